:- module(nppg_states,
          [ draw/2,              % +Module, -Start               det
            problem_numbers/2,   % +Module, -Numbers             det
            begin/3,             % +Module, +Number, -Start      det
            keep_static/3,       % +Module, +Data, -Number       det
            static_of/3,         % +Module, +Number, -Data       det
            static_drop/3,       % +Module, +Number, -True       det
            visit/4,             % +Module, +Static, +Data, -True  det
            step/4,              % +Module, +Gone, +New, -True   det
            observed/2,          % +Module, -Data                det
            horizon_of/2,        % +Module, -Steps               det
            situation/2,         % +Module, -Situation           det
            situation/3,         % +Module, +Lean, -Situation    det
            legal/3,             % +Module, +Serial, -Actions    det
            all_legal/3,         % +Module, +Serial, -Data       det
            nth_legal/4,         % +Module, +Serial, +Number, -Data  det
            expert_actions/2,    % +Module, -Data                det
            neighbours/2,        % +Module, -Answer              det
            take/5,              % +Module, +Lean, +Action, -Actions, -Answer  det
            outcomes_of/3,       % +Module, +Actions, -Outcomes  det
            reward_of/3,         % +Module, +Action, -Reward     det
            cost_of/3            % +Module, +Action, -Cost       det
          ]).

:- use_module(library(lists), [member/2, nth0/3]).
:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).
:- use_module(contract, [declared/2]).
:- use_module(domain).
:- use_module(guard, [fault/2]).
:- use_module(interpretation).
:- use_module(randomness, [without_draws/1]).
:- use_module(terms).
:- use_module(values, [must_be_actions/3, must_be_facts/4]).

/** <module> States, and what leads from one to another

What Python asks as it acts. A state crosses as what changes: its static facts under a number, and where an action has
been taken the facts that hold no longer, and those that did not hold before.
*/

%!  draw(+Module, -Start) is det: a random start state, which becomes the current one: [Static, Facts], with the number
%   of the static facts that hold there.

draw(Module, [Static, Data]) :-
    start(Module, Facts),
    in_force(Module, Static),
    encode_all(Facts, Data).

problem_numbers(Module, Numbers) :-
    numbered(Module, Numbers).

%!  begin(+Module, +Number, -Start) is det: the start state of that number, as `draw` gives one; [] where there is none.

begin(Module, Number, Start) :-
    (   problem(Module, Number, Facts)
    ->  in_force(Module, Static),
        encode_all(Facts, Data),
        Start = [Static, Data]
    ;   Start = []
    ).

%!  keep_static(+Module, +Data, -Number) is det: keeps the static facts of a problem.

keep_static(Module, Data, Number) :-
    decode_all(Data, Facts),
    must_be_facts(Module, problem/2, Facts, Static),
    sort(Facts, All),
    sort(Static, Sorted),
    ord_subtract(All, Sorted, Others),
    (   Others = [Fact|_]
    ->  fault(Module:(problem/2), '~w is not static'-[Fact])
    ;   new_static(Module, Sorted, Number)
    ).

static_of(Module, Number, Data) :-
    static_facts(Module, Number, Facts),
    encode_all(Facts, Data).

static_drop(Module, Number, true) :-
    drop_static(Module, Number).

%!  visit(+Module, +Static, +Data, -True) is det: makes a state current, with the static facts of that number.

visit(Module, Static, Data, true) :-
    enforce(Module, Static),
    decode_all(Data, Facts0),
    sort(Facts0, Facts),
    interpret(Module, Facts).

%!  step(+Module, +Gone, +New, -True) is det: makes the state current that differs from the current one in these facts.

step(Module, GoneData, NewData, true) :-
    decode_all(GoneData, Gone),
    decode_all(NewData, New),
    change(Module, Gone, New).

%!  observed(+Module, -Data) is det: the facts that are seen of the current state.

observed(Module, Data) :-
    observation(Module, Facts),
    encode_all(Facts, Data).

horizon_of(Module, Steps) :-
    horizon(Module, Steps).

has_dead_ends(Module) :-
    declared(Module, nppg_dead_ends).

%!  situation(+Module, -Situation) is det.
%
%   [Status, Actions] of the current state; [Status, Count, Serial] where there are many actions, which are kept for who
%   asks for them under this number.

situation(Module, Situation) :-
    situation(Module, false, Situation).

%!  situation(+Module, +Lean, -Situation) is det.
%
%   The same; where Lean is true, the actions stay unknown: [Status, -1, -1].

situation(Module, Lean, Situation) :-
    status(Module, Status),
    situation(Module, Lean, Status, _, Situation).

%   Actions are those that cross.

situation(Module, Lean, Status, Crossing, Situation) :-
    (   Status \== running
    ->  Situation = [Status, []],
        Crossing = []
    ;   Lean == true, some_action(Module)
    ->  Situation = [Status, -1, -1],
        Crossing = []
    ;   actions(Module, Actions),
        length(Actions, Count),
        (   Count > 100
        ->  flag(nppg_legal, Serial, Serial+1),
            nb_setval(nppg_legal, legal(Serial, Actions)),
            Situation = [Status, Count, Serial],
            Crossing = []
        ;   Actions \== []
        ->  Situation = [Status, Data],
            Crossing = Actions,
            (   encode_flat(Actions, Data)
            ->  true
            ;   must_be_actions(Module, action/1, Actions),
                encode_all(Actions, Data)
            )
        ;   has_dead_ends(Module)
        ->  Situation = [terminal, []],
            Crossing = []
        ;   fault(Module:(action/1), 'gave no legal action, though the state is neither goal nor terminal and no :- dead_ends are declared,'-[])
        )
    ).

