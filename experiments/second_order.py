"""Second-order steps under other regularisations, weights and replays, compared by exact success.

python -m experiments.second_order --first-seed 10 --seeds 6
"""

from __future__ import annotations

import argparse
from itertools import islice
from statistics import mean

from experiments.common import add_seeds, done, successes
from nppg import Options

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
    add_seeds(parser, 10, first=0)
    chosen = parser.parse_args()
    seeds = range(chosen.first_seed, chosen.first_seed + chosen.seeds)
    options = [Options(MARKS[-1], seed, step="second-order", **changes) for _, changes in SETTINGS for seed in seeds]
    found = done(successes, [(each, MARKS) for each in options], chosen.jobs)
    print("| setting | " + " | ".join(f"{mark}" for mark in MARKS) + f" | worst at {MARKS[-1]} |")
    print("|---" * (len(MARKS) + 2) + "|", flush=True)
    for name, _ in SETTINGS:
        rows = list(islice(found, len(seeds)))
        means = " | ".join(f"{mean(column):.3f}" for column in zip(*rows, strict=True))
        print(f"| {name} | {means} | {min(row[-1] for row in rows):.3f} |", flush=True)


if __name__ == "__main__":
    main()
