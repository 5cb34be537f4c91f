"""Proofs: hand-written rules proven right, a planted wrong rule found, every count counted again by brute force."""

from __future__ import annotations

import json
from itertools import permutations
from pathlib import Path

import numpy as np
import pytest
from samples import resigned

from nppg.cli.main import main
from nppg.judging.evaluation import evaluate_exactly
from nppg.learning.episode import generate_episode
from nppg.policy.policy import Policy
from nppg.rules.proof import Failure, prove
from nppg.worlds.domain import Domain

OPTIMAL = """
delta(1, move(X, Y), 9.0) :- goal_on(X, Y), !.
delta(1, move(_, Y), 0.0) :- clear(Y), !.
delta(1, move(X, _), 9.0) :- goal_on(A, _), above(X, A), !.
delta(1, move(X, _), 9.0) :- goal_on(_, B), above(X, B), !.
delta(1, _, 0.0).
"""
PLANTED = {
    "loses": ("goal_on(_, B), above(X, B)", "goal_on(_, B), on(X, B)"),  # waits while more lies above B
    "never": ("move(X, Y), 9.0", "move(X, Y), -1.0"),  # prefers all other moves to the one that reaches the goal
    "piles": ("move(_, Y), 0.0", "move(_, Y), 9.5"),  # onto clear blocks first of all
}


@pytest.fixture
def model(tmp_path: Path, four_blocks: Domain, plain_bias):
    """Writes rules by hand into a model file for so many blocks."""

    def write(rules: str = OPTIMAL, blocks: int = 4) -> Path:
        path = tmp_path / "model.pl"
        Policy(four_blocks, plain_bias).save(path)
        text = path.read_text().replace("model(trees, 0)", "model(trees, 1)")
        resigned(path, text.replace("blocks=4", f"blocks={blocks}") + rules)
        return path

    return write


def planted(name: str) -> str:
    old, new = PLANTED[name]
    assert OPTIMAL.count(old) == 1
    return OPTIMAL.replace(old, new)


def all_states(blocks: int) -> set[frozenset]:
    """Every way to stack so many blocks, as sets of on/2 facts."""
    found = {frozenset()}
    for i in range(1, blocks + 1):  # the next block goes onto the floor, onto a tower or between two blocks
        new = set()
        for state in found:
            for below in ["floor", *(f"b{j}" for j in range(1, i))]:
                new.add(state | {("on", f"b{i}", below)})
            for fact in state:
                new.add(state - {fact} | {("on", fact[1], f"b{i}"), ("on", f"b{i}", fact[2])})
        found = {each for each in new if is_state(each)}
    return found


def is_state(facts: frozenset) -> bool:
    below = [fact[2] for fact in facts if fact[2] != "floor"]
    return len(set(below)) == len(below)


def orbits(states: set[frozenset], fixed: tuple[str, str], blocks: int) -> dict[frozenset, int]:
    """Each state's number of renamings that leave the two goal blocks alone."""
    free = [f"b{i}" for i in range(1, blocks + 1) if f"b{i}" not in fixed]
    sizes = {}
    for state in states:
        renamings = (dict(zip(free, order, strict=True)) for order in permutations(free))
        same = {frozenset((n, names.get(x, x), names.get(y, y)) for n, x, y in state) for names in renamings}
        sizes[state] = len(same)
    return sizes


def goal_of(failure: Failure) -> tuple[str, str]:
    ((_, a, b),) = [fact for fact in failure.state if fact[0] == "goal_on"]
    return a, b


def courses(policy: Policy, state: tuple, greedy: bool, count: int) -> list[bool]:
    """Whether episodes from a state reach the goal in time."""
    rng = np.random.default_rng(0)
    found = []
    for _ in range(count):
        here, steps = state, policy.domain.horizon(state)
        while policy.domain.situation(here).status == "running" and steps:
            here = policy.domain.act(here, policy.act(here, rng, greedy), rng)[1]
            steps -= 1
        found.append(policy.domain.situation(here).status == "goal")
    return found


@pytest.mark.parametrize(("blocks", "states"), [(2, 3), (3, 13), (4, 73), (5, 501)])
def test_optimal_rules_are_proven(model, blocks: int, states: int) -> None:
    path = model(blocks=blocks)
    policy = Policy.load(path)
    proof = prove(policy, path)
    everything = all_states(blocks)
    assert len(everything) == states
    sizes = orbits(everything, ("b1", "b2"), blocks)
    goals = [state for state in everything if ("on", "b1", "b2") in state]
    assert (proof.states, proof.starts) == (states, states - len(goals))
    assert proof.classes == round(sum(1 / size for size in sizes.values()))
    assert proof.complete and proof.success == 1.0 and proof.failures == () and proof.greedy
    assert proof.parameters == {"blocks": blocks, "task": "on"}


def test_the_stochastic_policy_of_the_same_rules_is_not(model) -> None:
    path = model()
    policy = Policy.load(path)
    proof = prove(policy, path, greedy=False)
    exact = evaluate_exactly(policy).success
    assert not proof.complete and not proof.greedy and 0.99 < proof.success < 1
    assert proof.success == pytest.approx(exact, abs=1e-12)
    assert 0 < len(proof.failures) < proof.classes and all(0.9 < each.success < 1 for each in proof.failures)


