:- module(nppg_waiting,
          [ sleep/1              % +Seconds                      det
          ]).

/** <module> Waiting

What a domain has in place of Prolog's sleep/1, which cannot be stopped before it is over; see look/2 in guard.pl.
*/

:- redefine_system_predicate(sleep(_)).

sleep(Seconds) :-
    get_time(Begin),
    End is Begin+Seconds,
    until(End).

until(End) :-
    get_time(Now),
    (   Now >= End
    ->  true
    ;   Rest is min(0.1, End-Now),
        system:sleep(Rest),
        until(End)
    ).
