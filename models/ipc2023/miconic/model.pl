% SHA-256 of what follows: 48a1dc07432f5fa0e1f9f8a9aaaaa88bdb2b723874d45d82675fd8af4bd97fd8
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
model(trained_episodes, 827).
model(trees, 50).

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

% tree 1: step size 1.0, 218 examples, 7 leaves
delta(1, board(_, _), 0.37658714184199144) :- !.
delta(1, depart(_, _), 0.2914415281518455) :- !.
delta(1, up(_, Floor), 0.14528593508500784) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(1, up(_, _), -0.47715842488309834) :- !.
delta(1, down(_, Floor), 0.14427733877134855) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(1, down(_, _), -0.3739378107424463) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 201 examples, 7 leaves
delta(2, board(_, _), 0.33619799425333674) :- !.
delta(2, depart(_, _), 0.27306913423047796) :- !.
delta(2, up(_, Floor), 0.18727467473399442) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(2, up(_, _), -0.38108807842937803) :- !.
delta(2, down(_, Floor), 0.13735263948907597) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(2, down(_, _), -0.40744640487188005) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 207 examples, 9 leaves
delta(3, board(_, _), 0.26847498051640284) :- !.
delta(3, depart(_, _), 0.2438619657368547) :- !.
delta(3, up(_, Floor), 0.1688419049396484) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(3, up(_, Floor), 0.14141277349102097) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(3, up(_, _), -0.3989947526034861) :- !.
delta(3, down(_, Floor), 0.10887006489102523) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(3, down(_, Floor), 0.10909090909090917) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(3, down(_, _), -0.44759739777753954) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 202 examples, 9 leaves
delta(4, board(_, _), 0.17846485839436158) :- !.
delta(4, depart(_, _), 0.17110790734130873) :- !.
delta(4, up(_, Floor), 0.14445372374488608) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(4, up(_, Floor), 0.10826930785918686) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(4, up(_, _), -0.30787753755505715) :- !.
delta(4, down(_, Floor), 0.09537722082915187) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(4, down(_, Floor), 0.07171272735392348) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(4, down(_, _), -0.3362229722265169) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 205 examples, 9 leaves
delta(5, board(_, _), 0.1347635230326271) :- !.
delta(5, depart(_, _), 0.11552131104350631) :- !.
delta(5, up(_, Floor), 0.11022127748703145) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(5, up(_, Floor), 0.07568516926353241) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(5, up(_, _), -0.26275531784090544) :- !.
delta(5, down(_, Floor), 0.16040450015208213) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(5, down(_, Floor), 0.050879767837371366) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(5, down(_, _), -0.28950118244325257) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 207 examples, 9 leaves
delta(6, board(_, _), 0.11260027047607402) :- !.
delta(6, depart(_, _), 0.09755096949931076) :- !.
delta(6, up(_, Floor), 0.16504032508031927) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(6, up(_, Floor), 0.061616051185182694) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(6, up(_, _), -0.26828934607708993) :- !.
delta(6, down(_, Floor), 0.18147640969168669) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(6, down(_, Floor), 0.03716104290214225) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(6, down(_, _), -0.2917731343666488) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 203 examples, 9 leaves
delta(7, board(_, _), 0.10514025285583499) :- !.
delta(7, depart(_, _), 0.08719424941287805) :- !.
delta(7, up(_, Floor), 0.1532043999704751) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(7, up(_, Floor), 0.07018002550527311) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(7, up(_, _), -0.263393631955415) :- !.
delta(7, down(_, Floor), 0.20365011960649065) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(7, down(_, Floor), 0.04741081734500371) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(7, down(_, _), -0.2962027469083897) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 204 examples, 9 leaves
delta(8, board(_, _), 0.09933984344146798) :- !.
delta(8, depart(_, _), 0.07927471459031643) :- !.
delta(8, up(_, Floor), 0.12763056328349323) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(8, up(_, Floor), 0.08461170799648163) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(8, up(_, _), -0.2566666527516514) :- !.
delta(8, down(_, Floor), 0.17298582876054225) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(8, down(_, Floor), 0.05704521052949729) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(8, down(_, _), -0.26337268185377255) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 205 examples, 10 leaves
delta(9, board(_, _), 0.1767116854982613) :- !.
delta(9, depart(_, _), 0.12583281938723662) :- !.
delta(9, up(_, Floor), -0.007951905675529131) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(9, up(_, Floor), 0.09367644881541391) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(9, up(_, Floor), -0.06438166230218664) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), todo_served(Passenger), needed_boarded_to_depart(Passenger), !.
delta(9, up(_, Floor), 0.12993387598286002) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(9, up(_, _), -0.2607925209828863) :- !.
delta(9, down(_, Floor), 0.1665449400717006) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(9, down(_, _), -0.262046153538248) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 205 examples, 11 leaves
delta(10, board(_, _), 0.23537293909169366) :- !.
delta(10, depart(_, _), 0.15283562905583314) :- !.
delta(10, up(_, Floor), 0.07205818896626351) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(10, up(_, Floor), -0.08035299860737614) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), todo_served(Passenger), needed_boarded_to_depart(Passenger), !.
delta(10, up(_, Floor), 0.11282066085355909) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(10, up(_, _), -0.20633440247585016) :- !.
delta(10, down(Floor, Floor2), -0.021823993047111908) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), boarded(Passenger), destin(Passenger, Floor), !.
delta(10, down(_, Floor), -0.01779208196037817) :- lift_at(Floor2), toward_could_board(Floor2, Floor), todo_served(Passenger), destin(Passenger, Floor), !.
delta(10, down(_, Floor), 0.15260729770647286) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(10, down(_, _), -0.2969778692628031) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 207 examples, 11 leaves
delta(11, board(_, _), 0.20097693194939317) :- !.
delta(11, depart(_, _), 0.1743403804934172) :- !.
delta(11, up(_, Floor), 0.17555677517206636) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(11, up(_, _), -0.26598688470679777) :- !.
delta(11, down(Floor, Floor2), -0.05277456477122244) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), boarded(Passenger), destin(Passenger, Floor), !.
delta(11, down(_, Floor), -0.01445229019634001) :- lift_at(Floor2), toward_could_board(Floor2, Floor), todo_served(Passenger), destin(Passenger, Floor), !.
delta(11, down(_, Floor), 0.12017309388761035) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(11, down(Floor, _), -0.0419435319682255) :- fewer_lift_at_than_boarded, todo_served(Passenger), destin(Passenger, Floor), !.
delta(11, down(_, _), 0.044837683994321864) :- fewer_lift_at_than_boarded, !.
delta(11, down(_, _), -0.21941140648155658) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 204 examples, 22 leaves
delta(12, board(Floor, Passenger), 0.0033954431387640096) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), todo_served(Passenger2), boarded(Passenger2), !.
delta(12, board(Floor, Passenger), -0.019330531965356786) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(12, board(Floor, Passenger), -0.0262832076185004) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), origin(Passenger, Floor3), above(Floor2, Floor3), !.
delta(12, board(Floor, Passenger), 0.018902825144233023) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(12, board(_, _), 0.13033041479151591) :- !.
delta(12, depart(_, _), 0.13632170446579334) :- !.
delta(12, up(Floor, Floor2), -0.025348223492712856) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), todo_served(Passenger), origin(Passenger, Floor), !.
delta(12, up(_, Floor), -0.003870629161891575) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), destin(Passenger, Floor), needed_boarded_to_depart(Passenger), !.
delta(12, up(_, Floor), 0.15483866269180538) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(12, up(_, Floor), -0.04687004134598988) :- lift_at(Floor2), toward_could_board(Floor2, Floor), todo_served(Passenger), destin(Passenger, Floor), !.
delta(12, up(_, Floor), 0.12069444543156661) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(12, up(_, Floor), 0.015285558250394756) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(12, up(_, _), -0.22895814166559855) :- !.
delta(12, down(_, Floor), -0.03301521841419065) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), fewer_lift_at_than_boarded, todo_served(Passenger), needed_boarded_to_depart(Passenger), !.
delta(12, down(_, Floor), 0.018925542204502287) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), fewer_lift_at_than_boarded, !.
delta(12, down(Floor, Floor2), -0.011022149685445777) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), todo_served(Passenger), origin(Passenger, Floor), !.
delta(12, down(_, Floor), 0.12960163017467072) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(12, down(Floor, Floor2), 0.12301632202699739) :- origin(Passenger, Floor2), destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(12, down(Floor, Floor2), -0.04546741439240238) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(12, down(_, Floor), 0.002847953456906642) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(12, down(_, _), -0.28235930239001744) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 203 examples, 18 leaves
delta(13, board(Floor, Passenger), 0.012041159553115164) :- destin(Passenger2, Floor), origin(Passenger2, Floor2), destin(Passenger, Floor2), !.
delta(13, board(Floor, _), -0.0507654153737597) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(13, board(_, _), 0.15487841241409267) :- !.
delta(13, depart(Floor, _), -0.01335188345359539) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(13, depart(_, _), 0.12414558593934193) :- !.
delta(13, up(_, Floor), -0.29783563922697043) :- destin(Passenger, Floor), origin(Passenger, _), fewer_lift_at_than_todo_served, !.
delta(13, up(Floor, Floor2), 0.010181335779752642) :- destin(Passenger, Floor2), origin(Passenger, Floor3), above(Floor, Floor3), !.
delta(13, up(_, Floor), -0.011842498680030403) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(13, up(Floor, _), -0.08168968298885544) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(13, up(_, _), -0.04150750257723749) :- goal_served(Passenger), done_served(Passenger), !.
delta(13, up(_, _), 0.19409110251748773) :- !.
delta(13, down(_, Floor), -0.19766406262988648) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), destin(Passenger, Floor), origin(Passenger, _), !.
delta(13, down(_, Floor), 0.0020547115621921907) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(13, down(_, Floor), -0.00636980546047273) :- todo_served(Passenger), origin(Passenger, Floor), goal_served(Passenger2), done_served(Passenger2), !.
delta(13, down(_, Floor), 0.2734800519810486) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(13, down(_, Floor), 0.046297659783872444) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(13, down(_, _), -0.19396325248961765) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 212 examples, 18 leaves
delta(14, board(Floor, Passenger), 0.0016209918468007417) :- origin(Passenger, Floor2), could_depart(Floor2), destin(Passenger, Floor3), above(Floor, Floor3), !.
delta(14, board(_, Passenger), -0.040919028893148315) :- origin(Passenger, Floor), could_depart(Floor), !.
delta(14, board(_, _), 0.11614865120183998) :- !.
delta(14, depart(Floor, _), -0.027210202390565548) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(14, depart(Floor, _), -0.007991841619680189) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(14, depart(_, _), 0.09910224341999653) :- !.
delta(14, up(_, Floor), -0.18997062156286423) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(14, up(_, Floor), 0.1617903418611617) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(14, up(_, Floor), 0.0776172285364383) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(14, up(_, _), -0.15681982724109267) :- !.
delta(14, down(_, Floor), 0.0014235211818151119) :- lift_at(Floor2), toward_could_board(Floor2, Floor), todo_served(Passenger), destin(Passenger, Floor), fewer_lift_at_than_boarded, !.
delta(14, down(_, Floor), -0.13713834186168727) :- lift_at(Floor2), toward_could_board(Floor2, Floor), todo_served(Passenger), destin(Passenger, Floor), !.
delta(14, down(Floor, Floor2), -0.012892998438435764) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), boarded(Passenger), destin(Passenger, Floor), !.
delta(14, down(_, Floor), 0.2851422589133072) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(14, down(_, Floor), -0.04665954269804174) :- boarded(Passenger), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(14, down(_, Floor), 0.056439511547814285) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(14, down(_, _), -0.18519491890877796) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 209 examples, 24 leaves
delta(15, board(Floor, Passenger), 0.0007416869194584426) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), destin(Passenger2, Floor), needed_boarded_to_depart(Passenger2), above(Floor, Floor2), !.
delta(15, board(Floor, Passenger), -0.10332449657057127) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), destin(Passenger2, Floor), needed_boarded_to_depart(Passenger2), !.
delta(15, board(Floor, Passenger), 0.01780403439861534) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(15, board(Floor, Passenger), 0.007874469904658274) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), origin(Passenger, Floor3), above(Floor2, Floor3), !.
delta(15, board(Floor, Passenger), -0.0481172357459421) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(15, board(_, _), 0.11655170098225726) :- !.
delta(15, depart(Floor, _), -0.014385308578124223) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(15, depart(_, _), 0.09007562862496073) :- !.
delta(15, up(Floor, Floor2), 0.0021800123279637493) :- destin(Passenger, Floor), origin(Passenger, Floor3), needed_lift_at_to_depart(Floor2), above(Floor3, Floor2), !.
delta(15, up(Floor, Floor2), -0.05920256087387703) :- destin(Passenger, Floor), origin(Passenger, _), needed_lift_at_to_depart(Floor2), !.
delta(15, up(Floor, Floor2), 0.11107600111538138) :- destin(Passenger, Floor), origin(Passenger, _), could_board(Floor2), !.
delta(15, up(Floor, _), -0.010230043072376804) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(15, up(_, Floor), 0.08140529650352392) :- todo_served(Passenger), destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(15, up(_, Floor), -0.0431837356999698) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(15, up(Floor, _), 0.03524405899272667) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(15, up(_, _), -0.18016530973357733) :- !.
delta(15, down(Floor, Floor2), 0.0007089904274881925) :- origin(Passenger, Floor2), destin(Passenger, Floor), fewer_lift_at_than_todo_served, goal_served(Passenger2), done_served(Passenger2), !.
delta(15, down(Floor, Floor2), -0.15960854952228506) :- origin(Passenger, Floor2), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(15, down(Floor, Floor2), 0.00710896051479534) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(15, down(_, Floor), 0.28815152108340464) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(15, down(_, Floor), -0.058399501438785105) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(15, down(_, Floor), 0.021520091799823164) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(15, down(_, _), -0.1303408936084708) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 219 examples, 23 leaves
delta(16, board(Floor, Passenger), 0.004607805187925205) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), goal_served(Passenger2), done_served(Passenger2), !.
delta(16, board(Floor, Passenger), -0.10835970094649393) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), origin(Passenger, Floor3), above(Floor2, Floor3), !.
delta(16, board(Floor, Passenger), 0.0014210664548652363) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(16, board(_, _), -0.025839732098290158) :- fewer_lift_at_than_boarded, !.
delta(16, board(_, _), 0.085102122086696) :- !.
delta(16, depart(Floor, _), -0.01795068033932797) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(16, depart(_, _), 0.14569726514911127) :- !.
delta(16, up(_, Floor), -0.22086383408967236) :- destin(Passenger, Floor), origin(Passenger, _), fewer_lift_at_than_todo_served, !.
delta(16, up(Floor, Floor2), 0.010594194928905256) :- destin(Passenger, Floor2), origin(Passenger, Floor3), above(Floor, Floor3), !.
delta(16, up(_, Floor), -0.0036138418071150957) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(16, up(_, Floor), -0.03733370512685626) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), fewer_lift_at_than_boarded, !.
delta(16, up(_, Floor), 0.0015250526504327678) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(16, up(Floor, _), -0.02898416153657065) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(16, up(_, _), 0.14665462487156106) :- !.
delta(16, down(Floor, Floor2), -0.011345235144253469) :- goal_served(Passenger), done_served(Passenger), lift_at(Floor3), toward_could_board(Floor3, Floor2), could_depart(Floor), !.
delta(16, down(_, Floor), 0.027968923136583203) :- goal_served(Passenger), done_served(Passenger), lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(16, down(Floor, _), 0.018493385847569325) :- goal_served(Passenger), done_served(Passenger), destin(Passenger, Floor2), toward_could_board(Floor2, Floor), !.
delta(16, down(_, _), -0.14652832980828154) :- goal_served(Passenger), done_served(Passenger), !.
delta(16, down(_, Floor), 0.014646152244853293) :- destin(Passenger, Floor), origin(Passenger, Floor2), needed_lift_at_to_depart(Floor2), !.
delta(16, down(_, Floor), -0.10170362049072952) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(16, down(_, Floor), -0.016852802554358674) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(16, down(_, _), 0.18596651702344086) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 206 examples, 20 leaves
delta(17, board(Floor, Passenger), 0.006868426917853279) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), beyond_above(Floor3, Floor2), origin(Passenger, Floor3), !.
delta(17, board(Floor, Passenger), -0.12939823328878958) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), beyond_above(_, Floor2), !.
delta(17, board(Floor, Passenger), 0.007577960498876629) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(17, board(_, _), 0.07571969668534612) :- !.
delta(17, depart(Floor, _), -0.016824260033151104) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(17, depart(_, _), 0.08234687373171745) :- !.
delta(17, up(_, Floor), -0.13862623411793867) :- destin(Passenger, Floor), origin(Passenger, _), could_board(Floor), !.
delta(17, up(Floor, Floor2), 0.02079716502601116) :- destin(Passenger, Floor2), origin(Passenger, Floor3), above(Floor3, Floor), !.
delta(17, up(_, Floor), -0.016461990893029174) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(17, up(_, Floor), -0.05050663045364228) :- lift_at(Floor2), toward_could_depart(Floor, Floor2), !.
delta(17, up(Floor, _), -0.02710972764576575) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(17, up(_, _), 0.10583732407872348) :- !.
delta(17, down(Floor, Floor2), -0.0071833624684522375) :- lift_at(Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), origin(Passenger, Floor), destin(Passenger, Floor2), !.
delta(17, down(_, Floor), -0.001954659039807373) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), lift_at(Floor3), toward_could_depart(Floor, Floor3), !.
delta(17, down(_, Floor), 0.10719960180019446) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(17, down(Floor, Floor2), -0.005885357028305684) :- done_served(Passenger), destin(Passenger, Floor2), todo_served(Passenger2), destin(Passenger2, Floor), !.
delta(17, down(_, Floor), 0.05050023763413622) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(17, down(_, Floor), -0.09075960595354046) :- beyond_above(_, Floor), !.
delta(17, down(_, _), 0.01140205542334186) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 210 examples, 21 leaves
delta(18, board(Floor, Passenger), 0.003641310096761241) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), origin(Passenger, Floor3), could_depart(Floor3), !.
delta(18, board(Floor, Passenger), 0.0004683980107605291) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), beyond_above(Floor, _), !.
delta(18, board(Floor, Passenger), -0.03999050671566517) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(18, board(_, _), 0.05956931320749404) :- !.
delta(18, depart(_, _), 0.06959830731852715) :- lift_at(Floor), beyond_above(_, Floor), !.
delta(18, depart(_, _), -0.04042372505048613) :- todo_served(Passenger), origin(Passenger, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(18, depart(_, _), 0.0006955781846320367) :- todo_served(Passenger), origin(Passenger, _), !.
delta(18, depart(_, _), 0.008825707801040925) :- !.
delta(18, up(Floor, _), -0.18547076679959162) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(18, up(_, Floor), 0.0018213807131221746) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), boarded(Passenger), destin(Passenger, Floor), !.
delta(18, up(_, Floor), -0.046333412476651036) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(18, up(_, _), 0.19987051819015353) :- fewer_lift_at_than_todo_served, !.
delta(18, up(_, _), -0.016781062435514697) :- !.
delta(18, down(Floor, Floor2), -0.052977183871772526) :- destin(Passenger, Floor2), origin(Passenger, _), toward_could_depart(Floor, Floor2), !.
delta(18, down(_, Floor), -0.016750175078519357) :- destin(Passenger, Floor), origin(Passenger, _), could_board(Floor), !.
delta(18, down(_, Floor), 0.26418458733815775) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(18, down(_, Floor), 0.0006824542192364788) :- fewer_lift_at_than_boarded, lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(18, down(_, _), -0.28972016028488) :- fewer_lift_at_than_boarded, !.
delta(18, down(_, Floor), 0.0619715237932467) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(18, down(_, _), -0.03297585926294213) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 204 examples, 25 leaves
delta(19, board(Floor, Passenger), 0.0005982569150514593) :- fewer_lift_at_than_boarded, destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(19, board(_, _), -0.03888690873513124) :- fewer_lift_at_than_boarded, !.
delta(19, board(Floor, Passenger), 0.001618296955424817) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), todo_served(Passenger2), boarded(Passenger2), !.
delta(19, board(Floor, Passenger), -0.012687254822950992) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(19, board(_, _), 0.04478002833249777) :- !.
delta(19, depart(_, _), 0.07472285520722903) :- fewer_lift_at_than_boarded, !.
delta(19, depart(Floor, _), 0.00033390756191925417) :- todo_served(Passenger), origin(Passenger, _), origin(Passenger, Floor), !.
delta(19, depart(_, _), -0.04164573979622782) :- todo_served(Passenger), origin(Passenger, _), !.
delta(19, depart(_, _), 0.007974121216243666) :- !.
delta(19, up(Floor, Floor2), -0.055510898338715156) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), goal_served(Passenger), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(19, up(Floor, Floor2), 0.0030879355951449598) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), goal_served(Passenger), destin(Passenger, Floor), !.
delta(19, up(_, Floor), -0.013770389335000383) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), todo_served(Passenger), origin(Passenger, Floor), !.
delta(19, up(_, Floor), 0.10299910033563481) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(19, up(Floor, Floor2), 0.06690213917851766) :- done_served(Passenger), destin(Passenger, Floor), beyond_above(Floor2, _), !.
delta(19, up(Floor, _), -0.027102709973934352) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(19, up(Floor, Floor2), 0.008934806447095503) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(19, up(_, _), -0.19560906322859867) :- !.
delta(19, down(_, Floor), -0.0869486933427174) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), lift_at(Floor2), beyond_above(Floor2, _), !.
delta(19, down(_, Floor), 0.017086715035031237) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), boarded(Passenger), destin(Passenger, Floor), !.
delta(19, down(_, Floor), -0.013232004403124454) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(19, down(Floor, _), -0.0009773542217861848) :- lift_at(Floor2), beyond_above(Floor2, Floor3), toward_could_board(Floor, Floor3), !.
delta(19, down(_, _), 0.18219671809987154) :- lift_at(Floor), beyond_above(Floor, _), !.
delta(19, down(_, Floor), -0.07731219588400337) :- beyond_above(_, Floor), !.
delta(19, down(_, _), 0.05331114310907532) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 215 examples, 19 leaves
delta(20, board(_, Passenger), 0.010384537603212209) :- destin(Passenger, Floor), could_depart(Floor), !.
delta(20, board(_, Passenger), 0.006768446508684658) :- origin(Passenger, Floor), beyond_above(Floor2, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(20, board(_, Passenger), -0.07802507758597693) :- origin(Passenger, Floor), beyond_above(_, Floor), !.
delta(20, board(_, _), 0.00736355787380214) :- !.
delta(20, depart(_, _), 0.07413005270823377) :- !.
delta(20, up(Floor, Floor2), 0.10420188426582207) :- beyond_above(Floor2, Floor3), destin(Passenger, Floor2), needed_boarded_to_depart(Passenger), toward_could_board(Floor3, Floor), !.
delta(20, up(_, Floor), -0.040637557969185056) :- beyond_above(Floor, _), destin(Passenger, Floor), needed_boarded_to_depart(Passenger), !.
delta(20, up(_, Floor), 0.027180742305765008) :- beyond_above(Floor, Floor2), origin(Passenger, Floor), destin(Passenger, Floor2), !.
delta(20, up(_, Floor), -0.20739726350274906) :- beyond_above(Floor, _), !.
delta(20, up(_, Floor), -0.014679536425263422) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(20, up(Floor, _), -0.00862700503441863) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(20, up(_, _), 0.11536243433700821) :- !.
delta(20, down(_, Floor), -0.0343392364370542) :- lift_at(Floor2), toward_could_board(Floor2, Floor), boarded(Passenger), destin(Passenger, Floor), !.
delta(20, down(_, Floor), 0.19396428888675335) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(20, down(_, Floor), 0.02749470404905774) :- done_served(Passenger), destin(Passenger, Floor), todo_served(Passenger2), destin(Passenger2, Floor), !.
delta(20, down(_, Floor), -0.008915002958386993) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(20, down(_, Floor), 0.013741187694564543) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(20, down(_, _), -0.16674038753089224) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 236 examples, 20 leaves
delta(21, board(Floor, Passenger), 0.01338815236331893) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), todo_served(Passenger2), boarded(Passenger2), !.
delta(21, board(Floor, Passenger), -0.039357845521244814) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(21, board(_, _), 0.06079867427903085) :- !.
delta(21, depart(_, _), 0.04625909746531763) :- !.
delta(21, up(_, Floor), -0.012800976512114677) :- beyond_above(Floor, _), destin(Passenger, Floor), needed_boarded_to_depart(Passenger), could_depart(Floor), !.
delta(21, up(_, Floor), 0.0754810692806122) :- beyond_above(Floor, _), destin(Passenger, Floor), needed_boarded_to_depart(Passenger), !.
delta(21, up(_, Floor), 0.008687804342280546) :- beyond_above(Floor, Floor2), boarded(Passenger), destin(Passenger, Floor2), !.
delta(21, up(_, Floor), -0.16944798589372181) :- beyond_above(Floor, _), !.
delta(21, up(Floor, _), 0.011557124619095487) :- todo_served(Passenger), destin(Passenger, Floor), done_served(Passenger2), destin(Passenger2, Floor), !.
delta(21, up(Floor, _), -0.0376400586534266) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(21, up(Floor, _), -0.005934702571827974) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(21, up(_, _), 0.09029017363154614) :- !.
delta(21, down(_, Floor), -0.17450071053501004) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(21, down(_, Floor), -0.06280946489033834) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(21, down(_, Floor), 0.14348243835664987) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(21, down(_, Floor), -0.03609260903167462) :- fewer_lift_at_than_boarded, lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(21, down(_, _), 0.1491426189506519) :- fewer_lift_at_than_boarded, !.
delta(21, down(_, Floor), 0.019195423467299574) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(21, down(_, _), -0.06962559556943494) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 207 examples, 15 leaves
delta(22, board(_, Passenger), 0.10417629084295162) :- destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(22, board(_, Passenger), -0.050713195092089665) :- origin(Passenger, Floor), beyond_above(_, Floor), fewer_lift_at_than_todo_served, !.
delta(22, board(_, Passenger), 0.00047312898453559824) :- origin(Passenger, Floor), beyond_above(_, Floor), !.
delta(22, board(_, _), 0.004989146967935678) :- !.
delta(22, depart(_, _), 0.06392218843835515) :- !.
delta(22, up(_, Floor), -0.05820377855722595) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(22, up(Floor, Floor2), 0.01300473052425565) :- goal_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor2), !.
delta(22, up(Floor, _), -0.06157304181634879) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(22, up(Floor, _), -0.010956945584292326) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(22, up(_, _), 0.1503868147308546) :- !.
delta(22, down(Floor, Floor2), 0.03037412361879685) :- done_served(Passenger), destin(Passenger, Floor), boarded(Passenger2), destin(Passenger2, Floor2), !.
delta(22, down(Floor, Floor2), 0.00670219944202885) :- done_served(Passenger), destin(Passenger, Floor), lift_at(Floor3), toward_could_board(Floor3, Floor2), !.
delta(22, down(Floor, _), -0.012222912979023738) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(22, down(_, _), -0.16416610357323555) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 203 examples, 17 leaves
delta(23, board(Floor, Passenger), -0.056926032164095634) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(23, board(_, _), 0.02699104207846175) :- !.
delta(23, depart(Floor, _), 0.018223809096932483) :- destin(Passenger, Floor), origin(Passenger, _), fewer_lift_at_than_boarded, !.
delta(23, depart(Floor, _), -0.03139425306519532) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(23, depart(_, _), 0.047459666973708695) :- !.
delta(23, up(Floor, Floor2), 0.0008551288588607614) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), fewer_lift_at_than_todo_served, done_served(Passenger), destin(Passenger, Floor), !.
delta(23, up(_, Floor), -0.1745687669076103) :- lift_at(Floor2), toward_could_board(Floor2, Floor), fewer_lift_at_than_todo_served, !.
delta(23, up(_, Floor), 0.008035575060747337) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(23, up(_, Floor), -0.021531649216675396) :- lift_at(Floor2), toward_could_board(Floor, Floor2), !.
delta(23, up(Floor, _), -0.006593883174252368) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(23, up(_, _), 0.18517691688751045) :- !.
delta(23, down(_, Floor), -0.1243007832108173) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(23, down(_, Floor), -0.007928516988062665) :- todo_served(Passenger), origin(Passenger, Floor2), toward_could_depart(Floor2, Floor), !.
delta(23, down(_, _), 0.1418048489918896) :- todo_served(Passenger), origin(Passenger, _), !.
delta(23, down(_, Floor), 0.04949195777025257) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(23, down(_, _), -0.08026314694910666) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 218 examples, 22 leaves
delta(24, board(Floor, _), -0.11541546011333309) :- destin(Passenger, Floor), origin(Passenger, Floor2), above(Floor2, Floor), !.
delta(24, board(Floor, _), 0.0017511858185382061) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(24, board(_, _), 0.0227909852428268) :- !.
delta(24, depart(_, _), 0.027057282601842005) :- goal_served(Passenger), done_served(Passenger), !.
delta(24, depart(_, _), -0.046943506473314967) :- lift_at(Floor), beyond_above(Floor, _), fewer_lift_at_than_boarded, !.
delta(24, depart(_, _), 0.005597429582839449) :- lift_at(Floor), beyond_above(Floor, _), !.
delta(24, depart(_, _), 0.019194821545397835) :- !.
delta(24, up(Floor, Floor2), -0.00037154681501757654) :- goal_served(Passenger), destin(Passenger, Floor2), lift_at(Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), origin(Passenger, Floor), !.
delta(24, up(_, Floor), 0.010736491190388261) :- goal_served(Passenger), destin(Passenger, Floor), lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(24, up(_, Floor), -0.1818322669857463) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(24, up(Floor, Floor2), -0.024827728994099414) :- todo_served(Passenger), destin(Passenger, Floor), todo_served(Passenger2), origin(Passenger2, Floor2), !.
delta(24, up(Floor, _), 0.1819794504811039) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(24, up(_, Floor), 0.01188026327259758) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(24, up(_, _), -0.06417918113479563) :- !.
delta(24, down(_, Floor), -0.030229284661009388) :- beyond_above(_, Floor), lift_at(Floor2), toward_could_depart(Floor, Floor2), !.
delta(24, down(_, Floor), -0.01216730387153122) :- beyond_above(_, Floor), lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(24, down(_, Floor), 0.2396605097678382) :- beyond_above(_, Floor), !.
delta(24, down(Floor, Floor2), 0.02971732542986097) :- boarded(Passenger), destin(Passenger, Floor2), beyond_above(Floor, _), !.
delta(24, down(_, Floor), -0.007383104813995213) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(24, down(Floor, _), 0.007488422776823437) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(24, down(_, _), -0.10450535681843595) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 234 examples, 19 leaves
delta(25, board(Floor, Passenger), 0.00840442674715039) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), origin(Passenger, Floor3), above(Floor2, Floor3), !.
delta(25, board(Floor, Passenger), 0.00021224456818965515) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), todo_served(Passenger2), boarded(Passenger2), !.
delta(25, board(Floor, Passenger), -0.012009053621244083) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(25, board(_, _), 0.03308212514824667) :- !.
delta(25, depart(_, _), 0.027597201212851724) :- lift_at(Floor), beyond_above(Floor, _), !.
delta(25, depart(_, _), -0.03469218906564449) :- todo_served(Passenger), origin(Passenger, _), !.
delta(25, depart(_, _), 0.002620904127696654) :- !.
delta(25, up(Floor, Floor2), -0.01663937367098196) :- goal_served(Passenger), destin(Passenger, Floor2), beyond_above(_, Floor), origin(Passenger, Floor), !.
delta(25, up(Floor, Floor2), 0.12961323616409945) :- goal_served(Passenger), destin(Passenger, Floor2), beyond_above(_, Floor), !.
delta(25, up(_, Floor), -0.032186268308997956) :- goal_served(Passenger), destin(Passenger, Floor), todo_served(Passenger2), needed_boarded_to_depart(Passenger2), !.
delta(25, up(_, Floor), 0.01291548857319535) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(25, up(Floor, Floor2), -0.009339882576414618) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), todo_served(Passenger), destin(Passenger, Floor), !.
delta(25, up(_, Floor), 0.03900175010147282) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(25, up(_, _), -0.07764026868090883) :- !.
delta(25, down(_, Floor), 0.09291276669195472) :- beyond_above(_, Floor), lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(25, down(_, Floor), 0.010170960689620654) :- beyond_above(Floor2, Floor), done_served(Passenger), destin(Passenger, Floor2), !.
delta(25, down(_, Floor), -0.07461998326070252) :- beyond_above(_, Floor), !.
delta(25, down(_, _), -0.09772456579133183) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 206 examples, 22 leaves
delta(26, board(Floor, Passenger), 0.05965367568544926) :- destin(Passenger, Floor2), above(Floor, Floor2), beyond_above(Floor2, _), !.
delta(26, board(Floor, Passenger), -0.04176864925697862) :- destin(Passenger, Floor2), above(Floor, Floor2), beyond_above(_, Floor), !.
delta(26, board(Floor, Passenger), 0.00221305790812545) :- destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(26, board(Floor, Passenger), -0.17970484943943293) :- origin(Passenger, Floor2), beyond_above(Floor2, Floor3), toward_could_board(Floor3, Floor), !.
delta(26, board(_, Passenger), 0.006911942529910163) :- origin(Passenger, Floor), beyond_above(Floor, _), !.
delta(26, board(_, _), 0.010324899465880714) :- !.
delta(26, depart(_, _), 0.06570643904433887) :- !.
delta(26, up(Floor, Floor2), -0.01433684192270043) :- goal_served(Passenger), destin(Passenger, Floor2), todo_served(Passenger2), boarded(Passenger2), destin(Passenger2, Floor), !.
delta(26, up(_, Floor), 0.20453115920771797) :- goal_served(Passenger), destin(Passenger, Floor), todo_served(Passenger2), boarded(Passenger2), !.
delta(26, up(_, Floor), -0.02272146626237714) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(26, up(Floor, _), 0.03862311578804885) :- goal_served(Passenger), done_served(Passenger), destin(Passenger, Floor2), above(Floor2, Floor), !.
delta(26, up(_, _), -0.03400682578499514) :- goal_served(Passenger), done_served(Passenger), !.
delta(26, up(_, _), -0.15024845816544175) :- !.
delta(26, down(Floor, Floor2), 0.03057011051176621) :- goal_served(Passenger), destin(Passenger, Floor2), origin(Passenger2, Floor2), destin(Passenger2, Floor), fewer_lift_at_than_boarded, !.
delta(26, down(Floor, Floor2), -0.00483540746832952) :- goal_served(Passenger), destin(Passenger, Floor2), origin(Passenger2, Floor2), destin(Passenger2, Floor), !.
delta(26, down(_, Floor), -0.17901803041519293) :- goal_served(Passenger), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(26, down(_, Floor), -0.0016433017538541126) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(26, down(Floor, Floor2), 0.03578387439557298) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(26, down(_, Floor), -0.04667426141854508) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(26, down(_, _), 0.25791208426967205) :- fewer_lift_at_than_todo_served, !.
delta(26, down(_, _), -0.029523938524980666) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 238 examples, 21 leaves
delta(27, board(Floor, Passenger), 0.005019288165270344) :- destin(Passenger, Floor2), beyond_above(Floor2, Floor3), could_board(Floor3), toward_could_depart(Floor, Floor3), !.
delta(27, board(_, Passenger), -0.10936245578348743) :- destin(Passenger, Floor), beyond_above(Floor, Floor2), could_board(Floor2), !.
delta(27, board(_, Passenger), 0.014324614767984791) :- destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(27, board(_, _), 0.028344683297704718) :- !.
delta(27, depart(_, _), 0.061004724742819566) :- goal_served(Passenger), done_served(Passenger), fewer_lift_at_than_boarded, !.
delta(27, depart(_, _), -0.01886006932729988) :- goal_served(Passenger), done_served(Passenger), todo_served(Passenger2), needed_boarded_to_depart(Passenger2), !.
delta(27, depart(_, _), 0.0014298088449857937) :- goal_served(Passenger), done_served(Passenger), !.
delta(27, depart(_, _), 0.0030478146390719987) :- lift_at(Floor), beyond_above(Floor, Floor2), could_board(Floor2), !.
delta(27, depart(_, _), -0.0971514661797589) :- lift_at(Floor), beyond_above(Floor, _), !.
delta(27, depart(_, _), 0.006358188053871514) :- !.
delta(27, up(_, Floor), -0.1240741313866689) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(27, up(Floor, _), 0.21732784302928423) :- todo_served(Passenger), origin(Passenger, Floor2), above(Floor, Floor2), !.
delta(27, up(_, _), -0.04518269110159905) :- todo_served(Passenger), origin(Passenger, _), !.
delta(27, up(_, Floor), 0.008823338173081896) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(27, up(_, _), -0.08074406875776025) :- !.
delta(27, down(_, Floor), 0.1776968947974379) :- goal_served(Passenger), destin(Passenger, Floor), todo_served(Passenger2), boarded(Passenger2), !.
delta(27, down(_, Floor), -0.03738668644302291) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(27, down(Floor, Floor2), 0.09197128415127803) :- goal_served(Passenger), destin(Passenger, Floor), todo_served(Passenger2), origin(Passenger2, Floor2), !.
delta(27, down(Floor, _), -0.017350734146544783) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(27, down(_, _), -0.1311936510766037) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 212 examples, 18 leaves
delta(28, board(Floor, Passenger), 0.003058165742207091) :- origin(Passenger, Floor2), could_depart(Floor2), destin(Passenger, Floor3), above(Floor, Floor3), !.
delta(28, board(_, Passenger), -0.014724579344477995) :- origin(Passenger, Floor), could_depart(Floor), !.
delta(28, board(_, _), 0.029211148819145397) :- !.
delta(28, depart(Floor, _), -0.04902987407692246) :- lift_at(Floor2), beyond_above(Floor3, Floor2), toward_could_depart(Floor3, Floor), fewer_lift_at_than_todo_served, !.
delta(28, depart(Floor, _), 0.0024279046786282246) :- lift_at(Floor2), beyond_above(Floor3, Floor2), toward_could_depart(Floor3, Floor), !.
delta(28, depart(_, _), 0.0037038636580722143) :- lift_at(Floor), beyond_above(_, Floor), !.
delta(28, depart(_, _), 0.015943517946219624) :- !.
delta(28, up(_, Floor), 0.1236401815096455) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor2), could_board(Floor2), !.
delta(28, up(Floor, Floor2), 0.019762388539464118) :- todo_served(Passenger), origin(Passenger, Floor2), destin(Passenger, Floor3), toward_could_depart(Floor, Floor3), !.
delta(28, up(_, Floor), -0.09176276336054658) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(28, up(_, _), -0.14292318392927592) :- !.
delta(28, down(_, Floor), -0.02223143960926922) :- goal_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(28, down(Floor, Floor2), -0.020609672004194415) :- goal_served(Passenger), destin(Passenger, Floor2), destin(Passenger2, Floor), needed_boarded_to_depart(Passenger2), !.
delta(28, down(_, Floor), 0.22696120196507516) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(28, down(Floor, Floor2), 0.051317420571880976) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(28, down(Floor, _), 0.007747910579242549) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(28, down(_, _), -0.13045068266361548) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 216 examples, 19 leaves
delta(29, board(_, Passenger), 0.005549931456058037) :- destin(Passenger, Floor), beyond_above(Floor2, Floor), needed_lift_at_to_depart(Floor2), could_board(Floor), !.
delta(29, board(_, Passenger), -0.12123821331786606) :- destin(Passenger, Floor), beyond_above(Floor2, Floor), needed_lift_at_to_depart(Floor2), !.
delta(29, board(_, Passenger), 0.023165666120451685) :- destin(Passenger, Floor), beyond_above(_, Floor), !.
delta(29, board(_, _), 0.009118992327593785) :- !.
delta(29, depart(Floor, _), 0.00018205030957587593) :- destin(Passenger, Floor), origin(Passenger, Floor2), above(Floor, Floor2), !.
delta(29, depart(Floor, _), -0.023307769062963828) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(29, depart(_, _), 0.032850443012851616) :- !.
delta(29, up(_, Floor), 0.0015041868920996945) :- beyond_above(Floor, Floor2), toward_could_depart(Floor, Floor2), toward_could_board(Floor2, Floor), !.
delta(29, up(_, Floor), -0.05425307414428701) :- beyond_above(Floor, Floor2), toward_could_depart(Floor, Floor2), !.
delta(29, up(_, Floor), -0.02615833533509494) :- beyond_above(Floor, _), done_served(Passenger), destin(Passenger, Floor), !.
delta(29, up(_, Floor), 0.1585188282557978) :- beyond_above(Floor, _), !.
delta(29, up(_, _), -0.060985298134371736) :- !.
delta(29, down(Floor, Floor2), -0.0034858491726724055) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor3), above(Floor2, Floor3), could_board(Floor3), !.
delta(29, down(Floor, Floor2), 0.09973622995660306) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor3), above(Floor2, Floor3), !.
delta(29, down(Floor, _), -0.016610089398695488) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(29, down(Floor, Floor2), 0.03229999089896651) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(29, down(_, _), -0.08886859006169762) :- fewer_lift_at_than_todo_served, !.
delta(29, down(_, _), 0.025127049413077703) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 205 examples, 20 leaves
delta(30, board(_, Passenger), 0.0025410006059807485) :- destin(Passenger, Floor), could_depart(Floor), !.
delta(30, board(Floor, _), 0.00033017048771792054) :- fewer_lift_at_than_todo_served, done_served(Passenger), destin(Passenger, Floor), !.
delta(30, board(_, _), -0.07421792885051293) :- fewer_lift_at_than_todo_served, !.
delta(30, board(_, _), 0.002195852808915889) :- !.
delta(30, depart(_, _), 0.0627829776483988) :- !.
delta(30, up(Floor, Floor2), -0.007356708574016815) :- destin(Passenger, Floor2), origin(Passenger, _), could_board(Floor), !.
delta(30, up(_, Floor), -0.003966479390826917) :- destin(Passenger, Floor), origin(Passenger, _), could_depart(Floor), !.
delta(30, up(_, Floor), 0.0925135568899704) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(30, up(Floor, _), 0.009797222554328324) :- todo_served(Passenger), origin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(30, up(_, _), -0.21339437212449486) :- todo_served(Passenger), origin(Passenger, _), !.
delta(30, up(_, _), 0.03590047940828599) :- goal_served(Passenger), done_served(Passenger), !.
delta(30, up(_, _), -0.004516137685245821) :- !.
delta(30, down(Floor, Floor2), 0.01773421251752665) :- goal_served(Passenger), destin(Passenger, Floor2), goal_served(Passenger2), destin(Passenger2, Floor), toward_could_board(Floor2, Floor), !.
delta(30, down(Floor, Floor2), -0.1049235399447053) :- goal_served(Passenger), destin(Passenger, Floor2), goal_served(Passenger2), destin(Passenger2, Floor), !.
delta(30, down(_, Floor), 0.05063620344898353) :- goal_served(Passenger), destin(Passenger, Floor), todo_served(Passenger), !.
delta(30, down(_, Floor), -0.0029400183204276093) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(30, down(Floor, _), -0.029653269547010596) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(30, down(_, _), 0.20019036282825306) :- fewer_lift_at_than_todo_served, !.
delta(30, down(_, _), -0.012158034556484901) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 205 examples, 21 leaves
delta(31, board(_, Passenger), 0.043926665053890965) :- destin(Passenger, Floor), beyond_above(_, Floor), !.
delta(31, board(_, Passenger), -0.008627705704226916) :- origin(Passenger, Floor), beyond_above(Floor, _), !.
delta(31, board(_, _), 0.0044003519088856675) :- !.
delta(31, depart(Floor, _), 0.02219427161506007) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(31, depart(_, _), 0.005523835983312905) :- todo_served(Passenger), origin(Passenger, Floor), could_depart(Floor), !.
delta(31, depart(_, _), -0.03451853265320746) :- todo_served(Passenger), origin(Passenger, _), !.
delta(31, depart(_, _), 0.008113128058653536) :- !.
delta(31, up(Floor, Floor2), -0.018016618548046596) :- origin(Passenger, Floor2), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(31, up(Floor, Floor2), 0.001088943390927011) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(31, up(Floor, Floor2), -0.003977009027439685) :- fewer_lift_at_than_todo_served, origin(Passenger, Floor), destin(Passenger, Floor2), !.
delta(31, up(_, _), 0.20665663247141877) :- fewer_lift_at_than_todo_served, !.
delta(31, up(_, Floor), 0.014355462753878777) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(31, up(_, _), -0.015334720009461462) :- !.
delta(31, down(_, Floor), -0.006487968069431794) :- destin(Passenger, Floor), origin(Passenger, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), could_depart(Floor), !.
delta(31, down(_, Floor), 0.11460626849009158) :- destin(Passenger, Floor), origin(Passenger, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(31, down(_, Floor), -0.08215166039157729) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(31, down(Floor, _), -0.0004236945189388545) :- fewer_lift_at_than_todo_served, done_served(Passenger), destin(Passenger, Floor), !.
delta(31, down(_, _), -0.25038598962993447) :- fewer_lift_at_than_todo_served, !.
delta(31, down(_, Floor), 0.011728318800725489) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(31, down(_, _), -0.011692207400846439) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 210 examples, 20 leaves
delta(32, board(Floor, _), 0.020365037665893107) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(32, board(Floor, Passenger), 0.0037390547999304365) :- destin(Passenger, Floor2), toward_could_depart(Floor, Floor2), !.
delta(32, board(_, Passenger), -0.027125300218836513) :- destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(32, board(_, _), 0.001702619197777663) :- !.
delta(32, depart(_, _), 0.0645660744929612) :- !.
delta(32, up(Floor, Floor2), -0.01193874406883896) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), todo_served(Passenger), origin(Passenger, Floor), !.
delta(32, up(_, Floor), 0.06070384033137359) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), fewer_lift_at_than_boarded, !.
delta(32, up(_, Floor), -0.0052723759446146965) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(32, up(Floor, _), 0.0059376815205410775) :- done_served(Passenger), destin(Passenger, Floor), todo_served(Passenger2), needed_boarded_to_depart(Passenger2), !.
delta(32, up(Floor, _), -0.005195563946419524) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(32, up(_, Floor), 0.0011560176255421886) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(32, up(_, _), -0.11120743347013208) :- !.
delta(32, down(_, Floor), -0.014802510820190438) :- lift_at(Floor2), toward_could_board(Floor2, Floor), boarded(Passenger), destin(Passenger, Floor), !.
delta(32, down(_, Floor), 0.10356820580384649) :- lift_at(Floor2), toward_could_board(Floor2, Floor), beyond_above(_, Floor), !.
delta(32, down(_, Floor), -0.004441351711352522) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(32, down(Floor, Floor2), -0.014715553666485916) :- lift_at(Floor3), toward_could_board(Floor2, Floor3), goal_served(Passenger), destin(Passenger, Floor), !.
delta(32, down(_, Floor), 0.06922603900864133) :- lift_at(Floor2), toward_could_board(Floor, Floor2), !.
delta(32, down(_, Floor), -0.0013724379350315975) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(32, down(_, _), -0.11990059867957586) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 236 examples, 22 leaves
delta(33, board(_, Passenger), 0.030488096855630337) :- destin(Passenger, Floor), could_depart(Floor), !.
delta(33, board(_, Passenger), 0.005715985824388026) :- fewer_lift_at_than_boarded, destin(Passenger, Floor), origin(_, Floor), !.
delta(33, board(_, _), -0.04759298924391836) :- fewer_lift_at_than_boarded, !.
delta(33, board(_, _), 0.016430390861169705) :- !.
delta(33, depart(Floor, _), -0.04454342270290796) :- lift_at(Floor2), beyond_above(Floor2, Floor3), fewer_lift_at_than_boarded, toward_could_depart(Floor3, Floor), !.
delta(33, depart(_, _), 0.0006563039488763612) :- lift_at(Floor), beyond_above(Floor, _), fewer_lift_at_than_boarded, !.
delta(33, depart(_, _), 0.011821139336147375) :- lift_at(Floor), beyond_above(Floor, _), !.
delta(33, depart(_, _), 0.0199272085819434) :- !.
delta(33, up(Floor, Floor2), 0.01895917857049612) :- could_board_through_destin_back_for_todo_served_1_floor(Floor2), goal_served(Passenger), destin(Passenger, Floor), boarded(Passenger2), destin(Passenger2, Floor2), !.
delta(33, up(Floor, Floor2), -0.007868775302869562) :- could_board_through_destin_back_for_todo_served_1_floor(Floor2), goal_served(Passenger), destin(Passenger, Floor), !.
delta(33, up(_, Floor), -0.05258549138904102) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(33, up(_, Floor), -0.04397954242096029) :- todo_served(Passenger), origin(Passenger, Floor2), above(Floor, Floor2), !.
delta(33, up(_, _), 0.11968222708676417) :- todo_served(Passenger), origin(Passenger, _), !.
delta(33, up(_, _), -0.022505960169118582) :- !.
delta(33, down(Floor, Floor2), 0.011795729298143208) :- todo_served(Passenger), origin(Passenger, Floor2), destin(Passenger, Floor3), above(Floor2, Floor3), toward_could_depart(Floor2, Floor), !.
delta(33, down(_, Floor), -0.18444029059155445) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(33, down(Floor, Floor2), -0.0007047009021891055) :- todo_served(Passenger), origin(Passenger, Floor2), todo_served(Passenger2), origin(Passenger2, Floor), !.
delta(33, down(_, Floor), 0.02204528936558849) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(33, down(Floor, Floor2), -0.040499560044984506) :- origin(Passenger, Floor), destin(Passenger, Floor2), !.
delta(33, down(_, _), 0.21041454988259745) :- fewer_lift_at_than_boarded, !.
delta(33, down(_, _), -0.018431139036984193) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 212 examples, 23 leaves
delta(34, board(Floor, Passenger), -0.04794136371595092) :- destin(Passenger, Floor2), toward_could_depart(Floor, Floor2), beyond_above(Floor, Floor3), could_board(Floor3), !.
delta(34, board(Floor, Passenger), 0.00357806798714952) :- destin(Passenger, Floor2), toward_could_depart(Floor, Floor2), beyond_above(Floor, _), !.
delta(34, board(Floor, Passenger), 0.0024526272371613944) :- destin(Passenger, Floor2), toward_could_depart(Floor, Floor2), !.
delta(34, board(Floor, Passenger), 0.014132920007755295) :- destin(Passenger, Floor2), beyond_above(Floor2, _), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(34, board(_, Passenger), -0.035022447236449504) :- destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(34, board(_, _), 0.04977107867919903) :- !.
delta(34, depart(_, _), 0.017030637133877417) :- !.
delta(34, up(Floor, Floor2), -0.12136084077501555) :- boarded(Passenger), destin(Passenger, Floor2), beyond_above(Floor3, Floor), needed_lift_at_to_depart(Floor3), !.
delta(34, up(Floor, Floor2), 0.03752975072284345) :- boarded(Passenger), destin(Passenger, Floor2), beyond_above(_, Floor), !.
delta(34, up(Floor, Floor2), -0.001318055977421817) :- boarded(Passenger), destin(Passenger, Floor2), boarded(Passenger2), destin(Passenger2, Floor), !.
delta(34, up(_, Floor), 0.024748250911642743) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(34, up(Floor, _), 0.08755168575396928) :- done_served(Passenger), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(34, up(Floor, _), -0.002338233652767391) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(34, up(Floor, _), 0.021490489715581096) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(34, up(_, _), -0.058189504711263884) :- !.
delta(34, down(Floor, Floor2), 0.015859670342908198) :- goal_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor3), toward_could_depart(Floor3, Floor2), !.
delta(34, down(Floor, Floor2), 0.0008016579089192064) :- goal_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor2), !.
delta(34, down(Floor, _), -0.05771110291821558) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(34, down(_, Floor), -0.053223442402604695) :- boarded(Passenger), destin(Passenger, Floor), beyond_above(_, Floor), !.
delta(34, down(_, Floor), 0.014593233255636228) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(34, down(_, Floor), -0.03380460568280337) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(34, down(_, _), 0.13370849263461002) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 236 examples, 23 leaves
delta(35, board(_, _), 0.014843323869326878) :- goal_served(Passenger), done_served(Passenger), !.
delta(35, board(_, Passenger), 0.004979405582537891) :- origin(Passenger, Floor), beyond_above(Floor, _), fewer_lift_at_than_boarded, !.
delta(35, board(_, Passenger), -0.15309985915435323) :- origin(Passenger, Floor), beyond_above(Floor, _), !.
delta(35, board(_, _), 0.0053144854241887135) :- !.
delta(35, depart(Floor, _), 0.0025982842415979987) :- todo_served(Passenger), origin(Passenger, _), origin(Passenger, Floor), !.
delta(35, depart(_, _), -0.05805314032039123) :- todo_served(Passenger), origin(Passenger, _), !.
delta(35, depart(_, _), 0.007438595170760846) :- !.
delta(35, up(Floor, Floor2), -0.03784073242963261) :- beyond_above(Floor2, _), origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(35, up(_, Floor), -0.0044212202346132785) :- beyond_above(Floor, _), fewer_lift_at_than_boarded, !.
delta(35, up(_, Floor), 0.1907813029268355) :- beyond_above(Floor, _), !.
delta(35, up(Floor, Floor2), -0.0004910720621791776) :- destin(Passenger, Floor), origin(Passenger, _), toward_could_board(Floor2, Floor), !.
delta(35, up(Floor, _), 0.021801005736284997) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(35, up(_, _), -0.0688543610003033) :- lift_at(Floor), beyond_above(_, Floor), !.
delta(35, up(_, _), -0.00020496396324316002) :- !.
delta(35, down(_, Floor), 0.00022513599809015372) :- beyond_above(Floor2, Floor), lift_at(Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor3, Floor), could_depart(Floor2), !.
delta(35, down(_, Floor), -0.02382940683752505) :- beyond_above(_, Floor), lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(35, down(_, Floor), -0.013840391673321776) :- beyond_above(_, Floor), lift_at(Floor2), toward_could_board(Floor, Floor2), !.
delta(35, down(_, Floor), 0.1250624855035697) :- beyond_above(_, Floor), !.
delta(35, down(Floor, _), -0.07726949761573827) :- goal_served(Passenger), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(35, down(Floor, _), 0.00020393316317240267) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(35, down(_, Floor), 0.026397563969994795) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(35, down(_, _), -0.008941457684064798) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 228 examples, 26 leaves
delta(36, board(_, _), 0.009394029054004513) :- goal_served(Passenger), done_served(Passenger), destin(Passenger, Floor), needed_lift_at_to_depart(Floor), !.
delta(36, board(Floor, _), -0.031220590017849506) :- goal_served(Passenger), done_served(Passenger), destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(36, board(_, _), 0.0038914546729422067) :- goal_served(Passenger), done_served(Passenger), !.
delta(36, board(Floor, Passenger), 0.04978680927524558) :- destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(36, board(Floor, _), 0.01915527571013364) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(36, board(_, _), -0.02806698932232071) :- !.
delta(36, depart(_, _), 0.02384551640626548) :- goal_served(Passenger), done_served(Passenger), !.
delta(36, depart(_, _), 0.0090049904266019) :- todo_served(Passenger), origin(Passenger, Floor), needed_lift_at_to_depart(Floor), !.
delta(36, depart(_, _), -0.07596318217825315) :- todo_served(Passenger), origin(Passenger, _), !.
delta(36, depart(_, _), 0.0034969345478670045) :- !.
delta(36, up(_, Floor), 0.09793740483941128) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), beyond_above(Floor, Floor3), could_depart(Floor3), !.
delta(36, up(_, Floor), -0.03434827560975224) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), beyond_above(Floor, _), !.
delta(36, up(_, Floor), -0.053250950973233596) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), todo_served(Passenger), needed_boarded_to_depart(Passenger), !.
delta(36, up(_, Floor), 0.015195974941587795) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(36, up(Floor, Floor2), -0.004058869301796561) :- origin(Passenger, Floor2), destin(Passenger, Floor), todo_served(Passenger2), destin(Passenger2, Floor2), !.
delta(36, up(Floor, Floor2), 0.007638505325741294) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(36, up(_, _), -0.14700331608312947) :- !.
delta(36, down(Floor, Floor2), -0.007315647182020113) :- goal_served(Passenger), destin(Passenger, Floor2), origin(Passenger, Floor3), toward_could_board(Floor2, Floor3), above(Floor3, Floor), !.
delta(36, down(_, Floor), 0.057332795639993286) :- goal_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor2), toward_could_board(Floor, Floor2), !.
delta(36, down(_, Floor), -0.09565591498106199) :- goal_served(Passenger), destin(Passenger, Floor), fewer_lift_at_than_boarded, !.
delta(36, down(_, Floor), 0.009997082502149193) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(36, down(_, _), -0.01389175270552405) :- lift_at(Floor), beyond_above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(36, down(_, _), 0.2020800240181811) :- lift_at(Floor), beyond_above(Floor, _), !.
delta(36, down(_, Floor), 0.004895949745328996) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(36, down(_, _), -0.011757644973104291) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 218 examples, 21 leaves
delta(37, board(Floor, Passenger), -0.003984962147772661) :- destin(Passenger, Floor2), toward_could_depart(Floor2, Floor), !.
delta(37, board(_, _), 0.0430824385472724) :- !.
delta(37, depart(Floor, _), 0.0059410383921511024) :- fewer_lift_at_than_boarded, todo_served(Passenger), origin(Passenger, Floor), !.
delta(37, depart(_, _), -0.03593153232165115) :- fewer_lift_at_than_boarded, lift_at(Floor), beyond_above(Floor, _), !.
delta(37, depart(_, _), 0.0019452367518244431) :- fewer_lift_at_than_boarded, !.
delta(37, depart(_, _), 0.012073104619461537) :- !.
delta(37, up(_, Floor), -0.02803699609089805) :- lift_at(Floor2), toward_could_board(Floor2, Floor), boarded(Passenger), destin(Passenger, Floor), fewer_lift_at_than_boarded, !.
delta(37, up(_, Floor), 0.0002649060647108272) :- lift_at(Floor2), toward_could_board(Floor2, Floor), boarded(Passenger), destin(Passenger, Floor), !.
delta(37, up(_, Floor), 0.0670618094691463) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(37, up(Floor, Floor2), 0.016009892975596296) :- boarded(Passenger), destin(Passenger, Floor), boarded(Passenger2), destin(Passenger2, Floor2), !.
delta(37, up(Floor, _), -0.002026841798582404) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(37, up(Floor, _), 0.00014611456538056371) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(37, up(_, _), -0.05571161912406523) :- !.
delta(37, down(Floor, Floor2), -0.016937622146219616) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), todo_served(Passenger), origin(Passenger, Floor), could_board(Floor2), !.
delta(37, down(Floor, Floor2), 0.0036860708562581382) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), todo_served(Passenger), origin(Passenger, Floor), !.
delta(37, down(Floor, Floor2), -0.0005702708613476536) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), done_served(Passenger), destin(Passenger, Floor), !.
delta(37, down(_, Floor), 0.056369265488902254) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(37, down(_, Floor), 0.02512032043365755) :- lift_at(Floor2), toward_could_depart(Floor, Floor2), fewer_lift_at_than_boarded, !.
delta(37, down(_, Floor), -0.01108096764524754) :- lift_at(Floor2), toward_could_depart(Floor, Floor2), !.
delta(37, down(_, _), -0.07137676044246448) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 217 examples, 18 leaves
delta(38, board(Floor, Passenger), 0.005971154542943702) :- destin(Passenger, Floor2), beyond_above(Floor2, Floor3), needed_lift_at_to_depart(Floor3), above(Floor3, Floor), !.
delta(38, board(_, Passenger), -0.08524953073310164) :- destin(Passenger, Floor), beyond_above(Floor, Floor2), needed_lift_at_to_depart(Floor2), !.
delta(38, board(_, Passenger), 0.0052782840907365704) :- destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(38, board(_, _), 0.007306847834550377) :- !.
delta(38, depart(_, _), 0.03139132246056441) :- !.
delta(38, up(Floor, Floor2), 0.003460905475847609) :- beyond_above(Floor2, _), todo_served(Passenger), boarded(Passenger), could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(38, up(_, Floor), -0.2015632674382937) :- beyond_above(Floor, _), todo_served(Passenger), boarded(Passenger), !.
delta(38, up(_, Floor), -0.020118383888456964) :- beyond_above(Floor, Floor2), origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(38, up(_, Floor), 0.08254461961733309) :- beyond_above(Floor, _), !.
delta(38, up(Floor, _), 0.1335625327273571) :- todo_served(Passenger), boarded(Passenger), destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(38, up(_, _), -0.006205783765896141) :- todo_served(Passenger), boarded(Passenger), !.
delta(38, up(Floor, Floor2), 0.011639128145541628) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(38, up(_, _), -0.03346331106539707) :- !.
delta(38, down(_, Floor), -0.0770191480904933) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(38, down(Floor, _), -0.014981039874584842) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(38, down(_, Floor), -0.002945948576747913) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(38, down(_, _), 0.15260824406973872) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 245 examples, 24 leaves
delta(39, board(_, Passenger), -0.005029756768724183) :- origin(Passenger, Floor), could_depart(Floor), fewer_lift_at_than_boarded, !.
delta(39, board(_, Passenger), 0.000330141978848545) :- origin(Passenger, Floor), could_depart(Floor), !.
delta(39, board(_, _), 0.03624638800918451) :- !.
delta(39, depart(_, _), 0.020798247268071186) :- todo_served(Passenger), origin(Passenger, _), !.
delta(39, depart(_, _), 0.0030270786071349373) :- goal_served(Passenger), done_served(Passenger), !.
delta(39, depart(_, _), -0.024610371787964862) :- lift_at(Floor), beyond_above(_, Floor), !.
delta(39, depart(_, _), 0.0009919628507910107) :- !.
delta(39, up(Floor, Floor2), -0.010771701396049495) :- goal_served(Passenger), destin(Passenger, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor2), todo_served(Passenger), !.
delta(39, up(Floor, Floor2), 0.007274582452283118) :- goal_served(Passenger), destin(Passenger, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(39, up(Floor, _), 0.07420914923774147) :- goal_served(Passenger), destin(Passenger, Floor), todo_served(Passenger), !.
delta(39, up(Floor, _), -0.002363042555417675) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(39, up(_, Floor), 0.022842538537925075) :- done_served(Passenger), destin(Passenger, Floor), todo_served(Passenger2), origin(Passenger2, Floor), !.
delta(39, up(_, Floor), -0.008082679937789272) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(39, up(_, Floor), 0.010072163236481057) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(39, up(_, _), -0.0733439583804853) :- !.
delta(39, down(Floor, Floor2), -0.033285646405238276) :- boarded(Passenger), destin(Passenger, Floor2), done_served(Passenger2), destin(Passenger2, Floor), fewer_lift_at_than_todo_served, !.
delta(39, down(Floor, Floor2), 0.001570275473975013) :- boarded(Passenger), destin(Passenger, Floor2), done_served(Passenger2), destin(Passenger2, Floor), !.
delta(39, down(_, Floor), -0.010131265743107104) :- boarded(Passenger), destin(Passenger, Floor), destin(Passenger2, Floor), needed_boarded_to_depart(Passenger2), !.
delta(39, down(_, Floor), 0.07749523393642352) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(39, down(_, Floor), -0.0027996252961887563) :- done_served(Passenger), destin(Passenger, Floor), beyond_above(_, Floor), !.
delta(39, down(_, Floor), 0.012924461355931434) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(39, down(Floor, _), 0.007178768746124061) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(39, down(_, _), -0.08844697448556779) :- !.
delta(39, _, 0.0).

% tree 40: step size 1.0, 210 examples, 18 leaves
delta(40, board(_, Passenger), 0.0028709229902614624) :- destin(Passenger, Floor), beyond_above(Floor, Floor2), could_board(Floor2), could_depart(Floor), !.
delta(40, board(_, Passenger), -0.15244450016524946) :- destin(Passenger, Floor), beyond_above(Floor, Floor2), could_board(Floor2), !.
delta(40, board(_, Passenger), 0.0074957027690870474) :- destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(40, board(_, _), 0.04521858240394232) :- !.
delta(40, depart(_, _), 0.06497773478945645) :- !.
delta(40, up(_, Floor), -0.15745404067213412) :- lift_at(Floor2), toward_could_board(Floor2, Floor), todo_served(Passenger), boarded(Passenger), !.
delta(40, up(_, Floor), -0.006441415922000438) :- lift_at(Floor2), toward_could_board(Floor2, Floor), todo_served(Passenger), destin(Passenger, Floor), !.
delta(40, up(_, Floor), 0.011468027289364701) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(40, up(_, _), 0.24869897688445275) :- todo_served(Passenger), origin(Passenger, _), fewer_lift_at_than_todo_served, !.
delta(40, up(_, _), -0.0040190423032662) :- todo_served(Passenger), origin(Passenger, _), !.
delta(40, up(_, Floor), 0.011054821232856454) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(40, up(_, _), -0.03608933814296433) :- !.
delta(40, down(Floor, Floor2), 0.007132459162785119) :- todo_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor2), !.
delta(40, down(Floor, _), -0.12657252242655004) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(40, down(_, Floor), -0.016053906721873498) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(40, down(_, Floor), -0.005147968378657535) :- lift_at(Floor2), toward_could_board(Floor, Floor2), !.
delta(40, down(_, _), 0.09059043648869403) :- !.
delta(40, _, 0.0).

