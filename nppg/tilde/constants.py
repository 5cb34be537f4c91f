"""Constants of a language that come from the data: answers of generators, thresholds of numbers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np

from nppg.bias.declarations import Template
from nppg.bias.names import written
from nppg.bridge.terms import Ground
from nppg.errors import NppgError
from nppg.tilde.declared import bias_of
from nppg.tilde.knowledge import Knowledge
from nppg.tilde.mode_terms import Unsupported
from nppg.tilde.program import Background, reachable
from nppg.tilde.task import Task
from nppg.tilde.terms import (
    Indicator,
    arguments,
    canonical,
    elements,
    indicator,
    is_variable,
    match,
    number,
    parts_of,
    within,
)

_HELPER = "generated constants"

Bound = dict[int, Ground]  # what variables stand for


class Rules(Exception):
    """A goal is about more than facts."""


class Facts:
    """Ground facts, by their predicates and first arguments."""

    def __init__(self, facts: Iterable[Ground], rules: Iterable[Indicator] = ()):
        self.rules = frozenset(rules)
        self._all: dict[Indicator, list[Ground]] = {}
        for fact in facts:
            self._all.setdefault(indicator(fact), []).append(fact)
        self._first: dict[Indicator, dict[Ground, list[Ground]]] = {}

    def solutions(self, goals: Sequence[Ground], bound: Bound) -> Iterator[Bound]:
        """What the goals' variables may stand for, in the order of the facts. Raises Rules."""
        if not goals:
            yield bound
            return
        goal, *others = goals
        if indicator(goal) == ("member", 2) and (items := elements(arguments(goal)[1])) is not None:
            instances: Iterable[Ground] = [("member", item, arguments(goal)[1]) for item in items]
        elif indicator(goal) in self.rules or is_variable(goal) or not indicator(goal)[0].isidentifier():
            raise Rules
        else:
            instances = self._instances(goal, bound)
        for fact in instances:
            found = dict(bound)
            if match(goal, fact, found):
                yield from self.solutions(others, found)

    def _instances(self, goal: Ground, bound: Bound) -> list[Ground]:
        predicate = indicator(goal)
        facts = self._all.get(predicate, [])
        if not predicate[1]:
            return facts
        first = arguments(goal)[0]
        first = bound.get(number(first), first) if is_variable(first) else first
        if is_variable(first):
            return facts
        if predicate not in self._first:
            index: dict[Ground, list[Ground]] = {}
            for fact in facts:
                index.setdefault(arguments(fact)[0], []).append(fact)
            self._first[predicate] = index
        return self._first[predicate].get(first, [])


def answers(
    base: Background, goals: Sequence[Ground], variables: Sequence[Ground], facts: Sequence[Ground] = ()
) -> list[tuple[Ground, ...]]:
    """What the variables stand for in the goals' answers, each once, sorted as Prolog does; asked once the background
    has been passed by the gate."""
    needed = reachable((each for goal in goals for each in within(goal)), base.rules)
    known = [fact for fact in base.facts if indicator(fact) in needed]
    others = sorted({indicator(fact) for fact in base.facts} - needed)
    text = "".join(f":- dynamic(/({written(name)}, {arity})).\n" for name, arity in others) + base.text
    known_as = Counter(number(each) for goal in (*goals, *variables) for each in parts_of(goal) if is_variable(each))
    once = {variable for variable, times in known_as.items() if times == 1}
    body = ", ".join(canonical(goal, once) for goal in goals)
    helper = f"{canonical((_HELPER, *variables))} :- {body}.\n"
    bias = bias_of(Path(), Template("example", ()), {}, (), (), 0)
    task = Task("constants", bias, (), (*known, *facts), text + helper)
    return Knowledge(task).solutions(_HELPER, len(variables))


def asked(
    base: Background, goals: Sequence[Ground], variables: Sequence[Ground], facts: Sequence[Ground] = ()
) -> list[tuple[Ground, ...]]:
    """The same; raises Unsupported where they cannot be asked so."""
    try:
        return answers(base, goals, variables, facts)
    except NppgError as error:
        message = error.problems[0].message.partition(" in the state")[0]
        what = "asking for its constants"
        raise Unsupported(message.replace(f"'{_HELPER}'/{len(variables)}", what)) from None


def equal_frequency(values: Sequence[float], most: int) -> list[float]:
    """At most so many thresholds that part the values into parts of the same size, in the middle between two values."""
    ordered = np.sort(np.asarray(values, float))
    found = []
    for part in range(1, most + 1):
        at = round(part * len(ordered) / (most + 1))
        above = ordered[ordered > ordered[at - 1]] if 0 < at < len(ordered) else ordered[:0]
        if len(above):
            found.append(float((ordered[at - 1] + above[0]) / 2))
    return list(dict.fromkeys(found))


def least_entropy(values: Sequence[float], classes: Sequence[Ground], most: int) -> list[float]:
    """At most so many thresholds, each of which parts a part that is there by then as to leave the least entropy of the
    classes (Fayyad and Irani 1993, without their stopping rule)."""
    names = {name: number for number, name in enumerate(dict.fromkeys(classes))}
    order = np.argsort(np.asarray(values, float), kind="stable")
    ordered = np.asarray(values, float)[order]
    ones = np.zeros((len(ordered), len(names)))
    ones[np.arange(len(ordered)), [names[classes[i]] for i in order]] = 1
    below = np.vstack([np.zeros(len(names)), np.cumsum(ones, axis=0)])
    cuts = [0, len(ordered)]
    while len(cuts) - 2 < most:
        best, gain = 0, 1e-9
        for start, end in pairwise(sorted(cuts)):
            at = np.arange(start + 1, end)
            at = at[ordered[at] > ordered[at - 1]]
            if len(at):
                left, right = below[at] - below[start], below[end] - below[at]
                gains = _entropy(below[end] - below[start]) - _entropy(left) - _entropy(right)
                if gains.max() > gain:
                    best, gain = int(at[gains.argmax()]), float(gains.max())
        if not best:
            break
        cuts.append(best)
    return [float((ordered[at - 1] + ordered[at]) / 2) for at in sorted(cuts)[1:-1]]


def _entropy(counts: np.ndarray) -> np.ndarray:
    """In bits, of so many examples together; shape (..., classes)."""
    whole = counts.sum(axis=-1, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore"):
        bits = np.where(counts > 0, counts * np.log2(counts / whole), 0.0)
    return -bits.sum(axis=-1)
