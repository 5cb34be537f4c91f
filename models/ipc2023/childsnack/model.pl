% SHA-256 of what follows: 7701ac9df5e5f2346e872b49383c8af5868dd3f80d49a7e967bb53c281285e52
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
model(bias_sha256, '9507e056c4f8f025e8780ee01ae5e5fa1a27f9a656e2c0759005f192bf14dc54').
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
model(trained_episodes, 1148).
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

% tree 3: step size 1.0, 203 examples, 16 leaves
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
delta(3, move_tray(_, _, _), 0.8574617495563162) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(3, move_tray(Tray, _, Place), 0.3131874807143081) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(3, move_tray(_, Place, Place2), 0.017913499052365108) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(3, move_tray(_, _, _), -0.4739475289567547) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 206 examples, 18 leaves
delta(4, make_sandwich_no_gluten(_, _, _), 0.18733266115154185) :- !.
delta(4, make_sandwich(_, _, _), -0.016350587136651887) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(4, make_sandwich(_, _, _), 0.2506467579178419) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(4, make_sandwich(_, _, _), -0.21301431978025664) :- !.
delta(4, put_on_tray(_, _), -0.004087536305858499) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(4, put_on_tray(_, _), 0.3786166633852461) :- fewer_ontray_1_than_todo_served, !.
delta(4, put_on_tray(_, _), 0.11059015551188078) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(4, put_on_tray(_, _), -0.08260221287669751) :- !.
delta(4, serve_sandwich_no_gluten(_, _, _, _), 0.3616339164286434) :- !.
delta(4, serve_sandwich(_, _, _, _), -0.2261543673110829) :- todo_served(Child), allergic_gluten(Child), !.
delta(4, serve_sandwich(_, _, _, _), 0.055803784433056) :- !.
delta(4, move_tray(_, Place, Place2), 0.15973710530075738) :- done_served(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(4, move_tray(_, _, Place), -0.07093012305345832) :- done_served(Child), waiting(Child, Place), !.
delta(4, move_tray(_, _, Place), 0.02871492806287104) :- fewer_at_1_than_not_allergic_gluten, todo_served(Child), waiting(Child, Place), !.
delta(4, move_tray(_, _, _), -0.07060428361147757) :- fewer_at_1_than_not_allergic_gluten, !.
delta(4, move_tray(_, Place, Place2), 0.009720600208364153) :- at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(4, move_tray(_, _, _), -0.4628402271502355) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 212 examples, 20 leaves
delta(5, make_sandwich_no_gluten(_, _, _), 0.1198710926505193) :- !.
delta(5, make_sandwich(_, _, _), -0.011109506185906663) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(5, make_sandwich(_, _, _), 0.4599106399671036) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(5, make_sandwich(_, _, _), -0.1489589831003508) :- !.
delta(5, put_on_tray(_, _), -0.0026082927469292727) :- fewer_ontray_1_than_todo_served, fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(5, put_on_tray(_, _), 0.24794276531617868) :- fewer_ontray_1_than_todo_served, !.
delta(5, put_on_tray(_, _), 0.022819992275405133) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(5, put_on_tray(_, _), -0.09838105130490167) :- !.
delta(5, serve_sandwich_no_gluten(_, _, _, _), 0.270174902740421) :- !.
delta(5, serve_sandwich(_, _, _, _), 0.021726842211304775) :- done_served(Child), allergic_gluten(Child), !.
delta(5, serve_sandwich(_, _, _, _), -1.7615510513761359) :- !.
delta(5, move_tray(_, Place, Place2), -0.6562299170126843) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_todo_served, !.
delta(5, move_tray(_, Place, Place2), 0.0024480664614434313) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), todo_served(Child), allergic_gluten(Child), !.
delta(5, move_tray(_, Place, Place2), -0.03159108155954687) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), at_kitchen_sandwich(_), !.
delta(5, move_tray(_, Place, Place2), 2.836503148015201) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(5, move_tray(_, Place, Place2), 0.42097555505795936) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(5, move_tray(_, Place, Place2), -0.02777255966679174) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(5, move_tray(Tray, _, Place), 0.21795128197789684) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(5, move_tray(_, _, _), -0.9337931955848005) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 221 examples, 23 leaves
delta(6, make_sandwich_no_gluten(_, _, _), -0.04563593693188558) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(6, make_sandwich_no_gluten(_, _, _), 0.0034242658009318934) :- at_kitchen_sandwich(_), !.
delta(6, make_sandwich_no_gluten(_, _, _), 0.1222048668966418) :- !.
delta(6, make_sandwich(_, _, _), -0.016704384637161448) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(6, make_sandwich(_, _, _), 0.38206297067426287) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(6, make_sandwich(_, _, _), -0.15001965251300378) :- !.
delta(6, put_on_tray(_, _), -0.0030325106144487987) :- fewer_ontray_1_than_todo_served, fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(6, put_on_tray(_, _), 0.18456023735552057) :- fewer_ontray_1_than_todo_served, !.
delta(6, put_on_tray(_, _), 0.030845908954192962) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(6, put_on_tray(_, _), -0.10160153575727375) :- !.
delta(6, serve_sandwich_no_gluten(_, _, _, _), 0.07398323738675316) :- !.
delta(6, serve_sandwich(_, Child, _, _), 0.5966744092084655) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(6, serve_sandwich(Sandwich, Child, _, _), -0.016783988570146888) :- todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(6, serve_sandwich(_, Child, _, _), 0.24112786815945284) :- todo_served(Child), !.
delta(6, serve_sandwich(_, _, _, _), -0.7594792330177756) :- !.
delta(6, move_tray(_, Place, Place2), 0.7601511217652782) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(6, move_tray(_, Place, Place2), 0.008928191714713374) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(6, move_tray(_, Place, _), -0.02795827287678301) :- done_served(Child), waiting(Child, Place), !.
delta(6, move_tray(_, _, _), -0.02190386606188661) :- todo_served(Child), not_allergic_gluten(Child), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(6, move_tray(_, _, _), -0.8735069733445702) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(6, move_tray(_, _, Place), -0.10563795097285575) :- at(_, Place), !.
delta(6, move_tray(_, _, _), 0.1726012446466544) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 202 examples, 22 leaves
delta(7, make_sandwich_no_gluten(_, _, _), 0.13061712207044426) :- !.
delta(7, make_sandwich(_, _, _), -0.015013146462048382) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(7, make_sandwich(_, _, _), 0.18110774366538113) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(7, make_sandwich(_, _, _), -0.17737711204455436) :- !.
delta(7, put_on_tray(_, _), 0.16318317088567552) :- fewer_ontray_1_than_todo_served, !.
delta(7, put_on_tray(_, _), 0.0370536676690269) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(7, put_on_tray(_, _), -0.03915992105034515) :- !.
delta(7, serve_sandwich_no_gluten(_, Child, _, _), 0.0001340806414327301) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(7, serve_sandwich_no_gluten(_, Child, _, _), 1.0931967085158536) :- todo_served(Child), !.
delta(7, serve_sandwich_no_gluten(_, _, _, _), -1.0963908607719624) :- !.
delta(7, serve_sandwich(_, Child, _, _), -0.10591709606618954) :- todo_served(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(7, serve_sandwich(_, Child, _, _), -0.046562628915376894) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(7, serve_sandwich(_, Child, _, _), 0.13788636981446398) :- todo_served(Child), !.
delta(7, serve_sandwich(_, _, _, _), -0.3710448682228356) :- !.
delta(7, move_tray(_, Place, Place2), 0.3726644313549144) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(7, move_tray(_, Place, Place2), 0.011229025177670798) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(7, move_tray(_, Place, _), -0.02381755271290009) :- done_served(Child), waiting(Child, Place), !.
delta(7, move_tray(_, _, Place), -0.5127990138859146) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(7, move_tray(_, _, Place), -0.01553326680708283) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(7, move_tray(Tray, _, _), 0.13384565134416168) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(7, move_tray(_, _, _), -0.08377820663958095) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 208 examples, 26 leaves
delta(8, make_sandwich_no_gluten(_, _, _), 0.011874485551618272) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(8, make_sandwich_no_gluten(_, _, _), 0.0002408138701162269) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(8, make_sandwich_no_gluten(_, _, _), -0.027615324054216874) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(8, make_sandwich_no_gluten(_, _, _), 0.10267074642566658) :- !.
delta(8, make_sandwich(_, Bread_portion, _), -0.005593140997279765) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(8, make_sandwich(_, _, _), 0.13632926341819274) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(8, make_sandwich(_, _, _), -0.009817964015090818) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(8, make_sandwich(_, _, _), 0.00353013183225699) :- goal_served(Child), done_served(Child), !.
delta(8, make_sandwich(_, _, _), -0.10022375430330425) :- !.
delta(8, put_on_tray(Sandwich, _), 0.16773284894562487) :- no_gluten_sandwich(Sandwich), !.
delta(8, put_on_tray(_, _), 0.03749375849068397) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(8, put_on_tray(_, _), -0.07280680318153322) :- !.
delta(8, serve_sandwich_no_gluten(_, Child, _, _), 0.002545488954635703) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(8, serve_sandwich_no_gluten(_, Child, _, _), 0.40397302386079836) :- todo_served(Child), !.
delta(8, serve_sandwich_no_gluten(_, _, _, _), -0.38724338773621236) :- !.
delta(8, serve_sandwich(_, Child, _, _), -0.01921552231496798) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(8, serve_sandwich(_, Child, _, _), 0.42281122835085) :- todo_served(Child), !.
delta(8, serve_sandwich(_, _, _, _), -0.14513153645245505) :- !.
delta(8, move_tray(_, Place, Place2), -0.17863168444565225) :- fewer_ontray_2_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), at(Tray2, Place), could_serve_sandwich(Tray2, Place), !.
delta(8, move_tray(_, Place, Place2), 0.1494805518948728) :- fewer_ontray_2_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(8, move_tray(_, _, _), -0.5218349401372345) :- fewer_ontray_2_than_todo_served, !.
delta(8, move_tray(_, _, Place), -0.010152940788709779) :- todo_served(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(8, move_tray(_, _, Place), 0.23359478751311172) :- todo_served(Child), waiting(Child, Place), !.
delta(8, move_tray(_, _, _), 0.00044017582758718726) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(8, move_tray(_, _, _), -0.13795360793236558) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 211 examples, 25 leaves
delta(9, make_sandwich_no_gluten(_, _, _), 0.008239822752295964) :- goal_served(Child), not_allergic_gluten(Child), no_gluten_sandwich(_), !.
delta(9, make_sandwich_no_gluten(_, _, _), 0.00019370751543902246) :- goal_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(9, make_sandwich_no_gluten(_, _, _), -0.11748135389285524) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(9, make_sandwich_no_gluten(_, _, _), 0.06876666234890884) :- !.
delta(9, make_sandwich(_, _, _), -0.22744684637278215) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(9, make_sandwich(_, _, _), 0.0034736453149641715) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(9, make_sandwich(_, _, _), -0.005889628411753671) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(9, make_sandwich(_, _, _), 0.059473901651919195) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(9, make_sandwich(_, _, _), -0.009982790076935496) :- !.
delta(9, put_on_tray(Sandwich, _), 0.1381279193122012) :- no_gluten_sandwich(Sandwich), !.
delta(9, put_on_tray(_, _), 0.026427967985164575) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(9, put_on_tray(_, _), -0.044763850832879) :- !.
delta(9, serve_sandwich_no_gluten(_, Child, _, _), 0.2681661855429211) :- todo_served(Child), !.
delta(9, serve_sandwich_no_gluten(_, _, _, _), -0.25493872968658926) :- !.
delta(9, serve_sandwich(Sandwich, Child, _, Place), -0.010331431514548666) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(9, serve_sandwich(_, Child, _, _), 0.46785273727447363) :- todo_served(Child), !.
delta(9, serve_sandwich(_, _, _, _), -0.1471547272583615) :- !.
delta(9, move_tray(Tray, Place, Place2), 0.003952999025015653) :- done_served(Child), waiting(Child, Place), done_served(Child2), allergic_gluten(Child2), could_put_on_tray(Tray, Place2), !.
delta(9, move_tray(_, Place, _), -0.010217015205155213) :- done_served(Child), waiting(Child, Place), done_served(Child2), allergic_gluten(Child2), !.
delta(9, move_tray(_, Place, _), -0.00012822013925947417) :- done_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(9, move_tray(_, Place, _), 0.19407935147924474) :- done_served(Child), waiting(Child, Place), !.
delta(9, move_tray(Tray, Place, Place2), 0.005204579973706839) :- at(Tray2, Place2), could_put_on_tray(Tray2, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(9, move_tray(_, Place, Place2), -0.0027478351097646628) :- at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(9, move_tray(_, _, _), -0.32382030665053024) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 206 examples, 25 leaves
delta(10, make_sandwich_no_gluten(_, _, _), -0.05473413192381223) :- done_served(Child), not_allergic_gluten(Child), !.
delta(10, make_sandwich_no_gluten(_, _, _), 0.06651616545426653) :- !.
delta(10, make_sandwich(_, _, _), -0.013265052687820205) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(10, make_sandwich(_, _, _), 0.048673547212844434) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(10, make_sandwich(_, _, _), -0.06837080705646638) :- !.
delta(10, put_on_tray(_, Tray), 0.061909042524808285) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(10, put_on_tray(_, Tray), 0.024821271360495476) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(10, put_on_tray(_, Tray), -0.36816543319699085) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(10, put_on_tray(Sandwich, _), 0.3125778412373245) :- no_gluten_sandwich(Sandwich), !.
delta(10, put_on_tray(_, _), -0.04854779283733866) :- todo_served(Child), allergic_gluten(Child), !.
delta(10, put_on_tray(_, _), 0.0035596217260978344) :- !.
delta(10, serve_sandwich_no_gluten(_, Child, _, _), 0.18065945708905906) :- todo_served(Child), !.
delta(10, serve_sandwich_no_gluten(_, _, _, _), -0.16501088460302776) :- !.
delta(10, serve_sandwich(Sandwich, Child, _, Place), -0.006973225587987606) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(10, serve_sandwich(_, Child, _, _), 0.1439277968912312) :- todo_served(Child), no_gluten_sandwich(_), !.
delta(10, serve_sandwich(_, Child, _, _), 0.013846703103084163) :- todo_served(Child), !.
delta(10, serve_sandwich(_, _, _, _), -0.06367859795063713) :- !.
delta(10, move_tray(_, Place, Place2), -0.08275741718408701) :- fewer_at_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), at(Tray2, Place), could_serve_sandwich(Tray2, Place), !.
delta(10, move_tray(_, Place, Place2), 0.08975274937324071) :- fewer_at_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(10, move_tray(_, _, _), -0.24074664331061651) :- fewer_at_1_than_todo_served, !.
delta(10, move_tray(_, _, Place), -0.009334800969692685) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(10, move_tray(_, _, Place), 0.20797049128190104) :- todo_served(Child), waiting(Child, Place), !.
delta(10, move_tray(_, Place, _), -0.14839747227144434) :- at(Tray, Place), ontray(_, Tray), !.
delta(10, move_tray(_, _, _), 0.060981630989845534) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 203 examples, 27 leaves
delta(11, make_sandwich_no_gluten(_, _, _), 0.058573967421840255) :- !.
delta(11, make_sandwich(_, _, _), -0.16332957273354468) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(11, make_sandwich(_, _, _), -0.0005484626975526277) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(11, make_sandwich(_, _, _), 0.03955395188850001) :- fewer_ontray_1_than_todo_served, !.
delta(11, make_sandwich(_, _, _), -0.02424959728901992) :- !.
delta(11, put_on_tray(_, Tray), 0.04950617942437876) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(11, put_on_tray(_, Tray), -0.19963292132852478) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served, !.
delta(11, put_on_tray(_, Tray), 0.024247225372405916) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(11, put_on_tray(Sandwich, _), 0.0003090571010473445) :- no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, !.
delta(11, put_on_tray(Sandwich, _), 0.17270440746027044) :- no_gluten_sandwich(Sandwich), !.
delta(11, put_on_tray(_, _), -0.03674801186142347) :- todo_served(Child), allergic_gluten(Child), !.
delta(11, put_on_tray(_, _), 0.00602577830602203) :- !.
delta(11, serve_sandwich_no_gluten(_, Child, _, _), 0.11250728296501787) :- todo_served(Child), !.
delta(11, serve_sandwich_no_gluten(_, _, _, _), -0.08798419239714782) :- !.
delta(11, serve_sandwich(Sandwich, Child, _, Place), -0.0026427013310024294) :- todo_served(Child), no_gluten_sandwich(_), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(11, serve_sandwich(_, Child, _, _), 0.10134445028418061) :- todo_served(Child), no_gluten_sandwich(_), !.
delta(11, serve_sandwich(_, Child, _, _), 0.007073307022851295) :- todo_served(Child), !.
delta(11, serve_sandwich(_, _, _, _), -0.05137513939785969) :- !.
delta(11, move_tray(_, _, Place), -0.03923848640784049) :- at_kitchen_bread(_), needed_at_to_serve_sandwich_no_gluten(Place), fewer_ontray_1_than_todo_served, !.
delta(11, move_tray(_, _, Place), 0.024011801947575125) :- at_kitchen_bread(_), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(11, move_tray(_, _, Place), -0.006007491693113053) :- at_kitchen_bread(_), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(11, move_tray(_, _, _), 0.1413660135947852) :- at_kitchen_bread(_), !.
delta(11, move_tray(_, Place, Place2), -0.04336984695770848) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(11, move_tray(_, Place, Place2), 0.08050013674506995) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(11, move_tray(_, Place, _), 0.03950051132162699) :- done_served(Child), waiting(Child, Place), !.
delta(11, move_tray(_, _, _), -0.1818641928156872) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 210 examples, 25 leaves
delta(12, make_sandwich_no_gluten(_, _, _), 0.04569961582082034) :- !.
delta(12, make_sandwich(_, Bread_portion, _), -0.006829109716583334) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(12, make_sandwich(_, _, _), 0.0524017492398209) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(12, make_sandwich(_, _, _), -0.02350078446666265) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(12, make_sandwich(_, _, _), 0.010185287695829258) :- done_served(Child), not_allergic_gluten(Child), !.
delta(12, make_sandwich(_, _, _), -0.08552517063686019) :- !.
delta(12, put_on_tray(_, Tray), 0.0018805365370240807) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(12, put_on_tray(_, Tray), -0.16765688705868284) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(12, put_on_tray(_, Tray), 0.0004501001495451583) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(12, put_on_tray(_, _), -0.0019005645015095227) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(12, put_on_tray(_, _), 0.14526412954064336) :- !.
delta(12, serve_sandwich_no_gluten(_, Child, _, _), 0.06744381543046109) :- todo_served(Child), !.
delta(12, serve_sandwich_no_gluten(_, _, _, _), -0.04858722731441911) :- !.
delta(12, serve_sandwich(Sandwich, Child, _, Place), -0.0048229801580819106) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(12, serve_sandwich(_, Child, _, _), 0.09021095713940293) :- todo_served(Child), !.
delta(12, serve_sandwich(_, _, _, _), -0.7492660766754353) :- !.
delta(12, move_tray(_, Place, _), 0.7419513955177091) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), fewer_at_1_than_not_allergic_gluten, !.
delta(12, move_tray(_, Place, _), -0.0008092176947542515) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(12, move_tray(_, Place, Place2), 0.002343207853507098) :- done_served(Child), not_allergic_gluten(Child), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(12, move_tray(_, _, _), -0.0058782999399385315) :- done_served(Child), not_allergic_gluten(Child), !.
delta(12, move_tray(Tray, _, _), -0.0661689800505208) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(12, move_tray(Tray, _, _), 0.12109612784625334) :- at(Tray, kitchen), !.
delta(12, move_tray(_, Place, Place2), 0.02641664178533576) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(12, move_tray(_, _, _), -0.14459151856339103) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 201 examples, 32 leaves
delta(13, make_sandwich_no_gluten(_, _, _), 0.001506595400517976) :- fewer_at_1_than_todo_served_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(13, make_sandwich_no_gluten(_, _, _), 6.641596320326837e-5) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(13, make_sandwich_no_gluten(_, _, _), -0.021978337954486733) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(13, make_sandwich_no_gluten(_, _, _), 0.05606465832950844) :- !.
delta(13, make_sandwich(_, Bread_portion, _), -0.025981762850056888) :- fewer_at_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(13, make_sandwich(_, _, _), 0.028643333026739555) :- fewer_at_1_than_todo_served, no_gluten_sandwich(_), !.
delta(13, make_sandwich(_, _, _), -0.005897282409964803) :- fewer_at_1_than_todo_served, !.
delta(13, make_sandwich(_, _, _), -0.20762625678851104) :- goal_served(Child), allergic_gluten(Child), !.
delta(13, make_sandwich(_, _, _), 0.0001749954174033075) :- !.
delta(13, put_on_tray(_, _), 0.1968397124874689) :- fewer_ontray_2_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(13, put_on_tray(_, _), -0.0005937946209812914) :- fewer_ontray_2_than_allergic_gluten, !.
delta(13, put_on_tray(_, Tray), 0.09437384549305118) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(13, put_on_tray(_, Tray), -0.048095471001034805) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(13, put_on_tray(_, _), 0.013954675622776413) :- fewer_at_1_than_not_allergic_gluten, !.
delta(13, put_on_tray(_, _), -0.210261959092983) :- !.
delta(13, serve_sandwich_no_gluten(_, Child, _, _), 0.0035407821377185875) :- todo_served(Child), at_kitchen_bread(_), fewer_ontray_1_than_todo_served, !.
delta(13, serve_sandwich_no_gluten(_, Child, _, _), -0.030839341976613022) :- todo_served(Child), at_kitchen_bread(_), !.
delta(13, serve_sandwich_no_gluten(_, Child, _, _), 0.05374996967262508) :- todo_served(Child), !.
delta(13, serve_sandwich_no_gluten(_, _, _, _), -0.042261847919051077) :- !.
delta(13, serve_sandwich(Sandwich, Child, _, Place), -0.00285309923476095) :- todo_served(Child), no_gluten_bread(_), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(13, serve_sandwich(_, Child, _, _), 0.12413810359676498) :- todo_served(Child), no_gluten_bread(_), !.
delta(13, serve_sandwich(_, Child, _, _), 3.608914608721143e-5) :- todo_served(Child), fewer_ontray_2_than_todo_served, !.
delta(13, serve_sandwich(_, Child, _, _), 0.0345674747018228) :- todo_served(Child), !.
delta(13, serve_sandwich(_, _, _, _), -0.371947265963966) :- !.
delta(13, move_tray(_, Place, Place2), -0.024102721207144226) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(13, move_tray(_, Place, Place2), 0.04100928777959266) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(13, move_tray(_, _, _), -0.18682665347683483) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(13, move_tray(_, _, _), -0.00836208249539445) :- fewer_ontray_2_than_allergic_gluten, !.
delta(13, move_tray(_, Place, _), -0.1115218901507441) :- todo_served(Child), waiting(Child, Place), !.
delta(13, move_tray(_, _, Place), -0.01898393936071028) :- at(Tray, Place), ontray(_, Tray), !.
delta(13, move_tray(_, _, _), 0.5040042618097077) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 214 examples, 34 leaves
delta(14, make_sandwich_no_gluten(_, _, _), 0.00020166941791427694) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(14, make_sandwich_no_gluten(_, _, _), 5.488577064310752e-5) :- fewer_at_1_than_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(14, make_sandwich_no_gluten(_, _, _), -0.021565702677040135) :- fewer_at_1_than_not_allergic_gluten, !.
delta(14, make_sandwich_no_gluten(_, _, _), 0.04092754293450166) :- !.
delta(14, make_sandwich(_, _, _), -0.029867989811341908) :- fewer_ontray_1_than_todo_served, at_kitchen_sandwich(_), !.
delta(14, make_sandwich(_, _, _), -0.01477638884184329) :- fewer_ontray_1_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(14, make_sandwich(_, _, _), 0.12755525365895357) :- fewer_ontray_1_than_todo_served, !.
delta(14, make_sandwich(_, _, _), -0.14424392892162843) :- !.
delta(14, put_on_tray(_, Tray), 0.1641220707782902) :- ontray(_, Tray), todo_served(Child), not_allergic_gluten(Child), !.
delta(14, put_on_tray(_, Tray), -0.013379784644365303) :- ontray(_, Tray), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(14, put_on_tray(_, Tray), 0.005086127316061545) :- ontray(_, Tray), !.
delta(14, put_on_tray(Sandwich, _), 0.016424320142285908) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(14, put_on_tray(_, _), -0.0026414453624547048) :- fewer_ontray_1_than_allergic_gluten, !.
delta(14, put_on_tray(_, _), -0.18929942579009582) :- fewer_at_2_than_todo_served, !.
delta(14, put_on_tray(_, _), 0.0010012955962111622) :- !.
delta(14, serve_sandwich_no_gluten(_, Child, _, _), 0.04812140672314423) :- todo_served(Child), !.
delta(14, serve_sandwich_no_gluten(_, _, _, _), -0.03746342864889333) :- !.
delta(14, serve_sandwich(_, Child, Tray, _), 0.04672442151038444) :- done_served(Child2), not_allergic_gluten(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place), todo_served(Child), !.
delta(14, serve_sandwich(_, _, Tray, _), -0.042754086946218406) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(14, serve_sandwich(_, _, Tray, _), 0.0034927096015311175) :- done_served(Child), not_allergic_gluten(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(14, serve_sandwich(_, _, _, _), -0.5586935187902106) :- done_served(Child), not_allergic_gluten(Child), !.
delta(14, serve_sandwich(_, _, _, _), -0.0031633993597003337) :- no_gluten_bread(_), todo_served(Child), allergic_gluten(Child), !.
delta(14, serve_sandwich(_, _, _, _), 0.07541149531291615) :- no_gluten_bread(_), !.
delta(14, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_bread(_), !.
delta(14, serve_sandwich(_, _, _, _), 0.003938802370970657) :- !.
delta(14, move_tray(Tray, kitchen, _), -0.0010025799638243512) :- goal_served(Child), done_served(Child), ontray(_, Tray), !.
delta(14, move_tray(Tray, _, _), 0.7556005633728436) :- goal_served(Child), done_served(Child), ontray(_, Tray), !.
delta(14, move_tray(_, Place, Place2), 0.0038344795430630264) :- goal_served(Child), done_served(Child), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(14, move_tray(_, _, _), -0.02509628116122466) :- goal_served(Child), done_served(Child), !.
delta(14, move_tray(_, Place, Place2), 0.03703821082382203) :- fewer_at_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(14, move_tray(_, _, _), -0.19712540291751254) :- fewer_at_1_than_todo_served, !.
delta(14, move_tray(Tray, _, _), 0.10266058918284754) :- at(Tray, kitchen), !.
delta(14, move_tray(_, _, _), -0.04433984814328252) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 207 examples, 28 leaves
delta(15, make_sandwich_no_gluten(_, _, _), 0.030306339148223088) :- !.
delta(15, make_sandwich(_, _, _), -0.018018743930879943) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_allergic_gluten, !.
delta(15, make_sandwich(_, Bread_portion, _), -0.0073979991955088935) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), !.
delta(15, make_sandwich(_, _, _), 0.04553893978546318) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(15, make_sandwich(_, _, _), -0.10629519971331017) :- !.
delta(15, put_on_tray(Sandwich, _), 0.042540726120119485) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(15, put_on_tray(_, _), -0.0051926286069081855) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(15, put_on_tray(_, _), 0.003364248177729392) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(15, put_on_tray(_, _), 0.0008169912344669019) :- fewer_at_1_than_not_allergic_gluten, !.
delta(15, put_on_tray(_, _), -0.12901892871582643) :- !.
delta(15, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- at_kitchen_bread(_), at_kitchen_sandwich(_), !.
delta(15, serve_sandwich_no_gluten(_, _, _, _), 0.0014276227961936047) :- at_kitchen_bread(_), !.
delta(15, serve_sandwich_no_gluten(_, _, _, _), 0.00018447968941430741) :- done_served(Child), allergic_gluten(Child), !.
delta(15, serve_sandwich_no_gluten(_, _, _, _), 0.013573192593392668) :- !.
delta(15, serve_sandwich(_, _, _, _), -0.003725876155538807) :- fewer_ontray_1_than_todo_served, no_gluten_bread(_), todo_served(Child), allergic_gluten(Child), !.
delta(15, serve_sandwich(_, _, _, _), 0.022475023318448004) :- fewer_ontray_1_than_todo_served, no_gluten_bread(_), !.
delta(15, serve_sandwich(_, _, _, _), -0.5855897589491579) :- fewer_ontray_1_than_todo_served, !.
delta(15, serve_sandwich(_, Child, _, _), 0.001864056834753711) :- todo_served(Child), fewer_ontray_2_than_todo_served, !.
delta(15, serve_sandwich(_, Child, _, _), 0.04178498292103317) :- todo_served(Child), !.
delta(15, serve_sandwich(_, _, _, _), -0.02634365048650196) :- !.
delta(15, move_tray(Tray, _, Place), -0.004951629959441073) :- could_serve_sandwich(Tray, Place), at_kitchen_sandwich(_), at_kitchen_bread(_), !.
delta(15, move_tray(Tray, _, Place), 0.7076853855623946) :- could_serve_sandwich(Tray, Place), at_kitchen_sandwich(_), !.
delta(15, move_tray(Tray, _, Place), 0.06034681150264485) :- could_serve_sandwich(Tray, Place), goal_served(Child), done_served(Child), !.
delta(15, move_tray(Tray, _, Place), -0.029486701252468404) :- could_serve_sandwich(Tray, Place), !.
delta(15, move_tray(_, _, _), -0.10399052399823573) :- no_gluten_bread(_), !.
delta(15, move_tray(_, _, Place), -0.002130016353633677) :- goal_served(Child), waiting(Child, Place), !.
delta(15, move_tray(_, _, _), 0.05402249937946013) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 221 examples, 23 leaves
delta(16, make_sandwich_no_gluten(_, _, _), 0.0362110630481781) :- !.
delta(16, make_sandwich(_, _, _), -0.13868714470883992) :- no_gluten_bread(_), !.
delta(16, make_sandwich(_, _, _), 0.003277759360323987) :- !.
delta(16, put_on_tray(_, _), -0.001481109827171911) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(16, put_on_tray(_, _), 0.03896322775863456) :- fewer_ontray_2_than_allergic_gluten, !.
delta(16, put_on_tray(_, _), -0.11137547025209248) :- todo_served(Child), not_allergic_gluten(Child), no_gluten_sandwich(_), !.
delta(16, put_on_tray(_, _), 0.0005189532139432217) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(16, put_on_tray(_, _), 0.0034237513674668886) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(16, put_on_tray(_, _), -0.003102603273702325) :- !.
delta(16, serve_sandwich_no_gluten(_, _, _, _), 0.004434133497483778) :- fewer_at_2_than_todo_served, fewer_at_1_than_todo_served, !.
delta(16, serve_sandwich_no_gluten(_, _, _, _), -0.16928951953947202) :- fewer_at_2_than_todo_served, !.
delta(16, serve_sandwich_no_gluten(_, _, _, _), 4.456954632085101e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(16, serve_sandwich_no_gluten(_, _, _, _), 0.0063601360706053685) :- !.
delta(16, serve_sandwich(_, Child, _, _), 0.27138999674544273) :- todo_served(Child), !.
delta(16, serve_sandwich(_, _, _, _), -0.02859571084766362) :- !.
delta(16, move_tray(Tray, _, Place), -0.004513393667482992) :- at(Tray, kitchen), needed_at_to_serve_sandwich_no_gluten(Place), fewer_ontray_2_than_allergic_gluten, !.
delta(16, move_tray(Tray, _, Place), 0.22886826349066575) :- at(Tray, kitchen), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(16, move_tray(Tray, _, _), 0.011220504359825106) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(16, move_tray(Tray, _, _), -0.05513049858394315) :- at(Tray, kitchen), !.
delta(16, move_tray(_, Place, Place2), 0.007929815026624558) :- fewer_at_2_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(16, move_tray(_, _, _), -0.0016997128974640065) :- fewer_at_2_than_allergic_gluten, !.
delta(16, move_tray(_, _, _), -0.23334347141334935) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 237 examples, 32 leaves
delta(17, make_sandwich_no_gluten(_, _, _), 0.0012357473403844972) :- fewer_at_1_than_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(17, make_sandwich_no_gluten(_, _, _), 1.5487651586740878e-5) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(17, make_sandwich_no_gluten(_, _, _), -0.019732126822584753) :- fewer_at_1_than_not_allergic_gluten, !.
delta(17, make_sandwich_no_gluten(_, _, _), 0.028894220996548318) :- !.
delta(17, make_sandwich(_, _, _), -0.07718116795514135) :- at_kitchen_sandwich(_), !.
delta(17, make_sandwich(_, Bread_portion, _), -0.013624846604923684) :- fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(17, make_sandwich(_, _, _), 0.07745861530865945) :- fewer_ontray_1_than_todo_served, !.
delta(17, make_sandwich(_, _, _), -0.04553213224289886) :- !.
delta(17, put_on_tray(_, _), 0.05105970582132096) :- fewer_at_1_than_todo_served, !.
delta(17, put_on_tray(_, _), -0.000513716003392127) :- fewer_ontray_1_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(17, put_on_tray(_, _), 0.018552200766452587) :- fewer_ontray_1_than_allergic_gluten, !.
delta(17, put_on_tray(_, _), -0.09355011846668332) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(17, put_on_tray(_, _), 0.003233392001447766) :- !.
delta(17, serve_sandwich_no_gluten(_, Child, _, _), 0.0) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, todo_served(Child2), not_allergic_gluten(Child2), !.
delta(17, serve_sandwich_no_gluten(_, Child, _, _), 0.0007622970730524585) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(17, serve_sandwich_no_gluten(_, Child, _, _), 0.03900772106955849) :- todo_served(Child), !.
delta(17, serve_sandwich_no_gluten(_, _, _, _), -0.031744250117105265) :- !.
delta(17, serve_sandwich(_, _, _, Place), 0.02988626837226133) :- at_kitchen_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, done_served(Child), waiting(Child, Place), !.
delta(17, serve_sandwich(_, _, _, _), -1.0340958927497566) :- at_kitchen_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(17, serve_sandwich(_, _, _, _), 0.030863898665666238) :- at_kitchen_sandwich(_), !.
delta(17, serve_sandwich(_, Child, _, _), 0.06531307699378912) :- todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(17, serve_sandwich(_, Child, _, _), -0.021551943126449976) :- todo_served(Child), !.
delta(17, serve_sandwich(_, _, _, _), -0.0866029431856221) :- !.
delta(17, move_tray(_, Place, kitchen), 0.023684558236399648) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(17, move_tray(_, Place, _), -0.08419345279180149) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(17, move_tray(_, Place, Place2), 1.0846976059316737) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(17, move_tray(_, _, _), -0.03541059754260523) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(17, move_tray(_, _, Place), 0.03727959800104488) :- todo_served(Child), waiting(Child, Place), at_kitchen_bread(_), !.
delta(17, move_tray(_, _, Place), -0.12156620450790336) :- todo_served(Child), waiting(Child, Place), !.
delta(17, move_tray(_, Place, _), -0.01869682984961878) :- todo_served(Child), waiting(Child, Place), !.
delta(17, move_tray(_, _, _), 0.13242098550104228) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 210 examples, 28 leaves
delta(18, make_sandwich_no_gluten(_, _, _), 0.021781722944380313) :- !.
delta(18, make_sandwich(_, Bread_portion, _), -0.02395220114759617) :- no_gluten_bread(Bread_portion), !.
delta(18, make_sandwich(_, _, _), -0.013549869387815114) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(18, make_sandwich(_, _, _), 0.06578301941925195) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(18, make_sandwich(_, _, _), -0.0010760431585246381) :- !.
delta(18, put_on_tray(_, _), -0.00047087243974169363) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(18, put_on_tray(_, _), 0.014948780407614803) :- fewer_ontray_2_than_allergic_gluten, !.
delta(18, put_on_tray(_, Tray), 0.02069252258604483) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(18, put_on_tray(_, Tray), -0.027724559607114146) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(18, put_on_tray(_, _), -0.7934488625395688) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(18, put_on_tray(_, _), -0.0009736425385207263) :- !.
delta(18, serve_sandwich_no_gluten(_, Child, _, _), 1.3707276463277267e-5) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(18, serve_sandwich_no_gluten(_, Child, _, _), 0.0470614838153894) :- todo_served(Child), !.
delta(18, serve_sandwich_no_gluten(_, _, _, _), -0.042717697046344524) :- !.
delta(18, serve_sandwich(_, _, _, _), 0.10937893008549965) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(18, serve_sandwich(_, _, _, Place), -0.061044967011625526) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(18, serve_sandwich(_, _, _, Place), 0.01740984020626868) :- done_served(Child), waiting(Child, Place), !.
delta(18, serve_sandwich(_, _, _, _), 0.0012141492264702374) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(18, serve_sandwich(_, _, _, _), 0.014895368274102375) :- !.
delta(18, move_tray(Tray, Place, Place2), -0.00514957501407781) :- at(Tray2, Place), could_put_on_tray(Tray2, Place), could_serve_sandwich(Tray, Place2), at_kitchen_bread(_), !.
delta(18, move_tray(Tray, Place, Place2), 0.8078047080341126) :- at(Tray2, Place), could_put_on_tray(Tray2, Place), could_serve_sandwich(Tray, Place2), !.
delta(18, move_tray(_, Place, _), -0.012636065535569452) :- at(Tray, Place), could_put_on_tray(Tray, Place), fewer_ontray_2_than_todo_served, !.
delta(18, move_tray(_, Place, _), 0.0011525594722191443) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(18, move_tray(Tray, _, Place), -0.02347682186686458) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(18, move_tray(Tray, _, Place), 0.10522870578039502) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(18, move_tray(_, Place, _), 0.04448592918702662) :- done_served(Child), waiting(Child, Place), !.
delta(18, move_tray(_, _, _), -0.2437543517251105) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 215 examples, 29 leaves
delta(19, make_sandwich_no_gluten(_, _, _), 0.02453277876651351) :- !.
delta(19, make_sandwich(_, _, _), -0.08403532038100223) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(19, make_sandwich(_, Bread_portion, _), -0.016893529912942344) :- no_gluten_bread(Bread_portion), !.
delta(19, make_sandwich(_, _, _), 0.10546102168845033) :- fewer_at_1_than_todo_served, !.
delta(19, make_sandwich(_, _, _), -0.006650599732242169) :- !.
delta(19, put_on_tray(_, _), 0.004789436951764663) :- at_kitchen_bread(_), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(19, put_on_tray(_, _), -0.034970942608259746) :- at_kitchen_bread(_), todo_served(Child), allergic_gluten(Child), !.
delta(19, put_on_tray(_, _), 0.0031279678157338686) :- at_kitchen_bread(_), !.
delta(19, put_on_tray(_, _), 0.05481302823383566) :- fewer_ontray_1_than_todo_served, !.
delta(19, put_on_tray(_, _), -0.016459033648973075) :- !.
delta(19, serve_sandwich_no_gluten(_, _, _, _), 0.0010506879595874586) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(19, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(19, serve_sandwich_no_gluten(_, _, _, _), 8.196419008657893e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(19, serve_sandwich_no_gluten(_, _, _, _), 0.00995830933094869) :- !.
delta(19, serve_sandwich(_, _, _, _), -0.3977336217407636) :- fewer_ontray_1_than_todo_served, goal_served(Child), done_served(Child), !.
delta(19, serve_sandwich(_, _, _, _), -0.001030521669770536) :- fewer_ontray_1_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(19, serve_sandwich(_, _, _, _), 0.0001615715508649045) :- fewer_ontray_1_than_todo_served, !.
delta(19, serve_sandwich(_, Child, _, Place), 0.11429500753488929) :- todo_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(19, serve_sandwich(_, Child, _, _), 0.005537631240605528) :- todo_served(Child), !.
delta(19, serve_sandwich(_, _, _, _), -0.028770273522183355) :- !.
delta(19, move_tray(_, Place, Place2), 0.021978907035338804) :- at_kitchen_sandwich(_), fewer_ontray_1_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(19, move_tray(_, _, _), -0.05208401808638822) :- at_kitchen_sandwich(_), fewer_ontray_1_than_allergic_gluten, !.
delta(19, move_tray(_, _, _), 0.40470636448798475) :- at_kitchen_sandwich(_), fewer_at_2_than_todo_served, !.
delta(19, move_tray(_, _, _), -0.0015903373171887013) :- at_kitchen_sandwich(_), !.
delta(19, move_tray(_, _, _), 0.014168018061192715) :- fewer_at_1_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(19, move_tray(_, _, _), -0.0027399375031363156) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(19, move_tray(_, _, Place), 7.311440276437034e-5) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(19, move_tray(_, _, _), -0.180811904417289) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 208 examples, 25 leaves
delta(20, make_sandwich_no_gluten(_, _, _), 0.02561456732341465) :- !.
delta(20, make_sandwich(_, _, _), -0.00047348272689245677) :- done_served(Child), not_allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(20, make_sandwich(_, _, _), 0.033111588462421064) :- done_served(Child), not_allergic_gluten(Child), !.
delta(20, make_sandwich(_, _, _), -0.05775934896104572) :- todo_served(Child), allergic_gluten(Child), !.
delta(20, make_sandwich(_, _, _), -0.014110527717558967) :- at_kitchen_sandwich(_), !.
delta(20, make_sandwich(_, _, _), 0.0028464423946660323) :- !.
delta(20, put_on_tray(_, _), -0.0017573281486173275) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(20, put_on_tray(_, _), 0.10034078890732406) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(20, put_on_tray(_, _), -0.049729953003969166) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(20, put_on_tray(Sandwich, _), 0.0033956501636500454) :- no_gluten_sandwich(Sandwich), !.
delta(20, put_on_tray(_, _), -0.0019129285285362113) :- !.
delta(20, serve_sandwich_no_gluten(_, _, _, _), 0.00405053690027863) :- !.
delta(20, serve_sandwich(_, _, _, _), 0.11155984953068802) :- at_kitchen_sandwich(_), !.
delta(20, serve_sandwich(_, _, _, Place), -0.07329411702944105) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(20, serve_sandwich(_, _, _, Place), 0.0010115962797355082) :- done_served(Child), waiting(Child, Place), !.
delta(20, serve_sandwich(_, _, _, _), -0.0005117572157974701) :- todo_served(Child), allergic_gluten(Child), !.
delta(20, serve_sandwich(_, _, _, _), 0.008623144126289862) :- !.
delta(20, move_tray(_, _, _), -0.21803706720946886) :- fewer_ontray_1_than_todo_served, fewer_no_gluten_sandwich_than_todo_served, !.
delta(20, move_tray(_, _, Place), -0.0017548009750629145) :- fewer_ontray_1_than_todo_served, allergic_gluten(Child), waiting(Child, Place), !.
delta(20, move_tray(_, _, _), 0.047705551945036825) :- fewer_ontray_1_than_todo_served, !.
delta(20, move_tray(_, _, Place), 0.0024489737940184032) :- done_served(Child), waiting(Child, Place), goal_served(Child2), allergic_gluten(Child2), !.
delta(20, move_tray(_, _, Place), -0.07181474120861094) :- done_served(Child), waiting(Child, Place), !.
delta(20, move_tray(_, _, Place), 0.18936120900985498) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(20, move_tray(_, _, _), -0.04476934379635624) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 206 examples, 28 leaves
delta(21, make_sandwich_no_gluten(_, _, _), 0.0161414765348641) :- !.
delta(21, make_sandwich(_, _, _), -0.038305453281859844) :- no_gluten_bread(_), !.
delta(21, make_sandwich(_, _, _), 0.03498400636922024) :- !.
delta(21, put_on_tray(_, Tray), 0.003396226884025941) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served_not_allergic_gluten, ontray(_, Tray), !.
delta(21, put_on_tray(_, _), -0.04267713246203718) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(21, put_on_tray(Sandwich, _), 0.014267999728276543) :- at_kitchen_sandwich(Sandwich2), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), !.
delta(21, put_on_tray(_, _), -0.004227557284742359) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(21, put_on_tray(_, _), 0.0012853422904056514) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(21, put_on_tray(_, _), -0.015318886361825544) :- done_served(Child), not_allergic_gluten(Child), !.
delta(21, put_on_tray(_, _), 0.12410068100435058) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(21, put_on_tray(_, _), -0.0035728403505151073) :- !.
delta(21, serve_sandwich_no_gluten(_, _, _, _), 0.0038115316036411023) :- fewer_ontray_2_than_todo_served, !.
delta(21, serve_sandwich_no_gluten(_, _, _, _), -0.062438274687046325) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(21, serve_sandwich_no_gluten(_, Child, _, _), 0.03724650872150262) :- todo_served(Child), !.
delta(21, serve_sandwich_no_gluten(_, _, _, _), -0.036392461730253296) :- !.
delta(21, serve_sandwich(_, Child, _, _), 0.08492566342317397) :- todo_served(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(21, serve_sandwich(_, Child, _, _), 0.005847307787675145) :- todo_served(Child), fewer_ontray_2_than_todo_served, !.
delta(21, serve_sandwich(_, Child, _, _), 0.04376478818760805) :- todo_served(Child), !.
delta(21, serve_sandwich(_, _, _, _), -0.028935666041213393) :- !.
delta(21, move_tray(_, _, Place), 0.12159807385298792) :- needed_at_to_serve_sandwich_no_gluten(Place), fewer_at_2_than_todo_served, at_kitchen_sandwich(_), !.
delta(21, move_tray(_, _, Place), -0.03300307528477105) :- needed_at_to_serve_sandwich_no_gluten(Place), fewer_at_2_than_todo_served, !.
delta(21, move_tray(_, _, Place), -0.09443576131501576) :- needed_at_to_serve_sandwich_no_gluten(Place), at_kitchen_sandwich(_), !.
delta(21, move_tray(_, _, Place), 0.0050331099617274356) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(21, move_tray(_, Place, _), -0.20793071670423538) :- fewer_at_2_than_todo_served, at(Tray, Place), ontray(_, Tray), !.
delta(21, move_tray(_, _, _), 0.001437246582487471) :- fewer_at_2_than_todo_served, !.
delta(21, move_tray(_, Place, Place2), 0.08739392484683463) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(21, move_tray(_, _, _), -0.04615071955394292) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 201 examples, 23 leaves
delta(22, make_sandwich_no_gluten(_, _, _), 0.012370663009122073) :- !.
delta(22, make_sandwich(_, _, _), -0.05737420795355563) :- todo_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, !.
delta(22, make_sandwich(_, _, _), -0.004020979797529186) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(22, make_sandwich(_, _, _), 0.003927180910896613) :- todo_served(Child), allergic_gluten(Child), !.
delta(22, make_sandwich(_, _, _), 0.005580633348315787) :- !.
delta(22, put_on_tray(_, _), 0.06531683521556542) :- !.
delta(22, serve_sandwich_no_gluten(_, _, _, _), 2.539010796183843e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(22, serve_sandwich_no_gluten(_, _, _, _), 0.006328543069925816) :- !.
delta(22, serve_sandwich(_, _, _, _), 0.0017711403298182786) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(22, serve_sandwich(_, _, _, _), -0.4693733319435304) :- at_kitchen_bread(_), !.
delta(22, serve_sandwich(_, Child, _, _), 0.19714854470655147) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(22, serve_sandwich(_, _, _, _), -0.021961055703627157) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(22, serve_sandwich(_, _, _, _), -0.003229970069155924) :- todo_served(Child), allergic_gluten(Child), !.
delta(22, serve_sandwich(_, _, _, _), 0.002124142154733836) :- !.
delta(22, move_tray(_, _, kitchen), 0.02952022039096221) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(22, move_tray(_, _, _), -0.025655997165089234) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(22, move_tray(Tray, _, Place), 0.4818223294157292) :- at_kitchen_bread(_), could_serve_sandwich(Tray, Place), !.
delta(22, move_tray(_, _, _), -0.0031930899660594057) :- at_kitchen_bread(_), !.
delta(22, move_tray(_, Place, _), -0.23646030851638547) :- at(Tray, Place), ontray(_, Tray), fewer_ontray_2_than_todo_served, !.
delta(22, move_tray(_, Place, _), -0.005897037040897648) :- at(Tray, Place), ontray(_, Tray), !.
delta(22, move_tray(_, Place, Place2), 0.019014489716701735) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(22, move_tray(_, _, _), -0.008531667129843686) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 203 examples, 27 leaves
delta(23, make_sandwich_no_gluten(_, _, _), 0.009973975632940625) :- !.
delta(23, make_sandwich(_, _, _), -0.03713675104620941) :- at_kitchen_sandwich(_), !.
delta(23, make_sandwich(_, _, _), 0.0002780227703390037) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(23, make_sandwich(_, _, _), -0.011697452955619593) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(23, make_sandwich(_, _, _), 0.017575232611967775) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(23, make_sandwich(_, _, _), -0.000912894875353088) :- !.
delta(23, put_on_tray(_, _), 0.0008985623959056239) :- fewer_no_gluten_sandwich_than_todo_served, goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(23, put_on_tray(_, _), -0.014956446867719594) :- fewer_no_gluten_sandwich_than_todo_served, goal_served(Child), done_served(Child), !.
delta(23, put_on_tray(_, Tray), 0.07842373916907476) :- fewer_no_gluten_sandwich_than_todo_served, ontray(_, Tray), !.
delta(23, put_on_tray(_, _), -0.010560344934020542) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(23, put_on_tray(Sandwich, _), 0.015139619997562834) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(23, put_on_tray(_, _), -0.003207253974466793) :- fewer_ontray_1_than_allergic_gluten, !.
delta(23, put_on_tray(_, _), -0.06360740098816263) :- !.
delta(23, serve_sandwich_no_gluten(_, _, _, _), -0.05926776106531191) :- at_kitchen_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(23, serve_sandwich_no_gluten(_, _, _, _), 0.0013508874545835915) :- at_kitchen_sandwich(_), !.
delta(23, serve_sandwich_no_gluten(_, Child, _, _), 0.023806024062654217) :- todo_served(Child), !.
delta(23, serve_sandwich_no_gluten(_, _, _, _), -0.021803749053058017) :- !.
delta(23, serve_sandwich(_, Child, _, _), 0.06690753388772476) :- todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(23, serve_sandwich(_, Child, _, _), 0.011005030072707877) :- todo_served(Child), at_kitchen_sandwich(_), !.
delta(23, serve_sandwich(_, Child, _, _), 9.832283209141985e-6) :- todo_served(Child), !.
delta(23, serve_sandwich(_, _, _, _), -0.008040133261054589) :- !.
delta(23, move_tray(_, _, _), -0.10165702852509766) :- fewer_at_1_than_not_allergic_gluten, !.
delta(23, move_tray(_, _, _), -0.016698536499683357) :- at_kitchen_sandwich(_), fewer_ontray_1_than_allergic_gluten, !.
delta(23, move_tray(_, _, _), 0.1326322542647525) :- at_kitchen_sandwich(_), !.
delta(23, move_tray(_, _, Place), 0.001146032196443559) :- done_served(Child), waiting(Child, Place), !.
delta(23, move_tray(_, _, _), -0.02529607672170966) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 214 examples, 24 leaves
delta(24, make_sandwich_no_gluten(_, _, _), 0.0005471240768874225) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(24, make_sandwich_no_gluten(_, _, _), -0.017102683954226414) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(24, make_sandwich_no_gluten(_, _, _), 0.009533861872838322) :- !.
delta(24, make_sandwich(_, Bread_portion, _), -0.004336723406906157) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), !.
delta(24, make_sandwich(_, _, _), 0.023960138490841647) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_2_than_todo_served, !.
delta(24, make_sandwich(_, _, _), -0.0028878362607427763) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(24, make_sandwich(_, _, _), 0.00022440129610302344) :- done_served(Child), not_allergic_gluten(Child), !.
delta(24, make_sandwich(_, _, _), -0.08431596456165483) :- !.
delta(24, put_on_tray(_, _), -0.0025391992508428185) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(24, put_on_tray(_, _), 0.04912247550460532) :- !.
delta(24, serve_sandwich_no_gluten(_, _, _, _), 0.006993454238409877) :- !.
delta(24, serve_sandwich(_, _, _, _), 0.000898510218590791) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), !.
delta(24, serve_sandwich(_, _, _, _), 0.0693141673637443) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(24, serve_sandwich(_, _, _, _), 0.025734417060566655) :- notexist(_), fewer_ontray_2_than_todo_served, !.
delta(24, serve_sandwich(_, _, _, _), 4.87475488448761e-5) :- notexist(_), !.
delta(24, serve_sandwich(_, _, _, Place), -0.08056535494820961) :- done_served(Child), waiting(Child, Place), !.
delta(24, serve_sandwich(_, _, _, _), 0.0028701347535252672) :- !.
delta(24, move_tray(_, Place, Place2), 0.026791297860347972) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(24, move_tray(_, _, _), -0.12447364835752248) :- fewer_ontray_1_than_todo_served, !.
delta(24, move_tray(_, _, Place), -0.055743343826506614) :- done_served(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(24, move_tray(_, _, Place), 0.0014866672391372824) :- done_served(Child), waiting(Child, Place), !.
delta(24, move_tray(_, _, _), 0.16374115282782623) :- goal_served(Child), done_served(Child), !.
delta(24, move_tray(_, _, _), -0.00595123463463959) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 211 examples, 28 leaves
delta(25, make_sandwich_no_gluten(_, _, _), -0.06580699459808052) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(25, make_sandwich_no_gluten(_, _, _), 0.006233583100492118) :- !.
delta(25, make_sandwich(_, _, _), -0.006529792867371957) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(25, make_sandwich(_, _, _), 0.016245620821338836) :- at_kitchen_sandwich(_), !.
delta(25, make_sandwich(_, Bread_portion, _), -0.0040148660324265785) :- at_kitchen_bread(Bread_portion2), no_gluten_bread(Bread_portion2), no_gluten_bread(Bread_portion), !.
delta(25, make_sandwich(_, _, _), 0.008330450095775713) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(25, make_sandwich(_, _, _), 0.0003380473756283263) :- fewer_ontray_2_than_allergic_gluten, !.
delta(25, make_sandwich(_, _, _), -0.11101860587806714) :- !.
delta(25, put_on_tray(_, _), 3.580923244830269e-5) :- done_served(Child), allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(25, put_on_tray(_, _), -0.010970661026269292) :- done_served(Child), allergic_gluten(Child), !.
delta(25, put_on_tray(_, _), 0.09146491617740087) :- no_gluten_sandwich(_), !.
delta(25, put_on_tray(_, Tray), 0.009973114002053519) :- ontray(_, Tray), !.
delta(25, put_on_tray(_, _), -0.011032433761080873) :- !.
delta(25, serve_sandwich_no_gluten(_, _, _, _), 0.0030531432463706365) :- !.
delta(25, serve_sandwich(_, Child, _, _), 1.5063339267676964e-5) :- fewer_no_gluten_sandwich_than_todo_served, todo_served(Child), done_served(Child2), allergic_gluten(Child2), !.
delta(25, serve_sandwich(_, Child, _, _), 0.08928489410504035) :- fewer_no_gluten_sandwich_than_todo_served, todo_served(Child), !.
delta(25, serve_sandwich(_, _, _, _), -0.012974764815444262) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(25, serve_sandwich(_, _, _, _), 5.136923984492303e-5) :- fewer_at_2_than_todo_served, !.
delta(25, serve_sandwich(_, _, _, _), 0.0007754186288729212) :- goal_served(Child), done_served(Child), !.
delta(25, serve_sandwich(_, _, _, _), -0.3609145724275973) :- !.
delta(25, move_tray(_, Place, Place2), -0.01481496777625324) :- at(_, Place2), goal_served(Child), waiting(Child, Place), !.
delta(25, move_tray(_, _, Place), -0.0034991128182591687) :- at(_, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(25, move_tray(_, _, Place), 0.4153105938553716) :- at(_, Place), !.
delta(25, move_tray(_, _, _), 0.002195964346961501) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(25, move_tray(_, _, _), -0.13796836018459396) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(25, move_tray(Tray, _, Place), 0.05271681607266373) :- could_serve_sandwich(Tray, Place), !.
delta(25, move_tray(_, _, _), -0.05319191652551831) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 210 examples, 25 leaves
delta(26, make_sandwich_no_gluten(_, _, _), 3.2711341013724385e-5) :- fewer_at_1_than_not_allergic_gluten, !.
delta(26, make_sandwich_no_gluten(_, _, _), 0.009497278635680156) :- !.
delta(26, make_sandwich(_, _, _), 0.003535990261107854) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), no_gluten_sandwich(_), !.
delta(26, make_sandwich(_, _, _), -0.0033017054525562102) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(26, make_sandwich(_, _, _), 0.0) :- fewer_at_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(26, make_sandwich(_, _, _), 0.08609617023500966) :- fewer_at_1_than_not_allergic_gluten, !.
delta(26, make_sandwich(_, _, _), -0.013303902931396208) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(26, make_sandwich(_, _, _), 0.004053834241158848) :- fewer_ontray_1_than_todo_served, !.
delta(26, make_sandwich(_, _, _), -0.004038218632620912) :- !.
delta(26, put_on_tray(_, Tray), -0.02167798759789651) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(26, put_on_tray(_, Tray), 0.011011180336902227) :- ontray(_, Tray), !.
delta(26, put_on_tray(_, _), -0.0013628855313054288) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(26, put_on_tray(_, _), -0.0007245975355254555) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(26, put_on_tray(_, _), 0.02972565296822806) :- !.
delta(26, serve_sandwich_no_gluten(_, _, _, _), 0.0035438564294108005) :- !.
delta(26, serve_sandwich(Sandwich, _, _, _), 0.0002840293821371332) :- no_gluten_sandwich(Sandwich), goal_served(Child), done_served(Child), !.
delta(26, serve_sandwich(Sandwich, _, _, _), -0.3938198878810069) :- no_gluten_sandwich(Sandwich), !.
delta(26, serve_sandwich(_, _, _, _), 0.0019496125153485844) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(26, serve_sandwich(_, _, _, _), 0.21443736062810104) :- at_kitchen_sandwich(_), !.
delta(26, serve_sandwich(_, _, _, _), -0.09230039620152575) :- fewer_ontray_2_than_todo_served, !.
delta(26, serve_sandwich(_, _, _, _), 0.005544657152302212) :- !.
delta(26, move_tray(Tray, _, Place), -0.01804154498428776) :- could_serve_sandwich(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(26, move_tray(Tray, _, Place), 0.3701251582424059) :- could_serve_sandwich(Tray, Place), !.
delta(26, move_tray(_, _, _), -0.07781640393029086) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 207 examples, 21 leaves
delta(27, make_sandwich_no_gluten(_, _, _), 0.00746687282607992) :- !.
delta(27, make_sandwich(_, Bread_portion, _), -0.0076694945457913485) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_bread(Bread_portion), !.
delta(27, make_sandwich(_, _, _), 0.030736265921262496) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(27, make_sandwich(_, _, _), -0.0011389572304692601) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(27, make_sandwich(_, _, _), -0.018143656107218475) :- at_kitchen_sandwich(_), !.
delta(27, make_sandwich(_, _, _), -0.0030902293949708025) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(27, make_sandwich(_, _, _), 0.0035357002886157946) :- !.
delta(27, put_on_tray(_, _), 0.00011255213999865206) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), fewer_at_1_than_todo_served, !.
delta(27, put_on_tray(_, _), -0.00042786469308971206) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(27, put_on_tray(_, _), 0.05251645755395992) :- !.
delta(27, serve_sandwich_no_gluten(_, _, _, _), 0.004445101513419503) :- !.
delta(27, serve_sandwich(_, Child, _, _), 0.0002663781212641816) :- todo_served(Child), fewer_ontray_2_than_todo_served, notexist(_), !.
delta(27, serve_sandwich(_, Child, _, _), 0.0031982686013070326) :- todo_served(Child), fewer_ontray_2_than_todo_served, !.
delta(27, serve_sandwich(_, Child, _, _), 0.019057216309013473) :- todo_served(Child), !.
delta(27, serve_sandwich(_, _, _, _), -0.00861841593488731) :- !.
delta(27, move_tray(Tray, Place, Place2), -7.946058848791023e-5) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), todo_served(Child), not_allergic_gluten(Child), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(27, move_tray(_, Place, Place2), 0.025720971103186864) :- at(Tray, Place), could_put_on_tray(Tray, Place2), todo_served(Child), not_allergic_gluten(Child), !.
delta(27, move_tray(_, Place, Place2), 0.00048463730450415627) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_allergic_gluten, !.
delta(27, move_tray(_, Place, Place2), -0.014689135475804466) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(27, move_tray(_, _, _), -0.08976430967324167) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 232 examples, 28 leaves
delta(28, make_sandwich_no_gluten(_, _, _), 0.000426443786819399) :- fewer_at_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(28, make_sandwich_no_gluten(_, _, _), 3.8371992502981835e-6) :- fewer_at_1_than_not_allergic_gluten, !.
delta(28, make_sandwich_no_gluten(_, _, _), 0.005130846588066251) :- !.
delta(28, make_sandwich(_, _, _), -0.010706366444184922) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(28, make_sandwich(_, _, _), 0.006585188701579697) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(28, make_sandwich(_, _, _), 5.748571597471391e-5) :- goal_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, !.
delta(28, make_sandwich(_, _, _), -0.09497799590681125) :- goal_served(Child), allergic_gluten(Child), !.
delta(28, make_sandwich(_, _, _), 0.07349769959851525) :- !.
delta(28, put_on_tray(_, _), -0.014139887454419306) :- fewer_ontray_1_than_todo_served, done_served(Child), not_allergic_gluten(Child), notexist(_), !.
delta(28, put_on_tray(_, _), 0.005832355365353615) :- fewer_ontray_1_than_todo_served, done_served(Child), not_allergic_gluten(Child), !.
delta(28, put_on_tray(_, _), -0.0004155289311585703) :- fewer_ontray_1_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(28, put_on_tray(_, _), 0.05922018689447459) :- fewer_ontray_1_than_todo_served, !.
delta(28, put_on_tray(_, _), -0.008627180487951166) :- !.
delta(28, serve_sandwich_no_gluten(_, _, _, Place), 9.307639944394485e-5) :- done_served(Child), waiting(Child, Place), !.
delta(28, serve_sandwich_no_gluten(_, _, _, _), 0.012393664284283472) :- !.
delta(28, serve_sandwich(_, _, _, _), 0.0007120928097151049) :- fewer_ontray_1_than_todo_served, goal_served(Child), done_served(Child), !.
delta(28, serve_sandwich(_, _, _, _), -0.4420070664949532) :- fewer_ontray_1_than_todo_served, !.
delta(28, serve_sandwich(_, _, _, _), -0.08536119278241448) :- todo_served(Child), allergic_gluten(Child), !.
delta(28, serve_sandwich(_, Child, _, _), 0.025855574457975827) :- todo_served(Child), !.
delta(28, serve_sandwich(_, _, _, _), -0.0073455546627323775) :- !.
delta(28, move_tray(Tray, _, _), -0.09038146523805785) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(28, move_tray(Tray, _, Place), 0.028139400470958233) :- at(Tray, kitchen), todo_served(Child), waiting(Child, Place), !.
delta(28, move_tray(Tray, _, _), -0.0038082433216350565) :- at(Tray, kitchen), !.
delta(28, move_tray(_, _, _), -0.027568380162023686) :- notexist(_), done_served(Child), not_allergic_gluten(Child), !.
delta(28, move_tray(_, _, _), 0.5332417107944719) :- notexist(_), !.
delta(28, move_tray(_, _, Place), 0.03362393434196718) :- done_served(Child), waiting(Child, Place), !.
delta(28, move_tray(_, _, _), -0.043624431088550686) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 213 examples, 25 leaves
delta(29, make_sandwich_no_gluten(_, _, _), 0.004345882187357442) :- !.
delta(29, make_sandwich(_, Bread_portion, _), -0.003340852824372082) :- fewer_at_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(29, make_sandwich(_, _, _), -0.001047855383625656) :- fewer_at_1_than_todo_served, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(29, make_sandwich(_, _, _), 0.023939987821264924) :- fewer_at_1_than_todo_served, !.
delta(29, make_sandwich(_, _, _), 0.0003321692648140379) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(29, make_sandwich(_, _, _), -0.00625456192297492) :- !.
delta(29, put_on_tray(_, Tray), 0.036688932527252416) :- fewer_ontray_1_than_todo_served, ontray(_, Tray), !.
delta(29, put_on_tray(Sandwich, _), 0.0033903769938792142) :- fewer_ontray_1_than_todo_served, no_gluten_sandwich(Sandwich), !.
delta(29, put_on_tray(_, _), -0.0056654991776515316) :- fewer_ontray_1_than_todo_served, !.
delta(29, put_on_tray(_, _), 0.001234108912477994) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(29, put_on_tray(_, _), -0.01624299463383831) :- !.
delta(29, serve_sandwich_no_gluten(_, _, _, _), 0.0004713762951043524) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(29, serve_sandwich_no_gluten(_, _, _, _), -0.13051620117012616) :- !.
delta(29, serve_sandwich(_, _, _, Place), -0.06969434034670945) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), !.
delta(29, serve_sandwich(_, _, _, Place), 0.006677730171197487) :- done_served(Child), waiting(Child, Place), !.
delta(29, serve_sandwich(_, _, _, _), -0.0014982211612580114) :- goal_served(Child), allergic_gluten(Child), todo_served(Child), !.
delta(29, serve_sandwich(_, _, _, _), 0.0) :- goal_served(Child), allergic_gluten(Child), !.
delta(29, serve_sandwich(_, _, _, _), 0.03943535651526941) :- !.
delta(29, move_tray(Tray, Place, _), 0.1599300062857796) :- done_served(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(29, move_tray(_, Place, _), -0.0017264581308815729) :- done_served(Child), waiting(Child, Place), !.
delta(29, move_tray(_, _, Place), 0.02447288871431354) :- at(Tray, Place), could_put_on_tray(Tray, Place), todo_served(Child), not_allergic_gluten(Child), !.
delta(29, move_tray(_, _, Place), -0.0030517224821784133) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(29, move_tray(_, _, _), -0.09996035421213954) :- fewer_ontray_1_than_todo_served, !.
delta(29, move_tray(_, _, _), 0.012752994001244838) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 247 examples, 25 leaves
delta(30, make_sandwich_no_gluten(_, _, _), 0.0061500055337537825) :- !.
delta(30, make_sandwich(_, _, _), -0.004478373808935806) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(30, make_sandwich(_, _, _), 0.046311903017656676) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_todo_served, !.
delta(30, make_sandwich(_, _, _), -0.010019689962020855) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(30, make_sandwich(_, _, _), -0.0018962183845343936) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(30, make_sandwich(_, _, _), -0.11416141347413394) :- !.
delta(30, put_on_tray(_, Tray), 0.10783508933158774) :- fewer_ontray_1_than_todo_served, ontray(_, Tray), !.
delta(30, put_on_tray(_, _), 0.001128562760572968) :- fewer_ontray_1_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(30, put_on_tray(_, _), -0.005334088678686869) :- fewer_ontray_1_than_todo_served, !.
delta(30, put_on_tray(_, _), -0.008595534574996328) :- !.
delta(30, serve_sandwich_no_gluten(_, Child, _, _), 0.02077239354747469) :- todo_served(Child), !.
delta(30, serve_sandwich_no_gluten(_, _, _, _), -0.0179335453998506) :- !.
delta(30, serve_sandwich(_, _, _, _), -0.17372506385437606) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(30, serve_sandwich(_, _, _, _), -0.0006491154391157077) :- fewer_ontray_2_than_allergic_gluten, !.
delta(30, serve_sandwich(_, Child, _, _), 0.0018395183468154345) :- todo_served(Child), done_served(Child2), allergic_gluten(Child2), !.
delta(30, serve_sandwich(_, Child, _, _), 0.0663880178188713) :- todo_served(Child), !.
delta(30, serve_sandwich(_, _, _, _), -0.009893061184221445) :- !.
delta(30, move_tray(_, _, Place), -0.07097296045466644) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(30, move_tray(_, _, Place), -0.009394832880094931) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(30, move_tray(_, _, Place), 0.025025483635579944) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(30, move_tray(_, _, _), 0.16746119323579253) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, no_gluten_bread(_), !.
delta(30, move_tray(_, _, _), -0.0004198450061775962) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(30, move_tray(Tray, _, Place), 0.008654077423757133) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(30, move_tray(_, _, _), -0.019515127430890733) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 212 examples, 29 leaves
delta(31, make_sandwich_no_gluten(_, _, _), 0.0028201732482283585) :- no_gluten_sandwich(_), !.
delta(31, make_sandwich_no_gluten(_, _, _), 2.6357539945633267e-5) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(31, make_sandwich_no_gluten(_, _, _), 0.0006654379772712419) :- !.
delta(31, make_sandwich(_, _, _), -0.07235794955047611) :- at_kitchen_sandwich(_), !.
delta(31, make_sandwich(_, _, _), 0.00042967181189359935) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(31, make_sandwich(_, _, _), -0.005017876226245169) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(31, make_sandwich(_, Bread_portion, _), -0.0012736603482503236) :- no_gluten_bread(Bread_portion), !.
delta(31, make_sandwich(_, _, _), 0.004014735525090168) :- !.
delta(31, put_on_tray(_, Tray), 0.06303182742890998) :- ontray(_, Tray), fewer_ontray_1_than_todo_served, !.
delta(31, put_on_tray(_, Tray), -0.006518943172011864) :- ontray(_, Tray), !.
delta(31, put_on_tray(_, _), -0.019178434367367554) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(31, put_on_tray(_, _), -5.8061929296710674e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(31, put_on_tray(_, _), 0.01219308083343394) :- !.
delta(31, serve_sandwich_no_gluten(_, _, _, _), 1.6188261266294428e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(31, serve_sandwich_no_gluten(_, _, _, _), 0.00133585809833169) :- !.
delta(31, serve_sandwich(_, _, _, _), -0.109094364969552) :- todo_served(Child), allergic_gluten(Child), !.
delta(31, serve_sandwich(_, Child, _, _), 0.002980959923054121) :- goal_served(Child2), allergic_gluten(Child2), todo_served(Child), !.
delta(31, serve_sandwich(_, _, _, _), -0.007778208196643735) :- goal_served(Child), allergic_gluten(Child), !.
delta(31, serve_sandwich(_, Child, _, _), 0.0481998096295063) :- todo_served(Child), !.
delta(31, serve_sandwich(_, _, _, _), -0.0069761658469519134) :- !.
delta(31, move_tray(Tray, _, Place), 0.007510713559528931) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), allergic_gluten(Child2), could_serve_sandwich(Tray, Place), !.
delta(31, move_tray(_, _, Place), -0.001150863398274122) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), allergic_gluten(Child2), !.
delta(31, move_tray(_, _, Place), -0.06822828791500585) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(31, move_tray(_, _, Place), 0.00019662519919539582) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(31, move_tray(Tray, _, _), -0.0047758989793535815) :- notexist(_), at(Tray, kitchen), !.
delta(31, move_tray(_, _, _), 0.16070192913072492) :- notexist(_), !.
delta(31, move_tray(Tray, _, Place), 0.0010172167159592177) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(31, move_tray(_, _, _), -0.025083072473302326) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 202 examples, 27 leaves
delta(32, make_sandwich_no_gluten(_, _, _), 0.003969644336515479) :- !.
delta(32, make_sandwich(_, _, _), -0.04036611349637495) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(32, make_sandwich(_, _, _), -0.0002788634532169426) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(32, make_sandwich(_, _, _), 0.02083725715293849) :- fewer_ontray_1_than_todo_served, !.
delta(32, make_sandwich(_, _, _), -0.0026788558130961663) :- !.
delta(32, put_on_tray(_, _), 0.0343773339855256) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(32, put_on_tray(Sandwich, _), 0.0032346208418053924) :- no_gluten_sandwich(_), no_gluten_sandwich(Sandwich), !.
delta(32, put_on_tray(_, _), -0.004182328981031634) :- no_gluten_sandwich(_), !.
delta(32, put_on_tray(_, Tray), 0.002631232146581931) :- ontray(_, Tray), !.
delta(32, put_on_tray(_, _), -0.014387920585367775) :- at_kitchen_bread(_), !.
delta(32, put_on_tray(_, _), 0.00016123579100363775) :- !.
delta(32, serve_sandwich_no_gluten(_, Child, _, _), 1.1823811545801489e-5) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(32, serve_sandwich_no_gluten(_, Child, _, _), 0.02719591693950867) :- todo_served(Child), !.
delta(32, serve_sandwich_no_gluten(_, _, _, _), -0.024703293412798137) :- !.
delta(32, serve_sandwich(_, _, _, _), 0.021288505463002233) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(32, serve_sandwich(_, _, _, _), -0.25819870957276597) :- at_kitchen_sandwich(_), !.
delta(32, serve_sandwich(_, Child, _, _), 0.009673193138196612) :- todo_served(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(32, serve_sandwich(_, Child, _, _), 0.0003802073838594298) :- todo_served(Child), !.
delta(32, serve_sandwich(_, _, _, _), -0.007325127614996301) :- !.
delta(32, move_tray(_, _, Place), -0.06463017311271653) :- not_allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(32, move_tray(_, _, Place), -0.011481428473991896) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child), !.
delta(32, move_tray(_, _, Place), 0.021170701182299693) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(32, move_tray(_, Place, _), -0.018265292105863043) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child), !.
delta(32, move_tray(_, Place, _), 0.2957299982573125) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(32, move_tray(_, _, _), -0.023004220934298505) :- goal_served(Child), done_served(Child), !.
delta(32, move_tray(_, _, _), 0.0026964010794071447) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 223 examples, 30 leaves
delta(33, make_sandwich_no_gluten(_, _, _), 0.00021599996466456216) :- fewer_at_1_than_todo_served_not_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(33, make_sandwich_no_gluten(_, _, _), -0.011114876121317535) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(33, make_sandwich_no_gluten(_, _, _), 0.0007472548944191038) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(33, make_sandwich_no_gluten(_, _, _), 0.004095599515825066) :- !.
delta(33, make_sandwich(_, _, _), 0.023376593922414285) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(33, make_sandwich(_, _, _), -0.04785103291496351) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(33, make_sandwich(_, _, _), 0.003533008875568933) :- at_kitchen_sandwich(_), !.
delta(33, make_sandwich(_, Bread_portion, _), -0.0057427299335545854) :- no_gluten_bread(Bread_portion), !.
delta(33, make_sandwich(_, _, Content_portion), -0.0012636025149336874) :- no_gluten_content(Content_portion), !.
delta(33, make_sandwich(_, _, _), 0.041302331014593185) :- !.
delta(33, put_on_tray(_, _), 0.0032789165734742665) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(33, put_on_tray(_, _), -0.011393459741623495) :- fewer_at_1_than_allergic_gluten, !.
delta(33, put_on_tray(_, Tray), 0.045328063472424955) :- ontray(_, Tray), !.
delta(33, put_on_tray(_, _), 0.008921598468263773) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(33, put_on_tray(_, _), -0.013985087596999532) :- !.
delta(33, serve_sandwich_no_gluten(_, _, _, _), 0.0030760002599716) :- !.
delta(33, serve_sandwich(_, _, _, _), 0.03938604964860666) :- at_kitchen_sandwich(_), !.
delta(33, serve_sandwich(_, _, _, Place), 0.006794165950985233) :- done_served(Child), waiting(Child, Place), goal_served(Child2), allergic_gluten(Child2), !.
delta(33, serve_sandwich(_, _, _, Place), -0.05426307965209148) :- done_served(Child), waiting(Child, Place), !.
delta(33, serve_sandwich(_, _, _, _), -0.001753138367932595) :- goal_served(Child), allergic_gluten(Child), !.
delta(33, serve_sandwich(_, _, _, _), 0.0038526614144601488) :- !.
delta(33, move_tray(_, _, Place), 0.1872972325082136) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(33, move_tray(_, _, Place), -0.0004952474511015692) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(33, move_tray(_, _, Place), -0.039422086579522876) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(33, move_tray(_, _, Place), 0.013549075176931043) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(33, move_tray(_, _, _), 0.00011888798261088174) :- fewer_ontray_1_than_todo_served, fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(33, move_tray(_, _, _), -0.21981584805435705) :- fewer_ontray_1_than_todo_served, !.
delta(33, move_tray(Tray, _, Place), 0.04050463807351178) :- could_serve_sandwich(Tray, Place), !.
delta(33, move_tray(_, _, _), -0.021760825720492562) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 263 examples, 29 leaves
delta(34, make_sandwich_no_gluten(_, _, _), 0.005031497938065433) :- !.
delta(34, make_sandwich(_, _, _), -0.00408505410253059) :- at_kitchen_sandwich(_), fewer_ontray_1_than_allergic_gluten, !.
delta(34, make_sandwich(_, _, _), 0.13014992436947906) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(34, make_sandwich(_, _, _), 0.001381429965089027) :- at_kitchen_sandwich(_), !.
delta(34, make_sandwich(_, _, _), -0.008001866429148933) :- no_gluten_bread(_), !.
delta(34, make_sandwich(_, _, _), 0.002113711783157321) :- !.
delta(34, put_on_tray(_, _), -0.013560302333046805) :- done_served(Child), not_allergic_gluten(Child), at_kitchen_bread(_), !.
delta(34, put_on_tray(_, _), 0.000201595466216016) :- done_served(Child), not_allergic_gluten(Child), !.
delta(34, put_on_tray(_, _), 0.044800246642351556) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(34, put_on_tray(Sandwich, _), 0.0020913479609079647) :- no_gluten_sandwich(Sandwich), !.
delta(34, put_on_tray(_, _), -0.009449260578263946) :- !.
delta(34, serve_sandwich_no_gluten(_, Child, _, _), 0.005635511638701137) :- todo_served(Child), !.
delta(34, serve_sandwich_no_gluten(_, _, _, _), -0.09936724621360447) :- !.
delta(34, serve_sandwich(_, _, Tray, Place), 0.012075358905861281) :- at_kitchen_sandwich(_), done_served(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(34, serve_sandwich(_, _, _, Place), -0.0041635570051240505) :- at_kitchen_sandwich(_), done_served(Child), waiting(Child, Place), !.
delta(34, serve_sandwich(_, _, _, _), -0.18840367215309814) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(34, serve_sandwich(_, _, _, _), 0.0014118382167140355) :- at_kitchen_sandwich(_), !.
delta(34, serve_sandwich(_, _, _, _), -0.004396863771731805) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(34, serve_sandwich(_, _, _, _), 0.00029009626591366044) :- fewer_ontray_2_than_allergic_gluten, !.
delta(34, serve_sandwich(_, Child, _, _), 0.01345687242953342) :- todo_served(Child), !.
delta(34, serve_sandwich(_, _, _, _), -0.0018755615475667942) :- !.
delta(34, move_tray(Tray, Place, Place2), -0.0003593321012264489) :- not_allergic_gluten(Child), waiting(Child, Place2), done_served(Child2), not_allergic_gluten(Child2), could_put_on_tray(Tray, Place), !.
delta(34, move_tray(_, _, Place), 0.004316036275122917) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(34, move_tray(_, _, Place), 0.004224397918844819) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place), !.
delta(34, move_tray(_, _, Place), -0.1993003623542471) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(34, move_tray(Tray, _, _), -0.018826536156445625) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(34, move_tray(_, _, _), -0.0010704065365894954) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(34, move_tray(_, _, _), 0.28615692104488605) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 227 examples, 30 leaves
delta(35, make_sandwich_no_gluten(_, _, _), 1.6428589431124074e-17) :- fewer_at_2_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(35, make_sandwich_no_gluten(_, _, _), 0.0014662752231316615) :- fewer_at_2_than_allergic_gluten, !.
delta(35, make_sandwich_no_gluten(_, _, _), -0.25302196485175477) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(35, make_sandwich_no_gluten(_, _, _), 0.0025267110049321992) :- !.
delta(35, make_sandwich(_, _, _), 0.2995447278775152) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), todo_served(Child), not_allergic_gluten(Child), !.
delta(35, make_sandwich(_, _, _), -0.003562301459688905) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(35, make_sandwich(_, _, _), 0.000683186536941759) :- at_kitchen_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(35, make_sandwich(_, _, _), -0.0065428715509691674) :- at_kitchen_sandwich(_), !.
delta(35, make_sandwich(_, _, _), -0.00013854938048378827) :- todo_served(Child), allergic_gluten(Child), !.
delta(35, make_sandwich(_, _, _), 0.026761427943450877) :- !.
delta(35, put_on_tray(_, _), 7.030618698102546e-5) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(35, put_on_tray(_, _), -0.00040822757433208975) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(35, put_on_tray(_, _), 0.028707067997759857) :- !.
delta(35, serve_sandwich_no_gluten(_, _, _, _), 0.00029118976548415764) :- !.
delta(35, serve_sandwich(_, Child, _, Place), 0.0004373162906804154) :- allergic_gluten(Child2), waiting(Child2, Place), done_served(Child3), not_allergic_gluten(Child3), todo_served(Child), !.
delta(35, serve_sandwich(_, _, _, Place), -5.213244551948733e-5) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(35, serve_sandwich(_, _, _, Place), 0.010289738796724021) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(35, serve_sandwich(_, _, _, _), 0.016110975116761298) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(35, serve_sandwich(_, _, _, _), -0.4075501909041598) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(35, serve_sandwich(_, _, _, _), -2.3778495865421815e-5) :- goal_served(Child), done_served(Child), !.
delta(35, serve_sandwich(_, _, _, _), 0.0004181342631576999) :- !.
delta(35, move_tray(Tray, _, Place), 0.44813889977656013) :- done_served(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), fewer_ontray_1_than_not_allergic_gluten, !.
delta(35, move_tray(Tray, _, Place), -0.00023448341280817088) :- done_served(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich(Tray, Place2), !.
delta(35, move_tray(_, Place, Place2), 8.630415175961916e-5) :- done_served(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(35, move_tray(_, _, Place), -0.009090318825674957) :- done_served(Child), waiting(Child, Place), !.
delta(35, move_tray(_, _, _), -0.00035586933615202264) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(35, move_tray(_, _, _), -0.1388585894794384) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(35, move_tray(Tray, _, Place), 0.057508992335129495) :- could_serve_sandwich(Tray, Place), !.
delta(35, move_tray(_, _, _), -0.01288343919466403) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 243 examples, 25 leaves
delta(36, make_sandwich_no_gluten(_, _, _), -0.8383605300758332) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(36, make_sandwich_no_gluten(_, _, _), 0.001076487196687064) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(36, make_sandwich_no_gluten(_, _, _), 0.0030287049451038833) :- !.
delta(36, make_sandwich(_, _, _), -0.002593225299396598) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(36, make_sandwich(_, _, _), 0.8818865871301867) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(36, make_sandwich(_, _, _), -0.0024145224328733813) :- fewer_ontray_2_than_allergic_gluten, !.
delta(36, make_sandwich(_, Bread_portion, _), -0.0025082825655877257) :- fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(36, make_sandwich(_, _, _), 0.020287085952036696) :- fewer_ontray_1_than_todo_served, !.
delta(36, make_sandwich(_, _, _), -0.0063768244787170865) :- !.
delta(36, put_on_tray(_, _), 0.042549532165918655) :- !.
delta(36, serve_sandwich_no_gluten(_, Child, _, _), 0.016506471726961066) :- todo_served(Child), !.
delta(36, serve_sandwich_no_gluten(_, _, _, _), -0.013223414269804529) :- !.
delta(36, serve_sandwich(_, Child, _, _), -0.009202115531572687) :- goal_served(Child2), done_served(Child2), todo_served(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(36, serve_sandwich(_, Child, _, _), 0.056645884410962265) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(36, serve_sandwich(_, _, _, _), -0.010592776951096018) :- goal_served(Child), done_served(Child), !.
delta(36, serve_sandwich(_, _, _, _), -0.20951874878906285) :- at_kitchen_sandwich(_), !.
delta(36, serve_sandwich(_, _, _, _), -0.0020422611575586255) :- todo_served(Child), allergic_gluten(Child), !.
delta(36, serve_sandwich(_, _, _, _), 0.0010086576958393818) :- !.
delta(36, move_tray(_, _, kitchen), 0.2739851715908644) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(36, move_tray(_, _, kitchen), -3.584806285846903e-5) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(36, move_tray(_, _, kitchen), -0.026879232066484803) :- !.
delta(36, move_tray(_, _, _), -0.2366654141373609) :- fewer_ontray_2_than_todo_served, !.
delta(36, move_tray(_, _, Place), 0.007511246611756775) :- todo_served(Child), waiting(Child, Place), !.
delta(36, move_tray(_, _, _), -0.004623887594155965) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 260 examples, 29 leaves
delta(37, make_sandwich_no_gluten(_, _, _), 0.010490795647215856) :- !.
delta(37, make_sandwich(_, _, _), -0.33817914726135634) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(37, make_sandwich(_, _, _), -0.006585014153683723) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(37, make_sandwich(_, _, _), 0.0003241485832471313) :- fewer_ontray_2_than_allergic_gluten, !.
delta(37, make_sandwich(_, _, _), 0.010059024756348494) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(37, make_sandwich(_, _, _), -0.0001394595786889434) :- !.
delta(37, put_on_tray(_, Tray), 0.033903110523389) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(37, put_on_tray(_, Tray), -0.007289893489107793) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(37, put_on_tray(_, _), 1.6101636168162859e-6) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(37, put_on_tray(_, _), -0.037292354515838996) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(37, put_on_tray(_, _), 0.0019674381876635923) :- !.
delta(37, serve_sandwich_no_gluten(_, Child, _, _), 0.015730986032414195) :- todo_served(Child), !.
delta(37, serve_sandwich_no_gluten(_, _, _, _), -0.029454821418418917) :- !.
delta(37, serve_sandwich(_, _, Tray, _), 0.03349658571931581) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(37, serve_sandwich(_, _, Tray, _), 6.201727418713472e-5) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(37, serve_sandwich(_, _, Tray, _), -0.0003546517187037514) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(37, serve_sandwich(_, _, _, _), -0.00038217291340122603) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_bread(_), !.
delta(37, serve_sandwich(_, _, _, _), -0.47929958925231286) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(37, serve_sandwich(_, _, _, _), 0.0031300042791269837) :- goal_served(Child), done_served(Child), !.
delta(37, serve_sandwich(_, _, _, _), 9.852496328897947e-5) :- !.
delta(37, move_tray(_, Place, _), -0.046885326303566455) :- goal_served(Child), waiting(Child, Place), done_served(Child), todo_served(Child2), waiting(Child2, Place), !.
delta(37, move_tray(_, Place, _), 0.05065996598287185) :- goal_served(Child), waiting(Child, Place), done_served(Child), !.
delta(37, move_tray(_, Place, _), 0.7923411800814408) :- goal_served(Child), waiting(Child, Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(37, move_tray(_, Place, _), -0.01801164387703915) :- goal_served(Child), waiting(Child, Place), !.
delta(37, move_tray(_, Place, Place2), 0.01249426829366048) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(37, move_tray(_, _, _), -0.02386160325891598) :- fewer_ontray_1_than_todo_served, !.
delta(37, move_tray(_, _, Place), 0.016754525870776443) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(37, move_tray(_, _, _), -0.008642384453464021) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 209 examples, 27 leaves
delta(38, make_sandwich_no_gluten(_, _, _), -0.0332958389073736) :- goal_served(Child), done_served(Child), !.
delta(38, make_sandwich_no_gluten(_, _, _), 0.006467542505719365) :- !.
delta(38, make_sandwich(_, _, _), -0.023780927265949072) :- at_kitchen_sandwich(_), fewer_at_1_than_todo_served, !.
delta(38, make_sandwich(_, _, _), 0.00070301195495473) :- at_kitchen_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(38, make_sandwich(_, _, _), -1.1759539616926933e-5) :- at_kitchen_sandwich(_), !.
delta(38, make_sandwich(_, _, _), -0.007928650007767027) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(38, make_sandwich(_, _, _), 0.007060463250339464) :- !.
delta(38, put_on_tray(_, _), 0.039269273636832) :- fewer_ontray_1_than_todo_served, !.
delta(38, put_on_tray(_, _), -0.0072016559419931766) :- !.
delta(38, serve_sandwich_no_gluten(_, _, _, _), 0.000974284653904512) :- !.
delta(38, serve_sandwich(_, _, _, _), 0.004683803874129647) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), fewer_ontray_1_than_todo_served, !.
delta(38, serve_sandwich(_, _, _, _), -0.4518954449305454) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(38, serve_sandwich(_, _, _, _), -0.04498537704475805) :- done_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(38, serve_sandwich(_, _, _, _), 0.019824463675683635) :- done_served(Child), not_allergic_gluten(Child), !.
delta(38, serve_sandwich(_, _, Tray, _), -0.0002564777893160481) :- notexist(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(38, serve_sandwich(_, _, _, _), 0.0) :- notexist(_), !.
delta(38, serve_sandwich(_, _, Tray, _), 9.97330830506448e-5) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(38, serve_sandwich(_, _, _, _), 0.005374380656336732) :- !.
delta(38, move_tray(_, _, _), -0.0029863357784778643) :- done_served(Child), not_allergic_gluten(Child), fewer_at_1_than_todo_served, done_served(Child2), allergic_gluten(Child2), !.
delta(38, move_tray(_, _, _), 0.4754887557201353) :- done_served(Child), not_allergic_gluten(Child), fewer_at_1_than_todo_served, !.
delta(38, move_tray(_, Place, Place2), 0.0003676314042219263) :- done_served(Child), not_allergic_gluten(Child), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(38, move_tray(_, _, _), -0.004978776372149901) :- done_served(Child), not_allergic_gluten(Child), !.
delta(38, move_tray(_, Place, Place2), 0.0034664793244401845) :- fewer_ontray_1_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(38, move_tray(_, _, _), -0.03213562063788286) :- fewer_ontray_1_than_todo_served, !.
delta(38, move_tray(Tray, _, Place), 0.009791090878282959) :- could_serve_sandwich(Tray, Place), !.
delta(38, move_tray(_, _, _), -0.0026888491502852813) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 240 examples, 25 leaves
delta(39, make_sandwich_no_gluten(_, _, _), 0.0) :- fewer_at_1_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(39, make_sandwich_no_gluten(_, _, _), 0.0008947994101719871) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(39, make_sandwich_no_gluten(_, _, _), 0.01023931468041112) :- !.
delta(39, make_sandwich(_, _, _), 0.015046075896659355) :- done_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(39, make_sandwich(_, _, _), -0.0015548684207578416) :- done_served(Child), allergic_gluten(Child), !.
delta(39, make_sandwich(_, _, _), -0.023570082551529016) :- !.
delta(39, put_on_tray(_, _), 0.013966921126438693) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(39, put_on_tray(_, _), 0.001282997791192836) :- fewer_at_1_than_not_allergic_gluten, !.
delta(39, put_on_tray(_, _), -0.04532132836662898) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(39, put_on_tray(_, _), 0.001130345941630393) :- !.
delta(39, serve_sandwich_no_gluten(_, _, _, _), 0.005389824900425835) :- !.
delta(39, serve_sandwich(_, _, _, _), 0.015510647908778014) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(39, serve_sandwich(_, _, _, _), -0.44888569057173733) :- at_kitchen_sandwich(_), !.
delta(39, serve_sandwich(_, Child, _, Place), 0.02977927358445618) :- todo_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(39, serve_sandwich(_, Child, _, _), 0.0011400771774313042) :- todo_served(Child), !.
delta(39, serve_sandwich(_, _, _, _), -0.005233780587161942) :- !.
delta(39, move_tray(Tray, _, Place), 0.029656671204756454) :- at_kitchen_sandwich(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(39, move_tray(Tray, _, _), -0.05093469962053523) :- at_kitchen_sandwich(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(39, move_tray(_, _, Place), -0.007550596008833524) :- at_kitchen_sandwich(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(39, move_tray(_, _, _), 0.5447690487619815) :- at_kitchen_sandwich(_), !.
delta(39, move_tray(_, Place, _), -0.029383425770106775) :- done_served(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(39, move_tray(_, Place, _), 0.000631106963401896) :- done_served(Child), waiting(Child, Place), !.
delta(39, move_tray(Tray, _, Place), 0.02724008201485087) :- could_serve_sandwich(Tray, Place), !.
delta(39, move_tray(_, _, _), -0.020672833263381957) :- !.
delta(39, _, 0.0).

% tree 40: step size 1.0, 219 examples, 28 leaves
delta(40, make_sandwich_no_gluten(_, _, _), -0.6670730245981538) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(40, make_sandwich_no_gluten(_, _, _), 0.00109725137756809) :- !.
delta(40, make_sandwich(_, _, Content_portion), -0.0036929121113487193) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_content(Content_portion), !.
delta(40, make_sandwich(_, _, _), -0.0013764850797770996) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(40, make_sandwich(_, _, _), 0.7380622971812734) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(40, make_sandwich(_, _, _), -0.005425540083684432) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(40, make_sandwich(_, _, _), 0.023361241486622216) :- at_kitchen_sandwich(_), !.
delta(40, make_sandwich(_, _, _), -0.018147487739543503) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(40, make_sandwich(_, _, _), 0.010076345465029269) :- !.
delta(40, put_on_tray(_, _), 0.17580799074777712) :- no_gluten_sandwich(_), !.
delta(40, put_on_tray(_, Tray), -0.010108092751883952) :- at_kitchen_bread(_), ontray(_, Tray), !.
delta(40, put_on_tray(_, _), 3.44890121442046e-5) :- at_kitchen_bread(_), !.
delta(40, put_on_tray(_, _), 0.0019226341662970524) :- !.
delta(40, serve_sandwich_no_gluten(_, _, _, _), 0.0009387247540763351) :- !.
delta(40, serve_sandwich(_, Child, _, _), 0.02998401973932655) :- at_kitchen_sandwich(_), goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(40, serve_sandwich(_, _, _, _), -0.014092401935068982) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(40, serve_sandwich(_, _, Tray, _), 0.015020767537482478) :- at_kitchen_sandwich(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(40, serve_sandwich(_, _, _, _), -0.2948945416926307) :- at_kitchen_sandwich(_), !.
delta(40, serve_sandwich(_, _, Tray, _), -0.1592029229561333) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(40, serve_sandwich(_, _, _, _), 0.00034248935020211494) :- fewer_ontray_2_than_allergic_gluten, !.
delta(40, serve_sandwich(_, _, _, _), 0.1849506629174831) :- !.
delta(40, move_tray(_, Place, Place2), 0.00037288148747993075) :- goal_served(Child), done_served(Child), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(40, move_tray(_, _, _), -0.11147999578199778) :- goal_served(Child), done_served(Child), !.
delta(40, move_tray(_, _, Place), 0.0053044779821881756) :- no_gluten_bread(_), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(40, move_tray(_, _, _), -0.037873063712591123) :- no_gluten_bread(_), !.
delta(40, move_tray(_, Place, _), 0.2945983440659978) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(40, move_tray(_, _, _), -0.00448165680004305) :- !.
delta(40, _, 0.0).

% tree 41: step size 1.0, 212 examples, 29 leaves
delta(41, make_sandwich_no_gluten(_, _, _), -0.09701101518320314) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(41, make_sandwich_no_gluten(_, _, _), 0.00026198203421575806) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(41, make_sandwich_no_gluten(_, _, _), -3.5557958231172995e-18) :- fewer_at_1_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(41, make_sandwich_no_gluten(_, _, _), 0.0005946685964190241) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(41, make_sandwich_no_gluten(_, _, _), 0.027379015306188033) :- !.
delta(41, make_sandwich(_, _, _), -0.006145340522955439) :- no_gluten_sandwich(_), fewer_at_2_than_allergic_gluten, !.
delta(41, make_sandwich(_, _, _), 0.08229307758726453) :- no_gluten_sandwich(_), at_kitchen_sandwich(_), !.
delta(41, make_sandwich(_, _, _), -0.0022773518762864734) :- no_gluten_sandwich(_), !.
delta(41, make_sandwich(_, _, _), -0.09329935533325097) :- !.
delta(41, put_on_tray(_, _), 0.11903858859191432) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(41, put_on_tray(_, _), 0.0010287427604709178) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(41, put_on_tray(_, _), -0.0017359730181646714) :- !.
delta(41, serve_sandwich_no_gluten(_, _, _, _), -0.011631328346182416) :- at_kitchen_bread(_), at_kitchen_sandwich(_), !.
delta(41, serve_sandwich_no_gluten(_, _, _, _), 0.00020975128493203624) :- at_kitchen_bread(_), !.
delta(41, serve_sandwich_no_gluten(_, _, _, _), 1.2207077761000181e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(41, serve_sandwich_no_gluten(_, _, _, _), 0.0027851225024268654) :- !.
delta(41, serve_sandwich(_, _, _, _), -0.25261030737941154) :- at_kitchen_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(41, serve_sandwich(_, _, _, _), 0.004896660689867858) :- at_kitchen_sandwich(_), !.
delta(41, serve_sandwich(_, _, _, _), -0.0018135615136698467) :- todo_served(Child), allergic_gluten(Child), !.
delta(41, serve_sandwich(_, Child, _, _), 0.035417054336001896) :- todo_served(Child), !.
delta(41, serve_sandwich(_, _, _, _), -0.0001485267473000328) :- !.
delta(41, move_tray(_, Place, _), 0.30676745565807934) :- at(Tray, Place), could_serve_sandwich(Tray, Place), at_kitchen_sandwich(_), fewer_at_1_than_todo_served, !.
delta(41, move_tray(_, Place, _), -0.005146785628999256) :- at(Tray, Place), could_serve_sandwich(Tray, Place), at_kitchen_sandwich(_), !.
delta(41, move_tray(_, Place, _), -0.031062564242734948) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(41, move_tray(_, Place, Place2), 0.02442038066279216) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), goal_served(Child), waiting(Child, Place), !.
delta(41, move_tray(_, Place, Place2), -0.007276318117104687) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(41, move_tray(Tray, _, _), 0.009621097556907432) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(41, move_tray(_, _, _), -0.09656680845168608) :- !.
delta(41, _, 0.0).

% tree 42: step size 1.0, 207 examples, 28 leaves
delta(42, make_sandwich_no_gluten(_, _, _), 0.005798433957625164) :- fewer_at_2_than_allergic_gluten, !.
delta(42, make_sandwich_no_gluten(_, _, _), 2.198462822647808e-5) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(42, make_sandwich_no_gluten(_, _, _), -0.23735034261327762) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(42, make_sandwich_no_gluten(_, _, _), 0.0013430926527211627) :- !.
delta(42, make_sandwich(_, _, _), 0.0032870412783174412) :- no_gluten_sandwich(_), done_served(Child), not_allergic_gluten(Child), !.
delta(42, make_sandwich(_, _, _), -0.002502787070602493) :- no_gluten_sandwich(_), fewer_ontray_2_than_allergic_gluten, !.
delta(42, make_sandwich(_, _, _), -0.057097643622191836) :- no_gluten_sandwich(_), !.
delta(42, make_sandwich(_, _, _), -0.009416602044302603) :- fewer_at_2_than_allergic_gluten, !.
delta(42, make_sandwich(_, _, Content_portion), -0.001559497675996874) :- no_gluten_content(Content_portion), !.
delta(42, make_sandwich(_, _, _), 0.22401524285826313) :- !.
delta(42, put_on_tray(Sandwich, _), 0.005708585449401804) :- no_gluten_sandwich(Sandwich), !.
delta(42, put_on_tray(_, Tray), 0.009823488453820792) :- ontray(_, Tray), fewer_ontray_1_than_todo_served, !.
delta(42, put_on_tray(_, Tray), -0.006872024870246606) :- ontray(_, Tray), !.
delta(42, put_on_tray(_, _), 0.0010009482148531802) :- goal_served(Child), done_served(Child), !.
delta(42, put_on_tray(_, _), -0.030284093754268944) :- !.
delta(42, serve_sandwich_no_gluten(_, _, _, _), 0.001740102266476372) :- !.
delta(42, serve_sandwich(_, _, Tray, _), -0.07760682153315059) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(42, serve_sandwich(_, _, Tray, _), 0.00023674784092179185) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(42, serve_sandwich(_, Child, _, _), 0.0758328236099701) :- todo_served(Child), !.
delta(42, serve_sandwich(_, _, _, _), -0.003249328490664935) :- !.
delta(42, move_tray(_, _, Place), 0.0007625951179093421) :- not_allergic_gluten(Child), waiting(Child, Place), todo_served(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(42, move_tray(_, _, Place), -0.10996537638903318) :- not_allergic_gluten(Child), waiting(Child, Place), todo_served(Child), !.
delta(42, move_tray(Tray, _, Place), -0.0011776345428110816) :- not_allergic_gluten(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(42, move_tray(_, _, Place), 0.006982987222727589) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(42, move_tray(_, _, _), -0.003391148457738882) :- fewer_ontray_1_than_allergic_gluten, !.
delta(42, move_tray(_, _, _), -0.002308818385337975) :- done_served(Child), not_allergic_gluten(Child), !.
delta(42, move_tray(_, _, _), 0.1251482147335056) :- !.
delta(42, _, 0.0).

% tree 43: step size 1.0, 203 examples, 27 leaves
delta(43, make_sandwich_no_gluten(_, _, _), 0.004311454236861068) :- fewer_at_2_than_allergic_gluten, !.
delta(43, make_sandwich_no_gluten(_, _, _), 0.004616416408862379) :- at_kitchen_sandwich(_), !.
delta(43, make_sandwich_no_gluten(_, _, _), -0.15022795391178925) :- fewer_at_1_than_todo_served, !.
delta(43, make_sandwich_no_gluten(_, _, _), 0.0009097970213916868) :- !.
delta(43, make_sandwich(_, Bread_portion, _), -0.05141991385900045) :- no_gluten_bread(Bread_portion), !.
delta(43, make_sandwich(_, _, Content_portion), -0.03175005790765296) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), no_gluten_content(Content_portion), !.
delta(43, make_sandwich(_, _, _), 0.20540531920778424) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(43, make_sandwich(_, _, _), -0.028957482116198037) :- goal_served(Child), allergic_gluten(Child), !.
delta(43, make_sandwich(_, _, _), 0.0007516304762169375) :- !.
delta(43, put_on_tray(_, _), 0.010589201392769042) :- fewer_ontray_1_than_todo_served, !.
delta(43, put_on_tray(_, _), 0.0013165802795987009) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(43, put_on_tray(_, _), -0.017435410527079916) :- !.
delta(43, serve_sandwich_no_gluten(_, _, _, _), 2.1026630442406367e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(43, serve_sandwich_no_gluten(_, _, _, _), 0.0012605723703990534) :- !.
delta(43, serve_sandwich(_, _, _, Place), -0.12603431852366298) :- fewer_at_1_than_todo_served, done_served(Child), waiting(Child, Place), !.
delta(43, serve_sandwich(_, _, _, _), -0.0004838521335191526) :- fewer_at_1_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(43, serve_sandwich(_, _, _, _), 0.0064432678984356504) :- fewer_at_1_than_todo_served, !.
delta(43, serve_sandwich(_, Child, _, _), 0.02694657543344845) :- todo_served(Child), !.
delta(43, serve_sandwich(_, _, _, _), -0.00010522053634155759) :- !.
delta(43, move_tray(_, _, Place), -0.021207515864627272) :- needed_at_to_serve_sandwich_no_gluten(Place), fewer_ontray_1_than_allergic_gluten, !.
delta(43, move_tray(Tray, _, Place), 0.17863672894886323) :- needed_at_to_serve_sandwich_no_gluten(Place), ontray(_, Tray), !.
delta(43, move_tray(_, _, Place), -0.003858899264620066) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(43, move_tray(_, Place, Place2), -0.00027351121495383256) :- at(Tray, Place2), could_put_on_tray(Tray, Place), todo_served(Child), allergic_gluten(Child), !.
delta(43, move_tray(_, Place, Place2), 0.005078613376077159) :- at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(43, move_tray(_, _, _), 0.0011561546683005667) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(43, move_tray(_, _, _), -0.04907628869585271) :- !.
delta(43, _, 0.0).

% tree 44: step size 1.0, 214 examples, 31 leaves
delta(44, make_sandwich_no_gluten(_, _, _), 0.0021896143091822058) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(44, make_sandwich_no_gluten(_, _, _), 0.025708065023325725) :- fewer_ontray_1_than_allergic_gluten, !.
delta(44, make_sandwich_no_gluten(_, _, _), 2.443780483687005e-5) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(44, make_sandwich_no_gluten(_, _, _), -0.036189356855459216) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(44, make_sandwich_no_gluten(_, _, _), 0.00023075755770117598) :- !.
delta(44, make_sandwich(_, _, _), -0.00043697315013206016) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(44, make_sandwich(_, _, _), -0.029699941786015566) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(44, make_sandwich(_, _, _), 0.006891455575605775) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(44, make_sandwich(_, _, _), -0.028565211799295314) :- done_served(Child), not_allergic_gluten(Child), !.
delta(44, make_sandwich(_, _, _), 0.05503974070729696) :- fewer_ontray_1_than_todo_served, !.
delta(44, make_sandwich(_, _, _), -0.02077227275617359) :- !.
delta(44, put_on_tray(_, _), 0.010567974014972987) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(44, put_on_tray(_, _), 0.0008708679748286839) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(44, put_on_tray(_, _), -0.012902171274679667) :- !.
delta(44, serve_sandwich_no_gluten(_, _, _, _), 0.001749087284670704) :- !.
delta(44, serve_sandwich(_, _, _, _), 0.00808243336838825) :- notexist(_), done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(44, serve_sandwich(_, _, _, _), 0.0) :- notexist(_), done_served(Child), not_allergic_gluten(Child), !.
delta(44, serve_sandwich(_, _, _, Place), 0.0028462092114046682) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(44, serve_sandwich(_, _, _, _), -0.09468632796103851) :- notexist(_), !.
delta(44, serve_sandwich(_, Child, _, Place), 0.0019818877687990907) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(44, serve_sandwich(_, _, _, Place), -0.002318250864670965) :- done_served(Child), waiting(Child, Place), !.
delta(44, serve_sandwich(_, _, _, _), 0.07284547895304685) :- !.
delta(44, move_tray(_, _, _), 0.10736995375275568) :- goal_served(Child), done_served(Child), notexist(_), fewer_ontray_1_than_todo_served, !.
delta(44, move_tray(_, _, _), -0.012240244223911172) :- goal_served(Child), done_served(Child), notexist(_), !.
delta(44, move_tray(Tray, _, _), 0.013845884272024244) :- goal_served(Child), done_served(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(44, move_tray(_, _, _), -0.028718186920000593) :- goal_served(Child), done_served(Child), !.
delta(44, move_tray(_, _, _), -2.6198442551511627e-5) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_allergic_gluten, !.
delta(44, move_tray(_, _, _), -0.08408587957180604) :- fewer_ontray_1_than_todo_served, !.
delta(44, move_tray(Tray, _, Place), 0.041943359378019726) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(44, move_tray(_, _, _), -0.01667087929391362) :- !.
delta(44, _, 0.0).

% tree 45: step size 1.0, 228 examples, 27 leaves
delta(45, make_sandwich_no_gluten(_, _, _), 0.008958474119491093) :- !.
delta(45, make_sandwich(_, _, _), 0.0016514928474426701) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(45, make_sandwich(_, _, _), -0.027541819960957382) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(45, make_sandwich(_, _, _), 0.00028933083311716886) :- fewer_ontray_1_than_todo_served, fewer_ontray_2_than_allergic_gluten, !.
delta(45, make_sandwich(_, _, _), 0.025602656272915737) :- fewer_ontray_1_than_todo_served, !.
delta(45, make_sandwich(_, _, _), -0.00038371911409516027) :- !.
delta(45, put_on_tray(_, _), 0.014068984053141045) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(45, put_on_tray(_, _), -0.00022566343208122903) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_bread(_), !.
delta(45, put_on_tray(_, _), 8.657053829030087e-6) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(45, put_on_tray(_, _), 0.0006907356596545682) :- fewer_at_1_than_todo_served, goal_served(Child), done_served(Child), !.
delta(45, put_on_tray(_, _), -0.019118753466468748) :- fewer_at_1_than_todo_served, !.
delta(45, put_on_tray(_, _), 0.0011937698140748495) :- !.
delta(45, serve_sandwich_no_gluten(_, _, _, _), 0.001227230833653068) :- !.
delta(45, serve_sandwich(_, _, Tray, _), 0.05080303740732176) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(45, serve_sandwich(_, _, _, Place), -0.011295271677475403) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(45, serve_sandwich(_, _, _, _), 0.04523052206818902) :- done_served(Child), not_allergic_gluten(Child), !.
delta(45, serve_sandwich(_, _, _, _), -0.08482097750179039) :- fewer_ontray_1_than_todo_served, !.
delta(45, serve_sandwich(_, _, _, _), 0.0005135264430589535) :- !.
delta(45, move_tray(Tray, _, _), 0.0023988022132803003) :- goal_served(Child), allergic_gluten(Child), at(Tray, Place), waiting(Child, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(45, move_tray(Tray, _, _), -0.016148056778883518) :- goal_served(Child), allergic_gluten(Child), at(Tray, Place), waiting(Child, Place), !.
delta(45, move_tray(_, Place, Place2), -0.003924686807883615) :- goal_served(Child), allergic_gluten(Child), at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(45, move_tray(_, _, _), 0.06918784643410594) :- goal_served(Child), allergic_gluten(Child), !.
delta(45, move_tray(_, Place, Place2), 0.01832893096019137) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(45, move_tray(_, Place, _), -0.01145892514049542) :- done_served(Child), waiting(Child, Place), !.
delta(45, move_tray(_, Place, _), -0.08206011645447896) :- at(Tray, Place), ontray(_, Tray), !.
delta(45, move_tray(_, _, _), 0.007986162413009546) :- !.
delta(45, _, 0.0).

% tree 46: step size 1.0, 227 examples, 27 leaves
delta(46, make_sandwich_no_gluten(_, _, _), -0.04255978446970922) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(46, make_sandwich_no_gluten(_, _, _), 0.0004310830315227067) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(46, make_sandwich_no_gluten(_, _, _), 0.0008176924653360555) :- fewer_ontray_1_than_allergic_gluten, !.
delta(46, make_sandwich_no_gluten(_, _, _), 0.0028493236364763672) :- !.
delta(46, make_sandwich(_, _, Content_portion), -0.02058453784187447) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_content(Content_portion), !.
delta(46, make_sandwich(_, _, _), -0.00662002918701711) :- fewer_ontray_1_than_todo_served_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(46, make_sandwich(_, _, _), 0.34896181927836295) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(46, make_sandwich(_, _, _), 4.47468045175205e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(46, make_sandwich(_, _, _), -0.03545957809930954) :- !.
delta(46, put_on_tray(_, _), 0.046112858379864494) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(46, put_on_tray(_, _), -0.3220088111719531) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(46, put_on_tray(_, _), 0.0003503955512305404) :- fewer_ontray_1_than_allergic_gluten, !.
delta(46, put_on_tray(_, _), 0.02782686187986973) :- !.
delta(46, serve_sandwich_no_gluten(_, _, _, _), 0.00536477591860234) :- !.
delta(46, serve_sandwich(_, _, Tray, _), -0.0054211485210956065) :- fewer_ontray_2_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(46, serve_sandwich(_, _, _, _), 0.002091277691924694) :- fewer_ontray_2_than_allergic_gluten, !.
delta(46, serve_sandwich(_, Child, _, _), -0.0002713202437176737) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(46, serve_sandwich(_, Child, _, _), 0.08523471033031639) :- todo_served(Child), !.
delta(46, serve_sandwich(_, _, _, _), -0.0027198779447123317) :- !.
delta(46, move_tray(_, Place, Place2), -0.008166140294536044) :- allergic_gluten(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(46, move_tray(_, _, Place), 0.05555698989655656) :- allergic_gluten(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place), !.
delta(46, move_tray(_, _, Place), -0.003985571826826722) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(46, move_tray(Tray, _, _), -0.004438393711173021) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(46, move_tray(Tray, _, _), -0.00029105219791464136) :- at(Tray, kitchen), !.
delta(46, move_tray(_, _, _), 7.480463216202508e-5) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(46, move_tray(_, _, _), -0.12145210020993069) :- !.
delta(46, _, 0.0).

% tree 47: step size 1.0, 215 examples, 27 leaves
delta(47, make_sandwich_no_gluten(_, _, _), 0.00424002037271616) :- !.
delta(47, make_sandwich(_, _, _), -0.00042714654484492264) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(47, make_sandwich(_, _, _), 0.30174777935286684) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(47, make_sandwich(_, _, _), -0.00021905413897137775) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(47, make_sandwich(_, Bread_portion, _), -0.03648683275840452) :- no_gluten_bread(Bread_portion), !.
delta(47, make_sandwich(_, _, _), 0.03224630933083685) :- fewer_ontray_1_than_allergic_gluten, !.
delta(47, make_sandwich(_, _, _), -0.018056887714300557) :- !.
delta(47, put_on_tray(_, _), 0.022451954421140553) :- goal_served(Child), done_served(Child), !.
delta(47, put_on_tray(_, _), 0.0019067516698625482) :- todo_served(Child), allergic_gluten(Child), fewer_at_2_than_allergic_gluten, !.
delta(47, put_on_tray(_, _), -0.3088321223612236) :- todo_served(Child), allergic_gluten(Child), !.
delta(47, put_on_tray(_, _), 0.005231801816340522) :- !.
delta(47, serve_sandwich_no_gluten(_, _, _, _), 0.007138185174192623) :- !.
delta(47, serve_sandwich(_, Child, _, _), 0.21852233038817798) :- goal_served(Child2), done_served(Child2), fewer_ontray_1_than_todo_served, todo_served(Child), !.
delta(47, serve_sandwich(_, _, _, _), -0.0010368756692346283) :- goal_served(Child), done_served(Child), fewer_ontray_1_than_todo_served, !.
delta(47, serve_sandwich(_, _, _, Place), 0.05158611811720261) :- goal_served(Child), done_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(47, serve_sandwich(_, _, _, _), 0.0012496515262948916) :- goal_served(Child), done_served(Child), !.
delta(47, serve_sandwich(_, _, _, _), -0.31267999525520124) :- notexist(_), !.
delta(47, serve_sandwich(_, _, _, _), 0.0217721506188625) :- no_gluten_bread(_), !.
delta(47, serve_sandwich(_, _, _, _), 0.0014589844779124212) :- !.
delta(47, move_tray(Tray, _, Place), 0.0027143688833012884) :- goal_served(Child), done_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(47, move_tray(Tray, _, _), -0.0004721042892690746) :- goal_served(Child), done_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(47, move_tray(_, _, _), -0.27184892644945113) :- goal_served(Child), done_served(Child), !.
delta(47, move_tray(Tray, _, _), 0.4015566909421894) :- at(Tray, Place), could_serve_sandwich(Tray, Place), notexist(_), !.
delta(47, move_tray(Tray, _, _), -0.023389333471837425) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(47, move_tray(_, _, Place), 0.0180830537631795) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(47, move_tray(_, _, _), -0.009096149193765505) :- !.
delta(47, _, 0.0).

% tree 48: step size 1.0, 209 examples, 25 leaves
delta(48, make_sandwich_no_gluten(_, _, _), -0.05020020821778918) :- no_gluten_sandwich(_), fewer_no_gluten_sandwich_than_todo_served_allergic_gluten, !.
delta(48, make_sandwich_no_gluten(_, _, _), 0.0013698752078918693) :- no_gluten_sandwich(_), !.
delta(48, make_sandwich_no_gluten(_, _, _), 0.0028314272935962078) :- !.
delta(48, make_sandwich(_, _, _), -0.0055258614658948565) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), fewer_at_2_than_allergic_gluten, !.
delta(48, make_sandwich(_, _, _), -0.00034910759788677365) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(48, make_sandwich(_, _, _), 6.225327291319394e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(48, make_sandwich(_, _, _), 0.05664575825896137) :- !.
delta(48, put_on_tray(Sandwich, _), 0.05599853970777034) :- no_gluten_sandwich(Sandwich), !.
delta(48, put_on_tray(_, _), -0.05139808563148724) :- !.
delta(48, serve_sandwich_no_gluten(_, _, _, _), -0.01041608111648189) :- at_kitchen_bread(_), !.
delta(48, serve_sandwich_no_gluten(_, _, _, _), 0.010509558137958631) :- !.
delta(48, serve_sandwich(_, _, _, _), 5.20799132512735e-5) :- notexist(_), fewer_ontray_1_than_allergic_gluten, !.
delta(48, serve_sandwich(_, _, _, _), -0.3736691666918819) :- notexist(_), !.
delta(48, serve_sandwich(_, _, _, Place), 0.0006560898243873315) :- done_served(Child), waiting(Child, Place), goal_served(Child2), allergic_gluten(Child2), !.
delta(48, serve_sandwich(_, _, _, Place), -0.07095135692089058) :- done_served(Child), waiting(Child, Place), !.
delta(48, serve_sandwich(_, _, _, _), 0.0030278774732723293) :- !.
delta(48, move_tray(Tray, Place, Place2), 0.005397583660133976) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(_, Tray), !.
delta(48, move_tray(_, Place, Place2), -0.0018727142222655976) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(48, move_tray(_, Place, Place2), -0.028649593294987216) :- at(Tray, Place), could_put_on_tray(Tray, Place2), ontray(_, Tray), !.
delta(48, move_tray(_, Place, Place2), 0.00031027415814441285) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(48, move_tray(_, Place, Place2), -0.006130751001966173) :- not_allergic_gluten(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(48, move_tray(_, Place, _), 0.42034636036742334) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(48, move_tray(_, _, _), 0.014650262319449565) :- fewer_ontray_1_than_allergic_gluten, !.
delta(48, move_tray(_, _, _), -0.021050922612580597) :- !.
delta(48, _, 0.0).

% tree 49: step size 1.0, 228 examples, 33 leaves
delta(49, make_sandwich_no_gluten(_, _, _), 0.0006597305806097996) :- fewer_at_1_than_allergic_gluten, !.
delta(49, make_sandwich_no_gluten(_, _, _), -0.33903968367022125) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(49, make_sandwich_no_gluten(_, _, _), 0.0011860054736293653) :- fewer_ontray_1_than_allergic_gluten, !.
delta(49, make_sandwich_no_gluten(_, _, _), 0.004095923955041568) :- !.
delta(49, make_sandwich(_, _, _), -1.6795657604060586e-5) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(49, make_sandwich(_, _, _), -0.01889937747506234) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(49, make_sandwich(_, _, _), 4.936733685869859e-5) :- at_kitchen_sandwich(_), !.
delta(49, make_sandwich(_, _, Content_portion), -0.014079870840644378) :- no_gluten_content(Content_portion), !.
delta(49, make_sandwich(_, _, _), -0.0016751732612135424) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(49, make_sandwich(_, _, _), 0.3963386886377951) :- !.
delta(49, put_on_tray(_, _), 0.005845660193661838) :- fewer_ontray_1_than_todo_served, !.
delta(49, put_on_tray(_, _), -0.000396766537671779) :- !.
delta(49, serve_sandwich_no_gluten(Sandwich, _, _, Place), 0.0019187005811410413) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(49, serve_sandwich_no_gluten(Sandwich, _, _, Place), 0.0006176383837558975) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(49, serve_sandwich_no_gluten(Sandwich, _, _, Place), -0.2938405035086529) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(49, serve_sandwich_no_gluten(_, _, _, Place), 8.631851204585462e-6) :- done_served(Child), waiting(Child, Place), !.
delta(49, serve_sandwich_no_gluten(_, _, _, _), 0.0027290412679549943) :- !.
delta(49, serve_sandwich(_, _, _, _), -0.00777479168972839) :- goal_served(Child), done_served(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(49, serve_sandwich(_, Child, _, _), 0.043731930320243396) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(49, serve_sandwich(_, _, _, _), -0.004965909793316121) :- goal_served(Child), done_served(Child), !.
delta(49, serve_sandwich(_, _, _, _), 0.0008427097513442879) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_bread(_), !.
delta(49, serve_sandwich(_, _, _, _), -0.25907974447037774) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(49, serve_sandwich(_, _, _, _), 0.01809360652236252) :- fewer_ontray_2_than_todo_served, !.
delta(49, serve_sandwich(_, _, _, _), 0.00013963099379159675) :- !.
delta(49, move_tray(Tray, _, Place), -0.028835902972282244) :- could_serve_sandwich(Tray, Place), done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(49, move_tray(Tray, _, Place), 0.0006819612963914354) :- could_serve_sandwich(Tray, Place), done_served(Child), waiting(Child, Place), !.
delta(49, move_tray(Tray, _, Place), -0.0015758559354771646) :- could_serve_sandwich(Tray, Place), at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(49, move_tray(Tray, _, Place), 0.5561954696771005) :- could_serve_sandwich(Tray, Place), !.
delta(49, move_tray(_, Place, _), 0.0365785640965075) :- todo_served(Child), allergic_gluten(Child), not_allergic_gluten(Child2), waiting(Child2, Place), !.
delta(49, move_tray(_, _, _), -0.004914134095503805) :- todo_served(Child), allergic_gluten(Child), !.
delta(49, move_tray(_, _, Place), 0.024038551171819862) :- at(_, Place), !.
delta(49, move_tray(_, _, _), -0.10933118386032653) :- !.
delta(49, _, 0.0).

% tree 50: step size 1.0, 237 examples, 29 leaves
delta(50, make_sandwich_no_gluten(_, _, _), -0.03416918866289905) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(50, make_sandwich_no_gluten(_, _, _), 0.0) :- fewer_at_1_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(50, make_sandwich_no_gluten(_, _, _), 0.0007132191281961179) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(50, make_sandwich_no_gluten(_, _, _), 0.06321201378533807) :- !.
delta(50, make_sandwich(_, _, _), 0.00040057317779517457) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(50, make_sandwich(_, _, _), -0.00024358508132068648) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(50, make_sandwich(_, _, _), -0.11294762783455867) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(50, make_sandwich(_, _, _), -0.0030830388907894073) :- todo_served(Child), allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(50, make_sandwich(_, _, _), 0.019788737400554927) :- todo_served(Child), allergic_gluten(Child), !.
delta(50, make_sandwich(_, _, _), 7.574781249222239e-5) :- !.
delta(50, put_on_tray(_, _), 0.050693983118770394) :- fewer_ontray_1_than_todo_served, !.
delta(50, put_on_tray(_, _), -0.0023726903559006494) :- !.
delta(50, serve_sandwich_no_gluten(_, Child, _, _), 0.005794006171771556) :- todo_served(Child), !.
delta(50, serve_sandwich_no_gluten(_, _, _, _), -0.04077556359950081) :- !.
delta(50, serve_sandwich(Sandwich, Child, _, Place), -0.00020230873892832334) :- no_gluten_bread(_), todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(50, serve_sandwich(_, Child, _, _), 0.06251267244814815) :- no_gluten_bread(_), todo_served(Child), !.
delta(50, serve_sandwich(_, _, _, _), -0.0025503497974084482) :- no_gluten_bread(_), !.
delta(50, serve_sandwich(_, _, _, _), -7.76339657076537e-6) :- notexist(_), !.
delta(50, serve_sandwich(_, _, _, _), -0.04928075094517087) :- goal_served(Child), done_served(Child), !.
delta(50, serve_sandwich(_, _, _, _), 0.0002423493725259952) :- !.
delta(50, move_tray(Tray, _, _), -0.07145541555137563) :- notexist(_), fewer_no_gluten_sandwich_than_todo_served, ontray(_, Tray), !.
delta(50, move_tray(_, _, _), -0.00019876904083974384) :- notexist(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(50, move_tray(_, _, Place), 0.0036991661898562733) :- notexist(_), todo_served(Child), waiting(Child, Place), !.
delta(50, move_tray(_, _, _), -0.0035090408434041475) :- notexist(_), !.
delta(50, move_tray(_, Place, Place2), 0.004710918701539786) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(50, move_tray(_, _, _), -0.008146226739637209) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(50, move_tray(_, _, Place), -0.00045369328532185227) :- at(_, Place), !.
delta(50, move_tray(_, _, _), 0.08608960081565378) :- !.
delta(50, _, 0.0).

% tree 51: step size 1.0, 217 examples, 28 leaves
delta(51, make_sandwich_no_gluten(_, _, _), 0.000162013456067801) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(51, make_sandwich_no_gluten(_, _, _), -0.014228356044014569) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(51, make_sandwich_no_gluten(_, _, _), 0.004201151925972119) :- !.
delta(51, make_sandwich(_, Bread_portion, _), -0.03509358450232839) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), no_gluten_bread(Bread_portion), todo_served(Child), allergic_gluten(Child), !.
delta(51, make_sandwich(_, Bread_portion, _), 0.014233424285976301) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), no_gluten_bread(Bread_portion), !.
delta(51, make_sandwich(_, _, _), 0.03391233779546991) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(51, make_sandwich(_, _, _), -0.0002879640539794926) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(51, make_sandwich(_, _, _), 1.6716530589282296e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(51, make_sandwich(_, _, _), -0.03424505892903445) :- !.
delta(51, put_on_tray(_, _), 0.011569348362163386) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(51, put_on_tray(_, Tray), -0.05721271975232136) :- ontray(_, Tray), fewer_at_1_than_todo_served, !.
delta(51, put_on_tray(_, Tray), 0.010673745801846556) :- ontray(_, Tray), !.
delta(51, put_on_tray(_, _), -0.011302023004058971) :- todo_served(Child), allergic_gluten(Child), !.
delta(51, put_on_tray(_, _), 0.01158760861451612) :- !.
delta(51, serve_sandwich_no_gluten(_, Child, _, _), 0.01620152830313709) :- todo_served(Child), !.
delta(51, serve_sandwich_no_gluten(_, _, _, _), -0.011474197602397901) :- !.
delta(51, serve_sandwich(Sandwich, _, _, Place), -0.0045379825435125495) :- todo_served(Child), allergic_gluten(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(51, serve_sandwich(_, _, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), !.
delta(51, serve_sandwich(_, Child, _, _), 0.06720346404530034) :- todo_served(Child), !.
delta(51, serve_sandwich(_, _, _, _), -0.0012437519448998792) :- !.
delta(51, move_tray(Tray, _, Place), -0.1691667261435547) :- done_served(Child), waiting(Child, Place), ontray(_, Tray), fewer_ontray_1_than_not_allergic_gluten, !.
delta(51, move_tray(Tray, _, Place), 0.011716546366810658) :- done_served(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(51, move_tray(_, _, Place), -0.00019740592670541333) :- done_served(Child), waiting(Child, Place), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(51, move_tray(_, _, Place), 0.02780103757670456) :- done_served(Child), waiting(Child, Place), !.
delta(51, move_tray(_, Place, _), -0.06350638534685742) :- goal_served(Child), waiting(Child, Place), !.
delta(51, move_tray(_, _, _), -0.0013937272641428948) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(51, move_tray(_, _, _), 0.14158796280586797) :- !.
delta(51, _, 0.0).

% tree 52: step size 1.0, 205 examples, 32 leaves
delta(52, make_sandwich_no_gluten(_, _, _), 0.0) :- fewer_at_1_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(52, make_sandwich_no_gluten(_, _, _), 0.0006803439572832254) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(52, make_sandwich_no_gluten(_, _, _), 0.021029178921178733) :- !.
delta(52, make_sandwich(_, _, _), 0.01652901900030721) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(52, make_sandwich(_, _, _), -0.00018076667067524156) :- fewer_at_1_than_allergic_gluten, !.
delta(52, make_sandwich(_, _, _), -0.06753776368296942) :- goal_served(Child), allergic_gluten(Child), !.
delta(52, make_sandwich(_, _, _), 0.012015119432408431) :- !.
delta(52, put_on_tray(_, Tray), 0.0) :- ontray(Sandwich, Tray), done_served(Child), not_allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(52, put_on_tray(_, Tray), 0.0006457154959697696) :- ontray(_, Tray), done_served(Child), not_allergic_gluten(Child), !.
delta(52, put_on_tray(_, Tray), 0.019567534387372167) :- ontray(_, Tray), notexist(_), !.
delta(52, put_on_tray(_, Tray), 3.0399275482198354e-6) :- ontray(_, Tray), !.
delta(52, put_on_tray(_, _), -0.0003523828250500624) :- fewer_ontray_1_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(52, put_on_tray(_, _), 0.006043030173267953) :- fewer_ontray_1_than_allergic_gluten, !.
delta(52, put_on_tray(_, _), -0.018260551953615894) :- fewer_at_1_than_todo_served, !.
delta(52, put_on_tray(_, _), 4.6328795897160346e-5) :- !.
delta(52, serve_sandwich_no_gluten(_, Child, _, _), 0.0024982214371245992) :- todo_served(Child), !.
delta(52, serve_sandwich_no_gluten(_, _, _, _), -0.018022806933534734) :- !.
delta(52, serve_sandwich(_, _, _, _), -0.0011432243689212297) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child), done_served(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(52, serve_sandwich(_, _, _, _), 0.042032659371056866) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(52, serve_sandwich(_, _, _, _), -3.4111982532106543e-5) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(52, serve_sandwich(_, _, _, _), -0.02021659469519247) :- no_gluten_sandwich(_), fewer_ontray_2_than_allergic_gluten, !.
delta(52, serve_sandwich(_, _, _, _), 0.004997160872989245) :- no_gluten_sandwich(_), !.
delta(52, serve_sandwich(_, _, _, _), -0.4390374963776564) :- fewer_ontray_2_than_todo_served, !.
delta(52, serve_sandwich(_, _, _, _), 0.0021453568497292234) :- !.
delta(52, move_tray(_, Place, Place2), 0.014004614750257646) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place2), todo_served(Child2), waiting(Child2, Place), !.
delta(52, move_tray(_, _, Place), -0.0009643239292055103) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(52, move_tray(_, _, _), 0.011468787203699765) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_at_2_than_todo_served_allergic_gluten, !.
delta(52, move_tray(_, _, _), -0.07605121166049995) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(52, move_tray(Tray, Place, Place2), -0.00559417890751921) :- ontray(_, Tray), at(Tray2, Place2), could_serve_sandwich(Tray2, Place), !.
delta(52, move_tray(Tray, _, _), 0.5609025341782508) :- ontray(_, Tray), !.
delta(52, move_tray(_, _, _), -0.012266375355795481) :- !.
delta(52, _, 0.0).

% tree 53: step size 1.0, 214 examples, 27 leaves
delta(53, make_sandwich_no_gluten(_, _, _), 0.05477062389983473) :- !.
delta(53, make_sandwich(_, _, _), -0.06632329872424954) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(53, make_sandwich(_, _, _), 0.00012514124924646277) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(53, make_sandwich(_, _, _), 0.025252106563178278) :- fewer_ontray_1_than_todo_served, !.
delta(53, make_sandwich(_, _, _), -0.001256800219718298) :- !.
delta(53, put_on_tray(_, _), 0.0005704627438001638) :- at_kitchen_bread(_), goal_served(Child), allergic_gluten(Child), !.
delta(53, put_on_tray(_, Tray), -0.01602095386795797) :- at_kitchen_bread(_), ontray(_, Tray), !.
delta(53, put_on_tray(_, _), 2.3081518718529127e-5) :- at_kitchen_bread(_), !.
delta(53, put_on_tray(Sandwich, _), 0.000808771482437899) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(53, put_on_tray(_, _), -0.0007976312685841122) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(53, put_on_tray(_, _), 0.01777442265448497) :- !.
delta(53, serve_sandwich_no_gluten(_, _, _, _), 0.000349529703962046) :- fewer_at_1_than_todo_served, !.
delta(53, serve_sandwich_no_gluten(_, _, _, _), -0.05597265552104133) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(53, serve_sandwich_no_gluten(_, _, _, _), 0.0003330829166189091) :- !.
delta(53, serve_sandwich(_, Child, _, _), 0.0017847399406372305) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, todo_served(Child), !.
delta(53, serve_sandwich(_, _, _, _), -0.001898723250733295) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(53, serve_sandwich(_, Child, _, _), 0.09615823477069316) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(53, serve_sandwich(_, _, _, _), -3.963404550117484e-5) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(53, serve_sandwich(Sandwich, _, _, _), -0.11340053695917658) :- no_gluten_bread(_), no_gluten_sandwich(Sandwich), !.
delta(53, serve_sandwich(_, _, _, _), 0.09431793733435506) :- no_gluten_bread(_), !.
delta(53, serve_sandwich(_, _, _, _), -0.11307165024980971) :- !.
delta(53, move_tray(_, _, Place), 0.017402432423626515) :- fewer_ontray_1_than_todo_served, at(Tray, Place), ontray(_, Tray), !.
delta(53, move_tray(_, _, _), -0.12256852896864687) :- fewer_ontray_1_than_todo_served, !.
delta(53, move_tray(_, _, kitchen), -0.03782197103645247) :- !.
delta(53, move_tray(_, _, _), -0.0155590889632046) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(53, move_tray(_, _, _), 0.20586429795167419) :- !.
delta(53, _, 0.0).

% tree 54: step size 1.0, 207 examples, 26 leaves
delta(54, make_sandwich_no_gluten(_, _, _), 0.003281442216501209) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(54, make_sandwich_no_gluten(_, _, _), 0.05804610588397856) :- !.
delta(54, make_sandwich(_, _, _), -0.1092412256119106) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(54, make_sandwich(_, _, _), 7.749695719337264e-5) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(54, make_sandwich(_, Bread_portion, _), -0.001110181264307623) :- no_gluten_bread(Bread_portion), !.
delta(54, make_sandwich(_, _, _), 0.024356730332965825) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(54, make_sandwich(_, _, _), -0.0003709841159196456) :- !.
delta(54, put_on_tray(_, _), -0.0002440735698517771) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(54, put_on_tray(_, _), 3.88031011654097e-6) :- fewer_ontray_1_than_todo_served, done_served(Child), allergic_gluten(Child), !.
delta(54, put_on_tray(_, _), 0.015174764176647313) :- fewer_ontray_1_than_todo_served, !.
delta(54, put_on_tray(_, _), -0.004132246757141139) :- !.
delta(54, serve_sandwich_no_gluten(_, Child, _, _), 0.007265021797030894) :- todo_served(Child), !.
delta(54, serve_sandwich_no_gluten(_, _, _, _), -0.00621358691011347) :- !.
delta(54, serve_sandwich(_, _, _, _), -0.1888425378808767) :- todo_served(Child), allergic_gluten(Child), !.
delta(54, serve_sandwich(_, _, _, Place), -0.018666315906100555) :- allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(54, serve_sandwich(_, _, _, Place), 0.0006506913755364784) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(54, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_2_than_allergic_gluten, !.
delta(54, serve_sandwich(_, _, _, _), 0.09440737997438334) :- !.
delta(54, move_tray(_, kitchen, _), -0.0013028095171087651) :- at_kitchen_sandwich(_), notexist(_), !.
delta(54, move_tray(_, _, _), 0.21407869720676806) :- at_kitchen_sandwich(_), notexist(_), !.
delta(54, move_tray(_, _, _), -0.011979379430727749) :- at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(54, move_tray(_, _, _), 0.004115572199154482) :- at_kitchen_sandwich(_), !.
delta(54, move_tray(_, Place, Place2), 0.01386772331378747) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place2), !.
delta(54, move_tray(_, Place, _), -0.0008642943013511405) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(54, move_tray(_, _, _), -0.06649107451470491) :- !.
delta(54, _, 0.0).

% tree 55: step size 1.0, 203 examples, 29 leaves
delta(55, make_sandwich_no_gluten(_, _, _), -0.04018887029959902) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(55, make_sandwich_no_gluten(_, _, _), 0.01794068217587927) :- !.
delta(55, make_sandwich(_, _, Content_portion), -0.06954300260587185) :- no_gluten_content(Content_portion), !.
delta(55, make_sandwich(_, _, _), 0.08881798497404016) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(55, make_sandwich(_, _, _), -0.028243487267031315) :- no_gluten_sandwich(_), !.
delta(55, make_sandwich(_, _, _), -0.02666233303529797) :- todo_served(Child), allergic_gluten(Child), !.
delta(55, make_sandwich(_, _, _), 0.000968722508405395) :- !.
delta(55, put_on_tray(_, _), 0.059202178585953) :- fewer_at_2_than_todo_served, !.
delta(55, put_on_tray(_, _), -0.030635037455997185) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(55, put_on_tray(_, _), 0.001113829705727248) :- !.
delta(55, serve_sandwich_no_gluten(Sandwich, _, _, Place), 0.002606336123188756) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(55, serve_sandwich_no_gluten(_, _, _, _), 0.0009190267470377423) :- at_kitchen_bread(_), !.
delta(55, serve_sandwich_no_gluten(_, _, _, _), -0.0032685194952301287) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(55, serve_sandwich_no_gluten(_, _, _, _), 1.8008851990831348e-5) :- !.
delta(55, serve_sandwich(_, _, _, _), -0.3730910478829493) :- notexist(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(55, serve_sandwich(_, Child, _, _), 0.01177273630961452) :- notexist(_), todo_served(Child), !.
delta(55, serve_sandwich(_, _, _, _), -0.0016504905520238556) :- notexist(_), !.
delta(55, serve_sandwich(_, _, _, Place), -6.89543832831801e-5) :- allergic_gluten(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(55, serve_sandwich(_, _, _, Place), 0.00010547390661882008) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(55, serve_sandwich(_, Child, _, _), 0.09130101551446179) :- todo_served(Child), !.
delta(55, serve_sandwich(_, _, _, _), -1.0943730077016478e-5) :- !.
delta(55, move_tray(Tray, _, Place), -0.027231421302453155) :- goal_served(Child), waiting(Child, Place), notexist(_), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(55, move_tray(_, _, Place), 0.47727456985200967) :- goal_served(Child), waiting(Child, Place), notexist(_), !.
delta(55, move_tray(_, _, Place), 0.00015253813012101216) :- goal_served(Child), waiting(Child, Place), done_served(Child2), allergic_gluten(Child2), !.
delta(55, move_tray(_, _, Place), -0.06919242633261866) :- goal_served(Child), waiting(Child, Place), !.
delta(55, move_tray(_, Place, _), -0.1156296954944324) :- goal_served(Child), waiting(Child, Place), !.
delta(55, move_tray(_, Place, Place2), 0.051258667808653256) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(55, move_tray(_, _, _), -0.0012337492442331935) :- !.
delta(55, _, 0.0).

% tree 56: step size 1.0, 205 examples, 20 leaves
delta(56, make_sandwich_no_gluten(_, _, _), 0.001222035404157601) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(56, make_sandwich_no_gluten(_, _, _), 0.01926450239710484) :- !.
delta(56, make_sandwich(_, _, _), -0.043855859673895596) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(56, make_sandwich(_, _, _), -0.00018022879864216723) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(56, make_sandwich(_, _, _), 0.0515648186598826) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(56, make_sandwich(_, _, _), -4.994730415266458e-5) :- !.
delta(56, put_on_tray(Sandwich, _), 0.005196335985636552) :- no_gluten_sandwich(Sandwich), !.
delta(56, put_on_tray(_, _), -0.036869408969609226) :- !.
delta(56, serve_sandwich_no_gluten(_, _, _, _), 0.0003814087463346342) :- !.
delta(56, serve_sandwich(Sandwich, _, _, _), -0.0967935463259317) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(56, serve_sandwich(Sandwich, Child, _, _), 0.010880442607473433) :- no_gluten_sandwich(Sandwich), todo_served(Child), !.
delta(56, serve_sandwich(Sandwich, _, _, _), -4.363348094225284e-5) :- no_gluten_sandwich(Sandwich), !.
delta(56, serve_sandwich(_, Child, _, Place), 0.14091502675369233) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(56, serve_sandwich(_, _, _, Place), -0.0012545076220903735) :- done_served(Child), waiting(Child, Place), !.
delta(56, serve_sandwich(_, _, _, _), 0.01785743128839037) :- done_served(Child), not_allergic_gluten(Child), !.
delta(56, serve_sandwich(_, _, _, _), -0.00417619965734547) :- !.
delta(56, move_tray(_, Place, Place2), 0.010167370533441045) :- at(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(56, move_tray(_, _, Place), 3.400869263804957e-5) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(56, move_tray(_, _, _), -0.1069236413242475) :- !.
delta(56, _, 0.0).

% tree 57: step size 1.0, 206 examples, 30 leaves
delta(57, make_sandwich_no_gluten(_, _, _), 0.0019258129711626627) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(57, make_sandwich_no_gluten(_, _, _), -0.19965158404250566) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(57, make_sandwich_no_gluten(_, _, _), 1.94965394840175e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(57, make_sandwich_no_gluten(_, _, _), 0.0015071694191845044) :- !.
delta(57, make_sandwich(_, Bread_portion, _), -0.01851909937415054) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), no_gluten_bread(Bread_portion), !.
delta(57, make_sandwich(_, _, _), 0.29029698520456054) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), fewer_at_1_than_allergic_gluten, !.
delta(57, make_sandwich(_, _, _), -0.00029907171042905373) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(57, make_sandwich(_, _, _), -0.02717579639846171) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(57, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(_), !.
delta(57, make_sandwich(_, _, _), 1.5594461250294144e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(57, make_sandwich(_, _, _), 0.009983978041621664) :- !.
delta(57, put_on_tray(_, _), 0.014977090758764404) :- fewer_ontray_1_than_todo_served, !.
delta(57, put_on_tray(_, _), -0.0021980897876980755) :- !.
delta(57, serve_sandwich_no_gluten(_, _, _, _), 1.7872942769748473e-5) :- at_kitchen_bread(_), !.
delta(57, serve_sandwich_no_gluten(_, _, _, _), -0.0616747522107276) :- !.
delta(57, serve_sandwich(_, _, Tray, Place), -0.007447027857649565) :- done_served(Child), waiting(Child, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(57, serve_sandwich(_, Child, _, Place), 0.10786827302249898) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(57, serve_sandwich(_, _, _, Place), -0.0017043166341703555) :- done_served(Child), waiting(Child, Place), !.
delta(57, serve_sandwich(_, _, _, _), 0.007001614706655014) :- done_served(Child), allergic_gluten(Child), notexist(_), !.
delta(57, serve_sandwich(_, _, _, _), 0.0) :- done_served(Child), allergic_gluten(Child), !.
delta(57, serve_sandwich(_, _, _, _), -0.11618196019233301) :- !.
delta(57, move_tray(Tray, Place, Place2), 0.009935683935955194) :- at(Tray2, Place), could_serve_sandwich(Tray2, Place), done_served(Child), waiting(Child, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(57, move_tray(_, Place, _), -0.12710354458151477) :- at(Tray, Place), could_serve_sandwich(Tray, Place), done_served(Child), waiting(Child, Place), !.
delta(57, move_tray(_, Place, _), 0.05135864170630839) :- at(Tray, Place), could_serve_sandwich(Tray, Place), done_served(Child), not_allergic_gluten(Child), !.
delta(57, move_tray(_, Place, _), -0.030674967281500386) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(57, move_tray(_, _, kitchen), 0.022847782713230576) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(57, move_tray(_, _, _), -0.030700747850802613) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(57, move_tray(_, _, Place), -0.0032188044974051453) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(57, move_tray(_, _, _), 0.20106206952257566) :- !.
delta(57, _, 0.0).

% tree 58: step size 1.0, 212 examples, 25 leaves
delta(58, make_sandwich_no_gluten(_, _, _), 0.009707710666621712) :- !.
delta(58, make_sandwich(_, _, _), -0.009905800436415757) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(58, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, !.
delta(58, make_sandwich(_, _, _), 0.025870297279362842) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(58, make_sandwich(_, _, _), -8.582162155033589e-5) :- !.
delta(58, put_on_tray(_, _), -0.01020015565465669) :- done_served(Child), not_allergic_gluten(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(58, put_on_tray(_, _), 0.00025215116741092415) :- done_served(Child), not_allergic_gluten(Child), !.
delta(58, put_on_tray(_, _), 0.010155197654312546) :- fewer_ontray_1_than_todo_served, !.
delta(58, put_on_tray(_, _), -7.487658109728607e-5) :- !.
delta(58, serve_sandwich_no_gluten(_, _, _, _), -0.002434941626742872) :- fewer_at_1_than_allergic_gluten, !.
delta(58, serve_sandwich_no_gluten(_, _, _, _), 0.0027715642603790914) :- !.
delta(58, serve_sandwich(Sandwich, _, _, _), -0.16030413042279065) :- no_gluten_sandwich(Sandwich), !.
delta(58, serve_sandwich(_, _, _, Place), -0.01984617052324598) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_not_allergic_gluten, !.
delta(58, serve_sandwich(_, _, _, Place), 0.0002668760513672979) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(58, serve_sandwich(_, Child, _, _), 0.09164839503665946) :- todo_served(Child), !.
delta(58, serve_sandwich(_, _, _, _), -0.0018770210305223954) :- !.
delta(58, move_tray(_, Place, Place2), -0.09593564270177103) :- needed_at_to_serve_sandwich_no_gluten(Place2), goal_served(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(58, move_tray(_, Place, Place2), 0.0015060411250959315) :- needed_at_to_serve_sandwich_no_gluten(Place2), goal_served(Child), waiting(Child, Place), !.
delta(58, move_tray(_, _, Place), 0.022581327987936425) :- needed_at_to_serve_sandwich_no_gluten(Place), fewer_at_1_than_not_allergic_gluten, !.
delta(58, move_tray(_, _, Place), -0.014200421303441624) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(58, move_tray(Tray, _, _), 0.11846494309008591) :- ontray(_, Tray), todo_served(Child), not_allergic_gluten(Child), !.
delta(58, move_tray(Tray, _, _), -0.002826558153664248) :- ontray(_, Tray), !.
delta(58, move_tray(_, _, _), 0.00022508191908113162) :- fewer_at_1_than_allergic_gluten, !.
delta(58, move_tray(_, _, _), -0.008923318072123643) :- !.
delta(58, _, 0.0).

% tree 59: step size 1.0, 205 examples, 22 leaves
delta(59, make_sandwich_no_gluten(_, _, _), 0.015265032715926672) :- !.
delta(59, make_sandwich(_, _, _), -0.015433989610652484) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(59, make_sandwich(_, _, _), 0.03580254617926557) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(59, make_sandwich(_, _, _), -4.681690610279553e-5) :- !.
delta(59, put_on_tray(_, Tray), -0.031676701839327505) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at_kitchen_bread(_), !.
delta(59, put_on_tray(_, Tray), 0.009032557532910023) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(59, put_on_tray(_, _), 0.017585435214463402) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(59, put_on_tray(_, _), -0.00010008110575928385) :- !.
delta(59, serve_sandwich_no_gluten(_, _, _, _), 0.003567616400497407) :- !.
delta(59, serve_sandwich(_, _, Tray, _), -0.0015324336630410224) :- goal_served(Child), done_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(59, serve_sandwich(_, Child, _, _), 0.010600128616319569) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(59, serve_sandwich(_, _, _, _), -0.0007208736423587171) :- goal_served(Child), done_served(Child), !.
delta(59, serve_sandwich(_, _, _, _), -0.11633005109240731) :- fewer_ontray_1_than_todo_served, notexist(_), !.
delta(59, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_1_than_todo_served, !.
delta(59, serve_sandwich(_, _, _, _), -0.00013525534122938053) :- todo_served(Child), allergic_gluten(Child), !.
delta(59, serve_sandwich(_, _, _, _), 0.0027977130396743956) :- !.
delta(59, move_tray(_, Place, _), -0.04549589848318036) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(59, move_tray(_, Place, _), -0.0044176785729684205) :- notexist(_), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(59, move_tray(_, _, _), 0.14240423395628743) :- notexist(_), !.
delta(59, move_tray(_, Place, Place2), 0.006059694389493907) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(59, move_tray(_, _, _), -0.023670467253890826) :- !.
delta(59, _, 0.0).

% tree 60: step size 1.0, 212 examples, 27 leaves
delta(60, make_sandwich_no_gluten(_, _, _), 0.006068158065665914) :- !.
delta(60, make_sandwich(_, _, _), 2.3302090620950846e-5) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(60, make_sandwich(_, _, _), -0.012123516514694127) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(60, make_sandwich(_, Bread_portion, _), -0.0014502543850648836) :- no_gluten_bread(Bread_portion), !.
delta(60, make_sandwich(_, _, _), 9.498736208272435e-6) :- fewer_ontray_2_than_allergic_gluten, !.
delta(60, make_sandwich(_, _, _), 0.03890586356242146) :- !.
delta(60, put_on_tray(_, _), 0.019499681545249357) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(60, put_on_tray(_, _), -0.00010536539359790595) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(60, put_on_tray(_, _), -0.020819581721083245) :- at_kitchen_bread(_), !.
delta(60, put_on_tray(_, _), 0.0048304658457824345) :- fewer_at_1_than_todo_served, !.
delta(60, put_on_tray(_, _), -8.528035430059015e-5) :- !.
delta(60, serve_sandwich_no_gluten(_, _, _, _), 2.039886014560569e-5) :- fewer_ontray_1_than_todo_served, !.
delta(60, serve_sandwich_no_gluten(_, _, _, _), 0.005413271259602653) :- !.
delta(60, serve_sandwich(_, _, _, _), 0.0) :- goal_served(Child), done_served(Child), at_kitchen_bread(_), !.
delta(60, serve_sandwich(_, Child, _, _), 0.06315441485267188) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(60, serve_sandwich(_, _, _, _), -0.0007673977121984422) :- goal_served(Child), done_served(Child), !.
delta(60, serve_sandwich(Sandwich, _, Tray, _), -0.04603035586766749) :- ontray(Sandwich2, Tray), no_gluten_sandwich(Sandwich2), no_gluten_sandwich(Sandwich), !.
delta(60, serve_sandwich(_, _, Tray, _), 0.05948377893806822) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(60, serve_sandwich(_, _, _, _), -0.09970315211939726) :- fewer_ontray_1_than_todo_served, !.
delta(60, serve_sandwich(_, _, _, _), 0.0038004482922893166) :- !.
delta(60, move_tray(Tray, _, _), -0.1038699402655992) :- no_gluten_bread(_), ontray(_, Tray), !.
delta(60, move_tray(_, Place, Place2), 0.007689132708475479) :- no_gluten_bread(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(60, move_tray(_, _, _), -0.0013864685674530176) :- no_gluten_bread(_), !.
delta(60, move_tray(_, Place, Place2), 0.12786949165280515) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), fewer_ontray_1_than_not_allergic_gluten, !.
delta(60, move_tray(_, Place, Place2), -0.0038408062035151895) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(60, move_tray(_, _, _), -0.05211160378783618) :- !.
delta(60, _, 0.0).

% tree 61: step size 1.0, 269 examples, 28 leaves
delta(61, make_sandwich_no_gluten(_, _, _), 0.0034384549479619256) :- fewer_at_1_than_allergic_gluten, !.
delta(61, make_sandwich_no_gluten(_, _, _), 0.00499460946269202) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(61, make_sandwich_no_gluten(_, _, _), -0.16065527638905722) :- fewer_at_2_than_allergic_gluten, !.
delta(61, make_sandwich_no_gluten(_, _, _), -0.0005550953583148407) :- fewer_ontray_1_than_allergic_gluten, !.
delta(61, make_sandwich_no_gluten(_, _, _), 0.0005822096596848334) :- !.
delta(61, make_sandwich(_, _, Content_portion), -0.04123937244930201) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_content(Content_portion), !.
delta(61, make_sandwich(_, Bread_portion, _), -0.01386768782237112) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(61, make_sandwich(_, _, _), 0.21651751063605854) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(61, make_sandwich(_, _, _), -0.040993350191420065) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(61, make_sandwich(_, _, _), 2.3557503082673588e-5) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(61, make_sandwich(_, _, _), 0.0004732937096563073) :- fewer_at_2_than_allergic_gluten, !.
delta(61, make_sandwich(_, _, _), -4.8970121789708066e-5) :- !.
delta(61, put_on_tray(_, _), 0.026428600588508534) :- !.
delta(61, serve_sandwich_no_gluten(_, _, _, _), 3.5946707714913966e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(61, serve_sandwich_no_gluten(_, _, _, _), 0.024258611603343257) :- !.
delta(61, serve_sandwich(Sandwich, Child, _, _), -0.00038218533607641426) :- notexist(_), todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(61, serve_sandwich(_, Child, _, _), 0.0998364237064388) :- notexist(_), todo_served(Child), !.
delta(61, serve_sandwich(_, _, _, _), -0.000417490241936045) :- notexist(_), !.
delta(61, serve_sandwich(_, _, _, _), -0.18715660818324797) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(61, serve_sandwich(_, _, _, _), 0.009724974844221556) :- !.
delta(61, move_tray(_, Place, _), -0.14500713475992466) :- notexist(_), todo_served(Child), waiting(Child, Place), !.
delta(61, move_tray(_, _, Place), -0.024477331061853545) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(61, move_tray(_, _, _), 0.02542405469383045) :- notexist(_), !.
delta(61, move_tray(_, _, Place), 7.755859372262862e-5) :- allergic_gluten(Child), waiting(Child, Place), goal_served(Child2), done_served(Child2), !.
delta(61, move_tray(_, _, Place), -0.021817346364869074) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(61, move_tray(_, _, _), 0.19791124098722573) :- fewer_at_1_than_todo_served, !.
delta(61, move_tray(_, _, _), -0.011699532662274406) :- !.
delta(61, _, 0.0).

% tree 62: step size 1.0, 251 examples, 31 leaves
delta(62, make_sandwich_no_gluten(_, _, _), 5.285942699117696e-5) :- fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(62, make_sandwich_no_gluten(_, _, _), 0.00823272047989776) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(62, make_sandwich_no_gluten(_, _, _), -0.10318026096790452) :- fewer_at_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(62, make_sandwich_no_gluten(_, _, _), 0.0002543440736067109) :- fewer_at_1_than_not_allergic_gluten, !.
delta(62, make_sandwich_no_gluten(_, _, _), 0.0014741176288226901) :- !.
delta(62, make_sandwich(_, _, _), -0.013429345406598068) :- fewer_at_1_than_allergic_gluten, !.
delta(62, make_sandwich(_, _, _), -0.011688982886677244) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(62, make_sandwich(_, _, _), 0.00837560320980058) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(62, make_sandwich(_, _, Content_portion), -0.005107600167125781) :- no_gluten_content(Content_portion), !.
delta(62, make_sandwich(_, _, _), 0.2580898041930145) :- !.
delta(62, put_on_tray(_, _), 0.00649891484540647) :- no_gluten_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(62, put_on_tray(_, _), -0.00038894616560262947) :- no_gluten_sandwich(_), !.
delta(62, put_on_tray(_, Tray), 0.0009596136461538893) :- ontray(_, Tray), !.
delta(62, put_on_tray(_, _), -0.012114094667076636) :- at_kitchen_bread(_), !.
delta(62, put_on_tray(_, _), 1.9728064670289582e-5) :- !.
delta(62, serve_sandwich_no_gluten(_, Child, _, _), 0.010649152751496296) :- todo_served(Child), !.
delta(62, serve_sandwich_no_gluten(_, _, _, _), -0.007528880655432778) :- !.
delta(62, serve_sandwich(_, _, _, _), -0.1730866539575578) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(62, serve_sandwich(_, _, _, _), 0.017944898693775448) :- at_kitchen_sandwich(_), !.
delta(62, serve_sandwich(_, _, _, _), -0.0008696743669368916) :- todo_served(Child), allergic_gluten(Child), !.
delta(62, serve_sandwich(_, Child, _, _), 0.014897925898900856) :- todo_served(Child), !.
delta(62, serve_sandwich(_, _, _, _), -9.170173953527852e-5) :- !.
delta(62, move_tray(Tray, Place, Place2), 0.0) :- at(Tray2, Place), could_serve_sandwich(Tray2, Place), notexist(_), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(62, move_tray(_, Place, _), -0.09580851638846782) :- at(Tray, Place), could_serve_sandwich(Tray, Place), notexist(_), !.
delta(62, move_tray(_, Place, _), 0.036050533265948266) :- at(Tray, Place), could_serve_sandwich(Tray, Place), done_served(Child), not_allergic_gluten(Child), !.
delta(62, move_tray(_, Place, _), -0.021917223191708288) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(62, move_tray(Tray, _, Place), -0.015552286213420329) :- todo_served(Child), waiting(Child, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(62, move_tray(_, _, Place), 0.12330570405816155) :- todo_served(Child), waiting(Child, Place), !.
delta(62, move_tray(_, _, _), 0.0003446934807352076) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(62, move_tray(_, _, _), -0.03951067400603862) :- !.
delta(62, _, 0.0).

% tree 63: step size 1.0, 261 examples, 29 leaves
delta(63, make_sandwich_no_gluten(_, _, _), 0.016368931845213666) :- todo_served(Child), allergic_gluten(Child), !.
delta(63, make_sandwich_no_gluten(_, _, _), 0.0014998615837086302) :- no_gluten_sandwich(_), !.
delta(63, make_sandwich_no_gluten(_, _, _), -0.008869420225453381) :- !.
delta(63, make_sandwich(_, _, _), -0.04732165933972217) :- fewer_at_1_than_allergic_gluten, !.
delta(63, make_sandwich(_, _, _), -0.006276347683421981) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(63, make_sandwich(_, _, _), 0.021350416427570313) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(63, make_sandwich(_, _, _), -3.11866651189952e-5) :- !.
delta(63, put_on_tray(_, _), 0.00010505413015169664) :- fewer_at_1_than_allergic_gluten, at_kitchen_bread(_), !.
delta(63, put_on_tray(_, _), -0.011398363157626159) :- fewer_at_1_than_allergic_gluten, !.
delta(63, put_on_tray(_, Tray), 0.013494152431261083) :- ontray(_, Tray), !.
delta(63, put_on_tray(_, _), 0.0005673029719593341) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(63, put_on_tray(_, _), -0.0018199624627065624) :- !.
delta(63, serve_sandwich_no_gluten(_, _, _, _), 0.004592691660702317) :- !.
delta(63, serve_sandwich(_, Child, Tray, _), -0.001419661419096967) :- fewer_ontray_1_than_todo_served, todo_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(63, serve_sandwich(_, Child, _, _), 0.10306706059126816) :- fewer_ontray_1_than_todo_served, todo_served(Child), !.
delta(63, serve_sandwich(_, _, _, _), -0.004317738369242699) :- fewer_ontray_1_than_todo_served, !.
delta(63, serve_sandwich(_, Child, _, _), 0.020271617417739304) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(63, serve_sandwich(_, _, _, _), -0.001404396986268634) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(63, serve_sandwich(_, _, _, _), -0.18116627523580187) :- notexist(_), !.
delta(63, serve_sandwich(_, _, _, _), 0.0032581995956036005) :- !.
delta(63, move_tray(_, Place, Place2), -0.03669877585682824) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(63, move_tray(_, _, Place), 0.11349783239246468) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(63, move_tray(_, Place, _), 0.0019556346110363968) :- fewer_ontray_1_than_not_allergic_gluten, allergic_gluten(Child), waiting(Child, Place), !.
delta(63, move_tray(_, _, _), -0.19024834647088987) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(63, move_tray(Tray, _, Place), -0.007842661144202904) :- could_serve_sandwich(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(63, move_tray(Tray, _, Place), 0.20405542318801315) :- could_serve_sandwich(Tray, Place), !.
delta(63, move_tray(_, Place, _), 6.893840846933954e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(63, move_tray(_, _, _), -0.024967161052306418) :- !.
delta(63, _, 0.0).

% tree 64: step size 1.0, 237 examples, 30 leaves
delta(64, make_sandwich_no_gluten(_, _, _), 0.005108087287504975) :- fewer_at_1_than_todo_served_allergic_gluten, no_gluten_sandwich(_), !.
delta(64, make_sandwich_no_gluten(_, _, _), -0.21206571915415806) :- fewer_at_1_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(64, make_sandwich_no_gluten(_, _, _), 2.9397140570748902e-5) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(64, make_sandwich_no_gluten(_, _, _), 0.07884129416201827) :- !.
delta(64, make_sandwich(_, _, Content_portion), -0.02451849931515631) :- fewer_at_1_than_allergic_gluten, no_gluten_content(Content_portion), !.
delta(64, make_sandwich(_, Bread_portion, _), -0.009532448836744591) :- fewer_at_1_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(64, make_sandwich(_, _, _), 0.2486493547515196) :- fewer_at_1_than_allergic_gluten, !.
delta(64, make_sandwich(_, _, _), -0.08589455298097731) :- todo_served(Child), allergic_gluten(Child), !.
delta(64, make_sandwich(_, _, _), -0.01461227422076207) :- done_served(Child), not_allergic_gluten(Child), !.
delta(64, make_sandwich(_, _, _), 0.004954259300668897) :- !.
delta(64, put_on_tray(_, _), 0.00823180993500166) :- fewer_at_2_than_todo_served, !.
delta(64, put_on_tray(_, Tray), 0.0006872619448138422) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(64, put_on_tray(_, _), -0.006795504926125997) :- goal_served(Child), allergic_gluten(Child), !.
delta(64, put_on_tray(_, _), 1.6546614625587916e-5) :- !.
delta(64, serve_sandwich_no_gluten(_, Child, _, _), 0.00664032540177596) :- todo_served(Child), !.
delta(64, serve_sandwich_no_gluten(_, _, _, _), -0.035259076258074395) :- !.
delta(64, serve_sandwich(_, Child, _, _), 0.03647722745542698) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(64, serve_sandwich(_, _, _, _), -0.001994028338701111) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(64, serve_sandwich(_, _, _, _), -0.005690641327419005) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(64, serve_sandwich(_, _, _, _), -8.010667101663906e-5) :- notexist(_), todo_served(Child), allergic_gluten(Child), !.
delta(64, serve_sandwich(_, _, _, _), -0.21285874418085812) :- notexist(_), !.
delta(64, serve_sandwich(_, _, _, _), 0.013663094282849569) :- no_gluten_sandwich(_), !.
delta(64, serve_sandwich(_, _, _, _), 0.0006438426807110341) :- !.
delta(64, move_tray(_, _, Place), -0.012454426739319251) :- at(Tray, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(64, move_tray(_, _, Place), 0.271314403859759) :- at(Tray, Place), ontray(_, Tray), !.
delta(64, move_tray(_, Place, Place2), 0.026446629247088512) :- fewer_ontray_1_than_not_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(64, move_tray(_, _, _), -0.12085752294863808) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(64, move_tray(_, _, _), -0.022698609417723063) :- at_kitchen_sandwich(_), !.
delta(64, move_tray(_, _, _), 0.07749628562497154) :- !.
delta(64, _, 0.0).

% tree 65: step size 1.0, 207 examples, 23 leaves
delta(65, make_sandwich_no_gluten(_, _, _), 0.027797969477133602) :- !.
delta(65, make_sandwich(_, _, _), -0.04349305020051192) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(65, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(_), fewer_at_2_than_allergic_gluten, !.
delta(65, make_sandwich(_, _, _), -0.002403668351977685) :- at_kitchen_sandwich(_), !.
delta(65, make_sandwich(_, _, _), 2.1590035724954928e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(65, make_sandwich(_, _, _), 0.019587081341191054) :- !.
delta(65, put_on_tray(_, _), 5.35883255956999e-6) :- done_served(Child), not_allergic_gluten(Child), !.
delta(65, put_on_tray(_, _), 0.007065986706753414) :- !.
delta(65, serve_sandwich_no_gluten(_, Child, _, _), 0.01348124316744565) :- todo_served(Child), !.
delta(65, serve_sandwich_no_gluten(_, _, _, _), -0.013629825463193771) :- !.
delta(65, serve_sandwich(_, _, _, _), -0.20873091306314778) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(65, serve_sandwich(_, _, _, Place), 0.030546045384309432) :- fewer_ontray_1_than_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(65, serve_sandwich(_, _, _, _), -0.021083911417071194) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(65, serve_sandwich(_, _, _, _), 0.009572631315244108) :- !.
delta(65, move_tray(_, Place, _), 0.22506569499338883) :- fewer_at_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(65, move_tray(_, _, _), -0.0028885155540848105) :- fewer_at_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(65, move_tray(_, Place, _), -0.040923291757228565) :- fewer_at_1_than_todo_served_not_allergic_gluten, goal_served(Child), waiting(Child, Place), !.
delta(65, move_tray(_, _, _), 0.02933441635876322) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(65, move_tray(_, _, Place), -0.05501711071682417) :- allergic_gluten(Child), waiting(Child, Place), notexist(_), !.
delta(65, move_tray(_, _, Place), 0.010707595286198475) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(65, move_tray(Tray, _, Place), 0.021442669686618943) :- could_serve_sandwich(Tray, Place), !.
delta(65, move_tray(_, _, _), -0.004856654776221319) :- !.
delta(65, _, 0.0).

% tree 66: step size 1.0, 222 examples, 21 leaves
delta(66, make_sandwich_no_gluten(_, _, _), 0.01371042200344687) :- !.
delta(66, make_sandwich(_, _, _), -0.00022806564570000874) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(66, make_sandwich(_, _, _), 0.001160992527963878) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(66, make_sandwich(_, _, _), 9.456161936896437e-6) :- done_served(Child), not_allergic_gluten(Child), !.
delta(66, make_sandwich(_, _, _), -0.042060319778475616) :- !.
delta(66, put_on_tray(_, _), 0.011962267159486808) :- !.
delta(66, serve_sandwich_no_gluten(_, _, _, Place), -0.23667964198055025) :- done_served(Child), waiting(Child, Place), !.
delta(66, serve_sandwich_no_gluten(_, _, _, _), 0.0013954952823833008) :- !.
delta(66, serve_sandwich(_, _, _, _), -0.31086117996472623) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(66, serve_sandwich(_, _, _, _), 0.019435176885024615) :- fewer_ontray_2_than_allergic_gluten, !.
delta(66, serve_sandwich(_, _, _, _), -0.004499536967663115) :- at_kitchen_bread(_), !.
delta(66, serve_sandwich(_, Child, _, _), 0.06791455087978622) :- todo_served(Child), !.
delta(66, serve_sandwich(_, _, _, _), -1.3603717926208237e-5) :- !.
delta(66, move_tray(_, Place, Place2), -0.04498236183008833) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(66, move_tray(Tray, _, _), -0.011386106141278307) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(66, move_tray(_, _, _), 0.549027720867423) :- fewer_ontray_2_than_allergic_gluten, !.
delta(66, move_tray(_, Place, Place2), 0.04922106372779955) :- at(Tray, Place), could_put_on_tray(Tray, Place2), goal_served(Child), done_served(Child), !.
delta(66, move_tray(_, Place, Place2), -0.008036371785861529) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(66, move_tray(_, _, _), 0.017916552069518376) :- at_kitchen_bread(_), !.
delta(66, move_tray(_, _, _), -0.14268164711546827) :- !.
delta(66, _, 0.0).

% tree 67: step size 1.0, 255 examples, 31 leaves
delta(67, make_sandwich_no_gluten(_, _, _), 0.00965002838477977) :- fewer_at_1_than_todo_served_allergic_gluten, no_gluten_sandwich(_), !.
delta(67, make_sandwich_no_gluten(_, _, _), -0.25802320724469446) :- fewer_at_1_than_todo_served_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(67, make_sandwich_no_gluten(_, _, _), -7.840160575031338e-19) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(67, make_sandwich_no_gluten(_, _, _), 0.02294947203786958) :- !.
delta(67, make_sandwich(_, Bread_portion, _), -0.007037145605747515) :- fewer_at_1_than_todo_served_allergic_gluten, fewer_ontray_1_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(67, make_sandwich(_, _, _), 0.310375705441133) :- fewer_at_1_than_todo_served_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(67, make_sandwich(_, _, _), -0.018384404085376872) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(67, make_sandwich(_, _, _), -0.02474719497008925) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(67, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, !.
delta(67, make_sandwich(_, _, _), 0.016850594444387385) :- !.
delta(67, put_on_tray(_, _), -0.03830472922136919) :- at_kitchen_bread(_), fewer_at_1_than_todo_served, !.
delta(67, put_on_tray(_, _), 0.001064042821288128) :- at_kitchen_bread(_), !.
delta(67, put_on_tray(_, Tray), 0.014037596512584707) :- ontray(_, Tray), !.
delta(67, put_on_tray(_, _), -0.0027936933021527935) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(67, put_on_tray(_, _), 3.608212055420201e-5) :- !.
delta(67, serve_sandwich_no_gluten(_, _, _, _), 0.001857812741677779) :- !.
delta(67, serve_sandwich(Sandwich, Child, _, Place), -0.0003168555300475527) :- no_gluten_bread(_), todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(67, serve_sandwich(_, Child, _, _), 0.06854131990411579) :- no_gluten_bread(_), todo_served(Child), !.
delta(67, serve_sandwich(_, _, _, _), -0.0005299330254968016) :- no_gluten_bread(_), !.
delta(67, serve_sandwich(_, _, _, Place), -0.019460516275723126) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(67, serve_sandwich(_, _, _, Place), 0.0005805425731296828) :- done_served(Child), waiting(Child, Place), !.
delta(67, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_bread(_), !.
delta(67, serve_sandwich(_, _, _, _), 0.0005292977466594526) :- !.
delta(67, move_tray(_, Place, Place2), 0.036233709800291086) :- fewer_at_1_than_todo_served_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place2), todo_served(Child), waiting(Child, Place), !.
delta(67, move_tray(_, _, Place), -0.0030482350147013368) :- fewer_at_1_than_todo_served_allergic_gluten, needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(67, move_tray(_, _, _), -0.020958642297828258) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(67, move_tray(_, Place, Place2), 0.022222517937880173) :- at(Tray, Place2), could_serve_sandwich(Tray, Place), at(Tray2, Place), could_serve_sandwich(Tray2, Place2), !.
delta(67, move_tray(_, Place, Place2), -9.639733677899126e-5) :- at(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(67, move_tray(_, _, _), -0.10131521414590437) :- no_gluten_bread(_), !.
delta(67, move_tray(_, _, _), 0.01164439334130251) :- !.
delta(67, _, 0.0).

% tree 68: step size 1.0, 260 examples, 28 leaves
delta(68, make_sandwich_no_gluten(_, _, _), 0.046093397170942095) :- !.
delta(68, make_sandwich(_, _, _), -0.0711404980994527) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(68, make_sandwich(_, _, _), 4.443606204224749e-6) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(68, make_sandwich(_, _, _), -0.0007546802870812472) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(68, make_sandwich(_, _, _), 0.003945852003294753) :- goal_served(Child), allergic_gluten(Child), !.
delta(68, make_sandwich(_, _, _), 0.0) :- at_kitchen_sandwich(_), !.
delta(68, make_sandwich(_, _, _), 0.005477726045054248) :- !.
delta(68, put_on_tray(_, Tray), 0.015864433962941682) :- ontray(_, Tray), !.
delta(68, put_on_tray(_, _), -0.0022913184749041335) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(68, put_on_tray(_, _), 0.0006213245020667912) :- !.
delta(68, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- done_served(Child), not_allergic_gluten(Child), !.
delta(68, serve_sandwich_no_gluten(_, _, _, _), 0.0012537290892732048) :- !.
delta(68, serve_sandwich(_, _, _, _), 0.026886075337397345) :- at_kitchen_sandwich(_), notexist(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(68, serve_sandwich(_, _, _, _), -0.0009289714379009318) :- at_kitchen_sandwich(_), notexist(_), !.
delta(68, serve_sandwich(_, _, _, _), -0.07436074781198268) :- at_kitchen_sandwich(_), !.
delta(68, serve_sandwich(_, _, _, Place), -0.0010227021035580566) :- done_served(Child), waiting(Child, Place), fewer_at_1_than_allergic_gluten, !.
delta(68, serve_sandwich(_, _, _, Place), 0.05689559448883003) :- done_served(Child), waiting(Child, Place), !.
delta(68, serve_sandwich(_, _, _, _), -0.004424680114519168) :- at_kitchen_bread(_), !.
delta(68, serve_sandwich(_, _, _, _), 0.0004000637484576239) :- !.
delta(68, move_tray(_, _, Place), 0.09795875720409561) :- at_kitchen_sandwich(_), needed_at_to_serve_sandwich_no_gluten(Place), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(68, move_tray(_, _, Place), -0.0018597644509367416) :- at_kitchen_sandwich(_), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(68, move_tray(_, _, _), -0.04462782591201404) :- at_kitchen_sandwich(_), goal_served(Child), allergic_gluten(Child), !.
delta(68, move_tray(_, _, _), 0.0007829170120152622) :- at_kitchen_sandwich(_), !.
delta(68, move_tray(_, Place, Place2), 0.010999725012125282) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), at(_, Place2), !.
delta(68, move_tray(_, Place, Place2), -0.08836299052252845) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(68, move_tray(Tray, _, Place), 0.012656736928264776) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(68, move_tray(_, _, _), -0.001572547391413785) :- !.
delta(68, _, 0.0).

% tree 69: step size 1.0, 214 examples, 24 leaves
delta(69, make_sandwich_no_gluten(_, _, _), -0.21327121456250434) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(69, make_sandwich_no_gluten(_, _, _), 5.460231932062112e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(69, make_sandwich_no_gluten(_, _, _), 0.0017459199868627869) :- fewer_at_2_than_allergic_gluten, !.
delta(69, make_sandwich_no_gluten(_, _, _), 0.04817242760634419) :- !.
delta(69, make_sandwich(_, _, _), -0.009241021147971052) :- fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(69, make_sandwich(_, _, _), 0.20296624572044478) :- fewer_at_1_than_allergic_gluten, !.
delta(69, make_sandwich(_, _, _), -1.6863334417595525e-5) :- goal_served(Child), done_served(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(69, make_sandwich(_, _, _), 0.006861184686701231) :- goal_served(Child), done_served(Child), !.
delta(69, make_sandwich(_, _, _), -0.09015149856857098) :- !.
delta(69, put_on_tray(_, _), 0.02049842049049887) :- !.
delta(69, serve_sandwich_no_gluten(_, _, _, _), -0.12400976559507572) :- fewer_at_1_than_todo_served_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(69, serve_sandwich_no_gluten(_, _, _, _), 4.175333639144427e-5) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(69, serve_sandwich_no_gluten(_, _, _, _), 1.017575881398486e-6) :- fewer_ontray_2_than_allergic_gluten, !.
delta(69, serve_sandwich_no_gluten(_, _, _, _), 0.0004419289786857373) :- !.
delta(69, serve_sandwich(_, _, _, _), -0.2528517470707589) :- fewer_ontray_2_than_allergic_gluten, !.
delta(69, serve_sandwich(_, Child, _, _), 0.0787759868403909) :- todo_served(Child), !.
delta(69, serve_sandwich(_, _, _, _), -0.003667772656268439) :- !.
delta(69, move_tray(Tray, _, Place), 0.35577843985044766) :- fewer_ontray_2_than_allergic_gluten, ontray(_, Tray), todo_served(Child), waiting(Child, Place), !.
delta(69, move_tray(Tray, _, _), -7.974166147332464e-5) :- fewer_ontray_2_than_allergic_gluten, ontray(_, Tray), !.
delta(69, move_tray(_, _, _), -0.004307318181913835) :- fewer_ontray_2_than_allergic_gluten, !.
delta(69, move_tray(_, Place, _), -0.09849867096882658) :- at(Tray, Place), ontray(_, Tray), !.
delta(69, move_tray(_, Place, _), -0.007203285043649433) :- done_served(Child), waiting(Child, Place), !.
delta(69, move_tray(_, _, _), 0.039010343942398676) :- !.
delta(69, _, 0.0).

% tree 70: step size 1.0, 202 examples, 30 leaves
delta(70, make_sandwich_no_gluten(_, _, _), -0.027537223430925843) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(70, make_sandwich_no_gluten(_, _, _), 0.00327553063536712) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(70, make_sandwich_no_gluten(_, _, _), 0.026740120919103938) :- !.
delta(70, make_sandwich(_, _, _), -0.0009674897557082596) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(70, make_sandwich(_, _, _), 0.021178656394693022) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(70, make_sandwich(_, _, _), -0.00013485604428740394) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(70, make_sandwich(_, _, _), -0.056817632538878386) :- fewer_ontray_1_than_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), !.
delta(70, make_sandwich(_, _, _), 0.00044950770718350916) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(70, make_sandwich(_, Bread_portion, _), -0.0013275150090287906) :- no_gluten_bread(Bread_portion), !.
delta(70, make_sandwich(_, _, _), 0.013718164842718617) :- !.
delta(70, put_on_tray(_, _), 0.04374938495072225) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(70, put_on_tray(_, _), 4.240961584310979e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), fewer_at_1_than_todo_served, !.
delta(70, put_on_tray(_, _), -0.0016386520274357253) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(70, put_on_tray(_, Tray), -0.00017915258980953885) :- ontray(_, Tray), !.
delta(70, put_on_tray(_, _), 0.0002355603018274026) :- !.
delta(70, serve_sandwich_no_gluten(_, _, _, _), 0.00191480464984638) :- !.
delta(70, serve_sandwich(_, _, _, Place), -0.1395267404790865) :- at_kitchen_sandwich(_), done_served(Child), waiting(Child, Place), !.
delta(70, serve_sandwich(_, _, _, _), -3.901828462910821e-5) :- at_kitchen_sandwich(_), !.
delta(70, serve_sandwich(_, _, _, _), 0.0010853896568591508) :- fewer_no_gluten_sandwich_than_todo_served, done_served(Child), not_allergic_gluten(Child), !.
delta(70, serve_sandwich(_, _, _, _), 0.022176530345148448) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(70, serve_sandwich(_, _, _, _), -0.01124890179376459) :- notexist(_), !.
delta(70, serve_sandwich(_, _, _, _), 5.415877803322085e-5) :- !.
delta(70, move_tray(_, Place, Place2), -0.0005220268860973177) :- done_served(Child), waiting(Child, Place), goal_served(Child2), waiting(Child2, Place2), fewer_ontray_1_than_allergic_gluten, !.
delta(70, move_tray(_, Place, Place2), 0.15840523401436835) :- done_served(Child), waiting(Child, Place), goal_served(Child2), waiting(Child2, Place2), !.
delta(70, move_tray(_, Place, _), 0.003476763069831303) :- done_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(70, move_tray(_, Place, _), -0.017487060618423582) :- done_served(Child), waiting(Child, Place), !.
delta(70, move_tray(_, _, _), -0.011471998098551461) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(70, move_tray(_, _, _), 0.01618858694537638) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(70, move_tray(_, _, _), -0.05763532906632425) :- !.
delta(70, _, 0.0).

% tree 71: step size 1.0, 246 examples, 25 leaves
delta(71, make_sandwich_no_gluten(_, _, _), 0.009177787210373045) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(71, make_sandwich_no_gluten(_, _, _), -0.12960310442293094) :- fewer_at_1_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(71, make_sandwich_no_gluten(_, _, _), 1.2851424170802755e-5) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(71, make_sandwich_no_gluten(_, _, _), 0.02406027405267604) :- !.
delta(71, make_sandwich(_, _, Content_portion), -0.007905122893772504) :- fewer_at_1_than_allergic_gluten, no_gluten_content(Content_portion), !.
delta(71, make_sandwich(_, Bread_portion, _), -0.005900803731502886) :- fewer_at_1_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(71, make_sandwich(_, _, _), 0.17198177247624252) :- fewer_at_1_than_allergic_gluten, !.
delta(71, make_sandwich(_, _, _), 0.0006204314666697853) :- goal_served(Child), done_served(Child), !.
delta(71, make_sandwich(_, _, _), -0.03819507933651896) :- !.
delta(71, put_on_tray(_, _), -0.008955566818537526) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(71, put_on_tray(_, _), 0.010935810481202941) :- !.
delta(71, serve_sandwich_no_gluten(_, _, _, Place), -0.0023445444301055532) :- done_served(Child), waiting(Child, Place), !.
delta(71, serve_sandwich_no_gluten(_, _, _, _), 0.002692811185428646) :- !.
delta(71, serve_sandwich(_, Child, _, _), -0.0012338556035527736) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(71, serve_sandwich(_, Child, _, _), 0.053860149612472305) :- todo_served(Child), !.
delta(71, serve_sandwich(_, _, _, _), -0.0016283931563967934) :- !.
delta(71, move_tray(_, Place, Place2), -0.0015388334539519813) :- todo_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), allergic_gluten(Child), !.
delta(71, move_tray(_, Place, Place2), 0.003318640072738472) :- todo_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(71, move_tray(_, Place, Place2), 1.8189308799886288e-5) :- todo_served(Child), waiting(Child, Place), at(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(71, move_tray(_, Place, _), -0.11392752386422565) :- todo_served(Child), waiting(Child, Place), !.
delta(71, move_tray(_, _, Place), 5.026502875539968e-5) :- at(_, Place), at_kitchen_bread(_), !.
delta(71, move_tray(_, _, Place), -0.02590362751998641) :- at(_, Place), !.
delta(71, move_tray(_, Place, Place2), -0.019050450358714135) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(71, move_tray(_, _, _), 0.0774087812196444) :- !.
delta(71, _, 0.0).

% tree 72: step size 1.0, 253 examples, 28 leaves
delta(72, make_sandwich_no_gluten(_, _, _), 0.01156365474687804) :- !.
delta(72, make_sandwich(_, _, _), 0.0005636404813213381) :- fewer_ontray_1_than_not_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(72, make_sandwich(_, _, _), -0.051821822799430615) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(72, make_sandwich(_, _, _), -0.0005136963833575759) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(72, make_sandwich(_, _, _), 0.00548006695866214) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(72, make_sandwich(_, _, _), -4.073658479224523e-5) :- !.
delta(72, put_on_tray(_, _), 0.01710515141230123) :- fewer_ontray_1_than_todo_served, !.
delta(72, put_on_tray(_, _), 0.00016302926282051129) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(72, put_on_tray(_, _), -0.003014457888315399) :- !.
delta(72, serve_sandwich_no_gluten(_, _, _, _), 0.0011372698817211856) :- at_kitchen_sandwich(_), !.
delta(72, serve_sandwich_no_gluten(_, _, _, _), -0.01578763368796428) :- fewer_ontray_2_than_allergic_gluten, !.
delta(72, serve_sandwich_no_gluten(_, _, _, _), 0.00017426598167766242) :- !.
delta(72, serve_sandwich(_, Child, _, _), 0.10747562367544523) :- goal_served(Child2), done_served(Child2), done_served(Child3), allergic_gluten(Child3), todo_served(Child), !.
delta(72, serve_sandwich(_, _, _, _), -0.0013377701728972862) :- goal_served(Child), done_served(Child), done_served(Child2), allergic_gluten(Child2), !.
delta(72, serve_sandwich(_, _, _, Place), -0.024123697286819196) :- goal_served(Child), done_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(72, serve_sandwich(_, _, _, _), 0.02093738847831132) :- goal_served(Child), done_served(Child), !.
delta(72, serve_sandwich(_, _, _, _), -2.533645801439331e-5) :- at_kitchen_bread(_), fewer_ontray_2_than_allergic_gluten, !.
delta(72, serve_sandwich(_, _, _, _), 0.02984913866018019) :- at_kitchen_bread(_), !.
delta(72, serve_sandwich(_, _, _, _), -0.13463268574174897) :- !.
delta(72, move_tray(Tray, _, Place), 0.0016003428171030237) :- goal_served(Child), done_served(Child), notexist(_), could_put_on_tray(Tray, Place), !.
delta(72, move_tray(_, _, _), -0.13144130909859156) :- goal_served(Child), done_served(Child), notexist(_), !.
delta(72, move_tray(_, _, Place), 0.035409721493168095) :- goal_served(Child), done_served(Child), todo_served(Child2), waiting(Child2, Place), !.
delta(72, move_tray(_, _, _), -0.02927195089856778) :- goal_served(Child), done_served(Child), !.
delta(72, move_tray(Tray, _, _), 0.13737516908538058) :- fewer_at_1_than_not_allergic_gluten, ontray(_, Tray), !.
delta(72, move_tray(_, _, _), -4.463368220000502e-5) :- fewer_at_1_than_not_allergic_gluten, !.
delta(72, move_tray(_, Place, Place2), 0.005636965185202967) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(72, move_tray(_, _, _), -0.013874451263140936) :- !.
delta(72, _, 0.0).

% tree 73: step size 1.0, 216 examples, 23 leaves
delta(73, make_sandwich_no_gluten(_, _, _), 0.0018738070654065503) :- fewer_at_1_than_allergic_gluten, !.
delta(73, make_sandwich_no_gluten(_, _, _), -0.13588736049554584) :- fewer_at_2_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(73, make_sandwich_no_gluten(_, _, _), 1.6526926227263382e-5) :- fewer_at_2_than_allergic_gluten, !.
delta(73, make_sandwich_no_gluten(_, _, _), 0.000752938824271625) :- !.
delta(73, make_sandwich(_, Bread_portion, _), -0.001733268782275439) :- fewer_ontray_1_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(73, make_sandwich(_, _, _), -0.00018871490631219674) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(73, make_sandwich(_, _, _), 0.13313544609664663) :- fewer_ontray_1_than_allergic_gluten, !.
delta(73, make_sandwich(_, _, _), 0.001152184895575217) :- goal_served(Child), done_served(Child), !.
delta(73, make_sandwich(_, _, _), -0.015042363751697886) :- at_kitchen_sandwich(_), !.
delta(73, make_sandwich(_, _, _), -8.295849570016374e-5) :- !.
delta(73, put_on_tray(_, _), 0.02194918379099418) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(73, put_on_tray(Sandwich, _), 0.0016996878182686114) :- no_gluten_sandwich(Sandwich), !.
delta(73, put_on_tray(_, _), -0.001690973270979396) :- !.
delta(73, serve_sandwich_no_gluten(_, _, _, _), 0.0003514560054127151) :- !.
delta(73, serve_sandwich(_, Child, _, _), 0.055394882111209194) :- todo_served(Child), !.
delta(73, serve_sandwich(_, _, _, _), -0.001748900396716858) :- !.
delta(73, move_tray(_, Place, Place2), 0.013654751540061865) :- at(_, Place2), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(73, move_tray(_, _, Place), -0.002504718067734346) :- at(_, Place), !.
delta(73, move_tray(_, Place, _), 0.0) :- at(Tray, Place), could_serve_sandwich(Tray, Place), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(73, move_tray(_, Place, _), -0.1021403812003745) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(73, move_tray(_, Place, _), 0.00588033822404353) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(73, move_tray(_, _, _), -0.010116158319556931) :- !.
delta(73, _, 0.0).

% tree 74: step size 1.0, 205 examples, 24 leaves
delta(74, make_sandwich_no_gluten(_, _, _), 0.04048106455628868) :- fewer_at_1_than_allergic_gluten, !.
delta(74, make_sandwich_no_gluten(_, _, _), 0.0017572333542162008) :- !.
delta(74, make_sandwich(_, _, Content_portion), -0.014507997230287166) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_content(Content_portion), !.
delta(74, make_sandwich(_, _, _), 0.01412611815283178) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(74, make_sandwich(_, _, _), -1.7398136839596686e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(74, make_sandwich(_, _, _), -0.000491817238271612) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(74, make_sandwich(_, _, _), 3.165722215909407e-5) :- at_kitchen_sandwich(_), !.
delta(74, make_sandwich(_, _, _), 2.4346879354644155e-5) :- goal_served(Child), done_served(Child), !.
delta(74, make_sandwich(_, _, _), -0.0593809841625385) :- !.
delta(74, put_on_tray(_, Tray), 0.0) :- ontray(_, Tray), goal_served(Child), done_served(Child), !.
delta(74, put_on_tray(_, Tray), 0.007929993769596914) :- ontray(_, Tray), !.
delta(74, put_on_tray(_, _), -0.016987428476706732) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(74, put_on_tray(_, _), 0.0012229055589926623) :- !.
delta(74, serve_sandwich_no_gluten(_, _, _, _), 0.00430853825901834) :- !.
delta(74, serve_sandwich(_, _, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(74, serve_sandwich(_, _, _, _), -0.2016474297214449) :- todo_served(Child), allergic_gluten(Child), !.
delta(74, serve_sandwich(_, Child, _, _), 0.08914116241693956) :- todo_served(Child), !.
delta(74, serve_sandwich(_, _, _, _), -0.0025880675642200863) :- !.
delta(74, move_tray(Tray, _, _), -0.1162380554496825) :- ontray(_, Tray), !.
delta(74, move_tray(_, Place, _), 0.24085815171777436) :- allergic_gluten(Child), waiting(Child, Place), fewer_at_2_than_allergic_gluten, !.
delta(74, move_tray(_, Place, _), -8.837346235156697e-6) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(74, move_tray(_, Place, _), 0.000352027443461591) :- done_served(Child), waiting(Child, Place), !.
delta(74, move_tray(_, _, _), -0.004561009517246635) :- !.
delta(74, _, 0.0).

% tree 75: step size 1.0, 206 examples, 29 leaves
delta(75, make_sandwich_no_gluten(_, _, _), -0.022144731029960237) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(75, make_sandwich_no_gluten(_, _, _), 6.340639470001113e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(75, make_sandwich_no_gluten(_, _, _), 0.061215169594471805) :- !.
delta(75, make_sandwich(_, _, _), 0.001037895185865893) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(75, make_sandwich(_, _, _), -0.11285187986854656) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(75, make_sandwich(_, _, _), 0.0011877160231343283) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(75, make_sandwich(_, _, _), 0.030865102287413005) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(75, make_sandwich(_, _, _), -2.200063597376235e-5) :- !.
delta(75, put_on_tray(_, _), 0.04356790716975028) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(75, put_on_tray(Sandwich, _), 0.001976696653419242) :- no_gluten_sandwich(Sandwich), !.
delta(75, put_on_tray(_, _), -0.009879328590499026) :- !.
delta(75, serve_sandwich_no_gluten(_, Child, _, _), 8.100711896564696e-5) :- todo_served(Child), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(75, serve_sandwich_no_gluten(_, Child, _, _), 0.002140580147130389) :- todo_served(Child), !.
delta(75, serve_sandwich_no_gluten(_, _, _, _), -0.19304941409358534) :- !.
delta(75, serve_sandwich(_, _, Tray, _), 0.0024711496873642117) :- fewer_at_1_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(75, serve_sandwich(_, _, _, _), -0.20686431128165542) :- fewer_at_1_than_allergic_gluten, !.
delta(75, serve_sandwich(_, _, Tray, _), -0.009027466678595126) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(75, serve_sandwich(_, _, Tray, _), 0.0016052619277459434) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(75, serve_sandwich(_, _, _, _), 0.048430408382657046) :- fewer_ontray_1_than_todo_served, !.
delta(75, serve_sandwich(_, _, _, _), 0.002233299164523916) :- !.
delta(75, move_tray(_, _, Place), -0.010336954955981116) :- done_served(Child), allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), fewer_ontray_2_than_not_allergic_gluten, !.
delta(75, move_tray(_, _, Place), 2.932484979093778e-5) :- done_served(Child), allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(75, move_tray(_, _, _), 0.38065740739135334) :- done_served(Child), allergic_gluten(Child), fewer_ontray_2_than_allergic_gluten, !.
delta(75, move_tray(_, _, _), -0.0012398831049162415) :- done_served(Child), allergic_gluten(Child), !.
delta(75, move_tray(Tray, Place, Place2), 0.01153371489320334) :- at(Tray, Place3), could_serve_sandwich_no_gluten(Tray, Place3), at(Tray2, Place), could_put_on_tray(Tray2, Place2), !.
delta(75, move_tray(Tray, _, _), -0.012000893442050823) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(75, move_tray(Tray, _, Place), 0.0007967376729448586) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(75, move_tray(_, _, _), -0.07589801926928944) :- !.
delta(75, _, 0.0).

% tree 76: step size 1.0, 237 examples, 24 leaves
delta(76, make_sandwich_no_gluten(_, _, _), 0.0009574146645180728) :- no_gluten_sandwich(_), !.
delta(76, make_sandwich_no_gluten(_, _, _), -0.09308756230999868) :- fewer_at_1_than_allergic_gluten, !.
delta(76, make_sandwich_no_gluten(_, _, _), 0.00012228101922912647) :- !.
delta(76, make_sandwich(_, _, _), -0.008982909318841275) :- at_kitchen_sandwich(_), !.
delta(76, make_sandwich(_, Bread_portion, _), -0.0029171380300307666) :- no_gluten_bread(Bread_portion), !.
delta(76, make_sandwich(_, _, _), 0.10565546963322281) :- fewer_ontray_1_than_allergic_gluten, !.
delta(76, make_sandwich(_, _, _), 0.0005573200568434919) :- !.
delta(76, put_on_tray(_, _), 0.02015739225275746) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(76, put_on_tray(Sandwich, _), 0.001437058246852363) :- no_gluten_sandwich(Sandwich), !.
delta(76, put_on_tray(_, _), -0.0014325245449475473) :- !.
delta(76, serve_sandwich_no_gluten(_, _, _, _), 0.008260868486268436) :- !.
delta(76, serve_sandwich(_, Child, _, Place), 3.6326761629183337e-5) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), todo_served(Child3), allergic_gluten(Child3), !.
delta(76, serve_sandwich(_, Child, _, Place), 0.001805295244409955) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(76, serve_sandwich(_, _, _, Place), -0.0007245027101659155) :- done_served(Child), waiting(Child, Place), !.
delta(76, serve_sandwich(_, _, _, _), -0.09379095798215335) :- !.
delta(76, move_tray(Tray, _, Place), -0.007664408489701385) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_put_on_tray(Tray2, Place), fewer_ontray_2_than_allergic_gluten, !.
delta(76, move_tray(Tray, _, Place), 0.009516495420805472) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_put_on_tray(Tray2, Place), !.
delta(76, move_tray(Tray, _, _), -0.02030455300245971) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(76, move_tray(Tray, _, _), 6.47219043997195e-5) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(76, move_tray(_, Place, _), -0.0005268043606330357) :- not_allergic_gluten(Child), waiting(Child, Place), at_kitchen_bread(_), !.
delta(76, move_tray(_, Place, _), 0.09836435954941992) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(76, move_tray(_, _, _), -0.002953529078234468) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(76, move_tray(_, _, _), 0.0004942052207298612) :- !.
delta(76, _, 0.0).

% tree 77: step size 1.0, 218 examples, 21 leaves
delta(77, make_sandwich_no_gluten(_, _, _), 0.04662173531026718) :- !.
delta(77, make_sandwich(_, _, _), -0.06949336220938207) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(77, make_sandwich(_, _, _), -0.00034250876407751875) :- fewer_ontray_2_than_allergic_gluten, !.
delta(77, make_sandwich(_, _, _), -0.00021240209506792892) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(77, make_sandwich(_, _, _), 0.0) :- goal_served(Child), done_served(Child), !.
delta(77, make_sandwich(_, _, _), 0.011459896902961281) :- !.
delta(77, put_on_tray(_, _), 0.005575789064032719) :- !.
delta(77, serve_sandwich_no_gluten(_, _, _, _), 0.0018530359620001578) :- !.
delta(77, serve_sandwich(_, _, _, _), 0.10524793690162952) :- at_kitchen_sandwich(_), !.
delta(77, serve_sandwich(_, _, _, _), 1.5996647796407547e-5) :- notexist(_), fewer_ontray_1_than_todo_served, !.
delta(77, serve_sandwich(_, _, _, _), 0.03351083631589281) :- notexist(_), !.
delta(77, serve_sandwich(_, _, _, Place), -0.026777123086128476) :- done_served(Child), waiting(Child, Place), !.
delta(77, serve_sandwich(_, _, _, _), 0.0013137811010238002) :- !.
delta(77, move_tray(_, Place, _), 2.427327479980984e-5) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(77, move_tray(_, Place, _), -0.13805119781781333) :- todo_served(Child), waiting(Child, Place), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(77, move_tray(_, Place, _), -6.590180434946029e-5) :- todo_served(Child), waiting(Child, Place), !.
delta(77, move_tray(_, Place, Place2), -0.03484397646612456) :- needed_at_to_serve_sandwich_no_gluten(Place2), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(77, move_tray(_, _, Place), 0.022197517960265804) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(77, move_tray(_, _, _), 0.04909163863616366) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(77, move_tray(_, _, _), -0.004208496927757917) :- !.
delta(77, _, 0.0).

% tree 78: step size 1.0, 203 examples, 32 leaves
delta(78, make_sandwich_no_gluten(_, _, _), 0.0006498553783092818) :- no_gluten_sandwich(_), !.
delta(78, make_sandwich_no_gluten(_, _, _), -0.13871524998937806) :- fewer_at_1_than_not_allergic_gluten, !.
delta(78, make_sandwich_no_gluten(_, _, _), 0.00027773461216000993) :- !.
delta(78, make_sandwich(_, Bread_portion, _), -0.004767066245991414) :- at_kitchen_bread(Bread_portion2), no_gluten_bread(Bread_portion2), no_gluten_bread(Bread_portion), !.
delta(78, make_sandwich(_, _, Content_portion), -0.00292967265025202) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), no_gluten_content(Content_portion), !.
delta(78, make_sandwich(_, _, _), 0.16924244714370199) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(78, make_sandwich(_, _, _), -0.05631398304545343) :- fewer_ontray_2_than_allergic_gluten, !.
delta(78, make_sandwich(_, _, _), 0.015535912434805227) :- at_kitchen_sandwich(_), !.
delta(78, make_sandwich(_, _, _), -0.003205141461481244) :- !.
delta(78, put_on_tray(_, _), -0.012798099491297945) :- done_served(Child), allergic_gluten(Child), at_kitchen_bread(_), !.
delta(78, put_on_tray(_, _), 0.0017436290765566228) :- done_served(Child), allergic_gluten(Child), !.
delta(78, put_on_tray(_, _), 0.005727044818073878) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(78, put_on_tray(Sandwich, _), 0.0011502196837075765) :- no_gluten_sandwich(Sandwich), !.
delta(78, put_on_tray(_, _), -0.001189261745581509) :- !.
delta(78, serve_sandwich_no_gluten(_, Child, _, _), 0.010346897337411646) :- todo_served(Child), !.
delta(78, serve_sandwich_no_gluten(_, _, _, _), -0.17124253737792822) :- !.
delta(78, serve_sandwich(_, _, _, Place), 0.008834693665682123) :- notexist(_), done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), !.
delta(78, serve_sandwich(_, _, _, _), -0.015268846953090278) :- notexist(_), done_served(Child), not_allergic_gluten(Child), !.
delta(78, serve_sandwich(_, _, _, _), 0.005303661483732863) :- notexist(_), todo_served(Child), allergic_gluten(Child), !.
delta(78, serve_sandwich(_, _, _, _), -0.19536586956998747) :- notexist(_), !.
delta(78, serve_sandwich(_, Child, _, _), 0.018957152000953183) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(78, serve_sandwich(_, _, _, _), -0.00027725465767001735) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(78, serve_sandwich(Sandwich, _, _, _), -1.0068397034807235e-5) :- no_gluten_sandwich(Sandwich), !.
delta(78, serve_sandwich(_, _, _, _), 0.00037707967711134263) :- !.
delta(78, move_tray(Tray, Place, Place2), 0.0170807835787313) :- notexist(_), allergic_gluten(Child), waiting(Child, Place2), could_put_on_tray(Tray, Place), !.
delta(78, move_tray(_, _, Place), -0.037196130294015764) :- notexist(_), allergic_gluten(Child), waiting(Child, Place), !.
delta(78, move_tray(_, _, _), -0.0005497468146998284) :- notexist(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(78, move_tray(_, _, _), 0.3830899315724291) :- notexist(_), !.
delta(78, move_tray(_, Place, _), -0.0331069269663516) :- todo_served(Child), waiting(Child, Place), !.
delta(78, move_tray(_, _, Place), -0.0064849123315963) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(78, move_tray(_, _, _), 0.010161580594065592) :- !.
delta(78, _, 0.0).

% tree 79: step size 1.0, 219 examples, 29 leaves
delta(79, make_sandwich_no_gluten(_, _, _), 0.08309418920343309) :- todo_served(Child), allergic_gluten(Child), !.
delta(79, make_sandwich_no_gluten(_, _, _), 0.0008424737846030254) :- at_kitchen_sandwich(_), !.
delta(79, make_sandwich_no_gluten(_, _, _), -0.01074897521188226) :- !.
delta(79, make_sandwich(_, _, _), 0.00080273126347353) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(79, make_sandwich(_, _, _), -0.11062730850040572) :- fewer_at_2_than_allergic_gluten, !.
delta(79, make_sandwich(_, _, _), -0.007577872439928412) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(79, make_sandwich(_, _, _), -0.0005762609326226727) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(79, make_sandwich(_, _, _), 0.032902925674841196) :- !.
delta(79, put_on_tray(_, _), -0.030723532970510874) :- fewer_at_1_than_todo_served, !.
delta(79, put_on_tray(_, _), 0.00200481559808674) :- !.
delta(79, serve_sandwich_no_gluten(Sandwich, _, _, Place), -0.12286558089854083) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), notexist(_), !.
delta(79, serve_sandwich_no_gluten(Sandwich, _, _, Place), 6.394970052124467e-5) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(79, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- at_kitchen_bread(_), !.
delta(79, serve_sandwich_no_gluten(_, _, _, _), 0.00016002477051442178) :- !.
delta(79, serve_sandwich(_, Child, _, _), 0.1449612157999081) :- at_kitchen_sandwich(_), todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(79, serve_sandwich(_, Child, _, _), -7.936106286495908e-6) :- at_kitchen_sandwich(_), todo_served(Child), !.
delta(79, serve_sandwich(_, _, _, _), -0.00027937206689679844) :- at_kitchen_sandwich(_), !.
delta(79, serve_sandwich(_, Child, _, _), 0.02467817892800871) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(79, serve_sandwich(_, _, _, _), -0.0009067937148603214) :- goal_served(Child), done_served(Child), !.
delta(79, serve_sandwich(_, _, _, _), 0.006584521967848068) :- todo_served(Child), allergic_gluten(Child), !.
delta(79, serve_sandwich(_, _, _, _), -0.17761233048689243) :- !.
delta(79, move_tray(_, Place, _), -0.06539415903613854) :- at_kitchen_sandwich(_), todo_served(Child), waiting(Child, Place), !.
delta(79, move_tray(_, _, _), 0.01852358588160145) :- at_kitchen_sandwich(_), goal_served(Child), allergic_gluten(Child), !.
delta(79, move_tray(_, _, _), -0.0008772901686222781) :- at_kitchen_sandwich(_), !.
delta(79, move_tray(_, Place, _), -0.036151004137868176) :- goal_served(Child), done_served(Child), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(79, move_tray(_, _, _), 0.004110374319677009) :- goal_served(Child), done_served(Child), !.
delta(79, move_tray(_, Place, Place2), 0.23843984267995755) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(79, move_tray(_, _, _), -0.0077596990788328605) :- !.
delta(79, _, 0.0).

% tree 80: step size 1.0, 250 examples, 26 leaves
delta(80, make_sandwich_no_gluten(_, _, _), 0.11740425170204719) :- !.
delta(80, make_sandwich(_, _, _), 0.002312747240573631) :- fewer_ontray_2_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(80, make_sandwich(_, _, _), -0.002534172609341227) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(80, make_sandwich(_, _, _), -0.17030241855082878) :- fewer_ontray_2_than_allergic_gluten, !.
delta(80, make_sandwich(_, _, _), -0.006824526405847785) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(80, make_sandwich(_, _, _), 0.003272556512113429) :- todo_served(Child), allergic_gluten(Child), !.
delta(80, make_sandwich(_, _, _), 0.1600360316740189) :- !.
delta(80, put_on_tray(_, _), 0.00819021478245054) :- fewer_ontray_1_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(80, put_on_tray(_, _), -7.838977744313936e-5) :- fewer_ontray_1_than_todo_served, !.
delta(80, put_on_tray(_, _), -0.002857618182238958) :- !.
delta(80, serve_sandwich_no_gluten(_, _, _, _), -0.09289340901660852) :- done_served(Child), allergic_gluten(Child), !.
delta(80, serve_sandwich_no_gluten(_, _, _, _), 0.008213256102375917) :- !.
delta(80, serve_sandwich(_, Child, _, _), 0.0014449333787843238) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(80, serve_sandwich(_, Child, _, _), 0.0) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), !.
delta(80, serve_sandwich(_, _, _, _), -0.0002648375576135286) :- fewer_ontray_2_than_allergic_gluten, !.
delta(80, serve_sandwich(_, _, _, _), -0.17568047059769307) :- notexist(_), !.
delta(80, serve_sandwich(_, Child, _, _), 0.0002703701075761911) :- todo_served(Child), !.
delta(80, serve_sandwich(_, _, _, _), -1.8743069889734364e-5) :- !.
delta(80, move_tray(Tray, _, Place), 0.006693456739615656) :- fewer_ontray_1_than_todo_served, fewer_at_2_than_todo_served_allergic_gluten, could_serve_sandwich_no_gluten(Tray, Place), !.
delta(80, move_tray(_, _, _), -0.0008929999137313528) :- fewer_ontray_1_than_todo_served, fewer_at_2_than_todo_served_allergic_gluten, !.
delta(80, move_tray(_, _, Place), -0.03429894199759742) :- fewer_ontray_1_than_todo_served, needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(80, move_tray(_, _, _), 0.004744166878346323) :- fewer_ontray_1_than_todo_served, !.
delta(80, move_tray(_, _, kitchen), -0.008012740045136761) :- !.
delta(80, move_tray(_, Place, _), 0.1367616105764957) :- goal_served(Child), waiting(Child, Place), !.
delta(80, move_tray(_, _, _), -0.0015654442398016733) :- !.
delta(80, _, 0.0).

% tree 81: step size 1.0, 201 examples, 26 leaves
delta(81, make_sandwich_no_gluten(_, _, _), 0.09592998759058619) :- !.
delta(81, make_sandwich(_, _, _), -0.11884288475624387) :- fewer_ontray_2_than_allergic_gluten, !.
delta(81, make_sandwich(_, _, _), -6.597337153905381e-5) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(81, make_sandwich(_, _, _), 0.018307348447684405) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(81, make_sandwich(_, _, _), -6.963617718380324e-5) :- !.
delta(81, put_on_tray(_, Tray), -0.005592306027552078) :- ontray(_, Tray), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(81, put_on_tray(_, Tray), 0.01140752881323308) :- ontray(_, Tray), fewer_ontray_1_than_todo_served, !.
delta(81, put_on_tray(_, Tray), -0.0021342080277586117) :- ontray(_, Tray), !.
delta(81, put_on_tray(_, _), -0.017264114433058055) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(81, put_on_tray(_, _), 5.581937938400443e-5) :- !.
delta(81, serve_sandwich_no_gluten(_, _, _, _), -0.008432420357687716) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(81, serve_sandwich_no_gluten(_, Child, _, _), 0.01471702772007165) :- todo_served(Child), !.
delta(81, serve_sandwich_no_gluten(_, _, _, _), -0.004752753186520909) :- !.
delta(81, serve_sandwich(_, _, _, _), -0.20984481143783693) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(81, serve_sandwich(Sandwich, _, _, _), -0.0542830480497679) :- goal_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(81, serve_sandwich(_, _, _, _), 0.04857945414230766) :- goal_served(Child), allergic_gluten(Child), !.
delta(81, serve_sandwich(_, Child, _, _), 0.01758597804445756) :- todo_served(Child), !.
delta(81, serve_sandwich(_, _, _, _), -0.00010391411569795199) :- !.
delta(81, move_tray(_, Place, _), 0.21395745821001572) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child), waiting(Child, Place), goal_served(Child2), allergic_gluten(Child2), !.
delta(81, move_tray(_, Place, _), -2.062069499979686e-5) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child), waiting(Child, Place), !.
delta(81, move_tray(_, _, _), -0.0036523220108285346) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(81, move_tray(_, Place, _), -0.002684137510389216) :- done_served(Child), not_allergic_gluten(Child), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(81, move_tray(_, _, _), 0.006734927753387609) :- done_served(Child), not_allergic_gluten(Child), !.
delta(81, move_tray(Tray, _, _), -0.022123109370984488) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(81, move_tray(_, _, _), 0.004576993596137179) :- !.
delta(81, _, 0.0).

% tree 82: step size 1.0, 225 examples, 26 leaves
delta(82, make_sandwich_no_gluten(_, _, _), 0.04401939517677069) :- !.
delta(82, make_sandwich(_, _, _), -0.07818188416642435) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(82, make_sandwich(_, _, _), 4.2486885244988336e-5) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(82, make_sandwich(_, Bread_portion, _), -0.0010603014369403893) :- no_gluten_bread(Bread_portion), !.
delta(82, make_sandwich(_, _, _), 0.003196889095337826) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(82, make_sandwich(_, _, _), -3.0640516221640953e-6) :- !.
delta(82, put_on_tray(_, _), 0.0019530241840721794) :- goal_served(Child), allergic_gluten(Child), fewer_at_1_than_allergic_gluten, !.
delta(82, put_on_tray(_, _), 8.991868497823716e-6) :- goal_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(82, put_on_tray(_, _), -0.03605046506461262) :- goal_served(Child), allergic_gluten(Child), !.
delta(82, put_on_tray(_, _), 0.00916847209945695) :- !.
delta(82, serve_sandwich_no_gluten(_, _, _, _), 0.00033625336111082994) :- !.
delta(82, serve_sandwich(_, _, _, _), -0.0035010124679009528) :- notexist(_), at_kitchen_sandwich(_), !.
delta(82, serve_sandwich(_, _, _, _), 0.02748144545099056) :- notexist(_), goal_served(Child), done_served(Child), !.
delta(82, serve_sandwich(_, _, _, _), 0.0) :- notexist(_), !.
delta(82, serve_sandwich(_, _, _, _), -0.2451136821216258) :- fewer_ontray_2_than_todo_served, goal_served(Child), done_served(Child), !.
delta(82, serve_sandwich(_, _, _, _), 0.00024281771940390143) :- fewer_ontray_2_than_todo_served, !.
delta(82, serve_sandwich(_, _, _, _), 0.0003670516519094018) :- !.
delta(82, move_tray(Tray, _, Place), 0.018340401534022485) :- notexist(_), at(Tray, Place2), could_serve_sandwich(Tray, Place2), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(82, move_tray(Tray, _, _), -0.06653899440584259) :- notexist(_), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(82, move_tray(_, Place, Place2), -0.018117293575553174) :- notexist(_), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(82, move_tray(_, _, _), 0.05563627036822278) :- notexist(_), !.
delta(82, move_tray(_, Place, Place2), 0.005012603099620353) :- done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(82, move_tray(_, Place, _), -0.01171153834229068) :- done_served(Child), waiting(Child, Place), !.
delta(82, move_tray(_, Place, Place2), -0.003934788851352798) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(82, move_tray(_, _, _), 0.30277159517845437) :- !.
delta(82, _, 0.0).

% tree 83: step size 1.0, 207 examples, 27 leaves
delta(83, make_sandwich_no_gluten(_, _, _), 0.053883955366223577) :- fewer_at_1_than_not_allergic_gluten, !.
delta(83, make_sandwich_no_gluten(_, _, _), 0.0002588040795694925) :- !.
delta(83, make_sandwich(_, _, _), 0.0005377391970116527) :- goal_served(Child), done_served(Child), !.
delta(83, make_sandwich(_, _, _), -0.00037580601732820415) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(83, make_sandwich(_, _, _), 0.0006747181012875327) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(83, make_sandwich(_, _, _), -0.057075981773552435) :- !.
delta(83, put_on_tray(_, Tray), 0.012351612679682879) :- ontray(_, Tray), fewer_ontray_1_than_todo_served, !.
delta(83, put_on_tray(_, Tray), -0.00014739888176851297) :- ontray(_, Tray), !.
delta(83, put_on_tray(_, _), -6.482378372365044e-5) :- notexist(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(83, put_on_tray(_, _), 0.0032956625794378345) :- notexist(_), !.
delta(83, put_on_tray(_, _), -0.02211322125131347) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(83, put_on_tray(_, _), 0.00024500846941703704) :- !.
delta(83, serve_sandwich_no_gluten(_, _, _, _), 0.0007481886843886057) :- !.
delta(83, serve_sandwich(_, _, _, Place), 2.048141290338267e-6) :- allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_todo_served, at_kitchen_bread(_), !.
delta(83, serve_sandwich(_, _, _, Place), -0.20921503269964223) :- allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_todo_served, !.
delta(83, serve_sandwich(_, _, _, Place), 0.011120427194675063) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(83, serve_sandwich(_, Child, _, _), 0.08118199452420904) :- todo_served(Child), !.
delta(83, serve_sandwich(_, _, _, _), -0.000566298535722132) :- !.
delta(83, move_tray(_, _, _), -0.001283586044060611) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_2_than_todo_served_not_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(83, move_tray(_, _, _), 0.2321593224776765) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(83, move_tray(Tray, _, _), 0.005551363836626741) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at(Tray, kitchen), !.
delta(83, move_tray(_, _, _), -0.024632550821991357) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(83, move_tray(_, Place, Place2), -2.896484116553574e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(Tray2, Place), could_serve_sandwich_no_gluten(Tray2, Place), !.
delta(83, move_tray(_, Place, Place2), 0.0042228248140976) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(83, move_tray(_, _, _), -0.10123475270269224) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(83, move_tray(_, _, _), 0.00047693038059733455) :- !.
delta(83, _, 0.0).

% tree 84: step size 1.0, 231 examples, 26 leaves
delta(84, make_sandwich_no_gluten(_, _, _), 0.015895540705706927) :- !.
delta(84, make_sandwich(_, _, _), -6.742942980764065e-6) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(84, make_sandwich(_, _, _), -0.033948950803180555) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(84, make_sandwich(_, _, _), -8.807879377612684e-5) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(84, make_sandwich(_, _, _), 0.05700421709541919) :- !.
delta(84, put_on_tray(_, Tray), -0.05466443399496387) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(84, put_on_tray(_, Tray), 0.008799248706261942) :- ontray(_, Tray), fewer_ontray_1_than_todo_served, !.
delta(84, put_on_tray(_, Tray), -0.00054498610364252) :- ontray(_, Tray), !.
delta(84, put_on_tray(_, _), -0.0005809598567476379) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(84, put_on_tray(_, _), 0.012242626488536504) :- !.
delta(84, serve_sandwich_no_gluten(_, _, _, _), -0.012873074343394793) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(84, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- done_served(Child), not_allergic_gluten(Child), !.
delta(84, serve_sandwich_no_gluten(_, _, _, _), 0.00251769834889595) :- !.
delta(84, serve_sandwich(_, _, _, _), 5.224316663605369e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(84, serve_sandwich(Sandwich, _, _, Place), -0.00017630272293245005) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(84, serve_sandwich(_, Child, _, _), 0.024139445601821585) :- todo_served(Child), !.
delta(84, serve_sandwich(_, _, _, _), -0.00015805301005294758) :- !.
delta(84, move_tray(_, Place, Place2), -0.010612573819009301) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place2), !.
delta(84, move_tray(_, Place, _), 0.0036293571637031345) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), waiting(Child, Place), !.
delta(84, move_tray(Tray, _, _), 0.01347268064216887) :- fewer_ontray_1_than_allergic_gluten, ontray(_, Tray), !.
delta(84, move_tray(_, _, _), -5.5479754275112437e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(84, move_tray(_, _, Place), -2.35787421898755e-6) :- at(Tray, Place), could_serve_sandwich(Tray, Place), goal_served(Child), done_served(Child), !.
delta(84, move_tray(_, _, Place), 0.005015914040968073) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(84, move_tray(_, Place, _), 0.002839348237262) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(84, move_tray(_, _, _), -0.04779496620051178) :- !.
delta(84, _, 0.0).

% tree 85: step size 1.0, 230 examples, 21 leaves
delta(85, make_sandwich_no_gluten(_, _, _), 0.00715270171109952) :- !.
delta(85, make_sandwich(_, _, Content_portion), -0.030958241540828317) :- no_gluten_content(Content_portion), !.
delta(85, make_sandwich(_, _, _), 0.00012948273457959677) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(85, make_sandwich(_, _, _), 0.021617535559429406) :- fewer_at_1_than_allergic_gluten, !.
delta(85, make_sandwich(_, _, _), 0.0008355437839786863) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(85, make_sandwich(_, _, _), -0.012103745910077601) :- !.
delta(85, put_on_tray(_, _), 0.022771984778611504) :- fewer_ontray_1_than_todo_served, !.
delta(85, put_on_tray(_, _), -0.002217692763384009) :- !.
delta(85, serve_sandwich_no_gluten(_, _, _, _), 0.0006037481730095682) :- !.
delta(85, serve_sandwich(_, _, _, _), -0.25062034741942) :- at_kitchen_sandwich(_), !.
delta(85, serve_sandwich(_, Child, _, Place), 0.014662833570102602) :- todo_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(85, serve_sandwich(_, Child, _, _), -5.449289704692442e-5) :- todo_served(Child), !.
delta(85, serve_sandwich(_, _, _, _), -0.0008020583157929908) :- !.
delta(85, move_tray(_, Place, Place2), 0.003121606175337987) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), at(Tray2, Place2), could_put_on_tray(Tray2, Place), !.
delta(85, move_tray(_, Place, Place2), -0.05251545711209129) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_at_2_than_todo_served, !.
delta(85, move_tray(_, Place, Place2), 0.001202414908196353) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(85, move_tray(_, _, _), 0.2851227154394026) :- fewer_at_1_than_todo_served, goal_served(Child), allergic_gluten(Child), !.
delta(85, move_tray(_, _, _), -0.0008970341087601712) :- fewer_at_1_than_todo_served, !.
delta(85, move_tray(_, Place, _), -0.008326014393428317) :- todo_served(Child), waiting(Child, Place), !.
delta(85, move_tray(_, _, _), 0.0007176441588718137) :- !.
delta(85, _, 0.0).

% tree 86: step size 1.0, 231 examples, 28 leaves
delta(86, make_sandwich_no_gluten(_, _, _), 0.03766530985752992) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(86, make_sandwich_no_gluten(_, _, _), 0.0009681235806469864) :- fewer_at_2_than_allergic_gluten, !.
delta(86, make_sandwich_no_gluten(_, _, _), -0.08247484641071857) :- fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(86, make_sandwich_no_gluten(_, _, _), 2.1821879645850894e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(86, make_sandwich_no_gluten(_, _, _), 0.00015378173302217166) :- !.
delta(86, make_sandwich(_, _, _), -0.0011975736353739379) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(86, make_sandwich(_, _, _), 0.008282174565602454) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(86, make_sandwich(_, _, _), -0.0798260908109556) :- fewer_at_2_than_allergic_gluten, !.
delta(86, make_sandwich(_, _, Content_portion), -0.002342196932329338) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_content(Content_portion), !.
delta(86, make_sandwich(_, _, _), 0.08510289143174916) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(86, make_sandwich(_, _, _), -0.030844168065097176) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(86, make_sandwich(_, _, _), 0.004799393426473429) :- !.
delta(86, put_on_tray(_, _), -0.018350131051239692) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(86, put_on_tray(_, _), 4.03157390509327e-6) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(86, put_on_tray(_, _), 0.012156024558520743) :- !.
delta(86, serve_sandwich_no_gluten(_, Child, _, _), 0.003688568455863637) :- todo_served(Child), !.
delta(86, serve_sandwich_no_gluten(_, _, _, _), -0.005417375006658707) :- !.
delta(86, serve_sandwich(Sandwich, _, _, _), -0.03600527436620622) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(86, serve_sandwich(Sandwich, _, _, _), 0.006714447586150254) :- no_gluten_sandwich(Sandwich), !.
delta(86, serve_sandwich(_, Child, _, _), 0.112566318638099) :- todo_served(Child), !.
delta(86, serve_sandwich(_, _, _, _), -0.01684587892275665) :- !.
delta(86, move_tray(_, Place, _), 0.0) :- at(Tray, Place), could_serve_sandwich(Tray, Place), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(86, move_tray(_, Place, _), -0.12295204644911881) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(86, move_tray(_, Place, Place2), 0.0005798258711254154) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_not_allergic_gluten, !.
delta(86, move_tray(_, Place, Place2), -0.0061223488337039346) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(86, move_tray(Tray, _, _), 0.06323900502570538) :- ontray(_, Tray), !.
delta(86, move_tray(_, _, _), -0.0029417185312526745) :- !.
delta(86, _, 0.0).

% tree 87: step size 1.0, 225 examples, 32 leaves
delta(87, make_sandwich_no_gluten(_, _, _), 0.04074009580446135) :- fewer_at_2_than_allergic_gluten, !.
delta(87, make_sandwich_no_gluten(_, _, _), -0.08311976663721422) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(87, make_sandwich_no_gluten(_, _, _), 5.3318080591272744e-5) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(87, make_sandwich_no_gluten(_, _, _), 0.00012581483203293747) :- !.
delta(87, make_sandwich(_, _, _), -0.05906320950906019) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_ontray_2_than_not_allergic_gluten, !.
delta(87, make_sandwich(_, _, _), 2.7214783284066413e-5) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(87, make_sandwich(_, _, _), -0.01320863954982531) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(87, make_sandwich(_, _, _), 0.0030505692247081656) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(87, make_sandwich(_, _, Content_portion), -0.0022339231320135365) :- no_gluten_content(Content_portion), !.
delta(87, make_sandwich(_, _, _), 0.10631641560752653) :- !.
delta(87, put_on_tray(_, Tray), 0.013025889899449833) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(87, put_on_tray(_, Tray), -0.0015020881743602165) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(87, put_on_tray(_, _), -0.03272408259840895) :- fewer_at_2_than_todo_served, !.
delta(87, put_on_tray(_, _), 0.0018468758629021438) :- !.
delta(87, serve_sandwich_no_gluten(_, _, _, _), 0.0) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(87, serve_sandwich_no_gluten(_, _, _, _), 0.00024079561044715786) :- !.
delta(87, serve_sandwich(_, _, _, _), -0.0022172134765078527) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(87, serve_sandwich(_, Child, _, _), 0.0585576260123628) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), !.
delta(87, serve_sandwich(_, _, _, _), -0.00045461879944416544) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(87, serve_sandwich(Sandwich, _, _, _), -0.024554777372847718) :- goal_served(Child), allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(87, serve_sandwich(_, _, _, _), 0.02252190552696587) :- goal_served(Child), allergic_gluten(Child), !.
delta(87, serve_sandwich(_, _, _, _), -0.042356808482310715) :- notexist(_), !.
delta(87, serve_sandwich(_, _, _, _), 6.733688082269384e-5) :- !.
delta(87, move_tray(_, _, Place), 0.1019235157626495) :- allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(87, move_tray(_, _, Place), -0.0005591864659966882) :- allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(87, move_tray(_, _, Place), -0.0076824040681191304) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(87, move_tray(_, _, Place), 0.004030422317090027) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(87, move_tray(_, Place, _), -0.1480912452781762) :- fewer_ontray_1_than_not_allergic_gluten, not_allergic_gluten(Child), waiting(Child, Place), !.
delta(87, move_tray(_, _, _), 0.00842491456824427) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(87, move_tray(Tray, _, Place), 0.043365345267505906) :- could_serve_sandwich(Tray, Place), !.
delta(87, move_tray(_, _, _), -0.008571019729008809) :- !.
delta(87, _, 0.0).

% tree 88: step size 1.0, 217 examples, 22 leaves
delta(88, make_sandwich_no_gluten(_, _, _), 0.01621114318890148) :- !.
delta(88, make_sandwich(_, _, _), 0.016394426664828685) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_allergic_gluten, !.
delta(88, make_sandwich(_, _, _), -0.0002444265277342245) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(88, make_sandwich(_, _, _), 0.0005658915777831271) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(88, make_sandwich(_, _, _), -0.03326239313960758) :- !.
delta(88, put_on_tray(_, _), -0.025749913170027974) :- fewer_ontray_1_than_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, notexist(_), !.
delta(88, put_on_tray(_, _), 0.0001210438156674539) :- fewer_ontray_1_than_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(88, put_on_tray(_, _), 0.0005865762318353342) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(88, put_on_tray(_, _), 0.00294197038392874) :- !.
delta(88, serve_sandwich_no_gluten(_, _, _, _), 0.0028127182702961766) :- !.
delta(88, serve_sandwich(Sandwich, _, _, Place), -0.002928256090321778) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(88, serve_sandwich(_, Child, _, _), 0.0317250566773778) :- todo_served(Child), !.
delta(88, serve_sandwich(_, _, _, _), -0.00030268004193464905) :- !.
delta(88, move_tray(Tray, Place, Place2), 0.004126878134760363) :- todo_served(Child), waiting(Child, Place), at(_, Place2), could_serve_sandwich(Tray, Place2), !.
delta(88, move_tray(_, Place, Place2), -0.000809195073343442) :- todo_served(Child), waiting(Child, Place), at(_, Place2), !.
delta(88, move_tray(_, Place, _), 8.153537300967131e-5) :- todo_served(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(88, move_tray(_, Place, _), -0.05378737186096525) :- todo_served(Child), waiting(Child, Place), !.
delta(88, move_tray(_, _, Place), -0.0006007688114295904) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(88, move_tray(_, _, _), 0.028237728924338307) :- done_served(Child), not_allergic_gluten(Child), !.
delta(88, move_tray(_, Place, Place2), 0.00039582205033382385) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(88, move_tray(_, _, _), -0.006399345445259839) :- !.
delta(88, _, 0.0).

% tree 89: step size 1.0, 222 examples, 26 leaves
delta(89, make_sandwich_no_gluten(_, _, _), 0.009817333422547083) :- !.
delta(89, make_sandwich(_, _, _), -0.0008031590530528386) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(89, make_sandwich(_, _, _), 0.18474067340984898) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(89, make_sandwich(_, _, _), -0.003892560742280338) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(89, make_sandwich(_, _, _), 0.006649980022843897) :- done_served(Child), not_allergic_gluten(Child), !.
delta(89, make_sandwich(_, _, _), -0.02556973956688427) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(89, make_sandwich(_, _, _), 0.002106910689277821) :- !.
delta(89, put_on_tray(_, _), 0.0005459527944819994) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(89, put_on_tray(_, _), -0.18443736853333845) :- fewer_ontray_1_than_todo_served_allergic_gluten, at_kitchen_bread(_), !.
delta(89, put_on_tray(_, _), 6.0329407865201695e-6) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(89, put_on_tray(_, _), 0.02612127913429206) :- fewer_ontray_1_than_todo_served, !.
delta(89, put_on_tray(_, _), -0.0005425170803589832) :- !.
delta(89, serve_sandwich_no_gluten(_, Child, _, _), 0.00297897422442915) :- todo_served(Child), !.
delta(89, serve_sandwich_no_gluten(_, _, _, _), -0.0021228811339567603) :- !.
delta(89, serve_sandwich(_, Child, _, _), -1.52393348483064e-5) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(89, serve_sandwich(_, Child, _, _), 0.03992754178372415) :- todo_served(Child), !.
delta(89, serve_sandwich(_, _, _, _), -0.00013757935296776323) :- !.
delta(89, move_tray(Tray, _, Place), -0.1202788819759829) :- done_served(Child), waiting(Child, Place), ontray(_, Tray), not_allergic_gluten(Child), !.
delta(89, move_tray(Tray, _, Place), 0.010032325507056341) :- done_served(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(89, move_tray(_, _, Place), 0.02877948074943534) :- done_served(Child), waiting(Child, Place), todo_served(Child2), allergic_gluten(Child2), !.
delta(89, move_tray(_, _, Place), -0.003017101308854921) :- done_served(Child), waiting(Child, Place), !.
delta(89, move_tray(_, _, _), 0.07210782410634703) :- at_kitchen_bread(_), done_served(Child), not_allergic_gluten(Child), !.
delta(89, move_tray(_, _, _), -0.016650590419493586) :- at_kitchen_bread(_), !.
delta(89, move_tray(_, Place, Place2), 0.00021415080393986688) :- at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(89, move_tray(_, _, _), -0.03438723063839253) :- !.
delta(89, _, 0.0).

% tree 90: step size 1.0, 201 examples, 26 leaves
delta(90, make_sandwich_no_gluten(_, _, _), 0.028394510724418103) :- fewer_at_1_than_allergic_gluten, !.
delta(90, make_sandwich_no_gluten(_, _, _), 0.0006997581570138996) :- !.
delta(90, make_sandwich(_, _, _), -0.04589815410478412) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(90, make_sandwich(_, _, _), -0.0005455376716957757) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(90, make_sandwich(_, _, _), 0.0021585678223899874) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(90, make_sandwich(_, _, _), -0.0001819334145065411) :- !.
delta(90, put_on_tray(_, _), 0.008770139731756221) :- notexist(_), !.
delta(90, put_on_tray(_, _), -0.04123240613617937) :- todo_served(Child), not_allergic_gluten(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(90, put_on_tray(_, _), 0.0007428040243291364) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(90, put_on_tray(Sandwich, _), 0.0027810787128790125) :- no_gluten_sandwich(Sandwich), !.
delta(90, put_on_tray(_, _), -0.0006677800750429135) :- !.
delta(90, serve_sandwich_no_gluten(_, _, _, _), 0.004333435845543948) :- !.
delta(90, serve_sandwich(_, _, Tray, _), -6.6302636025270135e-6) :- at_kitchen_bread(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(90, serve_sandwich(_, _, _, _), 0.04289737631839608) :- at_kitchen_bread(_), !.
delta(90, serve_sandwich(_, _, _, _), 0.019685319411943875) :- fewer_ontray_1_than_allergic_gluten, !.
delta(90, serve_sandwich(_, _, _, _), 0.011153486947522018) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(90, serve_sandwich(_, _, _, _), -0.052487344589276376) :- !.
delta(90, move_tray(_, _, Place), 0.03849690130052954) :- done_served(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place), not_allergic_gluten(Child), !.
delta(90, move_tray(_, _, Place), -0.018376218868883073) :- done_served(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(90, move_tray(_, _, Place), -0.07672238476332757) :- done_served(Child), waiting(Child, Place), waiting(Child, Place2), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(90, move_tray(_, _, Place), 0.009018358374056809) :- done_served(Child), waiting(Child, Place), !.
delta(90, move_tray(_, Place, _), 0.008533987613320937) :- at_kitchen_bread(_), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(90, move_tray(_, _, _), -0.030145845772018266) :- at_kitchen_bread(_), !.
delta(90, move_tray(_, _, Place), -0.021346500458476195) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(90, move_tray(_, _, _), 0.12281922061316249) :- !.
delta(90, _, 0.0).

% tree 91: step size 1.0, 225 examples, 27 leaves
delta(91, make_sandwich_no_gluten(_, _, _), 0.03420707656861392) :- fewer_at_1_than_allergic_gluten, !.
delta(91, make_sandwich_no_gluten(_, _, _), 4.4626682507765467e-7) :- fewer_at_1_than_not_allergic_gluten, !.
delta(91, make_sandwich_no_gluten(_, _, _), 0.001049237140884351) :- !.
delta(91, make_sandwich(_, _, _), -0.06399764703770766) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(91, make_sandwich(_, _, _), 8.96858340538746e-6) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(91, make_sandwich(_, _, _), -0.0002659068460109719) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(91, make_sandwich(_, _, _), 0.04069489927943173) :- fewer_at_1_than_todo_served, !.
delta(91, make_sandwich(_, _, _), -1.5647683438217577e-5) :- !.
delta(91, put_on_tray(_, _), 0.02350252204127392) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(91, put_on_tray(_, _), -8.092245944759794e-5) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(91, put_on_tray(_, _), 0.00012084419020241747) :- goal_served(Child), done_served(Child), !.
delta(91, put_on_tray(_, _), -0.030613733033309564) :- !.
delta(91, serve_sandwich_no_gluten(_, _, _, _), 0.004473093147934263) :- !.
delta(91, serve_sandwich(_, _, Tray, _), -0.0003841536235650631) :- goal_served(Child), done_served(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(91, serve_sandwich(_, Child, _, _), 0.05014032002148851) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(91, serve_sandwich(_, _, _, _), -0.0002487351345186552) :- goal_served(Child), done_served(Child), !.
delta(91, serve_sandwich(_, _, _, _), -8.87185051392584e-5) :- no_gluten_bread(_), todo_served(Child), allergic_gluten(Child), !.
delta(91, serve_sandwich(_, _, _, _), 0.0006303431139358447) :- no_gluten_bread(_), !.
delta(91, serve_sandwich(_, _, _, _), -0.0020946397167177955) :- !.
delta(91, move_tray(_, _, Place), 0.04956207810512693) :- at(_, Place), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(91, move_tray(_, Place, Place2), 4.552666202424168e-6) :- at(_, Place2), at(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(91, move_tray(_, _, Place), -0.002491356408073988) :- at(_, Place), !.
delta(91, move_tray(Tray, _, Place), -0.012859206848524835) :- at(Tray, kitchen), allergic_gluten(Child), waiting(Child, Place), !.
delta(91, move_tray(Tray, _, _), 0.014835720191074033) :- at(Tray, kitchen), !.
delta(91, move_tray(_, _, Place), 0.0035832501192281027) :- done_served(Child), waiting(Child, Place), !.
delta(91, move_tray(_, _, _), -0.11929963229696917) :- !.
delta(91, _, 0.0).

% tree 92: step size 1.0, 208 examples, 27 leaves
delta(92, make_sandwich_no_gluten(_, _, _), 0.03535598828959186) :- fewer_at_2_than_allergic_gluten, !.
delta(92, make_sandwich_no_gluten(_, _, _), -0.08733049976801167) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(92, make_sandwich_no_gluten(_, _, _), 4.0410131668878675e-5) :- !.
delta(92, make_sandwich(_, _, _), -0.03338870999040406) :- no_gluten_bread(_), fewer_at_1_than_todo_served_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(92, make_sandwich(_, _, _), 0.012145053949888279) :- no_gluten_bread(_), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(92, make_sandwich(_, _, _), 0.08727078019585734) :- no_gluten_bread(_), fewer_ontray_2_than_not_allergic_gluten, !.
delta(92, make_sandwich(_, _, _), -0.0034865352654415527) :- no_gluten_bread(_), !.
delta(92, make_sandwich(_, _, _), -0.037465334217533175) :- at_kitchen_sandwich(_), !.
delta(92, make_sandwich(_, _, _), 1.3209774187609775e-5) :- !.
delta(92, put_on_tray(_, Tray), 0.00019166996880149744) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at_kitchen_sandwich(Sandwich2), no_gluten_sandwich(Sandwich2), !.
delta(92, put_on_tray(_, Tray), -0.03711060156882265) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(92, put_on_tray(_, _), 0.008305702222798984) :- !.
delta(92, serve_sandwich_no_gluten(_, _, _, _), 0.0023573371188088297) :- !.
delta(92, serve_sandwich(_, _, _, _), 0.027624965952102874) :- no_gluten_sandwich(_), fewer_ontray_1_than_allergic_gluten, !.
delta(92, serve_sandwich(_, _, _, _), -0.15539401404264566) :- no_gluten_sandwich(_), fewer_at_1_than_todo_served, !.
delta(92, serve_sandwich(_, _, _, _), 0.00135997808701738) :- no_gluten_sandwich(_), !.
delta(92, serve_sandwich(_, Child, _, _), 0.04081926494290476) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(92, serve_sandwich(_, Child, _, _), 5.819919471989952e-5) :- todo_served(Child), !.
delta(92, serve_sandwich(_, _, _, _), -0.00036668407217927963) :- !.
delta(92, move_tray(Tray, _, Place), 9.906828024564512e-5) :- fewer_ontray_1_than_allergic_gluten, could_serve_sandwich_no_gluten(Tray, Place), !.
delta(92, move_tray(_, _, _), -0.02801892797153254) :- fewer_ontray_1_than_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(92, move_tray(_, _, _), 2.317923525999843e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(92, move_tray(_, Place, Place2), -0.024784361303367464) :- goal_served(Child), allergic_gluten(Child), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(92, move_tray(_, _, _), 0.18939567234743487) :- goal_served(Child), allergic_gluten(Child), !.
delta(92, move_tray(Tray, _, _), 0.0012378915714025254) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(92, move_tray(_, _, _), -0.027372446238801168) :- !.
delta(92, _, 0.0).

% tree 93: step size 1.0, 220 examples, 27 leaves
delta(93, make_sandwich_no_gluten(_, _, _), 0.02106398992004077) :- !.
delta(93, make_sandwich(_, _, _), -0.04007602042160298) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(93, make_sandwich(_, _, _), -0.003940443314105646) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(93, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, !.
delta(93, make_sandwich(_, _, _), 0.0) :- done_served(Child), allergic_gluten(Child), !.
delta(93, make_sandwich(_, _, _), 0.030333524012908564) :- !.
delta(93, put_on_tray(_, _), 0.0) :- at_kitchen_bread(_), fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(93, put_on_tray(_, _), 0.00047936618167124435) :- at_kitchen_bread(_), fewer_ontray_1_than_allergic_gluten, !.
delta(93, put_on_tray(_, _), -0.009070673658481724) :- at_kitchen_bread(_), !.
delta(93, put_on_tray(_, Tray), 0.00979615931048106) :- ontray(_, Tray), !.
delta(93, put_on_tray(_, _), 1.739359179370773e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(93, put_on_tray(_, _), -0.000587447196656934) :- !.
delta(93, serve_sandwich_no_gluten(_, _, _, _), 0.00038631229844229663) :- !.
delta(93, serve_sandwich(_, _, _, _), -0.054236049862935294) :- fewer_at_1_than_allergic_gluten, !.
delta(93, serve_sandwich(_, Child, _, _), 0.06298189353083303) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), !.
delta(93, serve_sandwich(_, _, _, _), -0.00018072202258162922) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(93, serve_sandwich(_, Child, _, _), 0.00027085676741293033) :- todo_served(Child), !.
delta(93, serve_sandwich(_, _, _, _), -0.0002323966422578968) :- !.
delta(93, move_tray(_, Place, Place2), -0.01432930275766172) :- fewer_at_2_than_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_ontray_2_than_todo_served, !.
delta(93, move_tray(_, Place, Place2), 5.956775041176748e-5) :- fewer_at_2_than_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(93, move_tray(Tray, _, _), -0.00024239419635949344) :- fewer_at_2_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(93, move_tray(_, _, _), 0.06671934353069853) :- fewer_at_2_than_allergic_gluten, !.
delta(93, move_tray(_, _, Place), 0.0026921984032026764) :- at(Tray, Place), ontray(_, Tray), fewer_at_1_than_todo_served, !.
delta(93, move_tray(_, _, Place), -0.0011709838614308529) :- at(Tray, Place), ontray(_, Tray), !.
delta(93, move_tray(_, _, _), -0.09795889774466648) :- fewer_ontray_2_than_todo_served, !.
delta(93, move_tray(_, _, _), 0.0002845029354263507) :- !.
delta(93, _, 0.0).

% tree 94: step size 1.0, 229 examples, 20 leaves
delta(94, make_sandwich_no_gluten(_, _, _), 0.0180251205297278) :- !.
delta(94, make_sandwich(_, _, _), -0.06215859256535231) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(94, make_sandwich(_, _, _), 0.026053945849404608) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(94, make_sandwich(_, _, _), -0.0001537348854974433) :- fewer_ontray_2_than_allergic_gluten, !.
delta(94, make_sandwich(_, _, _), -0.0023913299174847928) :- at_kitchen_sandwich(_), !.
delta(94, make_sandwich(_, _, _), 0.0007525699464676135) :- !.
delta(94, put_on_tray(_, _), 0.010291856969953503) :- !.
delta(94, serve_sandwich_no_gluten(_, _, _, _), 0.002935122082116688) :- !.
delta(94, serve_sandwich(_, _, _, _), -0.1604925900437017) :- done_served(Child), allergic_gluten(Child), fewer_no_gluten_sandwich_than_todo_served, notexist(_), !.
delta(94, serve_sandwich(_, _, _, _), 0.0) :- done_served(Child), allergic_gluten(Child), fewer_no_gluten_sandwich_than_todo_served, !.
delta(94, serve_sandwich(_, _, _, _), 0.005570199377256692) :- done_served(Child), allergic_gluten(Child), !.
delta(94, serve_sandwich(_, Child, _, _), 0.013180908599979) :- todo_served(Child), !.
delta(94, serve_sandwich(_, _, _, _), -0.0003619131180343135) :- !.
delta(94, move_tray(Tray, Place, Place2), -0.0037231901227637964) :- allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place2), done_served(Child2), waiting(Child2, Place2), !.
delta(94, move_tray(Tray, Place, Place2), 0.18772452662913608) :- allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place2), !.
delta(94, move_tray(_, Place, _), -0.009401479174333423) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(94, move_tray(_, Place, Place2), 0.00041221854246436195) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(94, move_tray(_, _, _), -0.00025442941784564434) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(94, move_tray(_, _, _), -0.02626780750595376) :- !.
delta(94, _, 0.0).

% tree 95: step size 1.0, 212 examples, 29 leaves
delta(95, make_sandwich_no_gluten(_, _, _), 0.02763988900897616) :- !.
delta(95, make_sandwich(_, _, _), -0.00027908111491112893) :- at_kitchen_sandwich(_), no_gluten_sandwich(Sandwich), at_kitchen_sandwich(Sandwich), !.
delta(95, make_sandwich(_, _, _), 0.045683849163839906) :- at_kitchen_sandwich(_), no_gluten_sandwich(_), !.
delta(95, make_sandwich(_, _, _), -0.006288953622748652) :- at_kitchen_sandwich(_), !.
delta(95, make_sandwich(_, _, _), -0.06765254897575601) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(95, make_sandwich(_, _, _), 0.005283176593424014) :- fewer_ontray_1_than_todo_served, !.
delta(95, make_sandwich(_, _, _), -0.0006793870764230796) :- !.
delta(95, put_on_tray(Sandwich, _), 0.0013227372628715616) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(95, put_on_tray(_, _), -0.04217303576817319) :- fewer_at_1_than_allergic_gluten, !.
delta(95, put_on_tray(_, _), 0.01184456942228217) :- !.
delta(95, serve_sandwich_no_gluten(_, Child, _, _), 0.008113432372141755) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(95, serve_sandwich_no_gluten(_, _, _, _), -0.004354626079237983) :- goal_served(Child), done_served(Child), !.
delta(95, serve_sandwich_no_gluten(_, _, _, _), -0.00876126442461044) :- notexist(_), !.
delta(95, serve_sandwich_no_gluten(_, _, _, _), 0.00012275654289554846) :- !.
delta(95, serve_sandwich(_, _, Tray, _), -0.079890885386855) :- done_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, at(Tray, Place), waiting(Child, Place), !.
delta(95, serve_sandwich(_, _, _, _), 0.002772443093748237) :- done_served(Child), allergic_gluten(Child), fewer_at_2_than_todo_served, !.
delta(95, serve_sandwich(_, Child, _, _), 0.010252504344003186) :- done_served(Child2), allergic_gluten(Child2), todo_served(Child), !.
delta(95, serve_sandwich(_, _, _, _), -0.00028888914954090415) :- done_served(Child), allergic_gluten(Child), !.
delta(95, serve_sandwich(Sandwich, Child, _, _), -9.722793955145738e-5) :- todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(95, serve_sandwich(_, Child, _, _), 0.02823852065066536) :- todo_served(Child), !.
delta(95, serve_sandwich(_, _, _, _), -0.0004491718972496169) :- !.
delta(95, move_tray(_, _, Place), -0.009275894357743966) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(95, move_tray(_, _, Place), 0.14453071537062448) :- done_served(Child), waiting(Child, Place), goal_served(Child2), allergic_gluten(Child2), !.
delta(95, move_tray(_, _, Place), -0.0009229135429828838) :- done_served(Child), waiting(Child, Place), !.
delta(95, move_tray(_, Place, Place2), -0.01029913862525425) :- allergic_gluten(Child), waiting(Child, Place), allergic_gluten(Child2), waiting(Child2, Place2), !.
delta(95, move_tray(_, Place, _), 0.06426749829227639) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(95, move_tray(_, _, _), -0.00011217504838154126) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(95, move_tray(_, _, _), -0.12005953476028894) :- !.
delta(95, _, 0.0).

% tree 96: step size 1.0, 224 examples, 27 leaves
delta(96, make_sandwich_no_gluten(_, _, _), 0.017140318472748824) :- fewer_at_1_than_allergic_gluten, !.
delta(96, make_sandwich_no_gluten(_, _, _), 0.0009334520442718966) :- at_kitchen_sandwich(_), !.
delta(96, make_sandwich_no_gluten(_, _, _), -0.06182443547505343) :- fewer_at_2_than_allergic_gluten, !.
delta(96, make_sandwich_no_gluten(_, _, _), 5.1092527031336634e-5) :- !.
delta(96, make_sandwich(_, _, _), -0.030075957447451042) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(96, make_sandwich(_, _, _), 0.00746916183271727) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(96, make_sandwich(_, _, _), -0.017233789507167283) :- at_kitchen_sandwich(_), !.
delta(96, make_sandwich(_, Bread_portion, _), -0.008216168525413195) :- no_gluten_bread(Bread_portion), !.
delta(96, make_sandwich(_, _, _), 0.07904150392013387) :- !.
delta(96, put_on_tray(_, _), -0.024274670538066756) :- done_served(Child), not_allergic_gluten(Child), at_kitchen_bread(_), !.
delta(96, put_on_tray(_, _), 0.0006135966749287323) :- done_served(Child), not_allergic_gluten(Child), !.
delta(96, put_on_tray(_, _), 0.012296544919778293) :- !.
delta(96, serve_sandwich_no_gluten(_, Child, _, _), 0.011599362562847815) :- todo_served(Child), !.
delta(96, serve_sandwich_no_gluten(_, _, _, _), -0.0023521645278581447) :- !.
delta(96, serve_sandwich(Sandwich, _, _, _), -0.038796828325722454) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(96, serve_sandwich(_, _, _, Place), 0.08431162480232697) :- fewer_at_1_than_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(96, serve_sandwich(_, _, _, _), 1.6915270774447003e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(96, serve_sandwich(_, _, _, _), 0.015764082871581216) :- at_kitchen_sandwich(_), done_served(Child), allergic_gluten(Child), !.
delta(96, serve_sandwich(_, _, _, _), -0.002287832206754228) :- at_kitchen_sandwich(_), !.
delta(96, serve_sandwich(_, _, _, Place), -0.1292171110060351) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(96, serve_sandwich(_, _, _, _), -0.000872466158177495) :- !.
delta(96, move_tray(_, _, _), -0.06037034644698439) :- fewer_at_2_than_allergic_gluten, !.
delta(96, move_tray(_, _, _), 0.14193592102732652) :- fewer_ontray_1_than_not_allergic_gluten, notexist(_), !.
delta(96, move_tray(_, _, _), -0.001086950521231323) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(96, move_tray(_, Place, Place2), 0.0007167701261311021) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(96, move_tray(_, _, _), -0.007769564263600572) :- !.
delta(96, _, 0.0).

% tree 97: step size 1.0, 221 examples, 29 leaves
delta(97, make_sandwich_no_gluten(_, _, _), 0.030148430240490964) :- fewer_at_1_than_allergic_gluten, !.
delta(97, make_sandwich_no_gluten(_, _, _), -0.13565138315947403) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(97, make_sandwich_no_gluten(_, _, _), 1.5268947734229413e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(97, make_sandwich_no_gluten(_, _, _), 0.00010316192309849394) :- !.
delta(97, make_sandwich(_, _, _), -0.044631608447536227) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(97, make_sandwich(_, _, _), 0.011117620499460239) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(97, make_sandwich(_, Bread_portion, _), -0.006583113537241533) :- no_gluten_bread(Bread_portion), !.
delta(97, make_sandwich(_, _, _), -0.004745755765588648) :- at_kitchen_sandwich(_), !.
delta(97, make_sandwich(_, _, _), 0.1576663069225406) :- !.
delta(97, put_on_tray(_, Tray), 0.002744868251438877) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(97, put_on_tray(_, _), 0.0004530438681084931) :- todo_served(Child), not_allergic_gluten(Child), goal_served(Child2), done_served(Child2), !.
delta(97, put_on_tray(_, _), -0.06663989085440424) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(97, put_on_tray(_, _), 0.001981319198053033) :- !.
delta(97, serve_sandwich_no_gluten(_, _, _, Place), -0.07851515747193843) :- done_served(Child), allergic_gluten(Child), not_allergic_gluten(Child2), waiting(Child2, Place), !.
delta(97, serve_sandwich_no_gluten(_, _, _, _), 0.001953404898497295) :- done_served(Child), allergic_gluten(Child), !.
delta(97, serve_sandwich_no_gluten(_, _, _, _), 0.0007023771538278523) :- !.
delta(97, serve_sandwich(_, _, _, _), -0.020557536125577893) :- todo_served(Child), allergic_gluten(Child), fewer_no_gluten_sandwich_than_todo_served, !.
delta(97, serve_sandwich(_, _, _, _), 0.00010653160992733298) :- todo_served(Child), allergic_gluten(Child), !.
delta(97, serve_sandwich(_, Child, _, _), 0.06756705346104595) :- todo_served(Child), !.
delta(97, serve_sandwich(_, _, _, _), -0.00026368492340476387) :- !.
delta(97, move_tray(_, Place, Place2), -0.0001940639647518636) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_at_1_than_todo_served, fewer_ontray_1_than_allergic_gluten, !.
delta(97, move_tray(_, Place, Place2), 0.12260996708020164) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_at_1_than_todo_served, !.
delta(97, move_tray(_, Place, Place2), -0.0014424555001149506) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(97, move_tray(_, Place, Place2), 0.00021883596212531533) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(97, move_tray(_, Place, _), -0.08451967046525825) :- at(Tray, Place), ontray(_, Tray), fewer_at_2_than_todo_served, !.
delta(97, move_tray(_, Place, _), -0.00036559012741652454) :- at(Tray, Place), ontray(_, Tray), !.
delta(97, move_tray(_, _, _), 0.010991901935169074) :- fewer_at_1_than_allergic_gluten, !.
delta(97, move_tray(_, _, _), -0.0026048917591854704) :- !.
delta(97, _, 0.0).

% tree 98: step size 1.0, 213 examples, 27 leaves
delta(98, make_sandwich_no_gluten(_, _, _), 0.039709907202702274) :- todo_served(Child), allergic_gluten(Child), !.
delta(98, make_sandwich_no_gluten(_, _, _), 5.865877739520885e-5) :- no_gluten_sandwich(_), !.
delta(98, make_sandwich_no_gluten(_, _, _), -0.009071732636509138) :- !.
delta(98, make_sandwich(_, _, _), -0.01126220828355245) :- no_gluten_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(98, make_sandwich(_, Bread_portion, _), -0.0005526118460573853) :- no_gluten_sandwich(_), no_gluten_bread(Bread_portion), !.
delta(98, make_sandwich(_, _, _), 0.04456050371694552) :- no_gluten_sandwich(_), !.
delta(98, make_sandwich(_, _, _), -0.0554307307739822) :- !.
delta(98, put_on_tray(_, _), -0.024071237740088357) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(98, put_on_tray(_, _), 2.6771213262326037e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(98, put_on_tray(_, Tray), 0.004369405503797228) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), ontray(Sandwich, Tray), !.
delta(98, put_on_tray(_, _), -0.0020450172141144324) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(98, put_on_tray(_, _), 0.00017175600138452125) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), todo_served(Child), not_allergic_gluten(Child), !.
delta(98, put_on_tray(_, _), -0.0006617605835936007) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(98, put_on_tray(_, _), 0.007486021828886463) :- !.
delta(98, serve_sandwich_no_gluten(_, _, _, _), 0.0013950127304674675) :- !.
delta(98, serve_sandwich(Sandwich, _, _, _), 0.002372959731135224) :- no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(98, serve_sandwich(Sandwich, _, _, _), -0.1302094063258819) :- no_gluten_sandwich(Sandwich), !.
delta(98, serve_sandwich(_, _, _, _), 0.17615390766385391) :- fewer_ontray_1_than_todo_served, !.
delta(98, serve_sandwich(_, _, _, _), -0.015174678624748427) :- todo_served(Child), allergic_gluten(Child), !.
delta(98, serve_sandwich(_, _, _, _), 0.0021649289569199044) :- !.
delta(98, move_tray(Tray, Place, _), -0.004744933849104174) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(98, move_tray(_, _, _), -0.00012803101101068113) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(98, move_tray(_, _, _), 0.11565988339389131) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(98, move_tray(Tray, _, Place), 0.000112290754477784) :- at(Tray, kitchen), done_served(Child), waiting(Child, Place), !.
delta(98, move_tray(Tray, _, _), -0.0006343376372863263) :- at(Tray, kitchen), !.
delta(98, move_tray(_, _, _), -0.1562951365195886) :- !.
delta(98, _, 0.0).

% tree 99: step size 1.0, 202 examples, 31 leaves
delta(99, make_sandwich_no_gluten(_, _, _), 0.01029789509911065) :- fewer_at_1_than_allergic_gluten, !.
delta(99, make_sandwich_no_gluten(_, _, _), 0.0010909014500868096) :- at_kitchen_sandwich(_), !.
delta(99, make_sandwich_no_gluten(_, _, _), 0.00012189195193185579) :- fewer_at_2_than_allergic_gluten, !.
delta(99, make_sandwich_no_gluten(_, _, _), -0.005972078244403976) :- !.
delta(99, make_sandwich(_, _, _), -0.03786832361638286) :- fewer_at_2_than_allergic_gluten, !.
delta(99, make_sandwich(_, _, _), 0.03236839908507428) :- todo_served(Child), allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(99, make_sandwich(_, _, _), -0.00038827515052137086) :- todo_served(Child), allergic_gluten(Child), !.
delta(99, make_sandwich(_, _, _), -0.0042693002016058) :- goal_served(Child), done_served(Child), !.
delta(99, make_sandwich(_, _, _), 2.0676853494906263e-6) :- !.
delta(99, put_on_tray(_, _), -0.0005359981768338987) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(99, put_on_tray(_, _), 0.017556317301779305) :- fewer_ontray_1_than_todo_served, !.
delta(99, put_on_tray(_, _), -0.003916880949324571) :- !.
delta(99, serve_sandwich_no_gluten(_, Child, _, _), 0.008484513669597765) :- todo_served(Child), !.
delta(99, serve_sandwich_no_gluten(_, _, _, _), -0.00454759962685746) :- !.
delta(99, serve_sandwich(_, _, _, Place), -0.017984015815402682) :- done_served(Child), waiting(Child, Place), todo_served(Child2), allergic_gluten(Child2), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(99, serve_sandwich(_, _, _, Place), 0.0005582242577909267) :- done_served(Child), waiting(Child, Place), todo_served(Child2), allergic_gluten(Child2), !.
delta(99, serve_sandwich(_, Child, _, Place), 0.0321448237482493) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(99, serve_sandwich(_, _, _, Place), -0.00021053080072214807) :- done_served(Child), waiting(Child, Place), !.
delta(99, serve_sandwich(_, _, _, _), 0.002261041409220869) :- notexist(_), done_served(Child), allergic_gluten(Child), !.
delta(99, serve_sandwich(_, _, _, _), -0.07561915810992867) :- notexist(_), !.
delta(99, serve_sandwich(_, _, _, _), -0.00010110589194686435) :- todo_served(Child), allergic_gluten(Child), !.
delta(99, serve_sandwich(_, _, _, _), 0.005924869629945032) :- !.
delta(99, move_tray(Tray, _, Place), -0.00561890150190897) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), done_served(Child), waiting(Child, Place), !.
delta(99, move_tray(Tray, _, _), 0.0275313007721137) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(99, move_tray(_, _, _), 0.012879650433947041) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(99, move_tray(_, _, _), -0.07656697880205718) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(99, move_tray(_, Place, Place2), 0.008305631317898653) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(99, move_tray(_, Place, _), -0.014754280691998502) :- done_served(Child), waiting(Child, Place), !.
delta(99, move_tray(Tray, _, Place), 0.08895629367137865) :- could_serve_sandwich(Tray, Place), !.
delta(99, move_tray(_, _, _), -0.006144052318506253) :- !.
delta(99, _, 0.0).

% tree 100: step size 1.0, 224 examples, 28 leaves
delta(100, make_sandwich_no_gluten(_, _, _), 0.011143731217474015) :- fewer_at_2_than_allergic_gluten, !.
delta(100, make_sandwich_no_gluten(_, _, _), -0.010187333162306746) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(100, make_sandwich_no_gluten(_, _, _), 3.68798006384014e-6) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(100, make_sandwich_no_gluten(_, _, _), 0.0001198177559392248) :- !.
delta(100, make_sandwich(_, _, _), -0.0009519003158033459) :- no_gluten_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(100, make_sandwich(_, _, _), 0.00014525195610467012) :- no_gluten_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(100, make_sandwich(_, _, _), 0.006544746196814955) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(100, make_sandwich(_, _, _), -0.0001587487782481886) :- no_gluten_sandwich(_), !.
delta(100, make_sandwich(_, _, _), -0.01908831501023816) :- !.
delta(100, put_on_tray(_, _), 0.004931632448435354) :- !.
delta(100, serve_sandwich_no_gluten(_, _, _, _), -0.08495253959982133) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(100, serve_sandwich_no_gluten(_, Child, _, _), 0.005891512352858712) :- todo_served(Child), !.
delta(100, serve_sandwich_no_gluten(_, _, _, _), -0.0037172190617450747) :- !.
delta(100, serve_sandwich(_, _, Tray, _), -0.0011826762382106425) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_2_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(100, serve_sandwich(_, _, Tray, _), 0.0012048945507680303) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_2_than_not_allergic_gluten, !.
delta(100, serve_sandwich(_, _, Tray, _), -0.07856223112499346) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(100, serve_sandwich(_, Child, _, _), 0.11457971290441994) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(100, serve_sandwich(_, _, _, _), -0.0004047511501256094) :- goal_served(Child), done_served(Child), !.
delta(100, serve_sandwich(_, _, _, _), 0.0018920902511470356) :- !.
delta(100, move_tray(Tray, _, Place), -0.007647896493486429) :- needed_at_to_serve_sandwich_no_gluten(Place), at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(100, move_tray(Tray, _, Place), 0.03145019206422728) :- needed_at_to_serve_sandwich_no_gluten(Place), at(Tray, kitchen), !.
delta(100, move_tray(Tray, _, Place), 3.889450672571537e-5) :- needed_at_to_serve_sandwich_no_gluten(Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(100, move_tray(_, _, Place), -0.10278038146446992) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(100, move_tray(_, _, _), 2.1146282238656292e-5) :- done_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(100, move_tray(_, _, _), -0.010139288853955203) :- done_served(Child), not_allergic_gluten(Child), !.
delta(100, move_tray(_, _, Place), -0.0009067705592125793) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(100, move_tray(_, _, _), 0.11743112305127845) :- !.
delta(100, _, 0.0).

% tree 101: step size 1.0, 203 examples, 24 leaves
delta(101, make_sandwich_no_gluten(_, _, _), 0.025702372565690544) :- fewer_at_1_than_allergic_gluten, !.
delta(101, make_sandwich_no_gluten(_, _, _), -0.05888023914671389) :- fewer_at_2_than_allergic_gluten, !.
delta(101, make_sandwich_no_gluten(_, _, _), 0.0036426705998792368) :- !.
delta(101, make_sandwich(_, _, _), -0.04222168517155349) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(101, make_sandwich(_, Bread_portion, _), -0.007927711517963265) :- todo_served(Child), allergic_gluten(Child), no_gluten_bread(Bread_portion), !.
delta(101, make_sandwich(_, _, _), 0.0755867080106224) :- todo_served(Child), allergic_gluten(Child), !.
delta(101, make_sandwich(_, _, _), 0.002112831547821158) :- done_served(Child), not_allergic_gluten(Child), !.
delta(101, make_sandwich(_, _, _), -0.005489328109521312) :- !.
delta(101, put_on_tray(_, _), 0.00019247156799335045) :- fewer_at_1_than_todo_served_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(101, put_on_tray(_, _), -0.009133154303828836) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(101, put_on_tray(_, _), 0.011154479441696641) :- !.
delta(101, serve_sandwich_no_gluten(_, _, _, _), -0.011245107301831439) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(101, serve_sandwich_no_gluten(_, _, _, _), 0.0006394327311711308) :- !.
delta(101, serve_sandwich(_, Child, _, Place), 0.030035622054186306) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(101, serve_sandwich(_, _, _, Place), -0.0007703948881708846) :- done_served(Child), waiting(Child, Place), !.
delta(101, serve_sandwich(_, _, _, _), -0.010739682603141181) :- todo_served(Child), allergic_gluten(Child), !.
delta(101, serve_sandwich(_, _, _, _), 0.008549521873618822) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(101, serve_sandwich(_, _, _, _), 0.00020775614934595628) :- !.
delta(101, move_tray(_, _, _), -7.55005295397663e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_1_than_allergic_gluten, !.
delta(101, move_tray(_, _, _), 0.024018479462372604) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_no_gluten_sandwich_than_todo_served, !.
delta(101, move_tray(_, _, Place), 8.181055137643221e-5) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(101, move_tray(_, _, _), -0.004127206144621722) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(101, move_tray(_, _, _), -0.054223920607971626) :- !.
delta(101, _, 0.0).

% tree 102: step size 1.0, 227 examples, 25 leaves
delta(102, make_sandwich_no_gluten(_, _, _), -0.04185156593290404) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(102, make_sandwich_no_gluten(_, _, _), 0.03290113570688313) :- !.
delta(102, make_sandwich(_, _, _), -9.840844049185312e-7) :- goal_served(Child), done_served(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(102, make_sandwich(_, _, _), 0.001817062636276895) :- goal_served(Child), done_served(Child), !.
delta(102, make_sandwich(_, _, _), -0.05758625610570168) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(102, make_sandwich(_, _, _), 0.0010396357275602797) :- fewer_at_1_than_todo_served, !.
delta(102, make_sandwich(_, _, _), -0.0007801780356660997) :- !.
delta(102, put_on_tray(_, _), 0.050765281066463344) :- goal_served(Child), allergic_gluten(Child), !.
delta(102, put_on_tray(_, Tray), -0.009574438317139507) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(102, put_on_tray(_, Tray), 0.00020480700648223038) :- ontray(_, Tray), !.
delta(102, put_on_tray(_, _), 0.006087172233018528) :- !.
delta(102, serve_sandwich_no_gluten(_, _, _, _), 0.0005127098792962945) :- !.
delta(102, serve_sandwich(_, Child, _, _), 0.0509701106016877) :- no_gluten_sandwich(_), todo_served(Child), !.
delta(102, serve_sandwich(_, _, _, _), -0.00043358395522973334) :- no_gluten_sandwich(_), !.
delta(102, serve_sandwich(_, _, _, Place), 0.00725974721624932) :- goal_served(Child), done_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(102, serve_sandwich(_, _, _, _), 0.0) :- goal_served(Child), done_served(Child), !.
delta(102, serve_sandwich(_, _, _, _), -0.14000341133329935) :- !.
delta(102, move_tray(_, Place, Place2), -0.06883563853954194) :- allergic_gluten(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place2), !.
delta(102, move_tray(_, Place, _), 0.0022918654633245074) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(102, move_tray(_, Place, _), -0.00020843433732736823) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(102, move_tray(_, Place, Place2), 0.0002796042410404214) :- done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(102, move_tray(_, Place, _), -0.01621178685172842) :- done_served(Child), waiting(Child, Place), !.
delta(102, move_tray(Tray, _, Place), 0.16376956768696174) :- could_serve_sandwich(Tray, Place), !.
delta(102, move_tray(_, _, _), -0.003412426131415699) :- !.
delta(102, _, 0.0).

% tree 103: step size 1.0, 215 examples, 30 leaves
delta(103, make_sandwich_no_gluten(_, _, _), -0.18557280870729745) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(103, make_sandwich_no_gluten(_, _, _), 0.00023366439840434732) :- fewer_at_1_than_allergic_gluten, !.
delta(103, make_sandwich_no_gluten(_, _, _), 0.0108584889919554) :- !.
delta(103, make_sandwich(_, _, _), -0.02018089239268006) :- at_kitchen_sandwich(_), fewer_ontray_2_than_not_allergic_gluten, !.
delta(103, make_sandwich(_, _, _), 0.0008712075322013258) :- at_kitchen_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(103, make_sandwich(_, _, _), -0.00028251848928745907) :- at_kitchen_sandwich(_), !.
delta(103, make_sandwich(_, Bread_portion, _), -0.00012438672581065386) :- fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(103, make_sandwich(_, _, _), 0.08861809062905396) :- fewer_ontray_1_than_todo_served, !.
delta(103, make_sandwich(_, _, _), -0.0016438042936194643) :- !.
delta(103, put_on_tray(_, Tray), 0.12619516922828328) :- fewer_at_2_than_todo_served_not_allergic_gluten, ontray(_, Tray), !.
delta(103, put_on_tray(_, _), -0.006176331275553091) :- fewer_at_2_than_todo_served_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(103, put_on_tray(_, _), 0.0012779948581515294) :- fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(103, put_on_tray(_, _), 0.0018624448270038096) :- fewer_ontray_1_than_allergic_gluten, !.
delta(103, put_on_tray(_, _), -0.024296293602690925) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(103, put_on_tray(_, _), 0.0008129951114679224) :- !.
delta(103, serve_sandwich_no_gluten(_, _, _, _), 0.009721905996226814) :- fewer_ontray_2_than_todo_served, !.
delta(103, serve_sandwich_no_gluten(_, _, _, _), -0.022695015623290727) :- !.
delta(103, serve_sandwich(_, _, _, _), 0.0006541743125184677) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(103, serve_sandwich(_, _, _, _), -0.004789617824701713) :- at_kitchen_bread(_), !.
delta(103, serve_sandwich(Sandwich, Child, _, Place), -0.00014907121445588485) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(103, serve_sandwich(_, Child, _, _), 0.03704466359994035) :- todo_served(Child), !.
delta(103, serve_sandwich(_, _, _, _), -0.0003300794031916255) :- !.
delta(103, move_tray(_, Place, Place2), 0.005513557940268408) :- not_allergic_gluten(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), todo_served(Child), !.
delta(103, move_tray(_, Place, Place2), -0.005518669379612429) :- not_allergic_gluten(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(103, move_tray(_, Place, _), -0.0453502329507864) :- not_allergic_gluten(Child), waiting(Child, Place), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(103, move_tray(_, Place, _), 0.0) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(103, move_tray(_, _, Place), -0.0068739762815878) :- at(Tray, Place), ontray(_, Tray), !.
delta(103, move_tray(Tray, _, _), 0.04318882603795468) :- ontray(_, Tray), !.
delta(103, move_tray(_, _, _), -0.0005912240103723762) :- !.
delta(103, _, 0.0).

% tree 104: step size 1.0, 226 examples, 32 leaves
delta(104, make_sandwich_no_gluten(_, _, _), 0.01014931527032743) :- !.
delta(104, make_sandwich(_, _, _), -0.0011059390517128588) :- at_kitchen_sandwich(_), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(104, make_sandwich(_, _, _), 0.01692542595749962) :- at_kitchen_sandwich(_), fewer_at_1_than_not_allergic_gluten, !.
delta(104, make_sandwich(_, _, _), -0.0009483342220537107) :- at_kitchen_sandwich(_), !.
delta(104, make_sandwich(_, _, _), 0.002997999539846463) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(104, make_sandwich(_, _, _), -3.48151502790465e-5) :- no_gluten_sandwich(_), !.
delta(104, make_sandwich(_, _, _), 0.00047731007830736206) :- goal_served(Child), done_served(Child), !.
delta(104, make_sandwich(_, _, _), -0.02847606614775225) :- !.
delta(104, put_on_tray(_, _), 3.764452732379724e-5) :- done_served(Child), not_allergic_gluten(Child), no_gluten_bread(_), !.
delta(104, put_on_tray(_, _), 5.900173477058067e-6) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(104, put_on_tray(_, _), -0.005874496347078515) :- done_served(Child), not_allergic_gluten(Child), !.
delta(104, put_on_tray(_, Tray), 0.011313290996468044) :- ontray(_, Tray), !.
delta(104, put_on_tray(Sandwich, _), 0.0015974779260416044) :- no_gluten_sandwich(Sandwich), !.
delta(104, put_on_tray(_, _), -0.003661816423466969) :- !.
delta(104, serve_sandwich_no_gluten(Sandwich, _, _, Place), -0.013005649259449073) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), at_kitchen_sandwich(_), !.
delta(104, serve_sandwich_no_gluten(Sandwich, _, _, Place), 4.658539463173266e-5) :- ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(104, serve_sandwich_no_gluten(_, _, _, _), 8.214338285055955e-5) :- !.
delta(104, serve_sandwich(_, Child, Tray, _), 0.026436157218238665) :- done_served(Child2), not_allergic_gluten(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place), todo_served(Child), !.
delta(104, serve_sandwich(_, _, Tray, _), -0.0004566056050999079) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(104, serve_sandwich(_, _, _, Place), -2.1279253155105756e-5) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(104, serve_sandwich(_, _, _, _), 9.756843235919098e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(104, serve_sandwich(_, _, _, _), -0.21297861122628314) :- notexist(_), !.
delta(104, serve_sandwich(_, _, _, _), -4.4777547767096406e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(104, serve_sandwich(_, _, _, _), 0.009433226539957705) :- !.
delta(104, move_tray(Tray, Place, Place2), 0.007052590538402169) :- allergic_gluten(Child), waiting(Child, Place2), allergic_gluten(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place2), !.
delta(104, move_tray(_, Place, Place2), -6.98928447541508e-5) :- allergic_gluten(Child), waiting(Child, Place2), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(104, move_tray(_, _, Place), -0.03946851982443776) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(104, move_tray(_, Place, Place2), -0.013154833984251327) :- at(Tray, Place), could_put_on_tray(Tray, Place2), todo_served(Child), waiting(Child, Place), !.
delta(104, move_tray(_, Place, Place2), 0.0023481627315838586) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(104, move_tray(_, _, _), -0.006534076506232239) :- done_served(Child), not_allergic_gluten(Child), !.
delta(104, move_tray(_, _, _), 0.22747516062784937) :- !.
delta(104, _, 0.0).

% tree 105: step size 1.0, 233 examples, 28 leaves
delta(105, make_sandwich_no_gluten(_, _, _), 0.016730451494436964) :- no_gluten_sandwich(_), !.
delta(105, make_sandwich_no_gluten(_, _, _), -0.12241644366019767) :- fewer_at_1_than_allergic_gluten, !.
delta(105, make_sandwich_no_gluten(_, _, _), 0.0002782863837282671) :- !.
delta(105, make_sandwich(_, _, _), -0.02473283913251555) :- at_kitchen_sandwich(_), goal_served(Child), allergic_gluten(Child), !.
delta(105, make_sandwich(_, _, _), 0.006016983122371604) :- at_kitchen_sandwich(_), !.
delta(105, make_sandwich(_, _, Content_portion), -0.0006844841410772364) :- no_gluten_content(Content_portion), !.
delta(105, make_sandwich(_, _, _), -0.00016971436865779294) :- done_served(Child), allergic_gluten(Child), !.
delta(105, make_sandwich(_, _, _), 0.16278285637545895) :- !.
delta(105, put_on_tray(_, Tray), 0.00453843241987257) :- ontray(_, Tray), fewer_ontray_1_than_todo_served, !.
delta(105, put_on_tray(_, Tray), -0.0010115614680076086) :- ontray(_, Tray), !.
delta(105, put_on_tray(_, _), -0.02168015474365963) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(105, put_on_tray(_, _), -0.0007570961804220151) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(105, put_on_tray(_, _), 0.003038559195662958) :- !.
delta(105, serve_sandwich_no_gluten(_, _, _, _), 0.012076733730558903) :- !.
delta(105, serve_sandwich(_, _, _, Place), -0.08077756963065096) :- allergic_gluten(Child), waiting(Child, Place), notexist(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(105, serve_sandwich(_, _, _, Place), 3.1111310990063604e-5) :- allergic_gluten(Child), waiting(Child, Place), notexist(_), !.
delta(105, serve_sandwich(_, _, _, Place), -0.0001661655702431593) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child), !.
delta(105, serve_sandwich(_, _, _, Place), 0.00018706297859405737) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(105, serve_sandwich(_, Child, _, _), 0.012966314630731723) :- todo_served(Child), !.
delta(105, serve_sandwich(_, _, _, _), -0.00020716615923498541) :- !.
delta(105, move_tray(_, kitchen, Place), -0.011676116519204848) :- allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(105, move_tray(_, _, Place), 1.9750117742622166e-5) :- allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(105, move_tray(_, _, Place), -0.002389895609149989) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(105, move_tray(_, _, Place), 0.10000471011972233) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(105, move_tray(_, Place, _), -0.0060143609277282396) :- fewer_ontray_1_than_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(105, move_tray(_, _, _), 0.021058858711482883) :- fewer_ontray_1_than_allergic_gluten, !.
delta(105, move_tray(_, _, _), -0.0429533717529378) :- !.
delta(105, _, 0.0).

% tree 106: step size 1.0, 248 examples, 30 leaves
delta(106, make_sandwich_no_gluten(_, _, _), 0.01621162506624341) :- at_kitchen_sandwich(_), !.
delta(106, make_sandwich_no_gluten(_, _, _), -0.02289533106540232) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(106, make_sandwich_no_gluten(_, _, _), 0.0002078722719137174) :- !.
delta(106, make_sandwich(_, _, Content_portion), -0.0028245166313317074) :- goal_served(Child), allergic_gluten(Child), no_gluten_content(Content_portion), !.
delta(106, make_sandwich(_, _, _), -0.00012280167649299402) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(106, make_sandwich(_, _, _), 0.04897927552329552) :- goal_served(Child), allergic_gluten(Child), !.
delta(106, make_sandwich(_, _, _), -0.042294662004357525) :- fewer_at_1_than_todo_served, !.
delta(106, make_sandwich(_, _, _), 3.587357811609591e-6) :- !.
delta(106, put_on_tray(_, _), -0.025653673968389242) :- fewer_ontray_2_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(106, put_on_tray(_, _), 1.6984527244727887e-5) :- fewer_ontray_2_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(106, put_on_tray(_, _), 4.248048121621419e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(106, put_on_tray(_, _), -0.00041840239508824436) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(106, put_on_tray(_, _), 0.005825586015801687) :- !.
delta(106, serve_sandwich_no_gluten(_, Child, _, _), 0.006942156471845066) :- todo_served(Child), !.
delta(106, serve_sandwich_no_gluten(_, _, _, _), -0.005000624857527355) :- !.
delta(106, serve_sandwich(_, Child, Tray, _), 0.0073174233868081445) :- done_served(Child2), not_allergic_gluten(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place), todo_served(Child), !.
delta(106, serve_sandwich(_, _, Tray, _), -0.00019489412803540176) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(106, serve_sandwich(_, _, _, _), -0.01142523912668378) :- done_served(Child), not_allergic_gluten(Child), fewer_at_1_than_todo_served, !.
delta(106, serve_sandwich(_, _, _, _), 0.0041219706023263546) :- done_served(Child), not_allergic_gluten(Child), !.
delta(106, serve_sandwich(_, _, _, Place), 1.9742700042442148e-5) :- done_served(Child), waiting(Child, Place), !.
delta(106, serve_sandwich(_, _, _, _), 0.047895852287420354) :- !.
delta(106, move_tray(Tray, _, Place), 0.0033209776997947817) :- allergic_gluten(Child), waiting(Child, Place), at(_, Place), could_serve_sandwich(Tray, Place), !.
delta(106, move_tray(_, _, Place), -0.00024900651065068696) :- allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(106, move_tray(_, _, Place), -0.0410710326033578) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(106, move_tray(_, _, Place), 0.0003100106572025277) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(106, move_tray(_, _, _), 0.028210407676355576) :- fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_1_than_todo_served, !.
delta(106, move_tray(_, _, _), -0.005717241803695899) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(106, move_tray(_, _, _), 0.00013433756779246322) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(106, move_tray(_, _, _), -0.01049407081027831) :- !.
delta(106, _, 0.0).

% tree 107: step size 1.0, 238 examples, 24 leaves
delta(107, make_sandwich_no_gluten(_, _, _), 0.010761007375028818) :- fewer_at_1_than_allergic_gluten, !.
delta(107, make_sandwich_no_gluten(_, _, _), -0.05749222234639568) :- fewer_at_2_than_allergic_gluten, !.
delta(107, make_sandwich_no_gluten(_, _, _), 0.0003977734245038923) :- !.
delta(107, make_sandwich(_, _, Content_portion), -0.007068980229691827) :- fewer_at_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), no_gluten_content(Content_portion), !.
delta(107, make_sandwich(_, _, _), 0.006767328532606942) :- fewer_at_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(107, make_sandwich(_, _, _), -0.0137022117362176) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(107, make_sandwich(_, Bread_portion, _), -0.004142742679355113) :- fewer_ontray_2_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(107, make_sandwich(_, _, _), 0.06111091809312247) :- fewer_ontray_2_than_allergic_gluten, !.
delta(107, make_sandwich(_, _, _), -0.011405568547207623) :- at_kitchen_sandwich(_), !.
delta(107, make_sandwich(_, _, _), 0.0012764926289808732) :- !.
delta(107, put_on_tray(_, _), 0.018011699312478487) :- !.
delta(107, serve_sandwich_no_gluten(_, Child, _, _), 0.0) :- todo_served(Child), at_kitchen_bread(_), !.
delta(107, serve_sandwich_no_gluten(_, Child, _, _), 0.0047517299833393254) :- todo_served(Child), !.
delta(107, serve_sandwich_no_gluten(_, _, _, _), -0.007730351289510505) :- !.
delta(107, serve_sandwich(_, _, _, _), -0.0258924921556407) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(107, serve_sandwich(_, _, _, _), 0.027781501775630442) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_sandwich(_), !.
delta(107, serve_sandwich(_, _, _, _), 0.0003691661069430049) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(107, serve_sandwich(_, _, _, _), -0.012328859675662652) :- notexist(_), !.
delta(107, serve_sandwich(_, _, _, _), 0.00017374918235695558) :- !.
delta(107, move_tray(_, _, Place), 0.025537611755806412) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(107, move_tray(Tray, _, Place), 0.01660710925235785) :- needed_at_to_serve_sandwich_no_gluten(Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(107, move_tray(_, _, Place), -0.01167226872241572) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(107, move_tray(_, _, _), -0.026879465986079085) :- !.
delta(107, _, 0.0).

% tree 108: step size 1.0, 213 examples, 30 leaves
delta(108, make_sandwich_no_gluten(_, _, _), 0.0006715915527372863) :- at_kitchen_sandwich(_), !.
delta(108, make_sandwich_no_gluten(_, _, _), 0.00011434557729138413) :- no_gluten_sandwich(_), !.
delta(108, make_sandwich_no_gluten(_, _, _), -0.10041204852289318) :- fewer_at_1_than_allergic_gluten, !.
delta(108, make_sandwich_no_gluten(_, _, _), 2.0748820204540484e-5) :- !.
delta(108, make_sandwich(_, Bread_portion, _), -0.0038511130490213844) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), no_gluten_bread(Bread_portion), !.
delta(108, make_sandwich(_, _, Content_portion), -0.00047591955657618786) :- at_kitchen_content(Content_portion2), no_gluten_content(Content_portion2), no_gluten_content(Content_portion), !.
delta(108, make_sandwich(_, _, _), 0.1282314071463606) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(108, make_sandwich(_, _, _), 0.0) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(108, make_sandwich(_, _, _), 0.0035735220413465095) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(108, make_sandwich(_, _, _), -0.0357211603396348) :- fewer_at_1_than_todo_served, !.
delta(108, make_sandwich(_, _, _), 6.443404631190432e-5) :- !.
delta(108, put_on_tray(_, _), 0.00120929277631369) :- done_served(Child), allergic_gluten(Child), notexist(_), !.
delta(108, put_on_tray(_, _), -0.001980103858849963) :- done_served(Child), allergic_gluten(Child), !.
delta(108, put_on_tray(_, _), 0.006445754323022301) :- !.
delta(108, serve_sandwich_no_gluten(_, _, _, _), 0.0002231359712063575) :- !.
delta(108, serve_sandwich(_, _, _, _), 0.009265884796542802) :- at_kitchen_sandwich(_), done_served(Child), not_allergic_gluten(Child), !.
delta(108, serve_sandwich(_, _, _, _), -0.1108669186606597) :- at_kitchen_sandwich(_), !.
delta(108, serve_sandwich(_, Child, _, _), 0.00034449677730261357) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(108, serve_sandwich(_, _, _, _), -0.0007269080348992446) :- done_served(Child), not_allergic_gluten(Child), !.
delta(108, serve_sandwich(_, _, _, _), -4.448942181969852e-6) :- todo_served(Child), allergic_gluten(Child), !.
delta(108, serve_sandwich(_, _, _, _), 0.03288135945236109) :- !.
delta(108, move_tray(Tray, _, Place), -0.00767328790092696) :- allergic_gluten(Child), waiting(Child, Place), at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(108, move_tray(Tray, _, Place), 0.01909042789440946) :- allergic_gluten(Child), waiting(Child, Place), at(Tray, kitchen), !.
delta(108, move_tray(_, _, Place), -0.033197428365593244) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child2), not_allergic_gluten(Child2), !.
delta(108, move_tray(_, _, Place), 0.00032413328102325447) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(108, move_tray(_, _, _), -0.002480813917666351) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(_), !.
delta(108, move_tray(_, _, _), 0.12474128348948581) :- fewer_ontray_1_than_todo_served, !.
delta(108, move_tray(_, _, Place), 5.553937606182295e-5) :- done_served(Child), waiting(Child, Place), !.
delta(108, move_tray(_, _, _), -0.011666242994472125) :- !.
delta(108, _, 0.0).

% tree 109: step size 1.0, 218 examples, 28 leaves
delta(109, make_sandwich_no_gluten(_, _, _), 0.11858568607975976) :- !.
delta(109, make_sandwich(_, _, Content_portion), -0.0050251372369218865) :- todo_served(Child), allergic_gluten(Child), at_kitchen_sandwich(_), no_gluten_content(Content_portion), !.
delta(109, make_sandwich(_, _, _), 0.004803210498193161) :- todo_served(Child), allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(109, make_sandwich(_, _, _), 0.00013715203814311134) :- todo_served(Child), allergic_gluten(Child), goal_served(Child2), done_served(Child2), !.
delta(109, make_sandwich(_, _, _), -0.08117954656027819) :- todo_served(Child), allergic_gluten(Child), !.
delta(109, make_sandwich(_, _, _), 0.002003870874670789) :- goal_served(Child), done_served(Child), !.
delta(109, make_sandwich(_, _, _), 1.8128566789683082e-6) :- !.
delta(109, put_on_tray(_, _), -0.13225227903298917) :- todo_served(Child), not_allergic_gluten(Child), no_gluten_sandwich(_), !.
delta(109, put_on_tray(_, _), 0.00040397974334530225) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(109, put_on_tray(_, _), 0.002555320521010548) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(109, put_on_tray(_, _), -0.0001954125752318921) :- !.
delta(109, serve_sandwich_no_gluten(_, _, _, Place), -0.09053599099049474) :- done_served(Child), waiting(Child, Place), !.
delta(109, serve_sandwich_no_gluten(_, _, _, _), 0.00015942009416951796) :- !.
delta(109, serve_sandwich(Sandwich, _, _, Place), -0.00018111292129917528) :- no_gluten_sandwich(_), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(109, serve_sandwich(_, Child, _, _), 0.028357263350245288) :- no_gluten_sandwich(_), todo_served(Child), !.
delta(109, serve_sandwich(_, _, _, _), -7.946148477904743e-5) :- no_gluten_sandwich(_), !.
delta(109, serve_sandwich(_, _, _, _), -4.7630143921504146e-5) :- at_kitchen_bread(_), !.
delta(109, serve_sandwich(_, _, _, Place), 0.0024807786854954598) :- done_served(Child), waiting(Child, Place), !.
delta(109, serve_sandwich(_, _, _, _), -0.1509433234570461) :- !.
delta(109, move_tray(Tray, Place, Place2), -0.006835932220475912) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_put_on_tray(Tray2, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(109, move_tray(Tray, Place, _), 0.021187666736296275) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_put_on_tray(Tray2, Place), !.
delta(109, move_tray(Tray, _, Place), 0.0033211769232656765) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_put_on_tray(Tray2, Place), !.
delta(109, move_tray(Tray, _, _), -0.027389264585499513) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(109, move_tray(_, Place, Place2), 0.00021279052484342333) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_bread(_), !.
delta(109, move_tray(_, Place, Place2), -0.012031774234936092) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(109, move_tray(Tray, _, _), 0.004266525244612905) :- at(Tray, kitchen), !.
delta(109, move_tray(_, _, _), 0.27751052306360496) :- !.
delta(109, _, 0.0).

% tree 110: step size 1.0, 281 examples, 32 leaves
delta(110, make_sandwich_no_gluten(_, _, _), 0.000723129740308525) :- at_kitchen_sandwich(_), !.
delta(110, make_sandwich_no_gluten(_, _, _), -0.09709529020688087) :- fewer_at_1_than_not_allergic_gluten, !.
delta(110, make_sandwich_no_gluten(_, _, _), 0.00013701702742563424) :- !.
delta(110, make_sandwich(_, _, _), -0.024926325362405792) :- no_gluten_sandwich(_), fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(110, make_sandwich(_, _, _), 0.00034375164683258017) :- no_gluten_sandwich(_), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(110, make_sandwich(_, Bread_portion, _), -0.0006922943174733473) :- no_gluten_sandwich(_), no_gluten_bread(Bread_portion), !.
delta(110, make_sandwich(_, _, _), 0.0015148977154270846) :- no_gluten_sandwich(_), !.
delta(110, make_sandwich(_, Bread_portion, _), -0.00036726266398084083) :- at_kitchen_sandwich(_), no_gluten_bread(Bread_portion), !.
delta(110, make_sandwich(_, _, _), 2.1536019435673264e-5) :- at_kitchen_sandwich(_), !.
delta(110, make_sandwich(_, _, Content_portion), -0.0003747848624882394) :- no_gluten_content(Content_portion), !.
delta(110, make_sandwich(_, _, _), 0.11312506423513322) :- !.
delta(110, put_on_tray(_, _), 0.00954192945969869) :- at_kitchen_bread(_), !.
delta(110, put_on_tray(_, _), -0.024253662920369033) :- fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(110, put_on_tray(_, _), 0.00027261085141666916) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(110, put_on_tray(_, _), 0.0019436938210409893) :- fewer_ontray_1_than_todo_served, !.
delta(110, put_on_tray(_, _), -0.0006424907696519382) :- !.
delta(110, serve_sandwich_no_gluten(_, _, _, Place), 1.1977121482242712e-6) :- done_served(Child), waiting(Child, Place), !.
delta(110, serve_sandwich_no_gluten(_, _, _, _), 0.0035020428977297537) :- !.
delta(110, serve_sandwich(_, _, _, Place), -0.2855824343925956) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(110, serve_sandwich(_, _, _, Place), -0.002178194348990024) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child), !.
delta(110, serve_sandwich(_, _, _, Place), 0.009367519728176607) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(110, serve_sandwich(_, _, _, _), 4.362368884951906e-6) :- at_kitchen_bread(_), !.
delta(110, serve_sandwich(_, Child, _, _), 0.04129336679716122) :- todo_served(Child), !.
delta(110, serve_sandwich(_, _, _, _), -0.00021448903674687613) :- !.
delta(110, move_tray(_, _, Place), -0.009809628200097628) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), allergic_gluten(Child2), waiting(Child2, Place), !.
delta(110, move_tray(_, _, _), 0.30270395494517044) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child), allergic_gluten(Child), !.
delta(110, move_tray(_, _, _), -0.01853119848417893) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(110, move_tray(_, _, _), 0.026201628334279446) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_ontray_1_than_todo_served, !.
delta(110, move_tray(_, _, _), -0.0010432714567823877) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(110, move_tray(_, _, Place), 0.011187783197101843) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(110, move_tray(_, _, _), -0.0532309064982924) :- !.
delta(110, _, 0.0).

% tree 111: step size 1.0, 229 examples, 28 leaves
delta(111, make_sandwich_no_gluten(_, _, _), 0.0005368608739042451) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(111, make_sandwich_no_gluten(_, _, _), -0.0172134464746251) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(111, make_sandwich_no_gluten(_, _, _), 0.0008605301163719646) :- !.
delta(111, make_sandwich(_, _, Content_portion), -0.012044802637363669) :- no_gluten_content(Content_portion), !.
delta(111, make_sandwich(_, Bread_portion, _), -0.0015064111835607508) :- no_gluten_bread(Bread_portion), !.
delta(111, make_sandwich(_, _, _), 0.04179639565656311) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(111, make_sandwich(_, _, _), -4.976122957789604e-5) :- !.
delta(111, put_on_tray(_, Tray), 0.004426326722655524) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(111, put_on_tray(_, _), 0.000910032313710681) :- done_served(Child), not_allergic_gluten(Child), !.
delta(111, put_on_tray(_, _), -0.01814978606341093) :- goal_served(Child), allergic_gluten(Child), !.
delta(111, put_on_tray(_, _), 0.00037999022590488814) :- !.
delta(111, serve_sandwich_no_gluten(_, _, _, _), 0.004080101762770746) :- !.
delta(111, serve_sandwich(Sandwich, _, _, _), -0.04234349641295538) :- at_kitchen_sandwich(_), no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(111, serve_sandwich(Sandwich, _, _, _), 0.00314491146669445) :- at_kitchen_sandwich(_), no_gluten_sandwich(Sandwich), !.
delta(111, serve_sandwich(_, _, _, _), 0.08901285289380177) :- at_kitchen_sandwich(_), !.
delta(111, serve_sandwich(_, _, _, _), 0.00029058599666997745) :- fewer_at_1_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(111, serve_sandwich(_, _, _, _), -0.0964148230827203) :- fewer_at_1_than_allergic_gluten, !.
delta(111, serve_sandwich(_, Child, _, _), 0.008445699036230601) :- todo_served(Child), !.
delta(111, serve_sandwich(_, _, _, _), -0.0004412676235559053) :- !.
delta(111, move_tray(_, _, Place), 0.09652548028137771) :- done_served(Child), waiting(Child, Place), fewer_at_1_than_allergic_gluten, todo_served(Child2), waiting(Child2, Place), !.
delta(111, move_tray(_, _, Place), -0.00015565793391375123) :- done_served(Child), waiting(Child, Place), fewer_at_1_than_allergic_gluten, !.
delta(111, move_tray(_, _, Place), -0.0053733037866127995) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_not_allergic_gluten, !.
delta(111, move_tray(_, _, Place), 0.0027749927521909215) :- done_served(Child), waiting(Child, Place), !.
delta(111, move_tray(_, _, _), -4.942988900191317e-5) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(111, move_tray(_, _, _), -0.06425197627700518) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(111, move_tray(_, Place, _), 0.010844321144535074) :- done_served(Child), waiting(Child, Place), !.
delta(111, move_tray(_, _, _), -0.008202234337811073) :- !.
delta(111, _, 0.0).

% tree 112: step size 1.0, 214 examples, 23 leaves
delta(112, make_sandwich_no_gluten(_, _, _), 0.020751076399393345) :- !.
delta(112, make_sandwich(_, _, _), 0.00025989307097873507) :- done_served(Child), not_allergic_gluten(Child), !.
delta(112, make_sandwich(_, _, _), -0.05510650031775792) :- !.
delta(112, put_on_tray(_, _), 0.009296052401122468) :- fewer_ontray_1_than_allergic_gluten, !.
delta(112, put_on_tray(_, _), -0.01629969863146064) :- done_served(Child), allergic_gluten(Child), !.
delta(112, put_on_tray(_, _), 0.005987274872328666) :- !.
delta(112, serve_sandwich_no_gluten(_, _, _, _), -0.0011835277351830338) :- done_served(Child), allergic_gluten(Child), !.
delta(112, serve_sandwich_no_gluten(_, _, _, _), 0.0031508077045501307) :- !.
delta(112, serve_sandwich(Sandwich, _, _, _), -0.021219330358719264) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(112, serve_sandwich(_, _, _, _), 0.003504772682843472) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(112, serve_sandwich(_, _, _, _), 0.06189061564389663) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(112, serve_sandwich(_, _, _, Place), -0.025234385640573176) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(112, serve_sandwich(_, Child, _, _), 0.0003215720583840654) :- todo_served(Child), !.
delta(112, serve_sandwich(_, _, _, _), -0.00020013704433194594) :- !.
delta(112, move_tray(_, Place, _), -0.09288586837441937) :- todo_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served_not_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(112, move_tray(_, Place, _), -0.00040479767246503345) :- todo_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(112, move_tray(_, Place, _), 0.007729573110174297) :- todo_served(Child), waiting(Child, Place), at_kitchen_bread(_), !.
delta(112, move_tray(_, Place, _), -0.0012357774865286125) :- todo_served(Child), waiting(Child, Place), !.
delta(112, move_tray(_, Place, Place2), -0.0007690976470211647) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(112, move_tray(_, _, _), 0.09583753492435605) :- fewer_ontray_2_than_allergic_gluten, !.
delta(112, move_tray(_, _, _), 0.0015094903727652478) :- done_served(Child), allergic_gluten(Child), !.
delta(112, move_tray(_, _, _), -0.014394261143160229) :- !.
delta(112, _, 0.0).

% tree 113: step size 1.0, 227 examples, 27 leaves
delta(113, make_sandwich_no_gluten(_, _, _), 0.028543154914275292) :- !.
delta(113, make_sandwich(_, _, _), -0.033564255956521155) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(113, make_sandwich(_, _, _), 7.15714110090551e-5) :- done_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(113, make_sandwich(_, _, _), -0.019037533235855733) :- done_served(Child), allergic_gluten(Child), !.
delta(113, make_sandwich(_, Bread_portion, _), -0.0006235796316029012) :- no_gluten_bread(Bread_portion), !.
delta(113, make_sandwich(_, _, _), 0.05243911266725975) :- !.
delta(113, put_on_tray(_, Tray), 0.0016111246652379704) :- at_kitchen_bread(_), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(113, put_on_tray(_, _), -0.023524001804740367) :- at_kitchen_bread(_), fewer_at_1_than_not_allergic_gluten, !.
delta(113, put_on_tray(_, _), 0.00024757058882905465) :- at_kitchen_bread(_), !.
delta(113, put_on_tray(_, _), 0.009103767707556857) :- fewer_ontray_1_than_todo_served, !.
delta(113, put_on_tray(_, _), 0.00012017782281022523) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(113, put_on_tray(_, _), -0.0009980910029050878) :- !.
delta(113, serve_sandwich_no_gluten(_, _, _, _), 0.008383596517685669) :- !.
delta(113, serve_sandwich(_, _, _, _), 0.0) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_bread(_), todo_served(Child), allergic_gluten(Child), !.
delta(113, serve_sandwich(_, _, _, _), 0.00071095584076876) :- fewer_no_gluten_sandwich_than_todo_served, at_kitchen_bread(_), !.
delta(113, serve_sandwich(_, Child, _, _), 0.030240812445335625) :- fewer_no_gluten_sandwich_than_todo_served, todo_served(Child), !.
delta(113, serve_sandwich(_, _, _, _), -0.00011536530242130922) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(113, serve_sandwich(_, Child, _, _), 0.00018136006321171596) :- todo_served(Child), !.
delta(113, serve_sandwich(_, _, _, _), -0.00026057922248796836) :- !.
delta(113, move_tray(Tray, _, Place), 0.036978726118061675) :- at(Tray, kitchen), done_served(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(113, move_tray(Tray, _, Place), -7.504867371525256e-5) :- at(Tray, kitchen), done_served(Child), waiting(Child, Place), !.
delta(113, move_tray(Tray, _, _), -0.01917459628992457) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(113, move_tray(Tray, _, _), 0.0009976901877409125) :- at(Tray, kitchen), !.
delta(113, move_tray(_, Place, Place2), -0.013790973689872369) :- at(Tray, Place2), could_serve_sandwich(Tray, Place2), done_served(Child), waiting(Child, Place), !.
delta(113, move_tray(_, _, Place), 0.021274396184457242) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(113, move_tray(_, _, _), -0.08953308099252291) :- !.
delta(113, _, 0.0).

% tree 114: step size 1.0, 208 examples, 30 leaves
delta(114, make_sandwich_no_gluten(_, _, _), -0.10458874301778884) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(114, make_sandwich_no_gluten(_, _, _), 0.00026637067081311435) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(114, make_sandwich_no_gluten(_, _, _), 0.017073679625483545) :- fewer_at_2_than_allergic_gluten, !.
delta(114, make_sandwich_no_gluten(_, _, _), 0.0001911686826904321) :- at_kitchen_sandwich(_), !.
delta(114, make_sandwich_no_gluten(_, _, _), -0.0057588556783745425) :- !.
delta(114, make_sandwich(_, _, _), -0.0009096088667638482) :- goal_served(Child), done_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(114, make_sandwich(_, _, _), 0.027777505385837183) :- goal_served(Child), done_served(Child), !.
delta(114, make_sandwich(_, _, _), -0.021743795721242916) :- fewer_at_1_than_todo_served, !.
delta(114, make_sandwich(_, _, _), -3.813683201359751e-6) :- !.
delta(114, put_on_tray(_, _), 0.10643112075121988) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(114, put_on_tray(_, _), 0.00012226566863239057) :- fewer_at_1_than_allergic_gluten, !.
delta(114, put_on_tray(_, _), 0.0012798366069008513) :- goal_served(Child), done_served(Child), !.
delta(114, put_on_tray(_, _), -0.017714340619572527) :- !.
delta(114, serve_sandwich_no_gluten(_, Child, _, _), 0.004364519234161607) :- todo_served(Child), !.
delta(114, serve_sandwich_no_gluten(_, _, _, _), -0.0019147376846748122) :- !.
delta(114, serve_sandwich(_, _, _, _), -0.07712891849697055) :- fewer_ontray_2_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(114, serve_sandwich(_, _, _, _), 0.0029483269093147552) :- fewer_ontray_2_than_allergic_gluten, !.
delta(114, serve_sandwich(_, Child, _, _), 0.0001438832838290905) :- done_served(Child2), allergic_gluten(Child2), todo_served(Child), !.
delta(114, serve_sandwich(_, _, _, _), -0.00018425411531722266) :- done_served(Child), allergic_gluten(Child), !.
delta(114, serve_sandwich(_, Child, _, _), 0.05640639244330861) :- todo_served(Child), !.
delta(114, serve_sandwich(_, _, _, _), -0.00011894895962403802) :- !.
delta(114, move_tray(_, _, kitchen), 0.08862023885688719) :- at_kitchen_bread(_), fewer_at_1_than_todo_served, !.
delta(114, move_tray(_, _, kitchen), -1.2481098094839363e-5) :- at_kitchen_bread(_), !.
delta(114, move_tray(_, Place, kitchen), -0.010904408565596692) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(114, move_tray(_, _, kitchen), 0.006083941443074357) :- !.
delta(114, move_tray(_, _, Place), 0.01549108316049666) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child), !.
delta(114, move_tray(_, _, Place), -0.011357960549647574) :- done_served(Child), waiting(Child, Place), !.
delta(114, move_tray(_, _, _), -0.08814366367038318) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(114, move_tray(_, _, _), 0.00015570763964626685) :- !.
delta(114, _, 0.0).

% tree 115: step size 1.0, 206 examples, 28 leaves
delta(115, make_sandwich_no_gluten(_, _, _), 0.004935771304072559) :- no_gluten_sandwich(_), !.
delta(115, make_sandwich_no_gluten(_, _, _), -0.061309231405018524) :- fewer_at_1_than_not_allergic_gluten, !.
delta(115, make_sandwich_no_gluten(_, _, _), 3.6928245887681435e-5) :- !.
delta(115, make_sandwich(_, _, Content_portion), -0.014273912195568608) :- no_gluten_content(Content_portion), !.
delta(115, make_sandwich(_, Bread_portion, _), -0.0013893741607019009) :- fewer_ontray_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(115, make_sandwich(_, _, _), 0.08579602178734361) :- fewer_ontray_1_than_todo_served, !.
delta(115, make_sandwich(_, _, _), -0.0027568602731029464) :- !.
delta(115, put_on_tray(_, _), -0.004733086771446305) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(115, put_on_tray(_, _), 0.006798981164566306) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(115, put_on_tray(_, _), -9.09614454469905e-5) :- !.
delta(115, serve_sandwich_no_gluten(_, Child, _, _), 0.0016311490258075954) :- todo_served(Child), !.
delta(115, serve_sandwich_no_gluten(_, _, _, _), -0.002418588071958755) :- !.
delta(115, serve_sandwich(_, _, _, _), 0.0011439351835025467) :- at_kitchen_sandwich(_), fewer_ontray_2_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(115, serve_sandwich(_, _, _, _), -0.054561409921602085) :- at_kitchen_sandwich(_), fewer_ontray_2_than_allergic_gluten, !.
delta(115, serve_sandwich(_, _, _, _), 0.0063779816388874495) :- at_kitchen_sandwich(_), no_gluten_sandwich(_), !.
delta(115, serve_sandwich(_, _, _, _), -0.00010340817061893717) :- at_kitchen_sandwich(_), !.
delta(115, serve_sandwich(_, _, _, Place), 0.01952176570433994) :- done_served(Child), waiting(Child, Place), fewer_at_1_than_todo_served, !.
delta(115, serve_sandwich(_, _, _, Place), -1.0594740455963126e-6) :- done_served(Child), waiting(Child, Place), !.
delta(115, serve_sandwich(_, _, _, _), -0.00014690515144913924) :- fewer_ontray_2_than_allergic_gluten, !.
delta(115, serve_sandwich(_, _, _, _), 0.0008866321855784187) :- !.
delta(115, move_tray(_, Place, _), 0.007125409581525153) :- done_served(Child), not_allergic_gluten(Child), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(115, move_tray(_, Place, _), -0.03458440564011466) :- done_served(Child), not_allergic_gluten(Child), not_allergic_gluten(Child2), waiting(Child2, Place), !.
delta(115, move_tray(_, _, _), 0.00010021791180050303) :- done_served(Child), not_allergic_gluten(Child), !.
delta(115, move_tray(_, _, Place), -0.008204368737809078) :- fewer_ontray_2_than_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(115, move_tray(_, _, _), 0.06210919111078691) :- fewer_ontray_2_than_allergic_gluten, !.
delta(115, move_tray(_, _, Place), -0.018351882958458805) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(115, move_tray(_, _, _), 0.009181501640815984) :- !.
delta(115, _, 0.0).

% tree 116: step size 1.0, 232 examples, 29 leaves
delta(116, make_sandwich_no_gluten(_, _, _), 3.859113022397042e-6) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), fewer_at_1_than_not_allergic_gluten, !.
delta(116, make_sandwich_no_gluten(_, _, _), -0.014796948414677947) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(116, make_sandwich_no_gluten(_, _, _), 1.5877603089116526e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(116, make_sandwich_no_gluten(_, _, _), 0.019985732300835984) :- !.
delta(116, make_sandwich(_, _, _), 0.020240365007213604) :- at_kitchen_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(116, make_sandwich(_, _, _), -0.0008208637953478242) :- at_kitchen_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(116, make_sandwich(_, _, _), -0.0020565432374425735) :- at_kitchen_sandwich(_), !.
delta(116, make_sandwich(_, _, _), 4.634507804565108e-6) :- done_served(Child), not_allergic_gluten(Child), !.
delta(116, make_sandwich(_, _, _), -0.04090106831628611) :- !.
delta(116, put_on_tray(_, _), 0.000832792010680479) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(116, put_on_tray(_, Tray), -0.02121532556800169) :- goal_served(Child), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(116, put_on_tray(_, _), 0.0006317900289463565) :- goal_served(Child), allergic_gluten(Child), !.
delta(116, put_on_tray(_, _), 0.0005300132899564406) :- !.
delta(116, serve_sandwich_no_gluten(_, _, _, Place), -0.001989639957000807) :- done_served(Child), waiting(Child, Place), !.
delta(116, serve_sandwich_no_gluten(_, _, _, _), 0.007837449706237785) :- !.
delta(116, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_bread(_), done_served(Child), not_allergic_gluten(Child), !.
delta(116, serve_sandwich(_, _, _, _), 0.03418446001077452) :- at_kitchen_bread(_), !.
delta(116, serve_sandwich(_, _, _, _), -0.0008478542697956239) :- goal_served(Child), done_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(116, serve_sandwich(_, _, _, _), 0.006080940954531589) :- goal_served(Child), done_served(Child), !.
delta(116, serve_sandwich(_, _, _, _), -0.05534286422900835) :- notexist(_), !.
delta(116, serve_sandwich(_, _, _, _), 0.0005627712701692955) :- !.
delta(116, move_tray(_, _, Place), -0.0267689804067422) :- todo_served(Child), waiting(Child, Place), goal_served(Child2), done_served(Child2), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(116, move_tray(_, _, Place), 0.0038132388561195646) :- todo_served(Child), waiting(Child, Place), goal_served(Child2), done_served(Child2), !.
delta(116, move_tray(_, _, Place), -0.008049588368521878) :- todo_served(Child), waiting(Child, Place), fewer_ontray_2_than_allergic_gluten, !.
delta(116, move_tray(_, _, Place), 0.09822772154629676) :- todo_served(Child), waiting(Child, Place), !.
delta(116, move_tray(Tray, _, _), -0.06299611815763491) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(116, move_tray(_, _, kitchen), 0.035867340853673414) :- !.
delta(116, move_tray(_, _, _), -0.0037592802533690764) :- !.
delta(116, _, 0.0).

% tree 117: step size 1.0, 254 examples, 27 leaves
delta(117, make_sandwich_no_gluten(_, _, _), 0.020754078755942915) :- !.
delta(117, make_sandwich(_, _, _), -0.04468401603400305) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(117, make_sandwich(_, _, _), -2.7135105776792887e-5) :- fewer_ontray_2_than_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(117, make_sandwich(_, _, _), 4.2723576774329006e-5) :- fewer_ontray_2_than_allergic_gluten, !.
delta(117, make_sandwich(_, _, _), -0.004759676690126802) :- at_kitchen_sandwich(_), !.
delta(117, make_sandwich(_, _, _), -1.913889065237746e-5) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(117, make_sandwich(_, _, _), 0.004371946271469006) :- !.
delta(117, put_on_tray(_, _), 0.025048676778357253) :- no_gluten_sandwich(_), fewer_at_2_than_todo_served, !.
delta(117, put_on_tray(Sandwich, _), 0.0009423901987514451) :- no_gluten_sandwich(_), no_gluten_sandwich(Sandwich), !.
delta(117, put_on_tray(_, _), -0.002143755886811952) :- no_gluten_sandwich(_), !.
delta(117, put_on_tray(_, _), -0.008946348307734628) :- at_kitchen_bread(_), !.
delta(117, put_on_tray(_, _), 0.00024275867656493015) :- !.
delta(117, serve_sandwich_no_gluten(_, _, _, _), 0.0008672120467660577) :- !.
delta(117, serve_sandwich(_, Child, Tray, _), 0.055092880160171484) :- goal_served(Child2), done_served(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place), todo_served(Child), !.
delta(117, serve_sandwich(_, _, Tray, _), -0.0005031900183076822) :- goal_served(Child), done_served(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(117, serve_sandwich(_, Child, _, _), 2.888569002244158e-5) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(117, serve_sandwich(_, _, _, _), -3.934127806171833e-5) :- goal_served(Child), done_served(Child), !.
delta(117, serve_sandwich(_, _, _, _), -0.06042913582529885) :- notexist(_), !.
delta(117, serve_sandwich(_, _, _, _), -4.457127817217791e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(117, serve_sandwich(_, _, _, _), 0.005836414595190338) :- !.
delta(117, move_tray(_, Place, _), -0.0945907019520694) :- done_served(Child), waiting(Child, Place), not_allergic_gluten(Child2), waiting(Child2, Place), !.
delta(117, move_tray(_, Place, _), 0.0) :- done_served(Child), waiting(Child, Place), !.
delta(117, move_tray(_, _, Place), 1.556101207396415e-5) :- done_served(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(117, move_tray(_, _, Place), -0.02860142890848653) :- done_served(Child), waiting(Child, Place), !.
delta(117, move_tray(_, _, Place), -0.014736616641506464) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(117, move_tray(_, _, _), 0.1245992696944248) :- !.
delta(117, _, 0.0).

% tree 118: step size 1.0, 236 examples, 28 leaves
delta(118, make_sandwich_no_gluten(_, _, _), -0.0016917944100831805) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(118, make_sandwich_no_gluten(_, _, _), 0.025385811038823904) :- !.
delta(118, make_sandwich(_, _, _), 0.0006580959069775856) :- fewer_at_1_than_todo_served_not_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(118, make_sandwich(_, _, _), -0.00012093339466995952) :- fewer_at_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(118, make_sandwich(_, _, _), -0.05909381202394422) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(118, make_sandwich(_, _, _), -5.5255804008488224e-5) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(118, make_sandwich(_, _, _), 0.02737784812222126) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(118, make_sandwich(_, _, _), -0.00011585129520275593) :- !.
delta(118, put_on_tray(_, _), 0.018696205371240688) :- fewer_ontray_1_than_todo_served, !.
delta(118, put_on_tray(_, _), -0.0010493798625612137) :- !.
delta(118, serve_sandwich_no_gluten(_, _, _, _), 1.8566897568495203e-6) :- goal_served(Child), not_allergic_gluten(Child), at_kitchen_bread(_), !.
delta(118, serve_sandwich_no_gluten(_, _, _, _), 0.00021615470983714133) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(118, serve_sandwich_no_gluten(_, _, _, _), -0.0012587687616753287) :- !.
delta(118, serve_sandwich(Sandwich, _, _, _), -0.04286799284312929) :- fewer_ontray_2_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(118, serve_sandwich(_, _, _, _), 0.06234652406914014) :- fewer_ontray_2_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(118, serve_sandwich(_, _, _, _), 0.00040456339633633445) :- fewer_ontray_2_than_allergic_gluten, !.
delta(118, serve_sandwich(_, _, _, _), 0.00030839750778149846) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(118, serve_sandwich(_, _, _, _), -0.23302730419074116) :- fewer_ontray_2_than_todo_served, !.
delta(118, serve_sandwich(_, _, _, _), -2.2583784805361127e-5) :- !.
delta(118, move_tray(_, _, Place), 0.03266130209898623) :- fewer_ontray_2_than_allergic_gluten, done_served(Child), waiting(Child, Place), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(118, move_tray(_, _, Place), -0.020862745486928163) :- fewer_ontray_2_than_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(118, move_tray(_, Place, Place2), 0.002479684902706745) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(118, move_tray(_, _, _), -0.06936407921330755) :- fewer_ontray_2_than_allergic_gluten, !.
delta(118, move_tray(_, Place, Place2), -0.0023615999842120203) :- needed_at_to_serve_sandwich_no_gluten(Place2), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(118, move_tray(_, _, Place), 0.32903545203988555) :- needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(118, move_tray(_, _, _), 0.004148944873748477) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(118, move_tray(_, _, _), -0.014086800111410305) :- !.
delta(118, _, 0.0).

% tree 119: step size 1.0, 272 examples, 24 leaves
delta(119, make_sandwich_no_gluten(_, _, _), 0.017994349567170546) :- !.
delta(119, make_sandwich(_, _, _), 0.0) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(119, make_sandwich(_, _, _), -0.033362028621465756) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(119, make_sandwich(_, _, _), -0.001814499141989257) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(119, make_sandwich(_, _, _), 0.01841163176254637) :- at_kitchen_sandwich(_), !.
delta(119, make_sandwich(_, _, _), 0.0036706793125323195) :- todo_served(Child), allergic_gluten(Child), !.
delta(119, make_sandwich(_, _, _), -0.00936167831046566) :- !.
delta(119, put_on_tray(_, _), 0.010252352615082422) :- no_gluten_bread(_), !.
delta(119, put_on_tray(_, _), -0.017877404555582885) :- at_kitchen_bread(_), !.
delta(119, put_on_tray(_, _), 0.00021371265157342682) :- !.
delta(119, serve_sandwich_no_gluten(_, Child, _, _), 0.003249562103437426) :- todo_served(Child), !.
delta(119, serve_sandwich_no_gluten(_, _, _, _), -0.005795531629956283) :- !.
delta(119, serve_sandwich(_, _, _, _), -0.01965816827960264) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(119, serve_sandwich(_, _, _, _), 1.1008339726396264e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(119, serve_sandwich(_, _, _, _), 0.038523078291707306) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(119, serve_sandwich(_, _, _, _), 0.0006571796554981233) :- !.
delta(119, move_tray(Tray, kitchen, _), -0.009420843325705761) :- ontray(_, Tray), todo_served(Child), allergic_gluten(Child), !.
delta(119, move_tray(Tray, _, _), 0.022245263545996773) :- ontray(_, Tray), todo_served(Child), allergic_gluten(Child), !.
delta(119, move_tray(Tray, _, Place), 0.006870996789876663) :- ontray(_, Tray), at(_, Place), !.
delta(119, move_tray(Tray, _, _), -0.04651890971945477) :- ontray(_, Tray), !.
delta(119, move_tray(_, Place, Place2), -0.0008792875933447033) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(119, move_tray(_, Place, Place2), 0.018290996807111957) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(119, move_tray(_, _, _), -0.003904682242638011) :- !.
delta(119, _, 0.0).

% tree 120: step size 1.0, 286 examples, 29 leaves
delta(120, make_sandwich_no_gluten(_, _, _), 0.0010267487983799956) :- at_kitchen_sandwich(_), !.
delta(120, make_sandwich_no_gluten(_, _, _), -0.05921815634899816) :- fewer_ontray_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(120, make_sandwich_no_gluten(_, _, _), 1.9371145288861347e-5) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(120, make_sandwich_no_gluten(_, _, _), 7.25819654589953e-5) :- !.
delta(120, make_sandwich(_, _, Content_portion), -0.0022396906010211585) :- no_gluten_content(Content_portion), !.
delta(120, make_sandwich(_, _, _), -0.0013299519740700596) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(120, make_sandwich(_, _, _), 0.06029899175718812) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(120, make_sandwich(_, _, _), -9.141357289507199e-5) :- !.
delta(120, put_on_tray(_, Tray), 0.011814843261571024) :- ontray(_, Tray), !.
delta(120, put_on_tray(_, _), 1.75766221019166e-5) :- fewer_no_gluten_sandwich_than_todo_served, goal_served(Child), done_served(Child), !.
delta(120, put_on_tray(_, _), -0.012500420092538333) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(120, put_on_tray(_, _), 0.0003170986512765025) :- !.
delta(120, serve_sandwich_no_gluten(_, _, _, _), 0.0069332021588441265) :- !.
delta(120, serve_sandwich(_, Child, Tray, _), 0.005296823331253219) :- done_served(Child2), not_allergic_gluten(Child2), waiting(Child2, Place), could_serve_sandwich(Tray, Place), todo_served(Child), !.
delta(120, serve_sandwich(_, _, Tray, _), -0.0003497800733224282) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(120, serve_sandwich(_, _, Tray, _), -0.002751453973385014) :- done_served(Child), not_allergic_gluten(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(120, serve_sandwich(_, _, _, _), 7.281189842610711e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(120, serve_sandwich(_, _, _, _), -0.1314973799489083) :- notexist(_), !.
delta(120, serve_sandwich(_, _, _, _), -4.524277645400056e-6) :- goal_served(Child), allergic_gluten(Child), !.
delta(120, serve_sandwich(_, _, _, _), 0.0025807143895713322) :- !.
delta(120, move_tray(_, _, Place), 0.0070802244906838984) :- at(Tray, Place), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(120, move_tray(_, _, Place), -0.005566102309257551) :- at(_, Place), allergic_gluten(Child), waiting(Child, Place), !.
delta(120, move_tray(_, _, Place), 2.0698720774730693e-5) :- at(Tray, Place), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(120, move_tray(_, _, Place), -0.0379282301755209) :- at(_, Place), !.
delta(120, move_tray(Tray, _, _), -0.013774957679016186) :- at(Tray, kitchen), fewer_at_2_than_todo_served, !.
delta(120, move_tray(Tray, _, _), 0.0017185235958558256) :- at(Tray, kitchen), !.
delta(120, move_tray(_, _, _), -0.00921344134351375) :- done_served(Child), not_allergic_gluten(Child), !.
delta(120, move_tray(_, _, _), 0.17787862506324398) :- !.
delta(120, _, 0.0).

% tree 121: step size 1.0, 254 examples, 24 leaves
delta(121, make_sandwich_no_gluten(_, _, _), 0.00039338825700047374) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(121, make_sandwich_no_gluten(_, _, _), -0.1978602275382202) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(121, make_sandwich_no_gluten(_, _, _), 4.787866251090995e-5) :- !.
delta(121, make_sandwich(_, _, _), 0.17112057561880603) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), todo_served(Child), not_allergic_gluten(Child), !.
delta(121, make_sandwich(_, _, _), -3.92544710389289e-5) :- at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(121, make_sandwich(_, _, _), 0.00012492459041571211) :- done_served(Child), not_allergic_gluten(Child), !.
delta(121, make_sandwich(_, _, _), -0.00986886283311704) :- at_kitchen_sandwich(_), !.
delta(121, make_sandwich(_, _, _), -1.2158114156239846e-5) :- !.
delta(121, put_on_tray(_, _), 0.009302807538958157) :- !.
delta(121, serve_sandwich_no_gluten(_, _, _, _), 0.004378123373929157) :- fewer_ontray_2_than_todo_served, !.
delta(121, serve_sandwich_no_gluten(_, _, _, _), -0.0011394105844898226) :- done_served(Child), allergic_gluten(Child), !.
delta(121, serve_sandwich_no_gluten(_, _, _, _), 0.0005967412779632588) :- !.
delta(121, serve_sandwich(_, _, _, _), 0.0678191385090487) :- at_kitchen_sandwich(_), no_gluten_bread(_), !.
delta(121, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_sandwich(_), !.
delta(121, serve_sandwich(_, _, _, _), 0.008910051388986113) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(121, serve_sandwich(_, _, _, _), -0.09153085079736761) :- notexist(_), !.
delta(121, serve_sandwich(_, _, _, _), 0.0030183788121529473) :- !.
delta(121, move_tray(_, Place, Place2), -0.004352926007702912) :- at_kitchen_sandwich(_), at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_not_allergic_gluten, !.
delta(121, move_tray(_, Place, Place2), 0.027070525362537994) :- at_kitchen_sandwich(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(121, move_tray(_, _, _), -0.09000371461602938) :- at_kitchen_sandwich(_), !.
delta(121, move_tray(_, Place, _), -0.01393829223349133) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(121, move_tray(_, _, Place), -0.00915641854262337) :- at(Tray, Place), ontray(_, Tray), !.
delta(121, move_tray(_, _, _), 0.11783152661289702) :- !.
delta(121, _, 0.0).

% tree 122: step size 1.0, 208 examples, 29 leaves
delta(122, make_sandwich_no_gluten(_, _, _), 0.00011987345188256093) :- fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(122, make_sandwich_no_gluten(_, _, _), -0.14045976055234605) :- fewer_at_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(122, make_sandwich_no_gluten(_, _, _), 5.0660430630305245e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(122, make_sandwich_no_gluten(_, _, _), 0.008847175861824597) :- !.
delta(122, make_sandwich(_, _, _), -0.0002671787370914855) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(122, make_sandwich(_, Bread_portion, _), -0.0001387761512707619) :- fewer_at_2_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(122, make_sandwich(_, _, _), 0.1668664934691746) :- fewer_at_2_than_allergic_gluten, !.
delta(122, make_sandwich(_, _, _), -0.011540119958340433) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(122, make_sandwich(_, _, _), 0.006745335272116073) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(122, make_sandwich(_, _, _), -2.1287009902185007e-5) :- !.
delta(122, put_on_tray(_, _), 0.007080171150451302) :- fewer_ontray_1_than_todo_served, !.
delta(122, put_on_tray(_, _), -0.00021142561856263154) :- !.
delta(122, serve_sandwich_no_gluten(_, _, _, _), 0.0004272538686874358) :- fewer_ontray_2_than_todo_served, !.
delta(122, serve_sandwich_no_gluten(_, _, _, _), -0.006993124740029894) :- !.
delta(122, serve_sandwich(_, _, _, _), -0.048035479933996025) :- fewer_ontray_1_than_todo_served, notexist(_), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(122, serve_sandwich(_, _, _, _), 0.00010234276357964327) :- fewer_ontray_1_than_todo_served, notexist(_), !.
delta(122, serve_sandwich(_, _, _, _), -6.40199979989934e-5) :- fewer_ontray_1_than_todo_served, goal_served(Child), done_served(Child), !.
delta(122, serve_sandwich(_, _, _, _), 0.00422253586870955) :- fewer_ontray_1_than_todo_served, !.
delta(122, serve_sandwich(Sandwich, Child, _, Place), -1.648639849038616e-5) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(122, serve_sandwich(_, Child, _, _), 0.015203573590695282) :- todo_served(Child), !.
delta(122, serve_sandwich(_, _, _, _), -0.00014364558883128643) :- !.
delta(122, move_tray(_, Place, Place2), 0.007363392796622834) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), needed_at_to_serve_sandwich_no_gluten(Place2), !.
delta(122, move_tray(_, Place, _), -0.0017239439378232016) :- allergic_gluten(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(122, move_tray(_, Place, _), -0.07321340602559967) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(122, move_tray(Tray, _, _), 0.07793088872801467) :- notexist(_), ontray(_, Tray), !.
delta(122, move_tray(_, _, _), -0.006069658953100725) :- notexist(_), !.
delta(122, move_tray(Tray, _, _), 0.002432923920301489) :- at(Tray, kitchen), !.
delta(122, move_tray(_, _, _), -0.010919274923413415) :- !.
delta(122, _, 0.0).

% tree 123: step size 1.0, 245 examples, 26 leaves
delta(123, make_sandwich_no_gluten(_, _, _), 0.0015386647256974892) :- !.
delta(123, make_sandwich(_, _, _), -0.029933900381786553) :- goal_served(Child), allergic_gluten(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(123, make_sandwich(_, _, _), -0.000250358677548747) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(123, make_sandwich(_, _, _), 0.0014503147625701091) :- goal_served(Child), allergic_gluten(Child), !.
delta(123, make_sandwich(_, _, _), 0.0022267323332053114) :- !.
delta(123, put_on_tray(_, _), -0.004912969038213775) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(123, put_on_tray(_, _), 0.0002463107749954612) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(123, put_on_tray(_, _), 0.0114999604062404) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(123, put_on_tray(_, _), -0.0004693505963688816) :- !.
delta(123, serve_sandwich_no_gluten(_, _, _, _), 0.0028459840428810015) :- !.
delta(123, serve_sandwich(Sandwich, _, _, _), -0.024694391025226605) :- done_served(Child), not_allergic_gluten(Child), no_gluten_sandwich(Sandwich), !.
delta(123, serve_sandwich(_, _, _, Place), 0.032442938875164945) :- done_served(Child), not_allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(123, serve_sandwich(_, _, _, _), 0.00020584633281507827) :- done_served(Child), not_allergic_gluten(Child), !.
delta(123, serve_sandwich(Sandwich, _, _, _), -0.03221020380984535) :- at_kitchen_bread(_), no_gluten_sandwich(Sandwich), !.
delta(123, serve_sandwich(_, _, _, _), 0.028319154529792622) :- at_kitchen_bread(_), !.
delta(123, serve_sandwich(_, _, _, _), -0.14644563122372306) :- notexist(_), !.
delta(123, serve_sandwich(_, _, _, _), 0.003127891680528383) :- !.
delta(123, move_tray(_, Place, Place2), -0.005053949294100691) :- done_served(Child), not_allergic_gluten(Child), at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_allergic_gluten, !.
delta(123, move_tray(_, Place, Place2), 0.007232693711872433) :- done_served(Child), not_allergic_gluten(Child), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(123, move_tray(_, _, _), -0.017488663348204345) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_2_than_todo_served, !.
delta(123, move_tray(_, _, _), 2.367034376311209e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(123, move_tray(_, Place, Place2), -0.021283966730039308) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_ontray_2_than_allergic_gluten, !.
delta(123, move_tray(_, Place, Place2), 0.012530774572342276) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(123, move_tray(_, _, _), 0.18956307759208665) :- notexist(_), !.
delta(123, move_tray(_, _, _), -0.004000413710605555) :- !.
delta(123, _, 0.0).

% tree 124: step size 1.0, 226 examples, 33 leaves
delta(124, make_sandwich_no_gluten(_, _, _), 0.04356919553151541) :- fewer_at_2_than_allergic_gluten, !.
delta(124, make_sandwich_no_gluten(_, _, _), 0.0003555494413677212) :- at_kitchen_sandwich(_), !.
delta(124, make_sandwich_no_gluten(_, _, _), -0.05140591797506175) :- fewer_ontray_1_than_allergic_gluten, !.
delta(124, make_sandwich_no_gluten(_, _, _), 0.00021838173198407632) :- !.
delta(124, make_sandwich(_, _, _), -0.08420545640898629) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_todo_served, !.
delta(124, make_sandwich(_, _, _), 0.0) :- fewer_at_2_than_allergic_gluten, !.
delta(124, make_sandwich(_, _, Content_portion), -0.0007329885316963105) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), no_gluten_content(Content_portion), !.
delta(124, make_sandwich(_, _, _), 0.05164953139605677) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(124, make_sandwich(_, _, _), -0.02294755220462518) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(124, make_sandwich(_, _, _), 0.0015720621703780215) :- !.
delta(124, put_on_tray(_, Tray), 0.00498227471109409) :- fewer_at_2_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(124, put_on_tray(_, _), -0.009947222124160084) :- fewer_at_2_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(124, put_on_tray(_, _), 6.6749135825162045e-6) :- fewer_at_2_than_allergic_gluten, !.
delta(124, put_on_tray(_, _), 0.015542335140450461) :- fewer_at_2_than_todo_served, !.
delta(124, put_on_tray(_, _), -9.171023536255224e-6) :- !.
delta(124, serve_sandwich_no_gluten(_, Child, _, _), 6.827990168824448e-5) :- todo_served(Child), at_kitchen_bread(_), !.
delta(124, serve_sandwich_no_gluten(_, Child, _, _), 0.002505986108958537) :- todo_served(Child), !.
delta(124, serve_sandwich_no_gluten(_, _, _, _), -0.056462593690771654) :- !.
delta(124, serve_sandwich(Sandwich, _, _, Place), -0.0006146482409818332) :- no_gluten_sandwich(_), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(124, serve_sandwich(Sandwich, _, _, _), -9.451354924242474e-5) :- no_gluten_sandwich(_), no_gluten_sandwich(Sandwich), !.
delta(124, serve_sandwich(_, _, _, _), 0.07279334567773739) :- no_gluten_sandwich(_), !.
delta(124, serve_sandwich(_, _, _, _), -0.052827130341754694) :- at_kitchen_sandwich(_), at_kitchen_bread(_), !.
delta(124, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_sandwich(_), !.
delta(124, serve_sandwich(_, _, _, _), 0.018315166764766314) :- !.
delta(124, move_tray(_, _, _), -0.00021392055601235417) :- at_kitchen_bread(_), fewer_at_1_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(124, move_tray(_, _, _), 0.07976006733854123) :- at_kitchen_bread(_), fewer_at_1_than_not_allergic_gluten, !.
delta(124, move_tray(_, Place, Place2), 0.00037006222199215794) :- at_kitchen_bread(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(124, move_tray(_, _, _), -0.0022085232502128188) :- at_kitchen_bread(_), !.
delta(124, move_tray(Tray, _, Place), -0.0013389964390852125) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(124, move_tray(Tray, _, Place), 0.003940254541598356) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(124, move_tray(Tray, _, _), 0.001973952668714142) :- at(Tray, kitchen), !.
delta(124, move_tray(_, _, _), -0.034049067289966276) :- !.
delta(124, _, 0.0).

% tree 125: step size 1.0, 248 examples, 28 leaves
delta(125, make_sandwich_no_gluten(_, _, _), 0.00020293406177989892) :- fewer_at_1_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(125, make_sandwich_no_gluten(_, _, _), -9.615626442440485e-18) :- fewer_at_1_than_allergic_gluten, !.
delta(125, make_sandwich_no_gluten(_, _, _), 0.034701600667480535) :- !.
delta(125, make_sandwich(_, _, _), -0.00036393146645682977) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(125, make_sandwich(_, _, _), 0.006355532141833947) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), todo_served(Child), not_allergic_gluten(Child), !.
delta(125, make_sandwich(_, _, _), -0.0001035563909110656) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(125, make_sandwich(_, _, _), 0.00036323097070905) :- fewer_no_gluten_sandwich_than_todo_served, done_served(Child), not_allergic_gluten(Child), !.
delta(125, make_sandwich(_, _, _), -0.07730539690357291) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(125, make_sandwich(_, _, _), -0.0006207725578123526) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(125, make_sandwich(_, _, _), 0.004366490832750195) :- !.
delta(125, put_on_tray(_, _), 0.0002144165997553807) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(125, put_on_tray(_, _), -0.01989048841679282) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(125, put_on_tray(Sandwich, _), 0.0006220384433407222) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(125, put_on_tray(_, _), -0.00035957855575700784) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(125, put_on_tray(_, _), 0.006173519173701417) :- !.
delta(125, serve_sandwich_no_gluten(_, _, _, _), 0.0018493665995666705) :- !.
delta(125, serve_sandwich(Sandwich, _, _, _), -0.030911436324509906) :- no_gluten_sandwich(Sandwich), !.
delta(125, serve_sandwich(_, Child, _, _), 0.08962511353134472) :- todo_served(Child), !.
delta(125, serve_sandwich(_, _, _, _), -0.00012285375707903466) :- !.
delta(125, move_tray(Tray, _, Place), 0.035858286132677136) :- could_serve_sandwich_no_gluten(Tray, Place), goal_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(125, move_tray(Tray, _, Place), -0.001484227056571251) :- could_serve_sandwich_no_gluten(Tray, Place), goal_served(Child), not_allergic_gluten(Child), !.
delta(125, move_tray(Tray, _, Place), 9.874230930354705e-5) :- could_serve_sandwich_no_gluten(Tray, Place), at_kitchen_bread(_), !.
delta(125, move_tray(Tray, _, Place), -0.0020893033152898925) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(125, move_tray(_, Place, _), 0.001955881218190201) :- at(Tray, Place), ontray(_, Tray), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(125, move_tray(_, Place, _), -0.07131607127660596) :- at(Tray, Place), ontray(_, Tray), !.
delta(125, move_tray(_, _, Place), -0.0004735742507267824) :- not_allergic_gluten(Child), waiting(Child, Place), !.
delta(125, move_tray(_, _, _), 0.01460835454834101) :- !.
delta(125, _, 0.0).

% tree 126: step size 1.0, 255 examples, 34 leaves
delta(126, make_sandwich_no_gluten(_, _, _), -0.020025557414394258) :- goal_served(Child), done_served(Child), !.
delta(126, make_sandwich_no_gluten(_, _, _), 0.00044524981787683954) :- !.
delta(126, make_sandwich(_, _, _), -0.00027000714446991916) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(126, make_sandwich(_, _, _), 0.006293134113932516) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(126, make_sandwich(_, _, _), -0.00312040932981648) :- no_gluten_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(126, make_sandwich(_, _, _), 0.00014455695841878767) :- no_gluten_sandwich(_), !.
delta(126, make_sandwich(_, _, _), -0.021498945784335925) :- at_kitchen_sandwich(_), !.
delta(126, make_sandwich(_, _, _), -2.4834171224631797e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(126, make_sandwich(_, _, _), 0.0015454112501878186) :- !.
delta(126, put_on_tray(_, _), 0.004644115061362553) :- at_kitchen_bread(_), !.
delta(126, put_on_tray(_, _), 0.0003100015084959215) :- done_served(Child), not_allergic_gluten(Child), !.
delta(126, put_on_tray(_, _), -0.032927179374062476) :- no_gluten_sandwich(_), !.
delta(126, put_on_tray(_, _), 0.00014508314614457112) :- !.
delta(126, serve_sandwich_no_gluten(_, _, _, _), 0.004989914900509562) :- at_kitchen_bread(_), !.
delta(126, serve_sandwich_no_gluten(_, _, _, _), -0.008499585729430001) :- fewer_no_gluten_sandwich_than_todo_served, goal_served(Child), done_served(Child), !.
delta(126, serve_sandwich_no_gluten(_, _, _, _), 9.517585878025758e-5) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(126, serve_sandwich_no_gluten(_, _, _, _), 3.1059775685745614e-6) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(126, serve_sandwich_no_gluten(_, _, _, _), 0.0006220801065841997) :- !.
delta(126, serve_sandwich(_, _, _, _), 0.006528647213336328) :- fewer_ontray_2_than_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(126, serve_sandwich(_, _, _, _), 0.0) :- fewer_ontray_2_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(126, serve_sandwich(_, _, _, _), -0.1288786326439714) :- fewer_ontray_2_than_allergic_gluten, !.
delta(126, serve_sandwich(_, _, _, Place), 0.0042626519562240246) :- goal_served(Child), allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(126, serve_sandwich(_, _, _, _), -0.004571238639110217) :- goal_served(Child), allergic_gluten(Child), !.
delta(126, serve_sandwich(_, Child, _, _), 0.041164968564273006) :- todo_served(Child), !.
delta(126, serve_sandwich(_, _, _, _), -0.00010290889102960268) :- !.
delta(126, move_tray(Tray, Place, _), 0.0016298905509564013) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_serve_sandwich(Tray2, Place), !.
delta(126, move_tray(Tray, _, _), -0.012857873619302662) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(126, move_tray(_, _, _), 0.1826932471990941) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(126, move_tray(_, _, _), -0.004615865450265584) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(126, move_tray(_, Place, Place2), 0.008292647592375602) :- fewer_ontray_2_than_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(126, move_tray(_, _, _), -0.003940294041694106) :- fewer_ontray_2_than_allergic_gluten, !.
delta(126, move_tray(_, Place, Place2), 0.001758497044248914) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(126, move_tray(_, _, _), -0.024412849168344616) :- !.
delta(126, _, 0.0).

% tree 127: step size 1.0, 246 examples, 29 leaves
delta(127, make_sandwich_no_gluten(_, _, _), 9.00667260379693e-5) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(127, make_sandwich_no_gluten(_, _, _), -0.12468885202205665) :- fewer_at_2_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(127, make_sandwich_no_gluten(_, _, _), 4.733164393175435e-6) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(127, make_sandwich_no_gluten(_, _, _), 0.00444298196068334) :- !.
delta(127, make_sandwich(_, _, _), -0.011908579094513016) :- goal_served(Child), done_served(Child), waiting(Child, Place), needed_at_to_serve_sandwich_no_gluten(Place), !.
delta(127, make_sandwich(_, _, _), -0.0015836908299432) :- goal_served(Child), done_served(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(127, make_sandwich(_, _, _), 0.002100654872410728) :- goal_served(Child), done_served(Child), !.
delta(127, make_sandwich(_, Bread_portion, _), -0.0004729461969215719) :- no_gluten_bread(Bread_portion), !.
delta(127, make_sandwich(_, _, Content_portion), -0.00025662901563369375) :- no_gluten_content(Content_portion), !.
delta(127, make_sandwich(_, _, _), 0.14965084631678016) :- !.
delta(127, put_on_tray(_, Tray), -0.006045672766730108) :- ontray(_, Tray), fewer_at_1_than_allergic_gluten, !.
delta(127, put_on_tray(_, Tray), 0.010923950233407262) :- ontray(_, Tray), !.
delta(127, put_on_tray(_, _), 0.0008073160607079298) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(127, put_on_tray(_, _), 9.50349053280361e-6) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(127, put_on_tray(_, _), -0.007210237357604715) :- !.
delta(127, serve_sandwich_no_gluten(_, _, _, _), -0.007478313894122979) :- fewer_ontray_1_than_allergic_gluten, !.
delta(127, serve_sandwich_no_gluten(_, _, _, _), 0.0002164980792236349) :- !.
delta(127, serve_sandwich(_, _, _, _), -0.06350986196453433) :- fewer_at_1_than_allergic_gluten, fewer_ontray_2_than_todo_served, !.
delta(127, serve_sandwich(_, _, _, _), 1.8557896323722995e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(127, serve_sandwich(_, Child, _, _), 0.029354212311970468) :- todo_served(Child), !.
delta(127, serve_sandwich(_, _, _, _), -0.0005239054717915833) :- !.
delta(127, move_tray(_, Place, _), -0.002356973578464579) :- fewer_at_1_than_allergic_gluten, goal_served(Child), done_served(Child), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(127, move_tray(_, _, _), 0.0774816724113593) :- fewer_at_1_than_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(127, move_tray(_, _, _), -0.003184168694450303) :- fewer_at_1_than_allergic_gluten, !.
delta(127, move_tray(_, _, Place), 0.002933620222726731) :- no_gluten_bread(_), done_served(Child), waiting(Child, Place), !.
delta(127, move_tray(_, _, _), -0.06186826180440401) :- no_gluten_bread(_), !.
delta(127, move_tray(_, Place, _), 0.002139929623565342) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(127, move_tray(_, _, _), -0.002902017586940785) :- !.
delta(127, _, 0.0).

% tree 128: step size 1.0, 262 examples, 25 leaves
delta(128, make_sandwich_no_gluten(_, _, _), -0.013214262541902886) :- done_served(Child), allergic_gluten(Child), !.
delta(128, make_sandwich_no_gluten(_, _, _), 0.032064029246434006) :- !.
delta(128, make_sandwich(_, _, _), -0.0006106377223018569) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(128, make_sandwich(_, _, _), 0.006423152417973506) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(128, make_sandwich(_, _, _), -0.04506707538915319) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(128, make_sandwich(_, _, _), 2.388173487471586e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(128, make_sandwich(_, _, _), 1.9612925523833508e-5) :- !.
delta(128, put_on_tray(_, Tray), 0.015451734242866258) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(128, put_on_tray(_, _), -0.010014783147465149) :- fewer_ontray_1_than_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(128, put_on_tray(_, _), 0.00011683027995455436) :- fewer_ontray_1_than_allergic_gluten, !.
delta(128, put_on_tray(_, _), 0.0011634645886370088) :- !.
delta(128, serve_sandwich_no_gluten(_, Child, _, _), 0.001161926199233087) :- todo_served(Child), !.
delta(128, serve_sandwich_no_gluten(_, _, _, _), -0.0028486341567583637) :- !.
delta(128, serve_sandwich(_, _, _, Place), 0.0005427700378457116) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(128, serve_sandwich(_, _, _, Place), -2.8034778701239974e-5) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child), !.
delta(128, serve_sandwich(_, _, _, Place), -0.2338354497269717) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(128, serve_sandwich(_, _, _, _), 0.0) :- at_kitchen_bread(_), !.
delta(128, serve_sandwich(_, Child, _, _), 0.019366935724716476) :- todo_served(Child), !.
delta(128, serve_sandwich(_, _, _, _), -0.0001997175469931868) :- !.
delta(128, move_tray(Tray, _, Place), -0.0014702790311132059) :- goal_served(Child), allergic_gluten(Child), ontray(_, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(128, move_tray(Tray, _, _), 0.24987281314298823) :- goal_served(Child), allergic_gluten(Child), ontray(_, Tray), !.
delta(128, move_tray(_, _, _), -0.012998858566380493) :- goal_served(Child), allergic_gluten(Child), goal_served(Child2), not_allergic_gluten(Child2), !.
delta(128, move_tray(_, _, _), 4.373408153322138e-5) :- goal_served(Child), allergic_gluten(Child), !.
delta(128, move_tray(_, _, _), -0.016391001931500553) :- !.
delta(128, _, 0.0).

% tree 129: step size 1.0, 212 examples, 20 leaves
delta(129, make_sandwich_no_gluten(_, _, _), 0.011424954609155848) :- !.
delta(129, make_sandwich(_, _, _), 1.6576091909662201e-6) :- no_gluten_bread(_), done_served(Child), not_allergic_gluten(Child), !.
delta(129, make_sandwich(_, _, _), -0.032914129676532476) :- no_gluten_bread(_), !.
delta(129, make_sandwich(_, _, _), 0.011265113998576652) :- !.
delta(129, put_on_tray(_, _), 0.007756334795564904) :- fewer_ontray_1_than_todo_served, !.
delta(129, put_on_tray(_, _), -7.577036845216703e-5) :- !.
delta(129, serve_sandwich_no_gluten(_, _, _, _), 0.0015439778312483568) :- !.
delta(129, serve_sandwich(_, _, _, Place), -0.07251415257120013) :- done_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), waiting(Child, Place), !.
delta(129, serve_sandwich(_, _, _, _), 0.008851090891254142) :- done_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(129, serve_sandwich(_, _, Tray, _), -0.010086620084141658) :- done_served(Child), not_allergic_gluten(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(129, serve_sandwich(_, _, _, _), 0.0567403657842962) :- done_served(Child), not_allergic_gluten(Child), !.
delta(129, serve_sandwich(_, _, _, _), 0.123699818329051) :- !.
delta(129, move_tray(_, Place, Place2), -2.139439767201731e-5) :- at(Tray, Place), could_put_on_tray(Tray, Place2), allergic_gluten(Child), waiting(Child, Place), todo_served(Child), !.
delta(129, move_tray(_, Place, Place2), 0.06537703093250076) :- at(Tray, Place), could_put_on_tray(Tray, Place2), allergic_gluten(Child), waiting(Child, Place), !.
delta(129, move_tray(_, Place, Place2), 5.674596990714775e-6) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(129, move_tray(_, Place, Place2), -0.04276531543780543) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(129, move_tray(_, Place, Place2), 0.024096072793409296) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(129, move_tray(_, Place, Place2), -0.0007615250322075688) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(129, move_tray(_, _, _), -0.16048784474728345) :- !.
delta(129, _, 0.0).

% tree 130: step size 1.0, 214 examples, 29 leaves
delta(130, make_sandwich_no_gluten(_, _, _), -0.0804434104454259) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(130, make_sandwich_no_gluten(_, _, _), 1.0360583196330081e-5) :- fewer_ontray_1_than_allergic_gluten, !.
delta(130, make_sandwich_no_gluten(_, _, _), 7.977154381011096e-5) :- !.
delta(130, make_sandwich(_, _, _), -0.0005411072687126156) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(130, make_sandwich(_, Bread_portion, _), -0.0007635858061007726) :- fewer_ontray_1_than_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(130, make_sandwich(_, _, _), 0.12232162953036463) :- fewer_ontray_1_than_allergic_gluten, !.
delta(130, make_sandwich(_, _, _), 0.002878073364023108) :- done_served(Child), not_allergic_gluten(Child), !.
delta(130, make_sandwich(_, _, _), -0.023959473113862897) :- fewer_at_1_than_not_allergic_gluten, !.
delta(130, make_sandwich(_, _, _), 0.0022597706768016437) :- !.
delta(130, put_on_tray(_, _), -0.026027752909538723) :- fewer_ontray_2_than_allergic_gluten, fewer_at_2_than_todo_served_allergic_gluten, !.
delta(130, put_on_tray(_, _), 0.0007230418569220337) :- fewer_ontray_2_than_allergic_gluten, !.
delta(130, put_on_tray(_, Tray), 0.006135877455621736) :- ontray(_, Tray), !.
delta(130, put_on_tray(_, _), 8.242816866566224e-6) :- !.
delta(130, serve_sandwich_no_gluten(_, _, _, _), 0.0005799112105779117) :- !.
delta(130, serve_sandwich(Sandwich, _, _, _), -0.02140887300610587) :- notexist(_), no_gluten_sandwich(Sandwich), !.
delta(130, serve_sandwich(_, _, _, _), 0.031231494902160043) :- notexist(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(130, serve_sandwich(_, _, _, _), 0.0005382861174767468) :- notexist(_), !.
delta(130, serve_sandwich(_, _, _, _), -0.11965949588161193) :- done_served(Child), not_allergic_gluten(Child), at_kitchen_sandwich(_), !.
delta(130, serve_sandwich(_, _, _, _), 0.0006641558169076213) :- done_served(Child), not_allergic_gluten(Child), !.
delta(130, serve_sandwich(_, _, _, _), 0.00189068843169105) :- !.
delta(130, move_tray(Tray, _, kitchen), -0.00040710045979842587) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), ontray(Sandwich, Tray), !.
delta(130, move_tray(_, _, kitchen), 0.0017305465361027363) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(130, move_tray(_, _, kitchen), 2.747519184569456e-5) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(130, move_tray(_, _, kitchen), -0.04401657369026364) :- !.
delta(130, move_tray(_, Place, _), -0.0258526101434619) :- allergic_gluten(Child), waiting(Child, Place), todo_served(Child2), waiting(Child2, Place), !.
delta(130, move_tray(_, Place, _), 0.0010572722088187437) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(130, move_tray(_, Place, Place2), -0.00015661803765309714) :- at(Tray, Place2), could_put_on_tray(Tray, Place), !.
delta(130, move_tray(_, _, _), 0.16830795985485733) :- !.
delta(130, _, 0.0).
