"""What the actions and rules of a PDDL domain change: everything else is static."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from nppg.pddl.model import Add, Change, Delete, Domain, Each, Effect, Probabilistic, Symbol, When


def _simple_effects(effect: Effect) -> Iterator[Add | Delete | Change]:
    """What may happen in an effect, under whatever condition."""
    if isinstance(effect, Add | Delete | Change):
        yield effect
    elif isinstance(effect, When | Each):
        yield from _simple_effects(effect.effect)
    else:
        inner = [each for _, each in effect.branches] if isinstance(effect, Probabilistic) else effect.parts
        for each in inner:
            yield from _simple_effects(each)


@cache
def _of_actions(effects: tuple[Effect, ...]) -> tuple[Add | Delete | Change, ...]:
    return tuple(simple for effect in effects for simple in _simple_effects(effect))


def changes(domain: Domain) -> tuple[Add | Delete | Change, ...]:
    """What may happen in any action of the domain."""
    return _of_actions(tuple(action.effect for action in domain.actions))


def fluents(domain: Domain) -> frozenset[str]:
    """The predicates that some action changes."""
    return frozenset(each.atom.name for each in changes(domain) if not isinstance(each, Change))


def changed_functions(domain: Domain) -> frozenset[str]:
    """The functions that some action changes."""
    return frozenset(each.target.name for each in changes(domain) if isinstance(each, Change))


def derived(domain: Domain) -> frozenset[str]:
    """The predicates that have rules."""
    return frozenset(rule.name for rule in domain.derived)


def symbols_of(domain: Domain) -> list[Symbol]:
    """The predicates with their parameters, those of rules that are not declared among them."""
    found = {each.name: each for each in domain.predicates}
    for rule in domain.derived:
        found.setdefault(rule.name, Symbol(rule.name, rule.parameters))
    return list(found.values())
