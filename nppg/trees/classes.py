"""Classification trees: splits by information gain, or by its ratio to the information of the split (Quinlan 1993)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nppg.trees.splits import ROUNDING, Split, Splits, large_enough
from nppg.trees.tilde import first_best
from nppg.trees.tree import Leaf

_GAIN = 1e-9  # bits: less is no gain but rounding


@dataclass(frozen=True, slots=True)
class Classes:
    """The criterion of examples that belong to classes."""

    labels: np.ndarray  # the number of each example's class
    weights: np.ndarray
    count: int  # of classes
    is_ratio: bool  # whether gains are divided by the information of the split
    least: int  # examples of each branch, by weight
    granularity: int = 0

    def is_pure(self, members: np.ndarray) -> bool:
        sums = self._sums(members)
        return float(sums.sum()) < 2 * self.least - ROUNDING or int(np.count_nonzero(sums)) < 2

    def best(self, answers: np.ndarray, members: np.ndarray) -> Split | None:
        splits = Splits(answers, self.granularity)
        labels, weights = self.labels[members], self.weights[members]
        covered = np.stack([splits.sums(np.where(labels == each, weights, 0.0)) for each in range(self.count)])
        whole = self._sums(members)
        allowed = large_enough(covered.sum(axis=0), float(whole.sum()), self.least)
        if not len(allowed):
            return None
        covered = covered[:, allowed]
        others = np.maximum(whole[:, None] - covered, 0.0)
        size = whole.sum()
        rest = (covered.sum(axis=0) * entropy(covered) + others.sum(axis=0) * entropy(others)) / size
        gain = float(entropy(whole[:, None])[0]) - rest
        if self.is_ratio:
            parts = np.stack([covered.sum(axis=0), others.sum(axis=0)])
            gain = np.where(gain > _GAIN, gain / np.maximum(entropy(parts), _GAIN), 0.0)
        best = first_best(gain)
        return splits[int(allowed[best])] if gain[best] > _GAIN else None

    def leaf(self, members: np.ndarray) -> Leaf:
        sums = self._sums(members)
        return Leaf(float(sums.argmax()), len(members), tuple(sums.tolist()))

    def _sums(self, members: np.ndarray) -> np.ndarray:
        """The weight of each class."""
        return np.bincount(self.labels[members], self.weights[members], self.count)


def entropy(weights: np.ndarray) -> np.ndarray:
    """Of each column of weights of classes, in bits."""
    shares = weights / np.maximum(weights.sum(axis=0), np.finfo(float).tiny)
    return -(shares * np.log2(np.where(shares > 0, shares, 1.0))).sum(axis=0)
