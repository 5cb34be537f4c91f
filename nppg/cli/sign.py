"""nppg sign."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.errors import NppgError, Problem
from nppg.experiments.signing import sign


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The files."""
    parser.add_argument(
        "files", nargs="+", type=Path, metavar="FILE", help="a model, a certificate, a checkpoint or a run.json"
    )


def run(options: argparse.Namespace) -> int:
    """Prints the files that it has signed. Raises NppgError with those that are of no such kind."""
    problems: list[Problem] = []
    for file in options.files:
        try:
            sign(file)
        except NppgError as error:
            problems += error.problems
        else:
            print(f"{file}: signed")
    if problems:
        raise NppgError(problems)
    return 0
