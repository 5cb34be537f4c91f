% SHA-256 of what follows: 352399c4efec5e82f16a506e4320c8928e29f4c94b71bf371cbbcf602ef1272b
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
model(domain, 'rover.pl').
model(domain_sha256, d6a6ffe4508d716571a413e78c42bc6cd5432fe3a89a2bca725e39d74a8aad4c).
model(action, navigate(rover, waypoint, waypoint)).
model(action, sample_soil(rover, store, waypoint)).
model(action, sample_rock(rover, store, waypoint)).
model(action, drop(rover, store)).
model(action, calibrate(rover, camera, objective, waypoint)).
model(action, take_image(rover, waypoint, objective, camera, is_mode)).
model(action, communicate_soil_data(rover, lander, waypoint, waypoint, waypoint)).
model(action, communicate_rock_data(rover, lander, waypoint, waypoint, waypoint)).
model(action, communicate_image_data(rover, lander, objective, is_mode, waypoint, waypoint)).
model(literal, todo_communicated_soil_data(waypoint)).
model(literal, goal_communicated_soil_data(waypoint)).
model(literal, todo_communicated_rock_data(waypoint)).
model(literal, goal_communicated_rock_data(waypoint)).
model(literal, todo_communicated_image_data(objective, is_mode)).
model(literal, goal_communicated_image_data(objective, is_mode)).
model(literal, at(rover, waypoint)).
model(literal, empty(store)).
model(literal, have_rock_analysis(rover, waypoint)).
model(literal, have_soil_analysis(rover, waypoint)).
model(literal, full(store)).
model(literal, calibrated(camera, rover)).
model(literal, have_image(rover, objective, is_mode)).
model(literal, communicated_soil_data(waypoint)).
model(literal, communicated_rock_data(waypoint)).
model(literal, communicated_image_data(objective, is_mode)).
model(literal, at_soil_sample(waypoint)).
model(literal, at_rock_sample(waypoint)).
model(literal, at_lander(lander, waypoint)).
model(literal, can_traverse(rover, waypoint, waypoint)).
model(literal, equipped_for_soil_analysis(rover)).
model(literal, equipped_for_rock_analysis(rover)).
model(literal, equipped_for_imaging(rover)).
model(literal, supports(camera, is_mode)).
model(literal, visible(waypoint, waypoint)).
model(literal, visible_from(objective, waypoint)).
model(literal, store_of(store, rover)).
model(literal, calibration_target(camera, objective)).
model(literal, on_board(camera, rover)).
model(literal, unsettled_visible(waypoint)).
model(literal, unsettled_visible_todo_communicated_soil_data(waypoint)).
model(literal, unsettled_visible_todo_communicated_rock_data(waypoint)).
model(literal, beyond_visible(waypoint, waypoint)).
model(literal, needed_have_soil_analysis_to_communicate_soil_data(waypoint)).
model(literal, needed_at_to_communicate_soil_data(waypoint)).
model(literal, needed_have_rock_analysis_to_communicate_rock_data(waypoint)).
model(literal, needed_at_to_communicate_rock_data(waypoint)).
model(literal, needed_have_image_to_communicate_image_data(objective, is_mode)).
model(literal, needed_at_to_communicate_image_data(waypoint)).
model(literal, needed_at_to_sample_soil_to_communicate_soil_data(rover, waypoint)).
model(literal, needed_empty_to_sample_soil_to_communicate_soil_data(store)).
model(literal, needed_at_to_sample_rock_to_communicate_rock_data(rover, waypoint)).
model(literal, needed_empty_to_sample_rock_to_communicate_rock_data(store)).
model(literal, needed_calibrated_to_take_image_to_communicate_image_data(camera, rover)).
model(literal, needed_at_to_take_image_to_communicate_image_data(rover, waypoint)).
model(literal, nearer_at(rover, waypoint, waypoint, waypoint)).
model(literal, could_sample_soil(rover, waypoint)).
model(literal, toward_could_sample_soil(rover, waypoint, waypoint)).
model(literal, could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(rover, waypoint)).
model(literal, toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(rover, waypoint, waypoint)).
model(literal, could_sample_rock(rover, waypoint)).
model(literal, toward_could_sample_rock(rover, waypoint, waypoint)).
model(literal, could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(rover, waypoint)).
model(literal, toward_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(rover, waypoint, waypoint)).
model(literal, could_calibrate(rover, waypoint)).
model(literal, toward_could_calibrate(rover, waypoint, waypoint)).
model(literal, could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(rover, waypoint)).
model(literal, toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(rover, waypoint, waypoint)).
model(literal, could_calibrate_for_todo_communicated_image_data_objective_any(rover, waypoint)).
model(literal, toward_could_calibrate_for_todo_communicated_image_data_objective_any(rover, waypoint, waypoint)).
model(literal, could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(rover, waypoint)).
model(literal, toward_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(rover, waypoint, waypoint)).
model(literal, could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(rover, waypoint)).
model(literal, toward_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(rover, waypoint, waypoint)).
model(literal, could_take_image(rover, waypoint)).
model(literal, toward_could_take_image(rover, waypoint, waypoint)).
model(literal, could_take_image_needed_have_image_to_communicate_image_data(rover, waypoint)).
model(literal, toward_could_take_image_needed_have_image_to_communicate_image_data(rover, waypoint, waypoint)).
model(literal, could_take_image_for_todo_communicated_image_data_any_is_mode(rover, waypoint)).
model(literal, toward_could_take_image_for_todo_communicated_image_data_any_is_mode(rover, waypoint, waypoint)).
model(literal, could_take_image_for_todo_communicated_image_data_objective_any(rover, waypoint)).
model(literal, toward_could_take_image_for_todo_communicated_image_data_objective_any(rover, waypoint, waypoint)).
model(literal, could_take_image_through_supports_for_todo_communicated_image_data_2_camera(rover, waypoint)).
model(literal, toward_could_take_image_through_supports_for_todo_communicated_image_data_2_camera(rover, waypoint, waypoint)).
model(literal, could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(rover, waypoint)).
model(literal, toward_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(rover, waypoint, waypoint)).
model(literal, could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(rover, waypoint)).
model(literal, toward_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(rover, waypoint, waypoint)).
model(literal, could_communicate_soil_data(rover, waypoint)).
model(literal, toward_could_communicate_soil_data(rover, waypoint, waypoint)).
model(literal, could_communicate_soil_data_todo_communicated_soil_data(rover, waypoint)).
model(literal, toward_could_communicate_soil_data_todo_communicated_soil_data(rover, waypoint, waypoint)).
model(literal, could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(rover, waypoint)).
model(literal, toward_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(rover, waypoint, waypoint)).
model(literal, could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(rover, waypoint)).
model(literal, toward_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(rover, waypoint, waypoint)).
model(literal, could_communicate_rock_data(rover, waypoint)).
model(literal, toward_could_communicate_rock_data(rover, waypoint, waypoint)).
model(literal, could_communicate_rock_data_todo_communicated_rock_data(rover, waypoint)).
model(literal, toward_could_communicate_rock_data_todo_communicated_rock_data(rover, waypoint, waypoint)).
model(literal, could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(rover, waypoint)).
model(literal, toward_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(rover, waypoint, waypoint)).
model(literal, could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(rover, waypoint)).
model(literal, toward_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(rover, waypoint, waypoint)).
model(literal, could_communicate_image_data(rover, waypoint)).
model(literal, toward_could_communicate_image_data(rover, waypoint, waypoint)).
model(literal, could_communicate_image_data_todo_communicated_image_data(rover, waypoint)).
model(literal, toward_could_communicate_image_data_todo_communicated_image_data(rover, waypoint, waypoint)).
model(literal, could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(rover, waypoint)).
model(literal, toward_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(rover, waypoint, waypoint)).
model(literal, could_communicate_image_data_for_todo_communicated_image_data_objective_any(rover, waypoint)).
model(literal, toward_could_communicate_image_data_for_todo_communicated_image_data_objective_any(rover, waypoint, waypoint)).
model(literal, could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(rover, waypoint)).
model(literal, toward_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(rover, waypoint, waypoint)).
model(literal, fewer_have_soil_analysis_1_than_todo_communicated_soil_data).
model(literal, fewer_have_soil_analysis_1_than_have_soil_analysis_2).
model(literal, fewer_have_soil_analysis_1_than_todo_communicated_soil_data_have_soil_analysis_2).
model(literal, fewer_at_1_than_todo_communicated_soil_data).
model(literal, fewer_at_1_than_have_soil_analysis_2).
model(literal, fewer_at_2_than_todo_communicated_soil_data).
model(literal, fewer_at_2_than_have_soil_analysis_2).
model(literal, fewer_at_2_than_todo_communicated_soil_data_have_soil_analysis_2).
model(literal, fewer_have_rock_analysis_1_than_todo_communicated_rock_data).
model(literal, fewer_have_rock_analysis_1_than_have_rock_analysis_2).
model(literal, fewer_have_rock_analysis_1_than_todo_communicated_rock_data_have_rock_analysis_2).
model(literal, fewer_at_1_than_todo_communicated_rock_data).
model(literal, fewer_at_1_than_have_rock_analysis_2).
model(literal, fewer_at_2_than_todo_communicated_rock_data).
model(literal, fewer_at_2_than_have_rock_analysis_2).
model(literal, fewer_at_2_than_todo_communicated_rock_data_have_rock_analysis_2).
model(literal, fewer_have_image_1_than_todo_communicated_image_data_1).
model(literal, fewer_have_image_1_than_have_image_2).
model(literal, fewer_have_image_1_than_todo_communicated_image_data_1_have_image_2).
model(literal, fewer_at_1_than_todo_communicated_image_data_1).
model(literal, fewer_at_1_than_have_image_2).
model(literal, fewer_at_1_than_todo_communicated_image_data_1_have_image_2).
model(literal, fewer_have_image_1_than_todo_communicated_image_data_2).
model(literal, fewer_have_image_1_than_have_image_3).
model(literal, fewer_have_image_1_than_todo_communicated_image_data_2_have_image_3).
model(literal, fewer_at_1_than_todo_communicated_image_data_2).
model(literal, fewer_at_1_than_have_image_3).
model(literal, fewer_at_1_than_todo_communicated_image_data_2_have_image_3).
model(literal, fewer_at_2_than_todo_communicated_image_data_1).
model(literal, fewer_at_2_than_have_image_2).
model(literal, fewer_at_2_than_todo_communicated_image_data_1_have_image_2).
model(literal, fewer_at_2_than_todo_communicated_image_data_2).
model(literal, fewer_at_2_than_have_image_3).
model(literal, fewer_at_2_than_todo_communicated_image_data_2_have_image_3).
model(bias, 'rover.yaml').
model(bias_sha256, '5b30446f01eb803ae18f1f0ed7bfa335e6f30b6a93cf6d99fa4820ccef362742').
model(success, 0.98989898989899).
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

