:- use_module('../../prolog/randomness').
:- use_module(library(janus), []).

% Python's side, for a Prolog without Python: a fixed row of numbers.

:- begin_tests(randomness, [condition(catch(janus:py_call('nppg.prolog':uniform(1), _), _, fail))]).

test(unseeded, throws(nppg_unseeded)) :-
    random(_).
test(without_draws, throws(nppg_unseeded)) :-
    without_draws(random(_)).
test(without_draws_once, all(X == [1])) :-
    without_draws(member(X, [1, 2])).
test(without_draws_failing, fail) :-
    without_draws(fail).
test(empty_range, fail) :-
    random_between(2, 1, _).
test(no_member, fail) :-
    random_member(_, []).
test(empty_permutation, Permutation == []) :-
    random_permutation([], Permutation).

:- end_tests(randomness).
