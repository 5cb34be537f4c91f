"""Rules as clauses and back, and model files: the same to the bit, and never more than data."""

from __future__ import annotations

import os
import re
from pathlib import Path
from random import Random

import numpy as np
import pytest
from samples import in_plain_prolog, pairs, random_query, random_tree, resigned, term, value_of_list, visited

from nppg.answers.coverage import Coverage
from nppg.bias.declarations import TreeLimits
from nppg.errors import NppgError
from nppg.logic.query import Literal, Var
from nppg.policy.policy import Policy
from nppg.trees.clauses import from_clause, to_clause
from nppg.trees.tilde import grow
from nppg.trees.tree import Leaf, Node, Rule
from nppg.worlds.domain import Domain


@pytest.mark.parametrize("seed", range(4))
def test_a_clause_says_what_its_rule_says(setting, seed: int) -> None:
    domain, bias, refiner, _ = setting
    examples = list(zip(*pairs(domain, visited(domain, 4)), strict=True))
    queries = [random_query(refiner, 1 + i % 4, Random(10 * seed + i)) for i in range(8)]
    ordered = [Rule(query, i + 0.5) for i, query in enumerate(queries)] + [Rule((), -1.0)]
    again = []
    for rule in ordered:
        _, head, body, value = to_clause(rule, bias)
        again.append(from_clause(head, body, value, bias))
        assert to_clause(again[-1], bias)[3] == rule.value
    for state, action in examples:
        assert value_of_list(again, bias, state, action) == value_of_list(ordered, bias, state, action)


@pytest.fixture
def policy(setting, tmp_path: Path) -> Policy:
    domain, bias, refiner, table = setting
    policy = Policy(domain, bias, table)
    for seed in range(8):
        policy.add(random_tree(refiner, 4, Random(seed)))
    return policy


def test_saved_and_loaded_potentials_are_equal_to_the_bit(policy: Policy, tmp_path: Path) -> None:
    policy.save(tmp_path / "model.pl", [("option", ("=", "seed", 3))])
    loaded = Policy.load(tmp_path / "model.pl")
    assert loaded.domain is not policy.domain and len(loaded.trees) == len(policy.trees)
    for state in visited(policy.domain, 8):
        actions = policy.domain.situation(state).actions
        expected = policy.prolog_potentials(state, actions)
        assert (loaded.potentials(state, actions) == expected).all()
        assert (loaded.prolog_potentials(state, actions) == expected).all()


def without_comments(path: Path) -> list[str]:
    return [line for line in path.read_text().splitlines() if not line.startswith(("% tree", "% SHA-256"))]


def test_a_loaded_model_is_saved_as_it_was(setting, tmp_path: Path) -> None:
    """For trees that have been grown: reading drops rules that are never reached, and a grown tree has none."""
    domain, bias, refiner, table = setting
    states, actions = pairs(domain, visited(domain, 15))
    policy, coverage = Policy(domain, bias, table), Coverage(table, states, actions)
    for seed in range(5):
        targets = np.random.default_rng(seed).normal(size=len(actions))
        policy.add(grow(targets, coverage, refiner, TreeLimits(5, 1)), step_size=0.3)
    policy.save(tmp_path / "model.pl")
    (tmp_path / "again").mkdir()
    Policy.load(tmp_path / "model.pl").save(tmp_path / "again" / "model.pl")
    assert without_comments(tmp_path / "again" / "model.pl") == without_comments(tmp_path / "model.pl")
    assert sorted(os.listdir(tmp_path / "again")) == sorted(["model.pl", policy.domain.path.name])


@pytest.fixture
def model(blocks: Domain, plain_bias, tmp_path: Path) -> Path:
    """A small readable model: two trees, three rules each."""

    def tree(value: float) -> Node:
        first, second = (Literal("clear", (Var(2),)),), (Literal("=", (Var(1), "floor")),)
        return Node(first, (first,), Leaf(value), Node(second, (second,), Leaf(2 * value), Leaf(-value)))

    policy = Policy(blocks, plain_bias)
    policy.add(tree(0.5))
    policy.add(tree(0.25))
    policy.save(tmp_path / "model.pl")
    return tmp_path / "model.pl"


def refused(path: Path, text: str) -> NppgError:
    resigned(path, text)
    with pytest.raises(NppgError) as caught:
        Policy.load(path)
    assert all(each.file == str(path) for each in caught.value.problems), caught.value
    return caught.value


def test_the_model_is_readable(model: Path) -> None:
    text = model.read_text()
    assert "delta(1, move(_, _), 0.5) :- goal_on(Block, _), clear(Block), !.\n" in text
    assert "delta(1, move(_, floor), 1.0) :- !.\n" in text
    assert "delta(1, _, -0.5).\n" in text or "delta(1, move(_, _), -0.5).\n" in text


