:- module(floortile, []).

% The PDDL domain floortile. What no action changes is static: it belongs to the problem. So do its goals:
% goal_painted(X, C) says that painted(X, C) is wanted, condition/1 has what is wanted beyond such facts, and goals/1
% says how many literals that is in all.

:- pddl('domain.pddl').
:- static robot/1, tile/1, color/1, up/2, down/2, right/2, left/2, available_color/1, free_color/1, goal_painted/2,
     goals/1, condition/1.
:- fluent robot_at/2, clear/1, painted/2, robot_has/2.
:- dead_ends.
:- discontiguous action/1, effect/3.

% change_color
action(change_color(R, C, C2)) :- robot_has(R, C), available_color(C2).
effect(change_color(R, C, C2), [robot_has(R, C)], [robot_has(R, C2)]).

% paint_up
action(paint_up(R, Y, X, C)) :- robot_has(R, C), robot_at(R, X), up(Y, X), clear(Y).
effect(paint_up(_R, Y, _X, C), [clear(Y)], [painted(Y, C)]).

% paint_down
action(paint_down(R, Y, X, C)) :- robot_has(R, C), robot_at(R, X), down(Y, X), clear(Y).
effect(paint_down(_R, Y, _X, C), [clear(Y)], [painted(Y, C)]).

% move_up
action(move_up(R, X, Y)) :- robot_at(R, X), up(Y, X), clear(Y).
effect(move_up(R, X, Y), [robot_at(R, X), clear(Y)], [robot_at(R, Y), clear(X)]).

% move_down
action(move_down(R, X, Y)) :- robot_at(R, X), down(Y, X), clear(Y).
effect(move_down(R, X, Y), [robot_at(R, X), clear(Y)], [robot_at(R, Y), clear(X)]).

% move_right
action(move_right(R, X, Y)) :- robot_at(R, X), right(Y, X), clear(Y).
effect(move_right(R, X, Y), [robot_at(R, X), clear(Y)], [robot_at(R, Y), clear(X)]).

% move_left
action(move_left(R, X, Y)) :- robot_at(R, X), left(Y, X), clear(Y).
effect(move_left(R, X, Y), [robot_at(R, X), clear(Y)], [robot_at(R, Y), clear(X)]).

goal :- \+ ( goal_painted(X, C), \+ painted(X, C) ), \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_painted(X, C) :- goal_painted(X, C), \+ painted(X, C).
done_painted(X, C) :- goal_painted(X, C), painted(X, C).

% derived from the types and the actions
:- table unsettled_up_todo_painted/1.
unsettled_up_todo_painted(X) :- todo_painted(X, _Color).
unsettled_up_todo_painted(X) :- up(X, Y), unsettled_up_todo_painted(Y).
:- table unsettled_before_up_todo_painted/1.
unsettled_before_up_todo_painted(X) :- todo_painted(X, _Color).
unsettled_before_up_todo_painted(X) :- up(Y, X), unsettled_before_up_todo_painted(Y).
:- table unsettled_right_todo_painted/1.
unsettled_right_todo_painted(X) :- todo_painted(X, _Color).
unsettled_right_todo_painted(X) :- right(X, Y), unsettled_right_todo_painted(Y).
:- table unsettled_before_right_todo_painted/1.
unsettled_before_right_todo_painted(X) :- todo_painted(X, _Color).
unsettled_before_right_todo_painted(X) :- right(Y, X), unsettled_before_right_todo_painted(Y).
:- table beyond_up/2.
beyond_up(X, Y) :- up(X, Y).
beyond_up(X, Y) :- beyond_up(X, Z), up(Z, Y).
:- table beyond_down/2.
beyond_down(X, Y) :- down(X, Y).
beyond_down(X, Y) :- beyond_down(X, Z), down(Z, Y).
:- table beyond_right/2.
beyond_right(X, Y) :- right(X, Y).
beyond_right(X, Y) :- beyond_right(X, Z), right(Z, Y).
:- table beyond_left/2.
beyond_left(X, Y) :- left(X, Y).
beyond_left(X, Y) :- beyond_left(X, Z), left(Z, Y).
needed_robot_has_to_paint_up(Color) :- todo_painted(_Tile, Color), \+ robot_has(_Robot, Color).
needed_robot_at_to_paint_up(Tile) :-
    up(Tile2, Tile),
    once(todo_painted(Tile2, _Color)),
    \+ ( up(Tile2, Tile3), robot_at(_Robot, Tile3) ).
needed_clear_to_paint_up(Tile) :- todo_painted(Tile, _Color), \+ clear(Tile).
needed_robot_at_to_paint_down(Tile) :-
    down(Tile2, Tile),
    once(todo_painted(Tile2, _Color)),
    \+ ( down(Tile2, Tile3), robot_at(_Robot, Tile3) ).
