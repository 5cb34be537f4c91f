:- module(logistics, []).

% Vans carry parcels between the sites of their town, a plane between the first sites of the towns. Odd problems have one
% parcel, even ones two, those from 31 on three.

:- static road/2, air/2, van/1, plane/1, goal_in/2.
:- fluent at/2, in/2, inside/2.

action(drive(V, X, Y))  :- van(V), at(V, X), road(X, Y).
action(fly(V, X, Y))    :- plane(V), at(V, X), air(X, Y).
action(load(P, V, X))   :- at(V, X), in(P, X).
action(unload(P, V, X)) :- at(V, X), inside(P, V).

effect(drive(V, X, Y), [at(V, X)], [at(V, Y)]).
effect(fly(V, X, Y), [at(V, X)], [at(V, Y)]).
effect(load(P, V, X), [in(P, X)], [inside(P, V)]).
effect(unload(P, V, X), [inside(P, V)], [in(P, X)]).

todo_in(P, X) :- goal_in(P, X), \+ in(P, X).

% The next leg of a parcel that is not where it is wanted, by what carries it: by van to where it is wanted, if that is in
% this town, else to the field; by plane from field to field.

leg(V, P, Z) :- van(V), todo_in(P, G), place(P, X), ( road(X, G) -> Z = G ; road(X, Z), air(Z, _) ).
leg(V, P, Z) :- plane(V), todo_in(P, G), place(P, X), air(X, Z), X \== G, \+ road(X, G).

place(P, X) :- in(P, X).
place(P, X) :- inside(P, V), at(V, X).

goal :- \+ todo_in(_, _).

horizon(N) :- aggregate_all(count, goal_in(_, _), Parcels), N is 8 * Parcels + 10.

site(a, a1).
site(a, a2).
site(b, b1).
site(b, b2).

problem(N, [at(va, VanA), at(vb, VanB), at(p, Plane), van(va), van(vb), plane(p), air(a1, b1), air(b1, a1)|Facts]) :-
    between(1, 50, N),
    ( N > 30 -> Parcels = 3 ; Parcels is 2 - N mod 2 ),
    maplist(drawn(N), [1, 2, 3], [[a1, a2], [b1, b2], [a1, b1]], [VanA, VanB, Plane]),
    findall(road(X, Y), ( site(Town, X), site(Town, Y), X \== Y ), Roads),
    findall([in(q(I), X), goal_in(q(I), Y)], ( between(1, Parcels, I), way(N, I, X, Y) ), Lists),
    append([Roads|Lists], Facts).

% What is drawn hangs on the number of the problem alone.

drawn(N, I, List, One) :- length(List, L), term_hash(draw(N, I), Hash), Index is Hash mod L, nth0(Index, List, One).

way(N, I, X, Y) :-
    findall(S, site(_, S), Sites),
    drawn(N, from(I), Sites, X),
    exclude(==(X), Sites, Others),
    drawn(N, to(I), Others, Y).
