"""The learning curves of several seeds: one CSV, one picture, one summary in Markdown.

python -m experiments.curves blocks_world --seeds 10 --output docs/on_ab
"""

from __future__ import annotations

import argparse
import csv
import platform
import tempfile
from dataclasses import replace
from pathlib import Path
from statistics import mean

import numpy as np

from experiments.common import add_seeds, done
from nppg import Domain, LanguageBias, Options, run
from nppg.bridge.files import locate
from nppg.experiments.progress import Progress, title

_OPTIONS = ("step", "min_examples", "examples_growth", "regularisation_growth", "clip", "replay")
_GRID = 50  # episodes between two points of a mean


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("domain")
    add_seeds(parser, 10)
    parser.add_argument("--episodes", type=int, default=Options().episodes)
    for each in _OPTIONS:
        default = getattr(Options(), each)
        parser.add_argument(f"--{each.replace('_', '-')}", type=type(default), default=default)
    parser.add_argument("--beside", type=Path, metavar="CSV", help="curves of other runs, whose mean is drawn too")
    parser.add_argument("--output", type=Path, required=True)
    chosen = parser.parse_args()
    chosen.output.mkdir(parents=True, exist_ok=True)
    options = Options(chosen.episodes, **{each: getattr(chosen, each) for each in _OPTIONS})
    wanted = [(chosen.domain, replace(options, seed=seed)) for seed in range(chosen.seeds)]
    runs = []
    for progress in done(_learn, wanted, chosen.jobs):
        last = progress.curve[-1]
        success = f"{last.success:.6f}, greedy {last.greedy_success:.6f}"
        print(f"seed {progress.options.seed}: {success}, {last.trees} trees, {last.seconds} s", flush=True)
        runs.append(progress)
    _write_csv(runs, chosen.output / "curves.csv")
    _write_summary(runs, chosen, chosen.output / "README.md")
    _draw(runs, chosen.beside, chosen.output / "curves.png")


def _learn(wanted: tuple[str, Options]) -> Progress:
    name, options = wanted
    domain, bias = Domain(name), LanguageBias.load(locate(name, "language_bias", ".yaml"))
    with tempfile.TemporaryDirectory() as folder:
        return replace(run(domain, bias, options, Path(folder)), evaluator=None)


def _write_csv(runs: list[Progress], path: Path) -> None:
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["seed", "episode", "trees", "success", "greedy_success"])
        for each in runs:
            for point in each.curve:
                row = [
                    each.options.seed,
                    point.episode,
                    point.trees,
                    f"{point.success:.6f}",
                    f"{point.greedy_success:.6f}",
                ]
                writer.writerow(row)


def _write_summary(runs: list[Progress], chosen: argparse.Namespace, path: Path) -> None:
    last = [each.curve[-1] for each in runs]
    rows = [
        f"| {seed} | {point.success:.6f} | {point.greedy_success:.6f} | {point.trees} | {point.seconds:.1f} |"
        for seed, point in enumerate(last)
    ]
    policy = runs[0].policy
    success = [point.success for point in last]
    lines = [
        f"# {policy.domain.name}: {len(runs)} runs",
        "",
        f"`{_command(chosen)}`",
        "",
        f"Domain parameters: {policy.domain.parameters}. Options: {_options(runs[0].options)}.",
        f"{policy.bias.tree}.",
        f"Python {platform.python_version()}, {platform.machine()}; seconds are those of training alone.",
        "",
        f"Success after {chosen.episodes} episodes, of the stochastic policy: mean {mean(success):.4f}, worst "
        f"{min(success):.4f}; trees on average {mean(point.trees for point in last):.0f}; "
        + ("exact, over all start states." if last[0].exact else "on sampled start states."),
        "",
        _first(runs),
        "",
        "![learning curves](curves.png)",
        "",
        "| seed | success | greedy | trees | seconds |",
        "|---|---|---|---|---|",
        *rows,
    ]
    path.write_text("\n".join(lines) + "\n")


def _first(runs: list[Progress]) -> str:
    """When 0.99 was reached, and the lowest success from there on."""
    found = []
    for each in runs:
        later = [point for i, point in enumerate(each.curve) if max(p.success for p in each.curve[: i + 1]) >= 0.99]
        found.append((later[0].episode, min(point.success for point in later)) if later else None)
    reached = [each for each in found if each]
    if not reached:
        return "No run has reached 0.99."
    return (
        f"{len(reached)} of {len(runs)} runs have reached 0.99, after {min(reached)[0]} to {max(reached)[0]} episodes; "
        f"their lowest success from there on is {min(low for _, low in reached):.4f}."
    )


def _command(chosen: argparse.Namespace) -> str:
    words = [f"python -m experiments.curves {chosen.domain} --seeds {chosen.seeds} --episodes {chosen.episodes}"]
    given = [(each, getattr(chosen, each)) for each in _OPTIONS]
    words += [f"--{each.replace('_', '-')} {value}" for each, value in given if value != getattr(Options(), each)]
    words += [f"--beside {chosen.beside}"] if chosen.beside else []
    return " ".join([*words, f"--output {chosen.output}"])


def _options(options: Options) -> str:
    shown = repr(options).removeprefix("Options(").removesuffix(")").split(", ")
    return ", ".join(each for each in shown if not each.startswith("seed="))


def _draw(runs: list[Progress], beside: Path | None, path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8, 4.5), layout="constrained")
    for number, each in enumerate(runs):
        axes.plot(
            [point.episode for point in each.curve],
            [point.success for point in each.curve],
            color="C0",
            alpha=0.35,
            linewidth=1,
            label=None if number else "each run",
        )
    means = _means([[(point.episode, point.success) for point in each.curve] for each in runs])
    axes.plot(*means, color="C0", linewidth=2.5, label=f"mean of {len(runs)} seeds")
    if beside:
        axes.plot(*_means(_read(beside)), color="C1", linewidth=2, label=f"mean of the runs in {beside.parent}")
    axes.axhline(0.99, color="grey", linestyle=":", linewidth=1, label="0.99")
    axes.set(xlabel="episodes", ylabel="success of the stochastic policy", ylim=(-0.02, 1.02))
    axes.set_title(title(runs[0].policy.domain))
    axes.grid(alpha=0.3)
    axes.legend(loc="lower right", frameon=False)
    figure.savefig(path, dpi=110)


def _read(path: Path) -> list[list[tuple[int, float]]]:
    """The curves in a CSV file of this program: the episodes and success of each run."""
    curves: dict[str, list[tuple[int, float]]] = {}
    with path.open() as file:
        for row in csv.DictReader(file):
            curves.setdefault(row["seed"], []).append((int(row["episode"]), float(row["success"])))
    return list(curves.values())


def _means(curves: list[list[tuple[int, float]]]) -> tuple[np.ndarray, np.ndarray]:
    """The grid's episodes, and the mean success there of curves that are straight between their points."""
    grid = np.arange(0, min(curve[-1][0] for curve in curves) + 1, _GRID)
    return grid, np.mean([np.interp(grid, *zip(*curve, strict=True)) for curve in curves], axis=0)


if __name__ == "__main__":
    main()
