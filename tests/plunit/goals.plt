:- use_module('../../prolog/goals').

:- begin_tests(goals).

test(as_it_is, Body == Checked) :-
    Body = ( findall(X, ( member(X, [1]), \+ X = 2 ), _), maplist(succ, [1], _), own(_) ),
    checked_body(m, Body, Checked).

test(built_later, Checked == ( nppg_late:checked(m, G), maplist(nppg_late:checked(m, G), [1]) )) :-
    checked_body(m, ( G, maplist(G, [1]) ), Checked).

test(refused, throws(nppg_refused(shell/1, ''))) :-
    checked_body(m, ( true ; \+ forall(true, shell(x)) ), _).

test(other_module, throws(nppg_refused(system:shell/1, _))) :-
    checked_body(m, system:shell(x), _).

test(what_a_file_may_define, all(Name/Arity == [shell/1])) :-
    noted(checked_body(m, ( shell(x), shell(y) ), _)),
    doubt(m, Name, Arity, _, _).

:- end_tests(goals).
