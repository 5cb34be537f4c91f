"""A problem of unified-planning as the text of a PDDL problem, with the names as they are.

unified-planning's own writer renames what PDDL has keywords for, like the predicate at, in domain and problem alike;
here the domain is there already, and has its names.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

from nppg.planning.optional import ConverterToPDDLString, UPProblem


def problem_text(problem: UPProblem, domain: str, constants: Collection[str]) -> str:
    """The text, for the domain of this name, which has these constants."""
    objects = [f"{each.name} - {each.type.name}" for each in problem.all_objects if each.name.lower() not in constants]
    converter = ConverterToPDDLString(problem.environment, _name)
    goal = problem.environment.expression_manager.And(problem.goals).simplify()
    if goal.is_bool_constant():
        wanted = "(and)" if goal.is_true() else "(or)"
    else:
        wanted = converter.convert(goal)
    parts = [
        f"(:domain {domain})",
        f"(:objects {' '.join(objects)})",
        f"(:init {' '.join(_facts(problem, converter))})",
        f"(:goal {wanted})",
    ]
    return "\n".join(["(define (problem given)", *parts, ")"])


def _facts(problem: UPProblem, converter: ConverterToPDDLString) -> Iterator[str]:
    """What the initial state has: all numbers, and what is true. Most facts are false, by a default, and are not even
    looked at then."""
    usual = all(value is not None and value.is_false() for value in map(problem.fluents_defaults.get, problem.fluents))
    values = problem.explicit_initial_values if usual else problem.initial_values
    for fluent, value in values.items():
        if value.is_true():
            yield converter.convert(fluent)
        elif not value.is_bool_constant():
            yield f"(= {converter.convert(fluent)} {converter.convert(value)})"


def _name(item: Any) -> str:
    """The name of a type, an object, a fluent or, with a question mark, a variable."""
    return f"?{item.name}" if type(item).__name__ == "Variable" else str(item.name)
