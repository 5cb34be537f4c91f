"""The commands as a user calls them: what they print and write, and how they end."""

from __future__ import annotations

import csv
import fcntl
import json
import os
import pty
import signal
import struct
import subprocess
import sys
import termios
import time
import warnings
from pathlib import Path

import pytest

from nppg.cli.arguments import warnings_told
from nppg.cli.main import main

COMMAND = [sys.executable, "-m", "nppg"]
SMALL = ["--set", "blocks=4", "--episodes", "60", "--evaluate-every", "20"]


@pytest.fixture(scope="module")
def trained(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("run")
    assert main(["train", "blocks_world", *SMALL, "--seed", "3", "--output", str(folder), "--quiet"]) == 0
    return folder


def test_train_writes_its_files(trained: Path) -> None:
    names = {each.name for each in trained.iterdir()}
    assert names == {"model.pl", "curve.csv", "curve.png", "run.json", "checkpoint.json"} | {
        f"blocks_world.{suffix}" for suffix in ("pl", "yaml")
    }
    with (trained / "curve.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0])[:4] == ["episode", "trees", "success", "seconds"]
    assert [int(row["episode"]) for row in rows][::3] == [0, 60]
    summary = json.loads((trained / "run.json").read_text())
    assert summary["options"]["seed"] == 3 and summary["domain"]["parameters"] == {"blocks": 4, "task": "on"}
    assert float(rows[-1]["success"]) == summary["last"]["success"]


def test_evaluate_takes_the_parameters_of_the_model(trained: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def result(*options: str) -> dict:
        assert main(["evaluate", str(trained / "model.pl"), "--json", *options]) == 0
        found: dict = json.loads(capsys.readouterr().out)
        return found

    exact = result("--exact")
    assert (exact["starts"], exact["exact"], exact["greedy"]) == (73 - 13, True, False)
    assert exact["success"] == json.loads((trained / "run.json").read_text())["last"]["success"]
    assert result("--exact", "--set", "blocks=5")["starts"] == 428
    sampled = result("--starts", "300", "--greedy")
    assert (sampled["starts"], sampled["exact"], sampled["greedy"]) == (300, False, True)
    assert result("--starts", "50") == result("--starts", "50") != result("--starts", "50", "--seed", "1")


def test_show_and_play(trained: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["show", str(trained / "model.pl"), "--tree", "2"]) == 0
    shown = capsys.readouterr().out
    assert shown.splitlines()[1] in (trained / "model.pl").read_text().splitlines()
    assert main(["show", str(trained / "model.pl"), "--tree", "2", "--format", "dot"]) == 0
    assert capsys.readouterr().out.startswith("digraph tree_2 {")
    assert main(["play", str(trained / "model.pl"), "--seed", "5"]) == 0
    played = capsys.readouterr().out
    assert "step 1" in played and "goal: b" in played and "->" in played


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["train", "blocks_wrld"], "did you mean 'blocks_world'"),
        (["train", "blocks_world", "--set", "blcks=3"], "there is no parameter blcks"),
        (["train", "blocks_world", "--set", "blocks"], "--set takes NAME=VALUE"),
        (["check", "blocks_world", "--set", "blocks"], "--set takes NAME=VALUE"),
        (["train", "blocks_world", "--step-size", "nan"], "step_size"),
        (["train", "blocks_world", "--guidance", "-0.1"], "guidance must be from 0 to 1"),
        (["train", "blocks_world", "--episodes", "-5"], "episodes must be at least 0"),
        (["train", "blocks_world", "--evaluate-every", "-1"], "evaluate-every must be at least 0"),
        (["train", "blocks_world", "--max-depth", "-1"], "max_depth"),
        (["train", "blocks_world", "--output", "/proc/nothing"], "cannot be written"),
        (["evaluate", "nowhere.pl"], "nowhere.pl: cannot be read"),
        (["evaluate", "MODEL", "--starts", "0"], "starts must be at least 1"),
        (["evaluate", "MODEL", "--seed", "-1"], "seed must be at least 0"),
        (["evaluate", "MODEL", "--seconds", "1"], "--seconds is for problems"),
        *[
            ([*verb, "--seconds", wrong], f"seconds must be a finite number greater than 0, not {wrong}")
            for verb in (["train", "blocks_world"], ["evaluate", "MODEL", "--problems", "1"])
            for wrong in ("0", "-1", "nan", "inf")
        ],
        (["prove", "MODEL", "--show", "-1"], "show must be at least 0"),
        (["show", "MODEL", "--tree", "0"], "there is no tree 0"),
        (["show", "MODEL", "--tree", "9999"], "there is no tree 9999"),
        (["new", "Upper"], "'Upper' cannot be a domain's name"),
    ],
)
def test_mistakes_end_with_status_2_and_one_line(
    arguments: list[str], message: str, trained: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([str(trained / "model.pl") if each == "MODEL" else each for each in arguments]) == 2
    output = capsys.readouterr()
    assert message in output.err and output.err.count("\n") == 1 and not output.out


def test_check_reports_all_mistakes_at_once(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "blocks_world", "--bias", "delivery"]) == 2
    errors = capsys.readouterr().err.splitlines()
    assert len(errors) > 3 and all("delivery.yaml:" in each for each in errors)


