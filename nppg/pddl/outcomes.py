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
    And,
    Arithmetic,
    Change,
    Delete,
    Domain,
    Each,
    Effect,
    Equal,
    Expression,
    Formula,
    Not,
    Probabilistic,
    Together,
    Typed,
    Value,
    When,
)
from nppg.pddl.names import APART
from nppg.pddl.normal import conjuncts, is_variable, simplified

_SUMMED = ("increase", "decrease")  # changes of the same number that come to one


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

    required = _different(conjuncts(simplified(action.precondition)))
    found = []
    for outcome in all_of(action.effect):
        parts = _united(outcome.parts)
        if met := _doubled(parts):
            raise refuse(f"two of its effects may change the same number, {met}")
        while pair := _meeting(parts, required):
            if not all(each.always and _change(each).operator in _SUMMED for each in pair):
                raise refuse(f"two of its effects may change the same number, {_change(pair[0]).target.name}")
            parts = (*(each for each in parts if each not in pair), *_split(*pair))
        found.append(replace(outcome, parts=parts))
    return tuple(found)


def _united(parts: tuple[Conditional, ...]) -> tuple[Conditional, ...]:
    """Changes of the same number that always happen, put together."""
    amounts: dict[Value, Change] = {}
    others = []
    for part in parts:
        change = part.effect
        if part.always and isinstance(change, Change) and change.operator in _SUMMED:
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


def _change(part: Conditional) -> Change:
    assert isinstance(part.effect, Change)
    return part.effect


def _numbers(parts: Iterable[Conditional]) -> list[Conditional]:
    """Those that change a number of the state."""
    return [part for part in parts if isinstance(part.effect, Change) and part.effect.target.name not in APART]


def _doubled(parts: Iterable[Conditional]) -> str:
    """The function of a change that may come about several times for one number, or nothing."""
    for part in _numbers(parts):
        if not {each.name for each in part.variables} <= set(_change(part).target.args):
            return _change(part).target.name
    return ""


def _meeting(parts: Iterable[Conditional], required: set[frozenset[str]]) -> tuple[Conditional, Conditional] | None:
    """Two changes that may be about the same number. `required`: the pairs of terms that the precondition has as
    different objects."""
    for one, other in combinations(_numbers(parts), 2):
        if _change(one).target.name == _change(other).target.name and not _told_apart(one, other, required):
            return one, other
    return None


def _told_apart(one: Conditional, other: Conditional, required: set[frozenset[str]]) -> bool:
    """Whether the two never change the same number: their conditions exclude each other, or two arguments have
    different names, or are said to be different."""
    if not (one.variables or other.variables):
        conditions = {*one.condition, *other.condition}
        if Not(_same(one, other)) in conditions or any(Not(each) in conditions for each in conditions):
            return True
    inner, others_inner = ({each.name for each in part.variables} for part in (one, other))
    for a, b in zip(_change(one).target.args, _change(other).target.args, strict=True):
        if a != b and not is_variable(a) and not is_variable(b):
            return True
        said = set[frozenset[str]]()
        if not {a, b} & (inner | others_inner):
            said |= required
        if b not in inner | others_inner:
            said |= _different(one.condition)
        if a not in inner | others_inner:
            said |= _different(other.condition)
        if a != b and frozenset((a, b)) in said:
            return True
    return False


def _different(formulas: Iterable[Formula]) -> set[frozenset[str]]:
    """The pairs of terms that are said to be different objects."""
    equations = (each.part for each in formulas if isinstance(each, Not))
    return {frozenset((each.left, each.right)) for each in equations if isinstance(each, Equal)}


def _split(one: Conditional, other: Conditional) -> tuple[Conditional, ...]:
    """Two changes, each for itself where they are about different numbers, and as one where these are the same."""
    same = _same(one, other)
    (united,) = _united((one, Conditional(replace(_change(other), target=_change(one).target))))
    return tuple(
        replace(part, condition=(*part.condition, condition))
        for part, condition in ((one, Not(same)), (other, Not(same)), (united, same))
    )


def _same(one: Conditional, other: Conditional) -> Formula:
    """That two changes are about the same number."""
    pairs = zip(_change(one).target.args, _change(other).target.args, strict=True)
    equations = tuple(Equal(a, b) for a, b in pairs if a != b)
    return equations[0] if len(equations) == 1 else And(equations)
