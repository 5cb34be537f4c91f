:- module(nppg_guard,
          [ guarded/2,           % +Predicate, :Goal         semidet
            guarded_findall/4,   % ?Template, +Predicate, :Goal, -Answers  det
            fault/2,             % +Module, +Format-Args     throws
            inference_limit/1,   % ?Limit                    det
            set_inference_limit/1, % +Limit                  det
            problems/2,          % +Exception, -Problems     det
            explanation/2        % +Message, -Line           det
          ]).

:- use_module(library(apply), [exclude/3]).
:- use_module(interpretation).

/** <module> Running a domain's code safely

A domain's predicate that loops, throws or calls halt/0 is reported with its name, its place in the file
and the state in which it happened. `Predicate` is Module:Name/Arity.
*/

:- meta_predicate guarded(+, 0), guarded_findall(?, +, 0, -).

:- dynamic inference_limit/1.
inference_limit(1 000 000).

set_inference_limit(Limit) :-
    retractall(inference_limit(_)),
    assertz(inference_limit(Limit)).

%!  guarded(+Predicate, :Goal) is semidet.
%
%   once(Goal) within the inference limit. Code that catches the limit's own exception is found out by
%   counting, so that a swallowed limit does not look like failure.

guarded(Predicate, Goal) :-
    inference_limit(Limit),
    statistics(inferences, Before),
    (   catch(call_with_inference_limit(Goal, Limit, Result), Error, true)
    ->  true
    ;   Result = failed
    ),
    statistics(inferences, After),
    (   nonvar(Error)
    ->  throw(nppg_fault(Predicate, Error))
    ;   ( Result == inference_limit_exceeded ; After - Before > Limit )
    ->  throw(nppg_fault(Predicate, inference_limit(Limit)))
    ;   Result \== failed
    ).

guarded_findall(Template, Predicate, Goal, Answers) :-
    guarded(Predicate, findall(Template, Goal, Answers)).

%!  fault(+Module, +Message) is erroneous.
%
%   Throws a mistake of the domain that is no exception of Prolog's: Message is Format-Args, and the
%   current state is added. Module:Name/Arity in place of Module names the predicate at fault.

fault(Predicate, Message) :-
    throw(nppg_fault(Predicate, Message)).

%!  problems(+Exception, -Problems) is det.
%
%   The exception as a list of tuples -(File, Line, Column, Message) for Python.

problems(nppg_problems(Problems), Problems) :- !.
problems(nppg_fault(Predicate, What), [-(File, Line, 0, Text)]) :-
    !,
    (   Predicate = Module:Indicator
    ->  place(Predicate, File, Line),
        format(string(Name), '~q ', [Indicator])
    ;   Module = Predicate,
        File = '', Line = 0, Name = ""
    ),
    interpretation(Module, Facts),
    what(What, Module, Explanation),
    format(atom(Text), '~w~w in the state ~q', [Name, Explanation, Facts]).
problems(Error, [-('', 0, 0, Text)]) :-
    explanation(Error, Explanation),
    format(atom(Text), 'Prolog: ~w', [Explanation]).

place(Module:Name/Arity, File, Line) :-
    functor(Head, Name, Arity),
    (   predicate_property(Module:Head, file(File)),
        predicate_property(Module:Head, line_count(Line))
    ->  true
    ;   File = '', Line = 0
    ).

what(inference_limit(Limit), _, Text) :-
    !,
    format(string(Text), 'took more than ~D inferences (does it loop?)', [Limit]).
what(Format-Args, _, Text) :-
    atomic(Format),
    !,
    format(string(Text), Format, Args).
what(Error, Module, Text) :-
    explanation(Error, Explanation),
    format(string(Prefix), '~q:', [Module]),
    atomic_list_concat(Parts, Prefix, Explanation),
    atomic_list_concat([threw, ' '|Parts], Text).

%!  explanation(+Error, -Line) is det.
%
%   The message that Prolog itself would print, on one line and without the place and the context, which
%   name the internals of a call and not the user's file.

explanation(Error, Line) :-
    (   Error = error(Formal, _)
    ->  Short = error(Formal, _)
    ;   Short = Error
    ),
    phrase(prolog:translate_message(Short), Parts),
    with_output_to(string(Text), print_message_lines(current_output, '', Parts)),
    split_string(Text, "\n", " \t", Lines),
    exclude(==(""), Lines, Kept),
    atomic_list_concat(Kept, ' ', Line).
