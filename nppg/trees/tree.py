"""Relational regression trees, and the ordered clauses that are the same function.

A node tests its whole *associated query*: the success branch extends the query by the test, the failure branch
keeps it. A tree is therefore the list of its leaves' queries, success first, of which the first that holds gives
the value (Blockeel and De Raedt 1998).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from nppg.bias.language_bias import LanguageBias
from nppg.bias.text import heading, literal_text
from nppg.logic.query import Query
from nppg.trees.drawing import Drawn, svg, wrapped


class _Seen:
    """What notebooks show."""

    __slots__ = ()

    def _repr_svg_(self) -> str:
        return seen(self)  # type: ignore[arg-type]


@dataclass(frozen=True, slots=True)
class Leaf(_Seen):
    """A predicted value, and how many examples it is the mean of (0 where that is not known). A leaf of classes has the
    number of its class for a value and the weight of each in `values`, one of several targets their means."""

    value: float
    examples: int = 0
    values: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Node(_Seen):
    """A test: `literals` extend the node's query; the extended query holds exactly if all `tests` do."""

    literals: Query
    tests: tuple[Query, ...]
    yes: Tree
    no: Tree


Tree = Leaf | Node
TestsOf = Callable[[Query, Query], tuple[Query, ...]]


@dataclass(frozen=True, slots=True)
class Rule:
    """A leaf with its query."""

    query: Query
    value: float


def rules(tree: Tree, query: Query = ()) -> Iterator[Rule]:
    """The leaves in order: the first whose query holds gives the value of the tree."""
    if isinstance(tree, Leaf):
        yield Rule(query, tree.value)
    else:
        yield from rules(tree.yes, query + tree.literals)
        yield from rules(tree.no, query)


def mapped(tree: Tree, change: Callable[[float], float]) -> Tree:
    """The tree with each leaf's value changed."""
    if isinstance(tree, Leaf):
        return Leaf(change(tree.value), tree.examples)
    return Node(tree.literals, tree.tests, mapped(tree.yes, change), mapped(tree.no, change))


def leaves(tree: Tree) -> int:
    """The number of leaves."""
    return 1 if isinstance(tree, Leaf) else leaves(tree.yes) + leaves(tree.no)


def tests(tree: Tree) -> list[Query]:
    """The tests of all nodes."""
    return [] if isinstance(tree, Leaf) else [*tree.tests, *tests(tree.yes), *tests(tree.no)]


def seen(tree: Tree, bias: LanguageBias | None = None, style: bool = True) -> str:
    """The tree as SVG; the bias knows what its variables stand for. Without `style` that is the page's."""
    return svg(_drawn(tree, bias), heading(bias) if bias else "", style)


def _drawn(tree: Tree, bias: LanguageBias | None) -> Drawn:
    if isinstance(tree, Leaf):
        count = (f"{tree.examples:,} examples",) if tree.examples else ()
        return Drawn((f"{tree.value:.4g}", *count), tree.value)
    lines = wrapped([literal_text(literal, bias) for literal in tree.literals])
    return Drawn(lines, yes=_drawn(tree.yes, bias), no=_drawn(tree.no, bias))


def from_rules(ordered: Sequence[Rule], tests_of: TestsOf, query: Query = ()) -> Tree:
    """The tree of an ordered list of rules whose last one holds wherever `query` does.

    Rules that share literals are put below one node. `tests_of(query, literals)` gives a node's tests. Raises
    ValueError for a list that has no such last rule.
    """
    given = set(query)
    if not ordered or not set(ordered[-1].query) <= given:
        raise ValueError("the last rule must hold wherever the others do not")
    if set(ordered[0].query) <= given:
        return Leaf(ordered[0].value)
    shared = max(
        end
        for end in range(1, len(ordered))
        if all(set(ordered[end - 1].query) <= set(rule.query) for rule in ordered[:end])
        and not set(ordered[end - 1].query) <= given
    )
    literals = tuple(literal for literal in ordered[shared - 1].query if literal not in given)
    return Node(
        literals,
        tests_of(query, literals),
        from_rules(ordered[:shared], tests_of, query + literals),
        from_rules(ordered[shared:], tests_of, query),
    )
