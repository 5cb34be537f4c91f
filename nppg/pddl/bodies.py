"""Formulas as bodies of Prolog clauses.

The literals are put in an order that is fast in large states: next comes a test whose variables are all bound, else the
atom that is expected to have the fewest answers, by the numbers of facts in the problems; where none are known, that
with the fewest unbound variables, among equals a fluent's before a static one's. A type is asked where no atom of the
conjunction guarantees it, and gives the values of a variable that no atom binds.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from nppg.errors import NppgError, Problem
from nppg.pddl.changing import derived, fluents
from nppg.pddl.clauses import Choice, Infix, Negated, Once, Part, Term, Var
from nppg.pddl.hierarchy import fits
from nppg.pddl.model import Arithmetic, Atom, Compare, Domain, Equal, Exists, Expression, Formula, Not, Or, Typed, Value
from nppg.pddl.names import APART, Names
from nppg.pddl.normal import conjuncts, free, is_variable, simplified

_OPERATORS = {"<": "<", "<=": "=<", "=": "=:=", ">=": ">=", ">": ">"}


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """A domain, what its parts are called, and how many facts a predicate has in the problems' initial states."""

    domain: Domain
    names: Names
    sizes: Mapping[str, float] = field(default_factory=dict)


@dataclass(slots=True)
class Scope:
    """What is known at one place in a body: the variables by name, the types of those that still need a check, those
    that are bound, and the values of functions."""

    variables: dict[str, Var] = field(default_factory=dict)
    types: dict[Var, tuple[str, ...]] = field(default_factory=dict)
    bound: set[Var] = field(default_factory=set)
    values: dict[tuple[str, tuple[Part, ...]], Var] = field(default_factory=dict)

    def inner(self) -> Scope:
        """What is known in a part of the body, which tells the rest nothing."""
        return Scope(dict(self.variables), {}, set(self.bound), dict(self.values))

    def declare(self, typed: Iterable[Typed]) -> list[Var]:
        """Takes up new variables, which hide others of their names."""
        new = []
        for each in typed:
            var = self.variables[each.name] = Var(each.name)
            self.types[var] = each.types
            new.append(var)
        return new


@dataclass(frozen=True, slots=True)
class _Pending:
    formula: Formula
    variables: Mapping[str, Var]

    def free(self) -> set[Var]:
        return {self.variables[name] for name in free(self.formula)}


def body(words: Vocabulary, formula: Formula, scope: Scope, inline: bool = False) -> tuple[Part, ...]:
    """The goals for a formula; all variables of the scope are bound by them. `inline`: answers may repeat."""
    pending = _pending(conjuncts(simplified(formula)), scope, inline)
    guaranteed = _guaranteed(words, pending, scope)
    goals: list[Part] = []
    checked: set[Var] = set(guaranteed)

    def check() -> None:
        for var, types in scope.types.items():
            if var in scope.bound and var not in checked:
                checked.add(var)
                goals.append(type_goal(words, types, var))

    check()
    while pending:
        ready = [each for each in pending if each.free() <= scope.bound or _binds(each, scope)]
        if ready:
            chosen = min(ready, key=lambda each: _effort(each.formula))
        else:
            generators = [each for each in pending if isinstance(each.formula, Atom)]
            if not generators:
                _generate(words, scope, checked, goals)
                continue
            chosen = min(generators, key=lambda each: _answers(words, each, scope))
        pending.remove(chosen)
        goals += _goals(words, chosen, scope)
        check()
    while any(var not in scope.bound for var in scope.types):
        _generate(words, scope, checked, goals)
    return tuple(goals)


def type_goal(words: Vocabulary, types: Sequence[str], var: Part) -> Part:
    """That a variable is of one of the types."""
    literals = [Term(words.names.types[type_], (var,)) for type_ in types]
    return literals[0] if len(literals) == 1 else Choice(tuple((literal,) for literal in literals))


def term(name: str, scope: Scope) -> Part:
    """An object or a variable of PDDL."""
    return scope.variables[name] if is_variable(name) else Term(name)


def atom_term(words: Vocabulary, atom: Atom, scope: Scope) -> Term:
    """An atom of PDDL."""
    return Term(words.names.predicates[atom.name], tuple(term(each, scope) for each in atom.args))


def number(words: Vocabulary, expression: Expression, scope: Scope, goals: list[Part]) -> Part:
    """An expression; the goals that look up its functions are added to `goals`."""
    if isinstance(expression, Value):
        return value(words, expression, scope, goals)
    if isinstance(expression, Arithmetic):
        first, *others = (number(words, operand, scope, goals) for operand in expression.operands)
        if not others:
            return Infix("-", Term(0), first) if expression.operator == "-" else first
        for other in others:
            first = Infix(expression.operator, first, other)
        return first
    return Term(expression)


