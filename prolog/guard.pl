:- module(nppg_guard,
          [ guarded/2,           % +Predicate, :Goal         semidet
            guarded/3,           % +Predicate, +Asked, :Goal  semidet
            guarded_findall/4,   % ?Template, +Predicate, :Goal, -Answers  det
            fault/2,             % +Module, +Format-Args     throws
            inference_limit/1,   % ?Limit                    det
            set_inference_limit/1, % +Limit                  det
            stopped/1,           % -Fault                    semidet
            stop_for/1,          % +Fault                    det
            tame/1,              % +Module                   det
            untame/1,            % +Module                   det
            tamed/2              % ?Head, ?Body              nondet
          ]).

:- use_module(library(lists), [member/2]).
:- use_module(interpretation, [all_facts/2]).

/** <module> Running a domain's code safely

A domain's predicate that loops, throws or calls halt/0 is reported with its name, its place in the file
and the state in which it happened. `Predicate` is Module:Name/Arity.
*/

:- meta_predicate guarded(+, 0), guarded(+, +, 0), limited(+, +, +, 0), guarded_findall(?, +, 0, -).

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
    guarded(Predicate, 0, Goal).

%!  guarded(+Predicate, +Asked, :Goal) is semidet.
%
%   The same for a goal that asks so many things. The limit is for a hundred things that are asked and facts that hold
%   together, and grows with them beyond.

guarded(Predicate, Asked, Goal) :-
    inference_limit(Least),
    Predicate = Module:_,
    all_facts(Module, Facts),
    Limit is Least*max(100, Asked+Facts)//100,
    statistics(inferences, Before),
    limited(Predicate, Limit, Before, Goal).

