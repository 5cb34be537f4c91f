"""Model files: written as Prolog that a person can read, read back strictly as data.

The head of the file describes the policy by facts model(Name, Value): the domain and its parameters, the
templates and predicates of the language bias, and what the caller adds, such as the options of the run.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from functools import partial
from importlib.metadata import version
from pathlib import Path
from typing import NamedTuple, Protocol

from nppg.bias.declarations import Template, TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bridge.bounds import DATA, bounded
from nppg.bridge.files import made, replacing, shipped
from nppg.bridge.prolog import ask
from nppg.bridge.seals import is_whole, opened, sealed
from nppg.bridge.terms import ground
from nppg.errors import NppgError, Problem, suggestion
from nppg.policy.copies import CHECKPOINT, conflicts, write_copies
from nppg.trees.clauses import from_clause
from nppg.trees.tree import Rule, Tree, from_rules
from nppg.worlds.domain import Domain
from nppg.worlds.opening import open_domain

FORMAT = 1


class Writable(Protocol):
    """What a model file is written from: a policy."""

    domain: Domain
    bias: LanguageBias
    trees: list[Tree]
    comments: list[str]

    @property
    def name(self) -> str:
        """Of its clauses in Prolog."""

    def stored(self) -> tuple[Writable, list[tuple]]: ...


class Stored(NamedTuple):
    """What a model file holds: its trees, the domain and what was looked at there, and the facts of its head."""

    domain: Domain
    bias: LanguageBias
    trees: list[Tree]
    facts: Mapping[str, list]


def write(policy: Writable, path: Path, facts: Sequence[tuple] = (), sentences: Sequence[Sequence[str]] = ()) -> None:
    """Writes the model, and a copy of its domain beside it, into a folder that is made if need be. Raises NppgError
    where there are `conflicts`."""
    made(path.parent)
    copies = {policy.domain.path.name: policy.domain.source, **policy.domain.companions}
    if problems := conflicts(path.parent, copies, [path.name]):
        raise NppgError(problems.values())
    write_copies(path.parent, copies)
    write_model(policy, path, facts, sentences)


def write_model(
    policy: Writable, path: Path, facts: Sequence[tuple] = (), sentences: Sequence[Sequence[str]] = ()
) -> None:
    """Writes the model alone; `sentences`, if given, has for each tree one for each of its rules."""
    policy, own = policy.stored()
    domain, bias = policy.domain, policy.bias
    templates = {each.name for each in (*bias.actions, bias.goal) if each}
    described = [
        ("format", FORMAT),
        ("nppg", version("nppg")),
        ("prolog", ask("version")),
        ("domain", domain.path.name),
        ("domain_sha256", domain.hash),
        *(("parameter", ("=", name, value)) for name, value in domain.parameters.items()),
        *(("action", (each.name, *each.types) if each.types else each.name) for each in bias.actions),
        *([("goal", (bias.goal.name, *bias.goal.types))] if bias.goal else []),
        *(
            ("literal", (name, *types) if types else name)
            for name, types in bias.types.items()
            if name not in templates
        ),
        *facts,
        *own,
        ("trees", len(policy.trees)),
    ]
    entries = [[key, value] for key, value in described]
    comments = [[each] for each in policy.comments]
    if sentences:
        comments = [[*comment, *said] for comment, said in zip(comments, sentences, strict=True)]
    clauses = policy.name

    def write_to(temporary: Path) -> None:
        try:
            ask("save", str(temporary), domain.name, domain.path.name, entries, clauses, comments)
        except NppgError as error:
            raise NppgError([Problem(str(path), 0, 0, f"cannot be written: {error}")]) from None
        temporary.write_bytes(sealed(temporary.read_bytes()))

    replacing(path, write_to)


def read(
    path: Path, parameters: Mapping[str, int | float | str], trust: bool | None = None, edited: bool = False
) -> Stored:
    """Reads a model. Its domain is the copy beside it, else the shipped one of that name.

    Raises NppgError for what is no model, is not as it was signed and not said to be `edited`, is cut off, or uses an
    action or a predicate that it does not declare or its domain does not have; warns where the domain is
    `another_domain`.
    """
    facts, domain_file, clauses = opened(path, lambda _: parsed(path), edited, partial(_anew, path))
    known: dict[str, list] = {}
    for key, value in facts:
        known.setdefault(key, []).append(ground(value))
    if known.get("format") != [FORMAT]:
        raise _wrong(path, 1, f"model(format, {FORMAT}) is missing: written by another version of nppg?")
    if Path(domain_file).name != domain_file:
        raise _wrong(path, 1, f"the domain stands beside its model: {domain_file} cannot be its file")
    beside = path.parent / domain_file
    shipped_file = shipped("domains") / domain_file
    if not beside.is_file() and not shipped_file.is_file():
        raise _wrong(path, 1, f"the model's domain is missing: {domain_file} has to stand beside it")
    given = {**_parameters(path, known), **parameters}
    domain = open_domain(beside if beside.is_file() else shipped_file.stem, given, trust=trust)
    bias = _bias(path, known, domain)
    trees = [
        from_rules(rules, bias.forms.deciding_tests)
        for rules in _trees(path, clauses, bias, known)
    ]
    for problem in another_domain(path, domain, known):
        warnings.warn(str(problem), stacklevel=3)
    return Stored(domain, bias, trees, known)


def parsed(path: Path) -> tuple[list, str, list]:
    """The facts, the domain's file and the rules of a model. Raises NppgError where it has not the form of one."""
    if path.suffix == ".pddl":
        raise NppgError([Problem(str(path), 0, 0, "is PDDL and no model: nppg train writes one")])
    bounded(path.read_bytes(), str(path), DATA)
    facts, _, domain_file, clauses = ask("model", str(path))
    return facts, domain_file, clauses


