% SHA-256 of what follows: 7d8f92c0954f2e6b7f2afd21a956453595e3739aa7d7abe559226b843f6e4a1a
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
model(domain, 'ferry.pl').
model(domain_sha256, '7b0e6da8bb9b289f6cd848adcb2ab7259ff1de92277447b34cc4127c9344ab81').
model(action, sail(location, location)).
model(action, board(car, location)).
model(action, debark(car, location)).
model(literal, todo_at(car, location)).
model(literal, goal_at(car, location)).
model(literal, done_at(car, location)).
model(literal, at_ferry(location)).
model(literal, at(car, location)).
model(literal, empty_ferry).
model(literal, on(car)).
model(literal, needed_on_to_debark(car)).
model(literal, needed_at_ferry_to_debark(location)).
model(literal, could_board(location)).
model(literal, could_board_needed_on_to_debark(location)).
model(literal, could_board_for_todo_at_any_location(location)).
model(literal, could_debark(location)).
model(literal, could_debark_todo_at(location)).
model(literal, could_debark_for_todo_at_any_location(location)).
model(bias, 'ferry.yaml').
model(bias_sha256, '550de0e32ae7481ec7660f9e0aad27f900204ad218ff9fc66886ee59ad5d0af9').
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
model(trained_episodes, 1145).
model(trees, 130).

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

domain(ferry).
:- ensure_loaded('ferry.pl').
:- add_import_module(policy, ferry, start).

