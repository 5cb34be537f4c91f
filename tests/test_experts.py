"""Experts that nobody wrote: optimal actions against brute force, plans as traces, and that steps of theirs teach."""

from __future__ import annotations

import json
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from nppg.bias.language_bias import LanguageBias
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.experiments.experts import expert_of
from nppg.experiments.train import train
from nppg.judging.expert import OptimalExpert
from nppg.judging.reachable import Reachable
from nppg.learning.courses import examples, importance_of
from nppg.learning.episode import generate_episode
from nppg.learning.gradient import returns
from nppg.learning.options import Options
from nppg.learning.regressors import regressor
from nppg.learning.visits import Visit
from nppg.logic.query import Literal, Query, Var
from nppg.policy.policy import Policy
from nppg.rrl.options import TGOptions
from nppg.trees.tree import Leaf, Node, rules
from nppg.worlds.domain import Domain
from nppg.worlds.opening import language_bias_of, open_domain

LIBRARY = Path(__file__).parents[1] / "examples" / "library"
RIVER = """
:- module(river, []).
:- fluent at/1.
:- static road/3, home/1.
:- dead_ends.
problem(1, [at(a), home(d), road(a, d, 0.75), road(a, b, 1.0), road(b, d, 1.0)]).
problem(2, [at(a), home(d), road(a, d, 0.4), road(a, b, 1.0), road(b, d, 1.0)]).
problem(3, [at(a), home(d), road(a, d, 0.5), road(a, b, 0.5), road(b, b, 1.0), road(b, d, 0.001)]).
problem(4, [at(a), home(d), road(a, b, 1.0)]).
problem(5, [at(a), home(d), road(a, b, 1.0), road(b, c, 1.0), road(c, e, 1.0), road(e, d, 1.0), road(a, f, 1.0)]).
goal :- home(X), at(X).
leads(X) :- road(X, _, _).
action(go(Y)) :- at(X), road(X, Y, _).
effect(go(Y), P, [at(X)], [at(Y)]) :- at(X), road(X, Y, P).
effect(go(Y), Q, [], []) :- at(X), road(X, Y, P), P < 1, Q is 1-P.
horizon(6).
"""


@pytest.fixture
def river(tmp_path: Path) -> Domain:
    (tmp_path / "river.pl").write_text(RIVER)
    (tmp_path / "river.yaml").write_text("action: go(+place)\ntypes: {leads: [place]}\nmodes: [leads(+place)]\n")
    return Domain(tmp_path / "river.pl")


def test_optimal_actions_are_all_that_lead_nearer(four_blocks: Domain, plain_bias: LanguageBias) -> None:
    expert = OptimalExpert(four_blocks)
    rng = np.random.default_rng(0)
    for _ in range(5):
        start = four_blocks.start(rng)
        for state in Reachable(four_blocks, start).states[::7]:
            left = four_blocks.horizon(state)  # the fewest moves
            nearer = [
                action
                for action, (outcome,) in four_blocks.neighbours(state)
                if four_blocks.situation(state).status == "running"
                and four_blocks.situation(outcome.state).status == "goal" * (left == 1) + "running" * (left > 1)
                and (left == 1 or four_blocks.horizon(outcome.state) == left - 1)
            ]
            assert expert(tuple(state)[::-1]) == expert(state) == nearer
        episode = generate_episode(Policy(four_blocks, plain_bias), rng, 1.0, start=start, expert=expert)
        assert episode.success and len(episode.steps) == four_blocks.horizon(start)
        assert all(step.guided for step in episode.steps)


def test_optimal_under_chance(river: Domain) -> None:
    """4/3 steps are fewer than 2, which are fewer than 2.5; a wrong turn that hardly leads back; no way at all."""
    expert = OptimalExpert(river)
    assert expert.advised == 5
    found = [expert(river.problem(number)) for number in river.problems]
    assert found == [[("go", "d")], [("go", "b")], [("go", "d")], [], [("go", "b")]]
    again = pickle.loads(pickle.dumps(expert))
    assert [again(again.domain.problem(number)) for number in river.problems] == found


def test_problems_that_are_too_large_have_no_advice_and_it_is_told(river: Domain, four_blocks: Domain) -> None:
    with pytest.warns(UserWarning, match="advises on 4 of 5 problems: the others have more than 3 states"):
        expert = OptimalExpert(river, limit=3)
    assert expert(river.problem(1)) and not expert(river.problem(5))
    few = OptimalExpert(four_blocks, limit=10)
    start = four_blocks.start(np.random.default_rng(0))
    with pytest.warns(UserWarning, match="starts with more than 10 states"):
        assert few(start) == []
    assert expert_of(river, Options(guidance=0, expert="optimal")) is None and expert_of(river, Options()) is None


