% SHA-256 of what follows: 2ca93b2463e5c066624585e8508ea2231e9467e12899108335b592c4e44becdd
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
model(domain, 'sokoban.pl').
model(domain_sha256, '653469fdb166faf0bdd389a5f21e319b86a0b1df446135a79852d14e76d0b7f7').
model(action, move(location, location, direction)).
model(action, push(location, location, location, direction, box)).
model(literal, todo_at(box, location)).
model(literal, goal_at(box, location)).
model(literal, done_at(box, location)).
model(literal, at_robot(location)).
model(literal, at(box, location)).
model(literal, clear(location)).
model(literal, adjacent(location, location, direction)).
model(literal, needed_at_robot_to_push(location)).
model(literal, needed_clear_to_push(location)).
model(literal, needed_clear_to_move_to_push(location)).
model(literal, needed_at_to_push_to_push(location)).
model(literal, needed_at_robot_to_push_to_push(location)).
model(literal, nearer_at_robot(location, location, location)).
model(literal, could_push(location)).
model(literal, toward_could_push(location, location)).
model(literal, could_push_todo_at(location)).
model(literal, toward_could_push_todo_at(location, location)).
model(literal, could_push_needed_at_robot_to_push(location)).
model(literal, toward_could_push_needed_at_robot_to_push(location, location)).
model(literal, could_push_needed_clear_to_push(location)).
model(literal, toward_could_push_needed_clear_to_push(location, location)).
model(literal, could_push_needed_at_to_push_to_push(location)).
model(literal, toward_could_push_needed_at_to_push_to_push(location, location)).
model(literal, could_push_for_todo_at_any_location(location)).
model(literal, toward_could_push_for_todo_at_any_location(location, location)).
model(literal, could_push_for_todo_at_any_location_3(location)).
model(literal, toward_could_push_for_todo_at_any_location_3(location, location)).
model(literal, could_push_for_todo_at_box_location(location)).
model(literal, toward_could_push_for_todo_at_box_location(location, location)).
model(literal, wanted_at(box, location)).
model(literal, toward_wanted_at(box, location, location)).
model(literal, could_move(location)).
model(literal, toward_could_move(location, location)).
model(literal, could_move_needed_at_robot_to_push(location)).
model(literal, toward_could_move_needed_at_robot_to_push(location, location)).
model(literal, could_move_needed_at_robot_to_push_to_push(location)).
model(literal, toward_could_move_needed_at_robot_to_push_to_push(location, location)).
model(literal, could_move_for_todo_at_any_location(location)).
model(literal, toward_could_move_for_todo_at_any_location(location, location)).
model(literal, could_move_for_todo_at_any_location_2(location)).
model(literal, toward_could_move_for_todo_at_any_location_2(location, location)).
model(literal, fewer_at_robot_than_todo_at_1).
model(bias, 'sokoban.yaml').
model(bias_sha256, f7d3e0f1052143a94dc2d99ce9cdfffcb9bacd1160b0b1b16e5560192e174c62).
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
model(trained_episodes, 802).
model(trees, 46).

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

domain(sokoban).
:- ensure_loaded('sokoban.pl').
:- add_import_module(policy, sokoban, start).

