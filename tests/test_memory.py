"""Evaluations that remember what they have met give the numbers of those that do not."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nppg import Options, RIBOptions, TGOptions, language_bias_of, open_domain
from nppg.experiments.train import train
from nppg.judging import memory
from nppg.judging.evaluation import evaluate, evaluate_both
from nppg.judging.memory import Memory
from nppg.learning.episode import Episode, generate_episode
from nppg.learning.gradient import total
from nppg.learning.options import Common
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain

DOMAINS = {
    "blocks_world": {"blocks": 3},
    "noisy_blocks": {"blocks": 3},
    "delivery": {},
    "grid": {},
    "rover": {},
    "corridor": {},
    "tests/domains/chain.pl": {},
    "tests/domains/roads.pl": {},
    "tests/domains/ferry.pl": {},
}
ROOT = Path(__file__).parent.parent


def opened(name: str) -> Domain:
    return open_domain(ROOT / name if "/" in name else name, DOMAINS[name])


def plain(policy: Policy, count: int, seed: int, greedy: bool, problems: Sequence[int]) -> list[Episode]:
    """The episodes of an evaluation by the policy in its domain itself."""
    rng = np.random.default_rng([seed, 0x6E707067])
    starts = [policy.domain.problem(number) for number in problems] or [None] * count
    return [generate_episode(policy, rng, greedy=greedy, start=start, scored=False) for start in starts]


def numbers(episodes: Sequence[Episode]) -> tuple[float, float, float]:
    count = len(episodes)
    steps = sum(len(each.steps) for each in episodes)
    found = total(each.undiscounted for each in episodes)
    return sum(each.success for each in episodes) / count, steps / count, found / count


def law(name: str, starts: int) -> None:
    """Evaluations while a policy learns, which share a memory."""
    domain = opened(name)
    remembered = Memory(domain)
    problems = domain.chosen
    *_, first, last = train(domain, language_bias_of(domain), Options(episodes=4, min_examples=10, seed=3))
    for iteration in (first, last, last):
        policy = iteration.policy
        found = evaluate_both(policy, starts, 5, 1.0, problems, remembered)
        for greedy, each in enumerate(found):
            expected = numbers(plain(policy, starts, 5, bool(greedy), problems))
            assert (each.success, each.mean_steps, each.mean_return) == expected
            assert each == evaluate(policy, starts, 5, bool(greedy), 1.0, problems)
        for tree in policy.trees[:1]:
            policy.add(tree)


@pytest.mark.parametrize("name", DOMAINS)
def test_while_a_policy_learns(name: str) -> None:
    law(name, 3 if name in ("grid", "rover", "corridor") else 8)


def test_where_memory_is_short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory, "_BYTES", 20_000)
    law("tests/domains/ferry.pl", 8)


@pytest.mark.parametrize("options", [TGOptions(episodes=8, min_sample=5), RIBOptions(episodes=8)], ids=["tg", "rib"])
def test_while_a_q_function_learns(options: Common) -> None:
    domain = opened("delivery")
    remembered = Memory(domain)
    for iteration in train(domain, language_bias_of(domain), options):
        found = evaluate_both(iteration.policy, 6, 5, 1.0, (), remembered)
        expected = numbers(plain(iteration.policy, 6, 5, True, ()))
        assert found[0] == found[1] and (found[0].success, found[0].mean_steps, found[0].mean_return) == expected


@pytest.mark.parametrize("name", ["noisy_blocks", "tests/domains/chain.pl"])
def test_seeds_do_not_mix(name: str) -> None:
    domain = opened(name)
    policy = Policy(domain, language_bias_of(domain))
    remembered = Memory(domain)
    for seed in (0, 1, 0, 2, 1):
        expected = numbers(plain(policy, 10, seed, False, ()))
        each, _ = evaluate_both(policy, 10, seed, 1.0, (), remembered)
        assert (each.success, each.mean_steps, each.mean_return) == expected


def test_what_is_known_is_not_asked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    domain = opened("delivery")
    policy = Policy(domain, language_bias_of(domain))
    remembered = Memory(domain)
    expected = evaluate_both(policy, 20, 0, 1.0, (), remembered)
    for name in ("start", "situation", "horizon", "act"):
        monkeypatch.setattr(Domain, name, lambda *_: pytest.fail("asked"))
    assert evaluate_both(policy, 20, 0, 1.0, (), remembered) == expected


@given(st.lists(st.sampled_from([0.0, -0.0, 1.0, -0.1, 0.3]) | st.floats(-1e9, 1e9), max_size=12))
@settings(max_examples=50)
def test_a_total_is_the_sum_of_what_is_written(found: list[float]) -> None:
    assert total(found) == float(sum(Fraction(repr(each)) for each in found))
