:- use_module('../../prolog/terms').

:- begin_tests(terms).

test(there_and_back, [forall(member(Term, [a, '', 'A b', 1, -1, 2.5, f(x), f([1, [a]], '[]', []), p(), a-b, {}, {a}]))]) :-
    encode(Term, Data),
    decode(Data, Back),
    Back == Term.
test(atom, Data == a) :-
    encode(a, Data).
test(compound, Data == [on, a, [s, 1]]) :-
    encode(on(a, s(1)), Data).
test(from_python, Term == on(a, s([]))) :-
    decode(-(on, a, -(s, -('[]'))), Term).
test(empty_list, Data == ['[]']) :-
    encode([], Data).
test(literal, Literal == on(B, floor)) :-
    literal([on, 1, [floor]], v(_, B), Literal).
test(literals, Literals == [clear(A), on(A, B)]) :-
    literals([[clear, 0], [on, 0, 1]], v(A, B), Literals).
test(conjunction, [true(Goals-Goal == [true, p, (p, q)]-(p, q, r))]) :-
    maplist(conjunction, [[], [p], [p, q]], Goals),
    conjunction([p, q, r], Goal).

:- end_tests(terms).
