"""What episodes have found out about the ways to the goal: a graph of the states that they have met.

It is about worlds where an action has one outcome, so that what has been seen of it once is known.
"""

from __future__ import annotations

import math
from collections import defaultdict, deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nppg.errors import NppgError
from nppg.learning.episode import Episode
from nppg.worlds.state import Interpretation, Static, interpretation_of, static_of
from nppg.worlds.world import Action, State

DOUBT = 3  # visits of a state by which what is known of the ways from there counts half
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
    """The states of one problem that have been met, by number, their legal actions, which of these have been tried, and
    the distances to the goal as far as they are known."""

    def __init__(self) -> None:
        self.states: list[State] = []
        self.legal: list[Sequence[Action] | None] = []  # none where nobody has acted yet, or the state ends an episode
        self.tried: list[dict[Action, int]] = []  # in each state, with the state that the action leads to
        self.visits: list[int] = []  # in how many episodes each has been met
        self.distances: dict[int, int] = {}  # the steps of the shortest known way to the goal; without one: missing
        self.needed: dict[int, int] = {}  # the lengths of ways from states that were tried without their first steps
        self._numbers: dict[int, int] = {}
        self._before: dict[int, list[int]] = defaultdict(list)  # the states from which one is reached
        self._ends: set[int] = set()  # states in which episodes end
        self._dead: set[int] | None = None

    def number(self, state: Interpretation) -> int:
        """Of a state, a new one if it has not been met."""
        found = self._numbers.setdefault(state.fingerprint, len(self.states))
        if found == len(self.states):
            self.states.append(state)
            self.legal.append(None)
            self.tried.append({})
            self.visits.append(0)
        return found

    def lead(self, state: int, legal: Sequence[Action], action: Action, following: int) -> None:
        """Learns where one of the legal actions leads. Raises NppgError where it has led elsewhere."""
        self.legal[state] = legal
        if action not in self.tried[state]:
            self.tried[state][action] = following
            self._before[following].append(state)
            self._dead = None
            if following in self.distances:
                self._is_within(state, self.distances[following] + 1)
        elif self.tried[state][action] != following:
            what = " and to ".join(f"({self.states[each]})" for each in (self.tried[state][action], following))
            raise NppgError(f"self-imitation is for actions that have one outcome: from one state, one leads to {what}")

    def end(self, state: int, is_goal: bool) -> None:
        """Learns that a state ends episodes."""
        if state not in self._ends:
            self._ends.add(state)
            self._dead = None
            if is_goal:
                self._is_within(state, 0)

    def _is_within(self, state: int, distance: int) -> None:
        """Learns that a state has a way of so many steps, and what that says about those before it."""
        waiting = deque([(state, distance)])
        while waiting:
            state, distance = waiting.popleft()
            if distance < self.distances.get(state, math.inf):
                self.distances[state] = distance
                waiting.extend((each, distance + 1) for each in self._before[state])

    def distance(self, state: Interpretation) -> int | None:
        """That of a state, none where no way is known from it."""
        return self.distances.get(self._numbers.get(state.fingerprint, -1))

    def way(self, state: int) -> list[Action]:
        """The actions of one of the shortest known ways from a state to the goal."""
        found = []
        for left in range(self.distances[state] - 1, -1, -1):
            action, state = next(each for each in self.tried[state].items() if self.distances.get(each[1]) == left)
            found.append(action)
        return found

    @property
    def dead(self) -> set[int]:
        """The states from which no way leads to the goal: all but those from which a known way leads to a goal, or to a
        state where not all has been tried."""
        if self._dead is None:
            alive = set(self.distances)
            for state, (legal, tried) in enumerate(zip(self.legal, self.tried, strict=True)):
                if state not in self._ends and (legal is None or len(tried) < len(legal)):
                    alive.add(state)
            waiting = deque(alive)
            while waiting:
                for each in self._before.get(waiting.popleft(), ()):
                    if each not in alive:
                        alive.add(each)
                        waiting.append(each)
            self._dead = set(range(len(self.states))) - alive
        return self._dead

    def saved(self) -> dict[str, Any]:
        """All that is known, to be stored."""
        return {
            "states": self.states,
            "legal": self.legal,
            "tried": self.tried,
            "visits": self.visits,
            "distances": self.distances,
            "needed": self.needed,
            "before": dict(self._before),
            "ends": sorted(self._ends),
        }

    @staticmethod
    def resumed(saved: dict[str, Any]) -> Ways:
        """The ways of which that was stored."""
        ways = Ways()
        for name in ("states", "legal", "tried", "visits", "distances", "needed"):
            setattr(ways, name, saved[name])
        ways._before.update(saved["before"])
        ways._ends.update(saved["ends"])
        ways._numbers = {interpretation_of(state).fingerprint: at for at, state in enumerate(ways.states)}
        return ways

    def comparison(self, state: int, discount: float) -> Comparison | None:
        """Of what has been tried in a state, where some of it is known to be better than the rest. An action from which
        no way is known has return 0, another one discount^distance; how much that counts grows with the episodes that
        have seen where it leads."""
        tried, distances = self.tried[state], self.distances
        if len(tried) < 2 or state not in distances:
            return None
        far = {action: distances.get(following) for action, following in tried.items()}
        least = min(each for each in far.values() if each is not None)
        best = [action for action, each in far.items() if each == least]
        others = [action for action, each in far.items() if each != least]
        if not others:
            return None
        behind = [1.0 if (each := far[action]) is None else 1.0 - discount ** (each - least) for action in others]
        visits = np.array([np.inf if tried[action] in self.dead else self.visits[tried[action]] for action in others])
        losses = np.array(behind) / (1 + DOUBT / np.maximum(visits, 1))
        return Comparison(self.states[state], [*best, *others], len(best), losses)


