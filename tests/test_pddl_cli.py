"""PDDL from the command line: imported, learned in, judged problem by problem, planned in; and what goes wrong."""

from __future__ import annotations

import csv
import json
from io import StringIO
from pathlib import Path

import numpy as np
import pytest

from nppg import Policy, generate_episode, language_bias_of, open_domain
from nppg.cli.main import main
from nppg.judging.problems import attempts
from nppg.worlds.opening import with_problems

LIBRARY = Path(__file__).parent.parent / "examples" / "library"
DOMAIN = str(LIBRARY / "domain.pddl")
PROBLEMS = [str(LIBRARY / f"p0{i}.pddl") for i in range(1, 6)]
MODEL = "runs/library/model.pl"


@pytest.fixture(scope="module")
def learned(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("learned")
    arguments = ["--output", str(folder / "runs" / "library"), "--episodes", "150", "--evaluate-every", "0", "--quiet"]
    assert main(["train", DOMAIN, "--problems", *PROBLEMS, *arguments]) == 0
    return folder


@pytest.fixture
def model(learned: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.chdir(learned)
    return MODEL


def test_the_folder_of_a_run_has_all_that_the_model_needs(model: str) -> None:
    names = {path.name for path in Path(model).parent.iterdir()}
    own = {"domain.pddl", "library.pl", "library.yaml", "library_problems.pl"}
    assert names == own | {"model.pl", "run.json", "checkpoint.json"}
    assert main(["train", DOMAIN, "--problems", *PROBLEMS[:2], "--episodes", "1", "--quiet", "--output", "again"]) == 0
    assert main(["train", DOMAIN, "--problems", *PROBLEMS[:3], "--episodes", "1", "--quiet", "--output", "again"]) == 0


def test_problems_are_judged_one_by_one(model: str, capsys: pytest.CaptureFixture[str]) -> None:
    files = sorted(map(str, LIBRARY.glob("*.pddl")))  # the domain among them
    assert main(["evaluate", model, "--problems", *files]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 13 and lines[0].startswith("p01") and lines[-1].endswith(" of 12")
    assert main(["evaluate", model, "--problems", *files, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["problems"] == 12 and found["solved"] == sum(each["ended"] == "solved" for each in found["list"])
    assert found["solved"] >= 5
    assert main(["evaluate", model, "--problems", "1-2,4", "--csv"]) == 0
    rows = list(csv.DictReader(StringIO(capsys.readouterr().out)))
    assert [row["name"] for row in rows] == ["p01", "p02", "p04"]


def test_what_takes_too_long_is_not_solved(model: str, capsys: pytest.CaptureFixture[str]) -> None:
    def ends(*options: str) -> list[tuple[str, int]]:
        assert main(["evaluate", model, "--problems", *PROBLEMS, "--json", *options]) == 0
        return [(each["ended"], each["steps"]) for each in json.loads(capsys.readouterr().out)["list"]]

    assert ends("--seconds", "1e-9") == [("time", 0)] * len(PROBLEMS)
    assert ends("--seconds", "1000") == ends()


def test_a_plan_is_printed_or_what_stopped_it(model: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["plan", model, PROBLEMS[2]]) == 0
    *steps, cost = capsys.readouterr().out.splitlines()
    assert all(step.startswith(("(push ", "(take ", "(put ")) for step in steps)
    assert cost == f"; cost = {len(steps)} (unit cost)"
    assert main(["plan", model, PROBLEMS[2], "--output", "plan.txt"]) == 0
    assert Path("plan.txt").read_text().splitlines() == [*steps, cost]
    assert main(["plan", model, PROBLEMS[2], "--horizon-factor", "0.05"]) == 1
    said = capsys.readouterr()
    assert said.out == "" and said.err.startswith("no plan: ")


def test_without_revisits_no_state_comes_twice_while_there_is_another(model: str) -> None:
    policy = Policy.load(model)
    domain = policy.domain = with_problems(policy.domain, [], [LIBRARY / "p07.pddl"])
    for greedy in (True, False):
        episode = generate_episode(policy, np.random.default_rng(0), greedy=greedy, revisits=False)
        met = set()
        for step, following in zip(
            episode.steps, [*(step.actual for step in episode.steps[1:]), episode.actual], strict=True
        ):
            met.add(tuple(step.actual))
            if tuple(following) in met:
                assert all(tuple(domain.certain(step.actual, action)) in met for action in step.actions)
        assert len(met) > len(episode.steps) // 2


def test_what_a_greedy_policy_avoids_is_counted_however_it_is_told_to_act(model: str) -> None:
    policy = Policy.load(model)
    policy.domain = with_problems(policy.domain, [], [LIBRARY / "p01.pddl", LIBRARY / "p02.pddl"])
    for tree in [*policy.trees]:
        policy.add(tree, -3.0)  # so that it prefers what is worst
    told = [each.avoided for each in attempts(policy, revisits=False)]
    assert any(told) and not any(each.avoided for each in attempts(policy, greedy=False, revisits=False))
    policy.greedy = True
    assert [each.avoided for each in attempts(policy, greedy=False, revisits=False)] == told


def test_an_imported_folder_is_a_domain_like_any_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["import", DOMAIN, *PROBLEMS, "--output", "own"]) == 0
    assert "5 problems" in capsys.readouterr().out
    assert main(["import", DOMAIN, *PROBLEMS, "--output", "own"]) == 0, "the same files may be written again"
    assert main(["check", "own/library.pl"]) == 0
    file = Path("own/library.pl")
    file.write_text(file.read_text() + "\nlost(Book) :- at(Book, Shelf), \\+ goal_at(Book, Shelf).\n")
    capsys.readouterr()
    assert main(["import", DOMAIN, *PROBLEMS, "--output", "own"]) == 2
    assert "own/library.pl: exists already and is left as it is" in capsys.readouterr().err
    arguments = ["--problems", "1-3", "--episodes", "20", "--quiet", "--output", "run"]
    assert main(["train", "own/library.pl", *arguments]) == 0
    assert main(["evaluate", "run/model.pl", "--problems", PROBLEMS[4]]) == 0, "PDDL's problems can still be read"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["train", DOMAIN], "domain.pddl: the domain needs problems: name them by --problems"),
        (["train", DOMAIN, "--problems", DOMAIN], "this is the domain: name its problems, too"),
        (["train", DOMAIN, "--problems", str(LIBRARY)], "is a folder: name its files"),
        (["train", DOMAIN, "--problems", "nowhere.pddl"], "nowhere.pddl: no such file"),
        (["train", DOMAIN, "--problems", "1", *PROBLEMS], "chosen by numbers or given as files, not both"),
        (["train", "blocks_world", "--problems", "1"], "there is no problem 1; the domain has no problems"),
        (["train", "blocks_world", "--problems", "9-2"], "9-2 ends before it begins"),
        (["train", "gym:FrozenLake-v1", "--problems", "1"], "an environment of Gymnasium has no problems"),
        (["import", PROBLEMS[0]], "a domain is expected, not a problem"),
        (["import", "nowhere.pddl"], "nowhere.pddl"),
        (["train", DOMAIN, "--problems", "1-99999999999"], "are more than 100,000 problems"),
        (["evaluate", DOMAIN, "--problems", PROBLEMS[0]], "is PDDL and no model: nppg train writes one"),
        (["plan", MODEL, "1-3"], "1-3 has 3 problems; a plan is for one"),
        (["plan", MODEL, "99"], "there is no problem 99; the domain has problems 1 to 5"),
        (["evaluate", MODEL, "--csv"], "--csv is for problems"),
        (["evaluate", MODEL, "--exact", "--problems", "1"], "--exact is about all start states"),
    ],
    ids=lambda value: " ".join(Path(each).name for each in value) if isinstance(value, list) else None,
)
def test_mistakes_are_one_line(model: str, arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments) == 2
    error = capsys.readouterr().err
    assert said in error and error.count("\n") == 1 and "Traceback" not in error


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("(:domain library)", "(:domain ferry)"), ":2:"),
        (("- book", "- boook"), "boook"),
        (("(cart-empty)", "(cart-empty b1)"), "cart-empty"),
        (("(:goal (and (at b1", "(:goal (and (cart-at b1"), ":5:"),
        (("(:goal (and", "(:goal (and (not (cart-empty)) (missing b1)"), "missing"),
    ],
    ids=["another domain", "a type", "an arity", "an argument", "a predicate"],
)
def test_a_problem_with_a_mistake_is_told_with_its_place(
    change: tuple[str, str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "wrong.pddl"
    file.write_text(Path(PROBLEMS[0]).read_text().replace(*change))
    assert main(["train", DOMAIN, "--problems", PROBLEMS[1], str(file)]) == 2
    error = capsys.readouterr().err
    assert f"{file}:" in error and said in error and "Traceback" not in error


def test_a_goal_about_all_objects_is_one_about_each(tmp_path: Path) -> None:
    domain, problem = tmp_path / "domain.pddl", tmp_path / "p.pddl"
    domain.write_text(
        "(define (domain lamps) (:requirements :adl) (:types lamp) (:predicates (lit ?l - lamp) (old ?l - lamp))"
        " (:action press :parameters (?l - lamp) :effect (lit ?l)))"
    )
    goal = "(forall (?l - lamp) (and (lit ?l) (not (old ?l))))"
    problem.write_text(f"(define (problem p) (:domain lamps) (:objects a b - lamp) (:init) (:goal {goal}))")
    opened = open_domain(domain, problems=problem)
    static = opened.problem(1).static.facts
    assert {("goal_lit", "a"), ("goal_lit", "b"), ("goals", 4)} <= set(static)
    assert ("condition", ("not", ("holds", ("old", "a")))) in static
    assert "todo_lit(-)" in language_bias_of(opened).source.decode()


def test_a_model_without_its_domain(model: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "model.pl").write_bytes(Path(model).read_bytes())
    assert main(["evaluate", str(tmp_path / "model.pl")]) == 2
    assert "the model's domain is missing: library.pl has to stand beside it" in capsys.readouterr().err


def test_a_goal_that_no_action_can_reach(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    domain, problem = tmp_path / "domain.pddl", tmp_path / "p.pddl"
    domain.write_text("(define (domain d) (:predicates (lit) (on)) (:action press :effect (on)))")
    problem.write_text("(define (problem p) (:domain d) (:init) (:goal (and (on) (lit))))")
    assert main(["import", str(domain), str(problem), "--output", str(tmp_path / "out")]) == 2
    error = capsys.readouterr().err
    assert f"{problem}:1:41: the goal (lit) cannot be reached: it does not hold, and no action adds lit" in error
    assert not (tmp_path / "out").exists()
