:- module(nppg_terms,
          [ encode/2,            % +Ground, -Data                 det
            decode/2,            % +Data, -Ground                 det
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
    (   Term == []
    ->  Data = ['[]']
    ;   atomic(Term)
    ->  Data = Term
    ;   compound_name_arguments(Term, Name, Args),
        maplist(encode, Args, Encoded),
        Data = [Name|Encoded]
    ).

decode(Data, Term) :-
    (   atomic(Data)
    ->  Term = Data
    ;   (   Data = [Name|Encoded]
        ->  true
        ;   Data =.. [-, Name|Encoded]
        ),
        (   Name == '[]', Encoded == []
        ->  Term = []
        ;   maplist(decode, Encoded, Args),
            compound_name_arguments(Term, Name, Args)
        )
    ).

literal([Name|Data], Variables, Literal) :-
    maplist(argument(Variables), Data, Args),
    Literal =.. [Name|Args].

argument(Variables, Data, Arg) :-
    (   Data = [Constant]
    ->  Arg = Constant
    ;   N is Data+1,
        arg(N, Variables, Arg)
    ).

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
