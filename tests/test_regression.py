"""A tree for each kind of action is what would be grown from that kind's examples alone."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from samples import pairs, visited

from nppg.answers.coverage import Coverage
from nppg.bias.declarations import Template
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND
from nppg.learning.options import Options
from nppg.learning.regressors import REGRESSORS, Examples, PerAction, Regressor, kinds_of_actions, regressor
from nppg.learning.training import train
from nppg.logic.query import Literal, Var
from nppg.policy.policy import Policy
from nppg.trees.tilde import Newton
from nppg.trees.tree import Leaf, Node, Tree
from nppg.worlds.domain import Domain

PER_ACTION = Options(models="per-action")


@pytest.fixture(params=REGRESSORS)
def options(request: pytest.FixtureRequest) -> Options:
    if request.param == "cart":
        pytest.importorskip("sklearn")
    return replace(PER_ACTION, regressor=request.param)


def sample(learner: Regressor, domain: Domain, count: int, seed: int, newton: bool = False) -> Examples:
    """Every action of some states, with random targets."""
    states, actions = pairs(domain, visited(domain, count))
    rng = np.random.default_rng(seed)
    answers = Coverage(learner.table, states, actions).bits
    step = Newton(rng.random(len(actions)), 0.3, 2.0) if newton else None
    return Examples(states, actions, answers, rng.normal(size=len(actions)), step)


def predicted(tree: Tree, learner: Regressor, found: Examples) -> list[float]:
    policy = Policy(learner.table.domain, learner.table.bias, learner.table)
    policy.add(tree)
    return policy.potentials_of(Coverage(learner.table, found.states, found.actions).bits).tolist()


@pytest.mark.parametrize("newton", [False, True])
def test_each_kind_has_the_tree_of_a_bias_without_the_others(delivery: Domain, delivery_bias, options, newton) -> None:
    learner = regressor(delivery, delivery_bias, options)
    found = sample(learner, delivery, 40, 1, newton)
    tree = learner.fit(found)
    together, compared = np.array(predicted(tree, learner, found)), 0
    for template in delivery_bias.actions:
        alone = REGRESSORS[options.regressor](delivery, replace(delivery_bias, actions=(template,)))
        own = np.flatnonzero([action[0] == template.name for action in found.actions])
        mine = found.of(own)
        mine = replace(mine, answers=Coverage(alone.table, mine.states, mine.actions).bits)
        assert predicted(alone.fit(mine), alone, mine) == together[own].tolist()
        compared += len(own)
    assert compared == len(together) and len(set(together.tolist())) >= len(delivery_bias.actions)
    one = regressor(delivery, delivery_bias, replace(options, models="one")).fit(found)
    assert predicted(one, learner, found) != together.tolist()


def test_second_order_leaves_are_clipped(delivery: Domain, delivery_bias, options) -> None:
    learner = regressor(delivery, delivery_bias, options)
    found = sample(learner, delivery, 40, 1, newton=True)
    assert found.newton
    found = replace(found, newton=replace(found.newton, clip=0.01))
    assert np.abs(predicted(learner.fit(found), learner, found)).max() == 0.01


def test_the_kind_is_asked_first(delivery: Domain, delivery_bias, options) -> None:
    learner = regressor(delivery, delivery_bias, options)
    tree = learner.fit(sample(learner, delivery, 20, 2))
    for kind in range(3):
        assert isinstance(tree, Node) and tree.literals == (Literal(KIND, (kind,)),)
        tree = tree.no
    assert tree == Leaf(0.0)


def test_kinds_without_an_example_get_0(delivery: Domain, delivery_bias, options) -> None:
    learner = regressor(delivery, delivery_bias, options)
    found = sample(learner, delivery, 40, 3)
    others = [i for i, action in enumerate(found.actions) if action[0] != "pick"]
    values = predicted(learner.fit(found.of(np.array(others))), learner, found)
    assert len(others) < len(values)
    for action, value in zip(found.actions, values, strict=True):
        assert (value == 0.0) == (action[0] == "pick")


CONSTANTS = """
action: step({types})
types: {{cell: [place], far: [direction, speed]}}
modes:
  - {{literal: cell(-place), lookahead: 1}}
  - "+place =< #"
  - far(+, +)
{modes}
lookahead: 1
"""


@pytest.mark.parametrize(
    ("types", "modes", "expected"),
    [
        ("+direction", "equal(+direction, [0, 1])", [(0,), (1,)]),
        ("+direction", "equal([b, a], +direction); equal(+direction, c)", [("b",), ("a",), ("c",)]),
        ("+direction", "equal(+speed, 1)", []),
        ("+direction, +speed", "equal(+direction, [0, 1])", []),
        (
            "+direction, +speed",
            "equal(+direction, [0, 1]); equal(+speed, [9, 7])",
            [(0, 9), (0, 7), (1, 9), (1, 7)],
        ),
    ],
)
def test_constants_tell_actions_of_one_kind_apart(bias_of, types: str, modes: str, expected: list[tuple]) -> None:
    bias = bias_of(CONSTANTS.format(types=types, modes="\n".join(f"  - {each}" for each in modes.split("; "))))
    found = kinds_of_actions(bias)
    assert found == [tuple(Literal("=", (Var(i), each)) for i, each in enumerate(row)) for row in expected]
    assert kinds_of_actions(replace(bias, actions=(Template("stay", ()),))) == []


def test_a_model_for_each_constant(chain: tuple[Domain, LanguageBias], options, tmp_path: Path) -> None:
    """The tree of that constant's examples; also of one that no mode names. And the rules can be read back."""
    domain, bias = chain
    learner = regressor(domain, bias, options)
    assert isinstance(learner, PerAction)
    states, actions = pairs(domain, [(("cell", x),) for x in (1, 2, 3)])
    states, actions = (
        [each for each in states for _ in "123"],
        [step for _ in range(6) for step in [("step", k) for k in (0, 1, 7)]],
    )
    answers = Coverage(learner.table, states, actions).bits
    targets = np.array([10.0 * k + state[0][1] ** 2 for state, (_, k) in zip(states, actions, strict=True)])
    found = Examples(states, actions, answers, targets)
    tree = learner.fit(found)
    assert isinstance(tree, Node) and tree.literals == (Literal("=", (Var(0), 0)),)
    policy = Policy(domain, bias, learner.table)
    policy.add(tree)
    potentials = policy.potentials_of(answers)
    for constant in (0, 1, 7):
        own = np.flatnonzero([action[1] == constant for action in actions])
        alone = regressor(domain, bias, replace(options, models="one"))
        expected = predicted(alone.fit(found.of(own)), alone, found.of(own))
        assert potentials[own] == pytest.approx(expected)
    assert policy.rules(1)[0].startswith("delta(1, step(0), ")
    policy.save(tmp_path / "model.pl")
    loaded = Policy.load(tmp_path / "model.pl")
    for state, action in zip(states, actions, strict=True):
        expected = policy.potentials(state, [action]).tolist()
        assert loaded.potentials(state, [action]).tolist() == expected
        assert loaded.prolog_potentials(state, [action]).tolist() == expected


def test_without_kinds_both_are_the_same(four_blocks: Domain, plain_bias) -> None:
    runs = [[*train(four_blocks, plain_bias, Options(episodes=30, models=each))] for each in ("one", "per-action")]
    one, several = (run[-1].policy.trees for run in runs)
    assert one == several and len(one) > 1
