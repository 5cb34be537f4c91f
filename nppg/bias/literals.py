"""The text of one literal in a language bias: `name(argument, ...)`, or a bound such as `+weight =< #`."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from typing import NamedTuple, TypeVar

from nppg.bias.declarations import Argument
from nppg.bias.names import is_name, written
from nppg.logic.query import OPEN, Constant, Real

Item = TypeVar("Item")
Parsed = tuple[str, list[tuple[Argument, int]]]  # its name and its arguments, each with its offset


class Mistake(Exception):
    """A mistake at an offset in a literal's text."""

    def __init__(self, offset: int, message: str):
        super().__init__(message)
        self.offset = offset


class _Token(NamedTuple):
    kind: str
    text: str
    offset: int


_TOKEN = re.compile(
    r"""(?P<space> \s+)
      | (?P<number> -?[0-9]+ (?:\.[0-9]+)? (?:[eE][+-]?[0-9]+)? (?!\w))
      | (?P<quoted> '(?: [^'\\] | '' | \\[\\'] )*')
      | (?P<name> \w+)
      | (?P<sign> \+-? | -)
      | (?P<bound> =< | >=)
      | (?P<mark> [()\[\],\#])""",
    re.VERBOSE,
)
_HINTS = {
    "=": ": equality is written equal(+type, +type)",
    "<": ": a threshold is written +type =< # or +type >= #",
    ">": ": a threshold is written +type =< # or +type >= #",
    "'": ": the quoted atom does not end",
    '"': ": an atom is quoted by '",
}


class _Parser:
    def __init__(self, text: str):
        self.tokens = list(self.scan(text))

    @staticmethod
    def scan(text: str) -> Iterator[_Token]:
        offset = 0
        while offset < len(text):
            match = _TOKEN.match(text, offset)
            if not match:
                raise Mistake(offset, f"{text[offset]!r} has no place in a literal{_HINTS.get(text[offset], '')}")
            if match.lastgroup != "space":
                yield _Token(str(match.lastgroup), match[0], offset)
            offset = match.end()
        yield _Token("end", "", len(text))

    @property
    def next(self) -> _Token:
        return self.tokens[0]

    def literal(self) -> Parsed:
        if self.next.kind == "sign":
            return self.bound()
        at, name = self.next.offset, self.constant("a name")
        if not isinstance(name, str):
            raise Mistake(at, f"a name is wanted, not the number {name}")
        args = self.sequence(")", self.argument) if self.next.text == "(" else []
        if self.next.kind != "end":
            raise self.unexpected("the end of the literal")
        return name, args

    def bound(self) -> Parsed:
        term = self.argument()
        if self.next.kind != "bound":
            raise self.unexpected("=< or >=, as in +weight =< #,")
        name = self.tokens.pop(0).text
        if self.next.text != "#":
            hint = ": YAML ends a text at ' #', unless it is in quotes" if self.next.kind == "end" else ""
            raise Mistake(self.next.offset, f"# is wanted, a threshold that is found from the examples{hint}")
        at = self.tokens.pop(0).offset
        if self.next.kind != "end":
            raise self.unexpected("the end of the literal")
        return name, [term, (Argument("#", "", (OPEN[name],)), at)]

    def sequence(self, end: str, item: Callable[[], Item]) -> list[Item]:
        self.tokens.pop(0)
        items: list[Item] = []
        while self.next.text != end or items:
            items.append(item())
            if self.next.text == end:
                break
            if self.next.text != ",":
                raise self.unexpected(f"',' or '{end}'")
            self.tokens.pop(0)
        self.tokens.pop(0)
        return items

    def argument(self) -> tuple[Argument, int]:
        first = self.next
        if first.kind == "sign":
            self.tokens.pop(0)
            kind, type_ = first.text, ""
            if self.next.kind == "name":
                type_ = self.tokens.pop(0).text
                if not is_name(type_):
                    raise Mistake(first.offset, f"a type is a lower-case name, not {type_!r}")
            return Argument(kind, type_), first.offset
        if first.text != "[":
            return Argument("#", "", (self.constant("an argument"),)), first.offset
        constants = tuple(self.sequence("]", lambda: self.constant("a constant")))
        if not constants:
            raise Mistake(first.offset, "the set of constants is empty")
        if len(set(map(written, constants))) < len(constants):
            raise Mistake(first.offset, "the set of constants holds one of them twice")
        return Argument("#", "", constants), first.offset

    def constant(self, wanted: str) -> Constant:
        token = self.next
        if token.text == "#":
            hint = "write a set of constants as [a, b], without #"
            raise Mistake(token.offset, f"'#' has no place in a literal: {hint}")
        if token.kind not in ("number", "quoted", "name"):
            raise self.unexpected(wanted)
        self.tokens.pop(0)
        if wanted != "a name" and self.next.text == "(":
            raise Mistake(token.offset, f"nested terms are not possible: {token.text}(...) can be no argument")
        if token.kind == "quoted":
            return re.sub(r"''|\\(.)", lambda match: match[1] or "'", token.text[1:-1])
        if token.kind == "number":
            return self.number(token)
        if not is_name(token.text):
            raise Mistake(
                token.offset,
                f"{token.text!r} is no lower-case name: write a variable as + or - and its type (+block), "
                f"an atom in quotes ('{token.text}')",
            )
        return token.text

    @staticmethod
    def number(token: _Token) -> int | float:
        try:
            value = float(token.text)
            if math.isinf(value):
                raise ValueError
            return int(token.text) if re.fullmatch(r"-?[0-9]+", token.text) else Real(value)
        except ValueError:
            raise Mistake(token.offset, "the number is too large") from None

    def unexpected(self, wanted: str) -> Mistake:
        if self.next.kind != "end":
            return Mistake(self.next.offset, f"{wanted} is wanted, not {self.next.text!r}")
        hint = ": YAML ends a text at ' #', unless it is in quotes"
        return Mistake(self.next.offset, f"{wanted} is wanted, but the literal ends here{hint}")


def parsed(text: str) -> Parsed:
    """A literal; a left-out type is the empty text. Raises Mistake."""
    return _Parser(text).literal()
