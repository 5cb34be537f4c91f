"""Random walks in which nppg and unified-planning, each reading the same PDDL, are to agree in every state."""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from random import Random

import pytest

from nppg.bridge.terms import Ground
from nppg.worlds.opening import open_domain
from nppg.worlds.pddl_domain import PddlDomain
from nppg.worlds.state import facts_of, static_of
from nppg.worlds.world import Action, State

pytest.importorskip("unified_planning")

from pyparsing import ParseBaseException
from unified_planning.engines import SequentialPlanValidator, UPSequentialSimulator
from unified_planning.engines.sequential_simulator import evaluate_quality_metric
from unified_planning.environment import get_environment
from unified_planning.exceptions import UPException
from unified_planning.io import PDDLReader
from unified_planning.model import Fluent, InstantaneousAction, Problem
from unified_planning.model.metrics import MinimizeActionCosts

get_environment().error_used_name = False  # an action may be called like a predicate

Named = tuple[str, ...]  # an action or a fact of PDDL with its arguments
REFUSALS = (  # what unified-planning's reader raises for what it does not support, or where it is at fault itself
    UPException,
    ParseBaseException,
    SyntaxError,
    NotImplementedError,
    AssertionError,
    AttributeError,
    KeyError,
    TypeError,
    ValueError,
)
MANY = 300  # ground actions that are asked for in every state
_ORDER = ("(define", "(:domain", "(:requirements", "(:objects", "(:init", "(:goal", "(:metric")


class Reference:
    """A problem as unified-planning reads and simulates it. Raises REFUSALS."""

    def __init__(self, domain: Path, problem: Path):
        environment = get_environment()
        text = in_order(problem.read_text(encoding="utf-8"))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.problem: Problem = PDDLReader().parse_problem_string(domain.read_text(encoding="utf-8"), text)
        self.objects = {each.name: environment.expression_manager.ObjectExp(each) for each in self.problem.all_objects}
        self.possible = {each.name: [_objects(self.problem, one) for one in each.parameters] for each in self._actions}

    @property
    def _actions(self) -> list[InstantaneousAction]:
        return list(self.problem.instantaneous_actions)

    def actions_in_all(self) -> int:
        """How many ground actions there are, whether or not they are ever applicable."""
        return sum(math.prod(map(len, choices)) for choices in self.possible.values())

    def atoms_in_all(self) -> int:
        """How many facts and numbers there are."""
        signatures = [each.signature for each in self.problem.fluents]
        return sum(math.prod(len(_objects(self.problem, one)) for one in each) for each in signatures)

    def begin(self) -> None:
        """Goes to the initial state."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.simulator = UPSequentialSimulator(self.problem, error_on_failed_checks=False)
        self.state = self.simulator.get_initial_state()

    def every(self) -> Iterator[Named]:
        """All ground actions."""
        for name, choices in self.possible.items():
            yield from ((name, *args) for args in product(*choices))

    def some(self, rng: Random, count: int) -> Iterator[Named]:
        """Ground actions at random."""
        names = [name for name, choices in self.possible.items() if all(choices)]
        for _ in range(count):
            name = rng.choice(names)
            yield (name, *map(rng.choice, self.possible[name]))

    def applicable(self, named: Named) -> bool:
        """Whether the action is applicable now."""
        name, *args = named
        if any(arg not in choices for arg, choices in zip(args, self.possible[name], strict=True)):
            return False
        return self.simulator.is_applicable(
            self.state, self.problem.action(name), [self.objects[each] for each in args]
        )

    def is_goal(self) -> bool:
        """Whether the goal holds now."""
        return self.simulator.is_goal(self.state)

    def facts(self) -> tuple[set[Named], dict[Named, float]]:
        """The facts that hold now, and the numbers."""
        facts, numbers = set(), {}
        for fluent, args in _atoms(self.problem):
            value = self.state.get_value(fluent(*map(self.objects.get, args))).constant_value()
            if value is True:
                facts.add((fluent.name, *args))
            elif value is not False:
                numbers[(fluent.name, *args)] = float(value)
        return facts, numbers

    def apply(self, named: Named) -> float | None:
        """Takes an action; its cost, where the problem has action costs."""
        action = self.problem.action(named[0])
        args = tuple(self.objects[each] for each in named[1:])
        before, self.state = self.state, self.simulator.apply(self.state, action, args)
        assert self.state is not None, f"{named} is applicable, but cannot be applied"
        for metric in self.problem.quality_metrics:
            if isinstance(metric, MinimizeActionCosts):
                return float(evaluate_quality_metric(self.simulator, metric, 0, before, action, args, self.state))
        return None


def in_order(problem: str) -> str:
    """The text of a problem with its sections in the order that unified-planning's grammar has them in, and a name that
    begins with a letter."""
    text = re.sub(r";[^\n]*", "", problem).lower()
    sections: list[str] = []
    depth = start = 0
    for match in re.finditer(r"[()]", text):
        depth += 1 if match.group() == "(" else -1
        if depth == 2 and match.group() == "(":
            start = match.start()
        elif depth == 1 and match.group() == ")":
            sections.append(re.sub(r"^\(\s*:\s*", "(:", text[start : match.end()]))

    def place(section: str) -> int:
        return next((index for index, each in enumerate(_ORDER) if section.startswith(each)), len(_ORDER))

    return "\n".join(["(define (problem some)", *sorted(sections[1:], key=place), ")"])


def _objects(problem: Problem, parameter: object) -> list[str]:
    return [each.name for each in problem.objects(parameter.type)]  # type: ignore[attr-defined]


def _atoms(problem: Problem) -> Iterator[tuple[Fluent, Named]]:
    for fluent in problem.fluents:
        for args in product(*(_objects(problem, each) for each in fluent.signature)):
            yield fluent, args


def opened(domain: Path, *problems: Path) -> PddlDomain:
    """The domain over these problems."""
    found = open_domain(domain, problems=problems)
    assert isinstance(found, PddlDomain)
    return found


def named_action(domain: PddlDomain, action: Action) -> Named:
    """An action by its name in PDDL."""
    return tuple(domain.plan_step(action).strip("()").split())


def named_facts(domain: PddlDomain, state: State) -> tuple[set[Named], dict[Named, float]]:
    """A state's facts and numbers by their names in PDDL: without types, and without what says what the goal is."""
    predicates = {own: name for name, own in domain.names.predicates.items()}
    functions = {own: name for name, own in domain.names.functions.items()}
    apart = {*domain.names.types.values(), *domain.names.goal.values(), *domain.names.own.values()}
    facts: set[Named] = set()
    numbers: dict[Named, float] = {}
    for fact in (*static_of(state).facts, *facts_of(state)):
        name, *args = fact if isinstance(fact, tuple) else (fact,)
        if name in predicates:
            facts.add((predicates[name], *map(str, args)))
        elif name in functions:
            key = (functions[name], *map(str, args[:-1]))
            assert key not in numbers, "a number has one value"
            numbers[key] = _float(args[-1])
        else:
            assert name in apart, f"what is {fact}?"
    return facts, numbers


