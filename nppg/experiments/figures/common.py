"""What the figures share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from statistics import mean, pstdev
from typing import Any

from nppg.experiments.reproduce import Job


def at(job: Job, episode: float) -> int:
    """The test that a point of the curve belongs to: policy gradients are tested with the next tree behind it."""
    return int(episode) // job.experiment.every * job.experiment.every


def grouped(rows: Iterable[Any], key: Callable) -> dict[Any, list]:
    found: dict[Any, list] = {}
    for row in rows:
        found.setdefault(key(row), []).append(row)
    return found


def moments(name: str, values: Sequence[float]) -> dict[str, float]:
    return {f"{name}_mean": mean(values), f"{name}_sd": pstdev(values)}
