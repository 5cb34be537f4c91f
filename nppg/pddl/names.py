"""What the parts of a PDDL domain are called in Prolog.

No two of them share a name, whatever their arities, since a language bias tells predicates apart by their names alone.
Actions choose first, then predicates, functions, and types, which give way: beside a predicate block, the type block is
is_block.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from nppg.pddl.hierarchy import all_types
from nppg.pddl.model import OBJECT, Domain

COST = "total-cost"  # what plans cost, by convention
REWARD = "reward"  # what PPDDL's plans earn
APART = (COST, REWARD)  # functions that are no part of a state

# Prolog's operators that are words, and those of domain files: as operands they need brackets.
_WORDS = (
    "is mod rem div divmod rdiv xor as dynamic discontiguous initialization meta_predicate module_transparent "
    "multifile public thread_local thread_initialization volatile table tnot static fluent parameter "
    "interchangeable environment pddl"
)
OPERATORS = frozenset(_WORDS.split())
# What else nppg has these names for.
_RESERVED = OPERATORS | {"equal", "delta", "dead_ends", "uniform_start", "holds", "true", "false", "fail"}
_HELPERS = {
    "goals": 1,
    "condition": 1,
    "added": 2,
    "deleted": 2,
    "charged": 2,
    "rewarded": 2,
    "gained": 1,
    "goal_reward": 1,
}


@dataclass(frozen=True, slots=True)
class Names:
    """Prolog's names by PDDL's; `goal`, `todo` and `done` are by predicate, `own` are the text's own predicates."""

    actions: Mapping[str, str]
    predicates: Mapping[str, str]
    functions: Mapping[str, str]
    types: Mapping[str, str]
    goal: Mapping[str, str]
    todo: Mapping[str, str]
    done: Mapping[str, str]
    own: Mapping[str, str]


def names_of(domain: Domain, taken: Callable[[str, int], bool]) -> Names:
    """Names for everything in the domain; none is `taken(name, arity)` by somebody else. Objects keep theirs."""
    used: set[str] = set()

    def named(all: Mapping[str, int], prefix: str, taken: Callable[[str, int], bool]) -> dict[str, str]:
        found: dict[str, str] = {}
        for name, arity in all.items():
            free = _free(name, arity, prefix, used, set(found.values()), taken)
            used.add(free)
            found[name] = free
        return found

    arities = {each.name: len(each.parameters) for each in domain.predicates}
    arities |= {each.name: len(each.parameters) for each in domain.derived}
    values = {each.name: len(each.parameters) + 1 for each in domain.functions if each.name not in APART}
    actions = named({each.name: len(each.parameters) for each in domain.actions}, "do", lambda *_: False)
    predicates = named(arities, "is", taken)
    functions = named(values, "value", taken)
    types = named(dict.fromkeys((*all_types(domain), OBJECT), 1), "is", taken)
    own = named(_HELPERS, "all", taken)

    def versions(kind: str) -> dict[str, str]:
        wanted = {f"{kind}_{predicates[name]}": arity for name, arity in arities.items()}
        return dict(zip(arities, named(wanted, "the", taken).values(), strict=True))

    return Names(actions, predicates, functions, types, versions("goal"), versions("todo"), versions("done"), own)


def _free(
    name: str, arity: int, prefix: str, used: set[str], alike: set[str], taken: Callable[[str, int], bool]
) -> str:
    base = re.sub(r"[^0-9a-z_]", "_", name.lower()).strip("_")
    if not base[:1].isalpha():
        base = f"{prefix}_{base}".strip("_")
    if base not in alike and (base in used or base in _RESERVED or taken(base, arity)):
        base = f"{prefix}_{base}"
    free, number = base, 2
    while free in used or free in _RESERVED or taken(free, arity):
        free, number = f"{base}_{number}", number + 1
    return free
