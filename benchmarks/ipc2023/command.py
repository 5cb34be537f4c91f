"""python -m benchmarks ipc2023."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from benchmarks.ipc2023 import lama
from benchmarks.ipc2023.results import Results
from benchmarks.ipc2023.tasks import DOMAINS

PARTS = (lama.PART,)


def main(arguments: Sequence[str]) -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks ipc2023", description=__doc__)
    parser.add_argument("--data", type=Path, required=True, metavar="FOLDER", help="NAME/domain.pddl, reference.json")
    parser.add_argument("--output", type=Path, default=Path("runs/ipc2023"), metavar="FOLDER", help="(default: %(default)s)")
    parser.add_argument("--parts", type=_names(PARTS), default=PARTS, help=f"of {','.join(PARTS)} (default: all)")
    parser.add_argument("--domains", type=_names(DOMAINS), default=DOMAINS, help="(default: all)")
    parser.add_argument("--problems", type=int, metavar="N", help="the first N of each level (default: all)")
    parser.add_argument("--seconds", type=int, default=60, help="for a problem, of processor time (default: 60)")
    parser.add_argument("--gigabytes", type=int, default=8, help="for a problem (default: 8)")
    parser.add_argument(
        "--give-up", type=int, default=5, metavar="N", help="LAMA: after N unsolved problems of a level (default: 5)"
    )
    options = parser.parse_args(arguments)
    results = Results(options.output)
    for domain in options.domains:
        if lama.PART in options.parts:
            lama.plan_all(
                options.data, domain, results, options.seconds, options.gigabytes, options.give_up, options.problems
            )


def _names(known: Sequence[str]):
    def read(text: str) -> list[str]:
        names = text.split(",")
        if wrong := set(names) - set(known):
            raise argparse.ArgumentTypeError(f"there is no {', '.join(sorted(wrong))}: {', '.join(known)}")
        return names

    return read
