"""Derived predicates as data, and what they are made from."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass

from nppg.bias.declarations import Declared, upwards
from nppg.pddl.clauses import Clause, Negated, Part, Term, Var

GOAL, TODO = "goal_", "todo_"  # goal_on(X, Y) is what a goal wants of on(X, Y), todo_on(X, Y) what is left of that


@dataclass(frozen=True)
class Derived:
    """A predicate, the types of its arguments, and its clauses. `table`: what it is tabled as, if it is; `needs`: what
    its clauses ask for beside what the domain has; `unknown`: the places where a test may have a new variable."""

    name: str
    types: tuple[str, ...]
    clauses: tuple[Clause, ...]
    table: str = ""
    needs: tuple[Derived, ...] = ()
    unknown: tuple[int, ...] = ()

    def __call__(self, *args: Part) -> Term:
        """Its literal with these arguments."""
        return Term(self.name, args)

    def all(self) -> Iterator[Derived]:
        """What it needs, and itself behind that."""
        for each in self.needs:
            yield from each.all()
        yield self


@dataclass(frozen=True)
class Words:
    """The predicates that derived ones are made from: the types of their arguments, which are fluents or static, what
    type lies below which, and the names that are taken."""

    types: Mapping[str, tuple[str, ...]]
    fluents: Collection[str]
    static: Collection[str]
    subtypes: Mapping[str, str]
    taken: Collection[str]

    @classmethod
    def of(
        cls,
        bias: Declared,
        fluents: Iterable[tuple[str, int]],
        static: Iterable[tuple[str, int]],
        predicates: Iterable[tuple[str, int]],
    ) -> Words:
        """Those of a language bias, for the fluents, the static ones and all predicates of its domain."""
        actions = {action.name for action in bias.actions}
        types = {name: own for name, own in bias.types.items() if name not in actions}
        changing, lasting, taken = ({name for name, _ in each} for each in (fluents, static, predicates))
        return cls(types, changing, lasting, bias.subtypes, taken | {*types})

    def fits(self, type_: str, other: str) -> bool:
        """Whether an object may be of both types."""
        return other in upwards(self.subtypes, type_) or type_ in upwards(self.subtypes, other)

    def has_facts(self, name: str) -> bool:
        """Whether a predicate is what states say, so that it may be asked whatever is known of its arguments."""
        return name in self.fluents or name in self.static

    def is_type(self, name: str) -> bool:
        """Whether a predicate is a type, so that it tells nothing of its objects."""
        return any(name in own for own in self.types.values())

    @property
    def todo(self) -> dict[str, tuple[str, ...]]:
        """The predicates of what is left to do, with their types."""
        return {name: own for name, own in self.types.items() if name.startswith(TODO)}


def typed(type_: str) -> Var:
    """A new variable for an object of this type."""
    return Var(type_)


def named(base: str, *parts: str) -> str:
    """A name made of parts, those left out that are empty."""
    return "_".join(filter(None, (base, *parts)))


def with_todo(words: Words) -> tuple[Derived, ...]:
    """What is left to do of goals that are facts goal_NAME, where the domain does not say it itself."""
    found = []
    for goal, types in words.types.items():
        now, todo = goal.removeprefix(GOAL), TODO + goal.removeprefix(GOAL)
        if goal.startswith(GOAL) and 0 < len(types) == len(words.types.get(now, ())) and todo not in words.taken:
            args = tuple(map(typed, types))
            clause = Clause(Term(todo, args), (Term(goal, args), Negated((Term(now, args),))))
            found.append(Derived(todo, types, (clause,), unknown=tuple(range(len(types)))))
    return tuple(found)
