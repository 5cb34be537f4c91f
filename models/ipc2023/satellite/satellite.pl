:- module(satellite, []).

% The PDDL domain satellite. What no action changes is static: it belongs to the problem. So do its goals:
% goal_pointing(S, D) says that pointing(S, D) is wanted, condition/1 has what is wanted beyond such facts, and goals/1
% says how many literals that is in all.

:- pddl('domain.pddl').
:- static satellite/1, direction/1, instrument/1, is_mode/1, on_board/2, supports/2, calibration_target/2,
     goal_pointing/2, goal_have_image/2, goals/1, condition/1.
:- fluent pointing/2, power_avail/1, power_on/1, calibrated/1, have_image/2.
:- dead_ends.
:- discontiguous action/1, effect/3.

% turn_to
action(turn_to(S, D_new, D_prev)) :- pointing(S, D_prev), direction(D_new), \+ pointing(S, D_new).
effect(turn_to(S, D_new, D_prev), [pointing(S, D_prev)], [pointing(S, D_new)]).

% switch_on
action(switch_on(I, S)) :- power_avail(S), on_board(I, S).
effect(switch_on(I, S), [calibrated(I), power_avail(S)], [power_on(I)]).

% switch_off
action(switch_off(I, S)) :- power_on(I), on_board(I, S).
effect(switch_off(I, S), [power_on(I)], [power_avail(S)]).

% calibrate
action(calibrate(S, I, D)) :- power_on(I), on_board(I, S), pointing(S, D), calibration_target(I, D).
effect(calibrate(_S, I, _D), [], [calibrated(I)]).

% take_image
action(take_image(S, D, I, M)) :- calibrated(I), power_on(I), on_board(I, S), pointing(S, D), supports(I, M).
effect(take_image(_S, D, _I, M), [], [have_image(D, M)]).

goal :-
    \+ ( goal_pointing(S, D), \+ pointing(S, D) ),
    \+ ( goal_have_image(D, M), \+ have_image(D, M) ),
    \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_pointing(S, D) :- goal_pointing(S, D), \+ pointing(S, D).
done_pointing(S, D) :- goal_pointing(S, D), pointing(S, D).
todo_have_image(D, M) :- goal_have_image(D, M), \+ have_image(D, M).
done_have_image(D, M) :- goal_have_image(D, M), have_image(D, M).

% derived from the types and the actions
needed_calibrated_to_take_image(Instrument) :-
    on_board(Instrument, _Satellite),
    once(( supports(Instrument, Is_mode),
           once(todo_have_image(_Direction, Is_mode)),
           \+ ( supports(Instrument2, Is_mode), calibrated(Instrument2), on_board(Instrument2, _Satellite2) ) )).
needed_power_on_to_take_image(Instrument) :-
    on_board(Instrument, _Satellite),
    once(( supports(Instrument, Is_mode),
           once(todo_have_image(_Direction, Is_mode)),
           \+ ( supports(Instrument2, Is_mode), power_on(Instrument2), on_board(Instrument2, _Satellite2) ) )).
needed_pointing_to_take_image(Satellite, Direction) :-
    todo_have_image(Direction, Is_mode),
    \+ ( pointing(Satellite2, Direction), on_board(Instrument, Satellite2), supports(Instrument, Is_mode) ),
    on_board(Instrument2, Satellite),
    supports(Instrument2, Is_mode).
needed_power_on_to_calibrate_to_take_image(Instrument) :-
    needed_calibrated_to_take_image(Instrument),
    \+ power_on(Instrument).
needed_pointing_to_calibrate_to_take_image(Satellite, Direction) :-
    on_board(Instrument, Satellite),
    calibration_target(Instrument, Direction),
    needed_calibrated_to_take_image(Instrument),
    \+ ( on_board(Instrument, Satellite2),
         pointing(Satellite2, Direction2),
         calibration_target(Instrument, Direction2) ).
needed_power_avail_to_switch_on_to_take_image(Satellite) :-
    on_board(Instrument, Satellite),
    needed_power_on_to_take_image(Instrument),
    \+ ( on_board(Instrument, Satellite2), power_avail(Satellite2) ).
wanted_pointing(Satellite, Z) :- todo_pointing(Satellite, Z).
could_calibrate(Satellite, Direction) :-
    on_board(Instrument, Satellite),
    \+ calibrated(Instrument),
    calibration_target(Instrument, Direction),
    power_on(Instrument).
could_calibrate_needed_calibrated_to_take_image(Satellite, Direction) :-
    on_board(Instrument, Satellite),
    calibration_target(Instrument, Direction),
    needed_calibrated_to_take_image(Instrument),
    power_on(Instrument).
could_calibrate_for_todo_have_image_direction_any(Satellite, Direction) :-
    todo_have_image(Direction, _Is_mode),
    on_board(Instrument, Satellite),
    \+ calibrated(Instrument),
    calibration_target(Instrument, Direction),
    power_on(Instrument).
could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction) :-
    on_board(Instrument, Satellite),
    \+ calibrated(Instrument),
    calibration_target(Instrument, Direction),
    power_on(Instrument),
    once(( supports(Instrument, Is_mode), once(todo_have_image(_Direction2, Is_mode)) )).
could_take_image(Satellite, Direction) :-
    on_board(Instrument, Satellite),
    calibrated(Instrument),
    power_on(Instrument),
    supports(Instrument, Is_mode),
    \+ have_image(Direction, Is_mode).
