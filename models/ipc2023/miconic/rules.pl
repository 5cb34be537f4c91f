% SHA-256 of what follows: 1d9b4b1e2d35bcb033361c094888b3d8a559e3e05f96ed65a30b4ddc2a6a1ee9
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
model(domain, 'miconic.pl').
model(domain_sha256, '10cca4ae2843dc69694dac3826b36a6dfbd7f2cd8c28dd3726b53415579622c2').
model(action, board(floor, passenger)).
model(action, depart(floor, passenger)).
model(action, up(floor, floor)).
model(action, down(floor, floor)).
model(literal, todo_served(passenger)).
model(literal, goal_served(passenger)).
model(literal, done_served(passenger)).
model(literal, origin(passenger, floor)).
model(literal, boarded(passenger)).
model(literal, served(passenger)).
model(literal, lift_at(floor)).
model(literal, destin(passenger, floor)).
model(literal, above(floor, floor)).
model(literal, beyond_above(floor, floor)).
model(literal, needed_lift_at_to_depart(floor)).
model(literal, needed_boarded_to_depart(passenger)).
model(literal, could_board(floor)).
model(literal, toward_could_board(floor, floor)).
model(literal, could_board_through_destin_back_for_todo_served_1_floor(floor)).
model(literal, toward_could_board_through_destin_back_for_todo_served_1_floor(floor, floor)).
model(literal, could_depart(floor)).
model(literal, toward_could_depart(floor, floor)).
model(literal, fewer_lift_at_than_todo_served).
model(literal, fewer_lift_at_than_boarded).
model(bias, 'miconic.yaml').
model(bias_sha256, '25d0d1154d4b93c693382491eb76f3e4f418fffcbdee60dfc0b0150d12dd06c6').
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

domain(miconic).
:- ensure_loaded('miconic.pl').
:- add_import_module(policy, miconic, start).

% tree 1: distilled, 7 rules
delta(1, board(_, _), 30.0) :- !.
delta(1, depart(_, _), 30.0) :- !.
delta(1, up(_, Floor), 20.0) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(1, up(_, Floor), 10.0) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(1, down(_, Floor), 20.0) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(1, down(_, Floor), 10.0) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(1, _, 0.0).
