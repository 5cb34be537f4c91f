:- module(rover, []).

% A rover on a line brings the wanted ones of some rocks to its base, as many at a time as its load limit allows. Its
% battery drains with the distance, and the faster the more it carries; half-way along the line it can be charged. A
% capacity of more than 1.5 times the length always suffices.

:- fluent place/2, at/1, battery/1, in/2, weight/2, wanted/1, carried/1.
:- parameter(length, 10.0).
:- parameter(sites, 3).
:- parameter(rocks, 5).
:- parameter(load_limit, 6.0).
:- parameter(capacity, 16.0).
:- parameter(step_reward, -0.02).
:- parameter(charge_reward, -0.25).

% Charging fills the battery up; a rock is dropped at the base only.

action(go(Place))  :- place(Place, _), \+ at(Place).
action(pick(Rock)) :- at(Place), in(Rock, Place), Place \== base, spare(Rock, Spare), Spare >= 0.
action(drop(Rock)) :- at(base), carried(Rock).
action(charge)     :- at(charger), battery(Energy), parameter(capacity, Capacity), Energy < Capacity.

effect(go(Place), [at(Here), battery(Energy)], Add) :-
    at(Here),
    battery(Energy),
    load(Load),
    cost(Here, Place, Load, Cost),
    Left is Energy - Cost,
    (   Left > 0 -> Add = [at(Place), battery(Left)] ; Add = [battery(0.0)] ).      % stranded on the way
effect(pick(Rock), [in(Rock, Place)], [carried(Rock)]) :- at(Place).
effect(drop(Rock), [carried(Rock)], [in(Rock, base)]).
effect(charge, [battery(Energy)], [battery(Capacity)]) :- battery(Energy), parameter(capacity, Capacity).

goal     :- \+ missing(_).
terminal :- \+ at(_).

missing(Rock) :- wanted(Rock), \+ in(Rock, base).

% A full load costs as much as the way itself.

cost(From, To, Load, Cost) :-
    place(From, X),
    place(To, Y),
    parameter(load_limit, Limit),
    Cost is abs(X - Y) * (1 + Load / Limit).

% Sums of reals depend on their order in the last digit: sorted, they are a matter of the state alone.

load(Load) :-
    findall(Weight, ( carried(Rock), weight(Rock, Weight) ), Weights),
    msort(Weights, Sorted),
    sum_list(Sorted, Load).

% spare(Rock, Spare): what the load limit leaves if the rock is taken, too; below 0 it does not fit.

spare(Rock, Spare) :-
    weight(Rock, Weight),
    load(Load),
    parameter(load_limit, Limit),
    Spare is Limit - Load - Weight.

% reserve(Place, Reserve): the energy that is left at the charger after going there by way of Place; below 0 the rover
% would strand. fetching(Rock, Reserve): the same, by way of the rock's place and with the rock.

reserve(Place, Reserve) :-
    load(Load),
    remaining(Place, Load, Reserve).

fetching(Rock, Reserve) :-
    in(Rock, Place),
    weight(Rock, Weight),
    load(Load),
    Loaded is Load + Weight,
    remaining(Place, Loaded, Reserve).

remaining(Place, Loaded, Reserve) :-
    at(Here),
    battery(Energy),
    load(Load),
    cost(Here, Place, Load, There),
    cost(Place, charger, Loaded, Back),
    Reserve is Energy - There - Back.

% One for each wanted rock, when it is dropped. Charging takes long: who charges whenever it is possible never
% strands and needs no numbers, but it does not pay.

reward(Action, Reward) :-
    parameter(step_reward, Step),
    (   Action = drop(Rock), wanted(Rock) -> Reward is Step + 1
    ;   Action = charge                   -> parameter(charge_reward, Reward)
    ;   terminal                          -> Reward is Step - 1
    ;   Reward = Step
    ).

% Rock by rock by way of the charger takes eight steps each.

horizon(Steps) :- aggregate_all(count, missing(_), Missing), Steps is 10 * Missing.

% Fetches what fits, the nearest first, as long as it leaves enough to reach the charger; else goes home with what it
% has, if that leaves enough, too; else charges.

expert(drop(Rock)) :- at(base), carried(Rock).
expert(charge)     :- action(charge).
expert(Action)     :- \+ ( at(base), carried(_) ), \+ action(charge), errand(Action).

errand(Action) :-
    findall(Distance-Rock, ( fetchable(Rock), distance(Rock, Distance) ), Rocks),
    (   msort(Rocks, [_-Rock|_])                -> towards(Rock, Action)
    ;   carried(_), reserve(base, R), R > 0     -> Action = go(base)
    ;   at(charger)                             -> Action = go(base)
    ;   Action = go(charger)
    ).

