"""The language bias: which literals a tree may test, with which types, and when a tree stops growing.

A bias is a YAML file in the terms of ACE (`type`, `rmode`, `lookahead`); docs/language_bias.md is its
reference. The file is read with `yaml.compose`, never with `safe_load`: a node keeps its text, so that `on`
stays a name and does not become True, and its line and column, so that every mistake can be located.
"""

from __future__ import annotations

import hashlib
import math
import re
import sys
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from itertools import accumulate
from pathlib import Path
from typing import NamedTuple, TypeVar

import yaml

from nppg.errors import NppgError, Problem, suggestion
from nppg.logic.query import OPEN, Constant, Real

MIN_VARIANCE = 1e-9  # the default, which alone is in the square of the targets' unit
KEYS = ("action", "goal", "subtypes", "types", "modes", "lookahead", "max_variables", "tree", "sentences")
REQUIRED = ("action", "types", "modes")
RESERVED = ("delta", 3)
MODE_KEYS = ("literal", "lookahead")
EQUALITY = ("equal", "=")  # its name in a file, and in Prolog
PLACEHOLDER = re.compile(r"\{([1-9][0-9]{0,2})\}")  # in a sentence, for the argument of that number

Item = TypeVar("Item")


@dataclass(frozen=True, slots=True)
class Argument:
    """One argument of a mode declaration; prints as it is written in the file."""

    kind: str  # "+" existing variable, "-" new variable, "+-" either, "#" one of `constants`
    type: str
    constants: tuple[Constant, ...] = ()

    def __str__(self) -> str:
        if self.kind != "#":
            return f"{self.kind}{self.type}"
        items = ", ".join(map(written, self.constants))
        return items if len(self.constants) == 1 else f"[{items}]"


@dataclass(frozen=True, slots=True)
class Mode:
    """A literal that a tree may test; prints as it is written in the file. Its place is no part of its identity."""

    name: str  # "=" for the built-in equal/2, "=<" or ">=" for a bound, whose threshold is OPEN
    args: tuple[Argument, ...]
    lookahead: int = 0  # how many further literals a test that starts with this one may add at once
    line: int = field(default=0, compare=False)
    column: int = field(default=0, compare=False)

    def __str__(self) -> str:
        if self.name in OPEN:
            return f"{self.args[0]} {self.name} #"
        return _atom("equal" if self.name == "=" else written(self.name), self.args)


@dataclass(frozen=True, slots=True)
class Template:
    """The form of one kind of action, or of the goal."""

    name: str
    types: tuple[str, ...]  # of its arguments
    line: int = field(default=0, compare=False)
    column: int = field(default=0, compare=False)

    def __str__(self) -> str:
        return _atom(written(self.name), self.types)


@dataclass(frozen=True, slots=True)
class TreeLimits:
    """When a tree stops growing. Raises NppgError, naming the field, for a value that cannot be."""

    max_depth: int = 4  # tests on the longest path; 0: the tree is one leaf
    min_examples: int = 2  # "minimal cases": each leaf holds at least so many examples
    min_variance: float = MIN_VARIANCE  # a node whose targets have less variance is a leaf
    significance: float = 1.0  # level of the F-test that a split must pass (ACE's ftest); 1.0 switches it off
    granularity: int = 0  # at most so many thresholds of a bound are tried at a node, quantiles of its examples; 0: all

    def __post_init__(self) -> None:
        whole = (("max_depth", 0), ("min_examples", 1), ("granularity", 0))
        wrong = [
            f"{name} must be a whole number of at least {least}, not {value!r}"
            for name, least in whole
            if type(value := getattr(self, name)) is not int or value < least
        ]
        if not (_is_number(self.min_variance) and 0 <= self.min_variance < math.inf):
            wrong.append(f"min_variance must be a finite number of at least 0, not {self.min_variance!r}")
        if not (_is_number(self.significance) and 0 < self.significance <= 1):
            wrong.append(f"significance must be a number above 0 and at most 1, not {self.significance!r}")
        if wrong:
            raise NppgError(Problem("", 0, 0, message) for message in wrong)

    def least_variance(self, unit: float) -> float:
        """`min_variance`; that of who states none is in the square of the targets' unit."""
        return self.min_variance * unit * unit if self.min_variance == MIN_VARIANCE else self.min_variance


