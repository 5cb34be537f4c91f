% SHA-256 of what follows: 03e3603c983aadd433513dcabaac1476466ee648172f5bbbfe61fd00ae5b3672
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
model(option, episodes=1000000000).
model(option, seed=0).
model(option, guidance=0.1).
model(option, expert=domain).
model(option, horizon_factor=1.0).
model(option, step_size=1.0).
model(option, discount=0.95).
model(option, min_examples=200).
model(option, examples_growth=0.0).
model(option, episodes_per_iteration=1).
model(option, curriculum=yes).
model(option, update=all).
model(option, step='second-order').
model(option, regularisation=0.25).
model(option, regularisation_growth=0.05).
model(option, clip=3.0).
model(option, importance=0.5).
model(option, imitation=self).
model(option, floor=0.1).
model(option, detours=3.0).
model(option, replay=1000).
model(option, regressor=tilde).
model(option, models='per-action').
model(option, unrewarded=keep).
model(option, line_search=0).
model(option, ratio_clip=0.2).
model(option, critic=none).
model(option, trace=1.0).
model(option, cut_off=end).
model(option, critic_step_size=0.5).
model(option, critic_trees=1).
model(option, normalise=no).
model(tree, max_depth=3).
model(tree, min_examples=2).
model(tree, min_variance=1.0e-9).
model(tree, significance=1.0).
model(tree, granularity=0).
model(curve, evaluate_every=0).
model(curve, seconds=120.0).
model(trained_episodes, 2725).
model(trees, 19).

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

