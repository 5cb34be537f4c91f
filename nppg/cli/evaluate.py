"""nppg evaluate."""

from __future__ import annotations

import argparse
import json
from dataclasses import asdict

from nppg.cli import loading
from nppg.cli.arguments import add_model, add_parameters
from nppg.judging.evaluation import evaluate, evaluate_exactly, merit
from nppg.learning.options import Options


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, and over which start states."""
    add_model(parser)
    add_parameters(parser)
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--exact", action="store_true", help="over all start states")
    how.add_argument("--starts", type=int, default=1000, help="number of sampled starts (default: 1000)")
    parser.add_argument("--greedy", action="store_true", help="take the most probable action")
    parser.add_argument(
        "--horizon-factor", type=float, metavar="FLOAT", help="of the domain's horizon (default: as in training)"
    )
    parser.add_argument("--seed", type=int, default=0, help="of the sampled starts (default: 0)")
    parser.add_argument("--json", action="store_true", help="print one JSON object")


def run(options: argparse.Namespace) -> int:
    """Prints the success, or the return where there is no goal. Raises NppgError."""
    policy = loading.policy(options)
    given = options.horizon_factor
    factor = Options(horizon_factor=policy.option("horizon_factor", 1.0) if given is None else given).horizon_factor
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
