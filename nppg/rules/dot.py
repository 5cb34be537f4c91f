"""A tree as a graph in Graphviz's language."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from nppg.bias.language_bias import LanguageBias
from nppg.bias.text import heading, literal_text
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

    return "\n".join([f"digraph {name} {{", f'  label="{heading(bias)}"; labelloc=t;', *lines(tree), "}"])
