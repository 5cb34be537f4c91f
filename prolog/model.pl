:- module(nppg_model,
          [ write_model/6,       % +File, +Name, +DomainFile, +Facts, +Policy, +Comments  det
            read_model/2,        % +File, -Model                det
            rule_text/3,         % +Signatures, +Clause, -Text  det
            rule_parts/3         % +Signatures, +Clause, -Parts  det
          ]).

:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, foldl/5, maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2, memberchk/2, nth0/3, nth1/3, same_length/2, subtract/3]).
:- use_module(library(readutil), [read_file_to_string/3]).
:- use_module(potential, [rule/3, signatures/2]).
:- use_module(report, [explanation/2]).
:- use_module(terms).

/** <module> Model files

A model file is Prolog that a person can read and that plain Prolog can load beside its domain. It is
written from the clauses that the potential is stored as, and read back strictly as data: nothing in it is
ever called. It has three parts: the terms of plain.pl, facts that describe it (model/2), and the trees.
*/


:- dynamic plain_file/1.
:- prolog_load_context(directory, Directory),
   atom_concat(Directory, '/plain.pl', File),
   assertz(plain_file(File)).

%!  write_model(+File, +Name, +DomainFile, +Facts, +Policy, +Comments) is det.
%
%   Name is the domain's module and DomainFile its file's base name. Facts is a list of [Key, Value], Value
%   as data. Comments has a list for each tree: a line of text, and behind it either nothing more or a line for each of
%   its rules, which comes to stand above that rule.

write_model(File, Name, DomainFile, Facts, Policy, Comments) :-
    setup_call_cleanup(
        open(File, write, Out, [encoding(utf8)]),
        ( preamble(Out, Name, DomainFile, Facts),
          forall(nth1(Tree, Comments, [Comment|Sentences]), write_tree(Out, Policy, Tree, Comment, Sentences)) ),
        close(Out)).

preamble(Out, Name, DomainFile, Facts) :-
    format(Out, '% A policy learned by nppg: the potential of an action is the sum of its delta/3, one per tree.~n', []),
    format(Out, '% In plain Prolog, in the folder of this file and its domain:  swipl model.pl~n', []),
    format(Out, '%     ?- state([...]), best_action(Action).~n~n', []),
    header(Header),
    portray_clause(Out, Header),
    forall(( member([Key, Data], Facts), decode(Data, Value) ),
           format(Out, '~W.~n', [model(Key, Value), [quoted(true), spacing(next_argument)]])),
    plain_file(Plain),
    read_file_to_string(Plain, Text, [encoding(utf8)]),
    format(Out, '~n~w~ndomain(~q).~n:- ensure_loaded(~q).~n:- add_import_module(policy, ~q, start).~n',
           [Text, Name, DomainFile, Name]).

header((:- module(policy, [state/1, potential/2, best_action/1, delta/3]))).

write_tree(Out, Policy, Tree, Comment, Sentences) :-
    format(Out, '~n% tree ~d: ~w~n', [Tree, Comment]),
    signatures(Policy, Signatures),
    findall(Text, ( rule(Policy, Tree, Clause), rule_text(Signatures, Clause, Text) ), Texts),
    (   Sentences == []
    ->  maplist(format(Out, '~w~n'), Texts)
    ;   maplist(write_explained(Out), Sentences, Texts)
    ).

write_explained(Out, Sentence, Text) :-
    format(Out, '% ~w~n~w~n', [Sentence, Text]).

%!  rule_text(+Signatures, +Clause, -Text) is det.
%
%   A clause on one line. A variable is named after the type of the argument where it first stands, in the
%   order of occurrence; by a letter where that has no signature.

rule_text(Signatures, Clause, Text) :-
    named(Signatures, Clause, (Head :- Body)),
    term_text(Head, HeadText),
    (   Body == true
    ->  format(atom(Text), '~w.', [HeadText])
    ;   goals(Body, Goals),
        maplist(term_text, Goals, Texts),
        atomic_list_concat(Texts, ', ', BodyText),
        format(atom(Text), '~w :- ~w.', [HeadText, BodyText])
    ).

%!  rule_parts(+Signatures, +Clause, -Parts) is det.
%
%   What rule_text/3 prints, in parts: [Action, Literals, Value], without the cut. A literal is [Name, Args, Text], an
%   argument its text, that of a constant in a list of one; Action is [] where the rule is about every action.

rule_parts(Signatures, Clause, [Action, Literals, Value]) :-
    named(Signatures, Clause, (delta(_, Head, Value) :- Body)),
    (   Head = '$VAR'(_)
    ->  Action = []
    ;   literal_parts(Head, Action)
    ),
    goals(Body, Goals0),
    subtract(Goals0, [true, !], Goals),
    maplist(literal_parts, Goals, Literals).

literal_parts(Literal, [Name, Args, Text]) :-
    Literal =.. [Name|Terms],
    maplist(argument_part, Terms, Args),
    term_text(Literal, Text).

argument_part(Term, Part) :-
    term_text(Term, Text),
    (   Term = '$VAR'(_)
    ->  Part = Text
    ;   Part = [Text]
    ).

%   The clause with its variables named.

named(Signatures, Clause, Named) :-
    copy_term(Clause, Named),
    Named = (Head :- Body),
    term_singletons(Named, Singletons),
    maplist(=('$VAR'('_')), Singletons),
    goals(Body, Literals),
    arg(2, Head, Action),
    foldl(name_variables(Signatures), [Action|Literals], [], _),
    numbervars(Named, 0, _).

