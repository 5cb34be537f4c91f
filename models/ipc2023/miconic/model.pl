% SHA-256 of what follows: dab1cb4d444ae01f670835ff2da0e6e24e1323a42971a7b1c01745b50eb12114
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
model(domain_sha256, '2e4260bd348b8483347a96d9e3a338ace93a46b6986e29ff8f0986206918fb99').
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
model(bias_sha256, '0b769ddcea6f529a210e93b15226b228459216ae417be439fe256fbb9553d97b').
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
model(trained_episodes, 635).
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

domain(miconic).
:- ensure_loaded('miconic.pl').
:- add_import_module(policy, miconic, start).

% tree 1: step size 1.0, 218 examples, 8 leaves
delta(1, board(_, _), 0.37658714184199144) :- !.
delta(1, depart(_, _), 0.2914415281518455) :- !.
delta(1, up(_, Floor), 0.14528593508500784) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(1, up(_, _), -0.47715842488309834) :- !.
delta(1, down(_, Floor), 0.14427733877134855) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(1, down(Floor, _), 0.0) :- above(Floor2, Floor), origin(_, Floor2), !.
delta(1, down(_, _), -0.3939564905386165) :- !.
delta(1, _, 0.0).

% tree 2: step size 1.0, 201 examples, 9 leaves
delta(2, board(_, _), 0.33322506354607756) :- !.
delta(2, depart(_, _), 0.27210231589978817) :- !.
delta(2, up(_, Floor), 0.18640368638268973) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(2, up(Floor, _), 0.0) :- above(Floor, Floor2), could_depart(Floor2), !.
delta(2, up(_, _), -0.39439982426567516) :- !.
delta(2, down(_, Floor), 0.1363462353020333) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(2, down(Floor, _), 0.0) :- above(Floor2, Floor), origin(_, Floor2), !.
delta(2, down(_, _), -0.42344767414136253) :- !.
delta(2, _, 0.0).

% tree 3: step size 1.0, 209 examples, 9 leaves
delta(3, board(_, _), 0.25794762803742133) :- !.
delta(3, depart(_, _), 0.2380591051942677) :- !.
delta(3, up(_, Floor), 0.16294483444274657) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(3, up(_, Floor), 0.130742521914769) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(3, up(_, _), -0.38802386332426625) :- !.
delta(3, down(_, Floor), 0.10678524619705655) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(3, down(_, Floor), 0.10092961487383804) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(3, down(_, _), -0.42921674826305867) :- !.
delta(3, _, 0.0).

% tree 4: step size 1.0, 202 examples, 9 leaves
delta(4, board(_, _), 0.1745129313406121) :- !.
delta(4, depart(_, _), 0.17043288993948497) :- !.
delta(4, up(_, Floor), 0.13812954930941826) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(4, up(_, Floor), 0.10578753238821778) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(4, up(_, _), -0.3014564049170917) :- !.
delta(4, down(_, Floor), 0.08658992798171652) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(4, down(_, Floor), 0.07143620292435836) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(4, down(_, _), -0.32647095096529444) :- !.
delta(4, _, 0.0).

% tree 5: step size 1.0, 201 examples, 9 leaves
delta(5, board(_, _), 0.13244540769861587) :- !.
delta(5, depart(_, _), 0.11571159527728904) :- !.
delta(5, up(_, Floor), 0.10394496613139251) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(5, up(_, Floor), 0.0752988872531996) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(5, up(_, _), -0.2478225768936392) :- !.
delta(5, down(_, Floor), 0.14240980359791183) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(5, down(_, Floor), 0.050878828852371605) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(5, down(_, _), -0.28332561066735334) :- !.
delta(5, _, 0.0).

% tree 6: step size 1.0, 204 examples, 9 leaves
delta(6, board(_, _), 0.11639831334412863) :- !.
delta(6, depart(_, _), 0.09860005714211668) :- !.
delta(6, up(_, Floor), 0.15256220623110509) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(6, up(_, Floor), 0.0620968717988179) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(6, up(_, _), -0.25138839361590937) :- !.
delta(6, down(_, Floor), 0.16208872504514413) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(6, down(_, Floor), 0.03742412260532502) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(6, down(_, _), -0.2867429824855537) :- !.
delta(6, _, 0.0).

% tree 7: step size 1.0, 203 examples, 9 leaves
delta(7, board(_, _), 0.10269257630294736) :- !.
delta(7, depart(_, _), 0.0914501512235727) :- !.
delta(7, up(_, Floor), 0.15528768737020227) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(7, up(_, Floor), 0.07194038832858789) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(7, up(_, _), -0.2682782508554242) :- !.
delta(7, down(_, Floor), 0.16178427216328953) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(7, down(_, Floor), 0.053685581943358825) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(7, down(_, _), -0.27139966491101986) :- !.
delta(7, _, 0.0).

% tree 8: step size 1.0, 204 examples, 9 leaves
delta(8, board(_, _), 0.10258750888606083) :- !.
delta(8, depart(_, _), 0.08369743562806495) :- !.
delta(8, up(_, Floor), 0.13565857177204832) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(8, up(_, Floor), 0.0716000523651753) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(8, up(_, _), -0.2482507908461358) :- !.
delta(8, down(_, Floor), 0.1504998536678594) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(8, down(_, Floor), 0.06261592624445339) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(8, down(_, _), -0.2679231837071504) :- !.
delta(8, _, 0.0).

% tree 9: step size 1.0, 203 examples, 12 leaves
delta(9, board(Floor, Passenger), -0.033583305717672464) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(9, board(_, _), 0.16424632001815273) :- !.
delta(9, depart(_, _), 0.10538398247976642) :- !.
delta(9, up(Floor, Floor2), 0.11445766162987804) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), !.
delta(9, up(_, Floor), 0.10340175159333324) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(9, up(Floor, Floor2), 0.02186305962985721) :- above(Floor3, Floor), toward_could_depart(Floor3, Floor2), !.
delta(9, up(_, _), -0.2701203180911266) :- !.
delta(9, down(_, Floor), 0.13057309521926286) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(9, down(Floor, Floor2), 0.049767374017163205) :- above(Floor3, Floor), toward_could_depart(Floor3, Floor2), !.
delta(9, down(Floor, Floor2), 0.009831552032178482) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), !.
delta(9, down(_, _), -0.28614968231340504) :- !.
delta(9, _, 0.0).

% tree 10: step size 1.0, 205 examples, 16 leaves
delta(10, board(_, _), 0.22896869664232308) :- !.
delta(10, depart(_, _), 0.18894968886516902) :- !.
delta(10, up(Floor, Floor2), -0.012665482962658408) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), todo_served(Passenger), origin(Passenger, Floor3), !.
delta(10, up(Floor, Floor2), -0.002049303009753437) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), todo_served(Passenger), origin(Passenger, Floor), !.
delta(10, up(Floor, Floor2), 0.0832760664800075) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), !.
delta(10, up(Floor, Floor2), 0.06267667380706547) :- above(Floor2, Floor3), toward_could_board(Floor, Floor3), above(Floor4, Floor3), could_board(Floor4), !.
delta(10, up(Floor, Floor2), -0.02106982140223561) :- above(Floor2, Floor3), toward_could_board(Floor, Floor3), !.
delta(10, up(Floor, Floor2), 0.016951059835966547) :- above(Floor3, Floor), toward_could_depart(Floor3, Floor2), !.
delta(10, up(_, _), -0.263973049565664) :- !.
delta(10, down(_, Floor), -0.01793924175007831) :- lift_at(Floor2), toward_could_board(Floor2, Floor), above(Floor, Floor3), could_depart(Floor3), !.
delta(10, down(_, Floor), 0.13713262211317293) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(10, down(Floor, Floor2), -0.024167227596291616) :- above(Floor3, Floor), toward_could_depart(Floor3, Floor2), fewer_lift_at_than_todo_served, !.
delta(10, down(Floor, Floor2), 0.04166881400796309) :- above(Floor3, Floor), toward_could_depart(Floor3, Floor2), !.
delta(10, down(Floor, Floor2), 0.007298380319560728) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), !.
delta(10, down(_, _), -0.3100588149186286) :- !.
delta(10, _, 0.0).

