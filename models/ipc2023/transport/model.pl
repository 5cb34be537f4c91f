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
model(domain_sha256, '587ab63ec7024ec6482edb11aa4f0e2f47de01eafc46bf800388a6e11d205e1b').
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
model(literal, nearer_at(location, location, location)).
model(literal, wanted_at(vehicle, location)).
model(literal, toward_wanted_at(vehicle, location, location)).
model(literal, could_pick_up(vehicle, location)).
model(literal, toward_could_pick_up(vehicle, location, location)).
model(literal, could_pick_up_for_todo_at_any_location(vehicle, location)).
model(literal, toward_could_pick_up_for_todo_at_any_location(vehicle, location, location)).
model(literal, could_pick_up_for_todo_at_package_any(vehicle, location)).
model(literal, toward_could_pick_up_for_todo_at_package_any(vehicle, location, location)).
model(literal, could_drop(vehicle, location)).
model(literal, could_drop_todo_at(vehicle, location)).
model(literal, toward_could_drop_todo_at(vehicle, location, location)).
model(literal, could_drop_for_todo_at_any_location(vehicle, location)).
model(literal, toward_could_drop_for_todo_at_any_location(vehicle, location, location)).
model(literal, nearer_capacity(size, size, size)).
model(literal, could_drop_for_todo_at_package_any(vehicle, size)).
model(literal, toward_could_drop_for_todo_at_package_any(vehicle, size, size)).
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
model(bias_sha256, fd785a18c32d1f4db94a9f19054e2f643770a2dc3cfc9b56a64ecb9821737e80).
model(option, episodes=1000000).
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
model(option, models=one).
model(option, unrewarded=keep).
model(option, line_search=0).
model(option, ratio_clip=0.2).
model(option, critic=none).
model(option, trace=1.0).
model(option, cut_off=end).
model(option, critic_step_size=0.5).
model(option, critic_trees=1).
model(option, normalise=no).
model(tree, max_depth=4).
model(tree, min_examples=2).
model(tree, min_variance=1.0e-9).
model(tree, significance=1.0).
model(tree, granularity=0).
model(curve, evaluate_every=0).
model(curve, seconds=120.0).
model(trained_episodes, 506).
model(trees, 33).

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

% tree 1: step size 1.0, 203 examples, 5 leaves
delta(1, pick_up(_, _, _, _, _), 0.5100775103237187) :- !.
delta(1, _, -0.5100775103237187) :- fewer_at_2_than_at_1, !.
delta(1, drive(Vehicle, _, Location), 0.4277215742158637) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(1, drive(_, _, _), -0.2841685660644171) :- !.
delta(1, _, -0.09387585549943835).

% tree 2: step size 1.0, 202 examples, 5 leaves
delta(2, pick_up(_, _, _, _, _), 0.4124543218941981) :- !.
delta(2, _, -0.4124543218941981) :- fewer_at_2_than_at_1, !.
delta(2, drive(Vehicle, _, Location), 0.4123328951557298) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(2, drive(_, _, _), -0.32615437147323467) :- !.
delta(2, _, -0.01655220589822251).

% tree 3: step size 1.0, 210 examples, 7 leaves
delta(3, drive(_, Location, Location2), -0.005559544163466172) :- at(Locatable, Location2), todo_at(Locatable, Location3), road(Location4, Location2), nearer_at(Location4, Location, Location3), !.
delta(3, drive(_, _, Location), 0.4395328534574016) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(3, drive(Vehicle, _, Location), 0.3971240889766448) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(3, drive(Vehicle, Location, Location2), -0.015129122084544557) :- road(Location3, Location), toward_could_drop_todo_at(Vehicle, Location2, Location3), !.
delta(3, drive(_, _, _), -0.6924792902393841) :- !.
delta(3, _, 0.2404662832265586) :- fewer_at_2_than_at_1, !.
delta(3, _, 0.03705107888267305).

% tree 4: step size 1.0, 209 examples, 7 leaves
delta(4, drive(Vehicle, _, Location), 0.5026791852579071) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(4, drive(_, _, Location), -0.033466373001644484) :- at(Locatable, Location), todo_at(Locatable, _), at(Locatable2, Location), vehicle(Locatable2), !.
delta(4, drive(_, _, Location), 0.35109019571528655) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(4, drive(_, Location, Location2), -0.004273896861065313) :- todo_at(Locatable, Location2), at(Locatable, Location), !.
delta(4, drive(_, _, _), -0.6080702066889592) :- !.
delta(4, _, 0.28560918286674314) :- fewer_in_2_than_at_2, !.
delta(4, _, -0.07732899968349316).

% tree 5: step size 1.0, 207 examples, 10 leaves
delta(5, drive(Vehicle, Location, Location2), -0.05318692918805208) :- at(Vehicle, Location3), toward_could_drop_todo_at(Vehicle, Location3, Location2), todo_at(Locatable, Location2), at(Locatable, Location), !.
delta(5, drive(Vehicle, _, Location), 0.45796754440974774) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(5, drive(_, _, Location), -0.053058405847108185) :- at(Locatable, Location), todo_at(Locatable, _), at(Locatable2, Location), vehicle(Locatable2), !.
delta(5, drive(_, _, Location), 0.27978146735956305) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(5, drive(_, _, _), -0.5009617936221638) :- !.
delta(5, pick_up(_, _, _, _, _), 0.21503525191645) :- fewer_in_2_than_todo_at_1, !.
delta(5, _, -0.03969424229663303) :- fewer_in_2_than_todo_at_1, !.
delta(5, pick_up(_, _, _, _, _), -0.21999323263140838) :- !.
delta(5, _, 0.15604767109358775) :- fewer_at_2_than_at_1, !.
delta(5, _, -0.08152334198981447).

% tree 6: step size 1.0, 204 examples, 11 leaves
delta(6, drive(Vehicle, _, Location), -0.2800542175654319) :- road(Location2, Location), toward_could_pick_up(Vehicle, Location, Location2), !.
delta(6, drive(Vehicle, _, Location), -0.24751267013395684) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(6, drive(_, Location, Location2), -0.006693125164569575) :- todo_at(Locatable, Location2), at(Locatable, Location), !.
delta(6, drive(_, _, _), 0.5935074697261359) :- !.
delta(6, pick_up(_, _, _, _, _), 0.11065389858752593) :- fewer_at_2_than_todo_at_1, !.
delta(6, _, -0.06935580188847876) :- fewer_at_2_than_todo_at_1, fewer_at_2_than_at_1, !.
delta(6, _, -0.000957177553497707) :- fewer_at_2_than_todo_at_1, !.
delta(6, pick_up(_, Location, _, _, _), -0.6110379092942431) :- todo_at(_, Location), !.
delta(6, pick_up(_, _, _, _, _), 0.1053614323812685) :- !.
delta(6, _, -0.13651718201134924) :- fewer_in_2_than_at_2, !.
delta(6, _, 0.1176595927520482).

