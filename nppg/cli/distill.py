"""nppg distill."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.cli import loading
from nppg.cli.arguments import (
    add_explain,
    add_model,
    add_no_revisits,
    add_parameters,
    add_problems,
    add_seconds,
    checked_seconds,
    warnings_told,
)
from nppg.judging.evaluation import evaluate, evaluate_exactly, merit
from nppg.learning.options import at_least
from nppg.policy.policy import Policy
from nppg.rules.distill import MAX_RULES, SECONDS, distilled
from nppg.rules.explain import explained, sentences


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, and how few rules."""
    add_model(parser)
    add_explain(parser)
    judging = parser.add_argument_group("what the rules are judged on (default: what the policy was trained on)")
    add_parameters(judging)
    add_problems(judging)
    add_no_revisits(judging)
    parser.add_argument(
        "--max-rules", type=int, default=MAX_RULES, metavar="N", help=f"at most so many (default: {MAX_RULES})"
    )
    add_seconds(parser, f"about so many, to find the rules in (default: {SECONDS:.0f})")
    parser.add_argument("--bias", help="what the rules may test (default: the bias that the model was trained with)")
    parser.add_argument(
        "--output", type=Path, metavar="FILE", help="the rules' model file (default: MODEL's folder, rules.pl)"
    )


def run(options: argparse.Namespace) -> int:
    """Prints and writes the rules with their success. Raises NppgError."""
    at_least("max-rules", options.max_rules, 1)
    seconds = checked_seconds(options)
    with warnings_told():
        policy = Policy.load(options.model, edited=options.edited)
    wanted = loading.policy(options, tell=False).domain if options.set or options.problems else None
    bias = loading.bias_of(policy, options)
    rules, report = distilled(policy, bias, options.max_rules, wanted, seconds or SECONDS, not options.no_revisits)
    problems = rules.domain.chosen
    if rules.domain.is_countable:
        result = evaluate_exactly(rules, greedy=True)
    else:
        result = evaluate(rules, seed=1, greedy=True, problems=problems, revisits=not options.no_revisits)
    judged, value = merit(rules, result)
    output = options.output or options.model.with_name("rules.pl")
    beside = Path(bias.file).resolve().parent == output.resolve().parent
    facts = [
        *([("bias", Path(bias.file).name), ("bias_sha256", bias.hash)] if beside else []),
        *((judged, value), ("starts", result.starts), ("exact", int(result.exact))),
    ]
    rules.save(output, facts, [sentences(rules, 1, bias)] if options.explain else ())
    print(*(explained(rules, 1, bias) if options.explain else rules.rules(1)), sep="\n")
    if report:
        print(report)
    over = "all" if result.exact or problems else "sampled"
    starts = "problems" if problems else "start states"
    print(
        f"{judged.replace('_', ' ')} of these rules over {over} {result.starts:,} {starts}: {value:.6f}; "
        f"written to {output}"
    )
    return 0
