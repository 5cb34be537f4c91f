"""What episodes have found out about the ways to the goal: a graph of the states that they have met.

It is about worlds where an action has one outcome, so that what has been seen of it once is known.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from nppg.learning.episode import Episode
from nppg.worlds.state import Interpretation, interpretation_of, static_of
from nppg.worlds.world import Action, State

MOST = 200_000  # states that are remembered; beyond, the problems that have not been met for longest are forgotten


@dataclass(frozen=True, slots=True)
class Comparison:
    """Actions that have been tried in a state: first those that the shortest known ways to the goal begin with, `best`
    of them, then others. `losses`, shape (others,): the share of the best ones' return that they are behind."""

    state: State
    actions: list[Action]
    best: int
    losses: np.ndarray


class Ways:
    """The states of one problem that have been met, by number, the actions that have been tried there, and the
    distances to the goal as far as they are known."""

    def __init__(self) -> None:
        self.states: list[State] = []
        self.tried: list[dict[Action, int]] = []  # in each state, with the state that the action leads to
        self._numbers: dict[int, int] = {}
        self._goals: set[int] = set()
        self._distances: dict[int, int] | None = {}

    def number(self, state: Interpretation) -> int:
        """Of a state, a new one if it has not been met."""
        found = self._numbers.setdefault(state.fingerprint, len(self.states))
        if found == len(self.states):
            self.states.append(state)
            self.tried.append({})
        return found

    def lead(self, state: int, action: Action, following: int) -> None:
        """Learns where an action leads."""
        if action not in self.tried[state]:
            self.tried[state][action] = following
            self._distances = None

    def reach(self, goal: int) -> None:
        """Learns that the goal is reached in a state."""
        if goal not in self._goals:
            self._goals.add(goal)
            self._distances = None

    @property
    def distances(self) -> dict[int, int]:
        """The steps of the shortest known way to the goal, by state; those without one are missing."""
        if self._distances is None:
            before = defaultdict(list)
            for state, tried in enumerate(self.tried):
                for following in tried.values():
                    before[following].append(state)
            self._distances = dict.fromkeys(self._goals, 0)
            waiting = deque(self._goals)
            while waiting:
                state = waiting.popleft()
                for each in before[state]:
                    if each not in self._distances:
                        self._distances[each] = self._distances[state] + 1
                        waiting.append(each)
        return self._distances

    def comparison(self, state: int, discount: float) -> Comparison | None:
        """Of what has been tried in a state, where some of it is known to be better than the rest. An action from which
        no way is known has return 0, another one discount^distance."""
        tried, distances = self.tried[state], self.distances
        if len(tried) < 2 or state not in distances:
            return None
        far = {action: distances.get(following) for action, following in tried.items()}
        least = min(each for each in far.values() if each is not None)
        best = [action for action, each in far.items() if each == least]
        others = [action for action, each in far.items() if each != least]
        if not others:
            return None
        losses = [1.0 if far[each] is None else 1.0 - discount ** (far[each] - least) for each in others]  # type: ignore[operator]
        return Comparison(self.states[state], [*best, *others], len(best), np.array(losses))


class Experience:
    """The ways of all problems: of all states with the same static facts."""

    def __init__(self) -> None:
        self._ways: dict[int, Ways] = {}  # the last ones that have been met come last
        self._static: dict[int, object] = {}  # kept, so that no other one gets its place

    def hear(self, episode: Episode) -> tuple[Ways, list[int]]:
        """Learns from an episode; the states that it has met, each once."""
        states = [*(step.actual for step in episode.steps), episode.actual]
        static = static_of(interpretation_of(states[0]))
        ways = self._ways.pop(id(static), None) or Ways()
        self._ways[id(static)], self._static[id(static)] = ways, static
        numbers = [ways.number(interpretation_of(state)) for state in states]
        for step, before, after in zip(episode.steps, numbers, numbers[1:], strict=False):
            ways.lead(before, step.actions[step.chosen], after)
        if episode.success:
            ways.reach(numbers[-1])
        self._forget(ways)
        return ways, list(dict.fromkeys(numbers))

    def draw(self, count: int, rng: np.random.Generator) -> list[tuple[Ways, int]]:
        """States met before: each problem of which some way is known is as likely as the others, then each state."""
        known = [ways for ways in self._ways.values() if ways.distances]
        if not known:
            return []
        chosen = [known[int(each * len(known))] for each in rng.random(count)]
        return [(ways, int(each * len(ways.states))) for ways, each in zip(chosen, rng.random(count), strict=True)]

    def _forget(self, last: Ways) -> None:
        while sum(len(ways.states) for ways in self._ways.values()) > MOST:
            oldest = next(iter(self._ways))
            if self._ways[oldest] is last:
                return
            del self._ways[oldest], self._static[oldest]


def pairs_of(comparisons: Sequence[Comparison]) -> list[tuple[State, list[Action]]]:
    """The states with the actions that are compared."""
    return [(each.state, each.actions) for each in comparisons]
