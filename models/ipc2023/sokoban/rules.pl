% SHA-256 of what follows: 571457b843ab0fe2db657663c8f6e0f41871a712f64d9d4465592c1c6c55e669
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
model(domain, 'sokoban.pl').
model(domain_sha256, '653469fdb166faf0bdd389a5f21e319b86a0b1df446135a79852d14e76d0b7f7').
model(action, move(location, location, direction)).
model(action, push(location, location, location, direction, box)).
model(literal, todo_at(box, location)).
model(literal, goal_at(box, location)).
model(literal, done_at(box, location)).
model(literal, at_robot(location)).
model(literal, at(box, location)).
model(literal, clear(location)).
model(literal, adjacent(location, location, direction)).
model(literal, needed_at_robot_to_push(location)).
model(literal, needed_clear_to_push(location)).
model(literal, needed_clear_to_move_to_push(location)).
model(literal, needed_at_to_push_to_push(location)).
model(literal, needed_at_robot_to_push_to_push(location)).
model(literal, nearer_at_robot(location, location, location)).
model(literal, could_push(location)).
model(literal, toward_could_push(location, location)).
model(literal, could_push_todo_at(location)).
model(literal, toward_could_push_todo_at(location, location)).
model(literal, could_push_needed_at_robot_to_push(location)).
model(literal, toward_could_push_needed_at_robot_to_push(location, location)).
model(literal, could_push_needed_clear_to_push(location)).
model(literal, toward_could_push_needed_clear_to_push(location, location)).
model(literal, could_push_needed_at_to_push_to_push(location)).
model(literal, toward_could_push_needed_at_to_push_to_push(location, location)).
model(literal, could_push_for_todo_at_any_location(location)).
model(literal, toward_could_push_for_todo_at_any_location(location, location)).
model(literal, could_push_for_todo_at_any_location_3(location)).
model(literal, toward_could_push_for_todo_at_any_location_3(location, location)).
model(literal, could_push_for_todo_at_box_location(location)).
model(literal, toward_could_push_for_todo_at_box_location(location, location)).
model(literal, wanted_at(box, location)).
model(literal, toward_wanted_at(box, location, location)).
model(literal, could_move(location)).
model(literal, toward_could_move(location, location)).
model(literal, could_move_needed_at_robot_to_push(location)).
model(literal, toward_could_move_needed_at_robot_to_push(location, location)).
model(literal, could_move_needed_at_robot_to_push_to_push(location)).
model(literal, toward_could_move_needed_at_robot_to_push_to_push(location, location)).
model(literal, could_move_for_todo_at_any_location(location)).
model(literal, toward_could_move_for_todo_at_any_location(location, location)).
model(literal, could_move_for_todo_at_any_location_2(location)).
model(literal, toward_could_move_for_todo_at_any_location_2(location, location)).
model(literal, fewer_at_robot_than_todo_at_1).
model(bias, 'sokoban.yaml').
model(bias_sha256, f7d3e0f1052143a94dc2d99ce9cdfffcb9bacd1160b0b1b16e5560192e174c62).
model(success, 0.10101010101010101).
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

domain(sokoban).
:- ensure_loaded('sokoban.pl').
:- add_import_module(policy, sokoban, start).

% tree 1: distilled, 2 rules
delta(1, move(_, Location, _), 0.0) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(1, _, 10.0).
