"""A tree that grows by splitting its leaves, which are numbered; what a leaf predicts is its owner's affair."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import count
from typing import Any

import numpy as np

from nppg.answers.table import Table
from nppg.bias.refinement import Refinement, Refiner
from nppg.logic.query import Query
from nppg.policy.forest import Forest
from nppg.trees.tree import Leaf, Node, Tree, mapped, rules


class NumberedTree:
    """`queries` and `depths` have an entry for each leaf: its associated query, and how many tests lead to it."""

    def __init__(self, table: Table, refiner: Refiner, tree: Tree | None = None):
        tree = tree or Leaf(0.0)
        self.table = table
        self.refiner = refiner
        self.queries: list[Query] = [rule.query for rule in rules(tree)]
        self.depths = list(_depths(tree))
        numbers = count()
        self._grow(mapped(tree, lambda _: float(next(numbers))))

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

        self.table.add([test.test])
        self._grow(grown(self._tree))
        return new

    def _grow(self, tree: Tree) -> None:
        self._tree = tree
        self._forest = Forest()
        self._forest.add(tree, self.table.place)

    def saved(self) -> dict[str, Any]:
        """The tree and the tests of its table, to be stored."""
        return {"tree": self._tree, "queries": self.queries, "depths": self.depths, "tests": list(self.table.tests)}

    def resume(self, saved: dict[str, Any]) -> None:
        """Is that tree."""
        self.table.add(saved["tests"])
        self.queries, self.depths = saved["queries"], saved["depths"]
        self._grow(saved["tree"])

    def with_values(self, value_of: Callable[[int], float]) -> Tree:
        """The tree with a value in each leaf."""
        return mapped(self._tree, lambda number: value_of(int(number)))

    def in_order(self) -> list[int]:
        """The leaves in the order of the tree's rules."""
        return [int(rule.value) for rule in rules(self._tree)]


def _depths(tree: Tree, depth: int = 0) -> Iterator[int]:
    if isinstance(tree, Leaf):
        yield depth
    else:
        yield from _depths(tree.yes, depth + 1)
        yield from _depths(tree.no, depth + 1)
