:- module(nppg_state_text,
          [ read_state/5         % +Module, +Text, +Fluents, -Static, -Facts  det
          ]).

:- use_module(library(lists), [member/2]).
:- use_module(library(ordsets), [ord_subtract/3]).
:- use_module(contract, [declared/2]).
:- use_module(report, [shown/2]).
:- use_module(values).

/** <module> States as people write them: on(b1, b2), on(b2, floor)
*/

%!  read_state(+Module, +Text, +Fluents, -Static, -Facts) is det.
%
%   The sorted facts that a text lists, static ones apart; Fluents are the indicators, as atoms, that may be meant where
%   one is none.
%
%   @throws nppg_problems(Problems)

read_state(Module, Text, Fluents, Static, Facts) :-
    listed(Module, Text, Terms),
    findall(Problem, ( member(Term, Terms), no_fact(Module, Term, Fluents, Problem) ), Problems),
    (   Problems == []
    ->  sort(Terms, Sorted),
        must_be_facts(Module, start/1, Sorted, Static),
        ord_subtract(Sorted, Static, Facts)
    ;   throw(nppg_problems(Problems))
    ).

listed(Module, Text, Terms) :-
    format(string(Listed), '[~w]', [Text]),
    catch(term_string(Terms, Listed, [module(Module)]), error(syntax_error(What), _), no_list(What, Text)),
    (   is_list(Terms)
    ->  true
    ;   no_list(no_list, Text)
    ).

no_list(What, Text) :-
    format(atom(Message), 'a state is a list of facts, like on(b1, b2), on(b2, floor): ~w in ~q', [What, Text]),
    throw(nppg_problems([-('', 0, 0, Message)])).

holdable(Module, Spec) :-
    (   Module:nppg_fluent(Spec)
    ->  true
    ;   declared(Module, nppg_static(Spec))
    ).

no_fact(Module, Term, Fluents, Problem) :-
    shown(Term, Shown),
    (   callable(Term), functor(Term, Name, Arity), holdable(Module, Name/Arity)
    ->  \+ proper(Term),
        defect(Term, Defect),
        format(atom(Message), '~w is no fact~w', [Shown, Defect]),
        Problem = -('', 0, 0, Message)
    ;   (   callable(Term)
        ->  functor(Term, Name, Arity),
            format(atom(Named), '~w/~w', [Name, Arity])
        ;   Named = ''
        ),
        format(atom(Message), '~w is no fact of a declared fluent', [Shown]),
        Problem = -('', 0, 0, Message, Named, Fluents)
    ).