@dataclass(frozen=True)
class LanguageBias:
    """The contents of one bias file."""

    file: str
    actions: tuple[Template, ...]  # one for each kind of action
    goal: Template | None
    types: Mapping[str, tuple[str, ...]]  # predicate -> argument types; the action's and the goal's too
    subtypes: Mapping[str, str]  # type -> its direct supertype
    modes: tuple[Mode, ...]
    max_lookahead: int  # of any mode
    max_variables: int  # existential variables in one query
    tree: TreeLimits
    sentences: Mapping[str, str] = field(default_factory=dict)  # predicate -> its literals in plain English
    source: bytes = field(default=b"", compare=False, repr=False)  # the file's contents; none for a bias without one

    @property
    def hash(self) -> str:
        """SHA-256 of the file as it was loaded, in hexadecimal."""
        return hashlib.sha256(self.source).hexdigest()

    @cached_property
    def roots(self) -> tuple[str, ...]:
        """The types of the root variables: the arguments of each kind of action, then the goal's."""
        templates = [*self.actions, self.goal] if self.goal else self.actions
        return tuple(type_ for template in templates for type_ in template.types)

    @cached_property
    def offsets(self) -> tuple[int, ...]:
        """The number of the first root variable of each kind of action, and of the goal."""
        return tuple(accumulate((len(action.types) for action in self.actions), initial=0))

    def fits(self, type_: str, wanted: str) -> bool:
        """Whether a variable of `type_` may stand where `wanted` is asked for: the same type, or one below it."""
        return wanted in _upwards(self.subtypes, type_)

    @classmethod
    def load(cls, path: str | Path) -> LanguageBias:
        """Reads a bias file. Raises NppgError with all its mistakes, located and in file order."""
        data = _read(path)
        return replace(_Reader(str(path), _text(path, data)).bias(), source=data)

    @classmethod
    def parse(cls, text: str, file: str) -> LanguageBias:
        """Reads the text of a bias file; `file` is what it is called. Raises NppgError like `load`."""
        return replace(_Reader(file, text).bias(), source=text.encode())

    def check(self, predicates: Collection[tuple[str, int]], actions: Collection[tuple[str, int]]) -> list[Problem]:
        """What the bias names and the domain does not have; `predicates` and `actions` are pairs of name and arity.

        No `actions` means that they cannot be told without running the domain."""
        problems = []

        def look_up(what: str, item: Mode | Template, arity: int, known: Collection[tuple[str, int]]) -> None:
            if (item.name, arity) not in known:
                message = f"the domain has no {what} {item.name}/{arity}{_near(item.name, known)}"
                problems.append(Problem(self.file, item.line, item.column, message))

        for action in self.actions if actions else ():
            look_up("action", action, len(action.types), actions)
        if self.goal:
            look_up("predicate", self.goal, len(self.goal.types), predicates)
        for mode in self.modes:
            if (mode.name, len(mode.args)) == RESERVED:
                message = "delta/3 is what the rules of a model are called; give the predicate another name"
                problems.append(Problem(self.file, mode.line, mode.column, message))
            elif mode.name != "=" and mode.name not in OPEN:
                look_up("predicate", mode, len(mode.args), predicates)
        return sorted(problems)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _near(name: str, known: Collection[tuple[str, int]]) -> str:
    same = ", ".join(f"{name}/{arity}" for other, arity in sorted(known) if other == name)
    return f" (it has {same})" if same else suggestion(name, (other for other, _ in known))


def _upwards(subtypes: Mapping[str, str], type_: str) -> list[str]:
    """A type and all above it, each once."""
    chain = [type_]
    while (above := subtypes.get(chain[-1])) is not None and above not in chain:
        chain.append(above)
    return chain


def _is_name(text: str) -> bool:
    """Whether Prolog reads the text as an atom without quotes."""
    return bool(re.fullmatch(r"[^\W\d_]\w*", text)) and not text[0].isupper() and not text[0].istitle()


def written(constant: Constant) -> str:
    if not isinstance(constant, str):
        return repr(constant)
    if _is_name(constant):
        return constant
    return "'" + constant.replace("\\", "\\\\").replace("'", "''") + "'"


def _atom(name: str, args: Sequence[object]) -> str:
    return f"{name}({', '.join(map(str, args))})" if args else name


# ---------------------------------------------------------------- the text of one literal


class _Mistake(Exception):
    """A mistake at an offset in a literal's text."""

    def __init__(self, offset: int, message: str):
        super().__init__(message)
        self.offset = offset


