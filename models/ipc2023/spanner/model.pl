% SHA-256 of what follows: 41717dc47a96b8879143884b39d79988e32e0623ed8c0f083ee3f2a5a91406f9
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
model(domain_sha256, dc3e79446c0abd8857a8e0b3341401e248ef8b4c99181b893744fd5349e7a669).
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
model(bias_sha256, '23242c37ba36ae5fd7b82f9013e554d8f5125fefa73a352d647330e479946578').
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
model(trained_episodes, 3177).
model(trees, 190).

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

% tree 1: step size 1.0, 205 examples, 4 leaves
delta(1, walk(_, Location, Man), 0.5155313029625392) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(1, walk(_, _, _), -1.8181818181818181) :- !.
delta(1, _, -0.5155313029625392) :- usable(Spanner), carrying(_, Spanner), !.
delta(1, _, 1.8181818181818181).

% tree 2: step size 1.0, 201 examples, 4 leaves
delta(2, walk(_, Location, Man), 0.3121073981804313) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(2, walk(_, _, _), -0.5309983268824567) :- !.
delta(2, _, -0.3121073981804313) :- usable(Spanner), carrying(_, Spanner), !.
delta(2, _, 0.5309983268824567).

% tree 3: step size 1.0, 202 examples, 4 leaves
delta(3, walk(_, Location, Man), 0.21783619388870948) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(3, walk(_, _, _), -0.3039596289354365) :- !.
delta(3, _, -0.21783619388870948) :- usable(Spanner), carrying(_, Spanner), !.
delta(3, _, 0.3039596289354365).

% tree 4: step size 1.0, 203 examples, 4 leaves
delta(4, walk(_, _, _), -0.7697054472016747) :- fewer_carrying_2_than_todo_tightened, !.
delta(4, walk(_, _, _), 0.15353897462387178) :- !.
delta(4, _, 0.7697054472016747) :- fewer_carrying_2_than_todo_tightened, !.
delta(4, _, -0.15353897462387178).

% tree 5: step size 1.0, 206 examples, 5 leaves
delta(5, walk(_, _, _), -1.5595159640571297) :- fewer_carrying_2_than_todo_tightened, !.
delta(5, walk(_, _, _), 0.11466334066717607) :- !.
delta(5, _, 1.5730947639201447) :- usable(Spanner), carrying(_, Spanner), fewer_carrying_2_than_todo_tightened, !.
delta(5, _, -0.11466334066717607) :- usable(Spanner), carrying(_, Spanner), !.
delta(5, _, 0.029503916292536347).

% tree 6: step size 1.0, 204 examples, 5 leaves
delta(6, walk(_, _, _), -0.3880211970302667) :- fewer_carrying_2_than_todo_tightened, !.
delta(6, walk(_, _, _), 0.10018636248632709) :- !.
delta(6, _, 0.3838044962145227) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(6, _, 0.00576095099206776) :- fewer_carrying_2_than_todo_tightened, !.
delta(6, _, -0.10018636248632709).

% tree 7: step size 1.0, 207 examples, 5 leaves
delta(7, walk(_, _, _), -0.3084113737337062) :- fewer_carrying_2_than_todo_tightened, !.
delta(7, walk(_, _, _), 0.09143353699197458) :- !.
delta(7, _, 0.30458723274589367) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(7, _, 0.0037385704855196077) :- fewer_carrying_2_than_todo_tightened, !.
delta(7, _, -0.09143353699197458).

% tree 8: step size 1.0, 209 examples, 6 leaves
delta(8, walk(_, Location, _), 0.057858839621678405) :- fewer_carrying_2_than_todo_tightened, link(Location, Location2), link(Location2, _), !.
delta(8, walk(_, _, _), -0.17082168708915818) :- fewer_carrying_2_than_todo_tightened, !.
delta(8, walk(_, _, _), 0.08472812897536589) :- !.
delta(8, _, 0.14738311318610423) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(8, _, -0.020969468559428276) :- fewer_carrying_2_than_todo_tightened, !.
delta(8, _, -0.08472812897536589).

% tree 9: step size 1.0, 206 examples, 5 leaves
delta(9, walk(_, _, _), -0.15239947999770742) :- fewer_carrying_2_than_todo_tightened, !.
delta(9, walk(_, _, _), 0.08473425016887218) :- !.
delta(9, _, 0.14800123914410787) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(9, _, 0.003089454974469242) :- fewer_carrying_2_than_todo_tightened, !.
delta(9, _, -0.08473425016887218).

% tree 10: step size 1.0, 201 examples, 7 leaves
delta(10, walk(_, Location, _), -0.011135912599423795) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), link(Location, Location2), at(_, Location2), !.
delta(10, walk(_, Location, _), 0.03367742785888717) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), !.
delta(10, walk(_, _, _), -0.15752759742005953) :- fewer_carrying_2_than_todo_tightened, !.
delta(10, walk(_, _, _), 0.08501356917197023) :- !.
delta(10, _, 0.13431434356325467) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(10, _, 0.0026756012636848622) :- fewer_carrying_2_than_todo_tightened, !.
delta(10, _, -0.08501356917197023).

% tree 11: step size 1.0, 210 examples, 7 leaves
delta(11, walk(_, Location, _), -0.009349397271477322) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), link(Location, Location2), at(_, Location2), !.
delta(11, walk(_, Location, _), 0.03279755219426619) :- fewer_carrying_2_than_todo_tightened, at(Locatable, Location), spanner(Locatable), !.
delta(11, walk(_, _, _), -0.09837893112239644) :- fewer_carrying_2_than_todo_tightened, !.
delta(11, walk(_, _, _), 0.07688196104319488) :- !.
delta(11, _, 0.07418850701102962) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(11, _, 0.0014973055480141332) :- fewer_carrying_2_than_todo_tightened, !.
delta(11, _, -0.07688196104319488).

% tree 12: step size 1.0, 211 examples, 9 leaves
delta(12, walk(Location, Location2, _), -0.010460362923262634) :- fewer_carrying_2_than_todo_tightened, link(Location2, Location3), link(Location3, _), link(Location4, Location), at(_, Location4), !.
delta(12, walk(_, Location, _), 0.05220257681515138) :- fewer_carrying_2_than_todo_tightened, link(Location, Location2), link(Location2, _), !.
delta(12, walk(_, _, _), -0.10034634918784374) :- fewer_carrying_2_than_todo_tightened, !.
delta(12, walk(_, _, _), 0.05704409107003487) :- !.
delta(12, _, -0.015889923023020273) :- fewer_carrying_2_than_todo_tightened, fewer_at_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(12, _, 0.00035462921815112176) :- fewer_carrying_2_than_todo_tightened, fewer_at_2_than_todo_tightened, !.
delta(12, _, 0.07410396235593814) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(12, _, 0.001455877310452621) :- fewer_carrying_2_than_todo_tightened, !.
delta(12, _, -0.05704409107003487).

% tree 13: step size 1.0, 209 examples, 5 leaves
delta(13, walk(_, _, _), -0.09701163267304087) :- fewer_carrying_2_than_todo_tightened, !.
delta(13, walk(_, _, _), 0.061919865834452116) :- !.
delta(13, _, 0.0952404016465652) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(13, _, 0.0013012309339759233) :- fewer_carrying_2_than_todo_tightened, !.
delta(13, _, -0.061919865834452116).

% tree 14: step size 1.0, 201 examples, 4 leaves
delta(14, walk(_, _, _), -0.08166041700368465) :- fewer_carrying_2_than_todo_tightened, !.
delta(14, walk(_, _, _), 0.04862827299272579) :- !.
delta(14, _, 0.08166041700368465) :- fewer_carrying_2_than_todo_tightened, !.
delta(14, _, -0.04862827299272579).

% tree 15: step size 1.0, 212 examples, 5 leaves
delta(15, walk(_, _, _), -0.04695476771383525) :- fewer_carrying_2_than_todo_tightened, !.
delta(15, walk(_, _, _), 0.040761850025109084) :- !.
delta(15, _, 0.04543359809369141) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(15, _, 0.001028400964136388) :- fewer_carrying_2_than_todo_tightened, !.
delta(15, _, -0.040761850025109084).

% tree 16: step size 1.0, 204 examples, 4 leaves
delta(16, walk(_, _, _), -0.0489469538649074) :- fewer_carrying_2_than_todo_tightened, !.
delta(16, walk(_, _, _), 0.03324165945177397) :- !.
delta(16, _, 0.0489469538649074) :- fewer_carrying_2_than_todo_tightened, !.
delta(16, _, -0.03324165945177397).

% tree 17: step size 1.0, 211 examples, 5 leaves
delta(17, walk(_, _, _), -0.046419996709043926) :- fewer_carrying_2_than_todo_tightened, !.
delta(17, walk(_, _, _), 0.0359907434906366) :- !.
delta(17, _, 0.04547016993239217) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(17, _, 0.0006560680350576264) :- fewer_carrying_2_than_todo_tightened, !.
delta(17, _, -0.0359907434906366).

% tree 18: step size 1.0, 208 examples, 5 leaves
delta(18, walk(_, _, _), -0.03438892560824957) :- fewer_carrying_2_than_todo_tightened, !.
delta(18, walk(_, _, _), 0.03253979532999118) :- !.
delta(18, _, 0.03339760839414455) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(18, _, 0.0006745297581676146) :- fewer_carrying_2_than_todo_tightened, !.
delta(18, _, -0.03253979532999118).

% tree 19: step size 1.0, 206 examples, 9 leaves
delta(19, walk(_, _, _), -0.008430073578128873) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(19, walk(_, _, _), 0.006062424922081983) :- fewer_at_2_than_todo_tightened, !.
delta(19, walk(_, Location, Man), -0.0006065430775355297) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), at(Locatable, Location), spanner(Locatable), !.
delta(19, walk(_, Location, Man), 0.030471092663115592) :- at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(19, walk(_, _, _), -0.0009613458644770842) :- !.
delta(19, _, 0.008278356574270953) :- usable(Spanner), carrying(_, Spanner), fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(19, _, -0.006062424922081983) :- usable(Spanner), carrying(_, Spanner), fewer_at_2_than_todo_tightened, !.
delta(19, _, -0.02963092163706204) :- usable(Spanner), carrying(_, Spanner), !.
delta(19, _, 0.0008130551490527224).

% tree 20: step size 1.0, 201 examples, 5 leaves
delta(20, walk(_, _, _), -0.037410586814762586) :- fewer_carrying_2_than_todo_tightened, !.
delta(20, walk(_, _, _), 0.02559372765582122) :- !.
delta(20, _, 0.036469125294646076) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(20, _, 0.0006569488494279908) :- fewer_carrying_2_than_todo_tightened, !.
delta(20, _, -0.02559372765582122).

