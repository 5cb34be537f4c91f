% SHA-256 of what follows: d8d395bc402f1718b8e9c3a70f97095b33f2cefb0d15a4b1bdc046c6e55c7709
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
model(domain, 'satellite.pl').
model(domain_sha256, ee221948c83e4a61662d163688d8457b59b482c752f176e8c6559cc0d4596c93).
model(action, turn_to(satellite, direction, direction)).
model(action, switch_on(instrument, satellite)).
model(action, switch_off(instrument, satellite)).
model(action, calibrate(satellite, instrument, direction)).
model(action, take_image(satellite, direction, instrument, is_mode)).
model(literal, todo_pointing(satellite, direction)).
model(literal, goal_pointing(satellite, direction)).
model(literal, done_pointing(satellite, direction)).
model(literal, todo_have_image(direction, is_mode)).
model(literal, goal_have_image(direction, is_mode)).
model(literal, done_have_image(direction, is_mode)).
model(literal, pointing(satellite, direction)).
model(literal, power_avail(satellite)).
model(literal, power_on(instrument)).
model(literal, calibrated(instrument)).
model(literal, have_image(direction, is_mode)).
model(literal, on_board(instrument, satellite)).
model(literal, supports(instrument, is_mode)).
model(literal, calibration_target(instrument, direction)).
model(literal, needed_calibrated_to_take_image(instrument)).
model(literal, needed_power_on_to_take_image(instrument)).
model(literal, needed_pointing_to_take_image(satellite, direction)).
model(literal, needed_power_on_to_calibrate_to_take_image(instrument)).
model(literal, needed_pointing_to_calibrate_to_take_image(satellite, direction)).
model(literal, needed_power_avail_to_switch_on_to_take_image(satellite)).
model(literal, wanted_pointing(satellite, direction)).
model(literal, could_calibrate(satellite, direction)).
model(literal, could_calibrate_needed_calibrated_to_take_image(satellite, direction)).
model(literal, could_calibrate_for_todo_have_image_direction_any(satellite, direction)).
model(literal, could_calibrate_through_supports_for_todo_have_image_2_instrument(satellite, direction)).
model(literal, could_take_image(satellite, direction)).
model(literal, could_take_image_todo_have_image(satellite, direction)).
model(literal, could_take_image_for_todo_have_image_any_is_mode(satellite, direction)).
model(literal, could_take_image_for_todo_have_image_direction_any(satellite, direction)).
model(literal, could_take_image_through_calibration_target_for_todo_have_image_1_instrument(satellite, direction)).
model(literal, fewer_pointing_2_than_todo_pointing_1).
model(literal, fewer_pointing_2_than_pointing_1).
model(literal, fewer_pointing_2_than_todo_pointing_2).
model(literal, fewer_pointing_1_than_todo_have_image_1).
model(literal, fewer_calibrated_than_todo_have_image_1).
model(literal, fewer_calibrated_than_pointing_2).
model(literal, fewer_calibrated_than_todo_have_image_1_pointing_2).
model(literal, fewer_power_on_than_todo_have_image_1).
model(literal, fewer_power_on_than_pointing_2).
model(literal, fewer_power_on_than_todo_have_image_1_pointing_2).
model(literal, fewer_calibrated_power_on_than_todo_have_image_1).
model(literal, fewer_calibrated_power_on_than_pointing_2).
model(literal, fewer_calibrated_power_on_than_todo_have_image_1_pointing_2).
model(literal, fewer_calibrated_than_todo_have_image_2).
model(literal, fewer_power_on_than_todo_have_image_2).
model(literal, fewer_calibrated_power_on_than_todo_have_image_2).
model(bias, 'satellite.yaml').
model(bias_sha256, '51518259e9d5a1a196c52c5a3fbef9eb3f79d4c1f585f2fc9ea84bfb2a8c8c47').
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
model(trained_episodes, 643).
model(trees, 47).

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

domain(satellite).
:- ensure_loaded('satellite.pl').
:- add_import_module(policy, satellite, start).