def test_new_writes_what_checks_and_trains_and_overwrites_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["new", "errands"]) == 0
    assert main(["check", "errands.pl"]) == 0
    assert main(["train", "errands.pl", "--episodes", "40", "--quiet"]) == 0
    assert (tmp_path / "runs" / "errands" / "model.pl").exists()
    (tmp_path / "errands.pl").write_text("mine")
    assert main(["new", "errands"]) == 2
    assert (tmp_path / "errands.pl").read_text() == "mine"


TREES_TOLD = """
import sys
from nppg.cli.main import main
from nppg.policy.policy import Policy

def add(*arguments, added=Policy.add):
    added(*arguments)
    print("tree", flush=True)

Policy.add = add
sys.exit(main(sys.argv[1:]))
"""


def test_an_interrupted_run_keeps_what_it_has_learned(tmp_path: Path) -> None:
    arguments = ["train", "blocks_world", "--episodes", "100000", "--evaluate-every", "0", "--output", str(tmp_path)]
    command = [sys.executable, "-c", TREES_TOLD, *arguments]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout and [process.stdout.readline() for _ in range(3)] == ["tree\n"] * 3
    process.send_signal(signal.SIGINT)
    time.sleep(0.06)
    process.send_signal(signal.SIGINT)  # saved without a curve, it is about to exit
    _, errors = process.communicate(timeout=120)
    assert process.returncode == 130 and errors == "interrupted\n"
    assert json.loads((tmp_path / "run.json").read_text())["trees"] > 0
    assert main(["evaluate", str(tmp_path / "model.pl"), "--starts", "5", "--json"]) == 0


def test_a_terminal_gets_a_progress_bar(tmp_path: Path) -> None:
    pytest.importorskip("tqdm")
    reader, writer = pty.openpty()
    fcntl.ioctl(writer, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 120, 0, 0))
    arguments = ["train", "blocks_world", "--set", "blocks=3", "--episodes", "30", "--output", str(tmp_path)]
    process = subprocess.Popen([*COMMAND, *arguments], stderr=writer, stdout=subprocess.DEVNULL)
    os.close(writer)
    shown = b""
    try:
        while data := os.read(reader, 4096):
            shown += data
    except OSError:
        pass
    assert process.wait(timeout=120) == 0
    assert b"30/30" in shown and b"trees=" in shown


@pytest.mark.parametrize("delay", [0.15, 0.25, 0.35, 0.5, 0.8, 1.2])
def test_an_interrupt_while_starting_ends_with_status_130(delay: float, tmp_path: Path) -> None:
    ready = "import sys, time; from nppg.cli.main import main; print('ready', flush=True); sys.exit(main(sys.argv[1:]))"
    arguments = ["train", "blocks_world", "--episodes", "100000", "--evaluate-every", "0", "--output", str(tmp_path)]
    command = [sys.executable, "-c", ready, *arguments]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout and process.stdout.readline() == "ready\n"
        time.sleep(delay)
        process.send_signal(signal.SIGINT)
        assert (process.communicate(timeout=120)[1], process.returncode) == ("interrupted\n", 130)


def test_a_warning_is_told_at_once_and_once(capsys: pytest.CaptureFixture[str]) -> None:
    with warnings_told():
        warnings.warn("mind the gap", stacklevel=1)
        assert capsys.readouterr().err == "warning: mind the gap\n"
        warnings.warn("mind the gap", stacklevel=1)
        with warnings_told(False):
            warnings.warn("the doors", stacklevel=1)
    assert capsys.readouterr().err == ""
