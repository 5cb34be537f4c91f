"""The derived predicates of a domain, and which of them are worth testing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from nppg.bias.declarations import Declared
from nppg.bias.names import is_name
from nppg.bridge.prolog import ask
from nppg.features.counts import fewer
from nppg.features.derived import Derived, Words, with_todo
from nppg.features.moves import are_listed, moves, nearer, targets, toward, ways
from nppg.features.needs import needs
from nppg.features.relations import beyond, unsettled
from nppg.features.schemas import schemas
from nppg.pddl.clauses import Term, clause_text, parts


def candidates(module: str, bias: Declared, words: Words) -> list[Derived]:
    """All of a loaded domain, the simple ones first. Each name, those of what they need among them, means one thing,
    and none that the domain knows."""
    more = with_todo(words)
    if more:
        types = {**words.types, **{each.name: each.types for each in more}}
        words = Words(types, words.fluents, words.static, words.subtypes, words.taken)
    all_schemas = schemas(module, bias, words)
    all_needs = needs(words, all_schemas)

    def made() -> Iterator[Derived]:
        yield from more
        yield from unsettled(words)
        yield from beyond(words)
        for need in all_needs:
            yield from need.derived
        for each in moves(words, all_schemas):
            way = ways(each) if each.steps else None
            if way:
                yield nearer(way)
            for target, along in targets(words, all_schemas, all_needs, each):
                yield target
                if way and are_listed(target):
                    yield toward(way, target, along)
        yield from fewer(words, all_schemas)

    found: dict[str, Derived] = {}
    known = dict.fromkeys(words.taken, "")
    for each in made():
        each = _complete(each, more)
        texts = {one.name: "\n".join(map(clause_text, one.clauses)) for one in each.all()}
        if each.name not in found and all(is_name(name) and known.get(name, own) == own for name, own in texts.items()):
            known |= texts
            found[each.name] = each
    return list(found.values())


def _complete(each: Derived, todo: Sequence[Derived]) -> Derived:
    """With what it asks of what is left to do, where the domain does not say that itself."""
    clauses = (clause for one in each.all() for clause in one.clauses)
    asked = {part.name for clause in clauses for part in parts(clause) if isinstance(part, Term)}
    more = [one for one in todo if one.name in asked and one is not each]
    return replace(each, needs=(*more, *each.needs)) if more else each


def text(chosen: Sequence[Derived]) -> str:
    """Their clauses, with what they need, as Prolog."""
    all_ = list({each.name: each for one in chosen for each in one.all()}.values())
    lines = []
    for each in all_:
        lines += [f":- table {each.table}."] if each.table else []
        lines += map(clause_text, each.clauses)
    return "\n".join(["", "% derived from the types and the actions", *lines, ""]) if lines else ""


def extensions(module: str, names: Sequence[Derived]) -> list[str | int]:
    """What distinguishes their answers in the current state; 0 where there are none, "error" where asking throws."""
    return ask("extensions", module, [each.name for each in names], [len(each.types) for each in names])
