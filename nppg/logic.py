"""Variables, literals, queries and θ-subsumption.

A query is a conjunction of literals. Its first `roots` variables, the root variables, are bound by the
example (the arguments of its action and of its goal); all others are existential. Because root variables
are bound, a query is true exactly if each of its *components* is: the parts that share no existential
variable. A component is therefore the unit that is asked of Prolog and whose answer is kept.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import permutations
from typing import NamedTuple

Constant = str | int | float


OPEN = {"=<": -math.inf, ">=": math.inf}  # by the names of bounds


class Var(NamedTuple):
    """A variable, known by its number."""

    index: int  # type: ignore[assignment]


Term = Var | Constant


class Literal(NamedTuple):
    """An atom over variables and constants; the name `=` is equality."""

    name: str
    args: tuple[Term, ...]

    def variables(self) -> Iterator[Var]:
        return (arg for arg in self.args if isinstance(arg, Var))


def implies(literal: Literal, weaker: Literal) -> bool:
    """Whether both bound one term in one direction, the first at least as tightly."""
    if literal.name != weaker.name or literal.name not in OPEN or literal.args[0] != weaker.args[0]:
        return False
    limit, other = literal.args[1], weaker.args[1]
    assert isinstance(limit, int | float) and isinstance(other, int | float)
    return limit <= other if literal.name == "=<" else limit >= other


def tightened(query: Iterable[Literal]) -> Query:
    """Without the bounds that another bound of the query implies."""
    kept = tuple(dict.fromkeys(query))
    if not any(literal.name in OPEN for literal in kept):
        return kept
    return tuple(each for each in kept if not any(other != each and implies(other, each) for other in kept))


Query = tuple[Literal, ...]
Substitution = Mapping[Var, Term]


def substitute(query: Iterable[Literal], theta: Substitution) -> Query:
    """The query under a substitution."""
    if not theta:
        return tuple(query)
    return tuple(
        Literal(name, tuple(theta.get(arg, arg) if isinstance(arg, Var) else arg for arg in args))
        for name, args in query
    )


def variables(query: Iterable[Literal]) -> list[Var]:
    """The variables of a query in the order of their first occurrence."""
    return list(dict.fromkeys(var for literal in query for var in literal.variables()))


def components(query: Iterable[Literal], roots: int) -> list[Query]:
    """Splits a query into its components; literals keep their order."""
    parts: list[tuple[set[Var], list[int]]] = []
    literals = list(query)
    for position, literal in enumerate(literals):
        own = {var for var in literal.variables() if var.index >= roots}
        members = [position]
        apart = []
        for part in parts:
            if part[0] & own:
                own |= part[0]
                members += part[1]
            else:
                apart.append(part)
        parts = [*apart, (own, members)]
    return [tuple(literals[i] for i in sorted(members)) for _, members in sorted(parts, key=lambda part: min(part[1]))]


def solve_equalities(query: Iterable[Literal], roots: int) -> tuple[dict[Var, Term], bool]:
    """The most general unifier of the query's equalities, and whether there is one.

    Root variables stand for existential ones, earlier root variables for later ones, constants for all.
    """
    theta: dict[Var, Term] = {}

    def find(term: Term) -> Term:
        while isinstance(term, Var) and term in theta:
            term = theta[term]
        return term

    for name, args in query:
        if name == "=":
            left, right = find(args[0]), find(args[1])
            if left == right and type(left) is type(right):
                continue
            if not isinstance(left, Var) and not isinstance(right, Var):
                return {}, False
            if not isinstance(left, Var) or (isinstance(right, Var) and left.index < right.index):
                left, right = right, left
            assert isinstance(left, Var)
            theta[left] = right
    return {var: find(var) for var in theta}, True


def subsumes(general: Query, special: Query, roots: int) -> bool:
    """Whether `general` θ-subsumes `special`: some substitution of its existential variables maps every
    literal of `general` into `special`, or to a bound that one of `special` implies."""
    by_name: dict[tuple[str, int], list[Literal]] = {}
    for literal in special:
        by_name.setdefault((literal.name, len(literal.args)), []).append(literal)

    def match(position: int, theta: dict[Var, Term]) -> bool:
        if position == len(general):
            return True
        name, args = general[position]
        terms = args[:1] if name in OPEN else args
        for candidate in by_name.get((name, len(args)), ()):
            if name in OPEN and not implies(candidate, Literal(name, (candidate.args[0], args[1]))):
                continue
            extended = dict(theta)
            for arg, target in zip(terms, candidate.args, strict=False):
                if isinstance(arg, Var) and arg.index >= roots:
                    if extended.setdefault(arg, target) != target:
                        break
                elif arg != target or type(arg) is not type(target):
                    break
            else:
                if match(position + 1, extended):
                    return True
        return False

    return match(0, {})


def reduced(query: Query, roots: int) -> Query:
    """The query without duplicates and without literals that θ-subsumption makes redundant (Plotkin's
    reduction)."""
    kept = list(tightened(query))
    for literal in reversed(list(kept)):
        if any(var.index >= roots for var in literal.variables()):
            rest = [other for other in kept if other != literal]
            if subsumes(tuple(kept), tuple(rest), roots):
                kept = rest
    return tuple(kept)


def _sort_key(literal: Literal) -> tuple:
    return (
        literal.name,
        tuple(
            (0, arg.index, "") if isinstance(arg, Var) else (1, 0, f"{type(arg).__name__} {arg}")
            for arg in literal.args
        ),
    )


def canonical(query: Query, roots: int) -> Query:
    """Renames the existential variables so that queries which differ only by their names and by the order of
    literals become equal as sets. The order stays: a literal may need the variables that an earlier one binds.
    Exact for up to six existential variables; beyond that variables keep their order of occurrence, so equal
    queries may then be told apart but never confused."""
    existential = sorted(var for var in variables(query) if var.index >= roots)
    if not existential:
        return tuple(dict.fromkeys(query))
    names = [Var(roots + i) for i in range(len(existential))]
    orders = permutations(existential) if len(existential) <= 6 else [tuple(existential)]
    renamed = (substitute(query, dict(zip(order, names, strict=True))) for order in orders)
    return tuple(dict.fromkeys(min(renamed, key=lambda each: sorted(map(_sort_key, set(each))))))


def normal_form(query: Query, roots: int) -> Query | None:
    """Equalities solved, redundancies removed, variables renamed: for θ-equivalent queries equal as sets.

    Equalities between root variables stay as literals. Returns None for a query that cannot be true.
    """
    theta, solvable = solve_equalities(query, roots)
    if not solvable:
        return None
    kept = [Literal("=", (term, var)) for var, term in sorted(theta.items()) if var.index < roots]
    rest = substitute((literal for literal in query if literal.name != "="), theta)
    return canonical(reduced((*kept, *rest), roots), roots)


def opened(test: Query) -> tuple[Query, float]:
    """What decides a test, and its limit: the test holds exactly if the value of what decides it is at most the limit.

    That of a test without a bound is 0 where it holds, else 1. That of a test with `X =< c` is the least X for which
    its other literals hold, of one with `X >= c` the least -X; infinity where there is none. Of several bounds an open
    one counts, else the first."""
    bounds = [i for i, each in enumerate(test) if each.name in OPEN]
    if not bounds:
        return test, 0.5
    i = min(bounds, key=lambda i: test[i].args[1] != OPEN[test[i].name])
    name, (term, limit) = test[i]
    assert isinstance(limit, int | float)
    open_test = (*test[:i], Literal(name, (term, OPEN[name])), *test[i + 1 :])
    return open_test, float(limit if name == "=<" else -limit)


def deciding_tests(query: Query, literals: Query, roots: int) -> tuple[Query, ...]:
    """The tests, in normal form, that all hold exactly if `query` still does when `literals` are added to it.

    Raises ValueError where the literals contradict the query.
    """
    own = [part for part in components(query + literals, roots) if any(each in literals for each in part)]
    forms = [normal_form(part, roots) for part in own]
    if None in forms:
        raise ValueError("the tests contradict each other")
    return tuple(form for form in forms if form is not None)
