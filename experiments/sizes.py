"""Policies learned with few blocks, held against many: second-order training, then distilled.

python -m experiments.sizes --write docs/sizes.md
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

from nppg import Domain, LanguageBias, Options, evaluate, train
from nppg.answers.table import TestTable
from nppg.bridge.files import locate
from nppg.policy.policy import Policy
from nppg.rules.distill import distill

LEARNED = (4, 5, 6, 8, 10)
TESTED = (10, 20, 50, 100)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--starts", type=int, default=1000)
    parser.add_argument("--episodes", type=int, default=500)
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the report into this file")
    chosen = parser.parse_args()
    bias = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    rows: list[str] = []
    for blocks in LEARNED:
        options = Options(chosen.episodes, step="second-order")
        *_, last = train(Domain("blocks_world", {"blocks": blocks}), bias, options)
        rules = distill(last.policy, bias)
        kinds = ((rules, f"{len(rules.rules(1))} rules"), (last.policy, f"{len(last.policy.trees)} trees"))
        seconds = []
        for policy, name in kinds:
            cells = [_cell(policy, n, chosen.starts) for n in TESTED]
            rows.append(_row(f"{blocks} blocks", name, *(f"{success:.3f}" for _, success in cells)))
            seconds.append(_row("seconds", name, *(f"{each:.0f}" for each, _ in cells)))
            print(rows[-1], seconds[-1], flush=True)
    report = _report(chosen, [*rows, *seconds])
    if chosen.write:
        chosen.write.write_text(report)
    print(report)


def _cell(policy: Policy, blocks: int, starts: int) -> tuple[float, float]:
    """The processor's seconds, and the greedy success of the same trees among another number of blocks."""
    domain = Domain("blocks_world", {"blocks": blocks})
    other = Policy(domain, policy.bias, TestTable(domain, policy.bias))
    for tree in policy.trees:
        other.add(tree)
    before = time.process_time()
    success = evaluate(other, starts, seed=0, greedy=True).success
    return time.process_time() - before, success


def _row(*cells: str) -> str:
    return "| " + " | ".join(cells) + " |"


def _report(chosen: argparse.Namespace, rows: list[str]) -> str:
    return "\n".join(
        [
            "# Other numbers of blocks",
            "",
            f"on(A, B): {chosen.episodes} episodes of second-order training with seed 0, and the rules distilled from",
            f"the trees; then the greedy success of both on {chosen.starts} sampled starts, the same in all rows.",
            "The last two rows are the seconds of one core that those of ten blocks took.",
            "",
            f"`python -m experiments.sizes --episodes {chosen.episodes} --starts {chosen.starts} "
            f"--write {chosen.write}`",
            "",
            _row("learned with", "policy", *(f"{n} blocks" for n in TESTED)),
            "|---" * (2 + len(TESTED)) + "|",
            *rows,
            "",
        ]
    )


if __name__ == "__main__":
    main()
