"""What an estimator takes for X, as examples: keys, sets of facts, or the rows of a table.

A column of a table is asked as value(Column, X): a number by thresholds, a name by the names that the column has. What
is missing (None, NaN) is no fact.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from nppg.bias.declarations import Argument, Mode, Template
from nppg.bias.language_bias import LanguageBias
from nppg.bridge.plain import alone
from nppg.bridge.terms import Ground
from nppg.logic.query import OPEN
from nppg.tilde.declared import bias_of
from nppg.tilde.targets import InputError
from nppg.tilde.task import Example

_VALUE, _NUMBER, _NAME, _COLUMN = "value", "number", "name", "column"


@dataclass(frozen=True)
class Columns:
    """Those of a table; what is called a name holds names."""

    names: tuple[str, ...]
    are_named: bool  # by who gave the table
    kinds: tuple[str, ...]

    @property
    def bias(self) -> LanguageBias:
        """Each column with what is tested about it."""
        modes = []
        for column, kind in zip(self.names, self.kinds, strict=True):
            place = Argument("#", _COLUMN, (column,))
            value = Argument("-", _NUMBER) if kind == _NUMBER else Argument("#", _NAME)
            modes.append(Mode(_VALUE, (place, value), lookahead=int(kind == _NUMBER)))
        bound = Mode("=<", (Argument("+", _NUMBER), Argument("#", _NUMBER, (OPEN["=<"],))))
        types = {(_VALUE, 2): (_COLUMN, _NUMBER)}
        return bias_of(Path("the table"), Template("example", ()), types, (*modes, bound), (), 1)


def examples_of(X: Any, arity: int) -> list[Example]:
    """Keys of so many values, sets of facts, or examples as they are. Raises InputError."""
    if X is None or isinstance(X, str) or not hasattr(X, "__len__"):
        raise InputError("X is a sequence of examples: keys, or collections of facts")
    if not len(X):
        raise InputError("there are no examples: Found array with 0 sample(s)")
    return [_example(each, i, arity) for i, each in enumerate(X)]


def _example(given: Any, i: int, arity: int) -> Example:
    if isinstance(given, Example):
        found = given
    elif isinstance(given, list | set | frozenset):
        found = Example((), facts=tuple(given))
    else:
        given = alone(given)
        found = Example(tuple(map(alone, given)) if isinstance(given, tuple) else (given,))
    if len(found.key) != arity:
        wanted = f"a key of {arity} value{'s' * (arity != 1)}" if arity else "a list of facts"
        raise InputError(f"example {i} of X is {given!r}: {wanted} is wanted")
    return found


def columns_of(X: Any) -> Columns:
    """The columns of a table. Raises InputError for what is none."""
    rows, names = _rows(X)
    kinds = [_NAME if any(isinstance(row[k], str) for row in rows) else _NUMBER for k in range(len(rows[0]))]
    given = names or [f"x{k}" for k in range(len(kinds))]
    return Columns(tuple(given), bool(names), tuple(kinds))


def table_examples(X: Any, columns: Columns, who: str) -> list[Example]:
    """The rows of a table with the same columns. Raises InputError."""
    rows, _ = _rows(X)
    count = len(columns.names)
    if len(rows[0]) != count:
        raise InputError(f"X has {len(rows[0])} features, but {who} is expecting {count} features as input")
    found = []
    for i, row in enumerate(rows):
        facts: list[Ground] = []
        for column, kind, value in zip(columns.names, columns.kinds, row, strict=True):
            if value is None or value != value:
                continue
            if kind == _NUMBER and isinstance(value, str):
                raise InputError(f"example {i} of X has {value!r} for {column}, which is no number")
            if isinstance(value, float) and math.isinf(value):
                raise InputError(f"example {i} of X has infinity for {column}")
            facts.append((_VALUE, column, str(value) if kind == _NAME else value))
        found.append(Example((), facts=tuple(facts)))
    return found


def _rows(X: Any) -> tuple[Sequence[Sequence[Any]], list[str]]:
    if type(X).__module__.startswith("scipy.sparse") or hasattr(X, "tocsr"):
        raise InputError("X is a sparse matrix: a dense one is wanted")
    columns = getattr(X, "columns", None)
    names = list(columns) if isinstance(columns, Collection) and all(isinstance(each, str) for each in columns) else []
    array = np.asarray(X, dtype=object if columns is not None else None)
    if array.dtype.kind == "c":
        raise InputError("Complex data not supported: X has complex numbers")
    if array.ndim != 2:
        hint = "; without a language bias X is a table of rows and columns"
        raise InputError(f"Expected 2D array, got {array.ndim}D array instead{hint}. Reshape your data")
    if not array.shape[0] or not array.shape[1]:
        what = "sample" if not array.shape[0] else "feature"
        raise InputError(f"Found array with 0 {what}(s) (shape={array.shape}) while a minimum of 1 is required.")
    rows = array.tolist()
    for i, row in enumerate(rows):
        for k, value in enumerate(row):
            if isinstance(value, bytes) or not (value is None or isinstance(value, str | int | float)):
                row[k] = _number(value, i)
    return rows, names


def _number(value: Any, i: int) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        message = f"example {i} of X has {value!r}: argument must be a string or a number"
        raise (TypeError(message) if isinstance(value, dict) else InputError(message)) from None
