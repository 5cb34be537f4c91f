:- use_module('../../prolog/loading').
:- use_module('../../prolog/state_text').
:- use_module(worlds).

:- dynamic told/1.

:- begin_tests(state_text, [ setup((ferry([], M), assertz(user:told(M)))),
                             cleanup((retract(user:told(M)), unload_domain(M))) ]).

state(Text, Facts) :-
    user:told(Module),
    read_state(Module, Text, ['at/2', 'boat/1'], Facts).

test(sorted, Facts == []) :-
    state("", Facts).
test(no_fluent, throws(nppg_problems([-('', 0, 0, _, 'att/2', ['at/2', 'boat/1'])]))) :-
    state("att(a, b)", _).
test(number, throws(nppg_problems([-('', 0, 0, '3 is no fact of a declared fluent', '', _)]))) :-
    state("3", _).
test(syntax, throws(nppg_problems([-('', 0, 0, _)]))) :-
    state("att(a", _).

:- end_tests(state_text).