% tree 11: step size 1.0, 206 examples, 18 leaves
delta(11, board(_, _), 0.2643431671596909) :- !.
delta(11, depart(_, _), 0.14822490701095872) :- !.
delta(11, up(Floor, Floor2), -0.051835856390108515) :- above(Floor3, Floor2), toward_could_board(Floor, Floor3), origin(Passenger, Floor3), destin(Passenger, Floor2), !.
delta(11, up(Floor, Floor2), 0.16573698110116034) :- above(Floor3, Floor2), toward_could_board(Floor, Floor3), fewer_lift_at_than_todo_served, !.
delta(11, up(Floor, Floor2), -0.021566718281681652) :- above(Floor3, Floor2), toward_could_board(Floor, Floor3), !.
delta(11, up(Floor, Floor2), 0.005270351958102715) :- fewer_lift_at_than_todo_served, above(Floor2, Floor3), toward_could_depart(Floor3, Floor), !.
delta(11, up(_, _), -0.2984338803699411) :- fewer_lift_at_than_todo_served, !.
delta(11, up(_, Floor), 0.10335539486171227) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(11, up(_, _), -0.08332554597336443) :- !.
delta(11, down(Floor, Floor2), 0.013313361553515281) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), above(Floor, Floor4), could_board(Floor4), needed_lift_at_to_depart(Floor4), !.
delta(11, down(Floor, Floor2), -0.058365855900819295) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), above(Floor, Floor4), could_board(Floor4), !.
delta(11, down(_, Floor), -0.03039199930810023) :- lift_at(Floor2), toward_could_board(Floor2, Floor), above(Floor3, Floor), could_board(Floor3), !.
delta(11, down(_, Floor), 0.1286264588952778) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(11, down(Floor, Floor2), -0.016537366530671792) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), above(Floor4, Floor2), toward_could_depart(Floor4, Floor), !.
delta(11, down(Floor, Floor2), 0.04715403541754107) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), !.
delta(11, down(Floor, _), 0.029456547885420768) :- above(Floor, Floor2), toward_could_board(Floor, Floor2), !.
delta(11, down(_, _), -0.27060740310290154) :- !.
delta(11, _, 0.0).

% tree 12: step size 1.0, 203 examples, 19 leaves
delta(12, board(Floor, _), -0.06366777564420706) :- above(Floor2, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), above(Floor3, Floor2), toward_could_board(Floor3, Floor2), !.
delta(12, board(Floor, _), 0.01785192498307737) :- above(Floor2, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(12, board(_, _), 0.1746385062630525) :- !.
delta(12, depart(_, _), 0.19726185848595335) :- !.
delta(12, up(_, Floor), -0.07759709892592549) :- lift_at(Floor2), toward_could_board(Floor2, Floor), destin(Passenger, Floor), needed_boarded_to_depart(Passenger), !.
delta(12, up(Floor, Floor2), -0.008042165871409726) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), above(Floor4, Floor), toward_could_depart(Floor4, Floor), !.
delta(12, up(_, Floor), 0.34406884825159784) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(12, up(Floor, _), 0.006647857366502792) :- todo_served(Passenger), origin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(12, up(_, _), -0.31257902595720083) :- todo_served(Passenger), origin(Passenger, _), !.
delta(12, up(_, Floor), 0.1104163906147549) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(12, up(_, _), -0.14717725443389465) :- !.
delta(12, down(_, Floor), -0.10787265217012532) :- lift_at(Floor2), toward_could_board(Floor2, Floor), destin(Passenger, Floor), needed_boarded_to_depart(Passenger), !.
delta(12, down(Floor, Floor2), -0.017377813008818827) :- lift_at(Floor3), toward_could_board(Floor3, Floor2), above(Floor4, Floor2), toward_could_depart(Floor4, Floor), !.
delta(12, down(_, Floor), 0.2330693174082492) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(12, down(Floor, _), 0.06394941933541932) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), boarded(Passenger), destin(Passenger, Floor2), !.
delta(12, down(Floor, _), -0.01686522728640869) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(12, down(_, Floor), 0.02349744298334405) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(12, down(_, _), -0.3126854385077457) :- !.
delta(12, _, 0.0).

% tree 13: step size 1.0, 206 examples, 17 leaves
delta(13, board(Floor, _), 0.1205613526098568) :- above(Floor2, Floor), toward_could_board(Floor2, Floor), !.
delta(13, board(Floor, _), 0.007850273621870775) :- above(Floor, Floor2), origin(_, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(13, board(Floor, _), -0.0432576113149049) :- above(Floor, Floor2), origin(_, Floor2), !.
delta(13, board(_, _), 0.02681818718911295) :- !.
delta(13, depart(_, _), 0.175609530077484) :- !.
delta(13, up(Floor, Floor2), -0.039139878811253415) :- above(Floor, Floor3), toward_could_board(Floor3, Floor2), above(Floor3, Floor4), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor4, Floor2), !.
delta(13, up(Floor, Floor2), -0.021432674948697463) :- above(Floor, Floor3), toward_could_board(Floor3, Floor2), done_served(Passenger), destin(Passenger, Floor3), !.
delta(13, up(Floor, Floor2), 0.16485638913892922) :- above(Floor, Floor3), toward_could_board(Floor3, Floor2), !.
delta(13, up(Floor, _), -0.0026732299834112292) :- above(Floor2, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor2), todo_served(Passenger), boarded(Passenger), !.
delta(13, up(Floor, _), 0.024889673769436346) :- above(Floor2, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(13, up(_, Floor), 0.015323590111636929) :- above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(13, up(_, _), -0.24248848211833532) :- !.
delta(13, down(_, Floor), -0.16291891123990349) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(13, down(Floor, _), -0.10390972490726755) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(13, down(_, Floor), -0.07059062665021688) :- above(Floor, Floor2), toward_could_board(Floor, Floor2), !.
delta(13, down(_, _), 0.18476732999431408) :- !.
delta(13, _, 0.0).

% tree 14: step size 1.0, 215 examples, 15 leaves
delta(14, board(_, _), 0.13234514595181454) :- !.
delta(14, depart(_, _), 0.12117259491641369) :- !.
delta(14, up(_, Floor), -0.2543043427666432) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(14, up(_, Floor), 0.034616544766887705) :- above(Floor2, Floor), could_depart(Floor2), origin(Passenger, Floor), destin(Passenger, Floor2), !.
delta(14, up(_, Floor), -0.1145838363451075) :- above(Floor2, Floor), could_depart(Floor2), !.
delta(14, up(Floor, _), -0.051308929957424476) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(14, up(_, _), 0.2323424255004937) :- !.
delta(14, down(Floor, Floor2), -0.016367665026751396) :- above(Floor2, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor3, Floor4), needed_lift_at_to_depart(Floor4), !.
delta(14, down(Floor, Floor2), 0.13024305241781628) :- above(Floor2, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), todo_served(Passenger), origin(Passenger, Floor2), !.
delta(14, down(Floor, Floor2), -0.009682632811821313) :- above(Floor2, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), !.
delta(14, down(_, Floor), -0.03591805399983203) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), todo_served(Passenger), needed_boarded_to_depart(Passenger), !.
delta(14, down(_, Floor), 0.07503139186548448) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(14, down(Floor, Floor2), 0.009815821545619524) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(14, down(_, _), -0.22410956476452829) :- !.
delta(14, _, 0.0).

