"""Model files: written as Prolog that a person can read, read back strictly as data.

The head of the file describes the policy by facts model(Name, Value): the domain and its parameters, the
templates and predicates of the language bias, and what the caller adds, such as the options of the run.
"""

from __future__ import annotations

import hashlib
import json
import os
import warnings
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from nppg import __version__
from nppg.clauses import from_clause
from nppg.coverage import table_of
from nppg.domain import Domain
from nppg.errors import NppgError, Problem, suggestion
from nppg.language_bias import LanguageBias, Template, TreeLimits
from nppg.logic import deciding_tests
from nppg.opening import open_domain
from nppg.options import Options
from nppg.policy import Policy
from nppg.prolog import ask, ground
from nppg.tree import Rule, from_rules, tests

FORMAT = 1


def write(policy: Policy, path: Path, facts: Sequence[tuple] = (), sentences: Sequence[Sequence[str]] = ()) -> None:
    """Writes the model, and a copy of its domain beside it, into a folder that is made if need be. Raises NppgError
    where there are `conflicts`."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise NppgError([Problem(str(path.parent), 0, 0, f"the folder cannot be made: {error.strerror}")]) from None
    copies = {policy.domain.path.name: policy.domain.source}
    if problems := conflicts(path.parent, copies, [path.name]):
        raise NppgError(problems.values())
    write_copies(path.parent, copies)
    write_model(policy, path, facts, sentences)


def write_model(
    policy: Policy, path: Path, facts: Sequence[tuple] = (), sentences: Sequence[Sequence[str]] = ()
) -> None:
    """Writes the model alone; `sentences`, if given, has for each tree one for each of its rules."""
    policy, own = policy.stored()
    domain, bias = policy.domain, policy.bias
    templates = {each.name for each in (*bias.actions, bias.goal) if each}
    described = [
        ("format", FORMAT),
        ("nppg", __version__),
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
    replacing(
        path,
        lambda temporary: ask("save", str(temporary), domain.name, domain.path.name, entries, policy.name, comments),
    )


def conflicts(folder: Path, copies: Mapping[str, bytes], own: Collection[str]) -> dict[str, Problem]:
    """Which copies, contents by name, cannot be put into a folder: those whose name is one of the model's `own` files,
    and those in place of which stands something else that no run of nppg wrote there."""
    recorded = recorded_hashes(folder)
    found = {}
    for name, source in copies.items():
        path = folder / name
        present = _contents(path)
        if name in own:
            found[name] = Problem(str(path), 0, 0, "a model needs another name than its domain's file")
        elif present not in (None, source) and _sha256(present or b"") != recorded.get(name):
            message = "there is another file of this name, which is left as it is: write into another folder"
            found[name] = Problem(str(path), 0, 0, message)
    return found


def write_copies(folder: Path, copies: Mapping[str, bytes]) -> None:
    """Writes the copies that are not there yet."""
    for name, source in copies.items():
        if _contents(folder / name) != source:
            replacing(folder / name, partial(Path.write_bytes, data=source))


def recorded_hashes(folder: Path) -> dict[str, str]:
    """SHA-256 of the inputs that the last run into a folder put there, by name."""
    try:
        summary = json.loads((folder / "run.json").read_text())
        return {each["file"]: each["sha256"] for each in (summary["domain"], summary["bias"]) if each}
    except (OSError, ValueError, KeyError, TypeError):
        return {}


def _contents(path: Path) -> bytes | None:
    """What stands in a file, nothing where there is none or it cannot be read."""
    try:
        return path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError:
        return b""


def replacing(path: Path, write_to: Callable[[Path], object]) -> None:
    """Writes a file under a temporary name and renames it, so that it is there whole or not at all. Raises
    NppgError where that is not possible."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        temporary.touch()
        write_to(temporary)
        os.replace(temporary, path)
    except OSError as error:
        raise NppgError([Problem(str(path), 0, 0, f"cannot be written: {error.strerror}")]) from None
    finally:
        temporary.unlink(missing_ok=True)


def read(path: Path, parameters: Mapping[str, int | float | str]) -> Policy:
    """Reads a model. Its domain is the copy beside it, else the shipped one of that name.

    Raises NppgError for what is no model, is cut off, or uses an action or a predicate that it does not declare
    or its domain does not have; warns where the domain is `another_domain`.
    """
    try:
        path.open("rb").close()
    except OSError as error:
        raise NppgError([Problem(str(path), 0, 0, f"cannot be read: {error.strerror}")]) from None
    facts, _, domain_file, clauses = ask("model", str(path))
    known: dict[str, list] = {}
    for key, value in facts:
        known.setdefault(key, []).append(ground(value))
    if known.get("format") != [FORMAT]:
        raise _wrong(path, 1, f"model(format, {FORMAT}) is missing: written by another version of nppg?")
    if Path(domain_file).name != domain_file:
        raise _wrong(path, 1, f"the domain stands beside its model: {domain_file} cannot be its file")
    beside = path.parent / domain_file
    file = beside if beside.is_file() else Path(domain_file).stem
    domain = open_domain(file, {**_parameters(path, known), **parameters})
    bias = _bias(path, known, domain)
    trees = [
        from_rules(rules, lambda query, literals: deciding_tests(query, literals, len(bias.roots)))
        for rules in _trees(path, clauses, bias, known)
    ]
    policy = Policy(domain, bias, table_of([test for tree in trees for test in tests(tree)], domain, bias))
    policy.facts = known
    policy.greedy = known.get("learner", [Options.learner]) != [Options.learner]
    for tree in trees:
        policy.add(tree)
    for problem in another_domain(path, policy):
        warnings.warn(str(problem), stacklevel=3)
    if "instance" in known:
        from nppg.rrl.instance_tree import restored

        return restored(policy, path)
    return policy


def another_domain(path: Path, policy: Policy) -> list[Problem]:
    """The problem that the policy, read from `path`, was learned in another domain file than it has now; else none."""
    now = policy.domain.hash
    if policy.facts.get("domain_sha256", [now]) == [now]:
        return []
    message = f"{policy.domain.path} is not the file that this model was learned with: its SHA-256 is another"
    return [Problem(str(path), 0, 0, message)]


def option(policy: Policy, name: str, default: Any) -> Any:
    """The value of an option of the run that a loaded policy comes from, as its model file says."""
    for fact in policy.facts.get("option", []):
        match fact:
            case ("=", str(known), value) if known == name:
                return value
    return default


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


def file_hash(path: str | Path) -> str:
    """SHA-256 of a file, in hexadecimal."""
    return _sha256(Path(path).read_bytes())


def _sha256(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()