% tree 1: step size 1.0, 214 examples, 13 leaves
delta(1, turn_to(Satellite, Direction, _), -0.024383388034192356) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(1, turn_to(Satellite, Direction, Direction2), -0.006302057071717961) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), done_pointing(Satellite2, Direction2), power_avail(Satellite2), !.
delta(1, turn_to(Satellite, Direction, _), 0.7174756020208262) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(1, turn_to(_, Direction, _), -0.0006519870571947961) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(1, turn_to(_, _, _), -0.5265332258038339) :- !.
delta(1, switch_on(_, Satellite), -0.21580799796427744) :- todo_pointing(Satellite, _), !.
delta(1, switch_on(Instrument, _), -0.10095086894478515) :- calibrated(Instrument), !.
delta(1, switch_on(_, _), 0.468593126520948) :- !.
delta(1, switch_off(_, _), -0.6067071323048188) :- !.
delta(1, calibrate(_, _, Direction), 0.3485791201597796) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(1, calibrate(_, _, _), -0.31209662873702704) :- !.
delta(1, take_image(_, _, _, _), 0.08808880793161415) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 219 examples, 12 leaves
delta(2, turn_to(Satellite, Direction, _), -0.1141209495487206) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), goal_have_image(Direction, Is_mode), done_have_image(Direction, Is_mode), !.
delta(2, turn_to(Satellite, Direction, _), -0.04343683214146897) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), todo_pointing(Satellite2, Direction), could_take_image(Satellite2, Direction), !.
delta(2, turn_to(Satellite, Direction, _), 0.8051906014220536) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(2, turn_to(_, _, _), -0.6123206933038254) :- !.
delta(2, switch_on(Instrument, _), 0.3804717074712546) :- calibration_target(Instrument, Direction), todo_have_image(Direction, _), !.
delta(2, switch_on(_, _), -0.4094601221595714) :- !.
delta(2, switch_off(_, _), -0.6087052422882412) :- !.
delta(2, calibrate(_, _, Direction), 0.3782046406444065) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(2, calibrate(_, _, _), -0.23936727550422907) :- !.
delta(2, take_image(_, Direction, _, _), 0.3316632047951558) :- pointing(Satellite, Direction), could_take_image_for_todo_have_image_any_is_mode(Satellite, Direction), !.
delta(2, take_image(_, _, _, _), -0.12360487190338308) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 213 examples, 16 leaves
delta(3, turn_to(Satellite, Direction, Direction2), -0.04900219872376017) :- pointing(Satellite2, Direction2), could_take_image_todo_have_image(Satellite2, Direction), goal_pointing(Satellite, Direction2), !.
delta(3, turn_to(_, Direction, Direction2), 0.8480084342243989) :- pointing(Satellite, Direction2), could_take_image_todo_have_image(Satellite, Direction), !.
delta(3, turn_to(Satellite, Direction, _), 0.4066396054265784) :- todo_pointing(Satellite, Direction), !.
delta(3, turn_to(Satellite, Direction, _), 0.1320683012475472) :- could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(3, turn_to(_, _, _), -0.565312438246097) :- !.
delta(3, switch_on(Instrument, _), 0.35072726536786) :- calibration_target(Instrument, Direction), todo_have_image(Direction, _), !.
delta(3, switch_on(_, _), -0.3132102301723203) :- power_avail(Satellite), goal_pointing(Satellite, _), !.
delta(3, switch_on(_, Satellite), -0.024818281369351193) :- pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(3, switch_on(_, _), 0.026005162860737105) :- !.
delta(3, switch_off(_, _), -0.4400846947322115) :- !.
delta(3, calibrate(Satellite, _, Direction), -0.06557570871702788) :- pointing(Satellite2, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite2, Direction), goal_pointing(Satellite, Direction), !.
delta(3, calibrate(_, _, Direction), 0.3885147017402738) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(3, calibrate(_, _, _), -0.2019938709822015) :- !.
delta(3, take_image(_, Direction, _, Is_mode), 0.42106509212420046) :- todo_have_image(Direction, Is_mode), !.
delta(3, take_image(_, _, _, _), -0.805948116137694) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 219 examples, 29 leaves
delta(4, turn_to(_, Direction, _), -0.038435233547414134) :- pointing(Satellite, Direction), todo_pointing(Satellite, _), fewer_pointing_2_than_pointing_1, fewer_power_on_than_todo_have_image_1, !.
delta(4, turn_to(_, Direction, _), 1.1702742634156107) :- pointing(Satellite, Direction), todo_pointing(Satellite, _), fewer_pointing_2_than_pointing_1, !.
delta(4, turn_to(_, Direction, _), 0.202198168186611) :- pointing(Satellite, Direction), todo_pointing(Satellite, _), fewer_calibrated_power_on_than_todo_have_image_1_pointing_2, !.
delta(4, turn_to(_, Direction, _), -0.1667300524714997) :- pointing(Satellite, Direction), todo_pointing(Satellite, _), !.
delta(4, turn_to(_, Direction, Direction2), 0.5705072883963587) :- calibrated(Instrument), calibration_target(Instrument, Direction2), on_board(Instrument, Satellite), could_take_image_todo_have_image(Satellite, Direction), !.
delta(4, turn_to(_, _, Direction), 0.010539847155110492) :- calibrated(Instrument), calibration_target(Instrument, Direction), !.
delta(4, turn_to(_, Direction, _), 0.23736074239279062) :- goal_pointing(_, Direction), !.
delta(4, turn_to(_, _, _), -0.6768408320033106) :- !.
delta(4, switch_on(_, Satellite), -0.07110513138795) :- fewer_power_on_than_pointing_2, pointing(Satellite, Direction), calibration_target(Instrument, Direction), power_on(Instrument), !.
delta(4, switch_on(_, Satellite), 0.5239811575956266) :- fewer_power_on_than_pointing_2, pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(4, switch_on(_, Satellite), 0.007513868260936714) :- fewer_power_on_than_pointing_2, todo_pointing(Satellite, _), !.
delta(4, switch_on(_, _), -0.4599299689369589) :- fewer_power_on_than_pointing_2, !.
delta(4, switch_on(Instrument, _), 0.02572179533788141) :- calibration_target(Instrument, Direction), todo_have_image(Direction, _), !.
delta(4, switch_on(_, _), -0.5706281581783554) :- !.
delta(4, switch_off(Instrument, Satellite), -0.3187875377212497) :- calibration_target(Instrument, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), on_board(Instrument, Satellite2), needed_pointing_to_calibrate_to_take_image(Satellite2, Direction), !.
delta(4, switch_off(Instrument, Satellite), -0.13661874606943075) :- calibration_target(Instrument, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), goal_pointing(Satellite, _), !.
delta(4, switch_off(Instrument, Satellite), 0.5022853438116289) :- calibration_target(Instrument, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(4, switch_off(_, _), -0.6320386718320243) :- !.
delta(4, calibrate(_, _, Direction), 0.0765237069365618) :- goal_pointing(_, Direction), todo_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(4, calibrate(_, _, Direction), -0.5796177635751066) :- goal_pointing(_, Direction), !.
delta(4, calibrate(Satellite, _, _), -0.07335559948579028) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(4, calibrate(Satellite, _, _), 0.6270320066616561) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(4, calibrate(_, _, _), -0.2419679222236553) :- !.
delta(4, take_image(Satellite, _, Instrument, Is_mode), -0.5936522240605144) :- todo_have_image(Direction, Is_mode), needed_pointing_to_take_image(Satellite, Direction), pointing(Satellite, Direction2), calibration_target(Instrument, Direction2), !.
delta(4, take_image(Satellite, _, _, Is_mode), 0.024239866379701575) :- todo_have_image(Direction, Is_mode), needed_pointing_to_take_image(Satellite, Direction), !.
delta(4, take_image(_, Direction, _, _), -0.12498855700280913) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(4, take_image(_, Direction, _, _), 0.5414832446957927) :- pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(4, take_image(_, _, _, _), -0.03121885425427739) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 210 examples, 26 leaves
delta(5, turn_to(Satellite, Direction, Direction2), -0.1147003185278225) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), todo_pointing(Satellite, _), could_take_image_todo_have_image(Satellite, Direction2), !.
delta(5, turn_to(Satellite, Direction, _), 0.30598434513055983) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), todo_pointing(Satellite, _), !.
delta(5, turn_to(Satellite, Direction, _), 0.20940227735767533) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), todo_have_image(Direction, _), !.
delta(5, turn_to(Satellite, Direction, _), -0.7530350387201453) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(5, turn_to(_, _, Direction), -0.3163956830686171) :- goal_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(5, turn_to(_, Direction, _), -0.19005055998034626) :- power_avail(Satellite), needed_pointing_to_take_image(Satellite, Direction), !.
delta(5, turn_to(_, _, _), 0.5921012577437712) :- !.
delta(5, switch_on(Instrument, _), -0.4363388413060546) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), fewer_power_on_than_pointing_2, !.
delta(5, switch_on(Instrument, _), -0.026924302171964835) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(5, switch_on(Instrument, _), 0.1377484878083145) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), !.
delta(5, switch_on(_, Satellite), 0.596033248576655) :- pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(5, switch_on(_, Satellite), 0.0261446227835904) :- todo_pointing(Satellite, _), !.
delta(5, switch_on(_, _), -0.18365042947008037) :- !.
delta(5, switch_off(_, Satellite), 0.072225045036618) :- done_pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(5, switch_off(Instrument, Satellite), 0.08665395058056258) :- calibration_target(Instrument, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), power_on(Instrument2), calibrated(Instrument2), !.
delta(5, switch_off(Instrument, Satellite), -0.07215847798018284) :- calibration_target(Instrument, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(5, switch_off(_, _), 0.023861318284757325) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(5, switch_off(_, _), -0.49132503418323176) :- !.
delta(5, calibrate(_, _, Direction), 0.2764736774188248) :- calibration_target(Instrument, Direction), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(5, calibrate(_, _, Direction), 0.12515782978351989) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(5, calibrate(_, _, _), -0.7197968117564741) :- !.
delta(5, take_image(Satellite, Direction, _, Is_mode), -0.024846823325394528) :- todo_have_image(Direction2, Is_mode), pointing(_, Direction2), goal_pointing(Satellite, Direction), !.
delta(5, take_image(_, Direction, _, Is_mode), -0.00991363479015042) :- todo_have_image(Direction2, Is_mode), pointing(Satellite, Direction2), todo_pointing(Satellite, Direction), !.
delta(5, take_image(_, _, _, Is_mode), 0.39250103503789513) :- todo_have_image(Direction, Is_mode), pointing(_, Direction), !.
delta(5, take_image(_, _, _, _), -0.37076957032722835) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 204 examples, 31 leaves
delta(6, turn_to(Satellite, Direction, Direction2), 0.0625132934141859) :- pointing(Satellite2, Direction2), could_take_image(Satellite2, Direction), on_board(Instrument, Satellite), calibration_target(Instrument, Direction), fewer_power_on_than_pointing_2, !.
delta(6, turn_to(Satellite, Direction, Direction2), -0.21479812053756236) :- pointing(Satellite2, Direction2), could_take_image(Satellite2, Direction), on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(6, turn_to(_, Direction, Direction2), -0.07913478966686939) :- pointing(Satellite, Direction2), could_take_image(Satellite, Direction), goal_pointing(Satellite2, Direction), could_take_image_for_todo_have_image_any_is_mode(Satellite2, Direction), !.
delta(6, turn_to(_, Direction, Direction2), 0.6100306630943166) :- pointing(Satellite, Direction2), could_take_image(Satellite, Direction), !.
delta(6, turn_to(Satellite, Direction, _), 0.14525129563688288) :- pointing(Satellite, Direction2), calibration_target(_, Direction2), todo_pointing(Satellite, Direction), !.
delta(6, turn_to(Satellite, _, _), -0.669382406461143) :- pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(6, turn_to(_, _, _), -0.271886673631262) :- power_on(Instrument), calibrated(Instrument), !.
delta(6, turn_to(_, _, _), 0.3459380101146374) :- !.
delta(6, switch_on(_, Satellite), 0.03197390857060566) :- goal_pointing(Satellite, Direction), pointing(Satellite2, Direction), could_calibrate(Satellite2, Direction), !.
delta(6, switch_on(Instrument, Satellite), -0.014554528270381376) :- goal_pointing(Satellite, Direction), pointing(_, Direction), needed_power_on_to_take_image(Instrument), !.
delta(6, switch_on(_, Satellite), -0.6059503182007823) :- goal_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(6, switch_on(_, Satellite), 0.14115941427317188) :- pointing(Satellite, Direction), goal_pointing(Satellite2, Direction), could_take_image_for_todo_have_image_any_is_mode(Satellite2, Direction), !.
delta(6, switch_on(_, Satellite), -0.2861084960270202) :- pointing(Satellite, Direction), goal_pointing(_, Direction), !.
delta(6, switch_on(Instrument, Satellite), -0.06096817583186706) :- calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(6, switch_on(_, _), 0.299822097852504) :- !.
delta(6, switch_off(Instrument, Satellite), -0.03093061407796197) :- calibration_target(Instrument, Direction), pointing(_, Direction), fewer_calibrated_than_pointing_2, could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(6, switch_off(Instrument, _), 0.39383214983686077) :- calibration_target(Instrument, Direction), pointing(_, Direction), fewer_calibrated_than_pointing_2, !.
delta(6, switch_off(Instrument, _), -0.04924120462098358) :- calibration_target(Instrument, Direction), pointing(_, Direction), !.
delta(6, switch_off(Instrument, _), 0.11884384066965654) :- power_avail(Satellite), done_pointing(Satellite, _), needed_calibrated_to_take_image(Instrument), !.
delta(6, switch_off(_, _), -0.01445303143860004) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(6, switch_off(_, _), -0.3043978105738401) :- !.
delta(6, calibrate(Satellite, _, _), 0.4251429993980006) :- on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(6, calibrate(_, _, _), 0.07896624928597805) :- fewer_pointing_2_than_pointing_1, power_avail(Satellite), todo_pointing(Satellite, _), !.
delta(6, calibrate(_, _, _), -0.4004463467078769) :- fewer_pointing_2_than_pointing_1, !.
delta(6, calibrate(_, _, Direction), -0.12488262277922332) :- goal_pointing(_, Direction), !.
delta(6, calibrate(_, _, _), 0.2111436830822679) :- !.
delta(6, take_image(_, Direction, _, Is_mode), 0.49071120462690426) :- todo_have_image(Direction, Is_mode), !.
delta(6, take_image(Satellite, _, Instrument, _), -0.01059744209831915) :- calibration_target(Instrument, Direction), todo_pointing(_, Direction), todo_pointing(Satellite, Direction), !.
delta(6, take_image(_, _, Instrument, _), 0.06928933733386901) :- calibration_target(Instrument, Direction), todo_pointing(_, Direction), !.
delta(6, take_image(_, _, _, _), -0.21527869035750485) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 224 examples, 23 leaves
delta(7, turn_to(Satellite, Direction, Direction2), -0.04488926482419902) :- pointing(Satellite2, Direction), needed_pointing_to_calibrate_to_take_image(Satellite2, Direction2), on_board(Instrument, Satellite), calibration_target(Instrument, Direction2), !.
delta(7, turn_to(_, Direction, Direction2), -0.014118544939079027) :- pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), todo_have_image(Direction, _), !.
delta(7, turn_to(_, Direction, Direction2), 0.9809078255599204) :- pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), !.
delta(7, turn_to(Satellite, Direction, _), -0.021462462058180448) :- could_take_image_todo_have_image(Satellite, Direction), goal_pointing(Satellite, Direction2), have_image(Direction2, _), !.
delta(7, turn_to(Satellite, Direction, _), 0.4943375739867495) :- could_take_image_todo_have_image(Satellite, Direction), !.
delta(7, turn_to(Satellite, Direction, _), 0.20254378057426053) :- todo_pointing(Satellite, Direction), !.
delta(7, turn_to(_, _, _), -0.38459870884327263) :- !.
delta(7, switch_on(_, Satellite), -0.09239098243955841) :- todo_pointing(Satellite, Direction), pointing(Satellite2, Direction), power_avail(Satellite2), !.
delta(7, switch_on(Instrument, Satellite), -0.004145624606725912) :- todo_pointing(Satellite, Direction), pointing(_, Direction), calibration_target(Instrument, Direction), !.
delta(7, switch_on(_, Satellite), 0.30212538259174176) :- todo_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(7, switch_on(Instrument, _), 0.11213605228997055) :- calibration_target(Instrument, Direction), todo_have_image(Direction, _), calibrated(Instrument), !.
delta(7, switch_on(Instrument, _), -0.030235797051563464) :- calibration_target(Instrument, Direction), todo_have_image(Direction, _), !.
delta(7, switch_on(_, _), -0.9146785481469827) :- !.
delta(7, switch_off(_, _), -0.357077781241395) :- !.
delta(7, calibrate(_, _, Direction), -0.11898352698433638) :- goal_pointing(_, Direction), !.
delta(7, calibrate(_, _, _), 0.45771452053910816) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(7, calibrate(_, _, Direction), 0.011689905662217474) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(7, calibrate(_, _, _), -0.08689835372970899) :- !.
delta(7, take_image(_, Direction, _, Is_mode), 0.31025533666077665) :- todo_have_image(Direction, Is_mode), !.
delta(7, take_image(Satellite, Direction, Instrument, _), 0.040859979463391934) :- calibration_target(Instrument, Direction2), todo_pointing(_, Direction2), could_take_image_for_todo_have_image_any_is_mode(Satellite, Direction), !.
delta(7, take_image(_, _, Instrument, _), -0.029437772230153883) :- calibration_target(Instrument, Direction), todo_pointing(_, Direction), !.
delta(7, take_image(_, _, _, _), -0.19259673355856285) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 205 examples, 21 leaves
delta(8, turn_to(Satellite, Direction, _), 0.0954482601772846) :- goal_pointing(Satellite, Direction2), todo_have_image(Direction2, _), todo_pointing(Satellite, Direction), !.
delta(8, turn_to(Satellite, _, _), -0.47838478565891346) :- goal_pointing(Satellite, Direction), todo_have_image(Direction, _), !.
delta(8, turn_to(Satellite, Direction, Direction2), 0.07188868002309606) :- pointing(Satellite, Direction3), could_take_image(Satellite, Direction3), pointing(Satellite2, Direction2), needed_pointing_to_take_image(Satellite2, Direction), !.
delta(8, turn_to(Satellite, _, _), -0.32098743591430073) :- pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(8, turn_to(Satellite, _, _), -0.07521392510840753) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(8, turn_to(_, _, _), 0.6174128729697296) :- !.
delta(8, switch_on(Instrument, _), 0.04984559735379038) :- fewer_pointing_2_than_pointing_1, calibration_target(Instrument, Direction), pointing(_, Direction), fewer_power_on_than_pointing_2, !.
delta(8, switch_on(Instrument, _), -0.11413100927063816) :- fewer_pointing_2_than_pointing_1, calibration_target(Instrument, Direction), pointing(_, Direction), !.
delta(8, switch_on(Instrument, _), 0.00041391961224916777) :- fewer_pointing_2_than_pointing_1, calibrated(Instrument), !.
delta(8, switch_on(_, _), -0.6724272387135266) :- fewer_pointing_2_than_pointing_1, !.
delta(8, switch_on(Instrument, _), -0.06273762865871671) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), !.
delta(8, switch_on(Instrument, _), -0.005772592860949846) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), !.
delta(8, switch_on(_, _), 0.165974481546105) :- !.
delta(8, switch_off(_, _), -0.2415267480101299) :- !.
delta(8, calibrate(_, _, Direction), -0.2627064574226066) :- goal_pointing(_, Direction), !.
delta(8, calibrate(_, _, _), 0.3393145545423403) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(8, calibrate(_, _, Direction), 0.018834929338939335) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(8, calibrate(_, _, _), -0.11319536475324576) :- !.
delta(8, take_image(_, Direction, _, Is_mode), 0.25264029271601446) :- todo_have_image(Direction, Is_mode), !.
delta(8, take_image(_, _, _, _), -0.08728184474687596) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 217 examples, 29 leaves
delta(9, turn_to(Satellite, Direction, Direction2), 0.09335567484978435) :- goal_have_image(Direction, _), on_board(Instrument, Satellite), calibration_target(Instrument, Direction2), could_take_image_for_todo_have_image_any_is_mode(Satellite, Direction2), !.
delta(9, turn_to(Satellite, Direction, Direction2), -0.23368935221812737) :- goal_have_image(Direction, _), on_board(Instrument, Satellite), calibration_target(Instrument, Direction2), !.
delta(9, turn_to(_, Direction, _), -0.0323171346970866) :- goal_have_image(Direction, _), done_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(9, turn_to(_, Direction, _), 0.3209538307373555) :- goal_have_image(Direction, _), !.
delta(9, turn_to(Satellite, Direction, _), -0.004477071192060514) :- goal_pointing(Satellite2, Direction), power_avail(Satellite2), goal_pointing(Satellite2, Direction2), could_take_image(Satellite, Direction2), !.
delta(9, turn_to(_, Direction, _), 0.13842748367678462) :- goal_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(9, turn_to(_, Direction, Direction2), 0.045654396141268296) :- pointing(Satellite, Direction2), could_take_image(Satellite, Direction), !.
delta(9, turn_to(_, _, _), -0.6679391686458752) :- !.
delta(9, switch_on(_, Satellite), 0.007885869763699536) :- todo_pointing(Satellite, Direction), pointing(Satellite2, Direction), could_calibrate_needed_calibrated_to_take_image(Satellite2, Direction), !.
delta(9, switch_on(_, Satellite), -0.1610824069125595) :- todo_pointing(Satellite, _), !.
delta(9, switch_on(Instrument, _), -0.06075206523466115) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), !.
delta(9, switch_on(_, _), 0.6999677537640029) :- fewer_calibrated_power_on_than_pointing_2, !.
delta(9, switch_on(_, _), -0.007577383335317134) :- !.
delta(9, switch_off(_, Satellite), -0.19280482491127393) :- power_avail(Satellite2), pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite2, Direction), !.
delta(9, switch_off(_, Satellite), 0.09773571612170699) :- power_avail(_), pointing(Satellite, Direction), could_calibrate_needed_calibrated_to_take_image(Satellite, Direction), !.
delta(9, switch_off(_, _), -0.06538486350778948) :- power_avail(_), !.
delta(9, switch_off(_, Satellite), 0.06064294573607036) :- fewer_pointing_2_than_pointing_1, pointing(Satellite, Direction), could_calibrate_needed_calibrated_to_take_image(Satellite, Direction), !.
delta(9, switch_off(_, _), -0.00848301032147201) :- fewer_pointing_2_than_pointing_1, !.
delta(9, switch_off(_, _), -0.05052803459204327) :- !.
delta(9, calibrate(_, _, Direction), -0.11046116207711353) :- fewer_calibrated_power_on_than_todo_have_image_1, goal_pointing(_, Direction), fewer_pointing_2_than_pointing_1, !.
delta(9, calibrate(_, _, Direction), 0.02527612101664103) :- fewer_calibrated_power_on_than_todo_have_image_1, goal_pointing(_, Direction), !.
delta(9, calibrate(_, _, _), 0.17519060082284388) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(9, calibrate(_, _, Direction), -0.013214235187447416) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), pointing(Satellite2, Direction), could_take_image(Satellite2, Direction), !.
delta(9, calibrate(_, _, Direction), 0.034556190682456994) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(9, calibrate(_, _, _), -0.38829475563450067) :- !.
delta(9, take_image(_, Direction, _, Is_mode), 0.17837162054983255) :- todo_have_image(Direction, Is_mode), !.
delta(9, take_image(_, _, _, Is_mode), 0.034627557608777296) :- done_have_image(Direction, Is_mode), todo_pointing(_, Direction), !.
delta(9, take_image(_, _, _, _), -0.07798726855241897) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 201 examples, 28 leaves
delta(10, turn_to(Satellite, Direction, Direction2), -0.005061066123627893) :- calibration_target(Instrument, Direction2), needed_calibrated_to_take_image(Instrument), calibration_target(Instrument2, Direction), needed_power_on_to_take_image(Instrument2), goal_pointing(Satellite, Direction2), !.
delta(10, turn_to(_, Direction, Direction2), 0.0715210336445797) :- calibration_target(Instrument, Direction2), needed_calibrated_to_take_image(Instrument), calibration_target(Instrument2, Direction), needed_power_on_to_take_image(Instrument2), !.
delta(10, turn_to(Satellite, Direction, Direction2), 0.01743500198434277) :- calibration_target(Instrument, Direction2), needed_calibrated_to_take_image(Instrument), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(10, turn_to(_, _, Direction), -0.5494004451283196) :- calibration_target(Instrument, Direction), needed_calibrated_to_take_image(Instrument), !.
delta(10, turn_to(_, Direction, _), -0.06201351566533312) :- calibration_target(Instrument, Direction), on_board(Instrument, Satellite), could_take_image(Satellite, Direction), !.
delta(10, turn_to(_, Direction, _), 0.39250754744130745) :- calibration_target(_, Direction), !.
delta(10, turn_to(_, _, Direction), 0.16237316585236236) :- pointing(Satellite, Direction), could_take_image_for_todo_have_image_any_is_mode(Satellite, Direction), !.
delta(10, turn_to(_, _, _), -0.2442899759592337) :- !.
delta(10, switch_on(_, Satellite), -0.47937043006639474) :- goal_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(10, switch_on(Instrument, Satellite), -0.0025707010703348893) :- fewer_calibrated_power_on_than_todo_have_image_1, todo_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(10, switch_on(_, _), 0.4644176005750909) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(10, switch_on(_, Satellite), -0.15224235013699447) :- pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(10, switch_on(_, _), 0.05188073437041172) :- !.
delta(10, switch_off(_, Satellite), -0.19096034958890998) :- pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_power_on_than_pointing_2, !.
delta(10, switch_off(_, Satellite), 0.007733645230761897) :- pointing(Satellite, Direction), calibration_target(_, Direction), goal_pointing(Satellite, Direction), !.
delta(10, switch_off(_, Satellite), -0.005317565833046614) :- pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(10, switch_off(_, Satellite), -0.03555607082524166) :- pointing(Satellite, Direction), goal_have_image(Direction, _), !.
delta(10, switch_off(_, _), 0.33105086386717536) :- fewer_pointing_2_than_pointing_1, !.
delta(10, switch_off(_, _), -0.0018386922194154165) :- !.
delta(10, calibrate(Satellite, _, Direction), 0.25243629274063534) :- goal_pointing(Satellite, Direction2), goal_pointing(Satellite2, Direction2), could_calibrate_needed_calibrated_to_take_image(Satellite2, Direction), !.
delta(10, calibrate(Satellite, _, _), -0.014872886947690735) :- goal_pointing(Satellite, _), !.
delta(10, calibrate(Satellite, _, Direction), 0.02368365765735777) :- pointing(Satellite2, Direction), todo_pointing(Satellite2, Direction2), needed_pointing_to_take_image(Satellite, Direction2), !.
delta(10, calibrate(_, _, Direction), -0.1381370056690996) :- pointing(Satellite, Direction), todo_pointing(Satellite, _), !.
delta(10, calibrate(_, _, Direction), 0.08351207514668778) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(10, calibrate(_, _, _), -0.011688089265669837) :- !.
delta(10, take_image(_, Direction, _, Is_mode), 0.13124564007658884) :- todo_have_image(Direction, Is_mode), !.
delta(10, take_image(_, _, _, _), -0.11523039746281163) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 204 examples, 27 leaves
delta(11, turn_to(Satellite, Direction, Direction2), -0.06605791325611585) :- could_take_image(Satellite, Direction), todo_have_image(Direction2, _), !.
delta(11, turn_to(Satellite, Direction, _), -0.013374951556865496) :- could_take_image(Satellite, Direction), pointing(Satellite2, Direction), could_calibrate(Satellite2, Direction), !.
delta(11, turn_to(Satellite, Direction, _), 0.38456852662744884) :- could_take_image(Satellite, Direction), !.
delta(11, turn_to(_, Direction, _), -0.1251074835091975) :- todo_pointing(Satellite, Direction), pointing(Satellite, Direction2), could_take_image(Satellite, Direction2), !.
delta(11, turn_to(_, Direction, _), 0.19614903321244204) :- todo_pointing(_, Direction), !.
delta(11, turn_to(_, Direction, _), 0.061123148605378194) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(11, turn_to(_, _, _), -0.2992415078183473) :- !.
delta(11, switch_on(Instrument, Satellite), 0.1272925145468831) :- done_pointing(Satellite, Direction), todo_have_image(Direction, _), needed_calibrated_to_take_image(Instrument), !.
delta(11, switch_on(_, Satellite), -0.0005359013321970078) :- done_pointing(Satellite, Direction), todo_have_image(Direction, _), !.
delta(11, switch_on(_, Satellite), -0.017460471712536393) :- on_board(Instrument, Satellite), needed_power_on_to_take_image(Instrument), fewer_pointing_2_than_pointing_1, !.
delta(11, switch_on(_, Satellite), 0.09409371737484593) :- on_board(Instrument, Satellite), needed_power_on_to_take_image(Instrument), !.
delta(11, switch_on(Instrument, _), 0.04421292008342371) :- calibrated(Instrument), !.
delta(11, switch_on(_, _), -0.40945885779939684) :- !.
delta(11, switch_off(Instrument, Satellite), 0.09575902672565798) :- power_avail(Satellite2), todo_pointing(Satellite2, Direction), needed_calibrated_to_take_image(Instrument), needed_pointing_to_take_image(Satellite, Direction), !.
delta(11, switch_off(Instrument, _), -0.0012297608324227753) :- power_avail(Satellite), todo_pointing(Satellite, _), needed_calibrated_to_take_image(Instrument), !.
delta(11, switch_off(_, _), -0.049163435689200355) :- power_avail(Satellite), todo_pointing(Satellite, _), !.
delta(11, switch_off(_, _), -0.18304058538203072) :- !.
delta(11, calibrate(_, _, Direction), -0.015472912711949328) :- calibrated(Instrument), calibration_target(Instrument, Direction), !.
delta(11, calibrate(_, _, Direction), -0.0001982304883817686) :- fewer_calibrated_than_pointing_2, goal_have_image(Direction, Is_mode), done_have_image(Direction, Is_mode), !.
delta(11, calibrate(_, _, _), 0.22324772410407745) :- fewer_calibrated_than_pointing_2, !.
delta(11, calibrate(_, _, _), -0.0045363593565232755) :- !.
delta(11, take_image(_, Direction, _, Is_mode), 0.18143713084718613) :- todo_have_image(Direction, Is_mode), pointing(Satellite, Direction), goal_pointing(Satellite, _), !.
delta(11, take_image(_, Direction, _, Is_mode), -0.025244746553566712) :- todo_have_image(Direction, Is_mode), fewer_power_on_than_pointing_2, !.
delta(11, take_image(_, Direction, _, Is_mode), 0.010849612893307848) :- todo_have_image(Direction, Is_mode), !.
delta(11, take_image(_, Direction, _, _), 0.01493020457252285) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(11, take_image(_, _, _, _), -0.05040735996533971) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 207 examples, 28 leaves
delta(12, turn_to(Satellite, Direction, _), 0.14434185580131798) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), on_board(Instrument, Satellite2), could_calibrate_needed_calibrated_to_take_image(Satellite2, Direction), !.
delta(12, turn_to(Satellite, Direction, Direction2), 0.04176937231764087) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), goal_pointing(Satellite2, Direction2), could_take_image_todo_have_image(Satellite2, Direction), !.
delta(12, turn_to(Satellite, Direction, _), -0.5176718649979588) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(12, turn_to(Satellite, _, _), 0.49798951983986517) :- fewer_pointing_2_than_pointing_1, goal_pointing(Satellite, _), !.
delta(12, turn_to(_, _, _), -0.02420505604358272) :- fewer_pointing_2_than_pointing_1, !.
delta(12, turn_to(_, _, _), -0.23408410530238055) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(12, turn_to(_, _, _), 0.1103825054990257) :- !.
delta(12, switch_on(Instrument, Satellite), 0.02577584760611228) :- calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), pointing(Satellite2, Direction), power_avail(Satellite2), fewer_pointing_2_than_pointing_1, !.
delta(12, switch_on(Instrument, Satellite), -0.0003161601318719043) :- calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), pointing(Satellite2, Direction), power_avail(Satellite2), !.
delta(12, switch_on(Instrument, Satellite), -0.21127923709449714) :- calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), fewer_power_on_than_pointing_2, !.
delta(12, switch_on(Instrument, Satellite), 0.015878999922815006) :- calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(12, switch_on(_, Satellite), -0.022246675616829536) :- fewer_power_on_than_pointing_2, pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(12, switch_on(_, _), 0.22466302239238464) :- fewer_power_on_than_pointing_2, !.
delta(12, switch_on(_, Satellite), 0.004897566411620739) :- goal_pointing(Satellite, Direction), done_pointing(Satellite, Direction), !.
delta(12, switch_on(_, _), -0.05289938574407597) :- !.
delta(12, switch_off(_, Satellite), -0.1305866615592637) :- goal_pointing(Satellite, _), !.
delta(12, switch_off(_, _), -0.019375191069141182) :- fewer_calibrated_power_on_than_todo_have_image_1_pointing_2, !.
delta(12, switch_off(_, _), -0.009737600902147727) :- power_avail(_), !.
delta(12, switch_off(_, _), 0.26785251322468745) :- !.
delta(12, calibrate(Satellite, _, Direction), 0.1502029653072841) :- goal_pointing(Satellite, Direction2), goal_pointing(Satellite2, Direction2), could_calibrate_needed_calibrated_to_take_image(Satellite2, Direction), !.
delta(12, calibrate(Satellite, _, _), -0.02535428629673949) :- goal_pointing(Satellite, _), !.
delta(12, calibrate(_, _, Direction), 0.013705485743005319) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(12, calibrate(_, _, _), 0.003430819558071742) :- fewer_calibrated_power_on_than_todo_have_image_1_pointing_2, !.
delta(12, calibrate(_, _, _), -0.2188331700575812) :- !.
delta(12, take_image(_, Direction, _, Is_mode), 0.17198115917254958) :- todo_have_image(Direction, Is_mode), !.
delta(12, take_image(_, _, _, _), 0.02797399226072117) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(12, take_image(_, _, _, _), -0.08437148829923277) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 204 examples, 27 leaves
delta(13, turn_to(Satellite, Direction, Direction2), -0.14888884566816138) :- could_take_image(Satellite, Direction), todo_have_image(Direction2, _), !.
delta(13, turn_to(Satellite, Direction, _), -0.011433921236095745) :- could_take_image(Satellite, Direction), done_pointing(Satellite, Direction2), have_image(Direction2, _), !.
delta(13, turn_to(Satellite, Direction, _), 0.28526950570006876) :- could_take_image(Satellite, Direction), !.
delta(13, turn_to(Satellite, Direction, _), -0.12706386497211936) :- todo_pointing(_, Direction), todo_pointing(Satellite, Direction2), needed_pointing_to_take_image(Satellite, Direction2), !.
delta(13, turn_to(_, Direction, _), 0.2041977719361314) :- todo_pointing(_, Direction), !.
delta(13, turn_to(_, Direction, _), 0.09749948261473121) :- calibration_target(Instrument, Direction), needed_power_on_to_take_image(Instrument), !.
delta(13, turn_to(_, _, _), -0.49101117130899735) :- !.
delta(13, switch_on(Instrument, Satellite), -0.06344990958108256) :- goal_pointing(Satellite, _), calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), needed_power_on_to_take_image(Instrument), !.
delta(13, switch_on(Instrument, Satellite), 0.016109650530747737) :- goal_pointing(Satellite, _), calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(13, switch_on(Instrument, Satellite), -0.014888318148234471) :- goal_pointing(Satellite, _), todo_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(13, switch_on(_, Satellite), 0.2325589515859268) :- goal_pointing(Satellite, _), !.
delta(13, switch_on(Instrument, _), -0.1679165114777586) :- fewer_power_on_than_pointing_2, calibration_target(Instrument, Direction), pointing(_, Direction), !.
delta(13, switch_on(_, _), 0.027465513914012207) :- fewer_power_on_than_pointing_2, !.
delta(13, switch_on(Instrument, Satellite), -0.012676894569977127) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(13, switch_on(_, _), 0.04561804785545507) :- !.
delta(13, switch_off(Instrument, Satellite), -0.03611947877585118) :- calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(13, switch_off(Instrument, Satellite), -0.007421594049693275) :- calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), todo_have_image(Direction, _), !.
delta(13, switch_off(Instrument, Satellite), 0.25272713702229327) :- calibration_target(Instrument, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(13, switch_off(_, _), -0.21410393810961864) :- !.
delta(13, calibrate(_, _, Direction), 0.0025062274998009135) :- fewer_power_on_than_pointing_2, pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(13, calibrate(_, _, _), -0.07168740754846414) :- fewer_power_on_than_pointing_2, !.
delta(13, calibrate(_, _, Direction), -0.004599665507359755) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), pointing(Satellite2, Direction), could_take_image(Satellite2, Direction), !.
delta(13, calibrate(_, _, Direction), 0.23453295121804557) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(13, calibrate(_, _, _), -0.011899693869929399) :- !.
delta(13, take_image(_, Direction, _, Is_mode), 0.162686321357762) :- todo_have_image(Direction, Is_mode), !.
delta(13, take_image(_, _, _, _), -0.08284584219034116) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 213 examples, 26 leaves
delta(14, turn_to(_, Direction, Direction2), 0.04877722960531076) :- pointing(Satellite, Direction), power_avail(Satellite), pointing(Satellite2, Direction2), could_calibrate_needed_calibrated_to_take_image(Satellite2, Direction), !.
delta(14, turn_to(_, Direction, _), 0.01686987382081494) :- pointing(Satellite, Direction), power_avail(Satellite), todo_have_image(Direction, _), !.
delta(14, turn_to(_, Direction, _), -0.46856166791593407) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(14, turn_to(Satellite, Direction, Direction2), 0.01611678469582341) :- calibrated(Instrument), on_board(Instrument, Satellite), goal_have_image(Direction, Is_mode), have_image(Direction2, Is_mode), !.
delta(14, turn_to(Satellite, _, _), -0.32228073210527575) :- calibrated(Instrument), on_board(Instrument, Satellite), !.
delta(14, turn_to(Satellite, _, Direction), -0.18477934791320177) :- goal_pointing(Satellite, Direction), !.
delta(14, turn_to(_, _, _), 0.6385118751826839) :- !.
delta(14, switch_on(Instrument, Satellite), 0.6503485488180929) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), on_board(Instrument2, Satellite), needed_power_on_to_take_image(Instrument2), !.
delta(14, switch_on(Instrument, Satellite), 0.013602642815645404) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), pointing(Satellite2, Direction), could_calibrate(Satellite2, Direction), !.
delta(14, switch_on(Instrument, Satellite), -0.0317721997569086) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(14, switch_on(_, Satellite), -0.5767891061899932) :- pointing(Satellite, Direction), goal_have_image(Direction, _), !.
delta(14, switch_on(_, Satellite), 0.046601269445662896) :- on_board(Instrument, Satellite), needed_power_on_to_take_image(Instrument), !.
delta(14, switch_on(_, _), -0.030638777222697356) :- !.
delta(14, switch_off(_, Satellite), -0.023943183953259253) :- fewer_power_on_than_pointing_2, pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(14, switch_off(_, _), 0.035252652130297976) :- fewer_power_on_than_pointing_2, !.
delta(14, switch_off(_, _), -0.12782130229166297) :- !.
delta(14, calibrate(_, _, _), 0.0006996931210843908) :- fewer_pointing_2_than_pointing_1, fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(14, calibrate(_, _, _), -0.36034168825967466) :- fewer_pointing_2_than_pointing_1, !.
delta(14, calibrate(_, _, Direction), -0.002254003635576728) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), todo_pointing(_, Direction), !.
delta(14, calibrate(_, _, Direction), 0.10131509880027566) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(14, calibrate(_, _, _), -0.01448958241419869) :- !.
delta(14, take_image(_, Direction, _, Is_mode), 0.15108378057269437) :- todo_have_image(Direction, Is_mode), !.
delta(14, take_image(_, _, _, _), -0.015184099315405679) :- power_avail(Satellite), todo_pointing(Satellite, _), fewer_power_on_than_pointing_2, !.
delta(14, take_image(_, _, _, _), 0.03943651923096136) :- power_avail(Satellite), todo_pointing(Satellite, _), !.
delta(14, take_image(_, _, _, _), -0.05443310185388248) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 205 examples, 29 leaves
delta(15, turn_to(_, Direction, Direction2), -0.04868233807534132) :- goal_have_image(Direction2, _), goal_pointing(Satellite, Direction2), could_calibrate(Satellite, Direction), fewer_pointing_2_than_pointing_1, !.
delta(15, turn_to(_, Direction, Direction2), 0.08103453749758226) :- goal_have_image(Direction2, _), goal_pointing(Satellite, Direction2), could_calibrate(Satellite, Direction), !.
delta(15, turn_to(_, Direction, Direction2), 0.01865473356251763) :- goal_have_image(Direction2, _), pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), !.
delta(15, turn_to(_, _, Direction), -0.5074172243443074) :- goal_have_image(Direction, _), !.
delta(15, turn_to(Satellite, _, Direction), -0.1919307766400656) :- goal_pointing(Satellite, Direction), fewer_calibrated_power_on_than_pointing_2, !.
delta(15, turn_to(Satellite, _, Direction), 0.002249461952532311) :- goal_pointing(Satellite, Direction), !.
delta(15, turn_to(_, Direction, _), -0.13581478704359295) :- pointing(Satellite, Direction), todo_pointing(Satellite, _), !.
delta(15, turn_to(_, _, _), 0.36853791169305605) :- !.
delta(15, switch_on(Instrument, _), -0.0993245486829385) :- calibration_target(Instrument, Direction), pointing(_, Direction), fewer_pointing_2_than_pointing_1, fewer_power_on_than_pointing_2, !.
delta(15, switch_on(Instrument, _), 0.022369088727534268) :- calibration_target(Instrument, Direction), pointing(_, Direction), fewer_pointing_2_than_pointing_1, !.
delta(15, switch_on(Instrument, Satellite), -0.006434029850132464) :- calibration_target(Instrument, Direction), pointing(_, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(15, switch_on(Instrument, _), 0.4068661371777771) :- calibration_target(Instrument, Direction), pointing(_, Direction), !.
delta(15, switch_on(_, Satellite), 0.0070106177500759165) :- pointing(Satellite, Direction), have_image(Direction, _), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(15, switch_on(_, Satellite), -0.00028132286763370563) :- pointing(Satellite, Direction), have_image(Direction, _), !.
delta(15, switch_on(_, _), -0.32068288723158533) :- fewer_calibrated_power_on_than_pointing_2, !.
delta(15, switch_on(_, _), 0.002166951491069766) :- !.
delta(15, switch_off(Instrument, Satellite), -0.07938848429223784) :- calibration_target(Instrument, Direction), pointing(_, Direction), pointing(Satellite, Direction), !.
delta(15, switch_off(Instrument, Satellite), 0.23164468071637917) :- calibration_target(Instrument, Direction), pointing(_, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(15, switch_off(Instrument, _), -0.0019829800371061607) :- calibration_target(Instrument, Direction), pointing(_, Direction), !.
delta(15, switch_off(_, _), -0.12671123360929978) :- !.
delta(15, calibrate(Satellite, _, Direction), 0.29861144834702874) :- pointing(Satellite2, Direction), goal_pointing(Satellite2, _), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(15, calibrate(_, _, Direction), -0.017240345823834144) :- pointing(Satellite, Direction), goal_pointing(Satellite, _), !.
delta(15, calibrate(Satellite, _, _), 0.024574212771360217) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(15, calibrate(_, _, _), 0.0037642411640380295) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(15, calibrate(_, _, _), -0.10973161308727641) :- !.
delta(15, take_image(Satellite, Direction, _, Is_mode), -0.025391907975034045) :- todo_have_image(Direction, Is_mode), todo_pointing(Satellite, Direction2), pointing(_, Direction2), !.
delta(15, take_image(_, Direction, _, Is_mode), 0.10259404447346801) :- todo_have_image(Direction, Is_mode), !.
delta(15, take_image(_, _, _, _), -0.04372420381585274) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 212 examples, 27 leaves
delta(16, turn_to(Satellite, _, Direction), 0.2686454766414167) :- todo_pointing(_, Direction), on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(16, turn_to(_, Direction, Direction2), 0.013881211398492858) :- todo_pointing(_, Direction2), pointing(Satellite, Direction2), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(16, turn_to(_, _, Direction), -0.06013471548807388) :- todo_pointing(_, Direction), !.
delta(16, turn_to(_, Direction, Direction2), 0.13817723021496767) :- pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), fewer_power_on_than_pointing_2, !.
delta(16, turn_to(_, Direction, Direction2), -0.05518331217840322) :- pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), !.
delta(16, turn_to(_, _, Direction), 0.07476045277919041) :- pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(16, turn_to(_, _, _), -0.41357269803365376) :- !.
delta(16, switch_on(Instrument, Satellite), -0.0022368732593743405) :- calibration_target(Instrument, Direction), todo_have_image(Direction, _), fewer_calibrated_power_on_than_todo_have_image_2, todo_pointing(Satellite, Direction), !.
delta(16, switch_on(Instrument, _), 0.25975170679759785) :- calibration_target(Instrument, Direction), todo_have_image(Direction, _), fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(16, switch_on(Instrument, _), 0.0023663549177916333) :- calibration_target(Instrument, Direction), todo_have_image(Direction, _), needed_calibrated_to_take_image(Instrument), !.
delta(16, switch_on(Instrument, _), -0.06488417039394173) :- calibration_target(Instrument, Direction), todo_have_image(Direction, _), !.
delta(16, switch_on(Instrument, _), 0.002356636797331174) :- power_avail(Satellite), done_pointing(Satellite, _), calibrated(Instrument), !.
delta(16, switch_on(_, _), -0.24386317970459415) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(16, switch_on(_, _), 0.11488969596332878) :- fewer_calibrated_than_todo_have_image_2, !.
delta(16, switch_on(_, _), -0.10800963613093245) :- !.
delta(16, switch_off(Instrument, Satellite), -0.054077919390632445) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(16, switch_off(_, Satellite), -0.04018402985765307) :- pointing(Satellite, Direction), goal_have_image(Direction, _), !.
delta(16, switch_off(_, Satellite), -0.008501989968736978) :- on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(16, switch_off(_, _), 0.1271233272569478) :- !.
delta(16, calibrate(_, _, Direction), 0.000767348629600599) :- power_on(Instrument), calibrated(Instrument), pointing(Satellite, Direction), could_calibrate_needed_calibrated_to_take_image(Satellite, Direction), !.
delta(16, calibrate(_, _, _), -0.028183718133839915) :- power_on(Instrument), calibrated(Instrument), !.
delta(16, calibrate(_, _, Direction), -0.010076585112120425) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), todo_have_image(Direction, _), !.
delta(16, calibrate(_, _, Direction), 0.012687648846697696) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(16, calibrate(_, _, _), 0.24934410582073033) :- !.
delta(16, take_image(_, Direction, _, Is_mode), 0.05562518676014122) :- todo_have_image(Direction, Is_mode), !.
delta(16, take_image(_, _, _, _), -0.024711490053096648) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 203 examples, 29 leaves
delta(17, turn_to(Satellite, Direction, _), 0.02202034412636894) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), goal_pointing(Satellite, _), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(17, turn_to(Satellite, Direction, _), -0.3420641126756006) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), goal_pointing(Satellite, _), !.
delta(17, turn_to(Satellite, Direction, _), -0.07865034019456853) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), pointing(_, Direction), !.
delta(17, turn_to(Satellite, Direction, _), 0.12628936528830859) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(17, turn_to(Satellite, _, Direction), -0.029198982407986247) :- pointing(Satellite, Direction2), calibration_target(_, Direction2), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(17, turn_to(Satellite, _, _), 0.4454295633259127) :- pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(17, turn_to(Satellite, Direction, _), 0.015143660944284702) :- could_take_image_todo_have_image(Satellite, Direction), !.
delta(17, turn_to(_, _, _), -0.06988795346476046) :- !.
delta(17, switch_on(Instrument, Satellite), -0.003600650219205309) :- power_avail(Satellite2), goal_pointing(Satellite2, Direction), needed_pointing_to_take_image(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(17, switch_on(_, Satellite), 0.03666374162314491) :- power_avail(Satellite2), goal_pointing(Satellite2, Direction), needed_pointing_to_take_image(Satellite, Direction), !.
delta(17, switch_on(Instrument, _), 0.010866417106709563) :- power_avail(Satellite), goal_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(17, switch_on(_, _), -0.13595116454102785) :- power_avail(Satellite), goal_pointing(Satellite, _), !.
delta(17, switch_on(Instrument, _), -0.035572916102144) :- calibration_target(Instrument, Direction), todo_pointing(_, Direction), !.
delta(17, switch_on(_, Satellite), 0.09624093483510632) :- on_board(Instrument, Satellite), needed_calibrated_to_take_image(Instrument), !.
delta(17, switch_on(_, _), -0.003338361746068921) :- !.
delta(17, switch_off(_, _), -0.1576402306326599) :- !.
delta(17, calibrate(Satellite, _, Direction), 0.17286051797178256) :- pointing(Satellite2, Direction), goal_pointing(Satellite2, _), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(17, calibrate(_, _, Direction), -0.014024533978473091) :- pointing(Satellite, Direction), goal_pointing(Satellite, _), !.
delta(17, calibrate(_, _, Direction), 0.0006322908538784486) :- fewer_calibrated_than_todo_have_image_1_pointing_2, todo_have_image(Direction, Is_mode), have_image(_, Is_mode), !.
delta(17, calibrate(_, _, _), -0.11252592970189587) :- fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(17, calibrate(_, _, Direction), 0.021342554393190962) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(17, calibrate(_, _, _), -0.0072238664985837826) :- !.
delta(17, take_image(Satellite, Direction, _, Is_mode), 0.04138893975601133) :- todo_pointing(Satellite, Direction2), calibration_target(_, Direction2), todo_have_image(Direction, Is_mode), !.
delta(17, take_image(Satellite, _, _, _), -0.013419376054109118) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(17, take_image(_, Direction, _, Is_mode), 0.018080892563700154) :- fewer_calibrated_than_todo_have_image_2, todo_have_image(Direction, Is_mode), !.
delta(17, take_image(_, _, _, _), -0.002925239972056686) :- fewer_calibrated_than_todo_have_image_2, !.
delta(17, take_image(_, _, _, Is_mode), 0.0052304920798136945) :- todo_have_image(Direction, Is_mode), done_pointing(_, Direction), !.
delta(17, take_image(_, _, _, _), -0.12424674881685718) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 205 examples, 27 leaves
delta(18, turn_to(_, Direction, Direction2), -0.005768188658010927) :- goal_pointing(Satellite, Direction), power_avail(Satellite), goal_have_image(Direction, Is_mode), goal_have_image(Direction2, Is_mode), fewer_pointing_1_than_todo_have_image_1, !.
delta(18, turn_to(_, Direction, Direction2), 0.08019779907436671) :- goal_pointing(Satellite, Direction), power_avail(Satellite), goal_have_image(Direction, Is_mode), goal_have_image(Direction2, Is_mode), !.
delta(18, turn_to(_, Direction, Direction2), 0.021067677654445713) :- goal_pointing(Satellite, Direction), power_avail(Satellite), power_on(Instrument), calibration_target(Instrument, Direction2), !.
delta(18, turn_to(_, Direction, _), -0.4115241587960764) :- goal_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(18, turn_to(Satellite, _, Direction), 0.027468790762544822) :- goal_pointing(Satellite, Direction), goal_pointing(Satellite, Direction2), todo_have_image(Direction2, _), !.
delta(18, turn_to(Satellite, _, Direction), -0.15604163402994148) :- goal_pointing(Satellite, Direction), !.
delta(18, turn_to(_, _, Direction), -0.04930714382019125) :- pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(18, turn_to(_, _, _), 0.36590668724224934) :- !.
delta(18, switch_on(Instrument, _), 0.2429137469411196) :- calibration_target(Instrument, Direction), done_pointing(_, Direction), fewer_power_on_than_pointing_2, fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(18, switch_on(Instrument, _), -0.0007794358084563378) :- calibration_target(Instrument, Direction), done_pointing(_, Direction), fewer_power_on_than_pointing_2, !.
delta(18, switch_on(Instrument, _), -0.0010396106686130706) :- calibration_target(Instrument, Direction), done_pointing(_, Direction), !.
delta(18, switch_on(_, Satellite), 0.005889317087854689) :- pointing(Satellite, Direction), calibration_target(_, Direction), fewer_pointing_1_than_todo_have_image_1, !.
delta(18, switch_on(_, Satellite), -0.2932116266494102) :- pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(18, switch_on(_, _), -0.008399661187655947) :- power_avail(Satellite), goal_pointing(Satellite, _), !.
delta(18, switch_on(_, _), 0.021724824020976946) :- !.
delta(18, switch_off(_, _), -0.0978087642218584) :- !.
delta(18, calibrate(_, _, Direction), -0.01153037525685066) :- calibrated(Instrument), calibration_target(Instrument, Direction), !.
delta(18, calibrate(_, _, Direction), -0.01642984737906019) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), pointing(Satellite2, Direction), power_avail(Satellite2), !.
delta(18, calibrate(_, _, Direction), 0.009137536500104713) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(18, calibrate(Satellite, _, _), -0.014451882922478041) :- on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(18, calibrate(_, _, _), 0.15451609230462127) :- !.
delta(18, take_image(Satellite, _, _, Is_mode), -0.053568833766657636) :- pointing(Satellite, Direction), have_image(Direction, Is_mode), !.
delta(18, take_image(Satellite, _, Instrument, Is_mode), 0.00022173568353840093) :- done_have_image(Direction, Is_mode), calibration_target(Instrument, Direction), goal_pointing(Satellite, Direction2), goal_have_image(Direction2, Is_mode), !.
delta(18, take_image(_, _, Instrument, Is_mode), -0.0021872096665442055) :- done_have_image(Direction, Is_mode), calibration_target(Instrument, Direction), !.
delta(18, take_image(Satellite, _, Instrument, _), -0.0006361350979741601) :- done_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(18, take_image(_, _, _, _), 0.12496358123853966) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 211 examples, 27 leaves
delta(19, turn_to(Satellite, Direction, Direction2), -0.17003512916466682) :- pointing(Satellite2, Direction2), could_calibrate(Satellite2, Direction2), on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(19, turn_to(Satellite, _, Direction), -0.03590381561135324) :- pointing(Satellite2, Direction), could_calibrate(Satellite2, Direction), todo_pointing(Satellite, Direction2), needed_pointing_to_take_image(Satellite, Direction2), !.
delta(19, turn_to(_, _, Direction), 0.07992192941661251) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(19, turn_to(Satellite, Direction, _), 0.0896770727272724) :- pointing(Satellite2, Direction), power_avail(Satellite2), todo_pointing(Satellite, _), !.
delta(19, turn_to(_, Direction, _), -0.18688731252051768) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(19, turn_to(_, _, Direction), -0.04570832803054921) :- pointing(Satellite, Direction), could_take_image_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(19, turn_to(_, _, _), 0.2293313937489984) :- !.
delta(19, switch_on(Instrument, _), 0.14274758562717546) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), fewer_calibrated_power_on_than_todo_have_image_2, fewer_power_on_than_pointing_2, !.
delta(19, switch_on(Instrument, _), -0.01735552931863498) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(19, switch_on(Instrument, _), -0.041067872461252514) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), !.
delta(19, switch_on(_, _), 0.021447769491154307) :- fewer_power_on_than_todo_have_image_1_pointing_2, fewer_pointing_1_than_todo_have_image_1, !.
delta(19, switch_on(_, _), -0.21483182127042028) :- fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(19, switch_on(_, _), 0.07331743507900977) :- fewer_calibrated_than_todo_have_image_2, !.
delta(19, switch_on(_, _), -0.06236100429811244) :- !.
delta(19, switch_off(_, Satellite), -0.012017232041044466) :- fewer_calibrated_than_todo_have_image_1_pointing_2, goal_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_pointing_1_than_todo_have_image_1, !.
delta(19, switch_off(_, Satellite), 0.06607222372441245) :- fewer_calibrated_than_todo_have_image_1_pointing_2, goal_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(19, switch_off(_, _), -0.022530634869507387) :- fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(19, switch_off(_, Satellite), -0.07550409550169619) :- goal_pointing(Satellite, _), !.
delta(19, switch_off(Instrument, _), 0.009698972317562697) :- calibration_target(Instrument, Direction), done_pointing(_, Direction), !.
delta(19, switch_off(_, _), -0.007119785676482782) :- !.
delta(19, calibrate(_, _, _), -0.04372915654009055) :- power_on(Instrument), calibrated(Instrument), !.
delta(19, calibrate(Satellite, _, _), -0.016327404782100027) :- todo_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(19, calibrate(_, _, Direction), -0.010252297072975692) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(19, calibrate(_, _, _), 0.12363607856498098) :- !.
delta(19, take_image(_, Direction, _, Is_mode), 0.06922098772450853) :- todo_have_image(Direction, Is_mode), !.
delta(19, take_image(_, _, _, _), -0.07232360130618355) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 216 examples, 29 leaves
delta(20, turn_to(Satellite, Direction, _), -0.006495739954644965) :- needed_pointing_to_take_image(Satellite, Direction), fewer_power_on_than_todo_have_image_1_pointing_2, fewer_pointing_1_than_todo_have_image_1, !.
delta(20, turn_to(Satellite, Direction, _), 0.32387234802179815) :- needed_pointing_to_take_image(Satellite, Direction), fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(20, turn_to(Satellite, Direction, _), 0.17044268555994002) :- needed_pointing_to_take_image(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(20, turn_to(Satellite, Direction, _), -0.19919667817880876) :- needed_pointing_to_take_image(Satellite, Direction), !.
delta(20, turn_to(Satellite, Direction, _), -0.04363964925009418) :- todo_pointing(Satellite, Direction), calibration_target(Instrument, Direction), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(20, turn_to(Satellite, Direction, _), 0.15249931158534014) :- todo_pointing(Satellite, Direction), !.
delta(20, turn_to(_, Direction, Direction2), 0.09517808236771716) :- done_pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), !.
delta(20, turn_to(_, _, _), -0.3133977125995022) :- !.
delta(20, switch_on(_, Satellite), 0.01711200926176098) :- fewer_calibrated_than_todo_have_image_1_pointing_2, pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(20, switch_on(Instrument, Satellite), 0.015547591178773442) :- fewer_calibrated_than_todo_have_image_1_pointing_2, done_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(20, switch_on(_, _), -0.3299852789614864) :- fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(20, switch_on(_, Satellite), -0.03455503712926088) :- pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(20, switch_on(_, Satellite), -0.010678368544499618) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(20, switch_on(_, _), 0.19608793308551847) :- !.
delta(20, switch_off(_, Satellite), -0.008043199816308987) :- fewer_calibrated_than_todo_have_image_1_pointing_2, goal_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_power_on_than_todo_have_image_1, !.
delta(20, switch_off(_, Satellite), 0.06770382301505243) :- fewer_calibrated_than_todo_have_image_1_pointing_2, goal_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(20, switch_off(_, _), -0.02260888810862489) :- fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(20, switch_off(_, _), -0.11184959380109355) :- !.
delta(20, calibrate(_, _, _), -0.015843285640279203) :- power_on(Instrument), calibrated(Instrument), !.
delta(20, calibrate(_, _, Direction), 0.0814685821480401) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(20, calibrate(_, _, Direction), -0.08082047891736902) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(20, calibrate(_, _, _), 0.14910762631342922) :- !.
delta(20, take_image(_, Direction, Instrument, Is_mode), 0.0022632415000496805) :- have_image(Direction, Is_mode2), supports(Instrument, Is_mode2), todo_have_image(Direction, Is_mode), !.
delta(20, take_image(_, Direction, Instrument, _), -0.07808085275473445) :- have_image(Direction, Is_mode), supports(Instrument, Is_mode), !.
delta(20, take_image(_, Direction, _, _), 0.0010568867867014149) :- goal_pointing(Satellite, Direction), could_take_image(Satellite, Direction), goal_pointing(Satellite2, Direction), could_take_image_todo_have_image(Satellite2, Direction), !.
delta(20, take_image(_, Direction, _, _), -0.0019310161857655761) :- goal_pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(20, take_image(Satellite, _, _, Is_mode), -0.0005212139177079939) :- done_have_image(Direction, Is_mode), could_take_image(Satellite, Direction), !.
delta(20, take_image(_, _, _, _), 0.11093412645611639) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 214 examples, 22 leaves
delta(21, turn_to(Satellite, Direction, _), 0.027453619068036603) :- todo_pointing(Satellite, Direction2), calibration_target(_, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(21, turn_to(Satellite, Direction, _), -0.05356330632118921) :- todo_pointing(Satellite, Direction2), calibration_target(_, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(21, turn_to(Satellite, _, Direction), -0.018800341340799314) :- todo_pointing(Satellite, Direction2), calibration_target(_, Direction2), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(21, turn_to(Satellite, _, _), 0.2903353343852837) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(21, turn_to(_, _, Direction), 0.20534163970699876) :- power_on(Instrument), calibration_target(Instrument, Direction), fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(21, turn_to(_, _, Direction), -0.0872714495316671) :- power_on(Instrument), calibration_target(Instrument, Direction), !.
delta(21, turn_to(_, Direction, _), 0.04795781468670741) :- calibrated(Instrument), calibration_target(Instrument, Direction), !.
delta(21, turn_to(_, _, _), -0.307718625228855) :- !.
delta(21, switch_on(Instrument, Satellite), 0.06586665528919886) :- calibration_target(Instrument, Direction), goal_have_image(Direction, _), pointing(Satellite, Direction), fewer_calibrated_power_on_than_todo_have_image_1_pointing_2, !.
delta(21, switch_on(Instrument, Satellite), -0.04509986079065266) :- calibration_target(Instrument, Direction), goal_have_image(Direction, _), pointing(Satellite, Direction), !.
delta(21, switch_on(Instrument, _), -0.1715848174462285) :- calibration_target(Instrument, Direction), goal_have_image(Direction, Is_mode), supports(Instrument, Is_mode), !.
delta(21, switch_on(Instrument, _), 0.0002570831512874144) :- calibration_target(Instrument, Direction), goal_have_image(Direction, _), !.
delta(21, switch_on(Instrument, _), -0.03545749483299062) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(21, switch_on(Instrument, _), 0.013663148294790255) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), !.
delta(21, switch_on(_, _), 0.07331858607273654) :- power_avail(Satellite), goal_pointing(Satellite, _), !.
delta(21, switch_on(_, _), -0.010473208763120866) :- !.
delta(21, switch_off(_, _), -0.10359181262710132) :- !.
delta(21, calibrate(_, _, Direction), 0.1370801408803926) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(21, calibrate(_, _, _), -0.011962729826820435) :- !.
delta(21, take_image(_, Direction, _, Is_mode), 0.04975515670099941) :- todo_have_image(Direction, Is_mode), !.
delta(21, take_image(_, _, _, _), -0.061547574401629286) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 203 examples, 27 leaves
delta(22, turn_to(_, Direction, Direction2), -0.09088665456143119) :- pointing(Satellite, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), goal_pointing(Satellite2, Direction), needed_pointing_to_calibrate_to_take_image(Satellite2, Direction2), !.
delta(22, turn_to(_, Direction, Direction2), -0.03428618017827837) :- pointing(Satellite, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), todo_pointing(_, Direction2), !.
delta(22, turn_to(_, Direction, Direction2), 0.30663504325821134) :- pointing(Satellite, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(22, turn_to(Satellite, _, _), -0.28645407591296174) :- pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(22, turn_to(Satellite, _, _), -0.008504998611355072) :- pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(22, turn_to(_, _, _), -0.018580514531107938) :- fewer_power_on_than_todo_have_image_2, !.
delta(22, turn_to(_, _, _), 0.12261627798756221) :- !.
delta(22, switch_on(_, Satellite), -0.008259636217010475) :- fewer_calibrated_than_pointing_2, todo_pointing(Satellite, Direction), done_have_image(Direction, _), fewer_pointing_2_than_pointing_1, !.
delta(22, switch_on(_, Satellite), 0.029235374034434748) :- fewer_calibrated_than_pointing_2, todo_pointing(Satellite, Direction), done_have_image(Direction, _), !.
delta(22, switch_on(_, Satellite), 0.012884707370745149) :- fewer_calibrated_than_pointing_2, pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(22, switch_on(_, _), -0.08532651752619407) :- fewer_calibrated_than_pointing_2, !.
delta(22, switch_on(Instrument, Satellite), -0.0017946202149840237) :- todo_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(22, switch_on(_, Satellite), 2.9120349962382043e-5) :- done_pointing(Satellite, Direction), todo_have_image(Direction, _), !.
delta(22, switch_on(_, _), 0.10769803897367078) :- !.
delta(22, switch_off(Instrument, Satellite), -0.013004527885694306) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), pointing(Satellite, Direction), !.
delta(22, switch_off(Instrument, _), -0.00030664610069380837) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), fewer_power_on_than_pointing_2, !.
delta(22, switch_off(Instrument, _), 0.02988196495920882) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), !.
delta(22, switch_off(_, _), -0.05297218597648071) :- !.
delta(22, calibrate(Satellite, _, _), 0.11530963780288778) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), fewer_calibrated_power_on_than_pointing_2, !.
delta(22, calibrate(Satellite, _, _), -0.0005250133970983147) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(22, calibrate(_, _, _), -0.02545026763510586) :- !.
delta(22, take_image(_, Direction, _, Is_mode), 0.0011660670637337015) :- goal_have_image(Direction2, Is_mode), done_have_image(Direction2, Is_mode), todo_pointing(Satellite, Direction2), could_take_image_through_calibration_target_for_todo_have_image_1_instrument(Satellite, Direction), !.
delta(22, take_image(_, Direction, _, Is_mode), 0.0005689509816602532) :- goal_have_image(Direction2, Is_mode), done_have_image(Direction2, Is_mode), pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(22, take_image(_, _, _, Is_mode), -0.10775766353546123) :- goal_have_image(Direction, Is_mode), done_have_image(Direction, Is_mode), !.
delta(22, take_image(_, Direction, _, Is_mode), 0.028530664259470845) :- todo_have_image(Direction, Is_mode), !.
delta(22, take_image(_, _, _, _), -0.0029859806224819406) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 201 examples, 23 leaves
delta(23, turn_to(Satellite, Direction, Direction2), -0.025827882754646318) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction2), todo_pointing(Satellite2, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite2, Direction2), !.
delta(23, turn_to(Satellite, _, Direction), -0.014277589381001106) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), goal_pointing(Satellite, Direction2), could_take_image_through_calibration_target_for_todo_have_image_1_instrument(Satellite, Direction2), !.
delta(23, turn_to(Satellite, _, Direction), 0.31271807751024383) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(23, turn_to(_, Direction, Direction2), -0.04607114160519457) :- pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), goal_have_image(Direction2, _), !.
delta(23, turn_to(_, Direction, Direction2), 0.18288493378461604) :- pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), !.
delta(23, turn_to(_, Direction, _), 0.03414983575556) :- goal_pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(23, turn_to(_, _, _), -0.31829155156691114) :- !.
delta(23, switch_on(Instrument, Satellite), -0.0010386168211726262) :- fewer_power_on_than_todo_have_image_1_pointing_2, todo_pointing(Satellite, Direction), calibration_target(_, Direction), calibration_target(Instrument, Direction), !.
delta(23, switch_on(_, Satellite), 0.019753086354244387) :- fewer_power_on_than_todo_have_image_1_pointing_2, todo_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(23, switch_on(_, _), -0.002958502900233816) :- fewer_power_on_than_todo_have_image_1_pointing_2, power_avail(Satellite), done_pointing(Satellite, _), !.
delta(23, switch_on(_, _), -0.2636710741824449) :- fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(23, switch_on(Instrument, _), 0.1428333684459683) :- fewer_calibrated_power_on_than_todo_have_image_2, calibration_target(Instrument, Direction), pointing(_, Direction), !.
delta(23, switch_on(_, _), -0.014725707775157906) :- fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(23, switch_on(_, _), -0.050485331656382006) :- !.
delta(23, switch_off(Instrument, Satellite), -0.0006463138414320379) :- calibration_target(Instrument, Direction), todo_pointing(_, Direction), todo_pointing(Satellite, Direction), !.
delta(23, switch_off(Instrument, _), 0.03200664134873899) :- calibration_target(Instrument, Direction), todo_pointing(_, Direction), !.
delta(23, switch_off(_, _), -0.08802161409418258) :- !.
delta(23, calibrate(_, _, Direction), 0.06489748267992966) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(23, calibrate(_, _, _), -0.008003097377924992) :- !.
delta(23, take_image(Satellite, _, _, Is_mode), -0.026113210516547667) :- pointing(Satellite, Direction), have_image(Direction, Is_mode), !.
delta(23, take_image(_, _, _, Is_mode), 0.089237016580344) :- goal_have_image(Direction, Is_mode), pointing(_, Direction), !.
delta(23, take_image(_, _, _, _), -0.0024372472978677986) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 202 examples, 27 leaves
delta(24, turn_to(Satellite, Direction, _), -0.010882006214720696) :- could_take_image_todo_have_image(Satellite, Direction), fewer_pointing_1_than_todo_have_image_1, !.
delta(24, turn_to(Satellite, Direction, Direction2), 0.0) :- could_take_image_todo_have_image(Satellite, Direction), done_pointing(Satellite2, Direction2), could_calibrate(Satellite2, Direction2), !.
delta(24, turn_to(Satellite, Direction, _), 0.13799696295793487) :- could_take_image_todo_have_image(Satellite, Direction), !.
delta(24, turn_to(_, _, Direction), -0.07378168276224677) :- goal_have_image(Direction, Is_mode), supports(Instrument, Is_mode), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(24, turn_to(_, _, Direction), 0.12465164431985834) :- goal_have_image(Direction, _), !.
delta(24, turn_to(_, Direction, _), 0.019654977917846993) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(24, turn_to(_, _, _), -0.3571693508279715) :- !.
delta(24, switch_on(_, Satellite), 0.006906957772017215) :- pointing(Satellite, Direction), goal_have_image(Direction, _), fewer_pointing_1_than_todo_have_image_1, !.
delta(24, switch_on(_, Satellite), 0.0027681235264360193) :- pointing(Satellite, Direction), goal_have_image(Direction, _), goal_pointing(Satellite, Direction), !.
delta(24, switch_on(_, Satellite), -0.0778212141376908) :- pointing(Satellite, Direction), goal_have_image(Direction, _), !.
delta(24, switch_on(Instrument, _), -0.015389620447430518) :- calibration_target(Instrument, Direction), pointing(_, Direction), fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(24, switch_on(Instrument, _), 0.17689657870505698) :- calibration_target(Instrument, Direction), pointing(_, Direction), !.
delta(24, switch_on(_, _), 0.03283907116073442) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(24, switch_on(_, _), -0.04968132113910546) :- !.
delta(24, switch_off(Instrument, Satellite), -0.0012737001065940912) :- on_board(Instrument2, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument2), calibration_target(Instrument, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(24, switch_off(_, Satellite), 0.13289810640876662) :- on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(24, switch_off(_, _), -0.07970415746267318) :- !.
delta(24, calibrate(_, _, Direction), 0.10419791329491854) :- fewer_calibrated_power_on_than_todo_have_image_1, pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(24, calibrate(_, _, _), -0.0014521639205076868) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(24, calibrate(_, _, _), -0.007977797635687418) :- !.
delta(24, take_image(Satellite, Direction, _, _), 0.016635194104884257) :- todo_pointing(Satellite, Direction2), todo_pointing(Satellite2, Direction2), could_take_image_todo_have_image(Satellite2, Direction), !.
delta(24, take_image(Satellite, _, _, _), -0.004885918783479539) :- todo_pointing(Satellite, _), !.
delta(24, take_image(Satellite, _, _, Is_mode), 0.00032094100302387124) :- goal_have_image(Direction, Is_mode), needed_pointing_to_take_image(Satellite, Direction), fewer_pointing_1_than_todo_have_image_1, !.
delta(24, take_image(Satellite, _, _, Is_mode), -0.04449599333567556) :- goal_have_image(Direction, Is_mode), needed_pointing_to_take_image(Satellite, Direction), !.
delta(24, take_image(_, Direction, _, Is_mode), 0.0018600609992089749) :- todo_have_image(Direction, Is_mode), !.
delta(24, take_image(_, _, _, _), -0.0005620259136410729) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 201 examples, 33 leaves
delta(25, turn_to(Satellite, Direction, Direction2), 0.017372298083684692) :- calibration_target(_, Direction), on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), goal_pointing(Satellite, Direction2), !.
delta(25, turn_to(Satellite, Direction, _), -0.35565955049766834) :- calibration_target(_, Direction), on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(25, turn_to(Satellite, Direction, _), -0.0479921572921946) :- calibration_target(_, Direction), calibrated(Instrument), on_board(Instrument, Satellite), !.
delta(25, turn_to(_, Direction, _), 0.17678622372529398) :- calibration_target(_, Direction), !.
delta(25, turn_to(Satellite, _, _), 0.6960458212266454) :- on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), fewer_power_on_than_todo_have_image_1, !.
delta(25, turn_to(Satellite, _, _), -0.020368104372378674) :- on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(25, turn_to(Satellite, _, _), 0.10716099309751548) :- goal_pointing(Satellite, Direction), done_have_image(Direction, _), !.
delta(25, turn_to(_, _, _), -0.17397462935640434) :- !.
delta(25, switch_on(Instrument, Satellite), -0.002439202973177131) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_power_on_than_todo_have_image_1, calibration_target(Instrument, Direction), !.
delta(25, switch_on(_, Satellite), 0.08858518853636184) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(25, switch_on(_, Satellite), -0.0027824842902977737) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(25, switch_on(_, Satellite), 0.00949022495118869) :- done_pointing(Satellite, Direction), goal_have_image(Direction, _), fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(25, switch_on(_, Satellite), -0.0006159293525019312) :- done_pointing(Satellite, Direction), goal_have_image(Direction, _), !.
delta(25, switch_on(_, Satellite), -0.0003280133325871769) :- todo_pointing(Satellite, Direction), needed_pointing_to_take_image(Satellite, Direction), !.
delta(25, switch_on(_, _), -0.3652376205833506) :- !.
delta(25, switch_off(Instrument, Satellite), -0.012740433136944174) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), pointing(Satellite2, Direction), power_avail(Satellite2), !.
delta(25, switch_off(Instrument, Satellite), 0.10647380762027508) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), fewer_pointing_2_than_pointing_1, !.
delta(25, switch_off(Instrument, Satellite), -0.0016182491064099878) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(25, switch_off(_, _), -0.024284747082564027) :- !.
delta(25, calibrate(Satellite, _, Direction), 0.049007853142426804) :- goal_pointing(Satellite2, Direction), done_pointing(Satellite2, Direction), goal_pointing(Satellite2, Direction2), could_calibrate(Satellite, Direction2), !.
delta(25, calibrate(_, _, Direction), -0.0020745795144994006) :- goal_pointing(Satellite, Direction), done_pointing(Satellite, Direction), !.
delta(25, calibrate(Satellite, Instrument, _), -0.0016017361544908184) :- todo_pointing(Satellite, Direction), goal_have_image(Direction, _), calibrated(Instrument), !.
delta(25, calibrate(Satellite, _, _), 0.01702945892108782) :- todo_pointing(Satellite, Direction), goal_have_image(Direction, _), !.
delta(25, calibrate(_, _, _), -0.10219806040954789) :- fewer_calibrated_than_todo_have_image_2, !.
delta(25, calibrate(_, _, _), 0.002630814656844121) :- !.
delta(25, take_image(Satellite, Direction, _, Is_mode), -0.003893865138949515) :- goal_pointing(Satellite, Direction2), calibration_target(_, Direction2), have_image(Direction, Is_mode), !.
delta(25, take_image(Satellite, _, _, _), -0.0002969773029840009) :- goal_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_than_todo_have_image_2, !.
delta(25, take_image(Satellite, _, _, _), 0.02821030835860224) :- goal_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(25, take_image(_, Direction, _, Is_mode), 0.004840720302386755) :- todo_have_image(Direction, Is_mode2), have_image(_, Is_mode2), todo_have_image(Direction, Is_mode), !.
delta(25, take_image(_, Direction, _, _), -0.0001974570660194629) :- todo_have_image(Direction, Is_mode), have_image(_, Is_mode), !.
delta(25, take_image(_, _, _, Is_mode), 0.0006280218239688725) :- todo_have_image(Direction, Is_mode), done_pointing(_, Direction), !.
delta(25, take_image(_, _, _, _), -0.05123101165312194) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 216 examples, 24 leaves
delta(26, turn_to(Satellite, Direction, _), 0.06902001257976244) :- goal_pointing(Satellite, Direction2), pointing(Satellite2, Direction2), done_pointing(Satellite2, Direction), !.
delta(26, turn_to(Satellite, _, _), -0.3072165186002633) :- goal_pointing(Satellite, Direction), pointing(_, Direction), power_avail(Satellite), !.
delta(26, turn_to(Satellite, _, _), 0.039465957077288914) :- goal_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(26, turn_to(_, Direction, _), 0.0003114002533061056) :- done_pointing(Satellite, Direction), power_avail(Satellite), todo_have_image(Direction, _), !.
delta(26, turn_to(_, Direction, _), -0.05602112977273671) :- done_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(26, turn_to(Satellite, _, _), -0.014728209784358749) :- calibrated(Instrument), on_board(Instrument, Satellite), !.
delta(26, turn_to(_, _, _), 0.4527858251623089) :- !.
delta(26, switch_on(_, _), 0.06742131273825737) :- power_on(Instrument), needed_calibrated_to_take_image(Instrument), fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(26, switch_on(_, _), -0.01347556509621421) :- power_on(Instrument), needed_calibrated_to_take_image(Instrument), !.
delta(26, switch_on(Instrument, Satellite), 0.017299314065258076) :- fewer_pointing_2_than_pointing_1, done_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(26, switch_on(_, _), -0.1885009642522372) :- fewer_pointing_2_than_pointing_1, !.
delta(26, switch_on(_, _), 0.03796214223189455) :- fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(26, switch_on(_, _), -0.0053120668148092616) :- !.
delta(26, switch_off(_, _), -0.07149347534804862) :- !.
delta(26, calibrate(Satellite, _, Direction), 0.03286778628610052) :- pointing(Satellite2, Direction), goal_pointing(Satellite2, _), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), fewer_calibrated_than_todo_have_image_1, !.
delta(26, calibrate(Satellite, _, Direction), -0.0010994438910894072) :- pointing(Satellite2, Direction), goal_pointing(Satellite2, _), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(26, calibrate(_, _, Direction), -0.006993194959093555) :- pointing(Satellite, Direction), goal_pointing(Satellite, _), !.
delta(26, calibrate(_, _, Direction), -2.1145725039058517e-6) :- todo_have_image(Direction, _), pointing(Satellite, Direction), could_take_image_todo_have_image(Satellite, Direction), !.
delta(26, calibrate(_, _, Direction), -0.09401757189629872) :- todo_have_image(Direction, _), !.
delta(26, calibrate(_, _, Direction), 0.008001228684602278) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(26, calibrate(_, _, _), -0.0002782177411684671) :- !.
delta(26, take_image(_, Direction, _, Is_mode), 0.028667312186798206) :- todo_have_image(Direction, Is_mode), !.
delta(26, take_image(_, _, _, _), -0.03170880426190173) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 204 examples, 27 leaves
delta(27, turn_to(Satellite, Direction, _), 0.002514313910542844) :- pointing(Satellite2, Direction), goal_pointing(Satellite2, _), fewer_calibrated_than_todo_have_image_1_pointing_2, could_calibrate(Satellite, Direction), !.
delta(27, turn_to(_, Direction, _), -0.5246909877131843) :- pointing(Satellite, Direction), goal_pointing(Satellite, _), fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(27, turn_to(Satellite, Direction, _), 0.14432008931810658) :- pointing(Satellite2, Direction), goal_pointing(Satellite2, _), todo_pointing(Satellite, Direction), !.
delta(27, turn_to(_, Direction, _), -0.09380735511492388) :- pointing(Satellite, Direction), goal_pointing(Satellite, _), !.
delta(27, turn_to(Satellite, Direction, Direction2), 0.08953527827651182) :- todo_pointing(Satellite, Direction), pointing(Satellite2, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite2, Direction), !.
delta(27, turn_to(Satellite, Direction, _), -0.11462236147434302) :- todo_pointing(Satellite, Direction), !.
delta(27, turn_to(_, _, Direction), -0.036394387648884294) :- done_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(27, turn_to(_, _, _), 0.5978422479555788) :- !.
delta(27, switch_on(Instrument, Satellite), -0.00045481751991031656) :- fewer_pointing_2_than_pointing_1, calibration_target(Instrument, Direction), needed_pointing_to_take_image(Satellite, Direction), power_on(_), !.
delta(27, switch_on(Instrument, Satellite), 0.007645941396373005) :- fewer_pointing_2_than_pointing_1, calibration_target(Instrument, Direction), needed_pointing_to_take_image(Satellite, Direction), !.
delta(27, switch_on(_, _), -0.2372031241032921) :- fewer_pointing_2_than_pointing_1, fewer_power_on_than_todo_have_image_1, !.
delta(27, switch_on(_, _), 0.005809100523457664) :- fewer_pointing_2_than_pointing_1, !.
delta(27, switch_on(Instrument, _), -0.03903041323939987) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), !.
delta(27, switch_on(_, Satellite), -0.011747876949664261) :- todo_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(27, switch_on(_, _), 0.07788631880789561) :- !.
delta(27, switch_off(_, _), -0.0556121442194087) :- !.
delta(27, calibrate(_, _, Direction), 0.00214295470886805) :- pointing(Satellite, Direction), power_avail(Satellite), pointing(Satellite2, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite2, Direction), !.
delta(27, calibrate(_, _, Direction), -0.12519298068579693) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(27, calibrate(_, _, Direction), 0.1560120120877934) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(27, calibrate(_, _, _), -0.007275161747112779) :- !.
delta(27, take_image(_, Direction, Instrument, Is_mode), 0.018548466653789345) :- calibration_target(Instrument, Direction2), goal_pointing(_, Direction2), todo_have_image(Direction, Is_mode), !.
delta(27, take_image(_, _, Instrument, _), -0.004169029001818152) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), !.
delta(27, take_image(Satellite, Direction, _, Is_mode), 0.005304889482029538) :- goal_pointing(Satellite, _), todo_have_image(Direction, Is_mode), !.
delta(27, take_image(Satellite, _, _, _), -0.0008013413363539462) :- goal_pointing(Satellite, _), !.
delta(27, take_image(_, _, _, _), 0.0014292731835038026) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(27, take_image(_, _, _, _), -0.049801170746290334) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 209 examples, 28 leaves
delta(28, turn_to(_, _, Direction), -0.14832899048661977) :- fewer_power_on_than_todo_have_image_1, goal_pointing(_, Direction), calibration_target(_, Direction), !.
delta(28, turn_to(_, _, Direction), 0.04026271320758597) :- fewer_power_on_than_todo_have_image_1, goal_pointing(_, Direction), !.
delta(28, turn_to(_, Direction, _), -0.05396503986235952) :- fewer_power_on_than_todo_have_image_1, pointing(Satellite, Direction), power_avail(Satellite), !.
delta(28, turn_to(_, _, _), 0.33922374489825446) :- fewer_power_on_than_todo_have_image_1, !.
delta(28, turn_to(Satellite, Direction, Direction2), -0.01726431630770604) :- todo_pointing(Satellite, Direction), pointing(Satellite2, Direction2), could_calibrate_needed_calibrated_to_take_image(Satellite2, Direction2), !.
delta(28, turn_to(Satellite, Direction, _), 0.11358069964388286) :- todo_pointing(Satellite, Direction), !.
delta(28, turn_to(Satellite, _, _), 0.06290382694262922) :- pointing(Satellite, Direction), could_take_image_through_calibration_target_for_todo_have_image_1_instrument(Satellite, Direction), !.
delta(28, turn_to(_, _, _), -0.27539268655192845) :- !.
delta(28, switch_on(Instrument, Satellite), 0.02569542207976664) :- calibration_target(Instrument, Direction), goal_have_image(Direction, _), needed_pointing_to_take_image(Satellite, Direction), fewer_pointing_2_than_pointing_1, !.
delta(28, switch_on(Instrument, Satellite), -0.002823544104795772) :- calibration_target(Instrument, Direction), goal_have_image(Direction, _), needed_pointing_to_take_image(Satellite, Direction), !.
delta(28, switch_on(Instrument, Satellite), 0.006852342996713024) :- calibration_target(Instrument, Direction), goal_have_image(Direction, _), done_pointing(Satellite, Direction), !.
delta(28, switch_on(Instrument, _), -0.1672090158639198) :- calibration_target(Instrument, Direction), goal_have_image(Direction, _), !.
delta(28, switch_on(_, Satellite), 0.002616620979110286) :- goal_pointing(Satellite, Direction), done_pointing(_, Direction), fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(28, switch_on(_, Satellite), -0.028511570118406344) :- goal_pointing(Satellite, Direction), done_pointing(_, Direction), !.
delta(28, switch_on(_, Satellite), 0.0957337472476943) :- pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(28, switch_on(_, _), -0.0065544456907256545) :- !.
delta(28, switch_off(_, _), -0.013660709631890157) :- !.
delta(28, calibrate(_, _, _), 0.0031572926950085216) :- fewer_power_on_than_todo_have_image_1_pointing_2, power_avail(Satellite), todo_pointing(Satellite, _), !.
delta(28, calibrate(_, _, _), -0.022799139951226042) :- fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(28, calibrate(_, _, Direction), -0.008758490834307464) :- pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(28, calibrate(_, _, Direction), 0.10628242165369654) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(28, calibrate(_, _, _), -0.0014512107613038534) :- !.
delta(28, take_image(_, Direction, _, _), -0.07420181335630739) :- fewer_power_on_than_todo_have_image_1, pointing(Satellite, Direction), power_avail(Satellite), !.
delta(28, take_image(_, _, _, _), 0.006621835782353332) :- fewer_power_on_than_todo_have_image_1, !.
delta(28, take_image(Satellite, _, _, Is_mode), -0.012050344069542168) :- pointing(Satellite, Direction), have_image(Direction, Is_mode), !.
delta(28, take_image(_, _, _, Is_mode), 0.07892534247582017) :- goal_have_image(Direction, Is_mode), pointing(_, Direction), !.
delta(28, take_image(_, _, _, _), -0.0008860136082659044) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 207 examples, 26 leaves
delta(29, turn_to(Satellite, Direction, _), 0.02582593844601668) :- goal_pointing(Satellite, Direction2), todo_pointing(_, Direction2), todo_pointing(Satellite, Direction), needed_pointing_to_take_image(Satellite, Direction), !.
delta(29, turn_to(Satellite, Direction, _), -0.0772147452277518) :- goal_pointing(Satellite, Direction2), todo_pointing(_, Direction2), todo_pointing(Satellite, Direction), !.
delta(29, turn_to(Satellite, _, _), 0.2094252811783164) :- goal_pointing(Satellite, Direction), todo_pointing(_, Direction), fewer_power_on_than_pointing_2, !.
delta(29, turn_to(Satellite, _, _), -0.013572229305742093) :- goal_pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(29, turn_to(_, Direction, Direction2), 0.022333941963197986) :- fewer_pointing_2_than_pointing_1, goal_pointing(Satellite, Direction2), could_take_image_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(29, turn_to(_, _, _), -0.2831276550329697) :- fewer_pointing_2_than_pointing_1, !.
delta(29, turn_to(Satellite, _, Direction), -0.011993048312509044) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(29, turn_to(_, _, _), 0.09917451325301745) :- !.
delta(29, switch_on(Instrument, Satellite), -0.011245463244915684) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), done_have_image(Direction, Is_mode), supports(Instrument, Is_mode), !.
delta(29, switch_on(Instrument, Satellite), -0.003082588322982623) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), power_on(Instrument2), needed_calibrated_to_take_image(Instrument2), !.
delta(29, switch_on(Instrument, Satellite), 0.18747658746340065) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(29, switch_on(_, Satellite), -0.004504597602052075) :- fewer_power_on_than_todo_have_image_1_pointing_2, goal_pointing(Satellite, _), !.
delta(29, switch_on(_, _), 0.015603564889848456) :- fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(29, switch_on(_, _), -0.1475763634772826) :- !.
delta(29, switch_off(_, Satellite), -0.0001207820304883811) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), fewer_pointing_2_than_pointing_1, goal_pointing(_, Direction), !.
delta(29, switch_off(_, Satellite), 0.024671291366886155) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), fewer_pointing_2_than_pointing_1, !.
delta(29, switch_off(_, Satellite), -0.0022424190935952893) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(29, switch_off(_, _), -0.02498012037801599) :- !.
delta(29, calibrate(_, _, Direction), 0.04601708080534557) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(29, calibrate(_, _, _), -0.0019035605477666206) :- !.
delta(29, take_image(Satellite, _, _, Is_mode), -0.04461624142592562) :- pointing(Satellite, Direction), have_image(Direction, Is_mode), !.
delta(29, take_image(_, Direction, _, _), -0.009922186248411072) :- pointing(Satellite, Direction), power_avail(Satellite), fewer_power_on_than_todo_have_image_1, !.
delta(29, take_image(_, Direction, _, _), 0.006897138119528999) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(29, take_image(Satellite, _, Instrument, _), -0.0011316163290831817) :- done_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(29, take_image(_, _, _, _), 0.051165257246047036) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 201 examples, 22 leaves
delta(30, turn_to(Satellite, Direction, Direction2), -0.010215032978418059) :- calibration_target(Instrument, Direction2), needed_power_on_to_calibrate_to_take_image(Instrument), on_board(Instrument2, Satellite), calibration_target(Instrument2, Direction), on_board(Instrument, Satellite), !.
delta(30, turn_to(Satellite, Direction, Direction2), 0.03408904785469024) :- calibration_target(Instrument, Direction2), needed_power_on_to_calibrate_to_take_image(Instrument), on_board(Instrument2, Satellite), calibration_target(Instrument2, Direction), !.
delta(30, turn_to(_, Direction, Direction2), 0.0002093445131856512) :- calibration_target(Instrument, Direction2), needed_power_on_to_calibrate_to_take_image(Instrument), goal_pointing(Satellite, Direction2), could_calibrate(Satellite, Direction), !.
delta(30, turn_to(_, _, Direction), -0.17423457178599286) :- calibration_target(Instrument, Direction), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(30, turn_to(Satellite, Direction, Direction2), 0.04998171348677993) :- pointing(Satellite2, Direction2), could_take_image(Satellite2, Direction2), could_take_image_todo_have_image(Satellite, Direction), !.
delta(30, turn_to(_, _, Direction), -0.1536704995598913) :- pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(30, turn_to(Satellite, _, Direction), -0.024910919886974706) :- goal_pointing(Satellite, Direction), !.
delta(30, turn_to(_, _, _), 0.2723741571444904) :- !.
delta(30, switch_on(_, Satellite), 0.08944751514543876) :- goal_pointing(Satellite, Direction), todo_have_image(Direction, _), fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(30, switch_on(_, Satellite), -0.011002788039381279) :- goal_pointing(Satellite, Direction), todo_have_image(Direction, _), !.
delta(30, switch_on(_, Satellite), -0.11761729174125374) :- pointing(Satellite, Direction), goal_pointing(_, Direction), fewer_calibrated_than_pointing_2, !.
delta(30, switch_on(_, Satellite), 0.008701837696901183) :- pointing(Satellite, Direction), goal_pointing(_, Direction), !.
delta(30, switch_on(_, _), 0.04681362282565993) :- fewer_power_on_than_todo_have_image_1, !.
delta(30, switch_on(_, _), -0.030956106509187807) :- !.
delta(30, switch_off(_, _), -0.011530741718474881) :- !.
delta(30, calibrate(_, _, Direction), 0.014051020445628242) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(30, calibrate(_, _, _), -0.005231938081668965) :- !.
delta(30, take_image(_, Direction, _, _), 0.0048469336148415235) :- fewer_pointing_2_than_pointing_1, todo_have_image(Direction, Is_mode), have_image(_, Is_mode), !.
delta(30, take_image(_, _, _, _), -0.031320115710983705) :- fewer_pointing_2_than_pointing_1, !.
delta(30, take_image(_, Direction, _, Is_mode), 0.013878536204212283) :- todo_have_image(Direction, Is_mode), !.
delta(30, take_image(_, _, _, _), -0.005062460832186777) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 211 examples, 25 leaves
delta(31, turn_to(Satellite, Direction, Direction2), 0.07816658286212162) :- calibration_target(_, Direction), goal_pointing(Satellite, Direction2), calibration_target(Instrument, Direction2), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(31, turn_to(Satellite, Direction, Direction2), -0.023461503574156023) :- calibration_target(_, Direction), goal_pointing(Satellite, Direction2), !.
delta(31, turn_to(_, Direction, Direction2), 0.029051991864673783) :- calibration_target(_, Direction), goal_have_image(Direction, Is_mode), done_have_image(Direction2, Is_mode), !.
delta(31, turn_to(_, Direction, _), -0.4106251221184355) :- calibration_target(_, Direction), !.
delta(31, turn_to(_, Direction, _), -0.06182684879688729) :- goal_have_image(Direction, Is_mode), have_image(_, Is_mode), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(31, turn_to(_, Direction, _), 0.01509862053180628) :- goal_have_image(Direction, Is_mode), have_image(_, Is_mode), !.
delta(31, turn_to(_, _, Direction), 0.5619044454464752) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(31, turn_to(_, _, _), -0.013770164010186664) :- !.
delta(31, switch_on(_, Satellite), 0.0005872403508590937) :- goal_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_than_pointing_2, needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(31, switch_on(_, Satellite), -0.13708124925282078) :- goal_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_than_pointing_2, !.
delta(31, switch_on(Instrument, Satellite), 0.007505830277470158) :- goal_pointing(Satellite, Direction), calibration_target(_, Direction), needed_power_on_to_take_image(Instrument), !.
delta(31, switch_on(_, Satellite), -0.0003603675595905719) :- goal_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(31, switch_on(_, _), 0.04529763964161753) :- fewer_power_on_than_pointing_2, !.
delta(31, switch_on(_, _), -0.0032902812795672326) :- !.
delta(31, switch_off(_, _), -0.04173676712135395) :- !.
delta(31, calibrate(Satellite, _, Direction), 0.0028477425179696493) :- pointing(Satellite2, Direction), power_avail(Satellite2), goal_pointing(Satellite, _), !.
delta(31, calibrate(_, Instrument, Direction), 0.00026316055187717603) :- pointing(Satellite, Direction), power_avail(Satellite), todo_have_image(Direction, Is_mode), supports(Instrument, Is_mode), !.
delta(31, calibrate(_, _, Direction), -0.03705704817079073) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(31, calibrate(_, _, Direction), 0.048928717067685444) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(31, calibrate(_, _, _), -0.008164705060275584) :- !.
delta(31, take_image(Satellite, Direction, Instrument, Is_mode), 0.005124802419942787) :- todo_have_image(Direction, Is_mode), pointing(Satellite, Direction2), calibration_target(Instrument, Direction2), fewer_calibrated_than_todo_have_image_1, !.
delta(31, take_image(Satellite, Direction, Instrument, Is_mode), -0.009494741706459774) :- todo_have_image(Direction, Is_mode), pointing(Satellite, Direction2), calibration_target(Instrument, Direction2), !.
delta(31, take_image(_, Direction, _, Is_mode), 0.01761728215463634) :- todo_have_image(Direction, Is_mode), !.
delta(31, take_image(_, _, _, _), -0.016897453705653473) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 202 examples, 27 leaves
delta(32, turn_to(Satellite, Direction, Direction2), 0.003915103376610752) :- pointing(Satellite2, Direction2), power_avail(Satellite2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), pointing(Satellite3, Direction2), needed_pointing_to_take_image(Satellite3, Direction), !.
delta(32, turn_to(Satellite, Direction, Direction2), -0.04450992911880726) :- pointing(Satellite2, Direction2), power_avail(Satellite2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(32, turn_to(_, Direction, Direction2), 0.1989729876709507) :- pointing(Satellite, Direction2), power_avail(Satellite), goal_pointing(_, Direction), !.
delta(32, turn_to(_, _, Direction), -0.01833596889842481) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(32, turn_to(_, Direction, _), -0.014978418517369281) :- calibrated(Instrument), calibration_target(Instrument, Direction), fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(32, turn_to(_, Direction, _), 0.038332338373072414) :- calibrated(Instrument), calibration_target(Instrument, Direction), !.
delta(32, turn_to(Satellite, _, _), 0.019295384670650947) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(32, turn_to(_, _, _), -0.10308500941917043) :- !.
delta(32, switch_on(_, Satellite), 0.056220690453464804) :- todo_pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(32, switch_on(Instrument, _), -0.15833925634798396) :- calibration_target(Instrument, Direction), goal_have_image(Direction, _), fewer_power_on_than_pointing_2, !.
delta(32, switch_on(Instrument, _), 0.004803156634055005) :- calibration_target(Instrument, Direction), goal_have_image(Direction, _), !.
delta(32, switch_on(_, Satellite), 0.012425669122778194) :- on_board(Instrument, Satellite), needed_power_on_to_take_image(Instrument), !.
delta(32, switch_on(_, _), -0.0027332985176444316) :- !.
delta(32, switch_off(_, Satellite), 0.0) :- power_avail(Satellite2), done_pointing(Satellite2, Direction), fewer_calibrated_power_on_than_todo_have_image_1, could_calibrate(Satellite, Direction), !.
delta(32, switch_off(_, _), -0.0006679003976943364) :- power_avail(Satellite), done_pointing(Satellite, _), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(32, switch_off(_, _), 0.030351375490338506) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(32, switch_off(_, _), -0.03797848767776336) :- !.
delta(32, calibrate(_, _, Direction), 0.0002492686566904738) :- power_on(Instrument), calibrated(Instrument), pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(32, calibrate(_, _, _), -0.015082310895401867) :- power_on(Instrument), calibrated(Instrument), !.
delta(32, calibrate(_, _, _), 0.023850292888014435) :- !.
delta(32, take_image(Satellite, Direction, Instrument, _), 5.8540065269551806e-5) :- goal_pointing(Satellite, Direction2), pointing(Satellite2, Direction2), calibration_target(Instrument, Direction), could_take_image_todo_have_image(Satellite2, Direction), !.
delta(32, take_image(Satellite, Direction, Instrument, _), -0.03328501470265674) :- goal_pointing(Satellite, Direction2), pointing(_, Direction2), calibration_target(Instrument, Direction), !.
delta(32, take_image(Satellite, Direction, _, Is_mode), 0.0069947965620431665) :- goal_pointing(Satellite, Direction2), pointing(_, Direction2), todo_have_image(Direction, Is_mode), !.
delta(32, take_image(Satellite, _, _, _), -0.0011150575969757447) :- goal_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(32, take_image(_, Direction, Instrument, _), 0.03859277845978487) :- todo_have_image(Direction, Is_mode), supports(Instrument, Is_mode), !.
delta(32, take_image(_, _, _, _), -0.008506875477424635) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 203 examples, 27 leaves
delta(33, turn_to(_, Direction, _), 0.07641717723754794) :- todo_pointing(_, Direction), todo_have_image(Direction, _), fewer_power_on_than_pointing_2, !.
delta(33, turn_to(_, Direction, _), -0.016987421133994086) :- todo_pointing(_, Direction), todo_have_image(Direction, _), !.
delta(33, turn_to(_, Direction, Direction2), 0.03518730895260812) :- todo_pointing(_, Direction), have_image(Direction2, _), !.
delta(33, turn_to(_, Direction, _), -0.3748721033470561) :- todo_pointing(_, Direction), !.
delta(33, turn_to(_, Direction, _), 0.013992972445634655) :- calibrated(Instrument), calibration_target(Instrument, Direction), fewer_calibrated_than_todo_have_image_1, !.
delta(33, turn_to(_, Direction, _), -0.057147854060511566) :- calibrated(Instrument), calibration_target(Instrument, Direction), !.
delta(33, turn_to(Satellite, _, _), -0.041688616794496126) :- todo_pointing(Satellite, Direction), needed_pointing_to_take_image(Satellite, Direction), !.
delta(33, turn_to(_, _, _), 0.38545001660688716) :- !.
delta(33, switch_on(Instrument, Satellite), -0.0015626080726676402) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_than_todo_have_image_1, calibration_target(Instrument, Direction), !.
delta(33, switch_on(_, Satellite), 0.04502951542354832) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_than_todo_have_image_1, !.
delta(33, switch_on(_, Satellite), 0.0015404615817393112) :- todo_pointing(Satellite, Direction), calibration_target(Instrument, Direction), calibrated(Instrument), !.
delta(33, switch_on(_, Satellite), -0.01604072771049193) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(33, switch_on(Instrument, Satellite), 0.005997613999544841) :- pointing(Satellite, Direction), done_have_image(Direction, _), needed_calibrated_to_take_image(Instrument), !.
delta(33, switch_on(_, Satellite), -0.00021697592258829567) :- pointing(Satellite, Direction), done_have_image(Direction, _), !.
delta(33, switch_on(_, _), 0.0025289684370505016) :- calibrated(Instrument), needed_power_on_to_take_image(Instrument), !.
delta(33, switch_on(_, _), -0.1264496023226638) :- !.
delta(33, switch_off(_, _), -0.03364808601354493) :- !.
delta(33, calibrate(_, _, Direction), 0.002828136933352529) :- power_avail(_), calibration_target(Instrument, Direction), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(33, calibrate(Satellite, _, _), 0.0003700198052746434) :- power_avail(Satellite2), pointing(Satellite2, Direction), could_calibrate_needed_calibrated_to_take_image(Satellite, Direction), !.
delta(33, calibrate(_, _, _), -0.03713566975531131) :- power_avail(_), !.
delta(33, calibrate(_, _, Direction), 0.01727512474390343) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(33, calibrate(_, _, _), -0.0017852490116068956) :- !.
delta(33, take_image(_, Direction, _, Is_mode), -0.00047494785085132064) :- todo_have_image(Direction2, Is_mode), pointing(_, Direction2), done_have_image(Direction, Is_mode), !.
delta(33, take_image(_, _, _, Is_mode), -0.0002978915139714645) :- todo_have_image(Direction, Is_mode), pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(33, take_image(_, _, _, Is_mode), 0.047055745115120014) :- todo_have_image(Direction, Is_mode), pointing(_, Direction), !.
delta(33, take_image(_, _, _, _), -0.004235124955874537) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 218 examples, 21 leaves
delta(34, turn_to(Satellite, _, Direction), -0.041661516255858774) :- calibration_target(Instrument, Direction), needed_power_on_to_take_image(Instrument), todo_pointing(Satellite, Direction2), needed_pointing_to_take_image(Satellite, Direction2), !.
delta(34, turn_to(Satellite, _, Direction), -0.025995823142811486) :- calibration_target(Instrument, Direction), needed_power_on_to_take_image(Instrument), on_board(Instrument2, Satellite), calibration_target(Instrument2, Direction), !.
delta(34, turn_to(_, _, Direction), 0.29976248867203714) :- calibration_target(Instrument, Direction), needed_power_on_to_take_image(Instrument), !.
delta(34, turn_to(Satellite, Direction, _), -0.03447567299234507) :- goal_pointing(Satellite, Direction2), pointing(Satellite2, Direction2), todo_pointing(Satellite2, Direction), !.
delta(34, turn_to(Satellite, _, _), 0.11891640664818538) :- goal_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(34, turn_to(_, Direction, _), 0.05481744869511755) :- calibrated(Instrument), calibration_target(Instrument, Direction), !.
delta(34, turn_to(_, _, _), -0.18355973236146544) :- !.
delta(34, switch_on(_, Satellite), 0.07836816298099734) :- todo_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(34, switch_on(_, _), -0.2973886164594694) :- fewer_pointing_2_than_pointing_1, !.
delta(34, switch_on(_, Satellite), -0.003551994169984546) :- pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(34, switch_on(_, _), 0.037277271873316004) :- !.
delta(34, switch_off(_, _), -0.013179813031829066) :- !.
delta(34, calibrate(_, _, Direction), 0.028069435930066892) :- pointing(Satellite, Direction), goal_pointing(Satellite, _), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(34, calibrate(_, _, Direction), -0.0009670719429834715) :- pointing(Satellite, Direction), goal_pointing(Satellite, _), !.
delta(34, calibrate(Satellite, _, _), 0.0011039442794043362) :- pointing(Satellite, Direction), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(34, calibrate(_, _, _), -0.026911777044340272) :- power_avail(_), !.
delta(34, calibrate(_, _, _), 0.0008315196332872534) :- !.
delta(34, take_image(_, Direction, _, Is_mode), -0.0002986317247702841) :- todo_have_image(Direction2, Is_mode), pointing(_, Direction2), done_have_image(Direction, Is_mode), !.
delta(34, take_image(_, _, _, Is_mode), 0.05699790997215825) :- todo_have_image(Direction, Is_mode), pointing(_, Direction), !.
delta(34, take_image(_, _, _, _), -0.023299533291211358) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 207 examples, 28 leaves
delta(35, turn_to(Satellite, _, _), -0.004539439017039832) :- todo_pointing(Satellite, Direction), pointing(Satellite2, Direction), power_avail(Satellite), goal_pointing(Satellite2, Direction), !.
delta(35, turn_to(Satellite, _, _), 0.1452739086579852) :- todo_pointing(Satellite, Direction), pointing(_, Direction), power_avail(Satellite), !.
delta(35, turn_to(Satellite, Direction, _), 0.020813585571652988) :- todo_pointing(Satellite, Direction2), pointing(Satellite2, Direction2), could_calibrate(Satellite2, Direction), !.
delta(35, turn_to(Satellite, _, _), -0.050477575254171896) :- todo_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(35, turn_to(Satellite, Direction, _), -0.03643241600865282) :- could_take_image(Satellite, Direction), goal_pointing(Satellite2, Direction), power_avail(Satellite2), !.
delta(35, turn_to(Satellite, Direction, _), 0.10490653588075288) :- could_take_image(Satellite, Direction), !.
delta(35, turn_to(_, Direction, _), 0.03929781089307511) :- pointing(Satellite, Direction), goal_pointing(Satellite, _), !.
delta(35, turn_to(_, _, _), -0.4479405439592556) :- !.
delta(35, switch_on(Instrument, Satellite), -0.015530397964178225) :- calibrated(Instrument), todo_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(35, switch_on(Instrument, _), 0.006011758020044321) :- calibrated(Instrument), fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(35, switch_on(Instrument, _), -0.0006822857304745245) :- calibrated(Instrument), !.
delta(35, switch_on(Instrument, Satellite), 0.008204606609712945) :- goal_pointing(Satellite, Direction), calibration_target(Instrument, Direction), power_avail(Satellite2), needed_pointing_to_calibrate_to_take_image(Satellite2, Direction), !.
delta(35, switch_on(Instrument, Satellite), -0.018858270380758487) :- goal_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(35, switch_on(_, Satellite), -0.0036493036173409076) :- todo_pointing(Satellite, Direction), done_have_image(Direction, _), !.
delta(35, switch_on(_, _), 0.337696031944401) :- !.
delta(35, switch_off(_, _), -0.04473572854906824) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(35, switch_off(Instrument, _), -0.0017996974599139334) :- supports(Instrument, Is_mode), have_image(_, Is_mode), !.
delta(35, switch_off(Instrument, _), 0.0510442186486009) :- calibration_target(Instrument, Direction), todo_pointing(_, Direction), !.
delta(35, switch_off(_, _), -2.5306745764698366e-5) :- !.
delta(35, calibrate(_, _, Direction), 0.022625306215092126) :- pointing(Satellite, Direction), could_calibrate_needed_calibrated_to_take_image(Satellite, Direction), !.
delta(35, calibrate(_, _, Direction), 1.4938796382591826e-6) :- todo_have_image(Direction, Is_mode), done_have_image(_, Is_mode), !.
delta(35, calibrate(_, _, _), -0.005869259969311905) :- !.
delta(35, take_image(Satellite, Direction, _, Is_mode), -0.0007079043374537167) :- todo_have_image(Direction2, Is_mode), needed_pointing_to_take_image(Satellite, Direction2), todo_have_image(Direction2, Is_mode2), have_image(Direction, Is_mode2), !.
delta(35, take_image(Satellite, _, _, Is_mode), 0.07264336477591321) :- todo_have_image(Direction, Is_mode), needed_pointing_to_take_image(Satellite, Direction), !.
delta(35, take_image(_, _, _, _), 0.002860164281907678) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(35, take_image(_, Direction, _, _), 0.002098028417720041) :- goal_pointing(Satellite, Direction), could_take_image(Satellite, Direction), !.
delta(35, take_image(_, _, _, _), -0.1302953789468646) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 227 examples, 23 leaves
delta(36, turn_to(Satellite, Direction, _), -0.11429004376074701) :- todo_pointing(Satellite, Direction2), todo_have_image(Direction2, _), needed_pointing_to_take_image(Satellite, Direction), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(36, turn_to(Satellite, Direction, _), 0.0010544582598302863) :- todo_pointing(Satellite, Direction2), todo_have_image(Direction2, _), needed_pointing_to_take_image(Satellite, Direction), !.
delta(36, turn_to(Satellite, Direction, _), 0.02642598655366693) :- todo_pointing(Satellite, Direction2), todo_have_image(Direction2, _), todo_pointing(Satellite, Direction), !.
delta(36, turn_to(Satellite, _, _), -0.006331823156057391) :- todo_pointing(Satellite, Direction), todo_have_image(Direction, _), !.
delta(36, turn_to(_, Direction, Direction2), -0.047322738472233415) :- goal_pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), !.
delta(36, turn_to(Satellite, _, _), -0.038280120631538316) :- pointing(Satellite, Direction), could_take_image_through_calibration_target_for_todo_have_image_1_instrument(Satellite, Direction), !.
delta(36, turn_to(_, _, _), 0.17029411026064134) :- !.
delta(36, switch_on(_, Satellite), 0.14449147346374147) :- goal_pointing(Satellite, Direction), goal_have_image(Direction, _), fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(36, switch_on(_, Satellite), -0.00025947341163038904) :- goal_pointing(Satellite, Direction), goal_have_image(Direction, _), !.
delta(36, switch_on(_, _), -0.04793828954039396) :- fewer_pointing_2_than_pointing_1, !.
delta(36, switch_on(Instrument, Satellite), 0.004370283789855943) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(36, switch_on(_, _), -0.0024077156922764557) :- !.
delta(36, switch_off(_, _), -0.017165523839038126) :- !.
delta(36, calibrate(_, _, Direction), 0.004966016303267217) :- power_avail(Satellite), goal_pointing(Satellite, _), goal_pointing(Satellite, Direction), !.
delta(36, calibrate(Satellite, _, _), 5.4333421574855926e-5) :- power_avail(Satellite2), goal_pointing(Satellite2, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(36, calibrate(_, _, _), -0.110883428264568) :- power_avail(Satellite), goal_pointing(Satellite, _), !.
delta(36, calibrate(_, _, _), -0.0011531448383101156) :- power_on(Instrument), calibrated(Instrument), !.
delta(36, calibrate(_, _, _), 0.011464584524633295) :- !.
delta(36, take_image(Satellite, Direction, _, Is_mode), 0.00023922451556248058) :- have_image(Direction2, Is_mode), pointing(_, Direction2), could_take_image_through_calibration_target_for_todo_have_image_1_instrument(Satellite, Direction), !.
delta(36, take_image(_, _, _, Is_mode), -0.02445332658763052) :- have_image(Direction, Is_mode), pointing(_, Direction), !.
delta(36, take_image(_, Direction, _, Is_mode), 0.008218661429159254) :- todo_have_image(Direction, Is_mode), !.
delta(36, take_image(_, _, _, _), -0.0004789446848512049) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 214 examples, 25 leaves
delta(37, turn_to(Satellite, Direction, _), -0.19591624664301618) :- goal_pointing(Satellite, Direction2), todo_pointing(_, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), power_avail(Satellite), !.
delta(37, turn_to(Satellite, Direction, _), 0.0010585945254475901) :- goal_pointing(Satellite, Direction2), todo_pointing(_, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(37, turn_to(Satellite, _, _), 0.27768249142597073) :- goal_pointing(Satellite, Direction), todo_pointing(_, Direction), fewer_pointing_2_than_pointing_1, !.
delta(37, turn_to(Satellite, _, _), -0.05114176321552623) :- goal_pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(37, turn_to(_, _, Direction), -0.0071850870486867766) :- done_pointing(Satellite, Direction), power_avail(Satellite), fewer_power_on_than_pointing_2, !.
delta(37, turn_to(_, _, Direction), 0.03470738669949534) :- done_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(37, turn_to(_, Direction, Direction2), 0.009451164064304884) :- todo_pointing(Satellite, Direction), could_take_image(Satellite, Direction2), !.
delta(37, turn_to(_, _, _), -0.36080907193500855) :- !.
delta(37, switch_on(_, Satellite), -0.008063735783171906) :- goal_pointing(Satellite, _), power_on(Instrument), needed_calibrated_to_take_image(Instrument), !.
delta(37, switch_on(Instrument, Satellite), -0.0012120099895696335) :- goal_pointing(Satellite, _), todo_pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(37, switch_on(_, Satellite), 0.3083283434034949) :- goal_pointing(Satellite, _), !.
delta(37, switch_on(Instrument, _), 0.017733096339022515) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(37, switch_on(Instrument, _), -0.0035413912204573816) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), !.
delta(37, switch_on(_, _), -0.06447951461058683) :- fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(37, switch_on(_, _), 0.004826777356823327) :- !.
delta(37, switch_off(_, Satellite), -1.2623714413334739e-5) :- done_pointing(Satellite, Direction), done_have_image(Direction, _), could_take_image(Satellite, Direction), !.
delta(37, switch_off(_, Satellite), 0.03037377900823221) :- done_pointing(Satellite, Direction), done_have_image(Direction, _), !.
delta(37, switch_off(_, _), -0.016568688062975616) :- !.
delta(37, calibrate(_, _, Direction), 0.02436630525600415) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(37, calibrate(_, _, _), -0.0021610600578149688) :- !.
delta(37, take_image(Satellite, _, _, _), -0.06323649196419528) :- todo_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(37, take_image(Satellite, _, _, Is_mode), -0.0013327328212912211) :- pointing(Satellite, Direction), have_image(Direction, Is_mode), !.
delta(37, take_image(_, _, _, _), -1.7964398106452636e-5) :- fewer_power_on_than_todo_have_image_2, !.
delta(37, take_image(_, _, _, _), 0.04771414046141936) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 275 examples, 21 leaves
delta(38, turn_to(Satellite, Direction, Direction2), 0.01693614973160882) :- pointing(Satellite2, Direction), power_avail(Satellite2), on_board(Instrument, Satellite), calibration_target(Instrument, Direction2), power_on(Instrument), !.
delta(38, turn_to(Satellite, Direction, Direction2), -0.05472125125766948) :- pointing(Satellite2, Direction), power_avail(Satellite2), on_board(Instrument, Satellite), calibration_target(Instrument, Direction2), !.
delta(38, turn_to(Satellite, Direction, _), -0.01572887127601958) :- pointing(Satellite2, Direction), power_avail(Satellite2), todo_pointing(Satellite2, Direction2), could_take_image(Satellite, Direction2), !.
delta(38, turn_to(_, Direction, _), 0.3991003963760851) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(38, turn_to(Satellite, _, _), -0.005553683617855604) :- goal_pointing(Satellite, Direction), todo_pointing(_, Direction), fewer_pointing_2_than_todo_pointing_1, !.
delta(38, turn_to(Satellite, _, _), -0.42226420965685285) :- goal_pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(38, turn_to(Satellite, _, _), -0.031501978789663036) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(38, turn_to(_, _, _), 0.1131770761931744) :- !.
delta(38, switch_on(Instrument, Satellite), -0.0005431984347901693) :- calibration_target(Instrument, Direction), needed_pointing_to_take_image(Satellite, Direction), goal_pointing(Satellite, Direction2), done_pointing(Satellite, Direction2), !.
delta(38, switch_on(Instrument, Satellite), 0.1744257075525221) :- calibration_target(Instrument, Direction), needed_pointing_to_take_image(Satellite, Direction), !.
delta(38, switch_on(_, Satellite), 0.019178142570051758) :- todo_pointing(Satellite, Direction), done_pointing(_, Direction), !.
delta(38, switch_on(_, Satellite), 0.005501236974727314) :- goal_pointing(Satellite, Direction), done_have_image(Direction, _), !.
delta(38, switch_on(_, _), -0.175275081158785) :- !.
delta(38, switch_off(_, _), -0.02211157375528727) :- !.
delta(38, calibrate(Satellite, _, _), 0.02051853137485932) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(38, calibrate(_, _, _), -0.019337787352607046) :- !.
delta(38, take_image(_, Direction, _, Is_mode), 0.0002657517880033987) :- goal_pointing(Satellite, Direction), done_pointing(Satellite, Direction2), todo_have_image(Direction2, Is_mode), !.
delta(38, take_image(_, Direction, _, _), -0.01911671232684998) :- goal_pointing(_, Direction), !.
delta(38, take_image(_, Direction, _, Is_mode), 0.015034665300471298) :- todo_have_image(Direction, Is_mode), !.
delta(38, take_image(_, _, _, _), -0.0026137916149573176) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 223 examples, 24 leaves
delta(39, turn_to(Satellite, Direction, Direction2), -0.00907405599737435) :- pointing(Satellite2, Direction2), could_take_image(Satellite2, Direction), pointing(Satellite3, Direction2), could_take_image_todo_have_image(Satellite3, Direction2), power_avail(Satellite), !.
delta(39, turn_to(_, Direction, Direction2), 0.03950167871658173) :- pointing(Satellite, Direction2), could_take_image(Satellite, Direction), pointing(Satellite2, Direction2), could_take_image_todo_have_image(Satellite2, Direction2), !.
delta(39, turn_to(Satellite, Direction, Direction2), 0.031630319885960594) :- pointing(Satellite2, Direction2), could_take_image(Satellite2, Direction), pointing(Satellite, Direction3), could_calibrate(Satellite, Direction3), !.
delta(39, turn_to(_, Direction, Direction2), -0.23826371029226107) :- pointing(Satellite, Direction2), could_take_image(Satellite, Direction), !.
delta(39, turn_to(_, _, Direction), -0.0574320313482495) :- done_pointing(Satellite, Direction), power_avail(Satellite), fewer_power_on_than_todo_have_image_2, !.
delta(39, turn_to(_, _, Direction), 0.015009398494426649) :- done_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(39, turn_to(_, Direction, Direction2), -0.03716848795513256) :- goal_pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), !.
delta(39, turn_to(_, _, _), 0.17030219352012294) :- !.
delta(39, switch_on(Instrument, Satellite), 0.0027101983451513234) :- pointing(Satellite, Direction), done_pointing(_, Direction), fewer_power_on_than_todo_have_image_1_pointing_2, calibrated(Instrument), !.
delta(39, switch_on(_, Satellite), -0.058363214212446224) :- pointing(Satellite, Direction), done_pointing(_, Direction), fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(39, switch_on(_, Satellite), -0.004779915825955816) :- pointing(Satellite, Direction), done_pointing(_, Direction), goal_pointing(Satellite, Direction), !.
delta(39, switch_on(_, Satellite), 0.007731683464255476) :- pointing(Satellite, Direction), done_pointing(_, Direction), !.
delta(39, switch_on(_, _), 0.08330363999206056) :- power_avail(Satellite), goal_pointing(Satellite, _), fewer_pointing_2_than_pointing_1, !.
delta(39, switch_on(_, _), -0.002444886733049412) :- power_avail(Satellite), goal_pointing(Satellite, _), !.
delta(39, switch_on(Instrument, Satellite), 0.0048595890936653985) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(39, switch_on(_, _), -0.023719363603772897) :- !.
delta(39, switch_off(_, _), -0.016982927727810144) :- !.
delta(39, calibrate(_, _, Direction), 0.0002270245318753538) :- power_avail(Satellite), todo_pointing(Satellite, _), pointing(Satellite, Direction), !.
delta(39, calibrate(_, _, _), -0.012541810356396624) :- power_avail(Satellite), todo_pointing(Satellite, _), !.
delta(39, calibrate(_, _, _), 0.02930971624270126) :- fewer_calibrated_power_on_than_pointing_2, !.
delta(39, calibrate(_, _, _), -0.0009028254134829486) :- !.
delta(39, take_image(_, Direction, _, Is_mode), 0.02665658751960188) :- todo_have_image(Direction, Is_mode), !.
delta(39, take_image(_, _, _, _), -0.007148949756867069) :- !.
delta(39, _, 0.0).