% tree 15: step size 1.0, 211 examples, 20 leaves
delta(15, board(_, _), 0.12626809235236838) :- !.
delta(15, depart(Floor, _), 0.01530315730377005) :- above(Floor, Floor2), toward_could_board(Floor2, Floor), above(Floor3, Floor), could_board(Floor3), !.
delta(15, depart(Floor, _), -0.027864317514533738) :- above(Floor, Floor2), toward_could_board(Floor2, Floor), todo_served(Passenger), destin(Passenger, Floor2), !.
delta(15, depart(Floor, _), 0.00013178826586016521) :- above(Floor, Floor2), toward_could_board(Floor2, Floor), !.
delta(15, depart(_, _), 0.10464228410844503) :- !.
delta(15, up(Floor, Floor2), 0.01496582044509431) :- above(Floor3, Floor2), above(Floor, Floor3), above(Floor, Floor4), above(Floor2, Floor4), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(15, up(Floor, Floor2), -0.1970859474211502) :- above(Floor3, Floor2), above(Floor, Floor3), above(Floor, Floor4), above(Floor2, Floor4), !.
delta(15, up(Floor, Floor2), 0.06281129307611999) :- above(Floor3, Floor2), above(Floor, Floor3), above(Floor3, Floor4), toward_could_board(Floor, Floor4), !.
delta(15, up(Floor, Floor2), -0.016392821069902173) :- above(Floor3, Floor2), above(Floor, Floor3), !.
delta(15, up(Floor, _), -0.0033234419456849153) :- above(Floor, Floor2), toward_could_board(Floor, Floor2), boarded(Passenger), destin(Passenger, Floor), !.
delta(15, up(Floor, _), 0.2953302591861609) :- above(Floor, Floor2), toward_could_board(Floor, Floor2), !.
delta(15, up(_, _), -0.07016125608242416) :- !.
delta(15, down(Floor, Floor2), -0.026860858946443834) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), above(Floor3, Floor4), could_depart(Floor4), !.
delta(15, down(Floor, Floor2), 0.07213749760811322) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), todo_served(Passenger), origin(Passenger, Floor2), !.
delta(15, down(Floor, Floor2), -0.00644387000489919) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), !.
delta(15, down(Floor, Floor2), 0.0072535561602251756) :- above(Floor2, Floor3), origin(_, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(15, down(_, Floor), -0.28036151319227615) :- above(Floor, Floor2), origin(_, Floor2), !.
delta(15, down(Floor, Floor2), 0.11789410885373254) :- above(Floor2, Floor3), toward_could_depart(Floor, Floor3), !.
delta(15, down(_, _), -0.1256274152650004) :- !.
delta(15, _, 0.0).

% tree 16: step size 1.0, 201 examples, 20 leaves
delta(16, board(Floor, _), -0.02702964462035119) :- goal_served(Passenger), done_served(Passenger), destin(Passenger2, Floor), needed_boarded_to_depart(Passenger2), !.
delta(16, board(_, _), 0.003968942367749513) :- goal_served(Passenger), done_served(Passenger), !.
delta(16, board(_, _), 0.07059787242664185) :- !.
delta(16, depart(_, _), 0.07151391633222172) :- !.
delta(16, up(Floor, Floor2), 0.025058353798941255) :- above(Floor3, Floor), toward_could_depart(Floor3, Floor2), above(Floor4, Floor2), needed_lift_at_to_depart(Floor4), could_board(Floor), !.
delta(16, up(Floor, Floor2), -0.26269246841360117) :- above(Floor3, Floor), toward_could_depart(Floor3, Floor2), above(Floor4, Floor2), needed_lift_at_to_depart(Floor4), !.
delta(16, up(Floor, Floor2), -0.008822192942563091) :- above(Floor3, Floor), toward_could_depart(Floor3, Floor2), destin(Passenger, Floor2), needed_boarded_to_depart(Passenger), !.
delta(16, up(Floor, Floor2), 0.09001377397373062) :- above(Floor3, Floor), toward_could_depart(Floor3, Floor2), !.
delta(16, up(_, Floor), 0.09285109500970569) :- above(Floor, Floor2), needed_lift_at_to_depart(Floor2), lift_at(Floor3), toward_could_board(Floor3, Floor2), !.
delta(16, up(_, Floor), -0.19386686872588632) :- above(Floor, Floor2), needed_lift_at_to_depart(Floor2), !.
delta(16, up(Floor, Floor2), -0.05083516859387346) :- above(Floor3, Floor), toward_could_board(Floor2, Floor3), !.
delta(16, up(_, _), 0.24125742288552562) :- !.
delta(16, down(Floor, Floor2), -0.012236980951166744) :- above(Floor2, Floor3), toward_could_depart(Floor, Floor3), fewer_lift_at_than_todo_served, above(Floor4, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor4), !.
delta(16, down(Floor, Floor2), 0.15395877198151733) :- above(Floor2, Floor3), toward_could_depart(Floor, Floor3), fewer_lift_at_than_todo_served, !.
delta(16, down(Floor, Floor2), -0.022737261970420277) :- above(Floor2, Floor3), toward_could_depart(Floor, Floor3), !.
delta(16, down(Floor, Floor2), 0.016118689141270764) :- above(Floor3, Floor), above(Floor3, Floor2), above(Floor4, Floor3), toward_could_depart(Floor2, Floor4), !.
delta(16, down(Floor, Floor2), -0.1724085320079292) :- above(Floor3, Floor), above(Floor3, Floor2), !.
delta(16, down(Floor, _), -0.02476942614015501) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(16, down(_, _), 0.03533958002114006) :- !.
delta(16, _, 0.0).

% tree 17: step size 1.0, 205 examples, 22 leaves
delta(17, board(Floor, Passenger), 0.018812612520211786) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), destin(Passenger, Floor3), toward_could_board(Floor3, Floor2), !.
delta(17, board(Floor, _), 0.005632831838218454) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), above(Floor3, Floor2), could_depart(Floor3), !.
delta(17, board(Floor, _), -0.10245374265966363) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(17, board(_, _), 0.08136534247994645) :- !.
delta(17, depart(Floor, _), -0.0990706273225385) :- above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(17, depart(_, _), 0.05325620959792984) :- !.
delta(17, up(Floor, Floor2), 0.02551712085869403) :- above(Floor3, Floor2), toward_could_board(Floor, Floor3), above(Floor4, Floor3), could_board_through_destin_back_for_todo_served_1_floor(Floor4), !.
delta(17, up(Floor, Floor2), 0.0003798303957535942) :- above(Floor3, Floor2), toward_could_board(Floor, Floor3), done_served(Passenger), destin(Passenger, Floor), !.
delta(17, up(Floor, Floor2), -0.26540142934958866) :- above(Floor3, Floor2), toward_could_board(Floor, Floor3), !.
delta(17, up(_, Floor), 0.004152305536574198) :- done_served(Passenger), destin(Passenger, Floor), boarded(Passenger2), destin(Passenger2, Floor), !.
delta(17, up(_, Floor), -0.06501326685648791) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(17, up(_, Floor), -0.026222991364713025) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(17, up(_, _), 0.28339743702247455) :- !.
delta(17, down(Floor, Floor2), 0.017544979505471053) :- above(Floor3, Floor), toward_could_board(Floor, Floor3), origin(Passenger, Floor3), destin(Passenger, Floor2), needed_lift_at_to_depart(Floor3), !.
delta(17, down(Floor, Floor2), -0.08297510686070679) :- above(Floor3, Floor), toward_could_board(Floor, Floor3), origin(Passenger, Floor3), destin(Passenger, Floor2), !.
delta(17, down(Floor, _), -0.01175140783760328) :- above(Floor2, Floor), toward_could_board(Floor, Floor2), todo_served(Passenger), destin(Passenger, Floor2), !.
delta(17, down(Floor, _), 0.24382825211694614) :- above(Floor2, Floor), toward_could_board(Floor, Floor2), !.
delta(17, down(_, Floor), 0.005186268955375999) :- fewer_lift_at_than_todo_served, above(Floor2, Floor), destin(_, Floor2), !.
delta(17, down(_, _), -0.18679978271743122) :- fewer_lift_at_than_todo_served, !.
delta(17, down(Floor, Floor2), -0.028277756744000522) :- above(Floor3, Floor), toward_could_depart(Floor2, Floor3), !.
delta(17, down(_, _), 0.0574918884444008) :- !.
delta(17, _, 0.0).

