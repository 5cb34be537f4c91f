"""nppg features."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.cli import loading
from nppg.cli.arguments import add_domain
from nppg.cli.writing import write_new
from nppg.errors import NppgError
from nppg.features.bias_edit import extended
from nppg.features.selection import text
from nppg.worlds.deriving import worth_testing


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The domain, and where to write."""
    add_domain(parser)
    parser.add_argument(
        "--output", type=Path, metavar="FOLDER", help="write the domain and its bias with them there (default: print)"
    )


def run(options: argparse.Namespace) -> int:
    """Prints the derived predicates that tell something in the domain, or writes both files with them. Raises
    NppgError."""
    domain = loading.domain(options)
    if domain.environment:
        raise NppgError(f"{domain.path}: an environment of Gymnasium does not say what its actions change")
    bias = loading.bias(options, domain)
    assert bias
    chosen = worth_testing(domain, bias)
    if options.output is None:
        print(text(chosen), end="")
        return 0
    files = {
        domain.path.name: domain.source + text(chosen).encode(),
        Path(bias.file).name: extended(bias.source.decode(), chosen).encode(),
        **domain.companions,
    }
    write_new(options.output, files)
    print(f"written to {options.output}/: {', '.join(files)}; {len(chosen)} derived predicates")
    return 0
