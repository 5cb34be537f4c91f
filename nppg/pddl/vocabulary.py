"""What the names of a domain and a problem stand for: types, predicates, functions and objects."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from nppg.pddl.model import OBJECT, Symbol

TOTAL_COST, REWARD = Symbol("total-cost", ()), Symbol("reward", ())
PREDECLARED = {each.name: each for each in (TOTAL_COST, REWARD)}


class Types:
    """The types of a domain, each with those above it; `parents` has no cycles."""

    def __init__(self, parents: Mapping[str, tuple[str, ...]]):
        self.parents = parents
        self._above: dict[str, frozenset[str]] = {OBJECT: frozenset([OBJECT])}
        for name in parents:
            self._above[name] = frozenset(above(parents, name) | {name, OBJECT})
        self._fitting: dict[tuple[tuple[str, ...], tuple[str, ...]], bool] = {}
        self._overlapping: dict[tuple[tuple[str, ...], tuple[str, ...]], bool] = {}

    @property
    def names(self) -> Collection[str]:
        """All of them, also `object`."""
        return self._above

    def fits(self, types: tuple[str, ...], wanted: tuple[str, ...]) -> bool:
        """Whether an object of the first types is of the wanted ones; also where one is unknown."""
        key = types, wanted
        if key not in self._fitting:
            known = self._known(key)
            self._fitting[key] = not known or any(self._above[each].intersection(wanted) for each in types)
        return self._fitting[key]

    def overlap(self, types: tuple[str, ...], wanted: tuple[str, ...]) -> bool:
        """Whether some type is below one of each; also where one is unknown."""
        key = types, wanted
        if key not in self._overlapping:
            common = (over.intersection(types) and over.intersection(wanted) for over in self._above.values())
            self._overlapping[key] = not self._known(key) or any(common)
        return self._overlapping[key]

    def _known(self, lists: Sequence[Sequence[str]]) -> bool:
        return all(each in self._above for names in lists for each in names)


def above(parents: Mapping[str, tuple[str, ...]], name: str) -> set[str]:
    """All types above one; it is among them where it is on a cycle."""
    found: set[str] = set()
    left = list(parents.get(name, ()))
    while left:
        each = left.pop()
        if each not in found:
            found.add(each)
            left.extend(parents.get(each, ()))
    return found


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """The declarations that formulas and effects refer to."""

    types: Types
    predicates: Mapping[str, Symbol]
    functions: Mapping[str, Symbol]
    objects: Mapping[str, tuple[str, ...]]
    derived: Collection[str] = ()
    object_kind: str = "constant"
