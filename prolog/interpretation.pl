:- module(nppg_interpretation,
          [ interpret/2,         % +Module, +Facts       det
            interpretation/2,    % +Module, -Facts       det
            facts/2,             % +Module, -Count       det
            all_facts/2,         % +Module, -Count       det
            effective/5,         % +Module, +Delete, +Add, -Gone, -New  det
            change/3,            % +Module, +Gone, +New  det
            exchange/3,          % +Module, +Gone, +New  det
            new_static/3,        % +Module, +Facts, -Number  det
            static_facts/3,      % +Module, +Number, -Facts  semidet
            enforce/2,           % +Module, +Number      semidet
            in_force/2,          % +Module, -Number      det
            drop_static/2,       % +Module, +Number      det
            tampered/1,          % +Module               semidet
            forget_tables/2,     % +Module, +Heads       det
            forget/1             % +Module               det
          ]).

:- use_module(library(lists), [member/2, memberchk/2]).
:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).

/** <module> The current interpretation

Which facts hold in the state that is current in a domain. Fluents and static predicates are dynamic predicates of the
domain's module, so that domain code needs no state argument.

A state is an ordered set of ground facts of the fluents; making another state current touches only the facts in which
the two differ. The static facts of a problem are kept under a number, 0 where there are none, and are in force for all
of its states: they are exchanged when a state of another problem becomes current.
*/

:- dynamic
    current/3,                   % Module, Facts or `changed`, their number
    static_facts/3,              % Module, Number, Facts
    numbers/2,                   % Module, Number: the last one that was given
    enforced/3,                  % Module, Number, how many facts: none where it is 0
    tabling/2.                   % Module, Heads: tables of these hold for one interpretation only, others for one problem

%   Of larger states the list of facts is made only where it is asked for.

small(100).

interpretation(Module, Facts) :-
    (   current(Module, Known, Count)
    ->  (   Known == changed
        ->  stored(Module, Facts),
            set_current(Module, Facts, Count)
        ;   Facts = Known
        )
    ;   Facts = []
    ).

stored(Module, Facts) :-
    findall(Head,
            ( Module:nppg_fluent(Name/Arity), functor(Head, Name, Arity), clause(Module:Head, true) ),
            Found),
    msort(Found, Facts).

set_current(Module, Facts, Count) :-
    retractall(current(Module, _, _)),
    assertz(current(Module, Facts, Count)).

%!  facts(+Module, -Count) is det: how many facts of fluents hold.

facts(Module, Count) :-
    (   current(Module, _, Known)
    ->  Count = Known
    ;   Count = 0
    ).

%!  all_facts(+Module, -Count) is det: how many facts hold, static ones among them.

all_facts(Module, Count) :-
    facts(Module, Own),
    (   enforced(Module, _, Static)
    ->  Count is Own+Static
    ;   Count = Own
    ).

interpret(Module, Facts) :-
    interpretation(Module, Old),
    ord_subtract(Old, Facts, Gone),
    ord_subtract(Facts, Old, New),
    retract_all(Gone, Module),
    assertz_all(New, Module),
    length(Facts, Count),
    set_current(Module, Facts, Count),
    drop_answers(Module).

drop_answers(Module) :-
    (   tabling(Module, Heads)
    ->  drop_answers(Heads, Module)
    ;   true
    ).

drop_answers([], _).
drop_answers([Head|Heads], Module) :-
    abolish_table_subgoals(Module:Head),
    drop_answers(Heads, Module).

