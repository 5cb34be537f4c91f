"""A policy that is a list of rules finds its best actions without scoring the others: they are the same."""

from __future__ import annotations

from pathlib import Path
from random import Random

import numpy as np
import pytest
from samples import random_tree

from nppg import Domain, LanguageBias, NppgError, Policy, evaluate, language_bias_of, open_domain
from nppg.bias.refinement import Refiner
from nppg.policy.gibbs import best
from nppg.trees.tree import Leaf, Node, Tree, mapped

DOMAINS = Path(__file__).parent / "domains"
PDDL = """
(define (domain parcels)
  (:requirements :strips :typing :negative-preconditions)
  (:types parcel place)
  (:predicates (at ?p - parcel ?x - place) (van ?x - place) (in ?p - parcel) (road ?x ?y - place))
  (:action go :parameters (?x ?y - place) :precondition (and (van ?x) (road ?x ?y))
    :effect (and (not (van ?x)) (van ?y)))
  (:action load :parameters (?p - parcel ?x - place) :precondition (and (van ?x) (at ?p ?x))
    :effect (and (not (at ?p ?x)) (in ?p)))
  (:action drop :parameters (?p - parcel ?x - place) :precondition (and (van ?x) (in ?p))
    :effect (and (at ?p ?x) (not (in ?p)))))
"""
PROBLEM = """
(define (problem two) (:domain parcels)
  (:objects a b c - place p q - parcel)
  (:init (van a) (at p a) (at q b) (road a b) (road b c) (road c a) (road b a))
  (:goal (and (at p c) (at q a))))
"""


def opened(name: str, folder: Path) -> tuple[Domain, LanguageBias]:
    if name != "pddl":
        domain = open_domain(name)
        return domain, language_bias_of(domain)
    (folder / "parcels.pddl").write_text(PDDL)
    (folder / "two.pddl").write_text(PROBLEM)
    domain = open_domain(folder / "parcels.pddl", problems=[folder / "two.pddl"])
    return domain, language_bias_of(domain)


def random_rules(refiner: Refiner, rng: Random) -> Tree:
    """Values are few, so that rules share them."""
    return mapped(random_tree(refiner, 3, rng), lambda _: float(rng.randint(-2, 2)))


@pytest.mark.parametrize("name", ["blocks_world", "delivery", str(DOMAINS / "roads.pl"), "pddl"])
def test_the_best_actions_are_those_of_the_highest_potential(name: str, tmp_path: Path) -> None:
    domain, bias = opened(name, tmp_path)
    rng = np.random.default_rng(1)
    refiner = Refiner(bias)
    seen = 0
    for seed in range(20):
        policy = Policy(domain, bias)
        policy.add(random_rules(refiner, Random(seed)))
        assert policy.is_rules
        state = domain.start(rng)
        for _ in range(6):
            status, actions = domain.situation(state)
            if status != "running":
                break
            potentials = policy.potentials(state, actions)
            expected = [action for action, good in zip(actions, best(potentials), strict=True) if good]
            assert policy.preferred(state) == expected
            seen += len(expected) < len(actions)
            _, state = domain.act(state, actions[int(rng.integers(len(actions)))], rng)
    assert seen > 2


def test_episodes_are_the_same_either_way(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    domain, bias = opened("pddl", tmp_path)
    refiner = Refiner(bias)
    for seed in range(5):
        policy = Policy(domain, bias)
        policy.add(random_rules(refiner, Random(seed)))
        alone = evaluate(policy, 10, greedy=True)
        with monkeypatch.context() as patched:
            patched.setattr(Policy, "is_rules", False)
            assert evaluate(policy, 10, greedy=True) == alone


def test_values_that_are_nearly_equal_are_scored(tmp_path: Path) -> None:
    domain, bias = opened("pddl", tmp_path)
    first = Refiner(bias).refinements(())[0]
    policy = Policy(domain, bias)
    policy.add(Node(first.literals, (first.test,), Leaf(1.0), Leaf(1.0 + 1e-12)))
    assert not policy.is_rules
    policy.add(Leaf(1.0))
    assert not policy.is_rules, "a sum of two trees is no list"


def taking(folder: Path, test: str, first: float = 2.0) -> Policy:
    """A policy of rules about many actions, the first for those that are good."""
    file = folder / "many.pl"
    file.write_text(f"""\
:- module(many, []).
:- fluent wet/1.
start([wet(1)]).
action(take(N)) :- between(1, 3000, N).
effect(take(_), [], []).
goal :- wet(0).
{test}
""")
    bias = LanguageBias.parse("action: take(number)\ntypes: {good: [number]}\nmodes: [good(+)]\n", "many.yaml")
    policy = Policy(Domain(file), bias)
    (good,) = [each for each in Refiner(bias).refinements(()) if each.test[0].name == "good"]
    policy.add(Node(good.literals, (good.test,), Leaf(first), Leaf(1.0)))
    return policy


def test_rules_have_as_much_time_as_all_actions_have(tmp_path: Path) -> None:
    policy = taking(tmp_path, "good(N) :- numlist(1, 200, L), foldl(plus, L, 0, _), N > 2990.")
    state = policy.domain.start(np.random.default_rng(0))
    actions = policy.domain.situation(state).actions
    potentials = policy.potentials(state, actions)
    assert policy.is_rules
    assert policy.preferred(state) == [actions[i] for i in np.flatnonzero(best(potentials))]


def test_a_test_is_to_blame_for_what_it_raises(tmp_path: Path) -> None:
    policy = taking(tmp_path, "good(N) :- N < 0 -> true ; atom_length(_, _).")
    state = policy.domain.start(np.random.default_rng(0))
    with pytest.raises(NppgError, match="test of the language bias"):
        policy.preferred(state)


@pytest.mark.parametrize("first", [2.0, -2.0])
def test_a_test_that_loops_is_stopped(tmp_path: Path, first: float) -> None:
    policy = taking(tmp_path, "good(N) :- N < 0 -> true ; repeat, fail.", first)
    with pytest.raises(NppgError, match="inferences"):
        policy.preferred(policy.domain.start(np.random.default_rng(0)))
