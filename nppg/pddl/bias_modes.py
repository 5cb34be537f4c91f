"""The literals that a policy for a PDDL domain may test, as mode declarations in an order of importance.

Every predicate can be asked of known objects, and for the objects in one place of it where the others are known, in two
where it has three places or more. What the goal wants has versions: the goal's facts, those still to do, those done. Of
what is too much, whole groups are left out, in the order of GROUPS.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import combinations

from nppg.bias.names import atom
from nppg.pddl.changing import derived, fluents, symbols_of
from nppg.pddl.hierarchy import above, all_types, common
from nppg.pddl.model import Action, Atom, Domain, Equal, Formula, Not, Symbol
from nppg.pddl.names import APART, Names
from nppg.pddl.normal import conjuncts, simplified

LOOKAHEAD = "lookahead"  # what a group loses: its lookahead, or all
ALL = "all"

# Family, number of new variables, and what is left out of them; what goes first comes first.
GROUPS: tuple[tuple[str, int, str], ...] = (
    *((family, 2, ALL) for family in ("done", "goal", "static", "todo", "fluent", "derived")),
    ("done", 1, ALL),
    ("static", 1, LOOKAHEAD),
    ("goal", 1, LOOKAHEAD),
    ("static", 1, ALL),
    ("done", 0, ALL),
    ("fluent", 1, LOOKAHEAD),
    ("derived", 1, LOOKAHEAD),
    ("goal", 1, ALL),
    ("type", 0, ALL),
    ("fluent", 1, ALL),
    ("derived", 1, ALL),
    ("todo", 1, LOOKAHEAD),
    ("todo", 1, ALL),
    ("goal", 0, ALL),
    ("static", 0, ALL),
)


@dataclass(frozen=True, slots=True)
class Tested:
    """One mode declaration; the types of its predicate's arguments are given once for all of them."""

    name: str
    kinds: tuple[str, ...]  # + or -
    family: str
    lookahead: int = 0

    def without(self, family: str, new: int, what: str) -> Tested | None:
        """What is left of it where `what` of a group is left out."""
        if (self.family, self.kinds.count("-")) != (family, new):
            return self
        return replace(self, lookahead=0) if what == LOOKAHEAD else None

    def __str__(self) -> str:
        return atom(self.name, self.kinds)


@dataclass(frozen=True, slots=True)
class Signature:
    """A predicate as Prolog calls it, with the types of its arguments as PDDL calls them; "" is a number's."""

    name: str
    types: tuple[str, ...]
    family: str


def signatures(domain: Domain, names: Names, wanted: Iterable[str]) -> Iterator[Signature]:
    """All predicates that can be asked but those of types: the goal's versions first, then what changes."""
    symbols = symbols_of(domain)
    goals = set(wanted)
    for symbol in symbols:
        if symbol.name in goals:
            versions = (("todo", names.todo), ("goal", names.goal), ("done", names.done))
            for family, called in versions:
                yield Signature(called[symbol.name], _types(domain, symbol), family)
    families = {symbol.name: _family(domain, symbol.name) for symbol in symbols}
    for family in ("fluent", "derived", "static"):
        for symbol in symbols:
            if families[symbol.name] == family:
                yield Signature(names.predicates[symbol.name], _types(domain, symbol), family)
    for function in domain.functions:
        if function.name not in APART:
            yield Signature(names.functions[function.name], (*_types(domain, function), ""), "number")


def modes(signature: Signature) -> Iterator[Tested]:
    """The ways to ask a predicate."""
    count = len(signature.types)
    if signature.family == "number":
        choices: list[tuple[int, ...]] = [(count - 1,)]
    elif signature.family == "type":
        choices = [()]
    else:
        choices = [(), *combinations(range(count), 1)]
        choices += combinations(range(count), 2) if count > 2 else ()
    for new in choices:
        kinds = tuple("-" if place in new else "+" for place in range(count))
        yield Tested(signature.name, kinds, signature.family, 1 if new else 0)


def _family(domain: Domain, name: str) -> str:
    return "fluent" if name in fluents(domain) else "derived" if name in derived(domain) else "static"


def _types(domain: Domain, symbol: Symbol) -> tuple[str, ...]:
    return tuple(common(domain, each.types) for each in symbol.parameters)


def action_types(domain: Domain, action: Action) -> tuple[str, ...]:
    """A type for each parameter."""
    return tuple(common(domain, each.types) for each in action.parameters)


def supertypes(domain: Domain, used: Iterable[str]) -> Mapping[str, str]:
    """For each type the nearest used one above it, where there is one; of the types that are not used, too."""
    known = set(used)
    found = {}
    for type_ in all_types(domain):
        nearest = next((each for each in above(domain, type_)[1:] if each in known), None)
        if nearest:
            found[type_] = nearest
    return found


def equalities(domain: Domain) -> list[str]:
    """The types of which an action may have the same object twice."""
    found: dict[str, None] = {}
    for action in domain.actions:
        types = action_types(domain, action)
        parts = conjuncts(simplified(action.precondition))
        for i, j in combinations(range(len(types)), 2):
            if types[i] == types[j] and not _differ(parts, action.parameters[i].name, action.parameters[j].name):
                found[types[i]] = None
    return list(found)


def constants(domain: Domain) -> dict[str, list[str]]:
    """The domain's own objects, by type."""
    found: dict[str, list[str]] = {}
    for each in domain.constants:
        found.setdefault(common(domain, each.types), []).append(each.name)
    return found


def _differ(parts: Iterable[Formula], one: str, other: str) -> bool:
    """Whether two variables cannot be the same: one is what the other is not."""
    parts = list(parts)
    positive = {_merged(part, one, other) for part in parts if isinstance(part, Atom)}
    for part in parts:
        if isinstance(part, Not) and isinstance(part.part, Equal):
            if {part.part.left, part.part.right} == {one, other}:
                return True
        elif isinstance(part, Not) and isinstance(part.part, Atom) and _merged(part.part, one, other) in positive:
            return True
    return False


def _merged(atom: Atom, one: str, other: str) -> Atom:
    return Atom(atom.name, tuple(one if term == other else term for term in atom.args))
