"""The potential by way of the table's answers is that of the clauses, to the bit; and what the policy makes of it."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest
from samples import random_tree, value_of_list, value_of_tree, visited

import nppg.policy.forest
from nppg.answers.coverage import root_table
from nppg.bias.refinement import Refiner
from nppg.errors import NppgError
from nppg.policy.gibbs import best, best_of_groups, gibbs
from nppg.policy.policy import Policy, choose, choose_best
from nppg.trees.tree import Leaf, Node, rules
from nppg.worlds.domain import Domain


def same_as_the_clauses(policy: Policy, states) -> None:
    for state in states:
        actions = policy.domain.situation(state).actions
        assert (policy.potentials(state, actions) == policy.prolog_potentials(state, actions)).all()


@pytest.mark.parametrize("with_table", [True, False])
def test_potentials_are_the_sum_of_the_clauses(setting, with_table: bool) -> None:
    """Before and after trees and columns are added; without the root table every tree brings columns."""
    domain, bias, refiner, table = setting
    policy = Policy(domain, bias, table if with_table else None)
    states = visited(domain, 6)
    trees, width = [], len(policy.table)
    for seed in range(12):
        tree = random_tree(refiner, 4, Random(seed))
        policy.add(tree, 0.5 if seed % 2 else 1.0)
        trees.append((tree, 0.5 if seed % 2 else 1.0))
        same_as_the_clauses(policy, states[seed % 3 :: 2])
    assert len(policy.table) > width or (with_table and "relational" not in bias.file)
    policy.table.add(each.test for each in refiner.refinements((next(iter(refiner.refinements(()))).literals[0],)))
    same_as_the_clauses(policy, states)
    for state in states[:2]:
        actions = domain.situation(state).actions
        for action, potential in zip(actions, policy.potentials(state, actions), strict=True):
            by_trees = sum(eta * value_of_tree(tree, bias, state, action) for tree, eta in trees)
            by_lists = sum(eta * value_of_list(list(rules(tree)), bias, state, action) for tree, eta in trees)
            assert potential == pytest.approx(by_trees, abs=1e-12) == by_lists


@pytest.mark.parametrize("memory", [0, 1, 7])
def test_a_full_memory_of_rows_changes_nothing(setting, monkeypatch: pytest.MonkeyPatch, memory: int) -> None:
    domain, bias, refiner, table = setting
    monkeypatch.setattr(nppg.policy.forest, "_MEMORY", memory)
    monkeypatch.setattr(nppg.policy.forest, "_CHUNK", 5)
    policy = Policy(domain, bias, table)
    states = visited(domain, 5)
    for seed in range(5):
        policy.add(random_tree(refiner, 4, Random(seed)))
        same_as_the_clauses(policy, states)
        same_as_the_clauses(policy, [states[0]])
        assert len(policy._forest._number) <= max(memory, len(domain.situation(states[0]).actions))


def test_trees_of_one_leaf(blocks: Domain, plain_bias) -> None:
    policy = Policy(blocks, plain_bias)
    (state,) = visited(blocks, 1)
    actions = blocks.situation(state).actions
    for value in (0.5, -2.0):
        policy.add(Leaf(value))
        same_as_the_clauses(policy, [state])
    assert set(policy.potentials(state, actions)) == {-1.5}


def test_without_trees_the_policy_is_uniform(setting) -> None:
    domain, bias, _, table = setting
    policy = Policy(domain, bias, table)
    for state in visited(domain, 3):
        actions = domain.situation(state).actions
        assert policy.distribution(state, actions).tolist() == [1 / len(actions)] * len(actions)
        assert policy.prolog_potentials(state, actions).tolist() == [0.0] * len(actions)


def test_the_distribution_is_gibbs(setting) -> None:
    domain, bias, refiner, table = setting
    policy = Policy(domain, bias, table)
    policy.add(random_tree(refiner, 4, Random(5)), step_size=3.0)
    for state in visited(domain, 3):
        actions = domain.situation(state).actions
        assert (policy.distribution(state, actions) == gibbs(policy.prolog_potentials(state, actions))).all()


def test_actions_are_drawn_by_their_probability(four_blocks: Domain, plain_bias) -> None:
    refiner = Refiner(plain_bias)
    policy = Policy(four_blocks, plain_bias, root_table(four_blocks, plain_bias, refiner))
    for seed in range(4):
        policy.add(random_tree(refiner, 4, Random(seed)))
    state = max(visited(four_blocks, 5), key=lambda state: len(four_blocks.situation(state).actions))
    actions = four_blocks.situation(state).actions
    expected = policy.distribution(state, actions)
    assert expected.max() > 1.5 * expected.min()
    rng, drawn = np.random.default_rng(0), 3000
    counts = np.zeros(len(actions))
    for _ in range(drawn):
        counts[actions.index(policy.act(state, rng))] += 1
    assert (abs(counts / drawn - expected) < 4.5 * np.sqrt(expected * (1 - expected) / drawn)).all()
    best = [action for action, p in zip(actions, expected, strict=True) if p == expected.max()]
    assert {policy.act(state, rng, greedy=True) for _ in range(100)} == set(best)


def test_choose() -> None:
    rng = np.random.default_rng(0)
    assert {choose(np.array([0.0, 1.0, 0.0]), rng) for _ in range(50)} == {1}
    short = np.array([0.2, 0.2, 0.2])  # rounding may leave the sum below 1
    assert set(choose(short, rng) for _ in range(200)) == {0, 1, 2}


@pytest.mark.parametrize("unit", [1.0, 2.0**-40, 2.0**40, -1.0, -(2.0**-40), -(2.0**40)])
@pytest.mark.parametrize("shift", [0.0, 1.0, -3.0])
def test_the_best_are_the_best_in_any_unit_and_of_any_sign(unit: float, shift: float) -> None:
    potentials = unit * (np.array([0.3, 0.3 * (1 - 1e-12), 0.1, 0.3, 0.5, 0.5 * (1 - 1e-12)]) + shift)
    expected = {4, 5} if unit > 0 else {2}
    assert set(np.flatnonzero(best(potentials))) == expected
    assert best_of_groups(np.tile(potentials, 3), np.array([0, 6, 12])).tolist() == 3 * best(potentials).tolist()
    rng = np.random.default_rng(0)
    picked = [choose_best(potentials, rng) for _ in range(400)]
    assert set(picked) == expected and min(picked.count(i) for i in expected) > 150


def test_what_is_best_of_a_group_hangs_on_that_group_alone() -> None:
    rng = np.random.default_rng(1)
    for _ in range(100):
        sizes = rng.integers(1, 5, 6)
        groups = [rng.integers(-2, 3, size) * 10.0 ** rng.integers(-12, 12) for size in sizes]
        starts = np.cumsum([0, *sizes[:-1]])
        alone = np.concatenate([each == each.max() for each in groups])
        assert best_of_groups(np.concatenate(groups), starts).tolist() == alone.tolist()


def test_no_legal_action_is_a_mistake(four_blocks: Domain, plain_bias) -> None:
    policy = Policy(four_blocks, plain_bias)
    at_goal = (("goal_on", "b1", "b2"), ("on", "b1", "b2"), ("on", "b2", "floor"))
    with pytest.raises(NppgError):
        policy.act(at_goal, np.random.default_rng(0))


def test_the_step_size_multiplies_the_stored_values(four_blocks: Domain, plain_bias) -> None:
    policy = Policy(four_blocks, plain_bias)
    test = Refiner(plain_bias).refinements(())[0]
    policy.add(Node(test.literals, (test.test,), Leaf(1.0), Leaf(-2.0)), step_size=0.25)
    assert [rule.value for rule in rules(policy.trees[0])] == [0.25, -0.5]
    assert [text.split(", ")[-1] if ":-" not in text else text for text in policy.rules(1)][-1] == "-0.5)."
    assert "0.25" in policy.rules(1)[0] and policy.rules(1)[0].endswith("!.")


def test_policies_of_one_domain_do_not_touch_each_other(four_blocks: Domain, plain_bias) -> None:
    one, two = (Policy(four_blocks, plain_bias) for _ in range(2))
    one.add(Leaf(1.0))
    (state,) = visited(four_blocks, 1)
    actions = four_blocks.situation(state).actions
    two.add(Leaf(5.0))
    assert set(one.prolog_potentials(state, actions)) == {1.0}
    del one
    assert set(two.prolog_potentials(state, actions)) == {5.0}
