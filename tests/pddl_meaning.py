"""What PDDL means, said as plainly as can be: the actions of a state and where they lead, over all groundings."""

from __future__ import annotations

import operator
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from nppg.pddl.hierarchy import memberships
from nppg.pddl.model import (
    Action,
    Add,
    And,
    Arithmetic,
    Atom,
    Change,
    Compare,
    Delete,
    Domain,
    Each,
    Effect,
    Equal,
    Exists,
    Expression,
    Forall,
    Formula,
    Not,
    Or,
    PlanningProblem,
    Probabilistic,
    Together,
    Typed,
    Value,
    When,
)

_COMPARE = {"<": operator.lt, "<=": operator.le, "=": operator.eq, ">=": operator.ge, ">": operator.gt}
_CHANGE = {
    "assign": lambda old, amount: amount,
    "increase": operator.add,
    "decrease": operator.sub,
    "scale-up": operator.mul,
    "scale-down": lambda old, amount: _divided(old, amount),
}
_ARITHMETIC = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": lambda left, right: _divided(left, right)}

Facts = frozenset[tuple[str, ...]]
Numbers = Mapping[tuple[str, ...], float]
Binding = Mapping[str, str]


@dataclass(frozen=True)
class Reading:
    """A problem of a domain."""

    domain: Domain
    problem: PlanningProblem

    def objects(self, typed: Typed) -> list[str]:
        given = (*self.domain.constants, *self.problem.objects)
        return sorted({name for type_, name in memberships(self.domain, given) if type_ in typed.types})

    def bindings(self, variables: tuple[Typed, ...]) -> Iterator[Binding]:
        for values in product(*(self.objects(each) for each in variables)):
            yield dict(zip((each.name for each in variables), values, strict=True))

    def start(self) -> tuple[Facts, Numbers]:
        facts = frozenset((each.name, *each.args) for each in self.problem.init)
        return facts, {(value.name, *value.args): number for value, number in self.problem.values}

    def closed(self, facts: Facts, numbers: Numbers) -> Facts:
        """The facts with those that the rules derive, stratum by stratum as long as rules negate none of their own."""
        derived = {rule.name for rule in self.domain.derived}
        known = facts
        while True:
            more = {
                (rule.name, *binding.values())
                for rule in self.domain.derived
                for binding in self.bindings(rule.parameters)
                if self.holds(rule.body, known, numbers, binding)
            }
            if more <= known:
                return known
            assert derived
            known |= more

    def holds(self, formula: Formula, facts: Facts, numbers: Numbers, binding: Binding) -> bool:
        def of(part: Formula, more: Binding = {}) -> bool:  # noqa: B006
            return self.holds(part, facts, numbers, {**binding, **more})

        if isinstance(formula, Atom):
            return _ground(formula, binding) in facts
        if isinstance(formula, Equal):
            return binding.get(formula.left, formula.left) == binding.get(formula.right, formula.right)
        if isinstance(formula, Not):
            return not of(formula.part)
        if isinstance(formula, And):
            return all(map(of, formula.parts))
        if isinstance(formula, Or):
            return any(map(of, formula.parts))
        if isinstance(formula, Forall):
            return all(of(formula.part, more) for more in self.bindings(formula.variables))
        if isinstance(formula, Exists):
            return any(of(formula.part, more) for more in self.bindings(formula.variables))
        assert isinstance(formula, Compare)
        left, right = (_number(side, numbers, binding) for side in (formula.left, formula.right))
        return left is not None and right is not None and _COMPARE[formula.operator](left, right)

    def legal(self, facts: Facts, numbers: Numbers) -> dict[tuple[str, ...], tuple[Action, Binding]]:
        known = self.closed(facts, numbers)
        return {
            (action.name, *binding.values()): (action, binding)
            for action in self.domain.actions
            for binding in self.bindings(action.parameters)
            if self.holds(action.precondition, known, numbers, binding)
        }

    def results(self, action: Action, binding: Binding, facts: Facts, numbers: Numbers) -> dict:
        """The probability of each state, a pair of its facts and the items of its numbers."""
        known = self.closed(facts, numbers)
        found: dict = {}
        for chance, happens in self.outcomes(action.effect, binding, known, numbers):
            gone = {_ground(each.atom, bound) for each, bound in happens if isinstance(each, Delete)}
            new = {_ground(each.atom, bound) for each, bound in happens if isinstance(each, Add)}
            after = dict(numbers)
            for each, bound in happens:
                if isinstance(each, Change):
                    key = (each.target.name, *(bound.get(arg, arg) for arg in each.target.args))
                    after[key] = _CHANGE[each.operator](after.get(key, 0), _number(each.amount, numbers, bound))
            state = ((facts - gone) | new, frozenset(after.items()))
            found[state] = found.get(state, 0) + chance
        return found

    def outcomes(self, effect: Effect, binding: Binding, facts: Facts, numbers: Numbers) -> list:
        """What happens, with its probability: simple effects, each with its binding."""
        if isinstance(effect, Together):
            found = [(Fraction(1), [])]
            for part in effect.parts:
                more = self.outcomes(part, binding, facts, numbers)
                found = [(p * q, [*one, *other]) for p, one in found for q, other in more]
            return found
        if isinstance(effect, Probabilistic):
            found, left = [], Fraction(1)
            for share, branch in effect.branches:
                left -= Fraction(str(share))
                inner = self.outcomes(branch, binding, facts, numbers)
                found += [(Fraction(str(share)) * p, happens) for p, happens in inner]
            return [(p, happens) for p, happens in [*found, (left, [])] if p]
        if isinstance(effect, When):
            true = self.holds(effect.condition, facts, numbers, binding)
            return self.outcomes(effect.effect if true else Together(()), binding, facts, numbers)
        if isinstance(effect, Each):
            happens = []
            for more in self.bindings(effect.variables):
                [(_, inner)] = self.outcomes(effect.effect, {**binding, **more}, facts, numbers)
                happens += inner
            return [(Fraction(1), happens)]
        return [(Fraction(1), [(effect, binding)])]


def _divided(left: float, right: float) -> float:
    """As Prolog divides: a whole number where it can be one."""
    whole = isinstance(left, int) and isinstance(right, int) and left % right == 0
    return left // right if whole else left / right


def _ground(atom: Atom, binding: Binding) -> tuple[str, ...]:
    return (atom.name, *(binding.get(arg, arg) for arg in atom.args))


def _number(expression: Expression, numbers: Numbers, binding: Binding) -> float | None:
    if isinstance(expression, Value):
        return numbers.get((expression.name, *(binding.get(arg, arg) for arg in expression.args)))
    if not isinstance(expression, Arithmetic):
        return expression
    operands = [_number(each, numbers, binding) for each in expression.operands]
    if None in operands:
        return None
    first, *others = operands
    if not others:
        return -first if expression.operator == "-" else first
    for other in others:
        first = _ARITHMETIC[expression.operator](first, other)
    return first
