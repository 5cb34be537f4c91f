:- module(corridor, []).

% The corridor of Kersting and Driessens (2008): a real position between two exits, and steps that go astray. The
% paper prints noise from N(1,1), under which it is best to go right from 1.25 on; its figure fits N(0,1), under which
% the middle parts left from right.

:- fluent pos/1.
:- parameter(length, 10.0).
:- parameter(step, 1.0).
:- parameter(noise_mean, 0.0).
:- parameter(noise_sd, 1.0).
:- parameter(step_reward, -1.0).
:- parameter(exit_reward, 20.0).

action(left).
action(right).

effect(Action, [pos(X)], [pos(Y)]) :-
    pos(X),
    step(Action, Sign),
    parameter(step, Step),
    parameter(noise_mean, Mean),
    parameter(noise_sd, Deviation),
    random_normal(Mean, Deviation, Noise),
    Y is X + Sign * Step + Noise.

step(left, -1).
step(right, 1).

% Outside.

goal :- pos(X), ( X < 0 ; parameter(length, Length), X > Length ).

reward(_, Reward) :- goal -> parameter(exit_reward, Reward) ; parameter(step_reward, Reward).

% Also who walks at random leaves in about 15 steps from the middle.

horizon(200).

start([pos(X)]) :- parameter(length, Length), random(Share), X is Share * Length.

% The position to a cell of a character.

picture([Line]) :-
    pos(X),
    parameter(length, Length),
    Cell is max(-1, min(60, floor(60 * X / Length))),
    findall(Character, ( between(-1, 60, I), drawn(I, Cell, Character) ), Characters),
    atomic_list_concat(Characters, Line).

drawn(Cell, Cell, 'R') :- !.
drawn(I, _, ' ')       :- ( I < 0 ; I > 59 ), !.
drawn(_, _, '.').

shapes([ line(0, 0, Length, 0, wall), line(0, -0.4, 0, 0.4, wanted), line(Length, -0.4, Length, 0.4, wanted),
         text(Middle, -1, 'exits at both ends'), disc(X, 0, 0.3, agent, '')|Marks]) :-
    pos(X),
    parameter(length, Length),
    Middle is Length / 2,
    Last is floor(Length),
    findall(text(I, -0.45, I), between(0, Last, I), Marks).
