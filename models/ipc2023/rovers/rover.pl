:- module(rover, []).

% The PDDL domain rover. What no action changes is static: it belongs to the problem. So do its goals:
% goal_communicated_soil_data(W) says that communicated_soil_data(W) is wanted, condition/1 has what is wanted beyond
% such facts, and goals/1 says how many literals that is in all.

:- pddl('domain.pddl').
:- static rover/1, waypoint/1, store/1, camera/1, is_mode/1, lander/1, objective/1, at_lander/2, can_traverse/3,
     equipped_for_soil_analysis/1, equipped_for_rock_analysis/1, equipped_for_imaging/1, supports/2, visible/2,
     visible_from/2, store_of/2, calibration_target/2, on_board/2, goal_communicated_soil_data/1,
     goal_communicated_rock_data/1, goal_communicated_image_data/2, goals/1, condition/1.
:- fluent at/2, empty/1, have_rock_analysis/2, have_soil_analysis/2, full/1, calibrated/2, have_image/3,
     communicated_soil_data/1, communicated_rock_data/1, communicated_image_data/2, at_soil_sample/1, at_rock_sample/1.
:- dead_ends.
:- discontiguous action/1, effect/3.

% navigate
action(navigate(X, Y, Z)) :- at(X, Y), can_traverse(X, Y, Z), visible(Y, Z).
effect(navigate(X, Y, Z), [at(X, Y)], [at(X, Z)]).

% sample_soil
action(sample_soil(X, S, P)) :- equipped_for_soil_analysis(X), at(X, P), at_soil_sample(P), store_of(S, X), empty(S).
effect(sample_soil(X, S, P), [empty(S), at_soil_sample(P)], [full(S), have_soil_analysis(X, P)]).

% sample_rock
action(sample_rock(X, S, P)) :- equipped_for_rock_analysis(X), at(X, P), at_rock_sample(P), store_of(S, X), empty(S).
effect(sample_rock(X, S, P), [empty(S), at_rock_sample(P)], [full(S), have_rock_analysis(X, P)]).

% drop
action(drop(X, Y)) :- full(Y), store_of(Y, X).
effect(drop(_X, Y), [full(Y)], [empty(Y)]).

% calibrate
action(calibrate(R, I, T, W)) :-
    equipped_for_imaging(R),
    at(R, W),
    on_board(I, R),
    calibration_target(I, T),
    visible_from(T, W).
effect(calibrate(R, I, _T, _W), [], [calibrated(I, R)]).

% take_image
action(take_image(R, P, O, I, M)) :-
    calibrated(I, R),
    on_board(I, R),
    equipped_for_imaging(R),
    at(R, P),
    supports(I, M),
    visible_from(O, P).
effect(take_image(R, _P, O, I, M), [calibrated(I, R)], [have_image(R, O, M)]).

% communicate_soil_data
action(communicate_soil_data(R, L, P, X, Y)) :- have_soil_analysis(R, P), at_lander(L, Y), at(R, X), visible(X, Y).
effect(communicate_soil_data(_R, _L, P, _X, _Y), [], [communicated_soil_data(P)]).

% communicate_rock_data
action(communicate_rock_data(R, L, P, X, Y)) :- have_rock_analysis(R, P), at_lander(L, Y), at(R, X), visible(X, Y).
effect(communicate_rock_data(_R, _L, P, _X, _Y), [], [communicated_rock_data(P)]).

% communicate_image_data
action(communicate_image_data(R, L, O, M, X, Y)) :- have_image(R, O, M), at_lander(L, Y), at(R, X), visible(X, Y).
effect(communicate_image_data(_R, _L, O, M, _X, _Y), [], [communicated_image_data(O, M)]).

goal :-
    \+ ( goal_communicated_soil_data(W), \+ communicated_soil_data(W) ),
    \+ ( goal_communicated_rock_data(W), \+ communicated_rock_data(W) ),
    \+ ( goal_communicated_image_data(O, M), \+ communicated_image_data(O, M) ),
    \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_communicated_soil_data(W) :- goal_communicated_soil_data(W), \+ communicated_soil_data(W).
done_communicated_soil_data(W) :- goal_communicated_soil_data(W), communicated_soil_data(W).
todo_communicated_rock_data(W) :- goal_communicated_rock_data(W), \+ communicated_rock_data(W).
done_communicated_rock_data(W) :- goal_communicated_rock_data(W), communicated_rock_data(W).
todo_communicated_image_data(O, M) :- goal_communicated_image_data(O, M), \+ communicated_image_data(O, M).
done_communicated_image_data(O, M) :- goal_communicated_image_data(O, M), communicated_image_data(O, M).

% derived from the types and the actions
:- table unsettled_visible/1.
unsettled_visible(X) :- todo_communicated_soil_data(X).
unsettled_visible(X) :- todo_communicated_rock_data(X).
unsettled_visible(X) :- visible(X, Y), unsettled_visible(Y).
:- table unsettled_visible_todo_communicated_soil_data/1.
unsettled_visible_todo_communicated_soil_data(X) :- todo_communicated_soil_data(X).
unsettled_visible_todo_communicated_soil_data(X) :- visible(X, Y), unsettled_visible_todo_communicated_soil_data(Y).
:- table unsettled_visible_todo_communicated_rock_data/1.
unsettled_visible_todo_communicated_rock_data(X) :- todo_communicated_rock_data(X).
unsettled_visible_todo_communicated_rock_data(X) :- visible(X, Y), unsettled_visible_todo_communicated_rock_data(Y).
:- table beyond_visible/2.
beyond_visible(X, Y) :- visible(X, Y).
beyond_visible(X, Y) :- beyond_visible(X, Z), visible(Z, Y).
needed_have_soil_analysis_to_communicate_soil_data(Waypoint) :-
    todo_communicated_soil_data(Waypoint),
    \+ have_soil_analysis(_Rover, Waypoint).
