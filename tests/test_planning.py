"""Plans that policies find: valid by unified-planning's validator, as `nppg plan` prints them and as its engine nppg
returns them."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from agreement import Reference, is_valid, named_facts, opened
from test_pddl_agreement import PAIRS, without_either, written

import nppg
from nppg.cli.verbs import run as run_verb
from nppg.errors import NppgError
from nppg.judging.problems import attempts
from nppg.pddl.problem_file import problem_of
from nppg.pddl.tokens import Document
from nppg.policy.policy import Policy

pytest.importorskip("unified_planning")

from unified_planning.engines import PlanGenerationResult
from unified_planning.engines import PlanGenerationResultStatus as Status
from unified_planning.exceptions import UPUsageError
from unified_planning.io import PDDLReader
from unified_planning.model import Problem
from unified_planning.shortcuts import (
    And,
    BoolType,
    Equals,
    Exists,
    Fluent,
    GlobalStartTiming,
    InstantaneousAction,
    Not,
    Object,
    OneshotPlanner,
    UserType,
    Variable,
    get_environment,
)

FERRY = """
(define (domain tiny-ferry)
  (:requirements :strips :typing :negative-preconditions :action-costs)
  (:types place car)
  (:constants end - place)
  (:predicates (ferry-at ?p - place) (at ?c - car ?p - place) (aboard ?c - car) (free))
  (:functions (total-cost))
  (:action sail-to :parameters (?from ?to - place)
    :precondition (and (ferry-at ?from) (not (= ?from ?to)))
    :effect (and (not (ferry-at ?from)) (ferry-at ?to) (increase (total-cost) 2)))
  (:action on :parameters (?c - car ?p - place)
    :precondition (and (at ?c ?p) (ferry-at ?p) (free))
    :effect (and (aboard ?c) (not (at ?c ?p)) (not (free)) (increase (total-cost) 1)))
  (:action off :parameters (?c - car ?p - place)
    :precondition (and (aboard ?c) (ferry-at ?p))
    :effect (and (at ?c ?p) (not (aboard ?c)) (free) (increase (total-cost) 1))))
"""
FIRST = """
(define (problem first) (:domain tiny-ferry)
  (:objects mid - place c1 c-2 - car)
  (:init (ferry-at end) (free) (at c1 end) (at c-2 mid) (= (total-cost) 0))
  (:goal (and (at c1 mid) (at c-2 end)))
  (:metric minimize (total-cost)))
"""
SECOND = """
(define (problem second) (:domain tiny-ferry)
  (:objects mid far - place c1 c-2 - car)
  (:init (ferry-at far) (free) (at c1 far) (at c-2 mid) (= (total-cost) 0))
  (:goal (and (at c1 mid) (at c-2 end)))
  (:metric minimize (total-cost)))
"""


@pytest.fixture(scope="module")
def ferry(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the domain, two problems and a model learned on them."""
    folder = tmp_path_factory.mktemp("ferry")
    for name, text in {"domain": FERRY, "first": FIRST, "second": SECOND}.items():
        (folder / f"{name}.pddl").write_text(text)
    domain = opened(folder / "domain.pddl", folder / "first.pddl", folder / "second.pddl")
    bias = nppg.language_bias_of(domain)
    nppg.run(domain, bias, replace(nppg.options_of(bias), episodes=150, seed=1), folder / "run", evaluate_every=0)
    return folder


@pytest.fixture
def planner(ferry: Path) -> dict:
    """The engine's arguments."""
    import nppg.planning  # noqa: F401

    get_environment().credits_stream = None
    return {"name": "nppg", "params": {"model": str(ferry / "run" / "model.pl")}}


def solved(planner: dict, problem: Problem) -> PlanGenerationResult:
    with OneshotPlanner(**planner) as engine:
        return engine.solve(problem)