class _Token(NamedTuple):
    kind: str
    text: str
    offset: int


_TOKEN = re.compile(
    r"""(?P<space> \s+)
      | (?P<number> -?[0-9]+ (?:\.[0-9]+)? (?:[eE][+-]?[0-9]+)? (?!\w))
      | (?P<quoted> '(?: [^'\\] | '' | \\[\\'] )*')
      | (?P<name> \w+)
      | (?P<sign> \+-? | -)
      | (?P<bound> =< | >=)
      | (?P<mark> [()\[\],\#])""",
    re.VERBOSE,
)
_HINTS = {
    "=": ": equality is written equal(+type, +type)",
    "<": ": a threshold is written +type =< # or +type >= #",
    ">": ": a threshold is written +type =< # or +type >= #",
    "'": ": the quoted atom does not end",
    '"': ": an atom is quoted by '",
}


class _Parser:
    """Reads `name(argument, ...)`. A left-out type is the empty text; arguments come with their offsets."""

    def __init__(self, text: str):
        self.tokens = list(self.scan(text))

    @staticmethod
    def scan(text: str) -> Iterator[_Token]:
        offset = 0
        while offset < len(text):
            match = _TOKEN.match(text, offset)
            if not match:
                raise _Mistake(offset, f"{text[offset]!r} has no place in a literal{_HINTS.get(text[offset], '')}")
            if match.lastgroup != "space":
                yield _Token(str(match.lastgroup), match[0], offset)
            offset = match.end()
        yield _Token("end", "", len(text))

    @property
    def next(self) -> _Token:
        return self.tokens[0]

    def literal(self) -> tuple[str, list[tuple[Argument, int]]]:
        if self.next.kind == "sign":
            return self.bound()
        at, name = self.next.offset, self.constant("a name")
        if not isinstance(name, str):
            raise _Mistake(at, f"a name is wanted, not the number {name}")
        args = self.sequence(")", self.argument) if self.next.text == "(" else []
        if self.next.kind != "end":
            raise self.unexpected("the end of the literal")
        return name, args

    def bound(self) -> tuple[str, list[tuple[Argument, int]]]:
        term = self.argument()
        if self.next.kind != "bound":
            raise self.unexpected("=< or >=, as in +weight =< #,")
        name = self.tokens.pop(0).text
        if self.next.text != "#":
            hint = ": YAML ends a text at ' #', unless it is in quotes" if self.next.kind == "end" else ""
            raise _Mistake(self.next.offset, f"# is wanted, a threshold that is found from the examples{hint}")
        at = self.tokens.pop(0).offset
        if self.next.kind != "end":
            raise self.unexpected("the end of the literal")
        return name, [term, (Argument("#", "", (OPEN[name],)), at)]

    def sequence(self, end: str, item: Callable[[], Item]) -> list[Item]:
        self.tokens.pop(0)
        items: list[Item] = []
        while self.next.text != end or items:
            items.append(item())
            if self.next.text == end:
                break
            if self.next.text != ",":
                raise self.unexpected(f"',' or '{end}'")
            self.tokens.pop(0)
        self.tokens.pop(0)
        return items

    def argument(self) -> tuple[Argument, int]:
        first = self.next
        if first.kind == "sign":
            self.tokens.pop(0)
            kind, type_ = first.text, ""
            if self.next.kind == "name":
                type_ = self.tokens.pop(0).text
                if not _is_name(type_):
                    raise _Mistake(first.offset, f"a type is a lower-case name, not {type_!r}")
            return Argument(kind, type_), first.offset
        if first.text != "[":
            return Argument("#", "", (self.constant("an argument"),)), first.offset
        constants = tuple(self.sequence("]", lambda: self.constant("a constant")))
        if not constants:
            raise _Mistake(first.offset, "the set of constants is empty")
        if len(set(map(written, constants))) < len(constants):
            raise _Mistake(first.offset, "the set of constants holds one of them twice")
        return Argument("#", "", constants), first.offset

    def constant(self, wanted: str) -> Constant:
        token = self.next
        if token.text == "#":
            hint = "write a set of constants as [a, b], without #"
            raise _Mistake(token.offset, f"'#' has no place in a literal: {hint}")
        if token.kind not in ("number", "quoted", "name"):
            raise self.unexpected(wanted)
        self.tokens.pop(0)
        if wanted != "a name" and self.next.text == "(":
            raise _Mistake(token.offset, f"nested terms are not possible: {token.text}(...) can be no argument")
        if token.kind == "quoted":
            return re.sub(r"''|\\(.)", lambda match: match[1] or "'", token.text[1:-1])
        if token.kind == "number":
            return self.number(token)
        if not _is_name(token.text):
            raise _Mistake(
                token.offset,
                f"{token.text!r} is no lower-case name: write a variable as + or - and its type (+block), "
                f"an atom in quotes ('{token.text}')",
            )
        return token.text

    @staticmethod
    def number(token: _Token) -> int | float:
        try:
            value = float(token.text)
            if math.isinf(value):
                raise ValueError
            return int(token.text) if re.fullmatch(r"-?[0-9]+", token.text) else Real(value)
        except ValueError:
            raise _Mistake(token.offset, "the number is too large") from None

    def unexpected(self, wanted: str) -> _Mistake:
        if self.next.kind != "end":
            return _Mistake(self.next.offset, f"{wanted} is wanted, not {self.next.text!r}")
        hint = ": YAML ends a text at ' #', and inside { } or [ ] at a comma, unless it is in quotes"
        return _Mistake(self.next.offset, f"{wanted} is wanted, but the literal ends here{hint}")