needed_at_to_communicate_soil_data(Waypoint) :-
    once(todo_communicated_soil_data(_Waypoint2)),
    \+ ( at(_Rover, Waypoint3), visible(Waypoint3, Waypoint4), at_lander(_Lander, Waypoint4) ),
    visible(Waypoint, Waypoint5),
    once(at_lander(_Lander2, Waypoint5)).
needed_have_rock_analysis_to_communicate_rock_data(Waypoint) :-
    todo_communicated_rock_data(Waypoint),
    \+ have_rock_analysis(_Rover, Waypoint).
needed_at_to_communicate_rock_data(Waypoint) :-
    once(todo_communicated_rock_data(_Waypoint2)),
    \+ ( at(_Rover, Waypoint3), visible(Waypoint3, Waypoint4), at_lander(_Lander, Waypoint4) ),
    visible(Waypoint, Waypoint5),
    once(at_lander(_Lander2, Waypoint5)).
needed_have_image_to_communicate_image_data(Objective, Is_mode) :-
    todo_communicated_image_data(Objective, Is_mode),
    \+ have_image(_Rover, Objective, Is_mode).
needed_at_to_communicate_image_data(Waypoint) :-
    once(todo_communicated_image_data(_Objective, _Is_mode)),
    \+ ( at(_Rover, Waypoint2), visible(Waypoint2, Waypoint3), at_lander(_Lander, Waypoint3) ),
    visible(Waypoint, Waypoint4),
    once(at_lander(_Lander2, Waypoint4)).
needed_at_to_sample_soil_to_communicate_soil_data(Rover, Waypoint) :-
    needed_have_soil_analysis_to_communicate_soil_data(Waypoint),
    \+ ( at(Rover2, Waypoint), equipped_for_soil_analysis(Rover2), store_of(_Store, Rover2) ),
    equipped_for_soil_analysis(Rover),
    once(store_of(_Store2, Rover)).
needed_empty_to_sample_soil_to_communicate_soil_data(Store) :-
    once(needed_have_soil_analysis_to_communicate_soil_data(_Waypoint)),
    \+ ( empty(Store2), store_of(Store2, Rover), equipped_for_soil_analysis(Rover) ),
    store_of(Store, Rover2),
    equipped_for_soil_analysis(Rover2).
needed_at_to_sample_rock_to_communicate_rock_data(Rover, Waypoint) :-
    needed_have_rock_analysis_to_communicate_rock_data(Waypoint),
    \+ ( at(Rover2, Waypoint), equipped_for_rock_analysis(Rover2), store_of(_Store, Rover2) ),
    equipped_for_rock_analysis(Rover),
    once(store_of(_Store2, Rover)).
needed_empty_to_sample_rock_to_communicate_rock_data(Store) :-
    once(needed_have_rock_analysis_to_communicate_rock_data(_Waypoint)),
    \+ ( empty(Store2), store_of(Store2, Rover), equipped_for_rock_analysis(Rover) ),
    store_of(Store, Rover2),
    equipped_for_rock_analysis(Rover2).
needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover) :-
    on_board(Camera, Rover),
    equipped_for_imaging(Rover),
    once(( supports(Camera, Is_mode),
           once(needed_have_image_to_communicate_image_data(_Objective, Is_mode)),
           \+ ( supports(Camera2, Is_mode),
                calibrated(Camera2, Rover2),
                on_board(Camera2, Rover2),
                equipped_for_imaging(Rover2) ) )).
needed_at_to_take_image_to_communicate_image_data(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    on_board(Camera, Rover),
    visible_from(Objective, Waypoint),
    once(( needed_have_image_to_communicate_image_data(Objective, Is_mode),
           supports(Camera, Is_mode),
           \+ ( visible_from(Objective, Waypoint2),
                at(Rover2, Waypoint2),
                equipped_for_imaging(Rover2),
                on_board(Camera2, Rover2),
                supports(Camera2, Is_mode) ) )).
step_at(Rover, Waypoint, Waypoint2) :- can_traverse(Rover, Waypoint, Waypoint2), visible(Waypoint, Waypoint2).
:- table far_at(_, _, _, min).
far_at(_Rover, Z, Z, 0).
far_at(Rover, Z, X, D) :- far_at(Rover, Z, Y, D0), step_at(Rover, X, Y), D is D0+1.
:- table steps_at/4.
steps_at(Rover, X, Z, D) :- far_at(Rover, Z, Y, D), Y == X.
nearer_at(Rover, X, Y, Z) :- step_at(Rover, X, Y), steps_at(Rover, Y, Z, D), steps_at(Rover, X, Z, D0), D < D0.
could_sample_soil(Rover, Waypoint) :-
    equipped_for_soil_analysis(Rover),
    once(( store_of(Store, Rover), \+ full(Store), empty(Store) )),
    at_soil_sample(Waypoint).
:- table places_could_sample_soil/2.
places_could_sample_soil(Rover, Places) :- findall(Z, could_sample_soil(Rover, Z), Found), sort(Found, Places).
distance_could_sample_soil(Rover, X, D) :-
    places_could_sample_soil(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_sample_soil/3.
nearest_could_sample_soil(Rover, X, D) :- aggregate_all(min(D0), distance_could_sample_soil(Rover, X, D0), D).
toward_could_sample_soil(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_sample_soil(Rover, X, D),
    nearest_could_sample_soil(Rover, Y, D0),
    D0 < D.
could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Waypoint) :-
    equipped_for_soil_analysis(Rover),
    once(( store_of(Store, Rover), empty(Store) )),
    needed_have_soil_analysis_to_communicate_soil_data(Waypoint),
    at_soil_sample(Waypoint).
:- table places_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data/2.
places_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Places) :-
    findall(Z, could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, X, D) :-
    places_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data/3.
nearest_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, X,
        D0), D).
