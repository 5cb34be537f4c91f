"""Algorithm 1: reproducible, it learns, and each option does what it says."""

from __future__ import annotations

import json
import math
import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import locate
from nppg.errors import NppgError
from nppg.judging.evaluation import ExactEvaluator, evaluate
from nppg.judging.space import Space
from nppg.learning.courses import examples
from nppg.learning.critic import critic
from nppg.learning.episode import generate_episode, longest
from nppg.learning.gradient import functional_gradient
from nppg.learning.options import Options
from nppg.learning.training import train
from nppg.learning.visits import kept
from nppg.policy.policy import Policy
from nppg.trees.tree import leaves
from nppg.worlds.domain import Domain


def run(folder: Path, seed: int, bias: str, hash_seed: str, *more: str) -> bytes:
    options = f"--set blocks=5 --episodes 60 --quiet --seed {seed} --evaluate-every 0".split()
    files = ["--bias", bias, "--output", str(folder)]
    subprocess.run(
        [sys.executable, "-m", "nppg", "train", "blocks_world", *options, *files, *more],
        env={**os.environ, "PYTHONHASHSEED": hash_seed, "PYTHONPATH": os.pathsep.join(sys.path)},
        check=True,
        capture_output=True,
        timeout=120,
    )
    return (folder / "model.pl").read_bytes()


def test_a_seed_reproduces_a_run_byte_for_byte(tmp_path: Path, relational_bias) -> None:
    first = run(tmp_path / "a", 1, relational_bias.file, "1")
    assert first.count(b"% tree") > 3
    assert run(tmp_path / "b", 1, relational_bias.file, "2") == first
    assert run(tmp_path / "c", 2, relational_bias.file, "1") != first


VARIANT = {"critic": "value", "trace": 0.8, "critic_trees": 2, "critic_step_size": 0.3, "normalise": "yes"}
VARIANT |= {"cut_off": "bootstrap", "line_search": 2, "ratio_clip": 0.4, "models": "per-action", "min_examples": 40}


@pytest.mark.parametrize("step", ["gradient", "second-order"])
def test_so_it_does_with_all_variants(tmp_path: Path, relational_bias, step: str) -> None:
    """And its files say which they were."""
    given = [f"--{name.replace('_', '-')}={value}" for name, value in (VARIANT | {"step": step, "replay": 20}).items()]
    first = run(tmp_path / "a", 1, relational_bias.file, "1", *given)
    assert first.count(b"% tree") > 3
    assert run(tmp_path / "b", 1, relational_bias.file, "2", *given) == first
    assert run(tmp_path / "c", 2, relational_bias.file, "1", *given) != first
    recorded = json.loads((tmp_path / "a" / "run.json").read_text())["options"]
    assert VARIANT.items() <= recorded.items()
    policy = Policy.load(tmp_path / "a" / "model.pl")
    assert all(policy.option(name, None) == value for name, value in VARIANT.items())
    sizes = {float(each) for each in re.findall(r"step size ([\d.]+),", first.decode())}
    assert sizes <= {0.0, 0.25, 0.5, 1.0, 2.0, 4.0} and len(sizes) > 1


def test_several_kinds_of_actions_are_learned_by_a_model_for_each(delivery: Domain, delivery_bias) -> None:
    policy = learned(delivery, delivery_bias, episodes=600, models="per-action")
    assert evaluate(policy, 200).success > 0.7


@pytest.mark.parametrize("options", [{}, {"step": "second-order", "line_search": 1}, {"models": "per-action"}])
def test_answers_that_are_asked_late_teach_the_same(monkeypatch, delivery, delivery_bias, options: dict) -> None:
    """A policy of large tables asks its own tests alone, and the rest is asked about what trees are grown from."""
    policies = []
    for most in (0, 10**6):
        monkeypatch.setattr("nppg.learning.courses._LARGE", most)
        policies.append(learned(delivery, delivery_bias, episodes=60, min_examples=30, **options))
    late, early = policies
    assert late.trees == early.trees and len(late.trees) > 2
    assert len(late.table) < len(early.table)


def learned(domain: Domain, bias, **options) -> Policy:
    *_, last = train(domain, bias, Options(**options))
    return last.policy


