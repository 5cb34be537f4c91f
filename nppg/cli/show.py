"""nppg show."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import replacing
from nppg.cli import loading
from nppg.cli.arguments import add_explain, add_model
from nppg.errors import NppgError
from nppg.experiments.progress import title
from nppg.policy.policy import Policy
from nppg.policy.sentences import explained
from nppg.rules.dot import dot
from nppg.rules.pictures import page
from nppg.trees.tree import seen

FORMATS = ("text", "html", "svg", "dot")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The model, and which trees."""
    add_model(parser)
    parser.add_argument("--tree", type=int, metavar="N", help="this tree alone, from 1")
    add_explain(parser)
    parser.add_argument("--bias", help="whose sentences explain (default: the bias that the model was trained with)")
    parser.add_argument("--format", choices=FORMATS, default="text", help="(default: text, which is Prolog)")
    parser.add_argument("--output", type=Path, metavar="FILE", help="where it is written to (default: it is printed)")


def run(options: argparse.Namespace) -> int:
    """Prints the trees as rules or as graphs. Raises NppgError."""
    if options.explain and options.format in ("dot", "svg"):
        raise NppgError(f"--explain is about rules, which --format {options.format} does not show")
    policy = loading.policy(options)
    count = len(policy.trees)
    if options.tree is not None and not 1 <= options.tree <= count:
        raise NppgError(f"there is no tree {options.tree}: the model has {count}")
    bias = loading.bias_of(policy, options) if options.explain else None
    numbers = range(1, count + 1) if options.tree is None else [options.tree]
    if options.format == "svg" and len(numbers) != 1:
        raise NppgError(f"an SVG has one tree, the model {count}: name one by --tree, or take --format html")
    parts = _parts(policy, numbers, options, bias)
    if options.output:
        replacing(options.output, lambda path: path.write_text("\n".join([*parts, ""]), encoding="utf-8"))
    else:
        for part in parts:
            print(part)
    return 0


def _parts(
    policy: Policy, numbers: Sequence[int], options: argparse.Namespace, bias: LanguageBias | None
) -> Iterator[str]:
    if options.format == "html":
        yield page(policy, numbers, title(policy.domain), bias)
        return
    for number in numbers:
        tree = policy.trees[number - 1]
        if options.format == "dot":
            yield dot(tree, policy.bias, f"tree_{number}")
        elif options.format == "svg":
            yield seen(tree, policy.bias)
        else:
            rules = explained(policy, number, bias) if bias else policy.rules(number)
            yield "\n".join([f"% tree {number}: {policy.comments[number - 1]}", *rules, ""])
