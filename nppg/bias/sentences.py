"""The section `sentences`: literals in plain English."""

from __future__ import annotations

import re
from collections.abc import Collection

import yaml

from nppg.bias.names import atom
from nppg.bias.nodes import Document
from nppg.bias.signatures import Signatures

PLACEHOLDER = re.compile(r"\{([1-9][0-9]{0,2})\}")  # in a sentence, for the argument of that number


def sentences(
    document: Document, signatures: Signatures, node: yaml.Node | None, known: Collection[str]
) -> dict[str, str]:
    """`known`: the predicates that may have a sentence; empty where that could not be read."""
    found = {}
    for name, value in (document.mapping(node, "sentences", known) if node else {}).items():
        text = document.text(value, 'a sentence like "{1} is clear", in quotes,')
        if text is not None:
            _check(document, value, text, name, signatures.types.get(name))
            found[name] = text.strip()
    return found


def _check(document: Document, node: yaml.Node, text: str, name: str, types: tuple[str, ...] | None) -> None:
    """Every argument has to be mentioned: a sentence without one would say more than its literal."""
    wrong = len(document.problems)
    if "\n" in text.strip():
        document.report(node, "a sentence is one line")
    mentioned = set()
    for match in re.finditer(r"\{[^{}]*\}|[{}]", text):
        placeholder = PLACEHOLDER.fullmatch(match[0])
        if not placeholder:
            message = f"a placeholder is the number of an argument in braces, like {{1}}, not {match[0]!r}"
            document.report(node, message, match.start())
        elif types is not None and int(placeholder[1]) > len(types):
            document.report(node, f"{match[0]} stands for no argument of {atom(name, types)}", match.start())
        else:
            mentioned.add(int(placeholder[1]))
    missing = [f"{{{i + 1}}}" for i in range(len(types or ())) if i + 1 not in mentioned]
    if types and missing and len(document.problems) == wrong:
        document.report(node, f"the sentence leaves out {', '.join(missing)} of {atom(name, types)}")
