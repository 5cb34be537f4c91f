:- module(nppg_join_order,
          [ ordered/4,           % +Module, +Bound, +Literals, -Ordered  det
            few/2,               % +Module, +Literal             semidet
            outgrown/3           % +Module, +Size, -Next         semidet
          ]).

:- use_module(library(lists), [member/2]).
:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).
:- use_module(interpretation, []).

/** <module> In which order the literals of a test are asked

A conjunction is faster where literals with few answers come first. Literals of fluents and static predicates, which are
facts, may move to the front: they are answered however their arguments are bound. Others keep their order, and come
behind all facts that stood before them, so that they find bound what they found bound before.
*/

%!  ordered(+Module, +Bound, +Literals, -Ordered) is det.
%
%   Next comes what is a fact without unbound variables, then the literal that is expected to have the fewest answers: of
%   n facts of k arguments n^(u/k), where u of them are unbound; of others as if there were as many facts as of the largest
%   predicate. How many there are is seen in the current state.
%   Bound is a term whose variables are bound before.

ordered(Module, Bound, Literals, Ordered) :-
    (   Literals = [_, _|_],
        member(Fact, Literals),
        facts(Module, Fact, _)
    ->  variables(Bound, Known),
        largest(Literals, Module, 10, Largest),
        next(Literals, Module, Known, Largest, Ordered)
    ;   Ordered = Literals
    ).

next([], _, _, _, []).
next([Literal|Literals], Module, Known, Largest, [Chosen|Ordered]) :-
    cost(Literal, Module, Known, Largest, Cost),
    cheapest(Literals, Module, Known, Largest, Cost-Literal, Chosen),
    removed([Literal|Literals], Chosen, Rest),
    variables(Chosen, Own),
    ord_union(Known, Own, Now),
    next(Rest, Module, Now, Largest, Ordered).

%   The first literal, or a fact behind it that is cheaper.

cheapest([], _, _, _, _-Best, Best).
cheapest([Literal|Literals], Module, Known, Largest, Cost0-Best0, Best) :-
    (   facts(Module, Literal, _),
        cost(Literal, Module, Known, Largest, Cost),
        Cost < Cost0
    ->  cheapest(Literals, Module, Known, Largest, Cost-Literal, Best)
    ;   cheapest(Literals, Module, Known, Largest, Cost0-Best0, Best)
    ).

removed([Literal|Literals], Chosen, Rest) :-
    (   Literal == Chosen
    ->  Rest = Literals
    ;   Rest = [Literal|More],
        removed(Literals, Chosen, More)
    ).

cost(Literal, Module, Known, Largest, Cost) :-
    variables(Literal, Own),
    ord_subtract(Own, Known, Unbound),
    length(Unbound, Count),
    (   facts(Module, Literal, Number)
    ->  (   Count =:= 0
        ->  Cost = 0
        ;   functor(Literal, _, Arity),
            Cost is max(Number, 1)**(Count/Arity)
        )
    ;   functor(Literal, _, Arity),
        Cost is Largest**(Count/max(Arity, 1))
    ).

facts(Module, Literal, Number) :-
    functor(Literal, Name, Arity),
    (   catch(Module:nppg_fluent(Name/Arity), _, fail)
    ;   catch(Module:nppg_static(Name/Arity), _, fail)
    ),
    !,
    functor(Head, Name, Arity),
    (   predicate_property(Module:Head, number_of_clauses(Number))
    ->  true
    ;   Number = 0
    ).

largest([], _, Largest, Largest).
largest([Literal|Literals], Module, Largest0, Largest) :-
    (   facts(Module, Literal, Number)
    ->  Largest1 is max(Largest0, Number)
    ;   Largest1 = Largest0
    ),
    largest(Literals, Module, Largest1, Largest).

variables(Term, Variables) :-
    term_variables(Term, Found),
    sort(Found, Variables).

%!  few(+Module, +Literal) is semidet.
%
%   Whether the literal is a fact's, of a predicate that has few of them.

few(Module, Literal) :-
    facts(Module, Literal, Number),
    Number =< 20.

%!  outgrown(+Module, +Size, -Next) is semidet.
%
%   Whether the current state has more facts than Size, so that an order that was found in smaller ones is to be found
%   anew; it is good for states of up to Next facts.

outgrown(Module, Size, Next) :-
    nppg_interpretation:facts(Module, Count),
    Count > Size,
    Next is 4*Count.