% tree 7: step size 1.0, 204 examples, 8 leaves
delta(7, pick_up(_, _, Package, _, _), 0.24183614748095034) :- todo_at(Package, _), !.
delta(7, pick_up(_, _, _, _, _), -0.5535982390721617) :- !.
delta(7, _, -0.12209838603764483) :- fewer_capacity_1_than_todo_at_1, fewer_at_2_than_at_1, !.
delta(7, drive(_, _, _), 0.020544748919106813) :- fewer_capacity_1_than_todo_at_1, !.
delta(7, _, -0.020057463409627715) :- fewer_capacity_1_than_todo_at_1, !.
delta(7, _, 0.27539587023073286) :- fewer_at_2_than_at_1, !.
delta(7, drive(_, _, _), 0.008776685192396293) :- !.
delta(7, _, -0.010612716275758449).

% tree 8: step size 1.0, 202 examples, 8 leaves
delta(8, pick_up(_, _, Package, _, _), 0.26635905326992) :- todo_at(Package, _), !.
delta(8, pick_up(_, _, _, _, _), -0.5269319359186377) :- !.
delta(8, _, -0.11951708857382264) :- fewer_capacity_1_than_todo_at_1, fewer_at_2_than_at_1, !.
delta(8, drive(_, _, _), -0.012336531948686733) :- fewer_capacity_1_than_todo_at_1, !.
delta(8, _, 0.01121868226900991) :- fewer_capacity_1_than_todo_at_1, !.
delta(8, _, 0.2514599561688241) :- fewer_at_2_than_at_1, !.
delta(8, drive(_, _, _), 0.032594732082054746) :- !.
delta(8, _, -0.03813384823580976).

% tree 9: step size 1.0, 209 examples, 11 leaves
delta(9, pick_up(_, Location, Package, _, _), 0.2086603856699786) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(9, pick_up(_, Location, _, _, _), -0.4432308855497735) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(9, pick_up(_, _, _, _, _), 0.0033704362763724016) :- !.
delta(9, drive(_, _, _), -0.06725832553488585) :- fewer_capacity_2_than_todo_at_1, fewer_in_2_than_todo_at_1, !.
delta(9, drive(_, _, _), 0.21564664198475036) :- fewer_capacity_2_than_todo_at_1, !.
delta(9, _, 0.026357994018478943) :- fewer_capacity_2_than_todo_at_1, fewer_in_2_than_in_1, !.
delta(9, _, -0.2537373274607518) :- fewer_capacity_2_than_todo_at_1, !.
delta(9, _, 0.01611259158626852) :- fewer_at_2_than_at_1, fewer_in_2_than_todo_at_1, !.
delta(9, _, 0.21937874389459275) :- fewer_at_2_than_at_1, !.
delta(9, drive(_, _, _), -0.13057198917518967) :- !.
delta(9, _, 0.1505484858932473).

% tree 10: step size 1.0, 215 examples, 12 leaves
delta(10, drive(Vehicle, Location, Location2), -0.022555397846323693) :- at(Vehicle, Location3), toward_could_drop_todo_at(Vehicle, Location3, Location2), todo_at(Locatable, Location2), at(Locatable, Location), !.
delta(10, drive(Vehicle, _, Location), 0.5586357103919225) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(10, drive(Vehicle, Location, Location2), -0.06683720000348503) :- at(Vehicle, Location3), toward_could_pick_up(Vehicle, Location2, Location3), at(Locatable, Location), todo_at(Locatable, _), !.
delta(10, drive(Vehicle, _, Location), 0.36003097971656123) :- at(Vehicle, Location2), toward_could_pick_up(Vehicle, Location, Location2), !.
delta(10, drive(Vehicle, _, Location), 0.03843242621403892) :- at(Vehicle, Location2), toward_could_pick_up_for_todo_at_package_any(Vehicle, Location2, Location), !.
delta(10, drive(_, _, _), -0.4091192379289771) :- !.
delta(10, _, 0.0840287613775237) :- fewer_at_2_than_at_1, fewer_capacity_1_than_at_2, !.
delta(10, _, 0.026028756362960526) :- fewer_at_2_than_at_1, fewer_capacity_1_than_todo_at_1, !.
delta(10, _, -0.3405514361074683) :- fewer_at_2_than_at_1, !.
delta(10, _, -0.05100262973179429) :- fewer_capacity_1_than_at_2, fewer_in_2_than_todo_at_1, !.
delta(10, _, -0.00014309584471822293) :- fewer_capacity_1_than_at_2, !.
delta(10, _, 0.07048015130675964).

% tree 11: step size 1.0, 214 examples, 12 leaves
delta(11, pick_up(Vehicle, Location, Package, Size, _), 0.026779342951665733) :- goal_at(Package, Location2), could_pick_up(Vehicle, Location2), road(Location3, Location), nearer_at(Location3, Location, Location2), capacity(Vehicle2, Size), at(Vehicle2, Location3), !.
delta(11, pick_up(Vehicle, Location, Package, _, _), -0.546488753882465) :- goal_at(Package, Location2), could_pick_up(Vehicle, Location2), road(Location3, Location), nearer_at(Location3, Location, Location2), !.
delta(11, pick_up(Vehicle, _, Package, _, _), 0.04943194185745003) :- goal_at(Package, Location), could_pick_up(Vehicle, Location), !.
delta(11, pick_up(_, _, _, _, _), 0.2662425551832483) :- !.
delta(11, drive(_, _, Location), -0.24858611919709125) :- fewer_in_2_than_todo_at_1, todo_at(_, Location), !.
delta(11, drive(_, _, _), 0.2185304617659976) :- fewer_in_2_than_todo_at_1, !.
delta(11, _, 0.05551840781764623) :- fewer_in_2_than_todo_at_1, fewer_in_2_than_in_1, !.
delta(11, _, -0.2741235098046715) :- fewer_in_2_than_todo_at_1, !.
delta(11, _, 1.3003134116266673e-18) :- fewer_at_2_than_at_1, fewer_capacity_2_than_todo_at_1, !.
delta(11, _, 0.2526893005168567) :- fewer_at_2_than_at_1, !.
delta(11, drive(_, _, _), -0.06762435364849972) :- !.
delta(11, _, 0.0673931343694394).

