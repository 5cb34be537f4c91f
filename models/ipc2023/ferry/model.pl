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
model(domain_sha256, fdfcf6a03a1e264e54e25af4b28d57411d4dc74f690c9913bc3ba24d31b6671c).
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
model(literal, could_board(location)).
model(literal, could_board_for_todo_at_any_location(location)).
model(literal, could_board_for_todo_at_car_any(location)).
model(literal, could_debark(location)).
model(literal, could_debark_todo_at(location)).
model(literal, could_debark_for_todo_at_any_location(location)).
model(bias, 'ferry.yaml').
model(bias_sha256, '127868d5fec2b0aa6620df6628df84148df25b3de66572d298be0ee1988e1639').
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
model(trained_episodes, 1067).
model(trees, 108).

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

% tree 1: step size 1.0, 211 examples, 3 leaves
delta(1, board(_, _), 0.18171487016307752) :- !.
delta(1, _, -0.18171487016307752) :- at_ferry(Location), at(_, Location), !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 216 examples, 6 leaves
delta(2, board(_, _), 0.5879779153236214) :- !.
delta(2, _, -0.5879779153236214) :- at_ferry(Location), at(_, Location), !.
delta(2, sail(_, Location), 0.8704230206469891) :- todo_at(Car, Location), on(Car), !.
delta(2, sail(_, _), -0.44449231519711657) :- !.
delta(2, _, 0.5259437003380716) :- at_ferry(Location), todo_at(_, Location), !.
delta(2, _, -0.7061590221178695).

% tree 3: step size 1.0, 206 examples, 6 leaves
delta(3, board(_, _), 0.3007522641732022) :- !.
delta(3, _, -0.3007522641732022) :- at_ferry(Location), at(_, Location), !.
delta(3, sail(_, Location), 0.7372243912845123) :- at(_, Location), !.
delta(3, sail(_, _), -0.48177110354779945) :- !.
delta(3, _, 0.3136301076602437) :- at_ferry(Location), todo_at(_, Location), !.
delta(3, _, -0.2840890564117877).

% tree 4: step size 1.0, 202 examples, 6 leaves
delta(4, board(_, _), 0.24492441943694732) :- !.
delta(4, _, -0.24492441943694732) :- at_ferry(Location), at(_, Location), !.
delta(4, sail(_, Location), 0.5216635241897081) :- at(_, Location), !.
delta(4, sail(_, _), -0.31471523751299196) :- !.
delta(4, _, 0.21573326277070612) :- at_ferry(Location), todo_at(_, Location), !.
delta(4, _, -0.26232900732175757).

% tree 5: step size 1.0, 203 examples, 6 leaves
delta(5, board(_, _), 0.21222847243737092) :- !.
delta(5, _, -0.21222847243737092) :- at_ferry(Location), at(_, Location), !.
delta(5, sail(_, Location), 0.49693786548551244) :- todo_at(Car, Location), on(Car), !.
delta(5, sail(_, _), -0.2525691687374702) :- !.
delta(5, _, 0.16862563206664857) :- at_ferry(Location), todo_at(_, Location), !.
delta(5, _, -0.2874803053287563).

% tree 6: step size 1.0, 203 examples, 6 leaves
delta(6, board(_, _), 0.15795982621075977) :- !.
delta(6, _, -0.15795982621075977) :- at_ferry(Location), at(_, Location), !.
delta(6, sail(_, Location), 0.4281029468533561) :- at(_, Location), !.
delta(6, sail(_, _), -0.25744106586846727) :- !.
delta(6, _, 0.13306678972775274) :- at_ferry(Location), todo_at(_, Location), !.
delta(6, _, -0.18556215292544115).

% tree 7: step size 1.0, 205 examples, 6 leaves
delta(7, board(_, _), 0.14664506321697057) :- !.
delta(7, _, -0.14664506321697057) :- at_ferry(Location), at(_, Location), !.
delta(7, sail(_, Location), 0.39060703248273776) :- todo_at(Car, Location), on(Car), !.
delta(7, sail(_, _), -0.19982015193683259) :- !.
delta(7, _, 0.10608894456530213) :- at_ferry(Location), todo_at(_, Location), !.
delta(7, _, -0.2257060004716742).

% tree 8: step size 1.0, 220 examples, 6 leaves
delta(8, debark(Car, Location), 0.15827064381294537) :- todo_at(Car, Location), !.
delta(8, debark(_, _), -0.2821136320384326) :- !.
delta(8, _, -0.15827064381294534) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(8, _, 0.20260311698898958) :- at_ferry(Location), could_debark(Location), !.
delta(8, sail(_, _), -0.016320200961561445) :- !.
delta(8, _, 0.023756670486061053).

% tree 9: step size 1.0, 203 examples, 8 leaves
delta(9, board(Car, _), 0.1383984173022401) :- todo_at(Car, _), !.
delta(9, board(_, _), -0.403953453540467) :- !.
delta(9, sail(Location, _), -0.07163110967524745) :- at_ferry(Location2), done_at(_, Location2), todo_at(Car, Location), on(Car), !.
delta(9, sail(_, _), 0.37644519748619704) :- at_ferry(Location), done_at(_, Location), !.
delta(9, _, -0.04388719134505574) :- at_ferry(Location), done_at(_, Location), !.
delta(9, _, -0.14671132221427685) :- at_ferry(Location), could_board(Location), !.
delta(9, sail(_, _), -0.01776937932480286) :- !.
delta(9, _, 0.03845080134343389).

% tree 10: step size 1.0, 211 examples, 8 leaves
delta(10, sail(_, Location), -0.04487865566416489) :- could_board_for_todo_at_car_any(Location), todo_at(_, Location), !.
delta(10, sail(_, Location), -0.009400266866835379) :- could_board_for_todo_at_car_any(Location), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(10, sail(_, Location), 0.8447340823469093) :- could_board_for_todo_at_car_any(Location), !.
delta(10, sail(_, Location), 0.7099951207239068) :- todo_at(Car, Location), on(Car), !.
delta(10, sail(_, _), -0.8504260565888753) :- !.
delta(10, _, 0.40078486017035037) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(10, _, 0.09721614476694261) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(10, _, -0.8194589412656492).

% tree 11: step size 1.0, 202 examples, 9 leaves
delta(11, board(Car, _), 0.16309726912364061) :- todo_at(Car, _), !.
delta(11, board(_, _), -0.8269607875786132) :- !.
delta(11, _, -0.002864614466357609) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), goal_at(Car, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(11, _, 0.7341366234243185) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(11, sail(_, _), -0.03670095568488038) :- at_ferry(Location), done_at(_, Location), !.
delta(11, _, 0.0383118307962916) :- at_ferry(Location), done_at(_, Location), !.
delta(11, _, -0.06896702445898625) :- at_ferry(Location), could_board(Location), !.
delta(11, sail(_, _), -0.0126554426052301) :- !.
delta(11, _, 0.020444734870650873).

% tree 12: step size 1.0, 220 examples, 9 leaves
delta(12, board(Car, _), 0.11003103942697126) :- todo_at(Car, _), !.
delta(12, board(_, _), -0.44387772717189833) :- !.
delta(12, _, -0.0029495575775729263) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), goal_at(Car, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(12, _, 0.37859458574520644) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(12, sail(_, _), -0.10134306657621568) :- at_ferry(Location), done_at(_, Location), !.
delta(12, _, 0.10886164614900969) :- at_ferry(Location), done_at(_, Location), !.
delta(12, _, -0.05356142197374826) :- at_ferry(Location), could_board(Location), !.
delta(12, sail(_, _), -0.00905489945877625) :- !.
delta(12, _, 0.015629471026253127).

% tree 13: step size 1.0, 203 examples, 9 leaves
delta(13, board(Car, _), 0.11145850704790575) :- todo_at(Car, _), !.
delta(13, board(_, _), -0.30861776750006215) :- !.
delta(13, _, -0.0035714805841325684) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), goal_at(Car, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(13, _, 0.2424309181952254) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(13, sail(_, _), -0.051208226187301635) :- at_ferry(Location), done_at(_, Location), !.
delta(13, _, 0.054700339159036875) :- at_ferry(Location), done_at(_, Location), !.
delta(13, _, -0.0602370753543539) :- at_ferry(Location), could_board(Location), !.
delta(13, sail(_, _), -0.0029908493135845497) :- !.
delta(13, _, 0.0050923858087439985).

% tree 14: step size 1.0, 215 examples, 10 leaves
delta(14, board(Car, Location), 0.04419507110177886) :- goal_at(Car2, Location), done_at(Car2, Location2), could_board_for_todo_at_car_any(Location2), todo_at(Car, _), !.
delta(14, board(_, Location), -0.03987412272347892) :- goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(14, board(Car, Location), 0.0027227652505158297) :- goal_at(Car2, Location), todo_at(Car, Location2), at(Car2, Location2), !.
delta(14, board(_, Location), -0.3094798305060552) :- goal_at(_, Location), !.
delta(14, board(_, _), 0.05560227195822085) :- !.
delta(14, _, 0.22841348357286273) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(14, sail(_, Location), 0.47020754607198734) :- todo_at(Car, Location), on(Car), !.
delta(14, sail(_, _), -0.38494213637114416) :- !.
delta(14, _, 0.4066038519789165) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(14, _, -0.2367195602892244).

% tree 15: step size 1.0, 201 examples, 10 leaves
delta(15, board(Car, _), 0.09349132112840733) :- todo_at(Car, _), !.
delta(15, board(_, _), -0.3146771762727316) :- !.
delta(15, _, -0.0047775587583827606) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), goal_at(Car, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(15, _, 0.22255979604097997) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(15, sail(_, _), -0.015169222067885643) :- at_ferry(Location), done_at(_, Location), !.
delta(15, _, 0.01639366416608815) :- at_ferry(Location), done_at(_, Location), !.
delta(15, sail(_, Location), 0.3212116726267645) :- todo_at(Car, Location), on(Car), !.
delta(15, sail(_, _), -0.24807688478963905) :- !.
delta(15, _, 0.21160613000345574) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(15, _, -0.17428790659146295).

% tree 16: step size 1.0, 205 examples, 11 leaves
delta(16, board(Car, Location), -0.28290314107587744) :- goal_at(Car, Location2), at(Car2, Location2), goal_at(Car2, Location), !.
delta(16, board(Car, _), 0.006366225974313341) :- goal_at(Car, Location), at(_, Location), !.
delta(16, board(_, Location), -0.025375448449583712) :- todo_at(_, Location), !.
delta(16, board(_, _), 0.06099745678700468) :- !.
delta(16, _, 0.19654108141306634) :- at_ferry(Location), could_board(Location), goal_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(16, _, -0.0028572020368417294) :- at_ferry(Location), could_board(Location), goal_at(_, Location), !.
delta(16, _, -0.028085888091185483) :- at_ferry(Location), could_board(Location), !.
delta(16, sail(_, Location), 0.3490101897995252) :- todo_at(Car, Location), on(Car), !.
delta(16, sail(_, _), -0.2350545680366109) :- !.
delta(16, _, 0.23372928676151658) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(16, _, -0.19023423041422374).

% tree 17: step size 1.0, 202 examples, 9 leaves
delta(17, board(Car, _), 0.07125642676674575) :- todo_at(Car, _), !.
delta(17, board(_, _), -0.13704232547081932) :- !.
delta(17, sail(_, _), -0.01676319543706479) :- at_ferry(Location), done_at(_, Location), at(Car, Location), todo_at(Car, _), !.
delta(17, _, 0.006103826599471527) :- at_ferry(Location), done_at(_, Location), at(Car, Location), todo_at(Car, _), !.
delta(17, sail(_, _), 0.07179798040900802) :- at_ferry(Location), done_at(_, Location), !.
delta(17, _, -0.007284430751725324) :- at_ferry(Location), done_at(_, Location), !.
delta(17, _, -0.03337260204891436) :- at_ferry(Location), could_board(Location), !.
delta(17, sail(_, _), -0.0060161256186952216) :- !.
delta(17, _, 0.012179758219297418).

% tree 18: step size 1.0, 208 examples, 10 leaves
delta(18, board(Car, Location), 0.003595104584169525) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, Location2), at(_, Location2), !.
delta(18, board(_, Location), -0.1843482932333562) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(18, board(_, _), 0.03008594845277022) :- !.
delta(18, _, 0.11064069613159656) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(18, sail(_, _), -0.02820403721393282) :- at_ferry(Location), done_at(_, Location), !.
delta(18, _, 0.03113680242633211) :- at_ferry(Location), done_at(_, Location), !.
delta(18, sail(_, Location), -0.2940408371162111) :- goal_at(Car, Location), at(Car, _), !.
delta(18, sail(_, _), 0.26097515996414256) :- !.
delta(18, _, 0.10144241975199088) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(18, _, -0.14150400273471875).

