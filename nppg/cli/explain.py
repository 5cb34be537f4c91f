"""nppg explain."""

from __future__ import annotations

import argparse

import numpy as np

from nppg.cli import loading
from nppg.cli.arguments import add_model, add_parameters, add_problems


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, and the state."""
    add_model(parser)
    parser.add_argument(
        "--state",
        metavar="FACTS",
        help='what holds: "on(b1, b2), on(b2, floor)" (default: a start state)',
    )
    parser.add_argument("--bias", help="whose sentences explain (default: the bias that the model was trained with)")
    add_parameters(parser)
    add_problems(parser)


def run(options: argparse.Namespace) -> int:
    """Prints the state, each action with its reasons, and what would change the choice. Raises NppgError."""
    policy = loading.policy(options)
    bias = loading.bias_of(policy, options) if options.bias or "bias" in policy.facts else None
    domain = policy.domain
    state = domain.start(np.random.default_rng(0)) if options.state is None else domain.state(options.state)
    explanation = policy.explain(state, bias)
    print(*domain.picture(state), "", explanation, sep="\n")
    return 0
