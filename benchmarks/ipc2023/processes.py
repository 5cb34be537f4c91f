"""Processes with limits, one at a time."""

from __future__ import annotations

import os
import resource
import signal
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

TIME = "time"
MEMORY = "memory"
_THREADS = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}  # of one core
_HERE = {"PYTHONPATH": os.pathsep.join(filter(None, (str(Path(__file__).parents[2]), os.environ.get("PYTHONPATH"))))}


class Ended(NamedTuple):
    """A process that has ended: its exit status, what it wrote, and the seconds of processor time that it used, with
    those that it started."""

    status: int
    output: str
    errors: str
    seconds: float

    @property
    def stopped(self) -> str | None:
        """Which limit stopped it, if one did."""
        if self.status in (-signal.SIGXCPU, -signal.SIGKILL):
            return TIME
        return MEMORY if self.status < 0 or (self.status > 0 and "MemoryError" in self.last) else None

    @property
    def is_mistaken(self) -> bool:
        """Whether neither its work nor a limit ended it."""
        return self.status != 0 and self.stopped is None

    @property
    def last(self) -> str:
        """The last line of its errors, which tells the mistake that ended it."""
        return (self.errors.strip().splitlines() or [f"exit {self.status}"])[-1]


def run(
    command: Sequence[str],
    folder: Path,
    seconds: int | None = None,
    gigabytes: int | None = None,
) -> Ended:
    """Runs a command in a folder. `seconds` of processor time are those of each of its processes."""
    before = _used()

    def limited() -> None:
        if seconds is not None:
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        if gigabytes is not None:
            resource.setrlimit(resource.RLIMIT_AS, (gigabytes << 30, gigabytes << 30))

    with subprocess.Popen(
        command,
        cwd=folder,
        env={**os.environ, **_THREADS, **_HERE},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=limited,
    ) as process:
        try:
            output, errors = process.communicate()
        except BaseException:
            process.terminate()
            raise
    return Ended(process.returncode, output, errors, round(_used() - before, 2))


def _used() -> float:
    """The processor time of all processes that this one has started and that have ended, in seconds."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime
