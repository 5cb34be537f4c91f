"""The rover with relations and numbers, with either alone: learning curves, in a CSV, a picture and a summary.

python -m experiments.ablation --seeds 10 --output docs/hybrid

A run that the CSV has already is not done again, so an interrupted command can be given once more; for other
settings the CSV has to go first.
"""

from __future__ import annotations

import argparse
import csv
import time
from pathlib import Path
from statistics import mean, pstdev
from typing import NamedTuple

import numpy as np

from experiments.common import add_seeds, done
from nppg import Domain, LanguageBias, Options, evaluate, generate_episode, train
from nppg.bridge.files import locate
from nppg.policy.policy import Policy

DOMAIN = "rover"
BIASES = {"rover": "relations and numbers", "rover_relational": "relations", "rover_numeric": "numbers"}
SETTINGS = {"step": "second-order", "min_examples": 500, "discount": 0.95}  # the best of a few, on seeds from 100 on


class Run(NamedTuple):
    """With which bias and options, and after how many episodes it is tested, on so many starts."""

    bias: str
    options: Options
    marks: list[int]
    starts: int


class Point(NamedTuple):
    """A point of a learning curve, of the stochastic policy on sampled starts; seconds are those of training alone."""

    bias: str
    seed: int
    episode: int
    trees: int
    success: float
    mean_return: float
    seconds: float


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add_seeds(parser, 10, first=0)
    parser.add_argument("--episodes", type=int, default=2000)
    parser.add_argument("--every", type=int, default=200, help="episodes between two points")
    parser.add_argument("--starts", type=int, default=500, help="that each point is tested on, the same for all")
    parser.add_argument("--output", type=Path, required=True)
    chosen = parser.parse_args()
    chosen.output.mkdir(parents=True, exist_ok=True)
    path = chosen.output / "curves.csv"
    points = _read(path)
    seeds = range(chosen.first_seed, chosen.first_seed + chosen.seeds)
    marks = list(range(0, chosen.episodes + 1, chosen.every))
    there = {
        (bias, seed)
        for seed in seeds
        for bias in BIASES
        if {p.episode for p in points if (p.bias, p.seed) == (bias, seed)} >= set(marks)
    }
    points = [p for p in points if (p.bias, p.seed) in there or p.seed not in seeds]
    missing = [
        Run(bias, Options(chosen.episodes, seed, **SETTINGS), marks, chosen.starts)
        for seed in seeds
        for bias in BIASES
        if (bias, seed) not in there
    ]
    for found in done(curve, missing, chosen.jobs):
        points += found
        _write(path, points)
        print(*points[-1], flush=True)
    points = [p for p in points if p.seed in seeds and p.episode in marks]
    (chosen.output / "README.md").write_text(_summary(points, chosen))
    _draw(points, chosen.output / "curves.png")


def curve(run: Run) -> list[Point]:
    """One run, with a point at the first tree after each of so many episodes."""
    bias = LanguageBias.load(locate(run.bias, "language_bias", ".yaml"))
    seconds, clock, waiting = 0.0, time.perf_counter(), list(run.marks)
    points = []
    for iteration in train(Domain(DOMAIN), bias, run.options):
        seconds += time.perf_counter() - clock
        while waiting and iteration.episodes >= waiting[0]:
            found = evaluate(iteration.policy, run.starts)
            trees = len(iteration.policy.trees)
            assert found.mean_return is not None
            mark, place = waiting.pop(0), (run.bias, run.options.seed)
            points.append(Point(*place, mark, trees, found.success, found.mean_return, round(seconds, 1)))
        clock = time.perf_counter()
    return points


def _read(path: Path) -> list[Point]:
    if not path.exists():
        return []
    with path.open() as file:
        return [
            Point(row["bias"], *(int(row[name]) for name in Point._fields[1:4]), *map(float, list(row.values())[4:]))
            for row in csv.DictReader(file)
        ]


def _write(path: Path, points: list[Point]) -> None:
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(Point._fields)
        writer.writerows((*p[:5], f"{p.mean_return:.4f}", p.seconds) for p in sorted(points))


def _expert(starts: int) -> tuple[float, float]:
    """Success and mean return of the domain's expert."""
    policy = Policy(Domain(DOMAIN), LanguageBias.load(locate(DOMAIN, "language_bias", ".yaml")))
    rng = np.random.default_rng(0)
    episodes = [generate_episode(policy, rng, guidance=1.0) for _ in range(starts)]
    returns = [sum(step.reward for step in each.steps) for each in episodes]
    return mean(each.success for each in episodes), mean(returns)


def _summary(points: list[Point], chosen: argparse.Namespace) -> str:
    last = {bias: [p for p in points if (p.bias, p.episode) == (bias, chosen.episodes)] for bias in BIASES}
    success, value = _expert(chosen.starts)
    seeds = f"--seeds {chosen.seeds}" + (f" --first-seed {chosen.first_seed}" if chosen.first_seed else "")
    marks = f"--episodes {chosen.episodes} --every {chosen.every} --starts {chosen.starts}"
    command = f"python -m experiments.ablation {seeds} {marks} --output {chosen.output}"
    rows = [
        f"| {BIASES[bias]} | [{bias}.yaml](../../language_bias/{bias}.yaml) | {_spread([p.success for p in own])} | "
        f"{min(p.success for p in own):.3f} | {_spread([p.mean_return for p in own])} | "
        f"{mean(p.trees for p in own):.0f} | {mean(p.seconds for p in own):.0f} |"
        for bias, own in last.items()
    ]
    return "\n".join(
        [
            "# The rover, with relations and with numbers",
            "",
            "The same learner with three languages in [the rover's domain](../../domains/rover.pl): relations and",
            "numbers, relations without numbers, numbers without relations.",
            "",
            f"`{command}`",
            "",
            f"Options: {', '.join(f'{name} {value}' for name, value in SETTINGS.items())}, as in the biases, so that",
            "`nppg train rover` has them; else the defaults. Success and return of the stochastic policy after",
            f"{chosen.episodes} episodes on {chosen.starts} sampled starts,",
            f"mean ± standard deviation of {chosen.seeds} seeds; seconds are those of training alone.",
            "",
            "| language | bias | success | worst | return | trees | seconds |",
            "|---|---|---|---|---|---|---|",
            *rows,
            f"| the domain's expert | | {success:.3f} | | {value:.3f} | | |",
            "",
            "![learning curves](curves.png)",
            "",
        ]
    )


def _apart(points: list[Point]) -> int:
    """Episodes between two points of a curve."""
    first, second, *_ = sorted({p.episode for p in points})
    return second - first


def _spread(values: list[float]) -> str:
    return f"{mean(values):.3f} ± {pstdev(values):.3f}"


def _draw(points: list[Point], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, both = pyplot.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    for axes, name, label in zip(both, ("success", "mean_return"), ("success", "return"), strict=True):
        for bias, title in BIASES.items():
            marks = sorted({p.episode for p in points if p.bias == bias})
            values = [[getattr(p, name) for p in points if (p.bias, p.episode) == (bias, mark)] for mark in marks]
            means, spreads = np.array([mean(each) for each in values]), np.array([pstdev(each) for each in values])
            axes.plot(marks, means, linewidth=2, label=title)
            axes.fill_between(marks, means - spreads, means + spreads, alpha=0.2)
        axes.set(xlabel="episodes", ylabel=f"{label} of the stochastic policy")
        axes.grid(alpha=0.3)
    both[0].legend(loc="lower right", frameon=False)
    seeds = len({p.seed for p in points})
    figure.suptitle(f"rover: mean and standard deviation of {seeds} seeds, a point every {_apart(points)} episodes")
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    main()
