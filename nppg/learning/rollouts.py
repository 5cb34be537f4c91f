"""The episodes of a training run: one after the other, or those of an iteration by several processes."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Iterator, Sequence

import numpy as np

from nppg.errors import NppgError, Problem
from nppg.learning.episode import IDLE, Episode, Expert, generate_episode
from nppg.learning.options import Common, Options
from nppg.policy.beside import Gone, Others
from nppg.policy.policy import Policy

MANY = 50  # episodes an iteration from which on each has a generator of its own; fewer draw from that of the run


def are_many(options: Common) -> bool:
    """Whether the episodes of an iteration are so many that processes play them."""
    return isinstance(options, Options) and options.episodes_per_iteration >= MANY


class Rollouts:
    """Plays episodes of a training run by their numbers, each with a generator of its own, so that it does not matter
    who plays it."""

    def __init__(self, policy: Policy, options: Options, expert: Expert | None = None):
        self.policy = policy
        self.options = options
        self.expert = expert

    def __call__(self, numbers: Sequence[int]) -> list[Episode]:
        options = self.options
        return [
            _played(self.policy, np.random.default_rng([options.seed, each]), options, self.expert) for each in numbers
        ]


def _played(policy: Policy, rng: np.random.Generator, options: Common, expert: Expert | None) -> Episode:
    return generate_episode(policy, rng, options.guidance, options.horizon_factor, learning=True, expert=expert)


def training_episodes(
    policy: Policy, rng: np.random.Generator, options: Common, expert: Expert | None = None
) -> Iterator[Episode]:
    """The episodes of a training run, each by the policy as it is by then, or guided by the expert, by default the
    domain's own. Raises NppgError where no episode takes a step any more."""
    return _busy(policy, (_played(policy, rng, options, expert) for _ in range(options.episodes)))


def iterations_episodes(
    policy: Policy, options: Options, jobs: int, expert: Expert | None = None
) -> Iterator[Episode]:
    """The same where many episodes are played between two trees, in up to `jobs` processes, which changes nothing."""
    return _busy(policy, _by_iterations(Rollouts(policy, options, expert), jobs))


def _busy(policy: Policy, episodes: Iterator[Episode]) -> Iterator[Episode]:
    idle = 0
    for episode in episodes:
        idle = 0 if episode.steps else idle + 1
        if idle == IDLE:
            message = f"{idle} episodes took no step: their starts were goal or terminal states, or the horizon 0"
            raise NppgError([Problem(str(policy.domain.path), 0, 0, message)])
        yield episode


def _by_iterations(rollouts: Rollouts, jobs: int) -> Iterator[Episode]:
    """Of those that are played at once, the ones behind a new tree are played again, by the policy that has it."""
    policy, options = rollouts.policy, rollouts.options
    others = Others(rollouts, 0 if policy.domain.environment else jobs - 1)
    ready: deque[Episode] = deque()
    wanted, trees = options.episodes_per_iteration, len(policy.trees)
    try:
        for number in range(options.episodes):
            if len(policy.trees) != trees:
                ready.clear()
                wanted, trees = options.episodes_per_iteration, len(policy.trees)
            if not ready:
                end = min(options.episodes, number + wanted)
                ready += _at_once(rollouts, others, range(number, end))
                wanted = others.count + 1  # there may be enough examples with any of them
            yield ready.popleft()
    finally:
        others.close()


def _at_once(rollouts: Rollouts, others: Others, numbers: Sequence[int]) -> list[Episode]:
    processes = others.free()
    own, *parts = [part.tolist() for part in np.array_split(numbers, len(processes) + 1)]
    asked = [others.asked(process, part) for process, part in zip(processes, parts, strict=True)]
    begin = time.perf_counter()
    found = rollouts(own)
    others.worked(time.perf_counter() - begin)
    for process, ready, part in zip(processes, asked, parts, strict=True):
        try:
            found += process.answer() if ready else rollouts(part)
        except Gone:
            others.lost(process)
            found += rollouts(part)
    return found
