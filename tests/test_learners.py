"""What holds of every learner behind the one door: its runs, its model files, its options."""

from __future__ import annotations

import csv
from dataclasses import fields
from pathlib import Path

import pytest

from nppg import Domain, evaluate, evaluate_exactly, train
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.experiments.learners import LEARNERS
from nppg.policy.policy import Policy

every_learner = pytest.mark.parametrize("learner", LEARNERS)


@every_learner
def test_one_door(tmp_path: Path, learner: str, capsys: pytest.CaptureFixture) -> None:
    arguments = f"train blocks_world --set blocks=4 --learner {learner} --episodes 120 --seed 2 --output".split()
    assert main([*arguments, str(tmp_path / "a")]) == 0
    assert main([*arguments, str(tmp_path / "b"), "--quiet"]) == 0
    assert (tmp_path / "a" / "model.pl").read_bytes() == (tmp_path / "b" / "model.pl").read_bytes()
    rows = list(csv.DictReader((tmp_path / "a" / "curve.csv").open()))
    assert (rows[0]["episode"], rows[-1]["episode"]) == ("0", "120")
    assert float(rows[-1]["leaves"]) + float(rows[-1]["instances"]) >= 1
    model = str(tmp_path / "a" / "model.pl")
    loaded = Policy.load(model)
    assert evaluate_exactly(loaded).success == pytest.approx(float(rows[-1]["success"]), rel=1e-12)
    capsys.readouterr()
    for command in (["evaluate", model, "--exact"], ["play", model], ["show", model], ["prove", model]):
        assert main(command) == 0
    how = "greedy" if loaded.greedy else "stochastic"
    assert f"success of the {how} policy over all 60 start states" in capsys.readouterr().out


@every_learner
def test_it_yields_before_it_learns_and_after_the_last_episode(delivery: Domain, delivery_bias, learner: str) -> None:
    """With every episode once, and of several kinds of actions."""
    episodes = 600 if learner == "tg" else 200  # its leaves wait for more examples before they split
    iterations = list(train(delivery, delivery_bias, LEARNERS[learner](episodes=episodes, seed=3)))
    assert iterations[0].episodes == 0 and not iterations[0].recent
    played = 0
    for each in iterations:
        played += len(each.recent)
        assert each.episodes == played
    assert played == episodes
    assert evaluate(iterations[-1].policy, 50).success > 0


@every_learner
def test_options_have_bounds(learner: str) -> None:
    for field in fields(LEARNERS[learner]):
        with pytest.raises(NppgError, match=field.name):
            LEARNERS[learner](**{field.name: 7 if field.metadata.get("text") else "neither"})
