"""Environments of Gymnasium, learned: returns, environment steps and seconds.

python -m experiments.environments --output docs/environments.md
"""

from __future__ import annotations

import argparse
import platform
import time
from dataclasses import dataclass, field, replace
from pathlib import Path

from experiments.common import add_jobs, done
from nppg import Options, Policy, evaluate, language_bias_of, open_domain, train
from nppg.bias.declarations import TreeLimits

_OPTIONS = {
    "regressor": "cart",
    "step": "second-order",
    "step_size": 0.5,
    "importance": 0.0,
    "critic": "value",
    "critic_trees": 2,
    "trace": 0.95,
    "cut_off": "bootstrap",
    "discount": 0.99,
    "normalise": "yes",
    "min_examples": 8000,
    "guidance": 0.0,
    "episodes": 100_000,
}
_EPISODES = 100  # of the last test


@dataclass(frozen=True)
class Task:
    """An environment with what is its own: steps to learn from, options, limits of trees, seeds."""

    id: str
    steps: int
    limits: TreeLimits
    seeds: int = 1
    options: dict = field(default_factory=dict)


TASKS = (
    Task("CartPole-v1", 150_000, TreeLimits(4, 50), seeds=5, options={"min_examples": 4000}),
    Task("Acrobot-v1", 120_000, TreeLimits(4, 50)),
    Task("FrozenLake-v1", 120_000, TreeLimits(5, 20)),
    Task(
        "Taxi-v3",
        300_000,
        TreeLimits(8, 10),
        seeds=3,
        options={"models": "per-action", "min_examples": 20_000, "step_size": 1.0},
    ),
)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--only", nargs="+", metavar="ID", default=[each.id for each in TASKS])
    parser.add_argument("--output", type=Path, required=True)
    add_jobs(parser)
    chosen = parser.parse_args()
    rows = []
    runs = [(task, seed) for task in TASKS if task.id in chosen.only for seed in range(task.seeds)]
    for row in done(_row, runs, chosen.jobs):
        rows.append(row)
        print(row, flush=True)
        chosen.output.write_text("\n".join([*_head(chosen), *rows]) + "\n")


def _row(run: tuple[Task, int]) -> str:
    """With the seed."""
    task, seed = run
    options = Options(**(_OPTIONS | task.options), seed=seed)  # type: ignore[arg-type]
    policy, steps, episodes, seconds = _learned(task, options)
    stochastic, greedy = (evaluate(policy, _EPISODES, seed, greedy).mean_return for greedy in (False, True))
    return (
        f"| {task.id} | {seed} | {stochastic:.1f} | {greedy:.1f} | {steps:,} | {episodes:,} | {seconds:.0f} "
        f"| {len(policy.trees)} |"
    )


def _learned(task: Task, options: Options) -> tuple[Policy, int, int, float]:
    """The policy after so many steps, the steps and episodes that they are, and the seconds."""
    domain = open_domain(f"gym:{task.id}")
    bias = replace(language_bias_of(domain), tree=task.limits)
    begin, steps = time.perf_counter(), 0
    for iteration in train(domain, bias, options):
        steps += sum(len(episode.steps) for episode in iteration.recent)
        if steps >= task.steps:
            break
    return iteration.policy, steps, iteration.episodes, time.perf_counter() - begin


def _head(chosen: argparse.Namespace) -> list[str]:
    import gymnasium

    options = ", ".join(f"{name} = {value}" for name, value in _OPTIONS.items() if name != "episodes")
    own = "; ".join(
        f"{task.id}: max_depth {task.limits.max_depth}, min_leaf {task.limits.min_examples}"
        + "".join(f", {name} {value}" for name, value in task.options.items())
        for task in TASKS
        if task.id in chosen.only
    )
    only = f" --only {' '.join(chosen.only)}" if len(chosen.only) < len(TASKS) else ""
    return [
        "# Environments of Gymnasium",
        "",
        f"`python -m experiments.environments{only} --output {chosen.output}`",
        "",
        f"Mean returns of {_EPISODES} episodes after learning, of the stochastic and of the greedy policy. Options: "
        f"{options}. Trees: {own}. gymnasium {gymnasium.__version__}, Python {platform.python_version()}, "
        f"{platform.machine()}, one core for each run.",
        "",
        "| environment | seed | return | greedy return | environment steps | episodes | seconds of learning | trees |",
        "|---|---|---|---|---|---|---|---|",
    ]


if __name__ == "__main__":
    main()