toward_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, X, D),
    nearest_could_sample_soil_needed_have_soil_analysis_to_communicate_soil_data(Rover, Y, D0),
    D0 < D.
could_sample_rock(Rover, Waypoint) :-
    equipped_for_rock_analysis(Rover),
    once(( store_of(Store, Rover), \+ full(Store), empty(Store) )),
    at_rock_sample(Waypoint).
:- table places_could_sample_rock/2.
places_could_sample_rock(Rover, Places) :- findall(Z, could_sample_rock(Rover, Z), Found), sort(Found, Places).
distance_could_sample_rock(Rover, X, D) :-
    places_could_sample_rock(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_sample_rock/3.
nearest_could_sample_rock(Rover, X, D) :- aggregate_all(min(D0), distance_could_sample_rock(Rover, X, D0), D).
toward_could_sample_rock(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_sample_rock(Rover, X, D),
    nearest_could_sample_rock(Rover, Y, D0),
    D0 < D.
could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Waypoint) :-
    equipped_for_rock_analysis(Rover),
    once(( store_of(Store, Rover), empty(Store) )),
    needed_have_rock_analysis_to_communicate_rock_data(Waypoint),
    at_rock_sample(Waypoint).
:- table places_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data/2.
places_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Places) :-
    findall(Z, could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, X, D) :-
    places_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data/3.
nearest_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, X,
        D0), D).
toward_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, X, D),
    nearest_could_sample_rock_needed_have_rock_analysis_to_communicate_rock_data(Rover, Y, D0),
    D0 < D.
could_calibrate(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    on_board(Camera, Rover),
    \+ calibrated(Camera, Rover),
    calibration_target(Camera, Objective),
    visible_from(Objective, Waypoint).
:- table places_could_calibrate/2.
places_could_calibrate(Rover, Places) :- findall(Z, could_calibrate(Rover, Z), Found), sort(Found, Places).
distance_could_calibrate(Rover, X, D) :-
    places_could_calibrate(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_calibrate/3.
nearest_could_calibrate(Rover, X, D) :- aggregate_all(min(D0), distance_could_calibrate(Rover, X, D0), D).
toward_could_calibrate(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_calibrate(Rover, X, D),
    nearest_could_calibrate(Rover, Y, D0),
    D0 < D.
could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    needed_calibrated_to_take_image_to_communicate_image_data(Camera, Rover),
    on_board(Camera, Rover),
    calibration_target(Camera, Objective),
    visible_from(Objective, Waypoint).
:- table places_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data/2.
places_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Places) :-
    findall(Z, could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, X, D) :-
    places_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data/3.
nearest_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover,
        X, D0), D).
toward_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, X, D),
    nearest_could_calibrate_needed_calibrated_to_take_image_to_communicate_image_data(Rover, Y, D0),
    D0 < D.
could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    on_board(Camera, Rover),
    \+ calibrated(Camera, Rover),
    calibration_target(Camera, Objective),
    once(todo_communicated_image_data(Objective, _Is_mode)),
    visible_from(Objective, Waypoint).
:- table places_could_calibrate_for_todo_communicated_image_data_objective_any/2.
places_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Places) :-
    findall(Z, could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Z), Found),
    sort(Found, Places).
distance_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, X, D) :-
    places_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_calibrate_for_todo_communicated_image_data_objective_any/3.
nearest_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, X, D0), D).
toward_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, X, D),
    nearest_could_calibrate_for_todo_communicated_image_data_objective_any(Rover, Y, D0),
    D0 < D.
could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    on_board(Camera, Rover),
    \+ calibrated(Camera, Rover),
    once(( supports(Camera, Is_mode), once(todo_communicated_image_data(_Objective, Is_mode)) )),
    calibration_target(Camera, Objective2),
    visible_from(Objective2, Waypoint).
:- table places_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera/2.
places_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Places) :-
    findall(Z, could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Z), Found),
    sort(Found, Places).
distance_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, X, D) :-
    places_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera/3.
nearest_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover,
        X, D0), D).
toward_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, X, D),
    nearest_could_calibrate_through_supports_for_todo_communicated_image_data_2_camera(Rover, Y, D0),
    D0 < D.
