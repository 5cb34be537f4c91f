"""Domains as Gymnasium environments of fixed size, for any library's policies.

The observation has a row for each action that could be legal, its slot: the answers to the tests of a language bias,
so what a policy sees is relational whatever it is made of. The state's legal actions fill the first slots.
"""

from __future__ import annotations

import copy
import heapq
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from nppg.answers.coverage import root_table
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.bias.text import literal_text
from nppg.bridge.files import locate
from nppg.errors import NppgError, Problem
from nppg.gym_env.domain_env import DomainEnv, spaces
from nppg.learning.options import at_least
from nppg.worlds.domain import Domain
from nppg.worlds.opening import language_bias_of
from nppg.worlds.world import Action, State

_SEARCHES = ((1, 3000), (5, 200), (100, 20))  # starts, and actions taken from each: some searches deep, many wide


class BoundedEnv(DomainEnv):
    """A domain with `slots` actions, of which `info["action_mask"]` and action_masks() tell the legal ones.

    Observation: float32 of shape (slots, tests), for each legal action the answers to what `tests` lists: 1 or 0; where
    the language bias has thresholds, the number X that "X =< #" is about, -X for "X >= #", the least if there are many
    and 0 if there are none. All other rows are 0. `bias` is a language bias or its file, by default that of the
    domain's name. `slots` is by default what most_actions() finds; NppgError is raised where a state turns out to have
    more legal actions. Everything else is as in DomainEnv, but for the texts, which are left out.
    """

    def __init__(
        self,
        domain: str | Path,
        parameters: Mapping[str, int | float | str] | None = None,
        slots: int | None = None,
        bias: LanguageBias | str | Path | None = None,
        horizon_factor: float = 1.0,
        render_mode: str | None = None,
    ):
        super().__init__(domain, parameters, horizon_factor, render_mode)
        if slots is not None:
            slots = at_least("slots", slots, 1)
        if bias is None:
            bias = language_bias_of(self.domain)
        elif not isinstance(bias, LanguageBias):
            bias = LanguageBias.load(locate(bias, "language_bias", ".yaml"))
        if problems := bias.check(self.domain.predicates, self.domain.actions):
            raise NppgError(problems)
        self._table = root_table(self.domain, bias, Refiner(bias))
        if not len(self._table):
            raise NppgError([Problem(str(bias.file), 0, 0, "has no test that can be asked of an action by itself")])
        self.slots = most_actions(self.domain) if slots is None else slots
        highest = np.ones((self.slots, len(self._table)), np.float32)
        highest[:, self._table.bounds] = np.finfo(np.float32).max
        self.observation_space = spaces.Box(np.where(highest == 1, 0, -highest), highest, dtype=np.float32)
        self.action_space = spaces.Discrete(self.slots)

    def __deepcopy__(self, memo: dict) -> BoundedEnv:
        """With the same table, to which nothing is ever added."""
        twin = object.__new__(type(self))
        memo |= {id(self): twin, id(self._table): self._table}
        twin.__dict__.update(copy.deepcopy(self.__dict__, memo))
        return twin

    @property
    def tests(self) -> list[str]:
        """What each column answers, its variables named by letters: the action's arguments first, then the goal's."""
        bias = self._table.bias
        return [", ".join(literal_text(literal, bias) for literal in test) for test in self._table.tests]

    def action_masks(self) -> np.ndarray:
        """Which slots hold a legal action, booleans of shape (slots,)."""
        return np.arange(self.slots) < len(self.actions)

    def _observed(self) -> tuple[np.ndarray, dict[str, Any]]:
        if len(self.actions) > self.slots:
            message = f"a state has {len(self.actions)} legal actions and the environment slots={self.slots}: give more"
            raise NppgError([Problem(str(self.domain.path), 0, 0, message)])
        rows = np.zeros(self.observation_space.shape, np.float32)
        if self.actions:
            rows[: len(self.actions)] = self._rows()
        return rows, {**self._info(), "action_mask": self.action_masks().astype(np.int8)}

    def _rows(self) -> np.ndarray:
        """The table's answers, with 1 for what holds; float64 numbers stay within float32's range."""
        answers = self._table.answers(self.domain.observe(self.state, self.np_random), self.actions)
        if not self._table.numeric:
            return answers
        bounds = self._table.bounds
        numbers = 1 - answers
        numbers[:, bounds] = np.where(np.isinf(answers[:, bounds]), 0, answers[:, bounds])
        return np.clip(numbers, self.observation_space.low[0], self.observation_space.high[0])


def most_actions(domain: Domain) -> int:
    """The largest number of legal actions in a state that best-first searches find, from random starts, which follow
    states with many actions first. The same in every run; a large domain may have states with more."""
    if domain.environment:
        return len(Domain.situation(domain, ()).actions)  # what its file gives in every state, masked ones included
    rng = np.random.default_rng(0)
    return max(1, *(_most_from(domain, taken, rng) for starts, taken in _SEARCHES for _ in range(starts)))


def _most_from(domain: Domain, left: int, rng: np.random.Generator) -> int:
    """From one start, with about as many actions taken as are `left`."""
    counts: dict[State, int] = {}
    queue: list[tuple[int, int, State, Sequence[Action]]] = []

    def meet(state: State) -> None:
        if state not in counts:
            actions = domain.situation(state).actions
            counts[state] = len(actions)
            heapq.heappush(queue, (-len(actions), len(counts), state, actions))

    meet(domain.start(rng))
    while queue and left > 0:
        _, _, state, actions = heapq.heappop(queue)
        for action in actions:
            meet(domain.act(state, action, rng)[1])
        left -= len(actions)
    return max(counts.values())
