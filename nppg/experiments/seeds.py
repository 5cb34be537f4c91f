"""The same training with several seeds: its runs, and one curve of their means and standard deviations."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from nppg.bridge.files import replacing
from nppg.errors import NppgError, Problem
from nppg.experiments import drawing
from nppg.experiments.figures.common import moments, write_csv
from nppg.experiments.jobs import Job
from nppg.experiments.progress import MEASURES, measured, title

_COLUMNS = tuple(name for names in MEASURES.values() for name in names)


def with_seeds(job: Job, seeds: Iterable[int]) -> list[Job]:
    """The job with these seeds, each in a folder seed-N within the job's. Raises NppgError where that is the folder of
    a run, whose curve would be lost."""
    if (job.folder / "run.json").exists():
        message = "this is the folder of another run: write into another one"
        raise NppgError([Problem(str(job.folder), 0, 0, message)])
    return [
        replace(job, options=replace(job.options, seed=seed), folder=job.folder / f"seed-{seed}") for seed in seeds
    ]


def rows(finished: Sequence[Job]) -> list[dict[str, float]]:
    """For each episode that the runs were judged after, how many of them had got there, and the moments of what they
    were judged by. One that has ended before keeps its last value."""
    return averaged([{job.due(float(point["episode"])): point for point in job.curve()} for job in finished])


def averaged(curves: Sequence[Mapping[float, Mapping[str, Any]]]) -> list[dict[str, float]]:
    """The same of curves, points by episode."""
    known = [sorted(curve) for curve in curves]
    found = []
    for episode in sorted(set().union(*known)):
        row: dict[str, float] = {"episode": episode, "runs": sum(own[-1] >= episode for own in known)}
        here = [curve[own[max(bisect_right(own, episode) - 1, 0)]] for curve, own in zip(curves, known, strict=True)]
        for name in _COLUMNS:
            if all(point[name] for point in here):
                row |= moments(name, [float(point[name]) for point in here])
        found.append(row)
    return found


def write(finished: Sequence[Job], output: Path) -> list[str]:
    """Writes curve.csv and, with matplotlib, curve.png. Returns their names."""
    found, picture = rows(finished), output / "curve.png"
    replacing(output / "curve.csv", lambda path: write_csv(found, path))
    if _draw(finished, found, picture):
        return ["curve.csv", picture.name]
    picture.unlink(missing_ok=True)
    return ["curve.csv"]


def summary(finished: Sequence[Job]) -> str:
    """What they have come to, in one line."""
    name, last = measured(finished[0].domain, finished[0].judging), rows(finished)[-1]
    stochastic, greedy = (f"{last[f'{each}_mean']:.4f} ± {last[f'{each}_sd']:.4f}" for each in MEASURES[name])
    return f"{len(finished)} runs: {name} {stochastic}, greedy {greedy}{_early(finished, last)}"


def _early(finished: Sequence[Job], last: dict[str, float]) -> str:
    early = len(finished) - int(last["runs"])
    return f"; {early} ended before episode {last['episode']:.0f} and keep their last value" if early else ""


def _draw(finished: Sequence[Job], found: list[dict[str, float]], path: Path) -> bool:
    """Whether matplotlib is there to draw the curve."""
    pyplot = drawing.pyplot()
    if pyplot is None:
        return False
    job = finished[0]
    name = measured(job.domain, job.judging)
    episodes = [row["episode"] for row in found]
    figure, axes = pyplot.subplots(figsize=(9, 4), layout="constrained")
    for number, (column, policy) in enumerate(zip(MEASURES[name], ("stochastic", "greedy"), strict=True)):
        middle, spread = (np.array([row[f"{column}_{moment}"] for row in found]) for moment in ("mean", "sd"))
        axes.plot(episodes, middle, color=f"C{number}", label=f"{policy} policy")
        axes.fill_between(episodes, middle - spread, middle + spread, color=f"C{number}", alpha=0.15, linewidth=0)
    what = f"{title(job.domain)}, {job.options.learner}: mean and standard deviation of {len(finished)} runs"
    drawing.save_curve(figure, axes, name, what + _early(finished, found[-1]), path)
    pyplot.close(figure)
    return True
