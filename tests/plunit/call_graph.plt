:- use_module('../../prolog/call_graph').

:- begin_tests(call_graph).

setup_walk :-
    dynamic([walk:nppg_fluent/1, walk:nppg_static/1, walk:at/1, walk:road/2, walk:loose/1]),
    assertz(walk:nppg_fluent(at/1)),
    assertz(walk:nppg_static(road/2)),
    maplist(clause_of_walk,
            [ (next(A, B) :- road(A, B) ; road(B, A)),
              (path(A, B) :- next(A, C), ( B = C ; path(C, B) )),
              (open(A) :- \+ forall(next(A, B), B == A)),
              (here(A) :- findall(B, (at(B), road(B, _)), [A|_])),
              (near(A) :- here(B), next(A, B)),
              (any(G, A) :- call(G, A)),
              (drawn(A) :- A is random(5)),
              (counted(A) :- nb_getval(count, A)),
              (said(A) :- loose(A)) ]).

clause_of_walk(Clause) :-
    walk:assertz(Clause),
    ( Clause = (Head :- _) ; Head = Clause ),
    !,
    functor(Head, Name, Arity),
    compile_predicates([walk:Name/Arity]).

teardown_walk :-
    forall(member(Indicator, [next/2, path/2, open/1, here/1, near/1, any/2, drawn/1, counted/1, said/1, at/1, road/2, loose/1,
                              nppg_fluent/1, nppg_static/1]),
           abolish(walk:Indicator)).

test(static, [setup(setup_walk), cleanup(teardown_walk), all(Name/Arity == [next/2, path/2, open/1, road/2])]) :-
    member(Name/Arity, [next/2, path/2, open/1, here/1, near/1, any/2, drawn/1, counted/1, said/1, at/1, road/2]),
    static_predicate(walk, Name/Arity).

:- end_tests(call_graph).