@pytest.mark.parametrize("name", PLANTED)
@pytest.mark.parametrize("greedy", [True, False])
def test_a_planted_wrong_rule_is_found(model, name: str, greedy: bool) -> None:
    """The classes that are named fail as often as is said, in the course of real episodes; no others do."""
    path = model(planted(name))
    policy = Policy.load(path)
    proof = prove(policy, path, greedy)
    everything = all_states(4)
    assert not proof.complete and 0 < len(proof.failures) < proof.classes
    loss, drawn = 0.0, []
    for failure in proof.failures:
        found = courses(policy, failure.state, greedy, 20)
        assert (any(found) or failure.success < 0.2) and (not all(found) or failure.success > 0.8)
        drawn.append(np.mean(found))
        facts = frozenset(fact for fact in failure.state if fact[0] == "on")
        assert facts in everything and ("on", *goal_of(failure)) not in facts
        assert failure.states == orbits({facts}, goal_of(failure), 4)[facts]
        assert f"goal: {' on '.join(goal_of(failure))}" == failure.picture[-1]
        loss += failure.states * (1 - failure.success)
    assert np.mean(drawn) == pytest.approx(np.mean([each.success for each in proof.failures]), abs=0.05)
    assert loss / proof.starts == pytest.approx(1 - proof.success, abs=1e-12)
    losses = [failure.states * (1 - failure.success) for failure in proof.failures]
    assert losses == pytest.approx(sorted(losses, reverse=True)) and losses[0] > 0.1
    rng = np.random.default_rng(1)
    episodes = [generate_episode(policy, rng, greedy=greedy) for _ in range(100)]
    named = {shape(failure.state) for failure in proof.failures}
    missed = {shape(each.steps[0].state) for each in episodes if not each.success}
    assert missed and missed <= named


def shape(state: tuple) -> tuple:
    """The same for states of a class: the least of all renamings that call the goal's blocks b1 and b2."""
    ((_, a, b),) = [fact for fact in state if fact[0] == "goal_on"]
    facts = [fact for fact in state if fact[0] == "on"]
    rest = [fact[1] for fact in facts if fact[1] not in (a, b)]
    candidates = []
    for order in permutations(range(3, 3 + len(rest))):
        names = {a: "b1", b: "b2", "floor": "floor"} | {x: f"b{i}" for x, i in zip(rest, order, strict=True)}
        candidates.append(tuple(sorted((names[x], names[y]) for _, x, y in facts)))
    return min(candidates)


def test_prove_as_a_command(model, capsys: pytest.CaptureFixture[str]) -> None:
    path = model()
    certificate = path.with_name("proof.json")
    assert main(["prove", str(path), "--output", str(certificate)]) == 0
    printed = capsys.readouterr().out
    assert "73 states, 60 of them start states" in printed and "greedy policy succeeds from every one" in printed
    contents = json.loads(certificate.read_text())
    assert contents["success"] == 1.0 and contents["failures"] == [] and contents["states"] == 73
    assert main(["prove", str(path), "--set", "blocks=5"]) == 0
    assert "501 states, 428 of them" in capsys.readouterr().out
    path = model(planted("never"))
    assert main(["prove", str(path), "--show", "1"]) == 0
    printed = capsys.readouterr().out
    assert printed.count("goal: ") == 1 and "with probability 0.000000" in printed and "it can fail in" in printed


@pytest.mark.parametrize("which", ["model", "domain", "rules"])
def test_the_certificate_of_a_changed_file_is_refused(model, which: str, capsys) -> None:
    path = model()
    certificate = path.with_name("proof.json")
    assert main(["prove", str(path), "--output", str(certificate)]) == 0
    assert main(["prove", str(path), "--check", str(certificate)]) == 0
    capsys.readouterr()
    if which == "rules":
        model(planted("loses"))
    else:
        changed = path if which == "model" else path.with_name("blocks_world.pl")
        text = changed.read_text() + "% another comment\n"
        resigned(changed, text) if which == "model" else changed.write_text(text)
    assert main(["prove", str(path), "--check", str(certificate)]) == 2
    errors = capsys.readouterr().err.splitlines()
    assert len(errors) == 1
    assert ("is not the file that this model was learned with" if which == "domain" else "certificate") in errors[0]


@pytest.mark.parametrize(
    "garbage",
    [b"", b"{", b"[]", b"null", b"3", b'"model_sha256"', b"{}", b"\xff\xfe\x00", b"NaN", b"[" * 100_000],
    ids=lambda garbage: repr(garbage[:14]),
)
def test_garbage_is_no_certificate(model, garbage: bytes, capsys: pytest.CaptureFixture[str]) -> None:
    path = model(blocks=3)
    certificate = path.with_name("proof.json")
    certificate.write_bytes(garbage)
    assert main(["prove", str(path), "--check", str(certificate)]) == 2
    assert "no certificate of nppg" in capsys.readouterr().err


def test_certificates_that_cannot_be_read_or_written(model, tmp_path: Path, capsys) -> None:
    path = model(blocks=3)
    for wrong in (tmp_path / "nothing.json", tmp_path):
        assert main(["prove", str(path), "--check", str(wrong)]) == 2
        assert f"{wrong}: cannot be read" in capsys.readouterr().err
    assert main(["prove", str(path), "--output", str(tmp_path / "no" / "folder.json")]) == 2
    assert "cannot be written" in capsys.readouterr().err
