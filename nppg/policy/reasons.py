"""Why a policy does what it does: what the rules of its trees say of each action, and what would have to be otherwise.

A leaf of a tree is a rule, and is known by its number in the order of the tree's rules, from 0. Rules of several trees
that say the same of the same actions are told together, with the sum of what they give.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND
from nppg.bridge.prolog import ask
from nppg.logic.query import Query
from nppg.policy.gibbs import best
from nppg.policy.model import Writable
from nppg.policy.sentences import phrases
from nppg.trees.tree import Leaf, Tree, leaves, tests

_RIVALS = 3  # actions that it is told of what would have to change for them
_CHANGES = 4  # that are told for each


class Place(Protocol):
    """Where a row of answers has that of a test: the column, and its limit if answers are numbers."""

    def __call__(self, test: Query) -> tuple[int, float]: ...


class Rule(NamedTuple):
    """A rule as people read it: the action and the conditions as Prolog prints them, and in words."""

    head: str
    body: tuple[str, ...]
    words: str

    def __str__(self) -> str:
        return f"{self.head} :- {', '.join(self.body)}" if self.body else self.head


class Said(NamedTuple):
    """What a rule, of so many trees, gives to an action's potential."""

    rule: Rule
    value: float
    trees: int


class Change(NamedTuple):
    """One test of one action, by number, that would make another action the best if its answer were the other one."""

    action: int
    test: Query
    holds: bool
    best: int


class Reasons:
    """The rules of a policy's trees, in the words of `bias`, and which of them decide for a row of answers."""

    def __init__(self, policy: Writable, place: Place, bias: LanguageBias):
        self._walks = [_walk(tree, place) for tree in policy.trees]
        self.rules: list[Rule] = []  # each once
        self.numbers: list[list[int]] = []  # of the rules of each tree
        self.values: list[list[float]] = []  # that they give
        self._leaves: dict[bytes, list[int]] = {}
        self._place = place
        self._tests = list(dict.fromkeys(test for tree in policy.trees for test in tests(tree)))
        known: dict[Rule, int] = {}
        for number in range(1, len(policy.trees) + 1):
            parts = ask("parts", policy.name, number)
            own = []
            for (action, literals, _), words in zip(parts, phrases(policy, parts, bias), strict=True):
                head = str(action[2]) if action else "any action"
                own.append(Rule(head, tuple(str(literal[2]) for literal in literals), words))
            self.numbers.append([known.setdefault(rule, len(known)) for rule in own])
            self.values.append([value for *_, value in parts])
        self.rules = list(known)

    def leaves(self, row: np.ndarray) -> list[int]:
        """The rule of each tree that decides for a pair with these answers."""
        key = row.tobytes()
        if key not in self._leaves:
            self._leaves[key] = [walk(row) for walk in self._walks]
        return self._leaves[key]

    def summed(self, row: np.ndarray) -> dict[int, tuple[float, int]]:
        """What each rule that decides gives in all, and in how many trees, by its number in `rules`."""
        found: dict[int, tuple[float, int]] = {}
        for numbers, values, leaf in zip(self.numbers, self.values, self.leaves(row), strict=True):
            value, trees = found.get(numbers[leaf], (0.0, 0))
            found[numbers[leaf]] = value + values[leaf], trees + 1
        return found

    def said(self, row: np.ndarray) -> list[Said]:
        """The same, the weightiest first."""
        found = [Said(self.rules[rule], *given) for rule, given in self.summed(row).items()]
        return sorted(found, key=lambda said: -abs(said.value))

    def changes(self, answers: np.ndarray, potentials_of: Callable[[np.ndarray], np.ndarray]) -> list[Change]:
        """Single answers about the best action, or about one of its rivals, that would make the rival the best. Tests
        of what an action is, which cannot change, are left out; those that bring a rival furthest ahead come first."""
        potentials = potentials_of(answers)
        order = np.argsort(-potentials, kind="stable")
        first, rivals = int(order[0]), [int(i) for i in order if not best(potentials)[i]][:_RIVALS]
        asked = [test for test in self._tests if all(literal.name not in ("=", KIND) for literal in test)]
        found = []
        for rival in rivals:
            own: list[tuple[float, Change]] = []
            for number in (first, rival):
                rows, holds = _flipped(answers[number], [self._place(test) for test in asked])
                changed = potentials_of(rows) if len(rows) else np.empty(0)
                for test, held, value in zip(asked, holds, changed.tolist(), strict=True):
                    other = potentials.copy()
                    other[number] = value
                    if best(other)[rival] and not best(other)[first]:
                        own.append((other[rival] - other[first], Change(number, test, held, rival)))
            found += [change for _, change in sorted(own, key=lambda each: -each[0])[:_CHANGES]]
        return found


def _walk(tree: Tree, place: Place) -> Callable[[np.ndarray], int]:
    """What finds the leaf of a row of answers."""
    if isinstance(tree, Leaf):
        return lambda row: 0
    asked = [place(test) for test in tree.tests]
    yes, no, ahead = _walk(tree.yes, place), _walk(tree.no, place), leaves(tree.yes)

    def walk(row: np.ndarray) -> int:
        if all(_holds(row, column, limit) for column, limit in asked):
            return yes(row)
        return ahead + no(row)

    return walk


def _holds(row: np.ndarray, column: int, limit: float) -> bool:
    return bool(row[column] if row.dtype == bool else row[column] <= limit)


def _flipped(row: np.ndarray, places: Sequence[tuple[int, float]]) -> tuple[np.ndarray, list[bool]]:
    """The row with one answer turned into the other, for each of these, and whether each test holds as it is."""
    rows, holds = np.repeat(row[None], len(places), axis=0), []
    for other, (column, limit) in zip(rows, places, strict=True):
        held = _holds(row, column, limit)
        other[column] = not held if row.dtype == bool else np.nextafter(limit, np.inf) if held else limit
        holds.append(held)
    return rows, holds


