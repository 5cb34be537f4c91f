"""The possible splits of a node's examples, by the answers to its candidate tests."""

from __future__ import annotations

import sys
from typing import NamedTuple

import numpy as np

ROUNDING = 1e-9  # of sums of weights


class Split(NamedTuple):
    """A candidate, and the limit of what it covers where answers are numbers."""

    candidate: int
    limit: float

    def covered(self, answers: np.ndarray) -> np.ndarray:
        """Which examples pass, for answers of shape (examples, candidates)."""
        own = answers[:, self.candidate]
        return own if own.dtype == bool else own <= self.limit


class Splits:
    """The possible splits of a node's examples, by their answers: one for each candidate; where answers are numbers,
    one for each candidate and each cut between two values, halfway (the lower value where that is as far as numbers
    go), or for at most `granularity` quantiles of the cuts of each candidate."""

    def __init__(self, answers: np.ndarray, granularity: int):
        self._truths = answers.dtype == bool
        if self._truths:
            self._covered = answers.astype(float)
            return
        self._order = np.argsort(answers, axis=0, kind="stable")
        ordered = np.take_along_axis(answers, self._order, axis=0)
        cuts = (ordered[:-1] < ordered[1:]).T
        if granularity:
            cuts = np.stack([_quantiles(each, granularity) for each in cuts])
        self._candidates, self._last = np.nonzero(cuts)  # of each split, and the position of the last covered example
        low, high = ordered[self._last, self._candidates], ordered[self._last + 1, self._candidates]
        middle = low / 2 + high / 2
        limits = np.where(middle < high, middle, low)
        self._limits = np.maximum(limits, -sys.float_info.max)  # a threshold is finite

    def sums(self, weights: np.ndarray) -> np.ndarray:
        """For each split the sum of the weights, shape (examples,), of the examples that it covers."""
        if self._truths:
            return np.add.reduce(self._covered * weights[:, None], axis=0)
        return weights[self._order].cumsum(axis=0)[self._last, self._candidates]

    def counts(self) -> np.ndarray:
        """For each split the number of examples that it covers."""
        return np.add.reduce(self._covered, axis=0) if self._truths else self._last + 1.0

    def __getitem__(self, split: int) -> Split:
        return Split(split, 0.5) if self._truths else Split(int(self._candidates[split]), float(self._limits[split]))


def _quantiles(cuts: np.ndarray, granularity: int) -> np.ndarray:
    """At most so many of the cuts, each the first that leaves the k-th share of the examples below it."""
    places = np.flatnonzero(cuts)
    if len(places) <= granularity:
        return cuts
    wanted = np.arange(1, granularity + 1) * (len(cuts) + 1) / (granularity + 1) - 1
    kept = np.zeros_like(cuts)
    kept[places[np.minimum(np.searchsorted(places, wanted), len(places) - 1)]] = True
    return kept


def large_enough(w1: np.ndarray, whole: float, least: int) -> np.ndarray:
    """The splits that leave the weight of `least` examples to both branches, by the weights that they cover."""
    return ((w1 >= least - ROUNDING) & (w1 <= whole - least + ROUNDING)).nonzero()[0]
