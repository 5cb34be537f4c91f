"""What the README shows is what happens."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from nppg.cli.main import main

README = (Path(__file__).parent.parent / "README.md").read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)


@pytest.fixture
def treasure(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "treasure.pl").write_text(blocks("prolog")[0])
    (tmp_path / "treasure.yaml").write_text(blocks("yaml")[0])
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_worked_example_is_learned_and_its_first_tree_is_the_one_shown(
    treasure: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["check", "treasure.pl"]) == 0
    assert main(["train", "treasure.pl", "--evaluate-every", "0", "--quiet"]) == 0
    capsys.readouterr()
    assert main(["show", "runs/treasure/model.pl", "--tree", "1"]) == 0
    assert capsys.readouterr().out.strip() == blocks("prolog")[1].strip()
    arguments = ["evaluate", "runs/treasure/model.pl", "--greedy", "--set", "rooms=30", "--starts", "200", "--json"]
    assert main(arguments) == 0
    assert '"success": 1.0' in capsys.readouterr().out


def test_a_mistake_that_shows_late_is_found_where_the_expert_goes(
    treasure: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = treasure / "treasure.pl"
    file.write_text("\n".join(line for line in file.read_text().splitlines() if "effect(unlock" not in line))
    assert main(["check", "treasure.pl"]) == 2
    assert "action/1 allows unlock, which no effect covers" in capsys.readouterr().err


@pytest.mark.parametrize("number", [0, 1])
def test_the_ten_lines_give_what_stands_below_them(tmp_path: Path, number: int) -> None:
    code, shown = blocks("python")[number], blocks("text")[number].strip().splitlines()
    result = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    evaluated, *rules = result.stdout.splitlines()
    told = re.findall(r"(?:Success|Return) ([0-9.]+[0-9])", README)[number]
    assert f"{'success' if number == 0 else 'mean_return'}={told}" in evaluated
    rounded = [re.sub(r"-?[0-9]+\.[0-9]+", lambda match: f"{float(match[0]):.3f}", rule) for rule in rules]
    assert rounded[: len(shown)] == shown
    assert len(list(tmp_path.glob("runs/*/model.pl"))) == 1


def test_both_worlds_take_the_same_ten_lines() -> None:
    first, second = (block.splitlines() for block in blocks("python"))
    assert len(first) == len(second) == 10
    assert [i for i, pair in enumerate(zip(first, second, strict=True)) if pair[0] != pair[1]] == [2, 9]
