:- module(nppg_terms,
          [ encode/2,            % +Ground, -Data                 det
            decode/2,            % +Data, -Ground                 det
            literal/3,           % +Data, +Variables, -Literal    det
            literals/3,          % +DataList, +Variables, -Literals  det
            conjunction/2        % +Literals, -Goal               det
          ]).

/** <module> Terms as data for Python

A ground term crosses the bridge as an atom, a number or a tuple -(Name, Args...); the empty list, which is no
atom and in Python no constant, crosses as -('[]'). A literal of a query
crosses as a list [Name, Args...] in which an argument is the number of a variable or a list [Constant].
*/

encode(Term, Data) :-
    (   Term == []
    ->  Data = -('[]')
    ;   atomic(Term)
    ->  Data = Term
    ;   compound_name_arguments(Term, Name, Args),
        maplist(encode, Args, Encoded),
        Data =.. [-, Name|Encoded]
    ).

decode(Data, Term) :-
    (   atomic(Data)
    ->  Term = Data
    ;   Data = -('[]')
    ->  Term = []
    ;   Data =.. [-, Name|Encoded],
        maplist(decode, Encoded, Args),
        compound_name_arguments(Term, Name, Args)
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
