"""Variables, literals and queries.

A query is a conjunction of literals. Its first `roots` variables, the root variables, are bound by the
example (the arguments of its action and of its goal); all others are existential. Because root variables
are bound, a query is true exactly if each of its *components* is: the parts that share no existential
variable. A component is therefore the unit that is asked of Prolog and whose answer is kept.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

Constant = str | int | float


OPEN = {"=<": -math.inf, ">=": math.inf}  # by the names of bounds


class Real(float):
    """A float among the constants of queries. It is equal to what Prolog takes for the same, so 1.0 is not 1 and -0.0
    not 0.0, as they are to Python; two queries that name them are two."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, float) and exact(self) == exact(other)

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = float.__hash__


def exact(value: object) -> object:
    """What is equal for two ground terms exactly where they are the same to Prolog."""
    if isinstance(value, float):
        return "float", value.hex()
    if isinstance(value, tuple):
        return tuple(map(exact, value))
    return type(value), value


def constant(value: Constant) -> Constant:
    """A value as the constant of a query."""
    return Real(value) if isinstance(value, float) else value


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
