:- use_module('../../prolog/late').

:- begin_tests(late).

test(lambda, Found == [2, 3]) :-
    Lambda = [X, Y]>>(Y is X+1),
    findall(Z, ( member(A, [1, 2]), checked(m, Lambda, A, Z) ), Found).

test(late, throws(nppg_refused(shell/1, ''))) :-
    checked(m, shell, x).

:- end_tests(late).