% tree 41: step size 1.0, 206 examples, 22 leaves
delta(41, board(Floor, Passenger), 0.00028907540453082997) :- destin(Passenger, Floor2), beyond_above(Floor2, Floor3), toward_could_depart(Floor2, Floor), needed_lift_at_to_depart(Floor3), !.
delta(41, board(Floor, Passenger), -0.004791213516647126) :- destin(Passenger, Floor2), beyond_above(Floor2, _), toward_could_depart(Floor2, Floor), !.
delta(41, board(_, Passenger), 0.04927344812265086) :- destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(41, board(_, _), -0.015192894850093279) :- fewer_lift_at_than_boarded, !.
delta(41, board(_, _), 0.00427393753296787) :- !.
delta(41, depart(Floor, _), 0.0026283951743590397) :- goal_served(Passenger), done_served(Passenger), destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(41, depart(_, _), 0.0002766693097291708) :- goal_served(Passenger), done_served(Passenger), destin(Passenger, Floor), could_depart(Floor), !.
delta(41, depart(_, _), -0.04122795868298324) :- goal_served(Passenger), done_served(Passenger), !.
delta(41, depart(_, _), 0.01698892827764909) :- !.
delta(41, up(Floor, _), 0.03716810271311423) :- boarded(Passenger), destin(Passenger, Floor), todo_served(Passenger2), needed_boarded_to_depart(Passenger2), fewer_lift_at_than_boarded, !.
delta(41, up(Floor, _), -0.002293738449009569) :- boarded(Passenger), destin(Passenger, Floor), todo_served(Passenger2), needed_boarded_to_depart(Passenger2), !.
delta(41, up(Floor, _), -0.0033390810862514763) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(41, up(Floor, Floor2), 0.03961388540200731) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), goal_served(Passenger), destin(Passenger, Floor), !.
delta(41, up(_, Floor), -0.01956983682348114) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(41, up(_, _), -0.07708522631307872) :- !.
delta(41, down(Floor, Floor2), 0.0003837460114376143) :- could_board_through_destin_back_for_todo_served_1_floor(Floor2), done_served(Passenger), destin(Passenger, Floor), !.
delta(41, down(_, Floor), -0.06461807719954302) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(41, down(Floor, Floor2), 0.016072676665039073) :- done_served(Passenger), destin(Passenger, Floor2), todo_served(Passenger2), destin(Passenger2, Floor), !.
delta(41, down(_, Floor), -0.03982623066188457) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(41, down(_, Floor), -0.014363056586760318) :- lift_at(Floor2), toward_could_board(Floor, Floor2), !.
delta(41, down(_, _), 0.10000943862454373) :- !.
delta(41, _, 0.0).

