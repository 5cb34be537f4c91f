"""What the experiments look at in a policy while it learns: rows of numbers, one file of them for each run."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Protocol

import numpy as np

from nppg.experiments import corridor
from nppg.experiments.paper import Experiment
from nppg.experiments.progress import Progress
from nppg.judging.space import Space, shared_space
from nppg.worlds.domain import Domain

ITERATIONS = (1, 2, 5, 10, 20, 50)  # trees after which the corridor's policy is looked at
CELLS = 200  # of the corridor


class Probe(Protocol):
    """Looks at the runs in one domain."""

    space: Space | None  # the domain's, where the probe has it

    def seen(self, progress: Progress) -> Iterator[dict[str, float]]:
        """Rows about the policy as it is by now, if this is the time to look at it."""


class Lengths:
    """Success by the minimal length of a solution, for each length: its share of all start states, the exact success,
    how many of the experiment's starts, the same in all tests and runs, have it, and how many of these succeeded."""

    def __init__(self, domain: Domain, experiment: Experiment):
        self.space: Space | None = shared_space(domain)
        self._drawn = shared_space(domain).draw(experiment.starts, np.random.default_rng(0x74657374))

    def seen(self, progress: Progress) -> Iterator[dict[str, float]]:
        evaluator, point = progress.evaluator, progress.point
        if not point:
            return
        assert evaluator
        space, drawn = evaluator.space, self._drawn
        succeeded = evaluator.sample(drawn, np.random.default_rng([progress.options.seed, point.episode]))
        success, _ = evaluator.by_class()
        lengths = np.array(space.horizons)
        for length in np.unique(lengths[space.running]).tolist():
            among = space.shares * (lengths == length)
            here = lengths[drawn] == length
            share = float(among.sum())
            yield {
                "episode": point.episode,
                "length": length,
                "share": share,
                "exact": float((among * success).sum() / share),
                "drawn": int(here.sum()),
                "succeeded": int(succeeded[here].sum()),
            }


class Corridor:
    """The probability of going left, and the expected return, by position."""

    space: Space | None = None

    def __init__(self, domain: Domain, experiment: Experiment):
        self._cells = corridor.Corridor(domain, CELLS)

    def seen(self, progress: Progress) -> Iterator[dict[str, float]]:
        policy = progress.policy
        trees = len(policy.trees)
        if trees not in ITERATIONS:
            return
        positions = self._cells.centres.tolist()
        left = np.array([policy.distribution((("pos", x),), ["left", "right"])[0] for x in positions])
        values = self._cells.values(1 - left)
        for position, chance, value in zip(positions, left.tolist(), values.tolist(), strict=True):
            yield {"iteration": trees, "position": position, "left": chance, "value": value}


PROBES: dict[str, Callable[[Domain, Experiment], Probe]] = {"lengths": Lengths, "corridor": Corridor}