def _float(term: Ground) -> float:
    assert isinstance(term, int | float)
    return float(term)


def agree(domain: PddlDomain, number: int, reference: Reference, walks: int, steps: int, seed: int = 0) -> int:
    """Asserts that both have the same actions, facts, numbers, costs and goal on random walks over a problem. Walks
    go on behind the goal. Where there are many ground actions, those that are not applicable are a sample. How many
    states were compared."""
    rng, compared = Random(seed), 0
    for _ in range(walks):
        state = domain.problem(number)
        reference.begin()
        for step in range(steps + 1):
            compared += 1
            following = _agree_here(domain, state, reference, rng)
            if step == steps or not following:
                break
            action = rng.choice(sorted(following))
            cost = reference.apply(action)
            if cost is not None:
                assert domain.cost(state, following[action][0]) == pytest.approx(cost), action
            state = following[action][1]
    return compared


Following = dict[Named, tuple[Action, State]]


def _agree_here(domain: PddlDomain, state: State, reference: Reference, rng: Random) -> Following:
    """The applicable actions, each with the state that it leads to."""
    facts, numbers = named_facts(domain, state)
    wanted, values = reference.facts()
    assert facts == wanted
    assert numbers == pytest.approx(values, rel=1e-9)
    following = {}
    for action, outcomes in domain.neighbours(state):
        (outcome,) = outcomes
        following[named_action(domain, action)] = (action, outcome.state)
    assert all(map(reference.applicable, following))
    many = reference.actions_in_all() > MANY
    others = reference.some(rng, MANY) if many else reference.every()
    assert not [each for each in others if each not in following and reference.applicable(each)]
    status, actions = domain.situation(state)
    assert status == ("goal" if reference.is_goal() else "running" if following else "terminal")
    assert {named_action(domain, each) for each in actions} == (set(following) if status == "running" else set())
    return following


def is_valid(reference: Reference, plan: str) -> bool:
    """Whether unified-planning's validator accepts a plan, written as PDDL's plans are."""
    read = PDDLReader(reference.problem.environment).parse_plan_string(reference.problem, plan)
    return bool(SequentialPlanValidator().validate(reference.problem, read))
