"""What the name of a domain stands for, and which language bias goes with it."""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import locate, shipped
from nppg.errors import NppgError, Problem
from nppg.worlds.domain import Domain
from nppg.worlds.gym_domain import GymDomain, open_environment
from nppg.worlds.pddl_domain import SUFFIX as PDDL
from nppg.worlds.pddl_domain import PddlDomain, import_domain
from nppg.worlds.problems import BESIDE, sorted_out

_GYM = "gym:"


def open_domain(
    name_or_path: str | Path,
    parameters: Mapping[str, int | float | str] | None = None,
    problems: str | Path | Iterable[str | int | Path] = (),
    trust: bool | None = None,
) -> Domain:
    """The domain of a shipped file's name, of a file, in PDDL too, or of gym:ID, an environment of Gymnasium, whose
    `parameters` are gymnasium.make's arguments. `problems` are those that start states are drawn from: numbers, as in
    "1-20", or files, PDDL's or such as `nppg import` writes. `trust`: as of Domain. Raises NppgError."""
    numbers, files = sorted_out(problems)
    if is_environment(name_or_path):
        domain: Domain = open_environment(str(name_or_path).removeprefix(_GYM), parameters)
    elif Path(name_or_path).suffix == PDDL:
        domain, files = import_domain(name_or_path, files, parameters), []
    else:
        domain = Domain(name_or_path, parameters, trust)
        kind = GymDomain if domain.environment else PddlDomain if domain.pddl else Domain
        domain = domain if kind is Domain else kind(name_or_path, parameters, trust=trust)
        beside = domain.path.with_name(f"{domain.path.stem}{BESIDE}")
        if not files and beside.is_file():
            domain = domain.over(domain.problems_of([beside]))
    return with_problems(domain, numbers, files)


def with_problems(domain: Domain, numbers: Sequence[int], files: Sequence[Path]) -> Domain:
    """The domain with start states drawn from some of its problems, or from those in files. Raises NppgError."""
    if (numbers or files) and domain.environment:
        raise NppgError(f"{domain.path}: an environment of Gymnasium has no problems")
    if files:
        return domain.over(domain.problems_of(files))
    return domain.with_problems(numbers) if numbers else domain


def is_environment(name_or_path: str | Path) -> bool:
    """Whether it is gym:ID."""
    return str(name_or_path).startswith(_GYM)


def is_generated(name_or_path: str | Path) -> bool:
    """Whether its domain file is written by nppg: gym:ID, or PDDL."""
    return is_environment(name_or_path) or Path(name_or_path).suffix == PDDL


def language_bias_of(domain: Domain) -> LanguageBias:
    """The language bias that `bias_path` finds. That of an environment is the file beside its domain file, or where
    that is generated the shipped one of the environment's name without its version; else a generated one. Raises
    NppgError."""
    if isinstance(domain, PddlDomain) and domain.generated:
        return domain.language_bias()
    if not isinstance(domain, GymDomain):
        return LanguageBias.load(bias_path(domain.path, domain.given))
    own = domain.path.with_suffix(".yaml")
    if domain.generated:
        own = shipped("language_bias") / f"{re.sub('-v[0-9]+$', '', domain.path.stem)}.yaml"
    return LanguageBias.load(own) if own.is_file() else domain.language_bias()


def bias_path(domain: Path, given: Mapping[str, int | float | str]) -> Path:
    """The language bias of a domain file's name: beside it, else among the shipped ones. Raises NppgError where there
    is none, or where a given parameter is the name of another bias in that folder: the user is to choose."""
    path = domain.with_suffix(".yaml")
    if not path.is_file():
        try:
            path = locate(domain.stem, "language_bias", ".yaml")
        except NppgError:
            raise NppgError(
                [Problem(str(path), 0, 0, "there is no language bias of this name; give one by --bias")]
            ) from None
    for name, value in given.items():
        other = path.parent / f"{value}.yaml"
        if other in path.parent.glob("*.yaml") and other != path:
            own, default = (each.stem if each.parent == shipped("language_bias") else each for each in (other, path))
            raise NppgError(f"{name}={value} has a language bias of its own: give --bias {own}, or --bias {default}")
    return path


def warn_of_another_task(domain: Domain, bias: str | Path) -> None:
    """Warns where a language bias has the name of another value that a parameter of the domain may have, which it is
    for: policies would not see what the present value asks for. The domain has to refuse what is no such value."""
    name = Path(bias).stem
    for key, value in domain.parameters.items() if not domain.environment else ():
        others = (name, f"no {name}") if isinstance(value, str) and value != name else ()
        if [_starts(domain, key, other) for other in others] == [True, False]:
            message = f"the language bias {name} is for {key}={name}, but {key} is {value}: give --set {key}={name}"
            warnings.warn(message, stacklevel=2)


def _starts(domain: Domain, parameter: str, value: str) -> bool:
    """Whether the domain has a start with this value of a parameter."""
    try:
        Domain(domain.path, {**domain.given, parameter: value}, domain.trusted).start(np.random.default_rng(0))
    except NppgError:
        return False
    return True
