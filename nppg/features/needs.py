"""What is needed for what is left to do (means and ends): what an action asks for that does it, where that is true of
no objects with which it could be taken."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from nppg.features.derived import TODO, Derived, Words
from nppg.features.joins import apart, joined
from nppg.features.schemas import Schema, variables_of
from nppg.pddl.clauses import Clause, Negated, Term, Var

DEPTH = 2  # how often what is needed for something is asked in turn what it needs


@dataclass(frozen=True)
class Need:
    """The facts of a fluent that are wanted, by the arguments in these `places`; `derived` says which, where the domain
    does not say it itself. `aim`: the predicate of what is left to do in the end; `path`: the actions until then."""

    name: str
    fluent: str
    places: tuple[int, ...]
    aim: str
    path: str = ""
    derived: tuple[Derived, ...] = ()

    def of(self, fact: Term) -> Term | None:
        """The literal that says that a fact of the fluent is wanted; none where the fact is about given objects."""
        if fact.name != self.fluent or max(self.places) >= len(fact.args):
            return None
        args = tuple(fact.args[place] for place in self.places)
        is_open = all(isinstance(arg, Var) for arg in args) and len({*args}) == len(args)
        return Term(self.name, args) if is_open else None


def needs(words: Words, all_schemas: Sequence[Schema]) -> list[Need]:
    """What is left to do itself, then what is needed for that, then what is needed for this."""
    whole = {name: tuple(range(len(types))) for name, types in words.todo.items() if types}
    level = found = [Need(name, name.removeprefix(TODO), places, name) for name, places in whole.items()]
    for _ in range(DEPTH):
        level = [each for need in level for schema in all_schemas for each in _needed(words, need, schema)]
        found = [*found, *level]
    return found


def _needed(words: Words, need: Need, schema: Schema) -> Iterator[Need]:
    """By an action that brings about what another need wants."""
    lasting = [each for each in schema.literals if each.name in words.static and not words.is_type(str(each.name))]
    path = f"to_{schema.action.name}{need.path and '_'}{need.path}"
    for wanted in filter(None, map(need.of, schema.added)):
        given = set(variables_of([wanted]))
        for literal in schema.literals:
            fluent, types = str(literal.name), words.types.get(str(literal.name), ())
            if fluent not in words.fluents or fluent == need.fluent or len(types) != len(literal.args):
                continue
            about = _about(literal, lasting, given)
            places = [i for i, arg in enumerate(literal.args) if isinstance(arg, Var)]
            places = [i for i in places if literal.args[i] in given or literal.args[i] in variables_of(about)]
            args = tuple(variables_of(literal.args[i] for i in places))
            if not args or len(args) < len(places):
                continue
            other = {var: Var(var.name) for var in variables_of((literal, *about)) if var not in given}
            none = Negated(joined((_renamed(each, other) for each in (literal, *about)), given))
            body = apart((*joined((wanted, *(about if {*args} - given else ())), args), none), args, args)
            kinds = tuple(schema.types.get(arg, types[i]) for i, arg in zip(places, args, strict=True))
            name = f"needed_{fluent}_{path}"
            derived = Derived(name, kinds, (Clause(Term(name, args), body),), "", need.derived)
            yield Need(name, fluent, tuple(places), need.aim, path, (derived,))


def _about(literal: Term, lasting: Sequence[Term], given: set[Var]) -> list[Term]:
    """The static facts about the objects of a literal that are not given, and about what these relate them to."""
    found: list[Term] = []
    reached = {*variables_of([literal])} - given
    while more := [each for each in lasting if each not in found and reached & {*variables_of([each])}]:
        found += more
        reached |= {*variables_of(more)} - given
    return found


def _renamed(literal: Term, names: dict[Var, Var]) -> Term:
    renamed = (names.get(arg, arg) if isinstance(arg, Var) else arg for arg in literal.args)
    return Term(literal.name, tuple(_renamed(arg, names) if isinstance(arg, Term) else arg for arg in renamed))
