:- module(transport, []).

% The PDDL domain transport. What no action changes is static: it belongs to the problem. So do its goals: goal_at(X, V)
% says that at(X, V) is wanted, condition/1 has what is wanted beyond such facts, and goals/1 says how many literals
% that is in all.

:- pddl('domain.pddl').
:- static size/1, location/1, locatable/1, vehicle/1, package/1, road/2, capacity_predecessor/2, goal_at/2, goals/1,
     condition/1.
:- fluent at/2, in/2, capacity/2.
:- dead_ends.
:- discontiguous action/1, effect/3.

% drive
action(drive(V, L1, L2)) :- at(V, L1), vehicle(V), road(L1, L2).
effect(drive(V, L1, L2), [at(V, L1)], [at(V, L2)]).

% pick-up
action(pick_up(V, L, P, S1, S2)) :- capacity_predecessor(S1, S2), capacity(V, S2), at(V, L), at(P, L), package(P).
effect(pick_up(V, L, P, S1, S2), [at(P, L), capacity(V, S2)], [in(P, V), capacity(V, S1)]).

% drop
action(drop(V, L, P, S1, S2)) :- in(P, V), capacity_predecessor(S1, S2), capacity(V, S1), at(V, L).
effect(drop(V, L, P, S1, S2), [in(P, V), capacity(V, S1)], [at(P, L), capacity(V, S2)]).

goal :- \+ ( goal_at(X, V), \+ at(X, V) ), \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_at(X, V) :- goal_at(X, V), \+ at(X, V).
done_at(X, V) :- goal_at(X, V), at(X, V).

% derived from the types and the actions
:- table beyond_road/2.
beyond_road(X, Y) :- road(X, Y).
beyond_road(X, Y) :- beyond_road(X, Z), road(Z, Y).
:- table beyond_capacity_predecessor/2.
beyond_capacity_predecessor(X, Y) :- capacity_predecessor(X, Y).
beyond_capacity_predecessor(X, Y) :- beyond_capacity_predecessor(X, Z), capacity_predecessor(Z, Y).
needed_in_to_drop(Package) :- todo_at(Package, _Location), \+ in(Package, _Vehicle).
needed_capacity_to_drop(Size) :-
    once(todo_at(_Package, _Location)),
    \+ ( capacity(_Vehicle, Size2), capacity_predecessor(Size2, _Size3) ),
    capacity_predecessor(Size, _Size4).
step_at(Location, Location2) :- road(Location, Location2).
:- table far_at(_, _, min).
far_at(Z, Z, 0).
far_at(Z, X, D) :- far_at(Z, Y, D0), step_at(X, Y), D is D0+1.
:- table steps_at/3.
steps_at(X, Z, D) :- far_at(Z, Y, D), Y == X.
nearer_at(X, Y, Z) :- step_at(X, Y), steps_at(Y, Z, D), steps_at(X, Z, D0), D < D0.
wanted_at(Vehicle, Z) :- todo_at(Vehicle, Z).
:- table places_wanted_at/2.
places_wanted_at(Vehicle, Places) :- findall(Z, wanted_at(Vehicle, Z), Found), sort(Found, Places).
distance_wanted_at(Vehicle, X, D) :- places_wanted_at(Vehicle, Places), member(Z, Places), steps_at(X, Z, D).
:- table nearest_wanted_at/3.
nearest_wanted_at(Vehicle, X, D) :- aggregate_all(min(D0), distance_wanted_at(Vehicle, X, D0), D).
toward_wanted_at(Vehicle, X, Y) :-
    step_at(X, Y),
    nearest_wanted_at(Vehicle, X, D),
    nearest_wanted_at(Vehicle, Y, D0),
    D0 < D.
could_pick_up(Vehicle, Location) :-
    capacity(Vehicle, Size),
    once(capacity_predecessor(_Size2, Size)),
    package(Package),
    \+ in(Package, Vehicle),
    at(Package, Location).
