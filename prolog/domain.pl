:- module(nppg_domain,
          [ load_domain/4,       % +File, +Parameters, -Module, -Description  det
            unload_domain/1,     % +Module                       det
            start/2,             % +Module, -Facts               det
            status/2,            % +Module, -Status              det
            actions/2,           % +Module, -Actions             det
            experts/2,           % +Module, -Actions             det
            observation/2,       % +Module, -Facts               det
            picture/2,           % +Module, -Lines               det
            parts/2,             % +Module, -Parts               det
            horizon/2,           % +Module, -Steps               det
            outcomes/3,          % +Module, +Action, -Outcomes   det
            reward/3,            % +Module, +Action, -Reward     det
            objects/3,           % +Module, +Predicate, -Objects  det
            binding/4,           % +Module, +Name, +Arity, -Values  det
            proper/1,            % +Term                         semidet
            defect/2             % +Term, -Text                  det
          ]).

:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [append/3, member/2, memberchk/2]).
:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).
:- use_module(library(prolog_codewalk), [prolog_walk_code/1]).
:- use_module(guard).
:- use_module(interpretation).
:- use_module(randomness, []).
:- use_module(report).

/** <module> The contract of a domain file

A domain file is a module that declares its fluents and parameters and defines the predicates below. None
of them has a state argument: they see the facts of the current state. docs/domains.md is the reference.

| start(-Facts)                     | a random start state                                     |
| action(-Action)                   | the legal actions, by backtracking                       |
| effect(+Action, -Delete, -Add)    | what an action changes                                   |
| effect(+Action, -P, -Delete, -Add)| outcomes by backtracking, with probabilities that sum to 1 |
| goal                              | true in a state that ends the episode with success       |
| terminal                          | true in a state that ends the episode without success    |
| reward(+Action, -R)               | for the action that led to the current state; default: 1 in a goal state, else 0 |
| horizon(-N)                       | in a start state: the length after which an episode ends; default 100 |
| expert(-Action)                   | the actions that an expert would take, by backtracking   |
| observation(-Facts)               | what is seen in place of the current state's facts, at random if it likes; default: these |
| picture(-Lines)                   | the current state drawn for people, a list of atoms; default: its facts |
| parts(-Lists)                     | the parts that two states are compared by, each a list of ground terms; default: the facts |

A file that declares :- environment(Id) is about an environment of Gymnasium, where its dynamics live: of the
predicates above it has action/1, and expert/1, picture/1 and parts/1 if it wants. Its parameters are the arguments
that the environment is made with, whether the file declares them or not.

Every load makes an instance, a module of its own, so that one file can be loaded with other parameters
beside itself.
*/

:- op(1150, fx, user:[fluent, interchangeable]).
:- thread_local loading/3, setting/2, heard/1.
:- dynamic defines/2, instances/1.
instances(0).

user:term_expansion(Term, Expansion) :-
    loading(Module, Name, File),
    nonvar(Term),
    prolog_load_context(source, File),
    source_location(_, Line),
    nb_setval(nppg_line, Line),
    expansion(Term, Module, Name, Expansion).

expansion((:- Declaration), Module, Name, Expansion) :-
    !,
    nonvar(Declaration),
    (   Declaration = module(Name, Exports)
    ->  Expansion = [(:- module(Module, Exports)), (:- nppg_guard:forbid_halt(Module)),
                     (:- discontiguous([nppg_fluent/1, nppg_interchangeable/1, nppg_environment/1, parameter/2]))]
    ;   declaration(Declaration, Module, Expansion)
    ).
expansion(Clause, Module, _, []) :-
    (   Clause = (Head :- _)
    ->  true
    ;   Head = Clause
    ),
    callable(Head),
    functor(Head, Name, Arity),
    declared(Module, nppg_fluent(Name/Arity)),
    wrong('~q is a fluent: its facts come from start/1 and the effects, not from the file'-[Name/Arity]).

declaration(fluent(Specs), _, Clauses) :-
    findall(Spec, specified(Specs, Spec), All),
    findall(Clause, ( member(Spec, All), fluent_clause(Spec, Clause) ), Clauses).
