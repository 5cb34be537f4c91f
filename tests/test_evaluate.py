"""Exact evaluation against the known numbers, plain enumeration and samples."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from itertools import product
from random import Random

import numpy as np
import pytest
from samples import random_tree, resigned

from nppg.answers.coverage import root_table
from nppg.bias.refinement import Refiner
from nppg.errors import NppgError
from nppg.judging.evaluation import Evaluation, ExactEvaluator, evaluate, evaluate_exactly
from nppg.judging.space import Space
from nppg.learning.episode import longest
from nppg.learning.options import Options
from nppg.learning.training import train
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain


@pytest.fixture(scope="module")
def policy(four_blocks: Domain, plain_bias) -> Policy:
    """Random trees: neither uniform nor good, with ties."""
    refiner = Refiner(plain_bias)
    policy = Policy(four_blocks, plain_bias, root_table(four_blocks, plain_bias, refiner))
    for seed in range(5):
        policy.add(random_tree(refiner, 3, Random(seed)))
    return policy


def all_starts(blocks: int) -> list[tuple]:
    """Every state of so many blocks in which b1 is not on b2, with the goal to put it there, by brute force: what
    each block stands on, without two on one block and without a circle."""
    names = [f"b{i}" for i in range(1, blocks + 1)]
    found = []
    for below in product([*names, "floor"], repeat=blocks):
        on = dict(zip(names, below, strict=True))
        reached = {"floor"}
        while grown := {block for block in names if on[block] in reached} - reached:
            reached |= grown
        taken = [each for each in below if each != "floor"]
        if len(reached) > blocks and len(set(taken)) == len(taken) and on["b1"] != "b2":
            found.append((("goal_on", "b1", "b2"), *(("on", block, on[block]) for block in names)))
    return found


def moves(policy: Policy, state: tuple, greedy: bool) -> tuple[str, list[tuple[float, tuple]]]:
    """The status of a state, and where its actions lead to with which probability."""
    status, actions = policy.domain.situation(state)
    if status != "running":
        return status, []
    pi = policy.distribution(state, actions)
    if greedy:
        best = pi >= pi.max() * (1 - 1e-9)
        pi = best / best.sum()
    found = []
    for action, outcomes in policy.domain.neighbours(state):
        ((_, following),) = outcomes
        found.append((float(pi[actions.index(action)]), following))
    return status, found


def success(moves_of: Callable[[tuple], tuple[str, list]], state: tuple, steps: int) -> tuple[float, float]:
    """The probability of the goal within so many steps, and their expected number, by recursion."""
    status, found = moves_of(state)
    if status != "running" or steps == 0:
        return float(status == "goal"), 0.0
    value, length = 0.0, 1.0
    for probability, following in found:
        chance, more = success(moves_of, following, steps - 1)
        value += probability * chance
        length += probability * more
    return value, length


@pytest.mark.parametrize("greedy", [False, True])
@pytest.mark.parametrize("factor", [0.6, 1.1, 1.25])
def test_exact_evaluation_is_plain_enumeration(policy: Policy, four: Space, greedy: bool, factor: float) -> None:
    starts = all_starts(4)
    assert len(starts) == 60
    moves_of = cache(lambda state: moves(policy, state, greedy))  # each state is come by on many ways
    found = [success(moves_of, state, longest(policy.domain.horizon(state), factor)) for state in starts]
    exact = ExactEvaluator(policy, four).evaluate(greedy, factor)
    assert exact.success == pytest.approx(np.mean([each[0] for each in found]), rel=1e-12)
    assert exact.mean_steps == pytest.approx(np.mean([each[1] for each in found]), rel=1e-12)
    assert (exact.starts, exact.exact, exact.greedy) == (60, True, greedy)
    assert 0.01 < exact.success < 0.99


@pytest.mark.parametrize("blocks", [3, 5])
def test_what_is_certain_is_1_and_probabilities_are_probabilities(plain_bias, blocks: int) -> None:
    """Though those of the actions hardly ever sum to 1; also with all the time in the world."""
    domain = Domain("blocks_world", {"blocks": blocks})
    refiner = Refiner(plain_bias)
    policy = Policy(domain, plain_bias, root_table(domain, plain_bias, refiner))
    judge = ExactEvaluator(policy)
    assert judge.space.mean(np.ones(len(judge.space.sizes))) == 1.0
    assert (judge.by_class(False, 3000.0)[0][judge.space.running] == 1.0).all()
    assert judge.evaluate(False, 3000.0).success == 1.0
    for seed in range(4):
        policy.add(random_tree(refiner, 3, Random(seed)))
        for greedy in (False, True):
            success, _ = judge.by_class(greedy, 50.0)
            assert success.min() == 0 and success.max() <= 1
            assert 0 <= judge.evaluate(greedy, 50.0).success <= 1


@pytest.mark.parametrize("greedy", [False, True])
def test_samples_agree_with_the_exact_value(policy: Policy, greedy: bool) -> None:
    exact = evaluate_exactly(policy, greedy)
    sampled = evaluate(policy, 1500, seed=1, greedy=greedy)
    error = math.sqrt(exact.success * (1 - exact.success) / sampled.starts)
    assert abs(sampled.success - exact.success) < 4 * error
    assert sampled.mean_return == sampled.success and not sampled.exact
    assert abs(sampled.mean_steps - exact.mean_steps) < 4 * 1.5 / math.sqrt(sampled.starts)


def test_the_uniform_policy_on_ten_blocks(space: Space, plain_bias) -> None:
    """1.3098 % of all 54,344,538 starts in the minimal number of moves."""
    evaluator = ExactEvaluator(Policy(space.domain, plain_bias), space)
    result = evaluator.evaluate()
    assert result.starts == 54_344_538
    assert round(100 * result.success, 4) == 1.3098
    assert evaluator.evaluate(greedy=True) == Evaluation(
        pytest.approx(result.success), result.starts, True, True, pytest.approx(result.mean_steps)
    )


def test_an_evaluator_sees_the_trees_that_are_added(four_blocks: Domain, plain_bias) -> None:
    refiner = Refiner(plain_bias)
    policy = Policy(four_blocks, plain_bias)
    evaluator = ExactEvaluator(policy)
    values = [evaluator.evaluate().success]
    for seed in range(3):
        policy.add(random_tree(refiner, 4, Random(seed)))
        values.append(evaluator.evaluate().success)
        assert values[-1] == evaluate_exactly(policy).success
    assert len(set(values)) == 4


@pytest.mark.parametrize("block", ["b1", "b2", "b3", "b4"])
def test_a_policy_that_names_an_interchangeable_object_is_refused(tmp_path, four_blocks, plain_bias, block) -> None:
    """Also where the block is one of the goal's that was drawn first."""
    Policy(four_blocks, plain_bias).save(tmp_path / "model.pl")
    text = (tmp_path / "model.pl").read_text().replace("model(trees, 0)", "model(trees, 1)")
    resigned(tmp_path / "model.pl", f"{text}\ndelta(1, move({block}, _), 5.0) :- !.\ndelta(1, _, 0.0).\n")
    with pytest.raises(NppgError, match=f"names \\['{block}'\\], which the domain declares interchangeable"):
        evaluate_exactly(Policy.load(tmp_path / "model.pl"))


