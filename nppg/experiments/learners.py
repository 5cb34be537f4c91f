"""The learners by name, each with its options, and where the options of a run come from."""

from __future__ import annotations

from dataclasses import Field, fields

from nppg.bias.declarations import OptionPlaces, TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.errors import NppgError, Problem, suggestion
from nppg.learning.options import Common, Options, kind_of, problem_of
from nppg.logic.query import Constant
from nppg.rrl.options import RIBOptions, TGOptions, TrendiOptions

LEARNERS: dict[str, type[Common]] = {each.learner: each for each in (Options, TGOptions, RIBOptions, TrendiOptions)}
_RENAMED = {"min_examples": "min_leaf"}  # where an option has a limit's name
LIMITS = {_RENAMED.get(each.name, each.name): each for each in fields(TreeLimits)}  # of trees, by their options


def owners_of(option: str) -> dict[str, Field]:
    """The learners that have an option, each with its own."""
    return {learner: each for learner, kind in LEARNERS.items() for each in fields(kind) if each.name == option}


def learner_of(bias: LanguageBias, given: str | None = None) -> str:
    """The learner's name: the given one, else the language bias's, else nppg. Raises NppgError with all mistakes in the
    bias's options."""
    if problems := option_problems(bias):
        raise NppgError(problems)
    return given or _own_learner(bias)


def options_of(bias: LanguageBias, learner: str | None = None, **given: Constant) -> Common:
    """The options of a run: the given ones, else the language bias's, else the defaults. Of the bias's the learner has
    those that it knows. Raises NppgError, for the bias's options with their places."""
    name = learner_of(bias, learner)
    if name not in LEARNERS:
        raise NppgError(_no_learner(name))
    kind = LEARNERS[name]
    own = {each.name: each for each in fields(kind)}
    if unknown := [each for each in given if each not in own]:
        raise NppgError(
            Problem("", 0, 0, f"{each} is no option of the learner {name}{suggestion(each, own)}") for each in unknown
        )
    values = {each: _converted(value, own[each]) for each, value in bias.options.items() if each in own}
    return kind(**{**values, **given})  # type: ignore[arg-type]


def option_problems(bias: LanguageBias) -> list[Problem]:
    """The mistakes in the options of a language bias, located."""
    found = []
    for name, value in bias.options.items():
        places = bias.option_places.get(name, OptionPlaces())
        owners = owners_of(name)
        if name == "learner":
            place, message = places.value, "" if value in LEARNERS else _no_learner(value)
        elif name in LIMITS and _own_learner(bias) not in owners:
            place, message = places.name, _misplaced(name, owners)
        elif owners:
            place, message = places.value, problem_of(next(iter(owners.values())), value)
        else:
            known = {"learner", *(each.name for kind in LEARNERS.values() for each in fields(kind))}
            place, message = places.name, f"no learner has the option {name!r}{suggestion(name, known)}"
        found += [Problem(bias.file, *place, message)] if message else []
    return sorted(found)


def _own_learner(bias: LanguageBias) -> str:
    return str(bias.options.get("learner", Options.learner))


def _no_learner(name: Constant) -> str:
    return f"learner must be one of {', '.join(LEARNERS)}, not {name!r}{suggestion(str(name), LEARNERS)}"


def _misplaced(option: str, owners: dict[str, Field]) -> str:
    """That a limit of trees stands among the options."""
    only = f", unless the option learner is {' or '.join(owners)}" if owners else ""
    return f"{option} limits trees: write tree: {{{LIMITS[option].name}: ...}}{only}"


def _converted(value: Constant, option: Field) -> Constant:
    """Of the option's kind, as the command line gives it."""
    return float(value) if kind_of(option) is float else value
