"""nppg report."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.bridge.files import replacing
from nppg.cli.arguments import add_parameters, add_problems, add_trust, parameters
from nppg.learning.options import at_least
from nppg.reports.build import EPISODES, Wishes, report


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The runs, and the page."""
    parser.add_argument(
        "runs", type=Path, nargs="+", metavar="RUN", help="the folder of a run, or of several, or a model file"
    )
    parser.add_argument(
        "--output", type=Path, default=Path("report.html"), metavar="FILE", help="the page (default: report.html)"
    )
    parser.add_argument(
        "--episodes", type=int, default=EPISODES, metavar="N", help=f"to show of each policy (default: {EPISODES})"
    )
    parser.add_argument("--seed", type=int, default=0, help="of these episodes (default: 0)")
    parser.add_argument("--prove", action="store_true", help="prove policies that no certificate lies beside")
    add_parameters(parser)
    add_problems(parser)
    add_trust(parser)


def run(options: argparse.Namespace) -> int:
    """Writes the page. Raises NppgError."""
    at_least("episodes", options.episodes, 0)
    at_least("seed", options.seed, 0)
    wishes = Wishes(options.episodes, options.seed, parameters(options.set), options.problems, options.prove)
    text = report(options.runs, wishes)
    replacing(options.output, lambda path: path.write_text(text, encoding="utf-8"))
    print(f"written to {options.output}: {len(text.encode()):,} bytes")
    return 0
