:- use_module('../../prolog/randomness').
:- use_module(library(janus), []).

% Python's side, for a Prolog without Python: a fixed row of numbers.

:- begin_tests(randomness, [condition(catch(janus:py_call('nppg.prolog':uniform(1), _), _, fail))]).

test(unseeded, throws(nppg_unseeded)) :-
    random(_).
test(empty_range, fail) :-
    random_between(2, 1, _).
test(no_member, fail) :-
    random_member(_, []).
test(empty_permutation, Permutation == []) :-
    random_permutation([], Permutation).

:- end_tests(randomness).
