"""What an agent acts in, as an episode needs it: states, their situations, actions.

A fact or an action is a name, or a tuple of a name and its arguments: `on(a, b)` is `("on", "a", "b")`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np

from nppg.bridge.terms import Ground
from nppg.worlds.state import Interpretation

State = Sequence[Ground]  # facts in Prolog's standard order: an Interpretation, or a tuple
Action = Ground


class Situation(NamedTuple):
    """What a state is: `running`, `goal` or `terminal`; or `truncated`, where no further step may be taken though the
    task is not over, as an environment of Gymnasium may say. And its legal actions, none in a goal or terminal state.
    """

    status: str
    actions: Sequence[Action]


class Outcome(NamedTuple):
    """One of the states that an action may lead to."""

    probability: float
    state: State


class World(Protocol):
    """What an episode needs of a domain, as Domain documents it: nppg.worlds.gym_domain has it from an environment of
    Gymnasium in place of a domain file's predicates."""

    @property
    def has_observation(self) -> bool: ...

    def interpreted(self, state: State) -> Interpretation: ...

    def start(self, rng: np.random.Generator) -> State: ...

    def situation(self, state: State, lean: bool = False) -> Situation: ...

    def horizon(self, state: State) -> int: ...

    def observe(self, state: State, rng: np.random.Generator) -> State: ...

    def expert_actions(self, state: State) -> list[Action]: ...

    def act(
        self, state: State, action: Action, rng: np.random.Generator, lean: bool = False
    ) -> tuple[float, State]: ...

    def certain(self, state: State, action: Action) -> State | None: ...
