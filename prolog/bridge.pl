:- module(nppg_bridge,
          [ ask/3                % +Name, +Args, -Answer    det
          ]).

:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(prolog_stack), []).
:- use_module(domain).
:- use_module(guard).
:- use_module(interpretation).
:- use_module(loading).
:- use_module(model).
:- use_module(potential).
:- use_module(query_pack).
:- use_module(randomness, [without_draws/1]).
:- use_module(report, [problems/2]).
:- use_module(state_text).
:- use_module(table).
:- use_module(terms).

/** <module> What Python asks

Every question is one predicate call(Name, Args..., Answer) below, with terms as data (see terms.pl).
*/

%   States come and go, and the clauses of old ones are collected. A second thread that does so makes every
%   other access to them slower.

:- set_prolog_gc_thread(false).

%!  ask(+Name, +Args, -Answer) is det.
%
%   Answer is [1, Value], or [0, Problems]; see report.pl.

ask(Name, Args, Answer) :-
    append(Args, [Value], All),
    Goal =.. [Name|All],
    (   catch(Goal, Error, true)
    ->  true
    ;   Error = nppg_problems([-('', 0, 0, Message)]),
        format(atom(Message), 'the question ~q failed', [Name])
    ),
    (   stopped(Fault)
    ->  problems(Fault, Problems),
        Answer = [0, Problems]
    ;   nonvar(Error)
    ->  problems(Error, Problems),
        Answer = [0, Problems]
    ;   Answer = [1, Value]
    ).

%!  aborted(+Question, -Nothing): asked after a question that Prolog aborted; throws what was to blame.

aborted(Question, _) :-
    (   stopped(Fault)
    ->  throw(Fault)
    ;   format(atom(Message), 'Prolog aborted the question ~q', [Question]),
        throw(nppg_problems([-('', 0, 0, Message)]))
    ).

load(File, Parameters, [Module, Description]) :-
    load_domain(File, Parameters, Module, Description).

unload(Module, true) :-
    unload_domain(Module).

limit(Limit, true) :-
    set_inference_limit(Limit).

version(Version) :-
    current_prolog_flag(version_data, swi(Major, Minor, Patch, _)),
    atomic_list_concat([Major, Minor, Patch], '.', Version).

%!  draw(+Module, -Facts) is det: a random start state, which becomes the current one.

draw(Module, Data) :-
    start(Module, Facts),
    encode_all(Facts, Data).

%!  visit(+Module, +Data, -True) is det: makes a state current.

visit(Module, Data, true) :-
    decode_all(Data, Facts0),
    sort(Facts0, Facts),
    interpret(Module, Facts).

%!  state_of(+Module, +Text, +Fluents, -Data) is det: the facts that a text lists; see state_text.pl.

state_of(Module, Text, Fluents, Data) :-
    read_state(Module, Text, Fluents, Facts),
    encode_all(Facts, Data).

drawing(Module, Lines) :-
    picture(Module, Lines).

%!  parts_of(+Module, -Data) is det: the lists that the current state consists of.

parts_of(Module, Data) :-
    parts(Module, Unordered),
    msort(Unordered, Parts),     % the order of answers follows that in which facts came to be
    maplist(maplist(encode), Parts, Data).

%!  binding_of(+Module, +Name, +Arity, -Data) is det: the arguments of the goal's only answer.

binding_of(Module, Name, Arity, Data) :-
    binding(Module, Name, Arity, Values),
    maplist(encode, Values, Data).

%!  observed(+Module, -Data) is det: the facts that are seen of the current state.

observed(Module, Data) :-
    observation(Module, Facts),
    encode_all(Facts, Data).

%!  intact(+Module, -Truth) is det: whether the fluents are what the state says, and domain code left them alone.

intact(Module, Truth) :-
    (   tampered(Module)
    ->  Truth = false
    ;   Truth = true
    ).

%!  texts(+Data, -Texts) is det: ground terms as Prolog reads them, whatever the operators: name(arg, ...).

texts(Data, Texts) :-
    decode_all(Data, Terms),
    findall(Text,
            ( member(Term, Terms), format(atom(Text), '~W', [Term, [quoted(true), ignore_ops(true), spacing(next_argument)]]) ),
            Texts).

horizon_of(Module, Steps) :-
    horizon(Module, Steps).

