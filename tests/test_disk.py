"""Several runs at once, disks that fail, processes that are killed: nothing that was there is lost."""

from __future__ import annotations

import errno
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from test_checkpoints import files

from nppg.bridge.files import held
from nppg.cli.main import main
from nppg.experiments import checkpoints, run_files
from nppg.experiments.checkpoints import Checkpoints
from nppg.policy.copies import CHECKPOINT
from nppg.policy.policy import Policy

SMALL = ["train", "blocks_world", "--set", "blocks=3", "--min-examples", "20", "--evaluate-every", "5", "--quiet"]
COMMAND = [sys.executable, "-m", "nppg"]
SOAK = "NPPG_SOAK" in os.environ  # as in `make soak`
KILLS = int(os.environ.get("NPPG_SOAK", "2"))


@pytest.fixture(autouse=True)
def no_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run_files, "_draw", lambda *_: False)


def is_whole(folder: Path, swept: bool = True) -> None:
    """Whether what is in a folder can be gone on with and used."""
    if (folder / CHECKPOINT).exists():
        assert checkpoints.read(folder / CHECKPOINT).run["count"] > 0
    if (folder / "model.pl").exists():
        Policy.load(folder / "model.pl")
    assert not swept or not list(folder.glob(".*"))


# ---------------------------------------------------------------- two runs


def test_a_second_run_into_a_folder_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for again in (["--output", str(tmp_path)], ["--seeds", "0", "--output", str(tmp_path.parent)]):
        folder = tmp_path if "--seeds" not in again else tmp_path.parent / "seed-0"
        folder.mkdir(exist_ok=True)
        with held(folder):
            assert main([*SMALL, "--episodes", "5", *again]) == 2
            assert not list(folder.iterdir())
        error = capsys.readouterr().err
        assert error.startswith(f"{folder}: another run is writing into this folder") and error.count("\n") == 1


def test_a_dead_process_holds_no_folder(tmp_path: Path) -> None:
    program = "import os, sys, pathlib, signal; from nppg.bridge.files import held; held(pathlib.Path(sys.argv[1]))"
    program += ".__enter__(); os.kill(os.getpid(), signal.SIGKILL)"
    process = subprocess.run([sys.executable, "-c", program, str(tmp_path)])
    assert process.returncode == -signal.SIGKILL
    with held(tmp_path):
        pass


# ---------------------------------------------------------------- failing disks


class Failing:
    """The k-th call of a function fails as on a full disk, and so does every later one until it is mended."""

    def __init__(self, function: Callable, at: int, before: Callable[..., object] = lambda *_: None):
        self.function = function
        self.left = at
        self.before = before

    def __call__(self, *args: Any, **keywords: Any) -> Any:
        self.left -= 1
        if self.left == 0:
            self.before(*args)
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return self.function(*args, **keywords)


def half(path: Path, *_: object) -> None:
    path.write_text("half of")


WHERE = {
    "fsync": (os, "fsync", lambda *_: None),
    "rename": (os, "replace", lambda *_: None),
    "link": (os, "link", lambda *_: None),
    "create": (Path, "touch", lambda *_: None),
    "write": (Path, "write_bytes", half),
}


@pytest.mark.parametrize("where", WHERE)
def test_any_write_may_fail(
    where: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(Checkpoints, "are_due", property(lambda _: True))
    assert main([*SMALL, "--episodes", "8", "--output", str(tmp_path / "whole")]) == 0
    owner, name, before = WHERE[where]
    for at in range(1, 1000) if SOAK else (1, 4, 9, 25):
        folder = tmp_path / f"{where}-{at}"
        with monkeypatch.context() as broken:
            failing = Failing(getattr(owner, name), at, before)
            broken.setattr(owner, name, lambda *args, failing=failing, **keywords: failing(*args, **keywords))
            status = main([*SMALL, "--episodes", "8", "--output", str(folder)])
        error = capsys.readouterr().err
        if status == 0:  # it was the checkpoint before the last one, or nothing
            assert files(folder) == files(tmp_path / "whole")
            if failing.left > 0:
                break
            continue
        assert status == 2 and error.count("\n") == 1 and "No space left on device" in error
        is_whole(folder)
        if (folder / CHECKPOINT).exists():
            assert main(["train", "--resume", str(folder), "--quiet"]) == 0
            assert files(folder) == files(tmp_path / "whole")


@pytest.mark.parametrize("most", [0, 100, 6000, 14000, *([1, 1500, 3000, 9000, 11000] * SOAK)])
def test_a_disk_may_be_full(
    most: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """No file can grow beyond so many bytes, whoever writes it."""
    monkeypatch.setattr(Checkpoints, "are_due", property(lambda _: True))
    assert main([*SMALL, "--episodes", "8", "--output", str(tmp_path / "whole")]) == 0
    capsys.readouterr()
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, before[1]))
    try:
        status = main([*SMALL, "--episodes", "8", "--output", str(tmp_path / "run")])
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    error = capsys.readouterr().err
    assert status == 2 and error.count("\n") == 1 and error.startswith(str(tmp_path))
    is_whole(tmp_path / "run")
    if (tmp_path / "run" / CHECKPOINT).exists():
        assert main(["train", "--resume", str(tmp_path / "run"), "--quiet"]) == 0
        assert files(tmp_path / "run") == files(tmp_path / "whole")