declaration(parameter(Parameter, Default), Module, Clauses) :-
    (   \+ ( atom(Parameter), kind(Default, _) )
    ->  declaration(parameter(_), Module, Clauses)
    ;   declared(Module, parameter(Parameter, _))
    ->  wrong('the parameter ~q is declared twice'-[Parameter]),
        Clauses = []
    ;   setting(Parameter, Value)
    ->  must_fit(Parameter, Default, Value),
        Clauses = [parameter(Parameter, Value)]
    ;   Clauses = [parameter(Parameter, Default)]
    ).
declaration(parameter(_), _, []) :-
    wrong('a parameter is declared by :- parameter(Name, Default), its default a name or a finite number'-[]).
declaration(uniform_start, _, [nppg_uniform_start]).
declaration(environment(Id), Module, Clauses) :-
    (   \+ ( atom(Id), Id \== '' )
    ->  wrong('an environment of Gymnasium is declared by its id: :- environment(\'CartPole-v1\')'-[]),
        Clauses = []
    ;   environment(Module, Other)
    ->  wrong('an environment is declared already: ~q'-[Other]),
        Clauses = []
    ;   Clauses = [nppg_environment(Id)]
    ).
declaration(interchangeable(Spec), _, Clauses) :-
    (   nonvar(Spec), Spec = Name/1, atom(Name)
    ->  Clauses = [nppg_interchangeable(Spec)]
    ;   wrong('interchangeable objects are declared by a predicate of one argument: :- interchangeable block/1'-[]),
        Clauses = []
    ).

specified(Specs, Spec) :-
    (   nonvar(Specs), ( Specs = (First, More) ; Specs = [First|More] )
    ->  (   specified(First, Spec)
        ;   specified(More, Spec)
        )
    ;   Specs \== [],
        Spec = Specs
    ).

fluent_clause(Spec, Clause) :-
    (   \+ ( nonvar(Spec), Spec = Name/Arity, atom(Name), integer(Arity), Arity >= 0 )
    ->  wrong('a fluent is declared by its name and the number of its arguments: :- fluent on/2'-[]),
        fail
    ;   contract(Spec)
    ->  wrong('~q is a predicate of the contract and can be no fluent'-[Spec]),
        fail
    ;   member(Clause, [(:- dynamic(Spec)), nppg_fluent(Spec)])
    ).

%   A parameter's value is of the kind of its default; an integer does for a float.

must_fit(Parameter, Default, Value) :-
    kind(Default, Wanted),
    (   kind(Value, Given), memberchk(Given-Wanted, [Wanted-Wanted, 'a whole number'-'a finite number'])
    ->  true
    ;   wrong('the parameter ~q must be ~w, not ~q'-[Parameter, Wanted, Value])
    ).

kind(Value, Kind) :-
    (   atom(Value)
    ->  Kind = 'a name'
    ;   integer(Value)
    ->  Kind = 'a whole number'
    ;   finite(Value)
    ->  Kind = 'a finite number'
    ).

finite(Number) :-
    number(Number),
    (   float(Number)
    ->  float_class(Number, Class),
        \+ memberchk(Class, [nan, infinite])
    ;   true
    ).

%   Notes a mistake in the term that is being read.

wrong(Format-Args) :-
    format(atom(Text), Format, Args),
    located(wrong, File, Line, Column),
    assertz(heard(-(File, Line, Column, Text))).

user:thread_message_hook(Message, Kind, _) :-
    loading(_, _, _),
    memberchk(Kind, [error, warning]),
    located(Message, File, Line, Column),
    explanation(Message, Text),
    assertz(heard(-(File, Line, Column, Text))).

syntax_error(-(_, _, _, Text)) :-
    sub_atom(Text, 0, _, _, 'Syntax error').

located(error(_, Context), File, Line, Column) :-
    nonvar(Context),
    Context = file(File, Line, Column, _),
    !.
located(error(_, Context), File, Line, Column) :-
    nonvar(Context),
    Context = stream(_, Line, Column, _),
    !,
    prolog_load_context(source, Id),
    source_file_name(Id, File).
located(_, File, Line, 0) :-
    source_location(Id, Line),
    !,
    source_file_name(Id, File).
located(_, '', 0, 0).

source_file_name(Id, File) :-
    (   sub_atom(Id, Before, _, _, '#')
    ->  sub_atom(Id, 0, Before, _, File)
    ;   File = Id
    ).

%!  load_domain(+File, +Parameters, -Module, -Description) is det.
%
%   Parameters is a list of lists [Name, Value]. Description is a list of lists [Key, Value].
%
%   @throws nppg_problems(Problems): every mistake that can be found without running the domain