limited(Predicate, Limit, Before, Goal) :-
    (   catch(call_with_inference_limit(Goal, Limit, Result), Error, note_abort(Error, Predicate, Limit, Before))
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

%!  stopped(-Fault) is semidet.
%
%   The fault that ended a question without an exception: Prolog was about to abort, or to halt.

:- dynamic stop/1.

stopped(Fault) :-
    stop(Fault),
    retractall(stop(_)).

stop_for(Fault) :-
    retractall(stop(_)),
    assertz(stop(Fault)).

%   An abort unwinds Prolog up to Python whoever catches it, so what it was about is left behind. Domain code
%   that swallows the limit's exception would run on without limit: there the exception becomes an abort.

note_abort(Error, Predicate, Limit, Before) :-
    (   Error == '$aborted'
    ->  statistics(inferences, After),
        (   After - Before >= Limit
        ->  stop_for(nppg_fault(Predicate, inference_limit(Limit)))
        ;   stop(nppg_fault(_, seconds(_)))
        ->  true
        ;   stop_for(nppg_fault(Predicate, 'called abort/0'-[]))
        )
    ;   true
    ).

:- multifile prolog:prolog_exception_hook/5.
:- dynamic prolog:prolog_exception_hook/5.

prolog:prolog_exception_hook(Ball, '$aborted', _, Catcher, _) :-
    nonvar(Ball),
    functor(Ball, inference_limit_exceeded, _),
    integer(Catcher),
    \+ keeps_limit(Catcher).

keeps_limit(Frame) :-
    prolog_frame_attribute(Frame, predicate_indicator, _:Name/3),
    (   Name == call_with_inference_limit
    ->  true
    ;   Name == catch,
        prolog_frame_attribute(Frame, parent, Parent),
        prolog_frame_attribute(Parent, predicate_indicator, _:call_with_inference_limit/3)
    ).

%!  look(+Engine, -Looked) is det.
%
%   Has the thread of that engine look at itself, as soon as it comes by; asked by another one. Looked is how often it has done so.

look(Engine, Looked) :-
    flag(nppg_looked, Looked, Looked),
    catch(thread_signal(Engine, nppg_guard:overdue), _, true).

%   Stops the call of domain code that has been going on for too long: three seconds for a million inferences that it has,
%   and is so far from these that it would take a minute: as one that waits, or works at enormous numbers. What else computes
%   comes to its inferences, on a busy machine later. It is looked at twice a second.

overdue :-
    flag(nppg_looked, Looked, Looked+1),
    prolog_current_frame(Frame),
    (   prolog_frame_attribute(Frame, parent_goal, nppg_guard:limited(Predicate, Limit, Before, _))
    ->  (   nb_current(nppg_overdue, Before-Ticks0)
        ->  Ticks is Ticks0+1
        ;   Ticks = 1
        ),
        nb_setval(nppg_overdue, Before-Ticks),
        Seconds is max(3, 3*Limit//1 000 000),
        statistics(inferences, Inferences),
        (   Ticks > 2*Seconds,
            120*(Inferences-Before) < Limit*Ticks
        ->  stop_for(nppg_fault(Predicate, seconds(Seconds))),
            abort
        ;   true
        )
    ;   true
    ).

%!  tame(+Module) is det.
%
%   Makes halt/0 and halt/1 throw where code of the module calls them, and a cleanup end where one loops.

tame(Module) :-
    forall(tamed(Head, Body),
           ( functor(Head, Name, Arity),
             redefine_system_predicate(Module:Head),
             forall(asks(Head, Goals), meta_predicate(Module:Goals)),
             assertz(Module:(Head :- Body)),
             compile_predicates([Module:Name/Arity]) )).

%!  untame(+Module) is det.
%
%   Removes these clauses from a module that is dropped, but for halt/0 and halt/1, which Prolog does not let go.

untame(Module) :-
    forall(( tamed(Head, _), Head \= halt, Head \= halt(_) ),
           ( functor(Head, Name, Arity), catch(abolish(Module:Name/Arity), _, true) )).

%!  tamed(?Head, ?Body) is nondet.
%
%   The clauses that a tame module has of its own.

tamed(halt, throw(nppg_halt)).
tamed(halt(_), throw(nppg_halt)).
tamed(setup_call_catcher_cleanup(Setup, Goal, Catcher, Cleanup),
      ( once(Setup), nppg_guard:cleaned(Goal, Catcher, Cleanup) )).
tamed(setup_call_cleanup(Setup, Goal, Cleanup), ( once(Setup), nppg_guard:cleaned(Goal, _, Cleanup) )).
tamed(call_cleanup(Goal, Cleanup), nppg_guard:cleaned(Goal, _, Cleanup)).

asks(setup_call_catcher_cleanup(_, _, _, _), setup_call_catcher_cleanup(0, 0, ?, 0)).
asks(setup_call_cleanup(_, _, _), setup_call_cleanup(0, 0, 0)).
asks(call_cleanup(_, _), call_cleanup(0, 0)).

%   All answers of Goal, then Cleanup: later it might never come. Prolog's own cleanups cannot be stopped: where the
%   limit has stopped Goal, there is none.

:- meta_predicate cleaned(0, ?, 0).

cleaned(Goal, Catcher, Cleanup) :-
    catch(findall(Goal, Goal, Answers), Error, true),
    (   nonvar(Error), ( Error == '$aborted' ; functor(Error, inference_limit_exceeded, _) )
    ->  throw(Error)
    ;   ended(Error, Answers, End),
        (   Catcher = End
        ->  ignore(catch(Cleanup, Late, true))
        ;   true
        ),
        (   nonvar(Error)
        ->  throw(Error)
        ;   nonvar(Late)
        ->  throw(Late)
        ;   member(Goal, Answers)
        )
    ).

ended(Error, Answers, End) :-
    (   nonvar(Error)
    ->  End = exception(Error)
    ;   Answers == []
    ->  End = fail
    ;   End = exit
    ).

%   Where other code calls them for a domain they fail, and the question is answered by a fault. Prolog allows
%   that ten times.

:- at_halt(nppg_guard:refuse_halt).

refuse_halt :-
    prolog_current_frame(Frame),
    (   prolog_frame_attribute(Frame, parent_goal, nppg_guard:limited(Predicate, _, _, _))
    ->  stop_for(nppg_fault(Predicate, 'called halt/0'-[])),
        cancel_halt(nppg)
    ;   prolog_frame_attribute(Frame, parent_goal, nppg_loading:load_domain(File, _, _, _, _))
    ->  stop_for(nppg_problems([-(File, 0, 0, 'loading the file called halt/0')])),
        cancel_halt(nppg)
    ;   true
    ).

:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

user:message_hook(cancel_halt(nppg), _, _).
