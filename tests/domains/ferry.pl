:- module(ferry, []).

% A ferry takes cars across a river, one at a time; in a storm it stays where it is. Fuel runs out.

:- fluent boat/1, car/2, fuel/1.
:- parameter(cars, 2).
:- parameter(storm, 0.25).

opposite(left, right).
opposite(right, left).

waiting(Car) :- boat(Side), car(Car, Side).

action(cross).
action(carry(Car)) :- waiting(Car).

% With the probability `storm` only fuel is used up.

effect(Action, P, [fuel(F)|Delete], [fuel(Less)|Add]) :-
    fuel(F),
    Less is F - 1,
    parameter(storm, Storm),
    moved(Action, Gone, New),
    (   P is 1 - Storm, Delete = Gone, Add = New
    ;   P = Storm, Delete = [], Add = []
    ).

moved(cross, [boat(From)], [boat(To)]) :- boat(From), opposite(From, To).
moved(carry(Car), [car(Car, From)|Delete], [car(Car, To)|Add]) :-
    moved(cross, Delete, Add),
    Delete = [boat(From)],
    Add = [boat(To)].

goal :- \+ car(_, left).

terminal :- fuel(0).

reward(_, R) :- ( goal -> R = 10 ; R = -1 ).

horizon(N) :- fuel(N).

expert(carry(Car)) :- boat(left), waiting(Car).
expert(cross)      :- boat(right).

start([boat(left), fuel(Fuel)|Cars]) :-
    parameter(cars, N),
    N > 0,
    numlist(1, N, Numbers),
    findall(car(Car, left), ( member(I, Numbers), atom_concat(c, I, Car) ), Cars),
    Fuel is N + 1.
