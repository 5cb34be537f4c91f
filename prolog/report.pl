:- module(nppg_report,
          [ problems/2,          % +Exception, -Problems     det
            explanation/2,       % +Message, -Line           det
            shown/2              % +Term, -Text              det
          ]).

:- use_module(library(apply), [exclude/3, foldl/4, maplist/2]).
:- use_module(library(lists), [append/3, memberchk/2]).
:- use_module(interpretation).
:- use_module(safety, [refusal/2]).

/** <module> Telling the user what is wrong

Exceptions become problems -(File, Line, Column, Message), or -(File, Line, Column, Message, Name, Known) with
a name that is unknown and those that are known, among which Python looks for a near one. Messages are one line;
they abbreviate long states and do not show the modules that instances of a domain are kept in.
*/

%!  problems(+Exception, -Problems) is det.

problems(nppg_problems(Problems), Problems) :- !.
problems(nppg_fault(Predicate, What), [Problem]) :-
    !,
    (   Predicate = Module:Indicator
    ->  place(Predicate, File, Line),
        name(Indicator, Name)
    ;   Module = Predicate,
        File = '', Line = 0, Name = ''
    ),
    (   What == nppg_unseeded, memberchk(Indicator, [effect/3, effect/4, reward/2])
    ->  Explanation = 'drew a random number, so what may come of an action cannot be listed,'
    ;   what(What, Explanation)
    ),
    circumstances(Indicator, Module, Circumstances),
    format(atom(Text0), '~w~w ~w', [Name, Explanation, Circumstances]),
    tidy(Text0, Text),
    (   What = error(existence_error(procedure, Missing), _),
        strip_module(Missing, _, Unknown/_)
    ->  findall(Known, current_predicate(Module:Known/_), All),
        Problem = -(File, Line, 0, Text, Unknown, All)
    ;   Problem = -(File, Line, 0, Text)
    ).
problems(nppg_refused(What, _), [-('', 0, 0, Text)]) :-
    !,
    refusal(What, Text).
problems(Error, [-('', 0, 0, Text)]) :-
    explanation(Error, Explanation),
    format(atom(Text), 'Prolog: ~w', [Explanation]).

name(test/0, 'a test of the language bias ') :- !.
name(Indicator, Name) :-
    format(atom(Name), '~q ', [Indicator]).

place(Module:Name/Arity, File, Line) :-
    functor(Head, Name, Arity),
    (   predicate_property(Module:Head, file(Id)),
        predicate_property(Module:Head, line_count(Line))
    ->  (   atomic_list_concat([File, Module], '#', Id)
        ->  true
        ;   File = Id
        )
    ;   File = '', Line = 0
    ).

what(inference_limit(Limit), Text) :-
    !,
    format(atom(Text), 'took more than ~D inferences (does it loop?)', [Limit]).
what(seconds(Seconds), Text) :-
    !,
    format(atom(Text), 'took more than ~D seconds (does it wait, or compute enormous numbers?)', [Seconds]).
what(Format-Args, Text) :-
    atomic(Format),
    !,
    maplist_shown(Args, Shown),
    format(atom(Text), Format, Shown).
what(nppg_halt, Text) :-
    !,
    Text = 'called halt, which would end Python,'.
what(nppg_unseeded, Text) :-
    !,
    Text = 'drew a random number, which only start/1, effects, reward/2 and observation/1 may,'.
what(nppg_refused(What, _), Text) :-
    !,
    refusal(What, Refusal),
    atom_concat('was stopped: ', Refusal, Text).
what(error(resource_error(Resource), _), Text) :-
    !,
    format(atom(Text), 'ran out of ~w (does it recurse without end?)', [Resource]).
what(Error, Text) :-
    (   Error = error(_, _)
    ->  explanation(Error, Explanation)
    ;   shown(Error, Explanation)
    ),
    atom_concat('threw ', Explanation, Text).

maplist_shown([], []).
maplist_shown([Arg|Args], [Shown|More]) :-
    (   ( atom(Arg) ; number(Arg) )
    ->  Shown = Arg
    ;   shown(Arg, Shown)
    ),
    maplist_shown(Args, More).

%   A start state has no state before it, but parameters.

circumstances(start/1, Module, Text) :-
    !,
    findall(Name=Value, catch(Module:parameter(Name, Value), _, fail), Parameters),
    (   Parameters == []
    ->  Text = ''
    ;   shown(Parameters, Shown),
        atom_concat('with the parameters ', Shown, Text)
    ).
circumstances(_, Module, Text) :-
    interpretation(Module, Facts),
    shown(Facts, Shown),
    (   tampered(Module)
    ->  Tampered = ', whose facts the domain\'s own code has changed: only effects may'
    ;   Tampered = ''
    ),
    atomic_list_concat(['in the state ', Shown, Tampered], Text).

