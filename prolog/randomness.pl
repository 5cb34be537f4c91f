:- module(nppg_randomness,
          [ without_draws/1,     % :Goal                  semidet
            random/1,            % -Float                 det
            random_between/3,    % +Low, +High, -Integer  semidet
            random_member/2,     % -Member, +List         semidet
            random_permutation/2, % +List, -Permutation   det
            random_normal/3      % +Mean, +Deviation, -Float  det
          ]).

/** <module> Randomness of a domain, drawn from Python's generator

The predicates of library(random) that a domain may call, with the same names and meanings, and a normal
draw. Every number comes from the NumPy generator that the caller handed over, so a seed reproduces a run.
*/

:- use_module(library(janus), [py_call/2]).
:- use_module(library(lists), [nth0/3]).
:- use_module(library(pairs), [pairs_keys_values/3, pairs_values/2]).

%!  without_draws(:Goal) is semidet.
%
%   once(Goal), in which no number can be drawn.

:- meta_predicate without_draws(0).

without_draws(Goal) :-
    b_setval(nppg_draws, none),
    call(Goal),
    !,
    b_setval(nppg_draws, any).

%!  random(-Float) is det.
%
%   Uniform in [0, 1).

random(Float) :-
    draws(1, [Float]).

draws(0, []) :-
    !.
draws(Count, Floats) :-
    (   \+ nb_current(nppg_draws, none),
        py_call('nppg.bridge.prolog':uniform(Count), Floats),
        Floats \== none
    ->  true
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
    length(List, Length),
    draws(Length, Floats),
    pairs_keys_values(Keyed, Floats, List),
    keysort(Keyed, Sorted),
    pairs_values(Sorted, Permutation).

%!  random_normal(+Mean, +Deviation, -Float) is det.
%
%   Normal with that standard deviation, from two uniform draws (Box and Muller 1958). 1 - U1 is never 0.

random_normal(Mean, Deviation, Float) :-
    draws(2, [U1, U2]),
    Float is Mean + Deviation * sqrt(-2 * log(1 - U1)) * cos(2 * pi * U2).
