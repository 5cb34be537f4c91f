:- use_module('../../prolog/loading').
:- use_module('../../prolog/domain').
:- use_module('../../prolog/interpretation').
:- use_module(worlds).

:- begin_tests(loading).

at([boat(left), fuel(3), car(c1, left), car(c2, left)]).

%   The text of a domain of which one closure, and one distance, depends on a fluent.

paths(':- module(paths, []).
:- static road/2.
:- fluent at/1, closed/1.
:- dead_ends.
:- table path/2, far(_, _, min), open/2, way(_, _, min).
path(A, B) :- road(A, B).
path(A, B) :- path(A, C), road(C, B).
far(A, A, 0).
far(A, B, D) :- far(A, C, D0), road(C, B), D is D0+1.
leads(A, B) :- road(A, B), \\+ closed(B).
open(A, B) :- leads(A, B).
open(A, B) :- open(A, C), leads(C, B).
way(A, A, 0).
way(A, B, D) :- way(A, C, D0), leads(C, B), D is D0+1.
action(go(B)) :- at(A), leads(A, B).
effect(go(B), [at(A)], [at(B)]) :- at(A).
goal :- at(c).
start([at(a), road(a, b)]).
').

loaded_paths(M) :-
    paths(Text),
    setup_call_cleanup(tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]), (write(Out, Text), close(Out)), true),
    call_cleanup(load_domain(File, [], false, M, _), delete_file(File)).

answers(M, [path-Path, far-Far, open-Open, way-Way]) :-
    sorted(B, M:path(a, B), Path),
    sorted(D-B, M:far(a, B, D), Far),
    sorted(B, M:open(a, B), Open),
    sorted(D-B, M:way(a, B, D), Way).

sorted(Template, Goal, Sorted) :-
    findall(Template, Goal, All),
    msort(All, Sorted).

%   The predicates of which tables are there.

kept(M, Names) :-
    findall(Name, ( current_table(M:Variant, _), functor(Variant, Name, _) ), All),
    sort(All, Names).

test(two_instances, [setup(ferry([], M)), cleanup((unload_domain(M), unload_domain(Other))),
                     true(Here-There == [c1, c2]-[])]) :-
    at(Facts),
    ferry([], Other),
    interpret(M, Facts),
    interpret(Other, [boat(left), fuel(1)]),
    objects(M, waiting, Here),
    objects(Other, waiting, There).
test(defines, [cleanup(unload_domain(Module)), nondet]) :-
    ferry([], Module),
    defines(Module, goal/0).
test(unloaded, Defined-Facts == []-[]) :-
    ferry([], Module),
    interpret(Module, [boat(left)]),
    unload_domain(Module),
    findall(Indicator, defines(Module, Indicator), Defined),
    interpretation(Module, Facts).
test(tables_are_kept_as_long_as_what_they_depend_on,
     [setup(loaded_paths(M)), cleanup(unload_domain(M)), nondet,
      true([First, Kept, Second, KeptAgain, Third, Left] ==
           [[path-[b, c], far-[0-a, 1-b, 2-c], open-[b, c], way-[0-a, 1-b, 2-c]], [far, path],
            [path-[b, c], far-[0-a, 1-b, 2-c], open-[], way-[0-a]], [far, path],
            [path-[c], far-[0-a, 1-c], open-[c], way-[0-a, 1-c]], []])]) :-
    new_static(M, [road(a, b), road(b, c), road(c, b)], One),
    new_static(M, [road(a, c)], Other),
    enforce(M, One),
    interpret(M, [at(a)]),
    answers(M, First),
    interpret(M, [at(a), closed(b)]),
    kept(M, Kept),
    answers(M, Second),
    exchange(M, [at(a)], [at(b)]),
    kept(M, KeptAgain),
    enforce(M, Other),
    interpret(M, [at(a)]),
    kept(M, Left),
    answers(M, Third).
test(no_file, throws(nppg_problems([-('no such file.pl', 0, 0, _)]))) :-
    load_domain('no such file.pl', [], false, _, _).

:- end_tests(loading).
