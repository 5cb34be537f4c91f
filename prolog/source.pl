:- module(nppg_source,
          [ read_source/3,       % +Text, +Operators, -Rows      det
            built_in/2,          % +Indicators, -Those           det
            pure_ones/2          % +Indicators, -Those           det
          ]).

:- use_module(library(lists), [append/3, member/2, memberchk/2]).
:- use_module(library(modules), [in_temporary_module/3]).
:- use_module(allowed, [kind/2]).
:- use_module(formula, [must_be_test/2]).
:- use_module(report, [explanation/2]).
:- use_module(safety, [clause_doubts/2, refusal/2]).
:- use_module(terms, [encode/2, encode_flat/2]).

/** <module> Prolog programs as data

A text of Prolog that somebody else has written is read term by term, and nothing of it is run: what it declares, the
facts and the rules in it are told with their lines, for others to make something of.
*/

%!  read_source(+Text, +Operators, -Rows) is det.
%
%   Rows are, in the order of the text,
%
%     - [Line, fact, Data] for a ground clause without a body,
%     - [Line, rule, Head, Text, Calls, Doubts, Refusal] for another one, where Head is data, Calls the predicates that
%       it calls as [Name, Arity] but for those that every program may call, Doubts those among them that a program which
%       is not trusted may not call, unless it defines them itself, and Refusal says why the clause cannot stand at all,
%       or is '',
%     - [Line, directive, Data] for what stands behind :- or ?-,
%     - [Line, error, Message] for what cannot be read.
%
%   In Data a variable is '$VAR'(N), numbered from 0. Operators is a list of lists [Priority, Type, Name] that hold for
%   this text; its own operator declarations hold from where they stand on.

read_source(Text, Operators, Rows) :-
    in_temporary_module(Module,
                        forall(member([Priority, Type, Name], Operators), op(Priority, Type, Module:Name)),
                        setup_call_cleanup(open_string(Text, In), nppg_source:rows(In, Module, Rows), close(In))).

rows(In, Module, Rows) :-
    catch(read_term(In, Term, [ term_position(Position), module(Module), double_quotes(atom), syntax_errors(error),
                                quasi_quotations(_) ]),
          error(Error, Context), true),
    (   nonvar(Error)
    ->  (   Context = stream(_, Line, _, _)
        ->  true
        ;   Context = string(Text, Offset)
        ->  line_at(Text, Offset, Line)
        ;   line_count(In, Line)
        ),
        explanation(error(Error, _), Message),
        Rows = [[Line, error, Message]|Rest],
        rows(In, Module, Rest)
    ;   Term == end_of_file
    ->  Rows = []
    ;   stream_position_data(line_count, Position, Line),
        row(Term, Module, Line, Row),
        Rows = [Row|Rest],
        rows(In, Module, Rest)
    ).

line_at(Text, Offset, Line) :-
    sub_string(Text, 0, Offset, _, Before),
    split_string(Before, "\n", "", Lines),
    length(Lines, Line).

row(Term, Module, Line, Row) :-
    (   nonvar(Term), ( Term = (:- Directive) ; Term = (?- Directive) )
    ->  declared(Directive, Module),
        numbervars(Directive, 0, _),
        encode(Directive, Data),
        Row = [Line, directive, Data]
    ;   callable(Term), ground(Term), \+ clausal(Term)
    ->  (   encode_flat([Term], [Data])
        ->  true
        ;   encode(Term, Data)
        ),
        Row = [Line, fact, Data]
    ;   catch(rule(Term, Line, Row), error(Error, _), true),
        (   nonvar(Error)
        ->  explanation(error(Error, _), Message),
            Row = [Line, error, Message]
        ;   true
        )
    ).

clausal((_ :- _)).
clausal((_ --> _)).
clausal((_ => _)).

%   An operator is needed to read what follows.

