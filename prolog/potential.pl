:- module(nppg_potential,
          [ new_policy/3,        % +Module, +Signatures, -Policy       det
            signatures/2,        % +Policy, -Signatures                det
            module_of/2,         % +Policy, -Module                    det
            drop_policy/1,       % +Policy                             det
            add_tree/2,          % +Policy, +Clauses                   det
            potential/3,         % +Policy, +Action, -Potential        det
            rule/3               % +Policy, ?Tree, -Clause             nondet
          ]).

:- use_module(library(lists), [append/3]).
:- use_module(terms).

/** <module> The potential: a sum of regression trees

Each tree is stored as the clauses of an ordered list, delta(Tree, Action, Value) :- Query, !. Their values
are already multiplied by the tree's step size, so the potential of an action in the current state is the
sum of the first answers, Psi(s, a) = delta(1, a) + ... + delta(M, a), added in this order.
*/

:- dynamic policies/1, size/2, signatures/2, module_of/2.
policies(0).

%!  new_policy(+Module, +Signatures, -Policy) is det.
%
%   Signatures is a list of [Name|Types], the types of the arguments of actions and predicates.

new_policy(Module, Signatures, Policy) :-
    retract(policies(Count0)),
    Count is Count0+1,
    assertz(policies(Count)),
    atom_concat('nppg_policy#', Count, Policy),
    add_import_module(Policy, Module, start),
    dynamic(Policy:(delta/3)),
    assertz(size(Policy, 0)),
    assertz(module_of(Policy, Module)),
    assertz(signatures(Policy, Signatures)).

drop_policy(Policy) :-
    retractall(size(Policy, _)),
    retractall(module_of(Policy, _)),
    retractall(signatures(Policy, _)),
    retractall(Policy:delta(_, _, _)).

%!  add_tree(+Policy, +Clauses) is det.
%
%   Clauses is a list [VariableCount, Head, Query, Value] as data, in order.

add_tree(Policy, Clauses) :-
    retract(size(Policy, Size)),
    Tree is Size+1,
    assertz(size(Policy, Tree)),
    forall(( append(_, [Data|Later], Clauses), clause_term(Data, Later, Tree, Clause) ),
           assertz(Policy:Clause)).

%   All rules but the last end in a cut.

clause_term([VariableCount, HeadData, Query, Value], Later, Tree, (delta(Tree, Action, Value) :- Body)) :-
    functor(Variables, v, VariableCount),
    (   HeadData == []
    ->  true
    ;   literal(HeadData, Variables, Action)
    ),
    literals(Query, Variables, Literals),
    (   Later == []
    ->  Goals = Literals
    ;   append(Literals, [!], Goals)
    ),
    conjunction(Goals, Body).

%!  potential(+Policy, +Action, -Potential) is det.
%
%   Of an action in the current state.

potential(Policy, Action, Potential) :-
    size(Policy, Size),
    sum(1, Size, Policy, Action, 0.0, Potential).

sum(Tree, Size, _, _, Potential, Potential) :-
    Tree > Size,
    !.
sum(Tree, Size, Policy, Action, Sum0, Potential) :-
    (   Policy:delta(Tree, Action, Value)
    ->  Sum is Sum0+Value
    ;   Sum = Sum0
    ),
    Next is Tree+1,
    sum(Next, Size, Policy, Action, Sum, Potential).

%!  rule(+Policy, ?Tree, -Clause) is nondet.
%
%   The stored clauses, in order.

rule(Policy, Tree, (delta(Tree, Action, Value) :- Body)) :-
    clause(Policy:delta(Tree, Action, Value), Body).
