:- use_module('../../prolog/table').
:- use_module(worlds).

:- begin_tests(table, [setup(new_toy), cleanup(drop_toy)]).

test(words, [cleanup(drop_table(Table)), Words == [0b101, 0b010]]) :-
    toy_table([[[clear, 0]], [[on, 0, [floor]]], [[on, 0, 4], [on, 4, [floor]]]], Table),
    rows(Table, [move(a, c), move(b, c)], _, Words).
test(action_by_action, [cleanup(drop_table(Table)), Words == [0b0, 0b1, 0b1, 0b0]]) :-
    new_table(toy, [[move, 2]], [goal_on, 2], Table),
    set_tests(Table, [], [[1, 2, [[[=, 1, [a]]]]], [2, 1, [[[=, 0, [a]]]]]], [[[1, [1, 2], true], [2, [1], false]]]),
    rows(Table, [move(a, c), move(b, a)], _, Words).
test(words_by_kind, [cleanup(drop_table(Table)), Kinds-Words == [1, 0, 1]-[0b0, 0b1, 0b1]]) :-
    new_table(toy, [[move, 2], [lift, 1]], [goal_on, 2], Table),
    set_tests(Table, [], [[1, 1, [[[clear, 0]]]], [2, 1, [[[on, 0, [floor]]]]]], [[[1, [1], false]], [[2, [1], true]]]),
    rows(Table, [lift(a), move(a, c), lift(b)], Kinds, Words).
test(shared_word, [cleanup(drop_table(Table)), Words-Calls == [1, 0, 0, 1]-2]) :-
    new_table(toy, [[move, 2]], [goal_on, 2], Table),
    assertz((toy:seen(X) :- flag(seen, N, N+1), X == a)),
    set_tests(Table, [], [[1, 1, [[[seen, 0]]]]], [[[1, [1], false], [1, [2], false]]]),
    flag(seen, _, 0),
    rows(Table, [move(a, c), move(c, a)], _, Words),
    flag(seen, Calls, 0),
    abolish(toy:seen/1).
test(kept_word, [cleanup(drop_table(Table)), Words-Calls == [1, 1]-1]) :-
    new_table(toy, [[move, 2]], [goal_on, 2], Table),
    assertz((toy:seen(X) :- flag(seen, N, N+1), X == a)),
    set_tests(Table, [], [[-1, 1, [[[seen, 0]]]]], [[[-1, [1], false]]]),
    flag(seen, _, 0),
    rows(Table, [move(a, c)], _, Words0),
    rows(Table, [move(a, b)], _, Words1),
    append(Words0, Words1, Words),
    flag(seen, Calls, 0),
    abolish(toy:seen/1).
test(dropped_word, [cleanup(drop_table(Table)), Words == [0b1]]) :-
    toy_table([[[clear, 0]]], Table),
    set_tests(Table, [1], [[2, 0, [[[on, 0, 1]]]]], [[[2, [], false]]]),
    rows(Table, [move(a, c)], _, Words),
    \+ clause(Table:'$row'(1, _, _), _).
test(no_tests, [cleanup(drop_table(Table)), Kinds-Words == [0]-[]]) :-
    new_table(toy, [[move, 2]], [goal_on, 2], Table),
    rows(Table, [move(a, c)], Kinds, Words).

:- end_tests(table).
