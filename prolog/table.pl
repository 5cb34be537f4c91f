:- module(nppg_table,
          [ new_table/4,         % +Module, +Kinds, +Goal, -Table             det
            drop_table/1,        % +Table                                     det
            set_tests/4,         % +Table, +Kind, +Group, +Words              det
            rows/4               % +Table, +Actions, -Kinds, -Words           det
          ]).

:- use_module(library(apply), [exclude/3, foldl/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, member/2, nth0/3]).
:- use_module(blame).
:- use_module(guard, [guarded/3]).
:- use_module(join_order, [outgrown/3]).
:- use_module(layout).
:- use_module(test_clauses, [word_clause/4]).

/** <module> Tables: tests that are asked again and again

A *table* keeps tests that are asked again and again: those without a shared prefix. They are compiled into
one clause per word, in a module that sees the domain. A kind of action has its own clauses. The tests about the
same arguments of the action form a group: a group is asked once for all actions of a state that agree in those
arguments, so tests about the goal's objects alone are asked once in a state.
*/

:- dynamic
    tables/1,
    words/3,                     % Table, Kind, Words: of word(Key, Arguments), sorted
    given/3,                     % Table, Key, Word: as set_tests/4 had it
    sized/2.                     % Table, Size: up to how many facts its clauses are good for
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
    new_layout(Table, Module, Kinds, Goal).

drop_table(Table) :-
    drop_layout(Table),
    retractall(words(Table, _, _)),
    retractall(given(Table, _, _)),
    retractall(sized(Table, _)),
    retractall(Table:'$row'(_, _, _)),
    retractall(Table:'$solution'(_, _, _)).

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
    retractall(given(Table, Key, _)),
    assertz(given(Table, Key, Word)),
    compile_word(Table, Count, Key, Word),
    Next is Key+1.

compile_word(Table, Count, Key, Word) :-
    functor(Roots, roots, Count),
    retractall(Table:'$row'(Key, _, _)),
    word_clause(Word, Table, Roots, Key).

%   The literals of tests stand in an order that is good for states of some size.

suit(Table, Module) :-
    (   sized(Table, Size)
    ->  true
    ;   Size = 0
    ),
    (   outgrown(Module, Size, Next)
    ->  retractall(sized(Table, _)),
        assertz(sized(Table, Next)),
        root_count(Table, Count),
        findall(Key-Word, given(Table, Key, Word), Words),
        forall(member(Key-Word, Words), compile_word(Table, Count, Key, Word))
    ;   true
    ).

%!  rows(+Table, +Actions, -Kinds, -Words) is det.
%
%   The answers to all tests of the table for actions of the current state: the kind of each action, and the words,
%   those of one kind after those of another; of a kind, the first word of all its actions, then the second, and so on.

rows(Table, Actions, Kinds, Words) :-
    goal_values(Table, GoalValues),
    kinds_and_roots(Actions, Table, GoalValues, Kinds, AllRoots),
    layout(Table, Module, _, _),
    suit(Table, Module),
    sort(Kinds, Present),
    asked(Present, Table, Actions, Asked),
    catch(guarded(Module:test/0, Asked, kind_words(Present, Kinds, AllRoots, Table, Words, [])),
          nppg_fault(_, Fault),
          blame_table(Table, Kinds, AllRoots, Fault)).

%   At most so many answers: those of 60 tests a word.

asked(Kinds, Table, Actions, Asked) :-
    most_words(Kinds, Table, 0, Most),
    length(Actions, Length),
    Asked is 60*Most*Length.

most_words([], _, Most, Most).
most_words([Kind|Kinds], Table, Most0, Most) :-
    (   words(Table, Kind, Words)
    ->  length(Words, Count),
        Most1 is max(Most0, Count)
    ;   Most1 = Most0
    ),
    most_words(Kinds, Table, Most1, Most).

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

group_words(Words, AllRoots, Table) -->
    group_words(Words, none, none, AllRoots, Table).

group_words([], _, _, _, _) -->
    [].
group_words([word(Key, Arguments)|Words], Last, Sharing0, AllRoots, Table) -->
    { (   Arguments == Last
      ->  Sharing = Sharing0
      ;   sharing(Arguments, AllRoots, Sharing)
      ) },
    shared(Sharing, Key, Table),
    group_words(Words, Arguments, Sharing, AllRoots, Table).

%   Where many actions agree in the arguments that a group is about, it is asked once for all of them: alike(Roots,
%   Numbers) has one of each sort, and for every action the number of its sort.

sharing(Arguments, AllRoots, Sharing) :-
    (   Arguments \== all,
        projections(AllRoots, Arguments, Keys),
        sort(Keys, Distinct),
        length(Distinct, Count),
        length(Keys, All),
        2*Count =< All
    ->  numbered(Distinct, 1, Pairs),
        list_to_assoc(Pairs, Numbers),
        functor(Sorts, sorts, Count),
        numbers(Keys, AllRoots, Numbers, Sorts, Own),
        Sorts =.. [_|Some],
        Sharing = alike(Some, Own)
    ;   Sharing = each(AllRoots)
    ).

numbered([], _, []).
numbered([Key|Keys], Number, [Key-Number|Pairs]) :-
    Next is Number+1,
    numbered(Keys, Next, Pairs).

numbers([], [], _, _, []).
numbers([Key|Keys], [Roots|AllRoots], Numbers, Sorts, [Number|Own]) :-
    get_assoc(Key, Numbers, Number),
    arg(Number, Sorts, First),
    (   var(First)
    ->  First = Roots
    ;   true
    ),
    numbers(Keys, AllRoots, Numbers, Sorts, Own).

shared(each(AllRoots), Key, Table) -->
    answers(AllRoots, Key, Table).
shared(alike(Some, Numbers), Key, Table) -->
    { phrase(answers(Some, Key, Table), Words),
      Known =.. [known|Words] },
    known(Numbers, Known).

known([], _) -->
    [].
known([Number|Numbers], Known) -->
    { arg(Number, Known, Word) },
    [Word],
    known(Numbers, Known).

answers([], _, _) -->
    [].
answers([Roots|AllRoots], Key, Table) -->
    { Table:'$row'(Key, Roots, Word) },
    [Word],
    answers(AllRoots, Key, Table).

projections([], _, []).
projections([Roots|AllRoots], Positions, [Values|More]) :-
    projection(Positions, Roots, Values),
    projections(AllRoots, Positions, More).

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
