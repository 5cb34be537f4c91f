"""Places: where an action could be taken, how far it is to there, and whether a step leads towards it.

A move is an action that exchanges one argument of a fluent: drive(V, X, Y) replaces at(V, X) by at(V, Y). Where static
facts relate the two, like road(X, Y), it is a step from X to Y, and there are distances.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import product

from nppg.features.derived import GOAL, TODO, Derived, Words, named, typed
from nppg.features.joins import apart, joined
from nppg.features.needs import Need
from nppg.features.schemas import Schema, variables_of
from nppg.pddl.clauses import Clause, Infix, Negated, Part, Term, Var, clause_text

_STEP = "step_"
_MOST = 12  # ways in which objects of an action can be those of something that is left to do


@dataclass
class Moves:
    """Those that change one argument of a fluent. `types`: of its other arguments; `along`: which of these a step
    depends on."""

    fluent: str
    place: int
    kind: str  # the type of what is exchanged
    types: tuple[str, ...]
    along: tuple[int, ...] = ()
    steps: list[tuple[tuple[Var, ...], Var, Var, tuple[Term, ...]]] = field(default_factory=list)


def moves(words: Words, all_schemas: Iterable[Schema]) -> list[Moves]:
    """All of a domain's."""
    found: dict[tuple[str, int], Moves] = {}
    for schema in all_schemas:
        for gone, new in product(schema.deleted, schema.added):
            if gone.name != new.name or not len(gone.args) == len(new.args) == len(words.types.get(str(gone.name), ())):
                continue
            changed = [i for i, (one, other) in enumerate(zip(gone.args, new.args, strict=True)) if one != other]
            if len(changed) != 1:
                continue
            (place,) = changed
            x, y = gone.args[place], new.args[place]
            edge = tuple(
                literal
                for literal in schema.literals
                if str(literal.name) in words.static and x in literal.args and y in literal.args
            )
            if not (isinstance(x, Var) and isinstance(y, Var)):
                continue
            others = tuple(arg for i, arg in enumerate(gone.args) if i != place)
            if not all(isinstance(arg, Var) for arg in others):
                continue
            own = words.types[str(gone.name)]
            types = tuple(schema.types.get(arg, "") for arg in others)  # type: ignore[arg-type]
            known = found.setdefault(
                (str(gone.name), place), Moves(str(gone.name), place, schema.types.get(x, own[place]), types)
            )
            mentioned = variables_of(edge)
            along = tuple(i for i, arg in enumerate(others) if arg in mentioned)
            known.along = tuple(sorted({*known.along, *along}))
            if edge:
                known.steps.append((others, x, y, edge))  # type: ignore[arg-type]
    return [each for each in found.values() if all(each.types)]


@dataclass
class Ways:
    """What is derived of moves, for all that leads along them."""

    moves: Moves
    step: Derived
    steps: Derived

    @property
    def types(self) -> tuple[str, ...]:
        """Of the arguments that a step depends on."""
        return tuple(self.moves.types[i] for i in self.moves.along)


def ways(each: Moves) -> Ways:
    """A step, and the number of steps from X to Z, found from Z on backwards."""
    types, kind = tuple(each.types[i] for i in each.along), each.kind
    name, lines, known = f"{_STEP}{each.fluent}", [], set()
    for others, x, y, edge in each.steps:
        clause = Clause(Term(name, (*(others[i] for i in each.along), x, y)), edge)
        if clause_text(clause) not in known:
            known.add(clause_text(clause))
            lines.append(clause)
    step = Derived(name, (*types, kind, kind), tuple(lines))
    args = tuple(map(typed, types))
    x, y, z, d, d0 = Var("X"), Var("Y"), Var("Z"), Var("D"), Var("D0")
    far, count = f"far_{each.fluent}", f"steps_{each.fluent}"
    longer = Infix("is", d, Infix("+", d0, Term(1)))
    far_clauses = (
        Clause(Term(far, (*args, z, z, Term(0)))),
        Clause(Term(far, (*args, z, x, d)), (Term(far, (*args, z, y, d0)), step(*args, x, y), longer)),
    )
    open_ = ", ".join("_" for _ in (*args, z, x))
    distance = Derived(far, (), far_clauses, f"{far}({open_}, min)", (step,))
    steps = Derived(
        count,
        (),
        (Clause(Term(count, (*args, x, z, d)), (distance(*args, z, y, d), Infix("==", y, x))),),
        f"{count}/{len(args) + 3}",
        (distance,),
    )
    return Ways(each, step, steps)


