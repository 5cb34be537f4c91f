:- module(nppg_call_graph,
          [ static_predicate/2   % +Module, +Indicator                        semidet
          ]).

:- use_module(library(lists), [append/3, member/2, memberchk/2]).
:- use_module(library(occurs), [sub_term/2]).

/** <module> What a predicate can depend on

A predicate of a domain depends on the fluents that its clauses call, and that those do which they call. Where that
cannot be told from the program, it may be every fluent: a goal that is made while it runs, a predicate that looks at
more than its arguments.
*/

%!  static_predicate(+Module, +Indicator) is semidet.
%
%   Succeeds where no answer of Name/Arity can depend on a fluent.

static_predicate(Module, Name/Arity) :-
    functor(Goal, Name, Arity),
    reach(Goal, Module, [], _).

declared(Module, Kind, Indicator) :-
    current_predicate(Module:Kind/1),
    call(Module:Kind, Indicator),
    !.

%   reach(+Goal, +Module, +Reached0, -Reached): the domain's predicates that calling a goal reaches; fails where a fluent is
%   among them, or may be.

reach(Goal, _, _, _) :-
    var(Goal),
    !,
    fail.
reach(Module:Goal, Module, Reached0, Reached) :-
    !,
    reach(Goal, Module, Reached0, Reached).
reach(Goal, Module, Reached0, Reached) :-
    functor(Goal, Name, Arity),
    (   memberchk(Name/Arity, Reached0)
    ->  Reached = Reached0
    ;   declared(Module, nppg_fluent, Name/Arity)
    ->  fail
    ;   declared(Module, nppg_static, Name/Arity)
    ->  Reached = [Name/Arity|Reached0]
    ;   predicate_property(Module:Goal, imported_from(_))
    ->  known(Name/Arity),
        \+ ( sub_term(Part, Goal), nonvar(Part), unsettled(Part) ),
        reach_arguments(Goal, Module, Reached0, Reached)
    ;   predicate_property(Module:Goal, defined),
        \+ predicate_property(Module:Goal, dynamic),
        functor(Head, Name, Arity),
        findall(Body, clause(Module:Head, Body), Bodies),
        reach_all(Bodies, Module, [Name/Arity|Reached0], Reached)
    ).

reach_all([], _, Reached, Reached).
reach_all([Goal|Goals], Module, Reached0, Reached) :-
    reach(Goal, Module, Reached0, Reached1),
    reach_all(Goals, Module, Reached1, Reached).

%   The goals among the arguments of a predicate that calls them.

reach_arguments(Goal, Module, Reached0, Reached) :-
    (   predicate_property(Module:Goal, meta_predicate(Spec))
    ->  findall(Called, called(Goal, Spec, Called), All),
        reach_all(All, Module, Reached0, Reached)
    ;   Reached = Reached0
    ).

called(Goal, Spec, Called) :-
    arg(I, Spec, Kind),
    arg(I, Goal, Argument),
    (   Kind == (^)
    ->  unquantified(Argument, Called)
    ;   integer(Kind),
        longer(Kind, Argument, Called)
    ).

unquantified(Argument, Goal) :-
    (   nonvar(Argument), Argument = _^Rest
    ->  unquantified(Rest, Goal)
    ;   Goal = Argument
    ).

longer(Count, Goal0, Goal) :-
    (   ( var(Goal0) ; Count =:= 0 )
    ->  Goal = Goal0
    ;   Goal0 =.. List0,
        length(More, Count),
        append(List0, More, List),
        Goal =.. List
    ).

%   Predicates of Prolog and its library that look at nothing but their arguments, and arithmetic that does not.

known(Indicator) :-
    memberchk(Indicator,
              [ true/0, fail/0, false/0, !/0, (',')/2, (;)/2, (->)/2, (*->)/2, (\+)/1, not/1, once/1, ignore/1, call/1,
                call/2, call/3, call/4, call/5, forall/2, findall/3, findall/4, bagof/3, setof/3, aggregate_all/3,
                aggregate_all/4, foldl/4, foldl/5, foldl/6, maplist/2, maplist/3, maplist/4, include/3, exclude/3,
                partition/4, predsort/3, (=)/2, (\=)/2, (==)/2, (\==)/2, (@<)/2, (@>)/2, (@=<)/2, (@>=)/2, compare/3,
                (is)/2, (=:=)/2, (=\=)/2, (<)/2, (>)/2, (=<)/2, (>=)/2, var/1, nonvar/1, atom/1, number/1, integer/1,
                float/1, atomic/1, compound/1, callable/1, is_list/1, ground/1, functor/3, arg/3, (=..)/2, copy_term/2,
                length/2, atom_length/2, atom_concat/3, sub_atom/5, atom_chars/2, atom_codes/2, atom_number/2,
                number_codes/2, char_code/2, atomic_list_concat/2, atomic_list_concat/3, sort/2, sort/4, msort/2,
                keysort/2, between/3, succ/2, plus/3, term_variables/2, member/2, memberchk/2, append/2, append/3,
                select/3, selectchk/3, subtract/3, permutation/2, nth0/3, nth1/3, last/2, reverse/2, delete/3,
                sum_list/2, sumlist/2, max_list/2, min_list/2, max_member/2, min_member/2, numlist/3,
                list_to_set/2, intersection/3, union/3, subset/2, pairs_keys/2, pairs_values/2, pairs_keys_values/3,
                list_to_ord_set/2, ord_memberchk/2, ord_subtract/3, ord_union/3, ord_intersection/3, ord_subset/2,
                ord_del_element/3, ord_add_element/3, list_to_assoc/2, get_assoc/3, put_assoc/4
              ]).

unsettled(Part) :-
    memberchk(Part, [random, random_float, cputime, realtime, random(_), random_float(_)]).
