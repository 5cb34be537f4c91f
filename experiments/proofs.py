"""What a proof costs among more and more blocks: rules distilled with ten, each proof in a process of its own.

python -m experiments.proofs --write docs/proofs.md
"""

from __future__ import annotations

import argparse
import json
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from benchmarks.common import peak
from nppg import Domain, LanguageBias, Options, Policy, train
from nppg.bridge.files import locate
from nppg.judging.space import Space
from nppg.rules.distill import distill
from nppg.rules.proof import prove

EPISODES = 500
BLOCKS = [6, 8, 10, 11, 12, 13, 14, 16, 18]
PROBLEMS = "\n## On problems\n"  # what follows in the report's file is kept


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--blocks", type=int, nargs="+", default=BLOCKS)
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the report into this file")
    parser.add_argument("--rules", type=Path, metavar="MODEL", help="prove only this, and print figures as JSON")
    chosen = parser.parse_args()
    if chosen.rules:
        print(json.dumps(_figures(chosen.rules, chosen.blocks[0])))
        return
    rows: list[str] = []
    with tempfile.TemporaryDirectory() as folder:
        rules = Path(folder) / "rules.pl"
        count = _distilled(rules)
        before: dict = {}
        for blocks in chosen.blocks:
            command = [sys.executable, "-m", "experiments.proofs", "--rules", str(rules), "--blocks", str(blocks)]
            run = subprocess.run(command, check=True, capture_output=True, text=True)
            figures = json.loads(run.stdout)
            rows.append(_row(figures, before))
            before = figures
            print(rows[-1], flush=True)
    report = _report(chosen, count, rows)
    if chosen.write:
        _, heading, rest = chosen.write.read_text().partition(PROBLEMS) if chosen.write.exists() else ("", "", "")
        chosen.write.write_text(report + heading + rest)
    print(report)


def _distilled(path: Path) -> int:
    """Writes the rules; returns how many there are."""
    bias = LanguageBias.load(locate("blocks_world", "language_bias", ".yaml"))
    *_, last = train(Domain("blocks_world"), bias, Options(EPISODES, step="second-order"))
    rules = distill(last.policy, bias)
    rules.save(path)
    return len(rules.rules(1))


def _figures(rules: Path, blocks: int) -> dict:
    """One proof, and what this process has taken for it from its start on."""
    policy = Policy.load(rules, {"blocks": blocks})
    space = Space(policy.domain)
    proof = prove(policy, rules, space=space)
    return {
        "blocks": blocks,
        "states": proof.states,
        "classes": proof.classes,
        "pairs": len(space.owner),
        "complete": proof.complete,
        "seconds": time.process_time(),
        "megabytes": peak() / 1024,
    }


def _row(figures: dict, before: dict) -> str:
    """With the growth for each block more."""
    growth = ["", ""]
    if before:
        more = figures["blocks"] - before["blocks"]
        growth = [f"{(figures[each] / before[each]) ** (1 / more):.2f}" for each in ("classes", "seconds")]
    cells = [
        f"{figures['blocks']}",
        f"{figures['states']:,}" if figures["states"] < 1e12 else f"{figures['states']:.3g}",
        f"{figures['classes']:,}",
        f"{figures['pairs']:,}",
        "yes" if figures["complete"] else "no",
        f"{figures['seconds']:.1f}",
        f"{figures['megabytes']:.0f}",
        *growth,
    ]
    return "| " + " | ".join(cells) + " |"


def _report(chosen: argparse.Namespace, rules: int, rows: list[str]) -> str:
    blocks = " ".join(map(str, chosen.blocks))
    return "\n".join(
        [
            "# What a proof costs",
            "",
            f"on(A, B): {rules} rules, distilled after {EPISODES} episodes of second-order training with ten blocks;",
            "proven among other numbers of blocks, as `nppg prove rules.pl --set blocks=N` does it. Seconds of one",
            "core and peak memory are those of the whole process. Growth is for each block more.",
            "",
            f"`python -m experiments.proofs --blocks {blocks} --write {chosen.write}`",
            "",
            f"Python {platform.python_version()}, {platform.machine()}.",
            "",
            "| blocks | states | classes | pairs | every start | seconds | MB | growth of classes | of seconds |",
            "|---|---|---|---|---|---|---|---|---|",
            *rows,
            "",
        ]
    )


if __name__ == "__main__":
    main()
