"""Files of strangers: what is not trusted runs nothing but what a domain needs, and is told on one line."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import hostile_files as hostile
import numpy as np
import pytest

from nppg import Domain, LanguageBias, NppgError, Options, train
from nppg.bridge.bounds import bounded, checked


def file(folder: Path, source: str) -> Path:
    """The file in a folder of its own, beside one that it might want to include."""
    (folder / "own").mkdir(exist_ok=True)
    (folder / "evil.pl").write_text("evil.\n")
    path = folder / "own" / "walk.pl"
    path.write_text(source.replace("MARK", str(folder / "mark")))
    return path


def refused(folder: Path, source: str) -> str:
    """What is said of a file that is loaded and played; it must have done nothing, and be told on one line."""
    path = file(folder, source)
    with pytest.raises(NppgError) as caught:
        domain = Domain(path)
        domain.situation(domain.start(np.random.default_rng(0)))
    assert not (folder / "mark").exists()
    assert "\n" not in str(caught.value) and str(caught.value).startswith(str(path))
    return str(caught.value)


@pytest.mark.parametrize("text", hostile.TOP.values(), ids=hostile.TOP)
def test_what_a_file_says_to_prolog(tmp_path: Path, text: str) -> None:
    said = refused(tmp_path, f"{hostile.HEAD}{hostile.REST}{hostile.GOAL}{text}\n")
    assert "--trust" in said or "quasi" in said


@pytest.mark.parametrize("body", hostile.BODY.values(), ids=hostile.BODY)
def test_what_a_clause_calls(tmp_path: Path, body: str) -> None:
    refused(tmp_path, f"{hostile.HEAD}{hostile.REST}goal :- {body}.\n")


@pytest.mark.parametrize("body", hostile.LATER.values(), ids=hostile.LATER)
def test_what_a_clause_makes_and_calls(tmp_path: Path, body: str) -> None:
    refused(tmp_path, f"{hostile.HEAD}{hostile.REST}goal :- {body}.\nown(G) :- call(G, 'touch MARK').\n")


@pytest.mark.parametrize("text", hostile.BOMBS.values(), ids=hostile.BOMBS)
def test_what_is_out_of_bounds(tmp_path: Path, text: str) -> None:
    whole = text if text.startswith("\ufeff") else f"{hostile.HEAD}{hostile.REST}{hostile.GOAL}{text}\n"
    refused(tmp_path, whole)


def test_files_of_the_folder_are_looked_at_too(tmp_path: Path) -> None:
    source = hostile.HEAD + ":- use_module(more).\n:- include(rest).\n" + hostile.REST + "goal :- near(0).\n"
    path = file(tmp_path, source)
    (path.parent / "more.pl").write_text(":- module(walk_more, [near/1]).\nnear(X) :- X > 5.\n")
    (path.parent / "rest.pl").write_text("far(1).\n")
    domain = Domain(path)
    assert domain.situation(domain.start(np.random.default_rng(0))).status == "running"
    (path.parent / "less.pl").write_text(":- module(walk_less, [near/1]).\nnear(X) :- shell(X).\n")
    path.write_text(source.replace("(more)", "(less)"))
    for _ in range(2):
        with pytest.raises(NppgError, match=r"less\.pl:2: shell/1.*--trust"):
            Domain(path)
    (path.parent / "rest.pl").write_text(":- shell(x).\n")
    path.write_text(source)
    with pytest.raises(NppgError, match=r"rest\.pl:1: .*shell.*--trust"):
        Domain(path)
    (path.parent / "rest.pl").write_text("x(" + "(" * 100_000)
    with pytest.raises(NppgError, match="brackets"):
        Domain(path)


def test_a_file_that_is_trusted_may_do_it(tmp_path: Path) -> None:
    path = file(tmp_path, hostile.HEAD + hostile.REST + hostile.GOAL + ":- shell('touch MARK').\n")
    Domain(path, trust=True)
    assert (tmp_path / "mark").exists()


def test_the_command_line_refuses_and_trusts(tmp_path: Path) -> None:
    path = file(tmp_path, hostile.HEAD + hostile.REST + hostile.GOAL + ":- shell('touch MARK').\n")
    path.with_suffix(".yaml").write_text("action: [left, right]\ntypes: {at: [n]}\nmodes: [at(0)]\n")
    check = [sys.executable, "-m", "nppg", "check", str(path)]
    environment = {name: value for name, value in os.environ.items() if name != "NPPG_TRUST"}
    done = subprocess.run(check, capture_output=True, text=True, env=environment)
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and not (tmp_path / "mark").exists()
    done = subprocess.run([*check, "--trust"], capture_output=True, text=True, env=environment)
    assert done.returncode == 0 and (tmp_path / "mark").exists()


def test_a_language_bias_runs_nothing(tmp_path: Path) -> None:
    path = file(tmp_path, hostile.HEAD + hostile.REST + hostile.GOAL)
    bias = tmp_path / "walk.yaml"
    bias.write_text(
        f"action: [left, right]\ntypes: {{shell: [command]}}\nmodes: [\"shell('touch {tmp_path}/mark')\"]\n"
    )
    with pytest.raises(NppgError):
        list(train(Domain(path), LanguageBias.load(bias), Options(episodes=3)))
    assert not (tmp_path / "mark").exists()


@pytest.mark.parametrize("text", hostile.BIASES.values(), ids=hostile.BIASES)
def test_a_language_bias_is_bounded(tmp_path: Path, text: str) -> None:
    bias = tmp_path / "walk.yaml"
    bias.write_text(text.replace("MARK", str(tmp_path / "mark")))
    with pytest.raises(NppgError) as caught:
        LanguageBias.load(bias)
    assert len(str(caught.value)) < 30_000 and not (tmp_path / "mark").exists()


def test_what_a_domain_may_do_besides(tmp_path: Path) -> None:
    source = hostile.HEAD + ":- use_module(library(dcg/basics)).\n:- use_module(walk_besides).\n" + hostile.REST
    goal = "goal :- atom_codes('12', C), phrase(integer(X), C), X is 3 * 2 ** 2, twice(larger(X)), 2 ** 0.5 > 1.\n"
    path = file(tmp_path, source + goal + "larger(X, Y) :- Y > X, at(_).\n")
    more = ":- module(walk_besides, [twice/1]).\n:- meta_predicate twice(1).\n"
    more += "twice(G) :- call(G, 20), maplist(G, [30, 40]).\n"
    (path.parent / "walk_besides.pl").write_text(more)
    domain = Domain(path)
    assert domain.situation(domain.start(np.random.default_rng(0))).status == "goal"


def test_a_goal_that_waits_is_stopped(tmp_path: Path) -> None:
    domain = Domain(file(tmp_path, hostile.HEAD + hostile.REST + "goal :- sleep(60).\n"), trust=True)
    with pytest.raises(NppgError, match="seconds"):
        domain.situation(domain.start(np.random.default_rng(0)))


HANG = "goal :- E = 7 ** (7 ** 10), X is E + 1, X > 3.\n"
MEMORY = "goal :- doubled(34, abcdefgh, _).\ndoubled(0, A, A).\n"
MEMORY += "doubled(N, A, B) :- N > 0, M is N - 1, atom_concat(A, A, C), doubled(M, C, B).\n"


@pytest.mark.parametrize("goal, said", [("goal :- at(0).\n", ""), (HANG, "ended"), (MEMORY, "ended|seconds|memory")])
def test_a_process_of_its_own_can_be_ended(tmp_path: Path, goal: str, said: str) -> None:
    path = file(tmp_path, hostile.HEAD + hostile.REST + goal)
    path.with_suffix(".yaml").write_text("action: [left, right]\ntypes: {at: [n]}\nmodes: [at(0)]\n")
    check = [sys.executable, "-m", "nppg", "check", str(path), "--isolate"]
    done = subprocess.run(check, capture_output=True, text=True)
    assert done.returncode == (2 if said else 0)
    assert done.stderr.count("\n") == (1 if said else 0) and re.search(said, done.stderr)


def test_problems_and_states_are_bounded(tmp_path: Path) -> None:
    domain = Domain(file(tmp_path, hostile.HEAD + hostile.REST + hostile.GOAL))
    deep = "[" * 100_000
    (tmp_path / "problems.pl").write_text(f"problem(a, {deep}")
    with pytest.raises(NppgError, match="brackets"):
        domain.problems_of([tmp_path / "problems.pl"])
    with pytest.raises(NppgError, match="brackets"):
        domain.state(f"at({deep}")


def test_comments_hide_nothing() -> None:
    deep = "(" * 2000
    for text in (
        f"a :- b.\n/* a comment. */\nc({deep}",
        f"c(\n/* a comment.\n */{deep}",
        f"c(/* .\n*/{deep[:900]}/* .\n*/{deep[:900]}",
        f"'a\\\n/*', c({deep}) /* */",
    ):
        with pytest.raises(NppgError, match="brackets"):
            bounded(text.encode(), "text")
    assert not bounded(b"/* a comment.\n ((( */\na(b).\n", "text")


@pytest.mark.parametrize(
    "text",
    [
        "a(')', \"(\", 0'(, `[`, 'it''s (').",
        "% ((((\nb. /* [[[[ */",
        "c :- d, \\+ e, X = [1, 2|_], X \\= f(- 1).",
        "g(1 000 000).",
    ],
)
def test_brackets_that_are_none(text: str) -> None:
    checked(" ".join([text, "\n"] * 1000), "text")
    assert not bounded(text.encode(), "text")
