"""Tests that are asked of every state-action pair, together.

A `Table` holds the refinements of the empty query and whatever the trees of a policy test. Their answers are kept with
the pair, for the potential and for all trees grown from it later. An answer is a truth value; or, where a language bias
has bounds, all answers are the numbers that decide tests, which hold where the number is at most the test's limit
(`logic.opened`): a bound is asked once for all its thresholds.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence

import numpy as np

from nppg.answers.comparing import located
from nppg.answers.words import Words
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refinement, is_open
from nppg.bridge.prolog import ask, drop_with, exclusively
from nppg.errors import NppgError
from nppg.logic.query import OPEN, Query, opened
from nppg.worlds.domain import Domain
from nppg.worlds.legal import LegalActions
from nppg.worlds.world import Action, State

_AT_ONCE = 10_000  # facts and actions that are handed over in one question
_MEMORY = 10_000  # lists of candidates whose columns are remembered


@exclusively("add", "columns")
class Table(ABC):
    """The tests of a domain and bias that are asked together."""

    def __init__(self, domain: Domain, bias: LanguageBias):
        self.domain = domain
        self.bias = bias
        self.tests: list[Query] = []  # of those with a bound, what decides them
        self.bounds: list[int] = []  # columns of those
        self.numeric = any(mode.name in OPEN for mode in bias.modes)  # whether answers are numbers
        self._index: dict[Query, int] = {}
        self._columns: dict[int, tuple[int, Sequence[Refinement], np.ndarray]] = {}

    def __len__(self) -> int:
        return len(self.tests)

    def __contains__(self, test: Query) -> bool:
        return opened(test)[0] in self._index

    def __reduce__(self) -> tuple:
        """A copy prepares the tests for itself."""
        return _again, (type(self), self.domain, self.bias, self.tests)

    def add(self, tests: Iterable[Query]) -> None:
        """Adds what is not there yet."""
        new = []
        for test, _ in map(opened, tests):
            if test not in self._index:
                column = self._index[test] = len(self.tests)
                self.tests.append(test)
                self.bounds += [column] if any(map(is_open, test)) else []
                new.append(column)
        if new:
            self.numeric = self.numeric or bool(self.bounds)
            self._prepare(new)

    @abstractmethod
    def _prepare(self, columns: Sequence[int]) -> None:
        """To be able to answer these, which are new."""

    @abstractmethod
    def answers(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        """Shape (actions, tests): booleans, or numbers where tests may have bounds."""

    def answers_in(self, pairs: Sequence[tuple[State, Sequence[Action]]]) -> np.ndarray:
        """The answers about actions in many states, one below the other."""
        rows = [self.answers(state, actions) for state, actions in pairs]
        return np.concatenate(rows) if rows else np.empty((0, len(self)), bool)

    def place(self, test: Query) -> tuple[int, float]:
        """The column of a test in what `answers` returns, and its limit there."""
        deciding, limit = opened(test)
        return self._index[deciding], limit

    def columns(self, candidates: Sequence[Refinement]) -> np.ndarray:
        """The column of each candidate's test, -1 where the table does not have it."""
        size, _, found = self._columns.get(id(candidates), (-1, None, np.empty(0, int)))
        if size != len(self):
            found = np.array([self._index.get(each.test, -1) for each in candidates], dtype=np.intp)
            if len(self._columns) >= _MEMORY:
                self._columns.clear()
            self._columns[id(candidates)] = (len(self), candidates, found)
        return found


def _again(kind: type[Table], domain: Domain, bias: LanguageBias, tests: Sequence[Query]) -> Table:
    table = kind(domain, bias)
    table.add(tests)
    return table


def _parts(pairs: Sequence[tuple[State, Sequence[Action]]]) -> Iterator[Sequence[tuple[State, Sequence[Action]]]]:
    """The pairs in parts of the size of a question."""
    first = size = 0
    for i, (state, actions) in enumerate(pairs):
        size += len(state) + len(actions)
        if size > _AT_ONCE or i + 1 == len(pairs):
            yield pairs[first : i + 1]
            first, size = i + 1, 0


@exclusively("answers", "answers_in")
class TestTable(Table):
    """Tests that are compiled into Prolog clauses."""

    __test__ = False  # it is no test case, whatever its name makes pytest think

    def __init__(self, domain: Domain, bias: LanguageBias):
        super().__init__(domain, bias)
        kinds = [[template.name, len(template.types)] for template in bias.actions]
        goal = [bias.goal.name, len(bias.goal.types)] if bias.goal else []
        if not domain.trusted:
            asked = [[mode.name, len(mode.args)] for mode in bias.modes]
            ask("harmless", domain.module, [goal, *asked] if goal else asked)
        self.name: str = ask("table", domain.module, kinds, goal)
        drop_with(self, "table_drop", self.name)
        self._words = Words(bias, self._is_static)
        self._has_answered = False
        self.loaded: Callable[[], object] = lambda: None  # the Coverage whose examples Prolog holds

    def _is_static(self, test: Query) -> bool:
        """Whether it has the same answer in every state of a problem, as far as the domain's program tells, and that is
        worth keeping."""
        called = {(each.name, len(each.args)) for each in test if each.name != "=" and each.name not in OPEN}
        return bool(called) and all(self.domain.loaded.is_static(*each) for each in called)

    def _prepare(self, columns: Sequence[int]) -> None:
        tests = [(column, self.tests[column]) for column in columns]
        self.domain.loaded.forget_answers()
        ask("tests", self.name, *self._words.add(tests, self.bounds if self.numeric else None, len(self)))

    def answers(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        if not self.tests and self._has_answered and state is self.domain.loaded.current:
            return np.empty((len(actions), 0), float if self.numeric else bool)  # asking would find no mistake, either
        try:
            found = self._asked(state, actions)
            self._has_answered = True
            return found
        except NppgError as error:
            bounded = [self.tests[column] for column in self.bounds]
            raise self.located(error, bounded, [(state, actions)]) from None

    def answers_in(self, pairs: Sequence[tuple[State, Sequence[Action]]]) -> np.ndarray:
        """Many states at a time, of which what they differ in is handed over. Where that goes wrong they are asked one
        by one, to tell which state it is."""
        rows = []
        for some in _parts(pairs):
            try:
                rows.append(self._words.rows(*self.domain.loaded.answers_in(self.name, some)))
            except NppgError:
                rows.append(super().answers_in(some))
        return np.concatenate(rows) if rows else super().answers_in(pairs)

    def located(
        self, error: NppgError, tests: Iterable[Query], pairs: Sequence[tuple[State, Sequence[Action]]]
    ) -> NppgError:
        """What tests have raised about actions in states, with the place of the bound that is to blame."""

        def fails(test: Query) -> bool:
            alone = TestTable(self.domain, self.bias)
            alone.add([test])
            try:
                for state, actions in pairs:
                    alone._asked(state, actions)
            except NppgError:
                return True
            return False

        return located(error, self.bias, tests, fails)

    def _asked(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        if isinstance(actions, LegalActions) and actions.state is state:
            self.domain.visit(state)
            kinds, words = ask("answers_legal", self.name, actions.serial)
        else:
            if not isinstance(actions, list):
                actions = list(actions)  # before the visit: legal actions of another state may have to be found there
            self.domain.visit(state)
            kinds, words = self.domain.loaded.answers_about(self.name, actions)
        return self._words.rows(kinds, words)
