"""Optimal returns, held against a recursion without arrays, against minimal moves and against sampled episodes."""

from __future__ import annotations

import copy
import re
from pathlib import Path

import numpy as np
import pytest

from nppg import Domain, LanguageBias, NppgError, evaluate, evaluate_exactly
from nppg.bridge.files import locate
from nppg.judging.evaluation import ExactEvaluator
from nppg.judging.optimum import ReturnEvaluator
from nppg.judging.space import Space
from nppg.policy.policy import Policy
from nppg.worlds.world import State


@pytest.fixture(scope="module")
def grid() -> ReturnEvaluator:
    return ReturnEvaluator(Space(Domain("grid")))


def uniform(space: Space) -> np.ndarray:
    return 1 / np.bincount(space.owner)[space.owner]


def greedy(evaluator: ReturnEvaluator) -> np.ndarray:
    """The policy that takes the first of the optimal actions."""
    space, pairs = evaluator.space, evaluator.optimal().pairs
    best = {owner: max(np.flatnonzero(space.owner == owner), key=lambda i: pairs[i]) for owner in set(space.owner)}
    return np.array([float(best[owner] == i) for i, owner in enumerate(space.owner)])


@pytest.mark.parametrize("discount", [1.0, 0.8])
def test_the_optimum_is_that_of_the_plain_recursion(discount: float) -> None:
    domain = Domain("grid", {"width": 4, "height": 3, "slip": 0.3})
    space = Space(domain)
    found = ReturnEvaluator(space, discount).optimal()
    memory: dict[tuple[State, int], float] = {}

    def value(state: State, steps: int) -> float:
        if steps == 0 or domain.situation(state).status != "running":
            return 0.0
        if (state, steps) not in memory:
            memory[state, steps] = max(
                sum(
                    outcome.probability
                    * (domain.reward(outcome.state, action) + discount * value(outcome.state, steps - 1))
                    for outcome in outcomes
                )
                for action, outcomes in domain.neighbours(state)
            )
        return memory[state, steps]

    expected = [value(state, horizon) for state, horizon in zip(space.states, space.horizons, strict=True)]
    assert found.values == pytest.approx(expected)
    assert found.mean == pytest.approx(np.sum(expected) / space.starts)
    assert found.mean > 0


def test_no_policy_is_better_and_the_greedy_one_is_as_good(grid: ReturnEvaluator) -> None:
    best, space = grid.optimal(), grid.space
    rng = np.random.default_rng(0)
    for _ in range(5):
        weights = rng.exponential(size=len(space.owner))
        probabilities = weights / np.bincount(space.owner, weights)[space.owner]
        assert (grid.of(probabilities).values < best.values - 0.1)[space.running].all()
    assert grid.of(greedy(grid)).mean == pytest.approx(best.mean, abs=1e-6)  # but for the last steps of long episodes
    assert grid.agreement(greedy(grid)) == pytest.approx(1)
    assert 0.25 <= grid.agreement(uniform(space)) < 0.3


def test_a_policy_gets_what_it_gets_in_sampled_episodes(grid: ReturnEvaluator) -> None:
    policy = Policy(Domain("grid"), LanguageBias.load(locate("grid", "language_bias", ".yaml")))
    expected = grid.of(ExactEvaluator(policy, grid.space).probabilities()).mean
    sampled = evaluate(policy, 150).mean_return
    assert sampled == pytest.approx(expected, abs=4 * 0.65 / 150**0.5)
    assert expected == pytest.approx(grid.of(uniform(grid.space)).mean)


def test_in_the_blocks_world_the_optimal_moves_are_those_that_lead_to_fewer(four_blocks: Domain, plain_bias) -> None:
    space = Space(four_blocks)
    evaluator = ReturnEvaluator(space)
    best = evaluator.optimal()
    assert best.values[space.running] == pytest.approx(1)
    assert best.mean == pytest.approx(1)
    shorter = [
        four_blocks.situation(outcome.state).status == "goal" or four_blocks.horizon(outcome.state) < horizon
        for state, horizon, running in zip(space.states, space.horizons, space.running, strict=True)
        if running
        for _, (outcome,) in four_blocks.neighbours(state)
    ]
    assert (best.pairs > 0.5).tolist() == shorter
    untrained = Policy(four_blocks, plain_bias)
    success = evaluate_exactly(untrained).success
    assert evaluator.of(uniform(space)).mean == pytest.approx(success)
    assert evaluator.agreement(uniform(space)) > success


@pytest.mark.parametrize("unit", [2.0**-40, 2.0**40])
def test_what_is_optimal_does_not_hang_on_the_unit_of_the_rewards(grid: ReturnEvaluator, unit: float) -> None:
    other = copy.copy(grid)
    other._rewards, other._optimal = unit * grid._rewards, None
    assert other.agreement(uniform(grid.space)) == grid.agreement(uniform(grid.space))


def test_a_reward_that_draws_has_no_expectation(tmp_path: Path, four_blocks: Domain) -> None:
    (tmp_path / "noisy.pl").write_text(four_blocks.path.read_text() + "\nreward(_, R) :- random(R).\n")
    space = Space(Domain(tmp_path / "noisy.pl", {"blocks": 3}))
    with pytest.raises(NppgError, match="reward/2 drew a random number, so what may come of an action cannot be"):
        ReturnEvaluator(space)


def test_what_the_page_about_domains_shows(capsys: pytest.CaptureFixture[str]) -> None:
    page = (Path(__file__).parent.parent / "docs" / "domains.md").read_text(encoding="utf-8")
    section = page.split("## The best that can be done")[1]
    program, shown = re.findall(r"```(?:python)?\n(.*?)```", section, re.DOTALL)[:2]
    exec(program, {})
    assert capsys.readouterr().out == shown
