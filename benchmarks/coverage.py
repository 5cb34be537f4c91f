"""Coverage: candidate tests answered per second, in NumPy's hands, and the same tests asked one by one."""

from __future__ import annotations

import time
from collections.abc import Iterator

import janus_swi
import numpy as np

from benchmarks.common import Row, random_pairs, timed
from nppg import Domain, LanguageBias
from nppg.answers.coverage import Coverage, root_table
from nppg.bias.refinement import Refiner
from nppg.bridge.files import locate
from nppg.logic.query import Literal, Query, Var

STATES = 1000
ALONE = 50  # every so many states are asked one by one as well
SHARED: Query = (Literal("on", (Var(0), Var(4))),)  # on(X, Z)


def rows() -> Iterator[Row]:
    domain = Domain("blocks_world")
    pairs = random_pairs(domain, STATES, np.random.default_rng(0))
    states = [state for state, actions in pairs for _ in actions]
    actions = [action for _, own in pairs for action in own]
    sample = np.flatnonzero([i % ALONE == 0 for i, (_, own) in enumerate(pairs) for _ in own])

    bias = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    table = root_table(domain, bias, Refiner(bias))
    seconds, coverage = timed(lambda: Coverage(table, states, actions))
    yield _row(
        f"coverage: {len(table)} root tests on {len(actions)} pairs of {STATES} states",
        *(seconds, coverage.bits, *_alone(domain, states, actions, sample, table.tests)),
        target=1.5e6,
    )

    bias = LanguageBias.load(locate("blocks_world_relational", "language_bias", ".yaml"))
    refiner = Refiner(bias)
    coverage = Coverage(root_table(domain, bias, refiner), states, actions)
    candidates = [each for each in refiner.refinements(SHARED) if each.prefix]
    seconds, (answers, _) = timed(lambda: coverage.matrix(candidates, np.arange(len(actions)), {}))
    tests = [SHARED + each.literals for each in candidates]
    yield _row(
        f"coverage: {len(candidates)} tests behind on(X, Z), new variables, the same pairs",
        *(seconds, answers, *_alone(domain, states, actions, sample, tests)),
    )


def _row(
    what: str,
    seconds: float,
    answers: np.ndarray,
    alone: float,
    expected: np.ndarray,
    sample: np.ndarray,
    target: float = 0,
) -> Row:
    assert (answers[sample] == expected).all(), f"{what}: the answers differ from those of single queries"
    rate, single = answers.size / seconds, expected.size / alone
    return Row(
        what,
        f"{rate / 1e6:.2f} million/s",
        f"{rate / single:.0f} times one query per test ({single / 1e6:.2f} million/s)",
        f">= {target / 1e6:.1f} million/s" if target else "",
        rate >= target if target else None,
    )


def _alone(
    domain: Domain, states: list, actions: list, sample: np.ndarray, tests: list[Query]
) -> tuple[float, np.ndarray, np.ndarray]:
    """Seconds and answers of one query per test, with constant texts and bound inputs, for a sample of the pairs."""
    texts = [f"'{domain.module}':({', '.join(map(_text, test))})" for test in tests]
    answers = np.empty((len(sample), len(tests)), bool)
    spent = 0.0
    for row, i in enumerate(sample):
        domain.visit(states[i])
        goal = next(fact[1:] for fact in states[i] if fact[0] == "goal_on")
        roots = {f"V{k}": value for k, value in enumerate((*actions[i][1:], *goal))}
        start = time.perf_counter()
        answers[row] = [janus_swi.query_once(each, {**roots})["truth"] for each in texts]
        spent += time.perf_counter() - start
    return spent, answers, sample


def _text(literal: Literal) -> str:
    args = [f"V{arg.index}" if isinstance(arg, Var) else repr(arg) for arg in literal.args]
    return " = ".join(args) if literal.name == "=" else f"{literal.name}({', '.join(args)})"
