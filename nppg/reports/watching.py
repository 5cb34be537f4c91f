"""What is seen of a run while it goes on in a notebook: its curve as far as it has come."""

from __future__ import annotations

from collections.abc import Callable
from html import escape
from typing import Any

from nppg.experiments.progress import Progress, sizes, title
from nppg.reports.chart import Line, chart, legend


def watch() -> Callable[[Progress], None]:
    """To be the `report` of nppg.run: draws the curve anew with each of its points, and below it how far the run has
    come; where there is no notebook a line is printed for each."""
    shown: list[Any] = []

    def report(progress: Progress) -> None:
        if progress.point is None:
            return
        display = _display()
        if display is None:
            print(told(progress))
        elif shown:
            shown[0].update(_Html(progress_html(progress)))
        else:
            shown.append(display(_Html(progress_html(progress)), display_id=True))

    return report


def told(progress: Progress) -> str:
    """How far a run has come, in one line."""
    stochastic, greedy = progress.judged(progress.curve[-1]) if progress.curve else (0.0, 0.0)
    return (
        f"{title(progress.policy.domain)}: episode {progress.episodes:,} of {progress.options.episodes:,}, "
        f"{sizes(progress.policy)}, {progress.measure} {stochastic:.4f}, greedy {greedy:.4f}, {progress.seconds:.1f} s"
    )


def progress_html(progress: Progress) -> str:
    """The same with the curve."""
    episodes = [point.episode for point in progress.curve]
    judged = [progress.judged(point) for point in progress.curve]
    still = [0.0] * len(episodes)
    lines = [
        Line(f"{name} policy", 0, greedy, episodes, [each[greedy] for each in judged], still, 1)
        for name, greedy in (("stochastic", False), ("greedy", True))
    ]
    keys = f'<ul style="list-style:none;display:flex;gap:1.5em;padding:0">{legend(lines)}</ul>'
    return f'<div style="max-width:48rem">{chart(lines, progress.measure)}{keys}<p>{escape(told(progress))}</p></div>'


class _Html:
    """HTML, to whoever displays it."""

    def __init__(self, text: str):
        self._text = text

    def _repr_html_(self) -> str:
        return self._text


def _display() -> Any:
    """A notebook's function to display things with; None where this is none."""
    try:
        from IPython import get_ipython
        from IPython.display import display
    except ImportError:
        return None
    shell = get_ipython()
    return display if shell is not None and type(shell).__name__ == "ZMQInteractiveShell" else None
