"""NumPy's numbers as Python's own: others do not cross to Prolog as what they are, nor into files."""

from __future__ import annotations

from typing import Any

import numpy as np


def alone(value: Any) -> Any:
    """A number of NumPy's, or the only one in an array, as Python has it; everything else as it is."""
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.size == 1):
        value = value.item()
    return float(value) if isinstance(value, np.longdouble) else value
