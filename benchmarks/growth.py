"""How time grows with what a world, a policy or a data set has more of, and the exponent of that growth.

The exponent is the slope of a line through the logarithms, by least squares.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from pathlib import Path

import numpy as np

from benchmarks import one_tree, refinement
from benchmarks.common import Row, random_pairs
from nppg import Domain, LanguageBias, Options, Policy, train
from nppg.answers.coverage import root_table
from nppg.bias.refinement import Refiner
from nppg.bridge.files import locate
from nppg.judging.evaluation import evaluate
from nppg.tilde import fit
from nppg.worlds.world import State

BLOCKS = (5, 10, 20, 50, 100, 200)
TREES = (100, 200, 500, 1000, 2000, 5000)
EXAMPLES = (1000, 3000, 10_000, 30_000, 100_000)
MODES = (5, 10, 20, 40, 60)
LOOKAHEAD = (0, 1, 2)
FACTS = (10, 100, 1000, 10_000, 50_000)
STEPS = 40  # of an episode in a large world
LINEAR = 1.15  # an exponent up to this is linear, for the first sizes have fixed costs, and the last ones fill caches
FIELD = """\
:- module(field, []).
:- fluent at/1, stone/1.
start([at(0)|Stones]) :- parameter(size, N), findall(stone(I), between(1, N, I), Stones).
:- parameter(size, 10).
action(go(Y)) :- at(X), ( Y is X+1 ; Y is X-1 ).
effect(go(Y), [at(X)], [at(Y)]) :- at(X).
goal :- fail.
horizon(50).
"""
FIELD_BIAS = """\
action: go(+spot)
types: {at: [spot], stone: [spot]}
modes: [stone(+), at(+)]
"""


def rows() -> Iterator[Row]:
    yield from _blocks()
    yield _row("summing a policy's trees for 2,000 new rows of answers, by trees", TREES, _sums(), "s")
    yield _row("one tree, by examples", EXAMPLES, _fits(), "s")
    yield _row(
        "refinements of four queries of two tests, by modes",
        MODES,
        (_refined(modes, 1) for modes in MODES),
        "s",
        "with lookahead each literal is followed by each mode about its new variable: candidates grow as the square",
    )
    yield _row(
        "refinements of four queries of two tests, by 1 + lookahead",
        [1 + each for each in LOOKAHEAD],
        (_refined(15, lookahead) for lookahead in LOOKAHEAD),
        "s",
        "each literal more multiplies candidates by the modes about its new variable",
    )
    yield _row("a step, by facts in the state", FACTS, _steps(), "ms")


def _row(what: str, sizes: Sequence[int], times: Iterator[float], unit: str, reason: str = "") -> Row:
    found = list(times)
    exponent = float(np.polyfit(np.log(sizes), np.log(found), 1)[0])
    measured = ", ".join(f"{size:,}: {each:.3g} {unit}" for size, each in zip(sizes, found, strict=True))
    return Row(what, measured, f"exponent {exponent:.2f}", reason or f"<= {LINEAR}", exponent <= LINEAR)


def _blocks() -> Iterator[Row]:
    """The same trees in worlds of ever more blocks."""
    bias = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    *_, last = train(Domain("blocks_world"), bias, Options(episodes=300))
    worlds = [Domain("blocks_world", {"blocks": blocks}) for blocks in BLOCKS]
    policies = [_copied(last.policy, world, bias) for world in worlds]
    reason = (
        "legal actions grow so, too: a move for each two towers, whose number is about the root of twice the blocks"
    )
    yield _row("a step of training, by blocks", BLOCKS, (_trained(world, bias) for world in worlds), "ms", reason)
    yield _row("a step by 100 trees, by blocks", BLOCKS, map(_acted, policies), "ms", reason)
    yield _row(
        "an episode of an evaluation, by blocks",
        BLOCKS,
        map(_evaluated, policies),
        "ms",
        f"{reason}; episodes last longer",
    )


def _copied(policy: Policy, domain: Domain, bias: LanguageBias, most: int = 100) -> Policy:
    """With the first trees alone."""
    copy = Policy(domain, bias, root_table(domain, bias, Refiner(bias)))
    for tree in policy.trees[:most]:
        copy.add(tree)
    return copy


def _trained(domain: Domain, bias: LanguageBias) -> float:
    clock = time.process_time()
    steps = sum(len(each.steps) for iteration in train(domain, bias, Options(episodes=60)) for each in iteration.recent)
    return 1000 * (time.process_time() - clock) / steps


def _acted(policy: Policy) -> float:
    rng = np.random.default_rng(0)
    states = [state for state, _ in random_pairs(policy.domain, STEPS + 1, rng)]
    policy.act(states[0], rng)
    return 1000 * _seconds(lambda: [policy.act(state, rng) for state in states[1:]]) / STEPS


def _evaluated(policy: Policy) -> float:
    return 1000 * _seconds(lambda: evaluate(policy, STEPS)) / STEPS


def _sums() -> Iterator[float]:
    """Of trees learned in the blocks world."""
    domain, bias = Domain("blocks_world"), LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    learned = next(
        each.policy for each in train(domain, bias, Options(episodes=10**6)) if len(each.policy.trees) == 1000
    )
    rows = np.random.default_rng(0).random((2000, len(learned.table))) < 0.3
    for count in TREES:
        policy = Policy(domain, bias, learned.table)
        for tree in islice((tree for _ in range(5) for tree in learned.trees), count):
            policy.add(tree)
        policy.potentials_of(rows[:1])
        yield _seconds(lambda policy=policy: policy.potentials_of(rows))  # type: ignore[misc]


def _fits() -> Iterator[float]:
    domain, bias = Domain("blocks_world"), LanguageBias.load(one_tree.BIAS)
    examples = one_tree.data_set(domain, max(EXAMPLES), np.random.default_rng(0))
    for count in EXAMPLES:
        yield _seconds(lambda count=count: fit(examples[:count], domain, bias))  # type: ignore[misc]


def _refined(modes: int, lookahead: int) -> float:
    refiner, queries = refinement.setting_of(modes, lookahead, 2)
    return _seconds(lambda: [refiner.refinements(query) for query in queries])


def _steps() -> Iterator[float]:
    """Of somebody who walks among ever more stones."""
    bias = LanguageBias.parse(FIELD_BIAS, "field.yaml")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "field.pl")
        file.write_text(FIELD)
        for facts in FACTS:
            domain = Domain(file, {"size": facts - 1})
            policy = Policy(domain, bias, root_table(domain, bias, Refiner(bias)))
            rng = np.random.default_rng(0)
            state = _walked(policy, domain.start(rng), rng)
            yield 1000 * _seconds(lambda: _walked(policy, state, rng)) / STEPS  # noqa: B023  # called at once


def _walked(policy: Policy, state: State, rng: np.random.Generator) -> State:
    for _ in range(STEPS):
        state = policy.domain.act(state, policy.act(state, rng), rng)[1]
    return state


def _seconds(function: Callable[[], object]) -> float:
    clock = time.process_time()
    function()
    return time.process_time() - clock