# ---------------------------------------------------------------- the file


def _read(path: str | Path) -> bytes:
    try:
        return Path(path).read_bytes()
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise NppgError([Problem(str(path), 0, 0, f"cannot be read: {reason}")]) from None


def _text(path: str | Path, data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        lines = data[: error.start].decode("utf-8-sig").split("\n")
        line, column = len(lines), len(lines[-1]) + 1
        raise NppgError([Problem(str(path), line, column, f"not UTF-8: byte 0x{data[error.start]:02x}")]) from None


def _kind(node: yaml.Node) -> str:
    """What a node is, in a user's words."""
    if isinstance(node, yaml.ScalarNode):
        return repr(node.value) if node.value else "nothing"
    return "a list" if isinstance(node, yaml.SequenceNode) else "a mapping"


def _number(text: str) -> int | float | None:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return None


class _Reader:
    """Reads one file and gathers its problems, so that all are reported at once."""

    def __init__(self, file: str, text: str):
        self.file = file
        self.source = text
        self.problems: set[Problem] = set()
        self.types: dict[str, tuple[str, ...] | None] = {}  # None: declared, but not readable
        self.subtypes: dict[str, str] = {}
        self.complete = True  # the declarations could be read, so what is missing there is a mistake
        self.uses: list[tuple[str, yaml.Node, int]] = []  # types that modes name, with their places

    def bias(self) -> LanguageBias:
        root = self.compose()
        entries = self.mapping(root, "a language bias", KEYS)
        if isinstance(root, yaml.MappingNode):
            for key in REQUIRED:
                if key not in entries:
                    self.report(root, f"the key '{key}' is missing")
        self.read_types(entries.get("types"))
        self.read_subtypes(entries.get("subtypes"))
        declared = {name for types in self.types.values() for name in types or ()}
        declared |= {*self.subtypes, *self.subtypes.values()}
        before = len(self.problems)
        actions = self.actions(entries.get("action"))
        goal = self.template(entries.get("goal"), "goal", "-")
        all_known = self.complete and "action" in entries and len(self.problems) == before
        max_lookahead = self.whole(entries.get("lookahead"), "lookahead", 0, otherwise=sys.maxsize)
        max_variables = self.whole(entries.get("max_variables"), "max_variables", 4)
        modes = self.modes(entries.get("modes"), max_lookahead)
        tree = self.tree(entries.get("tree"))
        sentences = self.sentences(entries.get("sentences"), self.types if all_known else ())
        self.check_types(declared, [*actions, (entries["goal"], goal)] if goal else actions)
        if self.problems:
            raise NppgError(sorted(self.problems))
        types = {name: types for name, types in self.types.items() if types is not None}
        templates = tuple(template for _, template in actions)
        return LanguageBias(
            self.file, templates, goal, types, self.subtypes, modes, max_lookahead, max_variables, tree, sentences
        )

    # -------------------------------------------------- nodes

    def compose(self) -> yaml.Node:
        """The root node; what is no YAML is one located problem, since the parser cannot go on behind it."""
        line = column = 0
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
        self.problems.add(Problem(self.file, *self.place(node, offset), message))

    def mapping(self, node: yaml.Node, what: str, known: Collection[str] = ()) -> dict[str, yaml.Node]:
        """The entries of a mapping; its keys are checked against `known`, if given."""
        if not isinstance(node, yaml.MappingNode):
            self.report(node, f"{what} is a mapping (key: value), not {_kind(node)}")
            return {}
        entries: dict[str, yaml.Node] = {}
        first: dict[str, int] = {}
        for key_node, value in node.value:
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
        if isinstance(node, yaml.SequenceNode):
            return list(node.value)
        self.report(node, f"{what}, not {_kind(node)}")
        return None

    def text(self, node: yaml.Node, what: str) -> str | None:
        if not isinstance(node, yaml.ScalarNode) or not node.value.strip():
            self.report(node, f"{what} is wanted, not {_kind(node)}")
            return None
        value = str(node.value)
        for offset, char in enumerate(value):
            if not char.isprintable() and char != "\n":
                self.report(node, f"the character {char!r} has no place here", offset)
                return None
        return value

    def type_name(self, node: yaml.Node) -> str | None:
        text = self.text(node, "a type")
        if text is not None and not _is_name(text):
            self.report(node, f"a type is a lower-case name, not {text!r}")
            return None
        return text

    def whole(self, node: yaml.Node | None, key: str, default: int, otherwise: int = 0) -> int:
        """A whole number; `otherwise` stands for a wrong one, so that it causes no further reports."""
        if node is None:
            return default
        value = _number(node.value) if isinstance(node, yaml.ScalarNode) else None
        if isinstance(value, int) and value >= 0:
            return value
        self.report(node, f"{key} is a whole number of at least 0, not {_kind(node)}")
        return otherwise

    # -------------------------------------------------- types

    def read_types(self, node: yaml.Node | None) -> None:
        self.complete = isinstance(node, yaml.MappingNode)
        entries = self.mapping(node, "types") if node else {}
        for name, value in entries.items():
            if name in EQUALITY:
                self.report(value, "equal/2 is built in and has no type declaration: its modes name the types")
            elif name in OPEN:
                self.report(value, f"{name} is built in and has no type declaration: its modes name the type")
            nodes = self.items(value, f"the types of {name!r} are a list, like [block, place]")
            types = [self.type_name(each) for each in nodes or ()]
            self.types[name] = None if nodes is None or None in types else tuple(each for each in types if each)

    def read_subtypes(self, node: yaml.Node | None) -> None:
        entries = self.mapping(node, "subtypes") if node else {}
        for name, value in entries.items():
            above = self.type_name(value)
            if not _is_name(name):
                self.report(value, f"a type is a lower-case name, not {name!r}")
            elif above is not None:
                self.subtypes[name] = above
        for name in self.subtypes:
            chain = _upwards(self.subtypes, name)
            if self.subtypes.get(chain[-1]) == name == min(chain, key=list(self.subtypes).index):
                self.report(entries[name], f"the subtypes form a cycle: {' < '.join([*chain, name])}")

    def check_types(self, declared: set[str], templates: Iterable[tuple[yaml.Node, Template]]) -> None:
        """Reports types that are declared nowhere. A template declares types for the modes and for the other
        template but not for itself: an argument that nothing can look at is a slip of the pen."""
        if not self.complete:
            return
        templates = list(templates)
        known = declared.union(*(template.types for _, template in templates))
        for name, node, offset in self.uses:
            if name not in known:
                self.report(node, f"the type {name!r} is declared nowhere{suggestion(name, known)}", offset)
        used = declared | {name for name, _, _ in self.uses}
        for node, template in templates:
            others = used.union(*(other.types for _, other in templates if other is not template))
            for name in template.types:
                if name not in others:
                    match = re.search(rf"[^\w]({name})\b", str(node.value))
                    message = f"the type {name!r} is used nowhere else{suggestion(name, others)}"
                    self.report(node, message, match.start(1) if match else 0)

    # -------------------------------------------------- literals

    def parse(self, node: yaml.Node, what: str) -> tuple[str, list[tuple[Argument, int]]] | None:
        text = self.text(node, what)
        if text is None:
            return None
        try:
            return _Parser(text).literal()
        except _Mistake as mistake:
            self.report(node, str(mistake), mistake.offset)
            return None

    def actions(self, node: yaml.Node | None) -> list[tuple[yaml.Node, Template]]:
        """The templates of one kind of action, or of a list of kinds, with their places."""
        if node is None:
            return []
        several = isinstance(node, yaml.SequenceNode)
        nodes = self.items(node, "actions") or [] if several else [node]
        if not nodes:
            self.report(node, "at least one action is wanted")
        found: dict[str, tuple[yaml.Node, Template]] = {}
        for each in nodes:
            template = self.template(each, "action", "+", bare=several)
            if template and template.name in found:
                self.report(each, f"the action {template.name} is given twice")
            elif template:
                found[template.name] = (each, template)
        return list(found.values())

    def template(self, node: yaml.Node | None, key: str, sign: str, bare: bool = False) -> Template | None:
        """`bare`: a name without arguments will do."""
        example = {"action": "move(+block, +place)", "goal": "goal_on(-block, -block)"}[key]
        parsed = self.parse(node, f"a template like {example}") if node else None
        if node is None or parsed is None:
            return None
        name, args = parsed
        if not args and not bare:
            self.report(node, f"the {key} is a template with arguments, like {example}, not {name!r}")
            return None
        types = []
        for arg, offset in args:
            type_ = arg.type if arg.kind == sign else str(arg)  # a bare type has been read as a constant
            if _is_name(type_):
                types.append(type_)
            else:
                self.report(node, f"an argument of the {key} is {sign} and a type, like {sign}block, not {arg}", offset)
        if len(types) < len(args):
            return None
        declared = self.types.setdefault(name, tuple(types))
        if declared is not None:
            if len(declared) != len(types):
                self.report(node, self.wrong_arity(name, declared, len(types)))
            else:
                self.check_fit(node, zip(types, declared, (offset for _, offset in args), strict=True))
        return Template(name, tuple(types), *self.place(node))

    @staticmethod
    def wrong_arity(name: str, declared: Sequence[str], given: int) -> str:
        plural = "" if len(declared) == 1 else "s"
        return f"{name} takes {len(declared)} argument{plural}, {_atom(name, declared)}, not {given}"

    def check_fit(self, node: yaml.Node, pairs: Iterable[tuple[str, str, int]]) -> None:
        known = {name for types in self.types.values() for name in types or ()}.union(*self.subtypes.items())
        for type_, wanted, offset in pairs:
            if type_ in known and wanted not in _upwards(self.subtypes, type_):
                self.report(node, f"the type {type_!r} is neither {wanted!r}, as declared, nor a subtype of it", offset)

    def modes(self, node: yaml.Node | None, max_lookahead: int) -> tuple[Mode, ...]:
        nodes = self.items(node, "modes are a list of literals") if node else None
        if nodes == [] and node:
            self.report(node, "at least one mode is wanted")
        modes: dict[str, Mode] = {}
        for each in nodes or ():
            literal, lookahead = each, 0
            if isinstance(each, yaml.MappingNode):
                entries = self.mapping(each, "a mode", () if self.is_cut(each) else MODE_KEYS)
                if "literal" not in entries:
                    self.report(each, "the key 'literal' is missing")
                    continue
                literal = entries["literal"]
                lookahead = self.whole(entries.get("lookahead"), "lookahead", 0)
                if lookahead > max_lookahead:
                    message = f"lookahead {lookahead} is more than the file's general maximum, {max_lookahead}"
                    self.report(entries["lookahead"], message)
            parsed = self.parse(literal, "a literal like on(+block, -block)")
            mode = self.mode(literal, *parsed, lookahead) if parsed else None
            if mode:
                earlier = modes.setdefault(str(mode), mode)
                if earlier is not mode:
                    self.report(literal, f"the mode {mode} is given twice (first on line {earlier.line})")
        return tuple(modes.values())

    @staticmethod
    def is_cut(node: yaml.MappingNode) -> bool:
        """Whether a comma inside { } has cut a literal in two; then its second half is not worth a report."""
        return any(
            isinstance(value, yaml.ScalarNode) and value.value.count("(") > value.value.count(")")
            for _, value in node.value
        )

    def mode(self, node: yaml.Node, name: str, args: list[tuple[Argument, int]], lookahead: int) -> Mode | None:
        self.uses += [(arg.type, node, offset) for arg, offset in args if arg.type]
        if name in EQUALITY:
            types = self.equal_types(node, args)
            name = "="
        elif name in OPEN:
            types = self.bound_types(node, args)
        elif name not in self.types:
            if self.complete:
                self.report(node, f"{name!r} has no type declaration{suggestion(name, self.types)}")
            return None
        else:
            types = self.types[name]
            if types is not None and len(types) != len(args):
                self.report(node, self.wrong_arity(name, types, len(args)))
                return None
        if types is None:
            return None
        self.check_fit(
            node, ((arg.type, wanted, offset) for (arg, offset), wanted in zip(args, types, strict=True) if arg.type)
        )
        typed = tuple(
            Argument(arg.kind, arg.type or wanted, arg.constants) for (arg, _), wanted in zip(args, types, strict=True)
        )
        return Mode(name, typed, lookahead, *self.place(node))

    def equal_types(self, node: yaml.Node, args: list[tuple[Argument, int]]) -> tuple[str, ...] | None:
        """The types of equal/2, which its arguments name; a constant has the type of the other argument."""
        wrong = len(self.problems)
        if len(args) != 2:
            self.report(node, f"equal takes 2 arguments, not {len(args)}")
            return None
        for arg, offset in args:
            if arg.kind in ("-", "+-"):
                self.report(node, f"equal compares existing variables: write +{arg.type}, not {arg}", offset)
            elif arg.kind == "+" and not arg.type:
                self.report(node, "equal has no declared types: write the type, like +block", offset)
        if all(arg.kind == "#" for arg, _ in args):
            self.report(node, "equal compares a variable, like +block, with another or with a constant")
        if len(self.problems) > wrong:
            return None
        (left, _), (right, _) = args
        return left.type or right.type, right.type or left.type

    def bound_types(self, node: yaml.Node, args: list[tuple[Argument, int]]) -> tuple[str, ...] | None:
        """The type of what is bounded; a threshold has the same."""
        term, offset = args[0] if args else (Argument("", ""), 0)
        if [arg.constants for arg, _ in args[1:]] not in [[(limit,)] for limit in OPEN.values()]:
            self.report(node, "=< and >= are built in: write +weight =< # for a threshold")
        elif not (term.kind == "+" and term.type):
            self.report(node, f"a threshold is for an existing variable of a type, like +weight, not {term}", offset)
        else:
            return term.type, term.type
        return None

    # -------------------------------------------------- limits

    def tree(self, node: yaml.Node | None) -> TreeLimits:
        values: dict[str, int | float] = {}
        entries = self.mapping(node, "tree", [each.name for each in fields(TreeLimits)]) if node else {}
        for key, value_node in entries.items():
            value = _number(value_node.value) if isinstance(value_node, yaml.ScalarNode) else None
            if value is None:
                self.report(value_node, f"{key} is a number, not {_kind(value_node)}")
                continue
            try:
                TreeLimits(**{key: value})  # type: ignore[arg-type]
                values[key] = value
            except NppgError as error:
                self.report(value_node, str(error))
        return TreeLimits(**values)  # type: ignore[arg-type]

    # -------------------------------------------------- sentences

    def sentences(self, node: yaml.Node | None, known: Collection[str]) -> dict[str, str]:
        """`known`: the predicates that may have a sentence; empty where that could not be read."""
        found = {}
        for name, value in (self.mapping(node, "sentences", known) if node else {}).items():
            text = self.text(value, 'a sentence like "{1} is clear", in quotes,')
            if text is not None:
                self.check_sentence(value, name, text)
                found[name] = text.strip()
        return found

    def check_sentence(self, node: yaml.Node, name: str, text: str) -> None:
        """Every argument has to be mentioned: a sentence without one would say more than its literal."""
        types = self.types.get(name)
        wrong = len(self.problems)
        if "\n" in text.strip():
            self.report(node, "a sentence is one line")
        mentioned = set()
        for match in re.finditer(r"\{[^{}]*\}|[{}]", text):
            placeholder = PLACEHOLDER.fullmatch(match[0])
            if not placeholder:
                message = f"a placeholder is the number of an argument in braces, like {{1}}, not {match[0]!r}"
                self.report(node, message, match.start())
            elif types is not None and int(placeholder[1]) > len(types):
                self.report(node, f"{match[0]} stands for no argument of {_atom(name, types)}", match.start())
            else:
                mentioned.add(int(placeholder[1]))
        missing = [f"{{{i + 1}}}" for i in range(len(types or ())) if i + 1 not in mentioned]
        if types and missing and len(self.problems) == wrong:
            self.report(node, f"the sentence leaves out {', '.join(missing)} of {_atom(name, types)}")
