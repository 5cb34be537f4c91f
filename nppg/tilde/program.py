"""Programs in Prolog that data comes in: facts, rules and declarations with their places, as data that is never run."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from nppg.bias.names import written
from nppg.bridge.bounds import DATA, bounded
from nppg.bridge.prolog import ask
from nppg.bridge.terms import Compound, Ground, ground
from nppg.errors import NppgError, Problem
from nppg.tilde.terms import Indicator, arguments, elements, indicator, parts, told

_MOST = 50  # mistakes that are told of one file
_INCLUDES = {("consult", 1), ("reconsult", 1), ("ensure_loaded", 1), ("include", 1), ("[|]", 2)}
_SILENT = {"op", "style_check", "multifile", "discontiguous"}  # of no meaning once the program is read


@dataclass(frozen=True, slots=True)
class Clause:
    """A fact, a rule or a directive. `data` is the fact, the rule's head, or what is declared, with variables as
    ("$VAR", number)."""

    file: str
    line: int
    kind: str
    data: Ground
    text: str = ""  # a rule as Prolog prints it
    calls: tuple[Indicator, ...] = ()  # without what every program may call
    doubts: tuple[Indicator, ...] = ()  # those that only a program may call that defines them itself
    refusal: str = ""  # why it cannot stand at all
    predicate: Indicator = field(init=False, default=("", 0), compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "predicate", indicator(self.data))

    def problem(self, message: str) -> Problem:
        return Problem(self.file, self.line, 0, message)


def read(path: Path, operators: Sequence[tuple[int, str, str]] = ()) -> list[Clause]:
    """What a file has, and the files that it loads from its folder. Raises NppgError with all that cannot be read."""
    clauses: list[Clause] = []
    problems: list[Problem] = []
    _read(path, path.parent, operators, clauses, problems, set())
    if problems:
        raise NppgError(problems[:_MOST])
    return clauses


def _read(
    path: Path,
    folder: Path,
    operators: Sequence[tuple[int, str, str]],
    clauses: list[Clause],
    problems: list[Problem],
    seen: set[Path],
) -> None:
    seen.add(path.resolve())
    for line, kind, data, *more in ask("source", read_text(path), [list(each) for each in operators]):
        if kind == "error":
            problems.append(Problem(str(path), line, 0, data))
            continue
        term = Compound(ground(data)) if isinstance(data, list) else data
        if kind == "rule":
            text, calls, doubts, refusal = more
            clauses.append(Clause(str(path), line, kind, term, text, _indicators(calls), _indicators(doubts), refusal))
            continue
        clause = Clause(str(path), line, kind, term)
        found = _included(term, path, folder) if kind == "directive" and indicator(term) in _INCLUDES else None
        if found is None:
            clauses.append(clause)
        for each in found or ():
            if each.resolve() not in seen:
                _read(each, folder, operators, clauses, problems, seen)


def _indicators(data: list[list]) -> tuple[Indicator, ...]:
    return tuple((name, arity) for name, arity in data)


def read_text(path: Path) -> str:
    """That of a file. Old files are in Latin 1, or end their lines as Windows does."""
    try:
        source = path.read_bytes()
    except OSError as error:
        raise NppgError([Problem(str(path), 0, 0, f"cannot be read: {error.strerror}")]) from None
    try:
        text = source.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = source.decode("latin-1")
    text = text.replace("\r\n", "\n")
    bounded(text.encode(), str(path), DATA)
    return text


def _included(data: Ground, path: Path, folder: Path) -> list[Path] | None:
    """The files that a directive names, where all are in the folder."""
    specs = elements(data) if indicator(data) == ("[|]", 2) else list(arguments(data))
    found = []
    for spec in specs or ():
        candidates = [path.parent / f"{spec}{suffix}" for suffix in ("", ".pl", ".b", ".kb") if type(spec) is str]
        here = [each for each in candidates if each.is_file() and each.resolve().is_relative_to(folder.resolve())]
        if not here:
            return None
        found.append(here[0])
    return found


def conditional(clauses: Iterable[Clause], left_out: list[Problem]) -> list[Clause]:
    """Without what stands behind a condition that is not so: `:- if(Goal)` to `:- endif`. The condition is not run:
    what asks for SWI-Prolog is so, what asks for anything else is not."""
    found, open_ones = [], [(True, True)]  # whether the branch counts, and whether one of its conditional has
    for clause in clauses:
        name, arity = clause.predicate if clause.kind == "directive" else ("", 0)
        within = open_ones[-2][0] if len(open_ones) > 1 else True
        if (name, arity) == ("if", 1):
            so = open_ones[-1][0] and _holds(arguments(clause.data)[0], clause, left_out)
            open_ones.append((so, so or not open_ones[-1][0]))
        elif (name, arity) == ("elif", 1) and len(open_ones) > 1:
            so = within and not open_ones[-1][1] and _holds(arguments(clause.data)[0], clause, left_out)
            open_ones[-1] = so, so or open_ones[-1][1]
        elif (name, arity) == ("else", 0) and len(open_ones) > 1:
            open_ones[-1] = within and not open_ones[-1][1], True
        elif (name, arity) == ("endif", 0) and len(open_ones) > 1:
            open_ones.pop()
        elif open_ones[-1][0]:
            found.append(clause)
    return found


def _holds(condition: Ground, clause: Clause, left_out: list[Problem]) -> bool:
    name, arity = indicator(condition)
    args = arguments(condition)
    if (name, arity) in ((",", 2), (";", 2)):
        both = [_holds(each, clause, left_out) for each in args]
        return all(both) if name == "," else any(both)
    if (name, arity) in (("\\+", 1), ("not", 1)):
        return not _holds(args[0], clause, left_out)
    if (name, arity) == ("current_prolog_flag", 2) and args[0] == "dialect":
        return args[1] == "swi"
    if condition not in ("fail", "false", "true") and name != "current_predicate":
        left_out.append(clause.problem(f"the condition {told(condition)} is not asked, and taken for false"))
    return condition == "true"


@dataclass(frozen=True)
class Background:
    """What a program defines, as a task has it."""

    facts: tuple[Ground, ...]
    text: str
    defined: frozenset[Indicator]
    rules: Mapping[Indicator, frozenset[Indicator]]  # what each predicate that the text defines calls
    missing: dict[Indicator, str]  # predicates that are left out, and why


def background(
    clauses: Iterable[Clause],
    asked: Iterable[Indicator],
    left_out: list[Problem],
    given: Collection[Indicator] = (),
) -> Background:
    """The facts, and a text of Prolog with the rules, but for what a program that is not trusted may not do: that is
    left out, with all that depends on it, and told; so are directives. `asked` are predicates that are tested, `given`
    those that examples have facts of."""
    clauses = list(clauses)
    own = [clause for clause in clauses if clause.kind != "directive"]
    defined = {clause.predicate for clause in own}
    missing = {
        (name, arity): f"{name}/{arity} is Prolog's own"
        for name, arity in ask("unchangeable", [list(each) for each in sorted(defined)])
    }
    for clause in own:
        if clause.predicate in missing and clause.kind == "fact":
            what = f"{clause.predicate[0]}/{clause.predicate[1]}"
            left_out.append(clause.problem(f"what the file says of {what} is left out: it is Prolog's own"))
            break
    rules: dict[Indicator, list[Clause]] = {}
    for clause in own:
        if clause.kind == "rule":
            rules.setdefault(clause.predicate, []).append(clause)
    for head, its in rules.items():
        for clause in its:
            called = [each for each in clause.doubts if each not in defined]
            if clause.refusal or called:
                why = clause.refusal or f"it calls {called[0][0]}/{called[0][1]}, which only a trusted program may"
                if head not in missing:
                    left_out.append(clause.problem(f"{head[0]}/{head[1]} is left out: {why}"))
                missing.setdefault(head, why)
    while more := {
        head: f"it calls {'/'.join(map(str, each))}, which is left out"
        for head, its in rules.items()
        if head not in missing
        for clause in its
        for each in clause.calls
        if each in missing
    }:
        missing |= more
    kept = [clause for clause in own if clause.predicate not in missing]
    lines, dynamic = _declarations([clause for clause in clauses if clause.kind == "directive"], left_out)
    calls = {head: frozenset(each for clause in its for each in clause.calls) for head, its in rules.items()}
    reached = reachable(asked, calls)
    for clause in kept:
        for name, arity in clause.calls:
            if (name, arity) not in defined | dynamic:
                dynamic.add((name, arity))
                if (name, arity) not in given and clause.predicate in reached:
                    left_out.append(clause.problem(f"{name}/{arity} is called and nowhere defined: it fails"))
    lines += [f":- dynamic(/({written(name)}, {arity})).\n" for name, arity in sorted(dynamic - defined)]
    mixed = [clause for clause in kept if clause.predicate in rules]
    mixed.sort(key=lambda each: each.predicate)
    as_text = iter(ask("texts", [clause.data for clause in mixed if clause.kind == "fact"]))
    lines += [clause.text if clause.kind == "rule" else f"{next(as_text)}.\n" for clause in mixed]
    facts = tuple(clause.data for clause in kept if clause.predicate not in rules)
    return Background(facts, "".join(lines), frozenset(defined | dynamic) - missing.keys(), calls, missing)


def reachable(asked: Iterable[Indicator], calls: Mapping[Indicator, frozenset[Indicator]]) -> set[Indicator]:
    """What asking these predicates may call."""
    found: set[Indicator] = set()
    unread = list(asked)
    while unread:
        each = unread.pop()
        if each not in found:
            found.add(each)
            unread += calls.get(each, ())
    return found


def _declarations(declared: Iterable[Clause], left_out: list[Problem]) -> tuple[list[str], set[Indicator]]:
    """The lines that go into the text, and the predicates that may change."""
    lines: list[str] = []
    dynamic: set[Indicator] = set()
    for clause in declared:
        name, arity = clause.predicate
        args = arguments(clause.data)
        if name == "dynamic" and arity == 1:
            specs = elements(args[0])
            for spec in specs if specs is not None else parts(args[0]):
                if indicator(spec) == ("/", 2) and all(type(each) in (str, int) for each in arguments(spec)):
                    dynamic.add(arguments(spec))  # type: ignore[arg-type]
        elif name == "table" and arity == 1:
            lines.append(f":- table {told(args[0])}.\n")
        elif not (name in _SILENT or (name == "use_module" and indicator(args[0])[0] == "library")):
            left_out.append(clause.problem(f":- {told(clause.data)} is not run"))
    return lines, dynamic
