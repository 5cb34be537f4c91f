:- module(spanner, []).

% The PDDL domain spanner. What no action changes is static: it belongs to the problem. So do its goals:
% goal_tightened(N) says that tightened(N) is wanted, condition/1 has what is wanted beyond such facts, and goals/1 says
% how many literals that is in all.

:- pddl('domain.pddl').
:- static location/1, locatable/1, man/1, nut/1, spanner/1, link/2, goal_tightened/1, goals/1, condition/1.
:- fluent at/2, carrying/2, usable/1, tightened/1, loose/1.
:- dead_ends.
:- discontiguous action/1, effect/3.

% walk
action(walk(Start, End, M)) :- link(Start, End), at(M, Start), man(M).
effect(walk(Start, End, M), [at(M, Start)], [at(M, End)]).

% pickup_spanner
action(pickup_spanner(L, S, M)) :- at(M, L), man(M), at(S, L), spanner(S).
effect(pickup_spanner(L, S, M), [at(S, L)], [carrying(M, S)]).

% tighten_nut
action(tighten_nut(L, S, M, N)) :- carrying(M, S), usable(S), loose(N), at(M, L), at(N, L).
effect(tighten_nut(_L, S, _M, N), [loose(N), usable(S)], [tightened(N)]).

goal :- \+ ( goal_tightened(N), \+ tightened(N) ), \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_tightened(N) :- goal_tightened(N), \+ tightened(N).
done_tightened(N) :- goal_tightened(N), tightened(N).

% derived from the types and the actions
:- table beyond_link/2.
beyond_link(X, Y) :- link(X, Y).
beyond_link(X, Y) :- beyond_link(X, Z), link(Z, Y).
step_at(Location, Location2) :- link(Location, Location2).
:- table far_at(_, _, min).
far_at(Z, Z, 0).
far_at(Z, X, D) :- far_at(Z, Y, D0), step_at(X, Y), D is D0+1.
:- table steps_at/3.
steps_at(X, Z, D) :- far_at(Z, Y, D), Y == X.
nearer_at(X, Y, Z) :- step_at(X, Y), steps_at(Y, Z, D), steps_at(X, Z, D0), D < D0.
could_pickup_spanner(Man, Location) :- man(Man), spanner(Spanner), \+ carrying(Man, Spanner), at(Spanner, Location).
:- table places_could_pickup_spanner/2.
places_could_pickup_spanner(Man, Places) :- findall(Z, could_pickup_spanner(Man, Z), Found), sort(Found, Places).
distance_could_pickup_spanner(Man, X, D) :-
    places_could_pickup_spanner(Man, Places),
    member(Z, Places),
    steps_at(X, Z, D).
:- table nearest_could_pickup_spanner/3.
nearest_could_pickup_spanner(Man, X, D) :- aggregate_all(min(D0), distance_could_pickup_spanner(Man, X, D0), D).
toward_could_pickup_spanner(Man, X, Y) :-
    step_at(X, Y),
    nearest_could_pickup_spanner(Man, X, D),
    nearest_could_pickup_spanner(Man, Y, D0),
    D0 < D.
could_tighten_nut(Man, Location) :-
    carrying(Man, Spanner),
    usable(Spanner),
    loose(Nut),
    \+ tightened(Nut),
    at(Nut, Location).
:- table places_could_tighten_nut/2.
places_could_tighten_nut(Man, Places) :- findall(Z, could_tighten_nut(Man, Z), Found), sort(Found, Places).
distance_could_tighten_nut(Man, X, D) :- places_could_tighten_nut(Man, Places), member(Z, Places), steps_at(X, Z, D).
:- table nearest_could_tighten_nut/3.
nearest_could_tighten_nut(Man, X, D) :- aggregate_all(min(D0), distance_could_tighten_nut(Man, X, D0), D).
toward_could_tighten_nut(Man, X, Y) :-
    step_at(X, Y),
    nearest_could_tighten_nut(Man, X, D),
    nearest_could_tighten_nut(Man, Y, D0),
    D0 < D.
:- table number_at_2/1.
number_at_2(N) :- findall(X, at(_Locatable, X), Found), sort(Found, Set), length(Set, N).
:- table number_todo_tightened/1.
number_todo_tightened(N) :- findall(X, todo_tightened(X), Found), sort(Found, Set), length(Set, N).
fewer_at_2_than_todo_tightened :- number_at_2(N), number_todo_tightened(M), N < M.
:- table number_at_1/1.
number_at_1(N) :- findall(X, at(X, _Location), Found), sort(Found, Set), length(Set, N).
fewer_at_2_than_at_1 :- number_at_2(N), number_at_1(M), N < M.
:- table number_carrying_2/1.
number_carrying_2(N) :- findall(X, carrying(_Man, X), Found), sort(Found, Set), length(Set, N).
fewer_carrying_2_than_todo_tightened :- number_carrying_2(N), number_todo_tightened(M), N < M.
fewer_carrying_2_than_at_1 :- number_carrying_2(N), number_at_1(M), N < M.
:- table number_usable/1.
number_usable(N) :- findall(X, usable(X), Found), sort(Found, Set), length(Set, N).
fewer_usable_than_at_1 :- number_usable(N), number_at_1(M), N < M.
both_carrying_2_usable(X) :- carrying(_Man, X), usable(X).
:- table number_carrying_2_usable/1.
number_carrying_2_usable(N) :- findall(X, both_carrying_2_usable(X), Found), sort(Found, Set), length(Set, N).
fewer_carrying_2_usable_than_todo_tightened :- number_carrying_2_usable(N), number_todo_tightened(M), N < M.
fewer_carrying_2_usable_than_at_1 :- number_carrying_2_usable(N), number_at_1(M), N < M.
:- table number_carrying_1/1.
number_carrying_1(N) :- findall(X, carrying(X, _Spanner), Found), sort(Found, Set), length(Set, N).
fewer_carrying_1_than_todo_tightened :- number_carrying_1(N), number_todo_tightened(M), N < M.
