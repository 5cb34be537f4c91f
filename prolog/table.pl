:- module(nppg_table,
          [ new_table/4,         % +Module, +Kinds, +Goal, -Table             det
            drop_table/1,        % +Table                                     det
            set_tests/4,         % +Table, +Dropped, +Words, +Kinds           det
            rows/4               % +Table, +Actions, -Kinds, -Words           det
          ]).

:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2, nth0/3]).
:- use_module(blame).
:- use_module(guard, [guarded/3]).
:- use_module(join_order, [outgrown/3]).
:- use_module(known_answers).
:- use_module(layout).
:- use_module(test_clauses, [word_clause/4]).

/** <module> Tables: tests that are asked again and again

A *table* keeps tests that are asked again and again: those without a shared prefix. They are compiled into one clause
per word, in a module that sees the domain. A word is about some arguments and the goal: which of an action's arguments
these are, the words of its kind say. So tests that ask the same of different arguments, even of different kinds of
actions, are one word, and it is asked once in a state for every choice of arguments that its actions make: a word about
the goal's objects alone once.
*/

:- dynamic
    tables/1,
    given/4,                     % Table, Key, Arity, Word: as set_tests/4 had it
    keeps/1,                     % Table: some of its words have keys below 0
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
    dynamic([Table:('$row'/3), Table:('$solution'/3), Table:('$questions'/9)]),
    new_layout(Table, Module, Kinds, Goal),
    maplist(no_words, Kinds, None),
    set_kinds(None, 0, Table).

no_words(_, []).

drop_table(Table) :-
    drop_layout(Table),
    drop_answers(Table),
    retractall(keeps(Table)),
    retractall(given(Table, _, _, _)),
    retractall(sized(Table, _)),
    retractall(Table:'$row'(_, _, _)),
    retractall(Table:'$solution'(_, _, _)),
    retractall(Table:'$questions'(_, _, _, _, _, _, _, _, _)).

%!  set_tests(+Table, +Dropped, +Words, +Kinds) is det.
%
%   Compiles new words, drops others, and says what is asked about the actions of every kind.
%
%   Words is a list of [Key, Arity, Word]. Word is a list of at most 60 tests, a test a list of literals as data, or a
%   measure [measure, Test], the bound first in Test; the first Arity variables are the arguments that it is about, behind
%   them come the goal's. Key is below 0 where none of them can depend on a fluent. Dropped is a list of keys. Kinds has a list for each kind of action, of [Key, Positions, Alone]:
%   the word is asked about the arguments in these positions; Alone is true where no other action is asked the same.

set_tests(Table, Dropped, Words, Kinds) :-
    forall(member(Key, Dropped), drop_word(Table, Key)),
    forall(member([Key, Arity, Word], Words),
           ( assertz(given(Table, Key, Arity, Word)), compile_word(Table, Key, Arity, Word) )),
    retractall(keeps(Table)),
    (   given(Table, Kept, _, _),
        Kept < 0
    ->  assertz(keeps(Table))
    ;   true
    ),
    retractall(Table:'$questions'(_, _, _, _, _, _, _, _, _)),
    set_kinds(Kinds, 0, Table).

drop_word(Table, Key) :-
    retractall(given(Table, Key, _, _)),
    retractall(Table:'$row'(Key, _, _)),
    retractall(Table:'$solution'(Key, _, _)).

compile_word(Table, Key, Arity, Word) :-
    layout(Table, _, _, Goal),
    template(Goal, _, GoalValues),
    length(GoalValues, GoalArity),
    Count is Arity+GoalArity,
    functor(Roots, roots, Count),
    retractall(Table:'$row'(Key, _, _)),
    word_clause(Word, Table, Roots, Key).

%   '$questions'(Action, GoalValues, Kind, Shared, SharedEnd, Own, OwnEnd, Words, WordsEnd): what is asked about an action
%   of a kind, as lists with open ends: of question(Key, Roots)-Word where another action may ask the same, and where none
%   does; and their words in order.

set_kinds([], _, _).
set_kinds([Asked|Kinds], Kind, Table) :-
    layout(Table, _, Templates, Goal),
    nth0(Kind, Templates, Template),
    template(Template, Action, _),
    template(Goal, _, GoalValues),
    questions(Asked, Action, GoalValues, Shared, SharedEnd, Own, OwnEnd, Words, WordsEnd),
    assertz(Table:'$questions'(Action, GoalValues, Kind, Shared, SharedEnd, Own, OwnEnd, Words, WordsEnd)),
    Next is Kind+1,
    set_kinds(Kinds, Next, Table).

