"""RIB: instance-based regression on a relational distance (Driessens and Ramon 2003), in bounded memory.

The prediction for a pair i is the mean of the instances' values weighted by nearness,

    q(i) = sum_j(q_j / d_ij^power) / sum_j(1 / d_ij^power),

the value of the instance at distance 0 where there is one, and 0 as long as there is no instance. An example is kept
out where its prediction is good already, judged by how far values deviate nearby and on the whole; and where memory
is full, an instance is removed. The two limits and the two ways of removal are the paper's in kind; their formulas and
numbers, as they stand here, are choices of nppg, the paper's own being unknown.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np

from nppg.rrl.options import InstanceOptions
from nppg.rrl.removal import Contributions, error_contributions, variance_excess

_NEWS = 1e-6  # an error up to this share of the largest value met is never worth an instance
_FLAT = 4.0  # up to this power weights are kept in single precision; others differ too widely for its exponents
_REMEMBERED = 2**28  # bytes for distances of classes from the instances, at most
_TOGETHER = 2**20  # distances that are computed together


class Distance(Protocol):
    """Between numbered things."""

    def rows(self, pairs: np.ndarray, others: np.ndarray) -> np.ndarray:
        """Distances of shape (pairs, others)."""


class Instances:
    """A regressor over the numbers of a distance's classes. Every class is stored at most once."""

    def __init__(self, distance: Distance, options: InstanceOptions):
        self.distance = distance
        self.options = options
        room = options.max_instances + 1  # one comes in before one goes
        self.unit = 0.0  # the largest |value| met
        self._size = 0
        self._pairs = np.zeros(room, np.int64)
        self._values = np.zeros(room)
        # 1 / d_ij^power between instances, 0 on the diagonal; only for the choice of what to remove: precise enough
        self._weights = np.zeros((room, room), np.float32 if options.power <= _FLAT else np.float64)
        self._contributions = Contributions(self._weights, self._values)
        self._changed = np.zeros(room, np.int64)  # when each place took its instance, in changes
        self._changes = 0
        self._forget(np.float32)

    def __len__(self) -> int:
        return self._size

    @property
    def pairs(self) -> np.ndarray:
        """The classes of the instances, shape (instances,)."""
        return self._pairs[: self._size].copy()

    @property
    def values(self) -> np.ndarray:
        """Their values, in the same order."""
        return self._values[: self._size].copy()

    def predict(self, pairs: np.ndarray) -> np.ndarray:
        """q of each class, shape (pairs,)."""
        return self._predicted(self._distances(pairs))

    def _distances(self, pairs: np.ndarray) -> np.ndarray:
        """Of classes from the instances, shape (pairs, instances). They are remembered: only the distances from
        instances that have come since a class was met last are computed."""
        unknown = {each for each in pairs.tolist() if each not in self._row_of}
        if len(self._row_of) + len(unknown) > len(self._rows):
            self._forget(self._rows.dtype)
            if len(set(pairs.tolist())) > len(self._rows):
                return self.distance.rows(pairs, self._pairs[: self._size])
        rows = np.array([self._row_of.setdefault(each, len(self._row_of)) for each in pairs.tolist()], np.int64)
        looked = self._looked[rows]
        for when in np.unique(looked[looked < self._changes]).tolist():
            new = np.flatnonzero(self._changed[: self._size] > when)
            some = np.flatnonzero(looked == when)
            step = 1 + _TOGETHER // max(1, len(new))
            for start in range(0, len(some), step):
                batch = some[start : start + step]
                found = self.distance.rows(pairs[batch], self._pairs[new])
                kept = found.astype(self._rows.dtype)
                if (kept != found).any():
                    self._forget(np.float64)
                    return self._distances(pairs)
                self._rows[rows[batch, None], new] = kept
        self._looked[rows] = self._changes
        return self._rows[rows, : self._size].astype(float)

    def _forget(self, precision: type | np.dtype) -> None:
        """Begins anew to remember; in single precision as long as distances are as good there."""
        room = len(self._pairs)
        size = _REMEMBERED // np.dtype(precision).itemsize // room
        self._rows = np.zeros((size, room), precision)  # zeros take no room before they are used
        self._looked = np.zeros(size, np.int64)  # how many changes each row has seen
        self._row_of: dict[int, int] = {}  # of each class that is remembered

    def _predicted(self, distances: np.ndarray) -> np.ndarray:
        if self._size == 0:
            return np.zeros(len(distances))
        with np.errstate(divide="ignore"):
            weights = distances**-self.options.power
        there = distances == 0
        hit = there.any(axis=1)
        weights[hit] = there[hit]
        return weights @ self._values[: self._size] / weights.sum(axis=1)

    def update(self, pair: int, value: float) -> None:
        """Learns from one example. The value of a class that is stored becomes that of the example."""
        self.unit = max(self.unit, abs(value))
        distances = self._distances(np.array([pair]))
        same = np.flatnonzero(distances[0] == 0)
        if len(same):
            for place in same.tolist():
                self._contributions.revalue(place, value, self._size)
            self._values[same] = value
        elif self._is_news(abs(value - self._predicted(distances)[0]), distances[0]):
            self._append(pair, value, distances[0])
            if self._size > self.options.max_instances:
                self._remove(self._least())

    def store(self, pair: int, value: float) -> None:
        """Takes in an instance without asking whether it is news, as from a file. The class must be a new one."""
        if self._size == self.options.max_instances:
            raise ValueError(f"there is room for {self.options.max_instances} instances only")
        self.unit = max(self.unit, abs(value))
        self._append(pair, value, self._distances(np.array([pair]))[0])

    def saved(self) -> dict[str, Any]:
        """The instances with all that is known of them, to be stored, but for their classes."""
        size = self._size
        weights = self._weights[:size, :size]
        values = self._values[:size]
        return {"unit": self.unit, "values": values, "weights": weights, "sums": self._contributions.saved()}

    def resume(self, pairs: Sequence[int], saved: dict[str, Any]) -> None:
        """Holds these, which are of the classes `pairs`."""
        self.unit, self._size = saved["unit"], len(pairs)
        self._pairs[: self._size], self._values[: self._size] = pairs, saved["values"]
        self._weights[: self._size, : self._size] = saved["weights"]
        self._contributions.resume(saved["sums"])
        for place in range(self._size):
            self._take(place)

    def _is_news(self, error: float, distances: np.ndarray) -> bool:
        """Whether an example is so badly predicted that it should be stored: its error is more than `global_deviation`
        times the standard deviation of all values and `local_deviation` times that of its nearest neighbours'."""
        options, values = self.options, self._values[: self._size]
        if error <= max(_NEWS * self.unit, options.global_deviation * _deviation(values)):
            return False
        if self._size > options.neighbours:
            values = values[np.argpartition(distances, options.neighbours)[: options.neighbours]]
        return error > options.local_deviation * _deviation(values)

    def _append(self, pair: int, value: float, distances: np.ndarray) -> None:
        last = self._size
        self._pairs[last], self._values[last] = pair, value
        self._weights[last, :last] = self._weights[:last, last] = distances**-self.options.power
        self._contributions.add(last)
        self._take(last)
        self._size += 1

    def _take(self, place: int) -> None:
        """Notes that there is another instance in a place."""
        self._changes += 1
        self._changed[place] = self._changes

    def _remove(self, gone: int) -> None:
        """The last instance takes the place of the one that goes."""
        self._contributions.remove(gone, self._size)
        self._size = last = self._size - 1
        for array in (self._pairs, self._values, self._weights, self._weights.T):
            array[gone] = array[last]
        self._weights[gone, gone] = 0
        self._take(gone)

    # -------------------------------------------------- which instance to remove

    def _least(self) -> int:
        if self.options.removal == "maximum-variance":
            excess = self.variance_excess()
            if excess.max() > 0:
                return int(excess.argmax())
        return self._contributions.least(self._size)

    def error_contributions(self) -> np.ndarray:
        """What removing an instance costs, shape (instances,); see removal.py."""
        return error_contributions(self._weights[: self._size, : self._size], self._values[: self._size])

    def variance_excess(self) -> np.ndarray:
        """By how much an instance's slopes |q_i - q_j| / d_ij exceed `max_gradient` in all, shape (instances,)."""
        inverse = self._weights[: self._size, : self._size] ** (1 / self.options.power)
        return variance_excess(inverse, self._values[: self._size], self.options.max_gradient)


def _deviation(values: np.ndarray) -> float:
    return float(values.std()) if len(values) else 0.0
