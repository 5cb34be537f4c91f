:- module(nppg_query_pack,
          [ new_table/4,         % +Module, +Kinds, +Goal, -Table             det
            drop_table/1,        % +Table                                     det
            set_tests/4,         % +Table, +Kind, +Group, +Words              det
            rows/4,              % +Table, +Actions, -Kinds, -Words           det
            load_examples/3,     % +Table, +States, +Examples                 det
            coverage/4           % +Table, +Packs, +Examples, -Words          det
          ]).

:- use_module(library(apply), [exclude/3, foldl/4, maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2, memberchk/2, nth0/3]).
:- use_module(domain).
:- use_module(guard).
:- use_module(interpretation).
:- use_module(terms).

/** <module> Query packs: many tests asked at once

A test is a conjunction over the root variables of an example, the arguments of its action and of the
goal, and over existential variables of its own. The answers to up to 60 tests are the bits of one word.

A *table* keeps tests that are asked again and again: those without a shared prefix. They are compiled into
one clause per word, in a module that sees the domain. A kind of action has its own clauses. The tests about the
same arguments of the action form a group: a group is asked once for all actions of a state that agree in those
arguments, so tests about the goal's objects alone are asked once in a state.

The value of a *measure*, a test with a bound, is not a bit but the least number for which its other literals hold, of
`X >= c` the least of -X, or infinity: it decides the test for every threshold. It takes a word of its own.

A *pack* (Blockeel et al. 2002) is the set of a node's tests that extend one part of its query: that prefix
runs once, and a test that has succeeded is not tried again.
*/

:- dynamic
    layout/4,                    % Table, Module, Kinds, Goal
    roots/5,                     % Table, Action, GoalValues, Kind, Roots
    tables/1,
    state/3,                     % Table, Number, Facts
    example/4,                   % Table, Number, State, Roots
    words/3.                     % Table, Kind, Words: of word(Key, Arguments), sorted
tables(0).

%!  new_table(+Module, +Kinds, +Goal, -Table) is det.
%
%   Kinds is a list of [Name, Arity], the action templates; Goal is [] or [Name, Arity].

new_table(Module, Kinds, Goal, Table) :-
    retract(tables(Count0)),
    Count is Count0+1,
    assertz(tables(Count)),
    atom_concat('nppg_table#', Count, Table),
    set_module(Table:class(system)),
    add_import_module(Table, Module, start),
    dynamic([Table:('$row'/3), Table:('$solution'/3)]),
    assertz(layout(Table, Module, Kinds, Goal)),
    set_roots(Table, Kinds, Goal).

%   What the root variables are bound to by an action of each kind and by the goal; the arguments of other kinds
%   of actions stay unbound.

set_roots(Table, Kinds, Goal) :-
    maplist(template, Kinds, Actions, Args),
    template(Goal, _, GoalValues),
    append(Args, ActionValues),
    append(ActionValues, GoalValues, Values),
    Roots =.. [roots|Values],
    forall(nth0(Kind, Actions, Action), assertz(roots(Table, Action, GoalValues, Kind, Roots))).

template([], [], []).
template([Name, Arity], Template, Args) :-
    functor(Template, Name, Arity),
    Template =.. [_|Args].

drop_table(Table) :-
    retractall(layout(Table, _, _, _)),
    retractall(roots(Table, _, _, _, _)),
    retractall(words(Table, _, _)),
    drop_examples(Table),
    retractall(Table:'$row'(_, _, _)),
    retractall(Table:'$solution'(_, _, _)).

root_count(Table, Count) :-
    layout(Table, _, Kinds, Goal),
    foldl(add_arity, Kinds, 0, Count0),
    (   Goal = [_, Arity]
    ->  Count is Count0+Arity
    ;   Count = Count0
    ).

add_arity([_, Arity], Sum0, Sum) :-
    Sum is Sum0+Arity.

%!  set_tests(+Table, +Kind, +Group, +Words) is det.
%
%   Compiles the tests of a group, which replace those it had. Group is [Number, Positions]: the positions of
%   the root variables that it is about. Words is a list of lists of at most 60 tests, a test a list of
%   literals as data, or of measures [measure, Test], the bound first in Test. Groups are numbered from 0, and new ones come
%   behind the others. Where a group is about all arguments of the action, no other action has its answers: its words
%   have `all` in place of the positions.

set_tests(Table, Kind, [Number, Positions], Words) :-
    root_count(Table, Count),
    Key is (Kind*1 000 000 + Number)*1 000 000,
    foldl(set_word(Table, Count), Words, Key, End),
    (   retract(words(Table, Kind, Old))
    ->  true
    ;   Old = []
    ),
    layout(Table, _, Kinds, _),
    nth0(Kind, Kinds, [_, Arity]),
    (   Arity > 0, length(Positions, Arity)
    ->  Arguments = all
    ;   Arguments = Positions
    ),
    exclude(of_group(Arguments), Old, Others),
    Last is End-1,
    findall(word(Own, Arguments), between(Key, Last, Own), New),
    append(Others, New, All),
    sort(All, Sorted),
    assertz(words(Table, Kind, Sorted)).

