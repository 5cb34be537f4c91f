:- module(nppg_bridge,
          [ ask/3                % +Name, +Args, -Answer    det
          ]).

:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(prolog_stack), []).
:- use_module(call_graph, [static_predicate/2]).
:- use_module(contract, [contract/1]).
:- use_module(domain).
:- use_module(formula, [must_be_test/2]).
:- use_module(guard).
:- use_module(interpretation).
:- use_module(late, []).
:- use_module(layout, [layout/4]).
:- use_module(loading).
:- use_module(model).
:- use_module(potential).
:- use_module(problem_file).
:- use_module(query_pack).
:- use_module(randomness, [without_draws/1]).
:- use_module(report, [problems/2]).
:- use_module(rule_list).
:- use_module(schemas).
:- use_module(shapes).
:- use_module(source).
:- use_module(state_text).
:- use_module(states).
:- use_module(table).
:- use_module(terms).
:- use_module(used_files, [used_files/2]).

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

load(File, Parameters, Trust, [Module, Description]) :-
    load_domain(File, Parameters, Trust, Module, Description).

%!  dictionaries(+Truth, -Nothing) is det: whether the file that is loaded next may have some.

dictionaries(Truth, true) :-
    nb_setval(nppg_dicts, Truth).

unload(Module, true) :- unload_domain(Module).

limit(Limit, true) :- set_inference_limit(Limit).

version(Version) :-
    current_prolog_flag(version_data, swi(Major, Minor, Patch, _)),
    atomic_list_concat([Major, Minor, Patch], '.', Version).

%!  state_of(+Module, +Text, +Fluents, -Answer) is det: the static facts that a text lists, and the others; see state_text.pl.

state_of(Module, Text, Fluents, [StaticData, Data]) :-
    read_state(Module, Text, Fluents, Static, Facts),
    encode_all(Static, StaticData),
    encode_all(Facts, Data).

%!  problems_in(+Module, +File, -Problems) is det: the start states of a file, each [Name, Static, Facts].

problems_in(Module, File, Problems) :-
    read_problems(Module, File, Found),
    findall([Name, StaticData, Data],
            ( member(problem(Given, Static, Facts), Found),
              format(atom(Name), '~w', [Given]),
              encode_all(Static, StaticData),
              encode_all(Facts, Data) ),
            Problems).

%!  source(+Text, +Operators, -Rows) is det: a program as data; see source.pl.

source(Text, Operators, Rows) :-
    read_source(Text, Operators, Rows).

unchangeable(Indicators, Those) :-
    built_in(Indicators, Those).

harmless_built_in(Indicators, Those) :-
    pure_ones(Indicators, Those).

%!  taken(+Name, +Arity, -Truth) is det: whether a predicate of this name is not a domain file's to define.

taken(Name, Arity, Truth) :-
    functor(Head, Name, Arity),
    (   (   contract(Name/Arity)
        ;   member(Module, [system, nppg_randomness, nppg_formula]),
            predicate_property(Module:Head, defined)
        )
    ->  Truth = true
    ;   Truth = false
    ).

%!  harmless(+Module, +Indicators, -Nothing) is det: whether a language bias asks only what a test may ask.

harmless(Module, Indicators, true) :-
    forall(member([Name, Arity], Indicators), ( functor(Head, Name, Arity), must_be_test(Head, Module) )).

drawing(Module, Lines) :-
    picture(Module, Lines).

%!  shapes_of(+Module, -Shapes) is det: the current state as shapes; see shapes.pl.

shapes_of(Module, Shapes) :-
    shapes(Module, Shapes).

%!  parts_of(+Module, -Data) is det: the lists that the current state consists of.

parts_of(Module, Data) :-
    parts(Module, Unordered),
    msort(Unordered, Parts),     % the order of answers follows that in which facts came to be
    maplist(maplist(encode), Parts, Data).

%!  binding_of(+Module, +Name, +Arity, -Data) is det: the arguments of the goal's only answer.

binding_of(Module, Name, Arity, Data) :-
    binding(Module, Name, Arity, Values),
    maplist(encode, Values, Data).

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

members(Module, Predicate, Data) :-
    objects(Module, Predicate, Objects),
    encode_all(Objects, Data).

%!  answers_of(+Module, +Name, +Arity, -Data) is det: all answers of a predicate in the current state.

