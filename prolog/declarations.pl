:- module(nppg_declarations,
          [ reading/7,           % +Module, +Name, +File, +Parameters, :Goal, -Problems, -Refused  det
            heard/1              % +Problem                       det
          ]).

:- use_module(library(lists), [member/2, memberchk/2]).
:- use_module(contract, [contract/1, declared/2, environment/2]).
:- use_module(directives, [unqualified/1]).
:- use_module(guard, []).
:- use_module(report, [explanation/2]).
:- use_module(safety, [gate/3, refusal/2, used_file/2]).
:- use_module(used_files, [used_module/3, using/3]).
:- use_module(values, [finite/1]).

/** <module> The declarations of a domain file

While a domain file is being read, its declarations become clauses: those of nppg_fluent/1, nppg_static/1,
nppg_interchangeable/1, nppg_environment/1, nppg_pddl/1 and parameter/2 and the facts nppg_uniform_start and
nppg_dead_ends, in the file's module. Mistakes in them, and
what Prolog has to say of the file, are noted with their places.
*/

:- op(1150, fx, user:[fluent, static, interchangeable]).
:- thread_local loading/3, setting/2, noted/1, refused/1.

%!  reading(+Module, +Name, +File, +Parameters, :Goal, -Problems, -Refused) is det.
%
%   Runs Goal, which loads File, a file of the module Name, as Module. Parameters is a list of lists [Name, Value].
%   Problems is what was noted, in order; Refused what a file that is not trusted may not do.

:- meta_predicate reading(+, +, +, +, 0, -, -).

reading(Module, Name, File, Parameters, Goal, Problems, Refused) :-
    retractall(noted(_)),
    retractall(refused(_)),
    retractall(setting(_, _)),
    forall(member([Key, Value], Parameters), assertz(setting(Key, Value))),
    setup_call_cleanup(
        asserta(loading(Module, Name, File)),
        Goal,
        retractall(loading(_, _, _))),
    findall(Problem, retract(noted(Problem)), Problems),
    findall(Problem, retract(refused(Problem)), Refused).

%!  heard(+Problem) is det.
%
%   Notes a problem with the file that is being read.

heard(Problem) :-
    assertz(noted(Problem)).

user:term_expansion(Term, Expansion) :-
    loading(Module, Name, File),
    nonvar(Term),
    prolog_load_context(source, Source),
    (   Source == File
    ->  source_location(_, Line),
        nb_setval(nppg_line, Line),
        (   expansion(Term, Module, Name, Expanded)
        ->  Expansion = Expanded
        ;   passed(Term, Module, Expansion)
        )
    ;   \+ of_prolog(Source),
        prolog_load_context(module, Other),
        used_file(Source, Other),
        (   used_module(Source, Term, [Head|More])
        ->  (   gated(Head, Other, Refused)
            ->  Expansion = Refused
            ;   Expansion = [Head|More]
            )
        ;   passed(Term, Other, Expansion)
        )
    ).

%   A directive that names a file is about one of the domain's own.

passed(Term, Module, Expansion) :-
    (   gated(Term, Module, Gated)
    ->  Expansion = Gated
    ;   Term = (:- Directive),
        nonvar(Directive),
        using(Directive, Module, Goal),
        Expansion = (:- Goal)
    ).

%   What a file that is not trusted may not do is left out of it.

gated(Term, Module, Expansion) :-
    catch(gate(Term, Module, Expansion), nppg_refused(What, _),
          ( refusal(What, Text), located(wrong, File, Line, Column), assertz(refused(-(File, Line, Column, Text))),
            Expansion = [] )).

of_prolog(Source) :-
    current_prolog_flag(home, Home),
    sub_atom(Source, 0, _, _, Home).

