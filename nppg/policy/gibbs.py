"""The Gibbs distribution over potentials."""

from __future__ import annotations

import numpy as np


def gibbs(potentials: np.ndarray) -> np.ndarray:
    """pi(s, a) = exp Psi(s, a) / sum_b exp Psi(s, b), for the potentials of a state's actions."""
    weights = np.exp(potentials - potentials.max())
    return weights / weights.sum()


def gibbs_of_groups(potentials: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """The same for many states at once, the actions of each standing together from `starts` on."""
    sizes = np.diff(starts, append=len(potentials))
    weights = np.exp(potentials - np.repeat(np.maximum.reduceat(potentials, starts), sizes))
    return weights / np.repeat(np.add.reduceat(weights, starts), sizes)
