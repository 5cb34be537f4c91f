:- module(blocks_world, []).

% Blocks on a table, the task on(A, B): stack block A on block B in as few moves as possible.

:- fluent on/2, goal_on/2.
:- parameter(blocks, 10).
:- interchangeable block/1.
:- uniform_start.

block(X) :- on(X, _).

clear(X) :- on(X, _), \+ on(_, X).

above(X, Y) :- on(X, Z), ( Z = Y ; above(Z, Y) ).

% compheight(X, Y, C): X compared with Y is higher, same or lower above the floor, which is lowest.

compheight(floor, Y, C) :- !, ( Y == floor -> C = same ; C = lower ).
compheight(_, floor, C) :- !, C = higher.
compheight(X, Y, C)     :- on(X, BelowX), on(Y, BelowY), compheight(BelowX, BelowY, C).

action(move(X, floor)) :- clear(X), \+ on(X, floor).
action(move(X, Y))     :- clear(X), clear(Y), X \== Y.

effect(move(X, Y), [on(X, Z)], [on(X, Y)]) :- on(X, Z).

goal :- goal_on(A, B), on(A, B).

% The minimal number of moves: clear A and B, then move A. Moves above both count once.

horizon(Moves) :-
    goal_on(A, B),
    burden(A, OnA),
    burden(B, OnB),
    (   on(A, B)              -> Moves = 0
    ;   same_tower(A, B)      -> Moves is max(OnA, OnB) + 1
    ;   Moves is OnA + OnB + 1
    ).

burden(X, Count) :- aggregate_all(count, above(_, X), Count).

same_tower(A, B) :- above(A, B), !.
same_tower(A, B) :- above(B, A).

% The optimal moves: A onto B where both are clear, else a block in the way to where it is in nobody's way.

expert(move(A, B)) :- goal_on(A, B), clear(A), clear(B).
expert(move(X, Y)) :- in_the_way(X), action(move(X, Y)), \+ goal_block(Y), \+ in_the_way(Y).

in_the_way(X) :- goal_block(Y), above(X, Y).

goal_block(X) :- goal_on(A, B), ( X = A ; X = B ).

% A uniformly random state and goal in which the goal does not hold yet. The number of towers has the weight
% of the states with so many towers; blocks in random order are then cut at random places into that many.

start([goal_on(A, B)|Facts]) :-
    parameter(blocks, N),
    N >= 2,
    numlist(1, N, Numbers),
    findall(Block, ( member(I, Numbers), atom_concat(b, I, Block) ), Blocks),
    findall(Towers-Weight, ( member(Towers, Numbers), weight(N, Towers, Weight) ), Weighted),
    repeat,
    random_permutation(Blocks, Row),
    towers(Weighted, Towers),
    bottoms(N, Towers, Bottoms),
    stacked(Row, 1, Bottoms, floor, Facts),
    random_permutation(Blocks, [A, B|_]),
    \+ memberchk(on(A, B), Facts),
    !.

% C(n-1, m-1) n! / m! states of n blocks have m towers.

weight(N, Towers, Weight) :-
    N1 is N - 1,
    Towers1 is Towers - 1,
    binomial(N1, Towers1, Compositions),
    factorial(N, FN),
    factorial(Towers, FT),
    Weight is Compositions * FN // FT.

binomial(N, K, C) :- factorial(N, FN), factorial(K, FK), R is N - K, factorial(R, FR), C is FN // (FK * FR).

factorial(0, 1) :- !.
factorial(N, F) :- N1 is N - 1, factorial(N1, F1), F is N * F1.

towers(Weighted, Towers) :-
    aggregate_all(sum(Weight), member(_-Weight, Weighted), Sum),
    random(U),
    Threshold is U * Sum,
    heavier(Weighted, Threshold, Towers).

heavier([Towers-Weight|Rest], Threshold, Chosen) :-
    (   ( Rest == [] ; Threshold < Weight ) -> Chosen = Towers
    ;   Below is Threshold - Weight,
        heavier(Rest, Below, Chosen)
    ).

% The positions in the row at which a new tower starts: the first, and a random choice of the others.

bottoms(N, Towers, [1|Bottoms]) :-
    findall(I, between(2, N, I), Places),
    random_permutation(Places, Shuffled),
    Towers1 is Towers - 1,
    length(Chosen, Towers1),
    append(Chosen, _, Shuffled),
    !,
    sort(Chosen, Bottoms).

stacked([], _, _, _, []).
stacked([Block|Row], I, Bottoms, Below, [on(Block, Under)|Facts]) :-
    (   Bottoms = [I|Later] -> Under = floor
    ;   Later = Bottoms, Under = Below
    ),
    Next is I + 1,
    stacked(Row, Next, Later, Block, Facts).

% The towers, each from the floor up.

parts(Towers) :- findall(Tower, ( on(Bottom, floor), tower(Bottom, Tower) ), Towers).

tower(Block, [Block|Above]) :- on(Next, Block), !, tower(Next, Above).
tower(Block, [Block]).

% The towers side by side, and the goal.

picture(Lines) :-
    goal_on(A, B),
    parts(Towers),
    aggregate_all(max(Height), ( member(Tower, Towers), length(Tower, Height) ), Highest),
    findall(Line, ( between(1, Highest, Down), Level is Highest - Down, row(Towers, Level, Line) ), Rows),
    format(atom(Goal), 'goal: ~w on ~w', [A, B]),
    append(Rows, [Goal], Lines).

row(Towers, Level, Line) :-
    findall(Cell, ( member(Tower, Towers), cell(Tower, Level, Cell) ), Cells),
    atomic_list_concat(Cells, Line).

cell(Tower, Level, Cell) :-
    (   nth0(Level, Tower, Block) -> true ; Block = '' ),
    format(atom(Cell), '~w~t~5|', [Block]).
