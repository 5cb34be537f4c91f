:- module(cars, []).

% A ferry carries cars, one at a time, each to its place.

:- fluent ferry/1, at/2, empty/0, on/1, goal_at/2, place/1.
:- parameter(cars, 2).
:- parameter(places, 3).

action(sail(From, To)) :- ferry(From), place(To), From \== To.
action(board(C, L))    :- ferry(L), at(C, L), empty.
action(debark(C, L))   :- ferry(L), on(C).

effect(sail(From, To), [ferry(From)], [ferry(To)]).
effect(board(C, L), [at(C, L), empty], [on(C)]).
effect(debark(C, L), [on(C)], [at(C, L), empty]).

goal :- \+ misplaced(_, _), empty.

misplaced(C, L) :- at(C, L), \+ goal_at(C, L).

reward(_, R) :- goal -> R = 1 ; R = 0.

horizon(N) :- parameter(cars, Cars), N is 8*Cars.

start([ferry(Here), empty|Facts]) :-
    parameter(cars, N),
    parameter(places, M),
    numlist(1, M, Places),
    random_member(Here, Places),
    findall([at(C, From), goal_at(C, To)],
            ( between(1, N, I), atom_concat(c, I, C), random_member(From, Places), random_member(To, Places) ), Lists),
    append(Lists, Cars),
    findall(place(L), member(L, Places), All),
    append(Cars, All, Facts).
