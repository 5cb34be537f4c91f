"""Values as data that can be stored and read back: numbers to the bit, what is shared still shared, and nothing run.

A value is a table of entries, each a kind and its items, which are atoms of JSON or, in a list of one, the number of an
entry before. So nothing is nested, however deep a value is. What is no list, tuple, dict, bytes or array of NumPy's is
one of the kinds that the caller knows: no name in the data says what is to be called.
"""

from __future__ import annotations

from base64 import b64decode, b64encode
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np

_ATOMS = frozenset({type(None), bool, int, float, str})
_DTYPES = frozenset({"?", "<i1", "|i1", "|b1", "|u1", "<i2", "<i4", "<i8", "<u4", "<u8", "<f4", "<f8"})


class Kind(NamedTuple):
    """Values of a class: their items, and what makes such a value of these."""

    made_of: type
    items: Callable[[Any], Iterable]
    made: Callable[..., Any]


def fields_of(*classes: type) -> list[Kind]:
    """Kinds of dataclasses and named tuples, whose items are their fields."""
    found = []
    for each in classes:
        names = [field.name for field in fields(each)] if is_dataclass(each) else each._fields  # type: ignore[attr-defined]
        found.append(Kind(each, partial(_fields, names), each))
    return found


def _fields(names: Sequence[str], value: Any) -> list:
    return [getattr(value, name) for name in names]


_OWN = (
    Kind(list, lambda value: value, lambda *items: list(items)),
    Kind(tuple, lambda value: value, lambda *items: items),
    Kind(
        dict,
        lambda value: (each for pair in value.items() for each in pair),
        lambda *items: dict(zip(items[::2], items[1::2], strict=True)),
    ),
    Kind(bytes, lambda value: (b64encode(value).decode(),), lambda text: b64decode(text, validate=True)),
    Kind(
        np.ndarray,
        lambda value: (value.dtype.str, b64encode(value.tobytes()).decode(), *value.shape),
        lambda dtype, text, *shape: _array(dtype, text).reshape(shape).copy(),
    ),
)


def _array(dtype: str, text: str) -> np.ndarray:
    if dtype not in _DTYPES:
        raise ValueError(f"{dtype!r} is no type of numbers")
    return np.frombuffer(b64decode(text, validate=True), dtype)


def table_of(value: Any, kinds: Sequence[Kind] = ()) -> list[list]:
    """The entries of a value, its own last. Raises TypeError for what is of no kind."""
    known = {each.made_of: (each.made_of.__name__, each.items) for each in (*_OWN, *kinds)}
    table: list[list] = []
    places: dict[int, int] = {}
    alike: dict[tuple, int] = {}  # terms that are made of names alone, of which there are many
    held: list[Any] = []  # so that no place is another value's
    waiting: list[tuple[Any, str, list]] = []

    def put(each: Any) -> None:
        if isinstance(each, np.generic):
            name, items = "number", [each.dtype.str, b64encode(each.tobytes()).decode()]
        else:
            try:
                name, get = known[type(each)]
            except KeyError:
                raise TypeError(f"{type(each).__name__} is of no kind") from None
            items = list(get(each))
        waiting.append((each, name, items))

    def is_missing(each: Any) -> bool:
        return type(each) not in _ATOMS and id(each) not in places

    put(value)
    while waiting:
        each, name, items = waiting[-1]
        if id(each) in places:
            waiting.pop()
            continue
        if missing := [item for item in items if is_missing(item)]:
            for item in missing:
                put(item)
            continue
        waiting.pop()
        held.append((each, items))
        key = (name, *items) if isinstance(each, tuple) and {*map(type, items)} == {str} else None
        if key in alike:
            places[id(each)] = alike[key]
            continue
        places[id(each)] = len(table)
        if key:
            alike[key] = len(table)
        table.append([name, *(item if type(item) in _ATOMS else [places[id(item)]] for item in items)])
    return table


def value_of(table: Sequence[Sequence], kinds: Sequence[Kind] = ()) -> Any:
    """The value of these entries. Raises ValueError, TypeError, LookupError or ArithmeticError for what is none."""
    known: Mapping[str, Callable[..., Any]] = {each.made_of.__name__: each.made for each in (*_OWN, *kinds)}
    known = {**known, "number": lambda dtype, text: _array(dtype, text)[0]}
    found: list[Any] = []
    for name, *items in table:
        made = known[name]
        found.append(made(*[_item(item, found) if type(item) is list else item for item in items]))
    return found[-1]


def _item(reference: list, found: Sequence[Any]) -> Any:
    (number,) = reference
    if type(number) is not int or number < 0:
        raise ValueError(f"{number!r} is no entry")
    return found[number]
