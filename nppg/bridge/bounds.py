"""Bounds on Prolog text before Prolog reads it: terms that are too deep end the process, long numbers never end."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from nppg.errors import NppgError, Problem

BYTES = 4 * 2**20  # of a domain file
DATA = 512 * 2**20  # of a file of problems, or of a model
DEPTH = 1000  # brackets in each other
OPERATORS = 5000  # in each other, of a term
DIGITS = 1000
CHARACTERS = 100_000  # of a name or a text
ARGUMENTS = 10_000  # of a term
ELEMENTS = 2_000_000  # of a list

# Short clauses, in which nothing can be out of bounds, without what brackets or an end may hide in.
_SHORT = re.compile(
    r"""(?:(?:(?:[^%'"`/\\\r]|(?<!\w)'[^'\\\r\n]{0,1000}'){1,900}?(?<=[A-Za-z0-9_)\]]\.)|%[^\r\n]*)?\r?\n)+"""
)

# A clause of nothing but names, numbers, commas and brackets, as problems are.
_PLAIN = re.compile(r"(?:[\w\s,()\[\]]|(?<=\d)\.(?=\d)){1,100000}\.(?=\s|$)")
_LONG = re.compile(rf"\w{{{DIGITS + 1}}}|\w\s+\w")  # digits may stand in groups

_TOKEN = re.compile(
    r"""(?P<blank>\s+|%[^\n]*)
    |(?P<comment>/\*(?:[^*]+|\*(?!/))*(?:\*/)?)
    |(?P<character>0'(?:\\.|''|[^\\]))
    |(?P<number>\d\w*(?:\s+\d\w*)*(?P<radix>'\w+)?)
    |(?P<word>\w+)
    |(?P<quoted>'(?:[^'\\]+|\\.|'')*'?|"(?:[^"\\]+|\\.|"")*"?|`(?:[^`\\]+|\\.|``)*`?)
    |(?P<symbol>(?:[-+*/\\^<>=~:.?@\#&$]|(?![\w\s])[^\x00-\x7f])+)
    |(?P<open>[(\[{])
    |(?P<close>[)\]}])
    |(?P<comma>[,|])
    |(?P<other>.)""",
    re.VERBOSE | re.DOTALL,
)
_OPERANDS = frozenset({"character", "number", "word", "quoted"})
_SYMBOL = r"\-+*/\\^<>=~:.?@#&$"
_POINT = re.compile(rf"\.(?=[^\s%{_SYMBOL}])")  # that does not end a clause
_FRACTION = re.compile(r"(?:[^\w.]|^)\d+\.\d")
_BRACE = re.compile(r"[\w'\"]\{")


def _has_dictionaries(text: str) -> bool:
    """Whether it may have: there is a point that stands in no number, or a brace that touches a name."""
    points = (point.start() for point in _POINT.finditer(text))
    return any(not _FRACTION.search(text, max(0, at - 20), at + 2) for at in points) or (
        "{" in text and _BRACE.search(text) is not None
    )


def bounded(source: bytes, file: str, most: int = BYTES) -> bool:
    """Whether a text of Prolog may have dictionaries in it. Raises NppgError where it is out of bounds."""
    if len(source) > most:
        raise _Beyond(file, 0, f"the file has {len(source):,} bytes, more than {most:,}").error()
    try:
        text = source.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise _Beyond(file, 1, "is no text in UTF-8: a domain starts with :- module(Name, []).").error() from None
    try:
        _scan(text)
    except _Beyond as beyond:
        raise _Beyond(file, text.count("\n", 0, beyond.line) + 1, beyond.message).error() from None
    return _has_dictionaries(text)


def checked(text: str, what: str) -> None:
    """Raises NppgError where a text that is to be read as a term is out of bounds."""
    try:
        _scan(text)
    except _Beyond as beyond:
        raise NppgError(f"{what}: {beyond.message}") from None


def included(path: str, folder: str) -> str:
    """What is wrong with a file that a domain in the folder uses; called by prolog/safety.pl."""
    file = Path(path).resolve()
    if not file.is_relative_to(Path(folder).resolve()) or not file.is_file():
        return f"{path} is no file in the folder of the domain"
    if file.with_suffix(".qlf").exists():
        return f"{file.with_suffix('.qlf')} is compiled and cannot be looked into"
    try:
        bounded(file.read_bytes(), str(file))
    except NppgError as error:
        return str(error)
    except OSError as error:
        return f"{file} cannot be read: {error.strerror}"
    return ""


class _Beyond(Exception):
    """Where a text is out of bounds: a line, or for `_scan` a position."""

    def __init__(self, file: str, line: int, message: str):
        self.file, self.line, self.message = file, line, message

    def error(self) -> NppgError:
        return NppgError([Problem(self.file, self.line, 0, self.message)])


class _Level:
    """A pair of brackets that is open: how many arguments may be in it, where commas part some; how many there were,
    and how many operators in the present one."""

    __slots__ = ("found", "most", "operators")

    def __init__(self, most: int = 0):
        self.most, self.found, self.operators = most, 0, 0


def _scan(text: str) -> None:
    """Raises _Beyond."""
    start, whole = 0, len(text)
    while start < whole:
        if (plain := _PLAIN.match(text, start)) and _is_small(plain.group()):
            start = plain.end()
        elif short := _SHORT.match(text, start):
            start = short.end()
        else:
            start = _clause_end(text, start)


def _is_small(plain: str) -> bool:
    """Whether nothing in a plain clause can be out of bounds."""
    if plain.count(",") >= ARGUMENTS or _LONG.search(plain):
        return False
    letters = np.frombuffer(plain.encode("ascii", "replace"), np.uint8)
    opened = ((letters == ord("(")) | (letters == ord("["))).astype(np.int32)
    closed = ((letters == ord(")")) | (letters == ord("]"))).astype(np.int32)
    return int((opened - closed).cumsum().max()) <= DEPTH


def _clause_end(text: str, start: int) -> int:
    """Where the clause ends that starts there. Raises _Beyond."""
    levels = [_Level()]
    beneath = 0  # operators in the levels below the uppermost
    before, end = "", 0  # the kind of the last token that is none of blanks, and where it ended
    for match in _TOKEN.finditer(text, start):
        kind = match.lastgroup
        if kind == "radix":
            kind = "number"
        if kind in ("blank", "comment"):
            continue
        level, start = levels[-1], match.start()
        if kind == "symbol":
            token = match.group()
            if token == "." and text[match.end() : match.end() + 1] in ("", " ", "\n", "\t", "\r", "%"):
                return match.end()
            if "/*" in token:
                raise _Beyond("", start, "a comment has to stand behind a blank")
            level.operators += 1
        elif kind == "open":
            bracket = match.group()
            levels.append(_Level(ELEMENTS if bracket == "[" else ARGUMENTS if bracket == "(" and end == start else 0))
            beneath += level.operators
            if len(levels) > DEPTH:
                raise _Beyond("", start, f"more than {DEPTH:,} brackets stand in each other")
            if match.group() == "{" and text[start + 1 : start + 2] == "|":
                raise _Beyond("", start, "quasi quotations are not read")
        elif kind == "close":
            if len(levels) > 1:
                levels.pop()
                beneath -= levels[-1].operators
        elif kind == "comma":
            if level.most:
                level.found += 1
                level.operators = 0
                if level.found >= level.most:
                    raise _Beyond("", start, f"more than {level.most:,} arguments or elements stand beside each other")
            else:
                level.operators += 1
        elif kind in _OPERANDS:
            if match.end() - start > (DIGITS if kind == "number" else CHARACTERS):
                long = f"a name has more than {CHARACTERS:,} characters"
                raise _Beyond("", start, f"a number has more than {DIGITS:,} digits" if kind == "number" else long)
            if before in _OPERANDS or before == "close":
                level.operators += 1
        else:
            level.operators += 1  # ! and ; and what is none
        if beneath + levels[-1].operators > OPERATORS:
            raise _Beyond("", start, f"a term has more than {OPERATORS:,} operators in each other")
        before, end = kind or "", match.end()
    return len(text)
