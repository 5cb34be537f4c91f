:- module(blocksworld, []).

% The PDDL domain blocksworld. What no action changes is static: it belongs to the problem. So do its goals:
% goal_clear(X) says that clear(X) is wanted, condition/1 has what is wanted beyond such facts, and goals/1 says how
% many literals that is in all.

:- pddl('domain.pddl').
:- static object/1, goal_clear/1, goal_on_table/1, goal_on/2, goals/1, condition/1.
:- fluent clear/1, on_table/1, arm_empty/0, holding/1, on/2.
:- dead_ends.
:- discontiguous action/1, effect/3.

% pickup
action(pickup(Ob)) :- arm_empty, clear(Ob), on_table(Ob).
effect(pickup(Ob), [clear(Ob), on_table(Ob), arm_empty], [holding(Ob)]).

% putdown
action(putdown(Ob)) :- holding(Ob).
effect(putdown(Ob), [holding(Ob)], [clear(Ob), arm_empty, on_table(Ob)]).

% stack
action(stack(Ob, Underob)) :- holding(Ob), clear(Underob).
effect(stack(Ob, Underob), [clear(Underob), holding(Ob)], [arm_empty, clear(Ob), on(Ob, Underob)]).

% unstack
action(unstack(Ob, Underob)) :- arm_empty, clear(Ob), on(Ob, Underob).
effect(unstack(Ob, Underob), [on(Ob, Underob), clear(Ob), arm_empty], [holding(Ob), clear(Underob)]).

goal :-
    \+ ( goal_clear(X), \+ clear(X) ),
    \+ ( goal_on_table(X), \+ on_table(X) ),
    \+ ( goal_on(X, Y), \+ on(X, Y) ),
    \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_clear(X) :- goal_clear(X), \+ clear(X).
done_clear(X) :- goal_clear(X), clear(X).
todo_on_table(X) :- goal_on_table(X), \+ on_table(X).
done_on_table(X) :- goal_on_table(X), on_table(X).
todo_on(X, Y) :- goal_on(X, Y), \+ on(X, Y).
done_on(X, Y) :- goal_on(X, Y), on(X, Y).

% derived from the types and the actions
:- table unsettled_on/1.
unsettled_on(X) :- todo_clear(X).
unsettled_on(X) :- todo_on_table(X).
unsettled_on(X) :- todo_on(X, _Object).
unsettled_on(X) :- on(X, Y), unsettled_on(Y).
:- table unsettled_on_todo_clear/1.
unsettled_on_todo_clear(X) :- todo_clear(X).
unsettled_on_todo_clear(X) :- on(X, Y), unsettled_on_todo_clear(Y).
:- table unsettled_on_todo_on_table/1.
unsettled_on_todo_on_table(X) :- todo_on_table(X).
unsettled_on_todo_on_table(X) :- on(X, Y), unsettled_on_todo_on_table(Y).
:- table unsettled_on_todo_on/1.
unsettled_on_todo_on(X) :- todo_on(X, _Object).
unsettled_on_todo_on(X) :- on(X, Y), unsettled_on_todo_on(Y).
:- table unsettled_before_on/1.
unsettled_before_on(X) :- todo_clear(X).
unsettled_before_on(X) :- todo_on_table(X).
unsettled_before_on(X) :- todo_on(X, _Object).
unsettled_before_on(X) :- on(Y, X), unsettled_before_on(Y).
:- table unsettled_before_on_todo_clear/1.
unsettled_before_on_todo_clear(X) :- todo_clear(X).
unsettled_before_on_todo_clear(X) :- on(Y, X), unsettled_before_on_todo_clear(Y).
:- table unsettled_before_on_todo_on_table/1.
unsettled_before_on_todo_on_table(X) :- todo_on_table(X).
unsettled_before_on_todo_on_table(X) :- on(Y, X), unsettled_before_on_todo_on_table(Y).
:- table unsettled_before_on_todo_on/1.
unsettled_before_on_todo_on(X) :- todo_on(X, _Object).
unsettled_before_on_todo_on(X) :- on(Y, X), unsettled_before_on_todo_on(Y).
:- table beyond_goal_on/2.
beyond_goal_on(X, Y) :- goal_on(X, Y).
beyond_goal_on(X, Y) :- beyond_goal_on(X, Z), goal_on(Z, Y).
:- table beyond_on/2.
beyond_on(X, Y) :- on(X, Y).
beyond_on(X, Y) :- beyond_on(X, Z), on(Z, Y).
needed_holding_to_putdown(Object) :- todo_clear(Object), \+ holding(Object).
needed_on_to_unstack(Object) :- todo_clear(Object), \+ on(_Object2, Object).
needed_clear_to_stack(Object) :- todo_on(_Object2, Object), \+ clear(Object).
needed_on_table_to_pickup_to_putdown(Object) :- needed_holding_to_putdown(Object), \+ on_table(Object).
needed_on_to_unstack_to_putdown(Object) :- needed_holding_to_putdown(Object), \+ on(Object, _Object2).
needed_holding_to_putdown_to_stack(Object) :- needed_clear_to_stack(Object), \+ holding(Object).
wanted_clear(Z) :- todo_clear(Z).
could_pickup(Object) :- on_table(Object), \+ holding(Object), arm_empty.
could_pickup_needed_holding_to_putdown(Object) :- needed_holding_to_putdown(Object), on_table(Object), arm_empty.
could_pickup_needed_holding_to_putdown_to_stack(Object) :-
    needed_holding_to_putdown_to_stack(Object),
    on_table(Object),
    arm_empty.
