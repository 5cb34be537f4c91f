:- module(nppg_domain,
          [ start/2,             % +Module, -Facts               det
            problem/3,           % +Module, +Number, -Facts      semidet
            numbered/2,          % +Module, -Numbers             det
            cost/3,              % +Module, +Action, -Cost       det
            status/2,            % +Module, -Status              det
            actions/2,           % +Module, -Actions             det
            some_action/1,       % +Module                       semidet
            experts/2,           % +Module, -Actions             det
            observation/2,       % +Module, -Facts               det
            picture/2,           % +Module, -Lines               det
            parts/2,             % +Module, -Parts               det
            horizon/2,           % +Module, -Steps               det
            outcomes/3,          % +Module, +Action, -Outcomes   det
            reward/4,            % +Module, +Action, +Status, -Reward  det
            objects/3,           % +Module, +Predicate, -Objects  det
            binding/4            % +Module, +Name, +Arity, -Values  det
          ]).

:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [member/2]).
:- use_module(library(ordsets), [ord_subtract/3]).
:- use_module(contract, [environment/2]).
:- use_module(guard).
:- use_module(interpretation).
:- use_module(loading, [defines/2]).
:- use_module(values).

/** <module> What a loaded domain is asked

The predicates of its contract (see contract.pl), asked about the current state, and their answers, checked.
*/

%!  start(+Module, -Facts) is det.
%
%   Draws a start state and makes it current.

start(Module, Facts) :-
    (   environment(Module, Id)
    ->  fault(Module:(start/1), 'is a matter of the environment ~q: open the file by nppg.open_domain'-[Id])
    ;   guarded(Module:(start/1), Module:start(Drawn))
    ->  true
    ;   fault(Module:(start/1), 'failed'-[])
    ),
    begin(Module, start/1, Drawn, Facts).

%   Static facts that are in force already stay.

begin(Module, Source, Given, Facts) :-
    must_be_facts(Module, Source, Given, Static0),
    sort(Static0, Static),
    sort(Given, All),
    (   Static == []
    ->  Facts = All
    ;   ord_subtract(All, Static, Facts)
    ),
    in_force(Module, Old),
    (   ( Old == 0, Static == [] ; static_facts(Module, Old, Static) )
    ->  true
    ;   new_static(Module, Static, Number),
        enforce(Module, Number)
    ),
    interpret(Module, Facts).

%!  problem(+Module, +Number, -Facts) is semidet.
%
%   Makes the start state of that number current. Fails where the domain has none.

problem(Module, Number, Facts) :-
    guarded(Module:(problem/2), Module:problem(Number, Given)),
    begin(Module, problem/2, Given, Facts).

%!  numbered(+Module, -Numbers) is det.
%
%   The numbers of its problems, sorted.

numbered(Module, Numbers) :-
    guarded_findall(Number, Module:(problem/2), Module:problem(Number, _), Found),
    sort(Found, Numbers),
    (   Numbers == []
    ->  fault(Module:(problem/2), 'has no problem'-[])
    ;   member(Number, Numbers), \+ ( integer(Number), Number > 0 )
    ->  fault(Module:(problem/2), 'numbers a problem by ~w, not by a whole number from 1'-[Number])
    ;   true
    ).

%!  status(+Module, -Status) is det.
%
%   goal, terminal or running, for the current state.

status(Module, Status) :-
    (   defines(Module, goal/0), guarded(Module:(goal/0), Module:goal)
    ->  Status = goal
    ;   defines(Module, terminal/0), guarded(Module:(terminal/0), Module:terminal)
    ->  Status = terminal
    ;   Status = running
    ).

%!  actions(+Module, -Actions) is det.
%
%   The legal actions of the current state, sorted, so that their order is a function of the state alone. They are
%   ground; must_be_actions/3 says whether they are actions.

actions(Module, Actions) :-
    guarded_findall(Action, Module:(action/1), Module:action(Action), Found),
    sort(Found, Actions),
    (   ground(Actions), acyclic_term(Actions)
    ->  true
    ;   must_be_actions(Module, action/1, Actions)
    ).

%!  some_action(+Module) is semidet.
%
%   Whether the current state has a legal action.

some_action(Module) :-
    guarded(Module:(action/1), Module:action(_)).

experts(Module, Actions) :-
    (   defines(Module, expert/1)
    ->  guarded_findall(Action, Module:(expert/1), Module:expert(Action), Found),
        sort(Found, Actions),
        must_be_actions(Module, expert/1, Actions)
    ;   Actions = []
    ).

%!  observation(+Module, -Facts) is det.
%
%   What is seen of the current state, in a domain that defines observation/1.

observation(Module, Facts) :-
    (   guarded(Module:(observation/1), Module:observation(Seen))
    ->  must_be_facts(Module, observation/1, Seen),
        sort(Seen, Facts)
    ;   fault(Module:(observation/1), failed-[])
    ).

%!  picture(+Module, -Lines) is det.
%
%   The current state as lines of text.

picture(Module, Lines) :-
    (   defines(Module, picture/1)
    ->  (   guarded(Module:(picture/1), Module:picture(Drawn)), is_list(Drawn)
        ->  findall(Line, ( member(Part, Drawn), format(atom(Line), "~w", [Part]) ), Lines)
        ;   fault(Module:(picture/1), 'gave no list of lines'-[])
        )
    ;   interpretation(Module, Facts),
        findall(Line, ( member(Fact, Facts), format(atom(Line), '~q', [Fact]) ), Lines)
    ).

%!  parts(+Module, -Parts) is det.
%
%   The parts of the current state, in a domain that defines parts/1: a list of lists.

