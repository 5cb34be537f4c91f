:- use_module('../../prolog/layout').
:- use_module('../../prolog/table').
:- use_module(worlds).

:- begin_tests(layout, [setup(new_toy), cleanup(drop_toy)]).

test(other_kind, [cleanup(drop_table(Table)), throws(nppg_fault(toy:action/1, _-[fly]))]) :-
    toy_table([[[clear, 0]]], Table),
    rows(Table, [fly], _, _).
test(roots, [cleanup(drop_table(Table)), Count-Kind-Last == 3-1-c]) :-
    new_table(toy, [[move, 2], [lift, 1]], [], Table),
    root_count(Table, Count),
    action_roots(Table, [], lift(c), Kind, roots(_, _, Last)).
test(goal_values, [cleanup(drop_table(Table)), Values == [a, b]]) :-
    toy_table([], Table),
    goal_values(Table, Values).

:- end_tests(layout).
