"""The value-function learners under other options, compared by exact success: the search behind their defaults.

python -m experiments.baselines tg --first-seed 100 --seeds 5
"""

from __future__ import annotations

import argparse
from itertools import islice
from statistics import mean, pstdev

from experiments.common import add_seeds, done, successes
from nppg.experiments.learners import LEARNERS

MARKS = (500, 1000, 1500, 2000)
EXPLORATION: list[dict] = [
    {},
    {"discount": 0.8},
    {"discount": 0.95},
    {"guidance": 0.0},
    {"guidance": 0.2},
    {"exploration": "epsilon-greedy"},
    {"exploration": "epsilon-greedy", "epsilon": 0.3},
    {"cooling": 0.999},
    {"min_temperature": 0.003},
    {"min_temperature": 0.03},
    {"min_temperature": 0.1},
]
OWN: dict[str, list[dict]] = {
    "tg": [{"min_sample": 50}, {"min_sample": 100}, {"min_sample": 400}, {"significance": 0.01}, {"max_depth": 6}],
    "rib": [
        {"mismatch": 5.0},
        {"mismatch": 20.0},
        {"local_deviation": 0.5, "global_deviation": 0.1},
        {"max_instances": 1500},
        {"max_instances": 1500, "mismatch": 20.0},
        {"removal": "maximum-variance"},
        {"power": 3.0, "mismatch": 3.0},
        {"power": 3.0, "mismatch": 3.0, "max_instances": 1500},
    ],
    "trendi": [
        {"mismatch": 5.0},
        {"max_instances": 50},
        {"max_instances": 100},
        {"max_instances": 100, "mismatch": 5.0},
        {"max_instances": 100, "min_sample": 100},
        {"max_instances": 100, "significance": 0.01},
        {"power": 3.0, "mismatch": 3.0},
    ],
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("learner", choices=OWN)
    add_seeds(parser, 5, first=100)
    parser.add_argument("--own", action="store_true", help="leave out the options of the exploration")
    chosen = parser.parse_args()
    tried = ({}, *OWN[chosen.learner]) if chosen.own else (*EXPLORATION, *OWN[chosen.learner])
    seeds, kind = range(chosen.first_seed, chosen.first_seed + chosen.seeds), LEARNERS[chosen.learner]
    runs = [(kind(episodes=MARKS[-1], seed=seed, **changes), MARKS) for changes in tried for seed in seeds]
    found = done(successes, runs, chosen.jobs)
    print("| options | " + " | ".join(map(str, MARKS)) + f" | sd at {MARKS[-1]} |")
    print("|---" * (len(MARKS) + 2) + "|", flush=True)
    for changes in tried:
        rows = list(islice(found, len(seeds)))
        means = " | ".join(f"{mean(column):.3f}" for column in zip(*rows, strict=True))
        name = ", ".join(f"{key} {value}" for key, value in changes.items()) or "the defaults"
        print(f"| {name} | {means} | {pstdev(row[-1] for row in rows):.3f} |", flush=True)


if __name__ == "__main__":
    main()
