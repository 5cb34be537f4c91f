:- module(nppg_query_pack,
          [ load_examples/3,     % +Table, +States, +Examples                 det
            drop_examples/1,     % +Table                                     det
            coverage/4           % +Table, +Packs, +Examples, -Words          det
          ]).

:- use_module(library(apply), [foldl/4]).
:- use_module(blame).
:- use_module(guard, [guarded/2]).
:- use_module(interpretation, [enforce/2, interpret/2]).
:- use_module(layout).
:- use_module(test_clauses, [pack_clause/4]).

/** <module> Query packs: many tests asked at once

A *pack* (Blockeel et al. 2002) is the set of a node's tests that extend one part of its query: that prefix
runs once, and a test that has succeeded is not tried again. Packs are asked about examples: pairs of a state and an
action, which are loaded before. The table (see table.pl) says what the root variables are, and its module keeps the
clauses while they are asked.
*/

:- dynamic
    state/3,                     % Table, Number, state(Static, Facts, GoalValues)
    example/4.                   % Table, Number, State, Roots

%!  load_examples(+Table, +States, +Examples) is det.
%
%   Replaces the examples that coverage/4 is asked about. States is a list of Static-Facts, the number of the
%   static facts and a sorted list, Examples a
%   list of [State, Action] with the number of a state, from 0.

load_examples(Table, States, Examples) :-
    drop_examples(Table),
    layout(Table, Module, _, _),
    foldl(load_state(Table, Module), States, 0, _),
    foldl(load_example(Table), Examples, 0, _).

drop_examples(Table) :-
    retractall(state(Table, _, _)),
    retractall(example(Table, _, _, _)).

load_state(Table, Module, Static-Facts, Number, Next) :-
    enforce(Module, Static),
    interpret(Module, Facts),
    goal_values(Table, GoalValues),
    assertz(state(Table, Number, state(Static, Facts, GoalValues))),
    Next is Number+1.

load_example(Table, [State, Action], Number, Next) :-
    state(Table, State, state(_, _, GoalValues)),
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
    pack_clause(Pack, Table, Roots, Number),
    Next is Number+1.

example_words([], _, _, _, _) -->
    [].
example_words([Number|Numbers], Table, Module, Count, Current) -->
    { example(Table, Number, State, Roots),
      (   State == Current
      ->  true
      ;   state(Table, State, state(Static, Facts, _)),
          enforce(Module, Static),
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

%   Where a pack does not finish, the single test at fault is looked for.

answered(Table, Goal, Roots) :-
    layout(Table, Module, _, _),
    catch(guarded(Module:test/0, Goal), nppg_fault(_, Fault),
          ( blame(Module, Goal, Roots), throw(nppg_fault(Module:test/0, Fault)) )).
