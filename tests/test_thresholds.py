"""Thresholds: trees, potentials, rules and models with bounds, among objects that have weights and numbers alone."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from random import Random

import numpy as np
import pytest
from samples import in_plain_prolog, random_query, random_tree, resigned, truth, value_of_list, value_of_tree

from nppg.answers.coverage import Coverage, root_table
from nppg.answers.facts import FactTable
from nppg.answers.table import TestTable
from nppg.bias.declarations import TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, Refiner
from nppg.errors import NppgError
from nppg.judging.evaluation import evaluate_exactly
from nppg.learning.options import Options
from nppg.learning.training import train
from nppg.logic.query import OPEN, Literal, Query, Var
from nppg.policy.policy import Policy
from nppg.rrl.options import RIBOptions, TGOptions, TrendiOptions
from nppg.rrl.regressors import regressor
from nppg.rules.distill import distill
from nppg.rules.dot import dot
from nppg.rules.explain import explained
from nppg.trees.clauses import from_clause, to_clause
from nppg.trees.tilde import Example, Newton, best_split, fit, grow
from nppg.trees.tree import Leaf, Node, Rule, Tree, rules
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State

DEPOT = """
:- module(depot, []).
:- fluent near/2, weight/2, red/1, limit/1, reach/1.
:- parameter(odd, none).

start(Facts) :-
    findall(weight(X, W), ( member(X, [a, b, c]), some(2, W) ), Weights),
    findall(near(X, Y), ( member(X, [a, b, c]), member(Y, [a, b, c]), random(U), U < 0.3 ), Near),
    findall(red(X), ( member(X, [a, b, c]), random(U), U < 0.5 ), Red),
    findall(reach(D), some(2, D), Reach),
    some(1, Limit),
    append([Weights, Near, Red, Reach, [limit(Limit), weight(a, 0)]], Facts0),
    sort(Facts0, Facts).

some(N, W) :- between(1, N, _), random_between(-3, 3, I), random(U), ( U < 0.5 -> W = I ; W is I * 1.25 ).

action(lift(X)) :- member(X, [a, b, c]).
action(go(D))   :- reach(D).
action(wait).

effect(_, [], []).
goal :- \\+ red(_).
reward(lift(X), 1) :- weight(X, W), W > 1.5, red(X), !.
reward(go(D), 0.5) :- D < -1, !.
reward(_, 0).
horizon(3).

heavier(X, Y) :- weight(X, V), weight(Y, W), V > W.
measured(X, W) :- weight(X, W).
measured(X, W) :- red(X), parameter(odd, W), W \\== none.
"""
DEPOT_BIAS = """
action: [go(+distance), lift(+item), wait]
goal: limit(-mass)
lookahead: 2
max_variables: 3
types: {near: [item, item], weight: [item, mass], red: [item]}
modes:
  - {literal: "near(+item, -item)", lookahead: 2}
  - {literal: "weight(+item, -mass)", lookahead: 1}
  - red(+)
  - "+mass =< #"
  - "+mass >= #"
  - "+distance =< #"
  - equal(+distance, [2, 0])
  - equal(+item, +item)
"""
PLAIN = """
:- module(plain, []).
:- fluent obs/2.
start([obs(1, 0.0)]).
action(go).
effect(_, [], []).
goal :- fail.
"""
PLAIN_BIAS = """
action: [go]
types: {obs: [index, value]}
modes:
  - {literal: "obs([1, 2, 3, 4], -value)", lookahead: 1}
  - "+value =< #"
