:- use_module('../../prolog/report').

:- begin_tests(report).

test(variable, Text == 'f(_,\'A\')') :-
    shown(f(_, 'A'), Text).
test(long_list) :-
    numlist(1, 100, List),
    shown(List, Text),
    sub_atom(Text, _, _, 0, '20, ... and 80 more]').
test(cyclic) :-
    X = f(X),
    shown(X, Text),
    atom_length(Text, Length),
    Length < 700.
test(long_term) :-
    length(List, 5000),
    T =.. [f|List],
    shown(T, Text),
    sub_atom(Text, 600, _, 0, ' ...').
test(message, Line == 'Type error: `integer\' expected, found `a\' (an atom)') :-
    explanation(error(type_error(integer, a), context(secret#1, _)), Line).
test(any_ball, Line == 'ball(_)') :-
    explanation(ball(_), Line).
test(unbound) :-
    explanation(_, Line),
    atom(Line).
test(no_internal_module, Line == 'Unknown procedure: p/1') :-
    assertz('walk#7':q),
    explanation(error(existence_error(procedure, 'walk#7':p/1), _), Line).
test(problems_pass, Problems == [x]) :-
    problems(nppg_problems([x]), Problems).
test(fault, Text == 'p/0 took more than 5 inferences (does it loop?) in the state []') :-
    problems(nppg_fault(nowhere:p/0, inference_limit(5)), [-('', 0, 0, Text)]).

:- end_tests(report).
