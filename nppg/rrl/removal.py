"""What leaves a full memory of instances.

`error_contributions` and `variance_excess` say of all instances what they cost and how steep they are, from the matrix
of weights. `Contributions` finds the one that costs least, mostly without the matrix: as a rule it is the one that has
just come.
"""

from __future__ import annotations

from typing import Any

import numpy as np

_ROWS = 64  # of a square matrix that are worked on together, so that they stay in the processor's cache
_MANY = 300  # of fewer instances, all contributions are computed at once
_FEW = 8  # the instances of lowest bounds, whose contributions are computed first
_SOME = 128  # of so many instances at most they are computed in double precision
_ROUNDING = 2.0**-20  # of the sum of all errors: far above what single precision loses in a contribution


def error_contributions(weights: np.ndarray, values: np.ndarray, some: np.ndarray | None = None) -> np.ndarray:
    """What removing an instance costs, shape (instances,): the error of its own prediction from the others, and by
    how much such errors of the others grow in all; of all instances, or of some by their numbers, two or more. There
    must be three instances or more.

    Without its own error an instance that differs from its neighbours would always be the first to go, and as only
    what differs comes in, memory would keep what it held when it was first full.

    With T_i = sum_j w_ij and S_i = sum_j w_ij q_j, the error of i without k is

        |q_i - (S_i - w_ik q_k) / (T_i - w_ik)| = |q_i T_i - S_i - w_ik (q_i - q_k)| / (T_i - w_ik).

    Where w_ik is more than half of T_i, that is the difference of two numbers that may be as good as equal: both
    sums are then made anew without k, the one nearest to i.
    """
    n = len(values)
    values = values.astype(weights.dtype)
    totals = weights.sum(axis=1)
    offsets = values * totals - weights @ values
    nearest = weights.argmax(axis=1)
    ruled = np.flatnonzero(weights[np.arange(n), nearest] > totals / 2)
    others = weights[ruled]
    others[np.arange(len(ruled)), nearest[ruled]] = 0
    rests = others.sum(axis=1)
    without = np.abs(values[ruled] * rests - others @ values) / rests
    columns, of = (slice(None), np.arange(n)) if some is None else (some, some)
    place = np.full(n, -1)
    place[of] = np.arange(len(of))
    ruled, without = ruled[place[nearest[ruled]] >= 0], without[place[nearest[ruled]] >= 0]
    nearest = place[nearest]
    summed = np.zeros(len(of))
    for start in range(0, n, _ROWS):
        rows = slice(start, start + _ROWS)
        among = weights[rows, columns]
        errors = values[rows, None] - values[columns]
        errors *= among
        np.subtract(offsets[rows, None], errors, out=errors)
        np.abs(errors, out=errors)
        rest = totals[rows, None] - among
        own = slice(*np.searchsorted(ruled, (start, start + _ROWS)))
        rest[ruled[own] - start, nearest[ruled[own]]] = 1
        errors /= rest
        errors[ruled[own] - start, nearest[ruled[own]]] = without[own]
        summed += errors.sum(axis=0)
    alone = np.abs(offsets) / totals
    return summed - alone.sum() + alone[columns]  # in both sums the instance's own error is there and the same


def variance_excess(inverse: np.ndarray, values: np.ndarray, most: float) -> np.ndarray:
    """By how much an instance's slopes |q_i - q_j| / d_ij exceed `most` in all, shape (instances,); `inverse` has the
    1 / d_ij. An M that is too small for the values keeps what is new out of a full memory."""
    n = len(values)
    values = values.astype(inverse.dtype)
    excess = np.zeros(n)
    for start in range(0, n, _ROWS):
        some = slice(start, start + _ROWS)
        slopes = values[some, None] - values
        np.abs(slopes, out=slopes)
        slopes *= inverse[some]
        slopes -= most
        np.maximum(slopes, 0, out=slopes)
        excess[some] = slopes.sum(axis=1)
    return excess


