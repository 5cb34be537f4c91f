:- module(delivery, []).

% A robot brings parcels from room to room. Copied and renamed by `nppg new`: change it into your own domain.
%
% A state is the set of the facts that hold in it. Nothing below has a state argument: the predicates see the
% facts of the current state. docs/domains.md describes everything that a domain may define.

% The predicates that a state consists of.

:- fluent at/1, in/2, holding/1, wanted/2.

% Numbers that can be set from outside: --set rooms=6.

:- parameter(rooms, 4).
:- parameter(parcels, 3).

% start(-Facts): a random start state. All randomness comes from random/1, random_between/3, random_member/2
% and random_permutation/2, so that a seed reproduces a run.

start([at(Room), wanted(Parcel, Target)|Facts]) :-
    rooms(Rooms),
    parcels(Parcels),
    random_member(Room, Rooms),
    random_member(Parcel, Parcels),
    placed(Parcels, Rooms, Facts),
    random_member(Target, Rooms),
    \+ memberchk(in(Parcel, Target), Facts),
    !.
start(Facts) :- start(Facts).

placed([], _, []).
placed([Parcel|Parcels], Rooms, [in(Parcel, Room)|Facts]) :-
    random_member(Room, Rooms),
    placed(Parcels, Rooms, Facts).

rooms(Rooms)     :- parameter(rooms, N), findall(Room, ( between(1, N, I), atom_concat(room, I, Room) ), Rooms).
parcels(Parcels) :- parameter(parcels, N), findall(Parcel, ( between(1, N, I), atom_concat(parcel, I, Parcel) ), Parcels).

% What a language bias may ask about a state, beside the fluents.

empty_handed :- \+ holding(_).

% action(-Action): the legal actions.

action(go(Room))    :- rooms(Rooms), member(Room, Rooms), \+ at(Room).
action(pick(Parcel)) :- empty_handed, at(Room), in(Parcel, Room).
action(drop(Parcel)) :- holding(Parcel).

% effect(+Action, -Delete, -Add): what an action changes.

effect(go(Room), [at(Old)], [at(Room)])                        :- at(Old).
effect(pick(Parcel), [in(Parcel, Room)], [holding(Parcel)])    :- in(Parcel, Room).
effect(drop(Parcel), [holding(Parcel)], [in(Parcel, Room)])    :- at(Room).

% goal: the episode has succeeded. The reward is then 1, if reward/2 does not say otherwise.

goal :- wanted(Parcel, Target), in(Parcel, Target).

% horizon(-Steps): in a start state, after how many steps the episode ends. Here as many as are needed, so that
% only the best way is rewarded.

horizon(Steps) :-
    wanted(Parcel, _),
    in(Parcel, Place),
    (   at(Place) -> Steps = 3 ; Steps = 4 ).

% expert(-Action), optional: what an expert would do; a share of the episodes follows it.

expert(drop(Parcel)) :- holding(Parcel), \+ wanted(Parcel, _).
expert(drop(Parcel)) :- holding(Parcel), wanted(Parcel, Room), at(Room).
expert(go(Room))     :- holding(Parcel), wanted(Parcel, Room), \+ at(Room).
expert(go(Room))     :- empty_handed, wanted(Parcel, _), in(Parcel, Room), \+ at(Room).
expert(pick(Parcel)) :- empty_handed, wanted(Parcel, _), in(Parcel, Room), at(Room).
