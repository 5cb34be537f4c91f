% SHA-256 of what follows: bc6878791d08f0251d33e79502001cda82daf7715ab92e6ead48dcc1939cf1b3
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
model(domain, 'childsnack.pl').
model(domain_sha256, bf55754b14bc9cd031fbcdeda319012ad5f789af7b9b8445ecd40caad3371f0a).
model(action, make_sandwich_no_gluten(sandwich, bread_portion, content_portion)).
model(action, make_sandwich(sandwich, bread_portion, content_portion)).
model(action, put_on_tray(sandwich, tray)).
model(action, serve_sandwich_no_gluten(sandwich, child, tray, place)).
model(action, serve_sandwich(sandwich, child, tray, place)).
model(action, move_tray(tray, place, place)).
model(literal, todo_served(child)).
model(literal, goal_served(child)).
model(literal, done_served(child)).
model(literal, at_kitchen_bread(bread_portion)).
model(literal, at_kitchen_content(content_portion)).
model(literal, at_kitchen_sandwich(sandwich)).
model(literal, ontray(sandwich, tray)).
model(literal, no_gluten_sandwich(sandwich)).
model(literal, served(child)).
model(literal, at(tray, place)).
model(literal, notexist(sandwich)).
model(literal, no_gluten_bread(bread_portion)).
model(literal, no_gluten_content(content_portion)).
model(literal, allergic_gluten(child)).
model(literal, not_allergic_gluten(child)).
model(literal, waiting(child, place)).
model(literal, needed_at_to_serve_sandwich_no_gluten(place)).
model(literal, could_put_on_tray(tray, place)).
model(literal, could_serve_sandwich_no_gluten(tray, place)).
model(literal, could_serve_sandwich(tray, place)).
model(literal, fewer_ontray_1_than_todo_served).
model(literal, fewer_ontray_1_than_allergic_gluten).
model(literal, fewer_ontray_1_than_todo_served_allergic_gluten).
model(literal, fewer_no_gluten_sandwich_than_todo_served).
model(literal, fewer_no_gluten_sandwich_than_allergic_gluten).
model(literal, fewer_no_gluten_sandwich_than_todo_served_allergic_gluten).
model(literal, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten).
model(literal, fewer_ontray_2_than_todo_served).
model(literal, fewer_ontray_2_than_allergic_gluten).
model(literal, fewer_at_1_than_todo_served).
model(literal, fewer_at_1_than_allergic_gluten).
model(literal, fewer_at_1_than_todo_served_allergic_gluten).
model(literal, fewer_at_2_than_todo_served).
model(literal, fewer_at_2_than_allergic_gluten).
model(literal, fewer_at_2_than_todo_served_allergic_gluten).
model(literal, fewer_ontray_1_than_not_allergic_gluten).
model(literal, fewer_ontray_1_than_todo_served_not_allergic_gluten).
model(literal, fewer_ontray_2_than_not_allergic_gluten).
model(literal, fewer_ontray_2_than_todo_served_not_allergic_gluten).
model(literal, fewer_at_1_than_not_allergic_gluten).
model(literal, fewer_at_1_than_todo_served_not_allergic_gluten).
model(literal, fewer_at_2_than_todo_served_not_allergic_gluten).
model(bias, 'childsnack.yaml').
model(bias_sha256, '9507e056c4f8f025e8780ee01ae5e5fa1a27f9a656e2c0759005f192bf14dc54').
model(success, 1.0).
model(starts, 98).
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

domain(childsnack).
:- ensure_loaded('childsnack.pl').
:- add_import_module(policy, childsnack, start).

% tree 1: distilled, 7 rules
delta(1, make_sandwich_no_gluten(_, _, _), 40.0) :- !.
delta(1, move_tray(_, _, _), 0.0) :- fewer_ontray_1_than_todo_served, !.
delta(1, serve_sandwich_no_gluten(_, Child, _, _), 40.0) :- todo_served(Child), !.
delta(1, move_tray(Tray, _, Place), 30.0) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(1, serve_sandwich(_, Child, _, _), 20.0) :- todo_served(Child), !.
delta(1, serve_sandwich(_, _, _, _), 0.0) :- !.
delta(1, _, 10.0).
