"""A training run with its learning curve and its files."""

from __future__ import annotations

import math
import tempfile
import time
import warnings
from collections.abc import Callable, Mapping
from contextlib import nullcontext, suppress
from functools import partial
from pathlib import Path
from typing import Any

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import held, sweep
from nppg.bridge.plain import alone
from nppg.errors import NppgError, Problem
from nppg.experiments import checkpoints
from nppg.experiments.checkpoints import MINUTE, Checkpoints
from nppg.experiments.learners import options_of
from nppg.experiments.points import Points, is_due
from nppg.experiments.progress import Judging, Point, Progress
from nppg.experiments.run_files import FILES, any_reached, copies_of, in_the_way, settings, write_files
from nppg.experiments.train import learning_of
from nppg.judging.space import Space
from nppg.learning.options import Common
from nppg.learning.rollouts import are_many
from nppg.learning.training import Iteration
from nppg.policy.copies import BEFORE, CHECKPOINT, recorded_hashes
from nppg.worlds.domain import Domain
from nppg.worlds.gym_domain import GymDomain

_PROGRESS = ("episodes", "stage", "outcomes", "curve", "notes")  # what of it goes on with the run


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
    seconds: float | None = None,
    checkpoint_every: float = MINUTE,
    resume: bool = False,
) -> Progress:
    """Trains and writes the files into the folder `output`; `options` are by default, None, those of the bias.

    Every `evaluate_every` episodes (0: never; by default 50, and 200 where the domain's starts are drawn from problems)
    the policy is evaluated: exactly where the domain allows it and has few classes of states; on some of the problems,
    20 at most, each once; else on `starts` sampled starts, by default 1000, which are drawn in place of problems, too,
    where they are given. With `until_success` or `until_return` the run ends at the first such point where the
    stochastic policy reaches it; for a return all points are sampled. It ends, too, with the episode after so many
    `seconds` of learning. `space` is the domain's, where the caller has it already. Up to `jobs` processes work at the
    run, with the same numbers: sampled points may then be drawn while training goes on, and come later, in order.

    On KeyboardInterrupt the files are written for what has been learned, then it is raised again; after a mistake of
    the domain they are written as far as there was none before, so that nothing is lost and nothing overwritten. Raises
    NppgError, before it starts, where a file that no run wrote stands in the way of a copy of the domain or the bias,
    or another run is writing into the folder.

    After the first episode, then every `checkpoint_every` seconds (0: never), and after the last one a checkpoint is
    written. With `resume` the run goes on from that, and comes to what it would have come to without a break; it may be
    given more episodes.
    """
    options = options_of(bias) if options is None else options
    judging = judging_of(domain, evaluate_every, starts, until_success, until_return, seconds)
    evaluate_every, starts = judging["evaluate_every"], judging["starts"]
    copies = copies_of(domain, bias)
    problems = bias.check(domain.predicates, domain.actions)
    problems += in_the_way(copies, output)
    if problems:
        raise NppgError(problems)
    make_folder(output)
    with held(output):
        sweep(output, (*FILES, CHECKPOINT, BEFORE, *copies))
        going = _Run(domain, bias, options, judging, output, copies, space, jobs, checkpoint_every)
        if resume:
            going.resume()
        return going.go(report)


class _Run:
    """A run while it goes on."""

    def __init__(
        self,
        domain: Domain,
        bias: LanguageBias,
        options: Common,
        judging: Judging,
        output: Path,
        copies: Mapping[str, bytes],
        space: Space | None,
        jobs: int,
        checkpoint_every: float,
    ):
        self.bias = bias
        self.output = output
        self.copies = copies
        self.settings = settings(domain, bias, options, judging)
        self.learning = learning_of(domain, bias, options, jobs)
        self.progress = Progress(self.learning.policy, options, judging)
        at_once = judging["until_success"] is not None or judging["until_return"] is not None
        beside = 1 if at_once or are_many(options) else jobs
        self.points = partial(Points, self.progress, judging["starts"], space, beside)
        # where several processes learn, time is the clock's, else the processor's, which has other things to do
        self.now = time.perf_counter if jobs > 1 and are_many(options) else time.process_time
        self.clock = self.now()
        self.drawn: Points | None = None
        self.checkpoints = Checkpoints(output, checkpoint_every)
        self.earlier = recorded_hashes(output)
        self.has_begun = False
        self.pending: list[list] = []  # points that a checkpoint was waiting for

    def go(self, report: Callable[[Progress], None]) -> Progress:
        """Learns to the end, and writes the files."""
        progress, judging = self.progress, self.progress.judging
        there = (self.output / "model.pl").exists()
        try:
            if self.pending:
                self.drawn = self.points()
                self.drawn.resume(self.pending)
            self.clock = self.now()
            for iteration in self.learning.iterations(self.is_over):
                self.has_begun = True
                _advance(progress, iteration, self.now() - self.clock)
                if is_due(progress, len(iteration.recent), judging["evaluate_every"]):
                    self.drawn = self.drawn or self.points()
                    self.drawn.draw(progress)
                for point in self.drawn.drawn(wait=progress.is_spent) if self.drawn else ():
                    progress.curve.append(point)  # before others are told, which may end the run
                    if progress.point:
                        report(progress)
                    progress.point = point
                reached = _reached(progress.point, judging["until_success"], judging["until_return"])
                progress.ended = reached or progress.is_spent
                report(progress)
                if progress.ended:
                    break
                progress.point = None
                self.clock = self.now()
        except BaseException as error:
            self._rescue(error, there)
            raise
        finally:
            if self.drawn:
                self.drawn.close()
        self.checkpoints.end()
        progress.written = write_files(progress, self.bias, self.output, self.copies, self.earlier)
        return progress

    def is_over(self) -> bool:
        """Whether the episode was the last one. Where a checkpoint is due, it is written."""
        progress = self.progress
        seconds = progress.seconds + self.now() - self.clock
        over = seconds >= progress.judging.get("seconds", math.inf)
        last = over or self.learning.count == progress.options.episodes  # behind it the files are written anyway
        if last or self.checkpoints.are_due:
            begin = self.now()
            bare = last or self.checkpoints.is_first
            self.checkpoints.keep(self._saved(seconds), (lambda: None) if bare else self._write)
            self.clock += self.now() - begin
        return over

    def _write(self) -> None:
        write_files(self.progress, self.bias, self.output, self.copies, self.earlier, ended=False)

    def _saved(self, seconds: float) -> dict[str, Any]:
        progress = self.progress
        return {
            "settings": self.settings,
            "sources": dict(self.copies),
            "chosen": list(progress.policy.domain.chosen),
            "count": self.learning.count,
            "progress": [getattr(progress, name) for name in _PROGRESS],
            "seconds": seconds,
            "pending": self.drawn.saved() if self.drawn else [],
            "learning": self.learning.saved(),
        }

    def resume(self) -> None:
        """Goes on from the checkpoint in the folder. Raises NppgError."""
        progress = self.progress
        found = checkpoints.last(self.output, self.bias)
        checkpoints.check(found, self.settings)
        checkpoints.tell_versions(found)
        saved = found.run

        def go_on() -> None:
            self.learning.resume(saved["learning"])
            self.pending = saved["pending"]
            for name, value in zip(_PROGRESS, saved["progress"], strict=True):
                setattr(progress, name, value)
            progress.seconds = saved["seconds"]

        checkpoints.resumed(found.path, go_on)
        self.checkpoints.has_good = found.path.name == CHECKPOINT
        domain = progress.policy.domain
        if isinstance(domain, GymDomain) and not domain.comes_back():
            message = "leads elsewhere when it is reset to the same seed, so the run does not go on as it would have"
            warnings.warn(f"{domain.path}: the environment {message}", stacklevel=2)

    def _rescue(self, error: BaseException, there: bool) -> None:
        """Writes what there is, as far as that can be done, when a run ends by force. What cannot be written is told
        by the error itself."""
        interrupted, progress = isinstance(error, KeyboardInterrupt), self.progress
        if not self.has_begun or (there and not interrupted):
            return
        if interrupted and self.learning.is_settled and self.learning.count:
            with suppress(NppgError):
                self.checkpoints.keep(self._saved(progress.seconds + self.now() - self.clock))
        progress.curve.extend(self.drawn.rescued() if self.drawn else ())
        with nullcontext() if interrupted else suppress(NppgError):
            write_files(progress, self.bias, self.output, self.copies, self.earlier)


def judging_of(
    domain: Domain,
    evaluate_every: int | None,
    starts: int | None,
    until_success: float | None = None,
    until_return: float | None = None,
    seconds: float | None = None,
) -> Judging:
    """These arguments of `run`, with what is meant where they are left out."""
    judging: Judging = {
        "evaluate_every": alone((200 if domain.chosen else 50) if evaluate_every is None else evaluate_every),
        "starts": alone(1000 if starts is None and not domain.chosen else starts),
        "until_success": alone(until_success),
        "until_return": alone(until_return),
    }
    return judging if seconds is None else {**judging, "seconds": alone(seconds)}


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
