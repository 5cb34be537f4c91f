"""What was learned, for people: trees in ACE's compact notation, ordered rules in Prolog, tables of errors."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterator, Sequence

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bias.names import atom, written
from nppg.bias.text import literal_text
from nppg.logic.query import Literal, Query, Var
from nppg.tilde.model import Model
from nppg.trees.tree import Leaf, Tree


def tree_text(tree: Tree, model: Model) -> str:
    """A tree: a node's test, below it what is said where it holds, and where not."""
    head = literal_text(_example(model.bias), model.bias) if model.bias.roots else ""
    return "\n".join([*([head] if head else []), *_lines(tree, model, "", "")])


def _lines(tree: Tree, model: Model, first: str, rest: str) -> Iterator[str]:
    if isinstance(tree, Leaf):
        yield f"{first}{leaf_text(tree, model)}"
        return
    yield f"{first}{_conjunction(tree.literals, model.bias)} ?"
    yield from _lines(tree.yes, model, f"{rest}+--yes: ", f"{rest}|       ")
    yield from _lines(tree.no, model, f"{rest}+--no:  ", f"{rest}        ")


def leaf_text(leaf: Leaf, model: Model) -> str:
    """[class] [those of it/all], or [value] [how many]."""
    if model.classes and leaf.values:
        size = math.fsum(leaf.values)
        return f"[{said(leaf, model)}] [{leaf.values[int(leaf.value)]:.10g}/{size:.10g}]"
    return f"[{said(leaf, model)}] [{leaf.examples}]"


def said(leaf: Leaf, model: Model) -> str:
    """What a leaf predicts."""
    if model.classes and leaf.values:
        return str(model.classes[int(leaf.value)])
    return ", ".join(f"{value:.6g}" for value in leaf.values or (leaf.value,))


def rules_text(tree: Tree, model: Model) -> str:
    """The same as clauses, of which the first that holds counts."""
    return "\n".join(_rules(tree, (), model))


def _rules(tree: Tree, query: Query, model: Model) -> Iterator[str]:
    if not isinstance(tree, Leaf):
        yield from _rules(tree.yes, query + tree.literals, model)
        yield from _rules(tree.no, query, model)
        return
    example = _example(model.bias)
    value = written(said(tree, model)) if model.classes else said(tree, model)
    name = written(example.name) if example.args else written(model.target)
    roots = [literal_text(Literal("=", (each, each)), model.bias).split(" = ")[0] for each in example.args]
    head = atom(name, [*roots, value if model.classes or "," not in value else f"[{value}]"])
    size = math.fsum(tree.values) if model.classes else tree.examples
    body = f" :- {_conjunction(query, model.bias)}, !" if query else ""
    yield f"{head}{body}.  % {leaf_text(tree, model).rsplit('[', 1)[1].rstrip(']')}" if size else f"{head}{body}."


def _conjunction(query: Query, bias: LanguageBias) -> str:
    return ", ".join(literal_text(each, bias) for each in query)


def _example(bias: LanguageBias) -> Literal:
    template = bias.actions[0]
    return Literal(template.name, tuple(Var(i) for i in range(len(template.types))))


def confusion(truth: np.ndarray, said: np.ndarray, classes: Sequence[Hashable]) -> str:
    """A table: a row for each true class, a column for what it was taken for. All are numbers of classes."""
    count = len(classes)
    cells = np.bincount(truth * count + said, minlength=count * count).reshape(count, count)
    names = [str(each) for each in classes]
    width = max(len(str(cells.max())), *map(len, names)) + 2
    first = max(len("is \\ said"), *map(len, names))
    lines = ["is \\ said".ljust(first) + "".join(name.rjust(width) for name in names)]
    for name, row in zip(names, cells, strict=True):
        lines.append(name.ljust(first) + "".join(str(cell).rjust(width) for cell in row))
    return "\n".join(lines)


def errors_text(truth: np.ndarray, said: np.ndarray) -> str:
    """The errors of numbers, shape (examples, targets), for each target."""
    lines = []
    for k, (own, other) in enumerate(zip(truth.T, said.T, strict=True), 1):
        off = own - other
        spread = float(((own - own.mean()) ** 2).sum())
        share = f"{1 - float((off**2).sum()) / spread:.4f}" if spread else "none, for all targets are equal"
        alike = np.corrcoef(own, other)[0, 1] if spread and other.std() else math.nan
        name = f"target {k}: " if truth.shape[1] > 1 else ""
        lines.append(
            f"{name}root mean squared error {math.sqrt(float((off**2).mean())):.6g}, mean absolute error "
            f"{float(np.abs(off).mean()):.6g}, R2 {share}" + ("" if math.isnan(alike) else f", correlation {alike:.4f}")
        )
    return "\n".join(lines)
