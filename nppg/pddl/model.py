"""A PDDL domain and its problems as data: what nppg.pddl.reader reads and nppg.pddl.domain_text writes.

All names are in lower case, as PDDL does not tell cases apart. A term is a name: `?x` is a variable, everything else an
object. An implication is read as the disjunction that it is, an untyped name as one of type object.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

Number = int | float
OBJECT = "object"  # the type of all objects


@dataclass(frozen=True, slots=True)
class Typed:
    """A variable, an object or a constant, with its type; several are `either` of them."""

    name: str
    types: tuple[str, ...] = (OBJECT,)


@dataclass(frozen=True, slots=True)
class Symbol:
    """A predicate or a numeric function, with its parameters."""

    name: str
    parameters: tuple[Typed, ...]


# Formulas


@dataclass(frozen=True, slots=True)
class Atom:
    """A predicate of terms; in an initial state or as an effect also a fact."""

    name: str
    args: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Equal:
    """Two terms are the same object."""

    left: str
    right: str


@dataclass(frozen=True, slots=True)
class Not:
    """Negation, by failure."""

    part: Formula


@dataclass(frozen=True, slots=True)
class And:
    """A conjunction; the empty one is true."""

    parts: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Or:
    """A disjunction; the empty one is false."""

    parts: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Forall:
    """For all objects of these types."""

    variables: tuple[Typed, ...]
    part: Formula


@dataclass(frozen=True, slots=True)
class Exists:
    """For some objects of these types."""

    variables: tuple[Typed, ...]
    part: Formula


@dataclass(frozen=True, slots=True)
class Compare:
    """A comparison of numbers: `operator` is <, <=, =, >= or >."""

    operator: str
    left: Expression
    right: Expression


Formula = Atom | Equal | Not | And | Or | Forall | Exists | Compare


@dataclass(frozen=True, slots=True)
class Value:
    """The value of a numeric function of terms."""

    name: str
    args: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """`operator` is +, -, * or /; a single operand of - is negated."""

    operator: str
    operands: tuple[Expression, ...]


Expression = Number | Value | Arithmetic

# Effects


@dataclass(frozen=True, slots=True)
class Add:
    """The atom holds afterwards, also where another effect deletes it."""

    atom: Atom


@dataclass(frozen=True, slots=True)
class Delete:
    """The atom does not hold afterwards."""

    atom: Atom


@dataclass(frozen=True, slots=True)
class Change:
    """What becomes of a number: `operator` is assign, increase, decrease, scale-up or scale-down."""

    operator: str
    target: Value
    amount: Expression


@dataclass(frozen=True, slots=True)
class When:
    """The effect, where the condition holds before."""

    condition: Formula
    effect: Effect


@dataclass(frozen=True, slots=True)
class Each:
    """The effect for all objects of these types: `forall`."""

    variables: tuple[Typed, ...]
    effect: Effect


@dataclass(frozen=True, slots=True)
class Together:
    """All of the effects: `and`."""

    parts: tuple[Effect, ...]


@dataclass(frozen=True, slots=True)
class Probabilistic:
    """One of the effects, each with its probability; nothing with what is left to 1."""

    branches: tuple[tuple[Number, Effect], ...]


Effect = Add | Delete | Change | When | Each | Together | Probabilistic


@dataclass(frozen=True, slots=True)
class Action:
    """An action schema."""

    name: str
    parameters: tuple[Typed, ...]
    precondition: Formula
    effect: Effect


@dataclass(frozen=True, slots=True)
class Derived:
    """A rule of a derived predicate, an axiom: the atom `name(parameters)` holds where the body does."""

    name: str
    parameters: tuple[Typed, ...]
    body: Formula


@dataclass(frozen=True, slots=True)
class Domain:
    """A PDDL domain. `types`: each type's parents, several where it is declared below `either`; object is not among
    the keys. `source`: the text of its file."""

    file: str
    name: str
    requirements: tuple[str, ...]
    types: Mapping[str, tuple[str, ...]]
    constants: tuple[Typed, ...]
    predicates: tuple[Symbol, ...]
    functions: tuple[Symbol, ...]
    derived: tuple[Derived, ...]
    actions: tuple[Action, ...]
    source: str


@dataclass(frozen=True, slots=True)
class Metric:
    """What plans are judged by: `direction` is minimize or maximize."""

    direction: str
    expression: Expression


@dataclass(frozen=True, slots=True)
class PlanningProblem:
    """A PDDL problem. `objects` does not have the domain's constants; `values` are the numbers of the initial state;
    `goal_reward` is PPDDL's, 0 where the file has none; `goal_place`: line and column of its goal."""

    file: str
    name: str
    domain: str
    objects: tuple[Typed, ...]
    init: tuple[Atom, ...]
    values: tuple[tuple[Value, Number], ...]
    goal: Formula
    metric: Metric | None
    goal_reward: Number
    goal_place: tuple[int, int] = (0, 0)
