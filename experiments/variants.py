"""The paper's variants, and what goes beyond them, on blocks world and corridor: a table in Markdown.

python -m experiments.variants --output docs/variants.md
"""

from __future__ import annotations

import argparse
import platform
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import islice
from pathlib import Path
from statistics import mean, pstdev

import numpy as np

from experiments.common import add_seeds, done
from nppg import Domain, LanguageBias, Options, Policy, evaluate_exactly, train
from nppg.bridge.files import locate
from nppg.experiments.corridor import Corridor


@dataclass(frozen=True)
class World:
    """Where the variants are compared, with the options that they change, and what is measured in the end."""

    domain: str
    parameters: dict[str, int]
    options: dict
    measure: Callable[[Policy], float]
    what: str


@cache
def _cells(domain: Domain) -> Corridor:
    return Corridor(domain, 200)


def _corridor_return(policy: Policy) -> float:
    cells = _cells(policy.domain)
    right = [policy.distribution((("pos", x),), ["left", "right"])[1] for x in cells.centres.tolist()]
    return float(cells.values(np.array(right)).mean())


WORLDS = (
    World(
        "blocks_world",
        {"blocks": 5},
        {"episodes": 600},
        lambda policy: evaluate_exactly(policy).success,
        "exact success of the stochastic policy over all starts",
    ),
    World(
        "corridor",
        {},
        {"episodes": 600, "step_size": 0.7, "episodes_per_iteration": 30, "min_examples": 0, "guidance": 0.0},
        _corridor_return,
        "expected return of the stochastic policy from uniform starts",
    ),
)
VARIANTS: dict[str, dict] = {
    "the paper's: one model, all actions, fixed step, Monte Carlo returns": {},
    "a regression model for each action (`--models per-action`)": {"models": "per-action"},
    "only the action taken, divided by its probability (`--update taken`)": {"update": "taken"},
    "line search (`--line-search 3`)": {"line_search": 3},
    "actor-critic (`--critic value`)": {"critic": "value"},
    "actor-critic, `--trace 0.9`": {"critic": "value", "trace": 0.9},
    "without guidance (`--guidance 0`)": {"guidance": 0.0},
    "gradient of the expected return (`--importance 0`)": {"importance": 0.0},
    "gradient of the expected return, actor-critic": {"importance": 0.0, "critic": "value"},
    "second-order steps (`--step second-order`)": {"step": "second-order"},
    "second-order steps, actor-critic": {"step": "second-order", "critic": "value"},
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add_seeds(parser, 10)
    parser.add_argument("--output", type=Path, required=True)
    chosen = parser.parse_args()
    begin = time.perf_counter()
    runs = [(name, number, seed) for name in VARIANTS for number in range(len(WORLDS)) for seed in range(chosen.seeds)]
    all_found = done(_measured, runs, chosen.jobs)
    rows = []
    for name in VARIANTS:
        cells = []
        for _ in WORLDS:
            found = list(islice(all_found, chosen.seeds))
            cells.append(f"{mean(found):.3f} ± {pstdev(found):.3f}, worst {min(found):.3f}")
        rows.append(f"| {name} | {' | '.join(cells)} |")
        print(rows[-1], flush=True)
    chosen.output.write_text("\n".join([*_head(chosen, time.perf_counter() - begin), *rows]) + "\n")


@cache
def _loaded(number: int) -> tuple[Domain, LanguageBias]:
    each = WORLDS[number]
    return Domain(each.domain, each.parameters), LanguageBias.load(locate(each.domain, "language_bias", ".yaml"))


def _measured(run: tuple[str, int, int]) -> float:
    """Of the variant of this name, in the world of this number, with this seed."""
    name, number, seed = run
    *_, last = train(*_loaded(number), Options(**(WORLDS[number].options | VARIANTS[name]), seed=seed))
    return WORLDS[number].measure(last.policy)


def _head(chosen: argparse.Namespace, seconds: float) -> list[str]:
    worlds = [
        f"* {world.domain} ({_settings(world.parameters) or 'as it is'}; {_settings(world.options)}): {world.what}."
        for world in WORLDS
    ]
    return [
        "# The paper's variants",
        "",
        f"`python -m experiments.variants --seeds {chosen.seeds} --output {chosen.output}`",
        "",
        f"Seeds 0 to {chosen.seeds - 1}; mean ± standard deviation over the seeds. Python {platform.python_version()}, "
        f"{platform.machine()}, {seconds / 60:.0f} minutes.",
        "",
        *worlds,
        "",
        f"| variant | {' | '.join(world.domain for world in WORLDS)} |",
        "|---" * (len(WORLDS) + 1) + "|",
    ]


def _settings(named: dict) -> str:
    return ", ".join(f"{name} = {value}" for name, value in named.items())


if __name__ == "__main__":
    main()