:- table places_could_pick_up/2.
places_could_pick_up(Vehicle, Places) :- findall(Z, could_pick_up(Vehicle, Z), Found), sort(Found, Places).
distance_could_pick_up(Vehicle, X, D) :- places_could_pick_up(Vehicle, Places), member(Z, Places), steps_at(X, Z, D).
:- table nearest_could_pick_up/3.
nearest_could_pick_up(Vehicle, X, D) :- aggregate_all(min(D0), distance_could_pick_up(Vehicle, X, D0), D).
toward_could_pick_up(Vehicle, X, Y) :-
    step_at(X, Y),
    nearest_could_pick_up(Vehicle, X, D),
    nearest_could_pick_up(Vehicle, Y, D0),
    D0 < D.
could_pick_up_needed_in_to_drop(Vehicle, Location) :-
    capacity(Vehicle, Size),
    once(capacity_predecessor(_Size2, Size)),
    needed_in_to_drop(Package),
    package(Package),
    at(Package, Location).
:- table places_could_pick_up_needed_in_to_drop/2.
places_could_pick_up_needed_in_to_drop(Vehicle, Places) :-
    findall(Z, could_pick_up_needed_in_to_drop(Vehicle, Z), Found),
    sort(Found, Places).
distance_could_pick_up_needed_in_to_drop(Vehicle, X, D) :-
    places_could_pick_up_needed_in_to_drop(Vehicle, Places),
    member(Z, Places),
    steps_at(X, Z, D).
:- table nearest_could_pick_up_needed_in_to_drop/3.
nearest_could_pick_up_needed_in_to_drop(Vehicle, X, D) :-
    aggregate_all(min(D0), distance_could_pick_up_needed_in_to_drop(Vehicle, X, D0), D).
toward_could_pick_up_needed_in_to_drop(Vehicle, X, Y) :-
    step_at(X, Y),
    nearest_could_pick_up_needed_in_to_drop(Vehicle, X, D),
    nearest_could_pick_up_needed_in_to_drop(Vehicle, Y, D0),
    D0 < D.
could_pick_up_needed_capacity_to_drop(Vehicle, Location) :-
    capacity(Vehicle, Size),
    once(( capacity_predecessor(Size2, Size), needed_capacity_to_drop(Size2) )),
    package(Package),
    at(Package, Location).
:- table places_could_pick_up_needed_capacity_to_drop/2.
places_could_pick_up_needed_capacity_to_drop(Vehicle, Places) :-
    findall(Z, could_pick_up_needed_capacity_to_drop(Vehicle, Z), Found),
    sort(Found, Places).
distance_could_pick_up_needed_capacity_to_drop(Vehicle, X, D) :-
    places_could_pick_up_needed_capacity_to_drop(Vehicle, Places),
    member(Z, Places),
    steps_at(X, Z, D).
:- table nearest_could_pick_up_needed_capacity_to_drop/3.
nearest_could_pick_up_needed_capacity_to_drop(Vehicle, X, D) :-
    aggregate_all(min(D0), distance_could_pick_up_needed_capacity_to_drop(Vehicle, X, D0), D).
toward_could_pick_up_needed_capacity_to_drop(Vehicle, X, Y) :-
    step_at(X, Y),
    nearest_could_pick_up_needed_capacity_to_drop(Vehicle, X, D),
    nearest_could_pick_up_needed_capacity_to_drop(Vehicle, Y, D0),
    D0 < D.
could_pick_up_for_todo_at_any_location(Vehicle, Location) :-
    capacity(Vehicle, Size),
    once(capacity_predecessor(_Size2, Size)),
    package(Package),
    \+ in(Package, Vehicle),
    at(Package, Location),
    once(todo_at(_Locatable, Location)).
:- table places_could_pick_up_for_todo_at_any_location/2.
places_could_pick_up_for_todo_at_any_location(Vehicle, Places) :-
    findall(Z, could_pick_up_for_todo_at_any_location(Vehicle, Z), Found),
    sort(Found, Places).
