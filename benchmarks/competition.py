"""Learning in the worlds of the planning competition, as `nppg import` writes them: seconds, and where they go.

NPPG_PDDL names a folder like the competition's (NAME/domain.pddl, NAME/training); without it there is nothing to learn.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.common import Row
from nppg import language_bias_of, open_domain, options_of, train
from nppg.bias.refinement import Refinement, Refiner
from nppg.logic.query import Query

EPISODES = 500  # of a world without a limit
MANY = 2000
LAST = 100
SECONDS = {"blocksworld": 20, "satellite": 25, "transport": 30}
SHARE = 0.02  # of the time may be refinement


def rows() -> Iterator[Row]:
    for folder in filter(None, os.environ.get("NPPG_PDDL", "").split(os.pathsep)):
        for file in sorted(Path(folder).glob("*/domain.pddl")):
            if problems := sorted(file.parent.glob("training/**/*.pddl")):
                yield _row(file, problems)


def _row(file: Path, problems: Sequence[Path]) -> Row:
    domain = open_domain(file, problems=problems)
    bias = language_bias_of(domain)
    limit = SECONDS.get(file.parent.name)
    episodes = MANY if limit else EPISODES
    options = replace(options_of(bias), episodes=episodes)
    outcomes: list[bool] = []
    with _timed_refinements() as refining:
        clock = time.process_time()
        for iteration in train(domain, bias, options):
            outcomes += [episode.success for episode in iteration.recent]
        seconds = time.process_time() - clock
    share = sum(refining) / seconds
    return Row(
        f"{file.parent.name}, {episodes} episodes, {len(iteration.policy.trees)} trees",
        f"{seconds:.1f} s, {np.mean(outcomes[-LAST:]):.0%} of the last {LAST} episodes reach the goal",
        f"refinement is {share:.1%} of it",
        f"<= {SHARE:.0%}" + (f", <= {limit} s" if limit else ""),
        share <= SHARE and (limit is None or seconds <= limit),
    )


@contextmanager
def _timed_refinements() -> Iterator[list[float]]:
    """The seconds of every call of the refinement operator."""
    found: list[float] = []
    original = Refiner.refinements

    def measured(refiner: Refiner, query: Query) -> tuple[Refinement, ...]:
        clock = time.process_time()
        result = original(refiner, query)
        found.append(time.process_time() - clock)
        return result

    Refiner.refinements = measured  # type: ignore[method-assign]
    try:
        yield found
    finally:
        Refiner.refinements = original  # type: ignore[method-assign]