def roads(chosen: Iterable[Derived]) -> set[str]:
    """The static predicates along which something moves, where steps are among what is derived."""
    steps = (one for each in chosen for one in each.all() if one.name.startswith(_STEP))
    goals = (goal for step in steps for clause in step.clauses for goal in clause.body)
    return {str(goal.name) for goal in goals if isinstance(goal, Term)}


def nearer(way: Ways) -> Derived:
    """Y is one step from X and nearer to Z."""
    args = tuple(map(typed, way.types))
    x, y, z, d, d0 = Var("X"), Var("Y"), Var("Z"), Var("D"), Var("D0")
    kind = way.moves.kind
    name = f"nearer_{way.moves.fluent}"
    body = (way.step(*args, x, y), way.steps(*args, y, z, d), way.steps(*args, x, z, d0), Infix("<", d, d0))
    clause = Clause(Term(name, (*args, x, y, z)), body)
    return Derived(name, (*way.types, kind, kind, kind), (clause,), "", (way.steps,))


def targets(
    words: Words, all_schemas: Iterable[Schema], all_needs: Sequence[Need], each: Moves
) -> Iterator[tuple[Derived, tuple[int, ...]]]:
    """Sets of places: where what moves is wanted, and where an action could be taken if what moves were there, any
    action of a kind or one that has to do with what is left to do. Each with the moving arguments that it depends on,
    which come first, and the place last."""
    todo = TODO + each.fluent
    if len(words.types.get(todo, ())) == len(each.types) + 1:
        yield _wanted(words, each, todo)
    for schema in all_schemas:
        title = str(schema.action.name)
        if all(term.name == each.fluent for term in schema.added):
            continue
        for literal in schema.literals:
            if literal.name != each.fluent or len(literal.args) != len(each.types) + 1:
                continue
            z = literal.args[each.place]  # a variable, or the one place where the action can be taken
            others = [arg for i, arg in enumerate(literal.args) if i != each.place]
            if not all(
                isinstance(arg, Var) and words.fits(schema.types.get(arg, type_), type_)
                for arg, type_ in zip(others, each.types, strict=True)
            ):
                continue
            rest = tuple(goal for goal in schema.goals if goal is not literal)
            calls = [goal for goal in rest if isinstance(goal, Term) and not words.has_facts(str(goal.name))]
            for purpose in _purposes(words, schema, all_needs):
                body = (*purpose.goals, *rest)
                if not purpose.is_new:
                    bound = set(variables_of(body))
                    new = [term for term in schema.added if set(variables_of([term])) <= {*bound, z, *others}]
                    body += tuple(Negated((term,)) for term in new[:1])
                if not _is_bound(body):
                    continue
                used = set(variables_of(body))
                if isinstance(z, Var) and z not in used:
                    continue
                along = tuple(i for i, arg in enumerate(others) if arg in used)
                called = named("could", title, purpose.name)
                head = Term(called, (*(others[i] for i in along), z))
                known = variables_of(head.args[:-1] if each.steps else head.args)  # steps lead to all of the places
                types = (*(each.types[i] for i in along), each.kind)
                clause = Clause(head, apart(joined(body, known, calls), variables_of([head]), known))
                yield Derived(called, types, (clause,), "", purpose.needs), along


def _is_bound(body: Sequence[Part]) -> bool:
    """Whether what a body compares and computes is about variables that its facts bind."""
    facts = set(variables_of(goal for goal in body if isinstance(goal, Term)))
    return set(variables_of(goal for goal in body if isinstance(goal, Infix))) <= facts


def are_listed(target: Derived) -> bool:
    """Whether the places of a set can be asked for, and are not only what something is denied of."""
    place = target.clauses[0].head.args[-1]  # type: ignore[union-attr]
    facts = (goal for goal in target.clauses[0].body if isinstance(goal, Term))
    return not isinstance(place, Var) or place in variables_of(facts)


def _wanted(words: Words, each: Moves, todo: str) -> tuple[Derived, tuple[int, ...]]:
    args = tuple(map(typed, each.types))
    z = Var("Z")
    whole = (*args[: each.place], z, *args[each.place :])
    name = f"wanted_{each.fluent}"
    clause = Clause(Term(name, (*args, z)), (Term(todo, whole),))
    return Derived(name, (*each.types, each.kind), (clause,)), tuple(range(len(args)))


@dataclass(frozen=True)
class _Purpose:
    """What an action is taken for: a name, goals, what is derived for these; whether they say that what the action
    brings about is not there yet."""

    name: str
    goals: tuple[Term, ...] = ()
    needs: tuple[Derived, ...] = ()
    is_new: bool = False


