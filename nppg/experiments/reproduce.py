"""The paper's experiments: many runs of several learners, side by side, each tested as it learns.

Every run is a run of nppg.experiments.runs in a folder of its own, with a file `tests.csv` beside the usual ones.
"""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import locate, replacing
from nppg.experiments import jobs
from nppg.experiments.jobs import packed
from nppg.experiments.learners import LEARNERS
from nppg.experiments.paper import Experiment, Parameters, Variant
from nppg.experiments.probes import PROBES
from nppg.experiments.progress import Progress
from nppg.experiments.runs import judging_of
from nppg.judging.space import Space
from nppg.worlds.domain import Domain

_TESTS = "tests.csv"


@dataclass(frozen=True)
class Job(jobs.Job):
    """One run of an experiment."""

    experiment: Experiment
    variant: Variant

    def is_finished(self) -> bool:
        return (self.folder / _TESTS).is_file() and super().is_finished()

    def tests(self) -> list[dict[str, float]]:
        """What the probe has seen in the finished run."""
        with (self.folder / _TESTS).open(newline="") as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def observer(self, domain: Domain, folder: Path) -> tuple[Callable[[Progress], None], Space | None]:
        probe = PROBES[self.experiment.probe](domain, self.experiment)

        def look(progress: Progress) -> None:
            progress.notes.extend(probe.seen(progress))
            if progress.ended:
                replacing(folder / _TESTS, lambda path: _write(progress.notes, path))

        return look, probe.space


def jobs_of(experiment: Experiment, runs: int, episodes: int, parameters: Parameters, output: Path) -> list[Job]:
    """All runs of an experiment, variant by variant; `parameters` come on top of the variant's. Raises NppgError."""
    bias = LanguageBias.load(locate(experiment.domain, "language_bias", ".yaml"))
    found: list[Job] = []
    worlds: dict[tuple, bytes] = {}  # the same where it is equal, so that the runs of a process share it
    for variant in experiment.variants:
        given = {**variant.parameters, **parameters}
        domain = Domain(experiment.domain, given)
        world = worlds.setdefault(tuple(sorted(given.items())), packed(domain, bias))
        judging = judging_of(domain, experiment.every, experiment.starts)
        kind = LEARNERS[variant.learner]
        for seed in range(runs):
            options = kind(episodes=episodes, seed=seed, **variant.options)  # type: ignore[arg-type]
            folder = output / "runs" / f"{variant.name}-{seed}"
            found.append(Job(world, options, judging, folder, experiment, variant))
    return found


def _write(rows: list[dict[str, float]], path: Path) -> None:
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
