:- use_module('../../prolog/query_pack').
:- use_module('../../prolog/table').
:- use_module(worlds).

:- begin_tests(query_pack, [setup(new_toy), cleanup(drop_toy)]).

drop(Table) :-
    drop_examples(Table),
    drop_table(Table).

test(coverage, [cleanup(drop(Table)), Words == [0b01, 0b10, 0b00]]) :-
    toy_table([], Table),
    load_examples(Table, [0-[goal_on(a, b), on(a, b), on(b, floor), on(c, floor)], 0-[goal_on(c, c), on(c, floor)]],
                  [[0, move(a, c)], [0, move(c, b)], [1, move(a, c)]]),
    coverage(Table, [[[[on, 0, 4]], [[[on, 4, [floor]]], [[=, 4, [floor]]]]]], [0, 1, 2], Words).
test(backtracks_over_the_prefix, [cleanup(drop(Table)), Words == [0b11]]) :-
    toy_table([], Table),
    load_examples(Table, [0-[goal_on(a, b), on(a, b), on(b, floor), on(c, floor)]], [[0, move(a, c)]]),
    coverage(Table, [[[[on, 4, 5]], [[[=, 4, [a]]], [[=, 4, [c]]]]]], [0], Words).

:- end_tests(query_pack).