% tree 1: step size 1.0, 204 examples, 4 leaves
delta(1, move(_, Location, _), -0.8558091026314573) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(1, move(_, _, _), 0.4228684080827995) :- !.
delta(1, push(_, _, _, _, _), 0.648498037521629) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 211 examples, 7 leaves
delta(2, move(_, Location, right), 0.09716238818258308) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location3, Location), !.
delta(2, move(_, Location, right), -0.43369297127491785) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), !.
delta(2, move(_, Location, _), 0.6277509677140555) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), !.
delta(2, move(_, Location, _), -0.6650489926816519) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(2, move(_, _, _), 0.16305097988063702) :- !.
delta(2, push(_, _, _, _, _), 0.44322426730284864) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 201 examples, 6 leaves
delta(3, move(_, Location, _), 0.4424629829403129) :- at_robot(Location2), toward_could_move_for_todo_at_any_location_2(Location, Location2), !.
delta(3, move(_, Location, _), 0.13664212305314632) :- could_push_todo_at(Location), !.
delta(3, move(Location, _, _), -0.548632908494195) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), !.
delta(3, move(_, _, _), -0.08845552151882535) :- !.
delta(3, push(_, _, _, _, _), 0.23305853610338897) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 209 examples, 9 leaves
delta(4, move(_, _, down), -0.044658250146314506) :- at_robot(Location), could_push(Location), !.
delta(4, move(Location, _, down), 0.03414525835796254) :- clear(Location2), adjacent(Location2, Location, down), !.
delta(4, move(_, _, down), 1.0686438202878015) :- !.
delta(4, move(_, Location, Direction), 0.036794285672544357) :- clear(Location2), adjacent(Location, Location2, Direction), toward_could_push(Location, Location2), !.
delta(4, move(_, Location, Direction), -1.1059823149237544) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(4, move(_, Location, _), -0.18205951416363356) :- clear(Location2), toward_could_push(Location, Location2), !.
delta(4, move(_, _, _), 0.1413905959570406) :- !.
delta(4, push(_, _, _, _, _), 0.13410980356538776) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 216 examples, 7 leaves
delta(5, move(_, Location, down), -0.0938750453893128) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(5, move(_, _, down), -0.023605647178291417) :- at_robot(Location), could_push(Location), !.
delta(5, move(_, _, down), 0.29687086181992683) :- !.
delta(5, move(_, Location, _), 0.1739250677270159) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), !.
delta(5, move(_, _, _), -0.3454245942475368) :- !.
delta(5, push(_, _, _, _, _), 0.0890479512764404) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 212 examples, 9 leaves
delta(6, move(_, Location, Direction), 0.24515077360404086) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), adjacent(Location, Location3, Direction), toward_could_push(Location, Location3), !.
delta(6, move(_, Location, Direction), -0.23541890518049138) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), adjacent(Location, Location3, Direction), !.
delta(6, move(_, Location, _), -0.32115215092521165) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(6, move(_, Location, Direction), 0.14399905651122352) :- clear(Location2), adjacent(Location, Location2, Direction), clear(Location3), toward_could_push(Location, Location3), !.
delta(6, move(_, Location, Direction), -0.2576809499025366) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(6, move(_, Location, _), 0.0013048026427284834) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(6, move(_, _, _), 0.3679858694089416) :- !.
delta(6, push(_, _, _, _, _), 0.0685395603553117) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 203 examples, 7 leaves
delta(7, move(_, Location, _), 0.002827739356244619) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), clear(Location3), could_move_for_todo_at_any_location_2(Location3), !.
delta(7, move(_, Location, _), 0.22627397846722827) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), !.
delta(7, move(_, Location, _), -0.22084358025755746) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(7, move(_, Location, Direction), -0.11927465031358517) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(7, move(_, _, _), 0.12879663632413313) :- !.
delta(7, push(_, _, _, _, _), 0.048642631298577814) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 203 examples, 11 leaves
delta(8, move(_, Location, down), 0.035843611667203894) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), clear(Location3), adjacent(Location, Location3, down), !.
delta(8, move(_, Location, Direction), -0.060688399400475025) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), clear(Location3), adjacent(Location, Location3, Direction), !.
delta(8, move(Location, Location2, _), 1.5093108921031209) :- at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location2, Location3), clear(Location4), nearer_at_robot(Location4, Location2, Location), !.
delta(8, move(_, Location, _), -0.05175724642312429) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(8, move(_, Location, _), -0.08810521373436177) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), at_robot(Location3), toward_could_push_todo_at(Location, Location3), !.
delta(8, move(_, Location, _), 0.24957563000902847) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(8, move(Location, Location2, _), -0.35399584986006166) :- clear(Location3), nearer_at_robot(Location3, Location2, Location), !.
delta(8, move(_, _, _), 0.047779344643414795) :- !.
delta(8, push(_, _, Location, _, _), -1.4623571704832243) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(8, push(_, _, _, _, _), 0.04779995197745042) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 203 examples, 11 leaves
delta(9, move(Location, Location2, _), 0.022122668945891533) :- at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location2, Location3), clear(Location4), could_push_todo_at(Location4), nearer_at_robot(Location, Location2, Location4), !.
delta(9, move(_, Location, _), -0.03510709020617471) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), clear(Location3), could_push_todo_at(Location3), !.
delta(9, move(Location, Location2, Direction), 0.9563816059498076) :- at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location2, Location3), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(9, move(_, Location, _), -0.011733233839361505) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(9, move(_, Location, _), -0.05075203018281976) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), at_robot(Location3), toward_could_push_todo_at(Location, Location3), !.
delta(9, move(_, Location, _), 0.23258904676962633) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(9, move(_, Location, Direction), -0.2135185618454128) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(9, move(_, _, _), -0.002262582960090115) :- !.
delta(9, push(_, _, Location, _, _), -0.9455136353388149) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(9, push(_, _, _, _, _), 0.04288585618324844) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 206 examples, 11 leaves
delta(10, move(_, Location, left), -0.01182111052851944) :- clear(Location2), adjacent(Location, Location2, left), toward_could_push(Location, Location2), !.
delta(10, move(_, Location, Direction), 0.23365958665063263) :- clear(Location2), adjacent(Location, Location2, Direction), toward_could_push(Location, Location2), !.
delta(10, move(_, Location, Direction), 0.018614407247110484) :- clear(Location2), adjacent(Location, Location2, Direction), could_push_todo_at(Location), !.
delta(10, move(_, Location, Direction), -0.34213720600211345) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(10, move(Location, Location2, Direction), -0.055039064384908784) :- clear(Location3), adjacent(Location3, Location, Direction), at_robot(Location4), toward_could_push_todo_at(Location2, Location4), !.
delta(10, move(Location, _, Direction), 0.47103191400794436) :- clear(Location2), adjacent(Location2, Location, Direction), !.
delta(10, move(_, Location, _), -0.18499313225586106) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(10, move(_, _, _), 0.12284524343315571) :- !.
delta(10, push(_, _, Location, _, _), -0.38903725701836245) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(10, push(_, _, _, _, _), 0.04595887808970259) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 203 examples, 12 leaves
delta(11, move(Location, Location2, _), 0.017101971066943625) :- at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location2, Location3), at_robot(Location4), toward_could_push_needed_at_to_push_to_push(Location2, Location4), toward_could_move_for_todo_at_any_location_2(Location2, Location), !.
delta(11, move(_, Location, _), -0.11819706681309378) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), at_robot(Location3), toward_could_push_needed_at_to_push_to_push(Location, Location3), !.
delta(11, move(Location, Location2, Direction), 0.9724484442331404) :- at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location2, Location3), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(11, move(_, Location, _), -0.08268146905174174) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(11, move(_, Location, _), 0.02767352099892934) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), at_robot(Location3), toward_could_push_todo_at(Location3, Location), !.
delta(11, move(_, Location, _), -0.8834066749843248) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), !.
delta(11, move(_, Location, _), -0.10702209679415498) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(11, move(_, _, _), 0.08191874771727681) :- !.
delta(11, push(_, _, Location, _, Box), 0.04612012032038836) :- clear(Location2), toward_wanted_at(Box, Location2, Location), !.
delta(11, push(_, _, _, _, _), -0.22692677827363678) :- clear(Location), needed_at_robot_to_push(Location), !.
delta(11, push(_, _, _, _, _), 0.009420655527484749) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 210 examples, 11 leaves
delta(12, move(Location, Location2, Direction), 0.0009659081695615018) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), toward_could_push(Location2, Location4), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(12, move(_, Location, Direction), 1.4101530205668322) :- clear(Location2), adjacent(Location, Location2, Direction), clear(Location3), toward_could_push(Location, Location3), !.
delta(12, move(_, Location, Direction), 0.016363365636316504) :- clear(Location2), adjacent(Location, Location2, Direction), clear(Location3), toward_could_push_todo_at(Location3, Location2), !.
delta(12, move(_, Location, Direction), -0.2014374830320336) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(12, move(Location, Location2, Direction), 0.030676417464908276) :- clear(Location3), adjacent(Location3, Location, Direction), at_robot(Location4), toward_could_push_todo_at(Location4, Location2), !.
delta(12, move(Location, _, Direction), -0.9519374944167087) :- clear(Location2), adjacent(Location2, Location, Direction), !.
delta(12, move(_, Location, _), -0.08840418449287823) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(12, move(_, _, _), 0.08627848276886041) :- !.
delta(12, push(_, _, Location, _, _), -0.49031470340409405) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(12, push(_, _, _, _, _), 0.059885269818708994) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 208 examples, 13 leaves
delta(13, move(_, Location, up), -0.015423089921013171) :- at_robot(Location2), could_push(Location2), at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location, Location3), !.
delta(13, move(_, Location, _), 0.07102981658893706) :- at_robot(Location2), could_push(Location2), at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location, Location3), !.
delta(13, move(Location, _, Direction), 2.034630343534631) :- at_robot(Location2), could_push(Location2), clear(Location3), adjacent(Location3, Location, Direction), !.
delta(13, move(_, _, _), -0.0285659408294323) :- at_robot(Location), could_push(Location), !.
delta(13, move(_, Location, right), -0.056896184123160755) :- clear(Location2), toward_could_move_for_todo_at_any_location_2(Location2, Location), !.
delta(13, move(_, _, right), 0.2928527119000684) :- !.
delta(13, move(_, Location, _), 0.14040589441943577) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), !.
delta(13, move(_, _, _), -0.2634245662271977) :- !.
delta(13, push(Location, _, _, Direction, Box), -0.1900708002361304) :- clear(Location2), adjacent(Location2, Location, Direction), todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(13, push(Location, _, _, Direction, _), 0.07151224297402568) :- clear(Location2), adjacent(Location2, Location, Direction), !.
delta(13, push(_, Location, _, _, _), 0.011812345393611519) :- clear(Location2), toward_could_push(Location2, Location), !.
delta(13, push(_, _, _, _, _), -1.9654604057520404) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 216 examples, 12 leaves
delta(14, move(_, Location, left), -0.15656410442199425) :- clear(Location2), toward_could_push_needed_at_robot_to_push(Location, Location2), !.
delta(14, move(_, Location, left), -0.08067432151683256) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(14, move(_, _, left), 0.866058332073743) :- !.
delta(14, move(_, Location, up), -0.0888143627945042) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), !.
delta(14, move(_, Location, _), 0.27931920188947446) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), !.
delta(14, move(_, Location, _), 0.04199959836532862) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(14, move(_, _, _), -0.2691156516321921) :- !.
delta(14, push(Location, _, _, right, Box), -0.09698984500223938) :- clear(Location2), toward_wanted_at(Box, Location, Location2), at_robot(Location3), adjacent(Location2, Location3, right), !.
delta(14, push(Location, _, _, right, Box), 0.08696076621022113) :- clear(Location2), toward_wanted_at(Box, Location, Location2), !.
delta(14, push(Location, _, _, _, Box), -0.7885513109030718) :- clear(Location2), toward_wanted_at(Box, Location, Location2), !.
delta(14, push(_, _, _, _, _), 0.07941517242299005) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 202 examples, 13 leaves
delta(15, move(_, Location, down), 0.07178778020466198) :- clear(Location2), adjacent(Location, Location2, down), clear(Location3), toward_could_push(Location3, Location2), !.
delta(15, move(_, Location, Direction), -0.3049638239425306) :- clear(Location2), adjacent(Location, Location2, Direction), clear(Location3), toward_could_push(Location3, Location2), !.
delta(15, move(_, Location, Direction), -0.09763930069092287) :- clear(Location2), adjacent(Location, Location2, Direction), at_robot(Location3), toward_could_push_todo_at(Location, Location3), !.
delta(15, move(_, Location, Direction), 0.15476094581151728) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(15, move(_, Location, _), -0.07299302639840398) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(15, move(Location, _, Direction), 0.4318472826412159) :- clear(Location2), adjacent(Location2, Location, Direction), !.
delta(15, move(_, _, _), -0.018631638179840905) :- !.
delta(15, push(Location, _, Location2, Direction, _), 0.03991783318416619) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(15, push(_, _, Location, up, _), -0.4232038438615002) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(15, push(_, _, Location, Direction, _), 0.0064008441350055754) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(15, push(Location, Location2, _, _, Box), 0.14706339431507742) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(15, push(_, _, _, _, _), -0.0962937440218236) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 212 examples, 12 leaves
delta(16, move(_, Location, _), -0.14212033510702593) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(16, move(Location, _, up), -0.11149225490788847) :- clear(Location2), adjacent(Location2, Location, up), !.
delta(16, move(Location, _, Direction), 0.2616489483962038) :- clear(Location2), adjacent(Location2, Location, Direction), !.
delta(16, move(_, Location, _), -0.1742964005924451) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(16, move(_, _, _), 0.11272101044747444) :- !.
delta(16, push(Location, _, Location2, up, _), 0.01001842198774681) :- clear(Location3), adjacent(Location2, Location3, up), clear(Location4), adjacent(Location4, Location, up), !.
delta(16, push(_, _, Location, up, _), -0.2520262683158417) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(16, push(_, _, _, up, _), 0.03858069970704473) :- !.
delta(16, push(Location, Location2, _, _, Box), 0.11506980880283316) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(16, push(_, _, Location, Direction, _), 0.025700896398418195) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(16, push(_, _, _, _, _), -0.05847180217734372) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 201 examples, 13 leaves
delta(17, move(_, Location, left), 0.0002824385006789738) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), at_robot(Location3), toward_could_push_todo_at(Location3, Location), !.
delta(17, move(_, Location, left), -0.05661612131264678) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(17, move(Location, Location2, left), 0.2402648594004718) :- clear(Location3), nearer_at_robot(Location3, Location, Location2), !.
delta(17, move(_, _, left), -0.024789002407592284) :- !.
delta(17, move(_, Location, _), -0.03945092315668528) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), at_robot(Location3), toward_could_push_todo_at(Location, Location3), !.
delta(17, move(_, Location, _), 0.14810170977093803) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(17, move(_, Location, _), 0.04788378458544148) :- could_push_todo_at(Location), !.
delta(17, move(_, _, _), -0.1645798978594122) :- !.
delta(17, push(_, _, Location, up, _), -0.16777069960495453) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(17, push(_, _, _, up, _), 0.0314564067164922) :- !.
delta(17, push(_, _, Location, _, _), -0.04229571481903234) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(17, push(_, _, _, _, _), 0.09686812988933369) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 210 examples, 13 leaves
delta(18, move(Location, Location2, up), 0.007762206871720951) :- clear(Location3), adjacent(Location3, Location, up), at_robot(Location4), toward_could_push_todo_at(Location4, Location2), !.
delta(18, move(Location, _, up), -0.13045609439915395) :- clear(Location2), adjacent(Location2, Location, up), !.
delta(18, move(Location, _, up), 0.03599818810908325) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(18, move(_, _, up), -0.0264435662971771) :- !.
delta(18, move(_, Location, _), -0.044829463071303734) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(18, move(_, Location, _), -0.03142785111105829) :- todo_at(_, Location), !.
delta(18, move(_, _, _), 0.10541161761536323) :- !.
delta(18, push(Location, _, Location2, Direction, _), 0.03543113062279673) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(18, push(_, _, Location, up, _), -0.12381497160261697) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(18, push(_, _, Location, Direction, _), 0.003877444353527848) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(18, push(Location, Location2, _, _, Box), 0.10614140194935436) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(18, push(_, _, _, _, _), -0.042930909355716314) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 205 examples, 14 leaves
delta(19, move(_, Location, _), 0.06899924285361002) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push_needed_at_to_push_to_push(Location3, Location), toward_could_move_needed_at_robot_to_push(Location3, Location), !.
delta(19, move(_, Location, _), -0.014564001560704065) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push_needed_at_to_push_to_push(Location3, Location), !.
delta(19, move(_, Location, _), -0.18787197206973466) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push(Location3, Location), !.
delta(19, move(_, Location, _), 0.03925349975258321) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(19, move(Location, _, right), 0.04763569725481943) :- clear(Location2), adjacent(Location2, Location, right), !.
delta(19, move(Location, _, Direction), -0.09700536826530182) :- clear(Location2), adjacent(Location2, Location, Direction), !.
delta(19, move(_, _, right), -0.02944096041337619) :- !.
delta(19, move(_, _, _), 0.1826117840339461) :- !.
delta(19, push(Location, _, Location2, Direction, _), 0.03043027048564393) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(19, push(_, _, Location, up, _), -0.1003307263491071) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(19, push(_, _, Location, Direction, _), 0.00417242243153692) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(19, push(Location, Location2, _, _, Box), 0.09881832152833789) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(19, push(_, _, _, _, _), -0.033528476636936234) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 213 examples, 14 leaves
delta(20, move(_, Location, right), -0.007471184023924756) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), clear(Location3), toward_could_move_for_todo_at_any_location_2(Location3, Location), !.
delta(20, move(_, Location, right), 0.13320275348374078) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), !.
delta(20, move(_, Location, right), 0.007764999498527986) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(20, move(_, _, right), -0.2944209549716276) :- !.
delta(20, move(Location, _, Direction), -0.15605531732339556) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), clear(Location3), adjacent(Location2, Location3, Direction), !.
delta(20, move(Location, _, _), 0.025579542009810555) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), !.
delta(20, move(_, Location, _), -0.02651403913648599) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(20, move(_, _, _), 0.2650392382803734) :- !.
delta(20, push(_, _, _, up, _), -0.08652309847975445) :- clear(Location), needed_at_robot_to_push(Location), !.
delta(20, push(_, _, _, up, _), 0.014759760853001827) :- !.
delta(20, push(Location, Location2, _, _, Box), 0.07093839470578546) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(20, push(_, _, Location, Direction, _), 0.016656585255945894) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(20, push(_, _, _, _, _), -0.030515508171534) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 218 examples, 14 leaves
delta(21, move(Location, Location2, _), -0.015292311624112093) :- clear(Location3), toward_could_push_needed_at_to_push_to_push(Location2, Location3), clear(Location4), toward_could_push_needed_at_to_push_to_push(Location4, Location2), toward_could_push_todo_at(Location2, Location), !.
delta(21, move(_, Location, _), 0.18399079112545716) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), clear(Location3), toward_could_push_needed_at_to_push_to_push(Location3, Location), !.
delta(21, move(_, Location, _), 0.00207016262383245) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), at_robot(Location3), toward_could_push_todo_at(Location3, Location), !.
delta(21, move(_, Location, _), -0.0567933197832497) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(21, move(_, Location, _), -0.18789669033412779) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push(Location3, Location), !.
delta(21, move(_, Location, _), -0.010603859241994371) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(21, move(Location, _, _), -0.14056184937843746) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(21, move(_, _, _), 0.13246912878101083) :- !.
delta(21, push(Location, _, Location2, Direction, _), 0.027459709871947947) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(21, push(_, _, Location, up, _), -0.0625697050083106) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(21, push(_, _, Location, Direction, _), 0.004180303590065675) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(21, push(Location, Location2, _, _, Box), 0.09037705578931067) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(21, push(_, _, _, _, _), -0.02822644027610167) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 207 examples, 10 leaves
delta(22, move(_, Location, left), 0.0026640851976138195) :- todo_at(_, Location), !.
delta(22, move(_, Location, _), -0.11537851450675347) :- todo_at(_, Location), !.
delta(22, move(_, Location, _), 0.13634978846193277) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), !.
delta(22, move(_, Location, _), -0.10538909138233682) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(22, move(_, _, _), 0.06584048140152973) :- !.
delta(22, push(Location, _, Location2, Direction, _), 0.023611460724068844) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(22, push(_, _, Location, Direction, _), -0.05583656180236515) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(22, push(Location, Location2, _, _, Box), 0.06491515362587832) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(22, push(_, _, _, _, _), -0.027097035054590858) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 217 examples, 10 leaves
delta(23, move(_, Location, left), 0.006248499027027831) :- clear(Location2), toward_could_push(Location, Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), !.
delta(23, move(_, Location, left), -0.14371457759654255) :- clear(Location2), toward_could_push(Location, Location2), !.
delta(23, move(_, _, left), 0.016762281473908017) :- !.
delta(23, move(_, Location, Direction), -0.05933208935430508) :- clear(Location2), adjacent(Location, Location2, Direction), clear(Location3), adjacent(Location2, Location3, Direction), !.
delta(23, move(_, Location, Direction), 0.1572608697228607) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(23, move(Location, _, _), -0.08854150931407997) :- clear(Location2), toward_could_push(Location2, Location), !.
delta(23, move(_, _, _), 0.03729540971722026) :- !.
delta(23, push(_, _, Location, _, _), -0.019228322104106136) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(23, push(_, _, _, _, _), 0.07782380122434683) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 205 examples, 10 leaves
delta(24, move(_, Location, left), 0.0027268521490227448) :- todo_at(_, Location), !.
delta(24, move(_, Location, Direction), 0.0004230535726353891) :- todo_at(_, Location), clear(Location2), adjacent(Location, Location2, Direction), !.
delta(24, move(_, Location, _), -0.06527157711608518) :- todo_at(_, Location), !.
delta(24, move(_, Location, _), -0.036348143029060115) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(24, move(_, Location, _), 0.09622919358600819) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(24, move(_, _, _), 0.001749516414561969) :- !.
delta(24, push(_, _, _, right, _), 0.049289513203657674) :- !.
delta(24, push(Location, _, _, _, Box), -0.07803749418639451) :- clear(Location2), toward_wanted_at(Box, Location, Location2), !.
delta(24, push(_, _, _, _, _), 0.015305436467126999) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 210 examples, 9 leaves
delta(25, move(_, Location, _), -0.06397301400991992) :- todo_at(_, Location), !.
delta(25, move(_, Location, _), -0.029017276913250626) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(25, move(_, Location, _), -0.01682859732830383) :- clear(Location2), toward_could_push_needed_at_robot_to_push(Location, Location2), !.
delta(25, move(_, _, _), 0.08096015947703354) :- !.
delta(25, push(Location, _, Location2, Direction, Box), -0.06463302452595693) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), toward_wanted_at(Box, Location, Location4), !.
delta(25, push(_, _, Location, Direction, _), 0.010107004831112676) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(25, push(Location, Location2, _, _, Box), 0.054961017608206875) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(25, push(_, _, _, _, _), -0.031740226610742335) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 201 examples, 12 leaves
delta(26, move(_, Location, Direction), 0.045575393051080645) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_move_for_todo_at_any_location_2(Location3, Location), adjacent(Location, Location3, Direction), !.
delta(26, move(_, Location, _), -0.004905005885756604) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_move_for_todo_at_any_location_2(Location3, Location), !.
delta(26, move(_, Location, _), 0.005253239775371523) :- at_robot(Location2), toward_could_push(Location, Location2), at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location, Location3), !.
delta(26, move(_, Location, _), -0.1070742713119502) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(26, move(_, Location, right), -0.05184033706273924) :- clear(Location2), toward_could_move_for_todo_at_any_location_2(Location2, Location), !.
delta(26, move(_, Location, _), 0.007351611572891245) :- clear(Location2), toward_could_move_for_todo_at_any_location_2(Location2, Location), !.
delta(26, move(_, Location, _), -0.0103336755731184) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(26, move(_, _, _), 0.07464033203939478) :- !.
delta(26, push(Location, Location2, _, _, Box), 0.038955191689431554) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(26, push(_, _, Location, Direction, _), 0.009680438742874263) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(26, push(_, _, _, _, _), -0.02586545306890845) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 202 examples, 14 leaves
delta(27, move(Location, _, right), -0.012249445361813334) :- clear(Location2), adjacent(Location2, Location, right), at_robot(Location3), could_push(Location3), !.
delta(27, move(Location, _, right), 0.04009718826533818) :- clear(Location2), adjacent(Location2, Location, right), !.
delta(27, move(_, Location, right), 0.0017032715456415028) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), !.
delta(27, move(_, _, right), -0.10761814689557957) :- !.
delta(27, move(_, _, _), 0.12988585517963083) :- clear(Location), needed_at_robot_to_push(Location), clear(Location2), toward_could_push(Location2, Location), !.
delta(27, move(_, _, _), -0.03843230254371783) :- clear(Location), needed_at_robot_to_push(Location), !.
delta(27, move(_, _, left), 0.03986093795472015) :- !.
delta(27, move(_, _, _), -0.06752061061883671) :- !.
delta(27, push(Location, _, Location2, Direction, _), 0.015174941456878654) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(27, push(_, _, Location, up, _), -0.06207234198796791) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(27, push(_, _, Location, Direction, _), 0.002995673066275597) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(27, push(Location, Location2, _, _, Box), 0.047839603618983095) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(27, push(_, _, _, _, _), -0.026510038976435585) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 218 examples, 14 leaves
delta(28, move(_, Location, right), 0.027805053448817493) :- clear(Location2), could_move_needed_at_robot_to_push(Location2), at_robot(Location3), toward_could_push_needed_at_to_push_to_push(Location3, Location), !.
delta(28, move(_, _, right), -0.006185890018981607) :- clear(Location), could_move_needed_at_robot_to_push(Location), !.
delta(28, move(_, Location, right), -0.1162694084367396) :- clear(Location2), adjacent(Location, Location2, right), !.
delta(28, move(_, _, right), 0.005843037251408249) :- !.
delta(28, move(_, Location, _), 0.027297266249222445) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_move_for_todo_at_any_location_2(Location3, Location), !.
delta(28, move(_, Location, _), -0.06580616500857119) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(28, move(_, Location, _), -0.02360567762512038) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(28, move(_, _, _), 0.1313677267744588) :- !.
delta(28, push(Location, _, Location2, Direction, _), 0.015609104838710768) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(28, push(_, _, Location, up, _), -0.051140147198940236) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(28, push(_, _, Location, Direction, _), 0.0033238820599108755) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(28, push(Location, Location2, _, _, Box), 0.048410888715085046) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(28, push(_, _, _, _, _), -0.004771688070511181) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 210 examples, 13 leaves
delta(29, move(Location, _, left), 0.10052931959041474) :- clear(Location2), adjacent(Location2, Location, left), at_robot(Location3), toward_could_push(Location2, Location3), !.
delta(29, move(Location, _, left), -0.008806355130427688) :- clear(Location2), adjacent(Location2, Location, left), !.
delta(29, move(_, Location, left), -0.04722839886988983) :- clear(Location2), toward_could_push(Location, Location2), !.
delta(29, move(_, _, left), 0.014480860208826064) :- !.
delta(29, move(_, Location, _), 0.05675730492802573) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), clear(Location3), toward_could_push(Location2, Location3), !.
delta(29, move(_, Location, _), -0.010002541755122607) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(29, move(_, Location, _), 0.018400102467753806) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location2, Location), !.
delta(29, move(_, _, _), -0.08163283395452756) :- !.
delta(29, push(Location, _, Location2, Direction, Box), -0.0508076499895172) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), toward_wanted_at(Box, Location, Location4), !.
delta(29, push(_, _, Location, Direction, _), 0.009068867924209216) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(29, push(Location, Location2, _, _, Box), 0.04337194150257579) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(29, push(_, _, _, _, _), -0.023211811304970943) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 207 examples, 13 leaves
delta(30, move(_, Location, right), 0.11419735601454505) :- at_robot(Location2), toward_could_push_needed_at_robot_to_push(Location2, Location), !.
delta(30, move(Location, _, right), 0.02231336732243142) :- clear(Location2), adjacent(Location2, Location, right), !.
delta(30, move(_, _, right), -0.0743451559972576) :- !.
delta(30, move(_, Location, _), -0.12323079508957956) :- clear(Location2), could_push_needed_at_robot_to_push(Location2), at_robot(Location3), nearer_at_robot(Location, Location3, Location2), !.
delta(30, move(_, _, _), 0.009968683485602163) :- clear(Location), could_push_needed_at_robot_to_push(Location), !.
delta(30, move(_, Location, _), -0.023023788010578198) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(30, move(_, _, _), 0.06492050003415918) :- !.
delta(30, push(Location, _, Location2, up, _), 0.00330282967058573) :- clear(Location3), adjacent(Location2, Location3, up), clear(Location4), adjacent(Location4, Location, up), !.
delta(30, push(_, _, Location, up, _), -0.04342377538262161) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(30, push(_, _, _, up, _), 0.012784192937766293) :- !.
delta(30, push(_, _, Location, _, _), -0.013348341252866934) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(30, push(_, _, _, _, _), 0.034133946995873486) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 210 examples, 13 leaves
delta(31, move(Location, Location2, up), 0.0034133510792277544) :- clear(Location3), toward_could_push(Location3, Location), at_robot(Location4), toward_could_push_todo_at(Location4, Location2), !.
delta(31, move(Location, _, up), -0.0738187292697735) :- clear(Location2), toward_could_push(Location2, Location), !.
delta(31, move(_, _, up), 0.016148788284342002) :- !.
delta(31, move(Location, Location2, Direction), 0.03693046916100499) :- at_robot(Location3), toward_could_push(Location2, Location3), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(31, move(_, Location, _), -0.07164886317540084) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(31, move(_, Location, _), -0.030026213623816436) :- could_push_for_todo_at_any_location(Location), !.
delta(31, move(_, _, _), 0.09819369984645643) :- !.
delta(31, push(Location, _, Location2, up, _), 0.003042823115901394) :- clear(Location3), adjacent(Location2, Location3, up), clear(Location4), adjacent(Location4, Location, up), !.
delta(31, push(_, _, Location, up, _), -0.038469536017034046) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(31, push(_, _, _, up, _), 0.013028761366531779) :- !.
delta(31, push(_, _, Location, _, _), -0.01262297330704878) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(31, push(_, _, _, _, _), 0.03408505614724538) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 209 examples, 14 leaves
delta(32, move(_, Location, right), 0.056131386631621) :- clear(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push(Location3, Location), !.
delta(32, move(_, Location, right), -0.011824299175604768) :- clear(Location2), toward_could_push(Location, Location2), !.
delta(32, move(_, Location, right), -0.08488878361688168) :- clear(Location2), adjacent(Location, Location2, right), !.
delta(32, move(_, _, right), 0.011282058674524701) :- !.
delta(32, move(_, Location, _), 0.036948718644203675) :- clear(Location2), toward_could_push(Location, Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(32, move(_, Location, _), -0.06539407248837811) :- clear(Location2), toward_could_push(Location, Location2), !.
delta(32, move(_, _, _), -0.013260940824272805) :- clear(Location), could_move_needed_at_robot_to_push(Location), !.
delta(32, move(_, _, _), 0.07976144064570521) :- !.
delta(32, push(Location, _, Location2, up, _), 0.0029461547403714402) :- clear(Location3), adjacent(Location2, Location3, up), clear(Location4), adjacent(Location4, Location, up), !.
delta(32, push(_, _, Location, up, _), -0.035193389580545346) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(32, push(_, _, _, up, _), 0.011960956153964867) :- !.
delta(32, push(_, _, Location, _, _), -0.011847886805352035) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(32, push(_, _, _, _, _), 0.03205307650354304) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 216 examples, 13 leaves
delta(33, move(Location, Location2, Direction), -0.027752988096210362) :- at_robot(Location3), toward_could_push(Location2, Location3), clear(Location4), adjacent(Location4, Location, Direction), toward_could_push(Location, Location4), !.
delta(33, move(Location, Location2, Direction), 0.05565580229280511) :- at_robot(Location3), toward_could_push(Location2, Location3), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(33, move(_, Location, _), -0.071253726904836) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(33, move(Location, _, right), 0.036712048705037734) :- clear(Location2), adjacent(Location2, Location, right), !.
delta(33, move(Location, _, Direction), -0.057414778781089006) :- clear(Location2), adjacent(Location2, Location, Direction), !.
delta(33, move(_, Location, _), -0.020208632130558266) :- todo_at(_, Location), !.
delta(33, move(_, _, _), 0.07744214209511163) :- !.
delta(33, push(Location, _, Location2, up, _), 0.0027065785887018237) :- clear(Location3), adjacent(Location2, Location3, up), clear(Location4), adjacent(Location4, Location, up), !.
delta(33, push(_, _, Location, up, _), -0.03554568733378515) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(33, push(_, _, _, up, _), 0.01097361888402284) :- !.
delta(33, push(_, _, Location, _, _), -0.011488477431360512) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(33, push(_, _, _, _, _), 0.029057200509104823) :- !.
delta(33, _, 0.0).

% tree 34: step size 1.0, 206 examples, 14 leaves
delta(34, move(_, Location, Direction), -0.009498517696266128) :- clear(Location2), adjacent(Location, Location2, Direction), toward_could_push(Location, Location2), clear(Location3), adjacent(Location2, Location3, Direction), !.
delta(34, move(_, Location, Direction), 0.05459909518703785) :- clear(Location2), adjacent(Location, Location2, Direction), toward_could_push(Location, Location2), !.
delta(34, move(_, Location, up), 0.017672881138446492) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(34, move(_, Location, Direction), -0.08019119627821891) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(34, move(Location, Location2, _), -0.04229785464644511) :- clear(Location3), toward_could_push_needed_at_to_push_to_push(Location3, Location), clear(Location4), nearer_at_robot(Location4, Location3, Location2), !.
delta(34, move(Location, _, _), 0.014874759616111862) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(34, move(_, _, _), -0.007734756799297486) :- clear(Location), could_move_for_todo_at_any_location_2(Location), !.
delta(34, move(_, _, _), 0.06826204169085341) :- !.
delta(34, push(_, _, Location, right, Box), 0.028894393388324488) :- clear(Location2), toward_wanted_at(Box, Location2, Location), !.
delta(34, push(_, _, Location, right, Box), -0.013902061465784347) :- at(Box, Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(34, push(_, _, _, right, _), 0.0020232262487008368) :- !.
delta(34, push(Location, _, _, _, Box), -0.03622323949385165) :- clear(Location2), toward_wanted_at(Box, Location, Location2), !.
delta(34, push(_, _, _, _, _), 0.00757674634678472) :- !.
delta(34, _, 0.0).

% tree 35: step size 1.0, 203 examples, 11 leaves
delta(35, move(Location, Location2, right), 0.07386400135057801) :- clear(Location3), toward_could_push(Location2, Location3), clear(Location4), toward_could_push(Location4, Location), !.
delta(35, move(_, Location, right), -0.014896876648602939) :- clear(Location2), toward_could_push(Location, Location2), !.
delta(35, move(_, Location, right), -0.04108150570747609) :- clear(Location2), adjacent(Location, Location2, right), !.
delta(35, move(_, _, right), 0.013746523242045526) :- !.
delta(35, move(_, Location, left), -0.0066911967350695226) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(35, move(_, Location, _), 0.03542074399323487) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(35, move(_, Location, _), -0.09532565690616851) :- clear(Location2), toward_could_push(Location, Location2), !.
delta(35, move(_, _, _), 0.03100066436674772) :- !.
delta(35, push(_, _, Location, _, _), -0.010967499353735217) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(35, push(_, _, _, _, _), 0.023533163894472076) :- !.
delta(35, _, 0.0).

% tree 36: step size 1.0, 208 examples, 13 leaves
delta(36, move(_, Location, _), 0.013848289790736875) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push(Location3, Location), toward_could_move_for_todo_at_any_location_2(Location3, Location), !.
delta(36, move(_, Location, _), -0.05229867530631546) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push(Location3, Location), !.
delta(36, move(_, Location, left), 0.025142348694226824) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(36, move(_, Location, _), -0.011470124368802504) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(36, move(_, Location, _), 0.0012789282389889698) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), at_robot(Location3), toward_could_push_todo_at(Location3, Location), !.
delta(36, move(_, Location, _), -0.018759025634698345) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(36, move(_, Location, _), -0.016014929597765508) :- clear(Location2), toward_could_move_for_todo_at_any_location_2(Location2, Location), !.
delta(36, move(_, _, _), 0.048569516045379665) :- !.
delta(36, push(Location, _, Location2, Direction, _), 0.009972904867490221) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(36, push(_, _, Location, Direction, _), -0.030183240893530052) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(36, push(Location, Location2, _, _, Box), 0.029320357884845834) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(36, push(_, _, _, _, _), -0.014762289045088688) :- !.
delta(36, _, 0.0).

% tree 37: step size 1.0, 204 examples, 16 leaves
delta(37, move(Location, Location2, up), 0.0007713718942898564) :- clear(Location3), adjacent(Location3, Location, up), at_robot(Location4), toward_could_push_todo_at(Location4, Location2), !.
delta(37, move(Location, _, up), -0.03988472923142632) :- clear(Location2), adjacent(Location2, Location, up), !.
delta(37, move(_, Location, up), -0.006780522095983203) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(37, move(_, _, up), 0.029671199510327408) :- !.
delta(37, move(Location, _, Direction), -0.025982969292228014) :- clear(Location2), adjacent(Location2, Location, Direction), clear(Location3), adjacent(Location3, Location2, Direction), !.
delta(37, move(Location, _, Direction), 0.06619416237304111) :- clear(Location2), adjacent(Location2, Location, Direction), !.
delta(37, move(_, _, _), -0.052555901856877675) :- clear(Location), needed_at_robot_to_push(Location), !.
delta(37, move(_, _, _), 0.03778511155097298) :- !.
delta(37, push(_, _, Location, right, Box), 0.023705602039995995) :- clear(Location2), toward_wanted_at(Box, Location2, Location), !.
delta(37, push(_, _, Location, right, Box), -0.013154924580575232) :- at(Box, Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(37, push(_, _, _, right, _), 0.001509770533778469) :- !.
delta(37, push(Location, _, Location2, Direction, _), 0.0026862890725674175) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(37, push(_, _, Location, Direction, _), -0.028626019071285543) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(37, push(Location, Location2, _, _, Box), 0.01015659962043908) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(37, push(_, _, _, _, _), -0.0035041219301075676) :- !.
delta(37, _, 0.0).

% tree 38: step size 1.0, 201 examples, 11 leaves
delta(38, move(_, Location, up), 0.0030967248759167657) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), !.
delta(38, move(_, _, up), -0.062474415185751794) :- !.
delta(38, move(Location, Location2, _), 0.08719306265272259) :- clear(Location3), nearer_at_robot(Location3, Location2, Location), clear(Location4), toward_could_push(Location4, Location3), !.
delta(38, move(Location, Location2, _), -0.02421456661344424) :- clear(Location3), nearer_at_robot(Location3, Location2, Location), !.
delta(38, move(_, _, _), -0.0178270848331018) :- clear(Location), could_move_for_todo_at_any_location_2(Location), !.
delta(38, move(_, _, _), 0.005112831422765951) :- !.
delta(38, push(_, _, Location, right, Box), 0.023084953840067705) :- clear(Location2), toward_wanted_at(Box, Location2, Location), !.
delta(38, push(_, _, _, right, _), -0.011408675763661957) :- !.
delta(38, push(Location, _, _, _, Box), -0.03009244561506386) :- clear(Location2), toward_wanted_at(Box, Location, Location2), !.
delta(38, push(_, _, _, _, _), 0.005422663276992524) :- !.
delta(38, _, 0.0).

% tree 39: step size 1.0, 208 examples, 13 leaves
delta(39, move(_, Location, left), -0.019092952541086373) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(39, move(_, Location, _), 0.04117047498850279) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), clear(Location3), toward_could_push(Location2, Location3), !.
delta(39, move(_, Location, _), -0.007083090937609052) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(39, move(_, _, left), -0.027559826927476747) :- clear(Location), could_push_needed_at_robot_to_push(Location), !.
delta(39, move(_, _, left), 0.055262709594425315) :- !.
delta(39, move(_, Location, _), 0.0290570772567457) :- at_robot(Location2), toward_could_push_needed_at_robot_to_push(Location2, Location), !.
delta(39, move(_, _, _), -0.06412880181042652) :- !.
delta(39, push(Location, _, Location2, Direction, _), 0.00906981263615475) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(39, push(_, _, Location, up, _), -0.02310639166531299) :- clear(Location2), adjacent(Location, Location2, up), !.
delta(39, push(_, _, Location, Direction, _), 0.0016356680607277796) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(39, push(Location, Location2, _, _, Box), 0.02745216861264001) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(39, push(_, _, _, _, _), -0.01272277311914702) :- !.
delta(39, _, 0.0).

% tree 40: step size 1.0, 217 examples, 11 leaves
delta(40, move(_, Location, _), 0.015082056252454267) :- at_robot(Location2), toward_could_push(Location, Location2), at_robot(Location3), toward_could_push_todo_at(Location3, Location), !.
delta(40, move(_, Location, _), 0.009947240706800541) :- at_robot(Location2), toward_could_push(Location, Location2), at_robot(Location3), toward_could_move_needed_at_robot_to_push(Location, Location3), !.
delta(40, move(_, Location, _), -0.046769258703857904) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(40, move(_, Location, _), -0.015222561824195078) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(40, move(_, Location, _), -0.01505725754084309) :- could_push_for_todo_at_any_location(Location), !.
delta(40, move(_, _, _), 0.04611822118641433) :- !.
delta(40, push(_, _, Location, _, _), -0.014020808612740231) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(40, push(Location, _, Location2, Direction, _), 0.008233934693006316) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), adjacent(Location4, Location, Direction), !.
delta(40, push(_, _, Location, Direction, _), -0.01952279832166818) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(40, push(_, _, _, _, _), 0.022481517844052515) :- !.
delta(40, _, 0.0).

