:- module(nppg_randomness,
          [ random/1,            % -Float                 det
            random_between/3,    % +Low, +High, -Integer  semidet
            random_member/2,     % -Member, +List         semidet
            random_permutation/2 % +List, -Permutation    det
          ]).

/** <module> Randomness of a domain, drawn from Python's generator

The predicates of library(random) that a domain may call, with the same names and meanings. Every number
comes from the NumPy generator that the caller handed over, so a seed reproduces a run.
*/

:- use_module(library(janus), [py_call/2]).
:- use_module(library(lists), [member/2, nth0/3]).
:- use_module(library(pairs), [pairs_values/2]).

%!  random(-Float) is det.
%
%   Uniform in [0, 1).

random(Float) :-
    py_call('nppg.prolog':uniform(), Drawn),
    (   Drawn >= 0
    ->  Float = Drawn
    ;   throw(nppg_unseeded)
    ).

random_between(Low, High, Integer) :-
    Low =< High,
    random(Float),
    Integer is Low + truncate(Float * (High - Low + 1)).

random_member(Member, List) :-
    length(List, Length),
    Length > 0,
    random(Float),
    Index is truncate(Float * Length),
    nth0(Index, List, Member).

random_permutation(List, Permutation) :-
    findall(Key-Element, (member(Element, List), random(Key)), Keyed),
    keysort(Keyed, Sorted),
    pairs_values(Sorted, Permutation).
