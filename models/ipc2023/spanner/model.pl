% SHA-256 of what follows: 4dc0949f0955497b3ab9a50bb3d79a81834b7b1b198fab058beeffcd6f7a83b8
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
model(trained_episodes, 4007).
model(trees, 248).

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

% tree 1: step size 1.0, 201 examples, 5 leaves
delta(1, walk(_, Location, Man), 0.6153263715809071) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(1, walk(_, _, _), -1.8424591738712779) :- !.
delta(1, pickup_spanner(_, _, Man), -0.6153263715809071) :- carrying(Man, _), !.
delta(1, pickup_spanner(_, _, _), 1.8424591738712779) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 201 examples, 5 leaves
delta(2, walk(_, Location, Man), 0.3186773791035284) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(2, walk(_, _, _), -0.5403366051007642) :- !.
delta(2, pickup_spanner(_, _, Man), -0.3186773791035284) :- carrying(Man, _), !.
delta(2, pickup_spanner(_, _, _), 0.5403366051007642) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 202 examples, 5 leaves
delta(3, walk(_, Location, Man), 0.1989699844011453) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(3, walk(_, _, _), -0.2657714985817226) :- !.
delta(3, pickup_spanner(_, _, Man), -0.1989699844011453) :- carrying(Man, _), !.
delta(3, pickup_spanner(_, _, _), 0.2657714985817226) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 204 examples, 7 leaves
delta(4, walk(_, Location, Man), -3.0) :- fewer_carrying_2_than_todo_tightened, at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(4, walk(_, _, _), -0.17472212729480247) :- fewer_carrying_2_than_todo_tightened, !.
delta(4, walk(_, _, _), 0.13868836322043324) :- !.
delta(4, pickup_spanner(_, _, Man), 3.0) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(4, pickup_spanner(_, _, Man), -0.13868836322043324) :- carrying(Man, _), !.
delta(4, pickup_spanner(_, _, _), 0.11586515216138862) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 204 examples, 6 leaves
delta(5, walk(_, _, _), -0.39076396455587653) :- fewer_carrying_2_than_todo_tightened, !.
delta(5, walk(_, _, _), 0.12409533739616055) :- !.
delta(5, pickup_spanner(_, _, Man), 0.30176426704592124) :- fewer_carrying_2_than_todo_tightened, carrying(Man, _), !.
delta(5, pickup_spanner(_, _, _), 0.08068062622897691) :- fewer_carrying_2_than_todo_tightened, !.
delta(5, pickup_spanner(_, _, _), -0.12409533739616055) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 204 examples, 6 leaves
delta(6, walk(_, _, _), -0.26093661085455766) :- fewer_carrying_2_than_todo_tightened, !.
delta(6, walk(_, _, _), 0.0935092503395377) :- !.
delta(6, pickup_spanner(_, _, Man), 0.21567183214429975) :- fewer_carrying_2_than_todo_tightened, carrying(Man, _), !.
delta(6, pickup_spanner(_, _, _), 0.042724743721748934) :- fewer_carrying_2_than_todo_tightened, !.
delta(6, pickup_spanner(_, _, _), -0.0935092503395377) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 208 examples, 5 leaves
delta(7, walk(_, _, _), -0.19804740254706524) :- fewer_carrying_2_than_todo_tightened, !.
delta(7, walk(_, _, _), 0.1068667935309799) :- !.
delta(7, pickup_spanner(_, _, _), 0.11020491993698542) :- fewer_carrying_2_than_todo_tightened, !.
delta(7, pickup_spanner(_, _, _), -0.1068667935309799) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 207 examples, 5 leaves
delta(8, walk(_, _, _), -0.17768665123467417) :- fewer_carrying_2_than_todo_tightened, !.
delta(8, walk(_, _, _), 0.08932994646194271) :- !.
delta(8, pickup_spanner(_, _, _), 0.09801925574151626) :- fewer_carrying_2_than_todo_tightened, !.
delta(8, pickup_spanner(_, _, _), -0.08932994646194271) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 212 examples, 6 leaves
delta(9, walk(_, _, _), -0.14013630168575314) :- fewer_carrying_2_than_todo_tightened, !.
delta(9, walk(_, _, _), 0.07152494923844208) :- !.
delta(9, pickup_spanner(_, _, Man), 0.10244501500847969) :- fewer_carrying_2_than_todo_tightened, carrying(Man, _), !.
delta(9, pickup_spanner(_, _, _), 0.022849386362858087) :- fewer_carrying_2_than_todo_tightened, !.
delta(9, pickup_spanner(_, _, _), -0.07152494923844208) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 206 examples, 7 leaves
delta(10, walk(_, Location, Man), 0.009575726755936584) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(10, walk(_, Location, _), -0.004484173683850651) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), !.
delta(10, walk(_, _, _), -0.09572620122429822) :- fewer_carrying_2_than_todo_tightened, !.
delta(10, walk(_, _, _), 0.06177431870776312) :- !.
delta(10, pickup_spanner(_, _, _), 0.04995175071580845) :- fewer_carrying_2_than_todo_tightened, !.
delta(10, pickup_spanner(_, _, _), -0.06177431870776312) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 207 examples, 5 leaves
delta(11, walk(_, _, _), -0.08418190113667458) :- fewer_carrying_2_than_todo_tightened, !.
delta(11, walk(_, _, _), 0.06714080044908456) :- !.
delta(11, pickup_spanner(_, _, _), 0.046856920240643175) :- fewer_carrying_2_than_todo_tightened, !.
delta(11, pickup_spanner(_, _, _), -0.06714080044908456) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 209 examples, 6 leaves
delta(12, walk(_, _, _), -0.09005324880229094) :- fewer_carrying_2_than_todo_tightened, !.
delta(12, walk(_, _, _), 0.06085557228098972) :- !.
delta(12, pickup_spanner(_, _, Man), 0.06830863662211575) :- fewer_carrying_2_than_todo_tightened, carrying(Man, _), !.
delta(12, pickup_spanner(_, _, _), 0.01325294281203885) :- fewer_carrying_2_than_todo_tightened, !.
delta(12, pickup_spanner(_, _, _), -0.06085557228098972) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 201 examples, 5 leaves
delta(13, walk(_, _, _), -0.08734175372679907) :- fewer_carrying_2_than_todo_tightened, !.
delta(13, walk(_, _, _), 0.046057174864060635) :- !.
delta(13, pickup_spanner(_, _, _), 0.061174137903579416) :- fewer_carrying_2_than_todo_tightened, !.
delta(13, pickup_spanner(_, _, _), -0.046057174864060635) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 216 examples, 5 leaves
delta(14, walk(_, _, _), -0.06604590967339113) :- fewer_carrying_2_than_todo_tightened, !.
delta(14, walk(_, _, _), 0.0385077917714458) :- !.
delta(14, pickup_spanner(_, _, _), 0.06448791133256837) :- fewer_carrying_2_than_todo_tightened, !.
delta(14, pickup_spanner(_, _, _), -0.0385077917714458) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 202 examples, 5 leaves
delta(15, walk(_, _, _), -0.06516126985126638) :- fewer_carrying_2_than_todo_tightened, !.
delta(15, walk(_, _, _), 0.04444797239533831) :- !.
delta(15, pickup_spanner(_, _, _), 0.04613681054046136) :- fewer_carrying_2_than_todo_tightened, !.
delta(15, pickup_spanner(_, _, _), -0.04444797239533831) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 209 examples, 5 leaves
delta(16, walk(_, Location, _), -0.019514322473621802) :- todo_tightened(Nut), at(Nut, Location), fewer_carrying_2_than_todo_tightened, !.
delta(16, walk(_, Location, _), 0.015682539649396268) :- todo_tightened(Nut), at(Nut, Location), !.
delta(16, walk(_, _, _), 0.04188317846213849) :- !.
delta(16, pickup_spanner(_, _, _), -0.036396734721010404) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 201 examples, 5 leaves
delta(17, walk(_, _, _), -0.05386247137232442) :- fewer_carrying_2_than_todo_tightened, !.
delta(17, walk(_, _, _), 0.03513445893533532) :- !.
delta(17, pickup_spanner(_, _, _), 0.03827412917992606) :- fewer_carrying_2_than_todo_tightened, !.
delta(17, pickup_spanner(_, _, _), -0.03513445893533532) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 206 examples, 7 leaves
delta(18, walk(_, Location, Man), 0.10135412520964351) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(18, walk(_, Location, _), -0.00154306473281931) :- at(Locatable, Location), spanner(Locatable), !.
delta(18, walk(_, _, _), -0.04059311598014172) :- fewer_carrying_2_than_todo_tightened, !.
delta(18, walk(_, _, _), 0.023959192437854295) :- !.
delta(18, pickup_spanner(_, _, Man), -0.08716484117169647) :- carrying(Man, _), !.
delta(18, pickup_spanner(_, _, _), 0.008576883935662138) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 217 examples, 7 leaves
delta(19, walk(_, Location, _), -0.0019738871955248404) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, !.
delta(19, walk(_, Location, _), 0.016140945056995065) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), !.
delta(19, walk(_, _, _), -0.04265197912435236) :- fewer_carrying_2_than_todo_tightened, !.
delta(19, walk(_, _, _), 0.03317974612867899) :- !.
delta(19, pickup_spanner(_, _, _), 0.02860988174526669) :- fewer_carrying_2_than_todo_tightened, !.
delta(19, pickup_spanner(_, _, _), -0.03317974612867899) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 211 examples, 7 leaves
delta(20, walk(_, Location, Man), 0.004579069679090793) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(20, walk(_, Location, _), -0.0012271722504357482) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), !.
delta(20, walk(_, _, _), -0.027010252576365475) :- fewer_carrying_2_than_todo_tightened, !.
delta(20, walk(_, _, _), 0.022788758679954016) :- !.
delta(20, pickup_spanner(_, _, _), 0.022352578756257176) :- fewer_carrying_2_than_todo_tightened, !.
delta(20, pickup_spanner(_, _, _), -0.022788758679954016) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 203 examples, 7 leaves
delta(21, walk(_, Location, Man), 0.007521771986308634) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(21, walk(_, Location, _), -0.002334651043549269) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), !.
delta(21, walk(_, _, _), -0.03180868240584759) :- fewer_carrying_2_than_todo_tightened, !.
delta(21, walk(_, _, _), 0.025180729124597116) :- !.
delta(21, pickup_spanner(_, _, _), 0.01941499145380528) :- fewer_carrying_2_than_todo_tightened, !.
delta(21, pickup_spanner(_, _, _), -0.025180729124597116) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 213 examples, 7 leaves
delta(22, walk(_, Location, Man), -0.008994648799424873) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), todo_tightened(Nut), at(Nut, Location), fewer_carrying_2_than_todo_tightened, !.
delta(22, walk(_, Location, Man), 0.009326521172848526) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), todo_tightened(Nut), at(Nut, Location), !.
delta(22, walk(_, Location, Man), 0.06662923278864655) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(22, walk(_, _, _), -0.010773803397342834) :- !.
delta(22, pickup_spanner(_, _, Man), -0.06494893799871351) :- carrying(Man, _), !.
delta(22, pickup_spanner(_, _, _), 0.00803286786959826) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 216 examples, 5 leaves
delta(23, walk(_, _, _), -0.05160001496335605) :- fewer_carrying_2_than_todo_tightened, !.
delta(23, walk(_, _, _), 0.015803368150981253) :- !.
delta(23, pickup_spanner(_, _, _), 0.038258393105219425) :- fewer_carrying_2_than_todo_tightened, !.
delta(23, pickup_spanner(_, _, _), -0.015803368150981253) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 216 examples, 10 leaves
delta(24, walk(_, Location, _), 0.03331414224719546) :- fewer_at_2_than_todo_tightened, at(_, Location), !.
delta(24, walk(_, _, _), -0.005093660905934949) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(24, walk(_, _, _), 0.001617267113473235) :- fewer_at_2_than_todo_tightened, !.
delta(24, walk(_, _, _), -0.038130182613824774) :- fewer_carrying_2_than_todo_tightened, !.
delta(24, walk(_, _, _), 0.012278548147918882) :- !.
delta(24, pickup_spanner(_, _, Man), -0.025679650841903094) :- fewer_at_2_than_todo_tightened, carrying(Man, _), !.
delta(24, pickup_spanner(_, _, _), 0.0004986416328679033) :- fewer_at_2_than_todo_tightened, !.
delta(24, pickup_spanner(_, _, _), 0.02851525815826842) :- fewer_carrying_2_than_todo_tightened, !.
delta(24, pickup_spanner(_, _, _), -0.012278548147918882) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 209 examples, 9 leaves
delta(25, walk(_, Location, Man), -0.035000735620540145) :- fewer_carrying_2_than_todo_tightened, at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(25, walk(_, Location, _), 0.02138158402517201) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), !.
delta(25, walk(_, _, _), -0.007196631800244003) :- fewer_carrying_2_than_todo_tightened, !.
delta(25, walk(_, _, _), 0.016934596339825803) :- !.
delta(25, pickup_spanner(_, _, Man), 0.035000735620540145) :- fewer_carrying_2_than_todo_tightened, carrying(Man, _), !.
delta(25, pickup_spanner(_, _, _), 0.0009577333758023301) :- fewer_carrying_2_than_todo_tightened, fewer_at_2_than_todo_tightened, !.
delta(25, pickup_spanner(_, _, _), -0.01137652963392931) :- fewer_carrying_2_than_todo_tightened, !.
delta(25, pickup_spanner(_, _, _), -0.016934596339825803) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 217 examples, 7 leaves
delta(26, walk(_, Location, _), -0.02933265301482359) :- fewer_carrying_2_than_todo_tightened, at(_, Location), !.
delta(26, walk(_, _, _), -0.0035116279198150135) :- fewer_carrying_2_than_todo_tightened, fewer_at_2_than_todo_tightened, !.
delta(26, walk(_, _, _), 0.006501391920611013) :- fewer_carrying_2_than_todo_tightened, !.
delta(26, walk(_, _, _), 0.013840217373546383) :- !.
delta(26, pickup_spanner(_, _, _), 0.025109147697398145) :- fewer_carrying_2_than_todo_tightened, !.
delta(26, pickup_spanner(_, _, _), -0.013840217373546383) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 211 examples, 5 leaves
delta(27, walk(_, _, _), -0.040105376698295635) :- fewer_carrying_2_than_todo_tightened, !.
delta(27, walk(_, _, _), 0.0151885680661784) :- !.
delta(27, pickup_spanner(_, _, _), 0.030791076019599694) :- fewer_carrying_2_than_todo_tightened, !.
delta(27, pickup_spanner(_, _, _), -0.0151885680661784) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 209 examples, 5 leaves
delta(28, walk(_, _, _), -0.03326078606308775) :- fewer_carrying_2_than_todo_tightened, !.
delta(28, walk(_, _, _), 0.013532736988208715) :- !.
delta(28, pickup_spanner(_, _, _), 0.025335397890416774) :- fewer_carrying_2_than_todo_tightened, !.
delta(28, pickup_spanner(_, _, _), -0.013532736988208715) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 204 examples, 7 leaves
delta(29, walk(_, Location, Man), 0.04862759107081358) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(29, walk(_, Location, _), -0.0011002214549014888) :- at(Locatable, Location), spanner(Locatable), !.
delta(29, walk(_, _, _), -0.02078002329791142) :- fewer_carrying_2_than_todo_tightened, !.
delta(29, walk(_, _, _), 0.011250332305685009) :- !.
delta(29, pickup_spanner(_, _, Man), -0.04232928226197566) :- carrying(Man, _), !.
delta(29, pickup_spanner(_, _, _), 0.004975807764568442) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 207 examples, 10 leaves
delta(30, walk(_, Location, _), 0.021754127062688304) :- fewer_at_2_than_todo_tightened, at(_, Location), !.
delta(30, walk(_, _, _), -0.002537580684782546) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(30, walk(_, _, _), 0.001516196123241336) :- fewer_at_2_than_todo_tightened, !.
delta(30, walk(_, _, _), -0.025256280018404253) :- fewer_carrying_2_than_todo_tightened, !.
delta(30, walk(_, _, _), 0.009633967905950419) :- !.
delta(30, pickup_spanner(_, _, Man), -0.021012585677655578) :- fewer_at_2_than_todo_tightened, carrying(Man, _), !.
delta(30, pickup_spanner(_, _, _), 0.000359185554542709) :- fewer_at_2_than_todo_tightened, !.
delta(30, pickup_spanner(_, _, _), 0.0197109368926617) :- fewer_carrying_2_than_todo_tightened, !.
delta(30, pickup_spanner(_, _, _), -0.009633967905950419) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 207 examples, 11 leaves
delta(31, walk(_, Location, _), -0.0011834164982436647) :- at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(31, walk(_, Location, _), 0.0006728640489645303) :- at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, !.
delta(31, walk(_, Location, Man), 0.02798162581547329) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(31, walk(_, Location, _), -0.0005230450070989053) :- at(Locatable, Location), spanner(Locatable), !.
delta(31, walk(_, _, _), -0.019129479639668604) :- fewer_carrying_2_than_todo_tightened, !.
delta(31, walk(_, _, _), 0.010080219234825626) :- !.
delta(31, pickup_spanner(_, _, Man), 0.005864999465047078) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(31, pickup_spanner(_, _, Man), -0.0031158912842743068) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(31, pickup_spanner(_, _, Man), -0.021584295411502016) :- carrying(Man, _), !.
delta(31, pickup_spanner(_, _, _), 0.0035452634569835377) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 208 examples, 7 leaves
delta(32, walk(_, Location, _), -0.01676147820914982) :- fewer_carrying_2_than_todo_tightened, at(_, Location), !.
delta(32, walk(_, Location, Man), 0.009664164069709866) :- fewer_carrying_2_than_todo_tightened, at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(32, walk(_, _, _), -0.0024638154956767443) :- fewer_carrying_2_than_todo_tightened, !.
delta(32, walk(_, _, _), 0.010963522803318972) :- !.
delta(32, pickup_spanner(_, _, _), 0.007352616107079655) :- fewer_carrying_2_than_todo_tightened, !.
delta(32, pickup_spanner(_, _, _), -0.010858228732308338) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 214 examples, 5 leaves
delta(33, walk(_, _, _), -0.028424465417555562) :- fewer_carrying_2_than_todo_tightened, !.
delta(33, walk(_, _, _), 0.011911380174358291) :- !.
delta(33, pickup_spanner(_, _, _), 0.02197672559073993) :- fewer_carrying_2_than_todo_tightened, !.
delta(33, pickup_spanner(_, _, _), -0.011911380174358291) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 213 examples, 8 leaves
delta(34, walk(_, _, _), 0.01894101382845681) :- fewer_at_2_than_todo_tightened, !.
delta(34, walk(_, _, _), -0.025082867052153825) :- fewer_carrying_2_than_todo_tightened, !.
delta(34, walk(_, _, _), 0.00728866855294061) :- !.
delta(34, pickup_spanner(_, _, Man), -0.01907070912871551) :- fewer_at_2_than_todo_tightened, carrying(Man, _), !.
delta(34, pickup_spanner(_, _, _), 0.0003047984851084687) :- fewer_at_2_than_todo_tightened, !.
delta(34, pickup_spanner(_, _, _), 0.018042389253227327) :- fewer_carrying_2_than_todo_tightened, !.
delta(34, pickup_spanner(_, _, _), -0.00728866855294061) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 201 examples, 5 leaves
delta(35, walk(_, _, _), -0.024194605919766136) :- fewer_carrying_2_than_todo_tightened, !.
delta(35, walk(_, _, _), 0.011438912776036236) :- !.
delta(35, pickup_spanner(_, _, _), 0.01911433811995639) :- fewer_carrying_2_than_todo_tightened, !.
delta(35, pickup_spanner(_, _, _), -0.011438912776036236) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 210 examples, 5 leaves
delta(36, walk(_, _, _), -0.02585701573621365) :- fewer_carrying_2_than_todo_tightened, !.
delta(36, walk(_, _, _), 0.009891225339759427) :- !.
delta(36, pickup_spanner(_, _, _), 0.018709955516827092) :- fewer_carrying_2_than_todo_tightened, !.
delta(36, pickup_spanner(_, _, _), -0.009891225339759427) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 212 examples, 10 leaves
delta(37, walk(_, Location, _), -0.014861572240745333) :- at(_, Location), fewer_carrying_2_than_todo_tightened, !.
delta(37, walk(_, Location, _), 0.006111081230545026) :- at(_, Location), !.
delta(37, walk(_, Location, Man), -0.0007737280203639727) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(37, walk(_, Location, Man), 0.2582218140934822) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(37, walk(_, _, _), -0.0019707937226020253) :- !.
delta(37, pickup_spanner(_, _, Man), 0.002904462376208045) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(37, pickup_spanner(_, _, Man), -0.0038896763956611426) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(37, pickup_spanner(_, _, Man), -0.24452304967719055) :- carrying(Man, _), !.
delta(37, pickup_spanner(_, _, _), 0.0034081718214796766) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 201 examples, 5 leaves
delta(38, walk(_, _, _), -0.026826439150951495) :- fewer_carrying_2_than_todo_tightened, !.
delta(38, walk(_, _, _), 0.009231957083438738) :- !.
delta(38, pickup_spanner(_, _, _), 0.021441977641874745) :- fewer_carrying_2_than_todo_tightened, !.
delta(38, pickup_spanner(_, _, _), -0.009231957083438738) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 210 examples, 5 leaves
delta(39, walk(_, _, _), -0.026886216636201686) :- fewer_carrying_2_than_todo_tightened, !.
delta(39, walk(_, _, _), 0.00896270060032948) :- !.
delta(39, pickup_spanner(_, _, _), 0.026886216636201686) :- fewer_carrying_2_than_todo_tightened, !.
delta(39, pickup_spanner(_, _, _), -0.00896270060032948) :- !.
delta(39, _, 0.0).

