:- module(nppg_blame,
          [ blame/3              % +Module, +Goal, +Roots      det
          ]).

:- use_module(library(apply), [exclude/3, maplist/3]).
:- use_module(library(lists), [append/3, last/2, member/2, memberchk/2]).
:- use_module(guard, [guarded/2]).
:- use_module(layout, [layout/4]).
:- use_module(terms, [conjunction/2]).
:- use_module(test_clauses, []).

/** <module> The test that is to blame

Where asking many tests at once does not finish, the single test at fault is looked for, so that the message can name
its predicate.
*/

%!  blame(+Module, +Goal, +Roots) is det.
%
%   Goal is Table:Head, the head of one of the clauses of test_clauses.pl.
%
%   Throws the fault of the first test in the clause's body that has one, with the literal that is to blame.

blame(Module, Table:Goal, Roots) :-
    clause(Table:Goal, Body),
    arg(2, Goal, Roots),
    flat(Body, Goals),
    forall(test(Goals, Table, Test), tried(Test, Module, Table, Roots)).

test(Goals, _, Test) :-
    member(( If -> _ ; _ ), Goals),
    flat(If, Conditions),
    (   append(Prefix, [arg(1, _, _)|Packed], Conditions)
    ->  member(( Own -> _ ; _ ), Packed),
        flat(Own, [_|Literals]),
        append(Prefix, Literals, Test)
    ;   Test = Conditions
    ).
test(Goals, Table, Test) :-
    member(findall(Number, Solution, _), Goals),
    clause(Table:Solution, Body),
    flat(Body, Literals),
    append(Literals, [Number =< inf, fail], Test).

flat(Conjunction, Goals) :-
    (   Conjunction = (Left, Right)
    ->  flat(Left, Start),
        flat(Right, End),
        append(Start, End, Goals)
    ;   Goals = [Conjunction]
    ).

tried(Test, Module, Table, Roots) :-
    exclude(is_control, Test, Literals),
    (   last(Literals, Last)
    ->  functor(Last, Name, Arity)
    ;   Name = test, Arity = 0
    ),
    maplist(watched(Test, Module, Table, Roots), Test, Watched),
    conjunction(Watched, Goal),
    catch(ignore(guarded(Module:Name/Arity, Goal)), nppg_fault(Predicate, Fault), true),
    (   var(Fault)
    ->  true
    ;   Fault = nppg_fault(_, _)
    ->  throw(Fault)
    ;   throw(nppg_fault(Predicate, Fault))
    ).

is_control(fail).
is_control(_ =< _).
is_control(_ >= _).

watched(Test, Module, Table, Roots, Literal, Watched) :-
    (   Literal == fail
    ->  Watched = fail
    ;   is_control(Literal)
    ->  arg(1, Literal, Number),
        source(Test, Number, Table, Roots, Source),
        Watched = ( nppg_test_clauses:checked(Number, nppg_guard:fault(Module:Source)), Literal )
    ;   functor(Literal, Name, Arity),
        Watched = catch(Table:Literal, error(Error, Context),
                        throw(nppg_fault(Module:Name/Arity, error(Error, Context))))
    ).

%   What gives the number that a bound compares: the first literal that is about it, else the goal or the action.

source(Literals, Number, _, _, Name/Arity) :-
    member(Literal, Literals),
    term_variables(Literal, Variables),
    member(Variable, Variables),
    Variable == Number,
    !,
    functor(Literal, Name, Arity).
source(_, Number, Table, Roots, Name/Arity) :-
    layout(Table, _, _, [Name, Arity]),
    Roots =.. Values,
    length(Own, Arity),
    append(_, Own, Values),
    memberchk(Number, Own),
    !.
source(_, _, _, _, action/1).
