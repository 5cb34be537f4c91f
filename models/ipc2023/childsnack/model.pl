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
model(domain_sha256, '6f3810c45f1e033ccab5a08290863159239334d85f482db5e46751cfbf553c21').
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
model(literal, could_put_on_tray(tray, place)).
model(literal, could_serve_sandwich_no_gluten(tray, place)).
model(literal, could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(tray, place)).
model(literal, could_serve_sandwich(tray, place)).
model(literal, could_serve_sandwich_through_waiting_back_for_todo_served_1_place(tray, place)).
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
model(bias_sha256, '523f9861a55af4a72106d902f4f3d18b57dec0c4dadcb60c8dfb6fbc91c5ad2f').
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
model(trained_episodes, 1231).
model(trees, 125).

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

% tree 1: step size 1.0, 212 examples, 6 leaves
delta(1, make_sandwich_no_gluten(_, _, _), 1.2729392779806734) :- !.
delta(1, put_on_tray(_, _), 0.6940060446651182) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(1, put_on_tray(_, _), -0.03974907593633349) :- !.
delta(1, serve_sandwich_no_gluten(_, _, _, _), 0.5432685654062448) :- !.
delta(1, make_sandwich(_, _, _), -0.785092898864737) :- !.
delta(1, _, -0.31902501450192755).

% tree 2: step size 1.0, 207 examples, 6 leaves
delta(2, make_sandwich(_, _, _), -0.8713209918027874) :- fewer_ontray_1_than_allergic_gluten, !.
delta(2, make_sandwich(_, _, _), 0.060223068001297196) :- !.
delta(2, move_tray(Tray, _, Place), 0.9005058335392208) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(2, move_tray(_, _, kitchen), 0.3108695160080647) :- !.
delta(2, move_tray(_, _, _), -0.9858806854729081) :- !.
delta(2, _, 0.8999160500429453).

% tree 3: step size 1.0, 202 examples, 13 leaves
delta(3, move_tray(Tray, _, Place), 0.08863297332984332) :- could_serve_sandwich_no_gluten(Tray, Place), at(_, Place), at_kitchen_bread(_), !.
delta(3, move_tray(Tray, _, Place), -0.0812636003727094) :- could_serve_sandwich_no_gluten(Tray, Place), at(_, Place), !.
delta(3, move_tray(Tray, _, Place), 0.05352175221051749) :- could_serve_sandwich_no_gluten(Tray, Place), at_kitchen_bread(_), !.
delta(3, move_tray(Tray, _, Place), 0.7267565946615446) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(3, move_tray(_, Place, Place2), 0.4546594636829977) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(3, move_tray(_, Place, Place2), -0.2785389923473799) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(3, move_tray(_, Place, Place2), 0.11752109215116896) :- at(Tray, Place2), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(3, move_tray(_, _, _), -0.7092409610380034) :- !.
delta(3, make_sandwich(_, _, _), -0.31115503587850024) :- fewer_ontray_1_than_allergic_gluten, !.
delta(3, make_sandwich(_, _, _), 0.14243151741718452) :- !.
delta(3, put_on_tray(Sandwich, _), 0.3258609285608914) :- no_gluten_sandwich(Sandwich), !.
delta(3, put_on_tray(_, _), -0.3617869384958762) :- !.
delta(3, _, 0.6096772592611598).

% tree 4: step size 1.0, 202 examples, 9 leaves
delta(4, serve_sandwich(_, _, _, _), -0.6231096713741924) :- todo_served(Child), allergic_gluten(Child), !.
delta(4, serve_sandwich(_, _, _, _), 0.06587844865774344) :- !.
delta(4, put_on_tray(_, _), -0.222551906360462) :- fewer_at_1_than_todo_served, !.
delta(4, _, 0.6952388337143652) :- fewer_at_1_than_todo_served, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(4, _, -0.0031775523808242547) :- fewer_at_1_than_todo_served, !.
delta(4, make_sandwich(_, _, _), -0.4198727218328013) :- todo_served(Child), allergic_gluten(Child), !.
delta(4, make_sandwich(_, _, _), 0.12782867137020357) :- !.
delta(4, move_tray(_, _, _), -0.030558860595210454) :- !.
delta(4, _, 0.2737445690306502).

% tree 5: step size 1.0, 202 examples, 9 leaves
delta(5, serve_sandwich(_, _, _, _), -2.072588569117305) :- done_served(Child), not_allergic_gluten(Child), !.
delta(5, serve_sandwich(_, _, _, _), -0.20011407732597264) :- todo_served(Child), allergic_gluten(Child), !.
delta(5, serve_sandwich(_, _, Tray, _), 0.0) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(5, serve_sandwich(_, _, _, _), 0.06460347405100954) :- !.
delta(5, _, 2.0842169500987833) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(5, _, -0.010856878580143317) :- done_served(Child), not_allergic_gluten(Child), !.
delta(5, serve_sandwich_no_gluten(_, _, _, _), 0.31973211711454896) :- !.
delta(5, make_sandwich(_, _, _), -0.19623251878071662) :- !.
delta(5, _, 0.006426416049718724).

% tree 6: step size 1.0, 218 examples, 12 leaves
delta(6, move_tray(_, Place, _), -0.5473710198348245) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(6, move_tray(_, _, kitchen), 0.4004842082467765) :- fewer_ontray_2_than_todo_served, !.
delta(6, move_tray(_, _, _), -0.3829330781680197) :- fewer_ontray_2_than_todo_served, !.
delta(6, move_tray(_, _, Place), 0.962264455863555) :- todo_served(Child), waiting(Child, Place), !.
delta(6, move_tray(_, _, _), 0.094906098983183) :- !.
delta(6, serve_sandwich(_, _, _, _), -0.3528379615938956) :- fewer_ontray_2_than_todo_served, fewer_ontray_1_than_todo_served, !.
delta(6, serve_sandwich(_, _, _, _), -0.0017794063920264457) :- fewer_ontray_2_than_todo_served, !.
delta(6, _, 0.006810499164156424) :- fewer_ontray_2_than_todo_served, fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(6, _, 0.37712422218638203) :- fewer_ontray_2_than_todo_served, !.
delta(6, serve_sandwich_no_gluten(_, _, _, _), 0.0910167433177409) :- !.
delta(6, _, 0.032853575309152824) :- done_served(Child), allergic_gluten(Child), !.
delta(6, _, -0.9009129001222025).

% tree 7: step size 1.0, 201 examples, 13 leaves
delta(7, move_tray(Tray, Place, _), -0.8177490269453874) :- todo_served(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(7, move_tray(_, Place, kitchen), 0.14269769884524833) :- todo_served(Child), waiting(Child, Place), !.
delta(7, move_tray(_, Place, _), -0.09674700194233661) :- todo_served(Child), waiting(Child, Place), !.
delta(7, move_tray(_, _, Place), -0.6124136193707863) :- allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(7, move_tray(_, _, Place), 0.05961072690033491) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(7, move_tray(_, _, _), -0.16839481295592892) :- done_served(Child), allergic_gluten(Child), !.
delta(7, move_tray(_, _, _), 0.46264024950382554) :- !.
delta(7, _, -0.41256578578048925) :- done_served(Child), not_allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(7, _, 0.4789241918651723) :- done_served(Child), not_allergic_gluten(Child), !.
delta(7, make_sandwich_no_gluten(_, _, _), 0.20932454573665302) :- fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(7, _, -0.1933834860476789) :- fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(7, serve_sandwich(_, _, _, _), 0.1091987397491071) :- !.
delta(7, _, 0.5243430477957866).

% tree 8: step size 1.0, 202 examples, 13 leaves
delta(8, move_tray(_, Place, Place2), -0.3152375478532842) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(8, move_tray(_, Place, Place2), -0.007343427645622015) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), todo_served(Child), waiting(Child, Place), !.
delta(8, move_tray(_, Place, Place2), 0.5596878041449702) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(8, move_tray(Tray, _, Place), 0.11940611658128554) :- todo_served(Child), allergic_gluten(Child), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(8, move_tray(_, _, _), -0.12741628812237435) :- todo_served(Child), allergic_gluten(Child), !.
delta(8, move_tray(_, _, _), -0.7172740453160666) :- !.
delta(8, make_sandwich_no_gluten(_, _, _), 0.11488973862780859) :- fewer_ontray_1_than_todo_served, fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(8, _, -0.10511218624319776) :- fewer_ontray_1_than_todo_served, fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(8, _, 0.4304497427163891) :- fewer_ontray_1_than_todo_served, !.
delta(8, put_on_tray(_, _), 0.028433736824949315) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(8, put_on_tray(_, _), -0.08454506278213406) :- !.
delta(8, make_sandwich(_, _, _), -0.053462146757285306) :- !.
delta(8, _, 0.1362037142787625).

% tree 9: step size 1.0, 213 examples, 10 leaves
delta(9, make_sandwich(_, _, _), -0.03012320369791741) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(9, make_sandwich(_, _, _), 0.11432880443289567) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(9, make_sandwich(_, _, _), -0.4184458047222878) :- !.
delta(9, _, 0.0) :- fewer_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(9, put_on_tray(_, _), -0.0022290886147504512) :- fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(9, _, 0.39218372947612884) :- fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(9, move_tray(_, Place, Place2), 0.3517327824346201) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(9, move_tray(_, _, _), -0.34722976437709885) :- !.
delta(9, _, 0.2485028177467733) :- at_kitchen_sandwich(_), !.
delta(9, _, 0.031885652729324566).

