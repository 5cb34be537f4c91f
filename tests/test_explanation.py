"""Why a policy chooses: what the rules give adds up, and what would have to be otherwise changes the choice."""

from __future__ import annotations

from pathlib import Path
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import random_tree, visited

import nppg
from nppg import NppgError, Policy
from nppg.bias.refinement import Refiner
from nppg.cli.main import main
from nppg.policy.gibbs import best
from nppg.trees.tree import Leaf, Node, leaves, rules


def random_policy(seed: int, name: str = "blocks_world", trees: int = 3) -> Policy:
    domain = nppg.open_domain(name)
    bias = nppg.language_bias_of(domain)
    policy = Policy(domain, bias)
    for _ in range(trees):
        policy.add(random_tree(Refiner(bias), 3, Random(seed)))
        seed += 1
    return policy


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 10**6), st.sampled_from(["blocks_world", "rover"]))
def test_what_the_rules_give_adds_up(seed: int, name: str) -> None:
    policy = random_policy(seed, name)
    for state in visited(policy.domain, 3, seed):
        actions = list(policy.domain.situation(state).actions)
        scores, told = policy.scores(state, actions), policy.explain(state)
        assert sorted(text for each in told.actions for text in each.actions) == sorted(map(str, actions))
        for each in told.actions:
            number = list(map(str, actions)).index(each.actions[0])
            assert each.probability == pytest.approx(scores.probabilities[number])
            assert sum(said.value for said in each.said) == pytest.approx(each.potential)
            assert each.potential == pytest.approx(policy.prolog_potentials(state, actions)[number])
            assert sum(said.trees for said in each.said) == len(policy.trees)


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 10**6))
def test_leaves_are_those_of_the_rules(seed: int) -> None:
    policy = random_policy(seed)
    reasons = policy.reasons()
    assert reasons
    for state in visited(policy.domain, 2, seed):
        for row in policy.answers(state, list(policy.domain.situation(state).actions)):
            found = zip(policy.trees, reasons.leaves(row), strict=True)
            values = [list(rules(tree))[leaf].value for tree, leaf in found]
            assert sum(values) == pytest.approx(policy.potentials_of(row[None])[0])


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 10**6), st.sampled_from(["blocks_world", "rover"]))
def test_a_change_makes_another_action_the_best(seed: int, name: str) -> None:
    policy = random_policy(seed, name)
    reasons = policy.reasons()
    assert reasons
    for state in visited(policy.domain, 3, seed):
        answers = policy.answers(state, list(policy.domain.situation(state).actions))
        for change in reasons.changes(answers, policy.potentials_of):
            column, limit = policy.table.place(change.test)
            other = answers.copy()
            if other.dtype == bool:
                assert other[change.action, column] == change.holds
                other[change.action, column] = not change.holds
            else:
                assert (other[change.action, column] <= limit) == change.holds
                other[change.action, column] = np.nextafter(limit, np.inf) if change.holds else limit
            assert best(policy.potentials_of(other))[change.best]
            assert not best(policy.potentials_of(answers))[change.best]


def test_a_policy_without_trees_explains_nothing() -> None:
    policy = random_policy(0, trees=0)
    told = policy.explain(visited(policy.domain, 1)[0])
    assert all(not each.said for each in told.actions) and not told.otherwise
    assert sum(each.probability for each in told.actions) == pytest.approx(1)


def test_there_is_nothing_to_explain_at_the_end() -> None:
    policy = random_policy(0)
    with pytest.raises(NppgError, match="a goal state"):
        policy.explain(policy.domain.state("on(b1, b2), on(b2, floor), goal_on(b1, b2)"))


def test_notebooks_see_trees_and_policies() -> None:
    policy = random_policy(1)
    tree = policy.trees[0]
    assert tree._repr_svg_().count('class="leaf') == leaves(tree)
    assert "<svg" in policy._repr_html_() and policy._repr_svg_()
    assert policy.explain(visited(policy.domain, 1)[0])._repr_html_().startswith("<table>")
    assert random_policy(1, trees=0)._repr_svg_() is None
    assert "<b>" not in Node((), (), Leaf(1.0), Leaf(0.0, 3))._repr_svg_()


def test_the_verbs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model = tmp_path / "model.pl"
    random_policy(2).save(model)
    state = "on(b1, b2), on(b2, floor), on(b3, floor), goal_on(b2, b3)"
    assert main(["explain", str(model), "--state", state]) == 0
    said = capsys.readouterr().out
    assert "goal: b2 on b3" in said and "move(b1, b3)" in said
    assert main(["explain", str(model)]) == 0
    assert main(["explain", str(model), "--state", "on(b1"]) == 2
    capsys.readouterr()
    assert main(["show", str(model), "--tree", "1", "--format", "svg"]) == 0
    assert capsys.readouterr().out.startswith("<svg")
    assert main(["show", str(model), "--format", "svg"]) == 2
    assert "--tree" in capsys.readouterr().err
    assert main(["show", str(model), "--format", "html", "--output", str(tmp_path / "trees.html")]) == 0
    assert (tmp_path / "trees.html").read_text().count("<svg") == 3
