"""Pruning of grown trees: by C4.5's pessimistic estimate of errors (Quinlan 1993), or by what other examples say.

A subtree gives way to a leaf where that is expected to err no more. The estimates are those of C4.5's program, which
ACE prints too.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from nppg.trees.tree import Leaf, Node, Tree

_LEVELS = (0.0, 0.001, 0.005, 0.01, 0.05, 0.10, 0.20, 0.40, 1.00)
_DEVIATES = (4.0, 3.09, 2.58, 2.33, 1.65, 1.28, 0.84, 0.25, 0.00)
_SLACK = 0.1  # errors: so many more are no reason to keep a subtree, in C4.5


def safe(tree: Tree) -> Tree:
    """The same classes for all examples: a node both of whose branches are leaves of one class becomes one."""

    def joined(yes: Tree, no: Tree) -> bool:
        return isinstance(yes, Leaf) and isinstance(no, Leaf) and yes.value == no.value

    return _upwards(tree, lambda _, yes, no: joined(yes, no))


def pessimistic(tree: Tree, confidence: float) -> Tree:
    """With leaves in place of those subtrees whose leaves are expected to err at least as often on other examples: the
    upper limit, at this confidence, of a leaf's share of errors."""

    def worth(node: Node, yes: Tree, no: Tree) -> bool:
        own = expected_errors(merged(Node(node.literals, node.tests, yes, no)), confidence)
        return own <= expected_errors(yes, confidence) + expected_errors(no, confidence) + _SLACK

    return _upwards(tree, worth)


def by_validation(
    tree: Tree,
    grown_on: np.ndarray,
    others: np.ndarray,
    leaf: Callable[[np.ndarray], Leaf],
    errors: Callable[[Leaf, np.ndarray], float],
    passes: Callable[[Node, np.ndarray], np.ndarray],
) -> Tree:
    """Reduced-error pruning: with leaves in place of those subtrees that err at least as much on the examples `others`.

    `leaf` makes one of the examples that a tree was `grown_on`, `errors` tells what it does on some, and `passes` which
    of some examples pass a node's test."""

    def pruned(tree: Tree, own: np.ndarray, others: np.ndarray) -> tuple[Tree, float]:
        if isinstance(tree, Leaf):
            return tree, errors(tree, others)
        by, of = passes(tree, own), passes(tree, others)
        yes, wrong_yes = pruned(tree.yes, own[by], others[of])
        no, wrong_no = pruned(tree.no, own[~by], others[~of])
        instead = leaf(own)
        wrong = errors(instead, others)
        if wrong <= wrong_yes + wrong_no:
            return instead, wrong
        return Node(tree.literals, tree.tests, yes, no), wrong_yes + wrong_no

    return pruned(tree, grown_on, others)[0]


def _upwards(tree: Tree, replaceable: Callable[[Node, Tree, Tree], bool]) -> Tree:
    """With leaves, from below, in place of the nodes for which that is so, given their branches by then."""
    if isinstance(tree, Leaf):
        return tree
    yes, no = _upwards(tree.yes, replaceable), _upwards(tree.no, replaceable)
    node = Node(tree.literals, tree.tests, yes, no)
    return merged(node) if replaceable(tree, yes, no) else node


def leaves_of(tree: Tree) -> list[Leaf]:
    """Its leaves, in order."""
    return [tree] if isinstance(tree, Leaf) else [*leaves_of(tree.yes), *leaves_of(tree.no)]


def merged(tree: Tree) -> Leaf:
    """The leaf of all examples of a tree of classes."""
    found = leaves_of(tree)
    sums = [math.fsum(weights) for weights in zip(*(each.values for each in found), strict=True)]
    return Leaf(float(sums.index(max(sums))), sum(each.examples for each in found), tuple(sums))


def expected_errors(tree: Tree, confidence: float) -> float:
    """The sum over the leaves of the weight of their examples times the upper limit of the share of errors."""
    total = 0.0
    for leaf in leaves_of(tree):
        size = math.fsum(leaf.values)
        wrong = size - leaf.values[int(leaf.value)]
        total += wrong + added_errors(size, wrong, confidence)
    return total


def added_errors(size: float, wrong: float, confidence: float) -> float:
    """C4.5's AddErrs: how many more errors are to be expected of a leaf with `wrong` of `size` examples."""
    if wrong < 1e-6:
        return size * (1 - math.exp(math.log(confidence) / size)) if size > 0 else 0.0
    if wrong < 0.9999:
        none = added_errors(size, 0.0, confidence)
        return none + wrong * (added_errors(size, 1.0, confidence) - none)
    if wrong + 0.5 >= size:
        return 0.67 * (size - wrong)
    i = next(i for i, level in enumerate(_LEVELS) if confidence <= level)
    share = (confidence - _LEVELS[i - 1]) / (_LEVELS[i] - _LEVELS[i - 1])
    square = (_DEVIATES[i - 1] + (_DEVIATES[i] - _DEVIATES[i - 1]) * share) ** 2
    middle = wrong + 0.5
    upper = middle + square / 2 + math.sqrt(square * (middle * (1 - middle / size) + square / 4))
    return size * upper / (size + square) - wrong
