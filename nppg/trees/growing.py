"""How a tree is grown, whatever its targets are: a criterion says which split is the best, and what a leaf is."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from nppg.answers.coverage import Coverage, Known
from nppg.bias.refinement import Refiner
from nppg.logic.query import Query
from nppg.trees.splits import Split
from nppg.trees.tree import Leaf, Node, Tree


class Criterion(Protocol):
    """What is known of the targets; `members` are indices of examples."""

    def is_pure(self, members: np.ndarray) -> bool:
        """Whether a node of these examples is not to be split."""

    def best(self, answers: np.ndarray, members: np.ndarray) -> Split | None:
        """The best split by the answers, shape (members, candidates); None where there is no good one."""

    def leaf(self, members: np.ndarray) -> Leaf:
        """Of these examples."""


def grown(
    criterion: Criterion,
    coverage: Coverage,
    refiner: Refiner,
    max_depth: int | None,
    members: np.ndarray,
    query: Query = (),
) -> Tree:
    """Grows a tree of those examples that are `members`. `query` is the root's: it holds for all of them."""

    def node(query: Query, members: np.ndarray, known: Known, depth: int) -> Tree:
        if depth == max_depth or criterion.is_pure(members):
            return criterion.leaf(members)
        candidates = refiner.refinements(query)
        answers, known = coverage.matrix(candidates, members, known)
        best = criterion.best(answers, members)
        if best is None:
            return criterion.leaf(members)
        chosen, covered = candidates[best.candidate], best.covered(answers)
        if chosen.is_open:
            chosen = chosen.closed(best.limit)
        return Node(
            chosen.literals,
            (chosen.test,),
            node(query + chosen.literals, members[covered], known, depth + 1),
            node(query, members[~covered], known, depth + 1),
        )

    return node(query, members, {}, 0)
