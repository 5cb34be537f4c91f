% SHA-256 of what follows: 19d098b32c4f8d6f0fc398dbb404afeed15a2c5784edd032bc7f9875c49cbb11
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
model(domain, 'floortile.pl').
model(domain_sha256, '877352c69fbf91cfe54d59c05deaf658612bb6387de8271d4c34debed91583d0').
model(action, change_color(robot, color, color)).
model(action, paint_up(robot, tile, tile, color)).
model(action, paint_down(robot, tile, tile, color)).
model(action, move_up(robot, tile, tile)).
model(action, move_down(robot, tile, tile)).
model(action, move_right(robot, tile, tile)).
model(action, move_left(robot, tile, tile)).
model(literal, todo_painted(tile, color)).
model(literal, goal_painted(tile, color)).
model(literal, done_painted(tile, color)).
model(literal, robot_at(robot, tile)).
model(literal, clear(tile)).
model(literal, painted(tile, color)).
model(literal, robot_has(robot, color)).
model(literal, up(tile, tile)).
model(literal, down(tile, tile)).
model(literal, right(tile, tile)).
model(literal, left(tile, tile)).
model(literal, available_color(color)).
model(literal, free_color(robot)).
model(literal, unsettled_up_todo_painted(tile)).
model(literal, unsettled_before_up_todo_painted(tile)).
model(literal, unsettled_right_todo_painted(tile)).
model(literal, unsettled_before_right_todo_painted(tile)).
model(literal, beyond_up(tile, tile)).
model(literal, beyond_down(tile, tile)).
model(literal, beyond_right(tile, tile)).
model(literal, beyond_left(tile, tile)).
model(literal, needed_robot_has_to_paint_up(color)).
model(literal, needed_robot_at_to_paint_up(tile)).
model(literal, needed_clear_to_paint_up(tile)).
model(literal, needed_robot_at_to_paint_down(tile)).
model(literal, needed_clear_to_move_up_to_paint_up(tile)).
model(literal, needed_robot_at_to_move_up_to_paint_up(tile)).
model(literal, needed_clear_to_move_up_to_paint_down(tile)).
model(literal, could_paint_up(robot, color)).
model(literal, could_paint_up_todo_painted(robot, color)).
model(literal, could_paint_up_for_todo_painted_any_color(robot, color)).
model(literal, could_paint_up_for_todo_painted_tile_any_2(robot, color)).
model(literal, could_paint_up_for_todo_painted_tile_color(robot, color)).
model(literal, could_paint_down(robot, color)).
model(literal, could_paint_down_todo_painted(robot, color)).
model(literal, could_paint_down_for_todo_painted_any_color(robot, color)).
model(literal, could_paint_down_for_todo_painted_tile_any(robot, color)).
model(literal, could_paint_down_for_todo_painted_tile_color(robot, color)).
model(literal, nearer_robot_at(tile, tile, tile)).
model(literal, could_move_up(robot, tile)).
model(literal, toward_could_move_up(robot, tile, tile)).
model(literal, could_move_up_needed_robot_at_to_paint_up(tile)).
model(literal, toward_could_move_up_needed_robot_at_to_paint_up(tile, tile)).
model(literal, could_move_up_needed_clear_to_paint_up(tile)).
model(literal, toward_could_move_up_needed_clear_to_paint_up(tile, tile)).
model(literal, could_move_up_needed_robot_at_to_paint_down(tile)).
model(literal, toward_could_move_up_needed_robot_at_to_paint_down(tile, tile)).
model(literal, could_move_up_needed_clear_to_move_up_to_paint_up(tile)).
model(literal, toward_could_move_up_needed_clear_to_move_up_to_paint_up(tile, tile)).
model(literal, could_move_up_needed_clear_to_move_up_to_paint_down(tile)).
model(literal, toward_could_move_up_needed_clear_to_move_up_to_paint_down(tile, tile)).
model(literal, could_move_up_for_todo_painted_tile_any(robot, tile)).
model(literal, toward_could_move_up_for_todo_painted_tile_any(robot, tile, tile)).
model(literal, could_move_down(robot, tile)).
model(literal, toward_could_move_down(robot, tile, tile)).
model(literal, could_move_down_needed_robot_at_to_paint_up(tile)).
model(literal, toward_could_move_down_needed_robot_at_to_paint_up(tile, tile)).
model(literal, could_move_down_needed_clear_to_paint_up(tile)).
model(literal, toward_could_move_down_needed_clear_to_paint_up(tile, tile)).
model(literal, could_move_down_needed_robot_at_to_paint_down(tile)).
model(literal, toward_could_move_down_needed_robot_at_to_paint_down(tile, tile)).
model(literal, could_move_down_needed_clear_to_move_up_to_paint_up(tile)).
model(literal, toward_could_move_down_needed_clear_to_move_up_to_paint_up(tile, tile)).
model(literal, could_move_down_needed_clear_to_move_up_to_paint_down(tile)).
model(literal, toward_could_move_down_needed_clear_to_move_up_to_paint_down(tile, tile)).
model(literal, could_move_down_for_todo_painted_tile_any(robot, tile)).
model(literal, toward_could_move_down_for_todo_painted_tile_any(robot, tile, tile)).
model(literal, could_move_down_for_todo_painted_tile_any_2(robot, tile)).
model(literal, toward_could_move_down_for_todo_painted_tile_any_2(robot, tile, tile)).
model(literal, could_move_right(robot, tile)).
model(literal, toward_could_move_right(robot, tile, tile)).
model(literal, could_move_right_needed_robot_at_to_paint_up(tile)).
model(literal, toward_could_move_right_needed_robot_at_to_paint_up(tile, tile)).
model(literal, could_move_right_needed_clear_to_paint_up(tile)).
model(literal, toward_could_move_right_needed_clear_to_paint_up(tile, tile)).
model(literal, could_move_right_needed_robot_at_to_paint_down(tile)).
model(literal, toward_could_move_right_needed_robot_at_to_paint_down(tile, tile)).
model(literal, could_move_right_needed_clear_to_move_up_to_paint_up(tile)).
model(literal, toward_could_move_right_needed_clear_to_move_up_to_paint_up(tile, tile)).
model(literal, could_move_right_needed_clear_to_move_up_to_paint_down(tile)).
model(literal, toward_could_move_right_needed_clear_to_move_up_to_paint_down(tile, tile)).
model(literal, could_move_right_for_todo_painted_tile_any(robot, tile)).
model(literal, toward_could_move_right_for_todo_painted_tile_any(robot, tile, tile)).
model(literal, could_move_right_for_todo_painted_tile_any_2(robot, tile)).
model(literal, toward_could_move_right_for_todo_painted_tile_any_2(robot, tile, tile)).
model(literal, could_move_left(robot, tile)).
model(literal, toward_could_move_left(robot, tile, tile)).
model(literal, could_move_left_needed_robot_at_to_paint_up(tile)).
model(literal, toward_could_move_left_needed_robot_at_to_paint_up(tile, tile)).
model(literal, could_move_left_needed_clear_to_paint_up(tile)).
model(literal, toward_could_move_left_needed_clear_to_paint_up(tile, tile)).
model(literal, could_move_left_needed_robot_at_to_paint_down(tile)).
model(literal, toward_could_move_left_needed_robot_at_to_paint_down(tile, tile)).
model(literal, could_move_left_needed_clear_to_move_up_to_paint_up(tile)).
model(literal, toward_could_move_left_needed_clear_to_move_up_to_paint_up(tile, tile)).
model(literal, could_move_left_needed_clear_to_move_up_to_paint_down(tile)).
model(literal, toward_could_move_left_needed_clear_to_move_up_to_paint_down(tile, tile)).
model(literal, could_move_left_for_todo_painted_tile_any(robot, tile)).
model(literal, toward_could_move_left_for_todo_painted_tile_any(robot, tile, tile)).
model(literal, could_move_left_for_todo_painted_tile_any_2(robot, tile)).
model(literal, toward_could_move_left_for_todo_painted_tile_any_2(robot, tile, tile)).
model(literal, fewer_robot_has_1_than_todo_painted_1).
model(literal, fewer_robot_has_1_than_clear).
model(literal, fewer_robot_has_1_than_todo_painted_1_clear).
model(literal, fewer_robot_has_1_than_todo_painted_2).
model(bias, 'floortile.yaml').
model(bias_sha256, eb3040f9e089ea08d6d9b406064e6d72ee3874a8065ce8648b08aa5c22075783).
model(success, 0.1958762886597938).
model(starts, 97).
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

domain(floortile).
:- ensure_loaded('floortile.pl').
:- add_import_module(policy, floortile, start).

% tree 1: distilled, 8 rules
delta(1, change_color(Robot, _, Color), 30.0) :- could_paint_up_todo_painted(Robot, Color), !.
delta(1, paint_up(Robot, _, Tile, Color), 50.0) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(1, move_up(_, Tile, Tile2), 40.0) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(1, move_down(_, Tile, Tile2), 0.0) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(1, move_down(_, _, _), 50.0) :- !.
delta(1, move_right(_, _, _), 20.0) :- !.
delta(1, move_left(_, _, _), 10.0) :- !.
delta(1, _, 0.0).
