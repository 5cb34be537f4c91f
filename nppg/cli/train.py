"""nppg train."""

from __future__ import annotations

import argparse
import math
from dataclasses import fields, replace
from pathlib import Path

from nppg.cli import jobs, loading
from nppg.cli.arguments import add_domain, add_seconds, checked_seconds, warnings_told
from nppg.cli.progress import ENDLESS, reporter
from nppg.cli.training_options import add_training_options, chosen_options
from nppg.errors import NppgError
from nppg.experiments import runs, seeds
from nppg.experiments.checkpoints import MINUTE
from nppg.experiments.jobs import Job, packed
from nppg.experiments.learners import LEARNERS, LIMITS, learner_of, options_of
from nppg.experiments.many import available_cores
from nppg.experiments.resuming import Begun, begun
from nppg.learning.options import at_least
from nppg.worlds.problems import numbers_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """In groups, the options of the learners among them."""
    parser.usage = "nppg train DOMAIN [--option VALUE ...]\n       nppg train --resume DIR [--episodes N]"
    parser.epilog = "What is left out has the value that the language bias's options give it, else its default."
    learned = parser.add_argument_group("what to learn")
    add_domain(learned, needed=False)
    learned.add_argument(
        "--resume",
        type=Path,
        metavar="DIR",
        help="go on with the run of this folder from its last checkpoint; with more --episodes beyond its end",
    )
    files = parser.add_argument_group("output")
    files.add_argument(
        "--output",
        type=Path,
        metavar="DIR",
        help="folder for the files (default: runs/DOMAIN, or runs/DOMAIN-seeds)",
    )
    files.add_argument(
        "--evaluate-every",
        type=int,
        metavar="N",
        help="episodes between two points of the curve; 0: none (default: 50; with problems 200)",
    )
    files.add_argument(
        "--starts",
        type=int,
        metavar="N",
        help="starts of a sampled point of the curve (default: 200; with problems 20 of these)",
    )
    files.add_argument(
        "--until-success", type=float, metavar="P", help="stop at the first point of the curve with this success"
    )
    files.add_argument(
        "--until-return",
        type=float,
        metavar="R",
        help="stop at the first point with this mean return; points are then sampled, not exact",
    )
    add_seconds(files, "stop with the episode after so many seconds of learning; without --episodes, not before")
    files.add_argument(
        "--checkpoint-every",
        type=float,
        default=MINUTE,
        metavar="S",
        help="seconds between two checkpoints, from which --resume goes on; 0: none (default: 60)",
    )
    files.add_argument("--quiet", action="store_true", help="print nothing")
    many = parser.add_argument_group("several runs")
    many.add_argument(
        "--seeds",
        metavar="N-M",
        help="a run with each of these seeds, 0-9 or 0,3,7, in a folder of its own, and one curve; finished runs that "
        "the folder has are not done again",
    )
    jobs.add_pool(
        many,
        "runs at a time (default: the cores there are); without --seeds, processes that work at the run, with "
        "the same result (default: 2, where there are as many cores)",
    )
    add_training_options(parser, learned)


def run(options: argparse.Namespace) -> int:
    """Learns, prints the curve's points and writes the files. Raises NppgError."""
    every = options.checkpoint_every
    if not 0 <= every < math.inf:
        raise NppgError(f"checkpoint-every must be a finite number, at least 0, not {every:g}")
    if options.resume is not None:
        return _resumed(options)
    if options.domain is None:
        raise NppgError("nppg train: name a domain, or a run to go on with by --resume")
    at_least("evaluate-every", options.evaluate_every or 0, 0)
    seconds = checked_seconds(options)
    if options.starts is not None:
        at_least("starts", options.starts, 1)
    domain = loading.domain(options)
    starts = 200 if options.starts is None and not domain.chosen else options.starts
    bias = loading.bias(options, domain)
    assert bias
    learner = learner_of(bias, options.learner)
    given = chosen_options(options, learner)
    if seconds is not None and "episodes" not in {*given, *bias.options}:
        given["episodes"] = ENDLESS
    own = {field.name for field in fields(LEARNERS[learner])}
    limits = {LIMITS[name].name: value for name, value in given.items() if name not in own}
    bias = replace(bias, tree=replace(bias.tree, **limits))
    chosen = options_of(bias, learner, **{name: value for name, value in given.items() if name in own})
    until = options.until_success
    if until is not None and not (0 <= until <= 1 and options.evaluate_every != 0):
        raise NppgError("until-success must be from 0 to 1, and needs points of the curve (evaluate-every)")
    least = options.until_return
    if least is not None and not (math.isfinite(least) and options.evaluate_every != 0):
        raise NppgError("until-return must be a finite number, and needs points of the curve (evaluate-every)")
    output = options.output or Path("runs") / (domain.name if options.seeds is None else f"{domain.name}-seeds")
    judging = runs.judging_of(domain, options.evaluate_every, starts, until, least, seconds)
    if options.seeds is not None:
        return _with_seeds(options, Job(packed(domain, bias), chosen, judging, output))
    if options.cluster is not None:
        raise NppgError("--cluster is for several runs: give --seeds")
    return _learned(options, Begun(domain, bias, chosen, judging), output)


def _learned(options: argparse.Namespace, begun: Begun, output: Path) -> int:
    """Does a run, or goes on with it. Raises NppgError."""
    processes = min(2, available_cores()) if options.jobs is None else at_least("jobs", options.jobs, 1)
    report = (lambda progress: None) if options.quiet else reporter(begun.options)
    with warnings_told(not options.quiet):
        progress = runs.run(
            begun.domain,
            begun.bias,
            begun.options,
            output,
            report=report,
            jobs=processes,
            checkpoint_every=options.checkpoint_every,
            resume=options.resume is not None,
            **begun.judging,
        )
    if not options.quiet:
        print(f"written to {output}/: {', '.join(progress.written)}")
    return 0


def _resumed(options: argparse.Namespace) -> int:
    """Goes on with a run. Raises NppgError."""
    known = {"resume", "episodes", "jobs", "quiet", "checkpoint_every", "trust", "arguments"}
    given = [name for name, value in vars(options).items() if name not in known and value not in (None, False, [])]
    if given:
        name = given[0].replace("_", "-")
        what = "the domain" if name == "domain" else f"--{name}"
        raise NppgError(f"nppg train --resume goes on with what the run was begun with: leave out {what}")
    return _learned(options, begun(options.resume, options.episodes), options.resume)


def _with_seeds(options: argparse.Namespace, job: Job) -> int:
    """Does the run with each of the seeds, prints a line for each, and writes their curve. Raises NppgError."""
    if options.seed is not None:
        raise NppgError("--seed is for one run, --seeds for several: give one of them")
    numbers = numbers_of(options.seeds, "--seeds")
    if numbers is None:
        raise NppgError(f"--seeds takes numbers such as 0-9 or 0,3,7, not '{options.seeds}'")
    wanted = seeds.with_seeds(job, dict.fromkeys(numbers))
    with warnings_told(not options.quiet):
        jobs.do(wanted, jobs.pool(options), not options.quiet)
    written = seeds.write(wanted, job.folder) if job.judging["evaluate_every"] else []
    if not options.quiet:
        if written:
            print(seeds.summary(wanted))
        print(f"written to {job.folder}/: {', '.join([*map(str, wanted), *written])}")
    return 0