% tree 18: step size 1.0, 211 examples, 21 leaves
delta(18, board(Floor, Passenger), 0.007450633419235644) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), origin(Passenger, Floor3), could_depart(Floor3), !.
delta(18, board(Floor, _), -0.12239748396861896) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), above(Floor2, Floor3), needed_lift_at_to_depart(Floor3), !.
delta(18, board(Floor, _), 0.00023941399191448878) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(18, board(_, _), 0.07215545657799619) :- !.
delta(18, depart(_, _), 0.07895974641297202) :- !.
delta(18, up(_, Floor), 0.0) :- above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), above(Floor3, Floor), toward_could_board(Floor, Floor3), could_depart(Floor3), !.
delta(18, up(_, Floor), -0.008350082105903961) :- above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), above(Floor3, Floor), toward_could_board(Floor, Floor3), !.
delta(18, up(_, Floor), -0.00023552673354906284) :- above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), above(Floor3, Floor), could_depart(Floor3), !.
delta(18, up(_, Floor), 0.18740374633166654) :- above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(18, up(_, Floor), 0.0323193062211082) :- goal_served(Passenger), destin(Passenger, Floor), above(Floor, Floor2), toward_could_depart(Floor, Floor2), !.
delta(18, up(_, Floor), -0.27615686836819964) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(18, up(_, Floor), 0.08435123864330493) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(18, up(_, _), -0.05769991788769815) :- !.
delta(18, down(Floor, Floor2), -0.010355398453301015) :- above(Floor, Floor3), toward_could_depart(Floor, Floor3), above(Floor4, Floor), above(Floor4, Floor2), toward_could_board(Floor2, Floor3), !.
delta(18, down(Floor, Floor2), 0.19532101072272154) :- above(Floor, Floor3), toward_could_depart(Floor, Floor3), above(Floor4, Floor), above(Floor4, Floor2), !.
delta(18, down(Floor, _), -0.02813386551922018) :- above(Floor, Floor2), toward_could_depart(Floor, Floor2), goal_served(Passenger), done_served(Passenger), !.
delta(18, down(Floor, _), 0.01218208014828006) :- above(Floor, Floor2), toward_could_depart(Floor, Floor2), !.
delta(18, down(_, Floor), -0.1348929195505275) :- above(Floor, Floor2), origin(_, Floor2), !.
delta(18, down(_, Floor), -0.057874839339305484) :- above(Floor, Floor2), could_depart(Floor2), !.
delta(18, down(_, _), 0.08809522727868031) :- !.
delta(18, _, 0.0).

% tree 19: step size 1.0, 235 examples, 22 leaves
delta(19, board(Floor, Passenger), 0.003954566837357848) :- destin(Passenger, Floor2), origin(Passenger2, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor), destin(Passenger2, Floor), !.
delta(19, board(Floor, Passenger), -0.032782573592062235) :- destin(Passenger, Floor2), origin(_, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(19, board(_, Passenger), 0.009666446550405512) :- destin(Passenger, Floor), origin(_, Floor), !.
delta(19, board(_, _), 0.0717395625692266) :- !.
delta(19, depart(Floor, _), -0.024370532119664008) :- todo_served(Passenger), origin(Passenger, Floor), destin(Passenger, Floor2), above(Floor, Floor2), !.
delta(19, depart(Floor, _), 0.0001949032884214044) :- todo_served(Passenger), origin(Passenger, Floor), !.
delta(19, depart(_, _), 0.09518146918396833) :- !.
delta(19, up(Floor, Floor2), -0.009873903919390848) :- above(Floor, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), destin(Passenger, Floor2), needed_boarded_to_depart(Passenger), !.
delta(19, up(Floor, Floor2), -0.004312408447029191) :- above(Floor, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), lift_at(Floor4), toward_could_board(Floor2, Floor4), !.
delta(19, up(Floor, Floor2), 0.1369660631354181) :- above(Floor, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), !.
delta(19, up(Floor, Floor2), 0.011205949649141955) :- above(Floor3, Floor2), needed_lift_at_to_depart(Floor3), above(Floor4, Floor), toward_could_board(Floor2, Floor4), !.
delta(19, up(_, Floor), -0.25676827381432255) :- above(Floor2, Floor), needed_lift_at_to_depart(Floor2), !.
delta(19, up(_, Floor), -0.0518703633208995) :- above(Floor2, Floor), origin(_, Floor2), !.
delta(19, up(_, _), 0.04493634312482511) :- !.
delta(19, down(_, Floor), -0.03693598404444247) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), above(Floor2, Floor3), could_depart(Floor3), !.
delta(19, down(Floor, Floor2), 0.172490805813289) :- above(Floor2, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), above(Floor4, Floor), above(Floor2, Floor4), !.
delta(19, down(_, Floor), -0.014351917253454667) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(19, down(_, Floor), -0.02189011030633167) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), above(Floor, Floor3), could_board(Floor3), !.
delta(19, down(_, Floor), 0.055163337095359734) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(19, down(Floor, _), 0.033000236404996025) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(19, down(_, _), -0.133920868671894) :- !.
delta(19, _, 0.0).

% tree 20: step size 1.0, 202 examples, 18 leaves
delta(20, board(Floor, _), 7.695128200334392e-5) :- above(Floor2, Floor), toward_could_depart(Floor2, Floor), origin(Passenger, Floor), destin(Passenger, Floor2), !.
delta(20, board(Floor, _), -0.025545123566022867) :- above(Floor2, Floor), toward_could_depart(Floor2, Floor), !.
delta(20, board(_, _), 0.07686945292315032) :- !.
delta(20, depart(_, _), 0.04708094670876635) :- !.
delta(20, up(Floor, _), -0.017002745444906563) :- above(Floor2, Floor), destin(_, Floor2), could_board(Floor), !.
delta(20, up(Floor, Floor2), -0.010818386577388265) :- above(Floor3, Floor), destin(_, Floor3), toward_could_depart(Floor3, Floor2), !.
delta(20, up(Floor, _), 0.18959892517231353) :- above(Floor2, Floor), destin(_, Floor2), !.
delta(20, up(_, Floor), -0.019040196369640147) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), destin(Passenger, Floor), needed_boarded_to_depart(Passenger), !.
delta(20, up(_, Floor), 0.06169424680972389) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(20, up(_, Floor), 0.0) :- above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(20, up(_, _), -0.10825088575085506) :- !.
delta(20, down(Floor, Floor2), -0.005054796587968844) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), above(Floor2, Floor4), toward_could_board(Floor2, Floor4), !.
delta(20, down(Floor, Floor2), 1.5905096897912302e-6) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), todo_served(Passenger), origin(Passenger, Floor), !.
delta(20, down(Floor, Floor2), 0.08512521538284303) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), !.
delta(20, down(Floor, Floor2), -0.024113380814620285) :- above(Floor2, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), above(Floor, Floor4), could_depart(Floor4), !.
delta(20, down(_, Floor), 0.04945101575394963) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(20, down(_, _), -0.24164991604351477) :- !.
delta(20, _, 0.0).

% tree 21: step size 1.0, 201 examples, 19 leaves
delta(21, board(Floor, _), 0.020312100462669323) :- above(Floor2, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(21, board(Floor, _), -0.07747908590233128) :- above(Floor2, Floor), toward_could_board(Floor2, Floor), above(Floor2, Floor3), could_board_through_destin_back_for_todo_served_1_floor(Floor3), !.
delta(21, board(Floor, _), 0.010246909524623296) :- above(Floor2, Floor), toward_could_board(Floor2, Floor), !.
delta(21, board(_, _), 0.0074110347194144555) :- !.
delta(21, depart(_, _), 0.06224400038487003) :- !.
delta(21, up(Floor, Floor2), 0.02869044112026017) :- above(Floor2, Floor3), origin(_, Floor3), toward_could_depart(Floor, Floor2), !.
delta(21, up(_, Floor), -0.16259360076562215) :- above(Floor, Floor2), origin(_, Floor2), !.
delta(21, up(Floor, Floor2), -0.020861074929937235) :- goal_served(Passenger), destin(Passenger, Floor2), above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), !.
delta(21, up(_, Floor), 0.27317256168477966) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(21, up(Floor, _), 0.025015937494515156) :- above(Floor, Floor2), toward_could_board(Floor, Floor2), !.
delta(21, up(_, _), -0.06776766246889968) :- !.
delta(21, down(_, Floor), -0.02667456321398277) :- above(Floor2, Floor), needed_lift_at_to_depart(Floor2), above(Floor2, Floor3), toward_could_board(Floor2, Floor3), toward_could_depart(Floor, Floor2), !.
delta(21, down(_, Floor), 0.15315240163350183) :- above(Floor2, Floor), needed_lift_at_to_depart(Floor2), above(Floor2, Floor3), toward_could_board(Floor2, Floor3), !.
delta(21, down(Floor, Floor2), 0.017374076272265913) :- above(Floor3, Floor2), needed_lift_at_to_depart(Floor3), above(Floor, Floor4), could_depart(Floor4), !.
delta(21, down(_, Floor), -0.06662958722023718) :- above(Floor2, Floor), needed_lift_at_to_depart(Floor2), !.
delta(21, down(Floor, _), -0.219885336036069) :- above(Floor, Floor2), destin(_, Floor2), !.
delta(21, down(_, Floor), -0.027242753111203995) :- above(Floor, Floor2), toward_could_board(Floor, Floor2), !.
delta(21, down(_, _), 0.043637548969139) :- !.
delta(21, _, 0.0).

