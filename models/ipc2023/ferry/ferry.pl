:- module(ferry, []).

% The PDDL domain ferry. What no action changes is static: it belongs to the problem. So do its goals: goal_at(C, L)
% says that at(C, L) is wanted, condition/1 has what is wanted beyond such facts, and goals/1 says how many literals
% that is in all.

:- pddl('domain.pddl').
:- static car/1, location/1, goal_at/2, goals/1, condition/1.
:- fluent at_ferry/1, at/2, empty_ferry/0, on/1.
:- dead_ends.
:- discontiguous action/1, effect/3.

% sail
action(sail(From, To)) :- at_ferry(From), location(To), \+ at_ferry(To).
effect(sail(From, To), [at_ferry(From)], [at_ferry(To)]).

% board
action(board(Car, Loc)) :- empty_ferry, at_ferry(Loc), at(Car, Loc).
effect(board(Car, Loc), [at(Car, Loc), empty_ferry], [on(Car)]).

% debark
action(debark(Car, Loc)) :- on(Car), at_ferry(Loc).
effect(debark(Car, Loc), [on(Car)], [at(Car, Loc), empty_ferry]).

goal :- \+ ( goal_at(C, L), \+ at(C, L) ), \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_at(C, L) :- goal_at(C, L), \+ at(C, L).
done_at(C, L) :- goal_at(C, L), at(C, L).

% derived from the types and the actions
needed_on_to_debark(Car) :- todo_at(Car, _Location), \+ on(Car).
needed_at_ferry_to_debark(Location) :- todo_at(_Car, Location), \+ at_ferry(Location).
could_board(Location) :- empty_ferry, at(Car, Location), \+ on(Car).
could_board_needed_on_to_debark(Location) :- empty_ferry, at(Car, Location), needed_on_to_debark(Car).
could_board_for_todo_at_any_location(Location) :-
    empty_ferry,
    todo_at(_Car, Location),
    once(( at(Car2, Location), \+ on(Car2) )).
could_debark(Location) :- on(Car), \+ at(Car, Location).
could_debark_todo_at(Location) :- todo_at(Car, Location), on(Car).
could_debark_for_todo_at_any_location(Location) :- todo_at(_Car, Location), once(( on(Car2), \+ at(Car2, Location) )).
