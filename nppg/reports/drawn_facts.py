"""States of a world that draws none, as shapes: a box for each object, on or in the one where it is.

What has no place is put side by side, or, where static facts are ways between such, so that the ways are short
(classical scaling of their lengths: Torgerson 1952).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from nppg.bridge.terms import Ground
from nppg.reports.forest import Forest, Places
from nppg.worlds.shapes import Shape

_MOST = 100  # objects, above which those that nothing happens to are left out
_LOOKED_AT = 200  # states, for the sizes of places
_CHARACTER = 0.17  # the width of one
_LINE = 0.34
_GAP = 0.18
_ACROSS = 5  # objects in a row
_WAYS = 400


class FactsDrawing:
    """Draws the states of some episodes in one world, each object of the lowest level at the same place in all."""

    def __init__(self, states: Sequence[Sequence[Ground]], static: Iterable[Ground], wanted: Iterable[str] = ()):
        self._wanted = set(wanted)
        self._goals = [each for each in static if isinstance(each, tuple) and each[0] in self._wanted]
        some = states[:: max(1, len(states) // _LOOKED_AT)]
        self._places = Places(some, self._wanted)
        forests = [self._places.forest([*state, *self._goals]) for state in some]
        objects = {name for forest in forests for name in forest.parents}
        self._only = self._places.moved if len(objects) > _MOST else None
        if self._only is not None:
            forests = [self._places.forest([*state, *self._goals], self._only) for state in some]
        self._left_out = len(objects) - len({name for forest in forests for name in forest.parents})
        roots = sorted({name for each in forests for name, below in each.parents.items() if below is None}, key=_natural)
        sizes = [_size(forest, root) for forest in forests for root in forest.parents if forest.parents[root] is None]
        self._cell = tuple(max((size[i] for size in sizes), default=1.0) + 2 * _GAP for i in range(2))
        self._ways = sorted(
            {
                (min(each[1:]), max(each[1:]))
                for each in static
                if isinstance(each, tuple) and len(each) == 3 and each[0] not in self._wanted
                and each[1] != each[2] and each[1] in roots and each[2] in roots
            }
        )[:_WAYS]
        self._at = self._spread(roots)

    def _spread(self, roots: list[str]) -> dict[str, tuple[float, float]]:
        """The middle of the lower edge of each root's place."""
        width, height = self._cell
        on_ways = sorted({name for way in self._ways for name in way}, key=_natural)
        found: dict[str, tuple[float, float]] = {}
        if len(on_ways) > 2:
            points = _scaled(on_ways, self._ways)
            apart = min(
                max(abs(a[0] - b[0]) / width, abs(a[1] - b[1]) / height)
                for i, a in enumerate(points)
                for b in points[:i]
            )
            factor = 1 / max(apart, 0.2)
            found = {name: (float(x * factor), float(y * factor)) for name, (x, y) in zip(on_ways, points, strict=True)}
        low = min((y for _, y in found.values()), default=0.0) - (height if found else 0.0)
        left = min((x for x, _ in found.values()), default=0.0)
        others = [name for name in roots if name not in found]
        across = max(1, round((len(others) * 2.2 * height / width) ** 0.5))
        for i, name in enumerate(others):
            found[name] = left + (i % across) * width, low - (i // across) * height
        return found

    def shapes(self, state: Iterable[Ground]) -> list[Shape]:
        """One of the states."""
        forest = self._places.forest([*state, *self._goals], self._only)
        held = _held(forest)
        found: list[Shape] = []
        for one, other in self._ways:
            (x1, y1), (x2, y2) = self._at[one], self._at[other]
            found.append(("line", _r(x1), _r(y1 + 0.3), _r(x2), _r(y2 + 0.3), "faint"))
        for root, (x, y) in self._at.items():
            if forest.parents.get(root, root) is None:
                self._draw(forest, held, root, x, y, found)
        loose = [*forest.loose, *([f"{self._left_out} objects that nothing happens to are left out"] * bool(self._left_out))]
        low = min((y for _, y in self._at.values()), default=0.0)
        left = min((x for x, _ in self._at.values()), default=0.0)
        for i, text in enumerate(loose[:8]):
            found.append(("box", _r(left), _r(low - (i + 2) * _LINE), _r(len(text) * _CHARACTER), _LINE, "bare", text))
        return found

    def _draw(
        self, forest: Forest, held: dict[str, list[str]], name: str, x: float, y: float, found: list[Shape]
    ) -> None:
        width, height = _own_size(forest, held, name)
        on_top = [each for each in held.get(name, ()) if each in forest.stacked]
        if len(on_top) > 1:
            width = _whole_size(forest, held, name)[0]
        tone = self._places.kinds[name] % 6 + 1 if name in self._places.kinds else "place"
        left, top = x - width / 2, y + height
        inside = [each for each in held.get(name, ()) if each not in forest.stacked]
        found.append(("box", _r(left), _r(y), _r(width), _r(height), tone, ""))
        for i, text in enumerate([name, *forest.notes.get(name, ())]):
            kind = "bare" if i == 0 else "note"
            found.append(("box", _r(left), _r(top - _GAP / 2 - (i + 1) * _LINE), _r(width), _LINE, kind, text))
        top -= _GAP / 2 + (1 + len(forest.notes.get(name, ()))) * _LINE
        for row in _rows(inside):
            sizes = [_whole_size(forest, held, each) for each in row]
            tall = max(size[1] for size in sizes)
            at = x - (sum(size[0] for size in sizes) + _GAP * (len(row) - 1)) / 2
            top -= tall + _GAP / 2
            for each, size in zip(row, sizes, strict=True):
                self._draw(forest, held, each, at + size[0] / 2, top, found)
                at += size[0] + _GAP
        sizes = [_whole_size(forest, held, each) for each in on_top]
        at = x - (sum(size[0] for size in sizes) + _GAP * (len(on_top) - 1)) / 2
        for each, size in zip(on_top, sizes, strict=True):
            self._draw(forest, held, each, at + size[0] / 2, y + height, found)
            at += size[0] + _GAP


def _held(forest: Forest) -> dict[str, list[str]]:
    """What is in or on each object."""
    found: dict[str, list[str]] = {}
    for name, below in sorted(forest.parents.items(), key=lambda each: _natural(each[0])):
        if below is not None:
            found.setdefault(below, []).append(name)
    return found


def _size(forest: Forest, name: str) -> tuple[float, float]:
    """How wide and high an object is with all that is in it and on it."""
    return _whole_size(forest, _held(forest), name)


def _whole_size(forest: Forest, held: dict[str, list[str]], name: str) -> tuple[float, float]:
    width, height = _own_size(forest, held, name)
    on_top = [_whole_size(forest, held, each) for each in held.get(name, ()) if each in forest.stacked]
    if on_top:
        width = max(width, sum(size[0] for size in on_top) + _GAP * (len(on_top) - 1))
        height += max(size[1] for size in on_top)
    return width, height


def _own_size(forest: Forest, held: dict[str, list[str]], name: str) -> tuple[float, float]:
    """The same without what is on it."""
    lines = [name, *forest.notes.get(name, ())]
    width, height = max(0.8, max(map(len, lines)) * _CHARACTER + _GAP), len(lines) * _LINE + _GAP
    for row in _rows([each for each in held.get(name, ()) if each not in forest.stacked]):
        sizes = [_whole_size(forest, held, each) for each in row]
        width = max(width, sum(size[0] for size in sizes) + _GAP * (len(row) + 1))
        height += max(size[1] for size in sizes) + _GAP / 2
    return width, height


def _rows(names: Sequence[str]) -> list[Sequence[str]]:
    return [names[i : i + _ACROSS] for i in range(0, len(names), _ACROSS)]


def _scaled(names: Sequence[str], ways: Sequence[tuple[str, str]]) -> np.ndarray:
    """Points in the plane whose distances are near the numbers of ways between these, shape (names, 2)."""
    number = {name: i for i, name in enumerate(names)}
    far = np.full((len(names), len(names)), np.inf)
    np.fill_diagonal(far, 0.0)
    for one, other in ways:
        far[number[one], number[other]] = far[number[other], number[one]] = 1.0
    for k in range(len(names)):
        far = np.minimum(far, far[:, k : k + 1] + far[k])
    far[np.isinf(far)] = far[np.isfinite(far)].max() + 1
    squared = far**2
    centred = -0.5 * (squared - squared.mean(0) - squared.mean(1)[:, None] + squared.mean())
    values, vectors = np.linalg.eigh(centred)
    points = vectors[:, [-1, -2]] * np.sqrt(np.maximum(values[[-1, -2]], 0.01))
    signs = np.sign(points[np.abs(points).argmax(axis=0), [0, 1]])
    return points * signs


def _natural(name: str) -> tuple:
    """b2 before b10."""
    digits = "".join(each for each in name if each.isdigit())
    return name.rstrip("0123456789"), int(digits[:12] or 0), name


def _r(value: float) -> float:
    return round(float(value), 3)
