:- use_module('../../prolog/loading').
:- use_module('../../prolog/problem_file').
:- use_module(worlds).

:- begin_tests(problem_file).

read(Text, M, Problems) :-
    setup_call_cleanup(tmp_file_stream(File, Out, [encoding(utf8)]), (write(Out, Text), close(Out)), true),
    call_cleanup(read_problems(M, File, Problems), delete_file(File)).

problems(Text, Problems) :-
    setup_call_cleanup(roads([], M), read(Text, M, Problems), unload_domain(M)).

test(sorted, Problems == [problem(p1, [road(a, b), road(b, c)], [at(a)]), problem(2, [], [at(b)])]) :-
    problems('problem(p1, [at(a), road(b, c), road(a, b)]). problem(2, [at(b)]).', Problems).
test(twice, throws(nppg_problems([-(_, 2, 0, 'there are two problems p1')]))) :-
    problems('problem(p1, []).\nproblem(p1, []).', _).
test(no_fact, throws(nppg_problems([-(_, 1, 0, 'gave ship(a), which is no fact of a declared fluent')]))) :-
    problems('problem(p1, [ship(a)]).', _).
test(no_problem, throws(nppg_problems([-(_, 1, 0, 'problem(Name, Facts) is expected, not go(a)')]))) :-
    problems('go(a).', _).
test(never_run, throws(nppg_problems([-(_, 1, 0, _)]))) :-
    problems(':- halt.', _).
test(syntax, throws(nppg_problems([-(_, 1, _, _)]))) :-
    problems('problem(p1, [.', _).
test(empty, throws(nppg_problems([-(_, 1, 0, 'there is no problem in it')]))) :-
    problems('', _).

:- end_tests(problem_file).
