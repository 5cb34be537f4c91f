"""The blocks world's other tasks: stack, all blocks in one tower, and unstack, all on the floor."""

from __future__ import annotations

import json
import re
from collections import Counter
from math import factorial
from pathlib import Path

import numpy as np
import pytest
from test_canonical_space import check_frequencies, check_horizon_and_expert

from nppg import Domain, LanguageBias, NppgError, Options, evaluate_exactly, train
from nppg.bridge.files import shipped
from nppg.cli.main import main
from nppg.judging.space import Space
from nppg.rules.distill import distill

TASKS = ["stack", "unstack"]
GOALS = {"stack": factorial, "unstack": lambda blocks: 1}


def of(task: str, blocks: int) -> Domain:
    return Domain("blocks_world", {"task": task, "blocks": blocks})


@pytest.mark.parametrize("blocks", [2, 4, 6])
@pytest.mark.parametrize("task", TASKS)
def test_horizon_and_expert(task: str, blocks: int) -> None:
    space = Space(of(task, blocks))
    assert sum(space.sizes) == {2: 3, 4: 73, 6: 4051}[blocks]
    assert space.starts == sum(space.sizes) - GOALS[task](blocks)
    check_horizon_and_expert(space, longest=blocks - 1)


@pytest.mark.parametrize("task", TASKS)
def test_starts_are_uniform(task: str) -> None:
    domain, rng = of(task, 4), np.random.default_rng(0)
    counts = Counter(domain.start(rng) for _ in range(3000))
    states = 73 - GOALS[task](4)
    assert len(counts) == states
    check_frequencies(counts, dict.fromkeys(counts, 1 / states))


def test_pictures() -> None:
    state = (("on", "b1", "floor"), ("on", "b2", "b1"), ("on", "b3", "floor"))
    assert of("stack", 3).picture(state) == ["b2        ", "b1   b3   ", "goal: all blocks in one tower"]
    assert of("unstack", 3).picture(state)[-1] == "goal: all blocks on the floor"


def test_other_tasks_are_refused() -> None:
    with pytest.raises(NppgError, match=r"start/1 .*on,stack,unstack.*pile"):
        of("pile", 3).start(np.random.default_rng(0))


@pytest.mark.parametrize("command", ["check", "train"])
@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["task=stack"], "task=stack has a language bias of its own: give --bias stack, or --bias blocks_world"),
        (["task=unstack"], "task=unstack has a language bias of its own: give --bias unstack, or --bias blocks_world"),
        (["task=stack", "--bias", "blocks_world"], "goal_on/2 is the goal template of the language bias and must have"),
        (["task=pile"], "start/1 threw Type error: `oneof([on,stack,unstack])' expected, found `pile'"),
        (["task=3"], "the parameter task must be a name, not 3"),
    ],
)
def test_a_task_wants_its_bias(
    command: str,
    options: list[str],
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([command, "blocks_world", "--set", *options]) == 2
    output = capsys.readouterr()
    assert message in output.err and output.err.count("\n") == 1 and not output.out


@pytest.mark.parametrize(
    ("task", "bias", "told"),
    [
        ("on", "stack", "stack is for task=stack, but task is on: give --set task=stack"),
        ("stack", "unstack", "unstack is for task=unstack, but task is stack: give --set task=unstack"),
        ("stack", "stack", ""),
        ("on", "blocks_world_relational", ""),
    ],
)
def test_a_bias_wants_its_task(task: str, bias: str, told: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "blocks_world", "--set", f"task={task}", "--bias", bias]) == 0
    assert capsys.readouterr().err == (f"warning: the language bias {told}\n" if told else "")


def test_a_domain_that_takes_any_text_says_nothing_of_its_biases(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (shipped("domains") / "delivery.pl").read_text()
    file = tmp_path / "mail.pl"
    file.write_text(text.replace(":- parameter(rooms", ":- parameter(who, me).\n:- parameter(rooms", 1))
    assert main(["check", str(file), "--bias", "delivery"]) == 0
    assert capsys.readouterr().err == ""


def test_a_bias_beside_the_domain_goes_by_its_path(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    mine = tmp_path / "mine.pl"
    mine.write_bytes((shipped("domains") / "blocks_world.pl").read_bytes())
    for name, source in {"mine": "blocks_world", "stack": "stack"}.items():
        (tmp_path / f"{name}.yaml").write_bytes((shipped("language_bias") / f"{source}.yaml").read_bytes())
    assert main(["check", str(mine), "--set", "task=on"]) == 0
    assert main(["check", str(mine), "--set", "task=unstack"]) == 2
    assert "goal_on/2" in capsys.readouterr().err
    assert main(["check", str(mine), "--set", "task=stack"]) == 2
    assert f"give --bias {tmp_path}/stack.yaml, or --bias {tmp_path}/mine.yaml\n" in capsys.readouterr().err
    assert main(["check", str(mine), "--set", "task=stack", "--bias", str(tmp_path / "stack.yaml")]) == 0


@pytest.mark.parametrize("step", ["gradient", "second-order"])
@pytest.mark.parametrize("task", TASKS)
def test_few_rules_are_learned(task: str, step: str) -> None:
    bias = LanguageBias.load(shipped("language_bias") / f"{task}.yaml")
    domain = of(task, 5)
    assert bias.check(domain.predicates, domain.actions) == []
    *_, last = train(domain, bias, Options(episodes=200, step=step))
    rules = distill(last.policy, bias)
    assert len(rules.rules(1)) <= 4
    assert evaluate_exactly(rules, greedy=True).success == 1


PAGE = (Path(__file__).parent.parent / "docs" / "tasks.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("task", TASKS)
def test_the_page_shows_what_the_commands_print(
    task: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    ten = PAGE.partition("## Other numbers of blocks")[0]
    for command, shown in re.findall(rf"^\$ nppg (.*runs/{task}\b.*)\n((?:[^$`].*\n)*)", ten, re.MULTILINE):
        assert main(command.split()) == 0
        printed = capsys.readouterr().out
        assert printed == shown or (not shown and command.startswith("train"))
    run = json.loads(Path(f"runs/{task}/run.json").read_text())
    row = re.search(rf"^\| `{task}` \| (300 .*)", PAGE, re.MULTILINE)
    rules = Path(f"runs/{task}/rules.pl").read_text().count("\ndelta(1, ")
    assert row and row[1].startswith(f"300 | {run['trees']} | {run['last']['success']:.6f} | {rules} | 1.000000 | ")