def _purposes(words: Words, schema: Schema, all_needs: Sequence[Need]) -> Iterator[_Purpose]:
    """Nothing in particular; what the action brings about is left to do, or needed; something is left to do, which it
    helps, that is about its objects, or about objects that static facts relate to these."""
    yield _Purpose("")
    seen: set[tuple] = set()
    names: set[str] = set()
    aims: dict[str, None] = {}
    for need, term in product(all_needs, schema.added):
        if wanted := need.of(term):
            aims[need.aim] = None
            seen.add((need.name, wanted.args))
            yield _Purpose(need.name, (wanted,), need.derived, is_new=True)
    todo_types = {todo: types for todo, types in words.todo.items() if todo in aims}
    named_ones = variables_of((schema.action, *schema.literals))  # not those of what is denied alone
    objects = {var: own for var, own in schema.types.items() if own and var in named_ones}
    for todo, types in todo_types.items():
        choices = [[None, *(var for var, own in objects.items() if words.fits(own, type_))] for type_ in types]
        count = 0
        for chosen in product(*choices):
            taken = [each for each in chosen if each is not None]
            if not taken or len(set(taken)) < len(taken) or (todo, chosen) in seen or count >= _MOST:
                continue
            count += 1
            args = tuple(typed(type_) if var is None else var for var, type_ in zip(chosen, types, strict=True))
            base = name = named("for", todo, *("any" if var is None else objects[var] for var in chosen))
            number = 1
            while name in names:
                number += 1
                name = f"{base}_{number}"
            names.add(name)
            yield _Purpose(name, (Term(todo, args),))
    for relation, (one, other) in _static_relations(words):
        for var, own in objects.items():
            for todo, types in todo_types.items():
                for place, type_ in enumerate(types):
                    for kind, back in ((one, False), (other, True)):
                        if not words.fits(own, kind) or not words.fits(type_, one if back else other):
                            continue
                        x = typed(type_)
                        args = tuple(x if i == place else typed(each) for i, each in enumerate(types))
                        name = named("through", relation, "back" if back else "", "for", todo, str(place + 1), own)
                        if name not in names:
                            names.add(name)
                            yield _Purpose(name, (Term(relation, (x, var) if back else (var, x)), Term(todo, args)))


def _static_relations(words: Words) -> Iterator[tuple[str, tuple[str, str]]]:
    """Those between objects of two types."""
    for name, types in words.types.items():
        if name in words.static and not name.startswith(GOAL) and len(types) == 2 and not words.fits(*types):
            yield name, (types[0], types[1])


def toward(way: Ways, target: Derived, along: tuple[int, ...]) -> Derived:
    """Y is one step from X, and nearer to the nearest place of a set."""
    each = way.moves
    shared = {i: typed(each.types[i]) for i in sorted({*along, *each.along})}
    own, stepping = tuple(shared[i] for i in along), tuple(shared[i] for i in each.along)
    x, y, z, d, d0 = Var("X"), Var("Y"), Var("Z"), Var("D"), Var("D0")
    found, places = Var("Found"), Var("Places")
    all_, nearest, to = f"places_{target.name}", f"nearest_{target.name}", f"distance_{target.name}"
    listed = (Term("findall", (z, target(*own, z), found)), Term("sort", (found, places)))
    every = _helper(all_, (*own, places), listed, (target,), tabled=True)
    ways_there = (every(*own, places), Term("member", (z, places)), way.steps(*stepping, x, z, d))
    reach = _helper(to, (*shared.values(), x, d), ways_there, (every, way.steps))
    least = (Term("aggregate_all", (Term("min", (d0,)), reach(*shared.values(), x, d0), d)),)
    near = _helper(nearest, (*shared.values(), x, d), least, (reach,), tabled=True)
    name = f"toward_{target.name}"
    body = (way.step(*stepping, x, y), near(*shared.values(), x, d), near(*shared.values(), y, d0), Infix("<", d0, d))
    types = tuple(each.types[i] for i in shared)
    return Derived(
        name, (*types, each.kind, each.kind), (Clause(Term(name, (*shared.values(), x, y)), body),), "", (near,)
    )


def _helper(
    name: str, args: tuple[Part, ...], body: tuple[Part, ...], needs: tuple[Derived, ...], tabled: bool = False
) -> Derived:
    table = f"{name}/{len(args)}" if tabled else ""
    return Derived(name, (), (Clause(Term(name, args), body),), table, needs)
