"""Copies go on from where the original was, whatever becomes of it; so do pickled ones, in another process."""

from __future__ import annotations

import copy
import gc
import pickle
import subprocess
import sys
import weakref
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nppg import Domain, NppgError, Options, Policy, TGOptions, generate_episode, language_bias_of, open_domain, tilde
from nppg.experiments.train import train
from nppg.learning.episode import Episode
from nppg.worlds.gym_domain import GymDomain

gymnasium = pytest.importorskip("gymnasium")
from nppg.gym_env.bounded import BoundedEnv  # noqa: E402
from nppg.gym_env.domain_env import DomainEnv  # noqa: E402

COPIES = [copy.copy, copy.deepcopy, lambda each: pickle.loads(pickle.dumps(each))]
TAXI = max(each for each in gymnasium.registry if each.startswith("Taxi-v"))
copied = pytest.mark.parametrize("copied", COPIES, ids=["copy", "deepcopy", "pickle"])


def rng(seed: int = 0) -> np.random.Generator:
    return np.random.default_rng(seed)


def course(domain: Any, state: Any, steps: int = 4) -> list:
    """What happens from a state on, by the first legal action each time."""
    found, drawn = [], rng()
    for _ in range(steps):
        situation = domain.situation(state)
        found.append((state, situation))
        if situation.status == "running":
            found.append(domain.act(state, situation.actions[0], drawn))
            state = found[-1][1]
    return found


@copied
def test_a_domain_answers_as_before(copied: Callable) -> None:
    domain = Domain("blocks_world", {"blocks": 4})
    state, other = domain.start(rng(1)), domain.start(rng(2))
    expected = course(Domain("blocks_world", {"blocks": 4}), state)
    twin = copied(domain)
    twin.situation(other)
    assert domain.situation(state) == expected[0][1], "each sees the state that it is asked about"
    assert course(twin, state) == expected
    del domain
    gc.collect()
    open_domain("corridor")  # a question, with which Prolog forgets what Python has dropped
    assert course(twin, state) == expected and twin.parameters["blocks"] == 4


def test_a_module_goes_with_the_last_copy() -> None:
    domain = Domain("delivery")
    held = weakref.ref(domain._loaded)
    twin = copy.deepcopy(domain)
    assert twin.module == domain.module != pickle.loads(pickle.dumps(domain)).module
    twin.fluents.clear()
    assert domain.fluents
    del domain
    gc.collect()
    assert held()
    del twin
    gc.collect()
    assert not held()


def test_a_pickled_domain_needs_no_file(tmp_path: Path) -> None:
    path = tmp_path / "walk.pl"
    path.write_text(
        ":- module(walk, []).\n:- fluent at/1.\naction(go).\neffect(_, [at(X)], [at(Y)]) :- at(X), Y is X+1.\n"
        "start([at(1)]).\ngoal :- at(9).\n"
    )
    domain = Domain(path)
    data = pickle.dumps(domain)
    for change in (lambda: path.write_text("other"), path.unlink):
        change()
        twin = pickle.loads(data)
        assert course(twin, (("at", 1),)) == course(domain, (("at", 1),))
        assert (twin.hash, twin.path) == (domain.hash, path)


@copied
@pytest.mark.parametrize("id", ["CartPole-v1", "FrozenLake-v1", TAXI])
def test_an_environment_goes_on_from_where_it_was(id: str, copied: Callable) -> None:
    domain = open_domain(f"gym:{id}")
    state = domain.start(rng(3))
    (first,), seed = domain.situation(state).actions[:1], rng()
    _, state = domain.act(state, first, seed)
    twin, expected = copied(domain), course(copy.deepcopy(domain), state)
    domain.act(state, first, seed)
    assert course(twin, state) == expected
    again = copied(twin)
    del domain, twin
    gc.collect()
    state = again.start(rng(3))
    assert again.situation(state).status == "running" and language_bias_of(again).max_variables


def test_what_an_environment_cannot_copy_is_one_line() -> None:
    domain = open_domain("gym:CartPole-v1")
    assert isinstance(domain, GymDomain)
    domain._made.env.unwrapped.stream = (each for each in ())  # type: ignore[attr-defined]
    for copied in COPIES[:2]:
        with pytest.raises(NppgError, match=r"^gym:CartPole-v1: it cannot be copied: TypeError: [^\n]*$"):
            copied(domain)


def learned(domain: Domain, options: Any) -> Policy:
    *_, last = train(domain, language_bias_of(domain), options)
    return last.policy


def judged(policy: Policy, seed: int = 5) -> Episode:
    return generate_episode(policy, rng(seed))


