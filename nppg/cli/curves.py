"""nppg curves."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.bridge.files import replacing
from nppg.errors import NppgError
from nppg.reports.chart import chart
from nppg.reports.runs import experiments, lines_of, runs_in


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The runs, and the picture."""
    parser.add_argument("runs", type=Path, nargs="+", metavar="RUN", help="the folder of a run, or of several")
    parser.add_argument(
        "--output", type=Path, default=Path("curves.svg"), metavar="FILE", help="the picture (default: curves.svg)"
    )


def run(options: argparse.Namespace) -> int:
    """Draws the curves in one picture, and prints where each ends. Raises NppgError."""
    runs = runs_in(options.runs)
    measures = {run.measure for run in runs if run.curve}
    if not measures:
        raise NppgError("none of these runs has a curve")
    if len(measures) > 1:
        raise NppgError("some of these runs are judged by success, others by returns: draw them apart")
    (measure,) = measures
    lines = lines_of(list(experiments(runs)), measure)
    replacing(options.output, lambda path: path.write_text(chart(lines, measure, keys=True), encoding="utf-8"))
    for line in lines:
        spread = f" ± {line.spreads[-1]:.4f}" if line.runs > 1 else ""
        print(f"{line.label}: {measure} {line.means[-1]:.4f}{spread} after {line.episodes[-1]:,.0f} episodes")
    print(f"written to {options.output}")
    return 0