% tree 19: step size 1.0, 215 examples, 7 leaves
delta(19, sail(_, Location), -0.14608689865275937) :- could_board_for_todo_at_car_any(Location), todo_at(_, Location), !.
delta(19, sail(_, Location), 0.5066779241977373) :- could_board_for_todo_at_car_any(Location), !.
delta(19, sail(_, Location), 0.23605040290011545) :- todo_at(Car, Location), on(Car), !.
delta(19, sail(_, Location), -0.005958621892159153) :- could_board_for_todo_at_any_location(Location), !.
delta(19, sail(_, _), -0.43632984285172544) :- !.
delta(19, _, 0.1684792810082387) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(19, _, -0.2866264735707892).

% tree 20: step size 1.0, 219 examples, 8 leaves
delta(20, sail(_, Location), 0.0003824495747848346) :- could_board_for_todo_at_car_any(Location), todo_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(20, sail(_, Location), -0.043326887705674104) :- could_board_for_todo_at_car_any(Location), todo_at(_, Location), !.
delta(20, sail(_, Location), 0.2327558442937838) :- could_board_for_todo_at_car_any(Location), !.
delta(20, sail(Location, Location2), -0.010809892369679235) :- could_debark_for_todo_at_any_location(Location2), todo_at(Car, Location), on(Car), !.
delta(20, sail(_, Location), 0.14780592901302633) :- could_debark_for_todo_at_any_location(Location), !.
delta(20, sail(_, _), -0.2106762887611946) :- !.
delta(20, _, 0.09390575957198119) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(20, _, -0.17451073544276516).

% tree 21: step size 1.0, 220 examples, 11 leaves
delta(21, board(Car, Location), 0.0354871532401732) :- goal_at(Car2, Location), done_at(Car2, Location2), could_board_for_todo_at_car_any(Location2), todo_at(Car, _), !.
delta(21, board(_, Location), -0.016892877072759795) :- goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(21, board(_, Location), -0.1451256382973859) :- goal_at(_, Location), !.
delta(21, board(Car, _), -0.012717825913614693) :- todo_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(21, board(_, _), 0.03752826533664947) :- !.
delta(21, _, -0.019216047177073446) :- at_ferry(Location), goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(21, _, 0.11121237877173003) :- at_ferry(Location), goal_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(21, _, 4.5387644499729735e-20) :- at_ferry(Location), goal_at(_, Location), !.
delta(21, _, -0.025924375999745546) :- at_ferry(Location), could_board(Location), !.
delta(21, sail(_, _), 0.01691559113338058) :- !.
delta(21, _, -0.021368621250211738).

% tree 22: step size 1.0, 211 examples, 10 leaves
delta(22, board(Car, _), -0.10931086596440615) :- goal_at(Car, Location), at(Car2, Location), goal_at(Car2, Location2), at(Car3, Location2), goal_at(Car3, Location), !.
delta(22, board(Car, _), 0.0025129884544596373) :- goal_at(Car, Location), at(Car2, Location), goal_at(Car2, Location2), at(_, Location2), !.
delta(22, board(Car, _), 0.011791654792611574) :- goal_at(Car, Location), at(_, Location), !.
delta(22, board(_, _), 0.060972061887961476) :- !.
delta(22, _, -0.014057000820696833) :- at_ferry(Location), goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(22, _, 0.056167203940982784) :- at_ferry(Location), goal_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(22, _, 5.435675044435233e-19) :- at_ferry(Location), goal_at(_, Location), !.
delta(22, sail(_, Location), -0.11272466098729764) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(22, sail(_, _), 0.11983156630167982) :- !.
delta(22, _, -0.045324555745373994).

% tree 23: step size 1.0, 201 examples, 11 leaves
delta(23, sail(_, Location), 0.030688755411793084) :- goal_at(Car, Location), at(Car, _), todo_at(Car2, Location), on(Car2), !.
delta(23, sail(_, Location), -0.15391059304345137) :- goal_at(Car, Location), at(Car, _), !.
delta(23, sail(_, Location), -0.015362657868587482) :- at(Car, Location), todo_at(Car, Location2), could_debark_todo_at(Location2), !.
delta(23, sail(_, Location), 0.23158344176847653) :- at(_, Location), !.
delta(23, sail(_, Location), 0.061447739460687975) :- todo_at(_, Location), !.
delta(23, sail(_, _), -0.0870811438636659) :- !.
delta(23, _, 0.06493766161135824) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(23, _, 0.006824566051366131) :- at_ferry(Location), goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(23, _, -0.16761181122386493) :- at_ferry(Location), goal_at(_, Location), !.
delta(23, board(_, _), 0.02231235470482044) :- !.
delta(23, _, -0.0175418460429769).

% tree 24: step size 1.0, 203 examples, 7 leaves
delta(24, debark(Car, Location), 0.0523331247298236) :- todo_at(Car, Location), !.
delta(24, debark(_, _), -0.02849416102192496) :- !.
delta(24, _, -0.0523331247298236) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(24, sail(_, Location), 0.07755665018663732) :- todo_at(Car, Location), on(Car), !.
delta(24, sail(_, _), -0.031129614567907322) :- !.
delta(24, _, -0.03139286813439098) :- at_ferry(Location), done_at(_, Location), !.
delta(24, _, 0.02333695208335238).

% tree 25: step size 1.0, 230 examples, 7 leaves
delta(25, board(Car, _), 0.06568032290197279) :- todo_at(Car, _), !.
delta(25, board(_, _), -0.03780597764113521) :- !.
delta(25, _, -0.04544836927827052) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(25, sail(Location, Location2), 0.11866802203595404) :- todo_at(Car, Location), at(Car, Location2), !.
delta(25, sail(_, _), -0.0733058324762939) :- !.
delta(25, _, 0.056876658330195194) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(25, _, -0.06499005276874362).

% tree 26: step size 1.0, 211 examples, 12 leaves
delta(26, board(Car, Location), -0.001347629217647697) :- goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), todo_at(Car2, Location), at(Car2, Location2), todo_at(Car2, Location3), done_at(_, Location3), !.
delta(26, board(Car, Location), 0.003323219038300664) :- goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(26, board(Car, _), 0.00020602683346808526) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(26, board(Car, _), -0.06652983826321394) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(26, board(Car, _), 0.04819507566570627) :- todo_at(Car, _), !.
delta(26, board(_, _), -0.006671289625801665) :- !.
delta(26, _, 0.030961169712574354) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(26, _, -0.006988691328534092) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(26, sail(_, Location), 0.06953439241002443) :- could_board_for_todo_at_car_any(Location), !.
delta(26, sail(_, _), -0.07658165919319057) :- !.
delta(26, _, 0.048593623111923744) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(26, _, -0.04522166832621576).

% tree 27: step size 1.0, 219 examples, 6 leaves
delta(27, debark(Car, Location), 0.05212125167433244) :- todo_at(Car, Location), !.
delta(27, debark(_, _), -0.05779411784292605) :- !.
delta(27, _, -0.05212125167433244) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(27, _, 0.052867304721984185) :- at_ferry(Location), could_debark(Location), !.
delta(27, sail(_, _), -0.0024171868241084087) :- !.
delta(27, _, 0.0032776159009368835).

% tree 28: step size 1.0, 202 examples, 8 leaves
delta(28, sail(Location, Location2), -0.06170329435663138) :- could_board_for_todo_at_any_location(Location2), goal_at(_, Location), at(Car, Location2), todo_at(Car, _), !.
delta(28, sail(Location, Location2), 0.0014442314042050304) :- could_board_for_todo_at_any_location(Location2), goal_at(_, Location), !.
delta(28, sail(_, Location), 0.008229455558125758) :- could_board_for_todo_at_any_location(Location), at(Car, Location), todo_at(Car, _), !.
delta(28, sail(_, Location), -0.00499501997511467) :- could_board_for_todo_at_any_location(Location), !.
delta(28, sail(Location, _), -0.038848587819384564) :- todo_at(Car, Location), on(Car), !.
delta(28, sail(_, _), 0.13566803965909371) :- !.
delta(28, _, 0.038848587819384564) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(28, _, -0.12644604731332587).

% tree 29: step size 1.0, 238 examples, 9 leaves
delta(29, sail(Location, _), -0.030868995085537605) :- todo_at(Car, Location), on(Car), !.
delta(29, sail(_, _), 0.11413230647797959) :- at_ferry(Location), at(Car, Location), goal_at(Car, Location2), done_at(_, Location2), !.
delta(29, sail(_, _), -0.008457397063839018) :- at_ferry(Location), at(_, Location), !.
delta(29, sail(_, Location), 0.04201618288279499) :- could_board_for_todo_at_car_any(Location), !.
delta(29, sail(_, _), -0.03966815556071009) :- !.
delta(29, _, 0.030868995085537605) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(29, _, -0.03931609252995417) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), todo_at(_, Location), !.
delta(29, _, 0.034730635315174035) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(29, _, -0.1376172141354831).

% tree 30: step size 1.0, 208 examples, 13 leaves
delta(30, sail(Location, Location2), -0.018880994557606546) :- todo_at(_, Location2), todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), at(Car2, _), !.
delta(30, sail(Location, Location2), 0.00018812561164103977) :- todo_at(_, Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(30, sail(_, Location), -0.010027892645051474) :- todo_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(30, sail(_, Location), 0.2131674893123888) :- todo_at(_, Location), !.
delta(30, sail(_, _), 0.017317482794996772) :- at_ferry(Location), at(Car, Location), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(30, sail(_, _), -0.16150127510026574) :- at_ferry(Location), at(_, Location), !.
delta(30, sail(_, Location), 0.03604757923184784) :- could_board_for_todo_at_car_any(Location), !.
delta(30, sail(_, _), -0.030781702225292817) :- !.
delta(30, _, 0.027256823655642456) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(30, _, 0.00922067785191014) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(30, _, -0.07298761477115916) :- at_ferry(Location), goal_at(_, Location), !.
delta(30, board(_, _), 0.010583698180301068) :- !.
delta(30, _, -0.00782339014619253).

% tree 31: step size 1.0, 202 examples, 13 leaves
delta(31, board(Car, Location), 0.01990188962023212) :- goal_at(Car, Location2), at(_, Location2), todo_at(_, Location), todo_at(Car, Location2), !.
delta(31, board(Car, Location), -0.004304502226986401) :- goal_at(Car, Location2), at(_, Location2), todo_at(_, Location), !.
delta(31, board(Car, _), -0.20856064405717886) :- goal_at(Car, Location), at(_, Location), !.
delta(31, board(_, Location), 0.008734865376612378) :- todo_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(31, board(_, Location), -0.043964010358083935) :- todo_at(_, Location), !.
delta(31, board(_, _), 0.05042879271706432) :- !.
delta(31, sail(_, _), -0.02488300382265056) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), todo_at(_, Location2), !.
delta(31, _, 0.01331224473464904) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), todo_at(_, Location2), !.
delta(31, _, 0.18527690827617727) :- at_ferry(Location), goal_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(31, _, -1.0226168021466445e-19) :- at_ferry(Location), goal_at(_, Location), !.
delta(31, _, -0.013234538127947792) :- at_ferry(Location), could_board(Location), !.
delta(31, sail(_, _), 0.004286738877296318) :- !.
delta(31, _, -0.0048241097059146245).

% tree 32: step size 1.0, 231 examples, 8 leaves
delta(32, sail(Location, _), -0.03203322565877966) :- todo_at(Car, Location), on(Car), !.
delta(32, sail(Location, Location2), 0.03038000002125724) :- todo_at(Car, Location), at(Car, Location2), at(Car2, Location), todo_at(Car2, _), !.
delta(32, sail(Location, Location2), -0.03471695777264746) :- todo_at(Car, Location), at(Car, Location2), !.
delta(32, sail(_, _), 0.17096268820754293) :- !.
delta(32, _, 0.03203322565877966) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(32, _, 0.0063172841523317464) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(32, _, -0.006781221224471148) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(32, _, -0.19059044573199022).

% tree 33: step size 1.0, 258 examples, 13 leaves
delta(33, sail(_, Location), -0.07943475353308964) :- todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(33, sail(_, Location), 0.05243928755034273) :- todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(33, sail(Location, Location2), -0.005196866369573404) :- todo_at(_, Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(33, sail(_, Location), 0.09134806482585509) :- todo_at(_, Location), !.
delta(33, sail(Location, _), 0.06574804115176373) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), at(Car2, _), !.
delta(33, sail(Location, _), -0.036918222491877595) :- todo_at(Car, Location), at(Car, _), !.
delta(33, sail(_, Location), 0.017634022163132188) :- could_board_for_todo_at_car_any(Location), !.
delta(33, sail(_, _), -0.0914498633818941) :- !.
delta(33, _, 0.029757947080760946) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(33, _, -0.06084849549356514) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(33, _, 0.008866197732184637) :- at_ferry(Location), goal_at(_, Location), !.
delta(33, board(_, _), 0.019631472747462964) :- !.
delta(33, _, -0.003090386898606516).