expansion((:- Declaration), Module, Name, Expansion) :-
    !,
    nonvar(Declaration),
    (   Declaration = module(Name, Exports)
    ->  unqualified(Exports),
        Expansion = [(:- module(Module, Exports)), (:- nppg_guard:tame(Module)),
                     (:- discontiguous([nppg_fluent/1, nppg_static/1, nppg_interchangeable/1, nppg_environment/1, parameter/2]))]
    ;   declaration(Declaration, Module, Expansion)
    ).
expansion(Clause, Module, _, []) :-
    (   Clause = (Head :- _)
    ->  true
    ;   Head = Clause
    ),
    callable(Head),
    \+ memberchk(Head, [_:_, ( _ --> _ )]),
    functor(Head, Name, Arity),
    (   declared(Module, nppg_fluent(Name/Arity))
    ->  wrong('~q is a fluent: its facts come from start/1 and the effects, not from the file'-[Name/Arity])
    ;   declared(Module, nppg_static(Name/Arity))
    ->  wrong('~q is static: its facts come from start/1 or problem/2; leave out the declaration where they stand in the file'-[Name/Arity])
    ;   built_in(Name/Arity)
    ->  wrong('~q is built into Prolog and cannot be defined anew: choose another name'-[Name/Arity])
    ).

built_in(Name/Arity) :-
    functor(Head, Name, Arity),
    predicate_property(system:Head, iso).

%   Arithmetic stays as it is written, unless the file has functions of its own: a domain is the same whatever else
%   has been loaded. library(arithmetic) would look at every domain.

plain_arithmetic(Goal) :-
    loading(Module, _, _),
    compound(Goal),
    compound_name_arity(Goal, Name, 2),
    memberchk(Name, [is, =:=, =\=, <, >, =<, >=]),
    \+ catch(arithmetic:evaluable(_, Module), _, fail).

declaration(fluent(Specs), Module, Clauses) :-
    facts_declared(Specs, (fluent), Module, Clauses).
declaration(static(Specs), Module, Clauses) :-
    facts_declared(Specs, (static), Module, Clauses).
declaration(dead_ends, _, [nppg_dead_ends]).
declaration(pddl(File), _, Clauses) :-
    (   atom(File)
    ->  Clauses = [nppg_pddl(File)]
    ;   wrong('the PDDL file that a domain comes from is declared by its name: :- pddl(\'ferry.pddl\')'-[]),
        Clauses = []
    ).
declaration(parameter(Parameter, Default), Module, Clauses) :-
    (   \+ ( atom(Parameter), kind(Default, _) )
    ->  declaration(parameter(_), Module, Clauses)
    ;   declared(Module, parameter(Parameter, _))
    ->  wrong('the parameter ~q is declared twice'-[Parameter]),
        Clauses = []
    ;   setting(Parameter, Value)
    ->  must_fit(Parameter, Default, Value),
        Clauses = [parameter(Parameter, Value)]
    ;   Clauses = [parameter(Parameter, Default)]
    ).
declaration(parameter(_), _, []) :-
    wrong('a parameter is declared by :- parameter(Name, Default), its default a name or a finite number'-[]).
declaration(uniform_start, _, [nppg_uniform_start]).
declaration(environment(Id), Module, Clauses) :-
    (   \+ ( atom(Id), Id \== '' )
    ->  wrong('an environment of Gymnasium is declared by its id: :- environment(\'CartPole-v1\')'-[]),
        Clauses = []
    ;   environment(Module, Other)
    ->  wrong('an environment is declared already: ~q'-[Other]),
        Clauses = []
    ;   Clauses = [nppg_environment(Id)]
    ).
declaration(interchangeable(Spec), _, Clauses) :-
    (   nonvar(Spec), Spec = Name/1, atom(Name)
    ->  Clauses = [nppg_interchangeable(Spec)]
    ;   wrong('interchangeable objects are declared by a predicate of one argument: :- interchangeable block/1'-[]),
        Clauses = []
    ).

specified(Specs, Spec) :-
    (   nonvar(Specs), ( Specs = (First, More) ; Specs = [First|More] )
    ->  (   specified(First, Spec)
        ;   specified(More, Spec)
        )
    ;   Specs \== [],
        Spec = Specs
    ).