% tree 12: step size 1.0, 209 examples, 12 leaves
delta(12, drive(Vehicle, _, Location), -0.03875143283872294) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), fewer_in_2_than_todo_at_2, fewer_at_2_than_todo_at_1, !.
delta(12, drive(Vehicle, _, Location), 0.14263687511143186) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), fewer_in_2_than_todo_at_2, !.
delta(12, drive(Vehicle, _, Location), -0.46131548540022443) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(12, drive(Vehicle, Location, Location2), 0.14229784543112317) :- road(Location3, Location), toward_could_pick_up_for_todo_at_package_any(Vehicle, Location3, Location), at(Vehicle, Location4), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location4), !.
delta(12, drive(Vehicle, Location, _), -0.18766474531233976) :- road(Location2, Location), toward_could_pick_up_for_todo_at_package_any(Vehicle, Location2, Location), !.
delta(12, drive(Vehicle, Location, _), -0.07571581601688751) :- road(Location2, Location), could_pick_up_for_todo_at_package_any(Vehicle, Location2), !.
delta(12, drive(_, _, _), 0.5366261444423077) :- !.
delta(12, _, 0.0) :- fewer_in_2_than_at_2, fewer_capacity_2_than_todo_at_2_at_2, fewer_in_2_than_in_1, !.
delta(12, _, 0.015879471090475872) :- fewer_in_2_than_at_2, fewer_capacity_2_than_todo_at_2_at_2, !.
delta(12, _, -0.24904025368933924) :- fewer_in_2_than_at_2, fewer_at_2_than_at_1, !.
delta(12, _, -0.03718126570294823) :- fewer_in_2_than_at_2, !.
delta(12, _, 0.04876816713926414).

% tree 13: step size 1.0, 216 examples, 12 leaves
delta(13, drop(_, Location, Package, _, Size), 0.03466727558037182) :- todo_at(Package, Location), capacity(Vehicle, Size), in(_, Vehicle), road(Location2, Location), todo_at(_, Location2), !.
delta(13, drop(_, Location, Package, _, Size), -0.13575901505800259) :- todo_at(Package, Location), capacity(Vehicle, Size), in(_, Vehicle), !.
delta(13, drop(_, Location, Package, _, _), 0.614958146445583) :- todo_at(Package, Location), !.
delta(13, drop(_, _, _, _, _), -0.6074659377799557) :- !.
delta(13, drive(Vehicle, _, _), 0.19648108574737622) :- fewer_in_2_than_todo_at_2, capacity(Vehicle, Size), capacity_predecessor(Size, _), !.
delta(13, drive(_, _, _), -0.19445383461267868) :- fewer_in_2_than_todo_at_2, !.
delta(13, _, -0.07112962980505631) :- fewer_in_2_than_todo_at_2, fewer_in_2_than_todo_at_2_at_2, !.
delta(13, _, 0.16288415598011913) :- fewer_in_2_than_todo_at_2, !.
delta(13, _, 0.08047693879714585) :- fewer_at_2_than_todo_at_1, fewer_at_2_than_at_1, !.
delta(13, _, 0.00108293583509854) :- fewer_at_2_than_todo_at_1, !.
delta(13, _, -0.16661531658893758) :- fewer_in_2_than_at_2, !.
delta(13, _, -0.02334177245179966).

% tree 14: step size 1.0, 214 examples, 14 leaves
delta(14, pick_up(_, Location, Package, _, _), 0.04238163746657029) :- goal_at(_, Location), todo_at(Package, Location2), road(Location, Location2), !.
delta(14, pick_up(Vehicle, Location, _, _, _), 0.01658817973997438) :- goal_at(Locatable, Location), done_at(Locatable, Location2), could_pick_up_for_todo_at_package_any(Vehicle, Location2), !.
delta(14, pick_up(_, Location, _, _, _), -0.4874304708420227) :- goal_at(_, Location), !.
delta(14, pick_up(_, _, _, Size, Size2), -0.028975459474670177) :- capacity(Vehicle, Size), could_drop_for_todo_at_package_any(Vehicle, Size2), !.
delta(14, pick_up(Vehicle, Location, _, _, _), -0.0033719184730764424) :- road(Location2, Location), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(14, pick_up(_, _, _, _, _), 0.21659314746824937) :- !.
delta(14, drive(Vehicle, Location, Location2), 0.07097070087529689) :- fewer_capacity_2_than_todo_at_1, road(Location3, Location), toward_could_pick_up(Vehicle, Location3, Location2), !.
delta(14, drive(_, _, _), -0.2875173195427766) :- fewer_capacity_2_than_todo_at_1, !.
delta(14, _, -0.011477463194163729) :- fewer_capacity_2_than_todo_at_1, fewer_in_2_than_todo_at_1, !.
delta(14, _, 0.15875018163858848) :- fewer_capacity_2_than_todo_at_1, !.
delta(14, drive(Vehicle, _, Location), -0.2638959220808849) :- road(Location2, Location), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(14, drive(_, _, _), 0.35275580974922194) :- !.
delta(14, _, 0.04083617409606888) :- fewer_capacity_1_than_at_2, !.
delta(14, _, -0.045636272886062056).

% tree 15: step size 1.0, 211 examples, 12 leaves
delta(15, drop(Vehicle, Location, Package, _, _), -0.0065668378541979) :- todo_at(Package, Location), road(Location2, Location), could_pick_up_for_todo_at_package_any(Vehicle, Location2), !.
delta(15, drop(Vehicle, Location, Package, _, _), -0.00334991936792539) :- todo_at(Package, Location), todo_at(Package, Location2), could_pick_up_for_todo_at_package_any(Vehicle, Location2), !.
delta(15, drop(_, Location, Package, _, _), 0.431463107240614) :- todo_at(Package, Location), !.
delta(15, drop(_, _, _, _, _), -0.2949846235411789) :- !.
delta(15, drive(Vehicle, Location, _), 0.27645070517522086) :- fewer_in_2_than_todo_at_2, road(Location2, Location), could_pick_up_for_todo_at_package_any(Vehicle, Location2), !.
delta(15, drive(_, _, _), -0.1350886816050639) :- fewer_in_2_than_todo_at_2, !.
delta(15, _, -0.22990724354468672) :- fewer_in_2_than_todo_at_2, fewer_capacity_2_than_at_2, !.
delta(15, _, 0.0264615304400347) :- fewer_in_2_than_todo_at_2, !.
delta(15, drive(Vehicle, _, Location), 0.13591220688117803) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(15, drive(_, _, _), -0.33996865964460116) :- !.
delta(15, _, -0.05546358880153886) :- fewer_in_2_than_at_2, !.
delta(15, _, 0.0794898987947153).