% tree 41: step size 1.0, 215 examples, 10 leaves
delta(41, move(_, Location, right), 0.03898281777840508) :- at_robot(Location2), toward_could_push_needed_at_robot_to_push(Location2, Location), !.
delta(41, move(_, Location, right), -0.06600745443448172) :- clear(Location2), adjacent(Location, Location2, right), !.
delta(41, move(_, _, right), 0.008099405377751966) :- !.
delta(41, move(_, Location, _), -0.03959094718236853) :- clear(Location2), toward_could_push_needed_at_robot_to_push(Location, Location2), !.
delta(41, move(_, Location, _), -0.013284181517538577) :- at_robot(Location2), toward_could_push_todo_at(Location, Location2), !.
delta(41, move(_, _, _), 0.06138392198220132) :- !.
delta(41, push(Location, _, _, Direction, _), 0.013120981639750293) :- clear(Location2), adjacent(Location2, Location, Direction), !.
delta(41, push(_, _, Location, Direction, _), -0.02023460346691633) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(41, push(_, _, _, _, _), 0.006708918982209996) :- !.
delta(41, _, 0.0).

% tree 42: step size 1.0, 214 examples, 13 leaves
delta(42, move(_, Location, up), -0.0035813156251514743) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push_needed_at_to_push_to_push(Location3, Location), !.
delta(42, move(_, Location, _), 0.023199351222891525) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push_needed_at_to_push_to_push(Location3, Location), !.
delta(42, move(_, Location, _), -0.04885441154904864) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push(Location3, Location), !.
delta(42, move(_, Location, _), 0.010742604628481832) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(42, move(Location, Location2, _), -0.027926006566260923) :- clear(Location3), toward_could_push_needed_at_to_push_to_push(Location3, Location), clear(Location4), nearer_at_robot(Location4, Location3, Location2), !.
delta(42, move(Location, _, _), 0.010972580610034498) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(42, move(_, Location, Direction), -0.002431394153976162) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(42, move(_, _, _), 0.03960074249496539) :- !.
delta(42, push(Location, _, Location2, Direction, Box), -0.01949255618888797) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), toward_wanted_at(Box, Location, Location4), !.
delta(42, push(_, _, Location, Direction, _), 0.0038350452476843583) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(42, push(Location, Location2, _, _, Box), 0.025236102815804518) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(42, push(_, _, _, _, _), -0.011656947338707025) :- !.
delta(42, _, 0.0).

