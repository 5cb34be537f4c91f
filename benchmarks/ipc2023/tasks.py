"""The competition's files, what is to be done with them, and within which limits."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.ipc2023.results import Line, Results

DOMAINS = (
    "ferry", "miconic", "spanner", "blocksworld", "childsnack", "satellite", "transport", "rovers", "floortile",
    "sokoban",
)  # fmt: skip
LEVELS = ("easy", "medium")
SOLVED = "solved"
_NOT_RUN: Line = {"solved": False, "ended": "not run", "cost": None, "seconds": None}


@dataclass(frozen=True)
class Task:
    """A testing problem: its file, and what tells it from the others in results."""

    path: Path
    domain: str
    level: str

    @property
    def name(self) -> dict[str, str]:
        return {"domain": self.domain, "level": self.level, "problem": self.path.stem}


@dataclass(frozen=True)
class Setting:
    """Where the competition's files are and results go; of processor time the `seconds` for a problem, for learning a
    domain and for distilling its rules; the memory for a problem; how many problems of a level; and after how many
    unsolved ones in a row whoever solves them gives up."""

    data: Path
    results: Results
    seconds: int
    gigabytes: int
    learn_seconds: int
    distill_seconds: int
    give_up: int
    most: int | None

    def domain(self, name: str) -> Path:
        """The domain's file."""
        return self.data / name / "domain.pddl"

    def training(self, domain: str) -> list[Path]:
        """The training problems, relative to the data."""
        return sorted(file.relative_to(self.data) for file in (self.data / domain / "training").glob("**/*.pddl"))

    def tasks(self, domain: str, level: str) -> list[Task]:
        """The level's testing problems in order of their numbers, so from small to large."""
        files = sorted((self.data / domain / "testing" / level).glob("*.pddl"))
        return [Task(file.resolve(), domain, level) for file in files[: self.most]]

    def attempt_all(self, part: str, domain: str, attempt: Callable[[Task, Line], Line | None], **key: Any) -> None:
        """Has each of a domain's problems attempted that has no result yet. `attempt` is told what results begin with,
        and gives the rest, or None where a mistake leaves it to the next time. Where it gives up, what follows, which
        are larger problems, is recorded as not run."""
        failed = 0
        for task in (task for level in LEVELS for task in self.tasks(domain, level)):
            known = {"part": part, **task.name, **key}
            line = self.results.get(**known)
            if line is None:
                found = attempt(task, known) if failed < self.give_up else _NOT_RUN
                if found is None:
                    continue
                line = self.results.add({**known, **found, "limit": self.seconds, "gigabytes": self.gigabytes})
                print(*known.values(), line["ended"], line["cost"], line["seconds"], flush=True)
            failed = 0 if line["solved"] else failed + 1

    def folder(self, domain: str, seed: int) -> Path:
        """Where a run's files are."""
        return self.results.folder.resolve() / domain / f"seed-{seed}"


def references(data: Path) -> Iterator[Line]:
    """A line for each testing problem with the lowest cost known, as results have it."""
    for file, cost in json.loads((data / "reference.json").read_text()).items():
        domain, _, level, problem = Path(file).with_suffix("").parts
        yield {"part": "reference", "domain": domain, "level": level, "problem": problem, "cost": cost}
