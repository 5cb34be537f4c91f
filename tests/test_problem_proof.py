"""Proofs on problems: held against the exact evaluation, and against brute force; worlds with traps, loops and luck."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from samples import resigned

from nppg.bias.language_bias import LanguageBias
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.judging.evaluation import ExactEvaluator
from nppg.judging.reachable import Reachable, TooMany
from nppg.judging.space import Space
from nppg.policy.policy import Policy
from nppg.rules.problem_proof import prove_problem, prove_problems
from nppg.worlds.domain import Domain
from nppg.worlds.state import standard_order
from tests.test_proof import OPTIMAL, PLANTED, planted

TOWN = """
:- module(town, []).
:- fluent at/1.
:- static road/3, home/1.
:- dead_ends.
problem(1, [at(a), home(d), road(a, b, sure), road(b, c, sure), road(c, d, sure), road(b, x, sure), road(y, d, sure)]).
problem(2, [at(a), home(d), road(a, b, sure), road(b, a, sure), road(b, d, sure)]).
problem(3, [at(a), home(d), road(a, b, slippery), road(b, d, sure)]).
problem(4, [at(d), home(d)]).
problem(5, [at(a), home(d), road(a, d, slippery)]).
way(X, Y) :- road(X, Y, _).
goal :- home(X), at(X).
action(go(Y)) :- at(X), road(X, Y, _).
effect(go(Y), 1, [at(X)], [at(Y)]) :- at(X), road(X, Y, sure).
effect(go(Y), 0.75, [at(X)], [at(Y)]) :- at(X), road(X, Y, slippery).
effect(go(Y), 0.25, [at(X)], [at(X)]) :- at(X), road(X, Y, slippery).
horizon(4).
"""
BIAS = "action: go(+place)\ntypes: {way: [place, place], home: [place]}\nmodes: ['way(+place, -place)', home(+place)]\n"


@pytest.fixture
def town(tmp_path: Path):
    """Writes a list of rules for this world into a model file."""
    (tmp_path / "town.pl").write_text(TOWN)
    (tmp_path / "town.yaml").write_text(BIAS)
    path = tmp_path / "model.pl"
    Policy(Domain(tmp_path / "town.pl"), LanguageBias.load(tmp_path / "town.yaml")).save(path)
    text = path.read_text().replace("model(trees, 0)", "model(trees, 1)")

    def write(rules: str = "delta(1, go(_), 0.0).") -> Path:
        resigned(path, f"{text}\n{rules}\n")
        return path

    return write


def test_states_are_merged_whatever_the_order_of_their_facts(four_blocks: Domain) -> None:
    start = four_blocks.start(np.random.default_rng(0))
    graph, other = Reachable(four_blocks, start), Reachable(four_blocks, tuple(start)[::-1])
    assert len(graph.states) == len({frozenset(each) for each in graph.states}) and graph.running.sum() == 60
    assert graph.states == other.states and (graph.target == other.target).all() and graph.is_certain
    assert all(list(each) == sorted(each, key=standard_order) for each in graph.states)
    distances = graph.distances()
    assert distances[0] == four_blocks.horizon(start) and (distances >= 0).all()
    for state, distance in zip(graph.states, distances, strict=True):
        assert distance == (0 if four_blocks.situation(state).status == "goal" else four_blocks.horizon(state))
    last = len(graph.states) - 1
    here = 0
    for outcome in graph.way_to(last):
        assert graph.source[outcome] == here
        here = graph.target[outcome]
    assert here == last
    with pytest.raises(TooMany, match=f"more than {last} states"):
        Reachable(four_blocks, start, limit=last)


@pytest.mark.parametrize("rules", [OPTIMAL, *map(planted, PLANTED)], ids=["optimal", *PLANTED])
@pytest.mark.parametrize("greedy", [True, False])
def test_it_agrees_with_the_exact_evaluation(
    four_blocks: Domain, four: Space, plain_bias, tmp_path: Path, rules: str, greedy: bool
) -> None:
    path = tmp_path / "model.pl"
    Policy(four_blocks, plain_bias).save(path)
    resigned(path, path.read_text().replace("model(trees, 0)", "model(trees, 1)") + rules)
    policy = Policy.load(path)
    judge = ExactEvaluator(policy, four)
    (success, _), certain = judge.by_class(greedy), judge.certain(greedy)
    for i in np.flatnonzero(four.running)[::6]:
        own = prove_problem(policy, four.states[i], greedy=greedy)
        everywhere = prove_problem(policy, four.states[i], greedy=greedy, everywhere=True)
        assert own.success == pytest.approx(success[i], abs=1e-12) == pytest.approx(everywhere.success, abs=1e-12)
        assert (own.certain and own.longest <= own.horizon) == certain[i]
        assert (own.certain, own.longest, own.horizon) == (everywhere.certain, everywhere.longest, everywhere.horizon)
        assert 60 < everywhere.states == everywhere.alive <= 73 and own.states <= everywhere.states
        assert own.complete == own.certain and everywhere.complete == (everywhere.sure == everywhere.states)


def test_ties_a_trap_and_a_state_that_is_never_entered(town) -> None:
    path = town()
    policy = Policy.load(path)
    one, two, three, four, five = prove_problems(policy, path).problems
    assert (one.certain, one.longest, one.success, one.states) == (False, None, 0.5, 5)
    assert one.failure.steps == ("(go b)", "(go x)") and (one.failure.loop, one.failure.lost) == (0, None)
    assert not two.certain and two.success == 0.75  # b at step 1, d or back, b at step 3, d at step 4
    assert (two.failure.steps, two.failure.loop) == (("(go b)", "(go a)"), 2)
    assert three.failure.loop == 1 and three.failure.steps == ("(go b)  ; with luck: nothing new",)
    assert three.success == pytest.approx(1 - 0.25**4 - 4 * 0.75 * 0.25**3 + 3 * 0.75 * 0.25**3, abs=1e-12)
    assert (four.certain, four.longest, four.success, four.states, four.complete) == (True, 0, 1.0, 1, True)
    assert five.success == pytest.approx(1 - 0.25**4) and not five.complete
    everywhere = prove_problems(policy, path, [1], everywhere=True).problems[0]
    assert (everywhere.states, everywhere.alive, everywhere.sure) == (5, 4, 2)  # c and d of a, b, c, d
    assert everywhere.failure.lost == 2


def test_from_everywhere_looks_where_the_policy_does_not_go(town) -> None:
    """It goes home at once where a way home is one step long, so that the start of the second problem is fine."""
    path = town("delta(1, go(X), 1.0) :- home(X), !.\ndelta(1, go(_), 0.0).")
    policy = Policy.load(path)
    assert prove_problems(policy, path, [2]).complete
    assert not prove_problems(policy, path, [1]).complete
    away = town("delta(1, go(X), -1.0) :- home(X), !.\ndelta(1, go(_), 0.0).")
    policy = Policy.load(away)
    facts = "at(b), home(d), road(b, d, sure), road(b, e, sure), road(e, d, sure)"
    proof = prove_problem(policy, policy.domain.state(facts))
    assert proof.certain and (proof.longest, proof.states) == (2, 3)
    facts = "at(a), home(d), road(a, d, sure), road(a, b, sure), road(b, d, sure), road(b, c, sure), road(c, b, sure)"
    proof = prove_problem(policy, policy.domain.state(facts), everywhere=True)
    assert not proof.certain and proof.failure.loop == 2
    rescued = town("delta(1, go(X), 1.0) :- home(X), !.\ndelta(1, go(_), 0.0).")
    policy = Policy.load(rescued)
    facts = facts.replace("road(b, d, sure), ", "")
    proof = prove_problem(policy, policy.domain.state(facts), everywhere=True)
    assert proof.certain and proof.complete and (proof.states, proof.alive, proof.sure) == (4, 2, 2)


def test_as_a_command(town, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = town()
    certificate = tmp_path / "proof.json"
    own = ["prove", str(path), "--problems", "1-4"]
    assert main([*own, "--output", str(certificate), "--show", "2"]) == 0
    printed = capsys.readouterr().out
    assert "problem 4: proven, in 0 steps at most; 1 states" in printed
    assert "succeeds for certain on 1 of 4 problems" in printed and printed.count("a run that fails") == 2
    assert "there is no way on" in printed and "and so on: it is in a loop of 2 steps" in printed
    contents = json.loads(certificate.read_text())
    assert [each["name"] for each in contents["problems"]] == [f"problem {i}" for i in range(1, 5)]
    assert len({each["facts_sha256"] for each in contents["problems"]}) == 4
    assert main([*own, "--check", str(certificate)]) == 0
    assert "was proved again" in capsys.readouterr().out
    assert main([*own, "--check", str(certificate), "--stochastic"]) == 2
    assert main(["prove", str(path), "--problems", "1-3", "--check", str(certificate)]) == 2
    capsys.readouterr()
    assert main([*own, "--states", "4"]) == 2
    assert "problem 1: more than 4 states can be reached by the policy" in capsys.readouterr().err
    assert main(["prove", str(path), "--from-everywhere", "--show", "0"]) == 0
    assert "succeeds from everywhere, on 1 of 5 problems" in capsys.readouterr().out


def test_what_has_no_proof(town, tmp_path: Path) -> None:
    path = town()
    (tmp_path / "town.pl").write_text(TOWN + "observation([]).\n")
    with pytest.warns(UserWarning, match="its SHA-256 is another"):
        policy = Policy.load(path)
    with pytest.raises(NppgError, match="is not the file that this model was learned with"):
        prove_problems(policy, path, [1])
    with pytest.raises(NppgError, match="observation/1"):
        Reachable(policy.domain, policy.domain.problem(1))
