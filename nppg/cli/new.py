"""nppg new."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from nppg.bridge.files import shipped
from nppg.errors import NppgError, Problem, suggestion

_FIRST = "delivery"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The name, and the shipped domain to start from."""
    parser.add_argument("name", help="of the domain, and of the files")
    parser.add_argument(
        "--from",
        dest="source",
        default=_FIRST,
        metavar="DOMAIN",
        help=f"the shipped domain to start from: see nppg domains (default: {_FIRST}, a short one with many comments)",
    )


def run(options: argparse.Namespace) -> int:
    """Writes both files and says what comes next. Raises NppgError."""
    name, source = options.name, options.source
    if not (name.isidentifier() and name[0].islower()):
        raise NppgError(f"'{name}' cannot be a domain's name: write a lower-case letter, then letters, digits or _")
    known = sorted(each.stem for each in shipped("domains").glob("*.pl"))
    if source not in known:
        hint = suggestion(source, known) or f"; there are: {', '.join(known)}"
        raise NppgError(f"there is no shipped domain {source}{hint}")
    files = [Path(f"{name}.pl"), Path(f"{name}.yaml")]
    for file in files:
        if file.exists():
            raise NppgError([Problem(str(file), 0, 0, "exists already and is left as it is")])
    for file, folder in zip(files, ("domains", "language_bias"), strict=True):
        text = (shipped(folder) / f"{source}{file.suffix}").read_text(encoding="utf-8")
        lines = [line for line in text.splitlines() if "$schema" not in line]
        renamed = re.sub(rf"(:- module\(|for the domain ){source}\b", rf"\g<1>{name}", "\n".join(lines)) + "\n"
        try:
            file.write_text(renamed, encoding="utf-8")
        except OSError as error:
            raise NppgError([Problem(str(file), 0, 0, f"cannot be written: {error.strerror}")]) from None
    print(f"written: {files[0]} and {files[1]}; next: nppg check {files[0]}, then nppg train {files[0]}")
    return 0
