"""Answers read off the facts are those of Prolog."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nppg.answers.coverage import Coverage, root_table
from nppg.answers.facts import FactTable, suffices
from nppg.answers.table import Table, TestTable
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.errors import NppgError
from nppg.logic.query import Query, Var, exact
from nppg.worlds.domain import Domain
from nppg.worlds.world import State

DOMAIN = """
:- module(meadow, []).
:- fluent at/1, flower/3, wet/0, near/2.
start([at(1)]).
action(go(1)).  action(go(2.5)).  action(go(a)).  action(pick(a, b)).  action(rest).
effect(_, [], []).
goal :- fail.
far(X) :- at(X), X > 3.
"""
BIAS = """
action: ["go(+place)", "pick(+thing, +thing)", rest]
types: {at: [place], flower: [thing, colour, size], wet: [], near: [thing, thing], far: [place]}
modes:
  - wet
  - at(+place)
  - flower(+thing, [red, blue], -size)
  - {literal: "flower(a, -colour, -size)", lookahead: 1}
  - {literal: "flower(+thing, red, -size)", lookahead: 1}
  - near(+thing, b)
  - equal(+thing, +thing)
  - equal(+place, [1, 1.0, a, 0, 0.0, -0.0])
  - at(-0.0)
  - at(0.0)
  - at(1)
  - at(1.0)
BOUNDS
lookahead: 1
"""
BOUNDS = '  - "+size =< #"'
numbers = st.sampled_from([0, 0.0, -0.0, 1, 1.0]) | st.integers(-3, 3) | st.floats(-3, 3, width=32)
things, colours = st.sampled_from(["a", "b"]), st.sampled_from(["red", "blue"])
facts = (
    st.tuples(st.just("at"), numbers | things)
    | st.tuples(st.just("flower"), things, colours, numbers)
    | st.tuples(st.just("near"), things, things)
    | st.just("wet")
)
PLACES = [1, 1.0, 0, 0.0, -0.0, 2.5, "a"]
ACTIONS = [*(("go", place) for place in PLACES), ("pick", "a", "b"), ("pick", "b", "b"), "rest"]


@pytest.fixture(scope="module")
def meadow(tmp_path_factory: pytest.TempPathFactory) -> Domain:
    path = tmp_path_factory.mktemp("meadow") / "meadow.pl"
    path.write_text(DOMAIN)
    return Domain(path)


@pytest.fixture(scope="module", params=[BOUNDS, BOUNDS.replace("=<", ">="), ""], ids=["=<", ">=", "truths"])
def tables(request: pytest.FixtureRequest, meadow: Domain, tmp_path_factory: pytest.TempPathFactory) -> list[Table]:
    path = tmp_path_factory.mktemp("bias") / "bias.yaml"
    path.write_text(BIAS.replace("BOUNDS", request.param))
    bias = LanguageBias.load(path)
    table = root_table(meadow, bias, Refiner(bias))
    asked = TestTable(meadow, bias)
    asked.add(table.tests)
    return [table, asked]


@given(st.lists(facts, max_size=8), st.lists(st.sampled_from(ACTIONS), min_size=1, max_size=4))
def test_the_answers_are_those_of_prolog(tables: list[Table], state: list, actions: list) -> None:
    read, asked = tables
    assert isinstance(read, FactTable) and len(read) > 10
    given_state: State = tuple({exact(fact): fact for fact in state}.values())
    expected = asked.answers(given_state, actions)
    found = read.answers(given_state, actions)
    assert found.dtype == expected.dtype
    np.testing.assert_array_equal(found, expected)
    for numbers in (found, expected):  # a limit is as good from either side of 0
        assert numbers.dtype == bool or ((numbers <= 0.0) == (numbers <= -0.0)).all()


def test_constants_that_python_takes_for_equal_are_tests_of_their_own(tables: list[Table]) -> None:
    constants = [test[0].args[0] for test in tables[0].tests if test[0].name == "="]
    assert [repr(each) for each in constants if not isinstance(each, str | Var)] == ["1", "1.0", "0", "0.0", "-0.0"]
    assert {repr(test[0].args[0]) for test in tables[0].tests if test[0].name == "at"} > {"-0.0", "0.0", "1", "1.0"}


@pytest.mark.parametrize(
    "mode",
    ["far(+place)", "near(-thing, -thing)", "near(-thing, b)", "flower(b, red, +size)"],
    ids=["no fluent", "two things", "a thing that others ask about", "a size that is asked about"],
)
def test_what_only_prolog_can_answer_is_left_to_it(meadow: Domain, bias_of: Callable, mode: str) -> None:
    bias = bias_of(BIAS.replace("BOUNDS", f"{BOUNDS}\n  - {mode}"))
    assert isinstance(root_table(meadow, bias, Refiner(bias)), TestTable)


def test_a_goal_is_left_to_prolog(blocks: Domain, plain_bias: LanguageBias) -> None:
    assert isinstance(root_table(blocks, plain_bias, Refiner(plain_bias)), TestTable)


def test_a_bound_below_a_test_without_lookahead(meadow: Domain, bias_of: Callable) -> None:
    """What no root test asks is asked at the node, with the same answers."""
    text = BIAS.replace("BOUNDS", BOUNDS).replace(", lookahead: 1}", "}")
    bias = bias_of(text)
    refiner = Refiner(bias)
    read = root_table(meadow, bias, refiner)
    assert isinstance(read, FactTable) and read.numeric and not read.bounds
    asked = TestTable(meadow, bias)
    asked.add(read.tests)
    states: list[State] = [(("flower", "a", "red", x),) for x in (1, 2.5, -3)] + [()]
    actions: list = [("pick", "a", "b")] * 4
    query = next(each.literals for each in refiner.refinements(()) if each.literals[0].name == "flower")
    candidates = refiner.refinements(query)
    assert any(each.is_open for each in candidates)
    found, expected = (
        Coverage(table, states, actions).matrix(candidates, np.arange(4), {})[0] for table in (read, asked)
    )
    np.testing.assert_array_equal(found, expected)
    assert set(found[:, [each.is_open for each in candidates]].ravel()) == {1, 2.5, -3, np.inf}


def test_what_is_no_number_is_reported(tmp_path: Path, bias_of: Callable) -> None:
    path = tmp_path / "odd.pl"
    path.write_text(DOMAIN.replace("start([at(1)])", "start([flower(a, red, big)])"))
    bias = bias_of(BIAS.replace("BOUNDS", BOUNDS))
    domain = Domain(path)
    table = root_table(domain, bias, Refiner(bias))
    with pytest.raises(
        NppgError, match=r"odd\.pl: flower/3 gave big, which is compared with a threshold and is no num"
    ):
        table.answers(domain.start(np.random.default_rng(0)), ["rest"])


SEVERAL = """
action: ["go(+place)", rest]
types: {flower: [thing, size, size]}
modes:
  - {literal: "flower(a, -size, -size)", lookahead: 1}
  - "+size =< #"
  - "+size >= #"
  - "+place >= #"
