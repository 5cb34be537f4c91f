"""Policies learned with few blocks, held against many: rules distilled after second-order training.

python -m benchmarks.sizes --write docs/sizes.md
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

from nppg import Domain, LanguageBias, Options, evaluate, train
from nppg.coverage import TestTable
from nppg.distill import distill
from nppg.policy import Policy
from nppg.shipped import locate

LEARNED = (4, 5, 6, 8, 10)
TESTED = (10, 20, 50, 100)
TIMED = 50


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--starts", type=int, default=1000)
    parser.add_argument("--episodes", type=int, default=500)
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the report into this file")
    chosen = parser.parse_args()
    bias = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    lines = ["| learned with | rules | " + " | ".join(f"{n} blocks" for n in TESTED) + " |"]
    lines.append("|---" * (2 + len(TESTED)) + "|")
    seconds: dict[tuple[str, int], float] = {}
    for blocks in LEARNED:
        *_, last = train(
            Domain("blocks_world", {"blocks": blocks}), bias, Options(chosen.episodes, step="second-order")
        )
        rules = distill(last.policy, bias)
        successes = [_success(rules, n, chosen.starts, seconds, "rules") for n in TESTED]
        lines.append(f"| {blocks} blocks | {len(rules.rules(1))} | " + " | ".join(successes) + " |")
        print(lines[-1], flush=True)
    success = _success(last.policy, TIMED, chosen.starts, seconds, "ensemble")
    lines += [
        "",
        f"{TIMED} blocks, learned with {LEARNED[-1]}: the rules take {seconds['rules', TIMED]:.0f} s, the ensemble of "
        f"{len(last.policy.trees)} trees that they were distilled from {seconds['ensemble', TIMED]:.0f} s, "
        f"with a success of {success}.",
    ]
    if chosen.write:
        chosen.write.write_text(_report(chosen, lines))
    print("\n".join(lines))


def _success(policy: Policy, blocks: int, starts: int, seconds: dict, kind: str) -> str:
    """The greedy success of the same trees among other numbers of blocks."""
    domain = Domain("blocks_world", {"blocks": blocks})
    other = Policy(domain, policy.bias, TestTable(domain, policy.bias))
    for tree in policy.trees:
        other.add(tree)
    clock = time.perf_counter()
    success = evaluate(other, starts, seed=0, greedy=True).success
    seconds[kind, blocks] = time.perf_counter() - clock
    return f"{success:.3f}"


def _report(chosen: argparse.Namespace, lines: list[str]) -> str:
    return "\n".join(
        [
            "# Other numbers of blocks",
            "",
            f"on(A, B): {chosen.episodes} episodes of second-order training with seed 0, distilled; then the greedy",
            f"success on {chosen.starts} sampled start states, the same for every row.",
            "",
            f"`python -m benchmarks.sizes --episodes {chosen.episodes} --starts {chosen.starts} "
            f"--write {chosen.write}`",
            "",
            *lines,
            "",
        ]
    )


if __name__ == "__main__":
    main()