lookahead: 1
max_variables: 9
"""


def loaded(folder: Path, name: str, domain: str, bias: str, **parameters) -> tuple[Domain, LanguageBias]:
    (folder / f"{name}.pl").write_text(domain)
    (folder / f"{name}.yaml").write_text(bias)
    return Domain(folder / f"{name}.pl", parameters), LanguageBias.load(folder / f"{name}.yaml")


@pytest.fixture(scope="module")
def depot(tmp_path_factory: pytest.TempPathFactory) -> tuple[Domain, LanguageBias]:
    return loaded(tmp_path_factory.mktemp("depot"), "depot", DEPOT, DEPOT_BIAS)


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> tuple[Domain, LanguageBias]:
    return loaded(tmp_path_factory.mktemp("plain"), "plain", PLAIN, PLAIN_BIAS)


def pairs(domain: Domain, count: int, seed: int = 0) -> tuple[list[State], list[Action]]:
    """Random states, each with all its actions."""
    rng = np.random.default_rng(seed)
    found = [(state, action) for state in (domain.start(rng) for _ in range(count)) for action in actions_of(state)]
    return [state for state, _ in found], [action for _, action in found]


def actions_of(state: State) -> list[Action]:
    reached = dict.fromkeys(("go", fact[1]) for fact in state if fact[0] == "reach")
    return [*reached, ("lift", "a"), ("lift", "b"), ("lift", "c"), "wait"]


# ---------------------------------------------------------------- trees


class Numbers:
    """Random float32 data as states of the domain `plain`, the same in 64 bits for scikit-learn, and random targets.

    Without ties: where a node has at least 16 examples, no two columns part them in the same way."""

    def __init__(self, seed: int, columns: int, rows: int = 160):
        rng = np.random.default_rng(seed)
        self.columns = rng.normal(size=(rows, columns)).astype(np.float32).astype(float)
        self.targets = rng.normal(size=rows) + np.sin(3 * self.columns).sum(axis=1)
        self.states: list[State] = [
            tuple(("obs", i + 1, x) for i, x in enumerate(row)) for row in self.columns.tolist()
        ]

    def examples(self) -> list[Example]:
        return [Example(state, "go", value) for state, value in zip(self.states, self.targets.tolist(), strict=True)]


@pytest.mark.parametrize("max_depth", [1, 2, 3, 4, 5])
@pytest.mark.parametrize(("columns", "least"), [(1, 1), (1, 5), (4, 8)])
def test_trees_on_numbers_are_those_of_scikit_learn(plain, max_depth: int, columns: int, least: int) -> None:
    learner = pytest.importorskip("sklearn.tree").DecisionTreeRegressor
    domain, bias = plain
    for seed in range(2):
        data = Numbers(seed, columns)
        own = fit(data.examples(), domain, replace(bias, tree=TreeLimits(max_depth, least, 0.0)))
        theirs = learner(max_depth=max_depth, min_samples_leaf=least, random_state=0)
        expected = theirs.fit(data.columns, data.targets).tree_

        def same(node: Tree, number: int) -> None:
            if isinstance(node, Leaf):
                assert expected.children_left[number] == -1  # noqa: B023
                assert node.examples == expected.n_node_samples[number]  # noqa: B023
                assert node.value == pytest.approx(expected.value[number].item(), rel=1e-10, abs=1e-12)  # noqa: B023
                return
            ((read, bound),) = node.tests
            assert bound == Literal("=<", (read.args[1], expected.threshold[number]))  # noqa: B023
            assert read == Literal("obs", (expected.feature[number] + 1, Var(0)))  # noqa: B023
            same(node.yes, expected.children_left[number])  # noqa: B023
            same(node.no, expected.children_right[number])  # noqa: B023

        same(own, 0)


def closed_tests(refinement, limits: list[float]) -> list[tuple[float, Query]]:
    """What a candidate can become, with its limit."""
    return [(c, refinement.closed(c).test) for c in limits] if refinement.is_open else [(0.5, refinement.test)]


@pytest.mark.parametrize("second_order", [False, True])
@pytest.mark.parametrize("seed", range(2))
def test_every_split_is_the_best_by_brute_force(depot, seed: int, second_order: bool) -> None:
    """Over all candidates and all thresholds between numbers that occur, by the truth told in Python."""
    domain, bias = depot
    states, actions = pairs(domain, 5, seed)
    rng = np.random.default_rng(seed)
    targets, curvatures = rng.normal(size=len(actions)), rng.random(len(actions)) + 0.1
    newton = Newton(curvatures, 0.7, 9.0) if second_order else None
    refiner, least = Refiner(bias), 2
    coverage = Coverage(root_table(domain, bias, refiner), states, actions)
    tree = grow(targets, coverage, refiner, TreeLimits(2, least, 0.0), newton)
    occurring = {abs(arg) for state in states for fact in state for arg in fact[1:] if not isinstance(arg, str)}
    values = sorted(occurring | {-each for each in occurring})
    limits = [(a + b) / 2 for a, b in pairwise(values)] + [values[-1] + 1]

    def score(covered: np.ndarray, own: np.ndarray, weights: np.ndarray) -> float:
        if min(covered.sum(), (~covered).sum()) < least:
            return -np.inf
        return sum(
            own[part].sum() ** 2 / (weights[part].sum() + (0.7 if newton else 0)) for part in (covered, ~covered)
        )

    bounds = 0

    def check(node: Tree, query: Query, members: np.ndarray) -> None:
        nonlocal bounds
        if isinstance(node, Leaf):
            return
        tests = [test for each in refiner.refinements(query) for _, test in closed_tests(each, limits)]
        answers = np.concatenate([truth([*tests, *node.tests], bias, states[i], [actions[i]]) for i in members])
        weights = curvatures[members] if newton else np.ones(len(members))
        scores = [score(column, targets[members], weights) for column in answers.T]
        assert scores[-1] == pytest.approx(max(scores), rel=1e-9)
        bounds += node.tests[0][-1].name in OPEN
        covered = answers[:, -1]
        check(node.yes, query + node.literals, members[covered])
        check(node.no, query, members[~covered])

    check(tree, (), np.arange(len(targets)))
    assert bounds
    ordered = list(rules(tree))
    chosen = [leaf_of(ordered, bias, *pair) for pair in zip(states, actions, strict=True)]
    for i, rule in enumerate(ordered):
        own = np.array(chosen) == i
        weight = (curvatures[own].sum() + 0.7) if newton else own.sum()
        assert rule.value == pytest.approx(targets[own].sum() / weight, rel=1e-9, abs=1e-12)


def leaf_of(ordered: list[Rule], bias: LanguageBias, state: State, action: Action) -> int:
    numbered = [Rule(rule.query, i) for i, rule in enumerate(ordered)]
    return int(value_of_list(numbered, bias, state, action))


@pytest.mark.parametrize("granularity", [0, 1, 2, 3, 7, 20, 40])
@pytest.mark.parametrize("kind", ["distinct", "repeated", "skewed"])
def test_granularity_chooses_quantiles(granularity: int, kind: str) -> None:
    """Which cuts are tried is seen by targets that are parted at each cut in turn."""
    rng = np.random.default_rng(3)
    column = {"distinct": rng.random(30), "repeated": rng.integers(0, 12, 30) / 4, "skewed": rng.random(30) ** 6 // 0.1}
    values = np.asarray(column[kind], float)
    distinct = np.unique(values)
    middles = (distinct[:-1] / 2 + distinct[1:] / 2).tolist()
    found = set()
    for cut in middles:
        split = best_split(values[:, None], np.where(values <= cut, 1.0, 0.0), TreeLimits(1, 1, 0.0, 1.0, granularity))
        assert split is not None and split.limit in middles
        found.add(split.limit)
    below = {cut: int((values <= cut).sum()) for cut in middles}
    shares = [30 * k / (granularity + 1) for k in range(1, granularity + 1)]
    expected = {next((cut for cut in middles if below[cut] >= share), middles[-1]) for share in shares}
    assert found == (expected if 0 < granularity < len(middles) else set(middles))
    assert granularity == 0 or len(found) <= granularity


def test_a_coarser_tree_is_as_good_as_its_thresholds(plain) -> None:
    domain, bias = plain
    data = Numbers(0, 2)

    def thresholds(granularity: int) -> tuple[set, int]:
        tree = fit(data.examples(), domain, replace(bias, tree=TreeLimits(1, 1, 0.0, 1.0, granularity)))
        assert isinstance(tree, Node)
        bound = tree.tests[0][-1]
        return {bound.args[1]}, round(100 * float((data.columns <= bound.args[1]).mean()))

    coarse, _ = thresholds(1)
    medians = [float(np.sort(column)[79:81].mean()) for column in data.columns.T]
    assert coarse <= set(medians)
    assert thresholds(0)[0] != coarse


def test_thresholds_are_finite_and_numbers_need_not_be(plain) -> None:
    domain, bias = plain
    inf = float("inf")
    values = [-inf] * 4 + [-1e308] * 4 + [1.5e308, 1.7e308] * 2 + [inf] * 4
    for cut in range(4, 16, 4):
        examples = [Example((("obs", 1, x),), "go", float(i < cut)) for i, x in enumerate(values)]
        tree = fit(examples, domain, bias)
        assert isinstance(tree, Node) and abs(tree.literals[-1].args[1]) < inf
        policy = Policy(domain, bias)
        policy.add(tree)
        found = [policy.potentials(each.state, ["go"])[0] for each in examples]
        assert found == [policy.prolog_potentials(each.state, ["go"])[0] for each in examples]
        assert found == [each.value for each in examples]


# ---------------------------------------------------------------- refinements and answers


def test_what_answers_hold_within_is_the_truth(depot) -> None:
    """At the root and down random paths: a test holds exactly where its answer is at most its limit, for thresholds at,
    between and beyond all numbers. Each refinement is more special than its query."""
    domain, bias = depot
    refiner = Refiner(bias)
    table = root_table(domain, bias, refiner)
    assert isinstance(table, TestTable)
    states, actions = pairs(domain, 4, 1)
    coverage, counts = Coverage(table, states, actions), {True: 0, False: 0}
    for seed in range(16):
        random = Random(seed)
        query = random_query(refiner, seed % 4, random)
        holding = np.concatenate(
            [truth([query], bias, *each) for each in zip(states, [[a] for a in actions], strict=True)]
        )
        members = np.flatnonzero(holding[:, 0])
        candidates = refiner.refinements(query)
        answers, _ = coverage.matrix(candidates, members, {})
        for column in random.sample(range(len(candidates)), min(len(candidates), 25)):
            each, own = candidates[column], answers[:, column]
            for limit, test in closed_tests(each, [-3.75, -2.0, -0.1, 0.0, 1.25, 2, 9]):
                literals = each.closed(limit).literals if each.is_open else each.literals
                for i, value in zip(members, own.tolist(), strict=True):
                    by_test, by_query = truth([test, query + literals], bias, states[i], [actions[i]])[0]
                    assert (value <= limit) == by_test == by_query, (query, test)
                    counts[each.is_open] += by_test
                outside = np.flatnonzero(~holding[:, 0])[:3]
                assert not any(truth([query + literals], bias, states[i], [actions[i]]).any() for i in outside)
    assert min(counts.values()) > 100


def test_several_weights_and_none(depot) -> None:
    domain, bias = depot
    refiner = Refiner(bias)
    weights: State = (("limit", 1), ("near", "b", "a"), *(("weight", "a", w) for w in (2, -1.5, 3)))
    lift = (Literal(KIND, (1,)),)
    item, mass = Var(1), Var(3)
    by_name = {each.literals: each for each in refiner.refinements(lift)}
    table = root_table(domain, bias, refiner)
    for name, expected in (("=<", -1.5), (">=", -3.0)):
        test = by_name[(Literal("weight", (item, mass)), Literal(name, (mass, OPEN[name])))].test
        column, _ = table.place(test)
        assert table.answers(weights, [("lift", "a"), ("lift", "b"), "wait"])[:, column].tolist() == [
            expected,
            np.inf,
            np.inf,
        ]


def test_more_measures_of_a_group_than_words_of_another(depot) -> None:
    """More than a thousand tests with two bounds, each of which has a word of its own."""
    domain, bias = depot
    refiner = Refiner(bias)
    table = root_table(domain, bias, refiner)
    states, actions = pairs(domain, 2, 5)
    before = Coverage(table, states, actions).bits
    item, mass = Var(1), Var(3)

    def between(limit: float) -> Query:
        return Literal("weight", (item, mass)), Literal("=<", (mass, 5.0)), Literal(">=", (mass, limit))

    limits = [-3 + i / 200 for i in range(1100)]
    table.add(map(between, limits))
    after = Coverage(table, states, actions).bits
    np.testing.assert_array_equal(after[:, : before.shape[1]], before)
    for limit in limits[::150]:
        column, own = table.place(between(limit))
        expected = [truth([between(limit)], bias, s, [a])[0, 0] for s, a in zip(states, actions, strict=True)]
        assert ((after[:, column] <= own) == expected).all()


# ---------------------------------------------------------------- potentials, rules, models


@pytest.fixture(scope="module")
def policy(depot) -> Policy:
    """Grown trees and random ones."""
    domain, bias = depot
    refiner = Refiner(bias)
    table = root_table(domain, bias, refiner)
    policy = Policy(domain, bias, table)
    states, actions = pairs(domain, 12, 7)
    for seed in range(5):
        targets = np.random.default_rng(seed).normal(size=len(actions))
        coverage = Coverage(table, states, actions)
        policy.add(grow(targets, coverage, refiner, TreeLimits(4, 2, granularity=3 * (seed % 2))), 0.3)
    for seed in range(12):
        policy.add(random_tree(refiner, 4, Random(seed)), 0.7)
    assert sum(each.name in OPEN for tree in policy.trees for rule in rules(tree) for each in rule.query) > 60
    return policy


def test_numbers_clauses_and_saved_clauses_give_the_same_potential(policy: Policy, tmp_path: Path) -> None:
    policy.save(tmp_path / "model.pl")
    again = Policy.load(tmp_path / "model.pl")
    assert again.domain is not policy.domain
    again.save(tmp_path / "again.pl")
    differing = set()
    for state, _ in zip(*pairs(policy.domain, 25, 11), strict=True):
        actions = actions_of(state)
        expected = policy.prolog_potentials(state, actions).tolist()
        assert policy.potentials(state, actions).tolist() == expected
        assert again.potentials(state, actions).tolist() == again.prolog_potentials(state, actions).tolist() == expected
        differing |= set(expected)
    assert len(differing) > 60
    third = Policy.load(tmp_path / "again.pl")
    assert [third.rules(i + 1) for i in range(17)] == [again.rules(i + 1) for i in range(17)]


def test_plain_prolog_reads_the_model(policy: Policy, tmp_path: Path) -> None:
    policy.save(tmp_path / "model.pl")
    states = list(dict.fromkeys(pairs(policy.domain, 5, 12)[0]))
    for state, (action, potential) in zip(states, in_plain_prolog(tmp_path / "model.pl", states), strict=True):
        actions = actions_of(state)
        expected = policy.potentials(state, actions)
        texts = [each if isinstance(each, str) else f"{each[0]}({each[1]})" for each in actions]
        assert expected[texts.index(action)] == expected.max() == pytest.approx(potential, rel=1e-14)


def test_a_list_of_rules_is_the_tree(policy: Policy) -> None:
    states, actions = pairs(policy.domain, 6, 13)
    bias = policy.bias
    for tree in policy.trees[::2]:
        single = Policy(policy.domain, bias)
        single.add(tree)
        ordered = list(rules(tree))
        read = [from_clause(*to_clause(rule, bias)[1:], bias) for rule in ordered]
        for state, action in list(zip(states, actions, strict=True))[::3]:
            (expected,) = single.prolog_potentials(state, [action])
            assert value_of_tree(tree, bias, state, action) == value_of_list(ordered, bias, state, action) == expected
            assert value_of_list(read, bias, state, action) == expected


def test_only_the_tightest_bound_is_written(plain) -> None:
    domain, bias = plain
    policy = Policy(domain, bias)
    data = Numbers(0, 1)
    policy.add(fit(data.examples(), domain, bias))
    texts = policy.rules(1)
    assert all(text.count("=<") <= 1 for text in texts) and texts[0].startswith("delta(1, go, ")
    assert sum(text.count(" :- obs(1, Value), Value =< ") for text in texts) == len(texts) - 1


@pytest.mark.parametrize("limit", [5.25, 1.0, 2.0])
def test_a_bound_of_what_equals_a_constant(depot, tmp_path: Path, limit: float) -> None:
    """go(D) with D = 2 and D =< 5.25 is written as go(2) :- 2 =< 5.25."""
    domain, bias = depot
    distance = Var(0)
    kind, bound, equal = (Literal(KIND, (0,)),), (Literal("=<", (distance, limit)),), (Literal("=", (distance, 2)),)
    tree = Node(kind, (kind,), Node(bound, (bound,), Node(equal, (equal,), Leaf(4.0), Leaf(3.0)), Leaf(2.0)), Leaf(1.0))
    policy = Policy(domain, bias)
    policy.add(tree)
    assert f"2 =< {limit}" in policy.rules(1)[0]
    policy.save(tmp_path / "model.pl")
    again = Policy.load(tmp_path / "model.pl")
    state: State = (("limit", 0),)
    actions = [("go", 2), ("go", 0.5), ("go", 9), ("lift", "a"), "wait"]
    expected = [4.0 if limit >= 2 else 2.0, 3.0, 2.0, 1.0, 1.0]
    for each in (policy, again):
        assert each.potentials(state, actions).tolist() == each.prolog_potentials(state, actions).tolist() == expected


@pytest.mark.parametrize(
    "body",
    [
        "Mass =< 3.0",  # nothing binds it
        "weight(Item, Mass), Other =< 3.0",
        "weight(Item, Mass), Mass =< 1.5NaN",
        "weight(Item, Mass), Mass =< 1.0Inf",
        "weight(Item, Mass), Mass =< inf",
        'weight(Item, Mass), Mass =< "3"',
        "weight(Item, Mass), Mass =< true",
        "weight(Item, Mass), Mass =< Item",
        "weight(Item, Mass), Mass =< _",
        "weight(Item, Mass), Mass =< 1 + 2",
        "weight(Item, Mass), Mass =< 9007199254740993",  # no float
        f"weight(Item, Mass), Mass =< {10**400}",
        "weight(Item, Mass), '=<'(Mass)",
        "weight(Item, Mass), '=<'(Mass, 2, 3)",
        "weight(Item, Mass), Mass < 3",
        "weight(Item, Mass), 1.5NaN =< 3",
        "weight(Item, Mass), red =< 3",
        "weight(Item, Mass), shell(ls) =< 3",
        "weight(Item, Mass), =<",
    ],
)
def test_a_model_with_a_hostile_bound_is_refused(depot, tmp_path: Path, body: str) -> None:
    domain, bias = depot
    policy = Policy(domain, bias)
    policy.add(Leaf(1.0))
    policy.save(tmp_path / "model.pl")
    text = (tmp_path / "model.pl").read_text()
    good = "weight(Item, Mass), Mass =< 3, Mass >= -1.5"
    for own, accepted in ((good, True), (body, False)):
        rule = f"delta(1, lift(Item), 2.0) :- {own}, !.\n"
        place = text.index("delta(1")
        resigned(tmp_path / "model.pl", text[:place] + rule + text[place:])
        line = text[:place].count("\n") + 1
        if accepted:
            found = Policy.load(tmp_path / "model.pl")
            state: State = (("limit", 0), ("weight", "a", 3), ("weight", "b", 3.5), ("weight", "c", -2))
            assert found.potentials(state, actions_of(state)).tolist() == [2.0, 1.0, 1.0, 1.0]
            continue
        with pytest.raises(NppgError) as caught:
            Policy.load(tmp_path / "model.pl")
        (problem,) = caught.value.problems
        assert (problem.file, problem.line) == (str(tmp_path / "model.pl"), line) and "\n" not in problem.message


# ---------------------------------------------------------------- training


def test_seeds_are_bit_identical_in_two_processes(depot) -> None:
    code = """