% tree 34: step size 1.0, 205 examples, 10 leaves
delta(34, sail(Location, Location2), -0.01893135858594856) :- could_board_for_todo_at_car_any(Location2), todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(34, sail(Location, Location2), 0.011632831706193808) :- could_board_for_todo_at_car_any(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(34, sail(Location, Location2), -0.0058467707916540395) :- could_board_for_todo_at_car_any(Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(34, sail(_, Location), 0.05607869965296706) :- could_board_for_todo_at_car_any(Location), !.
delta(34, sail(_, Location), 0.024305674891465394) :- todo_at(Car, Location), on(Car), !.
delta(34, sail(_, _), -0.10057188660653081) :- !.
delta(34, _, 0.05345590623275011) :- at_ferry(Location), at(Car, Location), goal_at(Car, Location2), todo_at(_, Location2), !.
delta(34, _, -0.004171895264312409) :- at_ferry(Location), at(_, Location), !.
delta(34, _, 0.0053874393192663746) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(34, _, -0.020107793985339326).

% tree 35: step size 1.0, 210 examples, 13 leaves
delta(35, sail(Location, Location2), 0.013968625112625884) :- at(Car, Location2), todo_at(Car, Location3), at_ferry(Location4), could_board_for_todo_at_car_any(Location4), goal_at(Car2, Location), at(Car2, Location3), !.
delta(35, sail(_, Location), -0.04354101021353964) :- at(Car, Location), todo_at(Car, _), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(35, sail(_, Location), -0.015937320460793637) :- at(Car, Location), todo_at(Car, _), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(35, sail(_, Location), 0.09192579423366844) :- at(Car, Location), todo_at(Car, _), !.
delta(35, sail(Location, Location2), 0.04947667552509934) :- could_board_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(35, sail(_, Location), -0.004669883621635998) :- could_board_for_todo_at_any_location(Location), !.
delta(35, sail(_, Location), 0.016388899532542897) :- todo_at(Car, Location), on(Car), !.
delta(35, sail(_, _), -0.1124419229087619) :- !.
delta(35, _, -0.045088444463148546) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(35, _, 0.004386586574482854) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(35, _, 0.053451696570965095) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(35, _, 0.019735020820304087) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(35, _, -0.025430250067765867).

% tree 36: step size 1.0, 237 examples, 9 leaves
delta(36, board(Car, _), 0.044547770237607864) :- todo_at(Car, _), todo_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(36, board(Car, Location), -0.034604637572043906) :- todo_at(Car, _), todo_at(_, Location), !.
delta(36, board(Car, _), 0.03464246911773445) :- todo_at(Car, _), !.
delta(36, board(_, _), -0.018606985149448724) :- !.
delta(36, _, -0.037027931902494274) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(36, sail(Location, Location2), -0.04765429766218991) :- todo_at(Car, Location), at(Car, Location2), !.
delta(36, sail(_, _), 0.05378258256175975) :- !.
delta(36, _, 0.019181662458322406) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(36, _, -0.032177276863375896).

% tree 37: step size 1.0, 260 examples, 11 leaves
delta(37, sail(_, Location), -0.03048932955364237) :- goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(37, sail(_, Location), 0.10001760395779502) :- goal_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(37, sail(_, Location), -0.015581725781866899) :- goal_at(_, Location), !.
delta(37, sail(Location, Location2), -0.0026942557423363725) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_debark(Location3), !.
delta(37, sail(Location, Location2), 0.01006089175900779) :- todo_at(Car, Location), at(Car, Location2), !.
delta(37, sail(_, _), 0.0012453060568623994) :- at_ferry(Location), could_debark_for_todo_at_any_location(Location), !.
delta(37, sail(_, _), -0.07843422667615096) :- !.
delta(37, _, 0.04716650600596881) :- at_ferry(Location), goal_at(_, Location), at(Car, Location), todo_at(Car, _), !.
delta(37, _, 0.010245781590450401) :- at_ferry(Location), goal_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(37, _, -0.02655353363175033) :- at_ferry(Location), goal_at(_, Location), !.
delta(37, _, -0.018204720162534223).

% tree 38: step size 1.0, 201 examples, 7 leaves
delta(38, sail(Location, Location2), 0.001990281449057805) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location2), on(Car2), !.
delta(38, sail(Location, Location2), -0.032005037651430965) :- todo_at(Car, Location2), at(Car, Location), !.
delta(38, sail(Location, _), -0.01540035348545785) :- todo_at(Car, Location), on(Car), !.
delta(38, sail(_, Location), 0.0472021296381025) :- goal_at(_, Location), !.
delta(38, sail(_, _), -0.00041551366500745785) :- !.
delta(38, _, 0.017921448551044817) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(38, _, -0.02369494291437942).

% tree 39: step size 1.0, 231 examples, 7 leaves
delta(39, board(Car, _), 0.018056190297278674) :- todo_at(Car, Location), done_at(_, Location), !.
delta(39, board(_, _), -0.07510469533041027) :- !.
delta(39, _, 0.05407399625772523) :- at_ferry(Location), could_board(Location), !.
delta(39, sail(Location, Location2), -0.03248091191444045) :- todo_at(Car, Location), at(Car, Location2), !.
delta(39, sail(_, _), 0.020231120187588065) :- !.
delta(39, _, 0.017151194957713226) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(39, _, -0.009711295256185071).

% tree 40: step size 1.0, 213 examples, 10 leaves
delta(40, sail(Location, Location2), 0.021163130420822244) :- could_board_for_todo_at_car_any(Location2), todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), at(_, Location3), !.
delta(40, sail(Location, Location2), -0.03320965194558377) :- could_board_for_todo_at_car_any(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(40, sail(Location, Location2), -0.00514466142068641) :- could_board_for_todo_at_car_any(Location2), todo_at(Car, Location2), at(Car, Location), !.
delta(40, sail(_, Location), 0.1260263231045363) :- could_board_for_todo_at_car_any(Location), !.
delta(40, sail(Location, _), 0.0643033628896478) :- todo_at(Car, Location), at(Car, Location2), todo_at(_, Location2), !.
delta(40, sail(Location, _), -0.024394581915437627) :- todo_at(Car, Location), at(Car, _), !.
delta(40, sail(_, Location), 0.013275503504943878) :- todo_at(Car, Location), on(Car), !.
delta(40, sail(_, _), -0.07304267349037652) :- !.
delta(40, _, 0.01812388420879346) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(40, _, -0.10488267101066234).

% tree 41: step size 1.0, 232 examples, 10 leaves
delta(41, sail(Location, Location2), -0.019166260694910783) :- at(Car, Location2), goal_at(Car, Location3), at(Car2, Location3), todo_at(Car2, Location), !.
delta(41, sail(_, Location), 0.15142047084578447) :- at(Car, Location), goal_at(Car, Location2), at(_, Location2), !.
delta(41, sail(_, Location), -0.056608216869336744) :- at(_, Location), todo_at(Car, Location), at(Car, _), !.
delta(41, sail(_, Location), 0.0054371602362916225) :- at(_, Location), !.
delta(41, sail(_, Location), 0.008552257914973084) :- at_ferry(Location2), at(_, Location2), todo_at(Car, Location), on(Car), !.
delta(41, sail(_, _), -0.037280474427413245) :- at_ferry(Location), at(_, Location), !.
delta(41, sail(_, _), 0.016632922272283208) :- at_ferry(Location), could_debark(Location), !.
delta(41, sail(_, _), -0.0038641143823707506) :- !.
delta(41, _, 0.011820560152176704) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(41, _, -0.09867981013628449).

% tree 42: step size 1.0, 237 examples, 11 leaves
delta(42, board(Car, Location), 0.04827743518630295) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, _), !.
delta(42, board(_, Location), -0.016817274773605326) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(42, board(_, Location), -0.09698047549195234) :- todo_at(_, Location), !.
delta(42, board(Car, _), -0.004468606548874633) :- todo_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(42, board(_, _), 0.02244856538954988) :- !.
delta(42, _, -0.033161067068020245) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(42, sail(_, _), -0.0016378897468508583) :- at_ferry(Location), done_at(_, Location), !.
delta(42, _, 0.0037467685931149384) :- at_ferry(Location), done_at(_, Location), !.
delta(42, _, 0.09825836878016544) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(42, sail(_, _), -0.02046750617140577) :- !.
delta(42, _, 0.005103213155827887).

% tree 43: step size 1.0, 242 examples, 13 leaves
delta(43, board(Car, _), 0.018176529140938084) :- goal_at(Car, Location), at(Car2, Location), todo_at(Car2, Location2), done_at(_, Location2), todo_at(Car, Location), !.
delta(43, board(Car, _), -0.004799190752985263) :- goal_at(Car, Location), at(Car2, Location), todo_at(Car2, Location2), done_at(_, Location2), !.
delta(43, board(Car, _), -0.15882512501997945) :- goal_at(Car, Location), at(_, Location), !.
delta(43, board(_, Location), 0.007123528519985731) :- todo_at(Car, Location), at(Car, Location2), todo_at(_, Location2), !.
delta(43, board(_, Location), -0.025123823281809215) :- todo_at(_, Location), !.
delta(43, board(_, _), 0.09146098120439325) :- !.
delta(43, sail(_, _), -0.008394485521563947) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(43, _, 0.004716577021711705) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(43, _, 0.08748859248390939) :- at_ferry(Location), goal_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(43, _, 0.0028925287074875058) :- at_ferry(Location), goal_at(_, Location), !.
delta(43, _, -0.022175525753057923) :- at_ferry(Location), could_board(Location), !.
delta(43, sail(_, _), 0.002074406256195127) :- !.
delta(43, _, -0.002157970457815396).

% tree 44: step size 1.0, 243 examples, 11 leaves
delta(44, sail(Location, Location2), 0.002933478370358774) :- could_board_for_todo_at_car_any(Location2), todo_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), at(Car2, Location), !.
delta(44, sail(Location, Location2), -0.0312914984905259) :- could_board_for_todo_at_car_any(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(44, sail(_, Location), -0.018276386456912097) :- could_board_for_todo_at_car_any(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(44, sail(_, Location), 0.10098809554259362) :- could_board_for_todo_at_car_any(Location), !.
delta(44, sail(Location, _), -0.012431950197045502) :- at_ferry(Location2), could_debark(Location2), todo_at(Car, Location), on(Car), !.
delta(44, sail(_, _), 0.027485674696048887) :- at_ferry(Location), could_debark(Location), !.
delta(44, sail(_, _), -0.05481011807021695) :- !.
delta(44, _, 0.012431950197045502) :- at_ferry(Location), goal_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(44, _, -0.06908847315324683) :- at_ferry(Location), goal_at(_, Location), !.
delta(44, board(_, _), 0.02741263395218061) :- !.
delta(44, _, -0.0009361806119940463).

% tree 45: step size 1.0, 235 examples, 9 leaves
delta(45, board(Car, Location), 0.018068009114141175) :- goal_at(Car, Location2), done_at(_, Location2), goal_at(_, Location), todo_at(Car, Location2), !.
delta(45, board(Car, Location), -0.01018403681256686) :- goal_at(Car, Location2), done_at(_, Location2), goal_at(_, Location), !.
delta(45, board(Car, _), -0.02277481518270515) :- goal_at(Car, Location), done_at(_, Location), !.
delta(45, board(_, _), 0.07077086717663814) :- !.
delta(45, _, -0.057954612406409776) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(45, sail(_, Location), 0.075965358892861) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(45, sail(_, _), -0.06458102156751382) :- !.
delta(45, _, 0.011216584870739187) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(45, _, -0.013668453301564756).

% tree 46: step size 1.0, 221 examples, 9 leaves
delta(46, sail(Location, Location2), -0.01142077742634609) :- at(Car, Location2), todo_at(Car, _), todo_at(Car, Location3), could_board_for_todo_at_car_any(Location3), todo_at(Car, Location), !.
delta(46, sail(_, Location), 0.08137083408587295) :- at(Car, Location), todo_at(Car, _), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(46, sail(Location, Location2), 0.025092346072280836) :- at(Car, Location2), todo_at(Car, _), todo_at(Car, Location), !.
delta(46, sail(_, Location), -0.17246023826833032) :- at(Car, Location), todo_at(Car, _), !.
delta(46, sail(Location, _), -0.007544403431851964) :- todo_at(Car, Location), on(Car), !.
delta(46, sail(Location, Location2), -0.001790838760193173) :- todo_at(Car, Location2), at(Car, Location), !.
delta(46, sail(_, _), 0.17573330608566537) :- !.
delta(46, _, 0.01282845485402732) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(46, _, -0.0968901675738895).

% tree 47: step size 1.0, 247 examples, 14 leaves
delta(47, sail(_, Location), -0.12190909907681427) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), at_ferry(Location3), at(_, Location3), !.
delta(47, sail(_, Location), 0.0004825733482206783) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(47, sail(_, Location), -0.018065494014164823) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location), at(Car2, _), !.
delta(47, sail(_, Location), 0.02486138928171443) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(47, sail(Location, Location2), -0.011775468324834035) :- todo_at(_, Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(47, sail(_, Location), 0.2480854755320401) :- todo_at(_, Location), !.
delta(47, sail(_, _), 0.030560914258500983) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(47, sail(_, _), -0.08958391422801108) :- !.
delta(47, _, -0.10554565988052694) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(47, _, 0.012450890445590805) :- at_ferry(Location), done_at(_, Location), at(Car, Location), todo_at(Car, _), !.
delta(47, _, -0.006429496711921118) :- at_ferry(Location), done_at(_, Location), !.
delta(47, _, -5.507655542421996e-5) :- at_ferry(Location), todo_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(47, _, 0.022343388006605545) :- at_ferry(Location), todo_at(_, Location), !.
delta(47, _, -0.008285003256432852).

% tree 48: step size 1.0, 252 examples, 7 leaves
delta(48, board(_, _), -0.19312757269880848) :- !.
delta(48, _, 0.1860060627932134) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), todo_at(_, Location), !.
delta(48, _, -0.0050147618337317516) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), goal_at(_, Location), !.
delta(48, _, 0.01409806272858079) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(48, _, 0.0005380465129479629) :- at_ferry(Location), could_board(Location), !.
delta(48, sail(_, _), -0.0004333975263768044) :- !.
delta(48, _, 0.0004737302774598117).