load_domain(File, Parameters, Module, Description) :-
    module_name(File, Name),
    retract(instances(Count0)),
    Count is Count0+1,
    assertz(instances(Count)),
    format(atom(Module), '~w#~d', [Name, Count]),
    retractall(heard(_)),
    retractall(setting(_, _)),
    forall(member([Key, Value], Parameters), assertz(setting(Key, Value))),
    setup_call_cleanup(
        asserta(loading(Module, Name, File)),
        load(File, Module),
        retractall(loading(_, _, _))),
    add_import_module(Module, nppg_randomness, start),
    findall(Problem, retract(heard(Problem)), Heard),
    (   member(Problem, Heard), syntax_error(Problem)
    ->  Mistakes = []                       % what could not be read would be taken for missing
    ;   findall(Problem, mistake(Module, File, Parameters, Problem), Mistakes)
    ),
    append(Heard, Mistakes, Problems),
    (   Problems == []
    ->  true
    ;   unload_domain(Module),
        sort(Problems, Sorted),
        length(Sorted, Count1),
        (   Count1 > 50
        ->  length(First, 50),
            append(First, _, Sorted),
            More is Count1-50,
            format(atom(Text), '~D more mistakes', [More]),
            append(First, [-(File, 0, 0, Text)], Shown)
        ;   Shown = Sorted
        ),
        throw(nppg_problems(Shown))
    ),
    forall(( contract(Indicator), defined(Module, Indicator) ),
           assertz(defines(Module, Indicator))),
    (   current_predicate(Module:TabledName/TabledArity),
        functor(Tabled, TabledName, TabledArity),
        predicate_property(Module:Tabled, tabled)
    ->  forget_tables(Module)
    ;   true
    ),
    findall([Key, Value], description(Module, Name, Key, Value), Description).

module_name(File, Name) :-
    catch(setup_call_cleanup(
              open(File, read, In, [encoding(utf8)]),
              first_term(In, Term),
              close(In)),
          Error,
          ( explanation(Error, Text), throw(nppg_problems([-(File, 0, 0, Text)])) )),
    (   nonvar(Term), Term = (:- module(Name, Exports)), atom(Name), is_list(Exports)
    ->  true
    ;   throw(nppg_problems([-(File, 1, 0, 'a domain starts with :- module(Name, []).')]))
    ).

first_term(In, Term) :-
    catch(read(In, Term), error(syntax_error(_), _), Term = none).

%   Directives and term expansions may loop, too.

load(File, Module) :-
    atomic_list_concat([File, Module], '#', Id),
    nb_setval(nppg_line, 1),
    Limit = 100 000 000,
    statistics(inferences, Before),
    catch(setup_call_cleanup(
              open(File, read, In, [encoding(utf8)]),
              call_with_inference_limit(load_files(user:Id, [stream(In), if(true), imports([]), silent(true)]),
                                        Limit, Result),
              close(In)),
          Error,
          load_stopped(Error, File, Before, Limit)),
    (   Result == inference_limit_exceeded
    ->  load_problem(File, Limit, Problem),
        assertz(heard(Problem))
    ;   true
    ).

load_stopped(Error, File, Before, Limit) :-
    (   Error \== '$aborted'
    ->  explanation(Error, Text),
        load_problem(File, Text, Problem),
        assertz(heard(Problem))
    ;   statistics(inferences, After),
        (   After-Before >= Limit
        ->  load_problem(File, Limit, Problem)
        ;   load_problem(File, 'loading was aborted', Problem)
        ),
        stop_for(nppg_problems([Problem]))
    ).

load_problem(File, What, -(File, Line, 0, Text)) :-
    nb_getval(nppg_line, Line),
    (   integer(What)
    ->  format(atom(Text), 'took more than ~D inferences to load (does a directive loop?)', [What])
    ;   Text = What
    ).

unload_domain(Module) :-
    forget(Module),
    retractall(defines(Module, _)),
    forall(( source_file(Id), atom_concat(_, Module, Id) ), unload_file(Id)),
    forall(( current_predicate(Module:Name/Arity),
             functor(Head, Name, Arity),
             predicate_property(Module:Head, dynamic),
             \+ predicate_property(Module:Head, imported_from(_)) ),
           retractall(Module:Head)).

contract(start/1).
contract(action/1).
contract(effect/3).
contract(effect/4).
contract(goal/0).
contract(terminal/0).
contract(reward/2).
contract(horizon/1).
contract(expert/1).
contract(observation/1).
contract(picture/1).
contract(parts/1).