% tree 10: step size 1.0, 216 examples, 14 leaves
delta(10, move_tray(Tray, _, Place), -0.11595035805625896) :- could_serve_sandwich(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(10, move_tray(Tray, Place, Place2), -0.004022652491857838) :- could_serve_sandwich(Tray, Place2), todo_served(Child), waiting(Child, Place), !.
delta(10, move_tray(Tray, _, Place), 0.4270993271403381) :- could_serve_sandwich(Tray, Place), !.
delta(10, move_tray(_, Place, Place2), -0.08811710055648139) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(10, move_tray(_, Place, Place2), 0.2644704754925523) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(10, move_tray(_, Place, _), -0.0069780295001194755) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(10, move_tray(_, _, _), -0.5073868184971665) :- !.
delta(10, serve_sandwich(Sandwich, _, _, Place), -0.2209788837863133) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(10, serve_sandwich(_, Child, _, _), 0.3037641997131307) :- todo_served(Child), !.
delta(10, serve_sandwich(_, _, _, _), -0.21680434295254344) :- !.
delta(10, _, 0.10612382241820002) :- fewer_at_1_than_allergic_gluten, fewer_ontray_1_than_todo_served, !.
delta(10, _, 0.00025137616723983845) :- fewer_at_1_than_allergic_gluten, !.
delta(10, make_sandwich(_, _, _), 0.0034333298555246513) :- !.
delta(10, _, 0.34045541633122683).

% tree 11: step size 1.0, 201 examples, 10 leaves
delta(11, serve_sandwich(_, _, _, _), 0.051036895052415265) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(11, serve_sandwich(_, _, _, _), 0.00794989437209851) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(11, serve_sandwich(_, _, _, _), -0.20675782221233976) :- !.
delta(11, move_tray(_, _, _), -0.09876087621151837) :- goal_served(Child), not_allergic_gluten(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(11, _, 0.05320377097319113) :- goal_served(Child), not_allergic_gluten(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(11, _, 0.1797832627425288) :- goal_served(Child), not_allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(11, _, 9.714141766500986e-19) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(11, make_sandwich_no_gluten(_, _, _), 0.09548094381074317) :- !.
delta(11, _, -0.09495707655171867) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(11, _, 8.966335685626955e-18).

% tree 12: step size 1.0, 214 examples, 15 leaves
delta(12, move_tray(Tray, _, Place), -0.5914112481986566) :- todo_served(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich_no_gluten(Tray, Place2), fewer_at_2_than_todo_served, !.
delta(12, move_tray(Tray, _, Place), 0.23075813954502156) :- todo_served(Child), waiting(Child, Place), waiting(Child, Place2), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(12, move_tray(_, _, Place), -0.030694491708326) :- todo_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(12, move_tray(_, _, Place), 0.6007166827761226) :- todo_served(Child), waiting(Child, Place), !.
delta(12, move_tray(_, _, Place), -0.006874053198575856) :- fewer_ontray_1_than_todo_served_allergic_gluten, at(_, Place), !.
delta(12, move_tray(_, _, _), 0.013106771952079802) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(12, move_tray(_, _, _), -0.4174171536415193) :- !.
delta(12, put_on_tray(_, Tray), -0.19397097752991366) :- fewer_ontray_1_than_allergic_gluten, ontray(_, Tray), !.
delta(12, put_on_tray(_, _), 0.13998885431836922) :- fewer_ontray_1_than_allergic_gluten, !.
delta(12, _, 0.06699265890895219) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(12, _, -0.0073493730515949655) :- fewer_ontray_1_than_allergic_gluten, !.
delta(12, serve_sandwich(_, Child, _, _), 0.08352006530542995) :- todo_served(Child), !.
delta(12, serve_sandwich(_, _, _, _), -0.0873474006624704) :- !.
delta(12, make_sandwich(_, _, _), 0.002545803144140436) :- !.
delta(12, _, 0.178871883586529).

% tree 13: step size 1.0, 207 examples, 9 leaves
delta(13, make_sandwich(_, _, _), 0.00026244102827412726) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), fewer_at_1_than_not_allergic_gluten, !.
delta(13, make_sandwich(_, _, _), -0.3223590637763684) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(13, make_sandwich(_, _, _), 0.06849428128521406) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(13, make_sandwich(_, _, _), -0.021155757734050006) :- !.
delta(13, _, 0.31369635887914393) :- fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(13, serve_sandwich_no_gluten(_, Child, _, _), 1.038121370017206) :- todo_served(Child), !.
delta(13, serve_sandwich_no_gluten(_, _, _, _), -1.0396304904081652) :- !.
delta(13, _, -0.12401223189152362) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(13, _, -0.012278380133692708).

% tree 14: step size 1.0, 213 examples, 16 leaves
delta(14, move_tray(Tray, _, Place), -0.06330661235416947) :- todo_served(Child), waiting(Child, Place), ontray(_, Tray), fewer_ontray_1_than_todo_served, !.
delta(14, move_tray(Tray, _, Place), 0.23137605743156572) :- todo_served(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(14, move_tray(_, _, Place), 0.02353436094129347) :- todo_served(Child), waiting(Child, Place), done_served(Child2), not_allergic_gluten(Child2), !.
delta(14, move_tray(_, _, Place), -0.13478103014893403) :- todo_served(Child), waiting(Child, Place), !.
delta(14, move_tray(_, Place, Place2), 0.07282838190699017) :- at(Tray, Place2), could_serve_sandwich(Tray, Place), goal_served(Child), waiting(Child, Place2), !.
delta(14, move_tray(_, Place, Place2), -0.034454586073874194) :- at(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(14, move_tray(_, Place, _), -0.0012691960134896443) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(14, move_tray(_, _, _), -0.33806479330139544) :- !.
delta(14, _, 0.00011713376859195567) :- todo_served(Child), not_allergic_gluten(Child), waiting(Child, Place), at(_, Place), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(14, _, 0.21854833745483668) :- todo_served(Child), not_allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(14, _, 0.04929156530912838) :- todo_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served, !.
delta(14, _, -0.10674104876894805) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(14, make_sandwich(_, _, _), -0.03916428955236101) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(14, _, 0.028582444915554093) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(14, serve_sandwich_no_gluten(_, _, _, _), 0.016607672030326134) :- !.
delta(14, _, -0.07472364440977272).

% tree 15: step size 1.0, 202 examples, 12 leaves
delta(15, make_sandwich(_, Bread_portion, _), -0.023047635753124962) :- fewer_ontray_1_than_not_allergic_gluten, no_gluten_bread(Bread_portion), !.
delta(15, make_sandwich(_, _, _), -0.0004349593674610612) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_content(Content_portion), no_gluten_content(Content_portion), !.
delta(15, make_sandwich(_, _, _), 0.05345369889786128) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(15, make_sandwich(_, _, _), -0.10703530548193722) :- !.
delta(15, put_on_tray(_, Tray), 0.02208344773226763) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(15, put_on_tray(_, Tray), -0.23784007071618984) :- ontray(_, Tray), !.
delta(15, put_on_tray(_, _), 0.16941933610075444) :- fewer_at_2_than_allergic_gluten, !.
delta(15, put_on_tray(_, _), -0.05219005490539939) :- !.
delta(15, move_tray(_, _, _), -0.028407210341313292) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(15, _, 0.020306777421830412) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(15, _, -0.011164088563249682) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(15, _, 0.10011603069867742).

% tree 16: step size 1.0, 202 examples, 16 leaves
delta(16, move_tray(Tray, Place, Place2), -0.008204948410105444) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place2), goal_served(Child), done_served(Child), todo_served(Child2), waiting(Child2, Place), !.
delta(16, move_tray(Tray, _, Place), 0.6230489701499412) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), goal_served(Child), done_served(Child), !.
delta(16, move_tray(Tray, _, Place), -0.08891251187126831) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(16, move_tray(Tray, _, Place), 0.052554723661655034) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(16, move_tray(_, Place, Place2), -0.03319169020581525) :- allergic_gluten(Child), waiting(Child, Place), at(_, Place2), !.
delta(16, move_tray(_, Place, _), 0.23686467172421996) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(16, move_tray(Tray, _, _), 0.02432829134826656) :- at(Tray, kitchen), !.
delta(16, move_tray(_, _, _), -0.5269378163230246) :- !.
delta(16, make_sandwich_no_gluten(_, _, _), 0.020321458135089978) :- fewer_ontray_1_than_todo_served, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(16, _, -0.027056071263988544) :- fewer_ontray_1_than_todo_served, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(16, _, 0.0005042589480835134) :- fewer_ontray_1_than_todo_served, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(16, _, 0.0823460783897396) :- fewer_ontray_1_than_todo_served, !.
delta(16, serve_sandwich_no_gluten(_, _, _, _), 3.5605177412546e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(16, serve_sandwich_no_gluten(_, _, _, _), 0.03288743127875488) :- !.
delta(16, _, 0.015158522328956973) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(16, _, -0.23684736802710976).

% tree 17: step size 1.0, 205 examples, 16 leaves
delta(17, move_tray(Tray, _, Place), -0.026783954909035148) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(17, move_tray(Tray, _, Place), 0.12050361950574077) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(17, move_tray(_, Place, _), 0.024214333272584845) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), ontray(Sandwich, Tray), could_put_on_tray(Tray, Place), !.
delta(17, move_tray(_, _, _), -0.1815245639245221) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(17, move_tray(_, Place, _), 0.43839191672042843) :- goal_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(17, move_tray(_, Place, _), -0.05278939756245193) :- goal_served(Child), waiting(Child, Place), !.
delta(17, move_tray(_, _, _), 0.05035950349188338) :- done_served(Child), allergic_gluten(Child), !.
delta(17, move_tray(_, _, _), -0.026992761476336363) :- !.
delta(17, _, 0.034790337822128085) :- fewer_ontray_2_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(17, _, -0.33646793901703936) :- fewer_ontray_2_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(17, make_sandwich(_, _, _), -0.04072456357133381) :- fewer_ontray_2_than_todo_served, !.
delta(17, _, 0.016289130858020168) :- fewer_ontray_2_than_todo_served, !.
delta(17, serve_sandwich(_, Child, _, _), 0.4700133456841238) :- todo_served(Child), !.
delta(17, serve_sandwich(_, _, _, _), -0.39323030782993806) :- !.
delta(17, serve_sandwich_no_gluten(_, _, _, _), 0.008622435404617906) :- !.
delta(17, _, -0.05446687590869404).

% tree 18: step size 1.0, 208 examples, 15 leaves
delta(18, move_tray(Tray, _, kitchen), 0.034211269453890504) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), ontray(_, Tray), !.
delta(18, move_tray(_, _, kitchen), -0.02468797666914599) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(18, move_tray(_, _, kitchen), 0.004377591218310245) :- fewer_ontray_1_than_allergic_gluten, !.
delta(18, move_tray(_, _, kitchen), -0.3954738718347666) :- !.
delta(18, move_tray(Tray, Place, _), 1.0467641557551888) :- done_served(Child), waiting(Child, Place), ontray(_, Tray), !.
delta(18, move_tray(_, Place, _), -0.0835850341695621) :- done_served(Child), waiting(Child, Place), !.
delta(18, move_tray(_, _, Place), 0.25278352285658734) :- at(_, Place), !.
delta(18, move_tray(_, _, _), -0.13586978733922697) :- !.
delta(18, _, 4.9213862883156134e-5) :- goal_served(Child), done_served(Child), fewer_at_1_than_allergic_gluten, !.
delta(18, _, -0.8204971503524576) :- goal_served(Child), done_served(Child), waiting(Child, Place), at(_, Place), !.
delta(18, _, 0.0005590959062060651) :- goal_served(Child), done_served(Child), !.
delta(18, put_on_tray(_, Tray), 0.05395664241479663) :- ontray(_, Tray), !.
delta(18, put_on_tray(_, _), -0.10703678926218424) :- !.
delta(18, serve_sandwich(_, _, _, _), -0.022218900761378814) :- !.
delta(18, _, 0.07622998119832361).

% tree 19: step size 1.0, 212 examples, 13 leaves
delta(19, move_tray(_, Place, Place2), -0.008237822257041715) :- at(Tray, Place2), could_serve_sandwich(Tray, Place), fewer_ontray_2_than_todo_served, !.
delta(19, move_tray(_, Place, Place2), 0.12291889971701683) :- at(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(19, move_tray(_, _, Place), -0.09609944623846055) :- fewer_ontray_2_than_todo_served, at(_, Place), !.
delta(19, move_tray(_, _, _), 0.08171915390342768) :- fewer_ontray_2_than_todo_served, !.
delta(19, move_tray(_, _, kitchen), -0.022934825870656483) :- !.
delta(19, move_tray(_, _, _), -0.3140527867942401) :- !.
delta(19, put_on_tray(_, _), 0.003405114743602263) :- fewer_ontray_2_than_todo_served, at_kitchen_sandwich(_), !.
delta(19, _, -0.06291552724699388) :- fewer_ontray_2_than_todo_served, at_kitchen_sandwich(_), !.
delta(19, serve_sandwich(_, _, _, _), 0.0003658397237388166) :- fewer_ontray_2_than_todo_served, !.
delta(19, _, 0.02267397923335325) :- fewer_ontray_2_than_todo_served, !.
delta(19, _, 7.835877056865203e-5) :- fewer_at_1_than_allergic_gluten, !.
delta(19, _, 0.0345000556638845) :- fewer_at_1_than_not_allergic_gluten, !.
delta(19, _, 0.2135801149683883).

% tree 20: step size 1.0, 213 examples, 15 leaves
delta(20, put_on_tray(_, Tray), 0.03527249411224545) :- ontray(_, Tray), at_kitchen_bread(_), !.
delta(20, put_on_tray(_, Tray), 0.00032840219241908836) :- ontray(_, Tray), fewer_at_1_than_todo_served, !.
delta(20, put_on_tray(_, Tray), -0.2478788549491605) :- ontray(_, Tray), !.
delta(20, put_on_tray(Sandwich, _), -0.025382409632333645) :- no_gluten_sandwich(Sandwich), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(20, put_on_tray(Sandwich, _), 0.176299454390355) :- no_gluten_sandwich(Sandwich), !.
delta(20, put_on_tray(_, _), 0.0012781882675593523) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(20, put_on_tray(_, _), -0.0713590947990832) :- !.
delta(20, make_sandwich(_, _, _), -0.013488757397184647) :- fewer_ontray_1_than_not_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(20, make_sandwich(_, _, _), 0.07694729987733036) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(20, make_sandwich(_, _, _), -0.1431654984402571) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(20, make_sandwich(_, _, _), -0.009404249791165777) :- !.
delta(20, move_tray(_, _, _), -0.10645117166626585) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(20, _, 0.045616185279910494) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(20, _, 0.001134103248950933) :- fewer_at_2_than_allergic_gluten, !.
delta(20, _, 0.19781134744048495).

% tree 21: step size 1.0, 216 examples, 15 leaves
delta(21, move_tray(_, Place, _), 0.00025254502049831324) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), done_served(Child2), waiting(Child2, Place), !.
delta(21, move_tray(_, _, _), -0.0286489445280446) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(21, move_tray(_, _, kitchen), 0.007994405704687974) :- goal_served(Child), allergic_gluten(Child), !.
delta(21, move_tray(_, _, _), 0.4635103022590437) :- goal_served(Child), allergic_gluten(Child), !.
delta(21, move_tray(_, Place, _), -0.16995879525541244) :- todo_served(Child), waiting(Child, Place), !.
delta(21, move_tray(_, _, Place), -0.05775170878148721) :- done_served(Child), waiting(Child, Place), !.
delta(21, move_tray(_, _, _), 0.01759454003533391) :- !.
delta(21, _, -0.00022812607870816473) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), done_served(Child2), not_allergic_gluten(Child2), !.
delta(21, _, 0.024982049941347697) :- goal_served(Child), allergic_gluten(Child), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(21, make_sandwich_no_gluten(_, _, _), 0.014005522359413007) :- goal_served(Child), allergic_gluten(Child), !.
delta(21, _, -0.4668022878751641) :- goal_served(Child), allergic_gluten(Child), !.
delta(21, make_sandwich(_, _, _), -0.0008568712490252497) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(21, make_sandwich(_, _, _), 0.0023017130198129026) :- !.
delta(21, _, 0.13417490084746425) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(21, _, 0.021697340612110268).

% tree 22: step size 1.0, 232 examples, 16 leaves
delta(22, move_tray(Tray, _, Place), 0.008003320671406723) :- ontray(_, Tray), done_served(Child), waiting(Child, Place), goal_served(Child2), allergic_gluten(Child2), !.
delta(22, move_tray(Tray, _, Place), -0.05323721399635647) :- ontray(_, Tray), done_served(Child), waiting(Child, Place), !.
delta(22, move_tray(Tray, Place, _), 0.30227643392899844) :- ontray(_, Tray), goal_served(Child), waiting(Child, Place), !.
delta(22, move_tray(Tray, _, _), 0.02404851647572422) :- ontray(_, Tray), !.
delta(22, move_tray(_, Place, kitchen), -0.024218350083618882) :- todo_served(Child), waiting(Child, Place), !.
delta(22, move_tray(_, Place, _), 0.04354008731888415) :- todo_served(Child), waiting(Child, Place), !.
delta(22, move_tray(_, Place, Place2), 0.008176738011038211) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(22, move_tray(_, _, _), -0.15010456485404666) :- !.
delta(22, make_sandwich(_, _, _), -0.010867217518594373) :- at_kitchen_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(22, _, 0.020720716418550764) :- at_kitchen_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(22, _, 0.01178287410742291) :- at_kitchen_sandwich(_), at_kitchen_bread(_), !.
delta(22, _, -0.26644568860003753) :- at_kitchen_sandwich(_), !.
delta(22, serve_sandwich_no_gluten(_, _, _, _), -0.17155503609489095) :- fewer_at_2_than_allergic_gluten, !.
delta(22, _, 0.0008684671688141095) :- fewer_at_2_than_allergic_gluten, !.
delta(22, _, -0.006742379407874556) :- fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(22, _, 0.14043295797030397).

% tree 23: step size 1.0, 204 examples, 15 leaves
delta(23, move_tray(Tray, _, _), -0.11600886030951268) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(23, move_tray(Tray, _, Place), 0.054734803273343034) :- at(Tray, kitchen), todo_served(Child), waiting(Child, Place), !.
delta(23, move_tray(Tray, _, _), -0.00896655448295103) :- at(Tray, kitchen), !.
delta(23, move_tray(_, _, Place), -0.0290217728122259) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(23, move_tray(_, _, _), 0.7456827916246459) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(23, move_tray(_, _, _), 0.10783985884148423) :- fewer_ontray_1_than_allergic_gluten, !.
delta(23, move_tray(_, _, _), -0.08247237279150472) :- !.
delta(23, serve_sandwich(_, _, _, _), -0.04982503293092857) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(23, _, 0.02391703018782591) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(23, put_on_tray(_, _), 0.015078350334730138) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(23, _, -0.5093320297402274) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(23, _, 0.00030237620769890975) :- done_served(Child), allergic_gluten(Child), fewer_at_1_than_allergic_gluten, !.
delta(23, _, -0.11554103538785056) :- done_served(Child), allergic_gluten(Child), !.
delta(23, serve_sandwich(_, _, _, _), 0.0020750817091274992) :- !.
delta(23, _, 0.08623004746088601).

% tree 24: step size 1.0, 201 examples, 10 leaves
delta(24, serve_sandwich_no_gluten(_, Child, _, _), 0.21335365813644422) :- todo_served(Child), !.
delta(24, serve_sandwich_no_gluten(_, _, _, _), -0.39916043452104766) :- !.
delta(24, move_tray(_, _, _), -0.026295854134815545) :- done_served(Child), allergic_gluten(Child), fewer_ontray_2_than_todo_served, !.
delta(24, move_tray(_, _, _), 0.325051248926919) :- done_served(Child), allergic_gluten(Child), !.
delta(24, _, 0.02915077556779562) :- done_served(Child), allergic_gluten(Child), fewer_ontray_1_than_allergic_gluten, !.
delta(24, _, -0.08087584457820808) :- done_served(Child), allergic_gluten(Child), !.
delta(24, move_tray(_, _, Place), 0.2811148026288754) :- at(_, Place), !.
delta(24, move_tray(_, _, _), -0.2723294865931697) :- !.
delta(24, put_on_tray(_, _), -0.06387984490132526) :- !.
delta(24, _, 0.08701648684722516).

% tree 25: step size 1.0, 203 examples, 10 leaves
delta(25, serve_sandwich_no_gluten(_, _, _, _), -0.12875673456739442) :- goal_served(Child), done_served(Child), !.
delta(25, serve_sandwich_no_gluten(_, _, _, _), 0.0162588953459876) :- !.
delta(25, move_tray(_, Place, Place2), 0.04846716267826397) :- fewer_no_gluten_sandwich_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(25, move_tray(_, _, _), -0.32503068031912563) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(25, move_tray(Tray, _, _), 0.254354448676291) :- ontray(_, Tray), !.
delta(25, move_tray(_, _, _), -0.07776651954088293) :- !.
delta(25, _, 0.18101198414922948) :- fewer_ontray_2_than_todo_served, goal_served(Child), done_served(Child), !.
delta(25, _, 0.03836528250281768) :- fewer_ontray_2_than_todo_served, !.
delta(25, _, -0.17044879826839235) :- no_gluten_sandwich(_), !.
delta(25, _, 0.03540604016756054).

% tree 26: step size 1.0, 232 examples, 12 leaves
delta(26, serve_sandwich(_, Child, _, _), 0.42412190626266016) :- todo_served(Child), goal_served(Child2), done_served(Child2), waiting(Child2, Place), at(_, Place), !.
delta(26, serve_sandwich(_, Child, _, _), 0.014895348588391014) :- todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(26, serve_sandwich(_, Child, _, _), 0.008374631512688286) :- todo_served(Child), fewer_ontray_2_than_not_allergic_gluten, !.
delta(26, serve_sandwich(_, Child, _, _), -0.016493395996742672) :- todo_served(Child), !.
delta(26, serve_sandwich(_, _, _, _), -0.30991815075607765) :- !.
delta(26, make_sandwich(_, Bread_portion, _), -0.03035806647979083) :- no_gluten_bread(Bread_portion), !.
delta(26, make_sandwich(_, _, _), 0.06830891560200757) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(26, make_sandwich(_, _, _), -0.005561589985736854) :- !.
delta(26, _, -0.21683372935656153) :- todo_served(Child), not_allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(26, _, -0.004733206214636284) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(26, serve_sandwich_no_gluten(_, _, _, _), -0.02980910400601747) :- !.
delta(26, _, 0.03185355347562293).

% tree 27: step size 1.0, 210 examples, 15 leaves
delta(27, move_tray(_, _, Place), -0.007992859089952087) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(27, move_tray(_, _, _), -0.003683525507402948) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(27, move_tray(_, _, _), 0.09916802321819616) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(27, move_tray(_, _, _), 0.04270410732426743) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), goal_served(Child), done_served(Child), !.
delta(27, move_tray(_, _, _), -0.0028796366985584985) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(27, move_tray(_, Place, _), -0.0014144462011970883) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(27, move_tray(_, _, _), -0.40740418562521696) :- !.
delta(27, make_sandwich(_, _, _), 0.05023381188881843) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(27, make_sandwich(_, _, _), -0.033114325208843456) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(27, _, 0.013292535352958285) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(27, _, -0.09800979743152484) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(27, _, -0.043065956721485395) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), goal_served(Child), done_served(Child), !.
delta(27, _, 0.0028578059651139342) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(27, _, 0.20462259248912668) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(27, _, 0.04063048788611293).

% tree 28: step size 1.0, 203 examples, 11 leaves
delta(28, move_tray(Tray, Place, _), 0.0) :- at(Tray, Place2), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place2), fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(28, move_tray(Tray, _, _), -0.0041679545661993155) :- at(Tray, Place), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(28, move_tray(Tray, _, _), -0.28543174394547555) :- at(Tray, Place), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(28, move_tray(_, _, Place), -0.06455571511518304) :- at(_, Place), !.
delta(28, move_tray(_, Place, _), -0.023046062032761404) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(28, move_tray(_, _, _), 0.08096597214987929) :- !.
delta(28, make_sandwich(_, _, _), -0.06166548697858129) :- goal_served(Child), allergic_gluten(Child), !.
delta(28, make_sandwich(_, _, _), 0.004947116999273953) :- !.
delta(28, _, 0.009075058916193418) :- fewer_at_1_than_allergic_gluten, fewer_ontray_2_than_todo_served, !.
delta(28, _, 0.00043359208306881664) :- fewer_at_1_than_allergic_gluten, !.
delta(28, _, 0.12209888087485127).

% tree 29: step size 1.0, 203 examples, 16 leaves
delta(29, move_tray(Tray, _, Place), 0.14619052120480355) :- fewer_ontray_2_than_todo_served, notexist(_), could_serve_sandwich(Tray, Place), !.
delta(29, move_tray(_, _, _), -0.012349012702854465) :- fewer_ontray_2_than_todo_served, notexist(_), !.
delta(29, move_tray(_, Place, Place2), 0.029141165316033293) :- fewer_ontray_2_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(29, move_tray(_, _, _), -0.09828982872659597) :- fewer_ontray_2_than_todo_served, !.
delta(29, move_tray(_, Place, Place2), 0.0038387520612892514) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(29, move_tray(_, Place, Place2), -0.08312554394178301) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(29, move_tray(_, _, _), -0.006913692530816043) :- at_kitchen_sandwich(_), !.
delta(29, move_tray(_, _, _), 1.0890271488047656) :- !.
delta(29, _, 0.007096151607860677) :- fewer_no_gluten_sandwich_than_todo_served, notexist(_), at_kitchen_sandwich(_), !.
delta(29, _, -0.10369816248483703) :- fewer_no_gluten_sandwich_than_todo_served, notexist(_), !.
delta(29, _, 0.03369920632082645) :- fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(29, _, 0.002446202907930367) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(29, _, 0.00031616849248692464) :- fewer_at_2_than_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(29, _, -0.02538052995004463) :- fewer_at_2_than_allergic_gluten, !.
delta(29, _, -0.00052017622746852) :- fewer_ontray_2_than_todo_served, !.
delta(29, _, -1.044778531469707).

% tree 30: step size 1.0, 204 examples, 14 leaves
delta(30, make_sandwich(_, _, _), -0.005828723800927255) :- at_kitchen_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(30, make_sandwich(_, _, _), 0.3943610570743281) :- at_kitchen_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(30, make_sandwich(_, _, _), 6.420423072759683e-5) :- at_kitchen_sandwich(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(30, make_sandwich(_, _, _), -0.012154531499116215) :- at_kitchen_sandwich(_), !.
delta(30, make_sandwich(_, _, _), -0.026863295519646075) :- todo_served(Child), allergic_gluten(Child), !.
delta(30, make_sandwich(_, _, _), -0.00046366098723760066) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(30, make_sandwich(_, _, _), 0.015087493753762522) :- !.
delta(30, serve_sandwich(_, Child, _, Place), 0.39058442175530184) :- todo_served(Child), done_served(Child2), waiting(Child2, Place), !.
delta(30, serve_sandwich(_, Child, _, _), 0.005097318002353362) :- todo_served(Child), !.
delta(30, serve_sandwich(_, _, _, _), -0.3365501780997738) :- !.
delta(30, _, -0.023691397280925234) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(30, _, 0.028297983087914962) :- todo_served(Child), allergic_gluten(Child), !.
delta(30, _, 0.0051525403019844485) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(30, _, -0.45618162645702304).

% tree 31: step size 1.0, 231 examples, 15 leaves
delta(31, move_tray(_, Place, Place2), -0.017582557460335702) :- no_gluten_sandwich(_), at(Tray, Place), could_put_on_tray(Tray, Place2), at(_, Place2), !.
delta(31, move_tray(_, Place, Place2), 0.04369411337655609) :- no_gluten_sandwich(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(31, move_tray(Tray, _, _), -0.023227013772378246) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), !.
delta(31, move_tray(_, _, _), -0.3415590382927969) :- no_gluten_sandwich(_), !.
delta(31, move_tray(_, _, Place), -0.03853347165331259) :- done_served(Child), waiting(Child, Place), !.
delta(31, move_tray(_, Place, Place2), 0.08891349536257259) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(31, move_tray(_, _, _), -0.021512626590272612) :- !.
delta(31, serve_sandwich(Sandwich, _, _, _), -0.18399464389727055) :- fewer_at_2_than_todo_served, no_gluten_sandwich(Sandwich), !.
delta(31, serve_sandwich(_, _, _, _), 0.02946274766669995) :- fewer_at_2_than_todo_served, !.
delta(31, _, 0.09666793354646755) :- fewer_at_2_than_todo_served, fewer_ontray_1_than_todo_served, !.
delta(31, _, -0.02310576606381265) :- fewer_at_2_than_todo_served, !.
delta(31, make_sandwich(_, _, _), -0.004159669913395466) :- fewer_ontray_1_than_allergic_gluten, !.
delta(31, _, 0.010595442975841996) :- fewer_ontray_1_than_allergic_gluten, !.
delta(31, _, 0.28600080876437495) :- no_gluten_sandwich(_), !.
delta(31, _, 0.005750360188888241).

% tree 32: step size 1.0, 208 examples, 14 leaves
delta(32, make_sandwich(_, _, _), 0.3106136917908088) :- at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(32, make_sandwich(_, _, _), -0.0037394341105736564) :- at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(32, make_sandwich(_, _, _), -0.008455853982623296) :- at_kitchen_sandwich(_), !.
delta(32, make_sandwich(_, Bread_portion, _), -0.01595538279321077) :- no_gluten_sandwich(_), no_gluten_bread(Bread_portion), !.
delta(32, make_sandwich(_, _, _), 0.032646937857213794) :- no_gluten_sandwich(_), !.
delta(32, make_sandwich(_, _, _), -0.0176302225448667) :- !.
delta(32, _, 0.01638878842613297) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), fewer_no_gluten_sandwich_than_todo_served, !.
delta(32, _, -0.001960403652765477) :- at_kitchen_bread(_), goal_served(Child), done_served(Child), !.
delta(32, make_sandwich_no_gluten(_, _, _), 0.008451405639080206) :- at_kitchen_bread(_), !.
delta(32, _, -0.29673819288171294) :- at_kitchen_bread(_), !.
delta(32, serve_sandwich(_, Child, _, _), 0.19719547013522112) :- todo_served(Child), !.
delta(32, serve_sandwich(_, _, _, _), -0.3758434424705731) :- !.
delta(32, _, 0.21569633532578977) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(32, _, -0.10763771297778589).

