"""Models in files: data, of which nothing is run. The first line says what it is, with the SHA-256 of the second."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from nppg.bias.declarations import Argument, Follower, Lookahead, Mode, OptionPlaces, Template, TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bridge.bounds import DATA
from nppg.bridge.files import replacing, sha256
from nppg.bridge.records import Kind, fields_of, table_of, value_of
from nppg.errors import NppgError, Problem
from nppg.logic.query import OPEN, Literal, Query, Real, Var
from nppg.tilde.knowledge import Knowledge
from nppg.tilde.model import Model
from nppg.trees.tree import Leaf, Node, Tree

_WHAT = "a model of nppg tilde"
_FORMAT = 1
_KINDS = [
    *fields_of(Model, Leaf, Node, Literal, Var),
    *fields_of(LanguageBias, Template, Mode, Argument, Follower, Lookahead, TreeLimits, OptionPlaces),
    Kind(Real, lambda value: (float(value),), Real),
]


def write_model(path: Path, model: Model) -> None:
    """Writes a model. Raises NppgError where that is not possible."""
    body = json.dumps(table_of(model, _KINDS), separators=(",", ":"))
    head = json.dumps({"nppg": _WHAT, "format": _FORMAT, "sha256": sha256(body.encode())})
    replacing(path, lambda file: file.write_text(f"{head}\n{body}\n", encoding="utf-8"))


def read_model(path: Path) -> Model:
    """The model in a file. Raises NppgError for what is none, or is damaged."""
    try:
        if path.stat().st_size > DATA:
            raise _wrong(path, f"has more than {DATA:,} bytes")
        head, body, *_ = [*path.read_text(encoding="utf-8").split("\n"), ""]
        told = json.loads(head)
        if not isinstance(told, dict) or told.get("nppg") != _WHAT:
            raise ValueError
    except OSError as error:
        raise _wrong(path, f"cannot be read: {error.strerror}") from None
    except (ValueError, RecursionError):
        raise _wrong(path, f"is not {_WHAT}") from None
    if told.get("format") != _FORMAT:
        raise _wrong(path, f"has the format {told.get('format')}, which this version does not read")
    if told.get("sha256") != sha256(body.encode()):
        raise _wrong(path, "is damaged: its checksum is wrong")
    try:
        model = value_of(json.loads(body), _KINDS)
        if not isinstance(model, Model) or not isinstance(model.bias, LanguageBias) or not model.trees:
            raise ValueError
        known = {*Knowledge.asked(model.bias)}
        for tree in model.trees:
            _check(tree, lambda literal: (literal.name, len(literal.args)) in known)
    except (ValueError, TypeError, LookupError, ArithmeticError, AttributeError, RecursionError):
        raise _wrong(path, "holds something else than a model") from None
    return model


def _check(tree: Tree, may_ask: Callable[[Literal], bool]) -> None:
    """Raises ValueError for what is no tree, or asks what the bias does not declare."""
    if isinstance(tree, Leaf):
        if not isinstance(tree.value, float) or not all(isinstance(each, float) for each in tree.values):
            raise ValueError
        return
    for query in (tree.literals, *tree.tests):
        if not _is_query(query) or not all(each.name in ("=", *OPEN) or may_ask(each) for each in query):
            raise ValueError
    _check(tree.yes, may_ask)
    _check(tree.no, may_ask)


def _is_query(query: Query) -> bool:
    def is_literal(each: Literal) -> bool:
        return isinstance(each, Literal) and all(isinstance(arg, Var | str | int | float) for arg in each.args)

    return all(map(is_literal, query))


def _wrong(path: Path, message: Any) -> NppgError:
    return NppgError([Problem(str(path), 0, 0, message)])
