"""Regression trees of weighted examples with one target or several: splits by the reduction of weighted variance.

It is summed over the targets in units of their deviation (predictive clustering, Blockeel, De Raedt and Ramon 1998).
"""

from __future__ import annotations

import numpy as np

from nppg.bias.declarations import MIN_VARIANCE
from nppg.trees.splits import ROUNDING, Split, Splits, large_enough
from nppg.trees.tilde import first_best, gains, is_significant
from nppg.trees.tree import Leaf


class Several:
    """The criterion of `targets` of shape (examples, targets). Leaves hold the weight of at least so many examples
    as `least`; `significance` is the level of the F-test."""

    def __init__(
        self, targets: np.ndarray, weights: np.ndarray, least: int, significance: float = 1.0, granularity: int = 0
    ):
        self.targets, self.weights = targets, weights
        self.least, self.significance, self.granularity = least, significance, granularity
        mean = np.average(targets, axis=0, weights=weights)
        deviation = np.sqrt(np.average((targets - mean) ** 2, axis=0, weights=weights))
        self._scaled = (targets - mean) / np.where(deviation > 0, deviation, 1.0)

    def is_pure(self, members: np.ndarray) -> bool:
        whole = float(self.weights[members].sum())
        return whole < 2 * self.least - ROUNDING or self._squares(members) / whole < MIN_VARIANCE

    def best(self, answers: np.ndarray, members: np.ndarray) -> Split | None:
        splits = Splits(answers, self.granularity)
        weights = self.weights[members]
        w1, whole = splits.sums(weights), float(weights.sum())
        allowed = large_enough(w1, whole, self.least)
        if not len(allowed):
            return None
        w1 = w1.take(allowed)
        gain = np.zeros(len(allowed))
        for values in self._scaled[members].T:
            weighted = weights * values
            gain += gains(splits.sums(weighted).take(allowed), float(weighted.sum()), w1, whole - w1, whole)
        best = first_best(gain)
        squares = self._squares(members)
        good = is_significant(float(gain[best]), squares, round(whole), self.significance, 1.0)
        return splits[int(allowed[best])] if good else None

    def leaf(self, members: np.ndarray) -> Leaf:
        means = np.average(self.targets[members], axis=0, weights=self.weights[members]).tolist()
        return Leaf(means[0], len(members), tuple(means))

    def _squares(self, members: np.ndarray) -> float:
        """The weighted sum of squares around the means."""
        values, weights = self._scaled[members], self.weights[members]
        return float((weights[:, None] * (values - np.average(values, axis=0, weights=weights)) ** 2).sum())