could_take_image_todo_have_image(Satellite, Direction) :-
    todo_have_image(Direction, Is_mode),
    on_board(Instrument, Satellite),
    supports(Instrument, Is_mode),
    calibrated(Instrument),
    power_on(Instrument).
could_take_image_for_todo_have_image_any_is_mode(Satellite, Direction) :-
    on_board(Instrument, Satellite),
    calibrated(Instrument),
    power_on(Instrument),
    supports(Instrument, Is_mode),
    \+ have_image(Direction, Is_mode),
    once(todo_have_image(_Direction2, Is_mode)).
could_take_image_for_todo_have_image_direction_any(Satellite, Direction) :-
    todo_have_image(Direction, _Is_mode),
    on_board(Instrument, Satellite),
    calibrated(Instrument),
    power_on(Instrument),
    once(( supports(Instrument, Is_mode2), \+ have_image(Direction, Is_mode2) )).
could_take_image_through_calibration_target_for_todo_have_image_1_instrument(Satellite, Direction) :-
    on_board(Instrument, Satellite),
    calibrated(Instrument),
    power_on(Instrument),
    once(( calibration_target(Instrument, Direction2), once(todo_have_image(Direction2, _Is_mode)) )),
    supports(Instrument, Is_mode2),
    \+ have_image(Direction, Is_mode2).
:- table number_pointing_2/1.
number_pointing_2(N) :- findall(X, pointing(_Satellite, X), Found), sort(Found, Set), length(Set, N).
:- table number_todo_pointing_1/1.
number_todo_pointing_1(N) :- findall(X, todo_pointing(X, _Direction), Found), sort(Found, Set), length(Set, N).
fewer_pointing_2_than_todo_pointing_1 :- number_pointing_2(N), number_todo_pointing_1(M), N < M.
:- table number_pointing_1/1.
number_pointing_1(N) :- findall(X, pointing(X, _Direction), Found), sort(Found, Set), length(Set, N).
fewer_pointing_2_than_pointing_1 :- number_pointing_2(N), number_pointing_1(M), N < M.
:- table number_todo_pointing_2/1.
number_todo_pointing_2(N) :- findall(X, todo_pointing(_Satellite, X), Found), sort(Found, Set), length(Set, N).
fewer_pointing_2_than_todo_pointing_2 :- number_pointing_2(N), number_todo_pointing_2(M), N < M.
:- table number_todo_have_image_1/1.
number_todo_have_image_1(N) :- findall(X, todo_have_image(X, _Is_mode), Found), sort(Found, Set), length(Set, N).
fewer_pointing_1_than_todo_have_image_1 :- number_pointing_1(N), number_todo_have_image_1(M), N < M.
:- table number_calibrated/1.
number_calibrated(N) :- findall(X, calibrated(X), Found), sort(Found, Set), length(Set, N).
fewer_calibrated_than_todo_have_image_1 :- number_calibrated(N), number_todo_have_image_1(M), N < M.
fewer_calibrated_than_pointing_2 :- number_calibrated(N), number_pointing_2(M), N < M.
both_todo_have_image_1_pointing_2(X) :- todo_have_image(X, _Is_mode), pointing(_Satellite, X).
:- table number_todo_have_image_1_pointing_2/1.
number_todo_have_image_1_pointing_2(N) :-
    findall(X, both_todo_have_image_1_pointing_2(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_calibrated_than_todo_have_image_1_pointing_2 :-
    number_calibrated(N),
    number_todo_have_image_1_pointing_2(M),
    N < M.
:- table number_power_on/1.
number_power_on(N) :- findall(X, power_on(X), Found), sort(Found, Set), length(Set, N).
fewer_power_on_than_todo_have_image_1 :- number_power_on(N), number_todo_have_image_1(M), N < M.
fewer_power_on_than_pointing_2 :- number_power_on(N), number_pointing_2(M), N < M.
fewer_power_on_than_todo_have_image_1_pointing_2 :- number_power_on(N), number_todo_have_image_1_pointing_2(M), N < M.
both_calibrated_power_on(X) :- calibrated(X), power_on(X).
:- table number_calibrated_power_on/1.
number_calibrated_power_on(N) :- findall(X, both_calibrated_power_on(X), Found), sort(Found, Set), length(Set, N).
fewer_calibrated_power_on_than_todo_have_image_1 :- number_calibrated_power_on(N), number_todo_have_image_1(M), N < M.
fewer_calibrated_power_on_than_pointing_2 :- number_calibrated_power_on(N), number_pointing_2(M), N < M.
fewer_calibrated_power_on_than_todo_have_image_1_pointing_2 :-
    number_calibrated_power_on(N),
    number_todo_have_image_1_pointing_2(M),
    N < M.
:- table number_todo_have_image_2/1.
number_todo_have_image_2(N) :- findall(X, todo_have_image(_Direction, X), Found), sort(Found, Set), length(Set, N).
fewer_calibrated_than_todo_have_image_2 :- number_calibrated(N), number_todo_have_image_2(M), N < M.
fewer_power_on_than_todo_have_image_2 :- number_power_on(N), number_todo_have_image_2(M), N < M.
fewer_calibrated_power_on_than_todo_have_image_2 :- number_calibrated_power_on(N), number_todo_have_image_2(M), N < M.
