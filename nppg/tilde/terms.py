"""Terms of Prolog as data: names, numbers, and tuples of a name and its arguments; a variable is ("$VAR", number)."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from nppg.bias.names import is_name, written
from nppg.bridge.terms import Ground

Indicator = tuple[str, int]

_LONG = 100  # characters of a term in a message


def indicator(data: Ground) -> Indicator:
    """The name and the arity of a term."""
    return (str(data[0]), len(data) - 1) if isinstance(data, tuple) else (str(data), 0)


def arguments(data: Ground) -> tuple[Ground, ...]:
    return data[1:] if isinstance(data, tuple) else ()


def parts_of(data: Ground) -> Iterator[Ground]:
    """All terms within one, itself among them."""
    unread = [data]
    while unread:
        each = unread.pop()
        yield each
        if not is_variable(each):
            unread += arguments(each)


def within(data: Ground) -> Iterator[Indicator]:
    """The predicates of all terms within one."""
    return map(indicator, parts_of(data))


def is_variable(data: Ground) -> bool:
    return isinstance(data, tuple) and data[0] == "$VAR"


def number(data: Ground) -> int:
    """That of a variable."""
    assert isinstance(data, tuple)
    return int(data[1])


def elements(data: Ground) -> list[Ground] | None:
    """Those of a list, None for what is none."""
    found = []
    while indicator(data) == ("[|]", 2):
        assert isinstance(data, tuple)
        found.append(data[1])
        data = data[2]
    return found if data == ("[]",) else None


def parts(data: Ground, name: str = ",") -> list[Ground]:
    """Those that an operator joins."""
    found = []
    while indicator(data) == (name, 2):
        assert isinstance(data, tuple)
        found.append(data[1])
        data = data[2]
    return [*found, data]


def told(data: Ground) -> str:
    """A term as people write it, cut short where it is long."""
    text = _told(data)
    return text if len(text) <= _LONG else f"{text[: _LONG - 3]}..."


def _told(data: Ground) -> str:
    if not isinstance(data, tuple):
        return written(data) if isinstance(data, str) and (is_name(data) or data[:1].isalnum()) else str(data)
    if is_variable(data):
        turn, letter = divmod(number(data), 26)
        return chr(ord("A") + letter) + (str(turn) if turn else "")
    items = elements(data)
    if items is not None:
        return f"[{', '.join(map(_told, items))}]"
    if data[0] == "[|]" and len(data) == 3:
        return f"[{_told(data[1])}|{_told(data[2])}]"
    name, args = data[0], [_told(each) for each in data[1:]]
    if len(args) == 2 and not is_name(name) and name != "#":
        return f"{args[0]}{name}{args[1]}"
    if len(args) == 1 and not is_name(name):
        return f"{name}{args[0]}"
    return f"{_told(name)}({', '.join(args)})"


def canonical(data: Ground, once: Collection[int] = ()) -> str:
    """A term as Prolog reads it, whatever the operators, with _ for the variables that are there once."""
    if not isinstance(data, tuple):
        return written(data)
    if is_variable(data):
        return "_" if number(data) in once else f"V{data[1]}"
    items = elements(data)
    if items is not None:
        return f"[{', '.join(canonical(each, once) for each in items)}]"
    return f"{written(data[0])}({', '.join(canonical(each, once) for each in data[1:])})"


def match(pattern: Ground, data: Ground, bound: dict[int, Ground]) -> bool:
    """Whether a ground term is an instance of a pattern; notes in `bound` what the pattern's variables stand for."""
    if is_variable(pattern):
        return bound.setdefault(number(pattern), data) == data
    if not isinstance(pattern, tuple):
        return pattern == data and isinstance(pattern, str) == isinstance(data, str)
    return (
        isinstance(data, tuple)
        and len(data) == len(pattern)
        and data[0] == pattern[0]
        and all(map(match, pattern[1:], data[1:], [bound] * (len(data) - 1)))
    )
