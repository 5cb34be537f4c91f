"""What tables and packs answer is what each test, asked by itself, answers."""

from __future__ import annotations

from pathlib import Path
from random import Random

import janus_swi
import numpy as np
import pytest
from samples import pairs, random_query, relations, root_values, truth, visited

from nppg.answers.coverage import Coverage, root_table
from nppg.answers.table import TestTable
from nppg.answers.words import WORD
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, Refinement, Refiner
from nppg.errors import NppgError
from nppg.logic.query import Literal, Query, Var
from nppg.worlds.domain import Domain
from nppg.worlds.state import Interpretation
from nppg.worlds.world import Action, State


def asked_one_by_one(domain: Domain, bias: LanguageBias, query: Query, state: State, action: Action) -> bool:
    """The query as text, as a user would type it, put to Prolog after the values of the root variables."""
    known = relations(state)
    kind, values = root_values(bias, action, known)
    goals = [f"V{var.index} = {value}" for var, value in values.items() if value]
    for name, args in query:
        if name == KIND:
            goals.append("true" if args[0] == kind else "fail")
        else:
            written = [f"V{arg.index}" if isinstance(arg, Var) else str(arg) for arg in args]
            goals.append(" = ".join(written) if name == "=" else f"{name}({', '.join(written)})" if args else name)
    domain.visit(state)
    goal = {"Text": ", ".join(goals), "Module": domain.module}
    return janus_swi.query_once("atom_to_term(Text, _Goal, _), once(Module:_Goal)", goal)["truth"]


def test_the_oracles_agree(setting) -> None:
    """Prolog, asked one by one, and the predicates written down again in Python."""
    domain, bias, refiner, _ = setting
    states, actions = pairs(domain, visited(domain, 3))
    for seed in range(25):
        query = random_query(refiner, 1 + seed % 4, Random(seed))
        for state, action in list(zip(states, actions, strict=True))[seed % 3 :: 3]:
            (expected,) = truth([query], bias, state, [action])[0]
            assert asked_one_by_one(domain, bias, query, state, action) == expected, (query, state, action)


def test_the_table_answers_its_tests(setting) -> None:
    domain, bias, refiner, table = setting
    for seed in range(30):  # tests about new variables, several literals long
        query = random_query(refiner, seed % 4, Random(seed))
        table.add(each.test for each in refiner.refinements(query)[-12:])
    if "relational" in bias.file:
        table.add((Literal("on", (Var(0), f"b{i}")),) for i in range(1, WORD + 10))  # one group, several words
        assert len(table) > 2 * WORD and max(map(len, table.tests)) >= 3
    for state in visited(domain, 12):
        actions = domain.situation(state).actions
        assert (table.answers(state, actions) == truth(table.tests, bias, state, actions)).all()


def test_many_states_at_once(setting, monkeypatch: pytest.MonkeyPatch) -> None:
    domain, _, refiner, table = setting
    random = Random(1)
    table.add(each.test for each in refiner.refinements(random_query(refiner, 2, random))[-12:])
    some = [(state, list(domain.situation(state).actions)) for state in visited(domain, 12)]
    asked = [(state, random.sample(actions, random.randint(1, len(actions)))) for state, actions in 2 * some]
    random.shuffle(asked)
    asked[3] = (tuple(asked[3][0]), asked[3][1])
    expected = np.concatenate([table.answers(state, actions) for state, actions in asked])
    for size in (10_000, 50):
        monkeypatch.setattr("nppg.answers.table._AT_ONCE", size)
        assert (table.answers_in(asked) == expected).all()
        assert (table.answers(*asked[-1]) == expected[-len(asked[-1][1]) :]).all(), "the last state is the current one"
    assert table.answers_in([]).shape == (0, len(table))


def test_answers_that_come_along_are_those_that_are_asked_for(setting) -> None:
    domain, bias, refiner, table = setting
    alone = TestTable(Domain(domain.path, domain.parameters), bias)
    alone.add(table.tests)
    rng, tried = np.random.default_rng(4), 0
    while tried < 30:
        state = domain.start(rng)
        for step in range(4):
            actions = domain.situation(state).actions
            if not actions:
                break
            tried += 1
            if step == 2:  # others than in the state before
                extra = [each.test for each in refiner.refinements(random_query(refiner, 1, Random(tried)))[-3:]]
                table.add(extra)
                alone.add(extra)
            some = actions if tried % 3 else actions[::2]
            assert (table.answers(state, some) == alone.answers(state, list(some))).all()
            state = domain.act(state, actions[int(rng.random() * len(actions))], rng, lean=step == 3)[1]


def test_numbers_that_python_takes_for_equal_are_facts_apart(tmp_path: Path) -> None:
    (tmp_path / "row.pl").write_text(
        ":- module(row, []).\n:- fluent at/1.\nstart([at(1)]).\naction(go).\neffect(_, [], []).\ngoal :- fail.\n"
        "whole :- at(X), integer(X).\n"
    )
    (tmp_path / "row.yaml").write_text("action: [go]\ntypes: {whole: []}\nmodes: [whole]\n")
    domain, bias = Domain(tmp_path / "row.pl"), LanguageBias.load(tmp_path / "row.yaml")
    table = root_table(domain, bias, Refiner(bias))
    states = [Interpretation([("at", number)]) for number in (1, 1.0, 2, 1.0, 1)]
    answers = table.answers_in([(state, ["go"]) for state in states])
    assert answers[:, 0].tolist() == [True, False, True, False, True]


