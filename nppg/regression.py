"""Regression learners: what fits the tree of an iteration to its examples, behind one protocol."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from nppg import cart
from nppg.coverage import Coverage, root_table
from nppg.domain import Action, Domain, State
from nppg.language_bias import LanguageBias
from nppg.logic import Query
from nppg.options import Options
from nppg.refinement import Refiner
from nppg.table import Table
from nppg.tilde import Newton, grow
from nppg.tree import Tree


@dataclass(frozen=True, slots=True)
class Examples:
    """State-action pairs, those of one state standing together; with the rows of the table's answers about them,
    shape (pairs, tests), the target of each, shape (pairs,), and what makes the tree a second-order step, if it is."""

    states: list[State]
    actions: list[Action]
    answers: np.ndarray
    targets: np.ndarray
    newton: Newton | None = None


class Regressor(Protocol):
    """Fits trees to examples that `table` describes."""

    table: Table

    def fit(self, examples: Examples, query: Query = ()) -> Tree:
        """A tree for the pairs for which `query` holds, as it does for all examples: its rules are about them alone,
        as if the tree stood in the success branch of nodes that ask the query."""


class Tilde:
    """TILDE under a language bias; see nppg.tilde."""

    def __init__(self, domain: Domain, bias: LanguageBias):
        self.refiner = Refiner(bias)
        self.table = root_table(domain, bias, self.refiner)
        self.limits = bias.tree

    def fit(self, examples: Examples, query: Query = ()) -> Tree:
        coverage = Coverage(self.table, examples.states, examples.actions, examples.answers)
        return grow(examples.targets, coverage, self.refiner, self.limits, examples.newton, query)


class Cart:
    """CART among the tests that TILDE has at the root; see nppg.cart."""

    def __init__(self, domain: Domain, bias: LanguageBias):
        self.table = root_table(domain, bias, Refiner(bias))
        self.limits = bias.tree

    def fit(self, examples: Examples, query: Query = ()) -> Tree:
        return cart.grow(examples.targets, examples.answers, self.table, self.limits, examples.newton, query)


REGRESSORS: dict[str, Callable[[Domain, LanguageBias], Regressor]] = {"tilde": Tilde, "cart": Cart}


def regressor(domain: Domain, bias: LanguageBias, options: Options) -> Regressor:
    """The one that the options ask for."""
    return REGRESSORS[options.regressor](domain, bias)