% tree 43: step size 1.0, 205 examples, 12 leaves
delta(43, move(Location, Location2, _), 0.012352799892083013) :- at_robot(Location3), toward_could_push(Location2, Location3), clear(Location4), toward_could_push(Location4, Location2), toward_could_push_todo_at(Location, Location2), !.
delta(43, move(_, Location, _), -0.04064722284017017) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push(Location3, Location), !.
delta(43, move(_, Location, right), -0.008450180565740772) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(43, move(_, Location, _), 0.01924380475780716) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(43, move(_, Location, _), -0.012332272012620524) :- could_push_for_todo_at_any_location(Location), !.
delta(43, move(_, Location, _), -0.012266031675750874) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location, Location2), !.
delta(43, move(_, _, _), 0.034827090726714666) :- !.
delta(43, push(Location, _, Location2, Direction, Box), -0.018626019691944745) :- clear(Location3), adjacent(Location2, Location3, Direction), clear(Location4), toward_wanted_at(Box, Location, Location4), !.
delta(43, push(_, _, Location, Direction, _), 0.004322142326361513) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(43, push(Location, Location2, _, _, Box), 0.024286187964277447) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(43, push(_, _, _, _, _), -0.01216825008921237) :- !.
delta(43, _, 0.0).

% tree 44: step size 1.0, 203 examples, 9 leaves
delta(44, move(_, Location, right), 0.0423703399658936) :- at_robot(Location2), toward_could_push_needed_at_robot_to_push(Location2, Location), !.
delta(44, move(_, Location, right), -0.026590510378987797) :- clear(Location2), adjacent(Location, Location2, right), !.
delta(44, move(_, _, right), 0.013605614437512781) :- !.
delta(44, move(_, Location, _), 0.015778981197096986) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), !.
delta(44, move(_, Location, _), 0.00803262221371015) :- at_robot(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(44, move(_, _, _), -0.058085039438687494) :- !.
delta(44, push(Location, Location2, _, _, Box), 0.02674112186907304) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(44, push(_, _, _, _, _), -0.01134461676083508) :- !.
delta(44, _, 0.0).

% tree 45: step size 1.0, 205 examples, 16 leaves
delta(45, move(_, Location, right), 0.012764065113616703) :- clear(Location2), adjacent(Location, Location2, right), toward_could_push(Location, Location2), !.
delta(45, move(_, Location, right), -0.05770967681891688) :- clear(Location2), adjacent(Location, Location2, right), !.
delta(45, move(Location, _, right), -0.008520456354245727) :- clear(Location2), toward_could_push_for_todo_at_any_location(Location2, Location), !.
delta(45, move(_, _, right), 0.019113125308159496) :- !.
delta(45, move(_, Location, _), -0.030454061677273908) :- at_robot(Location2), toward_could_push(Location, Location2), clear(Location3), toward_could_push(Location3, Location), !.
delta(45, move(_, Location, _), 0.018624741530078294) :- at_robot(Location2), toward_could_push(Location, Location2), !.
delta(45, move(Location, _, _), -0.010618226917005896) :- clear(Location2), toward_could_push_needed_at_to_push_to_push(Location2, Location), !.
delta(45, move(_, _, _), 0.056024354485746) :- !.
delta(45, push(_, _, Location, right, Box), 0.018210047058806356) :- clear(Location2), toward_wanted_at(Box, Location2, Location), !.
delta(45, push(_, _, Location, right, Box), -0.009425499512806378) :- at(Box, Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(45, push(_, _, _, right, _), 0.0010287075230922401) :- !.
delta(45, push(_, _, Location, Direction, Box), 0.002057445002013399) :- clear(Location2), adjacent(Location, Location2, Direction), todo_at(Box, Location3), toward_wanted_at(Box, Location2, Location3), !.
delta(45, push(_, _, Location, Direction, _), -0.01821141858461146) :- clear(Location2), adjacent(Location, Location2, Direction), !.
delta(45, push(Location, Location2, _, _, Box), 0.008232742063933346) :- todo_at(Box, Location3), nearer_at_robot(Location, Location2, Location3), !.
delta(45, push(_, _, _, _, _), -0.0025124555356882653) :- !.
delta(45, _, 0.0).

% tree 46: step size 1.0, 207 examples, 10 leaves
delta(46, move(_, Location, _), -0.010554586685952277) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), at_robot(Location3), toward_could_push_for_todo_at_any_location(Location3, Location), !.
delta(46, move(_, Location, up), -0.0022075655227344663) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(46, move(_, Location, _), 0.024692399439298122) :- at_robot(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(46, move(Location, Location2, _), 0.017468914834109638) :- at_robot(Location3), toward_could_push_todo_at(Location3, Location2), clear(Location4), nearer_at_robot(Location4, Location2, Location), !.
delta(46, move(_, Location, _), -0.007707446962320339) :- at_robot(Location2), toward_could_push_todo_at(Location2, Location), !.
delta(46, move(Location, Location2, _), -0.036310284539794686) :- clear(Location3), nearer_at_robot(Location3, Location2, Location), !.
delta(46, move(_, _, _), 0.006911241149589651) :- !.
delta(46, push(_, _, Location, _, _), -0.011485934659117219) :- clear(Location2), toward_could_move_needed_at_robot_to_push(Location, Location2), !.
delta(46, push(_, _, _, _, _), 0.026401023227998616) :- !.
delta(46, _, 0.0).