% tree 42: step size 1.0, 220 examples, 25 leaves
delta(42, board(_, Passenger), 0.01151400528570262) :- destin(Passenger, Floor), beyond_above(Floor, Floor2), origin(Passenger, Floor2), !.
delta(42, board(_, Passenger), -0.12954001393816036) :- destin(Passenger, Floor), beyond_above(Floor, Floor2), needed_lift_at_to_depart(Floor2), !.
delta(42, board(_, Passenger), 0.0037229800430086685) :- destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(42, board(_, _), 0.019498002331242267) :- !.
delta(42, depart(Floor, _), -0.030405038656959916) :- destin(Passenger, Floor), origin(Passenger, Floor2), above(Floor, Floor2), !.
delta(42, depart(Floor, _), 0.0009389249458073615) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(42, depart(_, _), 0.024665287700315383) :- lift_at(Floor), beyond_above(_, Floor), !.
delta(42, depart(_, _), -0.008434213760560104) :- todo_served(Passenger), origin(Passenger, _), !.
delta(42, depart(_, _), 0.0012429992606907778) :- !.
delta(42, up(_, Floor), 0.02952111997561741) :- goal_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor2), above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(42, up(_, Floor), -0.013322186375844295) :- goal_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor2), above(Floor, Floor2), !.
delta(42, up(_, Floor), -0.0949320672891534) :- goal_served(Passenger), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(42, up(_, Floor), 0.005965638840885616) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(42, up(_, Floor), 0.13162611218494624) :- todo_served(Passenger), origin(Passenger, Floor2), above(Floor, Floor2), !.
delta(42, up(_, _), -0.00524575503929188) :- todo_served(Passenger), origin(Passenger, _), !.
delta(42, up(_, _), -0.006793895136848471) :- !.
delta(42, down(_, Floor), 0.0006954599010090578) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), lift_at(Floor2), beyond_above(Floor2, Floor3), could_board_through_destin_back_for_todo_served_1_floor(Floor3), !.
delta(42, down(_, Floor), -0.060177899717010555) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), lift_at(Floor2), beyond_above(Floor2, _), !.
delta(42, down(_, Floor), -0.0005033550930242226) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), goal_served(Passenger), done_served(Passenger), !.
delta(42, down(_, Floor), 0.0006533285396297639) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(42, down(_, _), 0.11360718114934286) :- lift_at(Floor), beyond_above(Floor, _), fewer_lift_at_than_todo_served, !.
delta(42, down(_, _), -0.002301653252563726) :- lift_at(Floor), beyond_above(Floor, _), !.
delta(42, down(_, Floor), 0.001789884750647045) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(42, down(_, _), -0.011327204891572601) :- !.
delta(42, _, 0.0).

