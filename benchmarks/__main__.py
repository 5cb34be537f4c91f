"""Prints the tables of docs/performance.md.

python -m benchmarks [NAME...] [--write docs/performance.md]     NAME: see --help
python -m benchmarks profile [--write docs/performance.md]       where the time of a training run of each learner goes
python -m benchmarks ipc2023 ...                                 the planning competition: docs/ipc2023
python -m benchmarks options ...                                 the options of biases of PDDL domains, each changed
"""

from __future__ import annotations

import argparse
import os
import platform
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

from benchmarks.common import Row, splice

TABLES = {  # by their markers in the file
    "table": ("refinement", "coverage", "one_tree", "potentials", "training", "learners"),
    "competition": ("competition",),
    "growth": ("growth",),
    "large": ("large_states",),
    "tilde": ("tilde",),
}
COMMANDS = {"ipc2023": "benchmarks.ipc2023.command", "options": "benchmarks.options"}  # with arguments of their own
NAMES = [name for names in TABLES.values() for name in names]
HEAD = "| what | measured | against | target | met |\n|---|---|---|---|---|"


def main() -> None:
    if command := COMMANDS.get("".join(sys.argv[1:2])):
        return import_module(command).main(sys.argv[2:])
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks", description="The speed tables of docs/performance.md."
    )
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"{', '.join(NAMES)} (the default), or profile")
    parser.add_argument("--write", type=Path, metavar="FILE", help="also put it between the markers in FILE")
    chosen = parser.parse_args()
    if wrong := set(chosen.names) - {*NAMES, "profile"}:
        parser.error(f"there is no benchmark {', '.join(sorted(wrong))}")
    names = [each for each in chosen.names if each != "profile"] or ([] if chosen.names else NAMES)
    for marker, all_names in TABLES.items():
        if own := [name for name in all_names if name in names]:
            lines = [machine(), "", *HEAD.split("\n")]
            print("\n".join(lines), flush=True)
            for row in (row for name in own for row in import_module(f"benchmarks.{name}").rows()):
                lines.append(line(row))
                print(lines[-1], flush=True)
            splice(chosen.write, marker, "\n".join(lines))
    if "profile" in chosen.names:
        text = import_module("benchmarks.profile").tables()
        print(text)
        splice(chosen.write, "profile", text)


def line(row: Row) -> str:
    met = {True: "yes", False: "NO", None: ""}[row.met]
    return f"| {row.what} | {row.measured} | {row.compared} | {row.target} | {met} |"


def machine() -> str:
    from nppg.bridge.prolog import ask

    return (
        f"{_processor()}, {os.cpu_count()} cores; {platform.system()}, Python {platform.python_version()}, "
        f"SWI-Prolog {ask('version')}."
    )


def _processor() -> str:
    """The processor's model, where the system tells it."""

    def models() -> Iterator[str]:
        for each in Path("/proc/cpuinfo").read_text().splitlines() if Path("/proc/cpuinfo").exists() else ():
            if each.startswith("model name"):
                yield each.split(":", 1)[1].strip()

    return next(models(), platform.processor() or platform.machine())


if __name__ == "__main__":
    main()
