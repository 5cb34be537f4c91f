"""The refinement operator: candidates per second against modes, lookahead and depth.

The bias has as many modes as wanted, about binary predicates and an action of two arguments. The queries are random
paths of a depth, under a refiner that has seen none of them. They are held against the normal forms of all extended
queries, told one by one.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from random import Random

from benchmarks.common import Row
from nppg import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.logic.query import Query
from nppg.logic.subsumption import normal_form

QUERIES = 12
SETTINGS = [(5, 1, 2), (15, 1, 2), (30, 1, 2), (60, 1, 2), (15, 0, 2), (15, 2, 2), (15, 1, 0), (15, 1, 1), (15, 1, 3)]


def rows() -> Iterator[Row]:
    for modes, lookahead, depth in SETTINGS:
        seconds, candidates, plain = measured(modes, lookahead, depth)
        yield Row(
            f"refinement, {modes} modes, lookahead {lookahead}, depth {depth}",
            f"{candidates / seconds:,.0f} candidates/s",
            f"{plain / seconds:.1f} times telling each normal form by itself ({candidates / plain:,.0f} candidates/s)",
        )


def measured(modes: int, lookahead: int, depth: int) -> tuple[float, int, float]:
    """Seconds of the operator, the candidates that it gives, and seconds of telling normal forms one by one."""
    queries = [path(bias(modes, lookahead), depth, Random(seed)) for seed in range(QUERIES if depth else 1)]
    refiner = Refiner(bias(modes, lookahead))
    clock = time.process_time()
    found = [refiner.refinements(query) for query in queries]
    seconds = time.process_time() - clock
    clock = time.process_time()
    assert [len(plainly(refiner, query)) for query in queries] == [len(each) for each in found]
    return seconds, sum(map(len, found)), time.process_time() - clock


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
