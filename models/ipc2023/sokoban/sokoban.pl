:- module(sokoban, []).

% The PDDL domain sokoban. What no action changes is static: it belongs to the problem. So do its goals: goal_at(O, L)
% says that at(O, L) is wanted, condition/1 has what is wanted beyond such facts, and goals/1 says how many literals
% that is in all.

:- pddl('domain.pddl').
:- static location/1, direction/1, box/1, adjacent/3, goal_at/2, goals/1, condition/1.
:- fluent at_robot/1, at/2, clear/1.
:- dead_ends.
:- discontiguous action/1, effect/3.

% move
action(move(From, To, Dir)) :- at_robot(From), adjacent(From, To, Dir), clear(To).
effect(move(From, To, _Dir), [at_robot(From)], [at_robot(To)]).

% push
action(push(Rloc, Bloc, Floc, Dir, B)) :-
    at_robot(Rloc),
    at(B, Bloc),
    adjacent(Rloc, Bloc, Dir),
    adjacent(Bloc, Floc, Dir),
    clear(Floc).
effect(push(Rloc, Bloc, Floc, _Dir, B), [at_robot(Rloc), at(B, Bloc), clear(Floc)],
    [at_robot(Bloc), at(B, Floc), clear(Bloc)]).

goal :- \+ ( goal_at(O, L), \+ at(O, L) ), \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_at(O, L) :- goal_at(O, L), \+ at(O, L).
done_at(O, L) :- goal_at(O, L), at(O, L).

% derived from the types and the actions
needed_at_robot_to_push(Location) :-
    adjacent(Location, Location2, Direction),
    once(( adjacent(Location2, Location3, Direction),
           once(todo_at(_Box, Location3)),
           \+ ( at_robot(Location4),
                adjacent(Location4, Location5, Direction2),
                adjacent(Location5, Location3, Direction2) ) )).
needed_clear_to_push(Location) :- todo_at(_Box, Location), \+ clear(Location).
needed_clear_to_move_to_push(Location) :- needed_at_robot_to_push(Location), \+ clear(Location).
needed_at_to_push_to_push(Location) :- needed_at_robot_to_push(Location), \+ at(_Box, Location).
needed_at_robot_to_push_to_push(Location) :-
    needed_clear_to_push(Location2),
    \+ ( at_robot(Location3), adjacent(Location3, Location2, Direction), adjacent(Location2, _Location4, Direction) ),
    adjacent(Location, Location2, Direction2),
    once(adjacent(Location2, _Location5, Direction2)).
step_at_robot(Location, Location2) :- adjacent(Location, Location2, _Direction).
:- table far_at_robot(_, _, min).
far_at_robot(Z, Z, 0).
far_at_robot(Z, X, D) :- far_at_robot(Z, Y, D0), step_at_robot(X, Y), D is D0+1.
:- table steps_at_robot/3.
steps_at_robot(X, Z, D) :- far_at_robot(Z, Y, D), Y == X.
nearer_at_robot(X, Y, Z) :- step_at_robot(X, Y), steps_at_robot(Y, Z, D), steps_at_robot(X, Z, D0), D < D0.
could_push(Location) :-
    clear(Location2),
    adjacent(Location3, Location2, Direction),
    \+ at_robot(Location3),
    once(at(_Box, Location3)),
    adjacent(Location, Location3, Direction).
:- table places_could_push/1.
places_could_push(Places) :- findall(Z, could_push(Z), Found), sort(Found, Places).
distance_could_push(X, D) :- places_could_push(Places), member(Z, Places), steps_at_robot(X, Z, D).
:- table nearest_could_push/2.
nearest_could_push(X, D) :- aggregate_all(min(D0), distance_could_push(X, D0), D).
toward_could_push(X, Y) :- step_at_robot(X, Y), nearest_could_push(X, D), nearest_could_push(Y, D0), D0 < D.
could_push_todo_at(Location) :-
    clear(Location2),
    todo_at(Box, Location2),
    at(Box, Location3),
    adjacent(Location3, Location2, Direction),
    adjacent(Location, Location3, Direction).
:- table places_could_push_todo_at/1.
places_could_push_todo_at(Places) :- findall(Z, could_push_todo_at(Z), Found), sort(Found, Places).
distance_could_push_todo_at(X, D) :- places_could_push_todo_at(Places), member(Z, Places), steps_at_robot(X, Z, D).
:- table nearest_could_push_todo_at/2.
nearest_could_push_todo_at(X, D) :- aggregate_all(min(D0), distance_could_push_todo_at(X, D0), D).
toward_could_push_todo_at(X, Y) :-
    step_at_robot(X, Y),
    nearest_could_push_todo_at(X, D),
    nearest_could_push_todo_at(Y, D0),
    D0 < D.
