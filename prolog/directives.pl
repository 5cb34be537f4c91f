:- module(nppg_directives,
          [ directive/4,         % +Directive, +Module, +Folder, -Terms  semidet
            refused_text/1,      % +Text                                         throws
            refused_text/2,      % +Format, +Args                                throws
            shown_briefly/2,     % +Term, -Text                                  det
            source_file_of/3,    % +Id, +Module, -File                           det
            unqualified/1        % +Term                                         semidet
          ]).

:- use_module(library(janus), [py_call/2]).
:- use_module(library(lists), [memberchk/2]).
:- use_module(library(occurs), [sub_term/2]).
:- use_module(allowed).
:- use_module(goals, [doubtful/2, keep_to/1]).
:- use_module(used_files, [path/2, used_goal/4]).

/** <module> The directives of a file that is not trusted
*/

%!  source_file_of(+Id, +Module, -File) is det.
%
%   The file of what Prolog takes for a source: of the domain's own it is told with the module.

source_file_of(Id, Module, File) :-
    atom_concat(#, Module, End),
    (   atom_concat(File, End, Id)
    ->  true
    ;   File = Id
    ).

%!  unqualified(+Term) is semidet.
%
%   Succeeds where nothing in it is about another module.

unqualified(Specs) :-
    \+ ( sub_term(Part, Specs), nonvar(Part), ( Part = _:_ ; Part = initialization(_) ) ).

refused_text(Text) :-
    throw(nppg_refused(Text, '')).

refused_text(Format, Args) :-
    format(atom(Text), Format, Args),
    refused_text(Text).

shown_briefly(Term, Shown) :-
    format(atom(Shown), '~W', [Term, [quoted(true), max_depth(8), spacing(next_argument)]]).

%!  directive(+Directive, +Module, +Folder, -Terms) is semidet.
%
%   Fails where it is to stay as it is.

directive(Directive, Module, Folder, Terms) :-
    (   var(Directive)
    ->  fail
    ;   safe_directive(Directive)
    ->  fail
    ;   declares(Directive)
    ->  fail
    ;   Directive = module(Name, Exports)
    ->  module_declared(Name, Exports)
    ;   Directive = arithmetic_function(Name/Arity), atom(Name), integer(Arity)
    ->  Calls is Arity+1,
        doubtful(Module, Name/Calls),
        fail
    ;   Directive = table(Specs)
    ->  tabled(Specs, Module),
        fail
    ;   Directive = op(_, _, Names)
    ->  \+ ( nonvar(Names), sub_term(Part, Names), nonvar(Part), Part = _:_, refused_directive(Directive) ),
        fail
    ;   imported(Directive, Spec)
    ->  (   nonvar(Spec), Spec = library(Library)
        ->  (   ground(Library), term_to_atom(Library, Name), importable(Name)
            ->  fail
            ;   refused_text('the library ~w is none that a domain may use which is not trusted', [Library])
            )
        ;   beside(Spec, Module, Folder, Path),
            used_goal(Directive, Spec, Path, Goal),
            Terms = (:- Goal)
        )
    ;   refused_directive(Directive)
    ).

refused_directive(Directive) :-
    shown_briefly(Directive, Shown),
    refused_text(':- ~w is no declaration of a domain that is not trusted', [Shown]).

imported(use_module(Spec), Spec).
imported(use_module(Spec, Imports), Spec) :-
    ground(Imports),
    \+ ( sub_term(Part, Imports), nonvar(Part), ( Part = _:_ ; Part = op(_, _, _) ; Part = as(_, _) ) ).
imported(ensure_loaded(Spec), Spec).
imported(include(Spec), Spec).

declares(Directive) :-
    Directive =.. [Name, Specs],
    memberchk(Name, [dynamic, discontiguous, meta_predicate, multifile, fluent, static, det]),
    unqualified(Specs).

module_declared(Name, Exports) :-
    atom(Name),
    unqualified(Exports),
    (   current_module(Name)
    ->  prolog_load_context(source, File),
        (   module_property(Name, file(File))
        ->  fail
        ;   refused_text('there is a module ~q already', [Name])
        )
    ;   absolute_file_name(library(Name), _, [file_type(prolog), access(read), file_errors(fail)])
    ->  refused_text('~q is a library of Prolog: choose another name for the module', [Name])
    ;   keep_to(Name),
        fail
    ).

%   What is aggregated by predicates of the file is called.

tabled(Specs, Module) :-
    unqualified(Specs),
    !,
    forall(( sub_term(Part, Specs), nonvar(Part), aggregated(Part, Called) ), doubtful(Module, Called)).
tabled(Specs, _) :-
    refused_directive(table(Specs)).

aggregated(lattice(Name/Arity), Name/Arity).
aggregated(lattice(Head), Name/3) :-
    callable(Head),
    Head \= _/_,
    functor(Head, Name, _).
aggregated(po(Name/Arity), Name/Arity).
aggregated(po(Head), Name/2) :-
    callable(Head),
    Head \= _/_,
    functor(Head, Name, _).

%   A file of the folder, as Prolog source, whatever else of that name there is.



beside(Spec, Module, Folder, Path) :-
    (   path(Spec, Given),
        source_location(Id, _),
        source_file_of(Id, Module, From),
        file_directory_name(From, Directory),
        absolute_file_name(Given, Path, [relative_to(Directory), extensions([pl, '']), access(read), file_errors(fail)])
    ->  py_call('nppg.bridge.bounds':included(Path, Folder), Found),
        (   Found == ''
        ->  true
        ;   refused_text(Found)
        )
    ;   shown_briefly(Spec, Shown),
        refused_text('~w is no file in the folder of the domain', [Shown])
    ).
