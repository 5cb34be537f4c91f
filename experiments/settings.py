"""What the paper leaves open, compared: success after training under other tree limits and readings.

python -m experiments.settings --seeds 10
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from statistics import mean

from nppg import Domain, LanguageBias, Options, train
from nppg.bias.declarations import Mode, TreeLimits
from nppg.bridge.files import locate
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
    parser.add_argument("--seeds", type=int, default=10, help="seeds 0 to N - 1")
    seeds = parser.parse_args().seeds
    domain = Domain("blocks_world")
    shipped = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    space = None
    print(f"| setting | mean success of {seeds} seeds | worst | trees |\n|---|---|---|---|", flush=True)
    for name, limits, options, higher_only in SETTINGS:
        modes = tuple(map(_without_same, shipped.modes)) if higher_only else shipped.modes
        bias = replace(shipped, tree=limits, modes=modes)
        successes, trees = [], []
        for seed in range(seeds):
            *_, last = train(domain, bias, Options(seed=seed, **options))
            judge = ExactEvaluator(last.policy, space)
            space = judge.space
            successes.append(judge.evaluate().success)
            trees.append(len(last.policy.trees))
        print(f"| {name} | {mean(successes):.4f} | {min(successes):.4f} | {mean(trees):.0f} |", flush=True)


def _without_same(mode: Mode) -> Mode:
    args = (
        replace(arg, constants=tuple(each for each in arg.constants if each != "same")) if arg.constants else arg
        for arg in mode.args
    )
    return replace(mode, args=tuple(args))


if __name__ == "__main__":
    main()
