"""The benchmark of the planning competition, on a small world of the same shape."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from benchmarks.ipc2023 import lama, page, policies, zoo
from benchmarks.ipc2023.command import main as command
from benchmarks.ipc2023.processes import Ended
from benchmarks.ipc2023.results import Results
from benchmarks.ipc2023.tasks import DOMAINS, Setting
from nppg.cli.main import main

ROOT = Path(__file__).parent.parent
LIBRARY = ROOT / "examples" / "library"
NAME = DOMAINS[0]  # under which it is laid out


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("data")
    for number, part in enumerate(["training/easy"] * 4 + ["testing/easy", "testing/medium"], 1):
        (folder / NAME / part).mkdir(parents=True, exist_ok=True)
        shutil.copy(LIBRARY / f"p0{number}.pddl", folder / NAME / part)
    shutil.copy(LIBRARY / "domain.pddl", folder / NAME)
    costs = {f"{NAME}/testing/easy/p05.pddl": 1, f"{NAME}/testing/medium/p06.pddl": 1}
    (folder / "reference.json").write_text(json.dumps(costs))
    return folder


@pytest.fixture(scope="module")
def done(data: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a benchmark's results."""
    output = tmp_path_factory.mktemp("results")
    (output / "ferry-lama.jsonl").write_text("".join(f"{json.dumps(line)}\n" for line in _planned()))
    arguments = ["--data", str(data), "--output", str(output), "--parts", "learn,policy,rules,levin", "--domains", NAME]
    command([*arguments, "--learn-seconds", "1"])
    before = {file: file.read_text() for file in output.glob("*.jsonl")}
    command(arguments)
    assert before == {file: file.read_text() for file in output.glob("*.jsonl")}  # nothing is done again
    return output


def _planned() -> list[dict]:
    easy = {"solved": True, "ended": "solved", "cost": 2, "seconds": 0.5}
    medium = {"solved": False, "ended": "time", "cost": None, "seconds": 60.5}
    key = {"part": "lama", "domain": NAME}
    return [{**key, "level": "easy", "problem": "p05", **easy}, {**key, "level": "medium", "problem": "p06", **medium}]


def _setting(data: Path, output: Path) -> Setting:
    return Setting(data, Results(output), 60, 8, 1, 60, 1, None)


def test_what_is_learned_acts_on_each_problem(done: Path) -> None:
    results = Results(done)
    learned = results.get(part="learn", domain=NAME, seed=0)
    assert learned and learned["trees"] > 0
    for part in policies.MODELS:
        for level, problem in (("easy", "p05"), ("medium", "p06")):
            line = results.get(part=part, domain=NAME, seed=0, level=level, problem=problem)
            assert line and line["solved"] == (line["ended"] == "solved") == (line["cost"] is not None)
            assert line["processor"] > line["seconds"]
    written = "".join(file.read_text() for file in done.rglob("*.jsonl"))
    assert str(done) not in written and str(ROOT) not in written