% tree 1: step size 1.0, 211 examples, 6 leaves
delta(1, sail(_, Location), 0.197690791326387) :- todo_at(Car, Location), on(Car), !.
delta(1, sail(_, _), -0.35981547924141477) :- !.
delta(1, board(_, _), 0.197690791326387) :- !.
delta(1, debark(Car, Location), 0.197690791326387) :- todo_at(Car, Location), !.
delta(1, debark(_, _), -0.197690791326387) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 203 examples, 7 leaves
delta(2, sail(_, Location), 0.5308902497581423) :- todo_at(Car, Location), on(Car), !.
delta(2, sail(_, Location), 0.4407940332614386) :- at(_, Location), !.
delta(2, sail(_, _), -0.8374868546811833) :- !.
delta(2, board(_, _), 0.384560621891431) :- !.
delta(2, debark(Car, Location), 0.29486586313894586) :- todo_at(Car, Location), !.
delta(2, debark(_, _), -0.40024661583915455) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 203 examples, 7 leaves
delta(3, sail(_, Location), 0.42687227245521386) :- at(_, Location), !.
delta(3, sail(_, Location), 0.36832284451090413) :- todo_at(Car, Location), on(Car), !.
delta(3, sail(_, _), -0.6202160940243935) :- !.
delta(3, board(_, _), 0.27832324325949104) :- !.
delta(3, debark(Car, Location), 0.19483204315296646) :- todo_at(Car, Location), !.
delta(3, debark(_, _), -0.285186220692354) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 203 examples, 7 leaves
delta(4, sail(_, Location), 0.2838595372493059) :- at(_, Location), !.
delta(4, sail(_, Location), 0.25825272289799084) :- todo_at(Car, Location), on(Car), !.
delta(4, sail(_, _), -0.46037529803829946) :- !.
delta(4, board(_, _), 0.1717524798236371) :- !.
delta(4, debark(Car, Location), 0.11700956441671893) :- todo_at(Car, Location), !.
delta(4, debark(_, _), -0.20758753954314008) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 204 examples, 7 leaves
delta(5, sail(_, Location), 0.19729732837365294) :- at(_, Location), !.
delta(5, sail(_, Location), 0.19778010578408986) :- todo_at(Car, Location), on(Car), !.
delta(5, sail(_, _), -0.3592311590503092) :- !.
delta(5, board(_, _), 0.12357229749214206) :- !.
delta(5, debark(Car, Location), 0.09468802503070356) :- todo_at(Car, Location), !.
delta(5, debark(_, _), -0.15571801830108659) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 204 examples, 8 leaves
delta(6, sail(_, Location), 0.1905184634216176) :- could_board_needed_on_to_debark(Location), !.
delta(6, sail(_, Location), 0.1591783637599968) :- todo_at(Car, Location), on(Car), !.
delta(6, sail(_, _), -0.3296809365055816) :- !.
delta(6, board(Car, _), -0.024053362654752403) :- goal_at(Car, Location), done_at(_, Location), !.
delta(6, board(_, _), 0.0917211059915443) :- !.
delta(6, debark(Car, Location), 0.11090059781890682) :- todo_at(Car, Location), !.
delta(6, debark(_, _), -0.1267086331764467) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 204 examples, 9 leaves
delta(7, sail(_, Location), -0.06922009197876607) :- could_board_needed_on_to_debark(Location), todo_at(_, Location), !.
delta(7, sail(_, Location), 0.3422377318702264) :- could_board_needed_on_to_debark(Location), !.
delta(7, sail(_, Location), 0.22848228148916358) :- todo_at(Car, Location), on(Car), !.
delta(7, sail(_, _), -0.5792624313909837) :- !.
delta(7, board(Car, _), 0.25435037871937577) :- todo_at(Car, _), !.
delta(7, board(_, _), -0.2207164743591724) :- !.
delta(7, debark(Car, Location), 0.32202275935170876) :- todo_at(Car, Location), !.
delta(7, debark(_, _), -0.16330940181101122) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 216 examples, 11 leaves
delta(8, sail(Location, _), -0.005223713593962987) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location), on(Car2), !.
delta(8, sail(Location, Location2), -0.0017970450549624024) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location2), needed_on_to_debark(Car2), !.
delta(8, sail(Location, _), 0.3367633587565237) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(8, sail(_, Location), 0.2030322061268861) :- todo_at(Car, Location), on(Car), !.
delta(8, sail(_, Location), 0.0005627133921972065) :- could_board_needed_on_to_debark(Location), !.
delta(8, sail(_, _), -0.4789325993493311) :- !.
delta(8, board(Car, _), 0.3507842830435592) :- todo_at(Car, _), !.
delta(8, board(_, _), -0.3819070584019004) :- !.
delta(8, debark(Car, Location), 0.25555172624902145) :- todo_at(Car, Location), !.
delta(8, debark(_, _), -0.14261268295741383) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 205 examples, 10 leaves
delta(9, sail(_, Location), 0.07291270083156458) :- goal_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(9, sail(_, Location), -0.337974902520438) :- goal_at(Car, Location), at(Car, _), !.
delta(9, sail(Location, _), -0.14372126878907868) :- todo_at(Car, Location), on(Car), !.
delta(9, sail(_, _), -0.06391284657563667) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(9, sail(_, _), 0.31105434805541454) :- !.
delta(9, board(Car, _), 0.2782742827817612) :- todo_at(Car, _), !.
delta(9, board(_, _), -0.23565567041342209) :- !.
delta(9, debark(Car, Location), 0.1779291825296448) :- todo_at(Car, Location), !.
delta(9, debark(_, _), -0.12550550012604547) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 202 examples, 10 leaves
delta(10, sail(Location, _), -0.004193119823254427) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location), on(Car2), !.
delta(10, sail(Location, _), -0.00164472379128146) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(10, sail(Location, _), 0.1787390360239016) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(10, sail(_, Location), 0.143180566124967) :- todo_at(Car, Location), on(Car), !.
delta(10, sail(_, _), -0.3211382904663844) :- !.
delta(10, board(Car, _), 0.28677422734287766) :- todo_at(Car, _), !.
delta(10, board(_, _), -0.20880501411460928) :- !.
delta(10, debark(Car, Location), 0.13331325447952222) :- todo_at(Car, Location), !.
delta(10, debark(_, _), -0.09707955766721788) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 201 examples, 9 leaves
delta(11, sail(_, _), -0.21002192284307533) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(11, sail(Location, _), -0.10433562200028605) :- todo_at(Car, Location), on(Car), !.
delta(11, sail(_, Location), -0.08859165183722935) :- could_board_for_todo_at_any_location(Location), !.
delta(11, sail(_, _), 0.27930760751361927) :- !.
delta(11, board(Car, _), 0.22445246878023414) :- todo_at(Car, _), !.
delta(11, board(_, _), -0.163543665341521) :- !.
delta(11, debark(Car, Location), 0.10433562200028605) :- todo_at(Car, Location), !.
delta(11, debark(_, _), -0.1580843518993353) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 204 examples, 11 leaves
delta(12, sail(_, Location), 0.04488544528569101) :- goal_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(12, sail(_, Location), -0.21867547029863543) :- goal_at(Car, Location), at(Car, _), !.
delta(12, sail(_, Location), -0.05655079419265909) :- could_board(Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(12, sail(_, Location), 0.22822658635736742) :- could_board(Location), !.
delta(12, sail(_, Location), 0.07679110256966759) :- todo_at(_, Location), !.
delta(12, sail(_, _), -0.1387295866307749) :- !.
delta(12, board(Car, _), 0.18104741400248478) :- todo_at(Car, _), !.
delta(12, board(_, _), -0.13874620461602266) :- !.
delta(12, debark(Car, Location), 0.0864607180302821) :- todo_at(Car, Location), !.
delta(12, debark(_, _), -0.062152941534612066) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 207 examples, 11 leaves
delta(13, sail(Location, Location2), -0.019769922997223494) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location2), needed_on_to_debark(Car2), !.
delta(13, sail(Location, Location2), 0.14618281211498663) :- goal_at(Car, Location), done_at(Car, Location), could_board(Location2), !.
delta(13, sail(Location, _), -0.0011188095886424342) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(13, sail(_, Location), 0.08071701929923299) :- todo_at(Car, Location), on(Car), !.
delta(13, sail(_, Location), -0.017543114085774983) :- could_board_needed_on_to_debark(Location), !.
delta(13, sail(_, _), -0.20606842650621146) :- !.
delta(13, board(Car, _), 0.16409085564178227) :- todo_at(Car, _), !.
delta(13, board(_, _), -0.1669587660867296) :- !.
delta(13, debark(Car, Location), 0.09715317779029221) :- todo_at(Car, Location), !.
delta(13, debark(_, _), -0.05680677279487139) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 204 examples, 12 leaves
delta(14, sail(_, Location), -0.14084920712903454) :- at(Car, Location), at(Car, Location2), could_board_needed_on_to_debark(Location2), needed_at_ferry_to_debark(Location), !.
delta(14, sail(_, Location), 0.15487981720466548) :- at(Car, Location), at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(14, sail(_, Location), 0.017667201672476655) :- at(_, Location), todo_at(Car, Location), on(Car), !.
delta(14, sail(_, Location), -0.228667140395609) :- at(_, Location), !.
delta(14, sail(Location, _), -0.008002444141364378) :- todo_at(Car, Location), on(Car), !.
delta(14, sail(_, _), -0.0052507291485129415) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(14, sail(_, _), 0.20320443576180325) :- !.
delta(14, board(Car, _), 0.14436352638248004) :- todo_at(Car, _), !.
delta(14, board(_, _), -0.09911524328992355) :- !.
delta(14, debark(Car, Location), 0.08772621194168032) :- todo_at(Car, Location), !.
delta(14, debark(_, _), -0.14814173753689702) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 202 examples, 12 leaves
delta(15, sail(_, Location), 0.01561804912877004) :- goal_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(15, sail(_, Location), -0.17648041292910097) :- goal_at(Car, Location), at(Car, _), !.
delta(15, sail(Location, _), -0.041932475348310946) :- todo_at(Car, Location), on(Car), !.
delta(15, sail(_, _), 0.1715781184038809) :- !.
delta(15, board(Car, Location), -0.02972392770233977) :- goal_at(Car2, Location), done_at(Car2, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car, Location), !.
delta(15, board(_, Location), 0.04831833535262919) :- goal_at(Car, Location), done_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(15, board(Car, Location), 0.008782068521344262) :- goal_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(15, board(_, Location), -0.1361604095428084) :- goal_at(_, Location), !.
delta(15, board(_, _), 0.08909350682735642) :- !.
delta(15, debark(Car, Location), 0.07711372582157643) :- todo_at(Car, Location), !.
delta(15, debark(_, _), -0.043955111057385164) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 207 examples, 14 leaves
delta(16, sail(_, Location), -0.014099074353060258) :- at(Car, Location), goal_at(Car, Location2), could_board(Location2), needed_at_ferry_to_debark(Location), !.
delta(16, sail(_, Location), 0.122578852790282) :- at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(16, sail(_, Location), 0.017769192757248514) :- at(_, Location), todo_at(Car, Location), on(Car), !.
delta(16, sail(_, Location), -0.23121410030690057) :- at(_, Location), !.
delta(16, sail(Location, _), -0.006987520138341953) :- at_ferry(Location2), could_debark(Location2), todo_at(Car, Location), on(Car), !.
delta(16, sail(_, _), 0.2082667454846259) :- at_ferry(Location), could_debark(Location), !.
delta(16, sail(_, _), -0.033767055166196214) :- !.
delta(16, board(Car, Location), 0.007145074347871049) :- todo_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(16, board(_, Location), -0.10859447893215894) :- todo_at(_, Location), !.
delta(16, board(Car, _), 0.1347068560104435) :- todo_at(Car, _), !.
delta(16, board(_, _), -0.048386262221350715) :- !.
delta(16, debark(Car, Location), 0.06998359685541919) :- todo_at(Car, Location), !.
delta(16, debark(_, _), -0.07330955537415335) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 210 examples, 10 leaves
delta(17, sail(_, _), -0.1109318564704973) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(17, sail(Location, Location2), 0.06524185805773092) :- goal_at(Car, Location2), at(Car, _), could_board(Location), !.
delta(17, sail(_, Location), -0.09376034088264915) :- goal_at(Car, Location), at(Car, _), !.
delta(17, sail(Location, _), -0.02267723043795543) :- todo_at(Car, Location), on(Car), !.
delta(17, sail(_, _), 0.1815383106866235) :- !.
delta(17, board(Car, _), 0.11224376224818505) :- todo_at(Car, _), !.
delta(17, board(_, _), -0.1431088024788752) :- !.
delta(17, debark(Car, Location), 0.04735694852263347) :- todo_at(Car, Location), !.
delta(17, debark(_, _), -0.10859619079873688) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 209 examples, 13 leaves
delta(18, sail(Location, Location2), 0.002747317509861499) :- at(_, Location2), at(Car, Location), needed_on_to_debark(Car), could_debark_todo_at(Location2), !.
delta(18, sail(Location, Location2), -0.20174424973751257) :- at(_, Location2), at(Car, Location), needed_on_to_debark(Car), !.
delta(18, sail(Location, Location2), -0.08060568563611092) :- at(Car, Location2), todo_at(Car, Location), !.
delta(18, sail(_, Location), 0.09888671989676087) :- at(_, Location), !.
delta(18, sail(Location, _), -0.002264146225255975) :- at_ferry(Location2), at(_, Location2), could_board_needed_on_to_debark(Location), !.
delta(18, sail(_, _), 0.17751441454945996) :- at_ferry(Location), at(_, Location), !.
delta(18, sail(_, Location), 0.024427518429762915) :- todo_at(Car, Location), on(Car), !.
delta(18, sail(_, _), -0.026164863666948163) :- !.
delta(18, board(Car, _), 0.09443790728333984) :- todo_at(Car, _), !.
delta(18, board(_, _), -0.11748404018788337) :- !.
delta(18, debark(Car, Location), 0.0493654667740045) :- todo_at(Car, Location), !.
delta(18, debark(_, _), -0.03508373154908902) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 218 examples, 12 leaves
delta(19, sail(_, Location), 0.011599130539297583) :- could_debark_for_todo_at_any_location(Location), at(Car, Location), todo_at(Car, _), could_debark_todo_at(Location), !.
delta(19, sail(_, Location), -0.032812644721966634) :- could_debark_for_todo_at_any_location(Location), at(Car, Location), todo_at(Car, _), !.
delta(19, sail(Location, Location2), -0.002316379867691913) :- could_debark_for_todo_at_any_location(Location2), todo_at(Car, Location), on(Car), !.
delta(19, sail(_, Location), 0.24176993538490227) :- could_debark_for_todo_at_any_location(Location), !.
delta(19, sail(_, Location), -0.051463491145607165) :- could_board_needed_on_to_debark(Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(19, sail(_, Location), 0.07316488461206355) :- could_board_needed_on_to_debark(Location), !.
delta(19, sail(_, _), -0.24159299120352104) :- !.
delta(19, board(Car, _), 0.0710367393838863) :- todo_at(Car, _), !.
delta(19, board(_, _), -0.033834799435315116) :- !.
delta(19, debark(Car, Location), 0.05764995823321714) :- todo_at(Car, Location), !.
delta(19, debark(_, _), -0.08835935672484678) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 228 examples, 12 leaves
delta(20, sail(Location, Location2), 0.015932699363719445) :- could_board_needed_on_to_debark(Location2), todo_at(Car, Location2), at(Car, Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(20, sail(Location, Location2), -0.04210473171174007) :- could_board_needed_on_to_debark(Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(20, sail(Location, Location2), -0.006833250422705397) :- could_board_needed_on_to_debark(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(20, sail(_, Location), 0.21270382929531143) :- could_board_needed_on_to_debark(Location), !.
delta(20, sail(_, Location), 0.03921877305797224) :- todo_at(Car, Location), on(Car), !.
delta(20, sail(_, _), -0.09329689559546218) :- !.
delta(20, board(Car, Location), 0.0019763295121729392) :- goal_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(20, board(_, Location), -0.15184153996345745) :- goal_at(_, Location), !.
delta(20, board(_, _), 0.034523000183013776) :- !.
delta(20, debark(Car, Location), 0.044233178122611974) :- todo_at(Car, Location), !.
delta(20, debark(_, _), -0.055846027173429076) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 220 examples, 15 leaves
delta(21, sail(Location, Location2), -0.03626159649574615) :- todo_at(Car, Location2), at_ferry(Location3), could_board(Location3), at(Car, Location), !.
delta(21, sail(_, Location), 0.015309086308664656) :- todo_at(_, Location), at_ferry(Location2), could_board(Location2), !.
delta(21, sail(Location, Location2), -0.004231439037203078) :- todo_at(_, Location2), todo_at(Car, Location), on(Car), !.
delta(21, sail(_, Location), 0.25093673639433267) :- todo_at(_, Location), !.
delta(21, sail(_, Location), 0.03171944451829818) :- at(Car, Location), done_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(21, sail(_, Location), -0.2590976545458635) :- at(_, Location), !.
delta(21, sail(Location, _), -0.015473186727398213) :- goal_at(_, Location), !.
delta(21, sail(_, _), 0.05811627759937266) :- !.
delta(21, board(Car, Location), -0.01923998432260388) :- todo_at(Car, Location2), todo_at(_, Location), could_board_needed_on_to_debark(Location2), !.
delta(21, board(Car, Location), 0.014911933903854774) :- todo_at(Car, _), todo_at(_, Location), !.
delta(21, board(Car, _), 0.057895762965627665) :- todo_at(Car, _), !.
delta(21, board(_, _), -0.027146914915344034) :- !.
delta(21, debark(Car, Location), 0.03851489347898539) :- todo_at(Car, Location), !.
delta(21, debark(_, _), -0.061609696026976475) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 211 examples, 8 leaves
delta(22, sail(Location, _), -0.024523289890369275) :- todo_at(Car, Location), on(Car), !.
delta(22, sail(_, _), 0.13858319049282486) :- !.
delta(22, board(Car, Location), 0.0014952089006102526) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(22, board(Car, _), -0.09806379245050748) :- goal_at(Car, Location), at(_, Location), !.
delta(22, board(_, _), 0.021218090729165175) :- !.
delta(22, debark(Car, Location), 0.024523289890369275) :- todo_at(Car, Location), !.
delta(22, debark(_, _), -0.12739884955734934) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 201 examples, 12 leaves
delta(23, sail(Location, Location2), 0.0005960369891951518) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_debark(Location3), could_debark_todo_at(Location2), !.
delta(23, sail(Location, Location2), -0.06767392656233973) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_debark(Location3), !.
delta(23, sail(Location, Location2), -0.022010912542403494) :- todo_at(Car, Location), at(Car, Location2), todo_at(_, Location2), !.
delta(23, sail(Location, Location2), 0.05638451181505526) :- todo_at(Car, Location), at(Car, Location2), !.
delta(23, sail(Location, _), -0.02064228680850172) :- todo_at(Car, Location), on(Car), !.
delta(23, sail(_, _), -0.011546332273137078) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(23, sail(_, _), 0.12538201177134706) :- !.
delta(23, board(Car, _), 0.04723249155572872) :- todo_at(Car, Location), at(_, Location), !.
delta(23, board(_, _), -0.08277266056375523) :- !.
delta(23, debark(Car, Location), 0.023141198818346406) :- todo_at(Car, Location), !.
delta(23, debark(_, _), -0.0774932707721968) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 201 examples, 17 leaves
delta(24, sail(Location, Location2), -0.002327006446529724) :- todo_at(Car, Location2), at(Car, Location), goal_at(Car2, Location), at(Car2, Location2), !.
delta(24, sail(Location, Location2), 0.12614474337106585) :- todo_at(Car, Location2), at(Car, Location), goal_at(_, Location), !.
delta(24, sail(Location, Location2), -0.0358796961465889) :- todo_at(Car, Location2), at(Car, Location), at(_, Location2), !.
delta(24, sail(Location, Location2), 0.023038044139578252) :- todo_at(Car, Location2), at(Car, Location), !.
delta(24, sail(_, Location), -0.010318114172544126) :- could_board_needed_on_to_debark(Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(24, sail(_, Location), 0.04440192971286879) :- could_board_needed_on_to_debark(Location), !.
delta(24, sail(_, Location), -0.15358210067140973) :- at(_, Location), !.
delta(24, sail(_, _), 0.02200228904048002) :- !.
delta(24, board(Car, Location), -0.003955023348982428) :- todo_at(_, Location), goal_at(Car2, Location), done_at(Car2, Location), goal_at(Car, Location), !.
delta(24, board(_, Location), 0.010081917563289565) :- todo_at(_, Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(24, board(Car, Location), 0.002331116572597587) :- todo_at(_, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(24, board(_, Location), -0.03298948010671806) :- todo_at(_, Location), !.
delta(24, board(Car, _), -0.015285908647094884) :- goal_at(Car, Location), done_at(_, Location), !.
delta(24, board(_, _), 0.04110398549441065) :- !.
delta(24, debark(Car, Location), 0.02079926387065212) :- todo_at(Car, Location), !.
delta(24, debark(_, _), -0.021790180248105254) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 219 examples, 11 leaves
delta(25, sail(Location, _), -0.01861699271593995) :- todo_at(Car, Location), on(Car), !.
delta(25, sail(Location, Location2), -0.026892346814249058) :- todo_at(Car, Location2), at(Car, Location), at(Car2, Location2), needed_on_to_debark(Car2), !.
delta(25, sail(Location, Location2), 0.011116792592050352) :- todo_at(Car, Location2), at(Car, Location), !.
delta(25, sail(_, _), 0.10878081551974136) :- !.
delta(25, board(Car, Location), 0.006297130703487123) :- goal_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(25, board(Car, Location), -0.09515912514589338) :- goal_at(_, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(25, board(_, Location), 0.0007086977791779769) :- goal_at(_, Location), !.
delta(25, board(_, _), 0.0235212209189898) :- !.
delta(25, debark(Car, Location), 0.01861699271593995) :- todo_at(Car, Location), !.
delta(25, debark(_, _), -0.07755818004709718) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 248 examples, 15 leaves
delta(26, sail(_, Location), -0.062243059044168485) :- goal_at(Car, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(26, sail(Location, Location2), -0.014925325478069424) :- goal_at(_, Location2), todo_at(Car, Location), on(Car), !.
delta(26, sail(_, Location), 0.21250584805619815) :- goal_at(_, Location), !.
delta(26, sail(_, Location), 0.03572258278067583) :- at_ferry(Location2), could_board_for_todo_at_any_location(Location2), at(_, Location), !.
delta(26, sail(_, _), -0.001308868339869689) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(26, sail(_, Location), -0.1809067721831879) :- at(_, Location), !.
delta(26, sail(_, _), 0.013245393864673419) :- !.
delta(26, board(Car, Location), 0.010083007689935045) :- todo_at(_, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(26, board(_, Location), -0.04019740137349911) :- todo_at(_, Location), !.
delta(26, board(Car, _), -0.0028524002215866485) :- todo_at(Car, _), todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(26, board(Car, _), 0.053590820262562455) :- todo_at(Car, _), !.
delta(26, board(_, _), -0.012357926192104445) :- !.
delta(26, debark(Car, Location), 0.02796433443815333) :- todo_at(Car, Location), !.
delta(26, debark(_, _), -0.045105219987595126) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 228 examples, 12 leaves
delta(27, sail(Location, Location2), -0.002150991109648437) :- at(Car, Location2), todo_at(Car, Location3), could_debark_todo_at(Location3), could_debark_for_todo_at_any_location(Location), !.
delta(27, sail(_, Location), 0.032485951500737416) :- at(Car, Location), todo_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(27, sail(_, Location), 0.0013836547921512582) :- at(Car, Location), todo_at(Car, _), empty_ferry, !.
delta(27, sail(_, Location), -0.1527268817479981) :- at(Car, Location), todo_at(Car, _), !.
delta(27, sail(Location, _), -0.009534709477893713) :- at_ferry(Location2), could_debark(Location2), todo_at(Car, Location), on(Car), !.
delta(27, sail(_, _), 0.1759991996746783) :- at_ferry(Location), could_debark(Location), !.
delta(27, sail(_, _), -0.03516301396261782) :- !.
delta(27, board(Car, _), 0.04127416146111278) :- todo_at(Car, _), !.
delta(27, board(_, _), -0.012165309060512011) :- !.
delta(27, debark(Car, Location), 0.023480678736076607) :- todo_at(Car, Location), !.
delta(27, debark(_, _), -0.06627407182991439) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 217 examples, 15 leaves
delta(28, sail(Location, Location2), -0.004331889845389662) :- todo_at(Car, Location2), at(Car, Location3), needed_at_ferry_to_debark(Location3), could_board_for_todo_at_any_location(Location), !.
delta(28, sail(_, Location), 0.18869609691335856) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(28, sail(_, Location), -0.04260824629224609) :- todo_at(_, Location), at(Car, Location), needed_on_to_debark(Car), !.
delta(28, sail(_, Location), 0.034150124547868525) :- todo_at(_, Location), !.
delta(28, sail(Location, Location2), -0.18873465125624722) :- at(_, Location2), goal_at(_, Location), !.
delta(28, sail(_, Location), 0.01037806570958515) :- at(_, Location), !.
delta(28, sail(_, _), 0.05031694214132878) :- at_ferry(Location), could_debark_for_todo_at_any_location(Location), !.
delta(28, sail(_, _), -0.014179198678036905) :- !.
delta(28, board(Car, Location), -0.034301682609607864) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(28, board(Car, _), 0.01653930438026869) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(28, board(Car, _), 0.05049771605668873) :- todo_at(Car, _), !.
delta(28, board(_, _), -0.005897252885334322) :- !.
delta(28, debark(Car, Location), 0.017797773540815957) :- todo_at(Car, Location), !.
delta(28, debark(_, _), -0.04812464851820242) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 207 examples, 11 leaves
delta(29, sail(Location, Location2), 0.0005841313950455772) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location2), on(Car2), !.
delta(29, sail(Location, Location2), -0.045726379616469186) :- todo_at(Car, Location2), at(Car, Location), !.
delta(29, sail(Location, Location2), -0.056555393360864646) :- todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(29, sail(Location, Location2), 0.04217647258259916) :- todo_at(Car, Location), at(Car, Location2), !.
delta(29, sail(_, Location), 0.13570145842466141) :- goal_at(_, Location), !.
delta(29, sail(_, _), -0.0005505569967629249) :- !.
delta(29, board(Car, _), 0.01658917707943904) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(29, board(_, _), -0.07156690967778102) :- !.
delta(29, debark(Car, Location), 0.010888774325222202) :- todo_at(Car, Location), !.
delta(29, debark(_, _), -0.04403349995539549) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 221 examples, 12 leaves
delta(30, sail(_, Location), 0.09133247803868444) :- at(Car, Location), goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), needed_at_ferry_to_debark(Location), !.
delta(30, sail(_, Location), -0.03550312802024533) :- at(Car, Location), goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(30, sail(Location, Location2), 0.005546879352716997) :- at(_, Location2), todo_at(Car, Location), needed_on_to_debark(Car), !.
delta(30, sail(_, Location), -0.1964245596751882) :- at(_, Location), !.
delta(30, sail(_, _), -0.004494718132425821) :- at_ferry(Location), could_board(Location), !.
delta(30, sail(Location, _), 0.002394088629761903) :- todo_at(_, Location), !.
delta(30, sail(_, _), 0.15237620190546516) :- !.
delta(30, board(Car, _), 0.0577495920003999) :- todo_at(Car, _), !.
delta(30, board(_, _), -0.052180061141165975) :- !.
delta(30, debark(Car, Location), 0.014442365855550386) :- todo_at(Car, Location), !.
delta(30, debark(_, _), -0.02181701185840425) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 219 examples, 14 leaves
delta(31, sail(Location, Location2), -0.001183802816256426) :- goal_at(_, Location2), at(Car, Location2), needed_on_to_debark(Car), could_debark_todo_at(Location), !.
delta(31, sail(_, Location), 0.18243629728610525) :- goal_at(_, Location), at(Car, Location), needed_on_to_debark(Car), !.
delta(31, sail(_, Location), 0.016106962414937625) :- goal_at(Car, Location), todo_at(Car, Location2), could_debark(Location2), !.
delta(31, sail(_, Location), -0.04658742377846871) :- goal_at(_, Location), !.
delta(31, sail(_, _), -0.1249809632407435) :- at_ferry(Location), at(_, Location), !.
delta(31, sail(Location, Location2), 0.02029830426314877) :- todo_at(Car, Location), at(Car, Location2), !.
delta(31, sail(_, _), -0.013758457017044142) :- !.
delta(31, board(Car, Location), 0.025026746293005532) :- goal_at(_, Location), todo_at(Car, _), !.
delta(31, board(_, Location), -0.008927560904988531) :- goal_at(_, Location), !.
delta(31, board(Car, _), 0.0014641978989452765) :- todo_at(Car, Location), done_at(_, Location), !.
delta(31, board(_, _), -0.047010408520218976) :- !.
delta(31, debark(Car, Location), 0.011052020480161) :- todo_at(Car, Location), !.
delta(31, debark(_, _), -0.0345977885658289) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 258 examples, 14 leaves
delta(32, sail(Location, Location2), -0.015627615661658937) :- goal_at(_, Location2), at(Car, Location2), needed_on_to_debark(Car), could_board_needed_on_to_debark(Location), !.
delta(32, sail(_, Location), 0.2168951194411108) :- goal_at(_, Location), at(Car, Location), needed_on_to_debark(Car), !.
delta(32, sail(_, Location), 0.0068141826902599) :- goal_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(32, sail(_, Location), -0.03344887708542986) :- goal_at(_, Location), !.
delta(32, sail(Location, _), -0.2116410653649362) :- goal_at(_, Location), !.
delta(32, sail(_, _), -0.020172986041279137) :- at_ferry(Location), at(_, Location), !.
delta(32, sail(_, _), 0.025589032713276654) :- !.
delta(32, board(Car, Location), 0.018846636801873977) :- todo_at(Car, _), todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), could_board_for_todo_at_any_location(Location), !.
delta(32, board(Car, _), -0.021336388492105098) :- todo_at(Car, _), todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(32, board(Car, _), 0.04919226238416924) :- todo_at(Car, _), !.
delta(32, board(_, _), -0.019995416946625363) :- !.
delta(32, debark(Car, Location), 0.012130424869605137) :- todo_at(Car, Location), !.
delta(32, debark(_, _), -0.016497199361472776) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 206 examples, 12 leaves
delta(33, sail(_, Location), -0.032273148018439696) :- goal_at(_, Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(33, sail(Location, Location2), -0.009417313186741222) :- goal_at(_, Location2), todo_at(Car, Location), on(Car), !.
delta(33, sail(_, Location), 0.13279199084179188) :- goal_at(_, Location), !.
delta(33, sail(_, Location), 0.03869866358886562) :- at(Car, Location), todo_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(33, sail(_, Location), -0.1158900040436278) :- at(_, Location), !.
delta(33, sail(Location, _), 0.05182711154279598) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(33, sail(_, _), -0.009912307996921863) :- !.
delta(33, board(Car, _), -0.05329139018747525) :- goal_at(Car, Location), done_at(_, Location), !.
delta(33, board(_, _), 0.04082941224935368) :- !.
delta(33, debark(Car, Location), 0.012230638441611864) :- todo_at(Car, Location), !.
delta(33, debark(_, _), -0.061107670448046485) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 248 examples, 17 leaves
delta(34, sail(Location, Location2), 0.001091095281728432) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_debark(Location3), could_debark_todo_at(Location2), !.
delta(34, sail(Location, Location2), -0.02286341982252771) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_debark(Location3), !.
delta(34, sail(Location, Location2), -0.0015153689749925752) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), at(Car2, Location), !.
delta(34, sail(Location, Location2), 0.21452469416959039) :- todo_at(Car, Location), at(Car, Location2), !.
delta(34, sail(_, Location), 0.011949105278112306) :- at(Car, Location), goal_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(34, sail(_, Location), -0.3009174042626245) :- at(_, Location), !.
delta(34, sail(_, _), 0.15937055723306295) :- at_ferry(Location), could_debark(Location), !.
delta(34, sail(_, _), -0.016081556697011314) :- !.
delta(34, board(Car, _), 0.013604024860147676) :- goal_at(Car, Location), done_at(_, Location), could_board_needed_on_to_debark(Location), todo_at(Car, Location), !.
delta(34, board(Car, _), -0.005614666338475088) :- goal_at(Car, Location), done_at(_, Location), could_board_needed_on_to_debark(Location), !.
delta(34, board(Car, _), -0.02900484949650635) :- goal_at(Car, Location), done_at(_, Location), !.
delta(34, board(_, Location), -0.017649455900604936) :- goal_at(Car, Location), done_at(Car, Location), todo_at(_, Location), !.
delta(34, board(_, Location), 0.01572147704916923) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(34, board(_, _), 0.037737907688573526) :- !.
delta(34, debark(Car, Location), 0.01193421078174365) :- todo_at(Car, Location), !.
delta(34, debark(_, _), -0.0010150781387665152) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 207 examples, 14 leaves
delta(35, sail(Location, Location2), -0.007195123668562825) :- could_debark_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location2), at(Car2, Location), !.
delta(35, sail(Location, Location2), 0.03227630675468217) :- could_debark_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(35, sail(_, Location), 0.005389138071647721) :- could_debark_for_todo_at_any_location(Location), todo_at(Car, Location), on(Car), !.
delta(35, sail(_, Location), -0.07621543023574902) :- could_debark_for_todo_at_any_location(Location), !.
delta(35, sail(Location, Location2), 0.028617029160566708) :- todo_at(Car, Location), at(Car, Location2), todo_at(_, Location2), !.
delta(35, sail(Location, Location2), -0.044568609793854755) :- todo_at(Car, Location), at(Car, Location2), !.
delta(35, sail(_, Location), -0.03459550106933171) :- could_board_for_todo_at_any_location(Location), !.
delta(35, sail(_, _), 0.1315632043357915) :- !.
delta(35, board(Car, _), 0.015988914932858006) :- todo_at(Car, Location), done_at(_, Location), !.
delta(35, board(Car, _), -0.07547781195834748) :- goal_at(Car, Location), at(_, Location), !.
delta(35, board(_, _), 0.015911050250764273) :- !.
delta(35, debark(Car, Location), 0.007717919494613665) :- todo_at(Car, Location), !.
delta(35, debark(_, _), -0.019179890157906703) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 220 examples, 12 leaves
delta(36, sail(Location, Location2), -0.04697015456826049) :- at(Car, Location2), todo_at(Car, Location3), could_debark(Location3), could_debark_for_todo_at_any_location(Location), !.
delta(36, sail(_, Location), 0.016128513842943486) :- at(Car, Location), todo_at(Car, Location2), could_debark(Location2), !.
delta(36, sail(_, Location), 0.13238656429088952) :- at(Car, Location), goal_at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(36, sail(_, Location), -0.005050032807159575) :- at(_, Location), !.
delta(36, sail(Location, Location2), 0.00999680363726579) :- could_debark_for_todo_at_any_location(Location2), goal_at(Car, Location), at(Car, _), !.
delta(36, sail(_, Location), -0.002398522245268541) :- could_debark_for_todo_at_any_location(Location), !.
delta(36, sail(_, _), -0.028891282720712154) :- !.
delta(36, board(Car, _), 0.06197018927001179) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(36, board(_, _), -0.12983979499318293) :- !.
delta(36, debark(Car, Location), 0.008275200905438682) :- todo_at(Car, Location), !.
delta(36, debark(_, _), -0.026571665966581663) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 220 examples, 12 leaves
delta(37, sail(Location, Location2), 0.06696176303538652) :- goal_at(Car, Location2), at(Car, Location3), could_debark_todo_at(Location3), could_debark_for_todo_at_any_location(Location), !.
delta(37, sail(_, Location), -0.0036143204867954202) :- goal_at(Car, Location), at(Car, Location2), could_debark_todo_at(Location2), !.
delta(37, sail(_, Location), 0.0023431011757856974) :- goal_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(37, sail(_, Location), -0.13189149234384093) :- goal_at(Car, Location), at(Car, _), !.
delta(37, sail(_, Location), -0.06571081378967807) :- at_ferry(Location2), could_debark_for_todo_at_any_location(Location2), at(_, Location), !.
delta(37, sail(_, _), 0.03700606059252108) :- at_ferry(Location), could_debark_for_todo_at_any_location(Location), !.
delta(37, sail(_, _), 0.1228762886925069) :- !.
delta(37, board(Car, _), 0.07603781652116744) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(37, board(_, _), -0.0863827033649912) :- !.
delta(37, debark(Car, Location), 0.010470245129621586) :- todo_at(Car, Location), !.
delta(37, debark(_, _), -0.01789766718694061) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 299 examples, 18 leaves
delta(38, sail(Location, Location2), -0.005689338868126149) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location2), done_at(Car2, Location2), could_board(Location), !.
delta(38, sail(Location, Location2), 0.017938332415110843) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location2), done_at(Car2, Location2), !.
delta(38, sail(Location, Location2), 0.0013125179365410622) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_board(Location3), !.
delta(38, sail(Location, Location2), -0.058483375835651094) :- todo_at(Car, Location), at(Car, Location2), !.
delta(38, sail(Location, Location2), 0.024707850458743644) :- todo_at(Car, Location2), at(Car, Location), goal_at(Car2, Location2), done_at(Car2, Location2), !.
delta(38, sail(Location, Location2), -0.0525471654734127) :- todo_at(Car, Location2), at(Car, Location), !.
delta(38, sail(_, Location), -0.013191346361912448) :- could_board_for_todo_at_any_location(Location), !.
delta(38, sail(_, _), 0.1453282136221799) :- !.
delta(38, board(Car, Location), -0.0015215361893093674) :- todo_at(_, Location), goal_at(Car2, Location), done_at(Car2, Location), goal_at(Car, Location), !.
delta(38, board(_, Location), 0.008283444087622865) :- todo_at(_, Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(38, board(Car, Location), -0.08810787215668221) :- todo_at(_, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(38, board(_, Location), 1.543002573293786e-5) :- todo_at(_, Location), !.
delta(38, board(Car, _), 0.03309895226879396) :- todo_at(Car, Location), at(_, Location), !.
delta(38, board(_, Location), -0.0266001202973533) :- goal_at(_, Location), !.
delta(38, board(_, _), 0.008806007048284157) :- !.
delta(38, debark(Car, Location), 0.0080921404746212) :- todo_at(Car, Location), !.
delta(38, debark(_, _), -0.03311949231241759) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 248 examples, 11 leaves
delta(39, sail(Location, Location2), -0.032156287578448024) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location), at(Car2, Location2), !.
delta(39, sail(Location, Location2), -0.0005879076684389086) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location), on(Car2), !.
delta(39, sail(Location, Location2), 0.29758410282544656) :- todo_at(Car, Location2), at(Car, Location), !.
delta(39, sail(Location, Location2), -0.029033713698911147) :- todo_at(Car, Location), at(Car, _), at(Car, Location2), !.
delta(39, sail(Location, _), 0.09220844219117513) :- todo_at(Car, Location), at(Car, _), !.
delta(39, sail(Location, _), -0.16214615171112662) :- at(Car, Location), todo_at(Car, _), !.
delta(39, sail(_, _), 0.004748104753298137) :- !.
delta(39, board(_, _), -0.1121458793185851) :- !.
delta(39, debark(Car, Location), 0.010235358489740429) :- todo_at(Car, Location), !.
delta(39, debark(_, _), -0.08709339304022887) :- !.
delta(39, _, 0.0).

% tree 40: step size 1.0, 203 examples, 15 leaves
delta(40, sail(Location, Location2), -0.004697573472149206) :- goal_at(Car, Location2), done_at(Car, Location2), at_ferry(Location3), could_debark_for_todo_at_any_location(Location3), could_debark_todo_at(Location), !.
delta(40, sail(_, Location), 0.017859941778408175) :- goal_at(Car, Location), done_at(Car, Location), at_ferry(Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(40, sail(_, Location), 0.003489720431217372) :- goal_at(Car, Location), done_at(Car, Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(40, sail(_, Location), -0.08605185729072366) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(40, sail(Location, Location2), -0.0395508634420273) :- todo_at(Car, Location2), at(Car, Location), at(_, Location2), !.
delta(40, sail(Location, Location2), 0.0006641753947299349) :- todo_at(Car, Location2), at(Car, Location), !.
delta(40, sail(_, _), -0.018036833229093416) :- at_ferry(Location), could_debark_for_todo_at_any_location(Location), !.
delta(40, sail(_, _), 0.24415016149717447) :- !.
delta(40, board(Car, Location), 0.006667212441767218) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), could_board_for_todo_at_any_location(Location), !.
delta(40, board(Car, Location), -0.005691419663565981) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(40, board(_, Location), -0.16226520536021136) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(40, board(_, _), 0.017329035103315994) :- !.
delta(40, debark(Car, Location), 0.008598602937457114) :- todo_at(Car, Location), !.
delta(40, debark(_, _), -0.006422805305358021) :- !.
delta(40, _, 0.0).

% tree 41: step size 1.0, 218 examples, 17 leaves
delta(41, sail(Location, Location2), 0.034518907886679356) :- goal_at(Car, Location2), todo_at(Car, Location3), could_debark(Location3), could_debark_for_todo_at_any_location(Location), !.
delta(41, sail(_, Location), -0.039755511229811746) :- goal_at(Car, Location), todo_at(Car, Location2), could_debark(Location2), !.
delta(41, sail(Location, Location2), -0.023771080433029584) :- goal_at(_, Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(41, sail(_, Location), 0.2154347704381345) :- goal_at(_, Location), !.
delta(41, sail(_, Location), -0.14169457579842587) :- at(Car, Location), todo_at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(41, sail(_, Location), 0.0021062546887070962) :- at(_, Location), !.
delta(41, sail(_, _), 0.04326129292410056) :- at_ferry(Location), could_debark(Location), !.
delta(41, sail(_, _), -0.03143823061263181) :- !.
delta(41, board(Car, _), 0.00404583123878229) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location), !.
delta(41, board(Car, _), -0.003640146802356011) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(41, board(Car, Location), 0.0006666766633153289) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(41, board(Car, _), -0.06587370725320892) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(41, board(Car, _), 0.029811472709143656) :- todo_at(Car, _), !.
delta(41, board(_, _), -0.0016392122298075048) :- !.
delta(41, debark(Car, Location), 0.00810466731045476) :- todo_at(Car, Location), !.
delta(41, debark(_, _), -0.036727418664603884) :- !.
delta(41, _, 0.0).

% tree 42: step size 1.0, 250 examples, 11 leaves
delta(42, sail(Location, Location2), -0.02931366891023871) :- todo_at(Car, Location2), at(Car, Location3), needed_at_ferry_to_debark(Location3), could_board_needed_on_to_debark(Location), !.
delta(42, sail(_, Location), 0.03586473154953935) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(42, sail(_, Location), 0.0009399130324861284) :- todo_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(42, sail(_, Location), -0.07258453691968547) :- todo_at(Car, Location), at(Car, _), !.
delta(42, sail(Location, _), -0.006268772426315466) :- todo_at(Car, Location), on(Car), !.
delta(42, sail(_, _), 0.09284449803368677) :- !.
delta(42, board(Car, _), 0.0517417441796128) :- todo_at(Car, Location), at(_, Location), !.
delta(42, board(_, _), -0.06108081895096658) :- !.
delta(42, debark(Car, Location), 0.008509100323060294) :- todo_at(Car, Location), !.
delta(42, debark(_, _), -0.036088042409914166) :- !.
delta(42, _, 0.0).

% tree 43: step size 1.0, 253 examples, 13 leaves
delta(43, sail(_, Location), 0.004319579487841469) :- at(Car, Location), todo_at(Car, _), could_debark_todo_at(Location), !.
delta(43, sail(_, Location), 0.0012484162682798495) :- at(Car, Location), todo_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(43, sail(_, Location), -0.11718736481217071) :- at(Car, Location), todo_at(Car, _), !.
delta(43, sail(_, Location), 0.0013035469884169547) :- could_board(Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(43, sail(_, Location), -0.010481603618195445) :- could_board(Location), !.
delta(43, sail(Location, _), -0.005451108530382555) :- todo_at(Car, Location), on(Car), !.
delta(43, sail(_, _), 0.11674589360557998) :- !.
delta(43, board(Car, Location), 0.00020807966892976036) :- todo_at(Car, _), todo_at(_, Location), !.
delta(43, board(Car, _), 0.05754913217937491) :- todo_at(Car, _), !.
delta(43, board(_, _), -0.010377633606120323) :- !.
delta(43, debark(Car, Location), 0.00931892744661829) :- todo_at(Car, Location), !.
delta(43, debark(_, _), -0.01894515421989065) :- !.
delta(43, _, 0.0).

% tree 44: step size 1.0, 225 examples, 16 leaves
delta(44, sail(Location, Location2), -0.023839642609593408) :- at(Car, Location2), todo_at(Car, _), could_board_for_todo_at_any_location(Location), needed_at_ferry_to_debark(Location2), !.
delta(44, sail(Location, Location2), 0.06713209544609823) :- at(Car, Location2), todo_at(Car, _), could_board_for_todo_at_any_location(Location), !.
delta(44, sail(_, Location), 0.003417557645185766) :- at(Car, Location), todo_at(Car, _), could_debark_todo_at(Location), !.
delta(44, sail(_, Location), -0.07400296270678013) :- at(Car, Location), todo_at(Car, _), !.
delta(44, sail(Location, Location2), 0.10334349688543747) :- todo_at(_, Location2), at(_, Location), !.
delta(44, sail(_, Location), -0.0020473163805010937) :- todo_at(_, Location), !.
delta(44, sail(_, _), 0.02197340438975538) :- at_ferry(Location), could_debark(Location), !.
delta(44, sail(_, _), -0.046098480460768844) :- !.
delta(44, board(Car, Location), 0.04544969073352672) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, _), !.
delta(44, board(_, Location), -0.004987091540800887) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(44, board(Car, Location), -0.07719278137743578) :- todo_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(44, board(_, Location), 8.684967226378068e-5) :- todo_at(_, Location), !.
delta(44, board(_, _), 0.009911781668319498) :- !.
delta(44, debark(Car, Location), 0.005664142204877999) :- todo_at(Car, Location), !.
delta(44, debark(_, _), -0.02180848091883503) :- !.
delta(44, _, 0.0).

% tree 45: step size 1.0, 269 examples, 12 leaves
delta(45, sail(Location, Location2), -0.013955439137620082) :- goal_at(Car, Location2), at(Car, Location3), could_board_for_todo_at_any_location(Location3), could_board_for_todo_at_any_location(Location), !.
delta(45, sail(_, Location), 0.05588151526773371) :- goal_at(Car, Location), at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(45, sail(_, Location), 0.007609350074821452) :- goal_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(45, sail(_, Location), -0.12063387655040818) :- goal_at(Car, Location), at(Car, _), !.
delta(45, sail(Location, _), -0.0023040432562632758) :- todo_at(Car, Location), on(Car), !.
delta(45, sail(_, _), 0.14918291933934738) :- !.
delta(45, board(Car, Location), -0.012925903268086012) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(45, board(Car, _), 0.02430908644288203) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(45, board(_, _), -0.08670644384345208) :- !.
delta(45, debark(Car, Location), 0.007530013043370894) :- todo_at(Car, Location), !.
delta(45, debark(_, _), -0.01413942072670617) :- !.
delta(45, _, 0.0).

% tree 46: step size 1.0, 255 examples, 14 leaves
delta(46, sail(Location, Location2), -0.008588317422613706) :- at(Car, Location2), todo_at(Car, Location), todo_at(Car, Location3), could_board(Location3), !.
delta(46, sail(Location, Location2), 0.08576475927016049) :- at(Car, Location2), todo_at(Car, Location), !.
delta(46, sail(Location, Location2), 0.027077144421814397) :- at(_, Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(46, sail(_, Location), -0.20557881380552653) :- at(_, Location), !.
delta(46, sail(_, _), -0.001881234590009267) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(46, sail(Location, _), -0.0009907745761344076) :- todo_at(Car, Location), on(Car), !.
delta(46, sail(_, _), 0.10499075135358465) :- !.
delta(46, board(Car, _), -0.016105242951367917) :- goal_at(Car, Location), done_at(_, Location), could_board_needed_on_to_debark(Location), !.
delta(46, board(Car, _), 0.012531699454152232) :- goal_at(Car, Location), done_at(_, Location), todo_at(Car, Location), !.
delta(46, board(Car, _), -0.0021862243483253795) :- goal_at(Car, Location), done_at(_, Location), !.
delta(46, board(_, _), 0.027633073801042907) :- !.
delta(46, debark(Car, Location), 0.008881295632487195) :- todo_at(Car, Location), !.
delta(46, debark(_, _), -0.0029015737211066876) :- !.
delta(46, _, 0.0).

% tree 47: step size 1.0, 230 examples, 14 leaves
delta(47, sail(_, Location), -0.0003027504075580049) :- at(Car, Location), todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), needed_at_ferry_to_debark(Location), !.
delta(47, sail(_, Location), 0.04620239543709679) :- at(Car, Location), todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(47, sail(_, Location), 0.004846759727746005) :- at(Car, Location), todo_at(Car, _), could_debark_todo_at(Location), !.
delta(47, sail(_, Location), -0.09293983175796428) :- at(Car, Location), todo_at(Car, _), !.
delta(47, sail(Location, Location2), -0.008183380673013094) :- at_ferry(Location3), could_debark(Location3), todo_at(Car, Location2), at(Car, Location), !.
delta(47, sail(_, _), 0.09476070805115527) :- at_ferry(Location), could_debark(Location), !.
delta(47, sail(_, _), -0.02926216549860947) :- !.
delta(47, board(_, Location), -0.033221962404822655) :- todo_at(_, Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(47, board(_, Location), 0.013658169098140409) :- todo_at(_, Location), !.
delta(47, board(Car, _), 0.026536229700117125) :- todo_at(Car, _), !.
delta(47, board(_, _), -0.0022913817721885096) :- !.
delta(47, debark(Car, Location), 0.004631373964112241) :- todo_at(Car, Location), !.
delta(47, debark(_, _), -0.017170971947602337) :- !.
delta(47, _, 0.0).

% tree 48: step size 1.0, 213 examples, 15 leaves
delta(48, sail(Location, Location2), -0.07963697180253289) :- todo_at(Car, Location), at(Car, Location2), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(48, sail(Location, Location2), -0.01711919843681031) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), needed_on_to_debark(Car2), !.
delta(48, sail(Location, Location2), 0.01711940677958271) :- todo_at(Car, Location), at(Car, Location2), !.
delta(48, sail(_, Location), -0.027736806445744087) :- at(Car, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(48, sail(_, Location), 0.11678796531619282) :- at(_, Location), !.
delta(48, sail(_, _), 0.012934528457524883) :- at_ferry(Location), could_board(Location), !.
delta(48, sail(_, _), -0.03498441594435895) :- !.
delta(48, board(Car, Location), 0.03726849693650395) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(_, Location), !.
delta(48, board(Car, _), -0.014046309237382737) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(48, board(Car, _), 0.0007381021442433271) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(48, board(_, Location), -0.028931503172694727) :- goal_at(_, Location), !.
delta(48, board(_, _), 0.00491628475845495) :- !.
delta(48, debark(Car, Location), 0.0056504457140410845) :- todo_at(Car, Location), !.
delta(48, debark(_, _), -0.012472563156636812) :- !.
delta(48, _, 0.0).

% tree 49: step size 1.0, 246 examples, 13 leaves
delta(49, sail(Location, Location2), 0.027472271715060167) :- at(Car, Location2), goal_at(Car, Location3), needed_at_ferry_to_debark(Location3), could_board_needed_on_to_debark(Location), !.
delta(49, sail(_, Location), -0.15335086738071632) :- at(Car, Location), goal_at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(49, sail(Location, Location2), -0.046265161308119744) :- at(_, Location2), at(Car, Location), needed_on_to_debark(Car), !.
delta(49, sail(_, Location), 0.10292717291286649) :- at(_, Location), !.
delta(49, sail(Location, _), -0.0007224893455097495) :- goal_at(Car, Location), at(Car, _), could_board_needed_on_to_debark(Location), !.
delta(49, sail(Location, _), 0.12490971366533306) :- goal_at(Car, Location), at(Car, _), !.
delta(49, sail(Location, Location2), -0.02545738120949064) :- todo_at(Car, Location2), at(Car, Location), !.
delta(49, sail(_, _), 0.0253736542834526) :- !.
delta(49, board(Car, _), 0.010560306712879728) :- todo_at(Car, Location), at(_, Location), !.
delta(49, board(_, _), -0.026188425889015897) :- !.
delta(49, debark(Car, Location), 0.006199386787139481) :- todo_at(Car, Location), !.
delta(49, debark(_, _), -0.025915723865103386) :- !.
delta(49, _, 0.0).

% tree 50: step size 1.0, 227 examples, 12 leaves
delta(50, sail(_, Location), 0.09467750491910408) :- could_board(Location), !.
delta(50, sail(Location, Location2), 0.014374322322023403) :- at(Car, Location2), todo_at(Car, _), todo_at(Car, Location), !.
delta(50, sail(_, Location), -0.07699487305229266) :- at(Car, Location), todo_at(Car, _), !.
delta(50, sail(_, _), 0.05653913972013533) :- at_ferry(Location), could_debark(Location), !.
delta(50, sail(_, _), -0.019852422764479544) :- !.
delta(50, board(Car, Location), 0.035723508732215074) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(50, board(Car, Location), 0.0046033642379974034) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(50, board(Car, _), -0.03210945632879987) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(50, board(_, _), -0.09458764157579595) :- !.
delta(50, debark(Car, Location), 0.00478994041118509) :- todo_at(Car, Location), !.
delta(50, debark(_, _), -0.000789222382120658) :- !.
delta(50, _, 0.0).

% tree 51: step size 1.0, 224 examples, 14 leaves
delta(51, sail(_, Location), 0.0728761342285898) :- at(Car, Location), todo_at(Car, Location2), could_board(Location2), needed_at_ferry_to_debark(Location2), !.
delta(51, sail(_, Location), -0.008641632311711974) :- at(Car, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(51, sail(Location, Location2), 0.012807327498477183) :- at(Car, Location2), todo_at(Car, _), todo_at(Car, Location), !.
delta(51, sail(_, Location), -0.15018035442925376) :- at(Car, Location), todo_at(Car, _), !.
delta(51, sail(_, Location), -0.011775105736248355) :- could_board(Location), !.
delta(51, sail(Location, _), 0.13294983911215755) :- goal_at(Car, Location), at(Car, _), !.
delta(51, sail(_, _), -0.0067545036054917715) :- !.
delta(51, board(Car, _), -0.054992537817967466) :- goal_at(Car, Location), done_at(_, Location), !.
delta(51, board(_, Location), -0.015129721178688039) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(51, board(_, Location), 0.0014348127405515519) :- todo_at(_, Location), !.
delta(51, board(_, _), 0.031846173004892196) :- !.
delta(51, debark(Car, Location), 0.005579869293394516) :- todo_at(Car, Location), !.
delta(51, debark(_, _), -0.005793571387566215) :- !.
delta(51, _, 0.0).

% tree 52: step size 1.0, 218 examples, 12 leaves
delta(52, sail(Location, Location2), 0.002334500391459955) :- goal_at(Car, Location2), done_at(Car, Location2), goal_at(_, Location), could_debark_todo_at(Location2), !.
delta(52, sail(Location, Location2), -0.09394432640016429) :- goal_at(Car, Location2), done_at(Car, Location2), goal_at(_, Location), !.
delta(52, sail(_, Location), 0.016158353362109076) :- goal_at(Car, Location), done_at(Car, Location), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(52, sail(_, Location), -0.005491923112527145) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(52, sail(_, Location), -0.019576854561156983) :- could_board_for_todo_at_any_location(Location), !.
delta(52, sail(Location, _), 0.1501050886575007) :- goal_at(Car, Location), at(Car, _), !.
delta(52, sail(_, _), 0.0010537920156971014) :- !.
delta(52, board(Car, _), -0.07454237278616997) :- goal_at(Car, Location), at(_, Location), !.
delta(52, board(_, _), 0.017903792762223765) :- !.
delta(52, debark(Car, Location), 0.0048697312109598715) :- todo_at(Car, Location), !.
delta(52, debark(_, _), -0.01802837783179541) :- !.
delta(52, _, 0.0).

% tree 53: step size 1.0, 213 examples, 14 leaves
delta(53, sail(Location, Location2), 0.0098242428910454) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location), done_at(Car2, Location), could_debark_for_todo_at_any_location(Location2), !.
delta(53, sail(Location, Location2), -0.030176277388771537) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(53, sail(Location, Location2), -0.0017477550978927422) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_board(Location3), !.
delta(53, sail(Location, Location2), 0.12812748238798646) :- todo_at(Car, Location), at(Car, Location2), !.
delta(53, sail(_, Location), -0.02173918591073797) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(53, sail(_, Location), 0.033344422219298925) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(53, sail(Location, _), 0.010737526947280926) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(53, sail(_, _), -0.14436717815829508) :- !.
delta(53, board(Car, _), 0.041723423444054074) :- todo_at(Car, Location), at(_, Location), !.
delta(53, board(_, Location), -0.016212123664877478) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(53, board(_, _), 0.008807059758434738) :- !.
delta(53, debark(Car, Location), 0.005161960492272212) :- todo_at(Car, Location), !.
delta(53, debark(_, _), -0.0045634707789852695) :- !.
delta(53, _, 0.0).

% tree 54: step size 1.0, 201 examples, 13 leaves
delta(54, sail(Location, Location2), -0.009724513284109752) :- goal_at(Car, Location2), done_at(Car, Location2), at(Car2, Location2), needed_on_to_debark(Car2), todo_at(Car2, Location), !.
delta(54, sail(_, Location), 0.04074803173423274) :- goal_at(Car, Location), done_at(Car, Location), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(54, sail(_, Location), 0.017096764113098836) :- goal_at(Car, Location), done_at(Car, Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(54, sail(_, Location), -0.1337288629414861) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(54, sail(Location, Location2), 0.01729609204770662) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(54, sail(_, Location), -0.017960755489085514) :- could_board_for_todo_at_any_location(Location), !.
delta(54, sail(Location, _), -0.0018042933891633647) :- todo_at(Car, Location), on(Car), !.
delta(54, sail(_, _), 0.1336069742295361) :- !.
delta(54, board(Car, _), -0.10018612470667157) :- goal_at(Car, Location), at(_, Location), !.
delta(54, board(_, _), 0.045409760748824246) :- !.
delta(54, debark(Car, Location), 0.005258705951571731) :- todo_at(Car, Location), !.
delta(54, debark(_, _), -0.018450215532858742) :- !.
delta(54, _, 0.0).

% tree 55: step size 1.0, 245 examples, 15 leaves
delta(55, sail(Location, Location2), 0.0004187973185217875) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), needed_on_to_debark(Car2), could_debark_todo_at(Location2), !.
delta(55, sail(Location, Location2), -0.06495686103701633) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), needed_on_to_debark(Car2), !.
delta(55, sail(Location, Location2), 0.04320249374521704) :- todo_at(Car, Location), at(Car, Location2), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(55, sail(Location, Location2), -0.03231594188886457) :- todo_at(Car, Location), at(Car, Location2), !.
delta(55, sail(_, Location), -0.0237964988640901) :- todo_at(Car, Location), at(Car, Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(55, sail(_, Location), 0.17525517655156775) :- todo_at(_, Location), !.
delta(55, sail(_, Location), 0.04883151395211487) :- could_board_needed_on_to_debark(Location), !.
delta(55, sail(_, _), -0.08573064711135658) :- !.
delta(55, board(Car, Location), 0.03275478186631687) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(55, board(Car, _), 0.009650812766387993) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(55, board(Car, _), -0.02120869732775047) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(55, board(_, _), -0.09850391319733275) :- !.
delta(55, debark(Car, Location), 0.00525086579906316) :- todo_at(Car, Location), !.
delta(55, debark(_, _), -0.00019938094172996455) :- !.
delta(55, _, 0.0).

% tree 56: step size 1.0, 267 examples, 15 leaves
delta(56, sail(Location, Location2), -0.002054698014235471) :- at(Car, Location2), todo_at(Car, Location), todo_at(Car, Location3), could_board_needed_on_to_debark(Location3), !.
delta(56, sail(Location, Location2), 0.0773314742458371) :- at(Car, Location2), todo_at(Car, Location), !.
delta(56, sail(_, Location), 0.008207370678165482) :- at(_, Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(56, sail(_, Location), -0.17191144245393583) :- at(_, Location), !.
delta(56, sail(Location, _), -0.001318692710150519) :- todo_at(Car, Location), on(Car), !.
delta(56, sail(_, _), 0.00011572746993732585) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(56, sail(_, _), 0.12314502064485637) :- !.
delta(56, board(Car, Location), 0.013693294571990079) :- todo_at(Car, Location2), at(Car2, Location2), could_board_for_todo_at_any_location(Location), todo_at(Car2, Location), !.
delta(56, board(Car, Location), -0.022108684396502588) :- todo_at(Car, Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(56, board(Car, _), 0.020209914393994322) :- todo_at(Car, Location), at(_, Location), !.
delta(56, board(_, Location), -0.032623042725044654) :- goal_at(_, Location), !.
delta(56, board(_, _), 0.0028109418571708902) :- !.
delta(56, debark(Car, Location), 0.004869724522096485) :- todo_at(Car, Location), !.
delta(56, debark(_, _), -0.004053215703939346) :- !.
delta(56, _, 0.0).

% tree 57: step size 1.0, 203 examples, 15 leaves
delta(57, sail(Location, Location2), 0.0029748459587792446) :- goal_at(Car, Location2), todo_at(Car2, Location), at(Car2, Location2), done_at(Car, Location2), !.
delta(57, sail(Location, Location2), -0.047599465832412785) :- goal_at(_, Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(57, sail(_, Location), -0.014674894989227989) :- goal_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(57, sail(_, Location), 0.1320158424213159) :- goal_at(_, Location), !.
delta(57, sail(Location, Location2), -0.00010731102584963952) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location), on(Car2), !.
delta(57, sail(Location, Location2), 0.015406726638752736) :- todo_at(Car, Location), at(Car, Location2), !.
delta(57, sail(_, _), 0.002713537918052987) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(57, sail(_, _), -0.07590259162916975) :- !.
delta(57, board(Car, Location), 0.011269345924419204) :- todo_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(57, board(_, Location), -0.047818906684701436) :- todo_at(_, Location), !.
delta(57, board(Car, _), 0.03845645226934785) :- todo_at(Car, _), !.
delta(57, board(_, _), -0.0029570052664581047) :- !.
delta(57, debark(Car, Location), 0.0040410934419208054) :- todo_at(Car, Location), !.
delta(57, debark(_, _), -0.0217269876059387) :- !.
delta(57, _, 0.0).

% tree 58: step size 1.0, 238 examples, 14 leaves
delta(58, sail(Location, Location2), 0.014436664463959564) :- could_debark_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), at(_, Location2), !.
delta(58, sail(Location, Location2), -0.0007157806257283333) :- could_debark_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(58, sail(_, Location), -0.15877789944730608) :- could_debark_for_todo_at_any_location(Location), at(_, Location), !.
delta(58, sail(_, Location), 0.010257108551275875) :- could_debark_for_todo_at_any_location(Location), !.
delta(58, sail(Location, Location2), 0.004812428681685114) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location), at(Car2, Location2), !.
delta(58, sail(Location, _), -0.04481757889307619) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(58, sail(Location, _), -0.001348623436984252) :- todo_at(Car, Location), on(Car), !.
delta(58, sail(_, _), 0.22225492184521564) :- !.
delta(58, board(Car, Location), 0.0005818041062809068) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(58, board(Car, _), -0.07974632706330727) :- goal_at(Car, Location), at(_, Location), !.
delta(58, board(_, _), 0.03368671510189142) :- !.
delta(58, debark(Car, Location), 0.0033076509853169327) :- todo_at(Car, Location), !.
delta(58, debark(_, _), -0.016464700558579647) :- !.
delta(58, _, 0.0).

% tree 59: step size 1.0, 216 examples, 17 leaves
delta(59, sail(Location, Location2), -0.0010759623830712665) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_board(Location3), needed_at_ferry_to_debark(Location2), !.
delta(59, sail(Location, Location2), 0.017784524523449526) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_board(Location3), !.
delta(59, sail(Location, Location2), 0.0007278531075969416) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), on(Car2), !.
delta(59, sail(Location, Location2), -0.0520528238374251) :- todo_at(Car, Location), at(Car, Location2), !.
delta(59, sail(Location, Location2), 0.017530957916644406) :- goal_at(Car, Location), done_at(Car, Location), could_debark_for_todo_at_any_location(Location2), !.
delta(59, sail(Location, _), -0.03141127612568251) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(59, sail(_, Location), 0.06843432246425386) :- could_board_needed_on_to_debark(Location), !.
delta(59, sail(_, _), -0.008039974921864874) :- !.
delta(59, board(Car, Location), -0.030115404070146453) :- todo_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(59, board(Car, Location), 0.0038568164287118736) :- todo_at(_, Location), todo_at(Car, _), !.
delta(59, board(_, Location), -0.00010478306295168734) :- todo_at(_, Location), !.
delta(59, board(Car, _), -0.008418697341297856) :- goal_at(Car, Location), done_at(_, Location), could_board_needed_on_to_debark(Location), !.
delta(59, board(Car, _), 0.003763140784176252) :- goal_at(Car, Location), done_at(_, Location), !.
delta(59, board(_, _), 0.023193908203698637) :- !.
delta(59, debark(Car, Location), 0.003971782335034188) :- todo_at(Car, Location), !.
delta(59, debark(_, _), -0.009983399242042239) :- !.
delta(59, _, 0.0).

% tree 60: step size 1.0, 265 examples, 13 leaves
delta(60, sail(Location, Location2), -0.002065839963980497) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location2), done_at(Car2, Location2), needed_at_ferry_to_debark(Location2), !.
delta(60, sail(Location, Location2), 0.002646040179212464) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location2), done_at(Car2, Location2), !.
delta(60, sail(Location, Location2), 0.0005023992530265892) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), on(Car2), !.
delta(60, sail(Location, Location2), -0.1358228280502799) :- todo_at(Car, Location), at(Car, Location2), !.
delta(60, sail(Location, Location2), -0.01827346641553025) :- at(Car, Location2), todo_at(Car, _), could_board_needed_on_to_debark(Location), !.
delta(60, sail(_, Location), 0.18614610540336987) :- at(Car, Location), todo_at(Car, _), !.
delta(60, sail(_, _), 0.012227478802817684) :- at_ferry(Location), could_board(Location), !.
delta(60, sail(_, _), -0.1118018374286965) :- !.
delta(60, board(Car, _), 0.05608033020867153) :- todo_at(Car, _), !.
delta(60, board(_, _), -0.020716432737227848) :- !.
delta(60, debark(Car, Location), 0.00487045852297923) :- todo_at(Car, Location), !.
delta(60, debark(_, _), -0.00173398476895443) :- !.
delta(60, _, 0.0).

% tree 61: step size 1.0, 204 examples, 13 leaves
delta(61, sail(_, Location), 0.0006409713936756727) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location), needed_on_to_debark(Car2), could_debark_todo_at(Location), !.
delta(61, sail(_, Location), -0.05782647529724845) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location), needed_on_to_debark(Car2), !.
delta(61, sail(_, Location), 0.005632397030066641) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(61, sail(_, Location), -0.0026144079539805196) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(61, sail(Location, Location2), 0.00612629176135589) :- could_board(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(61, sail(_, Location), -0.03819060087919596) :- could_board(Location), !.
delta(61, sail(_, _), -0.00745861940244692) :- at_ferry(Location), could_board(Location), !.
delta(61, sail(_, _), 0.06332682862719183) :- !.
delta(61, board(Car, _), -0.01337499569928656) :- goal_at(Car, Location), done_at(_, Location), !.
delta(61, board(_, _), 0.04129149949245662) :- !.
delta(61, debark(Car, Location), 0.004340689683402045) :- todo_at(Car, Location), !.
delta(61, debark(_, _), -0.010860785928054364) :- !.
delta(61, _, 0.0).

% tree 62: step size 1.0, 229 examples, 14 leaves
delta(62, sail(_, Location), -0.04939040433506684) :- goal_at(Car, Location), at(Car, Location2), could_debark_todo_at(Location2), todo_at(Car, Location), !.
delta(62, sail(_, Location), 0.0014283148400701725) :- goal_at(Car, Location), at(Car, Location2), could_debark_todo_at(Location2), !.
delta(62, sail(_, Location), -0.03980371548559509) :- goal_at(Car, Location), done_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(62, sail(_, Location), 0.14207594713441832) :- goal_at(_, Location), !.
delta(62, sail(Location, Location2), 0.0369122069259687) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(62, sail(Location, Location2), -0.026715979521690063) :- todo_at(Car, Location), at(Car, Location2), !.
delta(62, sail(_, _), -0.11152663092257298) :- !.
delta(62, board(Car, Location), 0.010557432935488494) :- goal_at(Car, Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), todo_at(Car, Location2), !.
delta(62, board(Car, Location), -9.971828091771433e-5) :- goal_at(Car, Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(62, board(Car, _), -0.015551765559534185) :- goal_at(Car, Location), at(_, Location), !.
delta(62, board(_, _), 0.04456090719325839) :- !.
delta(62, debark(Car, Location), 0.0038650083975099742) :- todo_at(Car, Location), !.
delta(62, debark(_, _), -0.00916301342697238) :- !.
delta(62, _, 0.0).

% tree 63: step size 1.0, 237 examples, 15 leaves
delta(63, sail(Location, Location2), 0.0028455496913519875) :- goal_at(Car, Location2), done_at(Car, Location2), at(_, Location), could_debark_todo_at(Location2), !.
delta(63, sail(Location, Location2), -0.10039809689606383) :- goal_at(Car, Location2), done_at(Car, Location2), at(_, Location), !.
delta(63, sail(_, Location), 0.018426673088258037) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(63, sail(_, Location), -0.0026573081554626577) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(63, sail(Location, Location2), -0.037629041259732966) :- could_debark_for_todo_at_any_location(Location2), goal_at(_, Location), !.
delta(63, sail(_, Location), 0.01729238172083741) :- could_debark_for_todo_at_any_location(Location), !.
delta(63, sail(Location, _), 0.11669826183145773) :- goal_at(Car, Location), at(Car, _), !.
delta(63, sail(_, _), -0.024811016915667446) :- !.
delta(63, board(Car, Location), 0.03647889145042605) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(63, board(Car, _), -0.06798590716583003) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(63, board(Car, _), 0.03320360259223909) :- todo_at(Car, _), !.
delta(63, board(_, _), -0.0028607745563389644) :- !.
delta(63, debark(Car, Location), 0.0031088298562050817) :- todo_at(Car, Location), !.
delta(63, debark(_, _), -0.004649896892239591) :- !.
delta(63, _, 0.0).

% tree 64: step size 1.0, 259 examples, 16 leaves
delta(64, sail(Location, Location2), -0.0007647408548134196) :- at(Car, Location2), todo_at(Car, Location3), needed_at_ferry_to_debark(Location3), could_debark_todo_at(Location), !.
delta(64, sail(_, Location), 0.08021655952991402) :- at(Car, Location), todo_at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(64, sail(_, Location), -0.036668203734449) :- at(Car, Location), todo_at(Car, _), needed_at_ferry_to_debark(Location), !.
delta(64, sail(_, Location), 0.01660909881306377) :- at(Car, Location), todo_at(Car, _), !.
delta(64, sail(_, Location), 0.003189794173459468) :- todo_at(Car, Location), on(Car), !.
delta(64, sail(_, _), -0.05641861927274434) :- !.
delta(64, board(Car, Location), 0.0065256168695975785) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location2), !.
delta(64, board(Car, Location), -0.0013534628034436082) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(64, board(Car, _), 0.0010304236490220632) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(64, board(Car, _), -0.037821595285476364) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(64, board(Car, Location), 0.006942134461575006) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(64, board(_, Location), -0.01259918478970389) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(64, board(_, _), 0.024246912962749792) :- !.
delta(64, debark(Car, Location), 0.0028038591773002597) :- todo_at(Car, Location), !.
delta(64, debark(_, _), -0.011935965835711958) :- !.
delta(64, _, 0.0).

% tree 65: step size 1.0, 225 examples, 16 leaves
delta(65, sail(Location, Location2), -0.02553078174618112) :- at_ferry(Location3), could_board_for_todo_at_any_location(Location3), goal_at(_, Location2), could_board_needed_on_to_debark(Location), !.
delta(65, sail(_, Location), 0.00032547305921726575) :- at_ferry(Location2), could_board_for_todo_at_any_location(Location2), goal_at(_, Location), !.
delta(65, sail(_, _), 0.10871878367663936) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(65, sail(_, _), 0.00024437428611857767) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(65, sail(Location, Location2), 0.07035317945632318) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(65, sail(_, Location), -0.013650928975709084) :- could_board_for_todo_at_any_location(Location), !.
delta(65, sail(_, Location), -0.0731782451988538) :- at(Car, Location), todo_at(Car, _), !.
delta(65, sail(_, _), 0.018975895370092616) :- !.
delta(65, board(_, Location), -0.0851530261171902) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(65, board(Car, Location), 0.018862488118689708) :- todo_at(_, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(65, board(_, Location), -0.015262623958449831) :- todo_at(_, Location), !.
delta(65, board(Car, _), 0.022683048924832624) :- todo_at(Car, _), !.
delta(65, board(_, _), -0.003081681170307409) :- !.
delta(65, debark(Car, Location), 0.003968337280600156) :- todo_at(Car, Location), !.
delta(65, debark(_, _), -0.015253668307101974) :- !.
delta(65, _, 0.0).

% tree 66: step size 1.0, 212 examples, 16 leaves
delta(66, sail(Location, Location2), -0.000129471484317048) :- todo_at(Car, Location), at(Car, Location2), at(Car, Location3), could_debark_for_todo_at_any_location(Location3), could_debark_todo_at(Location), !.
delta(66, sail(Location, Location2), 0.002747729960303802) :- todo_at(Car, Location), at(Car, Location2), at(Car, Location3), could_debark_for_todo_at_any_location(Location3), !.
delta(66, sail(Location, Location2), -0.0003826438529553026) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_board_needed_on_to_debark(Location3), !.
delta(66, sail(Location, Location2), -0.10248027713412053) :- todo_at(Car, Location), at(Car, Location2), !.
delta(66, sail(Location, Location2), 0.021289391156152852) :- todo_at(Car, Location2), at(Car, _), could_debark_for_todo_at_any_location(Location), !.
delta(66, sail(_, Location), -0.04917661016277475) :- todo_at(Car, Location), at(Car, _), !.
delta(66, sail(_, _), -0.000957170966365241) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(66, sail(_, _), 0.10970144419396703) :- !.
delta(66, board(Car, Location), -0.009578628317798482) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(66, board(Car, Location), 0.027168753940250076) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(_, Location), !.
delta(66, board(Car, _), -0.0451591877762897) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(66, board(Car, _), 0.045431414135843826) :- todo_at(Car, _), !.
delta(66, board(_, _), -0.0004529907843942283) :- !.
delta(66, debark(Car, Location), 0.003031841059647348) :- todo_at(Car, Location), !.
delta(66, debark(_, _), -0.010215403074261813) :- !.
delta(66, _, 0.0).

% tree 67: step size 1.0, 228 examples, 15 leaves
delta(67, sail(Location, Location2), 0.08632065649671024) :- at(Car, Location2), at(Car, Location3), could_board_for_todo_at_any_location(Location3), todo_at(Car, Location), !.
delta(67, sail(_, Location), -0.01472892703370064) :- at(Car, Location), at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(67, sail(_, Location), 0.01391905764291314) :- at(Car, Location), todo_at(Car, Location2), could_debark(Location2), !.
delta(67, sail(_, Location), -0.1426273688427735) :- at(_, Location), !.
delta(67, sail(Location, Location2), 0.02142053603892776) :- todo_at(Car, Location2), at(Car, Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(67, sail(Location, Location2), -0.03249719121299302) :- todo_at(Car, Location2), at(Car, Location), !.
delta(67, sail(Location, _), -0.0016933755748775158) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(67, sail(_, _), 0.16889935692371721) :- !.
delta(67, board(Car, Location), 0.041704790251275846) :- goal_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(67, board(_, Location), -0.03737590652628026) :- goal_at(Car, Location), at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(67, board(_, Location), 0.020840061690840163) :- goal_at(_, Location), !.
delta(67, board(_, _), -0.10309639587286376) :- !.
delta(67, debark(Car, Location), 0.0032706295266573242) :- todo_at(Car, Location), !.
delta(67, debark(_, _), -0.01624094649957951) :- !.
delta(67, _, 0.0).

% tree 68: step size 1.0, 253 examples, 13 leaves
delta(68, sail(Location, Location2), 0.027243422807320013) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location2), done_at(Car2, Location2), !.
delta(68, sail(Location, Location2), 0.0004512632128365203) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), on(Car2), !.
delta(68, sail(Location, Location2), -0.10327788901305432) :- todo_at(Car, Location), at(Car, Location2), !.
delta(68, sail(_, Location), 0.06828052609811001) :- could_debark_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(68, sail(_, Location), -0.0731475003248403) :- could_debark_for_todo_at_any_location(Location), !.
delta(68, sail(Location, _), -0.001702725533926988) :- todo_at(Car, Location), on(Car), !.
delta(68, sail(_, _), 0.10942180573042308) :- !.
delta(68, board(Car, Location), 0.0011133578910874598) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(68, board(Car, _), -0.05619930850890774) :- goal_at(Car, Location), at(_, Location), !.
delta(68, board(_, _), 0.02596593463920743) :- !.
delta(68, debark(Car, Location), 0.003465934080478488) :- todo_at(Car, Location), !.
delta(68, debark(_, _), -0.015023276571130478) :- !.
delta(68, _, 0.0).

% tree 69: step size 1.0, 258 examples, 16 leaves
delta(69, sail(Location, Location2), -0.0014961154375729541) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location2), at(Car2, Location), empty_ferry, !.
delta(69, sail(Location, Location2), 0.02450164798913955) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location2), at(Car2, Location), !.
delta(69, sail(Location, Location2), -0.07435606480001741) :- goal_at(Car, Location2), done_at(Car, Location2), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(69, sail(_, Location), 0.0007084761340492299) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(69, sail(Location, Location2), 0.012961023325180253) :- could_debark_for_todo_at_any_location(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(69, sail(_, Location), -0.03461135841134039) :- could_debark_for_todo_at_any_location(Location), !.
delta(69, sail(Location, _), -0.0013568690916061128) :- todo_at(Car, Location), on(Car), !.
delta(69, sail(_, _), 0.08022904815663334) :- !.
delta(69, board(Car, Location), -0.15099471519312968) :- todo_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(69, board(Car, Location), 0.10700310810291233) :- todo_at(_, Location), todo_at(Car, _), !.
delta(69, board(_, Location), -0.0003698588809015144) :- todo_at(_, Location), !.
delta(69, board(Car, _), 0.03145271404877058) :- todo_at(Car, _), !.
delta(69, board(_, _), -0.00591803775530195) :- !.
delta(69, debark(Car, Location), 0.003138634881368115) :- todo_at(Car, Location), !.
delta(69, debark(_, _), -0.008230888671449181) :- !.
delta(69, _, 0.0).

% tree 70: step size 1.0, 264 examples, 14 leaves
delta(70, sail(Location, Location2), -0.03196994970082763) :- goal_at(Car, Location2), done_at(Car, Location2), goal_at(Car2, Location), done_at(Car2, Location), could_debark_for_todo_at_any_location(Location), !.
delta(70, sail(Location, Location2), 0.02010240714873686) :- goal_at(Car, Location2), done_at(Car, Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(70, sail(_, Location), -0.0005002961323451194) :- goal_at(Car, Location), done_at(Car, Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(70, sail(_, Location), 0.09237723761508962) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(70, sail(Location, Location2), 0.04626059292356595) :- goal_at(Car, Location), done_at(Car, Location), at(_, Location2), !.
delta(70, sail(Location, _), -0.01778528165324386) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(70, sail(_, Location), 0.0007739935431083075) :- todo_at(Car, Location), on(Car), !.
delta(70, sail(_, _), -0.09079335282048942) :- !.
delta(70, board(Car, Location), -0.021008726309095577) :- goal_at(Car2, Location), done_at(Car2, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(70, board(_, Location), 0.0022741432241071362) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(70, board(_, _), 0.0180015922041785) :- !.
delta(70, debark(Car, Location), 0.0024263196637830087) :- todo_at(Car, Location), !.
delta(70, debark(_, _), -0.008470056641571251) :- !.
delta(70, _, 0.0).

% tree 71: step size 1.0, 232 examples, 10 leaves
delta(71, sail(Location, Location2), 0.011490960801225506) :- at(Car, Location2), todo_at(Car, Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(71, sail(Location, Location2), -0.060471372787036924) :- at(Car, Location2), todo_at(Car, Location), !.
delta(71, sail(_, Location), 0.1971534161667555) :- at(Car, Location), goal_at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(71, sail(_, Location), -0.007804092512123209) :- at(_, Location), !.
delta(71, sail(_, Location), 0.0003734991217295631) :- todo_at(Car, Location), on(Car), !.
delta(71, sail(_, _), -0.05115265498309943) :- !.
delta(71, board(_, _), -0.10630366295256952) :- !.
delta(71, debark(Car, Location), 0.0028351434367006466) :- todo_at(Car, Location), !.
delta(71, debark(_, _), -0.01174041620368656) :- !.
delta(71, _, 0.0).

% tree 72: step size 1.0, 254 examples, 14 leaves
delta(72, sail(_, Location), 0.0027715336872935945) :- todo_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(72, sail(_, Location), -0.09616362796085949) :- todo_at(Car, Location), at(Car, _), !.
delta(72, sail(Location, Location2), -0.029581914220651002) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_debark(Location3), !.
delta(72, sail(Location, Location2), 0.006152768506410262) :- todo_at(Car, Location), at(Car, Location2), !.
delta(72, sail(Location, _), -0.0013129260292036268) :- todo_at(Car, Location), on(Car), !.
delta(72, sail(_, _), 0.10237915053926641) :- !.
delta(72, board(Car, Location), 0.00568976523388564) :- goal_at(Car, Location2), at(Car2, Location2), could_board_for_todo_at_any_location(Location), todo_at(Car2, Location), !.
delta(72, board(Car, Location), -0.04393145016834926) :- goal_at(Car, Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(72, board(Car, _), 0.023151994468568526) :- goal_at(Car, Location), at(_, Location), todo_at(Car, Location), !.
delta(72, board(Car, _), -0.003235897078434886) :- goal_at(Car, Location), at(_, Location), !.
delta(72, board(_, _), 0.02809903309620233) :- !.
delta(72, debark(Car, Location), 0.002598163101080339) :- todo_at(Car, Location), !.
delta(72, debark(_, _), -0.003331457351260749) :- !.
delta(72, _, 0.0).

% tree 73: step size 1.0, 247 examples, 16 leaves
delta(73, sail(_, Location), 0.004497961990891484) :- goal_at(Car, Location), done_at(Car, Location2), could_debark_for_todo_at_any_location(Location2), could_debark_todo_at(Location), !.
delta(73, sail(_, Location), -0.06197017198537389) :- goal_at(Car, Location), done_at(Car, Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(73, sail(_, Location), -0.041195506124679496) :- goal_at(Car, Location), todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(73, sail(_, Location), 0.13919441702051635) :- goal_at(_, Location), !.
delta(73, sail(Location, Location2), -0.052061695453410224) :- at(_, Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(73, sail(_, Location), 0.08010813548810836) :- at(_, Location), !.
delta(73, sail(_, _), -0.06773524340362272) :- !.
delta(73, board(Car, _), 0.005654123945962104) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location), !.
delta(73, board(Car, _), -8.605238474877614e-5) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(73, board(Car, Location), 0.0009326871116251809) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(73, board(Car, _), -0.07285124644090633) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(73, board(Car, _), 0.056315513144249006) :- todo_at(Car, _), !.
delta(73, board(_, _), -0.00023259921248497192) :- !.
delta(73, debark(Car, Location), 0.0029564723477402484) :- todo_at(Car, Location), !.
delta(73, debark(_, _), -0.012084374501114261) :- !.
delta(73, _, 0.0).

% tree 74: step size 1.0, 229 examples, 17 leaves
delta(74, sail(Location, Location2), -0.000269578132946149) :- at(Car, Location2), todo_at(Car, Location3), could_debark_todo_at(Location3), could_debark_for_todo_at_any_location(Location), !.
delta(74, sail(_, Location), 0.012102888345544656) :- at(Car, Location), todo_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(74, sail(Location, Location2), 0.0025889104338333853) :- at(Car, Location2), todo_at(Car, _), could_board_for_todo_at_any_location(Location), !.
delta(74, sail(_, Location), -0.06429421173020058) :- at(Car, Location), todo_at(Car, _), !.
delta(74, sail(_, Location), -0.009919378089707106) :- could_board(Location), !.
delta(74, sail(Location, _), -0.002109616430944942) :- todo_at(Car, Location), on(Car), !.
delta(74, sail(_, _), 0.058647806210506255) :- !.
delta(74, board(Car, Location), 0.06449333631493068) :- todo_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(74, board(Car, Location), -0.019344348618023012) :- todo_at(Car, Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(74, board(Car, _), 0.013831857129872215) :- todo_at(Car, Location), at(_, Location), !.
delta(74, board(_, Location), -0.051823046130798696) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(74, board(_, Location), 0.004614142896075465) :- todo_at(_, Location), !.
delta(74, board(Car, _), 0.007619267542329321) :- todo_at(Car, _), !.
delta(74, board(_, _), -0.0003449357654568101) :- !.
delta(74, debark(Car, Location), 0.003580913696534227) :- todo_at(Car, Location), !.
delta(74, debark(_, _), -0.012501993584053525) :- !.
delta(74, _, 0.0).

% tree 75: step size 1.0, 230 examples, 13 leaves
delta(75, sail(Location, Location2), 0.0009001131245976047) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), on(Car2), !.
delta(75, sail(Location, Location2), 6.822171024435909e-5) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(75, sail(Location, Location2), -0.04380981787533442) :- todo_at(Car, Location), at(Car, Location2), !.
delta(75, sail(Location, Location2), 0.013640432859067731) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location2), at(Car2, Location), !.
delta(75, sail(Location, _), -0.04338480212506917) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(75, sail(Location, _), -0.000842814990675205) :- todo_at(Car, Location), on(Car), !.
delta(75, sail(_, _), 0.11361189269232969) :- !.
delta(75, board(Car, Location), 0.032595721962277405) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, _), !.
delta(75, board(_, Location), -0.000741255544984842) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(75, board(_, _), -0.08743972772591875) :- !.
delta(75, debark(Car, Location), 0.0032656001536986697) :- todo_at(Car, Location), !.
delta(75, debark(_, _), -0.0015978145626483757) :- !.
delta(75, _, 0.0).

% tree 76: step size 1.0, 204 examples, 13 leaves
delta(76, sail(Location, Location2), -0.038840964549067235) :- goal_at(Car, Location2), at(Car, Location3), goal_at(Car, Location3), could_board_needed_on_to_debark(Location), !.
delta(76, sail(_, Location), 0.044932553463578266) :- goal_at(Car, Location), at(Car, Location2), goal_at(Car, Location2), !.
delta(76, sail(_, Location), 0.00040950764670984554) :- goal_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(76, sail(_, Location), -0.0747400684032276) :- goal_at(Car, Location), at(Car, _), !.
delta(76, sail(_, Location), -0.0037472636412218528) :- at(_, Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(76, sail(_, Location), 0.05933634608296397) :- at(_, Location), !.
delta(76, sail(_, _), 0.010479030497103881) :- at_ferry(Location), could_board(Location), !.
delta(76, sail(_, _), -0.033773610041828675) :- !.
delta(76, board(Car, _), 0.03837566968669966) :- todo_at(Car, _), !.
delta(76, board(_, _), -0.0028059822116431998) :- !.
delta(76, debark(Car, Location), 0.002989796026995349) :- todo_at(Car, Location), !.
delta(76, debark(_, _), -0.0021353193023899) :- !.
delta(76, _, 0.0).

% tree 77: step size 1.0, 208 examples, 16 leaves
delta(77, sail(Location, Location2), 0.020371147901094143) :- goal_at(Car, Location2), at(Car, Location3), could_board_needed_on_to_debark(Location), at_ferry(Location3), !.
delta(77, sail(Location, Location2), -0.018037776456500485) :- goal_at(Car, Location2), at(Car, _), could_board_needed_on_to_debark(Location), !.
delta(77, sail(_, Location), 0.0026450717036376795) :- goal_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(77, sail(_, Location), -0.08702897435652836) :- goal_at(Car, Location), at(Car, _), !.
delta(77, sail(Location, _), -0.0005089271777028241) :- todo_at(Car, Location), on(Car), !.
delta(77, sail(_, _), 0.06286375076940001) :- !.
delta(77, board(Car, Location), 0.0005501795865650652) :- goal_at(Car, Location2), at(Car2, Location2), could_board_for_todo_at_any_location(Location), todo_at(Car2, Location), !.
delta(77, board(Car, Location), -0.04218370156120879) :- goal_at(Car, Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(77, board(Car, _), 0.008836569216845828) :- goal_at(Car, Location), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(77, board(Car, _), -0.0012682037455779382) :- goal_at(Car, Location), at(_, Location), !.
delta(77, board(_, _), 0.026529138906722254) :- !.
delta(77, debark(Car, Location), -8.684450214842356e-6) :- todo_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(77, debark(Car, _), 0.036530250633679845) :- todo_at(Car, Location), at(_, Location), !.
delta(77, debark(Car, Location), 0.0006111661579496192) :- todo_at(Car, Location), !.
delta(77, debark(_, _), -0.0020700170487714417) :- !.
delta(77, _, 0.0).

% tree 78: step size 1.0, 234 examples, 13 leaves
delta(78, sail(_, Location), -0.00987496495410943) :- could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(78, sail(Location, Location2), -0.0022608215393874536) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(78, sail(_, Location), 0.14564446309445853) :- could_board_for_todo_at_any_location(Location), !.
delta(78, sail(Location, Location2), -0.0005572571143876064) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), needed_on_to_debark(Car2), !.
delta(78, sail(Location, Location2), 0.05334067565385787) :- todo_at(Car, Location), at(Car, Location2), !.
delta(78, sail(Location, _), -0.16160270452268632) :- todo_at(_, Location), !.
delta(78, sail(_, _), 0.003963457672838386) :- !.
delta(78, board(Car, Location), -0.008634410344201355) :- todo_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(78, board(Car, _), 0.05438160922167791) :- todo_at(Car, Location), at(_, Location), !.
delta(78, board(_, _), -0.04285771781743029) :- !.
delta(78, debark(Car, Location), 0.0023089882180830686) :- todo_at(Car, Location), !.
delta(78, debark(_, _), -0.0073100074118219146) :- !.
delta(78, _, 0.0).

% tree 79: step size 1.0, 234 examples, 15 leaves
delta(79, sail(Location, Location2), -0.0006787702453362338) :- goal_at(Car, Location2), done_at(Car, Location2), at(_, Location), could_debark_todo_at(Location), !.
delta(79, sail(Location, Location2), 0.1466997555544934) :- goal_at(Car, Location2), done_at(Car, Location2), at(_, Location), !.
delta(79, sail(Location, Location2), 0.007045224329163778) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(79, sail(_, Location), -0.017876773336577646) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(79, sail(Location, Location2), 0.00047821251515741287) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location2), on(Car2), !.
delta(79, sail(Location, _), -0.13957228853894932) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(79, sail(_, Location), -0.04501867444398268) :- could_debark_for_todo_at_any_location(Location), !.
delta(79, sail(_, _), 0.06634097983678697) :- !.
delta(79, board(Car, Location), 0.02683754348850139) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, _), !.
delta(79, board(_, Location), -0.0006170249485750528) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(79, board(_, Location), -0.06096817353841683) :- todo_at(_, Location), !.
delta(79, board(_, _), 0.011830098285278073) :- !.
delta(79, debark(Car, Location), 0.002239955259579496) :- todo_at(Car, Location), !.
delta(79, debark(_, _), -0.003795933802080437) :- !.
delta(79, _, 0.0).

% tree 80: step size 1.0, 210 examples, 15 leaves
delta(80, sail(Location, Location2), -0.028672584920591965) :- at(Car, Location2), todo_at(Car, Location3), could_board_for_todo_at_any_location(Location), could_board_needed_on_to_debark(Location3), !.
delta(80, sail(Location, Location2), 0.05218976750110661) :- at(Car, Location2), todo_at(Car, _), could_board_for_todo_at_any_location(Location), !.
delta(80, sail(_, Location), -0.06336571664963873) :- at(Car, Location), todo_at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(80, sail(_, Location), 0.024953084799286155) :- at(Car, Location), todo_at(Car, _), !.
delta(80, sail(_, Location), -0.0005387819852812148) :- at_ferry(Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(80, sail(_, _), 0.06393563136903045) :- at_ferry(Location), at(_, Location), !.
delta(80, sail(_, Location), 0.0007341090913545369) :- todo_at(Car, Location), on(Car), !.
delta(80, sail(_, _), -0.020111831237033275) :- !.
delta(80, board(Car, Location), -0.04484806137123568) :- goal_at(Car2, Location), done_at(Car2, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(80, board(_, Location), 0.0014127776820806273) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(80, board(Car, _), -0.0021551203315137864) :- todo_at(Car, Location), done_at(_, Location), !.
delta(80, board(_, _), 0.022735771777349933) :- !.
delta(80, debark(Car, Location), 0.001863313404950243) :- todo_at(Car, Location), !.
delta(80, debark(_, _), -0.00674368418674883) :- !.
delta(80, _, 0.0).

% tree 81: step size 1.0, 284 examples, 16 leaves
delta(81, sail(Location, Location2), 0.02676738772013082) :- could_board_for_todo_at_any_location(Location2), goal_at(Car, Location2), done_at(Car, Location2), goal_at(_, Location), !.
delta(81, sail(_, Location), -0.036276707479489925) :- could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(81, sail(_, Location), -0.013708140963609857) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(81, sail(_, Location), 0.1391190501606898) :- could_board_for_todo_at_any_location(Location), !.
delta(81, sail(Location, Location2), 0.01883235457708583) :- at(_, Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(81, sail(_, Location), -0.11325886546094246) :- at(_, Location), !.
delta(81, sail(Location, _), -0.016297205938234166) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(81, sail(_, _), 0.07685705384719003) :- !.
delta(81, board(Car, Location), 0.006436906464010833) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(81, board(Car, _), -0.0795971438502339) :- goal_at(Car, Location), at(_, Location), !.
delta(81, board(_, Location), 0.0022662139517306596) :- todo_at(_, Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(81, board(_, Location), -0.014677556804799183) :- todo_at(_, Location), !.
delta(81, board(_, _), 0.029137211735664303) :- !.
delta(81, debark(Car, Location), 0.0026379177289333534) :- todo_at(Car, Location), !.
delta(81, debark(_, _), -0.006774962198806746) :- !.
delta(81, _, 0.0).

% tree 82: step size 1.0, 210 examples, 16 leaves
delta(82, sail(Location, Location2), -0.0074954653708095) :- at(_, Location2), goal_at(_, Location2), could_debark_for_todo_at_any_location(Location), !.
delta(82, sail(_, Location), 0.08506578172683861) :- at(_, Location), goal_at(_, Location), !.
delta(82, sail(Location, Location2), 0.021372414377305554) :- at(_, Location2), at(_, Location), !.
delta(82, sail(_, Location), -0.03571052255897635) :- at(_, Location), !.
delta(82, sail(Location, Location2), 0.009150029763223159) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car, Location3), could_debark(Location3), !.
delta(82, sail(Location, Location2), -0.00025900198052064403) :- todo_at(Car, Location2), at(Car, Location), !.
delta(82, sail(_, Location), 0.00016718147412747003) :- todo_at(Car, Location), on(Car), !.
delta(82, sail(_, _), -0.050700382813125916) :- !.
delta(82, board(Car, Location), 0.0003361646108192173) :- todo_at(Car2, Location), goal_at(Car, Location2), could_board(Location2), at(Car2, Location2), !.
delta(82, board(Car, Location), -0.04274488094082022) :- todo_at(_, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(82, board(_, Location), 0.0006837088382030694) :- todo_at(_, Location), !.
delta(82, board(Car, _), -0.009244992419543002) :- goal_at(Car, Location), done_at(_, Location), !.
delta(82, board(_, _), 0.020614630181396282) :- !.
delta(82, debark(Car, Location), 0.0025191387952577453) :- todo_at(Car, Location), !.
delta(82, debark(_, _), -0.0016425057188860235) :- !.
delta(82, _, 0.0).

% tree 83: step size 1.0, 250 examples, 13 leaves
delta(83, sail(_, Location), -0.02074469139990847) :- todo_at(_, Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(83, sail(Location, Location2), 0.13173373998470006) :- todo_at(_, Location2), goal_at(_, Location), !.
delta(83, sail(_, Location), -0.004340336321161852) :- todo_at(_, Location), !.
delta(83, sail(_, Location), -0.014119832367669498) :- at_ferry(Location2), could_board_for_todo_at_any_location(Location2), goal_at(_, Location), !.
delta(83, sail(_, _), 0.03809371503134157) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(83, sail(_, _), -0.1283392407184369) :- !.
delta(83, board(_, Location), -0.03632613340560638) :- goal_at(Car, Location), done_at(Car, Location), todo_at(_, Location), !.
delta(83, board(Car, Location), 0.007104544849900655) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, _), !.
delta(83, board(_, Location), -0.0012001559679793784) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(83, board(_, _), 0.0390431089473656) :- !.
delta(83, debark(Car, Location), 0.0020146038533403513) :- todo_at(Car, Location), !.
delta(83, debark(_, _), -0.004695146192101325) :- !.
delta(83, _, 0.0).

% tree 84: step size 1.0, 238 examples, 13 leaves
delta(84, sail(_, Location), 0.002810314514356387) :- goal_at(Car, Location), done_at(Car, Location2), needed_at_ferry_to_debark(Location2), could_debark_todo_at(Location), !.
delta(84, sail(_, Location), -0.027549442371259045) :- goal_at(Car, Location), done_at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(84, sail(_, Location), -0.024146528681855642) :- goal_at(Car, Location), at(Car, Location2), could_debark_todo_at(Location2), !.
delta(84, sail(_, Location), 0.13864581692643055) :- goal_at(_, Location), !.
delta(84, sail(_, Location), 0.002965199748973002) :- at(Car, Location), todo_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(84, sail(_, Location), -0.080787762579257) :- at(_, Location), !.
delta(84, sail(_, _), 0.019797917699144758) :- at_ferry(Location), could_debark_for_todo_at_any_location(Location), !.
delta(84, sail(_, _), -0.014985209289354423) :- !.
delta(84, board(Car, _), 0.07567974803748935) :- todo_at(Car, Location), at(_, Location), !.
delta(84, board(_, _), -0.10198575240926899) :- !.
delta(84, debark(Car, Location), 0.0020288945959769495) :- todo_at(Car, Location), !.
delta(84, debark(_, _), -0.007835964565165634) :- !.
delta(84, _, 0.0).

% tree 85: step size 1.0, 203 examples, 14 leaves
delta(85, sail(_, Location), -0.036827787548919015) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), at(_, Location2), !.
delta(85, sail(_, Location), -0.0007449094457490432) :- could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(85, sail(_, Location), 0.080801257524493) :- could_board_for_todo_at_any_location(Location), !.
delta(85, sail(_, Location), -0.10572013767219147) :- could_board_needed_on_to_debark(Location), !.
delta(85, sail(Location, Location2), -0.017983470735401578) :- todo_at(Car, Location2), at(Car, Location), !.
delta(85, sail(_, _), 0.044107170901172284) :- !.
delta(85, board(Car, _), 0.06653931210777041) :- todo_at(Car, Location), done_at(_, Location), !.
delta(85, board(_, Location), 0.007307991686679152) :- todo_at(_, Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(85, board(_, Location), -0.03888985402136332) :- todo_at(_, Location), !.
delta(85, board(Car, _), 0.014648018968166364) :- todo_at(Car, _), !.
delta(85, board(_, _), -0.00037617970521862105) :- !.
delta(85, debark(Car, Location), 0.002022583651775738) :- todo_at(Car, Location), !.
delta(85, debark(_, _), -0.007516308280908738) :- !.
delta(85, _, 0.0).

% tree 86: step size 1.0, 268 examples, 14 leaves
delta(86, sail(_, Location), 0.011994325148835581) :- could_board_needed_on_to_debark(Location), todo_at(_, Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(86, sail(_, Location), -0.03428058292512078) :- could_board_needed_on_to_debark(Location), todo_at(_, Location), !.
delta(86, sail(_, Location), 0.07800470729938115) :- could_board_needed_on_to_debark(Location), !.
delta(86, sail(Location, Location2), -0.021966899234944676) :- could_debark_for_todo_at_any_location(Location2), todo_at(_, Location), !.
delta(86, sail(_, Location), 0.04374975561879248) :- could_debark_for_todo_at_any_location(Location), !.
delta(86, sail(_, _), 0.02553175815329685) :- at_ferry(Location), could_debark_for_todo_at_any_location(Location), !.
delta(86, sail(_, _), -0.07455928415460661) :- !.
delta(86, board(Car, Location), 0.010915186855045484) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, _), !.
delta(86, board(_, Location), -0.0003768890771476884) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(86, board(Car, _), 0.0019103623292549125) :- todo_at(Car, Location), done_at(_, Location), !.
delta(86, board(_, _), -0.03638611626214332) :- !.
delta(86, debark(Car, Location), 0.00201283386114188) :- todo_at(Car, Location), !.
delta(86, debark(_, _), -0.006583431705974816) :- !.
delta(86, _, 0.0).

% tree 87: step size 1.0, 246 examples, 14 leaves
delta(87, sail(_, Location), -0.0041621364531661716) :- at(Car, Location), todo_at(Car, Location2), needed_at_ferry_to_debark(Location2), could_board(Location2), !.
delta(87, sail(_, Location), 0.06622359917292764) :- at(Car, Location), todo_at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(87, sail(_, Location), -0.011779556115626453) :- at(Car, Location), todo_at(Car, _), needed_at_ferry_to_debark(Location), !.
delta(87, sail(_, Location), 0.003606947779783607) :- at(Car, Location), todo_at(Car, _), !.
delta(87, sail(Location, Location2), 0.0013610817378710042) :- goal_at(_, Location), could_board(Location2), !.
delta(87, sail(Location, _), -0.051147321811500925) :- goal_at(_, Location), !.
delta(87, sail(_, Location), 0.013821048780727499) :- could_debark_for_todo_at_any_location(Location), !.
delta(87, sail(_, _), -0.011115240974509097) :- !.
delta(87, board(Car, Location), 0.003976987034028984) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(87, board(Car, _), -0.050448841884536806) :- goal_at(Car, Location), at(_, Location), !.
delta(87, board(_, _), 0.04345757518556483) :- !.
delta(87, debark(Car, Location), 0.0020673911949859233) :- todo_at(Car, Location), !.
delta(87, debark(_, _), -0.00892068310694125) :- !.
delta(87, _, 0.0).

% tree 88: step size 1.0, 225 examples, 15 leaves
delta(88, sail(_, Location), -0.005461878464380503) :- goal_at(Car, Location), at(Car, Location2), at_ferry(Location2), could_board(Location), !.
delta(88, sail(_, Location), 0.035869766798909714) :- goal_at(Car, Location), at(Car, Location2), at_ferry(Location2), !.
delta(88, sail(_, Location), 0.001217423437410092) :- goal_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(88, sail(_, Location), -0.0820875009217882) :- goal_at(Car, Location), at(Car, _), !.
delta(88, sail(Location, Location2), -0.028516567061280654) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_board(Location3), !.
delta(88, sail(Location, Location2), 0.004229196204950474) :- todo_at(Car, Location), at(Car, Location2), !.
delta(88, sail(Location, _), -0.00045051365666592697) :- todo_at(Car, Location), on(Car), !.
delta(88, sail(_, _), 0.0584512389844909) :- !.
delta(88, board(Car, Location), -0.006298563700148484) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(88, board(Car, Location), 0.0658810195345105) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(_, Location), !.
delta(88, board(Car, _), -0.0030137652114794614) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(88, board(_, _), -0.039538366145012445) :- !.
delta(88, debark(Car, Location), 0.001973654542821925) :- todo_at(Car, Location), !.
delta(88, debark(_, _), -0.0030056745094953798) :- !.
delta(88, _, 0.0).

% tree 89: step size 1.0, 203 examples, 15 leaves
delta(89, sail(Location, Location2), -0.009150383261583758) :- goal_at(Car, Location2), done_at(Car, Location2), goal_at(Car, Location3), could_board_needed_on_to_debark(Location3), could_board_for_todo_at_any_location(Location), !.
delta(89, sail(_, Location), 0.004146651377419373) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(89, sail(Location, Location2), -0.0010975300306963777) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location), on(Car2), !.
delta(89, sail(_, Location), 0.13038569686544768) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(89, sail(_, Location), -0.025086437878764467) :- could_board(Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(89, sail(_, Location), 0.02365644169029003) :- could_board(Location), !.
delta(89, sail(_, _), 0.0075548605029332186) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(89, sail(_, _), -0.1098386440596871) :- !.
delta(89, board(Car, _), 0.021569066101406676) :- todo_at(Car, Location), at(_, Location), !.
delta(89, board(_, Location), 0.007432725317584414) :- goal_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(89, board(_, Location), -0.05001287437441683) :- goal_at(_, Location), !.
delta(89, board(_, _), 0.007624068954733769) :- !.
delta(89, debark(Car, Location), 0.002265676833416615) :- todo_at(Car, Location), !.
delta(89, debark(_, _), -0.006789658647146614) :- !.
delta(89, _, 0.0).

% tree 90: step size 1.0, 214 examples, 19 leaves
delta(90, sail(Location, Location2), -0.003956846573464119) :- at_ferry(Location3), could_board_for_todo_at_any_location(Location3), todo_at(Car, Location2), at(Car, Location), !.
delta(90, sail(_, Location), 0.05882853475857995) :- at_ferry(Location2), could_board_for_todo_at_any_location(Location2), at(_, Location), !.
delta(90, sail(_, _), -0.0011538432165943667) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(90, sail(_, Location), 0.008537901159692735) :- at(Car, Location), todo_at(Car, _), could_board_for_todo_at_any_location(Location), !.
delta(90, sail(_, Location), -0.0644373260235045) :- at(Car, Location), todo_at(Car, _), !.
delta(90, sail(Location, _), 0.032158903945494165) :- goal_at(Car, Location), at(Car, _), !.
delta(90, sail(_, _), -0.010804487973732754) :- !.
delta(90, board(Car, _), -0.06382229808549612) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(90, board(_, Location), -0.004787917455033434) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(90, board(_, Location), 4.524470317190466e-5) :- todo_at(_, Location), !.
delta(90, board(Car, _), 0.04238463357097171) :- todo_at(Car, _), !.
delta(90, board(_, _), -6.734306276625618e-5) :- !.
delta(90, debark(Car, Location), 0.00031371712861184104) :- at_ferry(Location2), at(Car2, Location2), needed_on_to_debark(Car2), todo_at(Car, Location), !.
delta(90, debark(_, _), -0.0006988044758771565) :- at_ferry(Location), at(Car, Location), needed_on_to_debark(Car), !.
delta(90, debark(_, Location), 0.018291715457776865) :- at_ferry(Location2), at(_, Location2), could_debark_for_todo_at_any_location(Location), !.
delta(90, debark(_, _), -1.0930566774226413e-6) :- at_ferry(Location), at(_, Location), !.
delta(90, debark(Car, Location), 0.0003569374564753396) :- todo_at(Car, Location), !.
delta(90, debark(_, _), -0.0027091505147540653) :- !.
delta(90, _, 0.0).

% tree 91: step size 1.0, 258 examples, 13 leaves
delta(91, sail(_, Location), -0.015700494536544728) :- todo_at(_, Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(91, sail(Location, Location2), -0.005474748300777726) :- todo_at(_, Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(91, sail(_, Location), 0.08854768240626137) :- todo_at(_, Location), !.
delta(91, sail(Location, _), -0.01820599783914319) :- at_ferry(Location2), could_board_needed_on_to_debark(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(91, sail(_, _), 0.04772074675160644) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(91, sail(_, _), 0.0038046370632551186) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(91, sail(_, _), -0.0803700397629914) :- !.
delta(91, board(Car, Location), 0.033526486869440014) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(91, board(_, Location), -0.01573660866841651) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(91, board(_, _), -0.03604152213199206) :- !.
delta(91, debark(Car, Location), 0.0014993673882756817) :- todo_at(Car, Location), !.
delta(91, debark(_, _), -0.001980537989867218) :- !.
delta(91, _, 0.0).

% tree 92: step size 1.0, 212 examples, 14 leaves
delta(92, sail(Location, Location2), 0.004046131996248163) :- todo_at(Car, Location2), at(Car, Location), at(_, Location2), could_board_needed_on_to_debark(Location2), !.
delta(92, sail(Location, Location2), -0.07745227781875147) :- todo_at(Car, Location2), at(Car, Location), at(_, Location2), !.
delta(92, sail(Location, Location2), 0.013150931796021571) :- todo_at(Car, Location2), at(Car, Location), at_ferry(Location3), could_debark_for_todo_at_any_location(Location3), !.
delta(92, sail(Location, Location2), -0.0005493421421362349) :- todo_at(Car, Location2), at(Car, Location), !.
delta(92, sail(Location, Location2), -0.007692434094823081) :- at_ferry(Location3), could_debark(Location3), todo_at(Car, Location), at(Car, Location2), !.
delta(92, sail(_, _), 0.0702929235974593) :- at_ferry(Location), could_debark(Location), !.
delta(92, sail(Location, _), 0.017454692959116343) :- todo_at(_, Location), !.
delta(92, sail(_, _), -0.02154750641276628) :- !.
delta(92, board(Car, Location), -0.03193263991366964) :- todo_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(92, board(Car, _), 0.06878346038013634) :- todo_at(Car, Location), at(_, Location), !.
delta(92, board(_, _), -0.03758211276918753) :- !.
delta(92, debark(Car, Location), 0.002215268822244825) :- todo_at(Car, Location), !.
delta(92, debark(_, _), -0.0014718171145973995) :- !.
delta(92, _, 0.0).

% tree 93: step size 1.0, 201 examples, 13 leaves
delta(93, sail(Location, Location2), -0.006653658755343065) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(93, sail(_, Location), 0.05609950521139248) :- could_board_for_todo_at_any_location(Location), !.
delta(93, sail(Location, Location2), -0.0031530375850396235) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_board_needed_on_to_debark(Location3), !.
delta(93, sail(Location, Location2), 0.035764518022465316) :- todo_at(Car, Location), at(Car, Location2), !.
delta(93, sail(_, Location), -0.08837044379692412) :- at(Car, Location), todo_at(Car, _), !.
delta(93, sail(_, _), 0.006379037031522894) :- !.
delta(93, board(Car, _), 0.037791025462068584) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(93, board(_, _), -0.038114007933324874) :- !.
delta(93, debark(Car, Location), 0.017969891103794385) :- todo_at(Car, Location2), done_at(_, Location2), could_debark_for_todo_at_any_location(Location), !.
delta(93, debark(Car, _), -3.0714881976160485e-5) :- todo_at(Car, Location), done_at(_, Location), !.
delta(93, debark(Car, Location), 0.0010492584999341156) :- todo_at(Car, Location), !.
delta(93, debark(_, _), -0.005982015024008003) :- !.
delta(93, _, 0.0).

% tree 94: step size 1.0, 236 examples, 15 leaves
delta(94, sail(_, Location), 0.0011009516843850605) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_debark_for_todo_at_any_location(Location2), could_debark_todo_at(Location), !.
delta(94, sail(_, Location), -0.03338625651841416) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(94, sail(Location, Location2), -0.0008428031070222801) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location2), at(Car2, Location), !.
delta(94, sail(_, Location), 0.06863075667457749) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(94, sail(Location, Location2), -0.009601439380386515) :- todo_at(Car, Location2), at(Car, Location), at(_, Location2), !.
delta(94, sail(Location, Location2), 0.04459808087313682) :- todo_at(Car, Location2), at(Car, Location), !.
delta(94, sail(Location, _), -0.08172124049075387) :- goal_at(_, Location), !.
delta(94, sail(_, _), 0.0004830049716997569) :- !.
delta(94, board(Car, Location), -0.0024497653260852825) :- todo_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(94, board(Car, _), 0.04424050095135963) :- todo_at(Car, Location), at(_, Location), !.
delta(94, board(_, Location), -0.021364317660847367) :- goal_at(_, Location), !.
delta(94, board(_, _), 0.002378400678379082) :- !.
delta(94, debark(Car, Location), 0.001776548426532423) :- todo_at(Car, Location), !.
delta(94, debark(_, _), -0.0035138968378869936) :- !.
delta(94, _, 0.0).

% tree 95: step size 1.0, 271 examples, 15 leaves
delta(95, sail(_, Location), 0.003674195594058267) :- could_debark_for_todo_at_any_location(Location), at(Car, Location), goal_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(95, sail(_, Location), -0.0944307524514759) :- could_debark_for_todo_at_any_location(Location), at(_, Location), !.
delta(95, sail(Location, Location2), -0.013632549297066731) :- could_debark_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(95, sail(_, Location), 0.04056399649850789) :- could_debark_for_todo_at_any_location(Location), !.
delta(95, sail(Location, _), -0.0002856144215331366) :- at(Car, Location), todo_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(95, sail(Location, _), 0.12257232847118811) :- at(Car, Location), todo_at(Car, _), !.
delta(95, sail(_, Location), 0.02087914556325929) :- at(_, Location), !.
delta(95, sail(_, _), -0.02534317713402046) :- !.
delta(95, board(Car, _), -0.0697982909651505) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(95, board(Car, _), 0.02500815873593221) :- todo_at(Car, Location), done_at(_, Location), !.
delta(95, board(_, Location), -0.010221061710087848) :- goal_at(_, Location), !.
delta(95, board(_, _), 0.00224472989976251) :- !.
delta(95, debark(Car, Location), 0.0019000488569255697) :- todo_at(Car, Location), !.
delta(95, debark(_, _), -0.009134298956574232) :- !.
delta(95, _, 0.0).

% tree 96: step size 1.0, 243 examples, 16 leaves
delta(96, sail(_, Location), 0.009935741608265217) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(96, sail(_, Location), -0.018463282895841943) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(96, sail(Location, Location2), -0.010042638575911141) :- could_board_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(96, sail(_, Location), 0.05441613232863598) :- could_board_for_todo_at_any_location(Location), !.
delta(96, sail(Location, Location2), -0.031204047583923745) :- todo_at(Car, Location), at(Car, Location2), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(96, sail(Location, Location2), 0.045953469509880523) :- todo_at(Car, Location), at(Car, Location2), !.
delta(96, sail(Location, Location2), 0.026535724512709306) :- todo_at(Car, Location2), at(Car, Location), !.
delta(96, sail(_, _), -0.09300235790555934) :- !.
delta(96, board(Car, _), 0.029551678958840914) :- todo_at(Car, Location), at(_, Location), !.
delta(96, board(Car, Location), 0.005043578618797607) :- goal_at(_, Location), todo_at(Car, _), !.
delta(96, board(_, Location), -0.0003106410660077241) :- goal_at(_, Location), !.
delta(96, board(_, _), -0.01701258429126545) :- !.
delta(96, debark(Car, Location), -4.225862340319103e-6) :- todo_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(96, debark(_, Location), 0.017966185848722404) :- todo_at(_, Location), !.
delta(96, debark(_, _), -0.002718254796700717) :- !.
delta(96, _, 0.0).

% tree 97: step size 1.0, 224 examples, 18 leaves
delta(97, sail(Location, Location2), 0.0006725996415861061) :- todo_at(Car, Location2), at(Car, Location3), needed_at_ferry_to_debark(Location3), could_board_for_todo_at_any_location(Location), !.
delta(97, sail(_, Location), -0.018517146281402372) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(97, sail(_, Location), -0.009769325837430846) :- todo_at(_, Location), at_ferry(Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(97, sail(_, Location), 0.12936390125474417) :- todo_at(_, Location), !.
delta(97, sail(Location, Location2), 0.0008286108643671087) :- todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(97, sail(Location, Location2), -0.053181032718933076) :- todo_at(Car, Location), at(Car, Location2), !.
delta(97, sail(Location, _), -0.03692133196970068) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(97, sail(_, _), 0.04760748342550819) :- !.
delta(97, board(Car, Location), 0.004011851508588019) :- todo_at(Car2, Location), at(Car2, Location2), needed_at_ferry_to_debark(Location2), todo_at(Car, Location2), !.
delta(97, board(_, Location), -0.09340658896348002) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(97, board(Car, Location), 0.007147220298968097) :- todo_at(_, Location), todo_at(Car, _), !.
delta(97, board(_, Location), -1.657321570210011e-5) :- todo_at(_, Location), !.
delta(97, board(Car, _), -0.012048758748168404) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(97, board(Car, _), 0.017744379114487313) :- todo_at(Car, _), !.
delta(97, board(_, _), -0.0002613817302720686) :- !.
delta(97, debark(_, Location), 0.018115917592682655) :- todo_at(_, Location), !.
delta(97, debark(_, _), -0.00893182791250889) :- !.
delta(97, _, 0.0).

% tree 98: step size 1.0, 249 examples, 16 leaves
delta(98, sail(Location, Location2), 0.0057038291767284475) :- goal_at(Car, Location2), todo_at(Car2, Location2), at(Car2, Location), done_at(Car, Location2), !.
delta(98, sail(Location, Location2), -0.04571116502103324) :- goal_at(_, Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(98, sail(Location, Location2), -0.0007571923613187446) :- goal_at(_, Location2), todo_at(Car, Location), on(Car), !.
delta(98, sail(_, Location), 0.21122453036266053) :- goal_at(_, Location), !.
delta(98, sail(Location, Location2), -0.006459543423153188) :- at_ferry(Location3), could_debark_for_todo_at_any_location(Location3), todo_at(Car, Location), at(Car, Location2), !.
delta(98, sail(_, _), 0.006475438301020467) :- at_ferry(Location), could_debark_for_todo_at_any_location(Location), !.
delta(98, sail(_, _), -0.18528012867592283) :- !.
delta(98, board(Car, Location), -8.365212541098661e-5) :- todo_at(_, Location), goal_at(Car2, Location), done_at(Car2, Location), goal_at(Car, Location), !.
delta(98, board(_, Location), 0.004186143696894697) :- todo_at(_, Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(98, board(Car, Location), 0.0026768470061880323) :- todo_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(98, board(_, Location), -0.012474074450842433) :- todo_at(_, Location), !.
delta(98, board(Car, _), 0.017784795064192956) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(98, board(_, _), -0.0017857640885457738) :- !.
delta(98, debark(Car, Location), 0.001310753411727814) :- todo_at(Car, Location), !.
delta(98, debark(_, _), -0.006748782998457065) :- !.
delta(98, _, 0.0).

% tree 99: step size 1.0, 256 examples, 13 leaves
delta(99, sail(_, Location), 0.015597107262566554) :- goal_at(Car, Location), at(Car, Location2), could_debark_for_todo_at_any_location(Location2), at_ferry(Location2), !.
delta(99, sail(_, Location), -0.01406537474502119) :- goal_at(Car, Location), at(Car, Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(99, sail(_, Location), 0.0001075967517278692) :- goal_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(99, sail(_, Location), -0.11758077081385847) :- goal_at(Car, Location), at(Car, _), !.
delta(99, sail(Location, _), -0.0004029211255073671) :- todo_at(Car, Location), on(Car), !.
delta(99, sail(_, _), 0.1553057262011056) :- !.
delta(99, board(_, Location), -0.04551725165567196) :- goal_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(99, board(Car, Location), -0.005024684725319546) :- goal_at(_, Location), goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(99, board(_, Location), 0.006133972227289708) :- goal_at(_, Location), !.
delta(99, board(_, _), 0.012431683618461512) :- !.
delta(99, debark(Car, Location), 0.0014356769603935608) :- todo_at(Car, Location), !.
delta(99, debark(_, _), -0.010898723163741419) :- !.
delta(99, _, 0.0).

% tree 100: step size 1.0, 203 examples, 16 leaves
delta(100, sail(Location, Location2), -0.016997429307782128) :- at(Car, Location2), done_at(Car, Location3), could_board_needed_on_to_debark(Location3), could_board_needed_on_to_debark(Location), !.
delta(100, sail(_, Location), 0.0021050531028560466) :- at(Car, Location), done_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(100, sail(_, Location), -0.006987170780988151) :- at(_, Location), at_ferry(Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(100, sail(_, Location), 0.12442769172846187) :- at(_, Location), !.
delta(100, sail(Location, Location2), 0.01940241454996425) :- at_ferry(Location3), could_debark_for_todo_at_any_location(Location3), todo_at(Car, Location2), at(Car, Location), !.
delta(100, sail(_, _), -0.013869724488068697) :- at_ferry(Location), could_debark_for_todo_at_any_location(Location), !.
delta(100, sail(_, Location), 6.950342145734129e-5) :- todo_at(Car, Location), on(Car), !.
delta(100, sail(_, _), -0.04872780404216389) :- !.
delta(100, board(Car, Location), 0.014445622558895279) :- goal_at(Car, Location2), at(Car2, Location2), goal_at(Car2, Location2), could_board_for_todo_at_any_location(Location), !.
delta(100, board(Car, _), -0.012417022823187109) :- goal_at(Car, Location), at(Car2, Location), goal_at(Car2, Location), !.
delta(100, board(Car, Location), 0.00037362200082808814) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(100, board(Car, _), -0.10929607112301662) :- goal_at(Car, Location), at(_, Location), !.
delta(100, board(_, _), 0.033362543689222396) :- !.
delta(100, debark(Car, Location), 0.001561919035053369) :- todo_at(Car, Location), !.
delta(100, debark(_, _), -0.005435316119980679) :- !.
delta(100, _, 0.0).

% tree 101: step size 1.0, 273 examples, 15 leaves
delta(101, sail(_, Location), -0.001566072842872477) :- goal_at(Car, Location), done_at(Car, Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(101, sail(Location, Location2), -0.001097683224676334) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location), on(Car2), !.
delta(101, sail(_, Location), 0.07964559915329127) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(101, sail(_, Location), -0.0005583779072998912) :- could_board(Location), todo_at(_, Location), !.
delta(101, sail(_, Location), 0.037089006890137444) :- could_board(Location), !.
delta(101, sail(_, Location), 0.00066918585982114) :- todo_at(Car, Location), on(Car), !.
delta(101, sail(_, _), -0.07699783264521778) :- !.
delta(101, board(Car, Location), -0.0077179404484164875) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(_, Location), !.
delta(101, board(Car, _), 0.016042263720704757) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(101, board(Car, Location), 0.0011140582229103736) :- todo_at(_, Location), todo_at(Car, _), !.
delta(101, board(_, Location), -0.0005860309287958286) :- todo_at(_, Location), !.
delta(101, board(_, _), -0.037842183988600044) :- !.
delta(101, debark(Car, Location), 0.0014858314930199276) :- todo_at(Car, Location), !.
delta(101, debark(_, _), -0.0074842799626765365) :- !.
delta(101, _, 0.0).

% tree 102: step size 1.0, 234 examples, 15 leaves
delta(102, sail(Location, Location2), 0.0198892107729085) :- todo_at(Car, Location2), at(Car, Location3), could_board_for_todo_at_any_location(Location3), could_board(Location), !.
delta(102, sail(_, Location), -0.01867380936853423) :- todo_at(Car, Location), at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(102, sail(_, Location), 0.0013779930851856388) :- todo_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(102, sail(_, Location), -0.058301653373795434) :- todo_at(Car, Location), at(Car, _), !.
delta(102, sail(_, Location), -0.008581280301169307) :- at(_, Location), at_ferry(Location2), could_board(Location2), !.
delta(102, sail(_, Location), 0.08248298035410576) :- at(_, Location), !.
delta(102, sail(Location, _), 0.0045002128340652725) :- at(Car, Location), todo_at(Car, _), !.
delta(102, sail(_, _), -0.031912537756024296) :- !.
delta(102, board(Car, Location), 0.018596667686000164) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(102, board(Car, _), 0.015497476682447879) :- goal_at(Car, Location), at(Car2, Location), goal_at(Car2, Location), !.
delta(102, board(Car, _), -0.04339078195115769) :- goal_at(Car, Location), at(_, Location), !.
delta(102, board(_, _), 0.02452831980149044) :- !.
delta(102, debark(Car, Location), 0.00140229041853741) :- todo_at(Car, Location), !.
delta(102, debark(_, _), -0.004971709209867252) :- !.
delta(102, _, 0.0).

% tree 103: step size 1.0, 224 examples, 16 leaves
delta(103, sail(Location, Location2), -0.0272424184696795) :- at(Car, Location2), todo_at(Car, Location3), could_board_needed_on_to_debark(Location), needed_at_ferry_to_debark(Location3), !.
delta(103, sail(Location, Location2), 0.0006255892825870927) :- at(Car, Location2), todo_at(Car, _), could_board_needed_on_to_debark(Location), !.
delta(103, sail(_, Location), 0.05120827699035056) :- at(Car, Location), todo_at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(103, sail(_, Location), -0.006488215907284334) :- at(Car, Location), todo_at(Car, _), !.
delta(103, sail(_, Location), 0.0037138238377349237) :- goal_at(Car, Location), at(Car, Location2), could_debark_todo_at(Location2), !.
delta(103, sail(_, Location), -0.062345769397373775) :- goal_at(Car, Location), at(Car, _), !.
delta(103, sail(Location, _), 0.013313858852730714) :- at(Car, Location), todo_at(Car, _), !.
delta(103, sail(_, _), -0.01033567255887213) :- !.
delta(103, board(Car, _), 0.04423419231337205) :- todo_at(Car, Location), at(_, Location), !.
delta(103, board(_, Location), 0.008642533047767464) :- goal_at(Car, Location), done_at(Car, Location), todo_at(_, Location), !.
delta(103, board(_, Location), -0.004294054950577059) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(103, board(_, Location), -0.01573012200126055) :- todo_at(_, Location), !.
delta(103, board(_, _), -3.896609870427371e-5) :- !.
delta(103, debark(Car, Location), 0.0012737835105246767) :- todo_at(Car, Location), !.
delta(103, debark(_, _), -0.0029629247248145556) :- !.
delta(103, _, 0.0).

% tree 104: step size 1.0, 209 examples, 14 leaves
delta(104, sail(Location, Location2), -0.0009278045993296205) :- goal_at(Car, Location2), done_at(Car, Location2), at_ferry(Location3), could_debark_for_todo_at_any_location(Location3), could_debark_todo_at(Location), !.
delta(104, sail(_, Location), 0.006055991926966152) :- goal_at(Car, Location), done_at(Car, Location), at_ferry(Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(104, sail(Location, Location2), 0.0024124624275063187) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(104, sail(_, Location), -0.05918457200945137) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(104, sail(_, Location), -0.034537460967475085) :- could_board_for_todo_at_any_location(Location), !.
delta(104, sail(Location, Location2), -0.014067205891200857) :- todo_at(Car, Location2), at(Car, Location), !.
delta(104, sail(_, _), 0.0908163788279586) :- !.
delta(104, board(Car, Location), 0.03256418010510329) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, _), !.
delta(104, board(_, Location), -0.0003799518802208383) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(104, board(Car, Location), -0.06182217395482105) :- todo_at(_, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(104, board(_, Location), 0.008435398020019254) :- todo_at(_, Location), !.
delta(104, board(_, _), 0.013919121142680657) :- !.
delta(104, debark(_, _), 0.0013710469459402097) :- !.
delta(104, _, 0.0).

% tree 105: step size 1.0, 204 examples, 14 leaves
delta(105, sail(_, Location), -0.020103130003327134) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), empty_ferry, !.
delta(105, sail(_, Location), 0.025827669566592645) :- todo_at(Car, Location), at(Car, Location2), needed_at_ferry_to_debark(Location2), !.
delta(105, sail(_, Location), 0.00043876606641687443) :- todo_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(105, sail(_, Location), -0.055530080830715776) :- todo_at(Car, Location), at(Car, _), !.
delta(105, sail(Location, Location2), 0.015890060182148363) :- at_ferry(Location3), could_board_needed_on_to_debark(Location3), todo_at(Car, Location), at(Car, Location2), !.
delta(105, sail(_, _), -0.022210677662241586) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(105, sail(Location, Location2), -0.009328204427304565) :- todo_at(Car, Location), at(Car, Location2), !.
delta(105, sail(_, _), 0.03295177181597999) :- !.
delta(105, board(Car, Location), 0.007434580085972029) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(105, board(Car, _), 0.0041842973955967065) :- goal_at(Car, Location), at(Car2, Location), goal_at(Car2, Location), !.
delta(105, board(Car, _), -0.01956396751862366) :- goal_at(Car, Location), at(_, Location), !.
delta(105, board(_, _), 0.039563965752715896) :- !.
delta(105, debark(_, _), 0.0016388827070805416) :- !.
delta(105, _, 0.0).

% tree 106: step size 1.0, 216 examples, 15 leaves
delta(106, sail(Location, Location2), -0.0006650970994031337) :- todo_at(Car, Location), at(Car, Location2), at(Car, Location3), could_board_for_todo_at_any_location(Location3), could_board_needed_on_to_debark(Location), !.
delta(106, sail(Location, Location2), 0.07497450178820436) :- todo_at(Car, Location), at(Car, Location2), at(Car, Location3), could_board_for_todo_at_any_location(Location3), !.
delta(106, sail(Location, Location2), 0.01657537719213092) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_board(Location3), !.
delta(106, sail(Location, Location2), -0.03611281195701314) :- todo_at(Car, Location), at(Car, Location2), !.
delta(106, sail(_, Location), 0.01052745533991966) :- at(Car, Location), todo_at(Car, Location2), could_debark(Location2), !.
delta(106, sail(_, Location), -0.12132481886983727) :- at(_, Location), !.
delta(106, sail(_, Location), 0.05569721796812206) :- todo_at(_, Location), !.
delta(106, sail(_, _), -0.007503628010217072) :- !.
delta(106, board(Car, _), 0.05490154935256647) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(106, board(_, Location), 0.002628140497670914) :- goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(106, board(_, Location), -0.022243484898344063) :- goal_at(_, Location), !.
delta(106, board(_, _), 0.008331253513963995) :- !.
delta(106, debark(Car, Location), 0.001334898939843641) :- todo_at(Car, Location), !.
delta(106, debark(_, _), -0.0024445716171304296) :- !.
delta(106, _, 0.0).

% tree 107: step size 1.0, 246 examples, 17 leaves
delta(107, sail(Location, Location2), -2.3988255356314833e-5) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location), at(Car2, Location2), could_debark_todo_at(Location), !.
delta(107, sail(Location, Location2), 0.0015817798308604182) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(107, sail(_, Location), 0.0005201762034060612) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location), on(Car2), !.
delta(107, sail(_, Location), -0.09337486562900033) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(107, sail(Location, Location2), 0.013529749121495505) :- could_board_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(107, sail(_, Location), -0.03650652692742942) :- could_board_for_todo_at_any_location(Location), !.
delta(107, sail(Location, Location2), -0.0017932047358089232) :- todo_at(Car, Location), at(Car, Location2), !.
delta(107, sail(_, _), 0.09127915908638909) :- !.
delta(107, board(Car, Location), -0.00734644656571251) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(107, board(Car, _), 0.04789435691055991) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(107, board(Car, Location), 0.002353429576374168) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location2), could_board(Location2), !.
delta(107, board(_, Location), -0.02976997694576881) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(107, board(Car, _), -0.003959621267551181) :- todo_at(Car, Location), done_at(_, Location), !.
delta(107, board(_, _), 0.004430009743468077) :- !.
delta(107, debark(Car, Location), 0.0007510927885892847) :- todo_at(Car, Location), !.
delta(107, debark(_, _), -0.002769792513512929) :- !.
delta(107, _, 0.0).

% tree 108: step size 1.0, 226 examples, 12 leaves
delta(108, sail(Location, Location2), -0.00037352008735201165) :- could_board_for_todo_at_any_location(Location2), goal_at(Car, Location2), done_at(Car, Location2), todo_at(_, Location), !.
delta(108, sail(_, Location), 0.03873493840979515) :- could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(108, sail(_, Location), 0.0006007779488860224) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(108, sail(_, Location), -0.05274353149495139) :- could_board_for_todo_at_any_location(Location), !.
delta(108, sail(Location, Location2), -0.007341850817895816) :- could_board(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(108, sail(_, Location), 0.08149511507488799) :- could_board(Location), !.
delta(108, sail(_, Location), 0.03985567371072455) :- goal_at(_, Location), !.
delta(108, sail(_, _), -0.05264595081476885) :- !.
delta(108, board(_, _), -0.049369579917080166) :- !.
delta(108, debark(Car, Location), 0.0008105207074612908) :- todo_at(Car, Location), !.
delta(108, debark(_, _), -0.0017619033220046428) :- !.
delta(108, _, 0.0).

% tree 109: step size 1.0, 225 examples, 15 leaves
delta(109, sail(Location, Location2), 0.056400428131885366) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(109, sail(Location, Location2), -0.006407265710345724) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(109, sail(_, Location), -0.09154161573282547) :- could_board_for_todo_at_any_location(Location), !.
delta(109, sail(Location, _), -0.0010167097548178046) :- goal_at(Car, Location), at(Car, Location2), could_debark_todo_at(Location2), !.
delta(109, sail(Location, _), 0.0708300236847028) :- goal_at(Car, Location), at(Car, _), !.
delta(109, sail(_, Location), 0.04050520725922457) :- goal_at(_, Location), !.
delta(109, sail(_, _), -0.04811528541612034) :- !.
delta(109, board(Car, Location), -0.003939938627011652) :- todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(109, board(Car, _), 0.03347723822382483) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(109, board(_, Location), -0.05802608048470987) :- todo_at(_, Location), !.
delta(109, board(_, Location), 0.0022904066113445774) :- goal_at(_, Location), !.
delta(109, board(_, _), -0.0017708918273420576) :- !.
delta(109, debark(Car, Location), 0.0018421746749805736) :- todo_at(Car, Location), !.
delta(109, debark(_, _), -0.003982683108276747) :- !.
delta(109, _, 0.0).

% tree 110: step size 1.0, 240 examples, 16 leaves
delta(110, sail(Location, Location2), -0.00887019108307213) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location), at(Car2, Location2), !.
delta(110, sail(Location, Location2), 0.049137760327707974) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car, Location3), could_debark(Location3), !.
delta(110, sail(Location, Location2), -0.006310456813237457) :- todo_at(Car, Location2), at(Car, Location), !.
delta(110, sail(Location, Location2), -8.842404352891714e-5) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location), on(Car2), !.
delta(110, sail(Location, Location2), 0.042359381161800144) :- todo_at(Car, Location), at(Car, Location2), !.
delta(110, sail(_, Location), -0.07343829319047704) :- todo_at(Car, Location), at(Car, _), !.
delta(110, sail(_, _), 0.0009861199982558401) :- !.
delta(110, board(Car, Location), -0.01560358915500045) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(_, Location), !.
delta(110, board(Car, _), -0.011601966604790022) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(110, board(Car, _), 0.013942665030293865) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(110, board(_, Location), -0.006697817786201616) :- goal_at(Car, Location), done_at(Car, Location), todo_at(_, Location), !.
delta(110, board(_, Location), 0.004680494525441261) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(110, board(_, _), 0.01998378454721072) :- !.
delta(110, debark(Car, Location), 0.0014907820286356873) :- todo_at(Car, Location), !.
delta(110, debark(_, _), -0.009372944841687261) :- !.
delta(110, _, 0.0).

% tree 111: step size 1.0, 254 examples, 17 leaves
delta(111, sail(Location, Location2), -0.00013591092305804695) :- at(Car, Location2), goal_at(Car, Location3), could_debark_todo_at(Location3), todo_at(Car, Location), !.
delta(111, sail(_, Location), 0.03232836592378224) :- at(Car, Location), goal_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(111, sail(_, Location), 0.027234710158429855) :- at(Car, Location), todo_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(111, sail(_, Location), -0.08032913105176658) :- at(_, Location), !.
delta(111, sail(Location, _), -0.00021688320648234778) :- at_ferry(Location2), could_debark(Location2), todo_at(Car, Location), on(Car), !.
delta(111, sail(_, _), 0.030169136087334552) :- at_ferry(Location), could_debark(Location), !.
delta(111, sail(Location, _), 0.0031014643673282446) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(111, sail(_, _), -0.006887081766358244) :- !.
delta(111, board(Car, Location), 0.00505418059889128) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(111, board(Car, Location), -0.04700571050651988) :- goal_at(Car, Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(111, board(Car, _), -0.00046694109166687213) :- goal_at(Car, Location), at(_, Location), !.
delta(111, board(_, Location), -0.014544096100675741) :- goal_at(Car, Location), done_at(Car, Location), todo_at(_, Location), !.
delta(111, board(_, Location), 0.001265570812498276) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(111, board(_, _), 0.06258047641913733) :- !.
delta(111, debark(Car, Location), 0.0011741385769244341) :- todo_at(Car, Location), !.
delta(111, debark(_, _), -0.0024364093790678267) :- !.
delta(111, _, 0.0).

% tree 112: step size 1.0, 257 examples, 13 leaves
delta(112, sail(Location, Location2), -0.007231098937973871) :- todo_at(_, Location2), at(Car, Location2), needed_on_to_debark(Car), todo_at(Car, Location), !.
delta(112, sail(_, Location), 0.126479208615792) :- todo_at(_, Location), at(Car, Location), needed_on_to_debark(Car), !.
delta(112, sail(Location, Location2), -0.059456486110923745) :- todo_at(_, Location2), at(Car, Location), needed_on_to_debark(Car), !.
delta(112, sail(_, Location), 0.005359744510755422) :- todo_at(_, Location), !.
delta(112, sail(_, Location), 0.012892964043173083) :- at(Car, Location), done_at(Car, Location2), could_board_needed_on_to_debark(Location2), !.
delta(112, sail(_, Location), -0.10549939313053738) :- at(_, Location), !.
delta(112, sail(Location, _), 0.04273523192586175) :- todo_at(Car, Location), at(Car, _), !.
delta(112, sail(_, _), -0.01196413568462411) :- !.
delta(112, board(Car, _), -0.07691846279304217) :- goal_at(Car, Location), at(_, Location), !.
delta(112, board(_, _), 0.07727442501553036) :- !.
delta(112, debark(Car, Location), 0.0012373284293575064) :- todo_at(Car, Location), !.
delta(112, debark(_, _), -0.00025308967717160743) :- !.
delta(112, _, 0.0).

% tree 113: step size 1.0, 225 examples, 13 leaves
delta(113, sail(Location, Location2), -0.0013379972077888454) :- at(Car, Location2), at(Car2, Location), needed_on_to_debark(Car2), goal_at(Car, Location2), !.
delta(113, sail(Location, Location2), -0.08910827689654044) :- at(_, Location2), at(Car, Location), needed_on_to_debark(Car), !.
delta(113, sail(_, Location), -0.0020325743421727538) :- at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(113, sail(_, Location), 0.017514861780879857) :- at(_, Location), !.
delta(113, sail(Location, _), -0.001882819267581302) :- at(Car, Location), todo_at(Car, _), empty_ferry, !.
delta(113, sail(Location, _), 0.06100814581012471) :- at(Car, Location), todo_at(Car, _), !.
delta(113, sail(_, Location), -0.0166723121666357) :- todo_at(Car, Location), at(Car, _), !.
delta(113, sail(_, _), 5.754979829878661e-5) :- !.
delta(113, board(Car, Location), -0.01733183478849251) :- todo_at(Car, Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(113, board(Car, _), 0.05180723566973378) :- todo_at(Car, _), !.
delta(113, board(_, _), -0.0008218973431792545) :- !.
delta(113, debark(_, _), 0.0011351642127423987) :- !.
delta(113, _, 0.0).

% tree 114: step size 1.0, 201 examples, 14 leaves
delta(114, sail(_, _), -0.02740117120098771) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(114, sail(_, Location), 0.001264827455370197) :- at_ferry(Location2), could_board_for_todo_at_any_location(Location2), at(Car, Location), needed_on_to_debark(Car), !.
delta(114, sail(_, _), -0.0012223678128236721) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(114, sail(Location, Location2), 0.00698206942906189) :- todo_at(Car, Location2), at(Car, Location), goal_at(Car2, Location2), done_at(Car2, Location2), !.
delta(114, sail(Location, Location2), -0.020674443399719734) :- todo_at(Car, Location2), at(Car, Location), !.
delta(114, sail(_, Location), 0.026637709149695876) :- could_board_needed_on_to_debark(Location), !.
delta(114, sail(_, _), -0.0053047881400548015) :- !.
delta(114, board(Car, Location), 0.0069570880347317185) :- goal_at(Car, Location2), done_at(_, Location2), could_board_for_todo_at_any_location(Location), todo_at(Car, Location2), !.
delta(114, board(Car, Location), -5.358707410030435e-5) :- goal_at(Car, Location2), done_at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(114, board(Car, _), -0.01552966975179792) :- goal_at(Car, Location), done_at(_, Location), !.
delta(114, board(_, _), 0.030559911818279446) :- !.
delta(114, debark(Car, Location), 0.0011925621974523278) :- todo_at(Car, Location), !.
delta(114, debark(_, _), -0.004886238615103143) :- !.
delta(114, _, 0.0).

% tree 115: step size 1.0, 213 examples, 11 leaves
delta(115, sail(_, Location), 0.06323476950926929) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), at(_, Location2), !.
delta(115, sail(_, Location), -0.004726970583279739) :- could_board_for_todo_at_any_location(Location), !.
delta(115, sail(Location, Location2), 0.0012703279882039368) :- at_ferry(Location3), could_board(Location3), todo_at(Car, Location), at(Car, Location2), !.
delta(115, sail(_, _), -0.07631717718735478) :- at_ferry(Location), could_board(Location), !.
delta(115, sail(_, Location), 0.035780209718375616) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(115, sail(_, _), -0.029942968260215454) :- !.
delta(115, board(Car, Location), 0.02871013720284261) :- goal_at(_, Location), todo_at(Car, _), !.
delta(115, board(_, Location), -0.000875095829670899) :- goal_at(_, Location), !.
delta(115, board(_, _), -0.01719065254060293) :- !.
delta(115, debark(_, _), 0.0009964713624916618) :- !.
delta(115, _, 0.0).

% tree 116: step size 1.0, 236 examples, 16 leaves
delta(116, sail(Location, Location2), 0.030138435036592526) :- goal_at(Car, Location2), done_at(Car, Location2), goal_at(Car, Location3), could_board_for_todo_at_any_location(Location3), could_board_needed_on_to_debark(Location), !.
delta(116, sail(_, Location), -0.002172325559002027) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(116, sail(Location, Location2), 0.010729805083455215) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location2), at(Car2, Location), !.
delta(116, sail(_, Location), -0.06474127986646978) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(116, sail(_, Location), -0.027643878034403338) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(116, sail(_, Location), 0.013788402603614844) :- could_board_for_todo_at_any_location(Location), !.
delta(116, sail(_, _), 0.09065144926081964) :- at_ferry(Location), at(_, Location), !.
delta(116, sail(_, _), -0.009197518524685496) :- !.
delta(116, board(Car, Location), 0.0008979717879358887) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location2), !.
delta(116, board(Car, Location), -2.8748504300346304e-5) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(116, board(Car, _), -0.0670970884041357) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(116, board(Car, _), 0.02319953521416708) :- todo_at(Car, _), !.
delta(116, board(_, _), -0.0006768803697790006) :- !.
delta(116, debark(Car, Location), 0.0010579042610235696) :- todo_at(Car, Location), !.
delta(116, debark(_, _), -0.008703956236347142) :- !.
delta(116, _, 0.0).

% tree 117: step size 1.0, 234 examples, 17 leaves
delta(117, sail(Location, Location2), 0.0001138333516734496) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location2), on(Car2), !.
delta(117, sail(Location, Location2), -0.04679358549012007) :- todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(117, sail(Location, Location2), -5.893311568780883e-5) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location), on(Car2), !.
delta(117, sail(Location, Location2), 0.008219204385701768) :- todo_at(Car, Location), at(Car, Location2), !.
delta(117, sail(_, Location), 0.046593804530715086) :- could_board(Location), todo_at(_, Location), !.
delta(117, sail(_, Location), -0.06807044106210944) :- could_board(Location), !.
delta(117, sail(Location, Location2), -0.006930469286225797) :- todo_at(Car, Location2), at(Car, Location), !.
delta(117, sail(_, _), 0.07226243365059878) :- !.
delta(117, board(Car, Location), 0.0112744994359289) :- todo_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(117, board(_, Location), 0.0015149685257317604) :- todo_at(_, Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(117, board(_, Location), -0.025506818302456893) :- todo_at(_, Location), !.
delta(117, board(Car, _), 0.017348988205237757) :- todo_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(117, board(_, Location), 0.000627620314381887) :- goal_at(_, Location), !.
delta(117, board(_, _), -0.008380347520777038) :- !.
delta(117, debark(Car, Location), 0.0008553254185848677) :- todo_at(Car, Location), !.
delta(117, debark(_, _), -0.006576440809513731) :- !.
delta(117, _, 0.0).

% tree 118: step size 1.0, 217 examples, 15 leaves
delta(118, sail(Location, Location2), 0.013580699323901138) :- goal_at(Car, Location2), at(Car, Location3), could_board_for_todo_at_any_location(Location3), could_board(Location), !.
delta(118, sail(_, Location), -0.025198134786066584) :- goal_at(Car, Location), at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(118, sail(_, Location), -0.006418814858743211) :- goal_at(Car, Location), at(Car, Location2), could_debark_todo_at(Location2), !.
delta(118, sail(_, Location), 0.061549855243185195) :- goal_at(_, Location), !.
delta(118, sail(_, Location), -0.002840250768485153) :- at_ferry(Location2), could_board_needed_on_to_debark(Location2), at(_, Location), !.
delta(118, sail(_, _), 0.014580754787449924) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(118, sail(_, _), -0.04577256385450273) :- at_ferry(Location), at(_, Location), !.
delta(118, sail(_, _), -0.00020842042838978004) :- !.
delta(118, board(Car, Location), 0.02020133442107558) :- todo_at(Car, Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(118, board(Car, _), 0.0014978731274278684) :- todo_at(Car, Location), at(Car2, Location), goal_at(Car2, Location), !.
delta(118, board(Car, _), -0.010629401498307484) :- todo_at(Car, Location), at(_, Location), !.
delta(118, board(_, _), -0.023331576181649185) :- !.
delta(118, debark(Car, Location), 0.0008052382378151276) :- todo_at(Car, Location), !.
delta(118, debark(_, _), -0.0025612732241692047) :- !.
delta(118, _, 0.0).

% tree 119: step size 1.0, 226 examples, 13 leaves
delta(119, sail(Location, Location2), -0.006352291675973957) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(119, sail(Location, Location2), -0.004043343294557248) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(119, sail(_, Location), 0.033665288277763605) :- could_board_for_todo_at_any_location(Location), !.
delta(119, sail(Location, Location2), 0.031462962054522495) :- todo_at(Car, Location), at(Car, Location2), at(_, Location), !.
delta(119, sail(Location, Location2), -0.00252592911557125) :- todo_at(Car, Location), at(Car, Location2), !.
delta(119, sail(Location, _), -0.08286991273199353) :- at(Car, Location), todo_at(Car, _), !.
delta(119, sail(_, _), 0.0006095582354677191) :- !.
delta(119, board(Car, _), 0.028789063464897617) :- todo_at(Car, _), !.
delta(119, board(_, _), -0.001224296917863314) :- !.
delta(119, debark(Car, Location), 0.0004725946852043602) :- todo_at(Car2, Location), at(Car2, _), todo_at(Car, Location), !.
delta(119, debark(_, Location), -0.0011431902346686828) :- todo_at(Car, Location), at(Car, _), !.
delta(119, debark(_, _), 0.012095852980627382) :- !.
delta(119, _, 0.0).

% tree 120: step size 1.0, 277 examples, 17 leaves
delta(120, sail(_, Location), -0.0412808233076747) :- at(Car, Location), todo_at(Car, Location2), could_board_for_todo_at_any_location(Location), could_board_needed_on_to_debark(Location2), !.
delta(120, sail(_, Location), 0.010238678231035574) :- at(Car, Location), todo_at(Car, _), could_board_for_todo_at_any_location(Location), !.
delta(120, sail(Location, Location2), -0.0005987975881765184) :- at(Car, Location2), todo_at(Car, _), could_debark_todo_at(Location), !.
delta(120, sail(_, Location), 0.05650514207316406) :- at(Car, Location), todo_at(Car, _), !.
delta(120, sail(Location, _), 0.018908419078131674) :- at_ferry(Location2), could_board_needed_on_to_debark(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(120, sail(_, _), -0.0015366128135595328) :- at_ferry(Location), could_board_needed_on_to_debark(Location), !.
delta(120, sail(_, Location), 0.010358365128634087) :- could_board_for_todo_at_any_location(Location), !.
delta(120, sail(_, _), -0.05167966271798393) :- !.
delta(120, board(Car, _), 0.010157434154414295) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location), !.
delta(120, board(Car, _), -0.00029814029308363317) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(120, board(Car, Location), -0.050860891641054964) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(_, Location), !.
delta(120, board(Car, _), 0.001345817436466944) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(120, board(Car, _), 0.03433482500414621) :- todo_at(Car, _), !.
delta(120, board(_, _), -0.00010668843587076466) :- !.
delta(120, debark(Car, Location), 0.00125538227965404) :- todo_at(Car, Location), !.
delta(120, debark(_, _), -0.0003133774558588868) :- !.
delta(120, _, 0.0).

% tree 121: step size 1.0, 227 examples, 16 leaves
delta(121, sail(Location, Location2), -0.01157591913963691) :- could_debark_for_todo_at_any_location(Location2), todo_at(Car, Location2), at(Car, Location), at(_, Location2), !.
delta(121, sail(Location, Location2), 0.00032056921372423545) :- could_debark_for_todo_at_any_location(Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(121, sail(Location, Location2), 0.019719666731242463) :- could_debark_for_todo_at_any_location(Location2), goal_at(Car, Location), at(Car, _), !.
delta(121, sail(_, Location), -0.00020497227068148424) :- could_debark_for_todo_at_any_location(Location), !.
delta(121, sail(_, _), -0.03836307599382821) :- at_ferry(Location), at(_, Location), !.
delta(121, sail(Location, Location2), -0.022537174730103374) :- todo_at(Car, Location), at(Car, Location2), !.
delta(121, sail(_, _), 0.019783361144839716) :- !.
delta(121, board(Car, _), 0.011346047896801542) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location), !.
delta(121, board(Car, _), -0.00011566204158725356) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(121, board(Car, Location), 0.003009455227994542) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(121, board(Car, _), -0.019428553936770468) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(121, board(Car, _), 0.03981785518330589) :- todo_at(Car, _), !.
delta(121, board(_, _), -0.0008642728569772858) :- !.
delta(121, debark(Car, Location), 0.0009254555152876988) :- todo_at(Car, Location), !.
delta(121, debark(_, _), -0.00023770669593411396) :- !.
delta(121, _, 0.0).

% tree 122: step size 1.0, 250 examples, 13 leaves
delta(122, sail(Location, Location2), -0.001199645627778536) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location), at(Car2, Location2), !.
delta(122, sail(Location, Location2), 0.012266574496836269) :- could_board_for_todo_at_any_location(Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(122, sail(_, Location), -0.03939670996998665) :- could_board_for_todo_at_any_location(Location), !.
delta(122, sail(Location, Location2), -0.0004703982793100535) :- could_board(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(122, sail(_, Location), 0.08169815832829641) :- could_board(Location), !.
delta(122, sail(_, Location), 0.03680349429546793) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(122, sail(_, _), -0.044710482069349994) :- !.
delta(122, board(_, Location), -0.05103551921685821) :- todo_at(_, Location), !.
delta(122, board(Car, _), 0.007702186598482378) :- todo_at(Car, _), !.
delta(122, board(_, _), -0.0008715412167197202) :- !.
delta(122, debark(Car, Location), 0.0014072995342725423) :- todo_at(Car, Location), !.
delta(122, debark(_, _), -0.0006910091480075724) :- !.
delta(122, _, 0.0).

% tree 123: step size 1.0, 211 examples, 12 leaves
delta(123, sail(Location, Location2), -0.00038468227527911056) :- todo_at(_, Location2), todo_at(Car, Location), on(Car), !.
delta(123, sail(_, Location), 0.07443207438145967) :- todo_at(_, Location), !.
delta(123, sail(_, Location), -0.09910804728317764) :- at(Car, Location), todo_at(Car, _), !.
delta(123, sail(_, Location), -0.007912050454778831) :- could_board(Location), !.
delta(123, sail(_, _), 0.031204176391550698) :- !.
delta(123, board(Car, Location), -0.029124907668495497) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(_, Location), !.
delta(123, board(Car, _), 0.003025167718544577) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(123, board(Car, _), 0.033907483350947364) :- todo_at(Car, _), !.
delta(123, board(_, _), -0.00017943747133529022) :- !.
delta(123, debark(Car, Location), 0.0010582692280050772) :- todo_at(Car, Location), !.
delta(123, debark(_, _), -0.005278626017728522) :- !.
delta(123, _, 0.0).

% tree 124: step size 1.0, 224 examples, 12 leaves
delta(124, sail(Location, Location2), 0.008085750728164486) :- at(_, Location2), at(Car, Location), needed_on_to_debark(Car), could_board_for_todo_at_any_location(Location2), !.
delta(124, sail(Location, Location2), -0.07743890033382636) :- at(_, Location2), at(Car, Location), needed_on_to_debark(Car), !.
delta(124, sail(_, Location), -0.02578666067811112) :- at(_, Location), goal_at(_, Location), !.
delta(124, sail(_, Location), 0.025735972787110532) :- at(_, Location), !.
delta(124, sail(Location, _), -0.00028672102676334353) :- at_ferry(Location2), could_debark(Location2), todo_at(Car, Location), on(Car), !.
delta(124, sail(_, _), 0.03653062061282125) :- at_ferry(Location), could_debark(Location), !.
delta(124, sail(_, _), -0.011657694355734159) :- !.
delta(124, board(Car, _), 0.04884834717682334) :- todo_at(Car, _), !.
delta(124, board(_, _), -0.00016142231489993289) :- !.
delta(124, debark(Car, Location), 0.0012464555960176264) :- todo_at(Car, Location), !.
delta(124, debark(_, _), -0.0004292770880084376) :- !.
delta(124, _, 0.0).

% tree 125: step size 1.0, 257 examples, 12 leaves
delta(125, sail(Location, Location2), -0.0009166751177317324) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location), at(Car2, Location2), empty_ferry, !.
delta(125, sail(Location, Location2), 0.003935053179800562) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location), at(Car2, Location2), !.
delta(125, sail(Location, Location2), 0.00024405609469437084) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location2), on(Car2), !.
delta(125, sail(Location, Location2), -0.04697139632191883) :- todo_at(Car, Location2), at(Car, Location), !.
delta(125, sail(_, Location), 0.024973361040351506) :- goal_at(Car, Location), done_at(Car, Location), at_ferry(Location2), could_board_needed_on_to_debark(Location2), !.
delta(125, sail(_, Location), -0.033325617224414295) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(125, sail(Location, _), -0.000543566843336022) :- todo_at(Car, Location), on(Car), !.
delta(125, sail(_, _), 0.11154066195978878) :- !.
delta(125, board(_, _), -0.07432126717414926) :- !.
delta(125, debark(Car, Location), 0.0010502217065154478) :- todo_at(Car, Location), !.
delta(125, debark(_, _), -0.004735305744455037) :- !.
delta(125, _, 0.0).

% tree 126: step size 1.0, 243 examples, 15 leaves
delta(126, sail(_, Location), -0.0009843610396789123) :- todo_at(Car, Location), at(Car, Location2), could_debark_for_todo_at_any_location(Location2), could_debark_todo_at(Location2), !.
delta(126, sail(_, Location), 0.011223538048697199) :- todo_at(Car, Location), at(Car, Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(126, sail(_, Location), 0.00018325758039582202) :- todo_at(Car, Location), at(Car, _), could_debark_todo_at(Location), !.
delta(126, sail(_, Location), -0.10885804449156825) :- todo_at(Car, Location), at(Car, _), !.
delta(126, sail(Location, Location2), 0.016606888351245828) :- todo_at(_, Location), todo_at(Car, Location), at(Car, Location2), !.
delta(126, sail(Location, _), -0.05272311016132064) :- todo_at(_, Location), !.
delta(126, sail(_, _), 0.07660864964338081) :- !.
delta(126, board(Car, Location), 0.006250284960361502) :- goal_at(Car, Location2), at(Car2, Location2), could_board_for_todo_at_any_location(Location), goal_at(Car2, Location2), !.
delta(126, board(Car, Location), -0.013730064351095708) :- goal_at(Car, Location2), at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(126, board(Car, _), 0.009556763992548916) :- goal_at(Car, Location), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(126, board(Car, _), -0.0049142507432076155) :- goal_at(Car, Location), at(_, Location), !.
delta(126, board(_, _), 0.06960009097487546) :- !.
delta(126, debark(Car, Location), 0.0008341973550659998) :- todo_at(Car, Location), !.
delta(126, debark(_, _), -0.003950920550192562) :- !.
delta(126, _, 0.0).

% tree 127: step size 1.0, 253 examples, 17 leaves
delta(127, sail(Location, Location2), 0.014533166312707254) :- could_board(Location2), at_ferry(Location3), could_board_for_todo_at_any_location(Location3), todo_at(Car, Location2), at(Car, Location), !.
delta(127, sail(_, Location), -0.08556600812370711) :- could_board(Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(127, sail(_, Location), -0.0065103435140725086) :- could_board(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(127, sail(_, Location), 0.020318446519026086) :- could_board(Location), !.
delta(127, sail(_, Location), 0.04247606251845286) :- goal_at(Car, Location), done_at(Car, Location), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(127, sail(_, Location), -0.00747794155207582) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(127, sail(_, _), 0.032988669142822065) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(127, sail(_, _), -0.04158883224239225) :- !.
delta(127, board(Car, _), 0.0018675549245098589) :- goal_at(Car, Location), done_at(_, Location), could_board_needed_on_to_debark(Location), todo_at(Car, Location), !.
delta(127, board(Car, _), -0.0003023446589661189) :- goal_at(Car, Location), done_at(_, Location), could_board_needed_on_to_debark(Location), !.
delta(127, board(Car, _), -0.01070759158009804) :- goal_at(Car, Location), done_at(_, Location), !.
delta(127, board(_, Location), -0.005630430501532014) :- goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(127, board(_, Location), 0.05724607320863054) :- goal_at(_, Location), !.
delta(127, board(_, _), -0.0075625963054883096) :- !.
delta(127, debark(Car, Location), 0.0010353703147480227) :- todo_at(Car, Location), !.
delta(127, debark(_, _), -0.0016901256320868792) :- !.
delta(127, _, 0.0).

% tree 128: step size 1.0, 281 examples, 15 leaves
delta(128, sail(Location, Location2), -0.009117563024366216) :- could_board_needed_on_to_debark(Location2), todo_at(Car, Location), at(Car, Location2), todo_at(_, Location2), !.
delta(128, sail(Location, Location2), 0.02247648264255401) :- could_board_needed_on_to_debark(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(128, sail(_, Location), 0.013265191554167466) :- could_board_needed_on_to_debark(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(128, sail(_, Location), -0.060143677887810935) :- could_board_needed_on_to_debark(Location), !.
delta(128, sail(Location, Location2), 0.010419414426606457) :- todo_at(Car, Location2), at(Car, Location), at_ferry(Location3), could_board_for_todo_at_any_location(Location3), !.
delta(128, sail(Location, Location2), -0.02415836958414604) :- todo_at(Car, Location2), at(Car, Location), !.
delta(128, sail(Location, _), 0.056218897220258794) :- at(Car, Location), todo_at(Car, _), !.
delta(128, sail(_, _), -0.004794526999299352) :- !.
delta(128, board(Car, Location), -0.025440350148512595) :- goal_at(Car, Location2), done_at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(128, board(Car, _), 0.003210965184064054) :- goal_at(Car, Location), done_at(_, Location), todo_at(Car, Location), !.
delta(128, board(Car, _), -0.0007808588388524529) :- goal_at(Car, Location), done_at(_, Location), !.
delta(128, board(_, _), 0.028575919178926944) :- !.
delta(128, debark(Car, Location), 0.0007548381278467481) :- todo_at(Car, Location), !.
delta(128, debark(_, _), -0.004127731256384508) :- !.
delta(128, _, 0.0).

% tree 129: step size 1.0, 211 examples, 16 leaves
delta(129, sail(Location, Location2), 0.00010424227658597015) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(_, Location), could_debark_todo_at(Location2), !.
delta(129, sail(Location, Location2), -0.05429897690697978) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(_, Location), !.
delta(129, sail(_, Location), 0.017864922450568733) :- goal_at(Car, Location), done_at(Car, Location), at(Car2, Location), needed_on_to_debark(Car2), !.
delta(129, sail(_, Location), -0.008077195975978127) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(129, sail(Location, Location2), 0.001693981169513221) :- todo_at(Car, Location2), at(Car, Location), at_ferry(Location3), could_debark_for_todo_at_any_location(Location3), !.
delta(129, sail(Location, Location2), -0.015339981117339885) :- todo_at(Car, Location2), at(Car, Location), !.
delta(129, sail(_, _), -0.0004209228201277548) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(129, sail(_, _), 0.08063346231427983) :- !.
delta(129, board(Car, Location), 0.00336733698717716) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(129, board(Car, Location), 0.0014776064714406034) :- goal_at(Car, Location2), could_board_needed_on_to_debark(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(129, board(Car, _), -0.06085977330930367) :- goal_at(Car, Location), could_board_needed_on_to_debark(Location), !.
delta(129, board(Car, _), 0.028228576689315756) :- todo_at(Car, _), !.
delta(129, board(_, _), -0.0008493991244482928) :- !.
delta(129, debark(Car, Location), 0.001334917568665201) :- todo_at(Car, Location), !.
delta(129, debark(_, _), -0.002162221330752278) :- !.
delta(129, _, 0.0).

% tree 130: step size 1.0, 261 examples, 15 leaves
delta(130, sail(Location, Location2), -0.020112555442654254) :- todo_at(Car, Location2), at(Car, Location3), at_ferry(Location3), could_debark_for_todo_at_any_location(Location), !.
delta(130, sail(_, Location), 0.02667719800241162) :- todo_at(Car, Location), at(Car, Location2), at_ferry(Location2), !.
delta(130, sail(_, Location), 0.006500212446671085) :- todo_at(Car, Location), at(Car, Location2), could_debark_todo_at(Location2), !.
delta(130, sail(_, Location), -0.10867141046618581) :- todo_at(Car, Location), at(Car, _), !.
delta(130, sail(Location, Location2), -0.007538135740822031) :- at(Car, Location2), todo_at(Car, Location), !.
delta(130, sail(_, Location), 0.16969437230120588) :- at(_, Location), !.
delta(130, sail(Location, _), 0.015968741151297147) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(130, sail(_, _), -0.031209038175185857) :- !.
delta(130, board(Car, Location), 0.0034392603040368694) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(Car2, Location), !.
delta(130, board(Car, _), -0.0728738185716413) :- goal_at(Car, Location), at(_, Location), !.
delta(130, board(_, Location), 0.024283724952971777) :- goal_at(_, Location), !.
delta(130, board(_, _), -0.016026705004017427) :- !.
delta(130, debark(Car, Location), 0.0010743207665636085) :- todo_at(Car, Location), !.
delta(130, debark(_, _), -0.00039682356861661243) :- !.
delta(130, _, 0.0).
