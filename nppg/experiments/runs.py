"""A training run with its learning curve and its files."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.plain import alone
from nppg.errors import NppgError, Problem
from nppg.experiments.learners import options_of
from nppg.experiments.points import Points, is_due
from nppg.experiments.progress import Judging, Point, Progress
from nppg.experiments.run_files import any_reached, in_the_way, write_files
from nppg.experiments.train import train
from nppg.judging.space import Space
from nppg.learning.options import Common
from nppg.learning.rollouts import are_many
from nppg.learning.training import Iteration
from nppg.worlds.domain import Domain


def run(
    domain: Domain,
    bias: LanguageBias,
    options: Common | None,
    output: Path,
    evaluate_every: int | None = None,
    starts: int | None = None,
    report: Callable[[Progress], None] = lambda progress: None,
    until_success: float | None = None,
    space: Space | None = None,
    until_return: float | None = None,
    jobs: int = 1,
) -> Progress:
    """Trains and writes the files into the folder `output`; `options` are by default, None, those of the bias.

    Every `evaluate_every` episodes (0: never; by default 50, and 200 where the domain's starts are drawn from problems)
    the policy is evaluated: exactly where the domain allows it and has few classes of states; on some of the problems,
    20 at most, each once; else on `starts` sampled starts, by default 1000, which are drawn in place of problems, too,
    where they are given. With `until_success` or `until_return` the run ends at the first such point where the
    stochastic policy reaches it; for a return all points are sampled. `space` is the domain's, where the caller has it
    already. Up to `jobs` processes work at the run, with the same numbers: sampled points may then be drawn while
    training goes on, and come later, in order.

    On KeyboardInterrupt the files are written for what has been learned, then it is raised again; after a mistake of
    the domain they are written as far as there was none before, so that nothing is lost and nothing overwritten. Raises
    NppgError, before it starts, where a file that no run wrote stands in the way of a copy of the domain or the bias.
    """
    options = options_of(bias) if options is None else options
    judging = judging_of(domain, evaluate_every, starts, until_success, until_return)
    evaluate_every, starts = judging["evaluate_every"], judging["starts"]
    problems = bias.check(domain.predicates, domain.actions)
    problems += in_the_way(domain, bias, output)
    if problems:
        raise NppgError(problems)
    make_folder(output)
    progress: Progress | None = None
    points: Points | None = None
    at_once = until_success is not None or until_return is not None
    try:
        clock = time.perf_counter()
        for iteration in train(domain, bias, options, jobs):
            progress = progress or Progress(iteration.policy, options, judging)
            _advance(progress, iteration, time.perf_counter() - clock)
            if is_due(progress, len(iteration.recent), evaluate_every):
                points = points or Points(progress, starts, space, 1 if at_once or are_many(options) else jobs)
                points.draw(progress)
            ended = progress.episodes == options.episodes
            for point in points.drawn(wait=ended) if points else ():
                progress.curve.append(point)  # before others are told, which may end the run
                if progress.point:
                    report(progress)
                progress.point = point
            reached = _reached(progress.point, until_success, until_return)
            progress.ended = reached or ended
            report(progress)
            if reached:
                break
            progress.point = None
            clock = time.perf_counter()
    except BaseException as error:
        interrupted = isinstance(error, KeyboardInterrupt)
        if progress and (interrupted or not (output / "model.pl").exists()):
            progress.curve.extend(points.rescued() if points else ())
            write_files(progress, bias, output)
        raise
    finally:
        if points:
            points.close()
    assert progress is not None
    progress.written = write_files(progress, bias, output)
    return progress


def judging_of(
    domain: Domain,
    evaluate_every: int | None,
    starts: int | None,
    until_success: float | None = None,
    until_return: float | None = None,
) -> Judging:
    """These arguments of `run`, with what is meant where they are left out."""
    return {
        "evaluate_every": alone((200 if domain.chosen else 50) if evaluate_every is None else evaluate_every),
        "starts": alone(1000 if starts is None and not domain.chosen else starts),
        "until_success": alone(until_success),
        "until_return": alone(until_return),
    }


def make_folder(output: Path) -> None:
    """Raises NppgError where it cannot be written to."""
    try:
        output.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=output).close()
    except OSError as error:
        raise NppgError([Problem(str(output), 0, 0, f"the folder cannot be written to: {error.strerror}")]) from None


def _reached(point: Point | None, success: float | None, mean_return: float | None) -> bool:
    if point is None:
        return False
    return any_reached((point.success, success), (point.mean_return, mean_return))


def _advance(progress: Progress, iteration: Iteration, seconds: float) -> None:
    progress.seconds += seconds
    progress.episodes, progress.stage = iteration.episodes, iteration.stage
    if progress.measure == "success":
        progress.outcomes += [episode.success for episode in iteration.recent]
    else:
        progress.outcomes += [episode.undiscounted for episode in iteration.recent]