% tree 40: step size 1.0, 209 examples, 5 leaves
delta(40, walk(_, _, _), -0.028210079306495512) :- fewer_carrying_2_than_todo_tightened, !.
delta(40, walk(_, _, _), 0.008684741835835669) :- !.
delta(40, pickup_spanner(_, _, _), 0.019967507882646354) :- fewer_carrying_2_than_todo_tightened, !.
delta(40, pickup_spanner(_, _, _), -0.00868474183583567) :- !.
delta(40, _, 0.0).

% tree 41: step size 1.0, 207 examples, 5 leaves
delta(41, walk(_, _, _), -0.025433374846251643) :- fewer_carrying_2_than_todo_tightened, !.
delta(41, walk(_, _, _), 0.006788525389184372) :- !.
delta(41, pickup_spanner(_, _, _), 0.020396599489632867) :- fewer_carrying_2_than_todo_tightened, !.
delta(41, pickup_spanner(_, _, _), -0.006788525389184372) :- !.
delta(41, _, 0.0).

% tree 42: step size 1.0, 203 examples, 7 leaves
delta(42, walk(_, Location, Man), 0.011550086901323234) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(42, walk(_, Location, _), -0.000426584693018411) :- at(Locatable, Location), spanner(Locatable), !.
delta(42, walk(_, _, _), -0.015707710744768486) :- fewer_carrying_2_than_todo_tightened, !.
delta(42, walk(_, _, _), 0.006569372960817117) :- !.
delta(42, pickup_spanner(_, _, _), 0.004918330723225252) :- fewer_carrying_2_than_todo_tightened, !.
delta(42, pickup_spanner(_, _, _), -0.007952584340630882) :- !.
delta(42, _, 0.0).

% tree 43: step size 1.0, 202 examples, 5 leaves
delta(43, walk(_, _, _), -0.019147430385990843) :- fewer_carrying_2_than_todo_tightened, !.
delta(43, walk(_, _, _), 0.008032290219095685) :- !.
delta(43, pickup_spanner(_, _, _), 0.015646706021227898) :- fewer_carrying_2_than_todo_tightened, !.
delta(43, pickup_spanner(_, _, _), -0.008032290219095685) :- !.
delta(43, _, 0.0).

% tree 44: step size 1.0, 207 examples, 5 leaves
delta(44, walk(_, _, _), -0.021302800021207147) :- fewer_carrying_2_than_todo_tightened, !.
delta(44, walk(_, _, _), 0.007405925901590553) :- !.
delta(44, pickup_spanner(_, _, _), 0.017309698324200883) :- fewer_carrying_2_than_todo_tightened, !.
delta(44, pickup_spanner(_, _, _), -0.007405925901590553) :- !.
delta(44, _, 0.0).

% tree 45: step size 1.0, 211 examples, 5 leaves
delta(45, walk(_, _, _), -0.020763075050758886) :- fewer_carrying_2_than_todo_tightened, !.
delta(45, walk(_, _, _), 0.006550271843608405) :- !.
delta(45, pickup_spanner(_, _, _), 0.017069466961310224) :- fewer_carrying_2_than_todo_tightened, !.
delta(45, pickup_spanner(_, _, _), -0.006550271843608405) :- !.
delta(45, _, 0.0).

% tree 46: step size 1.0, 207 examples, 5 leaves
delta(46, walk(_, _, _), -0.01725605581188872) :- fewer_carrying_2_than_todo_tightened, !.
delta(46, walk(_, _, _), 0.007089119664897883) :- !.
delta(46, pickup_spanner(_, _, _), 0.012042031600117681) :- fewer_carrying_2_than_todo_tightened, !.
delta(46, pickup_spanner(_, _, _), -0.007089119664897883) :- !.
delta(46, _, 0.0).

% tree 47: step size 1.0, 215 examples, 5 leaves
delta(47, walk(_, _, _), -0.01611370347873116) :- fewer_carrying_2_than_todo_tightened, !.
delta(47, walk(_, _, _), 0.005408968615314909) :- !.
delta(47, pickup_spanner(_, _, _), 0.01594561694884193) :- fewer_carrying_2_than_todo_tightened, !.
delta(47, pickup_spanner(_, _, _), -0.005408968615314909) :- !.
delta(47, _, 0.0).

% tree 48: step size 1.0, 203 examples, 10 leaves
delta(48, walk(_, Location, Man), -0.0020114403405609937) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(48, walk(_, Location, Man), 0.001701445768699311) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(48, walk(_, Location, Man), -0.0004062583207397182) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), todo_tightened(Nut), at(Nut, Location), !.
delta(48, walk(_, Location, Man), 0.01840162533265776) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(48, walk(_, _, _), -0.0021380732876277223) :- !.
delta(48, pickup_spanner(_, _, Man), 0.0019675785821105978) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(48, pickup_spanner(_, _, Man), -0.001701445768699311) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(48, pickup_spanner(_, _, Man), -0.01783323808013198) :- carrying(Man, _), !.
delta(48, pickup_spanner(_, _, _), 0.0021380732876277223) :- !.
delta(48, _, 0.0).

% tree 49: step size 1.0, 212 examples, 5 leaves
delta(49, walk(_, _, _), -0.018877111473231307) :- fewer_carrying_2_than_todo_tightened, !.
delta(49, walk(_, _, _), 0.00614530826148899) :- !.
delta(49, pickup_spanner(_, _, _), 0.01868646288342853) :- fewer_carrying_2_than_todo_tightened, !.
delta(49, pickup_spanner(_, _, _), -0.00614530826148899) :- !.
delta(49, _, 0.0).

% tree 50: step size 1.0, 216 examples, 8 leaves
delta(50, walk(_, Location, _), -0.010219355286250316) :- at(_, Location), fewer_carrying_2_than_todo_tightened, !.
delta(50, walk(_, Location, _), 0.0037672871417187472) :- at(_, Location), !.
delta(50, walk(_, Location, Man), -0.0005158761951441869) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(50, walk(_, Location, Man), 0.009112968146057202) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(50, walk(_, _, _), -0.0009976275180521065) :- !.
delta(50, pickup_spanner(_, _, _), 0.004585234934086659) :- fewer_carrying_2_than_todo_tightened, !.
delta(50, pickup_spanner(_, _, _), -0.005850491406247856) :- !.
delta(50, _, 0.0).

% tree 51: step size 1.0, 213 examples, 7 leaves
delta(51, walk(_, Location, Man), 0.00972110275915901) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(51, walk(_, Location, _), -0.00023216427729627376) :- at(Locatable, Location), spanner(Locatable), !.
delta(51, walk(_, _, _), -0.011501950273175573) :- fewer_carrying_2_than_todo_tightened, !.
delta(51, walk(_, _, _), 0.004378542751468237) :- !.
delta(51, pickup_spanner(_, _, _), 0.002949093593535972) :- fewer_carrying_2_than_todo_tightened, !.
delta(51, pickup_spanner(_, _, _), -0.005262138452981962) :- !.
delta(51, _, 0.0).

% tree 52: step size 1.0, 218 examples, 5 leaves
delta(52, walk(_, _, _), -0.01687288483719252) :- fewer_carrying_2_than_todo_tightened, !.
delta(52, walk(_, _, _), 0.005446624806448716) :- !.
delta(52, pickup_spanner(_, _, _), 0.014757201791954461) :- fewer_carrying_2_than_todo_tightened, !.
delta(52, pickup_spanner(_, _, _), -0.005446624806448716) :- !.
delta(52, _, 0.0).

% tree 53: step size 1.0, 210 examples, 5 leaves
delta(53, walk(_, _, _), -0.013443252442259114) :- fewer_carrying_2_than_todo_tightened, !.
delta(53, walk(_, _, _), 0.005894088764230859) :- !.
delta(53, pickup_spanner(_, _, _), 0.012201898004624076) :- fewer_carrying_2_than_todo_tightened, !.
delta(53, pickup_spanner(_, _, _), -0.005894088764230859) :- !.
delta(53, _, 0.0).

% tree 54: step size 1.0, 212 examples, 5 leaves
delta(54, walk(_, _, _), -0.01617817389158413) :- fewer_carrying_2_than_todo_tightened, !.
delta(54, walk(_, _, _), 0.004473293566215411) :- !.
delta(54, pickup_spanner(_, _, _), 0.014580281073313932) :- fewer_carrying_2_than_todo_tightened, !.
delta(54, pickup_spanner(_, _, _), -0.004473293566215411) :- !.
delta(54, _, 0.0).

% tree 55: step size 1.0, 202 examples, 5 leaves
delta(55, walk(_, _, _), -0.011992981144851485) :- fewer_carrying_2_than_todo_tightened, !.
delta(55, walk(_, _, _), 0.0057867743484650205) :- !.
delta(55, pickup_spanner(_, _, _), 0.011936634380035296) :- fewer_carrying_2_than_todo_tightened, !.
delta(55, pickup_spanner(_, _, _), -0.0057867743484650205) :- !.
delta(55, _, 0.0).

% tree 56: step size 1.0, 216 examples, 5 leaves
delta(56, walk(_, _, _), -0.013757695332412058) :- fewer_carrying_2_than_todo_tightened, !.
delta(56, walk(_, _, _), 0.0049299333836120415) :- !.
delta(56, pickup_spanner(_, _, _), 0.01363094836863197) :- fewer_carrying_2_than_todo_tightened, !.
delta(56, pickup_spanner(_, _, _), -0.0049299333836120415) :- !.
delta(56, _, 0.0).

% tree 57: step size 1.0, 212 examples, 5 leaves
delta(57, walk(_, _, _), -0.011062296812108298) :- fewer_carrying_2_than_todo_tightened, !.
delta(57, walk(_, _, _), 0.004992135973475166) :- !.
delta(57, pickup_spanner(_, _, _), 0.009732535288161863) :- fewer_carrying_2_than_todo_tightened, !.
delta(57, pickup_spanner(_, _, _), -0.004992135973475166) :- !.
delta(57, _, 0.0).

% tree 58: step size 1.0, 220 examples, 5 leaves
delta(58, walk(_, _, _), -0.012071727476039188) :- fewer_carrying_2_than_todo_tightened, !.
delta(58, walk(_, _, _), 0.005651865902359184) :- !.
delta(58, pickup_spanner(_, _, _), 0.011067625667407145) :- fewer_carrying_2_than_todo_tightened, !.
delta(58, pickup_spanner(_, _, _), -0.005651865902359184) :- !.
delta(58, _, 0.0).

% tree 59: step size 1.0, 209 examples, 5 leaves
delta(59, walk(_, _, _), -0.011520468935645229) :- fewer_carrying_2_than_todo_tightened, !.
delta(59, walk(_, _, _), 0.004321250195401548) :- !.
delta(59, pickup_spanner(_, _, _), 0.01146908112292427) :- fewer_carrying_2_than_todo_tightened, !.
delta(59, pickup_spanner(_, _, _), -0.004321250195401548) :- !.
delta(59, _, 0.0).

% tree 60: step size 1.0, 219 examples, 7 leaves
delta(60, walk(_, Location, Man), -0.002062208033663396) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), todo_tightened(Nut), at(Nut, Location), fewer_carrying_2_than_todo_tightened, !.
delta(60, walk(_, Location, Man), 0.002363390981860974) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), todo_tightened(Nut), at(Nut, Location), !.
delta(60, walk(_, Location, Man), 0.2643869647467742) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(60, walk(_, _, _), -0.0015322472040182917) :- !.
delta(60, pickup_spanner(_, _, Man), -0.2602891808491169) :- carrying(Man, _), !.
delta(60, pickup_spanner(_, _, _), 0.0014065442695610992) :- !.
delta(60, _, 0.0).

% tree 61: step size 1.0, 217 examples, 5 leaves
delta(61, walk(_, _, _), -0.015522321461992153) :- fewer_carrying_2_than_todo_tightened, !.
delta(61, walk(_, _, _), 0.0028353955772362906) :- !.
delta(61, pickup_spanner(_, _, _), 0.014110297177101846) :- fewer_carrying_2_than_todo_tightened, !.
delta(61, pickup_spanner(_, _, _), -0.0028353955772362906) :- !.
delta(61, _, 0.0).

% tree 62: step size 1.0, 205 examples, 5 leaves
delta(62, walk(_, _, _), -0.01698368814624239) :- fewer_carrying_2_than_todo_tightened, !.
delta(62, walk(_, _, _), 0.0027870763527456863) :- !.
delta(62, pickup_spanner(_, _, _), 0.01691112579868214) :- fewer_carrying_2_than_todo_tightened, !.
delta(62, pickup_spanner(_, _, _), -0.0027870763527456863) :- !.
delta(62, _, 0.0).

% tree 63: step size 1.0, 216 examples, 9 leaves
delta(63, walk(_, Location, Man), -0.00222670404796972) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(63, walk(_, Location, Man), 0.0013851872218658924) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(63, walk(_, Location, Man), 0.015624765607743462) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(63, walk(_, _, _), -0.001454996598905675) :- !.
delta(63, pickup_spanner(_, _, Man), 0.0021774064922606517) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(63, pickup_spanner(_, _, Man), -0.0013851872218658924) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(63, pickup_spanner(_, _, Man), -0.015624765607743462) :- carrying(Man, _), !.
delta(63, pickup_spanner(_, _, _), 0.0013396437886647552) :- !.
delta(63, _, 0.0).