could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    on_board(Camera, Rover),
    \+ calibrated(Camera, Rover),
    calibration_target(Camera, Objective),
    visible_from(Objective, Waypoint),
    once(( visible_from(Objective2, Waypoint), once(todo_communicated_image_data(Objective2, _Is_mode)) )).
:- table places_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint/2.
places_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Places) :-
    findall(Z, could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Z), Found),
    sort(Found, Places).
distance_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, D) :-
    places_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint/3.
nearest_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, D) :-
    aggregate_all(min(D0),
        distance_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, D0),
        D).
toward_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, D),
    nearest_could_calibrate_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Y, D0),
    D0 < D.
could_take_image(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    calibrated(Camera, Rover),
    on_board(Camera, Rover),
    supports(Camera, Is_mode),
    visible_from(Objective, Waypoint),
    \+ have_image(Rover, Objective, Is_mode).
:- table places_could_take_image/2.
places_could_take_image(Rover, Places) :- findall(Z, could_take_image(Rover, Z), Found), sort(Found, Places).
distance_could_take_image(Rover, X, D) :-
    places_could_take_image(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_take_image/3.
nearest_could_take_image(Rover, X, D) :- aggregate_all(min(D0), distance_could_take_image(Rover, X, D0), D).
toward_could_take_image(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_take_image(Rover, X, D),
    nearest_could_take_image(Rover, Y, D0),
    D0 < D.
could_take_image_needed_have_image_to_communicate_image_data(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    calibrated(Camera, Rover),
    on_board(Camera, Rover),
    supports(Camera, Is_mode),
    needed_have_image_to_communicate_image_data(Objective, Is_mode),
    visible_from(Objective, Waypoint).
:- table places_could_take_image_needed_have_image_to_communicate_image_data/2.
places_could_take_image_needed_have_image_to_communicate_image_data(Rover, Places) :-
    findall(Z, could_take_image_needed_have_image_to_communicate_image_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_take_image_needed_have_image_to_communicate_image_data(Rover, X, D) :-
    places_could_take_image_needed_have_image_to_communicate_image_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_take_image_needed_have_image_to_communicate_image_data/3.
nearest_could_take_image_needed_have_image_to_communicate_image_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_take_image_needed_have_image_to_communicate_image_data(Rover, X, D0), D).
toward_could_take_image_needed_have_image_to_communicate_image_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_take_image_needed_have_image_to_communicate_image_data(Rover, X, D),
    nearest_could_take_image_needed_have_image_to_communicate_image_data(Rover, Y, D0),
    D0 < D.
could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    calibrated(Camera, Rover),
    on_board(Camera, Rover),
    supports(Camera, Is_mode),
    once(todo_communicated_image_data(_Objective, Is_mode)),
    visible_from(Objective2, Waypoint),
    \+ have_image(Rover, Objective2, Is_mode).
:- table places_could_take_image_for_todo_communicated_image_data_any_is_mode/2.
places_could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Places) :-
    findall(Z, could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Z), Found),
    sort(Found, Places).
distance_could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, X, D) :-
    places_could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_take_image_for_todo_communicated_image_data_any_is_mode/3.
nearest_could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, X, D0), D).
toward_could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, X, D),
    nearest_could_take_image_for_todo_communicated_image_data_any_is_mode(Rover, Y, D0),
    D0 < D.
could_take_image_for_todo_communicated_image_data_objective_any(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    calibrated(Camera, Rover),
    on_board(Camera, Rover),
    supports(Camera, Is_mode),
    todo_communicated_image_data(Objective, _Is_mode2),
    \+ have_image(Rover, Objective, Is_mode),
    visible_from(Objective, Waypoint).
:- table places_could_take_image_for_todo_communicated_image_data_objective_any/2.
places_could_take_image_for_todo_communicated_image_data_objective_any(Rover, Places) :-
    findall(Z, could_take_image_for_todo_communicated_image_data_objective_any(Rover, Z), Found),
    sort(Found, Places).
distance_could_take_image_for_todo_communicated_image_data_objective_any(Rover, X, D) :-
    places_could_take_image_for_todo_communicated_image_data_objective_any(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_take_image_for_todo_communicated_image_data_objective_any/3.
nearest_could_take_image_for_todo_communicated_image_data_objective_any(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_take_image_for_todo_communicated_image_data_objective_any(Rover, X, D0), D).
toward_could_take_image_for_todo_communicated_image_data_objective_any(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_take_image_for_todo_communicated_image_data_objective_any(Rover, X, D),
    nearest_could_take_image_for_todo_communicated_image_data_objective_any(Rover, Y, D0),
    D0 < D.
could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    calibrated(Camera, Rover),
    on_board(Camera, Rover),
    once(( supports(Camera, Is_mode), once(todo_communicated_image_data(_Objective, Is_mode)) )),
    supports(Camera, Is_mode2),
    visible_from(Objective2, Waypoint),
    \+ have_image(Rover, Objective2, Is_mode2).
:- table places_could_take_image_through_supports_for_todo_communicated_image_data_2_camera/2.
places_could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, Places) :-
    findall(Z, could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, Z), Found),
    sort(Found, Places).
distance_could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, X, D) :-
    places_could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_take_image_through_supports_for_todo_communicated_image_data_2_camera/3.
