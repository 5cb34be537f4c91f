% SHA-256 of what follows: 5316a0aea3f926c55f3efb2aa840a39eaac667a0cc1960fe6e171edc841f8dda
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
model(domain, 'satellite.pl').
model(domain_sha256, ee221948c83e4a61662d163688d8457b59b482c752f176e8c6559cc0d4596c93).
model(action, turn_to(satellite, direction, direction)).
model(action, switch_on(instrument, satellite)).
model(action, switch_off(instrument, satellite)).
model(action, calibrate(satellite, instrument, direction)).
model(action, take_image(satellite, direction, instrument, is_mode)).
model(literal, todo_pointing(satellite, direction)).
model(literal, goal_pointing(satellite, direction)).
model(literal, done_pointing(satellite, direction)).
model(literal, todo_have_image(direction, is_mode)).
model(literal, goal_have_image(direction, is_mode)).
model(literal, done_have_image(direction, is_mode)).
model(literal, pointing(satellite, direction)).
model(literal, power_avail(satellite)).
model(literal, power_on(instrument)).
model(literal, calibrated(instrument)).
model(literal, have_image(direction, is_mode)).
model(literal, on_board(instrument, satellite)).
model(literal, supports(instrument, is_mode)).
model(literal, calibration_target(instrument, direction)).
model(literal, needed_calibrated_to_take_image(instrument)).
model(literal, needed_power_on_to_take_image(instrument)).
model(literal, needed_pointing_to_take_image(satellite, direction)).
model(literal, needed_power_on_to_calibrate_to_take_image(instrument)).
model(literal, needed_pointing_to_calibrate_to_take_image(satellite, direction)).
model(literal, needed_power_avail_to_switch_on_to_take_image(satellite)).
model(literal, wanted_pointing(satellite, direction)).
model(literal, could_calibrate(satellite, direction)).
model(literal, could_calibrate_needed_calibrated_to_take_image(satellite, direction)).
model(literal, could_calibrate_for_todo_have_image_direction_any(satellite, direction)).
model(literal, could_calibrate_through_supports_for_todo_have_image_2_instrument(satellite, direction)).
model(literal, could_take_image(satellite, direction)).
model(literal, could_take_image_todo_have_image(satellite, direction)).
model(literal, could_take_image_for_todo_have_image_any_is_mode(satellite, direction)).
model(literal, could_take_image_for_todo_have_image_direction_any(satellite, direction)).
model(literal, could_take_image_through_calibration_target_for_todo_have_image_1_instrument(satellite, direction)).
model(literal, fewer_pointing_2_than_todo_pointing_1).
model(literal, fewer_pointing_2_than_pointing_1).
model(literal, fewer_pointing_2_than_todo_pointing_2).
model(literal, fewer_pointing_1_than_todo_have_image_1).
model(literal, fewer_calibrated_than_todo_have_image_1).
model(literal, fewer_calibrated_than_pointing_2).
model(literal, fewer_calibrated_than_todo_have_image_1_pointing_2).
model(literal, fewer_power_on_than_todo_have_image_1).
model(literal, fewer_power_on_than_pointing_2).
model(literal, fewer_power_on_than_todo_have_image_1_pointing_2).
model(literal, fewer_calibrated_power_on_than_todo_have_image_1).
model(literal, fewer_calibrated_power_on_than_pointing_2).
model(literal, fewer_calibrated_power_on_than_todo_have_image_1_pointing_2).
model(literal, fewer_calibrated_than_todo_have_image_2).
model(literal, fewer_power_on_than_todo_have_image_2).
model(literal, fewer_calibrated_power_on_than_todo_have_image_2).
model(bias, 'satellite.yaml').
model(bias_sha256, '51518259e9d5a1a196c52c5a3fbef9eb3f79d4c1f585f2fc9ea84bfb2a8c8c47').
model(success, 0.9797979797979798).
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

domain(satellite).
:- ensure_loaded('satellite.pl').
:- add_import_module(policy, satellite, start).

% tree 1: distilled, 7 rules
delta(1, turn_to(Satellite, Direction, _), 10.0) :- todo_pointing(Satellite, Direction), !.
delta(1, turn_to(Satellite, Direction, _), 20.0) :- could_take_image_todo_have_image(Satellite, Direction), !.
delta(1, turn_to(Satellite, Direction, _), 30.0) :- could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(1, switch_on(Instrument, Satellite), 30.0) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), on_board(Instrument2, Satellite), needed_power_on_to_take_image(Instrument2), !.
delta(1, calibrate(_, _, _), 30.0) :- !.
delta(1, take_image(_, Direction, _, Is_mode), 30.0) :- todo_have_image(Direction, Is_mode), !.
delta(1, _, 0.0).