% tree 16: step size 1.0, 223 examples, 15 leaves
delta(16, pick_up(Vehicle, Location, _, _, _), -0.03999992967307197) :- capacity(Vehicle, Size), capacity_predecessor(Size, Size2), capacity(Vehicle2, Size2), could_pick_up_for_todo_at_package_any(Vehicle2, Location), at(Vehicle2, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(16, pick_up(Vehicle, Location, _, _, _), 0.10009107998155083) :- capacity(Vehicle, Size), capacity_predecessor(Size, Size2), capacity(Vehicle2, Size2), could_pick_up_for_todo_at_package_any(Vehicle2, Location), !.
delta(16, pick_up(Vehicle, _, _, _, _), 0.01064549705938207) :- capacity(Vehicle, Size), capacity_predecessor(Size, _), fewer_at_2_than_todo_at_1, !.
delta(16, pick_up(Vehicle, _, _, _, _), -0.20728979735943906) :- capacity(Vehicle, Size), capacity_predecessor(Size, _), !.
delta(16, pick_up(_, _, Package, _, _), -0.021616828107284075) :- done_at(Package, Location), todo_at(_, Location), !.
delta(16, pick_up(Vehicle, _, Package, _, _), -0.0003487107438873839) :- done_at(Package, Location), could_pick_up_for_todo_at_package_any(Vehicle, Location), !.
delta(16, pick_up(_, _, _, _, _), 0.28566279797901034) :- !.
delta(16, drive(Vehicle, Location, _), -0.13689895585659567) :- fewer_capacity_2_than_todo_at_2, road(Location2, Location), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(16, drive(_, _, _), 0.22582891062152724) :- fewer_capacity_2_than_todo_at_2, !.
delta(16, _, 0.0055255387652868235) :- fewer_capacity_2_than_todo_at_2, fewer_capacity_1_than_in_1, !.
delta(16, _, -0.09412982210583011) :- fewer_capacity_2_than_todo_at_2, !.
delta(16, _, 0.014023167128074807) :- fewer_in_2_than_todo_at_2, fewer_in_2_than_in_1, !.
delta(16, _, -0.18636563039417992) :- fewer_in_2_than_todo_at_2, !.
delta(16, drive(_, _, _), -0.018352122470645937) :- !.
delta(16, _, 0.06444931807997908).

% tree 17: step size 1.0, 204 examples, 15 leaves
delta(17, pick_up(Vehicle, Location, Package, _, _), 0.09508780027236105) :- goal_at(Package, Location2), at(_, Location2), road(Location3, Location), could_pick_up_for_todo_at_package_any(Vehicle, Location3), fewer_capacity_2_than_todo_at_1, !.
delta(17, pick_up(Vehicle, Location, Package, _, _), -0.040407564810900624) :- goal_at(Package, Location2), at(_, Location2), road(Location3, Location), could_pick_up_for_todo_at_package_any(Vehicle, Location3), !.
delta(17, pick_up(_, _, Package, _, _), -0.20246500887483002) :- goal_at(Package, Location), at(_, Location), road(Location2, Location), todo_at(_, Location2), !.
delta(17, pick_up(_, _, Package, _, _), 0.0044621030991847275) :- goal_at(Package, Location), at(_, Location), !.
delta(17, pick_up(_, Location, _, Size, _), -0.05742649728985605) :- capacity(Vehicle, Size), could_drop_todo_at(Vehicle, Location), !.
delta(17, pick_up(_, _, _, _, _), -0.008213581185683841) :- fewer_capacity_1_than_at_2, !.
delta(17, pick_up(_, _, _, _, _), 0.23052087215213357) :- !.
delta(17, drive(Vehicle, _, _), -0.20601524341928146) :- fewer_in_2_than_at_2, at(Vehicle, Location), could_pick_up_for_todo_at_package_any(Vehicle, Location), !.
delta(17, drive(_, _, _), 0.16222571697067215) :- fewer_in_2_than_at_2, !.
delta(17, _, 0.03234589472313631) :- fewer_in_2_than_at_2, fewer_capacity_1_than_todo_at_1, !.
delta(17, _, -0.2101187088398252) :- fewer_in_2_than_at_2, !.
delta(17, drive(Vehicle, Location, Location2), 0.028569032075201867) :- road(Location3, Location), toward_could_drop_todo_at(Vehicle, Location3, Location2), !.
delta(17, drive(_, _, _), -0.14622418557601732) :- !.
delta(17, _, 0.21435913235566323) :- fewer_capacity_2_than_todo_at_1, !.
delta(17, _, -0.011611943330947743).

% tree 18: step size 1.0, 213 examples, 13 leaves
delta(18, drop(_, Location, Package, _, _), 0.07396309353677544) :- todo_at(Package, Location), fewer_in_2_than_todo_at_2, fewer_in_2_than_in_1, !.
delta(18, drop(_, Location, Package, _, _), -0.10936166477121154) :- todo_at(Package, Location), fewer_in_2_than_todo_at_2, !.
delta(18, drop(_, Location, Package, _, _), -0.004487277416173825) :- todo_at(Package, Location), fewer_capacity_2_than_todo_at_2, !.
delta(18, drop(_, Location, Package, _, _), 0.2854380422988026) :- todo_at(Package, Location), !.
delta(18, drop(_, _, _, _, _), -0.2901504699129174) :- !.
delta(18, _, -0.006535659562230347) :- fewer_in_2_than_todo_at_2, fewer_capacity_2_than_at_2, fewer_capacity_2_than_todo_at_1, !.
delta(18, _, 0.043500944959823915) :- fewer_in_2_than_todo_at_2, fewer_capacity_2_than_at_2, !.
delta(18, _, -0.006587937093642862) :- fewer_in_2_than_todo_at_2, fewer_capacity_1_than_todo_at_1, !.
delta(18, _, 0.16552563177371904) :- fewer_in_2_than_todo_at_2, !.
delta(18, _, 0.010680333888121599) :- fewer_capacity_2_than_at_2, fewer_capacity_2_than_in_1, !.
delta(18, _, -0.1916769829363299) :- fewer_capacity_2_than_at_2, !.
delta(18, drive(_, _, _), 0.024113898693156846) :- !.
delta(18, _, -0.010668888835376478).

% tree 19: step size 1.0, 210 examples, 13 leaves
delta(19, drop(Vehicle, Location, Package, _, _), 0.002615912455213654) :- todo_at(Package, Location), todo_at(Package, Location2), could_pick_up_for_todo_at_package_any(Vehicle, Location2), fewer_capacity_1_than_todo_at_1, !.
delta(19, drop(Vehicle, Location, Package, _, _), -0.014210903501611274) :- todo_at(Package, Location), todo_at(Package, Location2), could_pick_up_for_todo_at_package_any(Vehicle, Location2), !.
delta(19, drop(_, Location, Package, _, _), 0.3340186912562452) :- todo_at(Package, Location), !.
delta(19, drop(Vehicle, _, _, _, Size), -0.007724685062845725) :- capacity(Vehicle2, Size), in(_, Vehicle2), at(Vehicle2, Location), could_drop_todo_at(Vehicle, Location), !.
delta(19, drop(_, _, _, _, Size), 0.00902160042311175) :- capacity(Vehicle, Size), in(_, Vehicle), !.
delta(19, drop(_, _, _, _, _), -0.20112771828080558) :- !.
delta(19, _, 0.0) :- fewer_at_2_than_todo_at_2, fewer_capacity_2_than_todo_at_1, fewer_capacity_2_than_todo_at_2_at_2, !.
delta(19, _, -0.15162541599682594) :- fewer_at_2_than_todo_at_2, fewer_capacity_2_than_todo_at_1, !.
delta(19, _, 0.0008284209507513679) :- fewer_at_2_than_todo_at_2, !.
delta(19, drive(Vehicle, _, Location), -0.2764853824653114) :- at(Vehicle, Location2), toward_could_drop_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(19, drive(_, _, _), 0.15813415707310255) :- !.
delta(19, _, 0.10841678332663454) :- fewer_capacity_2_than_todo_at_1, !.
delta(19, _, -0.1585510813617765).

% tree 20: step size 1.0, 207 examples, 15 leaves
delta(20, pick_up(Vehicle, Location, Package, Size, _), 0.008731030630600942) :- todo_at(Package, Location2), road(Location, Location2), capacity(Vehicle2, Size), toward_could_pick_up_for_todo_at_package_any(Vehicle2, Location2, Location), road(Location3, Location2), toward_could_pick_up(Vehicle, Location3, Location), !.
delta(20, pick_up(_, Location, Package, Size, _), -0.10839047552802486) :- todo_at(Package, Location2), road(Location, Location2), capacity(Vehicle, Size), toward_could_pick_up_for_todo_at_package_any(Vehicle, Location2, Location), !.
delta(20, pick_up(Vehicle, Location, Package, _, _), -0.015269006981359556) :- todo_at(Package, Location2), road(Location, Location2), road(Location3, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location3), !.
delta(20, pick_up(_, Location, Package, _, _), 0.13725075085665314) :- todo_at(Package, Location2), road(Location, Location2), !.
delta(20, pick_up(_, Location, _, Size, _), 0.019734302234360086) :- capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(20, pick_up(_, Location, _, Size, _), 0.01711531461437526) :- capacity(Vehicle, Size), could_pick_up_for_todo_at_any_location(Vehicle, Location), !.
delta(20, pick_up(_, _, _, _, _), -0.3506652576181648) :- !.
delta(20, drive(Vehicle, _, Location), -0.20673591024917484) :- fewer_capacity_2_than_todo_at_1, road(Location2, Location), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(20, drive(_, _, _), 0.14562515654125902) :- fewer_capacity_2_than_todo_at_1, !.
delta(20, _, -0.0429923374670693) :- fewer_capacity_2_than_todo_at_1, fewer_capacity_1_than_todo_at_1, !.
delta(20, _, 0.05698947355863313) :- fewer_capacity_2_than_todo_at_1, !.
delta(20, _, -0.007438047079433222) :- fewer_in_2_than_todo_at_2, fewer_at_2_than_todo_at_1, !.
delta(20, _, 0.198886985828483) :- fewer_in_2_than_todo_at_2, !.
delta(20, drive(_, _, _), -0.06795477782637066) :- !.
delta(20, _, 0.08909968052751374).

% tree 21: step size 1.0, 206 examples, 14 leaves
delta(21, drop(Vehicle, Location, Package, _, _), -0.04273301939407206) :- todo_at(Package, Location2), at(_, Location2), road(Location3, Location), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location3), !.
delta(21, drop(_, _, Package, Size, _), 0.43265639331879435) :- todo_at(Package, Location), at(_, Location), capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(21, drop(_, _, Package, _, _), -0.02415992660757548) :- todo_at(Package, Location), at(_, Location), !.
delta(21, drop(_, Location, _, _, _), -0.06536476768487055) :- road(Location2, Location), at(_, Location2), !.
delta(21, drop(Vehicle, Location, _, _, _), 0.02998358874352868) :- road(Location2, Location), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(21, drop(_, _, _, _, _), -0.028537738410739998) :- !.
delta(21, drive(_, _, _), 0.15726787382847998) :- fewer_in_2_than_todo_at_1, fewer_capacity_2_than_todo_at_2_at_2, !.
delta(21, _, -0.15683058421557375) :- fewer_in_2_than_todo_at_1, fewer_capacity_2_than_todo_at_2_at_2, !.
delta(21, _, -0.20991337891824893) :- fewer_in_2_than_todo_at_1, fewer_at_2_than_at_1, !.
delta(21, _, -0.001490574065820435) :- fewer_in_2_than_todo_at_1, !.
delta(21, drive(_, _, _), 0.03312680046170064) :- fewer_capacity_2_than_at_2, !.
delta(21, _, -0.0016380448127056727) :- fewer_capacity_2_than_at_2, !.
delta(21, _, -0.015187649130558692) :- fewer_in_2_than_at_2, !.
delta(21, _, 0.0014872775217768903).

