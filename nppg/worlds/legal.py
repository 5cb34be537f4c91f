"""Many legal actions, which stay in Prolog until somebody looks at them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import overload

from nppg.bridge.prolog import ask, exclusively
from nppg.bridge.terms import compounds
from nppg.worlds.loaded import Loaded
from nppg.worlds.world import Action, State


@exclusively("all", "__getitem__", "__len__")
class LegalActions(Sequence[Action]):
    """The legal actions of a state in a loaded domain file. `serial`: under which Prolog may still keep them, the state
    being current. `count`: how many there are, -1 where that is not known."""

    def __init__(self, loaded: Loaded, state: State, count: int, serial: int):
        self.state = state
        self.serial = serial
        self._loaded = loaded
        self._count = count
        self._all: list[Action] | None = None
        self._known: dict[int, Action] = {}

    @property
    def all(self) -> list[Action]:
        """As a list."""
        if self._all is None:
            self._loaded.visit(self.state)
            self._all = compounds(ask("all_legal", self._loaded.module, self.serial))
            for number, action in self._known.items():
                self._all[number] = action
        return self._all

    def __len__(self) -> int:
        return len(self.all) if self._count < 0 else self._count

    @overload
    def __getitem__(self, index: int) -> Action: ...
    @overload
    def __getitem__(self, index: slice) -> list[Action]: ...
    def __getitem__(self, index: int | slice) -> Action | list[Action]:
        if self._all is not None or isinstance(index, slice) or not 0 <= index < len(self):
            return self.all[index]
        if index not in self._known:
            self._loaded.visit(self.state)
            data = ask("nth_legal", self._loaded.module, self.serial, int(index))
            (self._known[index],) = compounds([data])
        return self._known[index]

    def __iter__(self) -> Iterator[Action]:
        return iter(self.all)  # one by one each would be a question

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, list | LegalActions) and self.all == list(other))

    __hash__ = None  # type: ignore[assignment]  # as a list

    def __repr__(self) -> str:
        return repr(self.all)

    def __reduce__(self) -> tuple:
        return list, (self.all,)
