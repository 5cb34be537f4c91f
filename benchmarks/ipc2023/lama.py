"""The planner LAMA, its first iteration, as the package up-fast-downward brings it."""

from __future__ import annotations

import importlib.util
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

from benchmarks.ipc2023.results import Line, Results
from benchmarks.ipc2023.tasks import LEVELS, tasks

PART = "lama"
SOLVED = "solved"
NOT_RUN = "not run"
_ENDED = {0: SOLVED, 21: "time", 23: "time", 24: "time", 20: "memory", 22: "memory"}  # by the driver's exit codes
_MISTAKES = (31, 33, 34, 35, 36, 37)
_COST = re.compile(r"^; cost = (\d+)", re.MULTILINE)


def plan_all(
    data: Path, domain: str, results: Results, seconds: int, gigabytes: int, give_up: int, most: int | None = None
) -> None:
    """Plans for each problem that has no result yet. After `give_up` problems of a level in a row without a plan the
    rest, which are larger, are recorded as not run."""
    for level in LEVELS:
        failed = 0
        for task in tasks(data, domain, level, most):
            key = {"part": PART, **task.name}
            line = results.get(**key)
            if line is None:
                if failed < give_up:
                    found = plan(data / domain / "domain.pddl", task.path, seconds, gigabytes)
                else:
                    found = {"solved": False, "ended": NOT_RUN, "cost": None, "seconds": None}
                line = results.add({**key, **found, "limit": seconds, "gigabytes": gigabytes})
                print(*task.name.values(), line["ended"], line["cost"], line["seconds"], flush=True)
            failed = 0 if line["solved"] else failed + 1


def plan(domain: Path, problem: Path, seconds: int, gigabytes: int) -> Line:
    """Whether it was solved, what it ended with, the plan's cost, and the seconds of processor time, which the limit is
    about: translation and search together. Raises RuntimeError where the planner does not take the files."""
    before = _used()
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [
                *(sys.executable, str(driver()), "--alias", "lama-first", "--plan-file", "plan"),
                # which gives the search what is left, rounded down to whole seconds
                *("--overall-time-limit", f"{seconds + 1}s", "--overall-memory-limit", f"{gigabytes}G"),
                *(str(domain.resolve()), str(problem.resolve())),
            ],
            cwd=folder,
            capture_output=True,
            text=True,
        )
        plan = Path(folder, "plan").read_text() if done.returncode == 0 else ""
    if done.returncode in _MISTAKES:
        raise RuntimeError(f"{problem}: the planner ended with {done.returncode}\n{done.stdout[-2000:]}{done.stderr}")
    used = round(_used() - before, 2)
    ended = _ENDED.get(done.returncode, f"exit {done.returncode}") if used <= seconds else "time"
    cost = int(_COST.findall(plan)[-1]) if ended == SOLVED else None
    return {"solved": ended == SOLVED, "ended": ended, "cost": cost, "seconds": used}


def driver() -> Path:
    """Raises RuntimeError where the package is not there."""
    found = importlib.util.find_spec("up_fast_downward")
    if found is None or found.origin is None:
        raise RuntimeError("LAMA is in the package up-fast-downward: pip install 'nppg[fast-downward]'")
    return Path(found.origin).with_name("downward") / "fast-downward.py"


def _used() -> float:
    """The processor time of all processes that this one has started and that have ended, in seconds."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime
