"""A training run with its files: model.pl, curve.csv, run.json and, with matplotlib, curve.png."""

from __future__ import annotations

import csv
import json
import platform
import tempfile
import time
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path

import numpy as np

from nppg import __version__
from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import replacing
from nppg.bridge.prolog import ask, undisturbed
from nppg.errors import NppgError, Problem
from nppg.experiments.train import train
from nppg.judging.evaluation import Evaluation, ExactEvaluator, evaluate
from nppg.judging.space import Space
from nppg.learning.options import Common
from nppg.learning.training import Iteration
from nppg.policy.copies import conflicts, recorded_hashes, write_copies
from nppg.policy.model import write_model
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain

_FILES = ("model.pl", "run.json", "curve.csv", "curve.png")
_CLASSES = 20_000  # state spaces up to this size are evaluated exactly between the trees
_RECENT = 100  # episodes that `recent` is the mean of


@dataclass(frozen=True, slots=True)
class Point:
    """One point of the learning curve. `success` is the stochastic policy's (exact where `exact` is 1), `recent`
    the share of the last training episodes that reached the goal, or their mean return (see Progress.measure);
    `seconds` leaves evaluation out. The value-function learners' policies are greedy where they are evaluated. `leaves`
    are those of all trees. Returns are undiscounted, of the sampled episodes; none where `exact` is 1."""

    episode: int
    trees: int
    success: float
    seconds: float
    greedy_success: float
    mean_steps: float
    recent: float
    exact: int
    leaves: int
    instances: int
    mean_return: float | None
    greedy_return: float | None


@dataclass
class Progress:
    """What a run has come to; handed to the caller after each tree, with a new `point` where one was made."""

    policy: Policy
    options: Common
    judging: Mapping[str, int | float | None] = field(default_factory=dict)  # run's arguments about the curve
    episodes: int = 0
    seconds: float = 0.0
    outcomes: list[float] = field(default_factory=list)  # of each episode: see `measure`
    curve: list[Point] = field(default_factory=list)
    point: Point | None = None
    evaluator: ExactEvaluator | None = None  # that the last point comes from, where it is exact
    ended: bool = False
    written: list[str] = field(default_factory=list)  # names of the files, at the end

    @property
    def measure(self) -> str:
        """What episodes are judged by: their success; their return in domains without a goal, and where the run is to
        end at one."""
        for_return = self.judging.get("until_return") is not None
        return "success" if self.policy.domain.has_goal and not for_return else "return"

    def judged(self, point: Point) -> tuple[float, float]:
        """The measure of a point's stochastic policy and of its greedy one."""
        if point.mean_return is None or point.greedy_return is None or self.measure == "success":
            return point.success, point.greedy_success
        return point.mean_return, point.greedy_return

    @property
    def recent(self) -> float:
        """Mean over the last episodes: the share that reached the goal, or the return."""
        return sum(self.outcomes[-_RECENT:]) / max(len(self.outcomes[-_RECENT:]), 1)


