"""Where the time of a training run goes: the share of every question to Prolog and of every stage in Python."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import nppg.bridge.prolog
import nppg.judging.evaluation
import nppg.learning.episode
import nppg.learning.regressors
import nppg.learning.training
import nppg.trees.tilde
from benchmarks.common import timed
from benchmarks.training import learn
from nppg.answers.coverage import Coverage
from nppg.answers.table import TestTable
from nppg.bias.refinement import Refiner
from nppg.experiments.learners import LEARNERS
from nppg.learning.options import Common
from nppg.policy.forest import Forest
from nppg.policy.policy import Policy
from nppg.rrl.distance import PairDistance
from nppg.rrl.instance_tree import InstanceTree
from nppg.rrl.instances import Instances
from nppg.rrl.tg import TG

STAGES: list[tuple[Any, str, str]] = [
    (nppg.learning.episode, "generate_episode", "the loop of an episode, choosing"),
    (TestTable, "answers", "unpacking the answers"),
    (Forest, "sums", "summing the trees"),
    (nppg.learning.training, "examples", "the functional gradient"),
    (nppg.learning.regressors, "grow", "growing a tree, the rest"),
    (Refiner, "refinements", "refinements of a node"),
    (Coverage, "matrix", "gathering a node's answers"),
    (nppg.trees.tilde, "best_split", "the best split"),
    (nppg.trees.tilde, "best_step", "the best split of a second-order step"),
    (Policy, "add", "adding a tree"),
    (TG, "update", "statistics and splits of TG"),
    (InstanceTree, "predict", "predictions from instances"),
    (InstanceTree, "update", "storing instances, looking for splits"),
    (Instances, "_least", "choosing the instance to remove"),
    (PairDistance, "describe", "the classes of pairs"),
    (PairDistance, "rows", "distances"),
]


class Clock:
    """Adds up the time that is spent in functions themselves, without what they call."""

    def __init__(self) -> None:
        self.calls: dict[str, int] = {}
        self.seconds: dict[str, float] = {}
        self._inner = [0.0]

    def around(self, function: Callable, name: Callable[..., str]) -> Callable:
        def measured(*args: Any, **options: Any) -> Any:
            key, start = name(*args), time.perf_counter()
            self._inner.append(0.0)
            try:
                return function(*args, **options)
            finally:
                spent = time.perf_counter() - start
                self.calls[key] = self.calls.get(key, 0) + 1
                self.seconds[key] = self.seconds.get(key, 0.0) + spent - self._inner.pop()
                self._inner[-1] += spent

        return measured


@contextmanager
def _wrapped(clock: Clock) -> Iterator[None]:
    asking = [each for name, each in sys.modules.items() if name.startswith("nppg.") and hasattr(each, "ask")]
    places = [(owner, name, lambda *_, text=f"Python: {text}": text) for owner, name, text in STAGES]
    places += [(module, "ask", lambda question, *_: f"Prolog: {question}") for module in asking]
    old = [getattr(owner, name) for owner, name, _ in places]
    for (owner, name, label), function in zip(places, old, strict=True):
        setattr(owner, name, clock.around(function, label))
    try:
        yield
    finally:
        for (owner, name, _), function in zip(places, old, strict=True):
            setattr(owner, name, function)


def tables(seed: int = 0, episodes: int = 2000) -> str:
    """The profile of a run of each learner, in Markdown."""
    return "\n\n".join(
        f"{learner}, {episodes} episodes:\n\n{_table(options(episodes, seed))}" for learner, options in LEARNERS.items()
    )


def _table(options: Common) -> str:
    clock = Clock()
    with _wrapped(clock):
        total, _ = timed(lambda: learn(options))
    shown = sorted(((seconds, key) for key, seconds in clock.seconds.items()), reverse=True)
    rows = [
        f"| {key} | {clock.calls[key]} | {1e6 * seconds / clock.calls[key]:.0f} | {seconds / total:.1%} |"
        for seconds, key in shown
        if seconds / total >= 0.005
    ]
    rest = 1 - sum(seconds for seconds, _ in shown) / total
    head = ["| where | calls | µs a call | share |", "|---|---:|---:|---:|"]
    return "\n".join([*head, *rows, f"| the rest | | | {rest:.1%} |", f"| all | | | {total:.2f} s |"])
