"""Relational Q-learning: Dzeroski, De Raedt and Driessens (2001), Algorithm RRL."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from nppg.bias.language_bias import LanguageBias
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
        value = step.reward + policy.options.discount * following
        found.append(Example(step.state, step.actions[step.chosen], step.answers[step.chosen], value))
        following = float(step.potentials.max())
    return found


def train(
    domain: Domain, bias: LanguageBias, options: QOptions, expert: Expert | None = None
) -> Iterator[Iteration]:
    """Yields after each episode, the first time before the first one. `expert` guides in place of the domain's own.
    Raises NppgError."""
    rng = np.random.default_rng(options.seed)
    policy = QFunction(regressor(domain, bias, options), options)
    yield Iteration(policy, 0, ())
    with training_episodes(policy, rng, options, expert=expert) as episodes:
        for count, episode in enumerate(episodes, 1):
            policy.regressor.update(examples(episode, policy))
            policy.temperature = options.temperature_after(count)
            yield Iteration(policy, count, (episode,))
