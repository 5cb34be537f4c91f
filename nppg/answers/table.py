"""Tests that are asked of every state-action pair, together.

A `Table` holds the refinements of the empty query and whatever the trees of a policy test. Their answers are kept with
the pair, for the potential and for all trees grown from it later. An answer is a truth value; or, where a language bias
has bounds, all answers are the numbers that decide tests, which hold where the number is at most the test's limit
(`logic.opened`): a bound is asked once for all its thresholds.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Sequence

import numpy as np

from nppg.answers.comparing import located
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, Refinement, is_open
from nppg.bridge.prolog import ask, drop_with
from nppg.bridge.terms import encoded, plain
from nppg.errors import NppgError
from nppg.logic.query import OPEN, Literal, Query, opened, variables
from nppg.worlds.domain import Domain
from nppg.worlds.legal import LegalActions
from nppg.worlds.world import Action, State

WORD = 60  # tests in one integer: it stays a small one in Prolog
BITS = 64  # of an integer in NumPy
_MEMORY = 10_000  # lists of candidates whose columns are remembered


class _Groups:
    """The tests of one kind of action, by the arguments that they are about, and where their answers stand."""

    def __init__(self) -> None:
        self.truths: dict[tuple[int, ...], list[int]] = {}  # columns of tests without a bound
        self.bounds: dict[tuple[int, ...], list[int]] = {}  # and with one; both have all groups
        self.always: list[int] = []
        self.words = 0
        self._places: np.ndarray = np.empty(0, np.intp)  # of each column's bit; that of none is never set
        self._bits: list[int] = []  # words of truth values
        self._values: list[tuple[int, int]] = []  # words of one number, with their column
        self._limitless: np.ndarray | None = None  # answers where nothing holds, if they are numbers

    def add(self, arguments: tuple[int, ...], column: int, bound: bool) -> None:
        truths, bounds = self.truths.setdefault(arguments, []), self.bounds.setdefault(arguments, [])
        (bounds if bound else truths).append(column)

    def update(self, size: int, bounds: Sequence[int] | None) -> None:
        """To be called after columns have been added; there are `size` of them, those of other kinds included, among
        them `bounds`, which is None where answers are truth values."""
        self._places = np.full(size, WORD)
        self._bits, self._values = [], []
        self.words = 0
        for arguments, columns in self.truths.items():
            words = range(self.words, self.words - (-len(columns) // WORD))
            for i, column in enumerate(columns):
                self._places[column] = (len(self._bits) + i // WORD) * BITS + i % WORD
            self._bits += words
            self.words += len(words)
            self._values += enumerate(self.bounds[arguments], self.words)
            self.words += len(self.bounds[arguments])
        if bounds is not None:
            self._limitless = np.ones(size)
            self._limitless[list(bounds)] = np.inf

    def rows(self, words: list, count: int) -> np.ndarray:
        """The answers to all columns; of each word in turn, `words` has that of every one of `count` actions."""
        own = [words[i * count : (i + 1) * count] for i in self._bits] if self._values else words
        bits = unpacked(np.array(own, "<i8").reshape(-1, count).T) if self._bits else np.zeros((count, BITS), bool)
        result = bits.take(self._places, axis=1)
        if self.always:
            result[:, self.always] = True
        if self._limitless is None:
            return result
        numbers = np.where(result, 0.0, self._limitless)
        for word, column in self._values:
            numbers[:, column] = words[word * count : (word + 1) * count]
        return numbers


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


class TestTable(Table):
    """Tests that are compiled into Prolog clauses."""

    __test__ = False  # it is no test case, whatever its name makes pytest think

    def __init__(self, domain: Domain, bias: LanguageBias):
        super().__init__(domain, bias)
        kinds = [[template.name, len(template.types)] for template in bias.actions]
        goal = [bias.goal.name, len(bias.goal.types)] if bias.goal else []
        self.name: str = ask("table", domain.module, kinds, goal)
        drop_with(self, "table_drop", self.name)
        self._groups = [_Groups() for _ in bias.actions]
        self.loaded: Callable[[], object] = lambda: None  # the Coverage whose examples Prolog holds

    def _prepare(self, columns: Sequence[int]) -> None:
        touched = set()
        for column in columns:
            test = self.tests[column]
            for kind, groups in enumerate(self._groups):
                arguments = self._arguments(test, kind)
                if test[0].name == KIND:
                    groups.always += [column] if test[0].args[0] == kind else []
                elif arguments is not None:
                    groups.add(arguments, column, any(map(is_open, test)))
                    touched.add((kind, arguments))
        for kind, arguments in sorted(touched):
            groups = self._groups[kind]
            group = [encoded(self.tests[column]) for column in groups.truths[arguments]]
            words = [group[i : i + WORD] for i in range(0, len(group), WORD)]
            words += [measure(self.tests[column]) for column in groups.bounds[arguments]]
            ask("tests", self.name, kind, [list(groups.truths).index(arguments), [i + 1 for i in arguments]], words)
        for groups in self._groups:
            groups.update(len(self), self.bounds if self.numeric else None)

    def _arguments(self, test: Query, kind: int) -> tuple[int, ...] | None:
        """The action's arguments that the test is about; None if some are another kind's, so that it never holds."""
        own = range(*self.bias.offsets[kind : kind + 2])
        used = sorted({var.index for var in variables(test) if var.index < self.bias.offsets[-1]})
        return tuple(used) if all(index in own for index in used) else None

    def answers(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        try:
            return self._asked(state, actions)
        except NppgError as error:
            bounded = [self.tests[column] for column in self.bounds]
            raise self.located(error, bounded, [(state, actions)]) from None

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
            given = plain(actions)  # before the visit: legal actions of another state may have to be found there
            self.domain.visit(state)
            kinds, words = ask("answers", self.name, given)
        if len(set(kinds)) == 1:
            return self._groups[kinds[0]].rows(words, len(actions))
        result = np.empty((len(actions), len(self)), float if self.numeric else bool)
        start = 0
        for kind in sorted(set(kinds)):
            members = np.flatnonzero(np.array(kinds) == kind)
            end = start + self._groups[kind].words * len(members)
            result[members] = self._groups[kind].rows(words[start:end], len(members))
            start = end
        return result


def measure(test: Query) -> list:
    """What decides a test with a bound, as prolog/test_clauses.pl reads it: the bound first."""
    bound = next(filter(is_open, test))
    return ["measure", encoded((Literal(bound.name, (bound.args[0], 0)), *(each for each in test if each != bound)))]


def unpacked(words: np.ndarray) -> np.ndarray:
    """Unpacks the words of each row, in order, to booleans of shape (rows, 64 * words per row)."""
    array = np.ascontiguousarray(words).view(np.uint8)
    return np.unpackbits(array, axis=1, bitorder="little").view(bool)
