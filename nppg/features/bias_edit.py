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
    places: list[tuple[yaml.CollectionNode, list[str], str]] = []
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


def _inserted(text: str, node: yaml.CollectionNode, items: Sequence[str], mark: str) -> str:
    """With items at the end of a mapping or a list, in the style that it is written in."""
    if node.flow_style:
        end = _end(node.value[-1]) if node.value else node.start_mark.index + 1
        return f"{text[:end]}{', ' if node.value else ''}{', '.join(items)}{text[end:]}"
    end = len(text[: _end(node)].rstrip())
    end += len(text[end:].split("\n", 1)[0])  # behind a comment
    indent = " " * node.start_mark.column
    return text[:end] + "".join(f"\n{indent}{mark}{item}" for item in items) + text[end:]


def _end(node: yaml.Node | tuple[yaml.Node, yaml.Node]) -> int:
    """Where a node ends; one in block style has what follows up to the next one in its own mark."""
    if isinstance(node, tuple):
        return max(map(_end, node))
    return _end(node.value[-1]) if isinstance(node, yaml.CollectionNode) and not node.flow_style else node.end_mark.index