lookahead: 1
"""


@given(st.lists(st.tuples(st.just("flower"), things, numbers, numbers), max_size=8), st.randoms(use_true_random=False))
def test_several_bounds_of_one_fluent(meadow: Domain, several: LanguageBias, state: list, random: Random) -> None:
    """Down a path of tests with thresholds; and as a model asks them, all of them closed."""
    refiner = Refiner(several)
    read = root_table(meadow, several, refiner)
    asked = TestTable(meadow, several)
    asked.add(read.tests)
    given_state: State = tuple({exact(fact): fact for fact in state}.values())
    actions: list = [("go", 1), "rest"]
    query: Query = ()
    for _ in range(3):
        candidates = refiner.refinements(query)
        found, expected = (
            Coverage(table, [given_state] * 2, actions).matrix(candidates, np.arange(2), {})[0]
            for table in (read, asked)
        )
        np.testing.assert_array_equal(found, expected)
        chosen = random.choice([each for each in candidates if each.is_open]).closed(random.choice([-1, 0, 0.5, 2]))
        query += chosen.literals
        for table in (read, asked):
            table.add([chosen.test])
        np.testing.assert_array_equal(read.answers(given_state, actions), asked.answers(given_state, actions))
    assert isinstance(read, FactTable) and suffices(read.tests, meadow, several) and max(map(len, read.tests)) >= 2


@pytest.fixture(scope="module")
def several(tmp_path_factory: pytest.TempPathFactory) -> LanguageBias:
    path = tmp_path_factory.mktemp("bias") / "bias.yaml"
    path.write_text(SEVERAL)
    return LanguageBias.load(path)


@pytest.mark.parametrize("value", ["e", ("f", 1)])
def test_no_number(meadow: Domain, several: LanguageBias, value) -> None:
    table = root_table(meadow, several, Refiner(several))
    place = r"^\S*bias.yaml:[0-9]+:[0-9]+: \+\w+ [=<>]+ # compares what is no number: "
    with pytest.raises(NppgError, match=rf"{place}.* flower/3 gave"):
        table.answers((("flower", "a", value, 1),), ["rest"])


def test_numbers_beyond_floats(meadow: Domain, several: LanguageBias) -> None:
    read = root_table(meadow, several, Refiner(several))
    asked = TestTable(meadow, several)
    asked.add(read.tests)
    for value in (10**400, -(10**400), 2**70 + 1, 2**63 - 1, float("inf"), -float("inf")):
        state: State = (("flower", "a", value, 1),)
        np.testing.assert_array_equal(read.answers(state, ["rest"]), asked.answers(state, ["rest"]))
    assert np.isinf(read.answers((("flower", "a", 10**400, 0),), ["rest"])).any()