% tree 1: step size 1.0, 213 examples, 17 leaves
delta(1, change_color(_, _, Color), -0.2639379905257903) :- needed_robot_has_to_paint_up(Color), todo_painted(Tile, Color), could_move_up_needed_clear_to_paint_up(Tile), !.
delta(1, change_color(_, Color, Color2), -0.2632338055841137) :- needed_robot_has_to_paint_up(Color2), robot_has(Robot, Color), could_paint_down_todo_painted(Robot, Color2), !.
delta(1, change_color(_, _, Color), 1.6151156620559433) :- needed_robot_has_to_paint_up(Color), !.
delta(1, change_color(_, _, _), -1.0520601753721794) :- !.
delta(1, paint_up(Robot, _, Tile, Color), 1.3924892144205345) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(1, paint_up(_, _, _, _), -1.7098839792510967) :- !.
delta(1, paint_down(_, _, _, _), -1.8093077852459118) :- !.
delta(1, move_up(_, Tile, Tile2), 1.451841552585383) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile, Tile2), !.
delta(1, move_up(_, _, _), -0.742784447845675) :- !.
delta(1, move_down(_, Tile, Tile2), -0.48588348436661305) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(1, move_down(_, _, _), 1.6894098408768674) :- !.
delta(1, move_right(Robot, _, Tile), 0.8799327404740922) :- robot_at(Robot, Tile2), toward_could_move_up_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(1, move_right(_, _, _), -0.20793969027803821) :- !.
delta(1, move_left(Robot, _, _), -0.23116380014853286) :- robot_at(Robot, Tile), could_move_up_needed_robot_at_to_paint_up(Tile), !.
delta(1, move_left(Robot, _, _), -0.025199390252174058) :- robot_has(Robot, Color), could_paint_up_todo_painted(Robot, Color), !.
delta(1, move_left(_, _, _), 0.9090544963782635) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 207 examples, 32 leaves
delta(2, change_color(Robot, _, Color), 0.09831787265886231) :- could_paint_up_todo_painted(Robot, Color), fewer_robot_has_1_than_todo_painted_1_clear, robot_at(Robot, Tile), todo_painted(Tile, _), !.
delta(2, change_color(Robot, _, Color), -0.2168763892436936) :- could_paint_up_todo_painted(Robot, Color), fewer_robot_has_1_than_todo_painted_1_clear, !.
delta(2, change_color(Robot, Color, Color2), -0.08852412519350927) :- could_paint_up_todo_painted(Robot, Color2), todo_painted(Tile, Color), todo_painted(Tile, Color2), !.
delta(2, change_color(Robot, _, Color), 0.8590851814965933) :- could_paint_up_todo_painted(Robot, Color), !.
delta(2, change_color(_, _, Color), -0.03196141401757216) :- todo_painted(Tile, Color), beyond_up(Tile2, Tile), could_move_down_needed_clear_to_move_up_to_paint_down(Tile2), !.
delta(2, change_color(_, _, Color), -0.6453817090086651) :- todo_painted(Tile, Color), beyond_up(_, Tile), !.
delta(2, change_color(_, Color, _), 0.13780294435634946) :- todo_painted(Tile, Color), beyond_up(_, Tile), !.
delta(2, change_color(_, _, _), -0.09898053460989853) :- !.
delta(2, paint_up(Robot, _, Tile, Color), -0.14717492382225125) :- todo_painted(Tile2, Color), toward_could_move_left(Robot, Tile, Tile2), goal_painted(Tile3, Color), could_move_left_needed_robot_at_to_paint_down(Tile3), !.
delta(2, paint_up(Robot, _, Tile, Color), 0.3648330914471645) :- todo_painted(Tile2, Color), toward_could_move_left(Robot, Tile, Tile2), !.
delta(2, paint_up(Robot, _, Tile, Color), 0.02522418681857097) :- goal_painted(Tile2, Color), could_move_down(Robot, Tile2), todo_painted(Tile3, Color), toward_could_move_left_needed_clear_to_paint_up(Tile3, Tile), !.
delta(2, paint_up(Robot, _, _, Color), -0.8878444465451454) :- goal_painted(Tile, Color), could_move_down(Robot, Tile), !.
delta(2, paint_up(Robot, _, Tile, Color), 0.20485227182295043) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(2, paint_up(_, _, _, _), -0.14596781583435306) :- !.
delta(2, paint_down(_, _, _, _), -0.7761261928901698) :- !.
delta(2, move_up(Robot, _, _), -0.08927740153830527) :- clear(Tile), needed_robot_at_to_paint_down(Tile), robot_at(Robot, Tile2), toward_could_move_up_needed_robot_at_to_paint_up(Tile, Tile2), !.
delta(2, move_up(Robot, Tile, _), -0.018994921548431618) :- clear(Tile2), needed_robot_at_to_paint_down(Tile2), todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(2, move_up(_, _, _), 0.8866000252668516) :- clear(Tile), needed_robot_at_to_paint_down(Tile), !.
delta(2, move_up(_, _, _), -0.16250753758160186) :- !.
delta(2, move_down(Robot, Tile, _), -0.21070232650495066) :- todo_painted(Tile, Color), could_paint_up(Robot, Color), !.
delta(2, move_down(Robot, Tile, Tile2), -0.1651471396473515) :- robot_at(Robot2, Tile), toward_could_move_left(Robot2, Tile2, Tile), todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(2, move_down(_, Tile, Tile2), 0.1297305981052409) :- robot_at(Robot, Tile), toward_could_move_left(Robot, Tile2, Tile), !.
delta(2, move_down(_, _, _), 0.7694439884947977) :- !.
delta(2, move_right(Robot, Tile, _), -0.012659266653864602) :- clear(Tile2), could_move_up(Robot, Tile2), robot_at(Robot2, Tile), toward_could_move_up(Robot2, Tile, Tile2), fewer_robot_has_1_than_clear, !.
delta(2, move_right(Robot, Tile, _), 0.05142187088532725) :- clear(Tile2), could_move_up(Robot, Tile2), robot_at(Robot2, Tile), toward_could_move_up(Robot2, Tile, Tile2), !.
delta(2, move_right(Robot, _, _), -0.27395876435360345) :- clear(Tile), could_move_up(Robot, Tile), !.
delta(2, move_right(_, _, _), 0.10603916459577707) :- !.
delta(2, move_left(_, _, Tile), 0.5602036762157271) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(2, move_left(Robot, Tile, _), 0.22919664260783465) :- clear(Tile2), toward_could_move_left_for_todo_painted_tile_any(Robot, Tile, Tile2), !.
delta(2, move_left(Robot, Tile, _), 0.042868827040172516) :- clear(Tile2), toward_could_move_right_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(2, move_left(_, _, _), -0.5953374775258365) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 204 examples, 26 leaves
delta(3, change_color(Robot, _, Color), -0.3590469672107584) :- robot_has(Robot, Color), !.
delta(3, change_color(Robot, Color, Color2), 0.8714747409542287) :- goal_painted(Tile, Color2), could_move_down(Robot, Tile), goal_painted(Tile2, Color), needed_robot_at_to_paint_down(Tile2), !.
delta(3, change_color(Robot, _, Color), -0.1401305738440079) :- goal_painted(Tile, Color), could_move_down(Robot, Tile), !.
delta(3, change_color(_, Color, _), -0.14711560091091078) :- todo_painted(_, Color), !.
delta(3, change_color(_, _, _), 0.07665241425400408) :- !.
delta(3, paint_up(Robot, _, _, _), -0.7299368291784374) :- clear(Tile), could_move_up(Robot, Tile), !.
delta(3, paint_up(_, Tile, _, Color), 0.5545511421464963) :- todo_painted(Tile, Color), !.
delta(3, paint_up(_, _, _, _), -0.2738802416299997) :- !.
delta(3, paint_down(_, _, _, _), -0.5067853667788004) :- !.
delta(3, move_up(_, Tile, Tile2), 0.38314906913320684) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(3, move_up(_, _, _), -0.7520535556698359) :- !.
delta(3, move_down(Robot, Tile, Tile2), 0.09522914589593716) :- robot_at(Robot2, Tile), toward_could_move_left_for_todo_painted_tile_any_2(Robot2, Tile2, Tile), todo_painted(Tile, Color), needed_robot_has_to_paint_up(Color), toward_could_move_up(Robot, Tile, Tile2), !.
delta(3, move_down(_, Tile, Tile2), -0.07859127545075442) :- robot_at(Robot, Tile), toward_could_move_left_for_todo_painted_tile_any_2(Robot, Tile2, Tile), todo_painted(Tile, Color), needed_robot_has_to_paint_up(Color), !.
delta(3, move_down(_, Tile, Tile2), -0.5142383879532787) :- robot_at(Robot, Tile), toward_could_move_left_for_todo_painted_tile_any_2(Robot, Tile2, Tile), !.
delta(3, move_down(Robot, Tile, _), -0.08192589569576313) :- todo_painted(Tile, Color), could_paint_up(Robot, Color), !.
delta(3, move_down(_, _, Tile), -0.057574031197449874) :- clear(Tile2), toward_could_move_up_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(3, move_down(_, _, _), 0.41307746553437663) :- !.
delta(3, move_right(Robot, Tile, _), -0.0242954610111805) :- robot_at(Robot, Tile2), could_move_right_needed_robot_at_to_paint_up(Tile2), todo_painted(Tile, Color), needed_robot_has_to_paint_up(Color), !.
delta(3, move_right(Robot, Tile, Tile2), 0.7894035987242248) :- robot_at(Robot, Tile3), could_move_right_needed_robot_at_to_paint_up(Tile3), robot_at(Robot2, Tile), toward_could_move_right_for_todo_painted_tile_any_2(Robot2, Tile2, Tile), !.
delta(3, move_right(Robot, _, _), -0.004412505735390582) :- robot_at(Robot, Tile), could_move_right_needed_robot_at_to_paint_up(Tile), !.
delta(3, move_right(_, _, _), -0.21146594457109463) :- !.
delta(3, move_left(_, _, Tile), 0.27434582118280887) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(3, move_left(_, _, Tile), 0.1399386137696727) :- clear(Tile2), toward_could_move_down_needed_clear_to_paint_up(Tile, Tile2), !.
delta(3, move_left(_, Tile, Tile2), -0.4034649156613612) :- robot_at(Robot, Tile), toward_could_move_left_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(3, move_left(_, _, _), 0.03400338783276474) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 240 examples, 32 leaves
delta(4, change_color(Robot, Color, Color2), 0.04153712562653555) :- could_paint_up_todo_painted(Robot, Color2), fewer_robot_has_1_than_todo_painted_1_clear, todo_painted(Tile, Color), robot_at(Robot, Tile), !.
delta(4, change_color(Robot, _, Color), -0.16924553565345715) :- could_paint_up_todo_painted(Robot, Color), fewer_robot_has_1_than_todo_painted_1_clear, !.
delta(4, change_color(Robot, _, Color), -0.06573177193935353) :- could_paint_up_todo_painted(Robot, Color), robot_has(Robot2, Color), could_paint_up_todo_painted(Robot2, Color), !.
delta(4, change_color(Robot, _, Color), 0.3116977584133989) :- could_paint_up_todo_painted(Robot, Color), !.
delta(4, change_color(Robot, _, Color), -0.013610088056070408) :- robot_at(Robot, Tile), could_move_left_needed_robot_at_to_paint_down(Tile), todo_painted(Tile2, Color), needed_robot_at_to_paint_up(Tile2), !.
delta(4, change_color(Robot, _, _), 0.05861288294185519) :- robot_at(Robot, Tile), could_move_left_needed_robot_at_to_paint_down(Tile), !.
delta(4, change_color(_, Color, _), 0.022034100085561396) :- goal_painted(Tile, Color), could_move_left_needed_clear_to_move_up_to_paint_down(Tile), !.
delta(4, change_color(_, _, _), -0.7031503678443369) :- !.
delta(4, paint_up(Robot, _, Tile, Color), -0.0014712714452991516) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), todo_painted(Tile3, Color), toward_could_move_left_needed_clear_to_move_up_to_paint_down(Tile, Tile3), !.
delta(4, paint_up(Robot, _, Tile, Color), 0.637863518322798) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(4, paint_up(_, _, _, _), -0.19291648662803285) :- !.
delta(4, paint_down(_, _, _, _), -0.3183178759255415) :- !.
delta(4, move_up(_, Tile, Tile2), 0.036285020186323874) :- clear(Tile3), toward_could_move_right_needed_robot_at_to_paint_up(Tile3, Tile), robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(4, move_up(_, Tile, _), -0.2045247225006343) :- clear(Tile2), toward_could_move_right_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(4, move_up(Robot, Tile, Tile2), -0.010551936568937402) :- clear(Tile3), nearer_robot_at(Tile3, Tile2, Tile), robot_at(Robot, Tile4), toward_could_move_left_needed_robot_at_to_paint_up(Tile2, Tile4), !.
delta(4, move_up(_, Tile, Tile2), 0.3928980243137431) :- clear(Tile3), nearer_robot_at(Tile3, Tile2, Tile), !.
delta(4, move_up(_, _, _), -0.026222463400643516) :- !.
delta(4, move_down(_, Tile, Tile2), -0.2881731706776941) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), clear(Tile3), nearer_robot_at(Tile3, Tile, Tile2), !.
delta(4, move_down(_, Tile, Tile2), -0.03224811514710788) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), available_color(Color), needed_robot_has_to_paint_up(Color), !.
delta(4, move_down(_, Tile, Tile2), 0.06640713824849384) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(4, move_down(_, Tile, Tile2), -0.07054514579354938) :- robot_at(Robot, Tile), toward_could_move_right(Robot, Tile2, Tile), !.
delta(4, move_down(_, _, _), 0.2962863986160784) :- !.
delta(4, move_right(Robot, _, _), -0.20434655788740003) :- robot_has(Robot, Color), could_paint_up_todo_painted(Robot, Color), !.
delta(4, move_right(_, Tile, _), -0.04925502749905236) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(4, move_right(Robot, _, _), -0.01731707676771569) :- robot_at(Robot, Tile), could_move_up_needed_robot_at_to_paint_up(Tile), !.
delta(4, move_right(_, _, _), 0.3352748051205886) :- !.
delta(4, move_left(Robot, _, Tile), -0.0007983052696112343) :- clear(Tile2), toward_could_move_down(Robot, Tile, Tile2), robot_at(Robot, Tile3), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile3, Tile), !.
delta(4, move_left(Robot, _, Tile), -0.14059292307568108) :- clear(Tile2), toward_could_move_down(Robot, Tile, Tile2), !.
delta(4, move_left(_, Tile, _), -0.065229211786095) :- todo_painted(Tile, Color), needed_robot_has_to_paint_up(Color), !.
delta(4, move_left(_, Tile, _), -0.01626726381038703) :- clear(Tile2), toward_could_move_left_needed_robot_at_to_paint_up(Tile, Tile2), !.
delta(4, move_left(_, _, _), 0.2874021630586097) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 226 examples, 23 leaves
delta(5, change_color(Robot, Color, Color2), -0.004710450584666336) :- robot_has(Robot, Color3), could_paint_up_for_todo_painted_tile_color(Robot, Color3), todo_painted(Tile, Color), todo_painted(Tile, Color2), !.
delta(5, change_color(Robot, _, _), 0.10628711208505512) :- robot_has(Robot, Color), could_paint_up_for_todo_painted_tile_color(Robot, Color), !.
delta(5, change_color(Robot, _, _), 0.03862863784985714) :- clear(Tile), needed_robot_at_to_paint_up(Tile), robot_at(Robot, Tile2), could_move_left_needed_robot_at_to_paint_down(Tile2), !.
delta(5, change_color(_, _, _), -0.2765235271573585) :- clear(Tile), needed_robot_at_to_paint_up(Tile), !.
delta(5, change_color(Robot, _, Color), 0.10987855158301463) :- could_paint_up_todo_painted(Robot, Color), !.
delta(5, change_color(_, _, _), -0.051627757193391105) :- !.
delta(5, paint_up(Robot, _, Tile, Color), -0.055938433974689145) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), todo_painted(Tile3, Color), needed_robot_at_to_paint_up(Tile3), !.
delta(5, paint_up(Robot, _, Tile, Color), 0.2545927650356456) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(5, paint_up(_, _, _, _), -0.09283666820838338) :- !.
delta(5, paint_down(_, _, _, _), -0.13451500596427038) :- !.
delta(5, move_up(_, Tile, Tile2), 0.18815323216825586) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(5, move_up(_, _, _), -0.15724254841669685) :- !.
delta(5, move_down(_, Tile, Tile2), -0.17480217219058972) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(5, move_down(_, _, _), 0.19159293985476145) :- !.
delta(5, move_right(Robot, Tile, _), 0.017469622537201218) :- robot_at(Robot2, Tile), could_move_up(Robot2, Tile), todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(5, move_right(Robot, Tile, Tile2), 0.012025315193056767) :- robot_at(Robot2, Tile), could_move_up(Robot2, Tile), robot_at(Robot, Tile3), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile2, Tile3), !.
delta(5, move_right(_, Tile, _), -0.13582333597221907) :- robot_at(Robot, Tile), could_move_up(Robot, Tile), !.
delta(5, move_right(_, Tile, Tile2), 0.193380350579094) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(5, move_right(_, _, _), -0.053804941183706795) :- !.
delta(5, move_left(_, _, Tile), 0.1611973692109929) :- clear(Tile2), toward_could_move_left_needed_clear_to_paint_up(Tile, Tile2), !.
delta(5, move_left(Robot, _, Tile), -0.1635282627054633) :- robot_at(Robot, Tile2), toward_could_move_left_needed_robot_at_to_paint_up(Tile, Tile2), !.
delta(5, move_left(_, _, _), 0.0110137807981755) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 210 examples, 32 leaves
delta(6, change_color(Robot, Color, Color2), -0.010015812203006617) :- todo_painted(Tile, Color2), could_move_left_needed_clear_to_paint_up(Tile), todo_painted(Tile2, Color), toward_could_move_up_needed_robot_at_to_paint_down(Tile, Tile2), robot_at(Robot, Tile2), !.
delta(6, change_color(_, Color, Color2), 0.6657229012988991) :- todo_painted(Tile, Color2), could_move_left_needed_clear_to_paint_up(Tile), todo_painted(Tile2, Color), toward_could_move_up_needed_robot_at_to_paint_down(Tile, Tile2), !.
delta(6, change_color(_, _, Color), -0.06370778674465316) :- todo_painted(Tile, Color), could_move_left_needed_clear_to_paint_up(Tile), !.
delta(6, change_color(Robot, _, Color), -0.109426732832244) :- could_paint_up_todo_painted(Robot, Color), robot_at(Robot, Tile), could_move_up_needed_robot_at_to_paint_up(Tile), !.
delta(6, change_color(Robot, _, Color), 0.19924341971920786) :- could_paint_up_todo_painted(Robot, Color), !.
delta(6, change_color(_, Color, _), -0.34978688750574205) :- goal_painted(Tile, Color), unsettled_before_right_todo_painted(Tile), !.
delta(6, change_color(_, _, _), 0.012351505387153525) :- !.
delta(6, paint_up(Robot, _, _, _), -0.1366995162339022) :- robot_at(Robot, Tile), could_move_up_needed_robot_at_to_paint_up(Tile), !.
delta(6, paint_up(_, Tile, _, Color), 0.5075084362947169) :- todo_painted(Tile, Color), !.
delta(6, paint_up(_, _, _, _), -0.083827151946637) :- !.
delta(6, paint_down(_, _, _, _), -0.22184417587640942) :- !.
delta(6, move_up(Robot, Tile, Tile2), 0.03669078839121865) :- todo_painted(Tile2, Color), robot_has(_, Color), toward_could_move_right_needed_robot_at_to_paint_up(Tile, Tile2), could_move_up(Robot, Tile2), !.
delta(6, move_up(_, Tile, Tile2), -0.0008482117237652658) :- todo_painted(Tile2, Color), robot_has(_, Color), toward_could_move_right_needed_robot_at_to_paint_up(Tile, Tile2), !.
delta(6, move_up(_, _, Tile), -0.2967559274263296) :- todo_painted(Tile, Color), robot_has(_, Color), !.
delta(6, move_up(_, Tile, Tile2), 0.1115572625825141) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(6, move_up(_, _, _), -0.018953014082489887) :- !.
delta(6, move_down(Robot, Tile, Tile2), -0.11833892089664126) :- robot_at(Robot2, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot2, Tile2, Tile), clear(Tile3), could_move_right(Robot, Tile3), !.
delta(6, move_down(_, Tile, Tile2), 0.008567499488235503) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), robot_at(Robot2, Tile), toward_could_move_down_for_todo_painted_tile_any_2(Robot2, Tile2, Tile), !.
delta(6, move_down(_, Tile, Tile2), -0.004373995733678103) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(6, move_down(Robot, _, Tile), -0.0714698395019179) :- todo_painted(Tile, Color), robot_has(Robot, Color), todo_painted(Tile2, Color), could_move_left(Robot, Tile2), !.
delta(6, move_down(Robot, _, Tile), 0.06270531506824434) :- todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(6, move_down(_, _, _), 0.31939946525293883) :- !.
delta(6, move_right(_, Tile, Tile2), -0.30133540920524415) :- robot_at(Robot, Tile), toward_could_move_left_for_todo_painted_tile_any_2(Robot, Tile, Tile2), !.
delta(6, move_right(_, _, Tile), -0.08191206572067122) :- clear(Tile2), toward_could_move_right_needed_clear_to_paint_up(Tile, Tile2), !.
delta(6, move_right(_, Tile, _), -0.005824352558238031) :- clear(Tile2), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile2, Tile), !.
delta(6, move_right(_, _, _), 0.2576405627688556) :- !.
delta(6, move_left(Robot, Tile, Tile2), 0.13380179732923264) :- clear(Tile3), toward_could_move_right(Robot, Tile3, Tile2), todo_painted(Tile, Color), todo_painted(Tile3, Color), !.
delta(6, move_left(Robot, _, Tile), -0.014394040487651898) :- clear(Tile2), toward_could_move_right(Robot, Tile2, Tile), !.
delta(6, move_left(Robot, Tile, Tile2), -0.025184952211924287) :- clear(Tile3), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile3, Tile2), todo_painted(Tile, Color), could_paint_down(Robot, Color), !.
delta(6, move_left(_, _, Tile), 0.039191416987140106) :- clear(Tile2), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile2, Tile), !.
delta(6, move_left(_, _, _), -0.5754429317278884) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 229 examples, 31 leaves
delta(7, change_color(_, Color, Color2), -0.039040893344893475) :- robot_has(Robot, Color2), could_paint_up_for_todo_painted_any_color(Robot, Color2), todo_painted(Tile, Color), todo_painted(Tile, Color2), !.
delta(7, change_color(_, Color, Color2), -0.0046736734715967475) :- robot_has(Robot, Color2), could_paint_up_for_todo_painted_any_color(Robot, Color2), todo_painted(Tile, Color), robot_at(Robot, Tile), !.
delta(7, change_color(_, _, Color), 0.3705117459210093) :- robot_has(Robot, Color), could_paint_up_for_todo_painted_any_color(Robot, Color), !.
delta(7, change_color(Robot, Color, _), -0.13246148278392833) :- goal_painted(Tile, Color), could_move_right_needed_clear_to_move_up_to_paint_down(Tile), robot_at(Robot, Tile2), could_move_left_needed_clear_to_paint_up(Tile2), !.
delta(7, change_color(_, Color, _), 0.21165588328897064) :- goal_painted(Tile, Color), could_move_right_needed_clear_to_move_up_to_paint_down(Tile), !.
delta(7, change_color(_, _, _), -0.2884138237627515) :- clear(Tile), needed_robot_at_to_paint_up(Tile), !.
delta(7, change_color(_, _, _), 0.02015032817895172) :- !.
delta(7, paint_up(_, _, Tile, Color), 0.21124276336380074) :- todo_painted(Tile2, Color), toward_could_move_left_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(7, paint_up(Robot, _, Tile, Color), -0.0002713914876693946) :- todo_painted(Tile2, Color), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile, Tile2), goal_painted(Tile3, Color), could_move_left(Robot, Tile3), !.
delta(7, paint_up(_, _, Tile, Color), 0.05946022972816799) :- todo_painted(Tile2, Color), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile, Tile2), !.
delta(7, paint_up(_, _, _, _), -0.14414270041133548) :- !.
delta(7, paint_down(_, _, _, _), -0.12848480338316456) :- !.
delta(7, move_up(_, Tile, Tile2), -0.007877429492142034) :- clear(Tile3), toward_could_move_right_needed_robot_at_to_paint_down(Tile2, Tile3), todo_painted(Tile, _), !.
delta(7, move_up(_, _, Tile), 0.07635106332535412) :- clear(Tile2), toward_could_move_right_needed_robot_at_to_paint_down(Tile, Tile2), !.
delta(7, move_up(Robot, _, Tile), 0.0021242399008994544) :- clear(Tile2), could_move_right(Robot, Tile2), robot_at(Robot, Tile3), toward_could_move_left_needed_clear_to_move_up_to_paint_down(Tile3, Tile), !.
delta(7, move_up(Robot, _, _), -0.17468025750822896) :- clear(Tile), could_move_right(Robot, Tile), !.
delta(7, move_up(Robot, _, _), -0.013780013320991399) :- robot_has(Robot, Color), done_painted(_, Color), !.
delta(7, move_up(_, _, _), 0.02780566568229153) :- !.
delta(7, move_down(_, _, Tile), -0.13698533264981858) :- clear(Tile2), toward_could_move_left_needed_robot_at_to_paint_up(Tile2, Tile), clear(Tile3), toward_could_move_up_needed_robot_at_to_paint_down(Tile2, Tile3), !.
delta(7, move_down(Robot, Tile, Tile2), -0.005893918241646634) :- clear(Tile3), toward_could_move_left_needed_robot_at_to_paint_up(Tile3, Tile2), todo_painted(Tile, Color), could_paint_up(Robot, Color), !.
delta(7, move_down(_, _, Tile), 0.014904500429672857) :- clear(Tile2), toward_could_move_left_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(7, move_down(_, Tile, Tile2), -0.05425869660558279) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(7, move_down(_, _, _), 0.2341430000723256) :- !.
delta(7, move_right(Robot, _, Tile), 0.09158193378703687) :- clear(Tile2), toward_could_move_left(Robot, Tile2, Tile), !.
delta(7, move_right(_, Tile, Tile2), -0.2509545348279587) :- robot_at(Robot, Tile), toward_could_move_left(Robot, Tile, Tile2), !.
delta(7, move_right(_, _, _), 0.008430741317266368) :- !.
delta(7, move_left(_, Tile, _), -0.22830178069762425) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(7, move_left(_, Tile, Tile2), -0.05141300342027798) :- robot_at(Robot, Tile), toward_could_move_right_for_todo_painted_tile_any_2(Robot, Tile, Tile2), !.
delta(7, move_left(Robot, _, _), 0.28662206525263234) :- robot_has(Robot, Color), todo_painted(_, Color), !.
delta(7, move_left(_, _, _), -0.0022302054877418936) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 209 examples, 23 leaves
delta(8, change_color(Robot, Color, Color2), -0.006091128067874989) :- robot_has(Robot2, Color), could_paint_up_for_todo_painted_tile_color(Robot2, Color), robot_at(Robot, Tile), could_move_left_needed_robot_at_to_paint_up(Tile), robot_has(Robot, Color2), !.
delta(8, change_color(Robot, Color, _), 0.39568395283912533) :- robot_has(Robot2, Color), could_paint_up_for_todo_painted_tile_color(Robot2, Color), robot_at(Robot, Tile), could_move_left_needed_robot_at_to_paint_up(Tile), !.
delta(8, change_color(Robot, Color, _), 0.13012471448802065) :- robot_has(Robot2, Color), could_paint_up_for_todo_painted_tile_color(Robot2, Color), robot_has(Robot, Color2), could_paint_down_for_todo_painted_tile_color(Robot, Color2), !.
delta(8, change_color(_, Color, _), -0.14106117423640338) :- robot_has(Robot, Color), could_paint_up_for_todo_painted_tile_color(Robot, Color), !.
delta(8, change_color(Robot, _, Color), -0.03542206938326856) :- could_paint_up_todo_painted(Robot, Color), clear(Tile), needed_robot_at_to_paint_up(Tile), !.
delta(8, change_color(Robot, _, Color), 0.07419530747370398) :- could_paint_up_todo_painted(Robot, Color), !.
delta(8, change_color(_, _, _), -0.12826248330708773) :- !.
delta(8, paint_up(Robot, _, Tile, Color), 0.17277704203088204) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(8, paint_up(_, _, _, _), -0.06982946121867317) :- !.
delta(8, paint_down(_, _, _, _), -0.0718651417465372) :- !.
delta(8, move_up(_, Tile, _), -0.0030689870268109476) :- fewer_robot_has_1_than_todo_painted_2, todo_painted(Tile, _), !.
delta(8, move_up(_, _, _), 0.01832971038040679) :- fewer_robot_has_1_than_todo_painted_2, !.
delta(8, move_up(_, _, Tile), 0.006759953098940324) :- clear(Tile2), toward_could_move_right_needed_clear_to_paint_up(Tile2, Tile), !.
delta(8, move_up(_, _, _), -0.27582939998435985) :- !.
delta(8, move_down(Robot, Tile, _), -0.022670077105847737) :- todo_painted(Tile, Color), could_paint_up(Robot, Color), !.
delta(8, move_down(_, _, _), 0.1439420701519229) :- !.
delta(8, move_right(Robot, _, Tile), 0.11213630875456383) :- clear(Tile2), toward_could_move_right_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(8, move_right(Robot, _, Tile), 0.010795700279335045) :- robot_at(Robot, Tile2), toward_could_move_right_needed_clear_to_move_up_to_paint_down(Tile, Tile2), !.
delta(8, move_right(_, _, _), -0.2489182313616732) :- !.
delta(8, move_left(_, Tile, Tile2), -0.0020864795971433834) :- clear(Tile3), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile3, Tile2), robot_at(Robot, Tile), toward_could_move_right(Robot, Tile, Tile2), !.
delta(8, move_left(_, _, Tile), 0.03807885659728824) :- clear(Tile2), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile2, Tile), !.
delta(8, move_left(_, _, _), -0.12032409074719713) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 203 examples, 22 leaves
delta(9, change_color(Robot, _, _), -0.07859036473239418) :- robot_has(Robot, Color), could_paint_up_todo_painted(Robot, Color), !.
delta(9, change_color(Robot, _, Color), -0.06518844799081723) :- done_painted(Tile, Color), unsettled_right_todo_painted(Tile), robot_at(Robot, Tile2), unsettled_up_todo_painted(Tile2), !.
delta(9, change_color(_, _, Color), 0.034795282254041035) :- done_painted(Tile, Color), unsettled_right_todo_painted(Tile), !.
delta(9, change_color(Robot, _, Color), -0.029806949728459306) :- robot_has(Robot, Color), !.
delta(9, change_color(_, _, _), 0.5059742299819666) :- !.
delta(9, paint_up(Robot, _, Tile, Color), 0.10823595546740933) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(9, paint_up(_, _, _, _), -0.0737764194244995) :- !.
delta(9, paint_down(_, _, _, _), -0.05887685150080811) :- !.
delta(9, move_up(Robot, _, Tile), 0.022465222156680283) :- robot_at(Robot, Tile2), toward_could_move_right_needed_robot_at_to_paint_up(Tile2, Tile), fewer_robot_has_1_than_todo_painted_1_clear, !.
delta(9, move_up(Robot, _, Tile), -0.003452793880193001) :- robot_at(Robot, Tile2), toward_could_move_right_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(9, move_up(_, _, Tile), 0.018692215869042378) :- clear(Tile2), toward_could_move_left_needed_clear_to_move_up_to_paint_down(Tile, Tile2), !.
delta(9, move_up(_, _, _), -0.15792584523627543) :- clear(Tile), beyond_right(_, Tile), !.
delta(9, move_up(_, _, _), 0.007253683755487797) :- !.
delta(9, move_down(_, Tile, Tile2), 0.04769360896713696) :- robot_at(Robot, Tile), could_move_down(Robot, Tile2), !.
delta(9, move_down(_, _, _), -0.1306930566337749) :- fewer_robot_has_1_than_todo_painted_1, !.
delta(9, move_down(_, _, _), 0.01858165281800044) :- !.
delta(9, move_right(_, Tile, Tile2), 0.005960993259586814) :- todo_painted(Tile, Color), todo_painted(Tile3, Color), toward_could_move_right_needed_clear_to_move_up_to_paint_down(Tile2, Tile3), !.
delta(9, move_right(_, Tile, _), -0.09180439316840641) :- todo_painted(Tile, _), !.
delta(9, move_right(Robot, Tile, _), -0.02605646259388619) :- clear(Tile2), toward_could_move_right_for_todo_painted_tile_any(Robot, Tile, Tile2), !.
delta(9, move_right(_, _, _), 0.15134440549610556) :- !.
delta(9, move_left(_, _, _), -0.38065303295419356) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 241 examples, 24 leaves
delta(10, change_color(Robot, _, Color), 0.03697851964144375) :- clear(Tile), could_move_up(Robot, Tile), robot_at(Robot, Tile2), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile, Tile2), could_paint_up_todo_painted(Robot, Color), !.
delta(10, change_color(Robot, _, _), -0.007449755544275712) :- clear(Tile), could_move_up(Robot, Tile), robot_at(Robot, Tile2), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile, Tile2), !.
delta(10, change_color(Robot, Color, _), 0.0030880490084802662) :- clear(Tile), could_move_up(Robot, Tile), goal_painted(Tile2, Color), could_move_left_needed_clear_to_move_up_to_paint_down(Tile2), !.
delta(10, change_color(Robot, _, _), -0.3757912890424006) :- clear(Tile), could_move_up(Robot, Tile), !.
delta(10, change_color(Robot, _, Color), -0.01008675565897476) :- could_paint_up_for_todo_painted_any_color(Robot, Color), robot_has(Robot2, Color), could_paint_up_todo_painted(Robot2, Color), !.
delta(10, change_color(Robot, _, Color), 0.1986528371130134) :- could_paint_up_for_todo_painted_any_color(Robot, Color), !.
delta(10, change_color(_, _, _), -0.017416568339467975) :- !.
delta(10, paint_up(Robot, _, Tile, Color), 0.02575401993441824) :- todo_painted(Tile2, Color), needed_robot_at_to_paint_up(Tile2), todo_painted(Tile3, Color), toward_could_move_down(Robot, Tile3, Tile), !.
delta(10, paint_up(_, _, _, Color), -0.9212554172873756) :- todo_painted(Tile, Color), needed_robot_at_to_paint_up(Tile), !.
delta(10, paint_up(_, Tile, _, Color), 0.10389991726620083) :- todo_painted(Tile, Color), !.
delta(10, paint_up(_, _, _, _), -0.05355000651396108) :- !.
delta(10, paint_down(_, _, _, _), -0.06806028879117881) :- !.
delta(10, move_up(_, Tile, Tile2), 0.09637439671249955) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(10, move_up(_, _, _), -0.17640865264732855) :- !.
delta(10, move_down(_, Tile, Tile2), -0.042106989900365016) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(10, move_down(_, _, _), 0.11396581066058888) :- !.
delta(10, move_right(_, Tile, Tile2), -0.004112961878460125) :- robot_at(Robot, Tile), toward_could_move_up(Robot, Tile, Tile2), robot_at(Robot2, Tile), toward_could_move_down(Robot2, Tile2, Tile), !.
delta(10, move_right(_, Tile, Tile2), 1.006640719393486) :- robot_at(Robot, Tile), toward_could_move_up(Robot, Tile, Tile2), available_color(Color), needed_robot_has_to_paint_up(Color), !.
delta(10, move_right(_, Tile, Tile2), -0.00028315954234843667) :- robot_at(Robot, Tile), toward_could_move_up(Robot, Tile, Tile2), !.
delta(10, move_right(_, _, _), -0.061257485970863806) :- !.
delta(10, move_left(_, Tile, _), -0.16479144803095458) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(10, move_left(_, Tile, Tile2), -0.06235649815619469) :- clear(Tile3), nearer_robot_at(Tile3, Tile, Tile2), !.
delta(10, move_left(_, _, _), 0.3676393235742798) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 207 examples, 28 leaves
delta(11, change_color(Robot, Color, Color2), -0.010569518814629253) :- todo_painted(Tile, Color), done_painted(Tile2, Color2), toward_could_move_right_for_todo_painted_tile_any(Robot, Tile2, Tile), could_paint_up_todo_painted(Robot, Color), !.
delta(11, change_color(Robot, Color, Color2), 0.035808019004869504) :- todo_painted(Tile, Color), done_painted(Tile2, Color2), toward_could_move_right_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(11, change_color(Robot, Color, _), 0.011748962344885022) :- todo_painted(Tile, Color), todo_painted(Tile, Color2), could_paint_up_for_todo_painted_tile_color(Robot, Color2), !.
delta(11, change_color(_, Color, _), -0.20397979761982984) :- todo_painted(_, Color), !.
delta(11, change_color(Robot, _, Color), 0.0736971029467813) :- robot_at(Robot, Tile), unsettled_before_up_todo_painted(Tile), todo_painted(_, Color), !.
delta(11, change_color(Robot, _, _), -0.006356553614032934) :- robot_at(Robot, Tile), unsettled_before_up_todo_painted(Tile), !.
delta(11, change_color(_, _, _), -0.026947699884366905) :- !.
delta(11, paint_up(Robot, _, Tile, Color), 0.08227967740675096) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(11, paint_up(_, _, _, _), -0.03815514058237215) :- !.
delta(11, paint_down(_, _, _, _), -0.03733746034601844) :- !.
delta(11, move_up(_, Tile, Tile2), 0.004777001986394048) :- todo_painted(Tile2, Color), robot_has(_, Color), toward_could_move_right_needed_clear_to_paint_up(Tile, Tile2), needed_robot_at_to_paint_up(Tile2), !.
delta(11, move_up(_, Tile, Tile2), -0.00020163408105605218) :- todo_painted(Tile2, Color), robot_has(_, Color), toward_could_move_right_needed_clear_to_paint_up(Tile, Tile2), !.
delta(11, move_up(_, _, Tile), 0.0028241380682184694) :- todo_painted(Tile, Color), robot_has(_, Color), fewer_robot_has_1_than_todo_painted_2, !.
delta(11, move_up(_, _, Tile), -0.1890741788145489) :- todo_painted(Tile, Color), robot_has(_, Color), !.
delta(11, move_up(_, Tile, Tile2), 0.09405199963235461) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(11, move_up(_, _, _), -0.0033426491330348024) :- !.
delta(11, move_down(_, Tile, Tile2), -0.01999095356456281) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(11, move_down(_, _, _), 0.09607190839526658) :- !.
delta(11, move_right(_, Tile, Tile2), -0.00785988689011738) :- clear(Tile3), beyond_up(Tile3, Tile2), robot_at(Robot, Tile), could_move_left(Robot, Tile3), !.
delta(11, move_right(_, _, Tile), 0.07816761518272224) :- clear(Tile2), beyond_up(Tile2, Tile), !.
delta(11, move_right(_, _, _), -0.04647300188023902) :- !.
delta(11, move_left(_, Tile, Tile2), -0.00375888287503339) :- clear(Tile3), toward_could_move_left_needed_robot_at_to_paint_up(Tile3, Tile2), robot_at(Robot, Tile), toward_could_move_right(Robot, Tile2, Tile3), !.
delta(11, move_left(_, _, Tile), 0.2253923314174194) :- clear(Tile2), toward_could_move_left_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(11, move_left(Robot, Tile, Tile2), -0.0013147300750106863) :- todo_painted(Tile2, Color), robot_has(Robot, Color), todo_painted(Tile3, Color), up(Tile, Tile3), !.
delta(11, move_left(Robot, _, Tile), 0.023849008143760644) :- todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(11, move_left(_, _, _), -0.12822391571111846) :- clear(Tile), needed_robot_at_to_paint_up(Tile), !.
delta(11, move_left(_, _, _), 0.005496383447935937) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 277 examples, 26 leaves
delta(12, change_color(_, Color, _), -0.0035121479687856795) :- robot_has(Robot, Color), could_paint_down_for_todo_painted_tile_color(Robot, Color), todo_painted(Tile, Color), could_move_right_needed_robot_at_to_paint_down(Tile), !.
delta(12, change_color(_, Color, Color2), -0.001918281887079828) :- robot_has(Robot, Color), could_paint_down_for_todo_painted_tile_color(Robot, Color), robot_has(Robot2, Color), could_paint_down_for_todo_painted_tile_color(Robot2, Color2), !.
delta(12, change_color(_, Color, _), 0.05066213214983296) :- robot_has(Robot, Color), could_paint_down_for_todo_painted_tile_color(Robot, Color), !.
delta(12, change_color(Robot, _, Color), -8.171748774534124e-5) :- clear(Tile), needed_robot_at_to_paint_up(Tile), todo_painted(Tile2, Color), toward_could_move_left_for_todo_painted_tile_any_2(Robot, Tile2, Tile), !.
delta(12, change_color(_, _, _), -0.16650970563458636) :- clear(Tile), needed_robot_at_to_paint_up(Tile), !.
delta(12, change_color(Robot, _, Color), 0.009345648964659553) :- could_paint_up_todo_painted(Robot, Color), !.
delta(12, change_color(_, _, _), -0.004119271682762361) :- !.
delta(12, paint_up(_, _, Tile, Color), 0.08218206375578695) :- todo_painted(Tile2, Color), toward_could_move_up_needed_clear_to_paint_up(Tile2, Tile), !.
delta(12, paint_up(_, _, _, _), -0.2422091454978337) :- !.
delta(12, paint_down(_, _, _, _), -0.016696591966442402) :- !.
delta(12, move_up(Robot, Tile, Tile2), 0.2843591525231508) :- clear(Tile3), toward_could_move_left(Robot, Tile3, Tile2), robot_at(Robot2, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot2, Tile, Tile2), !.
delta(12, move_up(Robot, _, Tile), -0.0015876171139280221) :- clear(Tile2), toward_could_move_left(Robot, Tile2, Tile), !.
delta(12, move_up(_, _, Tile), -0.12446855091358258) :- available_color(Color), needed_robot_has_to_paint_up(Color), todo_painted(Tile2, Color), toward_could_move_left_needed_robot_at_to_paint_up(Tile, Tile2), !.
delta(12, move_up(_, _, _), 0.012634277204611409) :- available_color(Color), needed_robot_has_to_paint_up(Color), !.
delta(12, move_up(_, Tile, Tile2), 0.032623761753536505) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(12, move_up(_, _, _), -0.0031079507529412163) :- !.
delta(12, move_down(_, Tile, Tile2), -0.11487944351654311) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(12, move_down(_, _, _), 0.014841185783720137) :- !.
delta(12, move_right(Robot, _, Tile), -0.001213711372073359) :- todo_painted(Tile, Color), done_painted(_, Color), could_paint_down(Robot, Color), !.
delta(12, move_right(_, _, Tile), 0.20427381579381487) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(12, move_right(Robot, Tile, Tile2), 0.0018661503145138815) :- robot_at(Robot2, Tile), toward_could_move_right_for_todo_painted_tile_any(Robot2, Tile2, Tile), robot_at(Robot, Tile3), toward_could_move_up_needed_robot_at_to_paint_up(Tile3, Tile2), !.
delta(12, move_right(_, Tile, Tile2), -0.179767926674475) :- robot_at(Robot, Tile), toward_could_move_right_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(12, move_right(_, _, _), 0.0023873713638622005) :- !.
delta(12, move_left(_, _, Tile), 0.16935651950193042) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(12, move_left(_, _, _), -0.010334525618440577) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 207 examples, 24 leaves
delta(13, change_color(Robot, Color, Color2), -0.00066344062786064) :- robot_has(Robot, Color3), could_paint_up_for_todo_painted_tile_color(Robot, Color3), todo_painted(Tile, Color), todo_painted(Tile, Color2), !.
delta(13, change_color(Robot, _, _), 0.07550404694164682) :- robot_has(Robot, Color), could_paint_up_for_todo_painted_tile_color(Robot, Color), !.
delta(13, change_color(_, _, _), -0.08828805999309923) :- clear(Tile), needed_robot_at_to_paint_up(Tile), !.
delta(13, change_color(Robot, _, Color), 0.02573549708589658) :- could_paint_up_todo_painted(Robot, Color), !.
delta(13, change_color(_, _, _), -0.014902832525522963) :- !.
delta(13, paint_up(Robot, _, Tile, Color), 0.038620186223136524) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(13, paint_up(_, _, _, _), -0.0353415025088666) :- !.
delta(13, paint_down(_, _, _, _), -0.0178424633076615) :- !.
delta(13, move_up(Robot, Tile, Tile2), -0.0006361930983356258) :- todo_painted(Tile2, Color), robot_has(Robot, Color), todo_painted(Tile3, Color), could_move_right_needed_robot_at_to_paint_down(Tile3), up(Tile3, Tile), !.
delta(13, move_up(Robot, _, Tile), 0.001139629248183763) :- todo_painted(Tile, Color), robot_has(Robot, Color), todo_painted(Tile2, Color), could_move_right_needed_robot_at_to_paint_down(Tile2), !.
delta(13, move_up(Robot, _, Tile), -0.13802463627825118) :- todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(13, move_up(_, Tile, Tile2), 0.058952335126105815) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(13, move_up(_, _, _), -0.006479193057724704) :- !.
delta(13, move_down(_, Tile, Tile2), -0.03179705628683257) :- robot_at(Robot, Tile), toward_could_move_up(Robot, Tile2, Tile), !.
delta(13, move_down(_, _, _), 0.03705830781165459) :- !.
delta(13, move_right(_, _, Tile), -0.0018325974475646007) :- todo_painted(Tile, Color), done_painted(_, Color), needed_robot_has_to_paint_up(Color), !.
delta(13, move_right(_, Tile, Tile2), 0.1442169116657749) :- todo_painted(Tile2, Color), done_painted(_, Color), toward_could_move_right_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(13, move_right(_, _, Tile), -0.0004204054861021125) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(13, move_right(_, Tile, Tile2), 0.037930966935057805) :- clear(Tile3), toward_could_move_up_needed_robot_at_to_paint_down(Tile2, Tile3), clear(Tile4), nearer_robot_at(Tile4, Tile3, Tile), !.
delta(13, move_right(_, _, Tile), -0.0021229187976826523) :- clear(Tile2), toward_could_move_up_needed_robot_at_to_paint_down(Tile, Tile2), !.
delta(13, move_right(_, _, _), -0.07378549895701593) :- !.
delta(13, move_left(_, Tile, Tile2), -0.009932948158794063) :- robot_at(Robot, Tile), toward_could_move_right_for_todo_painted_tile_any_2(Robot, Tile, Tile2), !.
delta(13, move_left(_, _, _), 0.004634930985103337) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 203 examples, 23 leaves
delta(14, change_color(Robot, Color, Color2), -0.0006219914986872083) :- robot_has(Robot, Color3), could_paint_up_for_todo_painted_tile_color(Robot, Color3), todo_painted(Tile, Color), todo_painted(Tile, Color2), !.
delta(14, change_color(Robot, _, _), 0.02985775065736407) :- robot_has(Robot, Color), could_paint_up_for_todo_painted_tile_color(Robot, Color), !.
delta(14, change_color(_, Color, _), -0.09036275568684349) :- goal_painted(Tile, Color), unsettled_before_right_todo_painted(Tile), !.
delta(14, change_color(_, _, Color), -0.0015883046831379592) :- robot_has(_, Color), !.
delta(14, change_color(_, _, _), 0.004114879444900994) :- !.
delta(14, paint_up(Robot, _, Tile, Color), 0.048259076413610436) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(14, paint_up(_, _, _, _), -0.008557982418310297) :- !.
delta(14, paint_down(_, _, _, _), -0.03133369588936141) :- !.
delta(14, move_up(Robot, _, Tile), 0.0003788870556375046) :- todo_painted(Tile, Color), robot_has(Robot, Color), goal_painted(Tile2, Color), needed_robot_at_to_paint_down(Tile2), could_move_right(Robot, Tile2), !.
delta(14, move_up(Robot, _, Tile), -0.02421753784168199) :- todo_painted(Tile, Color), robot_has(Robot, Color), goal_painted(Tile2, Color), needed_robot_at_to_paint_down(Tile2), !.
delta(14, move_up(Robot, _, Tile), 0.0018091291718289042) :- todo_painted(Tile, Color), robot_has(Robot, Color), todo_painted(Tile2, Color), needed_robot_at_to_paint_up(Tile2), !.
delta(14, move_up(Robot, _, Tile), -0.0004393889828664769) :- todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(14, move_up(_, Tile, Tile2), 0.04546762277010967) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(14, move_up(_, _, _), -0.009432456447075748) :- !.
delta(14, move_down(_, Tile, Tile2), -0.024573255770202092) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(14, move_down(_, _, _), 0.01848200876235619) :- !.
delta(14, move_right(_, _, Tile), 0.029153045041962193) :- clear(Tile2), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile, Tile2), !.
delta(14, move_right(Robot, _, Tile), 0.001553582081518385) :- clear(Tile2), toward_could_move_left(Robot, Tile2, Tile), !.
delta(14, move_right(_, _, _), -0.03264037547365852) :- !.
delta(14, move_left(_, Tile, Tile2), 0.0187305616616872) :- clear(Tile3), nearer_robot_at(Tile3, Tile, Tile2), todo_painted(Tile2, Color), needed_robot_has_to_paint_up(Color), !.
delta(14, move_left(_, Tile, Tile2), -0.04554965371909184) :- clear(Tile3), nearer_robot_at(Tile3, Tile, Tile2), !.
delta(14, move_left(_, _, _), 0.0762973886139172) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 237 examples, 24 leaves
delta(15, change_color(Robot, Color, Color2), 0.0017107573421720134) :- goal_painted(Tile, Color2), could_move_right(Robot, Tile), done_painted(Tile2, Color), toward_could_move_right_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(15, change_color(Robot, _, Color), -0.036818263831682775) :- goal_painted(Tile, Color), could_move_right(Robot, Tile), !.
delta(15, change_color(Robot, _, _), -0.006901882048042243) :- robot_has(Robot, Color), could_paint_up_todo_painted(Robot, Color), !.
delta(15, change_color(_, Color, _), -0.004585091400259087) :- todo_painted(Tile, Color), could_move_left_needed_robot_at_to_paint_down(Tile), !.
delta(15, change_color(_, _, _), 0.11094815046506856) :- !.
delta(15, paint_up(Robot, _, Tile, Color), 0.016373521497625405) :- todo_painted(Tile2, Color), toward_could_move_down(Robot, Tile2, Tile), !.
delta(15, paint_up(_, _, _, _), -0.20160061287853018) :- clear(Tile), needed_robot_at_to_paint_down(Tile), !.
delta(15, paint_up(_, Tile, _, Color), 0.01109741584466064) :- todo_painted(Tile, Color), !.
delta(15, paint_up(_, _, _, _), -0.004729609349757381) :- !.
delta(15, paint_down(_, _, _, _), -0.03527732198831956) :- !.
delta(15, move_up(Robot, Tile, Tile2), 0.21162953001572252) :- clear(Tile3), toward_could_move_left_for_todo_painted_tile_any(Robot, Tile3, Tile2), robot_at(Robot2, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot2, Tile, Tile2), !.
delta(15, move_up(Robot, _, Tile), -0.003108631818655733) :- clear(Tile2), toward_could_move_left_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(15, move_up(Robot, _, Tile), -0.07006497252448624) :- todo_painted(Tile, Color), robot_has(Robot, Color), goal_painted(Tile2, Color), needed_robot_at_to_paint_down(Tile2), !.
delta(15, move_up(Robot, _, Tile), 0.0004677388581000364) :- todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(15, move_up(_, Tile, Tile2), 0.019346297063915736) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(15, move_up(_, _, _), -0.002658395888590514) :- !.
delta(15, move_down(_, Tile, Tile2), -0.042418718807197574) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(15, move_down(_, _, _), 0.012647755192285863) :- !.
delta(15, move_right(_, Tile, Tile2), 0.005547898219640323) :- clear(Tile3), nearer_robot_at(Tile3, Tile, Tile2), todo_painted(Tile, Color), needed_robot_has_to_paint_up(Color), !.
delta(15, move_right(_, Tile, Tile2), -0.09620440154323266) :- clear(Tile3), nearer_robot_at(Tile3, Tile, Tile2), !.
delta(15, move_right(_, _, _), 0.11640202799565588) :- !.
delta(15, move_left(Robot, _, Tile), 0.02561636055207942) :- clear(Tile2), toward_could_move_up(Robot, Tile, Tile2), !.
delta(15, move_left(_, _, _), -0.037464429200076456) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 294 examples, 28 leaves
delta(16, change_color(Robot, Color, Color2), -5.880222219367195e-5) :- goal_painted(Tile, Color), could_move_right_needed_robot_at_to_paint_down(Tile), todo_painted(Tile2, Color2), toward_could_move_down_needed_robot_at_to_paint_up(Tile, Tile2), robot_at(Robot, Tile), !.
delta(16, change_color(_, Color, Color2), 0.12433754167884004) :- goal_painted(Tile, Color), could_move_right_needed_robot_at_to_paint_down(Tile), todo_painted(Tile2, Color2), toward_could_move_down_needed_robot_at_to_paint_up(Tile, Tile2), !.
delta(16, change_color(_, Color, _), -0.0011947564654301165) :- goal_painted(Tile, Color), could_move_right_needed_robot_at_to_paint_down(Tile), !.
delta(16, change_color(Robot, Color, _), -0.011881382348521404) :- todo_painted(Tile, Color), robot_at(Robot, Tile), goal_painted(Tile2, Color), could_move_down_for_todo_painted_tile_any_2(Robot, Tile2), !.
delta(16, change_color(Robot, Color, _), 0.023071919966496483) :- todo_painted(Tile, Color), robot_at(Robot, Tile), !.
delta(16, change_color(_, Color, _), 0.008425443481346603) :- goal_painted(Tile, Color), could_move_down_needed_clear_to_move_up_to_paint_down(Tile), !.
delta(16, change_color(_, _, _), -0.17205412640124026) :- !.
delta(16, paint_up(Robot, Tile, _, Color), 0.0007523571691849338) :- goal_painted(Tile2, Color), could_move_down_for_todo_painted_tile_any_2(Robot, Tile2), todo_painted(Tile, Color2), done_painted(Tile2, Color2), !.
delta(16, paint_up(Robot, _, _, Color), -0.7064955589220181) :- goal_painted(Tile, Color), could_move_down_for_todo_painted_tile_any_2(Robot, Tile), !.
delta(16, paint_up(Robot, _, Tile, Color), 0.04366822054157276) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(16, paint_up(_, _, _, _), -0.0029311783983851365) :- !.
delta(16, paint_down(_, _, _, _), -0.021483906347860692) :- !.
delta(16, move_up(Robot, Tile, Tile2), 0.22019820820256797) :- clear(Tile3), toward_could_move_left_for_todo_painted_tile_any(Robot, Tile3, Tile2), robot_at(Robot2, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot2, Tile, Tile2), !.
delta(16, move_up(Robot, _, Tile), -0.003372175118963427) :- clear(Tile2), toward_could_move_left_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(16, move_up(_, Tile, _), 0.0006956243107546244) :- clear(Tile2), beyond_right(Tile2, _), toward_could_move_right_needed_robot_at_to_paint_up(Tile, Tile2), !.
delta(16, move_up(_, _, _), -0.07063958086148149) :- clear(Tile), beyond_right(Tile, _), !.
delta(16, move_up(_, Tile, Tile2), 0.004104312519846994) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(16, move_up(_, _, _), -0.0015462102141753633) :- !.
delta(16, move_down(_, Tile, Tile2), -0.02723248929014888) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(16, move_down(_, _, _), 0.03116372596145392) :- !.
delta(16, move_right(_, Tile, Tile2), -0.0989028218786989) :- robot_at(Robot, Tile), toward_could_move_down_for_todo_painted_tile_any(Robot, Tile, Tile2), !.
delta(16, move_right(_, Tile, _), -0.0100674984069495) :- robot_at(Robot, Tile), could_move_up(Robot, Tile), !.
delta(16, move_right(_, Tile, Tile2), -0.00011944006702586708) :- robot_at(Robot, Tile), toward_could_move_down(Robot, Tile2, Tile), !.
delta(16, move_right(_, _, _), 0.4723034867192516) :- !.
delta(16, move_left(_, Tile, _), -0.03385211405216297) :- robot_at(Robot, Tile), could_move_up(Robot, Tile), !.
delta(16, move_left(_, Tile, Tile2), -0.0013216924771205225) :- robot_at(Robot, Tile), toward_could_move_down(Robot, Tile2, Tile), !.
delta(16, move_left(_, _, _), 0.34980124690393466) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 288 examples, 24 leaves
delta(17, change_color(Robot, Color, Color2), -8.57715226970992e-5) :- robot_has(Robot2, Color), could_paint_down_for_todo_painted_tile_color(Robot2, Color), could_paint_up_todo_painted(Robot, Color2), todo_painted(Tile, Color), todo_painted(Tile, Color2), !.
delta(17, change_color(Robot, Color, Color2), 0.1337822214480843) :- robot_has(Robot2, Color), could_paint_down_for_todo_painted_tile_color(Robot2, Color), could_paint_up_todo_painted(Robot, Color2), !.
delta(17, change_color(Robot, Color, _), -0.011900240001518472) :- robot_has(Robot2, Color), could_paint_down_for_todo_painted_tile_color(Robot2, Color), robot_at(Robot, Tile), could_move_down(Robot, Tile), !.
delta(17, change_color(_, Color, _), 0.00568055249397626) :- robot_has(Robot, Color), could_paint_down_for_todo_painted_tile_color(Robot, Color), !.
delta(17, change_color(Robot, Color, Color2), -0.00014704031617827386) :- robot_at(Robot, Tile), could_move_left_needed_robot_at_to_paint_down(Tile), todo_painted(Tile2, Color), todo_painted(Tile2, Color2), !.
delta(17, change_color(Robot, _, _), 0.015763165844457205) :- robot_at(Robot, Tile), could_move_left_needed_robot_at_to_paint_down(Tile), !.
delta(17, change_color(_, _, _), -0.13564701504443016) :- clear(Tile), needed_robot_at_to_paint_up(Tile), !.
delta(17, change_color(_, _, _), 0.0037397249925474408) :- !.
delta(17, paint_up(Robot, _, Tile, Color), 0.07879678056558338) :- todo_painted(Tile2, Color), toward_could_move_up(Robot, Tile2, Tile), !.
delta(17, paint_up(_, _, _, _), -0.011363978624879) :- !.
delta(17, paint_down(_, _, _, _), -0.033839103524423306) :- !.
delta(17, move_up(_, _, Tile), -0.20341030632681048) :- todo_painted(Tile, Color), robot_has(_, Color), !.
delta(17, move_up(_, Tile, Tile2), 0.03237230042543152) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(17, move_up(_, _, _), -0.01237684459358153) :- !.
delta(17, move_down(_, Tile, Tile2), -0.06359554394020059) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(17, move_down(_, _, _), 0.06772336239338714) :- !.
delta(17, move_right(_, Tile, _), -0.03177552031305384) :- clear(Tile2), toward_could_move_left_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(17, move_right(_, Tile, Tile2), -0.005184225504025939) :- robot_at(Robot, Tile), toward_could_move_down_for_todo_painted_tile_any_2(Robot, Tile, Tile2), clear(Tile3), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile3, Tile2), !.
delta(17, move_right(_, Tile, Tile2), 0.19414441818141398) :- robot_at(Robot, Tile), toward_could_move_down_for_todo_painted_tile_any_2(Robot, Tile, Tile2), !.
delta(17, move_right(_, _, _), -0.029486699371128106) :- !.
delta(17, move_left(_, _, Tile), 0.01978279152364671) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(17, move_left(_, Tile, Tile2), -0.012460488073776439) :- robot_at(Robot, Tile), toward_could_move_right(Robot, Tile, Tile2), !.
delta(17, move_left(_, _, _), 0.0013442598660830427) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 277 examples, 32 leaves
delta(18, change_color(Robot, _, Color), -0.011987871454906282) :- could_paint_up_todo_painted(Robot, Color), robot_at(Robot, Tile), could_move_up_needed_robot_at_to_paint_up(Tile), !.
delta(18, change_color(Robot, Color, Color2), -0.003478695067400128) :- could_paint_up_todo_painted(Robot, Color2), todo_painted(Tile, Color), todo_painted(Tile, Color2), !.
delta(18, change_color(Robot, _, Color), 0.15086735949675018) :- could_paint_up_todo_painted(Robot, Color), !.
delta(18, change_color(Robot, _, Color), -0.0003402774841234324) :- robot_at(Robot, Tile), could_move_left_needed_robot_at_to_paint_down(Tile), todo_painted(Tile2, Color), needed_robot_at_to_paint_up(Tile2), !.
delta(18, change_color(Robot, _, _), 0.01377842605034096) :- robot_at(Robot, Tile), could_move_left_needed_robot_at_to_paint_down(Tile), !.
delta(18, change_color(_, _, _), -0.12210166829776094) :- !.
delta(18, paint_up(Robot, Tile, Tile2, _), -0.28366194569690295) :- robot_at(Robot2, Tile2), toward_could_move_up_for_todo_painted_tile_any(Robot2, Tile2, Tile), robot_at(Robot, Tile3), toward_could_move_up_needed_robot_at_to_paint_up(Tile, Tile3), !.
delta(18, paint_up(_, Tile, Tile2, _), 0.0020124743347495386) :- robot_at(Robot, Tile2), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(18, paint_up(_, Tile, _, Color), 0.06867147816609236) :- todo_painted(Tile, Color), !.
delta(18, paint_up(_, _, _, _), -0.00798856929971413) :- !.
delta(18, paint_down(_, _, _, _), -0.030485043259673557) :- !.
delta(18, move_up(_, Tile, Tile2), -0.002711534673575175) :- clear(Tile3), toward_could_move_left_needed_robot_at_to_paint_down(Tile3, Tile2), todo_painted(Tile, _), !.
delta(18, move_up(_, _, Tile), 0.09795840981273153) :- clear(Tile2), toward_could_move_left_needed_robot_at_to_paint_down(Tile2, Tile), !.
delta(18, move_up(Robot, _, Tile), -6.953959795483892e-5) :- todo_painted(Tile, Color), robot_has(Robot, Color), fewer_robot_has_1_than_todo_painted_2, !.
delta(18, move_up(Robot, _, Tile), -0.2299986212668769) :- todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(18, move_up(_, Tile, Tile2), 0.015117953329111332) :- robot_at(Robot, Tile), could_move_up(Robot, Tile2), !.
delta(18, move_up(_, _, _), -0.0058815744642067794) :- !.
delta(18, move_down(Robot, Tile, Tile2), 0.004865256394194717) :- clear(Tile3), toward_could_move_down_for_todo_painted_tile_any_2(Robot, Tile, Tile3), robot_at(Robot2, Tile), toward_could_move_up(Robot2, Tile, Tile2), !.
delta(18, move_down(Robot, Tile, _), -0.06360595939851867) :- clear(Tile2), toward_could_move_down_for_todo_painted_tile_any_2(Robot, Tile, Tile2), !.
delta(18, move_down(Robot, Tile, _), -0.005749049629460632) :- todo_painted(Tile, Color), could_paint_up(Robot, Color), !.
delta(18, move_down(_, _, _), 0.05941739090822469) :- !.
delta(18, move_right(_, Tile, _), 0.35154879229673747) :- todo_painted(Tile, Color), needed_robot_has_to_paint_up(Color), todo_painted(Tile2, Color), clear(Tile2), !.
delta(18, move_right(_, Tile, _), -0.003875858340861801) :- todo_painted(Tile, Color), needed_robot_has_to_paint_up(Color), !.
delta(18, move_right(Robot, _, Tile), -0.002861772420994606) :- clear(Tile2), toward_could_move_right_needed_robot_at_to_paint_up(Tile2, Tile), todo_painted(Tile2, Color), could_paint_up(Robot, Color), !.
delta(18, move_right(_, _, Tile), 0.023430496197294752) :- clear(Tile2), toward_could_move_right_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(18, move_right(_, _, _), -0.09718855134929949) :- !.
delta(18, move_left(Robot, Tile, Tile2), -0.010808537225649601) :- clear(Tile3), toward_could_move_left_needed_robot_at_to_paint_up(Tile3, Tile2), todo_painted(Tile, Color), could_paint_up(Robot, Color), !.
delta(18, move_left(_, _, Tile), 0.1760451346692177) :- clear(Tile2), toward_could_move_left_needed_robot_at_to_paint_up(Tile2, Tile), !.
delta(18, move_left(Robot, _, Tile), -0.0012311127839043047) :- todo_painted(Tile, Color), robot_has(Robot, Color), todo_painted(Tile2, Color), needed_robot_at_to_paint_down(Tile2), !.
delta(18, move_left(Robot, _, Tile), 0.015145984126417664) :- todo_painted(Tile, Color), robot_has(Robot, Color), !.
delta(18, move_left(_, _, _), -0.10965051646367138) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 212 examples, 25 leaves
delta(19, change_color(Robot, Color, Color2), -0.001246195243981486) :- robot_has(Robot, Color3), could_paint_up_for_todo_painted_tile_color(Robot, Color3), todo_painted(Tile, Color), todo_painted(Tile, Color2), !.
delta(19, change_color(Robot, _, _), 0.02109543645302948) :- robot_has(Robot, Color), could_paint_up_for_todo_painted_tile_color(Robot, Color), !.
delta(19, change_color(_, _, _), -0.09988568709155941) :- clear(Tile), needed_robot_at_to_paint_up(Tile), !.
delta(19, change_color(Robot, _, Color), 0.012452874793572008) :- could_paint_up_todo_painted(Robot, Color), !.
delta(19, change_color(_, _, _), -0.008604272592069816) :- !.
delta(19, paint_up(_, Tile, Tile2, _), -0.1988391283912898) :- robot_at(Robot, Tile2), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(19, paint_up(_, Tile, _, Color), 0.09829227601277381) :- todo_painted(Tile, Color), !.
delta(19, paint_up(_, _, _, _), -0.006151278051952249) :- !.
delta(19, paint_down(_, _, _, _), -0.013863612374294182) :- !.
delta(19, move_up(_, Tile, Tile2), 0.07574902368365913) :- fewer_robot_has_1_than_todo_painted_2, robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile, Tile2), !.
delta(19, move_up(_, _, _), -0.0020187610683459617) :- fewer_robot_has_1_than_todo_painted_2, !.
delta(19, move_up(_, Tile, Tile2), -0.00026554808031343765) :- clear(Tile3), toward_could_move_left_needed_robot_at_to_paint_down(Tile3, Tile2), todo_painted(Tile, _), !.
delta(19, move_up(_, _, Tile), 0.007679677513218665) :- clear(Tile2), toward_could_move_left_needed_robot_at_to_paint_down(Tile2, Tile), !.
delta(19, move_up(_, Tile, _), 9.650088181195386e-5) :- clear(Tile2), toward_could_move_left_needed_robot_at_to_paint_down(Tile2, Tile), !.
delta(19, move_up(_, _, _), -0.09494137998581052) :- !.
delta(19, move_down(_, Tile, Tile2), -0.024256988583491693) :- robot_at(Robot, Tile), toward_could_move_up_for_todo_painted_tile_any(Robot, Tile2, Tile), !.
delta(19, move_down(_, _, _), 0.05143401365882965) :- !.
delta(19, move_right(Robot, Tile, Tile2), -0.01734403728636104) :- clear(Tile3), toward_could_move_right_needed_robot_at_to_paint_down(Tile3, Tile2), todo_painted(Tile, Color), could_paint_up(Robot, Color), !.
delta(19, move_right(_, _, Tile), 0.2095658469920857) :- clear(Tile2), toward_could_move_right_needed_robot_at_to_paint_down(Tile2, Tile), !.
delta(19, move_right(Robot, Tile, Tile2), -0.0007833129480893566) :- robot_at(Robot, Tile3), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile3, Tile2), todo_painted(Tile, Color), could_paint_down(Robot, Color), !.
delta(19, move_right(Robot, _, Tile), 0.0012493500160528155) :- robot_at(Robot, Tile2), toward_could_move_down_needed_clear_to_move_up_to_paint_down(Tile2, Tile), !.
delta(19, move_right(_, _, _), -0.07953018733515256) :- !.
delta(19, move_left(_, _, Tile), 0.08429674542425268) :- todo_painted(Tile, Color), done_painted(_, Color), !.
delta(19, move_left(_, _, _), -0.014949010870870855) :- !.
delta(19, _, 0.0).
