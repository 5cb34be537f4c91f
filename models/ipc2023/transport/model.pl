% SHA-256 of what follows: 3586860d37c15a1c347027194bcd75aceae1b0fb266ac76d97a72b4d7216befe
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
model(domain, 'transport.pl').
model(domain_sha256, '44591dcbf257a9d42d7792b216f8e5625943c2fcea1733f4c0e06b0bf319b5c8').
model(action, drive(vehicle, location, location)).
model(action, pick_up(vehicle, location, package, size, size)).
model(action, drop(vehicle, location, package, size, size)).
model(literal, todo_at(locatable, location)).
model(literal, goal_at(locatable, location)).
model(literal, done_at(locatable, location)).
model(literal, at(locatable, location)).
model(literal, in(package, vehicle)).
model(literal, capacity(vehicle, size)).
model(literal, road(location, location)).
model(literal, capacity_predecessor(size, size)).
model(literal, vehicle(locatable)).
model(literal, package(locatable)).
model(literal, beyond_road(location, location)).
model(literal, beyond_capacity_predecessor(size, size)).
model(literal, needed_in_to_drop(package)).
model(literal, needed_capacity_to_drop(size)).
model(literal, nearer_at(location, location, location)).
model(literal, wanted_at(vehicle, location)).
model(literal, toward_wanted_at(vehicle, location, location)).
model(literal, could_pick_up(vehicle, location)).
model(literal, toward_could_pick_up(vehicle, location, location)).
model(literal, could_pick_up_needed_in_to_drop(vehicle, location)).
model(literal, toward_could_pick_up_needed_in_to_drop(vehicle, location, location)).
model(literal, could_pick_up_needed_capacity_to_drop(vehicle, location)).
model(literal, toward_could_pick_up_needed_capacity_to_drop(vehicle, location, location)).
model(literal, could_pick_up_for_todo_at_any_location(vehicle, location)).
model(literal, toward_could_pick_up_for_todo_at_any_location(vehicle, location, location)).
model(literal, could_drop(vehicle, location)).
model(literal, could_drop_todo_at(vehicle, location)).
model(literal, toward_could_drop_todo_at(vehicle, location, location)).
model(literal, could_drop_for_todo_at_any_location(vehicle, location)).
model(literal, toward_could_drop_for_todo_at_any_location(vehicle, location, location)).
model(literal, nearer_capacity(size, size, size)).
model(literal, fewer_at_2_than_todo_at_1).
model(literal, fewer_at_2_than_at_1).
model(literal, fewer_at_2_than_todo_at_1_at_1).
model(literal, fewer_at_2_than_todo_at_2).
model(literal, fewer_in_2_than_todo_at_1).
model(literal, fewer_in_2_than_in_1).
model(literal, fewer_capacity_1_than_todo_at_1).
model(literal, fewer_capacity_1_than_in_1).
model(literal, fewer_in_2_than_todo_at_2).
model(literal, fewer_in_2_than_at_2).
model(literal, fewer_in_2_than_todo_at_2_at_2).
model(literal, fewer_capacity_1_than_todo_at_2).
model(literal, fewer_capacity_1_than_at_2).
model(literal, fewer_capacity_1_than_todo_at_2_at_2).
model(literal, fewer_capacity_2_than_todo_at_1).
model(literal, fewer_capacity_2_than_in_1).
model(literal, fewer_capacity_2_than_todo_at_2).
model(literal, fewer_capacity_2_than_at_2).
model(literal, fewer_capacity_2_than_todo_at_2_at_2).
model(bias, 'transport.yaml').
model(bias_sha256, '79cb43ae35462df9712e33d21ceb42094c3d725c55201a313424890dfe4682a8').
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
model(trained_episodes, 599).
model(trees, 43).

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

domain(transport).
:- ensure_loaded('transport.pl').
:- add_import_module(policy, transport, start).

