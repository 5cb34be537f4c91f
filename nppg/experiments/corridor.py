"""The corridor's optimal policy, by value iteration over cells of its length.

What is in a cell counts as being at its centre, and the noise is integrated exactly: the probability to get into a cell
is a difference of two values of the normal distribution function. So the cells' width is the only error.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from nppg.errors import NppgError
from nppg.worlds.domain import Domain

_CHANGE = 1e-10  # of the values, at which the iteration has converged


class Optimum(NamedTuple):
    """Of each cell the expected return, and whether it is best to go right; their mean, that of uniform starts; and the
    position from which on it is best to go right."""

    values: np.ndarray
    right: np.ndarray
    mean: float
    switch: float


class Corridor:
    """An instance of domains/corridor.pl in `cells` cells, `centres` are their positions. Returns are undiscounted and
    the episodes as long as they take, though the domain's horizon ends them; what that cuts off is negligible where
    the noise makes everyone leave. Raises NppgError where there is no noise."""

    def __init__(self, domain: Domain, cells: int = 1000):
        numbers = {name: float(value) for name, value in domain.parameters.items()}
        if numbers["noise_sd"] <= 0:
            raise NppgError(
                f"{domain.path}: noise_sd must be above 0 for the optimal policy, not {numbers['noise_sd']}"
            )
        self.edges = np.linspace(0, numbers["length"], cells + 1)
        self.centres = (self.edges[:-1] + self.edges[1:]) / 2
        self._step_reward, self._exit_reward = numbers["step_reward"], numbers["exit_reward"]
        self._moves = [  # for left and right, by cell: the probabilities of all cells
            _masses(self.edges - (self.centres + sign * numbers["step"] + numbers["noise_mean"])[:, None], numbers)
            for sign in (-1, 1)
        ]

    def optimum(self) -> Optimum:
        """The optimal policy."""
        values, change = np.zeros(len(self.centres)), math.inf
        while change > _CHANGE:
            left, right = (self._backed_up(moves, values) for moves in self._moves)
            new = np.maximum(left, right)
            change = float(np.abs(new - values).max())
            values = new
        goes_right = right > left
        switch = self.edges[np.argmax(goes_right)] if goes_right.any() else self.edges[-1]
        return Optimum(values, goes_right, float(values.mean()), float(switch))

    def values(self, right: np.ndarray) -> np.ndarray:
        """The expected return from each cell of a policy that goes right with these probabilities."""
        moves = self._moves[0] + right[:, None] * (self._moves[1] - self._moves[0])
        return np.linalg.solve(np.eye(len(moves)) - moves, self._backed_up(moves, np.zeros(len(moves))))

    def _backed_up(self, moves: np.ndarray, values: np.ndarray) -> np.ndarray:
        """The expected reward and value after moves."""
        staying = moves.sum(axis=1)
        return staying * self._step_reward + (1 - staying) * self._exit_reward + moves @ values


def _masses(distances: np.ndarray, numbers: dict[str, float]) -> np.ndarray:
    """The probabilities that the noise ends between each two of these distances from its mean."""
    scaled = distances / (numbers["noise_sd"] * math.sqrt(2))
    return np.diff(np.vectorize(math.erf)(scaled)) / 2
