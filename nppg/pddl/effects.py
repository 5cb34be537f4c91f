"""The effects of PDDL and PPDDL."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nppg.pddl.declarations import variables
from nppg.pddl.formulas import CHANGES, Scope, atom, counted, expression, formula, value
from nppg.pddl.model import Add, Atom, Change, Delete, Each, Effect, Probabilistic, Together, When
from nppg.pddl.numbers import plain, probability
from nppg.pddl.tokens import Group, Node, Word, described, head

NOTHING = Together(())
ROUNDING = Fraction(1, 10**9)  # what probabilities may sum to above 1


def effect(node: Node | None, scope: Scope) -> Effect:
    """The effect of a node; nothing stands for what is wrong, which is reported."""
    if node is None or (isinstance(node, Group) and not node.items):
        return NOTHING
    key = head(node)
    if not isinstance(node, Group) or not key:
        hint = f" (did you mean '({node.text})'?)" if isinstance(node, Word) else ""
        scope.report(node, f"an effect is wanted, not {described(node)}{hint}")
        return NOTHING
    parts = node.items[1:]
    if key == "and":
        return Together(tuple(effect(each, scope) for each in parts))
    if key == "not":
        return _deletion(node, scope)
    if key == "when":
        if not counted(node, 2, scope):
            return NOTHING
        return When(formula(parts[0], scope), effect(parts[1], scope))
    if key == "forall":
        if not counted(node, 2, scope):
            return NOTHING
        declared = variables(scope.document, scope.vocabulary.types, parts[0])
        return Each(declared, effect(parts[1], scope.within(declared)))
    if key == "probabilistic":
        return _probabilistic(node, parts, scope)
    if key in CHANGES and key not in scope.vocabulary.predicates:
        if not counted(node, 2, scope):
            return NOTHING
        target, amount = value(parts[0], scope), expression(parts[1], scope)
        return NOTHING if target is None else Change(key, target, amount)
    changed = _changed(node, scope)
    return NOTHING if changed is None else Add(changed)


def _deletion(node: Group, scope: Scope) -> Effect:
    if not counted(node, 1, scope):
        return NOTHING
    part = node.items[1]
    if not isinstance(part, Group) or not head(part):
        scope.report(part, f"an atom is wanted, not {described(part)}")
        return NOTHING
    changed = _changed(part, scope)
    return NOTHING if changed is None else Delete(changed)


def _changed(node: Group, scope: Scope) -> Atom | None:
    """The atom that is added or deleted; None where a mistake has been reported."""
    found = atom(node, scope, "an effect")
    if found is not None and found.name in scope.vocabulary.derived:
        scope.report(node, f"'{found.name}' is derived: an effect cannot change it")
    return found


def _probabilistic(node: Group, parts: Sequence[Node], scope: Scope) -> Effect:
    if not parts or len(parts) % 2:
        scope.report(node, "'probabilistic' has pairs of a probability and an effect")
        return NOTHING
    branches = []
    total = Fraction(0)
    for place, part in zip(parts[::2], parts[1::2], strict=True):
        share = _share(place, scope)
        total += share
        branches.append((plain(share), effect(part, scope)))
    if total > 1 + ROUNDING:
        scope.report(node, f"the probabilities sum to {float(total):.10g}, above 1")
    return Probabilistic(tuple(branches))


def _share(node: Node, scope: Scope) -> Fraction:
    """The probability of a node; 0 stands for what is wrong, which is reported."""
    if isinstance(node, Group):
        scope.report(node, f"a probability is a number like 0.5 or 1/2, not {described(node)}")
        return Fraction(0)
    found = probability(node.text)
    if found is None or not 0 <= found <= 1:
        scope.report(node, f"a probability is a number from 0 to 1, not {described(node)}")
        return Fraction(0)
    return found