% tree 40: step size 1.0, 206 examples, 28 leaves
delta(40, turn_to(Satellite, Direction, Direction2), -0.00035343137729304763) :- goal_pointing(Satellite, Direction3), done_pointing(_, Direction3), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(40, turn_to(Satellite, _, Direction), 0.020641569232393055) :- goal_pointing(Satellite, Direction2), done_pointing(_, Direction2), could_calibrate_for_todo_have_image_direction_any(Satellite, Direction), !.
delta(40, turn_to(Satellite, Direction, _), 0.0017124014449456952) :- goal_pointing(Satellite, Direction2), done_pointing(_, Direction2), could_take_image_todo_have_image(Satellite, Direction), !.
delta(40, turn_to(Satellite, _, _), -0.2085900666014243) :- goal_pointing(Satellite, Direction), done_pointing(_, Direction), !.
delta(40, turn_to(_, Direction, Direction2), -0.07345251311153954) :- pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), !.
delta(40, turn_to(_, Direction, Direction2), -0.018002187064617314) :- goal_have_image(Direction, Is_mode), have_image(Direction2, Is_mode), !.
delta(40, turn_to(_, _, _), 0.19267850957421861) :- !.
delta(40, switch_on(Instrument, _), 0.0007109720590398493) :- fewer_calibrated_power_on_than_todo_have_image_1_pointing_2, power_on(_), calibrated(Instrument), !.
delta(40, switch_on(_, _), -0.06345913144236595) :- fewer_calibrated_power_on_than_todo_have_image_1_pointing_2, power_on(_), !.
delta(40, switch_on(Instrument, _), 0.005177025873794495) :- fewer_calibrated_power_on_than_todo_have_image_1_pointing_2, calibration_target(Instrument, Direction), todo_have_image(Direction, _), !.
delta(40, switch_on(_, _), -0.0038084580916720907) :- fewer_calibrated_power_on_than_todo_have_image_1_pointing_2, !.
delta(40, switch_on(Instrument, Satellite), -0.0005263501211631805) :- pointing(Satellite, Direction), calibration_target(_, Direction), calibrated(Instrument), !.
delta(40, switch_on(_, Satellite), 0.048153255519834626) :- pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(40, switch_on(_, _), -0.0061727144532925755) :- !.
delta(40, switch_off(Instrument, _), 0.06991787029649632) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), fewer_calibrated_than_todo_have_image_1, !.
delta(40, switch_off(Instrument, _), -0.0023650352956587494) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), !.
delta(40, switch_off(_, _), -0.011725955963531744) :- !.
delta(40, calibrate(Satellite, _, Direction), 0.006624262077511335) :- pointing(Satellite, Direction2), have_image(Direction2, _), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(40, calibrate(Satellite, _, _), -0.0006546877553975174) :- pointing(Satellite, Direction), have_image(Direction, _), !.
delta(40, calibrate(_, _, Direction), 0.004251204377845284) :- power_avail(Satellite), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(40, calibrate(_, _, _), -0.02655372702656055) :- !.
delta(40, take_image(Satellite, Direction, _, Is_mode), 0.0025386912003181328) :- goal_have_image(Direction, Is_mode), todo_pointing(Satellite, Direction2), goal_have_image(Direction2, _), todo_have_image(Direction, Is_mode), !.
delta(40, take_image(Satellite, Direction, _, Is_mode), -0.0004550323059438975) :- goal_have_image(Direction, Is_mode), todo_pointing(Satellite, Direction2), goal_have_image(Direction2, _), !.
delta(40, take_image(_, Direction, _, Is_mode), 0.0018918229284431572) :- goal_have_image(Direction, Is_mode), todo_have_image(Direction2, Is_mode), done_have_image(Direction2, _), !.
delta(40, take_image(_, Direction, _, Is_mode), -0.04092131008489549) :- goal_have_image(Direction, Is_mode), !.
delta(40, take_image(_, Direction, _, _), 0.04656633285846072) :- goal_have_image(Direction, _), !.
delta(40, take_image(_, _, _, _), -0.0014715512001025094) :- !.
delta(40, _, 0.0).

