"""nppg prove."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.cli import loading
from nppg.cli.arguments import add_model, add_parameters, add_problems
from nppg.errors import NppgError
from nppg.judging.reachable import LIMIT
from nppg.learning.options import at_least
from nppg.policy.policy import Policy
from nppg.rules.certificates import Certificate, check_certificate
from nppg.rules.problem_proof import ProblemProof, Trace, prove_problems
from nppg.rules.proof import prove

_LINES = 40  # of a trace that are printed


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, what is proven, and the certificate."""
    add_model(parser)
    add_parameters(parser)
    add_problems(parser)
    parser.add_argument(
        "--from-everywhere",
        action="store_true",
        help="of problems: from every state that can be reached, and from which the goal can be reached",
    )
    parser.add_argument(
        "--states", type=int, default=LIMIT, metavar="N", help=f"of a problem, at most (default: {LIMIT:,})"
    )
    parser.add_argument("--stochastic", action="store_true", help="about the stochastic policy, not the greedy one")
    parser.add_argument("--output", type=Path, metavar="FILE", help="the certificate, as JSON")
    parser.add_argument(
        "--check",
        type=Path,
        metavar="FILE",
        help="refuse this certificate where it differs from the proof, which is done again and takes as long",
    )
    parser.add_argument(
        "--show", type=int, default=3, metavar="N", help="failing classes, or runs, to show (default: 3)"
    )


def run(options: argparse.Namespace) -> int:
    """Prints the verdict and what fails. Raises NppgError."""
    at_least("show", options.show, 0)
    policy = loading.policy(options, tell=False)  # what would be told is refused
    if policy.domain.chosen:
        _on_problems(options, policy)
    elif options.from_everywhere:
        raise NppgError("--from-everywhere is for problems: name them by --problems")
    else:
        _over_all_starts(options, policy)
    return 0


def _over_all_starts(options: argparse.Namespace, policy: Policy) -> None:
    proof = prove(policy, options.model, greedy=not options.stochastic)
    _check(options, proof)
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
    print(f"the {_kind(proof.greedy)} policy succeeds {verdict}")
    _write(options, proof)


def _on_problems(options: argparse.Namespace, policy: Policy) -> None:
    shown = 0

    def report(proof: ProblemProof) -> None:
        nonlocal shown
        print(f"{proof.name}: {_told(proof)}", flush=True)
        if proof.failure and shown < options.show:
            shown += 1
            print(*_lines(proof.failure), sep="\n", flush=True)

    limit = at_least("states", options.states, 1)
    greedy, everywhere = not options.stochastic, options.from_everywhere
    proof = prove_problems(policy, options.model, None, greedy, everywhere, limit, report)
    _check(options, proof)
    proven = sum(each.complete for each in proof.problems)
    where = "from everywhere, on" if everywhere else "for certain on"
    print(f"the {_kind(proof.greedy)} policy succeeds {where} {proven} of {len(proof.problems)} problems")
    _write(options, proof)


def _told(proof: ProblemProof) -> str:
    """One line about a problem."""
    late = proof.longest is not None and proof.longest > proof.horizon
    if proof.certain:
        told = f"proven, in {proof.longest} steps at most{f', beyond the horizon of {proof.horizon}' if late else ''}"
    else:
        told = "not proven, it can miss the goal"
    if late or not proof.certain:
        told += f"; within {proof.horizon} steps it reaches it with probability {proof.success:.9f}"
    told += f"; {proof.states:,} states"
    if proof.alive is not None:
        told += f", {proof.alive:,} with a way to the goal, {proof.sure:,} of them with a certain one"
    return told


def _lines(trace: Trace) -> list[str]:
    """A run that fails, a step a line; a long one without what is amidst."""
    lines = [f"  {step}" for step in trace.steps]
    if trace.lost is not None:
        lines.insert(trace.lost, "  from here on the goal is out of reach")
    if trace.loop:
        lines.insert(len(lines) - trace.loop, "  here begins a loop:")
        ended = f"  and so on: it is in a loop of {trace.loop} step{'s' * (trace.loop > 1)}"
    else:
        ended = "  there is no way on"
    if len(lines) > _LINES:
        half = _LINES // 2
        lines[half:-half] = [f"  ... {len(lines) - 2 * half} more lines"]
    begins = f", from a state that other actions lead to ({len(trace.way)} steps): {trace.state}" if trace.way else ""
    return [f"  a run that fails{begins}:", *lines, ended]


def _kind(greedy: bool) -> str:
    return "greedy" if greedy else "stochastic"


def _check(options: argparse.Namespace, proof: Certificate) -> None:
    if options.check:
        check_certificate(options.check, proof, options.edited)
        print(f"{options.check} is right: {options.model} was proved again, with the same result")


def _write(options: argparse.Namespace, proof: Certificate) -> None:
    if options.output:
        proof.save(options.output)
        print(f"certificate: {options.output}")
