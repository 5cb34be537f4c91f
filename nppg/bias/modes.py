"""The section `modes`: the literals that a tree may test."""

from __future__ import annotations

import yaml

from nppg.bias.declarations import EQUALITY, Argument, Mode
from nppg.bias.literals import Parsed
from nppg.bias.nodes import Document
from nppg.bias.signatures import Signatures, wrong_arity
from nppg.errors import suggestion
from nppg.logic.query import OPEN

MODE_KEYS = ("literal", "lookahead")

Placed = list[tuple[Argument, int]]  # arguments with their offsets


def modes(document: Document, signatures: Signatures, node: yaml.Node | None, max_lookahead: int) -> tuple[Mode, ...]:
    """The mode declarations, each once."""
    nodes = document.items(node, "modes are a list of literals") if node else None
    if nodes == [] and node:
        document.report(node, "at least one mode is wanted")
    found: dict[str, Mode] = {}
    for each in nodes or ():
        literal, lookahead = each, 0
        if isinstance(each, yaml.MappingNode):
            entries = document.mapping(each, "a mode", MODE_KEYS)
            if "literal" not in entries:
                document.report(each, "the key 'literal' is missing")
                continue
            literal = entries["literal"]
            lookahead = document.whole(entries.get("lookahead"), "lookahead", 0)
            if lookahead > max_lookahead:
                message = f"lookahead {lookahead} is more than the file's general maximum, {max_lookahead}"
                document.report(entries["lookahead"], message)
        parsed = document.literal(literal, "a literal like on(+block, -block)")
        mode = _mode(document, signatures, literal, parsed, lookahead) if parsed else None
        if mode:
            earlier = found.setdefault(str(mode), mode)
            if earlier is not mode:
                document.report(literal, f"the mode {mode} is given twice (first on line {earlier.line})")
    return tuple(found.values())


def _mode(document: Document, signatures: Signatures, node: yaml.Node, parsed: Parsed, lookahead: int) -> Mode | None:
    name, args = parsed
    signatures.uses += [(arg.type, node, offset) for arg, offset in args if arg.type]
    if name in EQUALITY:
        types = _equal_types(document, node, args)
        name = "="
    elif name in OPEN:
        types = _bound_types(document, node, args)
    elif name not in signatures.types:
        if signatures.complete:
            document.report(node, f"{name!r} has no type declaration{suggestion(name, signatures.types)}")
        return None
    else:
        types = signatures.types[name]
        if types is not None and len(types) != len(args):
            document.report(node, wrong_arity(name, types, len(args)))
            return None
    if types is None:
        return None
    pairs = [(arg, wanted, offset) for (arg, offset), wanted in zip(args, types, strict=True)]
    signatures.check_fit(node, ((arg.type, wanted, offset) for arg, wanted, offset in pairs if arg.type))
    typed = tuple(Argument(arg.kind, arg.type or wanted, arg.constants) for arg, wanted, _ in pairs)
    return Mode(name, typed, lookahead, *document.place(node))


def _equal_types(document: Document, node: yaml.Node, args: Placed) -> tuple[str, ...] | None:
    """The types of equal/2, which its arguments name; a constant has the type of the other argument."""
    wrong = len(document.problems)
    if len(args) != 2:
        document.report(node, f"equal takes 2 arguments, not {len(args)}")
        return None
    for arg, offset in args:
        if arg.kind in ("-", "+-"):
            document.report(node, f"equal compares existing variables: write +{arg.type}, not {arg}", offset)
        elif arg.kind == "+" and not arg.type:
            document.report(node, "equal has no declared types: write the type, like +block", offset)
    if all(arg.kind == "#" for arg, _ in args):
        document.report(node, "equal compares a variable, like +block, with another or with a constant")
    if len(document.problems) > wrong:
        return None
    (left, _), (right, _) = args
    return left.type or right.type, right.type or left.type


def _bound_types(document: Document, node: yaml.Node, args: Placed) -> tuple[str, ...] | None:
    """The type of what is bounded; a threshold has the same."""
    term, offset = args[0] if args else (Argument("", ""), 0)
    if [arg.constants for arg, _ in args[1:]] not in [[(limit,)] for limit in OPEN.values()]:
        document.report(node, "=< and >= are built in: write +weight =< # for a threshold")
    elif not (term.kind == "+" and term.type):
        message = f"a threshold is for an existing variable of a type, like +weight, not {term}"
        document.report(node, message, offset)
    else:
        return term.type, term.type
    return None
