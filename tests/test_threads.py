"""nppg answers in every thread, one at a time."""

from __future__ import annotations

import subprocess
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

import janus_swi
import numpy as np
import pytest

from nppg import Domain, Options, Policy, evaluate, generate_episode, language_bias_of, train
from nppg.bridge.interrupts import interruptible
from nppg.bridge.terms import texts
from nppg.worlds.world import State


@cache
def world() -> tuple[Domain, Policy, State]:
    """Made when it is first asked for, in the thread of the tests."""
    domain = Domain("blocks_world", {"blocks": 4})
    return domain, Policy(domain, language_bias_of(domain)), domain.start(np.random.default_rng(0))


def act(domain: Domain, _: Policy, state: State) -> object:
    return domain.act(state, domain.situation(state).actions[0], np.random.default_rng(0))


QUESTIONS: dict[str, Callable[[], object]] = {
    "load": lambda: Domain("delivery"),
    "start": lambda: world()[0].start(np.random.default_rng(0)),
    "situation": lambda: world()[0].situation(world()[2]),
    "act": lambda: act(*world()),
    "texts": lambda: texts(["a"]),
    "episode": lambda: generate_episode(world()[1], np.random.default_rng(0)),
    "evaluate": lambda: evaluate(world()[1], 2),
    "train": lambda: list(train(world()[0], world()[1].bias, Options(episodes=2))),
}


def elsewhere(question: Callable[[], object]) -> object:
    """What another thread is answered, or told."""
    found: list[object] = []

    def ask() -> None:
        try:
            found.append(question())
        except Exception as error:
            found.append(error)

    thread = threading.Thread(target=ask, name="other")
    thread.start()
    thread.join(120)
    return found[0]


@pytest.mark.parametrize("name", QUESTIONS)
def test_another_thread_is_answered_the_same(name: str) -> None:
    world()
    expected = QUESTIONS[name]()
    found = elsewhere(QUESTIONS[name])
    assert type(found) is type(expected)
    if name not in ("load", "train", "episode"):
        assert found == expected == QUESTIONS[name]()


def episodes(policy: Policy, seeds: range) -> list:
    return [generate_episode(policy, np.random.default_rng(seed)).actual for seed in seeds]


TABLED = """\
:- module(steps, []).
:- fluent at/1, edge/2.
:- table path/2.
start(Facts) :- findall(edge(X, Y), ( between(1, 6, X), random_between(1, 7, Y) ), Edges), Facts = [at(1)|Edges].
action(go(Y)) :- at(X), path(X, Y).
action(stay).
path(X, Y) :- edge(X, Y).
path(X, Y) :- path(X, Z), edge(Z, Y).
effect(go(Y), [at(X)], [at(Y)]) :- at(X).
effect(stay, [edge(X, Y)], []) :- findall(A-B, edge(A, B), All), msort(All, [X-Y|_]).
effect(stay, [], []) :- \\+ edge(_, _).
terminal :- at(7).
horizon(10).
"""
BIAS = "action: [stay, go(+place)]\ntypes: {at: [place], path: [place, place]}\nmodes: ['path(+place, 7)']\n"


@pytest.mark.parametrize("shared", [True, False])
def test_threads_at_the_same_time(shared: bool, tmp_path: Path) -> None:
    """Whether they share a domain or not, also one with tables, each is answered as if it were alone."""
    path = tmp_path / "steps.pl"
    path.write_text(TABLED)
    path.with_suffix(".yaml").write_text(BIAS)

    def made() -> list[Policy]:
        domains = [Domain("blocks_world", {"blocks": 4}), Domain(path)]
        return [Policy(each, language_bias_of(each)) for each in domains]

    policies = made()
    parts = [range(12 * i, 12 * i + 12) for i in range(4)]
    expected = [[episodes(policy, part) for policy in policies] for part in parts]
    found: list[list] = [[] for _ in parts]

    def play(number: int, own: list[Policy]) -> None:
        found[number] = [[episodes(policy, range(seed, seed + 1))[0] for seed in parts[number]] for policy in own]

    threads = [threading.Thread(target=play, args=(i, policies if shared else made())) for i in range(4)]
    switching = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    try:
        for each in threads:
            each.start()
        for each in threads:
            each.join()
    finally:
        sys.setswitchinterval(switching)
    assert found == expected


def test_learning_in_several_threads(tmp_path: Path) -> None:
    def learned(seed: int) -> list:
        domain = Domain("blocks_world", {"blocks": 3})
        options = Options(episodes=30, min_examples=10, seed=seed)
        *_, last = train(domain, language_bias_of(domain), options)
        return last.policy.trees

    with ThreadPoolExecutor(3) as pool:
        assert list(pool.map(learned, range(3))) == [learned(seed) for seed in range(3)]


def test_threads_that_have_ended_leave_nothing() -> None:
    world()
    count = {"truth": True, "N": 0}
    for _ in range(30):
        elsewhere(QUESTIONS["start"])
    assert janus_swi.query_once("statistics(threads, N)")["N"] < 5, count


def test_a_forked_process_is_answered(tmp_path: Path) -> None:
    """While another thread of the first one asks."""
    world()
    result = subprocess.run([sys.executable, "-c", FORKED], capture_output=True, text=True, timeout=120)
    assert (result.returncode, result.stdout) == (0, "[11, 11]\n"), result.stderr


FORKED = """
import multiprocessing, nppg, numpy as np, warnings
def start(seed):
    return len(domain.start(np.random.default_rng(seed)))
domain = nppg.Domain("blocks_world")
with multiprocessing.get_context("fork").Pool(2) as pool:
    print(pool.map(start, range(2)))
"""


def test_another_thread_is_not_interrupted() -> None:
    def work() -> str:
        with interruptible():
            return "done"

    assert elsewhere(work) == "done"


PROGRAM = """
import threading

def use(times):
    import nppg, numpy as np
    try:
        domain = nppg.open_domain("blocks_world")
        print([len(domain.start(np.random.default_rng(0))) for _ in range(times)])
    except nppg.NppgError as error:
        print(error)

for name in ("first", "second"):
    thread = threading.Thread(target=use, args=(2,), name=name)
    thread.start()
    thread.join()
use(1)
"""


def test_the_first_thread_need_not_be_the_main_one() -> None:
    """Nor need it live: the process ends as it should."""
    result = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, timeout=120)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.splitlines() == ["[11, 11]", "[11, 11]", "[11]"]
