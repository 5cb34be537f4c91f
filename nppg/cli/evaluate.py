"""nppg evaluate."""

from __future__ import annotations

import argparse
import csv
import json
import math
import sys
from collections.abc import Sequence
from dataclasses import asdict

from nppg.cli import loading
from nppg.cli.arguments import (
    add_acting,
    add_model,
    add_parameters,
    add_problems,
    add_search,
    add_seconds,
    checked_search,
    checked_seconds,
)
from nppg.errors import NppgError
from nppg.judging.evaluation import evaluate, evaluate_exactly, merit
from nppg.judging.levin import BUDGET, searched
from nppg.judging.problems import Attempt, attempts
from nppg.policy.policy import Policy

_COLUMNS = ("problem", "name", "ended", "steps", "cost", "seconds")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, and over which start states."""
    add_model(parser)
    add_parameters(parser)
    add_problems(parser)
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--exact", action="store_true", help="over all start states")
    how.add_argument("--starts", type=int, default=1000, help="number of sampled starts (default: 1000)")
    chooses = parser.add_mutually_exclusive_group()
    chooses.add_argument(
        "--greedy", action="store_true", help="take the most probable action; on problems this is the default"
    )
    chooses.add_argument("--stochastic", action="store_true", help="draw actions by their probabilities")
    add_acting(parser)
    add_seconds(parser, "of acting or searching, after which a problem is not solved")
    add_search(parser)
    parser.add_argument("--seed", type=int, default=0, help="of the sampled starts, and of what is drawn (default: 0)")
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="print one JSON object")
    form.add_argument("--csv", action="store_true", help="print a table of the problems")


def run(options: argparse.Namespace) -> int:
    """Prints the success, or the return where there is no goal; of problems each one's end. Raises NppgError."""
    searches, seconds = checked_search(options), checked_seconds(options)
    policy = loading.policy(options)
    if options.problems:
        _on_problems(options, policy, searches, seconds)
        return 0
    for name in ("csv", "no_revisits", "seconds", "search"):
        if getattr(options, name):
            raise NppgError(f"--{name.replace('_', '-')} is for problems: name them by --problems")
    factor = loading.factor(options, policy)
    if options.exact:
        result = evaluate_exactly(policy, options.greedy, factor)
    else:
        result = evaluate(policy, options.starts, options.seed, options.greedy, factor)
    if options.json:
        print(json.dumps(asdict(result)))
    else:
        kind = "greedy" if result.greedy else "stochastic"
        over = f"all {result.starts:,} start states" if result.exact else f"{result.starts:,} sampled start states"
        steps = f"{result.mean_steps:.3f} steps on average"
        name, value = merit(policy, result)
        print(f"{name.replace('_', ' ')} of the {kind} policy over {over}: {value:.6f} ({steps})")
    return 0


def _on_problems(options: argparse.Namespace, policy: Policy, searches: bool, seconds: float | None) -> None:
    if options.exact:
        raise NppgError("--exact is about all start states, not about problems")
    if searches:
        budget = BUDGET if options.budget is None else options.budget
        found = searched(policy, budget, math.inf if seconds is None else seconds, options.seed)
    else:
        found = attempts(
            policy,
            seed=options.seed,
            greedy=not options.stochastic,
            horizon_factor=loading.factor(options, policy),
            revisits=not options.no_revisits,
            within=seconds,
        )
    more = ("expansions",) if searches else ("avoided",) if options.no_revisits else ()
    columns = (*_COLUMNS, *more)
    if options.csv:
        table = csv.writer(sys.stdout, lineterminator="\n")
        table.writerow(columns)
        for each in found:
            table.writerow(_row(each, columns).values())
        return
    width = max(map(len, policy.domain.problems.values()), default=0)
    done = []
    for each in found:
        done.append(each)
        if not options.json:
            line = f"{each.name:{width}}  {each.ended:8}  {each.steps:5} steps  {each.seconds:8.3f} s"
            print(line, *(f"{getattr(each, name):7} {name}" for name in more), sep="  ", flush=True)
    solved = sum(each.solved for each in done)
    if options.json:
        print(json.dumps({"solved": solved, "problems": len(done), "list": [_row(each, columns) for each in done]}))
    else:
        print(f"solved {solved} of {len(done)}")


def _row(each: Attempt, columns: Sequence[str]) -> dict[str, object]:
    return {name: getattr(each, name) for name in columns}
