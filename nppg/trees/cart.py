"""CART by scikit-learn: regression trees over the answers of a table, a vector of fixed length.

It chooses among the table's tests alone, none of which is about a variable that another has introduced. A split is a
test of its column, with a threshold where the answer is a number, and the tree is one like TILDE's.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from nppg.answers.table import Table
from nppg.bias.declarations import TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, closed, is_open
from nppg.errors import NppgError
from nppg.logic.query import Literal, Query, Var, substitute, variables
from nppg.trees.given import must_be_finite
from nppg.trees.tilde import Newton, is_pure, is_significant, leaf, size_of
from nppg.trees.tree import Node, Tree

_LARGEST = float(np.finfo(np.float32).max)  # scikit-learn rounds what it splits to single precision


def scikit_learn(limits: TreeLimits) -> Any:
    """An unfitted tree with these limits. Raises NppgError where scikit-learn is missing, or for a limit that it does
    not know."""
    try:
        from sklearn.tree import DecisionTreeRegressor
    except ImportError:
        raise NppgError("CART needs scikit-learn: pip install 'nppg[cart]'") from None
    if limits.granularity:
        raise NppgError("CART tries every cut point: the limit granularity is TILDE's")
    return DecisionTreeRegressor(max_depth=limits.max_depth, min_samples_leaf=limits.min_examples, random_state=0)


def grow(
    targets: np.ndarray,
    rows: np.ndarray,
    table: Table,
    limits: TreeLimits,
    newton: Newton | None = None,
    query: Query = (),
    unit: float | None = None,
) -> Tree:
    """Grows a tree for one target per row of answers: of means, or for a second-order step; below `query`, which holds
    for all. The splits of the latter are those of the targets f / h weighted by h; `regularisation` and `clip` are a
    matter of the leaves. `unit` is as in TILDE. Raises NppgError as scikit_learn() does."""
    must_be_finite("the target", targets)
    unfitted, unit = scikit_learn(limits), size_of(targets) if unit is None else unit
    every = np.arange(len(targets))
    if limits.max_depth == 0 or rows.size == 0:
        return leaf(targets, every, newton)
    numbers = np.where(rows, 0.0, 1.0) if rows.dtype == bool else rows
    wanted, weights = targets / _power_of_2(size_of(targets)), None  # to scikit-learn a variance of 2e-16 is none
    if newton:
        weights = np.maximum(newton.curvatures, 1e-12 * (size_of(newton.curvatures) or 1.0))
        wanted = targets / weights
        wanted /= _power_of_2(size_of(wanted))
    found = unfitted.fit(np.minimum(numbers, _LARGEST), wanted, sample_weight=weights).tree_

    def node(number: int, query: Query, members: np.ndarray, asked: dict[int, Query]) -> Tree:
        column = int(found.feature[number])
        if column < 0 or is_pure(targets[members], limits, unit):
            return leaf(targets, members, newton)
        limit = float(found.threshold[number])
        if limit > _LARGEST / 4:  # between the last value and none at all
            limit = float(numbers[np.isfinite(numbers[:, column]), column].max())
        covered = numbers[members, column] <= limit
        if not newton and not _is_significant(targets[members], covered, limits, unit):
            return leaf(targets, members, newton)
        literals, test, renamed = _test(table, column, limit, query, asked)
        return Node(
            literals,
            test,
            node(found.children_left[number], query + literals, members[covered], {**asked, column: renamed}),
            node(found.children_right[number], query, members[~covered], asked),
        )

    return node(0, query, every, {})


def _power_of_2(number: float) -> float:
    """The least that is above a number, by which dividing rounds nothing."""
    return 2.0 ** math.frexp(number)[1]


def _is_significant(values: np.ndarray, covered: np.ndarray, limits: TreeLimits, unit: float) -> bool:
    squares, inside = (float(((each - each.mean()) ** 2).sum()) for each in (values, values[covered]))
    outside = values[~covered]
    rest = inside + float(((outside - outside.mean()) ** 2).sum()) if len(outside) else inside
    return is_significant(squares - rest, squares, len(values), limits.significance, unit)


def _test(
    table: Table, column: int, limit: float, query: Query, asked: dict[int, Query]
) -> tuple[Query, tuple[Query, ...], Query]:
    """The literals that a column's test adds to a query, the tests that these are, and the column's open test in the
    variables of the query, in which a test of the same column further down the query bounds its variable once more."""
    bias, test = table.bias, table.tests[column]
    if column in asked:
        renamed = asked[column]
        literals = tuple(filter(is_open, renamed))
    else:
        renamed = literals = _renamed(test, query, len(bias.roots))
    kind = _kind(test, query, bias)
    return (*kind, *closed(literals, limit)), (*([kind] if kind else []), closed(test, limit)), renamed


def _renamed(test: Query, query: Query, roots: int) -> Query:
    """The test with existential variables that the query does not have."""
    first = max([roots - 1, *(var.index for var in variables(query))]) + 1
    own = [var for var in variables(test) if var.index >= roots]
    return substitute(test, {var: Var(first + i) for i, var in enumerate(own)})


def _kind(test: Query, query: Query, bias: LanguageBias) -> Query:
    """The literal that says which kind of action the test is about, if it is about the arguments of one, and the query
    does not say so already."""
    if len(bias.actions) == 1 or any(each.name == KIND for each in (*query, *test)):
        return ()
    about = [var.index for var in variables(test) if var.index < bias.offsets[-1]]
    kinds = {
        kind
        for kind in range(len(bias.actions))
        for each in about
        if bias.offsets[kind] <= each < bias.offsets[kind + 1]
    }
    return tuple(Literal(KIND, (kind,)) for kind in kinds)
