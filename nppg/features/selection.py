"""The derived predicates of a domain, and which of them are worth testing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from nppg.bias.declarations import Declared
from nppg.bridge.prolog import ask
from nppg.features.counts import fewer
from nppg.features.derived import Derived, Words, with_todo
from nppg.features.moves import moves, nearer, targets, toward, ways
from nppg.features.relations import beyond, unsettled
from nppg.features.schemas import schemas
from nppg.pddl.clauses import Term, clause_text, parts


def candidates(module: str, bias: Declared, words: Words) -> list[Derived]:
    """All of a loaded domain, the simple ones first; each name stands for one predicate."""
    more = with_todo(words)
    if more:
        types = {**words.types, **{each.name: each.types for each in more}}
        words = Words(types, words.fluents, words.static, words.subtypes, words.taken)
    all_schemas = schemas(module, bias, words)

    def made() -> Iterator[Derived]:
        yield from more
        yield from unsettled(words)
        yield from beyond(words)
        for each in moves(words, all_schemas):
            way = ways(each) if each.steps else None
            if way:
                yield nearer(way)
            for target, along in targets(words, all_schemas, each):
                yield target
                if way:
                    yield toward(way, target, along)
        yield from fewer(words, all_schemas)

    found: dict[str, Derived] = {}
    clauses: dict[str, list[str]] = {}
    for one in made():
        each = replace(one, needs=(*_mentioned(one, more), *one.needs))
        own = {part.name: list(map(clause_text, part.clauses)) for part in each.all()}
        if not any(name in words.taken or clauses.get(name, lines) != lines for name, lines in own.items()):
            clauses |= own
            found.setdefault(each.name, each)
    return list(found.values())


def _mentioned(derived: Derived, others: Sequence[Derived]) -> Iterator[Derived]:
    """Those of the others that its clauses, or those of what it needs, ask for."""
    clauses = [clause for each in derived.all() for clause in each.clauses]
    names = {part.name for clause in clauses for part in parts(clause) if isinstance(part, Term)}
    yield from (each for each in others if each.name in names and each.name != derived.name)


def text(chosen: Sequence[Derived]) -> str:
    """Their clauses, with what they need, as Prolog."""
    all_ = list({each.name: each for one in chosen for each in one.all()}.values())
    lines = []
    for each in all_:
        lines += [f":- table {each.table}."] if each.table else []
        lines += map(clause_text, each.clauses)
    return "\n".join(["", "% derived from the types and the actions", *lines, ""]) if lines else ""


def extensions(module: str, names: Sequence[Derived]) -> list[str | int]:
    """What distinguishes their answers in the current state; 0 where there are none."""
    return ask("extensions", module, [each.name for each in names], [len(each.types) for each in names])
