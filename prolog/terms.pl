:- module(nppg_terms,
          [ encode/2,            % +Ground, -Data                 det
            encode_all/2,        % +Grounds, -DataList            det
            encode_flat/2,       % +Grounds, -DataList            semidet
            decode/2,            % +Data, -Ground                 det
            decode_all/2,        % +DataList, -Grounds            det
            literal/3,           % +Data, +Variables, -Literal    det
            literals/3,          % +DataList, +Variables, -Literals  det
            conjunction/2        % +Literals, -Goal               det
          ]).

/** <module> Terms as data for Python

A ground term is in Python a name, a number or a tuple (name, args...); the empty list, which is no atom and in
Python no constant, is the tuple ('[]',). A tuple reaches Prolog as -(Name, Args...), but leaves it as a list: every
tuple that janus 1.5 makes stays in memory for ever. A literal of a query crosses as a list [Name, Args...] in which an
argument is the number of a variable or a list [Constant].
*/

encode(Term, Data) :-
    (   compound(Term)
    ->  compound_name_arguments(Term, Name, Args),
        Data = [Name|Encoded],
        encode_all(Args, Encoded)
    ;   Term == []
    ->  Data = ['[]']
    ;   Data = Term
    ).

encode_all([], []).
encode_all([Term|Terms], [Data|Rest]) :-
    (   atom(Term)
    ->  Data = Term
    ;   encode(Term, Data)
    ),
    encode_all(Terms, Rest).

%!  encode_flat(+Grounds, -DataList) is semidet.
%
%   The same for names, and compounds of names and integers; fails where there is something else.

encode_flat([], []).
encode_flat([Term|Terms], [Data|Rest]) :-
    (   atom(Term)
    ->  Data = Term
    ;   compound(Term),
        compound_name_arguments(Term, Name, Args),
        constants(Args),
        Data = [Name|Args]
    ),
    encode_flat(Terms, Rest).

constants([]).
constants([Arg|Args]) :-
    (   atom(Arg)
    ->  true
    ;   integer(Arg)
    ),
    constants(Args).

decode(Data, Term) :-
    (   atomic(Data)
    ->  Term = Data
    ;   (   Data = [Name|Encoded]
        ->  true
        ;   compound_name_arguments(Data, -, [Name|Encoded])
        ),
        (   Name == '[]', Encoded == []
        ->  Term = []
        ;   decode_all(Encoded, Args),
            compound_name_arguments(Term, Name, Args)
        )
    ).

decode_all([], []).
decode_all([Data|Rest], [Term|Terms]) :-
    (   atom(Data)
    ->  Term = Data
    ;   decode(Data, Term)
    ),
    decode_all(Rest, Terms).

literal([Name|Data], Variables, Literal) :-
    arguments(Data, Variables, Args),
    Literal =.. [Name|Args].

arguments([], _, []).
arguments([Data|Rest], Variables, [Arg|Args]) :-
    (   Data = [Constant]
    ->  Arg = Constant
    ;   N is Data+1,
        arg(N, Variables, Arg)
    ),
    arguments(Rest, Variables, Args).

literals([], _, []).
literals([Data|Rest], Variables, [Literal|Literals]) :-
    literal(Data, Variables, Literal),
    literals(Rest, Variables, Literals).

conjunction([], true).
conjunction([Goal|Goals], Conjunction) :-
    (   Goals == []
    ->  Conjunction = Goal
    ;   Conjunction = (Goal, Rest),
        conjunction(Goals, Rest)
    ).
