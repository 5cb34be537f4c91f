:- module(nppg_contract,
          [ contract/1,          % ?Indicator                              nondet
            defined/2,           % +Module, +Indicator                     semidet
            declared/2,          % +Module, ?Head                          nondet
            environment/2,       % +Module, ?Id                            nondet
            action_kinds/2,      % +Module, -Kinds                         semidet
            mistake/4,           % +Module, +File, +Parameters, -Problem   nondet
            description/4        % +Module, +Name, ?Key, -Value            nondet
          ]).

:- use_module(library(lists), [member/2, memberchk/2]).
:- use_module(library(prolog_codewalk), [prolog_walk_code/1]).
:- use_module(guard, [tamed/2]).

/** <module> The contract of a domain file

A domain file is a module that declares its fluents and parameters and defines the predicates below. None
of them has a state argument: they see the facts of the current state. docs/domains.md is the reference.

| start(-Facts)                     | a random start state                                     |
| problem(?Number, -Facts)          | start states by number; without start/1, start states are drawn from these |
| action(-Action)                   | the legal actions, by backtracking                       |
| effect(+Action, -Delete, -Add)    | what an action changes                                   |
| effect(+Action, -P, -Delete, -Add)| outcomes by backtracking, with probabilities that sum to 1 |
| goal                              | true in a state that ends the episode with success       |
| terminal                          | true in a state that ends the episode without success    |
| reward(+Action, -R)               | for the action that led to the current state; default: 1 in a goal state, else 0 |
| cost(+Action, -Cost)              | what an action costs in the current state; default: 1 |
| horizon(-N)                       | in a start state: the length after which an episode ends; default 100 |
| expert(-Action)                   | the actions that an expert would take, by backtracking   |
| observation(-Facts)               | what is seen in place of the current state's facts, at random if it likes; default: these |
| picture(-Lines)                   | the current state drawn for people, a list of atoms; default: its facts |
| shapes(-Shapes)                   | the same as shapes, for reports: see shapes.pl; default: made from the facts |
| parts(-Lists)                     | the parts that two states are compared by, each a list of ground terms; default: the facts |

A file that declares :- environment(Id) is about an environment of Gymnasium, where its dynamics live: of the
predicates above it has action/1, and expert/1, picture/1, shapes/1 and parts/1 if it wants. Its parameters are the
arguments that the environment is made with, whether the file declares them or not.

A file that declares :- background, which TILDE writes, knows no actions: its predicates may have any of these names.
*/

contract(start/1).
contract(problem/2).
contract(action/1).
contract(effect/3).
contract(effect/4).
contract(goal/0).
contract(terminal/0).
contract(reward/2).
contract(cost/2).
contract(horizon/1).
contract(expert/1).
contract(observation/1).
contract(picture/1).
contract(shapes/1).
contract(parts/1).

%   Those that an environment of Gymnasium stands for.

dynamics(start/1).
dynamics(problem/2).
dynamics(effect/3).
dynamics(effect/4).
dynamics(goal/0).
dynamics(terminal/0).
dynamics(reward/2).
dynamics(cost/2).
dynamics(horizon/1).
dynamics(observation/1).

defined(Module, Name/Arity) :-
    functor(Head, Name, Arity),
    predicate_property(Module:Head, defined),
    \+ predicate_property(Module:Head, imported_from(_)).

declared(Module, Head) :-
    predicate_property(Module:Head, defined),
    catch(Module:Head, _, fail).

environment(Module, Id) :-
    declared(Module, nppg_environment(Id)).

background(Module) :-
    declared(Module, nppg_background).

fluent(Module, Indicator) :-
    declared(Module, nppg_fluent(Indicator)).

static(Module, Indicator) :-
    declared(Module, nppg_static(Indicator)).

parameter(Module, Name, Value) :-
    declared(Module, parameter(Name, Value)).

%!  mistake(+Module, +File, +Parameters, -Problem) is nondet.
%
%   What a domain file lacks or gets wrong, as a tuple -(File, Line, Column, Message).

