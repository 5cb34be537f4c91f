:- module(blocks_world, []).

% Blocks on a table. The task is to be done in as few moves as possible: on: stack block A on block B;
% stack: put all blocks into one tower; unstack: put all blocks on the floor.

:- fluent on/2, goal_on/2.
:- parameter(blocks, 10).
:- parameter(task, on).
:- interchangeable block/1.
:- uniform_start.

block(X) :- on(X, _).

clear(X) :- on(X, _), \+ on(_, X).

above(X, Y) :- on(X, Z), ( Z = Y ; above(Z, Y) ).

% compheight(X, Y, C): X compared with Y is higher, same or lower above the floor, which is lowest.

compheight(X, Y, C) :- place(X), place(Y), compared(X, Y, C).

compared(floor, Y, C) :- !, ( Y == floor -> C = same ; C = lower ).
compared(_, floor, C) :- !, C = higher.
compared(X, Y, C)     :- on(X, BelowX), on(Y, BelowY), compared(BelowX, BelowY, C).

place(floor).
place(X) :- block(X).

action(move(X, floor)) :- clear(X), \+ on(X, floor).
action(move(X, Y))     :- clear(X), clear(Y), X \== Y.

effect(move(X, Y), [on(X, Z)], [on(X, Y)]) :- on(X, Z).

goal :- parameter(task, Task), goal(Task).

goal(on)      :- goal_on(A, B), on(A, B).
goal(stack)   :- towers(1).
goal(unstack) :- \+ raised(_).

towers(Count) :- aggregate_all(count, on(_, floor), Count).

raised(X) :- on(X, Y), Y \== floor.

% The minimal number of moves.

horizon(Moves) :- parameter(task, Task), moves(Task, Moves).

% Clear A and B, then move A. Moves above both count once.

moves(on, Moves) :-
    goal_on(A, B),
    burden(A, OnA),
    burden(B, OnB),
    (   on(A, B)              -> Moves = 0
    ;   same_tower(A, B)      -> Moves is max(OnA, OnB) + 1
    ;   Moves is OnA + OnB + 1
    ).

% A move makes the highest tower higher by one block at most.

moves(stack, Moves) :-
    aggregate_all(count, block(_), Blocks),
    aggregate_all(max(Height), height(_, Height), Highest),
    Moves is Blocks - Highest.

moves(unstack, Moves) :- aggregate_all(count, raised(_), Moves).

height(floor, 0).
height(X, Height) :- on(X, Y), height(Y, Below), Height is Below + 1.

burden(X, Count) :- aggregate_all(count, above(_, X), Count).

same_tower(A, B) :- above(A, B), !.
same_tower(A, B) :- above(B, A).

% The optimal moves. on: A onto B where both are clear, else a block in the way to where it is in nobody's way;
% stack: onto a highest tower; unstack: to the floor.

expert(Move) :- parameter(task, Task), optimal(Task, Move).

optimal(on, move(A, B))          :- goal_on(A, B), clear(A), clear(B).
optimal(on, move(X, Y))          :- in_the_way(X), action(move(X, Y)), \+ goal_block(Y), \+ in_the_way(Y).
optimal(stack, move(X, Y))       :- action(move(X, Y)), \+ compheight(_, Y, higher).
optimal(unstack, move(X, floor)) :- action(move(X, floor)).

in_the_way(X) :- goal_block(Y), above(X, Y).

goal_block(X) :- goal_on(A, B), ( X = A ; X = B ).

% A uniformly random state in which the goal does not hold yet, for the task on with a random goal. The number of
% towers has the weight of the states with so many towers; blocks in random order are then cut at random places
% into that many.

start(Facts) :-
    parameter(task, Task),
    must_be(oneof([on, stack, unstack]), Task),
    parameter(blocks, N),
    N >= 2,
    numlist(1, N, Numbers),
    findall(Block, ( member(I, Numbers), atom_concat(b, I, Block) ), Blocks),
    findall(Towers-Weight, ( member(Towers, Numbers), \+ done(Task, N, Towers), weight(N, Towers, Weight) ), Weighted),
    repeat,
    random_permutation(Blocks, Row),
    towers(Weighted, Towers),
    bottoms(N, Towers, Bottoms),
    stacked(Row, 1, Bottoms, floor, Placed),
    with_goal(Task, Blocks, Placed, Facts),
    !.

% done(Task, N, Towers): N blocks in so many towers are a goal.

done(stack, _, 1).
done(unstack, N, N).

with_goal(on, Blocks, Facts, [goal_on(A, B)|Facts]) :-
    random_permutation(Blocks, [A, B|_]),
    \+ memberchk(on(A, B), Facts).
with_goal(stack, _, Facts, Facts).
with_goal(unstack, _, Facts, Facts).

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
    Threshold is rational(U) * Sum,         % exact: a float cannot hold the number of states of many blocks
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

% The towers, each from the floor up. Sorted: the order of the facts is that in which they came to hold.

parts(Sorted) :-
    findall(Tower, ( on(Bottom, floor), tower(Bottom, Tower) ), Towers),
    sort(Towers, Sorted).

tower(Block, [Block|Above]) :- on(Next, Block), !, tower(Next, Above).
tower(Block, [Block]).

% The towers side by side, and the goal.

picture(Lines) :-
    parts(Towers),
    aggregate_all(max(Height), ( member(Tower, Towers), length(Tower, Height) ), Highest),
    findall(Line, ( between(1, Highest, Down), Level is Highest - Down, row(Towers, Level, Line) ), Rows),
    parameter(task, Task),
    told(Task, Goal),
    append(Rows, [Goal], Lines).

told(on, Goal) :- goal_on(A, B), format(atom(Goal), 'goal: ~w on ~w', [A, B]).
told(stack, 'goal: all blocks in one tower').
told(unstack, 'goal: all blocks on the floor').

row(Towers, Level, Line) :-
    findall(Cell, ( member(Tower, Towers), cell(Tower, Level, Cell) ), Cells),
    atomic_list_concat(Cells, Line).

cell(Tower, Level, Cell) :-
    (   nth0(Level, Tower, Block) -> true ; Block = '' ),
    format(atom(Cell), '~w~t~5|', [Block]).

% The same as shapes: each tower stands where its lowest block has its place, so that a move moves nothing else.

shapes([line(-0.2, 0, Right, 0, faint), text(Middle, -0.7, Goal)|Boxes]) :-
    parts(Towers),
    append(Towers, Unsorted),
    length(Unsorted, Count),
    sort(Unsorted, Blocks),
    findall(box(X, Level, 1, 1, Tone, Block),
            ( member(Tower, Towers), Tower = [Bottom|_], nth0(Place, Blocks, Bottom), X is 1.25 * Place,
              nth0(Level, Tower, Block), tone(Block, Tone) ),
            Boxes),
    Right is 1.25 * Count,
    Middle is Right / 2,
    parameter(task, Task),
    told(Task, Goal).

tone(Block, Tone) :- ( goal_on(Block, _) ; goal_on(_, Block) ) -> Tone = wanted ; Tone = object.
