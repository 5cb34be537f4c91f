"""The best that any policy can do in a finite space, and what a policy does, in expected returns.

A return is the discounted sum of the domain's rewards until the episode ends: in a goal or terminal state, or after as
many steps as the domain's horizon allows from its start. So both are found by backward induction over the steps left,
V_t(s) = max_a sum_s' P(s' | s, a) (r + discount V_{t-1}(s')), with the policy's mean in place of the maximum.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from nppg.judging.space import Space
from nppg.policy.gibbs import best_of_groups


@dataclass(frozen=True, slots=True)
class Returns:
    """Expected returns: of an episode from each class of the space (0 where it is no start), of one that starts with
    each pair of a running class and an action, and the mean over all start states."""

    values: np.ndarray
    pairs: np.ndarray
    mean: float


class ReturnEvaluator:
    """The space of a domain with the expected reward of each of its pairs. Raises NppgError where reward/2 draws."""

    def __init__(self, space: Space, discount: float = 1.0):
        self.space = space
        self.discount = discount
        domain = space.domain
        rewards = [
            math.fsum(probability * domain.reward(successor, action) for probability, successor in outcomes)
            for state, running in zip(space.states, space.running, strict=True)
            if running
            for action, outcomes in domain.neighbours(state)
        ]
        self._rewards = np.array(rewards, float)
        self._first = np.flatnonzero(np.diff(space.owner, prepend=-1))  # pair of each running class
        self._optimal: Returns | None = None

    def optimal(self) -> Returns:
        """What an optimal policy gets, which knows how many steps are left."""
        if self._optimal is None:
            self._optimal = self._returns(lambda pairs: np.maximum.reduceat(pairs, self._first))
        return self._optimal

    def of(self, probabilities: np.ndarray) -> Returns:
        """What a policy gets that takes the action of each pair with this probability; see ExactEvaluator."""
        return self._returns(lambda pairs: np.add.reduceat(pairs * probabilities, self._first))

    def agreement(self, probabilities: np.ndarray, tolerance: float = 1e-9) -> float:
        """The probability that the first action from a random start state is optimal: but for `tolerance` times the
        largest return of its state."""
        is_best = best_of_groups(self.optimal().pairs, self._first, tolerance)
        agreeing = np.bincount(self.space.owner, probabilities * is_best, len(self.space.states))
        return self.space.mean(np.minimum(agreeing, 1.0))

    def _returns(self, backup: Callable[[np.ndarray], np.ndarray]) -> Returns:
        space, owner = self.space, self.space.owner
        limits = np.array(space.horizons)
        value, values, kept = np.zeros(len(limits)), np.zeros(len(limits)), np.zeros(len(owner))
        for t in range(1, limits.max(initial=0) + 1):
            pairs = self._rewards + self.discount * np.bincount(
                space.origin, space.weight * value[space.target], len(owner)
            )
            value[space.running] = backup(pairs)
            values[limits == t] = value[limits == t]
            kept[limits[owner] == t] = pairs[limits[owner] == t]
        return Returns(values, kept, space.mean(values))
