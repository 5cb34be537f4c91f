"""Prolog clauses as data, and their text.

A variable is itself, not its name: which name it gets is settled for each clause, where one that occurs once gets an
underscore.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from nppg.bias.names import written
from nppg.pddl.names import OPERATORS

WIDTH = 120
_ARITHMETIC = ("+", "-", "*", "/")


@dataclass(frozen=True, eq=False)
class Var:
    """A variable; `name` is what it would like to be called."""

    name: str


@dataclass(frozen=True)
class Term:
    """A name or a number, with arguments."""

    name: str | int | float
    args: tuple[Part, ...] = ()


@dataclass(frozen=True)
class Infix:
    """Two terms with an operator between them."""

    operator: str
    left: Part
    right: Part


@dataclass(frozen=True)
class Items:
    """A list, with what follows its items where it goes on."""

    items: tuple[Part, ...]
    rest: Var | None = None


@dataclass(frozen=True)
class Negated:
    """The goals cannot be met together."""

    goals: tuple[Part, ...]


@dataclass(frozen=True)
class Once:
    """The goals can be met together; how often does not matter."""

    goals: tuple[Part, ...]


@dataclass(frozen=True)
class Choice:
    """The goals of one of the alternatives are met."""

    alternatives: tuple[tuple[Part, ...], ...]


Part = Var | Term | Infix | Items | Negated | Once | Choice


@dataclass(frozen=True)
class Clause:
    """A fact or a rule."""

    head: Part
    body: tuple[Part, ...] = ()


def clause_text(clause: Clause) -> str:
    """The clause with its full stop, on one line where it fits."""
    names = _names(clause)
    head = _text(clause.head, names)
    if not clause.body:
        return _wrapped(f"{head}.", 4)
    line = f"{head} :- {', '.join(_text(goal, names) for goal in clause.body)}."
    if len(line) <= WIDTH and len(clause.body) < 8:
        return line
    return f"{_wrapped(f'{head} :-', 7)}\n    {_block(clause.body, names, 4)}."


def parts(part: Part | Clause) -> Iterator[Part]:
    """Everything in it, itself included."""
    if not isinstance(part, Clause):
        yield part
    for inner in _inner(part):
        yield from parts(inner)


def _inner(part: Part | Clause) -> Iterable[Part]:
    if isinstance(part, Clause):
        return (part.head, *part.body)
    if isinstance(part, Term):
        return part.args
    if isinstance(part, Infix):
        return (part.left, part.right)
    if isinstance(part, Items):
        return (*part.items, part.rest) if part.rest else part.items
    if isinstance(part, Choice):
        return [goal for goals in part.alternatives for goal in goals]
    return () if isinstance(part, Var) else part.goals


def _names(clause: Clause) -> dict[Var, str]:
    """A name for each variable, in the order in which they come."""
    counts = Counter(part for part in parts(clause) if isinstance(part, Var))
    names: dict[Var, str] = {}
    used: set[str] = set()
    for var, count in counts.items():
        name = base = variable_name(var.name)
        number = 2
        while name in used:
            name, number = f"{base}{number}", number + 1
        used.add(name)
        names[var] = name if count > 1 else f"_{name}"
    return names


def variable_name(name: str) -> str:
    """The name of a variable of PDDL as Prolog has it: `?loc-1` is Loc_1."""
    cleaned = re.sub(r"[^0-9A-Za-z_]", "_", name.lstrip("?")).strip("_")
    if not cleaned[:1].isalpha():
        cleaned = f"V{cleaned}"
    return cleaned[0].upper() + cleaned[1:]


def _text(part: Part, names: Mapping[Var, str]) -> str:
    if isinstance(part, Var):
        return names[part]
    if isinstance(part, Term):
        args = ", ".join(_text(arg, names) for arg in part.args)
        return f"{written(part.name)}({args})" if args else written(part.name)
    if isinstance(part, Infix):
        left, right = _operand(part.left, part, names), _operand(part.right, part, names)
        return f"{left}{part.operator}{right}" if part.operator in _ARITHMETIC else f"{left} {part.operator} {right}"
    if isinstance(part, Items):
        items = ", ".join(_text(item, names) for item in part.items)
        if not part.rest:
            return f"[{items}]"
        return f"[{items}|{names[part.rest]}]" if items else names[part.rest]
    if isinstance(part, Choice):
        return f"( {' ; '.join(_goals(goals, names) for goals in part.alternatives)} )"
    goals = _goals(part.goals, names)
    alone = len(part.goals) == 1 and isinstance(part.goals[0], Term | Negated | Once)
    if isinstance(part, Negated):
        return rf"\+ {goals}" if alone else rf"\+ ( {goals} )"
    return f"once({goals})" if alone else f"once(( {goals} ))"


def _operand(part: Part, whole: Infix, names: Mapping[Var, str]) -> str:
    text = _text(part, names)
    if isinstance(part, Infix):
        tight = whole.operator in "*/" or (whole.operator in _ARITHMETIC and part is whole.right)
        return f"({text})" if tight else text
    if isinstance(part, Term) and not part.args and part.name in OPERATORS:
        return f"({text})"
    negative = isinstance(part, Term) and not isinstance(part.name, str) and part.name < 0
    return f"({text})" if negative and whole.operator in _ARITHMETIC else text


def _goals(goals: Sequence[Part], names: Mapping[Var, str]) -> str:
    return ", ".join(_text(goal, names) for goal in goals) or "true"


def _block(goals: Sequence[Part], names: Mapping[Var, str], indent: int) -> str:
    """The goals one below the other; the first line is not indented."""
    return f",\n{' ' * indent}".join(_goal(goal, names, indent) for goal in goals) or "true"


def _goal(goal: Part, names: Mapping[Var, str], indent: int) -> str:
    text = _text(goal, names)
    if indent + len(text) < WIDTH or isinstance(goal, Var):
        return text
    if isinstance(goal, Negated):
        return rf"\+ ( {_block(goal.goals, names, indent + 5)} )"
    if isinstance(goal, Once):
        return f"once(( {_block(goal.goals, names, indent + 7)} ))"
    if isinstance(goal, Choice):
        margin = " " * indent
        blocks = (_block(goals, names, indent + 4) for goals in goal.alternatives)
        return f"(   {f'{chr(10)}{margin};   '.join(blocks)}\n{margin})"
    return _wrapped(text, indent + 4, indent)


def _wrapped(text: str, margin: int, start: int = 0) -> str:
    """The text with line breaks behind commas, best between lists; no name has a space."""
    lines, width = [], WIDTH - start - 1
    while len(text) > width and (cut := _cut(text, width)) > 0:
        lines.append(text[:cut])
        text, width = text[cut + 1 :], WIDTH - margin - 1
    return f"\n{' ' * margin}".join([*lines, text])


def _cut(text: str, width: int) -> int:
    between, inside = text.rfind("], ", 0, width) + 2, text.rfind(", ", 0, width) + 1
    return between if between > width // 3 else inside