distance_could_pick_up_for_todo_at_any_location(Vehicle, X, D) :-
    places_could_pick_up_for_todo_at_any_location(Vehicle, Places),
    member(Z, Places),
    steps_at(X, Z, D).
:- table nearest_could_pick_up_for_todo_at_any_location/3.
nearest_could_pick_up_for_todo_at_any_location(Vehicle, X, D) :-
    aggregate_all(min(D0), distance_could_pick_up_for_todo_at_any_location(Vehicle, X, D0), D).
toward_could_pick_up_for_todo_at_any_location(Vehicle, X, Y) :-
    step_at(X, Y),
    nearest_could_pick_up_for_todo_at_any_location(Vehicle, X, D),
    nearest_could_pick_up_for_todo_at_any_location(Vehicle, Y, D0),
    D0 < D.
could_drop(Vehicle, Location) :-
    in(Package, Vehicle),
    once(( capacity(Vehicle, Size), once(capacity_predecessor(Size, _Size2)) )),
    \+ at(Package, Location).
could_drop_todo_at(Vehicle, Location) :-
    in(Package, Vehicle),
    once(( capacity(Vehicle, Size), once(capacity_predecessor(Size, _Size2)) )),
    todo_at(Package, Location).
:- table places_could_drop_todo_at/2.
places_could_drop_todo_at(Vehicle, Places) :- findall(Z, could_drop_todo_at(Vehicle, Z), Found), sort(Found, Places).
distance_could_drop_todo_at(Vehicle, X, D) :-
    places_could_drop_todo_at(Vehicle, Places),
    member(Z, Places),
    steps_at(X, Z, D).
:- table nearest_could_drop_todo_at/3.
nearest_could_drop_todo_at(Vehicle, X, D) :- aggregate_all(min(D0), distance_could_drop_todo_at(Vehicle, X, D0), D).
toward_could_drop_todo_at(Vehicle, X, Y) :-
    step_at(X, Y),
    nearest_could_drop_todo_at(Vehicle, X, D),
    nearest_could_drop_todo_at(Vehicle, Y, D0),
    D0 < D.
could_drop_for_todo_at_any_location(Vehicle, Location) :-
    in(Package, Vehicle),
    once(( capacity(Vehicle, Size), once(capacity_predecessor(Size, _Size2)) )),
    todo_at(_Locatable, Location),
    \+ at(Package, Location).
:- table places_could_drop_for_todo_at_any_location/2.
places_could_drop_for_todo_at_any_location(Vehicle, Places) :-
    findall(Z, could_drop_for_todo_at_any_location(Vehicle, Z), Found),
    sort(Found, Places).
distance_could_drop_for_todo_at_any_location(Vehicle, X, D) :-
    places_could_drop_for_todo_at_any_location(Vehicle, Places),
    member(Z, Places),
    steps_at(X, Z, D).
:- table nearest_could_drop_for_todo_at_any_location/3.
nearest_could_drop_for_todo_at_any_location(Vehicle, X, D) :-
    aggregate_all(min(D0), distance_could_drop_for_todo_at_any_location(Vehicle, X, D0), D).
toward_could_drop_for_todo_at_any_location(Vehicle, X, Y) :-
    step_at(X, Y),
    nearest_could_drop_for_todo_at_any_location(Vehicle, X, D),
    nearest_could_drop_for_todo_at_any_location(Vehicle, Y, D0),
    D0 < D.
