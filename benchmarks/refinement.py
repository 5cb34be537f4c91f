"""The refinement operator: candidates per second against modes, lookahead and depth.

The bias has as many modes as wanted, about binary predicates and an action of two arguments. The queries are random
paths of a depth, under a refiner that has seen none of them. They are held against the normal forms of all extended
queries, told one by one.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from benchmarks.common import Row, timed
from nppg import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.logic.query import Query
from nppg.logic.subsumption import normal_form

QUERIES = 4
SETTINGS = [(5, 1, 2), (15, 1, 2), (30, 1, 2), (60, 1, 2), (15, 0, 2), (15, 2, 2), (15, 1, 0), (15, 1, 1), (15, 1, 3)]


def rows() -> Iterator[Row]:
    for setting in SETTINGS:
        refiner, queries = setting_of(*setting)
        seconds, found = timed(lambda refiner=refiner, queries=queries: [refiner.refinements(each) for each in queries])
        plain, told = timed(lambda refiner=refiner, queries=queries: [plainly(refiner, each) for each in queries])
        assert list(map(len, found)) == list(map(len, told)), "some refinements are equivalent, or one is missing"
        candidates = sum(map(len, found))
        yield Row(
            "refinement, {} modes, lookahead {}, depth {}".format(*setting),
            f"{candidates / seconds:,.0f} candidates/s",
            f"{plain / seconds:.1f} times telling each normal form by itself ({candidates / plain:,.0f} candidates/s)",
        )


def setting_of(modes: int, lookahead: int, depth: int) -> tuple[Refiner, list[Query]]:
    """An operator that has seen no query, and queries of this depth."""
    queries = [path(bias(modes, lookahead), depth, Random(seed)) for seed in range(QUERIES if depth else 1)]
    return Refiner(bias(modes, lookahead)), queries


def plainly(refiner: Refiner, query: Query) -> list[Query]:
    """The refinements of a query by the normal forms of all extended queries."""
    seen = {frozenset(normal_form(query, refiner.root_count) or ())}
    found = []
    for literals in refiner.extensions(query):
        form = normal_form(query + literals, refiner.root_count)
        if form is not None and frozenset(form) not in seen:
            seen.add(frozenset(form))
            found.append(literals)
    return found


def bias(modes: int, lookahead: int) -> LanguageBias:
    """With so many modes: of each predicate three, one that bridges to a new variable with lookahead."""
    names = [f"p{i}" for i in range((modes + 2) // 3)]
    lines = [
        text
        for name in names
        for text in (
            f'  - "{name}(+, +)"',
            f'  - {{literal: "{name}(+, -)", lookahead: {lookahead}}}',
            f'  - "{name}(-, +)"',
        )
    ]
    types = ", ".join(f"{name}: [thing, thing]" for name in names)
    head = f"action: act(+thing, +thing)\ntypes: {{{types}}}\nmax_variables: 4\nlookahead: {lookahead}\nmodes:\n"
    return LanguageBias.parse(head + "\n".join(lines[:modes]) + "\n", "modes.yaml")


def path(given: LanguageBias, depth: int, rng: Random) -> Query:
    """A query on a random path down a tree."""
    refiner, query = Refiner(given), ()
    for _ in range(depth):
        query += rng.choice(refiner.refinements(query)).literals
    return query