% tree 22: step size 1.0, 207 examples, 14 leaves
delta(22, pick_up(_, Location, Package, _, _), -0.07529230853557987) :- fewer_capacity_1_than_at_2, todo_at(Package, Location2), at(Locatable, Location2), goal_at(Locatable, Location3), nearer_at(Location, Location2, Location3), !.
delta(22, pick_up(_, _, Package, _, _), 0.1143993361701015) :- fewer_capacity_1_than_at_2, todo_at(Package, Location), at(_, Location), !.
delta(22, pick_up(_, _, _, _, _), -0.1972125895279299) :- fewer_capacity_1_than_at_2, !.
delta(22, pick_up(_, Location, Package, _, _), -0.09060942727516637) :- todo_at(Package, Location2), road(Location3, Location), nearer_at(Location2, Location3, Location), !.
delta(22, pick_up(_, _, Package, _, _), 0.3026603402313175) :- todo_at(Package, _), !.
delta(22, pick_up(_, _, _, _, _), -0.05721624278436067) :- !.
delta(22, drive(_, Location, Location2), 0.21315484747401195) :- fewer_capacity_1_than_at_2, road(Location3, Location2), nearer_at(Location, Location2, Location3), !.
delta(22, drive(_, _, _), -0.10199357784920955) :- fewer_capacity_1_than_at_2, !.
delta(22, _, -0.05143324890010033) :- fewer_capacity_1_than_at_2, fewer_in_2_than_todo_at_2, !.
delta(22, _, 0.03108883791092209) :- fewer_capacity_1_than_at_2, !.
delta(22, _, -1.9360059030803994e-18) :- fewer_in_2_than_todo_at_2, fewer_in_2_than_in_1, !.
delta(22, _, -0.18506627157299005) :- fewer_in_2_than_todo_at_2, !.
delta(22, _, 0.04168658839519579) :- fewer_in_2_than_at_2, !.
delta(22, _, -0.0013325320360880889).

