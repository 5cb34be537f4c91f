"""nppg check."""

from __future__ import annotations

import argparse

from nppg.answers.check import check
from nppg.cli import loading
from nppg.cli.arguments import add_domain
from nppg.errors import NppgError
from nppg.experiments.learners import option_problems


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The domain and its language bias."""
    add_domain(parser)


def run(options: argparse.Namespace) -> int:
    """Prints a summary, or raises NppgError with every mistake."""
    problems, summary = check(
        lambda: loading.domain(options), lambda domain: loading.bias(options, domain), option_problems
    )
    if problems:
        raise NppgError(problems)
    print(summary)
    return 0