% tree 1: step size 1.0, 203 examples, 7 leaves
delta(1, drive(Vehicle, _, Location), 0.4277215742158637) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(1, drive(_, _, Location), 0.220584029741667) :- at(_, Location), !.
delta(1, drive(_, _, _), -0.8284344921015049) :- !.
delta(1, pick_up(_, _, _, _, _), 0.536649655619455) :- !.
delta(1, drop(_, Location, Package, _, _), 0.2954601660035993) :- todo_at(Package, Location), !.
delta(1, drop(_, _, _, _, _), -0.3725945091169398) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 211 examples, 7 leaves
delta(2, drive(Vehicle, _, Location), 0.3211267522424536) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(2, drive(_, _, Location), 0.1663648234263349) :- at(_, Location), !.
delta(2, drive(_, _, _), -0.4999944981983069) :- !.
delta(2, pick_up(_, _, _, _, _), 0.27689471977867824) :- !.
delta(2, drop(_, Location, Package, _, _), 0.19083302405282968) :- todo_at(Package, Location), !.
delta(2, drop(_, _, _, _, _), -0.29377619912831604) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 203 examples, 7 leaves
delta(3, drive(Vehicle, _, Location), 0.5042410208400486) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(3, drive(_, _, Location), 0.4588063094048344) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(3, drive(_, _, _), -0.8761044114154289) :- !.
delta(3, pick_up(_, _, _, _, _), 0.40845946823654233) :- !.
delta(3, drop(_, Location, Package, _, _), 0.3406512117103974) :- todo_at(Package, Location), !.
delta(3, drop(_, _, _, _, _), -0.2920520305136825) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 215 examples, 12 leaves
delta(4, drive(Vehicle, Location, Location2), -0.1309994714172452) :- at(Vehicle, Location3), toward_could_drop_todo_at(Vehicle, Location3, Location2), todo_at(Locatable, Location2), at(Locatable, Location), !.
delta(4, drive(Vehicle, _, Location), 0.36268945377823353) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(4, drive(_, _, Location), 0.30218064872431394) :- at(Locatable, Location), todo_at(Locatable, _), fewer_capacity_1_than_at_2, !.
delta(4, drive(_, _, Location), -0.08588491733087815) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(4, drive(_, _, _), -0.5513361391798839) :- !.
delta(4, pick_up(_, Location, _, _, _), -0.2808644071646857) :- todo_at(_, Location), !.
delta(4, pick_up(_, _, _, _, _), 0.0024635902397047455) :- fewer_at_2_than_todo_at_1_at_1, !.
delta(4, pick_up(_, _, _, _, _), 0.45700702190593084) :- !.
delta(4, drop(_, Location, Package, _, _), -0.06262206085059205) :- todo_at(Package, Location), fewer_in_2_than_todo_at_1, !.
delta(4, drop(_, Location, Package, _, _), 0.39574902183531163) :- todo_at(Package, Location), !.
delta(4, drop(_, _, _, _, _), -0.2883909626285193) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 210 examples, 10 leaves
delta(5, drive(Vehicle, _, Location), 0.044974162253227375) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(5, drive(_, _, Location), -0.3546586237680961) :- at(Locatable, Location), vehicle(Locatable), !.
delta(5, drive(Vehicle, _, Location), -0.21724686891226055) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location, Location2), !.
delta(5, drive(Vehicle, _, Location), -0.058600249241130165) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(5, drive(_, _, _), 0.3418172148544322) :- !.
delta(5, pick_up(_, Location, _, _, _), -0.41224922582135515) :- todo_at(_, Location), !.
delta(5, pick_up(_, _, _, _, _), 0.3993989094561531) :- !.
delta(5, drop(_, Location, Package, _, _), 0.31479312834300427) :- todo_at(Package, Location), !.
delta(5, drop(_, _, _, _, _), -0.19818848148194834) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 222 examples, 12 leaves
delta(6, drive(Vehicle, Location, _), -0.005580599734219414) :- goal_at(Locatable, Location), done_at(Locatable, Location), goal_at(Locatable, Location2), could_drop_todo_at(Vehicle, Location2), !.
delta(6, drive(_, Location, Location2), -0.000845998660415977) :- goal_at(Locatable, Location), done_at(Locatable, Location), todo_at(Locatable2, Location2), at(Locatable2, Location), !.
delta(6, drive(_, Location, _), 0.25183449648767375) :- goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(6, drive(Vehicle, Location, Location2), -0.09600685717390592) :- at(Vehicle, Location3), toward_could_drop_todo_at(Vehicle, Location3, Location2), todo_at(Locatable, Location2), at(Locatable, Location), !.
delta(6, drive(Vehicle, _, Location), 0.17792594646468787) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(6, drive(Vehicle, _, Location), -0.01472111920779026) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), !.
delta(6, drive(_, _, _), -0.37464615668454265) :- !.
delta(6, pick_up(_, _, Package, _, _), 0.39522054790253136) :- todo_at(Package, _), !.
delta(6, pick_up(_, _, _, _, _), -0.4022138531682802) :- !.
delta(6, drop(_, Location, Package, _, _), 0.2592006258388792) :- todo_at(Package, Location), !.
delta(6, drop(_, _, _, _, _), -0.15284411753242103) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 204 examples, 13 leaves
delta(7, drive(Vehicle, Location, Location2), -0.06729028251913409) :- at(Vehicle, Location3), toward_could_drop_todo_at(Vehicle, Location3, Location2), todo_at(Locatable, Location2), at(Locatable, Location), !.
delta(7, drive(Vehicle, _, Location), 0.30478623194439775) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(7, drive(Vehicle, _, Location), -0.0812666817663064) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), at(Locatable, Location), vehicle(Locatable), !.
delta(7, drive(Vehicle, _, Location), 0.1563929601520537) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), !.
delta(7, drive(Vehicle, _, Location), -0.006378262695296691) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location2, Location), !.
delta(7, drive(_, _, _), -0.2887945906184338) :- !.
delta(7, pick_up(_, _, Package, _, _), 0.326132970348113) :- todo_at(Package, _), !.
delta(7, pick_up(_, _, _, _, _), -0.4175903358450932) :- !.
delta(7, drop(_, Location, Package, _, _), 0.018524631639333003) :- todo_at(Package, Location), fewer_capacity_2_than_todo_at_2, fewer_at_2_than_todo_at_1, !.
delta(7, drop(_, Location, Package, _, _), -0.06287090394010868) :- todo_at(Package, Location), fewer_capacity_2_than_todo_at_2, !.
delta(7, drop(_, Location, Package, _, _), 0.2573564245239626) :- todo_at(Package, Location), !.
delta(7, drop(_, _, _, _, _), -0.13289828075249002) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 210 examples, 15 leaves
delta(8, drive(Vehicle, Location, Location2), 0.011547716076038864) :- goal_at(Locatable, Location2), at(Locatable, Location3), toward_could_drop_todo_at(Vehicle, Location, Location3), !.
delta(8, drive(_, Location, Location2), -0.00011720807874914248) :- goal_at(Locatable, Location2), at(Locatable, Location3), nearer_at(Location3, Location2, Location), !.
delta(8, drive(_, _, Location), -0.21048884052895603) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(8, drive(Vehicle, Location, Location2), -0.01121076828747989) :- at(Locatable, Location), goal_at(Locatable, _), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(8, drive(_, Location, _), 0.38006078859895354) :- at(Locatable, Location), goal_at(Locatable, _), !.
delta(8, drive(Vehicle, _, Location), 0.20507573139739482) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(8, drive(_, _, _), -0.16742932997213308) :- !.
delta(8, pick_up(Vehicle, _, Package, _, _), -0.024441019854676532) :- todo_at(Package, _), at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), !.
delta(8, pick_up(_, _, Package, _, _), 0.2575497019559622) :- todo_at(Package, _), !.
delta(8, pick_up(_, _, _, _, _), -0.4373920138106155) :- !.
delta(8, drop(_, Location, Package, _, Size), -0.029028111700078598) :- todo_at(Package, Location), capacity(Vehicle, Size), could_pick_up_needed_in_to_drop(Vehicle, Location), !.
delta(8, drop(_, Location, Package, _, Size), -0.01434308636936296) :- todo_at(Package, Location), capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(8, drop(_, Location, Package, _, _), 0.20028588055725607) :- todo_at(Package, Location), !.
delta(8, drop(_, _, _, _, _), -0.11695110473359764) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 207 examples, 12 leaves
delta(9, drive(_, _, Location), -0.12689821522949749) :- todo_at(Locatable, Location), at(Locatable, _), !.
delta(9, drive(Vehicle, _, Location), -0.08279718248265394) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(9, drive(Vehicle, _, Location), -0.012534684370169084) :- at(Vehicle, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(9, drive(_, _, _), 0.3483588935908757) :- !.
delta(9, pick_up(_, Location, Package, _, _), 0.37437780611591087) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(9, pick_up(Vehicle, Location, Package, Size, _), -0.00555028744208845) :- capacity(Vehicle2, Size), could_pick_up_needed_in_to_drop(Vehicle2, Location), goal_at(Package, Location2), could_pick_up(Vehicle, Location2), !.
delta(9, pick_up(_, Location, _, Size, _), 0.06810390891550286) :- capacity(Vehicle, Size), could_pick_up_needed_in_to_drop(Vehicle, Location), !.
delta(9, pick_up(_, _, _, _, _), 0.00019811004279600942) :- fewer_at_2_than_todo_at_1_at_1, !.
delta(9, pick_up(_, _, _, _, _), -0.6632915420835382) :- !.
delta(9, drop(_, Location, Package, _, _), 0.22713142502840242) :- todo_at(Package, Location), !.
delta(9, drop(_, _, _, _, _), -0.08721373115118772) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 201 examples, 19 leaves
delta(10, drive(Vehicle, Location, _), -0.005692961269923942) :- goal_at(Locatable, Location), done_at(Locatable, Location), goal_at(Locatable, Location2), could_pick_up_needed_in_to_drop(Vehicle, Location2), !.
delta(10, drive(Vehicle, Location, _), -0.00217220831662656) :- goal_at(Locatable, Location), done_at(Locatable, Location), goal_at(Locatable, Location2), could_drop_todo_at(Vehicle, Location2), !.
delta(10, drive(_, Location, _), 0.25857906349215615) :- goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(10, drive(Vehicle, _, Location), -0.03938576616618257) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), at(Vehicle, Location3), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location3), !.
delta(10, drive(Vehicle, _, Location), 0.08271465723079122) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), !.
delta(10, drive(Vehicle, _, Location), 0.04197807169131609) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(10, drive(_, _, _), -0.16961313413572982) :- !.
delta(10, pick_up(_, Location, Package, Size, _), 0.010829875444297015) :- todo_at(Package, Location2), road(Location, Location2), at(Locatable, Location2), vehicle(Locatable), needed_capacity_to_drop(Size), !.
delta(10, pick_up(_, Location, Package, _, _), -0.051135861863260364) :- todo_at(Package, Location2), road(Location, Location2), at(Locatable, Location2), vehicle(Locatable), !.
delta(10, pick_up(_, Location, Package, _, _), 0.28431352802619964) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(10, pick_up(Vehicle, Location, Package, Size, _), 0.002794968952414711) :- capacity(Vehicle2, Size), could_pick_up_for_todo_at_any_location(Vehicle2, Location), todo_at(Package, Location2), could_pick_up(Vehicle, Location2), !.
delta(10, pick_up(_, Location, _, Size, _), -0.00013638938659728367) :- capacity(Vehicle, Size), could_pick_up_for_todo_at_any_location(Vehicle, Location), !.
delta(10, pick_up(_, _, _, _, _), 0.002150820354271411) :- fewer_at_2_than_todo_at_1, !.
delta(10, pick_up(_, _, _, _, _), -0.35608729104680015) :- !.
delta(10, drop(_, Location, Package, _, _), 0.008812920647454845) :- todo_at(Package, Location), fewer_capacity_2_than_todo_at_2, fewer_capacity_1_than_todo_at_1, !.
delta(10, drop(_, Location, Package, _, _), -0.0398646794805291) :- todo_at(Package, Location), fewer_capacity_2_than_todo_at_2, !.
delta(10, drop(_, Location, Package, _, _), 0.08875889700277599) :- todo_at(Package, Location), !.
delta(10, drop(_, _, _, _, _), -0.06106018331899504) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 205 examples, 21 leaves
delta(11, drive(Vehicle, Location, Location2), 0.005282960948209302) :- at(Vehicle, Location3), toward_could_pick_up_needed_in_to_drop(Vehicle, Location3, Location2), goal_at(_, Location2), could_drop(Vehicle, Location), !.
delta(11, drive(Vehicle, _, Location), -0.08560311253741267) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), goal_at(_, Location), !.
delta(11, drive(Vehicle, _, Location), -0.017774114369752417) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), at(Vehicle, Location3), toward_could_drop_todo_at(Vehicle, Location, Location3), !.
delta(11, drive(Vehicle, _, Location), 0.27321797106426166) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), !.
delta(11, drive(_, _, Location), 0.017310411202773796) :- fewer_in_2_than_todo_at_1, goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(11, drive(_, _, _), -0.2629665680263607) :- fewer_in_2_than_todo_at_1, !.
delta(11, drive(Vehicle, _, Location), 0.10387612643052122) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(11, drive(_, _, _), -0.05517430243010161) :- !.
delta(11, pick_up(Vehicle, Location, Package, _, _), 0.005267632479404064) :- goal_at(Locatable, Location), done_at(Locatable, Location), todo_at(Package, Location2), toward_could_pick_up_needed_capacity_to_drop(Vehicle, Location2, Location), !.
delta(11, pick_up(_, Location, _, _, _), -0.19445090650649) :- goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(11, pick_up(_, Location, Package, _, _), 0.13409126646474462) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(11, pick_up(_, _, _, Size, _), 0.043537956476269554) :- capacity(Vehicle, Size), in(_, Vehicle), !.
delta(11, pick_up(_, _, _, _, _), -0.05891226938219621) :- !.
delta(11, drop(Vehicle, _, _, _, _), -0.04269423477971433) :- fewer_capacity_1_than_at_2, capacity(Vehicle, Size), beyond_capacity_predecessor(_, Size), fewer_in_2_than_todo_at_1, !.
delta(11, drop(Vehicle, _, _, _, _), 0.002490162277734379) :- fewer_capacity_1_than_at_2, capacity(Vehicle, Size), beyond_capacity_predecessor(_, Size), !.
delta(11, drop(_, _, _, _, _), 0.022177331732884487) :- fewer_capacity_1_than_at_2, fewer_at_2_than_at_1, !.
delta(11, drop(_, _, _, _, _), -0.011247967901665651) :- fewer_capacity_1_than_at_2, !.
delta(11, drop(Vehicle, Location, Package, _, _), -0.006887388526216104) :- todo_at(Package, Location2), toward_could_pick_up(Vehicle, Location2, Location), !.
delta(11, drop(_, _, _, _, _), -0.0017867142330110762) :- fewer_capacity_1_than_todo_at_1, !.
delta(11, drop(_, _, _, _, _), 0.13085865584189665) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 202 examples, 16 leaves
delta(12, drive(Vehicle, _, Location), 0.011194868549867098) :- goal_at(Locatable, Location), fewer_in_2_than_at_2, at(Locatable, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(12, drive(_, _, Location), -0.17124157409939397) :- goal_at(_, Location), fewer_in_2_than_at_2, !.
delta(12, drive(_, _, Location), -0.011704412248074348) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(12, drive(_, _, Location), 0.041841866317402734) :- goal_at(_, Location), !.
delta(12, drive(Vehicle, _, Location), 0.009240255463135229) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), could_drop_for_todo_at_any_location(Vehicle, Location2), !.
delta(12, drive(_, _, Location), -0.08033882601004338) :- at(Locatable, Location), vehicle(Locatable), !.
delta(12, drive(_, Location, Location2), -0.026041584810098092) :- todo_at(Locatable, Location), at(Locatable, Location2), !.
delta(12, drive(_, _, _), 0.3525043329061042) :- !.
delta(12, pick_up(_, _, Package, _, _), 0.15391748342612144) :- todo_at(Package, _), !.
delta(12, pick_up(_, _, _, _, _), -0.32287133271896307) :- !.
delta(12, drop(_, Location, Package, _, _), 0.03237914507673832) :- fewer_in_2_than_todo_at_2_at_2, todo_at(Package, Location), !.
delta(12, drop(_, _, _, _, _), -0.00791363179722171) :- fewer_in_2_than_todo_at_2_at_2, !.
delta(12, drop(Vehicle, _, _, _, _), 0.00846918188841282) :- at(Vehicle, Location), could_pick_up_for_todo_at_any_location(Vehicle, Location), !.
delta(12, drop(_, Location, _, _, Size), 0.003966038139237927) :- capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(12, drop(_, _, _, _, _), -0.1078115384122338) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 206 examples, 16 leaves
delta(13, drive(Vehicle, Location, Location2), -0.005290124588511556) :- todo_at(Locatable, Location), at(Locatable, Location3), toward_could_pick_up_needed_capacity_to_drop(Vehicle, Location2, Location3), road(Location, Location3), !.
delta(13, drive(Vehicle, Location, Location2), 0.07499716300985118) :- todo_at(Locatable, Location), at(Locatable, Location3), toward_could_pick_up_needed_capacity_to_drop(Vehicle, Location2, Location3), !.
delta(13, drive(_, Location, _), 0.0163999628360181) :- todo_at(_, Location), fewer_in_2_than_in_1, !.
delta(13, drive(_, Location, _), -0.2102618032889187) :- todo_at(_, Location), !.
delta(13, drive(Vehicle, _, Location), -0.04613090270086291) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(13, drive(Vehicle, _, Location), -0.03382471637545038) :- at(Vehicle, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(13, drive(_, _, _), 0.26120712294862725) :- !.
delta(13, pick_up(Vehicle, _, Package, _, _), -0.012868205143566123) :- todo_at(Package, _), at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), !.
delta(13, pick_up(_, _, Package, _, _), 0.19594354535906688) :- todo_at(Package, _), !.
delta(13, pick_up(_, _, _, _, _), -0.23089601301579482) :- !.
delta(13, drop(Vehicle, _, _, _, _), 0.02035616894618751) :- at(Vehicle, Location), could_pick_up_for_todo_at_any_location(Vehicle, Location), !.
delta(13, drop(_, Location, _, _, _), 0.022413325860952384) :- fewer_in_2_than_in_1, todo_at(_, Location), !.
delta(13, drop(_, _, _, _, _), -0.005999119148177897) :- fewer_in_2_than_in_1, !.
delta(13, drop(_, _, _, _, _), 0.0024816985981877715) :- fewer_capacity_1_than_at_2, !.
delta(13, drop(_, _, _, _, _), -0.1458819601766652) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 204 examples, 16 leaves
delta(14, drive(_, Location, _), -0.0463236211483242) :- goal_at(Locatable, Location), at(Locatable, Location2), road(Location, Location2), fewer_capacity_1_than_at_2, !.
delta(14, drive(_, Location, _), 0.01740605798298483) :- goal_at(Locatable, Location), at(Locatable, Location2), road(Location, Location2), !.
delta(14, drive(Vehicle, Location, Location2), -0.039783369112169044) :- goal_at(Locatable, Location), at(Locatable, Location3), toward_could_drop_todo_at(Vehicle, Location2, Location3), !.
delta(14, drive(_, Location, _), 0.18099939650229085) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(14, drive(_, Location, Location2), 0.05137966717494893) :- todo_at(Locatable, Location2), at(Locatable, Location), fewer_at_2_than_todo_at_2, !.
delta(14, drive(_, Location, Location2), -0.019527489975704224) :- todo_at(Locatable, Location2), at(Locatable, Location), !.
delta(14, drive(_, _, _), -0.20832144861777793) :- fewer_in_2_than_todo_at_2, !.
delta(14, drive(_, _, _), 0.015585351037871094) :- !.
delta(14, pick_up(Vehicle, _, Package, _, _), -0.03149525849485753) :- todo_at(Package, _), at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), fewer_capacity_2_than_at_2, !.
delta(14, pick_up(Vehicle, _, Package, _, _), 0.00040624373454219994) :- todo_at(Package, _), at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), !.
delta(14, pick_up(_, _, Package, _, _), 0.0004746615280541908) :- todo_at(Package, _), fewer_at_2_than_todo_at_1_at_1, !.
delta(14, pick_up(_, _, Package, _, _), 0.1890077447426286) :- todo_at(Package, _), !.
delta(14, pick_up(_, _, _, _, _), -0.21499519834770991) :- !.
delta(14, drop(_, Location, Package, _, _), 0.19655047500106038) :- todo_at(Package, Location), !.
delta(14, drop(_, _, _, _, _), -0.09310496228609341) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 201 examples, 21 leaves
delta(15, drive(_, Location, _), 0.0024459686881558203) :- at(Locatable, Location), todo_at(Locatable, _), fewer_in_2_than_in_1, !.
delta(15, drive(_, Location, _), -0.11433818212457225) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(15, drive(Vehicle, _, Location), 0.011998081845058572) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), todo_at(_, Location), !.
delta(15, drive(Vehicle, _, Location), -0.0721303715585625) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(15, drive(Vehicle, _, Location), -0.013376372509762011) :- at(Vehicle, Location2), toward_could_pick_up_needed_capacity_to_drop(Vehicle, Location2, Location), !.
delta(15, drive(_, _, _), 0.25010877288610867) :- !.
delta(15, pick_up(Vehicle, _, Package, _, _), 0.03130039438781214) :- goal_at(Package, Location), at(_, Location), could_drop_for_todo_at_any_location(Vehicle, Location), todo_at(Package, Location), !.
delta(15, pick_up(Vehicle, _, Package, _, _), -0.002168925884226624) :- goal_at(Package, Location), at(_, Location), could_drop_for_todo_at_any_location(Vehicle, Location), !.
delta(15, pick_up(_, Location, Package, _, _), 0.027968965808023) :- goal_at(Package, Location2), at(Locatable, Location2), todo_at(Locatable, Location), !.
delta(15, pick_up(_, _, Package, _, _), -0.1734921866465968) :- goal_at(Package, Location), at(_, Location), !.
delta(15, pick_up(_, _, _, _, _), 0.0006065896647679685) :- fewer_capacity_1_than_at_2, !.
delta(15, pick_up(_, _, _, _, _), 0.059972386250539675) :- !.
delta(15, drop(_, _, _, _, Size), 0.0005494034188173553) :- beyond_capacity_predecessor(Size, _), fewer_at_2_than_todo_at_1, fewer_capacity_1_than_todo_at_2, !.
delta(15, drop(_, _, _, _, Size), -0.023577144004295784) :- beyond_capacity_predecessor(Size, _), fewer_at_2_than_todo_at_1, !.
delta(15, drop(_, Location, Package, _, Size), -0.006308538600453752) :- beyond_capacity_predecessor(Size, _), todo_at(Package, Location2), road(Location, Location2), !.
delta(15, drop(_, _, _, _, Size), 0.08793070517048261) :- beyond_capacity_predecessor(Size, _), !.
delta(15, drop(_, Location, Package, _, _), 0.025318485162012346) :- fewer_in_2_than_todo_at_2_at_2, todo_at(Package, Location), !.
delta(15, drop(_, _, _, _, _), -0.0048528068197142595) :- fewer_in_2_than_todo_at_2_at_2, !.
delta(15, drop(_, _, _, _, _), 0.017637352866401612) :- fewer_at_2_than_at_1, !.
delta(15, drop(_, _, _, _, _), -0.21073220998175912) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 210 examples, 22 leaves
delta(16, drive(Vehicle, Location, Location2), 0.0006057210229101298) :- at(Vehicle, Location3), toward_could_pick_up(Vehicle, Location3, Location2), at(Vehicle, Location4), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location4), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(16, drive(Vehicle, _, Location), -0.03124714528844506) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location2, Location), at(Vehicle, Location3), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location3), !.
delta(16, drive(Vehicle, _, Location), -0.0191954491590534) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location2, Location), at(Locatable, Location), vehicle(Locatable), !.
delta(16, drive(Vehicle, _, Location), 0.19638314174437246) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location2, Location), !.
delta(16, drive(_, _, Location), -0.03083840721423961) :- todo_at(_, Location), fewer_capacity_1_than_todo_at_1, !.
delta(16, drive(_, _, Location), 0.11015978356858118) :- todo_at(_, Location), !.
delta(16, drive(_, Location, _), 0.06586572075721693) :- todo_at(Locatable, Location), at(Locatable, _), !.
delta(16, drive(_, _, _), -0.3559701281567537) :- !.
delta(16, pick_up(Vehicle, Location, Package, _, _), -0.03827865872282464) :- fewer_at_2_than_todo_at_1, todo_at(Package, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(16, pick_up(_, _, _, _, _), 0.08316371033163997) :- fewer_at_2_than_todo_at_1, !.
delta(16, pick_up(Vehicle, _, Package, _, _), 0.043702286136457505) :- todo_at(Package, Location), could_pick_up(Vehicle, Location), !.
delta(16, pick_up(_, _, _, _, _), 0.016682602648083602) :- fewer_in_2_than_in_1, !.
delta(16, pick_up(_, _, _, _, _), -0.1468659646297521) :- !.
delta(16, drop(_, Location, Package, _, _), 0.006833906334776287) :- fewer_capacity_2_than_at_2, goal_at(Locatable, Location), at(Locatable, _), todo_at(Package, Location), !.
delta(16, drop(_, Location, _, _, _), -0.0023529515379980426) :- fewer_capacity_2_than_at_2, goal_at(Locatable, Location), at(Locatable, _), !.
delta(16, drop(_, _, _, _, _), 0.0018057872878799112) :- fewer_capacity_2_than_at_2, fewer_in_2_than_in_1, !.
delta(16, drop(_, _, _, _, _), -0.032400205262486236) :- fewer_capacity_2_than_at_2, !.
delta(16, drop(Vehicle, Location, Package, _, _), 0.0030471573975480435) :- goal_at(Locatable, Location), done_at(Locatable, Location), todo_at(Package, Location2), could_pick_up(Vehicle, Location2), !.
delta(16, drop(_, Location, _, _, _), -0.020183577887824537) :- goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(16, drop(_, _, _, _, _), 0.15734272140683092) :- fewer_in_2_than_at_2, !.
delta(16, drop(_, _, _, _, _), -0.0010675097766074933) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 204 examples, 21 leaves
delta(17, drive(Vehicle, Location, Location2), -0.04509834652906848) :- todo_at(Locatable, Location), at(Locatable, Location3), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location), could_pick_up_needed_capacity_to_drop(Vehicle, Location3), !.
delta(17, drive(Vehicle, Location, Location2), 0.028565622873321685) :- todo_at(Locatable, Location), at(Locatable, _), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(17, drive(Vehicle, Location, _), -0.010821299531622622) :- todo_at(Locatable, Location), at(Locatable, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(17, drive(_, Location, _), 0.10678448401710013) :- todo_at(Locatable, Location), at(Locatable, _), !.
delta(17, drive(_, _, Location), -0.01099951129538093) :- fewer_capacity_2_than_todo_at_2_at_2, todo_at(Locatable, Location), at(Locatable, _), !.
delta(17, drive(_, _, _), 0.019032473782749446) :- fewer_capacity_2_than_todo_at_2_at_2, !.
delta(17, drive(_, _, _), 0.0030012010226863747) :- fewer_capacity_2_than_in_1, !.
delta(17, drive(_, _, _), -0.17506674275250053) :- !.
delta(17, pick_up(_, _, _, Size, _), 0.014983604399475237) :- beyond_capacity_predecessor(_, Size), fewer_capacity_2_than_todo_at_1, fewer_capacity_1_than_todo_at_2, !.
delta(17, pick_up(_, _, _, Size, _), -0.08379815263312357) :- beyond_capacity_predecessor(_, Size), fewer_capacity_2_than_todo_at_1, !.
delta(17, pick_up(_, _, Package, Size, _), 0.034782324456881765) :- beyond_capacity_predecessor(_, Size), todo_at(Package, _), !.
delta(17, pick_up(_, _, _, Size, _), -0.011803827061782192) :- beyond_capacity_predecessor(_, Size), !.
delta(17, pick_up(_, _, Package, _, Size), -0.020473666120676973) :- todo_at(Package, Location), capacity(Vehicle, Size), could_drop_todo_at(Vehicle, Location), !.
delta(17, pick_up(_, _, Package, _, _), 0.13209025863724172) :- todo_at(Package, _), !.
delta(17, pick_up(_, _, _, _, _), -0.010615752267978232) :- !.
delta(17, drop(_, Location, Package, _, _), -0.025282801703481746) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(17, drop(_, Location, _, _, _), -0.011661977048901238) :- at(Locatable, Location), todo_at(Locatable, Location2), road(Location, Location2), !.
delta(17, drop(_, Location, _, _, _), 0.0007437392764412259) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(17, drop(_, _, Package, _, _), 0.10653443222288662) :- todo_at(Package, Location), at(_, Location), !.
delta(17, drop(_, _, _, _, _), -0.004340722844251111) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 207 examples, 22 leaves
delta(18, drive(Vehicle, _, Location), 0.00721532723837481) :- fewer_capacity_2_than_todo_at_2, could_pick_up_for_todo_at_any_location(Vehicle, Location), at(Vehicle, Location2), could_drop_for_todo_at_any_location(Vehicle, Location2), !.
delta(18, drive(Vehicle, _, Location), -0.03935456577624231) :- fewer_capacity_2_than_todo_at_2, could_pick_up_for_todo_at_any_location(Vehicle, Location), !.
delta(18, drive(_, Location, _), -0.009272007633793926) :- fewer_capacity_2_than_todo_at_2, at(Locatable, Location), todo_at(Locatable, _), !.
delta(18, drive(_, _, _), 0.18210594752459683) :- fewer_capacity_2_than_todo_at_2, !.
delta(18, drive(Vehicle, Location, Location2), 0.015304479220699935) :- at(Locatable, Location2), todo_at(Locatable, Location3), toward_could_pick_up(Vehicle, Location3, Location), !.
delta(18, drive(_, _, Location), -0.22677281173164093) :- at(_, Location), !.
delta(18, drive(_, _, _), -0.020101982542936585) :- fewer_capacity_2_than_todo_at_1, !.
delta(18, drive(_, _, _), 0.06151638625239747) :- !.
delta(18, pick_up(_, Location, Package, Size, _), 0.044390071896799665) :- capacity(Vehicle, Size), todo_at(Package, Location2), could_drop(Vehicle, Location2), could_pick_up(Vehicle, Location), !.
delta(18, pick_up(_, _, Package, Size, _), -0.018674163808521244) :- capacity(Vehicle, Size), todo_at(Package, Location), could_drop(Vehicle, Location), !.
delta(18, pick_up(_, _, _, Size, _), -0.16182769776096972) :- capacity(_, Size), fewer_capacity_1_than_todo_at_1, !.
delta(18, pick_up(_, _, _, Size, _), 0.005637788900039892) :- capacity(_, Size), !.
delta(18, pick_up(_, _, Package, _, _), 0.07143759850310688) :- todo_at(Package, _), !.
delta(18, pick_up(_, _, _, _, _), -0.007259776392652324) :- !.
delta(18, drop(_, _, _, _, Size), -0.017808296247447033) :- capacity(_, Size), fewer_at_2_than_todo_at_2, !.
delta(18, drop(Vehicle, Location, _, _, Size), -0.004782158823308636) :- capacity(Vehicle2, Size), at(Vehicle2, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(18, drop(_, _, _, _, Size), 0.18535776808291893) :- capacity(_, Size), !.
delta(18, drop(_, Location, Package, _, _), 0.0034322532287834155) :- goal_at(Locatable, Location), done_at(Locatable, Location), todo_at(Package, Location), !.
delta(18, drop(_, Location, _, _, _), -0.0002711984783358213) :- goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(18, drop(_, _, _, _, _), 0.00028471454875605024) :- fewer_at_2_than_todo_at_2, !.
delta(18, drop(_, _, _, _, _), -0.06209944916333256) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 203 examples, 20 leaves
delta(19, drive(_, Location, Location2), 0.011387706912905037) :- todo_at(Locatable, Location2), fewer_in_2_than_todo_at_1, at(Locatable, Location3), nearer_at(Location3, Location2, Location), !.
delta(19, drive(_, _, Location), -0.11359055092993846) :- todo_at(_, Location), fewer_in_2_than_todo_at_1, !.
delta(19, drive(Vehicle, Location, Location2), 0.016085755758593022) :- todo_at(Locatable, Location2), todo_at(Locatable, Location3), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location3), !.
delta(19, drive(_, _, Location), -0.0013040488475406285) :- todo_at(_, Location), !.
delta(19, drive(Vehicle, Location, Location2), 0.0057315389178322716) :- at(Vehicle, Location3), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location3), todo_at(Locatable, Location), at(Locatable, Location2), !.
delta(19, drive(Vehicle, _, Location), -0.05867944818832959) :- at(Vehicle, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(19, drive(Vehicle, _, Location), -0.036845346145213384) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(19, drive(_, _, _), 0.23608670762579625) :- !.
delta(19, pick_up(Vehicle, _, Package, _, _), -0.0119780256023588) :- todo_at(Package, Location), could_pick_up(Vehicle, Location), at(Locatable, Location), vehicle(Locatable), !.
delta(19, pick_up(Vehicle, _, Package, _, _), 0.09342838866940913) :- todo_at(Package, Location), could_pick_up(Vehicle, Location), !.
delta(19, pick_up(_, _, Package, _, _), -0.1467217510426415) :- fewer_capacity_2_than_todo_at_2_at_2, todo_at(Package, Location), at(_, Location), !.
delta(19, pick_up(_, _, _, _, _), -9.371840141541559e-6) :- fewer_capacity_2_than_todo_at_2_at_2, !.
delta(19, pick_up(_, _, Package, _, _), 0.07094853495949746) :- todo_at(Package, _), !.
delta(19, pick_up(_, _, _, _, _), -0.02540254257524907) :- !.
delta(19, drop(Vehicle, Location, Package, _, Size), 0.0007723287614430888) :- todo_at(Package, Location), todo_at(Package, Location2), could_pick_up_needed_in_to_drop(Vehicle, Location2), capacity(_, Size), !.
delta(19, drop(Vehicle, Location, Package, _, _), -0.013716213411037119) :- todo_at(Package, Location), todo_at(Package, Location2), could_pick_up_needed_in_to_drop(Vehicle, Location2), !.
delta(19, drop(_, Location, Package, _, _), -0.005110083771713931) :- todo_at(Package, Location), todo_at(Locatable, Location), at(Locatable, _), !.
delta(19, drop(_, Location, Package, _, _), 0.05917734977092388) :- todo_at(Package, Location), !.
delta(19, drop(_, _, _, _, _), -0.14737646069455373) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 223 examples, 20 leaves
delta(20, drive(_, Location, Location2), -0.11122996251877314) :- todo_at(_, Location2), todo_at(Locatable, Location), at(Locatable, Location2), fewer_capacity_1_than_at_2, !.
delta(20, drive(_, Location, Location2), 0.01209530617447378) :- todo_at(_, Location2), todo_at(Locatable, Location), at(Locatable, Location2), !.
delta(20, drive(Vehicle, Location, Location2), -0.06191802568992567) :- todo_at(Locatable, Location2), at(Locatable, Location3), toward_could_pick_up(Vehicle, Location, Location3), !.
delta(20, drive(_, _, Location), 0.2747449288383804) :- todo_at(_, Location), !.
delta(20, drive(Vehicle, _, Location), -0.0373142008733788) :- at(Vehicle, Location2), could_drop_for_todo_at_any_location(Vehicle, Location2), at(Vehicle, Location3), toward_could_drop_todo_at(Vehicle, Location, Location3), !.
delta(20, drive(Vehicle, _, _), 0.0515446298844021) :- at(Vehicle, Location), could_drop_for_todo_at_any_location(Vehicle, Location), !.
delta(20, drive(_, _, _), 0.017071045404396135) :- fewer_at_2_than_todo_at_1, !.
delta(20, drive(_, _, _), -0.18004370852652476) :- !.
delta(20, pick_up(Vehicle, Location, Package, _, Size), -0.10362457405086839) :- todo_at(Package, Location2), toward_could_pick_up(Vehicle, Location2, Location), capacity(Vehicle2, Size), could_drop(Vehicle2, Location), fewer_in_2_than_todo_at_2, !.
delta(20, pick_up(Vehicle, Location, Package, _, Size), 0.0035318906367785355) :- todo_at(Package, Location2), toward_could_pick_up(Vehicle, Location2, Location), capacity(Vehicle2, Size), could_drop(Vehicle2, Location), !.
delta(20, pick_up(Vehicle, Location, Package, _, _), 0.006320928185269191) :- todo_at(Package, Location2), toward_could_pick_up(Vehicle, Location2, Location), !.
delta(20, pick_up(_, _, Package, Size, _), -0.009533882096763624) :- todo_at(Package, Location), capacity(Vehicle, Size), could_drop_todo_at(Vehicle, Location), !.
delta(20, pick_up(_, _, Package, _, _), 0.15323773863216258) :- todo_at(Package, _), !.
delta(20, pick_up(_, _, _, _, _), -0.010336207697614421) :- !.
delta(20, drop(Vehicle, _, _, _, _), -0.023675824571701636) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), fewer_in_2_than_in_1, fewer_capacity_2_than_todo_at_1, !.
delta(20, drop(Vehicle, _, _, _, _), 0.009824294627691044) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), fewer_in_2_than_in_1, !.
delta(20, drop(Vehicle, _, _, _, _), -0.006181529182257355) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), fewer_capacity_1_than_at_2, !.
delta(20, drop(Vehicle, _, _, _, _), 0.07126308709565314) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), !.
delta(20, drop(_, _, _, _, _), -0.05644416226557571) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 218 examples, 18 leaves
delta(21, drive(Vehicle, _, Location), -0.009962233352083103) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(21, drive(Vehicle, _, Location), -0.00802424804410763) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), toward_could_pick_up_needed_capacity_to_drop(Vehicle, Location2, Location), !.
delta(21, drive(_, _, Location), 0.22392314158674387) :- at(Locatable, Location), vehicle(Locatable), !.
delta(21, drive(Vehicle, _, Location), -0.030231041908987434) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location), in(Package, Vehicle), todo_at(Package, Location), !.
delta(21, drive(Vehicle, _, Location), 0.0671260284151035) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(21, drive(_, _, _), 0.007419173052821246) :- fewer_at_2_than_todo_at_1, !.
delta(21, drive(_, _, _), -0.1652582453352439) :- !.
delta(21, pick_up(_, _, Package, Size, _), 0.01017941069286527) :- goal_at(Package, Location), at(_, Location), needed_capacity_to_drop(Size), todo_at(Package, Location), !.
delta(21, pick_up(_, _, Package, Size, _), -0.003375625323464024) :- goal_at(Package, Location), at(_, Location), needed_capacity_to_drop(Size), !.
delta(21, pick_up(_, Location, Package, _, _), 0.0020248180430902205) :- goal_at(Package, Location2), at(Locatable, Location2), todo_at(Locatable, Location), !.
delta(21, pick_up(_, _, Package, _, _), -0.11275381248765318) :- goal_at(Package, Location), at(_, Location), !.
delta(21, pick_up(_, _, _, _, _), 0.03408283339359932) :- !.
delta(21, drop(_, Location, Package, _, Size), 0.0075436441134293306) :- todo_at(Package, Location), capacity(Vehicle, Size), at(Vehicle, Location), todo_at(Package, Location2), could_drop(Vehicle, Location2), !.
delta(21, drop(_, Location, Package, _, Size), -0.026881904848185628) :- todo_at(Package, Location), capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(21, drop(_, Location, Package, _, Size), 0.056918845129317525) :- todo_at(Package, Location), capacity(_, Size), !.
delta(21, drop(_, Location, Package, _, _), -0.005601187561339173) :- todo_at(Package, Location), !.
delta(21, drop(_, _, _, _, _), -0.030994974160727884) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 211 examples, 19 leaves
delta(22, drive(Vehicle, _, Location), 0.025298394261761517) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), fewer_capacity_2_than_at_2, !.
delta(22, drive(Vehicle, _, Location), -0.010353524121588556) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(22, drive(_, _, Location), -0.08577532979780121) :- at(Locatable, Location), vehicle(Locatable), fewer_capacity_2_than_at_2, !.
delta(22, drive(_, _, Location), 0.002606339198182703) :- at(Locatable, Location), vehicle(Locatable), !.
delta(22, drive(Vehicle, _, Location), 0.019771425138719094) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location), fewer_capacity_1_than_at_2, !.
delta(22, drive(Vehicle, _, Location), -0.07054723892612622) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(22, drive(Vehicle, _, _), -0.03600515712242915) :- at(Vehicle, Location), could_pick_up_needed_capacity_to_drop(Vehicle, Location), !.
delta(22, drive(_, _, _), 0.1481008535213562) :- !.
delta(22, pick_up(Vehicle, Location, Package, _, _), 0.01658625555632881) :- goal_at(Package, Location2), could_pick_up(Vehicle, Location2), todo_at(Locatable, Location), at(Locatable, Location2), !.
delta(22, pick_up(Vehicle, Location, Package, _, _), 0.00194106385788505) :- goal_at(Package, Location2), could_pick_up(Vehicle, Location2), todo_at(Package, Location3), toward_could_pick_up_needed_in_to_drop(Vehicle, Location3, Location), !.
delta(22, pick_up(Vehicle, _, Package, _, _), -0.14866350573264075) :- goal_at(Package, Location), could_pick_up(Vehicle, Location), !.
delta(22, pick_up(_, Location, _, Size, _), -0.014672433378242925) :- capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(22, pick_up(_, _, _, _, _), 0.00018288574154154988) :- fewer_at_2_than_todo_at_1_at_1, !.
delta(22, pick_up(_, _, _, _, _), 0.0981441546940094) :- !.
delta(22, drop(Vehicle, _, _, _, _), 0.02638298616846917) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), fewer_in_2_than_todo_at_2, !.
delta(22, drop(Vehicle, _, _, _, _), -0.013755346370569639) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), fewer_in_2_than_todo_at_1, !.
delta(22, drop(Vehicle, _, _, _, _), 0.012845957199107007) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), !.
delta(22, drop(_, _, _, _, _), -0.01339769404640632) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 212 examples, 20 leaves
delta(23, drive(Vehicle, _, Location), 0.022477909413700006) :- at(Vehicle, Location2), could_drop(Vehicle, Location2), fewer_capacity_2_than_in_1, at(Vehicle, Location3), toward_could_drop_todo_at(Vehicle, Location3, Location), !.
delta(23, drive(Vehicle, _, _), -0.002808257960454859) :- at(Vehicle, Location), could_drop(Vehicle, Location), fewer_capacity_2_than_in_1, !.
delta(23, drive(Vehicle, _, _), -0.07059990443418782) :- at(Vehicle, Location), could_drop(Vehicle, Location), fewer_in_2_than_todo_at_1, !.
delta(23, drive(Vehicle, _, _), 0.0069246427003744546) :- at(Vehicle, Location), could_drop(Vehicle, Location), !.
delta(23, drive(Vehicle, _, Location), 0.0062961295082559965) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), toward_could_pick_up_needed_capacity_to_drop(Vehicle, Location2, Location), !.
delta(23, drive(_, _, Location), -0.03064325930893972) :- at(Locatable, Location), vehicle(Locatable), !.
delta(23, drive(Vehicle, _, _), -0.011306337888147068) :- at(Vehicle, Location), could_pick_up_needed_capacity_to_drop(Vehicle, Location), !.
delta(23, drive(_, _, _), 0.23579564185655255) :- !.
delta(23, pick_up(Vehicle, _, Package, _, _), 0.0036307750394400516) :- fewer_capacity_2_than_todo_at_2, todo_at(Package, Location), could_pick_up_needed_capacity_to_drop(Vehicle, Location), !.
delta(23, pick_up(Vehicle, Location, Package, _, _), 0.0010296023491783316) :- fewer_capacity_2_than_todo_at_2, todo_at(Package, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(23, pick_up(_, _, _, _, _), -0.18647663216161128) :- fewer_capacity_2_than_todo_at_2, !.
delta(23, pick_up(_, _, Package, _, _), 0.03777587780064302) :- todo_at(Package, _), !.
delta(23, pick_up(_, _, _, _, _), -0.011114303930362333) :- !.
delta(23, drop(_, Location, Package, _, _), 0.033607082114804544) :- fewer_capacity_1_than_at_2, todo_at(Package, Location), !.
delta(23, drop(_, _, _, _, _), -0.003335013581983685) :- fewer_capacity_1_than_at_2, !.
delta(23, drop(_, Location, Package, _, _), -0.00023654645686774895) :- goal_at(Locatable, Location), done_at(Locatable, Location), todo_at(Package, Location2), road(Location, Location2), !.
delta(23, drop(_, Location, _, _, _), 0.017188581671431353) :- goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(23, drop(_, _, _, _, _), -0.08443523377533231) :- fewer_in_2_than_todo_at_1, !.
delta(23, drop(_, _, _, _, _), 0.0034597676238197228) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 219 examples, 21 leaves
delta(24, drive(Vehicle, _, _), 0.014912381674086433) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), fewer_in_2_than_todo_at_1, fewer_at_2_than_todo_at_2, !.
delta(24, drive(Vehicle, _, _), -0.15302332282141656) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), fewer_in_2_than_todo_at_1, !.
delta(24, drive(Vehicle, Location, Location2), 0.03577820627569209) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(24, drive(Vehicle, _, _), -0.013795884830397379) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), !.
delta(24, drive(Vehicle, _, Location), 0.0008950327450167834) :- at(Vehicle, Location2), could_pick_up_needed_capacity_to_drop(Vehicle, Location2), at(Vehicle, Location3), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location3), !.
delta(24, drive(Vehicle, _, _), -0.02439352460566569) :- at(Vehicle, Location), could_pick_up_needed_capacity_to_drop(Vehicle, Location), !.
delta(24, drive(_, Location, _), -0.01157238828107574) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(24, drive(_, _, _), 0.24028081411851163) :- !.
delta(24, pick_up(Vehicle, Location, Package, _, _), -0.08288191739039272) :- todo_at(Package, Location2), could_pick_up(Vehicle, Location2), todo_at(Package, Location3), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location3), fewer_capacity_2_than_todo_at_2_at_2, !.
delta(24, pick_up(Vehicle, Location, Package, _, _), 0.002132692769448102) :- todo_at(Package, Location2), could_pick_up(Vehicle, Location2), todo_at(Package, Location3), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location3), !.
delta(24, pick_up(Vehicle, _, Package, _, _), 0.1413360451810121) :- todo_at(Package, Location), could_pick_up(Vehicle, Location), !.
delta(24, pick_up(_, Location, Package, _, _), 0.025936502290555365) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(24, pick_up(_, Location, _, Size, _), 0.022700351818063652) :- capacity(Vehicle, Size), could_drop_todo_at(Vehicle, Location), !.
delta(24, pick_up(_, _, _, _, _), -0.1541291765029725) :- !.
delta(24, drop(Vehicle, _, Package, _, _), 0.01798654923216269) :- at(Vehicle, Location), could_pick_up(Vehicle, Location), todo_at(Package, Location2), could_pick_up(Vehicle, Location2), !.
delta(24, drop(Vehicle, _, _, _, _), -0.0010829048777788646) :- at(Vehicle, Location), could_pick_up(Vehicle, Location), !.
delta(24, drop(_, Location, Package, _, _), 0.006018978570187252) :- fewer_capacity_1_than_at_2, todo_at(Package, Location), !.
delta(24, drop(_, _, _, _, _), -0.004470886614880354) :- fewer_capacity_1_than_at_2, !.
delta(24, drop(_, _, _, _, _), 0.0018401071576669575) :- fewer_capacity_2_than_todo_at_2_at_2, !.
delta(24, drop(_, _, _, _, _), -0.057323303578255505) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 220 examples, 22 leaves
delta(25, drive(Vehicle, _, Location), -0.04049855843252455) :- at(Locatable, Location), goal_at(Locatable, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(25, drive(Vehicle, _, Location), 0.08111389394601483) :- at(Locatable, Location), goal_at(Locatable, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), !.
delta(25, drive(Vehicle, Location, Location2), 0.0067287772394407025) :- at(Locatable, Location2), goal_at(Locatable, _), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(25, drive(_, _, Location), -0.2058350222406294) :- at(Locatable, Location), goal_at(Locatable, _), !.
delta(25, drive(_, Location, _), 0.0) :- at(Locatable, Location), todo_at(Locatable, _), fewer_capacity_2_than_in_1, !.
delta(25, drive(_, Location, _), -0.08059957767946191) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(25, drive(Vehicle, _, _), -0.004097251125410196) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), !.
delta(25, drive(_, _, _), 0.3580272939122799) :- !.
delta(25, pick_up(Vehicle, Location, Package, _, _), -0.05690205160663342) :- todo_at(Package, Location2), at(_, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), fewer_capacity_1_than_todo_at_1, !.
delta(25, pick_up(Vehicle, Location, Package, _, _), 0.0055527446531035245) :- todo_at(Package, Location2), at(_, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(25, pick_up(_, _, Package, _, _), 0.1297082870508233) :- todo_at(Package, Location), at(_, Location), fewer_capacity_2_than_todo_at_1, !.
delta(25, pick_up(_, _, Package, _, _), -0.0018811836159113408) :- todo_at(Package, Location), at(_, Location), !.
delta(25, pick_up(_, _, _, _, _), -0.23116767880054256) :- fewer_capacity_2_than_todo_at_1, fewer_capacity_2_than_at_2, !.
delta(25, pick_up(_, _, _, _, _), 0.0026970600261951375) :- fewer_capacity_2_than_todo_at_1, !.
delta(25, pick_up(_, _, Package, _, _), 0.04121127106763004) :- todo_at(Package, _), !.
delta(25, pick_up(_, _, _, _, _), -0.013526612119502688) :- !.
delta(25, drop(Vehicle, _, _, _, _), 0.04074002399161852) :- at(Vehicle, Location), could_pick_up_for_todo_at_any_location(Vehicle, Location), !.
delta(25, drop(_, _, _, _, _), 0.001543871325593021) :- fewer_capacity_2_than_at_2, fewer_in_2_than_in_1, !.
delta(25, drop(_, _, _, _, _), -0.053993057329727) :- fewer_capacity_2_than_at_2, !.
delta(25, drop(_, Location, Package, _, _), 0.00926545235090872) :- todo_at(Package, Location), !.
delta(25, drop(_, _, _, _, _), -0.006074277676558871) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 204 examples, 18 leaves
delta(26, drive(Vehicle, _, Location), 0.0054033307884436155) :- at(Locatable, Location), vehicle(Locatable), fewer_in_2_than_in_1, at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(26, drive(_, _, Location), -0.0006887460189118396) :- at(Locatable, Location), vehicle(Locatable), fewer_in_2_than_in_1, !.
delta(26, drive(_, _, Location), -0.08781291186385126) :- at(Locatable, Location), vehicle(Locatable), !.
delta(26, drive(_, Location, Location2), -0.047199092206722824) :- todo_at(Locatable, Location), at(Locatable, Location2), fewer_capacity_1_than_at_2, !.
delta(26, drive(_, Location, Location2), 0.012072403399260518) :- todo_at(Locatable, Location), at(Locatable, Location2), !.
delta(26, drive(_, _, _), -0.012827120746688913) :- fewer_in_2_than_in_1, !.
delta(26, drive(_, _, _), 0.3258549451156795) :- !.
delta(26, pick_up(_, Location, Package, _, _), 0.0019576984144112335) :- todo_at(Package, Location2), road(Location, Location2), fewer_capacity_2_than_todo_at_2, fewer_capacity_1_than_todo_at_2, !.
delta(26, pick_up(_, Location, Package, _, _), -0.2906751772578049) :- todo_at(Package, Location2), road(Location, Location2), fewer_capacity_2_than_todo_at_2, !.
delta(26, pick_up(_, Location, Package, _, _), 0.00920728231252107) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(26, pick_up(_, _, Package, _, _), 0.038725195570106334) :- todo_at(Package, Location), at(_, Location), !.
delta(26, pick_up(_, _, _, Size, _), -0.015545437425852605) :- capacity(_, Size), !.
delta(26, pick_up(_, _, _, _, _), 0.006620234548259799) :- !.
delta(26, drop(_, Location, Package, _, _), 0.0039430065337491375) :- todo_at(Package, Location), todo_at(Package, Location2), done_at(_, Location2), fewer_in_2_than_at_2, !.
delta(26, drop(_, Location, Package, _, _), -0.00686545103236885) :- todo_at(Package, Location), todo_at(Package, Location2), done_at(_, Location2), !.
delta(26, drop(_, Location, Package, _, _), 0.02584804852341428) :- todo_at(Package, Location), !.
delta(26, drop(_, _, _, _, _), -0.02055341917694608) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 221 examples, 20 leaves
delta(27, drive(Vehicle, Location, Location2), 0.006369680002172278) :- at(Locatable, Location2), goal_at(Locatable, Location3), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location3), todo_at(Locatable, Location), !.
delta(27, drive(Vehicle, _, Location), -0.05371880495121852) :- at(Locatable, Location), goal_at(Locatable, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(27, drive(_, _, Location), -0.03638778480431534) :- at(Locatable, Location), goal_at(Locatable, _), fewer_capacity_2_than_in_1, !.
delta(27, drive(_, _, Location), 0.14307043412262488) :- at(Locatable, Location), goal_at(Locatable, _), !.
delta(27, drive(Vehicle, _, Location), 0.03372209732268521) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), todo_at(_, Location), !.
delta(27, drive(Vehicle, _, Location), 0.0001355608380928167) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), !.
delta(27, drive(_, _, _), 0.01803885573406253) :- fewer_capacity_2_than_in_1, !.
delta(27, drive(_, _, _), -0.15874058996763296) :- !.
delta(27, pick_up(Vehicle, Location, Package, Size, _), -0.04036651826353375) :- todo_at(Package, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), capacity(Vehicle2, Size), could_pick_up(Vehicle2, Location), !.
delta(27, pick_up(Vehicle, Location, Package, _, _), 0.0009013645084403613) :- todo_at(Package, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(27, pick_up(_, _, _, Size, _), -0.034209206399269644) :- capacity(Vehicle, Size), in(_, Vehicle), fewer_capacity_2_than_todo_at_2, !.
delta(27, pick_up(_, _, _, Size, _), 0.0007761321303509558) :- capacity(Vehicle, Size), in(_, Vehicle), !.
delta(27, pick_up(_, Location, _, _, _), -0.01841676412776491) :- goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(27, pick_up(_, _, _, _, _), 0.1088767437887065) :- !.
delta(27, drop(_, Location, _, _, _), -0.038380753824514745) :- todo_at(Locatable, Location), at(Locatable, _), !.
delta(27, drop(_, _, _, _, _), 0.0061078617249040006) :- fewer_in_2_than_todo_at_2_at_2, fewer_at_2_than_todo_at_1, !.
delta(27, drop(_, _, _, _, _), -0.02504042322055902) :- fewer_in_2_than_todo_at_2_at_2, !.
delta(27, drop(_, Location, Package, _, _), -0.003390913145819285) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(27, drop(_, _, _, _, _), 0.07943237824746487) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 209 examples, 18 leaves
delta(28, drive(Vehicle, _, Location), -0.02776000269424746) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), could_drop_for_todo_at_any_location(Vehicle, Location2), !.
delta(28, drive(Vehicle, _, Location), -0.011496330487486012) :- at(Locatable, Location), vehicle(Locatable), at(Locatable, Location2), could_pick_up_for_todo_at_any_location(Vehicle, Location2), !.
delta(28, drive(_, _, Location), 0.23944052660652645) :- at(Locatable, Location), vehicle(Locatable), !.
delta(28, drive(Vehicle, _, Location), 0.06884429794854026) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location2), fewer_capacity_1_than_at_2, !.
delta(28, drive(Vehicle, _, Location), -0.0028408829650074206) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(28, drive(_, _, Location), 0.03582212903115687) :- todo_at(Locatable, Location), at(Locatable, _), !.
delta(28, drive(_, _, _), -0.26247753134412577) :- !.
delta(28, pick_up(_, _, _, _, _), 0.000966815922227529) :- fewer_capacity_2_than_in_1, fewer_capacity_1_than_todo_at_2, !.
delta(28, pick_up(_, _, _, _, _), -0.07429541339141095) :- fewer_capacity_2_than_in_1, !.
delta(28, pick_up(_, Location, Package, Size, _), -0.0029718403998331673) :- todo_at(Package, Location2), capacity(Vehicle, Size), toward_could_pick_up(Vehicle, Location2, Location), !.
delta(28, pick_up(_, _, Package, _, _), 0.1342860103158061) :- todo_at(Package, _), !.
delta(28, pick_up(_, _, _, _, _), -0.005195912849733975) :- !.
delta(28, drop(_, Location, Package, _, _), 0.025000479675629572) :- fewer_capacity_2_than_todo_at_1, todo_at(Package, Location), !.
delta(28, drop(_, _, _, _, _), -0.0061032026053339065) :- fewer_capacity_2_than_todo_at_1, !.
delta(28, drop(_, _, _, _, _), -0.06839251123329097) :- fewer_at_2_than_at_1, !.
delta(28, drop(_, Location, Package, _, _), 0.0038292622497277154) :- todo_at(Package, Location), !.
delta(28, drop(_, _, _, _, _), -0.0014411571644448872) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 253 examples, 17 leaves
delta(29, drive(Vehicle, Location, Location2), -0.0005613260821944378) :- at(Vehicle, Location3), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location3), at(Vehicle, Location4), could_drop_for_todo_at_any_location(Vehicle, Location4), could_pick_up_needed_in_to_drop(Vehicle, Location), !.
delta(29, drive(Vehicle, _, Location), 0.0006195567906238692) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location, Location2), at(Vehicle, Location3), could_drop_for_todo_at_any_location(Vehicle, Location3), !.
delta(29, drive(Vehicle, _, Location), -0.10626734301588846) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location, Location2), !.
delta(29, drive(Vehicle, Location, Location2), 0.0010372990218362156) :- todo_at(Locatable, Location), at(Locatable, Location2), todo_at(Locatable, Location3), toward_could_drop_todo_at(Vehicle, Location3, Location2), !.
delta(29, drive(_, Location, Location2), -0.05568453013205902) :- todo_at(Locatable, Location), at(Locatable, Location2), !.
delta(29, drive(Vehicle, _, Location), -0.01787060660765536) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(29, drive(_, _, _), 0.23742074350502443) :- !.
delta(29, pick_up(Vehicle, _, Package, _, _), 0.0032222503737269954) :- goal_at(Package, Location), at(_, Location), could_drop_for_todo_at_any_location(Vehicle, Location), !.
delta(29, pick_up(_, Location, Package, _, _), 0.0007084546186295421) :- goal_at(Package, Location2), at(Locatable, Location2), todo_at(Locatable, Location), !.
delta(29, pick_up(_, _, Package, _, _), -0.16764255717707036) :- goal_at(Package, Location), at(_, Location), !.
delta(29, pick_up(_, Location, _, Size, _), -0.020157721073643577) :- capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(29, pick_up(_, _, _, _, _), 0.053667202060269564) :- !.
delta(29, drop(_, Location, Package, _, Size), -0.017388766732499922) :- todo_at(Package, Location), fewer_in_2_than_in_1, capacity(_, Size), !.
delta(29, drop(_, Location, Package, _, _), 0.005813164798820742) :- todo_at(Package, Location), fewer_in_2_than_in_1, !.
delta(29, drop(_, Location, Package, _, _), 0.07159268897029757) :- todo_at(Package, Location), !.
delta(29, drop(_, _, _, _, _), -0.060924169240326315) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 207 examples, 16 leaves
delta(30, drive(Vehicle, _, Location), -0.010504443128122626) :- fewer_capacity_1_than_todo_at_1, could_drop_for_todo_at_any_location(Vehicle, Location), at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location, Location2), !.
delta(30, drive(Vehicle, _, Location), 0.0398380781002347) :- fewer_capacity_1_than_todo_at_1, could_drop_for_todo_at_any_location(Vehicle, Location), !.
delta(30, drive(Vehicle, _, Location), 0.0012435365623597097) :- fewer_capacity_1_than_todo_at_1, at(Vehicle, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(30, drive(_, _, _), -0.08981926324111887) :- fewer_capacity_1_than_todo_at_1, !.
delta(30, drive(Vehicle, _, _), -0.005833314748829606) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), !.
delta(30, drive(_, _, _), -0.0022471257957368935) :- fewer_capacity_2_than_todo_at_2_at_2, !.
delta(30, drive(_, _, _), 0.11733613044747802) :- !.
delta(30, pick_up(_, _, Package, _, _), 0.09424504724256341) :- todo_at(Package, Location), at(_, Location), !.
delta(30, pick_up(_, Location, _, _, _), -0.035975421093261066) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(30, pick_up(_, _, _, _, _), 0.0033286396330978536) :- !.
delta(30, drop(Vehicle, _, _, _, _), 0.010992661109248382) :- at(Vehicle, Location), could_pick_up_for_todo_at_any_location(Vehicle, Location), !.
delta(30, drop(_, Location, Package, _, _), 0.010839016713692057) :- fewer_in_2_than_in_1, todo_at(Package, Location), !.
delta(30, drop(_, _, _, _, _), -0.005389742777663826) :- fewer_in_2_than_in_1, !.
delta(30, drop(_, _, _, _, _), -0.13199370406082586) :- fewer_in_2_than_at_2, !.
delta(30, drop(_, _, _, _, _), 0.0004308129880433219) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 218 examples, 20 leaves
delta(31, drive(Vehicle, _, Location), 0.01233387616450592) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), fewer_capacity_2_than_todo_at_2, could_drop_todo_at(Vehicle, Location), !.
delta(31, drive(Vehicle, _, _), -0.2816869851969451) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), fewer_capacity_2_than_todo_at_2, !.
delta(31, drive(Vehicle, Location, Location2), -0.004248647407777862) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(31, drive(Vehicle, _, _), 0.04162214877414997) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), !.
delta(31, drive(_, _, Location), 0.20876523036688663) :- fewer_capacity_1_than_todo_at_1, at(Locatable, Location), todo_at(Locatable, _), !.
delta(31, drive(_, _, _), -0.004106714762410026) :- fewer_capacity_1_than_todo_at_1, !.
delta(31, drive(Vehicle, _, Location), 0.012856364356926813) :- at(Vehicle, Location2), toward_could_pick_up_needed_capacity_to_drop(Vehicle, Location2, Location), !.
delta(31, drive(_, _, _), -0.08117810585384244) :- !.
delta(31, pick_up(_, _, Package, _, _), 0.0) :- todo_at(Package, Location), at(_, Location), fewer_at_2_than_todo_at_1_at_1, !.
delta(31, pick_up(_, _, Package, _, _), 0.10759653680452712) :- todo_at(Package, Location), at(_, Location), !.
delta(31, pick_up(_, Location, _, Size, _), -0.025972218219247285) :- capacity(Vehicle, Size), could_pick_up(Vehicle, Location), fewer_capacity_2_than_todo_at_1, !.
delta(31, pick_up(_, Location, _, Size, _), 0.0019447435860528012) :- capacity(Vehicle, Size), could_pick_up(Vehicle, Location), !.
delta(31, pick_up(_, _, Package, _, _), 0.022523398047012432) :- todo_at(Package, _), !.
delta(31, pick_up(_, _, _, _, _), -0.005539701456289127) :- !.
delta(31, drop(_, Location, Package, _, _), 0.04691412692844221) :- fewer_capacity_2_than_at_2, todo_at(Package, Location), !.
delta(31, drop(_, _, _, _, _), -0.00785527289976388) :- fewer_capacity_2_than_at_2, !.
delta(31, drop(_, Location, _, _, _), -0.014141078949618564) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(31, drop(_, Location, Package, _, _), 0.004741760766504793) :- todo_at(Package, Location), !.
delta(31, drop(_, _, _, _, _), -0.0023140144824284146) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 220 examples, 19 leaves
delta(32, drive(Vehicle, Location, Location2), 0.003678601491239388) :- in(Package, Vehicle), todo_at(Package, Location2), at(Locatable, Location), package(Locatable), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(32, drive(Vehicle, Location, Location2), -0.14208244408762044) :- in(Package, Vehicle), todo_at(Package, Location2), at(Locatable, Location), package(Locatable), !.
delta(32, drive(Vehicle, Location, Location2), 0.02557064697345525) :- in(Package, Vehicle), todo_at(Package, Location2), todo_at(Package, Location3), toward_could_drop_todo_at(Vehicle, Location, Location3), !.
delta(32, drive(Vehicle, _, Location), -0.00043860358627767536) :- in(Package, Vehicle), todo_at(Package, Location), !.
delta(32, drive(_, _, _), -0.007273428693575574) :- fewer_capacity_2_than_todo_at_2, fewer_at_2_than_todo_at_2, !.
delta(32, drive(_, _, _), 0.3107746829044732) :- fewer_capacity_2_than_todo_at_2, !.
delta(32, drive(_, Location, _), 0.014327618907322879) :- todo_at(Locatable, Location), at(Locatable, _), !.
delta(32, drive(_, _, _), -0.07845202988547963) :- !.
delta(32, pick_up(_, _, _, _, _), 0.0026497129005195845) :- fewer_capacity_2_than_todo_at_2, fewer_in_2_than_in_1, !.
delta(32, pick_up(Vehicle, _, _, _, _), 0.00161965363156668) :- fewer_capacity_2_than_todo_at_2, at(Vehicle, Location), could_pick_up_needed_capacity_to_drop(Vehicle, Location), !.
delta(32, pick_up(_, _, _, _, _), -0.2458692717891089) :- fewer_capacity_2_than_todo_at_2, !.
delta(32, pick_up(_, _, Package, _, _), 0.03244238153048474) :- todo_at(Package, _), !.
delta(32, pick_up(_, _, _, _, _), -0.004402324654824774) :- !.
delta(32, drop(_, Location, _, _, _), -0.03901846095774793) :- at(Locatable, Location), todo_at(Locatable, _), fewer_capacity_2_than_in_1, !.
delta(32, drop(_, Location, Package, _, _), 0.0016200912965077482) :- at(Locatable, Location), todo_at(Locatable, _), todo_at(Package, Location), !.
delta(32, drop(_, Location, _, _, _), -6.32569483386982e-5) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(32, drop(_, Location, Package, _, _), 0.0763040961364474) :- todo_at(Package, Location), !.
delta(32, drop(_, _, _, _, _), -0.009829072442196383) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 232 examples, 19 leaves
delta(33, drive(Vehicle, _, Location), 0.0009586621390672714) :- in(Package, Vehicle), todo_at(Package, Location), fewer_at_2_than_at_1, fewer_at_2_than_todo_at_2, !.
delta(33, drive(Vehicle, _, Location), -0.12442671573544657) :- in(Package, Vehicle), todo_at(Package, Location), fewer_at_2_than_at_1, !.
delta(33, drive(Vehicle, _, Location), 0.006772296454850397) :- in(Package, Vehicle), todo_at(Package, Location), !.
delta(33, drive(Vehicle, _, _), -0.07643368311744246) :- at(Vehicle, Location), could_pick_up(Vehicle, Location), fewer_in_2_than_todo_at_1, !.
delta(33, drive(Vehicle, _, _), 0.016700226687865086) :- at(Vehicle, Location), could_pick_up(Vehicle, Location), !.
delta(33, drive(Vehicle, _, Location), -0.026655437779646112) :- at(Vehicle, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(33, drive(_, _, _), 0.15305069751507666) :- !.
delta(33, pick_up(_, _, Package, _, _), 0.1111448763374643) :- todo_at(Package, Location), at(_, Location), !.
delta(33, pick_up(_, _, _, _, _), -0.10873982322548117) :- fewer_capacity_1_than_at_2, !.
delta(33, pick_up(_, Location, Package, _, _), 0.021963792142019274) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(33, pick_up(_, _, _, _, _), -0.00574666000246349) :- !.
delta(33, drop(_, Location, Package, _, _), 0.002624643143392041) :- fewer_capacity_2_than_todo_at_1, fewer_capacity_2_than_in_1, todo_at(Package, Location), !.
delta(33, drop(_, _, _, _, _), -0.0016523295903857077) :- fewer_capacity_2_than_todo_at_1, fewer_capacity_2_than_in_1, !.
delta(33, drop(_, Location, _, _, Size), 0.00018748875061879662) :- fewer_capacity_2_than_todo_at_1, capacity(Vehicle, Size), could_drop_for_todo_at_any_location(Vehicle, Location), !.
delta(33, drop(_, _, _, _, _), -0.025637957281774655) :- fewer_capacity_2_than_todo_at_1, !.
delta(33, drop(_, Location, Package, _, _), -0.00028670747023144995) :- todo_at(Package, Location2), at(_, Location2), road(Location, Location2), !.
delta(33, drop(_, _, Package, _, _), 0.0384449418977673) :- todo_at(Package, Location), at(_, Location), !.
delta(33, drop(_, _, _, _, _), -0.0017068035071893604) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 216 examples, 17 leaves
delta(34, drive(Vehicle, Location, Location2), -0.015027254512692448) :- at(Locatable, Location2), todo_at(Locatable, Location3), road(Location, Location3), toward_could_drop_todo_at(Vehicle, Location3, Location), !.
delta(34, drive(_, Location, Location2), 0.07205345849593901) :- at(Locatable, Location2), todo_at(Locatable, Location3), road(Location, Location3), !.
delta(34, drive(Vehicle, _, Location), 0.003675880735257598) :- at(Locatable, Location), todo_at(Locatable, Location2), could_pick_up_needed_in_to_drop(Vehicle, Location2), !.
delta(34, drive(_, _, Location), -0.20787449038289507) :- at(_, Location), !.
delta(34, drive(_, _, _), -0.047664863515297036) :- fewer_capacity_1_than_todo_at_2, !.
delta(34, drive(Vehicle, _, Location), -0.012921941729646502) :- at(Vehicle, Location2), toward_could_pick_up_needed_capacity_to_drop(Vehicle, Location, Location2), !.
delta(34, drive(_, _, _), 0.16004455039795348) :- !.
delta(34, pick_up(_, _, Package, _, _), 0.13192729020726263) :- todo_at(Package, Location), at(_, Location), !.
delta(34, pick_up(_, Location, Package, Size, _), 0.01987727630922465) :- capacity(Vehicle, Size), could_drop_for_todo_at_any_location(Vehicle, Location), todo_at(Package, _), !.
delta(34, pick_up(_, Location, _, Size, _), -3.023100820358956e-5) :- capacity(Vehicle, Size), could_drop_for_todo_at_any_location(Vehicle, Location), !.
delta(34, pick_up(_, _, _, _, _), 0.001463383138145614) :- fewer_at_2_than_todo_at_2, !.
delta(34, pick_up(_, _, _, _, _), -0.11259135846970951) :- !.
delta(34, drop(_, Location, Package, _, Size), 0.0005421712094573167) :- capacity(Vehicle, Size), at(Vehicle, Location), todo_at(Package, Location2), could_pick_up(Vehicle, Location2), !.
delta(34, drop(_, Location, _, _, Size), -0.031392527579457645) :- capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(34, drop(_, Location, Package, _, _), 0.041380631654966554) :- todo_at(Package, Location), !.
delta(34, drop(_, _, _, _, _), -0.004601878408113019) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 233 examples, 20 leaves
delta(35, drive(_, Location, Location2), 0.017745886172515588) :- at(Locatable, Location2), goal_at(_, Location), todo_at(Locatable, Location), !.
delta(35, drive(_, Location, Location2), -0.239000565353453) :- at(_, Location2), goal_at(_, Location), !.
delta(35, drive(Vehicle, _, Location), -0.04544037879814251) :- at(_, Location), at(Vehicle, Location2), could_pick_up_needed_capacity_to_drop(Vehicle, Location2), !.
delta(35, drive(_, _, Location), 0.07114378944152047) :- at(_, Location), !.
delta(35, drive(Vehicle, _, Location), -0.016008066920194818) :- fewer_capacity_2_than_todo_at_2, could_drop_for_todo_at_any_location(Vehicle, Location), !.
delta(35, drive(_, _, _), 0.12427339152334009) :- fewer_capacity_2_than_todo_at_2, !.
delta(35, drive(Vehicle, _, Location), 0.01053376936187494) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location2, Location), !.
delta(35, drive(_, _, _), -0.039095253370063726) :- !.
delta(35, pick_up(_, Location, Package, _, _), -0.00564225347866734) :- goal_at(Locatable, Location), at(Locatable, _), goal_at(Package, Location), !.
delta(35, pick_up(_, Location, _, _, _), 0.19270216459891504) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(35, pick_up(Vehicle, _, _, _, _), -0.09030938264277615) :- fewer_capacity_1_than_todo_at_1, capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), !.
delta(35, pick_up(_, _, _, _, _), 0.0062141077473586845) :- fewer_capacity_1_than_todo_at_1, !.
delta(35, pick_up(_, _, _, _, _), 0.022969867481740344) :- !.
delta(35, drop(_, Location, Package, _, _), 0.020722145670930076) :- goal_at(Locatable, Location), at(Locatable, _), todo_at(Package, Location), !.
delta(35, drop(_, Location, _, _, _), -0.0020232252482198943) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(35, drop(_, _, _, _, _), 0.002710399349245841) :- fewer_capacity_2_than_todo_at_1, fewer_in_2_than_in_1, !.
delta(35, drop(_, _, _, _, _), -0.03514691481788659) :- fewer_capacity_2_than_todo_at_1, !.
delta(35, drop(_, Location, Package, _, _), 0.007015450234799406) :- todo_at(Package, Location), !.
delta(35, drop(_, _, _, _, _), -0.0013014932477189948) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 201 examples, 22 leaves
delta(36, drive(Vehicle, Location, Location2), 0.011554783538602242) :- at(Locatable, Location2), vehicle(Locatable), at(Vehicle, Location3), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location3), could_pick_up(Vehicle, Location), !.
delta(36, drive(Vehicle, _, Location), -0.0006719210581135043) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location, Location2), !.
delta(36, drive(Vehicle, _, Location), 0.0025641420620353657) :- at(Locatable, Location), vehicle(Locatable), at(Vehicle, Location2), could_drop_for_todo_at_any_location(Vehicle, Location2), !.
delta(36, drive(_, _, Location), -0.10653103488517329) :- at(Locatable, Location), vehicle(Locatable), !.
delta(36, drive(_, Location, Location2), 0.054226084961794645) :- goal_at(Locatable, Location), at(Locatable, Location3), nearer_at(Location, Location2, Location3), !.
delta(36, drive(_, Location, _), -0.09991292501999585) :- goal_at(_, Location), !.
delta(36, drive(Vehicle, _, Location), -0.006875604081829862) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(36, drive(_, _, _), 0.14962165888768045) :- !.
delta(36, pick_up(Vehicle, _, Package, _, _), 0.000741549689916254) :- fewer_capacity_1_than_todo_at_2_at_2, todo_at(Package, Location), could_pick_up_needed_capacity_to_drop(Vehicle, Location), !.
delta(36, pick_up(_, _, _, _, _), -0.07011679547838276) :- fewer_capacity_1_than_todo_at_2_at_2, !.
delta(36, pick_up(Vehicle, Location, Package, _, _), 0.006798178878826671) :- at(Vehicle, Location2), could_pick_up_needed_capacity_to_drop(Vehicle, Location2), todo_at(Package, Location3), toward_could_pick_up_needed_in_to_drop(Vehicle, Location3, Location), !.
delta(36, pick_up(Vehicle, _, _, _, _), -0.03391144413932868) :- at(Vehicle, Location), could_pick_up_needed_capacity_to_drop(Vehicle, Location), !.
delta(36, pick_up(Vehicle, _, Package, _, _), -0.009575670837303565) :- goal_at(Package, Location), could_drop(Vehicle, Location), !.
delta(36, pick_up(_, _, _, _, _), 0.11673820756474439) :- !.
delta(36, drop(Vehicle, _, _, _, _), -0.032921739104941485) :- fewer_in_2_than_todo_at_2_at_2, capacity(Vehicle, Size), beyond_capacity_predecessor(_, Size), !.
delta(36, drop(_, Location, Package, _, _), 0.006057823581819355) :- fewer_in_2_than_todo_at_2_at_2, todo_at(Package, Location), !.
delta(36, drop(_, _, _, _, _), -0.0031251257015398773) :- fewer_in_2_than_todo_at_2_at_2, !.
delta(36, drop(_, _, Package, _, _), 0.0010400727595164516) :- todo_at(Package, Location), done_at(_, Location), fewer_in_2_than_at_2, !.
delta(36, drop(_, _, Package, _, _), -0.007890484642761741) :- todo_at(Package, Location), done_at(_, Location), !.
delta(36, drop(_, Location, Package, _, _), 0.014527211925481204) :- todo_at(Package, Location), !.
delta(36, drop(_, _, _, _, _), -0.002285106065676214) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 237 examples, 19 leaves
delta(37, drive(Vehicle, Location, Location2), 0.006694083439355661) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), toward_could_pick_up(Vehicle, Location, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(37, drive(Vehicle, Location, Location2), -0.1322223376941136) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), toward_could_pick_up(Vehicle, Location, Location2), !.
delta(37, drive(Vehicle, Location, Location2), -0.0187218506303061) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), toward_could_pick_up(Vehicle, Location2, Location), !.
delta(37, drive(Vehicle, _, _), 0.06428655707172949) :- capacity(Vehicle, Size), beyond_capacity_predecessor(Size, _), !.
delta(37, drive(Vehicle, Location, Location2), 0.0007246422131166398) :- goal_at(Locatable, Location2), goal_at(Locatable, Location3), toward_could_pick_up(Vehicle, Location, Location3), !.
delta(37, drive(_, _, Location), -0.02595149106605774) :- goal_at(_, Location), !.
delta(37, drive(_, _, _), 0.15921802000672644) :- fewer_capacity_1_than_at_2, !.
delta(37, drive(_, _, _), -0.006887865042435377) :- !.
delta(37, pick_up(_, _, _, _, Size), 0.0025453398869794406) :- fewer_capacity_1_than_todo_at_1, capacity(Vehicle, Size), in(_, Vehicle), !.
delta(37, pick_up(_, _, _, _, _), -0.0758313527771484) :- fewer_capacity_1_than_todo_at_1, fewer_capacity_2_than_todo_at_2_at_2, !.
delta(37, pick_up(_, _, _, _, _), 0.0003109285989090242) :- fewer_capacity_1_than_todo_at_1, !.
delta(37, pick_up(_, _, Package, _, _), 0.015521703530802863) :- todo_at(Package, _), !.
delta(37, pick_up(_, _, _, _, _), -0.002464953576871817) :- !.
delta(37, drop(Vehicle, _, _, _, _), -0.014930367620341955) :- fewer_capacity_1_than_at_2, capacity(Vehicle, Size), beyond_capacity_predecessor(_, Size), !.
delta(37, drop(_, _, _, _, _), -9.069810939642472e-5) :- fewer_capacity_1_than_at_2, fewer_capacity_1_than_todo_at_2, !.
delta(37, drop(_, _, _, _, _), 0.0013468238748901484) :- fewer_capacity_1_than_at_2, !.
delta(37, drop(Vehicle, _, _, _, _), 0.011909654830146539) :- at(Vehicle, Location), could_drop_todo_at(Vehicle, Location), !.
delta(37, drop(_, _, _, _, _), -0.0010973017230771235) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 236 examples, 21 leaves
delta(38, drive(Vehicle, _, Location), 0.00015228565524245675) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), at(Vehicle, Location3), toward_could_drop_for_todo_at_any_location(Vehicle, Location3, Location), fewer_in_2_than_in_1, !.
delta(38, drive(Vehicle, _, Location), -0.0334879239927621) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), at(Vehicle, Location3), toward_could_drop_for_todo_at_any_location(Vehicle, Location3, Location), !.
delta(38, drive(Vehicle, _, Location), -0.014000569340222493) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), could_pick_up_for_todo_at_any_location(Vehicle, Location), !.
delta(38, drive(Vehicle, _, Location), 0.14665194833349188) :- at(Vehicle, Location2), toward_could_pick_up_needed_in_to_drop(Vehicle, Location2, Location), !.
delta(38, drive(Vehicle, _, Location), 0.08359630435410922) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location, Location2), fewer_capacity_1_than_todo_at_2, !.
delta(38, drive(Vehicle, _, Location), -0.01882777815730401) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location, Location2), !.
delta(38, drive(_, _, _), -0.17632987484146068) :- fewer_in_2_than_todo_at_1, !.
delta(38, drive(_, _, _), 0.013728296766696131) :- !.
delta(38, pick_up(Vehicle, Location, Package, _, _), 0.0033666036371153988) :- todo_at(Package, Location2), road(Location, Location2), fewer_capacity_1_than_at_2, todo_at(Package, Location3), could_drop(Vehicle, Location3), !.
delta(38, pick_up(_, Location, Package, _, _), -0.1643494540233348) :- todo_at(Package, Location2), road(Location, Location2), fewer_capacity_1_than_at_2, !.
delta(38, pick_up(_, Location, Package, _, _), 0.008243736071435056) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(38, pick_up(Vehicle, Location, _, _, _), 0.006172619897786077) :- goal_at(Locatable, Location), at(Locatable, Location2), could_pick_up_for_todo_at_any_location(Vehicle, Location2), !.
delta(38, pick_up(_, Location, _, _, _), -0.013127465702772071) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(38, pick_up(_, _, _, _, _), 0.14750895641375558) :- !.
delta(38, drop(_, Location, Package, _, _), 0.011795665877287352) :- fewer_in_2_than_todo_at_1, todo_at(Package, Location), !.
delta(38, drop(_, _, _, _, _), -0.004740222417745229) :- fewer_in_2_than_todo_at_1, !.
delta(38, drop(Vehicle, _, _, _, _), -0.01248632994613208) :- fewer_capacity_2_than_at_2, capacity(Vehicle, Size), beyond_capacity_predecessor(_, Size), !.
delta(38, drop(_, _, _, _, _), 0.0011695370632490792) :- fewer_capacity_2_than_at_2, !.
delta(38, drop(_, Location, Package, _, _), 0.002307216006943682) :- todo_at(Package, Location), !.
delta(38, drop(_, _, _, _, _), -0.00039974424761913993) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 249 examples, 15 leaves
delta(39, drive(Vehicle, Location, Location2), -0.008084139298299323) :- at(Vehicle, Location3), could_pick_up(Vehicle, Location3), goal_at(_, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(39, drive(Vehicle, _, Location), 0.06974255609862881) :- at(Vehicle, Location2), could_pick_up(Vehicle, Location2), goal_at(_, Location), !.
delta(39, drive(Vehicle, _, _), 0.0017040832653205202) :- at(Vehicle, Location), could_pick_up(Vehicle, Location), fewer_in_2_than_todo_at_2_at_2, !.
delta(39, drive(Vehicle, _, _), -0.014820263319808466) :- at(Vehicle, Location), could_pick_up(Vehicle, Location), !.
delta(39, drive(_, Location, Location2), -0.0005237500507849892) :- todo_at(Locatable, Location), at(Locatable, Location2), fewer_at_2_than_at_1, !.
delta(39, drive(_, Location, Location2), 0.0019986159301326237) :- todo_at(Locatable, Location), at(Locatable, Location2), !.
delta(39, drive(_, _, _), -0.10739237884617764) :- fewer_in_2_than_todo_at_1, !.
delta(39, drive(_, _, _), -0.0004251055532175097) :- !.
delta(39, pick_up(_, Location, _, _, Size), -0.007291674669469648) :- capacity(Vehicle, Size), could_drop_todo_at(Vehicle, Location), !.
delta(39, pick_up(_, _, Package, _, _), 0.04089071621510456) :- todo_at(Package, _), !.
delta(39, pick_up(_, _, _, _, _), -0.0033716082650487415) :- !.
delta(39, drop(_, Location, _, _, Size), -0.010025861330569177) :- capacity(Vehicle, Size), could_drop_todo_at(Vehicle, Location), !.
delta(39, drop(_, Location, Package, _, _), 0.05511640067426726) :- todo_at(Package, Location), !.
delta(39, drop(_, _, _, _, _), -0.006120926962675557) :- !.
delta(39, _, 0.0).

% tree 40: step size 1.0, 261 examples, 17 leaves
delta(40, drive(Vehicle, Location, Location2), -0.07066896585210791) :- goal_at(Locatable, Location2), at(Locatable, _), toward_could_pick_up_needed_in_to_drop(Vehicle, Location, Location2), could_pick_up_needed_in_to_drop(Vehicle, Location2), !.
delta(40, drive(Vehicle, Location, Location2), 0.004698678218787737) :- goal_at(Locatable, Location2), at(Locatable, _), toward_could_pick_up_needed_in_to_drop(Vehicle, Location, Location2), !.
delta(40, drive(Vehicle, Location, Location2), -0.002234358798695092) :- goal_at(Locatable, Location2), at(Locatable, Location3), toward_could_pick_up(Vehicle, Location, Location3), !.
delta(40, drive(_, _, Location), 0.21775561739433183) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(40, drive(Vehicle, Location, Location2), -0.015205312415693964) :- at(Vehicle, Location3), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location3), todo_at(_, Location), !.
delta(40, drive(Vehicle, _, Location), 0.0610330883075446) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(40, drive(_, Location, Location2), 0.014377359711196315) :- todo_at(Locatable, Location), at(Locatable, Location2), !.
delta(40, drive(_, _, _), -0.24759044353794898) :- !.
delta(40, pick_up(_, Location, _, Size, _), -0.06143783260724279) :- capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(40, pick_up(_, _, Package, _, _), 0.00010606083512910768) :- todo_at(Package, Location), at(Locatable, Location), goal_at(Locatable, Location), !.
delta(40, pick_up(_, _, Package, _, _), 0.10447361366243843) :- todo_at(Package, Location), at(_, Location), !.
delta(40, pick_up(_, _, _, _, _), -0.023466341005745347) :- fewer_in_2_than_todo_at_2_at_2, !.
delta(40, pick_up(_, _, _, _, _), 0.004575625770551449) :- !.
delta(40, drop(Vehicle, _, Package, _, _), -0.009349191170107712) :- todo_at(Package, Location), could_pick_up_needed_in_to_drop(Vehicle, Location), !.
delta(40, drop(_, Location, Package, _, _), 0.06140893028999747) :- todo_at(Package, Location), !.
delta(40, drop(_, _, _, _, _), -0.005498160578849297) :- !.
delta(40, _, 0.0).

