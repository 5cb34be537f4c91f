"""What results come to: problems solved, and the competition's quality."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from benchmarks.ipc2023.results import Line, Results

TaskName = tuple[str, str]  # level and problem


@dataclass(frozen=True)
class Score:
    """How one who acts does on a domain's problems: the results by problem, and the lowest cost known of each."""

    lines: Mapping[TaskName, Line]
    references: Mapping[TaskName, float]

    def solved(self, level: str | None = None) -> int:
        """How many problems, of a level."""
        return sum(line["solved"] for line in self.of(level))

    def of(self, level: str | None = None) -> Sequence[Line]:
        """The results of a level, or all."""
        return [line for line in self.lines.values() if level in (None, line["level"])]

    @property
    def straight(self) -> int:
        """How many problems it solved without taking another action than it prefers, because that leads back."""
        return sum(line["solved"] and not line.get("avoided") for line in self.lines.values())

    @property
    def quality(self) -> float:
        """The sum of reference / cost over the problems solved, each at most 1."""
        solved = {name: line["cost"] for name, line in self.lines.items() if line["solved"]}
        return sum(min(1.0, self.references[name] / max(cost, 1)) for name, cost in solved.items())

    @property
    def seconds(self) -> Sequence[float]:
        """What each problem took, of processor time, reading and all."""
        return [line.get("processor", line["seconds"]) or 0.0 for line in self.lines.values()]

    @property
    def failures(self) -> Counter[str]:
        """What stopped it on the others."""
        return Counter(line["ended"] for line in self.lines.values() if not line["solved"])

    def cost_against(self, other: Score) -> float | None:
        """The costs over those of another, summed over what both solve."""
        both = [name for name, line in self.lines.items() if line["solved"] and other.solves(name)]
        theirs = sum(other.lines[name]["cost"] for name in both)
        return sum(self.lines[name]["cost"] for name in both) / theirs if theirs else None

    def solves(self, name: TaskName) -> bool:
        """Whether it does that problem."""
        return name in self.lines and bool(self.lines[name]["solved"])


def scores(results: Results, references: Iterable[Line], part: str, domain: str) -> dict[Any, Score]:
    """Of a part's results on a domain, by seed (None where there are no seeds)."""
    costs = {_task(line): line["cost"] for line in references if line["domain"] == domain}
    found: dict[Any, dict[TaskName, Line]] = {}
    for line in results.lines.values():
        if line["part"] == part and line["domain"] == domain:
            found.setdefault(line.get("seed"), {})[_task(line)] = line
    return {seed: Score(found[seed], costs) for seed in sorted(found, key=str)}


def _task(line: Line) -> TaskName:
    return line["level"], line["problem"]
