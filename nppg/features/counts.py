"""Whether there is enough of something: numbers of objects compared with each other, for a threshold on one of them
does not hold in larger problems."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import product

from nppg.features.derived import TODO, Derived, Words, named, typed
from nppg.features.schemas import Schema, variables_of
from nppg.pddl.clauses import Clause, Infix, Term, Var

Set = tuple[str, tuple[tuple[str, int], ...]]  # a name, and predicates with the place of the object in each


def fewer(words: Words, all_schemas: Iterable[Schema]) -> Iterator[Derived]:
    """Where an action does what is wanted of one object by means of another one: what it asks of the means is true of
    fewer objects than what it asks of those that it is wanted for."""
    made: dict[Set, Derived] = {}
    seen = set()
    for schema in all_schemas:
        done = [Term(f"{TODO}{each.name}", each.args) for each in schema.added]
        done = [each for each in done if each.name in words.types]
        wanting = [var for var in variables_of(done) if var in schema.types]
        means = [var for var in schema.types if var not in wanting]
        for one, other in product(means, wanting):
            wanted = _sets(words, (*done, *schema.literals), other)
            for less, more in product(_sets(words, schema.literals, one), wanted):
                changing = any(_changes(words, name) for _, asked in (less, more) for name, _ in asked)
                if less[1] == more[1] or (less[1], more[1]) in seen or not changing:
                    continue
                seen.add((less[1], more[1]))
                few, many = (made.setdefault(each, _count(words, each)) for each in (less, more))
                n, m = Var("N"), Var("M")
                name = f"fewer_{less[0]}_than_{more[0]}"
                yield Derived(name, (), (Clause(Term(name), (few(n), many(m), Infix("<", n, m))),), "", (few, many))


def _changes(words: Words, name: str) -> bool:
    return name in words.fluents or name.startswith(TODO)


def _sets(words: Words, literals: Iterable[Term], var: Var) -> list[Set]:
    """What is asked of this object alone: each literal for itself, others than it left open, and all together."""
    asked: dict[tuple[str, int], None] = {}
    for literal in literals:
        name = str(literal.name)
        types = words.types.get(name, ())
        own = [place for place, arg in enumerate(literal.args) if arg is var]
        tells = _changes(words, name) or (len(types) == 1 and not words.is_type(name))
        if len(own) == 1 and len(types) == len(literal.args) and tells:
            asked[name, own[0]] = None
    found: list[Set] = [(_called(words, [each]), (each,)) for each in asked]
    return [*found, (_called(words, asked), tuple(asked))] if len(asked) > 1 else found


def _called(words: Words, asked: Iterable[tuple[str, int]]) -> str:
    return "_".join(named(name, str(place + 1) if len(words.types[name]) > 1 else "") for name, place in asked)


def _count(words: Words, each: Set) -> Derived:
    called, asked = each
    x, found, once, n = Var("X"), Var("Found"), Var("Set"), Var("N")
    goals = tuple(
        Term(name, tuple(x if i == place else typed(own) for i, own in enumerate(words.types[name])))
        for name, place in asked
    )
    both = Derived(f"both_{called}", (), (Clause(Term(f"both_{called}", (x,)), goals),))
    name = f"number_{called}"
    goal = both(x) if len(goals) > 1 else goals[0]
    body = (Term("findall", (x, goal, found)), Term("sort", (found, once)), Term("length", (once, n)))
    needs = (both,) if len(goals) > 1 else ()
    return Derived(name, (), (Clause(Term(name, (n,)), body),), f"{name}/1", needs)
