:- module(nppg_known_answers,
          [ keep_answers/2,      % +Table, +Key                               det
            drop_answers_of/2,   % +Table, ?Key                               det
            is_kept/2,           % +Table, +Key                               semidet
            known_answers/3      % +Table, +Module, -Trie                     semidet
          ]).

:- use_module(interpretation, [in_force/2]).

/** <module> Answers that hold in every state of a problem

The answer of a word of tests (see table.pl) about some objects is the same in all states where no test of the word can
depend on a fluent (see call_graph.pl). It is kept for as long as the problem's static facts are in force.
*/

:- dynamic
    kept/2,                      % Table, Key
    store/3.                     % Table, number of the static facts, Trie

%!  keep_answers(+Table, +Key) is det: from now on keeps the answers of a word.

keep_answers(Table, Key) :-
    assertz(kept(Table, Key)).

%!  drop_answers_of(+Table, ?Key) is det: keeps none of a word any more; unbound, of none of them.

drop_answers_of(Table, Key) :-
    retractall(kept(Table, Key)),
    empty(Table).

empty(Table) :-
    forall(retract(store(Table, _, Trie)), trie_destroy(Trie)).

%!  is_kept(+Table, +Key) is semidet: whether the answers of a word are kept.

is_kept(Table, Key) :-
    kept(Table, Key).

%!  known_answers(+Table, +Module, -Trie) is semidet.
%
%   Those about the problem of the current state: a trie of question(Key, Roots) and the word. Fails where no word's
%   are kept.

known_answers(Table, Module, Trie) :-
    kept(Table, _),
    !,
    in_force(Module, Number),
    (   store(Table, Number, Trie),
        trie_property(Trie, value_count(Count)),
        most(Most),
        Count =< Most
    ->  true
    ;   empty(Table),
        trie_new(Trie),
        assertz(store(Table, Number, Trie))
    ).

most(200 000).
