"""Where things go in the plane: those with ways between them so that the ways are short, the others side by side."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

Way = tuple[str, str]
Size = tuple[float, float]

_ROUNDS = 200


def needed(ways: Iterable[Way]) -> list[Way]:
    """Ways, without those that go through others, as far as these lead in one direction only: of an order the steps."""
    onwards: dict[str, set[str]] = {}
    for one, other in ways:
        onwards.setdefault(one, set()).add(other)
    both = any(one in onwards.get(other, ()) for one, others in onwards.items() for other in others)
    if both:
        return sorted({(min(one, other), max(one, other)) for one, others in onwards.items() for other in others})
    return sorted(
        (one, other)
        for one, others in onwards.items()
        for other in others
        if not any(other in onwards.get(between, ()) for between in others)
    )


def component(ways: Sequence[Way]) -> list[str]:
    """The names of the largest part that hangs together, in order."""
    beside: dict[str, set[str]] = {}
    for one, other in ways:
        beside.setdefault(one, set()).add(other)
        beside.setdefault(other, set()).add(one)
    best: set[str] = set()
    left = set(beside)
    while left:
        found, unread = set(), [min(left)]
        while unread:
            name = unread.pop()
            if name not in found:
                found.add(name)
                unread += beside[name]
        left -= found
        best = max(best, found, key=len)
    return sorted(best)


def placed(names: Sequence[str], ways: Sequence[Way], sizes: Mapping[str, Size]) -> dict[str, tuple[float, float]]:
    """The middles of boxes of these sizes, which all hang together by ways: by classical scaling of the lengths of ways
    (Torgerson 1952); then they are pushed apart until none lies on another."""
    extents = np.array([sizes[name] for name in names])
    points = _scaled(names, ways) * (0.9 * extents.mean(axis=0) + 0.4)
    for _ in range(_ROUNDS):
        moved = False
        for i in range(len(names)):
            apart = points - points[i]
            room = (extents + extents[i]) / 2 - np.abs(apart)
            for j in np.flatnonzero((room > 1e-9).all(axis=1)):
                if j != i:
                    axis = int(room[j, 1] < room[j, 0])
                    push = room[j, axis] / 2 * (1 if apart[j, axis] > 0 or (apart[j, axis] == 0 and j > i) else -1)
                    points[j, axis] += push
                    points[i, axis] -= push
                    apart = points - points[i]
                    moved = True
        if not moved:
            break
    return {name: (float(x), float(y)) for name, (x, y) in zip(names, points, strict=True)}


def rows(names: Sequence[str], sizes: Mapping[str, Size], gap: float, wide: float) -> dict[str, tuple[float, float]]:
    """The middles of the lower edges of boxes in rows, downwards from 0, each `wide` at most if it has several."""
    found: dict[str, tuple[float, float]] = {}
    row: list[str] = []
    across = down = 0.0

    def close() -> None:
        nonlocal row, across, down
        tall = max((sizes[name][1] for name in row), default=0.0)
        at = 0.0
        down -= tall
        for name in row:
            found[name] = at + sizes[name][0] / 2, down
            at += sizes[name][0] + gap
        down -= gap
        row, across = [], 0.0

    for name in names:
        if row and across + sizes[name][0] > wide:
            close()
        row.append(name)
        across += sizes[name][0] + gap
    close()
    return found


def _scaled(names: Sequence[str], ways: Sequence[Way]) -> np.ndarray:
    """Points whose distances are near the numbers of ways between these, shape (names, 2)."""
    number = {name: i for i, name in enumerate(names)}
    far = np.full((len(names), len(names)), np.inf)
    np.fill_diagonal(far, 0.0)
    for one, other in ways:
        if one in number and other in number:
            far[number[one], number[other]] = far[number[other], number[one]] = 1.0
    for k in range(len(names)):
        far = np.minimum(far, far[:, k : k + 1] + far[k])
    squared = far**2
    centred = -0.5 * (squared - squared.mean(0) - squared.mean(1)[:, None] + squared.mean())
    values, vectors = np.linalg.eigh(centred)
    points = vectors[:, [-1, -2]] * np.sqrt(np.maximum(values[[-1, -2]], 0.0))
    signs = np.sign(points[np.abs(points).argmax(axis=0), [0, 1]])
    return points * np.where(signs == 0, 1.0, signs)
