:- use_module('../../prolog/interpretation').

:- begin_tests(interpretation, [setup(new_world), cleanup(forget(world))]).

new_world :-
    dynamic([world:on/2, world:nppg_fluent/1]),
    forall(member(Clause, [nppg_fluent(on/2)]), assertz(world:Clause)).

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
    change(world, [on(a, b), on(z, z)], [on(a, floor)]),
    interpretation(world, Facts).
test(deleted_and_added_stays, Facts == [on(a, b)]) :-
    interpret(world, [on(a, b)]),
    change(world, [on(a, b)], [on(a, b)]),
    interpretation(world, Facts).
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
