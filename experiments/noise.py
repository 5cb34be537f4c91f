"""What is lost by seeing badly: blocks before a camera that errs, at several noise levels.

python -m experiments.noise --output docs/noise
"""

from __future__ import annotations

import argparse
import csv
import platform
import tempfile
from pathlib import Path
from statistics import mean, pstdev

from experiments.common import add_seeds, done
from nppg import Domain, LanguageBias, Options, Policy, evaluate, run
from nppg.bridge.files import locate
from nppg.experiments.progress import Progress

_NOISES = (0.0, 0.1, 0.3)
_OPTIONS = {"step": "second-order", "min_examples": 500}
_STARTS = 2000  # of the last tests


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add_seeds(parser, 5)
    parser.add_argument("--episodes", type=int, default=1000)
    parser.add_argument("--output", type=Path, required=True)
    chosen = parser.parse_args()
    chosen.output.mkdir(parents=True, exist_ok=True)
    wanted = [(noise, seed, chosen.episodes) for noise in _NOISES for seed in range(chosen.seeds)]
    runs: dict[float, list[Progress]] = {noise: [] for noise in _NOISES}
    tested: dict[tuple[float, float], list[float]] = {(noise, under): [] for noise in _NOISES for under in _NOISES}
    for (noise, seed, _), (progress, successes) in zip(wanted, done(_learn, wanted, chosen.jobs), strict=True):
        print(f"noise {noise}, seed {seed}: {progress.curve[-1].success:.3f}, {progress.seconds:.0f} s", flush=True)
        runs[noise].append(progress)
        for under, success in successes.items():
            tested[noise, under].append(success)
    _write_csv(runs, chosen.output / "curves.csv")
    _draw(runs, chosen.output / "curves.png")
    _write_summary(runs, tested, chosen, chosen.output / "README.md")


def _learn(run_of: tuple[float, int, int]) -> tuple[Progress, dict[float, float]]:
    """With this noise, seed and number of episodes; and the success of its model under each noise."""
    noise, seed, episodes = run_of
    domain = Domain("noisy_blocks", {"noise": noise})
    bias = LanguageBias.load(locate("noisy_blocks", "language_bias", ".yaml"))
    options = Options(episodes=episodes, seed=seed, **_OPTIONS)  # type: ignore[arg-type]
    with tempfile.TemporaryDirectory() as folder:
        progress = run(domain, bias, options, Path(folder), 100, 500)
        return progress, {under: _success(Path(folder, "model.pl"), under) for under in _NOISES}


def _success(model: Path, noise: float) -> float:
    """Of the greedy policy, under another noise than it may have learned with."""
    return evaluate(Policy.load(model, {"noise": noise}), _STARTS, greedy=True).success


def _write_csv(runs: dict[float, list[Progress]], path: Path) -> None:
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["noise", "seed", "episode", "trees", "success", "greedy_success"])
        writer.writerows(
            [
                noise,
                each.options.seed,
                point.episode,
                point.trees,
                f"{point.success:.4f}",
                f"{point.greedy_success:.4f}",
            ]
            for noise, own in runs.items()
            for each in own
            for point in each.curve
        )


def _draw(runs: dict[float, list[Progress]], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import numpy as np
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8, 4.5), layout="constrained")
    for number, (noise, own) in enumerate(runs.items()):
        found = np.array([[point.success for point in each.curve] for each in own])
        episodes = [100 * i for i in range(found.shape[1])]
        middle, spread = found.mean(axis=0), found.std(axis=0)
        axes.plot(episodes, middle, color=f"C{number}", label=f"noise {noise:g}")
        axes.fill_between(episodes, middle - spread, middle + spread, color=f"C{number}", alpha=0.15, linewidth=0)
    label = f"success: mean and standard deviation of {len(own)} runs"
    axes.set(xlabel="episodes", ylabel=label, ylim=(-0.02, 1.04))
    axes.grid(alpha=0.3)
    axes.legend(loc="lower right", frameon=False)
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def _write_summary(
    runs: dict[float, list[Progress]],
    tested: dict[tuple[float, float], list[float]],
    chosen: argparse.Namespace,
    path: Path,
) -> None:
    policy = runs[_NOISES[0]][0].policy
    rows = [
        f"| {noise:g} | " + " | ".join(_moments(tested[noise, under]) for under in _NOISES) + " |" for noise in _NOISES
    ]
    losses = ", ".join(
        f"{mean(tested[0.0, 0.0]) - mean(tested[noise, noise]):.3f} at noise {noise:g}" for noise in _NOISES[1:]
    )
    gains = ", ".join(
        f"{mean(tested[noise, noise]) - mean(tested[0.0, noise]):+.3f} at noise {noise:g}" for noise in _NOISES[1:]
    )
    options = ", ".join(f"{name} = {value}" for name, value in _OPTIONS.items())
    lines = [
        "# What is lost by seeing badly",
        "",
        f"`python -m experiments.noise --seeds {chosen.seeds} --episodes {chosen.episodes} --output {chosen.output}`",
        "",
        f"noisy_blocks.pl with {policy.domain.parameters['blocks']} blocks and "
        f"{policy.domain.parameters['slack']} step more than the shortest solution takes; {options}; seeds 0 to "
        f"{chosen.seeds - 1}; Python {platform.python_version()}, {platform.machine()}.",
        "",
        "![learning curves](curves.png)",
        "",
        f"Success of the greedy policy on {_STARTS} sampled starts, mean ± standard deviation over the runs:",
        "",
        "| learned under noise | " + " | ".join(f"tested under {under:g}" for under in _NOISES) + " |",
        "|---" * (len(_NOISES) + 1) + "|",
        *rows,
        "",
        f"The loss against full observation (noise 0 in learning and test): {losses}.",
        f"What learning under the noise of the test gains over learning without noise: {gains}.",
    ]
    path.write_text("\n".join(lines) + "\n")


def _moments(values: list[float]) -> str:
    return f"{mean(values):.3f} ± {pstdev(values):.3f}"


if __name__ == "__main__":
    main()