%   Those that an environment of Gymnasium stands for.

dynamics(start/1).
dynamics(effect/3).
dynamics(effect/4).
dynamics(goal/0).
dynamics(terminal/0).
dynamics(reward/2).
dynamics(horizon/1).
dynamics(observation/1).

defined(Module, Name/Arity) :-
    functor(Head, Name, Arity),
    predicate_property(Module:Head, defined),
    \+ predicate_property(Module:Head, imported_from(_)).

%   What a domain file lacks or gets wrong, as a tuple -(File, Line, Column, Message).

mistake(Module, File, _, -(File, 1, 0, Message)) :-
    member(Needed-Text, [ start/1  - 'start/1 is missing: start(-Facts) gives a random start state',
                          action/1 - 'action/1 is missing: action(-Action) gives the legal actions' ]),
    \+ defined(Module, Needed),
    \+ ( environment(Module, _), dynamics(Needed) ),
    Message = Text.
mistake(Module, File, _, -(File, 1, 0, 'effect/3 is missing: effect(+Action, -Delete, -Add) says what an action changes')) :-
    \+ environment(Module, _),
    \+ defined(Module, effect/3),
    \+ defined(Module, effect/4).
mistake(Module, File, _, -(File, 1, 0, 'no fluent is declared: :- fluent on/2 says which facts a state consists of')) :-
    \+ fluent(Module, _).
mistake(Module, File, _, -(File, 1, 0, 'neither goal/0, terminal/0 nor reward/2 is defined: there is nothing to learn')) :-
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
                       on_trace(nppg_domain:note_missing), source(true), autoload(true), walk_meta_predicates(true) ]),
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

declared(Module, Head) :-
    predicate_property(Module:Head, defined),
    catch(Module:Head, _, fail).

environment(Module, Id) :-
    declared(Module, nppg_environment(Id)).

fluent(Module, Indicator) :-
    declared(Module, nppg_fluent(Indicator)).

parameter(Module, Name, Value) :-
    declared(Module, parameter(Name, Value)).

description(_, Name, name, Name).
description(Module, _, fluents, Fluents) :-
    findall([Name, Arity], fluent(Module, Name/Arity), Fluents).
description(Module, _, parameters, Parameters) :-
    findall([Key, Value], parameter(Module, Key, Value), Parameters).
description(Module, _, predicates, Predicates) :-
    findall([Name, Arity],
            ( current_predicate(Module:Name/Arity),
              defined(Module, Name/Arity),
              \+ contract(Name/Arity),
              \+ memberchk(Name/Arity, [ nppg_fluent/1, nppg_uniform_start/0, nppg_interchangeable/1, nppg_environment/1,
                                          parameter/2, halt/0, halt/1 ]) ),
            Predicates0),
    sort(Predicates0, Predicates).
description(Module, _, actions, Actions) :-
    findall(Action, clause(Module:action(Action), _), Heads),
    (   member(Head, Heads), \+ callable(Head)
    ->  Found = []                          % they cannot be told without running the domain
    ;   findall(Name-Arity, ( member(Head, Heads), functor(Head, Name, Arity) ), Found)
    ),
    sort(Found, Sorted),
    findall([Name, Arity], member(Name-Arity, Sorted), Actions).
description(Module, _, uniform_start, Uniform) :-
    truth(declared(Module, nppg_uniform_start), Uniform).
description(Module, _, interchangeable, Names) :-
    findall(Name, declared(Module, nppg_interchangeable(Name/1)), Names).
description(Module, _, environment, Id) :-
    (   environment(Module, Found)
    ->  Id = Found
    ;   Id = ''
    ).
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

%!  start(+Module, -Facts) is det.
%
%   Draws a start state and makes it current.

start(Module, Facts) :-
    (   environment(Module, Id)
    ->  fault(Module:(start/1), 'is a matter of the environment ~q: open the file by nppg.open_domain'-[Id])
    ;   guarded(Module:(start/1), Module:start(Drawn))
    ->  true
    ;   fault(Module:(start/1), 'failed'-[])
    ),
    must_be_facts(Module, start/1, Drawn),
    sort(Drawn, Facts),
    interpret(Module, Facts).