import sys
from nppg.worlds.domain import Domain
from nppg.bias.language_bias import LanguageBias
from nppg.learning.options import Options
from nppg.learning.training import train
for step in ("gradient", "second-order"):
    options = Options(episodes=40, min_examples=60, seed=3, step=step)
    for iteration in train(Domain(sys.argv[1]), LanguageBias.load(sys.argv[2]), options):
        pass
    policy = iteration.policy
    for i in range(len(policy.trees)):
        print("\\n".join(policy.rules(i + 1)))
"""
    domain, bias = depot
    printed = {
        subprocess.run(
            [sys.executable, "-c", code, str(domain.path), bias.file],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(sys.path)},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    (text,) = printed
    assert text.count("=<") > 5


@pytest.mark.parametrize("options", [TGOptions(), RIBOptions(), TrendiOptions()], ids=lambda each: each.learner)
def test_value_functions_refuse_thresholds(depot, options) -> None:
    domain, bias = depot
    with pytest.raises(NppgError) as caught:
        regressor(domain, bias, options)
    (problem,) = caught.value.problems
    assert (problem.file, problem.line) == (bias.file, 11) and f"the learner {options.learner} " in problem.message


CHAIN = """
:- module(line, []).
:- fluent pos/1.
:- uniform_start.
start([pos(X)]) :- random_between(1, 8, X).
action(left).
action(right).
effect(left, [pos(X)], [pos(Y)])  :- pos(X), Y is max(0, X - 1).
effect(right, [pos(X)], [pos(Y)]) :- pos(X), Y is min(9, X + 2).
goal :- pos(X), ( X =:= 0 ; X =:= 9 ).
horizon(N) :- pos(X), N is min(X, (10 - X) // 2).
"""
FLIP = """
:- module(flip, []).
:- fluent pos/1, done/0.
:- interchangeable disk/1.
:- uniform_start.
disk(1).
disk(2).
start([pos(X)]) :- random_between(1, 2, X).
action(left).
action(right).
effect(left, [pos(X)], [pos(Y)]) :- pos(X), Y is 3 - X.
effect(right, [], [done]).
goal :- done.
horizon(3).
"""
CHAIN_BIAS = """
action: [left, right]
types: {pos: [position]}
modes: [{literal: pos(-position), lookahead: 1}, "+position =< #"]
lookahead: 1
"""


def chain_policy(domain: Domain, bias: LanguageBias, middle: float) -> Policy:
    """Goes left up to `middle`."""
    left, position = (Literal(KIND, (0,)),), Var(0)
    near: Query = (Literal("pos", (position,)), Literal("=<", (position, middle)))
    tree = Node(left, (left,), Node(near, (near,), Leaf(1.0), Leaf(-1.0)), Leaf(0.0))
    policy = Policy(domain, bias)
    policy.add(tree)
    return policy


@pytest.mark.parametrize(("middle", "success"), [(2.5, 1.0), (1.5, 7 / 8), (-1.0, 6 / 8), (6.0, 5 / 8)])
def test_exact_evaluation(tmp_path: Path, middle: float, success: float) -> None:
    domain, bias = loaded(tmp_path, "line", CHAIN, CHAIN_BIAS)
    policy = chain_policy(domain, bias, middle)
    assert evaluate_exactly(policy, greedy=True).success == pytest.approx(success)
    policy.save(tmp_path / "model.pl")
    assert evaluate_exactly(Policy.load(tmp_path / "model.pl"), greedy=True).success == pytest.approx(success)


def test_numbers_that_are_interchangeable_are_not_compared(tmp_path: Path) -> None:
    domain, bias = loaded(tmp_path, "flip", FLIP, CHAIN_BIAS)
    with pytest.raises(NppgError, match=r"compares numbers, and .*flip\.pl declares numbers interchangeable"):
        evaluate_exactly(chain_policy(domain, bias, 1.5))


def test_what_rules_say(tmp_path: Path) -> None:
    """Distilled, explained and drawn."""
    domain, bias = loaded(tmp_path, "line", CHAIN, CHAIN_BIAS + 'sentences: {pos: "it is at {1}", left: "go left"}\n')
    *_, last = train(domain, bias, Options(episodes=60, min_examples=60, seed=1))
    learned = last.policy
    few = distill(learned, bias)
    assert evaluate_exactly(few, greedy=True).success >= evaluate_exactly(learned, greedy=True).success > 0.7
    assert "=<" in "".join(few.rules(1)) and len(few.rules(1)) <= 10
    lines = explained(chain_policy(domain, bias, 4.5), 1, bias)
    assert lines[0] == "% First choice: go left, if it is at some Position and Position =< 4.5."
    assert lines[1] == "delta(1, left, 1.0) :- pos(Position), Position =< 4.5, !."
    text = dot(chain_policy(domain, bias, 4.5).trees[0], bias)
    assert '[shape=box, label="pos(A), A =< 4.5"]' in text


# ---------------------------------------------------------------- what is no number


@pytest.mark.parametrize(
    ("odd", "goal", "problem"),
    [
        ("heavy", "", "measured/2 gave heavy, which is compared with a threshold and is no number, in the state"),
        ("e", "", "measured/2 gave e, which is compared"),
        ("none", "limit(big)", "limit/1 gave big, which is compared"),
    ],
)
def test_what_is_no_number_is_told_with_its_predicate(tmp_path: Path, odd: str, goal: str, problem: str) -> None:
    """Also where it is not the first answer; asked at the root, and at a node below."""
    bias_text = DEPOT_BIAS.replace("weight", "measured")
    domain, bias = loaded(tmp_path, "depot", DEPOT, bias_text, odd=odd)
    state: State = tuple(sorted([("red", "a"), ("weight", "a", 1), ("limit", 1)]))
    if goal:
        state = (("limit", "big"),)
    refiner = Refiner(bias)
    with pytest.raises(NppgError) as caught:
        root_table(domain, bias, refiner).answers(state, actions_of(state))
    (found,) = caught.value.problems
    mode = bias.file, bias_text.splitlines().index('  - "+mass =< #"') + 1, 6
    assert problem in found.message and "\n" not in found.message
    assert (found.file, found.line, found.column) == mode
    if not goal:
        line = DEPOT.splitlines().index("measured(X, W) :- weight(X, W).") + 1
        place = f"+mass =< # compares what is no number: {domain.path}:{line}: "
        assert found.message.startswith(place)
        bias = LanguageBias.parse(
            bias_text.replace(", lookahead: 1}", "}").replace("lookahead: 2", "lookahead: 0"), "b"
        )
        refiner = Refiner(bias)
        coverage = Coverage(root_table(domain, bias, refiner), [state], [("lift", "a")])
        query: Query = (Literal(KIND, (1,)), Literal("measured", (Var(1), Var(3))))
        bounds = [each for each in refiner.refinements(query) if each.is_open]
        with pytest.raises(NppgError) as caught:
            coverage.matrix(bounds, np.arange(1), {})
        (found,) = caught.value.problems
        assert found.message.startswith(place + problem.removesuffix(", in the state"))
        assert (found.file, *mode[1:]) == ("b", found.line, found.column)


def test_what_never_ends_is_not_told_as_no_number(tmp_path: Path) -> None:
    """A bound asks for all answers, of which there is no end, where the literal alone asks for one."""
    endless = DEPOT.replace("measured(X, W) :- weight(X, W).", "measured(X, W) :- weight(X, W), repeat.")
    domain, bias = loaded(tmp_path, "depot", endless, DEPOT_BIAS.replace("weight", "measured"))
    state: State = tuple(sorted([("red", "a"), ("weight", "a", 1), ("limit", 1)]))
    with pytest.raises(NppgError, match="measured/2 took more than") as caught:
        root_table(domain, bias, Refiner(bias)).answers(state, actions_of(state))
    assert caught.value.problems[0].file == str(domain.path)


def test_an_argument_that_is_no_number(depot) -> None:
    domain, bias = depot
    table = root_table(domain, bias, Refiner(bias))
    with pytest.raises(NppgError) as caught:
        table.answers((("limit", 1),), [("go", "far")])
    (found,) = caught.value.problems
    line = DEPOT.splitlines().index("action(lift(X)) :- member(X, [a, b, c]).") + 1
    place = bias.file, DEPOT_BIAS.splitlines().index('  - "+distance =< #"') + 1, 6
    assert (found.file, found.line, found.column) == place
    assert found.message.startswith(
        f"+distance =< # compares what is no number: {domain.path}:{line}: action/1 gave far"
    )


def test_numbers_that_prolog_and_python_round(depot) -> None:
    """Integers that are no floats, and what lies beyond them, are compared as Prolog compares them."""
    domain, bias = depot
    kind, far = (Literal(KIND, (0,)),), 2.0**53
    for name in ("=<", ">="):
        for limit in (far, -far, 1e300):
            bound = (Literal(name, (Var(0), limit)),)
            policy = Policy(domain, bias)
            policy.add(Node(kind, (kind,), Node(bound, (bound,), Leaf(2.0), Leaf(1.0)), Leaf(0.0)))
            numbers = [2**53 + 1, -(2**53) - 1, 2**53 - 1, 10**299, 10**301, 10**400, -(10**400), float("inf")]
            actions: list[Action] = [("go", each) for each in numbers]
            found = policy.potentials((("limit", 0),), actions).tolist()
            assert found == policy.prolog_potentials((("limit", 0),), actions).tolist()
            assert set(found) == {1.0, 2.0}


def test_a_table_of_facts_takes_part(plain, depot) -> None:
    """The tests above look at both kinds of tables."""
    assert isinstance(root_table(*plain, Refiner(plain[1])), FactTable)
    assert isinstance(root_table(*depot, Refiner(depot[1])), TestTable)
