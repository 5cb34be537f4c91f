"""Distilled rules: few, as good as what they are learned from, none of them idle, and a model like any other."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from samples import value_of_list, visited

import nppg.rrl.training
import nppg.rules.growing
from nppg.answers.coverage import root_table
from nppg.bias.refinement import KIND, Refiner
from nppg.bridge import home as prolog_home
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.judging.evaluation import ExactEvaluator, evaluate, evaluate_exactly
from nppg.judging.space import Space
from nppg.learning.options import Options
from nppg.learning.training import train
from nppg.logic.forms import Forms
from nppg.policy.policy import Policy
from nppg.rrl.options import TGOptions
from nppg.rules.distill import distill
from nppg.rules.growing import Preferences, met_everywhere, met_in_episodes
from nppg.rules.pruning import levelled, pruned
from nppg.trees.tilde import grow
from nppg.trees.tree import Rule, from_rules, rules
from nppg.worlds.domain import Domain


def learned(domain: Domain, bias, episodes: int, seed: int = 0) -> Policy:
    *_, last = train(domain, bias, Options(episodes=episodes, seed=seed, step="second-order"))
    return last.policy


def list_of(policy: Policy) -> list[Rule]:
    (tree,) = policy.trees
    return list(rules(tree))


JOINS = """
action: move(+block, +place)
goal: goal_on(-block, -block)
subtypes: {block: place}
types: {clear: [place], on: [place, place], above: [place, place]}
modes: ["on(+, +-)", "on(-, +)", clear(+), "above(+-, +)", "equal(+place, +place)", "equal(+place, floor)"]
max_variables: 2
tree: {max_depth: 4, min_examples: 1}
"""


@pytest.fixture(params=["plain", "relational", "joins"])
def bias(request: pytest.FixtureRequest, bias_of):
    return bias_of(JOINS) if request.param == "joins" else request.getfixturevalue(f"{request.param}_bias")


def greedy_success(policy: Policy, space: Space) -> float:
    return ExactEvaluator(policy, space).evaluate(greedy=True).success


class Lists:
    """Greedy exact success of lists of rules."""

    def __init__(self, policy: Policy, space: Space):
        self.policy = policy
        self.space = space

    def success(self, ordered: Sequence[Rule]) -> float:
        policy = Policy(self.policy.domain, self.policy.bias)
        roots = len(policy.bias.roots)
        policy.add(from_rules(ordered, Forms(roots).deciding_tests))
        return greedy_success(policy, self.space)


def shorter(ordered: list[Rule], refiner: Refiner) -> Iterator[list[Rule]]:
    """The list without a rule, or a rule without a literal."""
    for i, rule in enumerate(ordered[:-1]):
        yield ordered[:i] + ordered[i + 1 :]
        for literal in rule.query:
            query = tuple(each for each in rule.query if each != literal)
            if query and refiner.allows(query):
                yield [*ordered[:i], Rule(query, rule.value), *ordered[i + 1 :]]


@pytest.mark.parametrize("episodes", [50, 200])
def test_rules_are_as_good_as_the_ensemble_and_none_is_idle(four_blocks: Domain, four: Space, bias, episodes) -> None:
    ensemble = learned(four_blocks, bias, episodes)
    distilled = distill(ensemble, bias)
    ordered = list_of(distilled)
    wanted = greedy_success(ensemble, four)
    assert len(ordered) <= 10 and ordered[-1].query == ()
    success = greedy_success(distilled, four)
    assert success >= wanted > (0.99 if episodes == 200 else 0.4)
    lists = Lists(distilled, four)
    assert lists.success(ordered) == pytest.approx(success, abs=1e-12)
    found = [lists.success(each) for each in shorter(ordered, Refiner(bias))]
    assert len(found) > 4 and max(found) < success - 1e-9


@pytest.mark.parametrize("domain_name", ["four_blocks", "delivery"])
def test_rules_in_the_policy_are_their_list(
    request: pytest.FixtureRequest, domain_name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    domain = request.getfixturevalue(domain_name)
    bias = request.getfixturevalue("delivery_bias" if domain_name == "delivery" else "relational_bias")
    monkeypatch.setattr(nppg.rules.growing, "_EPISODES", 20)
    distilled = distill(learned(domain, bias, 100), bias)
    ordered = list_of(distilled)
    used = set()
    for state in visited(domain, 40, seed=3):
        actions = domain.situation(state).actions
        expected = [value_of_list(ordered, bias, state, action) for action in actions]
        assert distilled.potentials(state, actions).tolist() == expected
        assert distilled.prolog_potentials(state, actions).tolist() == expected
        used |= set(expected)
    assert used == {rule.value for rule in ordered} and len(used) > 1
    assert all(value == 10 * i for i, value in enumerate(sorted(used)))


def test_pruning_never_loses_success(four_blocks: Domain, four: Space, plain_bias) -> None:
    """For lists of random rules, good and bad ones."""
    refiner, rng = Refiner(plain_bias), np.random.default_rng(0)
    lists = Lists(Policy(four_blocks, plain_bias), four)
    dropped = gained = 0
    for _ in range(6):
        ordered = []
        for _ in range(6):
            query: tuple = ()
            for _ in range(rng.integers(1, 4)):
                candidates = refiner.refinements(query)
                query += candidates[rng.integers(len(candidates))].literals
            ordered.append(Rule(query, float(rng.integers(4))))
        ordered.append(Rule((), float(rng.integers(4))))
        before = lists.success(ordered)
        best = before

        def accepts(candidate: list[Rule]) -> bool:
            nonlocal best
            if lists.success(candidate) < best:
                return False
            best = lists.success(candidate)
            return True

        short = pruned(ordered, refiner, accepts)
        after = lists.success(short)
        assert after >= before and all(lists.success(each) < after for each in shorter(short, refiner))
        level = levelled(short, accepts)
        assert lists.success(level) >= after and [r.query for r in level] == [r.query for r in short]
        assert {rule.value for rule in level} <= {10.0 * i for i in range(len({rule.value for rule in short}))}
        dropped += sum(len(rule.query) + 1 for rule in ordered) - sum(len(rule.query) + 1 for rule in short)
        gained += after > before
    assert dropped > 20 and gained


@pytest.mark.parametrize("exact", [True, False])
def test_a_value_function_is_distilled_from_what_it_does(plain_bias, exact) -> None:
    """Its best actions, whatever it once explored with."""
    domain = Domain("blocks_world", {"blocks": 4})
    *_, last = nppg.rrl.training.train(domain, plain_bias, TGOptions(episodes=400, min_sample=40, significance=0.1))
    policy = last.policy
    preferences = Preferences(policy, root_table(domain, plain_bias, Refiner(plain_bias)))
    preferences.add(met_everywhere(ExactEvaluator(policy)) if exact else met_in_episodes(policy))
    states, actions, shares = preferences.states, preferences.actions, preferences.shares
    assert set(shares) == {0.0, 1.0}
    met = list(dict.fromkeys(states))
    for state in met:
        legal = domain.situation(state).actions
        q = dict(zip(legal, policy.potentials(state, legal), strict=True))
        own = [(a, share) for s, a, share in zip(states, actions, shares, strict=True) if s == state]
        assert {a for a, share in own if share} == {a for a in legal if q[a] >= max(q.values()) - 1e-12}


def test_no_more_rules_than_wanted(four_blocks: Domain, four: Space, plain_bias) -> None:
    policy = learned(four_blocks, plain_bias, 200)
    found = [ExactEvaluator(Policy(four_blocks, plain_bias), four).evaluate().success]  # of one rule for all actions
    unbounded = len(list_of(distill(policy, plain_bias)))
    for most in (1, 2, 3):
        distilled = distill(policy, plain_bias, most)
        assert len(list_of(distilled)) <= most < unbounded
        found.append(greedy_success(distilled, four))
    assert found[1] == pytest.approx(found[0]) and 1 > found[3] >= found[2] > 2 * found[1]


def test_trees_are_grown_from_answers_to_all_tests_so_far(
    four_blocks: Domain, bias_of, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Judging a tree can bring new ones."""
    widths = []

    def grown(targets, coverage, *rest, **query):
        widths.append(len(coverage.table))
        assert coverage.bits.shape == (len(targets), len(coverage.table))
        return grow(targets, coverage, *rest, **query)

    monkeypatch.setattr(nppg.rules.growing, "grow", grown)
    bias = bias_of(JOINS)
    for seed in range(3):
        distill(learned(four_blocks, bias, 60, seed), bias)
    assert len(set(widths)) > 1