could_push_needed_at_robot_to_push(Location) :-
    needed_at_robot_to_push(Location2),
    once(at(_Box, Location2)),
    clear(Location3),
    adjacent(Location2, Location3, Direction),
    adjacent(Location, Location2, Direction).
:- table places_could_push_needed_at_robot_to_push/1.
places_could_push_needed_at_robot_to_push(Places) :-
    findall(Z, could_push_needed_at_robot_to_push(Z), Found),
    sort(Found, Places).
distance_could_push_needed_at_robot_to_push(X, D) :-
    places_could_push_needed_at_robot_to_push(Places),
    member(Z, Places),
    steps_at_robot(X, Z, D).
:- table nearest_could_push_needed_at_robot_to_push/2.
nearest_could_push_needed_at_robot_to_push(X, D) :-
    aggregate_all(min(D0), distance_could_push_needed_at_robot_to_push(X, D0), D).
toward_could_push_needed_at_robot_to_push(X, Y) :-
    step_at_robot(X, Y),
    nearest_could_push_needed_at_robot_to_push(X, D),
    nearest_could_push_needed_at_robot_to_push(Y, D0),
    D0 < D.
could_push_needed_clear_to_push(Location) :-
    needed_clear_to_push(Location2),
    once(at(_Box, Location2)),
    clear(Location3),
    adjacent(Location2, Location3, Direction),
    adjacent(Location, Location2, Direction).
:- table places_could_push_needed_clear_to_push/1.
places_could_push_needed_clear_to_push(Places) :-
    findall(Z, could_push_needed_clear_to_push(Z), Found),
    sort(Found, Places).
distance_could_push_needed_clear_to_push(X, D) :-
    places_could_push_needed_clear_to_push(Places),
    member(Z, Places),
    steps_at_robot(X, Z, D).
:- table nearest_could_push_needed_clear_to_push/2.
nearest_could_push_needed_clear_to_push(X, D) :-
    aggregate_all(min(D0), distance_could_push_needed_clear_to_push(X, D0), D).
toward_could_push_needed_clear_to_push(X, Y) :-
    step_at_robot(X, Y),
    nearest_could_push_needed_clear_to_push(X, D),
    nearest_could_push_needed_clear_to_push(Y, D0),
    D0 < D.
could_push_needed_at_to_push_to_push(Location) :-
    needed_at_to_push_to_push(Location2),
    clear(Location2),
    adjacent(Location3, Location2, Direction),
    once(at(_Box, Location3)),
    adjacent(Location, Location3, Direction).
:- table places_could_push_needed_at_to_push_to_push/1.
places_could_push_needed_at_to_push_to_push(Places) :-
    findall(Z, could_push_needed_at_to_push_to_push(Z), Found),
    sort(Found, Places).
distance_could_push_needed_at_to_push_to_push(X, D) :-
    places_could_push_needed_at_to_push_to_push(Places),
    member(Z, Places),
    steps_at_robot(X, Z, D).
:- table nearest_could_push_needed_at_to_push_to_push/2.
nearest_could_push_needed_at_to_push_to_push(X, D) :-
    aggregate_all(min(D0), distance_could_push_needed_at_to_push_to_push(X, D0), D).
toward_could_push_needed_at_to_push_to_push(X, Y) :-
    step_at_robot(X, Y),
    nearest_could_push_needed_at_to_push_to_push(X, D),
    nearest_could_push_needed_at_to_push_to_push(Y, D0),
    D0 < D.
could_push_for_todo_at_any_location(Location) :-
    clear(Location2),
    adjacent(Location3, Location2, Direction),
    \+ at_robot(Location3),
    once(at(_Box, Location3)),
    adjacent(Location, Location3, Direction),
    once(todo_at(_Box2, Location)).
:- table places_could_push_for_todo_at_any_location/1.
places_could_push_for_todo_at_any_location(Places) :-
    findall(Z, could_push_for_todo_at_any_location(Z), Found),
    sort(Found, Places).
distance_could_push_for_todo_at_any_location(X, D) :-
    places_could_push_for_todo_at_any_location(Places),
    member(Z, Places),
    steps_at_robot(X, Z, D).
:- table nearest_could_push_for_todo_at_any_location/2.
nearest_could_push_for_todo_at_any_location(X, D) :-
    aggregate_all(min(D0), distance_could_push_for_todo_at_any_location(X, D0), D).
toward_could_push_for_todo_at_any_location(X, Y) :-
    step_at_robot(X, Y),
    nearest_could_push_for_todo_at_any_location(X, D),
    nearest_could_push_for_todo_at_any_location(Y, D0),
    D0 < D.
