"""An expert that nobody wrote: the optimal actions of problems that have few states."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from typing import Generic, TypeVar

import numpy as np

from nppg.errors import NppgError
from nppg.judging.reachable import Reachable, TooMany
from nppg.worlds.domain import Domain
from nppg.worlds.state import Interpretation, Static
from nppg.worlds.world import Action, State

LIMIT = 10_000  # states of a problem that are gone through
_FAILURES = 5  # drawn starts with more states, after which others are not tried
_ALIKE = 1e-6  # expected numbers of steps this near to each other are equal
_CONVERGED = 1e-10

Value = TypeVar("Value")


class ByState(Generic[Value]):
    """What is known of states, by their fingerprints, for each set of static facts."""

    def __init__(self) -> None:
        self._of: list[tuple[Static, dict[int, Value]]] = []
        self._last: tuple[Static, dict[int, Value]] | None = None

    def about(self, static: Static) -> dict[int, Value]:
        """What is known of the states that have these static facts, to be added to."""
        if self._last is None or self._last[0] is not static:
            known = next((known for own, known in self._of if own == static), None)
            if known is None:
                known = {}
                self._of.append((static, known))
            self._last = static, known
        return self._last[1]


class OptimalExpert:
    """Gives all actions of a state that lead to a goal state in the fewest steps. Costs are not looked at, as they are
    not in learning. Where outcomes are left to chance it is the expected number of steps, and where that is more than
    the horizon of the start, or where there is no way to the goal, that counts as the horizon: Bonet's and Geffner's
    equations, with the finite penalty for dead ends of Kolobov, Mausam and Weld (2012).

    All states that can be reached from a start are gone through. Those of the problems that the domain's starts are
    drawn from at once, the smallest first: there is no advice on a problem of more than `limit` states, nor on one that
    has at least as many facts of either kind; on how many there is, is told by a warning. Starts that the domain draws
    are looked at when they are met. Raises NppgError where the domain has no goal, or as Reachable does."""

    def __init__(self, domain: Domain, limit: int = LIMIT):
        if not domain.has_goal:
            raise NppgError(f"{domain.path}: an optimal expert needs goal/0, which the domain does not define")
        self.domain = domain
        self.limit = limit
        self._known: ByState[list[Action]] = ByState()
        self._too_large: list[tuple[int, int]] = []
        starts = sorted((domain.interpreted(domain.problem(each)) for each in domain.chosen), key=_size)
        self.advised = sum([self._learn(start) for start in starts])
        if self.advised < len(starts):
            warnings.warn(
                f"the optimal expert advises on {self.advised} of {len(starts)} problems: the others have more than "
                f"{limit:,} states, or are larger than ones that have; there the policy acts",
                stacklevel=2,
            )

    def __reduce__(self) -> tuple:
        """Fingerprints are those of a process."""
        return _again, (self.domain, self.limit)

    def __call__(self, state: State) -> list[Action]:
        state = self.domain.interpreted(state)
        known = self._known.about(state.static)
        is_new = state.fingerprint not in known and not self.domain.chosen and len(self._too_large) < _FAILURES
        if is_new and not self._learn(state):
            message = f"there are starts with more than {self.limit:,} states: the optimal expert has no advice there"
            warnings.warn(message, stacklevel=2)
        return known.get(state.fingerprint, [])

    def _learn(self, start: Interpretation) -> bool:
        """Whether the problem of this start is small enough."""
        facts, static = _size(start)[1:]
        if any(facts >= own and static >= other for own, other in self._too_large):
            return False
        try:
            graph = Reachable(self.domain, start, self.limit)
        except TooMany:
            self._too_large.append((facts, static))
            return False
        known = self._known.about(start.static)
        known.update((state.fingerprint, []) for state in graph.states)
        for state, action in optimal_pairs(graph, self.domain.horizon(start)):
            known[graph.states[state].fingerprint].append(action)
        return True


def _again(domain: Domain, limit: int) -> OptimalExpert:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        return OptimalExpert(domain, limit)


def _size(start: Interpretation) -> tuple[int, int, int]:
    facts, static = len(start.facts), len(start.static.facts)
    return facts + static, facts, static


def optimal_pairs(graph: Reachable, penalty: float) -> Iterator[tuple[int, Action]]:
    """The states from which the goal can be reached, each with its optimal actions, as OptimalExpert has them."""
    if graph.is_certain:
        left: np.ndarray = graph.distances().astype(float)
        left[left < 0] = np.inf
        after = left[graph.target]
        there = np.isfinite(left)
    else:
        left, after = _expected(graph, penalty)
        there = left < penalty - _ALIKE
    optimal = there[graph.owner] & (after <= left[graph.owner] - 1 + _ALIKE)
    for pair in np.flatnonzero(optimal).tolist():
        yield int(graph.owner[pair]), graph.actions[pair]


def _expected(graph: Reachable, penalty: float) -> tuple[np.ndarray, np.ndarray]:
    """The least expected number of steps from each state, at most `penalty`, and that after each pair: by value
    iteration from 0, which comes to it from below."""
    steps = np.where(graph.goal | graph.running, 0.0, penalty)
    first = np.flatnonzero(np.diff(graph.owner, prepend=-1))
    while True:
        after = np.bincount(graph.origin, graph.weight * steps[graph.target], len(graph.owner))
        new = steps.copy()
        new[graph.running] = np.minimum(1 + np.minimum.reduceat(after, first), penalty) if len(first) else 0
        if np.abs(new - steps).max() < _CONVERGED:
            return new, after
        steps = new