% tree 64: step size 1.0, 209 examples, 5 leaves
delta(64, walk(_, _, _), -0.016257313817076076) :- fewer_carrying_2_than_todo_tightened, !.
delta(64, walk(_, _, _), 0.0024720555006843815) :- !.
delta(64, pickup_spanner(_, _, _), 0.014942375899620927) :- fewer_carrying_2_than_todo_tightened, !.
delta(64, pickup_spanner(_, _, _), -0.0024720555006843815) :- !.
delta(64, _, 0.0).

% tree 65: step size 1.0, 211 examples, 9 leaves
delta(65, walk(_, Location, _), -0.0005012161310849082) :- at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(65, walk(_, Location, _), 0.00013100755677327404) :- at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, !.
delta(65, walk(_, Location, Man), 0.005480738760045677) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(65, walk(_, Location, _), -0.00011827762171017048) :- at(Locatable, Location), spanner(Locatable), !.
delta(65, walk(_, _, _), -0.007425722379325704) :- fewer_carrying_2_than_todo_tightened, !.
delta(65, walk(_, _, _), 0.002421641976138606) :- !.
delta(65, pickup_spanner(_, _, _), 0.002893822666300821) :- fewer_carrying_2_than_todo_tightened, !.
delta(65, pickup_spanner(_, _, _), -0.0029176737608512314) :- !.
delta(65, _, 0.0).

% tree 66: step size 1.0, 203 examples, 5 leaves
delta(66, walk(_, _, _), -0.014509172188542679) :- fewer_carrying_2_than_todo_tightened, !.
delta(66, walk(_, _, _), 0.0024108219400985655) :- !.
delta(66, pickup_spanner(_, _, _), 0.014449939527532485) :- fewer_carrying_2_than_todo_tightened, !.
delta(66, pickup_spanner(_, _, _), -0.0024108219400985655) :- !.
delta(66, _, 0.0).

% tree 67: step size 1.0, 212 examples, 5 leaves
delta(67, walk(_, _, _), -0.015284070261885621) :- fewer_carrying_2_than_todo_tightened, !.
delta(67, walk(_, _, _), 0.0023921886271626516) :- !.
delta(67, pickup_spanner(_, _, _), 0.015062538006941113) :- fewer_carrying_2_than_todo_tightened, !.
delta(67, pickup_spanner(_, _, _), -0.0023921886271626516) :- !.
delta(67, _, 0.0).

% tree 68: step size 1.0, 205 examples, 7 leaves
delta(68, walk(_, Location, Man), 0.006673404178671723) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(68, walk(_, Location, _), -0.0001845442865623296) :- at(Locatable, Location), spanner(Locatable), !.
delta(68, walk(_, _, _), -0.007829815979365214) :- fewer_carrying_2_than_todo_tightened, !.
delta(68, walk(_, _, _), 0.0020793385696448704) :- !.
delta(68, pickup_spanner(_, _, _), 0.0015841598061454433) :- fewer_carrying_2_than_todo_tightened, !.
delta(68, pickup_spanner(_, _, _), -0.002452089389773005) :- !.
delta(68, _, 0.0).

% tree 69: step size 1.0, 209 examples, 5 leaves
delta(69, walk(_, _, _), -0.012719454652926673) :- fewer_carrying_2_than_todo_tightened, !.
delta(69, walk(_, _, _), 0.002579375313257142) :- !.
delta(69, pickup_spanner(_, _, _), 0.010674943196125785) :- fewer_carrying_2_than_todo_tightened, !.
delta(69, pickup_spanner(_, _, _), -0.002579375313257142) :- !.
delta(69, _, 0.0).

% tree 70: step size 1.0, 220 examples, 5 leaves
delta(70, walk(_, _, _), -0.012058965629996414) :- fewer_carrying_2_than_todo_tightened, !.
delta(70, walk(_, _, _), 0.0023023025196233717) :- !.
delta(70, pickup_spanner(_, _, _), 0.01196504835386192) :- fewer_carrying_2_than_todo_tightened, !.
delta(70, pickup_spanner(_, _, _), -0.0023023025196233717) :- !.
delta(70, _, 0.0).

% tree 71: step size 1.0, 208 examples, 5 leaves
delta(71, walk(_, _, _), -0.012166939685635439) :- fewer_carrying_2_than_todo_tightened, !.
delta(71, walk(_, _, _), 0.0025034020890402652) :- !.
delta(71, pickup_spanner(_, _, _), 0.012090322999001863) :- fewer_carrying_2_than_todo_tightened, !.
delta(71, pickup_spanner(_, _, _), -0.0025034020890402652) :- !.
delta(71, _, 0.0).

% tree 72: step size 1.0, 209 examples, 5 leaves
delta(72, walk(_, _, _), -0.010675792738061112) :- fewer_carrying_2_than_todo_tightened, !.
delta(72, walk(_, _, _), 0.002181105931958544) :- !.
delta(72, pickup_spanner(_, _, _), 0.010554090531365537) :- fewer_carrying_2_than_todo_tightened, !.
delta(72, pickup_spanner(_, _, _), -0.002181105931958544) :- !.
delta(72, _, 0.0).

% tree 73: step size 1.0, 203 examples, 5 leaves
delta(73, walk(_, _, _), -0.010180839518051153) :- fewer_carrying_2_than_todo_tightened, !.
delta(73, walk(_, _, _), 0.0024161912562080494) :- !.
delta(73, pickup_spanner(_, _, _), 0.010103970905098332) :- fewer_carrying_2_than_todo_tightened, !.
delta(73, pickup_spanner(_, _, _), -0.0024031620747596866) :- !.
delta(73, _, 0.0).

% tree 74: step size 1.0, 207 examples, 5 leaves
delta(74, walk(_, _, _), -0.010654868186055664) :- fewer_carrying_2_than_todo_tightened, !.
delta(74, walk(_, _, _), 0.0020826981045464804) :- !.
delta(74, pickup_spanner(_, _, _), 0.009853160136252944) :- fewer_carrying_2_than_todo_tightened, !.
delta(74, pickup_spanner(_, _, _), -0.0020826981045464804) :- !.
delta(74, _, 0.0).

% tree 75: step size 1.0, 216 examples, 10 leaves
delta(75, walk(_, Location, _), -0.00010749100776150954) :- at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, !.
delta(75, walk(_, Location, Man), 0.20860023029873756) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(75, walk(_, Location, _), -0.00010407640273028345) :- at(Locatable, Location), spanner(Locatable), !.
delta(75, walk(_, _, _), -0.007307886093996516) :- fewer_carrying_2_than_todo_tightened, !.
delta(75, walk(_, _, _), 0.0018217833738839988) :- !.
delta(75, pickup_spanner(_, _, _), 0.0011666033369593374) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(75, pickup_spanner(_, _, _), -0.0005712902707436825) :- fewer_at_2_than_todo_tightened, !.
delta(75, pickup_spanner(_, _, Man), -0.20278546504861422) :- carrying(Man, _), !.
delta(75, pickup_spanner(_, _, _), 0.0007260329870937583) :- !.
delta(75, _, 0.0).

% tree 76: step size 1.0, 203 examples, 11 leaves
delta(76, walk(_, Location, _), -0.007414059985996822) :- at(_, Location), fewer_carrying_2_than_todo_tightened, !.
delta(76, walk(_, Location, _), 0.0012865472261246193) :- at(_, Location), !.
delta(76, walk(_, _, _), -0.0009673275856493927) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(76, walk(_, _, _), 0.00038493787037581246) :- fewer_at_2_than_todo_tightened, !.
delta(76, walk(_, Location, Man), 0.012420722044416563) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(76, walk(_, _, _), -0.00041146858471998517) :- !.
delta(76, pickup_spanner(_, _, Man), 0.001161738071607488) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(76, pickup_spanner(_, _, Man), -0.0009606128143486165) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(76, pickup_spanner(_, _, Man), -0.006548758979480818) :- carrying(Man, _), !.
delta(76, pickup_spanner(_, _, _), 0.0010265590019621687) :- !.
delta(76, _, 0.0).

% tree 77: step size 1.0, 204 examples, 7 leaves
delta(77, walk(_, Location, Man), 0.011185060019203597) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(77, walk(_, Location, _), -0.00020191588904339543) :- at(Locatable, Location), spanner(Locatable), !.
delta(77, walk(_, _, _), -0.004991439352139034) :- fewer_carrying_2_than_todo_tightened, !.
delta(77, walk(_, _, _), 0.0018808037222942018) :- !.
delta(77, pickup_spanner(_, _, Man), -0.007493534295076572) :- carrying(Man, _), !.
delta(77, pickup_spanner(_, _, _), 0.0009981907251832992) :- !.
delta(77, _, 0.0).

% tree 78: step size 1.0, 202 examples, 11 leaves
delta(78, walk(_, Location, _), -0.0017846875448750878) :- todo_tightened(Nut), at(Nut, Location), fewer_carrying_2_than_todo_tightened, !.
delta(78, walk(_, Location, _), 0.0010616429608690942) :- todo_tightened(Nut), at(Nut, Location), !.
delta(78, walk(_, _, _), -0.0011629190982340857) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(78, walk(_, _, _), 0.0003912573345830598) :- fewer_at_2_than_todo_tightened, !.
delta(78, walk(_, Location, Man), 0.15311756013660782) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(78, walk(_, _, _), -0.00044621423148204464) :- !.
delta(78, pickup_spanner(_, _, Man), 0.00115029611362928) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(78, pickup_spanner(_, _, Man), -0.0006714685379921973) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(78, pickup_spanner(_, _, Man), -0.1520819481074496) :- carrying(Man, _), !.
delta(78, pickup_spanner(_, _, _), 0.0006991326278270622) :- !.
delta(78, _, 0.0).

% tree 79: step size 1.0, 209 examples, 5 leaves
delta(79, walk(_, _, _), -0.015791406594116753) :- fewer_carrying_2_than_todo_tightened, !.
delta(79, walk(_, _, _), 0.001798120310544351) :- !.
delta(79, pickup_spanner(_, _, _), 0.01573553277336641) :- fewer_carrying_2_than_todo_tightened, !.
delta(79, pickup_spanner(_, _, _), -0.001798120310544351) :- !.
delta(79, _, 0.0).

