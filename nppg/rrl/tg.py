"""TG: an incremental first-order regression tree (Driessens, Ramon and Blockeel 2001). No example is stored."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from nppg.answers.coverage import Coverage
from nppg.answers.table import Table
from nppg.bias.refinement import Refiner
from nppg.policy.policy import Policy
from nppg.rrl.numbered_tree import NumberedTree
from nppg.rrl.options import GrowthOptions
from nppg.rrl.qfunction import Example
from nppg.trees.tilde import best_gain, is_significant
from nppg.worlds.world import Action, State


class Statistics:
    """What a leaf keeps: counts, sums and sums of squares of q, of all its examples and by the outcome of each test.

    `whole` has shape (3,) and includes what the leaf took over from its parent; `by_test`, shape (2, 3, tests), with
    the tests that fail first, is about the examples since the leaf came to be.
    """

    def __init__(self, whole: np.ndarray, tests: int):
        self.whole = whole
        self.by_test = np.zeros((2, 3, tests))

    @property
    def mean(self) -> float:
        """0 before the first example."""
        return float(self.whole[1] / self.whole[0]) if self.whole[0] else 0.0

    def add(self, answers: np.ndarray, values: np.ndarray) -> None:
        """Takes in examples: their answers to the tests, shape (examples, tests), and q."""
        powers = np.stack([np.ones(len(values)), values, values**2])
        self.whole += powers.sum(axis=1)
        for outcome in (0, 1):
            self.by_test[outcome] += (powers[:, :, None] * (answers == outcome)).sum(axis=1)

    def best_split(self, significance: float, unit: float) -> int | None:
        """The test that reduces the sum of squares most, if it passes the F-test; gains are judged in the unit of q."""
        if self.by_test.shape[2] == 0:
            return None
        count, total, squares = self.by_test[:, :, 0].sum(axis=0)
        n1, s1, _ = self.by_test[1]
        found = best_gain(s1, total, n1, count, n1, count, 1)
        around = squares - total**2 / count
        return found[0] if found and is_significant(found[1], around, int(count), significance, unit) else None


class TG:
    """The regressor."""

    def __init__(self, table: Table, refiner: Refiner, options: GrowthOptions):
        self.table = table
        self.tree = NumberedTree(table, refiner)
        self.options = options
        self.statistics = [self._statistics(0, np.zeros(3))]
        self.unit = 0.0  # the largest |q| met

    def _statistics(self, leaf: int, whole: np.ndarray) -> Statistics:
        deep = self.tree.depths[leaf] >= self.options.max_depth
        return Statistics(whole, 0 if deep else len(self.tree.candidates(leaf)))

    @property
    def width(self) -> int:
        return len(self.table)

    def describe(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        return self.table.answers(state, actions)

    def predict(self, descriptions: np.ndarray) -> np.ndarray:
        return np.array([each.mean for each in self.statistics])[self.tree.leaf_of(descriptions)]

    def update(self, examples: Sequence[Example]) -> None:
        """Each leaf that saw an example splits at most once."""
        answers = np.stack([each.description for each in examples])
        values = np.array([each.value for each in examples])
        self.unit = float(np.abs(values).max(initial=self.unit))
        coverage = Coverage(self.table, [each.state for each in examples], [each.action for each in examples], answers)
        leaves = self.tree.leaf_of(answers)
        for leaf in dict.fromkeys(leaves.tolist()):
            members = np.flatnonzero(leaves == leaf)
            statistics = self.statistics[leaf]
            candidates = self.tree.candidates(leaf)[: statistics.by_test.shape[2]]
            tested, _ = coverage.matrix(candidates, members, {})
            statistics.add(tested, values[members])
            if statistics.by_test[:, 0, :1].sum() >= self.options.min_sample:
                self._split(leaf, statistics)

    def _split(self, leaf: int, statistics: Statistics) -> None:
        best = statistics.best_split(self.options.significance, self.unit)
        if best is not None:
            new = self.tree.split(leaf, self.tree.candidates(leaf)[best])
            failed, passed = statistics.by_test[:, :, best].copy()
            self.statistics[leaf] = self._statistics(leaf, failed)
            self.statistics.append(self._statistics(new, passed))

    def sizes(self) -> dict[str, int]:
        return {"trees": 1, "leaves": len(self.tree)}

    def stored(self) -> tuple[Policy, list[tuple]]:
        policy = Policy(self.table.domain, self.table.bias, self.table)
        policy.add(self.tree.with_values(lambda leaf: self.statistics[leaf].mean))
        return policy, [("learner", self.options.learner)]

    def saved(self) -> dict[str, Any]:
        statistics = [[each.whole, each.by_test] for each in self.statistics]
        return {"tree": self.tree.saved(), "statistics": statistics, "unit": self.unit}

    def resume(self, saved: dict[str, Any]) -> None:
        self.tree.resume(saved["tree"])
        self.unit = saved["unit"]
        self.statistics = []
        for whole, by_test in saved["statistics"]:
            self.statistics.append(Statistics(whole, by_test.shape[2]))
            self.statistics[-1].by_test = by_test


def restored(policy: Policy, path: Path) -> Policy:
    """The value function of which a model file, read from `path`, has the tree: it takes the best action."""
    policy.greedy = True
    return policy
