:- use_module('../../prolog/interpretation').
:- use_module('../../prolog/potential').
:- use_module('../../prolog/rule_list').
:- use_module(worlds).

:- begin_tests(rule_list, [ setup((new_toy, assertz(toy:(action(move(X, floor)) :- on(X, Y), Y \== floor, \+ on(_, X))),
                                   assertz(toy:(action(move(X, Y)) :- on(X, _), on(Y, _), \+ on(_, X), \+ on(_, Y), X \== Y)))),
                            cleanup((retractall(toy:action(_)), drop_toy)) ]).

%   Clauses as Python gives them: [VariableCount, Head, Query, Value]; of the actions move(a, c), move(a, floor), move(c, a).

policy(Policy, Clauses) :-
    new_policy(toy, [], Policy),
    add_tree(Policy, Clauses).

best(Clauses, Actions) :-
    setup_call_cleanup(policy(Policy, Clauses),
                       ( preferred(Policy, First), preferred(Policy, Actions), First == Actions ),
                       ( forget_rules(Policy), drop_policy(Policy) )).

test(first_rule_that_is_met, Actions == [move(a, c), move(a, floor)]) :-
    best([[2, [move, 0, 1], [[on, 0, [b]]], 3.0], [2, [move, 0, 1], [], 1.0]], Actions).
test(highest_value_first, Actions == [move(c, a)]) :-
    best([[2, [move, 0, 1], [[on, 0, [b]]], -3.0], [2, [move, 0, 1], [], 1.0]], Actions).
test(an_earlier_rule_hides_a_later_one, Actions == [move(a, c)]) :-
    best([[1, [move, 0, [floor]], [], 0.0], [2, [move, 0, 1], [[on, 0, [b]]], 3.0], [2, [move, 0, 1], [], 1.0]], Actions).
test(rules_of_one_value_count_together, Actions == [move(a, c), move(a, floor), move(c, a)]) :-
    best([[2, [move, 0, 1], [[on, 0, [b]]], 2.0], [2, [move, 0, 1], [[on, 0, [floor]]], 2.0], [2, [move, 0, 1], [], 1.0]], Actions).
test(a_rule_for_all_actions, Actions == [move(a, c), move(a, floor), move(c, a)]) :-
    best([[0, [], [], 1.0]], Actions).
test(no_action, Actions == []) :-
    interpret(toy, []),
    best([[0, [], [], 1.0]], Actions),
    interpret(toy, [goal_on(a, b), on(a, b), on(b, floor), on(c, floor)]).

:- end_tests(rule_list).
