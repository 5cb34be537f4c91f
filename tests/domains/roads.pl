:- module(roads, []).

% Go along roads, which are static, to the place that a problem asks for; d is a dead end.

:- static road/2, goal_at/1.
:- fluent at/1.
:- dead_ends.

problem(1, [at(a), goal_at(c), road(a, b), road(b, c)]).
problem(2, [at(a), goal_at(c), road(a, d), road(a, c)]).

action(go(To)) :- at(From), road(From, To).
effect(go(To), [at(From)], [at(To)]) :- at(From).
effect(build(X), [], [road(X, X)]).
goal :- at(X), goal_at(X).
cost(go(_), 2).
horizon(5).
