"""What the command line tells of itself: versions, shipped domains, completion."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from nppg.cli.main import main
from nppg.cli.verbs import VERBS


def test_new_from_a_shipped_domain(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["domains"]) == 0
    names = [line for line in capsys.readouterr().out.splitlines() if re.fullmatch(r"\w+", line)]
    assert "blocks_world" in names and "rover" in names
    for name in names:
        assert main(["new", f"my_{name}", "--from", name]) == 0
        assert main(["check", f"my_{name}.pl"]) == 0, capsys.readouterr().err
        assert (tmp_path / f"my_{name}.pl").read_text().startswith(f":- module(my_{name}, []).")
    capsys.readouterr()
    assert main(["new", "mine", "--from", "blocks_wolrd"]) == 2
    assert capsys.readouterr().err == "there is no shipped domain blocks_wolrd (did you mean 'blocks_world'?)\n"
    assert not (tmp_path / "mine.pl").exists()


def test_the_versions_are_told_without_starting_prolog(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--version"]) == 0
    assert re.fullmatch(r"nppg \S+\njanus-swi \S+\nSWI-Prolog 9\.\S+.*\nPython \S+\n", capsys.readouterr().out)


COMPLETED = """
eval "$SCRIPT"
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_nppg
printf '%s\\n' "${COMPREPLY[@]}"
"""


@pytest.mark.parametrize(
    ("words", "completed"),
    [
        (["tr"], ["train"]),
        (["train", "blocks_w"], ["blocks_world"]),
        (["train", "blocks_world", "--step", ""], ["gradient", "second-order"]),
        (["new", "mine", "--from", "gr"], ["grid"]),
        (["evaluate", "--ex"], ["--exact"]),
        (["show", "mod"], ["model.pl"]),
        (["nonesuch", "--"], []),
    ],
)
def test_the_shell_completes(
    words: list[str], completed: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bash = shutil.which("bash") or pytest.skip("needs bash")
    (tmp_path / "model.pl").touch()
    assert main(["completion", "bash"]) == 0
    environment = {**os.environ, "SCRIPT": capsys.readouterr().out}
    result = subprocess.run(
        [bash, "-c", COMPLETED, "bash", "nppg", *words], cwd=tmp_path, env=environment, capture_output=True, text=True
    )
    assert result.stdout.split() == completed and not result.stderr


def test_the_other_shells_are_told_of_every_command(capsys: pytest.CaptureFixture[str]) -> None:
    for shell in ("zsh", "fish"):
        assert main(["completion", shell]) == 0
        script = capsys.readouterr().out
        assert all(verb in script for verb in VERBS) and "second-order" in script