% tree 41: step size 1.0, 215 examples, 20 leaves
delta(41, drive(Vehicle, _, Location), -0.009502767667762407) :- fewer_capacity_2_than_in_1, at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(41, drive(_, _, Location), 0.07252380657090735) :- fewer_capacity_2_than_in_1, goal_at(_, Location), !.
delta(41, drive(_, _, _), -3.7850524011539855e-6) :- fewer_capacity_2_than_in_1, !.
delta(41, drive(Vehicle, Location, Location2), 0.03933374087565655) :- todo_at(Locatable, Location2), at(Locatable, Location), todo_at(Locatable, Location3), toward_could_pick_up_needed_capacity_to_drop(Vehicle, Location3, Location), !.
delta(41, drive(_, Location, Location2), -0.0025782992766979324) :- todo_at(Locatable, Location2), at(Locatable, Location), !.
delta(41, drive(_, _, Location), 0.025374104142308205) :- goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(41, drive(_, _, _), -0.09992930302229029) :- !.
delta(41, pick_up(Vehicle, Location, Package, _, _), 0.000488410036446313) :- todo_at(Package, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), todo_at(Package, Location3), could_pick_up_needed_in_to_drop(Vehicle, Location3), !.
delta(41, pick_up(Vehicle, Location, Package, _, _), -0.038766947869829815) :- todo_at(Package, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(41, pick_up(_, Location, _, Size, _), 0.0006344016947477082) :- capacity(Vehicle, Size), in(_, Vehicle), could_pick_up_needed_in_to_drop(Vehicle, Location), !.
delta(41, pick_up(_, _, _, Size, _), -0.02161794292367832) :- capacity(Vehicle, Size), in(_, Vehicle), !.
delta(41, pick_up(_, _, Package, _, _), 0.09141569078619545) :- todo_at(Package, _), !.
delta(41, pick_up(_, _, _, _, _), -0.002191796528982928) :- !.
delta(41, drop(Vehicle, _, Package, _, _), -0.0006638472124527813) :- fewer_in_2_than_todo_at_2_at_2, todo_at(Package, Location), could_pick_up(Vehicle, Location), !.
delta(41, drop(_, _, _, _, _), 0.016566730727615574) :- fewer_in_2_than_todo_at_2_at_2, !.
delta(41, drop(_, Location, _, _, Size), 0.000459275737400436) :- fewer_in_2_than_todo_at_1, capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(41, drop(_, _, _, _, _), -0.06991750183786115) :- fewer_in_2_than_todo_at_1, !.
delta(41, drop(_, Location, Package, _, _), 0.006455078943084783) :- todo_at(Package, Location), !.
delta(41, drop(_, _, _, _, _), -0.001221288733290193) :- !.
delta(41, _, 0.0).

% tree 42: step size 1.0, 240 examples, 21 leaves
delta(42, drive(Vehicle, _, Location), -0.031518096581502425) :- todo_at(Locatable, Location), at(Locatable, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(42, drive(_, Location, Location2), -0.004594373729867196) :- todo_at(_, Location2), todo_at(_, Location), !.
delta(42, drive(_, _, Location), 0.1717368733397523) :- todo_at(_, Location), !.
delta(42, drive(Vehicle, _, Location), 0.011354193058255137) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location, Location2), at(Vehicle, Location3), toward_could_pick_up_needed_in_to_drop(Vehicle, Location3, Location), !.
delta(42, drive(Vehicle, _, Location), -0.004711066372176158) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location, Location2), !.
delta(42, drive(Vehicle, _, Location), 0.0033622394398379433) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(42, drive(_, _, _), -0.11151347624133481) :- !.
delta(42, pick_up(_, Location, _, Size, _), -0.06534995328069587) :- capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(42, pick_up(_, Location, _, _, _), -0.021660817786963434) :- fewer_capacity_1_than_at_2, todo_at(Locatable, Location), at(Locatable, _), !.
delta(42, pick_up(_, _, _, _, _), 0.08499635822323065) :- fewer_capacity_1_than_at_2, !.
delta(42, pick_up(Vehicle, Location, Package, _, _), 0.014513817745819673) :- todo_at(Package, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(42, pick_up(_, _, _, _, _), -0.03894496338246572) :- !.
delta(42, drop(Vehicle, Location, _, _, _), -0.0013513388073307985) :- goal_at(Locatable, Location), at(Locatable, Location2), fewer_capacity_2_than_at_2, toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(42, drop(_, Location, _, _, _), 0.05231948025945222) :- goal_at(Locatable, Location), at(Locatable, _), fewer_capacity_2_than_at_2, !.
delta(42, drop(Vehicle, Location, _, _, _), 0.00018830867082823214) :- goal_at(Locatable, Location), at(Locatable, _), could_pick_up_for_todo_at_any_location(Vehicle, Location), !.
delta(42, drop(_, Location, _, _, _), -0.009093261046775884) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(42, drop(_, _, _, _, Size), -0.059424916519833754) :- capacity(_, Size), fewer_in_2_than_todo_at_2, !.
delta(42, drop(_, _, _, _, Size), 0.005132053847911403) :- capacity(_, Size), !.
delta(42, drop(_, Location, Package, _, _), 0.011128848787095628) :- todo_at(Package, Location), !.
delta(42, drop(_, _, _, _, _), -0.0024203081618593635) :- !.
delta(42, _, 0.0).

% tree 43: step size 1.0, 202 examples, 15 leaves
delta(43, drive(Vehicle, Location, Location2), 0.0024643941198384143) :- could_pick_up_needed_in_to_drop(Vehicle, Location2), fewer_in_2_than_todo_at_2, goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(43, drive(Vehicle, _, Location), -0.1767093541030974) :- could_pick_up_needed_in_to_drop(Vehicle, Location), fewer_in_2_than_todo_at_2, !.
delta(43, drive(Vehicle, _, Location), 0.021304099782959843) :- could_pick_up_needed_in_to_drop(Vehicle, Location), !.
delta(43, drive(_, _, Location), -0.07856483415756786) :- goal_at(Locatable, Location), done_at(Locatable, Location), fewer_in_2_than_todo_at_1, !.
delta(43, drive(_, _, Location), 0.018804583375589334) :- goal_at(Locatable, Location), done_at(Locatable, Location), !.
delta(43, drive(_, _, Location), 0.2470057817618087) :- todo_at(_, Location), !.
delta(43, drive(_, _, _), -0.020558816757385804) :- !.
delta(43, pick_up(Vehicle, Location, Package, _, _), 0.00048474536822845486) :- todo_at(Package, Location2), at(_, Location2), could_pick_up_needed_capacity_to_drop(Vehicle, Location2), road(Location, Location2), !.
delta(43, pick_up(Vehicle, _, Package, _, _), 0.0) :- todo_at(Package, Location), at(_, Location), could_pick_up_needed_capacity_to_drop(Vehicle, Location), !.
delta(43, pick_up(_, _, Package, _, _), 0.07495937283419869) :- todo_at(Package, Location), at(_, Location), !.
delta(43, pick_up(_, Location, _, _, _), -0.09503496083675417) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(43, pick_up(_, _, _, _, _), 0.004889444338530336) :- !.
delta(43, drop(_, Location, Package, _, _), 0.011651985300695056) :- todo_at(Package, Location), !.
delta(43, drop(_, _, _, _, _), -0.005551222172170971) :- !.
delta(43, _, 0.0).
