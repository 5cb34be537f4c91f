"""Reads tasks as nppg writes them: a YAML file with the language and the settings, and files of Prolog beside it.

The example files have terms example(Key, Target), where Key is as `example` declares it or, for models, the example's
name; behind them may come a list of the example's own facts, and its weight. All of it is read as data.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import yaml

from nppg.bias.declarations import Template
from nppg.bias.language_bias import LanguageBias
from nppg.bias.names import number
from nppg.bias.nodes import Document
from nppg.bridge.prolog import ask
from nppg.bridge.terms import Ground, ground
from nppg.errors import NppgError, Problem
from nppg.tilde.declared import askable, bias_of, looking_ahead
from nppg.tilde.mode_terms import Language
from nppg.tilde.program import Clause, background, conditional, read, read_text
from nppg.tilde.task import REGRESS, SETTINGS, Example, Settings, Target, Task
from nppg.tilde.terms import (
    Indicator,
    arguments,
    elements,
    indicator,
    parts,
    told,
)

_LANGUAGE = ("example", "types", "modes", "lookahead", "lookaheads")
_FILES = ("background", "facts", "examples")
KEYS = (*_LANGUAGE, "target", "classes", "settings", *_FILES)
OPERATORS = [(200, "fy", "+-"), (200, "fy", "#")]
_REQUIRED = ("example", "modes", "examples")


def read_own(file: Path) -> Task:
    """The task of a YAML file. Raises NppgError with its mistakes."""
    document = Document(str(file), read_text(file))
    root = document.compose()
    entries = document.mapping(root, "a learning problem", KEYS)
    for key in _REQUIRED:
        if key not in entries and isinstance(root, yaml.MappingNode):
            document.report(root, f"the key '{key}' is missing")
    settings = _settings(document, entries.get("settings"))
    types = _types(document, entries.get("types"))
    template = _template(document, entries.get("example"))
    left_out: list[Problem] = []
    found, steps = _language(document, entries, types, left_out)
    names = {
        key: document.text(entries[key], "a file") for key in ("background", "facts", "examples") if key in entries
    }
    if document.problems or left_out:
        raise NppgError(sorted([*document.problems, *left_out]))
    files = {key: file.parent / name for key, name in names.items() if name}
    clauses = {key: conditional(read(path, OPERATORS), left_out) for key, path in files.items()}
    examples = tuple(_example(clause, template, settings.mode == REGRESS) for clause in clauses["examples"])
    if not examples:
        raise NppgError([Problem(str(files["examples"]), 0, 0, "there is no example in it")])
    theirs = {indicator(fact) for each in examples for fact in each.facts}
    asked = [(mode.name, len(mode.args)) for mode in found.modes]
    shared = [*clauses.get("background", ()), *clauses.get("facts", ())]
    base = background(shared, asked, left_out, theirs)
    most = document.whole(entries.get("lookahead"), "lookahead", max([0, *steps.values()]))
    modes, lookaheads = askable(found.modes, found.lookaheads, base, theirs, file, left_out)
    target = document.text(entries["target"], "a name") if "target" in entries else None
    listed = document.items(entries["classes"], "a list of classes") if "classes" in entries else None
    return Task(
        name=file.stem,
        bias=bias_of(file, template, types, looking_ahead(modes, steps), lookaheads, most),
        examples=examples,
        facts=base.facts,
        background=base.text,
        background_file=str(files.get("background", "")),
        examples_file=str(files["examples"]),
        target=target or "class",
        classes=tuple(each.value for each in listed or ()),
        settings=settings,
        left_out=tuple(left_out),
    )


def language(text: str, file: str = "") -> LanguageBias:
    """The language bias of a text in the format of a task: of `example`, `types`, `modes`, `lookahead`, `lookaheads`.
    Raises NppgError with its mistakes."""
    document = Document(file or "the language bias", text)
    entries = document.mapping(document.compose(), "a language bias", KEYS)
    types, template = _types(document, entries.get("types")), _template(document, entries.get("example"))
    left_out: list[Problem] = []
    found, steps = _language(document, entries, types, left_out)
    most = document.whole(entries.get("lookahead"), "lookahead", max([0, *steps.values()]))
    if document.problems or left_out:
        raise NppgError(sorted([*document.problems, *left_out]))
    modes, lookaheads = looking_ahead(found.modes, steps), tuple(found.lookaheads)
    return bias_of(Path(document.file), template, types, modes, lookaheads, most)


def _language(
    document: Document,
    entries: Mapping[str, yaml.Node],
    types: dict[Indicator, tuple[str, ...]],
    left_out: list[Problem],
) -> tuple[Language, dict[Indicator, int]]:
    """The modes and the templates of lookahead, and the lookahead of predicates."""
    found = Language(types, _no_constants, left_out)
    steps = _modes(document, entries.get("modes"), found)
    for node in document.items(entries["lookaheads"], "a list of templates") or () if "lookaheads" in entries else ():
        for first, *others in _literals(document, node):
            found.declare(_clause(document, node, ("lookahead", first, _joined(others))))
    return found, steps


def _no_constants(variables: Ground, generator: Ground, clause: Clause) -> list[tuple[Ground, ...]]:
    return []


def _settings(document: Document, node: yaml.Node | None) -> Settings:
    values: dict[str, str | int | float] = {}
    for key, value in document.mapping(node, "settings", SETTINGS).items() if node else ():
        text = document.text(value, "a value")
        if text is not None:
            given = number(text)
            values[key] = text if given is None else given
            try:
                Settings(**({"mode": values.get("mode", "classify")} | {key: values[key]}))  # type: ignore[arg-type]
            except NppgError as error:
                document.report(value, str(error))
                del values[key]
    return Settings(**values)  # type: ignore[arg-type]


def _types(document: Document, node: yaml.Node | None) -> dict[Indicator, tuple[str, ...]]:
    """A name stands for the predicate with so many arguments as there are types; name/2 is for people to read."""
    found = {}
    for name, listed in document.mapping(node, "types").items() if node else ():
        types = [document.text(each, "a type") for each in document.items(listed, "a list of types") or ()]
        if None not in types:
            found[name.rpartition("/")[0] or name, len(types)] = tuple(map(str, types))
    return found


def _template(document: Document, node: yaml.Node | None) -> Template:
    for (literal,) in _literals(document, node) if node else ():
        args = (arguments(arg)[0] if indicator(arg) == ("+", 1) else arg for arg in arguments(literal))
        return Template(indicator(literal)[0], tuple(map(told, args)))
    return Template("example", ())


def _modes(document: Document, node: yaml.Node | None, language: Language) -> dict[Indicator, int]:
    """Takes the modes; gives the lookahead of predicates."""
    steps: dict[Indicator, int] = {}
    for each in document.items(node, "modes are a list of literals") or () if node else ():
        entries = {"literal": each}
        if isinstance(each, yaml.MappingNode):
            entries = document.mapping(each, "a mode", ("literal", "lookahead", "recall"))
        if "literal" not in entries:
            document.report(each, "the key 'literal' is missing")
            continue
        recall = document.whole(entries.get("recall"), "recall", 0)
        for literals in _literals(document, entries["literal"]):
            literal = literals[0]
            if indicator(literal) == ("equal", 2):
                literal = ("=", *arguments(literal))
            data: Ground = (":", recall, literal) if recall else literal
            language.declare(_clause(document, each, ("rmode", data)))
            if "lookahead" in entries:
                steps[indicator(literal)] = document.whole(entries["lookahead"], "lookahead", 0)
    return steps


def _literals(document: Document, node: yaml.Node) -> list[list[Ground]]:
    """The literals of a text, as one list; none where a mistake has been reported."""
    text = document.text(node, "a literal like on(+block, -block)")
    if text is None:
        return []
    rows = ask("source", f"literals(({text})).\n", [list(each) for each in OPERATORS])
    if len(rows) != 1 or rows[0][1] not in ("fact", "rule"):
        wrong = next((row[2] for row in rows if row[1] == "error"), "one literal is wanted")
        document.report(node, f"{wrong}: {text}")
        return []
    return [parts(arguments(ground(rows[0][2]))[0])]


def _clause(document: Document, node: yaml.Node, data: Ground) -> Clause:
    return Clause(document.file, document.place(node)[0], "fact", data)


def _joined(literals: Sequence[Ground]) -> Ground:
    *before, joined = literals
    for each in reversed(before):
        joined = (",", each, joined)
    return joined


def _example(clause: Clause, template: Template, is_number: bool) -> Example:
    args = arguments(clause.data)
    if clause.kind != "fact" or clause.predicate[0] != "example" or not 1 <= len(args) <= 4:
        raise NppgError([clause.problem(f"example(Key, Target, Facts, Weight) is wanted, not {told(clause.data)}")])
    default: tuple[Ground, ...] = ("?", ("[]",), 1.0)
    key, target, facts, weight = (*args, *default[len(args) - 1 :])
    own, count = elements(facts), len(template.types)
    if count and indicator(key) != (template.name, count):
        raise NppgError([clause.problem(f"{told(key)} is no {template.name} of {count} arguments")])
    if own is None or not isinstance(weight, int | float):
        raise NppgError([clause.problem("behind key and target come a list of facts and a number, the weight")])
    name = "" if count else str(key) if isinstance(key, str | int) else told(key)
    return Example(
        arguments(key) if count else (), _target(target, is_number), tuple(own), float(weight), clause.line, name
    )


def _target(data: Ground, is_number: bool) -> Target | None:
    """`?` stands for what is to be predicted."""
    if data == "?":
        return None
    several = elements(data)
    if several is not None:
        return tuple(several)  # type: ignore[arg-type]
    return data if is_number and isinstance(data, int | float) else told(data)
