:- module(nppg_loading,
          [ load_domain/5,       % +File, +Parameters, +Trust, -Module, -Description  det
            unload_domain/1,     % +Module                       det
            defines/2            % +Module, ?Indicator           nondet
          ]).

:- use_module(library(lists), [append/3, member/2]).
:- use_module(contract).
:- use_module(declarations).
:- use_module(formula, []).
:- use_module(guard, [stop_for/1, untame/1]).
:- use_module(call_graph, [static_predicate/2]).
:- use_module(interpretation, [forget/1, forget_tables/2]).
:- use_module(randomness, []).
:- use_module(report, [explanation/2]).
:- use_module(safety, [forget_files/0, guarding/2, unguarded/1]).
:- use_module(waiting, []).
:- use_module(used_files, [reading_used/3, unload_source/1, unload_used/1]).

/** <module> Loading domain files

Every load makes an instance, a module of its own, so that one file can be loaded with other parameters
beside itself.
*/

:- dynamic
    defines/2,                   % Module, Indicator: of the contract's predicates
    source/2,                    % Module, Id: what Prolog takes for the file that it comes from
    instances/1.
instances(0).

%!  load_domain(+File, +Parameters, +Trust, -Module, -Description) is det.
%
%   Parameters is a list of lists [Name, Value]. Trust is true where the file may do anything; else see safety.pl.
%   Description is a list of lists [Key, Value].
%
%   @throws nppg_problems(Problems): every mistake that can be found without running the domain

load_domain(File, Parameters, Trust, Module, Description) :-
    module_name(File, Name),
    retract(instances(Count0)),
    Count is Count0+1,
    assertz(instances(Count)),
    format(atom(Module), '~w#~d', [Name, Count]),
    (   Trust == true
    ->  Load = load(File, Module)
    ;   file_directory_name(File, Folder),
        Load = guarding(Folder, load(File, Module))
    ),
    reading(Module, Name, File, Parameters, reading_used(Module, File, Load), Heard, Refused0),
    findall(Problem, ( Trust \== true, unguarded(Problem) ), Refused, Refused0),
    must_be_harmless(Refused, Module),
    add_import_module(Module, nppg_randomness, start),
    add_import_module(Module, nppg_formula, start),
    add_import_module(Module, nppg_waiting, start),
    (   member(Problem, Heard), syntax_error(Problem)
    ->  Mistakes = []                       % what could not be read would be taken for missing
    ;   findall(Problem, ( mistake(Module, File, Parameters, Problem), \+ told(Problem, Heard) ), Mistakes)
    ),
    append(Heard, Mistakes, Problems),
    (   Problems == []
    ->  true
    ;   unload_domain(Module),
        sort(Problems, Sorted),
        length(Sorted, Count1),
        (   Count1 > 50
        ->  length(First, 50),
            append(First, _, Sorted),
            More is Count1-50,
            format(atom(Text), '~D more mistakes', [More]),
            append(First, [-(File, 0, 0, Text)], Shown)
        ;   Shown = Sorted
        ),
        throw(nppg_problems(Shown))
    ),
    forall(( contract(Indicator), defined(Module, Indicator) ),
           assertz(defines(Module, Indicator))),
    (   tabled(Module, _)
    ->  findall(Kept, ( tabled(Module, Head), \+ static_head(Module, Head), table_of(Module, Head, Kept) ), Heads),
        forget_tables(Module, Heads)
    ;   true
    ),
    findall([Key, Value], description(Module, Name, Key, Value), Description).

%   The first of the places is told, and how many there are.

must_be_harmless([], _) :-
    !.
must_be_harmless(Refused, Module) :-
    forget_files,
    unload_domain(Module),
    sort(Refused, [-(File, Line, Column, Text)|More]),
    length(More, Count),
    (   Count == 0
    ->  Message = Text
    ;   format(atom(Message), '~w [~D more]', [Text, Count])
    ),
    throw(nppg_problems([-(File, Line, Column, Message)])).

tabled(Module, Head) :-
    current_predicate(Module:Name/Arity),
    functor(Head, Name, Arity),
    predicate_property(Module:Head, tabled).

%   Under which its answers are kept: without the arguments that are aggregated (`:- table path(_, _, min)`).

table_of(Module, Head, Kept) :-
    (   current_predicate(Module:'$table_mode'/3),
        Module:'$table_mode'(Head, Variant, _)
    ->  Kept = Variant
    ;   Kept = Head
    ).

static_head(Module, Head) :-
    functor(Head, Name, Arity),
    static_predicate(Module, Name/Arity).

module_name(File, Name) :-
    catch(setup_call_cleanup(
              open(File, read, In, [encoding(utf8)]),
              first_term(In, Term),
              close(In)),
          Error,
          ( explanation(Error, Text), throw(nppg_problems([-(File, 0, 0, Text)])) )),
    (   nonvar(Term), Term = (:- module(Name, Exports)), atom(Name), is_list(Exports)
    ->  true
    ;   throw(nppg_problems([-(File, 1, 0, 'a domain starts with :- module(Name, []).')]))
    ).

%   Behind :- encoding(Encoding), which may come before.

first_term(In, Term) :-
    catch(read(In, First), error(syntax_error(_), _), First = none),
    (   nonvar(First), First = (:- encoding(_))
    ->  first_term(In, Term)
    ;   Term = First
    ).

%   Directives and term expansions may loop, too.

load(File, Module) :-
    atomic_list_concat([File, Module], '#', Id),
    assertz(source(Module, Id)),
    nb_setval(nppg_line, 1),
    Limit = 100 000 000,
    statistics(inferences, Before),
    catch(setup_call_cleanup(
              open(File, read, In, [encoding(utf8)]),
              call_with_inference_limit(load_files(user:Id, [stream(In), if(true), imports([]), silent(true)]),
                                        Limit, Result),
              close(In)),
          Error,
          load_stopped(Error, File, Before, Limit)),
    (   Result == inference_limit_exceeded
    ->  load_problem(File, Limit, Problem),
        heard(Problem)
    ;   true
    ).

load_stopped(Error, File, Before, Limit) :-
    (   Error \== '$aborted'
    ->  explanation(Error, Text),
        load_problem(File, Text, Problem),
        heard(Problem)
    ;   statistics(inferences, After),
        (   After-Before >= Limit
        ->  load_problem(File, Limit, Problem)
        ;   load_problem(File, 'loading was aborted', Problem)
        ),
        stop_for(nppg_problems([Problem]))
    ).

load_problem(File, What, -(File, Line, 0, Text)) :-
    nb_getval(nppg_line, Line),
    (   integer(What)
    ->  format(atom(Text), 'took more than ~D inferences to load (does a directive loop?)', [What])
    ;   Text = What
    ).

%   There is no fluent because the declaration has been refused.

told(-(_, _, _, Text), Heard) :-
    sub_atom(Text, 0, _, _, 'no fluent is declared'),
    member(-(_, _, _, Why), Heard),
    ( sub_atom(Why, _, _, _, 'can be no fluent') ; sub_atom(Why, 0, _, _, 'a fluent is declared by') ),
    !.

syntax_error(-(_, _, _, Text)) :-
    sub_atom(Text, 0, _, _, 'Syntax error').

unload_domain(Module) :-
    forget(Module),
    retractall(defines(Module, _)),
    unload_used(Module),
    forall(retract(source(Module, Id)), unload_source(Id)),
    untame(Module),
    forall(( current_predicate(Module:Name/Arity),
             functor(Head, Name, Arity),
             predicate_property(Module:Head, dynamic),
             \+ predicate_property(Module:Head, imported_from(_)) ),
           retractall(Module:Head)).
