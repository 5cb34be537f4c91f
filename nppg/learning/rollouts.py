"""The episodes of a training run: one after the other, or those of an iteration by several processes."""

from __future__ import annotations

import time
import warnings
from collections import deque
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from nppg.errors import NppgError, Problem
from nppg.learning.curriculum import Curriculum
from nppg.learning.episode import IDLE, Episode, generate_episode
from nppg.learning.options import Common, Options
from nppg.policy.beside import Gone, Others
from nppg.policy.policy import Policy

SILENCE = 200  # episodes without any reward after which that is told
MANY = 50  # episodes an iteration from which on each has a generator of its own; fewer draw from that of the run


def are_many(options: Common) -> bool:
    """Whether the episodes of an iteration are so many that processes play them."""
    return isinstance(options, Options) and options.episodes_per_iteration >= MANY


class Played(NamedTuple):
    """An episode, and the problem that a curriculum drew for it."""

    episode: Episode
    problem: int | None


class Rollouts:
    """Plays episodes of a training run by their numbers, each with a generator of its own, so that it does not matter
    who plays it. With a curriculum so many problems as are `opened` are open."""

    def __init__(self, policy: Policy, options: Options, curriculum: Curriculum | None = None):
        self.policy = policy
        self.options = options
        self.curriculum = curriculum

    def __call__(self, numbers: Sequence[int], opened: int) -> list[Played]:
        rngs = (np.random.default_rng([self.options.seed, each]) for each in numbers)
        return [_played(self.policy, rng, self.options, self.curriculum, opened) for rng in rngs]


def _played(
    policy: Policy, rng: np.random.Generator, options: Common, curriculum: Curriculum | None, opened: int
) -> Played:
    problem = curriculum.draw(rng, opened) if curriculum else None
    start = None if problem is None else policy.domain.problem(problem)
    floor = options.floor if isinstance(options, Options) else 0.0
    episode = generate_episode(
        policy, rng, options.guidance, options.horizon_factor, learning=True, start=start, floor=floor
    )
    return Played(episode, problem)


def training_episodes(
    policy: Policy, rng: np.random.Generator, options: Common, curriculum: Curriculum | None = None
) -> Iterator[Episode]:
    """The episodes of a training run, each by the policy as it is by then; what the curriculum opens is open from the
    next one on. Warns where none of them is rewarded. Raises NppgError where no episode takes a step any more."""
    played = (
        _played(policy, rng, options, curriculum, curriculum.opened if curriculum else 0)
        for _ in range(options.episodes)
    )
    return _watched(policy, played, options, curriculum)


def iterations_episodes(
    policy: Policy, options: Options, jobs: int, curriculum: Curriculum | None = None
) -> Iterator[Episode]:
    """The same where many episodes are played between two trees, in up to `jobs` processes, which changes nothing; what
    the curriculum opens is open from the next tree on."""
    return _watched(policy, _by_iterations(Rollouts(policy, options, curriculum), jobs), options, curriculum)


def _watched(
    policy: Policy, episodes: Iterator[Played], options: Common, curriculum: Curriculum | None
) -> Iterator[Episode]:
    idle, rewarded = 0, False
    for count, (episode, problem) in enumerate(episodes, 1):
        idle = 0 if episode.steps else idle + 1
        if idle == IDLE:
            message = f"{idle} episodes took no step: their starts were goal or terminal states, or the horizon 0"
            raise NppgError([Problem(str(policy.domain.path), 0, 0, message)])
        rewarded = rewarded or any(step.reward for step in episode.steps)
        if curriculum and problem is not None and not episode.guided:
            curriculum.note(problem, episode.success)
        if not rewarded and count in (SILENCE, options.episodes):
            warnings.warn(_silent(policy, count, options, curriculum), stacklevel=2)
        yield episode


def _silent(policy: Policy, count: int, options: Common, curriculum: Curriculum | None) -> str:
    """What is told where no episode has been rewarded."""
    if curriculum:
        where = f", not even on the {curriculum.opened} smallest problems"
        wanted = ["smaller problems"]
    elif policy.domain.chosen:
        where = ""
        wanted = ["smaller problems"] + ["--curriculum yes"] * (getattr(options, "curriculum", "yes") == "no")
    else:
        where = ""
        wanted = ["smaller start states, or problems from small to large"]
    if not policy.domain.has_expert:
        wanted.append("an expert")
    elif not options.guidance:
        wanted.append("--guidance 0.1, for the domain has an expert")
    wanted.append("a longer horizon (--horizon-factor 2)")
    learned = "nothing has been learned" if count == options.episodes else "nothing can be learned so far"
    return f"none of {count} episodes was rewarded{where}: {learned}. What may help: {'; '.join(wanted)}"


def _by_iterations(rollouts: Rollouts, jobs: int) -> Iterator[Played]:
    """Of those that are played at once, the ones behind a new tree are played again, by the policy that has it."""
    policy, options, curriculum = rollouts.policy, rollouts.options, rollouts.curriculum
    others = Others(rollouts, 0 if policy.domain.environment else jobs - 1)
    ready: deque[Played] = deque()
    wanted, trees, opened = 0, -1, 0
    try:
        for number in range(options.episodes):
            if len(policy.trees) != trees:
                ready.clear()
                wanted, trees = options.episodes_per_iteration, len(policy.trees)
                opened = curriculum.opened if curriculum else 0
            if not ready:
                end = min(options.episodes, number + wanted)
                ready += _at_once(rollouts, others, range(number, end), opened)
                wanted = others.count + 1  # there may be enough examples with any of them
            yield ready.popleft()
    finally:
        others.close()


def _at_once(rollouts: Rollouts, others: Others, numbers: Sequence[int], opened: int) -> list[Played]:
    processes = others.free()
    own, *parts = [part.tolist() for part in np.array_split(numbers, len(processes) + 1)]
    asked = [others.asked(process, part, opened) for process, part in zip(processes, parts, strict=True)]
    begin = time.perf_counter()
    found = rollouts(own, opened)
    others.worked(time.perf_counter() - begin)
    for process, ready, part in zip(processes, asked, parts, strict=True):
        try:
            found += process.answer() if ready else rollouts(part, opened)
        except Gone:
            others.lost(process)
            found += rollouts(part, opened)
    return found
