"""The sections `action` and `goal`: templates, which declare their own types."""

from __future__ import annotations

import yaml

from nppg.bias.declarations import Template
from nppg.bias.names import is_name
from nppg.bias.nodes import Document
from nppg.bias.signatures import Signatures, wrong_arity


def actions(document: Document, signatures: Signatures, node: yaml.Node | None) -> list[tuple[yaml.Node, Template]]:
    """The templates of one kind of action, or of a list of kinds, with their places."""
    if node is None:
        return []
    several = isinstance(node, yaml.SequenceNode)
    nodes = document.items(node, "actions") or [] if several else [node]
    if not nodes:
        document.report(node, "at least one action is wanted")
    found: dict[str, tuple[yaml.Node, Template]] = {}
    for each in nodes:
        template = _template(document, signatures, each, "action", bare=several)
        if template and template.name in found:
            document.report(each, f"the action {template.name} is given twice")
        elif template:
            found[template.name] = (each, template)
    return list(found.values())


def goal(document: Document, signatures: Signatures, node: yaml.Node | None) -> list[tuple[yaml.Node, Template]]:
    """The template of the goal with its place, if there is one."""
    template = _template(document, signatures, node, "goal") if node else None
    return [(node, template)] if node and template else []


def _template(
    document: Document, signatures: Signatures, node: yaml.Node, key: str, bare: bool = False
) -> Template | None:
    """`bare`: a name without arguments will do."""
    sign, example = {"action": ("+", "move(+block, +place)"), "goal": ("-", "goal_on(-block, -block)")}[key]
    parsed = document.literal(node, f"a template like {example}")
    if parsed is None:
        return None
    name, args = parsed
    if not args and not bare:
        hint = f": an action without arguments stands in a list, [{name}]" if key == "action" else ""
        document.report(node, f"the {key} is a template with arguments, like {example}, not {name!r}{hint}")
        return None
    types = []
    for arg, offset in args:
        type_ = arg.type if arg.kind == sign else str(arg)  # a bare type has been read as a constant
        if is_name(type_):
            types.append(type_)
        else:
            message = f"an argument of the {key} is {sign} and a type, like {sign}block, not {arg}"
            document.report(node, message, offset)
    if len(types) < len(args):
        return None
    declared = signatures.types.setdefault(name, tuple(types))
    if declared is not None:
        if len(declared) != len(types):
            document.report(node, wrong_arity(name, declared, len(types)))
        else:
            signatures.check_fit(node, zip(types, declared, (offset for _, offset in args), strict=True))
    return Template(name, tuple(types), *document.place(node))