def run(
    domain: Domain,
    bias: LanguageBias,
    options: Common,
    output: Path,
    evaluate_every: int = 50,
    starts: int = 1000,
    report: Callable[[Progress], None] = lambda progress: None,
    until_success: float | None = None,
    space: Space | None = None,
    until_return: float | None = None,
) -> Progress:
    """Trains and writes the files into the folder `output`.

    Every `evaluate_every` episodes (0: never) the policy is evaluated: exactly where the domain allows it and has
    few classes of states, else on `starts` sampled starts. With `until_success` or `until_return` the run ends at the
    first such point where the stochastic policy reaches it; for a return all points are sampled. `space` is the
    domain's, where the caller has it already. On KeyboardInterrupt the files are written for what has been learned,
    then it is raised again; after a mistake of the domain they are written as far as there was none before, so that
    nothing is lost and nothing overwritten. Raises NppgError, before it starts, where a file that no run wrote stands
    in the way of a copy of the domain or the bias.
    """
    problems = bias.check(domain.predicates, domain.actions)
    problems += conflicts(output, _copies(domain, bias), _FILES).values()
    if problems:
        raise NppgError(problems)
    _make_folder(output)
    judging = {
        "evaluate_every": evaluate_every,
        "starts": starts,
        "until_success": until_success,
        "until_return": until_return,
    }
    progress: Progress | None = None
    try:
        clock = time.perf_counter()
        judge: Callable[[], tuple[Evaluation, Evaluation]] | None = None
        for iteration in train(domain, bias, options):
            progress = progress or Progress(iteration.policy, options, judging)
            _advance(progress, iteration, time.perf_counter() - clock)
            if _is_due(progress, iteration, evaluate_every):
                judge = judge or _judge(progress, starts, space)
                progress.point = _point(progress, *judge())
                progress.curve.append(progress.point)
            reached = _reached(progress.point, until_success, until_return)
            progress.ended = reached or progress.episodes == options.episodes
            report(progress)
            if reached:
                break
            progress.point = None
            clock = time.perf_counter()
    except BaseException as error:
        interrupted = isinstance(error, KeyboardInterrupt)
        if progress and (interrupted or not (output / "model.pl").exists()):
            write_files(progress, bias, output)
        raise
    assert progress is not None
    progress.written = write_files(progress, bias, output)
    return progress


def _make_folder(output: Path) -> None:
    try:
        output.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=output).close()
    except OSError as error:
        raise NppgError([Problem(str(output), 0, 0, f"the folder cannot be written to: {error.strerror}")]) from None


def _reached(point: Point | None, success: float | None, mean_return: float | None) -> bool:
    if point is None:
        return False
    wanted = ((point.success, success), (point.mean_return, mean_return))
    return any(least is not None and value is not None and value >= least for value, least in wanted)


def _advance(progress: Progress, iteration: Iteration, seconds: float) -> None:
    progress.seconds += seconds
    progress.episodes = iteration.episodes
    if progress.measure == "success":
        progress.outcomes += [episode.success for episode in iteration.recent]
    else:
        progress.outcomes += [sum(step.reward for step in episode.steps) for episode in iteration.recent]


def _is_due(progress: Progress, iteration: Iteration, every: int) -> bool:
    if every == 0:
        return False
    last = progress.episodes - len(iteration.recent)
    at_end = progress.episodes == progress.options.episodes
    return not progress.curve or last // every < progress.episodes // every or at_end


def _judge(progress: Progress, starts: int, space: Space | None) -> Callable[[], tuple[Evaluation, Evaluation]]:
    """How the run's policy is evaluated: the stochastic and the greedy one."""
    policy, seed, factor = progress.policy, progress.options.seed, progress.options.horizon_factor
    if policy.domain.is_countable and progress.measure == "success":
        try:
            exact = ExactEvaluator(policy, space or Space(policy.domain, _CLASSES))
        except NppgError:
            pass
        else:

            def exactly() -> tuple[Evaluation, Evaluation]:
                now = progress.evaluator = exact.snapshot()
                return now.evaluate(False, factor), now.evaluate(True, factor)

            return exactly
    return lambda: (
        evaluate(policy, starts, seed, False, factor),
        evaluate(policy, starts, seed, True, factor),
    )


def _point(progress: Progress, stochastic: Evaluation, greedy: Evaluation) -> Point:
    sizes = progress.policy.sizes()
    return Point(
        progress.episodes,
        sizes.get("trees", 0),
        stochastic.success,
        round(progress.seconds, 3),
        greedy.success,
        stochastic.mean_steps,
        progress.recent,
        int(stochastic.exact),
        sizes.get("leaves", 0),
        sizes.get("instances", 0),
        stochastic.mean_return,
        greedy.mean_return,
    )


def _copies(domain: Domain, bias: LanguageBias) -> dict[str, bytes]:
    """The contents of the input files, by name; a bias made in Python has none."""
    copies = {domain.path.name: domain.source}
    return copies | {Path(bias.file).name: bias.source} if bias.source else copies


