"""A canonical form of fact sets up to the renaming of interchangeable objects.

Facts that share an interchangeable object are connected. Each connected part is put into canonical form on its
own, by colour refinement and, where that leaves objects alike, by trying each of them in turn; the form of the
set is the sorted list of its parts' forms. Exact for every domain; quick where parts are small or irregular.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable

from nppg.domain import Ground

Form = tuple


class Canonizer:
    """Canonical forms of fact sets, comparable with each other, in which `objects` may be renamed."""

    def __init__(self, objects: Iterable[Ground]):
        self.objects = frozenset(objects)
        self._shapes: dict[tuple, int] = {}

    def form(self, facts: Iterable[Ground]) -> tuple[Form, int]:
        """The canonical form, and the number of renamings of the objects that map the set onto itself; objects that
        no fact names can be renamed among themselves."""
        encoded = [self._encode(fact) for fact in facts]
        parts = self._parts(encoded)
        symmetries = math.factorial(len(self.objects.difference(*(args for _, args in encoded))))
        forms = []
        for part in parts:
            form, own = _part_form(part)
            forms.append(form)
            symmetries *= own
        for count in Counter(forms).values() if len(forms) > 1 else ():
            symmetries *= math.factorial(count)
        forms.sort()
        return tuple(forms), symmetries

    def _encode(self, fact: Ground) -> tuple[int, tuple[Ground, ...]]:
        """The number of the fact's shape, which is the fact with its objects left out, and those objects."""
        found: list[Ground] = []
        shape = self._shape(fact, found)
        return self._shapes.setdefault(shape, len(self._shapes)), tuple(found)

    def _shape(self, term: Ground, found: list[Ground]) -> tuple:
        if isinstance(term, tuple):
            return (term[0], *(self._shape(arg, found) for arg in term[1:]))
        if term in self.objects:
            found.append(term)
            return ()
        return (type(term).__name__, term)

    @staticmethod
    def _parts(facts: list[tuple[int, tuple[Ground, ...]]]) -> list[list[tuple[int, tuple[Ground, ...]]]]:
        leader: dict[Ground, Ground] = {}

        def find(each: Ground) -> Ground:
            while leader[each] != each:
                leader[each] = leader[leader[each]]
                each = leader[each]
            return each

        for _, objects in facts:
            for each in objects:
                leader.setdefault(each, each)
                leader[find(each)] = find(objects[0])
        parts: dict[Ground | None, list] = {}
        for fact in facts:
            parts.setdefault(find(fact[1][0]) if fact[1] else None, []).append(fact)
        return list(parts.values())


def _part_form(facts: list[tuple[int, tuple[Ground, ...]]]) -> tuple[Form, int]:
    """The canonical form of one connected part, and the number of its symmetries."""
    objects = sorted({each for _, args in facts for each in args}, key=repr)
    number = {each: i for i, each in enumerate(objects)}
    numbered = [(shape, tuple(number[each] for each in args)) for shape, args in facts]
    return _search(numbered, [0] * len(objects))


def _search(facts: list[tuple[int, tuple[int, ...]]], colours: list[int]) -> tuple[Form, int]:
    colours = _refined(facts, colours)
    cells = Counter(colours)
    if len(cells) == len(colours):
        return tuple(sorted((shape, *(colours[i] for i in args)) for shape, args in facts)), 1
    cell = min(colour for colour, size in cells.items() if size > 1)
    best: Form | None = None
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


def _refined(facts: list[tuple[int, tuple[int, ...]]], colours: list[int]) -> list[int]:
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
