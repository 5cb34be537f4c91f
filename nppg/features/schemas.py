"""What a domain's clauses say about its actions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from nppg.bias.declarations import Declared
from nppg.bridge.prolog import ask
from nppg.features.derived import Words
from nppg.pddl.clauses import Choice, Infix, Negated, Part, Term, Var, parts

_COMPARISONS = ("=", "\\=", "==", "\\==", "is", "<", ">", "=<", ">=", "=:=", "=\\=", "@<", "@>", "@=<", "@>=")


@dataclass(frozen=True)
class Schema:
    """An action, the goals that have to be met for it, and the facts that it deletes and adds; the types of its
    variables, as far as they are known."""

    action: Term
    goals: tuple[Part, ...]
    deleted: tuple[Term, ...]
    added: tuple[Term, ...]
    types: Mapping[Var, str]

    @property
    def literals(self) -> tuple[Term, ...]:
        """The goals that are plain facts."""
        return tuple(goal for goal in self.goals if isinstance(goal, Term))


def schemas(module: str, bias: Declared, words: Words) -> list[Schema]:
    """Those of a loaded domain, each once."""
    templates = {action.name: action.types for action in bias.actions}
    found = []
    for action, goals, deleted, added in ask("schemas", module):
        variables: dict[int, Var] = {}
        kinds: dict[int, str] = {}
        for literal in (action, *_atoms(goals), *deleted, *added):
            own = templates.get(literal[0], ()) if literal is action else words.types.get(literal[0], ())
            if isinstance(literal, list) and len(own) == len(literal) - 1:
                for arg, type_ in zip(literal[1:], own, strict=True):
                    if isinstance(arg, list) and arg[0] == "$VAR":
                        kinds.setdefault(arg[1], type_)
        made = [_part(each, variables, kinds) for each in (action, *goals, *deleted, *added)]
        head, *rest = made
        first, second = len(goals), len(goals) + len(deleted)
        found.append(
            Schema(
                head,
                tuple(goal for goal in rest[:first] if goal != Term("!")),
                tuple(each for each in rest[first:second] if isinstance(each, Term)),
                tuple(each for each in rest[second:] if isinstance(each, Term)),
                {var: kinds[number] for number, var in variables.items() if number in kinds},
            )
        )
    return found


def _atoms(goals: Iterable[Any]) -> Iterator[list]:
    for goal in goals:
        if isinstance(goal, list):
            yield goal
            yield from _atoms(goal[1:])


def _part(data: Any, variables: dict[int, Var], kinds: Mapping[int, str]) -> Any:
    if not isinstance(data, list):
        return Term(data)
    name, *args = data
    if name == "$VAR":
        return variables.setdefault(args[0], Var(kinds.get(args[0], "V")))
    inner = tuple(_part(each, variables, kinds) for each in args)
    if name == "\\+":
        return Negated(_together(inner[0]))
    if name == ";" and len(inner) == 2:
        return Choice(tuple(_together(each) for each in inner))
    if name in _COMPARISONS and len(inner) == 2:
        return Infix(name, *inner)
    return Term(name, inner)


def _together(part: Part) -> tuple[Part, ...]:
    if isinstance(part, Term) and part.name == "," and len(part.args) == 2:
        return (*_together(part.args[0]), *_together(part.args[1]))
    return (part,)


def variables_of(goals: Iterable[Part]) -> list[Var]:
    """Of goals, each once."""
    return list(dict.fromkeys(part for goal in goals for part in parts(goal) if isinstance(part, Var)))