% tree 33: step size 1.0, 202 examples, 13 leaves
delta(33, serve_sandwich(Sandwich, Child, _, _), -0.15947538453273827) :- todo_served(Child), no_gluten_sandwich(Sandwich), todo_served(Child2), allergic_gluten(Child2), !.
delta(33, serve_sandwich(Sandwich, Child, _, _), 0.02976291832808808) :- todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(33, serve_sandwich(_, Child, _, _), -0.016867426230859895) :- todo_served(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(33, serve_sandwich(_, Child, _, _), 0.2461200294171757) :- todo_served(Child), !.
delta(33, serve_sandwich(_, _, _, _), -0.14070194222907598) :- !.
delta(33, _, 0.0) :- done_served(Child), not_allergic_gluten(Child), goal_served(Child2), allergic_gluten(Child2), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(33, _, -0.1724152261883866) :- done_served(Child), not_allergic_gluten(Child), goal_served(Child2), allergic_gluten(Child2), !.
delta(33, _, -0.023258986001894) :- done_served(Child), not_allergic_gluten(Child), notexist(_), !.
delta(33, _, 0.01694302497825392) :- done_served(Child), not_allergic_gluten(Child), !.
delta(33, make_sandwich(_, _, _), -0.0533502270707915) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(33, make_sandwich(_, _, _), 0.0005059014821066816) :- !.
delta(33, _, 0.07606831630610454) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(33, _, -0.007420845134791648).

% tree 34: step size 1.0, 210 examples, 16 leaves
delta(34, move_tray(Tray, _, Place), 0.00035621933605530567) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), at(_, Place), goal_served(Child), done_served(Child), !.
delta(34, move_tray(Tray, _, Place), -0.018564540418152767) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), at(_, Place), !.
delta(34, move_tray(Tray, _, Place), -0.004777650295387909) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(34, move_tray(Tray, _, Place), 0.10114743322591485) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(34, move_tray(Tray, _, Place), -0.004150550184848091) :- could_serve_sandwich_no_gluten(Tray, Place), at(_, Place), !.
delta(34, move_tray(Tray, _, Place), 0.026958025177122674) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(34, move_tray(_, _, Place), 0.003621069759021266) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(34, move_tray(_, _, _), -0.16675066401066854) :- !.
delta(34, make_sandwich(_, Bread_portion, _), -0.024151449576476147) :- fewer_at_1_than_todo_served, no_gluten_bread(Bread_portion), !.
delta(34, make_sandwich(_, _, _), 0.061632310863299136) :- fewer_at_1_than_todo_served, !.
delta(34, _, 0.01797123094767876) :- fewer_at_1_than_todo_served, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(34, _, -0.05594207149800345) :- fewer_at_1_than_todo_served, !.
delta(34, _, -0.008710568150082835) :- fewer_at_2_than_allergic_gluten, goal_served(Child), done_served(Child), !.
delta(34, _, 0.0003196000161516394) :- fewer_at_2_than_allergic_gluten, !.
delta(34, _, 0.103523898444041) :- no_gluten_bread(_), !.
delta(34, _, 0.003513014921616431).

% tree 35: step size 1.0, 214 examples, 14 leaves
delta(35, move_tray(Tray, _, Place), -0.021977148728408002) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(35, move_tray(Tray, _, Place), 0.05716977639469499) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(35, move_tray(_, Place, Place2), 0.024059980653367036) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(35, move_tray(_, Place, Place2), -0.01933692755756952) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(35, move_tray(Tray, _, _), -0.017857795885197876) :- at(Tray, kitchen), !.
delta(35, move_tray(_, _, _), -0.2394285735745273) :- !.
delta(35, put_on_tray(Sandwich, _), 0.005463283907118074) :- fewer_ontray_1_than_not_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(35, put_on_tray(_, _), -0.028710036392088783) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(35, _, -0.0033461255862841243) :- fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(35, _, 0.1502095428376678) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(35, _, 0.022914408106584794) :- fewer_ontray_1_than_todo_served, fewer_no_gluten_sandwich_than_todo_served, !.
delta(35, _, 0.0007689561019679624) :- fewer_ontray_1_than_todo_served, !.
delta(35, _, -0.019908872776383483) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(35, _, 0.008748870655079328).

% tree 36: step size 1.0, 203 examples, 13 leaves
delta(36, make_sandwich(_, Bread_portion, _), -0.10793712376203538) :- no_gluten_bread(Bread_portion), goal_served(Child), allergic_gluten(Child), !.
delta(36, make_sandwich(_, Bread_portion, _), 1.509315598088713e-5) :- no_gluten_bread(Bread_portion), !.
delta(36, make_sandwich(_, _, _), -0.016551943709276585) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(36, make_sandwich(_, _, _), 0.04207244672332853) :- no_gluten_sandwich(_), !.
delta(36, make_sandwich(_, _, _), -0.006738961285687842) :- !.
delta(36, serve_sandwich(_, Child, _, _), 0.10481058718434152) :- fewer_at_1_than_not_allergic_gluten, todo_served(Child), !.
delta(36, serve_sandwich(_, _, _, _), -0.06486209796629716) :- fewer_at_1_than_not_allergic_gluten, !.
delta(36, _, 0.0014758358363453135) :- fewer_at_1_than_not_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(36, _, -0.04412378447685613) :- fewer_at_1_than_not_allergic_gluten, !.
delta(36, serve_sandwich(_, _, _, _), 0.0035734192269463775) :- done_served(Child), allergic_gluten(Child), !.
delta(36, serve_sandwich(_, _, _, _), -0.02204930117810145) :- !.
delta(36, put_on_tray(_, _), -0.009064543299785156) :- !.
delta(36, _, 0.10642810031444588).

% tree 37: step size 1.0, 203 examples, 15 leaves
delta(37, move_tray(_, Place, Place2), -0.07217900696266367) :- at(_, Place2), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(37, move_tray(_, _, Place), -0.0019205646457852734) :- at(_, Place), at_kitchen_bread(_), !.
delta(37, move_tray(_, _, Place), 0.33685337464247017) :- at(_, Place), !.
delta(37, move_tray(_, Place, Place2), 0.0034163617365762164) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), fewer_at_1_than_todo_served, !.
delta(37, move_tray(_, Place, Place2), -0.3279177267417604) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(37, move_tray(Tray, _, Place), 0.13160149953871922) :- could_serve_sandwich(Tray, Place), !.
delta(37, move_tray(_, _, _), -0.020988308583905407) :- !.
delta(37, make_sandwich(_, _, _), -0.01834708290156437) :- fewer_at_1_than_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(37, _, 0.04475024019403022) :- fewer_at_1_than_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(37, _, 0.007926477272680513) :- fewer_at_1_than_not_allergic_gluten, fewer_ontray_1_than_todo_served, !.
delta(37, _, -0.018789926651225634) :- fewer_at_1_than_not_allergic_gluten, !.
delta(37, _, -0.002951218645386911) :- fewer_at_2_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(37, _, 0.0022727399172115252) :- fewer_at_2_than_allergic_gluten, !.
delta(37, serve_sandwich(_, _, _, _), 0.003612646387532751) :- !.
delta(37, _, -0.07806002854786129).

% tree 38: step size 1.0, 212 examples, 14 leaves
delta(38, move_tray(_, _, _), -0.010147971230051876) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(38, move_tray(_, _, _), -0.0050663784829961455) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(38, move_tray(_, _, _), 0.451726863318666) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(38, move_tray(_, _, Place), -0.08978045814109156) :- at(_, Place), !.
delta(38, move_tray(_, Place, _), -0.0634136834411901) :- todo_served(Child), waiting(Child, Place), !.
delta(38, move_tray(_, _, _), 0.0631405599456543) :- !.
delta(38, serve_sandwich(_, _, _, _), -0.44941583462114765) :- at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(38, serve_sandwich(_, _, _, _), 0.015590475166379042) :- at_kitchen_sandwich(_), !.
delta(38, make_sandwich(_, _, _), -0.0066659016643288976) :- at_kitchen_sandwich(_), !.
delta(38, _, 0.019190990681350505) :- at_kitchen_sandwich(_), !.
delta(38, make_sandwich(_, _, _), 0.0011215016011334078) :- fewer_ontray_1_than_allergic_gluten, !.
delta(38, make_sandwich(_, _, _), -0.03056543613742461) :- !.
delta(38, _, 0.054080824242612485) :- goal_served(Child), done_served(Child), !.
delta(38, _, 0.003929619488964949).

% tree 39: step size 1.0, 214 examples, 15 leaves
delta(39, move_tray(_, Place, Place2), -0.0023467454564941653) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_no_gluten_sandwich_than_todo_served, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(39, move_tray(_, Place, Place2), 0.0776878759441417) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_no_gluten_sandwich_than_todo_served, !.
delta(39, move_tray(_, Place, Place2), 0.0024861197871925236) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(39, move_tray(_, Place, Place2), -0.02780386602508675) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(39, move_tray(_, _, _), 0.01704720825833941) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), done_served(Child), not_allergic_gluten(Child), !.
delta(39, move_tray(_, _, _), -0.006247725156640305) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(39, move_tray(_, _, _), -0.16129660743687776) :- !.
delta(39, put_on_tray(_, _), -0.011540302620291544) :- fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(39, _, 0.014505739353606478) :- fewer_no_gluten_sandwich_than_todo_served, fewer_ontray_1_than_not_allergic_gluten, !.
delta(39, put_on_tray(_, _), 0.0071427776673909085) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(39, _, -0.03194418394630792) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(39, serve_sandwich_no_gluten(_, _, _, _), 0.004474845128955227) :- fewer_at_2_than_allergic_gluten, !.
delta(39, _, -0.0022825966940397797) :- fewer_at_2_than_allergic_gluten, !.
delta(39, _, -0.001698816490802725) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(39, _, 0.13894620532671176).

% tree 40: step size 1.0, 202 examples, 14 leaves
delta(40, put_on_tray(_, _), 0.004695419625902784) :- fewer_no_gluten_sandwich_than_todo_served, fewer_at_1_than_todo_served, !.
delta(40, put_on_tray(_, _), -0.04369799300261316) :- fewer_no_gluten_sandwich_than_todo_served, todo_served(Child), allergic_gluten(Child), !.
delta(40, put_on_tray(_, _), 3.4009016150459916e-5) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(40, put_on_tray(Sandwich, _), 0.018863226623340373) :- no_gluten_sandwich(Sandwich), !.
delta(40, put_on_tray(_, _), -0.008356759531312062) :- todo_served(Child), allergic_gluten(Child), !.
delta(40, put_on_tray(_, _), 0.0022537464313312737) :- !.
delta(40, move_tray(_, _, Place), -0.018926021589937662) :- fewer_at_1_than_todo_served, not_allergic_gluten(Child), waiting(Child, Place), !.
delta(40, move_tray(_, _, _), 0.02931360501465206) :- fewer_at_1_than_todo_served, !.
delta(40, _, 0.0056022966361356456) :- fewer_at_1_than_todo_served, no_gluten_bread(_), !.
delta(40, _, -0.015351072174643158) :- fewer_at_1_than_todo_served, !.
delta(40, serve_sandwich(_, _, _, _), -0.008305791440843074) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(40, _, 0.049813767465964866) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(40, serve_sandwich(_, _, _, _), 0.02881133791842634) :- !.
delta(40, _, -0.03865023076517889).

% tree 41: step size 1.0, 208 examples, 12 leaves
delta(41, make_sandwich(_, _, _), -0.009039556527242334) :- fewer_ontray_2_than_allergic_gluten, fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(41, make_sandwich(_, _, _), 0.0020170404324487638) :- fewer_ontray_2_than_allergic_gluten, !.
delta(41, make_sandwich(_, _, _), -0.0013715845004264723) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(41, make_sandwich(_, _, _), 0.0770105495678486) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(41, make_sandwich(_, _, _), -0.00048412410804874145) :- !.
delta(41, serve_sandwich(_, Child, _, _), 0.05349078075070306) :- todo_served(Child), fewer_ontray_2_than_not_allergic_gluten, !.
delta(41, serve_sandwich(_, Child, _, _), -0.008543503044829691) :- todo_served(Child), !.
delta(41, serve_sandwich(_, _, _, _), -0.03294533277171362) :- !.
delta(41, serve_sandwich_no_gluten(_, _, _, _), -0.008729597867680204) :- fewer_ontray_2_than_allergic_gluten, !.
delta(41, _, 0.00902976303853185) :- fewer_ontray_2_than_allergic_gluten, !.
delta(41, _, -0.10223466404086222) :- notexist(_), !.
delta(41, _, -0.00016832112175413353).

% tree 42: step size 1.0, 249 examples, 15 leaves
delta(42, move_tray(Tray, _, Place), -0.018292081861686963) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(42, move_tray(Tray, _, Place), 0.3905303169659243) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_2_than_not_allergic_gluten, !.
delta(42, move_tray(Tray, _, Place), -0.009621650947056746) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(42, move_tray(Tray, _, Place), 0.00940655262625993) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray2), could_put_on_tray(Tray2, Place), !.
delta(42, move_tray(Tray, _, _), -0.25803161073183845) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(42, move_tray(_, _, _), -0.024775153697193717) :- done_served(Child), allergic_gluten(Child), !.
delta(42, move_tray(_, _, _), 0.09629138180781105) :- !.
delta(42, _, 1.5453163659831753e-5) :- at_kitchen_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_bread(_), !.
delta(42, _, 0.017902370997480495) :- at_kitchen_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(42, _, 0.004142758212253634) :- at_kitchen_sandwich(_), done_served(Child), not_allergic_gluten(Child), !.
delta(42, _, -0.24443163432927215) :- at_kitchen_sandwich(_), !.
delta(42, _, 0.00011745639911586714) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(42, _, 0.04068229370612011) :- goal_served(Child), allergic_gluten(Child), !.
delta(42, _, -0.05351244112849559) :- goal_served(Child), done_served(Child), !.
delta(42, _, 0.004001885140127444).

% tree 43: step size 1.0, 253 examples, 12 leaves
delta(43, put_on_tray(_, _), -0.3543177681699089) :- fewer_ontray_1_than_todo_served_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(43, put_on_tray(Sandwich, _), 0.006561288674261154) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(43, put_on_tray(_, _), -0.00454161885511733) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(43, put_on_tray(_, _), 0.021912315686822108) :- !.
delta(43, move_tray(_, _, _), -0.00010625867641203131) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(43, _, 0.3060081739523215) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(43, make_sandwich_no_gluten(_, _, _), 0.0008771046215247648) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(43, _, -0.006321788661779616) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(43, move_tray(_, _, Place), -0.04167218101916505) :- done_served(Child), waiting(Child, Place), !.
delta(43, move_tray(_, _, _), 0.050577737920119284) :- !.
delta(43, _, 0.017060390051132863) :- no_gluten_bread(_), !.
delta(43, _, -0.05725299989863132).

% tree 44: step size 1.0, 254 examples, 12 leaves
delta(44, serve_sandwich(_, Child, _, _), 0.0) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, todo_served(Child2), allergic_gluten(Child2), !.
delta(44, serve_sandwich(_, Child, _, _), 0.07608050306328977) :- todo_served(Child), fewer_ontray_1_than_not_allergic_gluten, !.
delta(44, serve_sandwich(Sandwich, Child, _, Place), -0.004292859884027789) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(44, serve_sandwich(_, Child, _, _), 0.0027740088985709) :- todo_served(Child), !.
delta(44, serve_sandwich(_, _, _, _), -0.029644544396097896) :- !.
delta(44, put_on_tray(_, Tray), 0.03567514842369954) :- todo_served(Child), allergic_gluten(Child), ontray(_, Tray), !.
delta(44, put_on_tray(_, _), -0.05137763692649936) :- todo_served(Child), allergic_gluten(Child), !.
delta(44, _, 0.03365790381337542) :- todo_served(Child), allergic_gluten(Child), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(44, _, -0.014632282149602183) :- todo_served(Child), allergic_gluten(Child), !.
delta(44, put_on_tray(_, _), 0.01624361902628511) :- !.
delta(44, _, -0.06129671245806437) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(44, _, -0.0010229290205750804).

% tree 45: step size 1.0, 217 examples, 14 leaves
delta(45, move_tray(_, _, Place), 2.446834942547175e-5) :- no_gluten_bread(_), at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(45, move_tray(_, _, _), -0.07829481124040681) :- no_gluten_bread(_), !.
delta(45, move_tray(_, Place, _), 0.018295080293767394) :- done_served(Child), waiting(Child, Place), at_kitchen_sandwich(_), !.
delta(45, move_tray(_, Place, _), -9.816270757469068e-5) :- done_served(Child), waiting(Child, Place), !.
delta(45, move_tray(_, Place, Place2), 0.00010349673784295234) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(45, move_tray(_, _, _), -0.0041900807566485005) :- !.
delta(45, serve_sandwich_no_gluten(_, _, _, _), -0.01619050157473189) :- no_gluten_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(45, serve_sandwich_no_gluten(_, _, _, _), 0.004045622574485237) :- no_gluten_sandwich(_), !.
delta(45, make_sandwich(_, _, _), 0.007399783182345264) :- no_gluten_sandwich(_), !.
delta(45, _, 0.07599080654339112) :- no_gluten_sandwich(_), !.
delta(45, put_on_tray(_, _), -5.9219384000587326e-5) :- todo_served(Child), allergic_gluten(Child), !.
delta(45, put_on_tray(_, _), 0.015652533342661628) :- !.
delta(45, _, -0.02992035743230785) :- at_kitchen_sandwich(_), !.
delta(45, _, 0.0007560298629069258).

% tree 46: step size 1.0, 216 examples, 11 leaves
delta(46, serve_sandwich_no_gluten(_, _, _, _), 0.000426893341030916) :- fewer_at_1_than_allergic_gluten, !.
delta(46, serve_sandwich_no_gluten(_, _, _, _), -0.2176653566549837) :- fewer_ontray_2_than_allergic_gluten, !.
delta(46, serve_sandwich_no_gluten(_, _, _, _), 0.0008787177619846757) :- !.
delta(46, move_tray(_, _, _), 0.024639679568536424) :- goal_served(Child), not_allergic_gluten(Child), notexist(_), !.
delta(46, move_tray(_, _, _), -0.08778940610805015) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(46, _, -0.011452191016303945) :- goal_served(Child), not_allergic_gluten(Child), notexist(_), !.
delta(46, _, 0.07070517575517012) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(46, put_on_tray(_, _), 0.009459331282238992) :- at_kitchen_sandwich(_), !.
delta(46, _, -0.009190414248679158) :- at_kitchen_sandwich(_), !.
delta(46, _, -0.00022430360450383736) :- fewer_at_2_than_allergic_gluten, !.
delta(46, _, 0.21526346064466792).

% tree 47: step size 1.0, 202 examples, 14 leaves
delta(47, make_sandwich(_, _, _), 0.010613846351509464) :- fewer_at_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(47, make_sandwich(_, _, _), -0.0009343670540441881) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(47, make_sandwich(_, _, _), -0.04885230953415117) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(47, make_sandwich(_, _, _), 0.001394329777820402) :- at_kitchen_sandwich(_), !.
delta(47, make_sandwich(_, _, _), -0.0013041463588162978) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(47, make_sandwich(_, _, _), 0.0046684233459124425) :- !.
delta(47, put_on_tray(_, _), 0.00439094163514144) :- at_kitchen_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(47, _, -0.014269946967547749) :- at_kitchen_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(47, _, 0.046848909673135423) :- at_kitchen_sandwich(_), todo_served(Child), allergic_gluten(Child), !.
delta(47, _, -0.0013798883476015026) :- at_kitchen_sandwich(_), !.
delta(47, serve_sandwich_no_gluten(_, _, _, _), -0.015044663603345502) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(47, serve_sandwich_no_gluten(_, _, _, _), 0.0069885884187673485) :- !.
delta(47, _, 0.008361538599065903) :- fewer_at_2_than_todo_served, !.
delta(47, _, -0.009006232969672057).

% tree 48: step size 1.0, 212 examples, 13 leaves
delta(48, make_sandwich(_, _, _), -0.0589317653329828) :- at_kitchen_sandwich(_), goal_served(Child), allergic_gluten(Child), !.
delta(48, make_sandwich(_, _, _), 0.00011543477891310873) :- at_kitchen_sandwich(_), !.
delta(48, make_sandwich(_, _, _), 0.006096437721624484) :- no_gluten_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(48, make_sandwich(_, _, _), -0.0004222353277630908) :- no_gluten_sandwich(_), !.
delta(48, make_sandwich(_, _, _), -0.004510548035881295) :- !.
delta(48, serve_sandwich(_, _, _, _), -0.0017644483461847207) :- at_kitchen_sandwich(_), at_kitchen_bread(_), !.
delta(48, _, 0.058453989059920095) :- at_kitchen_sandwich(_), at_kitchen_bread(_), !.
delta(48, serve_sandwich(_, _, _, _), 0.005299972855729924) :- at_kitchen_sandwich(_), !.
delta(48, _, -0.004823085707763077) :- at_kitchen_sandwich(_), !.
delta(48, serve_sandwich(_, Child, _, _), 0.047659405813181614) :- todo_served(Child), !.
delta(48, serve_sandwich(_, _, _, _), -0.08853317059730224) :- !.
delta(48, _, -0.006820694110996622) :- no_gluten_bread(_), !.
delta(48, _, 0.027547318282084253).