% tree 49: step size 1.0, 245 examples, 10 leaves
delta(49, board(_, Location), -0.10423075005065903) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(49, board(Car, _), 0.060917784750953094) :- todo_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(49, board(_, _), -0.026553338427050287) :- !.
delta(49, _, 0.0921896667558488) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(49, sail(_, _), -0.0035904342970422653) :- at_ferry(Location), done_at(_, Location), !.
delta(49, _, 0.004670324214603474) :- at_ferry(Location), done_at(_, Location), !.
delta(49, sail(_, Location), 0.06734800024949439) :- could_board_for_todo_at_any_location(Location), !.
delta(49, sail(_, _), -0.09685299612874401) :- !.
delta(49, _, 0.005749186266056678) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(49, _, -0.0009823580584949806).

% tree 50: step size 1.0, 212 examples, 11 leaves
delta(50, sail(_, Location), 0.051301644861216494) :- goal_at(Car, Location), at(Car, Location2), todo_at(Car2, Location), todo_at(Car2, Location2), at(Car2, Location3), could_board_for_todo_at_any_location(Location3), !.
delta(50, sail(_, Location), -0.024183966849781725) :- goal_at(Car, Location), at(Car, Location2), todo_at(Car2, Location), todo_at(Car2, Location2), !.
delta(50, sail(_, Location), 0.010404189223843209) :- goal_at(Car, Location), at(Car, Location2), todo_at(Car2, Location2), at(Car2, Location), !.
delta(50, sail(_, Location), -0.14676609430469648) :- goal_at(Car, Location), at(Car, _), !.
delta(50, sail(Location, _), -0.004343672539928851) :- todo_at(Car, Location), on(Car), !.
delta(50, sail(_, _), 0.12965948215458492) :- at_ferry(Location), at(_, Location), !.
delta(50, sail(_, _), -0.00030883790336810337) :- !.
delta(50, _, 0.004072661696828941) :- at_ferry(Location), done_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(50, _, -0.026377552617795973) :- at_ferry(Location), done_at(_, Location), !.
delta(50, _, -0.0022867259591574313) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(50, _, 0.01931488805855463).

% tree 51: step size 1.0, 308 examples, 9 leaves
delta(51, sail(_, Location), -0.05488587358162125) :- goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_any_location(Location2), at_ferry(Location3), could_board_for_todo_at_car_any(Location3), !.
delta(51, sail(_, Location), 0.011879168073945628) :- goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(51, sail(_, Location), 0.1742884219782748) :- goal_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(51, sail(_, Location), -0.0367910295568309) :- goal_at(_, Location), !.
delta(51, sail(Location, _), 0.030651135642425466) :- goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(51, sail(Location, _), -0.039649242554714755) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(51, sail(Location, Location2), 0.002154314179098781) :- todo_at(Car, Location), at(Car, Location2), !.
delta(51, sail(_, _), -0.16624324285772465) :- !.
delta(51, _, 0.06199756767313083).

% tree 52: step size 1.0, 287 examples, 10 leaves
delta(52, sail(_, Location), 0.1436991089077772) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), at(_, Location2), at(Car, Location), todo_at(Car, _), !.
delta(52, sail(_, Location), -0.003079002773687047) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), at(_, Location2), !.
delta(52, sail(_, Location), -0.018709621914261575) :- could_board_for_todo_at_any_location(Location), !.
delta(52, sail(Location, Location2), 0.006445441391768119) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location2), at(Car2, Location), !.
delta(52, sail(Location, _), -0.1392995713516413) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(52, sail(_, Location), -0.02014203397433183) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(52, sail(_, _), 0.03695554861327929) :- !.
delta(52, _, -0.027476579615555018) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(52, _, 0.05352993403877568) :- at_ferry(Location), goal_at(_, Location), !.
delta(52, _, -0.015485529988992035).

% tree 53: step size 1.0, 261 examples, 9 leaves
delta(53, board(Car, Location), 0.0040949584701870856) :- goal_at(Car, Location2), done_at(_, Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(53, board(Car, Location), -0.02925063301270362) :- goal_at(Car, Location2), done_at(_, Location2), goal_at(_, Location), !.
delta(53, board(Car, _), 0.0026330042502642056) :- goal_at(Car, Location), done_at(_, Location), !.
delta(53, board(_, _), 0.09842530864719146) :- !.
delta(53, _, -0.07849684727244848) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(53, sail(_, Location), -0.10886934700590814) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(53, sail(_, _), 0.10184704193873587) :- !.
delta(53, _, 0.00750267245332356) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(53, _, -0.0134393965823836).

% tree 54: step size 1.0, 214 examples, 12 leaves
delta(54, board(Car, Location), 0.04963823415294718) :- goal_at(_, Location), todo_at(Car, Location2), at(_, Location2), !.
delta(54, board(_, Location), -0.019509149353167988) :- goal_at(Car, Location), at(Car, Location2), todo_at(_, Location2), !.
delta(54, board(_, Location), 0.012329432025158066) :- goal_at(_, Location), !.
delta(54, board(Car, _), -0.02878135338466721) :- todo_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(54, board(_, _), 0.008759031184367693) :- !.
delta(54, _, -0.04735027753955043) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), done_at(_, Location2), could_board_for_todo_at_car_any(Location), !.
delta(54, _, 0.00046597513990280525) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(54, _, 0.015019968132074587) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(54, _, -0.00857585372678545) :- at_ferry(Location), goal_at(_, Location), !.
delta(54, sail(_, Location), -0.009094875946285243) :- todo_at(Car, Location), at(Car, _), !.
delta(54, sail(_, _), 0.031354591432739665) :- !.
delta(54, _, -0.0031436205713305655).

% tree 55: step size 1.0, 235 examples, 6 leaves
delta(55, debark(_, _), 0.047595522841139694) :- !.
delta(55, _, -0.046814038365737345) :- at_ferry(Location), could_debark(Location), !.
delta(55, sail(_, Location), -0.14283815102409556) :- could_board_for_todo_at_any_location(Location), !.
delta(55, sail(_, _), 0.14031676306398325) :- !.
delta(55, _, -0.08248515649730988) :- at_ferry(Location), todo_at(_, Location), !.
delta(55, _, 0.05022760281060327).

% tree 56: step size 1.0, 231 examples, 12 leaves
delta(56, sail(Location, Location2), -0.01415371333573013) :- todo_at(_, Location2), at(Car, Location), todo_at(Car, Location3), todo_at(Car2, Location3), at(Car2, Location2), !.
delta(56, sail(Location, Location2), 0.21795154912916231) :- todo_at(_, Location2), at(Car, Location), todo_at(Car, _), !.
delta(56, sail(_, Location), 0.04721185612444143) :- todo_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(56, sail(_, Location), -0.12379048394053321) :- todo_at(_, Location), !.
delta(56, sail(Location, Location2), 0.05381670271107994) :- at(Car, Location), todo_at(Car, Location3), todo_at(Car2, Location3), at(Car2, Location2), !.
delta(56, sail(Location, _), -0.16392912008152452) :- at(Car, Location), todo_at(Car, _), !.
delta(56, sail(_, Location), 0.08680648062828705) :- could_board(Location), !.
delta(56, sail(_, _), -0.021660184780786254) :- !.
delta(56, _, -0.008032509851806662) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(56, _, 0.01362794651055745) :- at_ferry(Location), done_at(_, Location), !.
delta(56, _, 0.0036911707548915548) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(56, _, -0.09410413089838171).

% tree 57: step size 1.0, 271 examples, 8 leaves
delta(57, sail(_, Location), 0.03399430958603346) :- at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), at_ferry(Location3), could_board_for_todo_at_car_any(Location3), !.
delta(57, sail(_, Location), -0.008524315080061066) :- at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(57, sail(_, Location), -0.10878726200669703) :- at(_, Location), !.
delta(57, sail(Location, Location2), 0.002779120517228733) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location2), on(Car2), !.
delta(57, sail(Location, _), -0.035174511278792946) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(57, sail(Location, Location2), -0.002764944283871584) :- todo_at(Car, Location2), at(Car, Location), !.
delta(57, sail(_, _), 0.0667776334124525) :- !.
delta(57, _, 0.06941952233185121).

% tree 58: step size 1.0, 245 examples, 12 leaves
delta(58, board(Car, Location), 0.06197497550613305) :- goal_at(_, Location), todo_at(Car, Location2), at(_, Location2), !.
delta(58, board(_, Location), -0.019344861877983715) :- goal_at(_, Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(58, board(_, Location), 0.004288398211851111) :- goal_at(_, Location), !.
delta(58, board(Car, _), -0.04233791460758149) :- todo_at(Car, Location), at(Car2, Location), goal_at(Car2, Location2), at(_, Location2), !.
delta(58, board(Car, _), 0.007090714802452074) :- todo_at(Car, Location), at(_, Location), !.
delta(58, board(_, _), 0.00580856401533249) :- !.
delta(58, _, -0.0448162209206305) :- at_ferry(Location), goal_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(58, sail(_, _), 0.00339817002487881) :- at_ferry(Location), goal_at(_, Location), !.
delta(58, _, -0.0026938848915489177) :- at_ferry(Location), goal_at(_, Location), !.
delta(58, sail(_, Location), -0.022003712615564604) :- todo_at(Car, Location), at(Car, _), !.
delta(58, sail(_, _), 0.05213913097823418) :- !.
delta(58, _, -0.0016323065629460399).

% tree 59: step size 1.0, 224 examples, 10 leaves
delta(59, sail(_, Location), 0.1747597758744296) :- goal_at(Car, Location), at(Car, Location2), goal_at(_, Location2), at_ferry(Location3), could_board_for_todo_at_any_location(Location3), !.
delta(59, sail(_, Location), -0.04568770465666955) :- goal_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(59, sail(_, Location), 0.007476051994852308) :- goal_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(59, sail(_, Location), -0.08163131765653903) :- goal_at(_, Location), !.
delta(59, sail(_, Location), -0.1563974311149752) :- at(_, Location), at_ferry(Location2), at(_, Location2), !.
delta(59, sail(_, Location), 0.011149038276913022) :- at(_, Location), !.
delta(59, sail(Location, _), 0.04149908170984503) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(59, sail(_, _), -0.010336363464865972) :- !.
delta(59, _, -0.014919256217389073) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(59, _, 0.05293501753082097).

% tree 60: step size 1.0, 263 examples, 11 leaves
delta(60, board(_, Location), -0.12489309750372556) :- todo_at(_, Location), !.
delta(60, board(Car, Location), -0.007019912104010765) :- goal_at(_, Location), goal_at(Car, Location2), done_at(_, Location2), !.
delta(60, board(_, Location), 0.030796300548781363) :- goal_at(_, Location), !.
delta(60, board(Car, _), -0.01664417449164399) :- todo_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(60, board(_, _), 0.011675058170515474) :- !.
delta(60, _, 0.11931174007156131) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(60, _, 0.0001410182654436365) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(60, sail(_, _), -0.023548567043704595) :- at_ferry(Location), done_at(_, Location), !.
delta(60, _, 0.0023441116458208745) :- at_ferry(Location), done_at(_, Location), !.
delta(60, _, 0.004799695171525559) :- at_ferry(Location), could_board(Location), !.
delta(60, _, -7.657544182468144e-20).

% tree 61: step size 1.0, 245 examples, 11 leaves
delta(61, sail(_, Location), 0.18188519680801415) :- todo_at(Car, Location), at(Car, Location2), done_at(_, Location2), at_ferry(Location3), could_board(Location3), !.
delta(61, sail(_, Location), -0.010213912811645099) :- todo_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(61, sail(_, Location), -0.04955904989238752) :- todo_at(_, Location), at_ferry(Location2), could_board(Location2), !.
delta(61, sail(_, Location), 0.03278841599126571) :- todo_at(_, Location), !.
delta(61, sail(Location, _), -0.0017543188543683852) :- todo_at(Car, Location), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(61, sail(Location, _), -0.11669693810644671) :- todo_at(_, Location), !.
delta(61, sail(Location, _), 0.058370195916299945) :- goal_at(_, Location), !.
delta(61, sail(_, _), -0.0034281772760851) :- !.
delta(61, _, 0.0022099632809754414) :- at_ferry(Location), done_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(61, _, -0.10931527926286932) :- at_ferry(Location), done_at(_, Location), !.
delta(61, _, 0.020172991307353973).

% tree 62: step size 1.0, 283 examples, 10 leaves
delta(62, board(Car, Location), -0.0016900265077971553) :- goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), todo_at(Car2, Location), at(Car2, Location2), todo_at(Car2, Location3), done_at(_, Location3), !.
delta(62, board(Car, Location), 0.00533619951147939) :- goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(62, board(Car, _), -0.13346680084425883) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(62, board(Car, _), 0.0458190938874757) :- todo_at(Car, _), !.
delta(62, board(_, _), -0.0003345053324614513) :- !.
delta(62, _, 0.07372192152919556) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(62, sail(_, Location), 0.029395972288725807) :- todo_at(_, Location), !.
delta(62, sail(_, _), -0.03100541567435229) :- !.
delta(62, _, 0.004841964876517578) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(62, _, -0.001133256120660035).

