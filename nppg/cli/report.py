"""nppg report."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.bridge.files import replacing
from nppg.cli.arguments import add_parameters, add_trust, parameters
from nppg.reports.build import report


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The runs, and the page."""
    parser.add_argument("runs", type=Path, nargs="+", metavar="RUN", help="the folder of a run, or of several")
    parser.add_argument(
        "--output", type=Path, default=Path("report.html"), metavar="FILE", help="the page (default: report.html)"
    )
    add_parameters(parser)
    add_trust(parser)


def run(options: argparse.Namespace) -> int:
    """Writes the page. Raises NppgError."""
    text = report(options.runs, parameters(options.set))
    replacing(options.output, lambda path: path.write_text(text, encoding="utf-8"))
    print(f"written to {options.output}: {len(text.encode()):,} bytes")
    return 0
