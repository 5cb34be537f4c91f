"""Levin tree search: it finds what is there, says where nothing is, and keeps to its budget."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from io import StringIO
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nppg import NppgError, Policy, language_bias_of, open_domain
from nppg.cli.main import main
from nppg.judging import levin
from nppg.judging.levin import search, searched
from nppg.judging.problems import DEAD_END, LIMIT, SOLVED, attempt
from nppg.worlds.domain import Domain
from nppg.worlds.problems import numbered
from nppg.worlds.state import Interpretation, static_facts
from nppg.worlds.world import Action

HERE = Path(__file__).parent
LIBRARY = HERE.parent / "examples" / "library"
PLACES = "abcdef"


def knowing_nothing(domain: Domain) -> Policy:
    """The policy without a tree: every action is as probable as the others."""
    return Policy(domain, language_bias_of(domain))


@pytest.fixture(scope="module")
def library() -> Policy:
    files = [LIBRARY / f"p0{number}.pddl" for number in (1, 4)]
    return knowing_nothing(open_domain(LIBRARY / "domain.pddl", problems=files))


def leads_to_the_goal(domain: Domain, problem: int, plan: Sequence[Action]) -> bool:
    state = domain.problem(problem)
    for action in plan:
        status, actions = domain.situation(state)
        assert status == "running" and action in actions
        following = domain.certain(state, action)
        assert following is not None
        state = following
    return domain.situation(state)[0] == "goal"


def test_it_finds_a_plan_where_the_policy_does_not(library: Policy) -> None:
    assert not attempt(library, 2).solved
    found = search(library, 2)
    assert found.ended == SOLVED and len(found.plan) == found.steps == found.cost
    assert leads_to_the_goal(library.domain, 2, found.plan)
    assert found.expansions and found.steps < found.expansions < 3000
    assert search(library, 2).plan == found.plan


def test_it_keeps_to_its_limits(library: Policy) -> None:
    needed = search(library, 2).expansions
    assert needed
    assert search(library, 2, needed).solved
    short = search(library, 2, needed - 1)
    assert (short.ended, short.steps, short.plan, short.expansions) == (LIMIT, 0, (), needed - 1)
    late = search(library, 2, seconds=0.0)
    assert late.ended == LIMIT and late.expansions == 0
    with pytest.raises(NppgError, match="budget must be at least 1"):
        search(library, 2, 0)


ROADS = st.sets(st.tuples(st.sampled_from(PLACES), st.sampled_from(PLACES)).filter(lambda road: road[0] != road[1]))


@settings(max_examples=40, deadline=None)
@given(ROADS, st.sampled_from([0.0, 0.9]))
def test_it_finds_a_plan_wherever_there_is_one(roads: set[tuple[str, str]], greedy: float) -> None:
    domain = open_domain(HERE / "domains" / "roads.pl")
    static = static_facts([("goal_at", "f"), *(("road", *each) for each in sorted(roads))])
    domain = domain.over(numbered([Interpretation([("at", "a")], static)], ["random"]))
    reached, before = {"a"}, set()
    while reached != before:
        before, reached = reached, reached | {end for begin, end in roads if begin in reached}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(levin, "_GREEDY", greedy)
        found = search(knowing_nothing(domain), 1)
    assert found.ended == (SOLVED if "f" in reached else DEAD_END)
    if found.solved:
        assert leads_to_the_goal(domain, 1, found.plan) and found.cost == 2 * found.steps
        assert len(set(found.plan)) == found.steps  # by state pruning: each leads to a place of its own


@settings(max_examples=20, deadline=None)
@given(ROADS)
def test_a_goal_is_found_within_depth_by_probability(roads: set[tuple[str, str]]) -> None:
    """Theorem 3 of the paper, for the plan that was found; without the greedy part, whose ties are drawn."""
    domain = open_domain(HERE / "domains" / "roads.pl")
    static = static_facts([("goal_at", "f"), *(("road", *each) for each in sorted(roads))])
    domain = domain.over(numbered([Interpretation([("at", "a")], static)], ["random"]))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(levin, "_GREEDY", 0.0)
        found = search(knowing_nothing(domain), 1)
    if found.solved:
        places = ["a", *(action[1] for action in found.plan[:-1])]
        probability = np.prod([1 / sum(begin == place for begin, _ in roads) for place in places])
        assert found.expansions and found.expansions <= 1 + found.steps / probability + 1e-9


def test_chance_is_refused(tmp_path: Path) -> None:
    ferry = knowing_nothing(open_domain(HERE / "domains" / "ferry.pl"))
    with pytest.raises(NppgError, match="left to chance"):
        search(ferry, 1)
    text = (HERE / "domains" / "roads.pl").read_text()
    (tmp_path / "roads.pl").write_text(text.replace("[at(To)]) :- at", "[at(To)]) :- random(_), at"))
    (tmp_path / "roads.yaml").write_text((HERE / "domains" / "roads.yaml").read_text())
    with pytest.raises(NppgError, match="draw numbers"):
        search(knowing_nothing(open_domain(tmp_path / "roads.pl")), 1)


def test_on_the_command_line(library: Policy, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model, problem = str(tmp_path / "library.model.pl"), str(LIBRARY / "p04.pddl")
    library.save(model)
    (tmp_path / "domain.pddl").write_text((LIBRARY / "domain.pddl").read_text())
    assert main(["plan", model, problem, "--search", "levin", "--seed", "2"]) == 0
    *steps, cost = capsys.readouterr().out.splitlines()
    assert cost == f"; cost = {len(steps)} (unit cost)" and all(step.startswith("(") for step in steps)
    assert main(["plan", model, problem, "--search", "levin", "--budget", "5"]) == 1
    assert capsys.readouterr().err == "no plan: none was found in 5 expansions\n"

    assert main(["evaluate", model, "--problems", problem, "--search", "levin"]) == 0
    assert " expansions\nsolved 1 of 1\n" in capsys.readouterr().out
    assert main(["evaluate", model, "--problems", problem, "--search", "levin", "--budget", "3", "--json"]) == 0
    (one,) = json.loads(capsys.readouterr().out)["list"]
    assert one["ended"] == LIMIT and one["expansions"] == 3
    assert main(["evaluate", model, "--problems", problem, "--search", "levin", "--budget", "3", "--csv"]) == 0
    (row,) = csv.DictReader(StringIO(capsys.readouterr().out))
    assert row["expansions"] == "3"


@pytest.mark.parametrize(
    "options, message",
    [
        (["--budget", "3"], "--budget is for a search"),
        (["--search", "levin", "--stochastic"], "--stochastic is about acting"),
        (["--search", "levin", "--horizon-factor", "2"], "--horizon-factor is about acting"),
    ],
)
def test_options_that_do_not_go_together(options: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    for verb in (["plan", "m.pl", "1"], ["evaluate", "m.pl", "--problems", "1"]):
        assert main([*verb, *options]) == 2
        assert message in capsys.readouterr().err


def test_all_problems_in_turn(library: Policy) -> None:
    assert [each.problem for each in searched(library, 20)] == [1, 2]
    assert [each.problem for each in searched(library, 20, problems=[2])] == [2]
