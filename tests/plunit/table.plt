:- use_module('../../prolog/table').
:- use_module(worlds).

:- begin_tests(table, [setup(new_toy), cleanup(drop_toy)]).

test(words, [cleanup(drop_table(Table)), Words == [0b101, 0b010]]) :-
    toy_table([[[clear, 0]], [[on, 0, [floor]]], [[on, 0, 4], [on, 4, [floor]]]], Table),
    rows(Table, [move(a, c), move(b, c)], _, Words).
test(words_one_after_the_other, [cleanup(drop_table(Table)), Words == [0b0, 0b1, 0b1, 0b0]]) :-
    toy_table([[[=, 1, [a]]]], Table),
    set_tests(Table, 0, [1, [1]], [[[[=, 0, [a]]]]]),
    rows(Table, [move(a, c), move(b, a)], _, Words).
test(words_by_kind, [cleanup(drop_table(Table)), Kinds-Words == [1, 0, 1]-[0b1, 0b0, 0b1]]) :-
    new_table(toy, [[move, 2], [lift, 1]], [goal_on, 2], Table),
    set_tests(Table, 0, [0, [1]], [[[[clear, 0]]]]),
    set_tests(Table, 1, [0, [3]], [[[[on, 2, [floor]]]]]),
    rows(Table, [lift(a), move(a, c), lift(b)], Kinds, Words).

:- end_tests(table).
