"""Few rules from many runs: second-order training on on(A, B) with several seeds, each run distilled and counted.

python -m experiments.distilled --write docs/distilled.md
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

from benchmarks.common import timed
from experiments.common import add_seeds, done, world
from nppg import Options, train
from nppg.judging.evaluation import ExactEvaluator
from nppg.policy.policy import Policy
from nppg.rules.distill import distill

RULES = 10


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add_seeds(parser, 10)
    parser.add_argument("--episodes", type=int, default=500)
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the report into this file")
    chosen = parser.parse_args()
    rows: list[str] = []
    kept = 0
    runs = [Options(chosen.episodes, seed, step="second-order") for seed in range(chosen.seeds)]
    for row, is_kept in done(_distilled, runs, chosen.jobs):
        kept += is_kept
        rows.append(row)
        print(row, flush=True)
    *_, space = world("blocks_world")
    report = _report(chosen, rows, kept, space.starts)
    if chosen.write:
        chosen.write.write_text(report)
    print(report)


def _distilled(options: Options) -> tuple[str, bool]:
    """A row, and whether it has few rules that succeed from every start."""
    domain, bias, space = world("blocks_world")
    learning, last = timed(lambda: _last(train(domain, bias, options)))
    distilling, rules = timed(lambda: distill(last, bias, RULES))
    before, after = ExactEvaluator(last, space), ExactEvaluator(rules, space)
    count, every = len(rules.rules(1)), bool(after.certain(greedy=True)[space.running].all())
    success = f"{after.evaluate(greedy=True).success:.6f}" + (", every start" if every else "")
    row = (
        f"| {options.seed} | {len(last.trees)} | {before.evaluate().success:.6f} | "
        f"{before.evaluate(greedy=True).success:.6f} | {count} | {success} | {learning:.1f} | {distilling:.1f} |"
    )
    return row, every and count <= RULES


def _last(iterations: Iterator) -> Policy:
    *_, last = iterations
    return last.policy


def _report(chosen: argparse.Namespace, rows: list[str], kept: int, starts: int) -> str:
    options = f"--seeds {chosen.seeds} --episodes {chosen.episodes} --write {chosen.write}"
    return "\n".join(
        [
            "# Few rules from every run",
            "",
            f"on(A, B) among ten blocks: {chosen.episodes} episodes of second-order training, then `nppg distill`. All",
            f"successes are exact, over all {starts:,} start states. 'Every start': no course from any of them misses",
            "the goal, which is decided without probabilities. The seconds of distilling include those of listing the",
            "classes of states.",
            "",
            f"`python -m experiments.distilled {options}`",
            "",
            "| seed | trees | success | greedy | rules | success of the rules, greedy | training, s | distilling, s |",
            "|---|---|---|---|---|---|---|---|",
            *rows,
            "",
            f"{kept} of {len(rows)} runs give at most {RULES} rules that succeed from every start.",
            "",
        ]
    )


if __name__ == "__main__":
    main()
