"""The figures of an experiment: its numbers as CSV, its picture, a report in Markdown.

Each has a module with three functions: `rows` of numbers from the finished runs, `draw` them, `tell` them.
"""

from __future__ import annotations

import platform
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

from nppg.bridge.files import replacing
from nppg.errors import NppgError
from nppg.experiments.drawing import pyplot
from nppg.experiments.figures import corridor, learners, lengths
from nppg.experiments.figures.common import write_csv
from nppg.experiments.reproduce import Job


def write(name: str, finished: Sequence[Job], output: Path, command: str, seconds: float) -> list[Path]:
    """Writes NAME.csv, NAME.png and NAME.md from the finished runs. Returns their paths."""
    if pyplot() is None:
        raise NppgError("the picture needs matplotlib: pip install 'nppg[plot]'")
    figure = {"figure1": learners, "figure2": lengths, "figure3": corridor}[name]
    found = figure.rows(finished)
    paths = [output / f"{name}.{suffix}" for suffix in ("csv", "png", "md")]
    replacing(paths[0], lambda path: write_csv(found, path))
    replacing(paths[1], lambda path: figure.draw(found, path))
    text = [*_head(name, finished, command, seconds), *figure.tell(found, finished), ""]
    replacing(paths[2], lambda path: path.write_text("\n".join(text)))
    return paths


def _head(name: str, finished: Sequence[Job], command: str, seconds: float) -> list[str]:
    summary = finished[0].summary()
    parameters = ", ".join(f"{key} = {value}" for key, value in summary["domain"]["parameters"].items())
    took = f"The runs not done before took {seconds / 60:.1f} minutes" if seconds else "All runs had been done before"
    return [
        f"# {name}",
        "",
        f"`{command}`",
        "",
        f"{summary['domain']['file']} ({parameters}); nppg {version('nppg')}, Python {platform.python_version()}, "
        f"SWI-Prolog {summary['prolog']}, {platform.machine()}. {took}.",
        "",
        f"![{name}]({name}.png)",
        "",
    ]
