"""The reader of language-bias files: its sections, in the order in which they need each other."""

from __future__ import annotations

import sys
from dataclasses import fields

import yaml

from nppg.bias.declarations import Declared, TreeLimits
from nppg.bias.modes import modes
from nppg.bias.names import number
from nppg.bias.nodes import Document, described
from nppg.bias.options import options
from nppg.bias.sentences import sentences
from nppg.bias.signatures import Signatures
from nppg.bias.templates import actions, goal
from nppg.errors import NppgError

KEYS = ("action", "goal", "subtypes", "types", "modes", "lookahead", "max_variables", "tree", "options", "sentences")
REQUIRED = ("action", "types", "modes")


def read(file: str, text: str) -> Declared:
    """What a file of this name and text declares. Raises NppgError with all its mistakes."""
    document = Document(file, text)
    root = document.compose()
    entries = document.mapping(root, "a language bias", KEYS)
    if isinstance(root, yaml.MappingNode):
        for key in REQUIRED:
            if key not in entries:
                document.report(root, f"the key '{key}' is missing")
    signatures = Signatures(document, entries.get("types"), entries.get("subtypes"))
    before = len(document.problems)
    kinds = actions(document, signatures, entries.get("action"))
    goals = goal(document, signatures, entries.get("goal"))
    all_known = signatures.complete and "action" in entries and len(document.problems) == before
    max_lookahead = document.whole(entries.get("lookahead"), "lookahead", 0, otherwise=sys.maxsize)
    max_variables = document.whole(entries.get("max_variables"), "max_variables", 4)
    found = modes(document, signatures, entries.get("modes"), max_lookahead)
    tree = _tree(document, entries.get("tree"))
    values, places = options(document, entries.get("options"))
    said = sentences(document, signatures, entries.get("sentences"), signatures.types if all_known else ())
    signatures.check_uses([*kinds, *goals])
    if document.problems:
        raise NppgError(sorted(document.problems))
    return Declared(
        file,
        actions=tuple(template for _, template in kinds),
        goal=next((template for _, template in goals), None),
        types={name: types for name, types in signatures.types.items() if types is not None},
        subtypes=signatures.subtypes,
        modes=found,
        max_lookahead=max_lookahead,
        max_variables=max_variables,
        tree=tree,
        sentences=said,
        options=values,
        is_default_maximum="max_variables" not in entries,
        option_places=places,
    )


def _tree(document: Document, node: yaml.Node | None) -> TreeLimits:
    values: dict[str, int | float] = {}
    entries = document.mapping(node, "tree", [each.name for each in fields(TreeLimits)]) if node else {}
    for key, value_node in entries.items():
        value = number(value_node.value) if isinstance(value_node, yaml.ScalarNode) else None
        if value is None:
            document.report(value_node, f"{key} is a number, not {described(value_node)}")
            continue
        try:
            TreeLimits(**{key: value})  # type: ignore[arg-type]
            values[key] = value
        except NppgError as error:
            document.report(value_node, str(error))
    return TreeLimits(**values)  # type: ignore[arg-type]
