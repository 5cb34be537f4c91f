"""A canonical form of fact sets up to the renaming of interchangeable objects.

Facts that share an interchangeable object are connected. Each connected part is put into canonical form on its
own, by colour refinement and, where that leaves objects alike, by trying each of them in turn; the form of the
set is the sorted list of its parts' forms. Exact for every domain; quick where parts are small or irregular, and
where the same parts are met again: they are remembered.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from typing import NamedTuple

from nppg.bridge.terms import Ground
from nppg.logic.query import exact

Form = tuple[int, ...]
Encoded = tuple[int, tuple[Ground, ...]]  # the number of a fact's shape, which is the fact without its objects; those
Numbered = tuple[tuple[int, tuple[int, ...]], ...]  # facts, with the objects numbered in the order of appearance


class _Part(NamedTuple):
    """A connected part: the number of its form, how many objects it has, and how many symmetries."""

    form: int
    objects: int
    symmetries: int


class Canonizer:
    """Canonical forms of fact sets, comparable with each other, in which `objects` may be renamed."""

    def __init__(self, objects: Iterable[Ground]):
        self.objects = frozenset(objects)
        self._shapes: dict[tuple, int] = {}
        self._encoded: dict[Ground, Encoded] = {}
        self._known: dict[Numbered, _Part] = {}
        self._forms: dict[tuple, int] = {}  # of parts

    def form(self, facts: Iterable[Ground]) -> tuple[Form, int]:
        """The canonical form, and the number of renamings of the objects that map the set onto itself; objects that
        no fact names can be renamed among themselves."""
        parts = [self._part(part) for part in _connected([self._encode(fact) for fact in facts])]
        forms = [part.form for part in parts]
        symmetries = math.factorial(len(self.objects) - sum(part.objects for part in parts))
        for part in parts:
            symmetries *= part.symmetries
        if len(set(forms)) < len(forms):
            symmetries *= math.prod(map(math.factorial, Counter(forms).values()))
        return tuple(sorted(forms)), symmetries

    def _encode(self, fact: Ground) -> Encoded:
        """Those of names alone are remembered: to Python, 1 and 1.0 are the same."""
        if (known := self._encoded.get(fact)) is not None:
            return known
        found: list[Ground] = []
        shape = self._shape(fact, found)
        encoded = self._shapes.setdefault(shape, len(self._shapes)), tuple(found)
        if all(isinstance(arg, str) for arg in (fact if isinstance(fact, tuple) else (fact,))):
            self._encoded[fact] = encoded
        return encoded

    def _shape(self, term: Ground, found: list[Ground]) -> tuple:
        if isinstance(term, tuple):
            return (term[0], *(self._shape(arg, found) for arg in term[1:]))
        if term in self.objects:
            found.append(term)
            return ()
        return (exact(term),)

    def _part(self, facts: list[Encoded]) -> _Part:
        number: dict[Ground, int] = {}
        numbered = tuple(
            [(shape, tuple([number.setdefault(each, len(number)) for each in args])) for shape, args in facts]
        )
        part = self._known.get(numbered)
        if part is None:
            form, symmetries = _search(numbered, [0] * len(number))
            part = _Part(self._forms.setdefault(form, len(self._forms)), len(number), symmetries)
            self._known[numbered] = part
        return part


def _connected(facts: list[Encoded]) -> Iterable[list[Encoded]]:
    """The connected parts; facts without objects make up one of their own."""
    leader: dict[Ground, Ground] = {}

    def find(each: Ground) -> Ground:
        while (above := leader[each]) != each:
            leader[each] = each = leader[above]
        return each

    for _, objects in facts:
        for each in objects:
            leader.setdefault(each, each)
            if each != objects[0]:
                leader[find(each)] = find(objects[0])
    parts: dict[Ground | None, list[Encoded]] = {}
    for fact in facts:
        parts.setdefault(find(fact[1][0]) if fact[1] else None, []).append(fact)
    return parts.values()


def _search(facts: Numbered, colours: list[int]) -> tuple[tuple, int]:
    """The canonical form of one connected part, and the number of its symmetries."""
    colours = _refined(facts, colours)
    cells = Counter(colours)
    if len(cells) == len(colours):
        return tuple(sorted((shape, *(colours[i] for i in args)) for shape, args in facts)), 1
    cell = min(colour for colour, size in cells.items() if size > 1)
    best: tuple | None = None
    symmetries = 0
    for i, colour in enumerate(colours):
        if colour == cell:
            singled = [2 * each + 1 for each in colours]
            singled[i] -= 1
            form, own = _search(facts, singled)
            if best is None or form < best:
                best, symmetries = form, own
            elif form == best:
                symmetries += own
    assert best is not None
    return best, symmetries


def _refined(facts: Numbered, colours: list[int]) -> list[int]:
    """The coarsest colouring, at least as fine as the given one, in which objects of one colour stand in the
    same facts with objects of the same colours."""
    while True:
        seen: list[list[tuple]] = [[] for _ in colours]
        for shape, args in facts:
            tints = tuple(colours[i] for i in args)
            for position, i in enumerate(args):
                seen[i].append((shape, position, tints))
        signatures = [(colour, tuple(sorted(own))) for colour, own in zip(colours, seen, strict=True)]
        rank = {signature: r for r, signature in enumerate(sorted(set(signatures)))}
        refined = [rank[signature] for signature in signatures]
        if len(rank) == len(colours) or refined == colours:
            return refined
        if len(rank) == len(set(colours)):
            return refined
        colours = refined
