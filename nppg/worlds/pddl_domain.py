"""Domains that come from PDDL: the domain file that it is written as, and PDDL's problems as its start states."""

from __future__ import annotations

import tempfile
from collections import Counter
from collections.abc import Mapping, Sequence
from functools import cache, partial
from pathlib import Path

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.prolog import ask
from nppg.errors import NppgError, Problem
from nppg.features.bias_edit import extended
from nppg.features.derived import Derived
from nppg.features.moves import roads
from nppg.features.selection import text as clauses_of
from nppg.pddl.bias_text import bias_text
from nppg.pddl.domain_text import domain_text
from nppg.pddl.goals import goal_predicates, unreachable
from nppg.pddl.model import Domain as Pddl
from nppg.pddl.model import PlanningProblem
from nppg.pddl.names import Names, names_of
from nppg.pddl.opening_text import module_name
from nppg.pddl.problem_data import problem_data
from nppg.pddl.reader import read_domain, read_problem
from nppg.worlds.deriving import worth_testing
from nppg.worlds.domain import Domain
from nppg.worlds.problems import Problems
from nppg.worlds.state import Interpretation, Static, standard_order
from nppg.worlds.world import Action, State

SUFFIX = ".pddl"


@cache
def taken(name: str, arity: int) -> bool:
    """Whether a predicate of a domain file cannot have this name, since Prolog or nppg has it."""
    return ask("taken", name, arity) == "true"


class PddlDomain(Domain):
    """A domain file that was written from PDDL, which lies beside it: `pddl` names it."""

    def __init__(
        self,
        path: str | Path,
        parameters: Mapping[str, int | float | str] | None = None,
        pddl: Pddl | None = None,
        trust: bool | None = None,
    ):
        super().__init__(path, parameters, trust)
        self.generated = pddl is not None  # its file, which has no place then
        self.model = pddl or read_domain(self.path.parent / self.pddl)
        self.derived: list[Derived] = []  # predicates that the domain file has beyond PDDL's
        self.names: Names = names_of(self.model, taken)

    def start(self, rng: np.random.Generator) -> State:
        if not (self.chosen or self.has_start):
            raise NppgError([Problem(self.model.file, 0, 0, "the domain needs problems: name them by --problems")])
        return super().start(rng)

    @property
    def companions(self) -> dict[str, bytes]:
        return {self.pddl: self.model.source.encode(), **super().companions}

    @property
    def wanted(self) -> list[str]:
        """The PDDL predicates of which goal facts of this domain file say what is wanted."""
        static = {name for name, _ in self.static}
        return [predicate for predicate, name in self.names.goal.items() if name in static]

    def language_bias(self) -> LanguageBias:
        """The generated one."""
        text = bias_text(self.model, self.names, self.wanted, roads(self.derived))
        text = extended(text, self.derived)
        return LanguageBias.parse(text, str(self.path.with_suffix(".yaml")))

    def problems_of(self, files: Sequence[Path]) -> Problems:
        if any(file.suffix == ".pl" for file in files):
            return super().problems_of(files)
        files = problem_files(files, self.model)
        return Problems(dict(enumerate(_names(files), 1)), partial(self._start, files), files=files)

    def _start(self, files: Sequence[Path], number: int) -> Interpretation:
        return self.start_of(read_problem(files[number - 1], self.model))

    def _start_of_read(self, problems: Sequence[PlanningProblem], number: int) -> Interpretation:
        return self.start_of(problems[number - 1])

    def over_read(self, problems: Sequence[PlanningProblem]) -> PddlDomain:
        """The same domain with these problems."""
        files = [Path(each.file) for each in problems]
        names = dict(enumerate(_names(files), 1))
        return self.over(Problems(names, partial(self._start_of_read, problems), files=files))

    def start_of(self, problem: PlanningProblem) -> Interpretation:
        """The start state of a problem. Raises NppgError where its goal cannot be reached."""
        if wrong := out_of_reach(problem, self.model):
            raise NppgError(wrong)
        data = problem_data(problem, self.model, self.names, self.wanted)
        return Interpretation(sorted(data.fluents, key=standard_order), Static(sorted(data.static, key=standard_order)))

    def file_of(self, number: int) -> Path | None:
        """The PDDL file that a problem comes from, None where it comes from another one."""
        files = self._problems.files if number in self.problems and self._problems else ()
        return files[number - 1] if files else None

    def step_of_plan(self, name: str, args: Sequence[str]) -> Action:
        """The action that PDDL's plans have with this name and these objects."""
        return (self.names.actions[name], *args) if args else self.names.actions[name]

    def plan_step(self, action: Action) -> str:
        """An action as PDDL's plans have it: (sail l1 l2)."""
        name, *args = action if isinstance(action, tuple) else (action,)
        own = {prolog: pddl for pddl, prolog in self.names.actions.items()}
        return f"({' '.join([own[str(name)], *map(str, args)])})"


def out_of_reach(problem: PlanningProblem, domain: Pddl) -> list[Problem]:
    """What the goal wants and no action can reach."""
    return [Problem(problem.file, *problem.goal_place, message) for message in unreachable(problem, domain)]


def problem_files(files: Sequence[Path], domain: Pddl) -> list[Path]:
    """Without the file of the domain, which a pattern like *.pddl brings along. Raises NppgError where none is left."""
    source = domain.source.encode()
    left = [file for file in files if file.stat().st_size != len(source) or file.read_bytes() != source]
    if files and not left:
        raise NppgError([Problem(str(files[0]), 0, 0, "this is the domain: name its problems, too")])
    return left


def _names(files: Sequence[Path]) -> list[str]:
    """What tells the files apart: their names without suffix, or with their folders where these alone do."""
    for parts in range(1, max((len(file.parts) for file in files), default=0) + 1):
        names = ["/".join(file.with_suffix("").parts[-parts:]) for file in files]
        if len(set(names)) == len(names):
            break
    return names


def _sizes(problems: Sequence[PlanningProblem]) -> dict[str, float]:
    """How many facts of each predicate there are at the start, on average."""
    counts = Counter(atom.name for each in problems for atom in each.init)
    return {name: count / len(problems) for name, count in counts.items()}


def import_domain(
    path: str | Path, problems: Sequence[Path] = (), parameters: Mapping[str, int | float | str] | None = None
) -> PddlDomain:
    """The domain of a PDDL file, with these problems. Raises NppgError with the mistakes in all files."""
    pddl = read_domain(path)
    read: list[PlanningProblem] = []
    wrong: list[Problem] = []
    for each in problem_files(problems, pddl):
        try:
            read.append(read_problem(each, pddl))
            wrong += out_of_reach(read[-1], pddl)
        except NppgError as error:
            wrong += error.problems
    if wrong:
        raise NppgError(wrong)
    names = names_of(pddl, taken)
    wanted = frozenset().union(*(goal_predicates(each, pddl) for each in read))
    text = domain_text(pddl, names, wanted, _sizes(read))
    domain = _loaded(text, pddl, parameters, read)
    if read:
        chosen = worth_testing(domain, domain.language_bias())
        domain = _loaded(text + clauses_of(chosen), pddl, parameters, read)
        domain.derived = chosen
    return domain


def _loaded(
    text: str,
    pddl: Pddl,
    parameters: Mapping[str, int | float | str] | None,
    problems: Sequence[PlanningProblem],
) -> PddlDomain:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, f"{module_name(pddl)}.pl")
        file.write_text(text, encoding="utf-8")
        domain = PddlDomain(file, parameters, pddl)
    domain.path = Path(file.name)
    return domain.over_read(problems) if problems else domain