mistake(Module, File, _, -(File, 1, 0, Message)) :-
    \+ background(Module),
    member(Needed-Text, [ start/1  - 'start/1 is missing: start(-Facts) gives a random start state',
                          action/1 - 'action/1 is missing: action(-Action) gives the legal actions' ]),
    \+ defined(Module, Needed),
    \+ ( environment(Module, _), dynamics(Needed) ),
    \+ ( Needed == start/1, ( defined(Module, problem/2) ; declared(Module, nppg_pddl(_)) ) ),
    Message = Text.
mistake(Module, File, _, -(File, 1, 0, 'effect/3 is missing: effect(+Action, -Delete, -Add) says what an action changes')) :-
    \+ background(Module),
    \+ environment(Module, _),
    \+ defined(Module, effect/3),
    \+ defined(Module, effect/4).
mistake(Module, File, _, -(File, 1, 0, 'no fluent is declared: :- fluent on/2 says which facts a state consists of')) :-
    \+ background(Module),
    \+ fluent(Module, _).
mistake(Module, File, _, -(File, 1, 0, 'neither goal/0, terminal/0 nor reward/2 is defined: there is nothing to learn')) :-
    \+ background(Module),
    \+ environment(Module, _),
    \+ defined(Module, goal/0),
    \+ defined(Module, terminal/0),
    \+ defined(Module, reward/2).
mistake(Module, File, _, -(File, Line, 0, Message)) :-
    environment(Module, Id),
    (   dynamics(Name/Arity),
        defined(Module, Name/Arity),
        What = Name/Arity,
        functor(Head, Name, Arity),
        once(( clause(Module:Head, _, Clause), clause_property(Clause, line_count(Line)) ))
    ;   declared(Module, nppg_uniform_start),
        What = uniform_start,
        Line = 1
    ),
    format(atom(Message), '~q has no place in this file: the dynamics are those of the environment ~q', [What, Id]).
mistake(Module, File, Parameters, -(File, 1, 0, Message, Key, Names)) :-
    \+ environment(Module, _),
    findall(Name, parameter(Module, Name, _), Names),
    member([Key, _], Parameters),
    \+ memberchk(Key, Names),
    (   Names == []
    ->  Has = none
    ;   atomic_list_concat(Names, ', ', Has)
    ),
    format(atom(Message), 'there is no parameter ~q; the domain has ~w', [Key, Has]).
mistake(Module, File, _, -(File, 1, 0, Message)) :-
    declared(Module, nppg_interchangeable(Name/1)),
    \+ defined(Module, Name/1),
    format(atom(Message), 'unknown predicate ~q, which is declared interchangeable', [Name/1]).
mistake(Module, File, _, -(File, Line, 0, 'expansion in module user would change other domains, too: leave out user:')) :-
    member(Name/Arity, [term_expansion/2, term_expansion/4, goal_expansion/2, goal_expansion/4]),
    functor(Head, Name, Arity),
    catch(clause(user:Head, _, Clause), _, fail),
    clause_property(Clause, source(Id)),
    sub_atom(Id, _, _, 0, Module),
    clause_property(Clause, line_count(Line)).
mistake(Module, File, _, -(File, Line, 0, Message, Name, Known)) :-
    findall(Undefined, undefined(Module, Undefined), All0),
    sort(All0, All),
    findall(Other, ( All = [_|_], callable_name(Module, Other) ), Known),
    member(Line-(Name/Arity), All),
    format(atom(Message), 'unknown predicate ~q', [Name/Arity]).

callable_name(Module, Name) :-
    (   current_predicate(Module:Name/Arity),
        defined(Module, Name/Arity)
    ;   member(Name, [random, random_between, random_member, random_permutation, random_normal])
    ;   predicate_property(system:Head, defined),
        functor(Head, Name, _),
        \+ sub_atom(Name, 0, _, _, $)
    ).

%   Predicates that some clause of the domain calls and nobody defines.

:- thread_local missing/1.

