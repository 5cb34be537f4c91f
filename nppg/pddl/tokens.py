"""The text of a PDDL file as nested groups of words, each with its place, and what is reported about them."""

from __future__ import annotations

import re
from bisect import bisect
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path

from nppg.errors import NppgError, Problem, suggestion

LARGEST = 50_000_000  # bytes of a file
DEEPEST = 100  # groups within each other, so that recursion over them is safe
LONGEST = 1_000  # characters of a word
EFFORT = 20_000  # names that are compared with wrong ones, in all
SECTIONS = (":action", ":derived", ":predicates", ":functions", ":constants", ":types", ":objects", ":init", ":goal")

_TOKEN = re.compile(r";[^\n]*|[()]|[^\s();]+")


@dataclass(slots=True)
class Word:
    """A symbol in lower case, and its offset in the source."""

    at: int
    text: str


@dataclass(slots=True)
class Group:
    """What stands between parentheses, and the offset of the opening one."""

    at: int
    items: list[Node]


Node = Word | Group


class Document:
    """The text of one file, with the problems that were found in it, so that all are reported at once."""

    def __init__(self, file: str, source: str):
        self.file = file
        self.source = source
        self.problems: set[Problem] = set()
        self._effort = EFFORT
        self._told: set[str] = set()
        self._lines: list[int] = []

    def place(self, at: int) -> tuple[int, int]:
        """Line and column, from 1, of an offset."""
        if not self._lines:
            self._lines = [0, *(match.end() for match in re.finditer("\n", self.source))]
        line = bisect(self._lines, at)
        return line, at - self._lines[line - 1] + 1

    def report(self, node: Node, message: str) -> None:
        """Notes a problem at a node."""
        self.problems.add(Problem(self.file, *self.place(node.at), message))

    def report_unknown(self, node: Node, what: str, word: str, known: Collection[str]) -> None:
        """Notes an unknown name at the first of its places, with a near one."""
        if (message := f"unknown {what} '{word}'") not in self._told:
            self._told.add(message)
            self.report(node, message + self.hint(word, known))

    def hint(self, word: str, known: Collection[str]) -> str:
        """A near name as `suggestion` has it, as long as that takes no long time."""
        self._effort -= len(known)
        return suggestion(word, known) if self._effort >= 0 else ""

    def fail(self, at: int, message: str) -> NppgError:
        """The error to raise where reading cannot go on."""
        return NppgError([Problem(self.file, *self.place(at), message)])

    def finish(self) -> None:
        """Raises NppgError with all problems, if there are some."""
        if self.problems:
            raise NppgError(sorted(self.problems))

    def groups(self) -> list[Group]:
        """The groups that the file consists of."""
        top: list[Node] = []
        items = top
        stack: list[Group] = []
        section = closed = -1
        for match in _TOKEN.finditer(self.source):
            token = match.group()
            first = token[0]
            if first == "(":
                group = Group(match.start(), [])
                items.append(group)
                stack.append(group)
                items = group.items
                if len(stack) > DEEPEST:
                    raise self.fail(match.start(), f"nested too deeply: more than {DEEPEST} parentheses are open")
            elif first == ")":
                if not stack:
                    raise self.fail(match.start(), "this parenthesis closes nothing: there is one too many")
                stack.pop()
                items = stack[-1].items if stack else top
                closed = closed if stack else match.start()
            elif first != ";":
                word = Word(match.start(), token.lower())
                if not token.isprintable() or len(token) > LONGEST:
                    raise self._no_word(word)
                if not stack:
                    raise self._outside(word, closed)
                if not items:
                    if len(stack) == 1 and closed >= 0 and word.text != "define":
                        raise self.fail(closed, "this parenthesis closes the file's first one, but more follows")
                    if section < 0 and len(stack) > 2 and word.text in SECTIONS:
                        section = stack[-2].at
                items.append(word)
        if stack:
            raise self.fail(stack[-1].at if section < 0 else section, "this parenthesis is never closed")
        return [each for each in top if isinstance(each, Group)]

    def _outside(self, word: Word, closed: int) -> NppgError:
        """The error that a word in no parentheses is."""
        text = repr(word.text[:30])
        if closed < 0:
            return self.fail(word.at, f"not PDDL: a file begins with '(define', not with {text}")
        return self.fail(word.at, f"{text} stands outside of all parentheses")

    def _no_word(self, word: Word) -> NppgError:
        """The error that a word is which no file has."""
        if len(word.text) > LONGEST:
            return self.fail(word.at, f"a word of {len(word.text)} characters, more than {LONGEST}")
        offset, character = next(each for each in enumerate(word.text) if not each[1].isprintable())
        return self.fail(word.at + offset, f"the character {character!r} has no place in PDDL")


def opened(path: str | Path) -> Document:
    """The document of a file. Raises NppgError where it cannot be read as text."""
    file = str(path)
    try:
        if Path(path).is_dir():
            raise NppgError([Problem(file, 0, 0, "is a directory, not a PDDL file")])
        data = b""
        size = Path(path).stat().st_size
        if size <= LARGEST:
            with open(path, "rb") as stream:
                data = stream.read(LARGEST + 1)
        if max(size, len(data)) > LARGEST:
            raise NppgError([Problem(file, 0, 0, f"is larger than {LARGEST // 10**6} MB")])
    except FileNotFoundError:
        raise NppgError([Problem(file, 0, 0, "no such file")]) from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise NppgError([Problem(file, 0, 0, f"cannot be read: {reason}")]) from None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        before = data[: error.start]
        line, column = before.count(b"\n") + 1, error.start - before.rfind(b"\n")
        message = f"not UTF-8: the byte 0x{data[error.start]:02x} has no meaning here"
        raise NppgError([Problem(file, line, column, message)]) from None
    return Document(file, text.replace("\r\n", "\n").replace("\r", "\n"))


def head(node: Node) -> str:
    """The word that a group begins with; the empty string where it is none."""
    if isinstance(node, Group) and node.items and isinstance(node.items[0], Word):
        return node.items[0].text
    return ""


def described(node: Node) -> str:
    """What a node is, in a user's words."""
    if isinstance(node, Word):
        return repr(node.text)
    return f"'({head(node)} ...)'" if head(node) else "a list" if node.items else "'()'"