declared(Directive, Module) :-
    (   ground(Directive), Directive = op(Priority, Type, Names), integer(Priority), atom(Type),
        ( atom(Names), List = [Names] ; is_list(Names), List = Names ),
        \+ ( member(Name, List), \+ atom(Name) )
    ->  catch(forall(member(Name, List), op(Priority, Type, Module:Name)), error(_, _), true)
    ;   true
    ).

rule(Term, Line, [Line, rule, Data, Text, Calls, Doubts, Refusal]) :-
    (   nonvar(Term), Term = (_ --> _)
    ->  dcg_translate_rule(Term, Clause)
    ;   Clause = Term
    ),
    (   nonvar(Clause), Clause = (Head :- Body)
    ->  true
    ;   nonvar(Clause), Clause = (Left => Body0)
    ->  (   nonvar(Left), Left = (Head, Guard)
        ->  Body = (Guard, Body0)
        ;   Head = Left,
            Body = Body0
        )
    ;   Head = Clause,
        Body = true
    ),
    (   callable(Head)
    ->  true
    ;   throw(error(type_error(callable, Head), _))
    ),
    catch(clause_doubts(Clause, Found), nppg_refused(What, _), true),
    (   nonvar(What)
    ->  Doubts = [],
        refusal(What, Advice),
        once(( sub_atom(Advice, Before, _, _, ': if its author'), sub_atom(Advice, 0, Before, _, Refusal)
             ; Refusal = Advice ))
    ;   findall([DoubtName, DoubtArity], member(DoubtName/DoubtArity, Found), Doubts),
        Refusal = ''
    ),
    findall([CallName, CallArity],
            ( called(Body, Call), kind(Call, Kind), Kind == other, functor(Call, CallName, CallArity) ),
            Calls0),
    sort(Calls0, Calls),
    with_output_to(string(Text), portray_clause(Clause)),
    numbervars(Head, 0, _),
    encode(Head, Data).

%   called(+Body, -Goal) is nondet: goals that running the body may call.

called(Body, _) :-
    \+ callable(Body),
    !,
    fail.
called(Body, Goal) :-
    memberchk(Body, [(_, _), (_ ; _), (_ -> _), (_ *-> _), \+ _]),
    !,
    arg(_, Body, Part),
    called(Part, Goal).
called(_ ^ Body, Goal) :-
    !,
    called(Body, Goal).
called(_:Body, Goal) :-
    !,
    called(Body, Goal).
called(Body, Body).
called(Body, Goal) :-
    predicate_property(system:Body, meta_predicate(Spec)),
    arg(N, Spec, Kind),
    ( integer(Kind) ; Kind == ^ ; Kind == // ),
    arg(N, Body, Part),
    nonvar(Part),
    (   Part = _ ^ _
    ->  called(Part, Goal)
    ;   callable(Part),
        ( integer(Kind) -> More = Kind ; Kind == // -> More = 2 ; More = 0 ),
        Part =.. List0,
        length(Added, More),
        append(List0, Added, List),
        catch(Extended =.. List, _, fail),
        called(Extended, Goal)
    ).

%!  built_in(+Indicators, -Those) is det.
%
%   Those of the predicates [Name, Arity] that Prolog has and lets nobody define anew.

built_in(Indicators, Those) :-
    findall([Name, Arity],
            ( member([Name, Arity], Indicators),
              functor(Head, Name, Arity),
              once(( predicate_property(system:Head, iso) ; memberchk(Name/Arity, [(:)/2, (-->)/2, (=>)/2, (?-)/1]) )) ),
            Those).

%!  pure_ones(+Indicators, -Those) is det.
%
%   Those of the predicates [Name, Arity] that Prolog has and a test may ask.

pure_ones(Indicators, Those) :-
    findall([Name, Arity],
            ( member([Name, Arity], Indicators),
              functor(Head, Name, Arity),
              kind(Head, Kind),
              Kind \== other,
              catch(must_be_test(Head, nppg_unloaded), nppg_refused(_, _), fail) ),
            Those).
