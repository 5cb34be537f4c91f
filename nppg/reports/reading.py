"""What there is to read in a policy: its rules with their sentences, and its trees as pictures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape

from nppg.bias.language_bias import LanguageBias
from nppg.bias.text import literal_text
from nppg.policy.policy import Policy
from nppg.policy.sentences import sentences
from nppg.trees.tree import Leaf, Tree, seen

Path = tuple[tuple[str, bool], ...]  # tests with their answers, from the root


def paths(tree: Tree, bias: LanguageBias, above: Path = ()) -> Iterator[Path]:
    """The tests that lead to each leaf, in the order of the leaves."""
    if isinstance(tree, Leaf):
        yield above
    else:
        test = ", ".join(literal_text(literal, bias) for literal in tree.literals)
        yield from paths(tree.yes, bias, (*above, (test, True)))
        yield from paths(tree.no, bias, (*above, (test, False)))


def rules_html(policy: Policy, tree: int, bias: LanguageBias) -> str:
    """The rules of a tree (from 1) as a list, each with its sentence if the bias has any."""
    said: Sequence[str] = sentences(policy, tree, bias) if bias.sentences else ()
    items = []
    for number, rule in enumerate(policy.rules(tree)):
        sentence = f'<p class="said">{escape(said[number])}</p>' if said else ""
        items.append(f'<li>{sentence}<pre class="rule"><code>{highlighted(rule)}</code></pre></li>')
    return f'<ol class="rules">{"".join(items)}</ol>'


def tree_html(policy: Policy, tree: int, number: int) -> str:
    """The picture of a tree (from 1), the one of that number on the page, in a frame that it may be moved in."""
    drawn = seen(policy.trees[tree - 1], policy.bias, style=False)
    return f'<div class="wide" tabindex="0" role="region" aria-label="tree {tree}" data-tree="{number}">{drawn}</div>'


def highlighted(rule: str) -> str:
    """A rule with its neck and its cut made faint."""
    text = escape(rule)
    return text.replace(" :- ", ' <i>:-</i> ').replace(", !.", "<i>, !.</i>")
