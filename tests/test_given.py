"""What people hand over, from wherever: what is no state, no action or no finite number of the domain is told, with the
example's index, and never counts as something else in silence."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nppg import Domain, NppgError, Policy, TGOptions, generate_episode, language_bias_of, tilde
from nppg.bridge.plain import number
from nppg.experiments.train import train
from nppg.tilde import Example
from nppg.trees.tilde import Newton, grow
from nppg.trees.tree import Leaf
from nppg.worlds.state import Interpretation

WALK = """\
:- module(walk, []).
:- fluent at/1.
:- static road/2.
start([at(1), road(1, 2)]).
action(go).
action(stay(1)).
effect(_, [], []).
near(1).
terminal :- fail.
"""
BIAS = "action: [go, stay(+place)]\ntypes: {at: [place], road: [place, place]}\nmodes: ['at([-3, 1])']\n"
NO_NUMBERS: list[Any] = [
    float("nan"), float("inf"), -np.inf, np.float32("nan"), np.float16("inf"), np.longdouble("1e4000"),
    np.array(np.nan), None, "1.5", b"1", 1j, np.complex64(1), np.datetime64("2020"), [1.0], np.zeros(2), 1e200, 10**400,
]  # fmt: skip
NO_FACTS: list[Any] = [
    ("foo", 1), ("at", 1, 2), "at", ("near", 1), ("length", 1), "true", ("action", "go"), 5, (1, 2), (("at",), 1), (),
    ("at", np.nan), ("at", np.float32("nan")), ("at", ("f", np.nan)), ("at", None), ("at", True),
]  # fmt: skip
NO_STATES: list[Any] = [None, 5, "at(1)", b"at(1)", {"at": 1}, np.float64(1)]
NO_ACTIONS: list[Any] = ["jump", ("go", 1), "stay", ("stay", np.nan), None, np.nan, 5, ()]


@pytest.fixture
def walk(tmp_path: Path) -> Domain:
    path = tmp_path / "walk.pl"
    path.write_text(WALK)
    path.with_suffix(".yaml").write_text(BIAS)
    return Domain(path)


def examples(*last: Any) -> list[Any]:
    return [Example((("at", 1),), "go", 0.0), Example((("at", -3),), "go", 1.0), *last] * 3


def told(call: Callable[[], object], start: str = "") -> None:
    """It raises NppgError, with one line."""
    with pytest.raises(NppgError, match=f"^{re.escape(start)}") as caught:
        call()
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("wrong", NO_NUMBERS, ids=str)
def test_what_is_no_finite_number(wrong: Any, walk: Domain) -> None:
    bias = language_bias_of(walk)
    told(lambda: number("x", wrong))
    told(lambda: tilde.fit(examples(Example((("at", 1),), "go", wrong)), walk, bias), "examples[2]: the target")
    told(lambda: Policy(walk, bias).add(Leaf(1.0), wrong), "the step size")
    told(lambda: generate_episode(Policy(walk, bias), np.random.default_rng(0), wrong))
    if isinstance(wrong, float | np.floating):
        told(lambda: Policy(walk, bias).add(Leaf(float(wrong))), "the value of a leaf")


RIGHT: list[Any] = [1, True, 2.5, np.int8(1), np.float16(2.5), np.bool_(1), np.array([2.5]), np.array(1)]


@pytest.mark.parametrize("right", RIGHT)
def test_what_is_one(right: Any, walk: Domain) -> None:
    bias = language_bias_of(walk)
    found = tilde.fit([Example((("at", 1),), "go", right), Example((("at", 1),), "go", 0)], walk, bias)
    assert found == Leaf(float(np.ravel(right)[0]) / 2, 2)


@pytest.mark.parametrize("wrong", NO_FACTS, ids=str)
def test_what_is_no_fact_of_the_domain(wrong: Any, walk: Domain) -> None:
    bias, state = language_bias_of(walk), (("at", 1), wrong)
    told(lambda: tilde.fit(examples(Example(state, "go", 1.0)), walk, bias), "examples[2]: ")
    policy = Policy(walk, bias)
    policy.add(tilde.fit(examples(), walk, bias))
    for ask in (
        walk.situation, walk.horizon, walk.expert_actions, walk.neighbours, walk.picture, walk.interpreted,
        lambda state: walk.act(state, "go", np.random.default_rng(0)), lambda state: walk.outcomes(state, ["go"]),
        lambda state: walk.reward(state, "go"), lambda state: policy.potentials(state, ["go"]),
        lambda state: policy.act(state, np.random.default_rng(0)),
        lambda state: generate_episode(policy, np.random.default_rng(0), start=state),
    ):  # fmt: skip
        told(lambda ask=ask: ask(state))
    assert walk.situation((("at", 1),)).status == "running"


@pytest.mark.parametrize("wrong", NO_STATES, ids=str)
def test_what_is_no_state(wrong: Any, walk: Domain) -> None:
    told(lambda: walk.situation(wrong))
    told(lambda: Policy(walk, language_bias_of(walk)).act(wrong, np.random.default_rng(0)))
    told(lambda: tilde.fit(examples(Example(wrong, "go", 1.0)), walk, language_bias_of(walk)), "examples[2]: ")


@pytest.mark.parametrize("wrong", NO_ACTIONS, ids=str)
def test_what_is_no_action(wrong: Any, walk: Domain) -> None:
    bias, state = language_bias_of(walk), (("at", 1),)
    told(lambda: tilde.fit(examples(Example(state, wrong, 1.0)), walk, bias), "examples[2]: ")
    told(lambda: walk.act(state, wrong, np.random.default_rng(0)))
    told(lambda: walk.outcomes(state, [wrong]))
    told(lambda: walk.reward(state, wrong))


@pytest.mark.parametrize("wrong", [7, None, "abc", (1, 2), Example((), "go", 1.0)[:2]], ids=str)
def test_what_is_no_example(wrong: Any, walk: Domain) -> None:
    told(lambda: tilde.fit(examples(wrong), walk, language_bias_of(walk)), "examples[2]: ")
    told(lambda: tilde.fit([], walk, language_bias_of(walk)), "there is no example")


def test_states_of_another_domain(walk: Domain) -> None:
    other = Domain("blocks_world", {"blocks": 3}).start(np.random.default_rng(0))
    assert isinstance(other, Interpretation)
    told(lambda: walk.situation(other), f"{walk.path}: goal_on(")
    told(lambda: tilde.fit(examples(Example(other, "go", 1.0)), walk, language_bias_of(walk)), "examples[2]: goal_on(")


def test_a_list_that_somebody_changes_is_another_state(walk: Domain) -> None:
    state: list[Any] = [("at", 1)]
    assert walk.picture(state) == ["at(1)"]
    state[0] = ("at", 2)
    assert walk.picture(state) == ["at(2)"] and walk.interpreted(state).facts == (("at", 2),)


@pytest.mark.parametrize("wrong", [0, None, "seed", np.random.RandomState(0)], ids=str)
def test_what_is_no_generator(wrong: Any, walk: Domain) -> None:
    told(lambda: walk.start(wrong))
    told(lambda: walk.act((("at", 1),), "go", wrong))


def test_gradients_and_curvatures() -> None:
    for targets, curvatures, what in (([0, np.nan], [1, 1], "the target"), ([0, 1], [1, np.inf], "the curvature")):
        newton = Newton(np.array(curvatures, float), 0.1, 3.0)
        told(lambda t=targets, n=newton: grow(np.array(t, float), None, None, None, n), f"{what} of example 1 is")  # type: ignore[arg-type,misc]


@pytest.mark.parametrize("reward", ["1.0e200", "1.0e100", "-1.0e308"])
def test_rewards_whose_squares_are_no_numbers(reward: str, walk: Domain) -> None:
    walk.path.write_text(WALK + f"reward(_, {reward}).\nhorizon(3).\n")
    domain = Domain(walk.path)
    if reward == "1.0e100":
        assert domain.reward((("at", 1),), "go") == 1e100
        with pytest.raises(NppgError, match=r"^the target .* is larger than 1e\+100$"):
            list(train(domain, language_bias_of(domain), TGOptions(episodes=3, guidance=0)))
    else:
        told(lambda: domain.reward((("at", 1),), "go"), f"{walk.path}:10: reward/2 gave")
