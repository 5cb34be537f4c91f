"""Pictures, where matplotlib is there to draw them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from nppg.bridge.files import replacing


def pyplot() -> Any:
    """matplotlib's, for files alone; None where it is missing."""
    try:
        import matplotlib
    except ImportError:
        return None
    matplotlib.use("Agg")
    from matplotlib import pyplot

    return pyplot


def save_curve(figure: Any, axes: Any, measure: str, title: str, path: Path) -> None:
    """Finishes the picture of a learning curve, whose lines are drawn, and writes it."""
    axes.set(xlabel="episodes", ylabel=measure, title=title)
    if measure == "success":
        axes.set(ylim=(-0.02, 1.02))
    axes.grid(alpha=0.3)
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
    replacing(path, lambda temporary: figure.savefig(temporary, format="png", dpi=120))