step_capacity(Size, Size2) :- capacity_predecessor(Size2, Size).
step_capacity(Size, Size2) :- capacity_predecessor(Size, Size2).
:- table far_capacity(_, _, min).
far_capacity(Z, Z, 0).
far_capacity(Z, X, D) :- far_capacity(Z, Y, D0), step_capacity(X, Y), D is D0+1.
:- table steps_capacity/3.
steps_capacity(X, Z, D) :- far_capacity(Z, Y, D), Y == X.
nearer_capacity(X, Y, Z) :- step_capacity(X, Y), steps_capacity(Y, Z, D), steps_capacity(X, Z, D0), D < D0.
:- table number_at_2/1.
number_at_2(N) :- findall(X, at(_Locatable, X), Found), sort(Found, Set), length(Set, N).
:- table number_todo_at_1/1.
number_todo_at_1(N) :- findall(X, todo_at(X, _Location), Found), sort(Found, Set), length(Set, N).
fewer_at_2_than_todo_at_1 :- number_at_2(N), number_todo_at_1(M), N < M.
:- table number_at_1/1.
number_at_1(N) :- findall(X, at(X, _Location), Found), sort(Found, Set), length(Set, N).
fewer_at_2_than_at_1 :- number_at_2(N), number_at_1(M), N < M.
both_todo_at_1_at_1(X) :- todo_at(X, _Location), at(X, _Location2).
:- table number_todo_at_1_at_1/1.
number_todo_at_1_at_1(N) :- findall(X, both_todo_at_1_at_1(X), Found), sort(Found, Set), length(Set, N).
fewer_at_2_than_todo_at_1_at_1 :- number_at_2(N), number_todo_at_1_at_1(M), N < M.
:- table number_todo_at_2/1.
number_todo_at_2(N) :- findall(X, todo_at(_Locatable, X), Found), sort(Found, Set), length(Set, N).
fewer_at_2_than_todo_at_2 :- number_at_2(N), number_todo_at_2(M), N < M.
:- table number_in_2/1.
number_in_2(N) :- findall(X, in(_Package, X), Found), sort(Found, Set), length(Set, N).
fewer_in_2_than_todo_at_1 :- number_in_2(N), number_todo_at_1(M), N < M.
:- table number_in_1/1.
number_in_1(N) :- findall(X, in(X, _Vehicle), Found), sort(Found, Set), length(Set, N).
fewer_in_2_than_in_1 :- number_in_2(N), number_in_1(M), N < M.
:- table number_capacity_1/1.
number_capacity_1(N) :- findall(X, capacity(X, _Size), Found), sort(Found, Set), length(Set, N).
fewer_capacity_1_than_todo_at_1 :- number_capacity_1(N), number_todo_at_1(M), N < M.
fewer_capacity_1_than_in_1 :- number_capacity_1(N), number_in_1(M), N < M.
fewer_in_2_than_todo_at_2 :- number_in_2(N), number_todo_at_2(M), N < M.
fewer_in_2_than_at_2 :- number_in_2(N), number_at_2(M), N < M.
both_todo_at_2_at_2(X) :- todo_at(_Locatable, X), at(_Locatable2, X).
:- table number_todo_at_2_at_2/1.
number_todo_at_2_at_2(N) :- findall(X, both_todo_at_2_at_2(X), Found), sort(Found, Set), length(Set, N).
fewer_in_2_than_todo_at_2_at_2 :- number_in_2(N), number_todo_at_2_at_2(M), N < M.
fewer_capacity_1_than_todo_at_2 :- number_capacity_1(N), number_todo_at_2(M), N < M.
fewer_capacity_1_than_at_2 :- number_capacity_1(N), number_at_2(M), N < M.
fewer_capacity_1_than_todo_at_2_at_2 :- number_capacity_1(N), number_todo_at_2_at_2(M), N < M.
:- table number_capacity_2/1.
number_capacity_2(N) :- findall(X, capacity(_Vehicle, X), Found), sort(Found, Set), length(Set, N).
fewer_capacity_2_than_todo_at_1 :- number_capacity_2(N), number_todo_at_1(M), N < M.
fewer_capacity_2_than_in_1 :- number_capacity_2(N), number_in_1(M), N < M.
fewer_capacity_2_than_todo_at_2 :- number_capacity_2(N), number_todo_at_2(M), N < M.
fewer_capacity_2_than_at_2 :- number_capacity_2(N), number_at_2(M), N < M.
fewer_capacity_2_than_todo_at_2_at_2 :- number_capacity_2(N), number_todo_at_2_at_2(M), N < M.
