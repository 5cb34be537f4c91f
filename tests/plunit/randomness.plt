:- use_module('../../prolog/randomness').
:- use_module(library(janus), []).

seeded(Goal) :-
    janus:py_call('numpy.random':default_rng(0), Generator),
    janus:py_call('nppg.bridge.prolog':randomness(Generator), Context),
    setup_call_cleanup(
        janus:py_call(Context:'__enter__'(), _),
        once(Goal),
        janus:py_call(Context:'__exit__'(@none, @none, @none), _)).

% The mean of the powers of Xs.

moment(Xs, Power, Moment) :-
    length(Xs, Count),
    foldl([X, S0, S]>>(S is S0 + X ** Power), Xs, 0, Sum),
    Moment is Sum / Count.

:- begin_tests(randomness, [condition(catch(janus:py_call('nppg.bridge.prolog':uniform(1), _), _, fail))]).

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

test(normal_moments) :-
    seeded(findall(Z, ( between(1, 20 000, _), random_normal(3, 2, X), Z is (X - 3) / 2 ), Zs)),
    forall(member(Power-Expected, [1-0, 2-1, 3-0, 4-3]),
           ( moment(Zs, Power, Moment), abs(Moment - Expected) < 0.03 * Power ** 2 )).
test(normal_without_deviation, X == 3.0) :-
    seeded(random_normal(3, 0, X)).
test(normal_is_reproduced, X == Y) :-
    seeded(random_normal(0, 1, X)),
    seeded(random_normal(0, 1, Y)).

:- end_tests(randomness).
