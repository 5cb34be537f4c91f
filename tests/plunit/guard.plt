:- use_module('../../prolog/guard').

:- begin_tests(guard).

g(Goal) :-
    guarded(m:p/0, Goal).

test(true) :-
    g(true).
test(once, all(X == [1])) :-
    g(member(X, [1, 2])).
test(fails, fail) :-
    g(fail).
test(throws, throws(nppg_fault(m:p/0, oops))) :-
    g(throw(oops)).
test(loops, throws(nppg_fault(m:p/0, inference_limit(1 000 000)))) :-
    g((repeat, fail)).
test(limit_restored, Result == inference_limit_exceeded) :-
    call_with_inference_limit(( catch(g((repeat, fail)), _, true), repeat, fail ), 5 000 000, Result).
test(own_limit_of_a_domain, Result == inference_limit_exceeded) :-
    g(call_with_inference_limit((repeat, fail), 1000, Result)).
test(all, Answers == [1, 2]) :-
    guarded_findall(X, m:p/1, member(X, [1, 2]), Answers).
test(none, Answers == []) :-
    guarded_findall(_, m:p/1, fail, Answers).
test(halt, throws(nppg_halt)) :-
    tame(guarded),
    assertz(guarded:(stop :- halt)),
    call(guarded:stop).
test(halt_1, throws(nppg_halt)) :-
    tame(more_guarded),
    assertz(more_guarded:(stop :- halt(1))),
    call(more_guarded:stop).
test(nothing_stopped, fail) :-
    stopped(_).
test(stopped, Fault-Again == why-none) :-
    stop_for(why),
    stopped(Fault),
    ( stopped(Again) -> true ; Again = none ).

:- end_tests(guard).