% tree 49: step size 1.0, 219 examples, 15 leaves
delta(49, move_tray(Tray, _, _), -0.03869595698089841) :- at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(49, move_tray(Tray, _, Place), -0.014159767073479925) :- at(Tray, kitchen), done_served(Child), waiting(Child, Place), !.
delta(49, move_tray(Tray, _, _), 0.015557157506061257) :- at(Tray, kitchen), !.
delta(49, move_tray(_, Place, Place2), 0.005424073108383093) :- at(_, Place2), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(49, move_tray(_, _, Place), -0.045961529587355485) :- at(_, Place), !.
delta(49, move_tray(_, _, _), 5.159863287397142e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(49, move_tray(_, _, _), 0.8800932422471144) :- !.
delta(49, _, 0.030857452854642035) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), at(Tray, kitchen), fewer_ontray_1_than_todo_served, !.
delta(49, _, -0.004387193507052417) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), at(Tray, kitchen), !.
delta(49, _, -0.9105693033152312) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), todo_served(Child), allergic_gluten(Child), !.
delta(49, _, 0.013231511349926216) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(49, _, -0.042591271550511914) :- done_served(Child), not_allergic_gluten(Child), notexist(_), !.
delta(49, _, 0.006111542536291992) :- done_served(Child), not_allergic_gluten(Child), !.
delta(49, put_on_tray(_, _), -0.023187276319893063) :- !.
delta(49, _, 0.017618426244712573).

% tree 50: step size 1.0, 214 examples, 10 leaves
delta(50, make_sandwich(_, _, _), 0.00016270516119737402) :- goal_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(50, make_sandwich(_, _, _), -0.047816521485104575) :- goal_served(Child), allergic_gluten(Child), !.
delta(50, make_sandwich(_, _, _), 0.006229877135496125) :- !.
delta(50, move_tray(Tray, _, _), -0.056394341763751465) :- at(Tray, Place), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), no_gluten_bread(_), !.
delta(50, move_tray(Tray, _, _), 0.006869020213063822) :- at(Tray, Place), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(50, move_tray(Tray, _, _), -0.03934791472208067) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(50, move_tray(_, _, _), 0.0519492512405544) :- !.
delta(50, _, 0.07291317403941731) :- no_gluten_sandwich(_), !.
delta(50, _, -0.010154093217056431) :- goal_served(Child), done_served(Child), !.
delta(50, _, 0.002557498413958161).

% tree 51: step size 1.0, 223 examples, 11 leaves
delta(51, move_tray(_, Place, _), -0.09812584901185233) :- at(Tray, Place), ontray(_, Tray), !.
delta(51, move_tray(_, _, Place), -0.015161243806033817) :- at(_, Place), !.
delta(51, move_tray(_, _, kitchen), 0.07343499706070075) :- !.
delta(51, move_tray(_, _, _), -0.007329740575824879) :- !.
delta(51, make_sandwich(_, _, _), -0.003801739177407716) :- fewer_at_1_than_not_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(51, make_sandwich(_, _, _), 0.010755999812394073) :- fewer_at_1_than_not_allergic_gluten, !.
delta(51, make_sandwich(_, _, _), -0.024409374609300174) :- goal_served(Child), allergic_gluten(Child), !.
delta(51, make_sandwich(_, _, _), 0.000206823145040678) :- !.
delta(51, _, 0.07671782651998989) :- no_gluten_sandwich(_), !.
delta(51, _, 0.012747352043150976) :- notexist(_), !.
delta(51, _, -0.011542087529965286).

% tree 52: step size 1.0, 214 examples, 15 leaves
delta(52, move_tray(Tray, Place, Place2), 0.1648100844476454) :- could_serve_sandwich(Tray, Place2), fewer_ontray_1_than_todo_served_not_allergic_gluten, goal_served(Child), waiting(Child, Place), !.
delta(52, move_tray(Tray, _, Place), -0.006130260273778636) :- could_serve_sandwich(Tray, Place), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(52, move_tray(Tray, _, Place), 0.038942012430139415) :- could_serve_sandwich(Tray, Place), at(Tray, kitchen), !.
delta(52, move_tray(Tray, _, Place), -0.047827265048004095) :- could_serve_sandwich(Tray, Place), !.
delta(52, move_tray(_, Place, Place2), 0.004660785510983253) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(52, move_tray(_, _, _), -0.0007792212025360778) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(52, move_tray(_, _, _), -0.07636065542143874) :- !.
delta(52, serve_sandwich(_, _, _, _), -0.153048804093412) :- at_kitchen_sandwich(_), fewer_at_1_than_todo_served, !.
delta(52, serve_sandwich(_, _, _, _), 0.0007336660387722086) :- at_kitchen_sandwich(_), !.
delta(52, make_sandwich(_, _, _), -0.006845817714041888) :- at_kitchen_sandwich(_), !.
delta(52, _, 0.018339558317381783) :- at_kitchen_sandwich(_), !.
delta(52, make_sandwich(_, _, _), -6.65031875635377e-5) :- done_served(Child), not_allergic_gluten(Child), !.
delta(52, _, 0.053753139349532825) :- done_served(Child), not_allergic_gluten(Child), !.
delta(52, _, -0.010832373918318174) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(52, _, 0.002500479321370141).

% tree 53: step size 1.0, 202 examples, 14 leaves
delta(53, move_tray(_, Place, Place2), 0.1979134639032312) :- at(_, Place2), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(53, move_tray(_, _, Place), -0.020816281938413863) :- at(_, Place), !.
delta(53, move_tray(_, _, _), 0.01982680841550835) :- goal_served(Child), allergic_gluten(Child), fewer_at_1_than_allergic_gluten, !.
delta(53, move_tray(_, _, _), -0.33906670469325517) :- goal_served(Child), allergic_gluten(Child), !.
delta(53, move_tray(_, _, _), -0.013632940539192352) :- goal_served(Child), done_served(Child), !.
delta(53, move_tray(_, _, _), 0.026995865696845808) :- !.
delta(53, put_on_tray(_, _), 0.0059563198247558615) :- no_gluten_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(53, _, -0.02209156245781421) :- no_gluten_sandwich(_), fewer_at_1_than_allergic_gluten, !.
delta(53, _, -0.003868229410033251) :- no_gluten_sandwich(_), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(53, _, 0.17261499382924564) :- no_gluten_sandwich(_), !.
delta(53, _, -0.0005889419742709634) :- goal_served(Child), done_served(Child), at_kitchen_bread(_), !.
delta(53, _, 0.011655025786464622) :- goal_served(Child), done_served(Child), !.
delta(53, _, 0.002055670500451177) :- notexist(_), !.
delta(53, _, -0.0181998626269129).

% tree 54: step size 1.0, 219 examples, 13 leaves
delta(54, make_sandwich(_, _, _), 0.0007347440676593817) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(54, make_sandwich(_, _, _), 0.26068928655425977) :- fewer_at_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(54, make_sandwich(_, _, _), -0.0004125298963049177) :- fewer_at_1_than_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(54, make_sandwich(_, _, _), 0.0005895276094287767) :- fewer_at_1_than_not_allergic_gluten, !.
delta(54, make_sandwich(_, _, _), -0.017574525885391757) :- !.
delta(54, move_tray(_, _, _), -0.007026565607025535) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(54, _, 0.008983651845571474) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(54, serve_sandwich(_, _, _, _), 0.010490922125110292) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(54, _, -0.26528172021333973) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(54, serve_sandwich(_, Child, _, _), 0.055652182319583986) :- todo_served(Child), !.
delta(54, serve_sandwich(_, _, _, _), -0.07058940217426532) :- !.
delta(54, _, 0.042439517724947654) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(54, _, -0.020746086436137373).

% tree 55: step size 1.0, 201 examples, 11 leaves
delta(55, serve_sandwich_no_gluten(_, _, _, _), 0.004417250147187628) :- fewer_ontray_2_than_todo_served, todo_served(Child), not_allergic_gluten(Child), !.
delta(55, serve_sandwich_no_gluten(_, _, _, _), -0.1874429254713872) :- fewer_ontray_2_than_todo_served, !.
delta(55, serve_sandwich_no_gluten(_, _, _, _), 0.0023183551731535117) :- !.
delta(55, make_sandwich(_, _, _), 0.06711066687645394) :- goal_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(55, make_sandwich(_, _, _), -0.010455919489795858) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(55, _, -0.051903214167986066) :- goal_served(Child), not_allergic_gluten(Child), no_gluten_sandwich(_), !.
delta(55, _, 0.00022814723166893859) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(55, make_sandwich_no_gluten(_, _, _), 0.001254810639446498) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(55, _, -0.002671915786294759) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(55, _, 0.18736379143340212) :- fewer_ontray_2_than_todo_served, !.
delta(55, _, -0.0006643095722223723).

% tree 56: step size 1.0, 229 examples, 11 leaves
delta(56, serve_sandwich(_, Child, _, _), -0.047921075538861005) :- todo_served(Child), todo_served(Child2), allergic_gluten(Child2), !.
delta(56, serve_sandwich(_, Child, _, _), 0.054978256011568485) :- todo_served(Child), !.
delta(56, serve_sandwich(_, _, _, _), -0.09209786880213106) :- !.
delta(56, make_sandwich(_, _, _), 0.03967919963235623) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(56, make_sandwich(_, _, _), -0.00880769843221826) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(56, _, -0.05046781510209587) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(56, _, 0.009755067541370848) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(56, serve_sandwich_no_gluten(_, _, _, _), -0.013004696890858218) :- at_kitchen_bread(_), !.
delta(56, serve_sandwich_no_gluten(_, _, _, _), 0.0033947031395471245) :- !.
delta(56, _, 0.0703041025701323) :- fewer_at_1_than_todo_served, !.
delta(56, _, 0.00022344805029877231).

% tree 57: step size 1.0, 229 examples, 12 leaves
delta(57, serve_sandwich(Sandwich, Child, _, _), -0.019877368408700295) :- todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(57, serve_sandwich(_, Child, _, _), 0.08325885212572363) :- todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(57, serve_sandwich(_, Child, _, _), 0.0011439589303806244) :- todo_served(Child), !.
delta(57, serve_sandwich(_, _, _, _), -0.04438818142922992) :- !.
delta(57, put_on_tray(_, _), -0.00015325220215519595) :- fewer_ontray_1_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(57, put_on_tray(_, _), 0.04388675371946811) :- fewer_ontray_1_than_allergic_gluten, !.
delta(57, put_on_tray(_, _), -0.022608888822150053) :- goal_served(Child), allergic_gluten(Child), !.
delta(57, put_on_tray(_, _), 0.001101230282791733) :- !.
delta(57, _, -0.002307705325753511) :- fewer_at_2_than_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(57, _, 0.014317526008097579) :- fewer_at_2_than_allergic_gluten, !.
delta(57, _, -0.07064709961973996) :- fewer_at_1_than_not_allergic_gluten, !.
delta(57, _, 0.008419406508438943).

% tree 58: step size 1.0, 257 examples, 15 leaves
delta(58, move_tray(Tray, _, Place), 0.04228170857877709) :- goal_served(Child), waiting(Child, Place), at(Tray, kitchen), allergic_gluten(Child), !.
delta(58, move_tray(Tray, _, Place), -0.03580558971094955) :- goal_served(Child), waiting(Child, Place), at(Tray, kitchen), !.
delta(58, move_tray(_, _, Place), 0.004993515536614785) :- goal_served(Child), waiting(Child, Place), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(58, move_tray(_, _, Place), -0.139862663080394) :- goal_served(Child), waiting(Child, Place), !.
delta(58, move_tray(_, _, Place), -0.0018302842994801847) :- at_kitchen_sandwich(_), at(_, Place), !.
delta(58, move_tray(_, _, _), 0.11498888443870747) :- at_kitchen_sandwich(_), !.
delta(58, move_tray(_, _, _), -0.022736634136026466) :- !.
delta(58, _, 1.0503876416556754e-17) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_ontray_1_than_todo_served_not_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(58, _, 0.002646967625795732) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(58, _, -0.042143558420928706) :- fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(58, _, 0.002538556979986756) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(58, put_on_tray(_, Tray), 0.003744781006215744) :- ontray(_, Tray), !.
delta(58, put_on_tray(_, _), -0.029501068204956973) :- !.
delta(58, _, 0.0860334164749495) :- no_gluten_sandwich(_), !.
delta(58, _, 0.002592607981786382).

% tree 59: step size 1.0, 206 examples, 11 leaves
delta(59, make_sandwich(_, _, _), -0.0014795033549190647) :- fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(59, make_sandwich(_, _, _), 0.0) :- fewer_ontray_1_than_not_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(59, make_sandwich(_, _, _), 0.002081050732000766) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(59, make_sandwich(_, _, _), -0.027892764776664296) :- !.
delta(59, serve_sandwich_no_gluten(_, _, _, _), 0.0009685397533014103) :- fewer_at_2_than_allergic_gluten, !.
delta(59, serve_sandwich_no_gluten(_, _, _, _), 0.00046836561257293996) :- at_kitchen_bread(_), !.
delta(59, serve_sandwich_no_gluten(_, _, _, _), -0.019970944505326667) :- !.
delta(59, move_tray(_, _, _), -0.013049521000118426) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(59, _, 0.01009995609297853) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(59, _, 0.03841553550879607) :- notexist(_), !.
delta(59, _, 0.00036967157518357754).

% tree 60: step size 1.0, 224 examples, 12 leaves
delta(60, serve_sandwich_no_gluten(_, _, Tray, _), 0.000615710500752404) :- goal_served(Child), done_served(Child), waiting(Child, Place), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(60, serve_sandwich_no_gluten(_, _, _, _), 0.000468480582467894) :- goal_served(Child), done_served(Child), fewer_at_2_than_allergic_gluten, !.
delta(60, serve_sandwich_no_gluten(_, _, _, _), -0.3387407897599797) :- goal_served(Child), done_served(Child), !.
delta(60, serve_sandwich_no_gluten(_, _, _, _), 0.00844418035293233) :- !.
delta(60, put_on_tray(_, _), 1.2442466635609824e-5) :- done_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(60, put_on_tray(_, _), -0.024074941718841704) :- done_served(Child), allergic_gluten(Child), !.
delta(60, _, -1.1573515544062098e-5) :- done_served(Child), allergic_gluten(Child), done_served(Child2), not_allergic_gluten(Child2), !.
delta(60, _, 0.33945363767423714) :- done_served(Child), allergic_gluten(Child), !.
delta(60, move_tray(_, _, Place), 0.11777667762644742) :- at(_, Place), !.
delta(60, move_tray(_, _, _), -0.08882028492448796) :- !.
delta(60, _, 0.02467934134537113) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(60, _, -0.027701070364008814).

% tree 61: step size 1.0, 214 examples, 12 leaves
delta(61, serve_sandwich(Sandwich, Child, _, _), -0.0032336862873907552) :- todo_served(Child), no_gluten_sandwich(Sandwich), todo_served(Child2), allergic_gluten(Child2), !.
delta(61, serve_sandwich(Sandwich, Child, _, _), 0.00017752666912751046) :- todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(61, serve_sandwich(_, Child, _, _), 0.08917404577200692) :- todo_served(Child), !.
delta(61, serve_sandwich(_, _, _, _), -0.06655571070254396) :- !.
delta(61, make_sandwich(_, _, _), -0.004023869924135703) :- no_gluten_sandwich(_), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(61, make_sandwich(_, _, _), 0.009549983506165724) :- no_gluten_sandwich(_), !.
delta(61, _, 0.003601935416410972) :- no_gluten_sandwich(_), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(61, _, -0.051091218370349176) :- no_gluten_sandwich(_), !.
delta(61, _, 0.015370369977042081) :- goal_served(Child), done_served(Child), fewer_at_1_than_todo_served, !.
delta(61, _, -0.0003599329069280362) :- goal_served(Child), done_served(Child), !.
delta(61, make_sandwich_no_gluten(_, _, _), 0.0012338198711882293) :- !.
delta(61, _, -0.002081861118389047).

% tree 62: step size 1.0, 204 examples, 14 leaves
delta(62, move_tray(_, Place, Place2), 0.0238786568519302) :- at(Tray, Place), could_serve_sandwich(Tray, Place), at(Tray2, Place2), ontray(_, Tray2), !.
delta(62, move_tray(_, Place, _), -0.07836114689586005) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(62, move_tray(_, Place, Place2), 0.0061704720614778625) :- at(_, Place2), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place2), !.
delta(62, move_tray(_, _, Place), -0.01902267582037905) :- at(_, Place), !.
delta(62, move_tray(_, _, Place), -0.006767891808038062) :- done_served(Child), waiting(Child, Place), !.
delta(62, move_tray(_, _, _), 0.12013291730406231) :- !.
delta(62, _, 0.0023779072750027674) :- notexist(_), fewer_at_1_than_todo_served_not_allergic_gluten, todo_served(Child), allergic_gluten(Child), !.
delta(62, _, -0.12470411630009957) :- notexist(_), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(62, make_sandwich(_, _, _), -0.003500291290133709) :- notexist(_), !.
delta(62, _, 0.03073976222378711) :- notexist(_), !.
delta(62, serve_sandwich_no_gluten(_, _, _, _), 0.003914131643640755) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(62, _, -0.011966257601767456) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(62, _, -0.0018826320641406357) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(62, _, 0.03968175594951385).

% tree 63: step size 1.0, 214 examples, 14 leaves
delta(63, move_tray(Tray, _, Place), -0.007064177881279948) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_1_than_todo_served, !.
delta(63, move_tray(Tray, _, Place), 0.030151337091472514) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(63, move_tray(Tray, _, kitchen), -0.027474354281716223) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(63, move_tray(_, _, kitchen), 0.040334325699845804) :- !.
delta(63, move_tray(_, _, Place), -4.744384143240451e-5) :- at(Tray, Place), ontray(_, Tray), !.
delta(63, move_tray(_, _, _), -0.09903617953696581) :- !.
delta(63, put_on_tray(_, _), -0.030414792912263032) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(63, put_on_tray(_, _), 0.0058752764789891014) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(63, put_on_tray(_, _), 0.013920759900765576) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(63, put_on_tray(_, _), -0.0008799100451094413) :- !.
delta(63, make_sandwich_no_gluten(_, _, _), 0.0015041178300239531) :- fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(63, _, -0.0019999949119735697) :- fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(63, _, 0.06319592746905682) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(63, _, -0.00153999597784712).

% tree 64: step size 1.0, 218 examples, 16 leaves
delta(64, move_tray(_, Place, _), -0.0011087849523383582) :- done_served(Child), waiting(Child, Place), at_kitchen_bread(_), todo_served(Child2), waiting(Child2, Place), !.
delta(64, move_tray(_, Place, _), 0.0) :- done_served(Child), waiting(Child, Place), at_kitchen_bread(_), !.
delta(64, move_tray(_, Place, Place2), -0.0004975599348923451) :- done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(64, move_tray(_, Place, _), 0.252915768339656) :- done_served(Child), waiting(Child, Place), !.
delta(64, move_tray(_, Place, Place2), 0.03023891771300142) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_ontray_1_than_todo_served, !.
delta(64, move_tray(_, Place, Place2), -0.008696059990220682) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(64, move_tray(_, _, _), -0.03933468305839225) :- fewer_ontray_2_than_todo_served, !.
delta(64, move_tray(_, _, _), 0.006342882965529143) :- !.
delta(64, _, 0.00327470903451505) :- goal_served(Child), done_served(Child), notexist(_), fewer_ontray_1_than_allergic_gluten, !.
delta(64, _, -0.026095664597462355) :- goal_served(Child), done_served(Child), notexist(_), !.
delta(64, _, -0.2232460077555889) :- goal_served(Child), done_served(Child), waiting(Child, Place), at(_, Place), !.
delta(64, _, 0.0018676486488942848) :- goal_served(Child), done_served(Child), !.
delta(64, make_sandwich(_, _, _), 0.040134330467956475) :- fewer_at_1_than_not_allergic_gluten, !.
delta(64, make_sandwich(_, _, _), -0.01323365082803408) :- !.
delta(64, _, -0.0304717148516295) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(64, _, 0.014496033625376112).

% tree 65: step size 1.0, 207 examples, 14 leaves
delta(65, move_tray(_, Place, Place2), 0.01826027451310473) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(65, move_tray(_, Place, _), -0.004827987291087152) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, done_served(Child), waiting(Child, Place), !.
delta(65, move_tray(_, _, _), -0.021341432339126318) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(65, move_tray(_, Place, Place2), 0.0023127097666340536) :- at(Tray, Place), could_put_on_tray(Tray, Place2), at_kitchen_bread(_), !.
delta(65, move_tray(_, Place, Place2), -0.01594920910312539) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(65, move_tray(Tray, _, _), 0.1382859910081691) :- ontray(_, Tray), !.
delta(65, move_tray(_, _, _), -0.006179200077517827) :- !.
delta(65, _, 0.0002438615295897309) :- goal_served(Child), done_served(Child), waiting(Child, Place), at(_, Place), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(65, _, -0.10471978540411687) :- goal_served(Child), done_served(Child), waiting(Child, Place), at(_, Place), !.
delta(65, _, 0.0017133172599390093) :- goal_served(Child), done_served(Child), !.
delta(65, _, 5.339415665554873e-5) :- fewer_ontray_1_than_not_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(65, _, 0.01915863380215978) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(65, serve_sandwich_no_gluten(_, _, _, _), 0.007066281601639577) :- !.
delta(65, _, -0.020089683923112747).