def test_four_blocks_are_learned(four_blocks: Domain, four: Space, plain_bias) -> None:
    """In 300 episodes with a tree for every ten examples; the uniform policy solves less than a quarter."""
    assert ExactEvaluator(Policy(four_blocks, plain_bias), four).evaluate().success < 0.25
    policy = learned(four_blocks, plain_bias, episodes=300, min_examples=10)
    judge = ExactEvaluator(policy, four)
    assert judge.evaluate().success > 0.9 and judge.evaluate(greedy=True).success > 0.99


def test_four_blocks_are_learned_by_new_variables(four_blocks: Domain, four: Space, bias_of) -> None:
    """Neither clear nor above are given: being on top of something takes a join."""
    bias = bias_of(
        """
action: move(+block, +place)
goal: goal_on(-block, -block)
subtypes: {block: place}
types: {on: [place, place]}
modes: ["on(+, +-)", "on(-, +)", "equal(+place, +place)", "equal(+place, floor)"]
max_variables: 2
tree: {max_depth: 6, min_examples: 1}
"""
    )
    policy = learned(four_blocks, bias, episodes=300, min_examples=10)
    assert ExactEvaluator(policy, four).evaluate().success > 0.85
    assert any(len(test) > 1 for test in policy.table.tests)


def test_several_kinds_of_actions_are_learned(delivery: Domain, delivery_bias) -> None:
    policy = learned(delivery, delivery_bias, episodes=900)
    assert evaluate(policy, 200).success > 0.8
    assert evaluate(Policy(delivery, delivery_bias), 200).success < 0.2


def test_an_iteration_is_algorithm_1(four_blocks: Domain, plain_bias) -> None:
    options = Options(episodes=60, seed=4, min_examples=50, step_size=0.5)
    before, trees = 0, 0
    for iteration in train(four_blocks, plain_bias, options):
        policy = iteration.policy
        assert iteration.episodes == before + len(iteration.recent)
        examples = sum(len(step.actions) for episode in iteration.recent for step in episode.steps)
        if len(policy.trees) > trees:
            assert examples > 50
            last = sum(len(step.actions) for step in iteration.recent[-1].steps)
            assert examples - last <= 50  # called as soon as there are more
            assert policy.comments[-1] == f"step size 0.5, {examples} examples, {leaves(policy.trees[-1])} leaves"
        else:
            assert examples <= 50
        before, trees = iteration.episodes, len(policy.trees)
    assert before == 60 and trees > 3


def test_the_probabilities_recorded_are_those_of_the_policy_before_the_tree(four_blocks: Domain, plain_bias) -> None:
    earlier = Policy(four_blocks, plain_bias)
    for iteration in train(four_blocks, plain_bias, Options(episodes=30, seed=5)):
        for step in (step for episode in iteration.recent for step in episode.steps):
            assert step.probabilities.tolist() == earlier.distribution(step.state, step.actions).tolist()
        for tree in iteration.policy.trees[len(earlier.trees) :]:
            earlier.add(tree)
    assert len(earlier.trees) >= 2


def test_episodes_per_iteration(four_blocks: Domain, plain_bias) -> None:
    iterations = list(train(four_blocks, plain_bias, Options(episodes=60, min_examples=0, episodes_per_iteration=20)))
    assert [len(each.recent) for each in iterations] == [0, 20, 20, 20]
    assert len(list(train(four_blocks, plain_bias, Options(episodes=0)))) == 1


def episodes(domain: Domain, bias, count: int = 60, **arguments) -> list:
    policy, rng = Policy(domain, bias), np.random.default_rng(0)
    return [generate_episode(policy, rng, **arguments) for _ in range(count)]


def test_episodes_are_chains_of_legal_steps(four_blocks: Domain, plain_bias) -> None:
    rng = np.random.default_rng(1)
    for episode in episodes(four_blocks, plain_bias):
        horizon = four_blocks.horizon(episode.steps[0].state)
        assert len(episode.steps) <= horizon
        assert episode.success == (four_blocks.situation(episode.last).status == "goal")
        assert episode.success or len(episode.steps) == horizon
        following = [step.state for step in episode.steps[1:]] + [episode.last]
        for step, after in zip(episode.steps, following, strict=True):
            assert list(step.actions) == four_blocks.situation(step.state).actions
            assert four_blocks.act(step.state, step.actions[step.chosen], rng) == (step.reward, after)


