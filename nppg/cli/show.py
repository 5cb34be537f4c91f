"""nppg show."""

from __future__ import annotations

import argparse

from nppg.cli import loading
from nppg.cli.arguments import add_explain, add_model
from nppg.errors import NppgError
from nppg.rules.dot import dot
from nppg.policy.sentences import explained


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, and which trees."""
    add_model(parser)
    parser.add_argument("--tree", type=int, metavar="N", help="this tree alone, from 1")
    add_explain(parser)
    parser.add_argument("--bias", help="whose sentences explain (default: the bias that the model was trained with)")
    parser.add_argument("--format", choices=("prolog", "dot"), default="prolog", help="(default: prolog)")


def run(options: argparse.Namespace) -> int:
    """Prints the trees as rules or as graphs. Raises NppgError."""
    if options.explain and options.format == "dot":
        raise NppgError("--explain is about rules, which --format dot does not show")
    policy = loading.policy(options)
    count = len(policy.trees)
    if options.tree is not None and not 1 <= options.tree <= count:
        raise NppgError(f"there is no tree {options.tree}: the model has {count}")
    bias = loading.bias_of(policy, options) if options.explain else None
    for number in range(1, count + 1) if options.tree is None else [options.tree]:
        if options.format == "dot":
            print(dot(policy.trees[number - 1], policy.bias, f"tree_{number}"))
        else:
            rules = explained(policy, number, bias) if bias else policy.rules(number)
            print(f"% tree {number}: {policy.comments[number - 1]}", *rules, "", sep="\n")
    return 0