% tree 66: step size 1.0, 255 examples, 14 leaves
delta(66, make_sandwich(_, _, _), -0.0022217908263406673) :- fewer_at_1_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(66, make_sandwich(_, _, _), 0.15309685893375266) :- fewer_at_1_than_allergic_gluten, !.
delta(66, make_sandwich(_, _, _), 0.0007488432362221769) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(66, make_sandwich(_, _, _), -0.04639680578073891) :- at_kitchen_sandwich(_), !.
delta(66, make_sandwich(_, Bread_portion, _), -0.012340626513834385) :- no_gluten_bread(Bread_portion), !.
delta(66, make_sandwich(_, _, _), 0.014044238819725286) :- !.
delta(66, _, -0.15384128485315735) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), at_kitchen_bread(_), !.
delta(66, _, 4.125188660312968e-20) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), !.
delta(66, move_tray(_, _, _), -0.005243573494162983) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(66, _, 0.026495327222070684) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(66, move_tray(_, _, Place), 0.022590670938657575) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(66, move_tray(_, _, _), -0.070855674060089) :- !.
delta(66, _, 0.0005285800579256121) :- fewer_no_gluten_sandwich_than_todo_served_allergic_gluten, !.
delta(66, _, 0.04684356360549437).

% tree 67: step size 1.0, 225 examples, 14 leaves
delta(67, put_on_tray(_, _), 1.6842578108735022e-5) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, done_served(Child), not_allergic_gluten(Child), !.
delta(67, put_on_tray(_, _), -0.3402708644159187) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_at_1_than_not_allergic_gluten, !.
delta(67, put_on_tray(Sandwich, _), 0.01479926607533814) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(67, put_on_tray(_, _), -0.007980014353860788) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(67, put_on_tray(_, _), 0.011165506385586577) :- notexist(_), !.
delta(67, put_on_tray(_, _), -0.0017966636676814303) :- todo_served(Child), allergic_gluten(Child), !.
delta(67, put_on_tray(_, _), 0.0002839525313750718) :- !.
delta(67, move_tray(_, _, _), -0.0075436988839465815) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(67, _, 8.771889543724711e-6) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(67, _, 0.3323872105010203) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(67, serve_sandwich_no_gluten(_, Child, _, _), 0.006637044046069839) :- todo_served(Child), !.
delta(67, serve_sandwich_no_gluten(_, _, _, _), -0.1345891993803525) :- !.
delta(67, _, 0.12362239111615043) :- done_served(Child), allergic_gluten(Child), !.
delta(67, _, -0.005524638040225077).

% tree 68: step size 1.0, 219 examples, 14 leaves
delta(68, move_tray(Tray, _, Place), -0.001451626045967216) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), allergic_gluten(Child), waiting(Child, Place), fewer_at_1_than_allergic_gluten, !.
delta(68, move_tray(Tray, _, Place), 0.24086586232612384) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), allergic_gluten(Child), waiting(Child, Place), !.
delta(68, move_tray(Tray, _, Place), -0.022819907732700172) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), fewer_at_1_than_todo_served, !.
delta(68, move_tray(Tray, _, Place), 0.006185044758233803) :- could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(68, move_tray(Tray, Place, Place2), -0.00424536074568638) :- at(Tray2, Place), could_put_on_tray(Tray2, Place2), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(68, move_tray(_, Place, Place2), 0.015678719853444555) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(68, move_tray(_, _, _), -0.06974296977868309) :- !.
delta(68, make_sandwich(_, _, _), -0.024278298339595956) :- notexist(_), fewer_at_2_than_allergic_gluten, !.
delta(68, make_sandwich(_, _, _), 0.010148329468562972) :- notexist(_), !.
delta(68, _, -0.0015594726098989607) :- notexist(_), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(68, _, 0.023879707852402714) :- notexist(_), !.
delta(68, _, -0.20220992160558462) :- at_kitchen_sandwich(_), fewer_no_gluten_sandwich_than_todo_served, !.
delta(68, _, 0.0011845036527716975) :- at_kitchen_sandwich(_), !.
delta(68, _, 0.009102333107484154).

% tree 69: step size 1.0, 219 examples, 12 leaves
delta(69, put_on_tray(_, _), 0.08431195477929096) :- fewer_ontray_1_than_allergic_gluten, !.
delta(69, put_on_tray(_, _), 0.011697961165659831) :- done_served(Child), not_allergic_gluten(Child), !.
delta(69, put_on_tray(Sandwich, _), 0.0005022506754265723) :- no_gluten_sandwich(Sandwich), !.
delta(69, put_on_tray(_, _), -0.015793096672276963) :- !.
delta(69, move_tray(_, _, _), -0.016776887633443663) :- no_gluten_sandwich(_), done_served(Child), allergic_gluten(Child), !.
delta(69, _, 0.027407416432516093) :- no_gluten_sandwich(_), done_served(Child), allergic_gluten(Child), !.
delta(69, _, -0.08748262234563896) :- no_gluten_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(69, _, 0.00426319490572624) :- no_gluten_sandwich(_), !.
delta(69, make_sandwich(_, _, _), -0.0010779203377681954) :- todo_served(Child), allergic_gluten(Child), !.
delta(69, make_sandwich(_, _, _), 0.00960643657061314) :- !.
delta(69, make_sandwich_no_gluten(_, _, _), 0.000871432936085365) :- !.
delta(69, _, -0.003097957595173387).

% tree 70: step size 1.0, 216 examples, 16 leaves
delta(70, move_tray(_, _, Place), 0.0009307175864324029) :- fewer_at_2_than_todo_served, done_served(Child), waiting(Child, Place), at(Tray, Place), ontray(_, Tray), !.
delta(70, move_tray(_, _, Place), -0.01913172193917181) :- fewer_at_2_than_todo_served, done_served(Child), waiting(Child, Place), !.
delta(70, move_tray(_, Place, _), 0.20009746731532058) :- fewer_at_2_than_todo_served, at(Tray, Place), ontray(_, Tray), !.
delta(70, move_tray(_, _, _), -0.0044244431610145135) :- fewer_at_2_than_todo_served, !.
delta(70, move_tray(_, Place, Place2), 0.005202545135964021) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), goal_served(Child), done_served(Child), !.
delta(70, move_tray(_, Place, Place2), -8.393279450891893e-7) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(70, move_tray(_, _, _), 0.0025056472606408173) :- at_kitchen_bread(_), !.
delta(70, move_tray(_, _, _), -0.05222378469100533) :- !.
delta(70, make_sandwich(_, _, _), -0.006750995824366172) :- fewer_ontray_1_than_todo_served_allergic_gluten, fewer_at_2_than_allergic_gluten, !.
delta(70, make_sandwich(_, _, _), 0.19141848906460035) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(70, make_sandwich(_, _, _), -0.04043371736519406) :- at_kitchen_sandwich(_), !.
delta(70, make_sandwich(_, _, _), 0.0019405805217578898) :- !.
delta(70, _, -0.327804524083543) :- no_gluten_sandwich(_), fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(70, _, 0.04441308726244178) :- no_gluten_sandwich(_), !.
delta(70, _, 6.331815842231096e-5) :- fewer_at_2_than_allergic_gluten, !.
delta(70, _, 0.013849300615992927).

% tree 71: step size 1.0, 208 examples, 8 leaves
delta(71, make_sandwich(_, _, _), -0.05482398434433585) :- !.
delta(71, make_sandwich_no_gluten(_, _, _), 0.0014456858671528501) :- at_kitchen_bread(_), fewer_no_gluten_sandwich_than_todo_served_allergic_gluten, !.
delta(71, _, -0.0005310590005889265) :- at_kitchen_bread(_), fewer_no_gluten_sandwich_than_todo_served_allergic_gluten, !.
delta(71, _, 0.06010672035445508) :- at_kitchen_bread(_), !.
delta(71, move_tray(_, _, _), -0.04775553197946867) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(71, move_tray(_, _, _), 0.03768630379762558) :- !.
delta(71, _, 0.04007708321138373) :- fewer_no_gluten_sandwich_than_todo_served, !.
delta(71, _, -0.03800210849337155).

% tree 72: step size 1.0, 206 examples, 16 leaves
delta(72, move_tray(_, _, Place), -0.003750554906996561) :- goal_served(Child), allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(72, move_tray(_, _, Place), 0.010548024138964034) :- goal_served(Child), allergic_gluten(Child), done_served(Child2), waiting(Child2, Place), !.
delta(72, move_tray(Tray, _, _), -0.07338412526813455) :- goal_served(Child), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(72, move_tray(_, _, _), 0.007182457248169047) :- goal_served(Child), allergic_gluten(Child), !.
delta(72, move_tray(_, Place, Place2), -0.0005740649930389958) :- done_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place2), !.
delta(72, move_tray(_, Place, _), 0.015294662314961165) :- done_served(Child), waiting(Child, Place), !.
delta(72, move_tray(_, Place, Place2), 0.0015195938039210362) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(72, move_tray(_, _, _), -0.0064074870688134895) :- !.
delta(72, put_on_tray(Sandwich, _), 0.058346358977161054) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served, !.
delta(72, put_on_tray(Sandwich, _), -0.020815877343155223) :- no_gluten_sandwich(Sandwich), !.
delta(72, put_on_tray(_, Tray), 0.006566657845799448) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(72, put_on_tray(_, _), -0.07006187419376744) :- !.
delta(72, _, -0.0006657761127752818) :- no_gluten_sandwich(_), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(72, _, 0.07366772225652117) :- no_gluten_sandwich(_), !.
delta(72, _, -0.008834105712165766) :- fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(72, _, 0.001258347837444675).

% tree 73: step size 1.0, 205 examples, 15 leaves
delta(73, move_tray(_, Place, Place2), -0.002678215350787631) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(73, move_tray(_, Place, Place2), 0.04801779851551817) :- at(Tray, Place), could_put_on_tray(Tray, Place2), fewer_at_1_than_todo_served, !.
delta(73, move_tray(_, Place, Place2), 0.0005580911895169474) :- at(Tray, Place), could_put_on_tray(Tray, Place2), done_served(Child), not_allergic_gluten(Child), !.
delta(73, move_tray(_, Place, Place2), -0.020953187841401332) :- at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(73, move_tray(_, _, _), -0.07496192105292943) :- no_gluten_bread(_), !.
delta(73, move_tray(_, Place, Place2), 0.003981871285992049) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(73, move_tray(_, _, _), -0.004538021018491174) :- !.
delta(73, put_on_tray(Sandwich, Tray), -0.0067792097990591865) :- no_gluten_sandwich(Sandwich), ontray(Sandwich2, Tray), no_gluten_sandwich(Sandwich2), !.
delta(73, put_on_tray(Sandwich, _), 0.03284599060969527) :- no_gluten_sandwich(Sandwich), !.
delta(73, put_on_tray(_, Tray), 0.029777586409125596) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(73, put_on_tray(_, _), -0.07277098347207853) :- !.
delta(73, serve_sandwich_no_gluten(_, Child, _, _), 0.021354463595365403) :- todo_served(Child), !.
delta(73, serve_sandwich_no_gluten(_, _, _, _), -0.03857525860570773) :- !.
delta(73, _, 0.07694748111888565) :- no_gluten_sandwich(_), !.
delta(73, _, -9.991361262264767e-5).

% tree 74: step size 1.0, 201 examples, 11 leaves
delta(74, make_sandwich(_, _, _), -5.2797933437903316e-5) :- done_served(Child), allergic_gluten(Child), fewer_at_1_than_allergic_gluten, !.
delta(74, make_sandwich(_, _, _), 0.0006175364926209989) :- done_served(Child), allergic_gluten(Child), !.
delta(74, make_sandwich(_, _, _), -0.07758426389103619) :- !.
delta(74, serve_sandwich(_, _, _, _), -0.001218200380294719) :- no_gluten_sandwich(_), at_kitchen_bread(_), !.
delta(74, _, 0.07557860237248072) :- no_gluten_sandwich(_), at_kitchen_bread(_), !.
delta(74, move_tray(_, _, _), -0.023279330949707824) :- no_gluten_sandwich(_), !.
delta(74, _, 0.024159377202609394) :- no_gluten_sandwich(_), !.
delta(74, move_tray(Tray, _, Place), 0.0036212159483378814) :- could_serve_sandwich(Tray, Place), !.
delta(74, move_tray(_, _, _), -0.015094800125986043) :- !.
delta(74, _, 0.023016936814024187) :- at_kitchen_sandwich(_), !.
delta(74, _, -0.003829909938409709).

% tree 75: step size 1.0, 244 examples, 15 leaves
delta(75, move_tray(_, _, Place), 0.0009279656129122766) :- at(Tray, Place), could_serve_sandwich(Tray, Place), fewer_ontray_2_than_todo_served, at(Tray2, Place), could_serve_sandwich_no_gluten(Tray2, Place), !.
delta(75, move_tray(_, _, Place), -0.213745879254559) :- at(Tray, Place), could_serve_sandwich(Tray, Place), fewer_ontray_2_than_todo_served, !.
delta(75, move_tray(_, _, Place), 0.008678181658116228) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(75, move_tray(_, _, _), 0.3208909867141471) :- fewer_at_1_than_todo_served, no_gluten_sandwich(_), !.
delta(75, move_tray(_, _, _), -0.0067368998687664826) :- fewer_at_1_than_todo_served, !.
delta(75, move_tray(_, Place, _), -0.022519922356612054) :- goal_served(Child), waiting(Child, Place), !.
delta(75, move_tray(_, _, _), 0.0032717322628765134) :- !.
delta(75, put_on_tray(_, _), 0.0011252432546939623) :- at_kitchen_sandwich(_), no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(75, _, -0.12467268332311653) :- at_kitchen_sandwich(_), no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(75, make_sandwich(_, _, _), -0.0035593607039763942) :- at_kitchen_sandwich(_), !.
delta(75, _, 0.010386758011843321) :- at_kitchen_sandwich(_), !.
delta(75, serve_sandwich(_, _, _, _), 0.0187209959195387) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(75, _, -0.002866962517592749) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(75, _, -0.02725940417107251) :- done_served(Child), allergic_gluten(Child), !.
delta(75, _, 0.008579327044147822).

% tree 76: step size 1.0, 225 examples, 12 leaves
delta(76, move_tray(_, Place, _), -0.05478805794704064) :- goal_served(Child), waiting(Child, Place), !.
delta(76, move_tray(_, Place, _), -0.019974614687564823) :- at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(76, move_tray(_, _, Place), -0.001493804193077199) :- at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(76, move_tray(_, _, _), 0.1567052142099036) :- !.
delta(76, put_on_tray(Sandwich, _), 0.04981545108002951) :- fewer_at_2_than_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(76, put_on_tray(_, _), -0.08953252473942244) :- fewer_at_2_than_allergic_gluten, !.
delta(76, _, 0.06040108988085877) :- fewer_at_2_than_allergic_gluten, no_gluten_sandwich(_), !.
delta(76, _, 1.482548906347758e-6) :- fewer_at_2_than_allergic_gluten, !.
delta(76, _, -0.1311776110268333) :- goal_served(Child), allergic_gluten(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(76, _, 0.009830860154227093) :- goal_served(Child), allergic_gluten(Child), !.
delta(76, _, 0.016191539367126365) :- fewer_ontray_1_than_todo_served, !.
delta(76, _, -0.00023173333422557695).

% tree 77: step size 1.0, 221 examples, 12 leaves
delta(77, make_sandwich(_, _, _), -0.031672910423535136) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(77, make_sandwich(_, _, _), -0.008807217088816462) :- goal_served(Child), done_served(Child), !.
delta(77, make_sandwich(_, _, _), 0.023893305758570002) :- fewer_ontray_1_than_todo_served, !.
delta(77, make_sandwich(_, _, _), -0.008296155305848357) :- !.
delta(77, serve_sandwich_no_gluten(_, _, _, _), -0.01974870460017613) :- at_kitchen_sandwich(_), todo_served(Child), not_allergic_gluten(Child), !.
delta(77, serve_sandwich_no_gluten(_, _, _, _), 6.864354907556384e-5) :- at_kitchen_sandwich(_), !.
delta(77, serve_sandwich_no_gluten(_, _, _, _), -0.00033797868834777197) :- fewer_ontray_1_than_allergic_gluten, !.
delta(77, serve_sandwich_no_gluten(_, _, _, _), 0.008372751101824331) :- !.
delta(77, make_sandwich_no_gluten(_, _, _), -0.009401120192540158) :- at_kitchen_sandwich(_), !.
delta(77, _, 0.043410858738328895) :- at_kitchen_sandwich(_), !.
delta(77, move_tray(_, _, _), -0.011900144169249074) :- !.
delta(77, _, 0.005081064313465419).

% tree 78: step size 1.0, 218 examples, 13 leaves
delta(78, serve_sandwich(Sandwich, _, _, _), -0.09384535939956908) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(78, serve_sandwich(Sandwich, _, _, _), 0.0007725364156880955) :- no_gluten_sandwich(Sandwich), !.
delta(78, serve_sandwich(_, Child, _, _), 0.0588670600723487) :- todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(78, serve_sandwich(_, Child, _, _), 0.0007710758917310125) :- todo_served(Child), !.
delta(78, serve_sandwich(_, _, _, _), -0.03560088712283786) :- !.
delta(78, make_sandwich(_, Bread_portion, _), -0.005831038856437455) :- goal_served(Child), done_served(Child), no_gluten_bread(Bread_portion), !.
delta(78, make_sandwich(_, _, _), 0.013028927134567702) :- goal_served(Child), done_served(Child), !.
delta(78, _, 0.0018790489549125975) :- goal_served(Child), done_served(Child), fewer_at_1_than_allergic_gluten, !.
delta(78, _, -0.030772866405249753) :- goal_served(Child), done_served(Child), !.
delta(78, put_on_tray(_, _), 0.014803879164642025) :- fewer_at_2_than_allergic_gluten, !.
delta(78, _, -0.012178619229191558) :- fewer_at_2_than_allergic_gluten, !.
delta(78, put_on_tray(_, _), -0.0014976250361037064) :- !.
delta(78, _, 0.0868280155612126).

% tree 79: step size 1.0, 202 examples, 14 leaves
delta(79, make_sandwich(_, _, _), 0.03539833456204304) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), todo_served(Child), not_allergic_gluten(Child), !.
delta(79, make_sandwich(_, _, _), -0.00024428695536354514) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(79, make_sandwich(_, _, _), -0.0018876487329888428) :- fewer_ontray_1_than_allergic_gluten, !.
delta(79, make_sandwich(_, _, _), -9.31663524221186e-5) :- todo_served(Child), allergic_gluten(Child), goal_served(Child2), done_served(Child2), !.
delta(79, make_sandwich(_, _, _), -0.135772970381831) :- todo_served(Child), allergic_gluten(Child), !.
delta(79, make_sandwich(_, _, _), 0.0124704486112481) :- !.
delta(79, _, -0.03539833456204304) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), todo_served(Child), not_allergic_gluten(Child), !.
delta(79, _, 0.00024352212362330612) :- fewer_ontray_1_than_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(79, move_tray(_, _, _), -0.0010528488167088372) :- fewer_ontray_1_than_allergic_gluten, !.
delta(79, _, 0.0017222370764122482) :- fewer_ontray_1_than_allergic_gluten, !.
delta(79, serve_sandwich_no_gluten(_, _, _, _), 0.0029583679402079674) :- fewer_ontray_2_than_allergic_gluten, !.
delta(79, serve_sandwich_no_gluten(_, _, _, _), -0.018266394840442287) :- !.
delta(79, _, 0.13520002470784534) :- todo_served(Child), allergic_gluten(Child), !.
delta(79, _, -0.010821351050245155).