% tree 21: step size 1.0, 210 examples, 5 leaves
delta(21, walk(_, _, _), -0.03942940066739954) :- fewer_carrying_2_than_todo_tightened, !.
delta(21, walk(_, _, _), 0.024637343896535813) :- !.
delta(21, _, 0.03841697871799103) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(21, _, 0.000715644804984354) :- fewer_carrying_2_than_todo_tightened, !.
delta(21, _, -0.024637343896535813).

% tree 22: step size 1.0, 203 examples, 5 leaves
delta(22, walk(_, _, _), -0.0439304662872255) :- fewer_carrying_2_than_todo_tightened, !.
delta(22, walk(_, _, _), 0.02354702538175872) :- !.
delta(22, _, 0.04305888209546401) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(22, _, 0.0008117594376292684) :- fewer_carrying_2_than_todo_tightened, !.
delta(22, _, -0.02354702538175872).

% tree 23: step size 1.0, 213 examples, 6 leaves
delta(23, walk(_, _, _), -0.029826419117793896) :- fewer_carrying_2_than_todo_tightened, !.
delta(23, walk(_, _, _), 0.023147015575304932) :- !.
delta(23, _, 0.02901962807859177) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(23, _, 3.409047827511445e-5) :- fewer_carrying_2_than_todo_tightened, fewer_at_2_than_todo_tightened, !.
delta(23, _, 0.0006984008440097064) :- fewer_carrying_2_than_todo_tightened, !.
delta(23, _, -0.023147015575304932).

% tree 24: step size 1.0, 216 examples, 5 leaves
delta(24, walk(_, _, _), -0.02975348659333119) :- fewer_carrying_2_than_todo_tightened, !.
delta(24, walk(_, _, _), 0.016926316786710346) :- !.
delta(24, _, 0.029099138643554012) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(24, _, 0.0005224039434584823) :- fewer_carrying_2_than_todo_tightened, !.
delta(24, _, -0.016926316786710346).

% tree 25: step size 1.0, 216 examples, 8 leaves
delta(25, walk(_, Location, Man), -0.0018399015430613569) :- link(Location, Location2), toward_could_tighten_nut(Man, Location, Location2), link(Location2, Location3), toward_could_pickup_spanner(Man, Location2, Location3), fewer_carrying_2_than_todo_tightened, !.
delta(25, walk(_, Location, Man), 0.001094919706729588) :- link(Location, Location2), toward_could_tighten_nut(Man, Location, Location2), link(Location2, Location3), toward_could_pickup_spanner(Man, Location2, Location3), !.
delta(25, walk(Location, Location2, Man), 0.02827955852211486) :- link(Location2, Location3), toward_could_tighten_nut(Man, Location2, Location3), link(Location4, Location), link(_, Location4), !.
delta(25, walk(_, Location, Man), -0.000539486551038665) :- link(Location, Location2), toward_could_tighten_nut(Man, Location, Location2), !.
delta(25, walk(_, _, _), -0.01399813027878017) :- fewer_carrying_2_than_todo_tightened, !.
delta(25, walk(_, _, _), 0.00874308012840432) :- !.
delta(25, _, -0.021842140685633334) :- usable(Spanner), carrying(_, Spanner), !.
delta(25, _, 0.0007299771065205375).

% tree 26: step size 1.0, 209 examples, 5 leaves
delta(26, walk(_, _, _), -0.018318415685620332) :- fewer_carrying_2_than_todo_tightened, !.
delta(26, walk(_, _, _), 0.016908661034679986) :- !.
delta(26, _, 0.017568153342533692) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(26, _, 0.0005915351365013629) :- fewer_carrying_2_than_todo_tightened, !.
delta(26, _, -0.016908661034679986).

% tree 27: step size 1.0, 217 examples, 5 leaves
delta(27, walk(_, _, _), -0.02530029314041352) :- fewer_carrying_2_than_todo_tightened, !.
delta(27, walk(_, _, _), 0.016253660384885436) :- !.
delta(27, _, 0.02435358561276865) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(27, _, 0.0006272709789597674) :- fewer_carrying_2_than_todo_tightened, !.
delta(27, _, -0.016253660384885436).

% tree 28: step size 1.0, 211 examples, 6 leaves
delta(28, walk(_, _, _), -0.01897536336182232) :- fewer_carrying_2_than_todo_tightened, !.
delta(28, walk(_, _, _), 0.016776896360266632) :- !.
delta(28, _, 0.018415797684532272) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(28, _, 2.74480857861181e-5) :- fewer_carrying_2_than_todo_tightened, fewer_at_2_than_todo_tightened, !.
delta(28, _, 0.00047740341441263967) :- fewer_carrying_2_than_todo_tightened, !.
delta(28, _, -0.016776896360266632).

% tree 29: step size 1.0, 209 examples, 8 leaves
delta(29, walk(Location, Location2, _), -0.0006438215534801849) :- at(Locatable, Location2), spanner(Locatable), link(Location3, Location), at(_, Location3), !.
delta(29, walk(_, Location, _), 0.02282520229369627) :- at(Locatable, Location), spanner(Locatable), !.
delta(29, walk(_, _, _), -0.019330543506274778) :- fewer_carrying_2_than_todo_tightened, !.
delta(29, walk(_, _, _), 0.012259680360784921) :- !.
delta(29, _, 0.005600133588171784) :- fewer_carrying_2_than_todo_tightened, fewer_at_2_than_todo_tightened, !.
delta(29, _, -0.005644455965658022) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(29, _, 0.00035995187319600434) :- fewer_carrying_2_than_todo_tightened, !.
delta(29, _, -0.01507521147350964).

% tree 30: step size 1.0, 204 examples, 5 leaves
delta(30, walk(_, _, _), -0.011969130472592572) :- fewer_carrying_2_than_todo_tightened, !.
delta(30, walk(_, _, _), 0.016087276155534756) :- !.
delta(30, _, 0.011315534772391281) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(30, _, 0.0005843532964209168) :- fewer_carrying_2_than_todo_tightened, !.
delta(30, _, -0.016087276155534756).

