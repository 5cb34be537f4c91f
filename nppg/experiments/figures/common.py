"""What the figures share."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from statistics import mean, pstdev
from typing import Any


def grouped(rows: Iterable[Any], key: Callable) -> dict[Any, list]:
    found: dict[Any, list] = {}
    for row in rows:
        found.setdefault(key(row), []).append(row)
    return found


def moments(name: str, values: Sequence[float]) -> dict[str, float]:
    return {f"{name}_mean": mean(values), f"{name}_sd": pstdev(values)}


def write_csv(rows: Sequence[dict], path: Path) -> None:
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: f"{x:.6f}" if isinstance(x, float) else x for key, x in row.items()} for row in rows)