@copied
@pytest.mark.parametrize("name", ["blocks_world", "gym:FrozenLake-v1"])
def test_a_policy_chooses_as_before_and_learns_alone(name: str, copied: Callable) -> None:
    domain = open_domain(name, {"blocks": 4} if name == "blocks_world" else {})
    policy = learned(domain, Options(episodes=40, min_examples=20, guidance=0.2 * (name == "blocks_world")))
    assert policy.trees
    state = domain.start(rng())
    actions = domain.situation(state).actions
    before, rules = policy.potentials(state, actions).tolist(), policy.rules(1)
    twin = copied(policy)
    for each in (policy, twin):
        assert each.potentials(state, actions).tolist() == before == each.prolog_potentials(state, actions).tolist()
    policy.add(policy.trees[0])
    assert len(twin.trees) == len(policy.trees) - 1 == twin.sizes()["trees"]
    assert twin.potentials(state, actions).tolist() == before == twin.prolog_potentials(state, actions).tolist()
    twin.add(policy.trees[0], comment="again")
    assert twin.potentials(state, actions).tolist() == policy.potentials(state, actions).tolist()
    before = twin.potentials(state, actions).tolist()
    del policy, each
    gc.collect()
    open_domain("corridor")
    assert twin.rules(1) == rules and twin.potentials(state, actions).tolist() == before
    assert twin.prolog_potentials(state, actions).tolist() == before
    assert judged(twin).steps


def test_a_tables_columns_are_those_of_the_copys_own_candidates() -> None:
    domain = Domain("blocks_world", {"blocks": 3})
    bias = language_bias_of(domain)
    examples = [tilde.Example(domain.start(rng(i)), ("move", "b1", "floor"), float(i % 2)) for i in range(12)]
    assert tilde.fit(examples, copy.deepcopy(domain), copy.deepcopy(bias)) == tilde.fit(examples, domain, bias)
    table = Policy(domain, bias).table
    table._columns[1] = (0, [], np.zeros(0))
    assert not copy.deepcopy(table)._columns


@pytest.mark.parametrize("copied", COPIES[1:], ids=["deepcopy", "pickle"])
def test_a_q_function_predicts_as_before(copied: Callable) -> None:
    domain = Domain("blocks_world", {"blocks": 3})
    policy = learned(domain, TGOptions(episodes=60, min_sample=10))
    state = domain.start(rng())
    actions = domain.situation(state).actions
    twin = copied(policy)
    assert twin.potentials(state, actions).tolist() == policy.potentials(state, actions).tolist()
    assert judged(twin).steps[0].potentials.tolist() == judged(policy).steps[0].potentials.tolist()


# ---------------------------------------------------------------- as environments of Gymnasium


def played(env: Any, actions: list[int]) -> list:
    return [repr(env.step(action)) for action in actions]


ENVIRONMENTS = {
    "domain": lambda: DomainEnv("blocks_world", {"blocks": 4}, horizon_factor=5),
    "wrapped": lambda: gymnasium.make("nppg/grid-v0", horizon_factor=5),
    "random": lambda: DomainEnv("noisy_blocks", horizon_factor=5),
    "bounded": lambda: BoundedEnv("delivery", slots=8, horizon_factor=5),
    "gym": lambda: DomainEnv("gym:CartPole-v1"),
    "gym-bounded": lambda: BoundedEnv("gym:FrozenLake-v1"),
}


@pytest.mark.parametrize("name", ENVIRONMENTS)
@copied
def test_an_environment_is_copied_with_all_that_it_will_draw(name: str, copied: Callable) -> None:
    if name == "wrapped" and copied is copy.copy:
        pytest.skip("a copied wrapper of Gymnasium's has the same environment")
    env, alike = ENVIRONMENTS[name](), ENVIRONMENTS[name]()
    for each in (env, alike):
        each.reset(seed=4)
        each.step(0)
    twin = copied(env)
    env.step(1)
    env.reset()
    expected = played(alike, [0, 1, 0])
    assert played(twin, [0, 1, 0]) == expected
    assert twin.action_space is not env.action_space
    del env
    gc.collect()
    open_domain("corridor")
    assert repr(twin.reset()) == repr(alike.reset())
    twin.action_space.seed(0)
    assert twin.action_space.sample() in twin.action_space


def test_a_pickled_policy_is_itself_in_another_process(tmp_path: Path) -> None:
    domain = Domain("blocks_world", {"blocks": 4})
    policy = learned(domain, Options(episodes=30, min_examples=20))
    state = domain.start(rng())
    (tmp_path / "policy").write_bytes(pickle.dumps((policy, state)))
    program = (
        "import pickle, sys; policy, state = pickle.load(open(sys.argv[1], 'rb'))\n"
        "print(policy.potentials(state, policy.domain.situation(state).actions).tolist())"
    )
    command = [sys.executable, "-c", program, str(tmp_path / "policy")]
    printed = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout
    assert printed.strip() == str(policy.potentials(state, domain.situation(state).actions).tolist())
