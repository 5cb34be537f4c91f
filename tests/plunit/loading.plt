:- use_module('../../prolog/loading').
:- use_module('../../prolog/domain').
:- use_module('../../prolog/interpretation').
:- use_module(worlds).

:- begin_tests(loading).

at([boat(left), fuel(3), car(c1, left), car(c2, left)]).

test(two_instances, [setup(ferry([], M)), cleanup((unload_domain(M), unload_domain(Other))),
                     true(Here-There == [c1, c2]-[])]) :-
    at(Facts),
    ferry([], Other),
    interpret(M, Facts),
    interpret(Other, [boat(left), fuel(1)]),
    objects(M, waiting, Here),
    objects(Other, waiting, There).
test(defines, [cleanup(unload_domain(Module)), nondet]) :-
    ferry([], Module),
    defines(Module, goal/0).
test(unloaded, Defined-Facts == []-[]) :-
    ferry([], Module),
    interpret(Module, [boat(left)]),
    unload_domain(Module),
    findall(Indicator, defines(Module, Indicator), Defined),
    interpretation(Module, Facts).
test(no_file, throws(nppg_problems([-('no such file.pl', 0, 0, _)]))) :-
    load_domain('no such file.pl', [], _, _).

:- end_tests(loading).
