"""The language bias: which literals a tree may test, with which types, and when a tree stops growing.

A bias is a YAML file in the terms of ACE (`type`, `rmode`, `lookahead`); docs/language_bias.md is its reference.
"""

from __future__ import annotations

import hashlib
from collections.abc import Collection
from dataclasses import dataclass, field
from functools import cached_property
from itertools import accumulate
from pathlib import Path

from nppg.bias.declarations import Declared, Mode, Template, upwards
from nppg.bias.reader import read
from nppg.errors import NppgError, Problem, suggestion
from nppg.logic.forms import Forms
from nppg.logic.query import OPEN

RESERVED = ("delta", 3)
LARGEST = 200_000  # bytes of a file


@dataclass(frozen=True)
class LanguageBias(Declared):
    """What one bias file declares, and the file."""

    source: bytes = field(default=b"", compare=False, repr=False)  # the file's contents; none for a bias without one

    @property
    def hash(self) -> str:
        """SHA-256 of the file as it was loaded, in hexadecimal."""
        return hashlib.sha256(self.source).hexdigest()

    @cached_property
    def roots(self) -> tuple[str, ...]:
        """The types of the root variables: the arguments of each kind of action, then the goal's."""
        templates = [*self.actions, self.goal] if self.goal else self.actions
        return tuple(type_ for template in templates for type_ in template.types)

    @cached_property
    def offsets(self) -> tuple[int, ...]:
        """The number of the first root variable of each kind of action, and of the goal."""
        return tuple(accumulate((len(action.types) for action in self.actions), initial=0))

    @cached_property
    def forms(self) -> Forms:
        """The normal forms of queries, for all who have to do with the same tests."""
        return Forms(len(self.roots))

    def fits(self, type_: str, wanted: str) -> bool:
        """Whether a variable of `type_` may stand where `wanted` is asked for: the same type, or one below it."""
        return wanted in upwards(self.subtypes, type_)

    @classmethod
    def load(cls, path: str | Path) -> LanguageBias:
        """Reads a bias file. Raises NppgError with all its mistakes, located and in file order."""
        data = _read(path)
        return cls(**vars(read(str(path), _text(path, data))), source=data)

    @classmethod
    def parse(cls, text: str, file: str) -> LanguageBias:
        """Reads the text of a bias file; `file` is what it is called. Raises NppgError like `load`."""
        return cls(**vars(read(file, text)), source=text.encode())

    def check(self, predicates: Collection[tuple[str, int]], actions: Collection[tuple[str, int]]) -> list[Problem]:
        """What the bias names and the domain does not have; `predicates` and `actions` are pairs of name and arity.

        No `actions` means that they cannot be told without running the domain."""
        problems = []

        def look_up(what: str, item: Mode | Template, arity: int, known: Collection[tuple[str, int]]) -> None:
            if (item.name, arity) not in known:
                message = f"the domain has no {what} {item.name}/{arity}{_near(item.name, known)}"
                problems.append(Problem(self.file, item.line, item.column, message))

        for action in self.actions if actions else ():
            look_up("action", action, len(action.types), actions)
        if self.goal:
            look_up("predicate", self.goal, len(self.goal.types), predicates)
        for mode in self.modes:
            if (mode.name, len(mode.args)) == RESERVED:
                message = "delta/3 is what the rules of a model are called; give the predicate another name"
                problems.append(Problem(self.file, mode.line, mode.column, message))
            elif mode.name != "=" and mode.name not in OPEN:
                look_up("predicate", mode, len(mode.args), predicates)
        return sorted(problems)


def _near(name: str, known: Collection[tuple[str, int]]) -> str:
    same = ", ".join(f"{name}/{arity}" for other, arity in sorted(known) if other == name)
    return f" (it has {same})" if same else suggestion(name, (other for other, _ in known))


def _read(path: str | Path) -> bytes:
    try:
        with open(path, "rb") as file:
            data = file.read(LARGEST + 1)
        if len(data) <= LARGEST:
            return data
        reason = f"it has more than {LARGEST:,} bytes"
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
    raise NppgError([Problem(str(path), 0, 0, f"cannot be read: {reason}")])


def _text(path: str | Path, data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        lines = data[: error.start].decode("utf-8-sig").split("\n")
        line, column = len(lines), len(lines[-1]) + 1
        raise NppgError([Problem(str(path), line, column, f"not UTF-8: byte 0x{data[error.start]:02x}")]) from None
