:- module(miconic, []).

% The PDDL domain miconic. What no action changes is static: it belongs to the problem. So do its goals:
% goal_served(Person) says that served(Person) is wanted, condition/1 has what is wanted beyond such facts, and goals/1
% says how many literals that is in all.

:- pddl('domain.pddl').
:- static passenger/1, floor/1, destin/2, above/2, goal_served/1, goals/1, condition/1.
:- fluent origin/2, boarded/1, served/1, lift_at/1.
:- dead_ends.
:- discontiguous action/1, effect/3.

% board
action(board(F, P)) :- lift_at(F), origin(P, F).
effect(board(F, P), [origin(P, F)], [boarded(P)]).

% depart
action(depart(F, P)) :- lift_at(F), boarded(P), destin(P, F).
effect(depart(_F, P), [boarded(P)], [served(P)]).

% up
action(up(F1, F2)) :- lift_at(F1), above(F1, F2).
effect(up(F1, F2), [lift_at(F1)], [lift_at(F2)]).

% down
action(down(F1, F2)) :- lift_at(F1), above(F2, F1).
effect(down(F1, F2), [lift_at(F1)], [lift_at(F2)]).

goal :- \+ ( goal_served(Person), \+ served(Person) ), \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_served(Person) :- goal_served(Person), \+ served(Person).
done_served(Person) :- goal_served(Person), served(Person).

% derived from the types and the actions
:- table beyond_above/2.
beyond_above(X, Y) :- above(X, Y).
beyond_above(X, Y) :- beyond_above(X, Z), above(Z, Y).
needed_lift_at_to_depart(Floor) :-
    destin(Passenger, Floor),
    todo_served(Passenger),
    \+ ( destin(Passenger, Floor2), lift_at(Floor2) ).
needed_boarded_to_depart(Passenger) :- todo_served(Passenger), \+ boarded(Passenger).
could_board(Floor) :- origin(Passenger, Floor), \+ boarded(Passenger).
:- table places_could_board/1.
places_could_board(Places) :- findall(Z, could_board(Z), Found), sort(Found, Places).
step_lift_at(Floor, Floor2) :- above(Floor, Floor2).
step_lift_at(Floor, Floor2) :- above(Floor2, Floor).
:- table far_lift_at(_, _, min).
far_lift_at(Z, Z, 0).
far_lift_at(Z, X, D) :- far_lift_at(Z, Y, D0), step_lift_at(X, Y), D is D0+1.
:- table steps_lift_at/3.
steps_lift_at(X, Z, D) :- far_lift_at(Z, Y, D), Y == X.
distance_could_board(X, D) :- places_could_board(Places), member(Z, Places), steps_lift_at(X, Z, D).
:- table nearest_could_board/2.
nearest_could_board(X, D) :- aggregate_all(min(D0), distance_could_board(X, D0), D).
toward_could_board(X, Y) :- step_lift_at(X, Y), nearest_could_board(X, D), nearest_could_board(Y, D0), D0 < D.
could_board_through_destin_back_for_todo_served_1_floor(Floor) :-
    todo_served(Passenger),
    destin(Passenger, Floor),
    once(( origin(Passenger2, Floor), \+ boarded(Passenger2) )).
:- table places_could_board_through_destin_back_for_todo_served_1_floor/1.
places_could_board_through_destin_back_for_todo_served_1_floor(Places) :-
    findall(Z, could_board_through_destin_back_for_todo_served_1_floor(Z), Found),
    sort(Found, Places).
distance_could_board_through_destin_back_for_todo_served_1_floor(X, D) :-
    places_could_board_through_destin_back_for_todo_served_1_floor(Places),
    member(Z, Places),
    steps_lift_at(X, Z, D).
:- table nearest_could_board_through_destin_back_for_todo_served_1_floor/2.
nearest_could_board_through_destin_back_for_todo_served_1_floor(X, D) :-
    aggregate_all(min(D0), distance_could_board_through_destin_back_for_todo_served_1_floor(X, D0), D).
toward_could_board_through_destin_back_for_todo_served_1_floor(X, Y) :-
    step_lift_at(X, Y),
    nearest_could_board_through_destin_back_for_todo_served_1_floor(X, D),
    nearest_could_board_through_destin_back_for_todo_served_1_floor(Y, D0),
    D0 < D.
could_depart(Floor) :- boarded(Passenger), \+ served(Passenger), destin(Passenger, Floor).
:- table places_could_depart/1.
places_could_depart(Places) :- findall(Z, could_depart(Z), Found), sort(Found, Places).
distance_could_depart(X, D) :- places_could_depart(Places), member(Z, Places), steps_lift_at(X, Z, D).
:- table nearest_could_depart/2.
nearest_could_depart(X, D) :- aggregate_all(min(D0), distance_could_depart(X, D0), D).
toward_could_depart(X, Y) :- step_lift_at(X, Y), nearest_could_depart(X, D), nearest_could_depart(Y, D0), D0 < D.
:- table number_lift_at/1.
number_lift_at(N) :- findall(X, lift_at(X), Found), sort(Found, Set), length(Set, N).
:- table number_todo_served/1.
number_todo_served(N) :- findall(X, todo_served(X), Found), sort(Found, Set), length(Set, N).
fewer_lift_at_than_todo_served :- number_lift_at(N), number_todo_served(M), N < M.
:- table number_boarded/1.
number_boarded(N) :- findall(X, boarded(X), Found), sort(Found, Set), length(Set, N).
fewer_lift_at_than_boarded :- number_lift_at(N), number_boarded(M), N < M.
