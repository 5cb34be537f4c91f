"""TREENPPG: Algorithm 1 of Kersting and Driessens (2008)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.learning.courses import course_of
from nppg.learning.curriculum import curriculum_of
from nppg.learning.episode import Episode, Expert
from nppg.learning.options import Options
from nppg.learning.rollouts import are_many, iterations_episodes, training_episodes
from nppg.policy.policy import Policy
from nppg.trees.tree import leaves
from nppg.worlds.domain import Domain


@dataclass(frozen=True, slots=True)
class Iteration:
    """The policy after one more tree; `episodes` counts all so far, `recent` are those since the last tree. `stage`:
    how far the curriculum is, where there is one."""

    policy: Policy
    episodes: int
    recent: tuple[Episode, ...]
    stage: str = ""


def wanted(trees: int, options: Options) -> float:
    """More examples than this are gathered for the tree that follows so many: min_examples (1 + growth trees)."""
    return options.min_examples + options.min_examples * options.examples_growth * trees


class Training:
    """A training run as it goes on. Between two episodes all that it hangs on can be stored, and gone on with by
    another one that was made of the same domain, bias and options, with the same numbers.

    A policy asks what its trees test. It shares the learner's table where trees are grown from the answers that its
    steps have: not where the table is large, or in self-imitation."""

    def __init__(
        self,
        domain: Domain,
        bias: LanguageBias,
        options: Options | None = None,
        jobs: int = 1,
        expert: Expert | None = None,
    ):
        self.options = options or Options()
        self.course = course_of(domain, bias, self.options)
        self.policy = Policy(domain, bias, self.course.table)
        self.curriculum = curriculum_of(domain) if self.options.curriculum == "yes" else None
        self.recent: list[Episode] = []
        self.is_settled = True  # whether `saved` can tell what it is: not while it learns from what it has heard
        if are_many(self.options):
            self._watched = iterations_episodes(self.policy, self.options, jobs, self.curriculum, expert)
        else:
            rng = np.random.default_rng(self.options.seed)
            self._watched = training_episodes(self.policy, rng, self.options, self.curriculum, expert)

    @property
    def count(self) -> int:
        """The episodes so far."""
        return self._watched.count

    def iterations(self, is_over: Callable[[], bool] = lambda: False) -> Iterator[Iteration]:
        """See `train`. A run that is gone on with begins with what comes of its last episode."""
        if self.count == 0:
            yield self._iteration()
        with self._watched as episodes:
            if self.count == 0 and not self._hears(episodes):
                return
            while True:
                last = is_over() or self.count == self.options.episodes
                gathered = self.course.gathered
                enough = gathered > wanted(len(self.policy.trees), self.options)
                if last or (enough and len(self.recent) >= self.options.episodes_per_iteration):
                    self.is_settled = False
                    if enough and (grown := self.course.tree(self.policy)):
                        tree, eta = grown
                        told = f"step size {eta}, {gathered} examples, {leaves(tree)} leaves"
                        self.policy.add(tree, eta, told)
                    yield self._iteration()
                    if last:
                        return
                    self.recent = []
                    self.is_settled = True
                if not self._hears(episodes):
                    return

    def _iteration(self) -> Iteration:
        return Iteration(self.policy, self.count, tuple(self.recent), str(self.curriculum or ""))

    def _hears(self, episodes: Iterator[Episode]) -> bool:
        """Whether there is another episode, which is learned of."""
        for episode in episodes:
            self.is_settled = False
            self.recent.append(episode)
            self.course.hear(episode)
            self.is_settled = True
            return True
        return False

    def saved(self) -> dict[str, Any]:
        """All that it hangs on, as it is between two episodes."""
        return {
            "trees": list(self.policy.trees),
            "comments": list(self.policy.comments),
            "episodes": self._watched.saved(),
            "recent": list(self.recent),
            "course": self.course.saved(),
        }

    def resume(self, saved: dict[str, Any]) -> None:
        """Goes on from there; nothing has been played yet."""
        for tree, comment in zip(saved["trees"], saved["comments"], strict=True):
            self.policy.add(tree, comment=comment)
        self._watched.resume(saved["episodes"])
        self.recent = list(saved["recent"])
        self.course.resume(saved["course"])


def train(
    domain: Domain,
    bias: LanguageBias,
    options: Options | None = None,
    jobs: int = 1,
    is_over: Callable[[], bool] = lambda: False,
    expert: Expert | None = None,
) -> Iterator[Iteration]:
    """Yields after each tree, the first time before the first one, the last time after all episodes, or the one after
    which it `is_over`. Where there are MANY episodes to an iteration, up to `jobs` processes play them, and nothing
    changes with their number. `expert` guides episodes in place of the domain's own, and is pickled for these
    processes. Raises NppgError."""
    yield from Training(domain, bias, options, jobs, expert).iterations(is_over)