@pytest.mark.parametrize("name", ["first", "second"])
def test_a_plan_that_is_printed_is_valid(ferry: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    problem = ferry / f"{name}.pddl"
    for extra in ([], ["--no-revisits"], ["--stochastic", "--seed", "3", "--horizon-factor", "9"]):
        assert run_verb(["plan", str(ferry / "run" / "model.pl"), str(problem), *extra]) == 0
        printed = capsys.readouterr().out
        reference = Reference(ferry / "domain.pddl", problem)
        assert is_valid(reference, printed)
        *steps, cost = printed.splitlines()
        assert not is_valid(reference, "\n".join(steps[:-1])), "the last step reaches the goal"
        reference.begin()
        costs = [reference.apply(tuple(step.strip("()").split())) for step in steps]
        assert cost == f"; cost = {sum(each or 0 for each in costs):g} (general cost)"


def test_every_attempt_that_is_solved_is_valid(ferry: Path) -> None:
    """Also long ones, of a policy that has learned nothing."""
    files = [ferry / "first.pddl", ferry / "second.pddl"]
    domain = opened(ferry / "domain.pddl", *files)
    policy, valid = Policy(domain, nppg.language_bias_of(domain)), 0
    for seed in range(5):
        for each in attempts(policy, seed=seed, greedy=False, horizon_factor=5):
            plan = "\n".join(map(domain.plan_step, each.plan))
            reference = Reference(ferry / "domain.pddl", files[each.problem - 1])
            assert is_valid(reference, plan) == each.solved
            valid += each.solved
    assert valid


@pytest.mark.parametrize("name", ["first", "second"])
def test_the_engine_plans(ferry: Path, planner: dict, name: str) -> None:
    problem = PDDLReader().parse_problem(str(ferry / "domain.pddl"), str(ferry / f"{name}.pddl"))
    found = solved(planner, problem)
    assert found.status is Status.SOLVED_SATISFICING and found.engine_name == "nppg"
    assert float(found.metrics["engine_internal_time"]) >= 0
    assert {each.action for each in found.plan.actions} <= set(problem.actions)
    reference = Reference(ferry / "domain.pddl", ferry / f"{name}.pddl")
    assert is_valid(reference, "\n".join(_line(each) for each in found.plan.actions))


def _line(step: object) -> str:
    names = [step.action.name, *map(str, step.actual_parameters)]  # type: ignore[attr-defined]
    return f"({' '.join(names)})"


def test_the_engine_is_chosen_by_name_alone(ferry: Path, planner: dict) -> None:
    factory = get_environment().factory
    assert "nppg" in factory.engines and "nppg" not in factory.preference_list
    nppg.planning.register()
    assert factory.engines.count("nppg") == 1
    with pytest.raises(NppgError, match="nppg needs a model: OneshotPlanner"):
        OneshotPlanner(name="nppg")
    with pytest.raises(NppgError, match=r"nothing\.pl"):
        OneshotPlanner(name="nppg", params={"model": str(ferry / "nothing.pl")})
    with pytest.raises(TypeError, match="modell"):
        OneshotPlanner(name="nppg", params={"modell": "x"})


def test_the_problem_may_be_made_in_python(ferry: Path, planner: dict) -> None:
    """With names that are not in lower case."""
    problem = PDDLReader().parse_problem(str(ferry / "domain.pddl"), str(ferry / "first.pddl")).clone()
    car = problem.user_type("car")
    third = Object("Third", car)
    problem.add_object(third)
    problem.set_initial_value(problem.fluent("at")(third, problem.object("mid")), True)
    problem.add_goal(problem.fluent("at")(third, problem.object("end")))
    found = solved({**planner, "params": {**planner["params"], "revisits": False, "horizon_factor": 3.0}}, problem)
    assert found.status is Status.SOLVED_SATISFICING
    assert third in {each.object() for step in found.plan.actions for each in step.actual_parameters}


def test_what_the_engine_cannot_solve(ferry: Path, planner: dict) -> None:
    problem = PDDLReader().parse_problem(str(ferry / "domain.pddl"), str(ferry / "second.pddl"))
    short = {**planner, "params": {**planner["params"], "horizon_factor": 0.1}}
    found = solved(short, problem)
    assert found.status is Status.UNSOLVABLE_INCOMPLETELY and found.plan is None
    assert found.log_messages[0].message == "limit after 3 steps"
    other = Problem("other")
    place = UserType("place")
    other.add_fluent(Fluent("there", BoolType(), p=place), default_initial_value=False)
    other.add_object("here", place)
    other.add_goal(other.fluent("there")(other.object("here")))
    found = solved(planner, other)
    assert found.status is Status.UNSUPPORTED_PROBLEM
    assert "no problem of the domain tiny-ferry" in found.log_messages[0].message
    assert "'there'" in found.log_messages[0].message


def test_the_actions_have_to_be_those_of_the_domain(ferry: Path, planner: dict, tmp_path: Path) -> None:
    changed = tmp_path / "domain.pddl"
    changed.write_text(
        FERRY.replace("(at ?c ?p) (ferry-at ?p) (free))", "(at ?c ?p) (ferry-at ?p) (free) (aboard ?c))")
    )
    found = solved(planner, PDDLReader().parse_problem(str(changed), str(ferry / "first.pddl")))
    assert found.status is Status.INTERNAL_ERROR and found.plan is None
    assert "are not those of the domain tiny-ferry" in found.log_messages[0].message


def test_a_problem_of_another_kind_is_refused(ferry: Path, planner: dict) -> None:
    problem = PDDLReader().parse_problem(str(ferry / "domain.pddl"), str(ferry / "first.pddl"))
    problem.add_timed_goal(GlobalStartTiming(5), problem.fluent("free")())
    with OneshotPlanner(**planner) as engine:
        assert not engine.supports(problem.kind)
        engine.error_on_failed_checks = True
        with pytest.raises(UPUsageError):
            engine.solve(problem)


def test_without_unified_planning_it_is_told_how_to_get_it() -> None:
    code = "import sys; sys.modules['unified_planning'] = None; import nppg.planning"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert found.stderr.splitlines()[-1].endswith("nppg.planning needs unified-planning: pip install 'nppg[pddl]'")


@pytest.mark.parametrize("name", PAIRS)
def test_a_problem_is_handed_over_as_it_is(name: str, tmp_path: Path) -> None:
    """The start state and whether it is a goal, whatever the names are and whatever the goal says."""
    from nppg.planning.problem_text import problem_text

    domain_file, problem_file = written(tmp_path, *PAIRS[name])
    domain_file.write_text(without_either(domain_file.read_text()))
    domain = opened(domain_file, problem_file)
    reference = Reference(domain_file, problem_file)
    constants = {each.name for each in domain.model.constants}
    text = problem_text(reference.problem, domain.model.name, constants)
    start = domain.start_of(problem_of(Document("problem", text), domain.model))
    assert named_facts(domain, start) == named_facts(domain, domain.problem(1))
    rng = np.random.default_rng(0)
    for _ in range(5):
        one, other = domain.problem(1), start
        for _ in range(8):
            status, actions = domain.situation(one)
            assert domain.situation(other) == (status, actions)
            if status != "running":
                break
            action = actions[int(rng.random() * len(actions))]
            one, other = domain.act(one, action, rng)[1], domain.act(other, action, rng)[1]


def test_facts_that_are_true_by_default_are_handed_over(ferry: Path, planner: dict) -> None:
    """A problem made without PDDL, whose ferry is free by default."""
    place, car = UserType("place"), UserType("car")
    problem = Problem("made")
    fluents = {
        "ferry-at": Fluent("ferry-at", BoolType(), p=place),
        "at": Fluent("at", BoolType(), c=car, p=place),
        "aboard": Fluent("aboard", BoolType(), c=car),
        "free": Fluent("free"),
    }
    for name, fluent in fluents.items():
        problem.add_fluent(fluent, default_initial_value=name == "free")
    ferry_at, at, aboard, free = fluents.values()
    sail = InstantaneousAction("Sail-To", a=place, b=place)
    sail.add_precondition(And(ferry_at(sail.a), Not(Equals(sail.a, sail.b))))
    sail.add_effect(ferry_at(sail.a), False)
    sail.add_effect(ferry_at(sail.b), True)
    on, off = (InstantaneousAction(name, c=car, p=place) for name in ("on", "off"))
    on.add_precondition(And(at(on.c, on.p), ferry_at(on.p), free()))
    off.add_precondition(And(aboard(off.c), ferry_at(off.p)))
    for action, holds in ((on, False), (off, True)):
        action.add_effect(at(action.c, action.p), holds)
        action.add_effect(aboard(action.c), not holds)
        action.add_effect(free(), holds)
    problem.add_actions([sail, on, off])
    end, mid, only = Object("END", place), Object("mid", place), Object("c1", car)
    problem.add_objects([end, mid, only])
    problem.set_initial_value(ferry_at(mid), True)
    problem.set_initial_value(at(only, end), True)
    problem.add_goal(Exists(at(only, Variable("where", place)), Variable("where", place)))
    problem.add_goal(at(only, mid))
    found = solved(planner, problem)
    assert found.status is Status.SOLVED_SATISFICING
    assert str(found.plan.actions[0]) == "Sail-To(mid, END)"
