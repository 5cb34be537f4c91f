"""What TILDE learns from, whatever file it was written in: background knowledge, examples with targets, the language.

A reader of some format makes a `Task`; `nppg.tilde.knowledge` loads it, `nppg.tilde.estimators` learns from it.

A key addresses an example in one knowledge base (ACE's `load(key)`): `facts` hold for all examples, the example's root
variables are bound to its key. A model is an example with facts of its own (ACE's `load(models)`), where the key is
empty as a rule. Both may be mixed.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.terms import Ground
from nppg.errors import NppgError, Problem

CLASSIFY, REGRESS = "classify", "regress"
HEURISTICS = {CLASSIFY: ("gain_ratio", "gain"), REGRESS: ("variance",)}  # the first is the default
PRUNING = ("c45", "safe", "validation", "none")

_WHOLE = {"minimal_cases": 1, "max_depth": 0, "granularity": 0, "n_estimators": 1, "random_state": 0}

Target = str | int | float | tuple[float, ...]  # a class; a number; several numbers


@dataclass(frozen=True, slots=True)
class Example:
    """One example. A value that is missing is a fact that is absent."""

    key: tuple[Ground, ...] = ()  # what the root variables are bound to, one for each type of `task.template`
    target: Target | None = None  # None: it is to be predicted
    facts: tuple[Ground, ...] = ()  # its own, beside those of all: a fact is a name or (name, *arguments)
    weight: float = 1.0
    line: int = 0  # in the file of the examples, for messages
    name: str = ""  # what the file calls a model


@dataclass(frozen=True, slots=True)
class Settings:
    """How a tree is grown and pruned; the estimators' parameters have the same names. Raises NppgError, naming the
    field, for a value that cannot be."""

    mode: str = CLASSIFY
    heuristic: str = ""  # gain_ratio or gain; variance; empty: the mode's first
    minimal_cases: int = 2  # each leaf holds at least so many examples
    max_depth: int = 0  # tests on the longest path; 0: any number
    significance: float = 1.0  # level of the F-test of regression (ACE's ftest); 1 switches it off
    pruning: str = ""  # c45, safe, validation or none; empty: c45 for classes, none for numbers
    confidence: float = 0.25  # of C4.5's pessimistic pruning
    validation_share: float = 0.25  # of the examples, kept aside to prune by
    granularity: int = 0  # at most so many thresholds of a bound are tried at a node; 0: all
    n_estimators: int = 1  # trees, or rounds of trees that are added up
    learning_rate: float | None = None  # None: trees of samples vote; a number: they are added up, so much of each
    random_state: int = 0  # of what is drawn: the validation share, folds, samples

    def __post_init__(self) -> None:
        wrong = []
        if self.mode not in HEURISTICS:
            wrong.append(f"mode must be classify or regress, not {self.mode!r}")
        elif self.heuristic and self.heuristic not in HEURISTICS[self.mode]:
            known = " or ".join(HEURISTICS[self.mode])
            wrong.append(f"heuristic must be {known} to {self.mode}, not {self.heuristic!r}")
        if self.pruning and self.pruning not in PRUNING:
            wrong.append(f"pruning must be one of {', '.join(PRUNING)}, not {self.pruning!r}")
        for name, least in _WHOLE.items():
            if type(value := getattr(self, name)) is not int or value < least:
                wrong.append(f"{name} must be a whole number of at least {least}, not {value!r}")
        for name, most in (("significance", 1.0), ("confidence", 1.0), ("validation_share", 0.9)):
            if not (_is_number(value := getattr(self, name)) and 0 < value <= most):
                wrong.append(f"{name} must be a number above 0 and at most {most:g}, not {value!r}")
        if self.learning_rate is not None and not (_is_number(self.learning_rate) and 0 < self.learning_rate <= 1):
            wrong.append(f"learning_rate must be None or a number above 0 and at most 1, not {self.learning_rate!r}")
        if wrong:
            raise NppgError(Problem("", 0, 0, message) for message in wrong)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


SETTINGS = tuple(each.name for each in fields(Settings))


@dataclass(frozen=True)
class Task:
    """A learning problem. `bias.actions` is one template, the example's: the target predicate's name and the types of
    those of its arguments that are given (`dmuta(+mol, -class)`: Template("dmuta", ("mol",))); for models
    Template("example", ()). In `bias`, a mode's `#` argument without constants takes those that the data has in this
    place; see nppg.bias.declarations for `recall`, `lookaheads`, ANY and one name with two arities."""

    name: str
    bias: LanguageBias
    examples: tuple[Example, ...]
    facts: tuple[Ground, ...] = ()  # that hold for all examples
    background: str = ""  # clauses, as a text of Prolog; with facts of the same predicate these come first
    background_file: str = ""  # where the text is from, for messages
    examples_file: str = ""
    target: str = "class"  # what is predicted, as people call it
    classes: tuple[str, ...] = ()  # in the order of the file; none: those of the examples, sorted
    settings: Settings = field(default_factory=Settings)
    left_out: tuple[Problem, ...] = ()  # what of the file could not be carried over, each with its place

    @property
    def targets(self) -> list[Target | None]:
        """Of the examples, in order."""
        return [each.target for each in self.examples]

    @property
    def template(self) -> str:
        """The example as a literal is written: dmuta(mol)."""
        return str(self.bias.actions[0])
