"""NumPy's numbers count as Python's, wherever somebody hands them over; what is no number is told in one line."""

from __future__ import annotations

import json
from collections.abc import Callable
from enum import IntEnum
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nppg import (
    Domain,
    LanguageBias,
    NppgError,
    Options,
    Policy,
    RIBOptions,
    evaluate,
    language_bias_of,
    open_domain,
    run,
    tilde,
)
from nppg.answers.coverage import root_table, table_of
from nppg.answers.facts import FactTable
from nppg.bias.refinement import Refiner
from nppg.bridge.plain import alone
from nppg.bridge.terms import Compound, plain
from nppg.rrl.distance import PairDistance

WALK = """\
:- module(walk, []).
:- fluent at/1.
:- parameter(far, 9).
:- parameter(fast, false).
start([at(1)]).
action(go(1)).
action(go(-1)).
effect(go(S), [at(X)], [at(Y)]) :- at(X), Y is X + S.
goal :- at(X), parameter(far, Far), X >= Far.
"""
BIAS = """\
action: go(+step)
types: {at: [place]}
modes: ["at([-3, 1])", "equal(+step, [1, -1])"]
"""
WHOLE: list[Callable[[int], Any]] = [
    np.int64,
    np.int8,
    np.array,
    lambda n: np.array([n]),
    lambda n: np.array(n, object),
]
REAL: list[Callable[[float], Any]] = [np.float64, np.float32, np.float16, np.longdouble, np.array]


class Three(IntEnum):
    THREE = 3


@pytest.fixture
def walk(tmp_path: Path) -> Domain:
    path = tmp_path / "walk.pl"
    path.write_text(WALK)
    path.with_suffix(".yaml").write_text(BIAS)
    return Domain(path)


def rng() -> np.random.Generator:
    return np.random.default_rng(0)


def same(found: Any, expected: Any) -> bool:
    return found == expected and repr(found) == repr(expected)


@pytest.mark.parametrize("number", [*WHOLE, *REAL])
def test_a_number_alone_is_pythons(number: Callable) -> None:
    expected = 3 if number in WHOLE else 0.5
    assert same(alone(number(expected)), expected)
    assert same(plain([("p", number(expected), ("q", number(expected)))]), [("p", expected, ("q", expected))])


def test_what_is_no_number_stays() -> None:
    for each in (None, "a", [1], np.zeros(2), (np.int64(1),)):
        assert alone(each) is each
    assert alone(np.True_) is True and alone(np.str_("a")) == "a"


def test_terms_are_left_as_they_are() -> None:
    deep: tuple = ("[]",)
    for i in range(5000):
        deep = ("[|]", i, deep)
    for each in ("a", 1, 0.5, ("on", "a", "b"), ("f", ("g", 1)), deep, Three.THREE, Fraction(1, 2), Compound(("a", 1))):
        (found,) = plain([each])
        assert found is each or found == each
    assert same(plain([["on", "a", np.int64(1)]]), [("on", "a", 1)])


@pytest.mark.parametrize("wrong", [True, np.True_, None, 1j, np.complex64(1), np.zeros(2), b"x", {1}, {"a": 1}, ()])
def test_what_is_no_term_is_told(wrong: Any, walk: Domain) -> None:
    asked = [
        lambda: walk.situation((("at", wrong),)),
        lambda: walk.act((("at", 1),), ("go", wrong), rng()),
        lambda: Policy(walk, language_bias_of(walk)).distribution((("at", 1),), [("go", wrong)]),
    ]
    for each in asked:
        with pytest.raises(NppgError, match=r" is no term: that is a name, a number, or a tuple .*$") as caught:
            each()
        assert len(caught.value.problems) == 1


@pytest.mark.parametrize("number", WHOLE)
def test_a_domain_is_asked_with_them(number: Callable, walk: Domain) -> None:
    state, expected = (("at", number(1)),), (("at", 1),)
    assert walk.situation(state) == walk.situation(expected)
    assert walk.act(state, ("go", number(1)), rng()) == walk.act(expected, ("go", 1), rng()) == (0, (("at", 2),))
    assert walk.reward((("at", number(9)),), ("go", number(1))) == 1
    assert same(walk.neighbours(state), walk.neighbours(expected))
    assert walk.picture(state) == walk.picture(expected) and walk.parts(state) == walk.parts(expected)
    given = Domain(walk.path, {"far": number(2)})
    assert same(given.given, {"far": 2}) and same(given.parameters["far"], 2)


def test_truth_values_are_names_in_parameters(walk: Domain) -> None:
    for true in (True, np.True_, "true"):
        assert same(Domain(walk.path, {"fast": true}).parameters["fast"], "true")
    pytest.importorskip("gymnasium")
    domain = open_domain("gym:FrozenLake-v1", {"is_slippery": np.False_, "max_episode_steps": np.int64(7)})
    assert domain.horizon(()) == 7 and same(domain.given, {"is_slippery": "false", "max_episode_steps": 7})