def test_the_shape_of_the_inverse_does_not_matter(policy: Policy, monkeypatch) -> None:
    """NumPy 2.0 gives that of np.unique along an axis as a column."""
    expected, unique = evaluate_exactly(policy), np.unique

    def column(*args, **options):
        *found, inverse = unique(*args, **options)
        return *found, inverse.reshape(-1, 1)

    monkeypatch.setattr(np, "unique", column)
    assert evaluate_exactly(policy) == expected


def test_samples_are_reproduced_by_their_seed(policy: Policy) -> None:
    assert evaluate(policy, 50, seed=3) == evaluate(policy, 50, seed=3)
    assert len({evaluate(policy, 50, seed=seed) for seed in range(4)}) == 4


def test_evaluation_does_not_touch_training(four_blocks: Domain, four: Space, plain_bias) -> None:
    def learned(look) -> list[list[str]]:
        for iteration in train(four_blocks, plain_bias, Options(episodes=40, seed=2)):
            policy = iteration.policy
            look(policy)
        return [policy.rules(tree) for tree in range(1, len(policy.trees) + 1)]

    def both(policy: Policy) -> None:
        evaluate(policy, 5, seed=2)
        ExactEvaluator(policy, four).evaluate(greedy=True)

    undisturbed = learned(lambda policy: None)
    assert len(undisturbed) >= 3 and learned(both) == undisturbed


@pytest.mark.parametrize(("starts", "seed"), [(0, 0), (-5, 0), (10, -1)])
def test_numbers_that_cannot_be(policy: Policy, starts: int, seed: int) -> None:
    with pytest.raises(NppgError, match="at least"):
        evaluate(policy, starts, seed)


def test_what_is_not_declared_cannot_be_evaluated_exactly(delivery: Domain, delivery_bias) -> None:
    with pytest.raises(NppgError, match="uniform_start"):
        evaluate_exactly(Policy(delivery, delivery_bias))
