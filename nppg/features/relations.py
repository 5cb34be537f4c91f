"""Recursion over a relation between objects of one type: what lies beyond, and whether all of that is done."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from nppg.features.derived import GOAL, Derived, Words, named, typed
from nppg.pddl.clauses import Clause, Term, Var


def relations(words: Words) -> list[tuple[str, str]]:
    """The binary predicates that relate objects of one type, with that type: fluents, static ones, and goals."""
    found = []
    for name, types in words.types.items():
        known = name in words.fluents or name in words.static or name.startswith(GOAL)
        if known and len(types) == 2 and words.fits(*types):
            found.append((name, types[0]))
    return found


def beyond(words: Words) -> Iterator[Derived]:
    """The transitive closure: beyond_on(X, Y) says that Y is on X's way down."""
    for relation, type_ in relations(words):
        name = f"beyond_{relation}"
        x, y, z = Var("X"), Var("Y"), Var("Z")
        clauses = (
            Clause(Term(name, (x, y)), (Term(relation, (x, y)),)),
            Clause(Term(name, (x, y)), (Term(name, (x, z)), Term(relation, (z, y)))),
        )
        yield Derived(name, (type_, type_), clauses, f"{name}/2", unknown=(0, 1))


def unsettled(words: Words) -> Iterator[Derived]:
    """Something is left to do with an object, or with one beyond it: anything of which it is the first argument, or what
    one predicate says."""
    for relation, type_ in relations(words):
        if relation.startswith(GOAL):
            continue
        todo = [name for name, types in words.todo.items() if types and words.fits(type_, types[0])]
        for back in (False, True):
            base = named("unsettled", "before" if back else "", relation)
            if len(todo) > 1:
                yield _unsettled(words, base, relation, type_, back, todo)
            for name in todo:
                yield _unsettled(words, f"{base}_{name}", relation, type_, back, [name])


def _unsettled(words: Words, name: str, relation: str, type_: str, back: bool, all_todo: Iterable[str]) -> Derived:
    x, y = Var("X"), Var("Y")
    clauses = [Clause(Term(name, (x,)), (Term(todo, (x, *map(typed, words.types[todo][1:]))),)) for todo in all_todo]
    step = Term(relation, (y, x) if back else (x, y))
    clauses.append(Clause(Term(name, (x,)), (step, Term(name, (y,)))))
    return Derived(name, (type_,), tuple(clauses), f"{name}/1")
