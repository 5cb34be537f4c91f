:- module(nppg_goals,
          [ checked_body/3,      % +Module, +Body, -Checked      det
            refused/1,           % +Goal                         throws
            special/4,           % +What, +Goal, +Module, -Checked  semidet
            doubt/5,             % ?Module, ?Name, ?Arity, ?Id, ?Line  nondet
            doubtful/2,          % +Module, +Indicator           det
            noted/1,             % :Goal                         semidet
            own/2,               % +Module, +Head                semidet
            there/2,             % +Module, +Head                semidet
            keep_to/1,           % +Module                       det
            let_go/1,            % +Module                       det
            asked_there/2        % +Module, +Goal                semidet
          ]).

:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, memberchk/2]).
:- use_module(library(occurs), [sub_term/2]).
:- use_module(allowed).
:- use_module(harmless).

/** <module> The goals of a domain that is not trusted

A clause's body is walked before the clause is there. What a goal calls that is known by then is looked up; what is known
only when it runs is called by late.pl, which looks then. Whatever is not allowed is thrown, as nppg_refused(Indicator, Why).
*/

:- dynamic kept/1.               % Module: of a domain that is not trusted, or of a file that it uses
:- meta_predicate noted(0).
:- thread_local noting/0, doubt/5.

%!  keep_to(+Module) is det.
%
%   From now on what the module defines counts as checked.

keep_to(Module) :-
    (   kept(Module)
    ->  true
    ;   assertz(kept(Module))
    ).

let_go(Module) :-
    retractall(kept(Module)).

%!  there(+Module, +Head) is semidet.
%
%   Succeeds where a call of it would find something.

there(Module, Head) :-
    (   predicate_property(Module:Head, defined)
    ->  true
    ;   exists(Head)
    ).

%!  own(+Module, +Head) is semidet.
%
%   Succeeds for a predicate of the module itself, or of another file of the domain.

own(Module, Head) :-
    predicate_property(Module:Head, defined),
    (   predicate_property(Module:Head, imported_from(From))
    ->  kept(From)
    ;   true
    ).

%!  checked_body(+Module, +Body, -Checked) is det.
%
%   Checked is the body with goals that are made while it runs replaced by what looks at them.
%
%   @throws nppg_refused(Indicator, Why)

%!  noted(:Goal) is semidet.
%
%   Runs Goal, which has checked_body/3 look at a file that is being read. What the file may still define is noted as
%   doubt(Module, Name, Arity, Id, Line), where Prolog takes Id for the source.

noted(Goal) :-
    retractall(doubt(_, _, _, _, _)),
    setup_call_cleanup(asserta(noting), Goal, retractall(noting)).

%!  doubtful(+Module, +Indicator) is det.

doubtful(Module, Name/Arity) :-
    (   doubt(Module, Name, Arity, _, _)
    ->  true
    ;   source_location(Id, Line)
    ->  assertz(doubt(Module, Name, Arity, Id, Line))
    ;   assertz(doubt(Module, Name, Arity, '', 0))
    ).

checked_body(Module, Body, nppg_late:checked(Module, Body)) :-
    var(Body),
    !.
checked_body(Module, Body, Checked) :-
    connective(Body),
    !,
    Body =.. [Name|Goals0],
    maplist(checked_body(Module), Goals0, Goals),
    Checked =.. [Name|Goals].
checked_body(Module, Other:Goal, Goal1) :-
    !,
    (   nonvar(Goal), Other == Module
    ->  checked_body(Module, Goal, Goal1)
    ;   asked_there(Other, Goal)
    ->  Goal1 = Other:Goal
    ;   callable(Goal), functor(Goal, Name, Arity), library_of(Name/Arity, Other), kind(Goal, Kind), Kind \== other
    ->  of_kind(Kind, Goal, Module, Goal2),
        Goal1 = Other:Goal2
    ;   nonvar(Goal)
    ->  functor(Goal, Name, Arity),
        throw(nppg_refused(Other:Name/Arity, 'a goal of another module'))
    ;   throw(nppg_refused((:)/2, 'a goal of another module'))
    ).
checked_body(Module, Goal, Checked) :-
    callable(Goal),
    !,
    kind(Goal, Kind),
    of_kind(Kind, Goal, Module, Checked).
checked_body(_, Goal, Goal).

%!  asked_there(+Module, +Goal) is semidet.
%
%   Goals of another file's own predicates, which that file has handed on to be called; they change nothing there.

asked_there(Module, Goal) :-
    atom(Module),
    callable(Goal),
    kept(Module),
    (   connective(Goal)
    ->  forall(arg(_, Goal, Part), asked_there(Module, Part))
    ;   kind(Goal, Kind),
        (   memberchk(Kind, [pure, special(arithmetic)])
        ->  true
        ;   Kind == other,
            own(Module, Goal)
        )
    ).

connective((_, _)).
connective((_ ; _)).
connective('|'(_, _)).                   % as ; to the compiler
connective((_ -> _)).
connective((_ *-> _)).
connective(\+ _).

of_kind(pure, Goal, _, Goal).
of_kind(meta(Spec), Goal, Module, Checked) :-
    Goal =.. [Name|Arguments0],
    Spec =.. [_|Kinds],
    maplist(argument(Module), Kinds, Arguments0, Arguments),
    Checked =.. [Name|Arguments].