% tree 80: step size 1.0, 261 examples, 15 leaves
delta(80, move_tray(_, Place, _), 0.0004847848076919386) :- at_kitchen_sandwich(_), todo_served(Child), waiting(Child, Place), at_kitchen_bread(_), !.
delta(80, move_tray(_, Place, _), -0.003552819454353965) :- at_kitchen_sandwich(_), todo_served(Child), waiting(Child, Place), !.
delta(80, move_tray(_, _, Place), -0.0009000684579938733) :- at_kitchen_sandwich(_), at(_, Place), !.
delta(80, move_tray(_, _, _), 0.07088266376341396) :- at_kitchen_sandwich(_), !.
delta(80, move_tray(Tray, _, _), -0.054700067797914975) :- ontray(_, Tray), !.
delta(80, move_tray(_, _, Place), -0.006307289226482149) :- goal_served(Child), waiting(Child, Place), !.
delta(80, move_tray(_, _, _), 0.019670328552263975) :- !.
delta(80, put_on_tray(_, _), 0.026733794549071776) :- at_kitchen_sandwich(_), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(80, _, -0.025717332900515824) :- at_kitchen_sandwich(_), at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(80, _, -0.06869707088286364) :- at_kitchen_sandwich(_), no_gluten_sandwich(_), !.
delta(80, _, 0.0012660630259363366) :- at_kitchen_sandwich(_), !.
delta(80, _, 0.0) :- goal_served(Child), done_served(Child), fewer_no_gluten_sandwich_than_todo_served_allergic_gluten, !.
delta(80, _, 0.046768910825142486) :- goal_served(Child), done_served(Child), !.
delta(80, make_sandwich(_, _, _), -0.010123728506124242) :- !.
delta(80, _, 0.003566377225047758).

% tree 81: step size 1.0, 238 examples, 13 leaves
delta(81, put_on_tray(_, Tray), -0.06763862635662615) :- fewer_ontray_1_than_todo_served_allergic_gluten, ontray(_, Tray), !.
delta(81, put_on_tray(_, _), 0.06472766941822418) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(81, put_on_tray(_, Tray), 0.07793749661666466) :- ontray(_, Tray), !.
delta(81, put_on_tray(Sandwich, _), 0.0044182753864611575) :- no_gluten_sandwich(Sandwich), !.
delta(81, put_on_tray(_, _), -0.013863164672082061) :- !.
delta(81, _, 0.006809611225082296) :- at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(81, _, -0.003850377791875897) :- at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(81, serve_sandwich(_, _, _, _), 0.0031376328313441433) :- at_kitchen_sandwich(_), !.
delta(81, _, -0.07006430785306633) :- at_kitchen_sandwich(_), !.
delta(81, move_tray(Tray, _, _), 0.10459172359439553) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(81, move_tray(_, _, _), -0.06983089970357198) :- !.
delta(81, _, -0.028294477486885287) :- done_served(Child), not_allergic_gluten(Child), !.
delta(81, _, 0.0026084585758376967).

% tree 82: step size 1.0, 223 examples, 13 leaves
delta(82, move_tray(_, _, Place), -0.031231300474666723) :- at(_, Place), !.
delta(82, move_tray(_, Place, _), 0.019890637528278455) :- at(Tray, Place), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), fewer_at_1_than_allergic_gluten, !.
delta(82, move_tray(_, Place, _), -0.03147999695191358) :- at(Tray, Place), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(82, move_tray(_, _, _), -0.0006623968104291495) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(82, move_tray(_, _, _), 0.17487001788602155) :- !.
delta(82, serve_sandwich(Sandwich, _, _, Place), -0.0025381410593669947) :- no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(82, serve_sandwich(_, _, _, _), 0.020748477259129497) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(82, _, 0.002468477073853962) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), at_kitchen_sandwich(Sandwich2), no_gluten_sandwich(Sandwich2), !.
delta(82, _, -0.16977057244089538) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(82, put_on_tray(_, _), 0.007251580159700632) :- fewer_at_1_than_todo_served, !.
delta(82, put_on_tray(_, _), -0.019939048295009018) :- !.
delta(82, _, -0.004929458691775612) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(82, _, 0.024915699393556808).

% tree 83: step size 1.0, 204 examples, 12 leaves
delta(83, serve_sandwich_no_gluten(Sandwich, _, _, Place), 0.033912173135613816) :- fewer_at_1_than_allergic_gluten, ontray(Sandwich, Tray), could_serve_sandwich(Tray, Place), !.
delta(83, serve_sandwich_no_gluten(_, _, _, _), -0.005879403334798736) :- fewer_at_1_than_allergic_gluten, !.
delta(83, serve_sandwich_no_gluten(_, _, _, _), -0.10405335678289174) :- done_served(Child), allergic_gluten(Child), !.
delta(83, serve_sandwich_no_gluten(_, _, _, _), 0.002305070339797192) :- !.
delta(83, move_tray(_, _, kitchen), 0.013635517925947409) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(83, move_tray(_, _, _), -0.06651388633507427) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(83, _, -0.005290227154323927) :- goal_served(Child), not_allergic_gluten(Child), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(83, _, 0.04552888960493768) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(83, _, 0.0) :- goal_served(Child), done_served(Child), at_kitchen_sandwich(_), !.
delta(83, _, 0.09642955248656779) :- goal_served(Child), done_served(Child), !.
delta(83, make_sandwich_no_gluten(_, _, _), 0.0007976605214330861) :- !.
delta(83, _, -0.0012157688420096902).

% tree 84: step size 1.0, 202 examples, 10 leaves
delta(84, serve_sandwich(_, Child, _, _), 0.07459737912181168) :- todo_served(Child), !.
delta(84, serve_sandwich(_, _, _, _), -0.031445705913510334) :- !.
delta(84, move_tray(_, _, _), -0.0031190793752283587) :- done_served(Child), allergic_gluten(Child), fewer_ontray_2_than_allergic_gluten, !.
delta(84, _, 0.003804356059479693) :- done_served(Child), allergic_gluten(Child), fewer_ontray_2_than_allergic_gluten, !.
delta(84, _, -0.046123215035172666) :- done_served(Child), allergic_gluten(Child), waiting(Child, Place), at(_, Place), !.
delta(84, _, 5.322138481000227e-5) :- done_served(Child), allergic_gluten(Child), !.
delta(84, make_sandwich(_, _, _), 0.012898295395835622) :- fewer_at_1_than_not_allergic_gluten, !.
delta(84, _, -0.006449317606143668) :- fewer_at_1_than_not_allergic_gluten, !.
delta(84, make_sandwich(_, _, _), -0.011687506687133094) :- !.
delta(84, _, 0.0072066299866151646).

% tree 85: step size 1.0, 227 examples, 11 leaves
delta(85, serve_sandwich_no_gluten(_, Child, _, _), 0.04486823010197426) :- goal_served(Child2), done_served(Child2), todo_served(Child), !.
delta(85, serve_sandwich_no_gluten(_, _, _, _), -0.03292813300241034) :- goal_served(Child), done_served(Child), !.
delta(85, serve_sandwich_no_gluten(_, _, _, _), -0.13248254347382812) :- fewer_ontray_2_than_allergic_gluten, !.
delta(85, serve_sandwich_no_gluten(_, _, _, _), 0.006741097434252965) :- !.
delta(85, put_on_tray(_, Tray), -0.06758346536504065) :- fewer_ontray_1_than_todo_served_allergic_gluten, ontray(_, Tray), !.
delta(85, put_on_tray(_, _), 0.0025685787088407766) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(85, put_on_tray(_, _), 0.025473943029923115) :- !.
delta(85, serve_sandwich(_, _, _, _), 0.029396842081583618) :- goal_served(Child), done_served(Child), !.
delta(85, _, -0.04467406985335779) :- goal_served(Child), done_served(Child), !.
delta(85, _, 0.13866132580293958) :- fewer_ontray_2_than_allergic_gluten, !.
delta(85, _, -0.01253543474941321).

% tree 86: step size 1.0, 210 examples, 13 leaves
delta(86, put_on_tray(Sandwich, _), 0.003979038906362178) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), !.
delta(86, put_on_tray(Sandwich, _), -0.005175613947731719) :- no_gluten_sandwich(Sandwich), fewer_at_1_than_allergic_gluten, !.
delta(86, put_on_tray(Sandwich, _), 0.013584118369009737) :- no_gluten_sandwich(Sandwich), !.
delta(86, put_on_tray(_, Tray), 0.00748507059906227) :- todo_served(Child), allergic_gluten(Child), waiting(Child, Place), could_serve_sandwich(Tray, Place), !.
delta(86, put_on_tray(_, _), -0.10154140304289415) :- todo_served(Child), allergic_gluten(Child), !.
delta(86, put_on_tray(_, Tray), 0.004928729446685462) :- ontray(_, Tray), !.
delta(86, put_on_tray(_, _), -0.004758189316297768) :- !.
delta(86, serve_sandwich_no_gluten(_, Child, _, _), 0.025630377744401016) :- todo_served(Child), !.
delta(86, serve_sandwich_no_gluten(_, _, _, _), -0.05481579195920382) :- !.
delta(86, _, -0.004893715371608214) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, Tray), at(Tray, Place), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(86, _, 0.09983100790456519) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(86, move_tray(_, _, _), 0.03671280912839737) :- !.
delta(86, _, -0.030447571486653714).

% tree 87: step size 1.0, 240 examples, 14 leaves
delta(87, serve_sandwich(_, Child, _, _), 0.03361265813777387) :- notexist(_), todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(87, serve_sandwich(_, Child, _, _), -0.0009458051776608313) :- notexist(_), todo_served(Child), !.
delta(87, serve_sandwich(_, _, _, _), -0.00475749939357164) :- notexist(_), !.
delta(87, serve_sandwich(_, Child, _, _), 0.0016367729027889106) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, todo_served(Child), !.
delta(87, serve_sandwich(_, _, _, _), -0.001721008702520705) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(87, serve_sandwich(_, _, _, _), -0.01290978210949443) :- !.
delta(87, move_tray(_, Place, Place2), -0.021414399783804466) :- goal_served(Child), done_served(Child), at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(87, move_tray(_, _, _), 0.024506938275823054) :- goal_served(Child), done_served(Child), !.
delta(87, _, -0.03907895949395534) :- goal_served(Child), done_served(Child), notexist(_), !.
delta(87, _, 0.004856214211034964) :- goal_served(Child), done_served(Child), !.
delta(87, put_on_tray(_, _), 0.018800589523975047) :- fewer_ontray_1_than_todo_served, !.
delta(87, put_on_tray(_, _), 3.0857710510999746e-5) :- !.
delta(87, _, -0.018151675842469194) :- at_kitchen_sandwich(_), !.
delta(87, _, 0.01058570411256235).

% tree 88: step size 1.0, 262 examples, 14 leaves
delta(88, put_on_tray(Sandwich, _), 0.02659721889597691) :- fewer_ontray_2_than_allergic_gluten, fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(88, put_on_tray(_, _), -0.025277898688646407) :- fewer_ontray_2_than_allergic_gluten, fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(88, put_on_tray(_, _), 0.1400724463391643) :- fewer_ontray_2_than_allergic_gluten, !.
delta(88, put_on_tray(_, _), 0.004300033354778001) :- at_kitchen_bread(_), !.
delta(88, put_on_tray(_, _), -0.010832192091253573) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(88, put_on_tray(_, _), 0.00045070474972451035) :- !.
delta(88, serve_sandwich_no_gluten(_, _, _, _), 0.007960117149864316) :- at_kitchen_sandwich(_), fewer_ontray_2_than_allergic_gluten, !.
delta(88, _, -0.1472547475876594) :- at_kitchen_sandwich(_), fewer_ontray_2_than_allergic_gluten, !.
delta(88, make_sandwich(_, _, _), -0.005173301878086175) :- at_kitchen_sandwich(_), !.
delta(88, _, 0.010130376606122418) :- at_kitchen_sandwich(_), !.
delta(88, serve_sandwich(_, _, _, _), -0.042601092773532134) :- notexist(_), !.
delta(88, serve_sandwich(_, _, _, _), 0.0028099034836228786) :- !.
delta(88, _, 0.038669188314112805) :- done_served(Child), allergic_gluten(Child), !.
delta(88, _, -0.0007722930716827529).

% tree 89: step size 1.0, 209 examples, 13 leaves
delta(89, move_tray(_, _, Place), -0.018404179885340332) :- at(Tray, Place), ontray(_, Tray), !.
delta(89, move_tray(Tray, Place, Place2), -0.020171430860196758) :- at(Tray2, Place), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray2, Place2), at(Tray, kitchen), !.
delta(89, move_tray(_, Place, Place2), 0.011311599143625332) :- at(Tray, Place), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray, Place2), !.
delta(89, move_tray(_, _, _), 0.12488395601312002) :- goal_served(Child), done_served(Child), !.
delta(89, move_tray(_, _, _), -0.00708940351773223) :- !.
delta(89, _, -0.10373909992918266) :- goal_served(Child), done_served(Child), fewer_at_1_than_todo_served_not_allergic_gluten, waiting(Child, Place), at(_, Place), !.
delta(89, _, 0.001224831706973139) :- goal_served(Child), done_served(Child), fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(89, _, -0.00045632887550861725) :- goal_served(Child), done_served(Child), no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(89, _, 0.0028387106702165263) :- goal_served(Child), done_served(Child), !.
delta(89, make_sandwich(_, _, _), 0.004281849992104156) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(89, make_sandwich(_, _, _), -0.012288735453137481) :- !.
delta(89, serve_sandwich_no_gluten(_, _, _, _), -0.006727583605501795) :- !.
delta(89, _, 0.012233164344536267).

% tree 90: step size 1.0, 215 examples, 12 leaves
delta(90, put_on_tray(_, _), 0.0016438932130767093) :- fewer_ontray_1_than_todo_served, fewer_at_1_than_todo_served_allergic_gluten, !.
delta(90, put_on_tray(_, _), 0.05538380247356099) :- fewer_ontray_1_than_todo_served, !.
delta(90, put_on_tray(_, _), 0.0032935671075540922) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(90, put_on_tray(_, _), -0.004731983627323742) :- !.
delta(90, _, -0.0003469640640903885) :- at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served, done_served(Child), allergic_gluten(Child), !.
delta(90, _, -0.05029449042983254) :- at_kitchen_sandwich(_), fewer_ontray_1_than_todo_served, !.
delta(90, _, 0.004725184115523859) :- at_kitchen_sandwich(_), no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(90, _, -0.0032927868881761782) :- at_kitchen_sandwich(_), !.
delta(90, serve_sandwich_no_gluten(_, _, _, _), -0.009116231048942457) :- done_served(Child), allergic_gluten(Child), !.
delta(90, serve_sandwich_no_gluten(_, _, _, _), 0.002069101478081772) :- !.
delta(90, _, 0.00859673352429263) :- done_served(Child), allergic_gluten(Child), !.
delta(90, _, -0.0011806274704536832).

% tree 91: step size 1.0, 221 examples, 15 leaves
delta(91, put_on_tray(Sandwich, _), -0.13574105642857912) :- no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, no_gluten_sandwich(Sandwich2), ontray(Sandwich2, _), !.
delta(91, put_on_tray(Sandwich, _), 6.279682185326668e-6) :- no_gluten_sandwich(Sandwich), fewer_no_gluten_sandwich_than_todo_served, !.
delta(91, put_on_tray(Sandwich, _), 0.0033677987861013333) :- no_gluten_sandwich(Sandwich), !.
delta(91, put_on_tray(_, _), 0.12852352883703946) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, notexist(_), !.
delta(91, put_on_tray(_, _), -0.0025113025945792526) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(91, put_on_tray(_, _), 0.0003705411954871336) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(91, put_on_tray(_, _), -0.02079106962780982) :- !.
delta(91, move_tray(_, Place, _), 0.08951044196373514) :- done_served(Child), waiting(Child, Place), todo_served(Child2), allergic_gluten(Child2), !.
delta(91, move_tray(_, Place, _), -0.021581177406548104) :- done_served(Child), waiting(Child, Place), !.
delta(91, move_tray(_, _, _), -0.09102733380990148) :- goal_served(Child), done_served(Child), !.
delta(91, move_tray(_, _, _), 0.019348291178614915) :- !.
delta(91, _, 0.036300794834259076) :- no_gluten_sandwich(_), fewer_ontray_2_than_not_allergic_gluten, !.
delta(91, _, -0.0038406862741613207) :- no_gluten_sandwich(_), !.
delta(91, _, -0.014671459423523965) :- at_kitchen_sandwich(_), !.
delta(91, _, 0.010632552234990758).

% tree 92: step size 1.0, 218 examples, 9 leaves
delta(92, put_on_tray(_, _), 0.224557389702422) :- !.
delta(92, _, -0.17276291943555735) :- at_kitchen_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, at_kitchen_bread(_), !.
delta(92, _, -0.00018759001048430934) :- at_kitchen_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(92, make_sandwich(_, _, _), 0.013018479080238305) :- at_kitchen_sandwich(_), !.
delta(92, _, -0.021128614588612794) :- at_kitchen_sandwich(_), !.
delta(92, serve_sandwich_no_gluten(_, _, _, _), -0.027297474279501622) :- notexist(_), !.
delta(92, serve_sandwich_no_gluten(_, _, _, _), 0.008855834496301842) :- !.
delta(92, _, -0.006345662240120875) :- fewer_ontray_2_than_allergic_gluten, !.
delta(92, _, 0.024768178087497605).

% tree 93: step size 1.0, 243 examples, 13 leaves
delta(93, put_on_tray(Sandwich, Tray), -0.01276957757095825) :- ontray(_, Tray), no_gluten_sandwich(Sandwich), at_kitchen_bread(_), !.
delta(93, put_on_tray(Sandwich, Tray), 0.0010577433123722568) :- ontray(_, Tray), no_gluten_sandwich(Sandwich), !.
delta(93, put_on_tray(_, Tray), 0.20671664260409853) :- ontray(_, Tray), !.
delta(93, put_on_tray(_, _), -0.09033071360077058) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(93, put_on_tray(_, _), 0.045979612054072305) :- no_gluten_sandwich(_), !.
delta(93, put_on_tray(_, _), -3.035676905717135e-5) :- !.
delta(93, serve_sandwich_no_gluten(_, _, _, _), 0.006632780135187842) :- at_kitchen_sandwich(_), !.
delta(93, make_sandwich_no_gluten(_, _, _), 0.0003348013792224876) :- at_kitchen_sandwich(_), !.
delta(93, _, -0.13560081464526064) :- at_kitchen_sandwich(_), !.
delta(93, serve_sandwich(Sandwich, _, _, Place), -0.014191788264914426) :- ontray(Sandwich, Tray), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(93, serve_sandwich(_, _, _, _), 0.03640638538755092) :- !.
delta(93, _, -0.033924863326279045) :- goal_served(Child), done_served(Child), !.
delta(93, _, 0.005847226787846634).

% tree 94: step size 1.0, 245 examples, 11 leaves
delta(94, serve_sandwich(Sandwich, _, _, _), -0.05702370551203715) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(94, serve_sandwich(Sandwich, _, _, _), 0.004537428320164992) :- no_gluten_sandwich(Sandwich), !.
delta(94, serve_sandwich(_, Child, _, _), 0.11011716700238393) :- todo_served(Child), !.
delta(94, serve_sandwich(_, _, _, _), -0.013509937920509946) :- !.
delta(94, make_sandwich(_, _, _), -3.260357587201978e-5) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(94, make_sandwich(_, _, _), -0.001573590156864791) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(94, _, 0.0010785550695706142) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(94, put_on_tray(_, _), 0.019096040364247953) :- notexist(_), !.
delta(94, put_on_tray(_, _), -0.010773330119820183) :- !.
delta(94, _, -0.0587080237872719) :- notexist(_), !.
delta(94, _, 0.004278457260088159).

% tree 95: step size 1.0, 251 examples, 9 leaves
delta(95, make_sandwich(_, _, _), -0.002841051396647639) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(95, make_sandwich(_, _, _), 0.0) :- todo_served(Child), not_allergic_gluten(Child), done_served(Child2), allergic_gluten(Child2), !.
delta(95, make_sandwich(_, _, _), 0.04828137138915688) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(95, make_sandwich(_, _, _), -0.0007143298452649816) :- !.
delta(95, serve_sandwich_no_gluten(_, _, _, _), 0.009838975797564202) :- !.
delta(95, move_tray(_, _, _), -0.00011567636208207595) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(95, _, 0.0021548921432540903) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(95, _, -0.055611822798631624) :- fewer_ontray_1_than_todo_served, !.
delta(95, _, -0.002033346084498202).