def test_learning_goes_on_where_it_was_stopped(data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    setting, run, commands = _setting(data, tmp_path), policies.run, []

    def stopped(command: list[str], folder: Path, *_: object) -> Ended:
        commands.append(command)
        if len(commands) == 1:
            done = run([*command, "--episodes", "30"], folder)  # which end before the seconds do
            raise KeyboardInterrupt(done)
        return run(command, folder)

    monkeypatch.setattr(policies, "run", stopped)
    with pytest.raises(KeyboardInterrupt):
        policies.learn(setting, NAME, 0)
    policies.learn(setting, NAME, 0)
    line = setting.results.get(part="learn", domain=NAME, seed=0)
    assert "--resume" in commands[1] and line and line["processor"] > line["seconds"]


def test_the_page_has_the_results(data: Path, done: Path, tmp_path: Path) -> None:
    shutil.copy(ROOT / page.FOLDER / "README.md", tmp_path)
    page.write(data, Results(done), tmp_path)
    text = (tmp_path / "README.md").read_text()
    assert f"| {NAME} | 1 of 1 | 0 of 1 | 0.5 | 1.00 | 61 | 60.5 | 1 time |" in text
    page.write(data, Results(tmp_path), tmp_path)
    assert (tmp_path / "README.md").read_text() == text  # made again from the results beside it


def test_a_model_of_the_zoo_reads_problems_beside_its_pddl(
    data: Path, done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copy(ROOT / zoo.FOLDER / "README.md", tmp_path)
    zoo.write(_setting(data, done), 0, DOMAINS, tmp_path)
    text = (tmp_path / "README.md").read_text()
    shutil.copy(LIBRARY / "domain.pddl", tmp_path / "ipc2023" / NAME)
    assert f"[{NAME}](ipc2023/{NAME})" in text and "```prolog\ndelta(1, " in text
    for name in policies.MODELS.values():
        model = tmp_path / "ipc2023" / NAME / name
        assert str(done) not in model.read_text()
        assert main(["evaluate", str(model), "--json", "--problems", str(LIBRARY / "p05.pddl")]) == 0
        assert json.loads(capsys.readouterr().out)["problems"] == 1


def test_all_the_time_of_a_problem_counts() -> None:
    found = {"ended": "solved", "cost": 5, "steps": 5, "seconds": 1.0}
    output = json.dumps({"list": [found]})
    assert policies.attempted(Ended(0, output, "", 59.0), 60)["solved"]
    late = policies.attempted(Ended(0, output, "", 61.0), 60)
    assert (late["solved"], late["ended"], late["cost"]) == (False, "time", None)
    assert policies.attempted(Ended(-24, "", "", 65.0), 60)["ended"] == "time"
    short = Ended(1, "", "Traceback\nnumpy.exceptions._ArrayMemoryError: Unable to allocate\n", 2.0)
    assert policies.attempted(short, 60)["ended"] == "memory" and not short.is_mistaken


def test_a_mistake_is_told_and_done_again(
    data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    setting = _setting(data, tmp_path)
    (folder := setting.folder(NAME, 0)).mkdir(parents=True)
    (folder / "model.pl").touch()
    (folder / "rules.pl").touch()
    outcomes = [Ended(2, "", "a\nmodel.pl:1: a mistake\n", 2.0), Ended(-24, "", "", 65.0)]
    for outcome, recorded in zip(outcomes, (0, 3), strict=True):
        monkeypatch.setattr(policies, "run", lambda *_, outcome=outcome: outcome)
        policies.distill(setting, NAME, 0)
        policies.act(setting, "policy", NAME, 0)
        assert len(Results(tmp_path).lines) == recorded
        assert capsys.readouterr().err.count("not recorded: model.pl:1: a mistake") == 3 - recorded


def test_lama_plans_until_it_gives_up(data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    setting = _setting(data, tmp_path)
    for number in range(1, 5):
        shutil.copy(LIBRARY / "p06.pddl", data / NAME / "testing" / "medium" / f"p1{number}.pddl")
    calls = []

    def plan(domain: Path, problem: Path, *limits: int) -> dict:
        calls.append(problem.stem)
        solved = problem.stem == "p05"
        return {"solved": solved, "ended": "solved" if solved else "time", "cost": 2, "seconds": 1.0}

    monkeypatch.setattr(lama, "plan", plan)
    lama.plan_all(setting, NAME)
    lama.plan_all(setting, NAME)
    assert calls == ["p05", "p06"]
    assert [line["ended"] for line in setting.results.lines.values()] == ["solved", "time", *["not run"] * 4]


def test_lama_plans(data: Path) -> None:
    pytest.importorskip("up_fast_downward")
    found = lama.plan(data / NAME / "domain.pddl", data / NAME / "testing" / "easy" / "p05.pddl", 60, 8)
    assert found["solved"] and found["cost"] > 0 and found["seconds"] > 0
