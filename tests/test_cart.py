"""Trees by scikit-learn: they are its own, and the same kind of tree as TILDE's."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from samples import pairs, visited

from nppg import Options, train
from nppg.answers.coverage import Coverage, root_table
from nppg.bias.declarations import TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.errors import NppgError
from nppg.policy.policy import Policy
from nppg.trees import cart, tilde
from nppg.trees.tree import Leaf, Node, Tree, leaves, mapped
from nppg.worlds.domain import Domain

tree_module = pytest.importorskip("sklearn.tree")

DOMAIN = """
:- module(slope, []).
:- fluent x/1, y/1, grass/1.
start([x(0), y(0)]).
action(go(a)).  action(go(b)).  action(stay).
effect(_, [], []).
goal :- fail.
"""
BIAS = """
action: ["go(+way)", stay]
types: {x: [length], y: [height], grass: [way]}
modes:
  - {literal: x(-length), lookahead: 1}
  - {literal: y(-height), lookahead: 1}
  - "+length =< #"
  - "+height >= #"
  - grass(+way)
lookahead: 1
"""


@pytest.fixture(scope="module")
def slope(tmp_path_factory: pytest.TempPathFactory) -> tuple[Domain, LanguageBias]:
    folder = tmp_path_factory.mktemp("slope")
    (folder / "slope.pl").write_text(DOMAIN)
    (folder / "slope.yaml").write_text(BIAS)
    return Domain(folder / "slope.pl"), LanguageBias.load(folder / "slope.yaml")


def sample(slope: tuple[Domain, LanguageBias], seed: int, size: int = 60) -> tuple[Coverage, np.ndarray]:
    """Random states, one in eight without a height, with every action; random targets."""
    domain, bias = slope
    rng = np.random.default_rng(seed)
    states, actions = [], []
    for _ in range(size):
        x, y = rng.random(2, np.float32).tolist()
        facts = [("grass", each) for each in "ab" if rng.random() < 0.5] + [("x", x)]
        states += [tuple(facts + ([("y", y)] if rng.random() < 7 / 8 else []))] * 3
        actions += [("go", "a"), ("go", "b"), "stay"]
    return Coverage(root_table(domain, bias, Refiner(bias)), states, actions), rng.normal(size=len(states))


def predicted(tree: Tree, coverage: Coverage) -> np.ndarray:
    """By the tests of the tree's own nodes."""

    def value(node: Tree, row: np.ndarray) -> float:
        while isinstance(node, Node):
            places = [coverage.table.place(test) for test in node.tests]
            node = node.yes if all(row[column] <= limit for column, limit in places) else node.no
        return node.value

    return np.array([value(tree, row) for row in coverage.bits])


@pytest.mark.parametrize("depth", [0, 1, 2, 4])
@pytest.mark.parametrize("seed", range(3))
def test_the_tree_is_that_of_scikit_learn(slope, seed: int, depth: int) -> None:
    coverage, targets = sample(slope, seed)
    tree = cart.grow(targets, coverage.bits, coverage.table, TreeLimits(depth, 3, 0.0))
    numbers = np.minimum(coverage.bits, 10)
    own = tree_module.DecisionTreeRegressor(max_depth=depth or None, min_samples_leaf=3, random_state=0)
    expected = own.fit(numbers, targets).predict(numbers) if depth else np.full(len(targets), targets.mean())
    assert leaves(tree) == (own.get_n_leaves() if depth else 1)
    np.testing.assert_allclose(predicted(tree, coverage), expected, rtol=1e-12)


@pytest.mark.parametrize("second_order", [False, True])
def test_clauses_numbers_and_saved_clauses_agree_to_the_bit(slope, tmp_path: Path, second_order: bool) -> None:
    domain, bias = slope
    coverage, _ = sample(slope, 9)
    policy = Policy(domain, bias, coverage.table)
    for seed in range(6):
        found, targets = sample(slope, seed)
        newton = tilde.Newton(np.abs(targets), 0.5, 3.0) if second_order else None
        policy.add(cart.grow(targets, found.bits, found.table, TreeLimits(4, 2), newton), 0.3)
    policy.save(tmp_path / "model.pl")
    loaded = Policy.load(tmp_path / "model.pl")
    for state in dict.fromkeys(coverage.states):
        actions = [("go", "a"), ("go", "b"), "stay"]
        fast = policy.potentials(state, actions).tolist()
        assert fast == policy.prolog_potentials(state, actions).tolist() == loaded.potentials(state, actions).tolist()
        assert fast == loaded.prolog_potentials(state, actions).tolist()


def test_a_bound_below_another_replaces_it_in_the_rules(slope) -> None:
    domain, bias = slope
    coverage, _ = sample(slope, 0)
    targets = np.array([np.floor(8 * next(fact[1] for fact in state if fact[0] == "x")) for state in coverage.states])
    policy = Policy(domain, bias, coverage.table)
    policy.add(cart.grow(targets, coverage.bits, coverage.table, TreeLimits(5, 1)))
    texts = policy.rules(1)
    assert max(text.count("=<") for text in texts) == 1 and texts[0].startswith(
        "delta(1, _, 0.0) :- x(Length), Length =<"
    )


def test_leaves_of_second_order_steps(slope) -> None:
    coverage, targets = sample(slope, 3)
    curvatures = np.random.default_rng(1).random(len(targets))
    newton = tilde.Newton(curvatures, 0.7, 1.5)
    tree = cart.grow(targets, coverage.bits, coverage.table, TreeLimits(3, 5), newton)
    found = predicted(tree, coverage)
    assert leaves(tree) > 4
    for value in set(found.tolist()):
        own = found == value
        expected = np.clip(targets[own].sum() / (curvatures[own].sum() + 0.7), -1.5, 1.5)
        assert value == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("k", [-40, -27, 13, 40])
def test_a_tree_does_not_hang_on_the_unit_of_its_targets(slope, k: int) -> None:
    coverage, targets = sample(slope, 5)
    unit, curvatures = 2.0**k, np.abs(targets) / 3
    for limits in (TreeLimits(5, 1), TreeLimits(5, 2, 0.0, 0.3)):
        one, other = (cart.grow(factor * targets, coverage.bits, coverage.table, limits) for factor in (1.0, unit))
        assert leaves(one) > 3 and other == mapped(one, lambda value: value * unit)
        steps = [tilde.Newton(factor * curvatures, factor * 0.25, 3.0) for factor in (1.0, unit)]
        assert cart.grow(targets, coverage.bits, coverage.table, limits, steps[0]) == cart.grow(
            unit * targets, coverage.bits, coverage.table, limits, steps[1]
        )


def test_limits_of_nodes(slope) -> None:
    coverage, targets = sample(slope, 4)
    full = cart.grow(targets, coverage.bits, coverage.table, TreeLimits(6, 1, 0.0))
    fewer = cart.grow(targets, coverage.bits, coverage.table, TreeLimits(6, 1, 0.0, 0.01))
    assert 1 <= leaves(fewer) < leaves(full)
    assert isinstance(cart.grow(targets, coverage.bits, coverage.table, TreeLimits(6, 1, 1e9)), Leaf)
    with pytest.raises(NppgError, match="granularity is TILDE's"):
        cart.grow(targets, coverage.bits, coverage.table, TreeLimits(granularity=3))


def test_relational_tests_without_numbers(delivery: Domain, delivery_bias: LanguageBias) -> None:
    """The table's own tests alone; where those do, the tree fits as well as TILDE's root."""
    states, actions = pairs(delivery, visited(delivery, 40))
    coverage = Coverage(root_table(delivery, delivery_bias, Refiner(delivery_bias)), states, actions)
    assert coverage.bits.dtype == bool
    targets = np.array([float(action[0] == "pick") if isinstance(action, tuple) else 0.0 for action in actions])
    policy = Policy(delivery, delivery_bias, coverage.table)
    policy.add(cart.grow(targets, coverage.bits, coverage.table, TreeLimits(3, 1)))
    for state in states[::7]:
        legal = delivery.situation(state).actions
        wanted = [float(isinstance(each, tuple) and each[0] == "pick") for each in legal]
        assert policy.potentials(state, legal).tolist() == wanted == policy.prolog_potentials(state, legal).tolist()


def test_scikit_learn_is_missing(slope, monkeypatch: pytest.MonkeyPatch) -> None:
    coverage, targets = sample(slope, 0)
    monkeypatch.setitem(__import__("sys").modules, "sklearn.tree", None)
    with pytest.raises(NppgError, match=r"needs scikit-learn: pip install 'nppg\[cart\]'"):
        cart.grow(targets, coverage.bits, coverage.table, TreeLimits())
    with pytest.raises(NppgError, match="needs scikit-learn"):  # before an episode is played
        next(train(coverage.table.domain, coverage.table.bias, Options(regressor="cart")))
