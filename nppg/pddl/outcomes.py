"""What an action may lead to: its effect as outcomes with probabilities, each of them parts that happen together."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations

from nppg.errors import NppgError, Problem
from nppg.pddl.model import (
    Action,
    Add,
    Arithmetic,
    Change,
    Delete,
    Domain,
    Each,
    Effect,
    Expression,
    Formula,
    Probabilistic,
    Together,
    Typed,
    Value,
    When,
)
from nppg.pddl.names import APART
from nppg.pddl.normal import conjuncts, is_variable, simplified


@dataclass(frozen=True, slots=True)
class Conditional:
    """An effect for all objects of these types for which the condition holds."""

    effect: Add | Delete | Change
    variables: tuple[Typed, ...] = ()
    condition: tuple[Formula, ...] = ()

    @property
    def always(self) -> bool:
        """Whether it happens once, whatever the state."""
        return not self.variables and not self.condition


@dataclass(frozen=True, slots=True)
class Outcome:
    """What happens together, with its probability."""

    probability: Fraction
    parts: tuple[Conditional, ...]


def outcomes(domain: Domain, action: Action) -> tuple[Outcome, ...]:
    """The outcomes of an action, those with probability 0 left out. Raises NppgError for what is not supported."""

    def refuse(message: str) -> NppgError:
        return NppgError([Problem(domain.file, 0, 0, f"the action {action.name}: {message}")])

    def all_of(effect: Effect) -> list[Outcome]:
        if isinstance(effect, Together):
            found = [Outcome(Fraction(1), ())]
            for part in effect.parts:
                found = [
                    Outcome(before.probability * more.probability, before.parts + more.parts)
                    for before in found
                    for more in all_of(part)
                ]
            return found
        if isinstance(effect, Probabilistic):
            return branches(effect)
        if isinstance(effect, When):
            condition = conjuncts(simplified(effect.condition))
            return [within(each, (), condition) for each in all_of(effect.effect)]
        if isinstance(effect, Each):
            inner = all_of(effect.effect)
            if len(inner) > 1:
                raise refuse("a probabilistic effect inside a forall is not supported")
            return [within(each, effect.variables, ()) for each in inner]
        return [Outcome(Fraction(1), (Conditional(effect),))]

    def branches(effect: Probabilistic) -> list[Outcome]:
        left = Fraction(1)
        found = []
        for number, branch in effect.branches:
            share = Fraction(str(number))
            left -= share
            if share > 0:
                found += [replace(each, probability=share * each.probability) for each in all_of(branch)]
        if left < Fraction(-1, 10**9):
            raise refuse("the probabilities of its effects sum to more than 1")
        return found + [Outcome(left, ())] * (left > Fraction(1, 10**9))

    def within(outcome: Outcome, variables: tuple[Typed, ...], condition: Iterable[Formula]) -> Outcome:
        return replace(
            outcome,
            parts=tuple(
                Conditional(each.effect, variables + each.variables, (*condition, *each.condition))
                for each in outcome.parts
            ),
        )

    found = tuple(replace(each, parts=_united(each.parts)) for each in all_of(action.effect))
    for outcome in found:
        if met := _meeting(outcome.parts):
            raise refuse(f"two of its effects may change the same number, {met}")
    return found


def _united(parts: tuple[Conditional, ...]) -> tuple[Conditional, ...]:
    """Changes of the same number that always happen, put together."""
    amounts: dict[Value, Change] = {}
    others = []
    for part in parts:
        change = part.effect
        if part.always and isinstance(change, Change) and change.operator in ("increase", "decrease"):
            if change.target in amounts:
                operator, amount = amounts[change.target].operator, amounts[change.target].amount
                sign = "+" if change.operator == operator else "-"
                amounts[change.target] = Change(operator, change.target, _combined(sign, amount, change.amount))
            else:
                amounts[change.target] = change
        else:
            others.append(part)
    return (*others, *map(Conditional, amounts.values()))


def _combined(sign: str, one: Expression, other: Expression) -> Expression:
    if isinstance(one, int) and isinstance(other, int):
        return one + other if sign == "+" else one - other
    return Arithmetic(sign, (one, other))


def _meeting(parts: tuple[Conditional, ...]) -> str:
    """The function of which two changes may be about the same number, or nothing."""
    numbers = [part for part in parts if isinstance(part.effect, Change) and part.effect.target.name not in APART]
    for part in numbers:
        assert isinstance(part.effect, Change)
        if not {each.name for each in part.variables} <= set(part.effect.target.args):
            return part.effect.target.name
    for one, other in combinations([part.effect for part in numbers], 2):
        assert isinstance(one, Change) and isinstance(other, Change)
        if one.target.name == other.target.name and all(
            a == b or is_variable(a) or is_variable(b) for a, b in zip(one.target.args, other.target.args, strict=True)
        ):
            return one.target.name
    return ""