% tree 96: step size 1.0, 201 examples, 15 leaves
delta(96, move_tray(_, _, Place), -0.00047262782972456584) :- at(Tray, Place), ontray(_, Tray), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(96, move_tray(_, Place, Place2), -2.7532836110224055e-5) :- at(Tray, Place2), ontray(_, Tray), at(Tray2, Place), could_serve_sandwich(Tray2, Place), !.
delta(96, move_tray(_, _, Place), 0.038732375083351624) :- at(Tray, Place), ontray(_, Tray), !.
delta(96, move_tray(_, Place, _), 0.0017492564949390624) :- fewer_at_2_than_todo_served, at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(96, move_tray(_, _, _), -0.03699383561634933) :- fewer_at_2_than_todo_served, !.
delta(96, move_tray(_, _, kitchen), -0.0034500983226996174) :- !.
delta(96, move_tray(_, _, _), 0.029566392722898075) :- !.
delta(96, make_sandwich(_, _, _), -0.0021002341317025363) :- fewer_at_2_than_todo_served, fewer_ontray_1_than_todo_served, !.
delta(96, _, 0.01487620600815701) :- fewer_at_2_than_todo_served, fewer_ontray_1_than_todo_served, !.
delta(96, _, 0.0029420609988222495) :- fewer_at_2_than_todo_served, fewer_ontray_2_than_allergic_gluten, !.
delta(96, _, -0.011979184039439287) :- fewer_at_2_than_todo_served, !.
delta(96, serve_sandwich_no_gluten(_, Child, _, _), 0.04028306968282488) :- todo_served(Child), !.
delta(96, serve_sandwich_no_gluten(_, _, _, _), -0.03773364784082926) :- !.
delta(96, make_sandwich_no_gluten(_, _, _), 0.00057698450426863) :- !.
delta(96, _, -0.03493261296013775).

% tree 97: step size 1.0, 206 examples, 12 leaves
delta(97, make_sandwich(_, _, Content_portion), -0.08322903144515247) :- no_gluten_content(Content_portion), !.
delta(97, make_sandwich(_, _, _), -0.011205416463137751) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_1_than_not_allergic_gluten, !.
delta(97, make_sandwich(_, _, _), 0.01030571324475286) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(97, make_sandwich(_, _, _), 0.0) :- done_served(Child), allergic_gluten(Child), !.
delta(97, make_sandwich(_, _, _), 0.12794621596729475) :- !.
delta(97, serve_sandwich(Sandwich, Child, _, _), -0.014389005582739603) :- todo_served(Child), no_gluten_sandwich(Sandwich), !.
delta(97, serve_sandwich(_, Child, _, _), 0.04678732272080684) :- todo_served(Child), !.
delta(97, serve_sandwich(_, _, _, _), -0.019757800082643426) :- !.
delta(97, _, -0.0727838142628909) :- no_gluten_sandwich(_), fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(97, _, 0.006142489379742188) :- no_gluten_sandwich(_), !.
delta(97, _, 0.0016635890951343607) :- fewer_ontray_1_than_todo_served, !.
delta(97, _, -0.0022976853520902366).

% tree 98: step size 1.0, 214 examples, 12 leaves
delta(98, serve_sandwich(Sandwich, _, _, _), -0.2409641214656344) :- no_gluten_sandwich(Sandwich), !.
delta(98, serve_sandwich(_, Child, _, _), -0.0045351341647576005) :- todo_served(Child), at_kitchen_bread(_), !.
delta(98, serve_sandwich(_, Child, _, _), 0.09860355735568044) :- todo_served(Child), !.
delta(98, serve_sandwich(_, _, _, _), -0.07379265407057808) :- !.
delta(98, move_tray(_, Place, _), 0.029493234760234594) :- fewer_at_2_than_todo_served_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(98, move_tray(_, _, _), -0.01333985048998013) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(98, make_sandwich(_, _, _), 0.0029001755917223287) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(98, _, -0.014654723860901808) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(98, _, 0.2177061028452646) :- no_gluten_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(98, _, -6.0380041006151946e-5) :- no_gluten_sandwich(_), !.
delta(98, move_tray(_, _, _), -0.010567213256461306) :- !.
delta(98, _, 0.005360243690875106).

% tree 99: step size 1.0, 212 examples, 10 leaves
delta(99, serve_sandwich_no_gluten(_, _, _, _), -0.007030074703632113) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(99, serve_sandwich_no_gluten(_, _, _, _), 0.02933746327254628) :- !.
delta(99, put_on_tray(Sandwich, _), 0.055357937650743066) :- no_gluten_sandwich(Sandwich), fewer_ontray_1_than_allergic_gluten, !.
delta(99, put_on_tray(Sandwich, _), -0.09826242593958802) :- no_gluten_sandwich(Sandwich), !.
delta(99, put_on_tray(_, _), -0.04199442864127543) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(99, put_on_tray(_, _), 0.09963072940523748) :- !.
delta(99, serve_sandwich(_, _, _, _), 0.004033050825262794) :- no_gluten_sandwich(_), !.
delta(99, _, -0.03282373498018984) :- no_gluten_sandwich(_), !.
delta(99, make_sandwich_no_gluten(_, _, _), 0.0003497826435424665) :- !.
delta(99, _, -0.0007692579408657843).

% tree 100: step size 1.0, 229 examples, 15 leaves
delta(100, move_tray(_, _, Place), -0.014824176689705128) :- todo_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place), todo_served(Child3), allergic_gluten(Child3), !.
delta(100, move_tray(_, _, Place), 0.009704251091200156) :- todo_served(Child), waiting(Child, Place), done_served(Child2), waiting(Child2, Place), !.
delta(100, move_tray(_, _, Place), 0.3020627600864085) :- todo_served(Child), waiting(Child, Place), no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(100, move_tray(_, _, Place), 0.00944692344493194) :- todo_served(Child), waiting(Child, Place), !.
delta(100, move_tray(_, Place, Place2), 0.0007228403193898816) :- at_kitchen_bread(_), at(Tray, Place), could_put_on_tray(Tray, Place2), !.
delta(100, move_tray(_, _, _), -0.00032914641033351944) :- at_kitchen_bread(_), !.
delta(100, move_tray(_, _, _), -0.028877498766238373) :- !.
delta(100, serve_sandwich(_, Child, _, _), 0.020521551742667808) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(100, serve_sandwich(_, _, _, _), -0.02125056806589617) :- done_served(Child), not_allergic_gluten(Child), !.
delta(100, serve_sandwich(_, _, _, Place), 0.0007546013232569088) :- done_served(Child), waiting(Child, Place), !.
delta(100, serve_sandwich(_, _, _, _), -0.2859221982614489) :- !.
delta(100, make_sandwich(_, _, _), 0.007165919666612647) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(100, _, -0.021287439918728723) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(100, put_on_tray(_, _), 0.017953576238517233) :- !.
delta(100, _, -0.007399962437013789).

% tree 101: step size 1.0, 225 examples, 13 leaves
delta(101, move_tray(_, Place, Place2), 0.002582205103597344) :- goal_served(Child), waiting(Child, Place2), at(Tray, Place2), could_serve_sandwich(Tray, Place), !.
delta(101, move_tray(_, _, Place), -0.05382606943144036) :- goal_served(Child), waiting(Child, Place), fewer_no_gluten_sandwich_than_todo_served, !.
delta(101, move_tray(_, _, Place), 0.0011123256698064555) :- goal_served(Child), waiting(Child, Place), !.
delta(101, move_tray(_, _, _), -0.010644049809134314) :- fewer_ontray_2_than_allergic_gluten, !.
delta(101, move_tray(_, Place, _), -0.004660627253492777) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(101, move_tray(_, _, _), 0.03223064482529084) :- !.
delta(101, make_sandwich(_, _, _), -0.007276499133706711) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_at_2_than_allergic_gluten, !.
delta(101, make_sandwich(_, _, _), 0.010253179833617693) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(101, make_sandwich(_, _, _), -0.029302183407353615) :- goal_served(Child), allergic_gluten(Child), !.
delta(101, make_sandwich(_, _, _), 0.00040739620951975704) :- !.
delta(101, make_sandwich_no_gluten(_, _, _), 0.0013027301235416242) :- !.
delta(101, _, 0.04695766438132939) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(101, _, 0.0029966292207414882).

% tree 102: step size 1.0, 208 examples, 8 leaves
delta(102, serve_sandwich(Sandwich, Child, _, Place), -0.0008590123166875653) :- todo_served(Child), ontray(Sandwich, Tray), could_serve_sandwich_no_gluten(Tray, Place), !.
delta(102, serve_sandwich(_, Child, _, _), 0.05210797755801951) :- todo_served(Child), !.
delta(102, serve_sandwich(_, _, _, _), -0.007033605263633928) :- !.
delta(102, put_on_tray(_, _), -0.0016006683676160931) :- fewer_no_gluten_sandwich_than_allergic_gluten, !.
delta(102, put_on_tray(_, _), 0.02780666908876118) :- !.
delta(102, make_sandwich_no_gluten(_, _, _), 0.002421175859171968) :- !.
delta(102, make_sandwich(_, _, _), -0.006242485722196092) :- !.
delta(102, _, -0.07007016506228271).

% tree 103: step size 1.0, 223 examples, 12 leaves
delta(103, make_sandwich(_, _, _), -0.009937254281748374) :- fewer_at_1_than_not_allergic_gluten, fewer_ontray_1_than_allergic_gluten, !.
delta(103, make_sandwich(_, _, _), 0.00016345704643885018) :- fewer_at_1_than_not_allergic_gluten, !.
delta(103, make_sandwich(_, _, _), -0.0002696734671261014) :- todo_served(Child), not_allergic_gluten(Child), at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(103, make_sandwich(_, _, _), 0.031203431004967447) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(103, make_sandwich(_, _, _), -0.0008133539417451585) :- !.
delta(103, serve_sandwich_no_gluten(_, Child, _, _), 0.017932794786602757) :- fewer_at_1_than_not_allergic_gluten, todo_served(Child), !.
delta(103, serve_sandwich_no_gluten(_, _, _, _), -0.023934746878588355) :- fewer_at_1_than_not_allergic_gluten, !.
delta(103, _, 0.01399601540310941) :- fewer_at_1_than_not_allergic_gluten, no_gluten_sandwich(_), !.
delta(103, _, -2.3161972097275635e-5) :- fewer_at_1_than_not_allergic_gluten, !.
delta(103, serve_sandwich_no_gluten(_, _, _, _), 0.0038718530429018324) :- !.
delta(103, make_sandwich_no_gluten(_, _, _), 0.0009383672600976812) :- !.
delta(103, _, -0.03395525518639575).

% tree 104: step size 1.0, 225 examples, 13 leaves
delta(104, make_sandwich(_, _, _), -0.0002798932519956503) :- fewer_at_1_than_allergic_gluten, at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(104, make_sandwich(_, _, _), 0.07007416091057277) :- fewer_at_1_than_allergic_gluten, !.
delta(104, make_sandwich(_, _, _), -0.021874680053915026) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(104, make_sandwich(_, _, _), 0.007782786475777721) :- fewer_ontray_1_than_todo_served, !.
delta(104, make_sandwich(_, _, _), -0.00011043186664908134) :- !.
delta(104, put_on_tray(_, _), -0.082369629683651) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(104, _, 0.007861392291799415) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(104, move_tray(_, _, _), -0.007702669816957642) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(104, _, 0.00541586453420164) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(104, move_tray(_, _, Place), -0.03776675077160219) :- goal_served(Child), waiting(Child, Place), !.
delta(104, move_tray(_, _, _), 0.03254181282531574) :- !.
delta(104, _, -0.015205581792252126) :- fewer_at_1_than_allergic_gluten, !.
delta(104, _, 0.02941312417936868).

% tree 105: step size 1.0, 210 examples, 15 leaves
delta(105, move_tray(Tray, _, Place), -0.007522434592313723) :- at(Tray, kitchen), allergic_gluten(Child), waiting(Child, Place), fewer_ontray_1_than_todo_served, !.
delta(105, move_tray(Tray, _, Place), 0.012109248678559954) :- at(Tray, kitchen), allergic_gluten(Child), waiting(Child, Place), !.
delta(105, move_tray(Tray, _, _), -0.012686890550101176) :- at(Tray, kitchen), goal_served(Child), allergic_gluten(Child), !.
delta(105, move_tray(Tray, _, _), 0.00024921338015288766) :- at(Tray, kitchen), !.
delta(105, move_tray(_, _, Place), -0.0010008834949111096) :- goal_served(Child), allergic_gluten(Child), at(Tray, Place), could_put_on_tray(Tray, Place), !.
delta(105, move_tray(_, _, _), 0.09560454387863462) :- goal_served(Child), allergic_gluten(Child), !.
delta(105, move_tray(_, Place, Place2), 0.0004829544622358933) :- at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(105, move_tray(_, _, _), -0.004478257463336639) :- !.
delta(105, make_sandwich(_, _, _), -0.014581643735461907) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(105, make_sandwich(_, _, _), -0.004424364523863946) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(105, make_sandwich(_, _, _), 0.04979794957680902) :- !.
delta(105, _, 0.009319744592255251) :- fewer_ontray_1_than_todo_served_allergic_gluten, fewer_at_1_than_allergic_gluten, !.
delta(105, _, -0.004365277535951232) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(105, _, -0.11296967785987491) :- goal_served(Child), allergic_gluten(Child), !.
delta(105, _, 0.0002730007736600006).

% tree 106: step size 1.0, 268 examples, 12 leaves
delta(106, serve_sandwich_no_gluten(_, _, _, _), 0.0054835654583896346) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(106, serve_sandwich_no_gluten(_, _, _, _), 0.0021300068604305626) :- fewer_ontray_2_than_todo_served, fewer_no_gluten_sandwich_than_todo_served, !.
delta(106, serve_sandwich_no_gluten(_, _, _, _), -0.12311095801550545) :- fewer_ontray_2_than_todo_served, !.
delta(106, serve_sandwich_no_gluten(_, _, _, _), 0.012132690688951092) :- !.
delta(106, serve_sandwich(_, Child, _, _), 0.019871532521625164) :- fewer_ontray_2_than_not_allergic_gluten, todo_served(Child), !.
delta(106, serve_sandwich(_, _, _, _), -0.004281171303464969) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(106, make_sandwich(_, _, _), 0.00553535762099963) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(106, _, -0.01918468340532245) :- fewer_ontray_2_than_not_allergic_gluten, !.
delta(106, _, -0.0007467469587166573) :- fewer_ontray_2_than_todo_served, fewer_no_gluten_sandwich_than_todo_served, !.
delta(106, _, 0.12195379852989588) :- fewer_ontray_2_than_todo_served, !.
delta(106, serve_sandwich(_, _, _, _), 6.260871740887746e-5) :- !.
delta(106, _, -0.012111616594393457).

% tree 107: step size 1.0, 207 examples, 11 leaves
delta(107, serve_sandwich_no_gluten(_, _, _, _), 0.0024577972945905692) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(107, serve_sandwich_no_gluten(_, _, _, _), -0.04647373113200463) :- fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(107, serve_sandwich_no_gluten(_, _, _, _), 0.0023084722879025714) :- !.
delta(107, move_tray(Tray, Place, _), 0.020689517901950973) :- at(Tray, Place2), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray, Place2), done_served(Child), waiting(Child, Place), !.
delta(107, move_tray(Tray, _, _), -0.0017051740547762342) :- at(Tray, Place), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(107, move_tray(_, _, _), -0.03348799845430042) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(107, move_tray(_, _, _), 0.0010364587390850131) :- !.
delta(107, make_sandwich(_, _, _), -0.017204204223853003) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(107, _, 0.01201006970949051) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(107, _, 0.05292347949980783) :- todo_served(Child), not_allergic_gluten(Child), !.
delta(107, _, -0.001680314291588627).

% tree 108: step size 1.0, 222 examples, 14 leaves
delta(108, make_sandwich(_, _, _), 0.08028631843709541) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), fewer_at_1_than_not_allergic_gluten, !.
delta(108, make_sandwich(_, _, _), -6.543782821428153e-5) :- at_kitchen_sandwich(Sandwich), no_gluten_sandwich(Sandwich), !.
delta(108, make_sandwich(_, _, _), 0.0023859144826868066) :- fewer_at_1_than_allergic_gluten, fewer_no_gluten_sandwich_than_todo_served, !.
delta(108, make_sandwich(_, _, _), -0.0001268329005962292) :- fewer_at_1_than_allergic_gluten, !.
delta(108, make_sandwich(_, _, _), -0.013183067206302178) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(108, make_sandwich(_, _, _), 0.0009957522084238983) :- !.
delta(108, serve_sandwich(Sandwich, _, _, _), -0.08008571451838455) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(108, serve_sandwich(Sandwich, _, _, _), 0.0008648853565856347) :- no_gluten_sandwich(Sandwich), !.
delta(108, serve_sandwich(_, Child, _, _), 0.11283760961065402) :- todo_served(Child), !.
delta(108, serve_sandwich(_, _, _, _), -0.013273150095417097) :- !.
delta(108, move_tray(_, _, _), 0.007106729464036273) :- at_kitchen_sandwich(_), !.
delta(108, _, -0.09840081528475399) :- at_kitchen_sandwich(_), !.
delta(108, _, 0.0016199575867925189) :- todo_served(Child), allergic_gluten(Child), !.
delta(108, _, -0.0058665301415857405).

% tree 109: step size 1.0, 215 examples, 12 leaves
delta(109, move_tray(_, _, Place), 0.01268863245809843) :- at(Tray, Place), ontray(_, Tray), at_kitchen_bread(_), !.
delta(109, move_tray(_, _, Place), -0.002642418311237515) :- at(Tray, Place), ontray(_, Tray), !.
delta(109, move_tray(_, Place, Place2), 0.0032255044630261475) :- done_served(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place2), !.
delta(109, move_tray(_, _, Place), -0.0009094949132794188) :- done_served(Child), waiting(Child, Place), !.
delta(109, move_tray(_, _, _), -0.03460741328532295) :- !.
delta(109, put_on_tray(Sandwich, _), 0.013830952150537494) :- fewer_ontray_1_than_todo_served_allergic_gluten, no_gluten_sandwich(Sandwich), !.
delta(109, put_on_tray(_, _), -0.017036207585710096) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(109, _, 0.0035921582599648043) :- fewer_ontray_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(109, _, 0.00010359908909739143) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(109, make_sandwich(_, _, _), 0.0013981561280378043) :- fewer_ontray_1_than_todo_served, !.
delta(109, make_sandwich(_, _, _), -0.0018313825431912508) :- !.
delta(109, _, 0.022363711926557322).

% tree 110: step size 1.0, 243 examples, 12 leaves
delta(110, put_on_tray(_, _), 0.03576372534398431) :- fewer_at_1_than_allergic_gluten, !.
delta(110, put_on_tray(_, Tray), 0.00014252230261721792) :- at_kitchen_bread(_), ontray(_, Tray), !.
delta(110, put_on_tray(_, _), -0.014442166317084795) :- at_kitchen_bread(_), !.
delta(110, put_on_tray(_, _), 0.004812366898081281) :- !.
delta(110, _, 0.0) :- fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(_), done_served(Child), not_allergic_gluten(Child), !.
delta(110, _, -0.035752100245605406) :- fewer_at_1_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(110, serve_sandwich(_, _, _, _), -0.003950163551017751) :- fewer_at_1_than_allergic_gluten, !.
delta(110, _, 0.003067004688530846) :- fewer_at_1_than_allergic_gluten, !.
delta(110, serve_sandwich(Sandwich, _, _, _), -0.03239677056586441) :- no_gluten_sandwich(Sandwich), !.
delta(110, serve_sandwich(_, _, _, _), 0.01285999523189459) :- !.
delta(110, _, 0.033835453899647025) :- fewer_ontray_1_than_todo_served_not_allergic_gluten, !.
delta(110, _, -0.012283525115341108).