def test_actions_in_any_order_and_number(setting) -> None:
    domain, _, _, table = setting
    random = Random(0)
    for state in visited(domain, 5):
        actions = domain.situation(state).actions
        answers = table.answers(state, actions)
        order = [random.randrange(len(actions)) for _ in range(20)]
        assert (table.answers(state, [actions[i] for i in order]) == answers[order]).all()
        none, all_in_one = table.answers(state, []), table.answers_in([(state, []), (state, actions), (state, [])])
        assert none.shape == (0, len(table)) and none.dtype == answers.dtype
        assert (all_in_one == answers).all()


def test_tests_keep_their_columns_when_others_are_added(relational_bias: LanguageBias, blocks: Domain) -> None:
    refiner = Refiner(relational_bias)
    table = TestTable(blocks, relational_bias)
    tests = [each.test for each in refiner.refinements(())]
    (state,) = visited(blocks, 1)
    actions = blocks.situation(state).actions
    for i in range(0, len(tests), 7):
        table.add(tests[: i + 7])
        assert table.tests == tests[: i + 7]
        assert (table.answers(state, actions) == truth(table.tests, relational_bias, state, actions)).all()
    assert [table.place(test)[0] for test in tests] == list(range(len(tests)))


def check_path(coverage: Coverage, bias: LanguageBias, refiner: Refiner, random: Random, depth: int) -> int:
    """Goes down a random path as a tree would; returns how many of the answers were asked of packs."""
    members, known, query, asked = np.arange(len(coverage.actions)), {}, (), 0
    for _ in range(depth):
        candidates = refiner.refinements(query)
        random.shuffle(order := list(members))
        members = np.array(order)
        matrix, known = coverage.matrix(candidates, members, known)
        expected = np.concatenate(
            [
                truth([query + each.literals for each in candidates], bias, coverage.states[i], [coverage.actions[i]])
                for i in members
            ]
        )
        assert matrix.shape == (len(members), len(candidates)) and (matrix == expected).all()
        asked = len(known)
        useful = [i for i in range(len(candidates)) if matrix[:, i].sum() > 0]
        about_new = [i for i in useful if candidates[i].test not in coverage.table._index]
        new = [i for i in useful if _introduces(candidates[i], refiner)]
        if not useful:
            break
        chosen = random.choice(about_new or new or useful)
        if random.random() < 0.8:
            query += candidates[chosen].literals
            members = members[matrix[:, chosen]]
        elif not matrix[:, chosen].all():
            members = members[~matrix[:, chosen]]
    return asked


def _introduces(candidate: Refinement, refiner: Refiner) -> bool:
    return any(var.index >= refiner.root_count for literal in candidate.literals for var in literal.variables())


@pytest.mark.parametrize("seed", range(3))
def test_packs_answer_the_candidates_of_a_node(setting, seed: int) -> None:
    domain, bias, refiner, table = setting
    states, actions = pairs(domain, visited(domain, 5, seed))
    order = list(range(len(states)))
    Random(seed).shuffle(order)  # the examples of a state do not stand together
    order = order[:25]
    coverage = Coverage(table, [states[i] for i in order], [actions[i] for i in order])
    asked = check_path(coverage, bias, refiner, Random(seed), 4)
    assert asked > WORD or "relational" not in bias.file


def test_packs_about_several_kinds_of_actions(delivery: Domain, bias_of) -> None:
    bias = bias_of(
        """
action: [go(+room), pick(+parcel), drop(+parcel)]
goal: wanted(-parcel, -room)
types: {at: [room], in: [parcel, room], holding: [parcel]}
modes: ["in(+, -)", "in(-, +)", "in(+, +)", at(+), holding(+), holding(-), "equal(+parcel, +parcel)"]
max_variables: 3
"""
    )
    refiner = Refiner(bias)
    table = root_table(delivery, bias, refiner)
    states, actions = pairs(delivery, visited(delivery, 12))
    assert {action[0] for action in actions} == {"go", "pick", "drop"}
    asked = 0
    for seed in range(6):
        coverage = Coverage(table, states, actions)
        asked += check_path(coverage, bias, refiner, Random(seed), 4)
    assert asked


def test_a_pack_tries_every_answer_of_its_prefix(blocks: Domain, relational_bias: LanguageBias) -> None:
    """above(-V, X) has many answers; a test may succeed on any of them, and only on one."""
    x, new = Var(0), Var(4)
    prefix = (Literal("above", (new, x)),)
    table = TestTable(blocks, relational_bias)
    tower = sorted(("on", f"b{i}", f"b{i - 1}") for i in range(2, 9))
    state: State = (("goal_on", "b7", "b9"), ("on", "b1", "floor"), *tower, ("on", "b9", "floor"))
    candidates = [
        Refinement((literal,), (*prefix, literal), prefix)
        for literal in (Literal("on", (new, "b3")), Literal("on", (new, "b6")), Literal("on", (new, "b9")))
    ]
    table.add([prefix])
    coverage = Coverage(table, [state, state], [("move", "b2", "b9"), ("move", "b5", "b9")])
    matrix, _ = coverage.matrix(candidates, np.arange(2), {})
    assert matrix.tolist() == [[True, True, False], [False, True, False]]


def test_an_action_without_a_template_is_named(blocks: Domain, plain_bias: LanguageBias) -> None:
    table = root_table(blocks, plain_bias, Refiner(plain_bias))
    (state,) = visited(blocks, 1)
    with pytest.raises(NppgError, match="lift"):
        table.answers(state, [("lift", "b1")])