of_group(Arguments, word(_, Arguments)).

set_word(Table, Count, Word, Key, Next) :-
    functor(Roots, roots, Count),
    retractall(Table:'$row'(Key, _, _)),
    word(Word, Table, Roots, Key),
    Next is Key+1.

word([measure, Test], Table, Roots, Key) :-
    !,
    retractall(Table:'$solution'(Key, _, _)),
    measure(Table, Roots, Test, Key, Value, Goal),
    compiled(Table, ('$row'(Key, Roots, Value) :- Goal)).
word(Tests, Table, Roots, Key) :-
    foldl(test_bit(Roots), Tests, bits(1, 0, true), bits(_, Bits, Body)),
    compiled(Table, ('$row'(Key, Roots, Bits) :- Body)).

%   Compiles the solutions of a measure under a key of their own; Goal gives its Value.

measure(Table, Roots, Test, Key, Value, Goal) :-
    query_variables(Roots, [Test], Variables),
    literals(Test, Variables, [Bound|Literals]),
    conjunction(Literals, Body),
    Bound =.. [Name, Number, _],
    compiled(Table, ('$solution'(Key, Roots, Number) :- Body)),
    Goal = ( findall(Found, '$solution'(Key, Roots, Found), Numbers),
             nppg_query_pack:least(Numbers, Name, Value) ).

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

test_bit(Roots, Test, bits(Bit, Bits0, Body), bits(NextBit, Bits, Extended)) :-
    NextBit is Bit*2,
    test_goal(Roots, Test, Goal),
    Extended = (Body, ( Goal -> Bits is Bits0+Bit ; Bits = Bits0 )).

%   Each test gets fresh existential variables.

test_goal(Roots, Test, Goal) :-
    query_variables(Roots, [Test], Variables),
    literals(Test, Variables, Literals),
    conjunction(Literals, Goal).

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

%!  action_roots(+Table, +GoalValues, +Action, -Kind, -Roots) is det.
%
%   The values of the root variables.

action_roots(Table, GoalValues, Action, Kind, Roots) :-
    (   roots(Table, Action, GoalValues, Kind, Roots)
    ->  true
    ;   layout(Table, Module, _, _),
        fault(Module:(action/1), 'gave ~p, for which the language bias has no action template,'-[Action])
    ).

goal_values(Table, Values) :-
    layout(Table, Module, _, Goal),
    (   Goal = [Name, Arity]
    ->  binding(Module, Name, Arity, Values)
    ;   Values = []
    ).

%!  rows(+Table, +Actions, -Kinds, -Words) is det.
%
%   The answers to all tests of the table for actions of the current state: the kind of each action, and the words,
%   those of one kind after those of another; of a kind, the first word of all its actions, then the second, and so on.

rows(Table, Actions, Kinds, Words) :-
    goal_values(Table, GoalValues),
    kinds_and_roots(Actions, Table, GoalValues, Kinds, AllRoots),
    layout(Table, Module, _, _),
    sort(Kinds, Present),
    catch(guarded(Module:test/0, kind_words(Present, Kinds, AllRoots, Table, Words, [])),
          nppg_fault(_, Fault),
          blame_table(Table, Kinds, AllRoots, Fault)).

kinds_and_roots([], _, _, [], []).
kinds_and_roots([Action|Actions], Table, GoalValues, [Kind|Kinds], [Roots|AllRoots]) :-
    action_roots(Table, GoalValues, Action, Kind, Roots),
    kinds_and_roots(Actions, Table, GoalValues, Kinds, AllRoots).

kind_words([], _, _, _) -->
    [].
kind_words([Kind|Present], Kinds, AllRoots, Table) -->
    { of_kind(Kinds, AllRoots, Kind, Own),
      (   words(Table, Kind, Words)
      ->  true
      ;   Words = []
      )
    },
    group_words(Words, Own, Table),
    kind_words(Present, Kinds, AllRoots, Table).

of_kind([], [], _, []).
of_kind([Kind|Kinds], [Roots|AllRoots], Wanted, Own) :-
    (   Kind == Wanted
    ->  Own = [Roots|Rest]
    ;   Own = Rest
    ),
    of_kind(Kinds, AllRoots, Wanted, Rest).

group_words([], _, _) -->
    [].
group_words([word(Key, Arguments)|Words], AllRoots, Table) -->
    (   { Arguments == all }
    ->  answers(AllRoots, Key, Table)
    ;   answers(AllRoots, Key, Arguments, Table, [])
    ),
    group_words(Words, AllRoots, Table).

