"""The episodes of a training run: one after the other, or those of an iteration by several processes."""

from __future__ import annotations

import time
import warnings
from collections import deque
from collections.abc import Iterator, Sequence
from functools import partial
from types import TracebackType
from typing import Any, NamedTuple, Protocol

import numpy as np

from nppg.errors import NppgError, Problem
from nppg.learning.curriculum import Curriculum
from nppg.learning.episode import IDLE, Episode, Expert, generate_episode
from nppg.learning.options import Common, Options
from nppg.policy.beside import Gone, Others
from nppg.policy.policy import Policy

SILENCE = 200  # episodes that have come to nothing after which that is told
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
    who plays it. With a curriculum so many problems as are `opened` are open, while there are so many `trees`."""

    def __init__(
        self, policy: Policy, options: Options, curriculum: Curriculum | None = None, expert: Expert | None = None
    ):
        self.policy = policy
        self.options = options
        self.curriculum = curriculum
        self.expert = expert
        self.opened, self.trees = 0, -1

    def __call__(self, numbers: Sequence[int], opened: int) -> list[Played]:
        rngs = (np.random.default_rng([self.options.seed, each]) for each in numbers)
        return [_played(self.policy, rng, self.options, self.curriculum, opened, self.expert) for rng in rngs]


def _played(
    policy: Policy,
    rng: np.random.Generator,
    options: Common,
    curriculum: Curriculum | None,
    opened: int,
    expert: Expert | None,
) -> Played:
    problem = curriculum.draw(rng, opened) if curriculum else None
    start = None if problem is None else policy.domain.problem(problem)
    floor = options.floor if isinstance(options, Options) else 0.0
    episode = generate_episode(
        policy,
        rng,
        options.guidance,
        options.horizon_factor,
        learning=True,
        start=start,
        expert=expert,
        floor=floor,
    )
    return Played(episode, problem)


def training_episodes(
    policy: Policy,
    rng: np.random.Generator,
    options: Common,
    curriculum: Curriculum | None = None,
    expert: Expert | None = None,
) -> Watched:
    """The episodes of a training run, each by the policy as it is by then; what the curriculum opens is open from the
    next one on."""
    return Watched(policy, _OneByOne(policy, rng, options, curriculum, expert), options, curriculum)


def iterations_episodes(
    policy: Policy, options: Options, jobs: int, curriculum: Curriculum | None = None, expert: Expert | None = None
) -> Watched:
    """The same where many episodes are played between two trees, in up to `jobs` processes, which changes nothing; what
    the curriculum opens is open from the next tree on."""
    rollouts = Rollouts(policy, options, curriculum, expert)
    return Watched(policy, _ByIterations(rollouts, jobs), options, curriculum)


class _Plays(Protocol):
    """Plays the episodes of a run from a number on; what its next episode hangs on can be stored."""

    def __call__(self, begin: int) -> Iterator[Played]: ...

    def saved(self) -> Any: ...

    def resume(self, saved: Any) -> None: ...


class _OneByOne:
    """Episodes that draw from the generator of the run."""

    def __init__(
        self,
        policy: Policy,
        rng: np.random.Generator,
        options: Common,
        curriculum: Curriculum | None,
        expert: Expert | None,
    ):
        self._rng = rng
        self._options = options
        self._curriculum = curriculum
        self._play = partial(_played, policy, rng, options, curriculum, expert=expert)
        self._before: dict[str, Any] | None = None  # the generator before the episode that is being played

    def __call__(self, begin: int) -> Iterator[Played]:
        for _ in range(begin, self._options.episodes):
            self._before = dict(self._rng.bit_generator.state)
            played = self._play(self._curriculum.opened if self._curriculum else 0)
            self._before = None
            yield played

    def saved(self) -> dict[str, Any]:
        return self._before or dict(self._rng.bit_generator.state)

    def resume(self, saved: dict[str, Any]) -> None:
        self._rng.bit_generator.state = saved


class Watched:
    """The episodes of a training run, in `with` for as long as it goes on. Warns where all have come to nothing: none
    has reached the goal, or none was rewarded where there is no goal; after SILENCE of them and at the end, whatever
    ends the run but a mistake. Raises NppgError where no episode takes a step any more."""

    def __init__(self, policy: Policy, plays: _Plays, options: Common, curriculum: Curriculum | None):
        self.count = 0  # episodes so far
        self._policy = policy
        self._plays = plays
        self._options = options
        self._curriculum = curriculum
        self._idle = 0
        self._is_rewarded = self._is_silent = self._has_reached = False

    def __enter__(self) -> Iterator[Episode]:
        return self._episodes()

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        if self._is_silent and not isinstance(error, Exception):
            self._tell("nothing has been learned")

    def saved(self) -> dict[str, Any]:
        """What is to be known of the episodes so far, and of what they have drawn."""
        flags = (self._is_rewarded, self._is_silent, self._has_reached)
        curriculum = self._curriculum
        return {
            "count": self.count,
            "idle": self._idle,
            "flags": flags,
            "plays": self._plays.saved(),
            "curriculum": curriculum and [curriculum.opened, list(curriculum.newest), curriculum.any_success],
        }

    def resume(self, saved: dict[str, Any]) -> None:
        """Goes on from there."""
        self.count, self._idle = saved["count"], saved["idle"]
        self._is_rewarded, self._is_silent, self._has_reached = saved["flags"]
        self._plays.resume(saved["plays"])
        if self._curriculum:
            self._curriculum.opened, self._curriculum.newest, self._curriculum.any_success = saved["curriculum"]

    def _episodes(self) -> Iterator[Episode]:
        domain, curriculum = self._policy.domain, self._curriculum
        for episode, problem in self._plays(self.count):
            self.count += 1
            self._idle = 0 if episode.steps else self._idle + 1
            if self._idle == IDLE:
                message = f"{IDLE} episodes took no step: their starts were goal or terminal states, or the horizon 0"
                raise NppgError([Problem(str(domain.path), 0, 0, message)])
            self._is_rewarded = self._is_rewarded or any(step.reward for step in episode.steps)
            self._has_reached = self._has_reached or (episode.success and bool(episode.steps))
            self._is_silent = not (self._has_reached if domain.has_goal else self._is_rewarded)
            if curriculum and problem is not None and not episode.guided:
                curriculum.note(problem, episode.success)
            if self._is_silent and self.count == SILENCE and self.count < self._options.episodes:
                self._tell("nothing can be learned so far")
            yield episode

    def _tell(self, learned: str) -> None:
        domain, curriculum, options = self._policy.domain, self._curriculum, self._options
        where = ""
        if curriculum:
            where = f", not even on the {curriculum.opened} smallest problems"
            wanted = ["smaller problems"]
        elif domain.chosen:
            wanted = ["smaller problems"] + ["--curriculum yes"] * (getattr(options, "curriculum", "yes") == "no")
        else:
            wanted = ["smaller start states, or problems from small to large"]
        if not domain.has_expert:
            wanted.append("an expert")
        elif not options.guidance:
            wanted.append("--guidance 0.1, for the domain has an expert")
        wanted.append("a longer horizon (--horizon-factor 2)")
        what = "reached the goal" if domain.has_goal else "was rewarded"
        so = "" if self._is_rewarded else f": {learned}"
        told = f"none of {self.count} episodes {what}{where}{so}. What may help: {'; '.join(wanted)}"
        warnings.warn(told, stacklevel=3)


class _ByIterations:
    """Of the episodes that are played at once, the ones behind a new tree are played again, by the policy that has
    it."""

    def __init__(self, rollouts: Rollouts, jobs: int):
        self._rollouts = rollouts
        self._jobs = jobs

    def __call__(self, begin: int) -> Iterator[Played]:
        rollouts = self._rollouts
        policy, options, curriculum = rollouts.policy, rollouts.options, rollouts.curriculum
        others = Others(rollouts, 0 if policy.domain.environment else self._jobs - 1)
        ready: deque[Played] = deque()
        wanted = options.episodes_per_iteration
        try:
            for number in range(begin, options.episodes):
                if len(policy.trees) != rollouts.trees:
                    ready.clear()
                    wanted, rollouts.trees = options.episodes_per_iteration, len(policy.trees)
                    rollouts.opened = curriculum.opened if curriculum else 0
                if not ready:
                    end = min(options.episodes, number + wanted)
                    ready += _at_once(rollouts, others, range(number, end), rollouts.opened)
                    wanted = others.count + 1  # there may be enough examples with any of them
                yield ready.popleft()
        finally:
            others.close()

    def saved(self) -> list[int]:
        return [self._rollouts.opened, self._rollouts.trees]

    def resume(self, saved: list[int]) -> None:
        self._rollouts.opened, self._rollouts.trees = saved


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