% tree 41: step size 1.0, 219 examples, 25 leaves
delta(41, turn_to(Satellite, Direction, _), -0.0029383938516671145) :- goal_have_image(Direction, Is_mode), todo_have_image(Direction2, Is_mode), could_calibrate(Satellite, Direction2), pointing(Satellite, Direction2), !.
delta(41, turn_to(Satellite, Direction, _), 0.036374102936505524) :- goal_have_image(Direction, Is_mode), todo_have_image(Direction2, Is_mode), could_calibrate(Satellite, Direction2), !.
delta(41, turn_to(_, Direction, Direction2), 0.028509559643823793) :- goal_have_image(Direction, _), todo_pointing(Satellite, Direction), could_calibrate(Satellite, Direction2), !.
delta(41, turn_to(_, Direction, _), -0.24354726546522296) :- goal_have_image(Direction, _), !.
delta(41, turn_to(Satellite, _, _), -0.04411972975097559) :- pointing(Satellite, Direction), could_take_image_todo_have_image(Satellite, Direction), !.
delta(41, turn_to(_, Direction, _), 0.12831438288031377) :- calibration_target(_, Direction), !.
delta(41, turn_to(_, _, _), -0.031015161262145638) :- !.
delta(41, switch_on(Instrument, Satellite), -0.0011509222946283059) :- goal_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_power_on_than_todo_have_image_2, calibration_target(Instrument, Direction), !.
delta(41, switch_on(_, Satellite), 0.20178538278018776) :- goal_pointing(Satellite, Direction), calibration_target(_, Direction), fewer_calibrated_power_on_than_todo_have_image_2, !.
delta(41, switch_on(_, Satellite), -0.004569626611583743) :- goal_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(41, switch_on(Instrument, _), 0.01724271273653818) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), needed_calibrated_to_take_image(Instrument), !.
delta(41, switch_on(Instrument, _), -0.004662802907748535) :- calibration_target(Instrument, Direction), goal_pointing(_, Direction), !.
delta(41, switch_on(_, _), 0.003016401060479047) :- calibrated(Instrument), needed_power_on_to_take_image(Instrument), !.
delta(41, switch_on(_, _), -0.03264970737024771) :- !.
delta(41, switch_off(Instrument, _), -0.00011404209402636352) :- power_avail(Satellite), done_pointing(Satellite, _), calibrated(Instrument), !.
delta(41, switch_off(_, _), 0.032472186450337476) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(41, switch_off(_, _), -0.011800001551330248) :- !.
delta(41, calibrate(_, _, Direction), 0.009946057430067127) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(41, calibrate(_, _, _), -0.001365514015949701) :- !.
delta(41, take_image(_, Direction, _, Is_mode), 0.0012984809083711275) :- goal_have_image(Direction2, Is_mode), goal_pointing(Satellite, Direction2), could_take_image_todo_have_image(Satellite, Direction), !.
delta(41, take_image(_, Direction, _, Is_mode), -0.044788188061999135) :- goal_have_image(Direction2, Is_mode), goal_pointing(Satellite, Direction2), pointing(Satellite, Direction), !.
delta(41, take_image(_, _, _, Is_mode), 0.0005133238758656156) :- goal_have_image(Direction, Is_mode), goal_pointing(_, Direction), !.
delta(41, take_image(_, Direction, _, Is_mode), 0.005165430090346887) :- todo_have_image(Direction, Is_mode), !.
delta(41, take_image(_, _, _, _), -0.0006699344788238455) :- !.
delta(41, _, 0.0).

