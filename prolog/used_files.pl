:- module(nppg_used_files,
          [ reading_used/3,      % +Module, +File, :Goal                     semidet
            using/3,             % +Directive, +Module, -Goal                semidet
            path/2,              % +Spec, -Given                             semidet
            used_goal/4,         % +Directive, +Spec, +Path, -Goal           semidet
            used_module/3,       % +File, +Term, -Terms                        semidet
            used_files/2,        % +Module, -Files                           det
            unload_used/1,       % +Module                                   det
            unload_source/1      % +Id                                       det
          ]).

:- use_module(library(lists), [member/2, memberchk/2]).
:- use_module(goals, [let_go/1]).
:- use_module(guard, [untame/1]).

/** <module> The other files of a domain

A domain file may be continued in files that it names by `include`, `use_module`, `ensure_loaded` or the like. Each
instance of the domain has modules of its own for them, as it has for the domain file: they go with it, an edited file
is read anew, and two folders may hold different files of one name. What they are is told to Python, for they belong
to the domain wherever it is copied to.
*/

:- thread_local
    loading/2,                   % Instance, Folder: what is being read
    reading/2.                   % File, Module: a file that is a module, the latest first
:- dynamic
    used/3,                      % Instance, Name, Path: a file of it, named from its folder
    part/4,                      % Instance, Path, Context, Id: a file that has been loaded into a module
    parts/1.
parts(0).

%!  reading_used(+Module, +File, :Goal) is semidet.
%
%   Runs Goal, which loads File as Module.

:- meta_predicate reading_used(+, +, 0).

reading_used(Module, File, Goal) :-
    file_directory_name(File, Folder),
    setup_call_cleanup(asserta(loading(Module, Folder)), Goal, retractall(loading(_, _))).

%!  using(+Directive, +Module, -Goal) is semidet.
%
%   Goal is what a directive that names one file becomes, which is read into Module. Fails where it names a library, or
%   no file that is there: Prolog says so itself.

using(Directive, Module, Goal) :-
    names(Directive, Spec),
    path(Spec, Given),
    source_location(Id, _),
    source(Id, Module, From),
    found(Given, From, Path),
    used_goal(Directive, Spec, Path, Goal).

%!  path(+Spec, -Given) is semidet.
%
%   What a file is named by, 'parts/rest', "parts/rest" or parts/rest, as an atom.

path(Spec, Given) :-
    ground(Spec),
    Spec \== [],
    (   Spec = Folder/Name
    ->  path(Folder, Front),
        path(Name, Back),
        atomic_list_concat([Front, Back], /, Given)
    ;   ( atom(Spec) ; string(Spec) ),
        atom_string(Given, Spec)
    ).

names(use_module(Spec), Spec).
names(use_module(Spec, _), Spec).
names(ensure_loaded(Spec), Spec).
names(consult(Spec), Spec).
names([Spec], Spec).
names(load_files(Spec), Spec).
names(load_files(Spec, _), Spec).
names(include(Spec), Spec).

