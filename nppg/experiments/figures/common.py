"""What the figures share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from statistics import mean, pstdev
from typing import Any


def grouped(rows: Iterable[Any], key: Callable) -> dict[Any, list]:
    found: dict[Any, list] = {}
    for row in rows:
        found.setdefault(key(row), []).append(row)
    return found


def moments(name: str, values: Sequence[float]) -> dict[str, float]:
    return {f"{name}_mean": mean(values), f"{name}_sd": pstdev(values)}