%!  legal(+Module, +Serial, -Actions) is det.
%
%   The legal actions of the current state, which is the one of which Serial was given.

legal(Module, Serial, Actions) :-
    (   nb_current(nppg_legal, legal(Serial, Kept))
    ->  Actions = Kept
    ;   actions(Module, Actions)
    ).

%!  all_legal(+Module, +Serial, -Data) is det.

all_legal(Module, Serial, Data) :-
    legal(Module, Serial, Actions),
    must_be_actions(Module, action/1, Actions),
    encode_all(Actions, Data).

%!  nth_legal(+Module, +Serial, +Number, -Data) is det: one of them, from 0.

nth_legal(Module, Serial, Number, Data) :-
    legal(Module, Serial, Actions),
    nth0(Number, Actions, Action),
    must_be_actions(Module, action/1, [Action]),
    encode(Action, Data).

expert_actions(Module, Data) :-
    experts(Module, Actions),
    encode_all(Actions, Data).

%!  neighbours(+Module, -Answer) is det.
%
%   [Current, Neighbours]: the facts of the current state, and a list of [Action, Outcomes] for all legal actions, also
%   in a goal or terminal state. An outcome is [Probability, Facts], where a fact of the current state is given as its
%   number there, from 0.

neighbours(Module, [Data, Neighbours]) :-
    actions(Module, Actions),
    must_be_actions(Module, action/1, Actions),
    interpretation(Module, Current),
    encode_all(Current, Data),
    findall([Encoded, Outcomes],
            ( member(Action, Actions), encode(Action, Encoded), encoded_outcomes(Module, Action, Current, Outcomes) ),
            Neighbours).

encoded_outcomes(Module, Action, Current, Data) :-
    outcomes(Module, Action, Outcomes),
    findall([Probability, Facts],
            ( member(Probability-change(Gone, New), Outcomes),
              ord_subtract(Current, Gone, Kept),
              ord_union(Kept, New, Terms),
              encode_change(Terms, Current, 0, Facts) ),
            Data).

%   Both lists of facts are sorted.

encode_change([], _, _, []).
encode_change([Fact|Facts], Current, Number, [Data|Rest]) :-
    (   Current = [Old|More]
    ->  compare(Order, Fact, Old),
        encode_change(Order, Fact, Facts, Current, More, Number, Data, Rest)
    ;   encode(Fact, Data),
        encode_change(Facts, [], Number, Rest)
    ).

encode_change(=, _, Facts, _, More, Number, Number, Rest) :-
    Next is Number+1,
    encode_change(Facts, More, Next, Rest).
encode_change(<, Fact, Facts, Current, _, Number, Data, Rest) :-
    encode(Fact, Data),
    encode_change(Facts, Current, Number, Rest).
encode_change(>, Fact, Facts, _, More, Number, Data, Rest) :-
    Next is Number+1,
    encode_change([Fact|Facts], More, Next, [Data|Rest]).

%!  take(+Module, +Lean, +Action, -Actions, -Answer) is det.
%
%   Takes an action in the current state: [Reward, Gone, New, Situation] for the state that it leads to, which differs in
%   these facts. Situation is [] where asking for it goes wrong, which is to be heard only by who does ask. Actions are
%   the legal actions that are in it.

take(Module, Lean, ActionData, Actions, [Reward, GoneData, NewData, Situation]) :-
    decode(ActionData, Action),
    outcomes(Module, Action, Outcomes),
    chosen(Outcomes, change(Gone, New)),
    change(Module, Gone, New),
    (   catch(without_draws(status(Module, Found)), nppg_fault(_, _), fail)
    ->  Status = Found
    ;   true
    ),
    reward(Module, Action, Status, Reward),
    encode_all(Gone, GoneData),
    encode_all(New, NewData),
    (   nonvar(Found),
        catch(without_draws(situation(Module, Lean, Status, Crossing, Whole)), nppg_fault(_, _), fail)
    ->  Situation = Whole,
        Actions = Crossing
    ;   Situation = [],
        Actions = []
    ).

%!  outcomes_of(+Module, +Actions, -Outcomes) is det.
%
%   What each of the actions may lead to in the current state: a list of [Probability, Gone, New].

outcomes_of(Module, ActionsData, Data) :-
    decode_all(ActionsData, Actions),
    findall(Outcomes, ( member(Action, Actions), encoded_changes(Module, Action, Outcomes) ), Data).

encoded_changes(Module, Action, Data) :-
    outcomes(Module, Action, Outcomes),
    findall([Probability, GoneData, NewData],
            ( member(Probability-change(Gone, New), Outcomes), encode_all(Gone, GoneData), encode_all(New, NewData) ),
            Data).

%!  reward_of(+Module, +Action, -Reward) is det: for an action that has just led to the current state.

reward_of(Module, ActionData, Reward) :-
    decode(ActionData, Action),
    reward(Module, Action, _, Reward).

cost_of(Module, ActionData, Cost) :-
    decode(ActionData, Action),
    cost(Module, Action, Cost).

chosen([_-Change], Change) :-
    !.
chosen(Outcomes, Change) :-
    nppg_randomness:random(Float),
    pick(Outcomes, Float, Change).

pick([Probability-Change|Outcomes], Float, Chosen) :-
    (   ( Outcomes == [] ; Float < Probability )
    ->  Chosen = Change
    ;   Rest is Float-Probability,
        pick(Outcomes, Rest, Chosen)
    ).
