:- module(nppg_test_clauses,
          [ word_clause/4,       % +Word, +Table, +Roots, +Key                det
            pack_clause/4,       % +Pack, +Table, +Roots, +Number             det
            least/3,             % +Numbers, +Name, -Least                    det
            checked/2            % +Number, :Otherwise                        det
          ]).

:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [member/2]).
:- use_module(join_order, [ordered/4]).
:- use_module(layout, [layout/4]).
:- use_module(terms).

/** <module> Tests compiled into clauses

A test is a conjunction over the root variables of an example, the arguments of its action and of the
goal, and over existential variables of its own. The answers to up to 60 tests are the bits of one word.

The value of a *measure*, a test with a bound, is not a bit but the least number for which its other literals hold, of
`X >= c` the least of -X, or infinity: it decides the test for every threshold. It takes a word of its own.

The clauses are '$row'(Key, Roots, Word) for the tests of a table (see table.pl), '$pack'(Number, Roots, Word) for a
pack (see query_pack.pl) and '$solution'(Key, Roots, Number) for what a measure is about. blame.pl reads them.
*/

%!  word_clause(+Word, +Table, +Roots, +Key) is det.
%
%   Word is a list of at most 60 tests, a test a list of literals as data, or a measure [measure, Test], the bound
%   first in Test.

word_clause([measure, Test], Table, Roots, Key) :-
    !,
    retractall(Table:'$solution'(Key, _, _)),
    measure(Table, Roots, Test, Key, Value, Goal),
    compiled(Table, ('$row'(Key, Roots, Value) :- Goal)).
word_clause(Tests, Table, Roots, Key) :-
    layout(Table, Module, _, _),
    foldl(test_bit(Module, Roots), Tests, bits(1, 0, true), bits(_, Bits, Body)),
    compiled(Table, ('$row'(Key, Roots, Bits) :- Body)).

%!  pack_clause(+Pack, +Table, +Roots, +Number) is det.
%
%   Pack is [Prefix, Tests], with at most 60 tests, or a measure.

pack_clause([measure, Test], Table, Roots, Number) :-
    !,
    measure(Table, Roots, Test, pack(Number), Value, Goal),
    compiled(Table, ('$pack'(Number, Roots, Value) :- Goal)).
pack_clause([Prefix, Tests], Table, Roots, Number) :-
    query_variables(Roots, [Prefix], Shared),
    literals(Prefix, Shared, PrefixLiterals),
    conjunction(PrefixLiterals, PrefixGoal),
    length(Tests, Size),
    Full is (1<<Size)-1,
    foldl(pack_bit(Shared), Tests, bits(1, Bits0, true), bits(_, Bits, Body)),
    compiled(Table, ( '$pack'(Number, Roots, Answer) :-
                          Answers = answers(0),
                          (   PrefixGoal,
                              arg(1, Answers, Bits0),
                              Body,
                              nb_setarg(1, Answers, Bits),
                              Bits =:= Full
                          ->  true
                          ;   true
                          ),
                          arg(1, Answers, Answer) )).

pack_bit(Shared, Test, bits(Bit, Bits0, Body), bits(NextBit, Bits, Extended)) :-
    NextBit is Bit*2,
    query_variables(Shared, [Test], Variables),
    literals(Test, Variables, Literals),
    conjunction(Literals, Goal),
    Extended = (Body, ( Bits0 /\ Bit =:= 0, Goal -> Bits is Bits0+Bit ; Bits = Bits0 )).

%   Compiles the solutions of a measure under a key of their own; Goal gives its Value.

measure(Table, Roots, Test, Key, Value, Goal) :-
    query_variables(Roots, [Test], Variables),
    literals(Test, Variables, [Bound|Literals]),
    conjunction(Literals, Body),
    Bound =.. [Name, Number, _],
    compiled(Table, ('$solution'(Key, Roots, Number) :- Body)),
    Goal = ( findall(Found, '$solution'(Key, Roots, Found), Numbers),
             nppg_test_clauses:least(Numbers, Name, Value) ).

%!  least(+Numbers, +Name, -Least) is det.
%
%   The least number, or the least of the negated numbers for the bound >=, as a float; infinity if there is none, or
%   if it is too large for a float.

least(Numbers, Name, Least) :-
    unmet(Name, None),
    foldl(tighter(Name), Numbers, None, Extreme),
    signed(Name, Extreme, Least).

tighter(Name, Number, Extreme0, Extreme) :-
    checked(Number, throw),
    (   call(Name, Extreme0, Number)
    ->  Extreme = Extreme0
    ;   Extreme = Number
    ).

:- meta_predicate checked(+, 1).

checked(Number, Otherwise) :-
    (   number(Number), Number =:= Number
    ->  true
    ;   call(Otherwise, 'gave ~p, which is compared with a threshold and is no number,'-[Number])
    ).

unmet(=<, None) :-
    None is inf.
unmet(>=, None) :-
    None is -inf.

signed(Name, Number, Value) :-
    (   abs(Number) =< 1.7976931348623157e308
    ->  Size is float(Number)
    ;   Number < 0
    ->  Size is -inf
    ;   Size is inf
    ),
    (   Name == (=<)
    ->  Value = Size
    ;   Value is -Size
    ).

compiled(Table, Clause) :-
    current_prolog_flag(optimise, Old),
    setup_call_cleanup(
        set_prolog_flag(optimise, true),
        assertz(Table:Clause),
        set_prolog_flag(optimise, Old)).

test_bit(Module, Roots, Test, bits(Bit, Bits0, Body), bits(NextBit, Bits, Extended)) :-
    NextBit is Bit*2,
    test_goal(Module, Roots, Test, Goal),
    Extended = (Body, ( Goal -> Bits is Bits0+Bit ; Bits = Bits0 )).

%   Each test gets fresh existential variables.

test_goal(Module, Roots, Test, Goal) :-
    query_variables(Roots, [Test], Variables),
    literals(Test, Variables, Literals),
    ordered(Module, Roots, Literals, Ordered),
    conjunction(Ordered, Goal).

query_variables(Roots, Queries, Variables) :-
    functor(Roots, _, RootCount),
    findall(Number, ( member(Query, Queries), member([_|Args], Query), member(Number, Args), integer(Number) ), Numbers),
    foldl(higher, Numbers, RootCount, Size),
    functor(Variables, v, Size),
    share(1, RootCount, Roots, Variables).

higher(Number, Size0, Size) :-
    Size is max(Size0, Number+1).

share(N, Count, _, _) :-
    N > Count,
    !.
share(N, Count, Roots, Variables) :-
    arg(N, Roots, Variable),
    arg(N, Variables, Variable),
    Next is N+1,
    share(Next, Count, Roots, Variables).