% tree 63: step size 1.0, 248 examples, 13 leaves
delta(63, board(Car, Location), 0.06222874949192441) :- goal_at(Car2, Location), todo_at(Car, _), at(Car2, Location2), goal_at(_, Location2), !.
delta(63, board(Car, Location), -0.0006100585603735307) :- goal_at(_, Location), todo_at(Car, _), !.
delta(63, board(_, Location), -0.011493691942143579) :- goal_at(_, Location), !.
delta(63, board(Car, _), 0.006041099642857691) :- todo_at(Car, Location), could_board_for_todo_at_car_any(Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(63, board(Car, _), -0.06251247865331619) :- todo_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(63, board(_, _), 0.013983440070984489) :- !.
delta(63, _, 0.0037279428391659543) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), empty_ferry, !.
delta(63, _, 3.285456337495126e-21) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(63, _, -0.05439702759353072) :- at_ferry(Location), goal_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(63, _, 0.0006949217621289113) :- at_ferry(Location), goal_at(_, Location), !.
delta(63, _, 0.04192363740681078) :- at_ferry(Location), could_board(Location), !.
delta(63, sail(_, _), 0.0005432816924465894) :- !.
delta(63, _, -0.000575866315539947).

% tree 64: step size 1.0, 209 examples, 12 leaves
delta(64, sail(Location, Location2), -0.10190269316392372) :- goal_at(Car, Location2), at(Car, Location3), goal_at(_, Location), goal_at(Car2, Location3), done_at(Car2, Location3), !.
delta(64, sail(Location, Location2), 0.027727191498532935) :- goal_at(Car, Location2), at(Car, _), goal_at(_, Location), !.
delta(64, sail(_, Location), 0.04039612672569094) :- goal_at(Car, Location), at(Car, _), at(Car2, Location), todo_at(Car2, _), !.
delta(64, sail(_, Location), -0.018390482120315528) :- goal_at(Car, Location), at(Car, _), !.
delta(64, sail(_, _), -0.024946764036652535) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(64, sail(_, _), 0.0034256863292784234) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(64, sail(_, _), 0.1265442538542652) :- at_ferry(Location), at(_, Location), !.
delta(64, sail(_, _), -0.007622824386791941) :- !.
delta(64, _, 0.059667943059946875) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(64, _, -7.561159517739423e-5) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(64, _, 0.005014201458708133) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(64, _, -0.0945156318665041).

% tree 65: step size 1.0, 245 examples, 9 leaves
delta(65, sail(_, Location), 0.005853317544075307) :- could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(65, sail(_, Location), -0.004774196751887258) :- could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(65, sail(_, Location), -0.041625262522731674) :- could_board_for_todo_at_any_location(Location), !.
delta(65, sail(Location, Location2), 0.008155223452192644) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), done_at(_, Location3), !.
delta(65, sail(Location, Location2), -0.0156278511590273) :- todo_at(Car, Location), at(Car, Location2), !.
delta(65, sail(Location, _), -0.00456266788038641) :- todo_at(Car, Location), on(Car), !.
delta(65, sail(_, _), 0.211062946435582) :- !.
delta(65, _, 0.004797893693459824) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(65, _, -0.1972314748439551).

% tree 66: step size 1.0, 219 examples, 12 leaves
delta(66, sail(Location, Location2), -0.009490592830333914) :- goal_at(Car, Location2), at(Car, _), done_at(Car, Location3), could_board_for_todo_at_car_any(Location3), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(66, sail(_, Location), 0.05545456352769411) :- goal_at(Car, Location), at(Car, _), done_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(66, sail(Location, Location2), -0.17754855234019296) :- goal_at(Car, Location2), at(Car, _), at(Car2, Location), todo_at(Car2, _), !.
delta(66, sail(_, Location), 0.025879665754555706) :- goal_at(Car, Location), at(Car, _), !.
delta(66, sail(Location, _), 0.17288421697607095) :- at(Car, Location), todo_at(Car, _), goal_at(Car2, Location), at(Car2, _), !.
delta(66, sail(Location, _), -0.02089839455366645) :- at(Car, Location), todo_at(Car, _), !.
delta(66, sail(Location, _), -0.05257463553781429) :- todo_at(_, Location), !.
delta(66, sail(_, _), 0.02190953875773801) :- !.
delta(66, _, 0.0039995794268454996) :- at_ferry(Location), todo_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(66, _, -0.035663362990823705) :- at_ferry(Location), todo_at(_, Location), !.
delta(66, _, 0.02789985648056026) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(66, _, -0.00602151534439719).

% tree 67: step size 1.0, 215 examples, 13 leaves
delta(67, sail(Location, Location2), -0.009443256279584379) :- goal_at(Car, Location2), at(Car, Location3), could_board_for_todo_at_car_any(Location3), todo_at(Car2, Location3), at(Car2, Location), !.
delta(67, sail(_, Location), 0.09859175734917586) :- goal_at(Car, Location), at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(67, sail(_, Location), -0.029111913264259888) :- goal_at(_, Location), at_ferry(Location2), could_board(Location2), !.
delta(67, sail(_, Location), 0.011906216394589653) :- goal_at(_, Location), !.
delta(67, sail(Location, Location2), -0.0003891530634099216) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_debark(Location3), !.
delta(67, sail(Location, Location2), 0.039756756721467626) :- todo_at(Car, Location), at(Car, Location2), !.
delta(67, sail(_, _), -0.07367738913294364) :- !.
delta(67, _, -0.01141745814951996) :- at_ferry(Location), done_at(_, Location), at(Car, Location), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(67, _, 0.019487339832470377) :- at_ferry(Location), done_at(_, Location), at(Car, Location), todo_at(Car, _), !.
delta(67, _, 0.0017037082111649544) :- at_ferry(Location), done_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(67, _, -0.0018063820655049997) :- at_ferry(Location), done_at(_, Location), !.
delta(67, _, 0.002125944271562659) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(67, _, -0.054743844526925364).

% tree 68: step size 1.0, 279 examples, 10 leaves
delta(68, sail(Location, Location2), 0.0019504568822330405) :- todo_at(Car, Location2), at(Car, _), goal_at(_, Location), todo_at(Car2, Location2), on(Car2), !.
delta(68, sail(Location, Location2), -0.08700769351266897) :- todo_at(Car, Location2), at(Car, _), goal_at(_, Location), !.
delta(68, sail(_, Location), 0.06200710551321403) :- todo_at(Car, Location), at(Car, _), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(68, sail(_, Location), -0.011843911555788799) :- todo_at(Car, Location), at(Car, _), !.
delta(68, sail(Location, _), -0.0012287348512360487) :- goal_at(Car, Location), at(Car, _), goal_at(Car, Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(68, sail(Location, _), 0.11422341761961903) :- goal_at(Car, Location), at(Car, _), !.
delta(68, sail(_, Location), 0.0014105883718782501) :- todo_at(_, Location), !.
delta(68, sail(_, _), -0.016064565547809957) :- !.
delta(68, _, 0.004698105851091562) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(68, _, -0.0701271915963777).

% tree 69: step size 1.0, 222 examples, 9 leaves
delta(69, board(Car, _), 0.06978901660998921) :- todo_at(Car, _), !.
delta(69, board(_, _), -0.004265912281284415) :- !.
delta(69, sail(_, _), -0.013890222431101565) :- at_ferry(Location), done_at(_, Location), todo_at(_, Location), !.
delta(69, _, 0.0019056144963181725) :- at_ferry(Location), done_at(_, Location), todo_at(_, Location), !.
delta(69, sail(_, _), 0.015070359407061794) :- at_ferry(Location), done_at(_, Location), !.
delta(69, _, -0.003209802245137348) :- at_ferry(Location), done_at(_, Location), !.
delta(69, _, -0.06965918121496592) :- at_ferry(Location), could_board(Location), !.
delta(69, sail(_, _), 0.006195251770447513) :- !.
delta(69, _, -0.006791762120180871).

% tree 70: step size 1.0, 213 examples, 9 leaves
delta(70, sail(Location, Location2), -0.00649440139093417) :- todo_at(Car, Location2), at(Car, Location), at(Car2, Location2), todo_at(Car2, _), todo_at(Car2, Location), !.
delta(70, sail(Location, Location2), 0.03911306337705893) :- todo_at(Car, Location2), at(Car, Location), at(Car2, Location2), todo_at(Car2, _), !.
delta(70, sail(Location, Location2), 0.00034306233792723095) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location2), on(Car2), !.
delta(70, sail(Location, Location2), -0.009438502620369132) :- todo_at(Car, Location2), at(Car, Location), !.
delta(70, sail(Location, Location2), 0.054693719430182856) :- todo_at(Car, Location), at(Car, Location2), todo_at(_, Location2), !.
delta(70, sail(Location, Location2), -0.03467631180438583) :- todo_at(Car, Location), at(Car, Location2), !.
delta(70, sail(_, Location), -0.111577388616207) :- goal_at(Car, Location), at(Car, _), !.
delta(70, sail(_, _), 0.02893288492366349) :- !.
delta(70, _, 0.04571985105383512).

% tree 71: step size 1.0, 220 examples, 12 leaves
delta(71, board(Car, Location), 0.024403304316696926) :- todo_at(Car, Location2), at(Car2, Location2), done_at(Car2, Location3), could_board_for_todo_at_car_any(Location3), todo_at(_, Location), !.
delta(71, board(Car, _), -0.030491855465482075) :- todo_at(Car, Location), at(Car2, Location), done_at(Car2, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(71, board(Car, _), 0.06649415839091319) :- todo_at(Car, Location), at(_, Location), !.
delta(71, board(Car, Location), 0.010447118432944835) :- todo_at(_, Location), todo_at(Car, _), !.
delta(71, board(_, Location), -0.0025295638021416334) :- todo_at(_, Location), !.
delta(71, board(_, _), -0.011988803759860039) :- !.
delta(71, _, -0.058147731000665226) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(71, _, 4.6245900684877926e-5) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(71, sail(_, _), 0.004571025832184798) :- at_ferry(Location), done_at(_, Location), !.
delta(71, _, -0.0012672789348686382) :- at_ferry(Location), done_at(_, Location), !.
delta(71, _, -0.0025056649527300215) :- at_ferry(Location), could_board(Location), !.
delta(71, _, -4.5704985656434267e-20).

% tree 72: step size 1.0, 245 examples, 9 leaves
delta(72, debark(Car, Location), 0.003918011493513965) :- todo_at(Car, Location), !.
delta(72, debark(_, _), -0.01993015649468687) :- !.
delta(72, sail(_, Location), -0.059607350497620844) :- at_ferry(Location2), todo_at(_, Location2), todo_at(Car, Location), at(Car, _), !.
delta(72, sail(_, _), 0.03164052594785707) :- at_ferry(Location), todo_at(_, Location), !.
delta(72, _, 0.026782273931610822) :- at_ferry(Location), todo_at(Car, Location), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(72, _, -3.2689534423711094e-5) :- at_ferry(Location), todo_at(_, Location), !.
delta(72, sail(_, Location), 0.05389811765928517) :- goal_at(_, Location), !.
delta(72, sail(_, _), -0.022231200624221157) :- !.
delta(72, _, -0.014946922025686246).

% tree 73: step size 1.0, 206 examples, 7 leaves
delta(73, board(Car, _), 0.11676965006428616) :- todo_at(Car, _), !.
delta(73, board(_, _), -0.006672369992209229) :- !.
delta(73, _, -0.1086573102146172) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(73, sail(_, Location), -0.01991090260407568) :- todo_at(Car, Location), at(Car, _), !.
delta(73, sail(_, _), 0.024389064611098167) :- !.
delta(73, _, 0.004337144071502254) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(73, _, -0.009712672454753829).

% tree 74: step size 1.0, 225 examples, 11 leaves
delta(74, sail(Location, Location2), -0.029868474527634737) :- at(Car, Location2), todo_at(Car, _), goal_at(Car2, Location), done_at(Car2, Location), at(Car, Location3), could_board_for_todo_at_any_location(Location3), !.
delta(74, sail(Location, Location2), 0.04107380220868497) :- at(Car, Location2), todo_at(Car, _), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(74, sail(_, Location), 0.0006568719914158736) :- at(Car, Location), todo_at(Car, _), todo_at(Car2, Location), on(Car2), !.
delta(74, sail(_, Location), -0.07337884021411618) :- at(Car, Location), todo_at(Car, _), !.
delta(74, sail(Location, Location2), 0.0008447281491261313) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location2), on(Car2), !.
delta(74, sail(Location, Location2), -0.010005850731170142) :- todo_at(Car, Location2), at(Car, Location), !.
delta(74, sail(Location, _), -0.0019913682191026925) :- todo_at(Car, Location), on(Car), !.
delta(74, sail(_, _), 0.05026653681072811) :- !.
delta(74, _, 0.0014469763681719972) :- at_ferry(Location), done_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(74, _, -0.01713958336673377) :- at_ferry(Location), done_at(_, Location), !.
delta(74, _, 0.03826906555923945).

