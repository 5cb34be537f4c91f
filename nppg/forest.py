"""A sum of trees as arrays: the fast path of the potential.

The trees of a policy share few distinct tests. Each state-action pair is asked those once; its row of answers
decides its path through every tree. Rows that have been met before are remembered with their sum. The order of
addition is that of the trees, so the sum equals Prolog's to the bit.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from nppg.logic import Query
from nppg.tree import Leaf, Tree

_MEMORY = 20_000  # distinct rows that are remembered
_CHUNK = 2_000_000  # leaves that are looked up at once


class Forest:
    """Trees over a table of tests."""

    def __init__(self) -> None:
        self.roots: list[int] = []
        self.depth = 0
        self._column: list[int] = []
        self._children: list[tuple[int, int]] = []  # (failure, success)
        self._value: list[float] = []
        self._arrays: tuple[np.ndarray, ...] | None = None
        self._forget()

    def _forget(self) -> None:
        self._known: dict[bytes, int] = {}
        self._rows = np.empty((0, 0), bool)
        self._sums = np.empty(0)

    def add(self, tree: Tree, column_of: Callable[[Query], int]) -> None:
        """Adds a tree; `column_of` gives the place of a test's answer in a row."""
        depths: list[int] = []
        start = len(self._column)
        self.roots.append(self._place(tree, column_of, 0, depths))
        self.depth = max(self.depth, *depths)
        self._arrays = None
        if max(self._column[start:]) >= self._rows.shape[1]:  # the rows lack the answer to a new test
            self._forget()
        elif len(self._known):
            self._sums[: len(self._known)] += self._values(self._rows[: len(self._known)], len(self.roots) - 1)[:, 0]

    def _place(self, tree: Tree, column_of: Callable[[Query], int], depth: int, depths: list[int]) -> int:
        if isinstance(tree, Leaf):
            depths.append(depth)
            return self._node(0, None, tree.value)
        failure = self._place(tree.no, column_of, depth + len(tree.tests), depths)
        success = self._place(tree.yes, column_of, depth + len(tree.tests), depths)
        for test in reversed(tree.tests):
            success = self._node(column_of(test), (failure, success), 0.0)
        return success

    def _node(self, column: int, children: tuple[int, int] | None, value: float) -> int:
        number = len(self._value)
        self._column.append(column)
        self._children.append(children or (number, number))
        self._value.append(value)
        return number

    def _values(self, rows: np.ndarray, first: int) -> np.ndarray:
        """The value of each tree from number `first` on, for each row: shape (rows, trees)."""
        if first == len(self.roots) - 1:  # the newest tree alone: its nodes are the last ones
            low = 0 if first == 0 else self.roots[first - 1] + 1
            low = min(low, len(self._value))
            column, children = np.array(self._column[low:]), np.array(self._children[low:]) - low
            value, roots = np.array(self._value[low:]), np.array([self.roots[first] - low])
        else:
            column, children, value, roots = self._all()
            roots = roots[first:]
        node = np.broadcast_to(roots, (len(rows), len(roots)))
        if rows.shape[1]:
            at = np.arange(len(rows))[:, None]
            for _ in range(self.depth):
                node = children[node, rows[at, column[node]].astype(np.intp)]
        return value[node]

    def _all(self) -> tuple[np.ndarray, ...]:
        if self._arrays is None:
            self._arrays = tuple(map(np.array, (self._column, self._children, self._value, self.roots)))
        return self._arrays

    def sums(self, rows: np.ndarray) -> np.ndarray:
        """The potential of each row of answers."""
        if not self.roots:
            return np.zeros(len(rows))
        if rows.shape[1] != self._rows.shape[1] or len(self._known) + len(rows) > _MEMORY:
            self._forget()
        keys = [row.tobytes() for row in np.ascontiguousarray(rows)]
        new = {key: i for i, key in reversed(list(enumerate(keys))) if key not in self._known}
        if new:
            self._remember(new, rows)
        return self._sums[[self._known[key] for key in keys]]

    def _remember(self, new: dict[bytes, int], rows: np.ndarray) -> None:
        fresh = rows[list(new.values())]
        size = len(self._known)
        if size + len(fresh) > len(self._rows):
            room = 2 * (size + len(fresh))
            self._rows = (
                np.resize(self._rows[:size], (room, rows.shape[1])) if size else np.empty((room, rows.shape[1]), bool)
            )
            self._sums = np.resize(self._sums[:size], room) if size else np.empty(room)
        self._known |= {key: size + i for i, key in enumerate(new)}
        self._rows[size : size + len(fresh)] = fresh
        step = max(1, _CHUNK // len(self.roots))
        for a in range(0, len(fresh), step):
            part = fresh[a : a + step]
            self._sums[size + a : size + a + len(part)] = np.cumsum(self._values(part, 0), axis=1)[:, -1]
