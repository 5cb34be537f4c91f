"""The types of a PDDL domain: which lie above which, and which objects are of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from nppg.pddl.model import OBJECT, Domain, Typed


def above(domain: Domain, type_: str) -> tuple[str, ...]:
    """The type and all above it, nearest first, object last."""
    found = [type_]
    for each in found:
        found += [parent for parent in domain.types.get(each, ()) if parent not in found and parent != OBJECT]
    return (*found, OBJECT) if type_ != OBJECT else (OBJECT,)


def fits(domain: Domain, types: Iterable[str], wanted: Sequence[str]) -> bool:
    """Whether an object of these types, whichever of them it is, is of one of the wanted ones."""
    return OBJECT in wanted or all(not set(above(domain, type_)).isdisjoint(wanted) for type_ in types)


def overlap(domain: Domain, some: Iterable[str], others: Iterable[str]) -> bool:
    """Whether one of the types lies above or below one of the others."""
    return any(a in above(domain, b) or b in above(domain, a) for a in some for b in others)


def common(domain: Domain, types: Sequence[str]) -> str:
    """The nearest type that all of the types lie below."""
    first, *others = types
    return next(each for each in above(domain, first) if all(each in above(domain, other) for other in others))


def below_object(domain: Domain) -> tuple[str, ...]:
    """The types that no other type but object lies above."""
    return tuple(type_ for type_ in all_types(domain) if above(domain, type_)[1:] == (OBJECT,))


def all_types(domain: Domain) -> tuple[str, ...]:
    """All types but object, in the order of their declarations; some may be named as parents alone."""
    found = dict.fromkeys(domain.types)
    for parents in domain.types.values():
        found |= dict.fromkeys(parents)
    found.pop(OBJECT, None)
    return tuple(found)


def memberships(domain: Domain, objects: Iterable[Typed]) -> Iterator[tuple[str, str]]:
    """Each object with each of its types."""
    for each in objects:
        types = dict.fromkeys(type_ for given in each.types for type_ in above(domain, given))
        yield from ((type_, each.name) for type_ in types)