% tree 43: step size 1.0, 205 examples, 22 leaves
delta(43, board(Floor, Passenger), 0.019747309047551852) :- destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(43, board(Floor, _), 0.005189712078472216) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(43, board(Floor, _), 0.002592262460939952) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(43, board(_, _), -0.06044345114615907) :- !.
delta(43, depart(_, _), 0.019703903853164555) :- lift_at(Floor), beyond_above(Floor, Floor2), needed_lift_at_to_depart(Floor2), !.
delta(43, depart(_, _), -0.07007693164882667) :- lift_at(Floor), beyond_above(Floor, _), fewer_lift_at_than_boarded, !.
delta(43, depart(_, _), 0.0009062699660379736) :- lift_at(Floor), beyond_above(Floor, _), !.
delta(43, depart(_, _), 0.020460115486608674) :- !.
delta(43, up(_, Floor), -0.19216923122099058) :- boarded(Passenger), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(43, up(_, Floor), 0.008839675283033206) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(43, up(Floor, _), -0.01600209003005846) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(43, up(_, _), 0.17679874767635595) :- todo_served(Passenger), origin(Passenger, _), !.
delta(43, up(_, _), -0.011343586140771394) :- !.
delta(43, down(_, Floor), 0.00695076742079708) :- todo_served(Passenger), destin(Passenger, Floor), beyond_above(Floor2, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(43, down(_, Floor), -0.08635150647148764) :- todo_served(Passenger), destin(Passenger, Floor), beyond_above(_, Floor), !.
delta(43, down(Floor, Floor2), -0.004611819094176875) :- todo_served(Passenger), destin(Passenger, Floor2), todo_served(Passenger2), destin(Passenger2, Floor), !.
delta(43, down(_, Floor), 0.028143016269285878) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(43, down(Floor, Floor2), -0.007895982075826384) :- fewer_lift_at_than_todo_served, origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(43, down(_, _), 0.1393457955899527) :- fewer_lift_at_than_todo_served, !.
delta(43, down(_, Floor), 0.003625383192370725) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(43, down(_, _), -0.012519113835773494) :- !.
delta(43, _, 0.0).

% tree 44: step size 1.0, 217 examples, 22 leaves
delta(44, board(Floor, Passenger), -0.04992713126830556) :- destin(Passenger, Floor2), toward_could_depart(Floor, Floor2), beyond_above(Floor, Floor3), could_board(Floor3), !.
delta(44, board(Floor, Passenger), 0.0004652229199296943) :- destin(Passenger, Floor2), toward_could_depart(Floor, Floor2), beyond_above(Floor, _), !.
delta(44, board(Floor, Passenger), 0.00191058780306404) :- destin(Passenger, Floor2), toward_could_depart(Floor, Floor2), !.
delta(44, board(_, _), 0.040638701170369565) :- !.
delta(44, depart(Floor, _), 0.004794957287160883) :- todo_served(Passenger), origin(Passenger, Floor2), toward_could_depart(Floor2, Floor), above(Floor, Floor2), !.
delta(44, depart(Floor, _), -0.06376147187434238) :- todo_served(Passenger), origin(Passenger, Floor2), toward_could_depart(Floor2, Floor), !.
delta(44, depart(_, _), 0.0051908710966656136) :- todo_served(Passenger), origin(Passenger, _), !.
delta(44, depart(_, _), 0.007641219098256799) :- !.
delta(44, up(Floor, Floor2), 0.03853999259566008) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(44, up(_, Floor), -0.05362571346824394) :- lift_at(Floor2), toward_could_board(Floor2, Floor), todo_served(Passenger), boarded(Passenger), !.
delta(44, up(_, Floor), 0.0038179180338954125) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(44, up(_, Floor), -0.02169404894193012) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(44, up(_, _), 0.1545151543970265) :- lift_at(Floor), beyond_above(_, Floor), !.
delta(44, up(_, _), -0.008191516497631961) :- !.
delta(44, down(_, Floor), 0.0646596596962742) :- goal_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor2), toward_could_depart(Floor2, Floor), fewer_lift_at_than_boarded, !.
delta(44, down(_, Floor), -0.004164387409123942) :- goal_served(Passenger), destin(Passenger, Floor), origin(Passenger, Floor2), toward_could_depart(Floor2, Floor), !.
delta(44, down(_, Floor), -0.20307888218232834) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(44, down(_, Floor), 0.14157994525380996) :- beyond_above(Floor2, Floor), goal_served(Passenger), destin(Passenger, Floor2), !.
delta(44, down(_, Floor), -0.03921315067192446) :- beyond_above(_, Floor), !.
delta(44, down(Floor, Floor2), 0.005568835302860767) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(44, down(_, _), -0.029088214708667667) :- !.
delta(44, _, 0.0).

