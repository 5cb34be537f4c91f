:- module(chain, []).

% A walk along cells to the last one, where episodes end. There is no goal, and one kind of action: its argument is the
% direction.

:- fluent cell/1.
:- parameter(cells, 4).

action(step(0)).
action(step(1)).

effect(step(D), [cell(X)], [cell(Y)]) :- cell(X), Y is max(1, X + 2 * D - 1).

terminal :- cell(X), parameter(cells, X).

reward(_, R) :- ( terminal -> R = 1 ; R = -0.1 ).

horizon(12).

start([cell(X)]) :- parameter(cells, N), Last is N - 1, random_between(1, Last, X).
