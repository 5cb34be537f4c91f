"""The blocks world's other tasks: stack, all blocks in one tower, and unstack, all on the floor."""

from __future__ import annotations

from collections import Counter
from math import factorial

import numpy as np
import pytest
from test_canonical_space import check_frequencies, check_horizon_and_expert

from nppg import Domain, LanguageBias, NppgError, Options, evaluate_exactly, train
from nppg.distill import distill
from nppg.shipped import shipped
from nppg.space import Space

TASKS = ["stack", "unstack"]
GOALS = {"stack": factorial, "unstack": lambda blocks: 1}


def of(task: str, blocks: int) -> Domain:
    return Domain("blocks_world", {"task": task, "blocks": blocks})


@pytest.mark.parametrize("blocks", [2, 4, 6])
@pytest.mark.parametrize("task", TASKS)
def test_horizon_and_expert(task: str, blocks: int) -> None:
    space = Space(of(task, blocks))
    assert sum(space.sizes) == {2: 3, 4: 73, 6: 4051}[blocks]
    assert space.starts == sum(space.sizes) - GOALS[task](blocks)
    check_horizon_and_expert(space, longest=blocks - 1)


@pytest.mark.parametrize("task", TASKS)
def test_starts_are_uniform(task: str) -> None:
    domain, rng = of(task, 4), np.random.default_rng(0)
    counts = Counter(domain.start(rng) for _ in range(3000))
    states = 73 - GOALS[task](4)
    assert len(counts) == states
    check_frequencies(counts, dict.fromkeys(counts, 1 / states))


def test_pictures() -> None:
    state = (("on", "b1", "floor"), ("on", "b2", "b1"), ("on", "b3", "floor"))
    assert of("stack", 3).picture(state) == ["b2        ", "b1   b3   ", "goal: all blocks in one tower"]
    assert of("unstack", 3).picture(state)[-1] == "goal: all blocks on the floor"


def test_other_tasks_are_refused() -> None:
    with pytest.raises(NppgError, match=r"start/1 .*on,stack,unstack.*pile"):
        of("pile", 3).start(np.random.default_rng(0))


@pytest.mark.parametrize("step", ["gradient", "second-order"])
@pytest.mark.parametrize("task", TASKS)
def test_few_rules_are_learned(task: str, step: str) -> None:
    bias = LanguageBias.load(shipped("language_bias") / f"{task}.yaml")
    domain = of(task, 5)
    assert bias.check(domain.predicates, domain.actions) == []
    *_, last = train(domain, bias, Options(episodes=200, step=step))
    rules = distill(last.policy, bias)
    assert len(rules.rules(1)) <= 4
    assert evaluate_exactly(rules, greedy=True).success == 1
