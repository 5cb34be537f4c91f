"""A tree as a graph in Graphviz's language."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from nppg.bias.language_bias import LanguageBias
from nppg.bias.text import literal_text
from nppg.logic.query import Literal, Var
from nppg.trees.tree import Leaf, Tree


def dot(tree: Tree, bias: LanguageBias, name: str = "tree") -> str:
    """The tree as a digraph: tests in boxes, the value in each leaf; success to the left."""
    numbers = count()

    def lines(node: Tree) -> Iterator[str]:
        own = next(numbers)
        if isinstance(node, Leaf):
            yield f'  n{own} [shape=plain, label="{node.value:.4g}"];'
            return
        label = ", ".join(literal_text(literal, bias) for literal in node.literals).replace('"', '\\"')
        yield f'  n{own} [shape=box, label="{label}"];'
        for branch, answer in ((node.yes, "yes"), (node.no, "no")):
            first = None
            for line in lines(branch):
                first = first or line.split()[0]
                yield line
            yield f'  n{own} -> {first} [label="{answer}"];'

    head = ", ".join(map(str, (literal_text(each, bias) for each in _templates(bias))))
    return "\n".join([f"digraph {name} {{", f'  label="{head}"; labelloc=t;', *lines(tree), "}"])


def _templates(bias: LanguageBias) -> list[Literal]:
    templates = [*bias.actions, *([bias.goal] if bias.goal else [])]
    return [
        Literal(template.name, tuple(Var(offset + i) for i in range(len(template.types))))
        for template, offset in zip(templates, bias.offsets, strict=False)
    ]
