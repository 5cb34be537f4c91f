:- use_module('../../prolog/declarations').
:- use_module('../../prolog/domain').
:- use_module('../../prolog/loading').
:- use_module(worlds).

:- begin_tests(declarations).

test(parameter, [cleanup(unload_domain(Module)), Facts == [boat(left), fuel(2), car(c1, left)]]) :-
    ferry([[cars, 1]], Module),
    start(Module, Facts).
test(wrong_kind, throws(nppg_problems([-(_, _, 0, 'the parameter cars must be a whole number, not many')]))) :-
    ferry([[cars, many]], _).
test(heard, Problems == [-('a.pl', 2, 0, first), -('a.pl', 1, 0, second)]) :-
    reading(m, m, 'a.pl', [], ( heard(-('a.pl', 2, 0, first)), heard(-('a.pl', 1, 0, second)) ), Problems, []).

:- end_tests(declarations).