must_be_facts(Module, Source, Facts) :-
    (   is_list(Facts)
    ->  true
    ;   fault(Module:Source, 'gave ~w where a list of facts is wanted,'-[Facts])
    ),
    (   member(Fact, Facts), \+ fact(Module, Fact)
    ->  defect(Fact, Defect),
        fault(Module:Source, 'gave ~w, which is no fact of a declared fluent~w,'-[Fact, Defect])
    ;   true
    ).

fact(Module, Fact) :-
    callable(Fact),
    functor(Fact, Name, Arity),
    Module:nppg_fluent(Name/Arity),
    proper(Fact).

must_be_actions(Module, Source, Actions) :-
    (   all_actions(Actions), proper(Actions)
    ->  true
    ;   member(Action, Actions), \+ ( callable(Action), proper(Action) ),
        defect(Action, Defect),
        fault(Module:Source, 'gave ~w, which is no action~w,'-[Action, Defect])
    ).

all_actions([]).
all_actions([Action|Actions]) :-
    callable(Action),
    all_actions(Actions).

%   What can be compared, stored and handed to Python: finite, ground, made of names, integers and floats.

proper(Term) :-
    ground(Term),
    acyclic_term(Term),
    plain(Term).

plain(Term) :-
    (   compound(Term)
    ->  compound_name_arguments(Term, _, Args),
        all_plain(Args)
    ;   integer(Term)
    ->  true
    ;   float(Term)
    ->  Term =:= Term
    ;   atom(Term)
    ->  true
    ;   Term == []
    ).

all_plain([]).
all_plain([Term|Terms]) :-
    (   atom(Term)
    ->  true
    ;   plain(Term)
    ),
    all_plain(Terms).

defect(Term, Text) :-
    (   \+ ground(Term)
    ->  Text = ' (it has an unbound variable)'
    ;   \+ acyclic_term(Term)
    ->  Text = ' (it contains itself)'
    ;   \+ plain(Term)
    ->  Text = ' (only names, integers, floats and compounds of them can be part of one)'
    ;   Text = ''
    ).

%!  status(+Module, -Status) is det.
%
%   goal, terminal or running, for the current state.

status(Module, Status) :-
    (   defines(Module, goal/0), guarded(Module:(goal/0), Module:goal)
    ->  Status = goal
    ;   defines(Module, terminal/0), guarded(Module:(terminal/0), Module:terminal)
    ->  Status = terminal
    ;   Status = running
    ).

%!  actions(+Module, -Actions) is det.
%
%   The legal actions of the current state, sorted, so that their order is a function of the state alone.

actions(Module, Actions) :-
    guarded_findall(Action, Module:(action/1), Module:action(Action), Found),
    sort(Found, Actions),
    must_be_actions(Module, action/1, Actions).

experts(Module, Actions) :-
    (   defines(Module, expert/1)
    ->  guarded_findall(Action, Module:(expert/1), Module:expert(Action), Found),
        sort(Found, Actions),
        must_be_actions(Module, expert/1, Actions)
    ;   Actions = []
    ).

%!  observation(+Module, -Facts) is det.
%
%   What is seen of the current state, in a domain that defines observation/1.

observation(Module, Facts) :-
    (   guarded(Module:(observation/1), Module:observation(Seen))
    ->  must_be_facts(Module, observation/1, Seen),
        sort(Seen, Facts)
    ;   fault(Module:(observation/1), failed-[])
    ).

%!  picture(+Module, -Lines) is det.
%
%   The current state as lines of text.

picture(Module, Lines) :-
    (   defines(Module, picture/1)
    ->  (   guarded(Module:(picture/1), Module:picture(Drawn)), is_list(Drawn)
        ->  findall(Line, ( member(Part, Drawn), format(atom(Line), "~w", [Part]) ), Lines)
        ;   fault(Module:(picture/1), 'gave no list of lines'-[])
        )
    ;   interpretation(Module, Facts),
        findall(Line, ( member(Fact, Facts), format(atom(Line), '~q', [Fact]) ), Lines)
    ).

%!  parts(+Module, -Parts) is det.
%
%   The parts of the current state, in a domain that defines parts/1: a list of lists.

parts(Module, Parts) :-
    (   guarded(Module:(parts/1), Module:parts(Given)), is_list(Given), \+ ( member(Part, Given), \+ is_list(Part) )
    ->  (   member(Part, Given), member(Term, Part), \+ proper(Term)
        ->  defect(Term, Defect),
            fault(Module:(parts/1), 'gave ~w in a part~w,'-[Term, Defect])
        ;   Parts = Given
        )
    ;   fault(Module:(parts/1), 'gave no list of lists'-[])
    ).

