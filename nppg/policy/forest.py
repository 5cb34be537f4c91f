"""A sum of trees as arrays: the fast path of the potential.

The trees of a policy share few distinct tests. Each state-action pair is asked those once; its row of answers
decides its path through every tree. Rows that have been met before are remembered with their sum. The order of
addition is that of the trees, so the sum equals Prolog's to the bit.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from nppg.logic.query import Query
from nppg.trees.tree import Leaf, Tree

_MEMORY = 20_000  # distinct rows that are remembered
_CHUNK = 2_000_000  # leaves that are looked up at once


class _Arrays(NamedTuple):
    """Every node has two places, one for either answer (failure, success), and is known by the first: at each place
    the column that the node asks and its limit, the node behind that answer, the value of a leaf. A leaf leads to
    itself. `roots` has one node per tree."""

    column: np.ndarray
    limit: np.ndarray
    children: np.ndarray
    value: np.ndarray
    roots: np.ndarray

    def leaf_values(self, rows: np.ndarray, depth: int) -> np.ndarray:
        """The value of each tree for each row: shape (rows, trees)."""
        node = self.roots[None, :]
        starts = np.arange(len(rows))[:, None] * rows.shape[1]
        answers = rows.ravel()
        for _ in range(depth):
            answer = answers.take(starts + self.column.take(node))
            node = self.children.take(node + (answer if rows.dtype == bool else answer <= self.limit.take(node)))
        values = self.value.take(node)
        return values if depth else np.broadcast_to(values, (len(rows), len(self.roots)))

    def shifted(self, offset: int) -> _Arrays:
        """The same with places from `offset` on."""
        return self._replace(children=self.children + offset, roots=self.roots + offset)


class Forest:
    """Trees over a table of tests."""

    def __init__(self) -> None:
        self._parts: list[_Arrays] = []  # one after the other they are all trees
        self._places = 0
        self._depth = 0
        self._forget(0)

    def _forget(self, width: int) -> None:
        self._number: dict[bytes, int] = {}
        self._rows = np.empty((16, width), bool)
        self._sums = np.empty(16)

    def add(self, tree: Tree, place_of: Callable[[Query], tuple[int, float]]) -> None:
        """Adds a tree; `place_of` gives the column of a test in a row of answers, and its limit if they are numbers."""
        arrays, depth = _arrays(tree, place_of)
        self._parts.append(arrays.shifted(self._places))
        self._places += len(arrays.value)
        self._depth = max(self._depth, depth)
        size = len(self._number)
        if arrays.column.max() >= self._rows.shape[1]:  # the rows lack the answer to a new test
            self._forget(0)
        elif size:
            self._sums[:size] += arrays.leaf_values(self._rows[:size], depth)[:, 0]

    def sums(self, rows: np.ndarray) -> np.ndarray:
        """The potential of each row of answers."""
        if not self._parts:
            return np.zeros(len(rows))
        if rows.dtype != bool:  # numbers hardly ever come again
            return self._summed(rows)
        if rows.shape[1] != self._rows.shape[1]:
            self._forget(rows.shape[1])
        keys = _keys(rows)
        try:
            return self._sums.take([self._number[key] for key in keys])
        except KeyError:
            pass
        if len(self._number) + len(rows) > _MEMORY:
            self._forget(rows.shape[1])
        new = {key: i for i, key in enumerate(keys) if key not in self._number}
        self._remember(list(new), rows[list(new.values())])
        return self._sums.take([self._number[key] for key in keys])

    def _remember(self, keys: list[bytes], rows: np.ndarray) -> None:
        size, end = len(self._number), len(self._number) + len(keys)
        if end > len(self._rows):
            self._rows = np.concatenate([self._rows[:size], np.empty((end, rows.shape[1]), bool)])
            self._sums = np.concatenate([self._sums[:size], np.empty(end)])
        self._number |= {key: size + i for i, key in enumerate(keys)}
        self._rows[size:end] = rows
        self._sums[size:end] = self._summed(rows)

    def _summed(self, rows: np.ndarray) -> np.ndarray:
        trees = self._joined()
        step = max(1, _CHUNK // len(trees.roots))
        sums = np.empty(len(rows))
        for a in range(0, len(rows), step):
            values = trees.leaf_values(rows[a : a + step], self._depth)
            sums[a : a + step] = np.cumsum(values, axis=1)[:, -1]
        return sums

    def _joined(self) -> _Arrays:
        if len(self._parts) > 1:
            self._parts = [_Arrays(*map(np.concatenate, zip(*self._parts, strict=True)))]
        return self._parts[0]


def _keys(rows: np.ndarray) -> list[bytes]:
    """What is equal for equal rows."""
    width, answers = rows.shape[1], rows.tobytes()
    return [answers[i : i + width] for i in range(0, len(answers), width)] if width else [b""] * len(rows)


def _arrays(tree: Tree, place_of: Callable[[Query], tuple[int, float]]) -> tuple[_Arrays, int]:
    """A tree as arrays, and the number of answers on its longest path."""
    column: list[int] = []
    limits: list[float] = []
    children: list[int] = []
    value: list[float] = []

    def node(asked: tuple[int, float], failure: int, success: int, own: float) -> int:
        column.extend((asked[0], asked[0]))
        limits.extend((asked[1], asked[1]))
        children.extend((failure, success))
        value.extend((own, own))
        return len(value) - 2

    def place(part: Tree) -> tuple[int, int]:
        if isinstance(part, Leaf):
            return node((0, 0.0), len(value), len(value), part.value), 0
        failure, below_failure = place(part.no)
        success, below_success = place(part.yes)
        for test in reversed(part.tests):
            success = node(place_of(test), failure, success, 0.0)
        return success, len(part.tests) + max(below_failure, below_success)

    root, depth = place(tree)
    return _Arrays(*map(np.array, (column, limits, children, value, [root]))), depth
