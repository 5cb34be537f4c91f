:- module(nppg_interpretation,
          [ interpret/2,         % +Module, +Facts       det
            interpretation/2,    % +Module, -Facts       det
            facts/2,             % +Module, -Count       det
            change/3,            % +Module, +Delete, +Add  det
            tampered/1,          % +Module               semidet
            forget_tables/1,     % +Module               det
            forget/1             % +Module               det
          ]).

:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).

/** <module> The current interpretation

Which facts hold in the state that is current in a domain. Fluents are dynamic predicates of the domain's
module, so that domain code needs no state argument. A state is an ordered set of ground facts; making
another state current touches only the facts in which the two differ.
*/

:- dynamic
    current/3,                   % Module, Facts, their number
    tabling/1.                   % Module: its tables hold for one interpretation only

interpretation(Module, Facts) :-
    (   current(Module, Current, _)
    ->  Facts = Current
    ;   Facts = []
    ).

%!  facts(+Module, -Count) is det: how many facts hold.

facts(Module, Count) :-
    (   current(Module, _, Known)
    ->  Count = Known
    ;   Count = 0
    ).

interpret(Module, Facts) :-
    interpretation(Module, Old),
    ord_subtract(Old, Facts, Gone),
    ord_subtract(Facts, Old, New),
    retract_all(Gone, Module),
    assertz_all(New, Module),
    length(Facts, Count),
    retractall(current(Module, _, _)),
    assertz(current(Module, Facts, Count)),
    (   tabling(Module)
    ->  abolish_module_tables(Module)
    ;   true
    ).

retract_all([], _).
retract_all([Fact|Facts], Module) :-
    (   retract(Module:Fact)
    ->  true
    ;   true
    ),
    retract_all(Facts, Module).

assertz_all([], _).
assertz_all([Fact|Facts], Module) :-
    assertz(Module:Fact),
    assertz_all(Facts, Module).

change(Module, Delete, Add) :-
    interpretation(Module, Old),
    sort(Delete, Gone),
    sort(Add, New),
    ord_subtract(Old, Gone, Kept),
    ord_union(Kept, New, Facts),
    interpret(Module, Facts).

%!  tampered(+Module) is semidet.
%
%   True where the fluents are not those of the current state, because some code asserts or retracts them.

tampered(Module) :-
    interpretation(Module, Facts),
    catch(findall(Head,
                  ( Module:nppg_fluent(Name/Arity), functor(Head, Name, Arity), clause(Module:Head, true) ),
                  Stored),
          _, fail),
    msort(Stored, Sorted),
    Sorted \== Facts.

%!  forget_tables(+Module) is det.
%
%   From now on drops the answers of the module's tabled predicates when another state becomes current.

forget_tables(Module) :-
    assertz(tabling(Module)).

forget(Module) :-
    retractall(tabling(Module)),
    retractall(current(Module, _, _)).
