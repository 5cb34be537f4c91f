"""One regression tree: seconds and held-out error, beside a propositional learner on ready-made columns.

The data set: ten blocks, uniformly random states and goals in which on(A, B) does not hold; half of the moves are
drawn from the optimal ones, half from all legal ones. The target is 1 if the move is optimal, else -1, and normal
noise of 0.1 is added.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks.common import Row, peak, timed
from nppg import Domain, LanguageBias
from nppg.answers.coverage import Coverage, root_table
from nppg.answers.table import TestTable
from nppg.bias.refinement import Refiner
from nppg.trees.tilde import Example, fit
from nppg.trees.tree import Leaf, Tree

LIMITS = {130: 0.03, 1000: 0.1, 5000: 0.3, 20_000: 1.0}  # examples: seconds
MANY = 100_000
LINEAR = 1.5  # times as long for each example as with the most of LIMITS
MEGABYTES = 1000
BIAS = Path(__file__).with_name("one_tree.yaml")
HELD_OUT = 2000
RMSE = 0.105  # at 1000 examples


def rows() -> Iterator[Row]:
    domain = Domain("blocks_world")
    bias = LanguageBias.load(BIAS)
    examples = data_set(domain, max(LIMITS) + HELD_OUT, np.random.default_rng(0))
    held_out = examples[-HELD_OUT:]
    for count, limit in LIMITS.items():
        first = examples[:count]
        runs = [timed(lambda first=first: fit(first, domain, bias)) for _ in range(max(3, min(9, 5000 // count)))]
        seconds = median(each for each, _ in runs)
        error = rmse(predictions(runs[0][1], domain, bias, held_out), held_out)
        bounds = f"<= {limit:g} s" + (f", RMSE <= {RMSE}" if count == 1000 else "")
        yield Row(
            f"one tree of depth 4 from {count} examples",
            f"{seconds:.3g} s, RMSE {error:.4f}",
            _floor(first, held_out, domain, bias, seconds),
            bounds,
            seconds <= limit and (count != 1000 or error <= RMSE),
        )
    run = subprocess.run([sys.executable, "-m", __name__], check=True, capture_output=True, text=True)
    least, most, kilobytes = map(float, run.stdout.split())
    growth, megabytes = most / MANY / (least / max(LIMITS)), kilobytes / 1024
    yield Row(
        f"one tree of depth 4 from {MANY} examples, in a fresh process",
        f"{most:.3g} s, peak memory {megabytes:.0f} MB",
        f"{growth:.2f} times the time for each example of {max(LIMITS)} ({least:.3g} s)",
        f"<= {LINEAR:g} times, <= {MEGABYTES} MB",
        growth <= LINEAR and megabytes <= MEGABYTES,
    )


def data_set(domain: Domain, size: int, rng: np.random.Generator) -> list[Example]:
    """Examples, each in a state of its own."""

    def example() -> Example:
        state = domain.start(rng)
        optimal = domain.expert_actions(state)
        drawn_from = optimal if rng.random() < 0.5 else domain.situation(state).actions
        action = drawn_from[int(rng.integers(len(drawn_from)))]
        return Example(state, action, (1.0 if action in optimal else -1.0) + 0.1 * float(rng.standard_normal()))

    return [example() for _ in range(size)]


def predictions(tree: Tree, domain: Domain, bias: LanguageBias, examples: list[Example]) -> np.ndarray:
    """What the tree says of each example."""
    table = TestTable(domain, bias)
    table.add(_tests(tree))
    answers = _bits(table, examples)
    result = np.empty(len(examples))

    def descend(tree: Tree, members: np.ndarray) -> None:
        if isinstance(tree, Leaf):
            result[members] = tree.value
        else:
            holds = answers[np.ix_(members, [table.place(test)[0] for test in tree.tests])].all(axis=1)
            descend(tree.yes, members[holds])
            descend(tree.no, members[~holds])

    descend(tree, np.arange(len(examples)))
    return result


def _tests(tree: Tree) -> list:
    return [] if isinstance(tree, Leaf) else [*tree.tests, *_tests(tree.yes), *_tests(tree.no)]


def _bits(table: TestTable, examples: list[Example]) -> np.ndarray:
    return Coverage(table, [each.state for each in examples], [each.action for each in examples]).bits


def rmse(predicted: np.ndarray, examples: list[Example]) -> float:
    return float(np.sqrt(np.mean((predicted - [each.value for each in examples]) ** 2)))


def _floor(train: list[Example], held_out: list[Example], domain: Domain, bias: LanguageBias, seconds: float) -> str:
    """scikit-learn's tree on the answers to all tests of the root, which it is given for nothing."""
    try:
        from sklearn.tree import DecisionTreeRegressor
    except ImportError:
        return "scikit-learn is not installed"
    table = root_table(domain, bias, Refiner(bias))
    columns, other = _bits(table, train), _bits(table, held_out)
    targets = [each.value for each in train]
    model = DecisionTreeRegressor(max_depth=4, min_samples_leaf=2, random_state=0)
    spent = median(timed(lambda: model.fit(columns, targets))[0] for _ in range(5))
    error = rmse(model.predict(other), held_out)
    return f"{seconds / spent:.0f} times scikit-learn on {len(table)} ready columns ({spent:.2g} s, RMSE {error:.4f})"


def _many() -> None:
    """Prints the seconds of the most of LIMITS and of MANY examples, and the peak memory in KiB."""
    domain, bias = Domain("blocks_world"), LanguageBias.load(BIAS)
    examples = data_set(domain, MANY, np.random.default_rng(0))
    for count in (max(LIMITS), MANY):
        print(timed(lambda count=count: fit(examples[:count], domain, bias))[0])
    print(peak())


if __name__ == "__main__":
    _many()
