"""nppg distill."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.cli import loading
from nppg.cli.arguments import add_explain, add_model, add_problems
from nppg.judging.evaluation import evaluate, evaluate_exactly, merit
from nppg.learning.options import at_least
from nppg.rules.distill import distill
from nppg.rules.explain import explained, sentences


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, and how few rules."""
    add_model(parser)
    add_explain(parser)
    add_problems(parser)
    parser.add_argument("--max-rules", type=int, default=10, metavar="N", help="(default: 10)")
    parser.add_argument("--bias", help="what the rules may test (default: the bias that the model was trained with)")
    parser.add_argument(
        "--output", type=Path, metavar="FILE", help="the rules' model file (default: MODEL's folder, rules.pl)"
    )


def run(options: argparse.Namespace) -> int:
    """Prints and writes the rules with their success. Raises NppgError."""
    at_least("max-rules", options.max_rules, 1)
    policy = loading.policy(options)
    bias = loading.bias_of(policy, options)
    rules = distill(policy, bias, options.max_rules)
    exact = policy.domain.is_countable
    problems = policy.domain.chosen
    result = evaluate_exactly(rules, greedy=True) if exact else evaluate(rules, seed=1, greedy=True, problems=problems)
    judged, value = merit(rules, result)
    output = options.output or options.model.with_name("rules.pl")
    beside = Path(bias.file).resolve().parent == output.resolve().parent
    facts = [
        *([("bias", Path(bias.file).name), ("bias_sha256", bias.hash)] if beside else []),
        *((judged, value), ("starts", result.starts), ("exact", int(result.exact))),
    ]
    rules.save(output, facts, [sentences(rules, 1, bias)] if options.explain else ())
    print(*(explained(rules, 1, bias) if options.explain else rules.rules(1)), sep="\n")
    over = "all" if result.exact or problems else "sampled"
    starts = "problems" if problems else "start states"
    print(
        f"{judged.replace('_', ' ')} of these rules over {over} {result.starts:,} {starts}: {value:.6f}; "
        f"written to {output}"
    )
    return 0