answers([], _, _) -->
    [].
answers([Roots|AllRoots], Key, Table) -->
    { Table:'$row'(Key, Roots, Word) },
    [Word],
    answers(AllRoots, Key, Table).

%   A word is asked once for all actions that agree in the arguments that it is about.

answers([], _, _, _, _) -->
    [].
answers([Roots|AllRoots], Key, Positions, Table, Asked) -->
    { projection(Positions, Roots, Values),
      (   memberchk(Values-Known, Asked)
      ->  Word = Known,
          Now = Asked
      ;   Table:'$row'(Key, Roots, Word),
          Now = [Values-Word|Asked]
      )
    },
    [Word],
    answers(AllRoots, Key, Positions, Table, Now).

projection([], _, []).
projection([Position|Positions], Roots, [Value|Values]) :-
    arg(Position, Roots, Value),
    projection(Positions, Roots, Values).

%   Where asking does not finish, the single test at fault is looked for, so that the message can name its
%   predicate.

blame_table(Table, Kinds, AllRoots, Fault) :-
    layout(Table, Module, _, _),
    (   nth0(I, Kinds, Kind),
        nth0(I, AllRoots, Roots),
        words(Table, Kind, Words),
        member(word(Word, _), Words),
        catch(( blame(Module, Table:'$row'(Word, Roots, _), Roots), fail ), Blamed, true)
    ->  throw(Blamed)
    ;   throw(nppg_fault(Module:test/0, Fault))
    ).

%   Runs a pack, likewise.

answered(Table, Goal, Roots) :-
    layout(Table, Module, _, _),
    catch(guarded(Module:test/0, Goal), nppg_fault(_, Fault),
          ( blame(Module, Goal, Roots), throw(nppg_fault(Module:test/0, Fault)) )).

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
        Watched = ( nppg_query_pack:checked(Number, fault(Module:Source)), Literal )
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

%!  load_examples(+Table, +States, +Examples) is det.
%
%   Replaces the examples that coverage/4 is asked about. States is a list of sorted fact lists, Examples a
%   list of [State, Action] with the number of a state, from 0.

load_examples(Table, States, Examples) :-
    drop_examples(Table),
    layout(Table, Module, _, _),
    foldl(load_state(Table, Module), States, 0, _),
    foldl(load_example(Table), Examples, 0, _).

drop_examples(Table) :-
    retractall(state(Table, _, _)),
    retractall(example(Table, _, _, _)).

load_state(Table, Module, Facts, Number, Next) :-
    interpret(Module, Facts),
    goal_values(Table, GoalValues),
    assertz(state(Table, Number, Facts-GoalValues)),
    Next is Number+1.

load_example(Table, [State, Action], Number, Next) :-
    state(Table, State, _-GoalValues),
    action_roots(Table, GoalValues, Action, _, Roots),
    assertz(example(Table, Number, State, Roots)),
    Next is Number+1.

%!  coverage(+Table, +Packs, +Examples, -Words) is det.
%
%   Each pack is a list [Prefix, Tests] of literals as data, with at most 60 tests, or a measure. Words has one word
%   for each example and pack, example by example.

coverage(Table, Packs, Examples, Words) :-
    layout(Table, Module, _, _),
    setup_call_cleanup(
        foldl(compile_pack(Table), Packs, 0, Count),
        phrase(example_words(Examples, Table, Module, Count, -1), Words),
        ( retractall(Table:'$pack'(_, _, _)), retractall(Table:'$solution'(pack(_), _, _)) )).

compile_pack(Table, Pack, Number, Next) :-
    root_count(Table, Count),
    functor(Roots, roots, Count),
    pack(Pack, Table, Roots, Number),
    Next is Number+1.

pack([measure, Test], Table, Roots, Number) :-
    !,
    measure(Table, Roots, Test, pack(Number), Value, Goal),
    compiled(Table, ('$pack'(Number, Roots, Value) :- Goal)).
pack([Prefix, Tests], Table, Roots, Number) :-
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

example_words([], _, _, _, _) -->
    [].
example_words([Number|Numbers], Table, Module, Count, Current) -->
    { example(Table, Number, State, Roots),
      (   State == Current
      ->  true
      ;   state(Table, State, Facts-_),
          interpret(Module, Facts)
      )
    },
    pack_words(0, Count, Table, Roots),
    example_words(Numbers, Table, Module, Count, State).

pack_words(Count, Count, _, _) -->
    !.
pack_words(Number, Count, Table, Roots) -->
    { answered(Table, Table:'$pack'(Number, Roots, Word), Roots),
      Next is Number+1
    },
    [Word],
    pack_words(Next, Count, Table, Roots).
