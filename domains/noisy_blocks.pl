:- module(noisy_blocks, []).

% Blocks on a table before a bad camera: stack block A on block B. It shows which blocks stand in one tower, but not
% how, and which of them are clear, which it gets wrong with probability `noise`, for each block and at each look anew.
% So that nothing else tells which blocks are clear, any move may be tried, and an impossible one changes nothing.

:- fluent on/2, goal_on/2, together/2, looks_clear/1.
:- parameter(blocks, 5).
:- parameter(noise, 0.1).
:- parameter(slack, 1).

block(X) :- on(X, _).

clear(X) :- on(X, _), \+ on(_, X).

above(X, Y) :- on(X, Z), ( Z = Y ; above(Z, Y) ).

same_tower(X, Y) :- above(X, Y).
same_tower(X, Y) :- above(Y, X).

action(move(X, floor)) :- block(X).
action(move(X, Y))     :- block(X), block(Y), X \== Y.

effect(move(X, Y), Delete, Add) :-
    (   clear(X), ( Y == floor ; clear(Y) )
    ->  on(X, Z), Delete = [on(X, Z)], Add = [on(X, Y)]
    ;   Delete = [], Add = []
    ).

goal :- goal_on(A, B), on(A, B).

% What the camera shows.

observation([goal_on(A, B)|Facts]) :-
    goal_on(A, B),
    findall(together(X, Y), ( block(X), block(Y), X \== Y, same_tower(X, Y) ), Pairs),
    findall(looks_clear(X), ( block(X), looks_clear_now(X) ), Clear),
    append(Pairs, Clear, Facts).

looks_clear_now(X) :-
    parameter(noise, Noise),
    random(Float),
    (   Float < Noise -> \+ clear(X) ; clear(X) ).

% As many as it takes where all is seen, and some to make mistakes good.

horizon(Steps) :-
    goal_on(A, B),
    burden(A, OnA),
    burden(B, OnB),
    parameter(slack, Slack),
    (   same_tower(A, B) -> Steps is max(OnA, OnB) + 1 + Slack
    ;   Steps is OnA + OnB + 1 + Slack
    ).

burden(X, Count) :- aggregate_all(count, above(_, X), Count).

expert(move(A, B))     :- goal_on(A, B), clear(A), clear(B).
expert(move(X, floor)) :- goal_on(A, B), clear(X), ( above(X, A) ; above(X, B), X \== A ).
expert(move(A, floor)) :- goal_on(A, B), clear(A), above(A, B).

% Each block is put onto the floor or onto a tower, as likely as not, until that is no goal.

start([goal_on(A, B)|Facts]) :-
    parameter(blocks, N),
    findall(Block, ( between(1, N, I), atom_concat(b, I, Block) ), Blocks),
    repeat,
    random_permutation(Blocks, [A, B|Rest]),
    random_permutation([A, B|Rest], Row),
    foldl(put, Row, []-[], Facts-_),
    \+ memberchk(on(A, B), Facts),
    !.

put(Block, Facts-Tops, [on(Block, Place)|Facts]-[Block|Others]) :-
    random_member(Place, [floor|Tops]),
    ( selectchk(Place, Tops, Others) -> true ; Others = Tops ).

picture(Lines) :-
    findall(Line, ( on(Bottom, floor), tower(Bottom, Tower), atomic_list_concat(Tower, ' ', Line) ), Towers),
    goal_on(A, B),
    format(atom(Goal), 'goal: ~w on ~w', [A, B]),
    append(Towers, [Goal], Lines).

tower(Block, [Block|Above]) :- on(Next, Block), !, tower(Next, Above).
tower(Block, [Block]).
