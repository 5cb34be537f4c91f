"""nppg import."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.answers.coverage import root_table
from nppg.bias.refinement import Refiner
from nppg.cli.writing import write_new
from nppg.worlds.pddl_domain import import_domain


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The files, and where to write."""
    parser.add_argument("domain", type=Path, help="a PDDL domain")
    parser.add_argument("problem", type=Path, nargs="*", help="its problems")
    parser.add_argument("--output", type=Path, metavar="FOLDER", help="(default: the domain's name)")


def run(options: argparse.Namespace) -> int:
    """Writes the domain file, its language bias and its problems, and says what comes next. Raises NppgError."""
    domain = import_domain(options.domain, options.problem)
    bias = domain.language_bias()
    folder = options.output or Path(domain.name)
    files = {domain.path.name: domain.source, Path(bias.file).name: bias.source, **domain.companions}
    write_new(folder, files)
    tests = len(root_table(domain, bias, Refiner(bias)))
    print(f"written to {folder}/: {', '.join(files)}; {tests} tests, {len(domain.problems)} problems")
    print(f"next: nppg check {folder / domain.path.name}, then nppg train {folder / domain.path.name}")
    return 0