% tree 23: step size 1.0, 215 examples, 13 leaves
delta(23, pick_up(_, Location, _, _, _), -0.10604414839633107) :- at(Locatable, Location), todo_at(Locatable, Location2), road(Location3, Location2), nearer_at(Location, Location2, Location3), fewer_capacity_1_than_at_2, !.
delta(23, pick_up(_, Location, _, _, _), 0.03876101659492335) :- at(Locatable, Location), todo_at(Locatable, Location2), road(Location3, Location2), nearer_at(Location, Location2, Location3), !.
delta(23, pick_up(_, Location, _, Size, _), -0.04433644689884495) :- at(Locatable, Location), todo_at(Locatable, _), capacity_predecessor(Size2, Size), capacity(_, Size2), !.
delta(23, pick_up(_, Location, _, _, _), 0.3629576943571757) :- at(Locatable, Location), todo_at(Locatable, _), !.
delta(23, pick_up(_, _, _, _, _), -0.19450571357041319) :- !.
delta(23, drive(_, _, _), 0.046453696254021265) :- fewer_capacity_1_than_todo_at_1, fewer_in_2_than_in_1, !.
delta(23, _, -0.04166921050474724) :- fewer_capacity_1_than_todo_at_1, fewer_in_2_than_in_1, !.
delta(23, _, -0.005182842710767541) :- fewer_capacity_1_than_todo_at_1, fewer_capacity_1_than_todo_at_2, !.
delta(23, _, -0.20393469759512184) :- fewer_capacity_1_than_todo_at_1, !.
delta(23, _, 0.18484777021356075) :- fewer_capacity_1_than_at_2, fewer_at_2_than_at_1, !.
delta(23, _, -5.576990038004141e-19) :- fewer_capacity_1_than_at_2, !.
delta(23, _, -0.08372754986121422) :- fewer_in_2_than_todo_at_2, !.
delta(23, _, 0.019571522969279664).

% tree 24: step size 1.0, 211 examples, 13 leaves
delta(24, pick_up(Vehicle, _, Package, _, _), 0.11737133548872) :- todo_at(Package, Location), could_drop(Vehicle, Location), !.
delta(24, pick_up(_, Location, Package, _, _), -0.011442499507327113) :- todo_at(Locatable, Location), at(Locatable, Location2), goal_at(Package, Location3), nearer_at(Location2, Location3, Location), !.
delta(24, pick_up(_, Location, _, _, _), 0.03493522883088211) :- todo_at(Locatable, Location), at(Locatable, _), !.
delta(24, pick_up(_, _, _, _, _), -0.22433571695147903) :- fewer_capacity_2_than_todo_at_1, !.
delta(24, pick_up(_, _, _, _, _), 0.014193060385316354) :- !.
delta(24, _, -0.004529406547957941) :- fewer_capacity_2_than_todo_at_2_at_2, fewer_capacity_1_than_todo_at_2, fewer_capacity_1_than_todo_at_2_at_2, !.
delta(24, _, 0.0035557895764252567) :- fewer_capacity_2_than_todo_at_2_at_2, fewer_capacity_1_than_todo_at_2, !.
delta(24, _, -0.00046963153597899743) :- fewer_capacity_2_than_todo_at_2_at_2, fewer_capacity_2_than_in_1, !.
delta(24, _, 0.09498637348592434) :- fewer_capacity_2_than_todo_at_2_at_2, !.
delta(24, drive(_, _, _), -0.018510148738411253) :- fewer_in_2_than_in_1, !.
delta(24, _, 0.07709873004985174) :- fewer_in_2_than_in_1, !.
delta(24, _, -0.05640687968245007) :- fewer_in_2_than_at_2, !.
delta(24, _, 0.012757577857558454).

% tree 25: step size 1.0, 228 examples, 16 leaves
delta(25, pick_up(_, Location, _, _, Size), -0.03859669430224924) :- goal_at(Locatable, Location), capacity(Vehicle, Size), could_drop_for_todo_at_any_location(Vehicle, Location), todo_at(Locatable, Location2), at(Vehicle, Location2), !.
delta(25, pick_up(_, Location, _, _, Size), 0.06541289980709396) :- goal_at(_, Location), capacity(Vehicle, Size), could_drop_for_todo_at_any_location(Vehicle, Location), !.
delta(25, pick_up(Vehicle, Location, Package, _, _), 0.0037777451294031235) :- goal_at(_, Location), todo_at(Package, Location2), could_pick_up(Vehicle, Location2), !.
delta(25, pick_up(_, Location, _, _, _), -0.327430410291293) :- goal_at(_, Location), !.
delta(25, pick_up(_, Location, Package, _, Size), -0.07617765035020801) :- capacity(Vehicle, Size), in(_, Vehicle), todo_at(Package, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(25, pick_up(_, _, _, _, Size), 0.023389081416468428) :- capacity(Vehicle, Size), in(_, Vehicle), !.
delta(25, pick_up(_, _, _, Size, _), -0.01970905028291932) :- capacity_predecessor(Size2, Size), capacity(_, Size2), !.
delta(25, pick_up(_, _, _, _, _), 0.12901301931428052) :- !.
delta(25, drive(_, _, _), -0.0025148369968992705) :- fewer_capacity_1_than_todo_at_1, fewer_capacity_2_than_in_1, !.
delta(25, _, 0.0025186489535954306) :- fewer_capacity_1_than_todo_at_1, fewer_capacity_2_than_in_1, !.
delta(25, _, -0.030071875045280586) :- fewer_capacity_1_than_todo_at_1, fewer_at_2_than_at_1, !.
delta(25, _, 0.0) :- fewer_capacity_1_than_todo_at_1, !.
delta(25, drive(Vehicle, Location, _), -0.3067422958061658) :- road(Location2, Location), toward_could_drop_todo_at(Vehicle, Location2, Location), !.
delta(25, drive(_, _, _), 0.33038840664834207) :- !.
delta(25, _, 0.11835251133839021) :- fewer_capacity_2_than_todo_at_2, !.
delta(25, _, -0.11594205795392526).

% tree 26: step size 1.0, 206 examples, 14 leaves
delta(26, pick_up(Vehicle, Location, _, _, _), 0.02114327873801221) :- goal_at(Locatable, Location), done_at(Locatable, Location2), could_pick_up_for_todo_at_package_any(Vehicle, Location2), !.
delta(26, pick_up(_, Location, _, Size, Size2), 0.008286314136665628) :- goal_at(_, Location), capacity(Vehicle, Size), toward_could_drop_for_todo_at_package_any(Vehicle, Size2, Size), !.
delta(26, pick_up(_, Location, _, _, _), -0.09778721408421845) :- goal_at(_, Location), !.
delta(26, pick_up(_, Location, _, Size, _), -0.017499437625643523) :- fewer_capacity_1_than_todo_at_1, capacity(Vehicle, Size), could_pick_up(Vehicle, Location), !.
delta(26, pick_up(_, _, _, _, _), 0.01028954637897216) :- fewer_capacity_1_than_todo_at_1, !.
delta(26, pick_up(_, _, _, _, _), 0.14506324543679291) :- !.
delta(26, drive(_, _, _), -0.030542865115982542) :- fewer_capacity_2_than_at_2, fewer_capacity_1_than_todo_at_1, !.
delta(26, _, 0.04551788830644055) :- fewer_capacity_2_than_at_2, fewer_capacity_1_than_todo_at_1, !.
delta(26, drive(_, _, _), -0.0004444849326594139) :- fewer_capacity_2_than_at_2, !.
delta(26, _, -0.12272618313174213) :- fewer_capacity_2_than_at_2, !.
delta(26, drive(_, Location, _), 0.060087628799524846) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(26, drive(_, _, _), -0.09975023488831096) :- !.
delta(26, _, -0.002187970285872702) :- fewer_capacity_2_than_todo_at_2, !.
delta(26, _, 0.08911810708013151).

% tree 27: step size 1.0, 208 examples, 16 leaves
delta(27, drive(Vehicle, Location, Location2), -0.0004597509058452221) :- goal_at(Locatable, Location2), at(Locatable, _), done_at(Locatable, Location3), could_drop(Vehicle, Location3), road(Location4, Location), toward_could_drop_for_todo_at_any_location(Vehicle, Location2, Location4), !.
delta(27, drive(Vehicle, _, Location), 0.03847430392522916) :- goal_at(Locatable, Location), at(Locatable, _), done_at(Locatable, Location2), could_drop(Vehicle, Location2), !.
delta(27, drive(Vehicle, _, Location), 0.030476214122631) :- goal_at(Locatable, Location), at(Locatable, Location2), at(Vehicle, Location3), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location3), !.
delta(27, drive(_, _, Location), -0.24804233761431455) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(27, drive(Vehicle, Location, Location2), 0.04744363062973278) :- road(Location3, Location), toward_could_pick_up(Vehicle, Location3, Location2), road(Location4, Location2), nearer_at(Location4, Location3, Location), !.
delta(27, drive(Vehicle, Location, Location2), -0.13886552173459082) :- road(Location3, Location), toward_could_pick_up(Vehicle, Location3, Location2), !.
delta(27, drive(Vehicle, _, Location), -0.06787271259275396) :- at(Vehicle, Location2), toward_could_drop_todo_at(Vehicle, Location, Location2), !.
delta(27, drive(_, _, _), 0.5005803353396744) :- !.
delta(27, pick_up(Vehicle, Location, _, _, _), -0.004017344313772609) :- fewer_in_2_than_todo_at_2_at_2, road(Location2, Location), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location, Location2), !.
delta(27, pick_up(_, _, _, _, _), 0.12833571896683488) :- fewer_in_2_than_todo_at_2_at_2, !.
delta(27, _, 0.023735420175830794) :- fewer_in_2_than_todo_at_2_at_2, fewer_capacity_2_than_todo_at_2, !.
delta(27, _, -0.07703722174317428) :- fewer_in_2_than_todo_at_2_at_2, !.
delta(27, pick_up(_, _, _, _, _), 0.03485943337961721) :- fewer_capacity_1_than_todo_at_1, !.
delta(27, _, -0.006051091367276948) :- fewer_capacity_1_than_todo_at_1, !.
delta(27, _, 0.006599318480669586) :- fewer_at_2_than_todo_at_2, !.
delta(27, _, -0.3759383822385906).