nearest_could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover,
        X, D0), D).
toward_could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, X, D),
    nearest_could_take_image_through_supports_for_todo_communicated_image_data_2_camera(Rover, Y, D0),
    D0 < D.
could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    calibrated(Camera, Rover),
    on_board(Camera, Rover),
    supports(Camera, Is_mode),
    visible_from(Objective, Waypoint),
    once(todo_communicated_image_data(Objective, _Is_mode2)),
    once(( visible_from(Objective2, Waypoint), \+ have_image(Rover, Objective2, Is_mode) )).
:- table places_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint/2.
places_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Places) :-
    findall(Z, could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Z), Found),
    sort(Found, Places).
distance_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, D) :-
    places_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint/3.
nearest_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, D) :-
    aggregate_all(min(D0),
        distance_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, D0),
        D).
toward_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, D),
    nearest_could_take_image_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Y, D0),
    D0 < D.
could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Waypoint) :-
    equipped_for_imaging(Rover),
    calibrated(Camera, Rover),
    on_board(Camera, Rover),
    once(( calibration_target(Camera, Objective), once(todo_communicated_image_data(Objective, _Is_mode)) )),
    supports(Camera, Is_mode2),
    visible_from(Objective2, Waypoint),
    \+ have_image(Rover, Objective2, Is_mode2).
:- table places_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera/2.
places_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Places) :-
    findall(Z, could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Z), Found),
    sort(Found, Places).
distance_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, X, D) :-
    places_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera/3.
nearest_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, X, D) :-
    aggregate_all(min(D0),
        distance_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, X, D0),
        D).
toward_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, X, D),
    nearest_could_take_image_through_calibration_target_for_todo_communicated_image_data_1_camera(Rover, Y, D0),
    D0 < D.
could_communicate_soil_data(Rover, Waypoint) :-
    have_soil_analysis(Rover, Waypoint2),
    \+ communicated_soil_data(Waypoint2),
    at_lander(_Lander, Waypoint3),
    visible(Waypoint, Waypoint3).
:- table places_could_communicate_soil_data/2.
places_could_communicate_soil_data(Rover, Places) :-
    findall(Z, could_communicate_soil_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_soil_data(Rover, X, D) :-
    places_could_communicate_soil_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_soil_data/3.
nearest_could_communicate_soil_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_soil_data(Rover, X, D0), D).
toward_could_communicate_soil_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_soil_data(Rover, X, D),
    nearest_could_communicate_soil_data(Rover, Y, D0),
    D0 < D.
could_communicate_soil_data_todo_communicated_soil_data(Rover, Waypoint) :-
    have_soil_analysis(Rover, Waypoint2),
    todo_communicated_soil_data(Waypoint2),
    at_lander(_Lander, Waypoint3),
    visible(Waypoint, Waypoint3).
:- table places_could_communicate_soil_data_todo_communicated_soil_data/2.
places_could_communicate_soil_data_todo_communicated_soil_data(Rover, Places) :-
    findall(Z, could_communicate_soil_data_todo_communicated_soil_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_soil_data_todo_communicated_soil_data(Rover, X, D) :-
    places_could_communicate_soil_data_todo_communicated_soil_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_soil_data_todo_communicated_soil_data/3.
nearest_could_communicate_soil_data_todo_communicated_soil_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_soil_data_todo_communicated_soil_data(Rover, X, D0), D).
toward_could_communicate_soil_data_todo_communicated_soil_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_soil_data_todo_communicated_soil_data(Rover, X, D),
    nearest_could_communicate_soil_data_todo_communicated_soil_data(Rover, Y, D0),
    D0 < D.
could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, Waypoint) :-
    have_soil_analysis(Rover, Waypoint2),
    \+ communicated_soil_data(Waypoint2),
    todo_communicated_soil_data(Waypoint),
    once(( visible(Waypoint, Waypoint3), once(at_lander(_Lander, Waypoint3)) )).
:- table places_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint/2.
places_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, Places) :-
    findall(Z, could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, X, D) :-
    places_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint/3.
nearest_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, X,
        D0), D).
toward_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, X, D),
    nearest_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint(Rover, Y, D0),
    D0 < D.
could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, Waypoint) :-
    have_soil_analysis(Rover, Waypoint2),
    \+ communicated_soil_data(Waypoint2),
    todo_communicated_soil_data(Waypoint3),
    once(at_lander(_Lander, Waypoint3)),
    visible(Waypoint, Waypoint3).
:- table places_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2/2.
places_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, Places) :-
    findall(Z, could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, X, D) :-
    places_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2/3.
nearest_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, X,
        D0), D).
toward_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, X, D),
    nearest_could_communicate_soil_data_for_todo_communicated_soil_data_waypoint_2(Rover, Y, D0),
    D0 < D.
could_communicate_rock_data(Rover, Waypoint) :-
    have_rock_analysis(Rover, Waypoint2),
    \+ communicated_rock_data(Waypoint2),
    at_lander(_Lander, Waypoint3),
    visible(Waypoint, Waypoint3).
:- table places_could_communicate_rock_data/2.
places_could_communicate_rock_data(Rover, Places) :-
    findall(Z, could_communicate_rock_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_rock_data(Rover, X, D) :-
    places_could_communicate_rock_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_rock_data/3.
nearest_could_communicate_rock_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_rock_data(Rover, X, D0), D).
toward_could_communicate_rock_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_rock_data(Rover, X, D),
    nearest_could_communicate_rock_data(Rover, Y, D0),
    D0 < D.
