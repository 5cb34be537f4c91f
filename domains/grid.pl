:- module(grid, []).

% A finite grid: two rooms, parted by a wall with a door in its lowest row, a goal in the upper right corner and a pit
% below it. A step goes astray to either side with the probability slip / 2, and one against a wall stays where it is.
% (Kersting and Driessens, 2008, have a finite grid world beside their corridor, whose details are unknown: this is
% not theirs.)

:- fluent x/1, y/1.
:- parameter(width, 9).
:- parameter(height, 6).
:- parameter(slip, 0.2).
:- parameter(step_reward, -0.02).
:- uniform_start.

action(north).
action(east).
action(south).
action(west).

effect(Action, P, [x(X), y(Y)], [x(X1), y(Y1)]) :-
    x(X),
    y(Y),
    course(Action, P, Direction),
    step(Direction, DX, DY),
    X0 is X + DX,
    Y0 is Y + DY,
    (   cell(X0, Y0) -> X1 = X0, Y1 = Y0 ; X1 = X, Y1 = Y ).

course(Action, P, Direction) :-
    parameter(slip, Slip),
    (   P is 1 - Slip, Direction = Action
    ;   P is Slip / 2, beside(Action, Direction)
    ),
    P > 0.

beside(Action, Direction) :- member(Action, [north, south]), member(Direction, [east, west]).
beside(Action, Direction) :- member(Action, [east, west]), member(Direction, [north, south]).

step(north, 0, 1).
step(east, 1, 0).
step(south, 0, -1).
step(west, -1, 0).

cell(X, Y) :-
    parameter(width, Width),
    parameter(height, Height),
    between(1, Width, X),
    between(1, Height, Y),
    \+ wall(X, Y).

% The wall is one cell thick and leaves the lowest row open.

wall(X, Y) :- parameter(width, Width), X is (Width + 1) // 2, Y > 1.

goal     :- parameter(width, X), parameter(height, Y), x(X), y(Y).
terminal :- parameter(width, X), pit(Y), x(X), y(Y).

pit(Y) :- parameter(height, Height), Y is Height - 1.

reward(_, R) :- goal -> R = 1 ; terminal -> R = -1 ; parameter(step_reward, R).

% A way along the walls takes twice the sum of both sides at most.

horizon(Steps) :- parameter(width, Width), parameter(height, Height), Steps is 4 * (Width + Height).

% The right room has to be two columns wide for a way around the pit.

start([x(X), y(Y)]) :-
    parameter(width, Width),
    parameter(height, Height),
    Width >= 4,
    Height >= 2,
    findall(X-Y, free(X, Y), Cells),
    random_member(X-Y, Cells).

free(X, Y) :-
    cell(X, Y),
    parameter(width, Width),
    pit(Pit),
    \+ ( X =:= Width, Y >= Pit ).

picture(Lines) :-
    parameter(width, Width),
    parameter(height, Height),
    findall(Line,
            ( between(1, Height, Down), Y is Height + 1 - Down,
              findall(Character, ( between(1, Width, X), drawn(X, Y, Character) ), Characters),
              atomic_list_concat(Characters, ' ', Line) ),
            Lines).

drawn(X, Y, 'R') :- x(X), y(Y), !.
drawn(X, Y, '#') :- wall(X, Y), !.
drawn(X, Y, '.') :- free(X, Y), !.
drawn(_, Y, Sign) :- pit(Y) -> Sign = 'O' ; Sign = 'G'.

shapes(Shapes) :-
    parameter(width, Width),
    parameter(height, Height),
    x(AtX),
    y(AtY),
    findall(box(X, Y, 1, 1, Tone, Text),
            ( between(1, Height, Y), between(1, Width, X), kind(X, Y, Tone, Text) ),
            Cells),
    MiddleX is AtX + 0.5,
    MiddleY is AtY + 0.5,
    append(Cells, [disc(MiddleX, MiddleY, 0.32, agent, '')], Shapes).

kind(X, Y, wall, '')  :- wall(X, Y), !.
kind(X, Y, place, '') :- free(X, Y), !.
kind(_, Y, Tone, Text) :- pit(Y) -> Tone = danger, Text = pit ; Tone = wanted, Text = goal.