drop_all_answers(Module) :-
    (   tabling(Module, _)
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

%!  effective(+Module, +Delete, +Add, -Gone, -New) is det.
%
%   What deleting and then adding facts changes in the current state: the facts that hold no longer, and those that do
%   not hold yet, both sorted.

effective(Module, Delete, Add, Gone, New) :-
    sort(Delete, Deleted),
    sort(Add, Added),
    gone(Deleted, Module, Added, Gone),
    new(Added, Module, New).

gone([], _, _, []).
gone([Fact|Facts], Module, Added, Gone) :-
    (   holds(Module, Fact),
        \+ memberchk(Fact, Added)
    ->  Gone = [Fact|Rest]
    ;   Gone = Rest
    ),
    gone(Facts, Module, Added, Rest).

new([], _, []).
new([Fact|Facts], Module, New) :-
    (   holds(Module, Fact)
    ->  New = Rest
    ;   New = [Fact|Rest]
    ),
    new(Facts, Module, Rest).

holds(Module, Fact) :-
    Module:Fact,
    !.

%!  change(+Module, +Gone, +New) is det.
%
%   Makes the state current in which the facts Gone, which hold, do not, and the facts New do; both are sorted.

change(Module, Gone, New) :-
    facts(Module, Count0),
    (   small(Small),
        Count0 =< Small
    ->  interpretation(Module, Old),
        ord_subtract(Old, Gone, Kept),
        ord_union(Kept, New, Facts),
        length(Facts, Count),
        exchange(Module, Gone, New, Facts, Count)
    ;   exchange(Module, Gone, New)
    ).

%!  exchange(+Module, +Gone, +New) is det.
%
%   The same for facts in any order; no list of those that hold is made.

exchange(Module, Gone, New) :-
    facts(Module, Count0),
    length(Gone, Less),
    length(New, More),
    Count is Count0-Less+More,
    exchange(Module, Gone, New, changed, Count).

exchange(Module, Gone, New, Facts, Count) :-
    retract_all(Gone, Module),
    assertz_all(New, Module),
    set_current(Module, Facts, Count),
    drop_answers(Module).

%!  new_static(+Module, +Facts, -Number) is det.
%
%   Keeps the static facts of a problem.

new_static(Module, Facts, Number) :-
    (   Facts == []
    ->  Number = 0
    ;   (   retract(numbers(Module, Last))
        ->  true
        ;   Last = 0
        ),
        Number is Last+1,
        assertz(numbers(Module, Number)),
        assertz(static_facts(Module, Number, Facts))
    ).

drop_static(Module, Number) :-
    retractall(static_facts(Module, Number, _)).

in_force(Module, Number) :-
    (   enforced(Module, Known, _)
    ->  Number = Known
    ;   Number = 0
    ).

%!  enforce(+Module, +Number) is semidet.
%
%   Puts static facts into force, and those of another problem out of it. Fails where no such facts are kept.

enforce(Module, Number) :-
    in_force(Module, Old),
    (   Number == Old
    ->  true
    ;   (   Number == 0
        ->  Facts = []
        ;   static_facts(Module, Number, Facts)
        ),
        (   Old == 0
        ->  true
        ;   forall(( Module:nppg_static(Name/Arity), functor(Head, Name, Arity) ), retractall(Module:Head))
        ),
        assertz_all(Facts, Module),
        retractall(enforced(Module, _, _)),
        (   Number == 0
        ->  true
        ;   length(Facts, Count),
            assertz(enforced(Module, Number, Count))
        ),
        drop_all_answers(Module)
    ).

%!  tampered(+Module) is semidet.
%
%   True where the fluents are not those of the current state, because some code asserts or retracts them; in a large
%   state, where there are more or fewer.

tampered(Module) :-
    catch(stored(Module, Stored), _, fail),
    (   current(Module, changed, Count)
    ->  \+ length(Stored, Count)
    ;   interpretation(Module, Facts),
        Stored \== Facts
    ).

%!  forget_tables(+Module, +Heads) is det.
%
%   From now on drops the answers of the module's tabled predicates when another problem's facts come into force, and
%   those of the predicates with these heads when another state becomes current.

forget_tables(Module, Heads) :-
    assertz(tabling(Module, Heads)).

forget(Module) :-
    retractall(tabling(Module, _)),
    retractall(enforced(Module, _, _)),
    retractall(numbers(Module, _)),
    retractall(static_facts(Module, _, _)),
    retractall(current(Module, _, _)).