could_communicate_rock_data_todo_communicated_rock_data(Rover, Waypoint) :-
    have_rock_analysis(Rover, Waypoint2),
    todo_communicated_rock_data(Waypoint2),
    at_lander(_Lander, Waypoint3),
    visible(Waypoint, Waypoint3).
:- table places_could_communicate_rock_data_todo_communicated_rock_data/2.
places_could_communicate_rock_data_todo_communicated_rock_data(Rover, Places) :-
    findall(Z, could_communicate_rock_data_todo_communicated_rock_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_rock_data_todo_communicated_rock_data(Rover, X, D) :-
    places_could_communicate_rock_data_todo_communicated_rock_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_rock_data_todo_communicated_rock_data/3.
nearest_could_communicate_rock_data_todo_communicated_rock_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_rock_data_todo_communicated_rock_data(Rover, X, D0), D).
toward_could_communicate_rock_data_todo_communicated_rock_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_rock_data_todo_communicated_rock_data(Rover, X, D),
    nearest_could_communicate_rock_data_todo_communicated_rock_data(Rover, Y, D0),
    D0 < D.
could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Waypoint) :-
    have_rock_analysis(Rover, Waypoint2),
    \+ communicated_rock_data(Waypoint2),
    todo_communicated_rock_data(Waypoint),
    once(( visible(Waypoint, Waypoint3), once(at_lander(_Lander, Waypoint3)) )).
:- table places_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint/2.
places_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Places) :-
    findall(Z, could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, X, D) :-
    places_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint/3.
nearest_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, X,
        D0), D).
toward_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, X, D),
    nearest_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint(Rover, Y, D0),
    D0 < D.
could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, Waypoint) :-
    have_rock_analysis(Rover, Waypoint2),
    \+ communicated_rock_data(Waypoint2),
    todo_communicated_rock_data(Waypoint3),
    once(at_lander(_Lander, Waypoint3)),
    visible(Waypoint, Waypoint3).
:- table places_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2/2.
places_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, Places) :-
    findall(Z, could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, X, D) :-
    places_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2/3.
nearest_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, X,
        D0), D).
toward_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, X, D),
    nearest_could_communicate_rock_data_for_todo_communicated_rock_data_waypoint_2(Rover, Y, D0),
    D0 < D.
could_communicate_image_data(Rover, Waypoint) :-
    have_image(Rover, Objective, Is_mode),
    \+ communicated_image_data(Objective, Is_mode),
    at_lander(_Lander, Waypoint2),
    visible(Waypoint, Waypoint2).
:- table places_could_communicate_image_data/2.
places_could_communicate_image_data(Rover, Places) :-
    findall(Z, could_communicate_image_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_image_data(Rover, X, D) :-
    places_could_communicate_image_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_image_data/3.
nearest_could_communicate_image_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_image_data(Rover, X, D0), D).
toward_could_communicate_image_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_image_data(Rover, X, D),
    nearest_could_communicate_image_data(Rover, Y, D0),
    D0 < D.
could_communicate_image_data_todo_communicated_image_data(Rover, Waypoint) :-
    have_image(Rover, Objective, Is_mode),
    todo_communicated_image_data(Objective, Is_mode),
    at_lander(_Lander, Waypoint2),
    visible(Waypoint, Waypoint2).
:- table places_could_communicate_image_data_todo_communicated_image_data/2.
places_could_communicate_image_data_todo_communicated_image_data(Rover, Places) :-
    findall(Z, could_communicate_image_data_todo_communicated_image_data(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_image_data_todo_communicated_image_data(Rover, X, D) :-
    places_could_communicate_image_data_todo_communicated_image_data(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_image_data_todo_communicated_image_data/3.
nearest_could_communicate_image_data_todo_communicated_image_data(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_image_data_todo_communicated_image_data(Rover, X, D0), D).
toward_could_communicate_image_data_todo_communicated_image_data(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_image_data_todo_communicated_image_data(Rover, X, D),
    nearest_could_communicate_image_data_todo_communicated_image_data(Rover, Y, D0),
    D0 < D.
could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Waypoint) :-
    have_image(Rover, Objective, Is_mode),
    \+ communicated_image_data(Objective, Is_mode),
    once(todo_communicated_image_data(_Objective2, Is_mode)),
    at_lander(_Lander, Waypoint2),
    visible(Waypoint, Waypoint2).
:- table places_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode/2.
places_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Places) :-
    findall(Z, could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, X, D) :-
    places_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode/3.
nearest_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover,
        X, D0), D).
toward_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, X, D),
    nearest_could_communicate_image_data_for_todo_communicated_image_data_any_is_mode(Rover, Y, D0),
    D0 < D.
could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, Waypoint) :-
    have_image(Rover, Objective, Is_mode),
    \+ communicated_image_data(Objective, Is_mode),
    once(todo_communicated_image_data(Objective, _Is_mode2)),
    at_lander(_Lander, Waypoint2),
    visible(Waypoint, Waypoint2).
