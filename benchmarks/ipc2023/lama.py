"""The planner LAMA, its first iteration, as the package up-fast-downward brings it."""

from __future__ import annotations

import importlib.util
import re
import sys
import tempfile
from pathlib import Path

from benchmarks.ipc2023.processes import MEMORY, TIME, run
from benchmarks.ipc2023.results import Line
from benchmarks.ipc2023.tasks import SOLVED, Setting

PART = "lama"
_ENDED = {0: SOLVED, 21: TIME, 23: TIME, 24: TIME, 20: MEMORY, 22: MEMORY}  # by the driver's exit codes
_MISTAKES = (31, 33, 34, 35, 36, 37)
_COST = re.compile(r"^; cost = (\d+)", re.MULTILINE)


def plan_all(setting: Setting, domain: str) -> None:
    """Plans for each problem that has no result yet."""
    limits = setting.seconds, setting.gigabytes
    setting.attempt_all(PART, domain, lambda task, _: plan(setting.domain(domain), task.path, *limits))


def plan(domain: Path, problem: Path, seconds: int, gigabytes: int) -> Line:
    """Whether it was solved, what it ended with, the plan's cost, and the seconds of processor time, which the limit is
    about: translation and search together. Raises RuntimeError where the planner does not take the files."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            *(sys.executable, str(driver()), "--alias", "lama-first", "--plan-file", "plan"),
            # which gives the search what is left, rounded down to whole seconds
            *("--overall-time-limit", f"{seconds + 1}s", "--overall-memory-limit", f"{gigabytes}G"),
            *(str(domain.resolve()), str(problem.resolve())),
        ]
        done = run(command, Path(folder))
        plan = Path(folder, "plan").read_text() if done.status == 0 else ""
    if done.status in _MISTAKES:
        raise RuntimeError(f"{problem}: the planner ended with {done.status}\n{done.output[-2000:]}{done.errors}")
    ended = _ENDED.get(done.status, f"exit {done.status}") if done.seconds <= seconds else TIME
    cost = int(_COST.findall(plan)[-1]) if ended == SOLVED else None
    return {"solved": ended == SOLVED, "ended": ended, "cost": cost, "seconds": done.seconds}


def driver() -> Path:
    """Raises RuntimeError where the package is not there."""
    found = importlib.util.find_spec("up_fast_downward")
    if found is None or found.origin is None:
        raise RuntimeError("LAMA is in the package up-fast-downward: pip install 'nppg[fast-downward]'")
    return Path(found.origin).with_name("downward") / "fast-downward.py"

