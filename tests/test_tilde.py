"""Growing one regression tree: planted trees are found again, and every split is the best there is."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import numpy as np
import pytest
from samples import pairs, truth, value_of_tree, visited

from nppg.answers.coverage import Coverage
from nppg.bias.declarations import TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.logic.query import Literal, Query, Var
from nppg.trees.tilde import Example, Newton, best_split, f_test, fit, grow
from nppg.trees.tree import Leaf, Node, Tree, leaves, mapped
from nppg.worlds.domain import Domain

UNBOUNDED = TreeLimits(max_depth=99, min_examples=1, min_variance=0.0)
X, Y, A, B = map(Var, range(4))


def node(test: Query, yes: Tree, no: Tree) -> Node:
    return Node(test, (test,), yes, no)


def literal(name: str, *args) -> Query:
    return (Literal(name, args),)


def structure(tree: Tree) -> Tree:
    """The tree without its numbers of examples, its values rounded."""
    if isinstance(tree, Leaf):
        return Leaf(round(tree.value, 9))
    return Node(tree.literals, tree.tests, structure(tree.yes), structure(tree.no))


def depth(tree: Tree) -> int:
    return 0 if isinstance(tree, Leaf) else 1 + max(depth(tree.yes), depth(tree.no))


def all_leaves(tree: Tree) -> list[Leaf]:
    return [tree] if isinstance(tree, Leaf) else all_leaves(tree.yes) + all_leaves(tree.no)


def sse(tree: Tree, bias: LanguageBias, examples: list[Example]) -> float:
    return sum((each.value - value_of_tree(tree, bias, each.state, each.action)) ** 2 for each in examples)


@pytest.fixture(scope="module")
def sample(blocks: Domain) -> tuple[list, list]:
    return pairs(blocks, visited(blocks, 25))


def test_a_planted_tree_is_found_again(blocks: Domain, plain_bias: LanguageBias, sample) -> None:
    planted = node(
        literal("clear", A),
        node(literal("=", Y, "floor"), Leaf(20.0), node(literal("above", X, A), Leaf(13.0), Leaf(14.0))),
        node(literal("above", X, B), Leaf(-2.0), Leaf(1.0)),
    )
    bias = replace(plain_bias, tree=UNBOUNDED)
    examples = [Example(s, a, value_of_tree(planted, bias, s, a)) for s, a in zip(*sample, strict=True)]
    tree = fit(examples, blocks, bias)
    assert sse(tree, bias, examples) == 0
    assert isinstance(tree, Node) and tree.literals == literal("clear", A)
    fresh = zip(*pairs(blocks, visited(blocks, 20, seed=1)), strict=True)
    assert all(value_of_tree(tree, bias, s, a) == value_of_tree(planted, bias, s, a) for s, a in fresh)


def test_a_planted_tree_over_new_variables_is_found_again(blocks: Domain, relational_bias, sample) -> None:
    """Below on(V, X) is asked what else is above V: a test about the variable that the node above introduced."""
    new = Var(4)
    first, second = literal("above", new, A), literal("on", B, new)
    planted = Node(first, (first,), Node(second, (first + second,), Leaf(9.0), Leaf(5.0)), Leaf(0.0))
    bias = replace(relational_bias, tree=UNBOUNDED)
    examples = [Example(s, a, value_of_tree(planted, bias, s, a)) for s, a in zip(*sample, strict=True)]
    assert {each.value for each in examples} == {9.0, 5.0, 0.0}
    tree = fit(examples, blocks, bias)
    assert sse(tree, bias, examples) == 0
    assert leaves(tree) <= 4


@pytest.mark.parametrize("limits", [TreeLimits(3, 4, 0.0), TreeLimits(99, 8, 0.05)])
def test_every_split_is_the_best_by_brute_force(setting, limits: TreeLimits) -> None:
    domain, bias, refiner, table = setting
    states, actions = pairs(domain, visited(domain, 5))
    targets = np.random.default_rng(0).normal(size=len(actions))
    tree = grow(targets, Coverage(table, states, actions), refiner, limits)
    assert depth(tree) <= limits.max_depth

    def weighted(answers: np.ndarray, values: np.ndarray) -> float:
        """Of the two branches; infinite where one is too small."""
        if min(answers.sum(), (~answers).sum()) < limits.min_examples:
            return np.inf
        return sum(values[branch].var() * branch.sum() for branch in (answers, ~answers)) / len(values)

    def check(tree: Tree, query: Query, members: np.ndarray, level: int) -> None:
        values = targets[members]
        candidates = refiner.refinements(query)
        answers = np.concatenate(
            [truth([query + each.literals for each in candidates], bias, states[i], [actions[i]]) for i in members]
        )
        scores = [weighted(column, values) for column in answers.T]
        if isinstance(tree, Leaf):
            assert tree.examples == len(values)
            assert tree.value == pytest.approx(values.mean(), abs=1e-12)
            stopped = level == limits.max_depth or values.var() < limits.min_variance
            assert stopped or min(scores, default=np.inf) >= values.var() - 1e-9
            return
        (chosen,) = [i for i, each in enumerate(candidates) if each.literals == tree.literals]
        assert scores[chosen] == pytest.approx(min(scores), abs=1e-9)
        assert min(np.flatnonzero(np.isclose(scores, min(scores), rtol=1e-12, atol=1e-12))) == chosen
        assert tree.tests == (candidates[chosen].test,)
        covered = answers[:, chosen]
        check(tree.yes, query + tree.literals, members[covered], level + 1)
        check(tree.no, query, members[~covered], level + 1)

    check(tree, (), np.arange(len(targets)), 0)


@pytest.fixture(scope="module")
def columns(plain_bias: LanguageBias, sample) -> np.ndarray:
    """The truth of every test of the bias, in each example; there are no new variables."""
    tests = [each.test for each in Refiner(plain_bias).refinements(())]
    return np.array([truth(tests, plain_bias, state, [action])[0] for state, action in zip(*sample, strict=True)])


@pytest.mark.parametrize("max_depth", [1, 2, 3])
@pytest.mark.parametrize("min_examples", [1, 5])
def test_as_good_as_scikit_learn_on_the_columns(
    blocks: Domain, plain_bias: LanguageBias, sample, columns: np.ndarray, max_depth: int, min_examples: int
) -> None:
    """Without new variables all tests are columns that are known beforehand."""
    learner = pytest.importorskip("sklearn.tree").DecisionTreeRegressor
    states, actions = sample
    targets = np.random.default_rng(1).normal(size=len(actions)) + columns @ np.linspace(-1, 1, columns.shape[1])
    bias = replace(plain_bias, tree=TreeLimits(max_depth, min_examples, 0.0))
    examples = [Example(*each) for each in zip(states, actions, targets.tolist(), strict=True)]
    theirs = learner(max_depth=max_depth, min_samples_leaf=min_examples, random_state=0).fit(columns, targets)
    expected = ((theirs.predict(columns) - targets) ** 2).sum()
    assert sse(fit(examples, blocks, bias), bias, examples) == pytest.approx(expected, rel=1e-9)


def test_the_order_of_the_examples_does_not_matter_to_fit(four_blocks: Domain, relational_bias: LanguageBias) -> None:
    states, actions = pairs(four_blocks, visited(four_blocks, 20))
    targets = [float(Random(str(each)).randrange(8)) for each in zip(states, actions, strict=True)]
    examples = [Example(*each) for each in zip(states, actions, targets, strict=True)]
    shuffled = Random(0).sample(examples, len(examples))
    assert structure(fit(examples, four_blocks, relational_bias)) == structure(
        fit(shuffled, four_blocks, relational_bias)
    )


def test_limits(blocks: Domain, plain_bias: LanguageBias, sample) -> None:
    noise = np.random.default_rng(2).normal(size=len(sample[0])).tolist()
    examples = [Example(*each) for each in zip(*sample, noise, strict=True)]

    def tree(**limits) -> Tree:
        return fit(examples, blocks, replace(plain_bias, tree=replace(UNBOUNDED, **limits)))

    assert depth(tree()) > 5
    assert tree(max_depth=0) == Leaf(pytest.approx(np.mean(noise)), len(noise))
    assert [depth(tree(max_depth=d)) for d in (1, 2, 5)] == [1, 2, 5]
    for least in (2, 7, 30):
        sizes = [leaf.examples for leaf in all_leaves(tree(min_examples=least))]
        assert min(sizes) >= least and sum(sizes) == len(noise)
    assert leaves(tree(min_examples=len(noise))) == 1
    variance = float(np.var(noise))
    assert leaves(tree(min_variance=variance * 1.01)) == 1 < leaves(tree(min_variance=variance * 0.99))
    assert leaves(tree(significance=1e-6)) == 1 < leaves(tree(significance=0.05)) < leaves(tree(significance=1.0))


def test_a_leaf_is_the_mean_and_constant_targets_are_not_split(blocks: Domain, plain_bias, sample) -> None:
    examples = [Example(s, a, 0.1) for s, a in zip(*sample, strict=True)]
    tree = fit(examples, blocks, replace(plain_bias, tree=UNBOUNDED))
    assert tree == Leaf(pytest.approx(0.1, abs=1e-15), len(examples))


def times(tree: Tree, unit: float) -> Tree:
    return mapped(tree, lambda value: value * unit)


@pytest.mark.parametrize("k", [-40, -27, -9, 13, 40])
def test_a_tree_does_not_hang_on_the_unit_of_its_targets(setting, k: int) -> None:
    """To the bit, whatever stops its growth; and second-order steps do not, where curvatures have the same unit."""
    domain, bias, refiner, table = setting
    coverage = Coverage(table, *pairs(domain, visited(domain, 12)))
    rng, unit = np.random.default_rng(1), 2.0**k
    targets = rng.normal(size=len(coverage.actions)) * rng.choice([1.0, 1e-3, 1e-7], len(coverage.actions))
    assert leaves(grow(targets, coverage, refiner, TreeLimits(5, 1))) > 8
    for limits in (TreeLimits(5, 1), TreeLimits(5, 3, 1e-9, 0.1), TreeLimits(4, 2, 0.0)):
        expected = grow(targets, coverage, refiner, limits)
        assert grow(unit * targets, coverage, refiner, limits) == times(expected, unit)
        states, actions = coverage.states, coverage.actions
        examples = [Example(*each) for each in zip(states, actions, (unit * (targets + 0.5)).tolist(), strict=True)]
        shifted = [each._replace(value=each.value / unit) for each in examples]
        own = replace(bias, tree=limits)
        assert fit(examples, domain, own) == times(fit(shifted, domain, own), unit)
        curvatures = np.abs(targets) * rng.random(len(targets))
        one, other = Newton(curvatures, 0.25, 3.0), Newton(unit * curvatures, unit * 0.25, 3.0)
        assert grow(unit * targets, coverage, refiner, limits, other) == grow(targets, coverage, refiner, limits, one)


def test_a_stated_variance_is_absolute_and_the_default_in_the_unit(blocks: Domain, plain_bias, sample) -> None:
    small = [Example(s, a, 1e-5 * i % 7e-5) for i, (s, a) in enumerate(zip(*sample, strict=True))]
    for limits, grown in ((TreeLimits(), True), (TreeLimits(min_variance=1e-8), False)):
        assert (leaves(fit(small, blocks, replace(plain_bias, tree=limits))) > 1) == grown


def test_equal_candidates_the_first_wins() -> None:
    values = np.array([0.0, 0.0, 1.0, 1.0])
    good = values > 0
    answers = np.array([values > 2, ~good, good, good]).T
    assert best_split(answers, values, UNBOUNDED) == (1, 0.5)
    assert best_split(answers[:, :1], values, UNBOUNDED) is None


@pytest.mark.parametrize(
    ("degrees", "level", "critical"),
    [
        (1, 0.05, 161.448),
        (2, 0.05, 18.513),
        (10, 0.05, 4.965),
        (10, 0.01, 10.044),
        (30, 0.05, 4.171),
        (120, 0.05, 3.920),
    ],
)
def test_critical_values_of_the_f_distribution(degrees: int, level: float, critical: float) -> None:
    assert f_test(critical, degrees) == pytest.approx(level, rel=5e-4)


def test_the_f_test_is_scipys() -> None:
    stats = pytest.importorskip("scipy.stats")
    for degrees in (1, 2, 3, 10, 57, 1000, 20_000):
        for f in (0.0, 1e-6, 0.01, 0.5, 1.0, 4.0, 30.0, 1e4):
            assert f_test(f, degrees) == pytest.approx(stats.f.sf(f, 1, degrees), rel=1e-8, abs=1e-300), (f, degrees)


def test_a_split_must_pass_the_f_test() -> None:
    """Against an F statistic computed from the two branches."""
    rng = np.random.default_rng(3)
    decisions = set()
    for _ in range(200):
        values = rng.normal(size=12)
        answers = rng.random((12, 1)) < 0.5
        if not 2 <= answers.sum() <= 10:
            continue
        values += answers[:, 0] * rng.random() * 2
        inside = sum(((values[b] - values[b].mean()) ** 2).sum() for b in (answers[:, 0], ~answers[:, 0]))
        f = 10 * (((values - values.mean()) ** 2).sum() - inside) / inside
        found = best_split(answers, values, TreeLimits(4, 1, 0.0, 0.05)) is not None
        assert found == (f >= 4.9646)
        decisions.add(found)
    assert decisions == {True, False}
    two = np.array([[True], [False]])
    assert best_split(two, np.array([0.0, 1.0]), TreeLimits(4, 1, 0.0, 0.05)) is None  # no degree of freedom is left
    four = np.array([[True], [True], [False], [False]])
    assert best_split(four, np.array([1.0, 1.0, 0.0, 0.0]), TreeLimits(4, 1, 0.0, 0.001)) == (
        0,
        0.5,
    )  # nothing is left over