% tree 80: step size 1.0, 201 examples, 7 leaves
delta(80, walk(_, Location, Man), 0.0026190302653246846) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(80, walk(_, Location, _), -9.464849270633089e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(80, walk(_, _, _), -0.010957210521767312) :- fewer_carrying_2_than_todo_tightened, !.
delta(80, walk(_, _, _), 0.0015652844027555588) :- !.
delta(80, pickup_spanner(_, _, _), 0.008563829970201355) :- fewer_carrying_2_than_todo_tightened, !.
delta(80, pickup_spanner(_, _, _), -0.0018176502350489576) :- !.
delta(80, _, 0.0).

% tree 81: step size 1.0, 216 examples, 10 leaves
delta(81, walk(_, Location, _), 0.010652501010165547) :- fewer_at_2_than_todo_tightened, at(_, Location), !.
delta(81, walk(_, _, _), -0.0005862226957386021) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(81, walk(_, _, _), 0.00023070741310631448) :- fewer_at_2_than_todo_tightened, !.
delta(81, walk(_, _, _), -0.014275905141536026) :- fewer_carrying_2_than_todo_tightened, !.
delta(81, walk(_, _, _), 0.0009681410053172302) :- !.
delta(81, pickup_spanner(_, _, Man), -0.009361045572876264) :- fewer_at_2_than_todo_tightened, carrying(Man, _), !.
delta(81, pickup_spanner(_, _, _), 5.301393716891718e-5) :- fewer_at_2_than_todo_tightened, !.
delta(81, pickup_spanner(_, _, _), 0.014275905141536026) :- fewer_carrying_2_than_todo_tightened, !.
delta(81, pickup_spanner(_, _, _), -0.0009681410053172302) :- !.
delta(81, _, 0.0).

% tree 82: step size 1.0, 205 examples, 5 leaves
delta(82, walk(_, _, _), -0.015666040502578492) :- fewer_carrying_2_than_todo_tightened, !.
delta(82, walk(_, _, _), 0.001964555550322427) :- !.
delta(82, pickup_spanner(_, _, _), 0.015666040502578492) :- fewer_carrying_2_than_todo_tightened, !.
delta(82, pickup_spanner(_, _, _), -0.001964555550322427) :- !.
delta(82, _, 0.0).

% tree 83: step size 1.0, 210 examples, 5 leaves
delta(83, walk(_, _, _), -0.013893482771688616) :- fewer_carrying_2_than_todo_tightened, !.
delta(83, walk(_, _, _), 0.0015437682388805855) :- !.
delta(83, pickup_spanner(_, _, _), 0.013846154938773819) :- fewer_carrying_2_than_todo_tightened, !.
delta(83, pickup_spanner(_, _, _), -0.0015437682388805855) :- !.
delta(83, _, 0.0).

% tree 84: step size 1.0, 202 examples, 5 leaves
delta(84, walk(_, _, _), -0.017214188299246) :- fewer_carrying_2_than_todo_tightened, !.
delta(84, walk(_, _, _), 0.0017538134881482953) :- !.
delta(84, pickup_spanner(_, _, _), 0.017156310482348745) :- fewer_carrying_2_than_todo_tightened, !.
delta(84, pickup_spanner(_, _, _), -0.0017538134881482953) :- !.
delta(84, _, 0.0).

% tree 85: step size 1.0, 204 examples, 5 leaves
delta(85, walk(_, _, _), -0.010336597913679418) :- fewer_carrying_2_than_todo_tightened, !.
delta(85, walk(_, _, _), 0.0014454876439044385) :- !.
delta(85, pickup_spanner(_, _, _), 0.010336597913679418) :- fewer_carrying_2_than_todo_tightened, !.
delta(85, pickup_spanner(_, _, _), -0.0014454876439044385) :- !.
delta(85, _, 0.0).

% tree 86: step size 1.0, 202 examples, 5 leaves
delta(86, walk(_, _, _), -0.00889093481648294) :- fewer_carrying_2_than_todo_tightened, !.
delta(86, walk(_, _, _), 0.0013730391781771423) :- !.
delta(86, pickup_spanner(_, _, _), 0.008802802731894693) :- fewer_carrying_2_than_todo_tightened, !.
delta(86, pickup_spanner(_, _, _), -0.0013730391781771423) :- !.
delta(86, _, 0.0).

% tree 87: step size 1.0, 202 examples, 5 leaves
delta(87, walk(_, _, _), -0.013289317255354505) :- fewer_carrying_2_than_todo_tightened, !.
delta(87, walk(_, _, _), 0.0015088504919212023) :- !.
delta(87, pickup_spanner(_, _, _), 0.013289317255354505) :- fewer_carrying_2_than_todo_tightened, !.
delta(87, pickup_spanner(_, _, _), -0.0015088504919212023) :- !.
delta(87, _, 0.0).

% tree 88: step size 1.0, 214 examples, 5 leaves
delta(88, walk(_, _, _), -0.010780746828347482) :- fewer_carrying_2_than_todo_tightened, !.
delta(88, walk(_, _, _), 0.0014636762888316785) :- !.
delta(88, pickup_spanner(_, _, _), 0.010710727401273852) :- fewer_carrying_2_than_todo_tightened, !.
delta(88, pickup_spanner(_, _, _), -0.0014636762888316785) :- !.
delta(88, _, 0.0).

% tree 89: step size 1.0, 201 examples, 5 leaves
delta(89, walk(_, _, _), -0.008521384965278118) :- fewer_carrying_2_than_todo_tightened, !.
delta(89, walk(_, _, _), 0.0014315980856278807) :- !.
delta(89, pickup_spanner(_, _, _), 0.007804863434713355) :- fewer_carrying_2_than_todo_tightened, !.
delta(89, pickup_spanner(_, _, _), -0.001425010241692496) :- !.
delta(89, _, 0.0).

% tree 90: step size 1.0, 201 examples, 5 leaves
delta(90, walk(_, _, _), -0.010221987799009513) :- fewer_carrying_2_than_todo_tightened, !.
delta(90, walk(_, _, _), 0.0015524879951919572) :- !.
delta(90, pickup_spanner(_, _, _), 0.010136303482753257) :- fewer_carrying_2_than_todo_tightened, !.
delta(90, pickup_spanner(_, _, _), -0.0015524879951919572) :- !.
delta(90, _, 0.0).

% tree 91: step size 1.0, 204 examples, 8 leaves
delta(91, walk(_, Location, Man), -1.978255912510816e-5) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(91, walk(_, Location, Man), 0.009366925509170322) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(91, walk(_, Location, _), -7.710908211280101e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(91, walk(_, _, _), -0.004894492737749531) :- fewer_carrying_2_than_todo_tightened, !.
delta(91, walk(_, _, _), 0.0013432039018898977) :- !.
delta(91, pickup_spanner(_, _, Man), -0.00599745153178754) :- carrying(Man, _), !.
delta(91, pickup_spanner(_, _, _), 0.00039112517671165755) :- !.
delta(91, _, 0.0).

% tree 92: step size 1.0, 214 examples, 11 leaves
delta(92, walk(_, Location, _), -9.009608380903965e-5) :- at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, fewer_usable_than_at_1, !.
delta(92, walk(_, Location, _), 5.7054493495456366e-5) :- at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, !.
delta(92, walk(_, Location, Man), 0.009540225858600529) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(92, walk(_, Location, _), -2.1823674025796336e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(92, walk(_, _, _), -0.006798374140780841) :- fewer_carrying_2_than_todo_tightened, !.
delta(92, walk(_, _, _), 0.0013210707805365609) :- !.
delta(92, pickup_spanner(_, _, Man), 0.000989654857411374) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(92, pickup_spanner(_, _, Man), -0.0006965232569027335) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(92, pickup_spanner(_, _, Man), -0.004452925523395669) :- carrying(Man, _), !.
delta(92, pickup_spanner(_, _, _), 0.0004530182540813585) :- !.
delta(92, _, 0.0).

% tree 93: step size 1.0, 203 examples, 5 leaves
delta(93, walk(_, _, _), -0.01332579057817798) :- fewer_carrying_2_than_todo_tightened, !.
delta(93, walk(_, _, _), 0.0013290079471163741) :- !.
delta(93, pickup_spanner(_, _, _), 0.013284413371023419) :- fewer_carrying_2_than_todo_tightened, !.
delta(93, pickup_spanner(_, _, _), -0.0013290079471163741) :- !.
delta(93, _, 0.0).

% tree 94: step size 1.0, 202 examples, 5 leaves
delta(94, walk(_, _, _), -0.008256462654183625) :- fewer_carrying_2_than_todo_tightened, !.
delta(94, walk(_, _, _), 0.0011040659730735282) :- !.
delta(94, pickup_spanner(_, _, _), 0.0082156735906367) :- fewer_carrying_2_than_todo_tightened, !.
delta(94, pickup_spanner(_, _, _), -0.0010992075833098339) :- !.
delta(94, _, 0.0).

% tree 95: step size 1.0, 215 examples, 5 leaves
delta(95, walk(_, _, _), -0.010084216807102343) :- fewer_carrying_2_than_todo_tightened, !.
delta(95, walk(_, _, _), 0.0016870249987874992) :- !.
delta(95, pickup_spanner(_, _, _), 0.010022675413502753) :- fewer_carrying_2_than_todo_tightened, !.
delta(95, pickup_spanner(_, _, _), -0.0016870249987874992) :- !.
delta(95, _, 0.0).

% tree 96: step size 1.0, 212 examples, 5 leaves
delta(96, walk(_, _, _), -0.011145564120464373) :- fewer_carrying_2_than_todo_tightened, !.
delta(96, walk(_, _, _), 0.0014431303195807433) :- !.
delta(96, pickup_spanner(_, _, _), 0.011064356291870745) :- fewer_carrying_2_than_todo_tightened, !.
delta(96, pickup_spanner(_, _, _), -0.0014431303195807433) :- !.
delta(96, _, 0.0).

% tree 97: step size 1.0, 201 examples, 5 leaves
delta(97, walk(_, _, _), -0.009462779649132343) :- fewer_carrying_2_than_todo_tightened, !.
delta(97, walk(_, _, _), 0.0015232215853680637) :- !.
delta(97, pickup_spanner(_, _, _), 0.009434296869928756) :- fewer_carrying_2_than_todo_tightened, !.
delta(97, pickup_spanner(_, _, _), -0.0015232215853680637) :- !.
delta(97, _, 0.0).

% tree 98: step size 1.0, 201 examples, 5 leaves
delta(98, walk(_, _, _), -0.01043136563816805) :- fewer_carrying_2_than_todo_tightened, !.
delta(98, walk(_, _, _), 0.0012201899820297897) :- !.
delta(98, pickup_spanner(_, _, _), 0.010387437377357221) :- fewer_carrying_2_than_todo_tightened, !.
delta(98, pickup_spanner(_, _, _), -0.0012201899820297897) :- !.
delta(98, _, 0.0).

% tree 99: step size 1.0, 203 examples, 5 leaves
delta(99, walk(_, _, _), -0.007742678681980969) :- fewer_carrying_2_than_todo_tightened, !.
delta(99, walk(_, _, _), 0.0011745087670513344) :- !.
delta(99, pickup_spanner(_, _, _), 0.007222340144570297) :- fewer_carrying_2_than_todo_tightened, !.
delta(99, pickup_spanner(_, _, _), -0.0011745087670513344) :- !.
delta(99, _, 0.0).

% tree 100: step size 1.0, 209 examples, 10 leaves
delta(100, walk(_, Location, _), 0.008491890648677263) :- fewer_at_2_than_todo_tightened, at(_, Location), !.
delta(100, walk(_, _, _), -0.0002358806961988356) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(100, walk(_, _, _), 7.977444768395176e-5) :- fewer_at_2_than_todo_tightened, !.
delta(100, walk(_, _, _), -0.0071410153697690605) :- fewer_carrying_2_than_todo_tightened, !.
delta(100, walk(_, _, _), 0.0007411937498530207) :- !.
delta(100, pickup_spanner(_, _, Man), -0.007895709070502435) :- fewer_at_2_than_todo_tightened, carrying(Man, _), !.
delta(100, pickup_spanner(_, _, _), 3.077873905537887e-5) :- fewer_at_2_than_todo_tightened, !.
delta(100, pickup_spanner(_, _, _), 0.006591092392835122) :- fewer_carrying_2_than_todo_tightened, !.
delta(100, pickup_spanner(_, _, _), -0.0007411937498530207) :- !.
delta(100, _, 0.0).

% tree 101: step size 1.0, 208 examples, 5 leaves
delta(101, walk(_, _, _), -0.006661992880725626) :- fewer_carrying_2_than_todo_tightened, !.
delta(101, walk(_, _, _), 0.0012426915534725143) :- !.
delta(101, pickup_spanner(_, _, _), 0.006276253971767868) :- fewer_carrying_2_than_todo_tightened, !.
delta(101, pickup_spanner(_, _, _), -0.0012426915534725143) :- !.
delta(101, _, 0.0).

% tree 102: step size 1.0, 204 examples, 5 leaves
delta(102, walk(_, _, _), -0.0074776293849983634) :- fewer_carrying_2_than_todo_tightened, !.
delta(102, walk(_, _, _), 0.0011014837627920944) :- !.
delta(102, pickup_spanner(_, _, _), 0.007477629384998362) :- fewer_carrying_2_than_todo_tightened, !.
delta(102, pickup_spanner(_, _, _), -0.0011014837627920944) :- !.
delta(102, _, 0.0).

% tree 103: step size 1.0, 206 examples, 11 leaves
delta(103, walk(_, Location, _), -0.0005408247694341959) :- at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(103, walk(_, Location, _), 0.00017525807065144292) :- at(Locatable, Location), spanner(Locatable), fewer_at_2_than_todo_tightened, !.
delta(103, walk(_, Location, Man), 0.009599420169574891) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(103, walk(_, Location, _), -1.654922637123152e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(103, walk(_, _, _), -0.0038655605420914816) :- fewer_carrying_2_than_todo_tightened, !.
delta(103, walk(_, _, _), 0.0012575164476833637) :- !.
delta(103, pickup_spanner(_, _, _), 0.0012158872428951817) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(103, pickup_spanner(_, _, _), -0.0007817409353931606) :- fewer_at_2_than_todo_tightened, !.
delta(103, pickup_spanner(_, _, Man), -0.007272037749061186) :- carrying(Man, _), !.
delta(103, pickup_spanner(_, _, _), 0.0003012314419935494) :- !.
delta(103, _, 0.0).

% tree 104: step size 1.0, 209 examples, 5 leaves
delta(104, walk(_, _, _), -0.009500113650106824) :- fewer_carrying_2_than_todo_tightened, !.
delta(104, walk(_, _, _), 0.0013419151037078268) :- !.
delta(104, pickup_spanner(_, _, _), 0.009500113650106824) :- fewer_carrying_2_than_todo_tightened, !.
delta(104, pickup_spanner(_, _, _), -0.0013364894961978542) :- !.
delta(104, _, 0.0).

% tree 105: step size 1.0, 217 examples, 5 leaves
delta(105, walk(_, _, _), -0.006691679349033579) :- fewer_carrying_2_than_todo_tightened, !.
delta(105, walk(_, _, _), 0.001187614821533694) :- !.
delta(105, pickup_spanner(_, _, _), 0.006261417353390858) :- fewer_carrying_2_than_todo_tightened, !.
delta(105, pickup_spanner(_, _, _), -0.001187614821533694) :- !.
delta(105, _, 0.0).

% tree 106: step size 1.0, 205 examples, 5 leaves
delta(106, walk(_, _, _), -0.008003415413268626) :- fewer_carrying_2_than_todo_tightened, !.
delta(106, walk(_, _, _), 0.0009859729733711039) :- !.
delta(106, pickup_spanner(_, _, _), 0.007971783242535245) :- fewer_carrying_2_than_todo_tightened, !.
delta(106, pickup_spanner(_, _, _), -0.0009859729733711039) :- !.
delta(106, _, 0.0).

% tree 107: step size 1.0, 212 examples, 10 leaves
delta(107, walk(_, Location, Man), -1.8380800876193895e-5) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(107, walk(_, Location, Man), 0.009182859421956005) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(107, walk(_, Location, _), -5.3440059670684575e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(107, walk(_, _, _), -0.00464634424367358) :- fewer_carrying_2_than_todo_tightened, !.
delta(107, walk(_, _, _), 0.0008990117893404302) :- !.
delta(107, pickup_spanner(_, _, Man), 0.0005860281137551325) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(107, pickup_spanner(_, _, Man), -0.0005098130088932582) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(107, pickup_spanner(_, _, Man), -0.005797225956724323) :- carrying(Man, _), !.
delta(107, pickup_spanner(_, _, _), 0.00039071935172729967) :- !.
delta(107, _, 0.0).

% tree 108: step size 1.0, 218 examples, 5 leaves
delta(108, walk(_, _, _), -0.006745515271267508) :- fewer_carrying_2_than_todo_tightened, !.
delta(108, walk(_, _, _), 0.0013524562627624944) :- !.
delta(108, pickup_spanner(_, _, _), 0.006726914503006169) :- fewer_carrying_2_than_todo_tightened, !.
delta(108, pickup_spanner(_, _, _), -0.0013524562627624944) :- !.
delta(108, _, 0.0).

% tree 109: step size 1.0, 218 examples, 5 leaves
delta(109, walk(_, _, _), -0.009182914410685403) :- fewer_carrying_2_than_todo_tightened, !.
delta(109, walk(_, _, _), 0.0012432347567348145) :- !.
delta(109, pickup_spanner(_, _, _), 0.008706362967773313) :- fewer_carrying_2_than_todo_tightened, !.
delta(109, pickup_spanner(_, _, _), -0.0012432347567348145) :- !.
delta(109, _, 0.0).

% tree 110: step size 1.0, 211 examples, 5 leaves
delta(110, walk(_, _, _), -0.006272024490299816) :- fewer_carrying_2_than_todo_tightened, !.
delta(110, walk(_, _, _), 0.001113142350236525) :- !.
delta(110, pickup_spanner(_, _, _), 0.006272024490299816) :- fewer_carrying_2_than_todo_tightened, !.
delta(110, pickup_spanner(_, _, _), -0.001113142350236525) :- !.
delta(110, _, 0.0).

% tree 111: step size 1.0, 205 examples, 5 leaves
delta(111, walk(_, _, _), -0.007544675751541706) :- fewer_carrying_2_than_todo_tightened, !.
delta(111, walk(_, _, _), 0.0012245146491848852) :- !.
delta(111, pickup_spanner(_, _, _), 0.007524366406097221) :- fewer_carrying_2_than_todo_tightened, !.
delta(111, pickup_spanner(_, _, _), -0.0012245146491848852) :- !.
delta(111, _, 0.0).

% tree 112: step size 1.0, 201 examples, 5 leaves
delta(112, walk(_, _, _), -0.006624197676665488) :- fewer_carrying_2_than_todo_tightened, !.
delta(112, walk(_, _, _), 0.001022128976406118) :- !.
delta(112, pickup_spanner(_, _, _), 0.006624197676665488) :- fewer_carrying_2_than_todo_tightened, !.
delta(112, pickup_spanner(_, _, _), -0.001022128976406118) :- !.
delta(112, _, 0.0).

% tree 113: step size 1.0, 216 examples, 5 leaves
delta(113, walk(_, _, _), -0.008173222860714565) :- fewer_carrying_2_than_todo_tightened, !.
delta(113, walk(_, _, _), 0.0011827412916016519) :- !.
delta(113, pickup_spanner(_, _, _), 0.008151567691698919) :- fewer_carrying_2_than_todo_tightened, !.
delta(113, pickup_spanner(_, _, _), -0.0011827412916016519) :- !.
delta(113, _, 0.0).

% tree 114: step size 1.0, 204 examples, 5 leaves
delta(114, walk(_, _, _), -0.004530050515685018) :- fewer_carrying_2_than_todo_tightened, !.
delta(114, walk(_, _, _), 0.001117459636168993) :- !.
delta(114, pickup_spanner(_, _, _), 0.004530050515685018) :- fewer_carrying_2_than_todo_tightened, !.
delta(114, pickup_spanner(_, _, _), -0.001117459636168993) :- !.
delta(114, _, 0.0).

% tree 115: step size 1.0, 201 examples, 7 leaves
delta(115, walk(_, Location, Man), 0.0055648157849096805) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(115, walk(_, Location, _), -1.952490938632947e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(115, walk(_, _, _), -0.0033723021068534963) :- fewer_carrying_2_than_todo_tightened, !.
delta(115, walk(_, _, _), 0.0009830770217708444) :- !.
delta(115, pickup_spanner(_, _, Man), -0.0034531651343973698) :- carrying(Man, _), !.
delta(115, pickup_spanner(_, _, _), 0.0003171419332253508) :- !.
delta(115, _, 0.0).

% tree 116: step size 1.0, 210 examples, 7 leaves
delta(116, walk(_, Location, _), -0.004678999888170023) :- at(_, Location), fewer_carrying_2_than_todo_tightened, !.
delta(116, walk(_, Location, _), 0.000767216621895889) :- at(_, Location), !.
delta(116, walk(_, Location, Man), 0.010628777049761727) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(116, walk(_, _, _), -0.00011629811520912321) :- !.
delta(116, pickup_spanner(_, _, Man), -0.006853082278682538) :- carrying(Man, _), !.
delta(116, pickup_spanner(_, _, _), 0.00030200078425711543) :- !.
delta(116, _, 0.0).

% tree 117: step size 1.0, 203 examples, 5 leaves
delta(117, walk(_, _, _), -0.005447064609197734) :- fewer_carrying_2_than_todo_tightened, !.
delta(117, walk(_, _, _), 0.0009587756258854369) :- !.
delta(117, pickup_spanner(_, _, _), 0.005447064609197734) :- fewer_carrying_2_than_todo_tightened, !.
delta(117, pickup_spanner(_, _, _), -0.0009587756258854369) :- !.
delta(117, _, 0.0).

% tree 118: step size 1.0, 208 examples, 5 leaves
delta(118, walk(_, _, _), -0.005883427834720394) :- fewer_carrying_2_than_todo_tightened, !.
delta(118, walk(_, _, _), 0.0011028114182782811) :- !.
delta(118, pickup_spanner(_, _, _), 0.005868372453821854) :- fewer_carrying_2_than_todo_tightened, !.
delta(118, pickup_spanner(_, _, _), -0.0011028114182782811) :- !.
delta(118, _, 0.0).

% tree 119: step size 1.0, 205 examples, 9 leaves
delta(119, walk(_, Location, Man), -0.005223332448583391) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(119, walk(_, Location, Man), 0.001009562203403724) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(119, walk(_, Location, _), -0.00014160370274172188) :- at(_, Location), !.
delta(119, walk(_, _, _), 0.14478379644133407) :- !.
delta(119, pickup_spanner(_, _, Man), 0.005210054048166618) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(119, pickup_spanner(_, _, Man), -0.001009562203403724) :- carrying(Man, _), !.
delta(119, pickup_spanner(_, _, _), 2.040035071360567e-5) :- fewer_at_2_than_todo_tightened, !.
delta(119, pickup_spanner(_, _, _), -0.1446450570978199) :- !.
delta(119, _, 0.0).

% tree 120: step size 1.0, 218 examples, 5 leaves
delta(120, walk(_, _, _), -0.005942318948605677) :- fewer_carrying_2_than_todo_tightened, !.
delta(120, walk(_, _, _), 0.0011769866328064339) :- !.
delta(120, pickup_spanner(_, _, _), 0.005637099692588688) :- fewer_carrying_2_than_todo_tightened, !.
delta(120, pickup_spanner(_, _, _), -0.0011769866328064339) :- !.
delta(120, _, 0.0).

% tree 121: step size 1.0, 218 examples, 5 leaves
delta(121, walk(_, _, _), -0.005809310869618383) :- fewer_carrying_2_than_todo_tightened, !.
delta(121, walk(_, _, _), 0.0008639840545559384) :- !.
delta(121, pickup_spanner(_, _, _), 0.005794761826012269) :- fewer_carrying_2_than_todo_tightened, !.
delta(121, pickup_spanner(_, _, _), -0.0008639840545559384) :- !.
delta(121, _, 0.0).

% tree 122: step size 1.0, 212 examples, 5 leaves
delta(122, walk(_, _, _), -0.004891087252278917) :- fewer_carrying_2_than_todo_tightened, !.
delta(122, walk(_, _, _), 0.0010088347866716305) :- !.
delta(122, pickup_spanner(_, _, _), 0.004891087252278917) :- fewer_carrying_2_than_todo_tightened, !.
delta(122, pickup_spanner(_, _, _), -0.0010088347866716305) :- !.
delta(122, _, 0.0).

% tree 123: step size 1.0, 216 examples, 10 leaves
delta(123, walk(_, Location, _), 0.013652143028491525) :- fewer_at_2_than_todo_tightened, at(_, Location), !.
delta(123, walk(_, _, _), -0.0003437506415319167) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(123, walk(_, _, _), 0.00014387722303416925) :- fewer_at_2_than_todo_tightened, !.
delta(123, walk(_, _, _), -0.004839436182432558) :- fewer_carrying_2_than_todo_tightened, !.
delta(123, walk(_, _, _), 0.0004514147885829502) :- !.
delta(123, pickup_spanner(_, _, Man), -0.012819082050809068) :- fewer_at_2_than_todo_tightened, carrying(Man, _), !.
delta(123, pickup_spanner(_, _, _), 4.254667127177337e-5) :- fewer_at_2_than_todo_tightened, !.
delta(123, pickup_spanner(_, _, _), 0.004839436182432558) :- fewer_carrying_2_than_todo_tightened, !.
delta(123, pickup_spanner(_, _, _), -0.0004514147885829502) :- !.
delta(123, _, 0.0).

% tree 124: step size 1.0, 204 examples, 5 leaves
delta(124, walk(_, _, _), -0.00537737550066194) :- fewer_carrying_2_than_todo_tightened, !.
delta(124, walk(_, _, _), 0.0008713645136426712) :- !.
delta(124, pickup_spanner(_, _, _), 0.005091547169688527) :- fewer_carrying_2_than_todo_tightened, !.
delta(124, pickup_spanner(_, _, _), -0.0008713645136426712) :- !.
delta(124, _, 0.0).

% tree 125: step size 1.0, 203 examples, 7 leaves
delta(125, walk(_, Location, Man), 0.0048351931761582475) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(125, walk(_, Location, _), -6.194516047321998e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(125, walk(_, _, _), -0.003795312915125171) :- fewer_carrying_2_than_todo_tightened, !.
delta(125, walk(_, _, _), 0.0008980317355030691) :- !.
delta(125, pickup_spanner(_, _, Man), -0.002215200841015127) :- carrying(Man, _), !.
delta(125, pickup_spanner(_, _, _), 0.0003563373780388161) :- !.
delta(125, _, 0.0).

% tree 126: step size 1.0, 201 examples, 5 leaves
delta(126, walk(_, _, _), -0.004850398240654446) :- fewer_carrying_2_than_todo_tightened, !.
delta(126, walk(_, _, _), 0.0010030129313550278) :- !.
delta(126, pickup_spanner(_, _, _), 0.004850398240654446) :- fewer_carrying_2_than_todo_tightened, !.
delta(126, pickup_spanner(_, _, _), -0.0010030129313550278) :- !.
delta(126, _, 0.0).

% tree 127: step size 1.0, 202 examples, 5 leaves
delta(127, walk(_, _, _), -0.005580011197000294) :- fewer_carrying_2_than_todo_tightened, !.
delta(127, walk(_, _, _), 0.0009336735710098694) :- !.
delta(127, pickup_spanner(_, _, _), 0.005323615487162314) :- fewer_carrying_2_than_todo_tightened, !.
delta(127, pickup_spanner(_, _, _), -0.0009336735710098694) :- !.
delta(127, _, 0.0).

% tree 128: step size 1.0, 213 examples, 5 leaves
delta(128, walk(_, _, _), -0.005497983056243459) :- fewer_carrying_2_than_todo_tightened, !.
delta(128, walk(_, _, _), 0.001051433330797085) :- !.
delta(128, pickup_spanner(_, _, _), 0.005497983056243459) :- fewer_carrying_2_than_todo_tightened, !.
delta(128, pickup_spanner(_, _, _), -0.001051433330797085) :- !.
delta(128, _, 0.0).

% tree 129: step size 1.0, 201 examples, 5 leaves
delta(129, walk(_, _, _), -0.004854010242263735) :- fewer_carrying_2_than_todo_tightened, !.
delta(129, walk(_, _, _), 0.0008084803001806649) :- !.
delta(129, pickup_spanner(_, _, _), 0.004842498234166079) :- fewer_carrying_2_than_todo_tightened, !.
delta(129, pickup_spanner(_, _, _), -0.0008084803001806649) :- !.
delta(129, _, 0.0).

% tree 130: step size 1.0, 214 examples, 9 leaves
delta(130, walk(_, Location, Man), 0.004623551958107696) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(130, walk(_, Location, _), -3.34963053559034e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(130, walk(_, _, _), -0.003522289767285652) :- fewer_carrying_2_than_todo_tightened, !.
delta(130, walk(_, _, _), 0.0007027236298859174) :- !.
delta(130, pickup_spanner(_, _, Man), 0.0003238821972371015) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(130, pickup_spanner(_, _, Man), -0.00026983548500742263) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(130, pickup_spanner(_, _, Man), -0.0020483828692033934) :- carrying(Man, _), !.
delta(130, pickup_spanner(_, _, _), 0.0003384880910492961) :- !.
delta(130, _, 0.0).

% tree 131: step size 1.0, 207 examples, 9 leaves
delta(131, walk(_, Location, Man), 0.09613343937648185) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(131, walk(_, Location, _), -2.9697097172831614e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(131, walk(_, _, _), -0.0027660142883083575) :- fewer_carrying_2_than_todo_tightened, !.
delta(131, walk(_, _, _), 0.0006951052919247088) :- !.
delta(131, pickup_spanner(_, _, Man), 0.00031491287534091486) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(131, pickup_spanner(_, _, Man), -0.00031976158627619746) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(131, pickup_spanner(_, _, Man), -0.09380014441890787) :- carrying(Man, _), !.
delta(131, pickup_spanner(_, _, _), 0.0003235384568453259) :- !.
delta(131, _, 0.0).

% tree 132: step size 1.0, 201 examples, 9 leaves
delta(132, walk(_, Location, Man), 0.008677008734803085) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(132, walk(_, Location, _), -2.3592151513320726e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(132, walk(_, _, _), -0.0031035434099768878) :- fewer_carrying_2_than_todo_tightened, !.
delta(132, walk(_, _, _), 0.0007201046122810427) :- !.
delta(132, pickup_spanner(_, _, Man), 0.0004288000275216797) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(132, pickup_spanner(_, _, Man), -0.0003926877434083102) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(132, pickup_spanner(_, _, Man), -0.0065582892833975295) :- carrying(Man, _), !.
delta(132, pickup_spanner(_, _, _), 0.00029040002528723987) :- !.
delta(132, _, 0.0).

% tree 133: step size 1.0, 202 examples, 7 leaves
delta(133, walk(_, Location, Man), 0.009616877988800591) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(133, walk(_, Location, _), -3.514396771289283e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(133, walk(_, _, _), -0.0030318786158496087) :- fewer_carrying_2_than_todo_tightened, !.
delta(133, walk(_, _, _), 0.0008546815963240196) :- !.
delta(133, pickup_spanner(_, _, Man), -0.006982905299815824) :- carrying(Man, _), !.
delta(133, pickup_spanner(_, _, _), 0.0002591323343639435) :- !.
delta(133, _, 0.0).

% tree 134: step size 1.0, 217 examples, 5 leaves
delta(134, walk(_, _, _), -0.0051803511474757535) :- fewer_carrying_2_than_todo_tightened, !.
delta(134, walk(_, _, _), 0.0008588305008333414) :- !.
delta(134, pickup_spanner(_, _, _), 0.004744111727550658) :- fewer_carrying_2_than_todo_tightened, !.
delta(134, pickup_spanner(_, _, _), -0.0008588305008333414) :- !.
delta(134, _, 0.0).

% tree 135: step size 1.0, 218 examples, 5 leaves
delta(135, walk(_, _, _), -0.005616198800671788) :- fewer_carrying_2_than_todo_tightened, !.
delta(135, walk(_, _, _), 0.0010300883979993197) :- !.
delta(135, pickup_spanner(_, _, _), 0.0056034066623079784) :- fewer_carrying_2_than_todo_tightened, !.
delta(135, pickup_spanner(_, _, _), -0.0010300883979993197) :- !.
delta(135, _, 0.0).

% tree 136: step size 1.0, 206 examples, 5 leaves
delta(136, walk(_, _, _), -0.004695293878722585) :- fewer_carrying_2_than_todo_tightened, !.
delta(136, walk(_, _, _), 0.0006923455094312757) :- !.
delta(136, pickup_spanner(_, _, _), 0.004695293878722585) :- fewer_carrying_2_than_todo_tightened, !.
delta(136, pickup_spanner(_, _, _), -0.0006901208518353223) :- !.
delta(136, _, 0.0).

% tree 137: step size 1.0, 205 examples, 5 leaves
delta(137, walk(_, _, _), -0.0058067150886663655) :- fewer_carrying_2_than_todo_tightened, !.
delta(137, walk(_, _, _), 0.0007951410091553673) :- !.
delta(137, pickup_spanner(_, _, _), 0.0058067150886663655) :- fewer_carrying_2_than_todo_tightened, !.
delta(137, pickup_spanner(_, _, _), -0.0007951410091553673) :- !.
delta(137, _, 0.0).

% tree 138: step size 1.0, 213 examples, 5 leaves
delta(138, walk(_, _, _), -0.0035673081254651395) :- fewer_carrying_2_than_todo_tightened, !.
delta(138, walk(_, _, _), 0.0009448827281977058) :- !.
delta(138, pickup_spanner(_, _, _), 0.003251646332223756) :- fewer_carrying_2_than_todo_tightened, !.
delta(138, pickup_spanner(_, _, _), -0.0009448827281977058) :- !.
delta(138, _, 0.0).

% tree 139: step size 1.0, 213 examples, 5 leaves
delta(139, walk(_, _, _), -0.004527242465603802) :- fewer_carrying_2_than_todo_tightened, !.
delta(139, walk(_, _, _), 0.0008374281584086785) :- !.
delta(139, pickup_spanner(_, _, _), 0.004499601528774415) :- fewer_carrying_2_than_todo_tightened, !.
delta(139, pickup_spanner(_, _, _), -0.0008374281584086785) :- !.
delta(139, _, 0.0).

% tree 140: step size 1.0, 209 examples, 5 leaves
delta(140, walk(_, _, _), -0.005759520568282516) :- fewer_carrying_2_than_todo_tightened, !.
delta(140, walk(_, _, _), 0.0007737903125933824) :- !.
delta(140, pickup_spanner(_, _, _), 0.005482806855910788) :- fewer_carrying_2_than_todo_tightened, !.
delta(140, pickup_spanner(_, _, _), -0.0007737903125933824) :- !.
delta(140, _, 0.0).

% tree 141: step size 1.0, 221 examples, 5 leaves
delta(141, walk(_, _, _), -0.005119548259934613) :- fewer_carrying_2_than_todo_tightened, !.
delta(141, walk(_, _, _), 0.0008165185227096476) :- !.
delta(141, pickup_spanner(_, _, _), 0.0051083181009803705) :- fewer_carrying_2_than_todo_tightened, !.
delta(141, pickup_spanner(_, _, _), -0.0008165185227096476) :- !.
delta(141, _, 0.0).

% tree 142: step size 1.0, 201 examples, 5 leaves
delta(142, walk(_, _, _), -0.0038529965298823073) :- fewer_carrying_2_than_todo_tightened, !.
delta(142, walk(_, _, _), 0.0008036642870324863) :- !.
delta(142, pickup_spanner(_, _, _), 0.003844586380095488) :- fewer_carrying_2_than_todo_tightened, !.
delta(142, pickup_spanner(_, _, _), -0.0008036642870324863) :- !.
delta(142, _, 0.0).

% tree 143: step size 1.0, 217 examples, 5 leaves
delta(143, walk(_, _, _), -0.0045409697071538664) :- fewer_carrying_2_than_todo_tightened, !.
delta(143, walk(_, _, _), 0.0008946456631912761) :- !.
delta(143, pickup_spanner(_, _, _), 0.0045409697071538664) :- fewer_carrying_2_than_todo_tightened, !.
delta(143, pickup_spanner(_, _, _), -0.0008946456631912761) :- !.
delta(143, _, 0.0).

% tree 144: step size 1.0, 215 examples, 5 leaves
delta(144, walk(_, _, _), -0.004858163050578722) :- fewer_carrying_2_than_todo_tightened, !.
delta(144, walk(_, _, _), 0.0008920737387500579) :- !.
delta(144, pickup_spanner(_, _, _), 0.004847699233690555) :- fewer_carrying_2_than_todo_tightened, !.
delta(144, pickup_spanner(_, _, _), -0.0008920737387500579) :- !.
delta(144, _, 0.0).

% tree 145: step size 1.0, 209 examples, 5 leaves
delta(145, walk(_, _, _), -0.004660864986099827) :- fewer_carrying_2_than_todo_tightened, !.
delta(145, walk(_, _, _), 0.0005980466432617368) :- !.
delta(145, pickup_spanner(_, _, _), 0.004486181447025643) :- fewer_carrying_2_than_todo_tightened, !.
delta(145, pickup_spanner(_, _, _), -0.0005980466432617368) :- !.
delta(145, _, 0.0).

% tree 146: step size 1.0, 206 examples, 5 leaves
delta(146, walk(_, _, _), -0.0040219365779661075) :- fewer_carrying_2_than_todo_tightened, !.
delta(146, walk(_, _, _), 0.0006353375287940706) :- !.
delta(146, pickup_spanner(_, _, _), 0.0036983337021130923) :- fewer_carrying_2_than_todo_tightened, !.
delta(146, pickup_spanner(_, _, _), -0.0006353375287940706) :- !.
delta(146, _, 0.0).

% tree 147: step size 1.0, 209 examples, 5 leaves
delta(147, walk(_, _, _), -0.003770215158706174) :- fewer_carrying_2_than_todo_tightened, !.
delta(147, walk(_, _, _), 0.0007119754596501089) :- !.
delta(147, pickup_spanner(_, _, _), 0.003770215158706174) :- fewer_carrying_2_than_todo_tightened, !.
delta(147, pickup_spanner(_, _, _), -0.0007119754596501089) :- !.
delta(147, _, 0.0).

% tree 148: step size 1.0, 204 examples, 5 leaves
delta(148, walk(_, _, _), -0.004399948816620055) :- fewer_carrying_2_than_todo_tightened, !.
delta(148, walk(_, _, _), 0.0008827656913997232) :- !.
delta(148, pickup_spanner(_, _, _), 0.004399948816620055) :- fewer_carrying_2_than_todo_tightened, !.
delta(148, pickup_spanner(_, _, _), -0.0008827656913997232) :- !.
delta(148, _, 0.0).

% tree 149: step size 1.0, 208 examples, 9 leaves
delta(149, walk(_, Location, Man), -0.004901179801564155) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(149, walk(_, Location, Man), 0.0006757487741024448) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(149, walk(_, Location, _), -0.0001292737332721069) :- at(_, Location), !.
delta(149, walk(_, _, _), 0.11894405531485201) :- !.
delta(149, pickup_spanner(_, _, Man), 0.004901179801564155) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(149, pickup_spanner(_, _, Man), -0.0006757487741024448) :- carrying(Man, _), !.
delta(149, pickup_spanner(_, _, _), 1.6024890558709365e-5) :- fewer_at_2_than_todo_tightened, !.
delta(149, pickup_spanner(_, _, _), -0.11881734423178808) :- !.
delta(149, _, 0.0).

% tree 150: step size 1.0, 205 examples, 8 leaves
delta(150, walk(_, Location, Man), -1.5164215303559995e-5) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(150, walk(_, Location, Man), 0.007567160129507755) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(150, walk(_, Location, _), -2.3735709341184314e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(150, walk(_, _, _), -0.0022815861823986174) :- fewer_carrying_2_than_todo_tightened, !.
delta(150, walk(_, _, _), 0.0007454173595942662) :- !.
delta(150, pickup_spanner(_, _, Man), -0.006177374498005599) :- carrying(Man, _), !.
delta(150, pickup_spanner(_, _, _), 0.00023654641960035242) :- !.
delta(150, _, 0.0).

% tree 151: step size 1.0, 204 examples, 5 leaves
delta(151, walk(_, _, _), -0.004935855043018606) :- fewer_carrying_2_than_todo_tightened, !.
delta(151, walk(_, _, _), 0.0006907777300429679) :- !.
delta(151, pickup_spanner(_, _, _), 0.00466291835616473) :- fewer_carrying_2_than_todo_tightened, !.
delta(151, pickup_spanner(_, _, _), -0.0006907777300429679) :- !.
delta(151, _, 0.0).

% tree 152: step size 1.0, 201 examples, 5 leaves
delta(152, walk(_, _, _), -0.0019649743462580344) :- fewer_carrying_2_than_todo_tightened, !.
delta(152, walk(_, _, _), 0.000501552796075122) :- !.
delta(152, pickup_spanner(_, _, _), 0.001887093856979417) :- fewer_carrying_2_than_todo_tightened, !.
delta(152, pickup_spanner(_, _, _), -0.000501552796075122) :- !.
delta(152, _, 0.0).

% tree 153: step size 1.0, 201 examples, 5 leaves
delta(153, walk(_, _, _), -0.0033167488938751367) :- fewer_carrying_2_than_todo_tightened, !.
delta(153, walk(_, _, _), 0.0008559182264821752) :- !.
delta(153, pickup_spanner(_, _, _), 0.0031861958019264477) :- fewer_carrying_2_than_todo_tightened, !.
delta(153, pickup_spanner(_, _, _), -0.0008559182264821752) :- !.
delta(153, _, 0.0).

% tree 154: step size 1.0, 216 examples, 8 leaves
delta(154, walk(_, _, _), 0.005940497102340689) :- fewer_at_2_than_todo_tightened, !.
delta(154, walk(_, _, _), -0.0037996824470399406) :- fewer_carrying_2_than_todo_tightened, !.
delta(154, walk(_, _, _), 0.0003095445536904272) :- !.
delta(154, pickup_spanner(_, _, Man), -0.005945583163568435) :- fewer_at_2_than_todo_tightened, carrying(Man, _), !.
delta(154, pickup_spanner(_, _, _), 1.7137467519251596e-5) :- fewer_at_2_than_todo_tightened, !.
delta(154, pickup_spanner(_, _, _), 0.0037996824470399406) :- fewer_carrying_2_than_todo_tightened, !.
delta(154, pickup_spanner(_, _, _), -0.0003095445536904272) :- !.
delta(154, _, 0.0).

% tree 155: step size 1.0, 209 examples, 5 leaves
delta(155, walk(_, _, _), -0.0037676404424394068) :- fewer_carrying_2_than_todo_tightened, !.
delta(155, walk(_, _, _), 0.0007145330548899172) :- !.
delta(155, pickup_spanner(_, _, _), 0.0037676404424394068) :- fewer_carrying_2_than_todo_tightened, !.
delta(155, pickup_spanner(_, _, _), -0.0007145330548899172) :- !.
delta(155, _, 0.0).

% tree 156: step size 1.0, 204 examples, 7 leaves
delta(156, walk(_, Location, Man), 0.00400573199593552) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(156, walk(_, Location, _), -1.923994779450952e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(156, walk(_, _, _), -0.002587346479695074) :- fewer_carrying_2_than_todo_tightened, !.
delta(156, walk(_, _, _), 0.0005640215321486467) :- !.
delta(156, pickup_spanner(_, _, Man), -0.00220531024630677) :- carrying(Man, _), !.
delta(156, pickup_spanner(_, _, _), 0.00025153569558859936) :- !.
delta(156, _, 0.0).

% tree 157: step size 1.0, 205 examples, 9 leaves
delta(157, walk(_, Location, Man), -0.0022252169743665856) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(157, walk(_, Location, Man), 0.0009103428933789657) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(157, walk(_, Location, _), -0.00010685850291302374) :- at(_, Location), !.
delta(157, walk(_, _, _), 0.11347302944730703) :- !.
delta(157, pickup_spanner(_, _, Man), 0.002220765760697468) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(157, pickup_spanner(_, _, Man), -0.0009103428933789657) :- carrying(Man, _), !.
delta(157, pickup_spanner(_, _, _), 1.677055176338967e-5) :- fewer_at_2_than_todo_tightened, !.
delta(157, pickup_spanner(_, _, _), -0.11337273055739401) :- !.
delta(157, _, 0.0).

% tree 158: step size 1.0, 209 examples, 9 leaves
delta(158, walk(_, Location, Man), -0.0038450368537191666) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(158, walk(_, Location, Man), 0.0005743243728130962) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(158, walk(_, Location, _), -0.00011150811192381016) :- at(_, Location), !.
delta(158, walk(_, _, _), 0.11276356347389323) :- !.
delta(158, pickup_spanner(_, _, Man), 0.0038450368537191666) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(158, pickup_spanner(_, _, Man), -0.0005743243728130962) :- carrying(Man, _), !.
delta(158, pickup_spanner(_, _, _), 1.8679163610713744e-5) :- fewer_at_2_than_todo_tightened, !.
delta(158, pickup_spanner(_, _, _), -0.11266028473267144) :- !.
delta(158, _, 0.0).

% tree 159: step size 1.0, 216 examples, 5 leaves
delta(159, walk(_, _, _), -0.0043895300411979764) :- fewer_carrying_2_than_todo_tightened, !.
delta(159, walk(_, _, _), 0.0007315319985495071) :- !.
delta(159, pickup_spanner(_, _, _), 0.004377288217913689) :- fewer_carrying_2_than_todo_tightened, !.
delta(159, pickup_spanner(_, _, _), -0.0007315319985495071) :- !.
delta(159, _, 0.0).

% tree 160: step size 1.0, 202 examples, 10 leaves
delta(160, walk(_, Location, _), -0.002979242259931959) :- at(_, Location), fewer_carrying_2_than_todo_tightened, !.
delta(160, walk(_, Location, _), 0.00034512202174823245) :- at(_, Location), !.
delta(160, walk(_, Location, Man), -8.79684679005088e-5) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(160, walk(_, Location, Man), 0.004959274398898679) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(160, walk(_, _, _), -0.00021812027288719071) :- !.
delta(160, pickup_spanner(_, _, Man), 0.00019250286787026835) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(160, pickup_spanner(_, _, Man), -0.00015438859510789622) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(160, pickup_spanner(_, _, Man), -0.0022904711742179566) :- carrying(Man, _), !.
delta(160, pickup_spanner(_, _, _), 0.0003372853063309947) :- !.
delta(160, _, 0.0).

% tree 161: step size 1.0, 206 examples, 5 leaves
delta(161, walk(_, _, _), -0.0033521630513094446) :- fewer_carrying_2_than_todo_tightened, !.
delta(161, walk(_, _, _), 0.0007122035101836586) :- !.
delta(161, pickup_spanner(_, _, _), 0.003342908299101911) :- fewer_carrying_2_than_todo_tightened, !.
delta(161, pickup_spanner(_, _, _), -0.0007122035101836586) :- !.
delta(161, _, 0.0).

% tree 162: step size 1.0, 208 examples, 5 leaves
delta(162, walk(_, _, _), -0.003873131608728773) :- fewer_carrying_2_than_todo_tightened, !.
delta(162, walk(_, _, _), 0.00043880137304090963) :- !.
delta(162, pickup_spanner(_, _, _), 0.0037210834769675852) :- fewer_carrying_2_than_todo_tightened, !.
delta(162, pickup_spanner(_, _, _), -0.00043880137304090963) :- !.
delta(162, _, 0.0).

% tree 163: step size 1.0, 206 examples, 5 leaves
delta(163, walk(_, _, _), -0.0033050917507845157) :- fewer_carrying_2_than_todo_tightened, !.
delta(163, walk(_, _, _), 0.0006437394151796873) :- !.
delta(163, pickup_spanner(_, _, _), 0.003292342580638472) :- fewer_carrying_2_than_todo_tightened, !.
delta(163, pickup_spanner(_, _, _), -0.0006437394151796873) :- !.
delta(163, _, 0.0).

% tree 164: step size 1.0, 206 examples, 5 leaves
delta(164, walk(_, _, _), -0.0041912310113055825) :- fewer_carrying_2_than_todo_tightened, !.
delta(164, walk(_, _, _), 0.0005846840242152356) :- !.
delta(164, pickup_spanner(_, _, _), 0.004183183004774141) :- fewer_carrying_2_than_todo_tightened, !.
delta(164, pickup_spanner(_, _, _), -0.0005846840242152356) :- !.
delta(164, _, 0.0).

% tree 165: step size 1.0, 207 examples, 5 leaves
delta(165, walk(_, Location, Man), 0.008161928099520113) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(165, walk(_, _, _), -0.0003017608318561792) :- !.
delta(165, pickup_spanner(_, _, Man), -0.008139899653157328) :- carrying(Man, _), !.
delta(165, pickup_spanner(_, _, _), 0.0003017608318561792) :- !.
delta(165, _, 0.0).

% tree 166: step size 1.0, 207 examples, 5 leaves
delta(166, walk(_, _, _), -0.0028448821671731178) :- fewer_carrying_2_than_todo_tightened, !.
delta(166, walk(_, _, _), 0.0006389698335952014) :- !.
delta(166, pickup_spanner(_, _, _), 0.002735413663640349) :- fewer_carrying_2_than_todo_tightened, !.
delta(166, pickup_spanner(_, _, _), -0.0006389698335952014) :- !.
delta(166, _, 0.0).

% tree 167: step size 1.0, 207 examples, 5 leaves
delta(167, walk(_, _, _), -0.0033634577104020356) :- fewer_carrying_2_than_todo_tightened, !.
delta(167, walk(_, _, _), 0.0006748700384708112) :- !.
delta(167, pickup_spanner(_, _, _), 0.0032406727673171174) :- fewer_carrying_2_than_todo_tightened, !.
delta(167, pickup_spanner(_, _, _), -0.0006748700384708112) :- !.
delta(167, _, 0.0).

% tree 168: step size 1.0, 217 examples, 5 leaves
delta(168, walk(_, _, _), -0.003351296396155681) :- fewer_carrying_2_than_todo_tightened, !.
delta(168, walk(_, _, _), 0.0007272203185184758) :- !.
delta(168, pickup_spanner(_, _, _), 0.003351296396155681) :- fewer_carrying_2_than_todo_tightened, !.
delta(168, pickup_spanner(_, _, _), -0.0007272203185184758) :- !.
delta(168, _, 0.0).

% tree 169: step size 1.0, 216 examples, 7 leaves
delta(169, walk(_, Location, Man), 0.004250454138077556) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(169, walk(_, Location, _), -2.956218389835566e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(169, walk(_, _, _), -0.0024865245186883426) :- fewer_carrying_2_than_todo_tightened, !.
delta(169, walk(_, _, _), 0.00047602631361029886) :- !.
delta(169, pickup_spanner(_, _, Man), -0.00243472866692552) :- carrying(Man, _), !.
delta(169, pickup_spanner(_, _, _), 0.00033077382775875577) :- !.
delta(169, _, 0.0).

% tree 170: step size 1.0, 215 examples, 5 leaves
delta(170, walk(_, _, _), -0.003185336063726851) :- fewer_carrying_2_than_todo_tightened, !.
delta(170, walk(_, _, _), 0.0006182324495215124) :- !.
delta(170, pickup_spanner(_, _, _), 0.0030150718586382857) :- fewer_carrying_2_than_todo_tightened, !.
delta(170, pickup_spanner(_, _, _), -0.0006182324495215124) :- !.
delta(170, _, 0.0).

% tree 171: step size 1.0, 203 examples, 5 leaves
delta(171, walk(_, _, _), -0.002966523762453606) :- fewer_carrying_2_than_todo_tightened, !.
delta(171, walk(_, _, _), 0.0006469592584304262) :- !.
delta(171, pickup_spanner(_, _, _), 0.002966523762453606) :- fewer_carrying_2_than_todo_tightened, !.
delta(171, pickup_spanner(_, _, _), -0.0006452622967725746) :- !.
delta(171, _, 0.0).

% tree 172: step size 1.0, 214 examples, 5 leaves
delta(172, walk(_, _, _), -0.0038637532062914754) :- fewer_carrying_2_than_todo_tightened, !.
delta(172, walk(_, _, _), 0.0005765438537189884) :- !.
delta(172, pickup_spanner(_, _, _), 0.0037197172435226794) :- fewer_carrying_2_than_todo_tightened, !.
delta(172, pickup_spanner(_, _, _), -0.0005765438537189884) :- !.
delta(172, _, 0.0).

% tree 173: step size 1.0, 219 examples, 5 leaves
delta(173, walk(_, _, _), -0.003814406259153688) :- fewer_carrying_2_than_todo_tightened, !.
delta(173, walk(_, _, _), 0.0005521577234724068) :- !.
delta(173, pickup_spanner(_, _, _), 0.003807421904497421) :- fewer_carrying_2_than_todo_tightened, !.
delta(173, pickup_spanner(_, _, _), -0.0005521577234724068) :- !.
delta(173, _, 0.0).

% tree 174: step size 1.0, 211 examples, 5 leaves
delta(174, walk(_, _, _), -0.00346027745809511) :- fewer_carrying_2_than_todo_tightened, !.
delta(174, walk(_, _, _), 0.0005142094147486295) :- !.
delta(174, pickup_spanner(_, _, _), 0.003324254802516492) :- fewer_carrying_2_than_todo_tightened, !.
delta(174, pickup_spanner(_, _, _), -0.0005142094147486295) :- !.
delta(174, _, 0.0).

% tree 175: step size 1.0, 219 examples, 5 leaves
delta(175, walk(_, _, _), -0.0037343121063427936) :- fewer_carrying_2_than_todo_tightened, !.
delta(175, walk(_, _, _), 0.0005942420020981548) :- !.
delta(175, pickup_spanner(_, _, _), 0.0037343121063427936) :- fewer_carrying_2_than_todo_tightened, !.
delta(175, pickup_spanner(_, _, _), -0.0005942420020981548) :- !.
delta(175, _, 0.0).

% tree 176: step size 1.0, 202 examples, 5 leaves
delta(176, walk(_, _, _), -0.002794796245502849) :- fewer_carrying_2_than_todo_tightened, !.
delta(176, walk(_, _, _), 0.0006720491695493088) :- !.
delta(176, pickup_spanner(_, _, _), 0.0026478315326719337) :- fewer_carrying_2_than_todo_tightened, !.
delta(176, pickup_spanner(_, _, _), -0.0006720491695493088) :- !.
delta(176, _, 0.0).

% tree 177: step size 1.0, 203 examples, 5 leaves
delta(177, walk(_, _, _), -0.0027043037167497194) :- fewer_carrying_2_than_todo_tightened, !.
delta(177, walk(_, _, _), 0.0005528389377876278) :- !.
delta(177, pickup_spanner(_, _, _), 0.0027043037167497194) :- fewer_carrying_2_than_todo_tightened, !.
delta(177, pickup_spanner(_, _, _), -0.0005528389377876278) :- !.
delta(177, _, 0.0).

% tree 178: step size 1.0, 216 examples, 8 leaves
delta(178, walk(_, Location, Man), -0.0018444367591837023) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(178, walk(_, Location, Man), 0.0006666398023673559) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(178, walk(_, Location, _), -9.193476296297435e-5) :- at(_, Location), !.
delta(178, walk(_, _, _), 0.10138152722661185) :- !.
delta(178, pickup_spanner(_, _, Man), 0.0018444367591837023) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(178, pickup_spanner(_, _, Man), -0.0006666398023673559) :- carrying(Man, _), !.
delta(178, pickup_spanner(_, _, _), -0.10128028525288126) :- !.
delta(178, _, 0.0).

% tree 179: step size 1.0, 213 examples, 5 leaves
delta(179, walk(_, _, _), -0.003091505336910365) :- fewer_carrying_2_than_todo_tightened, !.
delta(179, walk(_, _, _), 0.0005461001204090328) :- !.
delta(179, pickup_spanner(_, _, _), 0.003077262910742392) :- fewer_carrying_2_than_todo_tightened, !.
delta(179, pickup_spanner(_, _, _), -0.0005461001204090328) :- !.
delta(179, _, 0.0).

% tree 180: step size 1.0, 212 examples, 7 leaves
delta(180, walk(_, Location, Man), 0.004529059721363731) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(180, walk(_, Location, _), -3.121311293881286e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(180, walk(_, _, _), -0.002140505912121552) :- fewer_carrying_2_than_todo_tightened, !.
delta(180, walk(_, _, _), 0.000586390919542179) :- !.
delta(180, pickup_spanner(_, _, Man), -0.0032834984445539745) :- carrying(Man, _), !.
delta(180, pickup_spanner(_, _, _), 0.0003568320643479915) :- !.
delta(180, _, 0.0).

% tree 181: step size 1.0, 205 examples, 8 leaves
delta(181, walk(_, Location, Man), -0.002395879005789599) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(181, walk(_, Location, Man), 0.0006264131112030923) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(181, walk(_, Location, _), -0.0001438431597966523) :- at(_, Location), !.
delta(181, walk(_, _, _), 0.09984151443213171) :- !.
delta(181, pickup_spanner(_, _, Man), 0.002314253669359405) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(181, pickup_spanner(_, _, Man), -0.0006264131112030923) :- carrying(Man, _), !.
delta(181, pickup_spanner(_, _, _), -0.09968333310827437) :- !.
delta(181, _, 0.0).

% tree 182: step size 1.0, 205 examples, 5 leaves
delta(182, walk(_, _, _), -0.0034768709266904466) :- fewer_carrying_2_than_todo_tightened, !.
delta(182, walk(_, _, _), 0.0004906143227348406) :- !.
delta(182, pickup_spanner(_, _, _), 0.003312635767227649) :- fewer_carrying_2_than_todo_tightened, !.
delta(182, pickup_spanner(_, _, _), -0.0004906143227348406) :- !.
delta(182, _, 0.0).

% tree 183: step size 1.0, 203 examples, 5 leaves
delta(183, walk(_, _, _), -0.0027701945151916226) :- fewer_carrying_2_than_todo_tightened, !.
delta(183, walk(_, _, _), 0.0006882932105739749) :- !.
delta(183, pickup_spanner(_, _, _), 0.0027701945151916226) :- fewer_carrying_2_than_todo_tightened, !.
delta(183, pickup_spanner(_, _, _), -0.0006882932105739749) :- !.
delta(183, _, 0.0).

% tree 184: step size 1.0, 210 examples, 9 leaves
delta(184, walk(_, Location, Man), 0.004102271607770134) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(184, walk(_, Location, _), -2.0024160264282968e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(184, walk(_, _, _), -0.001914914614005238) :- fewer_carrying_2_than_todo_tightened, !.
delta(184, walk(_, _, _), 0.00044854759485613596) :- !.
delta(184, pickup_spanner(_, _, Man), 0.00022447804670554388) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(184, pickup_spanner(_, _, Man), -0.00024102163140722374) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(184, pickup_spanner(_, _, Man), -0.0029358651612883145) :- carrying(Man, _), !.
delta(184, pickup_spanner(_, _, _), 0.0003344055079613244) :- !.
delta(184, _, 0.0).

% tree 185: step size 1.0, 205 examples, 7 leaves
delta(185, walk(_, Location, _), -0.0018048574296444754) :- at(_, Location), fewer_carrying_2_than_todo_tightened, !.
delta(185, walk(_, Location, _), 0.0003048424998259647) :- at(_, Location), !.
delta(185, walk(_, Location, Man), 0.09714949469939954) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(185, walk(_, _, _), -0.0002675824845474362) :- !.
delta(185, pickup_spanner(_, _, Man), -0.09243380954579779) :- carrying(Man, _), !.
delta(185, pickup_spanner(_, _, _), 0.0004324924109143502) :- !.
delta(185, _, 0.0).

% tree 186: step size 1.0, 208 examples, 5 leaves
delta(186, walk(_, _, _), -0.002407814572347348) :- fewer_carrying_2_than_todo_tightened, !.
delta(186, walk(_, _, _), 0.0005269007318277952) :- !.
delta(186, pickup_spanner(_, _, _), 0.002407814572347348) :- fewer_carrying_2_than_todo_tightened, !.
delta(186, pickup_spanner(_, _, _), -0.0005269007318277952) :- !.
delta(186, _, 0.0).

% tree 187: step size 1.0, 207 examples, 5 leaves
delta(187, walk(_, _, _), -0.002932256254751417) :- fewer_carrying_2_than_todo_tightened, !.
delta(187, walk(_, _, _), 0.0004392271645992876) :- !.
delta(187, pickup_spanner(_, _, _), 0.002932256254751417) :- fewer_carrying_2_than_todo_tightened, !.
delta(187, pickup_spanner(_, _, _), -0.0004392271645992876) :- !.
delta(187, _, 0.0).

% tree 188: step size 1.0, 201 examples, 5 leaves
delta(188, walk(_, _, _), -0.0030896367422230584) :- fewer_carrying_2_than_todo_tightened, !.
delta(188, walk(_, _, _), 0.00047063646700695055) :- !.
delta(188, pickup_spanner(_, _, _), 0.0030843849154983294) :- fewer_carrying_2_than_todo_tightened, !.
delta(188, pickup_spanner(_, _, _), -0.00047063646700695055) :- !.
delta(188, _, 0.0).

% tree 189: step size 1.0, 213 examples, 7 leaves
delta(189, walk(_, Location, Man), 0.006985821284834296) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(189, walk(_, Location, _), -1.3842538935073967e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(189, walk(_, _, _), -0.0023491618977135764) :- fewer_carrying_2_than_todo_tightened, !.
delta(189, walk(_, _, _), 0.0004239775847908173) :- !.
delta(189, pickup_spanner(_, _, Man), -0.00535831525882542) :- carrying(Man, _), !.
delta(189, pickup_spanner(_, _, _), 0.000328698212422601) :- !.
delta(189, _, 0.0).

% tree 190: step size 1.0, 221 examples, 5 leaves
delta(190, walk(_, _, _), -0.0031385469593337217) :- fewer_carrying_2_than_todo_tightened, !.
delta(190, walk(_, _, _), 0.00047264671128899267) :- !.
delta(190, pickup_spanner(_, _, _), 0.0031332632202274295) :- fewer_carrying_2_than_todo_tightened, !.
delta(190, pickup_spanner(_, _, _), -0.00047264671128899267) :- !.
delta(190, _, 0.0).

% tree 191: step size 1.0, 219 examples, 5 leaves
delta(191, walk(_, _, _), -0.0026655691093395535) :- fewer_carrying_2_than_todo_tightened, !.
delta(191, walk(_, _, _), 0.0004769894375497154) :- !.
delta(191, pickup_spanner(_, _, _), 0.0026611008461801277) :- fewer_carrying_2_than_todo_tightened, !.
delta(191, pickup_spanner(_, _, _), -0.0004769894375497154) :- !.
delta(191, _, 0.0).

% tree 192: step size 1.0, 208 examples, 5 leaves
delta(192, walk(_, _, _), -0.003131205322988959) :- fewer_carrying_2_than_todo_tightened, !.
delta(192, walk(_, _, _), 0.0005164720110952419) :- !.
delta(192, pickup_spanner(_, _, _), 0.002935097829046123) :- fewer_carrying_2_than_todo_tightened, !.
delta(192, pickup_spanner(_, _, _), -0.0005164720110952419) :- !.
delta(192, _, 0.0).

% tree 193: step size 1.0, 201 examples, 5 leaves
delta(193, walk(_, _, _), -0.002694874345093567) :- fewer_carrying_2_than_todo_tightened, !.
delta(193, walk(_, _, _), 0.00040761320200732214) :- !.
delta(193, pickup_spanner(_, _, _), 0.002694874345093567) :- fewer_carrying_2_than_todo_tightened, !.
delta(193, pickup_spanner(_, _, _), -0.00040761320200732214) :- !.
delta(193, _, 0.0).

% tree 194: step size 1.0, 218 examples, 5 leaves
delta(194, walk(_, _, _), -0.002761296182779456) :- fewer_carrying_2_than_todo_tightened, !.
delta(194, walk(_, _, _), 0.0005533416537967295) :- !.
delta(194, pickup_spanner(_, _, _), 0.00266853473708451) :- fewer_carrying_2_than_todo_tightened, !.
delta(194, pickup_spanner(_, _, _), -0.0005533416537967295) :- !.
delta(194, _, 0.0).

% tree 195: step size 1.0, 217 examples, 5 leaves
delta(195, walk(_, _, _), -0.003393150665691008) :- fewer_carrying_2_than_todo_tightened, !.
delta(195, walk(_, _, _), 0.0004563716418487472) :- !.
delta(195, pickup_spanner(_, _, _), 0.003393150665691008) :- fewer_carrying_2_than_todo_tightened, !.
delta(195, pickup_spanner(_, _, _), -0.0004563716418487472) :- !.
delta(195, _, 0.0).

% tree 196: step size 1.0, 209 examples, 5 leaves
delta(196, walk(_, _, _), -0.0029816301408944817) :- fewer_carrying_2_than_todo_tightened, !.
delta(196, walk(_, _, _), 0.0004624513936788376) :- !.
delta(196, pickup_spanner(_, _, _), 0.002886964534664228) :- fewer_carrying_2_than_todo_tightened, !.
delta(196, pickup_spanner(_, _, _), -0.0004624513936788376) :- !.
delta(196, _, 0.0).

% tree 197: step size 1.0, 210 examples, 5 leaves
delta(197, walk(_, _, _), -0.002944443121146451) :- fewer_carrying_2_than_todo_tightened, !.
delta(197, walk(_, _, _), 0.0005307762401308684) :- !.
delta(197, pickup_spanner(_, _, _), 0.0029396456035169502) :- fewer_carrying_2_than_todo_tightened, !.
delta(197, pickup_spanner(_, _, _), -0.0005307762401308684) :- !.
delta(197, _, 0.0).

% tree 198: step size 1.0, 208 examples, 5 leaves
delta(198, walk(_, _, _), -0.002466884225900013) :- fewer_carrying_2_than_todo_tightened, !.
delta(198, walk(_, _, _), 0.0004985477587620226) :- !.
delta(198, pickup_spanner(_, _, _), 0.002466884225900013) :- fewer_carrying_2_than_todo_tightened, !.
delta(198, pickup_spanner(_, _, _), -0.0004985477587620226) :- !.
delta(198, _, 0.0).

% tree 199: step size 1.0, 201 examples, 5 leaves
delta(199, walk(_, _, _), -0.001786459947257029) :- fewer_carrying_2_than_todo_tightened, !.
delta(199, walk(_, _, _), 0.0004662787856606239) :- !.
delta(199, pickup_spanner(_, _, _), 0.0017799397207541295) :- fewer_carrying_2_than_todo_tightened, !.
delta(199, pickup_spanner(_, _, _), -0.0004662787856606239) :- !.
delta(199, _, 0.0).

% tree 200: step size 1.0, 203 examples, 9 leaves
delta(200, walk(_, Location, Man), -0.0021050911957094173) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(200, walk(_, Location, Man), 0.0004883339046885865) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(200, walk(_, Location, _), -0.00012229834477286535) :- at(_, Location), !.
delta(200, walk(_, _, _), 0.09111654592300131) :- !.
delta(200, pickup_spanner(_, _, Man), 0.0021050911957094173) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(200, pickup_spanner(_, _, Man), -0.0004883339046885865) :- carrying(Man, _), !.
delta(200, pickup_spanner(_, _, _), 2.043126996931704e-5) :- fewer_at_2_than_todo_tightened, !.
delta(200, pickup_spanner(_, _, _), -0.09100541398311478) :- !.
delta(200, _, 0.0).

% tree 201: step size 1.0, 213 examples, 5 leaves
delta(201, walk(_, _, _), -0.002927147161342098) :- fewer_carrying_2_than_todo_tightened, !.
delta(201, walk(_, _, _), 0.0005451031733087401) :- !.
delta(201, pickup_spanner(_, _, _), 0.0028362531528096893) :- fewer_carrying_2_than_todo_tightened, !.
delta(201, pickup_spanner(_, _, _), -0.0005451031733087401) :- !.
delta(201, _, 0.0).

% tree 202: step size 1.0, 202 examples, 10 leaves
delta(202, walk(_, Location, Man), -1.8611797672307847e-5) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(202, walk(_, Location, Man), 0.0890018126539028) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(202, walk(_, Location, _), -4.12758028117517e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(202, walk(_, _, _), -0.0016597998422865261) :- fewer_carrying_2_than_todo_tightened, !.
delta(202, walk(_, _, _), 0.00034589254685642954) :- !.
delta(202, pickup_spanner(_, _, Man), 0.0001562379149658074) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(202, pickup_spanner(_, _, Man), -0.00014412248092090805) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(202, pickup_spanner(_, _, Man), -0.08787194689666572) :- carrying(Man, _), !.
delta(202, pickup_spanner(_, _, _), 0.0003608808829639457) :- !.
delta(202, _, 0.0).

% tree 203: step size 1.0, 217 examples, 5 leaves
delta(203, walk(_, _, _), -0.003212987559987769) :- fewer_carrying_2_than_todo_tightened, !.
delta(203, walk(_, _, _), 0.00046743295259254916) :- !.
delta(203, pickup_spanner(_, _, _), 0.003212987559987769) :- fewer_carrying_2_than_todo_tightened, !.
delta(203, pickup_spanner(_, _, _), -0.00046743295259254916) :- !.
delta(203, _, 0.0).

% tree 204: step size 1.0, 212 examples, 5 leaves
delta(204, walk(_, _, _), -0.002214728132025214) :- fewer_carrying_2_than_todo_tightened, !.
delta(204, walk(_, _, _), 0.00042472370643950873) :- !.
delta(204, pickup_spanner(_, _, _), 0.002214728132025214) :- fewer_carrying_2_than_todo_tightened, !.
delta(204, pickup_spanner(_, _, _), -0.00042472370643950873) :- !.
delta(204, _, 0.0).

% tree 205: step size 1.0, 203 examples, 5 leaves
delta(205, walk(_, _, _), -0.002505044262230684) :- fewer_carrying_2_than_todo_tightened, !.
delta(205, walk(_, _, _), 0.0005332838193771411) :- !.
delta(205, pickup_spanner(_, _, _), 0.002505044262230684) :- fewer_carrying_2_than_todo_tightened, !.
delta(205, pickup_spanner(_, _, _), -0.0005332838193771411) :- !.
delta(205, _, 0.0).

% tree 206: step size 1.0, 207 examples, 5 leaves
delta(206, walk(_, _, _), -0.0029684756255449413) :- fewer_carrying_2_than_todo_tightened, !.
delta(206, walk(_, _, _), 0.00047162383233709617) :- !.
delta(206, pickup_spanner(_, _, _), 0.0029638322255709777) :- fewer_carrying_2_than_todo_tightened, !.
delta(206, pickup_spanner(_, _, _), -0.00047162383233709617) :- !.
delta(206, _, 0.0).

% tree 207: step size 1.0, 207 examples, 5 leaves
delta(207, walk(_, _, _), -0.003351063424703351) :- fewer_carrying_2_than_todo_tightened, !.
delta(207, walk(_, _, _), 0.0002856381088787357) :- !.
delta(207, pickup_spanner(_, _, _), 0.003351063424703351) :- fewer_carrying_2_than_todo_tightened, !.
delta(207, pickup_spanner(_, _, _), -0.0002856381088787357) :- !.
delta(207, _, 0.0).

% tree 208: step size 1.0, 202 examples, 5 leaves
delta(208, walk(_, _, _), -0.0025386252535762174) :- fewer_carrying_2_than_todo_tightened, !.
delta(208, walk(_, _, _), 0.0005006957378053322) :- !.
delta(208, pickup_spanner(_, _, _), 0.0025386252535762174) :- fewer_carrying_2_than_todo_tightened, !.
delta(208, pickup_spanner(_, _, _), -0.0005006957378053322) :- !.
delta(208, _, 0.0).

% tree 209: step size 1.0, 212 examples, 5 leaves
delta(209, walk(_, _, _), -0.003399781628866588) :- fewer_carrying_2_than_todo_tightened, !.
delta(209, walk(_, _, _), 0.0005303812212275391) :- !.
delta(209, pickup_spanner(_, _, _), 0.0033753850413999276) :- fewer_carrying_2_than_todo_tightened, !.
delta(209, pickup_spanner(_, _, _), -0.0005303812212275391) :- !.
delta(209, _, 0.0).

% tree 210: step size 1.0, 213 examples, 9 leaves
delta(210, walk(_, Location, Man), 0.08608424117756662) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(210, walk(_, Location, _), -1.9122006773980032e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(210, walk(_, _, _), -0.0016074522136116098) :- fewer_carrying_2_than_todo_tightened, !.
delta(210, walk(_, _, _), 0.0003861874573780966) :- !.
delta(210, pickup_spanner(_, _, Man), 0.00018071748174989006) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(210, pickup_spanner(_, _, Man), -0.0001825612316502376) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(210, pickup_spanner(_, _, Man), -0.08501204039909588) :- carrying(Man, _), !.
delta(210, pickup_spanner(_, _, _), 0.0002870224666190484) :- !.
delta(210, _, 0.0).

% tree 211: step size 1.0, 205 examples, 5 leaves
delta(211, walk(_, _, _), -0.0020739581063483905) :- fewer_carrying_2_than_todo_tightened, !.
delta(211, walk(_, _, _), 0.0004474449538570412) :- !.
delta(211, pickup_spanner(_, _, _), 0.002066305728827749) :- fewer_carrying_2_than_todo_tightened, !.
delta(211, pickup_spanner(_, _, _), -0.0004474449538570412) :- !.
delta(211, _, 0.0).

% tree 212: step size 1.0, 212 examples, 5 leaves
delta(212, walk(_, _, _), -0.0024076796624854986) :- fewer_carrying_2_than_todo_tightened, !.
delta(212, walk(_, _, _), 0.00039925567509174607) :- !.
delta(212, pickup_spanner(_, _, _), 0.0024076796624854986) :- fewer_carrying_2_than_todo_tightened, !.
delta(212, pickup_spanner(_, _, _), -0.00039925567509174607) :- !.
delta(212, _, 0.0).

% tree 213: step size 1.0, 207 examples, 9 leaves
delta(213, walk(_, Location, Man), -0.0032969382812756596) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(213, walk(_, Location, Man), 0.000391546980797344) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(213, walk(_, Location, _), -9.584075679520786e-5) :- at(_, Location), !.
delta(213, walk(_, _, _), 0.08602567676729868) :- !.
delta(213, pickup_spanner(_, _, Man), 0.0032969382812756596) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(213, pickup_spanner(_, _, Man), -0.000391546980797344) :- carrying(Man, _), !.
delta(213, pickup_spanner(_, _, _), 8.719004797206534e-6) :- fewer_at_2_than_todo_tightened, !.
delta(213, pickup_spanner(_, _, _), -0.08593107472290858) :- !.
delta(213, _, 0.0).

% tree 214: step size 1.0, 202 examples, 5 leaves
delta(214, walk(_, _, _), -0.0027569584992587514) :- fewer_carrying_2_than_todo_tightened, !.
delta(214, walk(_, _, _), 0.00035943906983061934) :- !.
delta(214, pickup_spanner(_, _, _), 0.0026759719676103725) :- fewer_carrying_2_than_todo_tightened, !.
delta(214, pickup_spanner(_, _, _), -0.00035943906983061934) :- !.
delta(214, _, 0.0).

% tree 215: step size 1.0, 211 examples, 5 leaves
delta(215, walk(_, _, _), -0.0029093713744570778) :- fewer_carrying_2_than_todo_tightened, !.
delta(215, walk(_, _, _), 0.00045234761383690874) :- !.
delta(215, pickup_spanner(_, _, _), 0.0029049949405095584) :- fewer_carrying_2_than_todo_tightened, !.
delta(215, pickup_spanner(_, _, _), -0.00045234761383690874) :- !.
delta(215, _, 0.0).

% tree 216: step size 1.0, 207 examples, 5 leaves
delta(216, walk(_, _, _), -0.0023927255355483323) :- fewer_carrying_2_than_todo_tightened, !.
delta(216, walk(_, _, _), 0.00048423835322164525) :- !.
delta(216, pickup_spanner(_, _, _), 0.0023927255355483323) :- fewer_carrying_2_than_todo_tightened, !.
delta(216, pickup_spanner(_, _, _), -0.00048423835322164525) :- !.
delta(216, _, 0.0).

% tree 217: step size 1.0, 205 examples, 5 leaves
delta(217, walk(_, _, _), -0.003281482810752483) :- fewer_carrying_2_than_todo_tightened, !.
delta(217, walk(_, _, _), 0.0003725864875629886) :- !.
delta(217, pickup_spanner(_, _, _), 0.003281482810752483) :- fewer_carrying_2_than_todo_tightened, !.
delta(217, pickup_spanner(_, _, _), -0.0003725864875629886) :- !.
delta(217, _, 0.0).

% tree 218: step size 1.0, 208 examples, 5 leaves
delta(218, walk(_, _, _), -0.0023958346317090092) :- fewer_carrying_2_than_todo_tightened, !.
delta(218, walk(_, _, _), 0.00037660334201158923) :- !.
delta(218, pickup_spanner(_, _, _), 0.002315161898985276) :- fewer_carrying_2_than_todo_tightened, !.
delta(218, pickup_spanner(_, _, _), -0.00037660334201158923) :- !.
delta(218, _, 0.0).

% tree 219: step size 1.0, 217 examples, 5 leaves
delta(219, walk(_, _, _), -0.0025836226815517268) :- fewer_carrying_2_than_todo_tightened, !.
delta(219, walk(_, _, _), 0.00041165363095660196) :- !.
delta(219, pickup_spanner(_, _, _), 0.0025798002343924292) :- fewer_carrying_2_than_todo_tightened, !.
delta(219, pickup_spanner(_, _, _), -0.00041165363095660196) :- !.
delta(219, _, 0.0).

% tree 220: step size 1.0, 201 examples, 5 leaves
delta(220, walk(_, _, _), -0.003056643260585849) :- fewer_carrying_2_than_todo_tightened, !.
delta(220, walk(_, _, _), 0.00036554906919664733) :- !.
delta(220, pickup_spanner(_, _, _), 0.003056643260585849) :- fewer_carrying_2_than_todo_tightened, !.
delta(220, pickup_spanner(_, _, _), -0.00036554906919664733) :- !.
delta(220, _, 0.0).

% tree 221: step size 1.0, 216 examples, 5 leaves
delta(221, walk(_, _, _), -0.0025021150876653386) :- fewer_carrying_2_than_todo_tightened, !.
delta(221, walk(_, _, _), 0.0003590290788603594) :- !.
delta(221, pickup_spanner(_, _, _), 0.0025021150876653386) :- fewer_carrying_2_than_todo_tightened, !.
delta(221, pickup_spanner(_, _, _), -0.0003590290788603594) :- !.
delta(221, _, 0.0).

% tree 222: step size 1.0, 215 examples, 8 leaves
delta(222, walk(_, Location, Man), -0.0020906976606393443) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(222, walk(_, Location, Man), 0.00040317877688169685) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(222, walk(_, Location, _), -9.706182385954979e-5) :- at(_, Location), !.
delta(222, walk(_, _, _), 0.08276228996832954) :- !.
delta(222, pickup_spanner(_, _, Man), 0.0020906976606393443) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(222, pickup_spanner(_, _, Man), -0.00040317877688169685) :- carrying(Man, _), !.
delta(222, pickup_spanner(_, _, _), -0.08265721724934993) :- !.
delta(222, _, 0.0).

% tree 223: step size 1.0, 217 examples, 5 leaves
delta(223, walk(_, Location, _), -0.0003037014683845761) :- todo_tightened(Nut), at(Nut, Location), fewer_carrying_2_than_todo_tightened, !.
delta(223, walk(_, Location, _), 0.0001681944695705948) :- todo_tightened(Nut), at(Nut, Location), !.
delta(223, walk(_, _, _), 0.08392214159276808) :- !.
delta(223, pickup_spanner(_, _, _), -0.0813780210740319) :- !.
delta(223, _, 0.0).

% tree 224: step size 1.0, 209 examples, 5 leaves
delta(224, walk(_, _, _), -0.002861035769583342) :- fewer_carrying_2_than_todo_tightened, !.
delta(224, walk(_, _, _), 0.00029832514327733395) :- !.
delta(224, pickup_spanner(_, _, _), 0.002861035769583342) :- fewer_carrying_2_than_todo_tightened, !.
delta(224, pickup_spanner(_, _, _), -0.00029832514327733395) :- !.
delta(224, _, 0.0).

% tree 225: step size 1.0, 207 examples, 9 leaves
delta(225, walk(_, Location, Man), 0.004975143510391026) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(225, walk(_, Location, _), -3.308098493603499e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(225, walk(_, _, _), -0.0020240186692238103) :- fewer_carrying_2_than_todo_tightened, !.
delta(225, walk(_, _, _), 0.00022318229776003743) :- !.
delta(225, pickup_spanner(_, _, Man), 0.00013450216073741266) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(225, pickup_spanner(_, _, Man), -0.00011077011493498174) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(225, pickup_spanner(_, _, Man), -0.00355875079520354) :- carrying(Man, _), !.
delta(225, pickup_spanner(_, _, _), 0.00040113447973268314) :- !.
delta(225, _, 0.0).

% tree 226: step size 1.0, 211 examples, 5 leaves
delta(226, walk(_, _, _), -0.0035545354716138263) :- fewer_carrying_2_than_todo_tightened, !.
delta(226, walk(_, _, _), 0.00031296773193097144) :- !.
delta(226, pickup_spanner(_, _, _), 0.0035545354716138263) :- fewer_carrying_2_than_todo_tightened, !.
delta(226, pickup_spanner(_, _, _), -0.00031296773193097144) :- !.
delta(226, _, 0.0).

% tree 227: step size 1.0, 201 examples, 5 leaves
delta(227, walk(_, _, _), -0.0031062855905378286) :- fewer_carrying_2_than_todo_tightened, !.
delta(227, walk(_, _, _), 0.00031234513299516805) :- !.
delta(227, pickup_spanner(_, _, _), 0.003094611415557979) :- fewer_carrying_2_than_todo_tightened, !.
delta(227, pickup_spanner(_, _, _), -0.00031234513299516805) :- !.
delta(227, _, 0.0).

% tree 228: step size 1.0, 220 examples, 5 leaves
delta(228, walk(_, _, _), -0.0030173278936225793) :- fewer_carrying_2_than_todo_tightened, !.
delta(228, walk(_, _, _), 0.0004326266093547719) :- !.
delta(228, pickup_spanner(_, _, _), 0.0030112506168241144) :- fewer_carrying_2_than_todo_tightened, !.
delta(228, pickup_spanner(_, _, _), -0.0004326266093547719) :- !.
delta(228, _, 0.0).

% tree 229: step size 1.0, 216 examples, 5 leaves
delta(229, walk(_, _, _), -0.003161568404185871) :- fewer_carrying_2_than_todo_tightened, !.
delta(229, walk(_, _, _), 0.00035258834239249346) :- !.
delta(229, pickup_spanner(_, _, _), 0.003161568404185871) :- fewer_carrying_2_than_todo_tightened, !.
delta(229, pickup_spanner(_, _, _), -0.00035258834239249346) :- !.
delta(229, _, 0.0).

% tree 230: step size 1.0, 216 examples, 8 leaves
delta(230, walk(_, Location, _), 0.00410655858215529) :- fewer_at_2_than_todo_tightened, at(_, Location), !.
delta(230, walk(_, _, _), -0.0001900950357344714) :- fewer_at_2_than_todo_tightened, !.
delta(230, walk(_, _, _), -0.0024210556052713427) :- fewer_carrying_2_than_todo_tightened, !.
delta(230, walk(_, _, _), 0.00017983528510271397) :- !.
delta(230, pickup_spanner(_, _, _), -0.003915675173257422) :- fewer_at_2_than_todo_tightened, !.
delta(230, pickup_spanner(_, _, _), 0.002417631129048515) :- fewer_carrying_2_than_todo_tightened, !.
delta(230, pickup_spanner(_, _, _), -0.00017983528510271397) :- !.
delta(230, _, 0.0).

% tree 231: step size 1.0, 201 examples, 5 leaves
delta(231, walk(_, _, _), -0.0030609766494909354) :- fewer_carrying_2_than_todo_tightened, !.
delta(231, walk(_, _, _), 0.00039302007854293) :- !.
delta(231, pickup_spanner(_, _, _), 0.003052369645218966) :- fewer_carrying_2_than_todo_tightened, !.
delta(231, pickup_spanner(_, _, _), -0.00039302007854293) :- !.
delta(231, _, 0.0).

% tree 232: step size 1.0, 201 examples, 5 leaves
delta(232, walk(_, _, _), -0.002676530441479911) :- fewer_carrying_2_than_todo_tightened, !.
delta(232, walk(_, _, _), 0.0003110146098866854) :- !.
delta(232, pickup_spanner(_, _, _), 0.002676530441479911) :- fewer_carrying_2_than_todo_tightened, !.
delta(232, pickup_spanner(_, _, _), -0.0003110146098866854) :- !.
delta(232, _, 0.0).

% tree 233: step size 1.0, 221 examples, 5 leaves
delta(233, walk(_, _, _), -0.002700046299549336) :- fewer_carrying_2_than_todo_tightened, !.
delta(233, walk(_, _, _), 0.0003081790844670109) :- !.
delta(233, pickup_spanner(_, _, _), 0.002700046299549336) :- fewer_carrying_2_than_todo_tightened, !.
delta(233, pickup_spanner(_, _, _), -0.0003081790844670109) :- !.
delta(233, _, 0.0).

% tree 234: step size 1.0, 207 examples, 5 leaves
delta(234, walk(_, _, _), -0.0035293049569935027) :- fewer_carrying_2_than_todo_tightened, !.
delta(234, walk(_, _, _), 0.00022245685270329117) :- !.
delta(234, pickup_spanner(_, _, _), 0.003524397170689723) :- fewer_carrying_2_than_todo_tightened, !.
delta(234, pickup_spanner(_, _, _), -0.00022245685270329117) :- !.
delta(234, _, 0.0).

% tree 235: step size 1.0, 206 examples, 5 leaves
delta(235, walk(_, _, _), -0.002744605063642646) :- fewer_carrying_2_than_todo_tightened, !.
delta(235, walk(_, _, _), 0.0003329987646344513) :- !.
delta(235, pickup_spanner(_, _, _), 0.002740800488243725) :- fewer_carrying_2_than_todo_tightened, !.
delta(235, pickup_spanner(_, _, _), -0.0003329987646344513) :- !.
delta(235, _, 0.0).

% tree 236: step size 1.0, 215 examples, 10 leaves
delta(236, walk(_, Location, _), -0.0016951850531474611) :- at(_, Location), fewer_carrying_2_than_todo_tightened, !.
delta(236, walk(_, Location, _), 0.0001995116558583967) :- at(_, Location), !.
delta(236, walk(_, Location, Man), -2.8931965891257213e-5) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_at_2_than_todo_tightened, !.
delta(236, walk(_, Location, Man), 0.002757477188880106) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(236, walk(_, _, _), -0.0002452832246137232) :- !.
delta(236, pickup_spanner(_, _, Man), 0.00015304641356473443) :- carrying(Man, _), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(236, pickup_spanner(_, _, Man), -0.00012844522143582436) :- carrying(Man, _), fewer_at_2_than_todo_tightened, !.
delta(236, pickup_spanner(_, _, Man), -0.0013687784468936178) :- carrying(Man, _), !.
delta(236, pickup_spanner(_, _, _), 0.0003617762320445924) :- !.
delta(236, _, 0.0).

% tree 237: step size 1.0, 216 examples, 8 leaves
delta(237, walk(_, Location, Man), -0.0026961032217226754) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), fewer_carrying_2_than_todo_tightened, !.
delta(237, walk(_, Location, Man), 0.0003791684642213766) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(237, walk(_, Location, _), -7.505803590375864e-5) :- at(_, Location), !.
delta(237, walk(_, _, _), 0.07783488405402686) :- !.
delta(237, pickup_spanner(_, _, Man), 0.0026203124695809528) :- carrying(Man, _), fewer_carrying_2_than_todo_tightened, !.
delta(237, pickup_spanner(_, _, Man), -0.0003791684642213766) :- carrying(Man, _), !.
delta(237, pickup_spanner(_, _, _), -0.07566476150139961) :- !.
delta(237, _, 0.0).

% tree 238: step size 1.0, 205 examples, 5 leaves
delta(238, walk(_, _, _), -0.0023884700907801973) :- fewer_carrying_2_than_todo_tightened, !.
delta(238, walk(_, _, _), 0.00037863733629415027) :- !.
delta(238, pickup_spanner(_, _, _), 0.002385196621330186) :- fewer_carrying_2_than_todo_tightened, !.
delta(238, pickup_spanner(_, _, _), -0.0003779023956724642) :- !.
delta(238, _, 0.0).

% tree 239: step size 1.0, 209 examples, 5 leaves
delta(239, walk(_, _, _), -0.002486330903279913) :- fewer_carrying_2_than_todo_tightened, !.
delta(239, walk(_, _, _), 0.00031985263072058993) :- !.
delta(239, pickup_spanner(_, _, _), 0.002486330903279913) :- fewer_carrying_2_than_todo_tightened, !.
delta(239, pickup_spanner(_, _, _), -0.00031985263072058993) :- !.
delta(239, _, 0.0).

% tree 240: step size 1.0, 207 examples, 5 leaves
delta(240, walk(_, _, _), -0.0028033740332699497) :- fewer_carrying_2_than_todo_tightened, !.
delta(240, walk(_, _, _), 0.00022116221748865562) :- !.
delta(240, pickup_spanner(_, _, _), 0.002799563134196654) :- fewer_carrying_2_than_todo_tightened, !.
delta(240, pickup_spanner(_, _, _), -0.00022116221748865562) :- !.
delta(240, _, 0.0).

% tree 241: step size 1.0, 217 examples, 7 leaves
delta(241, walk(_, Location, Man), 0.07584289097963076) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(241, walk(_, Location, _), -3.6510076811700705e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(241, walk(_, _, _), -0.0016265086010971508) :- fewer_carrying_2_than_todo_tightened, !.
delta(241, walk(_, _, _), 0.00026116158955234774) :- !.
delta(241, pickup_spanner(_, _, Man), -0.07477797812917336) :- carrying(Man, _), !.
delta(241, pickup_spanner(_, _, _), 0.00044865689235817154) :- !.
delta(241, _, 0.0).

% tree 242: step size 1.0, 214 examples, 5 leaves
delta(242, walk(_, _, _), -0.0027942454022418075) :- fewer_carrying_2_than_todo_tightened, !.
delta(242, walk(_, _, _), 0.0002642992646906939) :- !.
delta(242, pickup_spanner(_, _, _), 0.0027942454022418075) :- fewer_carrying_2_than_todo_tightened, !.
delta(242, pickup_spanner(_, _, _), -0.0002642992646906939) :- !.
delta(242, _, 0.0).

% tree 243: step size 1.0, 206 examples, 5 leaves
delta(243, walk(_, _, _), -0.0025535872706474835) :- fewer_carrying_2_than_todo_tightened, !.
delta(243, walk(_, _, _), 0.00028175562688032257) :- !.
delta(243, pickup_spanner(_, _, _), 0.0025433173700843) :- fewer_carrying_2_than_todo_tightened, !.
delta(243, pickup_spanner(_, _, _), -0.00028175562688032257) :- !.
delta(243, _, 0.0).

% tree 244: step size 1.0, 212 examples, 5 leaves
delta(244, walk(_, _, _), -0.0029836705745694314) :- fewer_carrying_2_than_todo_tightened, !.
delta(244, walk(_, _, _), 0.00025816898774469395) :- !.
delta(244, pickup_spanner(_, _, _), 0.0029836705745694314) :- fewer_carrying_2_than_todo_tightened, !.
delta(244, pickup_spanner(_, _, _), -0.00025816898774469395) :- !.
delta(244, _, 0.0).

% tree 245: step size 1.0, 215 examples, 5 leaves
delta(245, walk(_, _, _), -0.002071547730472964) :- fewer_carrying_2_than_todo_tightened, !.
delta(245, walk(_, _, _), 0.0002860157252616752) :- !.
delta(245, pickup_spanner(_, _, _), 0.002071547730472964) :- fewer_carrying_2_than_todo_tightened, !.
delta(245, pickup_spanner(_, _, _), -0.0002860157252616752) :- !.
delta(245, _, 0.0).

% tree 246: step size 1.0, 207 examples, 5 leaves
delta(246, walk(_, _, _), -0.0023321968505181346) :- fewer_carrying_2_than_todo_tightened, !.
delta(246, walk(_, _, _), 0.00027193379530520903) :- !.
delta(246, pickup_spanner(_, _, _), 0.0022717211073227687) :- fewer_carrying_2_than_todo_tightened, !.
delta(246, pickup_spanner(_, _, _), -0.00027193379530520903) :- !.
delta(246, _, 0.0).

% tree 247: step size 1.0, 219 examples, 5 leaves
delta(247, walk(_, _, _), -0.0021532254808309566) :- fewer_carrying_2_than_todo_tightened, !.
delta(247, walk(_, _, _), 0.00029994106975884895) :- !.
delta(247, pickup_spanner(_, _, _), 0.0021503734651693077) :- fewer_carrying_2_than_todo_tightened, !.
delta(247, pickup_spanner(_, _, _), -0.00029994106975884895) :- !.
delta(247, _, 0.0).

% tree 248: step size 1.0, 213 examples, 10 leaves
delta(248, walk(_, Location, _), 0.005326993000134559) :- fewer_at_2_than_todo_tightened, at(_, Location), !.
delta(248, walk(_, _, _), -0.0001383998318361245) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(248, walk(_, _, _), 3.190682465946617e-5) :- fewer_at_2_than_todo_tightened, !.
delta(248, walk(_, _, _), -0.002116324178104258) :- fewer_carrying_2_than_todo_tightened, !.
delta(248, walk(_, _, _), 0.00012828267547152029) :- !.
delta(248, pickup_spanner(_, _, Man), -0.005246062869835065) :- fewer_at_2_than_todo_tightened, carrying(Man, _), !.
delta(248, pickup_spanner(_, _, _), 2.632150387451583e-5) :- fewer_at_2_than_todo_tightened, !.
delta(248, pickup_spanner(_, _, _), 0.002116324178104258) :- fewer_carrying_2_than_todo_tightened, !.
delta(248, pickup_spanner(_, _, _), -0.00012828267547152029) :- !.
delta(248, _, 0.0).
