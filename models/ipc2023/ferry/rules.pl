% SHA-256 of what follows: 2598f6af1ed3c7c75599d887974d84cca84ae25bd3d6df339509ae59b865c8d8
% A policy learned by nppg: the potential of an action is the sum of its delta/3, one per tree.
% In plain Prolog, in the folder of this file and its domain:  swipl model.pl
%     ?- state([...]), best_action(Action).

:- module(policy,
          [ state/1,
            potential/2,
            best_action/1,
            delta/3
          ]).
model(format, 1).
model(nppg, '0.1.0').
model(prolog, '9.2.9').
model(domain, 'ferry.pl').
model(domain_sha256, '7b0e6da8bb9b289f6cd848adcb2ab7259ff1de92277447b34cc4127c9344ab81').
model(action, sail(location, location)).
model(action, board(car, location)).
model(action, debark(car, location)).
model(literal, todo_at(car, location)).
model(literal, goal_at(car, location)).
model(literal, done_at(car, location)).
model(literal, at_ferry(location)).
model(literal, at(car, location)).
model(literal, empty_ferry).
model(literal, on(car)).
model(literal, needed_on_to_debark(car)).
model(literal, needed_at_ferry_to_debark(location)).
model(literal, could_board(location)).
model(literal, could_board_needed_on_to_debark(location)).
model(literal, could_board_for_todo_at_any_location(location)).
model(literal, could_debark(location)).
model(literal, could_debark_todo_at(location)).
model(literal, could_debark_for_todo_at_any_location(location)).
model(bias, 'ferry.yaml').
model(bias_sha256, '550de0e32ae7481ec7660f9e0aad27f900204ad218ff9fc66886ee59ad5d0af9').
model(success, 1.0).
model(starts, 99).
model(exact, 0).
model(trees, 1).

% Lets plain Prolog load the domain: what its declarations mean.
:- op(1150, fx, user:[fluent, static, interchangeable]).
:- multifile user:term_expansion/2.
:- dynamic user:term_expansion/2.
:- dynamic delta/3.
user:term_expansion((:- fluent(Specs)), [(:- dynamic(Specs)), (:- discontiguous(fluents/1)), fluents(Specs)]).
user:term_expansion((:- static(Specs)), Clauses) :- user:term_expansion((:- fluent(Specs)), Clauses).
user:term_expansion((:- dead_ends), []).
user:term_expansion((:- pddl(_)), []).
user:term_expansion((:- parameter(Name, Default)), [(:- discontiguous(parameter/2)), parameter(Name, Value)]) :-
    ( policy:model(parameter, Name=Given) -> Value = Given ; Value = Default ).
user:term_expansion((:- uniform_start), []).
user:term_expansion((:- interchangeable(_)), []).
user:term_expansion((:- environment(_)), []).

% state(Facts) makes a state current; potential(Action, Potential) is about its legal actions, best_action(Action) about
% one of the highest potential.
state(Facts) :-
    domain(Module),
    forall(member(Fact, Facts), must_be_fact(Module, Fact)),
    forall(( Module:fluents(Specs), fluent_head(Specs, Head) ), retractall(Module:Head)),
    forall(member(Fact, Facts), assertz(Module:Fact)).
must_be_fact(Module, Fact) :-
    (   ground(Fact), Module:fluents(Specs), fluent_head(Specs, Head), Fact = Head
    ->  true
    ;   throw(error(domain_error(fact_of_a_fluent, Fact), _))
    ).
fluent_head((Specs, More), Head) :- !, ( fluent_head(Specs, Head) ; fluent_head(More, Head) ).
fluent_head(Specs, Head) :- is_list(Specs), !, member(Spec, Specs), fluent_head(Spec, Head).
fluent_head(Name/Arity, Head) :- functor(Head, Name, Arity).
potential(Action, Potential) :-
    domain(Module),
    model(trees, Last),
    setof(Legal, Module:action(Legal), Actions),
    member(Action, Actions),
    aggregate_all(sum(Value), ( between(1, Last, Tree), once(delta(Tree, Action, Value)) ), Potential).
best_action(Action) :-
    aggregate_all(max(Potential, Legal), potential(Legal, Potential), max(_, Action)).

domain(ferry).
:- ensure_loaded('ferry.pl').
:- add_import_module(policy, ferry, start).

% tree 1: distilled, 5 rules
delta(1, sail(_, Location), 20.0) :- todo_at(Car, Location), on(Car), !.
delta(1, sail(_, Location), 10.0) :- could_board_needed_on_to_debark(Location), !.
delta(1, board(Car, _), 20.0) :- todo_at(Car, _), !.
delta(1, debark(Car, Location), 20.0) :- todo_at(Car, Location), !.
delta(1, _, 0.0).