% tree 22: step size 1.0, 203 examples, 23 leaves
delta(22, board(Floor, Passenger), 0.003117038392629555) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), goal_served(Passenger2), done_served(Passenger2), !.
delta(22, board(Floor, Passenger), -0.02507120831044526) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(22, board(_, _), 0.033615271702978) :- !.
delta(22, depart(Floor, _), -0.014533845533507724) :- goal_served(Passenger), done_served(Passenger), above(Floor2, Floor), could_board(Floor2), !.
delta(22, depart(_, _), 0.00967426429884248) :- goal_served(Passenger), done_served(Passenger), !.
delta(22, depart(_, _), 0.03938076307697735) :- !.
delta(22, up(Floor, Floor2), 2.3289915528410533e-5) :- above(Floor, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), above(Floor4, Floor3), toward_could_depart(Floor2, Floor4), above(Floor4, Floor), !.
delta(22, up(Floor, Floor2), -0.018169417170669375) :- above(Floor, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), above(Floor4, Floor3), toward_could_depart(Floor2, Floor4), !.
delta(22, up(Floor, Floor2), -0.006420274279196259) :- above(Floor, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), above(Floor, Floor4), toward_could_depart(Floor2, Floor4), !.
delta(22, up(Floor, Floor2), 0.11800489478036437) :- above(Floor, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor3), !.
delta(22, up(Floor, Floor2), -0.03134312721116794) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor4, Floor2), above(Floor, Floor4), !.
delta(22, up(Floor, _), 0.042571063098675824) :- above(Floor2, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(22, up(_, Floor), -0.00020782398324703335) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(22, up(_, _), -0.19195011651091418) :- !.
delta(22, down(Floor, Floor2), -0.13189345677853265) :- above(Floor3, Floor2), toward_could_board(Floor3, Floor2), above(Floor2, Floor4), toward_could_depart(Floor2, Floor4), above(Floor4, Floor), !.
delta(22, down(_, Floor), 0.000606669684116105) :- above(Floor2, Floor), toward_could_board(Floor2, Floor), above(Floor, Floor3), toward_could_depart(Floor, Floor3), !.
delta(22, down(_, Floor), -0.028108153489975942) :- above(Floor2, Floor), toward_could_board(Floor2, Floor), destin(Passenger, Floor), needed_boarded_to_depart(Passenger), !.
delta(22, down(_, Floor), 0.07263125133492893) :- above(Floor2, Floor), toward_could_board(Floor2, Floor), !.
delta(22, down(_, Floor), -0.05082105900214023) :- above(Floor, Floor2), needed_lift_at_to_depart(Floor2), above(Floor, Floor3), toward_could_board(Floor2, Floor3), !.
delta(22, down(_, Floor), 0.22319628618709936) :- above(Floor, Floor2), needed_lift_at_to_depart(Floor2), !.
delta(22, down(_, _), -0.0519541230614001) :- fewer_lift_at_than_todo_served, !.
delta(22, down(_, _), 0.013058416724013729) :- !.
delta(22, _, 0.0).

% tree 23: step size 1.0, 228 examples, 22 leaves
delta(23, board(_, Passenger), 0.04751692026480952) :- destin(Passenger, Floor), above(Floor, _), !.
delta(23, board(Floor, _), -0.029507072858837722) :- above(Floor2, Floor), destin(_, Floor2), !.
delta(23, board(_, _), 0.007915172425008728) :- !.
delta(23, depart(_, _), 0.004404453135498534) :- todo_served(Passenger), origin(Passenger, Floor), could_depart(Floor), !.
delta(23, depart(_, _), -0.07572854189360718) :- todo_served(Passenger), origin(Passenger, _), !.
delta(23, depart(_, _), 0.01606276440229697) :- !.
delta(23, up(Floor, Floor2), 0.005491480355689182) :- above(Floor3, Floor2), toward_could_board(Floor3, Floor2), above(Floor4, Floor), toward_could_depart(Floor2, Floor4), above(Floor, Floor3), !.
delta(23, up(Floor, Floor2), -0.023900507054284172) :- above(Floor3, Floor2), toward_could_board(Floor3, Floor2), above(Floor4, Floor), toward_could_depart(Floor2, Floor4), !.
delta(23, up(Floor, Floor2), -0.011779969359825409) :- above(Floor3, Floor2), toward_could_board(Floor3, Floor2), origin(Passenger, Floor), destin(Passenger, Floor3), !.
delta(23, up(_, Floor), 0.1421935630514305) :- above(Floor2, Floor), toward_could_board(Floor2, Floor), !.
delta(23, up(Floor, Floor2), 0.06116246615311345) :- done_served(Passenger), destin(Passenger, Floor), above(Floor3, Floor2), toward_could_depart(Floor2, Floor3), !.
delta(23, up(Floor, _), -0.017289478661542068) :- done_served(Passenger), destin(Passenger, Floor), !.
delta(23, up(Floor, _), -0.0006304599180755194) :- above(Floor2, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(23, up(_, _), -0.2079453779334028) :- !.
delta(23, down(Floor, Floor2), 0.031515317647702414) :- above(Floor3, Floor), toward_could_board(Floor2, Floor3), above(Floor4, Floor2), toward_could_depart(Floor3, Floor4), could_depart(Floor2), !.
delta(23, down(Floor, Floor2), -0.004263822028783286) :- above(Floor3, Floor), toward_could_board(Floor2, Floor3), above(Floor4, Floor2), toward_could_depart(Floor3, Floor4), !.
delta(23, down(Floor, Floor2), -0.10576867235854656) :- above(Floor3, Floor), toward_could_board(Floor2, Floor3), above(Floor4, Floor), above(Floor2, Floor4), !.
delta(23, down(Floor, Floor2), 0.0037056021863089337) :- above(Floor3, Floor), toward_could_board(Floor2, Floor3), !.
delta(23, down(_, Floor), -0.04935097216421784) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(23, down(Floor, _), 0.2085152333417884) :- above(Floor2, Floor), above(_, Floor2), !.
delta(23, down(_, _), -0.01462009421967056) :- !.
delta(23, _, 0.0).

% tree 24: step size 1.0, 214 examples, 18 leaves
delta(24, board(_, _), 0.04276516797599958) :- !.
delta(24, depart(_, _), 0.03189593525214205) :- !.
delta(24, up(_, Floor), 0.026107841683295985) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), above(Floor2, Floor3), toward_could_depart(Floor2, Floor3), could_board(Floor), !.
delta(24, up(_, Floor), -0.005073190772425752) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), above(Floor2, Floor3), toward_could_depart(Floor2, Floor3), !.
delta(24, up(_, Floor), -0.17112203213006924) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), todo_served(Passenger), boarded(Passenger), !.
delta(24, up(_, Floor), 0.0039153097843610775) :- above(Floor, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(24, up(Floor, Floor2), 0.2505943288862131) :- goal_served(Passenger), destin(Passenger, Floor2), above(Floor, Floor3), could_depart(Floor3), !.
delta(24, up(_, Floor), -0.032442529392283405) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(24, up(Floor, _), 0.021372525354509852) :- above(Floor, Floor2), toward_could_board(Floor, Floor2), !.
delta(24, up(_, _), -0.08593043083006575) :- !.
delta(24, down(Floor, Floor2), -0.004725089415862635) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor4, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor4), !.
delta(24, down(Floor, Floor2), 0.10279464818712795) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), destin(Passenger, Floor3), needed_boarded_to_depart(Passenger), !.
delta(24, down(Floor, Floor2), -0.00129994857965661) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), !.
delta(24, down(Floor, Floor2), 0.05296850518548763) :- destin(Passenger, Floor), origin(Passenger, Floor3), above(Floor2, Floor3), !.
delta(24, down(Floor, _), -0.012565097580267493) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(24, down(_, Floor), -0.2344753670711066) :- above(Floor, Floor2), could_depart(Floor2), !.
delta(24, down(_, _), 0.01561703045677301) :- !.
delta(24, _, 0.0).

