:- use_module('../../prolog/harmless').

:- begin_tests(harmless).

test(head, all(Head == [p(a), q])) :-
    member(Head, [p(a), q, ( a :- b ), ( a => b ), '?=>'(a, b), user:p, ( a --> b ), nppg_x, '$x'(1), [a], ( a, b )]),
    plain_head(Head).

test(format, all(Text == ["~w and ~10|~q", "~`xt~20|", "~~@"])) :-
    member(Text, ["~w and ~10|~q", "~@", "~`xt~20|", "~*@", "~:W", "~`~@", "~~@", "~"]),
    string_codes(Text, Codes),
    plain_format(Codes).

test(sink, all(Sink == [user_error, atom(a)])) :-
    member(Sink, [user_error, atom(a), 'a.txt', user_input, _]),
    sink(Sink).

test(power, all(Term == [2**x, 2**100, x<<3])) :-
    member(Term, [2**x, 2**100, x**2, x<<3, 2+3, x]),
    power(Term).

test(lambda, all(Term == [[x]>>true, a/([x]>>true)])) :-
    member(Term, [[x]>>true, a/([x]>>true), f(x)]),
    lambda(Term).

:- end_tests(harmless).
