:- use_module('../../prolog/state_text').
:- use_module('../../prolog/loading').
:- use_module(worlds).

:- dynamic sea/1.

:- begin_tests(state_text, [ setup((ferry([], M), assertz(user:sea(M)))),
                             cleanup((retract(user:sea(M)), unload_domain(M))) ]).

facts(Text, Facts) :-
    sea(M),
    read_state(M, Text, ['boat/1', 'car/2', 'fuel/1'], [], Facts).

test(sorted, Facts == [boat(left), fuel(2), car(c1, left)]) :-
    facts('fuel(2), car(c1, left), boat(left), fuel(2)', Facts).
test(empty, Facts == []) :-
    facts('', Facts).
test(no_list, throws(nppg_problems([-('', 0, 0, _)]))) :-
    facts('boat(', _).
test(open_list, throws(nppg_problems([-('', 0, 0, _)]))) :-
    facts('boat(left)|More', _).
test(no_fluent, throws(nppg_problems([-('', 0, 0,
                                       'ship(left) is no fact of a declared fluent', 'ship/1', ['boat/1', 'car/2', 'fuel/1'])]))) :-
    facts('boat(left), ship(left)', _).
test(unbound, throws(nppg_problems([-('', 0, 0, 'boat(_) is no fact (it has an unbound variable)')]))) :-
    facts('boat(_)', _).
test(static_facts_apart, [ setup(roads([], M)), cleanup(unload_domain(M)), Static-Facts == [road(a, b)]-[at(a)] ]) :-
    read_state(M, 'road(a, b), at(a)', [], Static, Facts).

:- end_tests(state_text).
