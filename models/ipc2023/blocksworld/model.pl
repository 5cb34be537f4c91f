% SHA-256 of what follows: c596c4269ea48303de85c11c7045e2c8d536af90492fe0fc592d742e92d9d946
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
model(trained_episodes, 587).
model(trees, 44).

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

% tree 1: step size 1.0, 224 examples, 6 leaves
delta(1, pickup(_), 0.0) :- !.
delta(1, putdown(_), 0.27027027027027034) :- todo_clear(Object), todo_on_table(Object), !.
delta(1, putdown(_), -0.01261115602263541) :- !.
delta(1, stack(_, _), -0.27027027027027034) :- todo_clear(Object), todo_on_table(Object), !.
delta(1, stack(_, _), 0.01261115602263541) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 232 examples, 7 leaves
delta(2, pickup(Object), 0.1542518127883982) :- goal_clear(Object), !.
delta(2, pickup(_), -0.1542518127883982) :- !.
delta(2, putdown(_), -0.18678465740743444) :- todo_clear(Object), todo_on(Object, _), !.
delta(2, putdown(_), 0.323084394700877) :- !.
delta(2, stack(_, Object), 0.18678465740743444) :- todo_clear(Object2), todo_on(Object2, Object), !.
delta(2, stack(_, _), -0.323084394700877) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 242 examples, 12 leaves
delta(3, pickup(Object), -0.1579675878695192) :- todo_on(Object, Object2), clear(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(3, pickup(Object), 0.39941737303647246) :- todo_on(Object, Object2), clear(Object2), !.
delta(3, pickup(_), -0.4581033087513324) :- !.
delta(3, putdown(Object), -0.2607342913895791) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(3, putdown(Object), -0.05978900163927641) :- todo_on(Object, Object2), on(Object2, _), !.
delta(3, putdown(_), 0.5281739629507142) :- !.
delta(3, stack(Object, Object2), -0.11106940390059877) :- todo_on(Object, Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(3, stack(Object, Object2), 0.4294225132890731) :- todo_on(Object, Object2), !.
delta(3, stack(_, _), -0.5540291555717124) :- !.
delta(3, unstack(_, Object), -0.06395518828306747) :- goal_on_table(Object), !.
delta(3, unstack(_, _), 0.29141552900367446) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 214 examples, 12 leaves
delta(4, pickup(Object), -0.15793838614523806) :- todo_on(Object, Object2), clear(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(4, pickup(Object), 0.345440534242358) :- todo_on(Object, Object2), clear(Object2), !.
delta(4, pickup(_), -0.34526496289054415) :- !.
delta(4, putdown(Object), -0.2200879364318186) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(4, putdown(Object), -0.07492459821996149) :- todo_on(Object, Object2), on(Object2, _), !.
delta(4, putdown(_), 0.34812762891178406) :- !.
delta(4, stack(Object, Object2), -0.09411477756689442) :- todo_on(Object, Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(4, stack(Object, Object2), 0.37160768592176713) :- todo_on(Object, Object2), !.
delta(4, stack(_, _), -0.37095127909538406) :- !.
delta(4, unstack(Object, _), -0.13790484432880198) :- todo_on(Object2, Object), done_clear(Object2), !.
delta(4, unstack(_, _), 0.272548302229502) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 206 examples, 12 leaves
delta(5, pickup(Object), -0.12424617773273705) :- todo_on(Object, Object2), clear(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(5, pickup(Object), 0.2701937597504015) :- todo_on(Object, Object2), clear(Object2), !.
delta(5, pickup(_), -0.27884268150249525) :- !.
delta(5, putdown(Object), 0.134522574482996) :- todo_on(Object, Object2), clear(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(5, putdown(Object), -0.24917867194990975) :- todo_on(Object, Object2), clear(Object2), !.
delta(5, putdown(_), 0.20413847352571274) :- !.
delta(5, stack(_, Object), -0.2967793144266622) :- unsettled_on(Object), !.
delta(5, stack(Object, Object2), 0.282763304142952) :- todo_on(Object, Object2), !.
delta(5, stack(_, _), -0.06054324115265914) :- !.
delta(5, unstack(Object, _), -0.11600494610559817) :- todo_on(Object2, Object), done_clear(Object2), !.
delta(5, unstack(_, _), 0.23155488550242853) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 206 examples, 14 leaves
delta(6, pickup(Object), -0.09452346252493918) :- todo_on(Object, Object2), clear(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(6, pickup(Object), 0.20589574981291053) :- todo_on(Object, Object2), clear(Object2), !.
delta(6, pickup(_), -0.20859242877377107) :- !.
delta(6, putdown(Object), 0.026366435179744848) :- todo_on(Object, Object2), done_on_table(Object2), todo_on(Object3, Object), on(Object3, Object2), !.
delta(6, putdown(Object), -0.12520821114732608) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(6, putdown(_), 0.20665831355873363) :- clear(Object), unsettled_on(Object), !.
delta(6, putdown(_), 0.02070583517958783) :- todo_clear(Object), todo_on_table(Object), !.
delta(6, putdown(_), -0.0693754689801976) :- !.
delta(6, stack(_, Object), -0.22831731937952848) :- unsettled_on(Object), !.
delta(6, stack(Object, Object2), 0.2052179916013254) :- todo_on(Object, Object2), !.
delta(6, stack(_, _), -0.04822814763370499) :- !.
delta(6, unstack(Object, _), -0.09467729869266903) :- todo_on(Object2, Object), done_clear(Object2), !.
delta(6, unstack(_, _), 0.17928973189847416) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 202 examples, 13 leaves
delta(7, pickup(Object), -0.18137890112078817) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(7, pickup(Object), -0.11720299909374399) :- goal_on_table(Object), !.
delta(7, pickup(_), 0.2429696525535961) :- !.
delta(7, putdown(Object), 0.17696455615536677) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(7, putdown(Object), 0.10162227675607771) :- todo_on_table(Object), !.
delta(7, putdown(_), -0.1915523058265296) :- !.
delta(7, stack(_, Object), -0.23721663770689816) :- unsettled_on(Object), !.
delta(7, stack(Object, Object2), 0.21980900475409662) :- todo_on(Object, Object2), !.
delta(7, stack(_, _), -0.06000872289881983) :- !.
delta(7, unstack(_, Object), -0.014302704581194706) :- on(Object2, Object), unsettled_on(Object2), todo_on(Object, Object3), could_unstack_needed_clear_to_stack(Object3), !.
delta(7, unstack(_, Object), 0.19048867239918962) :- on(Object2, Object), unsettled_on(Object2), !.
delta(7, unstack(_, _), -0.14734744824420176) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 202 examples, 18 leaves
delta(8, pickup(Object), -0.20635535117746953) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(8, pickup(Object), -0.11120956455247083) :- goal_on_table(Object), !.
delta(8, pickup(_), 0.306633012702974) :- on_table(Object), goal_clear(Object), !.
delta(8, pickup(_), -0.024341314724632978) :- !.
delta(8, putdown(Object), -0.12747615997969539) :- todo_on(Object, Object2), done_on_table(Object2), clear(Object3), on_table(Object3), !.
delta(8, putdown(Object), 0.013788245325558704) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(8, putdown(Object), -0.02812876056173904) :- clear(Object2), unsettled_on(Object2), todo_on(Object, Object3), beyond_goal_on(Object2, Object3), !.
delta(8, putdown(_), 0.2144019625315867) :- clear(Object), unsettled_on(Object), !.
delta(8, putdown(_), 0.01564457787578236) :- todo_clear(Object), todo_on_table(Object), !.
delta(8, putdown(_), -0.059187529285578334) :- !.
delta(8, stack(_, Object), 0.06677760967133535) :- unsettled_on(Object), todo_on(Object, Object2), on(Object2, _), !.
delta(8, stack(_, Object), -0.23285958394498402) :- unsettled_on(Object), !.
delta(8, stack(Object, Object2), 0.19453102533746566) :- todo_on(Object, Object2), !.
delta(8, stack(_, _), -0.07448400161296342) :- !.
delta(8, unstack(Object, _), 0.27013086970509054) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(8, unstack(Object, _), 0.051688509304291266) :- todo_on_table(Object), !.
delta(8, unstack(_, _), -0.3097702427609787) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 206 examples, 16 leaves
delta(9, pickup(Object), -0.23310844681858725) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(9, pickup(Object), 0.21325661405010915) :- todo_on(Object, Object2), clear(Object2), !.
delta(9, pickup(_), -0.13177548375959047) :- !.
delta(9, putdown(Object), 0.19101742440134162) :- todo_on(Object, Object2), unsettled_before_on_todo_on(Object2), !.
delta(9, putdown(Object), 0.08156471081418992) :- todo_on_table(Object), !.
delta(9, putdown(_), 0.04609068011405921) :- todo_clear(Object), unsettled_before_on_todo_on_table(Object), !.
delta(9, putdown(_), -0.21769725801650544) :- !.
delta(9, stack(_, Object), -0.23388878452618386) :- on(Object, Object2), unsettled_before_on(Object2), !.
delta(9, stack(Object, _), -0.10585918700934296) :- todo_on(Object, Object2), unsettled_before_on_todo_on(Object2), !.
delta(9, stack(Object, _), -0.04335180412581534) :- todo_on_table(Object), !.
delta(9, stack(_, _), 0.2679387245843129) :- !.
delta(9, unstack(Object, Object2), -0.1400218061264699) :- on(Object3, Object2), unsettled_on(Object3), todo_on(Object, Object4), goal_on_table(Object4), unsettled_before_on(Object4), !.
delta(9, unstack(Object, Object2), 0.05333480052323688) :- on(Object3, Object2), unsettled_on(Object3), todo_on(Object, Object4), goal_on_table(Object4), !.
delta(9, unstack(_, Object), 0.38336263548382454) :- on(Object2, Object), unsettled_on(Object2), !.
delta(9, unstack(_, _), -0.21282548135360782) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 204 examples, 17 leaves
delta(10, pickup(Object), -0.22245416524416287) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(10, pickup(Object), 0.25920346688299484) :- todo_on(Object, Object2), clear(Object2), !.
delta(10, pickup(_), -0.1417941239603294) :- !.
delta(10, putdown(Object), 0.02060169958091634) :- on_table(Object2), done_clear(Object2), todo_on(Object, Object3), clear(Object3), unsettled_before_on_todo_on(Object3), !.
delta(10, putdown(Object), -0.1370687287135669) :- on_table(Object2), done_clear(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(10, putdown(_), 0.057100826257330345) :- on_table(Object), done_clear(Object), !.
delta(10, putdown(_), 0.2819236772551881) :- clear(Object), unsettled_on(Object), !.
delta(10, putdown(_), -0.054649410359816505) :- !.
delta(10, stack(_, Object), -0.25080628061576143) :- on(Object, Object2), unsettled_before_on(Object2), !.
delta(10, stack(Object, _), -0.11597190655742771) :- todo_on(Object, Object2), unsettled_before_on_todo_on(Object2), !.
delta(10, stack(_, Object), -0.08454263041421547) :- todo_on(Object2, Object), on_table(Object2), !.
delta(10, stack(_, _), 0.2203985382141524) :- !.
delta(10, unstack(Object, Object2), -0.26528591347511277) :- on(Object3, Object2), unsettled_on(Object3), todo_on(Object, Object4), beyond_goal_on(Object2, Object4), unsettled_before_on(Object4), !.
delta(10, unstack(Object, Object2), 0.1200253910146166) :- on(Object3, Object2), unsettled_on(Object3), todo_on(Object, Object4), beyond_goal_on(Object2, Object4), !.
delta(10, unstack(_, Object), 0.37044535823981034) :- on(Object2, Object), unsettled_on(Object2), !.
delta(10, unstack(_, _), -0.1817542032781911) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 206 examples, 22 leaves
delta(11, pickup(Object), -0.16980354887748259) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(11, pickup(Object), 0.2806244908208578) :- todo_on(Object, Object2), clear(Object2), !.
delta(11, pickup(_), -0.13621992078125414) :- !.
delta(11, putdown(_), 0.02133765412523683) :- todo_on_table(Object), clear(Object), todo_clear(Object2), on_table(Object2), !.
delta(11, putdown(Object), 0.016325311912130536) :- todo_on_table(Object2), clear(Object2), todo_on(Object, Object3), on_table(Object3), !.
delta(11, putdown(_), -0.14813065808263576) :- todo_on_table(Object), clear(Object), !.
delta(11, putdown(Object), 0.2361324523633608) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(11, putdown(Object), -0.1449037903637088) :- todo_on(Object, Object2), clear(Object2), !.
delta(11, putdown(_), 0.13825001375821516) :- !.
delta(11, stack(_, Object), -0.061585022409290126) :- todo_on_table(Object2), clear(Object2), todo_on(Object3, Object), could_stack_for_todo_on_any_object_2(Object3), !.
delta(11, stack(_, Object), -0.005100831601778808) :- todo_on_table(Object2), clear(Object2), todo_on(Object3, Object2), todo_on(Object, Object3), !.
delta(11, stack(_, _), 0.17558199796102245) :- todo_on_table(Object), clear(Object), !.
delta(11, stack(_, Object), -0.07682326985073738) :- todo_on(Object2, Object), needed_clear_to_stack(Object2), todo_on(Object2, Object3), unsettled_on(Object3), !.
delta(11, stack(_, Object), 0.14778339552925082) :- todo_on(Object2, Object), needed_clear_to_stack(Object2), !.
delta(11, stack(_, _), -0.29358911383596054) :- clear(Object), unsettled_on(Object), !.
delta(11, stack(_, _), 0.027202386824029735) :- !.
delta(11, unstack(Object, Object2), -0.21934346667390853) :- on(Object3, Object2), unsettled_on(Object3), todo_on(Object, Object4), unsettled_on(Object4), could_pickup_for_todo_on_object_any(Object2), !.
delta(11, unstack(Object, Object2), 0.0498495207439644) :- on(Object3, Object2), unsettled_on(Object3), todo_on(Object, Object4), unsettled_on(Object4), !.
delta(11, unstack(Object, Object2), 0.001534810477247388) :- on(Object3, Object2), unsettled_on(Object3), todo_on(Object, Object4), unsettled_before_on(Object4), !.
delta(11, unstack(_, Object), 0.31816461765754833) :- on(Object2, Object), unsettled_on(Object2), !.
delta(11, unstack(_, _), -0.1981211127150985) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 206 examples, 21 leaves
delta(12, pickup(Object), -0.1783688413956955) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(12, pickup(Object), -0.010438740862592636) :- on_table(Object2), beyond_goal_on(Object, Object2), todo_on(Object3, Object2), beyond_goal_on(Object, Object3), !.
delta(12, pickup(Object), 0.22851654114603118) :- on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(12, pickup(_), -0.10328667218385616) :- !.
delta(12, putdown(Object), 0.08257886157758428) :- clear(Object2), unsettled_on(Object2), todo_on(Object, Object3), beyond_goal_on(Object2, Object3), unsettled_before_on(Object3), !.
delta(12, putdown(Object), -0.09658226318765084) :- clear(Object2), unsettled_on(Object2), todo_on(Object, Object3), beyond_goal_on(Object2, Object3), !.
delta(12, putdown(_), 0.2789909784572439) :- clear(Object), unsettled_on(Object), !.
delta(12, putdown(_), 0.016828796262183136) :- todo_clear(Object), todo_on_table(Object), !.
delta(12, putdown(_), -0.042294734331527806) :- !.
delta(12, stack(_, Object), -0.30834475303951303) :- unsettled_on(Object), !.
delta(12, stack(Object, Object2), 0.18177295834823728) :- todo_on(Object, Object2), !.
delta(12, stack(Object, _), 0.053771505894700325) :- todo_on(Object2, Object), todo_on(_, Object2), !.
delta(12, stack(_, _), -0.1595234341980952) :- !.
delta(12, unstack(Object, Object2), 0.03819911897619201) :- todo_on(Object, Object3), unsettled_on(Object3), todo_clear(Object4), could_pickup_for_todo_on_object_any(Object4), todo_on(Object3, Object2), !.
delta(12, unstack(Object, _), -0.41615557153730953) :- todo_on(Object, Object2), unsettled_on(Object2), todo_clear(Object3), could_pickup_for_todo_on_object_any(Object3), !.
delta(12, unstack(Object, Object2), -0.04490047150437708) :- todo_on(Object, Object3), unsettled_on(Object3), todo_on(Object4, Object2), goal_clear(Object4), !.
delta(12, unstack(Object, _), 0.14872317488704204) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(12, unstack(_, Object), 0.41768552251108754) :- on(Object2, Object), unsettled_on(Object2), on_table(Object3), goal_clear(Object3), !.
delta(12, unstack(_, Object), -0.006931882603547939) :- on(Object2, Object), unsettled_on(Object2), !.
delta(12, unstack(_, _), -0.14236998541543672) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 208 examples, 23 leaves
delta(13, pickup(Object), -0.19070022852553636) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(13, pickup(Object), 0.007027583857596116) :- todo_on(Object, Object2), clear(Object2), fewer_clear_on_1_than_on_2, !.
delta(13, pickup(Object), 0.2610723870671571) :- todo_on(Object, Object2), clear(Object2), !.
delta(13, pickup(_), -0.09720277382381785) :- !.
delta(13, putdown(Object), 0.023802644021725803) :- todo_on(Object, Object2), unsettled_before_on(Object2), todo_on(Object3, Object), unsettled_on_todo_clear(Object3), unsettled_before_on_todo_on(Object2), !.
delta(13, putdown(Object), -0.03550990405358285) :- todo_on(Object, Object2), unsettled_before_on(Object2), todo_on(Object3, Object), unsettled_on_todo_clear(Object3), !.
delta(13, putdown(Object), 0.170544197244987) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(13, putdown(_), 0.05163919245123143) :- todo_on_table(_), !.
delta(13, putdown(_), -0.1770305343482657) :- clear(Object), goal_clear(Object), !.
delta(13, putdown(_), 0.018353380184676544) :- !.
delta(13, stack(Object, Object2), 0.08664737475968855) :- todo_on(Object, Object3), unsettled_before_on(Object3), todo_on(Object4, Object2), on(Object3, Object4), todo_on_table(Object3), !.
delta(13, stack(Object, Object2), -0.002556139916346582) :- todo_on(Object, Object3), unsettled_before_on(Object3), todo_on(Object4, Object2), on(Object3, Object4), !.
delta(13, stack(Object, _), -0.2247740213441213) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(13, stack(_, Object), 0.052027655872842145) :- clear(Object2), beyond_goal_on(Object, Object2), on(Object2, Object3), unsettled_on_todo_on(Object3), !.
delta(13, stack(_, Object), -0.11329871399946584) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(13, stack(Object, Object2), 0.2231380551264194) :- todo_on(Object, Object2), !.
delta(13, stack(_, _), -0.07099462273141964) :- !.
delta(13, unstack(_, Object), 0.29370849204067945) :- on(Object2, Object), unsettled_on_todo_on_table(Object2), !.
delta(13, unstack(Object, _), -0.09151249706912885) :- todo_on(Object, Object2), on(Object3, Object2), done_clear(Object3), !.
delta(13, unstack(Object, _), 0.2551538486539857) :- todo_on(Object, Object2), on(_, Object2), !.
delta(13, unstack(Object, _), 0.06752934460573408) :- on(Object, Object2), could_unstack_for_todo_on_object_any(Object2), !.
delta(13, unstack(_, _), -0.36416011127336334) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 202 examples, 25 leaves
delta(14, pickup(Object), -0.15337961035587666) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(14, pickup(Object), -0.033927729542410016) :- on_table(Object2), beyond_goal_on(Object, Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(14, pickup(Object), 0.19257317181257624) :- on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(14, pickup(_), -0.07982232078239435) :- !.
delta(14, putdown(Object), 0.01443095771128787) :- todo_on(Object2, Object), on(Object2, _), goal_clear(Object2), !.
delta(14, putdown(Object), 0.008738967718380522) :- todo_on(Object2, Object), on(Object2, _), todo_on_table(Object), !.
delta(14, putdown(Object), -0.12516265224963702) :- todo_on(Object2, Object), on(Object2, _), !.
delta(14, putdown(Object), -0.0026616648772863627) :- clear(Object2), on_table(Object2), todo_on(Object, Object2), !.
delta(14, putdown(_), 0.15346793106204862) :- clear(Object), on_table(Object), !.
delta(14, putdown(Object), 0.02539234749686535) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(14, putdown(_), -0.057345332014145524) :- !.
delta(14, stack(_, Object), -0.08086623502969152) :- todo_on(Object2, Object), todo_on(_, Object2), unsettled_on_todo_on_table(Object), !.
delta(14, stack(Object, Object2), -0.010808869113757332) :- todo_on(Object3, Object2), todo_on(_, Object3), todo_on_table(Object), !.
delta(14, stack(_, Object), 0.17541319810028222) :- todo_on(Object2, Object), todo_on(_, Object2), !.
delta(14, stack(_, Object), -0.02508652222161256) :- on(Object, Object2), goal_on(Object, Object2), todo_on(Object2, Object3), clear(Object3), !.
delta(14, stack(_, Object), 0.07081716539947205) :- on(Object, Object2), goal_on(Object, Object2), !.
delta(14, stack(_, _), -0.17669685687389175) :- clear(Object), unsettled_on(Object), !.
delta(14, stack(_, _), -0.00010970180782871974) :- !.
delta(14, unstack(_, Object), -0.023766385490081744) :- todo_on(Object2, Object), goal_on(Object3, Object2), could_pickup_needed_holding_to_putdown_to_stack(Object2), could_unstack_for_todo_on_object_any_2(Object3), !.
delta(14, unstack(_, Object), 0.013597517100751064) :- todo_on(Object2, Object), goal_on(_, Object2), could_pickup_needed_holding_to_putdown_to_stack(Object2), !.
delta(14, unstack(_, Object), 0.3105107879198995) :- todo_on(Object2, Object), goal_on(_, Object2), !.
delta(14, unstack(_, Object), 0.13424971497073257) :- todo_on(Object, Object2), goal_on_table(Object2), !.
delta(14, unstack(_, _), -0.3341210301180907) :- on_table(Object), todo_on(_, Object), !.
delta(14, unstack(_, _), 0.0679844933157565) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 204 examples, 26 leaves
delta(15, pickup(Object), -0.0006827419018751746) :- todo_on(Object2, Object), unsettled_on_todo_on_table(Object2), todo_clear(_), !.
delta(15, pickup(Object), 0.02846276251418912) :- todo_on(Object2, Object), unsettled_on_todo_on_table(Object2), !.
delta(15, pickup(Object), 0.041359825019807325) :- todo_on(Object, Object2), done_on_table(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(15, pickup(Object), -0.03433798764951175) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(15, pickup(_), -0.17421383092755952) :- !.
delta(15, putdown(Object), 0.005378468945893723) :- todo_on(Object2, Object), clear(Object2), todo_on(Object, Object3), clear(Object3), unsettled_on_todo_clear(Object3), !.
delta(15, putdown(Object), -0.22912561528433006) :- todo_on(Object2, Object), clear(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(15, putdown(Object), 0.026360692422501584) :- todo_on(Object2, Object), clear(Object2), !.
delta(15, putdown(Object), -0.0023328488762710525) :- clear(Object2), unsettled_on(Object2), todo_on(Object3, Object2), beyond_goal_on(Object3, Object), !.
delta(15, putdown(_), 0.1500598964400756) :- clear(Object), unsettled_on(Object), !.
delta(15, putdown(_), 0.00993546731574968) :- todo_clear(Object), todo_on_table(Object), !.
delta(15, putdown(_), -0.0230654562718482) :- !.
delta(15, stack(Object, Object2), -0.04861843190913697) :- todo_on(Object3, Object), clear(Object3), todo_on(Object4, Object3), beyond_on(Object2, Object4), !.
delta(15, stack(Object, Object2), 0.2690781081019964) :- todo_on(Object3, Object), clear(Object3), todo_on(Object4, Object2), needed_clear_to_stack(Object4), !.
delta(15, stack(Object, _), -0.03414064489714433) :- todo_on(Object2, Object), clear(Object2), !.
delta(15, stack(Object, Object2), 0.06545239707878585) :- todo_on(Object2, Object3), beyond_goal_on(Object3, Object), todo_on(Object4, Object), done_on(Object3, Object4), !.
delta(15, stack(Object, Object2), -0.01493320551305119) :- todo_on(Object2, Object3), beyond_goal_on(Object3, Object), !.
delta(15, stack(_, _), -0.18681614536574842) :- clear(Object), unsettled_on(Object), !.
delta(15, stack(_, _), 0.012967607910348998) :- !.
delta(15, unstack(Object, Object2), 0.02102439203758828) :- on(Object, Object3), unsettled_before_on(Object3), todo_on_table(Object4), beyond_goal_on(Object, Object4), todo_on_table(Object2), !.
delta(15, unstack(Object, _), -0.0896297851125288) :- on(Object, Object2), unsettled_before_on(Object2), todo_on_table(Object3), beyond_goal_on(Object, Object3), !.
delta(15, unstack(Object, Object2), -0.0448318057344655) :- on(Object, Object3), unsettled_before_on(Object3), todo_on(Object2, Object4), could_unstack_needed_clear_to_stack(Object4), !.
delta(15, unstack(Object, _), 0.28823721326384755) :- on(Object, Object2), unsettled_before_on(Object2), !.
delta(15, unstack(Object, _), 0.024694905969141152) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(15, unstack(_, _), -0.117569069486479) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 206 examples, 28 leaves
delta(16, pickup(Object), 0.08084995432947267) :- todo_on(Object, Object2), done_on_table(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(16, pickup(Object), -0.012821773799994994) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(16, pickup(_), -0.09117426867197223) :- on_table(Object), todo_on(_, Object), !.
delta(16, pickup(_), -0.004530168115370142) :- todo_clear(_), !.
delta(16, pickup(_), 0.010807666469242052) :- !.
delta(16, putdown(Object), 0.026179590949139672) :- todo_on(Object2, Object), on(Object2, Object3), unsettled_on(Object3), !.
delta(16, putdown(Object), -0.17216596522538477) :- todo_on(Object2, Object), on(Object2, Object3), goal_on_table(Object3), !.
delta(16, putdown(Object), 0.004116209012851572) :- todo_on(Object2, Object), on(Object2, _), !.
delta(16, putdown(Object), 0.19693194630840943) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(16, putdown(Object), -0.0644041303198788) :- todo_on(Object, Object2), clear(Object2), !.
delta(16, putdown(_), 0.03818455432119736) :- !.
delta(16, stack(Object, Object2), 0.0029213276723802006) :- todo_on(Object3, Object), on(Object3, Object4), unsettled_on(Object4), todo_on(Object, Object2), !.
delta(16, stack(Object, _), -0.029147491405897948) :- todo_on(Object2, Object), on(Object2, Object3), unsettled_on(Object3), !.
delta(16, stack(Object, Object2), -0.007822220881657349) :- todo_on(Object3, Object), on(Object3, Object4), todo_on(Object2, Object4), !.
delta(16, stack(Object, _), 0.17646946695893476) :- todo_on(Object2, Object), on(Object2, _), !.
delta(16, stack(Object, Object2), -0.034284057584869604) :- on_table(Object3), goal_on(Object2, Object3), todo_on(Object3, Object4), beyond_goal_on(Object, Object4), !.
delta(16, stack(_, Object), 0.07688007354621135) :- on_table(Object2), goal_on(Object, Object2), !.
delta(16, stack(Object, _), 0.033752203406604384) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(16, stack(_, _), -0.23711929680874552) :- !.
delta(16, unstack(Object, Object2), 0.015220394193901619) :- todo_on(Object, Object3), clear(Object3), todo_on(Object3, Object4), clear(Object4), todo_on(Object4, Object2), !.
delta(16, unstack(Object, _), -0.1271667937214987) :- todo_on(Object, Object2), clear(Object2), todo_on(Object2, Object3), clear(Object3), !.
delta(16, unstack(Object, Object2), -0.026099195165907137) :- todo_on(Object, Object3), clear(Object3), todo_on(Object4, Object2), on(Object3, Object4), !.
delta(16, unstack(Object, _), 0.47200892367802044) :- todo_on(Object, Object2), clear(Object2), !.
delta(16, unstack(Object, _), -0.017824945287724426) :- todo_on(Object2, Object), on(_, Object2), unsettled_before_on_todo_on(Object), !.
delta(16, unstack(Object, _), 0.08421303684341397) :- todo_on(Object2, Object), on(_, Object2), !.
delta(16, unstack(_, Object), 0.020134531819957054) :- todo_on(Object2, Object), clear(Object2), !.
delta(16, unstack(_, _), -0.3736418226681914) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 232 examples, 24 leaves
delta(17, pickup(Object), 0.052677296837940236) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object2, Object3), could_pickup_for_todo_on_object_any(Object3), goal_clear(Object), !.
delta(17, pickup(Object), -0.03553434355714101) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object2, Object3), could_pickup_for_todo_on_object_any(Object3), !.
delta(17, pickup(Object), -0.1146809635795486) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(17, pickup(Object), 0.07341906543168322) :- todo_on(Object, Object2), clear(Object2), !.
delta(17, pickup(_), -0.05838689189159076) :- !.
delta(17, putdown(Object), 0.07830675377680937) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(17, putdown(Object), 0.03346370240471327) :- todo_on_table(Object), !.
delta(17, putdown(Object), 0.01012168193204147) :- todo_on(Object2, Object), unsettled_before_on_todo_clear(Object2), !.
delta(17, putdown(_), -0.1868979199625371) :- !.
delta(17, stack(_, Object), -0.15978831396818668) :- on(Object, Object2), on(Object2, _), unsettled_on(Object), !.
delta(17, stack(Object, Object2), 0.03339900988305709) :- on(Object2, Object3), on(Object3, _), todo_on(Object, Object2), !.
delta(17, stack(_, Object), -0.002118229321772672) :- on(Object, Object2), on(Object2, _), !.
delta(17, stack(_, Object), -0.049136244359865716) :- goal_clear(Object), !.
delta(17, stack(Object, _), -0.03212075623585758) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(17, stack(_, _), 0.2688148094972686) :- !.
delta(17, unstack(Object, _), 0.019999002874189847) :- clear(Object2), beyond_goal_on(Object2, Object), todo_on(Object3, Object), goal_on(Object2, Object3), could_pickup_needed_holding_to_putdown_to_stack(Object3), !.
delta(17, unstack(Object, _), -0.20808755831636058) :- clear(Object2), beyond_goal_on(Object2, Object), todo_on(Object3, Object), goal_on(Object2, Object3), !.
delta(17, unstack(Object, Object2), -0.06862239377114612) :- clear(Object3), beyond_goal_on(Object3, Object), todo_on(Object3, Object2), !.
delta(17, unstack(Object, _), 0.4597083767548123) :- clear(Object2), beyond_goal_on(Object2, Object), !.
delta(17, unstack(Object, _), 0.02657074423047847) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object2, Object3), done_on_table(Object3), !.
delta(17, unstack(Object, _), -0.2783910487634076) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(17, unstack(_, _), 0.060138208723282675) :- on_table(Object), goal_on_table(Object), !.
delta(17, unstack(_, _), -0.023031798467561322) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 204 examples, 22 leaves
delta(18, pickup(Object), -0.04711935198964629) :- todo_on(Object, Object2), clear(Object2), on(Object2, Object3), unsettled_on(Object3), !.
delta(18, pickup(Object), -0.006177436124698125) :- todo_on(Object, Object2), clear(Object2), todo_on(Object2, Object3), could_unstack_for_todo_on_object_any_2(Object3), !.
delta(18, pickup(Object), 0.1423749645571609) :- todo_on(Object, Object2), clear(Object2), !.
delta(18, pickup(_), -0.16660102558843867) :- !.
delta(18, putdown(Object), -0.25356751551974094) :- todo_on(Object, Object2), goal_on_table(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(18, putdown(Object), 0.01379606761185865) :- todo_on(Object, Object2), goal_on_table(Object2), !.
delta(18, putdown(_), 0.13229346394287872) :- clear(Object), on_table(Object), !.
delta(18, putdown(_), 0.009679999025113434) :- todo_on_table(_), !.
delta(18, putdown(_), -0.04014348057274537) :- !.
delta(18, stack(Object, Object2), 0.2642247935567951) :- todo_on_table(Object3), todo_on(Object, Object3), on_table(Object4), beyond_goal_on(Object2, Object4), !.
delta(18, stack(Object, _), -0.02116216148184809) :- todo_on_table(Object2), todo_on(Object, Object2), !.
delta(18, stack(Object, Object2), -0.04184015033930255) :- todo_on(Object, Object2), fewer_clear_on_1_than_on_2, !.
delta(18, stack(Object, Object2), 0.07388165404171554) :- todo_on(Object, Object2), !.
delta(18, stack(_, _), -0.13920101234097101) :- !.
delta(18, unstack(Object, Object2), -0.010652160231837439) :- todo_on(Object3, Object2), on_table(Object3), todo_on(Object4, Object), done_clear(Object4), !.
delta(18, unstack(Object, Object2), -0.009866993271980968) :- todo_on(Object3, Object2), on_table(Object3), todo_on(Object, Object4), on(Object4, Object3), !.
delta(18, unstack(_, Object), 0.1933546557553965) :- todo_on(Object2, Object), on_table(Object2), !.
delta(18, unstack(_, Object), 0.0177668798355553) :- clear(Object2), could_unstack_needed_clear_to_stack(Object2), todo_on(Object3, Object2), beyond_goal_on(Object3, Object), !.
delta(18, unstack(_, _), -0.166596952192976) :- clear(Object), could_unstack_needed_clear_to_stack(Object), !.
delta(18, unstack(_, Object), 0.07749687037783551) :- on(Object2, Object), unsettled_on(Object2), !.
delta(18, unstack(_, _), -0.04015581962702741) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 236 examples, 26 leaves
delta(19, pickup(Object), -0.0031007100735331475) :- todo_on(Object, Object2), on_table(Object2), todo_on(Object, Object3), clear(Object3), fewer_clear_than_on_2, !.
delta(19, pickup(Object), 0.11013434122720357) :- todo_on(Object, Object2), on_table(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(19, pickup(Object), -0.050528949911049545) :- todo_on(Object, Object2), on_table(Object2), !.
delta(19, pickup(Object), -0.015532483778516843) :- todo_on(Object2, Object), clear(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(19, pickup(Object), 0.03252070659970269) :- todo_on(Object2, Object), clear(Object2), !.
delta(19, pickup(_), -0.10417162341286902) :- !.
delta(19, putdown(Object), 0.0015245876615298264) :- todo_on(Object2, Object), todo_on(_, Object2), fewer_clear_than_on_2, unsettled_on_todo_on_table(Object2), !.
delta(19, putdown(Object), -0.00481931635278321) :- todo_on(Object2, Object), todo_on(_, Object2), fewer_clear_than_on_2, !.
delta(19, putdown(Object), 0.07628553365105926) :- todo_on(Object2, Object), todo_on(_, Object2), !.
delta(19, putdown(Object), 0.018310133219385447) :- clear(Object2), beyond_goal_on(Object, Object2), todo_on(Object3, Object2), clear(Object3), !.
delta(19, putdown(Object), -0.37514872520044096) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(19, putdown(_), 0.026262861063033507) :- !.
delta(19, stack(_, Object), 0.17851207266123204) :- on(Object, Object2), unsettled_on(Object2), todo_on(Object2, Object3), needed_holding_to_putdown_to_stack(Object3), goal_on(Object, Object2), !.
delta(19, stack(_, Object), -0.001432387139678757) :- on(Object, Object2), unsettled_on(Object2), todo_on(Object2, Object3), needed_holding_to_putdown_to_stack(Object3), !.
delta(19, stack(_, Object), -0.3505714212748707) :- on(Object, Object2), unsettled_on(Object2), !.
delta(19, stack(_, Object), -0.15364346336574305) :- todo_on(Object2, Object), clear(Object2), !.
delta(19, stack(_, Object), -0.026603748870534672) :- todo_on(Object2, Object), on(Object2, _), !.
delta(19, stack(_, _), 0.537654035796369) :- !.
delta(19, unstack(Object, Object2), 0.00030234686825796774) :- on(Object3, Object2), unsettled_on_todo_on_table(Object3), todo_on(Object4, Object), could_pickup_needed_holding_to_putdown_to_stack(Object4), todo_on(Object2, Object), !.
delta(19, unstack(Object, Object2), -0.028168407741644353) :- on(Object3, Object2), unsettled_on_todo_on_table(Object3), todo_on(Object4, Object), could_pickup_needed_holding_to_putdown_to_stack(Object4), !.
delta(19, unstack(_, Object), 0.2318890634942118) :- on(Object2, Object), unsettled_on_todo_on_table(Object2), !.
delta(19, unstack(Object, _), -0.2566638422177621) :- todo_on(Object2, Object), on(_, Object2), on_table(Object2), !.
delta(19, unstack(Object, _), 0.010366064452083254) :- todo_on(Object2, Object), on(_, Object2), !.
delta(19, unstack(_, Object), -0.0820988583593071) :- todo_on(Object, Object2), on_table(Object2), !.
delta(19, unstack(_, _), 0.13661454667592654) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 218 examples, 22 leaves
delta(20, pickup(Object), -0.04604051801320391) :- todo_on(Object, Object2), clear(Object2), todo_on_table(Object3), beyond_goal_on(Object, Object3), !.
delta(20, pickup(Object), -0.01590531849571563) :- todo_on(Object, Object2), clear(Object2), todo_on(Object2, Object3), could_unstack(Object3), !.
delta(20, pickup(Object), 0.1876259271169533) :- todo_on(Object, Object2), clear(Object2), !.
delta(20, pickup(_), -0.10885534649045346) :- !.
delta(20, putdown(Object), 0.008890595443019213) :- todo_on(Object, Object2), todo_on(Object2, Object3), unsettled_on(Object3), fewer_clear_on_1_than_on_2, !.
delta(20, putdown(Object), -0.09597275136717995) :- todo_on(Object, Object2), todo_on(Object2, Object3), unsettled_on(Object3), !.
delta(20, putdown(Object), 0.024943579754185017) :- todo_on(Object, Object2), todo_on(Object2, _), !.
delta(20, putdown(_), 0.12275044233868602) :- !.
delta(20, stack(Object, Object2), -0.006655630090683377) :- todo_on(Object3, Object2), on_table(Object3), todo_on(Object, Object4), could_stack_for_todo_on_object_any_2(Object4), clear(Object3), !.
delta(20, stack(Object, Object2), 0.12412033175154857) :- todo_on(Object3, Object2), on_table(Object3), todo_on(Object, Object4), could_stack_for_todo_on_object_any_2(Object4), !.
delta(20, stack(_, Object), -0.03634369980341514) :- todo_on(Object2, Object), on_table(Object2), !.
delta(20, stack(Object, _), -0.14503838569019958) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(20, stack(Object, Object2), 0.060729242344650644) :- todo_on(Object, Object2), !.
delta(20, stack(_, _), -0.058106651753468616) :- !.
delta(20, unstack(Object, Object2), 0.09974504150523919) :- on_table(Object3), beyond_goal_on(Object2, Object3), todo_on(Object, Object4), on(Object4, Object3), goal_on_table(Object3), !.
delta(20, unstack(Object, Object2), -0.0035064944687074554) :- on_table(Object3), beyond_goal_on(Object2, Object3), todo_on(Object, Object4), on(Object4, Object3), !.
delta(20, unstack(Object, Object2), 0.028593613953504557) :- on_table(Object3), beyond_goal_on(Object2, Object3), on(Object, Object4), could_unstack_for_todo_on_object_any(Object4), !.
delta(20, unstack(_, Object), -0.2852913966011581) :- on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(20, unstack(Object, _), -0.03362131834828867) :- on_table(Object2), done_on(Object, Object2), !.
delta(20, unstack(_, Object), -0.004802015156986849) :- todo_on(Object2, Object), needed_on_to_unstack_to_putdown(Object2), !.
delta(20, unstack(_, _), 0.19676097241687848) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 244 examples, 27 leaves
delta(21, pickup(Object), -0.01662961660114602) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object2, Object3), could_pickup_for_todo_on_object_any(Object3), fewer_clear_on_1_than_on_2, !.
delta(21, pickup(Object), 0.026392597022999554) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object2, Object3), could_pickup_for_todo_on_object_any(Object3), !.
delta(21, pickup(Object), -0.0870228836148121) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(21, pickup(Object), 0.08330858665440563) :- todo_on(Object, Object2), clear(Object2), !.
delta(21, pickup(_), -0.04079239677635826) :- !.
delta(21, putdown(Object), 0.036621419889036645) :- todo_on(Object, Object2), unsettled_before_on(Object2), todo_on_table(Object3), could_stack_for_todo_on_any_object_2(Object3), !.
delta(21, putdown(Object), 0.021579098030051595) :- todo_on(Object, Object2), unsettled_before_on(Object2), on(Object3, Object2), unsettled_before_on_todo_on(Object3), !.
delta(21, putdown(Object), -0.2441488428366136) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(21, putdown(Object), 0.08438134804647072) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(21, putdown(Object), 0.021418446042637342) :- todo_on_table(Object), !.
delta(21, putdown(_), -0.02840791234409225) :- !.
delta(21, stack(Object, Object2), -0.008950639646569164) :- todo_on(Object, Object2), todo_on(Object3, Object), goal_on(_, Object3), beyond_on(Object2, Object3), !.
delta(21, stack(Object, Object2), 0.03416504443808885) :- todo_on(Object, Object2), todo_on(Object3, Object), goal_on(_, Object3), !.
delta(21, stack(Object, Object2), -0.24746333112575397) :- todo_on(Object, Object2), clear(Object3), unsettled_on(Object3), !.
delta(21, stack(Object, Object2), 0.0072029520422424035) :- todo_on(Object, Object2), !.
delta(21, stack(Object, _), 0.002692519907943975) :- todo_on(Object2, Object), on(Object3, Object2), todo_on_table(Object3), !.
delta(21, stack(Object, _), -0.0387603938779883) :- todo_on(Object2, Object), on(_, Object2), !.
delta(21, stack(_, _), 0.3734937860177079) :- on_table(Object), todo_on(Object, _), !.
delta(21, stack(_, _), -0.022560021375141813) :- !.
delta(21, unstack(Object, Object2), 0.03328674685599404) :- goal_on(Object, Object2), todo_on(Object2, Object3), on_table(Object3), !.
delta(21, unstack(Object, Object2), 0.004776418917068526) :- goal_on(Object, Object2), todo_on_table(Object3), beyond_goal_on(Object2, Object3), !.
delta(21, unstack(Object, Object2), -0.1625449442732406) :- goal_on(Object, Object2), !.
delta(21, unstack(Object, _), -0.06987277322814853) :- on(Object, Object2), could_pickup_for_todo_on_object_any(Object2), todo_on(Object, Object3), unsettled_before_on(Object3), !.
delta(21, unstack(Object, _), 0.04972463219058777) :- on(Object, Object2), could_pickup_for_todo_on_object_any(Object2), !.
delta(21, unstack(_, Object), -0.00814516486072719) :- todo_clear(Object2), beyond_goal_on(Object2, Object), !.
delta(21, unstack(_, _), 0.18638764737138638) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 210 examples, 25 leaves
delta(22, pickup(Object), 0.004551888517239869) :- todo_on(Object, Object2), clear(Object2), clear(Object3), beyond_goal_on(Object2, Object3), could_unstack_needed_clear_to_stack(Object2), !.
delta(22, pickup(Object), -0.036256935029062416) :- todo_on(Object, Object2), clear(Object2), clear(Object3), beyond_goal_on(Object2, Object3), !.
delta(22, pickup(Object), -0.011232707667566615) :- todo_on(Object, Object2), clear(Object2), on_table(Object3), on(Object2, Object3), !.
delta(22, pickup(Object), 0.09866133367802604) :- todo_on(Object, Object2), clear(Object2), !.
delta(22, pickup(_), -0.05670547386849598) :- !.
delta(22, putdown(Object), 0.040353682376762186) :- clear(Object2), beyond_goal_on(Object, Object2), on(Object2, Object3), beyond_goal_on(Object2, Object3), unsettled_on(Object2), !.
delta(22, putdown(Object), -0.010564401975538668) :- clear(Object2), beyond_goal_on(Object, Object2), on(Object2, Object3), beyond_goal_on(Object2, Object3), !.
delta(22, putdown(Object), 0.01404065800033134) :- clear(Object2), beyond_goal_on(Object, Object2), todo_clear(Object3), unsettled_before_on_todo_on_table(Object3), !.
delta(22, putdown(Object), -0.28663522287129206) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(22, putdown(_), 0.046534325866745455) :- !.
delta(22, stack(Object, Object2), 0.012323923830962322) :- on_table(Object3), goal_on(Object2, Object3), todo_on(Object, Object4), done_on(Object4, Object3), goal_on_table(Object3), !.
delta(22, stack(Object, Object2), -0.004478535307014577) :- on_table(Object3), goal_on(Object2, Object3), todo_on(Object, Object4), done_on(Object4, Object3), !.
delta(22, stack(_, Object), -0.13233069931432517) :- on_table(Object2), goal_on(Object, Object2), !.
delta(22, stack(_, Object), 0.059978363984327966) :- on(Object, Object2), unsettled_on(Object2), todo_on(Object, Object3), could_stack_for_todo_on_object_any_2(Object3), !.
delta(22, stack(_, Object), -0.11640160686318832) :- on(Object, Object2), unsettled_on(Object2), !.
delta(22, stack(Object, _), 0.3792208901295833) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(22, stack(_, _), -0.02699813425594557) :- !.
delta(22, unstack(Object, _), 0.0018136615051580836) :- clear(Object2), beyond_goal_on(Object2, Object), on(Object2, Object3), needed_clear_to_stack(Object3), todo_on_table(Object), !.
delta(22, unstack(Object, _), -0.044794028963448355) :- clear(Object2), beyond_goal_on(Object2, Object), on(Object2, Object3), needed_clear_to_stack(Object3), !.
delta(22, unstack(Object, Object2), 0.20527303406158917) :- clear(Object3), beyond_goal_on(Object3, Object), on(Object4, Object2), unsettled_on(Object4), !.
delta(22, unstack(Object, _), -0.02208230359295866) :- clear(Object2), beyond_goal_on(Object2, Object), !.
delta(22, unstack(_, Object), 0.06162844614644112) :- todo_on(Object2, Object), goal_on(_, Object2), !.
delta(22, unstack(_, _), -0.21980727201596725) :- clear(Object), unsettled_before_on(Object), !.
delta(22, unstack(_, _), 0.012678125710858867) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 210 examples, 29 leaves
delta(23, pickup(Object), 0.04392431298558915) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object3, Object), could_unstack_for_todo_on_object_object_2(Object3), !.
delta(23, pickup(Object), 0.011238245630106879) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object2, Object3), unsettled_before_on_todo_on_table(Object3), !.
delta(23, pickup(Object), -0.1682770236544502) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(23, pickup(Object), -0.02944107557706136) :- goal_on_table(Object), !.
delta(23, pickup(Object), -0.0035773446646860793) :- todo_on(Object, Object2), could_pickup_needed_holding_to_putdown_to_stack(Object2), !.
delta(23, pickup(_), 0.1337496514071084) :- !.
delta(23, putdown(Object), 0.0011615330070517294) :- todo_on(Object, Object2), on_table(Object2), todo_on(Object3, Object), on_table(Object3), unsettled_before_on_todo_on_table(Object2), !.
delta(23, putdown(Object), -0.17266954122251651) :- todo_on(Object, Object2), on_table(Object2), todo_on(Object3, Object), on_table(Object3), !.
delta(23, putdown(Object), 0.02872205595393197) :- todo_on(Object, Object2), on_table(Object2), todo_on(Object, Object3), unsettled_before_on(Object3), !.
delta(23, putdown(Object), -0.0006102124948421703) :- todo_on(Object, Object2), on_table(Object2), !.
delta(23, putdown(Object), 0.16103899081081502) :- clear(Object2), unsettled_on_todo_on(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(23, putdown(_), 0.0008913049856092007) :- clear(Object), unsettled_on_todo_on(Object), !.
delta(23, putdown(Object), -0.04865677880103129) :- todo_on(Object, Object2), goal_on(Object2, _), !.
delta(23, putdown(_), 0.005998812704888885) :- !.
delta(23, stack(Object, Object2), -0.003193130501712744) :- todo_on(Object2, Object3), unsettled_before_on_todo_on(Object3), todo_on(Object4, Object), on_table(Object4), beyond_goal_on(Object3, Object4), !.
delta(23, stack(Object, Object2), 0.20241451180901487) :- todo_on(Object2, Object3), unsettled_before_on_todo_on(Object3), todo_on(Object4, Object), on_table(Object4), !.
delta(23, stack(_, Object), -0.029596262273449834) :- todo_on(Object, Object2), unsettled_before_on_todo_on(Object2), !.
delta(23, stack(_, Object), 0.012384491613486155) :- clear(Object2), unsettled_on_todo_on(Object2), on_table(Object3), done_on(Object, Object3), !.
delta(23, stack(_, _), -0.18677121435540178) :- clear(Object), unsettled_on_todo_on(Object), !.
delta(23, stack(_, Object), -0.007276591798220418) :- todo_clear(Object2), beyond_on(Object, Object2), !.
delta(23, stack(_, _), 0.0497313907704115) :- !.
delta(23, unstack(Object, _), 0.04814388444280959) :- todo_clear(Object2), beyond_on(Object, Object2), todo_on_table(Object3), beyond_on(Object3, Object2), !.
delta(23, unstack(Object, _), 0.006766982552739233) :- todo_clear(Object2), beyond_on(Object, Object2), on(Object2, Object3), beyond_goal_on(Object2, Object3), !.
delta(23, unstack(Object, _), -0.22767785115101288) :- todo_clear(Object2), beyond_on(Object, Object2), !.
delta(23, unstack(Object, Object2), -0.0694734194847556) :- todo_on(Object3, Object2), needed_clear_to_stack(Object3), goal_clear(Object), !.
delta(23, unstack(_, Object), 0.008095706774631645) :- todo_on(Object2, Object), needed_clear_to_stack(Object2), !.
delta(23, unstack(_, Object), 0.26105367612277736) :- on(Object2, Object), unsettled_on(Object2), !.
delta(23, unstack(_, _), -0.028082109811406294) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 248 examples, 29 leaves
delta(24, pickup(Object), -0.004924228097784994) :- todo_on(Object2, Object), clear(Object2), todo_on(Object, Object3), clear(Object3), unsettled_on_todo_clear(Object3), !.
delta(24, pickup(Object), 0.11975490238274403) :- todo_on(Object2, Object), clear(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(24, pickup(Object), -0.014638410090023968) :- todo_on(Object2, Object), clear(Object2), !.
delta(24, pickup(Object), -0.006973202222892262) :- todo_on(Object, Object2), unsettled_on_todo_on_table(Object2), on(Object2, Object3), could_unstack_needed_clear_to_stack(Object3), !.
delta(24, pickup(Object), 0.009353271287815287) :- todo_on(Object, Object2), unsettled_on_todo_on_table(Object2), !.
delta(24, pickup(_), -0.03796475183174044) :- on_table(Object), todo_on(_, Object), !.
delta(24, pickup(_), 0.00046984162118260235) :- !.
delta(24, putdown(Object), 0.0414333382329131) :- todo_on(Object2, Object), goal_clear(Object2), fewer_clear_on_1_than_on_2, todo_on(Object, Object3), unsettled_on(Object3), !.
delta(24, putdown(Object), -0.0006425468621103148) :- todo_on(Object2, Object), goal_clear(Object2), fewer_clear_on_1_than_on_2, !.
delta(24, putdown(Object), 0.006320494652042929) :- todo_on(Object2, Object), goal_clear(Object2), on(Object2, Object3), goal_on_table(Object3), !.
delta(24, putdown(Object), -0.1354579564966797) :- todo_on(Object2, Object), goal_clear(Object2), !.
delta(24, putdown(Object), -0.002070572792127598) :- todo_on(Object2, Object), unsettled_before_on_todo_clear(Object2), !.
delta(24, putdown(_), 0.14789206216614212) :- !.
delta(24, stack(Object, _), -0.0414333382329131) :- todo_on(Object2, Object), goal_clear(Object2), fewer_clear_on_1_than_on_2, todo_on(Object, Object3), unsettled_on(Object3), !.
delta(24, stack(Object, _), 0.0006392330904147549) :- todo_on(Object2, Object), goal_clear(Object2), fewer_clear_on_1_than_on_2, !.
delta(24, stack(Object, Object2), -0.008473457833616716) :- todo_on(Object3, Object), goal_clear(Object3), todo_on(Object2, Object4), clear(Object4), !.
delta(24, stack(Object, _), 0.13713388429126083) :- todo_on(Object2, Object), goal_clear(Object2), !.
delta(24, stack(Object, Object2), 0.05839991331123637) :- todo_on(Object3, Object), on(Object2, Object3), todo_on(Object, Object4), done_on_table(Object4), !.
delta(24, stack(Object, Object2), -0.0032190729991884836) :- todo_on(Object3, Object), on(Object2, Object3), !.
delta(24, stack(_, Object), 0.03334032272378677) :- todo_on(Object2, Object), unsettled_before_on_todo_on_table(Object2), !.
delta(24, stack(_, _), -0.20411033509450288) :- !.
delta(24, unstack(Object, Object2), -0.014477547959971249) :- on(Object3, Object2), unsettled_on_todo_on_table(Object3), todo_on(Object4, Object), could_pickup_needed_holding_to_putdown_to_stack(Object4), fewer_clear_than_on_2, !.
delta(24, unstack(Object, Object2), 0.0013233158367580175) :- on(Object3, Object2), unsettled_on_todo_on_table(Object3), todo_on(Object4, Object), could_pickup_needed_holding_to_putdown_to_stack(Object4), !.
delta(24, unstack(_, Object), 0.11831022259266574) :- on(Object2, Object), unsettled_on_todo_on_table(Object2), !.
delta(24, unstack(_, Object), -0.017121921385290135) :- todo_on(Object2, Object), clear(Object2), on_table(Object3), done_clear(Object3), !.
delta(24, unstack(_, Object), 0.09282141544008388) :- todo_on(Object2, Object), clear(Object2), !.
delta(24, unstack(Object, Object2), 0.053241985415071406) :- todo_on(Object3, Object), beyond_goal_on(Object2, Object3), !.
delta(24, unstack(_, _), -0.26116398606440633) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 222 examples, 26 leaves
delta(25, pickup(Object), -0.007136172047369078) :- todo_on(Object2, Object), could_pickup_for_todo_on_any_object(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(25, pickup(Object), 0.016249419558772887) :- todo_on(Object2, Object), could_pickup_for_todo_on_any_object(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(25, pickup(Object), -0.0014312194602752878) :- todo_on(Object2, Object), could_pickup_for_todo_on_any_object(Object2), !.
delta(25, pickup(_), -0.07671715451600998) :- clear(Object), on(Object, _), unsettled_on(Object), !.
delta(25, pickup(_), 0.0015347114603567694) :- clear(Object), on(Object, _), !.
delta(25, pickup(Object), 0.000452982064724315) :- todo_on(Object, Object2), goal_on_table(Object2), !.
delta(25, pickup(_), -0.00038466296275398886) :- !.
delta(25, putdown(Object), 0.01607928921828481) :- todo_clear(Object2), on_table(Object2), todo_on(Object3, Object), unsettled_on_todo_clear(Object3), !.
delta(25, putdown(_), 0.006680596966078896) :- todo_clear(Object), on_table(Object), todo_on_table(Object2), needed_clear_to_stack(Object2), !.
delta(25, putdown(_), -0.12891662312076282) :- todo_clear(Object), on_table(Object), !.
delta(25, putdown(_), 0.0752045737633713) :- !.
delta(25, stack(Object, Object2), 0.00989420146010734) :- goal_on_table(Object2), on_table(Object3), done_clear(Object3), todo_on(Object, Object2), !.
delta(25, stack(_, Object), -0.032316948044797796) :- goal_on_table(Object), on_table(Object2), done_clear(Object2), !.
delta(25, stack(Object, Object2), -0.005028503003532593) :- goal_on_table(Object2), todo_on(Object3, Object), goal_clear(Object3), !.
delta(25, stack(_, Object), 0.20338080222643581) :- goal_on_table(Object), !.
delta(25, stack(_, Object), -0.14688305557758438) :- unsettled_on(Object), !.
delta(25, stack(Object, Object2), 0.03160195486133227) :- todo_on(Object, Object2), !.
delta(25, stack(_, _), -0.023117505638117226) :- !.
delta(25, unstack(Object, _), 0.06755530916527187) :- todo_on(Object2, Object), could_unstack_for_todo_on_object_any_2(Object2), todo_on(Object2, Object3), unsettled_on_todo_on_table(Object3), !.
delta(25, unstack(Object, Object2), -0.19994122180909563) :- todo_on(Object3, Object), could_unstack_for_todo_on_object_any_2(Object3), todo_clear(Object4), beyond_goal_on(Object4, Object2), !.
delta(25, unstack(Object, _), 0.003099402845245103) :- todo_on(Object2, Object), could_unstack_for_todo_on_object_any_2(Object2), !.
delta(25, unstack(Object, _), 0.0188727981621213) :- todo_on_table(Object2), beyond_goal_on(Object, Object2), todo_on_table(Object3), beyond_on(Object, Object3), !.
delta(25, unstack(Object, _), -0.10461077087323033) :- todo_on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(25, unstack(Object, _), 0.2756249962197586) :- on(Object, Object2), unsettled_on(Object2), !.
delta(25, unstack(_, _), -0.023551712432919102) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 204 examples, 23 leaves
delta(26, pickup(Object), 0.020790925060570387) :- todo_on(Object, Object2), done_on_table(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(26, pickup(Object), -0.003615930028099939) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(26, pickup(_), -0.0496011296630527) :- !.
delta(26, putdown(_), 0.054832268399182996) :- todo_clear(_), !.
delta(26, putdown(Object), 0.008469209858226938) :- todo_on(Object, Object2), clear(Object2), todo_on(Object2, Object3), clear(Object3), !.
delta(26, putdown(Object), -0.0882774961285234) :- todo_on(Object, Object2), clear(Object2), !.
delta(26, putdown(_), 0.010419673690185876) :- !.
delta(26, stack(_, Object), -0.11839992826295455) :- on(Object, Object2), goal_on(_, Object2), unsettled_on(Object), !.
delta(26, stack(Object, Object2), 0.028189771787323056) :- on(Object2, Object3), goal_on(_, Object3), beyond_goal_on(Object, Object2), !.
delta(26, stack(_, Object), -0.011028267407886691) :- on(Object, Object2), goal_on(_, Object2), !.
delta(26, stack(Object, Object2), -0.031659977711217896) :- todo_on(Object2, Object3), unsettled_before_on_todo_on(Object3), todo_on(Object4, Object), beyond_goal_on(Object2, Object4), !.
delta(26, stack(_, Object), 0.19076794264687433) :- todo_on(Object, Object2), unsettled_before_on_todo_on(Object2), !.
delta(26, stack(_, Object), -0.10747284616718748) :- on_table(Object2), beyond_goal_on(Object2, Object), !.
delta(26, stack(_, _), 0.06407972771913423) :- !.
delta(26, unstack(_, Object), -0.0008738786061095804) :- todo_on(Object, Object2), could_unstack_for_todo_on_object_any(Object2), on(Object2, Object3), unsettled_before_on_todo_clear(Object3), fewer_clear_than_on_2, !.
delta(26, unstack(_, Object), 0.003972668361718486) :- todo_on(Object, Object2), could_unstack_for_todo_on_object_any(Object2), on(Object2, Object3), unsettled_before_on_todo_clear(Object3), !.
delta(26, unstack(_, Object), 0.0016833138624954874) :- todo_on(Object, Object2), could_unstack_for_todo_on_object_any(Object2), on(Object2, Object3), could_unstack_needed_clear_to_stack(Object3), !.
delta(26, unstack(_, Object), -0.07575937444578609) :- todo_on(Object, Object2), could_unstack_for_todo_on_object_any(Object2), !.
delta(26, unstack(Object, _), -0.03396643191943296) :- goal_clear(Object), todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(26, unstack(Object, _), 0.01216707998410267) :- goal_clear(Object), !.
delta(26, unstack(Object, _), 0.12845934709018303) :- on(Object, Object2), unsettled_before_on(Object2), !.
delta(26, unstack(_, _), -0.014176786633180866) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 246 examples, 27 leaves
delta(27, pickup(Object), 0.06639754970377655) :- todo_on_table(Object2), could_unstack_todo_clear(Object2), todo_on(Object3, Object), could_pickup_for_todo_on_any_object(Object3), !.
delta(27, pickup(_), -0.0030375087645028013) :- todo_on_table(Object), could_unstack_todo_clear(Object), !.
delta(27, pickup(Object), 0.005627525157976558) :- todo_on(Object2, Object), unsettled_on_todo_on_table(Object2), !.
delta(27, pickup(_), -0.06649839713707838) :- clear(Object), on(Object, _), !.
delta(27, pickup(_), -5.882144192868888e-21) :- !.
delta(27, putdown(Object), -0.0002195508523862897) :- clear(Object2), beyond_goal_on(Object2, Object), todo_on(Object3, Object2), needed_clear_to_stack(Object3), unsettled_on_todo_clear(Object2), !.
delta(27, putdown(Object), 0.015228086776805165) :- clear(Object2), beyond_goal_on(Object2, Object), todo_on(Object3, Object2), needed_clear_to_stack(Object3), !.
delta(27, putdown(Object), -0.2900833872479334) :- clear(Object2), beyond_goal_on(Object2, Object), clear(Object3), beyond_goal_on(Object, Object3), !.
delta(27, putdown(Object), 0.006826257198375667) :- clear(Object2), beyond_goal_on(Object2, Object), !.
delta(27, putdown(Object), 0.0328526658704671) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(27, putdown(_), 0.004228930861987252) :- todo_on_table(_), !.
delta(27, putdown(_), -0.00814400815588488) :- !.
delta(27, stack(Object, Object2), -0.1897690669277306) :- on(Object2, Object3), beyond_goal_on(Object, Object3), on_table(Object4), goal_clear(Object4), unsettled_on(Object2), !.
delta(27, stack(Object, Object2), -0.0016660176272882338) :- on(Object2, Object3), beyond_goal_on(Object, Object3), on_table(Object4), goal_clear(Object4), !.
delta(27, stack(Object, Object2), 0.054013152287427035) :- on(Object2, Object3), beyond_goal_on(Object, Object3), todo_on(Object, Object4), done_on(Object4, Object3), !.
delta(27, stack(Object, Object2), -0.0036765391260406726) :- on(Object2, Object3), beyond_goal_on(Object, Object3), !.
delta(27, stack(_, Object), -0.051006829796286776) :- todo_on(Object, Object2), goal_on_table(Object2), !.
delta(27, stack(_, Object), -0.042540127700215175) :- todo_on(Object2, Object), unsettled_before_on_todo_clear(Object2), !.
delta(27, stack(_, _), 0.4269622762518206) :- !.
delta(27, unstack(Object, Object2), 0.00036732503880854703) :- clear(Object3), beyond_goal_on(Object, Object3), todo_on_table(Object4), beyond_goal_on(Object3, Object4), todo_on_table(Object2), !.
delta(27, unstack(Object, _), -0.060015066057054506) :- clear(Object2), beyond_goal_on(Object, Object2), todo_on_table(Object3), beyond_goal_on(Object2, Object3), !.
delta(27, unstack(Object, _), -0.04109555975037176) :- clear(Object2), beyond_goal_on(Object, Object2), on_table(Object3), done_on(Object, Object3), !.
delta(27, unstack(Object, _), 0.29272999697608804) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(27, unstack(Object, _), 0.06651086924967813) :- on(Object, Object2), could_unstack_needed_clear_to_stack(Object2), !.
delta(27, unstack(_, Object), 0.006769467160494986) :- todo_on(Object, Object2), goal_on_table(Object2), !.
delta(27, unstack(_, _), -0.2786144420351279) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 234 examples, 29 leaves
delta(28, pickup(Object), -0.002271137566554072) :- clear(Object2), beyond_goal_on(Object, Object2), todo_on(Object3, Object), could_unstack(Object3), unsettled_on_todo_clear(Object2), !.
delta(28, pickup(Object), 0.03992700730074823) :- clear(Object2), beyond_goal_on(Object, Object2), todo_on(Object3, Object), could_unstack(Object3), !.
delta(28, pickup(Object), 0.026790507279244917) :- clear(Object2), beyond_goal_on(Object, Object2), todo_on(Object3, Object), done_clear(Object3), !.
delta(28, pickup(Object), -0.1690281724004333) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(28, pickup(Object), 0.09576407032758806) :- clear(Object2), could_unstack_needed_clear_to_stack(Object2), todo_on(Object3, Object), on_table(Object3), !.
delta(28, pickup(_), -0.003752826602702114) :- clear(Object), could_unstack_needed_clear_to_stack(Object), !.
delta(28, pickup(_), -0.019118377326039045) :- !.
delta(28, putdown(Object), -0.01925293459767751) :- on_table(Object2), beyond_goal_on(Object, Object2), todo_on(Object3, Object), done_clear(Object3), fewer_clear_on_1_than_on_2, !.
delta(28, putdown(Object), 0.012207375553963907) :- on_table(Object2), beyond_goal_on(Object, Object2), todo_on(Object3, Object), done_clear(Object3), !.
delta(28, putdown(Object), 0.08739441398218456) :- on_table(Object2), beyond_goal_on(Object, Object2), on_table(Object3), unsettled_on(Object3), !.
delta(28, putdown(Object), -0.001485625730061425) :- on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(28, putdown(_), 0.013504961034003839) :- on_table(Object), needed_clear_to_stack(Object), !.
delta(28, putdown(_), -0.20035474766460842) :- clear(Object), on(Object, _), !.
delta(28, putdown(_), 0.007856508017091871) :- !.
delta(28, stack(Object, Object2), -0.0016787628921988912) :- holding(Object3), beyond_goal_on(Object3, Object2), on(Object2, Object4), beyond_goal_on(Object4, Object), todo_on(Object4, Object), !.
delta(28, stack(Object, Object2), 0.04628401933459112) :- holding(Object3), beyond_goal_on(Object3, Object2), on(Object2, Object4), beyond_goal_on(Object4, Object), !.
delta(28, stack(Object, Object2), -0.1769276669740357) :- holding(Object3), beyond_goal_on(Object3, Object2), todo_on(Object, Object4), unsettled_on(Object4), !.
delta(28, stack(_, Object), 0.03257160924887629) :- holding(Object2), beyond_goal_on(Object2, Object), !.
delta(28, stack(_, _), -0.025783111456170706) :- on_table(Object), needed_clear_to_stack(Object), !.
delta(28, stack(_, Object), -0.013345560162426712) :- todo_on(Object2, Object), on(Object2, _), !.
delta(28, stack(_, _), 0.241660387818631) :- !.
delta(28, unstack(Object, Object2), 0.007579955296692077) :- todo_on(Object, Object3), unsettled_on(Object3), todo_on(Object4, Object2), todo_on(Object3, Object4), !.
delta(28, unstack(Object, _), 0.0021710764513177172) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object3, Object2), beyond_on(Object3, Object2), !.
delta(28, unstack(Object, _), -0.10696916310004728) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(28, unstack(Object, Object2), -0.04176210675294715) :- todo_clear(Object3), todo_on(Object3, Object), todo_on(Object2, Object4), beyond_goal_on(Object, Object4), !.
delta(28, unstack(Object, _), 0.004376507010148239) :- todo_clear(Object2), todo_on(Object2, Object), !.
delta(28, unstack(_, Object), -0.009433661996931315) :- done_on_table(Object), !.
delta(28, unstack(_, _), 0.16906730281449384) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 218 examples, 25 leaves
delta(29, pickup(Object), -0.004843370612536688) :- todo_on(Object2, Object), todo_on(Object3, Object2), unsettled_before_on_todo_clear(Object3), !.
delta(29, pickup(Object), -0.0015004032959470036) :- todo_on(Object2, Object), todo_on(_, Object2), goal_on_table(Object), !.
delta(29, pickup(Object), 0.026586528221690865) :- todo_on(Object2, Object), todo_on(_, Object2), !.
delta(29, pickup(Object), 0.004172063338347919) :- todo_on_table(Object2), done_clear(Object2), todo_on(Object3, Object), on_table(Object3), !.
delta(29, pickup(_), -0.0006262513126720123) :- todo_on_table(Object), done_clear(Object), !.
delta(29, pickup(_), -0.06631603625545972) :- !.
delta(29, putdown(Object), -0.0027644386570512577) :- clear(Object2), beyond_goal_on(Object, Object2), done_on_table(Object2), todo_on(Object, Object2), !.
delta(29, putdown(Object), 0.03411135361585722) :- clear(Object2), beyond_goal_on(Object, Object2), done_on_table(Object2), !.
delta(29, putdown(Object), 0.009543891117246208) :- clear(Object2), beyond_goal_on(Object, Object2), on_table(Object3), done_on(Object2, Object3), !.
delta(29, putdown(Object), -0.26432763158071243) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(29, putdown(_), 0.02282722989064599) :- !.
delta(29, stack(_, Object), -0.12972864700442271) :- todo_on(Object2, Object), on(Object2, _), !.
delta(29, stack(_, Object), -0.1383110995485788) :- todo_on(Object2, Object), clear(Object2), todo_clear(_), !.
delta(29, stack(_, Object), 0.019463247779375834) :- todo_on(Object2, Object), clear(Object2), !.
delta(29, stack(_, _), -0.008255717791062458) :- clear(Object), done_on_table(Object), !.
delta(29, stack(_, _), 0.4083152482566974) :- !.
delta(29, unstack(Object, _), 0.0031405282791815334) :- todo_on(Object, Object2), on(Object2, Object3), unsettled_before_on(Object3), unsettled_before_on_todo_clear(Object2), !.
delta(29, unstack(Object, _), -0.1614259152688152) :- todo_on(Object, Object2), on(Object2, Object3), unsettled_before_on(Object3), !.
delta(29, unstack(Object, Object2), -0.0013016750140853767) :- todo_on(Object, Object3), on(Object3, _), todo_on(Object2, Object), !.
delta(29, unstack(Object, _), 0.00445690469001975) :- todo_on(Object, Object2), on(Object2, _), !.
delta(29, unstack(Object, Object2), 0.046365846452819645) :- todo_on(Object2, Object3), beyond_goal_on(Object, Object3), on(Object3, Object4), could_unstack(Object4), !.
delta(29, unstack(Object, Object2), -0.08469720870829707) :- todo_on(Object2, Object3), beyond_goal_on(Object, Object3), !.
delta(29, unstack(_, Object), -0.011197329211463516) :- todo_on(Object2, Object), done_clear(Object2), !.
delta(29, unstack(_, _), 0.2281739810778892) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 208 examples, 24 leaves
delta(30, pickup(Object), -0.006527675152530129) :- todo_on(Object, Object2), clear(Object2), todo_on(Object2, Object3), clear(Object3), !.
delta(30, pickup(Object), -0.0031694320062529485) :- todo_on(Object, Object2), clear(Object2), todo_on_table(Object3), beyond_goal_on(Object, Object3), !.
delta(30, pickup(Object), 0.09394165541742956) :- todo_on(Object, Object2), clear(Object2), !.
delta(30, pickup(_), -0.02564268503088039) :- !.
delta(30, putdown(Object), 0.010477516971719907) :- todo_on(Object, Object2), on_table(Object2), todo_clear(Object3), beyond_goal_on(Object3, Object2), unsettled_before_on(Object2), !.
delta(30, putdown(Object), -0.0009738664666829053) :- todo_on(Object, Object2), on_table(Object2), todo_clear(Object3), beyond_goal_on(Object3, Object2), !.
delta(30, putdown(Object), 0.0045535059604826095) :- todo_on(Object, Object2), on_table(Object2), todo_on(Object2, Object3), goal_on_table(Object3), !.
delta(30, putdown(Object), -0.14583558508553254) :- todo_on(Object, Object2), on_table(Object2), !.
delta(30, putdown(_), 0.10358005395005898) :- !.
delta(30, stack(Object, Object2), -0.0019804274594493174) :- on_table(Object3), goal_on(Object2, Object3), todo_on(Object, Object4), on_table(Object4), todo_clear(Object), !.
delta(30, stack(Object, Object2), 0.2335183569272114) :- on_table(Object3), goal_on(Object2, Object3), todo_on(Object, Object4), on_table(Object4), !.
delta(30, stack(_, Object), -0.063517083948122) :- on_table(Object2), goal_on(Object, Object2), clear(Object3), unsettled_on(Object3), !.
delta(30, stack(_, Object), 0.0006563061003259977) :- on_table(Object2), goal_on(Object, Object2), !.
delta(30, stack(_, Object), 0.053078689742455026) :- todo_on(Object, Object2), on(_, Object2), !.
delta(30, stack(_, Object), -0.00044295864840056357) :- todo_on(Object2, Object), needed_on_to_unstack(Object2), !.
delta(30, stack(_, _), -0.18862875511205626) :- !.
delta(30, unstack(Object, Object2), -0.0026180940896256256) :- todo_on(Object3, Object), on(Object3, _), unsettled_on(Object), could_unstack_todo_clear(Object2), !.
delta(30, unstack(Object, _), 0.08577885709567641) :- todo_on(Object2, Object), on(Object2, _), unsettled_on(Object), !.
delta(30, unstack(Object, _), -0.0034135951141215574) :- todo_on(Object2, Object), on(Object2, _), !.
delta(30, unstack(Object, Object2), -0.003672277009901608) :- todo_on(Object, Object3), done_on_table(Object3), todo_on(Object4, Object2), on(Object4, Object3), !.
delta(30, unstack(Object, _), 0.03067825147928497) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(30, unstack(_, Object), 0.017809802081024353) :- on(Object2, Object), unsettled_on_todo_on_table(Object2), !.
delta(30, unstack(_, _), -0.17263147510486848) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 272 examples, 29 leaves
delta(31, pickup(Object), -0.0022661793904861505) :- fewer_clear_on_1_than_on_2, todo_on(Object2, Object), could_pickup_for_todo_on_any_object(Object2), todo_on(Object, Object3), could_pickup_for_todo_on_object_any(Object3), !.
delta(31, pickup(Object), 0.016597877448665307) :- fewer_clear_on_1_than_on_2, todo_on(Object2, Object), could_pickup_for_todo_on_any_object(Object2), !.
delta(31, pickup(_), 0.003720540208163113) :- fewer_clear_on_1_than_on_2, fewer_clear_than_on_2, !.
delta(31, pickup(_), -0.06892709230809532) :- fewer_clear_on_1_than_on_2, !.
delta(31, pickup(Object), -0.01509358437095386) :- todo_on(Object2, Object), goal_clear(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(31, pickup(Object), 0.0006610272651264368) :- todo_on(Object2, Object), goal_clear(Object2), !.
delta(31, pickup(Object), 0.08582750567548722) :- todo_on(Object, Object2), clear(Object2), !.
delta(31, pickup(_), -0.0020537287176128796) :- !.
delta(31, putdown(Object), -0.056421096909393745) :- todo_on(Object2, Object), done_clear(Object2), todo_on(Object, Object3), on_table(Object3), fewer_clear_on_1_than_on_2, !.
delta(31, putdown(Object), 0.012952255070327875) :- todo_on(Object2, Object), done_clear(Object2), todo_on(Object, Object3), on_table(Object3), !.
delta(31, putdown(Object), 0.03095724448488135) :- todo_on(Object2, Object), done_clear(Object2), !.
delta(31, putdown(_), 0.0011073823498900244) :- todo_clear(Object), done_on_table(Object), clear(Object2), on(Object2, Object), !.
delta(31, putdown(_), -0.005521322698606349) :- todo_clear(Object), done_on_table(Object), !.
delta(31, putdown(_), 0.08146577576458613) :- !.
delta(31, stack(Object, Object2), -0.005539815950370573) :- todo_on(Object2, Object3), beyond_goal_on(Object, Object3), on(Object4, Object3), could_stack_for_todo_on_object_any_2(Object4), todo_on(Object4, Object), !.
delta(31, stack(Object, Object2), 0.0928187050102874) :- todo_on(Object2, Object3), beyond_goal_on(Object, Object3), on(Object4, Object3), could_stack_for_todo_on_object_any_2(Object4), !.
delta(31, stack(Object, Object2), -0.034896709854257545) :- todo_on(Object2, Object3), beyond_goal_on(Object, Object3), !.
delta(31, stack(Object, Object2), 0.030838659389858525) :- todo_on(Object2, Object), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(31, stack(Object, Object2), -0.007451929658456703) :- todo_on(Object2, Object), !.
delta(31, stack(Object, _), -0.1349705334379826) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(31, stack(_, _), 0.0011618412599359482) :- !.
delta(31, unstack(Object, Object2), 0.013104801766631294) :- on(Object, Object3), could_pickup_needed_holding_to_putdown_to_stack(Object3), todo_on(Object4, Object2), could_unstack_for_todo_on_any_object(Object4), !.
delta(31, unstack(Object, _), 0.0045553364650617115) :- on(Object, Object2), could_pickup_needed_holding_to_putdown_to_stack(Object2), todo_on(Object3, Object), goal_clear(Object3), !.
delta(31, unstack(Object, _), -0.20325770682878685) :- on(Object, Object2), could_pickup_needed_holding_to_putdown_to_stack(Object2), !.
delta(31, unstack(Object, _), -0.012407373792743202) :- clear(Object2), beyond_goal_on(Object2, Object), todo_on(Object3, Object2), needed_on_to_unstack_to_putdown(Object3), !.
delta(31, unstack(Object, _), 0.22749635469623505) :- clear(Object2), beyond_goal_on(Object2, Object), !.
delta(31, unstack(_, Object), 0.009151939388356754) :- todo_on(Object2, Object), clear(Object2), !.
delta(31, unstack(_, _), -0.07674631394020065) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 274 examples, 28 leaves
delta(32, pickup(Object), -0.0017820728314622979) :- todo_on(Object2, Object), on(Object2, _), goal_on_table(Object), !.
delta(32, pickup(Object), -0.0006833266506722063) :- todo_on(Object2, Object), on(Object2, Object3), todo_on(Object, Object3), !.
delta(32, pickup(Object), 0.10897887227769953) :- todo_on(Object2, Object), on(Object2, _), !.
delta(32, pickup(Object), 0.05409379331425463) :- todo_on(Object, Object2), could_pickup_for_todo_on_object_any(Object2), todo_on(Object2, Object3), could_unstack_for_todo_on_object_any_2(Object3), !.
delta(32, pickup(Object), -0.019965467602245397) :- todo_on(Object, Object2), could_pickup_for_todo_on_object_any(Object2), !.
delta(32, pickup(_), 0.005471381983676529) :- clear(Object), could_unstack_for_todo_on_object_object_2(Object), !.
delta(32, pickup(_), -0.12327986003716898) :- !.
delta(32, putdown(Object), -0.015365601878716984) :- on_table(Object2), beyond_goal_on(Object, Object2), todo_on(Object2, Object3), done_on_table(Object3), fewer_clear_on_1_than_on_2, !.
delta(32, putdown(Object), 0.040850306025431) :- on_table(Object2), beyond_goal_on(Object, Object2), todo_on(Object2, Object3), done_on_table(Object3), !.
delta(32, putdown(Object), -0.5189969463077999) :- on_table(Object2), beyond_goal_on(Object, Object2), clear(Object3), on_table(Object3), !.
delta(32, putdown(Object), 0.011544218831071847) :- on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(32, putdown(_), 0.024374717834436007) :- !.
delta(32, stack(_, Object), -0.0009348336422729816) :- on_table(Object2), done_on(Object, Object2), todo_on(Object2, Object3), clear(Object3), fewer_clear_than_on_2, !.
delta(32, stack(_, Object), 0.058864851626040014) :- on_table(Object2), done_on(Object, Object2), todo_on(Object2, Object3), clear(Object3), !.
delta(32, stack(Object, Object2), -0.12745339302949993) :- on_table(Object3), done_on(Object2, Object3), todo_on(Object, Object4), unsettled_on(Object4), !.
delta(32, stack(_, Object), 0.0047807088652259385) :- on_table(Object2), done_on(Object, Object2), !.
delta(32, stack(_, Object), 0.059492405991092574) :- todo_on(Object, Object2), on(Object2, _), unsettled_before_on_todo_clear(Object2), !.
delta(32, stack(_, Object), -0.13320556515103998) :- todo_on(Object, Object2), on(Object2, _), !.
delta(32, stack(Object, Object2), -0.04597706944145926) :- todo_on(Object, Object3), beyond_on(Object2, Object3), !.
delta(32, stack(_, _), 0.5318351469128555) :- !.
delta(32, unstack(Object, _), -0.03756043748946644) :- on(Object, Object2), could_pickup_for_todo_on_object_any(Object2), todo_on_table(Object3), beyond_goal_on(Object, Object3), !.
delta(32, unstack(Object, _), -0.030337707357930618) :- on(Object, Object2), could_pickup_for_todo_on_object_any(Object2), todo_on(Object, Object3), on_table(Object3), !.
delta(32, unstack(Object, _), 0.2143390446309705) :- on(Object, Object2), could_pickup_for_todo_on_object_any(Object2), !.
delta(32, unstack(Object, _), 0.04657152149019849) :- clear(Object2), beyond_goal_on(Object, Object2), todo_on(Object, Object3), goal_on_table(Object3), !.
delta(32, unstack(Object, _), -0.2608033346650058) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(32, unstack(_, Object), 0.08902395385419104) :- on(Object2, Object), unsettled_on(Object2), !.
delta(32, unstack(_, _), -0.029311370875883053) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 220 examples, 31 leaves
delta(33, pickup(Object), -0.0005335001638710599) :- on_table(Object2), done_clear(Object2), todo_on(Object, Object3), unsettled_before_on_todo_on_table(Object3), goal_clear(Object), !.
delta(33, pickup(Object), 0.05430202910876951) :- on_table(Object2), done_clear(Object2), todo_on(Object, Object3), unsettled_before_on_todo_on_table(Object3), !.
delta(33, pickup(Object), 0.0011356852243715222) :- on_table(Object2), done_clear(Object2), todo_on(Object3, Object), could_pickup_for_todo_on_any_object(Object3), !.
delta(33, pickup(_), -0.10622412219996097) :- on_table(Object), done_clear(Object), !.
delta(33, pickup(_), -0.0014233941318334184) :- clear(Object), could_unstack_for_todo_on_any_object(Object), on_table(Object2), done_on(Object, Object2), !.
delta(33, pickup(_), 0.08204348451322815) :- clear(Object), could_unstack_for_todo_on_any_object(Object), !.
delta(33, pickup(_), -0.0029072138256163844) :- !.
delta(33, putdown(_), 0.02175912559628849) :- clear(Object), goal_on_table(Object), todo_on_table(Object2), could_stack_for_todo_on_any_object_2(Object2), !.
delta(33, putdown(_), -0.20357517946531525) :- clear(Object), goal_on_table(Object), on_table(Object2), goal_clear(Object2), !.
delta(33, putdown(_), 0.018535173977242227) :- clear(Object), goal_on_table(Object), !.
delta(33, putdown(_), -0.03705377423429899) :- todo_clear(Object), unsettled_before_on_todo_on_table(Object), on_table(Object2), needed_clear_to_stack(Object2), !.
delta(33, putdown(_), 0.0012948731009539882) :- todo_clear(Object), unsettled_before_on_todo_on_table(Object), !.
delta(33, putdown(_), -0.003310377402055878) :- todo_clear(Object), goal_on_table(Object), !.
delta(33, putdown(_), 0.10704853916723493) :- !.
delta(33, stack(Object, Object2), 0.10740281619990881) :- on_table(Object2), todo_on(Object3, Object), goal_clear(Object3), todo_on(Object4, Object2), needed_clear_to_stack(Object4), !.
delta(33, stack(Object, Object2), -0.1320180447521465) :- on_table(Object2), todo_on(Object3, Object), goal_clear(Object3), !.
delta(33, stack(_, Object), -0.02631156911254877) :- on_table(Object), todo_on(Object2, Object), needed_holding_to_putdown(Object2), !.
delta(33, stack(_, Object), 0.3568975668742552) :- on_table(Object), !.
delta(33, stack(Object, Object2), 0.03361540516339157) :- todo_on(Object3, Object), on(Object2, Object3), todo_on(Object, Object4), done_on_table(Object4), !.
delta(33, stack(Object, Object2), -0.009906744361173333) :- todo_on(Object3, Object), on(Object2, Object3), !.
delta(33, stack(_, _), -0.24844620743177348) :- clear(Object), unsettled_on(Object), !.
delta(33, stack(_, _), 0.0015339455762870182) :- !.
delta(33, unstack(Object, _), -0.01054862087083266) :- todo_on(Object, Object2), on(Object3, Object2), needed_clear_to_stack(Object3), todo_on(Object2, Object3), !.
delta(33, unstack(Object, _), 0.026776202743810897) :- todo_on(Object, Object2), on(Object3, Object2), needed_clear_to_stack(Object3), !.
delta(33, unstack(Object, Object2), 0.01136634710030982) :- todo_on(Object, _), todo_on(Object3, Object2), clear(Object3), !.
delta(33, unstack(Object, _), -0.23138047693389202) :- todo_on(Object, _), !.
delta(33, unstack(Object, _), 5.294343430473392e-5) :- todo_on(Object2, Object), could_unstack_needed_holding_to_putdown_to_stack(Object2), todo_clear(Object3), beyond_on(Object, Object3), !.
delta(33, unstack(Object, _), -0.011925813276639295) :- todo_on(Object2, Object), could_unstack_needed_holding_to_putdown_to_stack(Object2), !.
delta(33, unstack(_, Object), -0.0032153611288129338) :- todo_on(Object, Object2), unsettled_before_on_todo_on_table(Object2), !.
delta(33, unstack(_, _), 0.20018879506762458) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 276 examples, 28 leaves
delta(34, pickup(Object), 0.03351322488071463) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object3, Object), could_unstack_for_todo_on_object_any_2(Object3), on_table(Object2), !.
delta(34, pickup(Object), -0.0022131627917855077) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object3, Object), could_unstack_for_todo_on_object_any_2(Object3), !.
delta(34, pickup(Object), 0.004515418230690195) :- todo_on(Object, Object2), unsettled_on(Object2), todo_on(Object2, Object3), could_pickup_needed_holding_to_putdown_to_stack(Object3), !.
delta(34, pickup(Object), -0.08999274495335786) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(34, pickup(Object), -0.01743864371886336) :- goal_on_table(Object), !.
delta(34, pickup(Object), -0.008390412348591898) :- todo_on(Object2, Object), done_clear(Object2), !.
delta(34, pickup(_), 0.08092522912156222) :- !.
delta(34, putdown(Object), 0.010423296983709269) :- on_table(Object2), beyond_goal_on(Object2, Object), todo_on(Object3, Object2), could_stack_for_todo_on_any_object_2(Object3), fewer_clear_on_1_than_on_2, !.
delta(34, putdown(Object), -0.02796839767097513) :- on_table(Object2), beyond_goal_on(Object2, Object), todo_on(Object3, Object2), could_stack_for_todo_on_any_object_2(Object3), !.
delta(34, putdown(Object), 0.08295971740161406) :- on_table(Object2), beyond_goal_on(Object2, Object), !.
delta(34, putdown(Object), 0.007656689370219285) :- fewer_clear_on_1_than_on_2, todo_on(Object2, Object), unsettled_on_todo_clear(Object2), !.
delta(34, putdown(_), -0.19401369455764622) :- fewer_clear_on_1_than_on_2, !.
delta(34, putdown(_), 0.028376550992034937) :- clear(Object), on_table(Object), !.
delta(34, putdown(_), -0.00029122765877648553) :- !.
delta(34, stack(_, Object), -0.08371102930945462) :- todo_on(Object, Object2), goal_on_table(Object2), !.
delta(34, stack(_, Object), 0.01027108005703694) :- on_table(Object2), done_on(Object, Object2), clear(Object3), goal_on_table(Object3), !.
delta(34, stack(_, Object), -0.05910707949668776) :- on_table(Object2), done_on(Object, Object2), !.
delta(34, stack(_, Object), -0.04889511373758463) :- todo_on(Object2, Object), on(Object2, _), !.
delta(34, stack(_, _), 0.22420656405703351) :- !.
delta(34, unstack(_, Object), 0.001242831095907432) :- on(Object, Object2), beyond_goal_on(Object, Object2), todo_clear(Object3), goal_on(Object3, Object2), unsettled_on(Object2), !.
delta(34, unstack(_, Object), -0.023362090627017214) :- on(Object, Object2), beyond_goal_on(Object, Object2), todo_clear(Object3), goal_on(Object3, Object2), !.
delta(34, unstack(_, Object), -0.009289119664728802) :- on(Object, Object2), beyond_goal_on(Object, Object2), todo_on(Object2, Object3), needed_clear_to_stack(Object3), !.
delta(34, unstack(_, Object), 0.22533364303733325) :- on(Object, Object2), beyond_goal_on(Object, Object2), !.
delta(34, unstack(Object, Object2), -0.0006595359003864134) :- todo_on(Object2, Object3), unsettled_before_on_todo_on_table(Object3), todo_on(Object4, Object), clear(Object4), !.
delta(34, unstack(_, Object), 0.0778662349874484) :- todo_on(Object, Object2), unsettled_before_on_todo_on_table(Object2), !.
delta(34, unstack(Object, _), -0.29143644827886545) :- on(Object, Object2), unsettled_on(Object2), !.
delta(34, unstack(_, _), 0.042831650483039885) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 210 examples, 29 leaves
delta(35, pickup(Object), 0.01923324660352088) :- on_table(Object2), needed_clear_to_stack(Object2), todo_on(Object3, Object), could_unstack_for_todo_on_object_any_2(Object3), fewer_clear_on_1_than_on_2, !.
delta(35, pickup(Object), -0.000272053166504911) :- on_table(Object2), needed_clear_to_stack(Object2), todo_on(Object3, Object), could_unstack_for_todo_on_object_any_2(Object3), !.
delta(35, pickup(Object), 0.012283381923211833) :- on_table(Object2), needed_clear_to_stack(Object2), todo_on(Object3, Object2), todo_on(Object, Object3), !.
delta(35, pickup(_), -0.08048930037393445) :- on_table(Object), needed_clear_to_stack(Object), !.
delta(35, pickup(Object), -0.0014572957986083135) :- todo_on(Object, Object2), on(Object2, Object3), could_unstack_for_todo_on_object_any_2(Object3), !.
delta(35, pickup(Object), 0.11807190944586515) :- todo_on(Object, Object2), on(Object2, _), !.
delta(35, pickup(Object), 0.001014578613463481) :- todo_on(Object, Object2), goal_on_table(Object2), !.
delta(35, pickup(_), -0.007838302808534132) :- !.
delta(35, putdown(Object), 0.007802891644890544) :- todo_on(Object2, Object), on(Object2, Object3), could_stack_for_todo_on_object_any_2(Object3), todo_on(Object, Object3), !.
delta(35, putdown(Object), -0.1656075211816217) :- todo_on(Object2, Object), on(Object2, Object3), could_stack_for_todo_on_object_any_2(Object3), !.
delta(35, putdown(Object), 0.02387844029500142) :- todo_on(Object2, Object), on(Object2, _), !.
delta(35, putdown(_), 0.000809807010266157) :- todo_on_table(Object), unsettled_before_on_todo_on(Object), todo_clear(Object2), unsettled_on_todo_on_table(Object2), !.
delta(35, putdown(_), -0.0011296403903625141) :- todo_on_table(Object), unsettled_before_on_todo_on(Object), !.
delta(35, putdown(_), 0.11313863749962091) :- !.
delta(35, stack(Object, Object2), -0.006944922648796593) :- on_table(Object3), goal_on(Object2, Object3), clear(Object4), beyond_goal_on(Object3, Object4), beyond_goal_on(Object2, Object), !.
delta(35, stack(_, Object), 0.17709384807607303) :- on_table(Object2), goal_on(Object, Object2), clear(Object3), beyond_goal_on(Object2, Object3), !.
delta(35, stack(Object, Object2), 0.01764843135472293) :- on_table(Object3), goal_on(Object2, Object3), todo_on(Object, Object4), done_on(Object4, Object3), !.
delta(35, stack(_, Object), -0.048830448793151515) :- on_table(Object2), goal_on(Object, Object2), !.
delta(35, stack(Object, Object2), -0.02817445800962971) :- on(Object2, Object3), beyond_goal_on(Object, Object3), on(Object4, Object3), unsettled_on(Object4), !.
delta(35, stack(Object, Object2), 0.04912677555545356) :- on(Object2, Object3), beyond_goal_on(Object, Object3), !.
delta(35, stack(_, Object), 0.00010094464694922524) :- todo_on(Object2, Object), needed_on_to_unstack(Object2), !.
delta(35, stack(_, _), -0.13576269424617196) :- !.
delta(35, unstack(Object, _), -0.003850408146084324) :- todo_on(Object2, Object), needed_clear_to_stack(Object2), on(Object2, Object3), could_pickup_needed_holding_to_putdown_to_stack(Object3), !.
delta(35, unstack(Object, _), 0.10252451928280995) :- todo_on(Object2, Object), needed_clear_to_stack(Object2), !.
delta(35, unstack(_, Object), -0.01421187090480125) :- on(Object2, Object), beyond_goal_on(Object, Object2), todo_on(Object, Object3), could_unstack_needed_clear_to_stack(Object3), !.
delta(35, unstack(_, Object), 0.06580533738616744) :- on(Object2, Object), beyond_goal_on(Object, Object2), !.
delta(35, unstack(Object, _), 0.022669969936140424) :- goal_clear(Object), !.
delta(35, unstack(_, _), -0.21870879372368865) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 206 examples, 25 leaves
delta(36, pickup(Object), 0.006520663922235471) :- todo_on(Object, Object2), clear(Object2), on(Object2, Object3), unsettled_on_todo_on(Object3), unsettled_before_on(Object3), !.
delta(36, pickup(Object), -0.03791898905322689) :- todo_on(Object, Object2), clear(Object2), on(Object2, Object3), unsettled_on_todo_on(Object3), !.
delta(36, pickup(Object), -0.0018240322926539655) :- todo_on(Object, Object2), clear(Object2), todo_on(Object2, Object3), goal_on_table(Object3), !.
delta(36, pickup(Object), 0.20996035903706606) :- todo_on(Object, Object2), clear(Object2), !.
delta(36, pickup(_), -0.03871310047368637) :- !.
delta(36, putdown(Object), 0.04764911706422352) :- on_table(Object2), needed_clear_to_stack(Object2), todo_on(Object3, Object), beyond_on(Object3, Object2), !.
delta(36, putdown(Object), -0.2637425073171818) :- on_table(Object2), needed_clear_to_stack(Object2), on_table(Object3), beyond_goal_on(Object, Object3), !.
delta(36, putdown(_), 0.012297613705622644) :- on_table(Object), needed_clear_to_stack(Object), !.
delta(36, putdown(Object), -0.00042527708069694663) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(36, putdown(_), -0.0003100415831243953) :- todo_on_table(Object), done_clear(Object), !.
delta(36, putdown(_), 0.07640297488093004) :- !.
delta(36, stack(_, Object), -0.03734771452556115) :- todo_on(Object, Object2), todo_on(Object2, Object3), needed_holding_to_putdown_to_stack(Object3), !.
delta(36, stack(_, Object), -0.020489830496382446) :- todo_on(Object, Object2), on(Object3, Object2), goal_clear(Object3), !.
delta(36, stack(_, Object), 0.3029233000824226) :- todo_on(Object, _), !.
delta(36, stack(Object, Object2), 0.05650734411011953) :- todo_on(Object, Object3), beyond_goal_on(Object2, Object3), !.
delta(36, stack(Object, _), 0.002717641221127315) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(36, stack(_, _), -0.19389892872281744) :- !.
delta(36, unstack(Object, Object2), -0.011598010267785161) :- on(Object3, Object2), beyond_goal_on(Object2, Object3), todo_on(Object, Object4), could_pickup_for_todo_on_object_any(Object4), todo_clear(Object2), !.
delta(36, unstack(Object, Object2), 0.001582217970433348) :- on(Object3, Object2), beyond_goal_on(Object2, Object3), todo_on(Object, Object4), could_pickup_for_todo_on_object_any(Object4), !.
delta(36, unstack(_, Object), -0.00498788884207863) :- on(Object2, Object), beyond_goal_on(Object, Object2), on(Object, Object3), could_unstack_for_todo_on_object_any_2(Object3), !.
delta(36, unstack(_, Object), 0.07782404775407405) :- on(Object2, Object), beyond_goal_on(Object, Object2), !.
delta(36, unstack(Object, _), 0.018374962545098326) :- todo_on_table(Object), !.
delta(36, unstack(_, Object), 0.01604651163565404) :- on(Object, Object2), unsettled_before_on_todo_clear(Object2), !.
delta(36, unstack(_, _), -0.21640001916703594) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 274 examples, 27 leaves
delta(37, pickup(Object), -0.009502411337350483) :- todo_on(Object, Object2), on(Object2, _), unsettled_before_on(Object2), !.
delta(37, pickup(Object), -0.00269941383692196) :- todo_on(Object, Object2), on(Object2, _), unsettled_on_todo_clear(Object2), !.
delta(37, pickup(Object), 0.0227647350538941) :- todo_on(Object, Object2), on(Object2, _), !.
delta(37, pickup(Object), 0.00317104130350373) :- todo_on(Object, Object2), goal_on_table(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(37, pickup(Object), -0.0005442262196702354) :- todo_on(Object, Object2), goal_on_table(Object2), !.
delta(37, pickup(_), -0.028157429924374918) :- !.
delta(37, putdown(_), -0.054400181645475894) :- fewer_clear_on_1_than_todo_clear_on_2, !.
delta(37, putdown(_), 0.20148154305057278) :- clear(Object), on(Object, _), !.
delta(37, putdown(Object), -0.026677240773817473) :- todo_on(Object2, Object), todo_on(_, Object2), !.
delta(37, putdown(_), 0.00904863163469032) :- !.
delta(37, stack(_, Object), -0.0016063500462024823) :- on_table(Object2), on(Object, Object2), todo_on(Object3, Object), needed_clear_to_stack(Object3), todo_on_table(Object), !.
delta(37, stack(_, Object), 0.11849027696256584) :- on_table(Object2), on(Object, Object2), todo_on(Object3, Object), needed_clear_to_stack(Object3), !.
delta(37, stack(_, Object), -0.017158189304997743) :- on_table(Object2), on(Object, Object2), on(Object3, Object2), unsettled_on(Object3), !.
delta(37, stack(_, Object), 0.004389349875894061) :- on_table(Object2), on(Object, Object2), !.
delta(37, stack(Object, Object2), 0.10837886874913663) :- goal_clear(Object2), todo_on(Object, Object3), unsettled_on(Object3), !.
delta(37, stack(_, Object), -0.026812348598047722) :- goal_clear(Object), !.
delta(37, stack(_, _), -0.3119660943257437) :- clear(Object), on(Object, _), !.
delta(37, stack(_, _), 0.0279743597674701) :- !.
delta(37, unstack(Object, Object2), 2.3287362819688944e-5) :- todo_on(Object, Object3), on_table(Object3), todo_on(Object3, Object4), beyond_goal_on(Object2, Object4), needed_on_table_to_pickup_to_putdown(Object2), !.
delta(37, unstack(Object, Object2), -0.009005077959624559) :- todo_on(Object, Object3), on_table(Object3), todo_on(Object3, Object4), beyond_goal_on(Object2, Object4), !.
delta(37, unstack(Object, _), 0.28827670771206104) :- todo_on(Object, Object2), on_table(Object2), clear(Object3), could_pickup_for_todo_on_object_any(Object3), !.
delta(37, unstack(Object, _), -0.0043267975237630185) :- todo_on(Object, Object2), on_table(Object2), !.
delta(37, unstack(_, Object), 0.025174717041375198) :- on(Object, Object2), goal_on_table(Object2), on(Object3, Object), unsettled_on(Object3), !.
delta(37, unstack(_, Object), -0.0022226805850784266) :- on(Object, Object2), goal_on_table(Object2), !.
delta(37, unstack(_, Object), 0.014873254223376434) :- todo_on(Object, Object2), goal_on_table(Object2), !.
delta(37, unstack(_, _), -0.2809883828790257) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 204 examples, 25 leaves
delta(38, pickup(Object), -0.02982762615440012) :- todo_on(Object, Object2), clear(Object2), on(Object2, Object3), unsettled_on(Object3), !.
delta(38, pickup(Object), -0.016675147618241702) :- todo_on(Object, Object2), clear(Object2), todo_clear(Object3), unsettled_before_on_todo_on(Object3), !.
delta(38, pickup(Object), 0.08193589970072993) :- todo_on(Object, Object2), clear(Object2), !.
delta(38, pickup(_), -0.032129738045946994) :- !.
delta(38, putdown(_), -0.01630784354588762) :- clear(Object), goal_on_table(Object), fewer_clear_than_on_2, todo_on(Object2, Object), needed_clear_to_stack(Object2), !.
delta(38, putdown(_), 0.006442837816696616) :- clear(Object), goal_on_table(Object), fewer_clear_than_on_2, !.
delta(38, putdown(_), -0.0024871892516434018) :- clear(Object), goal_on_table(Object), todo_on(Object2, Object), done_clear(Object2), !.
delta(38, putdown(_), 0.06318702376373606) :- clear(Object), goal_on_table(Object), !.
delta(38, putdown(Object), 0.004598063509986665) :- todo_on(Object2, Object), on(_, Object2), !.
delta(38, putdown(_), -0.2296236136585972) :- clear(Object), todo_on(_, Object), !.
delta(38, putdown(_), 0.0016699027806334548) :- !.
delta(38, stack(Object, Object2), 0.05463870776585472) :- todo_on(Object3, Object2), clear(Object3), todo_on_table(Object), clear(Object4), beyond_goal_on(Object4, Object3), !.
delta(38, stack(Object, Object2), -0.0006475663592651451) :- todo_on(Object3, Object2), clear(Object3), todo_on_table(Object), !.
delta(38, stack(_, Object), -0.1899553852916799) :- todo_on(Object2, Object), clear(Object2), !.
delta(38, stack(Object, Object2), 0.000738776377018097) :- holding(Object3), beyond_goal_on(Object2, Object3), todo_on(Object, Object4), unsettled_on_todo_on_table(Object4), !.
delta(38, stack(_, Object), -0.06352084586392898) :- holding(Object2), beyond_goal_on(Object, Object2), !.
delta(38, stack(Object, _), 0.3407944970018982) :- on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(38, stack(_, _), -0.020049646823249032) :- !.
delta(38, unstack(Object, _), 0.013936578729545958) :- on_table(Object2), goal_on(Object, Object2), todo_on(Object2, Object3), could_pickup_for_todo_on_object_any(Object3), !.
delta(38, unstack(Object, Object2), 0.004151046549281564) :- on_table(Object3), goal_on(Object, Object3), on(Object2, Object4), beyond_goal_on(Object, Object4), !.
delta(38, unstack(Object, _), -0.12814095486774385) :- on_table(Object2), goal_on(Object, Object2), !.
delta(38, unstack(Object, _), -0.012016108992635747) :- todo_on(Object, Object2), unsettled_on_todo_on_table(Object2), !.
delta(38, unstack(_, Object), 0.1279033768152804) :- on(Object2, Object), unsettled_on(Object2), !.
delta(38, unstack(_, _), -0.007792239559493499) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 232 examples, 26 leaves
delta(39, pickup(Object), -0.019165856227977385) :- todo_on(Object, Object2), clear(Object2), todo_on(Object2, Object3), could_unstack_for_todo_on_object_any(Object3), !.
delta(39, pickup(Object), -0.01489657419483028) :- todo_on(Object, Object2), clear(Object2), on(Object2, Object3), unsettled_before_on(Object3), !.
delta(39, pickup(Object), 0.13638703183433903) :- todo_on(Object, Object2), clear(Object2), !.
delta(39, pickup(_), -0.03266099868121908) :- !.
delta(39, putdown(_), -0.0890202023274602) :- todo_on_table(Object), needed_holding_to_putdown_to_stack(Object), clear(Object2), on(Object2, Object), !.
delta(39, putdown(_), 0.006785430543794406) :- todo_on_table(Object), needed_holding_to_putdown_to_stack(Object), !.
delta(39, putdown(Object), 0.004830254874802849) :- todo_on(Object2, Object), unsettled_before_on_todo_clear(Object2), todo_clear(Object2), !.
delta(39, putdown(Object), -0.03224447433318004) :- todo_on(Object2, Object), unsettled_before_on_todo_clear(Object2), !.
delta(39, putdown(Object), 0.10587354381031022) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(39, putdown(_), -0.006199620577414517) :- !.
delta(39, stack(_, Object), 0.04214086328312893) :- todo_on(Object, Object2), clear(Object2), todo_on(Object3, Object), needed_holding_to_putdown(Object3), !.
delta(39, stack(Object, Object2), 0.002729527778639747) :- todo_on(Object2, Object3), clear(Object3), todo_on(Object4, Object), needed_clear_to_stack(Object4), !.
delta(39, stack(_, Object), -0.17375447889475035) :- todo_on(Object, Object2), clear(Object2), !.
delta(39, stack(Object, _), -0.030722779061402892) :- fewer_clear_on_1_than_on_2, todo_on(Object2, Object), unsettled_on_todo_clear(Object2), !.
delta(39, stack(_, _), 0.19250955350986898) :- fewer_clear_on_1_than_on_2, !.
delta(39, stack(_, Object), 0.036682603837573144) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(39, stack(_, _), -0.07010131570105535) :- !.
delta(39, unstack(Object, Object2), 0.03392477451832728) :- todo_on(Object3, Object), beyond_goal_on(Object3, Object2), todo_on(Object4, Object3), on_table(Object4), unsettled_on(Object), !.
delta(39, unstack(Object, Object2), -0.003248419001299046) :- todo_on(Object3, Object), beyond_goal_on(Object3, Object2), todo_on(Object4, Object3), on_table(Object4), !.
delta(39, unstack(Object, Object2), 0.008977160901427236) :- todo_on(Object3, Object), beyond_goal_on(Object3, Object2), on(Object4, Object3), goal_on(Object, Object4), !.
delta(39, unstack(Object, Object2), -0.234967981693449) :- todo_on(Object3, Object), beyond_goal_on(Object3, Object2), !.
delta(39, unstack(_, Object), 0.0013753208963314253) :- todo_on(Object, Object2), could_unstack_needed_clear_to_stack(Object2), todo_on(Object3, Object), could_pickup_for_todo_on_any_object(Object3), !.
delta(39, unstack(_, Object), -0.03647113728796521) :- todo_on(Object, Object2), could_unstack_needed_clear_to_stack(Object2), !.
delta(39, unstack(Object, _), -0.0025724531624012523) :- todo_on_table(Object2), todo_on(Object, Object2), !.
delta(39, unstack(_, _), 0.1654328357317055) :- !.
delta(39, _, 0.0).

% tree 40: step size 1.0, 218 examples, 28 leaves
delta(40, pickup(Object), -0.040666705850376766) :- goal_clear(Object), todo_on(Object, Object2), unsettled_on(Object2), !.
delta(40, pickup(Object), 0.0006661062137131805) :- goal_clear(Object), todo_on(Object, Object2), clear(Object2), !.
delta(40, pickup(Object), -0.00040125269569114456) :- goal_clear(Object), !.
delta(40, pickup(Object), -0.012082326014643768) :- todo_on(Object2, Object), could_unstack_todo_clear(Object2), !.
delta(40, pickup(_), 0.18694011889801168) :- on_table(Object), goal_on_table(Object), !.
delta(40, pickup(_), -0.003244867249663848) :- !.
delta(40, putdown(Object), 0.02759392038117069) :- todo_on(Object, Object2), on_table(Object2), todo_on(Object2, Object3), clear(Object3), !.
delta(40, putdown(Object), 0.010477230263634387) :- todo_on(Object, Object2), on_table(Object2), on(Object3, Object2), unsettled_on_todo_on(Object3), !.
delta(40, putdown(Object), -0.18262551649046563) :- todo_on(Object, Object2), on_table(Object2), !.
delta(40, putdown(_), 0.09483577773260966) :- on_table(Object), goal_clear(Object), !.
delta(40, putdown(_), -0.03155909432043206) :- clear(Object), goal_clear(Object), !.
delta(40, putdown(_), 0.02840587905770675) :- !.
delta(40, stack(Object, Object2), -0.0478229450110244) :- on_table(Object3), beyond_goal_on(Object2, Object3), todo_on(Object4, Object), goal_clear(Object4), beyond_goal_on(Object, Object3), !.
delta(40, stack(Object, Object2), -0.00046623422617320586) :- on_table(Object3), beyond_goal_on(Object2, Object3), todo_on(Object4, Object), goal_clear(Object4), !.
delta(40, stack(Object, Object2), -0.03324842442669087) :- on_table(Object3), beyond_goal_on(Object2, Object3), todo_on(Object4, Object), beyond_goal_on(Object3, Object4), !.
delta(40, stack(_, Object), 0.21884569559101433) :- on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(40, stack(Object, _), -0.0012655288078146443) :- todo_on(Object2, Object), unsettled_before_on_todo_clear(Object2), todo_clear(Object2), !.
delta(40, stack(Object, _), 0.03151549316201117) :- todo_on(Object2, Object), unsettled_before_on_todo_clear(Object2), !.
delta(40, stack(_, _), -0.13242012774262527) :- !.
delta(40, unstack(Object, _), 0.023612064760392862) :- todo_on(Object2, Object), goal_on(Object3, Object2), done_clear(Object3), unsettled_on(Object), !.
delta(40, unstack(Object, _), -0.0011878006217949362) :- todo_on(Object2, Object), goal_on(Object3, Object2), done_clear(Object3), !.
delta(40, unstack(Object, Object2), 0.00418751956268741) :- todo_on(Object3, Object), goal_on(_, Object3), unsettled_on_todo_on_table(Object2), !.
delta(40, unstack(Object, _), -0.30679891353798183) :- todo_on(Object2, Object), goal_on(_, Object2), !.
delta(40, unstack(Object, Object2), -0.001019709833961801) :- clear(Object3), beyond_goal_on(Object2, Object3), todo_on(Object4, Object3), todo_on(Object, Object4), !.
delta(40, unstack(_, Object), 0.16282349763794188) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(40, unstack(_, Object), 0.006901212273991943) :- todo_on(Object2, Object), clear(Object2), !.
delta(40, unstack(_, _), -0.012368201976352518) :- !.
delta(40, _, 0.0).

% tree 41: step size 1.0, 210 examples, 28 leaves
delta(41, pickup(Object), -0.00021565721182279995) :- todo_on(Object, Object2), todo_on(Object2, Object3), could_unstack_for_todo_on_object_any(Object3), goal_clear(Object), !.
delta(41, pickup(Object), 0.004119553837503492) :- todo_on(Object, Object2), todo_on(Object2, Object3), could_unstack_for_todo_on_object_any(Object3), !.
delta(41, pickup(Object), -0.06719463120693853) :- todo_on(Object, Object2), todo_on(Object2, _), !.
delta(41, pickup(Object), -0.004001173664382622) :- clear(Object2), goal_on_table(Object2), goal_on_table(Object), !.
delta(41, pickup(_), 0.11383180000657572) :- clear(Object), goal_on_table(Object), !.
delta(41, pickup(Object), -0.006407853548613855) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(41, pickup(_), 0.0010223799585507933) :- !.
delta(41, putdown(_), 0.07632833919612822) :- todo_clear(_), !.
delta(41, putdown(Object), 0.04472509690575702) :- todo_on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(41, putdown(_), -0.19489120832956422) :- on_table(Object), needed_clear_to_stack(Object), !.
delta(41, putdown(_), 0.009511201222552843) :- !.
delta(41, stack(Object, Object2), 0.0007710326980203653) :- unsettled_on_todo_on(Object2), todo_on_table(Object3), beyond_goal_on(Object2, Object3), todo_on_table(Object4), todo_on(Object, Object4), !.
delta(41, stack(_, Object), -0.07351636004925395) :- unsettled_on_todo_on(Object), todo_on_table(Object2), beyond_goal_on(Object, Object2), !.
delta(41, stack(_, Object), -0.028255142105599856) :- unsettled_on_todo_on(Object), todo_clear(Object2), beyond_goal_on(Object2, Object), !.
delta(41, stack(_, Object), 0.28352439744743724) :- unsettled_on_todo_on(Object), !.
delta(41, stack(Object, Object2), -0.0027120814122577434) :- todo_on(Object, Object2), todo_on_table(Object2), !.
delta(41, stack(Object, Object2), 0.025214978369503246) :- todo_on(Object, Object2), !.
delta(41, stack(Object, _), 0.00936424963588945) :- todo_on(Object2, Object), on(Object2, _), !.
delta(41, stack(_, _), -0.17212378164866513) :- !.
delta(41, unstack(Object, Object2), 0.057232666268635615) :- todo_clear(Object3), beyond_goal_on(Object3, Object), on(Object4, Object2), beyond_on(Object4, Object3), fewer_clear_than_on_2, !.
delta(41, unstack(Object, Object2), -0.016334522025443273) :- todo_clear(Object3), beyond_goal_on(Object3, Object), on(Object4, Object2), beyond_on(Object4, Object3), !.
delta(41, unstack(Object, _), 0.0062287559372411335) :- todo_clear(Object2), beyond_goal_on(Object2, Object), todo_on_table(Object), !.
delta(41, unstack(Object, _), -0.14753551889233352) :- todo_clear(Object2), beyond_goal_on(Object2, Object), !.
delta(41, unstack(Object, Object2), 0.0010682741966806196) :- todo_clear(Object3), beyond_on(Object2, Object3), todo_on(Object4, Object), clear(Object4), !.
delta(41, unstack(_, Object), -0.06109237446003995) :- todo_clear(Object2), beyond_on(Object, Object2), !.
delta(41, unstack(Object, _), -0.026894085554440898) :- todo_on(Object, Object2), could_pickup_needed_holding_to_putdown_to_stack(Object2), !.
delta(41, unstack(_, _), 0.14213496140191106) :- !.
delta(41, _, 0.0).

% tree 42: step size 1.0, 242 examples, 27 leaves
delta(42, pickup(Object), -0.024691042332706154) :- todo_on(Object2, Object), could_pickup_needed_holding_to_putdown_to_stack(Object2), !.
delta(42, pickup(Object), -0.023058695426008965) :- todo_on(Object, Object2), unsettled_before_on(Object2), on(Object3, Object2), unsettled_before_on_todo_on(Object3), !.
delta(42, pickup(Object), 0.1209442728876092) :- todo_on(Object, Object2), unsettled_before_on(Object2), !.
delta(42, pickup(_), -0.024516231231478693) :- on_table(Object), needed_clear_to_stack(Object), !.
delta(42, pickup(_), 0.006849458213424684) :- !.
delta(42, putdown(_), 0.0004846611510254766) :- on_table(Object), needed_clear_to_stack(Object), on(Object2, Object), needed_clear_to_stack(Object2), unsettled_before_on_todo_clear(Object), !.
delta(42, putdown(_), -0.10308622866072496) :- on_table(Object), needed_clear_to_stack(Object), on(Object2, Object), needed_clear_to_stack(Object2), !.
delta(42, putdown(_), 0.03486977715145194) :- on_table(Object), needed_clear_to_stack(Object), !.
delta(42, putdown(Object), -0.0002831970915950463) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(42, putdown(_), 0.05526994657618846) :- !.
delta(42, stack(Object, Object2), 0.10554980700547803) :- todo_on(Object3, Object), beyond_goal_on(Object3, Object2), on(Object2, Object4), goal_on(Object2, Object4), todo_on(Object, Object2), !.
delta(42, stack(Object, Object2), -0.003856503156170851) :- todo_on(Object3, Object), beyond_goal_on(Object3, Object2), on(Object2, Object4), goal_on(Object2, Object4), !.
delta(42, stack(Object, Object2), -0.26998672428874443) :- todo_on(Object3, Object), beyond_goal_on(Object3, Object2), on_table(Object4), beyond_goal_on(Object4, Object), !.
delta(42, stack(Object, Object2), 0.03461508072856845) :- todo_on(Object3, Object), beyond_goal_on(Object3, Object2), !.
delta(42, stack(Object, Object2), -0.030167253261088628) :- todo_on(Object, Object3), unsettled_on(Object3), todo_on(Object4, Object2), unsettled_on_todo_clear(Object4), !.
delta(42, stack(Object, _), 0.21833744858901982) :- todo_on(Object, Object2), unsettled_on(Object2), !.
delta(42, stack(Object, Object2), 0.005589321900833818) :- todo_on(Object, Object2), !.
delta(42, stack(_, _), -0.04365213550542143) :- !.
delta(42, unstack(Object, Object2), -0.044806467590753386) :- clear(Object3), beyond_goal_on(Object, Object3), todo_on(Object4, Object2), could_pickup_for_todo_on_any_object(Object4), goal_on_table(Object3), !.
delta(42, unstack(Object, Object2), 0.006071025161923371) :- clear(Object3), beyond_goal_on(Object, Object3), todo_on(Object4, Object2), could_pickup_for_todo_on_any_object(Object4), !.
delta(42, unstack(Object, Object2), -0.013093958244021833) :- clear(Object3), beyond_goal_on(Object, Object3), todo_on(Object4, Object3), todo_on(Object2, Object4), !.
delta(42, unstack(Object, _), 0.1809539180146558) :- clear(Object2), beyond_goal_on(Object, Object2), !.
delta(42, unstack(Object, _), 0.005237609737985514) :- on_table(Object2), todo_on(Object2, _), goal_clear(Object), !.
delta(42, unstack(_, _), -0.2093885532309396) :- on_table(Object), todo_on(Object, _), !.
delta(42, unstack(Object, _), 0.008173071393812128) :- todo_clear(Object2), beyond_on(Object, Object2), !.
delta(42, unstack(_, _), -0.0004549744990997072) :- !.
delta(42, _, 0.0).

% tree 43: step size 1.0, 276 examples, 27 leaves
delta(43, pickup(Object), 0.003629062039125418) :- todo_on(Object, Object2), done_on_table(Object2), todo_on(Object, Object3), clear(Object3), !.
delta(43, pickup(Object), -0.0006842098615056879) :- todo_on(Object, Object2), done_on_table(Object2), !.
delta(43, pickup(Object), 0.0020310898659661883) :- todo_on(Object2, Object), done_clear(Object2), clear(Object3), could_unstack_for_todo_on_object_any_2(Object3), !.
delta(43, pickup(Object), -0.0015876405069460363) :- todo_on(Object2, Object), done_clear(Object2), !.
delta(43, pickup(_), -0.024295535557834445) :- !.
delta(43, putdown(Object), 0.0002727308831640152) :- todo_on(Object2, Object), needed_clear_to_stack(Object2), on(Object3, Object2), beyond_goal_on(Object3, Object), todo_on_table(Object), !.
delta(43, putdown(Object), -0.08025521913471739) :- todo_on(Object2, Object), needed_clear_to_stack(Object2), on(Object3, Object2), beyond_goal_on(Object3, Object), !.
delta(43, putdown(Object), 0.010861678357234754) :- todo_on(Object2, Object), needed_clear_to_stack(Object2), !.
delta(43, putdown(_), 0.0002003889771746645) :- todo_clear(Object), done_on_table(Object), todo_clear(Object2), unsettled_on_todo_on(Object2), !.
delta(43, putdown(_), -0.0023277406613986295) :- todo_clear(Object), done_on_table(Object), !.
delta(43, putdown(_), 0.08631564331363628) :- fewer_clear_on_1_than_on_2, !.
delta(43, putdown(_), 0.0001760110174686347) :- !.
delta(43, stack(Object, Object2), 0.28549455323740325) :- todo_on(Object2, Object3), beyond_goal_on(Object3, Object), todo_on(Object2, Object4), on_table(Object4), clear(Object3), !.
delta(43, stack(Object, Object2), -0.003081428083442545) :- todo_on(Object2, Object3), beyond_goal_on(Object3, Object), todo_on(Object2, Object4), on_table(Object4), !.
delta(43, stack(Object, Object2), -0.049416133928743354) :- todo_on(Object2, Object3), beyond_goal_on(Object3, Object), !.
delta(43, stack(_, Object), 0.02119222972537056) :- todo_on(Object, Object2), goal_on(Object2, _), unsettled_on_todo_clear(Object), !.
delta(43, stack(_, Object), -0.30826694848543723) :- todo_on(Object, Object2), goal_on(Object2, _), !.
delta(43, stack(_, Object), -0.04394757759871804) :- todo_on(Object2, Object), on_table(Object2), !.
delta(43, stack(_, _), 0.08879856477635163) :- !.
delta(43, unstack(_, Object), 0.0023853692778839073) :- on(Object, Object2), on(Object2, _), unsettled_before_on_todo_clear(Object2), !.
delta(43, unstack(_, Object), 0.0015941219074760281) :- on(Object, Object2), on(Object2, Object3), could_pickup_needed_holding_to_putdown_to_stack(Object3), !.
delta(43, unstack(_, Object), -0.1527994883819722) :- on(Object, Object2), on(Object2, _), !.
delta(43, unstack(Object, Object2), -0.01304540427286977) :- todo_on(Object, Object3), beyond_goal_on(Object2, Object3), on_table(Object4), needed_clear_to_stack(Object4), !.
delta(43, unstack(Object, Object2), 0.0012556951611314032) :- todo_on(Object, Object3), beyond_goal_on(Object2, Object3), !.
delta(43, unstack(Object, _), -0.006104389858589831) :- todo_on(Object, Object2), could_unstack_todo_clear(Object2), !.
delta(43, unstack(_, _), 0.18287248088734406) :- !.
delta(43, _, 0.0).

% tree 44: step size 1.0, 282 examples, 27 leaves
delta(44, pickup(Object), -0.0011131284147916853) :- todo_on(Object2, Object), needed_on_table_to_pickup_to_putdown(Object2), clear(Object3), goal_clear(Object3), !.
delta(44, pickup(Object), 0.14535423293965719) :- todo_on(Object2, Object), needed_on_table_to_pickup_to_putdown(Object2), !.
delta(44, pickup(Object), 0.0010880615350759286) :- on_table(Object2), todo_on(Object3, Object2), todo_on(Object, Object3), !.
delta(44, pickup(_), -0.03715554433689835) :- on_table(Object), todo_on(_, Object), !.
delta(44, pickup(Object), 0.00045867584758501527) :- todo_on(Object, Object2), clear(Object2), !.
delta(44, pickup(_), -0.0001518537302553915) :- !.
delta(44, putdown(Object), 0.013998849187882877) :- todo_on(Object, Object2), on_table(Object2), on(Object3, Object2), could_stack_for_todo_on_any_object_2(Object3), !.
delta(44, putdown(Object), 0.005210665983703663) :- todo_on(Object, Object2), on_table(Object2), todo_clear(Object3), beyond_goal_on(Object3, Object2), !.
delta(44, putdown(Object), -0.31422199526695055) :- todo_on(Object, Object2), on_table(Object2), !.
delta(44, putdown(_), -0.0003880121202646104) :- clear(Object), goal_clear(Object), on(Object, Object2), needed_clear_to_stack(Object2), !.
delta(44, putdown(_), 0.05930254833403501) :- clear(Object), goal_clear(Object), !.
delta(44, putdown(Object), 0.008610644973399518) :- todo_on(Object, Object2), unsettled_on_todo_clear(Object2), !.
delta(44, putdown(_), -0.02527982561868124) :- !.
delta(44, stack(_, Object), -0.23075915353645748) :- todo_on(Object2, Object), on(Object3, Object2), beyond_goal_on(Object3, Object), !.
delta(44, stack(_, Object), -0.0069411803390096675) :- todo_on(Object2, Object), on(_, Object2), unsettled_before_on_todo_clear(Object2), !.
delta(44, stack(_, Object), 0.035484761205340234) :- todo_on(Object2, Object), on(_, Object2), !.
delta(44, stack(_, Object), -0.16089495721333108) :- todo_on(Object, Object2), on(_, Object2), !.
delta(44, stack(_, Object), -0.010378844163796704) :- on(Object, Object2), on(Object2, _), !.
delta(44, stack(_, _), 0.5382502492028102) :- !.
delta(44, unstack(Object, _), 0.008724979776960282) :- todo_on(Object2, Object), todo_on(_, Object2), unsettled_on_todo_on_table(Object), !.
delta(44, unstack(Object, Object2), 0.00446265119047636) :- todo_on(Object3, Object), todo_on(Object4, Object3), beyond_goal_on(Object2, Object4), !.
delta(44, unstack(Object, _), -0.22582067595099067) :- todo_on(Object2, Object), todo_on(_, Object2), !.
delta(44, unstack(_, Object), 0.0014320007576380306) :- on(Object, Object2), goal_on(Object, Object2), clear(Object3), beyond_goal_on(Object, Object3), !.
delta(44, unstack(_, Object), -0.02510462783467159) :- on(Object, Object2), goal_on(Object, Object2), !.
delta(44, unstack(_, Object), 0.132693588510353) :- on(Object2, Object), unsettled_on(Object2), !.
delta(44, unstack(_, _), -0.0037502484193062987) :- !.
delta(44, _, 0.0).
