"""Relational Q-learning: Dzeroski, De Raedt and Driessens (2001), Algorithm RRL."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.plain import number
from nppg.learning.episode import Episode, Expert
from nppg.learning.rollouts import training_episodes
from nppg.learning.training import Iteration
from nppg.rrl.options import QOptions
from nppg.rrl.qfunction import Example, QFunction
from nppg.rrl.regressors import regressor
from nppg.worlds.domain import Domain


def examples(episode: Episode, policy: QFunction) -> list[Example]:
    """One for each step, from the last to the first: q = r + discount * max_b Q(s', b), without the second term where
    s' ends the episode as a goal or terminal state. All Q are those that the episode was chosen by."""
    following = float(policy.potentials(episode.last, episode.open).max()) if episode.open else 0.0
    found = []
    for step in reversed(episode.steps):
        value = number("the target", step.reward + policy.options.discount * following)
        found.append(Example(step.state, step.actions[step.chosen], step.answers[step.chosen], value))
        following = float(step.potentials.max())
    return found


class QLearning:
    """A training run as it goes on. Between two episodes all that it hangs on can be stored, and gone on with by
    another one that was made of the same domain, bias and options, with the same numbers."""

    def __init__(self, domain: Domain, bias: LanguageBias, options: QOptions, expert: Expert | None = None):
        self.options = options
        self.policy = QFunction(regressor(domain, bias, options), options)
        self.recent: list[Episode] = []
        self.is_settled = True  # whether `saved` can tell what it is: not while it learns from an episode
        rng = np.random.default_rng(options.seed)
        self._watched = training_episodes(self.policy, rng, options, expert=expert)

    @property
    def count(self) -> int:
        """The episodes so far."""
        return self._watched.count

    def iterations(self, is_over: Callable[[], bool] = lambda: False) -> Iterator[Iteration]:
        """See `train`; it ends with the episode after which it `is_over`. A run that is gone on with begins with what
        comes of its last episode, if nobody has heard of that."""
        if self.count == 0:
            yield Iteration(self.policy, 0, ())
        with self._watched as episodes:
            while self.recent or self._hears(episodes):
                last = is_over()
                self.is_settled = False
                yield Iteration(self.policy, self.count, tuple(self.recent))
                if last:
                    return
                self.recent = []
                self.is_settled = True

    def _hears(self, episodes: Iterator[Episode]) -> bool:
        """Whether there is another episode, which is learned from."""
        for episode in episodes:
            self.is_settled = False
            self.policy.regressor.update(examples(episode, self.policy))
            self.policy.temperature = self.options.temperature_after(self.count)
            self.recent = [episode]
            self.is_settled = True
            return True
        return False

    def saved(self) -> dict[str, Any]:
        """All that it hangs on, as it is between two episodes."""
        regressor = self.policy.regressor.saved()
        return {"regressor": regressor, "episodes": self._watched.saved(), "recent": list(self.recent)}

    def resume(self, saved: dict[str, Any]) -> None:
        """Goes on from there; nothing has been played yet."""
        self.policy.regressor.resume(saved["regressor"])
        self._watched.resume(saved["episodes"])
        self.policy.temperature = self.options.temperature_after(self.count)
        self.recent = list(saved["recent"])


def train(domain: Domain, bias: LanguageBias, options: QOptions, expert: Expert | None = None) -> Iterator[Iteration]:
    """Yields after each episode, the first time before the first one. `expert` guides in place of the domain's own.
    Raises NppgError."""
    yield from QLearning(domain, bias, options, expert).iterations()