%!  shown(+Term, -Text) is det.
%
%   Term as it would be typed, abbreviated where it is long or deep.

shown(Term, Text) :-
    (   is_list(Term), length(Term, Length), Length > 24
    ->  length(First, 20),
        append(First, _, Term),
        More is Length-20,
        bounded(First, Start),
        sub_atom(Start, 0, _, 1, Open),
        format(atom(Text), '~w, ... and ~D more]', [Open, More])
    ;   bounded(Term, Text)
    ).

bounded(Term, Text) :-
    brief(Term, Brief),
    copy_term(Brief, Copy, _),
    anonymous(Copy),
    format(atom(Whole), '~W', [Copy, [quoted(true), numbervars(true), max_depth(60), cycles(true)]]),
    (   sub_atom(Whole, 0, 600, Rest, Start), Rest > 3
    ->  atom_concat(Start, ' ...', Text)
    ;   Text = Whole
    ).

%   Term with dots for what is behind its first 1,000 parts, or is a long text or number: it may be of any size, and may
%   have itself among its parts.

brief(Term, Brief) :-
    brief(Term, Brief, 1000, _).

brief(Term, Term, Left, Left) :-
    var(Term),
    !.
brief(_, ..., Left, Left) :-
    Left =< 0,
    !.
brief(Term, Brief, Left0, Left) :-
    compound(Term),
    !,
    compound_name_arity(Term, Name, Arity),
    Kept is min(Arity, Left0),
    (   Kept =:= Arity
    ->  compound_name_arity(Brief, Name, Arity)
    ;   compound_name_arity(Brief, Name, Kept)
    ),
    Left1 is Left0-1,
    brief_arguments(1, Kept, Term, Brief, Left1, Left).
brief(Term, Brief, Left0, Left) :-
    Left is Left0-1,
    (   integer(Term)
    ->  (   abs(Term) < 1<<4000
        ->  Brief = Term
        ;   Brief = ...
        )
    ;   ( atom(Term) ; string(Term) ), atom_length(Term, Length), Length > 2000
    ->  sub_atom(Term, 0, 2000, _, Brief)
    ;   Brief = Term
    ).

brief_arguments(I, Arity, Term, Brief, Left0, Left) :-
    (   I > Arity
    ->  Left = Left0
    ;   arg(I, Term, Arg0),
        arg(I, Brief, Arg),
        brief(Arg0, Arg, Left0, Left1),
        Next is I+1,
        brief_arguments(Next, Arity, Term, Brief, Left1, Left)
    ).

anonymous(Term) :-
    term_variables(Term, Variables),
    maplist(=('$VAR'('_')), Variables).

%!  explanation(+Message, -Line) is det.
%
%   The message that Prolog itself would print, on one line and without the place and the context, which
%   name the internals of a call and not the user's file.

explanation(nppg_halt, Line) :-
    !,
    Line = 'halt was called, which would end Python'.
explanation(Message, Line) :-
    (   catch(translated(Message, Text0), _, fail)
    ->  true
    ;   shown(Message, Text0)
    ),
    split_string(Text0, "\n", " \t", Lines),
    exclude(==(""), Lines, Kept),
    atomic_list_concat(Kept, ' ', Text),
    tidy(Text, Line).

translated(Message, Text) :-
    (   Message = error(Formal0, _)
    ->  brief(Formal0, Formal1),
        copy_term(Formal1, Formal, _),
        anonymous(Formal),
        Short = error(Formal, _)
    ;   Short = Message
    ),
    phrase(prolog:translate_message(Short), Parts),
    (   Parts = ['Unknown message: ~p'-_|_]
    ->  shown(Message, Text)
    ;   with_output_to(string(Text), print_message_lines(current_output, '', Parts))
    ).

%   Replaces the names of the modules that nppg makes, such as 'blocks_world#1', by those that users know.

tidy(Text0, Text) :-
    findall(Quoted-Name,
            ( current_module(Module), sub_atom(Module, Before, 1, _, #), sub_atom(Module, 0, Before, _, Name),
              format(atom(Quoted), '~q', [Module]), once(sub_atom(Text0, _, _, _, Quoted)) ),
            Internals),
    foldl(rename, Internals, Text0, Text).

rename(Quoted-Name, Text0, Text) :-
    atom_concat(Quoted, ':', Qualifier),
    replaced(Text0, Qualifier, '', Text1),
    replaced(Text1, Quoted, Name, Text).

replaced(Text0, Old, New, Text) :-
    atomic_list_concat(Parts, Old, Text0),
    atomic_list_concat(Parts, New, Text).
