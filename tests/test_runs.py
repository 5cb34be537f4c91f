"""What a run and a saved policy leave in a folder: all of their own, and nothing of anyone else's lost."""

from __future__ import annotations

import csv
import json
import signal
import subprocess
import sys
import time
import warnings
import weakref
from dataclasses import replace
from pathlib import Path

import pytest
from samples import resigned

from nppg.bias.language_bias import LanguageBias
from nppg.bridge import prolog
from nppg.bridge.files import shipped
from nppg.bridge.interrupts import interruptible, undisturbed
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.experiments.run_files import is_finished
from nppg.experiments.runs import run
from nppg.learning import training
from nppg.learning.options import Options
from nppg.learning.training import Iteration
from nppg.policy.model import another_domain
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain

SHIPPED = (shipped("domains") / "blocks_world.pl").read_text()
MINE = SHIPPED + "% mine\n"
SMALL = ["--set", "blocks=3", "--episodes", "20", "--evaluate-every", "10"]


def train(folder: Path, domain: object = "blocks_world", *options: str) -> int:
    bias = ["--bias", "blocks_world"]
    return main(["train", str(domain), *bias, *SMALL, "--output", str(folder), *options])


# ---------------------------------------------------------------- nothing is overwritten


def test_a_domain_file_is_left_as_its_owner_wrote_it(plain_bias: LanguageBias, tmp_path: Path) -> None:
    mine = tmp_path / "blocks_world.pl"
    mine.write_text(MINE)
    with pytest.raises(NppgError, match=r"blocks_world\.pl: there is another file of this name"):
        Policy(Domain("blocks_world"), plain_bias).save(tmp_path / "model.pl")
    assert train(tmp_path) == 2
    assert [each.name for each in tmp_path.iterdir()] == [mine.name] and mine.read_text() == MINE
    Policy(Domain(mine), plain_bias).save(tmp_path / "model.pl")
    assert mine.read_text() == MINE


@pytest.mark.parametrize("folder", [".", "elsewhere"])
def test_a_model_has_another_name_than_its_domain(plain_bias: LanguageBias, tmp_path: Path, folder: str) -> None:
    mine = tmp_path / "model.pl"
    mine.write_text(SHIPPED)
    (tmp_path / folder).mkdir(exist_ok=True)
    with pytest.raises(NppgError, match="a model needs another name than its domain's file"):
        Policy(Domain(mine), plain_bias).save(tmp_path / folder / "model.pl")
    assert train(tmp_path / folder, mine) == 2
    assert mine.read_text() == SHIPPED and len(list(tmp_path.rglob("*.*"))) == 1


