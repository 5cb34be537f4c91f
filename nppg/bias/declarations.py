"""What a language bias declares: arguments, modes, templates, the limits of trees, and all of it together."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from nppg.bias.names import atom, written
from nppg.errors import NppgError, Problem
from nppg.logic.query import OPEN, Constant

EQUALITY = ("equal", "=")  # its name in a file, and in Prolog

ANY = "_"  # a type that is like every other one

MIN_VARIANCE = 1e-9  # the default, which alone is in the square of the targets' unit


@dataclass(frozen=True, slots=True)
class Argument:
    """One argument of a mode declaration; prints as it is written in the file."""

    kind: str  # "+" existing variable, "-" new variable, "+-" either, "#" one of `constants`
    type: str
    constants: tuple[Constant, ...] = ()

    def __str__(self) -> str:
        if self.kind != "#":
            return f"{self.kind}{self.type}"
        items = ", ".join(map(written, self.constants))
        return items if len(self.constants) == 1 else f"[{items}]"


@dataclass(frozen=True, slots=True)
class Mode:
    """A literal that a tree may test; prints as it is written in the file. Its place is no part of its identity."""

    name: str  # "=" for the built-in equal/2, "=<" or ">=" for a bound, whose threshold is OPEN
    args: tuple[Argument, ...]
    lookahead: int = 0  # how many further literals a test that starts with this one may add at once
    line: int = field(default=0, compare=False)
    column: int = field(default=0, compare=False)
    recall: int = 0  # at most so many literals of this mode stand in a query (ACE's rmode(N: ...)); 0: any number

    def __str__(self) -> str:
        if self.name in OPEN:
            return f"{self.args[0]} {self.name} #"
        return atom("equal" if self.name == "=" else written(self.name), self.args)


@dataclass(frozen=True, slots=True)
class Follower:
    """A literal of a lookahead template. An argument is what a mode has, or the number of a place whose term it is:
    from 0, through the arguments of the template's first literal and of the followers before this one."""

    name: str
    args: tuple[int | Argument, ...]


@dataclass(frozen=True, slots=True)
class Lookahead:
    """A template of what a test may add at once behind a literal (ACE's lookahead/2): behind each literal `name` whose
    arguments are those `given`, None for anything, all `followers` together.

    That of sbond(M, A, B, T) and atom(M, B, [c, n]) is
    Lookahead("sbond", (None,) * 4, (Follower("atom", (0, 2, Argument("#", "element", ("c", "n")))),))."""

    name: str
    given: tuple[Constant | None, ...]
    followers: tuple[Follower, ...]
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Template:
    """The form of one kind of action, or of the goal."""

    name: str
    types: tuple[str, ...]  # of its arguments
    line: int = field(default=0, compare=False)
    column: int = field(default=0, compare=False)

    def __str__(self) -> str:
        return atom(written(self.name), self.types)


@dataclass(frozen=True, slots=True)
class TreeLimits:
    """When a tree stops growing. Raises NppgError, naming the field, for a value that cannot be."""

    max_depth: int = 4  # tests on the longest path; 0: the tree is one leaf
    min_examples: int = 2  # "minimal cases": each leaf holds at least so many examples
    min_variance: float = MIN_VARIANCE  # a node whose targets have less variance is a leaf
    significance: float = 1.0  # level of the F-test that a split must pass (ACE's ftest); 1.0 switches it off
    granularity: int = 0  # at most so many thresholds of a bound are tried at a node, quantiles of its examples; 0: all

    def __post_init__(self) -> None:
        whole = (("max_depth", 0), ("min_examples", 1), ("granularity", 0))
        wrong = [
            f"{name} must be a whole number of at least {least}, not {value!r}"
            for name, least in whole
            if type(value := getattr(self, name)) is not int or value < least
        ]
        if not (_is_number(self.min_variance) and 0 <= self.min_variance < math.inf):
            wrong.append(f"min_variance must be a finite number of at least 0, not {self.min_variance!r}")
        if not (_is_number(self.significance) and 0 < self.significance <= 1):
            wrong.append(f"significance must be a number above 0 and at most 1, not {self.significance!r}")
        if wrong:
            raise NppgError(Problem("", 0, 0, message) for message in wrong)

    def least_variance(self, unit: float) -> float:
        """`min_variance`; that of who states none is in the square of the targets' unit."""
        return self.min_variance * unit * unit if self.min_variance == MIN_VARIANCE else self.min_variance


class OptionPlaces(NamedTuple):
    """Line and column of an option's name and of its value."""

    name: tuple[int, int] = (0, 0)
    value: tuple[int, int] = (0, 0)


@dataclass(frozen=True)
class Declared:
    """The contents of one bias file."""

    file: str
    actions: tuple[Template, ...]  # one for each kind of action
    goal: Template | None
    types: Mapping[str, tuple[str, ...]]  # predicate -> argument types; the action's and the goal's too; see types_of
    subtypes: Mapping[str, str]  # type -> its direct supertype
    modes: tuple[Mode, ...]
    max_lookahead: int  # of any mode
    max_variables: int  # existential variables in one query
    tree: TreeLimits
    sentences: Mapping[str, str] = field(default_factory=dict)  # predicate -> its literals in plain English
    options: Mapping[str, Constant] = field(default_factory=dict)  # of learners, which say what they may be
    is_default_maximum: bool = field(default=False, compare=False, repr=False)  # the file says no max_variables
    option_places: Mapping[str, OptionPlaces] = field(default_factory=dict, compare=False, repr=False)
    lookaheads: tuple[Lookahead, ...] = ()

    def types_of(self, name: str, arity: int) -> tuple[str, ...] | None:
        """Those of a predicate's arguments. Where one name has several arities, the others are kept as name/arity."""
        found = self.types.get(name)
        return found if found is not None and len(found) == arity else self.types.get(f"{name}/{arity}")


def upwards(subtypes: Mapping[str, str], type_: str) -> list[str]:
    """A type and all above it, each once."""
    chain = [type_]
    while (above := subtypes.get(chain[-1])) is not None and above not in chain:
        chain.append(above)
    return chain


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
