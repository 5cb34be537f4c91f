:- use_module('../../prolog/values').

:- begin_tests(values).

facts(Facts) :-
    setup_call_cleanup(
        assertz(toy_boat:nppg_fluent(boat/1)),
        must_be_facts(toy_boat, start/1, Facts),
        retractall(toy_boat:nppg_fluent(_))).

test(proper) :-
    proper([f(a, 1, 2.5), []]).
test(improper, Defects == [' (it has an unbound variable)', ' (it contains itself)',
                           ' (only names, integers, floats and compounds of them can be part of one)']) :-
    Circle = f(Circle),
    findall(Defect, ( member(Term, [f(_), Circle, f("text")]), \+ proper(Term), defect(Term, Defect) ), Defects).
test(finite, Finite == [1, 2.5]) :-
    Infinite is inf,
    NaN is nan,
    findall(Number, ( member(Number, [1, 2.5, Infinite, NaN, a]), finite(Number) ), Finite).
test(facts) :-
    facts([boat(left)]).
test(no_fact, throws(nppg_fault(toy_boat:(start/1),
                              'gave ~w, which is no fact of a declared fluent~w,'-[car(c1), '']))) :-
    facts([boat(left), car(c1)]).
test(no_facts, throws(nppg_fault(toy_boat:(start/1), 'gave ~w where a list of facts is wanted,'-[boat(left)]))) :-
    facts(boat(left)).
test(no_action, throws(nppg_fault(m:(action/1), 'gave ~w, which is no action~w,'-[7, '']))) :-
    must_be_actions(m, action/1, [go, 7]).

:- end_tests(values).
