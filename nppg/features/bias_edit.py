"""A language bias that tests derived predicates, too."""

from __future__ import annotations

from collections.abc import Sequence

import yaml

from nppg.bias.names import atom
from nppg.features.derived import Derived


def extended(text: str, chosen: Sequence[Derived]) -> str:
    """The text of a bias file with the types and modes of these predicates at the end of its sections."""
    if not chosen:
        return text
    root = yaml.compose(text)
    assert isinstance(root, yaml.MappingNode)
    sections = {key.value: value for key, value in root.value}
    types = {each.name: f"[{', '.join(each.types)}]" for each in chosen}
    lines = [line for each in chosen for line in _modes(each)]
    places = []
    if "types" in sections:
        places.append((sections["types"], [f"{name}: {own}" for name, own in types.items()], ""))
    places.append((sections["modes"], lines, "- "))
    for node, items, mark in sorted(places, key=lambda place: -place[0].end_mark.index):
        text = _inserted(text, node, items, mark)
    return text


def _modes(each: Derived) -> list[str]:
    known = atom(each.name, ["+"] * len(each.types))
    opened = [atom(each.name, ["-" if i == place else "+" for i in range(len(each.types))]) for place in each.unknown]
    return [known, *opened]


def _inserted(text: str, node: yaml.Node, items: Sequence[str], mark: str) -> str:
    """With items at the end of a mapping or a list, in the style that it is written in."""
    if node.flow_style:
        end = node.end_mark.index - 1
        before = text[:end].rstrip()
        comma = "" if before.endswith(("{", "[", ",")) else ", "
        return f"{before}{comma}{', '.join(items)}{text[end:]}"
    end = len(text[: node.end_mark.index].rstrip())
    first = node.value[0][0] if isinstance(node, yaml.MappingNode) else node.value[0]
    column = first.start_mark.column - len(mark)
    return text[:end] + "".join(f"\n{' ' * column}{mark}{item}" for item in items) + text[end:]
