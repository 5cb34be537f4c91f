"""The line search never does worse, by its own estimate, than the fixed step or none."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from samples import random_tree

from nppg.answers.coverage import root_table
from nppg.bias.refinement import Refiner
from nppg.learning.episode import generate_episode
from nppg.learning.line_search import estimate, step_size
from nppg.learning.options import Options
from nppg.learning.visits import Visit
from nppg.policy.policy import Policy
from nppg.trees.tree import Leaf, Tree, leaves
from nppg.worlds.domain import Domain


def setting(domain: Domain, bias, seed: int) -> tuple[Policy, list[Visit], Tree]:
    """A policy of two trees, visits with random values, some of them an expert's, and a third tree."""
    refiner, random = Refiner(bias), Random(seed)
    policy = Policy(domain, bias, root_table(domain, bias, refiner))
    for _ in range(2):
        policy.add(random_tree(refiner, 3, random), 0.5)
    rng = np.random.default_rng(seed)
    episodes = [generate_episode(policy, rng, guidance=0.4) for _ in range(12)]
    visits = [
        Visit(step, value, episode.guided)
        for episode in episodes
        for step, value in zip(episode.steps, rng.normal(size=len(episode.steps)).tolist(), strict=True)
    ]
    return policy, visits, next(tree for _ in range(99) if leaves(tree := random_tree(refiner, 4, random)) > 4)


def by_hand(policy: Policy, tree: Tree, eta: float, visits: list[Visit], clip: float) -> float:
    """The estimate, from the distributions of the policy with the tree."""
    after = Policy(policy.domain, policy.bias)
    for each in policy.trees:
        after.add(each)
    after.add(tree, eta)
    terms = []
    for step, value, guided in visits:
        if not guided:
            now = after.distribution(step.state, step.actions)[step.chosen]
            ratio = now / step.probabilities[step.chosen]
            terms.append(min(ratio * value, min(max(ratio, 1 - clip), 1 + clip) * value))
    return sum(terms) / len(terms)


@pytest.mark.parametrize("bias", ["plain_bias", "relational_bias"])
@pytest.mark.parametrize("seed", [0, 1, 3, 4])
def test_no_step_that_is_tried_has_a_higher_estimate(request, four_blocks: Domain, bias: str, seed: int) -> None:
    policy, visits, tree = setting(four_blocks, request.getfixturevalue(bias), seed)
    assert any(visit.guided for visit in visits)
    options = Options(step_size=0.8, line_search=2, ratio_clip=0.3)
    eta = step_size(tree, visits, policy, options)
    grid = [0.8 * factor for factor in (1.0, 0.0, 0.25, 0.5, 2.0, 4.0)]
    assert eta in grid
    estimates = [by_hand(policy, tree, each, visits, 0.3) for each in grid]
    assert by_hand(policy, tree, eta, visits, 0.3) >= max(estimates) - 1e-12
    assert len({round(each, 9) for each in estimates}) > 1
    assert len(policy.trees) == 2


def test_what_is_chosen_hangs_on_the_values(four_blocks: Domain, plain_bias) -> None:
    """Over many trees every kind of answer is given: no step, a shorter one, the fixed one, a longer one."""
    options = Options(line_search=2)
    found = set()
    for seed in range(25):
        policy, visits, tree = setting(four_blocks, plain_bias, seed)
        found.add(step_size(tree, visits, policy, options))
    assert {0.0, 1.0} < found and min(found - {0.0}) < 1.0 < max(found)


def test_where_nothing_can_be_told_the_step_is_the_fixed_one(four_blocks: Domain, plain_bias) -> None:
    policy, visits, tree = setting(four_blocks, plain_bias, 0)
    options = Options(step_size=0.7, line_search=3)
    assert step_size(tree, visits, policy, Options(step_size=0.7)) == 0.7
    assert step_size(tree, [visit._replace(guided=True) for visit in visits], policy, options) == 0.7
    assert step_size(tree, [visit._replace(value=0.0) for visit in visits], policy, options) == 0.7
    assert step_size(Leaf(3.0), visits, policy, options) == 0.7
    assert step_size(tree, visits, policy, replace(options, step_size=0.0)) == 0.0


def test_estimates_that_cancel_are_equal_but_for_rounding(four_blocks: Domain, plain_bias) -> None:
    """A tree of one leaf changes no probability, whatever the values are; in what cancels to 0 all is rounding."""
    policy, visits, _ = setting(four_blocks, plain_bias, 0)
    half = visits[: len(visits) // 2 * 2]
    for unit in (1.0, 2.0**-40, 2.0**40):
        zero = [visit._replace(value=(-1) ** i * unit, guided=False) for i, visit in enumerate(half)]
        for value in (0.1, 0.3, 0.7, 1.1):
            assert step_size(Leaf(value), zero, policy, Options(step_size=0.7, line_search=3)) == 0.7


weights = st.lists(st.tuples(st.floats(0.01, 50), st.floats(-5, 5)), min_size=1, max_size=9)


@given(weights, st.floats(0, 2))
def test_the_clip_bounds_what_a_step_may_promise(drawn: list[tuple[float, float]], clip: float) -> None:
    """The estimate is never above the importance-weighted one, nor by more than clip |Q| above that of no step."""
    ratios, values = map(np.array, zip(*drawn, strict=True))
    found = estimate(ratios, values, clip)
    assert found <= (ratios * values).mean() + 1e-12
    assert found <= (values + clip * np.abs(values)).mean() + 1e-12
    assert estimate(np.ones(len(values)), values, clip) == pytest.approx(values.mean())
    assert estimate(ratios, values, 100.0) == pytest.approx((ratios * values).mean())
