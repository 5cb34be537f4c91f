% SHA-256 of what follows: 1f03821cf7ad9593b684394f939ab098c29e2afdc5f54e9167335b17855a30ef
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
model(option, episodes=1000000000).
model(option, seed=0).
model(option, guidance=0.1).
model(option, expert=domain).
model(option, horizon_factor=1.0).
model(option, step_size=1.0).
model(option, discount=0.95).
model(option, min_examples=200).
model(option, examples_growth=0.0).
model(option, episodes_per_iteration=1).
model(option, curriculum=yes).
model(option, update=all).
model(option, step='second-order').
model(option, regularisation=0.25).
model(option, regularisation_growth=0.05).
model(option, clip=3.0).
model(option, importance=0.5).
model(option, imitation=self).
model(option, floor=0.1).
model(option, detours=3.0).
model(option, replay=1000).
model(option, regressor=tilde).
model(option, models='per-action').
model(option, unrewarded=keep).
model(option, line_search=0).
model(option, ratio_clip=0.2).
model(option, critic=none).
model(option, trace=1.0).
model(option, cut_off=end).
model(option, critic_step_size=0.5).
model(option, critic_trees=1).
model(option, normalise=no).
model(tree, max_depth=3).
model(tree, min_examples=2).
model(tree, min_variance=1.0e-9).
model(tree, significance=1.0).
model(tree, granularity=0).
model(curve, evaluate_every=0).
model(curve, seconds=120.0).
model(trained_episodes, 469).
model(trees, 39).

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