def test_a_run_replaces_what_an_earlier_run_wrote_and_only_that(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mine, folder = tmp_path / "blocks_world.pl", tmp_path / "run"
    mine.write_text(SHIPPED)
    assert train(folder, mine) == 0
    mine.write_text(MINE)
    assert train(folder, mine) == 0
    assert (folder / mine.name).read_text() == MINE
    (folder / mine.name).write_text(MINE + "% edited in the run's folder\n")
    capsys.readouterr()
    assert train(folder, mine) == 2
    assert "left as it is" in capsys.readouterr().err and "edited" in (folder / mine.name).read_text()


def test_a_run_ends_with_its_seconds_as_with_its_episodes(tmp_path: Path) -> None:
    assert train(tmp_path, "blocks_world", "--episodes", "100000", "--seconds", "0.1") == 0
    summary = json.loads((tmp_path / "run.json").read_text())
    assert summary["seconds"] >= 0.1 and summary["episodes"] < 100000 and summary["trees"] > 0
    assert summary["last"]["episode"] == summary["episodes"]
    assert "model(curve, seconds=0.1)" in (tmp_path / "model.pl").read_text()
    settings = {name: summary[name] for name in ("domain", "bias", "options", "curve")}
    assert is_finished(tmp_path, settings)
    summary["seconds"] = 0.05
    resigned(tmp_path / "run.json", json.dumps(summary))
    assert not is_finished(tmp_path, settings)


def test_a_probe_for_a_folder_leaves_files_alone(tmp_path: Path) -> None:
    (tmp_path / ".nppg").write_text("mine")
    assert train(tmp_path) == 0
    assert (tmp_path / ".nppg").read_text() == "mine"


# ---------------------------------------------------------------- what was read is what is written


def test_inputs_that_change_during_a_run_are_written_as_they_were(tmp_path: Path) -> None:
    domain_file, bias_file = tmp_path / "toy.pl", tmp_path / "toy.yaml"
    domain_file.write_text(SHIPPED)
    source = (shipped("language_bias") / "blocks_world.yaml").read_text()
    bias_file.write_bytes(b"\xef\xbb\xbf" + source.encode())
    domain, bias = Domain(domain_file, {"blocks": 3}), LanguageBias.load(bias_file)
    domain_file.write_text("no domain")
    bias_file.unlink()
    folder = tmp_path / "run"
    run(domain, bias, Options(episodes=20), folder, 0)
    assert (folder / "toy.pl").read_text() == SHIPPED
    assert (folder / "toy.yaml").read_bytes() == b"\xef\xbb\xbf" + source.encode()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        Policy.load(folder / "model.pl")


def test_a_run_is_saved_though_its_domain_is_edited_in_the_same_folder(
    plain_bias: LanguageBias, tmp_path: Path
) -> None:
    mine = tmp_path / "toy.pl"
    mine.write_text(SHIPPED)
    domain = Domain(mine, {"blocks": 3})
    with pytest.raises(NppgError, match="left as it is"):
        run(domain, plain_bias, Options(episodes=20), tmp_path, 0, report=lambda _: bool(mine.write_text(MINE)) or None)
    assert mine.read_text() == MINE
    assert {each.name for each in tmp_path.iterdir()} == {
        *("toy.pl", "blocks_world.yaml", "model.pl", "run.json", "checkpoint.json")
    }


def test_a_bias_made_in_python_has_no_file(plain_bias: LanguageBias, tmp_path: Path) -> None:
    made = replace(plain_bias, file="", source=b"")
    assert made == replace(plain_bias, file="")
    progress = run(Domain("blocks_world", {"blocks": 3}), made, Options(episodes=20), tmp_path, 0)
    assert progress.written == ["blocks_world.pl", "model.pl", "run.json"]
    assert {path.name for path in tmp_path.iterdir()} == {*progress.written, "checkpoint.json"}
    assert json.loads((tmp_path / "run.json").read_text())["bias"] is None
    assert "model(bias" not in (tmp_path / "model.pl").read_text()
    assert main(["distill", str(tmp_path / "model.pl"), "--max-rules", "2"]) == 2


def test_distill_asks_for_a_bias(plain_bias: LanguageBias, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Policy(Domain("blocks_world", {"blocks": 3}), plain_bias).save(tmp_path / "model.pl")
    assert main(["distill", str(tmp_path / "model.pl")]) == 2
    error = capsys.readouterr().err
    assert error == f"{tmp_path}/model.pl: the model names no language bias; give one by --bias\n"


# ---------------------------------------------------------------- what is recorded


def test_a_curve_of_an_earlier_run_goes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    assert train(tmp_path) == 0
    assert (tmp_path / "curve.csv").exists() and "curve.csv" in capsys.readouterr().out
    assert train(tmp_path, "blocks_world", "--evaluate-every", "0") == 0
    expected = ["blocks_world.pl", "blocks_world.yaml", "model.pl", "run.json"]
    assert capsys.readouterr().out == f"written to {tmp_path}/: {', '.join(expected)}\n"
    assert sorted(each.name for each in tmp_path.iterdir()) == sorted([*expected, "checkpoint.json", "notes.txt"])


def test_a_curve_that_no_run_wrote_stays(tmp_path: Path) -> None:
    (tmp_path / "curve.csv").write_text("mine")
    assert train(tmp_path, "blocks_world", "--evaluate-every", "0") == 0
    assert (tmp_path / "curve.csv").read_text() == "mine"


def test_what_ends_a_run_is_recorded(tmp_path: Path) -> None:
    assert train(tmp_path, "blocks_world", "--quiet") == 0
    assert "model(curve" not in (tmp_path / "model.pl").read_text()
    assert train(tmp_path, "blocks_world", "--until-success", "0.5", "--starts", "30") == 0
    recorded = json.loads((tmp_path / "run.json").read_text())["curve"]
    assert recorded == {"evaluate_every": 10, "starts": 30, "until_success": 0.5, "until_return": None}
    assert recorded.pop("until_return") is None
    for name, value in recorded.items():
        assert f"model(curve, {name}={value}).\n" in (tmp_path / "model.pl").read_text()


def test_returns_where_there_is_no_goal(chain, tmp_path: Path) -> None:
    """The uniform policy's return is 0.1 on average, and 1.1 less 0.1 a step the best."""
    domain, bias = chain
    options = Options(episodes=200, seed=1, guidance=0)
    progress = run(domain, bias, options, tmp_path, evaluate_every=20, starts=200)
    assert progress.measure == "return" and progress.policy.trees
    first, *_, last = progress.curve
    for point in progress.curve:
        assert progress.judged(point) == (point.mean_return, point.greedy_return)
        assert (point.success, point.exact) == (0.0, 0)
        # each episode that gets there ends in 1 after so many steps, all but the last of -0.1
        assert point.mean_return <= 1.1 - 0.1 * point.mean_steps + 1e-9
    assert first.mean_return < 0.4 and last.greedy_return > 0.85
    assert last.greedy_return == pytest.approx(0.9, abs=0.05)
    rewards = [[step.reward for step in episode.steps] for it in train_again(chain, options) for episode in it.recent]
    assert progress.outcomes == pytest.approx([sum(each) for each in rewards], abs=1e-12)
    assert progress.recent == pytest.approx(sum(map(sum, rewards[-100:])) / 100)
    rows = list(csv.DictReader((tmp_path / "curve.csv").open()))
    assert [float(row["mean_return"]) for row in rows] == [point.mean_return for point in progress.curve]
    assert (tmp_path / "curve.png").exists()


def train_again(chain, options: Options) -> list[Iteration]:
    return list(training.train(*chain, options))


def test_until_return(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Also where success could be evaluated exactly: points are then sampled."""
    assert train(tmp_path, "blocks_world", "--until-return", "0.3", "--episodes", "4000", "--starts", "40") == 0
    assert "return 0." in capsys.readouterr().out
    rows = list(csv.DictReader((tmp_path / "curve.csv").open()))
    assert len(rows) > 1 and all(row["exact"] == "0" and row["mean_return"] == row["success"] for row in rows)
    assert [float(row["mean_return"]) >= 0.3 for row in rows] == [False] * (len(rows) - 1) + [True]
    assert json.loads((tmp_path / "run.json").read_text())["curve"]["until_return"] == 0.3
    assert "model(curve, until_return=0.3).\n" in (tmp_path / "model.pl").read_text()
    assert train(tmp_path, "blocks_world") == 0
    (row, *_) = csv.DictReader((tmp_path / "curve.csv").open())
    assert row["exact"] == "1" and row["mean_return"] == row["greedy_return"] == ""
    for wrong in (["nan"], ["inf"], ["1", "--evaluate-every", "0"]):
        assert train(tmp_path, "blocks_world", "--until-return", *wrong) == 2
        assert "until-return must be a finite number" in capsys.readouterr().err


def test_another_domain_than_the_models_is_noted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert train(tmp_path, "blocks_world", "--quiet") == 0
    model, domain = tmp_path / "model.pl", tmp_path / "blocks_world.pl"
    policy = Policy.load(model)
    assert another_domain(model, policy.domain, policy.facts) == []
    domain.write_text(MINE)
    capsys.readouterr()
    assert main(["evaluate", str(model), "--starts", "5", "--json"]) == 0
    error = capsys.readouterr().err
    assert error.startswith(f"warning: {model}: {domain} is not the file") and error.count("\n") == 1
    with pytest.warns(UserWarning, match="is not the file"):
        policy = Policy.load(model)
    assert len(another_domain(model, policy.domain, policy.facts)) == 1


def test_evaluate_takes_the_horizon_of_the_training(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert train(tmp_path, "blocks_world", "--quiet", "--horizon-factor", "0.5") == 0
    last = json.loads((tmp_path / "run.json").read_text())["last"]["success"]

    def success(*options: str) -> float:
        assert main(["evaluate", str(tmp_path / "model.pl"), "--json", *options]) == 0
        return float(json.loads(capsys.readouterr().out)["success"])

    assert success("--exact") == last == success("--exact", "--horizon-factor", "0.5")
    assert success("--exact", "--horizon-factor", "3") > last
    assert success("--starts", "200", "--horizon-factor", "0") == 0
    assert main(["evaluate", str(tmp_path / "model.pl"), "--horizon-factor", "-1"]) == 2


# ---------------------------------------------------------------- Ctrl-C


@pytest.mark.parametrize("milliseconds", [2, 10, 30, 60, 100])
def test_a_second_interrupt_does_not_lose_the_run(tmp_path: Path, milliseconds: int) -> None:
    options = ["--episodes", "100000", "--evaluate-every", "10", "--set", "blocks=4", "--output", str(tmp_path)]
    command = [sys.executable, "-m", "nppg", "train", "blocks_world", *options]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout and process.stdout.readline().startswith("episode     0")
    process.stdout.readline()
    process.send_signal(signal.SIGINT)
    time.sleep(milliseconds / 1000)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=120)
    assert process.returncode == 130 and errors == "interrupted\n"
    assert (tmp_path / "curve.png").exists() and Policy.load(tmp_path / "model.pl").trees
    assert not list(tmp_path.glob(".*"))


def test_an_interrupt_waits_for_undisturbed_work() -> None:
    done = []
    with pytest.raises(KeyboardInterrupt), interruptible(), undisturbed():
        signal.raise_signal(signal.SIGINT)
        done.append(prolog.ask("version"))
    prolog.ask("version")
    assert done


def test_an_interrupt_does_not_outlive_its_command() -> None:
    with pytest.raises(NppgError), interruptible():
        signal.raise_signal(signal.SIGINT)
        raise NppgError("another end")
    prolog.ask("version")


def test_a_finalizer_swallows_no_interrupt() -> None:
    domain = Domain("blocks_world")
    gone = weakref.ref(domain)
    with pytest.raises(KeyboardInterrupt), interruptible():
        signal.raise_signal(signal.SIGINT)
        del domain
        assert gone() is None
        prolog.ask("version")
        pytest.fail("the interrupt is lost")