@given(st.integers(0, 10**6), st.integers(0, 10**4))
def test_an_episode_is_as_long_as_the_factor_says(horizon: int, thousandths: int) -> None:
    """As written in decimals, though the factor is none in binary."""
    assert longest(horizon, thousandths / 1000) == -(-thousandths * horizon // 1000)


def test_lengths_that_floats_cannot_hold() -> None:
    assert longest(10**9, 1e308) == 10**9 * int(1e308)
    assert longest(10**9, 1e-300) == 1 and longest(10**9, 0.0) == longest(0, 2.5) == 0
    assert longest(10**9, 1 + 1e-9) == 10**9 + 1 and longest(10**9, 1.0) == 10**9


@pytest.mark.parametrize("k", [-20, 20])
@pytest.mark.parametrize(
    "options",
    [
        {"step_size": 1.0},
        {"regressor": "cart"},
        {"step": "second-order"},
        {"critic": "value", "line_search": 1},
        {"normalise": "yes"},
    ],
)
def test_what_is_learned_does_not_hang_on_the_unit_of_the_rewards(k: int, options: dict) -> None:
    """Where the step size, or lambda, goes along with it."""
    if options.get("regressor") == "cart":
        pytest.importorskip("sklearn")
    bias = LanguageBias.load(locate("corridor", "language_bias", ".yaml"))
    found = []
    for unit in (1.0, 2.0**k):
        domain = Domain("corridor", {"step_reward": -unit, "exit_reward": 20 * unit})
        given = Options(episodes=120, guidance=0, **options)
        if given.step == "second-order":
            given = replace(given, regularisation=given.regularisation * unit)
        elif given.normalise == "no":
            given = replace(given, step_size=given.step_size / unit)
        *_, last = train(domain, bias, given)
        found.append(last.policy.trees)
    assert found[0] == found[1] and max(map(leaves, found[0])) > 1


def test_the_horizon_factor_lengthens_episodes(four_blocks: Domain, plain_bias) -> None:
    for factor in (0.5, 2.5):
        ratios = []
        for episode in episodes(four_blocks, plain_bias, horizon_factor=factor):
            limit = longest(four_blocks.horizon(episode.steps[0].state), factor)
            assert len(episode.steps) <= limit and (episode.success or len(episode.steps) == limit)
            ratios.append(len(episode.steps) / four_blocks.horizon(episode.steps[0].state))
        assert max(ratios) > 1 if factor > 1 else min(ratios) < 1


def test_guided_episodes_are_the_experts(four_blocks: Domain, plain_bias) -> None:
    guided = episodes(four_blocks, plain_bias, guidance=1.0)
    assert all(each.guided and each.success for each in guided)
    for step in (step for episode in guided for step in episode.steps):
        assert step.actions[step.chosen] in four_blocks.expert_actions(step.state)
    share = sum(each.guided for each in episodes(four_blocks, plain_bias, 400, guidance=0.25))
    assert 70 < share < 130
    assert not any(each.guided for each in episodes(four_blocks, plain_bias))


@pytest.mark.parametrize("update", ["all", "taken"])
@pytest.mark.parametrize("unrewarded", ["keep", "drop"])
@pytest.mark.parametrize("discount", [1.0, 0.5, 0.0])
def test_the_examples_of_an_episode(four_blocks: Domain, plain_bias, update, unrewarded, discount) -> None:
    options = Options(update=update, unrewarded=unrewarded, discount=discount)
    kinds = set()
    for episode in episodes(four_blocks, plain_bias, 40, guidance=0.3):
        learned = kept(critic(four_blocks, plain_bias, options).visits(episode), options)
        found = examples(learned, options) if learned else None
        expected = []
        for t, step in enumerate(episode.steps):
            value = sum(discount**k * later.reward for k, later in enumerate(episode.steps[t:]))
            kinds.add((len(episode.steps) > 1, value))
            for b, action in enumerate(step.actions):
                gradient = functional_gradient(step.probabilities, step.chosen, value)[b]
                if (value or unrewarded == "keep") and (update == "all" or b == step.chosen):
                    scale = step.probabilities[b] if update == "taken" else 1
                    expected.append((step.state, action, gradient / scale, step.answers[b].tolist()))
        if found is None:
            assert not expected
            continue
        assert found.states == [each[0] for each in expected] and found.actions == [each[1] for each in expected]
        assert found.targets.tolist() == pytest.approx([each[2] for each in expected], abs=1e-12)
        assert found.answers.tolist() == [each[3] for each in expected]
    assert {0.0, 1.0} <= {value for _, value in kinds} and (discount != 0.5 or (True, 0.5) in kinds)


@pytest.mark.parametrize("step", ["gradient", "second-order"])
@pytest.mark.parametrize("importance", [None, 0.0, 0.5, 1.0])
def test_importance_weights_the_action_taken(four_blocks: Domain, plain_bias, step: str, importance) -> None:
    """Left out, it is divided by its probability."""
    options = Options(update="taken", step=step, importance=importance)
    weights = set()
    for episode in episodes(four_blocks, plain_bias, 20, guidance=0.5):
        if learned := kept(critic(four_blocks, plain_bias, options).visits(episode), options):
            found = examples(learned, options).targets.tolist()
            pi = [visit.step.probabilities[visit.step.chosen] for visit in learned]
            values = [visit.value for visit in learned]
            assert found == pytest.approx(
                [v * p ** (importance or 0.0) * (1 - p) for v, p in zip(values, pi, strict=True)]
            )
            weights.update(found)
    assert len(weights) > 2
    assert options.importance == (importance or 0.0)


def test_so_do_those_of_the_variants(four_blocks: Domain, plain_bias) -> None:
    base = {"episodes": 80, "seed": 1, "min_examples": 20}
    value = {"critic": "value", "discount": 0.9}
    changes: list[dict] = [{}, value, value | {"trace": 0.5}, value | {"critic_step_size": 0.2}]
    changes += [
        value | {"cut_off": "bootstrap"},
        value | {"critic_trees": 3},
        value | {"normalise": "yes"},
        {"normalise": "yes"},
    ]
    changes += [{"line_search": 1}, {"line_search": 3}, {"line_search": 3, "ratio_clip": 3.0}]
    found = [learned(four_blocks, plain_bias, **(base | change)).trees for change in changes]
    assert all(found.count(each) == 1 and each for each in found)
    without = {"trace": 0.5, "cut_off": "bootstrap", "critic_step_size": 0.2, "critic_trees": 3, "ratio_clip": 3.0}
    assert learned(four_blocks, plain_bias, **(base | without)).trees == found[0]


def test_the_options_reach_training(four_blocks: Domain, plain_bias) -> None:
    """Every option but the numbers of episodes changes what is learned."""
    base = Options(episodes=25, seed=1, min_examples=40)
    changes = [{}, {"step_size": 0.5}, {"discount": 0.7}, {"guidance": 0.6}, {"min_examples": 80}, {"seed": 2}]
    changes += [
        {"episodes_per_iteration": 8},
        {"horizon_factor": 2.0},
        {"update": "taken"},
        {"unrewarded": "drop"},
    ]
    found = []
    for change in changes:
        *_, last = train(four_blocks, plain_bias, replace(base, **change))
        found.append([last.policy.rules(tree) for tree in range(1, len(last.policy.trees) + 1)])
    assert all(found.count(each) == 1 and each for each in found)


@pytest.mark.parametrize(
    "wrong",
    [
        {"episodes": -1},
        {"episodes": 1.5},
        {"episodes": True},
        {"episodes": "10"},
        {"seed": -1},
        {"step_size": math.nan},
        {"step_size": math.inf},
        {"step_size": -0.1},
        {"step_size": 10**400},
        {"step_size": None},
        {"discount": 1.01},
        {"discount": math.nan},
        {"guidance": -0.01},
        {"guidance": 2},
        {"min_examples": -1},
        {"episodes_per_iteration": 0},
        {"horizon_factor": -1.0},
        {"update": "some"},
        {"unrewarded": True},
        {"models": "two"},
        {"line_search": -1},
        {"line_search": 0.5},
        {"ratio_clip": -0.1},
        {"critic": "q"},
        {"trace": 1.1},
        {"critic_step_size": -1},
        {"critic_trees": 0},
        {"cut_off": "on"},
        {"normalise": True},
    ],
)
def test_options_that_cannot_be(wrong: dict) -> None:
    with pytest.raises(NppgError) as caught:
        Options(**wrong)
    assert next(iter(wrong)) in str(caught.value)


def test_all_wrong_options_are_named_at_once() -> None:
    with pytest.raises(NppgError) as caught:
        Options(episodes=-1, discount=2.0, update="x")
    assert len(caught.value.problems) == 3
    assert Options(step_size=1).step_size == 1  # a whole number will do