:- table places_could_communicate_image_data_for_todo_communicated_image_data_objective_any/2.
places_could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, Places) :-
    findall(Z, could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, Z), Found),
    sort(Found, Places).
distance_could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, X, D) :-
    places_could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_image_data_for_todo_communicated_image_data_objective_any/3.
nearest_could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, X, D) :-
    aggregate_all(min(D0), distance_could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover,
        X, D0), D).
toward_could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, X, Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, X, D),
    nearest_could_communicate_image_data_for_todo_communicated_image_data_objective_any(Rover, Y, D0),
    D0 < D.
could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Waypoint) :-
    have_image(Rover, Objective, Is_mode),
    \+ communicated_image_data(Objective, Is_mode),
    visible_from(Objective2, Waypoint),
    once(todo_communicated_image_data(Objective2, _Is_mode2)),
    once(( visible(Waypoint, Waypoint2), once(at_lander(_Lander, Waypoint2)) )).
:- table places_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint/2.
places_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover,
       Places) :-
    findall(Z,
        could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, Z),
        Found),
    sort(Found, Places).
distance_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X,
       D) :-
    places_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover,
        Places),
    member(Z, Places),
    steps_at(Rover, X, Z, D).
:- table nearest_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint/3.
nearest_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X,
       D) :-
    aggregate_all(min(D0),
        distance_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X, D0), D).
toward_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover, X,
       Y) :-
    step_at(Rover, X, Y),
    nearest_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover,
        X, D),
    nearest_could_communicate_image_data_through_visible_from_back_for_todo_communicated_image_data_1_waypoint(Rover,
        Y, D0),
    D0 < D.