@pytest.mark.parametrize("number", WHOLE)
def test_trees_are_those_of_pythons_numbers(number: Callable, walk: Domain) -> None:
    bias = language_bias_of(walk)

    def examples(number: Callable) -> list[tilde.Example]:
        return [
            tilde.Example((("at", number(-3 if i % 2 else 1)),), ("go", number(1)), float(i % 2)) for i in range(10)
        ]

    tree = tilde.fit(examples(int), walk, bias)
    assert tilde.fit(examples(number), walk, bias) == tree
    policy, other = Policy(walk, bias), Policy(walk, bias, table_of([], walk, bias))
    for each in (policy, other):
        each.add(tree)
        for place in (-3, 1, 5):
            state, actions = (("at", number(place)),), [("go", number(1)), ("go", number(-1))]
            expected = each.potentials((("at", place),), [("go", 1), ("go", -1)]).tolist()
            assert each.potentials(state, actions).tolist() == expected
            assert each.prolog_potentials(state, actions).tolist() == expected
            assert same(each.act(state, rng()), each.act((("at", place),), rng()))


@pytest.mark.parametrize("number", [*WHOLE, *REAL])
def test_tables_answer_as_for_pythons_numbers(number: Callable, walk: Domain) -> None:
    bias = LanguageBias.parse(
        """\
action: go(+step)
types: {at: [place]}
modes: [{literal: at(-place), lookahead: 1}, at(1), "equal(+step, [1, -1])", "+place =< #"]
lookahead: 1
""",
        "walk.yaml",
    )
    table = root_table(walk, bias, Refiner(bias))
    assert isinstance(table, FactTable)
    for place in (1, 2):
        state, actions = (("at", number(place)),), [("go", number(1)), ("go", number(-1))]
        exact = (("at", alone(number(place))),), [("go", alone(number(1))), ("go", alone(number(-1)))]
        np.testing.assert_array_equal(table.answers(state, actions), table.answers(*exact))
        pairs = PairDistance(walk, bias)
        assert pairs.describe(state, actions).tolist() == pairs.describe(*exact).tolist()


@pytest.mark.parametrize("number", [*WHOLE, *REAL])
def test_options_are_pythons(number: Callable) -> None:
    for kind in (Options, RIBOptions):
        options = kind(guidance=number(1))
        assert same(options, kind(guidance=alone(number(1))))
    if number in WHOLE:
        assert same(Options(episodes=number(3), seed=number(5)), Options(episodes=3, seed=5))
    else:
        with pytest.raises(NppgError, match=r"episodes must be a whole number, not 3.0"):
            Options(episodes=number(3))
    with pytest.raises(NppgError, match="guidance must be a number, not True"):
        Options(guidance=np.True_)  # type: ignore[arg-type]


def test_a_runs_numbers_are_pythons(walk: Domain, tmp_path: Path) -> None:
    bias, options = language_bias_of(walk), Options(episodes=np.int64(4), min_examples=np.int32(2), seed=np.uint8(3))  # type: ignore[arg-type]
    for folder, number in (("a", np.int64), ("b", int)):
        run(walk, bias, options, tmp_path / folder, number(2), number(3), until_success=np.float32(2))
    written, expected = ((tmp_path / folder / "run.json").read_text() for folder in "ab")
    assert json.loads(written)["options"] == json.loads(expected)["options"]
    policy = Policy(walk, bias)
    assert evaluate(policy, np.int64(3), seed=np.array(2)) == evaluate(policy, 3, seed=2)
    for wrong in (1.5, np.float64(3), "3", True, None):
        with pytest.raises(NppgError, match="starts must be a whole number, not "):
            evaluate(policy, wrong)  # type: ignore[arg-type]
        with pytest.raises(NppgError, match="seed must be a whole number, not "):
            evaluate(policy, 3, wrong)  # type: ignore[arg-type]


@pytest.mark.parametrize("number", WHOLE)
@pytest.mark.parametrize("bounded", [False, True])
def test_environments_take_them(number: Callable, bounded: bool) -> None:
    pytest.importorskip("gymnasium")
    from nppg.gym_env.bounded import BoundedEnv
    from nppg.gym_env.domain_env import DomainEnv

    def made(number: Callable) -> DomainEnv:
        given = {"blocks": number(4)}
        return BoundedEnv("blocks_world", given, slots=number(12)) if bounded else DomainEnv("blocks_world", given)

    env, expected = made(number), made(int)
    assert repr(env.reset(seed=number(3))) == repr(expected.reset(seed=3))
    assert repr(env.step(number(0))) == repr(expected.step(0))
    assert np.int64(3) in env.action_space and np.array(3) in env.action_space
    for wrong in (0.5, np.float64(0.5), None, "a", np.zeros(2)):
        with pytest.raises(NppgError, match=r"^the action .* is no whole number$"):
            env.step(wrong)  # type: ignore[arg-type]


@pytest.mark.parametrize("number", WHOLE)
def test_environments_as_domains_take_them(number: Callable) -> None:
    pytest.importorskip("gymnasium")
    domain = open_domain("gym:FrozenLake-v1", {"is_slippery": False})
    state = domain.start(rng())
    assert domain.situation((("obs", number(1), number(0)),)) == domain.situation(state)
    assert domain.act(state, ("do", number(1)), rng()) == (0.0, (("obs", 1, 4),))
    with pytest.raises(NppgError, match=r"is no action$"):
        domain.act((("obs", 1, 4),), ("do", number(9)), rng())