% tree 111: step size 1.0, 202 examples, 15 leaves
delta(111, move_tray(Tray, Place, Place2), 0.0017228156073581804) :- goal_served(Child), done_served(Child), waiting(Child, Place3), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray, Place3), at(Tray2, Place), could_serve_sandwich_no_gluten(Tray2, Place2), !.
delta(111, move_tray(Tray, _, _), -0.005037113189608032) :- goal_served(Child), done_served(Child), waiting(Child, Place), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(111, move_tray(_, _, _), 0.09576465160329176) :- goal_served(Child), done_served(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(111, move_tray(_, _, _), -0.001631250081977506) :- goal_served(Child), done_served(Child), !.
delta(111, move_tray(Tray, _, Place), -0.0007016793394913353) :- could_serve_sandwich_no_gluten(Tray, Place), fewer_ontray_2_than_allergic_gluten, !.
delta(111, move_tray(Tray, _, Place), 0.033794229358311285) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(111, move_tray(_, _, _), -0.03641425855766565) :- no_gluten_bread(_), !.
delta(111, move_tray(_, _, _), -4.056047884829368e-5) :- !.
delta(111, _, -0.0839025441642323) :- goal_served(Child), done_served(Child), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(111, make_sandwich(_, _, _), -1.6242136428877027e-5) :- goal_served(Child), done_served(Child), !.
delta(111, _, 0.0029189418663928567) :- goal_served(Child), done_served(Child), !.
delta(111, make_sandwich(_, _, _), -0.018385702538644022) :- fewer_at_2_than_allergic_gluten, !.
delta(111, make_sandwich(_, _, _), 0.01476438015932789) :- !.
delta(111, _, 0.014953533773412289) :- fewer_at_2_than_allergic_gluten, !.
delta(111, _, -0.011086666195595427).

% tree 112: step size 1.0, 265 examples, 16 leaves
delta(112, move_tray(_, Place, Place2), 0.0063730876825121435) :- goal_served(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray, Place), done_served(Child2), waiting(Child2, Place), !.
delta(112, move_tray(_, Place, Place2), -0.0019178388429884883) :- goal_served(Child), waiting(Child, Place2), at(Tray, Place), could_serve_sandwich_no_gluten_through_waiting_back_for_todo_served_1_place(Tray, Place), !.
delta(112, move_tray(_, _, Place), 0.0016168007077799207) :- goal_served(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(112, move_tray(_, _, Place), -0.05175221799375983) :- goal_served(Child), waiting(Child, Place), !.
delta(112, move_tray(_, _, _), 0.0007854885662189677) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(112, move_tray(_, _, _), -0.013334906356254927) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(112, move_tray(_, Place, _), 0.02684012392157375) :- at(Tray, Place), ontray(_, Tray), !.
delta(112, move_tray(_, _, _), -0.0021354826926049644) :- !.
delta(112, make_sandwich(_, _, _), 0.016434425346006733) :- at_kitchen_bread(_), fewer_ontray_1_than_todo_served, !.
delta(112, _, -0.00908410887803294) :- at_kitchen_bread(_), fewer_ontray_1_than_todo_served, !.
delta(112, make_sandwich(_, _, _), -0.016110160541362096) :- at_kitchen_bread(_), !.
delta(112, _, 0.00022160113797980435) :- at_kitchen_bread(_), !.
delta(112, _, -0.0019588220186592953) :- fewer_at_2_than_todo_served_allergic_gluten, fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(112, _, 0.0003023092687328208) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(112, _, 2.1653019215898804e-6) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(112, _, 0.04532140058321454).

% tree 113: step size 1.0, 247 examples, 14 leaves
delta(113, put_on_tray(_, Tray), -0.07913124318663685) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_not_allergic_gluten, !.
delta(113, put_on_tray(_, Tray), 0.016043429335059728) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_ontray_1_than_todo_served, !.
delta(113, put_on_tray(_, Tray), -0.00417440557238102) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(113, put_on_tray(_, _), 0.10328511525787203) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(113, put_on_tray(_, _), -0.0002273751588987774) :- todo_served(Child), allergic_gluten(Child), !.
delta(113, put_on_tray(_, _), 3.4528529504870904e-5) :- !.
delta(113, move_tray(Tray, _, Place), -0.30291328474685053) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), at(_, Place), !.
delta(113, move_tray(Tray, _, _), 0.004611785051091846) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(113, move_tray(_, _, _), -0.015212511061106462) :- fewer_ontray_1_than_todo_served, !.
delta(113, move_tray(_, _, _), 0.32380494501485224) :- !.
delta(113, _, -0.06494176641539189) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_ontray_2_than_todo_served_not_allergic_gluten, !.
delta(113, _, 0.0033932605734962535) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(113, serve_sandwich(_, _, _, _), -0.00383703224102265) :- !.
delta(113, _, 0.005925032068581936).

% tree 114: step size 1.0, 201 examples, 14 leaves
delta(114, put_on_tray(_, Tray), 0.017945161790429234) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(Sandwich2), no_gluten_sandwich(Sandwich2), !.
delta(114, put_on_tray(_, Tray), -0.00017781274142968404) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_1_than_todo_served_allergic_gluten, !.
delta(114, put_on_tray(_, Tray), -0.003255400342465231) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), fewer_at_2_than_allergic_gluten, !.
delta(114, put_on_tray(_, Tray), 0.001699070228841411) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(114, put_on_tray(_, _), -0.14645601844200185) :- goal_served(Child), allergic_gluten(Child), !.
delta(114, put_on_tray(_, _), 8.819827266298254e-5) :- !.
delta(114, serve_sandwich_no_gluten(_, _, _, _), 0.00038683712019548124) :- at_kitchen_sandwich(_), goal_served(Child), done_served(Child), !.
delta(114, serve_sandwich_no_gluten(_, _, _, _), -0.014984176851636674) :- at_kitchen_sandwich(_), !.
delta(114, _, -0.0015787061127573829) :- at_kitchen_sandwich(_), fewer_at_2_than_todo_served_allergic_gluten, !.
delta(114, _, 0.14443711544142537) :- at_kitchen_sandwich(_), !.
delta(114, move_tray(_, _, Place), -0.025240264546891204) :- allergic_gluten(Child), waiting(Child, Place), !.
delta(114, move_tray(_, _, _), 0.00893973907851857) :- !.
delta(114, _, -0.004944758287703118) :- fewer_ontray_1_than_allergic_gluten, !.
delta(114, _, 0.019575357898196626).

% tree 115: step size 1.0, 221 examples, 16 leaves
delta(115, move_tray(_, Place, _), 0.0) :- goal_served(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, fewer_at_1_than_todo_served_not_allergic_gluten, !.
delta(115, move_tray(_, Place, _), -0.012707867251157601) :- goal_served(Child), waiting(Child, Place), fewer_ontray_1_than_allergic_gluten, !.
delta(115, move_tray(_, Place, Place2), -0.005751392589084879) :- goal_served(Child), waiting(Child, Place), at(Tray, Place2), could_serve_sandwich_through_waiting_back_for_todo_served_1_place(Tray, Place2), !.
delta(115, move_tray(_, Place, _), 0.1520782071150306) :- goal_served(Child), waiting(Child, Place), !.
delta(115, move_tray(_, Place, Place2), -0.02235993541878417) :- fewer_at_2_than_todo_served_allergic_gluten, at(Tray, Place), could_serve_sandwich(Tray, Place2), !.
delta(115, move_tray(_, _, _), 0.026157082289243995) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(115, move_tray(_, _, _), 0.0007299055497130587) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(115, move_tray(_, _, _), -0.061298051501319055) :- !.
delta(115, put_on_tray(_, _), 0.010624504046884996) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(115, _, -0.12884593333392722) :- fewer_at_2_than_allergic_gluten, at_kitchen_sandwich(_), !.
delta(115, _, -0.002021967568919512) :- fewer_at_2_than_allergic_gluten, fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(115, _, 0.005035132330068308) :- fewer_at_2_than_allergic_gluten, !.
delta(115, put_on_tray(_, Tray), -0.06575867866369663) :- ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(115, put_on_tray(_, _), 0.028323332550103223) :- !.
delta(115, _, 0.09062498642980368) :- done_served(Child), allergic_gluten(Child), !.
delta(115, _, -0.01631850724014886).

% tree 116: step size 1.0, 254 examples, 13 leaves
delta(116, serve_sandwich(_, _, _, Place), -0.026963803548140472) :- done_served(Child), waiting(Child, Place), fewer_ontray_2_than_todo_served, !.
delta(116, serve_sandwich(_, Child, _, Place), 0.004055774814513375) :- done_served(Child2), waiting(Child2, Place), todo_served(Child), !.
delta(116, serve_sandwich(_, _, _, Place), -0.0030683129524645292) :- done_served(Child), waiting(Child, Place), !.
delta(116, serve_sandwich(_, _, Tray, _), -0.0012175592729494254) :- todo_served(Child), allergic_gluten(Child), ontray(Sandwich, Tray), no_gluten_sandwich(Sandwich), !.
delta(116, serve_sandwich(_, _, _, _), 0.0) :- todo_served(Child), allergic_gluten(Child), !.
delta(116, serve_sandwich(_, _, _, _), 0.004940877087099136) :- !.
delta(116, put_on_tray(_, _), 0.002115881028930093) :- fewer_at_2_than_allergic_gluten, !.
delta(116, put_on_tray(_, _), 0.0001276117072303191) :- fewer_ontray_1_than_todo_served_allergic_gluten, !.
delta(116, put_on_tray(_, _), -0.016003336320991567) :- !.
delta(116, make_sandwich(_, _, _), -0.004536423130409461) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(116, make_sandwich(_, _, _), 0.001036909223635028) :- !.
delta(116, _, 0.03795369159256723) :- fewer_ontray_2_than_todo_served, !.
delta(116, _, -0.0012489645462979045).

% tree 117: step size 1.0, 255 examples, 11 leaves
delta(117, put_on_tray(Sandwich, _), 0.06161224696339094) :- no_gluten_sandwich(Sandwich), todo_served(Child), allergic_gluten(Child), !.
delta(117, put_on_tray(Sandwich, _), -0.011764301764505682) :- no_gluten_sandwich(Sandwich), !.
delta(117, put_on_tray(_, _), -0.08083068412224774) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(117, put_on_tray(_, _), 0.00891247318547793) :- !.
delta(117, make_sandwich(_, _, _), 0.0015056243958089762) :- goal_served(Child), done_served(Child), !.
delta(117, serve_sandwich_no_gluten(_, _, _, _), 0.0013179447541611998) :- goal_served(Child), done_served(Child), !.
delta(117, _, -0.010349329071202147) :- goal_served(Child), done_served(Child), !.
delta(117, make_sandwich_no_gluten(_, _, _), 0.0008309382024961518) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(117, _, -0.0028176610803421344) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(117, make_sandwich(_, _, _), -0.0005520894009066985) :- !.
delta(117, _, 0.03107967127800949).

% tree 118: step size 1.0, 260 examples, 12 leaves
delta(118, put_on_tray(_, _), -0.157422825328857) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), at_kitchen_bread(_), !.
delta(118, put_on_tray(_, _), 0.006817382740154367) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_no_gluten_sandwich_than_todo_served, !.
delta(118, put_on_tray(_, _), -0.0008955118398970026) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(118, put_on_tray(_, _), 0.019823533060150583) :- !.
delta(118, _, 0.1585596528096313) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), at_kitchen_bread(_), fewer_ontray_2_than_not_allergic_gluten, !.
delta(118, _, -3.633667484724419e-21) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), at_kitchen_bread(_), !.
delta(118, move_tray(_, _, _), -0.0357723535061433) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(118, _, 0.02982286481550088) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(118, make_sandwich_no_gluten(_, _, _), -0.02342559291156793) :- at_kitchen_sandwich(_), !.
delta(118, _, 0.0035643709669866525) :- at_kitchen_sandwich(_), !.
delta(118, serve_sandwich(_, _, _, _), -0.004141090376449704) :- !.
delta(118, _, 0.0028346602426936804).

% tree 119: step size 1.0, 244 examples, 11 leaves
delta(119, put_on_tray(_, _), -0.1541964222824751) :- fewer_at_2_than_todo_served_allergic_gluten, todo_served(Child), not_allergic_gluten(Child), !.
delta(119, put_on_tray(_, _), 0.0003994192088244203) :- fewer_at_2_than_todo_served_allergic_gluten, !.
delta(119, put_on_tray(_, _), 0.0026921357538877456) :- fewer_ontray_1_than_todo_served, !.
delta(119, put_on_tray(_, _), -0.0013514515871216447) :- !.
delta(119, serve_sandwich_no_gluten(_, Child, _, _), 0.026077874893314364) :- todo_served(Child), goal_served(Child2), done_served(Child2), !.
delta(119, serve_sandwich_no_gluten(_, Child, _, _), -0.013915854093622214) :- todo_served(Child), !.
delta(119, serve_sandwich_no_gluten(_, _, _, _), -0.042209789410412264) :- !.
delta(119, _, 0.15328252150318272) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), fewer_at_2_than_todo_served_not_allergic_gluten, !.
delta(119, _, -0.0031739738835141816) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(119, serve_sandwich(_, _, _, _), 0.00684780322373686) :- !.
delta(119, _, -0.006347925833748573).

% tree 120: step size 1.0, 279 examples, 12 leaves
delta(120, serve_sandwich(_, Child, _, _), 0.03744393836308254) :- done_served(Child2), not_allergic_gluten(Child2), todo_served(Child), !.
delta(120, serve_sandwich(_, _, _, _), -0.011261914434241363) :- done_served(Child), not_allergic_gluten(Child), !.
delta(120, serve_sandwich(_, _, _, _), -0.012059950726898033) :- notexist(_), !.
delta(120, serve_sandwich(_, _, _, _), 0.0007257585946323284) :- !.
delta(120, _, 0.0010448890897764697) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served, notexist(_), !.
delta(120, _, -0.0001161583180991502) :- done_served(Child), not_allergic_gluten(Child), fewer_ontray_1_than_todo_served, !.
delta(120, serve_sandwich_no_gluten(_, _, _, _), 0.0001879260298595306) :- done_served(Child), not_allergic_gluten(Child), !.
delta(120, _, -0.0272485331488378) :- done_served(Child), not_allergic_gluten(Child), !.
delta(120, put_on_tray(_, _), 0.011824318981614955) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(120, put_on_tray(_, _), -0.017094184299628525) :- !.
delta(120, _, -0.006461151076657329) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(120, _, 0.01938373558104218).

% tree 121: step size 1.0, 236 examples, 16 leaves
delta(121, put_on_tray(_, Tray), -0.10229295677983688) :- ontray(_, Tray), fewer_at_1_than_allergic_gluten, fewer_ontray_2_than_not_allergic_gluten, !.
delta(121, put_on_tray(_, Tray), 0.001043562483455445) :- ontray(_, Tray), fewer_at_1_than_allergic_gluten, !.
delta(121, put_on_tray(_, Tray), 0.003723194504801781) :- ontray(_, Tray), goal_served(Child), allergic_gluten(Child), !.
delta(121, put_on_tray(_, Tray), -0.0027019262707363933) :- ontray(_, Tray), !.
delta(121, put_on_tray(_, _), -0.013179331625285054) :- at_kitchen_bread(_), no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(121, put_on_tray(_, _), 0.001155509312725142) :- at_kitchen_bread(_), !.
delta(121, put_on_tray(_, _), 0.09348215778020277) :- goal_served(Child), not_allergic_gluten(Child), !.
delta(121, put_on_tray(_, _), -0.00046971907785227563) :- !.
delta(121, serve_sandwich_no_gluten(_, _, _, _), 0.002841790653647426) :- at_kitchen_sandwich(_), fewer_ontray_1_than_not_allergic_gluten, !.
delta(121, serve_sandwich_no_gluten(_, _, _, _), -0.006531213193604071) :- at_kitchen_sandwich(_), !.
delta(121, _, -0.00045925298101263116) :- at_kitchen_sandwich(_), done_served(Child), not_allergic_gluten(Child), !.
delta(121, _, 0.025265470828266613) :- at_kitchen_sandwich(_), !.
delta(121, make_sandwich(_, _, _), -0.0005144237392863926) :- at_kitchen_bread(Bread_portion), no_gluten_bread(Bread_portion), !.
delta(121, make_sandwich(_, _, _), 0.007262149803225097) :- !.
delta(121, make_sandwich_no_gluten(_, _, _), 0.00048788134581854997) :- !.
delta(121, _, -0.005691227314809017).

% tree 122: step size 1.0, 281 examples, 10 leaves
delta(122, serve_sandwich_no_gluten(_, Child, _, _), 0.024790715880893995) :- todo_served(Child), !.
delta(122, serve_sandwich_no_gluten(_, _, _, _), -0.01289808747978632) :- !.
delta(122, put_on_tray(_, Tray), 0.015206683826654887) :- ontray(_, Tray), fewer_ontray_1_than_not_allergic_gluten, !.
delta(122, put_on_tray(_, Tray), -0.09516484269793651) :- ontray(_, Tray), !.
delta(122, put_on_tray(_, _), 0.00020499553003742467) :- at_kitchen_bread(_), !.
delta(122, put_on_tray(_, _), 0.0871283177898418) :- !.
delta(122, serve_sandwich(_, _, _, _), 0.006194673210639258) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(122, _, -0.024542382226143043) :- no_gluten_sandwich(Sandwich), ontray(Sandwich, _), !.
delta(122, serve_sandwich(_, _, _, _), -0.012659188369076771) :- !.
delta(122, _, 0.010256872713115343).

% tree 123: step size 1.0, 273 examples, 15 leaves
delta(123, move_tray(Tray, Place, Place2), -0.007833446208173035) :- could_serve_sandwich_no_gluten(Tray, Place2), at(Tray2, Place), could_put_on_tray(Tray2, Place), at_kitchen_bread(_), !.
delta(123, move_tray(Tray, Place, Place2), 0.025881332358206322) :- could_serve_sandwich_no_gluten(Tray, Place2), at(Tray2, Place), could_put_on_tray(Tray2, Place), !.
delta(123, move_tray(Tray, Place, Place2), 0.006862861928799421) :- could_serve_sandwich_no_gluten(Tray, Place2), todo_served(Child), waiting(Child, Place), !.
delta(123, move_tray(Tray, _, Place), -0.12666466202305937) :- could_serve_sandwich_no_gluten(Tray, Place), !.
delta(123, move_tray(_, _, Place), -0.01772834542297446) :- at(_, Place), fewer_ontray_1_than_not_allergic_gluten, !.
delta(123, move_tray(_, _, Place), 0.007691872239613998) :- at(_, Place), !.
delta(123, move_tray(Tray, _, _), -0.008358265433661619) :- at(Tray, Place), could_serve_sandwich(Tray, Place), !.
delta(123, move_tray(_, _, _), 0.3095071221995355) :- !.
delta(123, put_on_tray(_, _), 0.05934982629764955) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(123, _, -0.06449610221622587) :- fewer_ontray_1_than_not_allergic_gluten, at_kitchen_sandwich(_), !.
delta(123, _, 0.002908019166194838) :- fewer_ontray_1_than_not_allergic_gluten, !.
delta(123, make_sandwich(_, _, _), -0.00816329292116485) :- at_kitchen_bread(_), !.
delta(123, _, 0.012776206978526598) :- at_kitchen_bread(_), !.
delta(123, serve_sandwich(_, _, _, _), 0.0035539061327899903) :- !.
delta(123, _, -0.19731127794938164).

% tree 124: step size 1.0, 227 examples, 10 leaves
delta(124, serve_sandwich_no_gluten(_, Child, _, _), 0.020862258262534933) :- todo_served(Child), !.
delta(124, serve_sandwich_no_gluten(_, _, _, _), -0.009012213036807703) :- !.
delta(124, serve_sandwich(_, Child, _, _), 0.0018632338841355115) :- fewer_ontray_1_than_allergic_gluten, todo_served(Child), !.
delta(124, serve_sandwich(_, _, _, _), -0.004391866678401) :- fewer_ontray_1_than_allergic_gluten, !.
delta(124, make_sandwich(_, _, _), -0.00200144207718551) :- fewer_ontray_1_than_allergic_gluten, !.
delta(124, _, 0.0036873547417485297) :- fewer_ontray_1_than_allergic_gluten, !.
delta(124, serve_sandwich(_, Child, _, _), 0.008698569904989203) :- todo_served(Child), !.
delta(124, serve_sandwich(_, _, _, _), -0.007672496637865197) :- !.
delta(124, _, 0.0036550854888694937) :- done_served(Child), not_allergic_gluten(Child), !.
delta(124, _, -0.015726608155488705).

% tree 125: step size 1.0, 257 examples, 12 leaves
delta(125, serve_sandwich_no_gluten(_, _, _, _), 0.0007170162992045796) :- fewer_at_1_than_todo_served_allergic_gluten, at_kitchen_sandwich(_), !.
delta(125, serve_sandwich_no_gluten(_, _, _, _), -0.09638727273047035) :- fewer_at_1_than_todo_served_allergic_gluten, !.
delta(125, serve_sandwich_no_gluten(_, Child, _, _), 0.013829134930418452) :- todo_served(Child), !.
delta(125, serve_sandwich_no_gluten(_, _, _, _), -0.006185349220412111) :- !.
delta(125, move_tray(_, Place, _), -0.044855187726073255) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, at(Tray, Place), ontray(_, Tray), !.
delta(125, move_tray(_, _, _), 0.016343202272247274) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(125, _, -0.007289646542242595) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, fewer_ontray_1_than_not_allergic_gluten, !.
delta(125, _, 0.029826568527581598) :- fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten, !.
delta(125, put_on_tray(_, _), -0.005336390521626016) :- fewer_at_1_than_allergic_gluten, !.
delta(125, _, 0.10041394389178762) :- fewer_at_1_than_allergic_gluten, !.
delta(125, move_tray(_, _, _), -0.012877680086803643) :- !.
delta(125, _, 0.011432098126061817).
