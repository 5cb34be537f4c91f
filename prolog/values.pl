:- module(nppg_values,
          [ must_be_facts/3,     % +Module, +Source, +Facts      det
            must_be_facts/4,     % +Module, +Source, +Facts, -Static  det
            must_be_actions/3,   % +Module, +Source, +Actions    det
            proper/1,            % +Term                         semidet
            defect/2,            % +Term, -Text                  det
            finite/1             % +Term                         semidet
          ]).

:- use_module(library(apply), [partition/4]).
:- use_module(library(lists), [member/2, memberchk/2]).
:- use_module(contract, [declared/2]).
:- use_module(guard, [fault/2]).

/** <module> What a domain may give as facts, actions and numbers

Source is the predicate, as Name/Arity, that gave them and is told to be at fault where they are none.
*/

must_be_facts(Module, Source, Facts) :-
    (   is_list(Facts)
    ->  true
    ;   fault(Module:Source, 'gave ~w where a list of facts is wanted,'-[Facts])
    ),
    (   all_facts(Facts, Module)
    ->  true
    ;   member(Fact, Facts), \+ fact(Module, Fact)
    ->  (   callable(Fact),
            functor(Fact, Name, Arity),
            declared(Module, nppg_static(Name/Arity))
        ->  fault(Module:Source, 'gave ~w, which is static: no effect can change it,'-[Fact])
        ;   defect(Fact, Defect),
            fault(Module:Source, 'gave ~w, which is no fact of a declared fluent~w,'-[Fact, Defect])
        )
    ).

all_facts([], _).
all_facts([Fact|Facts], Module) :-
    fact(Module, Fact),
    all_facts(Facts, Module).

%!  must_be_facts(+Module, +Source, +Facts, -Static) is det.
%
%   The same for what may have static facts, too; Static are these.

must_be_facts(Module, Source, Facts, Static) :-
    (   is_list(Facts),
        predicate_property(Module:nppg_static(_), defined),
        \+ \+ Module:nppg_static(_)
    ->  partition(static_fact(Module), Facts, Static, Others)
    ;   Static = [],
        Others = Facts
    ),
    must_be_facts(Module, Source, Others).

static_fact(Module, Fact) :-
    callable(Fact),
    functor(Fact, Name, Arity),
    Module:nppg_static(Name/Arity),
    proper(Fact).

fact(Module, Fact) :-
    callable(Fact),
    functor(Fact, Name, Arity),
    Module:nppg_fluent(Name/Arity),
    proper(Fact).

must_be_actions(Module, Source, Actions) :-
    (   all_actions(Actions), proper(Actions)
    ->  true
    ;   member(Action, Actions), \+ ( callable(Action), proper(Action) ),
        defect(Action, Defect),
        fault(Module:Source, 'gave ~w, which is no action~w,'-[Action, Defect])
    ).

all_actions([]).
all_actions([Action|Actions]) :-
    callable(Action),
    all_actions(Actions).

%   What can be compared, stored and handed to Python: finite, ground, made of names, integers and floats.

proper(Term) :-
    ground(Term),
    acyclic_term(Term),
    plain(Term).

plain(Term) :-
    (   compound(Term)
    ->  compound_name_arguments(Term, _, Args),
        all_plain(Args)
    ;   integer(Term)
    ->  true
    ;   float(Term)
    ->  Term =:= Term
    ;   atom(Term)
    ->  true
    ;   Term == []
    ).

all_plain([]).
all_plain([Term|Terms]) :-
    (   atom(Term)
    ->  true
    ;   plain(Term)
    ),
    all_plain(Terms).

defect(Term, Text) :-
    (   \+ ground(Term)
    ->  Text = ' (it has an unbound variable)'
    ;   \+ acyclic_term(Term)
    ->  Text = ' (it contains itself)'
    ;   \+ plain(Term)
    ->  Text = ' (only names, integers, floats and compounds of them can be part of one)'
    ;   Text = ''
    ).

finite(Number) :-
    number(Number),
    (   float(Number)
    ->  float_class(Number, Class),
        \+ memberchk(Class, [nan, infinite])
    ;   true
    ).
