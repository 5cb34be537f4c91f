:- module(nppg_schemas,
          [ schemas/2,           % +Module, -Data                      det
            extensions/4         % +Module, +Names, +Arities, -Found   det
          ]).

:- use_module(library(apply), [maplist/4]).
:- use_module(contract, [defined/2]).
:- use_module(guard, [guarded_findall/4]).
:- use_module(terms, [encode/2, encode_all/2]).

/** <module> What a domain's clauses say about its actions

A schema is an action with what has to hold for it and what it changes, read off the clauses of action/1 and effect/3 or
effect/4. Its variables are '$VAR'(N).
*/

%!  schemas(+Module, -Data) is det.
%
%   A list [Action, Goals, Deleted, Added] for each clause of action/1 with each clause that has an effect for it.

schemas(Module, Data) :-
    findall(Schema, schema(Module, Schema), Data).

schema(Module, [Name, GoalData, DeletedData, AddedData]) :-
    clause(Module:action(Action), Body),
    callable(Action),
    effect(Module, Action, Deleted0, Added0, Changing),
    known_items(Deleted0, Deleted),
    known_items(Added0, Added),
    conjuncts(Body, Goals, Goals1),
    conjuncts(Changing, Goals1, []),
    numbervars([Action, Goals, Deleted, Added], 0, _),
    encode(Action, Name),
    encode_all(Goals, GoalData),
    encode_all(Deleted, DeletedData),
    encode_all(Added, AddedData).

effect(Module, Action, Deleted, Added, Body) :-
    defined(Module, effect/3),
    clause(Module:effect(Action, Deleted, Added), Body).
effect(Module, Action, Deleted, Added, Body) :-
    defined(Module, effect/4),
    clause(Module:effect(Action, _, Deleted, Added), Body).

%   The items of a list that may go on in a variable.

known_items(List, Items) :-
    (   nonvar(List), List = [Item|Rest]
    ->  (   callable(Item)
        ->  Items = [Item|More]
        ;   Items = More
        ),
        known_items(Rest, More)
    ;   Items = []
    ).

conjuncts(Goal, Goals, Rest) :-
    (   nonvar(Goal), Goal = (Left, Right)
    ->  conjuncts(Left, Goals, Goals1),
        conjuncts(Right, Goals1, Rest)
    ;   Goal == true
    ->  Goals = Rest
    ;   Goals = [Goal|Rest]
    ).

%!  extensions(+Module, +Names, +Arities, -Found) is det.
%
%   What distinguishes the answers that predicates have in the current state: a hash for each, 0 where there are none, and
%   `error` where asking for all of them throws.

extensions(Module, Names, Arities, Found) :-
    maplist(extension(Module), Names, Arities, Found).

extension(Module, Name, Arity, Hash) :-
    functor(Head, Name, Arity),
    Head =.. [_|Args],
    (   catch(guarded_findall(Args, Module:Name/Arity, Module:Head, All), _, fail)
    ->  true
    ;   All = error
    ),
    (   All == error
    ->  Hash = error
    ;   All == []
    ->  Hash = 0
    ;   sort(All, Sorted),
        variant_sha1(Sorted, Hash)
    ).