% tree 45: step size 1.0, 243 examples, 18 leaves
delta(45, board(Floor, Passenger), 0.0028156377796871848) :- destin(Passenger, Floor2), toward_could_depart(Floor2, Floor), goal_served(Passenger2), done_served(Passenger2), !.
delta(45, board(Floor, Passenger), -0.020350135045160617) :- destin(Passenger, Floor2), toward_could_depart(Floor2, Floor), !.
delta(45, board(_, _), 0.0036634912210979412) :- goal_served(Passenger), done_served(Passenger), destin(Passenger, Floor), needed_lift_at_to_depart(Floor), !.
delta(45, board(_, _), -0.008956241531242623) :- goal_served(Passenger), done_served(Passenger), !.
delta(45, board(_, _), 0.03347573613092256) :- !.
delta(45, depart(_, _), 0.036641753005766386) :- !.
delta(45, up(_, Floor), -0.008683461282546446) :- lift_at(Floor2), toward_could_board(Floor2, Floor), destin(Passenger, Floor), needed_boarded_to_depart(Passenger), !.
delta(45, up(_, Floor), -0.005231244470047343) :- lift_at(Floor2), toward_could_board(Floor2, Floor), fewer_lift_at_than_boarded, !.
delta(45, up(_, Floor), 0.0359172772498926) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(45, up(_, _), -0.0814000343710872) :- !.
delta(45, down(_, Floor), -0.02533621152007921) :- fewer_lift_at_than_boarded, could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(45, down(_, Floor), -0.006882920885370806) :- fewer_lift_at_than_boarded, lift_at(Floor2), toward_could_depart(Floor, Floor2), !.
delta(45, down(_, _), 0.07930571087419537) :- fewer_lift_at_than_boarded, !.
delta(45, down(_, Floor), 0.010787431396335277) :- fewer_lift_at_than_todo_served, lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(45, down(_, _), -0.0626930625487932) :- fewer_lift_at_than_todo_served, !.
delta(45, down(Floor, _), -0.01457346371019622) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(45, down(_, _), 0.031146199035191505) :- !.
delta(45, _, 0.0).