% tree 25: step size 1.0, 219 examples, 18 leaves
delta(25, board(_, _), 0.027758191872865278) :- !.
delta(25, depart(_, _), 0.060743375511794574) :- !.
delta(25, up(Floor, Floor2), -0.01371013291696034) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), above(Floor, Floor4), above(Floor2, Floor4), toward_could_board(Floor4, Floor2), !.
delta(25, up(Floor, Floor2), 0.19582603938659285) :- lift_at(Floor3), toward_could_depart(Floor3, Floor2), above(Floor, Floor4), above(Floor2, Floor4), !.
delta(25, up(_, Floor), -0.025875354495366865) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), fewer_lift_at_than_todo_served, !.
delta(25, up(_, Floor), 0.00497614341150112) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(25, up(Floor, Floor2), -0.196796369041702) :- above(Floor3, Floor2), above(Floor, Floor3), above(Floor, Floor4), above(Floor2, Floor4), !.
delta(25, up(Floor, Floor2), 0.00583859643846216) :- above(Floor3, Floor2), above(Floor, Floor3), !.
delta(25, up(_, _), 0.04705168911578131) :- todo_served(Passenger), origin(Passenger, _), !.
delta(25, up(_, _), -0.014088531049931357) :- !.
delta(25, down(Floor, _), 0.12030569497821147) :- above(Floor, Floor2), toward_could_depart(Floor2, Floor), above(Floor2, Floor3), could_depart(Floor3), !.
delta(25, down(Floor, Floor2), -0.011062205806331153) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor), above(Floor4, Floor), above(Floor4, Floor2), !.
delta(25, down(Floor, _), 0.0006592844765045086) :- above(Floor, Floor2), toward_could_depart(Floor2, Floor), !.
delta(25, down(Floor, Floor2), 0.012717577466959467) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), todo_served(Passenger), origin(Passenger, Floor2), !.
delta(25, down(Floor, Floor2), -0.004699518157073402) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), !.
delta(25, down(_, Floor), -0.17772880365736546) :- above(Floor, Floor2), destin(_, Floor2), !.
delta(25, down(_, _), 0.0035981749121343264) :- !.
delta(25, _, 0.0).

% tree 26: step size 1.0, 206 examples, 19 leaves
delta(26, board(Floor, _), -0.05803891395315802) :- destin(Passenger, Floor), origin(Passenger, Floor2), above(Floor, Floor2), !.
delta(26, board(Floor, _), 0.0021446397570620054) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(26, board(_, _), 0.032055877097451085) :- !.
delta(26, depart(_, _), 0.02082563216369564) :- !.
delta(26, up(Floor, Floor2), 0.018053887158424806) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor2, Floor4), could_board(Floor4), could_depart(Floor2), !.
delta(26, up(Floor, Floor2), -0.05459425875297282) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor2, Floor4), could_board(Floor4), !.
delta(26, up(Floor, Floor2), -0.005038978501885377) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor2, Floor4), could_depart(Floor4), !.
delta(26, up(Floor, Floor2), 0.09775443653145653) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), !.
delta(26, up(Floor, Floor2), 0.020315171082835218) :- above(Floor3, Floor2), above(Floor, Floor3), done_served(Passenger), destin(Passenger, Floor2), !.
delta(26, up(Floor, Floor2), -0.15508667628445683) :- above(Floor3, Floor2), above(Floor, Floor3), !.
delta(26, up(Floor, _), 0.05891260498927126) :- above(Floor2, Floor), toward_could_depart(Floor2, Floor), !.
delta(26, up(_, _), -0.0351091813503088) :- !.
delta(26, down(Floor, Floor2), 0.008145985662782379) :- above(Floor, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor3, Floor2), lift_at(Floor4), toward_could_depart(Floor4, Floor2), !.
delta(26, down(Floor, Floor2), -0.11568908206595058) :- above(Floor, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor3, Floor2), !.
delta(26, down(Floor, Floor2), 0.0005180363573687418) :- above(Floor3, Floor2), toward_could_depart(Floor3, Floor), above(Floor, Floor4), toward_could_board(Floor4, Floor), !.
delta(26, down(Floor, Floor2), -0.04592236756380932) :- above(Floor3, Floor2), toward_could_depart(Floor3, Floor), !.
delta(26, down(_, Floor), -0.028097241235808104) :- above(Floor2, Floor), toward_could_depart(Floor, Floor2), !.
delta(26, down(_, _), 0.2224949875035805) :- !.
delta(26, _, 0.0).

