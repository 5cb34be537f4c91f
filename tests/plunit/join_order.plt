:- use_module('../../prolog/join_order').

:- begin_tests(join_order, [setup(new_world), cleanup(drop_world)]).

new_world :-
    dynamic([crowd:at/2, crowd:on/1, crowd:nppg_fluent/1, crowd:nppg_static/1]),
    forall(member(Spec, [at/2, on/1]), assertz(crowd:nppg_fluent(Spec))),
    forall(between(1, 100, I), assertz(crowd:at(I, home))),
    assertz(crowd:on(1)).

drop_world :-
    forall(member(Head, [at(_, _), on(_), nppg_fluent(_)]), retractall(crowd:Head)).

test(few_facts_first, Ordered == [on(C), at(C, L)]) :-
    ordered(crowd, [], [at(C, L), on(C)], Ordered).
test(what_is_bound_first, Ordered == [at(C, L), on(D)]) :-
    ordered(crowd, f(C, L), [on(D), at(C, L)], [at(C, L), on(D)]),
    Ordered = [at(C, L), on(D)].
test(facts_before_others, Ordered == [on(C), near(C, L)]) :-
    ordered(crowd, L, [near(C, L), on(C)], Ordered).
test(others_stay_behind_the_facts_that_bind_for_them, Ordered == [on(D), at(C, L), near(C, L)]) :-
    ordered(crowd, [], [at(C, L), near(C, L), on(D)], Ordered).
test(others_as_the_largest, Ordered == [near(C, L), at(C, M)]) :-
    ordered(crowd, L, [near(C, L), at(C, M)], Ordered).
test(others_keep_their_order, Ordered == [far(C), near(C)]) :-
    ordered(crowd, [], [far(C), near(C)], Ordered).
test(a_literal_twice, Ordered == [on(C), on(C)]) :-
    ordered(crowd, [], [on(C), on(C)], Ordered).

:- end_tests(join_order).
