:- use_module('../../prolog/query_pack').
:- use_module('../../prolog/interpretation').

:- begin_tests(query_pack, [setup(new_world), cleanup(forget(toy))]).

new_world :-
    dynamic([toy:on/2, toy:goal_on/2, toy:nppg_fluent/1]),
    assertz(toy:(clear(X) :- on(X, _), \+ on(_, X))),
    assertz(toy:(bad(X) :- X > 1)),
    interpret(toy, [goal_on(a, b), on(a, b), on(b, floor), on(c, floor)]).

%   Roots: X and Y of move(X, Y), then the goal's A and B.

table(Tests, Table) :-
    new_table(toy, [[move, 2]], [goal_on, 2], Table),
    set_tests(Table, 0, [0, [1, 2]], [Tests]).

test(words, [cleanup(drop_table(Table)), Words == [0b101, 0b010]]) :-
    table([[[clear, 0]], [[on, 0, [floor]]], [[on, 0, 4], [on, 4, [floor]]]], Table),
    rows(Table, [move(a, c), move(b, c)], _, Words).
test(words_one_after_the_other, [cleanup(drop_table(Table)), Words == [0b0, 0b1, 0b1, 0b0]]) :-
    table([[[=, 1, [a]]]], Table),
    set_tests(Table, 0, [1, [1]], [[[[=, 0, [a]]]]]),
    rows(Table, [move(a, c), move(b, a)], _, Words).
test(words_by_kind, [cleanup(drop_table(Table)), Kinds-Words == [1, 0, 1]-[0b1, 0b0, 0b1]]) :-
    new_table(toy, [[move, 2], [lift, 1]], [goal_on, 2], Table),
    set_tests(Table, 0, [0, [1]], [[[[clear, 0]]]]),
    set_tests(Table, 1, [0, [3]], [[[[on, 2, [floor]]]]]),
    rows(Table, [lift(a), move(a, c), lift(b)], Kinds, Words).
test(goal_variables, [cleanup(drop_table(Table)), Words == [1, 0]]) :-
    table([[[=, 0, 2]]], Table),
    rows(Table, [move(a, c), move(c, a)], _, Words).
test(other_kind, [cleanup(drop_table(Table)), throws(nppg_fault(toy:action/1, _-[fly]))]) :-
    table([[[clear, 0]]], Table),
    rows(Table, [fly], _, _).
test(test_at_fault, [cleanup(drop_table(Table)), throws(nppg_fault(toy:bad/1, error(type_error(evaluable, _), _)))]) :-
    table([[[clear, 0]], [[bad, 0]]], Table),
    rows(Table, [move(a, c)], _, _).
test(coverage, [cleanup(drop_table(Table)), Words == [0b01, 0b10, 0b00]]) :-
    table([], Table),
    load_examples(Table, [[goal_on(a, b), on(a, b), on(b, floor), on(c, floor)], [goal_on(c, c), on(c, floor)]],
                  [[0, move(a, c)], [0, move(c, b)], [1, move(a, c)]]),
    coverage(Table, [[[[on, 0, 4]], [[[on, 4, [floor]]], [[=, 4, [floor]]]]]], [0, 1, 2], Words).
test(backtracks_over_the_prefix, [cleanup(drop_table(Table)), Words == [0b11]]) :-
    table([], Table),
    load_examples(Table, [[goal_on(a, b), on(a, b), on(b, floor), on(c, floor)]], [[0, move(a, c)]]),
    coverage(Table, [[[[on, 4, 5]], [[[=, 4, [a]]], [[=, 4, [c]]]]]], [0], Words).

:- end_tests(query_pack).
