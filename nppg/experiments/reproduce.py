"""The paper's experiments: many runs of several learners, side by side, each tested as it learns.

Every run is a run of nppg.experiments.runs in a folder of its own, with a file `tests.csv` beside the usual ones. A run
that has been finished with the same settings is not done again.
"""

from __future__ import annotations

import csv
import functools
import json
import os
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import asdict, dataclass
from multiprocessing import get_context
from pathlib import Path

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import file_hash, locate, replacing
from nppg.bridge.interrupts import interruptible
from nppg.errors import NppgError
from nppg.experiments.learners import LEARNERS
from nppg.experiments.paper import Experiment, Parameters, Variant
from nppg.experiments.probes import PROBES
from nppg.experiments.progress import Progress
from nppg.experiments.runs import run
from nppg.learning.options import Common
from nppg.worlds.domain import Domain

_TESTS = "tests.csv"


@dataclass(frozen=True)
class Job:
    """One run of an experiment."""

    experiment: Experiment
    variant: Variant
    options: Common
    parameters: Parameters
    folder: Path

    def is_finished(self) -> bool:
        """Whether its files are there and come from the same settings, domain and bias."""
        try:
            summary = json.loads((self.folder / "run.json").read_text())
        except (OSError, ValueError):
            return False
        name = self.experiment.domain
        inputs = [locate(name, "domains", ".pl"), locate(name, "language_bias", ".yaml")]
        return (
            (self.folder / _TESTS).is_file()
            and summary["learner"] == self.options.learner
            and summary["options"] == asdict(self.options)
            and summary["episodes"] == self.options.episodes
            and summary["curve"]["starts"] == self.experiment.starts
            and summary["domain"]["parameters"] == _domain(name, tuple(sorted(self.parameters.items()))).parameters
            and [summary[each]["sha256"] for each in ("domain", "bias")] == list(map(file_hash, inputs))
        )

    def result(self) -> str:
        """What the finished run has come to, in one line."""
        last = self.summary()["last"]
        sizes = ", ".join(f"{last[name]} {name}" for name in ("trees", "leaves", "instances") if last[name])
        return f"success {last['success']:.4f}, {sizes or 'nothing learned'}"

    def tests(self) -> list[dict[str, float]]:
        """What the probe has seen in the finished run."""
        with (self.folder / _TESTS).open(newline="") as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def summary(self) -> dict:
        """What run.json says of the finished run."""
        return json.loads((self.folder / "run.json").read_text())

    def curve(self) -> list[dict[str, str]]:
        """The points of the finished run's curve.csv."""
        with (self.folder / "curve.csv").open(newline="") as file:
            return list(csv.DictReader(file))


def jobs(experiment: Experiment, runs: int, episodes: int, parameters: Parameters, output: Path) -> list[Job]:
    """All runs of an experiment, variant by variant; `parameters` come on top of the variant's."""
    return [
        Job(
            experiment,
            variant,
            LEARNERS[variant.learner](episodes=episodes, seed=seed, **variant.options),  # type: ignore[arg-type]
            {**variant.parameters, **parameters},
            output / "runs" / f"{variant.name}-{seed}",
        )
        for variant in experiment.variants
        for seed in range(runs)
    ]


def do(wanted: list[Job], processes: int) -> Iterator[tuple[Job, float]]:
    """Does the runs that are not finished yet, in `processes` spawned processes. Yields each finished one, with the
    seconds that it took, 0 where it was there already. Raises NppgError."""
    missing = [job for job in wanted if not job.is_finished()]
    yield from ((job, 0.0) for job in wanted if job not in missing)
    context = get_context("spawn")  # a process that has started Prolog cannot be forked
    with ProcessPoolExecutor(processes, context) as executor:
        try:
            futures = {executor.submit(_run, job): job for job in missing}
            for future in as_completed(futures):
                failure, seconds = future.result()
                if failure:
                    raise NppgError(failure)
                yield futures[future], seconds
        except BaseException:
            executor.shutdown(wait=False, cancel_futures=True)
            raise


def available_cores() -> int:
    """Those that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _run(job: Job) -> tuple[str, float]:
    """Does a run, in a process of its own: what went wrong, and the seconds."""
    begin = time.perf_counter()
    try:
        with interruptible():
            _learn(job)
    except NppgError as error:
        return str(error), 0.0
    return "", time.perf_counter() - begin


def _learn(job: Job) -> None:
    experiment = job.experiment
    domain, bias = _prepared(experiment.domain, tuple(sorted(job.parameters.items())))
    probe = PROBES[experiment.probe](domain, experiment)
    found: list[dict[str, float]] = []

    def look(progress: Progress) -> None:
        found.extend(probe.seen(progress))
        if progress.ended:
            replacing(job.folder / _TESTS, lambda path: _write(found, path))

    run(domain, bias, job.options, job.folder, experiment.every, experiment.starts, look, space=probe.space)


@functools.cache
def _domain(name: str, parameters: tuple) -> Domain:
    return Domain(name, dict(parameters))


@functools.cache
def _prepared(name: str, parameters: tuple) -> tuple[Domain, LanguageBias]:
    """What the runs of a process share."""
    return _domain(name, parameters), LanguageBias.load(locate(name, "language_bias", ".yaml"))


def _write(rows: list[dict[str, float]], path: Path) -> None:
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