% tree 46: step size 1.0, 205 examples, 24 leaves
delta(46, board(_, _), 0.007217969702243048) :- goal_served(Passenger), done_served(Passenger), !.
delta(46, board(_, Passenger), 0.0162743073684242) :- origin(Passenger, Floor), beyond_above(Floor, Floor2), could_depart(Floor2), !.
delta(46, board(_, Passenger), -0.04375882151932298) :- origin(Passenger, Floor), beyond_above(Floor, _), !.
delta(46, board(_, _), 0.003341472721584622) :- !.
delta(46, depart(Floor, _), 0.0072662043100277345) :- fewer_lift_at_than_boarded, done_served(Passenger), destin(Passenger, Floor), !.
delta(46, depart(Floor, _), 0.0031076582238429304) :- fewer_lift_at_than_boarded, destin(Passenger, Floor), origin(Passenger, _), !.
delta(46, depart(_, _), -0.04319466997110018) :- fewer_lift_at_than_boarded, !.
delta(46, depart(_, _), 0.009466349583328381) :- !.
delta(46, up(Floor, Floor2), 0.04112237204057417) :- destin(Passenger, Floor2), origin(Passenger, Floor3), toward_could_depart(Floor, Floor3), could_depart(Floor2), !.
delta(46, up(Floor, Floor2), -0.005718330133094002) :- destin(Passenger, Floor2), origin(Passenger, Floor3), toward_could_depart(Floor, Floor3), !.
delta(46, up(Floor, Floor2), 0.007209850828866942) :- destin(Passenger, Floor2), origin(Passenger, Floor3), above(Floor3, Floor), !.
delta(46, up(_, Floor), -0.11470682361069282) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(46, up(Floor, Floor2), 0.0025517814941945593) :- lift_at(Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor3, Floor2), goal_served(Passenger), destin(Passenger, Floor), !.
delta(46, up(_, Floor), -0.05518620304613072) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(46, up(_, Floor), 0.16871685248962282) :- beyond_above(Floor, _), !.
delta(46, up(_, _), -0.020101517104284115) :- !.
delta(46, down(Floor, Floor2), -0.02521125907438838) :- goal_served(Passenger), destin(Passenger, Floor2), todo_served(Passenger2), origin(Passenger2, Floor), !.
delta(46, down(_, Floor), 0.08590973042208828) :- goal_served(Passenger), destin(Passenger, Floor), beyond_above(_, Floor), !.
delta(46, down(_, Floor), -0.01179415862774391) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(46, down(Floor, _), -0.005062241133377175) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(46, down(Floor, _), 0.05192898974319684) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(46, down(Floor, _), 0.0184460601685221) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(46, down(_, _), -0.12054240276834348) :- !.
delta(46, _, 0.0).

