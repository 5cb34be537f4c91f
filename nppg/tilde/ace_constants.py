"""What generators of constants in ACE's settings give: `rmode(#(V: generator, literal))`."""

from __future__ import annotations

from collections.abc import Sequence

from nppg.bridge.terms import Ground
from nppg.tilde.ace_settings import Given
from nppg.tilde.constants import Facts, Rules, asked, equal_frequency, least_entropy
from nppg.tilde.mode_terms import Unsupported
from nppg.tilde.program import Background, Clause
from nppg.tilde.task import Example
from nppg.tilde.terms import (
    Indicator,
    arguments,
    elements,
    indicator,
    is_variable,
    number,
    parts,
    told,
)

_THRESHOLDS = {("threshold", 3), ("discretized", 3), ("boundary", 3)}
_FIRST = 1000  # number of a variable of its own
_MOST_THRESHOLDS = 10  # where the settings do not say how many


class Constants:
    """Gives what variables stand for where a generator holds; thresholds of numbers where the generator is
    threshold(Goal, [X], C)."""

    def __init__(self, given: Given, base: Background, facts: Facts, examples: Sequence[Example]):
        self.given = given
        self.base = base
        self.facts = facts
        self.examples = examples

    def __call__(self, variables: Ground, generator: Ground, clause: Clause) -> list[tuple[Ground, ...]]:
        wanted = arguments(variables)
        if indicator(generator) in _THRESHOLDS:
            return [(value,) for value in self._thresholds(generator)]
        rows = self._solutions(parts(generator), wanted)
        return list(dict.fromkeys(rows))

    def _solutions(self, goals: Sequence[Ground], wanted: Sequence[Ground]) -> list[tuple[Ground, ...]]:
        try:
            return [tuple(bound[number(each)] for each in wanted) for bound in self.facts.solutions(goals, {})]
        except Rules:
            return asked(self.base, goals, wanted)
        except KeyError:
            raise Unsupported("a variable of the constants is not in the generator") from None

    def _thresholds(self, generator: Ground) -> list[float]:
        """Of the numbers that a goal gives for the last of its variables: as many as to_be_discretized says, by entropy
        where the goal's first arguments are the key, else of equal frequency."""
        goal, listed, _ = arguments(generator)
        value = (elements(listed) or [""])[0]
        if not is_variable(value):
            raise Unsupported("a threshold is of one variable: threshold(Goal, [X], C)")
        args = [
            ("$VAR", _FIRST + i) if is_variable(arg) and arg != value else arg for i, arg in enumerate(arguments(goal))
        ]
        goal = (indicator(goal)[0], *args)
        others = [arg for arg in args if is_variable(arg) and arg != value]
        rows = [(row[:-1], row[-1]) for row in self._solutions([goal], [*others, value])]
        numbers = [(key, number) for key, number in rows if isinstance(number, int | float)]
        if not numbers:
            raise Unsupported(f"{told(goal)} gives no numbers")
        most = self._most(indicator(goal))
        classes = {each.key: each.target for each in self.examples}
        size = len(self.examples[0].key)
        values = [number for _, number in numbers]
        if self.given.value("discretize", "entropy") == "entropy" and all(key[:size] in classes for key, _ in numbers):
            return least_entropy(values, [str(classes[key[:size]]) for key, _ in numbers], most)
        return equal_frequency(values, most)

    def _most(self, predicate: Indicator) -> int:
        for clause in self.given.terms.get("to_be_discretized", ()):
            goal, *more = arguments(clause.data)
            if indicator(goal) == predicate:
                return next((each for each in more if type(each) is int), _MOST_THRESHOLDS)
        return _MOST_THRESHOLDS
