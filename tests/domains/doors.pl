:- module(doors, []).

% Rooms in a row, each with four doors: one leads on, the others back to the first room. Problem N has N rooms before the
% last one.

:- static leads_on/2, last/1.
:- fluent room/1.

problem(N, [room(1), last(Last)|Doors]) :-
    between(1, 9, N),
    Last is N + 1,
    findall(leads_on(Room, Door), ( between(1, N, Room), Door is Room * Room mod 4 + 1 ), Doors).

action(open(Door)) :- between(1, 4, Door).

effect(open(Door), [room(X)], [room(Y)]) :- room(X), ( leads_on(X, Door) -> Y is X + 1 ; Y = 1 ).

goal :- room(X), last(X).

horizon(N) :- last(N).
