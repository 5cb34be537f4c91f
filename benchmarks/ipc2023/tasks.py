"""The competition's files: domains, training and testing problems, and the cheapest cost known of each."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

DOMAINS = (
    "ferry", "miconic", "spanner", "blocksworld", "childsnack", "satellite", "transport", "rovers", "floortile", "sokoban",
)  # fmt: skip
LEVELS = ("easy", "medium")


@dataclass(frozen=True)
class Task:
    """A testing problem."""

    domain: str
    level: str
    problem: str
    path: Path

    @property
    def name(self) -> dict[str, str]:
        """What tells it from the others, in results."""
        return {"domain": self.domain, "level": self.level, "problem": self.problem}


def tasks(data: Path, domain: str, level: str, most: int | None = None) -> list[Task]:
    """A level's testing problems (the first `most`), in order of their numbers, so from small to large."""
    files = sorted((data / domain / "testing" / level).glob("*.pddl"))
    return [Task(domain, level, file.stem, file) for file in files[:most]]


def training(data: Path, domain: str) -> list[Path]:
    """The training problems."""
    return sorted((data / domain / "training").glob("**/*.pddl"))


def references(data: Path) -> Iterator[dict[str, str | float]]:
    """A line for each testing problem with the cheapest cost known, as results have it."""
    for file, cost in json.loads((data / "reference.json").read_text()).items():
        domain, _, level, problem = Path(file).with_suffix("").parts
        yield {"part": "reference", "domain": domain, "level": level, "problem": problem, "cost": cost}