% tree 42: step size 1.0, 204 examples, 29 leaves
delta(42, turn_to(Satellite, Direction, _), -0.0015434202870147362) :- done_pointing(Satellite, Direction2), calibration_target(_, Direction2), could_take_image(Satellite, Direction), fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(42, turn_to(Satellite, Direction, _), 0.006800305929205868) :- done_pointing(Satellite, Direction2), calibration_target(_, Direction2), could_take_image(Satellite, Direction), !.
delta(42, turn_to(Satellite, _, _), -0.19795672419140437) :- done_pointing(Satellite, Direction), calibration_target(_, Direction), !.
delta(42, turn_to(_, Direction, Direction2), 0.018309617169205306) :- pointing(Satellite, Direction2), could_take_image_for_todo_have_image_any_is_mode(Satellite, Direction), power_avail(Satellite2), needed_pointing_to_take_image(Satellite2, Direction), !.
delta(42, turn_to(_, Direction, Direction2), -0.062034541899262025) :- pointing(Satellite, Direction2), could_take_image_for_todo_have_image_any_is_mode(Satellite, Direction), !.
delta(42, turn_to(_, Direction, _), -0.03092177631831049) :- pointing(Satellite, Direction), todo_pointing(Satellite, _), !.
delta(42, turn_to(_, _, _), 0.3464361460972243) :- !.
delta(42, switch_on(_, Satellite), -0.01222504364623205) :- fewer_pointing_1_than_todo_have_image_1, pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(42, switch_on(_, _), 0.04388354039771463) :- fewer_pointing_1_than_todo_have_image_1, !.
delta(42, switch_on(Instrument, Satellite), -0.0016614768820891078) :- pointing(Satellite, Direction), goal_pointing(_, Direction), calibrated(Instrument), !.
delta(42, switch_on(_, Satellite), 0.019013028389755528) :- pointing(Satellite, Direction), goal_pointing(_, Direction), !.
delta(42, switch_on(_, _), -0.23208454048679736) :- power_avail(Satellite), goal_pointing(Satellite, _), !.
delta(42, switch_on(_, _), 0.00216283523147726) :- !.
delta(42, switch_off(Instrument, _), -0.0005857170145609726) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), calibrated(Instrument), !.
delta(42, switch_off(Instrument, Satellite), -3.6541940184547946e-5) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), pointing(Satellite, Direction), !.
delta(42, switch_off(Instrument, _), 0.053635969995050034) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), !.
delta(42, switch_off(_, _), -0.020307632976624364) :- !.
delta(42, calibrate(Satellite, Instrument, _), -0.0009268227029940292) :- goal_pointing(Satellite, Direction), todo_have_image(Direction, _), calibrated(Instrument), !.
delta(42, calibrate(Satellite, _, _), 0.009046820212398714) :- goal_pointing(Satellite, Direction), todo_have_image(Direction, _), !.
delta(42, calibrate(Satellite, _, _), 0.0011122684702780928) :- on_board(Instrument, Satellite), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(42, calibrate(_, _, Direction), -0.028975570889200185) :- goal_have_image(Direction, _), !.
delta(42, calibrate(_, _, _), 0.00018575066169560222) :- !.
delta(42, take_image(Satellite, _, _, _), 0.00013068799612562005) :- goal_pointing(Satellite, Direction), have_image(Direction, _), fewer_calibrated_than_todo_have_image_2, !.
delta(42, take_image(Satellite, _, _, _), 3.1692317006338125e-5) :- goal_pointing(Satellite, Direction), have_image(Direction, _), fewer_calibrated_than_todo_have_image_1, !.
delta(42, take_image(Satellite, _, _, _), -0.06109457967541881) :- goal_pointing(Satellite, Direction), have_image(Direction, _), !.
delta(42, take_image(Satellite, _, _, Is_mode), -0.0007540190897898534) :- pointing(Satellite, Direction), have_image(Direction, Is_mode), !.
delta(42, take_image(_, _, _, Is_mode), 0.03901016711805627) :- goal_have_image(Direction, Is_mode), pointing(_, Direction), !.
delta(42, take_image(_, _, _, _), -0.00027983780674531444) :- !.
delta(42, _, 0.0).

% tree 43: step size 1.0, 231 examples, 26 leaves
delta(43, turn_to(_, Direction, Direction2), 0.026686241653368227) :- goal_have_image(Direction, _), pointing(Satellite, Direction2), needed_pointing_to_take_image(Satellite, Direction), could_calibrate_needed_calibrated_to_take_image(Satellite, Direction2), !.
delta(43, turn_to(_, Direction, Direction2), -0.09955289521587822) :- goal_have_image(Direction, _), pointing(Satellite, Direction2), needed_pointing_to_take_image(Satellite, Direction), !.
delta(43, turn_to(_, Direction, Direction2), -0.02815282181886834) :- goal_have_image(Direction, _), todo_pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction2), !.
delta(43, turn_to(_, Direction, _), 0.3862854234730916) :- goal_have_image(Direction, _), !.
delta(43, turn_to(Satellite, _, Direction), -0.022400465723234966) :- done_pointing(Satellite2, Direction), power_avail(Satellite2), goal_pointing(Satellite, Direction), !.
delta(43, turn_to(_, _, Direction), 0.03928551046591791) :- done_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(43, turn_to(_, Direction, Direction2), 0.02016366828444338) :- todo_pointing(Satellite, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(43, turn_to(_, _, _), -0.3515537823729487) :- !.
delta(43, switch_on(Instrument, Satellite), 0.0018769189375000776) :- goal_pointing(Satellite, Direction), pointing(_, Direction), calibrated(Instrument), !.
delta(43, switch_on(_, Satellite), -0.09003949814863797) :- goal_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(43, switch_on(_, Satellite), 0.09995353190466229) :- on_board(Instrument, Satellite), needed_power_on_to_take_image(Instrument), !.
delta(43, switch_on(Instrument, _), 0.016046025502547356) :- calibration_target(Instrument, Direction), done_have_image(Direction, _), !.
delta(43, switch_on(_, _), -0.01875157910647229) :- !.
delta(43, switch_off(_, _), -0.004047245308436303) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(43, switch_off(Instrument, Satellite), 0.03633991058086225) :- calibration_target(Instrument, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(43, switch_off(_, _), -0.0004545619682807517) :- !.
delta(43, calibrate(_, _, Direction), -0.016658390120830927) :- calibrated(Instrument), calibration_target(Instrument, Direction), !.
delta(43, calibrate(_, _, _), 0.0209139178055915) :- fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(43, calibrate(_, _, _), -0.0003333655365911201) :- !.
delta(43, take_image(Satellite, _, _, Is_mode), -0.002069122817041748) :- goal_pointing(Satellite, _), pointing(Satellite, Direction), have_image(Direction, Is_mode), !.
delta(43, take_image(Satellite, _, _, Is_mode), -0.0002786420403512718) :- goal_pointing(Satellite, _), supports(Instrument, Is_mode), needed_calibrated_to_take_image(Instrument), !.
delta(43, take_image(Satellite, _, _, _), 0.021072434859209982) :- goal_pointing(Satellite, _), !.
delta(43, take_image(_, _, _, _), 0.0018209161421653183) :- fewer_calibrated_than_todo_have_image_2, !.
delta(43, take_image(_, Direction, _, _), 0.00015370400988954736) :- goal_pointing(Satellite, Direction), power_avail(Satellite), !.
delta(43, take_image(_, _, _, _), -0.05399106297493261) :- !.
delta(43, _, 0.0).

% tree 44: step size 1.0, 217 examples, 25 leaves
delta(44, turn_to(Satellite, Direction, Direction2), 0.00790140444548881) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), goal_pointing(Satellite2, Direction2), power_avail(Satellite2), could_calibrate(Satellite, Direction), !.
delta(44, turn_to(Satellite, Direction, Direction2), -0.09191431632650206) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), goal_pointing(Satellite2, Direction2), power_avail(Satellite2), !.
delta(44, turn_to(Satellite, Direction, Direction2), -0.02934555377342987) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), pointing(Satellite2, Direction2), could_take_image_for_todo_have_image_direction_any(Satellite2, Direction), !.
delta(44, turn_to(Satellite, Direction, _), 0.1884322165929002) :- on_board(Instrument, Satellite), calibration_target(Instrument, Direction), !.
delta(44, turn_to(_, Direction, _), 0.04695256942647606) :- fewer_pointing_2_than_pointing_1, power_on(Instrument), calibration_target(Instrument, Direction), !.
delta(44, turn_to(_, _, _), -0.3400914896402648) :- fewer_pointing_2_than_pointing_1, !.
delta(44, turn_to(_, _, Direction), -0.00625826935762688) :- pointing(Satellite, Direction), could_take_image_todo_have_image(Satellite, Direction), !.
delta(44, turn_to(_, _, _), 0.07770494628473398) :- !.
delta(44, switch_on(Instrument, Satellite), 0.0007054353325893099) :- goal_pointing(Satellite, Direction), pointing(_, Direction), fewer_power_on_than_todo_have_image_1, calibrated(Instrument), !.
delta(44, switch_on(_, Satellite), -0.08318165392067338) :- goal_pointing(Satellite, Direction), pointing(_, Direction), fewer_power_on_than_todo_have_image_1, !.
delta(44, switch_on(_, Satellite), 0.014936853228758628) :- goal_pointing(Satellite, Direction), pointing(_, Direction), fewer_pointing_2_than_pointing_1, !.
delta(44, switch_on(_, Satellite), -0.0044221173222940315) :- goal_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(44, switch_on(Instrument, Satellite), 0.0) :- fewer_pointing_1_than_todo_have_image_1, pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(44, switch_on(_, _), 0.0008112732404604528) :- fewer_pointing_1_than_todo_have_image_1, !.
delta(44, switch_on(Instrument, _), 0.24207254959827182) :- supports(Instrument, Is_mode), todo_have_image(_, Is_mode), !.
delta(44, switch_on(_, _), -0.0008247295078381548) :- !.
delta(44, switch_off(_, _), -0.004947673239760647) :- !.
delta(44, calibrate(Satellite, _, Direction), 0.006594407799123054) :- todo_pointing(Satellite, Direction2), todo_pointing(Satellite2, Direction2), could_calibrate(Satellite2, Direction), !.
delta(44, calibrate(Satellite, _, _), -0.0008783304088378853) :- todo_pointing(Satellite, _), !.
delta(44, calibrate(_, _, _), 0.0008726304782991595) :- fewer_power_on_than_todo_have_image_2, !.
delta(44, calibrate(_, _, _), 0.0007159170563775777) :- power_avail(Satellite), done_pointing(Satellite, _), !.
delta(44, calibrate(_, _, _), -0.01229377011835313) :- !.
delta(44, take_image(_, Direction, _, Is_mode), 0.01736796682497589) :- todo_have_image(Direction, Is_mode), !.
delta(44, take_image(_, _, _, _), -0.0034561202995482304) :- !.
delta(44, _, 0.0).

