"""The section `options`: what suits the domain. Which options there are, and what they may be, the learners know."""

from __future__ import annotations

import yaml

from nppg.bias.declarations import OptionPlaces
from nppg.bias.names import number
from nppg.bias.nodes import Document
from nppg.logic.query import Constant


def options(document: Document, node: yaml.Node | None) -> tuple[dict[str, Constant], dict[str, OptionPlaces]]:
    """The values, numbers where they read as such: `no` and `on` are texts as everywhere. And where they stand."""
    entries = document.mapping(node, "options") if node else {}
    keys = {key.value: key for key, _ in node.value} if isinstance(node, yaml.MappingNode) else {}
    values: dict[str, Constant] = {}
    for name, value_node in entries.items():
        text = document.text(value_node, f"a value of {name}")
        if text is not None:
            value = number(text)
            values[name] = text.strip() if value is None else value
    return values, {name: OptionPlaces(document.place(keys[name]), document.place(entries[name])) for name in values}
