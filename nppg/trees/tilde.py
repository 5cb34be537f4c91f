"""TILDE: top-down induction of relational regression trees (Blockeel and De Raedt 1998).

Usable on its own: `fit(examples, domain, bias)` grows a tree from states and actions with real targets.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from nppg.answers.coverage import Coverage, Known, root_table
from nppg.bias.declarations import TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.logic.query import Query
from nppg.trees.given import given, must_be_finite
from nppg.trees.tree import Leaf, Node, Tree, mapped
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State

_GAIN = 1e-9  # less than this, in the square of the targets' unit, is no gain but rounding
_TIE = 1e-9  # gains this near to the best one, relatively, count as equal: the first candidate wins


class Example(NamedTuple):
    """A state, an action in it and a real target."""

    state: State
    action: Action
    value: float


def fit(examples: Sequence[Example], domain: Domain, bias: LanguageBias) -> Tree:
    """Grows a tree from examples; those of one state should stand together. Limits are the bias's.
    Raises NppgError for what is no example."""
    refiner = Refiner(bias)
    states, actions, targets = given(examples, domain)
    coverage = Coverage(root_table(domain, bias, refiner), states, actions)
    mean = math.fsum(targets.tolist()) / len(targets)  # far from 0, sums of squares would cancel
    return mapped(grow(targets - mean, coverage, refiner, bias.tree), lambda value: value + mean)


@dataclass(frozen=True, slots=True)
class Newton:
    """What makes a tree a second-order step: with gradients f for targets and curvatures h, shape (examples,), a leaf
    predicts sum(f) / (sum(h) + regularisation), clipped to +-clip, and splits are judged by how far that goes."""

    curvatures: np.ndarray
    regularisation: float
    clip: float


def grow(
    targets: np.ndarray,
    coverage: Coverage,
    refiner: Refiner,
    limits: TreeLimits,
    newton: Newton | None = None,
    query: Query = (),
    unit: float | None = None,
) -> Tree:
    """Grows a tree for one target per example of `coverage`: of means, or for a second-order step. `query` is the
    root's: it holds for all examples. What is a gain at all is judged in the targets' `unit`, which is their size
    unless it is given: so the tree does not hang on how rewards are scaled."""
    unit = size_of(targets) if unit is None else unit
    must_be_finite("the target", targets)
    if newton:
        must_be_finite("the curvature", newton.curvatures)

    def node(query: Query, members: np.ndarray, known: Known, depth: int) -> Tree:
        values = targets[members]
        if depth == limits.max_depth or is_pure(values, limits, unit):
            return leaf(targets, members, newton)
        candidates = refiner.refinements(query)
        answers, known = coverage.matrix(candidates, members, known)
        if newton:
            best = best_step(answers, values, newton.curvatures[members], newton.regularisation, limits, unit)
        else:
            best = best_split(answers, values, limits, unit)
        if best is None:
            return leaf(targets, members, newton)
        chosen, covered = candidates[best.candidate], best.covered(answers)
        if chosen.is_open:
            chosen = chosen.closed(best.limit)
        return Node(
            chosen.literals,
            (chosen.test,),
            node(query + chosen.literals, members[covered], known, depth + 1),
            node(query, members[~covered], known, depth + 1),
        )

    return node(query, np.arange(len(targets)), {}, 0)


def leaf(targets: np.ndarray, members: np.ndarray, newton: Newton | None) -> Leaf:
    """Of these examples."""
    total, weight = math.fsum(targets[members].tolist()), float(max(len(members), 1))
    if newton:
        weight = math.fsum(newton.curvatures[members].tolist()) + newton.regularisation
    value = total / weight if weight else 0.0
    return Leaf(max(-newton.clip, min(newton.clip, value)) if newton else value, len(members))


def size_of(values: np.ndarray) -> float:
    """The mean absolute value of those that are not 0, the unit of what is made from them; 0 where there are none."""
    found = np.abs(values[values != 0])
    return float(found.sum()) / len(found) if len(found) else 0.0


def is_pure(values: np.ndarray, limits: TreeLimits, unit: float) -> bool:
    """Whether a node with these targets is not to be split: they are too few, or too alike."""
    if len(values) < 2 * limits.min_examples or not values.any():
        return True
    return _variance(values) < limits.least_variance(unit)


class Split(NamedTuple):
    """A candidate, and the limit of what it covers where answers are numbers."""

    candidate: int
    limit: float

    def covered(self, answers: np.ndarray) -> np.ndarray:
        """Which examples pass, for answers of shape (examples, candidates)."""
        own = answers[:, self.candidate]
        return own if own.dtype == bool else own <= self.limit


class _Splits:
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


def best_split(answers: np.ndarray, values: np.ndarray, limits: TreeLimits, unit: float | None = None) -> Split | None:
    """The split that reduces the weighted variance most, or None if none may split.

    `answers` has shape (examples, candidates). The reduction of the sum of squares is
    s1^2 / n1 + s0^2 / n0 - s^2 / n with the sums s and counts n of the two branches.
    """
    splits = _Splits(answers, limits.granularity)
    n1, count = splits.counts(), len(values)
    found = best_gain(splits.sums(values), values.sum(), n1, count, n1, float(count), limits.min_examples)
    if found is None:
        return None
    squares = 0.0 if limits.significance == 1.0 else _variance(values) * count
    unit = size_of(values) if unit is None else unit
    return splits[found[0]] if is_significant(found[1], squares, count, limits.significance, unit) else None


def best_step(
    answers: np.ndarray,
    values: np.ndarray,
    curvatures: np.ndarray,
    regularisation: float,
    limits: TreeLimits,
    unit: float | None = None,
) -> Split | None:
    """The split with the largest sum of f^2 / (h + regularisation) over the two branches, f and h the branch's sums,
    or None if none exceeds that of the undivided node. There is no F-test. Gains are in the targets' unit, as
    curvatures are too."""
    splits = _Splits(answers, limits.granularity)
    s1, h1 = splits.sums(values), splits.sums(curvatures)
    whole = float(curvatures.sum())
    found = best_gain(s1, values.sum(), splits.counts(), len(values), h1, whole, limits.min_examples, regularisation)
    unit = size_of(values) if unit is None else unit
    return splits[found[0]] if found and found[1] > 0 and found[1] >= _GAIN * unit else None


def best_gain(
    s1: np.ndarray,
    total: float,
    n1: np.ndarray,
    count: float,
    weights: np.ndarray,
    whole: float,
    least: int,
    regularisation: float = 0.0,
) -> tuple[int, float] | None:
    """The split of the largest s1^2 / w1 + s0^2 / w0 - s^2 / w, and that gain; None where no split leaves
    `least` examples to both branches.

    Of each split's covered examples: the sum `s1` of the values, the number `n1` and the sum `weights` of weights,
    and of all examples `total`, `count` and `whole`; `regularisation` is added to each weight. The sums are to run in a
    fixed order, so that the outcome does not depend on the machine's linear algebra."""
    w1 = weights + regularisation if regularisation else weights
    w0 = whole - weights + regularisation if regularisation else whole - weights
    allowed = ((n1 >= least) & (n1 <= count - least) & (w1 > 0) & (w0 > 0)).nonzero()[0]
    if not len(allowed):
        return None
    s1, w1, w0 = s1.take(allowed), w1.take(allowed), w0.take(allowed)
    gain = s1**2 / w1 + (total - s1) ** 2 / w0
    gain -= total**2 / (whole + regularisation)
    top = float(gain.max())
    best = int((gain >= top - _TIE * abs(top)).argmax())
    return int(allowed[best]), float(gain[best])