of_kind(special(What), Goal, Module, Checked) :-
    (   own(Module, Goal)
    ->  Checked = Goal
    ;   special(What, Goal, Module, Checked)
    ->  true
    ;   refused(Goal)
    ).
of_kind(other, Goal, Module, Goal) :-
    functor(Goal, Name, Arity),
    (   noting
    ->  doubtful(Module, Name/Arity)
    ;   own(Module, Goal)
    ->  true
    ;   there(Module, Goal)
    ->  refused(Goal)
    ;   true
    ).

refused(Goal) :-
    functor(Goal, Name, Arity),
    throw(nppg_refused(Name/Arity, '')).

argument(_, Kind, Argument, Argument) :-
    \+ integer(Kind),
    \+ memberchk(Kind, [^, //]),
    !.
argument(Module, ^, Argument0, Argument) :-
    !,
    (   nonvar(Argument0), Argument0 = V^Rest0
    ->  argument(Module, ^, Rest0, Rest),
        Argument = V^Rest
    ;   checked_body(Module, Argument0, Argument)
    ).
argument(Module, //, Argument0, Argument) :-
    !,
    closure(Module, 2, Argument0, Argument).
argument(Module, Count, Argument0, Argument) :-
    closure(Module, Count, Argument0, Argument).

%   closure(+Module, +Count, +Closure, -Checked): what is called with Count more arguments.

closure(Module, _, Closure, nppg_late:checked(Module, Closure)) :-
    var(Closure),
    !.
closure(Module, 0, Closure, Checked) :-
    !,
    checked_body(Module, Closure, Checked).
closure(Module, _, Other:Closure, _) :-
    Other \== Module,
    !,
    throw(nppg_refused(Other:Closure, 'a goal of another module')).
closure(Module, Count, Closure0, Closure) :-
    \+ lambda(Closure0),
    callable(Closure0),
    !,
    extended(Closure0, Count, More, Goal),
    checked_body(Module, Goal, Goal1),
    (   Goal1 == Goal
    ->  Closure = Closure0
    ;   Goal1 =.. List,
        append(Front, End, List),
        End == More
    ->  Closure =.. Front
    ;   Closure = nppg_late:checked(Module, Closure0)
    ).
closure(Module, _, Closure, nppg_late:checked(Module, Closure)).

extended(Closure, Count, More, Goal) :-
    length(More, Count),
    Closure =.. List0,
    append(List0, More, List),
    Goal =.. List.

%   special(+What, +Goal, +Module, -Checked): fails where the arguments are none that are allowed.

special(clauses, Goal, Module, Checked) :-
    arg(1, Goal, Clause),
    (   nonvar(Clause), Clause \= (_ :- _), Clause \= _:_, callable(Clause), plain_head(Clause)
    ->  Checked = Goal
    ;   Checked = nppg_late:with_text(Module, Goal)
    ).
special(key, Goal, Module, Checked) :-
    arg(1, Goal, Key),
    (   var(Key)
    ->  Checked = nppg_late:with_text(Module, Goal)
    ;   atom(Key),
        plain_name(Key),
        Checked = Goal
    ).
special(format, Goal, Module, Checked) :-
    functor(Goal, _, Arity),
    (   Arity =:= 3
    ->  arg(1, Goal, Sink),
        sink(Sink),
        arg(2, Goal, Text)
    ;   arg(1, Goal, Text)
    ),
    (   var(Text)
    ->  Checked = nppg_late:with_text(Module, Goal)
    ;   catch(text_to_string(Text, String), _, fail),
        string_codes(String, Codes),
        plain_format(Codes),
        Checked = Goal
    ).
special(stream, Goal, _, Goal) :-
    arg(1, Goal, Stream),
    atom(Stream),
    memberchk(Stream, [user_error, user_output, current_output]).
special(text, Goal, Module, nppg_late:with_text(Module, Goal)).
special(digits, Goal, Module, nppg_late:with_text(Module, Goal)).
special(width, Goal, Module, Checked) :-
    (   Goal = tab(Width), integer(Width), Width < 10 000
    ->  Checked = Goal
    ;   Checked = nppg_late:with_text(Module, Goal)
    ).
special(arithmetic, Goal, Module, Checked) :-
    (   ( Goal = (_ is Right), var(Right) ; sub_term(Part, Goal), power(Part) )
    ->  Checked = nppg_late:with_text(Module, Goal)
    ;   Checked = Goal
    ).
special(options, Goal, _, Goal) :-
    arg(2, Goal, Options),
    ground(Options),
    is_list(Options),
    \+ ( member_of(Option, Options), \+ memberchk(Option, [quoted(_), ignore_ops(_), numbervars(_), max_depth(_), spacing(_)]) ).
special(phrase, Goal, Module, Checked) :-
    Goal =.. [phrase, Body0|Lists],
    (   nonvar(Body0), ( connective(Body0) ; Body0 = {_} ; Body0 = !; Body0 = call(_) ; is_list(Body0) ; string(Body0) )
    ->  dcg_translate_rule((nppg --> Body0), (_ :- Translated)),
        checked_body(Module, Translated, Same),
        Same == Translated,
        Checked = Goal
    ;   closure(Module, 2, Body0, Body),
        Checked =.. [phrase, Body|Lists]
    ).

member_of(Member, [Member|_]).
member_of(Member, [_|Rest]) :-
    member_of(Member, Rest).