% tree 28: step size 1.0, 222 examples, 14 leaves
delta(28, drop(Vehicle, _, _, Size, _), 3.8632326383735596e-5) :- capacity_predecessor(Size2, Size), capacity(Vehicle2, Size2), fewer_capacity_2_than_todo_at_1, at(Vehicle, Location), could_drop_todo_at(Vehicle2, Location), !.
delta(28, drop(_, _, _, Size, _), -0.10779420348644307) :- capacity_predecessor(Size2, Size), capacity(_, Size2), fewer_capacity_2_than_todo_at_1, !.
delta(28, drop(_, _, _, Size, _), 0.01680823010503283) :- capacity_predecessor(Size2, Size), capacity(_, Size2), !.
delta(28, drop(_, Location, Package, _, _), -0.021514296310182163) :- todo_at(Package, Location), todo_at(Locatable, Location), at(Locatable, _), !.
delta(28, drop(_, Location, Package, _, _), 0.2872802187635051) :- todo_at(Package, Location), !.
delta(28, drop(_, _, _, _, _), -0.05285107892584701) :- !.
delta(28, drive(_, _, _), 0.06416290221497896) :- fewer_capacity_1_than_at_2, fewer_in_2_than_todo_at_2_at_2, !.
delta(28, _, -0.007642138029698619) :- fewer_capacity_1_than_at_2, fewer_in_2_than_todo_at_2_at_2, !.
delta(28, drive(_, _, _), -0.09935868269937047) :- fewer_capacity_1_than_at_2, !.
delta(28, _, 0.06003267456196758) :- fewer_capacity_1_than_at_2, !.
delta(28, _, 0.011275277416318523) :- fewer_in_2_than_at_2, fewer_capacity_2_than_in_1, !.
delta(28, _, -0.13738352151585376) :- fewer_in_2_than_at_2, !.
delta(28, drive(_, _, _), 0.06711064415280388) :- !.
delta(28, _, -0.055661729018332363).

% tree 29: step size 1.0, 231 examples, 15 leaves
delta(29, pick_up(_, Location, Package, Size, _), 0.0) :- capacity(Vehicle, Size), at(Vehicle, Location), goal_at(Package, Location2), could_drop_todo_at(Vehicle, Location2), !.
delta(29, pick_up(_, Location, Package, Size, _), 0.0009427675166632989) :- capacity(Vehicle, Size), at(Vehicle, Location), todo_at(Package, Location2), at(_, Location2), !.
delta(29, pick_up(_, Location, _, Size, _), -0.12405582500998504) :- capacity(Vehicle, Size), at(Vehicle, Location), !.
delta(29, pick_up(Vehicle, Location, _, Size, Size2), 0.02409637585136143) :- capacity(Vehicle2, Size), toward_could_drop_for_todo_at_package_any(Vehicle2, Size2, Size), at(Vehicle2, Location2), toward_could_pick_up_for_todo_at_package_any(Vehicle, Location2, Location), !.
delta(29, pick_up(_, _, _, Size, Size2), -0.11172254703567869) :- capacity(Vehicle, Size), toward_could_drop_for_todo_at_package_any(Vehicle, Size2, Size), !.
delta(29, pick_up(_, _, Package, _, _), 0.3021473156749021) :- goal_at(Package, Location), todo_at(_, Location), !.
delta(29, pick_up(_, _, _, _, _), -0.026187810112029777) :- !.
delta(29, drive(Vehicle, Location, Location2), 0.11113207787009866) :- fewer_in_2_than_in_1, road(Location3, Location), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location3), !.
delta(29, drive(_, _, _), -0.102411285228507) :- fewer_in_2_than_in_1, !.
delta(29, _, 0.04081610309184444) :- fewer_in_2_than_in_1, fewer_in_2_than_todo_at_2, !.
delta(29, _, -0.006638815901088286) :- fewer_in_2_than_in_1, !.
delta(29, drive(_, _, _), 0.04442965601953432) :- fewer_at_2_than_todo_at_1, !.
delta(29, _, -0.021512026565771485) :- fewer_at_2_than_todo_at_1, !.
delta(29, _, -0.11809175315999652) :- fewer_in_2_than_todo_at_2, !.
delta(29, _, 0.0035436579445263295).