answers_of(Module, Name, Arity, Data) :-
    extension(Module, Name, Arity, Answers),
    maplist(encode_all, Answers, Data).

table(Module, Kinds, Goal, Table) :-
    new_table(Module, Kinds, Goal, Table).

is_static(Module, Name, Arity, Answer) :-
    (   static_predicate(Module, Name/Arity)
    ->  Answer = true
    ;   Answer = false
    ).

table_drop(Table, true) :-
    drop_examples(Table),
    drop_table(Table).

tests(Table, Dropped, Words, Kinds, true) :-
    set_tests(Table, Dropped, Words, Kinds).

%!  act(+Module, +Lean, +Table, +Action, -Answer) is det.
%
%   Takes an action, as states.pl says; with what a table answers about the legal actions of the state that it leads to,
%   as `answers` gives it, behind the situation: [] where Table is none, there are no actions, or asking goes wrong.

act(Module, Lean, Table, Data, [Reward, Gone, New, Situation, Answers]) :-
    take(Module, Lean, Data, Actions, [Reward, Gone, New, Situation]),
    (   Actions \== [],
        Table \== '',
        catch(without_draws(rows(Table, Actions, Kinds, Words)), nppg_fault(_, _), fail)
    ->  Answers = [Kinds, Words]
    ;   Answers = []
    ).

answers(Table, Data, [Kinds, Words]) :-
    decode_all(Data, Actions),
    rows(Table, Actions, Kinds, Words).

%!  answers_in(+Table, +Facts, +States, -Answers) is det.
%
%   The same for actions in many states, one after the other. A state is [Static, Gone, New, Actions]: the number of its
%   static facts, and how it differs from the state before it, the first one from the current state, by the numbers of
%   facts in Facts, from 1.

answers_in(Table, FactData, States, [Kinds, Words]) :-
    layout(Table, Module, _, _),
    decode_all(FactData, Facts),
    compound_name_arguments(Known, facts, Facts),
    answers_in(States, Known, Module, Table, Kinds, Words).

answers_in([], _, _, _, [], []).
answers_in([[Static, GoneNumbers, NewNumbers, Data]|States], Known, Module, Table, Kinds, Words) :-
    known(GoneNumbers, Known, Gone),
    known(NewNumbers, Known, New),
    enforce(Module, Static),
    exchange(Module, Gone, New),
    decode_all(Data, Actions),
    rows(Table, Actions, OwnKinds, OwnWords),
    append(OwnKinds, MoreKinds, Kinds),
    append(OwnWords, MoreWords, Words),
    answers_in(States, Known, Module, Table, MoreKinds, MoreWords).

known([], _, []).
known([Number|Numbers], Known, [Fact|Facts]) :-
    arg(Number, Known, Fact),
    known(Numbers, Known, Facts).

%!  answers_legal(+Table, +Serial, -Answers) is det: the same for the legal actions of the current state.

answers_legal(Table, Serial, [Kinds, Words]) :-
    layout(Table, Module, _, _),
    legal(Module, Serial, Actions),
    rows(Table, Actions, Kinds, Words).

examples(Table, StateData, ExampleData, true) :-
    maplist(decode_state, StateData, States),
    findall([State, Action], ( member([State, Encoded], ExampleData), decode(Encoded, Action) ), Examples),
    load_examples(Table, States, Examples).

decode_state([Static, Data], Static-Facts) :-
    decode_all(Data, Facts0),
    sort(Facts0, Facts).

cover(Table, Packs, Examples, Words) :-
    coverage(Table, Packs, Examples, Words).

policy(Module, Signatures, Policy) :-
    new_policy(Module, Signatures, Policy).

policy_drop(Policy, true) :-
    forget_rules(Policy),
    drop_policy(Policy).

tree(Policy, Clauses, true) :-
    add_tree(Policy, Clauses).

potentials(Policy, Data, Potentials) :-
    findall(Potential, ( member(Encoded, Data), decode(Encoded, Action), potential(Policy, Action, Potential) ), Potentials).

%!  preferred_actions(+Policy, -Data) is det: of a policy of one tree, the best legal actions in the current state.

preferred_actions(Policy, Data) :-
    preferred(Policy, Actions),
    encode_all(Actions, Data).

preferred_action(Policy, Float, Data) :-
    preferred(Policy, Float, Action),
    encode(Action, Data).

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