% tree 31: step size 1.0, 207 examples, 6 leaves
delta(31, walk(_, Location, Man), 0.023230306035835018) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(31, walk(_, Location, _), -4.7585478063810794e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(31, walk(_, _, _), -0.016926002222685466) :- fewer_carrying_2_than_todo_tightened, !.
delta(31, walk(_, _, _), 0.011647912790542475) :- !.
delta(31, _, -0.017634142045834578) :- usable(Spanner), carrying(_, Spanner), !.
delta(31, _, 0.00047376640593396714).

% tree 32: step size 1.0, 207 examples, 5 leaves
delta(32, walk(_, _, _), -0.019227271972217606) :- fewer_carrying_2_than_todo_tightened, !.
delta(32, walk(_, _, _), 0.013843060743340229) :- !.
delta(32, _, 0.01870882112364879) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(32, _, 0.00047285736546763383) :- fewer_carrying_2_than_todo_tightened, !.
delta(32, _, -0.013843060743340229).

% tree 33: step size 1.0, 208 examples, 5 leaves
delta(33, walk(_, _, _), -0.017877756031456703) :- fewer_carrying_2_than_todo_tightened, !.
delta(33, walk(_, _, _), 0.01360951903942239) :- !.
delta(33, _, 0.017361652976075153) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(33, _, 0.0004705285180478891) :- fewer_carrying_2_than_todo_tightened, !.
delta(33, _, -0.01360951903942239).

% tree 34: step size 1.0, 214 examples, 4 leaves
delta(34, walk(_, _, _), -0.017922746419034883) :- fewer_carrying_2_than_todo_tightened, !.
delta(34, walk(_, _, _), 0.014848045185730923) :- !.
delta(34, _, 0.017922746419034883) :- fewer_carrying_2_than_todo_tightened, !.
delta(34, _, -0.014848045185730923).

% tree 35: step size 1.0, 213 examples, 5 leaves
delta(35, walk(_, _, _), -0.016260824100831146) :- fewer_carrying_2_than_todo_tightened, !.
delta(35, walk(_, _, _), 0.013162590963473633) :- !.
delta(35, _, 0.015874992104239344) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(35, _, 0.00035225840135622363) :- fewer_carrying_2_than_todo_tightened, !.
delta(35, _, -0.013162590963473633).

% tree 36: step size 1.0, 201 examples, 5 leaves
delta(36, walk(_, _, _), -0.016920499730365763) :- fewer_carrying_2_than_todo_tightened, !.
delta(36, walk(_, _, _), 0.012352215256032206) :- !.
delta(36, _, 0.016592551767940195) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(36, _, 0.0003004778574695629) :- fewer_carrying_2_than_todo_tightened, !.
delta(36, _, -0.012352215256032202).

% tree 37: step size 1.0, 214 examples, 5 leaves
delta(37, walk(_, _, _), -0.015198413791984904) :- fewer_carrying_2_than_todo_tightened, !.
delta(37, walk(_, _, _), 0.01264480224193127) :- !.
delta(37, _, 0.014591161615065849) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(37, _, 0.00032071119410591813) :- fewer_carrying_2_than_todo_tightened, !.
delta(37, _, -0.01264480224193127).

% tree 38: step size 1.0, 210 examples, 5 leaves
delta(38, walk(_, _, _), -0.01407354227766255) :- fewer_carrying_2_than_todo_tightened, !.
delta(38, walk(_, _, _), 0.010562309383605787) :- !.
delta(38, _, 0.013518592137565387) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(38, _, 0.00040049851747574937) :- fewer_carrying_2_than_todo_tightened, !.
delta(38, _, -0.010562309383605787).

% tree 39: step size 1.0, 214 examples, 7 leaves
delta(39, walk(Location, Location2, Man), 0.01963702649923425) :- link(Location2, Location3), link(Location3, _), link(Location4, Location), link(_, Location4), toward_could_tighten_nut(Man, Location, Location2), !.
delta(39, walk(Location, Location2, _), -0.00013477741117597135) :- link(Location2, Location3), link(Location3, _), link(Location4, Location), link(_, Location4), !.
delta(39, walk(_, Location, _), -0.0007162691276990474) :- link(Location, Location2), link(Location2, _), !.
delta(39, walk(_, _, _), -0.008837804889564082) :- fewer_carrying_2_than_todo_tightened, !.
delta(39, walk(_, _, _), 0.007172641851294251) :- !.
delta(39, _, -0.01720343433921067) :- usable(Spanner), carrying(_, Spanner), !.
delta(39, _, 0.0005262999009952117).

% tree 40: step size 1.0, 220 examples, 4 leaves
delta(40, walk(_, _, _), -0.012714455720498506) :- fewer_carrying_2_than_todo_tightened, !.
delta(40, walk(_, _, _), 0.010250146390973255) :- !.
delta(40, _, 0.012714455720498506) :- fewer_carrying_2_than_todo_tightened, !.
delta(40, _, -0.010250146390973255).

% tree 41: step size 1.0, 217 examples, 4 leaves
delta(41, walk(_, _, _), -0.019331298650754357) :- fewer_carrying_2_than_todo_tightened, !.
delta(41, walk(_, _, _), 0.008683337979556074) :- !.
delta(41, _, 0.01917459460096469) :- fewer_carrying_2_than_todo_tightened, !.
delta(41, _, -0.008683337979556076).

% tree 42: step size 1.0, 206 examples, 5 leaves
delta(42, walk(_, _, _), -0.012911719548870824) :- fewer_carrying_2_than_todo_tightened, !.
delta(42, walk(_, _, _), 0.009795614242319622) :- !.
delta(42, _, 0.01262524137489054) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(42, _, 0.0002633287141487247) :- fewer_carrying_2_than_todo_tightened, !.
delta(42, _, -0.009795614242319622).

% tree 43: step size 1.0, 207 examples, 5 leaves
delta(43, walk(_, _, _), -0.014385393690440612) :- fewer_carrying_2_than_todo_tightened, !.
delta(43, walk(_, _, _), 0.007857624675201328) :- !.
delta(43, _, 0.013866409940176835) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(43, _, 0.00037735713099826306) :- fewer_carrying_2_than_todo_tightened, !.
delta(43, _, -0.007857624675201328).

% tree 44: step size 1.0, 204 examples, 4 leaves
delta(44, walk(_, _, _), -0.011631451234718194) :- fewer_carrying_2_than_todo_tightened, !.
delta(44, walk(_, _, _), 0.009714470094632843) :- !.
delta(44, _, 0.011631451234718194) :- fewer_carrying_2_than_todo_tightened, !.
delta(44, _, -0.009714470094632843).

% tree 45: step size 1.0, 207 examples, 4 leaves
delta(45, walk(_, _, _), -0.012390199901537165) :- fewer_carrying_2_than_todo_tightened, !.
delta(45, walk(_, _, _), 0.007956743726697144) :- !.
delta(45, _, 0.012390199901537165) :- fewer_carrying_2_than_todo_tightened, !.
delta(45, _, -0.007956743726697144).

% tree 46: step size 1.0, 215 examples, 5 leaves
delta(46, walk(_, _, _), -0.010261312548606365) :- fewer_carrying_2_than_todo_tightened, !.
delta(46, walk(_, _, _), 0.007507555164405825) :- !.
delta(46, _, 0.009712695197529058) :- fewer_carrying_2_than_todo_tightened, usable(Spanner), carrying(_, Spanner), !.
delta(46, _, 0.00032779671766457435) :- fewer_carrying_2_than_todo_tightened, !.
delta(46, _, -0.007507555164405825).

% tree 47: step size 1.0, 214 examples, 9 leaves
delta(47, walk(Location, Location2, Man), 0.029579862196405106) :- link(Location2, Location3), at(_, Location3), link(Location4, Location), link(_, Location4), toward_could_tighten_nut(Man, Location, Location2), !.
delta(47, walk(Location, Location2, _), -4.4330333905037176e-5) :- link(Location2, Location3), at(_, Location3), link(Location4, Location), link(_, Location4), !.
delta(47, walk(_, Location, _), -0.0003906927309241094) :- link(Location, Location2), at(_, Location2), !.
delta(47, walk(_, _, _), -0.009401296507042703) :- fewer_carrying_2_than_todo_tightened, !.
delta(47, walk(_, _, _), 0.00551695443596183) :- !.
delta(47, _, 0.003769888965688207) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(47, _, -0.0033182271165777054) :- fewer_at_2_than_todo_tightened, !.
delta(47, _, -0.025814057219024075) :- usable(Spanner), carrying(_, Spanner), !.
delta(47, _, 0.0003399331343417275).

% tree 48: step size 1.0, 208 examples, 4 leaves
delta(48, walk(_, _, _), -0.01030539201681058) :- fewer_carrying_2_than_todo_tightened, !.
delta(48, walk(_, _, _), 0.007609559774072155) :- !.
delta(48, _, 0.01030539201681058) :- fewer_carrying_2_than_todo_tightened, !.
delta(48, _, -0.007609559774072154).

% tree 49: step size 1.0, 212 examples, 4 leaves
delta(49, walk(_, _, _), -0.01056669371520315) :- fewer_carrying_2_than_todo_tightened, !.
delta(49, walk(_, _, _), 0.007059551134088247) :- !.
delta(49, _, 0.01056669371520315) :- fewer_carrying_2_than_todo_tightened, !.
delta(49, _, -0.007059551134088247).

% tree 50: step size 1.0, 205 examples, 4 leaves
delta(50, walk(_, _, _), -0.010986039948904324) :- fewer_carrying_2_than_todo_tightened, !.
delta(50, walk(_, _, _), 0.00787351489993755) :- !.
delta(50, _, 0.010986039948904324) :- fewer_carrying_2_than_todo_tightened, !.
delta(50, _, -0.00787351489993755).

% tree 51: step size 1.0, 211 examples, 4 leaves
delta(51, walk(_, _, _), -0.009625704310534425) :- fewer_carrying_2_than_todo_tightened, !.
delta(51, walk(_, _, _), 0.00790229664167995) :- !.
delta(51, _, 0.009625704310534425) :- fewer_carrying_2_than_todo_tightened, !.
delta(51, _, -0.00790229664167995).

% tree 52: step size 1.0, 206 examples, 4 leaves
delta(52, walk(_, _, _), -0.010297318519073678) :- fewer_carrying_2_than_todo_tightened, !.
delta(52, walk(_, _, _), 0.007789351036983736) :- !.
delta(52, _, 0.010297318519073678) :- fewer_carrying_2_than_todo_tightened, !.
delta(52, _, -0.007789351036983736).

% tree 53: step size 1.0, 220 examples, 4 leaves
delta(53, walk(_, _, _), -0.010543512983454672) :- fewer_carrying_2_than_todo_tightened, !.
delta(53, walk(_, _, _), 0.008252716209675843) :- !.
delta(53, _, 0.010543512983454672) :- fewer_carrying_2_than_todo_tightened, !.
delta(53, _, -0.008252716209675843).

% tree 54: step size 1.0, 212 examples, 4 leaves
delta(54, walk(_, _, _), -0.010678956703977883) :- fewer_carrying_2_than_todo_tightened, !.
delta(54, walk(_, _, _), 0.007131649510392087) :- !.
delta(54, _, 0.010678956703977883) :- fewer_carrying_2_than_todo_tightened, !.
delta(54, _, -0.007131649510392087).

% tree 55: step size 1.0, 211 examples, 4 leaves
delta(55, walk(_, _, _), -0.009138054301886545) :- fewer_carrying_2_than_todo_tightened, !.
delta(55, walk(_, _, _), 0.006054848478098927) :- !.
delta(55, _, 0.009138054301886545) :- fewer_carrying_2_than_todo_tightened, !.
delta(55, _, -0.006054848478098927).

% tree 56: step size 1.0, 214 examples, 4 leaves
delta(56, walk(_, _, _), -0.005633372347185443) :- fewer_carrying_2_than_todo_tightened, !.
delta(56, walk(_, _, _), 0.007291232277241765) :- !.
delta(56, _, 0.005633372347185443) :- fewer_carrying_2_than_todo_tightened, !.
delta(56, _, -0.007291232277241765).

% tree 57: step size 1.0, 204 examples, 4 leaves
delta(57, walk(_, _, _), -0.008852852234910717) :- fewer_carrying_2_than_todo_tightened, !.
delta(57, walk(_, _, _), 0.006292784854381333) :- !.
delta(57, _, 0.008761442161468359) :- fewer_carrying_2_than_todo_tightened, !.
delta(57, _, -0.006292784854381333).

% tree 58: step size 1.0, 203 examples, 4 leaves
delta(58, walk(_, _, _), -0.008021171362330475) :- fewer_carrying_2_than_todo_tightened, !.
delta(58, walk(_, _, _), 0.006664396278676255) :- !.
delta(58, _, 0.007969833860743129) :- fewer_carrying_2_than_todo_tightened, !.
delta(58, _, -0.006664396278676255).

% tree 59: step size 1.0, 209 examples, 4 leaves
delta(59, walk(_, _, _), -0.004894265402990383) :- fewer_carrying_2_than_todo_tightened, !.
delta(59, walk(_, _, _), 0.005937285967545739) :- !.
delta(59, _, 0.004894265402990383) :- fewer_carrying_2_than_todo_tightened, !.
delta(59, _, -0.005937285967545739).

% tree 60: step size 1.0, 202 examples, 8 leaves
delta(60, walk(_, Location, Man), 0.014035557079220102) :- at(Locatable, Location), spanner(Locatable), at(Man, Location2), toward_could_tighten_nut(Man, Location2, Location), !.
delta(60, walk(_, Location, _), -1.2359771685026274e-5) :- at(Locatable, Location), spanner(Locatable), !.
delta(60, walk(_, _, _), -0.006568879530756682) :- fewer_carrying_2_than_todo_tightened, !.
delta(60, walk(_, _, _), 0.0038682074535967993) :- !.
delta(60, _, 0.0020796860844413774) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(60, _, -0.0014783450215068088) :- fewer_at_2_than_todo_tightened, !.
delta(60, _, -0.011962599260158302) :- usable(Spanner), carrying(_, Spanner), !.
delta(60, _, 0.0001432044821266869).

% tree 61: step size 1.0, 205 examples, 4 leaves
delta(61, walk(_, _, _), -0.01002316647618059) :- fewer_carrying_2_than_todo_tightened, !.
delta(61, walk(_, _, _), 0.005149565942292561) :- !.
delta(61, _, 0.01002316647618059) :- fewer_carrying_2_than_todo_tightened, !.
delta(61, _, -0.005149565942292561).

% tree 62: step size 1.0, 217 examples, 4 leaves
delta(62, walk(_, _, _), -0.006653807784722773) :- fewer_carrying_2_than_todo_tightened, !.
delta(62, walk(_, _, _), 0.0060974744409065225) :- !.
delta(62, _, 0.006653807784722773) :- fewer_carrying_2_than_todo_tightened, !.
delta(62, _, -0.0060974744409065225).

% tree 63: step size 1.0, 205 examples, 4 leaves
delta(63, walk(_, _, _), -0.007509746173962002) :- fewer_carrying_2_than_todo_tightened, !.
delta(63, walk(_, _, _), 0.005037477422128641) :- !.
delta(63, _, 0.007509746173962002) :- fewer_carrying_2_than_todo_tightened, !.
delta(63, _, -0.005037477422128641).

% tree 64: step size 1.0, 216 examples, 4 leaves
delta(64, walk(_, _, _), -0.0048230650748387355) :- fewer_carrying_2_than_todo_tightened, !.
delta(64, walk(_, _, _), 0.00469117807835219) :- !.
delta(64, _, 0.0048230650748387355) :- fewer_carrying_2_than_todo_tightened, !.
delta(64, _, -0.00469117807835219).

% tree 65: step size 1.0, 209 examples, 4 leaves
delta(65, walk(_, _, _), -0.006572226233266239) :- fewer_carrying_2_than_todo_tightened, !.
delta(65, walk(_, _, _), 0.0058997058041433525) :- !.
delta(65, _, 0.006572226233266239) :- fewer_carrying_2_than_todo_tightened, !.
delta(65, _, -0.0058997058041433525).

% tree 66: step size 1.0, 211 examples, 4 leaves
delta(66, walk(_, _, _), -0.006933702800007491) :- fewer_carrying_2_than_todo_tightened, !.
delta(66, walk(_, _, _), 0.0050497961838180125) :- !.
delta(66, _, 0.006933702800007491) :- fewer_carrying_2_than_todo_tightened, !.
delta(66, _, -0.0050497961838180125).

% tree 67: step size 1.0, 203 examples, 4 leaves
delta(67, walk(_, _, _), -0.006622477247467692) :- fewer_carrying_2_than_todo_tightened, !.
delta(67, walk(_, _, _), 0.004689342977167207) :- !.
delta(67, _, 0.006584448816726154) :- fewer_carrying_2_than_todo_tightened, !.
delta(67, _, -0.004689342977167207).

% tree 68: step size 1.0, 212 examples, 4 leaves
delta(68, walk(_, _, _), -0.006540914684775267) :- fewer_carrying_2_than_todo_tightened, !.
delta(68, walk(_, _, _), 0.004093626615075062) :- !.
delta(68, _, 0.006540914684775267) :- fewer_carrying_2_than_todo_tightened, !.
delta(68, _, -0.004093626615075062).

% tree 69: step size 1.0, 205 examples, 4 leaves
delta(69, walk(_, _, _), -0.005741381508410961) :- fewer_carrying_2_than_todo_tightened, !.
delta(69, walk(_, _, _), 0.004386770075044647) :- !.
delta(69, _, 0.005741381508410961) :- fewer_carrying_2_than_todo_tightened, !.
delta(69, _, -0.004386770075044647).

% tree 70: step size 1.0, 209 examples, 4 leaves
delta(70, walk(_, _, _), -0.005566244826206984) :- fewer_carrying_2_than_todo_tightened, !.
delta(70, walk(_, _, _), 0.005014915473872443) :- !.
delta(70, _, 0.005566244826206984) :- fewer_carrying_2_than_todo_tightened, !.
delta(70, _, -0.005014915473872443).

% tree 71: step size 1.0, 220 examples, 4 leaves
delta(71, walk(_, _, _), -0.006506855993968567) :- fewer_carrying_2_than_todo_tightened, !.
delta(71, walk(_, _, _), 0.0038664840914530542) :- !.
delta(71, _, 0.006506855993968567) :- fewer_carrying_2_than_todo_tightened, !.
delta(71, _, -0.0038664840914530542).

% tree 72: step size 1.0, 208 examples, 4 leaves
delta(72, walk(_, _, _), -0.007283509950786734) :- fewer_carrying_2_than_todo_tightened, !.
delta(72, walk(_, _, _), 0.004108274405315825) :- !.
delta(72, _, 0.007283509950786734) :- fewer_carrying_2_than_todo_tightened, !.
delta(72, _, -0.004108274405315825).

% tree 73: step size 1.0, 209 examples, 4 leaves
delta(73, walk(_, _, _), -0.006163205462133228) :- fewer_carrying_2_than_todo_tightened, !.
delta(73, walk(_, _, _), 0.003992912726156869) :- !.
delta(73, _, 0.006163205462133228) :- fewer_carrying_2_than_todo_tightened, !.
delta(73, _, -0.003992912726156869).

% tree 74: step size 1.0, 203 examples, 4 leaves
delta(74, walk(_, _, _), -0.0071668794785523775) :- fewer_carrying_2_than_todo_tightened, !.
delta(74, walk(_, _, _), 0.00438192353213653) :- !.
delta(74, _, 0.0071668794785523775) :- fewer_carrying_2_than_todo_tightened, !.
delta(74, _, -0.00438192353213653).

% tree 75: step size 1.0, 207 examples, 4 leaves
delta(75, walk(_, _, _), -0.0032072023780240553) :- fewer_carrying_2_than_todo_tightened, !.
delta(75, walk(_, _, _), 0.004005156996686937) :- !.
delta(75, _, 0.0032072023780240553) :- fewer_carrying_2_than_todo_tightened, !.
delta(75, _, -0.004005156996686937).

% tree 76: step size 1.0, 216 examples, 7 leaves
delta(76, walk(_, Location, Man), 0.010665888992698392) :- link(Location, Location2), could_pickup_spanner(Man, Location2), at(_, Location), !.
delta(76, walk(_, Location, Man), -0.0005083688389387263) :- link(Location, Location2), could_pickup_spanner(Man, Location2), fewer_carrying_2_than_todo_tightened, !.
delta(76, walk(_, Location, Man), 0.00021673566121909002) :- link(Location, Location2), could_pickup_spanner(Man, Location2), !.
delta(76, walk(_, _, _), -0.0051811522420663865) :- fewer_carrying_2_than_todo_tightened, !.
delta(76, walk(_, _, _), 0.004084422709926015) :- !.
delta(76, _, -0.009311125867479154) :- usable(Spanner), carrying(_, Spanner), !.
delta(76, _, 0.00013576249361634037).

% tree 77: step size 1.0, 203 examples, 4 leaves
delta(77, walk(_, _, _), -0.005229621326970871) :- fewer_carrying_2_than_todo_tightened, !.
delta(77, walk(_, _, _), 0.003530381281331428) :- !.
delta(77, _, 0.005229621326970871) :- fewer_carrying_2_than_todo_tightened, !.
delta(77, _, -0.003530381281331428).

% tree 78: step size 1.0, 204 examples, 4 leaves
delta(78, walk(_, _, _), -0.004901162150532227) :- fewer_carrying_2_than_todo_tightened, !.
delta(78, walk(_, _, _), 0.0036536583252428823) :- !.
delta(78, _, 0.004901162150532227) :- fewer_carrying_2_than_todo_tightened, !.
delta(78, _, -0.0036536583252428823).

% tree 79: step size 1.0, 202 examples, 4 leaves
delta(79, walk(_, _, _), -0.004584035796602298) :- fewer_carrying_2_than_todo_tightened, !.
delta(79, walk(_, _, _), 0.0035502112910141105) :- !.
delta(79, _, 0.004584035796602298) :- fewer_carrying_2_than_todo_tightened, !.
delta(79, _, -0.0035502112910141105).

% tree 80: step size 1.0, 209 examples, 4 leaves
delta(80, walk(_, _, _), -0.005291923627900763) :- fewer_carrying_2_than_todo_tightened, !.
delta(80, walk(_, _, _), 0.003765091123992539) :- !.
delta(80, _, 0.005291923627900763) :- fewer_carrying_2_than_todo_tightened, !.
delta(80, _, -0.003765091123992539).

% tree 81: step size 1.0, 201 examples, 4 leaves
delta(81, walk(_, _, _), -0.004774148037857613) :- fewer_carrying_2_than_todo_tightened, !.
delta(81, walk(_, _, _), 0.003714232116916914) :- !.
delta(81, _, 0.004774148037857613) :- fewer_carrying_2_than_todo_tightened, !.
delta(81, _, -0.003714232116916914).

% tree 82: step size 1.0, 216 examples, 4 leaves
delta(82, walk(_, _, _), -0.005270973218341345) :- fewer_carrying_2_than_todo_tightened, !.
delta(82, walk(_, _, _), 0.0034506128075685325) :- !.
delta(82, _, 0.005270973218341345) :- fewer_carrying_2_than_todo_tightened, !.
delta(82, _, -0.0034506128075685325).

% tree 83: step size 1.0, 205 examples, 9 leaves
delta(83, walk(Location, Location2, Man), 0.010582309199512748) :- link(Location2, Location3), link(Location3, _), link(Location4, Location), link(_, Location4), toward_could_tighten_nut(Man, Location, Location2), !.
delta(83, walk(Location, Location2, _), -7.829707503892133e-6) :- link(Location2, Location3), link(Location3, _), link(Location4, Location), link(_, Location4), !.
delta(83, walk(_, Location, _), -0.00020760212692385227) :- link(Location, Location2), link(Location2, _), !.
delta(83, walk(_, _, _), -0.0033449826861324523) :- fewer_carrying_2_than_todo_tightened, !.
delta(83, walk(_, _, _), 0.002238193664307085) :- !.
delta(83, _, 0.0008646532362273535) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(83, _, -0.0006825306426001502) :- fewer_at_2_than_todo_tightened, !.
delta(83, _, -0.009507691789160243) :- usable(Spanner), carrying(_, Spanner), !.
delta(83, _, 0.00010930622630233742).

% tree 84: step size 1.0, 210 examples, 4 leaves
delta(84, walk(_, _, _), -0.004206595539529536) :- fewer_carrying_2_than_todo_tightened, !.
delta(84, walk(_, _, _), 0.003996945883974322) :- !.
delta(84, _, 0.004206595539529536) :- fewer_carrying_2_than_todo_tightened, !.
delta(84, _, -0.003996945883974322).

% tree 85: step size 1.0, 202 examples, 4 leaves
delta(85, walk(_, _, _), -0.0046119798925654786) :- fewer_carrying_2_than_todo_tightened, !.
delta(85, walk(_, _, _), 0.0037493401782697053) :- !.
delta(85, _, 0.0046119798925654786) :- fewer_carrying_2_than_todo_tightened, !.
delta(85, _, -0.0037493401782697053).

% tree 86: step size 1.0, 204 examples, 4 leaves
delta(86, walk(_, _, _), -0.003450633153774394) :- fewer_carrying_2_than_todo_tightened, !.
delta(86, walk(_, _, _), 0.0037534947630160523) :- !.
delta(86, _, 0.003450633153774394) :- fewer_carrying_2_than_todo_tightened, !.
delta(86, _, -0.0037534947630160523).

% tree 87: step size 1.0, 202 examples, 4 leaves
delta(87, walk(_, _, _), -0.004208560308488829) :- fewer_carrying_2_than_todo_tightened, !.
delta(87, walk(_, _, _), 0.003223801261561392) :- !.
delta(87, _, 0.004208560308488829) :- fewer_carrying_2_than_todo_tightened, !.
delta(87, _, -0.003223801261561392).

% tree 88: step size 1.0, 202 examples, 4 leaves
delta(88, walk(_, _, _), -0.0034740689096511446) :- fewer_carrying_2_than_todo_tightened, !.
delta(88, walk(_, _, _), 0.003244336401793053) :- !.
delta(88, _, 0.0034740689096511446) :- fewer_carrying_2_than_todo_tightened, !.
delta(88, _, -0.003244336401793053).

% tree 89: step size 1.0, 208 examples, 4 leaves
delta(89, walk(_, _, _), -0.004711161314343078) :- fewer_carrying_2_than_todo_tightened, !.
delta(89, walk(_, _, _), 0.003393352963232883) :- !.
delta(89, _, 0.004711161314343078) :- fewer_carrying_2_than_todo_tightened, !.
delta(89, _, -0.003393352963232883).

% tree 90: step size 1.0, 217 examples, 4 leaves
delta(90, walk(_, _, _), -0.003691686434258227) :- fewer_carrying_2_than_todo_tightened, !.
delta(90, walk(_, _, _), 0.003612066943826794) :- !.
delta(90, _, 0.003691686434258227) :- fewer_carrying_2_than_todo_tightened, !.
delta(90, _, -0.003612066943826794).

% tree 91: step size 1.0, 201 examples, 10 leaves
delta(91, walk(Location, _, _), -0.0006018098039473822) :- link(Location2, Location), link(Location3, Location2), at(_, Location3), fewer_carrying_2_than_todo_tightened, !.
delta(91, walk(Location, _, _), 0.0005247696290467746) :- link(Location2, Location), link(Location3, Location2), at(_, Location3), !.
delta(91, walk(Location, _, _), -5.4054912371444265e-5) :- link(Location2, Location), link(Location3, Location2), link(Location4, Location3), at(_, Location4), !.
delta(91, walk(Location, _, _), 0.010173125902346104) :- link(Location2, Location), link(_, Location2), !.
delta(91, walk(_, _, _), -0.0013988568979007273) :- fewer_carrying_2_than_todo_tightened, !.
delta(91, walk(_, _, _), 0.00023586388135842938) :- !.
delta(91, _, 0.0009934259088456214) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(91, _, -0.0006100921725848247) :- fewer_at_2_than_todo_tightened, !.
delta(91, _, -0.009307340618230742) :- usable(Spanner), carrying(_, Spanner), !.
delta(91, _, 6.11228504725639e-5).

% tree 92: step size 1.0, 204 examples, 4 leaves
delta(92, walk(_, _, _), -0.004996256867399601) :- fewer_carrying_2_than_todo_tightened, !.
delta(92, walk(_, _, _), 0.0031367114107221316) :- !.
delta(92, _, 0.004996256867399601) :- fewer_carrying_2_than_todo_tightened, !.
delta(92, _, -0.0031367114107221316).

% tree 93: step size 1.0, 214 examples, 4 leaves
delta(93, walk(_, _, _), -0.004810867906581472) :- fewer_carrying_2_than_todo_tightened, !.
delta(93, walk(_, _, _), 0.0032427868727653852) :- !.
delta(93, _, 0.004810867906581472) :- fewer_carrying_2_than_todo_tightened, !.
delta(93, _, -0.0032427868727653852).

% tree 94: step size 1.0, 203 examples, 4 leaves
delta(94, walk(_, _, _), -0.004176655738253382) :- fewer_carrying_2_than_todo_tightened, !.
delta(94, walk(_, _, _), 0.00296395724549625) :- !.
delta(94, _, 0.004176655738253382) :- fewer_carrying_2_than_todo_tightened, !.
delta(94, _, -0.00296395724549625).

% tree 95: step size 1.0, 202 examples, 4 leaves
delta(95, walk(_, _, _), -0.004914507024187271) :- fewer_carrying_2_than_todo_tightened, !.
delta(95, walk(_, _, _), 0.0024070938039196634) :- !.
delta(95, _, 0.004914507024187271) :- fewer_carrying_2_than_todo_tightened, !.
delta(95, _, -0.0024070938039196634).

% tree 96: step size 1.0, 215 examples, 4 leaves
delta(96, walk(_, _, _), -0.003536097463702579) :- fewer_carrying_2_than_todo_tightened, !.
delta(96, walk(_, _, _), 0.003113834402097202) :- !.
delta(96, _, 0.003536097463702579) :- fewer_carrying_2_than_todo_tightened, !.
delta(96, _, -0.003113834402097202).

% tree 97: step size 1.0, 212 examples, 4 leaves
delta(97, walk(_, _, _), -0.0042243231468159234) :- fewer_carrying_2_than_todo_tightened, !.
delta(97, walk(_, _, _), 0.0034621207997756723) :- !.
delta(97, _, 0.0042243231468159234) :- fewer_carrying_2_than_todo_tightened, !.
delta(97, _, -0.0034621207997756723).

% tree 98: step size 1.0, 201 examples, 4 leaves
delta(98, walk(_, _, _), -0.0037944448592455355) :- fewer_carrying_2_than_todo_tightened, !.
delta(98, walk(_, _, _), 0.0030234113615668344) :- !.
delta(98, _, 0.0037944448592455355) :- fewer_carrying_2_than_todo_tightened, !.
delta(98, _, -0.0030234113615668344).

% tree 99: step size 1.0, 201 examples, 4 leaves
delta(99, walk(_, _, _), -0.0027091306963600696) :- fewer_carrying_2_than_todo_tightened, !.
delta(99, walk(_, _, _), 0.002677259601166749) :- !.
delta(99, _, 0.0027091306963600696) :- fewer_carrying_2_than_todo_tightened, !.
delta(99, _, -0.002677259601166749).

% tree 100: step size 1.0, 203 examples, 4 leaves
delta(100, walk(_, _, _), -0.004538357448616534) :- fewer_carrying_2_than_todo_tightened, !.
delta(100, walk(_, _, _), 0.002510758081104823) :- !.
delta(100, _, 0.004538357448616534) :- fewer_carrying_2_than_todo_tightened, !.
delta(100, _, -0.002510758081104823).

% tree 101: step size 1.0, 209 examples, 4 leaves
delta(101, walk(_, _, _), -0.0033399075848167454) :- fewer_carrying_2_than_todo_tightened, !.
delta(101, walk(_, _, _), 0.0026148551604725473) :- !.
delta(101, _, 0.0033399075848167454) :- fewer_carrying_2_than_todo_tightened, !.
delta(101, _, -0.0026148551604725473).

% tree 102: step size 1.0, 208 examples, 4 leaves
delta(102, walk(_, _, _), -0.004246271018396978) :- fewer_carrying_2_than_todo_tightened, !.
delta(102, walk(_, _, _), 0.0027613406014748722) :- !.
delta(102, _, 0.004246271018396978) :- fewer_carrying_2_than_todo_tightened, !.
delta(102, _, -0.0027613406014748722).

% tree 103: step size 1.0, 204 examples, 4 leaves
delta(103, walk(_, _, _), -0.0036901018421588833) :- fewer_carrying_2_than_todo_tightened, !.
delta(103, walk(_, _, _), 0.0032297775828838823) :- !.
delta(103, _, 0.0036901018421588833) :- fewer_carrying_2_than_todo_tightened, !.
delta(103, _, -0.0032297775828838823).

% tree 104: step size 1.0, 206 examples, 4 leaves
delta(104, walk(_, _, _), -0.0033984116805764178) :- fewer_carrying_2_than_todo_tightened, !.
delta(104, walk(_, _, _), 0.0028711538118078458) :- !.
delta(104, _, 0.0033984116805764178) :- fewer_carrying_2_than_todo_tightened, !.
delta(104, _, -0.002871153811807845).

% tree 105: step size 1.0, 209 examples, 4 leaves
delta(105, walk(_, _, _), -0.0031641617219827158) :- fewer_carrying_2_than_todo_tightened, !.
delta(105, walk(_, _, _), 0.0024373107740341114) :- !.
delta(105, _, 0.0031641617219827158) :- fewer_carrying_2_than_todo_tightened, !.
delta(105, _, -0.0024373107740341114).

% tree 106: step size 1.0, 217 examples, 4 leaves
delta(106, walk(_, _, _), -0.0036554729745904963) :- fewer_carrying_2_than_todo_tightened, !.
delta(106, walk(_, _, _), 0.002452141929645424) :- !.
delta(106, _, 0.0036554729745904963) :- fewer_carrying_2_than_todo_tightened, !.
delta(106, _, -0.002452141929645424).

% tree 107: step size 1.0, 205 examples, 4 leaves
delta(107, walk(_, _, _), -0.0031613596653085867) :- fewer_carrying_2_than_todo_tightened, !.
delta(107, walk(_, _, _), 0.0024889238320560405) :- !.
delta(107, _, 0.0031613596653085867) :- fewer_carrying_2_than_todo_tightened, !.
delta(107, _, -0.0024889238320560405).

% tree 108: step size 1.0, 212 examples, 4 leaves
delta(108, walk(_, _, _), -0.003280596257603993) :- fewer_carrying_2_than_todo_tightened, !.
delta(108, walk(_, _, _), 0.002382881677061521) :- !.
delta(108, _, 0.003280596257603993) :- fewer_carrying_2_than_todo_tightened, !.
delta(108, _, -0.002382881677061521).

% tree 109: step size 1.0, 218 examples, 4 leaves
delta(109, walk(_, _, _), -0.003545842301731967) :- fewer_carrying_2_than_todo_tightened, !.
delta(109, walk(_, _, _), 0.0023023074369338484) :- !.
delta(109, _, 0.003545842301731967) :- fewer_carrying_2_than_todo_tightened, !.
delta(109, _, -0.0023023074369338484).

% tree 110: step size 1.0, 219 examples, 4 leaves
delta(110, walk(_, _, _), -0.0026374422995960934) :- fewer_carrying_2_than_todo_tightened, !.
delta(110, walk(_, _, _), 0.0025592418745728008) :- !.
delta(110, _, 0.0026374422995960934) :- fewer_carrying_2_than_todo_tightened, !.
delta(110, _, -0.0025592418745728008).

% tree 111: step size 1.0, 213 examples, 4 leaves
delta(111, walk(_, _, _), -0.0026956449175246787) :- fewer_carrying_2_than_todo_tightened, !.
delta(111, walk(_, _, _), 0.0025917431616673437) :- !.
delta(111, _, 0.0026853444914309004) :- fewer_carrying_2_than_todo_tightened, !.
delta(111, _, -0.0025917431616673437).

% tree 112: step size 1.0, 201 examples, 4 leaves
delta(112, walk(_, _, _), -0.0026633637046601824) :- fewer_carrying_2_than_todo_tightened, !.
delta(112, walk(_, _, _), 0.0023213415034763047) :- !.
delta(112, _, 0.0026633637046601824) :- fewer_carrying_2_than_todo_tightened, !.
delta(112, _, -0.0023213415034763047).

% tree 113: step size 1.0, 209 examples, 4 leaves
delta(113, walk(_, _, _), -0.0020947584591387404) :- fewer_carrying_2_than_todo_tightened, !.
delta(113, walk(_, _, _), 0.0025978445299567896) :- !.
delta(113, _, 0.0020947584591387404) :- fewer_carrying_2_than_todo_tightened, !.
delta(113, _, -0.0025978445299567896).

% tree 114: step size 1.0, 209 examples, 4 leaves
delta(114, walk(_, _, _), -0.003294636886622668) :- fewer_carrying_2_than_todo_tightened, !.
delta(114, walk(_, _, _), 0.0025239854329887823) :- !.
delta(114, _, 0.003294636886622668) :- fewer_carrying_2_than_todo_tightened, !.
delta(114, _, -0.0025239854329887823).

% tree 115: step size 1.0, 204 examples, 4 leaves
delta(115, walk(_, _, _), -0.0037794930223123894) :- fewer_carrying_2_than_todo_tightened, !.
delta(115, walk(_, _, _), 0.002461541920893796) :- !.
delta(115, _, 0.0037794930223123894) :- fewer_carrying_2_than_todo_tightened, !.
delta(115, _, -0.002461541920893796).

% tree 116: step size 1.0, 201 examples, 4 leaves
delta(116, walk(_, _, _), -0.0020693978900406806) :- fewer_carrying_2_than_todo_tightened, !.
delta(116, walk(_, _, _), 0.002504225278723526) :- !.
delta(116, _, 0.0020693978900406806) :- fewer_carrying_2_than_todo_tightened, !.
delta(116, _, -0.002504225278723526).

% tree 117: step size 1.0, 210 examples, 4 leaves
delta(117, walk(_, _, _), -0.002220391642969487) :- fewer_carrying_2_than_todo_tightened, !.
delta(117, walk(_, _, _), 0.0022954036514835083) :- !.
delta(117, _, 0.002220391642969487) :- fewer_carrying_2_than_todo_tightened, !.
delta(117, _, -0.0022954036514835083).

% tree 118: step size 1.0, 203 examples, 4 leaves
delta(118, walk(_, _, _), -0.0024891103037606014) :- fewer_carrying_2_than_todo_tightened, !.
delta(118, walk(_, _, _), 0.002184536948363072) :- !.
delta(118, _, 0.0024891103037606014) :- fewer_carrying_2_than_todo_tightened, !.
delta(118, _, -0.002184536948363072).

% tree 119: step size 1.0, 208 examples, 4 leaves
delta(119, walk(_, _, _), -0.004034351119239144) :- fewer_carrying_2_than_todo_tightened, !.
delta(119, walk(_, _, _), 0.002454152349412658) :- !.
delta(119, _, 0.004034351119239144) :- fewer_carrying_2_than_todo_tightened, !.
delta(119, _, -0.002454152349412658).

% tree 120: step size 1.0, 205 examples, 4 leaves
delta(120, walk(_, _, _), -0.0038194831369319803) :- fewer_carrying_2_than_todo_tightened, !.
delta(120, walk(_, _, _), 0.0018402297350097415) :- !.
delta(120, _, 0.0038194831369319803) :- fewer_carrying_2_than_todo_tightened, !.
delta(120, _, -0.0018402297350097415).

% tree 121: step size 1.0, 218 examples, 4 leaves
delta(121, walk(_, _, _), -0.003182476502724038) :- fewer_carrying_2_than_todo_tightened, !.
delta(121, walk(_, _, _), 0.002069826596881334) :- !.
delta(121, _, 0.003182476502724038) :- fewer_carrying_2_than_todo_tightened, !.
delta(121, _, -0.002069826596881334).

% tree 122: step size 1.0, 208 examples, 4 leaves
delta(122, walk(_, _, _), -0.0027063070305490904) :- fewer_carrying_2_than_todo_tightened, !.
delta(122, walk(_, _, _), 0.002320034974618181) :- !.
delta(122, _, 0.0026967698801094162) :- fewer_carrying_2_than_todo_tightened, !.
delta(122, _, -0.002320034974618181).

% tree 123: step size 1.0, 217 examples, 4 leaves
delta(123, walk(_, _, _), -0.0031800017257039514) :- fewer_carrying_2_than_todo_tightened, !.
delta(123, walk(_, _, _), 0.0018156755448334276) :- !.
delta(123, _, 0.0031800017257039514) :- fewer_carrying_2_than_todo_tightened, !.
delta(123, _, -0.0018156755448334276).

% tree 124: step size 1.0, 204 examples, 4 leaves
delta(124, walk(_, _, _), -0.002458215030439719) :- fewer_carrying_2_than_todo_tightened, !.
delta(124, walk(_, _, _), 0.0017201113520051475) :- !.
delta(124, _, 0.0024496707894584115) :- fewer_carrying_2_than_todo_tightened, !.
delta(124, _, -0.0017201113520051475).

% tree 125: step size 1.0, 209 examples, 4 leaves
delta(125, walk(_, _, _), -0.002291110403619173) :- fewer_carrying_2_than_todo_tightened, !.
delta(125, walk(_, _, _), 0.0020425624791163086) :- !.
delta(125, _, 0.002291110403619173) :- fewer_carrying_2_than_todo_tightened, !.
delta(125, _, -0.0020425624791163086).

% tree 126: step size 1.0, 215 examples, 4 leaves
delta(126, walk(_, _, _), -0.0030349124036421022) :- fewer_carrying_2_than_todo_tightened, !.
delta(126, walk(_, _, _), 0.002236682075704574) :- !.
delta(126, _, 0.0030349124036421022) :- fewer_carrying_2_than_todo_tightened, !.
delta(126, _, -0.002236682075704574).

% tree 127: step size 1.0, 201 examples, 4 leaves
delta(127, walk(_, _, _), -0.003245751229245056) :- fewer_carrying_2_than_todo_tightened, !.
delta(127, walk(_, _, _), 0.0021936841137246738) :- !.
delta(127, _, 0.003245751229245056) :- fewer_carrying_2_than_todo_tightened, !.
delta(127, _, -0.0021936841137246738).

% tree 128: step size 1.0, 202 examples, 4 leaves
delta(128, walk(_, _, _), -0.0016500475967081692) :- fewer_carrying_2_than_todo_tightened, !.
delta(128, walk(_, _, _), 0.0018282013549073498) :- !.
delta(128, _, 0.0016500475967081692) :- fewer_carrying_2_than_todo_tightened, !.
delta(128, _, -0.0018282013549073498).

% tree 129: step size 1.0, 213 examples, 4 leaves
delta(129, walk(_, _, _), -0.003081668588485788) :- fewer_carrying_2_than_todo_tightened, !.
delta(129, walk(_, _, _), 0.0019777182413803565) :- !.
delta(129, _, 0.003081668588485788) :- fewer_carrying_2_than_todo_tightened, !.
delta(129, _, -0.0019777182413803565).

% tree 130: step size 1.0, 201 examples, 4 leaves
delta(130, walk(_, _, _), -0.0017916679669894083) :- fewer_carrying_2_than_todo_tightened, !.
delta(130, walk(_, _, _), 0.00174325915486966) :- !.
delta(130, _, 0.0017916679669894083) :- fewer_carrying_2_than_todo_tightened, !.
delta(130, _, -0.00174325915486966).

% tree 131: step size 1.0, 214 examples, 8 leaves
delta(131, walk(_, Location, Man), 0.006787378620550108) :- link(Location, Location2), toward_could_pickup_spanner(Man, Location, Location2), at(Man, Location3), toward_could_tighten_nut(Man, Location3, Location), !.
delta(131, walk(_, Location, Man), -5.7623617998975035e-6) :- link(Location, Location2), toward_could_pickup_spanner(Man, Location, Location2), !.
delta(131, walk(_, _, _), -0.002415781733571074) :- fewer_carrying_2_than_todo_tightened, !.
delta(131, walk(_, _, _), 0.001682651034161745) :- !.
delta(131, _, 0.000492993911347766) :- fewer_at_2_than_todo_tightened, fewer_carrying_2_than_todo_tightened, !.
delta(131, _, -0.00032451149208291823) :- fewer_at_2_than_todo_tightened, !.
delta(131, _, -0.0062565918725161285) :- usable(Spanner), carrying(_, Spanner), !.
delta(131, _, 6.262223846342141e-5).

% tree 132: step size 1.0, 207 examples, 4 leaves
delta(132, walk(_, _, _), -0.0032131388211352353) :- fewer_carrying_2_than_todo_tightened, !.
delta(132, walk(_, _, _), 0.001865950235117333) :- !.
delta(132, _, 0.0032131388211352353) :- fewer_carrying_2_than_todo_tightened, !.
delta(132, _, -0.001865950235117333).

% tree 133: step size 1.0, 201 examples, 4 leaves
delta(133, walk(_, _, _), -0.0027755422926853666) :- fewer_carrying_2_than_todo_tightened, !.
delta(133, walk(_, _, _), 0.001734023137535643) :- !.
delta(133, _, 0.0027755422926853666) :- fewer_carrying_2_than_todo_tightened, !.
delta(133, _, -0.001734023137535643).

% tree 134: step size 1.0, 202 examples, 4 leaves
delta(134, walk(_, _, _), -0.0017209118977646793) :- fewer_carrying_2_than_todo_tightened, !.
delta(134, walk(_, _, _), 0.0018743913179105182) :- !.
delta(134, _, 0.0017209118977646793) :- fewer_carrying_2_than_todo_tightened, !.
delta(134, _, -0.0018743913179105182).

% tree 135: step size 1.0, 217 examples, 4 leaves
delta(135, walk(_, _, _), -0.0014958252285270266) :- fewer_carrying_2_than_todo_tightened, !.
delta(135, walk(_, _, _), 0.0017697110328396201) :- !.
delta(135, _, 0.0014958252285270266) :- fewer_carrying_2_than_todo_tightened, !.
delta(135, _, -0.0017697110328396201).

% tree 136: step size 1.0, 218 examples, 4 leaves
delta(136, walk(_, _, _), -0.002336950075551884) :- fewer_carrying_2_than_todo_tightened, !.
delta(136, walk(_, _, _), 0.0016856500364737072) :- !.
delta(136, _, 0.002336950075551884) :- fewer_carrying_2_than_todo_tightened, !.
delta(136, _, -0.0016856500364737072).

% tree 137: step size 1.0, 206 examples, 4 leaves
delta(137, walk(_, _, _), -0.002512923104690832) :- fewer_carrying_2_than_todo_tightened, !.
delta(137, walk(_, _, _), 0.0018199155126986473) :- !.
delta(137, _, 0.002512923104690832) :- fewer_carrying_2_than_todo_tightened, !.
delta(137, _, -0.0018199155126986473).

% tree 138: step size 1.0, 205 examples, 4 leaves
delta(138, walk(_, _, _), -0.0021552688817665774) :- fewer_carrying_2_than_todo_tightened, !.
delta(138, walk(_, _, _), 0.0018147683821624636) :- !.
delta(138, _, 0.0021552688817665774) :- fewer_carrying_2_than_todo_tightened, !.
delta(138, _, -0.0018147683821624636).

% tree 139: step size 1.0, 213 examples, 4 leaves
delta(139, walk(_, _, _), -0.0018742280640389754) :- fewer_carrying_2_than_todo_tightened, !.
delta(139, walk(_, _, _), 0.0016012915036773794) :- !.
delta(139, _, 0.0018742280640389754) :- fewer_carrying_2_than_todo_tightened, !.
delta(139, _, -0.0016012915036773794).

% tree 140: step size 1.0, 213 examples, 1 leaves
delta(140, _, 1.1845517950622484e-20).

% tree 141: step size 1.0, 209 examples, 4 leaves
delta(141, walk(_, _, _), -0.0021558852859707056) :- fewer_carrying_2_than_todo_tightened, !.
delta(141, walk(_, _, _), 0.0016917551223393451) :- !.
delta(141, _, 0.0021558852859707056) :- fewer_carrying_2_than_todo_tightened, !.
delta(141, _, -0.0016917551223393451).

% tree 142: step size 1.0, 221 examples, 4 leaves
delta(142, walk(_, _, _), -0.0010413235699864051) :- fewer_carrying_2_than_todo_tightened, !.
delta(142, walk(_, _, _), 0.0017782238822888837) :- !.
delta(142, _, 0.0010413235699864051) :- fewer_carrying_2_than_todo_tightened, !.
delta(142, _, -0.0017782238822888837).

% tree 143: step size 1.0, 202 examples, 4 leaves
delta(143, walk(_, _, _), -0.001910747369822267) :- fewer_carrying_2_than_todo_tightened, !.
delta(143, walk(_, _, _), 0.0017705867456337477) :- !.
delta(143, _, 0.001910747369822267) :- fewer_carrying_2_than_todo_tightened, !.
delta(143, _, -0.0017705867456337477).

% tree 144: step size 1.0, 216 examples, 4 leaves
delta(144, walk(_, _, _), -0.001877062938325786) :- fewer_carrying_2_than_todo_tightened, !.
delta(144, walk(_, _, _), 0.0018350260699148914) :- !.
delta(144, _, 0.001877062938325786) :- fewer_carrying_2_than_todo_tightened, !.
delta(144, _, -0.0018350260699148914).

% tree 145: step size 1.0, 215 examples, 4 leaves
delta(145, walk(_, _, _), -0.0016784944348491838) :- fewer_carrying_2_than_todo_tightened, !.
delta(145, walk(_, _, _), 0.0018149917407928962) :- !.
delta(145, _, 0.0016784944348491838) :- fewer_carrying_2_than_todo_tightened, !.
delta(145, _, -0.0018149917407928962).

% tree 146: step size 1.0, 209 examples, 4 leaves
delta(146, walk(_, _, _), -0.0022100978637674966) :- fewer_carrying_2_than_todo_tightened, !.
delta(146, walk(_, _, _), 0.0016448562482316493) :- !.
delta(146, _, 0.0022100978637674966) :- fewer_carrying_2_than_todo_tightened, !.
delta(146, _, -0.0016448562482316493).

% tree 147: step size 1.0, 206 examples, 4 leaves
delta(147, walk(_, _, _), -0.0023020310944642957) :- fewer_carrying_2_than_todo_tightened, !.
delta(147, walk(_, _, _), 0.001714460811964838) :- !.
delta(147, _, 0.0023020310944642957) :- fewer_carrying_2_than_todo_tightened, !.
delta(147, _, -0.001714460811964838).

% tree 148: step size 1.0, 209 examples, 4 leaves
delta(148, walk(_, _, _), -0.0019407180803438834) :- fewer_carrying_2_than_todo_tightened, !.
delta(148, walk(_, _, _), 0.0015288354906307442) :- !.
delta(148, _, 0.0019407180803438834) :- fewer_carrying_2_than_todo_tightened, !.
delta(148, _, -0.0015288354906307442).

% tree 149: step size 1.0, 204 examples, 4 leaves
delta(149, walk(_, _, _), -0.0013245275233202062) :- fewer_carrying_2_than_todo_tightened, !.
delta(149, walk(_, _, _), 0.0019339599657610521) :- !.
delta(149, _, 0.0013245275233202062) :- fewer_carrying_2_than_todo_tightened, !.
delta(149, _, -0.0019339599657610521).

% tree 150: step size 1.0, 208 examples, 4 leaves
delta(150, walk(_, _, _), -0.0018908699041270721) :- fewer_carrying_2_than_todo_tightened, !.
delta(150, walk(_, _, _), 0.0016759125104834243) :- !.
delta(150, _, 0.0018908699041270721) :- fewer_carrying_2_than_todo_tightened, !.
delta(150, _, -0.0016759125104834243).

% tree 151: step size 1.0, 205 examples, 4 leaves
delta(151, walk(_, _, _), -0.00234065998280739) :- fewer_carrying_2_than_todo_tightened, !.
delta(151, walk(_, _, _), 0.001742303901216786) :- !.
delta(151, _, 0.00234065998280739) :- fewer_carrying_2_than_todo_tightened, !.
delta(151, _, -0.001742303901216786).

% tree 152: step size 1.0, 204 examples, 4 leaves
delta(152, walk(_, _, _), -0.0021845899630037126) :- fewer_carrying_2_than_todo_tightened, !.
delta(152, walk(_, _, _), 0.0016194230897576423) :- !.
delta(152, _, 0.0021845899630037126) :- fewer_carrying_2_than_todo_tightened, !.
delta(152, _, -0.0016194230897576423).

% tree 153: step size 1.0, 201 examples, 4 leaves
delta(153, walk(_, _, _), -0.0020716697249595793) :- fewer_carrying_2_than_todo_tightened, !.
delta(153, walk(_, _, _), 0.0014224387186120427) :- !.
delta(153, _, 0.0020716697249595793) :- fewer_carrying_2_than_todo_tightened, !.
delta(153, _, -0.0014224387186120427).

% tree 154: step size 1.0, 201 examples, 4 leaves
delta(154, walk(_, _, _), -0.0016874693605961751) :- fewer_carrying_2_than_todo_tightened, !.
delta(154, walk(_, _, _), 0.0016035152469587534) :- !.
delta(154, _, 0.0016874693605961751) :- fewer_carrying_2_than_todo_tightened, !.
delta(154, _, -0.0016035152469587534).

% tree 155: step size 1.0, 216 examples, 4 leaves
delta(155, walk(_, _, _), -0.0015744477109573822) :- fewer_carrying_2_than_todo_tightened, !.
delta(155, walk(_, _, _), 0.0016398326969306331) :- !.
delta(155, _, 0.0015744477109573822) :- fewer_carrying_2_than_todo_tightened, !.
delta(155, _, -0.0016398326969306331).

% tree 156: step size 1.0, 209 examples, 4 leaves
delta(156, walk(_, _, _), -0.0020123990447193235) :- fewer_carrying_2_than_todo_tightened, !.
delta(156, walk(_, _, _), 0.0014311500514599972) :- !.
delta(156, _, 0.0020123990447193235) :- fewer_carrying_2_than_todo_tightened, !.
delta(156, _, -0.0014311500514599972).

% tree 157: step size 1.0, 204 examples, 4 leaves
delta(157, walk(_, _, _), -0.0016987954055278074) :- fewer_carrying_2_than_todo_tightened, !.
delta(157, walk(_, _, _), 0.001677809666290966) :- !.
delta(157, _, 0.0016987954055278074) :- fewer_carrying_2_than_todo_tightened, !.
delta(157, _, -0.001677809666290966).

% tree 158: step size 1.0, 205 examples, 4 leaves
delta(158, walk(_, _, _), -0.0010507876121136916) :- fewer_carrying_2_than_todo_tightened, !.
delta(158, walk(_, _, _), 0.0015828119951136117) :- !.
delta(158, _, 0.0010507876121136916) :- fewer_carrying_2_than_todo_tightened, !.
delta(158, _, -0.0015828119951136117).

% tree 159: step size 1.0, 209 examples, 4 leaves
delta(159, walk(_, _, _), -0.001501163358343594) :- fewer_carrying_2_than_todo_tightened, !.
delta(159, walk(_, _, _), 0.0013017687968603499) :- !.
delta(159, _, 0.001501163358343594) :- fewer_carrying_2_than_todo_tightened, !.
delta(159, _, -0.0013017687968603499).

% tree 160: step size 1.0, 216 examples, 4 leaves
delta(160, walk(_, _, _), -0.0017260299101655651) :- fewer_carrying_2_than_todo_tightened, !.
delta(160, walk(_, _, _), 0.0015823396603403738) :- !.
delta(160, _, 0.0017260299101655651) :- fewer_carrying_2_than_todo_tightened, !.
delta(160, _, -0.0015823396603403738).

% tree 161: step size 1.0, 202 examples, 4 leaves
delta(161, walk(_, _, _), -0.0018203571904242312) :- fewer_carrying_2_than_todo_tightened, !.
delta(161, walk(_, _, _), 0.0015698301381578946) :- !.
delta(161, _, 0.0018203571904242312) :- fewer_carrying_2_than_todo_tightened, !.
delta(161, _, -0.0015698301381578946).

% tree 162: step size 1.0, 206 examples, 4 leaves
delta(162, walk(_, _, _), -0.001362448180749283) :- fewer_carrying_2_than_todo_tightened, !.
delta(162, walk(_, _, _), 0.0013345210669641638) :- !.
delta(162, _, 0.001362448180749283) :- fewer_carrying_2_than_todo_tightened, !.
delta(162, _, -0.0013345210669641638).

% tree 163: step size 1.0, 208 examples, 4 leaves
delta(163, walk(_, _, _), -0.0018868833132844156) :- fewer_carrying_2_than_todo_tightened, !.
delta(163, walk(_, _, _), 0.001353530086436938) :- !.
delta(163, _, 0.0018868833132844156) :- fewer_carrying_2_than_todo_tightened, !.
delta(163, _, -0.001353530086436938).

% tree 164: step size 1.0, 206 examples, 4 leaves
delta(164, walk(_, _, _), -0.0017656512129434344) :- fewer_carrying_2_than_todo_tightened, !.
delta(164, walk(_, _, _), 0.0013605463574042) :- !.
delta(164, _, 0.0017656512129434344) :- fewer_carrying_2_than_todo_tightened, !.
delta(164, _, -0.0013605463574042002).

% tree 165: step size 1.0, 206 examples, 4 leaves
delta(165, walk(_, _, _), -0.0020542783833861007) :- fewer_carrying_2_than_todo_tightened, !.
delta(165, walk(_, _, _), 0.0014816217476008799) :- !.
delta(165, _, 0.0020542783833861007) :- fewer_carrying_2_than_todo_tightened, !.
delta(165, _, -0.0014816217476008799).

% tree 166: step size 1.0, 205 examples, 4 leaves
delta(166, walk(_, _, _), -0.0019161871069670587) :- fewer_carrying_2_than_todo_tightened, !.
delta(166, walk(_, _, _), 0.001456223755928799) :- !.
delta(166, _, 0.0019161871069670587) :- fewer_carrying_2_than_todo_tightened, !.
delta(166, _, -0.001456223755928799).

% tree 167: step size 1.0, 207 examples, 4 leaves
delta(167, walk(_, _, _), -0.0016963062085751735) :- fewer_carrying_2_than_todo_tightened, !.
delta(167, walk(_, _, _), 0.0017833347872328522) :- !.
delta(167, _, 0.0016963062085751735) :- fewer_carrying_2_than_todo_tightened, !.
delta(167, _, -0.0017833347872328522).

% tree 168: step size 1.0, 207 examples, 4 leaves
delta(168, walk(_, _, _), -0.0017015493281237546) :- fewer_carrying_2_than_todo_tightened, !.
delta(168, walk(_, _, _), 0.0014558471780077827) :- !.
delta(168, _, 0.0017015493281237546) :- fewer_carrying_2_than_todo_tightened, !.
delta(168, _, -0.0014558471780077827).

% tree 169: step size 1.0, 217 examples, 4 leaves
delta(169, walk(_, _, _), -0.001597842750590258) :- fewer_carrying_2_than_todo_tightened, !.
delta(169, walk(_, _, _), 0.0013672573678855358) :- !.
delta(169, _, 0.001597842750590258) :- fewer_carrying_2_than_todo_tightened, !.
delta(169, _, -0.0013672573678855358).

% tree 170: step size 1.0, 216 examples, 4 leaves
delta(170, walk(_, _, _), -0.0011763276875527788) :- fewer_carrying_2_than_todo_tightened, !.
delta(170, walk(_, _, _), 0.0014326064472067943) :- !.
delta(170, _, 0.0011763276875527788) :- fewer_carrying_2_than_todo_tightened, !.
delta(170, _, -0.0014326064472067943).

% tree 171: step size 1.0, 215 examples, 4 leaves
delta(171, walk(_, _, _), -0.0019022652712275448) :- fewer_carrying_2_than_todo_tightened, !.
delta(171, walk(_, _, _), 0.0012184581227058671) :- !.
delta(171, _, 0.0019022652712275448) :- fewer_carrying_2_than_todo_tightened, !.
delta(171, _, -0.0012184581227058671).

% tree 172: step size 1.0, 203 examples, 4 leaves
delta(172, walk(_, _, _), -0.0018734649466057563) :- fewer_carrying_2_than_todo_tightened, !.
delta(172, walk(_, _, _), 0.0014747969710863136) :- !.
delta(172, _, 0.0018734649466057563) :- fewer_carrying_2_than_todo_tightened, !.
delta(172, _, -0.0014747969710863136).

% tree 173: step size 1.0, 214 examples, 4 leaves
delta(173, walk(_, _, _), -0.0017647832344810915) :- fewer_carrying_2_than_todo_tightened, !.
delta(173, walk(_, _, _), 0.0012371503696121616) :- !.
delta(173, _, 0.0017647832344810915) :- fewer_carrying_2_than_todo_tightened, !.
delta(173, _, -0.0012371503696121616).

% tree 174: step size 1.0, 219 examples, 4 leaves
delta(174, walk(_, _, _), -0.0009334873434318048) :- fewer_carrying_2_than_todo_tightened, !.
delta(174, walk(_, _, _), 0.0013983460885395533) :- !.
delta(174, _, 0.0009334873434318048) :- fewer_carrying_2_than_todo_tightened, !.
delta(174, _, -0.0013983460885395533).

% tree 175: step size 1.0, 220 examples, 4 leaves
delta(175, walk(_, _, _), -0.0015704964272716024) :- fewer_carrying_2_than_todo_tightened, !.
delta(175, walk(_, _, _), 0.0013465014506691974) :- !.
delta(175, _, 0.0015704964272716024) :- fewer_carrying_2_than_todo_tightened, !.
delta(175, _, -0.0013465014506691974).

% tree 176: step size 1.0, 216 examples, 4 leaves
delta(176, walk(_, _, _), -0.0009157965098422031) :- fewer_carrying_2_than_todo_tightened, !.
delta(176, walk(_, _, _), 0.0013222891884090897) :- !.
delta(176, _, 0.0009134564577303795) :- fewer_carrying_2_than_todo_tightened, !.
delta(176, _, -0.0013222891884090897).

% tree 177: step size 1.0, 218 examples, 4 leaves
delta(177, walk(_, _, _), -0.0026792463410733307) :- fewer_carrying_2_than_todo_tightened, !.
delta(177, walk(_, _, _), 0.0012750045795934925) :- !.
delta(177, _, 0.0026792463410733307) :- fewer_carrying_2_than_todo_tightened, !.
delta(177, _, -0.0012750045795934925).

% tree 178: step size 1.0, 214 examples, 4 leaves
delta(178, walk(_, _, _), -0.0014991816073037577) :- fewer_carrying_2_than_todo_tightened, !.
delta(178, walk(_, _, _), 0.0012949767996187319) :- !.
delta(178, _, 0.0014991816073037577) :- fewer_carrying_2_than_todo_tightened, !.
delta(178, _, -0.0012949767996187319).

% tree 179: step size 1.0, 209 examples, 4 leaves
delta(179, walk(_, _, _), -0.0019953079662579608) :- fewer_carrying_2_than_todo_tightened, !.
delta(179, walk(_, _, _), 0.0014236961653143168) :- !.
delta(179, _, 0.0019953079662579608) :- fewer_carrying_2_than_todo_tightened, !.
delta(179, _, -0.0014236961653143168).

% tree 180: step size 1.0, 203 examples, 4 leaves
delta(180, walk(_, _, _), -0.0011677680130444301) :- fewer_carrying_2_than_todo_tightened, !.
delta(180, walk(_, _, _), 0.0012149788990214751) :- !.
delta(180, _, 0.0011677680130444301) :- fewer_carrying_2_than_todo_tightened, !.
delta(180, _, -0.0012149788990214751).

% tree 181: step size 1.0, 202 examples, 4 leaves
delta(181, walk(_, _, _), -0.001873350736239899) :- fewer_carrying_2_than_todo_tightened, !.
delta(181, walk(_, _, _), 0.0012496243643448954) :- !.
delta(181, _, 0.001873350736239899) :- fewer_carrying_2_than_todo_tightened, !.
delta(181, _, -0.0012496243643448954).

% tree 182: step size 1.0, 201 examples, 4 leaves
delta(182, walk(_, _, _), -0.001754986209470233) :- fewer_carrying_2_than_todo_tightened, !.
delta(182, walk(_, _, _), 0.0013741278536769617) :- !.
delta(182, _, 0.001750639024646403) :- fewer_carrying_2_than_todo_tightened, !.
delta(182, _, -0.0013741278536769617).

% tree 183: step size 1.0, 205 examples, 4 leaves
delta(183, walk(_, _, _), -0.001679933949057488) :- fewer_carrying_2_than_todo_tightened, !.
delta(183, walk(_, _, _), 0.0012632087451099326) :- !.
delta(183, _, 0.001679933949057488) :- fewer_carrying_2_than_todo_tightened, !.
delta(183, _, -0.0012632087451099326).

% tree 184: step size 1.0, 203 examples, 4 leaves
delta(184, walk(_, _, _), -0.0014133329084733152) :- fewer_carrying_2_than_todo_tightened, !.
delta(184, walk(_, _, _), 0.0011418271687750061) :- !.
delta(184, _, 0.0014133329084733152) :- fewer_carrying_2_than_todo_tightened, !.
delta(184, _, -0.0011418271687750061).

% tree 185: step size 1.0, 210 examples, 4 leaves
delta(185, walk(_, _, _), -0.0013106615571233386) :- fewer_carrying_2_than_todo_tightened, !.
delta(185, walk(_, _, _), 0.0011216040716811888) :- !.
delta(185, _, 0.0013074611934607273) :- fewer_carrying_2_than_todo_tightened, !.
delta(185, _, -0.0011216040716811888).

% tree 186: step size 1.0, 205 examples, 4 leaves
delta(186, walk(_, _, _), -0.0011567198038336367) :- fewer_carrying_2_than_todo_tightened, !.
delta(186, walk(_, _, _), 0.0012031180414544534) :- !.
delta(186, _, 0.0011567198038336367) :- fewer_carrying_2_than_todo_tightened, !.
delta(186, _, -0.0012031180414544534).

% tree 187: step size 1.0, 208 examples, 4 leaves
delta(187, walk(_, _, _), -0.0012879935191981713) :- fewer_carrying_2_than_todo_tightened, !.
delta(187, walk(_, _, _), 0.0012271290363113983) :- !.
delta(187, _, 0.0012879935191981713) :- fewer_carrying_2_than_todo_tightened, !.
delta(187, _, -0.0012271290363113985).

% tree 188: step size 1.0, 206 examples, 4 leaves
delta(188, walk(_, _, _), -0.0014318777282859483) :- fewer_carrying_2_than_todo_tightened, !.
delta(188, walk(_, _, _), 0.0013380621713631427) :- !.
delta(188, _, 0.0014318777282859483) :- fewer_carrying_2_than_todo_tightened, !.
delta(188, _, -0.0013380621713631427).

% tree 189: step size 1.0, 204 examples, 4 leaves
delta(189, walk(_, _, _), -0.0013517837055275171) :- fewer_carrying_2_than_todo_tightened, !.
delta(189, walk(_, _, _), 0.0011253577393502683) :- !.
delta(189, _, 0.0013517837055275171) :- fewer_carrying_2_than_todo_tightened, !.
delta(189, _, -0.0011253577393502683).

% tree 190: step size 1.0, 213 examples, 4 leaves
delta(190, walk(_, _, _), -0.0019479677775678665) :- fewer_carrying_2_than_todo_tightened, !.
delta(190, walk(_, _, _), 0.0010674634566018185) :- !.
delta(190, _, 0.0019479677775678665) :- fewer_carrying_2_than_todo_tightened, !.
delta(190, _, -0.0010674634566018185).
