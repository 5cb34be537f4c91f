:- module(nppg_rule_list,
          [ preferred/2,         % +Policy, -Actions             det
            preferred/3,         % +Policy, +Float, -Action      semidet
            forget_rules/1       % +Policy                       det
          ]).

:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [include/3, partition/4]).
:- use_module(library(lists), [member/2, nth0/3, same_length/2]).
:- use_module(library(ordsets), [ord_subtract/3]).
:- use_module(contract, [action_kinds/2, declared/2]).
:- use_module(domain, [actions/2]).
:- use_module(guard, [guarded/3, guarded_findall/4]).
:- use_module(join_order, [few/2, ordered/4, outgrown/3]).
:- use_module(potential, [module_of/2, potential/3, rule/3]).
:- use_module(terms, [conjunction/2]).
:- use_module(values, [must_be_actions/3]).

/** <module> A policy that is a list of rules

The one tree of such a policy gives an action the value of the first rule that it meets. Its best actions are found
without scoring the others: by asking the rules from the highest value on for legal actions of their kind, until some
action has the value.
*/

:- dynamic
    ordered/3.                   % Policy, Size (see outgrown/3), Groups: of group(Value, Rules, Hidden), from the highest
                                 % value on, where a rule is rule(Number, Kind)

%!  preferred(+Policy, -Actions) is det.
%
%   The legal actions of the highest potential in the current state, sorted. They are ground; must_be_actions/3 says
%   whether they are actions.

preferred(Policy, Actions) :-
    module_of(Policy, Module),
    by_value(Policy, Groups),
    catch(best(Groups, Policy, Module, Actions), nppg_fault(_, _), scored(Policy, Module, Actions)).

%!  preferred(+Policy, +Float, -Action) is semidet.
%
%   One of them: at the place Float, from 0 to below 1, of their list.

preferred(Policy, Float, Action) :-
    preferred(Policy, Actions),
    length(Actions, Count),
    Index is truncate(Float*Count),
    nth0(Index, Actions, Action),
    module_of(Policy, Module),
    must_be_actions(Module, action/1, [Action]).

best(Groups, Policy, Module, Actions) :-
    (   member(group(Value, Rules, Hidden), Groups),
        guarded_findall(Action, Module:test/0, valued(Policy, Module, Rules, Hidden, Value, Action), Found),
        Found \== []
    ->  sort(Found, Actions),
        (   ground(Actions), acyclic_term(Actions)
        ->  true
        ;   must_be_actions(Module, action/1, Actions)
        )
    ;   Actions = []
    ).

valued(Policy, Module, Rules, Hidden, Value, Action) :-
    legal(Policy, Module, Rules, Action),
    (   Hidden == true
    ->  has(Policy, Value, Action)
    ;   true
    ).

%   Where that takes too long for a question about the state, or goes wrong, all actions are scored: then it is clear
%   how much there is to ask, and what is at fault.

scored(Policy, Module, Best) :-
    actions(Module, Actions),
    must_be_actions(Module, action/1, Actions),
    length(Actions, Count),
    aggregate_all(count, rule(Policy, 1, _), Rules),
    Asked is Rules*Count,
    guarded(Module:test/0, Asked, findall(Value-Action, ( member(Action, Actions), potential(Policy, Action, Value) ), Pairs)),
    aggregate_all(max(Value), member(Value-_, Pairs), Highest),
    findall(Action, ( member(Value-Action, Pairs), Value =:= Highest ), Best).

legal(Policy, Module, Rules, Action) :-
    member(rule(Number, Kind), Rules),
    (   Kind = Name/Arity
    ->  functor(Action, Name, Arity)
    ;   true
    ),
    Policy:'$rule'(Number, Module, Action).

has(Policy, Value, Action) :-
    potential(Policy, Action, Own),
    Own =:= Value.

%   The rules are compiled when they are first asked: '$rule'(Number, Module, Action). A rule about all actions becomes one
%   for each kind of which no earlier rule has taken all actions. What is not about the action comes first, and once. The
%   action follows; only where the domain file is written from PDDL, so that it gives the same actions however they are
%   asked for, the literals with few answers may bind its arguments before.

by_value(Policy, Groups) :-
    module_of(Policy, Module),
    (   ordered(Policy, Size, Known)
    ->  true
    ;   Size = -1
    ),
    (   \+ outgrown(Module, Size, _),
        Size >= 0
    ->  Groups = Known
    ;   outgrown(Module, -1, Next),
        findall(Action-Value-Body, rule(Policy, 1, ( delta(1, Action, Value) :- Body )), Rules),
        forget_rules(Policy),
        kinds(Module, Kinds),
        compiled(Rules, Policy, Module, Kinds, 0, Pairs),
        keysort(Pairs, Rising),
        grouped(Rising, [], Groups),
        assertz(ordered(Policy, Next, Groups))
    ).

%   The kinds of actions, [any] where they cannot be told from the heads of the clauses.

