"""A YAML document as nodes with their places, and what is reported about them.

It is read with `yaml.compose`, never with `safe_load`: a node keeps its text, so that `on` stays a name and does not
become True, and its line and column, so that every mistake can be located.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

import yaml

from nppg.bias.literals import Mistake, Parsed, parsed
from nppg.bias.names import is_name, number
from nppg.errors import NppgError, Problem, suggestion

_DEEP = re.compile(r"(?:[\[{]\s*){50}")  # takes YAML's parser long
_MOST = 50  # problems that are told
_LONGEST = 500  # characters of one


class Document:
    """The text of one file, with the problems that were found in it, so that all are reported at once."""

    def __init__(self, file: str, source: str):
        self.file = file
        self.source = source
        self.problems: set[Problem] = set()

    def compose(self) -> yaml.Node:
        """The root node; what is no YAML is one located problem, since the parser cannot go on behind it."""
        line = column = 0
        if deep := _DEEP.search(self.source):
            line = self.source.count("\n", 0, deep.start()) + 1
            raise NppgError([Problem(self.file, line, 0, "nested too deeply")])
        try:
            node = yaml.compose(self.source, Loader=yaml.SafeLoader)
            if node is not None:
                return node
            message = "the file is empty"
        except yaml.reader.ReaderError as error:
            before = self.source[: error.position]
            line, column = before.count("\n") + 1, error.position - before.rfind("\n")
            message = f"the character {chr(error.character)!r} has no place in YAML"
        except yaml.MarkedYAMLError as error:
            if mark := error.problem_mark or error.context_mark:
                line, column = mark.line + 1, mark.column + 1
            message = "not YAML: " + " ".join(str(part) for part in (error.context, error.problem) if part)
            if "'\\t'" in message:
                message = "a tab: YAML is indented by spaces"
            elif "single document" in message:
                message = "a second YAML document begins here; a language bias is one"
        except (RecursionError, ValueError, OverflowError) as error:
            message = "nested too deeply" if isinstance(error, RecursionError) else f"not YAML: {error}"
        raise NppgError([Problem(self.file, line, column, " ".join(message.split()))])

    def place(self, node: yaml.Node, offset: int = 0) -> tuple[int, int]:
        """Line and column, from 1, of a node or of an offset in a scalar's text where that stands on one line."""
        start = node.start_mark
        if isinstance(node, yaml.ScalarNode):
            raw = self.source[start.index : node.end_mark.index]
            shift = raw.rfind(node.value)
            if shift >= 0 and "\n" not in raw:
                return start.line + 1, start.column + 1 + shift + offset
        return start.line + 1, start.column + 1

    def report(self, node: yaml.Node, message: str, offset: int = 0) -> None:
        """Notes a problem at a node, or at an offset in its text. Raises NppgError where there are many."""
        if len(message) > _LONGEST:
            message = f"{message[:_LONGEST]} ..."
        self.problems.add(Problem(self.file, *self.place(node, offset), message))
        if len(self.problems) >= _MOST:
            raise NppgError(sorted(self.problems))

    def mapping(self, node: yaml.Node, what: str, known: Collection[str] = ()) -> dict[str, yaml.Node]:
        """The entries of a mapping; its keys are checked against `known`, if given."""
        if not isinstance(node, yaml.MappingNode):
            self.report(node, f"{what} is a mapping (key: value), not {described(node)}")
            return {}
        entries: dict[str, yaml.Node] = {}
        first: dict[str, int] = {}
        for key_node, value in self._joined(node.value) if node.flow_style else node.value:
            key = self.text(key_node, "a key")
            if key is None:
                continue
            if key in first:
                self.report(key_node, f"the key {key!r} is given twice (first on line {first[key]})")
            elif known and key not in known:
                hint = suggestion(key, known) or f"; known are {', '.join(known)}"
                self.report(key_node, f"unknown key {key!r}{hint}")
            else:
                first[key], entries[key] = self.place(key_node)[0], value
        return entries

    def items(self, node: yaml.Node, what: str) -> list[yaml.Node] | None:
        """Those of a list; None where it is none, which is reported."""
        if isinstance(node, yaml.SequenceNode):
            pairs = [(each, each) for each in node.value]
            return [each for _, each in self._joined(pairs)] if node.flow_style else list(node.value)
        self.report(node, f"{what}, not {described(node)}")
        return None

    def _joined(self, pairs: Sequence[tuple[yaml.Node, yaml.Node]]) -> list[tuple[yaml.Node, yaml.Node]]:
        """What stands inside { }, where a comma ends a text, with the pieces of a literal put together up to its last
        bracket: all but the first are keys without a value. What stands inside [ ] is its own key."""
        found: list[tuple[yaml.Node, yaml.Node]] = []
        for key, value in pairs:
            is_piece = found and (key is value or described(value) == "nothing")
            whole = self._span(found[-1][1], key) if is_piece else None
            if whole:
                found[-1] = (found[-1][0], whole)
            else:
                found.append((key, value))
        return found

    def _span(self, first: yaml.Node, last: yaml.Node) -> yaml.Node | None:
        """Both as one text, if the first has a bracket that is yet to be closed and the last comes after its comma."""
        if not (_is_plain(first) and _is_plain(last) and first.value.count("(") > first.value.count(")")):
            return None
        between = self.source[first.end_mark.index : last.start_mark.index]
        if re.sub("#.*", "", between).strip() != ",":  # one of them is an alias, and stands elsewhere
            return None
        start = max(self.source.find(first.value, first.start_mark.index), first.start_mark.index)  # behind an anchor
        text = self.source[start : last.end_mark.index]
        if "\n" in text:
            text = f"{first.value}, {last.value}"
        return yaml.ScalarNode(first.tag, text, first.start_mark, last.end_mark)

    def text(self, node: yaml.Node, what: str) -> str | None:
        """That of a scalar; None where there is none, or what no text has, which is reported."""
        if not isinstance(node, yaml.ScalarNode) or not node.value.strip():
            self.report(node, f"{what} is wanted, not {described(node)}")
            return None
        value = str(node.value)
        for offset, char in enumerate(value):
            if not char.isprintable() and char != "\n":
                self.report(node, f"the character {char!r} has no place here", offset)
                return None
        return value

    def literal(self, node: yaml.Node, what: str) -> Parsed | None:
        """None where a mistake has been reported."""
        text = self.text(node, what)
        if text is None:
            return None
        try:
            return parsed(text)
        except Mistake as mistake:
            self.report(node, str(mistake), mistake.offset)
            return None

    def type_name(self, node: yaml.Node) -> str | None:
        """None where a mistake has been reported."""
        text = self.text(node, "a type")
        if text is not None and not is_name(text):
            self.report(node, f"a type is a lower-case name, not {text!r}")
            return None
        return text

    def whole(self, node: yaml.Node | None, key: str, default: int, otherwise: int = 0) -> int:
        """A whole number; `otherwise` stands for a wrong one, so that it causes no further reports."""
        if node is None:
            return default
        value = number(node.value) if isinstance(node, yaml.ScalarNode) else None
        if isinstance(value, int) and value >= 0:
            return value
        self.report(node, f"{key} is a whole number of at least 0, not {described(node)}")
        return otherwise


def _is_plain(node: yaml.Node) -> bool:
    """Whether it is a text without quotes."""
    return isinstance(node, yaml.ScalarNode) and not node.style


def described(node: yaml.Node) -> str:
    """What a node is, in a user's words."""
    if isinstance(node, yaml.ScalarNode):
        return repr(node.value) if node.value else "nothing"
    return "a list" if isinstance(node, yaml.SequenceNode) else "a mapping"
