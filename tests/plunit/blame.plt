:- use_module('../../prolog/blame').
:- use_module('../../prolog/table').
:- use_module(worlds).

:- begin_tests(blame, [setup(new_toy), cleanup(drop_toy)]).

test(test_at_fault, [cleanup(drop_table(Table)), throws(nppg_fault(toy:bad/1, error(type_error(evaluable, _), _)))]) :-
    toy_table([[[clear, 0]], [[bad, 0]]], Table),
    rows(Table, [move(a, c)], _, _).
test(bound_at_fault, [cleanup(drop_table(Table)), throws(nppg_fault(toy:on/2, _-[b]))]) :-
    new_table(toy, [[move, 2]], [goal_on, 2], Table),
    set_tests(Table, [], [[1, 2, [measure, [[=<, 4, [0]], [on, 0, 4]]]]], [[[1, [1, 2], true]]]),
    rows(Table, [move(a, c)], _, _).
test(nothing_to_blame, cleanup(drop_table(Table))) :-
    toy_table([[[clear, 0]]], Table),
    blame(toy, Table:'$row'(_, roots(a, c, a, b), _), roots(a, c, a, b)).

:- end_tests(blame).
