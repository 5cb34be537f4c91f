"""nppg domains."""

from __future__ import annotations

import argparse
import re
import textwrap
from pathlib import Path

from nppg.bridge.files import shipped


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """None."""


def run(options: argparse.Namespace) -> int:
    """Prints each domain with what stands at the head of its file, its parameters and its language biases."""
    for file in sorted(shipped("domains").glob("*.pl")):
        print(told(file))
    print("nppg train NAME learns in one, nppg new MINE --from NAME makes files of your own from it.")
    print("Besides: files of PDDL, and gym:ID for an environment of Gymnasium.")
    return 0


def told(file: Path) -> str:
    """What is said of one domain."""
    text = file.read_text(encoding="utf-8")
    about = re.search(r"^%.+(?:\n%.+)*", text, re.MULTILINE)
    words = re.sub(r"\s*%\s*", " ", about[0]).strip() if about else ""
    lines = [file.stem, *textwrap.wrap(words, 100, initial_indent="  ", subsequent_indent="  ")]
    parameters = re.findall(r"^:- parameter\((\w+), *([^)]+)\)", text, re.MULTILINE)
    if parameters:
        lines.append("  --set " + ", ".join(f"{name}={default}" for name, default in parameters))
    others = [bias.stem for bias in sorted(shipped("language_bias").glob(f"{file.stem}_*.yaml"))]
    if others:
        lines.append("  --bias " + ", ".join(others))
    return "\n".join([*lines, ""])
