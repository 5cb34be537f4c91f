"""nppg prove."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.cli import loading
from nppg.cli.arguments import add_model, add_parameters
from nppg.rules.proof import check_certificate, prove


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, and the certificate."""
    add_model(parser)
    add_parameters(parser)
    parser.add_argument("--stochastic", action="store_true", help="about the stochastic policy, not the greedy one")
    parser.add_argument("--output", type=Path, metavar="FILE", help="the certificate, as JSON")
    parser.add_argument(
        "--check",
        type=Path,
        metavar="FILE",
        help="refuse this certificate where it differs from the proof, which is done again and takes as long",
    )
    parser.add_argument("--show", type=int, default=3, metavar="N", help="failing classes to draw (default: 3)")


def run(options: argparse.Namespace) -> int:
    """Prints the verdict and the failing classes. Raises NppgError."""
    policy = loading.policy(options, tell=False)  # what would be told is refused
    proof = prove(policy, options.model, greedy=not options.stochastic)
    if options.check:
        check_certificate(options.check, proof)
        print(f"{options.check} is right: {options.model} was proved again, with the same result")
    kind = "greedy" if proof.greedy else "stochastic"
    print(f"{proof.classes:,} classes of {proof.states:,} states, {proof.starts:,} of them start states")
    for failure in proof.failures[: options.show]:
        print(
            "",
            f"from {failure.states:,} states like this it succeeds with probability {failure.success:.6f}:",
            sep="\n",
        )
        print(*failure.picture, sep="\n")
    verdict = (
        "from every one"
        if proof.complete
        else f"with {proof.success:.9f}; it can fail in {len(proof.failures)} classes"
    )
    print(f"the {kind} policy succeeds {verdict}")
    if options.output:
        proof.save(options.output)
        print(f"certificate: {options.output}")
    return 0
