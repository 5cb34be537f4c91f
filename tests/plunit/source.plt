:- use_module('../../prolog/source').

:- begin_tests(source).

rows(Text, Rows) :-
    read_source(Text, [[200, fy, +-], [500, fy, #]], Rows).

test(fact, Rows == [[1, fact, [p, a, 1]], [2, fact, q], [3, fact, [l, ['[|]', x, ['[]']]]]]) :-
    rows("p(a, 1).\nq.\nl([x]).\n", Rows).
test(directive, Rows == [[1, directive, [modeb, *, [p, [+, t], [#, c]]]]]) :-
    rows(":- modeb(*, p(+t, #c)).", Rows).
test(variables, Data == [rmode, [p, [+-, ['$VAR', 0]], ['$VAR', 0]]]) :-
    rows("rmode(p(+-X, X)).", [[1, rule, Data|_]]).
test(rule, Row == [1, rule, [r, ['$VAR', 0]], "r(A) :-\n    s(A),\n    open(A, read, _).\n", [[open, 3], [s, 1]], [[open, 3]], '']) :-
    rows("r(X) :- s(X), open(X, read, _).", [Row]).
test(within_findall, Calls == [[s, 2]]) :-
    rows("r(X, L) :- findall(Y, \\+ s(X, Y), L).", [[1, rule, _, _, Calls|_]]).
test(refused, true(Refusal \== '')) :-
    rows("r(X) :- X:s.", [[1, rule, _, _, _, _, Refusal]]).
test(syntax, [Line, Line2] == [2, 3]) :-
    rows("p(a).\np(.\nq(b).", [_, [Line, error, _], [Line2, fact|_]]).
test(no_head, true(nonvar(Message))) :-
    rows("3 :- true.", [[1, error, Message]]).
test(operator, Rows == [[1, directive, [op, 700, xfx, is_on]], [2, fact, [is_on, a, b]]]) :-
    rows(":- op(700, xfx, is_on).\na is_on b.", Rows).
test(operators_end, true(current_op(_, _, is_on))) :-
    catch(( rows("a is_on b.", [[_, error, _]]), op(700, xfx, is_on) ), _, fail),
    !.
test(grammar, Row = [1, rule, [q, _, _]|_]) :-
    rows("q --> [a], q.", [Row]).
test(never_run, Rows == [[1, directive, halt], [2, directive, [shell, touch]]]) :-
    rows(":- halt.\n?- shell(touch).", Rows).
test(built_in, Those == [[atom, 1], [=, 2]]) :-
    built_in([[atom, 1], [atom, 5], [append, 3], [=, 2]], Those).
test(pure, Those == [[<, 2], [member, 2]]) :-
    pure_ones([[<, 2], [member, 2], [open, 3], [mine, 2]], Those).

:- end_tests(source).
