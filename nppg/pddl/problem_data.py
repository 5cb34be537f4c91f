"""A PDDL problem as facts: those that no action changes, and those of its initial state."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from nppg.pddl.changing import changed_functions, fluents
from nppg.pddl.domain_text import declares_object
from nppg.pddl.effects_text import features
from nppg.pddl.goals import Ground, condition_term, fact, goal_parts, literals
from nppg.pddl.hierarchy import memberships
from nppg.pddl.model import OBJECT, Atom, Domain, PlanningProblem
from nppg.pddl.names import APART, Names


@dataclass(frozen=True, slots=True)
class ProblemData:
    """The facts of a problem, each of them once: a tuple of a name and its arguments, or a name."""

    static: list[Ground]
    fluents: list[Ground]


def problem_data(problem: PlanningProblem, domain: Domain, names: Names, goal_predicates: Iterable[str]) -> ProblemData:
    """The facts of a problem for the file that `domain_text` writes, with the same names and goal predicates."""
    wanted = set(goal_predicates)
    has_object = declares_object(domain, names)
    static: list[Ground] = [
        (names.types[type_], name)
        for type_, name in memberships(domain, (*domain.constants, *problem.objects))
        if type_ != OBJECT or has_object
    ]
    changing: list[Ground] = []
    for atom in problem.init:
        group = changing if atom.name in fluents(domain) else static
        group.append(fact(names.predicates[atom.name], atom.args))
    for function, number in problem.values:
        if function.name not in APART:
            group = changing if function.name in changed_functions(domain) else static
            group.append((names.functions[function.name], *function.args, number))
    for part in goal_parts(problem, domain):
        if isinstance(part, Atom) and part.name in wanted:
            static.append(fact(names.goal[part.name], part.args))
        else:
            static.append((names.own["condition"], condition_term(part, problem, domain, names, has_object)))
    static.append((names.own["goals"], literals(problem.goal, problem, domain)))
    if features(domain).reward:
        static.append((names.own["goal_reward"], problem.goal_reward))
        changing.append((names.own["gained"], 0))
    return ProblemData(list(dict.fromkeys(static)), list(dict.fromkeys(changing)))