undefined(Module, Missing) :-
    retractall(missing(_)),
    prolog_walk_code([ module(Module), module_class([user]), undefined(trace),
                       on_trace(nppg_contract:note_missing), source(true), autoload(true), walk_meta_predicates(true) ]),
    retract(missing(Missing)).

note_missing(Callee, _, Location) :-
    strip_module(Callee, _, Head),
    functor(Head, Name, Arity),
    (   Location = clause(Clause), clause_property(Clause, line_count(Line))
    ->  true
    ;   Location = clause_term_position(Clause, _), clause_property(Clause, line_count(Line))
    ->  true
    ;   Line = 1
    ),
    assertz(missing(Line-(Name/Arity))).

%!  action_kinds(+Module, -Kinds) is semidet.
%
%   The kinds of actions, as Name/Arity, sorted; fails where they cannot be told without running the domain.

action_kinds(Module, Kinds) :-
    findall(Action, clause(Module:action(Action), _), Heads),
    \+ ( member(Head, Heads), \+ callable(Head) ),
    findall(Name/Arity, ( member(Head, Heads), functor(Head, Name, Arity) ), Found),
    sort(Found, Kinds).

%!  description(+Module, +Name, ?Key, -Value) is nondet.
%
%   What Python is told of a domain, whose file calls its module Name.

description(_, Name, name, Name).
description(Module, _, fluents, Fluents) :-
    findall([Name, Arity], fluent(Module, Name/Arity), Fluents).
description(Module, _, (static), Static) :-
    findall([Name, Arity], static(Module, Name/Arity), Static).
description(Module, _, pddl, File) :-
    name_or_empty(Found, declared(Module, nppg_pddl(Found)), File).
description(Module, _, chance, Chance) :-
    truth(defined(Module, effect/4), Chance).
description(Module, _, cost, Cost) :-
    truth(defined(Module, cost/2), Cost).
description(Module, _, start, Start) :-
    truth(( defined(Module, start/1) ; environment(Module, _) ), Start).
description(Module, _, problems, Problems) :-
    truth(defined(Module, problem/2), Problems).
description(Module, _, parameters, Parameters) :-
    findall([Key, Value], parameter(Module, Key, Value), Parameters).
description(Module, _, predicates, Predicates) :-
    findall([Name, Arity],
            ( current_predicate(Module:Name/Arity),
              defined(Module, Name/Arity),
              \+ ( contract(Name/Arity), \+ background(Module) ),
              \+ memberchk(Name/Arity, [ nppg_fluent/1, nppg_static/1, nppg_uniform_start/0, nppg_interchangeable/1,
                                          nppg_environment/1, nppg_dead_ends/0, nppg_background/0, nppg_pddl/1, parameter/2 ]),
              functor(Head, Name, Arity),
              \+ tamed(Head, _) ),
            Predicates0),
    sort(Predicates0, Predicates).
description(Module, _, actions, Actions) :-
    (   action_kinds(Module, Kinds)
    ->  findall([Name, Arity], member(Name/Arity, Kinds), Actions)
    ;   Actions = []
    ).
description(Module, _, uniform_start, Uniform) :-
    truth(declared(Module, nppg_uniform_start), Uniform).
description(Module, _, interchangeable, Names) :-
    findall(Name, declared(Module, nppg_interchangeable(Name/1)), Names).
description(Module, _, environment, Id) :-
    name_or_empty(Found, environment(Module, Found), Id).
description(Module, _, expert, Expert) :-
    truth(defined(Module, expert/1), Expert).
description(Module, _, goal, Goal) :-
    truth(defined(Module, goal/0), Goal).
description(Module, _, observation, Observation) :-
    truth(defined(Module, observation/1), Observation).
description(Module, _, parts, Parts) :-
    truth(defined(Module, parts/1), Parts).

truth(Goal, Truth) :-
    (   call(Goal)
    ->  Truth = true
    ;   Truth = false
    ).

name_or_empty(Found, Goal, Name) :-
    (   call(Goal)
    ->  Name = Found
    ;   Name = ''
    ).
