:- use_module('../../prolog/safety').

:- begin_tests(safety).

seen(Term, Seen) :-
    guarding('/nowhere', ( gate(Term, safety_test, Terms) -> Seen = Terms ; Seen = same )).

test(as_it_is, all(Seen == [same, same, same, same])) :-
    member(Term, [p(a), ( p(X) :- q(X) ), ( :- table(p/1) ), ( :- use_module(library(lists)) )]),
    seen(Term, Seen).

test(built_later, Seen == ( p(G) :- nppg_late:checked(safety_test, G) )) :-
    seen(( p(G) :- G ), Seen).

test(refused, all(Seen == [refused, refused, refused, refused])) :-
    member(Term, [( :- shell(x) ), ( user:portray(_) :- true ), [(:- shell(x))], ( :- use_module(library(shell)) )]),
    catch(seen(Term, Seen), nppg_refused(_, _), Seen = refused).

test(not_guarded, fail) :-
    gate(( :- shell(x) ), safety_test, _).

:- end_tests(safety).