% tree 1: step size 1.0, 233 examples, 11 leaves
delta(1, navigate(_, _, _), -0.6470386374862914) :- !.
delta(1, calibrate(Rover, Camera, _, _), 0.5614707469576746) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(1, calibrate(_, _, _, _), -0.2264399859720655) :- !.
delta(1, take_image(_, _, _, _, Is_mode), 0.6208349350363618) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(1, take_image(_, _, _, _, Is_mode), 0.011049723756906086) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(Objective, _), !.
delta(1, take_image(_, _, _, _, _), -0.38675761954923976) :- !.
delta(1, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), -0.2184222669273459) :- todo_communicated_image_data(Objective, Is_mode), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), !.
delta(1, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), 0.04758999389871874) :- todo_communicated_image_data(Objective, Is_mode), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(1, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.45274935771538466) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(1, communicate_image_data(_, _, _, _, _, _), -0.3202197219055948) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 204 examples, 8 leaves
delta(2, navigate(_, _, _), -0.3681408606416675) :- !.
delta(2, calibrate(Rover, Camera, _, _), 0.2977535249700746) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(2, calibrate(_, _, _, _), -0.28815302065229453) :- !.
delta(2, take_image(_, _, _, _, Is_mode), 0.47725737335874213) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(2, take_image(_, _, _, _, _), -0.30593192572114025) :- !.
delta(2, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.4295948353322057) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(2, communicate_image_data(_, _, _, _, _, _), -0.3343181519150733) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 211 examples, 8 leaves
delta(3, navigate(_, _, _), -0.2540739420736424) :- !.
delta(3, calibrate(Rover, Camera, _, _), 0.22904328957759973) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(3, calibrate(_, _, _, _), -0.19082688994814748) :- !.
delta(3, take_image(_, _, _, _, Is_mode), 0.3424613055218963) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(3, take_image(_, _, _, _, _), -0.21948728260558836) :- !.
delta(3, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.31004834497293804) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(3, communicate_image_data(_, _, _, _, _, _), -0.27915377903157) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 207 examples, 20 leaves
delta(4, navigate(Rover, Waypoint, Waypoint2), 0.3194631695398175) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint2), could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), could_take_image(Rover, Waypoint), !.
delta(4, navigate(Rover, Waypoint, Waypoint2), -0.18653116190303354) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint2), could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), !.
delta(4, navigate(Rover, _, Waypoint), 1.5507797851933767) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), !.
delta(4, navigate(Rover, _, Waypoint), -0.0029664870698403213) :- could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), needed_at_to_communicate_image_data(Waypoint), !.
delta(4, navigate(Rover, _, Waypoint), 0.26838577745403636) :- could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(4, navigate(Rover, _, Waypoint), 0.017585131263734136) :- could_take_image(Rover, Waypoint), !.
delta(4, navigate(_, _, _), -0.27507737575315055) :- !.
delta(4, calibrate(Rover, Camera, Objective, _), -0.025855904825029224) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), have_image(Rover, Objective, _), calibrated(_, Rover), !.
delta(4, calibrate(Rover, Camera, Objective, _), 0.29103349807568596) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), have_image(Rover, Objective, _), !.
delta(4, calibrate(Rover, Camera, Objective, _), 0.051742912750538606) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), todo_communicated_image_data(Objective, Is_mode), have_image(Rover, _, Is_mode), !.
delta(4, calibrate(Rover, Camera, _, _), -0.11494182579791182) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(4, calibrate(_, _, _, _), -0.5064800818740107) :- !.
delta(4, take_image(_, _, Objective, _, Is_mode), 0.7431517287607745) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(4, take_image(_, _, _, _, _), -1.71321934245412) :- !.
delta(4, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.020851420948170038) :- communicated_image_data(_, Is_mode), todo_communicated_image_data(Objective, Is_mode), !.
delta(4, communicate_image_data(_, _, _, Is_mode, _, _), -0.5710913410248026) :- communicated_image_data(_, Is_mode), !.
delta(4, communicate_image_data(Rover, _, Objective, Is_mode, _, _), 0.6374840240574084) :- todo_communicated_image_data(Objective2, Is_mode), have_image(Rover, Objective2, Is_mode2), todo_communicated_image_data(Objective, Is_mode2), !.
delta(4, communicate_image_data(Rover, _, _, Is_mode, _, _), -0.019687644167735194) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, _), !.
delta(4, communicate_image_data(_, _, _, _, _, _), -0.12054649609073727) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 208 examples, 24 leaves
delta(5, navigate(Rover, Waypoint, Waypoint2), -0.6983283888088571) :- toward_could_calibrate(Rover, Waypoint2, Waypoint), !.
delta(5, navigate(Rover, Waypoint, Waypoint2), -0.04165936564239907) :- fewer_have_image_1_than_todo_communicated_image_data_1, toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(5, navigate(_, _, _), 0.935153866207865) :- fewer_have_image_1_than_todo_communicated_image_data_1, !.
delta(5, navigate(Rover, Waypoint, _), -0.41466420183794706) :- could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), !.
delta(5, navigate(_, _, _), 0.4241467930428799) :- !.
delta(5, sample_rock(_, _, _), -0.038584463772146166) :- !.
delta(5, calibrate(Rover, _, Objective, _), -0.4165280650609913) :- fewer_at_1_than_todo_communicated_image_data_2, have_image(Rover, Objective, Is_mode), todo_communicated_image_data(_, Is_mode), !.
delta(5, calibrate(Rover, _, Objective, _), 0.014913428538589558) :- fewer_at_1_than_todo_communicated_image_data_2, have_image(Rover, Objective, _), !.
delta(5, calibrate(Rover, Camera, _, _), 0.13438654276676015) :- fewer_at_1_than_todo_communicated_image_data_2, needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(5, calibrate(_, _, _, _), -0.1290036544450927) :- fewer_at_1_than_todo_communicated_image_data_2, !.
delta(5, calibrate(Rover, Camera, Objective, _), -0.032143965522800716) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), calibrated(Camera, Rover), !.
delta(5, calibrate(_, _, Objective, _), 0.3218922063659604) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(5, calibrate(Rover, Camera, _, _), 0.033998144090244715) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(5, calibrate(_, _, _, _), -0.17524217833602176) :- !.
delta(5, take_image(_, _, Objective, _, Is_mode), 0.3491924503310181) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(5, take_image(Rover, _, _, _, Is_mode), -0.007169972748006333) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), todo_communicated_image_data(Objective, Is_mode2), needed_have_image_to_communicate_image_data(Objective, Is_mode2), !.
delta(5, take_image(Rover, _, _, _, Is_mode), 0.022957219010644403) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), !.
delta(5, take_image(_, _, _, _, _), -0.7904340092404302) :- !.
delta(5, communicate_image_data(_, _, Objective, Is_mode, _, _), -0.5123358880949872) :- communicated_image_data(Objective, Is_mode), !.
delta(5, communicate_image_data(Rover, _, Objective, _, Waypoint, _), -0.0005495091560433326) :- visible_from(Objective, Waypoint), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(5, communicate_image_data(_, _, Objective, _, Waypoint, _), 0.6238627136729167) :- visible_from(Objective, Waypoint), !.
delta(5, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.15403612885256215) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(5, communicate_image_data(_, _, _, _, _, _), -0.17361100888221456) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 204 examples, 28 leaves
delta(6, navigate(Rover, _, Waypoint), 0.047691354851100876) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), todo_communicated_soil_data(Waypoint3), toward_could_sample_rock(Rover, Waypoint2, Waypoint3), !.
delta(6, navigate(Rover, _, Waypoint), -0.4955930136037904) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(6, navigate(Rover, Waypoint, _), 0.041199793100484855) :- could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), !.
delta(6, navigate(Rover, Waypoint, _), -0.2649694965229895) :- could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(6, navigate(Rover, Waypoint, Waypoint2), -0.12172538943736506) :- toward_could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(6, navigate(_, _, _), 1.1152496136941954) :- !.
delta(6, sample_soil(Rover, _, Waypoint), -0.4361071302567123) :- todo_communicated_soil_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(6, sample_soil(_, _, _), 0.2508009761110236) :- !.
delta(6, sample_rock(Rover, _, Waypoint), 0.45812927555016053) :- todo_communicated_soil_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(6, sample_rock(_, _, _), -1.0804380286976423) :- !.
delta(6, drop(_, _), 0.3254184239491131) :- !.
delta(6, calibrate(Rover, Camera, _, _), 0.4239701818819723) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(6, calibrate(_, _, _, _), -0.5001885617577689) :- !.
delta(6, take_image(Rover, Waypoint, Objective, _, Is_mode), -0.021494032391382763) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode2), have_image(Rover, Objective, Is_mode2), todo_communicated_image_data(Objective2, Is_mode2), have_image(Rover, Objective2, Is_mode), !.
delta(6, take_image(Rover, Waypoint, Objective, _, _), 0.09180040727389388) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), !.
delta(6, take_image(Rover, Waypoint, Objective, _, Is_mode), 0.0018545356794472622) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(6, take_image(Rover, Waypoint, _, _, _), -0.043692135690855095) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), !.
delta(6, take_image(_, _, _, _, _), -0.41288420713445034) :- fewer_have_image_1_than_have_image_3, !.
delta(6, take_image(_, _, Objective, _, Is_mode), 0.07197812697417574) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(6, take_image(_, _, _, _, _), -0.08634302656797015) :- !.
delta(6, communicate_soil_data(Rover, _, Waypoint, _, _), -0.18619758736679295) :- could_calibrate(Rover, Waypoint), !.
delta(6, communicate_soil_data(_, _, _, _, _), 0.017497560773789122) :- !.
delta(6, communicate_rock_data(_, _, _, _, _), -0.23706153609646205) :- !.
delta(6, communicate_image_data(_, _, _, Is_mode, _, _), -0.3014261430425275) :- communicated_image_data(_, Is_mode), !.
delta(6, communicate_image_data(Rover, _, Objective, Is_mode, _, Waypoint), 0.07075918257451362) :- could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(6, communicate_image_data(Rover, _, _, _, _, Waypoint), -0.1357844416766336) :- could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(6, communicate_image_data(_, _, _, _, _, _), 0.2230756864453777) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 205 examples, 34 leaves
delta(7, navigate(Rover, Waypoint, Waypoint2), -0.041795813646442796) :- fewer_at_1_than_todo_communicated_image_data_2, toward_could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint, Waypoint2), at_soil_sample(Waypoint), !.
delta(7, navigate(Rover, Waypoint, Waypoint2), 0.1342526949496761) :- fewer_at_1_than_todo_communicated_image_data_2, toward_could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint, Waypoint2), !.
delta(7, navigate(Rover, Waypoint, Waypoint2), 0.048951899933633664) :- fewer_at_1_than_todo_communicated_image_data_2, toward_could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint2, Waypoint), !.
delta(7, navigate(_, _, _), -0.44390153523193426) :- fewer_at_1_than_todo_communicated_image_data_2, !.
delta(7, navigate(Rover, Waypoint, Waypoint2), -0.1783163239973066) :- toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(7, navigate(Rover, _, Waypoint), -0.11004094640623326) :- todo_communicated_rock_data(Waypoint2), toward_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Waypoint, Waypoint2), !.
delta(7, navigate(_, _, _), 0.5964962486112148) :- !.
delta(7, sample_soil(_, _, _), -0.38833181708456704) :- !.
delta(7, sample_rock(Rover, _, Waypoint), 0.34463086254627684) :- todo_communicated_soil_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(7, sample_rock(_, _, _), -0.3043728801570156) :- !.
delta(7, drop(_, _), 0.0788862266258381) :- fewer_have_soil_analysis_1_than_have_soil_analysis_2, !.
delta(7, drop(Rover, _), 0.05637091653416369) :- todo_communicated_rock_data(Waypoint), could_communicate_soil_data(Rover, Waypoint), !.
delta(7, drop(_, _), -0.7257781249406657) :- !.
delta(7, calibrate(Rover, Camera, Objective, _), 0.08001176357821992) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(7, calibrate(Rover, _, Objective, _), -0.15984940110754595) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), !.
delta(7, calibrate(Rover, Camera, _, _), -0.040638588017150146) :- calibrated(Camera, Rover), !.
delta(7, calibrate(Rover, _, _, Waypoint), -0.015871023705363686) :- could_communicate_soil_data(Rover, Waypoint), !.
delta(7, calibrate(_, _, _, _), 0.6929699874217089) :- !.
delta(7, take_image(Rover, _, Objective, Camera, Is_mode), -0.03762799638429412) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), todo_communicated_image_data(Objective, Is_mode2), have_image(Rover, Objective, Is_mode2), todo_communicated_image_data(Objective2, Is_mode), calibration_target(Camera, Objective2), !.
delta(7, take_image(Rover, _, Objective, _, Is_mode), 0.0028109801153945427) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), todo_communicated_image_data(Objective, Is_mode2), have_image(Rover, Objective, Is_mode2), !.
delta(7, take_image(Rover, _, Objective, _, Is_mode), 0.001488947947266252) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), have_soil_analysis(Rover, _), !.
delta(7, take_image(_, _, Objective, _, Is_mode), 0.2866491751113059) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(7, take_image(_, _, Objective, _, _), -0.00990183236277163) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), fewer_have_image_1_than_have_image_2, !.
delta(7, take_image(_, _, Objective, _, _), 0.0716406249141632) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(7, take_image(_, _, _, _, _), -0.15491069749769235) :- !.
delta(7, communicate_soil_data(Rover, _, Waypoint, _, _), -0.19709613753887545) :- could_calibrate(Rover, Waypoint), !.
delta(7, communicate_soil_data(_, _, _, _, _), 0.0049616701672228055) :- !.
delta(7, communicate_rock_data(_, _, _, _, _), -0.2010663907301805) :- !.
delta(7, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), -0.04215662089589622) :- todo_communicated_image_data(Objective, Is_mode), toward_could_calibrate(Rover, Waypoint, Waypoint2), communicated_image_data(_, Is_mode), !.
delta(7, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), 0.037089782127044876) :- todo_communicated_image_data(Objective, Is_mode), toward_could_calibrate(Rover, Waypoint, Waypoint2), !.
delta(7, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.27996941069852815) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(7, communicate_image_data(_, _, _, _, Waypoint, _), 0.03193367540873294) :- at_soil_sample(Waypoint), !.
delta(7, communicate_image_data(_, _, _, _, _, _), -0.35423361484245824) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 204 examples, 35 leaves
delta(8, navigate(Rover, Waypoint, Waypoint2), 0.14061716818394215) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), toward_could_sample_rock(Rover, Waypoint, Waypoint2), fewer_have_image_1_than_have_image_2, !.
delta(8, navigate(Rover, Waypoint, Waypoint2), -0.010406338544893892) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), toward_could_sample_rock(Rover, Waypoint, Waypoint2), !.
delta(8, navigate(Rover, Waypoint, Waypoint2), 0.021027340126698598) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint, Waypoint2), !.
delta(8, navigate(Rover, Waypoint, _), -0.39183059422334854) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), !.
delta(8, navigate(Rover, Waypoint, Waypoint2), 0.010149752492853634) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), toward_could_sample_soil(Rover, Waypoint2, Waypoint), !.
delta(8, navigate(Rover, Waypoint, _), -0.2122521815387831) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), !.
delta(8, navigate(Rover, Waypoint, Waypoint2), -0.138919546839653) :- toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(8, navigate(_, _, _), 0.6256014535379542) :- !.
delta(8, sample_soil(Rover, _, _), 0.10955050387842083) :- have_soil_analysis(Rover, _), !.
delta(8, sample_soil(_, _, _), -0.34170278006332006) :- !.
delta(8, sample_rock(_, _, Waypoint), 0.01728614649380199) :- todo_communicated_soil_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(8, sample_rock(_, _, _), -0.2198307133756069) :- !.
delta(8, drop(_, _), 0.07490467540673551) :- todo_communicated_soil_data(_), !.
delta(8, drop(_, _), -0.13687517547948236) :- !.
delta(8, calibrate(Rover, Camera, _, Waypoint), -0.09046570417073369) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), at_soil_sample(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint, Waypoint2), !.
delta(8, calibrate(Rover, Camera, _, _), 0.06079887627588612) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), at_soil_sample(_), !.
delta(8, calibrate(Rover, Camera, Objective, _), -0.002414724626410532) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(8, calibrate(Rover, Camera, _, _), 0.11141648434300155) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(8, calibrate(Rover, _, Objective, Waypoint), 0.012496803659390033) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), could_communicate_image_data(Rover, Waypoint), !.
delta(8, calibrate(_, _, Objective, _), -0.01395950066297575) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(8, calibrate(_, _, _, _), -0.20348337691844834) :- !.
delta(8, take_image(_, _, Objective, _, Is_mode), 0.25373811976085786) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(8, take_image(Rover, _, Objective, _, _), 0.0699215916212077) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), have_image(Rover, Objective, Is_mode), !.
delta(8, take_image(_, _, Objective, _, _), -0.01712874665962008) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(8, take_image(_, _, _, _, _), -0.13039415048686753) :- !.
delta(8, communicate_soil_data(Rover, _, _, Waypoint, _), 0.004692981365456275) :- todo_communicated_soil_data(Waypoint2), toward_could_communicate_soil_data(Rover, Waypoint2, Waypoint), !.
delta(8, communicate_soil_data(_, _, _, _, _), -0.05748920712566426) :- !.
delta(8, communicate_rock_data(Rover, _, _, Waypoint, _), 0.16823062886606968) :- todo_communicated_soil_data(Waypoint2), toward_could_communicate_rock_data(Rover, Waypoint2, Waypoint), !.
delta(8, communicate_rock_data(_, _, _, _, _), -0.3662993312812721) :- !.
delta(8, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), -0.07012154650612303) :- todo_communicated_image_data(Objective, Is_mode), toward_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint2, Waypoint), could_calibrate(Rover, Waypoint2), !.
delta(8, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), 0.04262509471134876) :- todo_communicated_image_data(Objective, Is_mode), toward_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint2, Waypoint), !.
delta(8, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), -0.03357124236362215) :- todo_communicated_image_data(Objective, Is_mode), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(8, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.3227356039562778) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(8, communicate_image_data(_, _, _, _, _, _), -0.2064737573014871) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 206 examples, 30 leaves
delta(9, navigate(Rover, Waypoint, Waypoint2), 0.05065262526932572) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), todo_communicated_soil_data(Waypoint4), have_soil_analysis(Rover, Waypoint4), !.
delta(9, navigate(Rover, Waypoint, Waypoint2), -0.8244115083367306) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(9, navigate(Rover, Waypoint, Waypoint2), 0.004119313406201239) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), toward_could_sample_soil(Rover, Waypoint2, Waypoint), !.
delta(9, navigate(Rover, Waypoint, _), -0.1444735196670075) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), !.
delta(9, navigate(Rover, Waypoint, _), -0.10696996989088614) :- todo_communicated_rock_data(Waypoint2), toward_could_sample_soil(Rover, Waypoint, Waypoint2), !.
delta(9, navigate(_, _, _), 0.46574879546039116) :- !.
delta(9, sample_soil(_, _, Waypoint), 0.60793347945544) :- todo_communicated_soil_data(Waypoint), !.
delta(9, sample_soil(_, _, _), -0.39455289331698445) :- !.
delta(9, sample_rock(Rover, _, Waypoint), 0.18418963956453535) :- todo_communicated_soil_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(9, sample_rock(_, _, _), -0.27707838805271867) :- !.
delta(9, drop(_, _), 0.3639367784269026) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), !.
delta(9, drop(_, _), -0.0677581647345694) :- !.
delta(9, calibrate(Rover, _, _, Waypoint), -0.019851775348040293) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), fewer_have_image_1_than_have_image_3, !.
delta(9, calibrate(Rover, Camera, _, Waypoint), -0.0016593531824784674) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), calibrated(Camera, Rover), !.
delta(9, calibrate(Rover, _, _, Waypoint), 0.028471289925692513) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), !.
delta(9, calibrate(_, _, _, _), -0.2822627014363328) :- !.
delta(9, take_image(_, _, Objective, _, Is_mode), 0.17841344712871104) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(9, take_image(_, _, _, _, _), -0.10311974544344929) :- !.
delta(9, communicate_soil_data(_, _, Waypoint, _, _), 0.048802713384788414) :- todo_communicated_soil_data(Waypoint), !.
delta(9, communicate_soil_data(_, _, _, _, _), -0.14260763487983696) :- !.
delta(9, communicate_rock_data(Rover, _, _, Waypoint, _), 0.3060017510965561) :- todo_communicated_soil_data(Waypoint2), toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(9, communicate_rock_data(Rover, _, Waypoint, _, _), 0.04422637276634115) :- todo_communicated_soil_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(9, communicate_rock_data(_, _, _, _, _), -0.34375398908224547) :- !.
delta(9, communicate_image_data(Rover, _, _, Is_mode, Waypoint, Waypoint2), 0.034862582125317225) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, _), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2), toward_could_take_image(Rover, Waypoint, Waypoint2), !.
delta(9, communicate_image_data(Rover, _, _, Is_mode, _, Waypoint), -0.08114873899356895) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, _), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(9, communicate_image_data(Rover, _, Objective, Is_mode, _, _), 0.14862665286041105) :- todo_communicated_image_data(Objective2, Is_mode), have_image(Rover, Objective2, _), todo_communicated_image_data(Objective, Is_mode), !.
delta(9, communicate_image_data(Rover, _, _, Is_mode, _, _), -0.003053484566776617) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, _), !.
delta(9, communicate_image_data(Rover, _, _, _, _, Waypoint), 0.021807148050578425) :- could_sample_soil(Rover, Waypoint), !.
delta(9, communicate_image_data(_, _, _, _, _, _), -0.08821592367053427) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 201 examples, 31 leaves
delta(10, navigate(Rover, Waypoint, Waypoint2), -0.09183074552626773) :- toward_could_calibrate(Rover, Waypoint2, Waypoint), toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(10, navigate(Rover, Waypoint, Waypoint2), -0.05265058914890058) :- toward_could_calibrate(Rover, Waypoint2, Waypoint), todo_communicated_rock_data(Waypoint3), at_rock_sample(Waypoint3), !.
delta(10, navigate(Rover, Waypoint, Waypoint2), 0.41935770486602425) :- toward_could_calibrate(Rover, Waypoint2, Waypoint), !.
delta(10, navigate(Rover, _, Waypoint), 0.245308104807405) :- todo_communicated_rock_data(Waypoint2), could_take_image(Rover, Waypoint2), todo_communicated_soil_data(Waypoint3), toward_could_communicate_soil_data(Rover, Waypoint3, Waypoint), !.
delta(10, navigate(Rover, _, _), -0.15730842009170104) :- todo_communicated_rock_data(Waypoint), could_take_image(Rover, Waypoint), !.
delta(10, navigate(Rover, Waypoint, Waypoint2), 0.10922853438169981) :- toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint, Waypoint2), !.
delta(10, navigate(_, _, _), -0.8335767265531638) :- !.
delta(10, sample_soil(_, _, Waypoint), 0.4050375677358899) :- todo_communicated_soil_data(Waypoint), !.
delta(10, sample_soil(_, _, _), -0.2595806448864055) :- !.
delta(10, sample_rock(Rover, _, Waypoint), 0.09696013406687164) :- todo_communicated_soil_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(10, sample_rock(_, _, _), -0.19070051523636547) :- !.
delta(10, drop(Rover, _), -0.08312858270082693) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), todo_communicated_rock_data(Waypoint2), have_rock_analysis(Rover, Waypoint2), could_communicate_image_data(Rover, Waypoint2), !.
delta(10, drop(Rover, _), 0.018720947438916117) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), todo_communicated_rock_data(Waypoint2), have_rock_analysis(Rover, Waypoint2), !.
delta(10, drop(_, _), 0.13669241561897033) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), !.
delta(10, drop(_, _), -0.28043823397597245) :- !.
delta(10, calibrate(Rover, Camera, Objective, Waypoint), 0.001293717742335761) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), could_take_image_for_todo_communicated_image_data_objective_any(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), supports(Camera, Is_mode), !.
delta(10, calibrate(Rover, Camera, _, Waypoint), -0.017222235686285736) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), could_take_image_for_todo_communicated_image_data_objective_any(Rover, Waypoint), !.
delta(10, calibrate(Rover, Camera, _, _), 0.2517538119783769) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(10, calibrate(_, _, _, _), -0.10592401447530715) :- !.
delta(10, take_image(Rover, _, Objective, _, Is_mode), -0.013988240056393358) :- have_image(Rover, Objective, Is_mode), !.
delta(10, take_image(_, _, Objective, _, Is_mode), 0.0013018623137895978) :- todo_communicated_image_data(Objective, Is_mode2), communicated_image_data(_, Is_mode2), todo_communicated_image_data(Objective, Is_mode), !.
delta(10, take_image(_, _, Objective, _, _), -0.0066331792895192605) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(10, take_image(_, _, _, _, _), -0.0053409645853558976) :- todo_communicated_rock_data(_), !.
delta(10, take_image(_, _, _, _, _), 0.24955119897734276) :- !.
delta(10, communicate_soil_data(_, _, Waypoint, _, _), 0.42616731191067325) :- todo_communicated_soil_data(Waypoint), !.
delta(10, communicate_soil_data(_, _, _, _, _), -0.15293132208556395) :- !.
delta(10, communicate_rock_data(Rover, _, _, Waypoint, Waypoint2), 0.6153942824631506) :- toward_could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint2, Waypoint), !.
delta(10, communicate_rock_data(_, _, _, _, _), -0.07903778470308606) :- !.
delta(10, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.16132516489054746) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(10, communicate_image_data(_, _, _, _, _, _), -0.09202808470602533) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 201 examples, 36 leaves
delta(11, navigate(Rover, _, Waypoint), -0.06200890988065121) :- needed_have_soil_analysis_to_communicate_soil_data(Waypoint), todo_communicated_rock_data(Waypoint2), could_sample_rock(Rover, Waypoint2), !.
delta(11, navigate(_, _, Waypoint), 0.3973784705063342) :- needed_have_soil_analysis_to_communicate_soil_data(Waypoint), !.
delta(11, navigate(Rover, Waypoint, _), 0.03009749447853707) :- have_rock_analysis(Rover, _), have_soil_analysis(Rover, Waypoint), !.
delta(11, navigate(Rover, _, _), -0.6083339667195649) :- have_rock_analysis(Rover, _), !.
delta(11, navigate(Rover, _, Waypoint), 0.13289452593719508) :- could_calibrate(Rover, Waypoint), !.
delta(11, navigate(_, _, _), -0.11658655123873943) :- !.
delta(11, sample_soil(_, _, Waypoint), 0.2267625148808926) :- todo_communicated_soil_data(Waypoint), !.
delta(11, sample_soil(_, _, _), -0.13037877701985695) :- !.
delta(11, sample_rock(Rover, _, Waypoint), 0.05732639140687743) :- todo_communicated_soil_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(11, sample_rock(_, _, _), -0.12316129116465352) :- !.
delta(11, drop(Rover, _), -0.06626291136370857) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), todo_communicated_rock_data(Waypoint2), could_communicate_image_data(Rover, Waypoint2), !.
delta(11, drop(Rover, _), 0.002733473602014631) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), todo_communicated_rock_data(Waypoint2), could_calibrate(Rover, Waypoint2), !.
delta(11, drop(_, _), 0.17032712079717566) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), !.
delta(11, drop(_, _), -0.12157311680371234) :- !.
delta(11, calibrate(Rover, Camera, Objective, _), 0.02321368931439252) :- fewer_have_image_1_than_todo_communicated_image_data_2_have_image_3, todo_communicated_image_data(Objective, Is_mode), supports(Camera, Is_mode), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(11, calibrate(_, Camera, Objective, _), -0.019509053565251167) :- fewer_have_image_1_than_todo_communicated_image_data_2_have_image_3, todo_communicated_image_data(Objective, Is_mode), supports(Camera, Is_mode), !.
delta(11, calibrate(_, _, _, _), -0.12606625348840503) :- fewer_have_image_1_than_todo_communicated_image_data_2_have_image_3, !.
delta(11, calibrate(Rover, Camera, Objective, _), -0.007463416164640657) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), calibrated(Camera, Rover), !.
delta(11, calibrate(_, _, Objective, _), 0.13992113866623393) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(11, calibrate(Rover, Camera, _, _), 0.007425121607674161) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(11, calibrate(_, _, _, _), -0.05820164516952127) :- !.
delta(11, take_image(_, _, Objective, _, Is_mode), 0.07518974129695144) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(11, take_image(Rover, Waypoint, Objective, _, _), 0.011034773273981849) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), could_communicate_image_data(Rover, Waypoint), !.
delta(11, take_image(_, _, Objective, _, _), -0.0028806547270444523) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(11, take_image(_, _, _, _, _), -0.03192296064767456) :- !.
delta(11, communicate_soil_data(_, _, Waypoint, _, _), 0.3543121675536668) :- todo_communicated_soil_data(Waypoint), !.
delta(11, communicate_soil_data(_, _, _, _, _), -0.12202834386432142) :- !.
delta(11, communicate_rock_data(_, _, Waypoint, _, _), 0.21728686948258857) :- todo_communicated_rock_data(Waypoint), !.
delta(11, communicate_rock_data(_, _, _, _, _), -0.10537128636558313) :- !.
delta(11, communicate_image_data(_, _, _, Is_mode, _, Waypoint), 0.0018298520780426993) :- communicated_image_data(_, Is_mode), communicated_rock_data(Waypoint), !.
delta(11, communicate_image_data(_, _, Objective, Is_mode, _, _), -2.5637018363892265e-6) :- communicated_image_data(Objective2, Is_mode), todo_communicated_image_data(Objective2, Is_mode2), communicated_image_data(Objective, Is_mode2), !.
delta(11, communicate_image_data(_, _, _, Is_mode, _, _), -0.07735114067570342) :- communicated_image_data(_, Is_mode), !.
delta(11, communicate_image_data(_, _, Objective, Is_mode, _, _), -0.00299621533630735) :- todo_communicated_image_data(Objective, Is_mode2), todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, Is_mode2), !.
delta(11, communicate_image_data(_, _, Objective, _, _, _), 0.24914746937014376) :- todo_communicated_image_data(Objective, _), !.
delta(11, communicate_image_data(_, _, _, _, _, _), -0.012259979401178534) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 206 examples, 37 leaves
delta(12, navigate(Rover, Waypoint, Waypoint2), -0.05484665695878896) :- toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint3), toward_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Waypoint2, Waypoint3), !.
delta(12, navigate(Rover, Waypoint, Waypoint2), 0.22465587665271616) :- toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(12, navigate(Rover, Waypoint, Waypoint2), -0.00530789359362706) :- toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint, Waypoint2), could_take_image_for_todo_communicated_image_data_objective_any(Rover, Waypoint), !.
delta(12, navigate(Rover, Waypoint, Waypoint2), 0.12782023635406803) :- toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint, Waypoint2), !.
delta(12, navigate(Rover, Waypoint, Waypoint2), 0.06615891525140984) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint, Waypoint2), !.
delta(12, navigate(_, _, _), -0.3902986783980667) :- !.
delta(12, sample_soil(Rover, _, Waypoint), -0.03663242166320464) :- could_calibrate(Rover, Waypoint), !.
delta(12, sample_soil(_, _, _), 0.09260324705916884) :- goal_communicated_rock_data(_), !.
delta(12, sample_soil(_, _, _), -0.01634779254220607) :- !.
delta(12, sample_rock(_, _, Waypoint), 0.27399853635457433) :- todo_communicated_rock_data(Waypoint), !.
delta(12, sample_rock(_, _, _), -0.11193048271042451) :- !.
delta(12, drop(_, _), 0.0433900661477888) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(12, drop(_, _), 0.010505145901665281) :- fewer_have_rock_analysis_1_than_have_rock_analysis_2, communicated_rock_data(_), !.
delta(12, drop(_, _), -0.0067983510239998) :- fewer_have_rock_analysis_1_than_have_rock_analysis_2, !.
delta(12, drop(Rover, _), 0.001067478822317637) :- todo_communicated_soil_data(Waypoint), at(Rover, Waypoint), !.
delta(12, drop(_, _), -0.09243231641024685) :- !.
delta(12, calibrate(Rover, Camera, Objective, _), 0.19735698191786333) :- todo_communicated_image_data(Objective, Is_mode), supports(Camera, Is_mode), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(12, calibrate(_, Camera, Objective, _), -0.045163534073359234) :- todo_communicated_image_data(Objective, Is_mode), supports(Camera, Is_mode), !.
delta(12, calibrate(Rover, _, _, Waypoint), 0.042811618561056385) :- todo_communicated_soil_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(12, calibrate(_, _, _, _), -0.12965904040071688) :- !.
delta(12, take_image(Rover, _, _, _, Is_mode), -0.11493299846898672) :- have_image(Rover, _, Is_mode), !.
delta(12, take_image(_, Waypoint, Objective, _, _), 6.533273185693785e-5) :- at_soil_sample(Waypoint), communicated_image_data(Objective, _), !.
delta(12, take_image(_, Waypoint, _, _, _), -0.02108426277166396) :- at_soil_sample(Waypoint), !.
delta(12, take_image(_, _, Objective, _, Is_mode), 0.07711608375793762) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(12, take_image(_, _, _, _, _), -0.009514888259614614) :- !.
delta(12, communicate_soil_data(_, _, _, _, _), -0.1212087877611489) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(12, communicate_soil_data(_, _, _, _, Waypoint), 0.16465560044187774) :- goal_communicated_soil_data(Waypoint), !.
delta(12, communicate_soil_data(_, _, _, _, _), -0.030935429318999248) :- !.
delta(12, communicate_rock_data(_, _, Waypoint, _, _), 0.0741467604705122) :- todo_communicated_rock_data(Waypoint), !.
delta(12, communicate_rock_data(_, _, _, _, _), -0.03802108176976169) :- !.
delta(12, communicate_image_data(_, _, Objective, _, _, Waypoint), -0.12963028418515363) :- at_soil_sample(Waypoint), communicated_image_data(Objective, _), !.
delta(12, communicate_image_data(_, _, _, _, _, Waypoint), 0.0024785534124765448) :- at_soil_sample(Waypoint), !.
delta(12, communicate_image_data(Rover, _, _, _, _, Waypoint), -0.06523027194621447) :- could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint), needed_at_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(12, communicate_image_data(Rover, _, _, _, _, Waypoint), 0.01625360494011079) :- could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint), !.
delta(12, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), 0.22452817935413857) :- toward_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint2, Waypoint), !.
delta(12, communicate_image_data(_, _, _, _, _, _), -0.04015835621440683) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 210 examples, 35 leaves
delta(13, navigate(Rover, Waypoint, Waypoint2), -0.006354425143546125) :- needed_have_soil_analysis_to_communicate_soil_data(Waypoint2), todo_communicated_soil_data(Waypoint3), toward_could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint3, Waypoint), !.
delta(13, navigate(Rover, Waypoint, Waypoint2), -0.0009757135688849098) :- needed_have_soil_analysis_to_communicate_soil_data(Waypoint2), have_soil_analysis(Rover, Waypoint), !.
delta(13, navigate(_, _, Waypoint), 0.21274559898337178) :- needed_have_soil_analysis_to_communicate_soil_data(Waypoint), !.
delta(13, navigate(Rover, Waypoint, Waypoint2), -0.005004680915261494) :- have_soil_analysis(Rover, Waypoint), toward_could_take_image(Rover, Waypoint2, Waypoint), !.
delta(13, navigate(Rover, Waypoint, _), 0.1038698016317877) :- have_soil_analysis(Rover, Waypoint), !.
delta(13, navigate(Rover, Waypoint, Waypoint2), 0.072918150010869) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint, Waypoint2), !.
delta(13, navigate(_, _, _), -0.46823531250624334) :- !.
delta(13, sample_soil(_, _, Waypoint), 0.033339618088954304) :- todo_communicated_soil_data(Waypoint), !.
delta(13, sample_soil(_, _, _), -0.15485758402502434) :- !.
delta(13, sample_rock(Rover, _, Waypoint), -0.020140085598273866) :- could_communicate_image_data(Rover, Waypoint), !.
delta(13, sample_rock(_, _, Waypoint), 0.43771715968106284) :- todo_communicated_rock_data(Waypoint), !.
delta(13, sample_rock(_, _, _), -0.01616323634280297) :- !.
delta(13, drop(Rover, _), 0.009676182285089447) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), todo_communicated_rock_data(Waypoint2), could_communicate_image_data(Rover, Waypoint2), could_communicate_soil_data(Rover, Waypoint2), !.
delta(13, drop(Rover, _), -0.027198900777860198) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), todo_communicated_rock_data(Waypoint2), could_communicate_image_data(Rover, Waypoint2), !.
delta(13, drop(_, _), 0.13934503466836434) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), !.
delta(13, drop(_, _), 0.044042279318084944) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(13, drop(_, _), -0.09965461601853268) :- !.
delta(13, calibrate(_, _, Objective, _), -0.019322413867755375) :- communicated_image_data(Objective, _), todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(13, calibrate(_, _, Objective, _), 0.21480190054268658) :- communicated_image_data(Objective, _), at_rock_sample(_), !.
delta(13, calibrate(_, _, Objective, _), -0.00977875063677547) :- communicated_image_data(Objective, _), !.
delta(13, calibrate(Rover, Camera, _, _), 0.02556266019432123) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(13, calibrate(_, _, _, _), -0.08311103341848765) :- !.
delta(13, take_image(_, Waypoint, Objective, _, Is_mode), -0.01987813858878812) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), at_soil_sample(Waypoint), !.
delta(13, take_image(_, _, Objective, _, Is_mode), 0.06030012667101844) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(13, take_image(_, _, _, _, _), -0.056547793504674135) :- !.
delta(13, communicate_soil_data(_, _, Waypoint, _, _), 0.125093910005397) :- todo_communicated_soil_data(Waypoint), !.
delta(13, communicate_soil_data(Rover, _, _, Waypoint, _), 0.024287148119265984) :- todo_communicated_soil_data(Waypoint2), toward_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Waypoint2, Waypoint), !.
delta(13, communicate_soil_data(_, _, _, _, _), -0.243885353561132) :- !.
delta(13, communicate_rock_data(_, _, Waypoint, _, _), 0.1496526737131735) :- todo_communicated_rock_data(Waypoint), !.
delta(13, communicate_rock_data(_, _, _, _, _), -0.02367608789256843) :- !.
delta(13, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), -0.015643502180937095) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint2, Waypoint), todo_communicated_image_data(Objective, Is_mode), have_soil_analysis(Rover, Waypoint), !.
delta(13, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), 0.08165840078917626) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint2, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(13, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), -0.03514213041828205) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint2, Waypoint), !.
delta(13, communicate_image_data(_, _, _, _, _, _), -0.10488440087723715) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 215 examples, 38 leaves
delta(14, navigate(_, _, Waypoint), 0.012348235127071627) :- goal_communicated_rock_data(Waypoint), todo_communicated_rock_data(Waypoint2), needed_at_to_communicate_soil_data(Waypoint2), communicated_soil_data(_), !.
delta(14, navigate(_, _, Waypoint), -0.0639289871850611) :- goal_communicated_rock_data(Waypoint), todo_communicated_rock_data(Waypoint2), needed_at_to_communicate_soil_data(Waypoint2), !.
delta(14, navigate(_, _, Waypoint), -0.0010778648853129553) :- goal_communicated_rock_data(Waypoint), todo_communicated_soil_data(Waypoint2), communicated_rock_data(Waypoint2), !.
delta(14, navigate(_, _, Waypoint), 0.6942804117640599) :- goal_communicated_rock_data(Waypoint), !.
delta(14, navigate(Rover, Waypoint, Waypoint2), 0.12409662783592695) :- toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint2, Waypoint), todo_communicated_soil_data(Waypoint3), toward_could_take_image(Rover, Waypoint3, Waypoint), !.
delta(14, navigate(Rover, Waypoint, Waypoint2), -0.017869733207850416) :- toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint2, Waypoint), !.
delta(14, navigate(Rover, _, Waypoint), 0.07976213313431117) :- needed_at_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(14, navigate(_, _, _), -0.38516196904371397) :- !.
delta(14, sample_soil(Rover, _, Waypoint), -0.56085728905655) :- communicated_soil_data(Waypoint2), todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(14, sample_soil(_, _, _), 0.014099467860116772) :- communicated_soil_data(_), !.
delta(14, sample_soil(_, _, Waypoint), 0.03560910729831694) :- todo_communicated_soil_data(Waypoint), !.
delta(14, sample_soil(_, _, _), -0.0415659542936687) :- !.
delta(14, sample_rock(_, _, Waypoint), 0.24259178356278124) :- todo_communicated_rock_data(Waypoint), !.
delta(14, sample_rock(_, _, _), -0.09035280284695255) :- !.
delta(14, drop(Rover, _), -0.07264917754873279) :- todo_communicated_soil_data(Waypoint), have_soil_analysis(Rover, Waypoint), !.
delta(14, drop(_, _), 0.15662019207360398) :- goal_communicated_rock_data(_), !.
delta(14, drop(_, _), -0.005474335981687174) :- !.
delta(14, calibrate(Rover, Camera, Objective, _), -0.03420680286607424) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), fewer_have_image_1_than_todo_communicated_image_data_1_have_image_2, communicated_image_data(Objective, _), !.
delta(14, calibrate(Rover, Camera, _, _), 0.0019208078142946138) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), fewer_have_image_1_than_todo_communicated_image_data_1_have_image_2, !.
delta(14, calibrate(Rover, Camera, _, _), 0.08813222459643068) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(14, calibrate(_, _, _, _), -0.09837941099227122) :- !.
delta(14, take_image(_, _, Objective, Camera, Is_mode), 0.0013374468884235421) :- fewer_have_image_1_than_have_image_2, todo_communicated_image_data(Objective2, Is_mode), calibration_target(Camera, Objective2), todo_communicated_image_data(Objective, Is_mode), !.
delta(14, take_image(_, _, _, Camera, Is_mode), -0.024291345973300932) :- fewer_have_image_1_than_have_image_2, todo_communicated_image_data(Objective, Is_mode), calibration_target(Camera, Objective), !.
delta(14, take_image(Rover, _, _, _, _), -9.830126436487551e-5) :- fewer_have_image_1_than_have_image_2, have_rock_analysis(Rover, _), !.
delta(14, take_image(_, _, _, _, _), 0.14680512807019128) :- fewer_have_image_1_than_have_image_2, !.
delta(14, take_image(Rover, _, Objective, _, _), -0.07532477546289444) :- fewer_at_1_than_todo_communicated_image_data_2, have_image(Rover, Objective, _), !.
delta(14, take_image(_, _, _, _, _), 0.002831234635511666) :- fewer_at_1_than_todo_communicated_image_data_2, !.
delta(14, take_image(_, _, Objective, _, Is_mode), 0.008415647597392304) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(14, take_image(_, _, _, _, _), -0.007287000976870053) :- !.
delta(14, communicate_soil_data(_, _, Waypoint, _, _), -0.0508350797905722) :- todo_communicated_soil_data(Waypoint), todo_communicated_soil_data(Waypoint2), unsettled_visible_todo_communicated_rock_data(Waypoint2), !.
delta(14, communicate_soil_data(_, _, Waypoint, _, _), 0.08859940266345212) :- todo_communicated_soil_data(Waypoint), !.
delta(14, communicate_soil_data(_, _, _, _, _), -0.1875428984494027) :- !.
delta(14, communicate_rock_data(_, _, Waypoint, _, _), 0.19007087845469303) :- todo_communicated_rock_data(Waypoint), !.
delta(14, communicate_rock_data(_, _, _, _, _), -0.06850315976061033) :- !.
delta(14, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), -0.04216440162107635) :- todo_communicated_image_data(Objective, Is_mode), toward_could_take_image(Rover, Waypoint, Waypoint2), !.
delta(14, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.05289184284392261) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(14, communicate_image_data(_, _, _, _, _, _), -0.13182754302339805) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 205 examples, 38 leaves
delta(15, navigate(Rover, Waypoint, Waypoint2), -0.005526583625579561) :- todo_communicated_rock_data(Waypoint), todo_communicated_soil_data(Waypoint3), toward_could_communicate_image_data(Rover, Waypoint3, Waypoint), todo_communicated_rock_data(Waypoint4), toward_could_sample_soil(Rover, Waypoint2, Waypoint4), !.
delta(15, navigate(Rover, Waypoint, _), 0.028200626800912364) :- todo_communicated_rock_data(Waypoint), todo_communicated_soil_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(15, navigate(Rover, Waypoint, Waypoint2), 0.001007270038823301) :- todo_communicated_rock_data(Waypoint), todo_communicated_rock_data(Waypoint3), toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint3, Waypoint2), !.
delta(15, navigate(_, Waypoint, _), -0.20344506256126046) :- todo_communicated_rock_data(Waypoint), !.
delta(15, navigate(_, _, Waypoint), -0.10981018492497611) :- communicated_soil_data(Waypoint), !.
delta(15, navigate(_, Waypoint, _), -0.06222335269769593) :- needed_have_soil_analysis_to_communicate_soil_data(Waypoint), !.
delta(15, navigate(_, _, _), 0.32202875259009917) :- !.
delta(15, sample_soil(Rover, _, Waypoint), -0.010742196486651898) :- could_calibrate(Rover, Waypoint), !.
delta(15, sample_soil(_, _, _), 0.08076021702187995) :- goal_communicated_rock_data(_), !.
delta(15, sample_soil(_, _, _), -0.0011683182609076054) :- !.
delta(15, sample_rock(_, _, Waypoint), 0.1799098552283756) :- todo_communicated_rock_data(Waypoint), !.
delta(15, sample_rock(_, _, _), -0.037134767177931106) :- !.
delta(15, drop(Rover, _), -0.00722957109515802) :- todo_communicated_rock_data(Waypoint), at(Rover, Waypoint), todo_communicated_rock_data(Waypoint2), have_rock_analysis(Rover, Waypoint2), !.
delta(15, drop(Rover, _), 0.03811019779749164) :- todo_communicated_rock_data(Waypoint), at(Rover, Waypoint), !.
delta(15, drop(_, _), 0.012536000681066625) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), !.
delta(15, drop(_, _), -0.1424947230753575) :- !.
delta(15, calibrate(Rover, Camera, _, Waypoint), 0.05634187234556119) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(15, calibrate(Rover, _, _, Waypoint), -0.0043001919212669664) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), !.
delta(15, calibrate(_, _, Objective, _), 0.003943284535604376) :- communicated_rock_data(_), todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(15, calibrate(_, _, _, _), -0.0023812586208260263) :- communicated_rock_data(_), !.
delta(15, calibrate(Rover, _, _, Waypoint), 0.00016574194604392003) :- could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint), !.
delta(15, calibrate(_, _, _, _), -0.23504228347239695) :- !.
delta(15, take_image(_, Waypoint, Objective, _, Is_mode), -0.019030682620595908) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), at_soil_sample(Waypoint), !.
delta(15, take_image(_, _, Objective, _, Is_mode), 0.041983056714235086) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(15, take_image(_, _, _, _, _), -0.06235701779511155) :- !.
delta(15, communicate_soil_data(_, _, Waypoint, _, _), 0.05908431807005538) :- todo_communicated_soil_data(Waypoint), !.
delta(15, communicate_soil_data(_, _, _, _, _), -0.13422989512812983) :- !.
delta(15, communicate_rock_data(_, _, Waypoint, _, _), 0.1118160251795143) :- todo_communicated_rock_data(Waypoint), !.
delta(15, communicate_rock_data(_, _, _, _, _), -0.043154341113395236) :- !.
delta(15, communicate_image_data(Rover, _, Objective, Is_mode, _, Waypoint), -0.0012726249299521283) :- todo_communicated_image_data(Objective, Is_mode2), communicated_image_data(_, Is_mode2), needed_at_to_take_image_to_communicate_image_data(Rover, Waypoint), communicated_image_data(Objective, Is_mode), !.
delta(15, communicate_image_data(Rover, _, Objective, _, _, Waypoint), 0.07327296997929238) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), needed_at_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(15, communicate_image_data(Rover, _, Objective, _, _, Waypoint), -0.03323934007134065) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(15, communicate_image_data(_, _, Objective, _, _, _), 0.00472577817147511) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(15, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.010623787550208383) :- todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), todo_communicated_image_data(Objective, Is_mode), !.
delta(15, communicate_image_data(_, _, _, Is_mode, _, _), -0.002522494632356455) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(Objective, _), !.
delta(15, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), 0.006781480396507207) :- toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint, Waypoint2), !.
delta(15, communicate_image_data(_, _, _, _, _, _), -0.14779176487745) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 225 examples, 38 leaves
delta(16, navigate(Rover, Waypoint, Waypoint2), -0.04201428919325075) :- toward_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Waypoint, Waypoint2), todo_communicated_soil_data(Waypoint3), can_traverse(Rover, Waypoint, Waypoint3), !.
delta(16, navigate(Rover, Waypoint, Waypoint2), -0.0060887265060627915) :- toward_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Waypoint, Waypoint2), at_soil_sample(Waypoint), !.
delta(16, navigate(Rover, Waypoint, Waypoint2), 0.29458921618936423) :- toward_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Waypoint, Waypoint2), !.
delta(16, navigate(_, Waypoint, Waypoint2), -0.02576151975924079) :- communicated_rock_data(Waypoint2), at_soil_sample(Waypoint), !.
delta(16, navigate(_, _, Waypoint), 0.19132233477325591) :- communicated_rock_data(Waypoint), !.
delta(16, navigate(Rover, Waypoint, _), 0.13532949878559827) :- todo_communicated_soil_data(Waypoint2), toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(16, navigate(_, _, _), -0.35929914150074027) :- !.
delta(16, sample_soil(_, _, Waypoint), -0.01072241145275969) :- todo_communicated_soil_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(16, sample_soil(Rover, _, _), 0.006642459674533389) :- todo_communicated_rock_data(Waypoint), needed_at_to_communicate_rock_data(Waypoint), todo_communicated_soil_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(16, sample_soil(_, _, _), -0.016275282013183418) :- todo_communicated_rock_data(Waypoint), needed_at_to_communicate_rock_data(Waypoint), !.
delta(16, sample_soil(_, _, _), -0.00679709536372898) :- fewer_at_1_than_todo_communicated_image_data_2, !.
delta(16, sample_soil(_, _, _), 0.08530377893110169) :- !.
delta(16, sample_rock(_, _, Waypoint), 0.07615329498254646) :- todo_communicated_rock_data(Waypoint), !.
delta(16, sample_rock(_, _, _), -0.027019734894376507) :- !.
delta(16, drop(Rover, _), -0.003060461576813639) :- goal_communicated_soil_data(_), todo_communicated_rock_data(Waypoint), could_communicate_image_data(Rover, Waypoint), !.
delta(16, drop(_, _), 0.11532126566136759) :- goal_communicated_soil_data(_), !.
delta(16, drop(Rover, _), 0.03890278443543836) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), todo_communicated_rock_data(Waypoint2), at(Rover, Waypoint2), !.
delta(16, drop(_, _), -0.012661264997746507) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(16, drop(_, _), -0.09642389250202628) :- !.
delta(16, calibrate(_, _, _, _), 0.002994888200656878) :- goal_communicated_rock_data(_), fewer_at_1_than_todo_communicated_image_data_1, !.
delta(16, calibrate(Rover, _, _, _), 0.001080272824656097) :- goal_communicated_rock_data(_), todo_communicated_soil_data(Waypoint), have_soil_analysis(Rover, Waypoint), !.
delta(16, calibrate(_, _, _, _), -0.15917757111636968) :- goal_communicated_rock_data(_), !.
delta(16, calibrate(Rover, Camera, _, _), 0.05328910104789039) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(16, calibrate(_, _, _, _), -0.018722825951036748) :- !.
delta(16, take_image(Rover, _, Objective, _, Is_mode), -0.011932710616688135) :- todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), have_image(Rover, Objective, Is_mode), !.
delta(16, take_image(_, _, _, _, Is_mode), 0.0448786399287661) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(Objective, _), !.
delta(16, take_image(Rover, Waypoint, Objective, Camera, _), 0.0016367176575663909) :- calibration_target(Camera, Objective), todo_communicated_rock_data(Waypoint2), toward_could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(16, take_image(_, _, Objective, Camera, _), -0.04555308535693724) :- calibration_target(Camera, Objective), !.
delta(16, take_image(_, _, Objective, _, Is_mode), 0.006523424942661761) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(16, take_image(_, _, _, _, _), -0.0037422463203706817) :- !.
delta(16, communicate_soil_data(_, _, Waypoint, _, _), 0.11095396108336421) :- todo_communicated_soil_data(Waypoint), !.
delta(16, communicate_soil_data(_, _, _, _, _), -0.2028158136624229) :- !.
delta(16, communicate_rock_data(_, _, Waypoint, _, _), 0.22046255138368395) :- todo_communicated_rock_data(Waypoint), !.
delta(16, communicate_rock_data(_, _, _, _, _), -0.026151987491437954) :- !.
delta(16, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), 0.04452390215596202) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint2, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(16, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), -0.012484954471065686) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint2, Waypoint), !.
delta(16, communicate_image_data(_, _, _, _, _, _), -0.1120350539964341) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 208 examples, 42 leaves
delta(17, navigate(Rover, Waypoint, Waypoint2), -0.012023095959823394) :- todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), todo_communicated_soil_data(Waypoint4), needed_at_to_sample_soil_to_communicate_soil_data(Rover, Waypoint4), at_soil_sample(Waypoint), !.
delta(17, navigate(Rover, Waypoint, Waypoint2), 0.056216956378119756) :- todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), todo_communicated_soil_data(Waypoint4), needed_at_to_sample_soil_to_communicate_soil_data(Rover, Waypoint4), !.
delta(17, navigate(Rover, Waypoint, Waypoint2), 0.020823744687212358) :- todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), todo_communicated_rock_data(Waypoint4), toward_could_sample_soil(Rover, Waypoint4, Waypoint2), !.
delta(17, navigate(Rover, Waypoint, Waypoint2), -0.43308265403062657) :- todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(17, navigate(Rover, Waypoint, Waypoint2), 0.08949884488372996) :- todo_communicated_soil_data(Waypoint3), visible(Waypoint2, Waypoint3), toward_could_communicate_soil_data_todo_communicated_soil_data(Rover, Waypoint, Waypoint2), !.
delta(17, navigate(_, _, Waypoint), -0.14227346949719621) :- todo_communicated_soil_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(17, navigate(Rover, _, Waypoint), -0.05276710244576145) :- have_soil_analysis(Rover, Waypoint), !.
delta(17, navigate(_, _, _), 0.32304036253506063) :- !.
delta(17, sample_soil(_, _, Waypoint), -0.015091473156252214) :- todo_communicated_soil_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(17, sample_soil(_, _, _), 0.10324211419071681) :- goal_communicated_rock_data(_), !.
delta(17, sample_soil(_, _, _), -0.009429260737104993) :- !.
delta(17, sample_rock(_, _, Waypoint), 0.13355573585198713) :- todo_communicated_rock_data(Waypoint), !.
delta(17, sample_rock(_, _, _), -0.024305713386388345) :- !.
delta(17, drop(Rover, _), -0.012287565031715852) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), communicated_soil_data(_), could_communicate_image_data(Rover, Waypoint), !.
delta(17, drop(_, _), 0.12476316879159662) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), communicated_soil_data(_), !.
delta(17, drop(_, _), 0.010877859262611596) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), todo_communicated_soil_data(Waypoint2), at_rock_sample(Waypoint2), !.
delta(17, drop(_, _), -0.04767459800153247) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(17, drop(Rover, _), 0.04331710714931593) :- calibrated(_, Rover), todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), !.
delta(17, drop(Rover, _), -0.03059841712257177) :- calibrated(_, Rover), !.
delta(17, drop(_, _), 0.012562679765364427) :- todo_communicated_rock_data(Waypoint), needed_at_to_communicate_soil_data(Waypoint), !.
delta(17, drop(_, _), -0.17970707386161738) :- !.
delta(17, calibrate(Rover, _, _, Waypoint), 0.0011066090451839336) :- todo_communicated_soil_data(_), todo_communicated_soil_data(Waypoint2), toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(17, calibrate(_, _, _, _), -0.020624879099459422) :- todo_communicated_soil_data(_), !.
delta(17, calibrate(Rover, Camera, Objective, _), 0.013653692966534348) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(17, calibrate(Rover, _, Objective, _), -0.02120334199202968) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), !.
delta(17, calibrate(Rover, _, _, Waypoint), -0.006716360653240254) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(17, calibrate(_, _, _, _), 0.1770064811718014) :- !.
delta(17, take_image(Rover, _, _, _, Is_mode), -0.08692803039710234) :- have_image(Rover, _, Is_mode), !.
delta(17, take_image(Rover, Waypoint, Objective, _, _), -0.0003889533600024507) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), todo_communicated_soil_data(Waypoint2), visible_from(Objective, Waypoint2), !.
delta(17, take_image(Rover, Waypoint, _, _, _), 0.04999524557213396) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), !.
delta(17, take_image(_, _, _, _, _), -0.009165184071003082) :- !.
delta(17, communicate_soil_data(_, _, Waypoint, _, _), 0.08531946537324403) :- todo_communicated_soil_data(Waypoint), !.
delta(17, communicate_soil_data(_, _, _, _, _), -0.21180708600256717) :- !.
delta(17, communicate_rock_data(_, _, Waypoint, _, _), 0.14488283009865233) :- todo_communicated_rock_data(Waypoint), !.
delta(17, communicate_rock_data(_, _, _, _, _), -0.04631162281685114) :- !.
delta(17, communicate_image_data(_, _, Objective, Is_mode, Waypoint, _), 0.007529215462657751) :- todo_communicated_image_data(Objective2, Is_mode), visible_from(Objective2, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(17, communicate_image_data(_, _, _, Is_mode, Waypoint, _), -0.0010336980246362087) :- todo_communicated_image_data(Objective, Is_mode), visible_from(Objective, Waypoint), !.
delta(17, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), 0.0020353633361729277) :- toward_could_take_image_for_todo_communicated_image_data_objective_any(Rover, Waypoint2, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(17, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), -0.0009535793680850853) :- toward_could_take_image_for_todo_communicated_image_data_objective_any(Rover, Waypoint2, Waypoint), !.
delta(17, communicate_image_data(Rover, _, _, _, Waypoint, _), 0.0001649246781897216) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), !.
delta(17, communicate_image_data(_, _, _, _, _, _), -0.1273936134767491) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 203 examples, 39 leaves
delta(18, navigate(Rover, Waypoint, Waypoint2), 0.008450680298645664) :- todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint, Waypoint2, Waypoint3), todo_communicated_rock_data(Waypoint4), have_rock_analysis(Rover, Waypoint4), toward_could_sample_rock(Rover, Waypoint, Waypoint2), !.
delta(18, navigate(Rover, Waypoint, Waypoint2), -0.09485457679387058) :- todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint, Waypoint2, Waypoint3), todo_communicated_rock_data(Waypoint4), have_rock_analysis(Rover, Waypoint4), !.
delta(18, navigate(Rover, Waypoint, Waypoint2), -0.041054712249242405) :- todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint, Waypoint2, Waypoint3), todo_communicated_rock_data(Waypoint4), toward_could_sample_soil(Rover, Waypoint4, Waypoint2), !.
delta(18, navigate(Rover, Waypoint, Waypoint2), 0.3552811867993706) :- todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint, Waypoint2, Waypoint3), !.
delta(18, navigate(Rover, Waypoint, Waypoint2), -0.10979383350884417) :- could_communicate_image_data(Rover, Waypoint2), todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(18, navigate(Rover, _, Waypoint), 0.2637214921372441) :- could_communicate_image_data(Rover, Waypoint), !.
delta(18, navigate(Rover, Waypoint, Waypoint2), 0.0743816543956199) :- toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(18, navigate(_, _, _), -0.4153497386710566) :- !.
delta(18, sample_soil(_, _, Waypoint), 0.01033757964915618) :- todo_communicated_soil_data(Waypoint), !.
delta(18, sample_soil(_, _, _), -0.1598130537478904) :- !.
delta(18, sample_rock(_, _, _), -0.0004842612418029011) :- todo_communicated_rock_data(_), fewer_at_1_than_todo_communicated_image_data_2, !.
delta(18, sample_rock(_, _, _), 0.17575598584084598) :- todo_communicated_rock_data(_), !.
delta(18, sample_rock(_, _, _), -0.018155678958823498) :- !.
delta(18, drop(Rover, _), -0.030005484700031122) :- goal_communicated_soil_data(_), todo_communicated_soil_data(Waypoint), have_soil_analysis(Rover, Waypoint), !.
delta(18, drop(_, _), 0.20223448835848004) :- goal_communicated_soil_data(_), !.
delta(18, drop(Rover, _), -0.012582408889116273) :- todo_communicated_rock_data(Waypoint), at(Rover, Waypoint), todo_communicated_rock_data(Waypoint2), have_rock_analysis(Rover, Waypoint2), !.
delta(18, drop(Rover, _), 0.038044891548885566) :- todo_communicated_rock_data(Waypoint), at(Rover, Waypoint), !.
delta(18, drop(_, _), -0.07851880882611006) :- !.
delta(18, calibrate(Rover, Camera, _, _), 0.045339317573414396) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(18, calibrate(_, _, _, _), -0.05404854809231016) :- !.
delta(18, take_image(Rover, _, Objective, _, Is_mode), 0.001931602865203756) :- goal_communicated_image_data(Objective, Is_mode), todo_communicated_image_data(Objective, Is_mode2), have_image(Rover, Objective, Is_mode2), goal_communicated_rock_data(_), !.
delta(18, take_image(Rover, _, Objective, _, Is_mode), -0.02107399283870807) :- goal_communicated_image_data(Objective, Is_mode), todo_communicated_image_data(Objective, Is_mode2), have_image(Rover, Objective, Is_mode2), !.
delta(18, take_image(Rover, Waypoint, Objective, _, Is_mode), -2.8929722557822813e-5) :- goal_communicated_image_data(Objective, Is_mode), todo_communicated_rock_data(Waypoint2), toward_could_sample_soil(Rover, Waypoint2, Waypoint), !.
delta(18, take_image(_, _, Objective, _, Is_mode), 0.0548869098526488) :- goal_communicated_image_data(Objective, Is_mode), !.
delta(18, take_image(_, _, _, _, _), -0.0248912951058768) :- !.
delta(18, communicate_soil_data(_, _, _, Waypoint, _), -0.012377567533346507) :- at_soil_sample(Waypoint), todo_communicated_soil_data(Waypoint2), at_soil_sample(Waypoint2), !.
delta(18, communicate_soil_data(_, _, _, Waypoint, _), 0.08371086016080793) :- at_soil_sample(Waypoint), !.
delta(18, communicate_soil_data(_, _, Waypoint, _, _), 0.026756862672969898) :- todo_communicated_soil_data(Waypoint), !.
delta(18, communicate_soil_data(_, _, _, _, _), -0.11751050306096271) :- !.
delta(18, communicate_rock_data(_, _, Waypoint, _, _), -0.046684661919090396) :- communicated_rock_data(Waypoint), !.
delta(18, communicate_rock_data(_, _, _, _, _), 0.00045777512834477513) :- goal_communicated_rock_data(_), todo_communicated_soil_data(Waypoint), at_rock_sample(Waypoint), !.
delta(18, communicate_rock_data(_, _, _, _, _), 0.1594523465807582) :- goal_communicated_rock_data(_), !.
delta(18, communicate_rock_data(_, _, _, _, _), -0.00934306705570459) :- !.
delta(18, communicate_image_data(Rover, _, Objective, _, Waypoint, Waypoint2), -0.03479929303264606) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint2, Waypoint), todo_communicated_rock_data(Waypoint3), visible_from(Objective, Waypoint3), at_soil_sample(Waypoint), !.
delta(18, communicate_image_data(Rover, _, Objective, _, Waypoint, Waypoint2), 0.00011041545808864856) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint2, Waypoint), todo_communicated_rock_data(Waypoint3), visible_from(Objective, Waypoint3), !.
delta(18, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), -0.020185939015984665) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint2, Waypoint), have_soil_analysis(Rover, Waypoint), !.
delta(18, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), 0.06453152122957917) :- toward_could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint2, Waypoint), !.
delta(18, communicate_image_data(_, _, _, _, _, _), -0.1659927110241129) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 203 examples, 38 leaves
delta(19, navigate(Rover, Waypoint, Waypoint2), -0.04461370770161602) :- toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), have_rock_analysis(Rover, Waypoint2), !.
delta(19, navigate(Rover, Waypoint, Waypoint2), -0.0022471719868821776) :- toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), toward_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint2, Waypoint), !.
delta(19, navigate(Rover, Waypoint, Waypoint2), 0.15321910944745387) :- toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(19, navigate(Rover, Waypoint, Waypoint2), 0.13435027626853033) :- todo_communicated_rock_data(Waypoint3), toward_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Waypoint2, Waypoint3), todo_communicated_soil_data(Waypoint), !.
delta(19, navigate(Rover, _, Waypoint), -0.01228615713253963) :- todo_communicated_rock_data(Waypoint2), toward_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Waypoint, Waypoint2), !.
delta(19, navigate(_, Waypoint, _), -0.41986644255175815) :- unsettled_visible(Waypoint), !.
delta(19, navigate(_, _, _), 0.024670012160844034) :- !.
delta(19, sample_soil(_, _, Waypoint), 0.03522099825556207) :- todo_communicated_soil_data(Waypoint), !.
delta(19, sample_soil(_, _, _), -0.009680070551452568) :- !.
delta(19, sample_rock(_, _, Waypoint), 0.07418982633495069) :- todo_communicated_rock_data(Waypoint), !.
delta(19, sample_rock(_, _, _), -0.023446261978839783) :- !.
delta(19, drop(Rover, _), -0.025902338637514125) :- have_rock_analysis(Rover, Waypoint), todo_communicated_soil_data(Waypoint2), toward_could_communicate_rock_data(Rover, Waypoint2, Waypoint), could_communicate_image_data(Rover, Waypoint), !.
delta(19, drop(Rover, _), 0.050334829683985435) :- have_rock_analysis(Rover, Waypoint), todo_communicated_soil_data(Waypoint2), toward_could_communicate_rock_data(Rover, Waypoint2, Waypoint), !.
delta(19, drop(Rover, _), 0.0072061999001426635) :- have_rock_analysis(Rover, Waypoint), at_soil_sample(Waypoint), !.
delta(19, drop(Rover, _), -0.09397512910081389) :- have_rock_analysis(Rover, _), !.
delta(19, drop(_, _), -0.037580698789561946) :- todo_communicated_soil_data(_), !.
delta(19, drop(_, _), 0.15502552253553722) :- !.
delta(19, calibrate(Rover, Camera, _, _), -0.008351037352602269) :- calibrated(Camera, Rover), !.
delta(19, calibrate(Rover, _, _, _), -0.005101802613933603) :- todo_communicated_soil_data(Waypoint), could_sample_rock(Rover, Waypoint), !.
delta(19, calibrate(Rover, _, _, Waypoint), -0.00464607750964466) :- todo_communicated_rock_data(Waypoint2), toward_could_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(19, calibrate(_, _, _, _), 0.13962339943833868) :- !.
delta(19, take_image(_, _, Objective, _, Is_mode), 0.011251161904417854) :- at_soil_sample(_), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(19, take_image(_, _, _, _, _), -0.004499778378321422) :- at_soil_sample(_), !.
delta(19, take_image(Rover, _, _, _, _), -0.0002832753935185432) :- communicated_soil_data(_), todo_communicated_rock_data(Waypoint), have_rock_analysis(Rover, Waypoint), !.
delta(19, take_image(_, _, _, _, _), 0.0021980251522796756) :- communicated_soil_data(_), !.
delta(19, take_image(_, _, _, _, _), -0.10575328921935352) :- !.
delta(19, communicate_soil_data(_, _, Waypoint, _, _), -0.059764115883356485) :- communicated_soil_data(Waypoint), !.
delta(19, communicate_soil_data(Rover, _, _, _, _), -0.006878935646772537) :- at_rock_sample(Waypoint), at(Rover, Waypoint), !.
delta(19, communicate_soil_data(_, _, _, _, _), 0.0997297180678195) :- at_rock_sample(_), !.
delta(19, communicate_soil_data(_, _, _, _, _), -0.008536293616626632) :- !.
delta(19, communicate_rock_data(_, _, Waypoint, _, _), 0.21111185318787218) :- todo_communicated_rock_data(Waypoint), !.
delta(19, communicate_rock_data(_, _, _, _, _), -0.0718796197722659) :- !.
delta(19, communicate_image_data(_, _, Objective, Is_mode, _, _), -0.04308990021793369) :- communicated_image_data(Objective, Is_mode), !.
delta(19, communicate_image_data(_, _, _, Is_mode, _, Waypoint), -0.02120779997036653) :- todo_communicated_image_data(Objective, Is_mode), visible_from(Objective, Waypoint), fewer_have_image_1_than_have_image_2, !.
delta(19, communicate_image_data(_, _, _, Is_mode, _, Waypoint), 0.008593631190193726) :- todo_communicated_image_data(Objective, Is_mode), visible_from(Objective, Waypoint), !.
delta(19, communicate_image_data(_, _, _, _, _, _), -0.0122952030613681) :- todo_communicated_soil_data(Waypoint), at_rock_sample(Waypoint), !.
delta(19, communicate_image_data(_, _, _, _, _, _), 0.15176316351157715) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 208 examples, 36 leaves
delta(20, navigate(Rover, Waypoint, Waypoint2), 0.019770661986160464) :- todo_communicated_rock_data(Waypoint3), can_traverse(Rover, Waypoint2, Waypoint3), needed_have_rock_analysis_to_communicate_rock_data(Waypoint), could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, Waypoint2), !.
delta(20, navigate(Rover, Waypoint, Waypoint2), -0.07751048717460401) :- todo_communicated_rock_data(Waypoint3), can_traverse(Rover, Waypoint2, Waypoint3), needed_have_rock_analysis_to_communicate_rock_data(Waypoint), !.
delta(20, navigate(Rover, _, Waypoint), -0.019798148218282748) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), have_soil_analysis(Rover, Waypoint), !.
delta(20, navigate(Rover, _, Waypoint), 0.2623298305076455) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(20, navigate(_, _, Waypoint), 0.04554179739543345) :- todo_communicated_rock_data(_), needed_have_soil_analysis_to_communicate_soil_data(Waypoint), !.
delta(20, navigate(_, _, _), -0.2965952296851479) :- todo_communicated_rock_data(_), !.
delta(20, navigate(Rover, Waypoint, Waypoint2), -0.053167661216229546) :- toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(20, navigate(_, _, _), 0.1134702111219547) :- !.
delta(20, sample_soil(_, _, Waypoint), -0.00860184505575412) :- todo_communicated_soil_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(20, sample_soil(_, _, _), -0.005843501172646273) :- goal_communicated_rock_data(_), fewer_have_image_1_than_have_image_2, !.
delta(20, sample_soil(_, _, _), 0.10973579253254535) :- goal_communicated_rock_data(_), !.
delta(20, sample_soil(_, _, _), -0.008292442579442814) :- !.
delta(20, sample_rock(_, _, Waypoint), 0.06861281294613535) :- todo_communicated_rock_data(Waypoint), !.
delta(20, sample_rock(_, _, _), -0.01713789478012127) :- !.
delta(20, drop(_, _), 0.07754705245531925) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(20, drop(_, _), 0.01959319332153203) :- fewer_have_soil_analysis_1_than_todo_communicated_soil_data, !.
delta(20, drop(Rover, _), 0.012333334819807952) :- todo_communicated_rock_data(Waypoint), could_calibrate(Rover, Waypoint), !.
delta(20, drop(_, _), -0.13886137479514757) :- !.
delta(20, calibrate(Rover, Camera, _, _), 0.036560905565736754) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(20, calibrate(_, _, _, _), -0.06280298642845802) :- !.
delta(20, take_image(_, Waypoint, _, _, _), -0.02511894613286941) :- at_soil_sample(Waypoint), !.
delta(20, take_image(Rover, Waypoint, Objective, _, Is_mode), -0.0007198208500416479) :- goal_communicated_image_data(Objective, Is_mode), could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), !.
delta(20, take_image(_, _, Objective, _, Is_mode), 0.07551769112025958) :- goal_communicated_image_data(Objective, Is_mode), !.
delta(20, take_image(_, _, _, _, _), -0.012532480539837089) :- !.
delta(20, communicate_soil_data(_, _, Waypoint, _, _), 0.061346628025809195) :- todo_communicated_soil_data(Waypoint), !.
delta(20, communicate_soil_data(Rover, _, _, Waypoint, _), 0.0035234790750708392) :- could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Waypoint), !.
delta(20, communicate_soil_data(_, _, _, _, _), -0.14235104308522276) :- !.
delta(20, communicate_rock_data(_, _, Waypoint, _, _), 0.0985450052555603) :- todo_communicated_rock_data(Waypoint), !.
delta(20, communicate_rock_data(_, _, _, _, _), -0.09783521875677731) :- !.
delta(20, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), 0.0002702561885763051) :- todo_communicated_rock_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), goal_communicated_image_data(Objective, Is_mode), todo_communicated_rock_data(Waypoint3), could_sample_rock(Rover, Waypoint3), !.
delta(20, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), -0.0014913029085183917) :- todo_communicated_rock_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), goal_communicated_image_data(Objective, Is_mode), !.
delta(20, communicate_image_data(Rover, _, _, _, Waypoint, _), 0.056564863221745636) :- todo_communicated_rock_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(20, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), -0.006221198659753686) :- todo_communicated_image_data(Objective, Is_mode), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(20, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.030229842293904102) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(20, communicate_image_data(_, _, _, _, _, _), -0.08682051536198133) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 208 examples, 49 leaves
delta(21, navigate(Rover, _, Waypoint), 0.01633997870724828) :- could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint), at_soil_sample(Waypoint), communicated_soil_data(_), !.
delta(21, navigate(Rover, _, Waypoint), -0.035605679643044806) :- could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint), at_soil_sample(Waypoint), !.
delta(21, navigate(Rover, Waypoint, Waypoint2), -0.009734671796882892) :- could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint2), todo_communicated_rock_data(Waypoint3), toward_could_sample_rock(Rover, Waypoint3, Waypoint), !.
delta(21, navigate(Rover, _, Waypoint), 0.21352227766106321) :- could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint), !.
delta(21, navigate(_, Waypoint, Waypoint2), -0.031134717098820736) :- goal_communicated_rock_data(Waypoint2), needed_have_soil_analysis_to_communicate_soil_data(Waypoint), !.
delta(21, navigate(_, _, Waypoint), 0.18221070149784943) :- goal_communicated_rock_data(Waypoint), !.
delta(21, navigate(_, _, _), 0.10183893168968278) :- fewer_have_image_1_than_todo_communicated_image_data_1_have_image_2, !.
delta(21, navigate(_, _, _), -0.27960980491821186) :- !.
delta(21, sample_soil(_, _, Waypoint), -0.007392804167599923) :- unsettled_visible(Waypoint), todo_communicated_soil_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(21, sample_soil(_, _, Waypoint), 0.04682186083238781) :- unsettled_visible(Waypoint), !.
delta(21, sample_soil(_, _, _), -0.008464104230231247) :- !.
delta(21, sample_rock(_, _, Waypoint), 0.1935592100188133) :- todo_communicated_rock_data(Waypoint), !.
delta(21, sample_rock(_, _, _), -0.016927882273511802) :- !.
delta(21, drop(Rover, _), -0.007218944844644618) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), todo_communicated_rock_data(Waypoint2), have_rock_analysis(Rover, Waypoint2), !.
delta(21, drop(_, _), 0.08929663142719435) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), !.
delta(21, drop(_, _), 0.037153618970810404) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(21, drop(_, _), -0.11432865919770532) :- !.
delta(21, calibrate(Rover, Camera, _, Waypoint), 0.011736264840356225) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(21, calibrate(Rover, _, _, Waypoint), -0.001132324595578905) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), !.
delta(21, calibrate(Rover, _, _, Waypoint), 0.003127444346182335) :- todo_communicated_rock_data(Waypoint2), toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(21, calibrate(_, _, Objective, _), 0.0025685305589975764) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(21, calibrate(_, _, _, _), -0.10434515451247132) :- !.
delta(21, take_image(Rover, _, Objective, _, Is_mode), -0.00043673249205818554) :- todo_communicated_image_data(Objective, Is_mode2), have_image(Rover, Objective, Is_mode2), todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, Is_mode2), have_image(Rover, Objective, Is_mode), !.
delta(21, take_image(Rover, _, Objective, _, Is_mode), 0.01686585501488844) :- todo_communicated_image_data(Objective, Is_mode2), have_image(Rover, Objective, Is_mode2), todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, Is_mode2), !.
delta(21, take_image(Rover, _, Objective, Camera, _), -0.07574820886298389) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), todo_communicated_image_data(Objective2, Is_mode), calibration_target(Camera, Objective2), !.
delta(21, take_image(Rover, _, Objective, _, _), 0.00019435661953486213) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), !.
delta(21, take_image(_, _, Objective, Camera, Is_mode), 0.014962806636791358) :- todo_communicated_image_data(Objective2, Is_mode), calibration_target(Camera, Objective2), todo_communicated_image_data(Objective, Is_mode), !.
delta(21, take_image(_, _, _, Camera, Is_mode), -0.029456079434767975) :- todo_communicated_image_data(Objective, Is_mode), calibration_target(Camera, Objective), !.
delta(21, take_image(_, _, _, _, _), 0.17256266990716382) :- fewer_have_image_1_than_have_image_3, !.
delta(21, take_image(_, _, _, _, _), -0.004951232854609647) :- !.
delta(21, communicate_soil_data(Rover, _, Waypoint, Waypoint2, _), 0.034139196088234854) :- toward_could_communicate_image_data(Rover, Waypoint, Waypoint2), !.
delta(21, communicate_soil_data(Rover, _, _, Waypoint, _), 0.0001890838412658061) :- todo_communicated_rock_data(Waypoint2), todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(21, communicate_soil_data(_, _, _, _, _), -0.24979991067142351) :- todo_communicated_rock_data(_), !.
delta(21, communicate_soil_data(Rover, _, Waypoint, Waypoint2, Waypoint3), 0.010822378027970918) :- nearer_at(Rover, Waypoint2, Waypoint3, Waypoint), !.
delta(21, communicate_soil_data(_, _, _, _, _), -0.0038565965233037895) :- !.
delta(21, communicate_rock_data(Rover, _, _, Waypoint, Waypoint2), 0.0035640758940882256) :- todo_communicated_soil_data(Waypoint2), todo_communicated_soil_data(Waypoint3), toward_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Waypoint3, Waypoint), !.
delta(21, communicate_rock_data(Rover, _, _, _, Waypoint), 0.00048122768969720764) :- todo_communicated_soil_data(Waypoint), todo_communicated_rock_data(Waypoint2), could_sample_soil(Rover, Waypoint2), !.
delta(21, communicate_rock_data(_, _, _, _, Waypoint), -0.02504310152176404) :- todo_communicated_soil_data(Waypoint), !.
delta(21, communicate_rock_data(_, _, Waypoint, _, _), 0.030165210469789785) :- todo_communicated_rock_data(Waypoint), !.
delta(21, communicate_rock_data(_, _, _, _, _), -0.003010970840430144) :- !.
delta(21, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), -0.013936991464493355) :- todo_communicated_image_data(Objective2, Is_mode), visible_from(Objective2, Waypoint2), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), visible_from(Objective, Waypoint), !.
delta(21, communicate_image_data(Rover, _, _, Is_mode, Waypoint, Waypoint2), 0.00026577591786980094) :- todo_communicated_image_data(Objective, Is_mode), visible_from(Objective, Waypoint2), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(21, communicate_image_data(_, _, Objective, Is_mode, _, Waypoint), 0.07834609984595182) :- todo_communicated_image_data(Objective2, Is_mode), visible_from(Objective2, Waypoint), todo_communicated_image_data(Objective, _), !.
delta(21, communicate_image_data(_, _, _, Is_mode, _, Waypoint), -0.0008961091057962769) :- todo_communicated_image_data(Objective, Is_mode), visible_from(Objective, Waypoint), !.
delta(21, communicate_image_data(Rover, _, _, Is_mode, Waypoint, Waypoint2), 0.04120547333028109) :- toward_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint2, Waypoint), todo_communicated_image_data(_, Is_mode), !.
delta(21, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), -0.0015431674257031067) :- toward_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint2, Waypoint), !.
delta(21, communicate_image_data(_, _, _, Is_mode, _, _), 0.0008659935328522413) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(Objective, _), !.
delta(21, communicate_image_data(_, _, _, _, _, _), -0.1599473419919303) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 234 examples, 43 leaves
delta(22, navigate(Rover, _, Waypoint), -0.004922708854747076) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), have_rock_analysis(Rover, _), toward_could_calibrate(Rover, Waypoint, Waypoint2), !.
delta(22, navigate(Rover, _, Waypoint), 0.6016283032707386) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), have_rock_analysis(Rover, _), !.
delta(22, navigate(Rover, Waypoint, Waypoint2), 0.040871450493436795) :- todo_communicated_rock_data(Waypoint3), can_traverse(Rover, Waypoint2, Waypoint3), todo_communicated_soil_data(Waypoint), !.
delta(22, navigate(Rover, _, Waypoint), -0.05032600964138052) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(22, navigate(Rover, Waypoint, Waypoint2), -0.062028153098306595) :- at_soil_sample(Waypoint2), todo_communicated_soil_data(Waypoint3), toward_could_sample_rock(Rover, Waypoint, Waypoint3), !.
delta(22, navigate(_, _, Waypoint), 0.2071248804124285) :- at_soil_sample(Waypoint), !.
delta(22, navigate(Rover, _, Waypoint), 0.06841866000265932) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), !.
delta(22, navigate(_, _, _), -0.2462000689399909) :- !.
delta(22, sample_soil(_, _, Waypoint), 0.0407896623335439) :- todo_communicated_soil_data(Waypoint), !.
delta(22, sample_soil(_, _, _), -0.46789973628243436) :- !.
delta(22, sample_rock(_, _, Waypoint), 0.1309786125239907) :- todo_communicated_rock_data(Waypoint), !.
delta(22, sample_rock(_, _, _), -0.005033422983851255) :- !.
delta(22, drop(Rover, _), 0.03521944998545279) :- todo_communicated_soil_data(Waypoint), needed_at_to_sample_soil_to_communicate_soil_data(Rover, Waypoint), have_soil_analysis(Rover, _), !.
delta(22, drop(Rover, _), -0.011013352162721915) :- todo_communicated_soil_data(Waypoint), needed_at_to_sample_soil_to_communicate_soil_data(Rover, Waypoint), !.
delta(22, drop(Rover, _), 0.02720070800594164) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), todo_communicated_rock_data(Waypoint2), at(Rover, Waypoint2), !.
delta(22, drop(_, _), -0.014107433685207536) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(22, drop(_, _), -0.19707802908906616) :- !.
delta(22, calibrate(Rover, Camera, _, _), 0.005038082526981892) :- equipped_for_soil_analysis(Rover), communicated_rock_data(_), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(22, calibrate(Rover, _, _, _), -0.0024669609564385688) :- equipped_for_soil_analysis(Rover), communicated_rock_data(_), !.
delta(22, calibrate(Rover, _, _, _), 0.0013768489303767595) :- equipped_for_soil_analysis(Rover), todo_communicated_rock_data(Waypoint), needed_at_to_communicate_image_data(Waypoint), !.
delta(22, calibrate(Rover, _, _, _), -0.16850837020027315) :- equipped_for_soil_analysis(Rover), !.
delta(22, calibrate(Rover, Camera, _, _), 0.09065208815464107) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(22, calibrate(_, _, _, _), -0.009174050672685244) :- !.
delta(22, take_image(Rover, _, _, _, Is_mode), -0.03389196949790979) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), !.
delta(22, take_image(Rover, _, Objective, _, Is_mode), -0.005327629236603337) :- have_image(Rover, Objective, Is_mode), !.
delta(22, take_image(Rover, Waypoint, _, _, _), 0.10191023861599142) :- could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), !.
delta(22, take_image(_, _, _, _, _), -0.0010130775805446113) :- !.
delta(22, communicate_soil_data(Rover, _, Waypoint, Waypoint2, _), -0.006734891566761241) :- todo_communicated_rock_data(Waypoint3), can_traverse(Rover, Waypoint2, Waypoint3), communicated_soil_data(Waypoint), !.
delta(22, communicate_soil_data(Rover, _, _, Waypoint, _), 0.11658437539375126) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(22, communicate_soil_data(_, _, _, Waypoint, _), 0.012914693017317567) :- communicated_rock_data(Waypoint), !.
delta(22, communicate_soil_data(_, _, Waypoint, Waypoint2, _), -0.08819568308855143) :- visible(Waypoint, Waypoint2), !.
delta(22, communicate_soil_data(_, _, _, _, _), 0.0019647476448965417) :- !.
delta(22, communicate_rock_data(_, _, Waypoint, _, _), 0.04445934873853899) :- todo_communicated_rock_data(Waypoint), !.
delta(22, communicate_rock_data(_, _, _, _, _), -0.06938865677701857) :- !.
delta(22, communicate_image_data(_, _, Objective, Is_mode, Waypoint, _), 0.008262621549500103) :- visible_from(Objective, Waypoint), todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), todo_communicated_image_data(Objective, Is_mode), !.
delta(22, communicate_image_data(_, _, Objective, Is_mode, Waypoint, _), -0.0018139931777043337) :- visible_from(Objective, Waypoint), todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), !.
delta(22, communicate_image_data(Rover, _, Objective, _, Waypoint, Waypoint2), 0.000445858843926272) :- visible_from(Objective, Waypoint), toward_could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(22, communicate_image_data(_, _, Objective, _, Waypoint, _), -0.08827252436366083) :- visible_from(Objective, Waypoint), !.
delta(22, communicate_image_data(Rover, _, Objective, _, Waypoint, _), 0.001650006594857025) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), !.
delta(22, communicate_image_data(_, _, Objective, _, _, _), -0.01585123600084398) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(22, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.07143620698178377) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(22, communicate_image_data(_, _, _, _, _, _), -0.00455437348447539) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 215 examples, 36 leaves
delta(23, navigate(Rover, Waypoint, Waypoint2), 0.03771220984853355) :- toward_could_sample_rock(Rover, Waypoint2, Waypoint), todo_communicated_soil_data(Waypoint3), toward_could_sample_soil(Rover, Waypoint2, Waypoint3), !.
delta(23, navigate(Rover, Waypoint, Waypoint2), 0.0027904090315043176) :- toward_could_sample_rock(Rover, Waypoint2, Waypoint), could_communicate_rock_data(Rover, Waypoint2), !.
delta(23, navigate(Rover, Waypoint, Waypoint2), -0.19520230990296492) :- toward_could_sample_rock(Rover, Waypoint2, Waypoint), !.
delta(23, navigate(Rover, Waypoint, Waypoint2), -0.0458261563863467) :- toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint2, Waypoint), !.
delta(23, navigate(Rover, Waypoint, Waypoint2), -0.03614945028528928) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint3, Waypoint2, Waypoint), !.
delta(23, navigate(_, _, _), 0.5660312893431659) :- !.
delta(23, sample_soil(_, _, Waypoint), 0.010793184387542757) :- todo_communicated_soil_data(Waypoint), !.
delta(23, sample_soil(_, _, _), -0.02951290656852134) :- !.
delta(23, sample_rock(_, _, Waypoint), 0.11705209378985774) :- todo_communicated_rock_data(Waypoint), !.
delta(23, sample_rock(_, _, _), -0.01495739232886665) :- !.
delta(23, drop(_, _), 0.08117506910157658) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(23, drop(_, _), 0.012128954124496443) :- todo_communicated_soil_data(Waypoint), unsettled_visible_todo_communicated_rock_data(Waypoint), !.
delta(23, drop(_, _), 0.0008599427873490368) :- fewer_have_soil_analysis_1_than_have_soil_analysis_2, !.
delta(23, drop(_, _), -0.5103821369968703) :- !.
delta(23, calibrate(Rover, _, _, Waypoint), 0.00037868837839208987) :- could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), could_sample_soil(Rover, Waypoint), fewer_have_image_1_than_have_image_3, !.
delta(23, calibrate(Rover, _, _, Waypoint), -0.014295953855806004) :- could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), could_sample_soil(Rover, Waypoint), !.
delta(23, calibrate(Rover, Camera, _, Waypoint), 0.0632610647885055) :- could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(23, calibrate(Rover, _, _, Waypoint), -0.005031354042689571) :- could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), !.
delta(23, calibrate(_, _, _, _), -0.14140353940229747) :- !.
delta(23, take_image(_, _, Objective, _, Is_mode), 0.014132524471935118) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(23, take_image(Rover, _, Objective, _, _), -0.001109816355479653) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), have_image(Rover, Objective, Is_mode), !.
delta(23, take_image(_, _, Objective, _, _), 0.005104897175335506) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(23, take_image(_, _, _, _, _), -0.025847325179453737) :- !.
delta(23, communicate_soil_data(Rover, _, _, Waypoint, _), 0.041398360381064314) :- todo_communicated_rock_data(Waypoint2), toward_could_communicate_soil_data(Rover, Waypoint2, Waypoint), !.
delta(23, communicate_soil_data(_, _, _, Waypoint, _), 0.006088732314656772) :- communicated_rock_data(Waypoint), !.
delta(23, communicate_soil_data(_, _, _, _, _), -5.983371652305235e-5) :- todo_communicated_soil_data(Waypoint), have_rock_analysis(_, Waypoint), !.
delta(23, communicate_soil_data(_, _, _, _, _), -0.16162512731283762) :- !.
delta(23, communicate_rock_data(_, _, Waypoint, _, _), 0.03130718632310714) :- todo_communicated_rock_data(Waypoint), !.
delta(23, communicate_rock_data(_, _, _, _, _), -0.04030098099943395) :- !.
delta(23, communicate_image_data(Rover, _, Objective, _, Waypoint, Waypoint2), 0.01818220479437963) :- todo_communicated_rock_data(Waypoint3), toward_could_sample_rock(Rover, Waypoint, Waypoint3), visible_from(Objective, Waypoint2), !.
delta(23, communicate_image_data(Rover, _, _, _, Waypoint, _), -0.00011897702891735332) :- todo_communicated_rock_data(Waypoint2), toward_could_sample_rock(Rover, Waypoint, Waypoint2), !.
delta(23, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), 0.006729987588109346) :- could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(23, communicate_image_data(Rover, _, _, _, Waypoint, _), -0.0016601340589082907) :- could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), !.
delta(23, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), 0.0045988079936841115) :- toward_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint, Waypoint2), !.
delta(23, communicate_image_data(_, _, _, _, _, _), -0.128649336950451) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 232 examples, 39 leaves
delta(24, navigate(Rover, Waypoint, Waypoint2), -0.03873844027353122) :- toward_could_sample_rock(Rover, Waypoint, Waypoint2), fewer_have_image_1_than_todo_communicated_image_data_1, toward_could_sample_soil(Rover, Waypoint, Waypoint2), !.
delta(24, navigate(Rover, Waypoint, Waypoint2), 0.006880545200414656) :- toward_could_sample_rock(Rover, Waypoint, Waypoint2), fewer_have_image_1_than_todo_communicated_image_data_1, !.
delta(24, navigate(Rover, Waypoint, Waypoint2), -0.022600850037234756) :- toward_could_sample_rock(Rover, Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint3), have_rock_analysis(_, Waypoint3), !.
delta(24, navigate(Rover, Waypoint, Waypoint2), 0.37472451888483765) :- toward_could_sample_rock(Rover, Waypoint, Waypoint2), !.
delta(24, navigate(Rover, Waypoint, _), 0.13542699268532232) :- todo_communicated_rock_data(Waypoint2), toward_could_sample_rock(Rover, Waypoint2, Waypoint), !.
delta(24, navigate(_, Waypoint, _), -0.39432506404904366) :- unsettled_visible(Waypoint), !.
delta(24, navigate(_, _, _), 0.02157860951672433) :- !.
delta(24, sample_soil(Rover, _, Waypoint), -0.12164402012637268) :- todo_communicated_rock_data(Waypoint2), toward_could_sample_rock(Rover, Waypoint2, Waypoint), !.
delta(24, sample_soil(_, _, _), -0.008092917360236446) :- fewer_have_image_1_than_todo_communicated_image_data_2, !.
delta(24, sample_soil(Rover, _, Waypoint), -0.0038586328158769475) :- could_calibrate(Rover, Waypoint), !.
delta(24, sample_soil(_, _, _), 0.12971628047781247) :- !.
delta(24, sample_rock(Rover, _, Waypoint), 0.040548741051178464) :- have_soil_analysis(Rover, _), todo_communicated_rock_data(Waypoint), !.
delta(24, sample_rock(Rover, _, _), -0.004996354232735317) :- have_soil_analysis(Rover, _), !.
delta(24, sample_rock(Rover, _, _), 0.0037715497685307598) :- calibrated(_, Rover), !.
delta(24, sample_rock(_, _, _), 0.00022852468621806563) :- fewer_at_1_than_todo_communicated_image_data_1, !.
delta(24, sample_rock(_, _, _), -0.06294721365414792) :- !.
delta(24, drop(_, _), -0.1575458974949459) :- todo_communicated_soil_data(Waypoint), have_rock_analysis(_, Waypoint), !.
delta(24, drop(_, _), -0.020384333071099627) :- fewer_at_1_than_have_soil_analysis_2, !.
delta(24, drop(_, _), 0.22525758985148983) :- at_rock_sample(_), !.
delta(24, drop(_, _), -0.017487699249372247) :- !.
delta(24, calibrate(Rover, Camera, _, _), -0.004814066276595892) :- at_soil_sample(_), calibrated(Camera, Rover), !.
delta(24, calibrate(Rover, _, _, _), -0.0029348865469158887) :- at_soil_sample(Waypoint), todo_communicated_soil_data(Waypoint2), toward_could_calibrate(Rover, Waypoint2, Waypoint), !.
delta(24, calibrate(_, _, _, _), 0.06664941815810524) :- at_soil_sample(_), !.
delta(24, calibrate(Rover, Camera, _, Waypoint), 0.0027464290797152235) :- could_communicate_soil_data(Rover, Waypoint), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(24, calibrate(Rover, _, _, Waypoint), -0.0003235617872651211) :- could_communicate_soil_data(Rover, Waypoint), !.
delta(24, calibrate(Rover, _, _, Waypoint), 0.00017183593160870198) :- could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), !.
delta(24, calibrate(_, _, _, _), -0.04779041221928078) :- !.
delta(24, take_image(_, _, Objective, Camera, _), -0.017481117217164353) :- fewer_have_image_1_than_todo_communicated_image_data_2_have_image_3, calibration_target(Camera, Objective), !.
delta(24, take_image(_, _, _, _, _), 0.00016109567230767566) :- fewer_have_image_1_than_todo_communicated_image_data_2_have_image_3, !.
delta(24, take_image(Rover, Waypoint, _, _, Is_mode), -0.0008876617709325551) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), !.
delta(24, take_image(_, _, _, _, Is_mode), 0.015694175926294407) :- todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(24, take_image(_, _, _, _, _), -0.005832347134910961) :- !.
delta(24, communicate_soil_data(_, _, Waypoint, _, _), 0.05319979625961883) :- todo_communicated_soil_data(Waypoint), !.
delta(24, communicate_soil_data(_, _, _, _, _), -0.029254676762931076) :- !.
delta(24, communicate_rock_data(_, _, Waypoint, _, _), 0.0560935531440528) :- todo_communicated_rock_data(Waypoint), !.
delta(24, communicate_rock_data(_, _, _, _, _), -0.04202013424232628) :- !.
delta(24, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.017737730990321516) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(24, communicate_image_data(_, _, _, _, _, _), -0.03352715109335626) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 221 examples, 42 leaves
delta(25, navigate(Rover, Waypoint, Waypoint2), 0.017496581310665733) :- have_rock_analysis(Rover, Waypoint), communicated_rock_data(Waypoint), toward_could_communicate_rock_data(Rover, Waypoint, Waypoint2), !.
delta(25, navigate(Rover, Waypoint, _), -0.05448554489232806) :- have_rock_analysis(Rover, Waypoint), communicated_rock_data(Waypoint), !.
delta(25, navigate(Rover, Waypoint, Waypoint2), -0.010768837957540989) :- have_rock_analysis(Rover, Waypoint), communicated_soil_data(Waypoint2), !.
delta(25, navigate(Rover, Waypoint, _), 1.108237263150429) :- have_rock_analysis(Rover, Waypoint), !.
delta(25, navigate(Rover, Waypoint, Waypoint2), -0.0013298546057820832) :- toward_could_sample_soil(Rover, Waypoint2, Waypoint), toward_could_calibrate(Rover, Waypoint2, Waypoint), !.
delta(25, navigate(Rover, Waypoint, Waypoint2), 0.2611801490488565) :- toward_could_sample_soil(Rover, Waypoint2, Waypoint), !.
delta(25, navigate(_, _, Waypoint), 0.13554906483092513) :- todo_communicated_soil_data(Waypoint), !.
delta(25, navigate(_, _, _), -0.3487406162798159) :- !.
delta(25, sample_soil(_, _, Waypoint), 0.01764113779779289) :- todo_communicated_soil_data(Waypoint), !.
delta(25, sample_soil(_, _, _), -0.03880246506105469) :- !.
delta(25, sample_rock(Rover, _, Waypoint), 0.2150145010847299) :- could_sample_soil(Rover, Waypoint), todo_communicated_rock_data(Waypoint), !.
delta(25, sample_rock(Rover, _, Waypoint), -0.010928120334579796) :- could_sample_soil(Rover, Waypoint), !.
delta(25, sample_rock(_, _, _), 0.0026545782823883045) :- at_soil_sample(_), fewer_have_image_1_than_have_image_3, !.
delta(25, sample_rock(_, _, _), -0.7482701961519048) :- at_soil_sample(_), !.
delta(25, sample_rock(_, _, Waypoint), 0.019269447576598705) :- todo_communicated_rock_data(Waypoint), !.
delta(25, sample_rock(_, _, _), -0.0008501834343229194) :- !.
delta(25, drop(Rover, _), 0.03193852188260237) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), todo_communicated_rock_data(Waypoint2), at(Rover, Waypoint2), !.
delta(25, drop(_, _), -0.005561051688574276) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(25, drop(_, _), 0.0049459362137210154) :- fewer_at_1_than_have_rock_analysis_2, todo_communicated_soil_data(_), !.
delta(25, drop(_, _), -0.0009541186896924902) :- fewer_at_1_than_have_rock_analysis_2, !.
delta(25, drop(_, _), -0.6510822069288285) :- !.
delta(25, calibrate(Rover, Camera, _, _), 0.0675195811732923) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(25, calibrate(_, _, _, Waypoint), 0.008155479194701267) :- todo_communicated_soil_data(Waypoint), !.
delta(25, calibrate(_, _, _, _), -0.08335198334721564) :- !.
delta(25, take_image(Rover, Waypoint, Objective, _, Is_mode), 0.00015858706433925454) :- could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(25, take_image(Rover, Waypoint, _, _, _), -0.010669901579453278) :- could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), !.
delta(25, take_image(Rover, _, _, _, Is_mode), 0.0014393938439347244) :- have_soil_analysis(Rover, _), todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(25, take_image(Rover, _, _, _, _), -0.004241286017770913) :- have_soil_analysis(Rover, _), !.
delta(25, take_image(_, _, _, _, _), -0.0006610202093452721) :- at_rock_sample(_), !.
delta(25, take_image(_, _, _, _, _), 0.08613536138903959) :- !.
delta(25, communicate_soil_data(_, _, Waypoint, _, _), 0.04281610005277906) :- todo_communicated_soil_data(Waypoint), !.
delta(25, communicate_soil_data(_, _, _, _, _), -0.06723650018595545) :- !.
delta(25, communicate_rock_data(_, _, _, _, _), -0.03340047216857964) :- fewer_have_soil_analysis_1_than_todo_communicated_soil_data, !.
delta(25, communicate_rock_data(_, _, Waypoint, _, _), -0.019117845127489298) :- communicated_rock_data(Waypoint), !.
delta(25, communicate_rock_data(Rover, _, _, Waypoint, _), -0.0031371185121935184) :- todo_communicated_soil_data(Waypoint2), toward_could_sample_soil(Rover, Waypoint, Waypoint2), !.
delta(25, communicate_rock_data(_, _, _, _, _), 0.12445645175895874) :- !.
delta(25, communicate_image_data(_, _, Objective, Is_mode, _, _), -0.0181361720811631) :- communicated_image_data(Objective, Is_mode), !.
delta(25, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), 0.004297353783321073) :- could_take_image(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(25, communicate_image_data(Rover, _, _, _, Waypoint, _), -0.019849347547852513) :- could_take_image(Rover, Waypoint), !.
delta(25, communicate_image_data(_, _, Objective, _, _, _), 0.10112417564398762) :- goal_communicated_image_data(Objective, _), !.
delta(25, communicate_image_data(_, _, _, _, _, _), -0.008234768775664786) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 223 examples, 39 leaves
delta(26, navigate(Rover, Waypoint, Waypoint2), 0.1519827939373935) :- todo_communicated_rock_data(Waypoint3), visible(Waypoint, Waypoint3), needed_at_to_sample_rock_to_communicate_rock_data(Rover, Waypoint2), todo_communicated_rock_data(Waypoint4), could_sample_rock(Rover, Waypoint4), !.
delta(26, navigate(Rover, Waypoint, Waypoint2), -0.009663693807026431) :- todo_communicated_rock_data(Waypoint3), visible(Waypoint, Waypoint3), needed_at_to_sample_rock_to_communicate_rock_data(Rover, Waypoint2), !.
delta(26, navigate(Rover, Waypoint, Waypoint2), 0.06691130522896567) :- todo_communicated_rock_data(Waypoint3), visible(Waypoint, Waypoint3), todo_communicated_rock_data(Waypoint4), nearer_at(Rover, Waypoint2, Waypoint3, Waypoint4), !.
delta(26, navigate(_, Waypoint, _), -0.3730076583142533) :- todo_communicated_rock_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(26, navigate(Rover, Waypoint, Waypoint2), 0.03956238554184006) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), todo_communicated_soil_data(Waypoint4), have_soil_analysis(Rover, Waypoint4), !.
delta(26, navigate(Rover, Waypoint, Waypoint2), -0.10938106112056731) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(26, navigate(Rover, Waypoint, Waypoint2), -0.019892682705646304) :- toward_could_calibrate(Rover, Waypoint2, Waypoint), !.
delta(26, navigate(_, _, _), 0.18119908855733788) :- !.
delta(26, sample_soil(Rover, _, _), -0.0014772118492799222) :- have_rock_analysis(Rover, _), todo_communicated_rock_data(Waypoint), could_communicate_rock_data(Rover, Waypoint), !.
delta(26, sample_soil(Rover, _, _), 0.3970267431819369) :- have_rock_analysis(Rover, _), !.
delta(26, sample_soil(Rover, _, _), 0.000337910741450825) :- have_soil_analysis(Rover, _), !.
delta(26, sample_soil(_, _, _), -0.06940300978138854) :- !.
delta(26, sample_rock(Rover, _, Waypoint), -0.488816021279506) :- could_calibrate(Rover, Waypoint), !.
delta(26, sample_rock(_, _, Waypoint), 0.1530379398751804) :- todo_communicated_rock_data(Waypoint), !.
delta(26, sample_rock(_, _, _), -0.009846235265840796) :- !.
delta(26, drop(Rover, _), -0.031892448433473164) :- todo_communicated_rock_data(Waypoint), could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint), !.
delta(26, drop(_, _), 0.00907659701255304) :- fewer_at_2_than_have_soil_analysis_2, todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(26, drop(_, _), -0.03442692931526114) :- fewer_at_2_than_have_soil_analysis_2, !.
delta(26, drop(_, _), 0.3640795540461304) :- at_rock_sample(_), !.
delta(26, drop(_, _), -0.011599364622012056) :- !.
delta(26, calibrate(Rover, Camera, _, _), 0.054051038280156026) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(26, calibrate(_, _, _, _), -0.14611688233765202) :- !.
delta(26, take_image(_, _, Objective, Camera, Is_mode), 0.019638608600306515) :- todo_communicated_image_data(Objective2, Is_mode), calibration_target(Camera, Objective2), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(26, take_image(_, _, _, Camera, Is_mode), -0.0030347805741186176) :- todo_communicated_image_data(Objective, Is_mode), calibration_target(Camera, Objective), !.
delta(26, take_image(Rover, Waypoint, Objective, _, Is_mode), 0.0008154405012617755) :- could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(26, take_image(Rover, Waypoint, _, _, _), -0.0001651805549216083) :- could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint), !.
delta(26, take_image(_, _, Objective, _, _), 0.00016360073896845128) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(26, take_image(_, _, _, _, _), -0.05972614211463995) :- !.
delta(26, communicate_soil_data(_, _, Waypoint, _, _), 0.00663392926133757) :- todo_communicated_soil_data(Waypoint), !.
delta(26, communicate_soil_data(_, _, _, _, _), -0.04160193892341068) :- !.
delta(26, communicate_rock_data(Rover, _, Waypoint, _, _), -0.012664484033651424) :- todo_communicated_rock_data(Waypoint), todo_communicated_soil_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(26, communicate_rock_data(_, _, Waypoint, _, _), 0.06820940446950433) :- todo_communicated_rock_data(Waypoint), !.
delta(26, communicate_rock_data(_, _, _, _, _), -0.06472331852236388) :- !.
delta(26, communicate_image_data(Rover, _, _, _, Waypoint, _), 0.036184687710747974) :- todo_communicated_soil_data(Waypoint2), toward_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Waypoint2, Waypoint), !.
delta(26, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.01105166997131469) :- todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), todo_communicated_image_data(Objective, Is_mode), !.
delta(26, communicate_image_data(_, _, _, Is_mode, _, _), -0.003953594094606896) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(Objective, _), !.
delta(26, communicate_image_data(_, _, Objective, _, _, _), 0.003185327263222086) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(26, communicate_image_data(_, _, _, _, _, _), -0.08221353628296939) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 209 examples, 37 leaves
delta(27, navigate(Rover, _, _), -0.03004561236251568) :- todo_communicated_rock_data(Waypoint), have_soil_analysis(Rover, Waypoint), empty(_), !.
delta(27, navigate(Rover, _, _), 0.4551907799980841) :- todo_communicated_rock_data(Waypoint), have_soil_analysis(Rover, Waypoint), !.
delta(27, navigate(Rover, Waypoint, Waypoint2), -6.771231274610166e-5) :- toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint3), can_traverse(Rover, Waypoint, Waypoint3), !.
delta(27, navigate(Rover, Waypoint, Waypoint2), 0.22666322948261855) :- toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(27, navigate(_, _, _), 0.05292332273076444) :- communicated_soil_data(_), !.
delta(27, navigate(_, _, _), -0.3814484512150465) :- !.
delta(27, sample_soil(_, _, Waypoint), -0.06042173924580636) :- needed_have_rock_analysis_to_communicate_rock_data(Waypoint), !.
delta(27, sample_soil(_, _, _), -0.008180228898405367) :- fewer_have_image_1_than_todo_communicated_image_data_2, !.
delta(27, sample_soil(Rover, _, _), -0.0020503808213733366) :- have_soil_analysis(Rover, _), !.
delta(27, sample_soil(_, _, _), 0.3164467990241894) :- !.
delta(27, sample_rock(Rover, _, Waypoint), 0.07669615693945542) :- could_sample_soil(Rover, Waypoint), todo_communicated_rock_data(Waypoint), !.
delta(27, sample_rock(Rover, _, Waypoint), -0.0018944187810064307) :- could_sample_soil(Rover, Waypoint), !.
delta(27, sample_rock(Rover, _, _), 0.03422227285488164) :- todo_communicated_rock_data(Waypoint), could_take_image(Rover, Waypoint), !.
delta(27, sample_rock(Rover, _, _), 0.007561019793379597) :- have_soil_analysis(Rover, _), !.
delta(27, sample_rock(_, _, _), -0.20100585311867633) :- !.
delta(27, drop(Rover, _), 0.006716032910380735) :- todo_communicated_rock_data(Waypoint), have_rock_analysis(Rover, Waypoint), todo_communicated_soil_data(Waypoint2), at_soil_sample(Waypoint2), !.
delta(27, drop(Rover, _), -0.3368467930673007) :- todo_communicated_rock_data(Waypoint), have_rock_analysis(Rover, Waypoint), !.
delta(27, drop(Rover, _), -0.001813341293911406) :- at_rock_sample(Waypoint), could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint), !.
delta(27, drop(_, _), 0.0678089165205946) :- at_rock_sample(_), !.
delta(27, drop(_, _), -0.003031906065284754) :- !.
delta(27, calibrate(Rover, Camera, _, _), 0.0746992098962227) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(27, calibrate(Rover, _, _, Waypoint), 0.018742180396687992) :- could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Waypoint), !.
delta(27, calibrate(_, _, _, _), -0.10524025257513343) :- !.
delta(27, take_image(_, _, Objective, _, Is_mode), 0.009264052766974869) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(27, take_image(_, _, _, _, _), -0.024419659546988503) :- !.
delta(27, communicate_soil_data(_, _, Waypoint, _, _), 0.008815823379829252) :- todo_communicated_soil_data(Waypoint), !.
delta(27, communicate_soil_data(_, _, _, _, _), -0.08055255981664115) :- !.
delta(27, communicate_rock_data(_, _, Waypoint, _, _), -0.02804698486673246) :- communicated_rock_data(Waypoint), !.
delta(27, communicate_rock_data(_, Lander, Waypoint, _, _), -0.003734503226378486) :- at_lander(Lander, Waypoint), !.
delta(27, communicate_rock_data(_, _, _, _, _), 0.09778647429911422) :- !.
delta(27, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.014179713942495129) :- todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), todo_communicated_image_data(Objective, Is_mode), !.
delta(27, communicate_image_data(_, _, _, Is_mode, _, _), -0.0014922476361206327) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(Objective, _), !.
delta(27, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), 0.00329320779544768) :- could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(27, communicate_image_data(Rover, _, _, _, Waypoint, _), -0.0009842530174579995) :- could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), !.
delta(27, communicate_image_data(_, _, Objective, _, _, _), 0.0014786560467819343) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(27, communicate_image_data(_, _, _, _, _, _), -0.04265580131019723) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 216 examples, 38 leaves
delta(28, navigate(Rover, Waypoint, Waypoint2), -0.0043414882199273395) :- todo_communicated_rock_data(Waypoint3), visible(Waypoint2, Waypoint3), toward_could_calibrate(Rover, Waypoint, Waypoint2), fewer_at_1_than_todo_communicated_image_data_1, !.
delta(28, navigate(Rover, Waypoint, Waypoint2), 0.08530248382150281) :- todo_communicated_rock_data(Waypoint3), visible(Waypoint2, Waypoint3), toward_could_calibrate(Rover, Waypoint, Waypoint2), !.
delta(28, navigate(Rover, Waypoint, Waypoint2), 0.017162345199714907) :- todo_communicated_rock_data(Waypoint3), visible(Waypoint2, Waypoint3), toward_could_sample_rock(Rover, Waypoint3, Waypoint), !.
delta(28, navigate(_, _, Waypoint), -0.2571122810440153) :- todo_communicated_rock_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(28, navigate(_, Waypoint, _), -0.07535243114142563) :- needed_have_soil_analysis_to_communicate_soil_data(Waypoint), !.
delta(28, navigate(Rover, Waypoint, Waypoint2), -0.016773652246494464) :- toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(28, navigate(_, _, _), 0.19889155009256204) :- !.
delta(28, sample_soil(Rover, _, Waypoint), 0.0024353137508322633) :- equipped_for_imaging(Rover), todo_communicated_soil_data(Waypoint), !.
delta(28, sample_soil(Rover, _, _), -0.07993896381840594) :- equipped_for_imaging(Rover), !.
delta(28, sample_soil(_, _, _), 0.22766459089664715) :- !.
delta(28, sample_rock(_, _, Waypoint), 0.006617106279982085) :- todo_communicated_rock_data(Waypoint2), visible(Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint), !.
delta(28, sample_rock(_, _, Waypoint), -0.003923563031073988) :- todo_communicated_rock_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(28, sample_rock(Rover, _, _), 0.0010298420800969094) :- todo_communicated_soil_data(Waypoint), could_sample_soil(Rover, Waypoint), !.
delta(28, sample_rock(Rover, _, _), 0.0010937776170579694) :- todo_communicated_rock_data(Waypoint), could_communicate_soil_data(Rover, Waypoint), !.
delta(28, sample_rock(_, _, _), -0.14383643825753226) :- !.
delta(28, drop(_, _), 0.0003261950625973451) :- fewer_have_image_1_than_have_image_3, todo_communicated_rock_data(Waypoint), needed_at_to_communicate_image_data(Waypoint), !.
delta(28, drop(_, _), -0.032129551335383345) :- fewer_have_image_1_than_have_image_3, !.
delta(28, drop(Rover, _), -0.007917895034727144) :- todo_communicated_rock_data(Waypoint), have_rock_analysis(Rover, Waypoint), !.
delta(28, drop(Rover, _), -0.004162749281734442) :- todo_communicated_soil_data(Waypoint), have_soil_analysis(Rover, Waypoint), !.
delta(28, drop(_, _), 0.0539365659687015) :- !.
delta(28, calibrate(Rover, Camera, _, _), 8.996045856963055e-5) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), todo_communicated_rock_data(Waypoint), have_rock_analysis(_, Waypoint), !.
delta(28, calibrate(Rover, Camera, _, _), 0.04548303137049129) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(28, calibrate(_, _, _, _), -0.04516309590781206) :- !.
delta(28, take_image(Rover, _, Objective, _, Is_mode), 0.0) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), todo_communicated_soil_data(Waypoint), needed_at_to_sample_soil_to_communicate_soil_data(Rover, Waypoint), !.
delta(28, take_image(_, _, Objective, _, Is_mode), 0.006285850533379701) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(28, take_image(_, _, _, _, _), -0.024878867791799805) :- !.
delta(28, communicate_soil_data(_, _, _, Waypoint, _), 0.014596635697897788) :- at_soil_sample(Waypoint), !.
delta(28, communicate_soil_data(_, _, Waypoint, _, _), 0.003317461097709452) :- todo_communicated_soil_data(Waypoint), !.
delta(28, communicate_soil_data(_, _, _, _, _), -0.016496899470763986) :- !.
delta(28, communicate_rock_data(_, _, Waypoint, _, _), 0.07918356603187268) :- todo_communicated_rock_data(Waypoint), !.
delta(28, communicate_rock_data(_, _, _, _, _), -0.013798426350900965) :- !.
delta(28, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.00833741870434461) :- communicated_rock_data(_), todo_communicated_image_data(Objective, Is_mode), !.
delta(28, communicate_image_data(_, _, _, _, _, _), -0.002209764859385877) :- communicated_rock_data(_), !.
delta(28, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.004869255485143908) :- todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), todo_communicated_image_data(Objective, Is_mode), !.
delta(28, communicate_image_data(_, _, _, Is_mode, _, _), -0.001706998295855779) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(Objective, _), !.
delta(28, communicate_image_data(Rover, _, _, _, Waypoint, _), 0.0016802059576418965) :- have_soil_analysis(Rover, Waypoint), !.
delta(28, communicate_image_data(_, _, _, _, _, _), -0.09243602644919031) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 202 examples, 45 leaves
delta(29, navigate(Rover, _, Waypoint), -0.01381940985575493) :- could_communicate_rock_data(Rover, Waypoint), todo_communicated_rock_data(Waypoint2), toward_could_sample_soil(Rover, Waypoint, Waypoint2), !.
delta(29, navigate(Rover, _, Waypoint), -0.004532567239360548) :- could_communicate_rock_data(Rover, Waypoint), at_rock_sample(Waypoint), !.
delta(29, navigate(Rover, _, Waypoint), 0.20567373527898875) :- could_communicate_rock_data(Rover, Waypoint), !.
delta(29, navigate(Rover, Waypoint, Waypoint2), -0.08372537375126389) :- toward_could_calibrate(Rover, Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint3), toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint3, Waypoint2), !.
delta(29, navigate(Rover, Waypoint, Waypoint2), 0.1283380418703208) :- toward_could_calibrate(Rover, Waypoint, Waypoint2), !.
delta(29, navigate(Rover, _, Waypoint), 0.04235715371809286) :- could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Waypoint), !.
delta(29, navigate(_, _, _), -0.21706648367876538) :- !.
delta(29, sample_soil(_, _, Waypoint), 0.014326409349036888) :- todo_communicated_soil_data(Waypoint), !.
delta(29, sample_soil(_, _, _), -0.01982228895653719) :- !.
delta(29, sample_rock(Rover, _, Waypoint), 0.10103876785724818) :- todo_communicated_rock_data(Waypoint), equipped_for_imaging(Rover), !.
delta(29, sample_rock(_, _, Waypoint), 0.002642535065764936) :- todo_communicated_rock_data(Waypoint), todo_communicated_rock_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(29, sample_rock(_, _, Waypoint), -0.00874754368138688) :- todo_communicated_rock_data(Waypoint), !.
delta(29, sample_rock(_, _, _), -0.020513616323693643) :- !.
delta(29, drop(Rover, _), -0.00711537607314333) :- at_soil_sample(_), todo_communicated_rock_data(Waypoint), could_communicate_rock_data(Rover, Waypoint), !.
delta(29, drop(_, _), -0.0011556751432162458) :- at_soil_sample(_), fewer_have_image_1_than_todo_communicated_image_data_2, !.
delta(29, drop(_, _), 0.07650273027134565) :- at_soil_sample(_), !.
delta(29, drop(_, _), 0.001748568749907196) :- todo_communicated_rock_data(Waypoint), at_rock_sample(Waypoint), !.
delta(29, drop(_, _), -0.013036288320923092) :- !.
delta(29, calibrate(Rover, Camera, Objective, _), 0.002636993008091457) :- communicated_image_data(Objective, _), todo_communicated_image_data(Objective, Is_mode), supports(Camera, Is_mode), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(29, calibrate(_, Camera, Objective, _), -0.0017220294159900884) :- communicated_image_data(Objective, _), todo_communicated_image_data(Objective, Is_mode), supports(Camera, Is_mode), !.
delta(29, calibrate(_, _, Objective, _), 0.0007079611660703293) :- communicated_image_data(Objective, _), communicated_rock_data(_), !.
delta(29, calibrate(_, _, Objective, _), -0.025706877171089337) :- communicated_image_data(Objective, _), !.
delta(29, calibrate(Rover, _, _, Waypoint), -0.003776087326934378) :- could_sample_rock(Rover, Waypoint), todo_communicated_rock_data(Waypoint), !.
delta(29, calibrate(Rover, _, _, Waypoint), 0.0009951890896021235) :- could_sample_rock(Rover, Waypoint), !.
delta(29, calibrate(_, _, _, _), 0.053999179993693226) :- empty(_), !.
delta(29, calibrate(_, _, _, _), -0.003789505762043831) :- !.
delta(29, take_image(_, _, Objective, _, Is_mode), 0.0005959684806179721) :- todo_communicated_rock_data(Waypoint), visible_from(Objective, Waypoint), goal_communicated_image_data(Objective, Is_mode), !.
delta(29, take_image(_, _, Objective, _, _), -0.10368217446516825) :- todo_communicated_rock_data(Waypoint), visible_from(Objective, Waypoint), !.
delta(29, take_image(Rover, Waypoint, _, _, Is_mode), -0.0021708334132527186) :- could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), have_image(Rover, _, Is_mode), !.
delta(29, take_image(Rover, Waypoint, _, _, _), 0.07532653382086246) :- could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), !.
delta(29, take_image(_, _, _, _, _), -0.02147381400305296) :- !.
delta(29, communicate_soil_data(_, _, Waypoint, _, _), 0.015256595732981125) :- todo_communicated_soil_data(Waypoint), !.
delta(29, communicate_soil_data(Rover, _, _, Waypoint, _), 0.002151012254971084) :- could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Waypoint), !.
delta(29, communicate_soil_data(_, _, _, _, _), -0.021591181851415904) :- !.
delta(29, communicate_rock_data(_, _, Waypoint, _, Waypoint2), 0.014656825009524664) :- have_soil_analysis(_, Waypoint2), todo_communicated_rock_data(Waypoint), !.
delta(29, communicate_rock_data(_, _, _, _, Waypoint), -0.0008578400322300107) :- have_soil_analysis(_, Waypoint), !.
delta(29, communicate_rock_data(Rover, _, _, _, Waypoint), 0.0016451256471894384) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(29, communicate_rock_data(_, _, _, _, _), -0.07417775986412699) :- !.
delta(29, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.012650828236640446) :- communicated_rock_data(_), todo_communicated_image_data(Objective, Is_mode), !.
delta(29, communicate_image_data(_, _, _, _, _, _), -0.002324126271017272) :- communicated_rock_data(_), !.
delta(29, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), 0.003260770883480337) :- toward_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint, Waypoint2), todo_communicated_image_data(Objective, Is_mode), !.
delta(29, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), -6.955021766528746e-5) :- toward_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint, Waypoint2), !.
delta(29, communicate_image_data(Rover, _, _, _, _, Waypoint), 0.002449347675423483) :- could_sample_rock(Rover, Waypoint), !.
delta(29, communicate_image_data(_, _, _, _, _, _), -0.08140248262961129) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 204 examples, 45 leaves
delta(30, navigate(Rover, Waypoint, Waypoint2), -0.010950960565944504) :- toward_could_communicate_rock_data(Rover, Waypoint, Waypoint2), have_soil_analysis(_, Waypoint), !.
delta(30, navigate(Rover, Waypoint, Waypoint2), 0.0) :- toward_could_communicate_rock_data(Rover, Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint3), toward_could_calibrate(Rover, Waypoint, Waypoint3), !.
delta(30, navigate(Rover, Waypoint, Waypoint2), 0.6760637436291015) :- toward_could_communicate_rock_data(Rover, Waypoint, Waypoint2), !.
delta(30, navigate(Rover, Waypoint, Waypoint2), -0.006538961903591771) :- todo_communicated_soil_data(Waypoint3), toward_could_communicate_image_data(Rover, Waypoint3, Waypoint2), todo_communicated_soil_data(Waypoint4), toward_could_communicate_soil_data(Rover, Waypoint4, Waypoint), !.
delta(30, navigate(Rover, _, Waypoint), 0.08583684865905808) :- todo_communicated_soil_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(30, navigate(Rover, _, Waypoint), 0.06263557522513082) :- needed_at_to_sample_rock_to_communicate_rock_data(Rover, Waypoint), !.
delta(30, navigate(_, _, _), -0.24733378162628447) :- !.
delta(30, sample_soil(Rover, _, _), -0.009437980457897828) :- todo_communicated_rock_data(Waypoint), have_rock_analysis(_, Waypoint), could_communicate_rock_data(Rover, Waypoint), !.
delta(30, sample_soil(Rover, _, Waypoint), -0.002333065571769676) :- todo_communicated_rock_data(Waypoint2), have_rock_analysis(_, Waypoint2), could_take_image(Rover, Waypoint), !.
delta(30, sample_soil(_, _, _), 0.10071835754503056) :- todo_communicated_rock_data(Waypoint), have_rock_analysis(_, Waypoint), !.
delta(30, sample_soil(_, _, Waypoint), 0.002477743083055728) :- todo_communicated_soil_data(Waypoint), !.
delta(30, sample_soil(_, _, _), -0.025015068190583696) :- !.
delta(30, sample_rock(Rover, _, Waypoint), -0.03376781397942443) :- could_calibrate(Rover, Waypoint), !.
delta(30, sample_rock(_, _, Waypoint), 0.10652563591229124) :- todo_communicated_rock_data(Waypoint), !.
delta(30, sample_rock(_, _, _), -0.0036779128175991474) :- !.
delta(30, drop(Rover, _), 0.01674934787785509) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), communicated_rock_data(Waypoint2), at(Rover, Waypoint2), !.
delta(30, drop(_, _), -0.03519451086437358) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), communicated_rock_data(_), !.
delta(30, drop(_, _), 0.09432805456262054) :- todo_communicated_soil_data(Waypoint), at_soil_sample(Waypoint), !.
delta(30, drop(_, _), -0.0027191462677983503) :- fewer_have_soil_analysis_1_than_have_soil_analysis_2, at_soil_sample(_), !.
delta(30, drop(_, _), 0.012720803641742549) :- fewer_have_soil_analysis_1_than_have_soil_analysis_2, !.
delta(30, drop(_, _), 0.0004965616552827456) :- todo_communicated_soil_data(Waypoint), unsettled_visible_todo_communicated_rock_data(Waypoint), !.
delta(30, drop(_, _), -0.8539807165382192) :- !.
delta(30, calibrate(Rover, _, Objective, Waypoint), -2.327613856830167e-5) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), calibrated(_, Rover), !.
delta(30, calibrate(Rover, _, Objective, Waypoint), 0.012393558232096745) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(30, calibrate(Rover, _, _, Waypoint), 0.0021871635383127618) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), fewer_at_1_than_todo_communicated_image_data_1, !.
delta(30, calibrate(Rover, _, _, Waypoint), -0.0759109688922838) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), !.
delta(30, calibrate(Rover, _, _, Waypoint), -0.007244335119466708) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(30, calibrate(_, _, _, _), 0.2438782807494403) :- todo_communicated_rock_data(Waypoint), have_rock_analysis(_, Waypoint), !.
delta(30, calibrate(_, _, _, _), -0.0035153035124793606) :- !.
delta(30, take_image(Rover, Waypoint, Objective, _, Is_mode), 0.007364287905018956) :- could_communicate_soil_data(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(30, take_image(Rover, Waypoint, _, _, _), -0.0023006904339006253) :- could_communicate_soil_data(Rover, Waypoint), !.
delta(30, take_image(_, _, Objective, _, Is_mode), 0.004937074877723303) :- fewer_at_1_than_todo_communicated_image_data_1, needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(30, take_image(_, _, _, _, _), -0.003934789796771405) :- fewer_at_1_than_todo_communicated_image_data_1, !.
delta(30, take_image(Rover, _, _, _, _), 0.0) :- todo_communicated_rock_data(Waypoint), could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint), !.
delta(30, take_image(_, _, _, _, _), -0.07012352841213512) :- !.
delta(30, communicate_soil_data(Rover, _, Waypoint, Waypoint2, _), 0.041581834823859645) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(30, communicate_soil_data(_, _, Waypoint, _, _), 0.0004362573136914672) :- have_rock_analysis(_, Waypoint), !.
delta(30, communicate_soil_data(_, _, _, _, _), -0.017775824208778043) :- !.
delta(30, communicate_rock_data(_, _, Waypoint, _, _), 0.016567681293258984) :- todo_communicated_rock_data(Waypoint), !.
delta(30, communicate_rock_data(_, _, _, _, _), -0.008647911853930951) :- !.
delta(30, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), 0.0002259978239303974) :- todo_communicated_image_data(Objective, Is_mode), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), !.
delta(30, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, _), -0.0036157104560715775) :- todo_communicated_image_data(Objective, Is_mode), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(30, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.017187299602384066) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(30, communicate_image_data(_, _, _, _, _, _), -0.013325745235097674) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 214 examples, 47 leaves
delta(31, navigate(Rover, Waypoint, Waypoint2), -0.01584981186675881) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint, Waypoint2, Waypoint3), todo_communicated_soil_data(Waypoint4), at_rock_sample(Waypoint4), have_soil_analysis(Rover, Waypoint2), !.
delta(31, navigate(Rover, Waypoint, Waypoint2), 0.19422918357434368) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint, Waypoint2, Waypoint3), todo_communicated_soil_data(Waypoint4), at_rock_sample(Waypoint4), !.
delta(31, navigate(Rover, Waypoint, Waypoint2), 0.0031467394377286614) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint, Waypoint2, Waypoint3), fewer_have_image_1_than_todo_communicated_image_data_1, !.
delta(31, navigate(Rover, Waypoint, Waypoint2), -0.030185480783324923) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint, Waypoint2, Waypoint3), !.
delta(31, navigate(_, Waypoint, _), 0.03361305192279388) :- have_rock_analysis(Rover, Waypoint), todo_communicated_rock_data(Waypoint2), could_calibrate(Rover, Waypoint2), !.
delta(31, navigate(_, Waypoint, _), -0.3766800259595716) :- have_rock_analysis(_, Waypoint), !.
delta(31, navigate(Rover, Waypoint, Waypoint2), -0.05768188318184747) :- toward_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Waypoint, Waypoint2), !.
delta(31, navigate(_, _, _), 0.1325157846182999) :- !.
delta(31, sample_soil(Rover, _, Waypoint), -0.02237124823201012) :- todo_communicated_rock_data(Waypoint2), needed_at_to_sample_rock_to_communicate_rock_data(Rover, Waypoint2), todo_communicated_rock_data(Waypoint3), toward_could_sample_rock(Rover, Waypoint, Waypoint3), !.
delta(31, sample_soil(Rover, _, _), 0.1294493098718421) :- todo_communicated_rock_data(Waypoint), needed_at_to_sample_rock_to_communicate_rock_data(Rover, Waypoint), !.
delta(31, sample_soil(_, _, Waypoint), 0.0016575576321016777) :- todo_communicated_soil_data(Waypoint), !.
delta(31, sample_soil(_, _, _), -0.061844049376166374) :- !.
delta(31, sample_rock(_, _, _), 0.186643151779927) :- full(_), !.
delta(31, sample_rock(_, _, _), 0.0034033402503686806) :- fewer_have_image_1_than_have_image_3, !.
delta(31, sample_rock(_, _, _), 4.6869735930049385e-5) :- communicated_soil_data(_), !.
delta(31, sample_rock(_, _, _), -0.023081438339787264) :- !.
delta(31, drop(_, _), -0.002528382781560387) :- fewer_have_rock_analysis_1_than_have_rock_analysis_2, todo_communicated_rock_data(Waypoint), at_soil_sample(Waypoint), !.
delta(31, drop(_, _), 0.03480175236231217) :- fewer_have_rock_analysis_1_than_have_rock_analysis_2, !.
delta(31, drop(Rover, _), -0.00018346024578726718) :- todo_communicated_rock_data(Waypoint), could_take_image(Rover, Waypoint), todo_communicated_rock_data(Waypoint2), at(Rover, Waypoint2), !.
delta(31, drop(Rover, _), 0.0020677674996113587) :- todo_communicated_rock_data(Waypoint), could_take_image(Rover, Waypoint), !.
delta(31, drop(Rover, _), 0.001022291782392914) :- todo_communicated_rock_data(Waypoint), could_communicate_rock_data(Rover, Waypoint), !.
delta(31, drop(_, _), -0.2343973883091066) :- !.
delta(31, calibrate(Rover, Camera, Objective, _), 0.0016602310420063351) :- communicated_image_data(Objective, _), todo_communicated_image_data(Objective, Is_mode), supports(Camera, Is_mode), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(31, calibrate(_, Camera, Objective, _), -0.0009430162157835105) :- communicated_image_data(Objective, _), todo_communicated_image_data(Objective, Is_mode), supports(Camera, Is_mode), !.
delta(31, calibrate(_, _, Objective, _), -0.03501698663869319) :- communicated_image_data(Objective, _), !.
delta(31, calibrate(Rover, Camera, _, Waypoint), 0.0026010412468576924) :- at_rock_sample(Waypoint), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(31, calibrate(_, _, _, Waypoint), -0.008258530770079844) :- at_rock_sample(Waypoint), !.
delta(31, calibrate(Rover, _, _, _), -0.005005011497131907) :- todo_communicated_rock_data(Waypoint), could_communicate_rock_data(Rover, Waypoint), !.
delta(31, calibrate(_, _, _, _), 0.2171701830933741) :- !.
delta(31, take_image(_, _, Objective, _, Is_mode), 0.00967613051379168) :- todo_communicated_image_data(Objective, Is_mode2), communicated_image_data(_, Is_mode2), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(31, take_image(_, _, Objective, _, _), -0.0006870846065695729) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(31, take_image(Rover, _, _, _, Is_mode), -0.0003826848858020235) :- todo_communicated_rock_data(Waypoint), could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, Is_mode), !.
delta(31, take_image(Rover, _, _, _, _), 0.0015663381039419783) :- todo_communicated_rock_data(Waypoint), could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), !.
delta(31, take_image(Rover, Waypoint, _, _, _), 2.9658220225115148e-5) :- todo_communicated_soil_data(Waypoint2), toward_could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(31, take_image(_, _, _, _, _), -0.0642167098364089) :- !.
delta(31, communicate_soil_data(Rover, _, Waypoint, Waypoint2, _), -0.00390718663250533) :- toward_could_communicate_soil_data(Rover, Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint3), toward_could_communicate_image_data(Rover, Waypoint3, Waypoint2), !.
delta(31, communicate_soil_data(Rover, _, Waypoint, Waypoint2, _), 0.016918143269179443) :- toward_could_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(31, communicate_soil_data(_, _, _, _, _), -0.036951891366653104) :- !.
delta(31, communicate_rock_data(_, _, Waypoint, _, _), 0.015313227106466964) :- todo_communicated_rock_data(Waypoint), !.
delta(31, communicate_rock_data(_, _, _, _, _), -0.06733987473086052) :- !.
delta(31, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), 0.006884021626536602) :- goal_communicated_image_data(_, Is_mode), toward_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Waypoint, Waypoint2), todo_communicated_image_data(Objective, Is_mode), !.
delta(31, communicate_image_data(Rover, _, _, Is_mode, Waypoint, Waypoint2), -0.0006651310511214607) :- goal_communicated_image_data(_, Is_mode), toward_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Waypoint, Waypoint2), !.
delta(31, communicate_image_data(Rover, _, _, Is_mode, Waypoint, _), 0.001953249164380467) :- goal_communicated_image_data(_, Is_mode), could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint), !.
delta(31, communicate_image_data(_, _, _, Is_mode, _, _), -0.10276903967270115) :- goal_communicated_image_data(_, Is_mode), !.
delta(31, communicate_image_data(_, _, _, _, _, Waypoint), 0.18707239116662805) :- at_soil_sample(Waypoint), !.
delta(31, communicate_image_data(_, _, _, _, _, _), -0.010929826410455954) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 215 examples, 50 leaves
delta(32, navigate(Rover, Waypoint, Waypoint2), -0.034322443568310344) :- have_soil_analysis(Rover, _), toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint2, Waypoint), !.
delta(32, navigate(Rover, Waypoint, Waypoint2), -0.024777043873080978) :- have_soil_analysis(Rover, _), toward_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint2, Waypoint), !.
delta(32, navigate(Rover, _, _), 0.4255361026459498) :- have_soil_analysis(Rover, _), !.
delta(32, navigate(Rover, _, Waypoint), -0.04993909659645159) :- at_rock_sample(Waypoint), could_sample_soil(Rover, Waypoint), !.
delta(32, navigate(_, _, Waypoint), 0.11287172246612749) :- at_rock_sample(Waypoint), !.
delta(32, navigate(Rover, Waypoint, Waypoint2), 0.0329865276382646) :- toward_could_sample_soil(Rover, Waypoint2, Waypoint), !.
delta(32, navigate(_, _, _), -0.24086246002475942) :- !.
delta(32, sample_soil(_, _, Waypoint), -0.0237603319152324) :- todo_communicated_rock_data(Waypoint), !.
delta(32, sample_soil(_, _, Waypoint), 0.07775805247805037) :- unsettled_visible(Waypoint), !.
delta(32, sample_soil(_, _, _), -0.0001733689204568626) :- !.
delta(32, sample_rock(_, _, Waypoint), 0.49698473654453157) :- todo_communicated_rock_data(Waypoint), !.
delta(32, sample_rock(_, _, _), -0.02203666341530063) :- !.
delta(32, drop(_, _), 0.0760941497447842) :- communicated_soil_data(_), at_rock_sample(_), !.
delta(32, drop(_, _), -0.02490318122473408) :- communicated_soil_data(_), !.
delta(32, drop(_, _), -0.00036681139426313156) :- todo_communicated_soil_data(Waypoint), unsettled_visible_todo_communicated_rock_data(Waypoint), fewer_have_image_1_than_todo_communicated_image_data_2, !.
delta(32, drop(_, _), 0.024112277705757183) :- todo_communicated_soil_data(Waypoint), unsettled_visible_todo_communicated_rock_data(Waypoint), !.
delta(32, drop(_, _), 0.017691915108889254) :- communicated_rock_data(_), !.
delta(32, drop(_, _), -0.4317556124509084) :- !.
delta(32, calibrate(Rover, _, _, Waypoint), 1.3438308197617848e-5) :- at_rock_sample(Waypoint), todo_communicated_rock_data(Waypoint2), at_rock_sample(Waypoint2), todo_communicated_rock_data(Waypoint3), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint3), !.
delta(32, calibrate(_, _, _, Waypoint), -0.15098928245428098) :- at_rock_sample(Waypoint), todo_communicated_rock_data(Waypoint2), at_rock_sample(Waypoint2), !.
delta(32, calibrate(_, _, _, Waypoint), 0.02169195748559143) :- at_rock_sample(Waypoint), !.
delta(32, calibrate(Rover, Camera, _, _), 0.0027436701785509897) :- fewer_have_image_1_than_have_image_3, needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(32, calibrate(_, _, _, _), -0.011595645036749602) :- fewer_have_image_1_than_have_image_3, !.
delta(32, calibrate(_, _, _, Waypoint), -0.0013637425216507452) :- todo_communicated_rock_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(32, calibrate(_, _, _, _), 0.17834033905907112) :- !.
delta(32, take_image(_, _, Objective, Camera, _), 0.03428577504130504) :- fewer_have_rock_analysis_1_than_have_rock_analysis_2, calibration_target(Camera, Objective), !.
delta(32, take_image(_, _, _, _, _), -0.0004994181117737443) :- fewer_have_rock_analysis_1_than_have_rock_analysis_2, !.
delta(32, take_image(Rover, _, Objective, Camera, _), 0.0007050466268400398) :- calibration_target(Camera, Objective), todo_communicated_rock_data(Waypoint), could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), !.
delta(32, take_image(_, _, Objective, Camera, _), -0.12399130504713497) :- calibration_target(Camera, Objective), !.
delta(32, take_image(_, _, Objective, _, Is_mode), 0.040589831980181866) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(32, take_image(_, _, _, _, _), -0.023572172122173808) :- !.
delta(32, communicate_soil_data(Rover, _, _, _, Waypoint), 0.025412950116532617) :- communicated_soil_data(_), todo_communicated_soil_data(Waypoint2), toward_could_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(32, communicate_soil_data(Rover, _, _, Waypoint, _), 0.00017364375954298357) :- communicated_soil_data(_), todo_communicated_soil_data(Waypoint2), toward_could_communicate_soil_data(Rover, Waypoint2, Waypoint), !.
delta(32, communicate_soil_data(_, _, _, _, _), -0.02296123525281938) :- communicated_soil_data(_), !.
delta(32, communicate_soil_data(_, _, Waypoint, _, _), 0.0031752402053333876) :- fewer_have_image_1_than_have_image_3, todo_communicated_soil_data(Waypoint), !.
delta(32, communicate_soil_data(_, _, _, _, _), -0.0012459805437629496) :- fewer_have_image_1_than_have_image_3, !.
delta(32, communicate_soil_data(_, _, _, _, Waypoint), 9.21684549987445e-5) :- todo_communicated_soil_data(Waypoint), !.
delta(32, communicate_soil_data(_, _, _, _, _), -0.06477720671836285) :- !.
delta(32, communicate_rock_data(Rover, _, _, _, _), 0.013186941975907892) :- todo_communicated_rock_data(Waypoint), could_communicate_rock_data(Rover, Waypoint), !.
delta(32, communicate_rock_data(_, _, _, _, _), -0.39355046040934044) :- at_rock_sample(_), !.
delta(32, communicate_rock_data(_, _, Waypoint, _, _), 0.008064224577945771) :- todo_communicated_rock_data(Waypoint), !.
delta(32, communicate_rock_data(_, _, _, _, _), -0.0035300365692271587) :- !.
delta(32, communicate_image_data(_, _, Objective, Is_mode, Waypoint, _), 0.0009172631594912275) :- communicated_image_data(Objective, _), todo_communicated_image_data(Objective2, Is_mode), visible_from(Objective2, Waypoint), !.
delta(32, communicate_image_data(Rover, _, Objective, _, Waypoint, Waypoint2), 0.00023774173010500393) :- communicated_image_data(Objective, _), toward_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint, Waypoint2), !.
delta(32, communicate_image_data(_, _, Objective, _, _, _), -0.03590521206775214) :- communicated_image_data(Objective, _), !.
delta(32, communicate_image_data(Rover, _, _, _, Waypoint, _), -0.015578972874043551) :- could_communicate_soil_data(Rover, Waypoint), have_rock_analysis(Rover, _), !.
delta(32, communicate_image_data(Rover, _, _, _, Waypoint, _), 0.0006292636053643174) :- could_communicate_soil_data(Rover, Waypoint), !.
delta(32, communicate_image_data(Rover, _, _, _, Waypoint, _), -0.000733473286570174) :- could_communicate_rock_data(Rover, Waypoint), !.
delta(32, communicate_image_data(_, _, _, _, _, _), 0.054614432279642224) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 212 examples, 44 leaves
delta(33, navigate(Rover, _, Waypoint), 0.02392451825925497) :- needed_at_to_communicate_rock_data(Waypoint), could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), !.
delta(33, navigate(Rover, _, Waypoint), 0.014911197574305882) :- needed_at_to_communicate_rock_data(Waypoint), have_rock_analysis(Rover, Waypoint), !.
delta(33, navigate(_, _, Waypoint), -0.22848256949386514) :- needed_at_to_communicate_rock_data(Waypoint), !.
delta(33, navigate(_, _, Waypoint), 0.021629933696338872) :- at_rock_sample(Waypoint), todo_communicated_rock_data(Waypoint), !.
delta(33, navigate(_, _, Waypoint), -0.10286667258505812) :- at_rock_sample(Waypoint), !.
delta(33, navigate(_, _, Waypoint), -0.02511483675774989) :- goal_communicated_rock_data(Waypoint), !.
delta(33, navigate(_, _, _), 0.3945798404549189) :- !.
delta(33, sample_soil(_, _, _), 0.05859444965880831) :- todo_communicated_rock_data(Waypoint), needed_at_to_communicate_rock_data(Waypoint), !.
delta(33, sample_soil(Rover, _, _), 0.0001597198385789714) :- have_rock_analysis(Rover, _), !.
delta(33, sample_soil(_, _, _), -0.04848676419087847) :- !.
delta(33, sample_rock(Rover, _, Waypoint), -0.0007945697440053481) :- todo_communicated_rock_data(Waypoint2), could_calibrate(Rover, Waypoint2), todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint, Waypoint2, Waypoint3), !.
delta(33, sample_rock(Rover, _, _), 0.03893828707248303) :- todo_communicated_rock_data(Waypoint), could_calibrate(Rover, Waypoint), !.
delta(33, sample_rock(_, _, Waypoint), 0.0010861359927770277) :- fewer_have_image_1_than_have_image_3, todo_communicated_rock_data(Waypoint), !.
delta(33, sample_rock(_, _, _), -0.0007655589264467588) :- fewer_have_image_1_than_have_image_3, !.
delta(33, sample_rock(_, _, _), -0.021266853810777427) :- !.
delta(33, drop(Rover, _), 0.0020343965053131324) :- calibrated(_, Rover), todo_communicated_rock_data(Waypoint), at_soil_sample(Waypoint), !.
delta(33, drop(Rover, _), -0.15866915205269702) :- calibrated(_, Rover), !.
delta(33, drop(_, _), -0.00863938137090527) :- fewer_have_soil_analysis_1_than_have_soil_analysis_2, !.
delta(33, drop(Rover, _), -0.006473424109994032) :- todo_communicated_rock_data(Waypoint), could_communicate_rock_data(Rover, Waypoint), !.
delta(33, drop(_, _), 0.07475376524648407) :- !.
delta(33, calibrate(Rover, Camera, _, _), 0.002504102493583534) :- todo_communicated_rock_data(Waypoint), could_sample_rock(Rover, Waypoint), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(33, calibrate(Rover, _, _, _), -0.0002464326625626179) :- todo_communicated_rock_data(Waypoint), could_sample_rock(Rover, Waypoint), !.
delta(33, calibrate(Rover, _, _, _), 0.0005896035806494171) :- todo_communicated_rock_data(Waypoint), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(33, calibrate(Rover, _, _, Waypoint), 0.0004526294887257671) :- todo_communicated_rock_data(Waypoint2), toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(33, calibrate(_, _, _, _), -0.05483362463594059) :- !.
delta(33, take_image(Rover, _, Objective, Camera, Is_mode), 0.002053122199250392) :- calibration_target(Camera, Objective), have_soil_analysis(Rover, _), todo_communicated_image_data(Objective2, Is_mode), needed_have_image_to_communicate_image_data(Objective2, Is_mode), !.
delta(33, take_image(Rover, _, Objective, Camera, _), -0.0002648537110450276) :- calibration_target(Camera, Objective), have_soil_analysis(Rover, _), !.
delta(33, take_image(_, Waypoint, Objective, Camera, _), 0.00043259263645849185) :- calibration_target(Camera, Objective), todo_communicated_rock_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(33, take_image(_, _, Objective, Camera, _), -0.04601045074546493) :- calibration_target(Camera, Objective), !.
delta(33, take_image(_, _, Objective, _, _), -0.02941997359531068) :- todo_communicated_rock_data(Waypoint), visible_from(Objective, Waypoint), !.
delta(33, take_image(_, Waypoint, _, _, _), -0.002114925823894468) :- todo_communicated_rock_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(33, take_image(_, _, _, _, _), 0.08940827928087995) :- !.
delta(33, communicate_soil_data(Rover, _, Waypoint, Waypoint2, _), 0.012308574103707295) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(33, communicate_soil_data(Rover, _, _, _, _), 0.0005017661334249937) :- todo_communicated_soil_data(Waypoint), could_calibrate(Rover, Waypoint), !.
delta(33, communicate_soil_data(Rover, _, Waypoint, _, _), 0.0003787517509143287) :- could_take_image(Rover, Waypoint), !.
delta(33, communicate_soil_data(_, _, _, _, _), -0.05708813644149693) :- !.
delta(33, communicate_rock_data(_, _, Waypoint, _, _), 0.017818663872926358) :- todo_communicated_rock_data(Waypoint), !.
delta(33, communicate_rock_data(_, _, _, _, _), -0.02892781491791651) :- !.
delta(33, communicate_image_data(_, _, _, _, _, _), 0.0024791898341895275) :- todo_communicated_rock_data(_), fewer_have_image_1_than_todo_communicated_image_data_1, !.
delta(33, communicate_image_data(Rover, _, _, _, Waypoint, _), 0.00010172084693938041) :- todo_communicated_rock_data(_), could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), !.
delta(33, communicate_image_data(_, _, _, _, _, _), -0.0664853990486594) :- todo_communicated_rock_data(_), !.
delta(33, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.04735158340928293) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(33, communicate_image_data(_, _, _, _, _, _), -0.0034152258543763588) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 207 examples, 42 leaves
delta(34, navigate(Rover, _, Waypoint), -0.005115775695658225) :- goal_communicated_soil_data(Waypoint), todo_communicated_soil_data(Waypoint2), have_soil_analysis(Rover, Waypoint2), !.
delta(34, navigate(Rover, Waypoint, Waypoint2), -0.0013669037344092284) :- goal_communicated_soil_data(Waypoint2), todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint3, Waypoint, Waypoint2), !.
delta(34, navigate(_, _, Waypoint), 0.09114121409214469) :- goal_communicated_soil_data(Waypoint), !.
delta(34, navigate(_, Waypoint, Waypoint2), -0.012210977253068097) :- goal_communicated_rock_data(Waypoint2), needed_have_soil_analysis_to_communicate_soil_data(Waypoint), !.
delta(34, navigate(_, _, Waypoint), 0.04710207033385627) :- goal_communicated_rock_data(Waypoint), !.
delta(34, navigate(Rover, _, Waypoint), 0.02376210688205979) :- todo_communicated_rock_data(Waypoint2), toward_could_sample_soil(Rover, Waypoint, Waypoint2), !.
delta(34, navigate(_, _, _), -0.13371473370283968) :- !.
delta(34, sample_soil(_, _, Waypoint), -0.06460570957484575) :- at_rock_sample(Waypoint), !.
delta(34, sample_soil(Rover, _, Waypoint), -0.004244925772099819) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(34, sample_soil(_, _, Waypoint), 0.022430361092620026) :- unsettled_visible(Waypoint), !.
delta(34, sample_soil(_, _, _), -0.0007714021952444415) :- !.
delta(34, sample_rock(Rover, _, Waypoint), 0.08152242513447544) :- todo_communicated_rock_data(Waypoint), equipped_for_imaging(Rover), !.
delta(34, sample_rock(_, _, Waypoint), -0.001811699151496711) :- todo_communicated_rock_data(Waypoint), !.
delta(34, sample_rock(_, _, _), -0.015691307972592234) :- !.
delta(34, drop(Rover, _), -6.291356415965484e-5) :- goal_communicated_soil_data(_), todo_communicated_soil_data(Waypoint), at(Rover, Waypoint), fewer_have_image_1_than_todo_communicated_image_data_2, !.
delta(34, drop(Rover, _), 0.014007971233274349) :- goal_communicated_soil_data(_), todo_communicated_soil_data(Waypoint), at(Rover, Waypoint), !.
delta(34, drop(Rover, _), 0.0032923448213504226) :- goal_communicated_soil_data(Waypoint), todo_communicated_rock_data(Waypoint2), toward_could_calibrate(Rover, Waypoint, Waypoint2), !.
delta(34, drop(_, _), -0.03927756798057533) :- goal_communicated_soil_data(_), !.
delta(34, drop(Rover, _), -0.000822777271131272) :- todo_communicated_rock_data(Waypoint), at(Rover, Waypoint), could_communicate_rock_data(Rover, Waypoint), !.
delta(34, drop(Rover, _), 0.08865209842804336) :- todo_communicated_rock_data(Waypoint), at(Rover, Waypoint), !.
delta(34, drop(_, _), -0.007382646736503452) :- !.
delta(34, calibrate(Rover, _, Objective, Waypoint), -0.00022556515273346026) :- have_soil_analysis(Rover, Waypoint), have_image(Rover, Objective, _), !.
delta(34, calibrate(Rover, _, _, Waypoint), 0.016494876243343226) :- have_soil_analysis(Rover, Waypoint), !.
delta(34, calibrate(Rover, _, _, _), 0.0019617327843135203) :- todo_communicated_rock_data(Waypoint), needed_at_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(34, calibrate(Rover, _, _, _), 0.0012886626536532306) :- todo_communicated_rock_data(Waypoint), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(34, calibrate(_, _, _, _), -0.04879718694859571) :- !.
delta(34, take_image(_, Waypoint, Objective, Camera, Is_mode), -0.028452899856375894) :- goal_communicated_image_data(Objective, Is_mode), calibration_target(Camera, Objective), at_soil_sample(Waypoint), !.
delta(34, take_image(_, _, Objective, Camera, Is_mode), 0.02583444138854025) :- goal_communicated_image_data(Objective, Is_mode), calibration_target(Camera, Objective), !.
delta(34, take_image(_, _, Objective, _, Is_mode), 0.033533951362643866) :- goal_communicated_image_data(Objective, Is_mode), todo_communicated_image_data(Objective2, Is_mode), needed_have_image_to_communicate_image_data(Objective2, Is_mode), !.
delta(34, take_image(_, _, Objective, _, Is_mode), -0.0006839309554751588) :- goal_communicated_image_data(Objective, Is_mode), !.
delta(34, take_image(_, _, _, _, _), -0.014827937060181933) :- !.
delta(34, communicate_soil_data(Rover, _, Waypoint, Waypoint2, _), -0.0031549834745290667) :- todo_communicated_soil_data(Waypoint), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2), !.
delta(34, communicate_soil_data(_, _, Waypoint, _, _), 0.013759475715747928) :- todo_communicated_soil_data(Waypoint), !.
delta(34, communicate_soil_data(_, _, _, _, _), -0.055487992897645076) :- !.
delta(34, communicate_rock_data(_, _, Waypoint, _, _), 0.02832370773705241) :- todo_communicated_rock_data(Waypoint), !.
delta(34, communicate_rock_data(_, _, _, _, _), -0.05392541477006529) :- !.
delta(34, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), 8.590413648571539e-7) :- todo_communicated_image_data(Objective2, Is_mode), have_image(Rover, Objective2, Is_mode2), toward_could_take_image(Rover, Waypoint, Waypoint2), communicated_image_data(Objective, Is_mode2), !.
delta(34, communicate_image_data(Rover, _, _, Is_mode, Waypoint, Waypoint2), -0.0017781380490053135) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, _), toward_could_take_image(Rover, Waypoint, Waypoint2), !.
delta(34, communicate_image_data(Rover, _, Objective, Is_mode, _, _), 0.04800052807584212) :- todo_communicated_image_data(Objective2, Is_mode), have_image(Rover, Objective2, Is_mode2), todo_communicated_image_data(Objective, Is_mode2), !.
delta(34, communicate_image_data(Rover, _, _, Is_mode, _, _), -0.0006098114583620857) :- todo_communicated_image_data(Objective, Is_mode), have_image(Rover, Objective, _), !.
delta(34, communicate_image_data(_, _, _, _, _, _), -0.025198907484053994) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 232 examples, 42 leaves
delta(35, navigate(Rover, Waypoint, Waypoint2), -0.01605054737532294) :- toward_could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint, Waypoint2), have_soil_analysis(Rover, Waypoint2), !.
delta(35, navigate(Rover, Waypoint, Waypoint2), -0.0003323157339323323) :- toward_could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint3), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint3), !.
delta(35, navigate(Rover, Waypoint, Waypoint2), 0.12032784603877335) :- toward_could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint, Waypoint2), !.
delta(35, navigate(Rover, Waypoint, Waypoint2), -0.023789401100505824) :- toward_could_sample_soil(Rover, Waypoint, Waypoint2), todo_communicated_soil_data(Waypoint3), toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint2, Waypoint3), !.
delta(35, navigate(Rover, Waypoint, Waypoint2), 0.07809256594558225) :- toward_could_sample_soil(Rover, Waypoint, Waypoint2), !.
delta(35, navigate(Rover, _, Waypoint), 0.02358996329095073) :- todo_communicated_soil_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(35, navigate(_, _, _), -0.3212599213629052) :- !.
delta(35, sample_soil(Rover, _, Waypoint), 0.0044362590728093555) :- todo_communicated_rock_data(Waypoint2), could_calibrate(Rover, Waypoint2), todo_communicated_soil_data(Waypoint), !.
delta(35, sample_soil(Rover, _, _), -0.017293972796868524) :- todo_communicated_rock_data(Waypoint), could_calibrate(Rover, Waypoint), !.
delta(35, sample_soil(Rover, _, Waypoint), -0.0016739238183953154) :- unsettled_visible(Waypoint), todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(35, sample_soil(_, _, Waypoint), 0.30577772769931333) :- unsettled_visible(Waypoint), !.
delta(35, sample_soil(_, _, _), -0.004814891976096768) :- !.
delta(35, sample_rock(Rover, _, Waypoint), -0.000630134473788891) :- have_soil_analysis(Rover, _), todo_communicated_soil_data(Waypoint), !.
delta(35, sample_rock(Rover, _, _), 0.018590812918961787) :- have_soil_analysis(Rover, _), !.
delta(35, sample_rock(Rover, _, _), 0.000815567870590712) :- todo_communicated_soil_data(Waypoint), needed_at_to_sample_soil_to_communicate_soil_data(Rover, Waypoint), !.
delta(35, sample_rock(_, _, _), -0.2773405549403209) :- !.
delta(35, drop(Rover, _), -0.005085284508702855) :- at_rock_sample(_), todo_communicated_rock_data(Waypoint), could_communicate_image_data(Rover, Waypoint), !.
delta(35, drop(Rover, _), -0.004808451551293542) :- at_rock_sample(Waypoint), could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, Waypoint), !.
delta(35, drop(_, _), 0.14043103759424294) :- at_rock_sample(_), !.
delta(35, drop(_, _), -0.010461270152545624) :- !.
delta(35, calibrate(Rover, _, _, Waypoint), -0.0006173149338132692) :- could_communicate_soil_data(Rover, Waypoint), todo_communicated_soil_data(Waypoint2), toward_could_communicate_image_data(Rover, Waypoint2, Waypoint), !.
delta(35, calibrate(Rover, _, _, Waypoint), -0.00019209877804809015) :- could_communicate_soil_data(Rover, Waypoint), could_sample_soil(Rover, Waypoint), !.
delta(35, calibrate(Rover, _, _, Waypoint), 0.020913451295804877) :- could_communicate_soil_data(Rover, Waypoint), !.
delta(35, calibrate(Rover, _, _, Waypoint), 0.0014798199982148821) :- unsettled_visible(Waypoint), todo_communicated_rock_data(Waypoint2), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint2), !.
delta(35, calibrate(_, _, _, Waypoint), -0.06228763810993367) :- unsettled_visible(Waypoint), !.
delta(35, calibrate(Rover, Camera, _, _), 0.010337889752420112) :- needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(35, calibrate(_, _, _, _), -0.0024432215337073346) :- !.
delta(35, take_image(_, _, Objective, Camera, Is_mode), -0.02295470568364243) :- goal_communicated_image_data(_, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), calibration_target(Camera, Objective), !.
delta(35, take_image(_, _, Objective, _, Is_mode), 0.02850991810381054) :- goal_communicated_image_data(_, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(35, take_image(_, _, _, _, Is_mode), -0.04536394694749244) :- goal_communicated_image_data(_, Is_mode), !.
delta(35, take_image(Rover, Waypoint, Objective, _, _), -2.4876731187836993e-5) :- could_communicate_image_data(Rover, Waypoint), todo_communicated_soil_data(Waypoint2), visible_from(Objective, Waypoint2), !.
delta(35, take_image(Rover, Waypoint, _, _, _), 0.0686160460961038) :- could_communicate_image_data(Rover, Waypoint), !.
delta(35, take_image(_, _, _, _, _), -0.001136513773096514) :- !.
delta(35, communicate_soil_data(_, _, Waypoint, _, _), -0.014704590142065576) :- communicated_soil_data(Waypoint), !.
delta(35, communicate_soil_data(Rover, _, _, Waypoint, _), -0.004895494107984586) :- could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Waypoint), !.
delta(35, communicate_soil_data(_, _, _, _, _), 0.036806329327201764) :- todo_communicated_soil_data(_), !.
delta(35, communicate_soil_data(_, _, _, _, _), -0.0011503438819867777) :- !.
delta(35, communicate_rock_data(_, _, Waypoint, _, _), 0.05280332421937726) :- todo_communicated_rock_data(Waypoint), !.
delta(35, communicate_rock_data(_, _, _, _, _), -0.032494671800290295) :- !.
delta(35, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.040791780168242496) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(35, communicate_image_data(_, _, _, _, _, _), -0.02952803998785933) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 225 examples, 41 leaves
delta(36, navigate(Rover, Waypoint, Waypoint2), -0.017849473250999105) :- have_soil_analysis(Rover, Waypoint3), todo_communicated_rock_data(Waypoint4), nearer_at(Rover, Waypoint4, Waypoint2, Waypoint3), communicated_soil_data(Waypoint), !.
delta(36, navigate(Rover, _, Waypoint), 0.03984282555309571) :- have_soil_analysis(Rover, Waypoint2), todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint3, Waypoint, Waypoint2), !.
delta(36, navigate(Rover, _, Waypoint), -0.1492199576324397) :- have_soil_analysis(Rover, Waypoint2), visible(Waypoint, Waypoint2), !.
delta(36, navigate(Rover, _, _), 0.008300595747723082) :- have_soil_analysis(Rover, _), !.
delta(36, navigate(Rover, Waypoint, Waypoint2), -0.03719383792724224) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(36, navigate(Rover, Waypoint, _), -0.032933146449971265) :- todo_communicated_rock_data(Waypoint2), toward_could_sample_soil(Rover, Waypoint2, Waypoint), !.
delta(36, navigate(_, _, _), 0.24630534493638012) :- !.
delta(36, sample_soil(_, _, Waypoint), 0.029902164378411363) :- todo_communicated_soil_data(Waypoint), !.
delta(36, sample_soil(_, _, _), -0.04555179036408987) :- !.
delta(36, sample_rock(Rover, _, Waypoint), -0.06389034152692653) :- todo_communicated_rock_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(36, sample_rock(_, _, Waypoint), -3.796730716083556e-5) :- todo_communicated_soil_data(Waypoint), !.
delta(36, sample_rock(_, _, _), 0.10411204939740973) :- !.
delta(36, drop(Rover, _), 0.00016289799796078889) :- todo_communicated_rock_data(Waypoint), at(Rover, Waypoint), todo_communicated_rock_data(Waypoint2), have_rock_analysis(Rover, Waypoint2), could_take_image(Rover, Waypoint), !.
delta(36, drop(Rover, _), -0.0163188249015234) :- todo_communicated_rock_data(Waypoint), at(Rover, Waypoint), todo_communicated_rock_data(Waypoint2), have_rock_analysis(Rover, Waypoint2), !.
delta(36, drop(Rover, _), 0.0028577684728267405) :- todo_communicated_rock_data(Waypoint), at(Rover, Waypoint), !.
delta(36, drop(_, _), -0.0046591288622995115) :- fewer_have_image_1_than_todo_communicated_image_data_1, !.
delta(36, drop(_, _), 0.07405928813752215) :- at_soil_sample(_), !.
delta(36, drop(_, _), -0.0013946814424793137) :- !.
delta(36, calibrate(_, _, _, _), 0.014939221168645125) :- fewer_have_soil_analysis_1_than_have_soil_analysis_2, !.
delta(36, calibrate(Rover, Camera, _, _), 0.013984854779556669) :- fewer_have_image_1_than_todo_communicated_image_data_1, needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(36, calibrate(_, _, _, _), -0.0020817417886682555) :- fewer_have_image_1_than_todo_communicated_image_data_1, !.
delta(36, calibrate(Rover, _, _, _), 0.001375550798471626) :- todo_communicated_soil_data(Waypoint), could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint), !.
delta(36, calibrate(_, _, _, _), -0.04676815312884529) :- !.
delta(36, take_image(Rover, _, Objective, Camera, Is_mode), -0.003993347756196806) :- calibration_target(Camera, Objective), todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), have_image(Rover, Objective, Is_mode), !.
delta(36, take_image(_, _, Objective, Camera, Is_mode), 0.012945103098714456) :- calibration_target(Camera, Objective), todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), !.
delta(36, take_image(Rover, Waypoint, Objective, Camera, _), 8.043176528110702e-5) :- calibration_target(Camera, Objective), todo_communicated_soil_data(Waypoint2), can_traverse(Rover, Waypoint, Waypoint2), !.
delta(36, take_image(_, _, Objective, Camera, _), -0.05207013231769199) :- calibration_target(Camera, Objective), !.
delta(36, take_image(_, _, Objective, _, Is_mode), 0.026258540809246732) :- needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(36, take_image(_, _, _, _, _), -0.013392339174125264) :- !.
delta(36, communicate_soil_data(_, _, Waypoint, _, _), 0.006622711717064445) :- todo_communicated_soil_data(Waypoint), !.
delta(36, communicate_soil_data(_, _, _, _, _), -0.04569563180803095) :- !.
delta(36, communicate_rock_data(_, _, Waypoint, _, _), 0.012957839853760759) :- todo_communicated_rock_data(Waypoint), !.
delta(36, communicate_rock_data(_, _, _, _, _), -0.015955830452758935) :- !.
delta(36, communicate_image_data(Rover, _, Objective, Is_mode, Waypoint, Waypoint2), 0.0012312351662794956) :- toward_could_sample_soil(Rover, Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint3), could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint3), todo_communicated_image_data(Objective, Is_mode), !.
delta(36, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), -0.00025149073377413894) :- toward_could_sample_soil(Rover, Waypoint, Waypoint2), todo_communicated_rock_data(Waypoint3), could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint3), !.
delta(36, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), -0.11439887820972378) :- toward_could_sample_soil(Rover, Waypoint, Waypoint2), unsettled_visible(Waypoint), !.
delta(36, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), 0.0001763513134228294) :- toward_could_sample_soil(Rover, Waypoint, Waypoint2), !.
delta(36, communicate_image_data(_, _, Objective, Is_mode, _, _), -0.00858415500911558) :- communicated_image_data(Objective, Is_mode), !.
delta(36, communicate_image_data(Rover, _, _, _, Waypoint, Waypoint2), -0.0001584689869056237) :- todo_communicated_rock_data(Waypoint3), nearer_at(Rover, Waypoint3, Waypoint, Waypoint2), !.
delta(36, communicate_image_data(_, _, _, _, _, _), 0.05192107856554116) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 236 examples, 46 leaves
delta(37, navigate(Rover, Waypoint, Waypoint2), -0.0010342571439905625) :- communicated_soil_data(Waypoint), toward_could_sample_soil(Rover, Waypoint2, Waypoint), todo_communicated_rock_data(Waypoint), !.
delta(37, navigate(Rover, Waypoint, Waypoint2), 0.00206421917816652) :- communicated_soil_data(Waypoint), toward_could_sample_soil(Rover, Waypoint2, Waypoint), !.
delta(37, navigate(Rover, Waypoint, Waypoint2), 0.000994457887575571) :- communicated_soil_data(Waypoint), could_sample_rock(Rover, Waypoint2), !.
delta(37, navigate(_, Waypoint, _), -0.07800690433462326) :- communicated_soil_data(Waypoint), !.
delta(37, navigate(Rover, Waypoint, Waypoint2), 0.006331686706039975) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), todo_communicated_soil_data(Waypoint4), toward_could_communicate_soil_data_todo_communicated_soil_data(Rover, Waypoint4, Waypoint2), !.
delta(37, navigate(Rover, Waypoint, Waypoint2), -0.07959598336282594) :- todo_communicated_soil_data(Waypoint3), nearer_at(Rover, Waypoint2, Waypoint, Waypoint3), !.
delta(37, navigate(Rover, _, Waypoint), -0.05349027637133252) :- todo_communicated_rock_data(Waypoint2), toward_could_sample_soil(Rover, Waypoint2, Waypoint), !.
delta(37, navigate(_, _, _), 0.26359018728983447) :- !.
delta(37, sample_soil(Rover, _, Waypoint), 0.005338707418129487) :- equipped_for_imaging(Rover), todo_communicated_rock_data(Waypoint2), toward_could_sample_rock(Rover, Waypoint2, Waypoint), !.
delta(37, sample_soil(Rover, _, Waypoint), 0.0006925521242101979) :- equipped_for_imaging(Rover), todo_communicated_rock_data(Waypoint2), toward_could_calibrate(Rover, Waypoint2, Waypoint), !.
delta(37, sample_soil(Rover, _, _), -0.24459959373052753) :- equipped_for_imaging(Rover), !.
delta(37, sample_soil(_, _, _), 0.030938461465439417) :- !.
delta(37, sample_rock(Rover, _, _), 0.030230606038124424) :- todo_communicated_rock_data(Waypoint), could_sample_soil(Rover, Waypoint), have_soil_analysis(Rover, Waypoint2), goal_communicated_soil_data(Waypoint2), !.
delta(37, sample_rock(Rover, _, _), -0.0005864469619851266) :- todo_communicated_rock_data(Waypoint), could_sample_soil(Rover, Waypoint), have_soil_analysis(Rover, _), !.
delta(37, sample_rock(Rover, _, _), 0.0034182877720133685) :- todo_communicated_rock_data(Waypoint), could_sample_soil(Rover, Waypoint), fewer_have_image_1_than_have_image_3, !.
delta(37, sample_rock(Rover, _, _), -0.11619614868173184) :- todo_communicated_rock_data(Waypoint), could_sample_soil(Rover, Waypoint), !.
delta(37, sample_rock(_, _, Waypoint), 0.4712296716601693) :- unsettled_visible(Waypoint), !.
delta(37, sample_rock(_, _, _), -0.0005220027438532427) :- !.
delta(37, drop(Rover, _), -0.012848274288260025) :- at_rock_sample(Waypoint), could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint), !.
delta(37, drop(_, _), -0.0009604339505849146) :- at_rock_sample(_), fewer_have_image_1_than_todo_communicated_image_data_2, !.
delta(37, drop(_, _), 0.12323185039708925) :- at_rock_sample(_), !.
delta(37, drop(_, _), 8.436025280077828e-5) :- todo_communicated_soil_data(Waypoint), unsettled_visible_todo_communicated_rock_data(Waypoint), !.
delta(37, drop(_, _), -0.07352926983250266) :- !.
delta(37, calibrate(Rover, _, Objective, Waypoint), 0.00030972307438517345) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), fewer_have_image_1_than_todo_communicated_image_data_2_have_image_3, todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(37, calibrate(Rover, _, _, Waypoint), -0.00311351852296397) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), fewer_have_image_1_than_todo_communicated_image_data_2_have_image_3, !.
delta(37, calibrate(Rover, _, _, Waypoint), -0.0005544791505113685) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), fewer_have_rock_analysis_1_than_have_rock_analysis_2, !.
delta(37, calibrate(Rover, _, _, Waypoint), 0.03370724177007182) :- could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint), !.
delta(37, calibrate(_, _, _, _), -0.03313445761416559) :- !.
delta(37, take_image(_, _, Objective, _, Is_mode), 0.0005848304321613881) :- fewer_have_image_1_than_have_image_2, todo_communicated_image_data(Objective, Is_mode), !.
delta(37, take_image(_, _, _, _, _), -0.007267955133230147) :- fewer_have_image_1_than_have_image_2, !.
delta(37, take_image(Rover, _, Objective, Camera, _), -0.017149424037124984) :- todo_communicated_soil_data(Waypoint), could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint), calibration_target(Camera, Objective), !.
delta(37, take_image(Rover, _, _, _, _), 0.017076324661877754) :- todo_communicated_soil_data(Waypoint), could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint), !.
delta(37, take_image(_, _, Objective, Camera, _), 0.03431306942988342) :- calibration_target(Camera, Objective), !.
delta(37, take_image(_, _, _, _, _), -0.00019320837096324577) :- !.
delta(37, communicate_soil_data(Rover, _, Waypoint, Waypoint2, _), 0.030633960099495428) :- toward_could_calibrate(Rover, Waypoint2, Waypoint), !.
delta(37, communicate_soil_data(Rover, _, Waypoint, _, _), 0.011754278415287667) :- todo_communicated_rock_data(Waypoint2), toward_could_communicate_rock_data(Rover, Waypoint, Waypoint2), !.
delta(37, communicate_soil_data(_, _, Waypoint, _, _), 0.0033386018490080055) :- todo_communicated_soil_data(Waypoint), !.
delta(37, communicate_soil_data(_, _, _, _, _), -0.1048571541062368) :- !.
delta(37, communicate_rock_data(Rover, _, Waypoint, _, Waypoint2), -0.0003557687781029375) :- todo_communicated_rock_data(Waypoint3), could_communicate_rock_data(Rover, Waypoint3), toward_could_sample_rock(Rover, Waypoint2, Waypoint), !.
delta(37, communicate_rock_data(Rover, _, _, _, _), 0.023363146573819504) :- todo_communicated_rock_data(Waypoint), could_communicate_rock_data(Rover, Waypoint), !.
delta(37, communicate_rock_data(Rover, _, _, _, _), -0.3503825461960169) :- equipped_for_soil_analysis(Rover), at_rock_sample(_), !.
delta(37, communicate_rock_data(Rover, _, _, _, _), 0.003594663989374504) :- equipped_for_soil_analysis(Rover), !.
delta(37, communicate_rock_data(_, _, _, _, _), 0.009065729484334196) :- !.
delta(37, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.009757637030699665) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(37, communicate_image_data(_, _, _, _, _, _), -0.023543048609386226) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 213 examples, 44 leaves
delta(38, navigate(Rover, Waypoint, Waypoint2), 0.0064319884509145405) :- have_rock_analysis(_, Waypoint2), toward_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint2, Waypoint), could_calibrate(Rover, Waypoint), !.
delta(38, navigate(Rover, Waypoint, Waypoint2), -0.0002317534202167041) :- have_rock_analysis(_, Waypoint2), toward_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint2, Waypoint), !.
delta(38, navigate(Rover, Waypoint, Waypoint2), 0.001973778669732736) :- have_rock_analysis(_, Waypoint2), toward_could_sample_rock(Rover, Waypoint, Waypoint2), !.
delta(38, navigate(_, _, Waypoint), -0.11762159611822835) :- have_rock_analysis(_, Waypoint), !.
delta(38, navigate(Rover, _, Waypoint), -0.09983845965175521) :- could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), full(_), !.
delta(38, navigate(Rover, _, Waypoint), 0.007964737529766659) :- could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), !.
delta(38, navigate(_, _, _), 0.3033045548687464) :- empty(_), !.
delta(38, navigate(_, _, _), -0.05343616815669087) :- !.
delta(38, sample_soil(_, _, Waypoint), 0.00014783307769853464) :- todo_communicated_rock_data(Waypoint), !.
delta(38, sample_soil(_, _, _), -0.011973207225980631) :- !.
delta(38, sample_rock(Rover, _, Waypoint), 0.0008869321818636318) :- at_soil_sample(Waypoint), todo_communicated_rock_data(Waypoint2), could_calibrate(Rover, Waypoint2), !.
delta(38, sample_rock(_, _, Waypoint), -0.0191626424432778) :- at_soil_sample(Waypoint), !.
delta(38, sample_rock(_, _, _), 0.00325271950752057) :- !.
delta(38, drop(Rover, _), 0.0015980895117005715) :- calibrated(_, Rover), todo_communicated_rock_data(Waypoint), have_soil_analysis(Rover, Waypoint), !.
delta(38, drop(Rover, _), -0.0050103240179314446) :- calibrated(_, Rover), !.
delta(38, drop(Rover, _), -0.0010908717903122336) :- at_rock_sample(Waypoint), todo_communicated_rock_data(Waypoint2), toward_could_calibrate(Rover, Waypoint2, Waypoint), !.
delta(38, drop(_, _), 0.05501379373705851) :- at_rock_sample(_), !.
delta(38, drop(_, _), -0.0011962686218982598) :- !.
delta(38, calibrate(Rover, _, _, Waypoint), -0.0008449451086711319) :- could_communicate_rock_data(Rover, Waypoint), todo_communicated_soil_data(Waypoint2), unsettled_visible_todo_communicated_rock_data(Waypoint2), !.
delta(38, calibrate(Rover, _, _, Waypoint), 0.014463397524794816) :- could_communicate_rock_data(Rover, Waypoint), !.
delta(38, calibrate(Rover, Camera, _, Waypoint), 0.00639322777168297) :- todo_communicated_soil_data(Waypoint2), visible(Waypoint, Waypoint2), needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover), !.
delta(38, calibrate(_, _, _, Waypoint), -0.00045606810768517877) :- todo_communicated_soil_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(38, calibrate(_, _, _, _), 0.0008835948929117116) :- fewer_have_image_1_than_todo_communicated_image_data_1_have_image_2, !.
delta(38, calibrate(_, _, _, _), -0.10627728987595694) :- !.
delta(38, take_image(_, _, Objective, Camera, Is_mode), 9.374520484188772e-6) :- calibration_target(Camera, Objective), needed_have_image_to_communicate_image_data(Objective, Is_mode), todo_communicated_soil_data(Waypoint), at_rock_sample(Waypoint), !.
delta(38, take_image(_, _, Objective, Camera, Is_mode), 0.0034643180805548836) :- calibration_target(Camera, Objective), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(38, take_image(_, _, Objective, Camera, _), -0.033562098839185234) :- calibration_target(Camera, Objective), !.
delta(38, take_image(Rover, Waypoint, Objective, _, Is_mode), -0.03388098848017588) :- have_image(Rover, Objective, Is_mode), could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint), !.
delta(38, take_image(Rover, _, Objective, _, Is_mode), 0.02079955875796463) :- have_image(Rover, Objective, Is_mode), !.
delta(38, take_image(_, _, Objective, _, _), 0.06403491461195461) :- goal_communicated_image_data(Objective, _), !.
delta(38, take_image(_, _, _, _, _), -0.0005013063160353122) :- !.
delta(38, communicate_soil_data(_, _, Waypoint, _, _), 0.0007606022542812949) :- todo_communicated_soil_data(Waypoint), !.
delta(38, communicate_soil_data(_, _, _, _, _), -0.03154190052313612) :- !.
delta(38, communicate_rock_data(_, _, Waypoint, _, _), 0.011665610308628867) :- todo_communicated_rock_data(Waypoint), !.
delta(38, communicate_rock_data(_, _, _, _, _), -0.03221910230275546) :- !.
delta(38, communicate_image_data(Rover, _, Objective, _, _, Waypoint), 0.00013159178078740616) :- communicated_image_data(Objective, _), at_rock_sample(Waypoint2), toward_could_sample_soil(Rover, Waypoint, Waypoint2), !.
delta(38, communicate_image_data(_, _, Objective, _, _, _), -0.11531780968105673) :- communicated_image_data(Objective, _), at_rock_sample(_), !.
delta(38, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.005020999897836372) :- communicated_image_data(Objective, _), todo_communicated_image_data(Objective, Is_mode), !.
delta(38, communicate_image_data(_, _, Objective, _, _, _), -0.001470680550121765) :- communicated_image_data(Objective, _), !.
delta(38, communicate_image_data(Rover, _, Objective, Is_mode, _, Waypoint), 0.00016672309474440703) :- have_soil_analysis(Rover, Waypoint), todo_communicated_image_data(Objective, Is_mode), !.
delta(38, communicate_image_data(Rover, _, _, _, _, Waypoint), -0.0005645304716492715) :- have_soil_analysis(Rover, Waypoint), !.
delta(38, communicate_image_data(Rover, _, _, _, _, _), -0.00016770294708485945) :- todo_communicated_rock_data(Waypoint), have_rock_analysis(Rover, Waypoint), !.
delta(38, communicate_image_data(_, _, _, _, _, _), 0.1027139177625571) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 209 examples, 45 leaves
delta(39, navigate(Rover, _, Waypoint), -0.19923738605858865) :- at(_, Waypoint), todo_communicated_rock_data(Waypoint2), could_calibrate(Rover, Waypoint2), !.
delta(39, navigate(_, _, Waypoint), -0.006611925893868298) :- at(Rover, Waypoint), equipped_for_imaging(Rover), !.
delta(39, navigate(_, _, Waypoint), 0.018715902239820777) :- at(_, Waypoint), !.
delta(39, navigate(_, Waypoint, _), 0.021257751659693506) :- at_soil_sample(Waypoint), goal_communicated_rock_data(Waypoint), !.
delta(39, navigate(_, Waypoint, _), -0.14517558013172704) :- at_soil_sample(Waypoint), !.
delta(39, navigate(Rover, Waypoint, _), -0.03500767347393312) :- could_calibrate(Rover, Waypoint), !.
delta(39, navigate(_, _, _), 0.2594722722752215) :- !.
delta(39, sample_soil(Rover, _, _), 0.0017734976952199074) :- have_rock_analysis(Rover, Waypoint), todo_communicated_soil_data(Waypoint2), toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint, Waypoint2), !.
delta(39, sample_soil(Rover, _, _), -0.06979892837395477) :- have_rock_analysis(Rover, _), !.
delta(39, sample_soil(_, _, Waypoint), 0.03453060963955619) :- todo_communicated_soil_data(Waypoint), !.
delta(39, sample_soil(_, _, _), -0.0020856526341174273) :- !.
delta(39, sample_rock(Rover, _, _), -0.0002521822904277523) :- equipped_for_soil_analysis(Rover), fewer_at_1_than_have_image_2, !.
delta(39, sample_rock(Rover, _, _), 0.10491446108736596) :- equipped_for_soil_analysis(Rover), !.
delta(39, sample_rock(_, _, _), -0.037104185753974527) :- !.
delta(39, drop(_, _), -0.041823364963786545) :- todo_communicated_rock_data(Waypoint), goal_communicated_soil_data(Waypoint), !.
delta(39, drop(Rover, _), 0.012911058220673855) :- todo_communicated_rock_data(Waypoint), at_soil_sample(Waypoint), have_soil_analysis(Rover, _), !.
delta(39, drop(_, _), -0.024940355967350097) :- todo_communicated_rock_data(Waypoint), at_soil_sample(Waypoint), !.
delta(39, drop(_, _), -0.009982314168937996) :- fewer_have_soil_analysis_1_than_have_soil_analysis_2, !.
delta(39, drop(_, _), 0.09563427512613343) :- !.
delta(39, calibrate(Rover, Camera, Objective, _), -5.1519676304488987e-5) :- have_image(Rover, Objective, Is_mode), todo_communicated_image_data(Objective2, Is_mode), needed_have_image_to_communicate_image_data(Objective2, Is_mode), calibrated(Camera, Rover), !.
delta(39, calibrate(Rover, _, Objective, _), 0.003293403071231511) :- have_image(Rover, Objective, Is_mode), todo_communicated_image_data(Objective2, Is_mode), needed_have_image_to_communicate_image_data(Objective2, Is_mode), !.
delta(39, calibrate(Rover, _, Objective, _), 0.0031288836641385482) :- have_image(Rover, Objective, _), todo_communicated_image_data(Objective, Is_mode), needed_have_image_to_communicate_image_data(Objective, Is_mode), !.
delta(39, calibrate(Rover, _, Objective, _), -0.08185967826729039) :- have_image(Rover, Objective, _), !.
delta(39, calibrate(_, _, Objective, _), -0.023286189150133696) :- todo_communicated_image_data(Objective, _), todo_communicated_rock_data(Waypoint), at_soil_sample(Waypoint), !.
delta(39, calibrate(_, _, Objective, _), 0.007242914511065602) :- todo_communicated_image_data(Objective, _), !.
delta(39, calibrate(_, _, _, Waypoint), -0.003117592573383162) :- needed_have_rock_analysis_to_communicate_rock_data(Waypoint), !.
delta(39, calibrate(_, _, _, _), 0.1854744607018166) :- !.
delta(39, take_image(Rover, _, Objective, _, Is_mode), -0.00038327252741574594) :- todo_communicated_image_data(Objective2, Is_mode), communicated_image_data(Objective2, _), have_image(Rover, Objective, Is_mode), !.
delta(39, take_image(_, _, _, _, Is_mode), 0.0008747906293010211) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(Objective, _), !.
delta(39, take_image(_, _, Objective, _, _), 0.00033368547547436004) :- todo_communicated_image_data(Objective, Is_mode), communicated_image_data(_, Is_mode), !.
delta(39, take_image(Rover, Waypoint, _, _, _), 0.0002936792170514462) :- could_sample_soil(Rover, Waypoint), !.
delta(39, take_image(_, _, _, _, _), -0.07188715131902398) :- !.
delta(39, communicate_soil_data(_, _, Waypoint, _, _), -0.022253246784067548) :- communicated_soil_data(Waypoint), !.
delta(39, communicate_soil_data(_, _, Waypoint, _, _), -0.0005599011335324293) :- todo_communicated_soil_data(Waypoint2), visible(Waypoint, Waypoint2), !.
delta(39, communicate_soil_data(Rover, _, _, Waypoint, _), -0.00023675396351970903) :- could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint), !.
delta(39, communicate_soil_data(_, _, _, _, _), 0.037617402591683134) :- !.
delta(39, communicate_rock_data(_, _, Waypoint, _, _), 0.025681753539814722) :- fewer_have_image_1_than_have_image_3, todo_communicated_rock_data(Waypoint), !.
delta(39, communicate_rock_data(_, _, _, _, _), -9.671499890424813e-5) :- fewer_have_image_1_than_have_image_3, !.
delta(39, communicate_rock_data(_, Lander, Waypoint, _, _), 0.0174232717657709) :- at_lander(Lander, Waypoint), todo_communicated_rock_data(Waypoint), !.
delta(39, communicate_rock_data(_, Lander, Waypoint, _, _), -0.00029843376826125276) :- at_lander(Lander, Waypoint), !.
delta(39, communicate_rock_data(Rover, _, _, _, _), 0.00013035827288815938) :- todo_communicated_rock_data(Waypoint), could_take_image(Rover, Waypoint), !.
delta(39, communicate_rock_data(_, _, _, _, _), -0.08676100487347739) :- !.
delta(39, communicate_image_data(_, _, Objective, Is_mode, _, _), 0.004010498132458268) :- todo_communicated_image_data(Objective, Is_mode), !.
delta(39, communicate_image_data(_, _, _, _, _, _), -0.0074245072257707) :- !.
delta(39, _, 0.0).
