:- use_module('../../prolog/known_answers').

:- begin_tests(known_answers).

test(none, fail) :-
    known_answers(nowhere, toy, _).
test(emptied, [cleanup(drop_answers_of(t, _)), Found == [1]]) :-
    keep_answers(t, 7),
    known_answers(t, toy, Trie),
    trie_insert(Trie, question(7, roots(a)), 1),
    known_answers(t, toy, Same),
    findall(Word, trie_lookup(Same, question(7, roots(a)), Word), Found),
    keep_answers(t, 8),
    drop_answers_of(t, 8),
    known_answers(t, toy, New),
    \+ trie_lookup(New, question(7, roots(a)), _),
    is_kept(t, 7),
    \+ is_kept(t, 8).

:- end_tests(known_answers).