% tree 45: step size 1.0, 202 examples, 21 leaves
delta(45, turn_to(Satellite, Direction, _), -0.033501069131623165) :- goal_pointing(Satellite, Direction2), pointing(_, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), power_avail(Satellite), !.
delta(45, turn_to(Satellite, Direction, _), 0.005622956647544328) :- goal_pointing(Satellite, Direction2), pointing(_, Direction2), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(45, turn_to(Satellite, _, _), -0.0231724610552743) :- goal_pointing(Satellite, Direction), pointing(Satellite2, Direction), could_take_image(Satellite2, Direction), !.
delta(45, turn_to(Satellite, _, _), 0.2572445434090881) :- goal_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(45, turn_to(_, _, Direction), 0.09359336733972413) :- goal_pointing(Satellite, Direction), done_pointing(Satellite, Direction), goal_have_image(Direction, _), !.
delta(45, turn_to(_, _, Direction), -0.020886561469264944) :- goal_pointing(Satellite, Direction), done_pointing(Satellite, Direction), !.
delta(45, turn_to(Satellite, _, _), 0.05291854381455431) :- todo_pointing(Satellite, Direction), needed_pointing_to_calibrate_to_take_image(Satellite, Direction), !.
delta(45, turn_to(_, _, _), -0.25130918601012564) :- !.
delta(45, switch_on(Instrument, Satellite), 0.006030516170080637) :- calibration_target(Instrument, Direction), pointing(_, Direction), goal_pointing(Satellite, Direction), fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(45, switch_on(Instrument, Satellite), -0.0026264128423024095) :- calibration_target(Instrument, Direction), pointing(_, Direction), goal_pointing(Satellite, Direction), !.
delta(45, switch_on(Instrument, _), -0.15112066361846277) :- calibration_target(Instrument, Direction), pointing(_, Direction), fewer_calibrated_than_pointing_2, !.
delta(45, switch_on(Instrument, _), 0.000187391987799573) :- calibration_target(Instrument, Direction), pointing(_, Direction), !.
delta(45, switch_on(_, _), 0.09130093589095938) :- fewer_calibrated_than_pointing_2, !.
delta(45, switch_on(_, _), -0.0014354722414680063) :- !.
delta(45, switch_off(_, _), -0.003656111117232447) :- !.
delta(45, calibrate(Satellite, _, _), 0.011337637607818548) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), fewer_calibrated_power_on_than_todo_have_image_1, !.
delta(45, calibrate(Satellite, _, _), -0.0008022195306226549) :- pointing(Satellite, Direction), could_calibrate_through_supports_for_todo_have_image_2_instrument(Satellite, Direction), !.
delta(45, calibrate(_, _, _), -0.012148445943618563) :- !.
delta(45, take_image(_, Direction, Instrument, _), 0.019336504016095993) :- todo_have_image(Direction, Is_mode), supports(Instrument, Is_mode), !.
delta(45, take_image(_, _, _, _), -0.01658842884647074) :- !.
delta(45, _, 0.0).

