"""RIB and TRENDI in one: instances go where their tests lead, leaves split on what they hold, files give them back."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from samples import resigned, some_blocks, visited

from nppg import Domain, train
from nppg.answers.coverage import Coverage
from nppg.bias.declarations import TreeLimits
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.policy.policy import Policy
from nppg.rrl.instance_tree import InstanceTree
from nppg.rrl.options import InstanceOptions, RIBOptions, TrendiOptions
from nppg.rrl.qfunction import Example, QFunction
from nppg.trees.tilde import best_split
from nppg.trees.tree import leaves

FOUR = TrendiOptions(episodes=250, min_sample=40, min_instances=10, max_instances=60, significance=0.2)


@pytest.fixture(scope="module", params=["trendi", "rib", "delivery"])
def learned(request: pytest.FixtureRequest) -> QFunction:
    if request.param == "delivery":
        domain, bias = (request.getfixturevalue(name) for name in ("delivery", "delivery_bias"))
    else:
        domain, bias = Domain("blocks_world", {"blocks": 4}), request.getfixturevalue("plain_bias")
    options = RIBOptions(episodes=250) if request.param == "rib" else FOUR
    *_, last = train(domain, bias, options)
    return last.policy


def regressor(policy: QFunction) -> InstanceTree:
    assert isinstance(policy.regressor, InstanceTree)
    return policy.regressor


def test_instances_are_where_their_tests_lead(learned: QFunction) -> None:
    tree = regressor(learned)
    assert len(tree.tree) == len(tree.leaves) == (learned.sizes().get("leaves", 1))
    assert len(tree.tree) > 2 or tree.growth is None
    for number, leaf in enumerate(tree.leaves):
        for pair, value, state, action in leaf.examples():
            (description,) = tree.describe(state, [action])
            assert description[-1] == pair
            assert tree._leaves_of(description[None]).tolist() == [number]
            assert tree.predict(description[None])[0] == value


def test_a_leaf_splits_on_what_it_holds(plain_bias) -> None:
    """The first split is TILDE's of the instances, with the F-test."""
    domain = Domain("blocks_world", {"blocks": 5})
    (first, *_) = train(domain, plain_bias, TrendiOptions(episodes=1, min_sample=60, min_instances=10))
    tree, rng = regressor(first.policy), np.random.default_rng(0)
    held: list[Example] = []
    while len(tree.tree) == 1 and len(held) < 600:
        state = domain.start(rng)
        actions = domain.situation(state).actions
        descriptions = tree.describe(state, actions)
        batch = [
            Example(state, action, description, float(("on", *action[1:]) in state or action[2] == "floor"))
            for action, description in zip(actions, descriptions, strict=True)
        ]
        before = tree.leaves[0].seen + len(batch) >= 60
        tree.update(batch)
        held += batch
        if before and len(tree.tree) == 2:
            kept = [each for leaf in tree.leaves for each in leaf.examples()]
            coverage = Coverage(tree.table, [each[2] for each in kept], [each[3] for each in kept])
            candidates = tree.tree.refiner.refinements(())
            answers, _ = coverage.matrix(candidates, np.arange(len(kept)), {})
            values = np.array([each[1] for each in kept])
            best = best_split(answers, values, TreeLimits(min_examples=1, significance=0.001))
            assert best is not None and tree.tree.queries[1] == candidates[best.candidate].literals
    assert len(tree.tree) == 2


def test_saved_and_loaded_predict_equally(learned: QFunction, tmp_path: Path) -> None:
    learned.save(tmp_path / "model.pl")
    loaded = Policy.load(tmp_path / "model.pl")
    assert isinstance(loaded, QFunction) and loaded.sizes() == learned.sizes()
    assert sum(map(leaves, loaded.trees)) == len(regressor(learned).tree)
    rng = np.random.default_rng(5)
    for _ in range(60):
        state = learned.domain.start(rng)
        actions = learned.domain.situation(state).actions
        np.testing.assert_allclose(
            loaded.potentials(state, actions), learned.potentials(state, actions), rtol=1e-12, atol=1e-14
        )
    loaded.save(tmp_path / "again.pl")
    assert (tmp_path / "again.pl").read_text() == (tmp_path / "model.pl").read_text()


SOME = {"episodes": 150, "guidance": 0.3, "seed": 1}


@pytest.mark.parametrize(
    "options",
    [RIBOptions(**SOME), RIBOptions(power=3.0, **SOME), TrendiOptions(min_sample=50, min_instances=8, **SOME)],
)
def test_where_the_objects_vary_from_start_to_start(options: InstanceOptions, tmp_path: Path, plain_bias) -> None:
    """Neither a model file nor another run of the same domain object changes what is predicted."""
    domain = some_blocks(tmp_path, 7, 2, 5)
    *_, last = train(domain, plain_bias, options)
    last.policy.save(tmp_path / "model.pl")
    loaded = Policy.load(tmp_path / "model.pl")
    *_, again = train(domain, plain_bias, options)
    assert again.policy.sizes() == last.policy.sizes()
    states = visited(domain, 100, seed=9)
    for state in states:
        actions = domain.situation(state).actions
        expected = last.policy.potentials(state, actions)
        np.testing.assert_allclose(loaded.potentials(state, actions), expected, rtol=1e-12, atol=1e-14)
        assert again.policy.potentials(state, actions).tolist() == expected.tolist()
    other = Domain(domain.path, domain.parameters)
    *_, fresh = train(other, plain_bias, options)
    assert [fresh.policy.potentials(s, other.situation(s).actions).tolist() for s in states] == [
        last.policy.potentials(s, domain.situation(s).actions).tolist() for s in states
    ]


@pytest.mark.parametrize(
    "wrong",
    [
        "instance(9999, move(b1, floor), 0.5, state(on(b1, b2)))",
        "instance(1, fly(b1, floor), 0.5, state(on(b1, b2)))",
        "instance(1, move(b1, floor), high, state(on(b1, b2)))",
        "instance(1, move(b1, floor), 0.5, state(under(b1, b2)))",
        "instance(1, move(b1, floor), 0.5)",
    ],
)
def test_what_is_no_instance_is_refused(wrong: str, tmp_path: Path, plain_bias, capsys) -> None:
    *_, last = train(Domain("blocks_world", {"blocks": 4}), plain_bias, RIBOptions(episodes=30))
    model = tmp_path / "model.pl"
    last.policy.save(model)
    text = model.read_text()
    resigned(model, text.replace("model(trees, 1).", f"model(instance, {wrong}).\nmodel(trees, 1)."))
    with pytest.raises(NppgError, match="this is no instance of the model's domain"):
        Policy.load(model)
    assert main(["evaluate", str(model)]) == 2
    assert capsys.readouterr().err.count("\n") == 1
