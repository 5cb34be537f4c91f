:- module(nppg_formula,
          [ holds/1,             % :Formula                      semidet
            must_be_test/2,      % +Goal, +Module                det
            holds/2              % +Module, +Formula             semidet
          ]).

:- use_module(library(apply), [foldl/4, foldl/5, maplist/3, partition/4]).
:- use_module(library(error), [must_be/2, domain_error/2]).
:- use_module(library(lists), [append/2, append/3, member/2, memberchk/2]).
:- use_module(allowed, []).          % their names are for domains to use, which see what is imported here
:- use_module(goals, []).

/** <module> Formulas that are data

What a problem's goal wants beyond facts is a ground term, in which an atom that starts with a question mark is a
variable:

| holds(Fact)             | the fact holds, or follows from the domain's clauses          |
| not(F)                  | F does not hold                                               |
| and(List), or(List)     | all of the formulas hold; one of them holds                   |
| forall(Variables, F)    | F holds for all values of the variables, each given as Name-Type or Name-Types: a predicate of one argument that is true of its values, or a list of such |
| exists(Variables, F)    | F holds for some values                                       |
| eq(A, B)                | A and B are the same                                          |
| compare(Op, X, Y)       | Op is <, =<, =:=, >= or >; X and Y are numbers, terms of +, -, *, / and value(F), which is N where the fact F with N as a further last argument holds |

In the domain ferry forall(['?c'-car], or([not(holds(red('?c'))), holds(at('?c', l1))])) holds if all red cars are at l1.
*/

:- meta_predicate holds(:).

%!  holds(:Formula) is semidet.
%
%   True where the formula holds in the state that is current in the module that asks.

holds(Module:Formula) :-
    holds(Module, Formula).

%!  holds(+Module, +Formula) is semidet.
%
%   True where the formula holds in the state that is current in the module. Throws a domain error for a term of
%   another shape.

holds(Module, Formula) :-
    must_be(ground, Formula),
    goal(Formula, [], Goal),
    must_be_tests(Goal, Module),
    \+ \+ Module:Goal.

%   A problem is data: what it names is asked of the domain's own predicates.

must_be_tests(Goal, Module) :-
    (   ( Goal = (A, B) ; Goal = (A ; B) )
    ->  must_be_tests(A, Module),
        must_be_tests(B, Module)
    ;   Goal = (\+ A)
    ->  must_be_tests(A, Module)
    ;   must_be_test(Goal, Module)
    ).

%!  must_be_test(+Goal, +Module) is det.
%
%   @throws nppg_refused(Indicator, Why) where it calls what may do more than look at the state

must_be_test(Goal, Module) :-
    (   ( nppg_goals:own(Module, Goal) ; looks(Goal) ; \+ nppg_goals:there(Module, Goal) )
    ->  true
    ;   functor(Goal, Name, Arity),
        throw(nppg_refused(Name/Arity, ''))
    ).

looks(Goal) :-
    nppg_allowed:kind(Goal, Kind),
    memberchk(Kind, [pure, special(arithmetic), special(digits)]).

%!  goal(+Formula, +Variables, -Goal) is det.
%
%   The goal with variables of Prolog in place of the formula's, whose names Variables pairs with them.

goal(holds(Fact), Variables, Goal) :-
    !,
    fact(Fact, Variables, Goal).
goal(not(Formula), Variables, \+ Goal) :-
    !,
    goal(Formula, Variables, Goal).
goal(and(Formulas), Variables, Goal) :-
    is_list(Formulas),
    !,
    goals(Formulas, Variables, Goal).
goal(or(Formulas), Variables, Goal) :-
    is_list(Formulas),
    !,
    foldl(alternative(Variables), Formulas, fail, Goal).
goal(forall(Typed, Formula), Variables, \+ Goal) :-
    !,
    goal(exists(Typed, not(Formula)), Variables, Goal).
