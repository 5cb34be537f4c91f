"""Formulas of PDDL without what they can do without, and what is in them."""

from __future__ import annotations

from collections.abc import Iterator

from nppg.pddl.model import And, Arithmetic, Atom, Compare, Equal, Exists, Expression, Forall, Formula, Not, Or, Value


def is_variable(term: str) -> bool:
    """Whether a term is a variable, not an object."""
    return term.startswith("?")


def simplified(formula: Formula) -> Formula:
    """The same without `forall`, without conjunctions in conjunctions, and without what a negation can do without."""
    if isinstance(formula, Not):
        return negation(formula.part)
    if isinstance(formula, And):
        parts = [simplified(part) for part in formula.parts]
        return _flat(And, [inner for part in parts for inner in (part.parts if isinstance(part, And) else (part,))])
    if isinstance(formula, Or):
        parts = [simplified(part) for part in formula.parts]
        return _flat(Or, [inner for part in parts for inner in (part.parts if isinstance(part, Or) else (part,))])
    if isinstance(formula, Forall):
        return negation(Exists(formula.variables, negation(formula.part)))
    if isinstance(formula, Exists):
        return Exists(formula.variables, simplified(formula.part))
    return formula


def negation(formula: Formula) -> Formula:
    """What holds where the formula does not, simplified."""
    if isinstance(formula, Not):
        return simplified(formula.part)
    if isinstance(formula, Or):
        return simplified(And(tuple(Not(part) for part in formula.parts)))
    if isinstance(formula, Forall):
        return Exists(formula.variables, negation(formula.part))
    part = simplified(formula)
    if isinstance(part, And) and not part.parts:
        return Or(())
    return negation(part) if isinstance(part, Not | Or) else Not(part)


def _flat(kind: type[And] | type[Or], parts: list[Formula]) -> Formula:
    return parts[0] if len(parts) == 1 else kind(tuple(parts))


def conjuncts(formula: Formula) -> tuple[Formula, ...]:
    """The parts of a simplified formula that must all hold."""
    return formula.parts if isinstance(formula, And) else (formula,)


def free(formula: Formula) -> set[str]:
    """The variables that no quantifier in it binds."""
    if isinstance(formula, Atom):
        return {term for term in formula.args if is_variable(term)}
    if isinstance(formula, Equal):
        return {term for term in (formula.left, formula.right) if is_variable(term)}
    if isinstance(formula, Compare):
        return {
            term
            for side in (formula.left, formula.right)
            for value in values(side)
            for term in value.args
            if is_variable(term)
        }
    if isinstance(formula, Not):
        return free(formula.part)
    if isinstance(formula, And | Or):
        return set().union(*map(free, formula.parts))
    return free(formula.part) - {each.name for each in formula.variables}


def values(expression: Expression) -> Iterator[Value]:
    """The functions in an expression, from left to right."""
    if isinstance(expression, Value):
        yield expression
    elif isinstance(expression, Arithmetic):
        for operand in expression.operands:
            yield from values(operand)


def atoms(formula: Formula) -> Iterator[Atom]:
    """The atoms in a formula, negated ones too."""
    if isinstance(formula, Atom):
        yield formula
    elif isinstance(formula, And | Or):
        for part in formula.parts:
            yield from atoms(part)
    elif isinstance(formula, Not | Forall | Exists):
        yield from atoms(formula.part)
