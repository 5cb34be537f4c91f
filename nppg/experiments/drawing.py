"""Pictures, where matplotlib is there to draw them."""

from __future__ import annotations

from typing import Any


def pyplot() -> Any:
    """matplotlib's, for files alone; None where it is missing."""
    try:
        import matplotlib
    except ImportError:
        return None
    matplotlib.use("Agg")
    from matplotlib import pyplot

    return pyplot
