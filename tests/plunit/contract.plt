:- use_module('../../prolog/contract').
:- use_module('../../prolog/loading').
:- use_module(worlds).

:- begin_tests(contract).

test(description, [nondet, true(Fluents-Parameters-Actions
        == [[boat, 1], [car, 2], [fuel, 1]]-[[cars, 2], [storm, 0.25]]-[[carry, 1], [cross, 0]])]) :-
    ferry([], Module, Description),
    unload_domain(Module),
    member([fluents, Fluents], Description),
    member([parameters, Parameters], Description),
    member([actions, Actions], Description).
test(wrong_parameter, throws(nppg_problems([-(_, 1, 0, 'there is no parameter carz; the domain has cars, storm', carz, [cars, storm])]))) :-
    ferry([[carz, 1]], _).
test(defined, [setup(ferry([], M)), cleanup(unload_domain(M)),
               Defined == [start/1, action/1, effect/4, goal/0, terminal/0, reward/2, horizon/1, expert/1]]) :-
    findall(Indicator, ( contract(Indicator), defined(M, Indicator) ), Defined).
test(missing, Texts == ['start/1 is missing: start(-Facts) gives a random start state',
                        'action/1 is missing: action(-Action) gives the legal actions',
                        'effect/3 is missing: effect(+Action, -Delete, -Add) says what an action changes',
                        'no fluent is declared: :- fluent on/2 says which facts a state consists of',
                        'neither goal/0, terminal/0 nor reward/2 is defined: there is nothing to learn']) :-
    findall(Text, mistake(nowhere, 'nowhere.pl', [], -('nowhere.pl', 1, 0, Text)), Texts).

:- end_tests(contract).
