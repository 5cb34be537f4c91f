"""nppg convert."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.cli.writing import write_new
from nppg.tilde.reading import read_task
from nppg.tilde.writing import files_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The data, and where to write."""
    parser.add_argument("source", nargs="+", help="a folder, or files of ACE (.s .kb .bg) or Aleph (.b .f .n, .pl)")
    parser.add_argument("--output", type=Path, metavar="FOLDER", help="(default: the data set's name)")


def run(options: argparse.Namespace) -> int:
    """Writes the data set as nppg has it, and lists what of it could not be carried over. Raises NppgError."""
    task = read_task(options.source)
    folder = options.output or Path(task.name)
    files = files_of(task)
    write_new(folder, dict(files))
    print(f"written to {folder}/: {', '.join(files)}; {len(task.examples)} examples, {len(task.bias.modes)} modes")
    for problem in task.left_out:
        print(problem)
    print(f"next: nppg tilde fit {folder / f'{task.name}.yaml'}")
    return 0
