"""TG: its statistics, its splits against batch TILDE, its tree in a model file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from samples import pairs, visited

from nppg.answers.coverage import Coverage, root_table
from nppg.bias.declarations import TreeLimits
from nppg.policy.policy import Policy
from nppg.rrl.options import TGOptions
from nppg.rrl.qfunction import Example, QFunction
from nppg.rrl.tg import TG
from nppg.trees.tilde import best_split, grow
from nppg.trees.tree import rules


def stream(domain, table, count: int, seed: int) -> list[Example]:
    """Pairs in random order, with targets that depend on a few tests, and noise."""
    rng = np.random.default_rng(seed)
    states, actions = pairs(domain, visited(domain, count, seed))
    answers = Coverage(table, states, actions).bits
    weights = rng.normal(size=answers.shape[1]) * (rng.random(answers.shape[1]) < 0.2)
    values = answers @ weights + rng.normal(scale=0.3, size=len(states))
    order = rng.permutation(len(states))
    return [Example(states[i], actions[i], answers[i], float(values[i])) for i in order]


def tree_of(learner: TG) -> list[tuple]:
    return [(rule.query, round(rule.value, 9)) for rule in rules(learner.stored()[0].trees[0])]


def test_repeated_data_grow_the_batch_tree(setting) -> None:
    """Where all data come in one update, a pass over them splits every leaf as TILDE splits the node."""
    domain, _, refiner, table = setting
    examples = stream(domain, table, 40, 3)
    learner = TG(table, refiner, TGOptions(min_sample=8, significance=1.0, max_depth=3))
    for _ in range(4):
        # a new test may have come with the last pass, so the descriptions are asked for anew
        learner.update([each._replace(description=table.answers(each.state, [each.action])[0]) for each in examples])
    coverage = Coverage(table, [each.state for each in examples], [each.action for each in examples])
    limits = TreeLimits(max_depth=3, min_examples=1, min_variance=0.0, significance=1.0)
    targets = np.array([each.value for each in examples])
    batch = grow(targets, coverage, refiner, limits)
    small = {rule.query for rule in rules(batch)} - {query for query, _ in tree_of(learner)}
    if not small:  # every node had as many examples as TG asks for
        assert tree_of(learner) == [(rule.query, round(rule.value, 9)) for rule in rules(batch)]
    assert tree_of(learner)[0][0][: len(batch.literals)] == batch.literals


@pytest.mark.parametrize("k", [-40, 40])
def test_the_tree_does_not_hang_on_the_unit_of_the_values(setting, k: int) -> None:
    domain, bias, refiner, table = setting
    examples = stream(domain, table, 60, 3)
    found = []
    for unit in (1.0, 2.0**k):
        learner = TG(root_table(domain, bias, refiner), refiner, TGOptions(min_sample=20, significance=0.1))
        for each in examples:
            description = learner.table.answers(each.state, [each.action])[0]
            learner.update([each._replace(description=description, value=unit * each.value)])
        found.append([(rule.query, rule.value / unit) for rule in rules(learner.stored()[0].trees[0])])
    assert found[0] == found[1] and len(found[0]) > 1


def test_a_gain_is_small_beside_all_that_was_met(setting) -> None:
    """Differences of a billionth in a task whose values go up to 1 split no leaf, and those of a task of billionths
    do."""
    domain, bias, refiner, table = setting
    examples = stream(domain, table, 60, 3)
    grown = []
    for first in (1.0, 1e-9):
        learner = TG(root_table(domain, bias, refiner), refiner, TGOptions(min_sample=40, significance=1.0))
        for i, each in enumerate(examples):
            description = learner.table.answers(each.state, [each.action])[0]
            learner.update([each._replace(description=description, value=1e-9 * each.value if i else first)])
            if i == 0:  # what the leaf has seen of it is forgotten
                learner.statistics[0] = learner._statistics(0, np.zeros(3))
        grown.append(len(learner.tree))
    assert grown[0] == 1 < grown[1]


class PlainTG:
    """Keeps every example, and recomputes all from them."""

    def __init__(self, table, refiner, options: TGOptions):
        self.table, self.refiner, self.options = table, refiner, options
        self.queries = [()]
        self.own: list[list[Example]] = [[]]
        self.inherited: list[list[Example]] = [[]]

    def matrix(self, leaf: int, members: list[Example]) -> np.ndarray:
        candidates = self.refiner.refinements(self.queries[leaf])
        coverage = Coverage(self.table, [each.state for each in members], [each.action for each in members])
        return coverage.matrix(candidates, np.arange(len(members)), {})[0]

    def update(self, leaves: list[int], examples: list[Example]) -> None:
        for leaf, example in zip(leaves, examples, strict=True):
            self.own[leaf].append(example)
        for leaf in dict.fromkeys(leaves):
            members = self.own[leaf]
            if len(members) < self.options.min_sample or len(self.queries[leaf]) >= self.options.max_depth:
                continue
            answers = self.matrix(leaf, members)
            limits = TreeLimits(min_examples=1, significance=self.options.significance)
            best = best_split(answers, np.array([each.value for each in members]), limits)
            if best is not None:
                chosen = self.refiner.refinements(self.queries[leaf])[best.candidate]
                passed = [each for each, holds in zip(members, best.covered(answers), strict=True) if holds]
                failed = [each for each, holds in zip(members, best.covered(answers), strict=True) if not holds]
                self.queries.append(self.queries[leaf] + chosen.literals)
                self.inherited[leaf], self.own[leaf] = failed, []
                self.inherited.append(passed)
                self.own.append([])


def test_a_long_stream_leaves_exact_statistics(blocks, plain_bias) -> None:
    from nppg.bias.refinement import Refiner

    refiner = Refiner(plain_bias)
    table = root_table(blocks, plain_bias, refiner)
    options = TGOptions(min_sample=60, significance=0.05, max_depth=30)
    learner, plain = TG(table, refiner, options), PlainTG(table, refiner, options)
    examples = stream(blocks, table, 250, 5)
    sizes = np.random.default_rng(0).integers(1, 9, len(examples))
    while examples:
        batch, examples = examples[: sizes[len(examples) - 1]], examples[sizes[len(examples) - 1] :]
        leaves = learner.tree.leaf_of(np.stack([each.description for each in batch])).tolist()
        learner.update(batch)
        plain.update(leaves, batch)
    assert len(learner.tree) > 5 and learner.tree.queries == plain.queries
    for leaf, statistics in enumerate(learner.statistics):
        seen = [each.value for each in plain.inherited[leaf] + plain.own[leaf]]
        np.testing.assert_allclose(statistics.whole, [len(seen), sum(seen), sum(v**2 for v in seen)], rtol=1e-9)
        if not plain.own[leaf]:
            assert not statistics.by_test.any()
            continue
        answers = plain.matrix(leaf, plain.own[leaf])
        values = np.array([each.value for each in plain.own[leaf]])
        for outcome in (0, 1):
            holds = answers == outcome
            expected = [holds.sum(axis=0), values @ holds, values**2 @ holds]
            np.testing.assert_allclose(statistics.by_test[outcome], expected, rtol=1e-9, atol=1e-9)


def test_a_leaf_waits_for_its_sample_and_for_significance(four_blocks, plain_bias, setting) -> None:
    domain, _, refiner, table = setting
    examples = stream(domain, table, 30, 1)
    for options in (TGOptions(min_sample=len(examples) + 1), TGOptions(min_sample=3, max_depth=0)):
        learner = TG(table, refiner, options)
        learner.update(examples)
        assert learner.sizes() == {"trees": 1, "leaves": 1}
        mean = np.mean([each.value for each in examples])
        assert learner.predict(examples[0].description[None])[0] == pytest.approx(mean)
    noise = np.random.default_rng(2).normal(size=len(examples))
    learner = TG(table, refiner, TGOptions(min_sample=3, significance=1e-6))
    learner.update([each._replace(value=float(value)) for each, value in zip(examples, noise, strict=True)])
    assert learner.sizes()["leaves"] == 1


def test_saved_and_loaded_trees_predict_equally(setting, tmp_path: Path) -> None:
    domain, _, refiner, table = setting
    examples = stream(domain, table, 40, 7)
    options = TGOptions(min_sample=20, significance=1.0)
    policy = QFunction(TG(table, refiner, options), options)
    for i in range(0, len(examples), 10):
        batch = examples[i : i + 10]
        policy.regressor.update(
            [each._replace(description=table.answers(each.state, [each.action])[0]) for each in batch]
        )
    assert policy.sizes()["leaves"] > 2
    policy.save(tmp_path / "model.pl")
    loaded = Policy.load(tmp_path / "model.pl")
    assert loaded.greedy
    for state in visited(domain, 20, 9):
        actions = domain.situation(state).actions
        assert (loaded.potentials(state, actions) == policy.potentials(state, actions)).all()
        assert (loaded.prolog_potentials(state, actions) == policy.potentials(state, actions)).all()
