:- use_module('../../prolog/known_answers').

:- begin_tests(known_answers).

test(dropped, [cleanup(drop_answers(t)), Found == [1]]) :-
    known_answers(t, toy, Trie),
    trie_insert(Trie, question(-7, roots(a)), 1),
    known_answers(t, toy, Same),
    findall(Word, trie_lookup(Same, question(-7, roots(a)), Word), Found),
    drop_answers(t),
    known_answers(t, toy, New),
    \+ trie_lookup(New, question(-7, roots(a)), _).

:- end_tests(known_answers).
