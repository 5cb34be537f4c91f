"""Second-order steps under other regularisations, weights and replays, compared by exact success.

python -m experiments.second_order --first-seed 10 --seeds 6
"""

from __future__ import annotations

import argparse
from statistics import mean

from benchmarks.common import successes
from nppg import Domain, LanguageBias, Options
from nppg.bridge.files import locate
from nppg.judging.space import Space

MARKS = (100, 200, 300, 500)
SETTINGS: list[tuple[str, dict]] = [
    ("importance 0.5, lambda 0.25 (the defaults)", {}),
    ("importance 1, lambda 1", {"importance": 1.0, "regularisation": 1.0}),
    ("importance 0.5, lambda 1", {"regularisation": 1.0}),
    ("importance 0.5, lambda 0.1", {"regularisation": 0.1}),
    ("importance 0.75", {"importance": 0.75}),
    ("importance 0.25", {"importance": 0.25}),
    ("importance 0", {"importance": 0.0}),
    ("replay of 100 steps", {"replay": 100}),
    (
        "small trees, replay of 20",
        {
            "min_examples": 30,
            "examples_growth": 0.03,
            "regularisation_growth": 0.02,
            "clip": 1.5,
            "replay": 20,
        },
    ),
]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--seeds", type=int, default=10)
    chosen = parser.parse_args()
    domain = Domain("blocks_world")
    bias = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    print("| setting | " + " | ".join(f"{mark}" for mark in MARKS) + f" | worst at {MARKS[-1]} |")
    print("|---" * (len(MARKS) + 2) + "|", flush=True)
    space = Space(domain)
    for name, changes in SETTINGS:
        rows = [
            successes(domain, bias, Options(MARKS[-1], seed, step="second-order", **changes), MARKS, space)
            for seed in range(chosen.first_seed, chosen.first_seed + chosen.seeds)
        ]
        means = " | ".join(f"{mean(column):.3f}" for column in zip(*rows, strict=True))
        print(f"| {name} | {means} | {min(row[-1] for row in rows):.3f} |", flush=True)


if __name__ == "__main__":
    main()