questions([], _, _, Shared, Shared, Own, Own, Words, Words).
questions([[Key, Positions, Alone]|Asked], Action, GoalValues, Shared, SharedEnd, Own, OwnEnd, [Word|Words], WordsEnd) :-
    projection(Positions, Action, Values),
    append(Values, GoalValues, All),
    Roots =.. [roots|All],
    Question = question(Key, Roots)-Word,
    (   Alone == true
    ->  Own = [Question|MoreOwn],
        More = Shared
    ;   Shared = [Question|More],
        MoreOwn = Own
    ),
    questions(Asked, Action, GoalValues, More, SharedEnd, MoreOwn, OwnEnd, Words, WordsEnd).

projection([], _, []).
projection([Position|Positions], Action, [Value|Values]) :-
    arg(Position, Action, Value),
    projection(Positions, Action, Values).

%   The literals of tests stand in an order that is good for states of some size.

suit(Table, Module) :-
    (   sized(Table, Size)
    ->  true
    ;   Size = 0
    ),
    (   outgrown(Module, Size, Next)
    ->  retractall(sized(Table, _)),
        assertz(sized(Table, Next)),
        findall(word(Key, Arity, Word), given(Table, Key, Arity, Word), Words),
        forall(member(word(Key, Arity, Word), Words), compile_word(Table, Key, Arity, Word))
    ;   true
    ).

%!  rows(+Table, +Actions, -Kinds, -Words) is det.
%
%   The answers to all tests of the table for actions of the current state: the kind of each action, and its words,
%   action by action.

rows(Table, Actions, Kinds, Words) :-
    goal_values(Table, GoalValues),
    all_questions(Actions, Table, GoalValues, Kinds, Shared, Own, Words),
    layout(Table, Module, _, _),
    suit(Table, Module),
    length(Words, Count),
    Asked is 60*Count,
    keysort(Shared, Sorted),
    (   keeps(Table)
    ->  known_answers(Table, Module, Trie),
        Kept = known(Trie)
    ;   Kept = none
    ),
    catch(guarded(Module:test/0, Asked, answered(Sorted, Own, Kept, Table)),
          nppg_fault(_, Fault),
          blame_table(Table, Sorted, Own, Fault)).

all_questions([], _, _, [], [], [], []).
all_questions([Action|Actions], Table, GoalValues, [Kind|Kinds], Shared, Own, Words) :-
    (   Table:'$questions'(Action, GoalValues, Kind, Shared, MoreShared, Own, MoreOwn, Words, MoreWords)
    ->  all_questions(Actions, Table, GoalValues, Kinds, MoreShared, MoreOwn, MoreWords)
    ;   action_roots(Table, GoalValues, Action, Kind, _)      % says that there is no such kind
    ).

answered(Sorted, Own, Kept, Table) :-
    answer_shared(Sorted, Kept, Table),
    answer_own(Own, Kept, Table).

answer_own([], _, _).
answer_own([question(Key, Roots)-Word|Questions], Kept, Table) :-
    answer(Kept, Table, Key, Roots, Word),
    answer_own(Questions, Kept, Table).

%   Questions that are the same stand together.

answer_shared([], _, _).
answer_shared([Question-Word|Questions], Kept, Table) :-
    Question = question(Key, Roots),
    answer(Kept, Table, Key, Roots, Word),
    answer_again(Questions, Question, Word, Kept, Table).

answer_again([], _, _, _, _).
answer_again([Question-Word|Questions], Last, Known, Kept, Table) :-
    (   Question == Last
    ->  Word = Known,
        answer_again(Questions, Last, Known, Kept, Table)
    ;   Question = question(Key, Roots),
        answer(Kept, Table, Key, Roots, Word),
        answer_again(Questions, Question, Word, Kept, Table)
    ).

%   Kept is known(Trie) where some answers hold in every state of the problem, else `none`.

answer(none, Table, Key, Roots, Word) :-
    Table:'$row'(Key, Roots, Word).
answer(known(Trie), Table, Key, Roots, Word) :-
    (   Key < 0
    ->  (   trie_lookup(Trie, question(Key, Roots), Known)
        ->  Word = Known
        ;   Table:'$row'(Key, Roots, Word),
            trie_insert(Trie, question(Key, Roots), Word)
        )
    ;   Table:'$row'(Key, Roots, Word)
    ).

%   Where asking does not finish, the single test at fault is looked for, so that the message can name its
%   predicate.

blame_table(Table, Sorted, Own, Fault) :-
    layout(Table, Module, _, _),
    (   member(Questions, [Sorted, Own]),
        member(question(Key, Roots)-_, Questions),
        catch(( blame(Module, Table:'$row'(Key, Roots, _), Roots), fail ), Blamed, true)
    ->  throw(Blamed)
    ;   throw(nppg_fault(Module:test/0, Fault))
    ).
