"""The states that can be reached from one start, each once, and what leads from one to another.

Nothing is promised of the domain: its facts may be static, its start any state. States are the same where their facts
are, by their fingerprints of 64 bits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from nppg.errors import NppgError
from nppg.worlds.domain import Domain
from nppg.worlds.state import Interpretation
from nppg.worlds.world import Action, State

LIMIT = 200_000
Choice = Callable[[State, Sequence[Action]], Sequence[Action]]  # some of the legal actions of a running state


class TooMany(NppgError):
    """There are more states than were to be looked at."""


class Reachable:
    """The states in the order in which they are found, breadth first: `states` and `status` have an entry for each,
    `running` says which have actions. The pairs of a running state and an action that leads on from it are numbered
    through: `owner` is the state of each, `actions` its action. An outcome leads from the pair `origin` to the state
    `target` with probability `weight`. `parents` has for each state but the first an outcome that first led there.

    All legal actions lead on, or those that `choice` gives, which is asked about each running state while that is
    current; if it needs no legal actions for that, it may be `lean`. Raises TooMany where there are more than `limit`
    states, and NppgError where the domain defines observation/1 or is an environment of Gymnasium.
    """

    def __init__(
        self, domain: Domain, start: State, limit: int = LIMIT, choice: Choice | None = None, lean: bool = False
    ):
        if domain.has_observation or domain.environment:
            what = "policies see what observation/1 draws" if domain.has_observation else "it is one of Gymnasium"
            raise NppgError(f"{domain.path}: its states cannot be gone through, for {what}; evaluate on samples")
        self.domain = domain
        self.states: list[Interpretation] = [domain.interpreted(start)]
        self.status: list[str] = []
        self.actions: list[Action] = []
        self.parents = [-1]
        number = {self.states[0].fingerprint: 0}
        owner: list[int] = []
        origin: list[int] = []
        target: list[int] = []
        weight: list[float] = []
        for here, state in enumerate(self.states):
            status, legal = domain.situation(state, lean)
            self.status.append(status)
            if status != "running":
                continue
            actions = list(legal if choice is None else choice(state, legal))
            for action, outcomes in zip(actions, domain.outcomes(state, actions), strict=True):
                for probability, successor in outcomes:
                    assert isinstance(successor, Interpretation)
                    there = number.setdefault(successor.fingerprint, len(self.states))
                    if there == len(self.states):
                        if there == limit:
                            raise TooMany(f"more than {limit:,} states can be reached")
                        self.states.append(successor)
                        self.parents.append(len(target))
                    origin.append(len(owner))
                    target.append(there)
                    weight.append(probability)
                owner.append(here)
                self.actions.append(action)
        self.running = np.array([each == "running" for each in self.status])
        self.goal = np.array([each == "goal" for each in self.status])
        self.owner, self.origin, self.target = (np.array(each, int) for each in (owner, origin, target))
        self.weight = np.array(weight)

    @property
    def source(self) -> np.ndarray:
        """The state that each outcome leads from."""
        return self.owner[self.origin]

    @property
    def is_certain(self) -> bool:
        """Whether every action has one outcome."""
        return len(self.origin) == len(self.owner)

    def distances(self) -> np.ndarray:
        """The least number of steps to a goal state, with luck where outcomes are left to chance; -1 where there is no
        way."""
        source, found = self.source, np.where(self.goal, 0, -1)
        steps, near = 0, self.goal
        while near.any():
            steps += 1
            near = np.bincount(source, near[self.target], len(found)).astype(bool) & (found < 0)
            found[near] = steps
        return found

    def longest(self, taken: np.ndarray) -> np.ndarray:
        """The most steps that it can take to a goal state if any of the pairs `taken` may be taken, whatever happens;
        -1 where the goal can be missed, by a state without a way on or by going round in a loop."""
        possible = taken[self.origin]
        source, target = self.source[possible], self.target[possible]
        found, steps = np.where(self.goal, 0, -1), 0
        while True:
            steps += 1
            missing = np.bincount(source, found[target] < 0, len(found)) > 0
            new = self.running & ~missing & (found < 0)
            if not new.any():
                return found
            found[new] = steps

    def way_to(self, state: int) -> list[int]:
        """The outcomes by which a state was first reached, from the start on."""
        way = []
        while (outcome := self.parents[state]) >= 0:
            way.append(outcome)
            state = int(self.owner[self.origin[outcome]])
        return way[::-1]
