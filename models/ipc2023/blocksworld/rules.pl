% SHA-256 of what follows: cd05d3600a7b3b0f501cbec3f34421cff11a623a0c9be60baad86c31d814cb79
% A policy learned by nppg: the potential of an action is the sum of its delta/3, one per tree.
% In plain Prolog, in the folder of this file and its domain:  swipl model.pl
%     ?- state([...]), best_action(Action).

:- module(policy,
          [ state/1,
            potential/2,
            best_action/1,
            delta/3
          ]).
model(format, 1).
model(nppg, '0.1.0').
model(prolog, '9.2.9').
model(domain, 'blocksworld.pl').
model(domain_sha256, '935d4b2b1e03a47ebf490a3cafb51e4cd0260e7fb04b663517860c889ed85a84').
model(action, pickup(object)).
model(action, putdown(object)).
model(action, stack(object, object)).
model(action, unstack(object, object)).
model(literal, todo_clear(object)).
model(literal, goal_clear(object)).
model(literal, done_clear(object)).
model(literal, todo_on_table(object)).
model(literal, goal_on_table(object)).
model(literal, done_on_table(object)).
model(literal, todo_on(object, object)).
model(literal, goal_on(object, object)).
model(literal, done_on(object, object)).
model(literal, clear(object)).
model(literal, on_table(object)).
model(literal, arm_empty).
model(literal, holding(object)).
model(literal, on(object, object)).
model(literal, unsettled_on(object)).
model(literal, unsettled_on_todo_clear(object)).
model(literal, unsettled_on_todo_on_table(object)).
model(literal, unsettled_on_todo_on(object)).
model(literal, unsettled_before_on(object)).
model(literal, unsettled_before_on_todo_clear(object)).
model(literal, unsettled_before_on_todo_on_table(object)).
model(literal, unsettled_before_on_todo_on(object)).
model(literal, beyond_goal_on(object, object)).
model(literal, beyond_on(object, object)).
model(literal, needed_holding_to_putdown(object)).
model(literal, needed_on_to_unstack(object)).
model(literal, needed_clear_to_stack(object)).
model(literal, needed_on_table_to_pickup_to_putdown(object)).
model(literal, needed_on_to_unstack_to_putdown(object)).
model(literal, needed_holding_to_putdown_to_stack(object)).
model(literal, wanted_clear(object)).
model(literal, could_pickup(object)).
model(literal, could_pickup_needed_holding_to_putdown(object)).
model(literal, could_pickup_needed_holding_to_putdown_to_stack(object)).
model(literal, could_pickup_for_todo_on_any_object(object)).
model(literal, could_pickup_for_todo_on_object_any(object)).
model(literal, could_stack_todo_on(object)).
model(literal, could_stack_for_todo_clear_object(object)).
model(literal, could_stack_for_todo_on_table_object_2(object)).
model(literal, could_stack_for_todo_on_any_object_2(object)).
model(literal, could_stack_for_todo_on_object_any_2(object)).
model(literal, could_stack_for_todo_on_object_object(object)).
model(literal, could_unstack(object)).
model(literal, could_unstack_todo_clear(object)).
model(literal, could_unstack_needed_holding_to_putdown(object)).
model(literal, could_unstack_needed_clear_to_stack(object)).
model(literal, could_unstack_needed_holding_to_putdown_to_stack(object)).
model(literal, could_unstack_for_todo_on_table_object(object)).
model(literal, could_unstack_for_todo_on_table_object_2(object)).
model(literal, could_unstack_for_todo_on_any_object(object)).
model(literal, could_unstack_for_todo_on_object_any(object)).
model(literal, could_unstack_for_todo_on_object_any_2(object)).
model(literal, could_unstack_for_todo_on_object_object_2(object)).
model(literal, fewer_clear_than_todo_clear).
model(literal, fewer_clear_than_on_2).
model(literal, fewer_clear_than_todo_clear_on_2).
model(literal, fewer_on_1_than_todo_clear).
model(literal, fewer_clear_on_1_than_todo_clear).
model(literal, fewer_clear_on_1_than_on_2).
model(literal, fewer_clear_on_1_than_todo_clear_on_2).
model(bias, 'blocksworld.yaml').
model(bias_sha256, '785696b26dbec54450904f8a258a448a295ec2867580d793ee51ea1d8d1885c3').
model(success, 1.0).
model(starts, 99).
model(exact, 0).
model(trees, 1).

% Lets plain Prolog load the domain: what its declarations mean.
:- op(1150, fx, user:[fluent, static, interchangeable]).
:- multifile user:term_expansion/2.
:- dynamic user:term_expansion/2.
:- dynamic delta/3.
user:term_expansion((:- fluent(Specs)), [(:- dynamic(Specs)), (:- discontiguous(fluents/1)), fluents(Specs)]).
user:term_expansion((:- static(Specs)), Clauses) :- user:term_expansion((:- fluent(Specs)), Clauses).
user:term_expansion((:- dead_ends), []).
user:term_expansion((:- pddl(_)), []).
user:term_expansion((:- parameter(Name, Default)), [(:- discontiguous(parameter/2)), parameter(Name, Value)]) :-
    ( policy:model(parameter, Name=Given) -> Value = Given ; Value = Default ).
user:term_expansion((:- uniform_start), []).
user:term_expansion((:- interchangeable(_)), []).
user:term_expansion((:- environment(_)), []).

% state(Facts) makes a state current; potential(Action, Potential) is about its legal actions, best_action(Action) about
% one of the highest potential.
state(Facts) :-
    domain(Module),
    forall(member(Fact, Facts), must_be_fact(Module, Fact)),
    forall(( Module:fluents(Specs), fluent_head(Specs, Head) ), retractall(Module:Head)),
    forall(member(Fact, Facts), assertz(Module:Fact)).
must_be_fact(Module, Fact) :-
    (   ground(Fact), Module:fluents(Specs), fluent_head(Specs, Head), Fact = Head
    ->  true
    ;   throw(error(domain_error(fact_of_a_fluent, Fact), _))
    ).
fluent_head((Specs, More), Head) :- !, ( fluent_head(Specs, Head) ; fluent_head(More, Head) ).
fluent_head(Specs, Head) :- is_list(Specs), !, member(Spec, Specs), fluent_head(Spec, Head).
fluent_head(Name/Arity, Head) :- functor(Head, Name, Arity).
potential(Action, Potential) :-
    domain(Module),
    model(trees, Last),
    setof(Legal, Module:action(Legal), Actions),
    member(Action, Actions),
    aggregate_all(sum(Value), ( between(1, Last, Tree), once(delta(Tree, Action, Value)) ), Potential).
best_action(Action) :-
    aggregate_all(max(Potential, Legal), potential(Legal, Potential), max(_, Action)).

domain(blocksworld).
:- ensure_loaded('blocksworld.pl').
:- add_import_module(policy, blocksworld, start).

% tree 1: distilled, 8 rules
delta(1, pickup(Object), 0.0) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(1, pickup(Object), 20.0) :- todo_on(Object, Object2), clear(Object2), !.
delta(1, putdown(Object), 20.0) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(1, putdown(Object), 0.0) :- todo_on(Object, Object2), clear(Object2), !.
delta(1, putdown(_), 20.0) :- !.
delta(1, stack(Object, Object2), 10.0) :- todo_on(Object, Object2), !.
delta(1, unstack(_, Object), 10.0) :- on(Object2, Object), unsettled_on(Object2), !.
delta(1, _, 0.0).