could_push_for_todo_at_any_location_3(Location) :-
    clear(Location2),
    once(todo_at(_Box, Location2)),
    adjacent(Location3, Location2, Direction),
    \+ at_robot(Location3),
    once(at(_Box2, Location3)),
    adjacent(Location, Location3, Direction).
:- table places_could_push_for_todo_at_any_location_3/1.
places_could_push_for_todo_at_any_location_3(Places) :-
    findall(Z, could_push_for_todo_at_any_location_3(Z), Found),
    sort(Found, Places).
distance_could_push_for_todo_at_any_location_3(X, D) :-
    places_could_push_for_todo_at_any_location_3(Places),
    member(Z, Places),
    steps_at_robot(X, Z, D).
:- table nearest_could_push_for_todo_at_any_location_3/2.
nearest_could_push_for_todo_at_any_location_3(X, D) :-
    aggregate_all(min(D0), distance_could_push_for_todo_at_any_location_3(X, D0), D).
toward_could_push_for_todo_at_any_location_3(X, Y) :-
    step_at_robot(X, Y),
    nearest_could_push_for_todo_at_any_location_3(X, D),
    nearest_could_push_for_todo_at_any_location_3(Y, D0),
    D0 < D.
could_push_for_todo_at_box_location(Location) :-
    clear(Location2),
    adjacent(Location3, Location2, Direction),
    \+ at_robot(Location3),
    adjacent(Location, Location3, Direction),
    once(( todo_at(Box, Location), at(Box, Location3) )).
:- table places_could_push_for_todo_at_box_location/1.
places_could_push_for_todo_at_box_location(Places) :-
    findall(Z, could_push_for_todo_at_box_location(Z), Found),
    sort(Found, Places).
distance_could_push_for_todo_at_box_location(X, D) :-
    places_could_push_for_todo_at_box_location(Places),
    member(Z, Places),
    steps_at_robot(X, Z, D).
:- table nearest_could_push_for_todo_at_box_location/2.
nearest_could_push_for_todo_at_box_location(X, D) :-
    aggregate_all(min(D0), distance_could_push_for_todo_at_box_location(X, D0), D).
toward_could_push_for_todo_at_box_location(X, Y) :-
    step_at_robot(X, Y),
    nearest_could_push_for_todo_at_box_location(X, D),
    nearest_could_push_for_todo_at_box_location(Y, D0),
    D0 < D.
wanted_at(Box, Z) :- todo_at(Box, Z).
:- table places_wanted_at/2.
places_wanted_at(Box, Places) :- findall(Z, wanted_at(Box, Z), Found), sort(Found, Places).
step_at(Location, Location2) :- adjacent(Location, Location2, _Direction).
:- table far_at(_, _, min).
far_at(Z, Z, 0).
far_at(Z, X, D) :- far_at(Z, Y, D0), step_at(X, Y), D is D0+1.
:- table steps_at/3.
steps_at(X, Z, D) :- far_at(Z, Y, D), Y == X.
distance_wanted_at(Box, X, D) :- places_wanted_at(Box, Places), member(Z, Places), steps_at(X, Z, D).
:- table nearest_wanted_at/3.
nearest_wanted_at(Box, X, D) :- aggregate_all(min(D0), distance_wanted_at(Box, X, D0), D).
toward_wanted_at(Box, X, Y) :- step_at(X, Y), nearest_wanted_at(Box, X, D), nearest_wanted_at(Box, Y, D0), D0 < D.
could_move(Location) :- at_robot(Location2), adjacent(Location2, Location, _Direction), \+ at_robot(Location).
:- table places_could_move/1.
places_could_move(Places) :- findall(Z, could_move(Z), Found), sort(Found, Places).
step_clear(Location, Location2) :- adjacent(Location2, Location, _Direction).
:- table far_clear(_, _, min).
far_clear(Z, Z, 0).
far_clear(Z, X, D) :- far_clear(Z, Y, D0), step_clear(X, Y), D is D0+1.
:- table steps_clear/3.
steps_clear(X, Z, D) :- far_clear(Z, Y, D), Y == X.
distance_could_move(X, D) :- places_could_move(Places), member(Z, Places), steps_clear(X, Z, D).
:- table nearest_could_move/2.
nearest_could_move(X, D) :- aggregate_all(min(D0), distance_could_move(X, D0), D).
toward_could_move(X, Y) :- step_clear(X, Y), nearest_could_move(X, D), nearest_could_move(Y, D0), D0 < D.
could_move_needed_at_robot_to_push(Location) :-
    needed_at_robot_to_push(Location),
    once(( at_robot(Location2), once(adjacent(Location2, Location, _Direction)) )).