% tree 30: step size 1.0, 206 examples, 11 leaves
delta(30, pick_up(_, _, _, Size, Size2), -0.008315903400604062) :- capacity(Vehicle, Size), toward_could_drop_for_todo_at_package_any(Vehicle, Size2, Size), fewer_in_2_than_todo_at_2_at_2, !.
delta(30, pick_up(Vehicle, _, Package, Size, Size2), -0.001981856878603672) :- capacity(Vehicle2, Size), toward_could_drop_for_todo_at_package_any(Vehicle2, Size2, Size), goal_at(Package, Location), could_pick_up_for_todo_at_package_any(Vehicle, Location), !.
delta(30, pick_up(_, _, _, Size, Size2), 0.0749732515378395) :- capacity(Vehicle, Size), toward_could_drop_for_todo_at_package_any(Vehicle, Size2, Size), !.
delta(30, pick_up(Vehicle, Location, Package, _, _), 0.06355982180979215) :- todo_at(Package, Location2), toward_could_pick_up_for_todo_at_any_location(Vehicle, Location2, Location), !.
delta(30, pick_up(Vehicle, _, Package, _, _), 0.03259569801785193) :- todo_at(Package, Location), could_pick_up(Vehicle, Location), !.
delta(30, pick_up(_, _, _, _, _), -0.23093544252201587) :- !.
delta(30, _, 0.12296438530430068) :- fewer_at_2_than_todo_at_1_at_1, !.
delta(30, drive(_, _, Location), 0.37046888078618695) :- goal_at(_, Location), !.
delta(30, drive(_, _, _), -0.41219111840970124) :- !.
delta(30, _, 0.06904151183804921) :- fewer_capacity_2_than_in_1, !.
delta(30, _, -0.030007639405324773).

% tree 31: step size 1.0, 205 examples, 13 leaves
delta(31, drive(Vehicle, _, Location), 0.15747894374685126) :- at(Locatable, Location), goal_at(Locatable, Location2), could_drop_for_todo_at_any_location(Vehicle, Location2), road(Location3, Location2), toward_could_drop_todo_at(Vehicle, Location3, Location), !.
delta(31, drive(Vehicle, _, Location), -0.03822164924872455) :- at(Locatable, Location), goal_at(Locatable, Location2), could_drop_for_todo_at_any_location(Vehicle, Location2), !.
delta(31, drive(Vehicle, Location, Location2), 0.056776414012521766) :- at(Locatable, Location2), goal_at(Locatable, Location3), toward_could_pick_up(Vehicle, Location, Location3), !.
delta(31, drive(_, _, Location), -0.31571147254375853) :- at(_, Location), !.
delta(31, drive(_, _, Location), -0.01465840418119389) :- fewer_in_2_than_todo_at_1, todo_at(Locatable, Location), at(Locatable, _), !.
delta(31, drive(_, _, _), 0.3694059004563062) :- fewer_in_2_than_todo_at_1, !.
delta(31, drive(Vehicle, _, Location), 0.015778474590076797) :- in(Package, Vehicle), todo_at(Package, Location), !.
delta(31, drive(_, _, _), -0.044100671436599195) :- !.
delta(31, _, 0.10986264181425211) :- fewer_capacity_1_than_at_2, !.
delta(31, _, 0.001081647961539946) :- fewer_in_2_than_at_2, fewer_capacity_2_than_todo_at_2_at_2, !.
delta(31, _, -0.27165674978775023) :- fewer_in_2_than_at_2, !.
delta(31, _, 0.05270654599753958) :- fewer_at_2_than_at_1, !.
delta(31, _, -0.0005702012252912557).

% tree 32: step size 1.0, 250 examples, 13 leaves
delta(32, pick_up(Vehicle, _, Package, Size, _), 0.0) :- todo_at(Package, Location), could_pick_up(Vehicle, Location), capacity(Vehicle2, Size), at(Vehicle2, Location), !.
delta(32, pick_up(Vehicle, _, Package, _, _), 0.04594686687716025) :- todo_at(Package, Location), could_pick_up(Vehicle, Location), !.
delta(32, pick_up(_, _, _, _, Size), -0.2569117549416325) :- capacity_predecessor(Size, Size2), capacity(_, Size2), fewer_capacity_1_than_at_2, !.
delta(32, pick_up(_, _, _, _, Size), 0.0009267884206578828) :- capacity_predecessor(Size, Size2), capacity(_, Size2), !.
delta(32, pick_up(_, _, Package, _, _), 0.035562244956923776) :- todo_at(Package, _), !.
delta(32, pick_up(_, _, _, _, _), -0.026352800465094094) :- !.
delta(32, _, -0.012782519625639416) :- fewer_capacity_1_than_todo_at_1, fewer_at_2_than_todo_at_1_at_1, !.
delta(32, _, -0.009792454678839187) :- fewer_capacity_1_than_todo_at_1, fewer_capacity_1_than_todo_at_2, !.
delta(32, _, 0.18839062025113093) :- fewer_capacity_1_than_todo_at_1, !.
delta(32, drive(Vehicle, Location, Location2), -0.16793802964035706) :- road(Location3, Location), toward_could_pick_up(Vehicle, Location2, Location3), !.
delta(32, drive(_, _, _), 0.11001890352691805) :- !.
delta(32, _, 0.046942481500862256) :- fewer_in_2_than_todo_at_1, !.
delta(32, _, -0.016367370412256384).

% tree 33: step size 1.0, 216 examples, 11 leaves
delta(33, drive(Vehicle, Location, _), 0.012889268631072917) :- road(Location2, Location), could_pick_up_for_todo_at_any_location(Vehicle, Location2), road(Location3, Location), toward_could_drop_todo_at(Vehicle, Location2, Location3), !.
delta(33, drive(Vehicle, Location, _), -0.2528592471959147) :- road(Location2, Location), could_pick_up_for_todo_at_any_location(Vehicle, Location2), fewer_capacity_2_than_at_2, !.
delta(33, drive(Vehicle, Location, _), 0.00798449428348032) :- road(Location2, Location), could_pick_up_for_todo_at_any_location(Vehicle, Location2), !.
delta(33, drive(Vehicle, _, Location), -0.0246222499296305) :- road(Location2, Location), could_pick_up(Vehicle, Location2), at(_, Location), !.
delta(33, drive(Vehicle, _, Location), 0.2525516864693453) :- road(Location2, Location), could_pick_up(Vehicle, Location2), !.
delta(33, drive(_, Location, _), 0.04031890696530725) :- goal_at(Locatable, Location), at(Locatable, _), !.
delta(33, drive(_, _, _), -0.10328079170296597) :- !.
delta(33, _, -0.11584073135765643) :- fewer_at_2_than_todo_at_1_at_1, !.
delta(33, _, 0.19394511867539) :- fewer_capacity_2_than_at_2, !.
delta(33, _, -0.040739545995605406) :- fewer_in_2_than_todo_at_1, !.
delta(33, _, 0.014528914740428443).
