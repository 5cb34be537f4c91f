:- use_module('../../prolog/used_files').
:- use_module('../../prolog/loading').

:- begin_tests(used_files, [setup(written), cleanup(removed)]).

:- dynamic folder/1.

text('walk.pl', ":- module(walk, []).\n:- use_module(more).\n:- use_module(more, [near/1]).\n:- include('in/rest').\n\c
                 :- fluent at/1.\nstart([at(1)]).\naction(go).\neffect(go, [], []).\ngoal :- at(X), near(X), far(X).\n").
text('more.pl', ":- module(more, [near/1]).\n:- use_module(walk_more).\nnear(1).\n").
text('walk_more.pl', ":- module(walk_more, []).\n:- use_module(more).\n").
text('in/rest.pl', "far(9).\n").

written :-
    tmp_file(walk, Folder),
    atom_concat(Folder, '/in', Inner),
    make_directory(Folder),
    make_directory(Inner),
    assertz(folder(Folder)),
    forall(text(Name, Text),
           ( atomic_list_concat([Folder, Name], /, File),
             setup_call_cleanup(open(File, write, Out), write(Out, Text), close(Out)) )).

removed :-
    retract(folder(Folder)),
    delete_directory_and_contents(Folder).

loaded(Module) :-
    folder(Folder),
    atom_concat(Folder, '/walk.pl', File),
    load_domain(File, [], false, Module, _).

test(files, [setup(loaded(Module)), cleanup(unload_domain(Module)),
             true(Names == ['in/rest.pl', 'more.pl', 'walk_more.pl'])]) :-
    used_files(Module, Files),
    findall(Name, member([Name, _], Files), Names).

test(own_modules, [setup(( loaded(One), loaded(Two) )), cleanup(( unload_domain(One), unload_domain(Two) ))]) :-
    predicate_property(One:near(_), imported_from(First)),
    predicate_property(Two:near(_), imported_from(Second)),
    First \== Second,
    One:near(X),
    X == 1.

test(forgotten, [setup(( loaded(Module), unload_domain(Module) )), true(Files == [])]) :-
    used_files(Module, Files).

test(path, all(Path == ['a/b', 'a/b', 'a/b'])) :-
    member(Spec, ['a/b', a/b, "a/b", library(a), X, [], f(X)]),
    path(Spec, Path).

:- end_tests(used_files).
