"""nppg plan."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from nppg.bridge.files import replacing
from nppg.cli import loading
from nppg.cli.arguments import add_acting, add_model, add_parameters, add_search, checked_search
from nppg.errors import NppgError
from nppg.judging.levin import BUDGET, search
from nppg.judging.problems import LIMIT, Attempt, attempt

_STOPPED = {
    "dead end": "it came to a state without a way on",
    "loop": "it went round in a loop",
    "limit": "it came to the limit of steps (see --horizon-factor)",
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, the problem, and how actions are chosen."""
    add_model(parser)
    parser.add_argument("problem", help="a file of PDDL, or the number of one of the domain's problems")
    add_parameters(parser)
    parser.add_argument("--stochastic", action="store_true", help="draw actions by their probabilities")
    add_acting(parser)
    add_search(parser)
    parser.add_argument("--seed", type=int, default=0, help="of what is drawn, ties among them (default: 0)")
    parser.add_argument("--output", type=Path, metavar="FILE", help="write the plan there")


def run(options: argparse.Namespace) -> int:
    """Prints the plan in the format of the planning competition; the status is 1 where none is found, and it is told
    what stopped the policy. Raises NppgError."""
    searches = checked_search(options)
    options.problems = [options.problem]
    policy = loading.policy(options)
    domain = policy.domain
    if len(domain.chosen) != 1:
        raise NppgError(f"{options.problem} has {len(domain.chosen)} problems; a plan is for one")
    (number,) = domain.chosen
    if searches:
        found = search(policy, number, BUDGET if options.budget is None else options.budget, seed=options.seed)
    else:
        factor = loading.factor(options, policy)
        found = attempt(policy, number, options.seed, not options.stochastic, factor, not options.no_revisits)
    if not found.solved:
        print(f"no plan: {_stopped(found)}", file=sys.stderr)
        return 1
    kind = "general cost" if domain.has_costs else "unit cost"
    lines = [*map(domain.plan_step, found.plan), f"; cost = {found.cost} ({kind})"]
    if domain.has_chance:
        lines.append(f"; one course of events: outcomes are left to chance, here drawn with seed {options.seed}")
    text = "".join(f"{line}\n" for line in lines)
    if options.output:
        replacing(options.output, lambda path: path.write_text(text, encoding="utf-8"))
    else:
        print(text, end="")
    return 0


def _stopped(found: Attempt) -> str:
    """Why there is no plan."""
    if found.expansions is None:
        return f"{_STOPPED[found.ended]}, after {found.steps} steps"
    end = "none was found in" if found.ended == LIMIT else "there is none: nothing is left after"
    return f"{end} {found.expansions:,} expansions"