% tree 47: step size 1.0, 229 examples, 23 leaves
delta(47, board(Floor, _), 0.04301701048094029) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(47, board(Floor, _), -0.08867895365817476) :- todo_served(Passenger), boarded(Passenger), destin(Passenger, Floor2), toward_could_board(Floor2, Floor), !.
delta(47, board(_, _), 0.0011356967344553915) :- todo_served(Passenger), boarded(Passenger), !.
delta(47, board(_, Passenger), -0.004715937381637297) :- destin(Passenger, Floor), origin(_, Floor), !.
delta(47, board(_, _), 0.00841349062987209) :- !.
delta(47, depart(_, _), 0.00103859976659253) :- fewer_lift_at_than_boarded, lift_at(Floor), beyond_above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(47, depart(_, _), -0.06996199516595404) :- fewer_lift_at_than_boarded, lift_at(Floor), beyond_above(Floor, _), !.
delta(47, depart(_, _), 0.0016657119669056498) :- fewer_lift_at_than_boarded, !.
delta(47, depart(_, _), 0.004700458074296753) :- !.
delta(47, up(_, Floor), 0.0444735128277024) :- lift_at(Floor2), toward_could_board(Floor2, Floor), boarded(Passenger), destin(Passenger, Floor), !.
delta(47, up(_, Floor), -0.20757354557544008) :- lift_at(Floor2), toward_could_board(Floor2, Floor), beyond_above(Floor, _), !.
delta(47, up(_, Floor), 0.016317930137180844) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(47, up(_, Floor), -0.03602537225937905) :- done_served(Passenger), destin(Passenger, Floor), beyond_above(Floor, _), !.
delta(47, up(_, Floor), 0.009253380158682408) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(47, up(Floor, Floor2), -0.010035269965619088) :- origin(Passenger, Floor), destin(Passenger, Floor2), !.
delta(47, up(_, _), 0.15693092310196513) :- !.
delta(47, down(Floor, Floor2), -0.03609894290843892) :- origin(Passenger, Floor2), destin(Passenger, Floor), destin(Passenger2, Floor2), needed_boarded_to_depart(Passenger2), !.
delta(47, down(Floor, Floor2), 0.0028800577719646494) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(47, down(Floor, Floor2), 0.026805808427149233) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), beyond_above(Floor, _), !.
delta(47, down(_, Floor), -0.039130099027781834) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(47, down(_, _), 0.16328479420900205) :- fewer_lift_at_than_todo_served, !.
delta(47, down(_, _), -0.007871270187033494) :- !.
delta(47, _, 0.0).