% tree 75: step size 1.0, 228 examples, 11 leaves
delta(75, board(Car, Location), 0.05740215510375126) :- todo_at(_, Location), todo_at(Car, _), !.
delta(75, board(_, Location), -0.001454767252250792) :- todo_at(_, Location), !.
delta(75, board(Car, _), 0.004792284503248882) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(75, board(Car, _), -0.04618694512307464) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(75, board(_, Location), 0.009103497632976944) :- goal_at(_, Location), !.
delta(75, board(_, _), -0.0031941714494807946) :- !.
delta(75, _, -0.05512013333642926) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(75, _, 0.00010202545417930282) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(75, sail(_, Location), 0.05357105832255606) :- at(Car, Location), todo_at(Car, _), !.
delta(75, sail(_, _), -0.009208277528722705) :- !.
delta(75, _, -0.013946623051378127).

% tree 76: step size 1.0, 224 examples, 11 leaves
delta(76, board(Car, Location), 0.03624192868531086) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, _), !.
delta(76, board(_, Location), -0.004529791297461325) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(76, board(Car, _), 0.009529344515979346) :- todo_at(Car, Location), done_at(_, Location), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(76, board(Car, _), -0.00403226362077549) :- todo_at(Car, Location), done_at(_, Location), !.
delta(76, board(_, _), -0.06398597708659098) :- !.
delta(76, _, -0.03166361190634423) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(76, sail(_, _), -0.0005730669183069056) :- at_ferry(Location), done_at(_, Location), !.
delta(76, _, 0.0012529555882236695) :- at_ferry(Location), done_at(_, Location), !.
delta(76, _, 0.055070446876927255) :- at_ferry(Location), could_board(Location), !.
delta(76, sail(_, _), -0.0012302403756063562) :- !.
delta(76, _, 0.0013125457106694031).

% tree 77: step size 1.0, 241 examples, 11 leaves
delta(77, sail(Location, Location2), 0.00621109404477849) :- could_board_for_todo_at_any_location(Location2), at_ferry(Location3), could_board_for_todo_at_car_any(Location3), todo_at(Car, Location2), at(Car, Location), !.
delta(77, sail(_, Location), -0.014204898076330961) :- could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(77, sail(Location, Location2), 0.10984365752484944) :- could_board_for_todo_at_any_location(Location2), goal_at(Car, Location), done_at(Car, Location), !.
delta(77, sail(_, Location), -0.002629471913627552) :- could_board_for_todo_at_any_location(Location), !.
delta(77, sail(Location, Location2), 0.0347160521511464) :- goal_at(Car, Location2), done_at(Car, Location2), at(Car2, Location), todo_at(Car2, _), !.
delta(77, sail(_, Location), -0.01989661252915321) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(77, sail(_, _), -0.156285403504756) :- at_ferry(Location), could_board(Location), !.
delta(77, sail(_, _), 0.008839498579627129) :- !.
delta(77, _, 0.04196482264683095) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(77, _, 0.0031608281823157424) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(77, _, -0.003597084758599988).

% tree 78: step size 1.0, 222 examples, 10 leaves
delta(78, board(Car, Location), -0.005042371125097137) :- goal_at(Car, Location2), at(Car2, Location2), todo_at(_, Location), done_at(Car2, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(78, board(Car, Location), 0.01912192849237522) :- goal_at(Car, Location2), at(_, Location2), todo_at(_, Location), !.
delta(78, board(Car, _), -0.10459664610295553) :- goal_at(Car, Location), at(_, Location), !.
delta(78, board(_, _), 0.04430752373320981) :- !.
delta(78, _, -0.0356612888444729) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(78, sail(_, _), -0.00016515341801712582) :- at_ferry(Location), goal_at(_, Location), !.
delta(78, _, 0.00209327366370799) :- at_ferry(Location), goal_at(_, Location), !.
delta(78, _, 0.08310619994654427) :- at_ferry(Location), could_board(Location), !.
delta(78, sail(_, _), 0.00021087324369728407) :- !.
delta(78, _, -0.00021692613729383154).

% tree 79: step size 1.0, 221 examples, 8 leaves
delta(79, board(Car, _), -0.05918399116404357) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(79, board(Car, _), 0.01688928130707168) :- todo_at(Car, _), !.
delta(79, board(_, _), -0.00018848890484168658) :- !.
delta(79, _, 0.038431294506416594) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(79, sail(_, Location), -0.0640037399305263) :- todo_at(Car, Location), at(Car, _), !.
delta(79, sail(_, _), 0.03813409422152541) :- !.
delta(79, _, 0.028496079443499432) :- at_ferry(Location), todo_at(_, Location), !.
delta(79, _, -0.0022911958520026266).

% tree 80: step size 1.0, 267 examples, 12 leaves
delta(80, sail(Location, Location2), 0.04637435731888041) :- goal_at(Car, Location), todo_at(Car2, Location), at(Car2, Location2), todo_at(Car, Location3), at(_, Location3), !.
delta(80, sail(Location, Location2), -0.0054531334392557765) :- goal_at(_, Location), todo_at(Car, Location), at(Car, Location2), !.
delta(80, sail(Location, _), -0.09710545014513948) :- goal_at(Car, Location), goal_at(Car, Location2), at(_, Location2), !.
delta(80, sail(Location, _), 0.004863302546083564) :- goal_at(_, Location), !.
delta(80, sail(_, Location), 0.13270284146555753) :- at(Car, Location), todo_at(Car, Location2), at(Car2, Location2), todo_at(Car2, _), !.
delta(80, sail(_, Location), -0.009702588696360617) :- at(Car, Location), todo_at(Car, _), !.
delta(80, sail(_, Location), 0.0019369119603521775) :- todo_at(Car, Location), on(Car), !.
delta(80, sail(_, _), -0.012345074845300306) :- !.
delta(80, _, -0.0055684963669537695) :- at_ferry(Location), goal_at(Car, Location), done_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(80, _, -0.0009910683148354766) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), could_debark(Location2), !.
delta(80, _, 0.0706888260050883) :- at_ferry(Location), goal_at(_, Location), !.
delta(80, _, -0.11077983778747318).

