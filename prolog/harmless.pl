:- module(nppg_harmless,
          [ lambda/1,            % +Term                         semidet
            plain_format/1,      % +Codes                        semidet
            plain_head/1,        % +Head                         semidet
            plain_name/1,        % +Name                         semidet
            power/1,             % +Term                         semidet
            sink/1               % +Sink                         semidet
          ]).

:- use_module(library(lists), [memberchk/2]).

/** <module> What arguments make a goal harmless, or not

Of domains that are not trusted; see goals.pl.
*/

%!  lambda(+Closure) is semidet.

lambda(Closure) :-
    compound(Closure),
    compound_name_arity(Closure, Name, 2),
    ( Name == (>>) ; Name == (/) ),
    !.

%!  power(+Term) is semidet.
%
%   Whose value may be enormous though its arguments are small.

power(Term) :-
    compound(Term),
    (   Term = _<<_
    ;   ( Term = _**Exponent ; Term = _^Exponent ),
        \+ ( integer(Exponent), Exponent < 10 )
    ),
    !.

%!  sink(+Sink) is semidet.
%
%   Where a domain may write: to the log, or into a term.

sink(Sink) :-
    nonvar(Sink),
    (   memberchk(Sink, [user_error, user_output, current_output])
    ;   memberchk(Sink, [atom(_), string(_), codes(_), codes(_, _), chars(_), chars(_, _)])
    ),
    !.

%!  plain_format(+Codes) is semidet.
%
%   Without ~@ and ~W, which call what they are given.

plain_format([]).
plain_format([0'~|Codes]) :-
    !,
    argument_skipped(Codes, [Directive|Rest]),
    \+ memberchk(Directive, `@W`),
    plain_format(Rest).
plain_format([_|Codes]) :-
    plain_format(Codes).

argument_skipped([0'`, _|Codes], Codes) :- !.
argument_skipped([Code|Codes], Rest) :-
    memberchk(Code, `0123456789*:`),
    !,
    argument_skipped(Codes, Rest).
argument_skipped(Codes, Codes).

%!  plain_head(+Head) is semidet.
%
%   Succeeds for what may be the head of a clause of the file's own: it says nothing of another module or to Prolog.

plain_head(Head) :-
    functor(Head, Name, Arity),
    plain_name(Name),
    \+ memberchk(Name/Arity, [(:)/2, '[|]'/2, []/0, (-->)/2, (:-)/2, (:-)/1, (?-)/1, (=>)/2, (?=>)/2, (',')/2, (;)/2, (->)/2,
                              (*->)/2, ('|')/2, {}/1]).

%!  plain_name(+Name) is semidet.
%
%   Succeeds for a name that neither nppg nor Prolog keeps for itself.

plain_name(Name) :-
    \+ sub_atom(Name, 0, _, _, nppg_),
    \+ sub_atom(Name, 0, _, _, $).
