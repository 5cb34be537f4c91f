"""Which words of tests a table asks about which arguments of an action, and where each test's answer stands.

Tests that ask the same, `clear(X)` and `clear(Y)` of `move(X, Y)`, are one *question*, of the arguments that they are
about. Questions that are asked of the same places, here the first and the second argument, share words: each word is
asked once in a state for every choice of arguments. See prolog/table.pl. Tests whose answers are the same in every
state of a problem have words of their own, with keys below 0, as these are asked once; see prolog/known_answers.pl.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, is_open
from nppg.bridge.terms import encoded
from nppg.logic.query import Literal, Query, Var, substitute, variables

WORD = 60  # tests in one integer: it stays a small one in Prolog
BITS = 64  # of an integer in NumPy
_NEVER, _ALWAYS = -1, -2  # in place of a bit: a column that does not hold, or does, whatever the arguments are

Place = tuple[int, tuple[int, ...]]  # a kind of action, and the positions of arguments, from 0
Word = tuple["Question", ...]


class Question(NamedTuple):
    """What a test asks of so many arguments: its first variables are these, those of the goal come next."""

    arity: int
    query: Query

    @property
    def is_bound(self) -> bool:
        """Whether its answer is a number, which takes a word of its own."""
        return any(map(is_open, self.query))


Group = tuple[tuple[Place, ...], bool]  # what questions share that share words: the places, and whether they are static
Asked = tuple[Question, tuple[int, ...]]  # of arguments of an action, by their positions


class Words:
    """The words of a table, by the places that they are asked of."""

    def __init__(self, bias: LanguageBias, is_static: Callable[[Query], bool]):
        """`is_static`: whether a test has the same answer in every state of a problem."""
        self.kinds = [_Kind() for _ in bias.actions]
        self._bias = bias
        self._is_static = is_static
        self._places: dict[Question, list[Place]] = {}
        self._questions: dict[Group, list[Question]] = {}
        self._words: dict[Group, list[Word]] = {}  # the same, of new ones not yet
        self._keys: dict[Word, int] = {}
        self._last = 0
        self._numeric = False
        self._sizes = np.zeros(len(self.kinds), int)  # the words of an action of each kind
        self._bits = np.empty((len(self.kinds), 0), int)  # of each kind and column: see _Kind

    def add(self, tests: Iterable[tuple[int, Query]], bounds: Sequence[int] | None, size: int) -> tuple[list, ...]:
        """Takes in new tests, each with its column, and tells what Prolog has to know: the keys of words that are asked
        no more, new words, and the words of every kind. There are `size` columns now, among them those of tests with
        `bounds`, which is None where answers are truth values."""
        for column, test in tests:
            for number, kind in enumerate(self.kinds):
                if test[0].name == KIND:
                    kind.always += [column] if test[0].args[0] == number else []
                elif found := self._question(test, number):
                    question, positions = found
                    kind.columns[column] = found
                    self._ask(question, (number, positions))
        for group, questions in self._questions.items():
            if group not in self._words:
                self._words[group] = list(_words(questions))
        old, self._keys = self._keys, {}
        for (_, static), own in self._words.items():
            for word in own:
                if word not in old:
                    self._last += 1
                self._keys[word] = old.get(word) or (-self._last if static else self._last)
        new = [[key, word[0].arity, _data(word)] for word, key in self._keys.items() if word not in old]
        asked: list[list] = [[] for _ in self.kinds]
        for number, kind in enumerate(self.kinds):
            stands: dict[Asked, tuple[int, int]] = {}
            for (places, _), own in self._words.items():
                for positions in (positions for each, positions in places if each == number):
                    alone = len(places) == 1 and len(positions) == len(self._bias.actions[number].types) > 0
                    for word in own:
                        stands |= {(question, positions): (len(asked[number]), i) for i, question in enumerate(word)}
                        asked[number].append([self._keys[word], [i + 1 for i in positions], str(alone).lower()])
            kind.update(stands, len(asked[number]), size, bounds)
        self._sizes = np.array([kind.words for kind in self.kinds])
        self._bits = np.stack([kind.bits for kind in self.kinds])
        self._numeric = bounds is not None
        return [key for word, key in old.items() if word not in self._keys], new, asked

    def rows(self, kinds: list[int], words: list) -> np.ndarray:
        """The answers to all columns about actions of these kinds, whose words stand one behind the other."""
        if not self._numeric and len(set(kinds)) == 1:
            return self.kinds[kinds[0]].truths(words, len(kinds))
        which = np.array(kinds, int)
        sizes = self._sizes[which]
        starts = sizes.cumsum() - sizes
        if self._numeric:
            result = np.empty((len(kinds), self._bits.shape[1]))
            for kind in np.flatnonzero(np.bincount(which)):
                members = np.flatnonzero(which == kind)
                result[members] = self.kinds[kind].numbers(words, starts[members].tolist())
            return result
        found = unpacked(np.array([*words, 0], "<i8")[None])[0]
        bits = self._bits[which]
        result = found.take(bits + BITS * starts[:, None])
        result[bits == _NEVER] = False
        result[bits == _ALWAYS] = True
        return result

    def _ask(self, question: Question, place: Place) -> None:
        """Asks a question of one more place."""
        old, static = self._places.get(question, []), self._is_static(question.query)
        if place not in old:
            if old:
                self._questions[tuple(old), static].remove(question)
                self._words.pop((tuple(old), static), None)
            self._places[question] = new = sorted([*old, place])
            self._questions.setdefault((tuple(new), static), []).append(question)
            self._words.pop((tuple(new), static), None)

    def _question(self, test: Query, kind: int) -> Asked | None:
        """What a test asks, and of which arguments of an action of this kind; None if it is about another kind's, so
        that it never holds."""
        first, end = self._bias.offsets[kind : kind + 2]
        goal, roots = self._bias.offsets[-1], len(self._bias.roots)
        used = variables(test)
        arguments = [var for var in used if var.index < goal]
        if not all(first <= var.index < end for var in arguments):
            return None
        numbers = {var: i for i, var in enumerate(arguments)}
        numbers |= {Var(index): len(arguments) + index - goal for index in range(goal, roots)}
        existential = [var for var in used if var.index >= roots]
        numbers |= {var: len(arguments) + roots - goal + i for i, var in enumerate(existential)}
        question = Question(len(arguments), substitute(test, {var: Var(i) for var, i in numbers.items()}))
        return question, tuple(var.index - first for var in arguments)


class _Kind:
    """Where the answers about actions of one kind stand."""

    def __init__(self) -> None:
        self.columns: dict[int, Asked] = {}
        self.always: list[int] = []
        self.words = 0
        self.bits: np.ndarray = np.empty(0, np.intp)  # of each column that among the bits of an action's words
        self._never: list[int] = []
        self._values: list[tuple[int, int]] = []  # words of one number, with their column
        self._limitless: np.ndarray = np.empty(0)  # answers where nothing holds, if they are numbers

    def update(
        self, stands: dict[Asked, tuple[int, int]], words: int, size: int, bounds: Sequence[int] | None
    ) -> None:
        """`stands` has the word and the bit of what is asked."""
        self.words = words
        self.bits = np.full(size, _NEVER)
        self.bits[self.always] = _ALWAYS
        self._values = []
        for column, asked in self.columns.items():
            word, bit = stands[asked]
            if asked[0].is_bound:
                self._values.append((word, column))
            else:
                self.bits[column] = word * BITS + bit
        self._never = np.flatnonzero(self.bits == _NEVER).tolist()
        if bounds is not None:
            self._limitless = np.ones(size)
            self._limitless[list(bounds)] = np.inf

    def truths(self, words: list, count: int) -> np.ndarray:
        """The answers to all columns about so many actions, which have all of these words."""
        found = unpacked(np.array(words, "<i8").reshape(count, -1)) if words else np.zeros((count, BITS), bool)
        result = found.take(self.bits, axis=1)
        if self._never:
            result[:, self._never] = False
        if self.always:
            result[:, self.always] = True
        return result

    def numbers(self, words: list, starts: Sequence[int]) -> np.ndarray:
        """The same as numbers, about actions whose words start there."""
        values = {word for word, _ in self._values}
        truths = [0 if i in values else words[start + i] for start in starts for i in range(self.words)]
        numbers = np.where(self.truths(truths, len(starts)), 0.0, self._limitless)
        for word, column in self._values:
            numbers[:, column] = [words[start + word] for start in starts]
        return numbers


def _words(questions: Sequence[Question]) -> Iterator[Word]:
    truths = [question for question in questions if not question.is_bound]
    yield from (tuple(truths[i : i + WORD]) for i in range(0, len(truths), WORD))
    yield from ((question,) for question in questions if question.is_bound)


def _data(word: Word) -> list:
    return measure(word[0].query) if word[0].is_bound else [encoded(question.query) for question in word]


def measure(test: Query) -> list:
    """What decides a test with a bound, as prolog/test_clauses.pl reads it: the bound first."""
    bound = next(filter(is_open, test))
    return ["measure", encoded((Literal(bound.name, (bound.args[0], 0)), *(each for each in test if each != bound)))]


def unpacked(words: np.ndarray) -> np.ndarray:
    """Unpacks the words of each row, in order, to booleans of shape (rows, 64 * words per row)."""
    return np.unpackbits(words.view(np.uint8), axis=1, bitorder="little").view(bool)
