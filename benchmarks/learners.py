"""A run of each other learner beside one of policy gradients; the points of a curve beside the training of its run."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from benchmarks.common import Row
from benchmarks.training import learn
from nppg import Domain, LanguageBias, Options
from nppg.bridge.files import locate
from nppg.experiments.learners import LEARNERS
from nppg.experiments.runs import run
from nppg.learning.options import Common

EPISODES = 2000
SECONDS = {"rib": 8}


def rows() -> Iterator[Row]:
    plain = _seconds(Options(EPISODES))
    for learner, options in LEARNERS.items():
        if learner != Options.learner:
            seconds, limit = _seconds(options(EPISODES)), SECONDS.get(learner)
            yield Row(
                f"{learner}, {EPISODES} episodes",
                f"{seconds:.1f} s",
                f"{seconds / plain:.1f} times a run of policy gradients ({plain:.1f} s)",
                f"<= {limit} s" if limit else "",
                seconds <= limit if limit else None,
            )
    for name, episodes in (("delivery", 300), ("noisy_blocks", 300)):
        yield _points(name, episodes)


def _seconds(options: Common) -> float:
    clock = time.process_time()
    learn(options)
    return time.process_time() - clock


def _points(name: str, episodes: int) -> Row:
    """Where states come again and where they do not."""
    domain, bias = Domain(name), LanguageBias.load(locate(name, "language_bias", ".yaml"))
    with tempfile.TemporaryDirectory() as folder:
        clock = time.process_time()
        progress = run(domain, bias, Options(episodes), Path(folder), starts=200)
        whole = time.process_time() - clock
    points = whole - progress.seconds
    return Row(
        f"points of the curve, `nppg train {name} --episodes {episodes}`: {len(progress.curve)}",
        f"{points:.1f} s",
        f"{points / progress.seconds:.1f} times the training ({progress.seconds:.1f} s)",
    )
