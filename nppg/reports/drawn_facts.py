"""States of a world that draws none, as shapes: a box for each object, on or in the one where it is.

Objects that are mostly in nothing have their places, where they are in every state; what is in nothing for a while is
told in a row below them. Static facts between places are ways.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from nppg.bridge.terms import Ground
from nppg.reports.forest import Forest, Places
from nppg.reports.spread import Size, Way, component, needed, placed, rows
from nppg.worlds.shapes import Shape

_MOST = 100  # objects, above which those that nothing happens to are left out
_LOOKED_AT = 200  # states, for the sizes of places
_CHARACTER = 0.17  # the width of one
_LINE = 0.34
_GAP = 0.18
_ACROSS = 5  # objects in a row
_ROW = 16  # towers that stand in one row
_DENSE = 3.0  # ways to a place, above which they say nothing about where it is


class FactsDrawing:
    """Draws the states of some episodes in one world."""

    def __init__(self, states: Sequence[Sequence[Ground]], static: Iterable[Ground], wanted: Iterable[str] = ()):
        names = set(wanted)
        facts = [each for each in static if isinstance(each, tuple)]
        self._goals = [each for each in facts if each[0] in names]
        some = states[:: max(1, len(states) // _LOOKED_AT)]
        self._places = Places(some, names)
        self._only: set[str] | None = None
        forests = [self._forest(state) for state in some]
        objects = {name for forest in forests for name in forest.parents}
        if len(objects) > _MOST:
            self._only = self._places.moved
            forests = [self._forest(state) for state in some]
        self._left_out = len(objects - {name for forest in forests for name in forest.parents})
        sizes: dict[str, Size] = {}
        counts: dict[str, int] = {}
        inside: set[str] = set()
        for forest in forests:
            held = _held(forest)
            inside |= {name for name, below in forest.parents.items() if below is not None}
            for name, below in forest.parents.items():
                if below is None:
                    own = _whole_size(forest, held, name)
                    old = sizes.get(name, (0.0, 0.0))
                    sizes[name] = max(own[0], old[0]), max(own[1], old[1])
                    counts[name] = counts.get(name, 0) + 1
        lasting = {name for name, count in counts.items() if 2 * count > len(forests) or name in self._places.based}
        self._ways = self._ways_among(facts, names, lasting, inside)
        self._at = self._spread(lasting, sizes)
        self._low = min((y for _, y in self._at.values()), default=0.0) - _GAP
        self._left = min((x - sizes[name][0] / 2 for name, (x, _) in self._at.items()), default=0.0)
        self._wide = max((x + sizes[name][0] / 2 for name, (x, _) in self._at.items()), default=8.0) - self._left

    def _forest(self, state: Iterable[Ground]) -> Forest:
        return self._places.forest([*state, *self._goals], self._only)

    @staticmethod
    def _ways_among(facts: Sequence[tuple], wanted: set[str], lasting: set[str], inside: set[str]) -> list[Way]:
        """The static facts between places, of predicates that say it of no thing that is in one, nor of all pairs."""
        found: dict[str, set[Way]] = {}
        for fact in facts:
            if len(fact) == 3 and fact[0] not in wanted and fact[1] != fact[2]:
                found.setdefault(fact[0], set()).add((fact[1], fact[2]))
        ways: list[Way] = []
        for pairs in found.values():
            known = {name for pair in pairs for name in pair}
            if inside & known or not lasting & known:
                continue
            own = needed(each for each in pairs if all(isinstance(name, str) for name in each))
            if 0 < len(own) <= _DENSE * len({name for way in own for name in way}) and len(own) <= 4 * _MOST:
                ways += own
        return sorted(set(ways))

    def _spread(self, lasting: set[str], sizes: dict[str, Size]) -> dict[str, tuple[float, float]]:
        """The middle of the lower edge of each place."""
        on_ways = component(self._ways)
        on_ways = on_ways if len(on_ways) > 2 else []
        self._ways = [way for way in self._ways if way[0] in on_ways]
        for name in on_ways:
            sizes.setdefault(name, (max(0.8, len(name) * _CHARACTER + _GAP), _LINE + _GAP))
        roomy = {name: (size[0] + 2 * _GAP, size[1] + 2 * _GAP) for name, size in sizes.items()}
        found: dict[str, tuple[float, float]] = {}
        if on_ways:
            middles = placed(on_ways, self._ways, roomy)
            found = {name: (x, y - sizes[name][1] / 2) for name, (x, y) in middles.items()}
        left = min((x - sizes[name][0] / 2 for name, (x, _) in found.items()), default=0.0)
        low = min((y for _, y in found.values()), default=0.0) - (2 * _GAP if found else 0.0)
        others = sorted(lasting - set(on_ways), key=natural)
        area = sum(roomy[name][0] * roomy[name][1] for name in others)
        wide = max(max((x for x, _ in found.values()), default=0.0) - left, 1.6 * area**0.5)
        if len(others) <= _ROW and set(others) <= self._places.based:
            wide = math.inf
        for name, (x, y) in rows(others, roomy, 0.0, wide).items():
            found[name] = left + x, low + y
        return found

    def shapes(self, state: Iterable[Ground]) -> list[Shape]:
        """One of the states."""
        forest = self._forest(state)
        held = _held(forest)
        found: list[Shape] = []
        for one, other in self._ways:
            (x1, y1), (x2, y2) = self._at[one], self._at[other]
            found.append(("line", _r(x1), _r(y1 + 0.25), _r(x2), _r(y2 + 0.25), "faint"))
        for root, (x, y) in self._at.items():
            if forest.parents.get(root) is None and (self._only is None or root in forest.parents):
                self._draw(forest, held, root, x, y, found)
        others = [name for name, below in forest.parents.items() if below is None and name not in self._at]
        sizes = {name: _whole_size(forest, held, name) for name in others}
        low = self._low
        for name, (x, y) in rows(sorted(others, key=natural), sizes, _GAP, self._wide).items():
            self._draw(forest, held, name, self._left + x, self._low + y, found)
            low = min(low, self._low + y)
        left_out = [f"{self._left_out} objects that nothing happens to are left out"] * bool(self._left_out)
        for i, text in enumerate([*forest.loose[:8], *left_out]):
            y = low - (i + 1) * _LINE - _GAP
            found.append(("box", _r(self._left), _r(y), _r(len(text) * _CHARACTER), _LINE, "note", text))
        return found

    def _draw(
        self, forest: Forest, held: dict[str, list[str]], name: str, x: float, y: float, found: list[Shape]
    ) -> None:
        """Adds an object, the middle of whose lower edge this is, with what is in it and on it."""
        width, height = _own_size(forest, held, name)
        on_top = [each for each in held.get(name, ()) if each in forest.stacked]
        if len(on_top) > 1:
            width = _whole_size(forest, held, name)[0]
        tone = self._places.kinds[name] % 6 + 1 if name in self._places.kinds else "place"
        top = y + height
        found.append(("box", _r(x - width / 2), _r(y), _r(width), _r(height), tone, ""))
        for i, text in enumerate([name, *forest.notes.get(name, ())]):
            line = top - _GAP / 2 - (i + 1) * _LINE
            found.append(("box", _r(x - width / 2), _r(line), _r(width), _LINE, "note" if i else "bare", text))
        top -= _GAP / 2 + (1 + len(forest.notes.get(name, ()))) * _LINE
        for row in _rows([each for each in held.get(name, ()) if each not in forest.stacked]):
            top -= max(_whole_size(forest, held, each)[1] for each in row) + _GAP / 2
            self._beside(forest, held, row, x, top, found)
        self._beside(forest, held, on_top, x, y + height, found)

    def _beside(
        self, forest: Forest, held: dict[str, list[str]], row: Sequence[str], x: float, y: float, found: list[Shape]
    ) -> None:
        sizes = [_whole_size(forest, held, each) for each in row]
        at = x - (sum(size[0] for size in sizes) + _GAP * (len(row) - 1)) / 2
        for each, size in zip(row, sizes, strict=True):
            self._draw(forest, held, each, at + size[0] / 2, y, found)
            at += size[0] + _GAP


def _held(forest: Forest) -> dict[str, list[str]]:
    """What is in or on each object."""
    found: dict[str, list[str]] = {}
    for name, below in sorted(forest.parents.items(), key=lambda each: natural(each[0])):
        if below is not None:
            found.setdefault(below, []).append(name)
    return found


def _whole_size(forest: Forest, held: dict[str, list[str]], name: str) -> Size:
    """How wide and high an object is with all that is in it and on it."""
    width, height = _own_size(forest, held, name)
    on_top = [_whole_size(forest, held, each) for each in held.get(name, ()) if each in forest.stacked]
    if on_top:
        width = max(width, sum(size[0] for size in on_top) + _GAP * (len(on_top) - 1))
        height += max(size[1] for size in on_top)
    return width, height


def _own_size(forest: Forest, held: dict[str, list[str]], name: str) -> Size:
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


def natural(name: str) -> tuple[str, int, str]:
    """By what names are to be sorted: b2 before b10."""
    digits = name[len(name.rstrip("0123456789")) :]
    return name[: len(name) - len(digits)], int(digits[:12] or 0), name


def _r(value: float) -> float:
    return round(float(value), 3)