needed_clear_to_move_up_to_paint_up(Tile) :- needed_robot_at_to_paint_up(Tile), \+ clear(Tile).
needed_robot_at_to_move_up_to_paint_up(Tile) :- needed_clear_to_paint_up(Tile), \+ robot_at(_Robot, Tile).
needed_clear_to_move_up_to_paint_down(Tile) :- needed_robot_at_to_paint_down(Tile), \+ clear(Tile).
could_paint_up(Robot, Color) :- robot_at(Robot, Tile), up(Tile2, Tile), \+ painted(Tile2, Color), clear(Tile2).
could_paint_up_todo_painted(Robot, Color) :-
    todo_painted(Tile, Color),
    clear(Tile),
    robot_at(Robot, Tile2),
    up(Tile, Tile2).
could_paint_up_for_todo_painted_any_color(Robot, Color) :-
    todo_painted(_Tile, Color),
    robot_at(Robot, Tile2),
    once(( up(Tile3, Tile2), \+ painted(Tile3, Color), clear(Tile3) )).
could_paint_up_for_todo_painted_tile_any_2(Robot, Color) :-
    robot_at(Robot, Tile),
    once(todo_painted(Tile, _Color2)),
    up(Tile2, Tile),
    \+ painted(Tile2, Color),
    clear(Tile2).
could_paint_up_for_todo_painted_tile_color(Robot, Color) :-
    todo_painted(Tile, Color),
    robot_at(Robot, Tile),
    once(( up(Tile2, Tile), \+ painted(Tile2, Color), clear(Tile2) )).
could_paint_down(Robot, Color) :- robot_at(Robot, Tile), down(Tile2, Tile), \+ painted(Tile2, Color), clear(Tile2).
could_paint_down_todo_painted(Robot, Color) :-
    todo_painted(Tile, Color),
    clear(Tile),
    robot_at(Robot, Tile2),
    down(Tile, Tile2).
could_paint_down_for_todo_painted_any_color(Robot, Color) :-
    todo_painted(_Tile, Color),
    robot_at(Robot, Tile2),
    once(( down(Tile3, Tile2), \+ painted(Tile3, Color), clear(Tile3) )).
could_paint_down_for_todo_painted_tile_any(Robot, Color) :-
    robot_at(Robot, Tile),
    down(Tile2, Tile),
    \+ painted(Tile2, Color),
    clear(Tile2),
    once(todo_painted(Tile2, _Color2)).
could_paint_down_for_todo_painted_tile_color(Robot, Color) :-
    todo_painted(Tile, Color),
    robot_at(Robot, Tile),
    once(( down(Tile2, Tile), \+ painted(Tile2, Color), clear(Tile2) )).
