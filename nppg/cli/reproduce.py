"""nppg reproduce."""

from __future__ import annotations

import argparse
import time
from pathlib import Path

from nppg.cli import jobs
from nppg.cli.arguments import add_parameters, parameters
from nppg.experiments import figures
from nppg.experiments.paper import EXPERIMENTS
from nppg.experiments.reproduce import jobs_of
from nppg.learning.options import at_least


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The experiment, and how much of it."""
    parser.add_argument("experiment", choices=EXPERIMENTS)
    parser.add_argument("--runs", type=int, help="runs of each variant, seeds from 0 (default: as in the paper)")
    parser.add_argument("--episodes", type=int, help="of each run (default: as in the paper)")
    jobs.add_pool(parser)
    add_parameters(parser)
    parser.add_argument(
        "--output",
        type=Path,
        default=Path("runs/reproduce"),
        help="folder for all; finished runs that it has are not done again (default: runs/reproduce)",
    )


def run(options: argparse.Namespace) -> int:
    """Prints a line a run, then the files. Raises NppgError."""
    experiment = EXPERIMENTS[options.experiment]
    pool = jobs.pool(options)
    runs = experiment.runs if options.runs is None else options.runs
    episodes = experiment.episodes if options.episodes is None else options.episodes
    at_least("runs", runs, 1)
    wanted = jobs_of(experiment, runs, episodes, parameters(options.set), options.output)
    begin = time.perf_counter()
    command = " ".join(["nppg", "reproduce", *(options.arguments[1:])])
    any_done = jobs.do(wanted, pool)
    took = time.perf_counter() - begin if any_done else 0.0
    for path in figures.write(experiment.name, wanted, options.output, command, took):
        print(f"written: {path}")
    return 0