class Experience:
    """The ways of all problems: of all states with the same static facts."""

    def __init__(self) -> None:
        self._ways: dict[Static, Ways] = {}  # the last ones that have been met come last

    def hear(self, episode: Episode) -> tuple[Ways, list[int]]:
        """Learns from an episode; the states that it has met, each once."""
        states = [*(step.actual for step in episode.steps), episode.actual]
        static = static_of(interpretation_of(states[0]))
        ways = self._ways.pop(static, None) or Ways()
        self._ways[static] = ways
        numbers = [ways.number(interpretation_of(state)) for state in states]
        for step, before, after in zip(episode.steps, numbers, numbers[1:], strict=False):
            ways.lead(before, step.actions, step.actions[step.chosen], after)
        if episode.success or not episode.open:
            ways.end(numbers[-1], episode.success)
        self._forget(ways)
        met = list(dict.fromkeys(numbers))
        for number in met:
            ways.visits[number] += 1
        return ways, met

    def draw(self, count: int, rng: np.random.Generator) -> list[tuple[Ways, int]]:
        """States met before: each problem of which some way is known is as likely as the others, then each state."""
        known = [ways for ways in self._ways.values() if ways.distances]
        if not known:
            return []
        chosen = [known[int(each * len(known))] for each in rng.random(count)]
        return [(ways, int(each * len(ways.states))) for ways, each in zip(chosen, rng.random(count), strict=True)]

    @property
    def size(self) -> int:
        """How many states are remembered."""
        return sum(len(ways.states) for ways in self._ways.values())

    def saved(self, others: Sequence[Ways]) -> tuple[dict[str, Any], list[int]]:
        """All of it, to be stored, with `others` that may have been forgotten; and which of the stored ways these
        are."""
        number = {ways: at for at, ways in enumerate(dict.fromkeys([*self._ways.values(), *others]))}
        statics = [static_of(interpretation_of(ways.states[0])) for ways in number]
        stored = {"statics": statics, "known": len(self._ways), "ways": [ways.saved() for ways in number]}
        return stored, [number[ways] for ways in others]

    def resume(self, saved: dict[str, Any]) -> list[Ways]:
        """Remembers that; all the ways that were stored."""
        ways = [Ways.resumed(each) for each in saved["ways"]]
        self._ways = dict(zip(saved["statics"][: saved["known"]], ways, strict=False))
        return ways

    def _forget(self, last: Ways) -> None:
        while self.size > MOST:
            oldest = next(iter(self._ways))
            if self._ways[oldest] is last:
                return
            del self._ways[oldest]


def pairs_of(comparisons: Sequence[Comparison]) -> list[tuple[State, list[Action]]]:
    """The states with the actions that are compared."""
    return [(each.state, each.actions) for each in comparisons]