def _variance(values: np.ndarray) -> float:
    mean = np.add.reduce(values) / len(values)
    return float(np.add.reduce((values - mean) ** 2) / len(values))


def is_significant(gain: float, squares: float, count: int, level: float, unit: float) -> bool:
    """The F-test of regression trees, F(1, n - 2) = (n - 2) gain / (squares - gain), with the sum of squares around
    the mean of n = `count` values; level 1 accepts any gain that is more than rounding in the values' unit."""
    if gain <= 0 or gain < _GAIN * unit * unit:
        return False
    if level == 1.0:
        return True
    rest = squares - gain
    return count > 2 and (rest <= 0 or f_test((count - 2) * gain / rest, count - 2) <= level)


def f_test(f: float, degrees: int) -> float:
    """P(F(1, degrees) > f), by the regularised incomplete beta function I_x(degrees / 2, 1 / 2) at
    x = degrees / (degrees + f)."""
    return _incomplete_beta(degrees / 2, 0.5, degrees / (degrees + f))


def _incomplete_beta(a: float, b: float, x: float) -> float:
    """I_x(a, b) by its continued fraction (Abramowitz and Stegun 26.5.8), evaluated by Lentz's method."""
    if x <= 0 or x >= 1:
        return float(x >= 1)
    if x > (a + 1) / (a + b + 2):
        return 1 - _incomplete_beta(b, a, 1 - x)
    log_front = math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b) + a * math.log(x) + b * math.log1p(-x)
    c, d, fraction = 1.0, 1 / (1 - (a + b) * x / (a + 1)), 1 / (1 - (a + b) * x / (a + 1))
    for m in range(1, 400):
        for term in (
            m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
            -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1)),
        ):
            d, c = 1 / (1 + term * d), 1 + term / c
            fraction *= c * d
        if abs(c * d - 1) < 1e-14:
            break
    return math.exp(log_front) * fraction / a
