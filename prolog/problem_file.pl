:- module(nppg_problem_file,
          [ read_problems/3      % +Module, +File, -Problems     det
          ]).

:- use_module(library(lists), [memberchk/2]).
:- use_module(library(ordsets), [ord_subtract/3]).
:- use_module(report, [explanation/2, shown/2]).
:- use_module(values, [must_be_facts/4]).

/** <module> Files of problems

A file of problems has terms problem(Name, Facts): each a start state of a domain. It is read as data, never run.
*/

%!  read_problems(+Module, +File, -Problems) is det.
%
%   Problems is a list of problem(Name, Static, Facts), in the order of the file, both lists sorted.
%
%   @throws nppg_problems(Problems)

read_problems(Module, File, Problems) :-
    catch(setup_call_cleanup(open(File, read, In, [encoding(utf8)]), terms(In, Module, File, [], Problems), close(In)),
          error(Error, Context),
          unreadable(error(Error, Context), File)),
    (   Problems == []
    ->  wrong(File, 1, 'there is no problem in it', [])
    ;   true
    ).

terms(In, Module, File, Names, Problems) :-
    read_term(In, Term, [term_position(Position), module(Module)]),
    stream_position_data(line_count, Position, Line),
    (   Term == end_of_file
    ->  Problems = []
    ;   start(Term, Module, File, Line, Names, Problem),
        Problem = problem(Name, _, _),
        Problems = [Problem|Rest],
        terms(In, Module, File, [Name|Names], Rest)
    ).

start(Term, Module, File, Line, Names, problem(Name, Static, Facts)) :-
    (   nonvar(Term), Term = problem(Name, Given), atomic(Name), is_list(Given)
    ->  true
    ;   shown(Term, Shown),
        wrong(File, Line, 'problem(Name, Facts) is expected, not ~w', [Shown])
    ),
    (   memberchk(Name, Names)
    ->  wrong(File, Line, 'there are two problems ~w', [Name])
    ;   true
    ),
    catch(must_be_facts(Module, problem/2, Given, Static0), nppg_fault(_, Format-Args),
          wrong(File, Line, Format, Args)),
    sort(Static0, Static),
    sort(Given, Sorted),
    ord_subtract(Sorted, Static, Facts).

wrong(File, Line, Format, Args) :-
    format(atom(Text), Format, Args),
    (   atom_concat(Message, ',', Text)     % a fault goes on behind it with the circumstances
    ->  true
    ;   Message = Text
    ),
    throw(nppg_problems([-(File, Line, 0, Message)])).

unreadable(Error, File) :-
    (   Error = error(_, stream(_, Line, Column, _))
    ->  true
    ;   Error = error(_, file(_, Line, Column, _))
    ->  true
    ;   Line = 0, Column = 0
    ),
    explanation(Error, Text),
    throw(nppg_problems([-(File, Line, Column, Text)])).
