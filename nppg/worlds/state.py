"""A state: what holds, in two parts.

The facts of the fluents are its own; the static ones are those of its problem, which all states of the problem share.
A state that an action has led to knows its facts only as what has changed, until somebody asks for them.
"""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import overload
from weakref import WeakKeyDictionary, WeakValueDictionary

from nppg.bridge.terms import Ground, plain, texts
from nppg.errors import NppgError
from nppg.logic.query import exact

_LONGEST = 500  # changes in a row, after which a state knows its facts
_MASK = 2**64 - 1


class Static:
    """The static facts of a problem, in Prolog's standard order; equal where the facts are. `numbers`: under which they
    are known to the loaded domain files."""

    __slots__ = ("__weakref__", "_facts", "_read", "numbers")

    def __init__(self, facts: Iterable[Ground] | Callable[[], tuple[Ground, ...]] = ()):
        read = facts if callable(facts) else None
        self._facts: tuple[Ground, ...] | None = None if callable(facts) else tuple(facts)
        self._read = read
        self.numbers: WeakKeyDictionary[object, int] = WeakKeyDictionary()

    @property
    def facts(self) -> tuple[Ground, ...]:
        """Asked of Prolog, where they come from there, when they are first needed."""
        if self._facts is None:
            assert self._read
            self._facts = self._read()
            self._read = None
        return self._facts

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Static) and self.facts == other.facts)

    def __hash__(self) -> int:
        return hash(self.facts)

    def __reduce__(self) -> tuple:
        return static_again, (self.facts,)


NOTHING = Static()


def static_facts(facts: Iterable[Ground]) -> Static:
    """Those of a problem, NOTHING where there are none."""
    own = tuple(facts)
    return Static(own) if own else NOTHING


_read_again: WeakValueDictionary[object, Static] = WeakValueDictionary()


def static_again(facts: tuple[Ground, ...]) -> Static:
    """Those that have been copied or pickled: the same object each time, which the domain files know already."""
    return _read_again.setdefault(exact(facts), static_facts(facts)) if facts else NOTHING


class Interpretation(Sequence[Ground]):
    """The facts of the fluents that hold in a state, a sequence in Prolog's standard order, equal to the tuple of them;
    `static` are the other facts. `str` writes all of them as Domain.state reads them."""

    __slots__ = ("_before", "_changes", "_facts", "_fingerprint", "static")

    def __init__(self, facts: Iterable[Ground] = (), static: Static = NOTHING):
        self._facts: tuple[Ground, ...] | None = tuple(facts)
        self._before: Interpretation | None = None
        self._changes: tuple[Sequence[Ground], Sequence[Ground]] = ((), ())
        self._fingerprint: int | None = None
        self.static = static

    def changed(self, gone: Sequence[Ground], new: Sequence[Ground]) -> Interpretation:
        """The state in which the facts `gone`, of this one, do not hold, and the facts `new` do."""
        state = Interpretation((), self.static)
        state._facts, state._before, state._changes = None, self, (gone, new)
        return state

    def difference(self, other: Interpretation) -> tuple[Sequence[Ground], Sequence[Ground]] | None:
        """What is gone in the other state and what is new there, if one is known to be the other with a change."""
        if other._before is self:
            return other._changes
        return self._changes[::-1] if self._before is other else None

    @property
    def facts(self) -> tuple[Ground, ...]:
        """As a tuple."""
        if self._facts is None:
            line = [self]
            while line[-1]._facts is None:
                before = line[-1]._before
                assert before is not None
                line.append(before)
            found = list(line.pop()._facts or ())
            for state in reversed(line):
                gone, new = state._changes
                for fact in gone:
                    del found[bisect_left(found, standard_order(fact), key=standard_order)]
                for fact in new:
                    insort(found, fact, key=standard_order)
            self._facts = tuple(found)
            if len(line) > _LONGEST:
                self._before = None
        return self._facts

    @property
    def fingerprint(self) -> int:
        """Of 64 bits, the same for equal states of a problem, and hardly ever for others; of what has changed alone."""
        if self._fingerprint is None:
            if self._before is not None and self._before._fingerprint is not None:
                found = self._before._fingerprint
                for fact in (*self._changes[0], *self._changes[1]):
                    found ^= _mixed(fact)
            else:
                found = 0
                for fact in self.facts:
                    found ^= _mixed(fact)
            self._fingerprint = found
        return self._fingerprint

    @overload
    def __getitem__(self, index: int) -> Ground: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Ground, ...]: ...
    def __getitem__(self, index: int | slice) -> Ground | tuple[Ground, ...]:
        return self.facts[index]

    def __len__(self) -> int:
        return len(self.facts)

    def __iter__(self) -> Iterator[Ground]:
        return iter(self.facts)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Interpretation):
            return self is other or (self.facts == other.facts and self.static == other.static)
        return self.facts == other

    def __hash__(self) -> int:
        return hash(self.facts)

    def __reduce__(self) -> tuple:
        return Interpretation, (self.facts, self.static)

    def __repr__(self) -> str:
        return repr(self.facts)

    def __str__(self) -> str:
        return ", ".join(texts((*self.static.facts, *self.facts)))


class FactNumbers:
    """Facts that states have in common, numbered from 1."""

    def __init__(self) -> None:
        self.facts: list[Ground] = []
        self._numbers: dict[object, int] = {}

    def of(self, state: Interpretation) -> list[int]:
        """The numbers of a state's facts, in order."""
        facts = state.facts
        keys: Sequence[object] = facts
        if {*map(type, chain.from_iterable(facts))} != {str}:  # type: ignore[arg-type]
            keys = [*map(exact, facts)]  # to Python 1 is equal to 1.0
        try:
            return [*map(self._numbers.__getitem__, keys)]
        except KeyError:
            pass
        for key, fact in zip(keys, facts, strict=True):
            if key not in self._numbers:
                self.facts.append(fact)
                self._numbers[key] = len(self.facts)
        return [*map(self._numbers.__getitem__, keys)]


def _mixed(fact: Ground) -> int:
    return hash(repr(fact)) & _MASK  # Python's hash of -1 is that of -2


def facts_of(state: Sequence[Ground]) -> list[Ground]:
    """A state's facts, with Python's numbers where somebody has made it with NumPy's. Raises NppgError."""
    return list(state.facts) if type(state) is Interpretation else plain(_iterable(state))


def interpretation_of(state: Sequence[Ground]) -> Interpretation:
    """A state as an Interpretation. Raises NppgError."""
    if type(state) is Interpretation:
        return state
    return Interpretation(sorted(set(plain(_iterable(state))), key=standard_order))


def _iterable(state: Sequence[Ground]) -> Iterable[Ground]:
    if isinstance(state, Iterable) and not isinstance(state, str | bytes | Mapping):
        return state
    raise NppgError(f"{state!r} is no state: that is a sequence of facts; Domain.state makes one of a text")


def static_of(state: Sequence[Ground]) -> Static:
    """The static facts that go with a state; none where somebody has made it of facts."""
    return state.static if type(state) is Interpretation else NOTHING


def standard_order(term: Ground) -> tuple:
    """A key that sorts ground terms as Prolog does: numbers by value, a float before an equal whole number; names by
    their characters; compounds by their number of arguments, name, arguments."""
    if isinstance(term, tuple):
        if len(term) == 1 and term[0] == "[]":
            return 1, "[]"
        return 2, len(term), term[0], *map(standard_order, term[1:])
    if isinstance(term, str):
        return 1, term
    return 0, term, not isinstance(term, float)
