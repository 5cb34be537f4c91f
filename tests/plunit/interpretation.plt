:- use_module('../../prolog/interpretation').

:- begin_tests(interpretation, [setup(new_world), cleanup(forget(world))]).

new_world :-
    dynamic([world:on/2, world:road/2, world:nppg_fluent/1, world:nppg_static/1]),
    forall(member(Clause, [nppg_fluent(on/2), nppg_static(road/2)]), assertz(world:Clause)).

many(Facts) :-
    findall(on(X, floor), between(1, 300, X), Facts).

on(Facts) :-
    findall(on(X, Y), world:on(X, Y), Facts).

test(empty, Facts == []) :-
    interpretation(nowhere, Facts).
test(current, Facts == [on(a, b), on(b, floor)]) :-
    interpret(world, [on(a, b), on(b, floor)]),
    on(Facts).
test(switch, Facts-Stored == [on(b, floor), on(c, b)]-[on(b, floor), on(c, b)]) :-
    interpret(world, [on(a, b), on(b, floor)]),
    interpret(world, [on(b, floor), on(c, b)]),
    interpretation(world, Facts),
    on(Stored).
test(change, Facts == [on(a, floor), on(b, floor)]) :-
    interpret(world, [on(a, b), on(b, floor)]),
    change(world, [on(a, b)], [on(a, floor)]),
    interpretation(world, Facts).
test(change_of_a_large_state, Facts-Count == [on(a, b)|Most]-300) :-
    many(All),
    interpret(world, All),
    change(world, [on(1, floor)], [on(a, b)]),
    facts(world, Count),
    interpretation(world, Found),
    All = [_|Most],
    msort(Found, Found),
    selectchk(on(a, b), Found, Most),
    Facts = [on(a, b)|Most].
test(switch_after_a_change, Facts == [on(a, floor)]) :-
    many(All),
    interpret(world, All),
    change(world, [on(1, floor)], [on(a, b)]),
    interpret(world, [on(a, floor)]),
    on(Facts).
test(effective, Gone-New == [on(a, b)]-[on(a, floor)]) :-
    interpret(world, [on(a, b), on(b, floor)]),
    effective(world, [on(a, b), on(z, z), on(b, floor)], [on(a, floor), on(b, floor)], Gone, New).
test(deleted_and_added_stays, Gone-New == []-[]) :-
    interpret(world, [on(a, b)]),
    effective(world, [on(a, b)], [on(a, b)], Gone, New).
test(static_facts_are_exchanged, Roads == [[road(a, b)], [road(b, c), road(c, d)], []]) :-
    new_static(world, [road(a, b)], First),
    new_static(world, [road(b, c), road(c, d)], Second),
    findall(Own,
            ( member(Number, [First, Second, 0]), enforce(world, Number), findall(road(X, Y), world:road(X, Y), Own) ),
            Roads).
test(static_facts_stay_in_other_states, Roads == [road(a, b)]) :-
    new_static(world, [road(a, b)], Number),
    enforce(world, Number),
    interpret(world, [on(a, b)]),
    findall(road(X, Y), world:road(X, Y), Roads),
    enforce(world, 0).
test(dropped_static_facts, fail) :-
    new_static(world, [road(a, b)], Number),
    drop_static(world, Number),
    enforce(world, Number).
test(tampered_large, cleanup(retractall(world:on(_, _)))) :-
    many(All),
    interpret(world, All),
    change(world, [on(1, floor)], []),
    \+ tampered(world),
    assertz(world:on(c, d)),
    tampered(world).
test(intact, fail) :-
    interpret(world, [on(a, b)]),
    tampered(world).
test(tampered, cleanup(retractall(world:on(_, _)))) :-
    interpret(world, [on(a, b)]),
    assertz(world:on(c, d)),
    tampered(world).
test(forgotten, Facts == []) :-
    interpret(world, []),
    forget(world),
    interpretation(world, Facts).

:- end_tests(interpretation).