goal(exists(Typed, Formula), Variables0, ( Generators, Types, Tests )) :-
    is_list(Typed),
    !,
    foldl(typed, Typed, TypeGoals, Variables0, Variables),
    conjuncts(Formula, Conjuncts),
    partition(is_fact, Conjuncts, Facts, Others),
    goals(Facts, Variables, Generators),
    conjunction(TypeGoals, Types),
    goals(Others, Variables, Tests).
goal(eq(A, B), Variables, C == D) :-
    !,
    maplist(value(Variables), [A, B], [C, D]).
goal(compare(Operator, Left, Right), Variables, Goal) :-
    memberchk(Operator, [<, =<, =:=, >=, >]),
    !,
    number(Left, Variables, X, Goals, More),
    number(Right, Variables, Y, More, [Comparison]),
    Comparison =.. [Operator, X, Y],
    conjunction(Goals, Goal).
goal(Formula, _, _) :-
    domain_error(formula, Formula).

goals(Formulas, Variables, Goal) :-
    maplist(goal_of(Variables), Formulas, Goals),
    conjunction(Goals, Goal).

goal_of(Variables, Formula, Goal) :-
    goal(Formula, Variables, Goal).

conjunction([], true).
conjunction([Goal|Goals], All) :-
    (   Goals == []
    ->  All = Goal
    ;   All = ( Goal, Others ),
        conjunction(Goals, Others)
    ).

alternative(Variables, Formula, Others, ( Goal ; Others )) :-
    goal(Formula, Variables, Goal).

%   A name that is bound twice means the inner variable.

typed(Name-Types, Goal, Variables, [Name-Var|Variables]) :-
    (   is_list(Types)
    ->  foldl(type_alternative(Var), Types, fail, Goal)
    ;   Goal =.. [Types, Var]
    ).

type_alternative(Var, Type, Others, ( Goal ; Others )) :-
    Goal =.. [Type, Var].

%   What must all hold. Facts among it come first, since they have fewer answers than types have values.

conjuncts(and(Formulas), Conjuncts) :-
    !,
    maplist(conjuncts, Formulas, Lists),
    append(Lists, Conjuncts).
conjuncts(not(or(Formulas)), Conjuncts) :-
    !,
    findall(not(Formula), member(Formula, Formulas), Negated),
    conjuncts(and(Negated), Conjuncts).
conjuncts(not(not(Formula)), Conjuncts) :-
    !,
    conjuncts(Formula, Conjuncts).
conjuncts(Formula, [Formula]).

is_fact(holds(_)).

fact(Fact, Variables, Goal) :-
    callable(Fact),
    !,
    Fact =.. [Name|Args],
    maplist(value(Variables), Args, Values),
    Goal =.. [Name|Values].
fact(Fact, _, _) :-
    domain_error(fact, Fact).

value(Variables, Term, Value) :-
    (   memberchk(Term-Found, Variables)
    ->  Value = Found
    ;   Value = Term
    ).

%   number(+Expression, +Variables, -Arithmetic, -Goals, ?Rest): the goals look up what the arithmetic needs.

number(Number, _, Number, Goals, Goals) :-
    number(Number),
    !.
number(value(Function), Variables, Value, [Goal|Goals], Goals) :-
    !,
    fact(Function, Variables, Fact),
    Fact =.. List0,
    append(List0, [Value], List),
    Goal =.. List.
number(Expression, Variables, Arithmetic, Goals, Rest) :-
    compound(Expression),
    Expression =.. [Operator|Operands],
    memberchk(Operator, [+, -, *, /]),
    !,
    foldl(operand(Variables), Operands, Values, Goals, Rest),
    Arithmetic =.. [Operator|Values].
number(Expression, _, _, _, _) :-
    domain_error(expression, Expression).

operand(Variables, Operand, Value, Goals, Rest) :-
    number(Operand, Variables, Value, Goals, Rest).
