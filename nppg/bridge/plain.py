"""NumPy's numbers as Python's own: others do not cross to Prolog as what they are, nor into files."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np


def alone(value: Any) -> Any:
    """A number of NumPy's, or the only one in an array, as Python has it; everything else as it is."""
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.size == 1):
        value = value.item()
    return float(value) if isinstance(value, np.longdouble) else value


def named(parameters: Mapping[str, int | float | str] | None) -> dict[str, int | float | str]:
    """Parameters as Prolog has them: NumPy's numbers are numbers, True and False are the names true and false."""
    values = {name: alone(value) for name, value in (parameters or {}).items()}
    return {name: str(value).lower() if isinstance(value, bool) else value for name, value in values.items()}
