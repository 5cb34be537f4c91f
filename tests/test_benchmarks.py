"""The benchmarks measure what they say: the floor learns, the data set is the one described."""

from pathlib import Path

import numpy as np
import pytest

from benchmarks import floor, one_tree
from benchmarks.__main__ import line
from benchmarks.common import Row, splice
from nppg import Domain, LanguageBias
from nppg.trees.tilde import fit


def test_the_floor_knows_the_world() -> None:
    world = floor.tables(10)
    assert len(world.weights) == 2084
    assert world.weights.sum() == 58_941_091
    assert world.weights[world.starts].sum() == 54_344_538
    assert floor.success(world, np.zeros(len(world.state))) == pytest.approx(0.013098, abs=5e-7)


def test_the_floor_learns() -> None:
    world = floor.tables(4)
    before = floor.success(world, np.zeros(len(world.state)))
    potential, trees = floor.train(world, episodes=800, min_examples=20)
    assert trees > 100
    assert before < 0.1 and floor.success(world, potential) > 0.9


def test_second_order_steps_of_the_floor_learn_from_fewer_episodes() -> None:
    world = floor.tables(4)
    potential, trees = floor.train(world, episodes=200, min_examples=20, second_order=True)
    assert trees > 50
    assert floor.success(world, potential) > 0.95


def test_the_data_set_tells_optimal_moves_by_its_targets() -> None:
    domain = Domain("blocks_world")
    rng = np.random.default_rng(1)
    examples = one_tree.data_set(domain, 200, rng)
    good = 0
    for state, action, value in examples:
        assert not any(("on", *fact[1:]) in state for fact in state if fact[0] == "goal_on")
        assert action in domain.situation(state).actions
        moves = domain.horizon(state)
        optimal = domain.horizon(domain.act(state, action, rng)[1]) == moves - 1
        assert abs(value - (1 if optimal else -1)) < 0.6
        good += optimal
    assert 100 < good < 180  # half of the moves, and those of the others that are optimal by chance


def test_predictions_are_those_of_the_tree() -> None:
    domain = Domain("blocks_world", {"blocks": 5})
    bias = LanguageBias.load(Path(one_tree.__file__).with_name("one_tree.yaml"))
    examples = one_tree.data_set(domain, 150, np.random.default_rng(2))
    tree = fit(examples, domain, bias)
    predicted = one_tree.predictions(tree, domain, bias, examples)
    assert one_tree.rmse(predicted, examples) < 0.8 * np.std([each.value for each in examples])
    assert predicted.mean() == pytest.approx(np.mean([each.value for each in examples]))


def test_the_table_is_put_between_its_markers(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("above\n<!-- table -->\nold\n<!-- /table -->\nbelow\n")
    splice(page, "table", line(Row("a", "1 s", "", "<= 2 s", True)))
    assert page.read_text() == "above\n<!-- table -->\n| a | 1 s |  | <= 2 s | yes |\n<!-- /table -->\nbelow\n"