horizon(Module, Steps) :-
    (   \+ defines(Module, horizon/1)
    ->  Steps = 100
    ;   guarded(Module:(horizon/1), Module:horizon(Given))
    ->  (   integer(Given), Given >= 0, Given =< 1 000 000 000
        ->  Steps = Given
        ;   fault(Module:(horizon/1), 'gave ~w where a number of steps from 0 to 1000000000 is wanted,'-[Given])
        )
    ;   fault(Module:(horizon/1), failed-[])
    ).

%!  outcomes(+Module, +Action, -Outcomes) is det.
%
%   Outcomes is a list of Probability-Facts, the states that the action may lead to. The current state
%   stays current.

outcomes(Module, Action, Outcomes) :-
    interpretation(Module, Facts),
    findall(Outcome, outcome(Module, Action, Facts, Outcome), Outcomes),
    (   Outcomes == []
    ->  fault(Module:(action/1), 'allows ~w, which no effect covers,'-[Action])
    ;   Outcomes = [1-_]
    ->  true
    ;   foldl(add_probability, Outcomes, 0, Sum),
        (   abs(Sum-1) < 1.0e-9
        ->  true
        ;   length(Outcomes, Count),
            fault(Module:(action/1), 'allows ~w, which has ~d outcomes whose probabilities sum to ~4f and not to 1,'-[Action, Count, Sum])
        )
    ).

add_probability(Probability-_, Sum0, Sum) :-
    Sum is Sum0 + Probability.

outcome(Module, Action, Facts, Probability-Successor) :-
    (   defines(Module, effect/3),
        Source = effect/3,
        Probability = 1,
        guarded_findall(Delete-Add, Module:(effect/3), Module:effect(Action, Delete, Add), Changes),
        member(Delete-Add, Changes)
    ;   defines(Module, effect/4),
        Source = effect/4,
        guarded_findall(c(P, Delete, Add), Module:(effect/4), Module:effect(Action, P, Delete, Add), Changes),
        member(c(Probability, Delete, Add), Changes),
        (   number(Probability), Probability > 0, Probability =< 1
        ->  true
        ;   fault(Module:(effect/4), 'gave ~w as the probability of an outcome of ~w'-[Probability, Action])
        )
    ),
    must_be_facts(Module, Source, Delete),
    must_be_facts(Module, Source, Add),
    sort(Delete, Gone),
    sort(Add, New),
    ord_subtract(Facts, Gone, Kept),
    ord_union(Kept, New, Successor).

%!  reward(+Module, +Action, -Reward) is det.
%
%   The reward for Action, which has just led to the current state.

reward(Module, Action, Reward) :-
    (   defines(Module, reward/2)
    ->  (   guarded(Module:(reward/2), Module:reward(Action, Given))
        ->  (   finite(Given)
            ->  Reward = Given
            ;   fault(Module:(reward/2), 'gave ~w where a finite number is wanted, for the action ~w'-[Given, Action])
            )
        ;   fault(Module:(reward/2), 'failed for the action ~w'-[Action])
        )
    ;   status(Module, goal)
    ->  Reward = 1
    ;   Reward = 0
    ).

%!  objects(+Module, +Predicate, -Objects) is det.
%
%   All X with Predicate(X) in the current state, sorted.

objects(Module, Predicate, Objects) :-
    Goal =.. [Predicate, Object],
    guarded_findall(Object, Module:(Predicate/1), Module:Goal, Found),
    sort(Found, Objects).

%!  binding(+Module, +Name, +Arity, -Values) is det.
%
%   The arguments of the goal's only answer in the current state.

binding(Module, Name, Arity, Values) :-
    functor(Goal, Name, Arity),
    guarded_findall(Goal, Module:(Name/Arity), Module:Goal, Answers0),
    sort(Answers0, Answers),
    (   Answers = [Answer]
    ->  (   proper(Answer)
        ->  Answer =.. [_|Values]
        ;   defect(Answer, Defect),
            fault(Module:(Name/Arity), 'gave ~w as the goal~w,'-[Answer, Defect])
        )
    ;   length(Answers, Count),
        fault(Module:(Name/Arity), 'is the goal template of the language bias and must have one answer, but has ~d'-[Count])
    ).
