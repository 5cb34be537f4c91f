"""Which examples a test covers.

Most answers are there already, for the examples come with those of a table. What a node needs beyond them, tests about
the existential variables of its query, is asked of Prolog as query packs: one call for all candidates on all examples
of the node.
"""

from __future__ import annotations

import weakref
from collections.abc import Mapping, Sequence

import numpy as np

from nppg.answers.facts import FactTable, suffices
from nppg.answers.table import Table, TestTable
from nppg.answers.words import WORD, measure, unpacked
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, Refinement, Refiner
from nppg.bridge.prolog import ask, exclusively
from nppg.bridge.terms import encoded, plain
from nppg.errors import NppgError
from nppg.logic.query import Literal, Query
from nppg.worlds.domain import Domain
from nppg.worlds.state import Interpretation, facts_of
from nppg.worlds.world import Action, State

Known = Mapping[Query, np.ndarray]


@exclusively("_ask")
class Coverage:
    """The answers of tests on a fixed list of examples.

    `bits` holds the answers to the table's tests, one row per example; where it is not given it is asked for.
    """

    def __init__(
        self,
        table: Table,
        states: Sequence[State],
        actions: Sequence[Action],
        bits: np.ndarray | None = None,
    ):
        self.table = table
        self.states = states
        self.actions = actions
        self._kept: list[Interpretation] = []  # the states that Prolog has, for their static facts are kept there
        self.bits = self._ask_table() if bits is None else bits

    def _runs(self) -> list[tuple[int, int]]:
        """The stretches of examples that stand in the same state."""
        starts = [i for i, state in enumerate(self.states) if i == 0 or state is not self.states[i - 1]]
        return list(zip(starts, [*starts[1:], len(self.states)], strict=True))

    def _ask_table(self) -> np.ndarray:
        return self.table.answers_in([(self.states[a], self.actions[a:b]) for a, b in self._runs()])

    def matrix(self, candidates: Sequence[Refinement], members: np.ndarray, known: Known) -> tuple[np.ndarray, Known]:
        """The answers, shape (members, candidates), and what is now known.

        `members` are the indices of the examples on which the candidates' query holds; `known` holds the answers
        that were asked for at the nodes above.
        """
        columns = self.table.columns(candidates)
        if (columns >= 0).all():
            return self.bits.take(members, axis=0).take(columns, axis=1), known
        missing = [
            each for each, column in zip(candidates, columns, strict=True) if column < 0 and each.test not in known
        ]
        if missing:
            known = {**known, **self._ask(missing, members)}
        result = np.empty((len(members), len(candidates)), self.bits.dtype)
        for i, (each, column) in enumerate(zip(candidates, columns, strict=True)):
            result[:, i] = self.bits[members, column] if column >= 0 else known[each.test][members]
        return result, known

    def _ask(self, candidates: Sequence[Refinement], members: np.ndarray) -> dict[Query, np.ndarray]:
        if isinstance(self.table, FactTable):
            own = FactTable(self.table.domain, self.table.bias)
            own.add(each.test for each in candidates)
            return dict(zip(own.tests, Coverage(own, self.states, self.actions).bits.T, strict=True))
        assert isinstance(self.table, TestTable)
        self._load(self.table)
        by_prefix: dict[Query, list[Refinement]] = {}
        for each in candidates:
            if not each.is_open:
                by_prefix.setdefault(each.prefix, []).append(each)
        packs = [
            (prefix, group[i : i + WORD]) for prefix, group in by_prefix.items() for i in range(0, len(group), WORD)
        ]
        bounds = [each.test for each in candidates if each.is_open]
        asked = [[encoded(prefix), [encoded(each.literals) for each in pack]] for prefix, pack in packs]
        self.table.domain.forget()
        try:
            words = ask("cover", self.table.name, [*asked, *map(measure, bounds)], members.tolist())
        except NppgError as error:
            pairs = [(self.states[i], [self.actions[i]]) for i in members]
            raise self.table.located(error, [each.test for each in candidates], pairs) from None
        by_pack = [words[i :: len(packs) + len(bounds)] for i in range(len(packs) + len(bounds))]
        answers: dict[Query, np.ndarray] = {}

        def note(test: Query, values: np.ndarray | list[float]) -> None:
            answers[test] = np.zeros(len(self.actions), self.bits.dtype)
            answers[test][members] = values

        for (_, pack), own in zip(packs, by_pack, strict=False):
            bits = unpacked(np.array(own, "<i8")[:, None])
            for i, each in enumerate(pack):
                note(each.test, bits[:, i] if self.bits.dtype == bool else ~bits[:, i])
        for test, values in zip(bounds, by_pack[len(packs) :], strict=True):
            note(test, values)
        return answers

    def _load(self, table: TestTable) -> None:
        if table.loaded() is not self:
            runs = self._runs()
            numbers = np.repeat(np.arange(len(runs)), [b - a for a, b in runs]).tolist()
            pairs = [[number, action] for number, action in zip(numbers, plain(self.actions), strict=True)]
            table.domain.forget()
            self._kept = states = [table.domain.interpreted(self.states[a]) for a, _ in runs]
            ask("examples", table.name, [[table.domain.static_number(each), facts_of(each)] for each in states], pairs)
            table.loaded = weakref.ref(self)


def root_table(domain: Domain, bias: LanguageBias, refiner: Refiner) -> Table:
    """The table of the tests that any node may ask: the refinements of the empty query, of every kind of action."""
    queries: list[Query] = [()]
    if len(bias.actions) > 1:
        queries += [(Literal(KIND, (kind,)),) for kind in range(len(bias.actions))]
    tests = [each.test for query in queries for each in refiner.refinements(query)]
    return table_of(tests, domain, bias)


def table_of(tests: Sequence[Query], domain: Domain, bias: LanguageBias) -> Table:
    """A table with these tests."""
    table = FactTable(domain, bias) if suffices(tests, domain, bias) else TestTable(domain, bias)
    table.add(tests)
    return table