fetchable(Rock) :- missing(Rock), \+ carried(Rock), spare(Rock, S), S >= 0, fetching(Rock, R), R > 0.

distance(Rock, Distance) :- in(Rock, Place), at(Here), cost(Here, Place, 0, Distance).

towards(Rock, Action) :- in(Rock, Place), ( at(Place) -> Action = pick(Rock) ; Action = go(Place) ).

% Sites anywhere along the line, two rocks or more at any of them, each wanted or not, but one at least.

start([at(base), battery(Capacity), place(base, 0.0), place(charger, Middle)|Facts]) :-
    parameter(length, Length),
    parameter(capacity, Capacity),
    Middle is Length / 2,
    sites(Length, Sites),
    rocks(Rocks),
    random_member(First, Rocks),
    foldl(rock(Sites, First), Rocks, Sites, Facts).

sites(Length, Sites) :-
    parameter(sites, N),
    findall(place(Site, X), ( between(1, N, I), atom_concat(site, I, Site), random(U), X is U * Length ), Sites).

rocks(Rocks) :-
    parameter(rocks, Most),
    random_between(2, Most, Count),
    findall(Rock, ( between(1, Count, I), atom_concat(rock, I, Rock) ), Rocks).

rock(Sites, First, Rock, Facts, [in(Rock, Site), weight(Rock, Weight)|Rest]) :-
    random_member(place(Site, _), Sites),
    parameter(load_limit, Limit),
    random(U),
    Weight is Limit * (0.1 + 0.8 * U),
    random(V),
    (   ( Rock == First ; V < 0.5 ) -> Rest = [wanted(Rock)|Facts] ; Rest = Facts ).

% The places in their order along the line with the rocks there, the wanted ones with a star, and the rover.

picture(Lines) :-
    findall(X-Place, place(Place, X), Places),
    keysort(Places, Sorted),
    findall(Line, ( member(X-Place, Sorted), told(X, Place, Line) ), Rows),
    findall(Name, ( carried(Rock), titled(Rock, Name) ), Names),
    atomic_list_concat(['carries:'|Names], ' ', Carried),
    battery(Energy),
    format(atom(Battery), 'battery: ~1f', [Energy]),
    append(Rows, [Carried, Battery], Lines).

told(X, Place, Line) :-
    findall(Name, ( in(Rock, Place), titled(Rock, Name) ), Names),
    atomic_list_concat(Names, ' ', Rocks),
    (   at(Place) -> Here = 'R' ; Here = ' ' ),
    format(atom(Line), '~w~t~1f~7| ~w~t~17|~w', [Here, X, Place, Rocks]).

titled(Rock, Name) :-
    weight(Rock, Weight),
    (   wanted(Rock) -> Star = '*' ; Star = '' ),
    format(atom(Name), '~w~w(~1f)', [Rock, Star, Weight]).

% The places along the line, with their rocks above them, the rover with what it carries below it, and the battery.

shapes([line(0, 0, Length, 0, wall), box(0, -2.6, Length, 0.35, faint, ''), box(0, -2.6, Charged, 0.35, agent, '')|Shapes]) :-
    parameter(length, Length),
    parameter(capacity, Capacity),
    battery(Energy),
    Charged is Length * Energy / Capacity,
    findall(Shape, ( place(Place, X), place_shape(Place, X, Shape) ), Places),
    findall(Shape, ( place(Place, X), stacked(in(_, Place), 0.75, 0.7, X, Shape) ), Rocks),
    findall(Shape, ( at(Here), place(Here, X), rover_shape(X, Shape) ), Rover),
    append([Places, Rocks, Rover], Shapes).

place_shape(_, X, line(X, -0.12, X, 0.12, wall)).
place_shape(Place, X, text(X, 0.32, Place)).

rover_shape(X, disc(X, -0.45, 0.28, agent, '')).
rover_shape(X, Shape) :- stacked(carried(_), -1.05, -0.55, X, Shape).

% stacked(What, First, Step, X, Shape): the rocks that are there, one above the other.

stacked(What, First, Step, X, disc(X, Y, Radius, Tone, Rock)) :-
    findall(Rock, rock_of(What, Rock), Unsorted),
    sort(Unsorted, Rocks),
    nth0(I, Rocks, Rock),
    Y is First + I * Step,
    weight(Rock, Weight),
    parameter(load_limit, Limit),
    Radius is 0.15 + 0.18 * Weight / Limit,
    ( wanted(Rock) -> Tone = wanted ; Tone = object ).

rock_of(in(Rock, Place), Rock) :- in(Rock, Place).
rock_of(carried(Rock), Rock)   :- carried(Rock).
