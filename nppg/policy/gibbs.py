"""What potentials make of a state's actions: the Gibbs distribution, and the best ones."""

from __future__ import annotations

import numpy as np

TIE = 1e-9  # potentials this near to the highest one, relatively to the largest of the state's, count as equal


def gibbs(potentials: np.ndarray) -> np.ndarray:
    """pi(s, a) = exp Psi(s, a) / sum_b exp Psi(s, b), for the potentials of a state's actions."""
    weights = np.exp(potentials - potentials.max())
    return weights / weights.sum()


def gibbs_of_groups(potentials: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """The same for many states at once, the actions of each standing together from `starts` on."""
    sizes = np.diff(starts, append=len(potentials))
    weights = np.exp(potentials - np.repeat(np.maximum.reduceat(potentials, starts), sizes))
    return weights / np.repeat(np.add.reduceat(weights, starts), sizes)


def best(potentials: np.ndarray) -> np.ndarray:
    """Which potentials of a state's actions are the highest, but for rounding; the same whatever their unit is."""
    return potentials >= potentials.max() - TIE * np.abs(potentials).max()


def best_of_groups(potentials: np.ndarray, starts: np.ndarray, tie: float = TIE) -> np.ndarray:
    """The same for many states at once, as in gibbs_of_groups."""
    sizes = np.diff(starts, append=len(potentials))
    limits = np.maximum.reduceat(potentials, starts) - tie * np.maximum.reduceat(np.abs(potentials), starts)
    return potentials >= np.repeat(limits, sizes)
