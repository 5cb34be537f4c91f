"""python -m benchmarks ipc2023."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path

from benchmarks.ipc2023 import lama, page, policies, zoo
from benchmarks.ipc2023.results import Results
from benchmarks.ipc2023.tasks import DOMAINS, Setting

PARTS = (policies.LEARN, *policies.MODELS, lama.PART)


def main(arguments: Sequence[str]) -> None:
    """Does what has no result yet."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks ipc2023",
        description="Learns the competition's domains and judges policies, rules and LAMA on its testing problems. "
        "What has a result is not done again. Times are of the processor.",
    )
    add = parser.add_argument
    add("--data", type=Path, required=True, metavar="FOLDER", help="the competition's files")
    add("--output", type=Path, default=Path("runs/ipc2023"), metavar="FOLDER", help="results (default: %(default)s)")
    add("--parts", type=_names(PARTS), metavar="NAMES", help=f"(default: {','.join(PARTS)})")
    add("--domains", type=_names(DOMAINS), default=DOMAINS, metavar="NAMES", help="(default: all, in this order)")
    add("--seeds", type=_seeds, default=[0], metavar="NUMBERS", help="(default: 0)")
    add("--problems", type=int, metavar="N", help="the first N of each level (default: all)")
    add("--learn-seconds", type=int, default=900, metavar="S", help="for a domain (default: 900)")
    add("--distill-seconds", type=int, default=120, metavar="S", help="for its rules, about (default: 120)")
    add("--seconds", type=int, default=60, metavar="S", help="for a problem (default: 60)")
    add("--gigabytes", type=int, default=8, metavar="N", help="for a problem (default: 8)")
    add("--give-up", type=int, default=5, metavar="N", help="after N unsolved ones in a row (default: 5)")
    add("--table", action="store_true", help=f"put results into {page.FOLDER}, and do nothing else but --parts")
    add("--zoo", action="store_true", help=f"put the first seed's models into {zoo.FOLDER}, likewise")
    options = parser.parse_args(arguments)
    parts = options.parts or (() if options.table or options.zoo else PARTS)
    setting = Setting(
        options.data,
        Results(options.output),
        options.seconds,
        options.gigabytes,
        options.learn_seconds,
        options.distill_seconds,
        options.give_up,
        options.problems,
    )
    for domain in options.domains:
        for seed in options.seeds:
            if policies.LEARN in parts:
                policies.learn(setting, domain, seed)
            if "rules" in parts:
                policies.distill(setting, domain, seed)
            for part in (part for part in policies.MODELS if part in parts):
                policies.act(setting, part, domain, seed)
        if lama.PART in parts:
            lama.plan_all(setting, domain)
    if options.table:
        page.write(setting.data, setting.results)
    if options.zoo:
        zoo.write(setting, options.seeds[0], options.domains)


def _names(known: Sequence[str]) -> Callable[[str], list[str]]:
    def read(text: str) -> list[str]:
        names = text.split(",")
        if wrong := set(names) - set(known):
            raise argparse.ArgumentTypeError(f"there is no {', '.join(sorted(wrong))}: {', '.join(known)}")
        return names

    return read


def _seeds(text: str) -> list[int]:
    return [int(each) for each in text.split(",")]