def test_a_folder_may_vanish(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(Checkpoints, "are_due", property(lambda _: True))
    folder, write = tmp_path / "run", checkpoints.write

    def vanishing(path: Path, *given: Any) -> None:
        write(path, *given)
        if given[0]["count"] == 3:
            shutil.rmtree(folder)

    monkeypatch.setattr(checkpoints, "write", vanishing)
    assert main([*SMALL, "--episodes", "8", "--output", str(folder)]) == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1 and "No such file or directory" in error and not folder.exists()


# ---------------------------------------------------------------- what is refused


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--resume", "nowhere"], "nowhere: there is no checkpoint to go on from"),
        (["--resume", "nowhere", "--seed", "1"], "leave out --seed"),
        (["blocks_world", "--resume", "nowhere"], "leave out the domain"),
        (["blocks_world", "--checkpoint-every", "-1"], "checkpoint-every must be a finite number, at least 0, not -1"),
        ([], "nppg train: name a domain, or a run to go on with by --resume"),
    ],
)
def test_mistakes_are_one_line(arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["train", *arguments]) == 2
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1


# ---------------------------------------------------------------- killed


def test_a_run_may_be_killed_at_any_moment(tmp_path: Path) -> None:
    options = [*SMALL, "--episodes", "150", "--jobs", "1"]
    assert main([*options, "--output", str(tmp_path / "whole")]) == 0
    draw = random.Random(KILLS)
    folder, survived = tmp_path / "run", 0
    for _ in range(KILLS):
        begun = (folder / CHECKPOINT).exists()
        arguments = ["train", "--resume", str(folder), "--quiet"] if begun else [*options, "--output", str(folder)]
        process = subprocess.Popen([*COMMAND, *arguments, "--checkpoint-every", "0.01"], stderr=subprocess.PIPE)
        if not begun and draw.random() < 0.8:
            while process.poll() is None and not (folder / CHECKPOINT).exists():
                time.sleep(0.01)
        time.sleep(draw.random() * (0.5 if not begun else 3.0))
        process.kill()
        _, errors = process.communicate()
        assert errors == b""
        if folder.exists():
            is_whole(folder, swept=False)
        if process.returncode == 0:
            survived += 1
            assert files(folder) == files(tmp_path / "whole")
            shutil.rmtree(folder)
    if (folder / CHECKPOINT).exists():
        assert main(["train", "--resume", str(folder), "--quiet"]) == 0
        assert files(folder) == files(tmp_path / "whole")


PROGRAM = "import sys, nppg.__main__ as program; print('ready', flush=True); sys.exit(program.run())"


def test_an_interrupt_at_any_moment_ends_with_status_130(tmp_path: Path) -> None:
    """From the first line of nppg's on: while it is imported, while Prolog starts, while it learns and writes."""
    draw = random.Random(KILLS)
    most = [0.02, 0.2, 0.8, 1.5]
    for number in range(2 * KILLS if not SOAK else KILLS):
        folder = tmp_path / str(number)
        arguments = [*SMALL, "--episodes", "100000", "--evaluate-every", "0", "--output", str(folder)]
        command = [sys.executable, "-c", PROGRAM, *arguments, "--checkpoint-every", "0.01"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            assert process.stdout and process.stdout.readline() == "ready\n"
            time.sleep(0.001 + draw.random() * most[number % len(most)])
            process.send_signal(signal.SIGINT)
            assert (process.communicate(timeout=120)[1], process.returncode) == ("interrupted\n", 130)
        if folder.exists():
            is_whole(folder)
