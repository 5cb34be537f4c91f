"""What environments of Gymnasium return, as plain numbers; an array of one number counts as the number."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from typing import Any

import numpy as np

from nppg.bridge.plain import LARGEST, alone

_SHOWN = 80  # characters of a value that a message has


class Unfit(Exception):
    """Says what a value is that is no such number; the message begins with `what` the value stands for."""


def number(what: str, value: Any) -> float:
    """A finite one. All of these raise Unfit."""
    try:
        found = value if type(value) is float else float(alone(value))
    except Exception:  # whatever the code of its class may raise
        found = np.nan
    if -LARGEST <= found <= LARGEST:
        return found
    raise _unfit(what, value, "is no finite number")


def whole(what: str, value: Any) -> int:
    """A float that is one counts as such."""
    if type(value) is int:
        return value
    try:
        plain = alone(value)
        found = int(plain)
        if found == plain:
            return found
    except Exception:
        pass
    raise _unfit(what, value, "is no whole number")


def flag(what: str, value: Any) -> bool:
    """1 and 0 count as such."""
    if value is True or value is False:
        return value
    try:
        plain = alone(value)
        if plain in (True, False):
            return bool(plain)
    except Exception:
        pass
    raise _unfit(what, value, "is neither True nor False")


def numbers(what: str, value: Any, count: int) -> list[float]:
    """Of an array of any shape; rounded to what float32 holds."""
    try:
        array = np.asarray(value)
        if array.dtype != np.float32:
            array = _narrowed(array)
    except Exception:
        raise _unfit(what, value, "is no array of numbers") from None
    if array.size != count:
        raise _unfit(what, value, f"is no array of {count} numbers")
    found = array.reshape(count).tolist()
    if not isfinite(sum(found)):
        raise _unfit(what, value, "has numbers that are not finite")
    return found


def _narrowed(array: np.ndarray) -> np.ndarray:
    if array.dtype.kind not in "biufO":
        raise ValueError
    with np.errstate(over="ignore"):
        return array.astype(np.float32)


def mask(what: str, value: Any, count: int) -> list[bool]:
    """One truth value for each of `count` actions."""
    try:
        array = np.asarray(value)
        found = array.ravel().tolist()
        fit = array.dtype.kind in "biu" or (array.dtype.kind == "f" and isfinite(sum(found)))
    except Exception:
        fit = False
    if not fit:
        raise _unfit(what, value, "is no array of 0 and 1")
    if len(found) != count:
        raise _unfit(what, value, f"has {len(found)} entries for {count} actions")
    return found


def told(what: str, value: Any) -> Mapping[str, Any]:
    """What stands in a dict; nothing in None."""
    if isinstance(value, dict | Mapping):
        return value
    if value is None:
        return {}
    raise _unfit(what, value, "is no dict")


def parts(what: str, value: Any, names: str) -> tuple[Any, ...] | list[Any]:
    """A tuple of the values that have these names."""
    count = names.count(",") + 1
    if isinstance(value, tuple | list) and len(value) == count:
        return value
    raise _unfit(what, value, f"and not {count} values: {names}")


def _unfit(what: str, value: Any, problem: str) -> Unfit:
    """Shows a value on one line, cut where it is long."""
    try:
        shown = " ".join(repr(value).split())
    except Exception:
        shown = f"a {type(value).__name__}"
    return Unfit(f"{what} {shown if len(shown) <= _SHOWN else f'{shown[:_SHOWN]}...'} {problem}")
