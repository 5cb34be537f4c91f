"""The reader of PDDL files."""

from __future__ import annotations

from pathlib import Path

from nppg.pddl.domain_file import domain_of
from nppg.pddl.model import Domain, PlanningProblem
from nppg.pddl.problem_file import problem_of
from nppg.pddl.tokens import opened


def read_domain(path: str | Path) -> Domain:
    """The domain of a file. Raises NppgError with all mistakes that it has."""
    return domain_of(opened(path))


def read_problem(path: str | Path, domain: Domain) -> PlanningProblem:
    """The problem of a file, for this domain. Raises NppgError with all mistakes that it has."""
    return problem_of(opened(path), domain)