domain(rover).
:- ensure_loaded('rover.pl').
:- add_import_module(policy, rover, start).

% tree 1: distilled, 15 rules
delta(1, navigate(Rover, Waypoint, Waypoint2), 50.0) :- toward_could_communicate_rock_data(Rover, Waypoint, Waypoint2), !.
delta(1, navigate(_, Waypoint, _), 0.0) :- todo_communicated_rock_data(Waypoint), !.
delta(1, navigate(Rover, Waypoint, Waypoint2), 60.0) :- toward_could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint, Waypoint2), !.
delta(1, navigate(Rover, Waypoint, Waypoint2), 40.0) :- toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(1, navigate(_, _, _), 10.0) :- !.
delta(1, sample_soil(_, _, Waypoint), 80.0) :- todo_communicated_soil_data(Waypoint), !.
delta(1, sample_rock(_, _, Waypoint), 30.0) :- todo_communicated_rock_data(Waypoint), !.
delta(1, drop(_, Store), 80.0) :- needed_empty_to_sample_soil_to_communicate_soil_data(Store), !.
delta(1, drop(_, _), 20.0) :- todo_communicated_rock_data(_), !.
delta(1, calibrate(_, _, _, _), 80.0) :- !.
delta(1, take_image(_, _, Objective, _, Is_mode), 80.0) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(1, communicate_soil_data(_, _, Waypoint, _, _), 80.0) :- todo_communicated_soil_data(Waypoint), !.
delta(1, communicate_rock_data(_, _, Waypoint, _, _), 80.0) :- todo_communicated_rock_data(Waypoint), !.
delta(1, communicate_image_data(_, _, Objective, Is_mode, _, _), 70.0) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(1, _, 0.0).
