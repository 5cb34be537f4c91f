"""NumPy's numbers as Python's own: others do not cross to Prolog as what they are, nor into files."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np

from nppg.errors import NppgError

LARGEST = 1e100  # of a reward or a target: the squares of what is made of larger ones are no numbers any more


def alone(value: Any) -> Any:
    """A number of NumPy's, or the only one in an array, as Python has it; everything else as it is."""
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.size == 1):
        value = value.item()
    return float(value) if isinstance(value, np.longdouble) else value


def number(what: str, value: Any) -> float:
    """A finite number. Raises NppgError, which says what it is."""
    value = alone(value)
    try:
        found = float(value) if isinstance(value, int | float | Fraction) else np.nan
    except OverflowError:
        raise NppgError(f"{what} is a number larger than {LARGEST}") from None
    if -LARGEST <= found <= LARGEST:
        return found
    if np.isfinite(found):
        raise NppgError(f"{what} {value!r} is larger than {LARGEST}")
    raise NppgError(f"{what} {value!r} is no finite number")


def named(parameters: Mapping[str, int | float | str] | None) -> dict[str, int | float | str]:
    """Parameters as Prolog has them: NumPy's numbers are numbers, True and False are the names true and false."""
    values = {name: alone(value) for name, value in (parameters or {}).items()}
    return {name: str(value).lower() if isinstance(value, bool) else value for name, value in values.items()}