class Contributions:
    """Finds the least error contribution among the first instances of `weights` and `values`, which their owner
    changes. It is told of each change.

    With the prediction p_i = S_i / T_i of i from the others, its error e_i = q_i - p_i becomes, without k,

        e_i + d_ik,  d_ik = w_ik (q_k - p_i) / (T_i - w_ik),

    so that the contribution of k is |e_k| + sum_i (|e_i + d_ik| - |e_i|), at least |e_k| + sum_i sign(e_i) d_ik. This
    bound is nearly linear in the weights: without w_ik in the denominator its sum is q_k (W u)_k - (W v)_k with
    u_i = sign(e_i) / T_i and v_i = u_i p_i. These products last while the only change is that another instance comes
    and goes again; how far that and the denominators can lower the sum is bounded for all k at once. Of those that may
    be least by their bounds the contributions are computed, in double precision; between those that differ by no more
    than rounding `error_contributions` decides.
    """

    def __init__(self, weights: np.ndarray, values: np.ndarray):
        self._weights = weights
        self._values = values
        self._sums = np.zeros((3, len(values)))  # over each instance's weights: T, S, and the squares
        self._largest = 0.0  # weight that was ever met
        self._products: tuple[np.ndarray, ...] | None = None  # T, p, sign(e), W u, W v without the last instance

    def _seen(self, values: np.ndarray | float) -> np.ndarray:
        """Values as `error_contributions` sees them."""
        return np.asarray(values).astype(self._weights.dtype).astype(float)

    def saved(self) -> dict[str, Any]:
        """What has been added up, to be stored: in another order the sums would be rounded in another way."""
        return {"sums": self._sums, "largest": self._largest, "products": self._products}

    def resume(self, saved: dict[str, Any]) -> None:
        """Goes on with that."""
        self._sums, self._largest, self._products = saved["sums"], saved["largest"], saved["products"]

    def add(self, last: int) -> None:
        """An instance has come to the place `last`, behind all others."""
        weights, values = self._weights[last, :last].astype(float), self._seen(self._values[: last + 1])
        self._largest = max(self._largest, weights.max(initial=0.0))
        self._sums[:, :last] += weights, weights * values[last], weights**2
        self._sums[:, last] = weights.sum(), weights @ values[:last], weights @ weights

    def remove(self, gone: int, n: int) -> None:
        """One of n instances is about to go; the last takes its place."""
        weights = self._weights[gone, :n].astype(float)
        self._sums[:, :n] -= weights, weights * self._seen(self._values[gone]), weights**2
        self._sums[:, gone] = self._sums[:, n - 1]
        if self._products and gone < len(self._products[0]):
            self._products = None

    def revalue(self, place: int, value: float, n: int) -> None:
        """An instance is about to have another value."""
        change = self._seen(value) - self._seen(self._values[place])
        self._sums[1, :n] += self._weights[place, :n] * change
        self._products = None

    def least(self, n: int) -> int:
        """The number of the instance, of n."""
        candidates = self._candidates(n) if n >= _MANY and self._sums[0, :n].min() >= 4 * self._largest else None
        if candidates is not None and len(candidates) == 1:
            return int(candidates[0])
        costs = error_contributions(self._weights[:n, :n], self._values[:n], candidates)
        return int(costs.argmin() if candidates is None else candidates[costs.argmin()])

    def _candidates(self, n: int) -> np.ndarray | None:
        """Those that it may be, in their order; None for all."""
        values = self._seen(self._values[:n])
        totals = self._sums[0, :n]
        predicted = self._sums[1, :n] / totals
        errors = values - predicted
        alone = np.abs(errors)
        rounding = _ROUNDING * (alone.sum() + 16 * np.abs(values).max())

        def contributions(some: np.ndarray) -> np.ndarray:
            weights = self._weights[some, :n]
            grown = (values[some, None] - predicted) * weights / (totals - weights)
            grown += errors
            np.abs(grown, out=grown)
            grown -= alone
            return alone[some] + grown.sum(axis=1)

        bounds = np.append(self._bounds(values, predicted, errors), -np.inf)
        if not np.isfinite(bounds[:-1]).all():
            return None
        first = np.argpartition(bounds, _FEW)[:_FEW]
        some = np.flatnonzero(bounds <= contributions(first).min() + rounding)
        if 1 < len(some) <= _SOME:
            costs = contributions(some)
            some = some[costs <= costs.min() + rounding]
        return some

    def _bounds(self, values: np.ndarray, predicted: np.ndarray, errors: np.ndarray) -> np.ndarray:
        """Of the contributions of all but the last instance, from below."""
        last = len(values) - 1
        weights, span = self._weights[last, :last].astype(float), np.ptp(values)
        if self._products is None or len(self._products[0]) != last:
            totals = self._sums[0, :last] - weights
            before = (self._sums[1, :last] - weights * values[last]) / totals
            signs = np.sign(values[:last] - before)
            among, vector = self._weights[:last, :last], signs / totals
            products = (among @ each.astype(among.dtype) for each in (vector, vector * before))
            self._products = totals, before, signs, *(each.astype(float) for each in products)
        totals, before, signs, slopes, offsets = self._products
        least = totals - self._largest  # what the denominators are at least
        moved = np.abs(predicted[:last] - before) / least + span * weights / (totals * least)
        squares = self._sums[2, :last]
        slack = np.sqrt(squares) * np.linalg.norm(moved) + squares * (span / (totals * least)).max()
        turned = np.flatnonzero(np.sign(errors[:last]) != signs)
        slack += 2 * span * (1 / least[turned]) @ self._weights[turned, :last]
        own = errors[last] + (values[:last] - predicted[last]) * weights / (self._sums[0, last] - weights)
        return np.abs(errors[:last]) + values[:last] * slopes - offsets - slack + np.abs(own) - abs(errors[last])
