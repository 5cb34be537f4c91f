"""Regression learners: what fits the tree of an iteration to its examples, behind one protocol."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Protocol

import numpy as np

from nppg.answers.coverage import Coverage, root_table
from nppg.answers.table import Table
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, Refiner
from nppg.learning.options import Options
from nppg.logic.query import Constant, Literal, Query, Var
from nppg.trees import cart
from nppg.trees.tilde import Newton, Split, grow
from nppg.trees.tree import Leaf, Node, Tree
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State


@dataclass(frozen=True, slots=True)
class Examples:
    """State-action pairs, those of one state standing together; with the rows of the table's answers about them,
    shape (pairs, tests), the target of each, shape (pairs,), what makes the tree a second-order step, if it is, and the
    unit of the targets: the size of what they are made from."""

    states: list[State]
    actions: list[Action]
    answers: np.ndarray
    targets: np.ndarray
    newton: Newton | None = None
    unit: float | None = None

    def of(self, members: np.ndarray) -> Examples:
        """Those with these indices."""
        return Examples(
            [self.states[i] for i in members],
            [self.actions[i] for i in members],
            self.answers[members],
            self.targets[members],
            self.newton and replace(self.newton, curvatures=self.newton.curvatures[members]),
            self.unit,
        )


class Regressor(Protocol):
    """Fits trees to examples that `table` describes."""

    table: Table

    def fit(self, examples: Examples, query: Query = ()) -> Tree:
        """A tree for the pairs for which `query` holds, as it does for all examples: its rules are about them alone,
        as if the tree stood in the success branch of nodes that ask the query."""


class Tilde:
    """TILDE under a language bias; see nppg.trees.tilde."""

    def __init__(self, domain: Domain, bias: LanguageBias):
        self.refiner = Refiner(bias)
        self.table = root_table(domain, bias, self.refiner)
        self.limits = bias.tree

    def fit(self, examples: Examples, query: Query = ()) -> Tree:
        coverage = Coverage(self.table, examples.states, examples.actions, examples.answers)
        return grow(examples.targets, coverage, self.refiner, self.limits, examples.newton, query, examples.unit)


class Cart:
    """CART among the tests that TILDE has at the root; see nppg.trees.cart."""

    def __init__(self, domain: Domain, bias: LanguageBias):
        cart.scikit_learn(bias.tree)  # what is wrong is said before anything is played
        self.table = root_table(domain, bias, Refiner(bias))
        self.limits = bias.tree

    def fit(self, examples: Examples, query: Query = ()) -> Tree:
        newton, unit = examples.newton, examples.unit
        return cart.grow(examples.targets, examples.answers, self.table, self.limits, newton, query, unit)


class PerAction:
    """A tree of its own for each kind of action, grown by `learner` on that kind's examples alone. The tree of an
    iteration asks for the kind first; kinds without an example get 0."""

    def __init__(self, learner: Regressor, kinds: Sequence[Query]):
        self.learner = learner
        self.table = learner.table
        self.kinds = kinds

    def fit(self, examples: Examples, query: Query = ()) -> Tree:
        """`query` is empty: kinds are asked for at the root alone."""
        found: list[tuple[Query, tuple[Query, ...], Tree]] = []
        rest = np.ones(len(examples.targets), bool)
        for kind in self.kinds:
            tests = self.table.bias.forms.deciding_tests(query, kind)
            own = np.all([Split(*self.table.place(test)).covered(examples.answers) for test in tests], axis=0)
            if own.any():
                found.append((kind, tests, self.learner.fit(examples.of(np.flatnonzero(own)), query + kind)))
            rest &= ~own
        tree = self.learner.fit(examples.of(np.flatnonzero(rest)), query) if rest.any() else Leaf(0.0)
        for kind, tests, own_tree in reversed(found):
            tree = Node(kind, tests, own_tree, tree)
        return tree


def kinds_of_actions(bias: LanguageBias) -> list[Query]:
    """Queries that tell the kinds of actions apart: the declared ones; where only one is declared and a mode equal/2
    names constants for each of its arguments, these constants. None where there is nothing to tell apart."""
    if len(bias.actions) > 1:
        return [(Literal(KIND, (kind,)),) for kind in range(len(bias.actions))]
    (action,) = bias.actions
    constants = [_constants(bias, type_) for type_ in action.types]
    if not constants:
        return []
    return [tuple(Literal("=", (Var(i), each)) for i, each in enumerate(chosen)) for chosen in product(*constants)]


def _constants(bias: LanguageBias, type_: str) -> list[Constant]:
    """Those that a variable of this type may be compared with."""
    equalities = [mode.args for mode in bias.modes if mode.name == "="]
    pairs = [pair for left, right in equalities for pair in ((left, right), (right, left))]
    found = [arg.constants for arg, other in pairs if other.kind == "+" and bias.fits(type_, other.type)]
    return list(dict.fromkeys(constant for each in found for constant in each))


REGRESSORS: dict[str, Callable[[Domain, LanguageBias], Regressor]] = {"tilde": Tilde, "cart": Cart}


def regressor(domain: Domain, bias: LanguageBias, options: Options) -> Regressor:
    """The one that the options ask for."""
    learner = REGRESSORS[options.regressor](domain, bias)
    kinds = kinds_of_actions(bias) if options.models == "per-action" else []
    return PerAction(learner, kinds) if kinds else learner
