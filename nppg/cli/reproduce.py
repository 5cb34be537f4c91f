"""nppg reproduce."""

from __future__ import annotations

import argparse
import time
from pathlib import Path

from nppg.cli.arguments import add_parameters, parameters
from nppg.experiments import figures
from nppg.experiments.paper import EXPERIMENTS
from nppg.experiments.reproduce import available_cores, do, jobs
from nppg.learning.options import at_least


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The experiment, and how much of it."""
    parser.add_argument("experiment", choices=EXPERIMENTS)
    parser.add_argument("--runs", type=int, help="runs of each variant, seeds from 0 (default: as in the paper)")
    parser.add_argument("--episodes", type=int, help="of each run (default: as in the paper)")
    parser.add_argument("--jobs", type=int, help="runs at a time (default: the cores there are)")
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
    processes = available_cores() if options.jobs is None else options.jobs
    runs = experiment.runs if options.runs is None else options.runs
    episodes = experiment.episodes if options.episodes is None else options.episodes
    for name, value in (("runs", runs), ("jobs", processes)):
        at_least(name, value, 1)
    wanted = jobs(experiment, runs, episodes, parameters(options.set), options.output)
    begin, done = time.perf_counter(), 0
    for count, (job, seconds) in enumerate(do(wanted, processes), 1):
        done += seconds > 0
        how = f"{seconds:.0f} s" if seconds else "done before"
        print(f"{count:3d} of {len(wanted)}: {job.folder.name}, {job.result()}, {how}", flush=True)
    command = " ".join(["nppg", "reproduce", *(options.arguments[1:])])
    took = time.perf_counter() - begin if done else 0.0
    for path in figures.write(experiment.name, wanted, options.output, command, took):
        print(f"written: {path}")
    return 0
