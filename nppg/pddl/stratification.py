"""Whether derived predicates are well defined: none depends on its own negation."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nppg.pddl.model import And, Atom, Derived, Exists, Forall, Formula, Not, Or


def negative_cycle(rules: Sequence[Derived]) -> list[str] | None:
    """The words of a cycle like `p, not q, p` through the rules; None where there is none."""
    names = {rule.name for rule in rules}
    below: dict[str, set[tuple[str, bool]]] = {each: set() for each in names}
    for rule in rules:
        below[rule.name].update((name, positive) for name, positive in used(rule.body) if name in names)
    for first in sorted(names):
        for name, positive in sorted(below[first]):
            path = None if positive else _path(below, name, first)
            if path is not None:
                signed = [f"not {name}", *path[1:]] if len(path) > 1 else [f"not {name}"]
                return [first, *signed]
    return None


def used(formula: Formula, positive: bool = True) -> Iterable[tuple[str, bool]]:
    """The predicates of a formula, each with whether it stands under an even number of negations."""
    if isinstance(formula, Atom):
        yield formula.name, positive
    elif isinstance(formula, Not):
        yield from used(formula.part, not positive)
    elif isinstance(formula, And | Or):
        for part in formula.parts:
            yield from used(part, positive)
    elif isinstance(formula, Forall | Exists):
        yield from used(formula.part, positive)


def _path(below: dict[str, set[tuple[str, bool]]], start: str, goal: str) -> list[str] | None:
    """A shortest way from one predicate to another, with both ends."""
    came: dict[str, str] = {start: start}
    left = [start]
    for name in left:
        if name == goal:
            way = [goal]
            while way[-1] != start:
                way.append(came[way[-1]])
            return way[::-1]
        for each, _ in sorted(below[name]):
            if each not in came:
                came[each] = name
                left.append(each)
    return None
