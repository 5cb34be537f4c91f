"""A Q-function as a policy: its potentials are the Q that an incremental regressor predicts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol

import numpy as np

from nppg.answers.table import Table
from nppg.bridge.prolog import exclusively
from nppg.policy.gibbs import best, gibbs
from nppg.policy.policy import Policy
from nppg.rrl.options import QOptions
from nppg.worlds.world import Action, State


class Example(NamedTuple):
    """A state, an action in it, what the regressor has described them by, and the target."""

    state: State
    action: Action
    description: np.ndarray
    value: float


class Regressor(Protocol):
    """Learns Q(s, a) from a stream of examples."""

    table: Table

    @property
    def width(self) -> int:
        """The length of a description."""

    def describe(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        """All that the prediction depends on, a row for each action."""

    def predict(self, descriptions: np.ndarray) -> np.ndarray:
        """Q of each description, shape (pairs,)."""

    def update(self, examples: Sequence[Example]) -> None:
        """Learns from the examples of one episode."""

    def sizes(self) -> dict[str, int]:
        """What it consists of, with numbers."""

    def stored(self) -> tuple[Policy, list[tuple]]:
        """A policy of one tree, and facts that say with it what is predicted."""

    def saved(self) -> dict[str, Any]:
        """All that it has learned, to be stored."""

    def resume(self, saved: dict[str, Any]) -> None:
        """Goes on with that, in place of having learned nothing."""


@exclusively("answers", "potentials_of")
class QFunction(Policy):
    """Explores by its Q while it learns, and is greedy elsewhere."""

    greedy = True

    def __init__(self, regressor: Regressor, options: QOptions):
        super().__init__(regressor.table.domain, regressor.table.bias, regressor.table)
        self.regressor = regressor
        self.options = options
        self.temperature = options.temperature

    @property
    def width(self) -> int:
        return self.regressor.width

    def answers(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        return self.regressor.describe(state, actions)

    def potentials_of(self, answers: np.ndarray) -> np.ndarray:
        return self.regressor.predict(answers)

    def probabilities_of(self, potentials: np.ndarray) -> np.ndarray:
        if self.options.exploration == "boltzmann":
            return gibbs(potentials / self.temperature)
        highest = best(potentials)
        return self.options.epsilon / len(potentials) + (1 - self.options.epsilon) * highest / highest.sum()

    def sizes(self) -> dict[str, int]:
        return self.regressor.sizes()

    def stored(self) -> tuple[Policy, list[tuple]]:
        return self.regressor.stored()
