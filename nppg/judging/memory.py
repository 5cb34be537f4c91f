"""What an evaluation has met before and does not hang on the policy, so that it is not asked again.

States that are met again are the same object. With each is remembered what Prolog has said of it: its situation, its
horizon, where its actions lead if no number was drawn for that, and the answers to the tests. A start state is
remembered with the state of the generator that it was drawn from, and leaves it as drawing did. So an episode is to the
bit what it would be without memory.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from nppg.policy.policy import Policy, Scores
from nppg.worlds.domain import Domain
from nppg.worlds.state import Interpretation, interpretation_of
from nppg.worlds.world import Action, Situation, State

_BYTES = 100_000_000  # about as much is remembered; what goes beyond it makes memory begin anew
_OWN = 1500  # of these, what a remembered thing takes by itself
_ACTION = 200  # and what each of its actions does


class _Place:
    """A state, and what is known of it."""

    __slots__ = ("answers", "by", "edges", "horizon", "scores", "situation", "state")

    def __init__(self, state: Interpretation):
        self.state = state
        self.situation: Situation | None = None
        self.horizon: int | None = None
        self.edges: dict[Action, tuple[float, State]] = {}
        self.answers: np.ndarray | None = None
        self.scores: Scores | None = None
        self.by: object = None  # whose scores these are


class Memory:
    """Of the states of one domain, and of the answers to the tests of one policy, whatever trees are added to it. It
    stands for the domain in an episode."""

    has_observation = False

    def __init__(self, domain: Domain):
        self.domain = domain
        self._forget()

    @staticmethod
    def suits(domain: Domain) -> bool:
        """Whether what a domain says of a state hangs on nothing else: policies see states as they are, and there is no
        environment of Gymnasium behind it."""
        return not (domain.has_observation or domain.environment)

    def _forget(self) -> None:
        # by fingerprint and identity of the static facts, and by that of the state: places keep both
        self._places: dict[tuple[int, int], _Place] = {}
        self._of: dict[int, _Place] = {}
        self._starts: dict[tuple[int, int], tuple[State, dict[str, Any]]] = {}
        self._size = 0

    def _place(self, state: State) -> _Place:
        found = self._of.get(id(state))
        if found is None:
            own = self.domain.interpreted(state)
            key = own.fingerprint, id(own.static)
            found = self._places.get(key)
            if found is None:
                found = self._places[key] = self._of[id(own)] = _Place(own)
                self._size += _OWN
        return found

    def _begun(self, state: State) -> State:
        """A start state; between episodes memory can end."""
        if self._size > _BYTES:
            self._forget()
        return self._place(state).state

    def problem(self, number: int) -> State:
        """The start state of a problem."""
        return self._begun(self.domain.problem(number))

    def start(self, rng: np.random.Generator) -> State:
        inner = rng.bit_generator.state["state"]  # of the PCG64 that NumPy's default generator is
        key = inner["state"], inner["inc"]
        found = self._starts.get(key)
        if found is None:
            state = self._begun(self.domain.start(rng))
            self._starts[key] = state, rng.bit_generator.state  # type: ignore[assignment]
            self._size += _OWN
            return state
        rng.bit_generator.state = found[1]
        return found[0]

    def situation(self, state: State, lean: bool = False) -> Situation:
        place = self._place(state)
        if place.situation is None:
            place.situation = self.domain.situation(place.state)
            self._size += _ACTION * len(place.situation.actions)
        return place.situation

    def horizon(self, state: State) -> int:
        place = self._place(state)
        if place.horizon is None:
            place.horizon = self.domain.horizon(place.state)
        return place.horizon

    def observe(self, state: State, rng: np.random.Generator) -> State:
        return state

    def interpreted(self, state: State) -> Interpretation:
        return interpretation_of(state)

    def expert_actions(self, state: State) -> list[Action]:
        return self.domain.expert_actions(state)

    def act(self, state: State, action: Action, rng: np.random.Generator, lean: bool = False) -> tuple[float, State]:
        place = self._place(state)
        edge = place.edges.get(action)
        if edge is None:
            before = rng.bit_generator.state
            reward, following = self.domain.act(place.state, action, rng)
            edge = reward, self._place(following).state
            if rng.bit_generator.state == before:
                place.edges[action] = edge
        return edge

    def certain(self, state: State, action: Action) -> State | None:
        return self.domain.certain(state, action)

    def scores(self, policy: Policy, by: object, state: State, actions: Sequence[Action]) -> Scores:
        """Of a state's legal actions, those that `by` has been told before."""
        place = self._place(state)
        if place.scores is None or place.by is not by:
            answers = place.answers
            if answers is None or answers.shape[1:] != (policy.width,):
                place.answers = answers = policy.answers(place.state, actions)
                self._size += answers.nbytes
            place.scores, place.by = policy.scored(answers), by
        return place.scores


class Remembering:
    """A policy as it is, in its domain as it is remembered: a Player."""

    is_rules = False  # all actions are scored

    def __init__(self, policy: Policy, memory: Memory):
        self.policy = policy
        self.domain = memory
        self.greedy = policy.greedy

    def scores(self, state: State, actions: Sequence[Action]) -> Scores:
        return self.domain.scores(self.policy, self, state, actions)

    def prefer(self, state: State, rng: np.random.Generator) -> Action:
        return self.policy.prefer(state, rng)
