:- use_module('../../prolog/interpretation').
:- use_module('../../prolog/loading').
:- use_module('../../prolog/states').
:- use_module(worlds).

:- dynamic town/1.

:- begin_tests(states, [ setup((roads([], M), assertz(user:town(M)))),
                         cleanup((retract(user:town(M)), unload_domain(M))) ]).

test(problems, Numbers == [1, 2]) :-
    town(M),
    problem_numbers(M, Numbers).
test(begin, Facts == [[at, a]]) :-
    town(M),
    begin(M, 1, [Static, Facts]),
    static_of(M, Static, [[goal_at, c], [road, a, b], [road, b, c]]).
test(no_such_problem, Start == []) :-
    town(M),
    begin(M, 3, Start).
test(a_change_and_a_situation, Answer == [0, [[at, a]], [[at, b]], [running, [[go, c]]]]) :-
    town(M),
    begin(M, 1, _),
    take(M, false, [go, b], _, Answer).
test(dead_end, Situation == [terminal, []]) :-
    town(M),
    begin(M, 2, _),
    take(M, false, [go, d], _, [0, _, _, Situation]).
test(outcomes_of, Outcomes == [[[1, [[at, a]], [[at, b]]]], [[1, [[at, a]], [[at, b]]]]]) :-
    town(M),
    begin(M, 1, _),
    outcomes_of(M, [[go, b], [go, b]], Outcomes).
test(step_back, Situation == [running, [[go, b]]]) :-
    town(M),
    begin(M, 1, _),
    take(M, false, [go, b], _, _),
    step(M, [[at, b]], [[at, a]], true),
    situation(M, Situation).
test(visit_with_static_facts, Situation == [running, [[go, z]]]) :-
    town(M),
    keep_static(M, [[road, y, z]], Number),
    visit(M, Number, [[at, y]], true),
    situation(M, Situation).
test(only_static, throws(nppg_fault(_:(problem/2), '~w is not static'-[at(a)]))) :-
    town(M),
    keep_static(M, [[at, a]], _).
test(no_effect_on_static_facts, throws(nppg_fault(_:(effect/3), _))) :-
    town(M),
    begin(M, 1, _),
    take(M, false, [build, a], _, _).
test(cost, Cost == 2) :-
    town(M),
    begin(M, 1, _),
    cost_of(M, [go, b], Cost).

:- end_tests(states).
