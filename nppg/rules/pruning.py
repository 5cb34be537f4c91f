"""Shorter lists of rules: without a rule, without a literal, with fewer different values."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from nppg.bias.refinement import Refiner
from nppg.trees.tree import Rule

_STEP = 10.0  # between two values of the rules

Accepts = Callable[[list[Rule]], bool]


def pruned(ordered: list[Rule], refiner: Refiner, accepts: Accepts) -> list[Rule]:
    """Drops rules, then literals, as long as what remains is accepted; the last rule stays, and holds always."""
    before: list[Rule] = []
    while ordered != before:
        before = ordered
        ordered = without_literals(without_rules(ordered, accepts), refiner, accepts)
    return ordered


def without_rules(ordered: list[Rule], accepts: Accepts) -> list[Rule]:
    """Drops rules, from the last one on."""
    for i in range(len(ordered) - 2, -1, -1):
        candidate = ordered[:i] + ordered[i + 1 :]
        if accepts(candidate):
            ordered = candidate
    return ordered


def without_literals(ordered: list[Rule], refiner: Refiner, accepts: Accepts) -> list[Rule]:
    """Drops literals."""
    for i, rule in enumerate(ordered[:-1]):
        for literal in reversed(rule.query):
            query = tuple(each for each in ordered[i].query if each != literal)
            if is_allowed(query, refiner):
                candidate = [*ordered[:i], replace(rule, query=query), *ordered[i + 1 :]]
                if accepts(candidate):
                    ordered = candidate
    return ordered


def is_allowed(query: Sequence, refiner: Refiner) -> bool:
    """Whether a rule may have this query: no literal may have lost the one that binds its variables."""
    return bool(query) and refiner.allows(tuple(query))


def one_less(ordered: list[Rule]) -> Iterator[list[Rule]]:
    """The list without each of its rules but the last."""
    for i in range(len(ordered) - 2, -1, -1):
        yield ordered[:i] + ordered[i + 1 :]


def ranked(ordered: list[Rule]) -> list[Rule]:
    """The same order of values, as multiples of a number that makes the stochastic policy nearly greedy."""
    ranks = {value: rank for rank, value in enumerate(sorted({rule.value for rule in ordered}))}
    return _with_levels(ordered, [ranks[rule.value] for rule in ordered])


def levelled(ordered: list[Rule], accepts: Accepts) -> list[Rule]:
    """As few different values as possible: neighbouring ones become one where that is accepted."""
    levels = [round(rule.value / _STEP) for rule in ranked(ordered)]
    for upper in range(max(levels), 0, -1):
        merged = [level - (level >= upper) for level in levels]
        if accepts(_with_levels(ordered, merged)):
            levels = merged
    return _with_levels(ordered, levels)


def _with_levels(ordered: list[Rule], levels: list[int]) -> list[Rule]:
    return [replace(rule, value=_STEP * level) for rule, level in zip(ordered, levels, strict=True)]