%   Kind is fluent or static.

facts_declared(Specs, Kind, Module, Clauses) :-
    findall(Spec, specified(Specs, Spec), All),
    atom_concat(nppg_, Kind, Name),
    findall(Clause,
            ( member(Spec, All), may_hold(Spec, Kind, Module), Fact =.. [Name, Spec],
              member(Clause, [(:- dynamic(Spec)), Fact]) ),
            Clauses).

may_hold(Spec, Kind, Module) :-
    (   \+ ( nonvar(Spec), Spec = Name/Arity, atom(Name), integer(Arity), Arity >= 0 )
    ->  kind_shown(Kind, What, Example),
        wrong('~w is declared by its name and the number of its arguments: :- ~w'-[What, Example]),
        fail
    ;   contract(Spec)
    ->  wrong('~q is a predicate of the contract and can be no ~w'-[Spec, Kind]),
        fail
    ;   built_in(Spec)
    ->  wrong('~q is built into Prolog and can be no ~w: choose another name'-[Spec, Kind]),
        fail
    ;   reserved(Spec)
    ->  wrong('~q is kept by nppg for itself and can be no ~w: choose another name'-[Spec, Kind]),
        fail
    ;   ( Kind == (static), Other = nppg_fluent(Spec) ; Kind == (fluent), Other = nppg_static(Spec) ),
        declared(Module, Other)
    ->  wrong('~q cannot be both a fluent and static'-[Spec]),
        fail
    ;   true
    ).

reserved(Name/Arity) :-
    (   Name/Arity == parameter/2
    ->  true
    ;   Name == '[]'
    ->  true
    ;   member(Start, [nppg_, $]),
        sub_atom(Name, 0, _, _, Start)
    ->  true
    ).

kind_shown((fluent), 'a fluent', 'fluent on/2').
kind_shown((static), 'a static predicate', 'static road/2').

%   A parameter's value is of the kind of its default; an integer does for a float.

must_fit(Parameter, Default, Value) :-
    kind(Default, Wanted),
    (   kind(Value, Given), memberchk(Given-Wanted, [Wanted-Wanted, 'a whole number'-'a finite number'])
    ->  true
    ;   wrong('the parameter ~q must be ~w, not ~q'-[Parameter, Wanted, Value])
    ).

kind(Value, Kind) :-
    (   atom(Value)
    ->  Kind = 'a name'
    ;   integer(Value)
    ->  Kind = 'a whole number'
    ;   finite(Value)
    ->  Kind = 'a finite number'
    ).

%   Notes a mistake in the term that is being read.

wrong(Format-Args) :-
    format(atom(Text), Format, Args),
    located(wrong, File, Line, Column),
    heard(-(File, Line, Column, Text)).

user:thread_message_hook(Message, Kind, _) :-
    loading(_, _, _),
    memberchk(Kind, [error, warning]),
    located(Message, File, Line, Column),
    explanation(Message, Text),
    heard(-(File, Line, Column, Text)).

located(error(_, Context), File, Line, Column) :-
    nonvar(Context),
    Context = file(File, Line, Column, _),
    !.
located(error(_, Context), File, Line, Column) :-
    nonvar(Context),
    Context = stream(_, Line, Column, _),
    !,
    prolog_load_context(source, Id),
    source_file_name(Id, File).
located(_, File, Line, 0) :-
    source_location(Id, Line),
    !,
    source_file_name(Id, File).
located(_, '', 0, 0).

source_file_name(Id, File) :-
    (   sub_atom(Id, Before, _, _, '#')
    ->  sub_atom(Id, 0, Before, _, File)
    ;   File = Id
    ).

:- multifile system:goal_expansion/2.
:- dynamic system:goal_expansion/2.
:- asserta((system:goal_expansion(Goal, _) :- nppg_declarations:plain_arithmetic(Goal), !, fail)).