def _anew(path: Path) -> str:
    """How a run's model can be had again, where its checkpoint is whole."""
    if path.name != "model.pl" or not is_whole(path.with_name(CHECKPOINT)):
        return ""
    return f"nppg train --resume {path.parent} writes it anew from the checkpoint there; "


def another_domain(path: Path, domain: Domain, facts: Mapping[str, list]) -> list[Problem]:
    """The problem that a policy, read from `path` with these facts, was learned in another file than that of `domain`;
    else none."""
    if facts.get("domain_sha256", [domain.hash]) == [domain.hash]:
        return []
    message = f"{domain.path} is not the file that this model was learned with: its SHA-256 is another"
    return [Problem(str(path), 0, 0, message)]


def _parameters(path: Path, known: Mapping[str, list]) -> dict[str, int | float | str]:
    parameters = {}
    for fact in known.get("parameter", []):
        match fact:
            case ("=", str(name), int(value) | float(value) | str(value)):
                parameters[name] = value
            case _:
                raise _wrong(path, 1, f"model(parameter, Name=Value) is expected, not {fact}")
    return parameters


def _bias(path: Path, known: Mapping[str, list], domain: Domain) -> LanguageBias:
    def template(term: str | tuple) -> Template:
        name, *types = term if isinstance(term, tuple) else (term,)
        if not all(isinstance(each, str) for each in (name, *types)):
            raise _wrong(path, 1, f"a predicate with types is expected, not {term}")
        return Template(name, tuple(types))

    literals = [template(term) for term in known.get("literal", [])]
    actions = tuple(map(template, known.get("action", [])))
    goal = next(map(template, known.get("goal", [])), None)
    if not actions:
        raise _wrong(path, 1, "the model declares no action")
    for each in literals if goal is None else [goal, *literals]:
        if (each.name, len(each.types)) not in domain.predicates:
            near = suggestion(each.name, (name for name, _ in domain.predicates))
            raise _wrong(
                path, 1, f"{domain.path} does not have {each.name}/{len(each.types)}{near}: is it another domain?"
            )
    types = {each.name: each.types for each in (*actions, *literals, *([goal] if goal else []))}
    file = next((path.parent / str(name) for name in known.get("bias", [])), path)
    return LanguageBias(str(file), actions, goal, types, {}, (), 0, 0, TreeLimits())


def _trees(path: Path, clauses: list, bias: LanguageBias, known: Mapping[str, list]) -> list[list[Rule]]:
    trees: list[list[Rule]] = []
    open_tree = False
    for line, number, head, body, value, final in clauses:
        if not open_tree:
            trees.append([])
        if number != len(trees):
            raise _wrong(path, line, f"a rule of tree {len(trees)} is expected here, not of tree {number}")
        try:
            trees[-1].append(from_clause(head, body, value, bias))
        except ValueError as error:
            raise _wrong(path, line, str(error)) from None
        open_tree = final != "true"
        if not open_tree and trees[-1][-1].query:
            raise _wrong(path, line, "the last rule of a tree has to hold for all actions")
    if open_tree or known.get("trees") != [len(trees)]:
        raise _wrong(path, clauses[-1][0] if clauses else 1, "the model is cut off here: rules are missing")
    return trees


def _wrong(path: Path, line: int, message: str) -> NppgError:
    return NppgError([Problem(str(path), line, 0, message)])
