:- use_module('../../prolog/waiting', []).

:- begin_tests(waiting).

test(sleep, true(Seconds >= 0.15)) :-
    get_time(Begin),
    nppg_waiting:sleep(0.15),
    get_time(End),
    Seconds is End-Begin.

test(no_number, error(type_error(evaluable, _))) :-
    nppg_waiting:sleep(a).

test(past, true) :-
    nppg_waiting:sleep(-1).

:- end_tests(waiting).
