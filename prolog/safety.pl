:- module(nppg_safety,
          [ gate/3,              % +Term, +Module, -Terms            semidet
            guarding/2,          % +Folder, :Goal                    semidet
            forget_files/0,
            used_file/2,         % +File, +Module                    det
            unguarded/1,         % -Problem                          nondet
            refusal/2            % +What, -Text                      det
          ]).

:- use_module(library(lists), [memberchk/2]).
:- use_module(library(occurs), [sub_term/2]).
:- use_module(directives).
:- use_module(goals).
:- use_module(harmless).
:- use_module(library(prolog_wrap), [wrap_predicate/4]).

/** <module> Files that are not trusted

Every term of a file is looked at when it has been read, before Prolog acts on it: a directive is a declaration that is
known here, or is refused; a clause's body is that of goals.pl. What is refused is left out, and the file with it.
*/

:- meta_predicate guarding(+, 0).
:- thread_local guarded/1, used/2.

%!  guarding(+Folder, :Goal) is semidet.
%
%   Runs Goal, which loads files of the folder that are not trusted.

guarding(Folder, Goal) :-
    retractall(used(_, _)),
    setup_call_cleanup(asserta(guarded(Folder)), noted(Goal), retractall(guarded(_))).

%!  forget_files is det.
%
%   No longer counts as checked what files, beside the domain's own, have been loaded since `guarding`: those of a domain
%   that is refused, and another one that uses them is, too, until they are changed.

forget_files :-
    forall(retract(used(_, Module)), let_go(Module)).

%!  unguarded(-Problem) is nondet.
%
%   What clauses call that is neither allowed nor, now that all is read, defined by the file.

unguarded(-(File, Line, 0, Text)) :-
    doubt(Module, Name, Arity, Id, Line),
    functor(Head, Name, Arity),
    \+ own(Module, Head),
    there(Module, Head),
    source_file_of(Id, Module, File),
    refusal(Name/Arity, Text).

%!  used_file(+File, +Module) is det.
%
%   Notes that a file beside the domain's own is being read.

used_file(File, Module) :-
    (   used(File, Module)
    ->  true
    ;   assertz(used(File, Module))
    ).

%!  refusal(+What, -Text) is det.
%
%   What is an indicator or a message.

refusal(What, Text) :-
    (   ( What = _/_ ; What = _:_ )
    ->  format(atom(Start), '~q is nothing that a domain may call which is not trusted', [What])
    ;   Start = What
    ),
    atom_concat(Start, ': if its author may run anything on this machine, give --trust (trust=True)', Text).

%!  gate(+Term, +Module, -Terms) is semidet.
%
%   Terms are what is to be loaded in place of a term that is read into a module. Fails where the term is to stay as it is,
%   or nothing is guarded.
%
%   @throws nppg_refused(What, Why)

gate(Term, Module, Terms) :-
    guarded(Folder),
    keep_to(Module),
    (   Term == begin_of_file
    ->  fail
    ;   Term == end_of_file
    ->  fail
    ;   Term = (:- Directive)
    ->  directive(Directive, Module, Folder, Terms)
    ;   Term = (?- Directive)
    ->  directive(Directive, Module, Folder, Terms)
    ;   clause_of(Term, Module, Terms)
    ).

clause_of(Term, Module, Checked) :-
    plain_term(Term),
    (   Term = (Head --> _)
    ->  grammar_head(Head),
        dcg_translate_rule(Term, (H :- Body)),
        rule(H, Body, Module, Body1),
        Body1 \== Body,
        Checked = (H :- Body1)
    ;   Term = (Head :- Body)
    ->  rule(Head, Body, Module, Body1),
        Body1 \== Body,
        Checked = (Head :- Body1)
    ;   Term = (Head => Body)
    ->  (   nonvar(Head), Head = (H, Guard)
        ->  rule(H, (Guard, Body), Module, (Guard1, Body1)),
            Left = (H, Guard1)
        ;   rule(Head, Body, Module, Body1),
            Left = Head
        ),
        (Left => Body1) \== Term,
        Checked = (Left => Body1)
    ;   head(Term),
        fail
    ).

grammar_head(Head) :-
    (   nonvar(Head), Head = (H, _)
    ->  head(H)
    ;   head(Head)
    ).

rule(Head, Body, Module, Checked) :-
    head(Head),
    (   functor(Head, parameter, 2)
    ->  refused_text('parameter/2 is what :- parameter(Name, Default) declares')
    ;   checked_body(Module, Body, Checked)
    ).

head(Head) :-
    (   \+ callable(Head)
    ->  true                                    % Prolog tells that this is no clause
    ;   functor(Head, Name, Arity),
        (   plain(Name, Arity)
        ->  true
        ;   must_be_plain(Name, Arity, Head),
            assertz(plain(Name, Arity))
        )
    ).

:- dynamic plain/2.              % Name, Arity: a clause may have it as its head

must_be_plain(Name, Arity, Head) :-
    (   \+ plain_name(Name)
    ->  refused_text('~q is a name that nppg and Prolog keep for themselves', [Name])
    ;   \+ plain_head(Head)
    ->  shown_briefly(Head, Shown),
        refused_text('~w is no clause of the file\'s own', [Shown])
    ;   hook(Name/Arity)
    ->  refused_text('~q would change how Prolog reads or prints', [Name/Arity])
    ;   true
    ).

hook(Indicator) :-
    memberchk(Indicator,
              [ term_expansion/2, term_expansion/4, goal_expansion/2, goal_expansion/4, portray/1, attr_unify_hook/2,
                attribute_goals/3, attr_portray_hook/2, exception/3, prolog_load_file/2, message_hook/3 ]).

%   What stands behind :- if(Goal) is asked before term expansion. It is no declaration, so it goes on to be refused.

:- wrap_predicate('$expand':cond_compilation(Term, _), nppg_safety, Wrapped,
                  ( guarded(_), conditional(Term) -> fail ; Wrapped )).

conditional(Term) :-
    nonvar(Term),
    Term = (:- Directive),
    nonvar(Directive),
    memberchk(Directive, [if(_), elif(_), else, endif]),
    prolog_load_context(source, Source),
    current_prolog_flag(home, Home),
    \+ sub_atom(Source, 0, _, _, Home).

%   Without dictionaries, whose functions are calls. Only where the text may have some is it looked into.

plain_term(Term) :-
    nb_current(nppg_dicts, true),
    sub_term(Part, Term),
    nonvar(Part),
    (   is_dict(Part)
    ;   compound(Part), compound_name_arity(Part, '.', _)
    ;   compound(Part), compound_name_arity(Part, Name, _), Name \== '[|]', \+ atom(Name)
    ),
    !,
    refused_text('dictionaries are not read').
plain_term(_).
