"""A tree that grows by splitting its leaves, which are numbered; what a leaf predicts is its owner's affair."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from nppg.coverage import TestTable
from nppg.forest import Forest
from nppg.logic import Query
from nppg.refinement import Refinement, Refiner
from nppg.tree import Leaf, Node, Tree, mapped


class NumberedTree:
    """`queries` and `depths` have an entry for each leaf: its associated query, and how many tests lead to it."""

    def __init__(self, table: TestTable, refiner: Refiner):
        self.table = table
        self.refiner = refiner
        self.queries: list[Query] = [()]
        self.depths = [0]
        self._tree: Tree = Leaf(0.0)
        self._forest = Forest()
        self._forest.add(self._tree, table.column)

    def __len__(self) -> int:
        return len(self.queries)

    def leaf_of(self, answers: np.ndarray) -> np.ndarray:
        """The leaf of each row of answers to the table's tests, shape (pairs,)."""
        return self._forest.sums(answers).astype(int)

    def candidates(self, leaf: int) -> tuple[Refinement, ...]:
        """The tests that may split a leaf."""
        return self.refiner.refinements(self.queries[leaf])

    def split(self, leaf: int, test: Refinement) -> int:
        """Returns the number of the new leaf, in which the test holds; the other one keeps the old number."""
        new = len(self)
        self.queries.append(self.queries[leaf] + test.literals)
        self.depths[leaf] += 1
        self.depths.append(self.depths[leaf])

        def grown(part: Tree) -> Tree:
            if isinstance(part, Node):
                return Node(part.literals, part.tests, grown(part.yes), grown(part.no))
            return Node(test.literals, (test.test,), Leaf(float(new)), part) if part.value == leaf else part

        self._tree = grown(self._tree)
        self.table.add([test.test])
        self._forest = Forest()
        self._forest.add(self._tree, self.table.column)
        return new

    def with_values(self, value_of: Callable[[int], float]) -> Tree:
        """The tree with a value in each leaf."""
        return mapped(self._tree, lambda number: value_of(int(number)))
