"""What the actions of an episode were worth: its returns, or advantages over a value function that is learned."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Protocol

import numpy as np

from nppg.bias.declarations import Template
from nppg.bias.language_bias import LanguageBias
from nppg.learning.episode import Episode
from nppg.learning.gradient import advantages, returns
from nppg.learning.options import Options
from nppg.learning.regressors import Examples, regressor
from nppg.learning.visits import Visit
from nppg.policy.policy import Policy
from nppg.trees.tilde import size_of
from nppg.trees.tree import Tree
from nppg.worlds.domain import Domain
from nppg.worlds.world import State

STATE = "state"  # the one action that the value function's trees are about, so that they are about states


class Critic(Protocol):
    """Judges episodes."""

    def visits(self, episode: Episode) -> list[Visit]:
        """All steps of an episode, each with its value."""

    def learn(self, visits: Sequence[Visit]) -> None:
        """Learns from visits, all of which it has judged since it learned last."""

    def saved(self) -> Any:
        """What it has learned, to be stored."""

    def resume(self, saved: Any) -> None:
        """Has learned that."""


class MonteCarlo:
    """Values are returns: there is no critic."""

    def __init__(self, options: Options):
        self.options = options

    def visits(self, episode: Episode) -> list[Visit]:
        return _visits(episode, returns([step.reward for step in episode.steps], self.options.discount))

    def learn(self, visits: Sequence[Visit]) -> None:
        pass

    def saved(self) -> None:
        pass

    def resume(self, saved: None) -> None:
        pass


class ValueFunction:
    """V(s), a sum of regression trees that descends the squared error as the policy's potential climbs the return: each
    tree fits what is left between V and its targets, advantage + V, and is multiplied by `critic_step_size`.

    Its trees test what the policy's language bias allows without an action: the goal's objects and new variables."""

    def __init__(self, domain: Domain, bias: LanguageBias, options: Options):
        states = replace(bias, actions=(Template(STATE, ()),))
        self.options = options
        self.regressor = regressor(domain, states, options)
        self.trees = Policy(domain, states, self.regressor.table)

    def __call__(self, states: Sequence[State]) -> np.ndarray:
        """V of each state, shape (states,)."""
        return self.trees.potentials_of(self._answers(states))

    def _answers(self, states: Sequence[State]) -> np.ndarray:
        return np.concatenate([self.trees.answers(state, [STATE]) for state in states])

    def visits(self, episode: Episode) -> list[Visit]:
        """With generalised advantage estimation. Nothing follows a goal or terminal state, nor, unless `cut_off` says
        so, where an episode was cut off."""
        if not episode.steps:
            return []
        *values, last = self([*(step.state for step in episode.steps), episode.last]).tolist()
        rewards = [step.reward for step in episode.steps]
        follows = episode.open and self.options.cut_off == "bootstrap"
        found = advantages(rewards, values, last if follows else 0.0, self.options.discount, self.options.trace)
        return _visits(episode, found)

    def learn(self, visits: Sequence[Visit]) -> None:
        """From the policy's own steps: V is its value, not the expert's."""
        own = [visit for visit in visits if not visit.guided]
        if not own:
            return
        states = [visit.step.state for visit in own]
        targets = np.array([visit.value for visit in own]) + self(states)
        unit = size_of(targets)
        for _ in range(self.options.critic_trees):
            answers = self._answers(states)
            residuals = targets - self.trees.potentials_of(answers)
            tree = self.regressor.fit(Examples(states, [STATE] * len(states), answers, residuals, unit=unit))
            self.trees.add(tree, self.options.critic_step_size)

    def saved(self) -> list[Tree]:
        return list(self.trees.trees)

    def resume(self, saved: list[Tree]) -> None:
        for tree in saved:
            self.trees.add(tree)


def critic(domain: Domain, bias: LanguageBias, options: Options) -> Critic:
    """The one that the options ask for."""
    return ValueFunction(domain, bias, options) if options.critic == "value" else MonteCarlo(options)


def _visits(episode: Episode, values: np.ndarray) -> list[Visit]:
    last = max((t for t, step in enumerate(episode.steps) if step.guided), default=-1)
    return [
        Visit(step, value, t <= last)
        for t, (step, value) in enumerate(zip(episode.steps, values.tolist(), strict=True))
    ]
