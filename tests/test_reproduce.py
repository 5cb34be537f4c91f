"""nppg reproduce: runs that are done once, samples that agree with the exact numbers, files that say what they are."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from nppg.cli.main import main
from nppg.experiments.paper import EXPERIMENTS
from nppg.experiments.reproduce import jobs_of
from nppg.judging.evaluation import ExactEvaluator
from nppg.judging.space import Space
from nppg.policy.policy import Policy
from nppg.trees.tree import Leaf

SMALL = ["--runs", "2", "--episodes", "100", "--set", "blocks=3", "--jobs", "2", "--output"]


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("reproduce")
    assert main(["reproduce", "figure1", *SMALL, str(folder)]) == 0
    return folder


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def test_a_figure_is_the_mean_of_its_runs(done: Path) -> None:
    found = rows(done / "figure1.csv")
    assert [(row["learner"], row["episode"]) for row in found] == [
        (learner, episode) for learner in ("nppg", "tg", "rib", "trendi") for episode in ("0", "50", "100")
    ]
    for row in found:
        ends = [rows(done / "runs" / f"{row['learner']}-{seed}" / "curve.csv") for seed in (0, 1)]
        success = [
            next(float(p["success"]) for p in end if int(p["episode"]) // 50 * 50 == int(row["episode"]))
            for end in ends
        ]
        assert float(row["exact_mean"]) == pytest.approx(np.mean(success), abs=1e-6)
        assert float(row["exact_sd"]) == pytest.approx(np.std(success), abs=1e-6)
        assert abs(float(row["sampled_mean"]) - float(row["exact_mean"])) < 0.06
    report = (done / "figure1.md").read_text()
    assert "reproduce figure1 --runs 2 --episodes 100 --set blocks=3" in report and "| RRL-TRENDI |" in report
    assert (done / "figure1.png").stat().st_size > 10_000


def test_finished_runs_are_not_done_again(done: Path, capsys: pytest.CaptureFixture) -> None:
    before = {path: path.stat().st_mtime_ns for path in done.glob("runs/*/model.pl")}
    assert len(before) == 8
    (done / "runs" / "tg-1" / "run.json").write_text("{")  # cut off
    assert main(["reproduce", "figure1", *SMALL, str(done)]) == 0
    changed = [path.parent.name for path in before if path.stat().st_mtime_ns != before[path]]
    assert changed == ["tg-1"]
    lines = capsys.readouterr().out.splitlines()
    assert sum(line.endswith("done before") for line in lines) == 7 and "8 of 8: tg-1, success" in lines[7]


def test_other_settings_are_other_runs(done: Path) -> None:
    experiment = EXPERIMENTS["figure1"]
    assert all(job.is_finished() for job in jobs_of(experiment, 2, 100, {"blocks": 3}, done))
    for episodes, parameters in ((200, {"blocks": 3}), (100, {"blocks": 5}), (100, {})):
        assert not any(job.is_finished() for job in jobs_of(experiment, 2, episodes, parameters, done))
    assert not jobs_of(experiment, 3, 100, {"blocks": 3}, done)[2].is_finished()


def test_figure2_takes_the_runs_that_are_there(done: Path, capsys: pytest.CaptureFixture) -> None:
    assert main(["reproduce", "figure2", *SMALL, str(done)]) == 0
    assert capsys.readouterr().out.count("done before") == 2
    found = rows(done / "figure2.csv")
    space = Space(Policy.load(done / "runs" / "nppg-0" / "model.pl").domain)
    for episode in ("0", "50", "100"):
        own = [row for row in found if row["episode"] == episode]
        assert [int(row["length"]) for row in own] == list(space.lengths())
        shares = [float(row["share"]) for row in own]
        assert shares == pytest.approx([number / space.starts for number in space.lengths().values()], abs=1e-6)
    last = [row for row in found if row["episode"] == "100"]
    whole = sum(float(row["share"]) * float(row["exact_mean"]) for row in last)
    figure1 = next(row for row in rows(done / "figure1.csv") if (row["learner"], row["episode"]) == ("nppg", "100"))
    assert whole == pytest.approx(float(figure1["exact_mean"]), abs=1e-4)


def test_samples_follow_the_exact_distribution(four_blocks, plain_bias) -> None:
    """Per class of starts, of a policy that is neither uniform nor sure."""
    policy = Policy(four_blocks, plain_bias)
    policy.add(Leaf(0.0))
    judge = ExactEvaluator(policy)
    exact, _ = judge.by_class()
    rng = np.random.default_rng(0)
    for number in np.flatnonzero(judge.space.running)[::4]:
        share = judge.sample(np.full(4000, number), rng).mean()
        assert abs(share - exact[number]) < 5 * np.sqrt(0.25 / 4000)
    starts = judge.space.draw(20_000, rng)
    counts = np.bincount(starts, minlength=len(judge.space.sizes)) / len(starts)
    expected = np.array(judge.space.sizes) * judge.space.running / judge.space.starts
    assert np.abs(counts - expected).max() < 0.02


def test_mistakes_are_told_in_one_line(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    for arguments, message in (
        (["--runs", "0"], "runs must be at least 1, not 0"),
        (["--jobs", "0"], "jobs must be at least 1, not 0"),
        (["--episodes", "-1"], "episodes must be at least 0, not -1"),
        (["--set", "block=3"], "there is no parameter block; the domain has"),
    ):
        assert main(["reproduce", "figure2", *arguments, "--output", str(tmp_path)]) == 2
        error = capsys.readouterr().err
        assert message in error and error.count("\n") == 1


def test_output_into_a_file(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    (tmp_path / "file").write_text("")
    assert main(["reproduce", "figure2", "--runs", "1", "--set", "blocks=3", "--output", str(tmp_path / "file")]) == 2
    error = capsys.readouterr().err
    assert "the folder cannot be written to" in error and error.count("\n") == 1


def test_run_files_name_the_learner(done: Path) -> None:
    summary = json.loads((done / "runs" / "rib-0" / "run.json").read_text())
    assert summary["learner"] == "rib" and summary["instances"] > 0
