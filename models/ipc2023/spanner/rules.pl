% SHA-256 of what follows: 836603401e9d42b9a17306eb1ed241aff017b7cc4931342e320ebcb41623f066
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
model(domain, 'spanner.pl').
model(domain_sha256, '8230f60f960876d2b45a4926c3ab638c6f9dc4dd4f2859eeb8d76d3cc03af8a8').
model(action, walk(location, location, man)).
model(action, pickup_spanner(location, spanner, man)).
model(action, tighten_nut(location, spanner, man, nut)).
model(literal, todo_tightened(nut)).
model(literal, goal_tightened(nut)).
model(literal, done_tightened(nut)).
model(literal, at(locatable, location)).
model(literal, carrying(man, spanner)).
model(literal, usable(spanner)).
model(literal, tightened(nut)).
model(literal, loose(nut)).
model(literal, link(location, location)).
model(literal, man(locatable)).
model(literal, nut(locatable)).
model(literal, spanner(locatable)).
model(literal, beyond_link(location, location)).
model(literal, nearer_at(location, location, location)).
model(literal, could_pickup_spanner(man, location)).
model(literal, toward_could_pickup_spanner(man, location, location)).
model(literal, could_tighten_nut(man, location)).
model(literal, toward_could_tighten_nut(man, location, location)).
model(literal, fewer_at_2_than_todo_tightened).
model(literal, fewer_at_2_than_at_1).
model(literal, fewer_carrying_2_than_todo_tightened).
model(literal, fewer_carrying_2_than_at_1).
model(literal, fewer_usable_than_at_1).
model(literal, fewer_carrying_2_usable_than_todo_tightened).
model(literal, fewer_carrying_2_usable_than_at_1).
model(literal, fewer_carrying_1_than_todo_tightened).
model(bias, 'spanner.yaml').
model(bias_sha256, '4207ea2a831ef2cabab3e19f1bd96bc1c01e504480c1c8612173c11ec6f02b85').
model(success, 1.0).
model(starts, 89).
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

domain(spanner).
:- ensure_loaded('spanner.pl').
:- add_import_module(policy, spanner, start).

% tree 1: distilled, 3 rules
delta(1, walk(_, _, _), 10.0) :- !.
delta(1, _, 20.0) :- fewer_carrying_2_than_todo_tightened, !.
delta(1, _, 0.0).
