:- module(gripper, []).

% A robot with two grippers carries balls from one room into the other.

:- fluent robot/1, at/2, free/1, carry/2.
:- parameter(balls, 3).

room(rooma).
room(roomb).

action(move(From, To)) :- robot(From), room(To), To \== From.
action(pick(B, R, G))  :- robot(R), at(B, R), free(G).
action(drop(B, R, G))  :- robot(R), carry(B, G).

effect(move(From, To), [robot(From)], [robot(To)]).
effect(pick(B, R, G), [at(B, R), free(G)], [carry(B, G)]).
effect(drop(B, R, G), [carry(B, G)], [at(B, R), free(G)]).

goal :- \+ carry(_, _), \+ at(_, rooma).

reward(_, R) :- goal -> R = 1 ; R = 0.

horizon(N) :- parameter(balls, Balls), N is 6*Balls+2.

start([robot(rooma), free(left), free(right)|Balls]) :-
    parameter(balls, Most),
    random_between(1, Most, N),
    numlist(1, N, Numbers),
    findall(at(B, rooma), ( member(I, Numbers), atom_concat(ball, I, B) ), Balls).
