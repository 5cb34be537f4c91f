"""The grid world, learned with TILDE and with CART, against its exact optimum.

python -m experiments.grid --output docs/grid.md
"""

from __future__ import annotations

import argparse
import platform
import time
from functools import cache
from itertools import islice
from pathlib import Path
from statistics import mean, pstdev
from typing import NamedTuple

from experiments.common import add_seeds, done, world
from nppg import Options, train
from nppg.judging.evaluation import ExactEvaluator
from nppg.judging.optimum import ReturnEvaluator
from nppg.judging.space import Space

_OPTIONS = {
    "step": "second-order",
    "step_size": 0.5,
    "critic": "value",
    "trace": 0.9,
    "discount": 0.95,
    "min_examples": 2000,
    "episodes": 1500,
}  # the best of a few, on seeds from 100 on


class Run(NamedTuple):
    """What one run has come to: expected returns of the stochastic and the greedy policy, how often the greedy one's
    first action is optimal, and the seconds of learning."""

    stochastic: float
    greedy: float
    agreement: float
    seconds: float


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add_seeds(parser, 5, first=0)
    parser.add_argument("--output", type=Path, required=True)
    chosen = parser.parse_args()
    space, rewards = _judges()
    seeds = range(chosen.first_seed, chosen.first_seed + chosen.seeds)
    rows, regressors = [], ("tilde", "cart")
    options_of_all = [
        Options(**_OPTIONS, regressor=regressor, seed=seed)  # type: ignore[arg-type]
        for regressor in regressors
        for seed in seeds
    ]
    found = done(_learned, options_of_all, chosen.jobs)
    for regressor in regressors:
        own = zip(*islice(found, len(seeds)), strict=True)
        rows.append(f"| {regressor.upper()} | {' | '.join(map(_moments, own))} |")
        print(rows[-1], flush=True)
    options = ", ".join(f"{name} = {value}" for name, value in _OPTIONS.items())
    lines = [
        "# The grid world",
        "",
        f"`python -m experiments.grid --seeds {chosen.seeds} --output {chosen.output}`",
        "",
        f"grid.pl as it is: {space.starts} start states, exact expected returns over all of them. {options}; seeds "
        f"{seeds[0]} to {seeds[-1]}; Python {platform.python_version()}, {platform.machine()}.",
        "",
        f"The optimal policy, which also knows how many steps are left, has the return {rewards.optimal().mean:.4f}.",
        "",
        "| learner | return | return, greedy | first action optimal, greedy | seconds |",
        "|---|---|---|---|---|",
        *rows,
        "",
        "Mean ± standard deviation over the seeds.",
    ]
    chosen.output.write_text("\n".join(lines) + "\n")


@cache
def _judges() -> tuple[Space, ReturnEvaluator]:
    *_, space = world("grid")
    return space, ReturnEvaluator(space)


def _learned(options: Options) -> Run:
    domain, bias, _ = world("grid")
    space, rewards = _judges()
    begin = time.perf_counter()
    *_, last = train(domain, bias, options)
    seconds = time.perf_counter() - begin
    judge = ExactEvaluator(last.policy, space)
    stochastic, greedy = (judge.probabilities(each) for each in (False, True))
    return Run(rewards.of(stochastic).mean, rewards.of(greedy).mean, rewards.agreement(greedy), seconds)


def _moments(values: tuple[float, ...]) -> str:
    return f"{mean(values):.3f} ± {pstdev(values):.3f}"


if __name__ == "__main__":
    main()
