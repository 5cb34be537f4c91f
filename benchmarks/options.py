"""python -m benchmarks options: the options that biases of PDDL domains are written with, and each of them changed, on
worlds that no result is reported on: ten seeds, a few seconds each, judged on larger problems than were learned on."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import product
from pathlib import Path
from statistics import mean
from typing import Any

import yaml

from nppg import Options, evaluate, language_bias_of, open_domain, train
from nppg.bias.language_bias import LanguageBias
from nppg.pddl.bias_text import WAYS
from nppg.rules.judge import in_domain

WORLDS: dict[str, tuple[dict[str, int], dict[str, int]]] = {  # what is learned on, and what is judged on
    "gripper": ({"balls": 4, "vary": 1}, {"balls": 12}),
    "logistics": ({"packages": 2, "vary": 1}, {"packages": 4}),
}
LIBRARY = Path("examples/library")  # learned on its first nine problems, judged on the other three
CHANGES: tuple[dict[str, Any], ...] = (
    {}, {"models": "one"}, {"detours": 0.0}, {"detours": 1.0}, {"replay": 200}, {"regularisation_growth": 0.0},
    {"discount": 0.9}, {"discount": 0.99}, {"floor": 0.0}, {"floor": 0.3},
)  # fmt: skip
_STARTS = 50


def main(arguments: Sequence[str]) -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks options", description=__doc__)
    add = parser.add_argument
    add("--worlds", type=Path, required=True, metavar="FOLDER", help=f"with {', '.join(WORLDS)}, and NAME_derived.yaml")
    add("--seconds", type=float, default=8.0, metavar="S", help="of learning (default: 8)")
    add("--seeds", type=int, default=10, metavar="N", help="seeds from 100 on (default: 10)")
    add("--jobs", type=int, default=1, metavar="N", help="processes (default: 1)")
    options = parser.parse_args(arguments)
    names = [*WORLDS, LIBRARY.name]
    runs = [*product(names, CHANGES, range(100, 100 + options.seeds))]
    with ProcessPoolExecutor(options.jobs, max_tasks_per_child=20) as pool:
        found = [*pool.map(partial(_judged, options.worlds, options.seconds), *zip(*runs, strict=True))]
    print("\n".join(_table(names, [(*run, *each) for run, each in zip(runs, found, strict=True)])))


def _judged(worlds: Path, seconds: float, name: str, changed: dict[str, Any], seed: int) -> tuple[float, float]:
    """The greedy success on larger problems, and the steps, where all of them are solved."""
    larger: Any
    if name in WORLDS:
        small, large = WORLDS[name]
        domain, larger = (open_domain(worlds / f"{name}.pl", each) for each in (small, large))
        bias = LanguageBias.load(worlds / f"{name}_derived.yaml")
    else:
        files = sorted(LIBRARY.glob("p*.pddl"))
        domain = open_domain(LIBRARY / "domain.pddl", problems=files[:9])
        bias, larger = language_bias_of(domain), domain.over(domain.problems_of(files[9:]))
    options = Options(**{**yaml.safe_load(WAYS), **changed, "episodes": 10**6, "seed": seed, "guidance": 0.0})
    until = time.process_time() + seconds
    *_, last = train(domain, bias, options, is_over=lambda: time.process_time() > until)
    result = evaluate(in_domain(last.policy, larger), _STARTS, 0, True)
    return result.success, result.mean_steps if result.success == 1 else 0.0


def _table(names: Sequence[str], found: Sequence[tuple]) -> Iterator[str]:
    yield f"| changed | {' | '.join(names)} |"
    yield "|---" * (1 + len(names)) + "|"
    for changed in CHANGES:
        cells = []
        for name in names:
            own = [(success, steps) for world, change, _, success, steps in found if (world, change) == (name, changed)]
            steps = [each for _, each in own if each]
            more = f", {mean(steps):.1f} steps" if steps else ""
            cells.append(f"{mean(s for s, _ in own):.2f} ({min(s for s, _ in own):.2f}){more}")
        title = ", ".join(f"`{key}` {value}" for key, value in changed.items()) or "nothing"
        yield f"| {title} | {' | '.join(cells)} |"
