:- module(nppg_rule_list,
          [ preferred/2,         % +Policy, -Actions             det
            forget_rules/1       % +Policy                       det
          ]).

:- use_module(library(apply), [include/3]).
:- use_module(library(lists), [member/2]).
:- use_module(guard, [guarded_findall/4]).
:- use_module(potential, [module_of/2, potential/3, rule/3]).
:- use_module(values, [must_be_actions/3]).

/** <module> A policy that is a list of rules

The one tree of such a policy gives an action the value of the first rule that it meets. Its best actions are found
without scoring the others: by asking the rules from the highest value on for legal actions of their kind, until some
action has the value.
*/

:- dynamic
    ordered/2.                   % Policy, Groups: of Value-Numbers, from the highest value on

%!  preferred(+Policy, -Actions) is det.
%
%   The legal actions of the highest potential in the current state, sorted.

preferred(Policy, Actions) :-
    module_of(Policy, Module),
    by_value(Policy, Groups),
    (   member(Value-Numbers, Groups),
        guarded_findall(Action, Module:(action/1), legal(Policy, Module, Numbers, Action), Found),
        sort(Found, Sorted),
        include(has(Policy, Value), Sorted, Actions),
        Actions \== []
    ->  must_be_actions(Module, action/1, Actions)
    ;   Actions = []
    ).

legal(Policy, Module, Numbers, Action) :-
    member(Number, Numbers),
    Policy:'$head'(Number, Action),
    Module:action(Action),
    Policy:'$rule'(Number, Action).

has(Policy, Value, Action) :-
    potential(Policy, Action, Own),
    Own =:= Value.

%   The rules are compiled when they are first asked: '$head'(Number, Action) and '$rule'(Number, Action).

by_value(Policy, Groups) :-
    (   ordered(Policy, Groups)
    ->  true
    ;   findall(Action-Value-Body, rule(Policy, 1, ( delta(1, Action, Value) :- Body )), Rules),
        retractall(Policy:'$head'(_, _)),
        retractall(Policy:'$rule'(_, _)),
        compiled(Rules, Policy, 0, Pairs),
        keysort(Pairs, Rising),
        grouped(Rising, [], Groups),
        assertz(ordered(Policy, Groups))
    ).

compiled([], _, _, []).
compiled([Action-Value-Body|Rules], Policy, Number, [Value-Number|Pairs]) :-
    without_cut(Body, Query),
    copy_term(Action, Head),
    assertz(Policy:'$head'(Number, Head)),
    assertz(Policy:('$rule'(Number, Action) :- Query)),
    Next is Number+1,
    compiled(Rules, Policy, Next, Pairs).

without_cut(Body, Query) :-
    (   Body = ( Goal, Goals )
    ->  without_cut(Goals, Rest),
        (   Rest == true
        ->  Query = Goal
        ;   Query = ( Goal, Rest )
        )
    ;   Body == !
    ->  Query = true
    ;   Query = Body
    ).

%   The last pairs come first.

grouped([], Groups, Groups).
grouped([Value-Number|Pairs], Groups0, Groups) :-
    (   Groups0 = [Same-Numbers|Others], Same =:= Value
    ->  grouped(Pairs, [Same-[Number|Numbers]|Others], Groups)
    ;   grouped(Pairs, [Value-[Number]|Groups0], Groups)
    ).

%!  forget_rules(+Policy) is det: what has been compiled of a policy.

forget_rules(Policy) :-
    (   retract(ordered(Policy, _))
    ->  retractall(Policy:'$head'(_, _)),
        retractall(Policy:'$rule'(_, _))
    ;   true
    ).