% tree 81: step size 1.0, 237 examples, 9 leaves
delta(81, sail(_, Location), 0.08634510682017793) :- goal_at(Car, Location), done_at(Car, Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(81, sail(Location, Location2), -0.031125411283712604) :- goal_at(Car, Location2), done_at(Car, Location2), at(Car2, Location), todo_at(Car2, _), !.
delta(81, sail(_, Location), 0.0043509520975962305) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(81, sail(_, _), -0.07878274141234017) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(81, sail(_, _), 0.02044114229169856) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(81, sail(_, _), -0.012995385940309995) :- !.
delta(81, _, -0.0065225497697295395) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(81, _, 0.005268973517825236) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(81, _, 0.019160932292592303).

% tree 82: step size 1.0, 220 examples, 14 leaves
delta(82, board(Car, Location), 0.028101689537653837) :- todo_at(Car2, Location), at(Car2, Location2), done_at(_, Location2), todo_at(Car, _), !.
delta(82, board(_, Location), -0.0007022429568576868) :- todo_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(82, board(Car, Location), 0.018758740415875542) :- todo_at(_, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(82, board(_, Location), -0.06661458512264679) :- todo_at(_, Location), !.
delta(82, board(Car, _), 0.005941992052838169) :- goal_at(Car, Location), done_at(_, Location), todo_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(82, board(Car, _), -0.01291872196396019) :- goal_at(Car, Location), done_at(_, Location), !.
delta(82, board(_, _), 0.04041693532283787) :- !.
delta(82, _, -0.027626404596028196) :- at_ferry(Location), todo_at(Car, Location), at(Car, Location2), done_at(_, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(82, _, 0.0002921457150068017) :- at_ferry(Location), todo_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(82, _, 0.04459211838946027) :- at_ferry(Location), todo_at(Car, Location), at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(82, _, -0.0005330443885270883) :- at_ferry(Location), todo_at(_, Location), !.
delta(82, _, -0.034691945635105) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(82, sail(_, _), 0.0038950442075945985) :- !.
delta(82, _, -0.0037183506867785603).

% tree 83: step size 1.0, 208 examples, 12 leaves
delta(83, sail(Location, Location2), -0.010053798995500155) :- goal_at(Car, Location2), at(Car, Location3), could_board_for_todo_at_car_any(Location3), goal_at(Car2, Location3), at(Car2, Location), !.
delta(83, sail(_, Location), 0.09861796605625144) :- goal_at(Car, Location), at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(83, sail(_, Location), 0.006387285350694854) :- goal_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(83, sail(_, Location), -0.02220067324332076) :- goal_at(_, Location), !.
delta(83, sail(_, _), -0.07475467456729934) :- at_ferry(Location), could_board(Location), !.
delta(83, sail(Location, _), -0.001707860605134245) :- at(Car, Location), todo_at(Car, _), !.
delta(83, sail(_, _), 0.014009100541773645) :- !.
delta(83, _, 0.0003846002770731842) :- at_ferry(Location), todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), could_debark_todo_at(Location), !.
delta(83, _, -0.04449463110381949) :- at_ferry(Location), todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(83, _, 0.006044806752193082) :- at_ferry(Location), todo_at(_, Location), !.
delta(83, _, 0.025975418820664842) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(83, _, -0.0010814120787046885).

% tree 84: step size 1.0, 293 examples, 7 leaves
delta(84, board(Car, _), 0.018141946316756277) :- todo_at(Car, Location), done_at(_, Location), !.
delta(84, board(_, _), -0.0753084737978176) :- !.
delta(84, _, 0.05381186263427498) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(84, sail(_, Location), -0.021344035736393666) :- could_board_for_todo_at_any_location(Location), !.
delta(84, sail(_, _), 0.018566494952296616) :- !.
delta(84, _, 0.0032747754533083238) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(84, _, -0.0025925708083670233).

% tree 85: step size 1.0, 225 examples, 11 leaves
delta(85, sail(Location, Location2), -0.0018571156179098317) :- goal_at(Car, Location2), at(Car, Location3), todo_at(Car2, Location2), todo_at(Car2, Location3), todo_at(Car3, Location2), at(Car3, Location), !.
delta(85, sail(_, Location), 0.0048467879002153024) :- goal_at(Car, Location), at(Car, Location2), todo_at(Car2, Location), todo_at(Car2, Location2), !.
delta(85, sail(_, Location), 0.0014441912932468362) :- goal_at(Car, Location), at(Car, _), todo_at(Car2, Location), on(Car2), !.
delta(85, sail(_, Location), -0.06804900123639744) :- goal_at(Car, Location), at(Car, _), !.
delta(85, sail(Location, Location2), 0.008275844717656489) :- at(Car, Location), todo_at(Car, _), todo_at(Car2, Location), at(Car2, Location2), !.
delta(85, sail(Location, _), -0.033645178954345316) :- at(Car, Location), todo_at(Car, _), !.
delta(85, sail(Location, _), -0.0009151508819730649) :- todo_at(Car, Location), on(Car), !.
delta(85, sail(_, _), 0.05381739582985829) :- !.
delta(85, _, 0.03760272983159013) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(85, _, 0.0029524018192207467) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(85, _, -0.0030557167074273376).

% tree 86: step size 1.0, 221 examples, 12 leaves
delta(86, sail(Location, Location2), 0.01383548401600017) :- todo_at(Car, Location2), at(Car, _), at_ferry(Location3), could_board(Location3), todo_at(Car2, Location), at(Car2, Location2), !.
delta(86, sail(_, Location), -0.07957897056320591) :- todo_at(Car, Location), at(Car, _), at_ferry(Location2), could_board(Location2), !.
delta(86, sail(_, Location), 0.044644561683053335) :- todo_at(Car, Location), at(Car, Location2), goal_at(Car2, Location2), done_at(Car2, Location2), !.
delta(86, sail(_, Location), -0.004156678154261019) :- todo_at(Car, Location), at(Car, _), !.
delta(86, sail(_, Location), 0.13675571483519336) :- at_ferry(Location2), at(_, Location2), at(_, Location), !.
delta(86, sail(_, _), -0.018396853191388087) :- at_ferry(Location), at(_, Location), !.
delta(86, sail(_, Location), -0.05386042307909053) :- at(_, Location), !.
delta(86, sail(_, _), 0.01756585990646179) :- !.
delta(86, _, -0.06995114014488514) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(86, _, 0.012211884056167303) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(86, _, 0.0026794397313819555) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(86, _, -0.007288933228914707).

% tree 87: step size 1.0, 236 examples, 10 leaves
delta(87, board(Car, Location), -0.011558822913402246) :- goal_at(Car2, Location), done_at(Car2, Location), goal_at(Car, Location2), done_at(_, Location2), goal_at(Car, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(87, board(Car, Location), 0.007361969398969058) :- goal_at(Car2, Location), done_at(Car2, Location), goal_at(Car, Location2), done_at(_, Location2), !.
delta(87, board(_, Location), 0.06804654335748529) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(87, board(_, _), -0.07882975464103383) :- !.
delta(87, _, -0.06156113680427873) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(87, _, 0.0008250486150652862) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board(Location2), !.
delta(87, _, -1.1855353665923305e-20) :- at_ferry(Location), done_at(_, Location), !.
delta(87, _, 0.07562279363762942) :- at_ferry(Location), could_board(Location), !.
delta(87, sail(_, _), -0.000536536026198607) :- !.
delta(87, _, 0.0005797312656492363).

% tree 88: step size 1.0, 238 examples, 11 leaves
delta(88, board(Car, _), 0.002255307674191314) :- todo_at(Car, Location), at(Car2, Location), todo_at(Car2, Location2), done_at(_, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(88, board(Car, _), -0.02463647903163142) :- todo_at(Car, Location), at(Car2, Location), todo_at(Car2, Location2), done_at(_, Location2), !.
delta(88, board(Car, _), 0.06434999693346688) :- todo_at(Car, Location), at(Car2, Location), goal_at(Car2, Location2), at(_, Location2), !.
delta(88, board(Car, _), -0.010712026647571708) :- todo_at(Car, Location), at(_, Location), !.
delta(88, board(_, _), -0.0547544703191943) :- !.
delta(88, _, 0.03407825502530157) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), at_ferry(Location2), could_board_for_todo_at_car_any(Location2), !.
delta(88, _, 5.122214018910207e-5) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(88, sail(_, Location), 0.04945171808737304) :- todo_at(_, Location), !.
delta(88, sail(_, _), -0.06310269967091446) :- !.
delta(88, _, 0.002277183554745904) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(88, _, -0.00041547107156190847).

% tree 89: step size 1.0, 275 examples, 12 leaves
delta(89, board(Car, _), 0.005034264195326225) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(89, board(Car, Location), 0.0023344205596224207) :- goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), todo_at(Car2, Location), at(Car2, Location2), !.
delta(89, board(Car, _), -0.027718781802058067) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(89, board(Car, _), 0.028839117128489574) :- todo_at(Car, _), !.
delta(89, board(_, _), -0.0004478170706442731) :- !.
delta(89, _, 0.01832642740108648) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_any_location(Location2), goal_at(Car, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(89, _, 5.267195598361686e-5) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(89, _, -0.002923881313691872) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(89, _, 0.0003795761636614785) :- at_ferry(Location), done_at(_, Location), !.
delta(89, sail(_, Location), -0.06768492841907534) :- goal_at(Car, Location), at(Car, _), !.
delta(89, sail(_, _), 0.04686560036226476) :- !.
delta(89, _, 0.0008075524179866254).

% tree 90: step size 1.0, 203 examples, 9 leaves
delta(90, board(Car, _), 0.014963027493499526) :- todo_at(Car, Location), at(Car2, Location), todo_at(Car2, Location2), done_at(_, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(90, board(Car, _), -0.01590181276475458) :- todo_at(Car, Location), at(Car2, Location), todo_at(Car2, Location2), done_at(_, Location2), !.
delta(90, board(Car, _), 0.11035478898519054) :- todo_at(Car, Location), at(_, Location), !.
delta(90, board(_, _), -0.056494092854675715) :- !.
delta(90, _, -0.054617151764845544) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(90, sail(_, Location), -0.04236503812677529) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(90, sail(_, _), 0.04949518147592321) :- !.
delta(90, _, 0.0021480448973905373) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(90, _, -0.010176275958969375).

% tree 91: step size 1.0, 218 examples, 9 leaves
delta(91, sail(Location, Location2), 0.005732625719097451) :- goal_at(Car, Location2), done_at(Car, Location2), goal_at(Car2, Location), done_at(Car2, Location), goal_at(Car, Location3), could_debark_for_todo_at_any_location(Location3), !.
delta(91, sail(Location, Location2), -0.02011671544409945) :- goal_at(Car, Location2), done_at(Car, Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(91, sail(Location, Location2), -0.0006748415874948482) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(Car2, Location2), at(Car2, Location), !.
delta(91, sail(_, Location), 0.04556890917850979) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(91, sail(Location, Location2), 0.02982279029004211) :- goal_at(Car, Location), done_at(Car, Location), could_board(Location2), !.
delta(91, sail(Location, _), -0.02392913772755312) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(91, sail(Location, Location2), 0.00208519363015614) :- todo_at(Car, Location), at(Car, Location2), !.
delta(91, sail(_, _), -0.06050190506668747) :- !.
delta(91, _, 0.024232618016447622).

% tree 92: step size 1.0, 246 examples, 6 leaves
delta(92, board(_, _), -0.09628087417429196) :- !.
delta(92, _, 0.09078821839887088) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(92, sail(Location, Location2), -0.03914230031692202) :- todo_at(Car, Location), at(Car, Location2), !.
delta(92, sail(_, _), 0.033655358250009856) :- !.
delta(92, _, 0.0021663510740512126) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(92, _, -0.0006420879656235685).

% tree 93: step size 1.0, 226 examples, 10 leaves
delta(93, board(Car, _), 0.010264780098652265) :- todo_at(Car, Location), done_at(_, Location), !.
delta(93, board(Car, _), -0.029060726119278468) :- goal_at(Car, Location), at(Car2, Location), goal_at(Car2, Location2), done_at(_, Location2), !.
delta(93, board(Car, _), 0.007014364155356521) :- goal_at(Car, Location), at(_, Location), !.
delta(93, board(_, Location), 0.005239266318949466) :- goal_at(_, Location), !.
delta(93, board(_, _), -0.002771887780044077) :- !.
delta(93, _, 0.008625149737307658) :- at_ferry(Location), could_board_for_todo_at_any_location(Location), !.
delta(93, sail(Location, Location2), 0.026703042037543243) :- todo_at(Car, Location), at(Car, Location2), !.
delta(93, sail(_, _), -0.0247664472300976) :- !.
delta(93, _, 0.0020583538155770657) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(93, _, -0.0005848684523070787).

% tree 94: step size 1.0, 230 examples, 12 leaves
delta(94, board(Car, Location), 0.0029084138792252537) :- goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car3, Location), at(Car3, Location2), !.
delta(94, board(Car, Location), -0.0016478002158264674) :- goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(94, board(Car, _), -0.12676210660682508) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(94, board(Car, _), 0.039244037346366355) :- todo_at(Car, _), !.
delta(94, board(_, _), -0.00035228919634046487) :- !.
delta(94, sail(_, Location), 0.08992833387030467) :- at_ferry(Location2), done_at(_, Location2), could_board_for_todo_at_any_location(Location), !.
delta(94, sail(_, _), -0.1354376482355448) :- at_ferry(Location), done_at(_, Location), !.
delta(94, _, 0.04553078233151176) :- at_ferry(Location), done_at(_, Location), todo_at(_, Location), !.
delta(94, _, -0.004836220383439093) :- at_ferry(Location), done_at(_, Location), !.
delta(94, _, 0.09533611000401883) :- at_ferry(Location), could_board(Location), !.
delta(94, sail(_, _), 0.0013432770116111035) :- !.
delta(94, _, -0.0014256883279190162).

% tree 95: step size 1.0, 205 examples, 13 leaves
delta(95, board(_, Location), 0.008126075301139053) :- goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), at(Car, Location3), could_board_for_todo_at_any_location(Location3), !.
delta(95, board(_, Location), -0.017253938178618866) :- goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(95, board(_, Location), 0.06377318638006146) :- goal_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(95, board(_, Location), -0.004143656532386153) :- goal_at(_, Location), !.
delta(95, board(Car, _), -0.055144541550096356) :- todo_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(95, board(_, _), 0.014366678641670804) :- !.
delta(95, _, 0.008194888610125104) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), empty_ferry, !.
delta(95, _, 0.0) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(95, _, -0.05920054964120585) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(95, _, 0.003884502700844702) :- at_ferry(Location), goal_at(_, Location), !.
delta(95, _, 0.038930432549750954) :- at_ferry(Location), could_board(Location), !.
delta(95, sail(_, _), 0.00022065711451546913) :- !.
delta(95, _, -0.00023134268973867825).

% tree 96: step size 1.0, 281 examples, 7 leaves
delta(96, sail(Location, Location2), -0.00012402831305242056) :- todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), todo_at(Car2, Location2), at(Car2, Location), !.
delta(96, sail(Location, Location2), 0.04520867112044774) :- todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(96, sail(Location, Location2), -0.0035245115208002603) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), at(_, Location3), !.
delta(96, sail(Location, Location2), 0.0019285750114851504) :- todo_at(Car, Location), at(Car, Location2), !.
delta(96, sail(_, Location), 0.004128556946516168) :- todo_at(Car, Location), on(Car), !.
delta(96, sail(_, _), -0.06796614921374487) :- !.
delta(96, _, 0.03282716923376571).

% tree 97: step size 1.0, 256 examples, 11 leaves
delta(97, board(Car, Location), -0.006519155273504542) :- goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), todo_at(Car2, Location), at(Car2, Location3), done_at(_, Location3), !.
delta(97, board(Car, Location), 0.014325608503168247) :- goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), todo_at(_, Location), !.
delta(97, board(Car, _), -0.03974174514077603) :- goal_at(Car, Location), could_board_for_todo_at_car_any(Location), !.
delta(97, board(Car, _), 0.023358113848532227) :- todo_at(Car, _), !.
delta(97, board(_, _), -0.00015119843148746193) :- !.
delta(97, sail(_, Location), -0.06230709849589388) :- at_ferry(Location2), todo_at(_, Location2), at(_, Location), !.
delta(97, sail(_, _), 0.04811752376568408) :- at_ferry(Location), todo_at(_, Location), !.
delta(97, _, 0.0014600964238296666) :- at_ferry(Location), todo_at(_, Location), !.
delta(97, _, 0.026340329556042888) :- at_ferry(Location), could_board_for_todo_at_car_any(Location), !.
delta(97, sail(_, _), 0.00041510049297682414) :- !.
delta(97, _, -0.0003476972555428481).

