"""What a policy comes to in a finite space, by backward induction over the steps that are left."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np


class Transitions(Protocol):
    """The states of a space, and the outcomes of its pairs of a running state and an action: nppg.judging.space and
    nppg.judging.reachable document them."""

    status: list[str]
    running: np.ndarray
    owner: np.ndarray
    origin: np.ndarray
    target: np.ndarray
    weight: np.ndarray


def reaching(space: Transitions, probabilities: np.ndarray, limits: Sequence[int] | np.ndarray) -> tuple:
    """From each running state the probability to reach a goal state, and the expected number of steps, where each pair
    is taken with its probability and an episode ends after as many steps as `limits` has for the state that it starts
    in; 0 where that is 0. Shapes (states,).

    V_t(s) is the probability to reach a goal state within t steps, and U_t(s) the expected number of steps when at most
    t are taken. A V near 1 is 1 less the probability to miss the goal, so that what is certain is 1; the sums of
    probabilities are but for rounding."""
    limits = np.asarray(limits)
    flow = probabilities[space.origin] * space.weight
    source = space.owner[space.origin]
    goal = np.array([float(status == "goal") for status in space.status])
    value, length = goal, np.zeros(len(goal))
    ended = 1.0 - goal - space.running
    missed = 1.0 - goal
    success, steps = np.zeros(len(goal)), np.zeros(len(goal))
    for t in range(1, limits.max(initial=0) + 1):
        value = np.minimum(goal + np.bincount(source, flow * value[space.target], len(goal)), 1.0)
        missed = np.minimum(ended + np.bincount(source, flow * missed[space.target], len(goal)), 1.0)
        length = space.running + np.bincount(source, flow * length[space.target], len(goal))
        now = limits == t
        success[now] = np.where(value[now] > 0.5, 1.0 - missed[now], value[now])
        steps[now] = length[now]
    return success * space.running, steps * space.running
