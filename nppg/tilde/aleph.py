"""Reads data sets as Aleph has them: background (`.b`), positive and negative examples (`.f`, `.n`), or one `.pl` file
with sections as the port to SWI-Prolog has it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

from nppg.bias.declarations import ANY, Template
from nppg.bridge.terms import Ground
from nppg.errors import NppgError, Problem, suggestion
from nppg.tilde.aleph_settings import SEARCH, SILENT, TREE
from nppg.tilde.constants import asked
from nppg.tilde.declared import askable, bias_of, looking_ahead
from nppg.tilde.mode_terms import Language, own_type
from nppg.tilde.program import Background, Clause, background, conditional, read
from nppg.tilde.task import CLASSIFY, REGRESS, Example, Settings, Target, Task
from nppg.tilde.terms import (
    Indicator,
    arguments,
    elements,
    indicator,
    told,
)

OPERATORS = [(500, "fy", "#"), (500, "fy", "*"), (900, "xfy", "because"), (500, "fy", "-#"), (500, "fy", "+-")]
POSITIVE, NEGATIVE = "pos", "neg"

_SECTIONS = {"begin_bg": "b", "begin_in_pos": "f", "begin_in_neg": "n"} | dict.fromkeys(
    ("end_bg", "end_in_pos", "end_in_neg"), "b"
)


def read_aleph(file: Path, positive: Path | None = None, negative: Path | None = None) -> Task:
    """The task of a background file and of its examples' files, or of a file that has all in sections. Raises NppgError
    with what cannot be read, and where there are no examples or modes."""
    left_out: list[Problem] = []
    sections: dict[str, list[Clause]] = {"b": [], "f": [], "n": []}
    section = "b"
    for clause in conditional(read(file, OPERATORS), left_out):
        word = clause.predicate[0] if clause.kind == "directive" else ""
        if word in _SECTIONS:
            section = _SECTIONS[word]
        else:
            sections[section].append(clause)
    for path, its in ((positive, "f"), (negative, "n")):
        if path:
            sections[its] += conditional(read(path, OPERATORS), left_out)
    return _Reading(file, sections, left_out).task(positive or file)


class _Reading:
    """What the files have."""

    def __init__(self, file: Path, sections: dict[str, list[Clause]], left_out: list[Problem]):
        self.file = file
        self.left_out = left_out
        self.settings: dict[str, Clause] = {}
        self.heads: list[Clause] = []
        self.modes: list[Clause] = []
        self.determined: dict[Indicator, list[Clause]] = {}
        self.clauses = [clause for clause in sections["b"] if not self._declares(clause)]
        self.examples = {
            name: [clause for clause in sections[its] if self._is_example(clause)]
            for name, its in ((POSITIVE, "f"), (NEGATIVE, "n"))
        }
        if not self.examples[POSITIVE]:
            raise NppgError([Problem(str(file), 0, 0, f"there are no positive examples: {file.with_suffix('.f')}")])
        head = self.heads[-1:]
        determined = list(self.determined)
        first = indicator(self.examples[POSITIVE][0].data)
        self.target = indicator(arguments(head[0].data)[1]) if head else determined[0] if determined else first
        if self.target != first:
            self.target = first if first in determined or not determined else self.target

    def _declares(self, clause: Clause) -> bool:
        """Whether it is a directive of Aleph's."""
        if clause.kind != "directive":
            return False
        (name, arity), args = clause.predicate, arguments(clause.data)
        if name in ("set", "aleph_set") and arity == 2:
            setting = str(args[0])
            if setting in TREE:
                self.settings[setting] = clause
            elif setting not in SEARCH:
                hint = suggestion(setting, [*TREE, *SEARCH])
                self.left_out.append(
                    clause.problem(f"{told(clause.data)} is left aside: Aleph has no such parameter{hint}")
                )
        elif name == "modeh" and arity == 2:
            self.heads.append(clause)
        elif name in ("modeb", "mode") and arity == 2:
            self.modes.append(clause)
        elif (name, arity) == ("determination", 2):
            target, body = (arguments(each) for each in args)
            if len(target) == len(body) == 2:
                self.determined.setdefault((str(target[0]), int(target[1])), []).append(clause)  # type: ignore[arg-type]
        elif name not in SILENT:
            return False
        return True

    def _is_example(self, clause: Clause) -> bool:
        if clause.kind == "fact":
            return True
        self.left_out.append(clause.problem(f"an example is a ground fact: {told(clause.data)} is left out"))
        return False

    def task(self, examples_file: Path) -> Task:
        types = self._types()
        wanted = self._dependent(types)
        rows = self._rows(wanted)
        number = wanted is not None and self._is_regression([target for _, target, _ in rows])
        modes = self._body_modes()
        asked = [indicator(arguments(clause.data)[1]) for clause in modes]
        base = background(self.clauses, asked, self.left_out)
        key_types = tuple(type_ for i, type_ in enumerate(types) if i != wanted)
        keys = {type_: {key[i] for key, _, _ in rows} for i, type_ in enumerate(key_types)}
        language = Language({}, _Constants(base, self._values(modes, base, keys)), self.left_out)
        for clause in modes:
            language.declare(self._as_rmode(clause, base))
        most = self._whole("lookahead", 1)
        steps = {
            (mode.name, len(mode.args)): most
            for mode in language.modes
            if any(arg.kind == "+-" for arg in mode.args) and mode.name != "="
        }
        kept, _ = askable(language.modes, (), base, (), self.file, self.left_out)
        template = Template(self.target[0], key_types)
        classes = elements(self._value("classes", ""))
        default = [POSITIVE, NEGATIVE] if wanted is None else []
        facts = tuple(fact for fact in base.facts if indicator(fact) != self.target)
        return Task(
            name=self.file.stem,
            bias=bias_of(self.file, template, {}, looking_ahead(kept, steps), (), most),
            examples=tuple(Example(key, _target(target, number), line=line) for key, target, line in rows),
            facts=facts,
            background=base.text,
            background_file=str(self.file),
            examples_file=str(examples_file),
            target=self.target[0],
            classes=() if number else tuple(map(told, classes or default)),
            settings=self._settings(number),
            left_out=tuple(self.left_out),
        )

    def _types(self) -> tuple[str, ...]:
        """Those of the target's arguments."""
        for clause in [*reversed(self.heads), *self.modes]:
            literal = arguments(clause.data)[1]
            if indicator(literal) == self.target:
                return tuple(map(own_type, arguments(literal)))
        return (ANY,) * self.target[1]

    def _dependent(self, types: Sequence[str]) -> int | None:
        """The place of the argument that is predicted; None where positive and negative examples are told apart."""
        if "dependent" in self.settings:
            place = self._whole("dependent", 0) - 1
            if 0 <= place < len(types):
                return place
            message = f"dependent has to be an argument of {self.target[0]}/{self.target[1]}"
            raise NppgError([self.settings["dependent"].problem(message)])
        if self.examples[NEGATIVE]:
            return None
        for clause in reversed(self.heads):
            literal = arguments(clause.data)[1]
            outputs = [i for i, arg in enumerate(arguments(literal)) if indicator(arg)[0] in ("-", "#")]
            if indicator(literal) == self.target and outputs:
                return outputs[-1]
        where = self.file.with_suffix(".n")
        message = f"there are no negative examples ({where}), and no set(dependent, N) says what to predict"
        raise NppgError([Problem(str(self.file), 0, 0, message)])

    def _rows(self, wanted: int | None) -> list[tuple[tuple[Ground, ...], Ground, int]]:
        """Key, target and line of each example."""
        rows: list[tuple[tuple[Ground, ...], Ground, int]] = []
        for name, clauses in self.examples.items():
            for clause in clauses:
                args = arguments(clause.data)
                if clause.predicate != self.target:
                    what = f"{told(clause.data)} is left out: examples are of {self.target[0]}/{self.target[1]}"
                    self.left_out.append(clause.problem(what))
                elif wanted is None:
                    rows.append((args, name, clause.line))
                elif name == POSITIVE:
                    rows.append(((*args[:wanted], *args[wanted + 1 :]), args[wanted], clause.line))
        return rows

    def _is_regression(self, targets: Iterable[Ground]) -> bool:
        tree = self._value("tree_type", "")
        if tree in ("model", "regression"):
            return True
        return tree == "" and "classes" not in self.settings and all(isinstance(each, int | float) for each in targets)

    def _settings(self, is_number: bool) -> Settings:
        """How the tree is grown: as Aleph's parameters of trees say, where it is to grow one."""
        if "tree_type" not in self.settings:
            return Settings(mode=REGRESS, significance=0.05) if is_number else Settings(mode=CLASSIFY)
        confidence = self._value("confidence", 0.25)
        return Settings(
            mode=REGRESS if is_number else CLASSIFY,
            heuristic="" if is_number else "gain",
            minimal_cases=max(1, self._whole("minpos", 2)),
            pruning="c45" if self._value("prune_tree", "false") == "true" and not is_number else "none",
            confidence=float(confidence) if isinstance(confidence, int | float) and 0 < confidence <= 1 else 0.25,
        )

    def _value(self, name: str, default: Ground) -> Ground:
        return arguments(self.settings[name].data)[1] if name in self.settings else default

    def _whole(self, name: str, default: int) -> int:
        value = self._value(name, default)
        return value if type(value) is int and value >= 0 else default

    def _body_modes(self) -> list[Clause]:
        """Those of predicates that determine the target. Raises NppgError where there are none."""
        allowed = {
            (str(body[0]), int(body[1]))  # type: ignore[arg-type]
            for clause in self.determined.get(self.target, ())
            for body in (arguments(arguments(clause.data)[1]),)
        }
        found = []
        for clause in self.modes:
            predicate = indicator(arguments(clause.data)[1])
            if predicate == self.target:
                continue
            if predicate in allowed or not self.determined:
                found.append(clause)
            else:
                what = f"{predicate[0]}/{predicate[1]} is not tested: no determination names it"
                self.left_out.append(clause.problem(what + suggestion(predicate[0], [name for name, _ in allowed])))
        moded = {indicator(arguments(clause.data)[1]) for clause in self.modes}
        for clause in self.determined.get(self.target, ()):
            body = arguments(arguments(clause.data)[1])
            if (*body,) not in moded:
                self.left_out.append(
                    clause.problem(f"{body[0]}/{body[1]} has a determination and no mode: it is not tested")
                )
        return found

    def _values(
        self, modes: Iterable[Clause], base: Background, keys: dict[str, set[Ground]]
    ) -> dict[str, set[Ground]]:
        """The values of each type: those of keys, what facts have where a mode names the type, and of what the
        predicate of that name holds."""
        found = {type_: set(values) for type_, values in keys.items()}
        places: dict[Indicator, list[tuple[int, str]]] = {}
        for clause in modes:
            literal = arguments(clause.data)[1]
            for i, arg in enumerate(arguments(literal)):
                if indicator(arg)[0] in ("+", "-"):
                    places.setdefault(indicator(literal), []).append((i, own_type(arg)))
                    places.setdefault((own_type(arg), 1), []).append((0, own_type(arg)))
        for fact in base.facts:
            for i, type_ in places.get(indicator(fact), ()):
                found.setdefault(type_, set()).add(arguments(fact)[i])
        return found

    def _as_rmode(self, clause: Clause, base: Background) -> Clause:
        """A mode in ACE's terms. What Aleph calls an output may be a variable that is there, since both stand for one
        term of an example; constants of a predicate that rules define are what it answers where the inputs are known.
        Aleph's recall bounds the answers of one call and has no counterpart here."""
        literal = arguments(clause.data)[1]
        if not isinstance(literal, tuple):
            return replace(clause, data=("rmode", literal))
        args = [("+-", arg[1]) if indicator(arg) == ("-", 1) else arg for arg in literal[1:]]
        if indicator(literal) in base.rules and any(indicator(arg) == ("#", 1) for arg in args):
            free: list[Ground] = [("$VAR", i) for i in range(len(args))]
            constants = [free[i] for i, arg in enumerate(args) if indicator(arg) == ("#", 1)]
            inputs = [("value", arg[1], free[i]) for i, arg in enumerate(args) if indicator(arg) == ("+", 1)]
            generator: Ground = (literal[0], *free)
            for each in reversed(inputs):
                generator = (",", each, generator)
            joined: Ground = constants[-1]
            for each in reversed(constants[:-1]):
                joined = (",", each, joined)
            given = (free[i] if indicator(arg) == ("#", 1) else arg for i, arg in enumerate(args))
            mode: Ground = ("rmode", ("#", (":", joined, generator), (literal[0], *given)))
            return replace(clause, data=mode, text=f"the mode {told(literal)}")
        return replace(clause, data=("rmode", (literal[0], *args)))


class _Constants:
    """What predicates answer where their inputs are values that the data has."""

    def __init__(self, base: Background, values: dict[str, set[Ground]]):
        self.base = base
        self.facts = [("value", type_, value) for type_, its in values.items() for value in its]

    def __call__(self, variables: Ground, generator: Ground, clause: Clause) -> list[tuple[Ground, ...]]:
        rows = asked(self.base, [generator], arguments(variables), self.facts)
        return [row for row in rows if not any(isinstance(value, tuple) for value in row)]


def _target(value: Ground, is_number: bool) -> Target:
    return value if is_number and isinstance(value, int | float) else told(value)