% tree 48: step size 1.0, 220 examples, 21 leaves
delta(48, board(_, _), 0.04163862839889272) :- !.
delta(48, depart(Floor, _), -0.008579483271876466) :- goal_served(Passenger), done_served(Passenger), destin(Passenger2, Floor), needed_boarded_to_depart(Passenger2), !.
delta(48, depart(_, _), 0.0066674952702991536) :- goal_served(Passenger), done_served(Passenger), !.
delta(48, depart(_, _), 0.019759313652259525) :- !.
delta(48, up(Floor, Floor2), 0.0170756298314025) :- boarded(Passenger), destin(Passenger, Floor2), todo_served(Passenger2), needed_boarded_to_depart(Passenger2), destin(Passenger2, Floor), !.
delta(48, up(_, Floor), -0.14342288236238296) :- boarded(Passenger), destin(Passenger, Floor), todo_served(Passenger2), needed_boarded_to_depart(Passenger2), !.
delta(48, up(Floor, Floor2), -0.0004153999249522336) :- boarded(Passenger), destin(Passenger, Floor2), todo_served(Passenger2), destin(Passenger2, Floor), !.
delta(48, up(_, Floor), 0.02564963015657587) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(48, up(_, _), 0.13886805619853293) :- fewer_lift_at_than_boarded, todo_served(Passenger), origin(Passenger, _), !.
delta(48, up(_, _), -0.00584900287565997) :- fewer_lift_at_than_boarded, !.
delta(48, up(_, Floor), -0.08314005054995538) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(48, up(_, _), 0.007283193481884) :- !.
delta(48, down(Floor, Floor2), -0.002192385928831007) :- goal_served(Passenger), destin(Passenger, Floor2), beyond_above(Floor, _), could_board(Floor), !.
delta(48, down(Floor, Floor2), 0.16252880137787765) :- goal_served(Passenger), destin(Passenger, Floor2), beyond_above(Floor, _), !.
delta(48, down(_, Floor), -0.021384561327098654) :- goal_served(Passenger), destin(Passenger, Floor), todo_served(Passenger2), needed_boarded_to_depart(Passenger2), !.
delta(48, down(_, Floor), 0.0021418557125218968) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(48, down(Floor, _), 0.00237813254709552) :- lift_at(Floor2), beyond_above(Floor2, _), could_board(Floor), !.
delta(48, down(_, _), -0.15200791633351282) :- lift_at(Floor), beyond_above(Floor, _), !.
delta(48, down(_, Floor), 0.019120350429350834) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(48, down(_, _), -0.006899415277307049) :- !.
delta(48, _, 0.0).

% tree 49: step size 1.0, 212 examples, 26 leaves
delta(49, board(_, Passenger), -0.013417637060868234) :- origin(Passenger, Floor), beyond_above(Floor2, Floor), destin(Passenger, Floor2), fewer_lift_at_than_boarded, !.
delta(49, board(_, Passenger), 0.005417640034799256) :- origin(Passenger, Floor), beyond_above(Floor2, Floor), destin(Passenger, Floor2), !.
delta(49, board(_, Passenger), 0.04153225962568737) :- origin(Passenger, Floor), beyond_above(_, Floor), !.
delta(49, board(Floor, Passenger), 0.0001777679306513527) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), goal_served(Passenger2), done_served(Passenger2), !.
delta(49, board(Floor, Passenger), -0.07972056154994656) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(49, board(_, _), 0.0019217442013297322) :- !.
delta(49, depart(Floor, _), 0.007228061121024311) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(49, depart(_, _), -0.03431292655472442) :- fewer_lift_at_than_boarded, todo_served(Passenger), origin(Passenger, _), !.
delta(49, depart(_, _), 0.003775992729980962) :- fewer_lift_at_than_boarded, !.
delta(49, depart(_, _), 0.005221638486172394) :- !.
delta(49, up(Floor, Floor2), 0.024715381430320635) :- goal_served(Passenger), destin(Passenger, Floor2), done_served(Passenger2), destin(Passenger2, Floor), todo_served(Passenger), !.
delta(49, up(Floor, Floor2), -0.0012838067165322356) :- goal_served(Passenger), destin(Passenger, Floor2), done_served(Passenger2), destin(Passenger2, Floor), !.
delta(49, up(Floor, Floor2), 0.022340487867315413) :- goal_served(Passenger), destin(Passenger, Floor2), origin(Passenger, Floor3), toward_could_depart(Floor3, Floor), !.
delta(49, up(_, Floor), -0.07261478944370937) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(49, up(Floor, _), -0.005906685131835022) :- fewer_lift_at_than_todo_served, done_served(Passenger), destin(Passenger, Floor), !.
delta(49, up(_, _), 0.18274996442775626) :- fewer_lift_at_than_todo_served, !.
delta(49, up(_, Floor), 0.002697649535542204) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(49, up(_, _), -0.009998338961680779) :- !.
delta(49, down(Floor, Floor2), 0.08232675136398288) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor3), above(Floor2, Floor3), could_board(Floor2), !.
delta(49, down(Floor, Floor2), -0.0039549661163584045) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor3), above(Floor2, Floor3), !.
delta(49, down(Floor, _), -0.056245767653265034) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(49, down(_, Floor), 0.015155423019188676) :- beyond_above(Floor2, Floor), lift_at(Floor3), toward_could_depart(Floor3, Floor2), !.
delta(49, down(_, Floor), -0.16416883365326804) :- beyond_above(_, Floor), !.
delta(49, down(_, Floor), -0.02165201914715341) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(49, down(_, _), 0.05054918404860066) :- !.
delta(49, _, 0.0).

% tree 50: step size 1.0, 216 examples, 24 leaves
delta(50, board(Floor, Passenger), -0.011413995829317137) :- destin(Passenger, Floor2), above(Floor, Floor2), origin(Passenger, Floor3), could_depart(Floor3), !.
delta(50, board(Floor, Passenger), 0.052301814886631305) :- destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(50, board(_, _), 0.005356583280327954) :- fewer_lift_at_than_boarded, !.
delta(50, board(_, Passenger), -0.07190130662492031) :- origin(Passenger, Floor), beyond_above(Floor, _), !.
delta(50, board(_, _), 0.0027720165156766507) :- !.
delta(50, depart(Floor, _), 0.011836538325110196) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(50, depart(Floor, _), 0.006227091743449707) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(50, depart(_, _), -0.0206890752261462) :- goal_served(Passenger), done_served(Passenger), !.
delta(50, depart(_, _), 0.0036787353004370566) :- !.
delta(50, up(Floor, Floor2), -0.00943741348269816) :- lift_at(Floor3), toward_could_board(Floor2, Floor3), origin(Passenger, Floor), destin(Passenger, Floor2), !.
delta(50, up(_, Floor), -0.0011391663067736413) :- lift_at(Floor2), toward_could_board(Floor, Floor2), goal_served(Passenger), done_served(Passenger), !.
delta(50, up(_, Floor), 0.05255703225764898) :- lift_at(Floor2), toward_could_board(Floor, Floor2), !.
delta(50, up(_, Floor), -0.008592848743990843) :- lift_at(Floor2), toward_could_depart(Floor, Floor2), beyond_above(Floor, _), !.
delta(50, up(_, Floor), 0.025400474212898025) :- lift_at(Floor2), toward_could_depart(Floor, Floor2), !.
delta(50, up(_, Floor), 0.004451879657407188) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(50, up(_, _), -0.10651850721017707) :- !.
delta(50, down(Floor, Floor2), -0.0509639383608119) :- boarded(Passenger), destin(Passenger, Floor2), todo_served(Passenger2), destin(Passenger2, Floor), !.
delta(50, down(_, Floor), -0.011118563290583515) :- boarded(Passenger), destin(Passenger, Floor), destin(Passenger2, Floor), needed_boarded_to_depart(Passenger2), !.
delta(50, down(_, Floor), 0.031216656269486224) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(50, down(Floor, Floor2), 0.005864916626947922) :- lift_at(Floor3), could_board_through_destin_back_for_todo_served_1_floor(Floor3), origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(50, down(_, _), -0.013506995029879194) :- lift_at(Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(50, down(_, Floor), -0.005148260820480012) :- lift_at(Floor2), toward_could_board(Floor, Floor2), !.
delta(50, down(_, _), 0.11351945534327276) :- !.
delta(50, _, 0.0).