% tree 27: step size 1.0, 208 examples, 19 leaves
delta(27, board(Floor, _), 0.008168845534631075) :- above(Floor2, Floor), origin(_, Floor2), needed_lift_at_to_depart(Floor2), !.
delta(27, board(Floor, _), -0.08993796713356172) :- above(Floor2, Floor), origin(_, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(27, board(Floor, _), 0.0018722856688456705) :- above(Floor2, Floor), origin(_, Floor2), !.
delta(27, board(_, _), 0.02767510266244388) :- !.
delta(27, depart(_, _), 0.029446680843979393) :- !.
delta(27, up(Floor, Floor2), 0.07464226420486125) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor3, Floor2), above(Floor4, Floor2), toward_could_board(Floor3, Floor4), !.
delta(27, up(Floor, Floor2), 0.002772743440817632) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor3, Floor2), boarded(Passenger), destin(Passenger, Floor2), !.
delta(27, up(Floor, Floor2), -0.01646797522149059) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor3, Floor2), !.
delta(27, up(Floor, Floor2), -0.00046435413081720504) :- above(Floor3, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor2, Floor4), could_board(Floor4), !.
delta(27, up(Floor, _), 0.029417764830926185) :- above(Floor2, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(27, up(_, Floor), -0.1753465452639639) :- above(Floor2, Floor), origin(_, Floor2), !.
delta(27, up(_, _), 0.001819334038319792) :- !.
delta(27, down(Floor, Floor2), -0.010473385572565119) :- above(Floor3, Floor), toward_could_depart(Floor2, Floor3), above(Floor4, Floor2), toward_could_board(Floor4, Floor2), above(Floor3, Floor4), !.
delta(27, down(Floor, Floor2), 0.019298294652394805) :- above(Floor3, Floor), toward_could_depart(Floor2, Floor3), above(Floor4, Floor2), toward_could_board(Floor4, Floor2), !.
delta(27, down(Floor, Floor2), -0.05363729348483835) :- above(Floor3, Floor), toward_could_depart(Floor2, Floor3), !.
delta(27, down(_, Floor), -0.025815661965125906) :- above(Floor, Floor2), toward_could_board(Floor, Floor2), !.
delta(27, down(_, Floor), -0.008212917639660249) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(27, down(_, _), 0.17955714948113646) :- !.
delta(27, _, 0.0).

% tree 28: step size 1.0, 221 examples, 15 leaves
delta(28, board(_, _), 0.023976022387266524) :- !.
delta(28, depart(_, _), 0.03362188895772795) :- !.
delta(28, up(Floor, Floor2), -0.005134899799427746) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), above(Floor4, Floor), toward_could_board(Floor4, Floor2), fewer_lift_at_than_boarded, !.
delta(28, up(Floor, Floor2), 0.0199834627777348) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), above(Floor4, Floor), toward_could_board(Floor4, Floor2), !.
delta(28, up(Floor, Floor2), -0.11126996029575892) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), fewer_lift_at_than_todo_served, !.
delta(28, up(Floor, Floor2), 0.007882557765132433) :- above(Floor, Floor3), toward_could_depart(Floor3, Floor2), !.
delta(28, up(Floor, _), -0.016270253609983288) :- boarded(Passenger), destin(Passenger, Floor), !.
delta(28, up(Floor, Floor2), -0.014817359878241947) :- above(Floor, Floor3), toward_could_board(Floor2, Floor3), !.
delta(28, up(_, _), 0.14791791346421582) :- !.
delta(28, down(Floor, Floor2), 0.0537901326386198) :- lift_at(Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor3, Floor2), above(Floor4, Floor), toward_could_depart(Floor4, Floor2), !.
delta(28, down(_, Floor), -8.1041247731714e-5) :- lift_at(Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(28, down(Floor, _), -0.13476868917079232) :- above(Floor2, Floor), destin(_, Floor2), !.
delta(28, down(_, Floor), 0.025445055514253426) :- lift_at(Floor2), toward_could_board(Floor2, Floor), !.
delta(28, down(_, _), -0.010391369060802982) :- !.
delta(28, _, 0.0).

% tree 29: step size 1.0, 203 examples, 24 leaves
delta(29, board(Floor, _), 0.005842188136262146) :- above(Floor, Floor2), origin(_, Floor2), could_depart(Floor2), !.
delta(29, board(Floor, _), 0.0002539657714472754) :- above(Floor, Floor2), origin(_, Floor2), fewer_lift_at_than_boarded, !.
delta(29, board(Floor, _), -0.13671839188007445) :- above(Floor, Floor2), origin(_, Floor2), !.
delta(29, board(_, _), 0.06511628764723486) :- !.
delta(29, depart(Floor, _), 0.009100416797088406) :- above(Floor2, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(29, depart(Floor, _), -0.20076434933996243) :- above(Floor2, Floor), above(_, Floor2), fewer_lift_at_than_todo_served, !.
delta(29, depart(Floor, _), 0.0008548070390601399) :- above(Floor2, Floor), above(_, Floor2), !.
delta(29, depart(_, _), 0.0042042744718361075) :- !.
delta(29, up(Floor, Floor2), 0.025178064780051267) :- above(Floor2, Floor3), toward_could_board(Floor, Floor3), lift_at(Floor4), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor4, Floor2), !.
delta(29, up(Floor, Floor2), 0.0013019161977868737) :- above(Floor2, Floor3), toward_could_board(Floor, Floor3), above(Floor3, Floor4), toward_could_depart(Floor4, Floor2), !.
delta(29, up(Floor, Floor2), -0.15702696380160816) :- above(Floor2, Floor3), toward_could_board(Floor, Floor3), !.
delta(29, up(_, Floor), 0.00030818510251874847) :- above(Floor, Floor2), toward_could_depart(Floor, Floor2), todo_served(Passenger), origin(Passenger, Floor), !.
delta(29, up(_, Floor), -0.028934414024443876) :- above(Floor, Floor2), toward_could_depart(Floor, Floor2), !.
delta(29, up(_, Floor), -0.008523055407989073) :- could_board_through_destin_back_for_todo_served_1_floor(Floor), !.
delta(29, up(_, _), 0.28611028334581284) :- !.
delta(29, down(Floor, Floor2), 0.0) :- above(Floor3, Floor2), toward_could_depart(Floor3, Floor2), fewer_lift_at_than_boarded, origin(Passenger, Floor3), destin(Passenger, Floor), !.
delta(29, down(_, Floor), -0.1710529931593899) :- above(Floor2, Floor), toward_could_depart(Floor2, Floor), fewer_lift_at_than_boarded, !.
delta(29, down(_, Floor), -0.004761211004766971) :- above(Floor2, Floor), toward_could_depart(Floor2, Floor), above(Floor, Floor3), could_board(Floor3), !.
delta(29, down(_, Floor), 0.01148243757462617) :- above(Floor2, Floor), toward_could_depart(Floor2, Floor), !.
delta(29, down(Floor, Floor2), 0.06253156948667288) :- above(Floor2, Floor3), toward_could_depart(Floor, Floor3), above(Floor4, Floor2), could_depart(Floor4), !.
delta(29, down(Floor, Floor2), -0.09444998246715394) :- above(Floor2, Floor3), toward_could_depart(Floor, Floor3), !.
delta(29, down(_, Floor), 0.2908607679705044) :- above(Floor, Floor2), needed_lift_at_to_depart(Floor2), !.
delta(29, down(_, _), -0.02385768967044687) :- !.
delta(29, _, 0.0).

% tree 30: step size 1.0, 207 examples, 21 leaves
delta(30, board(Floor, Passenger), 0.0009196168817170452) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), above(Floor, Floor3), needed_lift_at_to_depart(Floor3), !.
delta(30, board(Floor, Passenger), -0.018171420812341067) :- destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(30, board(_, _), 0.028970563585005445) :- !.
delta(30, depart(_, _), 0.02358887449374793) :- lift_at(Floor), above(Floor, _), !.
delta(30, depart(Floor, _), -0.025587654177117582) :- above(Floor2, Floor), origin(_, Floor2), !.
delta(30, depart(_, _), 0.00206739729549707) :- !.
delta(30, up(Floor, Floor2), -0.04572378631805196) :- above(Floor, Floor3), toward_could_board(Floor2, Floor3), above(Floor4, Floor2), toward_could_board(Floor, Floor4), !.
delta(30, up(Floor, Floor2), 0.16995686680383457) :- above(Floor, Floor3), toward_could_board(Floor2, Floor3), todo_served(Passenger), destin(Passenger, Floor2), !.
delta(30, up(Floor, Floor2), -0.0032552325686027906) :- above(Floor, Floor3), toward_could_board(Floor2, Floor3), !.
delta(30, up(Floor, Floor2), -0.18214628017997547) :- above(Floor3, Floor2), above(Floor, Floor3), above(Floor4, Floor2), needed_lift_at_to_depart(Floor4), !.
delta(30, up(Floor, Floor2), 0.02054503243401308) :- above(Floor3, Floor2), above(Floor, Floor3), !.
delta(30, up(Floor, _), 0.07023065562698053) :- above(Floor, Floor2), could_depart(Floor2), !.
delta(30, up(_, _), -0.027672674046129025) :- !.
delta(30, down(Floor, Floor2), -0.017422012297590713) :- above(Floor3, Floor), toward_could_board(Floor, Floor3), destin(Passenger, Floor2), needed_boarded_to_depart(Passenger), !.
delta(30, down(Floor, Floor2), -0.015119249653554026) :- above(Floor3, Floor), toward_could_board(Floor, Floor3), above(Floor2, Floor3), !.
delta(30, down(Floor, _), 0.1350432985371926) :- above(Floor2, Floor), toward_could_board(Floor, Floor2), !.
delta(30, down(Floor, Floor2), -0.12398503934152105) :- above(Floor2, Floor3), needed_lift_at_to_depart(Floor3), above(Floor4, Floor), above(Floor4, Floor2), !.
delta(30, down(_, Floor), 0.008798540442357063) :- above(Floor, Floor2), needed_lift_at_to_depart(Floor2), !.
delta(30, down(_, Floor), 0.029878126315284345) :- lift_at(Floor2), toward_could_depart(Floor2, Floor), !.
delta(30, down(_, _), -0.007079690919930253) :- !.
delta(30, _, 0.0).

