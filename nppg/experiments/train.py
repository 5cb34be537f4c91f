"""Every learner behind one door: which one learns is a matter of the options."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Protocol

from nppg.bias.language_bias import LanguageBias
from nppg.experiments import checkpoints
from nppg.experiments.experts import expert_of
from nppg.experiments.learners import options_of
from nppg.experiments.run_files import settings
from nppg.learning.options import Common, Options
from nppg.learning.training import Iteration, Training
from nppg.policy.policy import Policy
from nppg.rrl.options import RIBOptions, TGOptions, TrendiOptions
from nppg.rrl.training import QLearning
from nppg.worlds.domain import Domain


class Learning(Protocol):
    """A training run as it goes on: learning/training.py and rrl/training.py document it."""

    is_settled: bool

    @property
    def policy(self) -> Policy: ...

    @property
    def count(self) -> int: ...

    def iterations(self, is_over: Callable[[], bool]) -> Iterator[Iteration]: ...

    def saved(self) -> dict[str, Any]: ...

    def resume(self, saved: dict[str, Any]) -> None: ...


# What learns by relational Q-learning; experiments/learners.py has the options of all.
_Q_LEARNERS = (TGOptions, RIBOptions, TrendiOptions)


def learning_of(domain: Domain, bias: LanguageBias, options: Common, jobs: int = 1) -> Learning:
    """A run that has not begun. Raises NppgError."""
    expert = expert_of(domain, options)
    if isinstance(options, Options):
        return Training(domain, bias, options, jobs, expert)
    assert isinstance(options, _Q_LEARNERS)
    return QLearning(domain, bias, options, expert)


def train(
    domain: Domain,
    bias: LanguageBias,
    options: Common | None = None,
    jobs: int = 1,
    is_over: Callable[[], bool] = lambda: False,
    resume: str | Path | None = None,
) -> Iterator[Iteration]:
    """Learns as the class of the options says: by policy gradients for Options, by relational Q-learning for TGOptions,
    RIBOptions or TrendiOptions. Left out, they are `options_of` the bias. By policy gradients up to `jobs` processes
    play the episodes of an iteration, if it has many; the episode is the last after which it `is_over`.
    Yields as it learns, the first time before it has learned anything; by relational Q-learning after each episode.
    With `resume`, the folder of a run, it goes on from the checkpoint there, and first yields what follows the last
    episode of that. Raises NppgError."""
    options = options_of(bias) if options is None else options
    learning = learning_of(domain, bias, options, jobs)
    if resume is not None:
        found = checkpoints.last(Path(resume), bias)
        checkpoints.check(found, settings(domain, bias, options))
        checkpoints.tell_versions(found)
        checkpoints.resumed(found.path, lambda: learning.resume(found.run["learning"]))
    return learning.iterations(is_over)
