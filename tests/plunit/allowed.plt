:- use_module('../../prolog/allowed').

:- begin_tests(allowed).

test(kinds, all(Kind == [pure, meta(findall(?, 0, -)), special(format), pure, meta(maplist(1, ?)), other, other])) :-
    member(Head, [true, findall(_, _, _), format(_), append(_, _, _), maplist(_, _), shell(_), nobody_has_this(_)]),
    kind(Head, Kind).

test(exists, all(Name == [shell, holds, thread_create])) :-
    member(Name/Arity, [shell/1, holds/2, thread_create/3, nobody_has_this/1]),
    functor(Head, Name, Arity),
    exists(Head).

test(libraries, all(Library == [lists, pairs])) :-
    member(Indicator, [append/3, pairs_keys/2, shell/1, http_open/3]),
    library_of(Indicator, Library).

:- end_tests(allowed).
