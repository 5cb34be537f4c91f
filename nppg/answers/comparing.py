"""Which mode declaration compares what is no number."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from nppg.bias.declarations import Mode
from nppg.bias.language_bias import LanguageBias
from nppg.errors import NppgError, Problem
from nppg.logic.query import OPEN, Literal, Query, Term, Var

NO_NUMBER = "which is compared with a threshold and is no number"  # as prolog/test_clauses.pl says it too


def mode_of(bound: Literal, test: Query, bias: LanguageBias) -> Mode | None:
    """The mode declaration that a bound of a test is an instance of; none in a bias that has none."""
    type_ = _type(bound.args[0], test, bias)
    fitting = [mode for mode in bias.modes if mode.name == bound.name and bias.fits(type_, mode.args[0].type)]
    return fitting[0] if fitting else None


def _type(term: Term, test: Query, bias: LanguageBias) -> str:
    if isinstance(term, Var) and term.index < len(bias.roots):
        return bias.roots[term.index]
    places = ((bias.types_of(each.name, len(each.args)) or (), each.args) for each in test)
    return next((type_ for types, args in places for type_, arg in zip(types, args, strict=False) if arg == term), "")


def at_mode(problem: Problem, mode: Mode, bias: LanguageBias) -> Problem:
    """That something compared is no number, with the place of the comparison before that of the number."""
    return Problem(bias.file, mode.line, mode.column, f"{mode} compares what is no number: {problem}")


def located(error: NppgError, bias: LanguageBias, tests: Iterable[Query], fails: Callable[[Query], bool]) -> NppgError:
    """What tests have raised, where it is that something is no number with the place of the mode whose bound compares
    it: one of a test that fails, and does not without it. `fails` asks a test by itself."""
    if not any(NO_NUMBER in each.message for each in error.problems):
        return error
    for test in tests:
        rest = tuple(each for each in test if each.name not in OPEN)
        for bound in (each for each in test if each.name in OPEN):
            mode = mode_of(bound, test, bias)
            if mode and fails((*rest, bound)) and not (rest and fails(rest)):
                return NppgError(at_mode(each, mode, bias) for each in error.problems)
    return error