%!  situation(+Module, -Situation) is det: [Status, Actions] of the current state.

situation(Module, [Status, Data]) :-
    status(Module, Status),
    (   Status == running
    ->  actions(Module, Actions),
        (   Actions == []
        ->  fault(Module:(action/1), 'gave no legal action, though the state is neither goal nor terminal,'-[])
        ;   true
        ),
        encode_all(Actions, Data)
    ;   Data = []
    ).

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
    interpretation(Module, Current),
    encode_all(Current, Data),
    findall([Encoded, Outcomes],
            ( member(Action, Actions), encode(Action, Encoded), encoded_outcomes(Module, Action, Current, Outcomes) ),
            Neighbours).

encoded_outcomes(Module, Action, Current, Data) :-
    outcomes(Module, Action, Outcomes),
    findall([Probability, Facts],
            ( member(Probability-Terms, Outcomes), encode_change(Terms, Current, 0, Facts) ),
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

members(Module, Predicate, Data) :-
    objects(Module, Predicate, Objects),
    encode_all(Objects, Data).

%!  act(+Module, +Action, -Answer) is det.
%
%   Takes an action in the current state: [Reward, Facts, Situation] for the state that it leads to. Situation is []
%   where asking for it goes wrong, which is to be heard only by who does ask.

act(Module, ActionData, [Reward, Data, Situation]) :-
    decode(ActionData, Action),
    outcomes(Module, Action, Outcomes),
    chosen(Outcomes, Facts),
    interpret(Module, Facts),
    reward(Module, Action, Reward),
    encode_all(Facts, Data),
    (   catch(without_draws(situation(Module, Found)), nppg_fault(_, _), fail)
    ->  Situation = Found
    ;   Situation = []
    ).

%!  reward_of(+Module, +Action, -Reward) is det: for an action that has just led to the current state.

reward_of(Module, ActionData, Reward) :-
    decode(ActionData, Action),
    reward(Module, Action, Reward).

chosen([_-Facts], Facts) :-
    !.
chosen(Outcomes, Facts) :-
    nppg_randomness:random(Float),
    pick(Outcomes, Float, Facts).

pick([Probability-Facts|Outcomes], Float, Chosen) :-
    (   ( Outcomes == [] ; Float < Probability )
    ->  Chosen = Facts
    ;   Rest is Float-Probability,
        pick(Outcomes, Rest, Chosen)
    ).

table(Module, Kinds, Goal, Table) :-
    new_table(Module, Kinds, Goal, Table).

table_drop(Table, true) :-
    drop_examples(Table),
    drop_table(Table).

tests(Table, Kind, Group, Words, true) :-
    set_tests(Table, Kind, Group, Words).

answers(Table, Data, [Kinds, Words]) :-
    decode_all(Data, Actions),
    rows(Table, Actions, Kinds, Words).

examples(Table, StateData, ExampleData, true) :-
    maplist(decode_all, StateData, States0),
    maplist(sort, States0, States),
    findall([State, Action], ( member([State, Encoded], ExampleData), decode(Encoded, Action) ), Examples),
    load_examples(Table, States, Examples).

cover(Table, Packs, Examples, Words) :-
    coverage(Table, Packs, Examples, Words).

policy(Module, Signatures, Policy) :-
    new_policy(Module, Signatures, Policy).

policy_drop(Policy, true) :-
    drop_policy(Policy).

tree(Policy, Clauses, true) :-
    add_tree(Policy, Clauses).

potentials(Policy, Data, Potentials) :-
    findall(Potential, ( member(Encoded, Data), decode(Encoded, Action), potential(Policy, Action, Potential) ), Potentials).

rules(Policy, Tree, Texts) :-
    signatures(Policy, Signatures),
    findall(Text, ( rule(Policy, Tree, Clause), rule_text(Signatures, Clause, Text) ), Texts).

%!  parts(+Policy, +Tree, -Parts) is det: the rules of a tree, each as what it consists of; see model.pl.

parts(Policy, Tree, Parts) :-
    signatures(Policy, Signatures),
    findall(Rule, ( rule(Policy, Tree, Clause), rule_parts(Signatures, Clause, Rule) ), Parts).

save(File, Name, DomainFile, Facts, Policy, Comments, true) :-
    write_model(File, Name, DomainFile, Facts, Policy, Comments).

model(File, Model) :-
    read_model(File, Model).