step_robot_at(Tile, Tile2) :- up(Tile2, Tile).
step_robot_at(Tile, Tile2) :- down(Tile2, Tile).
step_robot_at(Tile, Tile2) :- right(Tile2, Tile).
step_robot_at(Tile, Tile2) :- left(Tile2, Tile).
:- table far_robot_at(_, _, min).
far_robot_at(Z, Z, 0).
far_robot_at(Z, X, D) :- far_robot_at(Z, Y, D0), step_robot_at(X, Y), D is D0+1.
:- table steps_robot_at/3.
steps_robot_at(X, Z, D) :- far_robot_at(Z, Y, D), Y == X.
nearer_robot_at(X, Y, Z) :- step_robot_at(X, Y), steps_robot_at(Y, Z, D), steps_robot_at(X, Z, D0), D < D0.
could_move_up(Robot, Tile) :- clear(Tile2), \+ robot_at(Robot, Tile2), up(Tile2, Tile).
:- table places_could_move_up/2.
places_could_move_up(Robot, Places) :- findall(Z, could_move_up(Robot, Z), Found), sort(Found, Places).
distance_could_move_up(Robot, X, D) :- places_could_move_up(Robot, Places), member(Z, Places), steps_robot_at(X, Z, D).
:- table nearest_could_move_up/3.
nearest_could_move_up(Robot, X, D) :- aggregate_all(min(D0), distance_could_move_up(Robot, X, D0), D).
toward_could_move_up(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_up(Robot, X, D),
    nearest_could_move_up(Robot, Y, D0),
    D0 < D.
could_move_up_needed_robot_at_to_paint_up(Tile) :- needed_robot_at_to_paint_up(Tile2), clear(Tile2), up(Tile2, Tile).
:- table places_could_move_up_needed_robot_at_to_paint_up/1.
places_could_move_up_needed_robot_at_to_paint_up(Places) :-
    findall(Z, could_move_up_needed_robot_at_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_up_needed_robot_at_to_paint_up(X, D) :-
    places_could_move_up_needed_robot_at_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_up_needed_robot_at_to_paint_up/2.
nearest_could_move_up_needed_robot_at_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_up_needed_robot_at_to_paint_up(X, D0), D).
toward_could_move_up_needed_robot_at_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_up_needed_robot_at_to_paint_up(X, D),
    nearest_could_move_up_needed_robot_at_to_paint_up(Y, D0),
    D0 < D.
could_move_up_needed_clear_to_paint_up(Tile) :- needed_clear_to_paint_up(Tile), once(( up(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_up_needed_clear_to_paint_up/1.
places_could_move_up_needed_clear_to_paint_up(Places) :-
    findall(Z, could_move_up_needed_clear_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_up_needed_clear_to_paint_up(X, D) :-
    places_could_move_up_needed_clear_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_up_needed_clear_to_paint_up/2.
nearest_could_move_up_needed_clear_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_up_needed_clear_to_paint_up(X, D0), D).
toward_could_move_up_needed_clear_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_up_needed_clear_to_paint_up(X, D),
    nearest_could_move_up_needed_clear_to_paint_up(Y, D0),
    D0 < D.
could_move_up_needed_robot_at_to_paint_down(Tile) :-
    needed_robot_at_to_paint_down(Tile2),
    clear(Tile2),
    up(Tile2, Tile).
:- table places_could_move_up_needed_robot_at_to_paint_down/1.
places_could_move_up_needed_robot_at_to_paint_down(Places) :-
    findall(Z, could_move_up_needed_robot_at_to_paint_down(Z), Found),
    sort(Found, Places).
distance_could_move_up_needed_robot_at_to_paint_down(X, D) :-
    places_could_move_up_needed_robot_at_to_paint_down(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_up_needed_robot_at_to_paint_down/2.
nearest_could_move_up_needed_robot_at_to_paint_down(X, D) :-
    aggregate_all(min(D0), distance_could_move_up_needed_robot_at_to_paint_down(X, D0), D).
toward_could_move_up_needed_robot_at_to_paint_down(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_up_needed_robot_at_to_paint_down(X, D),
    nearest_could_move_up_needed_robot_at_to_paint_down(Y, D0),
    D0 < D.
could_move_up_needed_clear_to_move_up_to_paint_up(Tile) :-
    needed_clear_to_move_up_to_paint_up(Tile),
    once(( up(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_up_needed_clear_to_move_up_to_paint_up/1.
places_could_move_up_needed_clear_to_move_up_to_paint_up(Places) :-
    findall(Z, could_move_up_needed_clear_to_move_up_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_up_needed_clear_to_move_up_to_paint_up(X, D) :-
    places_could_move_up_needed_clear_to_move_up_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_up_needed_clear_to_move_up_to_paint_up/2.
nearest_could_move_up_needed_clear_to_move_up_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_up_needed_clear_to_move_up_to_paint_up(X, D0), D).
toward_could_move_up_needed_clear_to_move_up_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_up_needed_clear_to_move_up_to_paint_up(X, D),
    nearest_could_move_up_needed_clear_to_move_up_to_paint_up(Y, D0),
    D0 < D.
could_move_up_needed_clear_to_move_up_to_paint_down(Tile) :-
    needed_clear_to_move_up_to_paint_down(Tile),
    once(( up(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_up_needed_clear_to_move_up_to_paint_down/1.
places_could_move_up_needed_clear_to_move_up_to_paint_down(Places) :-
    findall(Z, could_move_up_needed_clear_to_move_up_to_paint_down(Z), Found),
    sort(Found, Places).
distance_could_move_up_needed_clear_to_move_up_to_paint_down(X, D) :-
    places_could_move_up_needed_clear_to_move_up_to_paint_down(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_up_needed_clear_to_move_up_to_paint_down/2.
nearest_could_move_up_needed_clear_to_move_up_to_paint_down(X, D) :-
    aggregate_all(min(D0), distance_could_move_up_needed_clear_to_move_up_to_paint_down(X, D0), D).
toward_could_move_up_needed_clear_to_move_up_to_paint_down(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_up_needed_clear_to_move_up_to_paint_down(X, D),
    nearest_could_move_up_needed_clear_to_move_up_to_paint_down(Y, D0),
    D0 < D.
could_move_up_for_todo_painted_tile_any(Robot, Tile) :-
    clear(Tile2),
    \+ robot_at(Robot, Tile2),
    up(Tile2, Tile),
    once(todo_painted(Tile, _Color)).
:- table places_could_move_up_for_todo_painted_tile_any/2.
places_could_move_up_for_todo_painted_tile_any(Robot, Places) :-
    findall(Z, could_move_up_for_todo_painted_tile_any(Robot, Z), Found),
    sort(Found, Places).
distance_could_move_up_for_todo_painted_tile_any(Robot, X, D) :-
    places_could_move_up_for_todo_painted_tile_any(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_up_for_todo_painted_tile_any/3.
nearest_could_move_up_for_todo_painted_tile_any(Robot, X, D) :-
    aggregate_all(min(D0), distance_could_move_up_for_todo_painted_tile_any(Robot, X, D0), D).
toward_could_move_up_for_todo_painted_tile_any(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_up_for_todo_painted_tile_any(Robot, X, D),
    nearest_could_move_up_for_todo_painted_tile_any(Robot, Y, D0),
    D0 < D.
could_move_down(Robot, Tile) :- clear(Tile2), \+ robot_at(Robot, Tile2), down(Tile2, Tile).
:- table places_could_move_down/2.
places_could_move_down(Robot, Places) :- findall(Z, could_move_down(Robot, Z), Found), sort(Found, Places).
distance_could_move_down(Robot, X, D) :-
    places_could_move_down(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_down/3.
nearest_could_move_down(Robot, X, D) :- aggregate_all(min(D0), distance_could_move_down(Robot, X, D0), D).
toward_could_move_down(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_down(Robot, X, D),
    nearest_could_move_down(Robot, Y, D0),
    D0 < D.
could_move_down_needed_robot_at_to_paint_up(Tile) :-
    needed_robot_at_to_paint_up(Tile2),
    clear(Tile2),
    down(Tile2, Tile).
:- table places_could_move_down_needed_robot_at_to_paint_up/1.
places_could_move_down_needed_robot_at_to_paint_up(Places) :-
    findall(Z, could_move_down_needed_robot_at_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_down_needed_robot_at_to_paint_up(X, D) :-
    places_could_move_down_needed_robot_at_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_down_needed_robot_at_to_paint_up/2.
nearest_could_move_down_needed_robot_at_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_down_needed_robot_at_to_paint_up(X, D0), D).
toward_could_move_down_needed_robot_at_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_down_needed_robot_at_to_paint_up(X, D),
    nearest_could_move_down_needed_robot_at_to_paint_up(Y, D0),
    D0 < D.
could_move_down_needed_clear_to_paint_up(Tile) :-
    needed_clear_to_paint_up(Tile),
    once(( down(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_down_needed_clear_to_paint_up/1.
places_could_move_down_needed_clear_to_paint_up(Places) :-
    findall(Z, could_move_down_needed_clear_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_down_needed_clear_to_paint_up(X, D) :-
    places_could_move_down_needed_clear_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_down_needed_clear_to_paint_up/2.
nearest_could_move_down_needed_clear_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_down_needed_clear_to_paint_up(X, D0), D).
toward_could_move_down_needed_clear_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_down_needed_clear_to_paint_up(X, D),
    nearest_could_move_down_needed_clear_to_paint_up(Y, D0),
    D0 < D.
could_move_down_needed_robot_at_to_paint_down(Tile) :-
    needed_robot_at_to_paint_down(Tile2),
    clear(Tile2),
    down(Tile2, Tile).
:- table places_could_move_down_needed_robot_at_to_paint_down/1.
places_could_move_down_needed_robot_at_to_paint_down(Places) :-
    findall(Z, could_move_down_needed_robot_at_to_paint_down(Z), Found),
    sort(Found, Places).
distance_could_move_down_needed_robot_at_to_paint_down(X, D) :-
    places_could_move_down_needed_robot_at_to_paint_down(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_down_needed_robot_at_to_paint_down/2.
nearest_could_move_down_needed_robot_at_to_paint_down(X, D) :-
    aggregate_all(min(D0), distance_could_move_down_needed_robot_at_to_paint_down(X, D0), D).
toward_could_move_down_needed_robot_at_to_paint_down(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_down_needed_robot_at_to_paint_down(X, D),
    nearest_could_move_down_needed_robot_at_to_paint_down(Y, D0),
    D0 < D.
could_move_down_needed_clear_to_move_up_to_paint_up(Tile) :-
    needed_clear_to_move_up_to_paint_up(Tile),
    once(( down(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_down_needed_clear_to_move_up_to_paint_up/1.
places_could_move_down_needed_clear_to_move_up_to_paint_up(Places) :-
    findall(Z, could_move_down_needed_clear_to_move_up_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_down_needed_clear_to_move_up_to_paint_up(X, D) :-
    places_could_move_down_needed_clear_to_move_up_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_down_needed_clear_to_move_up_to_paint_up/2.
nearest_could_move_down_needed_clear_to_move_up_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_down_needed_clear_to_move_up_to_paint_up(X, D0), D).
toward_could_move_down_needed_clear_to_move_up_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_down_needed_clear_to_move_up_to_paint_up(X, D),
    nearest_could_move_down_needed_clear_to_move_up_to_paint_up(Y, D0),
    D0 < D.
could_move_down_needed_clear_to_move_up_to_paint_down(Tile) :-
    needed_clear_to_move_up_to_paint_down(Tile),
    once(( down(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_down_needed_clear_to_move_up_to_paint_down/1.
places_could_move_down_needed_clear_to_move_up_to_paint_down(Places) :-
    findall(Z, could_move_down_needed_clear_to_move_up_to_paint_down(Z), Found),
    sort(Found, Places).
distance_could_move_down_needed_clear_to_move_up_to_paint_down(X, D) :-
    places_could_move_down_needed_clear_to_move_up_to_paint_down(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_down_needed_clear_to_move_up_to_paint_down/2.
nearest_could_move_down_needed_clear_to_move_up_to_paint_down(X, D) :-
    aggregate_all(min(D0), distance_could_move_down_needed_clear_to_move_up_to_paint_down(X, D0), D).
toward_could_move_down_needed_clear_to_move_up_to_paint_down(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_down_needed_clear_to_move_up_to_paint_down(X, D),
    nearest_could_move_down_needed_clear_to_move_up_to_paint_down(Y, D0),
    D0 < D.
could_move_down_for_todo_painted_tile_any(Robot, Tile) :-
    clear(Tile2),
    \+ robot_at(Robot, Tile2),
    down(Tile2, Tile),
    once(todo_painted(Tile, _Color)).
:- table places_could_move_down_for_todo_painted_tile_any/2.
places_could_move_down_for_todo_painted_tile_any(Robot, Places) :-
    findall(Z, could_move_down_for_todo_painted_tile_any(Robot, Z), Found),
    sort(Found, Places).
distance_could_move_down_for_todo_painted_tile_any(Robot, X, D) :-
    places_could_move_down_for_todo_painted_tile_any(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_down_for_todo_painted_tile_any/3.
nearest_could_move_down_for_todo_painted_tile_any(Robot, X, D) :-
    aggregate_all(min(D0), distance_could_move_down_for_todo_painted_tile_any(Robot, X, D0), D).
toward_could_move_down_for_todo_painted_tile_any(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_down_for_todo_painted_tile_any(Robot, X, D),
    nearest_could_move_down_for_todo_painted_tile_any(Robot, Y, D0),
    D0 < D.
could_move_down_for_todo_painted_tile_any_2(Robot, Tile) :-
    clear(Tile2),
    \+ robot_at(Robot, Tile2),
    once(todo_painted(Tile2, _Color)),
    down(Tile2, Tile).
:- table places_could_move_down_for_todo_painted_tile_any_2/2.
places_could_move_down_for_todo_painted_tile_any_2(Robot, Places) :-
    findall(Z, could_move_down_for_todo_painted_tile_any_2(Robot, Z), Found),
    sort(Found, Places).
distance_could_move_down_for_todo_painted_tile_any_2(Robot, X, D) :-
    places_could_move_down_for_todo_painted_tile_any_2(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_down_for_todo_painted_tile_any_2/3.
nearest_could_move_down_for_todo_painted_tile_any_2(Robot, X, D) :-
    aggregate_all(min(D0), distance_could_move_down_for_todo_painted_tile_any_2(Robot, X, D0), D).
toward_could_move_down_for_todo_painted_tile_any_2(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_down_for_todo_painted_tile_any_2(Robot, X, D),
    nearest_could_move_down_for_todo_painted_tile_any_2(Robot, Y, D0),
    D0 < D.
could_move_right(Robot, Tile) :- clear(Tile2), \+ robot_at(Robot, Tile2), right(Tile2, Tile).
:- table places_could_move_right/2.
places_could_move_right(Robot, Places) :- findall(Z, could_move_right(Robot, Z), Found), sort(Found, Places).
distance_could_move_right(Robot, X, D) :-
    places_could_move_right(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_right/3.
nearest_could_move_right(Robot, X, D) :- aggregate_all(min(D0), distance_could_move_right(Robot, X, D0), D).
toward_could_move_right(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_right(Robot, X, D),
    nearest_could_move_right(Robot, Y, D0),
    D0 < D.
could_move_right_needed_robot_at_to_paint_up(Tile) :-
    needed_robot_at_to_paint_up(Tile2),
    clear(Tile2),
    right(Tile2, Tile).
:- table places_could_move_right_needed_robot_at_to_paint_up/1.
places_could_move_right_needed_robot_at_to_paint_up(Places) :-
    findall(Z, could_move_right_needed_robot_at_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_right_needed_robot_at_to_paint_up(X, D) :-
    places_could_move_right_needed_robot_at_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_right_needed_robot_at_to_paint_up/2.
nearest_could_move_right_needed_robot_at_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_right_needed_robot_at_to_paint_up(X, D0), D).
toward_could_move_right_needed_robot_at_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_right_needed_robot_at_to_paint_up(X, D),
    nearest_could_move_right_needed_robot_at_to_paint_up(Y, D0),
    D0 < D.
could_move_right_needed_clear_to_paint_up(Tile) :-
    needed_clear_to_paint_up(Tile),
    once(( right(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_right_needed_clear_to_paint_up/1.
places_could_move_right_needed_clear_to_paint_up(Places) :-
    findall(Z, could_move_right_needed_clear_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_right_needed_clear_to_paint_up(X, D) :-
    places_could_move_right_needed_clear_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_right_needed_clear_to_paint_up/2.
nearest_could_move_right_needed_clear_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_right_needed_clear_to_paint_up(X, D0), D).
toward_could_move_right_needed_clear_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_right_needed_clear_to_paint_up(X, D),
    nearest_could_move_right_needed_clear_to_paint_up(Y, D0),
    D0 < D.
could_move_right_needed_robot_at_to_paint_down(Tile) :-
    needed_robot_at_to_paint_down(Tile2),
    clear(Tile2),
    right(Tile2, Tile).
:- table places_could_move_right_needed_robot_at_to_paint_down/1.
places_could_move_right_needed_robot_at_to_paint_down(Places) :-
    findall(Z, could_move_right_needed_robot_at_to_paint_down(Z), Found),
    sort(Found, Places).
distance_could_move_right_needed_robot_at_to_paint_down(X, D) :-
    places_could_move_right_needed_robot_at_to_paint_down(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_right_needed_robot_at_to_paint_down/2.
nearest_could_move_right_needed_robot_at_to_paint_down(X, D) :-
    aggregate_all(min(D0), distance_could_move_right_needed_robot_at_to_paint_down(X, D0), D).
toward_could_move_right_needed_robot_at_to_paint_down(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_right_needed_robot_at_to_paint_down(X, D),
    nearest_could_move_right_needed_robot_at_to_paint_down(Y, D0),
    D0 < D.
could_move_right_needed_clear_to_move_up_to_paint_up(Tile) :-
    needed_clear_to_move_up_to_paint_up(Tile),
    once(( right(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_right_needed_clear_to_move_up_to_paint_up/1.
places_could_move_right_needed_clear_to_move_up_to_paint_up(Places) :-
    findall(Z, could_move_right_needed_clear_to_move_up_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_right_needed_clear_to_move_up_to_paint_up(X, D) :-
    places_could_move_right_needed_clear_to_move_up_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_right_needed_clear_to_move_up_to_paint_up/2.
nearest_could_move_right_needed_clear_to_move_up_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_right_needed_clear_to_move_up_to_paint_up(X, D0), D).
toward_could_move_right_needed_clear_to_move_up_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_right_needed_clear_to_move_up_to_paint_up(X, D),
    nearest_could_move_right_needed_clear_to_move_up_to_paint_up(Y, D0),
    D0 < D.
could_move_right_needed_clear_to_move_up_to_paint_down(Tile) :-
    needed_clear_to_move_up_to_paint_down(Tile),
    once(( right(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_right_needed_clear_to_move_up_to_paint_down/1.
places_could_move_right_needed_clear_to_move_up_to_paint_down(Places) :-
    findall(Z, could_move_right_needed_clear_to_move_up_to_paint_down(Z), Found),
    sort(Found, Places).
distance_could_move_right_needed_clear_to_move_up_to_paint_down(X, D) :-
    places_could_move_right_needed_clear_to_move_up_to_paint_down(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_right_needed_clear_to_move_up_to_paint_down/2.
nearest_could_move_right_needed_clear_to_move_up_to_paint_down(X, D) :-
    aggregate_all(min(D0), distance_could_move_right_needed_clear_to_move_up_to_paint_down(X, D0), D).
toward_could_move_right_needed_clear_to_move_up_to_paint_down(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_right_needed_clear_to_move_up_to_paint_down(X, D),
    nearest_could_move_right_needed_clear_to_move_up_to_paint_down(Y, D0),
    D0 < D.
could_move_right_for_todo_painted_tile_any(Robot, Tile) :-
    clear(Tile2),
    \+ robot_at(Robot, Tile2),
    right(Tile2, Tile),
    once(todo_painted(Tile, _Color)).
:- table places_could_move_right_for_todo_painted_tile_any/2.
places_could_move_right_for_todo_painted_tile_any(Robot, Places) :-
    findall(Z, could_move_right_for_todo_painted_tile_any(Robot, Z), Found),
    sort(Found, Places).
distance_could_move_right_for_todo_painted_tile_any(Robot, X, D) :-
    places_could_move_right_for_todo_painted_tile_any(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_right_for_todo_painted_tile_any/3.
nearest_could_move_right_for_todo_painted_tile_any(Robot, X, D) :-
    aggregate_all(min(D0), distance_could_move_right_for_todo_painted_tile_any(Robot, X, D0), D).
toward_could_move_right_for_todo_painted_tile_any(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_right_for_todo_painted_tile_any(Robot, X, D),
    nearest_could_move_right_for_todo_painted_tile_any(Robot, Y, D0),
    D0 < D.
could_move_right_for_todo_painted_tile_any_2(Robot, Tile) :-
    clear(Tile2),
    \+ robot_at(Robot, Tile2),
    once(todo_painted(Tile2, _Color)),
    right(Tile2, Tile).
:- table places_could_move_right_for_todo_painted_tile_any_2/2.
places_could_move_right_for_todo_painted_tile_any_2(Robot, Places) :-
    findall(Z, could_move_right_for_todo_painted_tile_any_2(Robot, Z), Found),
    sort(Found, Places).
distance_could_move_right_for_todo_painted_tile_any_2(Robot, X, D) :-
    places_could_move_right_for_todo_painted_tile_any_2(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_right_for_todo_painted_tile_any_2/3.
nearest_could_move_right_for_todo_painted_tile_any_2(Robot, X, D) :-
    aggregate_all(min(D0), distance_could_move_right_for_todo_painted_tile_any_2(Robot, X, D0), D).
toward_could_move_right_for_todo_painted_tile_any_2(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_right_for_todo_painted_tile_any_2(Robot, X, D),
    nearest_could_move_right_for_todo_painted_tile_any_2(Robot, Y, D0),
    D0 < D.
could_move_left(Robot, Tile) :- clear(Tile2), \+ robot_at(Robot, Tile2), left(Tile2, Tile).
:- table places_could_move_left/2.
places_could_move_left(Robot, Places) :- findall(Z, could_move_left(Robot, Z), Found), sort(Found, Places).
distance_could_move_left(Robot, X, D) :-
    places_could_move_left(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_left/3.
nearest_could_move_left(Robot, X, D) :- aggregate_all(min(D0), distance_could_move_left(Robot, X, D0), D).
toward_could_move_left(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_left(Robot, X, D),
    nearest_could_move_left(Robot, Y, D0),
    D0 < D.
could_move_left_needed_robot_at_to_paint_up(Tile) :-
    needed_robot_at_to_paint_up(Tile2),
    clear(Tile2),
    left(Tile2, Tile).
:- table places_could_move_left_needed_robot_at_to_paint_up/1.
places_could_move_left_needed_robot_at_to_paint_up(Places) :-
    findall(Z, could_move_left_needed_robot_at_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_left_needed_robot_at_to_paint_up(X, D) :-
    places_could_move_left_needed_robot_at_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_left_needed_robot_at_to_paint_up/2.
nearest_could_move_left_needed_robot_at_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_left_needed_robot_at_to_paint_up(X, D0), D).
toward_could_move_left_needed_robot_at_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_left_needed_robot_at_to_paint_up(X, D),
    nearest_could_move_left_needed_robot_at_to_paint_up(Y, D0),
    D0 < D.
could_move_left_needed_clear_to_paint_up(Tile) :-
    needed_clear_to_paint_up(Tile),
    once(( left(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_left_needed_clear_to_paint_up/1.
places_could_move_left_needed_clear_to_paint_up(Places) :-
    findall(Z, could_move_left_needed_clear_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_left_needed_clear_to_paint_up(X, D) :-
    places_could_move_left_needed_clear_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_left_needed_clear_to_paint_up/2.
nearest_could_move_left_needed_clear_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_left_needed_clear_to_paint_up(X, D0), D).
toward_could_move_left_needed_clear_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_left_needed_clear_to_paint_up(X, D),
    nearest_could_move_left_needed_clear_to_paint_up(Y, D0),
    D0 < D.
could_move_left_needed_robot_at_to_paint_down(Tile) :-
    needed_robot_at_to_paint_down(Tile2),
    clear(Tile2),
    left(Tile2, Tile).
:- table places_could_move_left_needed_robot_at_to_paint_down/1.
places_could_move_left_needed_robot_at_to_paint_down(Places) :-
    findall(Z, could_move_left_needed_robot_at_to_paint_down(Z), Found),
    sort(Found, Places).
distance_could_move_left_needed_robot_at_to_paint_down(X, D) :-
    places_could_move_left_needed_robot_at_to_paint_down(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_left_needed_robot_at_to_paint_down/2.
nearest_could_move_left_needed_robot_at_to_paint_down(X, D) :-
    aggregate_all(min(D0), distance_could_move_left_needed_robot_at_to_paint_down(X, D0), D).
toward_could_move_left_needed_robot_at_to_paint_down(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_left_needed_robot_at_to_paint_down(X, D),
    nearest_could_move_left_needed_robot_at_to_paint_down(Y, D0),
    D0 < D.
could_move_left_needed_clear_to_move_up_to_paint_up(Tile) :-
    needed_clear_to_move_up_to_paint_up(Tile),
    once(( left(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_left_needed_clear_to_move_up_to_paint_up/1.
places_could_move_left_needed_clear_to_move_up_to_paint_up(Places) :-
    findall(Z, could_move_left_needed_clear_to_move_up_to_paint_up(Z), Found),
    sort(Found, Places).
distance_could_move_left_needed_clear_to_move_up_to_paint_up(X, D) :-
    places_could_move_left_needed_clear_to_move_up_to_paint_up(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_left_needed_clear_to_move_up_to_paint_up/2.
nearest_could_move_left_needed_clear_to_move_up_to_paint_up(X, D) :-
    aggregate_all(min(D0), distance_could_move_left_needed_clear_to_move_up_to_paint_up(X, D0), D).
toward_could_move_left_needed_clear_to_move_up_to_paint_up(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_left_needed_clear_to_move_up_to_paint_up(X, D),
    nearest_could_move_left_needed_clear_to_move_up_to_paint_up(Y, D0),
    D0 < D.
could_move_left_needed_clear_to_move_up_to_paint_down(Tile) :-
    needed_clear_to_move_up_to_paint_down(Tile),
    once(( left(Tile2, Tile), clear(Tile2) )).
:- table places_could_move_left_needed_clear_to_move_up_to_paint_down/1.
places_could_move_left_needed_clear_to_move_up_to_paint_down(Places) :-
    findall(Z, could_move_left_needed_clear_to_move_up_to_paint_down(Z), Found),
    sort(Found, Places).
distance_could_move_left_needed_clear_to_move_up_to_paint_down(X, D) :-
    places_could_move_left_needed_clear_to_move_up_to_paint_down(Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_left_needed_clear_to_move_up_to_paint_down/2.
nearest_could_move_left_needed_clear_to_move_up_to_paint_down(X, D) :-
    aggregate_all(min(D0), distance_could_move_left_needed_clear_to_move_up_to_paint_down(X, D0), D).
toward_could_move_left_needed_clear_to_move_up_to_paint_down(X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_left_needed_clear_to_move_up_to_paint_down(X, D),
    nearest_could_move_left_needed_clear_to_move_up_to_paint_down(Y, D0),
    D0 < D.
could_move_left_for_todo_painted_tile_any(Robot, Tile) :-
    clear(Tile2),
    \+ robot_at(Robot, Tile2),
    left(Tile2, Tile),
    once(todo_painted(Tile, _Color)).
:- table places_could_move_left_for_todo_painted_tile_any/2.
places_could_move_left_for_todo_painted_tile_any(Robot, Places) :-
    findall(Z, could_move_left_for_todo_painted_tile_any(Robot, Z), Found),
    sort(Found, Places).
distance_could_move_left_for_todo_painted_tile_any(Robot, X, D) :-
    places_could_move_left_for_todo_painted_tile_any(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_left_for_todo_painted_tile_any/3.
nearest_could_move_left_for_todo_painted_tile_any(Robot, X, D) :-
    aggregate_all(min(D0), distance_could_move_left_for_todo_painted_tile_any(Robot, X, D0), D).
toward_could_move_left_for_todo_painted_tile_any(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_left_for_todo_painted_tile_any(Robot, X, D),
    nearest_could_move_left_for_todo_painted_tile_any(Robot, Y, D0),
    D0 < D.
could_move_left_for_todo_painted_tile_any_2(Robot, Tile) :-
    clear(Tile2),
    \+ robot_at(Robot, Tile2),
    once(todo_painted(Tile2, _Color)),
    left(Tile2, Tile).
:- table places_could_move_left_for_todo_painted_tile_any_2/2.
places_could_move_left_for_todo_painted_tile_any_2(Robot, Places) :-
    findall(Z, could_move_left_for_todo_painted_tile_any_2(Robot, Z), Found),
    sort(Found, Places).
distance_could_move_left_for_todo_painted_tile_any_2(Robot, X, D) :-
    places_could_move_left_for_todo_painted_tile_any_2(Robot, Places),
    member(Z, Places),
    steps_robot_at(X, Z, D).
:- table nearest_could_move_left_for_todo_painted_tile_any_2/3.
nearest_could_move_left_for_todo_painted_tile_any_2(Robot, X, D) :-
    aggregate_all(min(D0), distance_could_move_left_for_todo_painted_tile_any_2(Robot, X, D0), D).
toward_could_move_left_for_todo_painted_tile_any_2(Robot, X, Y) :-
    step_robot_at(X, Y),
    nearest_could_move_left_for_todo_painted_tile_any_2(Robot, X, D),
    nearest_could_move_left_for_todo_painted_tile_any_2(Robot, Y, D0),
    D0 < D.
:- table number_robot_has_1/1.
number_robot_has_1(N) :- findall(X, robot_has(X, _Color), Found), sort(Found, Set), length(Set, N).
:- table number_todo_painted_1/1.
number_todo_painted_1(N) :- findall(X, todo_painted(X, _Color), Found), sort(Found, Set), length(Set, N).
fewer_robot_has_1_than_todo_painted_1 :- number_robot_has_1(N), number_todo_painted_1(M), N < M.
:- table number_clear/1.
number_clear(N) :- findall(X, clear(X), Found), sort(Found, Set), length(Set, N).
fewer_robot_has_1_than_clear :- number_robot_has_1(N), number_clear(M), N < M.
both_todo_painted_1_clear(X) :- todo_painted(X, _Color), clear(X).
:- table number_todo_painted_1_clear/1.
number_todo_painted_1_clear(N) :- findall(X, both_todo_painted_1_clear(X), Found), sort(Found, Set), length(Set, N).
fewer_robot_has_1_than_todo_painted_1_clear :- number_robot_has_1(N), number_todo_painted_1_clear(M), N < M.
:- table number_todo_painted_2/1.
number_todo_painted_2(N) :- findall(X, todo_painted(_Tile, X), Found), sort(Found, Set), length(Set, N).
fewer_robot_has_1_than_todo_painted_2 :- number_robot_has_1(N), number_todo_painted_2(M), N < M.