% tree 46: step size 1.0, 341 examples, 28 leaves
delta(46, turn_to(_, Direction, Direction2), -0.30996917606373114) :- calibration_target(Instrument, Direction), needed_power_on_to_take_image(Instrument), calibration_target(Instrument2, Direction2), needed_calibrated_to_take_image(Instrument2), fewer_calibrated_than_todo_have_image_1_pointing_2, !.
delta(46, turn_to(_, Direction, Direction2), 0.016372148510792488) :- calibration_target(Instrument, Direction), needed_power_on_to_take_image(Instrument), calibration_target(Instrument2, Direction2), needed_calibrated_to_take_image(Instrument2), !.
delta(46, turn_to(_, Direction, Direction2), 0.10386100989762793) :- calibration_target(Instrument, Direction), needed_power_on_to_take_image(Instrument), pointing(Satellite, Direction2), on_board(Instrument, Satellite), !.
delta(46, turn_to(_, Direction, _), -0.020929975617298754) :- calibration_target(Instrument, Direction), needed_power_on_to_take_image(Instrument), !.
delta(46, turn_to(Satellite, _, _), 0.04228243485717556) :- goal_pointing(Satellite, Direction), done_pointing(_, Direction), fewer_calibrated_than_todo_have_image_1, !.
delta(46, turn_to(Satellite, _, _), -0.09761554169009606) :- goal_pointing(Satellite, Direction), done_pointing(_, Direction), !.
delta(46, turn_to(_, Direction, Direction2), -0.04972945694327838) :- pointing(Satellite, Direction2), could_calibrate(Satellite, Direction), !.
delta(46, turn_to(_, _, _), 0.4587852328634985) :- !.
delta(46, switch_on(_, Satellite), -0.02188239466983701) :- fewer_pointing_2_than_pointing_1, pointing(Satellite, Direction), todo_pointing(_, Direction), !.
delta(46, switch_on(Instrument, _), -0.0024542191380354382) :- fewer_pointing_2_than_pointing_1, calibration_target(Instrument, Direction), goal_pointing(_, Direction), !.
delta(46, switch_on(_, _), 0.05810630518697214) :- fewer_pointing_2_than_pointing_1, !.
delta(46, switch_on(_, Satellite), 0.0010990651475652432) :- pointing(Satellite, Direction), goal_have_image(Direction, _), fewer_pointing_1_than_todo_have_image_1, !.
delta(46, switch_on(_, Satellite), -0.11978641851988699) :- pointing(Satellite, Direction), goal_have_image(Direction, _), !.
delta(46, switch_on(_, _), -0.00021532643337288443) :- power_on(_), !.
delta(46, switch_on(_, _), 0.019475019580684882) :- !.
delta(46, switch_off(_, _), -0.010670959961215464) :- !.
delta(46, calibrate(_, _, Direction), 0.008038526374215404) :- calibration_target(Instrument, Direction), needed_power_on_to_calibrate_to_take_image(Instrument), fewer_power_on_than_todo_have_image_1_pointing_2, !.
delta(46, calibrate(_, _, Direction), -2.3415081537685034e-6) :- calibration_target(Instrument, Direction), needed_power_on_to_calibrate_to_take_image(Instrument), !.
delta(46, calibrate(Satellite, _, _), 0.00013729720400136735) :- fewer_pointing_2_than_pointing_1, todo_pointing(Satellite, _), !.
delta(46, calibrate(_, _, _), -0.008707164883488935) :- fewer_pointing_2_than_pointing_1, !.
delta(46, calibrate(_, _, Direction), 0.0020381518154173788) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(46, calibrate(_, _, _), -0.0005267099798431741) :- !.
delta(46, take_image(_, _, _, Is_mode), 0.014280937458612043) :- todo_have_image(Direction, Is_mode), done_pointing(_, Direction), !.
delta(46, take_image(_, Direction, _, Is_mode), -0.1641589763464379) :- goal_have_image(Direction, Is_mode), power_avail(Satellite), goal_pointing(Satellite, _), !.
delta(46, take_image(_, Direction, _, Is_mode), 0.0005668125616897563) :- goal_have_image(Direction, Is_mode), !.
delta(46, take_image(Satellite, _, _, Is_mode), -0.00018175254103214427) :- todo_have_image(Direction, Is_mode), needed_pointing_to_take_image(Satellite, Direction), !.
delta(46, take_image(_, _, _, _), 0.012678641462595949) :- !.
delta(46, _, 0.0).

% tree 47: step size 1.0, 251 examples, 28 leaves
delta(47, turn_to(Satellite, Direction, _), -0.04293314799871701) :- todo_pointing(Satellite, Direction), calibrated(Instrument), calibration_target(Instrument, Direction), todo_pointing(Satellite2, Direction), power_avail(Satellite2), !.
delta(47, turn_to(Satellite, Direction, _), 0.007007223378407991) :- todo_pointing(Satellite, Direction), calibrated(Instrument), calibration_target(Instrument, Direction), !.
delta(47, turn_to(Satellite, Direction, Direction2), -0.0177056187137658) :- todo_pointing(Satellite, Direction), todo_pointing(Satellite2, Direction), needed_pointing_to_calibrate_to_take_image(Satellite2, Direction2), !.
delta(47, turn_to(Satellite, Direction, _), 0.19684056167021538) :- todo_pointing(Satellite, Direction), !.
delta(47, turn_to(Satellite, Direction, Direction2), 0.022829379990544765) :- power_avail(Satellite), todo_pointing(Satellite2, Direction2), needed_pointing_to_take_image(Satellite2, Direction), !.
delta(47, turn_to(Satellite, _, _), -0.15150672612429142) :- power_avail(Satellite), !.
delta(47, turn_to(Satellite, _, _), -0.01991471556554346) :- goal_pointing(Satellite, Direction), done_pointing(_, Direction), !.
delta(47, turn_to(_, _, _), 0.043764634516677114) :- !.
delta(47, switch_on(_, Satellite), 0.0024382293771108726) :- fewer_pointing_2_than_pointing_1, fewer_calibrated_than_todo_have_image_1, todo_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(47, switch_on(_, _), -0.06759335478778226) :- fewer_pointing_2_than_pointing_1, fewer_calibrated_than_todo_have_image_1, !.
delta(47, switch_on(_, _), -0.0017628438746055512) :- fewer_pointing_2_than_pointing_1, power_avail(Satellite), todo_pointing(Satellite, _), !.
delta(47, switch_on(_, _), 0.007234976273905599) :- fewer_pointing_2_than_pointing_1, !.
delta(47, switch_on(Instrument, Satellite), 0.0) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), power_on(Instrument2), needed_calibrated_to_take_image(Instrument2), !.
delta(47, switch_on(Instrument, Satellite), 0.05078927523047948) :- pointing(Satellite, Direction), calibration_target(Instrument, Direction), !.
delta(47, switch_on(_, Satellite), 0.004256090003828469) :- goal_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(47, switch_on(_, _), -0.010243958897113086) :- !.
delta(47, switch_off(_, _), -0.009101050069801872) :- power_on(Instrument), needed_calibrated_to_take_image(Instrument), !.
delta(47, switch_off(_, _), 0.024904195970419818) :- fewer_power_on_than_todo_have_image_1, !.
delta(47, switch_off(_, _), -0.00032990243818876406) :- !.
delta(47, calibrate(_, _, Direction), -0.08707718518020638) :- pointing(Satellite, Direction), power_avail(Satellite), goal_pointing(_, Direction), !.
delta(47, calibrate(_, _, Direction), 0.004850468541731457) :- pointing(Satellite, Direction), power_avail(Satellite), !.
delta(47, calibrate(Satellite, _, _), 0.09806938759557214) :- pointing(Satellite, Direction), could_calibrate(Satellite, Direction), !.
delta(47, calibrate(_, _, _), -0.014790381052187565) :- !.
delta(47, take_image(Satellite, _, _, _), -0.042346436875911435) :- todo_pointing(Satellite, Direction), pointing(_, Direction), fewer_pointing_2_than_pointing_1, !.
delta(47, take_image(Satellite, _, _, _), 3.1731961886983695e-6) :- todo_pointing(Satellite, Direction), pointing(_, Direction), !.
delta(47, take_image(_, Direction, _, Is_mode), 0.010972957096671275) :- todo_have_image(Direction, Is_mode), !.
delta(47, take_image(_, _, _, _), -0.0021354084006480244) :- !.
delta(47, _, 0.0).
