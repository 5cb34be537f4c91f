"""What the paper leaves open, compared: success after training under other tree limits and readings.

python -m experiments.settings --seeds 10
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from itertools import islice
from statistics import mean

from experiments.common import add_seeds, done, world
from nppg import Options, train
from nppg.bias.declarations import Mode, TreeLimits
from nppg.judging.evaluation import ExactEvaluator

CHOSEN = TreeLimits(max_depth=4, min_examples=1, min_variance=1e-9)
SETTINGS: list[tuple[str, TreeLimits, dict, bool]] = [
    ("as shipped", CHOSEN, {}, False),
    ("at least 2 examples in a leaf", replace(CHOSEN, min_examples=2), {}, False),
    ("stops at a variance of 1e-6", replace(CHOSEN, min_variance=1e-6), {}, False),
    ("depth 3", replace(CHOSEN, max_depth=3), {}, False),
    ("depth 8", replace(CHOSEN, max_depth=8), {}, False),
    ("compheight only `higher`", CHOSEN, {}, True),
    ("steps with return 0 give no examples", CHOSEN, {"unrewarded": "drop"}, False),
]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add_seeds(parser, 10)
    chosen = parser.parse_args()
    seeds = chosen.seeds
    found = done(_learned, [(number, seed) for number in range(len(SETTINGS)) for seed in range(seeds)], chosen.jobs)
    print(f"| setting | mean success of {seeds} seeds | worst | trees |\n|---|---|---|---|", flush=True)
    for name, *_ in SETTINGS:
        successes, trees = zip(*islice(found, seeds), strict=True)
        print(f"| {name} | {mean(successes):.4f} | {min(successes):.4f} | {mean(trees):.0f} |", flush=True)


def _learned(run: tuple[int, int]) -> tuple[float, int]:
    """With the setting of this number and this seed: the exact success, and how many trees there are."""
    number, seed = run
    _, limits, options, higher_only = SETTINGS[number]
    domain, shipped, space = world("blocks_world")
    modes = tuple(map(_without_same, shipped.modes)) if higher_only else shipped.modes
    *_, last = train(domain, replace(shipped, tree=limits, modes=modes), Options(seed=seed, **options))
    return ExactEvaluator(last.policy, space).evaluate().success, len(last.policy.trees)


def _without_same(mode: Mode) -> Mode:
    args = (
        replace(arg, constants=tuple(each for each in arg.constants if each != "same")) if arg.constants else arg
        for arg in mode.args
    )
    return replace(mode, args=tuple(args))


if __name__ == "__main__":
    main()