def test_what_was_learned_wrong_for_certain_is_unlearned_from_guided_steps(river: Domain) -> None:
    """The policy goes to f with a probability of 1 - 1e-6, and is taught by the expert alone, in second-order steps.
    With pi(s, a)^0.5 as their weight the same steps teach next to nothing; the paper's steps are as they were."""
    bias, domain = LanguageBias.load(river.path.with_suffix(".yaml")), river.with_problems([5])
    options = Options(step="second-order", importance=0.5, expert="optimal")
    expert, start, choice = OptimalExpert(domain), domain.problem(5), [("go", "b"), ("go", "f")]
    leads: Query = (Literal("leads", (Var(0),)),)
    found = {}
    for guided in (True, False):
        learner = regressor(domain, bias, options)
        policy = Policy(domain, bias, learner.table)
        policy.add(Node(leads, (leads,), Leaf(0.0), Leaf(float(np.log(1e6)))))
        before = policy.distribution(start, choice)[0]
        assert before == pytest.approx(1e-6, rel=1e-3)
        rng = np.random.default_rng(0)
        for _ in range(6):
            visits = []
            for _ in range(5):
                episode = generate_episode(policy, rng, 1.0, learning=True, expert=expert)
                assert episode.success and episode.guided
                values = returns([step.reward for step in episode.steps], 0.9)
                steps = [replace(step, guided=guided) for step in episode.steps]
                visits += map(Visit, steps, values)
            made = examples(visits, options)
            tree = learner.fit(made)
            assert all(abs(rule.value) <= options.clip for rule in rules(tree))
            policy.add(tree)
        found[guided] = policy.distribution(start, choice)[0]
    assert found[True] > 0.99 and found[False] < 1e-4
    first = generate_episode(policy, rng, 1.0, expert=expert).steps[0]
    assert importance_of(first, Options(guidance=0.5)) == 1.0 and importance_of(first, options) == 0.0
    assert importance_of(replace(first, guided=False), options) == 0.5


def test_training_with_an_expert(river: Domain) -> None:
    """Also in several processes, which find its advice again; and by Q-learning."""
    bias = LanguageBias.load(river.path.with_suffix(".yaml"))
    options = Options(episodes=60, guidance=0.5, expert="optimal", episodes_per_iteration=50, step="second-order")
    policies = []
    for jobs in (1, 2):
        *_, last = train(river, bias, options, jobs)
        policies.append([list(rules(tree)) for tree in last.policy.trees])
        assert any(step.guided for episode in last.recent for step in episode.steps)
    assert policies[0] == policies[1] != []
    *_, last = train(river, bias, TGOptions(episodes=5, guidance=1.0, expert="optimal"))
    assert all(step.guided for step in last.recent[0].steps)


def test_a_planner_as_expert() -> None:
    pytest.importorskip("up_fast_downward")
    files = [LIBRARY / f"p0{i}.pddl" for i in (1, 2, 3)]
    domain = open_domain(LIBRARY / "domain.pddl", problems=files)
    expert = expert_of(domain, Options(expert="fast-downward"))
    again = pickle.loads(pickle.dumps(expert))
    policy = Policy(domain, language_bias_of(domain))
    for number in domain.problems:
        start = domain.problem(number)
        episode = generate_episode(policy, np.random.default_rng(0), 1.0, start=start, expert=expert)
        assert episode.success and all(step.guided for step in episode.steps)
        assert again(again.domain.problem(number)) == expert(start) != []
    with pytest.raises(NppgError, match=r"p01.pddl: the expert slow-upward cannot plan here"):
        expert_of(domain, Options(expert="slow-upward"))


def test_a_planner_needs_problems_in_pddl(river: Domain, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("unified_planning")
    assert main(["train", str(river.path), "--expert", "fast-downward", "--output", str(river.path.parent)]) == 2
    assert "the expert fast-downward plans for problems in PDDL files: name them by" in capsys.readouterr().err
    with pytest.raises(NppgError, match="expert must be a name"):
        Options(expert="")
    with pytest.raises(NppgError, match="expert must be a name"):
        Options(expert=3)  # type: ignore[arg-type]


def test_the_option_is_kept_and_what_has_no_advice_is_told(river: Domain, tmp_path: Path, capsys) -> None:
    (tmp_path / "wide.pl").write_text(RIVER.replace(":- module(river", ":- module(wide"))
    (tmp_path / "wide.yaml").write_bytes(river.path.with_suffix(".yaml").read_bytes())
    folder = tmp_path / "run"
    command = ["train", str(tmp_path / "wide.pl"), "--expert", "optimal", "--episodes", "20", "--output", str(folder)]
    assert main(command) == 0 and "advises" not in capsys.readouterr().err
    assert json.loads((folder / "run.json").read_text())["options"]["expert"] == "optimal"
    assert Policy.load(folder / "model.pl").option("expert", "") == "optimal"