parts(Module, Parts) :-
    (   guarded(Module:(parts/1), Module:parts(Given)), is_list(Given), \+ ( member(Part, Given), \+ is_list(Part) )
    ->  (   member(Part, Given), member(Term, Part), \+ proper(Term)
        ->  defect(Term, Defect),
            fault(Module:(parts/1), 'gave ~w in a part~w,'-[Term, Defect])
        ;   Parts = Given
        )
    ;   fault(Module:(parts/1), 'gave no list of lists'-[])
    ).

horizon(Module, Steps) :-
    (   \+ defines(Module, horizon/1)
    ->  Steps = 100
    ;   guarded(Module:(horizon/1), Module:horizon(Given))
    ->  (   integer(Given), Given >= 0, Given =< 1 000 000 000
        ->  Steps = Given
        ;   fault(Module:(horizon/1), 'gave ~w where a number of steps from 0 to 1000000000 is wanted,'-[Given])
        )
    ;   fault(Module:(horizon/1), failed-[])
    ).

%!  outcomes(+Module, +Action, -Outcomes) is det.
%
%   Outcomes is a list of Probability-change(Gone, New): the facts that hold no longer in a state that the action may
%   lead to, and those that do not hold yet. The current state stays current.

outcomes(Module, Action, Outcomes) :-
    (   defines(Module, effect/3)
    ->  guarded_findall(effect(1, Delete, Add), Module:(effect/3), Module:effect(Action, Delete, Add), Certain),
        changes(Certain, effect/3, Module, Action, Outcomes, Others)
    ;   Outcomes = Others
    ),
    (   defines(Module, effect/4)
    ->  guarded_findall(effect(P, Delete, Add), Module:(effect/4), Module:effect(Action, P, Delete, Add), Drawn),
        changes(Drawn, effect/4, Module, Action, Others, [])
    ;   Others = []
    ),
    (   Outcomes == []
    ->  fault(Module:(action/1), 'allows ~w, which no effect covers,'-[Action])
    ;   Outcomes = [1-_]
    ->  true
    ;   foldl(add_probability, Outcomes, 0, Sum),
        (   abs(Sum-1) < 1.0e-9
        ->  true
        ;   length(Outcomes, Count),
            fault(Module:(action/1), 'allows ~w, which has ~d outcomes whose probabilities sum to ~4f and not to 1,'-[Action, Count, Sum])
        )
    ).

add_probability(Probability-_, Sum0, Sum) :-
    Sum is Sum0 + Probability.

changes([], _, _, _, Outcomes, Outcomes).
changes([effect(Probability, Delete, Add)|Effects], Source, Module, Action, [Probability-change(Gone, New)|Outcomes], End) :-
    (   number(Probability), Probability > 0, Probability =< 1
    ->  true
    ;   fault(Module:(effect/4), 'gave ~w as the probability of an outcome of ~w'-[Probability, Action])
    ),
    must_be_facts(Module, Source, Delete),
    must_be_facts(Module, Source, Add),
    effective(Module, Delete, Add, Gone, New),
    changes(Effects, Source, Module, Action, Outcomes, End).

%!  reward(+Module, +Action, ?Status, -Reward) is det.
%
%   The reward for Action, which has just led to the current state; its status may be known.

reward(Module, Action, Status, Reward) :-
    (   defines(Module, reward/2)
    ->  (   guarded(Module:(reward/2), Module:reward(Action, Given))
        ->  (   finite(Given), abs(Given) =< 1.0e100     % squares of larger ones are no numbers any more
            ->  Reward = Given
            ;   finite(Given)
            ->  fault(Module:(reward/2), 'gave ~w, but rewards go up to 1e100, for the action ~w'-[Given, Action])
            ;   fault(Module:(reward/2), 'gave ~w where a finite number is wanted, for the action ~w'-[Given, Action])
            )
        ;   fault(Module:(reward/2), 'failed for the action ~w'-[Action])
        )
    ;   ( nonvar(Status) -> true ; status(Module, Status) ),
        (   Status == goal
        ->  Reward = 1
        ;   Reward = 0
        )
    ).

%!  cost(+Module, +Action, -Cost) is det.
%
%   What Action costs in the current state.

cost(Module, Action, Cost) :-
    (   \+ defines(Module, cost/2)
    ->  Cost = 1
    ;   guarded(Module:(cost/2), Module:cost(Action, Given))
    ->  (   finite(Given), Given >= 0
        ->  Cost = Given
        ;   fault(Module:(cost/2), 'gave ~w where a finite number from 0 is wanted, for the action ~w'-[Given, Action])
        )
    ;   fault(Module:(cost/2), 'failed for the action ~w'-[Action])
    ).

%!  objects(+Module, +Predicate, -Objects) is det.
%
%   All X with Predicate(X) in the current state, sorted.

objects(Module, Predicate, Objects) :-
    Goal =.. [Predicate, Object],
    guarded_findall(Object, Module:(Predicate/1), Module:Goal, Found),
    sort(Found, Objects).

%!  binding(+Module, +Name, +Arity, -Values) is det.
%
%   The arguments of the goal's only answer in the current state.

binding(Module, Name, Arity, Values) :-
    functor(Goal, Name, Arity),
    guarded_findall(Goal, Module:(Name/Arity), Module:Goal, Answers0),
    sort(Answers0, Answers),
    (   Answers = [Answer]
    ->  (   proper(Answer)
        ->  Answer =.. [_|Values]
        ;   defect(Answer, Defect),
            fault(Module:(Name/Arity), 'gave ~w as the goal~w,'-[Answer, Defect])
        )
    ;   length(Answers, Count),
        fault(Module:(Name/Arity), 'is the goal template of the language bias and must have one answer, but has ~d'-[Count])
    ).