:- table places_could_move_needed_at_robot_to_push/1.
places_could_move_needed_at_robot_to_push(Places) :-
    findall(Z, could_move_needed_at_robot_to_push(Z), Found),
    sort(Found, Places).
distance_could_move_needed_at_robot_to_push(X, D) :-
    places_could_move_needed_at_robot_to_push(Places),
    member(Z, Places),
    steps_clear(X, Z, D).
:- table nearest_could_move_needed_at_robot_to_push/2.
nearest_could_move_needed_at_robot_to_push(X, D) :-
    aggregate_all(min(D0), distance_could_move_needed_at_robot_to_push(X, D0), D).
toward_could_move_needed_at_robot_to_push(X, Y) :-
    step_clear(X, Y),
    nearest_could_move_needed_at_robot_to_push(X, D),
    nearest_could_move_needed_at_robot_to_push(Y, D0),
    D0 < D.
could_move_needed_at_robot_to_push_to_push(Location) :-
    needed_at_robot_to_push_to_push(Location),
    once(( at_robot(Location2), once(adjacent(Location2, Location, _Direction)) )).
:- table places_could_move_needed_at_robot_to_push_to_push/1.
places_could_move_needed_at_robot_to_push_to_push(Places) :-
    findall(Z, could_move_needed_at_robot_to_push_to_push(Z), Found),
    sort(Found, Places).
distance_could_move_needed_at_robot_to_push_to_push(X, D) :-
    places_could_move_needed_at_robot_to_push_to_push(Places),
    member(Z, Places),
    steps_clear(X, Z, D).
:- table nearest_could_move_needed_at_robot_to_push_to_push/2.
nearest_could_move_needed_at_robot_to_push_to_push(X, D) :-
    aggregate_all(min(D0), distance_could_move_needed_at_robot_to_push_to_push(X, D0), D).
toward_could_move_needed_at_robot_to_push_to_push(X, Y) :-
    step_clear(X, Y),
    nearest_could_move_needed_at_robot_to_push_to_push(X, D),
    nearest_could_move_needed_at_robot_to_push_to_push(Y, D0),
    D0 < D.
could_move_for_todo_at_any_location(Location) :-
    at_robot(Location2),
    once(todo_at(_Box, Location2)),
    adjacent(Location2, Location, _Direction),
    \+ at_robot(Location).
:- table places_could_move_for_todo_at_any_location/1.
places_could_move_for_todo_at_any_location(Places) :-
    findall(Z, could_move_for_todo_at_any_location(Z), Found),
    sort(Found, Places).
distance_could_move_for_todo_at_any_location(X, D) :-
    places_could_move_for_todo_at_any_location(Places),
    member(Z, Places),
    steps_clear(X, Z, D).
:- table nearest_could_move_for_todo_at_any_location/2.
nearest_could_move_for_todo_at_any_location(X, D) :-
    aggregate_all(min(D0), distance_could_move_for_todo_at_any_location(X, D0), D).
toward_could_move_for_todo_at_any_location(X, Y) :-
    step_clear(X, Y),
    nearest_could_move_for_todo_at_any_location(X, D),
    nearest_could_move_for_todo_at_any_location(Y, D0),
    D0 < D.
could_move_for_todo_at_any_location_2(Location) :-
    at_robot(Location2),
    adjacent(Location2, Location, _Direction),
    \+ at_robot(Location),
    once(todo_at(_Box, Location)).
:- table places_could_move_for_todo_at_any_location_2/1.
places_could_move_for_todo_at_any_location_2(Places) :-
    findall(Z, could_move_for_todo_at_any_location_2(Z), Found),
    sort(Found, Places).
distance_could_move_for_todo_at_any_location_2(X, D) :-
    places_could_move_for_todo_at_any_location_2(Places),
    member(Z, Places),
    steps_clear(X, Z, D).
:- table nearest_could_move_for_todo_at_any_location_2/2.
nearest_could_move_for_todo_at_any_location_2(X, D) :-
    aggregate_all(min(D0), distance_could_move_for_todo_at_any_location_2(X, D0), D).
toward_could_move_for_todo_at_any_location_2(X, Y) :-
    step_clear(X, Y),
    nearest_could_move_for_todo_at_any_location_2(X, D),
    nearest_could_move_for_todo_at_any_location_2(Y, D0),
    D0 < D.
:- table number_at_robot/1.
number_at_robot(N) :- findall(X, at_robot(X), Found), sort(Found, Set), length(Set, N).
:- table number_todo_at_1/1.
number_todo_at_1(N) :- findall(X, todo_at(X, _Location), Found), sort(Found, Set), length(Set, N).
fewer_at_robot_than_todo_at_1 :- number_at_robot(N), number_todo_at_1(M), N < M.