% tree 98: step size 1.0, 202 examples, 12 leaves
delta(98, sail(Location, Location2), 0.03393175057910832) :- goal_at(Car, Location2), done_at(Car, Location2), todo_at(_, Location2), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(98, sail(_, Location), -0.016448974815259435) :- goal_at(Car, Location), done_at(Car, Location), todo_at(_, Location), !.
delta(98, sail(_, Location), -0.07484720358311617) :- goal_at(Car, Location), done_at(Car, Location), at(Car2, Location), todo_at(Car2, _), !.
delta(98, sail(_, Location), 0.01745751423607677) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(98, sail(Location, Location2), -0.012049969218877608) :- could_board(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(98, sail(_, Location), 0.09786538552604088) :- could_board(Location), !.
delta(98, sail(_, _), 0.017597002616283722) :- at_ferry(Location), could_debark(Location), !.
delta(98, sail(_, _), -0.029980651517805042) :- !.
delta(98, _, 0.0016860491406532716) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(98, _, -0.016911706453020026) :- at_ferry(Location), done_at(_, Location), todo_at(_, Location), !.
delta(98, _, 0.015987111649095668) :- at_ferry(Location), done_at(_, Location), !.
delta(98, _, -0.04599280475937669).

% tree 99: step size 1.0, 239 examples, 13 leaves
delta(99, sail(_, Location), 0.0004988636570172459) :- goal_at(Car, Location), at(Car, _), at(Car2, Location), todo_at(Car2, _), could_debark_todo_at(Location), !.
delta(99, sail(_, Location), -0.11206331282272339) :- goal_at(Car, Location), at(Car, _), at(Car2, Location), todo_at(Car2, _), !.
delta(99, sail(Location, Location2), 0.05907229806502795) :- goal_at(Car, Location2), at(Car, _), goal_at(Car2, Location), done_at(Car2, Location), !.
delta(99, sail(_, Location), -0.009948312987507275) :- goal_at(Car, Location), at(Car, _), !.
delta(99, sail(Location, Location2), 0.0006740442009910291) :- could_board(Location2), todo_at(Car, Location), at(Car, Location2), !.
delta(99, sail(_, Location), 0.0922502087887565) :- could_board(Location), !.
delta(99, sail(_, _), 0.004612361784552219) :- at_ferry(Location), could_debark(Location), !.
delta(99, sail(_, _), -0.027415557804429756) :- !.
delta(99, _, 0.017658243566478993) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(99, _, 0.0011576371832540133) :- at_ferry(Location), goal_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(99, _, -0.0351165587177247) :- at_ferry(Location), goal_at(_, Location), !.
delta(99, board(_, _), 0.01201983812687621) :- !.
delta(99, _, -0.0057142669455808644).

% tree 100: step size 1.0, 203 examples, 12 leaves
delta(100, board(Car, Location), -0.008698351669006892) :- todo_at(Car, Location2), at(Car2, Location2), done_at(Car2, Location3), could_board_for_todo_at_car_any(Location3), todo_at(_, Location), !.
delta(100, board(Car, _), 0.005200268444723948) :- todo_at(Car, Location), at(Car2, Location), done_at(Car2, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(100, board(Car, _), 0.04569617418058306) :- todo_at(Car, Location), at(_, Location), !.
delta(100, board(_, Location), -0.02359912273380436) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(100, board(_, Location), 0.002306457655775216) :- todo_at(_, Location), !.
delta(100, board(_, _), -0.001710218653133558) :- !.
delta(100, _, 0.019141360916333967) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(100, sail(_, _), -0.0006397154576368743) :- at_ferry(Location), done_at(_, Location), !.
delta(100, _, 0.0007703646052729762) :- at_ferry(Location), done_at(_, Location), !.
delta(100, _, -0.03834964777047869) :- at_ferry(Location), could_board(Location), !.
delta(100, sail(_, _), 0.010815853282270957) :- !.
delta(100, _, -0.011491696656716635).

% tree 101: step size 1.0, 237 examples, 15 leaves
delta(101, sail(Location, Location2), 0.14212331403643305) :- could_board_for_todo_at_any_location(Location2), goal_at(_, Location), at(Car, Location2), todo_at(Car, _), !.
delta(101, sail(Location, Location2), -0.002662430928097614) :- could_board_for_todo_at_any_location(Location2), goal_at(_, Location), !.
delta(101, sail(_, Location), -0.015390031409288567) :- could_board_for_todo_at_any_location(Location), at(Car, Location), todo_at(Car, _), !.
delta(101, sail(_, Location), 0.016748690361629466) :- could_board_for_todo_at_any_location(Location), !.
delta(101, sail(Location, Location2), -0.0005287477461966808) :- todo_at(Car, Location), at(Car, Location2), todo_at(Car, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(101, sail(Location, Location2), 0.01399434884838915) :- todo_at(Car, Location), at(Car, Location2), !.
delta(101, sail(_, Location), 0.0033868248131858673) :- todo_at(Car, Location), on(Car), !.
delta(101, sail(_, _), -0.14162323847356617) :- !.
delta(101, _, 0.0008829517245529804) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), done_at(_, Location2), could_debark_todo_at(Location), !.
delta(101, _, -0.028362104505805417) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(101, _, -3.15023715490884e-6) :- at_ferry(Location), goal_at(Car, Location), at(Car, Location2), could_debark_todo_at(Location2), !.
delta(101, _, 0.00888096984719263) :- at_ferry(Location), goal_at(_, Location), !.
delta(101, board(Car, _), 0.024720531521618253) :- todo_at(Car, Location), at(_, Location), !.
delta(101, board(_, _), -0.0003303131450940294) :- !.
delta(101, _, -8.065229718525976e-5).

% tree 102: step size 1.0, 222 examples, 11 leaves
delta(102, sail(Location, Location2), 0.018017137762689373) :- goal_at(Car, Location), done_at(Car, Location), todo_at(_, Location), todo_at(Car2, Location2), at(Car2, Location), !.
delta(102, sail(Location, _), -0.029753489495225383) :- goal_at(Car, Location), done_at(Car, Location), todo_at(_, Location), !.
delta(102, sail(Location, Location2), -0.0007320837248846119) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location2), at(Car2, Location), !.
delta(102, sail(Location, _), 0.05351595459593917) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(102, sail(_, Location), 0.009274716942566862) :- at(Car, Location), at(Car, Location2), could_debark_for_todo_at_any_location(Location2), !.
delta(102, sail(_, Location), -0.04566941562005037) :- at(_, Location), !.
delta(102, sail(Location, _), -0.009316186780746735) :- todo_at(_, Location), !.
delta(102, sail(_, _), 0.021826134136621034) :- !.
delta(102, _, 0.012840952527690646) :- at_ferry(Location), done_at(_, Location), todo_at(_, Location), !.
delta(102, _, -0.05467813684476854) :- at_ferry(Location), done_at(_, Location), !.
delta(102, _, 0.02954089681575026).

% tree 103: step size 1.0, 218 examples, 9 leaves
delta(103, sail(_, Location), -0.04744391382243221) :- could_board_for_todo_at_any_location(Location), at(Car, Location), todo_at(Car, _), !.
delta(103, sail(Location, Location2), -0.004375094750372475) :- could_board_for_todo_at_any_location(Location2), goal_at(_, Location), !.
delta(103, sail(_, Location), 0.011826466428785456) :- could_board_for_todo_at_any_location(Location), !.
delta(103, sail(Location, Location2), 0.00035965404871987665) :- todo_at(Car, Location2), at(Car, Location), todo_at(Car2, Location2), on(Car2), !.
delta(103, sail(Location, Location2), -0.0032983707522453395) :- todo_at(Car, Location2), at(Car, Location), !.
delta(103, sail(Location, _), -0.0012572872390002481) :- todo_at(Car, Location), on(Car), !.
delta(103, sail(_, _), 0.08314738856602011) :- !.
delta(103, _, 0.0013982321769715677) :- at_ferry(Location), could_debark_todo_at(Location), !.
delta(103, _, -0.046672470876847755).

% tree 104: step size 1.0, 202 examples, 8 leaves
delta(104, sail(Location, Location2), 0.0031507100192518967) :- could_board_for_todo_at_any_location(Location2), goal_at(_, Location), todo_at(Car, Location), at(Car, Location2), !.
delta(104, sail(Location, Location2), -0.036714387685893156) :- could_board_for_todo_at_any_location(Location2), goal_at(_, Location), !.
delta(104, sail(_, Location), -0.0012861771273003232) :- could_board_for_todo_at_any_location(Location), goal_at(Car, Location), done_at(Car, Location), !.
delta(104, sail(_, Location), 0.02257077577675179) :- could_board_for_todo_at_any_location(Location), !.
delta(104, sail(_, Location), 0.0032908356186680103) :- could_debark_for_todo_at_any_location(Location), todo_at(Car, Location), on(Car), !.
delta(104, sail(_, Location), -0.004522131790489045) :- could_debark_for_todo_at_any_location(Location), !.
delta(104, sail(_, _), 0.09277296938015911) :- !.
delta(104, _, -0.08739557789390096).

% tree 105: step size 1.0, 286 examples, 11 leaves
delta(105, board(Car, Location), 0.033849797795089814) :- todo_at(Car, Location2), at(_, Location2), goal_at(_, Location), !.
delta(105, board(Car, _), -0.01713463579109972) :- todo_at(Car, Location), at(Car2, Location), todo_at(Car2, Location2), at(_, Location2), !.
delta(105, board(Car, _), 0.008702275776000842) :- todo_at(Car, Location), at(_, Location), !.
delta(105, board(_, _), -0.03138038990876854) :- !.
delta(105, _, 0.02196533877962817) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), could_board_for_todo_at_car_any(Location), !.
delta(105, _, 0.00012566656080577294) :- at_ferry(Location), goal_at(Car, Location), todo_at(Car, Location2), done_at(_, Location2), !.
delta(105, _, -0.04031888400099902) :- at_ferry(Location), goal_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(105, _, 1.0353884218125726e-5) :- at_ferry(Location), goal_at(_, Location), !.
delta(105, _, 0.027849224496245658) :- at_ferry(Location), could_board(Location), !.
delta(105, sail(_, _), 8.597122625345653e-5) :- !.
delta(105, _, -8.74769281067833e-5).

% tree 106: step size 1.0, 208 examples, 13 leaves
delta(106, sail(_, Location), 0.07727074020395878) :- could_board_for_todo_at_car_any(Location), goal_at(Car, Location), at(Car, Location2), done_at(_, Location2), !.
delta(106, sail(_, Location), -0.008596330365805826) :- could_board_for_todo_at_car_any(Location), goal_at(_, Location), !.
delta(106, sail(_, Location), -0.020526008412106955) :- could_board_for_todo_at_car_any(Location), at_ferry(Location2), could_board_for_todo_at_any_location(Location2), !.
delta(106, sail(_, Location), 0.02223847759730316) :- could_board_for_todo_at_car_any(Location), !.
delta(106, sail(Location, Location2), -0.0005108734370474435) :- could_debark_for_todo_at_any_location(Location2), todo_at(Car, Location), on(Car), !.
delta(106, sail(_, Location), 0.008005233167760393) :- could_debark_for_todo_at_any_location(Location), !.
delta(106, sail(_, Location), 0.0015157037663961197) :- could_board_for_todo_at_any_location(Location), !.
delta(106, sail(_, _), -0.046806553769948016) :- !.
delta(106, _, 0.0005527156973309846) :- at_ferry(Location), done_at(_, Location), todo_at(Car, Location), on(Car), !.
delta(106, _, -0.03949395111155834) :- at_ferry(Location), done_at(_, Location), !.
delta(106, _, 0.011106672191108653) :- at_ferry(Location), todo_at(Car, Location), at(Car, Location2), goal_at(_, Location2), !.
delta(106, _, -9.995610379255573e-5) :- at_ferry(Location), todo_at(_, Location), !.
delta(106, _, -0.00463992554262675).

% tree 107: step size 1.0, 202 examples, 9 leaves
delta(107, board(Car, _), -0.08402811827790986) :- goal_at(Car, Location), at(_, Location), !.
delta(107, board(_, _), 0.030967707694911986) :- !.
delta(107, _, -0.021778237271328955) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_any_location(Location2), goal_at(Car, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(107, _, 2.8812723755668896e-5) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(107, _, 0.010268758340404683) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(107, _, 2.2595527670091245e-5) :- at_ferry(Location), done_at(_, Location), !.
delta(107, _, 0.06282204313966168) :- at_ferry(Location), could_board(Location), !.
delta(107, sail(_, _), 4.5552323469707054e-5) :- !.
delta(107, _, -4.6687900753202565e-5).

% tree 108: step size 1.0, 258 examples, 12 leaves
delta(108, board(_, Location), -0.056331905644973014) :- goal_at(Car, Location), done_at(Car, Location), todo_at(Car2, Location), at(Car2, Location2), done_at(_, Location2), !.
delta(108, board(_, Location), 0.01132251306893104) :- goal_at(Car, Location), done_at(Car, Location), todo_at(_, Location), !.
delta(108, board(Car, Location), 0.02130972394396475) :- goal_at(Car2, Location), done_at(Car2, Location), todo_at(Car, _), !.
delta(108, board(_, Location), -0.0007931154676801186) :- goal_at(Car, Location), done_at(Car, Location), !.
delta(108, board(_, _), 0.04871615799925839) :- !.
delta(108, _, 0.04271090282894035) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_any_location(Location2), goal_at(Car, Location3), could_board_for_todo_at_car_any(Location3), !.
delta(108, _, 2.7073997465255425e-5) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_any_location(Location2), !.
delta(108, _, -0.02040919857324543) :- at_ferry(Location), done_at(Car, Location), goal_at(Car, Location2), could_board_for_todo_at_car_any(Location2), !.
delta(108, _, 3.132376594124096e-5) :- at_ferry(Location), done_at(_, Location), !.
delta(108, _, -0.04635532644025342) :- at_ferry(Location), could_board(Location), !.
delta(108, sail(_, _), -0.00043197177522517503) :- !.
delta(108, _, 0.0004467738763098962).
