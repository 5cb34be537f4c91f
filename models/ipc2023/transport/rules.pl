% SHA-256 of what follows: b8bde254754f84d4594dc2658928ecc3e4e145b359a55b134e8c3f9157784f47
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
model(domain, 'transport.pl').
model(domain_sha256, '44591dcbf257a9d42d7792b216f8e5625943c2fcea1733f4c0e06b0bf319b5c8').
model(action, drive(vehicle, location, location)).
model(action, pick_up(vehicle, location, package, size, size)).
model(action, drop(vehicle, location, package, size, size)).
model(literal, todo_at(locatable, location)).
model(literal, goal_at(locatable, location)).
model(literal, done_at(locatable, location)).
model(literal, at(locatable, location)).
model(literal, in(package, vehicle)).
model(literal, capacity(vehicle, size)).
model(literal, road(location, location)).
model(literal, capacity_predecessor(size, size)).
model(literal, vehicle(locatable)).
model(literal, package(locatable)).
model(literal, beyond_road(location, location)).
model(literal, beyond_capacity_predecessor(size, size)).
model(literal, needed_in_to_drop(package)).
model(literal, needed_capacity_to_drop(size)).
model(literal, nearer_at(location, location, location)).
model(literal, wanted_at(vehicle, location)).
model(literal, toward_wanted_at(vehicle, location, location)).
model(literal, could_pick_up(vehicle, location)).
model(literal, toward_could_pick_up(vehicle, location, location)).
model(literal, could_pick_up_needed_in_to_drop(vehicle, location)).
model(literal, toward_could_pick_up_needed_in_to_drop(vehicle, location, location)).
model(literal, could_pick_up_needed_capacity_to_drop(vehicle, location)).
model(literal, toward_could_pick_up_needed_capacity_to_drop(vehicle, location, location)).
model(literal, could_pick_up_for_todo_at_any_location(vehicle, location)).
model(literal, toward_could_pick_up_for_todo_at_any_location(vehicle, location, location)).
model(literal, could_drop(vehicle, location)).
model(literal, could_drop_todo_at(vehicle, location)).
model(literal, toward_could_drop_todo_at(vehicle, location, location)).
model(literal, could_drop_for_todo_at_any_location(vehicle, location)).
model(literal, toward_could_drop_for_todo_at_any_location(vehicle, location, location)).
model(literal, nearer_capacity(size, size, size)).
model(literal, fewer_at_2_than_todo_at_1).
model(literal, fewer_at_2_than_at_1).
model(literal, fewer_at_2_than_todo_at_1_at_1).
model(literal, fewer_at_2_than_todo_at_2).
model(literal, fewer_in_2_than_todo_at_1).
model(literal, fewer_in_2_than_in_1).
model(literal, fewer_capacity_1_than_todo_at_1).
model(literal, fewer_capacity_1_than_in_1).
model(literal, fewer_in_2_than_todo_at_2).
model(literal, fewer_in_2_than_at_2).
model(literal, fewer_in_2_than_todo_at_2_at_2).
model(literal, fewer_capacity_1_than_todo_at_2).
model(literal, fewer_capacity_1_than_at_2).
model(literal, fewer_capacity_1_than_todo_at_2_at_2).
model(literal, fewer_capacity_2_than_todo_at_1).
model(literal, fewer_capacity_2_than_in_1).
model(literal, fewer_capacity_2_than_todo_at_2).
model(literal, fewer_capacity_2_than_at_2).
model(literal, fewer_capacity_2_than_todo_at_2_at_2).
model(bias, 'transport.yaml').
model(bias_sha256, '79cb43ae35462df9712e33d21ceb42094c3d725c55201a313424890dfe4682a8').
model(success, 0.9696969696969697).
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

domain(transport).
:- ensure_loaded('transport.pl').
:- add_import_module(policy, transport, start).

% tree 1: distilled, 6 rules
delta(1, drive(Vehicle, _, Location), 30.0) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(1, drive(Vehicle, _, Location), 10.0) :- could_pick_up_needed_in_to_drop(Vehicle, Location), !.
delta(1, drive(_, _, _), 0.0) :- !.
delta(1, pick_up(_, _, Package, _, _), 40.0) :- todo_at(Package, _), !.
delta(1, pick_up(_, _, _, _, _), 0.0) :- !.
delta(1, _, 20.0).
