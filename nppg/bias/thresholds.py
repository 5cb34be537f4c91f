"""The thresholds of bounds in queries: those yet open, and those that take the place of others."""

from __future__ import annotations

from nppg.logic.query import OPEN, Literal, Query


def closed(query: Query, limit: float) -> Query:
    """A query with the threshold that makes its limit this one in place of OPEN; see logic.opened."""
    return tuple(
        Literal(each.name, (each.args[0], limit if each.name == "=<" else 0.0 - limit)) if is_open(each) else each
        for each in query
    )


def is_open(literal: Literal) -> bool:
    """Whether it is a bound whose threshold is still to be found."""
    return literal.name in OPEN and literal.args[1] == OPEN[literal.name]


def is_closed(literal: Literal) -> bool:
    return literal.name in OPEN and not is_open(literal)


def ranked(core: Query) -> tuple[Query, list[float]]:
    """The query with the ranks of its thresholds in their place, and the thresholds by rank. Queries that differ in
    thresholds alone have the same refinements but for these."""
    thresholds = sorted({float(each.args[1]) for each in core if each.name in OPEN})  # type: ignore[arg-type]
    if not thresholds:
        return core, thresholds
    ranks = {threshold: rank for rank, threshold in enumerate(thresholds)}
    return tuple(
        Literal(each.name, (each.args[0], ranks[each.args[1]])) if each.name in OPEN else each  # type: ignore[index]
        for each in core
    ), thresholds


def unranked(query: Query, thresholds: list[float]) -> Query:
    """With the thresholds in place of their ranks, which are floats where the form of a query with equal thresholds was
    remembered."""
    if not any(map(is_closed, query)):
        return query
    return tuple(
        Literal(each.name, (each.args[0], thresholds[int(each.args[1])]))  # type: ignore[arg-type]
        if is_closed(each)
        else each
        for each in query
    )
