"""nppg new."""

from __future__ import annotations

import argparse
from pathlib import Path

from nppg.bridge.files import shipped
from nppg.errors import NppgError, Problem


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The name."""
    parser.add_argument("name", help="of the domain, and of the files")


def run(options: argparse.Namespace) -> int:
    """Writes both files and says what comes next. Raises NppgError."""
    name = options.name
    if not (name.isidentifier() and name[0].islower()):
        raise NppgError(f"'{name}' cannot be a domain's name: write a lower-case letter, then letters, digits or _")
    files = [Path(f"{name}.pl"), Path(f"{name}.yaml")]
    for file in files:
        if file.exists():
            raise NppgError([Problem(str(file), 0, 0, "exists already and is left as it is")])
    for file, folder in zip(files, ("domains", "language_bias"), strict=True):
        text = (shipped(folder) / f"delivery{file.suffix}").read_text(encoding="utf-8")
        lines = [line for line in text.splitlines() if "$schema" not in line]
        try:
            file.write_text("\n".join(lines).replace("delivery", name) + "\n", encoding="utf-8")
        except OSError as error:
            raise NppgError([Problem(str(file), 0, 0, f"cannot be written: {error.strerror}")]) from None
    print(f"written: {files[0]} and {files[1]}; next: nppg check {files[0]}, then nppg train {files[0]}")
    return 0
