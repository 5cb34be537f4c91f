"""Returns, the Gibbs distribution and the functional gradient; NumPy only."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import lru_cache

import numpy as np


def total(numbers: Iterable[float]) -> float:
    """The sum of finite numbers as they are written in decimals, rounded once: ten times -0.1 and 1 are 0, which
    neither addition in binary nor math.fsum makes of them."""
    return float(sum(_written(number) * count for number, count in Counter(map(float, numbers)).items()))


@lru_cache
def _written(number: float) -> Fraction:
    return Fraction(repr(number))


def returns(rewards: Sequence[float], discount: float) -> np.ndarray:
    """The Monte Carlo estimate of Q for each step: Q_t = r_t + discount * Q_{t+1}, 0 behind the last."""
    result = np.zeros(len(rewards))
    following = 0.0
    for t in range(len(rewards) - 1, -1, -1):
        following = rewards[t] + discount * following
        result[t] = following
    return result


def advantages(
    rewards: Sequence[float], values: Sequence[float], last: float, discount: float, trace: float
) -> np.ndarray:
    """Generalised advantage estimation (Schulman et al. 2016): A_t = sum_k (discount * trace)^k delta_{t+k} with
    delta_t = r_t + discount * V(s_{t+1}) - V(s_t), for the `values` V(s_t) and V = `last` behind the last step.

    With trace 1 that is the return, with discounted `last` behind it, minus V(s_t); with trace 0 it is delta_t."""
    following = [*values, last][1:]
    deltas = [r + discount * after - before for r, after, before in zip(rewards, following, values, strict=True)]
    return returns(deltas, discount * trace)


def functional_gradient(probabilities: np.ndarray, chosen: int, value: float, importance: float = 1.0) -> np.ndarray:
    """The point-wise gradient of a step for every legal action b (Kersting and Driessens 2008, Proposition 3.1):

    value * d pi(s, a) / d Psi(s, b), with pi(s, a) (1 - pi(s, a)) for b = a, -pi(s, a) pi(s, b) for the others.
    The result sums to zero. With `importance` k other than 1 the leading pi(s, a) is taken to that power; at 0 this is
    the gradient of value * log pi(s, a).
    """
    weight = probabilities[chosen] if importance == 1.0 else probabilities[chosen] ** importance
    gradient = -weight * probabilities
    gradient[chosen] += weight
    return value * gradient


def taken_gradient(probabilities: np.ndarray, chosen: int, value: float, importance: float = 0.0) -> float:
    """The same at the action taken alone, value * pi(s, a)^k (1 - pi(s, a)). With `importance` k = 0 that is the
    gradient divided by the action's probability (the paper's footnote 2), which makes up for its being drawn by it."""
    return functional_gradient(probabilities, chosen, value, importance)[chosen]


def comparison_gradient(potentials: np.ndarray, best: int, losses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The gradient, and the curvature, of sum_b losses_b log sigma(Psi(a) - Psi(b)) / sqrt(n) in the potentials of a
    state's actions, shape (actions,) each: the first `best` of them are better than each of the n others b, which lose
    `losses`, shape (n,), against them. The a that is compared is the one of the highest potential; equal ones share."""
    better, worse = potentials[:best], potentials[best:]
    share = (better == better.max()).astype(float)
    share /= share.sum()
    wrong = 1 / (1 + np.exp(np.clip(better.max() - worse, -50, 50)))
    pull = losses * wrong / math.sqrt(len(losses))
    bend = pull * (1 - wrong)
    return np.concatenate([pull.sum() * share, -pull]), np.concatenate([bend.sum() * share, bend])
