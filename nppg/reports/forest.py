"""Which objects of a state are on or in which others, as far as its facts tell without anybody's help.

Of predicates with two arguments some say where things are: each thing has one place. What they relate is a forest:
at(ball, room) puts the ball into the room, on(a, b) with on(b, c) makes a tower. Whatever else holds of an object is
written on it. Predicates that change are asked first, since goals, for example, do not.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from nppg.bridge.terms import Ground

_NOTES = 3  # that are written on an object


class Forest(NamedTuple):
    """Of one state: what each object is in or on, None for a root; which are on theirs, not in it; and what is written
    on each."""

    parents: dict[str, str | None]
    stacked: set[str]
    notes: dict[str, list[str]]
    loose: list[str]  # facts about no object


class Places:
    """What the predicates of some states of one world mean."""

    def __init__(self, states: Sequence[Sequence[Ground]], wanted: Iterable[str] = ()):
        self._wanted = set(wanted)
        sets = [set(map(_fact, state)) for state in states]
        always = set.intersection(*sets) if sets else set()
        every = set.union(*sets) if sets else set()
        self._changing = {(fact[0], len(fact) - 1) for fact in every - always}
        pairs: dict[str, int] = {}
        several: set[str] = set()
        self._towers: set[str] = set()
        self._shared: set[str] = set()  # several things may be in one place
        self.based: set[str] = set()  # what is in a tower, or may be
        for facts in sets:
            own: dict[str, dict[str, str]] = {}
            for name, *args in facts:
                if len(args) == 2 and all(isinstance(arg, str) for arg in args):
                    pairs[name] = pairs.get(name, 0) + 1
                    places = own.setdefault(name, {})
                    if args[0] in places:
                        several.add(name)
                    if args[1] in places.values():
                        self._shared.add(name)
                    places[args[0]] = args[1]
            for name, places in own.items():
                if any(place in places for place in places.values()):
                    self._towers.add(name)
                    self.based |= {*places, *places.values()}
        known = [name for name in pairs if name not in several and name not in self._wanted]
        self._order = sorted(known, key=lambda name: ((name, 2) not in self._changing, -pairs[name], name))
        self.moved = {arg for fact in every - always for arg in fact[1:] if isinstance(arg, str)}
        signatures: dict[str, set[tuple]] = {}
        for name, *args in every:
            for i, arg in enumerate(args):
                if isinstance(arg, str) and (name, len(args)) in self._changing:
                    signatures.setdefault(arg, set()).add((name, i))
        kinds = sorted({tuple(sorted(each)) for each in signatures.values()})
        self.kinds = {arg: kinds.index(tuple(sorted(each))) for arg, each in signatures.items()}

    def forest(self, state: Iterable[Ground], only: set[str] | None = None) -> Forest:
        """Of one of the states, its facts of fluents and those that say what is `wanted`."""
        facts = sorted(map(_fact, state), key=str)
        found = Forest({}, set(), {}, [])
        left = []
        for name in self._order:
            for fact in facts:
                if fact[0] == name and len(fact) == 3 and not self._put(found, *fact):
                    left.append(fact)
        placed = set(self._order)
        for fact in [*left, *(each for each in facts if not (len(each) == 3 and each[0] in placed))]:
            name, *args = fact
            objects = [arg for arg in args if isinstance(arg, str)]
            if not objects:
                found.loose.append(" ".join(map(str, fact)))
                continue
            found.parents.setdefault(objects[0], None)
            told = " ".join([f"{'→ ' if name in self._wanted else ''}{name}", *map(str, args[1:])])
            if len(found.notes.setdefault(objects[0], [])) < _NOTES:
                found.notes[objects[0]].append(told)
        if only is not None:
            self._leave(found, only)
        return found

    def _put(self, found: Forest, name: str, thing: str, place: str) -> bool:
        """Puts a thing, or where it is somewhere already the place, on or in the other; not in a circle."""
        for below, above in ((place, thing), (thing, place))[: 1 if name in self._shared else 2]:
            if found.parents.get(above) is None and above not in _line(found, below):
                found.parents.setdefault(below, None)
                found.parents[above] = below
                if name in self._towers and above == thing:
                    found.stacked.add(above)
                return True
        return False

    @staticmethod
    def _leave(found: Forest, only: set[str]) -> None:
        """Leaves out the objects that are not wanted, and have nothing wanted in or on them."""
        kept = {each for name in only if name in found.parents for each in _line(found, name)}
        for name in list(found.parents):
            if name not in kept:
                del found.parents[name]


def _line(found: Forest, name: str) -> list[str]:
    """An object, and what it is in or on, down to the root."""
    line = [name]
    while (below := found.parents.get(line[-1])) is not None:
        line.append(below)
    return line


def _fact(term: Ground) -> tuple:
    """A fact as a flat tuple; arguments that are compounds as text."""
    if not isinstance(term, tuple):
        return (term,)
    return (term[0], *(str(arg) if isinstance(arg, tuple) else arg for arg in term[1:]))
