"""What a problem's goal asks for: facts that are wanted, and conditions beyond them as terms for prolog/formula.pl."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import product
from math import prod

from nppg.errors import NppgError, Problem
from nppg.pddl.changing import changes, derived, fluents
from nppg.pddl.hierarchy import below_object, memberships
from nppg.pddl.model import (
    OBJECT,
    Add,
    And,
    Arithmetic,
    Atom,
    Compare,
    Delete,
    Domain,
    Equal,
    Exists,
    Expression,
    Forall,
    Formula,
    Not,
    Or,
    PlanningProblem,
    Typed,
    Value,
)
from nppg.pddl.names import Names

Ground = str | int | float | tuple  # a name, a number, or a tuple of a name and its arguments

_MOST = 1000  # literals of a goal that are counted
_OPERATORS = {"<": "<", "<=": "=<", "=": "=:=", ">=": ">=", ">": ">"}


def goal_parts(problem: PlanningProblem, domain: Domain) -> list[Formula]:
    """What the goal wants, each for itself; of what it wants of all objects, the literals of each of them."""
    members: dict[str, list[str]] = {}
    for type_, name in memberships(domain, (*domain.constants, *problem.objects)):
        members.setdefault(type_, []).append(name)

    def parts(formula: Formula) -> list[Formula]:
        if isinstance(formula, And):
            return [inner for part in formula.parts for inner in parts(part)]
        if isinstance(formula, Forall):
            return _literals(formula, {}, members) or [formula]
        return [formula]

    return parts(problem.goal)


def _literals(formula: Formula, bound: Mapping[str, str], members: Mapping[str, list[str]]) -> list[Formula] | None:
    """The literals that a formula is the conjunction of, with objects for variables; None if there is none."""
    if isinstance(formula, Atom):
        return [Atom(formula.name, tuple(bound.get(each, each) for each in formula.args))]
    if isinstance(formula, Not) and isinstance(formula.part, Atom):
        return [Not(atom) for atom in _literals(formula.part, bound, members) or ()]
    if isinstance(formula, And):
        choices = [(part, bound) for part in formula.parts]
    elif isinstance(formula, Forall):
        names = [
            dict.fromkeys(name for type_ in each.types for name in members.get(type_, ())) for each in formula.variables
        ]
        if prod(map(len, names)) > _MOST:
            return None
        variables = [each.name for each in formula.variables]
        choices = [(formula.part, {**bound, **dict(zip(variables, chosen, strict=True))}) for chosen in product(*names)]
    else:
        return None
    found: list[Formula] = []
    for part, inner in choices:
        own = _literals(part, inner, members)
        if own is None or len(found) + len(own) > _MOST:
            return None
        found += own
    return found


def goal_predicates(problem: PlanningProblem, domain: Domain) -> frozenset[str]:
    """The predicates that the goal wants facts of, which actions change or rules derive."""
    moving = fluents(domain) | derived(domain)
    parts = goal_parts(problem, domain)
    return frozenset(part.name for part in parts if isinstance(part, Atom) and part.name in moving)


def literals(formula: Formula, problem: PlanningProblem, domain: Domain) -> int:
    """The number of literals in a goal, those under a quantifier once for each choice of objects; 1000 at most."""
    sizes: dict[str, int] = {}
    for type_, _ in memberships(domain, (*domain.constants, *problem.objects)):
        sizes[type_] = sizes.get(type_, 0) + 1

    def count(formula: Formula) -> int:
        if isinstance(formula, And | Or):
            return sum(map(count, formula.parts))
        if isinstance(formula, Not):
            return count(formula.part)
        if isinstance(formula, Forall | Exists):
            choices = 1
            for each in formula.variables:
                choices *= sum(sizes.get(type_, 0) for type_ in each.types)
            return choices * count(formula.part)
        return 1

    return min(_MOST, count(formula))


def condition_term(formula: Formula, problem: PlanningProblem, domain: Domain, names: Names, has_object: bool) -> tuple:
    """A formula as prolog/formula.pl knows it. `has_object`: the domain file has the type object.

    Raises NppgError for a quantifier over all objects, where it has not and there are objects without a type."""

    def types(typed: Typed) -> Ground:
        wanted = list(typed.types)
        if OBJECT in wanted and not has_object:
            untyped = [each.name for each in (*domain.constants, *problem.objects) if OBJECT in each.types]
            if untyped:
                message = f"the goal ranges over all objects, of which {untyped[0]} has no type"
                raise NppgError([Problem(problem.file, 0, 0, message)])
            wanted = list(below_object(domain))
        called = [names.types[type_] for type_ in wanted]
        return called[0] if len(called) == 1 else listed(called)

    def term(formula: Formula) -> tuple:
        if isinstance(formula, Atom):
            return ("holds", fact(names.predicates[formula.name], formula.args))
        if isinstance(formula, Equal):
            return ("eq", formula.left, formula.right)
        if isinstance(formula, Compare):
            return ("compare", _OPERATORS[formula.operator], number(formula.left), number(formula.right))
        if isinstance(formula, Not):
            return ("not", term(formula.part))
        if isinstance(formula, And | Or):
            return ("and" if isinstance(formula, And) else "or", listed(map(term, formula.parts)))
        kind = "forall" if isinstance(formula, Forall) else "exists"
        return (kind, listed(("-", each.name, types(each)) for each in formula.variables), term(formula.part))

    def number(expression: Expression) -> Ground:
        if isinstance(expression, Value):
            return ("value", fact(names.functions[expression.name], expression.args))
        if isinstance(expression, Arithmetic):
            first, *others = map(number, expression.operands)
            if not others:
                return (expression.operator, first)
            for other in others:
                first = (expression.operator, first, other)
            return first
        return expression

    return term(formula)


def fact(name: str, args: Sequence[Ground]) -> Ground:
    """A fact as Python has it: a tuple, or its name alone."""
    return (name, *args) if args else name


def listed(items: Iterable[Ground]) -> tuple:
    """A list of Prolog."""
    result: tuple = ("[]",)
    for item in reversed(list(items)):
        result = ("[|]", item, result)
    return result


def unreachable(problem: PlanningProblem, domain: Domain) -> list[str]:
    """What the goal wants and no action can reach, a message for each."""
    added = {each.atom.name for each in changes(domain) if isinstance(each, Add)} | derived(domain)
    deleted = {each.atom.name for each in changes(domain) if isinstance(each, Delete)} | derived(domain)
    initial = set(problem.init)
    messages = []
    for part in goal_parts(problem, domain):
        if isinstance(part, Atom) and part.name not in added and part not in initial:
            why = f"it does not hold, and no action adds {part.name}"
        elif isinstance(part, Not) and part.part in initial and part.part.name not in deleted:
            why = f"it holds, and no action deletes {part.part.name}"
        else:
            continue
        messages.append(f"the goal {_text(part)} cannot be reached: {why}")
    return messages


def _text(literal: Atom | Not) -> str:
    if isinstance(literal, Not):
        return f"(not {_text(literal.part)})"  # type: ignore[arg-type]
    return f"({' '.join((literal.name, *literal.args))})"