% tree 31: step size 1.0, 210 examples, 22 leaves
delta(31, board(Floor, _), 0.00040512407795701235) :- above(Floor2, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), above(Floor3, Floor), could_board_through_destin_back_for_todo_served_1_floor(Floor3), !.
delta(31, board(Floor, _), 0.0001619346244997128) :- above(Floor2, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), origin(Passenger, Floor), destin(Passenger, Floor2), !.
delta(31, board(Floor, _), -0.0765749737727064) :- above(Floor2, Floor), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(31, board(_, _), 0.023482594927089578) :- !.
delta(31, depart(Floor, _), 0.005087060656671031) :- above(Floor2, Floor), could_depart(Floor2), above(Floor3, Floor2), toward_could_depart(Floor3, Floor), !.
delta(31, depart(Floor, _), -0.059775003784207366) :- above(Floor2, Floor), could_depart(Floor2), !.
delta(31, depart(_, _), 0.026801531552315544) :- !.
delta(31, up(Floor, Floor2), 0.011299885889569691) :- above(Floor, Floor3), toward_could_depart(Floor2, Floor3), origin(Passenger, Floor2), destin(Passenger, Floor3), !.
delta(31, up(Floor, Floor2), 0.006768440673838252) :- above(Floor, Floor3), toward_could_depart(Floor2, Floor3), done_served(Passenger), destin(Passenger, Floor2), !.
delta(31, up(Floor, Floor2), -0.11131836770015839) :- above(Floor, Floor3), toward_could_depart(Floor2, Floor3), !.
delta(31, up(_, Floor), 0.0008471457538421856) :- destin(Passenger, Floor), origin(Passenger, _), fewer_lift_at_than_boarded, !.
delta(31, up(_, Floor), -0.02240104498266857) :- destin(Passenger, Floor), origin(Passenger, _), !.
delta(31, up(Floor, _), 0.1384684325564072) :- above(Floor, Floor2), above(Floor2, _), !.
delta(31, up(_, _), -0.0038871404522520703) :- !.
delta(31, down(Floor, Floor2), 0.035452089281376276) :- above(Floor2, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor, Floor4), toward_could_depart(Floor3, Floor4), !.
delta(31, down(Floor, Floor2), -0.1897419387843206) :- above(Floor2, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor3, Floor4), could_board(Floor4), !.
delta(31, down(Floor, Floor2), 0.0004579630439342334) :- above(Floor2, Floor3), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), !.
delta(31, down(Floor, Floor2), -0.0032900868244449947) :- above(Floor, Floor3), origin(Passenger, Floor3), destin(Passenger, Floor2), !.
delta(31, down(Floor, _), 0.23382150578470737) :- above(Floor, Floor2), origin(_, Floor2), !.
delta(31, down(Floor, _), -0.041201945459174445) :- above(Floor2, Floor), origin(_, Floor2), !.
delta(31, down(_, _), 0.020061768202960673) :- !.
delta(31, _, 0.0).

% tree 32: step size 1.0, 202 examples, 21 leaves
delta(32, board(Floor, Passenger), -0.021511999424463264) :- goal_served(Passenger2), done_served(Passenger2), destin(Passenger, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor2), !.
delta(32, board(_, _), 0.0014815084717381879) :- goal_served(Passenger), done_served(Passenger), !.
delta(32, board(_, _), 0.034468665559582536) :- !.
delta(32, depart(_, _), 0.016859859780735998) :- !.
delta(32, up(Floor, Floor2), -0.029833276686634824) :- goal_served(Passenger), destin(Passenger, Floor2), above(Floor3, Floor2), needed_lift_at_to_depart(Floor3), toward_could_board(Floor, Floor2), !.
delta(32, up(_, Floor), 0.2587651361239511) :- goal_served(Passenger), destin(Passenger, Floor), above(Floor2, Floor), needed_lift_at_to_depart(Floor2), !.
delta(32, up(_, Floor), -0.05595954781975682) :- goal_served(Passenger), destin(Passenger, Floor), fewer_lift_at_than_todo_served, !.
delta(32, up(_, Floor), 0.0051908605416718795) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(32, up(Floor, Floor2), 0.019094229530050515) :- lift_at(Floor3), toward_could_board(Floor2, Floor3), boarded(Passenger), destin(Passenger, Floor), !.
delta(32, up(_, Floor), -0.0026340046805878804) :- lift_at(Floor2), toward_could_board(Floor, Floor2), !.
delta(32, up(Floor, Floor2), 0.00805025173894137) :- origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(32, up(_, _), -0.16171870062710392) :- !.
delta(32, down(Floor, Floor2), -0.003181028969902984) :- above(Floor3, Floor2), destin(_, Floor3), toward_could_board(Floor2, Floor), needed_lift_at_to_depart(Floor2), !.
delta(32, down(Floor, Floor2), 0.02909169686646664) :- above(Floor3, Floor2), destin(_, Floor3), toward_could_board(Floor2, Floor), !.
delta(32, down(_, Floor), 0.014226208072043398) :- above(Floor2, Floor), destin(_, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor2, Floor), !.
delta(32, down(_, Floor), -0.1362687176285939) :- above(Floor2, Floor), destin(_, Floor2), !.
delta(32, down(Floor, Floor2), 0.0840140852954975) :- todo_served(Passenger), destin(Passenger, Floor2), above(Floor, _), !.
delta(32, down(_, Floor), -0.010215593550859773) :- todo_served(Passenger), destin(Passenger, Floor), !.
delta(32, down(Floor, _), 0.021559484347370882) :- above(Floor, Floor2), toward_could_depart(Floor, Floor2), !.
delta(32, down(_, _), -0.05951325497542834) :- !.
delta(32, _, 0.0).

% tree 33: step size 1.0, 201 examples, 19 leaves
delta(33, board(_, _), 0.03542330738764556) :- !.
delta(33, depart(_, _), 0.016747297569462985) :- !.
delta(33, up(_, Floor), -0.011044219569488303) :- above(Floor, Floor2), origin(Passenger, Floor2), destin(Passenger, Floor), could_board(Floor), !.
delta(33, up(_, Floor), 0.035708110592568745) :- above(Floor, Floor2), origin(Passenger, Floor2), destin(Passenger, Floor), !.
delta(33, up(_, Floor), 0.0004454912329894342) :- above(Floor, Floor2), origin(_, Floor2), toward_could_depart(Floor2, Floor), !.
delta(33, up(_, Floor), -0.16250673540339786) :- above(Floor, Floor2), origin(_, Floor2), !.
delta(33, up(Floor, Floor2), 0.1135651116645245) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), above(Floor4, Floor2), above(Floor3, Floor4), !.
delta(33, up(Floor, Floor2), -0.000532248974774825) :- above(Floor3, Floor2), toward_could_board_through_destin_back_for_todo_served_1_floor(Floor, Floor3), !.
delta(33, up(_, Floor), 0.02855922649333834) :- above(Floor, Floor2), above(Floor2, _), !.
delta(33, up(_, _), -0.07097270464839539) :- !.
delta(33, down(Floor, Floor2), -0.0018382855864960933) :- above(Floor3, Floor), toward_could_board(Floor2, Floor3), above(Floor4, Floor3), above(Floor2, Floor4), toward_could_depart(Floor2, Floor3), !.
delta(33, down(Floor, Floor2), 0.20700531018026744) :- above(Floor3, Floor), toward_could_board(Floor2, Floor3), above(Floor4, Floor3), above(Floor2, Floor4), !.
delta(33, down(Floor, Floor2), 0.0003836498876589399) :- above(Floor3, Floor), toward_could_board(Floor2, Floor3), above(Floor4, Floor3), toward_could_depart(Floor4, Floor), !.
delta(33, down(Floor, Floor2), -0.06739228138989826) :- above(Floor3, Floor), toward_could_board(Floor2, Floor3), !.
delta(33, down(Floor, Floor2), -0.14709957339814353) :- above(Floor2, Floor3), could_board_through_destin_back_for_todo_served_1_floor(Floor3), above(Floor, Floor4), above(Floor3, Floor4), !.
delta(33, down(_, Floor), 0.005171076047301372) :- above(Floor, Floor2), could_board_through_destin_back_for_todo_served_1_floor(Floor2), !.
delta(33, down(Floor, _), -0.01821289937396766) :- goal_served(Passenger), destin(Passenger, Floor), !.
delta(33, down(_, _), 0.041649716923225666) :- !.
delta(33, _, 0.0).
