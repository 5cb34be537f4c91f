:- module(nppg_known_answers,
          [ known_answers/3,     % +Table, +Module, -Trie                     det
            drop_answers/1       % +Table                                     det
          ]).

:- use_module(interpretation, [in_force/2]).

/** <module> Answers that hold in every state of a problem

The answer of a word of tests (see table.pl) about some objects is the same in all states where no test of the word can
depend on a fluent (see call_graph.pl). It is kept for as long as the problem's static facts are in force.
*/

:- dynamic store/3.              % Table, number of the static facts, Trie

%!  known_answers(+Table, +Module, -Trie) is det.
%
%   Those about the problem of the current state: a trie of question(Key, Roots) and the word.

known_answers(Table, Module, Trie) :-
    in_force(Module, Number),
    (   store(Table, Number, Trie),
        trie_property(Trie, value_count(Count)),
        most(Most),
        Count =< Most
    ->  true
    ;   drop_answers(Table),
        trie_new(Trie),
        assertz(store(Table, Number, Trie))
    ).

most(200 000).

drop_answers(Table) :-
    forall(retract(store(Table, _, Trie)), trie_destroy(Trie)).
