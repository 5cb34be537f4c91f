"""The first-order distance of RIB between state-action pairs (Driessens and Ramon 2003).

Objects are known by what they are to the goal and to the action, not by their names. A *role* is an argument of the
goal template or of an action; an object that plays one is renamed to the first role that it plays, in the order goal,
action. Objects that are interchangeable and play no role all have the name of their kind, and constants keep theirs.
In a domain that declares nothing interchangeable, every argument that is no number counts as an object. The distance is

    mismatch * (roles whose labels differ, and 1 for another kind of action) + distance of the states,

the label of a role being the object's name or the constant, and roles of another kind of action being other roles;
states are sets of parts, which a domain may define by parts/1, compared as in matching.py. How large the paper's
penalty is, is unknown. A sum of metrics, this is one.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.terms import Ground, plain
from nppg.errors import NppgError
from nppg.logic.query import exact
from nppg.rrl.matching import PartSets, grown
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State


class PairDistance:
    """Numbers classes of state-action pairs that look alike, and gives the distances between them.

    What is interchangeable is looked up in each state, so that how a pair looks hangs on nothing that was met before.
    Raises NppgError where scipy is missing, or for a mismatch that is not above 0.
    """

    def __init__(self, domain: Domain, bias: LanguageBias, mismatch: float = 1.0):
        if not 0 < mismatch < np.inf:
            raise NppgError(f"the mismatch penalty must be above 0 and finite, not {mismatch}")
        self.domain = domain
        self.goal = bias.goal
        self.mismatch = mismatch
        self._sets = PartSets()
        self._kinds: dict[Ground, str] = {}  # of the objects that are interchangeable in the state that is described
        self._symbols: dict[object, int] = {}
        self._classes: dict[tuple[int, ...], int] = {}
        self._set_of = np.zeros(0, np.int64)  # of each class: its set of parts, and the labels of its roles
        self._labels = np.zeros((0, 0), np.int64)
        self._examples: list[tuple[State, Action]] = []

    def __len__(self) -> int:
        """How many classes have been met."""
        return len(self._classes)

    def example(self, number: int) -> tuple[State, Action]:
        """The pair that a class was met with first."""
        return self._examples[number]

    # -------------------------------------------------- classes

    def describe(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        """The number of each action's class, shape (actions,)."""
        self._kinds = self.domain.kinds(state)
        parts = self.domain.parts(state)
        goal: tuple[Ground, ...] = ()
        if self.goal:
            arity = len(self.goal.types)
            goal = self.domain.binding(state, self.goal.name, arity)
            if not self.domain.has_parts:
                parts = tuple(part for part in parts if (part[0], len(part) - 1) != (self.goal.name, arity))
        names: dict[Ground, int] = {}
        self._name(None, goal, names)
        labels = tuple([self._symbol(each, names) for each in goal])
        symbols = [tuple([self._symbol(each, names) for each in part]) for part in parts]
        inside: dict[Ground, list[int]] = {}  # the parts that a term is in
        for i, part in enumerate(parts):
            for each in _terms(part):
                inside.setdefault(each, []).append(i)
        numbers = []
        for action in plain(actions):
            kind, args = self._kind(action)
            own = names.copy()
            self._name(kind, args, own)
            renamed = symbols.copy()
            for i in {i for each in own.keys() - names.keys() for i in inside.get(each, ())}:
                renamed[i] = tuple([self._symbol(each, own) for each in parts[i]])
            key = (self._sets.number(renamed), kind, *labels, *[self._symbol(each, own) for each in args])
            numbers.append(self._class(key, state, action))
        return np.array(numbers, np.int64)

    def _kind(self, action: Action) -> tuple[int, tuple[Ground, ...]]:
        """The number of a kind of actions, and the action's arguments."""
        name, *args = action if isinstance(action, tuple) else (action,)
        return self._number((None, name, len(args))), tuple(args)

    def _name(self, owner: int | None, values: tuple[Ground, ...], names: dict[Ground, int]) -> None:
        """Gives those objects names that play roles for the first time."""
        for i, each in enumerate(values):
            if each not in names and self._is_object(each):
                names[each] = self._number((None, owner, i, None))

    def _class(self, key: tuple[int, ...], state: State, action: Action) -> int:
        """The number of the class that has this set of parts and these labels."""
        number, *labels = key
        found = self._classes.setdefault(key, len(self._classes))
        if found == len(self._examples):
            self._examples.append((state, action))
            self._set_of = grown(self._set_of, found + 1)
            self._set_of[found] = number
            self._labels = grown(self._labels, found + 1, len(labels))
            self._labels[found, : len(labels)] = labels
        return found

    def _is_object(self, term: Ground) -> bool:
        return term in self._kinds if self.domain.interchangeable else not isinstance(term, int | float)

    def _symbol(self, term: Ground, names: dict[Ground, int]) -> int:
        if term in names:
            return names[term]
        if isinstance(term, tuple):
            return self._number((term[0], *(self._symbol(arg, names) for arg in term[1:])))
        if term in self._kinds:
            return self._number((None, self._kinds[term]))
        return self._number((None, exact(term)) if isinstance(term, float) else term)

    def _number(self, item: object) -> int:
        """Numbers what parts and labels are made of, from 1: constants and, as tuples, compounds, which begin with a
        string, and names of nppg's own, which begin with None."""
        return self._symbols.setdefault(item, len(self._symbols) + 1)

    # -------------------------------------------------- distances

    def rows(self, pairs: np.ndarray, others: np.ndarray) -> np.ndarray:
        """The distances of classes, by their numbers, from others; float64, shape (pairs, others)."""
        sets, row = np.unique(self._set_of[pairs], return_inverse=True)  # actions that leave a state's parts alike
        distances = self._sets.distances(sets, self._set_of[others])[row].astype(float)
        for role in range(self._labels.shape[1]):
            distances += self.mismatch * (self._labels[pairs, role, None] != self._labels[others, role])
        return distances


def _terms(term: Ground) -> set[Ground]:
    """A term, and what stands in it."""
    return {term}.union(*map(_terms, term)) if isinstance(term, tuple) else {term}