name_variables(Signatures, Literal, Named0, Named) :-
    (   compound(Literal),
        Literal =.. [Name|Args],
        member([Name|Types], Signatures),
        same_length(Args, Types)
    ->  foldl(name_variable, Args, Types, Named0, Named)
    ;   Named = Named0
    ).

name_variable(Variable, Type, Named, [Type|Named]) :-
    var(Variable),
    !,
    sub_atom(Type, 0, 1, _, First),
    sub_atom(Type, 1, _, 0, Rest),
    upcase_atom(First, Capital),
    aggregate_all(count, member(Type, Named), Before),
    (   Before == 0
    ->  Suffix = ''
    ;   Suffix is Before+1
    ),
    atomic_list_concat([Capital, Rest, Suffix], VariableName),
    Variable = '$VAR'(VariableName).
name_variable(_, _, Named, Named).

goals(Body, [Goal|Goals]) :-
    nonvar(Body),
    Body = (Goal, Rest),
    !,
    goals(Rest, Goals).
goals(Goal, [Goal]).

term_text(Term, Text) :-
    nonvar(Term),
    Term =.. [Name, Left, Right],
    memberchk(Name, [=<, >=]),
    !,
    term_text(Left, LeftText),
    term_text(Right, RightText),
    format(atom(Text), '~w ~w ~w', [LeftText, Name, RightText]).
term_text(Term, Text) :-
    format(atom(Text), '~W', [Term, [quoted(true), numbervars(true), spacing(next_argument)]]).

%!  read_model(+File, -Model) is det.
%
%   Model is a list [Facts, Name, DomainFile, Rules] with Rules a list of
%   [Line, Tree, Head, Query, Value, Final]: Head and Query as data in which variables are numbered in the
%   order of occurrence, Final true for a rule without a cut.
%
%   @throws nppg_problems(Problems) for everything that is no part of a model

read_model(File, [Facts, Name, DomainFile, Rules]) :-
    file_terms(File, Terms0),
    header(Header),
    same_terms([Header-_], Terms0, File, TermsH),
    described(TermsH, Facts, Terms1),
    plain_file(Plain),
    file_terms(Plain, PlainTerms),
    same_terms(PlainTerms, Terms1, File, Terms2),
    (   Terms2 = [domain(Name)-_, (:- ensure_loaded(DomainFile))-_, (:- add_import_module(policy, Name, start))-_|Terms],
        atom(Name),
        atom(DomainFile)
    ->  true
    ;   not_a_model(File, Terms2)
    ),
    rules(Terms, File, Rules).

file_terms(File, Terms) :-
    setup_call_cleanup(
        open(File, read, In, [encoding(utf8)]),
        catch(stream_terms(In, Terms), Error, syntax_problem(File, Error)),
        close(In)).

stream_terms(In, Terms) :-
    read_term(In, Term, [term_position(Position), module(nppg_model), cycles(false)]),
    (   Term == end_of_file
    ->  Terms = []
    ;   stream_position_data(line_count, Position, Line),
        Terms = [Term-Line|Rest],
        stream_terms(In, Rest)
    ).

syntax_problem(File, error(syntax_error(What), Place)) :-
    ( Place = stream(_, Line, Column, _) ; Place = file(_, Line, Column, _) ),
    !,
    explanation(error(syntax_error(What), _), Text),
    throw(nppg_problems([-(File, Line, Column, Text)])).
syntax_problem(_, Error) :-
    throw(Error).

described([model(Key, Value)-_|Terms], [[Key, Data]|Facts], Rest) :-
    atom(Key),
    ground(Value),
    !,
    encode(Value, Data),
    described(Terms, Facts, Rest).
described(Terms, [], Terms).

same_terms([], Terms, _, Terms).
same_terms([Wanted-_|More], Terms, File, Rest) :-
    (   Terms = [Term-_|Tail], Term =@= Wanted
    ->  same_terms(More, Tail, File, Rest)
    ;   not_a_model(File, Terms)
    ).

not_a_model(File, Terms) :-
    (   Terms = [_-Line|_]
    ->  true
    ;   Line = 0
    ),
    Message = 'this is no part of an nppg model, or the file is truncated here or was written by another version of nppg',
    throw(nppg_problems([-(File, Line, 0, Message)])).

rules([], _, []).
rules([Term-Line|Terms], File, [Rule|Rules]) :-
    (   rule_data(Term, Line, Rule)
    ->  rules(Terms, File, Rules)
    ;   throw(nppg_problems([-(File, Line, 0, 'this is no rule delta(Tree, Action, Value) :- Tests, !.')]))
    ).

rule_data(Term, Line, [Line, Tree, HeadData, Query, Value, Final]) :-
    (   Term = (Head :- Body)
    ->  goals(Body, Goals),
        append(Tests, [!], Goals),
        Final = false
    ;   Head = Term,
        Tests = [],
        Final = true
    ),
    Head = delta(Tree, Action, Value),
    integer(Tree),
    number(Value),
    term_variables(Term, Variables),
    (   var(Action)
    ->  HeadData = []
    ;   literal_data(Variables, Action, HeadData)
    ),
    maplist(literal_data(Variables), Tests, Query).

literal_data(Variables, Literal, [Name|Data]) :-
    callable(Literal),
    Literal =.. [Name|Args],
    maplist(argument_data(Variables), Args, Data).

argument_data(Variables, Arg, Data) :-
    (   var(Arg)
    ->  nth0(Data, Variables, Variable),
        Variable == Arg
    ;   atomic(Arg),
        \+ string(Arg),
        Data = [Arg]
    ).