:- table number_have_soil_analysis_1/1.
number_have_soil_analysis_1(N) :- findall(X, have_soil_analysis(X, _Waypoint), Found), sort(Found, Set), length(Set, N).
:- table number_todo_communicated_soil_data/1.
number_todo_communicated_soil_data(N) :-
    findall(X, todo_communicated_soil_data(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_have_soil_analysis_1_than_todo_communicated_soil_data :-
    number_have_soil_analysis_1(N),
    number_todo_communicated_soil_data(M),
    N < M.
:- table number_have_soil_analysis_2/1.
number_have_soil_analysis_2(N) :- findall(X, have_soil_analysis(_Rover, X), Found), sort(Found, Set), length(Set, N).
fewer_have_soil_analysis_1_than_have_soil_analysis_2 :-
    number_have_soil_analysis_1(N),
    number_have_soil_analysis_2(M),
    N < M.
both_todo_communicated_soil_data_have_soil_analysis_2(X) :-
    todo_communicated_soil_data(X),
    have_soil_analysis(_Rover, X).
:- table number_todo_communicated_soil_data_have_soil_analysis_2/1.
number_todo_communicated_soil_data_have_soil_analysis_2(N) :-
    findall(X, both_todo_communicated_soil_data_have_soil_analysis_2(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_have_soil_analysis_1_than_todo_communicated_soil_data_have_soil_analysis_2 :-
    number_have_soil_analysis_1(N),
    number_todo_communicated_soil_data_have_soil_analysis_2(M),
    N < M.
:- table number_at_1/1.
number_at_1(N) :- findall(X, at(X, _Waypoint), Found), sort(Found, Set), length(Set, N).
fewer_at_1_than_todo_communicated_soil_data :- number_at_1(N), number_todo_communicated_soil_data(M), N < M.
fewer_at_1_than_have_soil_analysis_2 :- number_at_1(N), number_have_soil_analysis_2(M), N < M.
:- table number_at_2/1.
number_at_2(N) :- findall(X, at(_Rover, X), Found), sort(Found, Set), length(Set, N).
fewer_at_2_than_todo_communicated_soil_data :- number_at_2(N), number_todo_communicated_soil_data(M), N < M.
fewer_at_2_than_have_soil_analysis_2 :- number_at_2(N), number_have_soil_analysis_2(M), N < M.
fewer_at_2_than_todo_communicated_soil_data_have_soil_analysis_2 :-
    number_at_2(N),
    number_todo_communicated_soil_data_have_soil_analysis_2(M),
    N < M.
:- table number_have_rock_analysis_1/1.
number_have_rock_analysis_1(N) :- findall(X, have_rock_analysis(X, _Waypoint), Found), sort(Found, Set), length(Set, N).
:- table number_todo_communicated_rock_data/1.
number_todo_communicated_rock_data(N) :-
    findall(X, todo_communicated_rock_data(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_have_rock_analysis_1_than_todo_communicated_rock_data :-
    number_have_rock_analysis_1(N),
    number_todo_communicated_rock_data(M),
    N < M.
:- table number_have_rock_analysis_2/1.
number_have_rock_analysis_2(N) :- findall(X, have_rock_analysis(_Rover, X), Found), sort(Found, Set), length(Set, N).
fewer_have_rock_analysis_1_than_have_rock_analysis_2 :-
    number_have_rock_analysis_1(N),
    number_have_rock_analysis_2(M),
    N < M.
both_todo_communicated_rock_data_have_rock_analysis_2(X) :-
    todo_communicated_rock_data(X),
    have_rock_analysis(_Rover, X).
:- table number_todo_communicated_rock_data_have_rock_analysis_2/1.
number_todo_communicated_rock_data_have_rock_analysis_2(N) :-
    findall(X, both_todo_communicated_rock_data_have_rock_analysis_2(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_have_rock_analysis_1_than_todo_communicated_rock_data_have_rock_analysis_2 :-
    number_have_rock_analysis_1(N),
    number_todo_communicated_rock_data_have_rock_analysis_2(M),
    N < M.
fewer_at_1_than_todo_communicated_rock_data :- number_at_1(N), number_todo_communicated_rock_data(M), N < M.
fewer_at_1_than_have_rock_analysis_2 :- number_at_1(N), number_have_rock_analysis_2(M), N < M.
fewer_at_2_than_todo_communicated_rock_data :- number_at_2(N), number_todo_communicated_rock_data(M), N < M.
fewer_at_2_than_have_rock_analysis_2 :- number_at_2(N), number_have_rock_analysis_2(M), N < M.
fewer_at_2_than_todo_communicated_rock_data_have_rock_analysis_2 :-
    number_at_2(N),
    number_todo_communicated_rock_data_have_rock_analysis_2(M),
    N < M.
:- table number_have_image_1/1.
number_have_image_1(N) :- findall(X, have_image(X, _Objective, _Is_mode), Found), sort(Found, Set), length(Set, N).
:- table number_todo_communicated_image_data_1/1.
number_todo_communicated_image_data_1(N) :-
    findall(X, todo_communicated_image_data(X, _Is_mode), Found),
    sort(Found, Set),
    length(Set, N).
fewer_have_image_1_than_todo_communicated_image_data_1 :-
    number_have_image_1(N),
    number_todo_communicated_image_data_1(M),
    N < M.
:- table number_have_image_2/1.
number_have_image_2(N) :- findall(X, have_image(_Rover, X, _Is_mode), Found), sort(Found, Set), length(Set, N).
fewer_have_image_1_than_have_image_2 :- number_have_image_1(N), number_have_image_2(M), N < M.
both_todo_communicated_image_data_1_have_image_2(X) :-
    todo_communicated_image_data(X, _Is_mode),
    have_image(_Rover, X, _Is_mode2).
:- table number_todo_communicated_image_data_1_have_image_2/1.
number_todo_communicated_image_data_1_have_image_2(N) :-
    findall(X, both_todo_communicated_image_data_1_have_image_2(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_have_image_1_than_todo_communicated_image_data_1_have_image_2 :-
    number_have_image_1(N),
    number_todo_communicated_image_data_1_have_image_2(M),
    N < M.
fewer_at_1_than_todo_communicated_image_data_1 :- number_at_1(N), number_todo_communicated_image_data_1(M), N < M.
fewer_at_1_than_have_image_2 :- number_at_1(N), number_have_image_2(M), N < M.
fewer_at_1_than_todo_communicated_image_data_1_have_image_2 :-
    number_at_1(N),
    number_todo_communicated_image_data_1_have_image_2(M),
    N < M.
:- table number_todo_communicated_image_data_2/1.
number_todo_communicated_image_data_2(N) :-
    findall(X, todo_communicated_image_data(_Objective, X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_have_image_1_than_todo_communicated_image_data_2 :-
    number_have_image_1(N),
    number_todo_communicated_image_data_2(M),
    N < M.
:- table number_have_image_3/1.
number_have_image_3(N) :- findall(X, have_image(_Rover, _Objective, X), Found), sort(Found, Set), length(Set, N).
fewer_have_image_1_than_have_image_3 :- number_have_image_1(N), number_have_image_3(M), N < M.
both_todo_communicated_image_data_2_have_image_3(X) :-
    todo_communicated_image_data(_Objective, X),
    have_image(_Rover, _Objective2, X).
:- table number_todo_communicated_image_data_2_have_image_3/1.
number_todo_communicated_image_data_2_have_image_3(N) :-
    findall(X, both_todo_communicated_image_data_2_have_image_3(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_have_image_1_than_todo_communicated_image_data_2_have_image_3 :-
    number_have_image_1(N),
    number_todo_communicated_image_data_2_have_image_3(M),
    N < M.
fewer_at_1_than_todo_communicated_image_data_2 :- number_at_1(N), number_todo_communicated_image_data_2(M), N < M.
fewer_at_1_than_have_image_3 :- number_at_1(N), number_have_image_3(M), N < M.
fewer_at_1_than_todo_communicated_image_data_2_have_image_3 :-
    number_at_1(N),
    number_todo_communicated_image_data_2_have_image_3(M),
    N < M.
fewer_at_2_than_todo_communicated_image_data_1 :- number_at_2(N), number_todo_communicated_image_data_1(M), N < M.
fewer_at_2_than_have_image_2 :- number_at_2(N), number_have_image_2(M), N < M.
fewer_at_2_than_todo_communicated_image_data_1_have_image_2 :-
    number_at_2(N),
    number_todo_communicated_image_data_1_have_image_2(M),
    N < M.
fewer_at_2_than_todo_communicated_image_data_2 :- number_at_2(N), number_todo_communicated_image_data_2(M), N < M.
fewer_at_2_than_have_image_3 :- number_at_2(N), number_have_image_3(M), N < M.
fewer_at_2_than_todo_communicated_image_data_2_have_image_3 :-
    number_at_2(N),
    number_todo_communicated_image_data_2_have_image_3(M),
    N < M.
