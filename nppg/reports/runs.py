"""What report and curves are about: the folders of runs, read with suspicion, for anybody may have written them."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nppg.errors import NppgError, Problem
from nppg.experiments.progress import MEASURES
from nppg.experiments.run_files import summary_of
from nppg.experiments.seeds import averaged
from nppg.reports.chart import Line

_OWN = ("seed", "episodes")  # options that do not make another experiment of a run


@dataclass(frozen=True)
class Run:
    """A folder with what its run.json says, and the points of its curve."""

    folder: Path
    summary: Mapping[str, Any]
    curve: Sequence[Mapping[str, str]]

    @property
    def options(self) -> Mapping[str, Any]:
        """Of its learner."""
        return _mapping(self.summary.get("options"))

    @property
    def domain(self) -> Mapping[str, Any]:
        """The file, its hash and the parameters."""
        return _mapping(self.summary.get("domain"))

    @property
    def learner(self) -> str:
        """By name."""
        return str(self.summary.get("learner", "nppg"))

    @property
    def measure(self) -> str:
        """What it is judged by, as far as its files tell."""
        judging = _mapping(self.summary.get("curve"))
        returns = [point.get("mean_return") for point in self.curve]
        wanted = judging.get("until_return") is not None
        never = all(_number(point.get("success")) in (None, 0.0) for point in self.curve)
        return "return" if returns and all(returns) and (wanted or never) else "success"

    @property
    def merit(self) -> float:
        """The last value of its greedy policy."""
        name = MEASURES[self.measure][1]
        values = [_number(point.get(name)) for point in self.curve]
        return values[-1] if values and values[-1] is not None else -math.inf

    @property
    def title(self) -> str:
        """The domain with its parameters."""
        name = Path(str(self.domain.get("file", self.folder.name))).stem
        parameters = ", ".join(f"{key} = {value}" for key, value in _mapping(self.domain.get("parameters")).items())
        return f"{name} ({parameters})" if parameters else name


def runs_in(folders: Sequence[Path]) -> list[Run]:
    """The runs in these folders: each the folder of a run, or of several; files are left out. Raises NppgError where
    there is none in a folder."""
    found: dict[Path, Run] = {}
    for folder in folders:
        for each in _folders(folder) if not folder.is_file() else ():
            found.setdefault(each.resolve(), _read(each))
    return list(found.values())


def _folders(folder: Path) -> list[Path]:
    if (folder / "run.json").is_file():
        return [folder]
    if not folder.is_dir():
        raise _wrong(folder, "there is no such folder: name one that nppg train has written, or a model file")
    inside = sorted((each.parent for each in folder.glob("*/run.json")), key=_by_number)
    if not inside:
        raise _wrong(folder, "is no folder of a run: neither it nor a folder in it has a run.json")
    return inside


def _by_number(folder: Path) -> tuple[int, str]:
    digits = "".join(each for each in folder.name if each.isdigit())
    return int(digits[:9] or 0), folder.name


def _read(folder: Path) -> Run:
    return Run(folder, summary_of(folder), _points(folder / "curve.csv"))


def _points(file: Path) -> list[dict[str, str]]:
    if not file.is_file():
        return []
    try:
        with file.open(newline="", encoding="utf-8") as source:
            found = list(csv.DictReader(source))
    except (OSError, ValueError, csv.Error) as error:
        raise _wrong(file, f"cannot be read: {error}") from None
    for number, point in enumerate(found, 2):
        for name in ("episode", "success", "greedy_success"):
            if _number(point.get(name)) is None:
                raise NppgError([Problem(str(file), number, 0, f"{point.get(name)!r} is no number for {name}")])
    return found


def experiments(runs: Sequence[Run]) -> Iterator[tuple[str, list[Run]]]:
    """Runs that differ by their seed alone, together, with what tells them from the others."""
    groups: dict[str, list[Run]] = {}
    for run in runs:
        groups.setdefault(json.dumps(_what(run), sort_keys=True, default=str), []).append(run)
    whats = [_what(group[0]) for group in groups.values()]
    differing = [name for name in dict.fromkeys(name for what in whats for name in what) if _differs(name, whats)]
    for what, group in zip(whats, groups.values(), strict=True):
        told = ", ".join(_told(name, what[name]) for name in differing if name in what)
        yield told or group[0].title, group


def _what(run: Run) -> dict[str, Any]:
    options = {name: value for name, value in run.options.items() if name not in _OWN}
    domain = {"domain": Path(str(run.domain.get("file"))).stem, **_mapping(run.domain.get("parameters"))}
    return {**domain, "learner": run.learner, **options, "bias": _mapping(run.summary.get("bias")).get("file")}


def _differs(name: str, whats: Sequence[Mapping[str, Any]]) -> bool:
    return len({json.dumps(what.get(name), default=str) for what in whats}) > 1


def _told(name: str, value: Any) -> str:
    return str(value) if name in ("domain", "learner") else f"{name.replace('_', ' ')} {value}"


def lines_of(groups: Sequence[tuple[str, list[Run]]], measure: str) -> list[Line]:
    """For each group the curve of its stochastic policy and of its greedy one, of runs that have one."""
    found = []
    for colour, (label, group) in enumerate(groups):
        curves = [_due(run) for run in group if run.curve]
        if not curves:
            continue
        rows = averaged(curves)
        for name, policy in zip(MEASURES[measure], ("stochastic", "greedy"), strict=True):
            own = [row for row in rows if f"{name}_mean" in row]
            if own:
                several = f"{len(curves)} runs, " if len(curves) > 1 else ""
                found.append(
                    Line(
                        f"{label}: {several}{policy} policy",
                        colour,
                        policy == "greedy",
                        [row["episode"] for row in own],
                        [row[f"{name}_mean"] for row in own],
                        [row[f"{name}_sd"] for row in own],
                        len(curves),
                    )
                )
    return found


def _due(run: Run) -> dict[float, Mapping[str, str]]:
    """The points by the episodes that they were due after, which are the same in all runs; the last one by its own."""
    every = _mapping(run.summary.get("curve")).get("evaluate_every")
    every = every if isinstance(every, int) and every > 0 else 1
    numbers = [int(float(point["episode"])) for point in run.curve]
    last = run.options.get("episodes", numbers[-1])
    due = (number if number == last else number // every * every for number in numbers)
    return dict(zip(map(float, due), run.curve, strict=True))


def _number(text: object) -> float | None:
    try:
        value = float(str(text))
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def _mapping(value: object) -> Mapping[str, Any]:
    return value if isinstance(value, dict) else {}


def _wrong(path: Path, message: str) -> NppgError:
    return NppgError([Problem(str(path), 0, 0, message)])
