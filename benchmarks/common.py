"""What the benchmarks share: rows of the table, random examples, a clock, a memory gauge."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State


class Row(NamedTuple):
    """A line of the table. `met` says whether the target is; None where there is none."""

    what: str
    measured: str
    compared: str = ""
    target: str = ""
    met: bool | None = None


def timed(function: Callable[[], Any]) -> tuple[float, Any]:
    """The seconds that a call takes, and what it gives."""
    start = time.perf_counter()
    value = function()
    return time.perf_counter() - start, value


def random_pairs(domain: Domain, states: int, rng: np.random.Generator) -> list[tuple[State, list[Action]]]:
    """Start states, each with its legal actions."""
    return [(state, domain.situation(state).actions) for state in (domain.start(rng) for _ in range(states))]


def peak() -> int:
    """The most memory that this process has held, in KiB.

    Linux hands getrusage's figure on from the process that started this one; /proc has this one's own.
    """
    status = Path("/proc/self/status")
    if status.exists():
        return next(int(line.split()[1]) for line in status.read_text().splitlines() if line.startswith("VmHWM"))
    import resource

    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most // 1024 if sys.platform == "darwin" else most


def splice(path: Path | None, name: str, text: str) -> None:
    """Replaces what stands between the markers <!-- name --> and <!-- /name --> of a file."""
    if path:
        before, rest = path.read_text().split(f"<!-- {name} -->\n", 1)
        after = rest.split(f"<!-- /{name} -->", 1)[1]
        path.write_text(f"{before}<!-- {name} -->\n{text}\n<!-- /{name} -->{after}")