kinds(Module, Kinds) :-
    (   action_kinds(Module, Known)
    ->  Kinds = Known
    ;   Kinds = [any]
    ).

compiled([], _, _, _, _, []).
compiled([Action-Value-Body|Rules], Policy, Module, Kinds, Number, Pairs) :-
    without_cut(Body, Literals),
    (   nonvar(Action)
    ->  functor(Action, Name, Arity),
        Own = [Name/Arity]
    ;   Own = Kinds
    ),
    findall(Value-rule(Number, Kind), member(Kind, Own), Pairs, More),
    forall(member(Kind, Own), compile(Action, Kind, Literals, Policy, Module, Number)),
    (   Literals == [], takes_all(Action)
    ->  ord_subtract(Kinds, Own, Left)
    ;   Left = Kinds
    ),
    Next is Number+1,
    compiled(Rules, Policy, Module, Left, Next, More).

takes_all(Action) :-
    (   compound(Action)
    ->  Action =.. [_|Args],
        term_variables(Args, Variables),
        same_length(Args, Variables)
    ;   true
    ).

compile(Action0, Kind, Literals0, Policy, Module, Number) :-
    copy_term(Action0-Literals0, Action-Literals),
    (   Kind = Name/Arity
    ->  functor(Action, Name, Arity)
    ;   true
    ),
    term_variables(Action, Own),
    connected(Literals, Own, About, Others),
    ordered(Module, [], Others, Conditions),
    conjunction(Conditions, Condition),
    asked(Action, About, Module, Goal),
    assertz(Policy:( '$rule'(Number, Module, Action) :- \+ \+ Condition, Goal )).

%!  asked(+Action, +Literals, +Module, -Goal) is det.

asked(Action, Literals, Module, Goal) :-
    (   nonvar(Action),
        declared(Module, nppg_pddl(_))
    ->  ordered(Module, [], Literals, Free),
        bounded(Free, Module, Before, Rest0),
        ordered(Module, Action, Rest0, Rest),
        conjunction(Before, Binding),
        conjunction(Rest, Tests),
        Goal = ( Binding, Module:action(Action), \+ \+ Tests )
    ;   ordered(Module, Action, Literals, Rest),
        conjunction(Rest, Tests),
        Goal = ( Module:action(Legal), Legal = Action, \+ \+ Tests )
    ).

%   The facts in front that have few answers, and the others.

bounded([Literal|Literals], Module, [Literal|Before], Rest) :-
    few(Module, Literal),
    !,
    bounded(Literals, Module, Before, Rest).
bounded(Literals, _, [], Literals).

%   The literals that share variables with the action, if only by way of others.

connected(Literals, Variables, About, Others) :-
    partition(shares(Variables), Literals, Some, Left),
    (   Some == []
    ->  About = [],
        Others = Left
    ;   term_variables(Variables-Some, More),
        connected(Left, More, Rest, Others),
        merged(Literals, Some, Rest, About)
    ).

shares(Variables, Literal) :-
    term_variables(Literal, Own),
    member(Variable, Own),
    member(Other, Variables),
    Variable == Other,
    !.

%   In their order.

merged(Literals, Some, Rest, About) :-
    include(among(Some, Rest), Literals, About).

among(Some, Rest, Literal) :-
    ( member(Other, Some) ; member(Other, Rest) ),
    Other == Literal,
    !.

without_cut(Body, Goals) :-
    (   Body = ( Goal, Rest )
    ->  Goals = [Goal|More],
        without_cut(Rest, More)
    ;   ( Body == ! ; Body == true )
    ->  Goals = []
    ;   Goals = [Body]
    ).

%   The last pairs come first. An action that meets one of the rules may have another value where an earlier rule about
%   its kind has a lower one: the rules are hidden then.

grouped([], Groups, Groups).
grouped([Value-Rule|Pairs], Groups0, Groups) :-
    (   Groups0 = [group(Same, Rules, Hidden0)|Others],
        Same =:= Value
    ->  hidden(Rule, Others, Hidden0, Hidden),
        grouped(Pairs, [group(Same, [Rule|Rules], Hidden)|Others], Groups)
    ;   hidden(Rule, Groups0, false, Hidden),
        grouped(Pairs, [group(Value, [Rule], Hidden)|Groups0], Groups)
    ).

hidden(rule(Number, Kind), Lower, Hidden0, Hidden) :-
    (   member(group(_, Rules, _), Lower),
        member(rule(Earlier, Other), Rules),
        Earlier < Number,
        ( Other == Kind ; Other == any ; Kind == any )
    ->  Hidden = true
    ;   Hidden = Hidden0
    ).

%!  forget_rules(+Policy) is det: what has been compiled of a policy.

forget_rules(Policy) :-
    (   retract(ordered(Policy, _, _))
    ->  retractall(Policy:'$rule'(_, _, _))
    ;   true
    ).