source(Id, Module, File) :-
    atom_concat(#, Module, End),
    (   atom_concat(File, End, Id)
    ->  true
    ;   File = Id
    ).

%   Of a copy, a file that was outside the folder stands in it.

found(Spec, From, Path) :-
    file_directory_name(From, Directory),
    (   there(Spec, Directory, Path)
    ->  true
    ;   loading(_, Folder),
        file_base_name(Spec, Name),
        there(Name, Folder, Path)
    ).

there(Spec, Directory, Path) :-
    absolute_file_name(Spec, Path, [relative_to(Directory), extensions([pl, '']), access(read), file_errors(fail)]),
    exists_file(Path).

%!  used_goal(+Directive, +Spec, +Path, -Goal) is semidet.
%
%   Goal has the directive read the file Path, which it names by Spec. It is noted as one of the domain's.

used_goal(Directive, _, Path, Goal) :-
    loading(Instance, Folder),
    note(Instance, Folder, Path),
    (   Directive = include(_)
    ->  Goal = include(Path)
    ;   imported(Directive, Imports),
        Goal = nppg_used_files:load_used(Instance, Path, Imports)
    ).

imported(Directive, Imports) :-
    (   Directive = use_module(_, Given)
    ->  Imports = Given
    ;   Directive = load_files(_, Options), is_list(Options), memberchk(imports(Given), Options)
    ->  Imports = Given
    ;   Imports = all
    ).

note(Instance, Folder, Path) :-
    (   used(Instance, _, Path)
    ->  true
    ;   atom_concat(Folder, /, Start),
        (   atom_concat(Start, Inside, Path)
        ->  Name = Inside
        ;   file_base_name(Path, Name)
        ),
        assertz(used(Instance, Name, Path))
    ).

%   Once for each module that it is read into; a file that is a module is read once, and imported.

:- public load_used/3.

load_used(Instance, Path, Imports) :-
    prolog_load_context(module, Context),
    (   part(Instance, Path, module, Id)
    ->  module_of(Id, Path, Module),
        import(Imports, Module, Context)
    ;   part(Instance, Path, Context, _)
    ->  true
    ;   first_term(Path, First),
        (   nonvar(First), First = (:- module(Name, _))
        ->  retract(parts(Count0)),
            Count is Count0+1,
            assertz(parts(Count)),
            format(atom(Module), '~w#~d', [Name, Count]),
            Into = module
        ;   Module = Context,
            Into = Context
        ),
        atomic_list_concat([Path, Module], #, Id),
        assertz(part(Instance, Path, Into, Id)),
        setup_call_cleanup(
            ( open(Path, read, In, [encoding(utf8)]), asserta(reading(Path, Module), Mark) ),
            load_files(Context:Id, [stream(In), if(true), imports(Imports), silent(true)]),
            ( erase(Mark), close(In) )),
        (   Into == module
        ->  add_import_module(Module, nppg_waiting, start),
            add_import_module(Module, nppg_randomness, start),
            add_import_module(Module, nppg_formula, start)
        ;   true
        )
    ).

import(Imports, Module, Context) :-
    module_property(Module, exports(All)),
    module_property(Module, exported_operators(Operators)),
    !,
    forall(( member(Each, All), wanted(Imports, Each) ), @(import(Module:Each), Context)),
    forall(( member(op(Priority, Type, Name), Operators), Imports == all ), op(Priority, Type, Context:Name)).
import(Imports, Module, Context) :-
    forall(( module_property(Module, exports(All)), member(Each, All), wanted(Imports, Each) ),
           @(import(Module:Each), Context)).

wanted(Imports, Each) :-
    (   Imports == all
    ->  true
    ;   Imports = except(Left)
    ->  \+ memberchk(Each, Left)
    ;   memberchk(Each, Imports)
    ).

%!  unload_source(+Id) is det.
%
%   Removes the clauses that come from a source. To unload_file/1, what was read from a stream is no file.

unload_source(Id) :-
    '$unload_file'(Id),
    retractall(system:'$load_context_module'(Id, _, _)).

module_of(Id, Path, Module) :-
    atom_concat(Path, End, Id),
    atom_concat(#, Module, End).

first_term(Path, First) :-
    setup_call_cleanup(
        open(Path, read, In, [encoding(utf8)]),
        catch(( read(In, Term), ( nonvar(Term), Term = (:- encoding(_)) -> read(In, First) ; First = Term ) ),
              error(syntax_error(_), _), First = none),
        close(In)).

%!  used_module(+File, +Term, -Terms) is semidet.
%
%   Terms is what the head of a file that is a module becomes, which is being read.

used_module(File, (:- module(Name, Exports)), [(:- module(Module, Exports)), (:- nppg_guard:tame(Module))]) :-
    atom(Name),
    reading(Latest, Known),
    !,
    Latest == File,
    Module = Known.

%!  used_files(+Module, -Files) is det: those of an instance, each [Name, Path], sorted.

used_files(Instance, Files) :-
    findall([Name, Path], used(Instance, Name, Path), Found),
    sort(Found, Files).

%!  unload_used(+Module) is det.
%
%   Forgets the files of an instance that is dropped.

unload_used(Instance) :-
    retractall(used(Instance, _, _)),
    let_go(Instance),
    forall(retract(part(Instance, Path, _, Id)),
           ( unload_source(Id), module_of(Id, Path, Module), untame(Module), let_go(Module) )).