def value(words: Vocabulary, function: Value, scope: Scope, goals: list[Part]) -> Var:
    """The variable for a function's value, which is looked up once."""
    if function.name in APART:
        message = f"({function.name}) can only be increased and decreased, not asked"
        raise NppgError([Problem(words.domain.file, 0, 0, message)])
    args = tuple(term(each, scope) for each in function.args)
    key = (function.name, args)
    if key not in scope.values:
        var = scope.values[key] = Var(function.name)
        scope.bound.add(var)
        goals.append(Term(words.names.functions[function.name], (*args, var)))
    return scope.values[key]


def _pending(parts: Iterable[Formula], scope: Scope, inline: bool) -> list[_Pending]:
    """The parts of a conjunction. What exists becomes part of it where its variables are to be found, too."""
    parts = list(parts)
    outside = scope.bound | {
        scope.variables[name] for part in parts if isinstance(part, Atom | Equal) for name in free(part)
    }
    found = []
    for part in parts:
        if isinstance(part, Exists) and (inline or not {scope.variables[name] for name in free(part)} <= outside):
            hidden = dict(scope.variables)
            scope.declare(part.variables)
            found += _pending(conjuncts(part.part), scope, inline)
            scope.variables = hidden
        else:
            found.append(_Pending(part, dict(scope.variables)))
    return found


def _guaranteed(words: Vocabulary, pending: Iterable[_Pending], scope: Scope) -> set[Var]:
    """The variables whose type follows from the declaration of an atom that they are in."""
    declared = {each.name: each.parameters for each in words.domain.predicates}
    return {
        var
        for each in pending
        if isinstance(each.formula, Atom)
        for name, parameter in zip(each.formula.args, declared.get(each.formula.name, ()), strict=False)
        if is_variable(name)
        and (var := each.variables[name]) in scope.types
        and fits(words.domain, parameter.types, scope.types[var])
    }


def _generate(words: Vocabulary, scope: Scope, checked: set[Var], goals: list[Part]) -> None:
    """Gives values to the first variable that has none."""
    var = next(var for var in scope.types if var not in scope.bound)
    goals.append(type_goal(words, scope.types[var], var))
    scope.bound.add(var)
    checked.add(var)


def _binds(pending: _Pending, scope: Scope) -> bool:
    """Whether it is an equation with one side known."""
    return isinstance(pending.formula, Equal) and len(pending.free() - scope.bound) < 2


def _effort(formula: Formula) -> int:
    if isinstance(formula, Atom | Equal):
        return 0
    if isinstance(formula, Not) and isinstance(formula.part, Atom | Equal):
        return 1
    return 2 if isinstance(formula, Compare) else 3


def _answers(words: Vocabulary, pending: _Pending, scope: Scope) -> tuple[float, int]:
    """Least for the fewest answers, as far as can be told: of n facts of k arguments, n^(u/k) where u are unbound."""
    atom = pending.formula
    assert isinstance(atom, Atom)
    unbound, kind = len(pending.free() - scope.bound), _kind(words, atom)
    if not words.sizes:
        return unbound, kind
    if atom.name in derived(words.domain):
        return max(words.sizes.values()) ** unbound, kind
    return max(words.sizes.get(atom.name, 0), 1) ** (unbound / len(atom.args)), kind


def _kind(words: Vocabulary, atom: Atom) -> int:
    return 0 if atom.name in fluents(words.domain) else 2 if atom.name in derived(words.domain) else 1


def _goals(words: Vocabulary, pending: _Pending, scope: Scope) -> list[Part]:
    """The goals for one part of a conjunction, whose variables they bind."""
    formula = pending.formula
    local = Scope(dict(pending.variables), {}, scope.bound, scope.values)
    if isinstance(formula, Atom):
        scope.bound |= pending.free()
        return [atom_term(words, formula, local)]
    if isinstance(formula, Equal):
        operator = "==" if pending.free() <= scope.bound else "="
        scope.bound |= pending.free()
        return [Infix(operator, term(formula.left, local), term(formula.right, local))]
    if isinstance(formula, Compare):
        goals: list[Part] = []
        sides = [number(words, side, local, goals) for side in (formula.left, formula.right)]
        return [*goals, Infix(_OPERATORS[formula.operator], *sides)]
    if isinstance(formula, Or):
        if not formula.parts:
            return [Term("fail")]
        return [Choice(tuple(body(words, part, local.inner()) for part in formula.parts))]
    if isinstance(formula, Exists):
        return [Once(_nested(words, formula, local.inner()))]
    assert isinstance(formula, Not), formula
    if isinstance(formula.part, Equal):
        return [Infix("\\==", term(formula.part.left, local), term(formula.part.right, local))]
    return [Negated(_nested(words, formula.part, local.inner()))]


def _nested(words: Vocabulary, formula: Formula, scope: Scope) -> tuple[Part, ...]:
    """The goals of what is only tested, so that it may have an answer several times."""
    return body(words, formula, scope, inline=True)
