:- module(nppg_worlds,
          [ ferry/3,             % +Parameters, -Module, -Description  det
            ferry/2,             % +Parameters, -Module          det
            blocks/1,            % -Module                       det
            roads/2,             % +Parameters, -Module          det
            noisy/2,             % +Noise, -Module               det
            new_toy/0,           %                               det
            drop_toy/0,          %                               det
            toy_table/2          % +Tests, -Table                det
          ]).

:- use_module('../../prolog/interpretation').
:- use_module('../../prolog/loading').
:- use_module('../../prolog/table').

/** <module> The domains that the units ask

The module toy is one without a file.
*/

:- dynamic ferry_file/1, roads_file/1, blocks_file/1, noisy_file/1.
:- prolog_load_context(directory, Directory),
   atom_concat(Directory, '/../domains/ferry.pl', File),
   assertz(ferry_file(File)),
   atom_concat(Directory, '/../domains/roads.pl', Roads),
   assertz(roads_file(Roads)),
   atom_concat(Directory, '/../../domains/blocks_world.pl', Blocks),
   assertz(blocks_file(Blocks)),
   atom_concat(Directory, '/../../domains/noisy_blocks.pl', Noisy),
   assertz(noisy_file(Noisy)).

ferry(Parameters, Module, Description) :-
    ferry_file(File),
    load_domain(File, Parameters, false, Module, Description).

ferry(Parameters, Module) :-
    ferry(Parameters, Module, _).

roads(Parameters, Module) :-
    roads_file(File),
    load_domain(File, Parameters, false, Module, _).

blocks(Module) :-
    blocks_file(File),
    load_domain(File, [], false, Module, _).

noisy(Noise, Module) :-
    noisy_file(File),
    load_domain(File, [[noise, Noise]], false, Module, _).

new_toy :-
    dynamic([toy:on/2, toy:goal_on/2, toy:nppg_fluent/1]),
    assertz(toy:(clear(X) :- on(X, _), \+ on(_, X))),
    assertz(toy:(bad(X) :- X > 1)),
    interpret(toy, [goal_on(a, b), on(a, b), on(b, floor), on(c, floor)]).

drop_toy :-
    interpret(toy, []),
    forget(toy),
    retractall(toy:clear(_)),
    retractall(toy:bad(_)).

%   Roots: X and Y of move(X, Y), then the goal's A and B.

toy_table(Tests, Table) :-
    new_table(toy, [[move, 2]], [goal_on, 2], Table),
    set_tests(Table, [], [[1, 2, Tests]], [[[1, [1, 2], true]]]).
