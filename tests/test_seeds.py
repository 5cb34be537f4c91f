"""nppg train --seeds: each run is the one that --seed does, wherever it is done, and their curve is that of all."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nppg.cli.main import main

COMMAND = [sys.executable, "-m", "nppg", "train"]
LIBRARY = Path(__file__).parent.parent / "examples" / "library"
SMALL = ["blocks_world", "--set", "blocks=3", "--episodes", "40", "--evaluate-every", "20"]
SETTINGS = {
    "nppg": [*SMALL, "--min-examples", "10"],
    "tg": [*SMALL, "--learner", "tg"],
    "pddl": [
        *(str(LIBRARY / "domain.pddl"), "--problems", *(str(LIBRARY / f"p0{i}.pddl") for i in (1, 2, 3))),
        *("--episodes", "20", "--min-examples", "5", "--step", "second-order", "--discount", "0.95"),
    ],
    "gym": ["gym:CartPole-v1", "--episodes", "10", "--evaluate-every", "5", "--starts", "3"],
}


def train(folder: Path, *arguments: str) -> int:
    return main(["train", *arguments, "--output", str(folder)])


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def contents(folder: Path) -> dict[str, Any]:
    """The files of a run, but for the seconds that it took."""
    found: dict[str, Any] = {path.name: path.read_bytes() for path in folder.iterdir()}
    del found["checkpoint.json"]  # which has the seconds in it
    summary = json.loads(found["run.json"])
    del summary["sha256"]  # which is over them, too
    for each in (summary, summary["last"] or {}):
        each.pop("seconds", None)
    found["run.json"] = summary
    if "curve.csv" in found:
        found["curve.csv"] = [row | {"seconds": ""} for row in rows(folder / "curve.csv")]
    return found


@pytest.mark.parametrize("name", ["tg", "pddl", "gym"])
def test_each_run_is_that_of_its_seed(name: str, tmp_path: Path) -> None:
    if name == "gym":
        pytest.importorskip("gymnasium")
    assert train(tmp_path / "many", *SETTINGS[name], "--seeds", "0,7", "--jobs", "2", "--quiet") == 0
    assert {path.name for path in (tmp_path / "many").iterdir()} == {"seed-0", "seed-7", "curve.csv", "curve.png"}
    assert train(tmp_path / "one", *SETTINGS[name], "--seed", "7", "--quiet") == 0
    assert contents(tmp_path / "many" / "seed-7") == contents(tmp_path / "one")


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("seeds")
    assert train(folder, *SETTINGS["nppg"], "--seeds", "0-2", "--quiet") == 0
    return folder


def test_the_curve_is_that_of_all_runs(done: Path, tmp_path: Path) -> None:
    assert train(tmp_path, *SETTINGS["nppg"], "--seed", "1", "--quiet") == 0
    assert contents(done / "seed-1") == contents(tmp_path)
    found = rows(done / "curve.csv")
    assert [row["episode"] for row in found] == ["0", "20", "40"] and {row["runs"] for row in found} == {"3"}
    curves = [rows(done / f"seed-{seed}" / "curve.csv") for seed in range(3)]
    for number, row in enumerate(found):
        for name in ("success", "greedy_success"):
            values = [float(curve[number][name]) for curve in curves]
            assert float(row[f"{name}_mean"]) == pytest.approx(np.mean(values), abs=1e-6)
            assert float(row[f"{name}_sd"]) == pytest.approx(np.std(values), abs=1e-6)
    assert (done / "curve.png").stat().st_size > 10_000


def test_finished_runs_are_not_done_again(done: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = {seed: (done / f"seed-{seed}" / "model.pl").stat().st_mtime_ns for seed in range(3)}
    summary = done / "seed-1" / "run.json"
    summary.write_text(summary.read_text().replace('"episodes": 40,\n  "trees"', '"episodes": 39,\n  "trees"'))
    assert train(done, *SETTINGS["nppg"], "--seeds", "0-2") == 0
    *lines, last, written = capsys.readouterr().out.splitlines()
    assert [line.endswith("done before") for line in lines] == [True, True, False]
    assert "seed-1, success" in lines[2] and last.startswith("3 runs: success 0.") and "curve.csv" in written
    after = {seed: (done / f"seed-{seed}" / "model.pl").stat().st_mtime_ns for seed in range(3)}
    assert [seed for seed in range(3) if after[seed] != before[seed]] == [1]
    assert train(done, *SETTINGS["nppg"], "--seeds", "0", "--max-depth", "2") == 0
    assert "done before" not in capsys.readouterr().out


def test_runs_that_end_early_keep_their_last_value(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["blocks_world", "--set", "blocks=3", "--episodes", "400", "--min-examples", "10"]
    arguments += ["--evaluate-every", "20", "--until-success", "0.6", "--seeds", "0-2"]
    assert train(tmp_path, *arguments) == 0
    printed = capsys.readouterr().out
    found = rows(tmp_path / "curve.csv")
    lasts = [float(rows(tmp_path / f"seed-{seed}" / "curve.csv")[-1]["success"]) for seed in range(3)]
    assert int(found[-1]["runs"]) < 3 and found[-1]["episode"] != "400", "some are faster than others"
    assert f"{3 - int(found[-1]['runs'])} ended before episode {found[-1]['episode']} and keep" in printed
    assert float(found[-1]["success_mean"]) == pytest.approx(np.mean(lasts), abs=1e-6) and min(lasts) >= 0.6
    assert train(tmp_path, *arguments) == 0
    assert capsys.readouterr().out.count("done before") == 3


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--seeds", "a"], "--seeds takes numbers such as 0-9 or 0,3,7, not 'a'"),
        (["--seeds", "-3"], "--seeds takes numbers such as 0-9 or 0,3,7, not '-3'"),
        (["--seeds", "3-1"], "--seeds: 3-1 ends before it begins"),
        (["--seeds", "0-99999999"], "--seeds: 0-99999999 are more than 100,000 seeds"),
        (["--seeds", "0-2", "--seed", "1"], "--seed is for one run, --seeds for several: give one of them"),
        (["--seeds", "0", "--jobs", "0"], "jobs must be at least 1, not 0"),
        (["--seeds", "0", "--jobs", "1", "--cluster", "tcp://a:1"], "give one of --jobs and --cluster"),
        (["--cluster", "tcp://a:1"], "--cluster is for several runs: give --seeds"),
        (["--seeds", "0-1", "--until-success", "2"], "until-success must be from 0 to 1"),
    ],
)
def test_mistakes_are_one_line(
    arguments: list[str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert train(tmp_path, *SMALL, *arguments) == 2
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1 and not list(tmp_path.iterdir())


def test_the_folder_of_another_run_is_left_as_it_is(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "run.json").write_text("{}")
    assert train(tmp_path, *SMALL, "--seeds", "0") == 2
    assert capsys.readouterr().err == f"{tmp_path}: this is the folder of another run: write into another one\n"


def test_a_mistake_of_one_run_leaves_those_that_are_finished(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "seed-1").mkdir()
    (tmp_path / "seed-1" / "blocks_world.pl").write_text("mine")
    assert train(tmp_path, *SETTINGS["nppg"], "--seeds", "0,1", "--jobs", "1") == 2
    printed, error = capsys.readouterr()
    assert error.startswith(f"{tmp_path}/seed-1/blocks_world.pl: there is another file") and error.count("\n") == 1
    assert "seed-0, success" in printed and (tmp_path / "seed-0" / "model.pl").exists()


def test_an_interrupt_ends_all_runs_which_keep_what_they_have_learned(tmp_path: Path) -> None:
    command = [*COMMAND, "blocks_world", "--set", "blocks=4", "--episodes", "100000"]
    command += ["--evaluate-every", "0", "--seeds", "0-3", "--jobs", "2", "--output", str(tmp_path)]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        while len(list(tmp_path.iterdir())) < 2:
            time.sleep(0.05)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        assert (process.communicate(timeout=60)[1], process.returncode) == ("interrupted\n", 130)
    assert {path.name for path in tmp_path.iterdir()} == {"seed-0", "seed-1"}
    for path in tmp_path.iterdir():
        assert 0 < json.loads((path / "run.json").read_text())["episodes"] < 100_000


# ---------------------------------------------------------------- on a cluster


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    """Of two processes."""
    with local_cluster(2, silence_logs="CRITICAL") as found:
        yield found


def local_cluster(workers: int, **settings: Any) -> Any:
    distributed = pytest.importorskip("distributed")
    return distributed.LocalCluster(
        n_workers=workers, **{"threads_per_worker": 1, "dashboard_address": ":0", **settings}
    )


def test_a_cluster_does_the_same_runs(cluster: Any, tmp_path: Path) -> None:
    arguments = [*SETTINGS["pddl"], "--seeds", "0-1", "--quiet"]
    assert train(tmp_path / "there", *arguments, "--cluster", cluster.scheduler_address) == 0
    assert train(tmp_path / "here", *arguments) == 0
    for seed in range(2):
        assert contents(tmp_path / "there" / f"seed-{seed}") == contents(tmp_path / "here" / f"seed-{seed}")
    assert (tmp_path / "there" / "curve.csv").read_text() == (tmp_path / "here" / "curve.csv").read_text()


def test_a_killed_worker_costs_its_run_a_repetition(
    cluster: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from distributed import Client

    arguments = ["blocks_world", "--set", "blocks=4", "--episodes", "300", "--seeds", "0-1", "--evaluate-every", "100"]
    killed: list[str] = []

    def kill() -> None:
        with Client(cluster.scheduler_address, set_as_default=False) as client:
            numbers = client.run(os.getpid)
            while not any(client.processing().values()):
                time.sleep(0.05)
            time.sleep(0.7)
            worker, running = next((name, keys) for name, keys in client.processing().items() if keys)
            killed.extend(running)
            os.kill(numbers[worker], signal.SIGKILL)

    killer = threading.Thread(target=kill)
    killer.start()
    assert train(tmp_path / "there", *arguments, "--cluster", cluster.scheduler_address) == 0
    killer.join()
    assert killed, "in the middle of a run"
    assert capsys.readouterr().out.count("success") == 3
    assert train(tmp_path / "here", *arguments, "--quiet") == 0
    for seed in range(2):
        assert contents(tmp_path / "there" / f"seed-{seed}") == contents(tmp_path / "here" / f"seed-{seed}")


def test_a_run_that_nobody_waits_for_ends_on_its_worker(cluster: Any, tmp_path: Path) -> None:
    from distributed import Client

    arguments = ["blocks_world", "--set", "blocks=4", "--episodes", "100000", "--seeds", "0-2", "--evaluate-every", "0"]
    arguments += ["--cluster", cluster.scheduler_address, "--output", str(tmp_path)]
    with Client(cluster.scheduler_address, set_as_default=False) as client:
        with subprocess.Popen([*COMMAND, *arguments], stderr=subprocess.PIPE, text=True) as process:
            while not any(client.processing().values()):
                time.sleep(0.1)
            time.sleep(1)
            process.send_signal(signal.SIGINT)
            assert (process.communicate(timeout=60)[1], process.returncode) == ("interrupted\n", 130)
        deadline = time.monotonic() + 60
        while any(client.run(lambda dask_worker: dask_worker.state.executing_count).values()):
            assert time.monotonic() < deadline
            time.sleep(0.1)


def test_a_mistake_on_a_cluster_is_told_as_here(
    cluster: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "seed-1").mkdir()
    (tmp_path / "seed-1" / "blocks_world.pl").write_text("mine")
    assert train(tmp_path, *SMALL, "--seeds", "1", "--cluster", cluster.scheduler_address) == 2
    error = capsys.readouterr().err
    assert error.startswith(f"{tmp_path}/seed-1/blocks_world.pl: there is another file") and error.count("\n") == 1
    assert [path.name for path in (tmp_path / "seed-1").iterdir()] == ["blocks_world.pl"]
    arguments = ["reproduce", "figure2", "--runs", "2", "--episodes", "50", "--set", "blocks=3"]
    arguments += ["--cluster", cluster.scheduler_address, "--output", str(tmp_path)]
    assert main(arguments) == 0 and (tmp_path / "runs" / "nppg-1" / "tests.csv").exists()
    assert main(arguments) == 0 and capsys.readouterr().out.count("done before") == 2


def test_a_cluster_that_cannot_be_used_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("nppg.experiments.cluster._TIMEOUT", 0.5)
    for address in ("tcp://127.0.0.1:9", "nowhere", "http://a:1"):
        assert train(tmp_path, *SMALL, "--seeds", "0", "--cluster", address) == 2
        assert capsys.readouterr().err == f"{address}: no scheduler of dask.distributed answers there\n"
    with local_cluster(0, processes=False) as found:
        assert train(tmp_path, *SMALL, "--seeds", "0", "--cluster", found.scheduler_address) == 2
        assert capsys.readouterr().err.endswith(": the scheduler has no workers\n")
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert train(tmp_path, *SMALL, "--seeds", "0", "--cluster", "tcp://a:1") == 2
    assert capsys.readouterr().err == "a cluster needs dask.distributed: pip install 'nppg[cluster]'\n"


def test_workers_with_several_threads_are_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with local_cluster(1, processes=False, threads_per_worker=2) as found:
        assert train(tmp_path, *SMALL, "--seeds", "0", "--cluster", found.scheduler_address) == 2
    error = capsys.readouterr().err
    assert "it works in 2 threads, but Prolog in one of them alone: start it by dask worker --nthreads 1" in error