def test_a_policy_that_is_hardly_sure_distils_too(four_blocks: Domain, four: Space, plain_bias) -> None:
    """One that is hardly better than the uniform one, by differences that its greedy choices show."""
    policy = learned(four_blocks, plain_bias, 200)
    faint = Policy(four_blocks, plain_bias, policy.table)
    for tree in policy.trees:
        faint.add(tree, 1e-3)
    assert ExactEvaluator(faint, four).evaluate().success < 0.25
    assert greedy_success(distill(faint, plain_bias), four) > 0.99


def test_a_domain_without_exact_space(delivery: Domain, delivery_bias, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(nppg.rules.growing, "_EPISODES", 40)
    policy = learned(delivery, delivery_bias, 300)
    with pytest.raises(NppgError):
        evaluate_exactly(policy)
    distilled = distill(policy, delivery_bias)
    ordered = list_of(distilled)
    assert len(ordered) <= 10 < sum(len(list(rules(tree))) for tree in policy.trees)
    found = [evaluate(each, 100, seed=7, greedy=True).success for each in (distilled, policy)]
    assert found[0] >= found[1] - 0.02 > 0.9
    assert any(literal.name == KIND for rule in ordered for literal in rule.query)


def swipl(folder: Path, goal: str) -> list[str]:
    home = prolog_home.linked().home
    assert home is not None
    binaries = [*home.glob("bin/*/swipl"), *home.parent.parent.glob("bin/swipl"), Path("/usr/bin/swipl")]
    command = [str(next(each for each in binaries if each.exists())), "-g", goal, "-t", "halt", "rules.pl"]
    result = subprocess.run(
        command,
        cwd=folder,
        env={**os.environ, "SWI_HOME_DIR": str(home)},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert not result.stderr, result.stderr
    return result.stdout.splitlines()


def term(fact) -> str:
    return f"{fact[0]}({','.join(map(str, fact[1:]))})"


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a model trained on four blocks, and its rules."""
    folder = tmp_path_factory.mktemp("run")
    options = f"--set blocks=4 --episodes 200 --step second-order --evaluate-every 0 --quiet --output {folder}".split()
    assert main(["train", "blocks_world", *options]) == 0
    assert main(["distill", str(folder / "model.pl")]) == 0
    return folder


def test_the_output_is_a_model_like_any_other(run: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model = str(run / "rules.pl")
    distilled = Policy.load(model)
    success = evaluate_exactly(distilled, greedy=True).success
    assert success == 1.0 and distilled.domain.parameters == {"blocks": 4, "task": "on"}
    text = (run / "rules.pl").read_text()
    assert f"model(success, {success})." in text and "model(starts, 60)." in text and "model(exact, 1)." in text
    shown = distilled.rules(1)
    assert len(shown) <= 10 and all(f"\n{line}\n" in text for line in shown)
    assert main(["show", model]) == 0
    assert capsys.readouterr().out.splitlines()[1:-1] == shown
    assert main(["play", model, "--seed", "1"]) == 0
    assert "the goal is reached" in capsys.readouterr().out
    assert main(["evaluate", model, "--exact", "--greedy"]) == 0
    assert "all 60 start states: 1.000000" in capsys.readouterr().out
    assert main(["evaluate", model, "--exact", "--greedy", "--set", "blocks=6"]) == 0
    assert "1.000000" in capsys.readouterr().out


def test_plain_prolog_loads_and_follows_the_rules(run: Path) -> None:
    distilled = Policy.load(run / "rules.pl")
    states = visited(distilled.domain, 12)
    goals = (
        f"(state([{','.join(map(term, state))}]), best_action(A{i}), potential(A{i}, P{i}), "
        f"format('~q ~w~n', [A{i}, P{i}]))"
        for i, state in enumerate(states)
    )
    best = set()
    for state, line in zip(states, swipl(run, ", ".join(goals)), strict=True):
        action, potential = line.split(" ")
        actions = distilled.domain.situation(state).actions
        potentials = distilled.potentials(state, actions)
        assert potentials[[term(each) for each in actions].index(action)] == potentials.max() == float(potential)
        best |= set(potentials)
    assert len(best) > 1


def test_distill_as_a_command(run: Path, four: Space, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "two.pl"
    bias = ["--bias", "blocks_world_relational"]
    assert main(["distill", str(run / "model.pl"), "--max-rules", "2", *bias, "--output", str(output)]) == 0
    printed = capsys.readouterr().out.splitlines()
    two = Policy.load(output)
    assert printed[:-1] == two.rules(1) and len(printed) <= 3
    success = greedy_success(two, four)
    assert f"all 60 start states: {success:.6f}; written to {output}" in printed[-1] and 0 < success < 1
    assert sorted(each.name for each in tmp_path.iterdir()) == ["blocks_world.pl", "two.pl"]
    assert main(["distill", str(run / "model.pl"), "--max-rules", "0"]) == 2
    assert "max-rules must be at least 1" in capsys.readouterr().err
    assert main(["distill", str(run / "model.pl"), "--bias", "delivery"]) == 2
    errors = capsys.readouterr().err
    assert errors and "Traceback" not in errors


def test_distilled_rules_distil_to_themselves(run: Path, four: Space, plain_bias) -> None:
    first = Policy.load(run / "rules.pl")
    again = distill(first, plain_bias)
    assert greedy_success(again, four) == 1.0
    assert len(list_of(again)) <= len(list_of(first))
    table = root_table(first.domain, plain_bias, Refiner(plain_bias))
    assert table.tests == again.table.tests[: len(table)]
    assert replace(plain_bias) == again.bias