@undisturbed()
def write_files(progress: Progress, bias: LanguageBias, output: Path) -> list[str]:
    """Writes all files of a run, each under a temporary name first, and removes the curve of an earlier one. Returns
    their names. Raises NppgError at the end where a file has come into the way of a copy since the run began."""
    policy, options = progress.policy, progress.options
    domain = policy.domain
    rerun = bool(recorded_hashes(output))
    copies = _copies(domain, bias)
    problems = conflicts(output, copies, _FILES)
    copies = {name: source for name, source in copies.items() if name not in problems}
    until = any(progress.judging.get(name) is not None for name in ("until_success", "until_return"))
    facts = [
        *([("bias", Path(bias.file).name), ("bias_sha256", bias.hash)] if bias.source else []),
        *(("option", ("=", name, value)) for name, value in asdict(options).items()),
        *(("tree", ("=", name, value)) for name, value in asdict(bias.tree).items()),
        *(("curve", ("=", name, value)) for name, value in progress.judging.items() if until and value is not None),
        ("trained_episodes", progress.episodes),
    ]
    write_copies(output, copies)
    write_model(policy, output / "model.pl", facts)
    summary = {
        "nppg": __version__,
        "prolog": ask("version"),
        "python": platform.python_version(),
        "numpy": np.__version__,
        "domain": {"file": domain.path.name, "sha256": domain.hash, "parameters": domain.parameters},
        "bias": {"file": Path(bias.file).name, "sha256": bias.hash} if bias.source else None,
        "learner": options.learner,
        "options": asdict(options),
        "tree": asdict(bias.tree),
        "curve": dict(progress.judging),
        "episodes": progress.episodes,
        **policy.sizes(),
        "seconds": round(progress.seconds, 3),
        "last": asdict(progress.curve[-1]) if progress.curve else None,
    }
    replacing(output / "run.json", lambda path: path.write_text(json.dumps(summary, indent=2) + "\n"))
    written = [*copies, "model.pl", "run.json"]
    if progress.curve:
        replacing(output / "curve.csv", lambda path: _write_curve(path, progress.curve))
        written += ["curve.csv", "curve.png"] if _draw(progress, output / "curve.png") else ["curve.csv"]
    for name in set(_FILES) - set(written) if rerun else ():
        (output / name).unlink(missing_ok=True)
    if problems:
        raise NppgError(problems.values())
    return sorted(written)


def _write_curve(path: Path, curve: list[Point]) -> None:
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([each.name for each in fields(Point)])
        writer.writerows([getattr(point, each.name) for each in fields(Point)] for point in curve)


def _draw(progress: Progress, path: Path) -> bool:
    """Whether matplotlib is there to draw the curve."""
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(9, 4), layout="constrained")
    episodes = [point.episode for point in progress.curve]
    exact = "exact" if progress.curve[-1].exact else "sampled"
    stochastic, greedy = zip(*map(progress.judged, progress.curve), strict=True)
    axes.plot(episodes, stochastic, label=f"stochastic policy, {exact}")
    axes.plot(episodes, greedy, label=f"greedy policy, {exact}", alpha=0.6)
    played = [point for point in progress.curve if point.episode]
    lately = [point.episode for point in played], [point.recent for point in played]
    axes.plot(*lately, ":", label="recent training episodes", color="grey")
    axes.set(xlabel="episodes", ylabel=progress.measure, title=_title(progress))
    if progress.measure == "success":
        axes.set(ylim=(-0.02, 1.02))
    axes.grid(alpha=0.3)
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
    replacing(path, lambda temporary: figure.savefig(temporary, format="png", dpi=120))
    pyplot.close(figure)
    return True


def _title(progress: Progress) -> str:
    options = progress.options
    return f"{title(progress.policy.domain)}, {options.learner}, seed {options.seed}: {sizes(progress.policy)}"


def sizes(policy: Policy) -> str:
    """What a policy consists of, for people."""
    return "  ".join(f"{name} {number:,}" for name, number in policy.sizes().items())


def title(domain: Domain) -> str:
    """The domain's name with its parameters, for people."""
    parameters = ", ".join(f"{name} = {value}" for name, value in domain.parameters.items())
    return f"{domain.name} ({parameters})" if parameters else domain.name
