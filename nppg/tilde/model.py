"""What has been learned, and what it says of examples."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from nppg.answers.coverage import Coverage, table_of
from nppg.bias.language_bias import LanguageBias
from nppg.logic.query import Query
from nppg.tilde.knowledge import Indicator, Knowledge
from nppg.tilde.task import Example
from nppg.trees.tree import Leaf, Node, Tree, tests


@dataclass(frozen=True)
class Model:
    """Trees, and how they are put together. `rounds` has the trees of each round: one; or, where trees are added up
    (`learning_rate`), one for each output, scores that start from `offset`."""

    bias: LanguageBias  # with all its constants
    rounds: tuple[tuple[Tree, ...], ...]
    target: str
    classes: tuple[Hashable, ...] = ()  # none for numbers
    learning_rate: float | None = None
    offset: tuple[float, ...] = ()
    predicates: tuple[Indicator, ...] = ()  # that its tests are about

    @property
    def trees(self) -> list[Tree]:
        """All of them."""
        return [tree for trees in self.rounds for tree in trees]

    @property
    def tree(self) -> Tree:
        """The first."""
        return self.rounds[0][0]


class Passes:
    """Which of some examples pass the tests of trees, asked once for each test."""

    def __init__(self, knowledge: Knowledge, bias: LanguageBias, examples: Sequence[Example]):
        self._knowledge, self._bias = knowledge, bias
        self.states, self.actions = knowledge.states(examples), knowledge.actions(examples)
        self._known: dict[Query, np.ndarray] = {}

    def ask(self, trees: Iterable[Tree]) -> None:
        """Asks the tests of trees, those that are new."""
        wanted = dict.fromkeys(test for tree in trees for test in tests(tree))
        new = [test for test in wanted if test not in self._known]
        if not new:
            return
        table = table_of(new, self._knowledge.domain, self._bias)
        answers = Coverage(table, self.states, self.actions).bits
        for test in new:
            column, limit = table.place(test)
            own = answers[:, column]
            self._known[test] = own if own.dtype == bool else own <= limit

    def passes(self, node: Node, rows: np.ndarray) -> np.ndarray:
        """Which of the examples `rows` pass a node's test, of those that have been asked."""
        return np.logical_and.reduce([self._known[test][rows] for test in node.tests])

    def leaves(self, tree: Tree, rows: np.ndarray) -> list[tuple[Leaf, np.ndarray]]:
        """The leaves of a tree with those of the examples that come to them."""
        self.ask([tree])

        def reached(tree: Tree, rows: np.ndarray) -> list[tuple[Leaf, np.ndarray]]:
            if isinstance(tree, Leaf):
                return [(tree, rows)]
            passed = self.passes(tree, rows)
            return reached(tree.yes, rows[passed]) + reached(tree.no, rows[~passed])

        return reached(tree, rows)

    def outputs(self, model: Model, rows: np.ndarray) -> np.ndarray:
        """What a model says of the examples `rows`, shape (rows, outputs): the probability of each class, or values."""
        self.ask(model.trees)
        scores = [self._scores(trees, model, rows) for trees in model.rounds]
        if model.learning_rate is None:
            return np.mean(scores, axis=0)
        total = np.array(model.offset) + model.learning_rate * np.sum(scores, axis=0)
        return probabilities(total) if model.classes else total

    def _scores(self, trees: tuple[Tree, ...], model: Model, rows: np.ndarray) -> np.ndarray:
        if model.learning_rate is not None:
            return np.stack([self.values(tree, rows)[:, 0] for tree in trees], axis=1)
        values = self.values(trees[0], rows)
        return values / values.sum(axis=1, keepdims=True) if model.classes else values

    def values(self, tree: Tree, rows: np.ndarray) -> np.ndarray:
        """What a tree's leaves hold for the examples, shape (rows, values)."""
        places = np.empty(len(self.actions), np.intp)
        places[rows] = np.arange(len(rows))
        found = self.leaves(tree, rows)
        result = np.empty((len(rows), max(1, len(found[0][0].values))))
        for leaf, own in found:
            result[places[own]] = leaf.values or (leaf.value,)
        return result


def probabilities(scores: np.ndarray) -> np.ndarray:
    """Of the classes, by their scores, or of two by the second one's."""
    if scores.shape[1] == 1:
        scores = np.concatenate([np.zeros_like(scores), scores], axis=1)
    powers = np.exp(scores - scores.max(axis=1, keepdims=True))
    return powers / powers.sum(axis=1, keepdims=True)
