:- use_module('../../prolog/test_clauses').
:- use_module('../../prolog/table').
:- use_module(worlds).

:- begin_tests(test_clauses, [setup(new_toy), cleanup(drop_toy)]).

test(goal_variables, [cleanup(drop_table(Table)), Words == [1, 0]]) :-
    toy_table([[[=, 0, 2]]], Table),
    rows(Table, [move(a, c), move(c, a)], _, Words).
test(least, Least == [2.0, -3.0]) :-
    findall(Value, ( member(Name, [=<, >=]), least([3, 2], Name, Value) ), Least).
test(none, Least == [Infinite, Infinite]) :-
    Infinite is inf,
    findall(Value, ( member(Name, [=<, >=]), least([], Name, Value) ), Least).
test(too_large, Least == Infinite) :-
    Infinite is inf,
    Large is 10**400,
    least([Large], =<, Least).
test(no_number, throws('gave ~p, which is compared with a threshold and is no number,'-[a])) :-
    least([1, a], =<, _).

:- end_tests(test_clauses).
