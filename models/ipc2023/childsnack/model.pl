% SHA-256 of what follows: 46a962e2bc2b5eec182491566cb1e03333cc95502168f009e7eff80d145d8a77
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
model(domain, 'childsnack.pl').
model(domain_sha256, bf55754b14bc9cd031fbcdeda319012ad5f789af7b9b8445ecd40caad3371f0a).
model(action, make_sandwich_no_gluten(sandwich, bread_portion, content_portion)).
model(action, make_sandwich(sandwich, bread_portion, content_portion)).
model(action, put_on_tray(sandwich, tray)).
model(action, serve_sandwich_no_gluten(sandwich, child, tray, place)).
model(action, serve_sandwich(sandwich, child, tray, place)).
model(action, move_tray(tray, place, place)).
model(literal, todo_served(child)).
model(literal, goal_served(child)).
model(literal, done_served(child)).
model(literal, at_kitchen_bread(bread_portion)).
model(literal, at_kitchen_content(content_portion)).
model(literal, at_kitchen_sandwich(sandwich)).
model(literal, ontray(sandwich, tray)).
model(literal, no_gluten_sandwich(sandwich)).
model(literal, served(child)).
model(literal, at(tray, place)).
model(literal, notexist(sandwich)).
model(literal, no_gluten_bread(bread_portion)).
model(literal, no_gluten_content(content_portion)).
model(literal, allergic_gluten(child)).
model(literal, not_allergic_gluten(child)).
model(literal, waiting(child, place)).
model(literal, needed_at_to_serve_sandwich_no_gluten(place)).
model(literal, could_put_on_tray(tray, place)).
model(literal, could_serve_sandwich_no_gluten(tray, place)).
model(literal, could_serve_sandwich(tray, place)).
model(literal, fewer_ontray_1_than_todo_served).
model(literal, fewer_ontray_1_than_allergic_gluten).
model(literal, fewer_ontray_1_than_todo_served_allergic_gluten).
model(literal, fewer_no_gluten_sandwich_than_todo_served).
model(literal, fewer_no_gluten_sandwich_than_allergic_gluten).
model(literal, fewer_no_gluten_sandwich_than_todo_served_allergic_gluten).
model(literal, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten).
model(literal, fewer_ontray_2_than_todo_served).
model(literal, fewer_ontray_2_than_allergic_gluten).
model(literal, fewer_at_1_than_todo_served).
model(literal, fewer_at_1_than_allergic_gluten).
model(literal, fewer_at_1_than_todo_served_allergic_gluten).
model(literal, fewer_at_2_than_todo_served).
model(literal, fewer_at_2_than_allergic_gluten).
model(literal, fewer_at_2_than_todo_served_allergic_gluten).
model(literal, fewer_ontray_1_than_not_allergic_gluten).
model(literal, fewer_ontray_1_than_todo_served_not_allergic_gluten).
model(literal, fewer_ontray_2_than_not_allergic_gluten).
model(literal, fewer_ontray_2_than_todo_served_not_allergic_gluten).
model(literal, fewer_at_1_than_not_allergic_gluten).
model(literal, fewer_at_1_than_todo_served_not_allergic_gluten).
model(literal, fewer_at_2_than_todo_served_not_allergic_gluten).
model(bias, 'childsnack.yaml').
model(bias_sha256, '21f54664b7121bd667183b786f287a71c3fe1cf9647f65f019435ad5f229255a').
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
model(tree, max_depth=4).
model(tree, min_examples=2).
model(tree, min_variance=1.0e-9).
model(tree, significance=1.0).
model(tree, granularity=0).
model(curve, evaluate_every=0).
model(curve, seconds=180.0).
model(trained_episodes, 1228).
model(trees, 142).

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

domain(childsnack).
:- ensure_loaded('childsnack.pl').
:- add_import_module(policy, childsnack, start).

% tree 1: step size 1.0, 212 examples, 14 leaves
delta(1, make_sandwich_no_gluten(_, _, _), 1.2430583188440065) :- !.
delta(1, make_sandwich(_, Bread_portion, _), -1.2002671714703887) :- no_gluten_bread(Bread_portion), !.
delta(1, make_sandwich(_, _, Content_portion), -0.3019540838131606) :- no_gluten_content(Content_portion), !.
delta(1, make_sandwich(_, _, _), 0.3931268157745112) :- !.
delta(1, put_on_tray(Sandwich, _), 0.7936021921279892) :- no_gluten_sandwich(Sandwich), !.
delta(1, put_on_tray(_, _), -0.6429283563793097) :- fewer_ontray_1_than_allergic_gluten, !.
delta(1, put_on_tray(_, _), 0.05827367642109366) :- !.
delta(1, serve_sandwich_no_gluten(_, _, _, _), 0.4175320661165325) :- !.
delta(1, serve_sandwich(_, _, _, _), 0.11487481590574376) :- !.
delta(1, move_tray(Tray, _, Place), 0.5423948828997279) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(1, move_tray(_, Place, Place2), 0.2065992723356924) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(1, move_tray(_, Place, Place2), -0.17322702569252407) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(1, move_tray(_, _, _), -1.0859133443386004) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 204 examples, 12 leaves
delta(2, make_sandwich_no_gluten(_, _, _), 0.6744957265998456) :- !.
delta(2, make_sandwich(_, _, _), -0.865279904073295) :- !.
delta(2, put_on_tray(_, _), -0.10175170582023671) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(2, put_on_tray(_, _), -0.007196521008735356) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(2, put_on_tray(_, _), 0.607108031025634) :- !.
delta(2, serve_sandwich_no_gluten(_, _, _, _), 0.5516516585746465) :- !.
delta(2, serve_sandwich(_, _, _, _), 0.05962639372936235) :- !.
delta(2, move_tray(Tray, _, Place), 0.5837086569188893) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(2, move_tray(_, Place, Place2), 0.384067638749122) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(2, move_tray(_, Place, Place2), -0.2759002303393807) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(2, move_tray(_, _, _), -0.765454780716337) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 203 examples, 19 leaves
delta(3, make_sandwich_no_gluten(_, _, _), 0.3552211792853426) :- !.
delta(3, make_sandwich(_, _, _), -0.930941082243922) :- todo_served(Child), allergic_gluten(Child), !.
delta(3, make_sandwich(_, _, _), 0.08734214060146704) :- !.
delta(3, put_on_tray(_, _), -0.0859364608363407) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(3, put_on_tray(_, _), -0.006840840980431197) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(3, put_on_tray(_, _), 0.22086063828293487) :- !.
delta(3, serve_sandwich_no_gluten(_, _, _, _), 0.5642380646153871) :- !.
delta(3, serve_sandwich(_, _, _, _), -0.36236394484757095) :- todo_served(Child), allergic_gluten(Child), !.
delta(3, serve_sandwich(_, _, _, _), 0.08076119583795478) :- !.
delta(3, move_tray(_, _, Place), -0.049437163506995396) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), todo_served(Child), waiting(Child, Place), !.
delta(3, move_tray(_, _, kitchen), -0.011335618337866163) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(3, move_tray(_, _, _), 0.8645904710155686) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at_kitchen_sandwich(_), !.
delta(3, move_tray(_, _, _), -0.007387242748236372) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(3, move_tray(Tray, _, Place), 0.3131874807143081) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(3, move_tray(_, Place, Place2), 0.177406716114923) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(3, move_tray(_, Place, Place2), -0.20378369296032453) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(3, move_tray(_, Place, Place2), 0.13242784380305606) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(3, move_tray(_, _, _), -0.5590727749191537) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 212 examples, 22 leaves
delta(4, make_sandwich_no_gluten(_, _, _), 0.16912479779722317) :- todo_served(Child), allergic_gluten(Child), !.
delta(4, make_sandwich_no_gluten(_, _, _), 0.0012318276141470778) :- !.
delta(4, make_sandwich(_, _, _), -0.013944436483604907) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(4, make_sandwich(_, _, _), 0.20765011759633575) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(4, make_sandwich(_, _, _), -0.20394532669416557) :- !.
delta(4, put_on_tray(Sandwich, _), -0.2583666956568106) :- fewer_no_gluten_sandwich_than_todo_served, no_gluten_sandwich(Sandwich), !.
delta(4, put_on_tray(_, _), 0.17445382986767397) :- fewer_no_gluten_sandwich_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(4, put_on_tray(_, _), -0.002538531574087283) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(4, put_on_tray(Sandwich, _), 0.2549461643850449) :- no_gluten_sandwich(Sandwich), !.
delta(4, put_on_tray(_, _), -0.11036664416991811) :- todo_served(Child), allergic_gluten(Child), !.
delta(4, put_on_tray(_, _), 0.030280135360188094) :- !.
delta(4, serve_sandwich_no_gluten(_, _, _, _), 0.4032193055983664) :- !.
delta(4, serve_sandwich(_, _, Tray, _), 0.037617420324968794) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(4, serve_sandwich(_, _, Tray, _), -1.575406902138579) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(4, serve_sandwich(_, _, _, _), 0.09320351835896991) :- !.
delta(4, move_tray(_, Place, _), -0.03828859966711329) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(4, move_tray(_, Place, _), 1.6732225528890945) :- done_served(Child), waiting(Child, Place), !.
delta(4, move_tray(Tray, _, Place), 0.19901716166420597) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(4, move_tray(_, Place, Place2), 0.12117817987683101) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), goal_served(Child), done_served(Child), !.
delta(4, move_tray(_, Place, Place2), -0.020485469583425984) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(4, move_tray(_, _, _), -0.47996258402089215) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 223 examples, 23 leaves
delta(5, make_sandwich_no_gluten(_, _, _), 0.13568796644593806) :- !.
delta(5, make_sandwich(_, _, Content_portion), -0.2956186548652609) :- no_gluten_content(Content_portion), !.
delta(5, make_sandwich(_, Bread_portion, _), -0.008305664388224257) :- fewer_no_gluten_sandwich_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(5, make_sandwich(_, _, _), 0.5666857870759636) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(5, make_sandwich(_, _, _), -0.0625870700336473) :- todo_served(Child), allergic_gluten(Child), !.
delta(5, make_sandwich(_, _, _), 0.03576634283275576) :- !.
delta(5, put_on_tray(_, _), -0.007767751557905788) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(5, put_on_tray(_, _), 0.2992760601910369) :- !.
delta(5, serve_sandwich_no_gluten(_, _, _, _), 0.127913511866942) :- !.
delta(5, serve_sandwich(_, Child, _, _), -0.06973471023307465) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(5, serve_sandwich(_, Child, _, _), 0.23637312486718126) :- todo_served(Child), !.
delta(5, serve_sandwich(_, _, _, _), -1.0902272023056492) :- !.
delta(5, move_tray(_, Place, Place2), 1.096016894735411) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(5, move_tray(_, Place, Place2), 0.03394873058920592) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(5, move_tray(_, Place, _), -0.12065541601205115) :- done_served(Child), waiting(Child, Place), !.
delta(5, move_tray(_, Place, Place2), 0.011150655609781785) :- at(Tray, Place), could_put_on_tray(Tray, Place2), todo_served(Child), waiting(Child, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(5, move_tray(_, Place, Place2), -0.14450330441018377) :- at(Tray, Place), could_put_on_tray(Tray, Place2), todo_served(Child), waiting(Child, Place), !.
delta(5, move_tray(_, Place, Place2), 0.21789597125670887) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(5, move_tray(_, Place, Place2), -0.06726329119346283) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(5, move_tray(_, _, _), -0.7730450146382961) :- fewer_ontray_1_than_todo_served, !.
delta(5, move_tray(_, _, Place), 0.13144154881109277) :- todo_served(Child), waiting(Child, Place), !.
delta(5, move_tray(_, _, _), -0.3105341911380363) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 204 examples, 30 leaves
delta(6, make_sandwich_no_gluten(_, _, _), 0.10814164729031389) :- !.
delta(6, make_sandwich(_, _, Content_portion), -0.15626747795981571) :- no_gluten_content(Content_portion), !.
delta(6, make_sandwich(_, _, _), -0.04654472684635573) :- at_kitchen_sandwich(_), !.
delta(6, make_sandwich(_, Bread_portion, _), -0.014704639655474208) :- fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(6, make_sandwich(_, _, _), 0.36322453943257493) :- fewer_ontray_1_than_todo_served, !.
delta(6, make_sandwich(_, _, _), -0.01684617043813235) :- !.
delta(6, put_on_tray(_, _), -0.0036098954546585444) :- fewer_ontray_1_than_todo_served, fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(6, put_on_tray(_, _), 0.21511829043180855) :- fewer_ontray_1_than_todo_served, !.
delta(6, put_on_tray(_, _), 0.023979567232988476) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(6, put_on_tray(_, _), -0.0405504060949302) :- !.
delta(6, serve_sandwich_no_gluten(_, _, _, _), 0.08896255555829971) :- !.
delta(6, serve_sandwich(_, _, _, _), 0.08188060109060287) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(6, serve_sandwich(_, _, _, _), -0.675862475776956) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(6, serve_sandwich(Sandwich, _, _, _), -0.04925297246094599) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(6, serve_sandwich(Sandwich, _, _, _), 0.25764991862862635) :- no_gluten_sandwich(Sandwich), !.
delta(6, serve_sandwich(_, _, _, _), 0.020577672440397574) :- goal_served(Child), done_served(Child), !.
delta(6, serve_sandwich(_, _, _, _), -0.24124011657839858) :- !.
delta(6, move_tray(Tray, Place, _), -0.08188060109060287) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), could_serve_sandwich(Tray, Place), !.
delta(6, move_tray(_, Place, kitchen), 0.02350484919531978) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(6, move_tray(_, Place, _), -0.02350484919531978) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(6, move_tray(_, Place, Place2), -0.061720146493985856) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(6, move_tray(_, Place, _), 0.6692727938257625) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_not_allergic_gluten, !.
delta(6, move_tray(_, Place, _), -0.03636117942155806) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(6, move_tray(_, Place, Place2), -0.07206581203239151) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(6, move_tray(_, Place, Place2), 0.19443863847411808) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(6, move_tray(_, Place, Place2), -0.01058297133277584) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(6, move_tray(_, _, _), -0.5733008577547708) :- fewer_ontray_1_than_todo_served, !.
delta(6, move_tray(_, _, Place), 0.1322568673095509) :- todo_served(Child), waiting(Child, Place), !.
delta(6, move_tray(_, _, _), -0.16513079703105688) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 222 examples, 30 leaves
delta(7, make_sandwich_no_gluten(_, _, _), 0.010948846660337288) :- at_kitchen_sandwich(_), fewer_at_1_than_todo_served, !.
delta(7, make_sandwich_no_gluten(_, _, _), -0.053212457463239854) :- at_kitchen_sandwich(_), !.
delta(7, make_sandwich_no_gluten(_, _, _), 0.06831645990463202) :- !.
delta(7, make_sandwich(_, _, _), -0.013624209930764021) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(7, make_sandwich(_, _, _), 0.30261952705828954) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(7, make_sandwich(_, _, _), -0.10533282173946802) :- !.
delta(7, put_on_tray(_, _), -0.013848784793348834) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(7, put_on_tray(_, _), 0.15536652096020515) :- fewer_ontray_1_than_todo_served, !.
delta(7, put_on_tray(_, _), 0.02426333349414483) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(7, put_on_tray(_, _), -0.04601266822964089) :- !.
delta(7, serve_sandwich_no_gluten(_, _, _, _), 7.443885201809499e-5) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(7, serve_sandwich_no_gluten(_, _, _, _), 0.08554006955272538) :- !.
delta(7, serve_sandwich(Sandwich, Child, Tray, _), 0.3179572820625032) :- ontray(Sandwich2, Tray), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(7, serve_sandwich(Sandwich, _, Tray, _), -0.06600560934446663) :- ontray(Sandwich2, Tray), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, !.
delta(7, serve_sandwich(Sandwich, _, Tray, _), -0.46042250668843215) :- ontray(Sandwich2, Tray), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(7, serve_sandwich(Sandwich, _, Tray, _), 0.01710403942191188) :- ontray(Sandwich2, Tray), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), !.
delta(7, serve_sandwich(_, _, Tray, _), 0.46864521312241614) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(7, serve_sandwich(_, _, _, _), -0.8337561844918542) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(7, serve_sandwich(_, _, _, _), 0.027217308709403792) :- !.
delta(7, move_tray(Tray, Place, Place2), -0.08763839975791658) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), could_put_on_tray(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(7, move_tray(Tray, _, Place), 0.09760778512738356) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), could_put_on_tray(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(7, move_tray(Tray, _, Place), -0.025335586212582913) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), could_put_on_tray(Tray, Place), !.
delta(7, move_tray(_, _, _), -0.445340979820183) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(7, move_tray(_, Place, _), -0.006806807461501401) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_sandwich(_), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(7, move_tray(_, _, _), 0.8866961325833691) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_sandwich(_), !.
delta(7, move_tray(_, _, _), -0.021586223453531842) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(7, move_tray(_, Place, Place2), 0.24336775588282636) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(7, move_tray(_, Place, Place2), 0.06422973338083014) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(7, move_tray(_, _, _), -0.2822867628263936) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 207 examples, 32 leaves
delta(8, make_sandwich_no_gluten(_, _, _), 0.007596336015477639) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(8, make_sandwich_no_gluten(_, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(8, make_sandwich_no_gluten(_, _, _), 0.0691367313023443) :- todo_served(Child), allergic_gluten(Child), !.
delta(8, make_sandwich_no_gluten(_, _, _), 0.0019334848713910397) :- no_gluten_sandwich(Sandwich), at_kitchen_sandwich(Sandwich), !.
delta(8, make_sandwich_no_gluten(_, _, _), -0.13205577085477851) :- no_gluten_sandwich(_), !.
delta(8, make_sandwich_no_gluten(_, _, _), 0.004119948910580616) :- !.
delta(8, make_sandwich(_, _, _), 0.21301264594212851) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(8, make_sandwich(_, _, _), -0.020346618793386097) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(8, make_sandwich(_, _, _), 0.004629386727610991) :- goal_served(Child), done_served(Child), !.
delta(8, make_sandwich(_, _, _), -0.10887446967151626) :- !.
delta(8, put_on_tray(_, _), 0.13024021641906613) :- fewer_ontray_1_than_todo_served, !.
delta(8, put_on_tray(_, _), 0.013548570742595759) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(8, put_on_tray(_, _), -0.07357649216859556) :- !.
delta(8, serve_sandwich_no_gluten(_, Child, _, _), 0.8829905467932953) :- todo_served(Child), !.
delta(8, serve_sandwich_no_gluten(_, _, _, _), -0.8744160048048214) :- !.
delta(8, serve_sandwich(Sandwich, Child, _, _), -0.057540401011694886) :- no_gluten_sandwich(Sandwich), todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(8, serve_sandwich(Sandwich, Child, _, _), 0.29972889836986405) :- no_gluten_sandwich(Sandwich), todo_served(Child), !.
delta(8, serve_sandwich(Sandwich, _, _, _), -0.07981217187917058) :- no_gluten_sandwich(Sandwich), !.
delta(8, serve_sandwich(_, _, _, _), -0.4618807730100197) :- at_kitchen_bread(_), !.
delta(8, serve_sandwich(_, _, Tray, _), -0.10426215872573079) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(8, serve_sandwich(_, _, _, Place), -0.014485190244974643) :- done_served(Child), waiting(Child, Place), !.
delta(8, serve_sandwich(_, _, _, _), 0.12151635278340757) :- !.
delta(8, move_tray(_, Place, _), 0.5193511891363126) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), not_allergic_gluten(Child), waiting(Child, Place), !.
delta(8, move_tray(_, _, _), -0.0122779229417675) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(8, move_tray(_, Place, Place2), 0.1257086870775943) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(8, move_tray(_, Place, Place2), 0.023449283341748076) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(8, move_tray(_, Place, _), -0.09384585865234533) :- done_served(Child), waiting(Child, Place), !.
delta(8, move_tray(_, _, _), 0.010181389568767678) :- todo_served(Child), not_allergic_gluten(Child), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(8, move_tray(_, _, _), -0.4149194668059318) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(8, move_tray(Tray, _, Place), 0.07657479295404337) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(8, move_tray(_, _, _), -0.07558298190549667) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 203 examples, 32 leaves
delta(9, make_sandwich_no_gluten(_, _, _), 0.015573357003468851) :- at_kitchen_sandwich(_), fewer_at_1_than_todo_served, !.
delta(9, make_sandwich_no_gluten(_, _, _), -0.03775855258428645) :- at_kitchen_sandwich(_), !.
delta(9, make_sandwich_no_gluten(_, _, _), 0.06026836520397822) :- !.
delta(9, make_sandwich(_, _, _), -0.09584322964543221) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(9, make_sandwich(_, _, _), -0.0010481934025692522) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(9, make_sandwich(_, _, _), 0.21268551693584328) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(9, make_sandwich(_, _, _), -0.010643373473968792) :- !.
delta(9, put_on_tray(_, _), 0.02183768614139193) :- at_kitchen_bread(_), fewer_at_1_than_todo_served, !.
delta(9, put_on_tray(_, _), -0.05743827907140468) :- at_kitchen_bread(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(9, put_on_tray(_, _), 0.007556217258712436) :- at_kitchen_bread(_), !.
delta(9, put_on_tray(_, _), 0.10335831110417847) :- fewer_ontray_1_than_todo_served, !.
delta(9, put_on_tray(_, _), 0.021829543205091263) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(9, put_on_tray(_, _), -0.0428008426577235) :- !.
delta(9, serve_sandwich_no_gluten(_, Child, _, _), 0.3556226060768081) :- todo_served(Child), !.
delta(9, serve_sandwich_no_gluten(_, _, _, _), -0.3432614056263173) :- !.
delta(9, serve_sandwich(Sandwich, Child, _, Place), -0.014245206952005157) :- no_gluten_sandwich(_), todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(9, serve_sandwich(_, Child, _, _), 0.17474727331187695) :- no_gluten_sandwich(_), todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(9, serve_sandwich(_, Child, _, _), 0.037233069071123205) :- no_gluten_sandwich(_), todo_served(Child), !.
delta(9, serve_sandwich(_, _, _, _), -0.10198793058410162) :- no_gluten_sandwich(_), !.
delta(9, serve_sandwich(_, _, _, _), -0.5828920872896746) :- !.
delta(9, move_tray(Tray, _, _), -0.35244064426572264) :- no_gluten_sandwich(_), fewer_ontray_2_than_todo_served, ontray(_, Tray), !.
delta(9, move_tray(_, _, Place), -0.04533738995200594) :- no_gluten_sandwich(_), fewer_ontray_2_than_todo_served, goal_served(Child), waiting(Child, Place), !.
delta(9, move_tray(_, _, _), 0.06384681391723052) :- no_gluten_sandwich(_), fewer_ontray_2_than_todo_served, !.
delta(9, move_tray(_, _, Place), -0.007248786790913749) :- no_gluten_sandwich(Sandwich), todo_served(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), !.
delta(9, move_tray(_, _, Place), 0.2521451566143939) :- no_gluten_sandwich(_), todo_served(Child), waiting(Child, Place), !.
delta(9, move_tray(_, _, _), -0.2267748473825192) :- no_gluten_sandwich(_), !.
delta(9, move_tray(_, _, Place), -0.016505189389498864) :- done_served(Child), waiting(Child, Place), !.
delta(9, move_tray(_, _, _), -0.047174245595401086) :- at_kitchen_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(9, move_tray(_, _, _), 0.04961110288604919) :- at_kitchen_sandwich(_), !.
delta(9, move_tray(Tray, _, _), 0.618834847057061) :- ontray(_, Tray), !.
delta(9, move_tray(_, _, _), -0.012534565264980013) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 203 examples, 32 leaves
delta(10, make_sandwich_no_gluten(_, _, _), 0.073405266922415) :- !.
delta(10, make_sandwich(_, _, _), -0.008536799143651623) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(10, make_sandwich(_, _, _), 0.15249450912988208) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(10, make_sandwich(_, _, _), -0.0748657032588062) :- !.
delta(10, put_on_tray(_, Tray), 0.054282148757103986) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(10, put_on_tray(_, Tray), 0.019241824348578546) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(10, put_on_tray(_, Tray), -0.3084075681077211) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(10, put_on_tray(Sandwich, _), 0.34673431936182375) :- no_gluten_sandwich(Sandwich), !.
delta(10, put_on_tray(_, _), 0.01483611256517113) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(10, put_on_tray(_, _), -0.025177757611586048) :- !.
delta(10, serve_sandwich_no_gluten(_, Child, _, _), 0.014178830131168368) :- todo_served(Child), fewer_ontray_2_than_todo_served, todo_served(Child2), not_allergic_gluten(Child2), !.
delta(10, serve_sandwich_no_gluten(_, Child, _, _), 0.00012458628386654362) :- todo_served(Child), fewer_ontray_2_than_todo_served, fewer_at_1_than_todo_served, !.
delta(10, serve_sandwich_no_gluten(_, Child, _, _), 0.0) :- todo_served(Child), fewer_ontray_2_than_todo_served, !.
delta(10, serve_sandwich_no_gluten(_, Child, _, _), 0.30367573836938555) :- todo_served(Child), !.
delta(10, serve_sandwich_no_gluten(_, _, _, _), -0.2800388262385325) :- !.
delta(10, serve_sandwich(Sandwich, Child, _, _), 0.04928669660768912) :- no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(10, serve_sandwich(Sandwich, _, _, _), -0.025794787949036408) :- no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, !.
delta(10, serve_sandwich(Sandwich, _, _, _), -0.2823504418121606) :- no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(10, serve_sandwich(Sandwich, _, _, _), 0.001888389773869002) :- no_gluten_sandwich(Sandwich), !.
delta(10, serve_sandwich(_, _, _, _), -0.22050762409826133) :- fewer_ontray_1_than_todo_served, !.
delta(10, serve_sandwich(_, _, _, _), 0.3180999520776358) :- !.
delta(10, move_tray(Tray, Place, Place2), -0.015047774164488405) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_put_on_tray(Tray2, Place2), fewer_at_1_than_todo_served, could_serve_sandwich(Tray, Place), !.
delta(10, move_tray(_, _, Place), 0.09344791608962805) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), could_put_on_tray(Tray, Place), fewer_at_1_than_todo_served, !.
delta(10, move_tray(_, _, Place), -0.037289422114658514) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), could_put_on_tray(Tray, Place), !.
delta(10, move_tray(_, _, _), -0.0003788049874021505) :- no_gluten_sandwich(_), fewer_ontray_2_than_todo_served, done_served(Child), not_allergic_gluten(Child), !.
delta(10, move_tray(_, _, _), -0.3171913587973677) :- no_gluten_sandwich(_), fewer_ontray_2_than_todo_served, !.
delta(10, move_tray(_, _, Place), 0.09149096583664429) :- no_gluten_sandwich(_), todo_served(Child), waiting(Child, Place), !.
delta(10, move_tray(_, _, _), -0.10879232223032367) :- no_gluten_sandwich(_), !.
delta(10, move_tray(_, Place, Place2), 0.29217616435171695) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), todo_served(Child), waiting(Child, Place), !.
delta(10, move_tray(_, Place, Place2), -0.0013438356570776916) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(10, move_tray(_, _, _), -0.09668576690656976) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 205 examples, 37 leaves
delta(11, make_sandwich_no_gluten(_, _, _), 0.07727325162569501) :- !.
delta(11, make_sandwich(_, _, _), -0.011949537309244454) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(11, make_sandwich(_, _, _), 0.06340180971690658) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(11, make_sandwich(_, _, _), -0.07456144673279114) :- !.
delta(11, put_on_tray(_, Tray), 0.0412962653001965) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(11, put_on_tray(_, Tray), 0.009156709939672032) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(11, put_on_tray(_, Tray), 7.420534559828881e-5) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_allergic_gluten, !.
delta(11, put_on_tray(_, Tray), -0.20641648084469946) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(11, put_on_tray(Sandwich, _), 0.00122746334497363) :- no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(11, put_on_tray(Sandwich, _), 0.21254714064757843) :- no_gluten_sandwich(Sandwich), !.
delta(11, put_on_tray(_, _), 0.002422328065775639) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(11, put_on_tray(_, _), -0.017961666924164007) :- !.
delta(11, serve_sandwich_no_gluten(_, Child, _, _), 0.12497768854638183) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(11, serve_sandwich_no_gluten(_, Child, _, _), 3.6886553965346006e-5) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), !.
delta(11, serve_sandwich_no_gluten(_, _, _, _), -0.20236300376304012) :- fewer_ontray_2_than_allergic_gluten, !.
delta(11, serve_sandwich_no_gluten(_, _, _, _), 0.011698306999809734) :- fewer_ontray_2_than_todo_served, !.
delta(11, serve_sandwich_no_gluten(_, _, _, _), 0.005177136177744173) :- at_kitchen_sandwich(_), !.
delta(11, serve_sandwich_no_gluten(_, _, _, _), 0.003335095575259357) :- goal_served(Child), done_served(Child), !.
delta(11, serve_sandwich_no_gluten(_, _, _, _), -1.026595491758105) :- !.
delta(11, serve_sandwich(_, _, _, _), 0.0850531411469482) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(11, serve_sandwich(_, _, _, _), -0.2972034497487267) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(11, serve_sandwich(Sandwich, _, _, Place), -0.015618912620005436) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(11, serve_sandwich(_, _, _, _), 0.028784053335286403) :- !.
delta(11, move_tray(_, _, Place), -0.2644319295598329) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(11, move_tray(Tray, _, Place), -0.0008131893007193651) :- not_allergic_gluten(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), fewer_at_1_than_todo_served, !.
delta(11, move_tray(Tray, _, Place), 0.3136072186788928) :- not_allergic_gluten(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), !.
delta(11, move_tray(_, _, Place), -0.15935766265822582) :- not_allergic_gluten(Child), waiting(Child, Place), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(11, move_tray(_, _, Place), 0.00027571478808836777) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(11, move_tray(Tray, _, Place), 0.10467846348003584) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, could_serve_sandwich_no_gluten(Tray, Place), goal_served(Child), done_served(Child), !.
delta(11, move_tray(Tray, _, Place), -0.011330621469458076) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, could_serve_sandwich_no_gluten(Tray, Place), !.
delta(11, move_tray(_, Place, Place2), 0.04750468481608236) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(11, move_tray(_, _, _), -0.10050361554512224) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(11, move_tray(_, _, _), 0.024343431123849114) :- goal_served(Child), done_served(Child), at_kitchen_sandwich(_), !.
delta(11, move_tray(_, _, _), -0.040331525015226445) :- goal_served(Child), done_served(Child), !.
delta(11, move_tray(_, _, _), -2.1524421409951793e-18) :- fewer_at_2_than_allergic_gluten, !.
delta(11, move_tray(_, _, _), 1.054704037196537) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 203 examples, 36 leaves
delta(12, make_sandwich_no_gluten(_, _, _), 0.010410942477746269) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served, !.
delta(12, make_sandwich_no_gluten(_, _, _), -0.06942323657714154) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(12, make_sandwich_no_gluten(_, _, _), 0.048262763133105506) :- !.
delta(12, make_sandwich(_, _, _), -0.0461907102270177) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(12, make_sandwich(_, Bread_portion, _), -0.005943469153455426) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(12, make_sandwich(_, _, _), 0.006357482907287334) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(12, make_sandwich(_, _, _), -0.0013543992195070148) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(12, make_sandwich(_, _, _), -8.463005446478195e-5) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(12, make_sandwich(_, _, _), 0.07228512439719091) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(12, make_sandwich(_, _, _), -0.0033653867868677655) :- !.
delta(12, put_on_tray(_, Tray), 0.011002861177889229) :- fewer_ontray_1_than_todo_served, fewer_at_2_than_todo_served_not_allergic_gluten, ontray(_, Tray), !.
delta(12, put_on_tray(_, _), -0.02697442119514456) :- fewer_ontray_1_than_todo_served, fewer_at_2_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(12, put_on_tray(_, _), 0.01634624437481956) :- fewer_ontray_1_than_todo_served, fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(12, put_on_tray(_, _), 0.00018629733349471967) :- fewer_ontray_1_than_todo_served, no_gluten_sandwich(_), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(12, put_on_tray(_, _), 0.15121544289148606) :- fewer_ontray_1_than_todo_served, no_gluten_sandwich(_), !.
delta(12, put_on_tray(_, _), -0.0010963755579174173) :- fewer_ontray_1_than_todo_served, !.
delta(12, put_on_tray(_, _), 0.008001541055754563) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(12, put_on_tray(_, _), -0.04244783489567322) :- !.
delta(12, serve_sandwich_no_gluten(_, _, _, _), 0.0011484277336584463) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served, !.
delta(12, serve_sandwich_no_gluten(_, _, _, _), -0.047643636245598205) :- fewer_ontray_1_than_todo_served, !.
delta(12, serve_sandwich_no_gluten(_, _, _, _), 0.0011035257387921869) :- fewer_ontray_2_than_allergic_gluten, !.
delta(12, serve_sandwich_no_gluten(_, _, _, _), 0.03474482415620137) :- !.
delta(12, serve_sandwich(_, Child, _, _), -0.003666765585702659) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(12, serve_sandwich(_, Child, _, _), 0.22227014929834182) :- todo_served(Child), !.
delta(12, serve_sandwich(_, _, _, _), -0.04940219263584165) :- !.
delta(12, move_tray(Tray, _, Place), 0.017145987651466955) :- could_serve_sandwich(Tray, Place), fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_2_than_allergic_gluten, !.
delta(12, move_tray(Tray, _, Place), -0.10097224904996285) :- could_serve_sandwich(Tray, Place), fewer_no_gluten_sandwich_than_todo_served, no_gluten_sandwich(_), !.
delta(12, move_tray(Tray, _, Place), 0.007273349445535631) :- could_serve_sandwich(Tray, Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(12, move_tray(Tray, Place, Place2), -0.00386891049924875) :- could_serve_sandwich(Tray, Place2), todo_served(Child), waiting(Child, Place), !.
delta(12, move_tray(Tray, _, Place), 0.4069411147037659) :- could_serve_sandwich(Tray, Place), !.
delta(12, move_tray(_, _, _), -0.4915708569923924) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(12, move_tray(_, Place, Place2), 0.04233595571597051) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(12, move_tray(_, Place, Place2), -0.015219906451872725) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(12, move_tray(_, _, Place), 0.0023235097548006886) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(12, move_tray(_, _, _), -0.06767178828589761) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 202 examples, 25 leaves
delta(13, make_sandwich_no_gluten(_, _, _), 0.04866711598248448) :- !.
delta(13, make_sandwich(_, _, _), -0.031288785677868095) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(13, make_sandwich(_, _, _), 0.0) :- fewer_no_gluten_sandwich_than_todo_served, fewer_at_1_than_not_allergic_gluten, !.
delta(13, make_sandwich(_, _, _), 0.12547120586364785) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(13, make_sandwich(_, _, _), 0.0012015951587308602) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(13, make_sandwich(_, _, _), -0.03869403898335666) :- !.
delta(13, put_on_tray(_, Tray), 0.029678834142521423) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(_), ontray(_, Tray), !.
delta(13, put_on_tray(_, _), -0.06575549140184293) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(_), fewer_at_2_than_todo_served, !.
delta(13, put_on_tray(_, _), 0.0041976880105719355) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(_), !.
delta(13, put_on_tray(_, _), 0.07704047351781704) :- fewer_ontray_1_than_todo_served, !.
delta(13, put_on_tray(_, _), 0.005608452584857551) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(13, put_on_tray(_, _), -0.055804592252582774) :- !.
delta(13, serve_sandwich_no_gluten(_, Child, _, _), 0.00032627387567157423) :- todo_served(Child), fewer_ontray_2_than_todo_served, at_kitchen_bread(_), fewer_at_2_than_todo_served, !.
delta(13, serve_sandwich_no_gluten(_, Child, _, _), -0.03105345650241273) :- todo_served(Child), fewer_ontray_2_than_todo_served, at_kitchen_bread(_), !.
delta(13, serve_sandwich_no_gluten(_, Child, _, _), 0.001822007005281391) :- todo_served(Child), fewer_ontray_2_than_todo_served, !.
delta(13, serve_sandwich_no_gluten(_, Child, _, _), 0.1021701153006116) :- todo_served(Child), !.
delta(13, serve_sandwich_no_gluten(_, _, _, _), -0.0880322348324584) :- !.
delta(13, serve_sandwich(_, Child, _, _), 0.15988815192913902) :- todo_served(Child), !.
delta(13, serve_sandwich(_, _, _, _), -0.020105139152054047) :- !.
delta(13, move_tray(Tray, _, _), -0.05438784935579336) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(13, move_tray(Tray, _, Place), -0.01649360768256003) :- at(Tray, kitchen), at(Tray2, Place), could_serve_sandwich(Tray2, Place), !.
delta(13, move_tray(Tray, _, _), 0.20032198580451532) :- at(Tray, kitchen), ontray(_, Tray), !.
delta(13, move_tray(Tray, _, _), -0.015439242469234633) :- at(Tray, kitchen), !.
delta(13, move_tray(_, _, _), -0.2941347781434702) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 204 examples, 38 leaves
delta(14, make_sandwich_no_gluten(_, _, _), 0.00887394789361305) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(14, make_sandwich_no_gluten(_, _, _), -0.07675913343643882) :- fewer_at_1_than_allergic_gluten, !.
delta(14, make_sandwich_no_gluten(_, _, _), 0.043250790611553014) :- !.
delta(14, make_sandwich(_, _, _), -0.00013642716761173593) :- todo_served(Child), not_allergic_gluten(Child), fewer_at_1_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(14, make_sandwich(_, _, _), 0.0011432252324490137) :- todo_served(Child), not_allergic_gluten(Child), fewer_at_1_than_not_allergic_gluten, !.
delta(14, make_sandwich(_, _, Content_portion), -0.0045046502085673845) :- todo_served(Child), not_allergic_gluten(Child), no_gluten_content(Content_portion), !.
delta(14, make_sandwich(_, _, _), 0.14212878485335306) :- todo_served(Child), not_allergic_gluten(Child), fewer_at_1_than_todo_served, !.
delta(14, make_sandwich(_, _, _), 0.001005463069717267) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(14, make_sandwich(_, _, _), -0.044749080245768354) :- !.
delta(14, put_on_tray(_, Tray), 0.09636505864745999) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(14, put_on_tray(_, Tray), 0.0006781438055146054) :- fewer_at_2_than_todo_served, ontray(_, Tray), !.
delta(14, put_on_tray(_, _), -0.053785191867292616) :- fewer_at_2_than_todo_served, fewer_no_gluten_sandwich_than_todo_served, !.
delta(14, put_on_tray(_, _), 0.0001980934080537592) :- fewer_at_2_than_todo_served, !.
delta(14, put_on_tray(_, _), 0.03461236726200935) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(14, put_on_tray(_, _), 0.003805705746405186) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(14, put_on_tray(_, _), -0.01564753730345643) :- !.
delta(14, serve_sandwich_no_gluten(_, Child, _, _), 0.15128732797993516) :- todo_served(Child), !.
delta(14, serve_sandwich_no_gluten(_, _, _, _), -0.10455556699503672) :- !.
delta(14, serve_sandwich(_, _, Tray, _), 0.01641126472181315) :- fewer_ontray_2_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(14, serve_sandwich(_, _, _, _), -0.3020746608292661) :- fewer_ontray_2_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(14, serve_sandwich(_, _, _, _), -0.021556118061552113) :- fewer_ontray_2_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(14, serve_sandwich(_, _, _, _), 0.011814297712790892) :- fewer_ontray_2_than_todo_served, !.
delta(14, serve_sandwich(_, Child, _, _), -0.007321068683681505) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(14, serve_sandwich(_, Child, _, _), 0.09388604063525423) :- todo_served(Child), !.
delta(14, serve_sandwich(_, _, _, _), -0.022146283201838673) :- !.
delta(14, move_tray(Tray, _, _), -0.020968704702792766) :- fewer_at_1_than_todo_served_not_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(14, move_tray(_, Place, _), 0.4638360102146194) :- fewer_at_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, goal_served(Child), waiting(Child, Place), !.
delta(14, move_tray(_, _, _), -0.0026049706251725256) :- fewer_at_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(14, move_tray(_, Place, _), -0.011270872241797573) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), waiting(Child, Place), !.
delta(14, move_tray(_, _, _), 0.0) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(14, move_tray(_, Place, Place2), -0.054172390503868004) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(14, move_tray(_, Place, Place2), 0.12831069623303085) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(14, move_tray(_, Place, Place2), -0.0052239432752869555) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(14, move_tray(Tray, _, Place), 0.05225134560983284) :- done_served(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), !.
delta(14, move_tray(_, _, Place), -0.04468267372349332) :- done_served(Child), waiting(Child, Place), !.
delta(14, move_tray(_, _, _), -0.001340667012047601) :- fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(14, move_tray(_, _, _), -0.24588977829326436) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 202 examples, 37 leaves
delta(15, make_sandwich_no_gluten(_, _, _), -0.08584397861406058) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(15, make_sandwich_no_gluten(_, _, _), 0.010781914294105327) :- fewer_at_1_than_allergic_gluten, !.
delta(15, make_sandwich_no_gluten(_, _, _), 0.030989485448686273) :- !.
delta(15, make_sandwich(_, _, Content_portion), -0.0027249786617508185) :- todo_served(Child), not_allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), no_gluten_content(Content_portion), !.
delta(15, make_sandwich(_, _, _), 0.14465865468169045) :- todo_served(Child), not_allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(15, make_sandwich(_, _, _), 0.0011613454053081035) :- todo_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(15, make_sandwich(_, _, _), 0.0) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(15, make_sandwich(_, _, _), -0.022722325516780852) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(15, make_sandwich(_, _, _), -0.03237869674146149) :- !.
delta(15, put_on_tray(_, Tray), 0.03561322932001763) :- ontray(_, Tray), fewer_ontray_1_than_todo_served, !.
delta(15, put_on_tray(_, Tray), -0.013063039328951621) :- ontray(_, Tray), !.
delta(15, put_on_tray(_, _), -0.0015339657054081375) :- fewer_ontray_1_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(15, put_on_tray(_, _), 0.01082611420674615) :- fewer_ontray_1_than_allergic_gluten, !.
delta(15, put_on_tray(_, _), 0.00018754078845074746) :- todo_served(Child), not_allergic_gluten(Child), fewer_at_1_than_not_allergic_gluten, !.
delta(15, put_on_tray(_, _), -0.030436606296414266) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(15, put_on_tray(_, _), 0.00019666247776901417) :- !.
delta(15, serve_sandwich_no_gluten(_, Child, _, _), 0.0013892380261818732) :- todo_served(Child), fewer_ontray_2_than_todo_served, at_kitchen_bread(_), fewer_at_2_than_todo_served, !.
delta(15, serve_sandwich_no_gluten(_, Child, _, _), -0.029254466848780192) :- todo_served(Child), fewer_ontray_2_than_todo_served, at_kitchen_bread(_), !.
delta(15, serve_sandwich_no_gluten(_, Child, _, _), 0.006802681998989078) :- todo_served(Child), fewer_ontray_2_than_todo_served, todo_served(Child2), not_allergic_gluten(Child2), !.
delta(15, serve_sandwich_no_gluten(_, Child, _, _), 7.527156637737853e-5) :- todo_served(Child), fewer_ontray_2_than_todo_served, !.
delta(15, serve_sandwich_no_gluten(_, Child, _, _), 0.1360172871779168) :- todo_served(Child), !.
delta(15, serve_sandwich_no_gluten(_, _, _, _), -0.08103630834716744) :- !.
delta(15, serve_sandwich(_, Child, _, _), 0.05740153277460479) :- todo_served(Child), fewer_at_1_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(15, serve_sandwich(_, Child, Tray, _), -0.0033882474014404465) :- todo_served(Child), fewer_at_1_than_todo_served, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(15, serve_sandwich(_, Child, _, _), 0.000597042982897821) :- todo_served(Child), fewer_at_1_than_todo_served, !.
delta(15, serve_sandwich(_, Child, _, _), 0.28876435092001235) :- todo_served(Child), !.
delta(15, serve_sandwich(_, _, _, _), -0.28822002990654694) :- !.
delta(15, move_tray(_, Place, Place2), 0.0843154233560556) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(15, move_tray(_, Place, Place2), 0.0025976761435600017) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(15, move_tray(_, Place, _), -0.03949450025003065) :- done_served(Child), waiting(Child, Place), !.
delta(15, move_tray(Tray, _, Place), 0.05989489925903117) :- done_served(Child), allergic_gluten(Child), could_serve_sandwich(Tray, Place), !.
delta(15, move_tray(_, Place, Place2), 0.001327625116761449) :- done_served(Child), allergic_gluten(Child), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(15, move_tray(_, _, _), -0.028193102421532053) :- done_served(Child), allergic_gluten(Child), !.
delta(15, move_tray(_, Place, Place2), -0.04699458488712585) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(15, move_tray(_, Place, Place2), 0.04919344075599371) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(15, move_tray(_, _, _), -0.21544222633330767) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 208 examples, 36 leaves
delta(16, make_sandwich_no_gluten(_, _, _), -0.11181132568596268) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(16, make_sandwich_no_gluten(_, _, _), 0.0077942349558267) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(16, make_sandwich_no_gluten(_, _, _), 0.019894022815673144) :- !.
delta(16, make_sandwich(_, Bread_portion, _), -0.020764036927139337) :- at_kitchen_bread(Bread_portion2), no_gluten_bread(Bread_portion2), no_gluten_bread(Bread_portion), !.
delta(16, make_sandwich(_, _, _), 0.13802881699396707) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), fewer_at_1_than_todo_served, !.
delta(16, make_sandwich(_, _, _), -0.0038693157924129537) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(16, make_sandwich(_, _, _), -0.02497810133885866) :- at_kitchen_sandwich(_), !.
delta(16, make_sandwich(_, _, _), 0.006948817096763608) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(16, make_sandwich(_, _, _), -0.0024558277698634163) :- !.
delta(16, put_on_tray(_, Tray), 0.0015443603930757283) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), ontray(_, Tray), !.
delta(16, put_on_tray(_, _), -0.024189562693145768) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(16, put_on_tray(_, _), 0.05034009293398875) :- fewer_ontray_1_than_todo_served, !.
delta(16, put_on_tray(_, _), 0.003547352526391905) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(16, put_on_tray(_, _), -0.01393423906214055) :- !.
delta(16, serve_sandwich_no_gluten(_, Child, _, _), 0.004866089085431489) :- todo_served(Child), fewer_ontray_2_than_todo_served, todo_served(Child2), not_allergic_gluten(Child2), !.
delta(16, serve_sandwich_no_gluten(_, Child, _, _), 6.166153510990604e-5) :- todo_served(Child), fewer_ontray_2_than_todo_served, !.
delta(16, serve_sandwich_no_gluten(_, Child, _, _), 0.08579195623688882) :- todo_served(Child), !.
delta(16, serve_sandwich_no_gluten(_, _, _, _), -0.044077351464619975) :- !.
delta(16, serve_sandwich(Sandwich, Child, _, _), -0.007116915334344745) :- todo_served(Child), no_gluten_sandwich(Sandwich), todo_served(Child2), allergic_gluten(Child2), !.
delta(16, serve_sandwich(Sandwich, Child, _, _), 0.49920075384347595) :- todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(16, serve_sandwich(_, Child, Tray, _), -0.49345966984490547) :- todo_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(16, serve_sandwich(_, Child, _, Place), 0.3941170728173472) :- todo_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(16, serve_sandwich(_, Child, _, _), 0.02550285773105203) :- todo_served(Child), !.
delta(16, serve_sandwich(_, _, _, _), -0.4419588329634204) :- !.
delta(16, move_tray(Tray, _, Place), -0.01295232406735162) :- could_serve_sandwich(Tray, Place), fewer_ontray_2_than_todo_served, at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(16, move_tray(Tray, _, Place), 0.018500491783299895) :- could_serve_sandwich(Tray, Place), fewer_ontray_2_than_todo_served, at(Tray, kitchen), !.
delta(16, move_tray(Tray, _, Place), -0.06395686102331041) :- could_serve_sandwich(Tray, Place), fewer_ontray_2_than_todo_served, !.
delta(16, move_tray(Tray, _, Place), 0.0) :- could_serve_sandwich(Tray, Place), fewer_at_2_than_todo_served, !.
delta(16, move_tray(Tray, _, Place), 0.10975716239623234) :- could_serve_sandwich(Tray, Place), !.
delta(16, move_tray(_, Place, Place2), -0.02638710778524633) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(16, move_tray(_, Place, Place2), 0.05213428679627756) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(16, move_tray(_, Place, Place2), -0.0012554809608892527) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(16, move_tray(Tray, Place, Place2), 0.002515177415651269) :- at(Tray2, Place2), could_put_on_tray(Tray2, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(16, move_tray(_, Place, Place2), -0.0004685844218142949) :- at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(16, move_tray(_, _, _), -0.18771355991929967) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 210 examples, 41 leaves
delta(17, make_sandwich_no_gluten(_, _, _), 0.0033670386815164584) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served, !.
delta(17, make_sandwich_no_gluten(_, _, _), -0.04187319106098979) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(17, make_sandwich_no_gluten(_, _, _), 0.03080968209173966) :- !.
delta(17, make_sandwich(_, Bread_portion, _), -0.03247146564904452) :- at_kitchen_bread(Bread_portion2), no_gluten_bread(Bread_portion2), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(17, make_sandwich(_, _, Content_portion), -0.00400395531221437) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_content(Content_portion), !.
delta(17, make_sandwich(_, _, _), 0.00677558257258712) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(17, make_sandwich(_, _, _), -0.0015817254875542157) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at_kitchen_sandwich(_), !.
delta(17, make_sandwich(_, _, _), 0.04477463977118252) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), todo_served(Child), allergic_gluten(Child), !.
delta(17, make_sandwich(_, _, _), -0.00011300321502207228) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(17, make_sandwich(_, _, _), -0.13000550845560904) :- fewer_at_1_than_todo_served, !.
delta(17, make_sandwich(_, _, _), 0.03334919363757852) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(17, make_sandwich(_, _, _), -0.01191032978030269) :- !.
delta(17, put_on_tray(_, _), 0.13460258890420995) :- fewer_ontray_1_than_todo_served, !.
delta(17, put_on_tray(_, _), 0.0018651022590554145) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(17, put_on_tray(_, _), -0.004886174618597572) :- !.
delta(17, serve_sandwich_no_gluten(_, Child, _, _), 0.09815000960981951) :- todo_served(Child), !.
delta(17, serve_sandwich_no_gluten(_, _, _, _), -0.15702327150780618) :- !.
delta(17, serve_sandwich(Sandwich, _, _, _), 0.2298494406508423) :- no_gluten_sandwich(Sandwich), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(17, serve_sandwich(Sandwich, _, _, _), -0.008668237510038127) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(17, serve_sandwich(Sandwich, Child, _, _), 0.004092190448333877) :- no_gluten_sandwich(Sandwich), todo_served(Child), !.
delta(17, serve_sandwich(Sandwich, _, _, _), -0.003893467254088134) :- no_gluten_sandwich(Sandwich), !.
delta(17, serve_sandwich(_, _, _, _), 0.006016080637113186) :- no_gluten_bread(_), goal_served(Child), allergic_gluten(Child), !.
delta(17, serve_sandwich(_, _, _, _), -0.231443954218004) :- no_gluten_bread(_), !.
delta(17, serve_sandwich(_, Child, _, Place), 0.10531099032141147) :- todo_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(17, serve_sandwich(_, Child, _, _), 0.0006492603878252099) :- todo_served(Child), !.
delta(17, serve_sandwich(_, _, _, _), -0.028771989433498006) :- !.
delta(17, move_tray(Tray, _, Place), -0.02822733984130782) :- not_allergic_gluten(Child), waiting(Child, Place), at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(17, move_tray(Tray, _, Place), 0.024238291784394867) :- not_allergic_gluten(Child), waiting(Child, Place), at(Tray, kitchen), could_serve_sandwich(Tray, Place), !.
delta(17, move_tray(Tray, _, Place), -0.008775564735473819) :- not_allergic_gluten(Child), waiting(Child, Place), at(Tray, kitchen), !.
delta(17, move_tray(Tray, Place, Place2), -0.05500859101634133) :- not_allergic_gluten(Child), waiting(Child, Place2), goal_served(Child2), done_served(Child2), could_serve_sandwich(Tray, Place), !.
delta(17, move_tray(_, _, Place), 0.014974451070667832) :- not_allergic_gluten(Child), waiting(Child, Place), goal_served(Child2), done_served(Child2), !.
delta(17, move_tray(_, _, Place), 0.0009051211347149883) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(17, move_tray(_, _, Place), -0.8006263197737258) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(17, move_tray(_, Place, Place2), 0.0076871913877903375) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(17, move_tray(_, Place, _), -0.0018771664976932113) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(17, move_tray(_, Place, _), -0.09255166433838877) :- todo_served(Child), waiting(Child, Place), !.
delta(17, move_tray(Tray, _, Place), -0.01997211754777016) :- ontray(_, Tray), at(Tray2, Place), could_serve_sandwich_no_gluten(Tray2, Place), !.
delta(17, move_tray(Tray, _, _), 0.8157868988397415) :- ontray(_, Tray), !.
delta(17, move_tray(_, _, _), 0.004464614048959706) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(17, move_tray(_, _, _), -0.038628053308610875) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 207 examples, 28 leaves
delta(18, make_sandwich_no_gluten(_, _, _), 0.020652755416117993) :- !.
delta(18, make_sandwich(_, _, _), -0.004729523441394701) :- no_gluten_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(18, make_sandwich(_, _, _), 0.042751002822903526) :- no_gluten_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(18, make_sandwich(_, _, _), -0.010864050469814247) :- no_gluten_sandwich(_), !.
delta(18, make_sandwich(_, _, _), -0.020673246522218473) :- !.
delta(18, put_on_tray(_, _), 0.07565202651858935) :- fewer_ontray_1_than_todo_served, !.
delta(18, put_on_tray(_, _), 0.00499381644166238) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(18, put_on_tray(_, _), -0.06282403374930459) :- !.
delta(18, serve_sandwich_no_gluten(_, _, _, _), 0.00017602139672091556) :- at_kitchen_bread(Bread_portion), todo_served(Child), not_allergic_gluten(Child), no_gluten_bread(Bread_portion), !.
delta(18, serve_sandwich_no_gluten(_, _, _, _), -0.05285265359721378) :- at_kitchen_bread(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(18, serve_sandwich_no_gluten(_, _, _, _), 0.0002462898235572091) :- at_kitchen_bread(_), !.
delta(18, serve_sandwich_no_gluten(_, _, _, _), 1.584939111648115e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(18, serve_sandwich_no_gluten(_, _, _, _), 0.05394551073108513) :- !.
delta(18, serve_sandwich(_, Child, _, _), -0.11486975829622006) :- todo_served(Child), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(18, serve_sandwich(_, Child, _, Place), 0.1669573259426836) :- todo_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(18, serve_sandwich(_, Child, _, _), 0.10681140443673783) :- todo_served(Child), no_gluten_bread(_), !.
delta(18, serve_sandwich(_, Child, _, _), -0.016656014442935435) :- todo_served(Child), !.
delta(18, serve_sandwich(_, _, _, _), -0.12108969243168737) :- !.
delta(18, move_tray(Tray, Place, Place2), -0.1313992747356968) :- could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(18, move_tray(Tray, Place, Place2), 0.034790903580639056) :- could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(18, move_tray(Tray, Place, Place2), -0.0012026808945719383) :- could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place), !.
delta(18, move_tray(Tray, _, Place), 0.13424450072688804) :- could_serve_sandwich(Tray, Place), !.
delta(18, move_tray(_, Place, kitchen), -0.010148288932762047) :- done_served(Child), waiting(Child, Place), fewer_at_1_than_todo_served, !.
delta(18, move_tray(_, Place, kitchen), 0.04691746743545547) :- done_served(Child), waiting(Child, Place), !.
delta(18, move_tray(Tray, Place, _), 0.0005651645590762648) :- done_served(Child), waiting(Child, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(18, move_tray(_, Place, _), -0.0219461418059252) :- done_served(Child), waiting(Child, Place), !.
delta(18, move_tray(_, _, _), -0.24705332062461483) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 207 examples, 29 leaves
delta(19, make_sandwich_no_gluten(_, _, _), 0.026482267428249544) :- !.
delta(19, make_sandwich(_, _, _), -0.04677643010369981) :- no_gluten_bread(_), !.
delta(19, make_sandwich(_, _, _), 0.024872865827747722) :- at_kitchen_sandwich(_), !.
delta(19, make_sandwich(_, _, _), 3.204747397124161e-18) :- fewer_at_1_than_todo_served, !.
delta(19, make_sandwich(_, _, _), 0.001967951764962176) :- !.
delta(19, put_on_tray(_, Tray), 0.00581062875999185) :- ontray(_, Tray), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(19, put_on_tray(_, Tray), 0.003967080106760743) :- ontray(_, Tray), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(19, put_on_tray(_, Tray), -0.10322630276706239) :- ontray(_, Tray), !.
delta(19, put_on_tray(_, _), 9.568229951970524e-5) :- goal_served(Child), done_served(Child), !.
delta(19, put_on_tray(_, _), 0.05497227610607396) :- !.
delta(19, serve_sandwich_no_gluten(_, Child, _, _), 0.0702117896154555) :- todo_served(Child), !.
delta(19, serve_sandwich_no_gluten(_, _, _, _), -0.07426405376172616) :- !.
delta(19, serve_sandwich(_, _, _, _), 0.11092039978282905) :- at_kitchen_sandwich(_), no_gluten_bread(_), !.
delta(19, serve_sandwich(_, _, _, _), -0.40836834560614527) :- at_kitchen_sandwich(_), !.
delta(19, serve_sandwich(_, Child, _, Place), 0.21267945359869092) :- todo_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(19, serve_sandwich(_, Child, _, _), -0.002556129301579254) :- todo_served(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(19, serve_sandwich(_, Child, _, _), 0.023441601460678096) :- todo_served(Child), !.
delta(19, serve_sandwich(_, _, _, _), -0.050727272496797) :- !.
delta(19, move_tray(_, _, _), -0.11933920471614612) :- at_kitchen_sandwich(_), no_gluten_bread(_), fewer_ontray_1_than_todo_served, !.
delta(19, move_tray(_, _, Place), 0.04199371898050452) :- at_kitchen_sandwich(_), no_gluten_bread(_), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(19, move_tray(_, _, _), -0.014979058276332832) :- at_kitchen_sandwich(_), no_gluten_bread(_), !.
delta(19, move_tray(_, Place, _), 0.48612248228666255) :- at_kitchen_sandwich(_), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(19, move_tray(_, Place, Place2), 0.0060989233754133645) :- at_kitchen_sandwich(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(19, move_tray(_, _, _), -0.007171689406753643) :- at_kitchen_sandwich(_), !.
delta(19, move_tray(_, Place, _), -0.21595397122364493) :- todo_served(Child), waiting(Child, Place), !.
delta(19, move_tray(_, _, Place), 0.012122605144542697) :- needed_at_to_serve_sandwich_no_gluten(Place), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(19, move_tray(_, _, Place), 0.10633069270966532) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(19, move_tray(_, _, _), -0.06450853721224734) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 201 examples, 33 leaves
delta(20, make_sandwich_no_gluten(_, _, _), 0.024827483887574855) :- !.
delta(20, make_sandwich(_, Bread_portion, _), -0.00680350677646834) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), fewer_ontray_1_than_todo_served, !.
delta(20, make_sandwich(_, Bread_portion, _), 0.03940483367389043) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), !.
delta(20, make_sandwich(_, _, _), -0.0327592871787919) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(20, make_sandwich(_, _, _), -0.08403016589461665) :- !.
delta(20, put_on_tray(_, _), -0.0005941458881437782) :- fewer_ontray_1_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(20, put_on_tray(_, _), 0.02571589932667724) :- fewer_ontray_1_than_todo_served, !.
delta(20, put_on_tray(_, _), 0.0002947953563384411) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(20, put_on_tray(_, _), -0.06065996112083652) :- !.
delta(20, serve_sandwich_no_gluten(_, Child, _, _), 0.0007504336640212975) :- todo_served(Child), at_kitchen_bread(_), fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_1_than_todo_served, !.
delta(20, serve_sandwich_no_gluten(_, Child, _, _), -0.025445370846318052) :- todo_served(Child), at_kitchen_bread(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(20, serve_sandwich_no_gluten(_, Child, _, _), 0.0009137215175032683) :- todo_served(Child), at_kitchen_bread(_), !.
delta(20, serve_sandwich_no_gluten(_, Child, _, _), 0.055596282951704115) :- todo_served(Child), !.
delta(20, serve_sandwich_no_gluten(_, _, _, _), -0.035495140217805574) :- !.
delta(20, serve_sandwich(_, _, _, _), -0.6921088338237019) :- at_kitchen_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(20, serve_sandwich(_, _, _, _), 0.0031961665812232274) :- at_kitchen_sandwich(_), !.
delta(20, serve_sandwich(_, Child, _, Place), 0.6107474863281138) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(20, serve_sandwich(_, _, _, Place), -0.029464143256063415) :- done_served(Child), waiting(Child, Place), !.
delta(20, serve_sandwich(_, _, _, _), 0.09992949226022453) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(20, serve_sandwich(_, _, _, _), 0.0027857261463341385) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(20, serve_sandwich(_, _, _, _), 0.026808144507144208) :- !.
delta(20, move_tray(Tray, _, Place), -0.008619610316485827) :- at_kitchen_sandwich(_), could_serve_sandwich(Tray, Place), notexist(_), !.
delta(20, move_tray(Tray, _, Place), 0.7269062466157616) :- at_kitchen_sandwich(_), could_serve_sandwich(Tray, Place), !.
delta(20, move_tray(Tray, _, _), -0.09019282757894147) :- at_kitchen_sandwich(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_2_than_todo_served, !.
delta(20, move_tray(Tray, _, _), 0.0015880261903397045) :- at_kitchen_sandwich(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(20, move_tray(_, Place, Place2), 0.05684763818267027) :- at_kitchen_sandwich(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(20, move_tray(_, _, _), -0.012805247571734409) :- at_kitchen_sandwich(_), !.
delta(20, move_tray(_, Place, _), -0.8166500789415011) :- todo_served(Child), waiting(Child, Place), !.
delta(20, move_tray(Tray, _, Place), -0.022760605013068556) :- could_serve_sandwich(Tray, Place), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(20, move_tray(Tray, _, Place), 0.11605729022506332) :- could_serve_sandwich(Tray, Place), !.
delta(20, move_tray(_, _, _), 0.013219550052791842) :- fewer_ontray_1_than_todo_served, !.
delta(20, move_tray(_, _, _), -0.07169533225388483) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 215 examples, 34 leaves
delta(21, make_sandwich_no_gluten(_, _, _), 0.019666852300821377) :- !.
delta(21, make_sandwich(_, Bread_portion, _), -0.0006974205926867175) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), no_gluten_bread(Bread_portion), !.
delta(21, make_sandwich(_, _, _), 0.0) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), fewer_at_1_than_allergic_gluten, !.
delta(21, make_sandwich(_, _, _), 0.04200728387133292) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(21, make_sandwich(_, _, _), -0.008181565619149447) :- no_gluten_sandwich(_), !.
delta(21, make_sandwich(_, _, _), -0.07762886505859803) :- at_kitchen_sandwich(_), !.
delta(21, make_sandwich(_, _, _), -0.005887482972565189) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(21, make_sandwich(_, _, _), 0.000864471512488157) :- !.
delta(21, put_on_tray(_, _), 0.07330359808074347) :- !.
delta(21, serve_sandwich_no_gluten(_, Child, _, _), 0.03323085347092006) :- todo_served(Child), !.
delta(21, serve_sandwich_no_gluten(_, _, _, _), -0.021386733143387803) :- !.
delta(21, serve_sandwich(_, _, _, Place), 0.0008810160015802771) :- fewer_ontray_1_than_not_allergic_gluten, notexist(_), goal_served(Child), done_served(Child), waiting(Child, Place), !.
delta(21, serve_sandwich(_, _, _, _), -0.6078635754672262) :- fewer_ontray_1_than_not_allergic_gluten, notexist(_), goal_served(Child), done_served(Child), !.
delta(21, serve_sandwich(_, _, _, _), 0.036167541879622296) :- fewer_ontray_1_than_not_allergic_gluten, notexist(_), !.
delta(21, serve_sandwich(_, _, _, Place), 0.001586965463810282) :- fewer_ontray_1_than_not_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(21, serve_sandwich(_, _, _, _), -0.11536014632476618) :- fewer_ontray_1_than_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(21, serve_sandwich(_, Child, _, _), 0.04006950394761821) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(21, serve_sandwich(_, _, _, _), -0.02647320917341729) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(21, serve_sandwich(Sandwich, _, _, Place), -0.003778201534991122) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(21, serve_sandwich(_, _, _, _), 0.0006244103865205363) :- notexist(_), !.
delta(21, serve_sandwich(_, _, _, _), 0.005143388668858904) :- !.
delta(21, move_tray(Tray, Place, _), -0.04273517910601649) :- at(Tray, Place2), could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place), !.
delta(21, move_tray(Tray, _, _), 0.7765786070579992) :- at(Tray, Place), could_serve_sandwich(Tray, Place), fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(21, move_tray(Tray, _, _), -0.0026200297228320744) :- at(Tray, Place), could_serve_sandwich(Tray, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(21, move_tray(Tray, _, Place), 0.01329171265617544) :- at(Tray, Place2), could_serve_sandwich(Tray, Place2), todo_served(Child), waiting(Child, Place), !.
delta(21, move_tray(Tray, _, _), -0.020025432484853143) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(21, move_tray(Tray, _, Place), -0.01474849470773525) :- could_serve_sandwich(Tray, Place), at_kitchen_bread(_), fewer_ontray_1_than_todo_served, !.
delta(21, move_tray(Tray, _, Place), 0.0018612636169636804) :- could_serve_sandwich(Tray, Place), at_kitchen_bread(_), !.
delta(21, move_tray(Tray, Place, Place2), -0.006257619694225482) :- could_serve_sandwich(Tray, Place2), at(Tray2, Place), could_put_on_tray(Tray2, Place), !.
delta(21, move_tray(Tray, _, Place), 0.10170793271129204) :- could_serve_sandwich(Tray, Place), !.
delta(21, move_tray(_, Place, Place2), 0.0006876781495744862) :- at(Tray, Place2), could_put_on_tray(Tray, Place), allergic_gluten(Child), waiting(Child, Place2), !.
delta(21, move_tray(_, Place, Place2), -0.00013628458269435858) :- at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(21, move_tray(_, _, _), -0.13305518451121168) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 213 examples, 35 leaves
delta(22, make_sandwich_no_gluten(_, _, _), 0.003130874185821598) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(22, make_sandwich_no_gluten(_, _, _), -0.09398828038889313) :- fewer_at_1_than_allergic_gluten, !.
delta(22, make_sandwich_no_gluten(_, _, _), 0.00929546388426187) :- !.
delta(22, make_sandwich(_, _, Content_portion), -0.003085053792371242) :- fewer_at_2_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, no_gluten_content(Content_portion), !.
delta(22, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(22, make_sandwich(_, _, _), 0.10123852872771776) :- fewer_at_2_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(22, make_sandwich(_, _, _), -0.004098269746614464) :- fewer_at_2_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at_kitchen_sandwich(_), !.
delta(22, make_sandwich(_, _, _), 0.007443515750134104) :- fewer_at_2_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(22, make_sandwich(_, _, _), -0.019530532882441855) :- fewer_at_2_than_todo_served, fewer_at_1_than_todo_served, !.
delta(22, make_sandwich(_, _, _), 3.0443393215374656e-5) :- fewer_at_2_than_todo_served, !.
delta(22, make_sandwich(_, _, _), 0.0026759185124025633) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(22, make_sandwich(_, _, _), -0.001096744668663252) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(22, make_sandwich(_, _, _), -0.07289369936616825) :- !.
delta(22, put_on_tray(Sandwich, _), 0.012494505936245516) :- no_gluten_sandwich(Sandwich), !.
delta(22, put_on_tray(_, Tray), 0.0027583830436596216) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(22, put_on_tray(_, _), 0.0028953931289624796) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(22, put_on_tray(_, _), -0.0023360939971092554) :- fewer_ontray_1_than_allergic_gluten, !.
delta(22, put_on_tray(_, _), -0.06765414428480068) :- !.
delta(22, serve_sandwich_no_gluten(_, _, _, _), 0.00012218319029858922) :- fewer_ontray_2_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(22, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_ontray_2_than_allergic_gluten, !.
delta(22, serve_sandwich_no_gluten(_, _, _, _), 0.008512517343398305) :- !.
delta(22, serve_sandwich(_, Child, _, _), 0.37580843823248994) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(22, serve_sandwich(_, _, _, _), -0.045902417800524675) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(22, serve_sandwich(Sandwich, _, _, _), -0.0017941709271745115) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(22, serve_sandwich(Sandwich, _, _, _), 0.1525547020610531) :- no_gluten_sandwich(Sandwich), !.
delta(22, serve_sandwich(_, _, Tray, _), -0.15033032149764944) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(22, serve_sandwich(_, _, _, _), 0.0025438024532927835) :- !.
delta(22, move_tray(_, Place, _), -0.5475047320233501) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(22, move_tray(Tray, _, Place), -0.001585129065123993) :- could_serve_sandwich(Tray, Place), at(Tray2, Place), ontray(_, Tray2), !.
delta(22, move_tray(Tray, _, Place), -0.0005039555648812765) :- could_serve_sandwich(Tray, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(22, move_tray(Tray, _, Place), 0.09687749834368456) :- could_serve_sandwich(Tray, Place), !.
delta(22, move_tray(_, _, kitchen), 0.09257774900700554) :- at_kitchen_bread(_), !.
delta(22, move_tray(_, _, _), -0.013501208488739631) :- at_kitchen_bread(_), !.
delta(22, move_tray(_, _, _), -0.08849416363257566) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 202 examples, 27 leaves
delta(23, make_sandwich_no_gluten(_, _, _), 0.01563677627652847) :- !.
delta(23, make_sandwich(_, _, _), 0.00022553811342907522) :- goal_served(Child), done_served(Child), !.
delta(23, make_sandwich(_, _, _), -0.06753324290088093) :- !.
delta(23, put_on_tray(_, _), 0.0617207340029131) :- notexist(_), !.
delta(23, put_on_tray(Sandwich, _), 0.013871697884271623) :- no_gluten_sandwich(Sandwich), !.
delta(23, put_on_tray(_, _), 0.00016977907244492316) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(23, put_on_tray(_, _), -0.013688871183065434) :- !.
delta(23, serve_sandwich_no_gluten(_, _, _, Place), 2.593731299820916e-6) :- done_served(Child), waiting(Child, Place), !.
delta(23, serve_sandwich_no_gluten(_, _, _, _), 0.012216228434434038) :- !.
delta(23, serve_sandwich(_, _, _, _), 0.0019209769369725055) :- at_kitchen_sandwich(_), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(23, serve_sandwich(_, _, _, _), -0.05760645919709958) :- at_kitchen_sandwich(_), !.
delta(23, serve_sandwich(_, Child, _, _), 0.053878258492924644) :- todo_served(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(23, serve_sandwich(Sandwich, Child, _, Place), -0.006928574064800028) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(23, serve_sandwich(_, Child, _, _), 0.0001672945525672918) :- todo_served(Child), !.
delta(23, serve_sandwich(_, _, _, _), -0.044793044833876784) :- !.
delta(23, move_tray(Tray, Place, Place2), -0.03147303389302036) :- could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(23, move_tray(Tray, Place, Place2), 0.014743429203074043) :- could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place), !.
delta(23, move_tray(Tray, Place, Place2), -0.00039109338108158596) :- could_serve_sandwich(Tray, Place2), at(Tray2, Place), could_put_on_tray(Tray2, Place), !.
delta(23, move_tray(Tray, _, Place), -4.5987873163708545e-5) :- could_serve_sandwich(Tray, Place), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(23, move_tray(Tray, _, Place), 0.10036020124773763) :- could_serve_sandwich(Tray, Place), !.
delta(23, move_tray(_, Place, Place2), 0.027395547166274747) :- fewer_ontray_1_than_todo_served_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(23, move_tray(_, _, _), -0.009577509371809394) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(23, move_tray(_, Place, Place2), -0.017106254062024737) :- done_served(Child), waiting(Child, Place), goal_served(Child2), waiting(Child2, Place2), !.
delta(23, move_tray(_, Place, _), 0.024147065617663062) :- done_served(Child), waiting(Child, Place), !.
delta(23, move_tray(Tray, _, Place), 0.008816748812586452) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(23, move_tray(_, _, _), -0.0802992700271668) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 235 examples, 45 leaves
delta(24, make_sandwich_no_gluten(_, _, _), 0.01667363900526509) :- !.
delta(24, make_sandwich(_, _, _), -0.003774985718208807) :- at_kitchen_sandwich(_), fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(24, make_sandwich(_, _, _), 0.006759295251526512) :- at_kitchen_sandwich(_), fewer_at_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(24, make_sandwich(_, _, _), 3.183709529171515e-5) :- at_kitchen_sandwich(_), fewer_at_1_than_not_allergic_gluten, !.
delta(24, make_sandwich(_, _, _), -0.05372837105073396) :- at_kitchen_sandwich(_), !.
delta(24, make_sandwich(_, _, _), -0.0007036889987305913) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(24, make_sandwich(_, _, _), 0.00017948411447925335) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(24, make_sandwich(_, _, _), -0.028122445279029865) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(24, make_sandwich(_, _, _), 0.03956784862433659) :- todo_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(24, make_sandwich(_, _, _), -0.0006991797400196434) :- todo_served(Child), allergic_gluten(Child), !.
delta(24, make_sandwich(_, _, _), -0.00012664353929560116) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(24, make_sandwich(_, _, _), 0.00037756989892069967) :- !.
delta(24, put_on_tray(_, Tray), -0.03463175840341594) :- fewer_at_1_than_todo_served_not_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at_kitchen_bread(_), !.
delta(24, put_on_tray(_, Tray), 0.0004246417567655428) :- fewer_at_1_than_todo_served_not_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(24, put_on_tray(_, _), 0.005067468222421818) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(24, put_on_tray(_, Tray), 0.04054592959633952) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(24, put_on_tray(_, Tray), -0.0015873637426092827) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(24, put_on_tray(Sandwich, _), 0.006535974240460508) :- no_gluten_sandwich(Sandwich), !.
delta(24, put_on_tray(_, _), -0.0001756901588017154) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(24, put_on_tray(_, _), -0.030031099338378678) :- !.
delta(24, serve_sandwich_no_gluten(_, Child, _, _), 2.965480444213897e-6) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(24, serve_sandwich_no_gluten(_, Child, _, _), 0.025494380398674726) :- todo_served(Child), !.
delta(24, serve_sandwich_no_gluten(_, _, _, _), -0.10814917328546718) :- !.
delta(24, serve_sandwich(_, _, _, _), -0.4100388363069716) :- at_kitchen_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(24, serve_sandwich(_, _, _, _), 1.2342639645455734e-5) :- at_kitchen_sandwich(_), !.
delta(24, serve_sandwich(_, Child, _, Place), 0.10938324625630044) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), done_served(Child3), not_allergic_gluten(Child3), !.
delta(24, serve_sandwich(_, Child, _, Place), 1.612143433518356e-5) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(24, serve_sandwich(_, _, _, Place), -0.03845394725370011) :- done_served(Child), waiting(Child, Place), !.
delta(24, serve_sandwich(_, _, _, _), -0.000496137548890797) :- notexist(_), goal_served(Child), allergic_gluten(Child), !.
delta(24, serve_sandwich(_, _, _, _), 0.021796660654213554) :- notexist(_), !.
delta(24, serve_sandwich(_, _, _, _), -0.12673605462506826) :- goal_served(Child), done_served(Child), !.
delta(24, serve_sandwich(_, _, _, _), 0.0006540375459463311) :- !.
delta(24, move_tray(Tray, Place, Place2), -0.057859294976562) :- at(Tray, kitchen), at(Tray2, Place), could_serve_sandwich_no_gluten(Tray2, Place2), !.
delta(24, move_tray(Tray, _, _), -0.0003268336576050763) :- at(Tray, kitchen), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(24, move_tray(Tray, _, _), 0.04241311746279922) :- at(Tray, kitchen), at_kitchen_sandwich(_), !.
delta(24, move_tray(Tray, _, Place), 0.013189521958701239) :- at(Tray, kitchen), could_serve_sandwich(Tray, Place), !.
delta(24, move_tray(Tray, _, _), -0.0239887291293459) :- at(Tray, kitchen), !.
delta(24, move_tray(Tray, Place, Place2), 0.0029756038975391253) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), could_put_on_tray(Tray, Place2), !.
delta(24, move_tray(_, Place, _), -0.08643813337379157) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(24, move_tray(Tray, Place, _), 0.10016765463558314) :- done_served(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(24, move_tray(_, Place, _), -0.00632988623392405) :- done_served(Child), waiting(Child, Place), !.
delta(24, move_tray(_, Place, _), -0.0014837331851657513) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(24, move_tray(_, _, _), 0.009498772986037608) :- notexist(_), !.
delta(24, move_tray(_, _, _), 0.5249676669122136) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 202 examples, 41 leaves
delta(25, make_sandwich_no_gluten(_, _, _), 0.012946916535963639) :- !.
delta(25, make_sandwich(_, _, _), -0.004542737917539497) :- fewer_at_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(25, make_sandwich(_, _, _), 0.013945092139378798) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(25, make_sandwich(_, _, _), 0.0010592364486479437) :- fewer_at_1_than_not_allergic_gluten, !.
delta(25, make_sandwich(_, Bread_portion, _), -0.008361588616613444) :- at_kitchen_bread(Bread_portion2), no_gluten_bread(Bread_portion2), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(25, make_sandwich(_, _, _), 0.00036170054869739563) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(25, make_sandwich(_, _, _), 0.008673577833531398) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(25, make_sandwich(_, _, _), -0.11098069411308695) :- !.
delta(25, put_on_tray(_, Tray), 0.02496727504933875) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(25, put_on_tray(_, Tray), -0.010942606497923975) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(25, put_on_tray(Sandwich, _), 0.0019187798919589995) :- at_kitchen_sandwich(Sandwich2), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), !.
delta(25, put_on_tray(_, _), 0.0) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(25, put_on_tray(_, _), 6.914712083854713e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(25, put_on_tray(_, _), -0.020998509759118905) :- fewer_at_2_than_todo_served, !.
delta(25, put_on_tray(_, _), 4.169575187479459e-5) :- !.
delta(25, serve_sandwich_no_gluten(_, _, _, _), -0.02264082381014899) :- at_kitchen_bread(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(25, serve_sandwich_no_gluten(_, _, _, _), 0.00032306121324667827) :- at_kitchen_bread(_), !.
delta(25, serve_sandwich_no_gluten(_, Child, _, _), 0.01425099003787806) :- todo_served(Child), !.
delta(25, serve_sandwich_no_gluten(_, _, _, _), -0.012131976287994254) :- !.
delta(25, serve_sandwich(Sandwich, _, _, _), -0.0020216777997188497) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(25, serve_sandwich(Sandwich, Child, _, _), 0.16762017220187414) :- no_gluten_sandwich(Sandwich), todo_served(Child), !.
delta(25, serve_sandwich(Sandwich, _, _, _), -0.0013998573615764676) :- no_gluten_sandwich(Sandwich), !.
delta(25, serve_sandwich(_, _, _, _), -0.007189411660014554) :- notexist(_), fewer_ontray_1_than_todo_served, !.
delta(25, serve_sandwich(_, _, _, _), 0.07167579323295224) :- notexist(_), !.
delta(25, serve_sandwich(_, _, _, _), -0.00017383450934397617) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(25, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_sandwich(_), !.
delta(25, serve_sandwich(_, _, _, Place), 0.009413667845857426) :- done_served(Child), waiting(Child, Place), !.
delta(25, serve_sandwich(_, _, _, _), -0.17762961707389574) :- !.
delta(25, move_tray(_, Place, kitchen), 0.02167905737958532) :- done_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(25, move_tray(_, Place, kitchen), -0.006085288126532079) :- done_served(Child), waiting(Child, Place), !.
delta(25, move_tray(_, Place, _), -0.04032013267965964) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(25, move_tray(_, Place, Place2), 0.005133317204394154) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(25, move_tray(_, Place, _), -0.0012281177693265067) :- done_served(Child), waiting(Child, Place), !.
delta(25, move_tray(_, _, kitchen), 0.016497028748845934) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(25, move_tray(Tray, _, kitchen), 0.008991980536597815) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(25, move_tray(_, _, kitchen), -0.045146341352357455) :- !.
delta(25, move_tray(_, _, _), 0.21041137335250193) :- fewer_at_1_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(25, move_tray(_, _, _), -0.006011513889500094) :- fewer_at_1_than_todo_served, !.
delta(25, move_tray(_, _, Place), 0.00448708607191883) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(25, move_tray(_, _, _), -0.012350893308161252) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 247 examples, 37 leaves
delta(26, make_sandwich_no_gluten(_, _, _), 0.023257377440253444) :- !.
delta(26, make_sandwich(_, _, _), -0.012035003146406455) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(26, make_sandwich(_, _, _), -0.0011718685752939069) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(26, make_sandwich(_, _, _), -0.08295532324724743) :- fewer_ontray_2_than_allergic_gluten, !.
delta(26, make_sandwich(_, _, _), 0.010922731013864385) :- no_gluten_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(26, make_sandwich(_, _, _), -0.00059497815112674) :- no_gluten_sandwich(_), !.
delta(26, make_sandwich(_, _, _), 0.0) :- goal_served(Child), done_served(Child), !.
delta(26, make_sandwich(_, _, _), -0.006285147633861017) :- !.
delta(26, put_on_tray(_, _), -0.0008889475527701804) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(26, put_on_tray(_, _), 6.378853797603865e-6) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(26, put_on_tray(_, _), 0.03261616667682535) :- fewer_ontray_1_than_todo_served, !.
delta(26, put_on_tray(_, Tray), -0.000592733215285245) :- ontray(_, Tray), !.
delta(26, put_on_tray(_, _), 0.00011884880511167638) :- !.
delta(26, serve_sandwich_no_gluten(_, _, _, _), 3.023949154328028e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(26, serve_sandwich_no_gluten(_, _, _, _), 0.010425958607773173) :- !.
delta(26, serve_sandwich(_, _, _, _), -0.31302382128436806) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(26, serve_sandwich(_, Child, _, _), 0.07637314288894827) :- at_kitchen_sandwich(_), todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(26, serve_sandwich(_, Child, _, _), -0.0033488337095719397) :- at_kitchen_sandwich(_), todo_served(Child), !.
delta(26, serve_sandwich(_, _, _, _), -0.00923435750528953) :- at_kitchen_sandwich(_), !.
delta(26, serve_sandwich(_, Child, _, _), 0.024555442435486956) :- notexist(_), todo_served(Child), !.
delta(26, serve_sandwich(_, _, _, _), -0.009065682176207544) :- notexist(_), !.
delta(26, serve_sandwich(_, _, _, _), -0.10422847320374552) :- done_served(Child), not_allergic_gluten(Child), !.
delta(26, serve_sandwich(_, _, _, _), 0.0016686704316859666) :- !.
delta(26, move_tray(Tray, _, kitchen), -0.004559951716370327) :- at_kitchen_bread(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(26, move_tray(_, _, kitchen), -0.000422995150004782) :- at_kitchen_bread(_), at(_, kitchen), !.
delta(26, move_tray(_, _, kitchen), 0.026841131847401896) :- at_kitchen_bread(_), !.
delta(26, move_tray(_, Place, kitchen), -0.10014686593801427) :- at(Tray, Place), ontray(_, Tray), !.
delta(26, move_tray(_, _, kitchen), -0.0018479469868582768) :- at(_, kitchen), !.
delta(26, move_tray(_, _, kitchen), 0.0092753714357285) :- !.
delta(26, move_tray(Tray, _, _), -0.02700516395835291) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(26, move_tray(Tray, _, Place), 0.010329333979171572) :- at(Tray, kitchen), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(26, move_tray(Tray, _, _), -0.011966047897604599) :- at(Tray, kitchen), !.
delta(26, move_tray(_, _, _), -0.0003225066343710699) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(26, move_tray(_, _, _), 0.42329233043953934) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(26, move_tray(Tray, _, Place), 0.004020334811113389) :- could_serve_sandwich(Tray, Place), !.
delta(26, move_tray(_, _, _), -0.007649568729233878) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 204 examples, 35 leaves
delta(27, make_sandwich_no_gluten(_, _, _), 0.02444056293854229) :- !.
delta(27, make_sandwich(_, Bread_portion, _), -0.0005936876490544626) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(27, make_sandwich(_, _, _), 0.08783128904408061) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(27, make_sandwich(_, _, _), -0.031062799225847825) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(27, make_sandwich(_, _, _), -0.03427816695329333) :- !.
delta(27, put_on_tray(_, _), 0.013896568418431437) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(27, put_on_tray(_, Tray), -0.05833974254830467) :- at_kitchen_bread(_), ontray(_, Tray), !.
delta(27, put_on_tray(_, _), 3.1754061119029544e-5) :- at_kitchen_bread(_), !.
delta(27, put_on_tray(_, _), 0.0084104876510877) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(27, put_on_tray(_, _), -0.00156975547010789) :- !.
delta(27, serve_sandwich_no_gluten(_, _, _, _), 0.0010514761847276468) :- fewer_ontray_2_than_todo_served, fewer_at_1_than_todo_served, !.
delta(27, serve_sandwich_no_gluten(_, _, _, _), -0.021647819460852084) :- fewer_ontray_2_than_todo_served, !.
delta(27, serve_sandwich_no_gluten(_, _, _, _), 0.002822127993711032) :- !.
delta(27, serve_sandwich(_, Child, _, _), 0.0068834308482817064) :- goal_served(Child2), done_served(Child2), at_kitchen_bread(_), todo_served(Child), !.
delta(27, serve_sandwich(_, _, _, _), -0.00029151189499590095) :- goal_served(Child), done_served(Child), at_kitchen_bread(_), !.
delta(27, serve_sandwich(_, _, _, _), -0.6231804737280208) :- goal_served(Child), done_served(Child), fewer_no_gluten_sandwich_than_todo_served, !.
delta(27, serve_sandwich(_, Child, _, _), 0.005404459830281332) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(27, serve_sandwich(_, _, _, _), -0.005575793009857633) :- goal_served(Child), done_served(Child), !.
delta(27, serve_sandwich(Sandwich, _, _, _), -0.10182620676504066) :- no_gluten_sandwich(Sandwich), !.
delta(27, serve_sandwich(_, _, _, _), 0.06021625723174691) :- todo_served(Child), allergic_gluten(Child), !.
delta(27, serve_sandwich(_, _, _, _), 0.0) :- notexist(_), !.
delta(27, serve_sandwich(_, _, _, _), 0.001410270542492222) :- !.
delta(27, move_tray(_, _, Place), -0.07719068006172661) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(27, move_tray(_, _, Place), -0.002203932665229923) :- allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(27, move_tray(_, Place, Place2), -0.0013840737943281818) :- allergic_gluten(Child), waiting(Child, Place2), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(27, move_tray(_, _, Place), 0.01851104606827541) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(27, move_tray(Tray, Place, Place2), -0.011895575519271997) :- fewer_at_1_than_todo_served, at(Tray2, Place), could_put_on_tray(Tray2, Place2), ontray(_, Tray), !.
delta(27, move_tray(_, Place, Place2), 0.0023340728249342155) :- fewer_at_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(27, move_tray(_, _, Place), -0.004484734272376416) :- fewer_at_1_than_todo_served, done_served(Child), waiting(Child, Place), !.
delta(27, move_tray(_, _, _), 0.7668386892069942) :- fewer_at_1_than_todo_served, !.
delta(27, move_tray(_, _, kitchen), -0.004779404692768964) :- at(_, kitchen), !.
delta(27, move_tray(_, _, kitchen), 0.0157678379837663) :- !.
delta(27, move_tray(Tray, _, Place), 0.007396631310728484) :- could_serve_sandwich(Tray, Place), !.
delta(27, move_tray(_, _, _), -0.019793646435772597) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 208 examples, 39 leaves
delta(28, make_sandwich_no_gluten(_, _, _), -0.00958985038068292) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(28, make_sandwich_no_gluten(_, _, _), 0.0005129643589770923) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(28, make_sandwich_no_gluten(_, _, _), 0.006367776071098715) :- !.
delta(28, make_sandwich(_, _, Content_portion), -0.0006786770935133973) :- goal_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), no_gluten_content(Content_portion), !.
delta(28, make_sandwich(_, _, _), 0.10080525806478141) :- goal_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(28, make_sandwich(_, _, _), -0.00914855302345576) :- goal_served(Child), allergic_gluten(Child), !.
delta(28, make_sandwich(_, _, _), -0.026240580038700844) :- at_kitchen_sandwich(_), !.
delta(28, make_sandwich(_, _, _), 0.009183389604171761) :- !.
delta(28, put_on_tray(_, _), 0.055114284180041447) :- fewer_ontray_1_than_todo_served, !.
delta(28, put_on_tray(_, _), 0.0019659595224311966) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(28, put_on_tray(_, _), -0.016870525665774655) :- !.
delta(28, serve_sandwich_no_gluten(_, _, _, _), 3.1920720528826226e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(28, serve_sandwich_no_gluten(_, _, _, _), 0.003710748618476359) :- !.
delta(28, serve_sandwich(_, Child, _, _), 0.03476693234233872) :- goal_served(Child2), allergic_gluten(Child2), done_served(Child3), not_allergic_gluten(Child3), todo_served(Child), !.
delta(28, serve_sandwich(_, _, _, _), -0.010045017724437723) :- goal_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(28, serve_sandwich(_, _, _, _), -0.43816360954400074) :- goal_served(Child), allergic_gluten(Child), fewer_no_gluten_sandwich_than_todo_served, !.
delta(28, serve_sandwich(_, _, _, _), 8.093545452820054e-5) :- goal_served(Child), allergic_gluten(Child), !.
delta(28, serve_sandwich(_, Child, _, _), 0.00237198263175625) :- fewer_ontray_1_than_not_allergic_gluten, notexist(_), todo_served(Child), !.
delta(28, serve_sandwich(_, _, _, _), -0.0029251138720806295) :- fewer_ontray_1_than_not_allergic_gluten, notexist(_), !.
delta(28, serve_sandwich(_, Child, _, _), 0.28713233449988096) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(28, serve_sandwich(_, _, _, _), -0.007027730847334622) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(28, serve_sandwich(Sandwich, _, _, _), 0.1725163381370233) :- no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(28, serve_sandwich(Sandwich, _, _, _), 0.00012651084621919788) :- no_gluten_sandwich(Sandwich), !.
delta(28, serve_sandwich(_, _, Tray, _), -0.17222119021324608) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(28, serve_sandwich(_, _, _, _), 0.0008711086127775003) :- !.
delta(28, move_tray(_, _, Place), -0.02402236714372122) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(28, move_tray(_, _, Place), 0.0603834638236627) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(28, move_tray(Tray, _, Place), -0.005646784299611901) :- fewer_ontray_1_than_not_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(28, move_tray(Tray, _, _), 0.006301224991470089) :- fewer_ontray_1_than_not_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(28, move_tray(_, _, _), -0.5302517789175146) :- fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_2_than_todo_served, !.
delta(28, move_tray(_, _, _), -0.00032375054336207065) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(28, move_tray(_, Place, _), -6.423293322932971e-5) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(28, move_tray(_, Place, _), 0.42161862355858254) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(28, move_tray(_, Place, _), -0.0018904811713363898) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(28, move_tray(_, Place, Place2), 0.007806307842540318) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_at_1_than_allergic_gluten, !.
delta(28, move_tray(_, Place, Place2), -0.03728088656185347) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(28, move_tray(_, _, Place), -0.010771119256611904) :- at(_, Place), !.
delta(28, move_tray(_, _, _), 0.02820176361252257) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 248 examples, 34 leaves
delta(29, make_sandwich_no_gluten(_, _, _), 0.010308859512581313) :- !.
delta(29, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(29, make_sandwich(_, _, _), -0.00125267748780265) :- fewer_at_1_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(29, make_sandwich(_, _, _), -0.044704563740826674) :- fewer_at_1_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(29, make_sandwich(_, _, _), -0.003286902029066733) :- fewer_at_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(29, make_sandwich(_, _, _), 0.005639302901067374) :- fewer_at_1_than_todo_served, !.
delta(29, make_sandwich(_, _, _), -0.0013636275154614082) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(29, make_sandwich(_, _, _), 0.03066197538254648) :- todo_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(29, make_sandwich(_, _, _), 0.00019722443422924487) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(29, make_sandwich(_, _, _), -0.007368774318519311) :- !.
delta(29, put_on_tray(_, _), 0.02746466781315772) :- fewer_at_1_than_todo_served, !.
delta(29, put_on_tray(_, _), -0.02760774478420705) :- at_kitchen_bread(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(29, put_on_tray(_, _), 7.887897572477254e-5) :- at_kitchen_bread(_), !.
delta(29, put_on_tray(Sandwich, _), 0.010449532257587267) :- no_gluten_sandwich(Sandwich), !.
delta(29, put_on_tray(_, _), -0.007926167550413707) :- todo_served(Child), allergic_gluten(Child), !.
delta(29, put_on_tray(_, _), 0.0003240448939690573) :- !.
delta(29, serve_sandwich_no_gluten(_, _, _, _), 8.247493025041988e-6) :- done_served(Child), allergic_gluten(Child), !.
delta(29, serve_sandwich_no_gluten(_, _, _, _), 0.011449008669671152) :- !.
delta(29, serve_sandwich(_, Child, _, _), 0.16163868241831622) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(29, serve_sandwich(Sandwich, Child, _, _), 0.053535135179516496) :- todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(29, serve_sandwich(_, Child, _, _), 0.004544330426052163) :- todo_served(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(29, serve_sandwich(_, Child, _, _), -0.05547164494010068) :- todo_served(Child), !.
delta(29, serve_sandwich(_, _, _, _), -0.00820020624063026) :- !.
delta(29, move_tray(Tray, Place, Place2), -0.02248230185991406) :- at(Tray2, Place), ontray(_, Tray2), could_put_on_tray(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(29, move_tray(Tray, Place, Place2), 0.03506065227121289) :- at(Tray2, Place), ontray(_, Tray2), could_put_on_tray(Tray, Place2), fewer_at_2_than_todo_served, !.
delta(29, move_tray(Tray, Place, Place2), -0.01062001686755154) :- at(Tray2, Place), ontray(_, Tray2), could_put_on_tray(Tray, Place2), !.
delta(29, move_tray(_, Place, _), -0.19442232322329273) :- at(Tray, Place), ontray(_, Tray), fewer_no_gluten_sandwich_than_todo_served, !.
delta(29, move_tray(_, Place, Place2), 0.010460061060056468) :- at(Tray, Place), ontray(_, Tray), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(29, move_tray(_, Place, _), -0.008454982676678175) :- at(Tray, Place), ontray(_, Tray), !.
delta(29, move_tray(_, _, Place), -0.004681697179708824) :- at(_, Place), !.
delta(29, move_tray(_, _, Place), -0.0015801939124208762) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(29, move_tray(_, _, Place), -0.0006624569370475386) :- done_served(Child), waiting(Child, Place), !.
delta(29, move_tray(_, _, _), 0.0421610625070627) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 210 examples, 35 leaves
delta(30, make_sandwich_no_gluten(_, _, _), -0.0800277161996372) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(30, make_sandwich_no_gluten(_, _, _), 0.0021766667843912133) :- fewer_at_1_than_allergic_gluten, !.
delta(30, make_sandwich_no_gluten(_, _, _), 0.0122325221531246) :- !.
delta(30, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(30, make_sandwich(_, _, _), -0.0012667562455305763) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(30, make_sandwich(_, _, _), 0.07969653656574514) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(30, make_sandwich(_, _, _), -0.0004008060055474668) :- fewer_at_1_than_allergic_gluten, !.
delta(30, make_sandwich(_, _, _), -0.010915296687440833) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(30, make_sandwich(_, _, _), 0.048831280988986155) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_no_gluten_sandwich_than_todo_served, !.
delta(30, make_sandwich(_, _, _), -0.0012912157033125639) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(30, make_sandwich(_, _, _), -0.10071677906939684) :- !.
delta(30, put_on_tray(_, _), 0.04398941431586118) :- fewer_ontray_2_than_todo_served, !.
delta(30, put_on_tray(_, _), -0.003687520381559982) :- !.
delta(30, serve_sandwich_no_gluten(_, _, _, _), 4.207323539964414e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(30, serve_sandwich_no_gluten(_, _, _, _), 0.0008901555529441163) :- !.
delta(30, serve_sandwich(_, _, _, Place), 0.021510481158061034) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, no_gluten_bread(_), done_served(Child), waiting(Child, Place), !.
delta(30, serve_sandwich(_, _, _, _), -0.4682708346654049) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, no_gluten_bread(_), !.
delta(30, serve_sandwich(_, _, _, _), 0.055758969353105724) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(30, serve_sandwich(_, Child, _, Place), -0.00013606940125942657) :- todo_served(Child), no_gluten_sandwich(_), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(30, serve_sandwich(_, Child, _, _), 0.0037985114328748645) :- todo_served(Child), no_gluten_sandwich(_), !.
delta(30, serve_sandwich(_, Child, _, _), 0.1510449549681529) :- todo_served(Child), !.
delta(30, serve_sandwich(_, _, _, _), -0.2565160932648238) :- !.
delta(30, move_tray(_, Place, _), -0.01803721140174021) :- not_allergic_gluten(Child), waiting(Child, Place), todo_served(Child2), allergic_gluten(Child2), todo_served(Child), !.
delta(30, move_tray(_, Place, _), 0.00021045435687775822) :- not_allergic_gluten(Child), waiting(Child, Place), todo_served(Child2), allergic_gluten(Child2), !.
delta(30, move_tray(_, Place, Place2), -0.007422610923014832) :- not_allergic_gluten(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place2), !.
delta(30, move_tray(_, Place, _), 0.47007274436543944) :- not_allergic_gluten(Child), waiting(Child, Place), no_gluten_bread(_), !.
delta(30, move_tray(_, Place, _), 0.03223377176469112) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(30, move_tray(_, Place, Place2), 0.015248827693366872) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(30, move_tray(Tray, _, Place), 0.002320394579149134) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, could_serve_sandwich(Tray, Place), !.
delta(30, move_tray(_, _, _), -0.006099978771901056) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(30, move_tray(_, _, Place), 0.011908037713466681) :- at(_, Place), todo_served(Child), waiting(Child, Place), !.
delta(30, move_tray(_, _, Place), -0.0026411302362810596) :- at(_, Place), !.
delta(30, move_tray(_, _, _), 0.003199405571051603) :- goal_served(Child), done_served(Child), !.
delta(30, move_tray(_, _, _), -0.06429833293139263) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 241 examples, 34 leaves
delta(31, make_sandwich_no_gluten(_, _, _), 3.084781876730568e-5) :- at_kitchen_sandwich(_), fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(31, make_sandwich_no_gluten(_, _, _), -0.03853883515268369) :- at_kitchen_sandwich(_), fewer_at_1_than_not_allergic_gluten, !.
delta(31, make_sandwich_no_gluten(_, _, _), 0.000722953451028022) :- at_kitchen_sandwich(_), !.
delta(31, make_sandwich_no_gluten(_, _, _), 0.01249419852630787) :- !.
delta(31, make_sandwich(_, _, _), 0.0) :- fewer_ontray_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), todo_served(Child), not_allergic_gluten(Child), fewer_at_1_than_allergic_gluten, !.
delta(31, make_sandwich(_, _, _), 0.06355698200767745) :- fewer_ontray_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(31, make_sandwich(_, _, _), -0.0028634291376824954) :- fewer_ontray_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(31, make_sandwich(_, _, _), -0.01434934480159454) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(31, make_sandwich(_, _, _), -0.06086416105897545) :- !.
delta(31, put_on_tray(_, _), -0.026976225935105364) :- fewer_ontray_1_than_todo_served_allergic_gluten, at_kitchen_bread(_), !.
delta(31, put_on_tray(_, _), 1.3653354040380911e-5) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(31, put_on_tray(_, _), 0.021901225676149112) :- !.
delta(31, serve_sandwich_no_gluten(_, _, _, _), 0.00132762766095716) :- !.
delta(31, serve_sandwich(_, Child, Tray, _), 0.04597216339784334) :- todo_served(Child), done_served(Child2), not_allergic_gluten(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place), !.
delta(31, serve_sandwich(_, Child, _, _), -0.02858940083175628) :- todo_served(Child), done_served(Child2), not_allergic_gluten(Child2), fewer_ontray_1_than_todo_served, !.
delta(31, serve_sandwich(_, Child, _, _), 0.010541917593888925) :- todo_served(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(31, serve_sandwich(Sandwich, Child, Tray, _), 0.04882372146863764) :- todo_served(Child), ontray(Sandwich2, Tray), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), !.
delta(31, serve_sandwich(_, Child, Tray, _), -0.04119909286000172) :- todo_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(31, serve_sandwich(_, Child, _, _), 0.0008097606195306604) :- todo_served(Child), at_kitchen_bread(_), !.
delta(31, serve_sandwich(_, Child, _, _), 0.23011730467782396) :- todo_served(Child), !.
delta(31, serve_sandwich(_, _, _, _), -0.2209800116969463) :- !.
delta(31, move_tray(_, Place, _), -0.24329987434443026) :- at_kitchen_sandwich(_), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(31, move_tray(_, Place, Place2), 0.028044197497215803) :- at_kitchen_sandwich(_), fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(31, move_tray(_, _, _), -0.005723691589889366) :- at_kitchen_sandwich(_), fewer_ontray_1_than_allergic_gluten, !.
delta(31, move_tray(_, Place, Place2), 0.014051849607923772) :- at_kitchen_sandwich(_), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(31, move_tray(_, _, _), -0.023574494477481216) :- at_kitchen_sandwich(_), !.
delta(31, move_tray(_, _, Place), -0.06714980680680238) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_2_than_todo_served, !.
delta(31, move_tray(_, _, Place), 0.001856752562291676) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(31, move_tray(_, _, Place), -0.00595640762135759) :- todo_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(31, move_tray(_, _, Place), 0.034065007325058974) :- todo_served(Child), waiting(Child, Place), !.
delta(31, move_tray(_, Place, _), -0.00453393701664271) :- not_allergic_gluten(Child), waiting(Child, Place), no_gluten_bread(_), !.
delta(31, move_tray(_, Place, _), 0.2764046696744304) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(31, move_tray(_, _, _), -0.015996694586258086) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 220 examples, 37 leaves
delta(32, make_sandwich_no_gluten(_, _, _), 0.007692606695298864) :- !.
delta(32, make_sandwich(_, _, _), 0.0) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(32, make_sandwich(_, Bread_portion, _), -0.0006836049741447907) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), !.
delta(32, make_sandwich(_, _, _), 0.06817402306788706) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(32, make_sandwich(_, _, _), -0.000236400155519867) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(32, make_sandwich(_, _, Content_portion), -0.030533451713425704) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_content(Content_portion), !.
delta(32, make_sandwich(_, _, _), -0.005947594544276621) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(32, make_sandwich(_, _, _), 0.02766624664471794) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(32, make_sandwich(_, _, _), -0.06830028060191701) :- !.
delta(32, put_on_tray(_, _), 0.020039528031111177) :- fewer_ontray_1_than_todo_served, !.
delta(32, put_on_tray(_, _), -0.0031811619070610695) :- !.
delta(32, serve_sandwich_no_gluten(_, _, _, _), 5.061607788108392e-5) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(32, serve_sandwich_no_gluten(_, _, _, _), 0.006278671509464041) :- !.
delta(32, serve_sandwich(Sandwich, _, _, _), -0.3476765705012623) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(32, serve_sandwich(Sandwich, _, _, _), 0.008253061595454275) :- no_gluten_sandwich(Sandwich), !.
delta(32, serve_sandwich(_, _, _, _), 0.22424510421499722) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served, !.
delta(32, serve_sandwich(_, _, Tray, _), 0.014363831369647759) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(32, serve_sandwich(_, _, _, _), -0.03646762712166914) :- done_served(Child), not_allergic_gluten(Child), !.
delta(32, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_1_than_todo_served, goal_served(Child), done_served(Child), !.
delta(32, serve_sandwich(_, _, _, _), -0.024428702931275137) :- fewer_ontray_1_than_todo_served, !.
delta(32, serve_sandwich(_, _, _, _), 0.00890970762380291) :- !.
delta(32, move_tray(_, Place, Place2), -0.08044304997837601) :- not_allergic_gluten(Child), waiting(Child, Place2), done_served(Child2), waiting(Child2, Place), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(32, move_tray(Tray, Place, Place2), 0.003423600704004268) :- not_allergic_gluten(Child), waiting(Child, Place2), done_served(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place2), !.
delta(32, move_tray(_, Place, Place2), -0.0031987156136655957) :- not_allergic_gluten(Child), waiting(Child, Place2), done_served(Child2), waiting(Child2, Place), !.
delta(32, move_tray(_, Place, Place2), 0.0033071039429937526) :- not_allergic_gluten(Child), waiting(Child, Place2), done_served(Child), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(32, move_tray(_, _, Place), -0.022895511737717745) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child), !.
delta(32, move_tray(_, _, Place), -0.009133593576021271) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(_), !.
delta(32, move_tray(_, _, Place), 0.06821618310977609) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(32, move_tray(Tray, _, _), -0.011738676844684168) :- notexist(_), at(Tray, kitchen), fewer_ontray_2_than_todo_served, !.
delta(32, move_tray(Tray, _, _), 7.561023852205859e-6) :- notexist(_), at(Tray, kitchen), !.
delta(32, move_tray(_, _, Place), -0.0009714859862266001) :- notexist(_), at(_, Place), !.
delta(32, move_tray(_, _, _), 0.23159197351474978) :- notexist(_), !.
delta(32, move_tray(Tray, _, Place), 0.006591349270806395) :- needed_at_to_serve_sandwich_no_gluten(Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(32, move_tray(_, _, Place), -0.001799829412056195) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(32, move_tray(_, Place, _), -0.02415633313975443) :- at(Tray, Place), ontray(_, Tray), !.
delta(32, move_tray(_, _, _), 0.003478655256173947) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 257 examples, 43 leaves
delta(33, make_sandwich_no_gluten(_, _, _), 0.01692651810987714) :- !.
delta(33, make_sandwich(_, _, _), -0.0022469624446307397) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, fewer_ontray_1_than_allergic_gluten, fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(33, make_sandwich(_, _, _), 0.0) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, fewer_ontray_1_than_allergic_gluten, !.
delta(33, make_sandwich(_, Bread_portion, _), -0.0008213062299816837) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(33, make_sandwich(_, _, _), 0.05135921548804391) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(33, make_sandwich(_, _, _), -0.017206750643123832) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_2_than_todo_served, !.
delta(33, make_sandwich(_, _, _), 0.0007578480218871092) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(33, make_sandwich(_, _, _), -0.03011371845993509) :- !.
delta(33, put_on_tray(_, Tray), 0.0025785776421752395) :- ontray(_, Tray), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(33, put_on_tray(_, Tray), 0.0019280744876283495) :- ontray(_, Tray), fewer_at_2_than_allergic_gluten, !.
delta(33, put_on_tray(_, Tray), -0.05034631837354181) :- ontray(_, Tray), goal_served(Child), allergic_gluten(Child), !.
delta(33, put_on_tray(_, Tray), 0.0013130610099215826) :- ontray(_, Tray), !.
delta(33, put_on_tray(Sandwich, _), 0.0010777323776062124) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, fewer_at_1_than_not_allergic_gluten, !.
delta(33, put_on_tray(Sandwich, _), -0.030604340516622874) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(33, put_on_tray(Sandwich, _), 0.007155783612522398) :- no_gluten_sandwich(Sandwich), !.
delta(33, put_on_tray(_, _), 0.03737723778920433) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(33, put_on_tray(_, _), -0.008261463292110027) :- !.
delta(33, serve_sandwich_no_gluten(_, _, _, _), -0.01918154996417584) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(33, serve_sandwich_no_gluten(_, _, _, _), 4.007933029007584e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(33, serve_sandwich_no_gluten(_, _, _, _), 0.010872046790278962) :- !.
delta(33, serve_sandwich(_, _, Tray, _), 5.792818462372965e-5) :- goal_served(Child), done_served(Child), fewer_at_2_than_allergic_gluten, waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(33, serve_sandwich(_, _, _, _), -0.0001644170717153807) :- goal_served(Child), done_served(Child), fewer_at_2_than_allergic_gluten, !.
delta(33, serve_sandwich(_, _, _, Place), 0.0) :- goal_served(Child), done_served(Child), allergic_gluten(Child2), waiting(Child2, Place), fewer_ontray_1_than_todo_served, !.
delta(33, serve_sandwich(_, _, _, Place), 0.003574413221782466) :- goal_served(Child), done_served(Child), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(33, serve_sandwich(_, Child, _, _), 0.1429337587726731) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(33, serve_sandwich(_, _, _, _), -0.007768417584145171) :- goal_served(Child), done_served(Child), !.
delta(33, serve_sandwich(_, _, _, _), -0.03034665582060345) :- no_gluten_bread(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(33, serve_sandwich(_, _, _, _), 4.933836798656081e-6) :- no_gluten_bread(_), fewer_ontray_2_than_todo_served, !.
delta(33, serve_sandwich(_, _, _, _), 0.00024466855670101083) :- no_gluten_bread(_), !.
delta(33, serve_sandwich(_, _, _, _), 0.0007865798066137877) :- !.
delta(33, move_tray(_, Place, _), -6.453376987921175e-5) :- todo_served(Child), waiting(Child, Place), goal_served(Child2), done_served(Child2), fewer_at_2_than_allergic_gluten, waiting(Child2, Place), !.
delta(33, move_tray(_, Place, _), 0.01918460855633729) :- todo_served(Child), waiting(Child, Place), goal_served(Child2), done_served(Child2), fewer_at_2_than_allergic_gluten, !.
delta(33, move_tray(_, Place, _), -0.20677998915505127) :- todo_served(Child), waiting(Child, Place), goal_served(Child2), done_served(Child2), !.
delta(33, move_tray(_, Place, _), -0.000247923503878775) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(33, move_tray(_, Place, _), 0.026189257332616043) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(33, move_tray(_, Place, _), -0.009667458934703357) :- todo_served(Child), waiting(Child, Place), !.
delta(33, move_tray(_, Place, Place2), 0.026083416367658745) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(33, move_tray(_, _, _), -0.049628654508683034) :- fewer_ontray_1_than_todo_served, !.
delta(33, move_tray(Tray, _, Place), 0.08837414460086099) :- could_serve_sandwich(Tray, Place), no_gluten_sandwich(_), !.
delta(33, move_tray(Tray, _, Place), 0.005965020532002157) :- could_serve_sandwich(Tray, Place), !.
delta(33, move_tray(Tray, _, Place), 0.004082192402547693) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(33, move_tray(_, _, _), -0.03489905052915535) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 205 examples, 34 leaves
delta(34, make_sandwich_no_gluten(_, _, _), 0.001956039717251195) :- at_kitchen_sandwich(_), no_gluten_sandwich(_), !.
delta(34, make_sandwich_no_gluten(_, _, _), -0.03634160480362636) :- at_kitchen_sandwich(_), !.
delta(34, make_sandwich_no_gluten(_, _, _), 0.00449649706189323) :- !.
delta(34, make_sandwich(_, _, _), -0.0022022004846225006) :- todo_served(Child), allergic_gluten(Child), fewer_at_2_than_allergic_gluten, !.
delta(34, make_sandwich(_, Bread_portion, _), -0.0005368930735779806) :- todo_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), no_gluten_bread(Bread_portion), !.
delta(34, make_sandwich(_, _, _), 0.0899587337671066) :- todo_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(34, make_sandwich(_, _, _), -0.0013693203340251847) :- todo_served(Child), allergic_gluten(Child), !.
delta(34, make_sandwich(_, _, _), 0.0025693922279968707) :- done_served(Child), not_allergic_gluten(Child), !.
delta(34, make_sandwich(_, _, _), -0.011844186051137639) :- !.
delta(34, put_on_tray(_, _), 0.0034992222560750966) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(34, put_on_tray(_, _), 0.00016983333844022508) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(34, put_on_tray(_, _), -0.060582856688969594) :- goal_served(Child), allergic_gluten(Child), !.
delta(34, put_on_tray(_, _), 0.013802828399384522) :- !.
delta(34, serve_sandwich_no_gluten(_, _, _, _), 1.2343216138383909e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(34, serve_sandwich_no_gluten(_, _, _, _), 0.006658588591177991) :- !.
delta(34, serve_sandwich(Sandwich, _, _, _), 0.002210916882189354) :- no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served, at_kitchen_sandwich(_), !.
delta(34, serve_sandwich(Sandwich, _, _, _), 3.47831847934348e-5) :- no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served, !.
delta(34, serve_sandwich(Sandwich, _, _, _), -0.3155883890756584) :- no_gluten_sandwich(Sandwich), !.
delta(34, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_2_than_allergic_gluten, !.
delta(34, serve_sandwich(_, Child, _, _), 0.44599582652407366) :- no_gluten_sandwich(_), todo_served(Child), !.
delta(34, serve_sandwich(_, _, _, _), -0.001589543697769791) :- no_gluten_sandwich(_), !.
delta(34, serve_sandwich(_, _, _, _), -0.02920677283236452) :- at_kitchen_bread(_), !.
delta(34, serve_sandwich(_, _, _, _), 0.0878783895980099) :- !.
delta(34, move_tray(_, Place, Place2), 0.029815358436489317) :- done_served(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(34, move_tray(_, _, Place), -0.007269948698488001) :- done_served(Child), waiting(Child, Place), !.
delta(34, move_tray(Tray, _, Place), -0.027665938666210355) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_serve_sandwich_no_gluten(Tray2, Place), fewer_ontray_1_than_todo_served, !.
delta(34, move_tray(Tray, _, Place), 0.007310855107919157) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_serve_sandwich_no_gluten(Tray2, Place), !.
delta(34, move_tray(Tray, Place, _), -0.004557837876480675) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), waiting(Child, Place), !.
delta(34, move_tray(Tray, _, _), 0.0330442921949403) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(34, move_tray(_, Place, Place2), 0.007950087712691225) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(34, move_tray(_, _, _), -0.007916852032760014) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(34, move_tray(_, _, _), -0.00034703783009168725) :- fewer_at_1_than_allergic_gluten, !.
delta(34, move_tray(_, _, _), -0.2609972569350439) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 215 examples, 41 leaves
delta(35, make_sandwich_no_gluten(_, _, _), 6.857937056741335e-18) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(35, make_sandwich_no_gluten(_, _, _), 0.001862139949753827) :- fewer_at_1_than_allergic_gluten, !.
delta(35, make_sandwich_no_gluten(_, _, _), -0.32806502331275855) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(35, make_sandwich_no_gluten(_, _, _), 0.00519807527205281) :- !.
delta(35, make_sandwich(_, _, _), 0.36282314552165634) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), fewer_at_1_than_not_allergic_gluten, !.
delta(35, make_sandwich(_, _, _), -0.004086584642585129) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(35, make_sandwich(_, _, _), 0.00016527300192045735) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(35, make_sandwich(_, _, _), -0.04267335754401298) :- goal_served(Child), allergic_gluten(Child), !.
delta(35, make_sandwich(_, _, _), 0.027751313665909688) :- at_kitchen_sandwich(_), !.
delta(35, make_sandwich(_, _, _), -0.020287068762158647) :- !.
delta(35, put_on_tray(_, _), 0.024400772389646885) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(35, put_on_tray(_, _), -0.008326786639744614) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(35, put_on_tray(_, Tray), 2.7790577416118906e-5) :- ontray(_, Tray), todo_served(Child), allergic_gluten(Child), !.
delta(35, put_on_tray(_, Tray), -0.03401498416883178) :- ontray(_, Tray), !.
delta(35, put_on_tray(_, _), -0.0004263041199407858) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(35, put_on_tray(_, _), 0.004473790361580804) :- !.
delta(35, serve_sandwich_no_gluten(_, _, _, _), 0.005599303807799226) :- !.
delta(35, serve_sandwich(_, _, _, _), 0.1174475052809166) :- at_kitchen_sandwich(_), notexist(_), !.
delta(35, serve_sandwich(_, _, _, _), -0.051431886796278296) :- at_kitchen_sandwich(_), !.
delta(35, serve_sandwich(_, Child, _, _), 0.001151231868977551) :- goal_served(Child2), done_served(Child2), todo_served(Child), notexist(_), !.
delta(35, serve_sandwich(_, Child, _, _), 0.009670202906534106) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(35, serve_sandwich(_, _, _, _), -0.0019270257525471656) :- goal_served(Child), done_served(Child), !.
delta(35, serve_sandwich(_, _, _, _), -0.002027281391191095) :- at_kitchen_bread(_), !.
delta(35, serve_sandwich(_, _, _, _), -0.2508946583474105) :- fewer_ontray_2_than_todo_served, !.
delta(35, serve_sandwich(_, _, _, _), 0.0001751330366206405) :- !.
delta(35, move_tray(Tray, Place, _), -0.12965830264778977) :- at_kitchen_sandwich(_), notexist(_), could_serve_sandwich(Tray, Place), !.
delta(35, move_tray(_, _, kitchen), 0.03186032650305532) :- at_kitchen_sandwich(_), notexist(_), !.
delta(35, move_tray(_, _, _), -0.008088851552635166) :- at_kitchen_sandwich(_), notexist(_), !.
delta(35, move_tray(Tray, Place, _), -0.0011827047418240394) :- at_kitchen_sandwich(_), ontray(_, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(35, move_tray(Tray, _, _), 0.06374332314543184) :- at_kitchen_sandwich(_), ontray(_, Tray), !.
delta(35, move_tray(_, Place, Place2), 0.01033403395931083) :- at_kitchen_sandwich(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(35, move_tray(_, _, _), -0.01597739835247211) :- at_kitchen_sandwich(_), !.
delta(35, move_tray(Tray, _, Place), 0.002252573223385582) :- notexist(_), at(Tray, kitchen), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(35, move_tray(Tray, _, _), -0.0055521044307444735) :- notexist(_), at(Tray, kitchen), !.
delta(35, move_tray(_, _, _), 0.2835573221527637) :- notexist(_), fewer_at_1_than_todo_served, !.
delta(35, move_tray(_, _, _), -0.0003943128687873562) :- notexist(_), !.
delta(35, move_tray(_, _, Place), 0.007790281363294447) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(35, move_tray(_, _, Place), -0.0005121132619063928) :- done_served(Child), waiting(Child, Place), !.
delta(35, move_tray(_, _, Place), 0.004214270287714093) :- at(_, Place), !.
delta(35, move_tray(_, _, _), -0.024340203006012365) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 237 examples, 40 leaves
delta(36, make_sandwich_no_gluten(_, _, _), -3.328696886340885e-18) :- fewer_at_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(36, make_sandwich_no_gluten(_, _, _), 0.0018205435039098663) :- fewer_at_1_than_not_allergic_gluten, !.
delta(36, make_sandwich_no_gluten(_, _, _), 0.007675216256166308) :- !.
delta(36, make_sandwich(_, Bread_portion, _), -0.0008212058136597432) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), fewer_ontray_1_than_allergic_gluten, !.
delta(36, make_sandwich(_, Bread_portion, _), 0.017323321770940245) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), !.
delta(36, make_sandwich(_, _, _), 0.0) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_allergic_gluten, !.
delta(36, make_sandwich(_, _, _), -0.027164359461037926) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(36, make_sandwich(_, _, _), -0.0050910577437496335) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(36, make_sandwich(_, _, _), 0.027894443248680203) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(36, make_sandwich(_, _, _), -0.0007576269262772667) :- !.
delta(36, put_on_tray(_, Tray), 0.0) :- ontray(_, Tray), fewer_ontray_2_than_allergic_gluten, !.
delta(36, put_on_tray(_, Tray), 0.03152850828858282) :- ontray(_, Tray), !.
delta(36, put_on_tray(_, _), 8.554015103590653e-6) :- fewer_no_gluten_sandwich_than_todo_served, goal_served(Child), done_served(Child), !.
delta(36, put_on_tray(_, _), -0.042160048378650145) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(36, put_on_tray(Sandwich, _), 0.008233384756400732) :- no_gluten_sandwich(Sandwich), !.
delta(36, put_on_tray(_, _), -0.00677848632248695) :- !.
delta(36, serve_sandwich_no_gluten(_, _, _, _), 2.3316871118209198e-6) :- fewer_at_1_than_allergic_gluten, !.
delta(36, serve_sandwich_no_gluten(_, _, _, _), 0.002809352022726547) :- !.
delta(36, serve_sandwich(Sandwich, _, _, _), -0.26816714190266994) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(36, serve_sandwich(Sandwich, _, _, _), 0.002496386321401388) :- no_gluten_sandwich(Sandwich), !.
delta(36, serve_sandwich(_, _, _, _), 0.0801102296794225) :- at_kitchen_sandwich(_), !.
delta(36, serve_sandwich(_, _, _, _), 0.06231129219757835) :- notexist(_), todo_served(Child), allergic_gluten(Child), !.
delta(36, serve_sandwich(_, _, _, _), 0.003347713730036031) :- notexist(_), !.
delta(36, serve_sandwich(_, _, _, _), -0.04366055532481399) :- goal_served(Child), done_served(Child), !.
delta(36, serve_sandwich(_, _, _, _), 0.003348138176853761) :- !.
delta(36, move_tray(Tray, Place, kitchen), -0.0014201611792627057) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), not_allergic_gluten(Child), waiting(Child, Place), !.
delta(36, move_tray(Tray, Place, _), 0.22718285406878566) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(36, move_tray(Tray, Place, _), -0.00031444514053267274) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), not_allergic_gluten(Child), waiting(Child, Place), !.
delta(36, move_tray(Tray, _, Place), 0.002969349196808572) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), done_served(Child), not_allergic_gluten(Child), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(36, move_tray(Tray, _, _), -0.00028277850362400624) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), done_served(Child), not_allergic_gluten(Child), !.
delta(36, move_tray(Tray, _, _), -0.013354102519963607) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(36, move_tray(_, Place, Place2), -0.02694310434309905) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), notexist(_), !.
delta(36, move_tray(_, Place, Place2), 0.037262464867354926) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(36, move_tray(_, _, _), 0.0013903317791617137) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at_kitchen_bread(_), !.
delta(36, move_tray(_, _, _), -0.10698615358418939) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(36, move_tray(Tray, _, Place), 0.0654496546233195) :- could_serve_sandwich(Tray, Place), goal_served(Child), done_served(Child), !.
delta(36, move_tray(Tray, _, Place), -0.0038027165824640915) :- could_serve_sandwich(Tray, Place), !.
delta(36, move_tray(_, Place, _), -0.03305093693458042) :- goal_served(Child), waiting(Child, Place), !.
delta(36, move_tray(_, _, _), 0.011924206449606976) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 201 examples, 39 leaves
delta(37, make_sandwich_no_gluten(_, _, _), 0.003976514346681209) :- fewer_at_2_than_allergic_gluten, !.
delta(37, make_sandwich_no_gluten(_, _, _), 0.003931453516993152) :- at_kitchen_sandwich(_), !.
delta(37, make_sandwich_no_gluten(_, _, _), -0.0436051878629711) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(37, make_sandwich_no_gluten(_, _, _), 0.00029947762570556454) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(37, make_sandwich_no_gluten(_, _, _), 0.001758337224337741) :- !.
delta(37, make_sandwich(_, _, _), -0.006783972386961726) :- fewer_at_1_than_todo_served, fewer_at_2_than_allergic_gluten, !.
delta(37, make_sandwich(_, _, _), -0.002441733504831897) :- fewer_at_1_than_todo_served, at_kitchen_sandwich(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(37, make_sandwich(_, _, _), 0.002146549121371071) :- fewer_at_1_than_todo_served, at_kitchen_sandwich(_), !.
delta(37, make_sandwich(_, _, Content_portion), -0.0005859474962667946) :- fewer_at_1_than_todo_served, no_gluten_content(Content_portion), !.
delta(37, make_sandwich(_, _, _), 0.054761645502879853) :- fewer_at_1_than_todo_served, !.
delta(37, make_sandwich(_, _, _), 0.0007249910315235944) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(37, make_sandwich(_, _, _), -0.01302963701398924) :- !.
delta(37, put_on_tray(_, Tray), 0.02362497635997391) :- ontray(_, Tray), !.
delta(37, put_on_tray(_, _), -0.007124526128004276) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(37, put_on_tray(_, _), -0.0007073428654847558) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(37, put_on_tray(_, _), 0.006326898852784254) :- !.
delta(37, serve_sandwich_no_gluten(_, Child, _, _), 0.006111988378492639) :- todo_served(Child), !.
delta(37, serve_sandwich_no_gluten(_, _, _, _), -0.04358015905920606) :- !.
delta(37, serve_sandwich(_, Child, _, _), 0.0) :- todo_served(Child), at_kitchen_sandwich(_), done_served(Child2), not_allergic_gluten(Child2), !.
delta(37, serve_sandwich(_, Child, Tray, _), 0.0028978338131953807) :- todo_served(Child), at_kitchen_sandwich(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(37, serve_sandwich(_, Child, _, _), -0.06758850328557885) :- todo_served(Child), at_kitchen_sandwich(_), !.
delta(37, serve_sandwich(_, Child, _, _), 0.017576969247872318) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(37, serve_sandwich(_, Child, _, _), -0.00576212966613424) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(37, serve_sandwich(_, Child, _, _), 0.0015923422844858015) :- todo_served(Child), !.
delta(37, serve_sandwich(_, _, _, _), -0.19077910198980552) :- !.
delta(37, move_tray(_, Place, Place2), -0.020571911667559437) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), done_served(Child), allergic_gluten(Child), waiting(Child, Place), !.
delta(37, move_tray(_, Place, Place2), 0.0577982185262338) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), done_served(Child), allergic_gluten(Child), !.
delta(37, move_tray(_, Place, Place2), 0.010626814846770255) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place2), !.
delta(37, move_tray(_, Place, Place2), -0.05533953381391435) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), fewer_ontray_2_than_todo_served, !.
delta(37, move_tray(_, Place, Place2), 3.8871614840095673e-5) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(37, move_tray(Tray, _, Place), 0.0069253230670116624) :- ontray(_, Tray), at(Tray, kitchen), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(37, move_tray(Tray, _, _), -0.013769866272287929) :- ontray(_, Tray), at(Tray, kitchen), !.
delta(37, move_tray(Tray, _, _), -0.004328626898291695) :- ontray(_, Tray), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(37, move_tray(Tray, _, _), 0.25841803514399) :- ontray(_, Tray), !.
delta(37, move_tray(_, Place, Place2), 0.011803500646601076) :- needed_at_to_serve_sandwich_no_gluten(Place2), done_served(Child), waiting(Child, Place), !.
delta(37, move_tray(_, _, Place), -0.009768652822596202) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(37, move_tray(_, _, _), 0.0038822683467868483) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(37, move_tray(_, _, _), -0.022366358641702274) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 211 examples, 34 leaves
delta(38, make_sandwich_no_gluten(_, _, _), 0.0019289730943006073) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(38, make_sandwich_no_gluten(_, _, _), -0.01710081498065326) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(38, make_sandwich_no_gluten(_, _, _), 0.008291492522068115) :- !.
delta(38, make_sandwich(_, Bread_portion, _), -0.000387908974906655) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, fewer_ontray_1_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(38, make_sandwich(_, _, _), 0.0) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, fewer_ontray_1_than_allergic_gluten, !.
delta(38, make_sandwich(_, _, _), 0.0020993123957013583) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(38, make_sandwich(_, _, _), -0.0004019772914103511) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(38, make_sandwich(_, _, _), 0.00032617531556968166) :- goal_served(Child), done_served(Child), !.
delta(38, make_sandwich(_, _, _), -0.01493827867558699) :- !.
delta(38, put_on_tray(Sandwich, _), 0.007238265388820083) :- fewer_at_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(38, put_on_tray(_, _), -0.014792381690075655) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(38, put_on_tray(_, _), 0.05428162795213066) :- !.
delta(38, serve_sandwich_no_gluten(_, _, _, _), -0.03792597817569697) :- fewer_ontray_1_than_todo_served, !.
delta(38, serve_sandwich_no_gluten(_, _, _, _), 0.0020140330639516284) :- !.
delta(38, serve_sandwich(_, _, _, _), 3.188219821919751e-5) :- goal_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(38, serve_sandwich(_, _, _, _), -0.23997413188571767) :- goal_served(Child), allergic_gluten(Child), fewer_at_1_than_todo_served, !.
delta(38, serve_sandwich(_, _, _, _), 0.0002384083190623398) :- goal_served(Child), allergic_gluten(Child), !.
delta(38, serve_sandwich(_, _, _, _), 0.1290175482932844) :- at_kitchen_sandwich(_), !.
delta(38, serve_sandwich(_, _, _, _), -0.010547980393724064) :- at_kitchen_bread(_), !.
delta(38, serve_sandwich(_, Child, _, _), 0.014833092816282225) :- todo_served(Child), !.
delta(38, serve_sandwich(_, _, _, _), -0.0011360902497485616) :- !.
delta(38, move_tray(_, _, _), 0.26696106248234996) :- goal_served(Child), allergic_gluten(Child), notexist(_), fewer_ontray_2_than_todo_served, !.
delta(38, move_tray(Tray, _, Place), 0.0004512802533385132) :- goal_served(Child), allergic_gluten(Child), notexist(_), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(38, move_tray(_, _, _), -0.0006127383119840814) :- goal_served(Child), allergic_gluten(Child), notexist(_), !.
delta(38, move_tray(Tray, _, Place), -0.005976375430441638) :- goal_served(Child), allergic_gluten(Child), ontray(_, Tray), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(38, move_tray(Tray, _, _), 0.008344275923988958) :- goal_served(Child), allergic_gluten(Child), ontray(_, Tray), !.
delta(38, move_tray(_, _, _), -0.011796997413369432) :- goal_served(Child), allergic_gluten(Child), !.
delta(38, move_tray(_, Place, _), 0.012239177203327786) :- at_kitchen_bread(_), todo_served(Child), waiting(Child, Place), !.
delta(38, move_tray(_, _, _), -0.002936727105100191) :- at_kitchen_bread(_), !.
delta(38, move_tray(_, Place, _), 0.0) :- todo_served(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(38, move_tray(_, Place, _), -0.14751686046924314) :- todo_served(Child), waiting(Child, Place), !.
delta(38, move_tray(_, Place, Place2), 0.00342852602101981) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(38, move_tray(_, _, _), -0.002436886951070113) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 201 examples, 32 leaves
delta(39, make_sandwich_no_gluten(_, _, _), 0.015287768924432602) :- !.
delta(39, make_sandwich(_, Bread_portion, _), -0.00041943099107213754) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_at_1_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(39, make_sandwich(_, _, _), 0.0) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_at_1_than_allergic_gluten, !.
delta(39, make_sandwich(_, _, Content_portion), -0.0001979246978238188) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_content(Content_portion), !.
delta(39, make_sandwich(_, _, _), 0.04028094369061245) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(39, make_sandwich(_, _, _), -5.17203376748166e-5) :- goal_served(Child), done_served(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(39, make_sandwich(_, _, _), 0.00013384004375573531) :- goal_served(Child), done_served(Child), !.
delta(39, make_sandwich(_, _, _), -0.024912794482377588) :- !.
delta(39, put_on_tray(_, _), -0.0027774728744711413) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(39, put_on_tray(_, _), 0.013746208492044481) :- !.
delta(39, serve_sandwich_no_gluten(_, Child, _, _), 0.011934277342284246) :- todo_served(Child), !.
delta(39, serve_sandwich_no_gluten(_, _, _, _), -0.00792158963829221) :- !.
delta(39, serve_sandwich(Sandwich, _, _, _), 0.002632178560030389) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(39, serve_sandwich(Sandwich, _, _, _), -0.24722105816958298) :- no_gluten_sandwich(Sandwich), !.
delta(39, serve_sandwich(_, _, _, _), -0.2295814867991228) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(39, serve_sandwich(_, _, _, Place), 0.006020771466381533) :- done_served(Child), waiting(Child, Place), notexist(_), !.
delta(39, serve_sandwich(_, _, _, Place), -0.0029206071106667483) :- done_served(Child), waiting(Child, Place), !.
delta(39, serve_sandwich(_, _, _, _), -0.0024647089360401633) :- todo_served(Child), allergic_gluten(Child), !.
delta(39, serve_sandwich(_, _, _, _), 0.23683700655480866) :- !.
delta(39, move_tray(Tray, _, Place), 0.013609007497756398) :- notexist(_), done_served(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(39, move_tray(_, _, Place), -0.003687729908261811) :- notexist(_), done_served(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(39, move_tray(_, _, Place), 7.310289319948132e-5) :- notexist(_), done_served(Child), waiting(Child, Place), !.
delta(39, move_tray(_, _, _), -0.08829511864755758) :- notexist(_), !.
delta(39, move_tray(_, Place, _), 0.23127714810898137) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, todo_served(Child), waiting(Child, Place), !.
delta(39, move_tray(_, _, _), -0.0001058899087666178) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(39, move_tray(_, Place, Place2), 0.0003253986449384565) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(39, move_tray(_, _, _), -0.0029090709919875925) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(39, move_tray(_, Place, Place2), 0.008367858282014294) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(39, move_tray(_, Place, Place2), -0.0015009620493574192) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(39, move_tray(_, _, _), -0.018373797044885568) :- fewer_ontray_2_than_todo_served, !.
delta(39, move_tray(_, _, _), 0.0002634582724274083) :- !.
delta(39, _, 0.0).

% tree 40: step size 1.0, 210 examples, 32 leaves
delta(40, make_sandwich_no_gluten(_, _, _), 0.004827634521414338) :- fewer_at_2_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(40, make_sandwich_no_gluten(_, _, _), -9.11028841617721e-19) :- fewer_at_2_than_allergic_gluten, !.
delta(40, make_sandwich_no_gluten(_, _, _), -0.029636374035617828) :- fewer_at_1_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(40, make_sandwich_no_gluten(_, _, _), 0.001088190515926921) :- fewer_at_1_than_todo_served, !.
delta(40, make_sandwich_no_gluten(_, _, _), 0.0020457508337962086) :- !.
delta(40, make_sandwich(_, _, _), 1.4281727840935064e-5) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(_), goal_served(Child), done_served(Child), !.
delta(40, make_sandwich(_, _, _), -0.005511158133936977) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(40, make_sandwich(_, _, _), 0.029636374035617825) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(40, make_sandwich(_, _, _), -0.0013339363651246193) :- fewer_ontray_1_than_allergic_gluten, !.
delta(40, make_sandwich(_, _, _), -0.04716533848080726) :- fewer_at_1_than_todo_served, !.
delta(40, make_sandwich(_, _, _), 0.0024189326674176562) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(40, make_sandwich(_, _, _), -0.0006561058086806526) :- !.
delta(40, put_on_tray(_, _), 0.01836510693161155) :- !.
delta(40, serve_sandwich_no_gluten(_, _, _, _), 0.001634110834188409) :- !.
delta(40, serve_sandwich(_, Child, _, _), 0.03209516039010494) :- todo_served(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(40, serve_sandwich(_, Child, _, Place), -0.0013203381204968678) :- todo_served(Child), allergic_gluten(Child2), waiting(Child2, Place), todo_served(Child2), !.
delta(40, serve_sandwich(_, Child, _, Place), 2.8430386074065276e-5) :- todo_served(Child), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(40, serve_sandwich(_, Child, _, _), 0.0067181802019463275) :- todo_served(Child), !.
delta(40, serve_sandwich(_, _, _, _), -0.01036385385061859) :- !.
delta(40, move_tray(Tray, Place, Place2), -0.011473556412193522) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), fewer_at_1_than_allergic_gluten, ontray(_, Tray), !.
delta(40, move_tray(_, Place, Place2), 0.0001339327344058278) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_allergic_gluten, !.
delta(40, move_tray(_, Place, Place2), -0.0030461771346072856) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(40, move_tray(_, Place, Place2), 0.0419389183930661) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(40, move_tray(_, Place, Place2), -0.001240627716192576) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(40, move_tray(Tray, _, Place), -0.009772549750804018) :- could_serve_sandwich(Tray, Place), goal_served(Child), done_served(Child), waiting(Child, Place2), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(40, move_tray(Tray, _, Place), 0.05656805496709007) :- could_serve_sandwich(Tray, Place), goal_served(Child), done_served(Child), !.
delta(40, move_tray(Tray, _, Place), 0.0022437331953334945) :- could_serve_sandwich(Tray, Place), at(_, Place), !.
delta(40, move_tray(Tray, _, Place), -0.03419103984529904) :- could_serve_sandwich(Tray, Place), !.
delta(40, move_tray(Tray, _, Place), -0.0009053889286440144) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(40, move_tray(Tray, _, Place), 0.0025822280489339296) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(40, move_tray(_, _, _), -0.05601956950221348) :- !.
delta(40, _, 0.0).

% tree 41: step size 1.0, 223 examples, 44 leaves
delta(41, make_sandwich_no_gluten(_, _, _), -0.18601258696002496) :- fewer_at_2_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(41, make_sandwich_no_gluten(_, _, _), 0.0014579163000072758) :- fewer_at_2_than_allergic_gluten, !.
delta(41, make_sandwich_no_gluten(_, _, _), 0.01714708632678634) :- !.
delta(41, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(41, make_sandwich(_, _, _), -0.0008305663586521016) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(41, make_sandwich(_, _, _), 0.2216692386032681) :- fewer_at_2_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(41, make_sandwich(_, _, _), -0.0006315117202919326) :- fewer_at_2_than_allergic_gluten, !.
delta(41, make_sandwich(_, _, _), 0.007306677393183654) :- goal_served(Child), done_served(Child), !.
delta(41, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(41, make_sandwich(_, _, _), -0.10041023175878008) :- fewer_at_1_than_todo_served, !.
delta(41, make_sandwich(_, _, _), 0.005246214328702044) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(41, make_sandwich(_, _, _), -0.0014695905439099629) :- !.
delta(41, put_on_tray(_, Tray), 0.036186526752715525) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(41, put_on_tray(_, Tray), -0.00041137798122467366) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(41, put_on_tray(Sandwich, _), 0.001545056956259973) :- no_gluten_sandwich(Sandwich), !.
delta(41, put_on_tray(_, _), -0.3582198341751568) :- fewer_at_2_than_todo_served, !.
delta(41, put_on_tray(_, _), 1.0646153230078695e-5) :- !.
delta(41, serve_sandwich_no_gluten(_, _, _, _), 4.7573204295719756e-6) :- fewer_ontray_1_than_allergic_gluten, !.
delta(41, serve_sandwich_no_gluten(_, _, _, _), 0.008460948399879405) :- !.
delta(41, serve_sandwich(Sandwich, _, _, _), -0.008920695504045183) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(41, serve_sandwich(Sandwich, _, _, _), 0.08039913078792428) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(41, serve_sandwich(Sandwich, _, _, _), -1.7057526042602287e-6) :- no_gluten_sandwich(Sandwich), !.
delta(41, serve_sandwich(_, Child, _, Place), 0.003381440697671905) :- no_gluten_sandwich(_), done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(41, serve_sandwich(_, _, _, Place), -0.0062913776160437055) :- no_gluten_sandwich(_), done_served(Child), waiting(Child, Place), !.
delta(41, serve_sandwich(_, _, _, _), -0.08366555811925842) :- no_gluten_sandwich(_), fewer_ontray_2_than_todo_served, !.
delta(41, serve_sandwich(_, _, _, _), 0.00015967214790814173) :- no_gluten_sandwich(_), !.
delta(41, serve_sandwich(_, _, _, _), -0.00538696167612028) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(41, serve_sandwich(_, Child, _, _), 0.06173712566356542) :- todo_served(Child), !.
delta(41, serve_sandwich(_, _, _, _), -0.0030157356541648684) :- !.
delta(41, move_tray(Tray, _, Place), 0.008485223303185005) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_allergic_gluten, could_serve_sandwich(Tray, Place), !.
delta(41, move_tray(_, _, Place), -0.0012648879920865669) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_allergic_gluten, !.
delta(41, move_tray(_, _, Place), -0.024646520178674393) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(41, move_tray(_, _, Place), 0.0004929251607235653) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(41, move_tray(Tray, _, _), -0.003238799631612411) :- notexist(_), ontray(_, Tray), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(41, move_tray(Tray, _, _), 0.42188303826497464) :- notexist(_), ontray(_, Tray), !.
delta(41, move_tray(_, _, Place), 0.010770117013690251) :- notexist(_), done_served(Child), waiting(Child, Place), !.
delta(41, move_tray(_, _, _), -0.023406875276461694) :- notexist(_), !.
delta(41, move_tray(_, Place, Place2), 0.00938090042041918) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(41, move_tray(_, Place, Place2), 0.0008067799819417993) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(41, move_tray(_, Place, Place2), -0.003514228765513452) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(41, move_tray(_, _, Place), 0.0013062472192832905) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), waiting(Child2, Place), !.
delta(41, move_tray(_, _, _), -0.00019520390419297228) :- done_served(Child), allergic_gluten(Child), !.
delta(41, move_tray(_, _, _), -0.053494063940218696) :- !.
delta(41, _, 0.0).

% tree 42: step size 1.0, 202 examples, 41 leaves
delta(42, make_sandwich_no_gluten(_, _, _), 0.0060938919808681945) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(42, make_sandwich_no_gluten(_, _, _), 0.00014997531536818228) :- fewer_at_2_than_allergic_gluten, !.
delta(42, make_sandwich_no_gluten(_, _, _), -0.32590907829125093) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(42, make_sandwich_no_gluten(_, _, _), 0.00027395248642651744) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(42, make_sandwich_no_gluten(_, _, _), 0.002314843250778868) :- !.
delta(42, make_sandwich(_, _, Content_portion), -0.038656511796339554) :- no_gluten_content(Content_portion), !.
delta(42, make_sandwich(_, _, _), -0.00467750876669793) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(42, make_sandwich(_, Bread_portion, _), -0.0025646041654949154) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(42, make_sandwich(_, _, _), 0.44083716495808484) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(42, make_sandwich(_, _, _), 0.0) :- fewer_ontray_1_than_todo_served, fewer_at_2_than_allergic_gluten, !.
delta(42, make_sandwich(_, _, _), 0.0065553388206497825) :- fewer_ontray_1_than_todo_served, !.
delta(42, make_sandwich(_, _, _), -0.013411622938404524) :- !.
delta(42, put_on_tray(_, _), 0.0) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(42, put_on_tray(_, _), 0.016360069129474658) :- fewer_ontray_1_than_todo_served, !.
delta(42, put_on_tray(_, _), -0.009675186687512338) :- !.
delta(42, serve_sandwich_no_gluten(_, _, _, Place), 0.0016932945943733144) :- done_served(Child), waiting(Child, Place), !.
delta(42, serve_sandwich_no_gluten(Sandwich, _, _, Place), -0.04783392252488092) :- notexist(_), ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(42, serve_sandwich_no_gluten(_, _, _, _), 0.00020089415635368325) :- notexist(_), !.
delta(42, serve_sandwich_no_gluten(_, _, _, _), 0.0006181896936002804) :- !.
delta(42, serve_sandwich(Sandwich, _, _, _), -0.048974796195178) :- goal_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(42, serve_sandwich(_, _, _, _), 0.0) :- goal_served(Child), allergic_gluten(Child), at_kitchen_bread(_), todo_served(Child), !.
delta(42, serve_sandwich(_, _, _, _), -0.013802860440160635) :- goal_served(Child), allergic_gluten(Child), at_kitchen_bread(_), !.
delta(42, serve_sandwich(_, _, _, _), 5.516224609881145e-6) :- goal_served(Child), allergic_gluten(Child), fewer_at_2_than_allergic_gluten, !.
delta(42, serve_sandwich(_, _, _, _), 0.09358827381976847) :- goal_served(Child), allergic_gluten(Child), !.
delta(42, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_bread(_), !.
delta(42, serve_sandwich(_, _, _, Place), -8.307796156880753e-5) :- fewer_ontray_1_than_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(42, serve_sandwich(_, _, _, _), -0.5319420465733007) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(42, serve_sandwich(_, _, _, _), 0.001671377749709065) :- !.
delta(42, move_tray(_, _, _), -0.10129888051476683) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(42, move_tray(_, _, Place), 0.027165386305932293) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place), goal_served(Child), done_served(Child), !.
delta(42, move_tray(_, _, Place), -0.0007921263176654412) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(42, move_tray(_, _, _), 0.0003076777643215162) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(42, move_tray(_, _, _), -0.003931084600464217) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(42, move_tray(Tray, _, Place), -0.01892643789754347) :- at(Tray, Place2), could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place), !.
delta(42, move_tray(Tray, _, _), 0.6265502577095577) :- at(Tray, Place), could_serve_sandwich(Tray, Place), fewer_at_1_than_todo_served, !.
delta(42, move_tray(Tray, _, _), -0.0005127168497250905) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(42, move_tray(Tray, _, Place), -0.0005720770154484718) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(42, move_tray(Tray, _, Place), 0.044269976640666446) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(42, move_tray(_, _, Place), 0.013075536221689192) :- done_served(Child), waiting(Child, Place), !.
delta(42, move_tray(_, _, _), -0.04698175999675643) :- !.
delta(42, _, 0.0).

% tree 43: step size 1.0, 257 examples, 29 leaves
delta(43, make_sandwich_no_gluten(_, _, _), 0.010092602738159172) :- fewer_at_2_than_allergic_gluten, !.
delta(43, make_sandwich_no_gluten(_, _, _), 0.0031378434604526885) :- at_kitchen_sandwich(_), !.
delta(43, make_sandwich_no_gluten(_, _, _), -0.015811475207076753) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(43, make_sandwich_no_gluten(_, _, _), 0.00037828643750220377) :- fewer_ontray_1_than_allergic_gluten, !.
delta(43, make_sandwich_no_gluten(_, _, _), 0.0009854655899086177) :- !.
delta(43, make_sandwich(_, _, _), -0.011776144384507971) :- fewer_at_2_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(43, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, !.
delta(43, make_sandwich(_, _, _), -0.0011882041206859317) :- fewer_ontray_1_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(43, make_sandwich(_, Bread_portion, _), -0.0009667805341199641) :- fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(43, make_sandwich(_, _, _), 0.03908501498220631) :- fewer_ontray_1_than_todo_served, !.
delta(43, make_sandwich(_, _, _), -0.0039320448112713765) :- !.
delta(43, put_on_tray(Sandwich, _), -0.0033440262951276094) :- no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(43, put_on_tray(Sandwich, _), 0.010817814434728) :- no_gluten_sandwich(Sandwich), !.
delta(43, put_on_tray(_, _), -0.02035045691145303) :- goal_served(Child), allergic_gluten(Child), !.
delta(43, put_on_tray(_, _), 0.0007008177040978868) :- !.
delta(43, serve_sandwich_no_gluten(_, _, _, _), 2.5166653423441808e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(43, serve_sandwich_no_gluten(_, _, _, _), 0.007597858039299689) :- !.
delta(43, serve_sandwich(_, _, _, _), -1.5216391161298303e-5) :- at_kitchen_bread(_), !.
delta(43, serve_sandwich(Sandwich, Child, _, Place), -0.0031399417970686245) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(43, serve_sandwich(_, Child, _, _), 0.08075416905955629) :- todo_served(Child), !.
delta(43, serve_sandwich(_, _, _, _), -0.003934087293512733) :- !.
delta(43, move_tray(_, Place, Place2), 0.003549243594554787) :- at(Tray, Place2), could_serve_sandwich_no_gluten(Tray, Place), at_kitchen_sandwich(_), !.
delta(43, move_tray(_, Place, Place2), -1.2839211979822356e-5) :- at(Tray, Place2), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(43, move_tray(_, _, _), -0.16068148836469312) :- fewer_ontray_2_than_todo_served, !.
delta(43, move_tray(_, _, Place), -0.002582281088222635) :- todo_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(43, move_tray(_, _, Place), 0.008659691199210095) :- todo_served(Child), waiting(Child, Place), !.
delta(43, move_tray(_, _, _), 0.0004963673266570556) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(43, move_tray(_, _, _), -0.005696218237608027) :- !.
delta(43, _, 0.0).

% tree 44: step size 1.0, 218 examples, 34 leaves
delta(44, make_sandwich_no_gluten(_, _, _), 0.001063676297011451) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(44, make_sandwich_no_gluten(_, _, _), 0.0) :- fewer_at_1_than_allergic_gluten, !.
delta(44, make_sandwich_no_gluten(_, _, _), 0.027698610208783066) :- !.
delta(44, make_sandwich(_, _, _), -0.0009481698330360523) :- no_gluten_sandwich(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(44, make_sandwich(_, _, _), 0.035860169368890436) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(44, make_sandwich(_, _, _), -0.00031490975093461445) :- no_gluten_sandwich(_), !.
delta(44, make_sandwich(_, _, _), -0.09785894808921759) :- !.
delta(44, put_on_tray(_, _), 0.02750263271619821) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(44, put_on_tray(Sandwich, _), 0.0014041077211172882) :- no_gluten_sandwich(Sandwich), !.
delta(44, put_on_tray(_, _), -0.0031290837024724855) :- !.
delta(44, serve_sandwich_no_gluten(_, Child, _, _), 0.01585069444073624) :- todo_served(Child), !.
delta(44, serve_sandwich_no_gluten(_, _, _, _), -0.015457244892017033) :- !.
delta(44, serve_sandwich(_, _, _, _), -0.09393922495311799) :- done_served(Child), allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(44, serve_sandwich(_, Child, _, _), 0.003704799460047031) :- done_served(Child2), allergic_gluten(Child2), todo_served(Child), !.
delta(44, serve_sandwich(_, _, _, _), -0.00041459347912155194) :- done_served(Child), allergic_gluten(Child), !.
delta(44, serve_sandwich(_, _, _, _), 0.2396563500725503) :- at_kitchen_sandwich(_), !.
delta(44, serve_sandwich(Sandwich, _, _, _), -0.036252713093875864) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(44, serve_sandwich(Sandwich, _, _, _), 0.00035653177038095325) :- no_gluten_sandwich(Sandwich), !.
delta(44, serve_sandwich(_, _, _, _), 0.06100871213711135) :- notexist(_), !.
delta(44, serve_sandwich(_, _, _, _), 0.006335444529730536) :- !.
delta(44, move_tray(Tray, kitchen, _), 0.0) :- done_served(Child), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(44, move_tray(Tray, _, _), 0.09244830280549902) :- done_served(Child), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(44, move_tray(Tray, _, Place), 6.257662630337601e-5) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), waiting(Child2, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(44, move_tray(_, _, Place), -0.06231721884281148) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), waiting(Child2, Place), !.
delta(44, move_tray(_, _, _), 0.06054780669587568) :- done_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(44, move_tray(_, _, _), -0.023122164010824946) :- done_served(Child), allergic_gluten(Child), !.
delta(44, move_tray(_, Place, _), -0.3114388055730305) :- at(Tray, Place), ontray(_, Tray), fewer_ontray_2_than_todo_served, !.
delta(44, move_tray(_, Place, Place2), 0.007801402977035973) :- at(Tray, Place), ontray(_, Tray), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(44, move_tray(_, Place, _), -0.006008175599423864) :- at(Tray, Place), ontray(_, Tray), !.
delta(44, move_tray(_, Place, Place2), -0.00039081885507303844) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place2), !.
delta(44, move_tray(_, Place, _), 0.038677945733926654) :- done_served(Child), waiting(Child, Place), !.
delta(44, move_tray(_, _, Place), 0.012111507658402073) :- done_served(Child), waiting(Child, Place), !.
delta(44, move_tray(_, _, _), -0.01635780395763027) :- !.
delta(44, _, 0.0).

% tree 45: step size 1.0, 221 examples, 40 leaves
delta(45, make_sandwich_no_gluten(_, _, _), -0.04451142316763427) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(45, make_sandwich_no_gluten(_, _, _), 0.0004407364226262651) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(45, make_sandwich_no_gluten(_, _, _), 0.024867404181337347) :- !.
delta(45, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(45, make_sandwich(_, _, _), 0.0006665117116851957) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(45, make_sandwich(_, _, _), -0.0016431395428468825) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(45, make_sandwich(_, _, _), 0.016360254589039384) :- at_kitchen_sandwich(_), !.
delta(45, make_sandwich(_, Bread_portion, _), -0.0004439952677908308) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), !.
delta(45, make_sandwich(_, _, _), 0.0010131586761835665) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(45, make_sandwich(_, _, _), -0.00029510933890142434) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(45, make_sandwich(_, _, _), -0.047496485727648405) :- !.
delta(45, put_on_tray(_, Tray), 0.002303129755078723) :- ontray(_, Tray), todo_served(Child), allergic_gluten(Child), !.
delta(45, put_on_tray(_, Tray), -0.026530454108672177) :- ontray(_, Tray), notexist(_), !.
delta(45, put_on_tray(_, Tray), 0.000508960196433489) :- ontray(_, Tray), !.
delta(45, put_on_tray(Sandwich, _), 0.002363020605520806) :- fewer_at_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(45, put_on_tray(_, _), -0.0023447390585781495) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(45, put_on_tray(_, _), 0.011798579426621767) :- !.
delta(45, serve_sandwich_no_gluten(_, _, _, _), 0.003541262525277072) :- !.
delta(45, serve_sandwich(_, _, _, Place), -3.060530519600696e-5) :- at_kitchen_sandwich(_), done_served(Child), waiting(Child, Place), !.
delta(45, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_sandwich(_), notexist(_), !.
delta(45, serve_sandwich(_, _, _, _), 0.11928299523147816) :- at_kitchen_sandwich(_), !.
delta(45, serve_sandwich(_, Child, _, _), 0.0) :- todo_served(Child), fewer_at_1_than_allergic_gluten, !.
delta(45, serve_sandwich(_, Child, _, _), 0.021133762168762) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(45, serve_sandwich(_, Child, _, _), 0.0017287756191975414) :- todo_served(Child), !.
delta(45, serve_sandwich(_, _, _, _), -0.005528049485367321) :- !.
delta(45, move_tray(_, Place, Place2), 0.00014278000558207702) :- allergic_gluten(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_ontray_1_than_todo_served, fewer_ontray_2_than_not_allergic_gluten, !.
delta(45, move_tray(_, Place, Place2), -0.005624125119335304) :- allergic_gluten(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(45, move_tray(_, Place, Place2), 0.002857487711188361) :- allergic_gluten(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(45, move_tray(_, Place, Place2), -0.002289993049853782) :- allergic_gluten(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(45, move_tray(_, _, Place), 0.05163582946998384) :- allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(45, move_tray(_, _, Place), -5.9523858512763564e-5) :- allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(_), !.
delta(45, move_tray(_, Place, Place2), 8.386473750972812e-5) :- allergic_gluten(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(45, move_tray(_, _, Place), -0.002146562194756191) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(45, move_tray(_, Place, Place2), 0.0036736576990034856) :- fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(45, move_tray(_, _, _), -0.0018027280772571095) :- fewer_ontray_1_than_allergic_gluten, !.
delta(45, move_tray(_, _, _), -0.0004481776419988493) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(45, move_tray(_, _, _), 0.0006558089096091546) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(45, move_tray(_, Place, _), -0.0005843874685291765) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(45, move_tray(_, _, _), -0.13741463014109215) :- !.
delta(45, _, 0.0).

% tree 46: step size 1.0, 222 examples, 35 leaves
delta(46, make_sandwich_no_gluten(_, _, _), -1.2264509487153113e-17) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(46, make_sandwich_no_gluten(_, _, _), 0.0012403315825775488) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(46, make_sandwich_no_gluten(_, _, _), -0.050170551551153575) :- fewer_at_2_than_allergic_gluten, !.
delta(46, make_sandwich_no_gluten(_, _, _), 0.022886610988235134) :- !.
delta(46, make_sandwich(_, _, _), -0.010941092713660436) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served, !.
delta(46, make_sandwich(_, _, _), 0.009217043152400446) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(46, make_sandwich(_, _, Content_portion), -0.0017841447271262616) :- fewer_at_1_than_todo_served, no_gluten_content(Content_portion), !.
delta(46, make_sandwich(_, _, _), 0.032055112810597274) :- fewer_at_1_than_todo_served, !.
delta(46, make_sandwich(_, _, _), -0.003211369680492) :- goal_served(Child), allergic_gluten(Child), !.
delta(46, make_sandwich(_, _, _), 9.467645818683692e-6) :- !.
delta(46, put_on_tray(Sandwich, Tray), 0.005266460421547666) :- todo_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), ontray(_, Tray), !.
delta(46, put_on_tray(Sandwich, _), -0.012572380419241996) :- todo_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served, !.
delta(46, put_on_tray(Sandwich, _), 0.002246481065473104) :- todo_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(46, put_on_tray(_, _), 1.938050644764779e-5) :- todo_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, fewer_at_2_than_allergic_gluten, !.
delta(46, put_on_tray(_, _), 0.018772557635316486) :- todo_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, !.
delta(46, put_on_tray(_, _), -0.0012911770127112248) :- todo_served(Child), allergic_gluten(Child), !.
delta(46, put_on_tray(_, Tray), -0.02226717588548035) :- ontray(_, Tray), !.
delta(46, put_on_tray(_, _), 0.004952253197970373) :- !.
delta(46, serve_sandwich_no_gluten(_, _, _, _), 2.23127899045141e-6) :- fewer_at_1_than_allergic_gluten, !.
delta(46, serve_sandwich_no_gluten(_, _, _, _), 0.002090784152095065) :- !.
delta(46, serve_sandwich(_, Child, _, _), 0.09441796882540629) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(46, serve_sandwich(_, _, _, _), -0.004244863472357925) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(46, serve_sandwich(Sandwich, _, _, Place), -0.0016924734995647798) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(46, serve_sandwich(_, _, _, _), -0.00044915407446863607) :- goal_served(Child), done_served(Child), !.
delta(46, serve_sandwich(_, _, _, _), 0.0011874830802613443) :- todo_served(Child), allergic_gluten(Child), !.
delta(46, serve_sandwich(_, _, _, _), 6.736453011661293e-5) :- !.
delta(46, move_tray(_, Place, Place2), 0.04790564093881913) :- at(Tray, Place), could_put_on_tray(Tray, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(46, move_tray(_, Place, _), -0.0001026172961675559) :- at(Tray, Place), could_put_on_tray(Tray, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(46, move_tray(_, Place, _), -0.000639704319331692) :- at(Tray, Place), could_put_on_tray(Tray, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(46, move_tray(_, Place, _), -0.002111789268670488) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(46, move_tray(Tray, _, Place), 0.010860277133711667) :- fewer_at_2_than_allergic_gluten, could_serve_sandwich(Tray, Place), !.
delta(46, move_tray(_, _, Place), 3.6715479060226726e-5) :- fewer_at_2_than_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(46, move_tray(_, _, _), -0.010694092868601665) :- fewer_at_2_than_allergic_gluten, !.
delta(46, move_tray(_, _, _), -0.1269401323686376) :- !.
delta(46, _, 0.0).

% tree 47: step size 1.0, 207 examples, 31 leaves
delta(47, make_sandwich_no_gluten(_, _, _), 0.027817787217654776) :- !.
delta(47, make_sandwich(_, _, _), -0.043209749209547635) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(47, make_sandwich(_, _, _), 1.9892672703065162e-18) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(47, make_sandwich(_, _, _), -0.001481314482578698) :- fewer_at_2_than_allergic_gluten, !.
delta(47, make_sandwich(_, _, _), 0.027304392422918794) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(47, make_sandwich(_, _, _), -0.0008793891717571791) :- !.
delta(47, put_on_tray(_, _), 7.212095406045534e-6) :- fewer_no_gluten_sandwich_than_todo_served, fewer_at_1_than_todo_served, done_served(Child), not_allergic_gluten(Child), !.
delta(47, put_on_tray(_, _), -0.05280129870628212) :- fewer_no_gluten_sandwich_than_todo_served, fewer_at_1_than_todo_served, !.
delta(47, put_on_tray(_, _), 1.9989642030971876e-5) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(47, put_on_tray(Sandwich, _), 0.0023013511528288785) :- no_gluten_sandwich(Sandwich), !.
delta(47, put_on_tray(_, _), -0.0008811658618929208) :- !.
delta(47, serve_sandwich_no_gluten(_, _, _, _), 0.0022382132855407097) :- !.
delta(47, serve_sandwich(Sandwich, _, _, _), -0.19342789528847518) :- no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(47, serve_sandwich(Sandwich, _, _, _), 0.000199252149610769) :- no_gluten_sandwich(Sandwich), !.
delta(47, serve_sandwich(_, _, _, _), 0.05967593117406125) :- fewer_at_1_than_todo_served, notexist(_), at_kitchen_sandwich(_), !.
delta(47, serve_sandwich(_, _, _, _), 0.010685108282118608) :- fewer_at_1_than_todo_served, notexist(_), !.
delta(47, serve_sandwich(_, _, _, _), -0.06843026657294195) :- fewer_at_1_than_todo_served, fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(47, serve_sandwich(_, _, _, _), 0.008557098582282693) :- fewer_at_1_than_todo_served, !.
delta(47, serve_sandwich(_, Child, _, _), 0.19498546783437795) :- todo_served(Child), !.
delta(47, serve_sandwich(_, _, _, _), -0.0008851401738794268) :- !.
delta(47, move_tray(_, Place, Place2), -0.0021391585303713523) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(47, move_tray(Tray, Place, Place2), -0.00040103483260708705) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(47, move_tray(_, Place, Place2), 0.13840265181510902) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(47, move_tray(_, Place, Place2), 0.02779003252842319) :- at(Tray, Place), could_put_on_tray(Tray, Place), allergic_gluten(Child), waiting(Child, Place2), fewer_no_gluten_sandwich_than_todo_served, !.
delta(47, move_tray(_, Place, Place2), -0.0005232102055587929) :- at(Tray, Place), could_put_on_tray(Tray, Place), allergic_gluten(Child), waiting(Child, Place2), !.
delta(47, move_tray(_, Place, _), -0.0019733820264580437) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(47, move_tray(_, _, _), -0.00020156317653267507) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(47, move_tray(_, _, _), 0.001378355794205592) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(47, move_tray(_, _, _), -0.16283663773472257) :- fewer_ontray_2_than_todo_served, !.
delta(47, move_tray(_, _, _), -0.0006917856832477797) :- !.
delta(47, _, 0.0).

% tree 48: step size 1.0, 202 examples, 42 leaves
delta(48, make_sandwich_no_gluten(_, _, _), 0.0024328390708962364) :- fewer_ontray_1_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(48, make_sandwich_no_gluten(_, _, _), -0.18756097862897206) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(48, make_sandwich_no_gluten(_, _, _), 0.0008196683668844052) :- fewer_ontray_1_than_allergic_gluten, !.
delta(48, make_sandwich_no_gluten(_, _, _), 0.003123563345168063) :- !.
delta(48, make_sandwich(_, _, Content_portion), -0.022600773404820383) :- no_gluten_content(Content_portion), !.
delta(48, make_sandwich(_, _, _), 0.2368919125752984) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(48, make_sandwich(_, _, _), 0.0) :- goal_served(Child), allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(48, make_sandwich(_, _, _), -0.007854867114786966) :- goal_served(Child), allergic_gluten(Child), !.
delta(48, make_sandwich(_, _, _), 0.0048280523874160075) :- !.
delta(48, put_on_tray(_, Tray), 0.023482791453103207) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(48, put_on_tray(_, Tray), -0.0014214326580926507) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(48, put_on_tray(_, _), -0.01958036132935002) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(48, put_on_tray(Sandwich, _), 0.007479113703124684) :- no_gluten_sandwich(Sandwich), !.
delta(48, put_on_tray(_, _), -0.0030805786411846428) :- todo_served(Child), allergic_gluten(Child), !.
delta(48, put_on_tray(_, _), 0.0010315849541183751) :- !.
delta(48, serve_sandwich_no_gluten(_, _, Tray, _), 0.0011031699611913695) :- done_served(Child), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(48, serve_sandwich_no_gluten(_, _, _, _), 0.00016081846462376111) :- done_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(48, serve_sandwich_no_gluten(_, _, _, _), -0.025779236363377027) :- done_served(Child), allergic_gluten(Child), !.
delta(48, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(48, serve_sandwich_no_gluten(_, _, _, _), 0.0010901395989647055) :- !.
delta(48, serve_sandwich(Sandwich, _, _, _), -0.03470193519934271) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(48, serve_sandwich(Sandwich, _, _, _), 0.11446361074155216) :- no_gluten_sandwich(Sandwich), !.
delta(48, serve_sandwich(_, Child, _, _), 0.0023787353899530723) :- done_served(Child2), not_allergic_gluten(Child2), done_served(Child3), allergic_gluten(Child3), todo_served(Child), !.
delta(48, serve_sandwich(_, _, _, _), -0.001304255623564269) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), allergic_gluten(Child2), !.
delta(48, serve_sandwich(_, Child, _, _), 0.0513653112696847) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(48, serve_sandwich(_, _, _, _), -0.0009261628027622403) :- done_served(Child), not_allergic_gluten(Child), !.
delta(48, serve_sandwich(_, _, _, _), 0.03444922693234989) :- todo_served(Child), allergic_gluten(Child), notexist(_), !.
delta(48, serve_sandwich(_, _, _, _), 4.1318625386320244e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(48, serve_sandwich(_, _, _, _), -0.18644810381031315) :- no_gluten_bread(_), !.
delta(48, serve_sandwich(_, _, _, _), 0.007388617344060252) :- !.
delta(48, move_tray(Tray, Place, _), -0.0001607457879959738) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), allergic_gluten(Child2), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(48, move_tray(_, Place, kitchen), -0.00012805917080679674) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), allergic_gluten(Child2), !.
delta(48, move_tray(_, Place, _), 0.10226924311933205) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), allergic_gluten(Child2), !.
delta(48, move_tray(_, Place, Place2), 0.0006901081479085945) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(48, move_tray(_, Place, _), -9.295760536114352e-5) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(48, move_tray(_, Place, _), -0.0019943165887305724) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(48, move_tray(_, Place, _), 0.009214745660092782) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), waiting(Child, Place), !.
delta(48, move_tray(_, _, _), -0.0008598238341332554) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(48, move_tray(Tray, _, _), -0.006173930476258555) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(48, move_tray(Tray, _, _), 0.009465375727025258) :- at(Tray, kitchen), !.
delta(48, move_tray(_, _, _), -0.08186473968426866) :- !.
delta(48, _, 0.0).

% tree 49: step size 1.0, 265 examples, 40 leaves
delta(49, make_sandwich_no_gluten(_, _, _), 0.0035420800268192096) :- fewer_at_2_than_allergic_gluten, !.
delta(49, make_sandwich_no_gluten(_, _, _), -0.033357627118508024) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(49, make_sandwich_no_gluten(_, _, _), 0.00024410398459694628) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(49, make_sandwich_no_gluten(_, _, _), 0.002124100567829582) :- !.
delta(49, make_sandwich(_, _, _), -0.004728946089660678) :- fewer_at_1_than_not_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(49, make_sandwich(_, Bread_portion, _), -0.0003812999796546874) :- fewer_at_1_than_not_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(49, make_sandwich(_, _, _), 0.0724667331806606) :- fewer_at_1_than_not_allergic_gluten, !.
delta(49, make_sandwich(_, _, _), -0.02561615949502968) :- !.
delta(49, put_on_tray(Sandwich, _), 0.005872091261195104) :- fewer_at_1_than_todo_served, no_gluten_sandwich(Sandwich), !.
delta(49, put_on_tray(_, _), 0.0003795721077604677) :- fewer_at_1_than_todo_served, goal_served(Child), done_served(Child), !.
delta(49, put_on_tray(_, Tray), -0.017337726074029704) :- fewer_at_1_than_todo_served, ontray(_, Tray), !.
delta(49, put_on_tray(_, _), 4.214251974825228e-6) :- fewer_at_1_than_todo_served, !.
delta(49, put_on_tray(_, _), 0.02423932738207646) :- fewer_ontray_1_than_todo_served, !.
delta(49, put_on_tray(_, _), -8.261894660790438e-5) :- !.
delta(49, serve_sandwich_no_gluten(_, _, _, _), -0.01775259533282174) :- done_served(Child), allergic_gluten(Child), !.
delta(49, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(49, serve_sandwich_no_gluten(_, _, _, _), 0.0003074519448034694) :- !.
delta(49, serve_sandwich(_, _, _, Place), -0.025742050083400806) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(49, serve_sandwich(_, Child, _, Place), 0.0002729119710383708) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), goal_served(Child3), allergic_gluten(Child3), !.
delta(49, serve_sandwich(_, Child, _, Place), 0.0077024570398494625) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(49, serve_sandwich(_, _, _, Place), -0.003097341552049606) :- done_served(Child), waiting(Child, Place), !.
delta(49, serve_sandwich(_, _, _, _), 0.10358730961879696) :- at_kitchen_sandwich(_), !.
delta(49, serve_sandwich(_, _, _, _), 4.277997423432714e-5) :- notexist(_), done_served(Child), not_allergic_gluten(Child), !.
delta(49, serve_sandwich(_, _, _, _), 0.0015555838553819147) :- notexist(_), !.
delta(49, serve_sandwich(_, _, _, _), -7.624910038726784e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(49, serve_sandwich(_, _, _, _), 0.008549509694425845) :- !.
delta(49, move_tray(_, Place, _), 0.0) :- fewer_at_1_than_todo_served_not_allergic_gluten, not_allergic_gluten(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(49, move_tray(_, Place, _), -0.0004379671486442256) :- fewer_at_1_than_todo_served_not_allergic_gluten, not_allergic_gluten(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(49, move_tray(_, Place, _), -0.1334900855133324) :- fewer_at_1_than_todo_served_not_allergic_gluten, not_allergic_gluten(Child), waiting(Child, Place), !.
delta(49, move_tray(_, Place, Place2), 0.003457036330668379) :- fewer_at_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(49, move_tray(Tray, _, Place), 0.002760622627070738) :- fewer_at_1_than_todo_served_not_allergic_gluten, could_serve_sandwich(Tray, Place), !.
delta(49, move_tray(_, _, _), -0.008276160458997772) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(49, move_tray(_, _, Place), -0.00042965263619485915) :- needed_at_to_serve_sandwich_no_gluten(Place), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(49, move_tray(_, _, Place), -0.00014277028703255188) :- needed_at_to_serve_sandwich_no_gluten(Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(49, move_tray(_, _, Place), 0.03768961413908281) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(49, move_tray(_, Place, Place2), -0.0011618155080013982) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(49, move_tray(_, Place, Place2), 0.002781997428370249) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(49, move_tray(_, Place, Place2), 0.000165382204251501) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(49, move_tray(_, _, _), -0.017189401402460728) :- !.
delta(49, _, 0.0).

% tree 50: step size 1.0, 214 examples, 30 leaves
delta(50, make_sandwich_no_gluten(_, _, _), -0.16266437406388226) :- fewer_at_2_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(50, make_sandwich_no_gluten(_, _, _), 0.0011579024410367387) :- fewer_at_2_than_allergic_gluten, !.
delta(50, make_sandwich_no_gluten(_, _, _), 0.04875523645350952) :- !.
delta(50, make_sandwich(_, _, _), -0.009684878143773192) :- fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(50, make_sandwich(_, _, _), 0.17404417381878706) :- fewer_at_2_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(50, make_sandwich(_, _, _), -0.0004760504739557589) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(50, make_sandwich(_, _, _), -0.056146651493088284) :- !.
delta(50, put_on_tray(_, _), -0.00029641365642504207) :- fewer_ontray_1_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(50, put_on_tray(_, _), 0.0) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(50, put_on_tray(_, _), 0.03037915269606383) :- fewer_ontray_1_than_todo_served, !.
delta(50, put_on_tray(_, _), -0.008108846536002343) :- !.
delta(50, serve_sandwich_no_gluten(_, _, _, _), 1.073181871618744e-6) :- goal_served(Child), done_served(Child), !.
delta(50, serve_sandwich_no_gluten(_, _, _, _), 0.0002352221606622139) :- !.
delta(50, serve_sandwich(_, Child, _, _), 5.702420164901757e-6) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(50, serve_sandwich(_, Child, _, _), 0.05928482183410061) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(50, serve_sandwich(_, Child, Tray, _), 0.00019829637492940484) :- todo_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(50, serve_sandwich(_, Child, _, _), 0.0031383720741970235) :- todo_served(Child), !.
delta(50, serve_sandwich(_, _, _, _), -0.07394618756643834) :- !.
delta(50, move_tray(_, Place, Place2), -0.008858960967942598) :- fewer_at_2_than_todo_served_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), at(Tray2, Place), could_serve_sandwich(Tray2, Place), !.
delta(50, move_tray(_, Place, Place2), 0.025351258209030204) :- fewer_at_2_than_todo_served_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(50, move_tray(_, Place, _), 0.004073303517020319) :- fewer_at_2_than_todo_served_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(50, move_tray(_, Place, _), -1.3997051360106757e-6) :- fewer_at_2_than_todo_served_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(50, move_tray(_, _, Place), 0.002055346962908727) :- fewer_at_2_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(50, move_tray(_, _, _), -0.09639943452290457) :- fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(50, move_tray(_, _, Place), -0.004756144331568874) :- at(_, Place), !.
delta(50, move_tray(_, _, _), -0.00035199627613461694) :- goal_served(Child), allergic_gluten(Child), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(50, move_tray(_, _, _), 0.07592825411813066) :- goal_served(Child), allergic_gluten(Child), !.
delta(50, move_tray(_, Place, Place2), 0.0034030829034283026) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(50, move_tray(_, _, _), -0.0033211980443471558) :- !.
delta(50, _, 0.0).

% tree 51: step size 1.0, 217 examples, 38 leaves
delta(51, make_sandwich_no_gluten(_, _, _), 0.0053678690813258895) :- fewer_at_1_than_allergic_gluten, !.
delta(51, make_sandwich_no_gluten(_, _, _), 0.00014115748250881027) :- fewer_at_2_than_todo_served, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(51, make_sandwich_no_gluten(_, _, _), -0.19893731687045718) :- fewer_at_2_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(51, make_sandwich_no_gluten(_, _, _), 6.403521213562586e-5) :- fewer_at_2_than_todo_served, !.
delta(51, make_sandwich_no_gluten(_, _, _), 0.0022958929314256206) :- !.
delta(51, make_sandwich(_, _, _), -0.08148738619362676) :- at_kitchen_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(51, make_sandwich(_, _, _), 0.002758259381425971) :- at_kitchen_sandwich(_), !.
delta(51, make_sandwich(_, _, _), -0.005244111011794454) :- fewer_at_1_than_allergic_gluten, !.
delta(51, make_sandwich(_, _, _), 0.29093565308513236) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(51, make_sandwich(_, _, _), -0.0006804393722394485) :- !.
delta(51, put_on_tray(_, _), -0.0002785388512668933) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(51, put_on_tray(_, _), 0.048176503516998107) :- fewer_ontray_1_than_todo_served, !.
delta(51, put_on_tray(_, _), 2.3676309388811546e-6) :- !.
delta(51, serve_sandwich_no_gluten(_, Child, _, _), 0.008546101906841082) :- fewer_at_1_than_allergic_gluten, todo_served(Child), !.
delta(51, serve_sandwich_no_gluten(_, _, _, _), -0.008543914513632815) :- fewer_at_1_than_allergic_gluten, !.
delta(51, serve_sandwich_no_gluten(_, _, _, _), -0.04141657744235582) :- fewer_ontray_1_than_allergic_gluten, !.
delta(51, serve_sandwich_no_gluten(_, _, _, _), 4.829635277063832e-5) :- !.
delta(51, serve_sandwich(_, _, Tray, _), -0.005272847599104261) :- at_kitchen_sandwich(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(51, serve_sandwich(_, _, _, _), 0.0872095140245834) :- at_kitchen_sandwich(_), !.
delta(51, serve_sandwich(_, Child, _, _), 0.0009398433961793944) :- at_kitchen_bread(_), goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(51, serve_sandwich(_, _, _, _), -0.0007530893483045526) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(51, serve_sandwich(_, _, _, _), -0.036567517609109854) :- at_kitchen_bread(_), !.
delta(51, serve_sandwich(_, Child, _, _), 0.010578608819085861) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(51, serve_sandwich(_, Child, _, _), 0.0015893570559908858) :- todo_served(Child), !.
delta(51, serve_sandwich(_, _, _, _), -0.0036098927237137915) :- !.
delta(51, move_tray(_, _, Place), -0.004598105058973782) :- fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(51, move_tray(_, _, Place), -0.0026619224329662177) :- fewer_ontray_1_than_allergic_gluten, done_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(51, move_tray(_, _, Place), 0.00025939090691394067) :- fewer_ontray_1_than_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(51, move_tray(_, _, Place), -0.0014150201593293682) :- fewer_ontray_1_than_allergic_gluten, not_allergic_gluten(Child), waiting(Child, Place), !.
delta(51, move_tray(_, _, _), 0.09330046913799289) :- fewer_ontray_1_than_allergic_gluten, !.
delta(51, move_tray(Tray, Place, Place2), -0.0020244094800881823) :- could_serve_sandwich_no_gluten(Tray, Place2), at(Tray2, Place), could_serve_sandwich(Tray2, Place2), at_kitchen_sandwich(_), !.
delta(51, move_tray(Tray, Place, Place2), 0.0010639852779439764) :- could_serve_sandwich_no_gluten(Tray, Place2), at(Tray2, Place), could_serve_sandwich(Tray2, Place2), !.
delta(51, move_tray(Tray, _, Place), 0.008948402433418892) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(51, move_tray(_, _, _), -0.0011897483330245635) :- fewer_ontray_2_than_todo_served, done_served(Child), allergic_gluten(Child), !.
delta(51, move_tray(_, _, _), -0.1332562120594933) :- fewer_ontray_2_than_todo_served, !.
delta(51, move_tray(Tray, _, Place), 0.003564886063713137) :- could_serve_sandwich(Tray, Place), !.
delta(51, move_tray(_, _, _), -0.005094055453065122) :- !.
delta(51, _, 0.0).

% tree 52: step size 1.0, 207 examples, 42 leaves
delta(52, make_sandwich_no_gluten(_, _, _), -2.9677222572058872e-18) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(52, make_sandwich_no_gluten(_, _, _), 0.0006076693493983365) :- fewer_at_1_than_allergic_gluten, !.
delta(52, make_sandwich_no_gluten(_, _, _), -0.705297402262608) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(52, make_sandwich_no_gluten(_, _, _), 0.00013547386587411484) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(52, make_sandwich_no_gluten(_, _, _), 0.0025386456632575222) :- !.
delta(52, make_sandwich(_, _, Content_portion), -0.017496840958989804) :- at_kitchen_content(Content_portion2), no_gluten_content(Content_portion2), no_gluten_content(Content_portion), !.
delta(52, make_sandwich(_, Bread_portion, _), -0.0020354282496723433) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), no_gluten_bread(Bread_portion), !.
delta(52, make_sandwich(_, _, _), 0.7033021251879312) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), fewer_at_1_than_not_allergic_gluten, !.
delta(52, make_sandwich(_, _, _), -0.0005361664527288865) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(52, make_sandwich(_, _, _), 0.053076105501247646) :- goal_served(Child), done_served(Child), fewer_no_gluten_sandwich_than_todo_served, !.
delta(52, make_sandwich(_, _, _), -0.001256358639555705) :- goal_served(Child), done_served(Child), !.
delta(52, make_sandwich(_, _, _), 0.0023478922865560266) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_2_than_allergic_gluten, !.
delta(52, make_sandwich(_, _, _), -0.007283720914134077) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(52, make_sandwich(_, _, _), -0.06276331786839506) :- !.
delta(52, put_on_tray(_, _), 0.028264332679611294) :- fewer_ontray_1_than_todo_served, !.
delta(52, put_on_tray(_, _), 4.9191211536152375e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(52, put_on_tray(_, _), -0.002087442427573205) :- !.
delta(52, serve_sandwich_no_gluten(_, _, _, _), -0.02810268895402087) :- at_kitchen_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(52, serve_sandwich_no_gluten(_, _, _, _), 7.445967541630118e-7) :- at_kitchen_sandwich(_), !.
delta(52, serve_sandwich_no_gluten(_, _, _, _), 0.002036284329974321) :- !.
delta(52, serve_sandwich(_, _, _, _), -0.09735744294896419) :- notexist(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(52, serve_sandwich(_, _, _, _), 0.0012937853951743771) :- notexist(_), !.
delta(52, serve_sandwich(_, _, _, _), 2.262773075999441e-5) :- no_gluten_sandwich(_), done_served(Child), allergic_gluten(Child), !.
delta(52, serve_sandwich(_, _, _, _), -0.002077536552314943) :- no_gluten_sandwich(_), !.
delta(52, serve_sandwich(_, Child, _, _), 0.03871313336385232) :- todo_served(Child), !.
delta(52, serve_sandwich(_, _, _, _), -0.0010151100378364777) :- !.
delta(52, move_tray(Tray, Place, Place2), 0.000519468483083883) :- notexist(_), fewer_ontray_1_than_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), could_put_on_tray(Tray, Place2), !.
delta(52, move_tray(_, Place, _), -8.015280561380627e-5) :- notexist(_), fewer_ontray_1_than_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(52, move_tray(_, _, _), -0.00853782793366007) :- notexist(_), fewer_ontray_1_than_allergic_gluten, at_kitchen_bread(_), !.
delta(52, move_tray(_, _, _), 0.0) :- notexist(_), fewer_ontray_1_than_allergic_gluten, !.
delta(52, move_tray(_, Place, _), -0.0006770501480798982) :- notexist(_), fewer_at_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(52, move_tray(_, _, _), 0.14699422410466487) :- notexist(_), fewer_at_1_than_todo_served, !.
delta(52, move_tray(_, _, _), -0.002307663199379507) :- notexist(_), fewer_ontray_2_than_todo_served, !.
delta(52, move_tray(_, _, _), 0.0008148797806171984) :- notexist(_), !.
delta(52, move_tray(Tray, Place, Place2), -0.00014547323977068884) :- fewer_ontray_2_than_todo_served, at(Tray2, Place), could_put_on_tray(Tray2, Place2), ontray(_, Tray), !.
delta(52, move_tray(_, Place, Place2), 0.0012356701901764392) :- fewer_ontray_2_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(52, move_tray(_, _, _), -0.04072488266767253) :- fewer_ontray_2_than_todo_served, !.
delta(52, move_tray(Tray, _, Place), 0.005390525158797186) :- todo_served(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(52, move_tray(_, _, Place), -0.0010847846991604263) :- todo_served(Child), waiting(Child, Place), !.
delta(52, move_tray(_, _, _), 0.0008318751957380492) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(52, move_tray(_, _, _), -0.002559114760310417) :- !.
delta(52, _, 0.0).

% tree 53: step size 1.0, 220 examples, 38 leaves
delta(53, make_sandwich_no_gluten(_, _, _), 0.003645076699490027) :- fewer_at_1_than_allergic_gluten, !.
delta(53, make_sandwich_no_gluten(_, _, _), -0.3223033164472922) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(53, make_sandwich_no_gluten(_, _, _), 0.003434370360763027) :- !.
delta(53, make_sandwich(_, _, _), 0.0014304173489630614) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(53, make_sandwich(_, _, _), -0.013228055868086789) :- goal_served(Child), done_served(Child), !.
delta(53, make_sandwich(_, Bread_portion, _), -0.004286122063550108) :- fewer_at_1_than_not_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(53, make_sandwich(_, _, _), -0.003757703831371776) :- fewer_at_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(53, make_sandwich(_, _, _), 0.2612611392819505) :- fewer_at_1_than_not_allergic_gluten, !.
delta(53, make_sandwich(_, _, _), -0.010615869259315394) :- fewer_ontray_2_than_allergic_gluten, !.
delta(53, make_sandwich(_, _, _), -0.00036784989143007733) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(53, make_sandwich(_, _, _), 0.0017444954027290716) :- !.
delta(53, put_on_tray(_, _), 0.008951054655493134) :- goal_served(Child), done_served(Child), !.
delta(53, put_on_tray(_, _), 0.0009502252072091177) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_bread(_), fewer_at_2_than_allergic_gluten, !.
delta(53, put_on_tray(_, _), -0.05364478201546779) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_bread(_), !.
delta(53, put_on_tray(_, _), 0.0009977225651227732) :- fewer_at_1_than_not_allergic_gluten, !.
delta(53, put_on_tray(_, _), 0.0017071235053923587) :- !.
delta(53, serve_sandwich_no_gluten(_, _, _, _), 8.37002079741026e-6) :- fewer_at_1_than_allergic_gluten, !.
delta(53, serve_sandwich_no_gluten(_, _, _, _), 0.005536382385027865) :- !.
delta(53, serve_sandwich(_, Child, _, Place), 8.329548288455556e-5) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child2), waiting(Child2, Place), todo_served(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(53, serve_sandwich(_, Child, _, Place), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(53, serve_sandwich(_, _, _, Place), -0.00030100543013234925) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(53, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_2_than_allergic_gluten, !.
delta(53, serve_sandwich(_, Child, _, _), 0.10267431461130384) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(53, serve_sandwich(_, _, _, _), -0.0018202313822075818) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(53, serve_sandwich(Sandwich, _, _, Place), -0.0029400978249515437) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), notexist(_), !.
delta(53, serve_sandwich(Sandwich, _, _, Place), -0.00011419274608990566) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), no_gluten_sandwich(Sandwich), !.
delta(53, serve_sandwich(Sandwich, _, _, Place), 0.0) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(53, serve_sandwich(_, _, _, _), 0.0) :- goal_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(53, serve_sandwich(_, _, _, _), 0.001823957086624142) :- goal_served(Child), allergic_gluten(Child), !.
delta(53, serve_sandwich(_, _, _, _), 3.3941559383359165e-5) :- !.
delta(53, move_tray(_, Place, _), -0.1210535575253664) :- todo_served(Child), waiting(Child, Place), !.
delta(53, move_tray(_, Place, Place2), -0.002544015965744257) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(53, move_tray(_, Place, Place2), -0.00029473468486897246) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(53, move_tray(_, Place, Place2), 0.018046257498354056) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(53, move_tray(_, _, _), -0.023112337159030917) :- fewer_ontray_1_than_todo_served, !.
delta(53, move_tray(_, _, Place), -0.011129550537301202) :- done_served(Child), waiting(Child, Place), !.
delta(53, move_tray(_, _, _), 0.018272423314314352) :- !.
delta(53, _, 0.0).

% tree 54: step size 1.0, 216 examples, 39 leaves
delta(54, make_sandwich_no_gluten(_, _, _), 0.0009379092797726226) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(54, make_sandwich_no_gluten(_, _, _), -0.07367527591287007) :- fewer_at_2_than_allergic_gluten, !.
delta(54, make_sandwich_no_gluten(_, _, _), 0.05254630534062843) :- !.
delta(54, make_sandwich(_, _, _), -0.009369316254087254) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(54, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(54, make_sandwich(_, _, _), 0.0566172158170272) :- fewer_at_2_than_allergic_gluten, !.
delta(54, make_sandwich(_, Bread_portion, _), -0.0005148627078928577) :- at_kitchen_sandwich(_), no_gluten_bread(Bread_portion), !.
delta(54, make_sandwich(_, _, _), 0.007941137537266059) :- at_kitchen_sandwich(_), goal_served(Child), allergic_gluten(Child), !.
delta(54, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(_), !.
delta(54, make_sandwich(_, _, _), -0.08852238782445092) :- !.
delta(54, put_on_tray(Sandwich, _), -0.023092978073343474) :- at_kitchen_sandwich(Sandwich2), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), at_kitchen_bread(_), !.
delta(54, put_on_tray(Sandwich, _), 0.018338108849476124) :- at_kitchen_sandwich(Sandwich2), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), !.
delta(54, put_on_tray(_, _), 0.03192951271558193) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(54, put_on_tray(_, _), -0.0020222041999216215) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(54, put_on_tray(_, _), -0.00034089429613939963) :- fewer_ontray_1_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(54, put_on_tray(_, _), 0.0016648285610618228) :- fewer_ontray_1_than_todo_served, !.
delta(54, put_on_tray(_, _), -0.007782054156270028) :- !.
delta(54, serve_sandwich_no_gluten(_, _, _, Place), 0.000783559437643818) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(54, serve_sandwich_no_gluten(_, _, _, _), 2.0307472614247537e-6) :- fewer_at_1_than_allergic_gluten, !.
delta(54, serve_sandwich_no_gluten(_, _, _, _), 0.0001333341448541502) :- at_kitchen_bread(_), !.
delta(54, serve_sandwich_no_gluten(_, _, _, _), -0.03270196893831337) :- !.
delta(54, serve_sandwich(_, Child, _, _), 0.05498983236306999) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, todo_served(Child), !.
delta(54, serve_sandwich(_, _, _, _), -0.0014500473103729115) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(54, serve_sandwich(Sandwich, _, _, _), -0.00036248138694330585) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(54, serve_sandwich(Sandwich, Child, _, _), 0.08834639286284646) :- no_gluten_sandwich(Sandwich), todo_served(Child), !.
delta(54, serve_sandwich(Sandwich, _, _, _), -0.00013386345273393654) :- no_gluten_sandwich(Sandwich), !.
delta(54, serve_sandwich(_, Child, _, Place), 0.0012421287253225706) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(54, serve_sandwich(_, _, _, Place), -0.0022462544430504852) :- done_served(Child), waiting(Child, Place), !.
delta(54, serve_sandwich(_, _, _, _), -0.538149855644986) :- fewer_ontray_2_than_todo_served, !.
delta(54, serve_sandwich(_, _, _, _), 0.0002820721484356068) :- !.
delta(54, move_tray(_, _, Place), -0.06427042734318482) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, todo_served(Child), waiting(Child, Place), !.
delta(54, move_tray(_, Place, _), -0.029542519483968976) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(54, move_tray(_, _, _), -0.004534025270233651) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(54, move_tray(_, _, _), 0.049135993790044304) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(54, move_tray(_, _, Place), -0.0021850971823856075) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(54, move_tray(_, _, Place), -0.00019874600222711197) :- at(Tray, Place), ontray(_, Tray), !.
delta(54, move_tray(_, Place, _), -0.0001329862110573344) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(54, move_tray(_, _, _), 0.6433124079073559) :- !.
delta(54, _, 0.0).

% tree 55: step size 1.0, 265 examples, 48 leaves
delta(55, make_sandwich_no_gluten(_, _, _), 0.04374979406327752) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(55, make_sandwich_no_gluten(_, _, _), -0.04874596153949072) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(55, make_sandwich_no_gluten(_, _, _), 0.0014887280757306335) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(55, make_sandwich_no_gluten(_, _, _), -0.15633281756883965) :- fewer_at_2_than_allergic_gluten, !.
delta(55, make_sandwich_no_gluten(_, _, _), 0.053882233751004587) :- !.
delta(55, make_sandwich(_, _, _), -0.059174355141167034) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(55, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(55, make_sandwich(_, _, _), 0.04861256043093626) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(55, make_sandwich(_, _, _), -0.0009254853896554919) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(55, make_sandwich(_, _, _), 0.14227852718041548) :- fewer_at_2_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(55, make_sandwich(_, _, _), -0.0020666598862265494) :- fewer_at_2_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(55, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, !.
delta(55, make_sandwich(_, _, _), 0.0) :- no_gluten_sandwich(_), fewer_at_1_than_not_allergic_gluten, fewer_ontray_2_than_allergic_gluten, !.
delta(55, make_sandwich(_, _, _), 0.019831177368379128) :- no_gluten_sandwich(_), fewer_at_1_than_not_allergic_gluten, !.
delta(55, make_sandwich(_, _, _), -0.0009605956868416582) :- no_gluten_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(55, make_sandwich(_, _, _), 2.5436762765674267e-5) :- no_gluten_sandwich(_), !.
delta(55, make_sandwich(_, _, _), -0.09868566253807191) :- !.
delta(55, put_on_tray(Sandwich, Tray), 0.0068968486833255425) :- ontray(_, Tray), no_gluten_sandwich(Sandwich), !.
delta(55, put_on_tray(_, Tray), -0.03558647182022918) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(55, put_on_tray(_, Tray), -0.0019731811969126386) :- ontray(_, Tray), goal_served(Child), done_served(Child), !.
delta(55, put_on_tray(_, Tray), 0.002039799901692259) :- ontray(_, Tray), !.
delta(55, put_on_tray(_, _), -7.531075146181046e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(55, put_on_tray(_, _), 0.01206477685011435) :- !.
delta(55, serve_sandwich_no_gluten(_, _, _, _), 0.0043867127945886675) :- !.
delta(55, serve_sandwich(_, _, _, _), -0.0952016950578411) :- goal_served(Child), done_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(55, serve_sandwich(_, _, _, Place), 3.27508131306359e-6) :- goal_served(Child), done_served(Child), fewer_ontray_1_than_todo_served, allergic_gluten(Child2), waiting(Child2, Place), !.
delta(55, serve_sandwich(_, _, _, _), 0.09851680460173287) :- goal_served(Child), done_served(Child), fewer_ontray_1_than_todo_served, !.
delta(55, serve_sandwich(_, _, _, _), -0.0162592707498193) :- goal_served(Child), done_served(Child), no_gluten_sandwich(_), !.
delta(55, serve_sandwich(_, _, _, _), 0.026847814139510828) :- goal_served(Child), done_served(Child), !.
delta(55, serve_sandwich(_, _, Tray, _), 0.0006472852366640057) :- fewer_ontray_1_than_todo_served, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(55, serve_sandwich(_, _, _, _), -0.3111354385421368) :- fewer_ontray_1_than_todo_served, !.
delta(55, serve_sandwich(_, _, Tray, _), -0.00021679461270204798) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_2_than_todo_served, !.
delta(55, serve_sandwich(_, _, Tray, _), 0.0) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(55, serve_sandwich(_, _, _, _), 0.0010537251540929545) :- !.
delta(55, move_tray(_, Place, Place2), 0.00039037185954354325) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place2), allergic_gluten(Child), !.
delta(55, move_tray(_, Place, Place2), -0.05895080023403367) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place2), !.
delta(55, move_tray(_, Place, _), -0.00043039522917275654) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), allergic_gluten(Child), !.
delta(55, move_tray(_, Place, _), 0.03216724252439473) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(55, move_tray(_, Place, _), 0.0) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(55, move_tray(_, _, _), -0.028810665867484212) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(55, move_tray(_, Place, Place2), -0.0077038861705086385) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(55, move_tray(_, _, _), 0.4055941712926474) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(55, move_tray(_, Place, _), -0.05292938092027551) :- todo_served(Child), waiting(Child, Place), !.
delta(55, move_tray(_, Place, Place2), 0.0038788418813469915) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), notexist(_), !.
delta(55, move_tray(_, Place, Place2), -0.007360529569384274) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(55, move_tray(_, _, Place), -0.001801982553446752) :- done_served(Child), waiting(Child, Place), !.
delta(55, move_tray(_, _, _), 0.04509371417531503) :- !.
delta(55, _, 0.0).

% tree 56: step size 1.0, 201 examples, 42 leaves
delta(56, make_sandwich_no_gluten(_, _, _), 0.0013065428111134346) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(56, make_sandwich_no_gluten(_, _, _), -0.03795728419362209) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(56, make_sandwich_no_gluten(_, _, _), 0.07092763653535228) :- !.
delta(56, make_sandwich(_, _, _), -0.10302186944621881) :- fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(56, make_sandwich(_, _, _), -0.021209283761597853) :- fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_2_than_allergic_gluten, !.
delta(56, make_sandwich(_, _, _), -0.0004812567983800658) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(56, make_sandwich(_, _, _), 0.021804882508556615) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(56, make_sandwich(_, _, _), -0.0006011666370750147) :- todo_served(Child), allergic_gluten(Child), !.
delta(56, make_sandwich(_, _, _), 0.0012431328004403601) :- !.
delta(56, put_on_tray(_, _), 0.013679025033523343) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_2_than_todo_served, !.
delta(56, put_on_tray(_, _), 0.0002119139165830217) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(56, put_on_tray(_, _), -0.00219545456754528) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(56, put_on_tray(_, _), -0.044461340689786785) :- at_kitchen_bread(_), !.
delta(56, put_on_tray(_, _), 0.0027729205739513434) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(56, put_on_tray(_, _), -0.00019030204258137936) :- !.
delta(56, serve_sandwich_no_gluten(_, Child, _, _), 8.367687846968031e-7) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(56, serve_sandwich_no_gluten(_, Child, _, _), 0.005106990849351214) :- todo_served(Child), !.
delta(56, serve_sandwich_no_gluten(_, _, _, _), -0.016777332768835338) :- !.
delta(56, serve_sandwich(_, _, _, _), 0.0) :- done_served(Child), allergic_gluten(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(56, serve_sandwich(_, _, _, _), 0.011523611415172528) :- done_served(Child), allergic_gluten(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(56, serve_sandwich(_, _, _, _), 2.6056478957014775e-5) :- done_served(Child), allergic_gluten(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(56, serve_sandwich(_, _, _, Place), -0.01578095702291867) :- done_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), waiting(Child2, Place), !.
delta(56, serve_sandwich(_, _, _, _), 8.218802803271822e-6) :- done_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(56, serve_sandwich(_, _, _, _), 1.2739127837850157e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(56, serve_sandwich(_, Child, _, _), 0.08291140708950201) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(56, serve_sandwich(_, _, _, _), -0.000629614082483723) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(56, serve_sandwich(Sandwich, _, _, _), -0.0001889876916605138) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(56, serve_sandwich(Sandwich, _, _, _), 0.032696253891413785) :- no_gluten_sandwich(Sandwich), !.
delta(56, serve_sandwich(_, _, Tray, _), -0.032607763623706695) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(56, serve_sandwich(_, _, _, _), 0.0005566677660806937) :- !.
delta(56, move_tray(_, Place, _), -0.0016701007369612862) :- at_kitchen_bread(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(56, move_tray(_, _, Place), -0.0002153583586098128) :- at_kitchen_bread(_), at(_, Place), !.
delta(56, move_tray(_, _, _), 0.11754738024274679) :- at_kitchen_bread(_), fewer_ontray_2_than_todo_served, !.
delta(56, move_tray(_, _, _), -0.00011950809241678855) :- at_kitchen_bread(_), !.
delta(56, move_tray(Tray, Place, _), -0.0073098396438135175) :- allergic_gluten(Child), waiting(Child, Place), ontray(_, Tray), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(56, move_tray(Tray, Place, _), 0.0367558199130144) :- allergic_gluten(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(56, move_tray(_, Place, _), 9.97872973192107e-5) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(56, move_tray(_, Place, _), -0.00931314444499729) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(56, move_tray(_, _, _), -0.1165602829376903) :- fewer_at_2_than_todo_served, !.
delta(56, move_tray(_, _, Place), 0.0161769221985362) :- todo_served(Child), waiting(Child, Place), !.
delta(56, move_tray(_, _, _), -0.0144189952834014) :- !.
delta(56, _, 0.0).

% tree 57: step size 1.0, 201 examples, 39 leaves
delta(57, make_sandwich_no_gluten(_, _, _), -0.01171570742003547) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(57, make_sandwich_no_gluten(_, _, _), 0.035174532309841314) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(57, make_sandwich_no_gluten(_, _, _), -0.05472261246215233) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(57, make_sandwich_no_gluten(_, _, _), 0.1554218284127767) :- fewer_ontray_1_than_allergic_gluten, !.
delta(57, make_sandwich_no_gluten(_, _, _), -0.025553539423565624) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(57, make_sandwich_no_gluten(_, _, _), 0.00012096531607267368) :- !.
delta(57, make_sandwich(_, _, Content_portion), -0.007699797067224187) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), no_gluten_content(Content_portion), !.
delta(57, make_sandwich(_, _, _), 0.15302303860334845) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(57, make_sandwich(_, _, _), -0.053245193266372046) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(57, make_sandwich(_, _, _), 0.05972704083365448) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(57, make_sandwich(_, _, _), -0.23048471876026896) :- !.
delta(57, put_on_tray(_, Tray), -0.0007768345991354904) :- ontray(_, Tray), goal_served(Child), done_served(Child), !.
delta(57, put_on_tray(_, Tray), 0.01662847759761479) :- ontray(_, Tray), !.
delta(57, put_on_tray(Sandwich, _), -0.16016837351323931) :- fewer_no_gluten_sandwich_than_todo_served, no_gluten_sandwich(Sandwich), !.
delta(57, put_on_tray(_, _), 0.00020364531185948994) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(57, put_on_tray(Sandwich, _), 0.003781847631864688) :- no_gluten_sandwich(Sandwich), !.
delta(57, put_on_tray(_, _), -0.0028703910668734763) :- !.
delta(57, serve_sandwich_no_gluten(_, Child, _, _), 0.004714454429828884) :- todo_served(Child), !.
delta(57, serve_sandwich_no_gluten(_, _, _, _), -0.006076790155699651) :- !.
delta(57, serve_sandwich(_, Child, _, _), -0.0006651310999428073) :- todo_served(Child), fewer_ontray_1_than_todo_served, todo_served(Child2), allergic_gluten(Child2), !.
delta(57, serve_sandwich(_, Child, _, _), 0.10181581638591108) :- todo_served(Child), fewer_ontray_1_than_todo_served, !.
delta(57, serve_sandwich(_, Child, _, _), -0.0004367421247184156) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(57, serve_sandwich(_, Child, _, _), 0.004859003742651182) :- todo_served(Child), !.
delta(57, serve_sandwich(_, _, _, _), -0.03605732182532789) :- !.
delta(57, move_tray(Tray, Place, _), -0.0008006490956117499) :- goal_served(Child), allergic_gluten(Child), at_kitchen_bread(_), fewer_ontray_1_than_not_allergic_gluten, could_put_on_tray(Tray, Place), !.
delta(57, move_tray(_, _, _), 0.08039973519559022) :- goal_served(Child), allergic_gluten(Child), at_kitchen_bread(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(57, move_tray(Tray, _, Place), 9.927527233678073e-5) :- goal_served(Child), allergic_gluten(Child), at_kitchen_bread(_), could_serve_sandwich(Tray, Place), !.
delta(57, move_tray(_, _, _), -0.001067677152383888) :- goal_served(Child), allergic_gluten(Child), at_kitchen_bread(_), !.
delta(57, move_tray(_, _, Place), 0.01823878398734236) :- goal_served(Child), allergic_gluten(Child), needed_at_to_serve_sandwich_no_gluten(Place), goal_served(Child2), done_served(Child2), !.
delta(57, move_tray(_, _, Place), -0.007507975800848317) :- goal_served(Child), allergic_gluten(Child), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(57, move_tray(_, _, _), -0.03164620128628264) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(57, move_tray(_, _, _), 0.005436826356264818) :- goal_served(Child), allergic_gluten(Child), !.
delta(57, move_tray(_, Place, Place2), 0.00021503522560480115) :- at(Tray, Place), could_put_on_tray(Tray, Place2), no_gluten_sandwich(Sandwich), at_kitchen_sandwich(Sandwich), !.
delta(57, move_tray(_, Place, Place2), -0.0023347422927708396) :- at(Tray, Place), could_put_on_tray(Tray, Place2), no_gluten_sandwich(_), !.
delta(57, move_tray(_, Place, Place2), 0.011846971255161704) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(57, move_tray(_, _, _), -0.03657785895219174) :- fewer_ontray_1_than_todo_served, !.
delta(57, move_tray(_, _, Place), 0.010022112617223909) :- todo_served(Child), waiting(Child, Place), !.
delta(57, move_tray(_, _, _), -0.007528240152465713) :- !.
delta(57, _, 0.0).

% tree 58: step size 1.0, 205 examples, 35 leaves
delta(58, make_sandwich_no_gluten(_, _, _), 0.05285500061174145) :- fewer_at_2_than_allergic_gluten, !.
delta(58, make_sandwich_no_gluten(_, _, _), -0.034539394644445054) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(58, make_sandwich_no_gluten(_, _, _), 0.0005010841283040866) :- fewer_ontray_1_than_allergic_gluten, !.
delta(58, make_sandwich_no_gluten(_, _, _), 0.0011722369922989586) :- !.
delta(58, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(58, make_sandwich(_, _, _), -0.00041733942442519434) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(58, make_sandwich(_, _, _), -0.06884955595464937) :- fewer_at_2_than_allergic_gluten, !.
delta(58, make_sandwich(_, _, _), -0.005447298337380413) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(58, make_sandwich(_, Bread_portion, _), -0.0009041826879100296) :- no_gluten_bread(Bread_portion), !.
delta(58, make_sandwich(_, _, _), 0.05573838178152213) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(58, make_sandwich(_, _, _), -0.00012015408102625084) :- !.
delta(58, put_on_tray(Sandwich, _), 0.01194919245646021) :- todo_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_allergic_gluten, !.
delta(58, put_on_tray(Sandwich, _), -0.017712320799292917) :- todo_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(58, put_on_tray(_, Tray), 0.0) :- todo_served(Child), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(58, put_on_tray(_, Tray), 0.021396169206156414) :- todo_served(Child), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(58, put_on_tray(_, _), -0.006945282904410316) :- todo_served(Child), allergic_gluten(Child), !.
delta(58, put_on_tray(_, Tray), 9.12048821993602e-5) :- ontray(_, Tray), done_served(Child), not_allergic_gluten(Child), !.
delta(58, put_on_tray(_, Tray), -0.02390668826810742) :- ontray(_, Tray), !.
delta(58, put_on_tray(_, _), 0.00525193024100616) :- !.
delta(58, serve_sandwich_no_gluten(_, _, _, _), 0.0026021707269057435) :- !.
delta(58, serve_sandwich(_, _, _, _), 0.0823288553954908) :- at_kitchen_sandwich(_), !.
delta(58, serve_sandwich(_, Child, _, _), 0.001317469784041179) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), at_kitchen_bread(_), !.
delta(58, serve_sandwich(_, Child, _, _), 0.021021544300246425) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(58, serve_sandwich(_, _, _, _), -0.0020600798190927145) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(58, serve_sandwich(_, _, _, _), -0.0006515860424798394) :- todo_served(Child), allergic_gluten(Child), !.
delta(58, serve_sandwich(_, _, _, _), 1.1099457130545272e-6) :- fewer_ontray_2_than_todo_served, !.
delta(58, serve_sandwich(_, _, _, _), 6.8745571095609e-5) :- !.
delta(58, move_tray(_, Place, _), -0.003427812063894324) :- at(Tray, Place), could_put_on_tray(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(58, move_tray(_, Place, _), -0.00033674222814684664) :- at(Tray, Place), could_put_on_tray(Tray, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(58, move_tray(_, Place, Place2), 0.0035497564397962496) :- at(Tray, Place), could_put_on_tray(Tray, Place), todo_served(Child), waiting(Child, Place2), !.
delta(58, move_tray(_, Place, _), -4.9572273663977255e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(58, move_tray(_, Place, Place2), 0.010764676974987205) :- fewer_at_1_than_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(58, move_tray(_, _, _), -0.010807191173158034) :- fewer_at_1_than_allergic_gluten, !.
delta(58, move_tray(_, _, _), -0.11577746011234313) :- !.
delta(58, _, 0.0).

% tree 59: step size 1.0, 225 examples, 37 leaves
delta(59, make_sandwich_no_gluten(_, _, _), 0.16423597298709702) :- !.
delta(59, make_sandwich(_, _, _), -0.00021516921729563241) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(59, make_sandwich(_, _, _), -0.2596284811580435) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(59, make_sandwich(_, _, _), -0.02258730970458957) :- fewer_at_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(59, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(59, make_sandwich(_, _, _), 0.01748669141332327) :- fewer_at_1_than_not_allergic_gluten, !.
delta(59, make_sandwich(_, _, _), 0.07429689541715294) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(59, make_sandwich(_, _, _), -6.52193188300049e-5) :- !.
delta(59, put_on_tray(_, _), -0.0001847250890484207) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(59, put_on_tray(Sandwich, _), 0.0018897500456620919) :- fewer_ontray_2_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(59, put_on_tray(_, _), -0.00186857569097877) :- fewer_ontray_2_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(59, put_on_tray(_, _), 0.025514165172113128) :- fewer_ontray_2_than_allergic_gluten, !.
delta(59, put_on_tray(_, _), -0.0018859137351498714) :- at_kitchen_bread(_), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(59, put_on_tray(_, _), 0.007916409956919843) :- at_kitchen_bread(_), !.
delta(59, put_on_tray(_, Tray), 0.003906734027666726) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(59, put_on_tray(_, Tray), -0.0006063653938672218) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(59, put_on_tray(_, _), 0.0006354750623831565) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(59, put_on_tray(_, _), -0.034340678065199685) :- !.
delta(59, serve_sandwich_no_gluten(_, _, _, _), -0.009752908059240235) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(59, serve_sandwich_no_gluten(_, _, _, _), 0.004239886310139097) :- !.
delta(59, serve_sandwich(_, _, _, _), -0.04611034180024824) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(59, serve_sandwich(Sandwich, _, _, _), -0.044220309661390796) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(59, serve_sandwich(Sandwich, _, _, _), 0.0002399940089179846) :- no_gluten_sandwich(Sandwich), !.
delta(59, serve_sandwich(_, Child, _, _), 0.008926870132502429) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(59, serve_sandwich(_, _, _, _), -0.0017751990654463559) :- done_served(Child), not_allergic_gluten(Child), !.
delta(59, serve_sandwich(_, _, _, Place), -0.0007770192462766504) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(59, serve_sandwich(_, _, _, _), 0.07220460194680714) :- !.
delta(59, move_tray(_, Place, Place2), -0.00406856922559432) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(59, move_tray(_, Place, Place2), -0.00034858651129658543) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(59, move_tray(_, Place, Place2), -0.0002664340449656557) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(Tray2, Place), could_serve_sandwich_no_gluten(Tray2, Place), !.
delta(59, move_tray(_, Place, Place2), 0.10292029586461258) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(59, move_tray(_, Place, Place2), 0.028990058840914195) :- done_served(Child), waiting(Child, Place2), at(Tray, Place), could_put_on_tray(Tray, Place), allergic_gluten(Child), !.
delta(59, move_tray(_, Place, Place2), -0.00038414317102085203) :- done_served(Child), waiting(Child, Place2), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(59, move_tray(_, _, Place), -0.01308828747024531) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_not_allergic_gluten, !.
delta(59, move_tray(_, _, Place), 0.00019340273058651163) :- done_served(Child), waiting(Child, Place), !.
delta(59, move_tray(_, _, _), -0.13348427385355086) :- !.
delta(59, _, 0.0).

% tree 60: step size 1.0, 220 examples, 44 leaves
delta(60, make_sandwich_no_gluten(_, _, _), 0.01347559329739328) :- fewer_at_1_than_allergic_gluten, !.
delta(60, make_sandwich_no_gluten(_, _, _), -0.12526700371517827) :- fewer_at_2_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(60, make_sandwich_no_gluten(_, _, _), 0.00036374231205192094) :- fewer_at_2_than_allergic_gluten, !.
delta(60, make_sandwich_no_gluten(_, _, _), 0.003539899026047931) :- !.
delta(60, make_sandwich(_, _, _), -0.025944925830480144) :- fewer_at_1_than_allergic_gluten, !.
delta(60, make_sandwich(_, _, _), -0.016167498313718682) :- goal_served(Child), done_served(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(60, make_sandwich(_, _, _), 0.0) :- goal_served(Child), done_served(Child), fewer_at_1_than_todo_served, !.
delta(60, make_sandwich(_, _, _), 0.00025524665389884825) :- goal_served(Child), done_served(Child), !.
delta(60, make_sandwich(_, _, _), -0.0009234428076133279) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(60, make_sandwich(_, _, _), 0.1316886940481188) :- fewer_at_1_than_not_allergic_gluten, !.
delta(60, make_sandwich(_, _, _), -0.015274186014782466) :- fewer_at_2_than_todo_served, !.
delta(60, make_sandwich(_, _, _), 0.00021289717207411925) :- !.
delta(60, put_on_tray(_, _), 0.007200845589349194) :- fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(60, put_on_tray(_, Tray), -0.03744947058512457) :- fewer_ontray_1_than_not_allergic_gluten, ontray(_, Tray), at_kitchen_bread(_), !.
delta(60, put_on_tray(_, Tray), 0.00020229651993643175) :- fewer_ontray_1_than_not_allergic_gluten, ontray(_, Tray), !.
delta(60, put_on_tray(_, _), 0.005274870567013891) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(60, put_on_tray(_, _), 0.0205434780909735) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(60, put_on_tray(Sandwich, _), 0.00178764268899287) :- no_gluten_sandwich(Sandwich), !.
delta(60, put_on_tray(_, _), -0.0019394450495538835) :- !.
delta(60, serve_sandwich_no_gluten(_, _, _, _), 0.00022354286706679862) :- goal_served(Child), done_served(Child), fewer_ontray_2_than_allergic_gluten, !.
delta(60, serve_sandwich_no_gluten(_, _, _, _), -0.02521588715905351) :- goal_served(Child), done_served(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(60, serve_sandwich_no_gluten(_, _, _, _), 7.344465858426897e-6) :- goal_served(Child), done_served(Child), !.
delta(60, serve_sandwich_no_gluten(_, _, _, _), 0.003949650733654101) :- !.
delta(60, serve_sandwich(_, _, _, _), -0.3048464509388948) :- fewer_ontray_1_than_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(60, serve_sandwich(_, Child, _, _), 0.0011734123203310783) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(60, serve_sandwich(_, _, _, _), -0.00042050993621635467) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(60, serve_sandwich(_, _, _, Place), -0.00026977420713935647) :- todo_served(Child), allergic_gluten(Child), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(60, serve_sandwich(_, _, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), !.
delta(60, serve_sandwich(_, _, _, _), 0.004280944849172661) :- !.
delta(60, move_tray(_, Place, Place2), -0.0010466684253954716) :- not_allergic_gluten(Child), waiting(Child, Place2), goal_served(Child2), waiting(Child2, Place), fewer_ontray_2_than_allergic_gluten, fewer_ontray_2_than_todo_served, !.
delta(60, move_tray(_, Place, Place2), 4.9982812941730483e-5) :- not_allergic_gluten(Child), waiting(Child, Place2), goal_served(Child2), waiting(Child2, Place), fewer_ontray_2_than_allergic_gluten, !.
delta(60, move_tray(_, Place, Place2), 0.4698729196542952) :- not_allergic_gluten(Child), waiting(Child, Place2), goal_served(Child2), waiting(Child2, Place), fewer_at_1_than_not_allergic_gluten, !.
delta(60, move_tray(_, Place, Place2), -2.4139141005827396e-5) :- not_allergic_gluten(Child), waiting(Child, Place2), goal_served(Child2), waiting(Child2, Place), !.
delta(60, move_tray(_, _, Place), -0.01173267832733222) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place), done_served(Child), !.
delta(60, move_tray(_, _, Place), 0.024441987211101607) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place), !.
delta(60, move_tray(_, _, Place), -0.025320600891031757) :- not_allergic_gluten(Child), waiting(Child, Place), no_gluten_sandwich(_), !.
delta(60, move_tray(_, _, Place), 0.009522507766857147) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(60, move_tray(_, Place, Place2), -0.0002235782292257705) :- not_allergic_gluten(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_allergic_gluten, !.
delta(60, move_tray(_, Place, Place2), 0.022859316135859516) :- not_allergic_gluten(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(60, move_tray(_, Place, _), -0.006351731951942203) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(60, move_tray(_, Place, _), -0.042941256935443185) :- at(Tray, Place), ontray(_, Tray), !.
delta(60, move_tray(_, Place, Place2), 0.00048615386731728854) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(60, move_tray(_, _, _), -0.00017948184332810437) :- !.
delta(60, _, 0.0).

% tree 61: step size 1.0, 214 examples, 46 leaves
delta(61, make_sandwich_no_gluten(_, _, _), 0.08570474207589579) :- fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(61, make_sandwich_no_gluten(_, _, _), 0.02347950207854045) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(61, make_sandwich_no_gluten(_, _, _), -0.12636471540492963) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(61, make_sandwich_no_gluten(_, _, _), 0.09708308150388018) :- !.
delta(61, make_sandwich(_, _, _), 8.018863597152146e-5) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(61, make_sandwich(_, _, _), -0.09130597261724663) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(61, make_sandwich(_, _, _), -0.024770566614530202) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(61, make_sandwich(_, _, Content_portion), -0.003735643657639935) :- fewer_at_2_than_allergic_gluten, no_gluten_content(Content_portion), !.
delta(61, make_sandwich(_, _, _), 0.11349863241128362) :- fewer_at_2_than_allergic_gluten, !.
delta(61, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), fewer_at_1_than_not_allergic_gluten, !.
delta(61, make_sandwich(_, _, _), 0.00021410091791546437) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(61, make_sandwich(_, _, _), -0.0002608263054083793) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(61, make_sandwich(_, _, _), -0.000504300980414203) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_at_1_than_todo_served, !.
delta(61, make_sandwich(_, _, _), 0.0006493307967066003) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(61, make_sandwich(_, _, _), 0.0004600477215959434) :- done_served(Child), not_allergic_gluten(Child), !.
delta(61, make_sandwich(_, _, _), -0.13341265713238515) :- !.
delta(61, put_on_tray(_, Tray), -0.011747409758159614) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_allergic_gluten, !.
delta(61, put_on_tray(_, Tray), 0.003941043864591496) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(61, put_on_tray(_, _), 0.21198790865390466) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(61, put_on_tray(Sandwich, _), 0.0012602321379009231) :- no_gluten_sandwich(Sandwich), !.
delta(61, put_on_tray(_, _), -0.001580238456116011) :- !.
delta(61, serve_sandwich_no_gluten(_, _, _, _), -0.1879630896678201) :- fewer_ontray_1_than_todo_served, !.
delta(61, serve_sandwich_no_gluten(_, Child, _, _), 0.01096665884047208) :- todo_served(Child), !.
delta(61, serve_sandwich_no_gluten(_, _, _, _), -0.007126599387686234) :- !.
delta(61, serve_sandwich(_, Child, _, _), 0.001289272468287565) :- notexist(_), goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(61, serve_sandwich(_, _, _, _), -0.0004858548365220511) :- notexist(_), goal_served(Child), done_served(Child), !.
delta(61, serve_sandwich(_, _, _, _), 0.028489055544067308) :- notexist(_), !.
delta(61, serve_sandwich(_, _, Tray, _), -0.20001123656903175) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(61, serve_sandwich(_, Child, _, _), 0.0022245104263867318) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(61, serve_sandwich(_, _, _, _), -8.064116102725195e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(61, serve_sandwich(_, _, _, _), -3.404432043004525e-5) :- fewer_at_1_than_todo_served, !.
delta(61, serve_sandwich(_, _, _, _), 5.252256808841052e-5) :- !.
delta(61, move_tray(_, _, Place), -0.028318952831627404) :- allergic_gluten(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(61, move_tray(Tray, _, Place), 0.0010166138033907432) :- allergic_gluten(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place), !.
delta(61, move_tray(_, _, Place), -0.00031192538070777336) :- allergic_gluten(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place), !.
delta(61, move_tray(Tray, _, Place), 0.012498592653832656) :- allergic_gluten(Child), waiting(Child, Place), waiting(Child, Place2), needed_at_to_serve_sandwich_no_gluten(Place2), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(61, move_tray(_, _, Place), -0.0012589020735237464) :- allergic_gluten(Child), waiting(Child, Place), waiting(Child, Place2), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(61, move_tray(_, _, Place), -0.003033639466164547) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(61, move_tray(_, Place, Place2), 0.004892384836412187) :- notexist(_), at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_not_allergic_gluten, !.
delta(61, move_tray(_, Place, Place2), -5.482463136530263e-5) :- notexist(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(61, move_tray(_, _, _), -0.014949465953395769) :- notexist(_), !.
delta(61, move_tray(Tray, _, _), 0.20926058963958577) :- fewer_no_gluten_sandwich_than_todo_served, ontray(_, Tray), !.
delta(61, move_tray(_, _, _), -0.0004554918511220368) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(61, move_tray(_, Place, Place2), 0.0012052832762304438) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(61, move_tray(_, _, _), -0.004349031067510548) :- !.
delta(61, _, 0.0).

% tree 62: step size 1.0, 210 examples, 35 leaves
delta(62, make_sandwich_no_gluten(_, _, _), 0.017905825291348598) :- !.
delta(62, make_sandwich(_, _, _), 0.0027163744423391043) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(62, make_sandwich(_, _, _), -0.0027366885856792817) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(62, make_sandwich(_, _, _), -0.03745884878972933) :- fewer_at_2_than_todo_served, !.
delta(62, make_sandwich(_, _, _), -0.00033071118580268706) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(62, make_sandwich(_, _, _), 0.00040499656545097654) :- !.
delta(62, put_on_tray(_, _), -0.00011151461237574018) :- fewer_ontray_1_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(62, put_on_tray(_, _), 0.01300247279163781) :- fewer_ontray_1_than_todo_served, !.
delta(62, put_on_tray(_, _), -0.003756881948891219) :- !.
delta(62, serve_sandwich_no_gluten(_, _, _, _), 1.3963446230122871e-6) :- goal_served(Child), done_served(Child), fewer_at_1_than_allergic_gluten, !.
delta(62, serve_sandwich_no_gluten(_, _, _, _), 0.0031283523864326164) :- goal_served(Child), done_served(Child), !.
delta(62, serve_sandwich_no_gluten(_, _, _, _), -0.03689643216823639) :- at_kitchen_sandwich(_), !.
delta(62, serve_sandwich_no_gluten(_, _, _, _), 0.002347964248060581) :- !.
delta(62, serve_sandwich(_, _, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(62, serve_sandwich(_, _, _, _), -0.0005504264634963406) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_2_than_allergic_gluten, !.
delta(62, serve_sandwich(_, _, _, _), -0.24881562391168194) :- todo_served(Child), allergic_gluten(Child), !.
delta(62, serve_sandwich(Sandwich, _, _, _), -0.18535364659437317) :- no_gluten_sandwich(Sandwich), !.
delta(62, serve_sandwich(_, _, _, _), -0.012437779509605942) :- notexist(_), fewer_ontray_1_than_allergic_gluten, !.
delta(62, serve_sandwich(_, _, _, _), 0.0023645414024238702) :- notexist(_), !.
delta(62, serve_sandwich(_, Child, _, _), 0.2019725716990465) :- todo_served(Child), !.
delta(62, serve_sandwich(_, _, _, _), -0.0005073277712098815) :- !.
delta(62, move_tray(_, Place, kitchen), 0.000451726049520711) :- allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_todo_served, !.
delta(62, move_tray(_, Place, kitchen), -2.7581683134739063e-5) :- allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_allergic_gluten, !.
delta(62, move_tray(_, Place, _), -0.0005302200598640482) :- allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_allergic_gluten, !.
delta(62, move_tray(_, Place, _), -4.4986964579741146e-5) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(62, move_tray(_, Place, _), 0.29251277642661533) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(62, move_tray(_, Place, Place2), -6.520895816385633e-5) :- at_kitchen_bread(Bread_portion), at(Tray, Place), could_put_on_tray(Tray, Place2), no_gluten_bread(Bread_portion), !.
delta(62, move_tray(_, Place, Place2), 0.01509409956849707) :- at_kitchen_bread(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(62, move_tray(_, _, _), -0.010190894711436235) :- at_kitchen_bread(_), fewer_ontray_1_than_todo_served, !.
delta(62, move_tray(_, _, _), 0.0) :- at_kitchen_bread(_), !.
delta(62, move_tray(_, _, Place), 0.0043069914994947585) :- allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(62, move_tray(_, _, Place), -0.0015345790677901113) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(62, move_tray(_, Place, _), 0.0003194052255666311) :- done_served(Child), waiting(Child, Place), !.
delta(62, move_tray(_, _, _), -0.05225482917915557) :- !.
delta(62, _, 0.0).

% tree 63: step size 1.0, 272 examples, 35 leaves
delta(63, make_sandwich_no_gluten(_, _, _), 0.0009598091537539433) :- !.
delta(63, make_sandwich(_, _, _), -0.00027793849866901356) :- fewer_ontray_2_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(63, make_sandwich(_, _, _), 0.05022646692470435) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(63, make_sandwich(_, _, _), 0.002397138294615568) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(63, make_sandwich(_, _, _), -0.03267746202779694) :- !.
delta(63, put_on_tray(_, _), -0.03542555342599765) :- fewer_ontray_1_than_todo_served_allergic_gluten, at_kitchen_bread(_), !.
delta(63, put_on_tray(_, _), 0.00016985083364352607) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(63, put_on_tray(_, Tray), 0.01478177124622266) :- ontray(_, Tray), !.
delta(63, put_on_tray(_, _), -0.008713783515974812) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(63, put_on_tray(_, _), 0.0014304557266361822) :- !.
delta(63, serve_sandwich_no_gluten(_, Child, _, _), 0.008835887503325767) :- todo_served(Child), !.
delta(63, serve_sandwich_no_gluten(_, _, _, _), -0.0068972373636554596) :- !.
delta(63, serve_sandwich(Sandwich, Child, _, _), 0.00040740614031073565) :- no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), fewer_ontray_1_than_not_allergic_gluten, no_gluten_sandwich(Sandwich), todo_served(Child), !.
delta(63, serve_sandwich(Sandwich, _, _, _), -5.920828419044479e-5) :- no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), fewer_ontray_1_than_not_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(63, serve_sandwich(_, _, _, _), -0.12432999036317824) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(63, serve_sandwich(Sandwich, _, _, _), -0.11829972494820831) :- no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(63, serve_sandwich(Sandwich, _, _, _), 0.0012228012965996224) :- no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), no_gluten_sandwich(Sandwich), !.
delta(63, serve_sandwich(_, _, Tray, Place), -0.0009977217667323658) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(63, serve_sandwich(_, _, _, _), 0.11954836910117257) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(63, serve_sandwich(_, Child, _, Place), 0.00030081871495305374) :- todo_served(Child), fewer_ontray_2_than_allergic_gluten, done_served(Child2), waiting(Child2, Place), !.
delta(63, serve_sandwich(_, Child, _, _), 0.0) :- todo_served(Child), fewer_ontray_2_than_allergic_gluten, !.
delta(63, serve_sandwich(_, Child, _, _), 0.003995404117896668) :- todo_served(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(63, serve_sandwich(_, Child, _, _), 0.039372154668564134) :- todo_served(Child), !.
delta(63, serve_sandwich(_, _, _, _), -0.005737814040325803) :- !.
delta(63, move_tray(Tray, Place, Place2), -0.002840537289800338) :- could_serve_sandwich_no_gluten(Tray, Place2), at(Tray2, Place), could_put_on_tray(Tray2, Place), !.
delta(63, move_tray(Tray, _, Place), -0.00012444979411087471) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(63, move_tray(Tray, _, Place), 0.14002097272038014) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(63, move_tray(Tray, _, _), -0.08795461889437066) :- fewer_at_1_than_todo_served, ontray(_, Tray), !.
delta(63, move_tray(_, Place, Place2), 0.004432459035288211) :- fewer_at_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(63, move_tray(_, _, _), -0.00458106057488319) :- fewer_at_1_than_todo_served, !.
delta(63, move_tray(_, Place, Place2), -0.026575171144698463) :- todo_served(Child), waiting(Child, Place2), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(63, move_tray(_, _, Place), 0.013768221651373137) :- todo_served(Child), waiting(Child, Place), !.
delta(63, move_tray(_, Place, _), 0.031760380051853464) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(63, move_tray(_, _, _), -0.01777241621194086) :- !.
delta(63, _, 0.0).

% tree 64: step size 1.0, 217 examples, 41 leaves
delta(64, make_sandwich_no_gluten(_, _, _), 0.009142593896975757) :- fewer_ontray_1_than_allergic_gluten, !.
delta(64, make_sandwich_no_gluten(_, _, _), -0.023384155751163545) :- todo_served(Child), allergic_gluten(Child), !.
delta(64, make_sandwich_no_gluten(_, _, _), 0.001738350426720309) :- !.
delta(64, make_sandwich(_, _, _), 0.0003996279027351181) :- at_kitchen_sandwich(_), goal_served(Child), allergic_gluten(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(64, make_sandwich(_, _, _), -0.009240550878753346) :- at_kitchen_sandwich(_), goal_served(Child), allergic_gluten(Child), !.
delta(64, make_sandwich(_, _, _), 0.03755543204986541) :- at_kitchen_sandwich(_), !.
delta(64, make_sandwich(_, _, _), 2.5184530179586243e-6) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(64, make_sandwich(_, _, _), -0.00017644469184794858) :- no_gluten_sandwich(_), !.
delta(64, make_sandwich(_, _, _), -0.030903259973700754) :- !.
delta(64, put_on_tray(_, _), 0.01092550811579118) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(64, put_on_tray(_, _), 2.036057151157916e-6) :- no_gluten_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(64, put_on_tray(_, _), -0.0008615940624113402) :- no_gluten_sandwich(_), !.
delta(64, put_on_tray(_, Tray), -0.02412872686909101) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(64, put_on_tray(_, Tray), 0.00013580757399353073) :- ontray(_, Tray), !.
delta(64, put_on_tray(_, _), -0.0019176909949434756) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(64, put_on_tray(_, _), 0.004439579019984762) :- !.
delta(64, serve_sandwich_no_gluten(_, Child, _, _), 0.008695894420853187) :- todo_served(Child), !.
delta(64, serve_sandwich_no_gluten(_, _, _, _), -0.006382405700255982) :- !.
delta(64, serve_sandwich(Sandwich, _, _, _), -0.09436680655166113) :- no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(64, serve_sandwich(Sandwich, _, _, _), 0.04925335512838135) :- no_gluten_sandwich(Sandwich), !.
delta(64, serve_sandwich(_, _, _, _), 0.012024465830892783) :- notexist(_), done_served(Child), allergic_gluten(Child), fewer_ontray_1_than_todo_served, !.
delta(64, serve_sandwich(_, _, _, _), 0.0006031726799127882) :- notexist(_), done_served(Child), allergic_gluten(Child), !.
delta(64, serve_sandwich(_, Child, _, _), 0.10994009352146863) :- notexist(_), todo_served(Child), !.
delta(64, serve_sandwich(_, _, _, _), -9.702447219800558e-5) :- notexist(_), !.
delta(64, serve_sandwich(_, _, Tray, _), -0.04390643199216088) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(64, serve_sandwich(_, _, _, _), -0.003807926165111849) :- at_kitchen_sandwich(_), !.
delta(64, serve_sandwich(_, _, _, _), 0.002891022015804048) :- !.
delta(64, move_tray(Tray, Place, Place2), -0.0016732556196568512) :- not_allergic_gluten(Child), waiting(Child, Place2), at(Tray, kitchen), could_put_on_tray(Tray, Place), !.
delta(64, move_tray(Tray, _, Place), 0.027989277963054927) :- not_allergic_gluten(Child), waiting(Child, Place), at(Tray, kitchen), could_serve_sandwich(Tray, Place), !.
delta(64, move_tray(Tray, _, Place), -0.0007175787325737741) :- not_allergic_gluten(Child), waiting(Child, Place), at(Tray, kitchen), !.
delta(64, move_tray(_, _, Place), 0.00015864376126573085) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_at_2_than_allergic_gluten, !.
delta(64, move_tray(_, _, Place), -0.09064493676231125) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(64, move_tray(_, _, Place), 3.652850235752391e-5) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(64, move_tray(Tray, _, _), -0.0010363769119115954) :- fewer_ontray_1_than_todo_served, at(Tray, kitchen), !.
delta(64, move_tray(_, _, _), 0.054453554894044395) :- fewer_ontray_1_than_todo_served, fewer_no_gluten_sandwich_than_todo_served, !.
delta(64, move_tray(_, _, _), -0.000489932600443309) :- fewer_ontray_1_than_todo_served, !.
delta(64, move_tray(Tray, _, Place), 0.0016470419567625938) :- needed_at_to_serve_sandwich_no_gluten(Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(64, move_tray(_, _, Place), -0.001107311557413391) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(64, move_tray(_, _, _), 0.0005054723478332929) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(64, move_tray(_, _, _), -0.011844880612148428) :- !.
delta(64, _, 0.0).

% tree 65: step size 1.0, 212 examples, 35 leaves
delta(65, make_sandwich_no_gluten(_, _, _), 0.000908448951584151) :- fewer_at_2_than_allergic_gluten, !.
delta(65, make_sandwich_no_gluten(_, _, _), -0.19455493788216252) :- fewer_at_1_than_todo_served, !.
delta(65, make_sandwich_no_gluten(_, _, _), 0.000191496935913766) :- !.
delta(65, make_sandwich(_, _, _), -0.0023957097766324786) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(65, make_sandwich(_, _, Content_portion), -0.0007287012080886956) :- fewer_at_1_than_todo_served, no_gluten_content(Content_portion), !.
delta(65, make_sandwich(_, _, _), 0.19460681808163946) :- fewer_at_1_than_todo_served, !.
delta(65, make_sandwich(_, _, _), -0.002471530742255718) :- todo_served(Child), allergic_gluten(Child), !.
delta(65, make_sandwich(_, _, _), 1.3930026183921309e-5) :- !.
delta(65, put_on_tray(Sandwich, _), 0.0100217476518877) :- no_gluten_sandwich(Sandwich), !.
delta(65, put_on_tray(_, Tray), -0.046621697911432974) :- ontray(_, Tray), notexist(_), !.
delta(65, put_on_tray(_, Tray), 0.00018618115188520553) :- ontray(_, Tray), !.
delta(65, put_on_tray(_, _), -0.00026456033869060134) :- todo_served(Child), allergic_gluten(Child), !.
delta(65, put_on_tray(_, _), 0.005320007940275533) :- !.
delta(65, serve_sandwich_no_gluten(_, _, _, _), -0.15790144731335376) :- fewer_at_1_than_todo_served, !.
delta(65, serve_sandwich_no_gluten(_, _, _, _), 0.00035852337892643946) :- !.
delta(65, serve_sandwich(Sandwich, _, _, _), -0.03051552711572148) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(65, serve_sandwich(Sandwich, _, _, _), 0.0014918423264191326) :- no_gluten_sandwich(Sandwich), !.
delta(65, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), allergic_gluten(Child), !.
delta(65, serve_sandwich(_, _, _, _), 0.0036984664552858646) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(65, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_bread(_), !.
delta(65, serve_sandwich(_, Child, _, _), 0.14976649765467437) :- todo_served(Child), !.
delta(65, serve_sandwich(_, _, _, _), -0.0010020418239526797) :- !.
delta(65, move_tray(_, Place, Place2), 0.0008824529039183072) :- at(Tray, Place), could_put_on_tray(Tray, Place2), done_served(Child), allergic_gluten(Child), fewer_at_1_than_allergic_gluten, !.
delta(65, move_tray(_, Place, Place2), 0.0005608709256667712) :- at(Tray, Place), could_put_on_tray(Tray, Place2), done_served(Child), allergic_gluten(Child), waiting(Child, Place), !.
delta(65, move_tray(_, Place, Place2), -0.009240007814760268) :- at(Tray, Place), could_put_on_tray(Tray, Place2), done_served(Child), allergic_gluten(Child), !.
delta(65, move_tray(_, Place, Place2), 0.03896278418873859) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_no_gluten_sandwich_than_todo_served, !.
delta(65, move_tray(_, Place, Place2), 0.00041349000975211126) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(65, move_tray(_, Place, Place2), -0.003866479403411222) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(65, move_tray(_, _, _), -0.0015496125383617724) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(65, move_tray(Tray, _, Place), 0.023007329149038698) :- fewer_at_1_than_todo_served_allergic_gluten, could_serve_sandwich_no_gluten(Tray, Place), !.
delta(65, move_tray(_, _, _), -8.949908508033823e-5) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(65, move_tray(_, _, _), -0.13943035094324144) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(65, move_tray(Tray, _, Place), 0.003711355961062782) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(65, move_tray(_, _, _), -0.0011235204158397472) :- !.
delta(65, _, 0.0).

% tree 66: step size 1.0, 204 examples, 45 leaves
delta(66, make_sandwich_no_gluten(_, _, _), 0.025194154838379793) :- fewer_at_1_than_not_allergic_gluten, fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(66, make_sandwich_no_gluten(_, _, _), -0.026355166642474077) :- fewer_at_1_than_not_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(66, make_sandwich_no_gluten(_, _, _), 0.050402813056524526) :- fewer_at_1_than_not_allergic_gluten, !.
delta(66, make_sandwich_no_gluten(_, _, _), 0.00044520174793255405) :- at_kitchen_sandwich(_), !.
delta(66, make_sandwich_no_gluten(_, _, _), -0.05354350866157407) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(66, make_sandwich_no_gluten(_, _, _), 0.0001711867797585247) :- !.
delta(66, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_todo_served_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(66, make_sandwich(_, _, _), -0.004443985095719766) :- fewer_at_1_than_todo_served_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(66, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_todo_served_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(66, make_sandwich(_, _, _), -0.07403846389141765) :- fewer_at_1_than_todo_served_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), !.
delta(66, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(66, make_sandwich(_, _, _), 0.00018886802817163098) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(66, make_sandwich(_, _, _), 8.953281515591089e-6) :- no_gluten_sandwich(_), done_served(Child), not_allergic_gluten(Child), !.
delta(66, make_sandwich(_, _, _), -0.004971396488939885) :- no_gluten_sandwich(_), !.
delta(66, make_sandwich(_, _, _), 0.05343190974047547) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(66, make_sandwich(_, _, _), -0.00016957392598016712) :- !.
delta(66, put_on_tray(_, Tray), 4.458761906651318e-6) :- ontray(_, Tray), done_served(Child), allergic_gluten(Child), !.
delta(66, put_on_tray(_, Tray), 0.020597939006154524) :- ontray(_, Tray), !.
delta(66, put_on_tray(_, _), 0.0037116174932693255) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(66, put_on_tray(_, _), 3.94157400350918e-6) :- fewer_at_1_than_todo_served, !.
delta(66, put_on_tray(_, _), -0.012416186380917902) :- goal_served(Child), allergic_gluten(Child), !.
delta(66, put_on_tray(_, _), 1.3914443904823777e-6) :- !.
delta(66, serve_sandwich_no_gluten(_, Child, _, _), 0.00505569016299265) :- todo_served(Child), !.
delta(66, serve_sandwich_no_gluten(_, _, _, _), -0.12158605442143479) :- !.
delta(66, serve_sandwich(_, _, _, _), -0.1451605674327637) :- fewer_ontray_1_than_todo_served, notexist(_), !.
delta(66, serve_sandwich(_, _, _, _), -2.8599644812992313e-5) :- fewer_ontray_1_than_todo_served, !.
delta(66, serve_sandwich(_, Child, Tray, _), 0.1400013697265232) :- goal_served(Child2), done_served(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place), todo_served(Child), !.
delta(66, serve_sandwich(_, _, Tray, _), -0.0006307757635493537) :- goal_served(Child), done_served(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(66, serve_sandwich(_, _, _, _), -3.9211621544293465e-5) :- goal_served(Child), done_served(Child), notexist(_), !.
delta(66, serve_sandwich(_, _, _, _), 0.006082539120038729) :- goal_served(Child), done_served(Child), !.
delta(66, serve_sandwich(_, _, _, _), 0.00039022160201054537) :- !.
delta(66, move_tray(Tray, Place, Place2), -0.02693564161639569) :- notexist(_), done_served(Child), waiting(Child, Place2), could_serve_sandwich(Tray, Place), !.
delta(66, move_tray(_, _, Place), -0.0003439417586648241) :- notexist(_), done_served(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(66, move_tray(_, _, Place), 0.01938225105769552) :- notexist(_), done_served(Child), waiting(Child, Place), !.
delta(66, move_tray(_, Place, _), 0.28325554664894215) :- notexist(_), todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(66, move_tray(_, Place, _), -0.002633012894245933) :- notexist(_), todo_served(Child), waiting(Child, Place), !.
delta(66, move_tray(_, _, kitchen), 0.01908492337540725) :- notexist(_), !.
delta(66, move_tray(_, _, _), -0.021763370892139217) :- notexist(_), !.
delta(66, move_tray(_, Place, Place2), -0.0006209573595177654) :- at(Tray, Place), could_put_on_tray(Tray, Place2), done_served(Child), allergic_gluten(Child), !.
delta(66, move_tray(_, Place, Place2), -0.00027958202264501993) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(66, move_tray(_, Place, Place2), 0.011772952973761642) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(66, move_tray(_, _, Place), 0.000828605483724515) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(66, move_tray(_, _, Place), -0.00018769096128647277) :- done_served(Child), waiting(Child, Place), !.
delta(66, move_tray(_, _, _), -0.04197857564614151) :- !.
delta(66, _, 0.0).

% tree 67: step size 1.0, 214 examples, 37 leaves
delta(67, make_sandwich_no_gluten(_, _, _), 0.10562208560255419) :- !.
delta(67, make_sandwich(_, _, _), 0.0) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, fewer_at_1_than_allergic_gluten, !.
delta(67, make_sandwich(_, _, _), 0.0005199635530130445) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(67, make_sandwich(_, _, _), -5.0126018660227376e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(67, make_sandwich(_, _, _), -0.17283023726709557) :- !.
delta(67, put_on_tray(_, Tray), 0.0) :- fewer_ontray_1_than_todo_served, ontray(_, Tray), fewer_ontray_1_than_allergic_gluten, !.
delta(67, put_on_tray(_, Tray), 0.010159477768031812) :- fewer_ontray_1_than_todo_served, ontray(_, Tray), !.
delta(67, put_on_tray(Sandwich, _), 0.004714003504616806) :- fewer_ontray_1_than_todo_served, no_gluten_sandwich(Sandwich), !.
delta(67, put_on_tray(_, _), 0.00035380241634737597) :- fewer_ontray_1_than_todo_served, goal_served(Child), done_served(Child), !.
delta(67, put_on_tray(_, _), -0.0058963973110346185) :- fewer_ontray_1_than_todo_served, !.
delta(67, put_on_tray(_, _), -0.0033368062183839133) :- !.
delta(67, serve_sandwich_no_gluten(_, _, _, _), 0.00014185501375890805) :- notexist(_), at_kitchen_sandwich(_), !.
delta(67, serve_sandwich_no_gluten(Sandwich, _, _, Place), -0.07302397047829572) :- notexist(_), ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(67, serve_sandwich_no_gluten(_, _, _, _), 5.3662505743130353e-5) :- notexist(_), !.
delta(67, serve_sandwich_no_gluten(_, _, _, _), 0.004457945217763716) :- !.
delta(67, serve_sandwich(_, _, _, _), 0.0) :- no_gluten_sandwich(_), at_kitchen_bread(_), !.
delta(67, serve_sandwich(_, _, _, _), -0.5136732755121078) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_2_than_todo_served, !.
delta(67, serve_sandwich(_, _, _, _), 0.0009458396152103067) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(67, serve_sandwich(_, _, _, _), -0.03597159232067606) :- no_gluten_sandwich(_), at_kitchen_sandwich(_), !.
delta(67, serve_sandwich(_, _, _, _), 0.0010570278760277014) :- no_gluten_sandwich(_), !.
delta(67, serve_sandwich(_, Child, _, _), 0.014932268094606743) :- todo_served(Child), !.
delta(67, serve_sandwich(_, _, _, _), -0.0012576595900767936) :- !.
delta(67, move_tray(Tray, Place, Place2), 0.0023806821310146157) :- allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place2), todo_served(Child2), allergic_gluten(Child2), could_serve_sandwich(Tray, Place), !.
delta(67, move_tray(Tray, Place, Place2), -0.00037265952693639584) :- allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place2), todo_served(Child2), allergic_gluten(Child2), !.
delta(67, move_tray(Tray, Place, Place2), -0.0017705402764671963) :- allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place2), !.
delta(67, move_tray(_, Place, kitchen), 0.0006742399983752284) :- allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(67, move_tray(_, Place, _), -0.00018881712274565363) :- allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(67, move_tray(_, Place, _), -0.02972597926902619) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(67, move_tray(_, _, _), -0.0004927061125361145) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(67, move_tray(_, _, _), 0.5942272535880269) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(67, move_tray(_, Place, Place2), 0.0007540620763869782) :- no_gluten_sandwich(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(67, move_tray(_, _, _), -0.0020353679347788773) :- no_gluten_sandwich(_), !.
delta(67, move_tray(_, Place, Place2), 0.0006306820737652019) :- fewer_at_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(67, move_tray(_, _, _), -0.01981055417712397) :- fewer_at_1_than_todo_served, !.
delta(67, move_tray(_, Place, _), 0.022903044474805748) :- done_served(Child), waiting(Child, Place), !.
delta(67, move_tray(_, _, _), -0.00022443928026907593) :- !.
delta(67, _, 0.0).

% tree 68: step size 1.0, 205 examples, 44 leaves
delta(68, make_sandwich_no_gluten(_, _, _), 0.000939861111633673) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(68, make_sandwich_no_gluten(_, _, _), -0.14612632873717965) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_2_than_allergic_gluten, !.
delta(68, make_sandwich_no_gluten(_, _, _), 8.247189237274471e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(68, make_sandwich_no_gluten(_, _, _), 0.030165303091313607) :- !.
delta(68, make_sandwich(_, Bread_portion, _), -0.003508470878618546) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion2), no_gluten_bread(Bread_portion2), no_gluten_bread(Bread_portion), !.
delta(68, make_sandwich(_, _, _), 0.11639095193623797) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(68, make_sandwich(_, _, _), -0.0036862439988733786) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(68, make_sandwich(_, _, _), -0.08450700820947478) :- goal_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, !.
delta(68, make_sandwich(_, _, _), 0.0008412040569658819) :- goal_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(68, make_sandwich(_, _, _), -0.0001836341005520468) :- goal_served(Child), allergic_gluten(Child), !.
delta(68, make_sandwich(_, _, _), 0.01672742352152728) :- !.
delta(68, put_on_tray(Sandwich, _), 0.0009779128860728748) :- no_gluten_sandwich(_), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(68, put_on_tray(Sandwich, _), -0.01700148167715392) :- no_gluten_sandwich(_), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(68, put_on_tray(Sandwich, _), 2.5505753915189957e-6) :- no_gluten_sandwich(_), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(68, put_on_tray(Sandwich, _), 0.003054564438301385) :- no_gluten_sandwich(_), no_gluten_sandwich(Sandwich), !.
delta(68, put_on_tray(_, _), 0.037535850029314734) :- no_gluten_sandwich(_), fewer_ontray_2_than_not_allergic_gluten, !.
delta(68, put_on_tray(_, _), -0.00349606550561794) :- no_gluten_sandwich(_), !.
delta(68, put_on_tray(_, Tray), -0.019633207774010075) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(68, put_on_tray(_, Tray), 8.422962057589014e-5) :- ontray(_, Tray), !.
delta(68, put_on_tray(_, _), 0.0030727148188502626) :- !.
delta(68, serve_sandwich_no_gluten(_, _, _, _), -0.009760469607579356) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(68, serve_sandwich_no_gluten(_, _, _, _), 5.054338290054013e-7) :- fewer_at_1_than_allergic_gluten, !.
delta(68, serve_sandwich_no_gluten(_, _, _, _), 0.003774983202999075) :- !.
delta(68, serve_sandwich(_, _, _, _), 0.000888085479383876) :- fewer_ontray_2_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(68, serve_sandwich(_, _, _, _), -0.20536220560039126) :- fewer_ontray_2_than_allergic_gluten, !.
delta(68, serve_sandwich(_, Child, _, _), 0.09755736828990695) :- fewer_ontray_1_than_not_allergic_gluten, goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(68, serve_sandwich(_, _, _, _), -7.975764648480078e-5) :- fewer_ontray_1_than_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(68, serve_sandwich(_, _, _, _), 0.0021041248028495925) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(68, serve_sandwich(Sandwich, _, _, _), -0.00014138526993098965) :- no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(68, serve_sandwich(Sandwich, _, _, _), 0.05558338286892767) :- no_gluten_sandwich(Sandwich), !.
delta(68, serve_sandwich(_, _, _, _), 0.0025640850046462263) :- goal_served(Child), allergic_gluten(Child), !.
delta(68, serve_sandwich(_, _, _, _), -0.055557496840573956) :- !.
delta(68, move_tray(Tray, _, _), -0.0038339325109706824) :- fewer_ontray_2_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(68, move_tray(Tray, _, Place), 0.0031400043639130586) :- fewer_ontray_2_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), waiting(Child, Place), !.
delta(68, move_tray(Tray, _, _), -0.00011344641209581464) :- fewer_ontray_2_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(68, move_tray(_, _, _), 0.23981833991069182) :- fewer_ontray_2_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, notexist(_), !.
delta(68, move_tray(_, _, _), 0.0) :- fewer_ontray_2_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(68, move_tray(_, Place, Place2), 0.00034346238654028285) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(68, move_tray(_, _, _), -0.00223427320541916) :- fewer_ontray_2_than_allergic_gluten, !.
delta(68, move_tray(Tray, _, Place), -0.0013804366278675228) :- could_serve_sandwich_no_gluten(Tray, Place), at_kitchen_sandwich(_), notexist(_), !.
delta(68, move_tray(Tray, _, Place), 0.012485301767867402) :- could_serve_sandwich_no_gluten(Tray, Place), at_kitchen_sandwich(_), !.
delta(68, move_tray(Tray, _, Place), -0.00385997364343576) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(68, move_tray(_, _, _), -0.0669858697294323) :- !.
delta(68, _, 0.0).

% tree 69: step size 1.0, 202 examples, 34 leaves
delta(69, make_sandwich_no_gluten(_, _, _), 0.0250154877266617) :- !.
delta(69, make_sandwich(_, _, _), -0.035012534975049636) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(69, make_sandwich(_, _, _), -0.012067503802554573) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(69, make_sandwich(_, _, _), 2.0057676519605152e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(69, make_sandwich(_, _, _), -3.151398410293578e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(69, make_sandwich(_, _, _), 0.06118249019543522) :- !.
delta(69, put_on_tray(_, Tray), -0.007896157233355733) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), fewer_ontray_1_than_allergic_gluten, !.
delta(69, put_on_tray(_, Tray), 0.005409610326831272) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), fewer_no_gluten_sandwich_than_todo_served, !.
delta(69, put_on_tray(_, Tray), -0.00016145439477565198) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), !.
delta(69, put_on_tray(_, _), 0.02356404338744487) :- no_gluten_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(69, put_on_tray(_, _), -0.00021664737290729019) :- no_gluten_sandwich(_), !.
delta(69, put_on_tray(_, _), -0.04009852535202732) :- at_kitchen_bread(_), !.
delta(69, put_on_tray(_, _), 0.00014046424099399045) :- !.
delta(69, serve_sandwich_no_gluten(_, _, _, _), -0.029637797587583867) :- fewer_at_1_than_allergic_gluten, !.
delta(69, serve_sandwich_no_gluten(_, _, _, _), 0.0001859441675976616) :- !.
delta(69, serve_sandwich(_, _, _, _), -0.0127579071261717) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(69, serve_sandwich(_, Child, _, _), -1.83945427198658e-5) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(69, serve_sandwich(_, Child, _, _), 0.050050064714490285) :- todo_served(Child), !.
delta(69, serve_sandwich(_, _, _, _), -0.005917047198832555) :- !.
delta(69, move_tray(Tray, Place, Place2), -0.00010738730623901966) :- goal_served(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place2), fewer_at_1_than_allergic_gluten, could_serve_sandwich(Tray, Place), !.
delta(69, move_tray(_, Place, Place2), 0.008354468828239679) :- goal_served(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place2), fewer_at_1_than_allergic_gluten, !.
delta(69, move_tray(_, Place, Place2), -0.002242928488958665) :- goal_served(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place2), !.
delta(69, move_tray(Tray, Place, _), 0.004117815908422833) :- goal_served(Child), waiting(Child, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(69, move_tray(Tray, Place, _), -2.2360330930205e-5) :- goal_served(Child), waiting(Child, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(69, move_tray(_, Place, _), -0.07521078747547313) :- goal_served(Child), waiting(Child, Place), notexist(_), !.
delta(69, move_tray(_, Place, _), 0.0015961595255014783) :- goal_served(Child), waiting(Child, Place), !.
delta(69, move_tray(_, _, Place), -0.005706016959739218) :- allergic_gluten(Child), waiting(Child, Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(69, move_tray(Tray, _, Place), 0.0023453976470886573) :- allergic_gluten(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(69, move_tray(_, _, Place), -0.0005828820342648987) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(69, move_tray(_, _, _), -0.0006267958007832573) :- no_gluten_sandwich(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(69, move_tray(_, _, _), 0.037641353988423235) :- no_gluten_sandwich(_), !.
delta(69, move_tray(_, _, Place), 7.625488721579396e-5) :- done_served(Child), waiting(Child, Place), !.
delta(69, move_tray(_, _, _), -0.000989090686686786) :- !.
delta(69, _, 0.0).

% tree 70: step size 1.0, 221 examples, 41 leaves
delta(70, make_sandwich_no_gluten(_, _, _), 0.009559632598778844) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(70, make_sandwich_no_gluten(_, _, _), -0.41570325189296276) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(70, make_sandwich_no_gluten(_, _, _), 5.7794420699136825e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(70, make_sandwich_no_gluten(_, _, _), 0.05223093152333812) :- !.
delta(70, make_sandwich(_, _, _), -0.014054257264404946) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(70, make_sandwich(_, Bread_portion, _), -0.0015197641636909202) :- fewer_at_1_than_todo_served_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(70, make_sandwich(_, _, _), 0.407241084485308) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(70, make_sandwich(_, _, _), 0.021537647471021) :- done_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(70, make_sandwich(_, _, _), -0.0006986427246196393) :- done_served(Child), allergic_gluten(Child), !.
delta(70, make_sandwich(_, Bread_portion, _), 0.010735022884593437) :- no_gluten_bread(Bread_portion), todo_served(Child), not_allergic_gluten(Child), !.
delta(70, make_sandwich(_, Bread_portion, _), -8.628592977384306e-5) :- no_gluten_bread(Bread_portion), !.
delta(70, make_sandwich(_, _, _), -0.06750456387357301) :- todo_served(Child), allergic_gluten(Child), !.
delta(70, make_sandwich(_, _, _), 5.99966392027036e-6) :- !.
delta(70, put_on_tray(_, Tray), 0.03854678467720253) :- ontray(_, Tray), !.
delta(70, put_on_tray(_, _), -0.012071598302964889) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(70, put_on_tray(Sandwich, _), 0.004656494813983569) :- no_gluten_sandwich(Sandwich), !.
delta(70, put_on_tray(_, _), 0.0021272712094245827) :- notexist(_), !.
delta(70, put_on_tray(_, _), -0.004086148948420613) :- !.
delta(70, serve_sandwich_no_gluten(_, _, _, _), 0.001058753827109602) :- goal_served(Child), done_served(Child), goal_served(Child2), not_allergic_gluten(Child2), !.
delta(70, serve_sandwich_no_gluten(_, _, _, _), 1.7819777271797159e-6) :- goal_served(Child), done_served(Child), !.
delta(70, serve_sandwich_no_gluten(_, _, _, _), -0.021866353359275316) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(70, serve_sandwich_no_gluten(_, _, _, _), 5.0559426598762204e-5) :- !.
delta(70, serve_sandwich(Sandwich, _, _, _), -0.028141363061786044) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(70, serve_sandwich(Sandwich, _, _, _), 0.1290401336270211) :- no_gluten_sandwich(Sandwich), !.
delta(70, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_2_than_todo_served, at_kitchen_bread(_), !.
delta(70, serve_sandwich(_, _, _, _), 2.255280470839008e-5) :- fewer_ontray_2_than_todo_served, fewer_ontray_1_than_allergic_gluten, !.
delta(70, serve_sandwich(_, _, _, _), -0.23534358894481333) :- fewer_ontray_2_than_todo_served, !.
delta(70, serve_sandwich(_, Child, _, _), 0.0015408273886945865) :- todo_served(Child), !.
delta(70, serve_sandwich(_, _, _, _), -0.000586041908592107) :- !.
delta(70, move_tray(_, Place, Place2), -0.004189623868725388) :- todo_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(70, move_tray(_, Place, _), -0.0017337597814818951) :- todo_served(Child), waiting(Child, Place), fewer_no_gluten_sandwich_than_todo_served, at_kitchen_bread(_), !.
delta(70, move_tray(_, Place, _), 0.26847978252533283) :- todo_served(Child), waiting(Child, Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(70, move_tray(_, Place, _), -0.003119730386009853) :- todo_served(Child), waiting(Child, Place), !.
delta(70, move_tray(_, Place, Place2), 0.005351142271722403) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_no_gluten_sandwich_than_todo_served, !.
delta(70, move_tray(_, Place, Place2), -6.913191289866928e-5) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(70, move_tray(_, _, _), -0.034014043406730705) :- fewer_ontray_1_than_todo_served, !.
delta(70, move_tray(_, _, kitchen), 0.0005606221301504266) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(70, move_tray(_, _, kitchen), -0.014830056991723519) :- !.
delta(70, move_tray(Tray, _, _), 0.022028914994916663) :- ontray(_, Tray), !.
delta(70, move_tray(_, _, _), -0.0018623013804976273) :- !.
delta(70, _, 0.0).

% tree 71: step size 1.0, 215 examples, 38 leaves
delta(71, make_sandwich_no_gluten(_, _, _), 0.00620385045468978) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(71, make_sandwich_no_gluten(_, _, _), -0.19768455549631436) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(71, make_sandwich_no_gluten(_, _, _), 0.0003844431507396502) :- !.
delta(71, make_sandwich(_, _, _), -0.036654893286598954) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(71, make_sandwich(_, _, _), -2.647444800515342e-5) :- goal_served(Child), done_served(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(71, make_sandwich(_, _, _), 0.005380791853192205) :- goal_served(Child), done_served(Child), !.
delta(71, make_sandwich(_, _, _), -0.006409799099921298) :- fewer_at_1_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(71, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_allergic_gluten, !.
delta(71, make_sandwich(_, _, Content_portion), -0.006704725622722569) :- no_gluten_content(Content_portion), !.
delta(71, make_sandwich(_, Bread_portion, _), -0.006028978719420334) :- no_gluten_bread(Bread_portion), !.
delta(71, make_sandwich(_, _, _), 0.16796849325016946) :- !.
delta(71, put_on_tray(_, Tray), 0.01813959949044841) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(71, put_on_tray(_, Tray), -0.0004487700523706064) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(71, put_on_tray(_, _), 0.0006375739326645863) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(71, put_on_tray(_, _), -0.030993906391927506) :- at_kitchen_bread(_), !.
delta(71, put_on_tray(_, _), 0.00011912996390879641) :- !.
delta(71, serve_sandwich_no_gluten(_, Child, _, _), 0.0) :- todo_served(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(71, serve_sandwich_no_gluten(_, Child, _, _), 0.002899153834326463) :- todo_served(Child), !.
delta(71, serve_sandwich_no_gluten(_, _, _, _), -0.045934940634658826) :- !.
delta(71, serve_sandwich(_, _, _, _), 0.030690732881452364) :- at_kitchen_sandwich(_), done_served(Child), allergic_gluten(Child), !.
delta(71, serve_sandwich(_, _, _, _), -0.13985877713007452) :- at_kitchen_sandwich(_), !.
delta(71, serve_sandwich(_, Child, _, _), 0.030853894212801887) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(71, serve_sandwich(_, _, _, _), -0.0012810795217245753) :- goal_served(Child), done_served(Child), !.
delta(71, serve_sandwich(_, _, _, _), -2.0524110525418497e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(71, serve_sandwich(_, _, _, _), 2.8874904397744772e-5) :- !.
delta(71, move_tray(Tray, _, kitchen), -0.043800422541802886) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(71, move_tray(_, _, kitchen), 0.08029920190214816) :- done_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(71, move_tray(_, _, kitchen), -0.0062408506143153235) :- done_served(Child), not_allergic_gluten(Child), !.
delta(71, move_tray(_, _, kitchen), 0.00028469902843269155) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(71, move_tray(_, _, kitchen), -0.07202234422898633) :- !.
delta(71, move_tray(_, _, _), -0.00040292063306214494) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_at_2_than_todo_served_allergic_gluten, !.
delta(71, move_tray(_, _, Place), -0.000281953022842709) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(71, move_tray(_, _, _), 0.22163832615521584) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(71, move_tray(_, Place, Place2), 0.0020613442365311394) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place2), !.
delta(71, move_tray(_, Place, _), -0.00022113675841702523) :- done_served(Child), waiting(Child, Place), !.
delta(71, move_tray(_, _, _), -0.02276353558412755) :- fewer_ontray_2_than_todo_served, !.
delta(71, move_tray(_, _, _), 0.0008522380373855996) :- !.
delta(71, _, 0.0).

% tree 72: step size 1.0, 223 examples, 32 leaves
delta(72, make_sandwich_no_gluten(_, _, _), 0.0032640588402702174) :- at_kitchen_sandwich(_), !.
delta(72, make_sandwich_no_gluten(_, _, _), 0.0) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(72, make_sandwich_no_gluten(_, _, _), 0.00023598794129570894) :- !.
delta(72, make_sandwich(_, _, _), -0.014286733198363965) :- at_kitchen_sandwich(_), !.
delta(72, make_sandwich(_, _, _), 0.0009172460966134614) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(72, make_sandwich(_, _, _), -0.00017095431887117192) :- !.
delta(72, put_on_tray(_, _), 0.01936569871516314) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(72, put_on_tray(Sandwich, _), 0.0011015519147871153) :- no_gluten_sandwich(Sandwich), !.
delta(72, put_on_tray(_, _), -0.0012620245279210292) :- !.
delta(72, serve_sandwich_no_gluten(_, Child, _, _), 0.0) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(72, serve_sandwich_no_gluten(_, Child, _, _), 0.003864703446003083) :- todo_served(Child), !.
delta(72, serve_sandwich_no_gluten(_, _, _, _), -0.003934698645627748) :- !.
delta(72, serve_sandwich(Sandwich, _, _, _), -0.049017500520734836) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(72, serve_sandwich(Sandwich, _, _, _), 0.00018701490839486274) :- no_gluten_sandwich(Sandwich), !.
delta(72, serve_sandwich(_, _, _, Place), 3.800800111392905e-5) :- done_served(Child), not_allergic_gluten(Child), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(72, serve_sandwich(_, Child, _, _), 0.0326356924965698) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(72, serve_sandwich(_, _, _, _), -0.0010919052064233621) :- done_served(Child), not_allergic_gluten(Child), !.
delta(72, serve_sandwich(_, _, _, _), -0.0027386852467649533) :- todo_served(Child), allergic_gluten(Child), !.
delta(72, serve_sandwich(_, _, _, _), 2.9226297048017844e-5) :- !.
delta(72, move_tray(_, Place, Place2), 0.0008051880700803174) :- at(Tray, Place), could_put_on_tray(Tray, Place2), allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(72, move_tray(Tray, Place, Place2), 0.000339381679207965) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(72, move_tray(_, Place, Place2), -0.008089131383301371) :- at(Tray, Place), could_put_on_tray(Tray, Place2), allergic_gluten(Child), waiting(Child, Place), !.
delta(72, move_tray(_, Place, Place2), -0.00248855102947663) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(72, move_tray(_, Place, Place2), 0.07422342799603238) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(72, move_tray(_, _, Place), -5.161310495331367e-5) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), allergic_gluten(Child), !.
delta(72, move_tray(_, _, Place), 0.011953163586182576) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(72, move_tray(_, _, Place), -0.001470122680644289) :- done_served(Child), waiting(Child, Place), !.
delta(72, move_tray(_, Place, Place2), 0.0015763100128462877) :- fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(72, move_tray(_, _, _), -0.0013480346412758982) :- fewer_ontray_1_than_allergic_gluten, !.
delta(72, move_tray(_, _, _), 5.119206933145646e-22) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(72, move_tray(_, _, _), -0.06370517033941932) :- !.
delta(72, _, 0.0).

% tree 73: step size 1.0, 235 examples, 35 leaves
delta(73, make_sandwich_no_gluten(_, _, _), 0.005067626862817037) :- fewer_at_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(73, make_sandwich_no_gluten(_, _, _), 0.03623949574780901) :- fewer_at_1_than_not_allergic_gluten, !.
delta(73, make_sandwich_no_gluten(_, _, _), -0.04476256757855155) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(73, make_sandwich_no_gluten(_, _, _), 6.822873108326821e-5) :- !.
delta(73, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_2_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(73, make_sandwich(_, _, _), -0.0033373895898263653) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_2_than_allergic_gluten, !.
delta(73, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_at_2_than_allergic_gluten, !.
delta(73, make_sandwich(_, _, _), 0.010539956495109077) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(73, make_sandwich(_, _, _), 0.005467881726550841) :- fewer_at_1_than_todo_served_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(73, make_sandwich(_, _, _), -0.06342383242642236) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(73, make_sandwich(_, _, _), -0.00036390710739708256) :- at_kitchen_sandwich(_), !.
delta(73, make_sandwich(_, _, _), 0.06626811021780106) :- fewer_ontray_2_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(73, make_sandwich(_, _, _), -2.176925568935462e-5) :- fewer_ontray_2_than_todo_served, !.
delta(73, make_sandwich(_, _, _), -2.801209892693601e-5) :- !.
delta(73, put_on_tray(_, _), -0.001610838649945686) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(73, put_on_tray(_, _), 0.0177626663446835) :- !.
delta(73, serve_sandwich_no_gluten(_, _, _, _), -0.010229933548880413) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(73, serve_sandwich_no_gluten(_, _, _, _), 1.1130517499871605e-6) :- done_served(Child), allergic_gluten(Child), !.
delta(73, serve_sandwich_no_gluten(_, _, _, _), 0.002307494266235194) :- !.
delta(73, serve_sandwich(Sandwich, _, _, _), -0.1752356915261831) :- no_gluten_sandwich(Sandwich), !.
delta(73, serve_sandwich(_, _, _, _), 0.18247596628185075) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(73, serve_sandwich(_, _, _, _), 0.007186048064904459) :- no_gluten_bread(_), goal_served(Child), allergic_gluten(Child), !.
delta(73, serve_sandwich(_, _, _, _), -0.03702436137612571) :- no_gluten_bread(_), !.
delta(73, serve_sandwich(_, _, _, _), 0.03133395242871096) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(73, serve_sandwich(_, _, _, _), 2.3049638761394265e-5) :- !.
delta(73, move_tray(_, Place, kitchen), -0.010030884462814008) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(73, move_tray(_, _, kitchen), 0.0714125376562315) :- fewer_ontray_1_than_todo_served, !.
delta(73, move_tray(_, _, kitchen), -0.004612952971187126) :- !.
delta(73, move_tray(_, _, _), -5.649525862392038e-6) :- fewer_ontray_2_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(73, move_tray(_, _, _), -0.10135089532529346) :- fewer_ontray_2_than_todo_served, !.
delta(73, move_tray(_, Place, Place2), 3.2854441936647584e-5) :- allergic_gluten(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place2), !.
delta(73, move_tray(_, Place, _), -0.00167835401465547) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(73, move_tray(_, _, Place), 0.00450895593376558) :- todo_served(Child), waiting(Child, Place), !.
delta(73, move_tray(_, _, _), -0.00042863472816245525) :- !.
delta(73, _, 0.0).

% tree 74: step size 1.0, 245 examples, 31 leaves
delta(74, make_sandwich_no_gluten(_, _, _), 0.03151145045306173) :- !.
delta(74, make_sandwich(_, _, _), -0.0542492062603418) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(74, make_sandwich(_, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(74, make_sandwich(_, _, _), -0.0002794934212113826) :- todo_served(Child), allergic_gluten(Child), !.
delta(74, make_sandwich(_, _, _), 0.0560734726405909) :- !.
delta(74, put_on_tray(_, Tray), 0.0036786732059112728) :- ontray(_, Tray), goal_served(Child), allergic_gluten(Child), !.
delta(74, put_on_tray(_, Tray), -0.06933323952683162) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(74, put_on_tray(_, Tray), 0.0001819613145604088) :- ontray(_, Tray), !.
delta(74, put_on_tray(_, _), -8.513023622689913e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(74, put_on_tray(_, _), 0.00646934065161072) :- !.
delta(74, serve_sandwich_no_gluten(_, Child, _, _), 0.0061206030984261904) :- todo_served(Child), !.
delta(74, serve_sandwich_no_gluten(_, _, _, _), -0.005141392399893824) :- !.
delta(74, serve_sandwich(_, _, _, _), 0.002028836408026884) :- notexist(_), at_kitchen_bread(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(74, serve_sandwich(_, _, _, _), -0.020620450811199998) :- notexist(_), at_kitchen_bread(_), !.
delta(74, serve_sandwich(_, _, Tray, _), -0.010850832607161996) :- notexist(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(74, serve_sandwich(_, _, _, Place), 7.006607584955337e-5) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(74, serve_sandwich(_, _, _, _), 0.03554940182337685) :- notexist(_), !.
delta(74, serve_sandwich(Sandwich, _, _, _), 7.681307558917944e-5) :- no_gluten_sandwich(Sandwich), !.
delta(74, serve_sandwich(_, _, _, _), -0.049375390844471234) :- !.
delta(74, move_tray(_, _, Place), 0.010674924914374466) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at(_, Place), done_served(Child), waiting(Child, Place), !.
delta(74, move_tray(_, _, Place), -0.0005824120709120752) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at(_, Place), !.
delta(74, move_tray(_, _, _), -1.8499242836925527e-19) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(74, move_tray(_, _, _), -0.019573987445048263) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(74, move_tray(_, _, Place), -0.00031967687948251104) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(74, move_tray(_, _, _), -0.00023123529890936158) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(74, move_tray(_, _, _), 0.07122932774719909) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(74, move_tray(_, Place, Place2), -0.00035822804121603014) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(74, move_tray(_, Place, Place2), 0.014382860598174113) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(74, move_tray(_, _, Place), 9.886089175763028e-5) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(74, move_tray(_, _, _), -0.02994434897167137) :- !.
delta(74, _, 0.0).

% tree 75: step size 1.0, 221 examples, 43 leaves
delta(75, make_sandwich_no_gluten(_, _, _), 0.014115470985412965) :- at_kitchen_sandwich(_), !.
delta(75, make_sandwich_no_gluten(_, _, _), 0.0003046133739789192) :- !.
delta(75, make_sandwich(_, _, _), -0.013935552691147548) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_at_2_than_allergic_gluten, !.
delta(75, make_sandwich(_, _, _), 0.0886606639423129) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(75, make_sandwich(_, _, _), -0.028109006720503225) :- !.
delta(75, put_on_tray(_, _), 0.009330344050554776) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(75, put_on_tray(Sandwich, _), 0.0024247064171886512) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(75, put_on_tray(_, _), -0.0024429407944355714) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(75, put_on_tray(_, Tray), -0.05157581340679305) :- ontray(_, Tray), fewer_at_1_than_todo_served, !.
delta(75, put_on_tray(_, Tray), 0.0007800172100650675) :- ontray(_, Tray), !.
delta(75, put_on_tray(_, _), 0.00011722663349800392) :- no_gluten_bread(_), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(75, put_on_tray(_, _), -0.001290990544357157) :- no_gluten_bread(_), !.
delta(75, put_on_tray(_, _), 0.0036646228737539344) :- !.
delta(75, serve_sandwich_no_gluten(_, _, _, _), 0.0007245352985333923) :- fewer_ontray_1_than_allergic_gluten, !.
delta(75, serve_sandwich_no_gluten(_, _, _, _), -0.025585319791357242) :- fewer_ontray_1_than_todo_served, !.
delta(75, serve_sandwich_no_gluten(_, _, _, _), 0.00048104622429384164) :- !.
delta(75, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(75, serve_sandwich(_, Child, _, _), 0.06694423025048657) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, notexist(_), todo_served(Child), !.
delta(75, serve_sandwich(_, _, _, _), -0.00024639592464941487) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, notexist(_), !.
delta(75, serve_sandwich(_, _, _, _), 0.0025079169697844153) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(75, serve_sandwich(_, _, _, _), -0.00022094434262287958) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(75, serve_sandwich(_, _, _, _), -0.4314969328007099) :- notexist(_), fewer_at_2_than_todo_served, !.
delta(75, serve_sandwich(_, _, _, _), 0.00026901939824821035) :- notexist(_), !.
delta(75, serve_sandwich(_, Child, _, _), -3.9081061423417494e-5) :- todo_served(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(75, serve_sandwich(_, Child, _, _), 0.006792078705916683) :- todo_served(Child), !.
delta(75, serve_sandwich(_, _, _, _), -0.00027160985745361757) :- !.
delta(75, move_tray(_, Place, Place2), -0.02637598183575753) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), needed_at_to_serve_sandwich_no_gluten(Place2), fewer_ontray_1_than_todo_served, !.
delta(75, move_tray(_, Place, Place2), 0.0007794988964151645) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(75, move_tray(_, Place, _), -0.010404870691366164) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), allergic_gluten(Child2), !.
delta(75, move_tray(_, Place, _), 0.015608412173329327) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(75, move_tray(_, Place, Place2), -0.01256138128788149) :- done_served(Child), not_allergic_gluten(Child), at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(75, move_tray(_, Place, Place2), 0.0073206117871180785) :- done_served(Child), not_allergic_gluten(Child), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(75, move_tray(_, _, _), 0.4265916091865644) :- done_served(Child), not_allergic_gluten(Child), notexist(_), !.
delta(75, move_tray(_, _, _), 0.002644854533072956) :- done_served(Child), not_allergic_gluten(Child), !.
delta(75, move_tray(Tray, _, Place), 0.0292593601464558) :- at(Tray, kitchen), could_serve_sandwich(Tray, Place), allergic_gluten(Child), waiting(Child, Place), !.
delta(75, move_tray(Tray, _, Place), -0.0005954706569173902) :- at(Tray, kitchen), could_serve_sandwich(Tray, Place), !.
delta(75, move_tray(Tray, _, Place), 0.00023251188793908754) :- at(Tray, kitchen), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(75, move_tray(Tray, _, _), -0.006171812259714454) :- at(Tray, kitchen), !.
delta(75, move_tray(_, _, _), 0.0011700116025640543) :- fewer_at_1_than_todo_served, fewer_at_2_than_allergic_gluten, !.
delta(75, move_tray(_, _, _), -0.0723477012758612) :- fewer_at_1_than_todo_served, !.
delta(75, move_tray(_, _, Place), -0.0010958667617038708) :- at(_, Place), !.
delta(75, move_tray(_, _, _), 0.0026204285352377345) :- !.
delta(75, _, 0.0).

% tree 76: step size 1.0, 238 examples, 39 leaves
delta(76, make_sandwich_no_gluten(_, _, _), 0.008172104681645868) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(76, make_sandwich_no_gluten(_, _, _), 0.0002405831078323966) :- fewer_at_1_than_not_allergic_gluten, !.
delta(76, make_sandwich_no_gluten(_, _, _), 0.00034065077820922765) :- no_gluten_sandwich(_), !.
delta(76, make_sandwich_no_gluten(_, _, _), -0.04336634250272007) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(76, make_sandwich_no_gluten(_, _, _), 4.671247069088827e-5) :- !.
delta(76, make_sandwich(_, _, _), 0.007008832900696868) :- at_kitchen_sandwich(_), done_served(Child), allergic_gluten(Child), !.
delta(76, make_sandwich(_, _, _), -0.043790330246547764) :- at_kitchen_sandwich(_), !.
delta(76, make_sandwich(_, Bread_portion, _), -0.0009444155062401104) :- no_gluten_bread(Bread_portion), !.
delta(76, make_sandwich(_, _, _), 0.046557123774591355) :- !.
delta(76, put_on_tray(Sandwich, _), 0.004673053807354275) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(76, put_on_tray(Sandwich, _), -0.008563966355643778) :- no_gluten_sandwich(Sandwich), at_kitchen_bread(_), !.
delta(76, put_on_tray(Sandwich, _), 0.0005105305884050946) :- no_gluten_sandwich(Sandwich), !.
delta(76, put_on_tray(_, _), 0.024884893755417484) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(76, put_on_tray(_, _), -0.0005992830417219225) :- !.
delta(76, serve_sandwich_no_gluten(_, _, _, Place), 1.4282777387570226e-6) :- done_served(Child), waiting(Child, Place), !.
delta(76, serve_sandwich_no_gluten(_, _, _, _), 0.001983388055279762) :- !.
delta(76, serve_sandwich(_, Child, _, Place), 1.1056859117773003e-5) :- notexist(_), done_served(Child2), waiting(Child2, Place), todo_served(Child), fewer_at_1_than_allergic_gluten, !.
delta(76, serve_sandwich(_, Child, _, Place), 0.005664787564216923) :- notexist(_), done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(76, serve_sandwich(_, _, _, Place), -0.0004123478628850489) :- notexist(_), done_served(Child), waiting(Child, Place), !.
delta(76, serve_sandwich(_, _, _, _), 0.0013712270044708192) :- notexist(_), goal_served(Child), done_served(Child), fewer_ontray_1_than_todo_served, !.
delta(76, serve_sandwich(_, _, _, _), -0.3003248474125326) :- notexist(_), goal_served(Child), done_served(Child), !.
delta(76, serve_sandwich(_, _, _, _), 0.0020498336568858275) :- notexist(_), !.
delta(76, serve_sandwich(_, Child, _, _), 0.015869107514789864) :- todo_served(Child), fewer_at_1_than_todo_served, !.
delta(76, serve_sandwich(_, Child, _, _), -8.825320103342156e-6) :- todo_served(Child), !.
delta(76, serve_sandwich(_, _, _, _), -0.00016875411988779876) :- !.
delta(76, move_tray(Tray, _, kitchen), -0.020818545073787227) :- no_gluten_sandwich(_), ontray(_, Tray), !.
delta(76, move_tray(_, _, kitchen), -0.0003084273328092867) :- no_gluten_sandwich(_), at(_, kitchen), !.
delta(76, move_tray(_, _, kitchen), 0.0005439858267034372) :- no_gluten_sandwich(_), !.
delta(76, move_tray(_, Place, kitchen), -0.0003463268238411752) :- notexist(_), done_served(Child), waiting(Child, Place), !.
delta(76, move_tray(_, _, kitchen), 0.31566534649813943) :- notexist(_), !.
delta(76, move_tray(_, Place, kitchen), -0.001408241953925425) :- todo_served(Child), waiting(Child, Place), !.
delta(76, move_tray(_, _, kitchen), 0.0005406028075522966) :- !.
delta(76, move_tray(_, Place, Place2), 0.010934551399037177) :- done_served(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(76, move_tray(_, Place, Place2), 5.303927093017481e-5) :- done_served(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(76, move_tray(_, _, Place), -0.0011190765425132582) :- done_served(Child), waiting(Child, Place), !.
delta(76, move_tray(_, _, Place), 0.0014915538926530796) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(76, move_tray(_, _, _), -0.03977173258863697) :- fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(76, move_tray(_, _, _), 0.00061353017018153) :- !.
delta(76, _, 0.0).

% tree 77: step size 1.0, 206 examples, 44 leaves
delta(77, make_sandwich_no_gluten(_, _, _), 0.00026164027353349874) :- fewer_at_1_than_allergic_gluten, !.
delta(77, make_sandwich_no_gluten(_, _, _), 0.08696708425724577) :- fewer_at_2_than_allergic_gluten, !.
delta(77, make_sandwich_no_gluten(_, _, _), -0.008498010273906582) :- fewer_at_1_than_todo_served, !.
delta(77, make_sandwich_no_gluten(_, _, _), 0.0002614025220175208) :- !.
delta(77, make_sandwich(_, Bread_portion, _), -0.0038121367636931476) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), no_gluten_bread(Bread_portion), !.
delta(77, make_sandwich(_, _, _), 0.0037041813356851424) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(77, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(77, make_sandwich(_, _, _), -0.24795170902818706) :- fewer_at_2_than_allergic_gluten, !.
delta(77, make_sandwich(_, _, _), -0.0020641762221348683) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(77, make_sandwich(_, _, Content_portion), -0.0002948292672880333) :- no_gluten_content(Content_portion), !.
delta(77, make_sandwich(_, _, _), 0.03220855274703016) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(77, make_sandwich(_, _, _), -7.171166946840315e-5) :- !.
delta(77, put_on_tray(Sandwich, _), 0.008569410763518602) :- no_gluten_sandwich(Sandwich), !.
delta(77, put_on_tray(_, Tray), 0.0011520063047724923) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(77, put_on_tray(_, _), 2.7441717536764353e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(77, put_on_tray(_, _), -0.03075641938454432) :- !.
delta(77, serve_sandwich_no_gluten(_, _, _, _), 0.0007132724347520929) :- fewer_at_1_than_todo_served_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(77, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(77, serve_sandwich_no_gluten(_, _, _, _), -0.16463105958363702) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(77, serve_sandwich_no_gluten(_, _, _, _), 0.0005879125474090983) :- !.
delta(77, serve_sandwich(_, Child, _, Place), -7.275147112927717e-5) :- notexist(_), done_served(Child2), waiting(Child2, Place), todo_served(Child), fewer_at_1_than_allergic_gluten, !.
delta(77, serve_sandwich(_, Child, _, Place), 0.009035783033149095) :- notexist(_), done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(77, serve_sandwich(_, _, _, Place), -0.0023624460287319507) :- notexist(_), done_served(Child), waiting(Child, Place), !.
delta(77, serve_sandwich(_, _, Tray, Place), -0.0006538693811435428) :- notexist(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(77, serve_sandwich(_, _, Tray, _), 0.0) :- notexist(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(77, serve_sandwich(_, _, _, _), 0.15097244996751197) :- notexist(_), !.
delta(77, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(77, serve_sandwich(_, _, _, _), -0.11104183429209209) :- at_kitchen_sandwich(_), !.
delta(77, serve_sandwich(_, Child, _, _), -3.234565660006936e-5) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(77, serve_sandwich(_, Child, _, _), 0.010945484550339613) :- todo_served(Child), !.
delta(77, serve_sandwich(_, _, _, _), -0.00017637150027961858) :- !.
delta(77, move_tray(_, Place, Place2), -0.0045730316809771306) :- todo_served(Child), waiting(Child, Place2), at(Tray, Place), could_put_on_tray(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(77, move_tray(_, Place, Place2), 0.0016416262665220683) :- todo_served(Child), waiting(Child, Place2), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(77, move_tray(_, _, Place), -4.779514439598318e-5) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(77, move_tray(_, _, Place), 0.0) :- todo_served(Child), waiting(Child, Place), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(77, move_tray(_, _, Place), 0.25890624271733764) :- todo_served(Child), waiting(Child, Place), !.
delta(77, move_tray(Tray, _, _), -0.04472823371539905) :- ontray(_, Tray), fewer_ontray_2_than_todo_served, !.
delta(77, move_tray(Tray, _, _), -0.00028520133111597644) :- ontray(_, Tray), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(77, move_tray(Tray, _, _), 0.0018532796481118207) :- ontray(_, Tray), !.
delta(77, move_tray(_, Place, _), -0.004402705390001029) :- goal_served(Child), done_served(Child), goal_served(Child2), waiting(Child2, Place), !.
delta(77, move_tray(_, _, _), 1.6654335134862008e-6) :- goal_served(Child), done_served(Child), !.
delta(77, move_tray(_, Place, Place2), 0.022663036876173024) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(77, move_tray(_, _, _), -0.00020275052614444127) :- !.
delta(77, _, 0.0).

% tree 78: step size 1.0, 271 examples, 35 leaves
delta(78, make_sandwich_no_gluten(_, _, _), 0.019505365344805656) :- fewer_at_1_than_not_allergic_gluten, !.
delta(78, make_sandwich_no_gluten(_, _, _), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(78, make_sandwich_no_gluten(_, _, _), -0.045045101249892125) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(78, make_sandwich_no_gluten(_, _, _), 0.00015665065053843889) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(78, make_sandwich_no_gluten(_, _, _), 0.0005993956925048395) :- !.
delta(78, make_sandwich(_, _, _), -0.051070323934950326) :- fewer_at_1_than_not_allergic_gluten, !.
delta(78, make_sandwich(_, _, _), -0.007284038400629528) :- at_kitchen_sandwich(_), !.
delta(78, make_sandwich(_, Bread_portion, _), -0.00020168979651818847) :- no_gluten_bread(Bread_portion), !.
delta(78, make_sandwich(_, _, _), 0.04596735921729819) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(78, make_sandwich(_, _, _), -6.398858639243515e-5) :- !.
delta(78, put_on_tray(_, Tray), 0.14807491891103178) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(78, put_on_tray(_, Tray), 0.0) :- ontray(_, Tray), todo_served(Child), not_allergic_gluten(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(78, put_on_tray(_, Tray), 0.0012291527742093154) :- ontray(_, Tray), todo_served(Child), not_allergic_gluten(Child), !.
delta(78, put_on_tray(_, Tray), -0.00024272010712662984) :- ontray(_, Tray), !.
delta(78, put_on_tray(_, _), 0.008035298826148956) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(78, put_on_tray(_, _), -0.01347536164334299) :- todo_served(Child), allergic_gluten(Child), !.
delta(78, put_on_tray(_, _), 1.73999944264552e-5) :- !.
delta(78, serve_sandwich_no_gluten(_, _, _, _), -0.12170279554158928) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(78, serve_sandwich_no_gluten(_, _, _, _), 0.007083629666602551) :- !.
delta(78, serve_sandwich(_, _, _, Place), -0.0031003279355240575) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child), !.
delta(78, serve_sandwich(_, Child, _, Place), 0.0) :- allergic_gluten(Child2), waiting(Child2, Place), todo_served(Child), fewer_at_1_than_todo_served, !.
delta(78, serve_sandwich(_, Child, _, Place), 9.562874774153006e-5) :- allergic_gluten(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(78, serve_sandwich(_, _, _, Place), -0.00011494218230187275) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(78, serve_sandwich(_, Child, _, _), 0.03951721309370226) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(78, serve_sandwich(_, _, _, _), -0.0010373678600440455) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(78, serve_sandwich(Sandwich, _, _, _), 0.01965528144286401) :- no_gluten_sandwich(Sandwich), !.
delta(78, serve_sandwich(_, _, Tray, _), -0.01953871826641328) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(78, serve_sandwich(_, _, _, _), 0.0001893654012564227) :- !.
delta(78, move_tray(_, Place, Place2), -0.002122751425377543) :- fewer_ontray_2_than_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place2), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(78, move_tray(Tray, _, Place), 0.012729128558215402) :- fewer_ontray_2_than_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place), ontray(_, Tray), !.
delta(78, move_tray(_, _, Place), -0.0001201939479696828) :- fewer_ontray_2_than_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(78, move_tray(_, Place, Place2), 5.001311982231694e-5) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(78, move_tray(_, _, _), -0.0025432143842286743) :- fewer_ontray_2_than_allergic_gluten, !.
delta(78, move_tray(_, _, _), -0.04349672370158279) :- !.
delta(78, _, 0.0).

% tree 79: step size 1.0, 246 examples, 43 leaves
delta(79, make_sandwich_no_gluten(_, _, _), -0.1788347084665579) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(79, make_sandwich_no_gluten(_, _, _), 4.6495158329445306e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(79, make_sandwich_no_gluten(_, _, _), 0.00011113352692641358) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(79, make_sandwich_no_gluten(_, _, _), 0.024189904817842948) :- !.
delta(79, make_sandwich(_, Bread_portion, _), -7.597373763429585e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion2), no_gluten_bread(Bread_portion2), no_gluten_bread(Bread_portion), !.
delta(79, make_sandwich(_, _, _), 0.19504874945275769) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(79, make_sandwich(_, _, _), -0.004082051155087744) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, !.
delta(79, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_ontray_2_than_not_allergic_gluten, !.
delta(79, make_sandwich(_, _, _), 0.003425054688666013) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(79, make_sandwich(_, _, _), 0.03467273771111413) :- done_served(Child), not_allergic_gluten(Child), !.
delta(79, make_sandwich(_, _, _), 0.0005344357797655389) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_2_than_not_allergic_gluten, !.
delta(79, make_sandwich(_, _, _), -9.941411687248568e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(79, make_sandwich(_, _, _), -0.06004592755598866) :- fewer_at_1_than_todo_served, !.
delta(79, make_sandwich(_, _, _), 1.933622370997479e-5) :- !.
delta(79, put_on_tray(_, Tray), 0.010583152176078674) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(79, put_on_tray(_, _), 0.0025611873092886354) :- fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(79, put_on_tray(Sandwich, _), 0.001217945358055128) :- no_gluten_sandwich(Sandwich), !.
delta(79, put_on_tray(_, _), -0.012689723012091203) :- goal_served(Child), allergic_gluten(Child), !.
delta(79, put_on_tray(_, _), 8.753483248232226e-7) :- !.
delta(79, serve_sandwich_no_gluten(_, _, _, _), 0.00015944298114719553) :- fewer_at_1_than_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(79, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_at_1_than_allergic_gluten, !.
delta(79, serve_sandwich_no_gluten(_, _, _, _), 0.004021291032517872) :- !.
delta(79, serve_sandwich(Sandwich, _, _, _), -0.002439061317565821) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(79, serve_sandwich(Sandwich, _, _, _), 0.052531959586116415) :- no_gluten_sandwich(Sandwich), !.
delta(79, serve_sandwich(_, Child, _, _), 0.0004618512630570074) :- at_kitchen_sandwich(_), notexist(_), todo_served(Child), !.
delta(79, serve_sandwich(_, _, _, _), -0.0008435834288830498) :- at_kitchen_sandwich(_), notexist(_), !.
delta(79, serve_sandwich(_, _, _, _), 0.046764741042304006) :- at_kitchen_sandwich(_), !.
delta(79, serve_sandwich(_, _, _, _), 0.010200177622243898) :- goal_served(Child), allergic_gluten(Child), goal_served(Child2), done_served(Child2), !.
delta(79, serve_sandwich(_, _, _, _), -0.0011314946800874488) :- goal_served(Child), allergic_gluten(Child), !.
delta(79, serve_sandwich(_, _, _, Place), 0.0014152619247701126) :- done_served(Child), waiting(Child, Place), !.
delta(79, serve_sandwich(_, _, _, _), -0.14062404259733904) :- !.
delta(79, move_tray(_, Place, Place2), -7.057643895880791e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(79, move_tray(_, Place, Place2), 0.018123891558990492) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_bread(_), !.
delta(79, move_tray(_, Place, Place2), -0.04497892994596451) :- at(Tray, Place), could_put_on_tray(Tray, Place2), goal_served(Child), waiting(Child, Place), !.
delta(79, move_tray(_, Place, Place2), 0.003401913539961411) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(79, move_tray(_, Place, Place2), 0.012060083494501243) :- fewer_ontray_1_than_not_allergic_gluten, done_served(Child), waiting(Child, Place2), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(79, move_tray(_, _, Place), -0.02601117126466018) :- fewer_ontray_1_than_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(79, move_tray(_, _, _), -0.013076196753156756) :- fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_2_than_allergic_gluten, !.
delta(79, move_tray(_, _, _), 0.10522527849660226) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(79, move_tray(_, _, Place), -2.8927237669819927e-5) :- done_served(Child), waiting(Child, Place), todo_served(Child2), allergic_gluten(Child2), !.
delta(79, move_tray(_, _, Place), 0.0009835618919220022) :- done_served(Child), waiting(Child, Place), !.
delta(79, move_tray(_, _, _), -0.019671198896943635) :- !.
delta(79, _, 0.0).

% tree 80: step size 1.0, 270 examples, 37 leaves
delta(80, make_sandwich_no_gluten(_, _, _), 0.028459129388653907) :- !.
delta(80, make_sandwich(_, _, _), -0.08165956923101104) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, fewer_at_2_than_todo_served, !.
delta(80, make_sandwich(_, _, _), 6.622006745780489e-5) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(80, make_sandwich(_, _, _), 0.01737884892918816) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_2_than_not_allergic_gluten, !.
delta(80, make_sandwich(_, _, _), -0.011774939766344677) :- goal_served(Child), allergic_gluten(Child), fewer_at_1_than_todo_served, !.
delta(80, make_sandwich(_, _, _), 0.0006959506003653054) :- goal_served(Child), allergic_gluten(Child), !.
delta(80, make_sandwich(_, _, _), 0.011854771160466971) :- !.
delta(80, put_on_tray(_, Tray), 0.0169751463261975) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(80, put_on_tray(Sandwich, _), 0.0038613626428135087) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(80, put_on_tray(_, _), -0.0031068382941391998) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(80, put_on_tray(_, _), 0.00015972877620007466) :- fewer_ontray_1_than_allergic_gluten, !.
delta(80, put_on_tray(_, _), 9.773760696536716e-6) :- fewer_at_2_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(80, put_on_tray(_, _), -0.021487216049374116) :- fewer_at_2_than_todo_served, !.
delta(80, put_on_tray(_, _), 0.00019525611551436418) :- !.
delta(80, serve_sandwich_no_gluten(_, Child, _, _), 0.006096802819633739) :- todo_served(Child), !.
delta(80, serve_sandwich_no_gluten(_, _, _, _), -0.003553307659072178) :- !.
delta(80, serve_sandwich(_, _, Tray, _), -0.018590085769496313) :- no_gluten_bread(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(80, serve_sandwich(_, _, Tray, _), 4.520664959582061e-5) :- no_gluten_bread(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(80, serve_sandwich(_, Child, _, _), 0.03424893296140582) :- no_gluten_bread(_), todo_served(Child), !.
delta(80, serve_sandwich(_, _, _, _), -8.589845994173935e-5) :- no_gluten_bread(_), !.
delta(80, serve_sandwich(_, _, _, _), -0.06219325109815794) :- at_kitchen_sandwich(_), !.
delta(80, serve_sandwich(_, Child, _, Place), 2.0060356721751175e-5) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(80, serve_sandwich(_, _, _, Place), -0.0012177270520754707) :- done_served(Child), waiting(Child, Place), !.
delta(80, serve_sandwich(_, _, _, _), 0.007689405463245251) :- !.
delta(80, move_tray(_, Place, Place2), 0.015870068415627044) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(80, move_tray(_, _, _), -4.106853130353567e-6) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_2_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(80, move_tray(_, _, _), -0.026216708514672993) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_2_than_todo_served, !.
delta(80, move_tray(_, _, _), 0.0015247218733820346) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(80, move_tray(_, _, _), -0.0008027161990269655) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(80, move_tray(_, Place, _), -0.000578688082222115) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_serve_sandwich(Tray, Place), at(Tray2, Place), could_serve_sandwich_no_gluten(Tray2, Place), !.
delta(80, move_tray(_, Place, _), 0.07452652119186713) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(80, move_tray(_, _, kitchen), 0.015693226851815466) :- fewer_ontray_1_than_todo_served, !.
delta(80, move_tray(_, _, _), -0.019448332093435425) :- fewer_ontray_1_than_todo_served, !.
delta(80, move_tray(_, _, _), 0.008226715564464495) :- at_kitchen_bread(_), !.
delta(80, move_tray(_, Place, Place2), -0.016781437081613088) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(80, move_tray(_, _, _), 0.004314065571469467) :- !.
delta(80, _, 0.0).

% tree 81: step size 1.0, 212 examples, 40 leaves
delta(81, make_sandwich_no_gluten(_, _, _), -0.1821643980194163) :- fewer_at_2_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(81, make_sandwich_no_gluten(_, _, _), 0.0001512995110234522) :- fewer_at_2_than_allergic_gluten, !.
delta(81, make_sandwich_no_gluten(_, _, _), 0.02536123119189157) :- !.
delta(81, make_sandwich(_, _, _), -0.008177167627295093) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(81, make_sandwich(_, Bread_portion, _), -3.853790697866225e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(81, make_sandwich(_, _, _), 0.00037593936811746467) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(81, make_sandwich(_, _, _), -5.201542521945077e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(81, make_sandwich(_, Bread_portion, _), -0.001965463496102575) :- fewer_at_2_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(81, make_sandwich(_, _, Content_portion), -0.0003767668029094902) :- fewer_at_2_than_allergic_gluten, no_gluten_content(Content_portion), !.
delta(81, make_sandwich(_, _, _), 0.2486609256854666) :- fewer_at_2_than_allergic_gluten, !.
delta(81, make_sandwich(_, _, _), -0.02481325447885826) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), todo_served(Child), allergic_gluten(Child), !.
delta(81, make_sandwich(_, _, _), 0.0) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(81, make_sandwich(_, _, _), -4.926751818580169e-6) :- todo_served(Child), allergic_gluten(Child), !.
delta(81, make_sandwich(_, _, _), 0.021984510810875334) :- !.
delta(81, put_on_tray(_, _), 2.1464814648303114e-5) :- no_gluten_sandwich(_), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), fewer_at_1_than_todo_served, !.
delta(81, put_on_tray(_, _), -0.0005466664256056617) :- no_gluten_sandwich(_), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(81, put_on_tray(_, _), 0.010902222713113531) :- no_gluten_sandwich(_), !.
delta(81, put_on_tray(_, _), -0.02217875251792094) :- !.
delta(81, serve_sandwich_no_gluten(_, _, _, Place), 1.2615003910091437e-6) :- done_served(Child), waiting(Child, Place), !.
delta(81, serve_sandwich_no_gluten(_, _, _, _), 0.0008080190695319529) :- !.
delta(81, serve_sandwich(_, _, _, _), -0.0004726378449069582) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(81, serve_sandwich(_, Child, _, _), 0.032082426846959) :- at_kitchen_sandwich(_), todo_served(Child), !.
delta(81, serve_sandwich(_, _, _, _), -0.0001550473950436931) :- at_kitchen_sandwich(_), !.
delta(81, serve_sandwich(_, _, _, _), -0.0034645247721366737) :- todo_served(Child), allergic_gluten(Child), !.
delta(81, serve_sandwich(_, Child, _, _), 5.971058737733345e-6) :- todo_served(Child), at_kitchen_bread(_), !.
delta(81, serve_sandwich(_, Child, _, _), 0.0014675356514952803) :- todo_served(Child), !.
delta(81, serve_sandwich(_, _, _, _), -0.0003974618486403257) :- !.
delta(81, move_tray(_, _, kitchen), 0.013557875576287555) :- done_served(Child), not_allergic_gluten(Child), fewer_at_1_than_not_allergic_gluten, !.
delta(81, move_tray(_, _, kitchen), -0.0004316369897158652) :- done_served(Child), not_allergic_gluten(Child), !.
delta(81, move_tray(_, Place, kitchen), -0.0028858971115412013) :- todo_served(Child), waiting(Child, Place), !.
delta(81, move_tray(_, _, kitchen), 0.00035560203000080425) :- at_kitchen_sandwich(_), !.
delta(81, move_tray(_, _, kitchen), -0.0002513070710587524) :- !.
delta(81, move_tray(Tray, _, Place), 0.0056732382618019835) :- at(Tray, kitchen), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(81, move_tray(Tray, _, Place), -0.00043429968938899524) :- at(Tray, kitchen), allergic_gluten(Child), waiting(Child, Place), !.
delta(81, move_tray(Tray, _, _), -0.0016118990642029923) :- at(Tray, kitchen), !.
delta(81, move_tray(Tray, _, Place), -3.362277878577677e-5) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(81, move_tray(Tray, _, Place), 0.0006626221536112926) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(81, move_tray(_, _, Place), 0.00022847102283439407) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(81, move_tray(_, _, _), -0.04691173311510271) :- !.
delta(81, _, 0.0).

% tree 82: step size 1.0, 215 examples, 39 leaves
delta(82, make_sandwich_no_gluten(_, _, _), 0.022700390097032775) :- fewer_at_2_than_allergic_gluten, !.
delta(82, make_sandwich_no_gluten(_, _, _), -0.027304351614955497) :- fewer_ontray_1_than_allergic_gluten, !.
delta(82, make_sandwich_no_gluten(_, _, _), 0.0008647151929146284) :- !.
delta(82, make_sandwich(_, _, _), -0.027134272368268045) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(82, make_sandwich(_, _, Content_portion), -0.003218365634233694) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), no_gluten_content(Content_portion), !.
delta(82, make_sandwich(_, _, _), 0.029884508206844244) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(82, make_sandwich(_, _, _), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(82, make_sandwich(_, _, _), -0.02393722232982905) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(82, make_sandwich(_, _, _), 0.010683704910145352) :- fewer_at_1_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(82, make_sandwich(_, _, _), -7.66904164076104e-5) :- fewer_at_1_than_todo_served, !.
delta(82, make_sandwich(_, _, _), -0.0044868825348377776) :- !.
delta(82, put_on_tray(Sandwich, _), 0.004564495148084246) :- no_gluten_sandwich(Sandwich), fewer_ontray_1_than_allergic_gluten, !.
delta(82, put_on_tray(Sandwich, _), -0.014527771777368605) :- no_gluten_sandwich(Sandwich), at_kitchen_bread(_), !.
delta(82, put_on_tray(Sandwich, Tray), 0.004179960109298827) :- no_gluten_sandwich(Sandwich), ontray(_, Tray), !.
delta(82, put_on_tray(Sandwich, _), -0.004174138728438559) :- no_gluten_sandwich(Sandwich), !.
delta(82, put_on_tray(_, Tray), 0.030056124724876628) :- ontray(_, Tray), !.
delta(82, put_on_tray(_, _), -0.004137904175096951) :- todo_served(Child), allergic_gluten(Child), !.
delta(82, put_on_tray(_, _), 5.2837323594369713e-5) :- !.
delta(82, serve_sandwich_no_gluten(_, _, _, _), -2.5614293967205978e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(82, serve_sandwich_no_gluten(_, _, _, _), 0.004802640290728105) :- !.
delta(82, serve_sandwich(_, _, Tray, _), -0.005497564006234213) :- fewer_ontray_2_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(82, serve_sandwich(_, _, _, _), 0.0005739080534168505) :- fewer_ontray_2_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(82, serve_sandwich(_, _, _, _), 2.3743877897746065e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(82, serve_sandwich(Sandwich, _, _, _), -0.0003601440103499895) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(82, serve_sandwich(Sandwich, _, _, _), 0.04806138028939391) :- no_gluten_sandwich(Sandwich), !.
delta(82, serve_sandwich(_, Child, _, _), 0.04005676967748853) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(82, serve_sandwich(_, _, _, _), -0.00012447272149248943) :- goal_served(Child), done_served(Child), !.
delta(82, serve_sandwich(_, _, _, _), -0.044210800247825664) :- no_gluten_bread(_), !.
delta(82, serve_sandwich(_, _, _, _), 0.0011777608673698783) :- !.
delta(82, move_tray(_, Place, kitchen), -0.011903077776203317) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(82, move_tray(_, _, kitchen), 0.025212636281074386) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(82, move_tray(_, _, kitchen), -0.0007426982591656579) :- !.
delta(82, move_tray(_, Place, Place2), -0.00011742855583799346) :- fewer_at_1_than_todo_served_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), at_kitchen_bread(_), !.
delta(82, move_tray(_, Place, Place2), 0.005408669612986956) :- fewer_at_1_than_todo_served_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(82, move_tray(_, _, _), -0.0005218033375801301) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(82, move_tray(_, Place, _), 0.0034996978961048205) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(82, move_tray(_, Place, _), -0.003402025241828841) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(82, move_tray(_, _, _), -0.06639428097254835) :- !.
delta(82, _, 0.0).

% tree 83: step size 1.0, 203 examples, 37 leaves
delta(83, make_sandwich_no_gluten(_, _, _), 0.008979569998158852) :- fewer_at_1_than_allergic_gluten, !.
delta(83, make_sandwich_no_gluten(_, _, _), -0.13881140272583947) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(83, make_sandwich_no_gluten(_, _, _), 0.0005591178406628443) :- fewer_ontray_1_than_allergic_gluten, !.
delta(83, make_sandwich_no_gluten(_, _, _), 0.0008457201879971025) :- !.
delta(83, make_sandwich(_, _, _), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(83, make_sandwich(_, _, _), -0.012508636095952068) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(83, make_sandwich(_, _, _), -0.013879480700908116) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_sandwich(_), goal_served(Child), allergic_gluten(Child), !.
delta(83, make_sandwich(_, _, _), 0.01477957854811383) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(83, make_sandwich(_, _, _), 0.169754877422268) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(83, make_sandwich(_, _, _), 0.0002976162922330835) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(83, make_sandwich(_, _, _), -0.01741566397078552) :- !.
delta(83, put_on_tray(_, _), 0.008391437005019074) :- no_gluten_sandwich(_), !.
delta(83, put_on_tray(_, Tray), -0.0165389429433955) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(83, put_on_tray(_, Tray), 0.00010974906520084327) :- ontray(_, Tray), !.
delta(83, put_on_tray(_, _), 0.0015007550709126348) :- !.
delta(83, serve_sandwich_no_gluten(_, _, _, _), -0.05088033225951714) :- fewer_at_1_than_allergic_gluten, at_kitchen_bread(_), !.
delta(83, serve_sandwich_no_gluten(_, _, _, _), 2.9049028816469092e-6) :- fewer_at_1_than_allergic_gluten, !.
delta(83, serve_sandwich_no_gluten(_, _, _, _), 0.002431894049780196) :- !.
delta(83, serve_sandwich(_, _, _, Place), 0.0) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(83, serve_sandwich(_, _, Tray, _), 0.0005399919786958874) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(83, serve_sandwich(_, _, _, _), -0.18869599806165374) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(83, serve_sandwich(Sandwich, _, _, _), -0.0024658141664851067) :- no_gluten_sandwich(Sandwich), !.
delta(83, serve_sandwich(_, Child, _, _), 0.026548938341504073) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(83, serve_sandwich(_, _, _, _), -0.0006532592176476786) :- goal_served(Child), done_served(Child), !.
delta(83, serve_sandwich(_, _, _, _), -0.00038145718313529505) :- !.
delta(83, move_tray(_, Place, Place2), -7.6373297692308e-5) :- fewer_ontray_1_than_todo_served, done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_allergic_gluten, !.
delta(83, move_tray(_, Place, Place2), 0.0031607703562089784) :- fewer_ontray_1_than_todo_served, done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(83, move_tray(_, Place, _), 0.0) :- fewer_ontray_1_than_todo_served, done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(83, move_tray(_, Place, _), -0.0038370868154689926) :- fewer_ontray_1_than_todo_served, done_served(Child), waiting(Child, Place), !.
delta(83, move_tray(Tray, _, _), -0.001638543469330822) :- fewer_ontray_1_than_todo_served, at(Tray, kitchen), !.
delta(83, move_tray(_, _, _), -0.0012980305867013506) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(83, move_tray(_, _, _), 0.19512532483503683) :- fewer_ontray_1_than_todo_served, !.
delta(83, move_tray(Tray, _, Place), 0.0018665130541894264) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(83, move_tray(_, _, Place), 0.000253822743767572) :- fewer_at_2_than_allergic_gluten, todo_served(Child), waiting(Child, Place), !.
delta(83, move_tray(_, _, _), -0.00014572947431750385) :- fewer_at_2_than_allergic_gluten, !.
delta(83, move_tray(_, _, _), -0.019638885679482722) :- !.
delta(83, _, 0.0).

% tree 84: step size 1.0, 244 examples, 33 leaves
delta(84, make_sandwich_no_gluten(_, _, _), -0.14834751449042577) :- fewer_at_2_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(84, make_sandwich_no_gluten(_, _, _), 8.040698772888275e-5) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(84, make_sandwich_no_gluten(_, _, _), 0.0011034821207460388) :- !.
delta(84, make_sandwich(_, _, Content_portion), -0.00023028346877828303) :- fewer_at_1_than_todo_served, no_gluten_content(Content_portion), !.
delta(84, make_sandwich(_, _, _), 0.22098982692118985) :- fewer_at_1_than_todo_served, !.
delta(84, make_sandwich(_, _, _), 0.0004907233500863183) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(84, make_sandwich(_, _, _), -8.251869999558439e-5) :- !.
delta(84, put_on_tray(_, _), 0.0018908875385084513) :- at_kitchen_bread(_), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(84, put_on_tray(_, _), -0.0172701671914988) :- at_kitchen_bread(_), !.
delta(84, put_on_tray(_, _), 0.004031780214317764) :- !.
delta(84, serve_sandwich_no_gluten(_, Child, _, _), 0.0032654475359443014) :- todo_served(Child), !.
delta(84, serve_sandwich_no_gluten(_, _, _, _), -0.0028488583342907445) :- !.
delta(84, serve_sandwich(Sandwich, Child, _, _), -0.028046710631073484) :- todo_served(Child), no_gluten_sandwich(Sandwich), todo_served(Child2), allergic_gluten(Child2), !.
delta(84, serve_sandwich(Sandwich, Child, _, _), 0.0003127304960100555) :- todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(84, serve_sandwich(_, Child, _, _), 0.11187594255955925) :- todo_served(Child), at_kitchen_sandwich(_), goal_served(Child2), done_served(Child2), !.
delta(84, serve_sandwich(_, Child, _, _), 0.0) :- todo_served(Child), at_kitchen_sandwich(_), !.
delta(84, serve_sandwich(_, Child, _, _), 0.0076151739610567865) :- todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(84, serve_sandwich(_, Child, _, _), -0.00985332272263068) :- todo_served(Child), !.
delta(84, serve_sandwich(_, _, _, _), -0.03871163216493961) :- !.
delta(84, move_tray(Tray, _, Place), 0.0012434410682782204) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, could_serve_sandwich(Tray, Place), !.
delta(84, move_tray(_, _, Place), -0.0007696697465698953) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(84, move_tray(_, _, Place), -0.03139414460992501) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), fewer_ontray_2_than_todo_served, !.
delta(84, move_tray(_, _, Place), 0.0003278844939493296) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(84, move_tray(_, Place, Place2), 0.03820792224787588) :- done_served(Child), waiting(Child, Place2), done_served(Child2), waiting(Child2, Place), fewer_at_2_than_todo_served, !.
delta(84, move_tray(_, Place, Place2), -3.9582079623597e-5) :- done_served(Child), waiting(Child, Place2), done_served(Child2), waiting(Child2, Place), !.
delta(84, move_tray(_, _, Place), -0.0012565874752923643) :- done_served(Child), waiting(Child, Place), !.
delta(84, move_tray(_, Place, Place2), 0.007854663347640642) :- fewer_at_2_than_todo_served_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(84, move_tray(_, _, _), -0.0018570198475973397) :- fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(84, move_tray(_, _, _), 0.0) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(84, move_tray(_, _, _), -0.1128821855078839) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(84, move_tray(Tray, _, Place), 0.0011972718194625453) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(84, move_tray(_, _, _), -0.0006620088010299719) :- !.
delta(84, _, 0.0).

% tree 85: step size 1.0, 215 examples, 29 leaves
delta(85, make_sandwich_no_gluten(_, _, _), 0.017992255329295315) :- !.
delta(85, make_sandwich(_, Bread_portion, _), -0.003375195114576941) :- at_kitchen_sandwich(_), no_gluten_bread(Bread_portion), !.
delta(85, make_sandwich(_, _, _), 0.011807147256987687) :- at_kitchen_sandwich(_), !.
delta(85, make_sandwich(_, _, _), 0.0011649086496532913) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(85, make_sandwich(_, _, _), -4.472146460000774e-5) :- no_gluten_sandwich(_), !.
delta(85, make_sandwich(_, _, _), 0.0001627459202509775) :- goal_served(Child), done_served(Child), !.
delta(85, make_sandwich(_, _, _), -0.03175124785590432) :- !.
delta(85, put_on_tray(_, Tray), 0.002818283573068968) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(85, put_on_tray(Sandwich, _), 0.0009389107866362765) :- no_gluten_sandwich(Sandwich), !.
delta(85, put_on_tray(_, _), 9.106247332794732e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(85, put_on_tray(_, _), 3.985243320699001e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(85, put_on_tray(_, _), -0.009619618397631364) :- !.
delta(85, serve_sandwich_no_gluten(_, _, _, _), 0.00041363501006056233) :- !.
delta(85, serve_sandwich(_, _, _, Place), -0.16824397648403278) :- at_kitchen_bread(_), done_served(Child), waiting(Child, Place), !.
delta(85, serve_sandwich(_, _, _, _), 0.004643389288398276) :- at_kitchen_bread(_), !.
delta(85, serve_sandwich(Sandwich, Child, _, Place), -0.0001123987083900549) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(85, serve_sandwich(_, Child, _, _), 0.044069834906931456) :- todo_served(Child), !.
delta(85, serve_sandwich(_, _, _, _), -0.00239156200418547) :- !.
delta(85, move_tray(_, Place, kitchen), 0.002054889390187082) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(85, move_tray(_, Place, kitchen), -0.008769746525255036) :- done_served(Child), waiting(Child, Place), !.
delta(85, move_tray(_, Place, _), -0.005309157842264888) :- done_served(Child), waiting(Child, Place), no_gluten_bread(_), !.
delta(85, move_tray(_, Place, _), -0.0019084847761051621) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(85, move_tray(_, Place, _), 0.17733697193530784) :- done_served(Child), waiting(Child, Place), !.
delta(85, move_tray(_, Place, _), -0.05576570106069988) :- todo_served(Child), waiting(Child, Place), !.
delta(85, move_tray(Tray, Place, Place2), 0.00578091067677588) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(85, move_tray(_, Place, Place2), -0.00166077142275231) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(85, move_tray(_, _, Place), 0.003935263172464887) :- done_served(Child), waiting(Child, Place), !.
delta(85, move_tray(_, _, _), -0.007105705106982679) :- !.
delta(85, _, 0.0).

% tree 86: step size 1.0, 240 examples, 38 leaves
delta(86, make_sandwich_no_gluten(_, _, _), 0.025410222797981653) :- !.
delta(86, make_sandwich(_, _, _), -0.016718604453615987) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(86, make_sandwich(_, _, _), 0.12148082097059727) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(86, make_sandwich(_, _, _), -4.5868623378110105e-6) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(86, make_sandwich(_, _, _), -0.0013131107027163135) :- done_served(Child), allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(86, make_sandwich(_, _, _), 0.002290004591509729) :- done_served(Child), allergic_gluten(Child), !.
delta(86, make_sandwich(_, _, _), -0.04081722695464748) :- !.
delta(86, put_on_tray(_, _), 0.007615631209211668) :- fewer_ontray_1_than_todo_served_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(86, put_on_tray(_, _), -0.12359862605606393) :- fewer_ontray_1_than_todo_served_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(86, put_on_tray(_, _), 0.00042786521605672924) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(86, put_on_tray(_, Tray), 0.01696943698415909) :- ontray(_, Tray), todo_served(Child), not_allergic_gluten(Child), !.
delta(86, put_on_tray(_, Tray), -0.0002133666216490417) :- ontray(_, Tray), !.
delta(86, put_on_tray(_, _), 8.500354072314652e-6) :- fewer_at_2_than_todo_served, notexist(_), !.
delta(86, put_on_tray(_, _), -0.007843556859303758) :- fewer_at_2_than_todo_served, !.
delta(86, put_on_tray(_, _), 0.00010833581228569462) :- !.
delta(86, serve_sandwich_no_gluten(_, Child, _, _), 0.006811428321236134) :- todo_served(Child), !.
delta(86, serve_sandwich_no_gluten(_, _, _, _), -0.0044575050124668085) :- !.
delta(86, serve_sandwich(_, _, _, _), -0.004922519319806592) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_todo_served, at_kitchen_sandwich(_), !.
delta(86, serve_sandwich(_, _, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(86, serve_sandwich(_, Child, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, todo_served(Child), fewer_at_2_than_todo_served, !.
delta(86, serve_sandwich(_, Child, _, _), 0.0015986895810301534) :- fewer_at_2_than_allergic_gluten, todo_served(Child), !.
delta(86, serve_sandwich(_, _, _, _), -0.000318983115398966) :- fewer_at_2_than_allergic_gluten, !.
delta(86, serve_sandwich(_, Child, _, _), 0.07587432704975822) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(86, serve_sandwich(_, _, _, _), -0.0003612487834420646) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(86, serve_sandwich(_, _, _, _), -9.88875251676545e-5) :- goal_served(Child), done_served(Child), !.
delta(86, serve_sandwich(_, _, _, _), -2.3358856254876707e-5) :- at_kitchen_sandwich(_), !.
delta(86, serve_sandwich(_, _, _, _), 0.0012538859333953818) :- !.
delta(86, move_tray(Tray, Place, Place2), -8.26288214018748e-6) :- fewer_at_1_than_todo_served, done_served(Child), waiting(Child, Place2), todo_served(Child2), waiting(Child2, Place2), could_put_on_tray(Tray, Place), !.
delta(86, move_tray(_, _, Place), 0.015380966995785282) :- fewer_at_1_than_todo_served, done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(86, move_tray(_, _, Place), -0.00045858236615102597) :- fewer_at_1_than_todo_served, done_served(Child), waiting(Child, Place), !.
delta(86, move_tray(_, _, _), -0.12333301947364965) :- fewer_at_1_than_todo_served, !.
delta(86, move_tray(_, _, Place), 4.030845376712241e-5) :- at(_, Place), done_served(Child), not_allergic_gluten(Child), !.
delta(86, move_tray(_, _, Place), 3.7484857911646796e-5) :- at(_, Place), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(86, move_tray(_, _, Place), -0.0037516090512706335) :- at(_, Place), !.
delta(86, move_tray(_, Place, _), -0.0014492272826117127) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(86, move_tray(_, Place, _), -0.0005694476320391605) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(86, move_tray(_, _, _), 0.028024262832504386) :- !.
delta(86, _, 0.0).

% tree 87: step size 1.0, 243 examples, 37 leaves
delta(87, make_sandwich_no_gluten(_, _, _), 0.002041273139953895) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(87, make_sandwich_no_gluten(_, _, _), -0.2476204492482632) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(87, make_sandwich_no_gluten(_, _, _), 1.797468932530373e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(87, make_sandwich_no_gluten(_, _, _), 0.017339308920393048) :- !.
delta(87, make_sandwich(_, _, _), -0.007342591819863068) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(87, make_sandwich(_, _, _), -0.0008265232821692245) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(87, make_sandwich(_, _, _), 0.009325249811940581) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(87, make_sandwich(_, _, _), -3.155430454415178e-5) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, at_kitchen_sandwich(Sandwich), !.
delta(87, make_sandwich(_, _, _), -0.02495743765114968) :- no_gluten_sandwich(_), fewer_at_1_than_todo_served, !.
delta(87, make_sandwich(_, _, _), 0.0004799326227478312) :- no_gluten_sandwich(_), !.
delta(87, make_sandwich(_, Bread_portion, _), -0.000967054362922479) :- fewer_at_1_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(87, make_sandwich(_, _, _), 0.27799498805093115) :- fewer_at_1_than_allergic_gluten, !.
delta(87, make_sandwich(_, _, _), -0.014950807617306187) :- todo_served(Child), allergic_gluten(Child), !.
delta(87, make_sandwich(_, _, _), 0.01445583750198121) :- !.
delta(87, put_on_tray(_, Tray), 0.007732001191472403) :- ontray(_, Tray), fewer_at_1_than_todo_served, !.
delta(87, put_on_tray(_, Tray), -0.0001962570486401154) :- ontray(_, Tray), !.
delta(87, put_on_tray(Sandwich, _), 0.0020151531236376713) :- no_gluten_sandwich(Sandwich), !.
delta(87, put_on_tray(_, _), 0.00020802511169091317) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(87, put_on_tray(_, _), 4.27652649672759e-6) :- goal_served(Child), done_served(Child), !.
delta(87, put_on_tray(_, _), -0.01656608976444547) :- !.
delta(87, serve_sandwich_no_gluten(_, _, _, _), 0.0013045383270206172) :- !.
delta(87, serve_sandwich(_, _, Tray, _), -0.039511552548012675) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), notexist(_), !.
delta(87, serve_sandwich(_, _, Tray, _), 0.002696503129881411) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(87, serve_sandwich(_, _, _, _), 0.09848162057344703) :- fewer_ontray_1_than_todo_served, !.
delta(87, serve_sandwich(_, Child, _, _), 3.0479020397127168e-5) :- todo_served(Child), fewer_ontray_2_than_allergic_gluten, !.
delta(87, serve_sandwich(_, Child, _, _), 0.002281934812655652) :- todo_served(Child), !.
delta(87, serve_sandwich(_, _, _, _), -0.00019155031274231392) :- !.
delta(87, move_tray(Tray, _, _), -0.00015999606852374666) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), notexist(_), fewer_at_1_than_todo_served, fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(87, move_tray(Tray, _, _), 0.03240645930173571) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), notexist(_), fewer_at_1_than_todo_served, !.
delta(87, move_tray(Tray, _, _), -0.00016172822846775007) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), notexist(_), !.
delta(87, move_tray(Tray, _, _), -0.003200221471406989) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(87, move_tray(Tray, _, Place), 0.0027028537069432577) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), waiting(Child, Place), !.
delta(87, move_tray(Tray, _, _), -0.0009548669714955579) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(87, move_tray(_, Place, Place2), 0.002860934284691399) :- fewer_ontray_1_than_todo_served_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(87, move_tray(_, _, _), -0.0003421283117253522) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(87, move_tray(_, _, _), -0.09337997141415064) :- !.
delta(87, _, 0.0).

% tree 88: step size 1.0, 262 examples, 35 leaves
delta(88, make_sandwich_no_gluten(_, _, _), 0.01937016199361369) :- fewer_at_1_than_allergic_gluten, !.
delta(88, make_sandwich_no_gluten(_, _, _), -0.020267345696717082) :- fewer_at_2_than_allergic_gluten, !.
delta(88, make_sandwich_no_gluten(_, _, _), 0.01546709796332569) :- !.
delta(88, make_sandwich(_, _, _), -0.032111331574663206) :- fewer_at_1_than_todo_served_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(88, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(88, make_sandwich(_, _, Content_portion), -0.0028856693473421373) :- no_gluten_content(Content_portion), !.
delta(88, make_sandwich(_, _, _), 0.1354221298836574) :- fewer_at_1_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(88, make_sandwich(_, _, _), 0.00222205923281135) :- fewer_at_1_than_todo_served, !.
delta(88, make_sandwich(_, _, _), -0.0005407549554469171) :- fewer_ontray_1_than_allergic_gluten, !.
delta(88, make_sandwich(_, _, _), 7.93743265636929e-5) :- !.
delta(88, put_on_tray(Sandwich, _), -0.11417406645861608) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(88, put_on_tray(Sandwich, _), 0.0007925489048914629) :- no_gluten_sandwich(Sandwich), !.
delta(88, put_on_tray(_, _), 0.02160568035246361) :- fewer_at_2_than_allergic_gluten, !.
delta(88, put_on_tray(_, _), -0.00929459556090557) :- fewer_ontray_2_than_allergic_gluten, !.
delta(88, put_on_tray(_, _), 0.00034259334222274453) :- !.
delta(88, serve_sandwich_no_gluten(_, Child, _, _), 1.9951755584740228e-7) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(88, serve_sandwich_no_gluten(_, Child, _, _), 0.0025844162862594827) :- todo_served(Child), !.
delta(88, serve_sandwich_no_gluten(_, _, _, _), -0.04093580368003688) :- !.
delta(88, serve_sandwich(Sandwich, _, _, _), -0.022508722958167998) :- notexist(_), no_gluten_sandwich(Sandwich), !.
delta(88, serve_sandwich(_, _, _, _), 0.027405418466049426) :- notexist(_), fewer_at_1_than_allergic_gluten, !.
delta(88, serve_sandwich(_, _, _, _), -0.0003255860989959526) :- notexist(_), goal_served(Child), allergic_gluten(Child), !.
delta(88, serve_sandwich(_, _, _, _), 0.0038063890062129597) :- notexist(_), !.
delta(88, serve_sandwich(_, _, _, _), -0.04592535812863526) :- at_kitchen_sandwich(_), !.
delta(88, serve_sandwich(_, _, _, _), 0.004042491734514329) :- !.
delta(88, move_tray(_, Place, Place2), 0.060254891475499645) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(Tray2, Place), could_serve_sandwich(Tray2, Place), !.
delta(88, move_tray(_, Place, Place2), 1.3742825192433966e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_allergic_gluten, !.
delta(88, move_tray(_, Place, Place2), -0.003037679346992034) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(88, move_tray(_, _, Place), 0.009349587167459136) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child), fewer_at_1_than_not_allergic_gluten, !.
delta(88, move_tray(_, _, Place), -0.0007331140660214516) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child), !.
delta(88, move_tray(_, _, Place), -0.0011863977748407966) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_allergic_gluten, !.
delta(88, move_tray(_, _, Place), 2.818421880800036e-5) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(88, move_tray(_, Place, _), 0.009281886670686017) :- at(Tray, Place), could_put_on_tray(Tray, Place), fewer_ontray_2_than_allergic_gluten, !.
delta(88, move_tray(_, Place, _), -0.002514317452583586) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(88, move_tray(_, _, _), -0.032231955812910204) :- !.
delta(88, _, 0.0).

% tree 89: step size 1.0, 219 examples, 44 leaves
delta(89, make_sandwich_no_gluten(_, _, _), -0.02637334674241429) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(89, make_sandwich_no_gluten(_, _, _), 0.04575142731295826) :- fewer_at_1_than_not_allergic_gluten, !.
delta(89, make_sandwich_no_gluten(_, _, _), -0.03385733042198101) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(89, make_sandwich_no_gluten(_, _, _), 0.00020974468025946209) :- !.
delta(89, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(89, make_sandwich(_, _, _), 0.0009900816363900273) :- fewer_at_1_than_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(89, make_sandwich(_, _, _), -0.08307277150960611) :- fewer_at_1_than_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(89, make_sandwich(_, _, _), -0.0041600280086341555) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(89, make_sandwich(_, _, _), 0.01201007364892465) :- fewer_at_1_than_not_allergic_gluten, !.
delta(89, make_sandwich(_, _, _), -0.005287953459953414) :- at_kitchen_sandwich(_), !.
delta(89, make_sandwich(_, Bread_portion, _), -0.0016414710195562622) :- no_gluten_bread(Bread_portion), !.
delta(89, make_sandwich(_, _, _), 0.034902153079257) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(89, make_sandwich(_, _, _), -4.407697850591568e-5) :- !.
delta(89, put_on_tray(Sandwich, _), -0.012996526498937514) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(89, put_on_tray(Sandwich, _), 0.0032750856182857933) :- no_gluten_sandwich(Sandwich), !.
delta(89, put_on_tray(_, Tray), -0.001992231358482586) :- ontray(Sandwich, Tray), done_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(89, put_on_tray(_, Tray), 0.0010422387225143097) :- ontray(_, Tray), done_served(Child), allergic_gluten(Child), !.
delta(89, put_on_tray(_, Tray), 0.01750620708179971) :- ontray(_, Tray), notexist(_), !.
delta(89, put_on_tray(_, Tray), 1.9468262060168095e-5) :- ontray(_, Tray), !.
delta(89, put_on_tray(_, _), -0.004787357382033859) :- todo_served(Child), allergic_gluten(Child), !.
delta(89, put_on_tray(_, _), 8.045251545233328e-5) :- !.
delta(89, serve_sandwich_no_gluten(_, _, _, _), 0.0024486404528741307) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(89, serve_sandwich_no_gluten(_, _, _, _), 1.0720442327681848e-6) :- fewer_at_1_than_allergic_gluten, !.
delta(89, serve_sandwich_no_gluten(_, _, _, _), -0.027142525084122057) :- goal_served(Child), done_served(Child), !.
delta(89, serve_sandwich_no_gluten(_, _, _, _), 0.0007439005934332481) :- !.
delta(89, serve_sandwich(Sandwich, _, _, _), -0.13433082879668704) :- no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(89, serve_sandwich(Sandwich, _, _, _), 0.0015780771978522433) :- no_gluten_sandwich(Sandwich), !.
delta(89, serve_sandwich(_, _, _, _), -0.10905392191247028) :- done_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(89, serve_sandwich(_, Child, _, _), 0.0030458644609701897) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(89, serve_sandwich(_, _, _, _), -0.0007839482152375012) :- done_served(Child), not_allergic_gluten(Child), !.
delta(89, serve_sandwich(_, _, _, _), -0.0005732006688424156) :- no_gluten_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(89, serve_sandwich(_, _, _, _), 0.15570877626399374) :- no_gluten_sandwich(_), !.
delta(89, serve_sandwich(_, _, _, _), 1.3639429251468113e-5) :- !.
delta(89, move_tray(_, _, _), -0.0009194155499713267) :- fewer_no_gluten_sandwich_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(89, move_tray(_, _, Place), -0.0004067436998436089) :- fewer_no_gluten_sandwich_than_todo_served, fewer_at_1_than_todo_served, at(Tray, Place), ontray(_, Tray), !.
delta(89, move_tray(_, _, _), 0.13862082005816728) :- fewer_no_gluten_sandwich_than_todo_served, fewer_at_1_than_todo_served, !.
delta(89, move_tray(_, _, Place), -0.014695088875135305) :- fewer_no_gluten_sandwich_than_todo_served, todo_served(Child), waiting(Child, Place), !.
delta(89, move_tray(_, _, _), 0.014639775700484643) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(89, move_tray(_, Place, Place2), 0.010660813706629364) :- at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(89, move_tray(_, _, kitchen), 0.004121583169741558) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(89, move_tray(_, _, kitchen), -0.0036622295643857893) :- !.
delta(89, move_tray(_, _, _), -0.014757886109292559) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(89, move_tray(_, _, _), 0.000961807398766094) :- !.
delta(89, _, 0.0).

% tree 90: step size 1.0, 228 examples, 31 leaves
delta(90, make_sandwich_no_gluten(_, _, _), 0.19523398341817205) :- !.
delta(90, make_sandwich(_, _, Content_portion), -0.0028779424089648096) :- todo_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), no_gluten_content(Content_portion), !.
delta(90, make_sandwich(_, _, _), 0.0028244752027194934) :- todo_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(90, make_sandwich(_, _, _), -0.0005496694647519311) :- todo_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(90, make_sandwich(_, _, _), -0.29167569859036413) :- todo_served(Child), allergic_gluten(Child), !.
delta(90, make_sandwich(_, Bread_portion, _), -0.001540172167101041) :- no_gluten_bread(Bread_portion), !.
delta(90, make_sandwich(_, _, _), 0.02180464362406621) :- !.
delta(90, put_on_tray(_, _), 0.00848898266496652) :- no_gluten_sandwich(_), !.
delta(90, put_on_tray(_, _), -0.013842909663307248) :- at_kitchen_bread(_), !.
delta(90, put_on_tray(_, _), 2.8807570029803267e-5) :- !.
delta(90, serve_sandwich_no_gluten(_, _, _, _), 0.0020239044282796795) :- !.
delta(90, serve_sandwich(_, _, _, _), 0.016351912703414975) :- at_kitchen_bread(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(90, serve_sandwich(_, _, _, _), -0.00029712740232336137) :- at_kitchen_bread(_), !.
delta(90, serve_sandwich(_, _, _, _), 0.005953230627683689) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(90, serve_sandwich(_, _, _, _), -0.13356171989440815) :- notexist(_), fewer_ontray_2_than_todo_served, !.
delta(90, serve_sandwich(_, _, _, _), 3.4126281352450796e-5) :- notexist(_), !.
delta(90, serve_sandwich(_, Child, _, _), 0.0017816271486115894) :- todo_served(Child), !.
delta(90, serve_sandwich(_, _, _, _), -0.00018001529483457042) :- !.
delta(90, move_tray(_, Place, Place2), -0.015209221790793988) :- at(Tray, Place), could_put_on_tray(Tray, Place2), ontray(_, Tray), fewer_ontray_1_than_not_allergic_gluten, !.
delta(90, move_tray(Tray, Place, Place2), 0.0038080637709924457) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), ontray(Sandwich, Tray2), ontray(Sandwich, Tray), !.
delta(90, move_tray(_, Place, Place2), -0.00323352339714767) :- at(Tray, Place), could_put_on_tray(Tray, Place2), ontray(_, Tray), !.
delta(90, move_tray(_, Place, Place2), -0.0002647821951624485) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(90, move_tray(_, Place, Place2), 0.0022104188080078226) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(90, move_tray(_, _, Place), -0.011651636478671708) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_not_allergic_gluten, !.
delta(90, move_tray(Tray, _, Place), 0.0001322605065691345) :- done_served(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(90, move_tray(_, _, Place), -5.122267998689395e-5) :- done_served(Child), waiting(Child, Place), !.
delta(90, move_tray(Tray, _, _), 0.18777962856399946) :- notexist(_), ontray(_, Tray), !.
delta(90, move_tray(_, _, _), -0.0007445590726786654) :- notexist(_), !.
delta(90, move_tray(_, _, _), -0.0034888252278313828) :- fewer_ontray_2_than_todo_served, !.
delta(90, move_tray(_, _, _), 0.0005173623117857344) :- !.
delta(90, _, 0.0).

% tree 91: step size 1.0, 254 examples, 35 leaves
delta(91, make_sandwich_no_gluten(_, _, _), 0.013516885005648915) :- fewer_at_1_than_allergic_gluten, !.
delta(91, make_sandwich_no_gluten(_, _, _), -0.09004575056779578) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(91, make_sandwich_no_gluten(_, _, _), 0.0020971417845823265) :- !.
delta(91, make_sandwich(_, _, _), -0.04585848628443959) :- fewer_at_1_than_allergic_gluten, !.
delta(91, make_sandwich(_, _, _), -0.0009193506719319597) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(91, make_sandwich(_, Bread_portion, _), -0.0013571867595654305) :- no_gluten_bread(Bread_portion), !.
delta(91, make_sandwich(_, _, Content_portion), -4.944916843138019e-5) :- no_gluten_content(Content_portion), !.
delta(91, make_sandwich(_, _, _), 0.08823763063658123) :- !.
delta(91, put_on_tray(_, _), 0.008499420238958142) :- no_gluten_sandwich(_), fewer_ontray_2_than_todo_served, !.
delta(91, put_on_tray(_, _), -0.0006487054825353878) :- no_gluten_sandwich(_), !.
delta(91, put_on_tray(_, _), -0.016584435976120346) :- at_kitchen_bread(_), !.
delta(91, put_on_tray(_, _), 0.00011924826289520771) :- !.
delta(91, serve_sandwich_no_gluten(_, _, _, _), -0.04500660015108256) :- fewer_at_1_than_allergic_gluten, !.
delta(91, serve_sandwich_no_gluten(_, _, _, _), 0.0011871063189641347) :- !.
delta(91, serve_sandwich(_, _, Tray, _), -0.13780787780248885) :- todo_served(Child), allergic_gluten(Child), at(Tray, Place), waiting(Child, Place), !.
delta(91, serve_sandwich(_, _, Tray, _), -2.0580942762220107e-5) :- todo_served(Child), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(91, serve_sandwich(_, _, _, _), 0.04424917631530263) :- todo_served(Child), allergic_gluten(Child), !.
delta(91, serve_sandwich(_, Child, _, _), 0.0) :- at_kitchen_bread(_), done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(91, serve_sandwich(_, _, _, _), -0.00043338193261347846) :- at_kitchen_bread(_), done_served(Child), not_allergic_gluten(Child), !.
delta(91, serve_sandwich(_, _, _, _), 0.03456524061840008) :- at_kitchen_bread(_), !.
delta(91, serve_sandwich(_, _, _, _), 0.0008908607008909663) :- goal_served(Child), done_served(Child), notexist(_), !.
delta(91, serve_sandwich(_, _, _, _), 0.022623182309124953) :- goal_served(Child), done_served(Child), !.
delta(91, serve_sandwich(_, _, _, _), -0.04805601198254899) :- at_kitchen_sandwich(_), !.
delta(91, serve_sandwich(_, _, _, _), 0.0015122309016902557) :- !.
delta(91, move_tray(_, _, _), -0.022686211356093052) :- notexist(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(91, move_tray(_, _, Place), -0.007899072726365423) :- notexist(_), done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), !.
delta(91, move_tray(_, _, Place), 0.0007390828791720485) :- notexist(_), done_served(Child), waiting(Child, Place), !.
delta(91, move_tray(_, _, _), 0.2006469411526135) :- notexist(_), fewer_at_1_than_not_allergic_gluten, !.
delta(91, move_tray(_, _, _), -0.002137295938238225) :- notexist(_), !.
delta(91, move_tray(_, Place, Place2), 0.02293351533938427) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_no_gluten_sandwich_than_todo_served, !.
delta(91, move_tray(_, Place, Place2), -0.0011034075088566702) :- at(Tray, Place), could_put_on_tray(Tray, Place2), todo_served(Child), waiting(Child, Place), !.
delta(91, move_tray(_, Place, Place2), 1.7158987703037892e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(91, move_tray(_, _, _), 4.430301983623141e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(91, move_tray(_, _, _), -0.05381534962422664) :- !.
delta(91, _, 0.0).

% tree 92: step size 1.0, 212 examples, 32 leaves
delta(92, make_sandwich_no_gluten(_, _, _), 0.013113126383033049) :- fewer_at_1_than_allergic_gluten, !.
delta(92, make_sandwich_no_gluten(_, _, _), -0.039814680053202295) :- fewer_at_2_than_allergic_gluten, !.
delta(92, make_sandwich_no_gluten(_, _, _), 0.00020035094978734737) :- !.
delta(92, make_sandwich(_, _, _), 0.006643453558537492) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(92, make_sandwich(_, _, _), -0.014037293611498986) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(92, make_sandwich(_, _, _), -3.1439465716974276e-7) :- fewer_ontray_1_than_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(92, make_sandwich(_, _, _), 0.05261584764988664) :- fewer_ontray_1_than_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), !.
delta(92, make_sandwich(_, _, _), 0.000508297193133791) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(92, make_sandwich(_, _, _), -0.04472617423793649) :- !.
delta(92, put_on_tray(_, _), -0.026937541372028567) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_bread(_), todo_served(Child), allergic_gluten(Child), !.
delta(92, put_on_tray(_, _), 2.311644698167017e-5) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_bread(_), !.
delta(92, put_on_tray(_, _), 0.00013312104777867513) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(92, put_on_tray(_, _), 0.0) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(92, put_on_tray(_, _), 0.001315561148511781) :- !.
delta(92, serve_sandwich_no_gluten(_, _, _, _), 0.0006924329794910184) :- !.
delta(92, serve_sandwich(Sandwich, _, _, Place), -0.0004485867605078556) :- done_served(Child), waiting(Child, Place), no_gluten_sandwich(Sandwich), !.
delta(92, serve_sandwich(_, Child, _, Place), 0.03224255887758195) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(92, serve_sandwich(_, _, _, Place), -0.00013363361261703208) :- done_served(Child), waiting(Child, Place), !.
delta(92, serve_sandwich(_, _, _, _), 0.000481148504713894) :- goal_served(Child), done_served(Child), fewer_ontray_2_than_todo_served, at_kitchen_bread(_), !.
delta(92, serve_sandwich(_, _, _, _), -0.10648338335275233) :- goal_served(Child), done_served(Child), fewer_ontray_2_than_todo_served, !.
delta(92, serve_sandwich(_, _, _, _), 0.0008943555193906533) :- goal_served(Child), done_served(Child), !.
delta(92, serve_sandwich(_, _, _, _), 1.7508036403292925e-7) :- !.
delta(92, move_tray(_, _, _), -0.002532882334202022) :- fewer_ontray_1_than_todo_served, fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(92, move_tray(_, _, _), -0.00023912095580144667) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(92, move_tray(_, _, Place), -1.1557770772820943e-6) :- fewer_ontray_1_than_todo_served, at(Tray, Place), ontray(_, Tray), !.
delta(92, move_tray(_, _, _), 0.14489103013959698) :- fewer_ontray_1_than_todo_served, !.
delta(92, move_tray(_, Place, Place2), 0.00011286658261695609) :- done_served(Child), waiting(Child, Place), at(_, Place2), !.
delta(92, move_tray(_, Place, _), -0.02878328867306675) :- done_served(Child), waiting(Child, Place), !.
delta(92, move_tray(_, _, Place), 0.036921080317644635) :- needed_at_to_serve_sandwich_no_gluten(Place), notexist(_), !.
delta(92, move_tray(_, _, Place), -0.003955070396801705) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(92, move_tray(_, _, _), -0.007171822641233151) :- !.
delta(92, _, 0.0).

% tree 93: step size 1.0, 221 examples, 37 leaves
delta(93, make_sandwich_no_gluten(_, _, _), 0.02130771166850331) :- fewer_at_1_than_allergic_gluten, !.
delta(93, make_sandwich_no_gluten(_, _, _), -0.03728507823435449) :- fewer_at_2_than_allergic_gluten, !.
delta(93, make_sandwich_no_gluten(_, _, _), 0.00015281780949239298) :- !.
delta(93, make_sandwich(_, _, _), -0.037193923507808056) :- fewer_at_1_than_allergic_gluten, !.
delta(93, make_sandwich(_, _, _), -0.003702548781788926) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(93, make_sandwich(_, Bread_portion, _), -0.0005404515961101938) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), !.
delta(93, make_sandwich(_, _, _), 0.0014835818732195111) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(93, make_sandwich(_, _, _), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(93, make_sandwich(_, _, _), 0.0816219492963333) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(93, make_sandwich(_, _, _), -0.000992266845062443) :- !.
delta(93, put_on_tray(_, _), 0.011720869493720998) :- no_gluten_sandwich(_), !.
delta(93, put_on_tray(_, _), -0.04259533695363815) :- at_kitchen_bread(_), !.
delta(93, put_on_tray(_, _), 0.0001433361734888249) :- !.
delta(93, serve_sandwich_no_gluten(_, _, _, _), -0.008973712913297767) :- at_kitchen_bread(_), !.
delta(93, serve_sandwich_no_gluten(_, Child, _, _), 0.0043614652101390304) :- todo_served(Child), !.
delta(93, serve_sandwich_no_gluten(_, _, _, _), -0.003959151442129985) :- !.
delta(93, serve_sandwich(Sandwich, _, _, Place), -0.01268186490269078) :- done_served(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), no_gluten_sandwich(Sandwich), !.
delta(93, serve_sandwich(_, _, _, Place), 0.016884767194893905) :- done_served(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), fewer_at_2_than_allergic_gluten, !.
delta(93, serve_sandwich(_, _, _, Place), -0.0005017704878765598) :- done_served(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(93, serve_sandwich(_, _, _, Place), -0.08342509560815829) :- done_served(Child), waiting(Child, Place), !.
delta(93, serve_sandwich(_, _, Tray, _), -0.0001236260739694531) :- at_kitchen_sandwich(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(93, serve_sandwich(_, _, _, _), 0.07453387360139804) :- at_kitchen_sandwich(_), !.
delta(93, serve_sandwich(_, _, _, _), 0.0) :- no_gluten_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(93, serve_sandwich(_, _, _, _), 0.011860399712865427) :- no_gluten_sandwich(_), !.
delta(93, serve_sandwich(_, _, _, _), -0.01261942697168624) :- goal_served(Child), done_served(Child), !.
delta(93, serve_sandwich(_, _, _, _), 1.1718843824157916e-5) :- !.
delta(93, move_tray(_, Place, Place2), 0.0010038271158929327) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(93, move_tray(_, _, _), -0.0017761936576139753) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(93, move_tray(_, _, _), 0.006423075549642856) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(93, move_tray(_, _, _), -0.08937745933667693) :- fewer_ontray_1_than_todo_served, !.
delta(93, move_tray(Tray, _, Place), 0.002567187253296106) :- todo_served(Child), allergic_gluten(Child), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(93, move_tray(_, _, _), -0.008104570908156613) :- todo_served(Child), allergic_gluten(Child), !.
delta(93, move_tray(_, Place, Place2), 0.09422115293778226) :- fewer_no_gluten_sandwich_than_todo_served, at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(93, move_tray(_, _, _), -0.00102834288985036) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(93, move_tray(_, Place, _), -0.004366459328149498) :- todo_served(Child), waiting(Child, Place), !.
delta(93, move_tray(_, _, _), 0.0009696280144789346) :- !.
delta(93, _, 0.0).

% tree 94: step size 1.0, 202 examples, 35 leaves
delta(94, make_sandwich_no_gluten(_, _, _), 0.03297177856973962) :- fewer_ontray_1_than_allergic_gluten, !.
delta(94, make_sandwich_no_gluten(_, _, _), -0.017233692306072294) :- fewer_at_1_than_not_allergic_gluten, !.
delta(94, make_sandwich_no_gluten(_, _, _), 1.9649016943351186e-5) :- !.
delta(94, make_sandwich(_, _, _), -0.06908025350982405) :- fewer_at_1_than_todo_served, !.
delta(94, make_sandwich(_, _, _), 0.013332293982821803) :- fewer_ontray_1_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(94, make_sandwich(_, _, _), -0.0001564491581245974) :- fewer_ontray_1_than_todo_served, !.
delta(94, make_sandwich(_, _, _), -0.0034911676592642737) :- !.
delta(94, put_on_tray(_, _), 0.009652894239739014) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(94, put_on_tray(_, _), -0.007918140955352017) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(94, put_on_tray(_, _), 0.0026805971283921344) :- fewer_ontray_1_than_todo_served, !.
delta(94, put_on_tray(_, _), 4.727744486398014e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(94, put_on_tray(_, _), -0.0003882830871859688) :- !.
delta(94, serve_sandwich_no_gluten(_, _, _, _), -0.003972110899330324) :- done_served(Child), allergic_gluten(Child), fewer_no_gluten_sandwich_than_todo_served, !.
delta(94, serve_sandwich_no_gluten(_, _, _, _), 2.5357074086327542e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(94, serve_sandwich_no_gluten(_, _, _, _), 0.0005390489081829219) :- !.
delta(94, serve_sandwich(_, _, _, _), 0.004212556432514667) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(94, serve_sandwich(_, _, _, Place), -0.08854743148463885) :- fewer_at_1_than_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(94, serve_sandwich(_, _, _, _), 5.272206230502395e-6) :- fewer_at_1_than_allergic_gluten, !.
delta(94, serve_sandwich(Sandwich, _, _, _), -0.031030652504145044) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(94, serve_sandwich(Sandwich, _, _, _), 0.000174570508807596) :- no_gluten_sandwich(Sandwich), !.
delta(94, serve_sandwich(_, _, _, Place), -1.1414652077159145e-5) :- allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(94, serve_sandwich(_, _, _, Place), 0.0027338530253248118) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(94, serve_sandwich(_, Child, _, _), 0.09099575471130578) :- todo_served(Child), !.
delta(94, serve_sandwich(_, _, _, _), -0.000237572970239632) :- !.
delta(94, move_tray(_, _, _), 0.017242390182118445) :- fewer_ontray_1_than_not_allergic_gluten, fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(94, move_tray(_, _, _), -0.08138964869229766) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(94, move_tray(_, _, _), -1.5343244377786843e-7) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(94, move_tray(_, Place, _), -0.0009210574827735901) :- fewer_at_1_than_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(94, move_tray(_, _, _), 0.11335625035728812) :- fewer_at_1_than_allergic_gluten, fewer_ontray_2_than_not_allergic_gluten, !.
delta(94, move_tray(_, _, _), -0.00010273116566339763) :- fewer_at_1_than_allergic_gluten, !.
delta(94, move_tray(_, _, Place), 0.0008757789663400966) :- needed_at_to_serve_sandwich_no_gluten(Place), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(94, move_tray(_, _, Place), -0.01271569702067749) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(94, move_tray(Tray, _, _), 0.011057723990643026) :- ontray(_, Tray), !.
delta(94, move_tray(_, _, _), -0.0012706868693630811) :- !.
delta(94, _, 0.0).

% tree 95: step size 1.0, 223 examples, 34 leaves
delta(95, make_sandwich_no_gluten(_, _, _), -0.011684753934074261) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(95, make_sandwich_no_gluten(_, _, _), 0.0004617088150106087) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(95, make_sandwich_no_gluten(_, _, _), 0.008421684684053167) :- !.
delta(95, make_sandwich(_, Bread_portion, _), -0.0006778389913386191) :- no_gluten_bread(Bread_portion), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(95, make_sandwich(_, Bread_portion, _), 0.03034765516207839) :- no_gluten_bread(Bread_portion), !.
delta(95, make_sandwich(_, _, _), 0.00170246178852209) :- goal_served(Child), done_served(Child), !.
delta(95, make_sandwich(_, _, _), -0.028077586546466377) :- fewer_at_1_than_todo_served, !.
delta(95, make_sandwich(_, _, _), -4.568634920948196e-5) :- !.
delta(95, put_on_tray(_, _), 0.024653011576421434) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(95, put_on_tray(_, _), -0.004735405296568898) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(95, put_on_tray(_, _), -0.0004842654341966401) :- goal_served(Child), done_served(Child), !.
delta(95, put_on_tray(_, _), 0.002069529494797579) :- !.
delta(95, serve_sandwich_no_gluten(_, Child, _, _), 0.002203537292857052) :- todo_served(Child), !.
delta(95, serve_sandwich_no_gluten(_, _, _, _), -0.10424515502260923) :- !.
delta(95, serve_sandwich(_, Child, _, _), 0.10654400798268011) :- done_served(Child2), allergic_gluten(Child2), todo_served(Child), !.
delta(95, serve_sandwich(_, _, _, _), -9.255321655685493e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(95, serve_sandwich(_, _, _, _), -0.04719472992155454) :- fewer_at_1_than_todo_served, fewer_ontray_1_than_todo_served, !.
delta(95, serve_sandwich(_, Child, _, _), 0.00025180845741387854) :- fewer_at_1_than_todo_served, todo_served(Child), !.
delta(95, serve_sandwich(_, _, _, _), -5.856388536730881e-5) :- fewer_at_1_than_todo_served, !.
delta(95, serve_sandwich(_, Child, _, _), 0.0006489996220778029) :- todo_served(Child), !.
delta(95, serve_sandwich(_, _, _, _), -0.00013823038473707527) :- !.
delta(95, move_tray(Tray, _, _), 0.00013611058648126448) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served, fewer_at_1_than_not_allergic_gluten, !.
delta(95, move_tray(Tray, _, _), -0.043462472325429075) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(95, move_tray(Tray, _, _), 0.0004983297683559575) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at_kitchen_sandwich(_), !.
delta(95, move_tray(Tray, _, Place), -0.008389250577717298) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), allergic_gluten(Child), waiting(Child, Place), fewer_at_2_than_allergic_gluten, !.
delta(95, move_tray(Tray, _, Place), 0.002333178520761536) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), allergic_gluten(Child), waiting(Child, Place), !.
delta(95, move_tray(Tray, _, _), -0.00011496335066030345) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(95, move_tray(Tray, _, _), 0.01809423481317347) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(95, move_tray(_, Place, _), -0.015805777574317285) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(95, move_tray(Tray, _, _), -0.00042197672002823307) :- fewer_ontray_1_than_todo_served, at(Tray, kitchen), !.
delta(95, move_tray(_, _, _), 0.07840023635274466) :- fewer_ontray_1_than_todo_served, !.
delta(95, move_tray(_, _, Place), 0.007664584242035658) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(95, move_tray(_, _, _), -0.01176154181859187) :- !.
delta(95, _, 0.0).

% tree 96: step size 1.0, 216 examples, 38 leaves
delta(96, make_sandwich_no_gluten(_, _, _), 0.0022062009383144094) :- at_kitchen_sandwich(_), !.
delta(96, make_sandwich_no_gluten(_, _, _), -0.16261451331871926) :- fewer_at_1_than_not_allergic_gluten, !.
delta(96, make_sandwich_no_gluten(_, _, _), 7.18648274076889e-5) :- !.
delta(96, make_sandwich(_, _, _), -0.03793950526602298) :- no_gluten_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(96, make_sandwich(_, _, _), 0.00012411564218584216) :- no_gluten_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(96, make_sandwich(_, _, _), -0.00011071992670156528) :- no_gluten_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(96, make_sandwich(_, _, _), 0.002658925448309466) :- no_gluten_sandwich(_), fewer_at_1_than_todo_served, !.
delta(96, make_sandwich(_, _, _), -0.0013671423236442332) :- no_gluten_sandwich(_), !.
delta(96, make_sandwich(_, _, Content_portion), -0.001297265444247463) :- no_gluten_content(Content_portion), !.
delta(96, make_sandwich(_, Bread_portion, _), -0.0009294148581444551) :- no_gluten_bread(Bread_portion), !.
delta(96, make_sandwich(_, _, _), 0.19138459135584365) :- !.
delta(96, put_on_tray(_, Tray), 0.004048093085634773) :- ontray(_, Tray), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(96, put_on_tray(_, Tray), 6.128987627306302e-5) :- ontray(_, Tray), at_kitchen_bread(_), fewer_at_2_than_allergic_gluten, !.
delta(96, put_on_tray(_, Tray), -0.017842237402946406) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(96, put_on_tray(_, Tray), 0.0004066211011638523) :- ontray(_, Tray), fewer_ontray_2_than_not_allergic_gluten, !.
delta(96, put_on_tray(_, Tray), -0.0001906681007665169) :- ontray(_, Tray), !.
delta(96, put_on_tray(_, _), 0.056663219071255135) :- fewer_ontray_1_than_todo_served, !.
delta(96, put_on_tray(_, _), -0.002804698867237838) :- !.
delta(96, serve_sandwich_no_gluten(_, _, _, _), 0.006300624227307617) :- !.
delta(96, serve_sandwich(_, _, _, _), -0.06292716926269482) :- fewer_ontray_1_than_todo_served, !.
delta(96, serve_sandwich(_, _, Tray, Place), -0.003127947243240117) :- done_served(Child), waiting(Child, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(96, serve_sandwich(_, Child, _, Place), 0.00046054090189576863) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(96, serve_sandwich(_, _, _, Place), -0.00034102491030093087) :- done_served(Child), waiting(Child, Place), !.
delta(96, serve_sandwich(Sandwich, _, _, Place), -1.3642671505806829e-5) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(96, serve_sandwich(_, _, _, _), 0.014237816729139489) :- !.
delta(96, move_tray(_, Place, Place2), -0.012626381908397016) :- todo_served(Child), waiting(Child, Place), notexist(_), fewer_ontray_1_than_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(96, move_tray(_, Place, _), 0.012274332282321922) :- todo_served(Child), waiting(Child, Place), notexist(_), fewer_ontray_1_than_allergic_gluten, !.
delta(96, move_tray(_, Place, _), -0.10310623203405142) :- todo_served(Child), waiting(Child, Place), notexist(_), !.
delta(96, move_tray(_, Place, Place2), 0.028189287812860783) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(96, move_tray(_, Place, _), -0.00014059743845459323) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(96, move_tray(_, Place, _), 0.0) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(96, move_tray(_, Place, _), -0.007744730903160836) :- todo_served(Child), waiting(Child, Place), !.
delta(96, move_tray(Tray, _, Place), -0.0029055512349272284) :- ontray(_, Tray), at(Tray2, Place), could_serve_sandwich(Tray2, Place), !.
delta(96, move_tray(Tray, _, _), 0.09755904396261064) :- ontray(_, Tray), no_gluten_sandwich(_), !.
delta(96, move_tray(Tray, _, _), -0.0005498579465216077) :- ontray(_, Tray), !.
delta(96, move_tray(_, Place, Place2), 4.291327591099805e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(96, move_tray(_, _, _), -0.00656640294009886) :- !.
delta(96, _, 0.0).

% tree 97: step size 1.0, 256 examples, 40 leaves
delta(97, make_sandwich_no_gluten(_, _, _), 0.011355523169870629) :- at_kitchen_sandwich(_), !.
delta(97, make_sandwich_no_gluten(_, _, _), -0.3401887193011068) :- fewer_at_1_than_todo_served, !.
delta(97, make_sandwich_no_gluten(_, _, _), 6.097946187742252e-5) :- !.
delta(97, make_sandwich(_, _, _), -0.0010259565234671407) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(97, make_sandwich(_, _, Content_portion), -0.0002849415602651185) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), no_gluten_content(Content_portion), !.
delta(97, make_sandwich(_, _, _), 0.5013819723140605) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(97, make_sandwich(_, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(97, make_sandwich(_, _, _), -0.013315984872922789) :- todo_served(Child), allergic_gluten(Child), !.
delta(97, make_sandwich(_, _, _), 1.5917936083358956e-5) :- goal_served(Child), allergic_gluten(Child), !.
delta(97, make_sandwich(_, _, _), 0.010191823540019254) :- !.
delta(97, put_on_tray(_, _), 0.00021223530511332687) :- no_gluten_bread(Bread_portion), at_kitchen_bread(Bread_portion), fewer_ontray_1_than_allergic_gluten, !.
delta(97, put_on_tray(_, _), -0.006846132691198702) :- no_gluten_bread(Bread_portion), at_kitchen_bread(Bread_portion), !.
delta(97, put_on_tray(_, _), 0.016571216776228772) :- no_gluten_bread(_), !.
delta(97, put_on_tray(_, Tray), -0.009755314944664462) :- at_kitchen_bread(_), ontray(_, Tray), !.
delta(97, put_on_tray(_, _), 7.299483172205166e-6) :- at_kitchen_bread(_), !.
delta(97, put_on_tray(_, _), 9.10347204508214e-5) :- !.
delta(97, serve_sandwich_no_gluten(_, _, _, _), -0.004306692254016113) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(97, serve_sandwich_no_gluten(_, _, _, _), 9.967372287942144e-7) :- done_served(Child), allergic_gluten(Child), !.
delta(97, serve_sandwich_no_gluten(_, _, _, _), 0.00044811445250642784) :- !.
delta(97, serve_sandwich(Sandwich, Child, _, Place), -0.00016697671189620303) :- fewer_ontray_1_than_todo_served, todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(97, serve_sandwich(_, Child, _, _), 0.09520408223386172) :- fewer_ontray_1_than_todo_served, todo_served(Child), !.
delta(97, serve_sandwich(_, _, _, _), -0.00018741430629012532) :- fewer_ontray_1_than_todo_served, !.
delta(97, serve_sandwich(Sandwich, _, _, _), -0.006235168677362463) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(97, serve_sandwich(Sandwich, _, _, _), 1.872420747082419e-6) :- no_gluten_sandwich(Sandwich), !.
delta(97, serve_sandwich(_, Child, _, _), 0.009987079843885617) :- goal_served(Child2), allergic_gluten(Child2), todo_served(Child), !.
delta(97, serve_sandwich(_, _, _, _), -0.0001343057661296065) :- goal_served(Child), allergic_gluten(Child), !.
delta(97, serve_sandwich(_, Child, _, _), 0.00036563349312618087) :- todo_served(Child), !.
delta(97, serve_sandwich(_, _, _, _), -0.0003282781864415666) :- !.
delta(97, move_tray(_, _, Place), 0.0004487468314643486) :- fewer_at_2_than_allergic_gluten, fewer_ontray_1_than_todo_served, done_served(Child), waiting(Child, Place), !.
delta(97, move_tray(_, Place, Place2), 3.221460757816671e-5) :- fewer_at_2_than_allergic_gluten, fewer_ontray_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(97, move_tray(_, _, _), -0.001713878992037617) :- fewer_at_2_than_allergic_gluten, fewer_ontray_1_than_todo_served, !.
delta(97, move_tray(Tray, Place, _), -1.000134805126876e-6) :- fewer_at_2_than_allergic_gluten, ontray(_, Tray), todo_served(Child), waiting(Child, Place), !.
delta(97, move_tray(Tray, _, _), 0.0044258893869115875) :- fewer_at_2_than_allergic_gluten, ontray(_, Tray), !.
delta(97, move_tray(_, _, _), -0.00010959576692671794) :- fewer_at_2_than_allergic_gluten, !.
delta(97, move_tray(_, _, _), -0.296298608504802) :- fewer_ontray_2_than_todo_served, !.
delta(97, move_tray(Tray, _, Place), -0.00014797165451910634) :- could_serve_sandwich(Tray, Place), at(_, Place), !.
delta(97, move_tray(Tray, _, Place), 0.0008095859724774254) :- could_serve_sandwich(Tray, Place), !.
delta(97, move_tray(Tray, _, Place), 6.388447623102783e-5) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(97, move_tray(_, _, _), -0.0009926091299525056) :- !.
delta(97, _, 0.0).

% tree 98: step size 1.0, 221 examples, 41 leaves
delta(98, make_sandwich_no_gluten(_, _, _), 0.06706937402968466) :- !.
delta(98, make_sandwich(_, _, _), -0.007919345224862333) :- fewer_ontray_2_than_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(98, make_sandwich(_, _, _), 0.006473150041354287) :- fewer_ontray_2_than_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(98, make_sandwich(_, _, _), -0.13098613154615202) :- fewer_ontray_2_than_not_allergic_gluten, fewer_at_2_than_todo_served, !.
delta(98, make_sandwich(_, _, _), 1.5072322547372441e-5) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(98, make_sandwich(_, _, _), 0.002691409691766918) :- fewer_at_2_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(98, make_sandwich(_, _, _), -2.4628950872942273e-5) :- fewer_at_2_than_todo_served, !.
delta(98, make_sandwich(_, _, _), -0.00014440392443957028) :- !.
delta(98, put_on_tray(_, Tray), 0.014874699132087154) :- fewer_ontray_1_than_todo_served, ontray(_, Tray), !.
delta(98, put_on_tray(_, _), -0.002772578294730139) :- fewer_ontray_1_than_todo_served, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_at_2_than_todo_served, !.
delta(98, put_on_tray(_, _), 1.5137947831466045e-6) :- fewer_ontray_1_than_todo_served, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(98, put_on_tray(_, _), 5.3760346309666965e-5) :- fewer_ontray_1_than_todo_served, !.
delta(98, put_on_tray(_, _), -0.0033554686138415513) :- !.
delta(98, serve_sandwich_no_gluten(_, _, _, _), 0.00024063750440534096) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_bread(_), !.
delta(98, serve_sandwich_no_gluten(_, _, _, _), -0.018148434676631117) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(98, serve_sandwich_no_gluten(_, _, _, _), 0.0005593705170561624) :- !.
delta(98, serve_sandwich(_, _, _, _), 0.02917438851964723) :- no_gluten_sandwich(_), fewer_ontray_2_than_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(98, serve_sandwich(Sandwich, _, _, Place), -0.0002739247756025049) :- no_gluten_sandwich(_), fewer_ontray_2_than_allergic_gluten, ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(98, serve_sandwich(_, _, _, _), 0.00017832151965368456) :- no_gluten_sandwich(_), fewer_ontray_2_than_allergic_gluten, !.
delta(98, serve_sandwich(_, _, _, _), -0.23155441606952046) :- no_gluten_sandwich(_), at_kitchen_sandwich(_), !.
delta(98, serve_sandwich(Sandwich, _, _, Place), -0.000400331686333903) :- no_gluten_sandwich(_), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(98, serve_sandwich(_, _, _, _), 0.0028381883406427225) :- no_gluten_sandwich(_), !.
delta(98, serve_sandwich(_, _, _, _), 0.03760570959564102) :- fewer_ontray_1_than_todo_served, !.
delta(98, serve_sandwich(_, Child, _, _), 0.00014524048914450077) :- todo_served(Child), !.
delta(98, serve_sandwich(_, _, _, _), -5.508179990713841e-5) :- !.
delta(98, move_tray(Tray, _, Place), -0.027252826449070476) :- needed_at_to_serve_sandwich_no_gluten(Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_serve_sandwich(Tray2, Place), fewer_ontray_2_than_todo_served, !.
delta(98, move_tray(Tray, _, Place), 0.000701063404027205) :- needed_at_to_serve_sandwich_no_gluten(Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_serve_sandwich(Tray2, Place), !.
delta(98, move_tray(Tray, _, Place), -0.0010156903662548594) :- needed_at_to_serve_sandwich_no_gluten(Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(98, move_tray(Tray, _, Place), 0.022252281501225643) :- needed_at_to_serve_sandwich_no_gluten(Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(98, move_tray(Tray, _, Place), 0.2608941172354234) :- needed_at_to_serve_sandwich_no_gluten(Place), fewer_no_gluten_sandwich_than_todo_served, ontray(_, Tray), !.
delta(98, move_tray(_, _, Place), -0.00017473271793425264) :- needed_at_to_serve_sandwich_no_gluten(Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(98, move_tray(_, _, Place), 0.006939594768479078) :- needed_at_to_serve_sandwich_no_gluten(Place), allergic_gluten(Child), waiting(Child, Place), !.
delta(98, move_tray(_, _, Place), -0.013868845537373048) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(98, move_tray(Tray, _, Place), 0.0013454335766254386) :- goal_served(Child), done_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), could_put_on_tray(Tray, Place), !.
delta(98, move_tray(Tray, _, _), -0.00018437554326543283) :- goal_served(Child), done_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(98, move_tray(_, _, _), -2.440000950360541e-7) :- goal_served(Child), done_served(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(98, move_tray(_, _, _), -0.03543108066689248) :- goal_served(Child), done_served(Child), !.
delta(98, move_tray(Tray, _, _), -0.00497683030895253) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(98, move_tray(_, _, _), 0.023634369680178194) :- fewer_ontray_1_than_todo_served, !.
delta(98, move_tray(_, _, _), -0.0017445488935211742) :- !.
delta(98, _, 0.0).

% tree 99: step size 1.0, 243 examples, 39 leaves
delta(99, make_sandwich_no_gluten(_, _, _), 8.399364845822282e-5) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(99, make_sandwich_no_gluten(_, _, _), -0.1971112266712017) :- fewer_at_1_than_allergic_gluten, !.
delta(99, make_sandwich_no_gluten(_, _, _), 0.12326137248972559) :- !.
delta(99, make_sandwich(_, _, Content_portion), -0.025465940536682923) :- no_gluten_content(Content_portion), !.
delta(99, make_sandwich(_, _, _), 3.688563369472356e-5) :- goal_served(Child), done_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(99, make_sandwich(_, _, _), -0.0019968319155910974) :- goal_served(Child), done_served(Child), !.
delta(99, make_sandwich(_, _, _), 0.2596763520784474) :- todo_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(99, make_sandwich(_, _, _), -5.193742228104924e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(99, make_sandwich(_, _, _), 0.00032891697833048244) :- !.
delta(99, put_on_tray(_, Tray), 0.030833483291924722) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(99, put_on_tray(_, _), -0.03220045541948179) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(99, put_on_tray(Sandwich, _), 0.0026903194886584705) :- no_gluten_sandwich(Sandwich), !.
delta(99, put_on_tray(_, _), -0.0018820287456722132) :- todo_served(Child), allergic_gluten(Child), !.
delta(99, put_on_tray(_, _), 0.00019861495018401557) :- !.
delta(99, serve_sandwich_no_gluten(_, _, _, _), 3.779301243416031e-5) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(99, serve_sandwich_no_gluten(_, _, _, _), -0.018046112486306456) :- !.
delta(99, serve_sandwich(_, _, _, _), 0.0018272780503777596) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_bread(_), !.
delta(99, serve_sandwich(_, Child, _, _), 0.0005508810258806582) :- fewer_ontray_1_than_not_allergic_gluten, no_gluten_sandwich(_), todo_served(Child), !.
delta(99, serve_sandwich(_, _, _, _), -0.00010974269186914159) :- fewer_ontray_1_than_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(99, serve_sandwich(_, Child, _, _), 0.05977918726697363) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(99, serve_sandwich(_, _, _, _), -0.00017156374617134743) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(99, serve_sandwich(Sandwich, _, _, _), -0.032093010593280444) :- no_gluten_sandwich(Sandwich), !.
delta(99, serve_sandwich(_, _, _, _), -0.0261641336008182) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(99, serve_sandwich(_, _, _, _), 0.0) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(99, serve_sandwich(_, _, _, _), 0.032222421240770655) :- done_served(Child), allergic_gluten(Child), !.
delta(99, serve_sandwich(_, _, _, _), -0.00010907530062731381) :- !.
delta(99, move_tray(_, _, Place), -0.005172989332824896) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(99, move_tray(_, _, Place), 5.026549446826088e-5) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), waiting(Child, Place), !.
delta(99, move_tray(Tray, _, Place), -6.052447979714005e-6) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), could_put_on_tray(Tray, Place), !.
delta(99, move_tray(_, _, _), 0.055937580158893295) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(99, move_tray(_, Place, Place2), -0.007879700108434135) :- done_served(Child), allergic_gluten(Child), allergic_gluten(Child2), waiting(Child2, Place2), waiting(Child, Place), !.
delta(99, move_tray(_, _, Place), 0.025103651405559573) :- done_served(Child), allergic_gluten(Child), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(99, move_tray(_, _, _), -0.019886570430409735) :- done_served(Child), allergic_gluten(Child), !.
delta(99, move_tray(_, Place, Place2), 0.017162890363446568) :- allergic_gluten(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(99, move_tray(_, Place, _), -0.00018148249021532984) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(99, move_tray(_, _, _), -0.21821421865106067) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(99, move_tray(Tray, _, _), 0.0010971972949126933) :- ontray(_, Tray), !.
delta(99, move_tray(_, _, _), -0.0010360817413164918) :- !.
delta(99, _, 0.0).

% tree 100: step size 1.0, 227 examples, 35 leaves
delta(100, make_sandwich_no_gluten(_, _, _), 0.1156577089040696) :- fewer_at_1_than_allergic_gluten, !.
delta(100, make_sandwich_no_gluten(_, _, _), 0.01141570847496219) :- at_kitchen_sandwich(_), !.
delta(100, make_sandwich_no_gluten(_, _, _), -0.01932750556579039) :- fewer_at_2_than_allergic_gluten, !.
delta(100, make_sandwich_no_gluten(_, _, _), 0.00016844755422696105) :- !.
delta(100, make_sandwich(_, Bread_portion, _), -0.003946774867262913) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), no_gluten_bread(Bread_portion), !.
delta(100, make_sandwich(_, _, _), 0.0026724580358267274) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(100, make_sandwich(_, _, _), -0.0018084465806193436) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(100, make_sandwich(_, _, _), -0.16868266267534873) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(100, make_sandwich(_, _, _), -1.3387654920451188e-5) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(100, make_sandwich(_, _, _), 0.0012109958633920318) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(100, make_sandwich(_, _, _), -0.00014554816427662644) :- !.
delta(100, put_on_tray(_, Tray), 0.005246720799672273) :- fewer_ontray_1_than_not_allergic_gluten, ontray(_, Tray), !.
delta(100, put_on_tray(_, _), 0.0033087945835897775) :- fewer_ontray_1_than_not_allergic_gluten, notexist(_), !.
delta(100, put_on_tray(_, _), -0.003565566434975519) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(100, put_on_tray(_, _), 1.813109144882664e-5) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(100, put_on_tray(_, _), 0.00011337119620499813) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(100, put_on_tray(_, _), -0.01606700044765901) :- !.
delta(100, serve_sandwich_no_gluten(_, _, _, Place), 1.7221832678821873e-6) :- done_served(Child), waiting(Child, Place), notexist(_), !.
delta(100, serve_sandwich_no_gluten(_, _, _, Place), -0.0008285031714735569) :- done_served(Child), waiting(Child, Place), !.
delta(100, serve_sandwich_no_gluten(_, _, _, _), 0.0010560200768557212) :- !.
delta(100, serve_sandwich(Sandwich, _, _, _), -0.02995265349963285) :- no_gluten_sandwich(Sandwich), !.
delta(100, serve_sandwich(_, _, _, _), 0.037646654358115934) :- goal_served(Child), done_served(Child), !.
delta(100, serve_sandwich(_, _, Tray, _), -0.0005857361814615666) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(100, serve_sandwich(_, _, _, _), 2.2401901467877262e-5) :- !.
delta(100, move_tray(_, _, Place), -0.00016815456570940893) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_2_than_not_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(100, move_tray(_, _, Place), 0.047282865168907104) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_2_than_not_allergic_gluten, !.
delta(100, move_tray(_, _, Place), -0.0021212265446767424) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(100, move_tray(_, _, Place), 0.0010508891244352333) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(100, move_tray(Tray, _, Place), 0.0034170444275343228) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), could_put_on_tray(Tray, Place), !.
delta(100, move_tray(_, _, _), -0.00410671903592416) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(100, move_tray(_, Place, Place2), -0.00028716753577993367) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(100, move_tray(_, Place, Place2), -0.00016494948941790807) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(100, move_tray(_, Place, Place2), 0.002814734384858797) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(100, move_tray(_, _, _), -0.015546828889068925) :- !.
delta(100, _, 0.0).

% tree 101: step size 1.0, 215 examples, 37 leaves
delta(101, make_sandwich_no_gluten(_, _, _), 0.16015860353259934) :- !.
delta(101, make_sandwich(_, _, _), -0.21573558256388778) :- todo_served(Child), allergic_gluten(Child), fewer_at_1_than_todo_served, !.
delta(101, make_sandwich(_, _, _), -0.00017039527840020238) :- todo_served(Child), allergic_gluten(Child), !.
delta(101, make_sandwich(_, _, _), -0.014495216050695517) :- at_kitchen_sandwich(_), !.
delta(101, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_allergic_gluten, !.
delta(101, make_sandwich(_, _, _), 0.014815719380189241) :- !.
delta(101, put_on_tray(_, _), 0.03671006813779188) :- !.
delta(101, serve_sandwich_no_gluten(_, _, _, _), 0.0011864255817798464) :- fewer_ontray_1_than_todo_served, !.
delta(101, serve_sandwich_no_gluten(_, _, _, _), -0.02282241485408421) :- fewer_no_gluten_sandwich_than_todo_served, notexist(_), !.
delta(101, serve_sandwich_no_gluten(_, _, _, _), 9.467645591805053e-6) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(101, serve_sandwich_no_gluten(_, _, _, _), 0.0001928132172770958) :- !.
delta(101, serve_sandwich(_, _, Tray, _), 0.0012641220034603953) :- fewer_at_1_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(101, serve_sandwich(_, _, _, _), -0.40663273132241845) :- fewer_at_1_than_allergic_gluten, fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(101, serve_sandwich(_, _, _, _), 4.379108561112994e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(101, serve_sandwich(_, _, _, Place), -0.0010319093489571183) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), waiting(Child, Place), !.
delta(101, serve_sandwich(_, _, _, _), 0.0017481465434036549) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(101, serve_sandwich(_, _, _, _), -0.014522707159298764) :- at_kitchen_bread(_), !.
delta(101, serve_sandwich(_, _, _, _), 0.06020188272965487) :- fewer_no_gluten_sandwich_than_todo_served, goal_served(Child), done_served(Child), !.
delta(101, serve_sandwich(_, _, _, _), 0.0022233952413746355) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(101, serve_sandwich(_, Child, _, _), 7.338057558166658e-5) :- todo_served(Child), !.
delta(101, serve_sandwich(_, _, _, _), -0.00010286213565057231) :- !.
delta(101, move_tray(_, Place, Place2), -0.004588627674016695) :- notexist(_), fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(101, move_tray(_, Place, Place2), 0.02804829447755691) :- notexist(_), fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(101, move_tray(_, Place, _), -1.1265274789740988e-6) :- notexist(_), fewer_ontray_1_than_todo_served_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(101, move_tray(_, _, _), -0.026735236876774184) :- notexist(_), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(101, move_tray(Tray, Place, _), -0.00016856737306825595) :- notexist(_), ontray(_, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(101, move_tray(Tray, _, _), 0.4428249693845728) :- notexist(_), ontray(_, Tray), !.
delta(101, move_tray(_, _, _), -0.008356324304031465) :- notexist(_), fewer_at_1_than_allergic_gluten, !.
delta(101, move_tray(_, _, _), 7.769096216439645e-6) :- notexist(_), !.
delta(101, move_tray(_, Place, _), -0.08388788258637822) :- fewer_at_2_than_todo_served, at(Tray, Place), ontray(_, Tray), !.
delta(101, move_tray(_, _, Place), -0.0007825500763000037) :- fewer_at_2_than_todo_served, todo_served(Child), waiting(Child, Place), !.
delta(101, move_tray(_, _, _), 0.0007825500763000037) :- fewer_at_2_than_todo_served, !.
delta(101, move_tray(Tray, _, Place), 0.0006916448468685613) :- todo_served(Child), waiting(Child, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(101, move_tray(_, _, Place), -8.976071995794742e-5) :- todo_served(Child), waiting(Child, Place), !.
delta(101, move_tray(_, _, _), 5.5262847396518975e-6) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(101, move_tray(_, _, _), -0.0010163214347020794) :- !.
delta(101, _, 0.0).

% tree 102: step size 1.0, 243 examples, 39 leaves
delta(102, make_sandwich_no_gluten(_, _, _), 0.02136468909181174) :- fewer_at_1_than_allergic_gluten, !.
delta(102, make_sandwich_no_gluten(_, _, _), 0.0008308128423995226) :- at_kitchen_sandwich(_), !.
delta(102, make_sandwich_no_gluten(_, _, _), -0.01614265988984347) :- fewer_at_2_than_allergic_gluten, !.
delta(102, make_sandwich_no_gluten(_, _, _), 0.00013361716135942226) :- !.
delta(102, make_sandwich(_, _, _), -0.033903637532715476) :- fewer_at_1_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(102, make_sandwich(_, _, _), 0.0020788698249507333) :- fewer_at_1_than_allergic_gluten, !.
delta(102, make_sandwich(_, _, _), -0.00845716759706995) :- no_gluten_sandwich(_), fewer_at_2_than_todo_served, !.
delta(102, make_sandwich(_, _, _), 0.0001621265168935505) :- no_gluten_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(102, make_sandwich(_, _, _), -7.14036476308493e-5) :- no_gluten_sandwich(_), !.
delta(102, make_sandwich(_, Bread_portion, _), -0.0008156249655466435) :- no_gluten_bread(Bread_portion), !.
delta(102, make_sandwich(_, _, _), 0.02412255786287298) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(102, make_sandwich(_, _, _), -7.621714939482774e-6) :- !.
delta(102, put_on_tray(_, _), 0.010371274298271461) :- todo_served(Child), allergic_gluten(Child), no_gluten_sandwich(_), !.
delta(102, put_on_tray(_, _), -2.6741825390128776e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(102, put_on_tray(_, Tray), 4.995362633492993e-5) :- ontray(_, Tray), done_served(Child), not_allergic_gluten(Child), !.
delta(102, put_on_tray(_, Tray), -0.013336240748985626) :- ontray(_, Tray), !.
delta(102, put_on_tray(_, _), 0.002114325509243521) :- !.
delta(102, serve_sandwich_no_gluten(_, _, _, _), -0.011398032179353017) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(102, serve_sandwich_no_gluten(_, _, _, _), 1.1611574318905123e-6) :- fewer_ontray_1_than_allergic_gluten, !.
delta(102, serve_sandwich_no_gluten(_, _, _, _), 0.003182014763771563) :- !.
delta(102, serve_sandwich(Sandwich, _, _, _), -0.02200790148718333) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(102, serve_sandwich(Sandwich, _, _, _), 0.00039306420380385627) :- no_gluten_sandwich(Sandwich), !.
delta(102, serve_sandwich(_, Child, _, _), 0.0012415381454325336) :- todo_served(Child), at_kitchen_bread(_), done_served(Child2), not_allergic_gluten(Child2), !.
delta(102, serve_sandwich(_, Child, _, _), -0.0018266924214754036) :- todo_served(Child), at_kitchen_bread(_), !.
delta(102, serve_sandwich(_, Child, _, _), 0.03434464645890712) :- todo_served(Child), !.
delta(102, serve_sandwich(_, _, _, _), -0.008434284502729641) :- !.
delta(102, move_tray(_, _, kitchen), 0.00013850172306984485) :- done_served(Child), allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(102, move_tray(_, _, kitchen), -0.008128127578110099) :- done_served(Child), allergic_gluten(Child), !.
delta(102, move_tray(Tray, _, kitchen), -0.004680977751191454) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(102, move_tray(_, _, kitchen), -0.00020815777543994063) :- at(_, kitchen), !.
delta(102, move_tray(_, _, kitchen), 0.06067913523753811) :- !.
delta(102, move_tray(_, Place, _), 0.0031848828841535637) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, fewer_ontray_1_than_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(102, move_tray(_, _, _), -0.0030929847106528283) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(102, move_tray(_, _, _), -0.06145041558309077) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(102, move_tray(_, _, _), -1.9216380566729947e-6) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(102, move_tray(_, Place, Place2), 0.010931711855441305) :- needed_at_to_serve_sandwich_no_gluten(Place2), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(102, move_tray(_, _, Place), -0.0013064855415230304) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(102, move_tray(_, _, _), -0.0039732385447648535) :- !.
delta(102, _, 0.0).

% tree 103: step size 1.0, 229 examples, 45 leaves
delta(103, make_sandwich_no_gluten(_, _, _), 0.03980535560837103) :- fewer_at_2_than_allergic_gluten, !.
delta(103, make_sandwich_no_gluten(_, _, _), -0.10835025496529155) :- fewer_at_1_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(103, make_sandwich_no_gluten(_, _, _), 9.4988080783393e-6) :- fewer_at_1_than_todo_served, !.
delta(103, make_sandwich_no_gluten(_, _, _), 0.00024014961441974592) :- !.
delta(103, make_sandwich(_, _, _), -0.06080880521319032) :- fewer_at_2_than_allergic_gluten, !.
delta(103, make_sandwich(_, Bread_portion, _), -0.0010722151853833788) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), no_gluten_bread(Bread_portion), !.
delta(103, make_sandwich(_, _, _), 0.09612777009816194) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), fewer_at_1_than_todo_served, !.
delta(103, make_sandwich(_, _, _), -0.00016677630301094722) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(103, make_sandwich(_, _, _), -0.002452053963899273) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(103, make_sandwich(_, _, _), 0.012801757459770816) :- at_kitchen_sandwich(_), !.
delta(103, make_sandwich(_, _, _), 7.082946177897169e-5) :- goal_served(Child), done_served(Child), !.
delta(103, make_sandwich(_, _, _), -0.011682348793162219) :- !.
delta(103, put_on_tray(_, _), 0.008470431043424573) :- fewer_ontray_1_than_todo_served, !.
delta(103, put_on_tray(_, _), -0.0005889507311670841) :- !.
delta(103, serve_sandwich_no_gluten(_, _, _, _), 0.004327018616172004) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(103, serve_sandwich_no_gluten(_, _, _, _), 1.0280867263654205e-6) :- fewer_ontray_2_than_allergic_gluten, !.
delta(103, serve_sandwich_no_gluten(Sandwich, _, _, Place), -0.016166521995659523) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(103, serve_sandwich_no_gluten(_, _, _, _), 0.00010333774951117166) :- !.
delta(103, serve_sandwich(_, _, _, _), 0.014304500061487526) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), fewer_ontray_1_than_todo_served, !.
delta(103, serve_sandwich(_, _, _, _), -4.303674068806193e-5) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(103, serve_sandwich(_, _, _, _), -0.18433870981880715) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(103, serve_sandwich(Sandwich, _, _, _), -0.01614561102780849) :- done_served(Child), not_allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(103, serve_sandwich(_, _, _, _), 0.01554554781369916) :- done_served(Child), not_allergic_gluten(Child), !.
delta(103, serve_sandwich(_, _, _, _), -0.013063252917097106) :- at_kitchen_sandwich(_), notexist(_), !.
delta(103, serve_sandwich(_, _, _, _), 0.012580512879364576) :- at_kitchen_sandwich(_), !.
delta(103, serve_sandwich(_, _, _, _), 0.02017393681849173) :- at_kitchen_bread(_), !.
delta(103, serve_sandwich(_, _, _, Place), -0.00014190254000470828) :- done_served(Child), waiting(Child, Place), !.
delta(103, serve_sandwich(_, _, _, _), 0.0005170630532971873) :- !.
delta(103, move_tray(_, _, Place), 0.026649768708995693) :- goal_served(Child), done_served(Child), waiting(Child, Place2), needed_at_to_serve_sandwich_no_gluten(Place2), waiting(Child, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(103, move_tray(_, _, Place), -0.001362119688682995) :- goal_served(Child), done_served(Child), waiting(Child, Place2), needed_at_to_serve_sandwich_no_gluten(Place2), waiting(Child, Place), !.
delta(103, move_tray(_, _, _), 0.0016430853328576252) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), fewer_at_1_than_allergic_gluten, !.
delta(103, move_tray(_, _, _), -0.03772305658992366) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(103, move_tray(Tray, _, Place), -0.0005732591484171437) :- goal_served(Child), done_served(Child), ontray(_, Tray), waiting(Child, Place), !.
delta(103, move_tray(Tray, _, _), 0.18891580230936383) :- goal_served(Child), done_served(Child), ontray(_, Tray), !.
delta(103, move_tray(_, Place, Place2), 0.0016539432820568071) :- goal_served(Child), done_served(Child), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(103, move_tray(_, _, _), -0.0035209988896460795) :- goal_served(Child), done_served(Child), !.
delta(103, move_tray(Tray, _, Place), 0.0007297273909846821) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), could_serve_sandwich(Tray, Place), !.
delta(103, move_tray(_, _, Place), -6.856061915020928e-6) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(103, move_tray(_, _, Place), -0.017645604145166045) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(103, move_tray(_, _, Place), 0.0) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(103, move_tray(Tray, _, _), -0.0016702272159749827) :- ontray(_, Tray), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(103, move_tray(Tray, _, _), 0.01805191182405087) :- ontray(_, Tray), !.
delta(103, move_tray(_, _, _), 1.253178099050683e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(103, move_tray(_, _, _), -0.014762984197655047) :- !.
delta(103, _, 0.0).

% tree 104: step size 1.0, 245 examples, 33 leaves
delta(104, make_sandwich_no_gluten(_, _, _), 0.07014589924456044) :- !.
delta(104, make_sandwich(_, _, _), 0.006782954285219171) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(104, make_sandwich(_, _, _), -1.882880305802442e-5) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(104, make_sandwich(_, _, _), -0.0018199644227748983) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, !.
delta(104, make_sandwich(_, _, _), 0.0) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(104, make_sandwich(_, _, _), -0.12451887678026642) :- goal_served(Child), allergic_gluten(Child), !.
delta(104, make_sandwich(_, _, _), 0.018340995202923607) :- at_kitchen_sandwich(_), !.
delta(104, make_sandwich(_, _, _), 1.1379481248206443e-6) :- !.
delta(104, put_on_tray(_, Tray), 0.008778484661502009) :- ontray(_, Tray), !.
delta(104, put_on_tray(_, _), -0.025062697989731885) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(104, put_on_tray(_, _), 1.3980105801013983e-5) :- !.
delta(104, serve_sandwich_no_gluten(_, _, _, Place), 0.0005073198096018882) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, not_allergic_gluten(Child), waiting(Child, Place), !.
delta(104, serve_sandwich_no_gluten(_, _, _, _), -0.021650909071848842) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(104, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(104, serve_sandwich_no_gluten(_, _, _, _), 0.0012276259625758797) :- !.
delta(104, serve_sandwich(_, _, _, _), -0.04743188146361224) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(104, serve_sandwich(Sandwich, _, _, _), -0.010764796372610038) :- notexist(_), no_gluten_sandwich(Sandwich), !.
delta(104, serve_sandwich(_, Child, _, _), 0.05139315014738451) :- notexist(_), todo_served(Child), !.
delta(104, serve_sandwich(_, _, _, _), -0.00023578413800443015) :- notexist(_), !.
delta(104, serve_sandwich(_, _, _, _), -0.014184658756885083) :- at_kitchen_sandwich(_), !.
delta(104, serve_sandwich(_, _, _, Place), 8.968029204671995e-6) :- done_served(Child), waiting(Child, Place), !.
delta(104, serve_sandwich(_, _, _, _), 0.0031806345619080295) :- !.
delta(104, move_tray(_, _, Place), -0.002217193069415462) :- fewer_ontray_1_than_todo_served, no_gluten_bread(_), todo_served(Child), waiting(Child, Place), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(104, move_tray(_, _, Place), 0.08127673819987541) :- fewer_ontray_1_than_todo_served, no_gluten_bread(_), todo_served(Child), waiting(Child, Place), !.
delta(104, move_tray(_, _, _), 0.014634375631831006) :- fewer_ontray_1_than_todo_served, no_gluten_bread(_), todo_served(Child), allergic_gluten(Child), !.
delta(104, move_tray(_, _, _), -0.01910454890789423) :- fewer_ontray_1_than_todo_served, no_gluten_bread(_), !.
delta(104, move_tray(_, _, _), -0.023546266522760876) :- fewer_ontray_1_than_todo_served, notexist(_), !.
delta(104, move_tray(_, _, Place), -0.007111909117905374) :- fewer_ontray_1_than_todo_served, goal_served(Child), waiting(Child, Place), !.
delta(104, move_tray(_, _, _), 0.02220318609016844) :- fewer_ontray_1_than_todo_served, !.
delta(104, move_tray(_, Place, _), -0.01578607528830343) :- todo_served(Child), waiting(Child, Place), !.
delta(104, move_tray(_, Place, Place2), 0.007861500119862053) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(104, move_tray(_, _, _), -0.007774637288439257) :- !.
delta(104, _, 0.0).

% tree 105: step size 1.0, 249 examples, 30 leaves
delta(105, make_sandwich_no_gluten(_, _, _), 0.08392958825463204) :- !.
delta(105, make_sandwich(_, _, _), -0.12000974364809291) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(105, make_sandwich(_, _, _), 2.151679672732211e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(105, make_sandwich(_, _, _), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(105, make_sandwich(_, _, _), 0.00031056404556303305) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(105, make_sandwich(_, _, _), 0.03814330887022617) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(105, make_sandwich(_, _, _), -2.5794587675856804e-5) :- !.
delta(105, put_on_tray(_, _), 0.00241870497511975) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(105, put_on_tray(_, _), -0.015070366078811957) :- at_kitchen_bread(_), no_gluten_bread(_), !.
delta(105, put_on_tray(_, _), 7.968270047896184e-5) :- at_kitchen_bread(_), !.
delta(105, put_on_tray(_, _), 0.0007520383125747212) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(105, put_on_tray(_, _), -0.0002361674011189187) :- !.
delta(105, serve_sandwich_no_gluten(_, Child, _, _), 0.004524664584696502) :- todo_served(Child), !.
delta(105, serve_sandwich_no_gluten(_, _, _, _), -0.027911605514356817) :- !.
delta(105, serve_sandwich(_, Child, _, _), 0.07182554596855947) :- goal_served(Child2), done_served(Child2), fewer_at_2_than_todo_served_not_allergic_gluten, goal_served(Child3), allergic_gluten(Child3), todo_served(Child), !.
delta(105, serve_sandwich(_, _, _, _), -1.5865519790142048e-5) :- goal_served(Child), done_served(Child), fewer_at_2_than_todo_served_not_allergic_gluten, goal_served(Child2), allergic_gluten(Child2), !.
delta(105, serve_sandwich(_, Child, _, _), 0.008270925260130992) :- goal_served(Child2), done_served(Child2), fewer_at_2_than_todo_served_not_allergic_gluten, todo_served(Child), !.
delta(105, serve_sandwich(_, _, _, _), -0.0005477187059257586) :- goal_served(Child), done_served(Child), fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(105, serve_sandwich(_, Child, _, _), 0.0) :- goal_served(Child2), done_served(Child2), todo_served(Child), fewer_ontray_2_than_todo_served, !.
delta(105, serve_sandwich(_, Child, _, _), 0.00021931465425877478) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(105, serve_sandwich(_, _, _, _), -0.00033276509937543497) :- goal_served(Child), done_served(Child), !.
delta(105, serve_sandwich(_, _, _, _), -0.013463488041927452) :- at_kitchen_sandwich(_), !.
delta(105, serve_sandwich(_, _, _, _), 0.0018856274874460475) :- !.
delta(105, move_tray(_, Place, Place2), -0.0005715359542126503) :- at(Tray, Place), could_put_on_tray(Tray, Place2), no_gluten_sandwich(Sandwich), fewer_ontray_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), !.
delta(105, move_tray(_, Place, Place2), 0.004522086847344393) :- at(Tray, Place), could_put_on_tray(Tray, Place2), no_gluten_sandwich(_), fewer_ontray_2_than_allergic_gluten, !.
delta(105, move_tray(_, Place, Place2), 0.00010528660162882949) :- at(Tray, Place), could_put_on_tray(Tray, Place2), no_gluten_sandwich(Sandwich), at_kitchen_sandwich(Sandwich), !.
delta(105, move_tray(_, Place, Place2), -0.02517505052124613) :- at(Tray, Place), could_put_on_tray(Tray, Place2), no_gluten_sandwich(_), !.
delta(105, move_tray(_, Place, Place2), 0.026910651182207583) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(105, move_tray(_, _, _), -0.05624704618723499) :- !.
delta(105, _, 0.0).

% tree 106: step size 1.0, 250 examples, 43 leaves
delta(106, make_sandwich_no_gluten(_, _, _), 0.015265304018154029) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(106, make_sandwich_no_gluten(_, _, _), -0.0382066778595268) :- fewer_at_2_than_allergic_gluten, !.
delta(106, make_sandwich_no_gluten(_, _, _), 0.021794253401108642) :- !.
delta(106, make_sandwich(_, _, _), 0.0006116525212417976) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(106, make_sandwich(_, _, _), -3.356736788918864e-6) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(106, make_sandwich(_, _, _), -0.0208918295819822) :- fewer_at_1_than_allergic_gluten, !.
delta(106, make_sandwich(_, _, _), 5.0692949726292695e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(106, make_sandwich(_, _, _), -0.0029080497788423984) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(106, make_sandwich(_, _, Content_portion), -1.0458276880408817e-6) :- fewer_at_1_than_todo_served, no_gluten_content(Content_portion), !.
delta(106, make_sandwich(_, _, _), 0.068471065843351) :- fewer_at_1_than_todo_served, !.
delta(106, make_sandwich(_, _, _), -0.0013492174415233832) :- todo_served(Child), allergic_gluten(Child), !.
delta(106, make_sandwich(_, _, _), 1.075034714423592e-6) :- !.
delta(106, put_on_tray(_, Tray), -0.0031778500404582933) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), ontray(Sandwich2, Tray), no_gluten_sandwich(Sandwich2), !.
delta(106, put_on_tray(_, _), 0.006406166818614625) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(106, put_on_tray(_, _), 1.295931197390489e-5) :- fewer_at_1_than_todo_served, at_kitchen_bread(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(106, put_on_tray(_, _), -0.03890993752382196) :- fewer_at_1_than_todo_served, at_kitchen_bread(_), !.
delta(106, put_on_tray(_, _), 0.00024887447128488883) :- fewer_at_1_than_todo_served, !.
delta(106, put_on_tray(_, _), 0.0013629694251373636) :- !.
delta(106, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_no_gluten_sandwich_than_todo_served, done_served(Child), allergic_gluten(Child), !.
delta(106, serve_sandwich_no_gluten(_, _, _, _), 0.001052520990608972) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(106, serve_sandwich_no_gluten(_, _, _, _), -0.0026594207219109533) :- goal_served(Child), done_served(Child), !.
delta(106, serve_sandwich_no_gluten(_, _, _, _), 6.477035508786951e-6) :- !.
delta(106, serve_sandwich(_, _, _, _), 0.007576730321879095) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(106, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(106, serve_sandwich(_, _, _, _), -0.07446546328364685) :- at_kitchen_sandwich(_), !.
delta(106, serve_sandwich(_, _, Tray, _), -0.001051246368587105) :- notexist(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(106, serve_sandwich(_, _, _, _), 0.032509824512949675) :- notexist(_), !.
delta(106, serve_sandwich(_, Child, _, _), 2.3692435862078146e-5) :- todo_served(Child), !.
delta(106, serve_sandwich(_, _, _, _), -0.00010570258910669572) :- !.
delta(106, move_tray(Tray, _, Place), 0.005678074871463053) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(106, move_tray(Tray, _, Place), -0.02963829609839892) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(106, move_tray(Tray, _, Place), 0.02905692672031068) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(106, move_tray(_, _, Place), -0.00018196671975077565) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(106, move_tray(_, Place, Place2), 0.00362747922349753) :- notexist(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(106, move_tray(_, _, _), -0.06183715789130779) :- notexist(_), !.
delta(106, move_tray(_, _, Place), 0.006364862865009381) :- goal_served(Child), done_served(Child), done_served(Child2), waiting(Child2, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(106, move_tray(_, _, Place), -9.610823897944457e-5) :- goal_served(Child), done_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(106, move_tray(Tray, _, _), 0.00023674004052200327) :- goal_served(Child), done_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(106, move_tray(_, _, _), -0.01662958164082766) :- goal_served(Child), done_served(Child), !.
delta(106, move_tray(_, _, _), 0.0742088965067622) :- fewer_at_1_than_not_allergic_gluten, !.
delta(106, move_tray(_, Place, Place2), 0.00024068099279808295) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(106, move_tray(_, _, _), -0.0010724585189165262) :- !.
delta(106, _, 0.0).

% tree 107: step size 1.0, 248 examples, 45 leaves
delta(107, make_sandwich_no_gluten(_, _, _), 0.0214545435134198) :- fewer_at_2_than_allergic_gluten, !.
delta(107, make_sandwich_no_gluten(_, _, _), 6.8752773349619425e-6) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(107, make_sandwich_no_gluten(_, _, _), -0.011815677708237675) :- fewer_at_1_than_not_allergic_gluten, !.
delta(107, make_sandwich_no_gluten(_, _, _), 0.0001546001565459056) :- !.
delta(107, make_sandwich(_, Bread_portion, _), -1.4994108992233937e-5) :- fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion2), no_gluten_bread(Bread_portion2), no_gluten_bread(Bread_portion), !.
delta(107, make_sandwich(_, _, _), 0.00671520822256703) :- fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(107, make_sandwich(_, _, _), -0.005716702747365446) :- fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(107, make_sandwich(_, _, _), -0.03463993843857248) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(107, make_sandwich(_, _, _), -0.00043117846524453793) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(107, make_sandwich(_, _, _), 0.06268714466481637) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(107, make_sandwich(_, _, _), -0.0037292832039236196) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(107, make_sandwich(_, _, _), 0.0009954612544891578) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(107, make_sandwich(_, _, _), -0.011346686212900468) :- !.
delta(107, put_on_tray(_, Tray), -0.015936715283355374) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(107, put_on_tray(_, Tray), 0.0025824261053093395) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, !.
delta(107, put_on_tray(_, Tray), 0.017474648580605323) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(107, put_on_tray(Sandwich, _), -0.0067553315629890935) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), fewer_at_2_than_allergic_gluten, !.
delta(107, put_on_tray(Sandwich, _), 0.0004322563498442959) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(107, put_on_tray(_, _), 0.006580635065447263) :- fewer_ontray_1_than_allergic_gluten, !.
delta(107, put_on_tray(_, _), -0.03943983466168173) :- at_kitchen_bread(_), !.
delta(107, put_on_tray(_, _), 5.427344255643683e-5) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(107, put_on_tray(_, _), -0.00020574679720627393) :- !.
delta(107, serve_sandwich_no_gluten(_, _, _, _), 0.0018486838631593659) :- !.
delta(107, serve_sandwich(_, _, _, Place), -0.0012923253218586378) :- at_kitchen_sandwich(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(107, serve_sandwich(_, _, _, _), 0.057710939765218586) :- at_kitchen_sandwich(_), !.
delta(107, serve_sandwich(_, _, _, _), 1.8422761221925037e-5) :- done_served(Child), allergic_gluten(Child), at_kitchen_bread(_), !.
delta(107, serve_sandwich(_, _, _, _), 0.0014042969244346894) :- done_served(Child), allergic_gluten(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(107, serve_sandwich(_, _, _, _), 1.1072254956023187e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(107, serve_sandwich(_, _, _, _), -0.014241489205051505) :- notexist(_), !.
delta(107, serve_sandwich(_, Child, _, _), 0.00017525201152737891) :- todo_served(Child), !.
delta(107, serve_sandwich(_, _, _, _), -0.00015600166072170395) :- !.
delta(107, move_tray(_, Place, _), -0.07130259254558263) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_todo_served_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(107, move_tray(_, Place, _), 0.0) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(107, move_tray(Tray, Place, Place2), 0.00020035775458940042) :- not_allergic_gluten(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place2), could_serve_sandwich(Tray, Place2), !.
delta(107, move_tray(_, Place, Place2), -0.0005254774467740137) :- not_allergic_gluten(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place2), !.
delta(107, move_tray(_, Place, _), 0.008533731823262412) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(107, move_tray(_, Place, _), -0.0002706861071424502) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(107, move_tray(_, _, Place), -0.05055548026287189) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(107, move_tray(Tray, _, Place), 0.0007001143030603643) :- done_served(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), !.
delta(107, move_tray(_, _, Place), -0.00017559592658287045) :- done_served(Child), waiting(Child, Place), !.
delta(107, move_tray(_, Place, Place2), 0.002905318392053265) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(107, move_tray(_, Place, Place2), -0.013971724033073712) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(107, move_tray(_, _, _), 0.0783326608956695) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(107, move_tray(_, _, _), -0.004914481498326359) :- !.
delta(107, _, 0.0).

% tree 108: step size 1.0, 217 examples, 38 leaves
delta(108, make_sandwich_no_gluten(_, _, _), 6.819984596696372e-5) :- at_kitchen_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(108, make_sandwich_no_gluten(_, _, _), 0.005063488171582289) :- at_kitchen_sandwich(_), !.
delta(108, make_sandwich_no_gluten(_, _, _), 4.2879072584878334e-19) :- fewer_at_1_than_allergic_gluten, !.
delta(108, make_sandwich_no_gluten(_, _, _), -0.021011062746105577) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(108, make_sandwich_no_gluten(_, _, _), 7.691334781427693e-5) :- !.
delta(108, make_sandwich(_, _, _), -0.027564319567483207) :- done_served(Child), not_allergic_gluten(Child), !.
delta(108, make_sandwich(_, _, _), -0.008491684071267212) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(108, make_sandwich(_, _, _), 0.0357761869572852) :- fewer_at_1_than_not_allergic_gluten, !.
delta(108, make_sandwich(_, _, _), -6.394584127256669e-5) :- !.
delta(108, put_on_tray(_, Tray), -0.014355503989244263) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(108, put_on_tray(_, Tray), 0.001161161717509071) :- ontray(_, Tray), !.
delta(108, put_on_tray(_, _), -6.0239518050434606e-5) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(108, put_on_tray(_, _), 0.009834575021402546) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(108, put_on_tray(Sandwich, _), 0.0009523352721117003) :- no_gluten_sandwich(Sandwich), !.
delta(108, put_on_tray(_, _), -0.0009511403474151776) :- !.
delta(108, serve_sandwich_no_gluten(_, _, _, _), -0.0005650753550365459) :- fewer_ontray_1_than_allergic_gluten, !.
delta(108, serve_sandwich_no_gluten(_, _, _, _), 0.0014040812857317147) :- !.
delta(108, serve_sandwich(Sandwich, _, _, _), -2.3524310303916653e-5) :- no_gluten_sandwich(Sandwich), fewer_ontray_2_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(108, serve_sandwich(Sandwich, _, _, _), 0.05312024912713172) :- no_gluten_sandwich(Sandwich), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(108, serve_sandwich(Sandwich, _, _, _), -0.007295231410989406) :- no_gluten_sandwich(Sandwich), !.
delta(108, serve_sandwich(_, _, _, _), 0.0002790577837312286) :- done_served(Child), allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(108, serve_sandwich(_, _, _, _), 0.010020964743214655) :- done_served(Child), allergic_gluten(Child), !.
delta(108, serve_sandwich(_, _, _, _), 0.010848024251199542) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(108, serve_sandwich(_, _, _, _), -0.009407994636693728) :- at_kitchen_bread(_), !.
delta(108, serve_sandwich(_, _, _, _), -0.07730552547214843) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(108, serve_sandwich(_, _, _, _), 8.879267595588425e-6) :- !.
delta(108, move_tray(_, Place, Place2), -0.03604154938839423) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), notexist(_), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(108, move_tray(_, Place, Place2), 0.0017053473580886176) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), notexist(_), fewer_at_1_than_allergic_gluten, !.
delta(108, move_tray(_, Place, Place2), -0.00018893346136478103) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), notexist(_), !.
delta(108, move_tray(_, Place, Place2), -0.0002053785228924836) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place2), !.
delta(108, move_tray(_, Place, Place2), -7.253355647794199e-5) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(108, move_tray(_, Place, Place2), 0.02738547379339622) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(108, move_tray(_, _, Place), -0.00167147116262382) :- at(_, Place), !.
delta(108, move_tray(Tray, _, Place), 0.0009787416492123661) :- done_served(Child), waiting(Child, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(108, move_tray(_, _, Place), -0.0012468305142919463) :- done_served(Child), waiting(Child, Place), !.
delta(108, move_tray(_, Place, _), -0.00010704845589840436) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(108, move_tray(_, _, _), 0.05253241845379887) :- !.
delta(108, _, 0.0).

% tree 109: step size 1.0, 254 examples, 43 leaves
delta(109, make_sandwich_no_gluten(_, _, _), 0.029696793384042137) :- fewer_at_1_than_allergic_gluten, !.
delta(109, make_sandwich_no_gluten(_, _, _), -0.03478755893187694) :- fewer_at_2_than_allergic_gluten, !.
delta(109, make_sandwich_no_gluten(_, _, _), 0.01709829899404421) :- !.
delta(109, make_sandwich(_, _, _), -0.039694649578179836) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(109, make_sandwich(_, _, _), 0.006856543452047095) :- fewer_at_1_than_allergic_gluten, !.
delta(109, make_sandwich(_, _, _), -0.00023061224039644504) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(109, make_sandwich(_, Bread_portion, _), -0.00013316978071827858) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(109, make_sandwich(_, _, _), 0.045424437478296484) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(109, make_sandwich(_, _, _), 0.0008497241377948759) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(109, make_sandwich(_, _, _), -7.426825355023878e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(109, make_sandwich(_, _, _), 5.8200658920327384e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(109, make_sandwich(_, _, _), -0.02066214727292371) :- !.
delta(109, put_on_tray(_, Tray), 0.0035110601381768045) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(109, put_on_tray(Sandwich, _), 0.0018019623523692985) :- no_gluten_sandwich(Sandwich), !.
delta(109, put_on_tray(_, _), 6.589321013167753e-5) :- goal_served(Child), done_served(Child), !.
delta(109, put_on_tray(_, _), -0.02575132919802588) :- !.
delta(109, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(109, serve_sandwich_no_gluten(_, _, _, _), 0.000722205733369882) :- !.
delta(109, serve_sandwich(_, _, _, Place), -0.21009742452987476) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served, done_served(Child2), waiting(Child2, Place), !.
delta(109, serve_sandwich(_, _, _, _), 0.0) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served, !.
delta(109, serve_sandwich(_, _, _, Place), -3.794832790777497e-5) :- done_served(Child), not_allergic_gluten(Child), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(109, serve_sandwich(_, Child, _, _), 0.004401645839178835) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(109, serve_sandwich(_, _, _, _), -5.292341030707533e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(109, serve_sandwich(Sandwich, _, _, _), -0.025045048859044964) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(109, serve_sandwich(Sandwich, _, _, _), 0.0020748173480304483) :- no_gluten_sandwich(Sandwich), !.
delta(109, serve_sandwich(Sandwich, _, _, Place), -0.00015776109732043412) :- no_gluten_bread(_), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(109, serve_sandwich(_, _, _, _), 0.05257404277384484) :- no_gluten_bread(_), !.
delta(109, serve_sandwich(_, _, _, _), 0.0001689778777915481) :- !.
delta(109, move_tray(_, _, Place), -0.00018354711230537325) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, notexist(_), waiting(Child, Place), !.
delta(109, move_tray(_, _, _), 0.2287259371797039) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, notexist(_), !.
delta(109, move_tray(_, _, Place), -0.007940489964435304) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child2), waiting(Child2, Place), !.
delta(109, move_tray(_, _, _), 0.00790262201191302) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(109, move_tray(_, kitchen, Place), 0.013553786943141017) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(109, move_tray(_, _, Place), -0.004650080235273727) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(109, move_tray(_, _, _), 2.7851020131781172e-5) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(109, move_tray(_, _, _), -0.02960032240467198) :- done_served(Child), not_allergic_gluten(Child), !.
delta(109, move_tray(_, Place, Place2), 0.002350764034026947) :- fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(109, move_tray(Tray, _, _), 3.149036696775728e-5) :- fewer_ontray_1_than_allergic_gluten, at(Tray, kitchen), !.
delta(109, move_tray(_, _, _), -0.0012346153541816951) :- fewer_ontray_1_than_allergic_gluten, !.
delta(109, move_tray(_, _, Place), 0.0008927409562306145) :- at(_, Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(109, move_tray(_, _, Place), -1.3364624342986666e-5) :- at(_, Place), !.
delta(109, move_tray(_, _, _), -0.04412562874530977) :- !.
delta(109, _, 0.0).

% tree 110: step size 1.0, 207 examples, 25 leaves
delta(110, make_sandwich_no_gluten(_, _, _), 0.04156802541225344) :- !.
delta(110, make_sandwich(_, _, _), 2.2113363109647134e-5) :- fewer_at_1_than_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(110, make_sandwich(_, _, _), -0.05382115613887402) :- fewer_at_1_than_not_allergic_gluten, !.
delta(110, make_sandwich(_, _, _), 0.0018198181095502057) :- fewer_at_2_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(110, make_sandwich(_, _, _), -1.4280441233572476e-6) :- fewer_at_2_than_todo_served, !.
delta(110, make_sandwich(_, _, _), -4.1919447543055014e-5) :- !.
delta(110, put_on_tray(_, _), 0.00953324858962263) :- at_kitchen_bread(_), !.
delta(110, put_on_tray(_, _), 0.0002738275423436076) :- fewer_ontray_1_than_allergic_gluten, !.
delta(110, put_on_tray(_, _), 9.357226905657977e-5) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(110, put_on_tray(_, _), -0.004181567865099888) :- !.
delta(110, serve_sandwich_no_gluten(_, _, _, _), 0.003949993338664731) :- !.
delta(110, serve_sandwich(_, _, Tray, _), -0.002972201638859877) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(110, serve_sandwich(_, _, Tray, _), 0.00023625007394673903) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(110, serve_sandwich(_, Child, _, _), 0.05842025981245741) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(110, serve_sandwich(_, _, _, _), -0.0003106490401557867) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(110, serve_sandwich(_, _, _, _), 0.0015394195503300272) :- !.
delta(110, move_tray(_, _, _), 0.0) :- todo_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(110, move_tray(_, _, _), -0.07175309102763676) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(110, move_tray(Tray, _, Place), 4.08029379508915e-6) :- at(_, Place), at(Tray, kitchen), !.
delta(110, move_tray(_, _, Place), -0.0003781592840957418) :- at(_, Place), !.
delta(110, move_tray(_, Place, Place2), 4.2387464180733285e-5) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(110, move_tray(_, _, _), -0.00020330532658964604) :- fewer_ontray_2_than_allergic_gluten, !.
delta(110, move_tray(Tray, _, _), 0.0006330256303924316) :- ontray(_, Tray), !.
delta(110, move_tray(_, _, _), -1.7652644440148153e-5) :- !.
delta(110, _, 0.0).

% tree 111: step size 1.0, 234 examples, 41 leaves
delta(111, make_sandwich_no_gluten(_, _, _), 0.022449523568998264) :- !.
delta(111, make_sandwich(_, _, _), -0.003383753979426731) :- at_kitchen_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(111, make_sandwich(_, _, _), 2.651953621159668e-5) :- at_kitchen_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(111, make_sandwich(_, _, _), 0.03712865196634073) :- at_kitchen_sandwich(_), !.
delta(111, make_sandwich(_, _, _), -0.04289853441730716) :- fewer_at_1_than_todo_served, !.
delta(111, make_sandwich(_, _, _), 0.0010322896477611065) :- fewer_ontray_1_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(111, make_sandwich(_, _, _), -1.3022171078429892e-5) :- fewer_ontray_1_than_todo_served, !.
delta(111, make_sandwich(_, _, _), -0.00022516446228899233) :- !.
delta(111, put_on_tray(_, Tray), 0.007367967652299793) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(111, put_on_tray(_, Tray), -0.004180505289545257) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(_, Tray), fewer_at_2_than_allergic_gluten, !.
delta(111, put_on_tray(_, Tray), 3.8554932072355e-5) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(_, Tray), !.
delta(111, put_on_tray(_, _), 0.0009272635576436954) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(111, put_on_tray(_, _), 2.668531227256697e-5) :- fewer_at_1_than_todo_served, fewer_ontray_2_than_allergic_gluten, !.
delta(111, put_on_tray(_, _), -0.0362602457268337) :- fewer_at_1_than_todo_served, !.
delta(111, put_on_tray(_, _), 0.0005394424113119415) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(111, put_on_tray(_, _), -3.508966207846773e-5) :- !.
delta(111, serve_sandwich_no_gluten(_, _, _, _), 1.570331673054118e-6) :- fewer_ontray_1_than_allergic_gluten, !.
delta(111, serve_sandwich_no_gluten(_, _, _, _), 0.003105055550960284) :- !.
delta(111, serve_sandwich(_, Child, _, Place), 0.0007964091585899687) :- allergic_gluten(Child2), waiting(Child2, Place), fewer_ontray_2_than_allergic_gluten, todo_served(Child), !.
delta(111, serve_sandwich(_, _, _, Place), -2.5339277413322795e-5) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_allergic_gluten, !.
delta(111, serve_sandwich(_, _, _, Place), -0.22340231227487875) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(111, serve_sandwich(_, _, _, Place), 0.00021648504468352588) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(111, serve_sandwich(_, Child, _, _), 0.0) :- done_served(Child2), allergic_gluten(Child2), todo_served(Child), at_kitchen_bread(_), !.
delta(111, serve_sandwich(_, Child, _, _), 0.00015527776946838966) :- done_served(Child2), allergic_gluten(Child2), todo_served(Child), !.
delta(111, serve_sandwich(_, _, _, _), -5.326038860483072e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(111, serve_sandwich(_, _, _, _), 0.0) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(111, serve_sandwich(_, _, _, _), 0.03469206907636884) :- goal_served(Child), done_served(Child), !.
delta(111, serve_sandwich(_, _, _, _), 7.721119170035618e-6) :- !.
delta(111, move_tray(Tray, _, Place), 0.2228974339033862) :- done_served(Child), allergic_gluten(Child), needed_at_to_serve_sandwich_no_gluten(Place), ontray(_, Tray), !.
delta(111, move_tray(_, _, Place), -1.079216742426917e-5) :- done_served(Child), allergic_gluten(Child), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(111, move_tray(_, Place, _), -0.0015901430276278603) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), waiting(Child2, Place), !.
delta(111, move_tray(_, _, _), 0.0006487430441961465) :- done_served(Child), allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(111, move_tray(_, _, _), -0.0004092368045489743) :- done_served(Child), allergic_gluten(Child), !.
delta(111, move_tray(_, Place, _), -0.0004781171630951883) :- at(Tray, Place), could_put_on_tray(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(111, move_tray(_, Place, _), 0.006746233645749031) :- at(Tray, Place), could_put_on_tray(Tray, Place), goal_served(Child), not_allergic_gluten(Child), !.
delta(111, move_tray(_, Place, _), -3.86238015973586e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(111, move_tray(_, Place, Place2), 0.007478081459120014) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(111, move_tray(_, Place, _), -0.007363124855132815) :- done_served(Child), waiting(Child, Place), !.
delta(111, move_tray(_, Place, Place2), 0.005064576340245503) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(111, move_tray(_, _, _), -0.038601046101637136) :- !.
delta(111, _, 0.0).

% tree 112: step size 1.0, 240 examples, 32 leaves
delta(112, make_sandwich_no_gluten(_, _, _), 2.955315937616851e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(112, make_sandwich_no_gluten(_, _, _), 0.13173712963076314) :- !.
delta(112, make_sandwich(_, _, _), -0.002169567182956832) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(112, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(112, make_sandwich(_, _, _), 0.0005969802317994758) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(112, make_sandwich(_, _, _), -9.01852193439054e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(112, make_sandwich(_, _, _), -0.19435370164417212) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(112, make_sandwich(_, _, _), 7.823022182101555e-5) :- !.
delta(112, put_on_tray(_, Tray), 0.014159721941329485) :- ontray(_, Tray), !.
delta(112, put_on_tray(_, _), -0.0031165030988995162) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(112, put_on_tray(_, _), 0.0019625655335355516) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(112, put_on_tray(_, _), 5.138834707374481e-7) :- !.
delta(112, serve_sandwich_no_gluten(_, _, _, _), 0.002755904548952547) :- !.
delta(112, serve_sandwich(Sandwich, _, _, _), -0.021133927909458623) :- no_gluten_sandwich(Sandwich), fewer_ontray_2_than_todo_served, !.
delta(112, serve_sandwich(Sandwich, _, _, _), 3.065884307841011e-6) :- no_gluten_sandwich(Sandwich), !.
delta(112, serve_sandwich(_, Child, _, _), 0.04894582363488147) :- no_gluten_sandwich(_), todo_served(Child), !.
delta(112, serve_sandwich(_, _, _, _), -0.00038823139133660776) :- no_gluten_sandwich(_), !.
delta(112, serve_sandwich(_, _, _, _), -0.0005793825825220066) :- at_kitchen_bread(_), !.
delta(112, serve_sandwich(_, _, _, _), 0.0010234505697636843) :- fewer_ontray_2_than_todo_served, !.
delta(112, serve_sandwich(_, _, _, _), -1.9778284243043276e-5) :- !.
delta(112, move_tray(Tray, Place, Place2), 0.005003842685997379) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(_), could_put_on_tray(Tray, Place2), !.
delta(112, move_tray(_, Place, Place2), 0.0008214772493936344) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(_), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(112, move_tray(_, Place, _), -0.0009021776590417085) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(_), !.
delta(112, move_tray(Tray, Place, Place2), 0.0008885012713081683) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), could_serve_sandwich(Tray, Place2), !.
delta(112, move_tray(_, Place, Place2), -0.0003891804805573262) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(112, move_tray(Tray, Place, _), -0.01956052820662074) :- not_allergic_gluten(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(112, move_tray(_, Place, _), 0.00023775923913496385) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(112, move_tray(Tray, Place, Place2), -0.001425435865130831) :- could_serve_sandwich(Tray, Place2), at(Tray2, Place), could_put_on_tray(Tray2, Place), !.
delta(112, move_tray(Tray, _, Place), 0.016565306341957558) :- could_serve_sandwich(Tray, Place), !.
delta(112, move_tray(_, Place, Place2), 0.003935577068787453) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(112, move_tray(_, _, _), -0.0074295415983295955) :- !.
delta(112, _, 0.0).

% tree 113: step size 1.0, 206 examples, 35 leaves
delta(113, make_sandwich_no_gluten(_, _, _), 1.0656105290078513e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(113, make_sandwich_no_gluten(_, _, _), 0.031450591131995866) :- !.
delta(113, make_sandwich(_, _, _), -2.574494832128839e-6) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, fewer_ontray_1_than_allergic_gluten, !.
delta(113, make_sandwich(_, _, _), 0.012574421231784266) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(113, make_sandwich(_, _, _), -0.00020313744212554276) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(113, make_sandwich(_, _, _), 0.00016992054981812823) :- goal_served(Child), done_served(Child), !.
delta(113, make_sandwich(_, _, _), -0.06179775660844121) :- !.
delta(113, put_on_tray(_, _), 0.005366455798773753) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(113, put_on_tray(Sandwich, _), 0.0007912546381741464) :- no_gluten_sandwich(Sandwich), !.
delta(113, put_on_tray(_, _), -0.012545265300615099) :- !.
delta(113, serve_sandwich_no_gluten(_, Child, _, _), 0.0007085971870044994) :- todo_served(Child), !.
delta(113, serve_sandwich_no_gluten(_, _, _, _), -6.325958169005622e-5) :- !.
delta(113, serve_sandwich(_, _, _, Place), 0.0045626884471717645) :- done_served(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(113, serve_sandwich(_, Child, _, Place), 0.0) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), at_kitchen_bread(_), !.
delta(113, serve_sandwich(_, Child, _, Place), 0.00018270087054393758) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(113, serve_sandwich(_, _, _, Place), -0.00020000667613230146) :- done_served(Child), waiting(Child, Place), !.
delta(113, serve_sandwich(_, _, _, _), 0.007985193224114367) :- done_served(Child), allergic_gluten(Child), !.
delta(113, serve_sandwich(_, _, _, _), -0.23081754082187558) :- fewer_no_gluten_sandwich_than_todo_served, fewer_at_1_than_todo_served, !.
delta(113, serve_sandwich(_, _, _, _), 1.665619538575942e-5) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(113, serve_sandwich(_, _, _, _), 0.0013154202932485729) :- !.
delta(113, move_tray(_, Place, kitchen), 0.000598437037537224) :- done_served(Child), allergic_gluten(Child), at_kitchen_sandwich(_), waiting(Child, Place), !.
delta(113, move_tray(_, _, kitchen), -0.00021989730676606154) :- done_served(Child), allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(113, move_tray(_, _, kitchen), -0.003915851518244509) :- done_served(Child), allergic_gluten(Child), !.
delta(113, move_tray(_, _, kitchen), 0.27205087900646313) :- fewer_no_gluten_sandwich_than_todo_served, fewer_at_1_than_todo_served, !.
delta(113, move_tray(_, _, kitchen), -0.00019580504449809565) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(113, move_tray(_, _, kitchen), -0.0019701317578644487) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(113, move_tray(_, _, kitchen), 0.0006807412216569577) :- !.
delta(113, move_tray(_, Place, _), -0.005869562807968862) :- at(Tray, Place), could_put_on_tray(Tray, Place), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(113, move_tray(_, Place, Place2), 0.008812420760936116) :- at(Tray, Place), could_put_on_tray(Tray, Place), at(Tray2, Place), could_serve_sandwich_no_gluten(Tray2, Place2), !.
delta(113, move_tray(_, Place, _), -0.00040509146878719434) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(113, move_tray(_, _, Place), 8.913194309854156e-5) :- todo_served(Child), not_allergic_gluten(Child), at(_, Place), !.
delta(113, move_tray(_, _, _), -0.03036699882632466) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(113, move_tray(Tray, _, Place), 0.0006934907462635816) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(113, move_tray(_, _, _), -0.0007129356619191623) :- !.
delta(113, _, 0.0).

% tree 114: step size 1.0, 208 examples, 35 leaves
delta(114, make_sandwich_no_gluten(_, _, _), 0.011769875761066532) :- !.
delta(114, make_sandwich(_, _, _), -0.030059381467450092) :- fewer_ontray_2_than_not_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(114, make_sandwich(_, _, _), 1.4634133007321261e-5) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(114, make_sandwich(_, _, _), 0.0016600320971960638) :- fewer_ontray_1_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(114, make_sandwich(_, _, _), -1.6777597877214366e-5) :- fewer_ontray_1_than_todo_served, !.
delta(114, make_sandwich(_, _, _), -5.8068247242896506e-5) :- !.
delta(114, put_on_tray(_, _), 0.0013010327685547382) :- fewer_ontray_1_than_todo_served_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(114, put_on_tray(_, _), -0.010291561241862972) :- fewer_ontray_1_than_todo_served_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(114, put_on_tray(_, _), 0.0005834430219207717) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(114, put_on_tray(Sandwich, _), 0.006963822436753206) :- no_gluten_sandwich(Sandwich), !.
delta(114, put_on_tray(_, _), 0.003205754640347936) :- fewer_at_2_than_todo_served, !.
delta(114, put_on_tray(_, _), -0.007092930246708029) :- todo_served(Child), allergic_gluten(Child), !.
delta(114, put_on_tray(_, _), 3.858628609277065e-6) :- !.
delta(114, serve_sandwich_no_gluten(_, _, _, _), 0.00032167711266609106) :- !.
delta(114, serve_sandwich(_, _, _, _), -0.10993556174592788) :- fewer_ontray_1_than_allergic_gluten, fewer_at_2_than_todo_served, !.
delta(114, serve_sandwich(_, _, _, _), 0.000136206939296085) :- fewer_ontray_1_than_allergic_gluten, !.
delta(114, serve_sandwich(_, Child, _, Place), 4.131354938737818e-5) :- done_served(Child2), waiting(Child2, Place), not_allergic_gluten(Child2), todo_served(Child), !.
delta(114, serve_sandwich(_, _, _, Place), -0.0001839715331697351) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), !.
delta(114, serve_sandwich(_, _, _, Place), -0.0033989604402014776) :- done_served(Child), waiting(Child, Place), !.
delta(114, serve_sandwich(_, _, _, _), -0.0002837861870846222) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_bread(_), !.
delta(114, serve_sandwich(_, _, _, _), 0.04693044465078303) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(114, serve_sandwich(Sandwich, _, _, _), 0.0315359216034668) :- no_gluten_sandwich(Sandwich), !.
delta(114, serve_sandwich(_, _, _, _), -0.02936904504567318) :- !.
delta(114, move_tray(_, _, Place), -0.00018888119720957707) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(114, move_tray(_, _, _), 0.1322459554982753) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(114, move_tray(_, Place, _), -0.002146574476304328) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), waiting(Child, Place), !.
delta(114, move_tray(_, Place, Place2), 0.0020213611751108774) :- fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(114, move_tray(_, _, _), -0.00034829447234413117) :- fewer_ontray_1_than_allergic_gluten, !.
delta(114, move_tray(_, Place, Place2), 0.01933113932071429) :- done_served(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(114, move_tray(_, _, Place), -0.0001795853256324363) :- done_served(Child), waiting(Child, Place), !.
delta(114, move_tray(_, Place, Place2), 0.005315837308127157) :- fewer_at_2_than_todo_served_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(114, move_tray(_, _, _), -0.005361329068173348) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(114, move_tray(_, _, _), -0.06292061830543758) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(114, move_tray(_, _, _), 9.170454968722399e-5) :- !.
delta(114, _, 0.0).

% tree 115: step size 1.0, 263 examples, 31 leaves
delta(115, make_sandwich_no_gluten(_, _, _), -0.0071843590797055715) :- goal_served(Child), done_served(Child), !.
delta(115, make_sandwich_no_gluten(_, _, _), 0.0035484922564302797) :- !.
delta(115, make_sandwich(_, _, _), -0.03170286123910772) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(115, make_sandwich(_, _, _), 1.9537075752164357e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(115, make_sandwich(_, _, _), 0.00404139375075433) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(115, make_sandwich(_, _, _), -0.0003926505627932417) :- !.
delta(115, put_on_tray(Sandwich, _), 0.004582554578943809) :- no_gluten_sandwich(Sandwich), !.
delta(115, put_on_tray(_, _), 0.0018201707758986466) :- fewer_at_1_than_allergic_gluten, !.
delta(115, put_on_tray(_, _), 4.321083207138975e-5) :- goal_served(Child), done_served(Child), !.
delta(115, put_on_tray(_, _), -0.014799485291315959) :- !.
delta(115, serve_sandwich_no_gluten(_, Child, _, _), 0.0015745490815187917) :- todo_served(Child), !.
delta(115, serve_sandwich_no_gluten(_, _, _, _), -0.0015379496934077239) :- !.
delta(115, serve_sandwich(_, _, _, _), 0.0010219251449068456) :- fewer_ontray_1_than_todo_served, goal_served(Child), done_served(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(115, serve_sandwich(_, _, _, _), -0.14781761496874177) :- fewer_ontray_1_than_todo_served, goal_served(Child), done_served(Child), !.
delta(115, serve_sandwich(_, _, _, _), -6.817074706588866e-6) :- fewer_ontray_1_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(115, serve_sandwich(_, _, _, _), 0.010344955661952118) :- fewer_ontray_1_than_todo_served, !.
delta(115, serve_sandwich(_, Child, _, _), 0.015475809361369346) :- todo_served(Child), fewer_ontray_2_than_not_allergic_gluten, !.
delta(115, serve_sandwich(_, Child, _, _), -1.84617772434963e-5) :- todo_served(Child), !.
delta(115, serve_sandwich(_, _, _, _), -0.00014490437580655003) :- !.
delta(115, move_tray(_, Place, _), -0.004471722099299178) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(115, move_tray(_, _, Place), -0.0003801356979381541) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served, done_served(Child), waiting(Child, Place), !.
delta(115, move_tray(_, _, _), 0.18289290561524219) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served, !.
delta(115, move_tray(Tray, _, _), 0.0021850253701171263) :- fewer_ontray_1_than_todo_served, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(115, move_tray(_, _, _), -0.003297985838276363) :- fewer_ontray_1_than_todo_served, !.
delta(115, move_tray(_, Place, Place2), 0.00020715733278066543) :- goal_served(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(115, move_tray(_, Place, _), -0.000208332007674228) :- goal_served(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(115, move_tray(_, Place, _), -0.018526155215084664) :- goal_served(Child), waiting(Child, Place), !.
delta(115, move_tray(Tray, _, Place), 0.0019858675342335963) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(115, move_tray(_, _, _), -0.001572304536500273) :- goal_served(Child), allergic_gluten(Child), !.
delta(115, move_tray(_, _, _), 8.717175449772528e-5) :- !.
delta(115, _, 0.0).

% tree 116: step size 1.0, 247 examples, 32 leaves
delta(116, make_sandwich_no_gluten(_, _, _), 1.9951746956312035e-5) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(116, make_sandwich_no_gluten(_, _, _), 0.005879078863851143) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(116, make_sandwich_no_gluten(_, _, _), -0.034601994586870986) :- fewer_at_2_than_allergic_gluten, !.
delta(116, make_sandwich_no_gluten(_, _, _), 0.03030354449443055) :- !.
delta(116, make_sandwich(_, _, _), -0.008888962988568772) :- fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(116, make_sandwich(_, Bread_portion, _), -9.074869646260062e-5) :- fewer_at_2_than_todo_served_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(116, make_sandwich(_, _, _), 0.04341046198261287) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(116, make_sandwich(_, _, _), -4.403004275751512e-5) :- done_served(Child), not_allergic_gluten(Child), no_gluten_sandwich(_), !.
delta(116, make_sandwich(_, _, _), 0.010552745462475647) :- done_served(Child), not_allergic_gluten(Child), !.
delta(116, make_sandwich(_, _, _), -0.0001348467816087104) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(116, make_sandwich(_, _, _), 0.0008633492533449134) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(116, make_sandwich(_, _, _), -0.034918681466330384) :- !.
delta(116, put_on_tray(_, _), 0.005920895671537637) :- fewer_at_1_than_not_allergic_gluten, !.
delta(116, put_on_tray(_, _), 5.263826940822333e-6) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(116, put_on_tray(_, _), -0.004997939134444798) :- !.
delta(116, serve_sandwich_no_gluten(_, Child, _, _), 0.0038544979527006403) :- todo_served(Child), !.
delta(116, serve_sandwich_no_gluten(_, _, _, _), -0.0021797972495431906) :- !.
delta(116, serve_sandwich(Sandwich, _, _, _), 0.0003078218594627211) :- no_gluten_sandwich(Sandwich), at_kitchen_sandwich(_), !.
delta(116, serve_sandwich(Sandwich, _, _, _), -0.00931458464710713) :- no_gluten_sandwich(Sandwich), !.
delta(116, serve_sandwich(_, Child, _, _), 0.058599430801545) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, todo_served(Child), !.
delta(116, serve_sandwich(_, _, _, _), -0.0003346539934639304) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(116, serve_sandwich(_, _, _, _), -1.2920433898594573e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(116, serve_sandwich(_, _, _, _), 0.00026422978662389714) :- !.
delta(116, move_tray(_, kitchen, Place), 0.004428659196371187) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(_), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(116, move_tray(_, _, Place), -3.4490062294740873e-6) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(_), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(116, move_tray(_, _, kitchen), 4.442475725543315e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(_), !.
delta(116, move_tray(_, _, _), -0.00010134781026530927) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(_), !.
delta(116, move_tray(_, Place, Place2), 0.0006841572278136778) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_todo_served, !.
delta(116, move_tray(_, Place, Place2), -0.0004151702574994946) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(116, move_tray(_, _, _), -0.004071532502675778) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(116, move_tray(_, _, _), -0.0716774264584581) :- !.
delta(116, _, 0.0).

% tree 117: step size 1.0, 228 examples, 35 leaves
delta(117, make_sandwich_no_gluten(_, _, _), 0.018198048359987652) :- fewer_at_1_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(117, make_sandwich_no_gluten(_, _, _), -0.029167443535398088) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(117, make_sandwich_no_gluten(_, _, _), 5.312836206083772e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(117, make_sandwich_no_gluten(_, _, _), 0.00019639874426956457) :- at_kitchen_sandwich(_), !.
delta(117, make_sandwich_no_gluten(_, _, _), -0.19381797893249544) :- fewer_ontray_1_than_allergic_gluten, !.
delta(117, make_sandwich_no_gluten(_, _, _), 9.698718355078099e-5) :- !.
delta(117, make_sandwich(_, _, _), -0.0036400451503695312) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_allergic_gluten, !.
delta(117, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(117, make_sandwich(_, Bread_portion, _), -0.0011983958971762783) :- no_gluten_bread(Bread_portion), !.
delta(117, make_sandwich(_, _, _), -0.0002869774070419757) :- done_served(Child), not_allergic_gluten(Child), !.
delta(117, make_sandwich(_, _, Content_portion), -3.174202555888909e-5) :- no_gluten_content(Content_portion), !.
delta(117, make_sandwich(_, _, _), 0.1970275124441437) :- !.
delta(117, put_on_tray(_, _), -0.00018992222037458469) :- no_gluten_bread(_), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(117, put_on_tray(_, _), 0.01132448419034115) :- no_gluten_bread(_), !.
delta(117, put_on_tray(_, _), -0.01747560815139271) :- at_kitchen_bread(_), !.
delta(117, put_on_tray(_, _), 4.1931964704266465e-5) :- !.
delta(117, serve_sandwich_no_gluten(_, _, _, _), 0.0007574537106211064) :- done_served(Child), not_allergic_gluten(Child), !.
delta(117, serve_sandwich_no_gluten(_, _, _, _), 0.00017740314263644445) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(117, serve_sandwich_no_gluten(_, _, _, _), -0.09897236843749356) :- fewer_ontray_2_than_todo_served, !.
delta(117, serve_sandwich_no_gluten(_, _, _, _), 6.793084041457854e-6) :- !.
delta(117, serve_sandwich(_, _, _, Place), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(117, serve_sandwich(_, _, _, Place), 0.0024198162956713923) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(117, serve_sandwich(_, _, _, _), -0.05709680869557871) :- fewer_ontray_1_than_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(117, serve_sandwich(_, _, _, _), 4.8735625102335325e-5) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(117, serve_sandwich(Sandwich, _, _, Place), -0.00048575042816214974) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(117, serve_sandwich(_, _, _, _), 0.08327487075010663) :- !.
delta(117, move_tray(_, _, Place), -0.03718065528917683) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(117, move_tray(_, _, Place), 4.618334008803804e-5) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(117, move_tray(_, Place, Place2), 0.0008251592167222939) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(117, move_tray(_, Place, _), -0.0045967435207077715) :- done_served(Child), waiting(Child, Place), !.
delta(117, move_tray(Tray, Place, _), -0.00038281771174013995) :- ontray(Sandwich, Tray), ontray(Sandwich, Tray2), could_put_on_tray(Tray2, Place), !.
delta(117, move_tray(Tray, _, _), 0.08913442771051469) :- ontray(_, Tray), !.
delta(117, move_tray(_, Place, Place2), 1.7034481374846624e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(117, move_tray(_, _, _), -0.000750882267934464) :- !.
delta(117, _, 0.0).

% tree 118: step size 1.0, 208 examples, 39 leaves
delta(118, make_sandwich_no_gluten(_, _, _), 0.005373711338150961) :- fewer_at_2_than_allergic_gluten, !.
delta(118, make_sandwich_no_gluten(_, _, _), -0.0889234395654764) :- fewer_at_1_than_todo_served, !.
delta(118, make_sandwich_no_gluten(_, _, _), 9.121673130136398e-6) :- !.
delta(118, make_sandwich(_, _, _), -0.0003212109981467939) :- fewer_at_1_than_not_allergic_gluten, no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), !.
delta(118, make_sandwich(_, _, _), 0.0038261508983254296) :- fewer_at_1_than_not_allergic_gluten, no_gluten_sandwich(_), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(118, make_sandwich(_, _, _), -0.01760095782652659) :- fewer_at_1_than_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(118, make_sandwich(_, _, _), -0.006851929289359111) :- fewer_at_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(118, make_sandwich(_, _, _), 0.09940180868050112) :- fewer_at_1_than_not_allergic_gluten, !.
delta(118, make_sandwich(_, _, _), -2.3243489810753415e-6) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(118, make_sandwich(_, _, _), -0.028202387058988965) :- !.
delta(118, put_on_tray(_, Tray), 0.003731779146631955) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(118, put_on_tray(Sandwich, _), 0.0005353501427950596) :- no_gluten_sandwich(Sandwich), !.
delta(118, put_on_tray(_, _), 1.0362519687370852e-5) :- goal_served(Child), done_served(Child), !.
delta(118, put_on_tray(_, _), -0.025687647173095445) :- fewer_at_1_than_todo_served, !.
delta(118, put_on_tray(_, _), 2.8101634292966483e-6) :- !.
delta(118, serve_sandwich_no_gluten(_, _, _, _), -0.022841432655041714) :- fewer_at_1_than_todo_served_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(118, serve_sandwich_no_gluten(_, _, _, _), 0.0002446068478452054) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(118, serve_sandwich_no_gluten(_, _, _, _), 0.002918113941259776) :- !.
delta(118, serve_sandwich(Sandwich, _, _, _), -0.002481902171856053) :- no_gluten_sandwich(Sandwich), !.
delta(118, serve_sandwich(_, Child, _, _), 0.05372071036028506) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(118, serve_sandwich(_, _, _, _), -0.00043076431462328753) :- goal_served(Child), done_served(Child), !.
delta(118, serve_sandwich(_, _, _, _), -0.0004872632647301984) :- fewer_ontray_2_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(118, serve_sandwich(_, _, _, _), 0.0001395139554763118) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(118, serve_sandwich(_, _, _, _), 0.004902276678037535) :- !.
delta(118, move_tray(Tray, Place, Place2), 0.0029379222609756048) :- todo_served(Child), allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(118, move_tray(_, Place, kitchen), 1.1978257861287659e-5) :- todo_served(Child), allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(118, move_tray(_, Place, _), -0.005273208246738945) :- todo_served(Child), allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(118, move_tray(_, _, _), 0.0503091609110479) :- todo_served(Child), allergic_gluten(Child), notexist(_), fewer_ontray_2_than_not_allergic_gluten, !.
delta(118, move_tray(_, _, _), -7.132800386956204e-5) :- todo_served(Child), allergic_gluten(Child), notexist(_), !.
delta(118, move_tray(Tray, _, Place), 0.0003585285468298939) :- todo_served(Child), allergic_gluten(Child), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(118, move_tray(_, _, _), -0.0005941967256001535) :- todo_served(Child), allergic_gluten(Child), !.
delta(118, move_tray(_, Place, _), -0.05612203885146889) :- todo_served(Child), waiting(Child, Place), goal_served(Child2), done_served(Child2), !.
delta(118, move_tray(_, Place, Place2), 0.004999428099608399) :- todo_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(118, move_tray(_, Place, _), -0.004918074553327384) :- todo_served(Child), waiting(Child, Place), !.
delta(118, move_tray(_, _, Place), -0.007876291028200255) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(118, move_tray(_, _, Place), 0.00031162489738867654) :- done_served(Child), waiting(Child, Place), !.
delta(118, move_tray(_, _, _), -0.000300377399587122) :- at_kitchen_bread(_), !.
delta(118, move_tray(_, _, _), 0.007827603014040797) :- !.
delta(118, _, 0.0).

% tree 119: step size 1.0, 206 examples, 33 leaves
delta(119, make_sandwich_no_gluten(_, _, _), 0.01065152452766849) :- fewer_at_1_than_allergic_gluten, !.
delta(119, make_sandwich_no_gluten(_, _, _), -0.004111067055948811) :- fewer_ontray_1_than_allergic_gluten, !.
delta(119, make_sandwich_no_gluten(_, _, _), 2.586116470555376e-5) :- !.
delta(119, make_sandwich(_, Bread_portion, _), -0.0033986149264531172) :- no_gluten_bread(_), fewer_ontray_1_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), no_gluten_bread(Bread_portion), !.
delta(119, make_sandwich(_, _, _), 0.0029064180614116067) :- no_gluten_bread(_), fewer_ontray_1_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(119, make_sandwich(_, _, _), -0.045930811014073605) :- no_gluten_bread(_), fewer_ontray_1_than_todo_served, fewer_no_gluten_sandwich_than_todo_served, !.
delta(119, make_sandwich(_, _, _), 3.7293228904457873e-6) :- no_gluten_bread(_), fewer_ontray_1_than_todo_served, !.
delta(119, make_sandwich(_, _, _), 0.0002848085849666752) :- no_gluten_bread(_), !.
delta(119, make_sandwich(_, _, _), 0.023867107633475215) :- !.
delta(119, put_on_tray(Sandwich, _), 0.002755000793685817) :- no_gluten_sandwich(_), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, !.
delta(119, put_on_tray(Sandwich, _), -0.005000969177010612) :- no_gluten_sandwich(_), no_gluten_sandwich(Sandwich), !.
delta(119, put_on_tray(_, Tray), 0.005812291796826334) :- no_gluten_sandwich(_), ontray(_, Tray), !.
delta(119, put_on_tray(_, _), -3.1185669647834505e-5) :- no_gluten_sandwich(_), !.
delta(119, put_on_tray(_, _), -0.022040233596635213) :- !.
delta(119, serve_sandwich_no_gluten(_, _, _, _), 0.00014274865059771014) :- !.
delta(119, serve_sandwich(_, _, _, Place), 0.03274844393743953) :- fewer_ontray_1_than_todo_served, done_served(Child), waiting(Child, Place), !.
delta(119, serve_sandwich(_, _, _, _), -0.009594094161587787) :- fewer_ontray_1_than_todo_served, goal_served(Child), allergic_gluten(Child), !.
delta(119, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(_), !.
delta(119, serve_sandwich(_, _, _, _), 0.006691907557449035) :- fewer_ontray_1_than_todo_served, !.
delta(119, serve_sandwich(_, _, _, Place), 1.49675032219916e-5) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(119, serve_sandwich(_, _, _, Place), -0.14503604455791103) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), !.
delta(119, serve_sandwich(_, _, _, Place), 0.0003064704974266759) :- done_served(Child), waiting(Child, Place), !.
delta(119, serve_sandwich(_, _, _, _), 0.004360862170548989) :- done_served(Child), allergic_gluten(Child), !.
delta(119, serve_sandwich(_, _, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), !.
delta(119, serve_sandwich(_, _, _, _), 0.00015943861200725992) :- !.
delta(119, move_tray(_, Place, Place2), 0.00014472425856980982) :- at(Tray, Place), could_put_on_tray(Tray, Place2), todo_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(119, move_tray(_, Place, Place2), -0.06247861830635759) :- at(Tray, Place), could_put_on_tray(Tray, Place2), todo_served(Child), not_allergic_gluten(Child), !.
delta(119, move_tray(_, Place, Place2), 0.0005330387002443341) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(119, move_tray(Tray, _, _), -0.004085452929606246) :- ontray(_, Tray), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(119, move_tray(Tray, _, Place), -0.0012340535683344304) :- ontray(_, Tray), at(_, Place), !.
delta(119, move_tray(Tray, _, _), 0.20881661693345668) :- ontray(_, Tray), !.
delta(119, move_tray(_, _, _), -0.004540908179976131) :- !.
delta(119, _, 0.0).

% tree 120: step size 1.0, 277 examples, 26 leaves
delta(120, make_sandwich_no_gluten(_, _, _), 5.138598892506612e-5) :- fewer_no_gluten_sandwich_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(120, make_sandwich_no_gluten(_, _, _), 0.004631049330391757) :- fewer_no_gluten_sandwich_than_todo_served_allergic_gluten, !.
delta(120, make_sandwich_no_gluten(_, _, _), 7.422121760162028e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(120, make_sandwich_no_gluten(_, _, _), -0.014021818318877272) :- !.
delta(120, make_sandwich(_, _, _), 0.007175847879121195) :- goal_served(Child), done_served(Child), !.
delta(120, make_sandwich(_, _, _), -0.03508914617137321) :- !.
delta(120, put_on_tray(_, _), 0.011475147511665748) :- !.
delta(120, serve_sandwich_no_gluten(_, Child, _, _), 0.004491276781088275) :- todo_served(Child), !.
delta(120, serve_sandwich_no_gluten(_, _, _, _), -0.016618713131131668) :- !.
delta(120, serve_sandwich(_, _, _, _), 0.04753517730749911) :- fewer_at_1_than_allergic_gluten, !.
delta(120, serve_sandwich(_, Child, _, Place), 0.009949512165601871) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(120, serve_sandwich(_, _, _, Place), -6.737819037429577e-5) :- done_served(Child), waiting(Child, Place), !.
delta(120, serve_sandwich(_, _, _, _), -0.12117559332235076) :- fewer_ontray_1_than_todo_served, !.
delta(120, serve_sandwich(_, _, _, _), -1.1653228168560451e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(120, serve_sandwich(_, _, _, _), 0.0022309086899735997) :- !.
delta(120, move_tray(Tray, Place, _), -0.05515302169920488) :- allergic_gluten(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(120, move_tray(_, Place, _), -0.0017834181233210428) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(120, move_tray(_, Place, _), 0.013905815879885564) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(120, move_tray(_, Place, Place2), 0.011411708689022804) :- done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(120, move_tray(_, Place, _), -0.026616103296033488) :- done_served(Child), waiting(Child, Place), notexist(_), !.
delta(120, move_tray(_, Place, _), 6.130653643505135e-5) :- done_served(Child), waiting(Child, Place), !.
delta(120, move_tray(_, _, kitchen), -0.005228549813385577) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(120, move_tray(_, _, kitchen), 0.00012644512698153462) :- !.
delta(120, move_tray(_, _, _), -0.0014201819183734617) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(120, move_tray(_, _, _), 0.15781317599588565) :- !.
delta(120, _, 0.0).

% tree 121: step size 1.0, 224 examples, 30 leaves
delta(121, make_sandwich_no_gluten(_, _, _), 1.1382824978713946e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(121, make_sandwich_no_gluten(_, _, _), 0.008671306854183597) :- !.
delta(121, make_sandwich(_, Bread_portion, _), -7.645508035028315e-5) :- no_gluten_bread(Bread_portion), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(121, make_sandwich(_, Bread_portion, _), 0.024712495508144812) :- no_gluten_bread(Bread_portion), !.
delta(121, make_sandwich(_, _, _), 0.00012950536945616697) :- goal_served(Child), done_served(Child), !.
delta(121, make_sandwich(_, _, _), -0.018130210273531247) :- !.
delta(121, put_on_tray(_, _), 8.816274983899988e-6) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(121, put_on_tray(_, _), -0.01261868042748013) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(121, put_on_tray(_, _), 0.005612272261738909) :- fewer_ontray_2_than_todo_served, !.
delta(121, put_on_tray(_, _), -0.00015855531906255104) :- !.
delta(121, serve_sandwich_no_gluten(_, _, _, _), -0.02903564959425866) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(121, serve_sandwich_no_gluten(_, _, _, _), 0.0008213384264119539) :- !.
delta(121, serve_sandwich(_, _, Tray, _), 0.00044983558321220243) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(121, serve_sandwich(_, _, Tray, _), -0.010288145649307271) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(121, serve_sandwich(_, _, Tray, _), 0.006290457972038547) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(121, serve_sandwich(_, Child, _, _), 0.046774861012090836) :- todo_served(Child), !.
delta(121, serve_sandwich(_, _, _, _), -0.00015993939844127208) :- !.
delta(121, move_tray(_, _, _), -3.198757872048141e-5) :- fewer_at_1_than_todo_served, fewer_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(121, move_tray(_, _, _), 0.007091133698073647) :- fewer_at_1_than_todo_served, fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(121, move_tray(_, Place, Place2), -0.0159925493306732) :- fewer_at_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_bread(_), !.
delta(121, move_tray(_, Place, Place2), 0.019026499630056905) :- fewer_at_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(121, move_tray(_, Place, _), 0.001794601851282579) :- fewer_at_1_than_todo_served, allergic_gluten(Child), waiting(Child, Place), !.
delta(121, move_tray(_, _, _), -0.059325218395037384) :- fewer_at_1_than_todo_served, !.
delta(121, move_tray(_, Place, Place2), -0.0007789564001947623) :- todo_served(Child), waiting(Child, Place2), todo_served(Child2), waiting(Child2, Place), !.
delta(121, move_tray(_, _, Place), -5.451600094349733e-5) :- todo_served(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(121, move_tray(_, _, Place), 0.025965982403972163) :- todo_served(Child), waiting(Child, Place), !.
delta(121, move_tray(_, Place, _), -0.0075527547389730755) :- goal_served(Child), waiting(Child, Place), !.
delta(121, move_tray(_, _, _), 0.00019741595438817195) :- fewer_ontray_1_than_todo_served, !.
delta(121, move_tray(_, _, _), -9.036970192470029e-5) :- !.
delta(121, _, 0.0).

% tree 122: step size 1.0, 254 examples, 34 leaves
delta(122, make_sandwich_no_gluten(_, _, _), -0.13219892249140391) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(122, make_sandwich_no_gluten(_, _, _), 1.2006036520497867e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(122, make_sandwich_no_gluten(_, _, _), 0.004031315284257945) :- !.
delta(122, make_sandwich(_, _, _), -0.02769386874599512) :- goal_served(Child), done_served(Child), fewer_at_1_than_todo_served, !.
delta(122, make_sandwich(_, _, _), 1.0659971207368872e-5) :- goal_served(Child), done_served(Child), !.
delta(122, make_sandwich(_, _, Content_portion), -0.0016711756259851257) :- fewer_ontray_1_than_not_allergic_gluten, no_gluten_content(Content_portion), !.
delta(122, make_sandwich(_, _, _), 0.1462483901064647) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(122, make_sandwich(_, _, _), -0.0012754105657205278) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(122, make_sandwich(_, _, _), -0.003046790620715929) :- fewer_ontray_2_than_allergic_gluten, !.
delta(122, make_sandwich(_, _, _), 0.0013995470943007902) :- !.
delta(122, put_on_tray(_, _), 0.004078532976474768) :- fewer_ontray_2_than_allergic_gluten, !.
delta(122, put_on_tray(_, _), 0.000200319996153838) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(122, put_on_tray(_, Tray), -0.008937371198535448) :- ontray(_, Tray), !.
delta(122, put_on_tray(_, _), 7.221457430020747e-7) :- !.
delta(122, serve_sandwich_no_gluten(_, Child, _, _), 0.001849527580160802) :- todo_served(Child), !.
delta(122, serve_sandwich_no_gluten(_, _, _, _), -0.0026120728010102174) :- !.
delta(122, serve_sandwich(_, _, _, _), -0.033218215538275885) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(122, serve_sandwich(Sandwich, _, _, _), -0.009110531330878151) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(122, serve_sandwich(Sandwich, _, _, _), 0.0041360734951793035) :- no_gluten_sandwich(Sandwich), !.
delta(122, serve_sandwich(_, _, _, Place), 0.00011786898165434226) :- fewer_ontray_2_than_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(122, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_2_than_allergic_gluten, !.
delta(122, serve_sandwich(_, Child, _, _), 0.07198777419055004) :- todo_served(Child), !.
delta(122, serve_sandwich(_, _, _, _), -0.00012045589423305659) :- !.
delta(122, move_tray(_, kitchen, Place), -6.299386937521135e-6) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), at(Tray, kitchen), could_serve_sandwich(Tray, Place), !.
delta(122, move_tray(_, Place, Place2), 0.036810662720442394) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(122, move_tray(_, _, _), -4.841790790818357e-5) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(122, move_tray(_, Place, Place2), -0.0003908945340933019) :- done_served(Child), waiting(Child, Place2), todo_served(Child2), waiting(Child2, Place), !.
delta(122, move_tray(_, _, Place), 0.011602330525430339) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(122, move_tray(_, _, Place), -0.00010469678958140522) :- done_served(Child), waiting(Child, Place), !.
delta(122, move_tray(_, Place, _), -0.000994469551152289) :- fewer_ontray_1_than_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(122, move_tray(_, _, _), 0.008229301025975678) :- fewer_ontray_1_than_allergic_gluten, !.
delta(122, move_tray(Tray, _, _), -0.00026803602458449224) :- at(Tray, kitchen), !.
delta(122, move_tray(_, _, _), -0.08157667509945012) :- !.
delta(122, _, 0.0).

% tree 123: step size 1.0, 274 examples, 31 leaves
delta(123, make_sandwich_no_gluten(_, _, _), 0.008299428014904834) :- !.
delta(123, make_sandwich(_, _, _), -0.03433567558412213) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(123, make_sandwich(_, _, _), 0.00965060475871246) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(123, make_sandwich(_, _, _), -9.906808115777597e-5) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(123, make_sandwich(_, _, _), 0.013326014699603147) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(123, make_sandwich(_, _, _), -0.0038538519729853066) :- fewer_at_2_than_todo_served, !.
delta(123, make_sandwich(_, _, _), 5.2252497313868506e-5) :- !.
delta(123, put_on_tray(_, _), 0.004514070730321405) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), no_gluten_sandwich(_), !.
delta(123, put_on_tray(_, _), -9.710362758735714e-6) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(123, put_on_tray(_, _), -0.016437968669915384) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_bread(_), !.
delta(123, put_on_tray(_, _), 0.00040139862181134376) :- fewer_ontray_2_than_allergic_gluten, !.
delta(123, put_on_tray(_, _), 0.003380291539304068) :- fewer_ontray_1_than_todo_served, !.
delta(123, put_on_tray(_, _), -0.0029016701840111838) :- !.
delta(123, serve_sandwich_no_gluten(_, _, _, Place), -0.0003309458416559053) :- done_served(Child), waiting(Child, Place), !.
delta(123, serve_sandwich_no_gluten(_, _, _, _), 0.0012849315010086161) :- !.
delta(123, serve_sandwich(Sandwich, _, _, Place), -0.0010708398634864545) :- fewer_at_2_than_todo_served, ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(123, serve_sandwich(_, Child, _, _), 0.029904060956784544) :- fewer_at_2_than_todo_served, todo_served(Child), !.
delta(123, serve_sandwich(_, _, _, _), -0.00011545938845875467) :- fewer_at_2_than_todo_served, !.
delta(123, serve_sandwich(_, _, _, _), 4.189451601263238e-5) :- fewer_at_1_than_not_allergic_gluten, !.
delta(123, serve_sandwich(_, _, _, _), -9.320122190209662e-5) :- !.
delta(123, move_tray(_, Place, Place2), -0.00035583778709329745) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, at(_, Place2), !.
delta(123, move_tray(_, Place, Place2), -7.214767449600382e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, at_kitchen_bread(_), !.
delta(123, move_tray(_, Place, Place2), 0.023401210885546316) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(123, move_tray(_, Place, Place2), -0.0004607000721828684) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(123, move_tray(Tray, _, _), -0.0013054348864010178) :- at(Tray, kitchen), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(123, move_tray(Tray, _, Place), 0.0061769375338006525) :- at(Tray, kitchen), could_serve_sandwich(Tray, Place), !.
delta(123, move_tray(Tray, _, _), -0.0010018418072355389) :- at(Tray, kitchen), !.
delta(123, move_tray(_, _, _), -0.04522267115635446) :- fewer_ontray_2_than_todo_served, !.
delta(123, move_tray(Tray, _, _), 0.0012112198124428857) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(123, move_tray(_, _, _), -0.0004969111672437536) :- !.
delta(123, _, 0.0).

% tree 124: step size 1.0, 231 examples, 35 leaves
delta(124, make_sandwich_no_gluten(_, _, _), 0.004175714899186501) :- fewer_at_1_than_allergic_gluten, !.
delta(124, make_sandwich_no_gluten(_, _, _), 0.004345263553798622) :- no_gluten_sandwich(_), !.
delta(124, make_sandwich_no_gluten(_, _, _), -0.022876633132337496) :- fewer_at_2_than_allergic_gluten, !.
delta(124, make_sandwich_no_gluten(_, _, _), 9.563795501600677e-5) :- !.
delta(124, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(124, make_sandwich(_, _, _), -0.01020750269173092) :- at_kitchen_sandwich(_), fewer_at_1_than_not_allergic_gluten, !.
delta(124, make_sandwich(_, _, _), -4.1533809798263924e-5) :- at_kitchen_sandwich(_), !.
delta(124, make_sandwich(_, _, _), -0.004631022051995722) :- fewer_at_1_than_allergic_gluten, !.
delta(124, make_sandwich(_, Bread_portion, _), -0.0006131560215187602) :- no_gluten_bread(Bread_portion), !.
delta(124, make_sandwich(_, _, Content_portion), -9.762310561684204e-6) :- no_gluten_content(Content_portion), !.
delta(124, make_sandwich(_, _, _), 0.03412170796818565) :- !.
delta(124, put_on_tray(_, Tray), -0.015389002660888294) :- ontray(_, Tray), fewer_ontray_1_than_not_allergic_gluten, at_kitchen_bread(_), !.
delta(124, put_on_tray(_, Tray), 0.0004198199332322338) :- ontray(_, Tray), fewer_ontray_1_than_not_allergic_gluten, !.
delta(124, put_on_tray(_, Tray), 0.0028179909114410136) :- ontray(_, Tray), !.
delta(124, put_on_tray(Sandwich, _), 0.005046998269438645) :- no_gluten_sandwich(Sandwich), !.
delta(124, put_on_tray(_, _), -0.0008640752012514688) :- todo_served(Child), allergic_gluten(Child), !.
delta(124, put_on_tray(_, _), 2.949839412658753e-6) :- !.
delta(124, serve_sandwich_no_gluten(_, _, _, _), 0.0004285139869047245) :- !.
delta(124, serve_sandwich(_, _, _, Place), 0.004960873521993518) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(124, serve_sandwich(_, _, _, Place), -0.09342915257066674) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(124, serve_sandwich(_, _, _, _), 0.05952340726131147) :- fewer_ontray_1_than_todo_served, !.
delta(124, serve_sandwich(_, Child, _, _), 0.0041156712883517205) :- todo_served(Child), !.
delta(124, serve_sandwich(_, _, _, _), -0.00022087368916807508) :- !.
delta(124, move_tray(_, Place, _), -0.07726611742473062) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(124, move_tray(_, _, kitchen), -0.00035673084010552555) :- fewer_ontray_1_than_todo_served, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(124, move_tray(_, _, kitchen), 0.027853514151001433) :- fewer_ontray_1_than_todo_served, !.
delta(124, move_tray(_, _, _), -0.011134572332046023) :- fewer_ontray_1_than_todo_served, !.
delta(124, move_tray(_, Place, Place2), 1.2216912596330698e-5) :- fewer_ontray_2_than_allergic_gluten, fewer_at_2_than_todo_served, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(124, move_tray(_, _, _), -0.0034674659494519314) :- fewer_ontray_2_than_allergic_gluten, fewer_at_2_than_todo_served, !.
delta(124, move_tray(_, _, _), 4.120243469448822e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(124, move_tray(_, Place, Place2), -7.861987962306e-5) :- done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(124, move_tray(_, Place, _), 0.09232456996429515) :- done_served(Child), waiting(Child, Place), !.
delta(124, move_tray(_, _, Place), 0.004231885083877673) :- done_served(Child), waiting(Child, Place), !.
delta(124, move_tray(_, _, _), -0.0057382159646868665) :- !.
delta(124, _, 0.0).

% tree 125: step size 1.0, 235 examples, 37 leaves
delta(125, make_sandwich_no_gluten(_, _, _), -0.27276121441592444) :- fewer_at_1_than_allergic_gluten, !.
delta(125, make_sandwich_no_gluten(_, _, _), 0.13748860888526668) :- !.
delta(125, make_sandwich(_, _, _), -0.0018647130959355575) :- fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(_), fewer_ontray_1_than_allergic_gluten, !.
delta(125, make_sandwich(_, _, _), -1.3000661439782904e-5) :- fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(125, make_sandwich(_, Bread_portion, _), -0.0002089263274880668) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(125, make_sandwich(_, _, _), 0.2800872953429228) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(125, make_sandwich(_, _, _), -0.0002821502704336565) :- fewer_at_1_than_allergic_gluten, !.
delta(125, make_sandwich(_, _, _), 0.002090434876079409) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(125, make_sandwich(_, _, _), -0.14662580419666482) :- !.
delta(125, put_on_tray(_, _), 0.006017032496402287) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(125, put_on_tray(_, _), 0.0013067109495686921) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(125, put_on_tray(_, _), -0.006880965851948457) :- at_kitchen_bread(_), !.
delta(125, put_on_tray(_, Tray), 0.0021631226140170164) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(125, put_on_tray(_, _), -0.0017929650468386951) :- !.
delta(125, serve_sandwich_no_gluten(_, _, _, _), 0.0012913325045037242) :- !.
delta(125, serve_sandwich(Sandwich, _, _, _), -0.0015046789037761136) :- no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(125, serve_sandwich(Sandwich, _, _, _), 0.030914769177541074) :- no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), no_gluten_sandwich(Sandwich), !.
delta(125, serve_sandwich(_, _, _, _), -0.030927288854735918) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(125, serve_sandwich(_, Child, _, _), 0.03138710371135269) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(125, serve_sandwich(_, _, _, _), -7.283620718812692e-5) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(125, serve_sandwich(_, _, _, Place), 0.00045005416414924766) :- no_gluten_sandwich(_), done_served(Child), waiting(Child, Place), !.
delta(125, serve_sandwich(_, _, _, _), 0.0) :- no_gluten_sandwich(_), !.
delta(125, serve_sandwich(_, _, _, Place), -0.12366687305926288) :- done_served(Child), waiting(Child, Place), !.
delta(125, serve_sandwich(_, _, _, _), 0.01219722494605488) :- !.
delta(125, move_tray(_, _, _), -0.004069127070174809) :- at_kitchen_bread(_), fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(125, move_tray(_, _, _), 4.088382982666252e-5) :- at_kitchen_bread(_), fewer_ontray_1_than_allergic_gluten, !.
delta(125, move_tray(_, _, Place), -0.0015274238086422961) :- at_kitchen_bread(_), done_served(Child), waiting(Child, Place), !.
delta(125, move_tray(_, Place, Place2), -0.0002752489546376208) :- at_kitchen_bread(_), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(125, move_tray(_, _, _), 0.13724570299778208) :- at_kitchen_bread(_), !.
delta(125, move_tray(Tray, Place, Place2), 0.009739732002115536) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), ontray(_, Tray), !.
delta(125, move_tray(_, Place, Place2), -0.006048748102266089) :- at(Tray, Place), could_put_on_tray(Tray, Place2), goal_served(Child), allergic_gluten(Child), !.
delta(125, move_tray(_, Place, Place2), 0.00020874986857840724) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(125, move_tray(Tray, _, Place), -0.0002244777559821782) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_serve_sandwich(Tray2, Place), !.
delta(125, move_tray(Tray, _, _), 0.0008859720293229952) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(125, move_tray(_, _, Place), 1.200115935906831e-5) :- at(Tray, Place), ontray(_, Tray), !.
delta(125, move_tray(_, _, _), -0.037127431583081474) :- !.
delta(125, _, 0.0).

% tree 126: step size 1.0, 266 examples, 31 leaves
delta(126, make_sandwich_no_gluten(_, _, _), 0.011493818074519128) :- !.
delta(126, make_sandwich(_, _, _), -0.016748666308664808) :- fewer_ontray_1_than_todo_served_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(126, make_sandwich(_, _, _), -9.541107329408289e-5) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(126, make_sandwich(_, _, _), -0.0003733031349123014) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(126, make_sandwich(_, _, _), 0.0077335249589413416) :- goal_served(Child), allergic_gluten(Child), !.
delta(126, make_sandwich(_, _, _), 0.00011862105355992586) :- !.
delta(126, put_on_tray(_, _), 0.000994625447421209) :- at_kitchen_bread(_), !.
delta(126, put_on_tray(_, _), -0.021087727047914756) :- goal_served(Child), allergic_gluten(Child), !.
delta(126, put_on_tray(_, _), 7.50272963884155e-5) :- !.
delta(126, serve_sandwich_no_gluten(_, Child, _, _), 3.185401636371859e-5) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(126, serve_sandwich_no_gluten(_, Child, _, _), 0.010034861253814843) :- todo_served(Child), !.
delta(126, serve_sandwich_no_gluten(_, _, _, _), -0.07795229894551589) :- !.
delta(126, serve_sandwich(_, _, Tray, _), -0.004932382565275015) :- fewer_ontray_1_than_not_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(126, serve_sandwich(_, Child, _, _), 0.058987398633542576) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(126, serve_sandwich(_, _, _, _), -0.0015529199130965502) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(126, serve_sandwich(_, _, Tray, _), 0.01322688070034534) :- fewer_at_1_than_todo_served_not_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(126, serve_sandwich(_, _, _, _), -0.007277861434055841) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(126, serve_sandwich(_, _, _, _), 0.0001461244902873805) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(126, serve_sandwich(_, _, _, _), -0.06047426504747899) :- todo_served(Child), allergic_gluten(Child), !.
delta(126, serve_sandwich(_, _, _, _), 6.056142367590069e-6) :- !.
delta(126, move_tray(_, Place, Place2), 0.004262944857624319) :- at(Tray, Place), could_serve_sandwich(Tray, Place), at(Tray2, Place), could_put_on_tray(Tray2, Place2), !.
delta(126, move_tray(_, Place, _), -0.024472873562258707) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(126, move_tray(_, Place, _), 0.0031664434481126044) :- at_kitchen_bread(_), allergic_gluten(Child), waiting(Child, Place), todo_served(Child), !.
delta(126, move_tray(_, Place, _), -7.170369673297198e-6) :- at_kitchen_bread(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(126, move_tray(_, _, _), -0.006355993135952824) :- at_kitchen_bread(_), fewer_ontray_1_than_todo_served, !.
delta(126, move_tray(_, _, _), 0.00037293771509830267) :- at_kitchen_bread(_), !.
delta(126, move_tray(_, Place, _), -0.0004053473963400212) :- no_gluten_sandwich(_), todo_served(Child), waiting(Child, Place), !.
delta(126, move_tray(_, _, _), 0.09642111088239613) :- no_gluten_sandwich(_), !.
delta(126, move_tray(_, _, kitchen), 0.0017685782889976544) :- !.
delta(126, move_tray(_, _, _), -0.0004611889571044257) :- !.
delta(126, _, 0.0).

% tree 127: step size 1.0, 209 examples, 38 leaves
delta(127, make_sandwich_no_gluten(_, _, _), 0.006592658028857927) :- fewer_at_1_than_allergic_gluten, !.
delta(127, make_sandwich_no_gluten(_, _, _), -0.08814669896221178) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(127, make_sandwich_no_gluten(_, _, _), 6.299876531900997e-6) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(127, make_sandwich_no_gluten(_, _, _), 4.875093646591094e-5) :- !.
delta(127, make_sandwich(_, _, _), -0.03406146867083159) :- fewer_at_2_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(127, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(127, make_sandwich(_, _, _), 0.010711057071353395) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(127, make_sandwich(_, _, _), -0.0009423458683353854) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(127, make_sandwich(_, _, _), -0.004038543110449293) :- fewer_at_2_than_allergic_gluten, !.
delta(127, make_sandwich(_, _, _), -0.00605657581068578) :- no_gluten_sandwich(_), at_kitchen_sandwich(_), !.
delta(127, make_sandwich(_, _, _), 0.0004465166904232867) :- no_gluten_sandwich(_), !.
delta(127, make_sandwich(_, Bread_portion, _), -0.000316521601531765) :- no_gluten_bread(Bread_portion), !.
delta(127, make_sandwich(_, _, _), 0.08466313485159288) :- fewer_at_1_than_not_allergic_gluten, !.
delta(127, make_sandwich(_, _, _), -6.924490821895103e-6) :- !.
delta(127, put_on_tray(_, _), 0.0163211670920389) :- !.
delta(127, serve_sandwich_no_gluten(_, _, _, Place), 4.651093109523195e-6) :- goal_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(127, serve_sandwich_no_gluten(_, _, _, _), 0.0006206573240918165) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(127, serve_sandwich_no_gluten(_, _, _, _), -0.007685537820505656) :- !.
delta(127, serve_sandwich(_, _, _, _), 0.0) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), fewer_no_gluten_sandwich_than_todo_served, fewer_at_2_than_todo_served_allergic_gluten, !.
delta(127, serve_sandwich(_, _, _, _), 0.008629467020991955) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(127, serve_sandwich(_, _, _, _), 0.0) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(127, serve_sandwich(_, _, _, _), -0.10698065172080898) :- goal_served(Child), done_served(Child), fewer_no_gluten_sandwich_than_todo_served, !.
delta(127, serve_sandwich(_, _, _, _), 0.00011579851693621331) :- goal_served(Child), done_served(Child), !.
delta(127, serve_sandwich(_, _, _, _), -0.008592656162169067) :- at_kitchen_bread(_), !.
delta(127, serve_sandwich(_, _, _, _), 0.019268733231503472) :- !.
delta(127, move_tray(Tray, _, Place), 0.014100149159060297) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_serve_sandwich(Tray2, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(127, move_tray(Tray, _, Place), -0.011390848784865553) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_serve_sandwich(Tray2, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(127, move_tray(Tray, _, Place), 0.009173281871371048) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_serve_sandwich(Tray2, Place), !.
delta(127, move_tray(Tray, _, Place), 5.501559268412047e-6) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at(_, Place), !.
delta(127, move_tray(Tray, _, _), -0.033623042830918104) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(127, move_tray(_, _, _), 0.005420808875252616) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), fewer_at_1_than_allergic_gluten, !.
delta(127, move_tray(_, _, _), -0.007757710713497481) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(127, move_tray(_, Place, _), 0.13730165715169004) :- goal_served(Child), done_served(Child), todo_served(Child2), waiting(Child2, Place), !.
delta(127, move_tray(_, _, _), -3.9422751196062036e-5) :- goal_served(Child), done_served(Child), !.
delta(127, move_tray(_, _, Place), -3.184809174168991e-5) :- fewer_at_2_than_allergic_gluten, todo_served(Child), waiting(Child, Place), !.
delta(127, move_tray(_, _, _), 0.010868017270766044) :- fewer_at_2_than_allergic_gluten, !.
delta(127, move_tray(_, _, _), -0.019989505325258183) :- !.
delta(127, _, 0.0).

% tree 128: step size 1.0, 244 examples, 26 leaves
delta(128, make_sandwich_no_gluten(_, _, _), 1.4230406721144654e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(128, make_sandwich_no_gluten(_, _, _), 0.011547246277532295) :- !.
delta(128, make_sandwich(_, _, _), -0.01919408932415948) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(128, make_sandwich(_, _, _), 1.1206029148411451e-6) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(128, make_sandwich(_, _, _), -3.960529464904293e-6) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(128, make_sandwich(_, _, _), 0.011066495683057384) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(128, make_sandwich(_, _, _), -1.6046347147677133e-5) :- !.
delta(128, put_on_tray(_, Tray), 0.00852707462361858) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(128, put_on_tray(_, _), 0.0010621783486448827) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_allergic_gluten, !.
delta(128, put_on_tray(_, _), -0.003763550557307414) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(128, put_on_tray(_, _), 0.0020123942469145325) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(128, put_on_tray(_, _), -1.4018152305008056e-5) :- !.
delta(128, serve_sandwich_no_gluten(_, _, _, _), 1.394718907185205e-5) :- fewer_ontray_1_than_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(128, serve_sandwich_no_gluten(_, _, _, _), -0.0018606392248874512) :- fewer_ontray_1_than_allergic_gluten, !.
delta(128, serve_sandwich_no_gluten(_, _, _, _), 0.0005428075215834078) :- !.
delta(128, serve_sandwich(Sandwich, _, _, _), -0.009127115150478817) :- no_gluten_sandwich(Sandwich), !.
delta(128, serve_sandwich(_, Child, _, _), 0.0351800252022166) :- todo_served(Child), !.
delta(128, serve_sandwich(_, _, _, _), -0.0007382831107560503) :- !.
delta(128, move_tray(_, Place, Place2), -0.00019214848959733972) :- at(Tray, Place2), ontray(_, Tray), could_serve_sandwich(Tray, Place), !.
delta(128, move_tray(_, _, Place), -9.12556850140925e-6) :- at(Tray, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(128, move_tray(_, _, Place), 0.010981113492589109) :- at(Tray, Place), ontray(_, Tray), !.
delta(128, move_tray(_, _, _), -0.051930830377942966) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(128, move_tray(Tray, _, Place), 0.00036214548999970295) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(128, move_tray(_, _, _), 1.7476554943974386e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(128, move_tray(_, _, _), -0.00027298797575172327) :- !.
delta(128, _, 0.0).

% tree 129: step size 1.0, 237 examples, 34 leaves
delta(129, make_sandwich_no_gluten(_, _, _), 0.0007709289899585354) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(129, make_sandwich_no_gluten(_, _, _), -0.11659114202770263) :- fewer_at_1_than_allergic_gluten, !.
delta(129, make_sandwich_no_gluten(_, _, _), 0.014912862242836401) :- !.
delta(129, make_sandwich(_, _, _), -0.007073419200941541) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(129, make_sandwich(_, Bread_portion, _), -2.4708043746063925e-5) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(129, make_sandwich(_, _, _), 0.1575744229639409) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(129, make_sandwich(_, _, _), -0.043620071902180174) :- !.
delta(129, put_on_tray(_, Tray), 0.03041331693860062) :- ontray(_, Tray), !.
delta(129, put_on_tray(_, _), -0.015641801671772388) :- at_kitchen_bread(_), !.
delta(129, put_on_tray(_, _), 0.0001429587972105768) :- !.
delta(129, serve_sandwich_no_gluten(_, _, _, _), 3.191279548754077e-5) :- at_kitchen_sandwich(_), !.
delta(129, serve_sandwich_no_gluten(_, _, _, _), 0.002975086503393903) :- !.
delta(129, serve_sandwich(_, _, _, _), -0.04324415322914726) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(129, serve_sandwich(Sandwich, _, _, _), -7.222879629791449e-5) :- todo_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(129, serve_sandwich(_, _, _, _), 7.00193548519575e-6) :- todo_served(Child), allergic_gluten(Child), !.
delta(129, serve_sandwich(_, Child, _, _), 0.056205851001916766) :- fewer_ontray_1_than_todo_served, todo_served(Child), !.
delta(129, serve_sandwich(_, _, _, _), -0.0001221764438920548) :- fewer_ontray_1_than_todo_served, !.
delta(129, serve_sandwich(_, Child, _, Place), 3.925551611220972e-5) :- todo_served(Child), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(129, serve_sandwich(_, Child, _, _), 0.001845048963723956) :- todo_served(Child), !.
delta(129, serve_sandwich(_, _, _, _), -0.0001243695639115911) :- !.
delta(129, move_tray(_, Place, Place2), -0.013894723896616888) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), allergic_gluten(Child), !.
delta(129, move_tray(_, Place, Place2), 0.00033281489006595444) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(129, move_tray(_, Place, Place2), -0.0034220837712460603) :- done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), fewer_ontray_2_than_todo_served, !.
delta(129, move_tray(_, Place, Place2), 3.564654434482697e-5) :- done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(129, move_tray(_, Place, _), 0.0740985565547848) :- done_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(129, move_tray(_, Place, _), -0.0012960206224707515) :- done_served(Child), waiting(Child, Place), !.
delta(129, move_tray(_, _, _), -0.00014821642872294233) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), fewer_ontray_1_than_allergic_gluten, !.
delta(129, move_tray(_, _, _), 0.0032762880910831398) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(129, move_tray(_, _, _), -0.0005399910842719556) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(129, move_tray(_, _, _), 0.00011138220255199152) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), no_gluten_sandwich(_), !.
delta(129, move_tray(_, _, _), -1.5796256839385886e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(129, move_tray(_, _, _), 2.7244255770664666e-5) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(129, move_tray(_, _, _), -0.08321303556222581) :- !.
delta(129, _, 0.0).

% tree 130: step size 1.0, 218 examples, 38 leaves
delta(130, make_sandwich_no_gluten(_, _, _), 0.03560989823139992) :- !.
delta(130, make_sandwich(_, _, _), -0.003969849434992223) :- at_kitchen_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(130, make_sandwich(_, _, _), -1.8630627248448325e-6) :- at_kitchen_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(130, make_sandwich(_, _, _), -3.8357893018444476e-5) :- at_kitchen_sandwich(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(130, make_sandwich(_, _, _), 0.03713300524936205) :- at_kitchen_sandwich(_), !.
delta(130, make_sandwich(_, _, _), 0.00883891648712838) :- no_gluten_sandwich(_), fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(130, make_sandwich(_, _, _), -3.213885320270448e-6) :- no_gluten_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(130, make_sandwich(_, _, _), -0.005147345854747784) :- no_gluten_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(130, make_sandwich(_, _, _), 1.8193987873417885e-5) :- no_gluten_sandwich(_), !.
delta(130, make_sandwich(_, _, _), -0.0658429949398709) :- !.
delta(130, put_on_tray(_, _), 0.026740008132701342) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(130, put_on_tray(_, _), 4.679216314232036e-6) :- no_gluten_sandwich(Sandwich), at_kitchen_sandwich(Sandwich), !.
delta(130, put_on_tray(_, _), -0.00032709476374551756) :- no_gluten_sandwich(_), !.
delta(130, put_on_tray(_, _), -0.03791046729459017) :- at_kitchen_bread(_), !.
delta(130, put_on_tray(_, _), 1.1343718563357707e-5) :- !.
delta(130, serve_sandwich_no_gluten(_, _, _, _), -0.006696007016059786) :- at_kitchen_sandwich(_), !.
delta(130, serve_sandwich_no_gluten(_, _, _, _), 0.00017927632037015285) :- !.
delta(130, serve_sandwich(_, Child, _, Place), 0.0021559468452442936) :- done_served(Child2), not_allergic_gluten(Child2), goal_served(Child3), allergic_gluten(Child3), waiting(Child3, Place), todo_served(Child), !.
delta(130, serve_sandwich(_, _, _, Place), -0.0002459826676315238) :- done_served(Child), not_allergic_gluten(Child), goal_served(Child2), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(130, serve_sandwich(_, _, _, _), -0.2183688504735444) :- done_served(Child), not_allergic_gluten(Child), goal_served(Child2), allergic_gluten(Child2), fewer_ontray_2_than_todo_served, !.
delta(130, serve_sandwich(_, _, _, _), 0.0) :- done_served(Child), not_allergic_gluten(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(130, serve_sandwich(_, Child, _, _), 4.103345397159702e-5) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(130, serve_sandwich(_, _, _, _), -5.8699467736147064e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(130, serve_sandwich(_, _, _, _), 0.02387527670294334) :- at_kitchen_sandwich(_), !.
delta(130, serve_sandwich(_, _, _, _), -0.0030706547202638923) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(130, serve_sandwich(_, _, _, _), 0.0004537631196294878) :- no_gluten_sandwich(_), !.
delta(130, serve_sandwich(_, _, _, _), 3.844356441317611e-6) :- !.
delta(130, move_tray(_, _, Place), -0.00015875962278795127) :- at_kitchen_sandwich(_), done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), !.
delta(130, move_tray(_, _, Place), 0.016605823267141263) :- at_kitchen_sandwich(_), done_served(Child), waiting(Child, Place), fewer_at_1_than_allergic_gluten, !.
delta(130, move_tray(_, _, Place), -8.609738779965682e-7) :- at_kitchen_sandwich(_), done_served(Child), waiting(Child, Place), !.
delta(130, move_tray(_, Place, Place2), 0.006685908164022786) :- at_kitchen_sandwich(_), at(Tray, Place2), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(130, move_tray(_, _, _), -0.06827240593903063) :- at_kitchen_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(130, move_tray(_, _, _), 0.00034328634988388065) :- at_kitchen_sandwich(_), !.
delta(130, move_tray(_, _, _), -0.005895464362015918) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(130, move_tray(Tray, Place, _), -7.58320827711813e-5) :- ontray(Sandwich, Tray), ontray(Sandwich, Tray2), could_serve_sandwich_no_gluten(Tray2, Place), !.
delta(130, move_tray(Tray, _, _), 0.25551627684031186) :- ontray(_, Tray), !.
delta(130, move_tray(_, _, _), -0.0006296180357231688) :- !.
delta(130, _, 0.0).

% tree 131: step size 1.0, 218 examples, 43 leaves
delta(131, make_sandwich_no_gluten(_, _, _), 0.00392320187517464) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(131, make_sandwich_no_gluten(_, _, _), 0.02619638933598527) :- !.
delta(131, make_sandwich(_, _, _), 4.003946305345296e-5) :- todo_served(Child), allergic_gluten(Child), done_served(Child2), allergic_gluten(Child2), !.
delta(131, make_sandwich(_, _, _), -0.047370824346745326) :- todo_served(Child), allergic_gluten(Child), !.
delta(131, make_sandwich(_, _, _), 0.0013912650883917204) :- goal_served(Child), done_served(Child), !.
delta(131, make_sandwich(_, _, _), 3.1239585549749145e-6) :- !.
delta(131, put_on_tray(Sandwich, Tray), 0.003458564440739531) :- no_gluten_sandwich(Sandwich), ontray(_, Tray), !.
delta(131, put_on_tray(Sandwich, _), -0.005559539219249302) :- no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served, !.
delta(131, put_on_tray(Sandwich, _), 0.0006204579759328604) :- no_gluten_sandwich(Sandwich), !.
delta(131, put_on_tray(_, _), -0.002846890448312702) :- fewer_at_2_than_allergic_gluten, at_kitchen_bread(_), !.
delta(131, put_on_tray(_, _), 0.001015437853124684) :- fewer_at_2_than_allergic_gluten, !.
delta(131, put_on_tray(_, _), 0.010801974996516037) :- todo_served(Child), not_allergic_gluten(Child), no_gluten_bread(_), !.
delta(131, put_on_tray(_, _), 7.150428490392318e-5) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(131, put_on_tray(_, _), -0.0006530755842600352) :- !.
delta(131, serve_sandwich_no_gluten(_, _, _, Place), 5.1449348254861846e-5) :- done_served(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(131, serve_sandwich_no_gluten(_, _, _, Place), -0.028151289388429535) :- done_served(Child), waiting(Child, Place), !.
delta(131, serve_sandwich_no_gluten(_, _, _, _), 0.00045392215052665114) :- notexist(_), !.
delta(131, serve_sandwich_no_gluten(_, _, _, _), 1.6296667258748234e-6) :- !.
delta(131, serve_sandwich(_, _, _, _), 7.989453815482853e-5) :- done_served(Child), not_allergic_gluten(Child), fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_bread(_), !.
delta(131, serve_sandwich(_, Child, _, _), 0.01878655990629999) :- done_served(Child2), not_allergic_gluten(Child2), fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), !.
delta(131, serve_sandwich(_, _, _, _), -8.534191151121125e-5) :- done_served(Child), not_allergic_gluten(Child), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(131, serve_sandwich(_, Child, _, _), -0.00015349168503111081) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(131, serve_sandwich(_, Child, _, _), 0.00021538949193082775) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(131, serve_sandwich(_, _, _, _), -0.0017054023868985518) :- done_served(Child), not_allergic_gluten(Child), !.
delta(131, serve_sandwich(_, _, _, _), -0.11188587289862567) :- goal_served(Child), allergic_gluten(Child), fewer_no_gluten_sandwich_than_todo_served, !.
delta(131, serve_sandwich(_, _, _, _), 1.4744910695166134e-5) :- goal_served(Child), allergic_gluten(Child), !.
delta(131, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_bread(_), !.
delta(131, serve_sandwich(_, _, _, _), 0.0017745489550877037) :- !.
delta(131, move_tray(_, Place, Place2), 0.004182092444173125) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place2), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(131, move_tray(_, Place, Place2), -0.00014642707071131487) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place2), waiting(Child, Place), !.
delta(131, move_tray(_, _, Place), -0.001195100079328647) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(131, move_tray(_, Place, _), -0.024245353214618365) :- done_served(Child), not_allergic_gluten(Child), fewer_at_2_than_todo_served, goal_served(Child2), waiting(Child2, Place), !.
delta(131, move_tray(_, _, _), 1.8111591307400257e-5) :- done_served(Child), not_allergic_gluten(Child), fewer_at_2_than_todo_served, !.
delta(131, move_tray(_, _, kitchen), -0.0056091904637936545) :- done_served(Child), not_allergic_gluten(Child), !.
delta(131, move_tray(_, _, _), 0.007044314638060052) :- done_served(Child), not_allergic_gluten(Child), !.
delta(131, move_tray(_, Place, Place2), 0.0013417872478672216) :- notexist(_), fewer_at_2_than_todo_served_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(131, move_tray(_, _, _), -0.0024763448928691186) :- notexist(_), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(131, move_tray(_, Place, _), -0.001109299893614516) :- notexist(_), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(131, move_tray(_, _, _), 0.14592303360164402) :- notexist(_), !.
delta(131, move_tray(Tray, _, Place), 0.0005611599108828559) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(131, move_tray(Tray, _, _), 3.950060395701954e-6) :- at(Tray, kitchen), !.
delta(131, move_tray(_, _, _), -0.0027318513613401236) :- !.
delta(131, _, 0.0).

% tree 132: step size 1.0, 204 examples, 35 leaves
delta(132, make_sandwich_no_gluten(_, _, _), 0.015128470569103996) :- fewer_ontray_1_than_allergic_gluten, !.
delta(132, make_sandwich_no_gluten(_, _, _), -0.009125051720203017) :- fewer_at_2_than_todo_served, !.
delta(132, make_sandwich_no_gluten(_, _, _), 1.8663117766184422e-5) :- !.
delta(132, make_sandwich(_, _, _), -0.007264745603488942) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(132, make_sandwich(_, _, _), 0.013077841802895389) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(132, make_sandwich(_, _, _), -0.0001525465935455272) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(132, make_sandwich(_, _, _), -0.052835814445457964) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_2_than_todo_served, !.
delta(132, make_sandwich(_, _, _), 6.9764300369718694e-6) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(132, make_sandwich(_, _, _), 0.013339572836606771) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(132, make_sandwich(_, _, _), -4.254679258537229e-6) :- !.
delta(132, put_on_tray(_, _), 0.009218680116466428) :- fewer_ontray_1_than_todo_served, !.
delta(132, put_on_tray(_, _), -0.00028649047454707593) :- !.
delta(132, serve_sandwich_no_gluten(_, Child, _, _), 0.013058840666302926) :- todo_served(Child), !.
delta(132, serve_sandwich_no_gluten(_, _, _, _), -0.013183771161935783) :- !.
delta(132, serve_sandwich(_, Child, _, Place), 0.013752404754704314) :- done_served(Child2), waiting(Child2, Place), fewer_no_gluten_sandwich_than_todo_served, todo_served(Child), !.
delta(132, serve_sandwich(_, _, _, Place), -8.982369375652485e-5) :- done_served(Child), waiting(Child, Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(132, serve_sandwich(_, _, _, Place), -0.002160272938169558) :- done_served(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(132, serve_sandwich(_, Child, _, Place), 0.00010241721168221275) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(132, serve_sandwich(_, _, _, Place), -3.129332190317915e-5) :- done_served(Child), waiting(Child, Place), !.
delta(132, serve_sandwich(_, _, _, _), 0.00019806099938227877) :- at_kitchen_sandwich(_), done_served(Child), allergic_gluten(Child), !.
delta(132, serve_sandwich(_, _, _, _), -0.04124386845436208) :- at_kitchen_sandwich(_), !.
delta(132, serve_sandwich(_, _, _, _), 0.0029401140890239017) :- !.
delta(132, move_tray(_, _, _), -0.024104626274175072) :- no_gluten_sandwich(_), goal_served(Child), allergic_gluten(Child), !.
delta(132, move_tray(Tray, Place, Place2), -1.043066034631309e-6) :- no_gluten_sandwich(_), could_serve_sandwich(Tray, Place2), goal_served(Child), waiting(Child, Place), !.
delta(132, move_tray(Tray, _, Place), 0.00036955580214668765) :- no_gluten_sandwich(_), could_serve_sandwich(Tray, Place), !.
delta(132, move_tray(_, _, Place), -0.00040450646804026264) :- no_gluten_sandwich(_), goal_served(Child), waiting(Child, Place), !.
delta(132, move_tray(_, _, _), 3.2683992010347204e-5) :- no_gluten_sandwich(_), !.
delta(132, move_tray(_, Place, Place2), 0.000892833104060221) :- done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), fewer_at_1_than_todo_served, !.
delta(132, move_tray(_, Place, Place2), -0.0001223009313195314) :- done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(132, move_tray(_, Place, _), -0.0066863065902608805) :- done_served(Child), waiting(Child, Place), fewer_at_1_than_todo_served, !.
delta(132, move_tray(_, Place, _), 0.00012225869678768526) :- done_served(Child), waiting(Child, Place), !.
delta(132, move_tray(_, Place, _), -0.00010373235078742775) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(132, move_tray(_, _, _), 0.07153979929086642) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(132, move_tray(_, _, _), -0.0014077242289673706) :- !.
delta(132, _, 0.0).

% tree 133: step size 1.0, 228 examples, 37 leaves
delta(133, make_sandwich_no_gluten(_, _, _), 0.000298195953745373) :- no_gluten_sandwich(_), !.
delta(133, make_sandwich_no_gluten(_, _, _), -0.17288300796703968) :- fewer_at_2_than_allergic_gluten, !.
delta(133, make_sandwich_no_gluten(_, _, _), 5.820038580468314e-5) :- !.
delta(133, make_sandwich(_, _, _), -0.0006691906599840296) :- goal_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_2_than_allergic_gluten, !.
delta(133, make_sandwich(_, _, _), 7.427253049632534e-5) :- goal_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(133, make_sandwich(_, _, Content_portion), -0.00024763586598885843) :- goal_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, no_gluten_content(Content_portion), !.
delta(133, make_sandwich(_, _, _), 0.18200728949862632) :- goal_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, !.
delta(133, make_sandwich(_, _, _), 5.08608449471496e-6) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(133, make_sandwich(_, _, _), -0.0003326781905056007) :- goal_served(Child), allergic_gluten(Child), !.
delta(133, make_sandwich(_, _, _), -0.0054305540905602604) :- at_kitchen_sandwich(_), !.
delta(133, make_sandwich(_, _, _), 0.00015555971432129284) :- !.
delta(133, put_on_tray(_, _), 0.008137327650647263) :- !.
delta(133, serve_sandwich_no_gluten(Sandwich, _, _, Place), 6.842581811329584e-7) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(133, serve_sandwich_no_gluten(Sandwich, _, _, Place), 0.06782477646326272) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(133, serve_sandwich_no_gluten(_, _, _, _), -0.06668955569493701) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(133, serve_sandwich_no_gluten(_, _, _, _), 0.0009850164243949495) :- !.
delta(133, serve_sandwich(Sandwich, _, _, Place), -0.0015900125746905972) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(133, serve_sandwich(Sandwich, _, _, Place), -2.475537046580742e-5) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), no_gluten_sandwich(Sandwich), !.
delta(133, serve_sandwich(Sandwich, _, _, Place), 0.016467712337619084) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(133, serve_sandwich(_, _, _, _), -0.21343743727997389) :- fewer_at_1_than_todo_served, !.
delta(133, serve_sandwich(_, Child, _, _), 0.003787574001933845) :- todo_served(Child), !.
delta(133, serve_sandwich(_, _, _, _), -9.236396775007818e-5) :- !.
delta(133, move_tray(_, _, Place), 0.0006446026040310531) :- todo_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place), fewer_ontray_2_than_allergic_gluten, !.
delta(133, move_tray(_, _, Place), 0.0) :- todo_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(133, move_tray(_, _, _), -0.00036965502504190283) :- todo_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(133, move_tray(_, Place, Place2), -0.00190979123061968) :- todo_served(Child), allergic_gluten(Child), at(Tray, Place), could_put_on_tray(Tray, Place2), waiting(Child, Place), !.
delta(133, move_tray(_, Place, Place2), 0.0020997430737248685) :- todo_served(Child), allergic_gluten(Child), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(133, move_tray(_, Place, Place2), 4.38849399665817e-5) :- todo_served(Child), allergic_gluten(Child), at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(133, move_tray(_, _, _), -0.009239527731675898) :- todo_served(Child), allergic_gluten(Child), !.
delta(133, move_tray(Tray, _, _), 0.234758717828625) :- at(Tray, Place), could_serve_sandwich(Tray, Place), fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(133, move_tray(Tray, _, _), -7.32721470392627e-5) :- at(Tray, Place), could_serve_sandwich(Tray, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(133, move_tray(Tray, _, _), -0.0003550815693069439) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(133, move_tray(_, Place, Place2), -0.000384684013685769) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(133, move_tray(_, Place, Place2), 0.0027378021982069306) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(133, move_tray(_, Place, Place2), 0.0011163733637649898) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(133, move_tray(_, _, _), -0.00470782686235733) :- !.
delta(133, _, 0.0).

% tree 134: step size 1.0, 246 examples, 34 leaves
delta(134, make_sandwich_no_gluten(_, _, _), 0.010294766359324505) :- !.
delta(134, make_sandwich(_, _, _), -0.023948493237464487) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(134, make_sandwich(_, _, _), 0.0002512105890325923) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(134, make_sandwich(_, _, _), -0.0001875151803882024) :- !.
delta(134, put_on_tray(_, Tray), 0.008486827334020206) :- ontray(_, Tray), todo_served(Child), not_allergic_gluten(Child), !.
delta(134, put_on_tray(_, Tray), -0.00031574201579378266) :- ontray(_, Tray), !.
delta(134, put_on_tray(_, _), -0.004781913698470816) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(134, put_on_tray(Sandwich, _), 0.002520154227108534) :- no_gluten_sandwich(Sandwich), !.
delta(134, put_on_tray(_, _), -0.00046478705362215823) :- todo_served(Child), allergic_gluten(Child), !.
delta(134, put_on_tray(_, _), 0.000137606006739646) :- !.
delta(134, serve_sandwich_no_gluten(_, _, _, _), 7.32823635945802e-5) :- !.
delta(134, serve_sandwich(_, _, _, Place), 0.00012704760369327547) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), at_kitchen_bread(_), !.
delta(134, serve_sandwich(_, _, _, Place), -0.19147357910497662) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), fewer_ontray_2_than_todo_served, !.
delta(134, serve_sandwich(_, _, _, Place), -7.34509190551013e-6) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), !.
delta(134, serve_sandwich(_, _, _, Place), 0.020582953825755083) :- done_served(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(134, serve_sandwich(_, _, _, Place), 0.0) :- done_served(Child), waiting(Child, Place), !.
delta(134, serve_sandwich(_, _, _, _), 0.023485753032270188) :- goal_served(Child), done_served(Child), !.
delta(134, serve_sandwich(_, _, Tray, _), 0.009701396175545312) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(134, serve_sandwich(_, _, _, _), 0.0024458638946729806) :- notexist(_), !.
delta(134, serve_sandwich(_, _, _, _), -0.011042727777004055) :- !.
delta(134, move_tray(_, Place, Place2), 0.007432735115702723) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), waiting(Child2, Place2), !.
delta(134, move_tray(_, Place, _), -0.0074748760718908154) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(134, move_tray(_, Place, _), 0.22218256465602854) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), fewer_ontray_2_than_todo_served, !.
delta(134, move_tray(_, Place, _), -2.6889955414515968e-5) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), !.
delta(134, move_tray(_, Place, _), -0.011806139316836427) :- done_served(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(134, move_tray(_, Place, _), 0.0025647189243605895) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(134, move_tray(_, Place, _), -9.521866653961342e-7) :- done_served(Child), waiting(Child, Place), !.
delta(134, move_tray(Tray, Place, Place2), -0.007312957800528423) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(134, move_tray(_, Place, Place2), 0.011675715466195597) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(134, move_tray(Tray, _, Place), 0.003999237966257135) :- could_serve_sandwich_no_gluten(Tray, Place), at(Tray, kitchen), !.
delta(134, move_tray(Tray, _, Place), -0.0005367816191338735) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(134, move_tray(_, _, _), -0.03512738167783152) :- fewer_ontray_2_than_todo_served, !.
delta(134, move_tray(_, _, _), 6.733925748628594e-5) :- !.
delta(134, _, 0.0).

% tree 135: step size 1.0, 234 examples, 40 leaves
delta(135, make_sandwich_no_gluten(_, _, _), 0.020821760190121278) :- fewer_at_1_than_allergic_gluten, !.
delta(135, make_sandwich_no_gluten(_, _, _), -0.07344387846523422) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(135, make_sandwich_no_gluten(_, _, _), 1.1895904004144202e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(135, make_sandwich_no_gluten(_, _, _), 0.00020654988327092598) :- !.
delta(135, make_sandwich(_, _, _), -0.03267025333723724) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(135, make_sandwich(_, _, _), 0.0072679498079519025) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(135, make_sandwich(_, _, _), -6.4988727044494e-6) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(135, make_sandwich(_, Bread_portion, _), -0.00018713239889119613) :- fewer_ontray_2_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(135, make_sandwich(_, _, _), 2.347769286821885e-5) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(135, make_sandwich(_, _, _), 0.06755712519218707) :- fewer_ontray_2_than_allergic_gluten, !.
delta(135, make_sandwich(_, _, _), -0.05888401499836963) :- !.
delta(135, put_on_tray(_, Tray), -0.009851554926576774) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(135, put_on_tray(_, Tray), 0.0002563048709879407) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(135, put_on_tray(_, Tray), 0.0015531415079159904) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(135, put_on_tray(_, _), -9.206477640178463e-6) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(135, put_on_tray(_, _), 0.0047662461602732305) :- !.
delta(135, serve_sandwich_no_gluten(_, Child, _, _), 0.0028600502680284174) :- todo_served(Child), !.
delta(135, serve_sandwich_no_gluten(_, _, _, _), -0.0031715928632459205) :- !.
delta(135, serve_sandwich(_, _, _, _), 0.05757309387489203) :- at_kitchen_sandwich(_), notexist(_), !.
delta(135, serve_sandwich(_, _, _, _), -0.004749019511000661) :- at_kitchen_sandwich(_), !.
delta(135, serve_sandwich(_, _, _, Place), 0.024948128134318927) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(135, serve_sandwich(_, _, _, Place), -2.45203276305065e-5) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(135, serve_sandwich(_, _, _, _), 0.0005411828042567285) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(135, serve_sandwich(_, _, _, _), -0.03340457556620703) :- goal_served(Child), done_served(Child), !.
delta(135, serve_sandwich(_, _, _, _), -1.0136929959808266e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(135, serve_sandwich(_, _, _, _), 0.002888693306604523) :- !.
delta(135, move_tray(_, _, _), -0.05005776849721261) :- at_kitchen_sandwich(_), notexist(_), fewer_at_2_than_todo_served, !.
delta(135, move_tray(_, _, Place), 0.0002001052785128255) :- at_kitchen_sandwich(_), notexist(_), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(135, move_tray(_, _, _), -0.0002531770751329443) :- at_kitchen_sandwich(_), notexist(_), !.
delta(135, move_tray(_, _, Place), -0.0012442436111359974) :- at_kitchen_sandwich(_), goal_served(Child), waiting(Child, Place), !.
delta(135, move_tray(_, _, Place), -0.0002606479489189022) :- at_kitchen_sandwich(_), at(_, Place), !.
delta(135, move_tray(_, _, _), 0.005649876407760393) :- at_kitchen_sandwich(_), !.
delta(135, move_tray(_, _, Place), -0.007572722062047821) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(135, move_tray(_, _, Place), 0.0004024582341330743) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(135, move_tray(_, _, Place), -0.00027213512319339625) :- done_served(Child), waiting(Child, Place), !.
delta(135, move_tray(_, _, Place), -0.0008257955978138485) :- fewer_ontray_2_than_todo_served, allergic_gluten(Child), waiting(Child, Place), !.
delta(135, move_tray(_, _, _), 0.06293124155644678) :- fewer_ontray_2_than_todo_served, !.
delta(135, move_tray(Tray, _, Place), 6.303193832271429e-5) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(135, move_tray(_, _, _), -0.001130919980130644) :- !.
delta(135, _, 0.0).

% tree 136: step size 1.0, 246 examples, 29 leaves
delta(136, make_sandwich_no_gluten(_, _, _), 0.00237372948607426) :- !.
delta(136, make_sandwich(_, _, _), 0.0063105364252942) :- done_served(Child), not_allergic_gluten(Child), !.
delta(136, make_sandwich(_, _, _), -0.03408560031126291) :- fewer_at_1_than_todo_served, !.
delta(136, make_sandwich(_, _, _), 5.418895650955446e-5) :- !.
delta(136, put_on_tray(_, _), 6.63483403786118e-5) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(136, put_on_tray(_, _), -0.018800305936288758) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(136, put_on_tray(_, _), 0.004368663560110822) :- !.
delta(136, serve_sandwich_no_gluten(_, _, _, Place), -0.0013697259832770475) :- done_served(Child), waiting(Child, Place), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(136, serve_sandwich_no_gluten(_, _, _, Place), 9.371629688565584e-7) :- done_served(Child), waiting(Child, Place), !.
delta(136, serve_sandwich_no_gluten(_, _, _, _), 0.0016328487782369236) :- !.
delta(136, serve_sandwich(Sandwich, _, _, _), 0.008727025486414124) :- no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, !.
delta(136, serve_sandwich(Sandwich, _, _, _), -0.02451475229737195) :- no_gluten_sandwich(Sandwich), !.
delta(136, serve_sandwich(_, _, _, _), -0.0007052191638818781) :- done_served(Child), not_allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(136, serve_sandwich(_, Child, _, _), 0.006074775633413096) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(136, serve_sandwich(_, _, _, _), -0.00013821796548299834) :- done_served(Child), not_allergic_gluten(Child), !.
delta(136, serve_sandwich(_, _, _, _), 0.16855561830268187) :- !.
delta(136, move_tray(Tray, Place, Place2), 0.002518926065716913) :- goal_served(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place2), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(136, move_tray(_, Place, Place2), -0.17895419585846065) :- goal_served(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place2), !.
delta(136, move_tray(_, Place, _), 0.03150940379260781) :- goal_served(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), fewer_at_2_than_todo_served, !.
delta(136, move_tray(_, Place, _), -0.000979892466900399) :- goal_served(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(136, move_tray(_, Place, _), -0.020533094251564472) :- goal_served(Child), waiting(Child, Place), !.
delta(136, move_tray(_, _, _), -0.00022922679487132755) :- fewer_at_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(136, move_tray(_, _, _), 0.03726267136983401) :- fewer_at_1_than_todo_served, notexist(_), !.
delta(136, move_tray(_, _, _), -1.1556687423521532e-5) :- fewer_at_1_than_todo_served, !.
delta(136, move_tray(_, Place, Place2), 0.009484566279361329) :- at(Tray, Place2), could_put_on_tray(Tray, Place), notexist(_), !.
delta(136, move_tray(_, Place, Place2), -7.14275842753686e-6) :- at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(136, move_tray(_, _, _), -0.010185413825577116) :- goal_served(Child), allergic_gluten(Child), !.
delta(136, move_tray(_, _, _), 1.4114206529470904e-5) :- !.
delta(136, _, 0.0).

% tree 137: step size 1.0, 277 examples, 35 leaves
delta(137, make_sandwich_no_gluten(_, _, _), -0.15937875519648842) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(137, make_sandwich_no_gluten(_, _, _), 1.6470202000367164e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(137, make_sandwich_no_gluten(_, _, _), 0.00020766184595915203) :- !.
delta(137, make_sandwich(_, _, _), 0.16992608234676923) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(137, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(137, make_sandwich(_, _, _), -0.0005589560688939766) :- fewer_at_1_than_allergic_gluten, !.
delta(137, make_sandwich(_, _, _), 6.784256008222455e-6) :- done_served(Child), not_allergic_gluten(Child), !.
delta(137, make_sandwich(_, _, _), -0.026300347766190023) :- !.
delta(137, put_on_tray(Sandwich, Tray), 0.00019341508995803346) :- ontray(_, Tray), at_kitchen_bread(_), no_gluten_sandwich(Sandwich), !.
delta(137, put_on_tray(_, Tray), -0.0106803865493197) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(137, put_on_tray(_, Tray), 0.0017318276913702657) :- ontray(_, Tray), !.
delta(137, put_on_tray(_, _), -0.0006634235372572015) :- goal_served(Child), done_served(Child), !.
delta(137, put_on_tray(_, _), 0.006789595625600308) :- !.
delta(137, serve_sandwich_no_gluten(_, Child, _, _), 0.014770908704931194) :- todo_served(Child), !.
delta(137, serve_sandwich_no_gluten(_, _, _, _), -0.0688638797427118) :- !.
delta(137, serve_sandwich(_, _, _, Place), -0.0030658401745195687) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), fewer_no_gluten_sandwich_than_todo_served, !.
delta(137, serve_sandwich(_, Child, _, Place), 0.00024024821221643313) :- allergic_gluten(Child2), waiting(Child2, Place), done_served(Child3), not_allergic_gluten(Child3), todo_served(Child), !.
delta(137, serve_sandwich(_, _, _, Place), -0.00010383870707947371) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(137, serve_sandwich(_, _, Tray, Place), -0.0005013351197334975) :- allergic_gluten(Child), waiting(Child, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(137, serve_sandwich(_, _, _, Place), 0.07698815957171516) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(137, serve_sandwich(_, _, _, _), -0.09352434431057935) :- at_kitchen_sandwich(_), no_gluten_bread(_), !.
delta(137, serve_sandwich(_, _, _, _), -0.0003530720668614244) :- at_kitchen_sandwich(_), !.
delta(137, serve_sandwich(Sandwich, _, _, _), -0.010863114375351696) :- no_gluten_sandwich(Sandwich), fewer_ontray_2_than_todo_served, !.
delta(137, serve_sandwich(Sandwich, _, _, _), 1.915188984830291e-5) :- no_gluten_sandwich(Sandwich), !.
delta(137, serve_sandwich(_, _, _, _), 0.01606528755605157) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(137, serve_sandwich(_, _, _, _), -5.805311796471933e-6) :- !.
delta(137, move_tray(_, _, _), -0.021696159004425192) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(137, move_tray(_, Place, Place2), 0.013545744108789058) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(137, move_tray(_, Place, Place2), 4.9721876059475e-5) :- done_served(Child), waiting(Child, Place), at(_, Place2), !.
delta(137, move_tray(_, Place, _), -0.021426713960244113) :- done_served(Child), waiting(Child, Place), !.
delta(137, move_tray(_, _, _), 0.11335374845183446) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_bread(_), !.
delta(137, move_tray(_, _, _), -0.00027863309373333904) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(137, move_tray(_, _, _), 0.00017052019094765112) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(137, move_tray(_, _, _), -0.0010429586761081682) :- !.
delta(137, _, 0.0).

% tree 138: step size 1.0, 232 examples, 38 leaves
delta(138, make_sandwich_no_gluten(_, _, _), 0.02579546537562968) :- fewer_ontray_1_than_allergic_gluten, !.
delta(138, make_sandwich_no_gluten(_, _, _), -0.00877432519937409) :- todo_served(Child), allergic_gluten(Child), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(138, make_sandwich_no_gluten(_, _, _), 2.532572004410041e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(138, make_sandwich_no_gluten(_, _, _), 0.00019695280826122696) :- !.
delta(138, make_sandwich(_, _, _), 0.011426030992097828) :- done_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(138, make_sandwich(_, _, _), -0.0022230232493005812) :- done_served(Child), allergic_gluten(Child), !.
delta(138, make_sandwich(_, _, _), -0.0678797637953704) :- fewer_at_1_than_todo_served, !.
delta(138, make_sandwich(_, _, _), 0.00010306638048189518) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(138, make_sandwich(_, _, _), -3.586828501150471e-5) :- !.
delta(138, put_on_tray(_, Tray), 0.008603182026756884) :- ontray(_, Tray), !.
delta(138, put_on_tray(_, _), -0.018142707302496102) :- todo_served(Child), not_allergic_gluten(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(138, put_on_tray(_, _), 1.6752846524622457e-6) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(138, put_on_tray(_, _), 8.126457880972251e-5) :- !.
delta(138, serve_sandwich_no_gluten(_, Child, _, _), 3.6137855503940197e-6) :- todo_served(Child), at_kitchen_bread(_), !.
delta(138, serve_sandwich_no_gluten(_, Child, _, _), 0.0) :- todo_served(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(138, serve_sandwich_no_gluten(_, Child, _, _), 0.0022964199041506555) :- todo_served(Child), !.
delta(138, serve_sandwich_no_gluten(_, _, _, _), -0.02174182212986253) :- !.
delta(138, serve_sandwich(_, _, _, _), 0.05076899853414363) :- notexist(_), fewer_at_1_than_todo_served, !.
delta(138, serve_sandwich(_, _, _, _), -5.267213022224548e-5) :- notexist(_), todo_served(Child), allergic_gluten(Child), !.
delta(138, serve_sandwich(_, _, _, _), 6.909268720996166e-5) :- notexist(_), !.
delta(138, serve_sandwich(Sandwich, _, _, _), 0.04603371582521909) :- no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(138, serve_sandwich(Sandwich, _, _, _), 8.95834337691948e-5) :- no_gluten_sandwich(Sandwich), !.
delta(138, serve_sandwich(_, _, _, _), -0.046028968457723245) :- no_gluten_sandwich(_), fewer_at_1_than_not_allergic_gluten, !.
delta(138, serve_sandwich(_, _, _, _), 1.0912400176006523e-6) :- no_gluten_sandwich(_), !.
delta(138, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_sandwich(_), !.
delta(138, serve_sandwich(_, _, _, _), 0.00027921665170829566) :- !.
delta(138, move_tray(Tray, _, Place), 0.03970863236567069) :- allergic_gluten(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), todo_served(Child), !.
delta(138, move_tray(Tray, _, Place), 5.773169100847987e-5) :- allergic_gluten(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(138, move_tray(Tray, _, Place), -5.8693645294556886e-5) :- allergic_gluten(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), !.
delta(138, move_tray(Tray, _, Place), 0.00010234300515451811) :- allergic_gluten(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(138, move_tray(_, _, Place), -0.0008612212998265449) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(138, move_tray(_, Place, Place2), 0.003283055799259119) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(138, move_tray(_, Place, _), 0.0023354373870940613) :- done_served(Child), waiting(Child, Place), at_kitchen_bread(_), !.
delta(138, move_tray(_, Place, _), -0.0028258764670589824) :- done_served(Child), waiting(Child, Place), !.
delta(138, move_tray(_, Place, Place2), 8.96691193319558e-5) :- fewer_ontray_1_than_todo_served_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(138, move_tray(_, _, _), -7.152147597817806e-5) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(138, move_tray(_, _, _), -0.029183724014296697) :- !.
delta(138, _, 0.0).

% tree 139: step size 1.0, 210 examples, 30 leaves
delta(139, make_sandwich_no_gluten(_, _, _), 0.015304137332353166) :- !.
delta(139, make_sandwich(_, _, _), -0.0409405580626377) :- goal_served(Child), allergic_gluten(Child), !.
delta(139, make_sandwich(_, _, _), 0.0011097227228470863) :- !.
delta(139, put_on_tray(_, _), -0.0021546576919535456) :- goal_served(Child), done_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(139, put_on_tray(_, _), 5.80916856682751e-5) :- goal_served(Child), done_served(Child), !.
delta(139, put_on_tray(_, Tray), 0.006020002602777692) :- ontray(_, Tray), !.
delta(139, put_on_tray(Sandwich, _), 0.0028535476224319997) :- no_gluten_sandwich(Sandwich), !.
delta(139, put_on_tray(_, _), 0.0) :- fewer_at_1_than_allergic_gluten, !.
delta(139, put_on_tray(_, _), -0.00436839084148396) :- !.
delta(139, serve_sandwich_no_gluten(_, _, _, _), 0.0022492509863492544) :- at_kitchen_sandwich(_), !.
delta(139, serve_sandwich_no_gluten(_, _, _, _), -0.00022485219059996663) :- fewer_ontray_1_than_allergic_gluten, !.
delta(139, serve_sandwich_no_gluten(_, _, _, _), 1.8774528996185164e-5) :- !.
delta(139, serve_sandwich(Sandwich, _, _, Place), 0.010668415897711489) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(139, serve_sandwich(_, _, _, _), -0.02496636578476115) :- done_served(Child), not_allergic_gluten(Child), fewer_at_1_than_todo_served, !.
delta(139, serve_sandwich(_, Child, _, _), 0.0007013518056720743) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(139, serve_sandwich(_, _, _, _), -4.449781816628296e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(139, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(139, serve_sandwich(_, _, _, _), -0.0017169905523982953) :- at_kitchen_bread(_), !.
delta(139, serve_sandwich(_, _, _, _), 0.00859443271126586) :- !.
delta(139, move_tray(_, _, Place), -0.026081558162684502) :- needed_at_to_serve_sandwich_no_gluten(Place), at_kitchen_sandwich(_), !.
delta(139, move_tray(_, Place, Place2), -0.0019880101447262333) :- needed_at_to_serve_sandwich_no_gluten(Place2), todo_served(Child), waiting(Child, Place), !.
delta(139, move_tray(Tray, _, Place), 0.009065578266831157) :- needed_at_to_serve_sandwich_no_gluten(Place), ontray(_, Tray), !.
delta(139, move_tray(_, _, Place), -5.2484734610984904e-5) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(139, move_tray(Tray, _, _), -0.0006450491252859541) :- at_kitchen_sandwich(_), ontray(_, Tray), fewer_ontray_1_than_allergic_gluten, !.
delta(139, move_tray(Tray, _, _), 0.05540087308323032) :- at_kitchen_sandwich(_), ontray(_, Tray), !.
delta(139, move_tray(_, Place, _), 0.0010680361923123376) :- at_kitchen_sandwich(_), done_served(Child), waiting(Child, Place), !.
delta(139, move_tray(_, _, _), -0.006195821183716376) :- at_kitchen_sandwich(_), !.
delta(139, move_tray(Tray, _, Place), 4.73761004479285e-6) :- could_serve_sandwich(Tray, Place), !.
delta(139, move_tray(_, _, _), -0.005731088977413598) :- !.
delta(139, _, 0.0).

% tree 140: step size 1.0, 203 examples, 34 leaves
delta(140, make_sandwich_no_gluten(_, _, _), 0.034679651381961246) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(140, make_sandwich_no_gluten(_, _, _), 3.10860575643564e-5) :- !.
delta(140, make_sandwich(_, _, _), -0.05234686297735316) :- fewer_ontray_1_than_allergic_gluten, !.
delta(140, make_sandwich(_, _, _), 0.03633793567599957) :- fewer_ontray_1_than_todo_served, !.
delta(140, make_sandwich(_, _, _), -0.0009588524577876138) :- !.
delta(140, put_on_tray(Sandwich, Tray), 0.001275766580376602) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(_, Tray), no_gluten_sandwich(Sandwich), !.
delta(140, put_on_tray(_, Tray), -0.002786796549881175) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(_, Tray), !.
delta(140, put_on_tray(_, _), 0.031070886466844687) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(140, put_on_tray(_, _), 2.753178316442e-7) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(140, put_on_tray(_, _), -0.031623398972292265) :- !.
delta(140, serve_sandwich_no_gluten(_, _, _, _), -0.0031727024570133012) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(140, serve_sandwich_no_gluten(_, _, _, _), 0.00029657478717098104) :- !.
delta(140, serve_sandwich(_, _, _, Place), -0.14631316338760794) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), not_allergic_gluten(Child), !.
delta(140, serve_sandwich(_, _, _, Place), 0.0) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(140, serve_sandwich(_, Child, _, Place), 0.013794134012309937) :- done_served(Child2), waiting(Child2, Place), fewer_at_1_than_todo_served, todo_served(Child), !.
delta(140, serve_sandwich(_, _, _, Place), -4.743498927975822e-5) :- done_served(Child), waiting(Child, Place), fewer_at_1_than_todo_served, !.
delta(140, serve_sandwich(_, _, _, Place), -3.230131222302933e-5) :- done_served(Child), waiting(Child, Place), !.
delta(140, serve_sandwich(_, _, _, _), 0.06361556110255984) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(140, serve_sandwich(_, _, _, _), -5.245213144230525e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(140, serve_sandwich(_, _, _, _), 0.0016017253224610644) :- !.
delta(140, move_tray(Tray, Place, _), 0.1251909503494534) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), could_serve_sandwich(Tray, Place), !.
delta(140, move_tray(_, Place, kitchen), 0.0004950003031595309) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(140, move_tray(_, Place, _), -0.0004969795642725275) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(140, move_tray(_, Place, Place2), 3.676446286228754e-5) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, done_served(Child2), waiting(Child2, Place2), !.
delta(140, move_tray(_, Place, _), -0.008276644286547131) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(140, move_tray(_, Place, Place2), 0.0006661190783991821) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place2), !.
delta(140, move_tray(_, Place, _), -0.00014838509885363026) :- done_served(Child), waiting(Child, Place), !.
delta(140, move_tray(_, Place, _), -0.08318532022863843) :- at(Tray, Place), ontray(_, Tray), fewer_at_1_than_not_allergic_gluten, !.
delta(140, move_tray(Tray, Place, _), 0.004440013746422305) :- at(Tray2, Place), ontray(Sandwich, Tray2), ontray(Sandwich, Tray), !.
delta(140, move_tray(_, Place, _), -0.0040383435336422534) :- at(Tray, Place), ontray(_, Tray), !.
delta(140, move_tray(_, Place, Place2), 0.007699065832633886) :- at_kitchen_bread(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(140, move_tray(_, _, _), -0.00011018759846348601) :- at_kitchen_bread(_), !.
delta(140, move_tray(_, _, _), -0.0004855419581170863) :- !.
delta(140, _, 0.0).

% tree 141: step size 1.0, 256 examples, 39 leaves
delta(141, make_sandwich_no_gluten(_, _, _), 0.027210426057953613) :- fewer_at_1_than_allergic_gluten, !.
delta(141, make_sandwich_no_gluten(_, _, _), 1.0254484021342177e-5) :- at_kitchen_sandwich(_), !.
delta(141, make_sandwich_no_gluten(_, _, _), -0.02973835721567371) :- fewer_at_2_than_allergic_gluten, !.
delta(141, make_sandwich_no_gluten(_, _, _), 1.1904888723802609e-5) :- !.
delta(141, make_sandwich(_, _, _), -0.04298166933820931) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(141, make_sandwich(_, _, _), -6.679076251668394e-5) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(141, make_sandwich(_, _, _), 0.005956911089464589) :- fewer_at_1_than_allergic_gluten, !.
delta(141, make_sandwich(_, _, Content_portion), -0.0009051594066034533) :- fewer_at_1_than_todo_served, no_gluten_content(Content_portion), !.
delta(141, make_sandwich(_, _, _), 0.052534630977185894) :- fewer_at_1_than_todo_served, !.
delta(141, make_sandwich(_, _, _), -0.002007149342453836) :- goal_served(Child), allergic_gluten(Child), !.
delta(141, make_sandwich(_, _, _), 1.3113003314139885e-6) :- !.
delta(141, put_on_tray(Sandwich, Tray), 0.0007029100063175047) :- ontray(_, Tray), at_kitchen_bread(_), fewer_no_gluten_sandwich_than_todo_served, no_gluten_sandwich(Sandwich), !.
delta(141, put_on_tray(_, Tray), -0.018654309904893775) :- ontray(_, Tray), at_kitchen_bread(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(141, put_on_tray(_, Tray), 0.0009231021016428803) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(141, put_on_tray(_, Tray), 0.0015754966716149887) :- ontray(_, Tray), !.
delta(141, put_on_tray(_, _), 0.005426713743186326) :- goal_served(Child), allergic_gluten(Child), !.
delta(141, put_on_tray(_, _), -0.0012489167788367504) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(141, put_on_tray(_, _), 6.90368261736721e-5) :- !.
delta(141, serve_sandwich_no_gluten(_, Child, _, _), 0.0010415318389011823) :- todo_served(Child), !.
delta(141, serve_sandwich_no_gluten(_, _, _, _), -0.0063508813660167725) :- !.
delta(141, serve_sandwich(_, Child, _, _), 4.874424826307986e-5) :- notexist(_), goal_served(Child2), done_served(Child2), fewer_ontray_1_than_allergic_gluten, todo_served(Child), !.
delta(141, serve_sandwich(_, _, _, _), -5.460875375121633e-5) :- notexist(_), goal_served(Child), done_served(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(141, serve_sandwich(_, _, _, _), 0.006439178362655359) :- notexist(_), goal_served(Child), done_served(Child), allergic_gluten(Child), !.
delta(141, serve_sandwich(_, _, _, _), 0.00014036607779798055) :- notexist(_), goal_served(Child), done_served(Child), !.
delta(141, serve_sandwich(_, _, _, _), -0.00992644037742648) :- notexist(_), !.
delta(141, serve_sandwich(_, _, _, _), -2.7293137825748438e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(141, serve_sandwich(_, _, _, Place), -4.044021141712739e-6) :- done_served(Child), waiting(Child, Place), !.
delta(141, serve_sandwich(_, _, _, _), 0.034891031665204415) :- !.
delta(141, move_tray(_, _, Place), 0.018312557130422787) :- done_served(Child), waiting(Child, Place), todo_served(Child2), allergic_gluten(Child2), fewer_at_1_than_todo_served, !.
delta(141, move_tray(_, _, Place), -9.584317839495937e-6) :- done_served(Child), waiting(Child, Place), todo_served(Child2), allergic_gluten(Child2), !.
delta(141, move_tray(_, _, Place), -0.0025140775447857143) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(141, move_tray(Tray, _, Place), 0.00038795952497923153) :- done_served(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), !.
delta(141, move_tray(_, _, Place), -0.000375703867854854) :- done_served(Child), waiting(Child, Place), !.
delta(141, move_tray(_, _, kitchen), 0.005955488613407649) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(141, move_tray(_, _, _), -0.00016105964510334752) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(141, move_tray(_, Place, Place2), 0.002050676245216134) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(141, move_tray(_, _, _), -7.354903072476833e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(141, move_tray(_, _, _), -0.06268676206943624) :- !.
delta(141, _, 0.0).

% tree 142: step size 1.0, 261 examples, 36 leaves
delta(142, make_sandwich_no_gluten(_, _, _), 0.024848954264064572) :- !.
delta(142, make_sandwich(_, _, _), -4.0675264594439294e-5) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(142, make_sandwich(_, _, _), -0.053436574513283916) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(142, make_sandwich(_, _, _), 1.2201846527122025e-6) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(142, make_sandwich(_, _, _), -0.0004956670299519602) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(142, make_sandwich(_, _, _), -8.778679347641455e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(142, make_sandwich(_, _, _), 0.013658879413848501) :- !.
delta(142, put_on_tray(_, _), 0.007746525802371099) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(142, put_on_tray(Sandwich, _), 0.0028966100216204034) :- no_gluten_sandwich(Sandwich), !.
delta(142, put_on_tray(_, _), 0.0002664290056340176) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(142, put_on_tray(_, _), -0.014890789632753552) :- !.
delta(142, serve_sandwich_no_gluten(_, Child, _, _), 0.0014137972623424289) :- todo_served(Child), !.
delta(142, serve_sandwich_no_gluten(_, _, _, _), -0.004219037312476751) :- !.
delta(142, serve_sandwich(_, _, _, _), 0.0002173256335928385) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_todo_served, at_kitchen_bread(_), !.
delta(142, serve_sandwich(_, _, _, _), -0.09601175845723534) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(142, serve_sandwich(_, _, _, _), 5.587607918081298e-5) :- fewer_ontray_1_than_allergic_gluten, fewer_ontray_2_than_todo_served, !.
delta(142, serve_sandwich(_, _, _, _), -1.5080544714946481e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(142, serve_sandwich(Sandwich, _, _, _), -0.00645749980003272) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(142, serve_sandwich(Sandwich, _, _, _), -2.6629289744147757e-6) :- no_gluten_sandwich(Sandwich), goal_served(Child), done_served(Child), !.
delta(142, serve_sandwich(Sandwich, _, _, _), 0.001082302855042391) :- no_gluten_sandwich(Sandwich), !.
delta(142, serve_sandwich(_, _, _, _), 0.02585497609579118) :- goal_served(Child), done_served(Child), fewer_at_1_than_todo_served, !.
delta(142, serve_sandwich(_, _, _, _), 2.3166489501395467e-5) :- goal_served(Child), done_served(Child), !.
delta(142, serve_sandwich(_, _, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), !.
delta(142, serve_sandwich(_, _, _, _), 0.00011545206534283796) :- !.
delta(142, move_tray(Tray, Place, Place2), -6.279294509037136e-5) :- allergic_gluten(Child), waiting(Child, Place2), at(_, Place2), could_put_on_tray(Tray, Place), !.
delta(142, move_tray(_, _, Place), 0.005428159631807235) :- allergic_gluten(Child), waiting(Child, Place), at(_, Place), fewer_at_1_than_allergic_gluten, !.
delta(142, move_tray(_, _, Place), -6.669497965641606e-7) :- allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(142, move_tray(_, _, Place), -0.04238177014378006) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(142, move_tray(_, Place, _), -0.00284298416085391) :- goal_served(Child), allergic_gluten(Child), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(142, move_tray(_, Place, _), -0.00028763217523335003) :- goal_served(Child), allergic_gluten(Child), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(142, move_tray(_, _, _), 0.12967042175192456) :- goal_served(Child), allergic_gluten(Child), !.
delta(142, move_tray(_, Place, Place2), -0.01518434075467794) :- todo_served(Child), waiting(Child, Place2), goal_served(Child2), waiting(Child2, Place), !.
delta(142, move_tray(_, _, Place), 1.9815743003990008e-5) :- todo_served(Child), waiting(Child, Place), !.
delta(142, move_tray(_, _, _), -0.0010658677546380375) :- no_gluten_bread(_), !.
delta(142, move_tray(_, _, _), 0.013573050468446505) :- !.
delta(142, _, 0.0).
