"""Potentials: state-action pairs per second under policies of 100, 500 and 2000 learned trees.

The states are freshly drawn. `cold` is the first time that a policy, put together anew, meets them; `warm` the second,
when it remembers the rows of answers. Both times Prolog is asked for the answers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from benchmarks.common import Row, random_pairs, timed
from nppg import Domain, LanguageBias, Options, Policy, train
from nppg.answers.coverage import root_table
from nppg.bias.refinement import Refiner
from nppg.bridge.files import locate
from nppg.worlds.world import Action, State

SIZES = (100, 500, 2000)
STATES = 2000
CLAUSES = 20  # states for which the clauses are summed, too
WANTED = 60_000


def rows() -> Iterator[Row]:
    domain = Domain("blocks_world")
    bias = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    learned = next(
        each.policy for each in train(domain, bias, Options(episodes=10**6)) if len(each.policy.trees) == max(SIZES)
    )
    states = random_pairs(domain, STATES, np.random.default_rng(10**6))
    pairs = sum(len(actions) for _, actions in states)
    few = states[:CLAUSES]
    fewest = 0.0
    for size in SIZES:
        policy = Policy(domain, bias, root_table(domain, bias, Refiner(bias)))
        for tree in learned.trees[:size]:
            policy.add(tree)
        cold, fast = timed(partial(_potentials, policy.potentials, states))
        warm, _ = timed(partial(_potentials, policy.potentials, states))
        clauses, summed = timed(partial(_potentials, policy.prolog_potentials, few))
        assert all((a == b).all() for a, b in zip(fast, summed, strict=False)), "the arrays differ from the clauses"
        one_by_one = clauses / sum(map(len, summed))
        fewest = fewest or cold
        growth = f", {cold / fewest:.1f} times the time of {SIZES[0]} trees" if size > SIZES[0] else ""
        yield Row(
            f"potentials, {size} trees, {pairs} pairs of {STATES} states",
            f"{pairs / cold:,.0f} pairs/s cold, {pairs / warm:,.0f} warm",
            f"{one_by_one * pairs / cold:.0f} times clause by clause ({1 / one_by_one:,.0f} pairs/s){growth}",
            f">= {WANTED:,} pairs/s" if size == 500 else "",
            pairs / cold >= WANTED if size == 500 else None,
        )


def _potentials(ask: Callable[[State, list[Action]], np.ndarray], states: list) -> list[np.ndarray]:
    return [ask(state, actions) for state, actions in states]
