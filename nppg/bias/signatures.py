"""The types of predicates, the types above them, and whether what the modes name fits."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

import yaml

from nppg.bias.declarations import EQUALITY, Template, upwards
from nppg.bias.names import atom, is_name
from nppg.bias.nodes import Document
from nppg.errors import suggestion
from nppg.logic.query import OPEN


class Signatures:
    """What the sections `types` and `subtypes` say, and what else turns out as the file is read."""

    def __init__(self, document: Document, types: yaml.Node | None, subtypes: yaml.Node | None):
        self.document = document
        self.types: dict[str, tuple[str, ...] | None] = {}  # None: declared, but not readable
        self.subtypes: dict[str, str] = {}
        self.complete = isinstance(types, yaml.MappingNode)  # so what is missing there is a mistake
        self.uses: list[tuple[str, yaml.Node, int]] = []  # types that modes name, with their places
        self._read_types(types)
        self._read_subtypes(subtypes)
        self._declared = {name for types in self.types.values() for name in types or ()}
        self._declared |= {*self.subtypes, *self.subtypes.values()}

    def _read_types(self, node: yaml.Node | None) -> None:
        entries = self.document.mapping(node, "types") if node else {}
        for name, value in entries.items():
            if name in EQUALITY:
                message = "equal/2 is built in and has no type declaration: its modes name the types"
                self.document.report(value, message)
            elif name in OPEN:
                message = f"{name} is built in and has no type declaration: its modes name the type"
                self.document.report(value, message)
            nodes = self.document.items(value, f"the types of {name!r} are a list, like [block, place]")
            types = [self.document.type_name(each) for each in nodes or ()]
            self.types[name] = None if nodes is None or None in types else tuple(each for each in types if each)

    def _read_subtypes(self, node: yaml.Node | None) -> None:
        entries = self.document.mapping(node, "subtypes") if node else {}
        for name, value in entries.items():
            above = self.document.type_name(value)
            if not is_name(name):
                self.document.report(value, f"a type is a lower-case name, not {name!r}")
            elif above is not None:
                self.subtypes[name] = above
        for name in self.subtypes:
            chain = upwards(self.subtypes, name)
            if self.subtypes.get(chain[-1]) == name == min(chain, key=list(self.subtypes).index):
                self.document.report(entries[name], f"the subtypes form a cycle: {' < '.join([*chain, name])}")

    def check_fit(self, node: yaml.Node, pairs: Iterable[tuple[str, str, int]]) -> None:
        """Reports each type that is not the one that is declared in its place, nor below that; `pairs` are both, with
        the offset in the node's text."""
        known = {name for types in self.types.values() for name in types or ()}.union(*self.subtypes.items())
        for type_, wanted, offset in pairs:
            if type_ in known and wanted not in upwards(self.subtypes, type_):
                message = f"the type {type_!r} is neither {wanted!r}, as declared, nor a subtype of it"
                self.document.report(node, message, offset)

    def check_uses(self, templates: Sequence[tuple[yaml.Node, Template]]) -> None:
        """Reports types that are declared nowhere. A template declares types for the modes and for the other
        templates but not for itself: an argument that nothing can look at is a slip of the pen."""
        if not self.complete:
            return
        known = self._declared.union(*(template.types for _, template in templates))
        for name, node, offset in self.uses:
            if name not in known:
                self.document.report(node, f"the type {name!r} is declared nowhere{suggestion(name, known)}", offset)
        used = self._declared | {name for name, _, _ in self.uses}
        for node, template in templates:
            others = used.union(*(other.types for _, other in templates if other is not template))
            for name in template.types:
                if name not in others:
                    match = re.search(rf"[^\w]({name})\b", str(node.value))
                    message = f"the type {name!r} is used nowhere else{suggestion(name, others)}"
                    self.document.report(node, message, match.start(1) if match else 0)


def wrong_arity(name: str, declared: Sequence[str], given: int) -> str:
    """The message that a literal has another number of arguments than is declared."""
    plural = "" if len(declared) == 1 else "s"
    return f"{name} takes {len(declared)} argument{plural}, {atom(name, declared)}, not {given}"
