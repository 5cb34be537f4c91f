:- use_module('../../prolog/loading').
:- use_module('../../prolog/interpretation').
:- use_module('../../prolog/schemas').
:- use_module(worlds).

:- begin_tests(schemas).

schemas_of_clauses(Clauses, Data) :-
    forall(member(Clause, Clauses), assertz(shop:Clause)),
    schemas(shop, Data).

drop_shop :-
    forall(member(Indicator, [action/1, effect/3, effect/4]), abolish(shop:Indicator)).

test(one_each, [setup(roads([], M)), cleanup(unload_domain(M)),
                true(Data == [[[go, V], [[at, W], [road, W, V], [at, X]], [[at, X]], [[at, V]]]])]) :-
    schemas(M, Data),
    maplist([N, ['$VAR', N]]>>true, [0, 1, 2], [V, W, X]).
test(clauses_that_do_not_fit, [setup(ferry([], M)), cleanup(unload_domain(M)), true(Actions-Deleted == [cross, [carry, V]]-Fuel)]) :-
    schemas(M, Data),
    findall(Action, member([Action|_], Data), Actions),
    maplist([[_, _, [[fuel, _]|_], _]]>>true, Data),        % lists that go on in a variable end there
    findall(Each, member([_, _, Each, _], Data), All),
    maplist([List, One]>>( length(List, One) ), All, Deleted),
    Fuel = [1, 1],
    V = ['$VAR', 0].
test(nested_goals, [cleanup(drop_shop),
                    true(Goals == [[';', ['->', [open, V], [big, V]], [\+, [',', [shut, V], [old, V]]]], !])]) :-
    schemas_of_clauses([(action(buy(A)) :- ( open(A) -> big(A) ; \+ ( shut(A), old(A) ) ), !), effect(buy(_), [], [])],
                       [[_, Goals, [], []]]),
    V = ['$VAR', 0].
test(outcomes, [cleanup(drop_shop), true(Data == [[buy, [], [], [[had, a]]], [buy, [], [open], []]])]) :-
    schemas_of_clauses([action(buy), effect(buy, 0.5, [], [had(a)]), effect(buy, 0.5, [open], [])], Data).
test(what_is_no_list, [cleanup(drop_shop), true(Data == [[buy, [[some, ['$VAR', 0], ['$VAR', 1]]], [], []]])]) :-
    schemas_of_clauses([action(buy), (effect(buy, Gone, [New]) :- some(Gone, New))], Data).
test(no_actions, Data == []) :-
    schemas(nowhere_at_all, Data).

test(extensions, [setup(roads([], M)), cleanup(unload_domain(M)), true(Found-Same-Different == [0, 0]-true-true)]) :-
    extensions(M, [at, road], [1, 2], Found),
    interpret(M, [at(a)]),
    extensions(M, [at], [1], [A]),
    interpret(M, [at(b)]),
    extensions(M, [at], [1], [B]),
    interpret(M, [at(a)]),
    extensions(M, [at], [1], [Again]),
    ( A == Again -> Same = true ; Same = false ),
    ( A \== B -> Different = true ; Different = false ).

:- end_tests(schemas).