@pytest.mark.parametrize(
    ("planted", "problem"),
    [
        (":- open('{file}', write, S), close(S).", "no rule"),
        (":- initialization((open('{file}', write, S), close(S))).", "no rule"),
        ("?- open('{file}', write, S), close(S).", "no rule"),
        ("user:term_expansion(_, _) :- open('{file}', write, S), close(S).", "no rule"),
        ("delta(3, _, 1.0) :- open('{file}', write, S), close(S), !.", "open/3 is no declared"),
        ("delta(3, _, 1.0) :- call((open('{file}', write, S), close(S))), !.", "no rule"),
        ("delta(3, _, 1.0) :- shell('touch {file}'), !.", "shell/1 is no declared"),
        ("delta(3, _, V) :- V is 1, !.", "no rule"),
        ("delta(3, move(X, _), 1.0) :- holding(X), !.", "holding/1 is no declared"),
        ("delta(3, move(X, _), 1.0) :- clear(X, X), !.", "clear/2 is no declared"),
        ("delta(3, lift(_), 1.0).", "lift/1 is no declared action"),
        ("delta(3, move(X, _), 1.0) :- clear(X).", "no rule"),  # its cut is missing
        ("delta(3, move(X, _), 1.0) :- clear(f(X)), !.", "no rule"),
        ("delta(3, move(X, _), 1.0) :- clear(X), !.", "cut off"),  # nothing follows
        ("delta(3, move(_, floor), 1.0).", "last rule"),
        ("delta(4, _, 1.0).", "tree 3 is expected"),
        ("delta(3, _, 1.0Inf).", "finite"),
        ("delta(3, _, 1.5NaN).", "finite"),
        ("delta(3, move(X, _), 1.0) :- clear(X), X, !.", "no rule"),
        ("delta(3, move(X, _), 1.0) :- clear([]), !.", "constants"),
        ("delta(3, _, 1.0) :- clear(", ""),
        ("delta(3, _, 1.0).", "cut off"),  # one more than announced
    ],
)
def test_a_model_is_data(model: Path, planted: str, problem: str) -> None:
    text = model.read_text()
    file = model.parent / "executed"
    lines = len(text.splitlines())
    error = refused(model, text + planted.format(file=file) + "\n")
    assert problem in str(error), error
    assert error.problems[0].line in (lines + 1, lines + 2)
    first = text.index("delta(1")
    refused(model, text[:first] + planted.format(file=file) + "\n" + text[first:])
    refused(model, planted.format(file=file) + "\n" + text)
    assert not file.exists()


def test_the_domain_stands_beside_its_model(model: Path) -> None:
    elsewhere = model.parent / "elsewhere"
    elsewhere.mkdir()
    evil = elsewhere / "blocks_world.pl"
    evil.write_text(f":- open('{model.parent}/executed', write, S), close(S).\n")
    text = model.read_text().replace("'blocks_world.pl'", f"'{evil}'")
    assert str(evil) in text
    refused(model, text)
    assert not (model.parent / "executed").exists()


def test_a_model_that_is_cut_off_anywhere_is_refused(model: Path) -> None:
    lines = model.read_text().splitlines(keepends=True)
    last = max(i for i, line in enumerate(lines) if line.startswith("delta"))
    for end in range(last + 1):
        refused(model, "".join(lines[:end]))
        if line := lines[end].rstrip():
            refused(model, "".join(lines[:end]) + line[: len(line) // 2])
    resigned(model, "".join(lines))
    Policy.load(model)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("model(format, 1)", "model(format, 2)"),
        ("model(parameter, blocks=10)", "model(parameter, blocks)"),
        ("model(parameter, blocks=10)", "model(parameter, blok=10)"),
        ("model(parameter, blocks=10)", "model(parameter, f(blocks, 10))"),
        ("model(literal, clear(place))", "model(literal, 3)"),
        ("model(literal, clear(place))", "model(literal, clean(place))"),
        ("model(literal, clear(place))", "model(literal, clear(f(place)))"),
        ("model(action, move(block, place))", "model(action, [])"),
        ("model(goal, goal_on(block, block))", "model(goal, 1.5)"),
        ("model(trees, 2)", "model(trees, 3)"),
        ("model(trees, 2)", "model(trees, X)"),
        ("model(trees, 2)", "model([a], 1)"),
        ("model(trees, 2)", "model(f(x), 1)"),
        ("model(trees, 2)", "model(2, trees)"),
        ("0.25", "10" * 400),
    ],
)
def test_a_wrong_head_is_refused(model: Path, old: str, new: str) -> None:
    text = model.read_text()
    assert old in text
    resigned(model, text.replace(old, new, 1))
    with pytest.raises(NppgError):
        Policy.load(model)


def test_what_another_version_has_written_may_be_so(model: Path) -> None:
    """The predicates for plain Prolog are those of the version that wrote the file."""
    resigned(model, model.read_text().replace("best_action(Action) :-", "best_action(Best, Action) :-"))
    with pytest.raises(NppgError, match="written by another version of nppg"):
        Policy.load(model)


def test_plain_prolog_gives_the_greedy_action(setting, policy: Policy, tmp_path: Path) -> None:
    domain, _, _, _ = setting
    policy.save(tmp_path / "model.pl")
    states = visited(domain, 6)
    for state, (action, potential) in zip(states, in_plain_prolog(tmp_path / "model.pl", states), strict=True):
        actions = domain.situation(state).actions
        expected = policy.potentials(state, actions)
        chosen = [term(each).replace(", ", ",") for each in actions].index(action)
        assert expected[chosen] == expected.max() == pytest.approx(potential, rel=1e-14)


def test_parameters_can_be_changed_on_loading(model: Path) -> None:
    loaded = Policy.load(model, {"blocks": 3})
    state = loaded.domain.start(np.random.default_rng(0))
    assert len(state) == 4 and re.search(r"blocks=10", model.read_text())
