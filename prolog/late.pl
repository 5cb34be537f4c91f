:- module(nppg_late,
          [ checked/2, checked/3, checked/4, checked/5, checked/6, checked/7, checked/8, checked/9,
            with_text/2          % +Module, +Goal                nondet
          ]).

:- use_module(library(lists), [append/3, memberchk/2]).
:- use_module(allowed, [kind/2]).
:- use_module(goals).
:- use_module(harmless).

/** <module> Goals that are made while a domain runs that is not trusted

What goals.pl has put in their place: it looks at them when they are called.
*/

%!  checked(+Module, +Closure, ?Argument...) is nondet.
%
%   Calls what was made while the domain runs, if it may be called.

checked(Module, Goal) :-
    run(Module, Goal, []).
checked(Module, Goal, A) :-
    run(Module, Goal, [A]).
checked(Module, Goal, A, B) :-
    run(Module, Goal, [A, B]).
checked(Module, Goal, A, B, C) :-
    run(Module, Goal, [A, B, C]).
checked(Module, Goal, A, B, C, D) :-
    run(Module, Goal, [A, B, C, D]).
checked(Module, Goal, A, B, C, D, E) :-
    run(Module, Goal, [A, B, C, D, E]).
checked(Module, Goal, A, B, C, D, E, F) :-
    run(Module, Goal, [A, B, C, D, E, F]).
checked(Module, Goal, A, B, C, D, E, F, G) :-
    run(Module, Goal, [A, B, C, D, E, F, G]).

run(Module, Closure, More) :-
    (   var(Closure)
    ->  throw(error(instantiation_error, _))
    ;   Closure = nppg_late:checked(Module, Inner)
    ->  run(Module, Inner, More)
    ;   Closure = Module:Inner
    ->  run(Module, Inner, More)
    ;   Closure = Other:Inner, extended(Inner, More, Goal), asked_there(Other, Goal)
    ->  call(Other:Goal)
    ;   Closure = _:_
    ->  throw(nppg_refused(Closure, 'a goal of another module'))
    ;   callable(Closure), lambda(Closure)
    ->  run_lambda(Closure, Module, More)
    ;   More == []
    ->  checked_body(Module, Closure, Goal),
        call(Module:Goal)
    ;   extended(Closure, More, Goal)
    ->  checked_body(Module, Goal, Checked),
        call(Module:Checked)
    ;   throw(error(type_error(callable, Closure), _))
    ).

extended(Closure, More, Goal) :-
    callable(Closure),
    (   More == []
    ->  Goal = Closure
    ;   Closure =.. List0,
        append(List0, More, List),
        Goal =.. List
    ).

%   Params>>Body and Free/Body, as library(yall) has them: each call has a copy, but for what is in Free.

run_lambda(Lambda0, Module, More) :-
    copy_term_nat(Lambda0, Copy),
    (   Copy = Free/Lambda
    ->  Lambda0 = Free/_
    ;   Lambda = Copy
    ),
    (   nonvar(Lambda), Lambda = (Params>>Body)
    ->  bound(Params, More, Rest),
        run(Module, Body, Rest)
    ;   run(Module, Lambda, More)
    ).

bound(Params, More, Rest) :-
    (   nonvar(Params), Params = [Param|Params1], More = [Param|More1]
    ->  bound(Params1, More1, Rest)
    ;   Rest = More
    ).

%!  with_text(+Module, +Goal) is nondet.
%
%   Goals whose arguments are known only now: clauses of the module's own, keys, formats, texts that become terms.

with_text(Module, Goal) :-
    kind(Goal, special(What)),
    (   known_now(What, Goal, Module, Checked)
    ->  call(Module:Checked)
    ;   memberchk(What, [digits, width, arithmetic])
    ->  throw(nppg_refused('a number or a text is too large', ''))
    ;   refused(Goal)
    ).

known_now(clauses, Goal0, Module, Goal) :-
    Goal0 =.. [Name, Clause0|More],
    (   nonvar(Clause0), Clause0 = Other:Clause1
    ->  Other == Module
    ;   Clause1 = Clause0
    ),
    nonvar(Clause1),
    (   Clause1 = (Head :- Body0)
    ->  callable(Head),
        Head \= _:_,
        plain_head(Head),
        (   Name == retract
        ->  Body = Body0
        ;   checked_body(Module, Body0, Body)
        ),
        Clause = (Head :- Body)
    ;   callable(Clause1),
        plain_head(Clause1),
        Clause = Clause1
    ),
    Goal =.. [Name, Clause|More].
known_now(key, Goal, _, Goal) :-
    arg(1, Goal, Key),
    atom(Key),
    plain_name(Key).
known_now(format, Goal, Module, Goal) :-
    special(format, Goal, Module, Same),
    Same == Goal.
known_now(text, Goal, _, Goal) :-
    \+ ( arg(_, Goal, Text), atomic(Text), \+ number(Text), atom_length(Text, Length), Length > 1000 ).
known_now(digits, Goal, _, Goal) :-
    \+ ( arg(_, Goal, Text), \+ number(Text), long(Text) ).
known_now(width, tab(Width), _, tab(Width)) :-
    Width < 10 000.
known_now(arithmetic, Goal, _, Goal) :-
    arg(2, Goal, Right),
    small(Right),
    (   functor(Goal, is, 2)
    ->  true
    ;   arg(1, Goal, Left),
        small(Left)
    ).

long(Text) :-
    (   is_list(Text)
    ->  length(Text, Length)
    ;   atomic(Text),
        atom_length(Text, Length)
    ),
    Length > 1000.

%   No power in the expression has more than a million bits.

small(Expression) :-
    (   compound(Expression)
    ->  \+ ( arg(_, Expression, Part), \+ small(Part) ),
        \+ ( arguments(Expression, Base, Exponent), Bits is msb(abs(Base)+1)*Exponent, Bits > 1 000 000 )
    ;   true
    ).

arguments(Power, Base, Exponent) :-
    (   ( Power = Left**Right ; Power = Left^Right )
    ;   Power = _<<Right,
        Left = 2
    ),
    catch(( Base is Left, Exponent is Right ), _, fail),
    integer(Base),
    integer(Exponent).