could_pickup_for_todo_on_any_object(Object) :-
    arm_empty,
    on_table(Object),
    \+ holding(Object),
    once(todo_on(_Object2, Object)).
could_pickup_for_todo_on_object_any(Object) :-
    arm_empty,
    on_table(Object),
    \+ holding(Object),
    once(todo_on(Object, _Object2)).
could_stack_todo_on(Object) :- todo_on(Object2, Object), holding(Object2).
could_stack_for_todo_clear_object(Object) :- \+ arm_empty, todo_clear(Object), once(holding(_Object2)).
could_stack_for_todo_on_table_object_2(Object) :- \+ arm_empty, todo_on_table(Object), once(holding(_Object2)).
could_stack_for_todo_on_any_object_2(Object) :- \+ arm_empty, once(holding(_Object2)), todo_on(_Object3, Object).
could_stack_for_todo_on_object_any_2(Object) :- \+ arm_empty, once(holding(_Object2)), todo_on(Object, _Object3).
could_stack_for_todo_on_object_object(Object) :- \+ arm_empty, todo_on(Object, Object2), holding(Object2).
could_unstack(Object) :- arm_empty, on(Object, _Object2), \+ holding(Object).
could_unstack_todo_clear(Object) :- arm_empty, on(Object, Object2), todo_clear(Object2).
could_unstack_needed_holding_to_putdown(Object) :-
    arm_empty,
    needed_holding_to_putdown(Object),
    once(on(Object, _Object2)).
could_unstack_needed_clear_to_stack(Object) :- arm_empty, on(Object, Object2), needed_clear_to_stack(Object2).
could_unstack_needed_holding_to_putdown_to_stack(Object) :-
    arm_empty,
    needed_holding_to_putdown_to_stack(Object),
    once(on(Object, _Object2)).
could_unstack_for_todo_on_table_object(Object) :-
    arm_empty,
    todo_on_table(Object),
    \+ holding(Object),
    once(on(Object, _Object2)).
could_unstack_for_todo_on_table_object_2(Object) :-
    arm_empty,
    on(Object, Object2),
    \+ holding(Object),
    todo_on_table(Object2).
could_unstack_for_todo_on_any_object(Object) :-
    arm_empty,
    todo_on(_Object2, Object),
    \+ holding(Object),
    once(on(Object, _Object3)).
could_unstack_for_todo_on_object_any(Object) :-
    arm_empty,
    todo_on(Object, _Object2),
    \+ holding(Object),
    once(on(Object, _Object3)).
could_unstack_for_todo_on_object_any_2(Object) :-
    arm_empty,
    on(Object, Object2),
    \+ holding(Object),
    once(todo_on(Object2, _Object3)).
could_unstack_for_todo_on_object_object_2(Object) :-
    arm_empty,
    todo_on(Object2, Object),
    \+ holding(Object),
    on(Object, Object2).
:- table number_clear/1.
number_clear(N) :- findall(X, clear(X), Found), sort(Found, Set), length(Set, N).
:- table number_todo_clear/1.
number_todo_clear(N) :- findall(X, todo_clear(X), Found), sort(Found, Set), length(Set, N).
fewer_clear_than_todo_clear :- number_clear(N), number_todo_clear(M), N < M.
:- table number_on_2/1.
number_on_2(N) :- findall(X, on(_Object, X), Found), sort(Found, Set), length(Set, N).
fewer_clear_than_on_2 :- number_clear(N), number_on_2(M), N < M.
both_todo_clear_on_2(X) :- todo_clear(X), on(_Object, X).
:- table number_todo_clear_on_2/1.
number_todo_clear_on_2(N) :- findall(X, both_todo_clear_on_2(X), Found), sort(Found, Set), length(Set, N).
fewer_clear_than_todo_clear_on_2 :- number_clear(N), number_todo_clear_on_2(M), N < M.
:- table number_on_1/1.
number_on_1(N) :- findall(X, on(X, _Object), Found), sort(Found, Set), length(Set, N).
fewer_on_1_than_todo_clear :- number_on_1(N), number_todo_clear(M), N < M.
both_clear_on_1(X) :- clear(X), on(X, _Object).
:- table number_clear_on_1/1.
number_clear_on_1(N) :- findall(X, both_clear_on_1(X), Found), sort(Found, Set), length(Set, N).
fewer_clear_on_1_than_todo_clear :- number_clear_on_1(N), number_todo_clear(M), N < M.
fewer_clear_on_1_than_on_2 :- number_clear_on_1(N), number_on_2(M), N < M.
fewer_clear_on_1_than_todo_clear_on_2 :- number_clear_on_1(N), number_todo_clear_on_2(M), N < M.
