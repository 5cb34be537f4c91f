"""nppg answers in the thread that used it first; others are told so."""

from __future__ import annotations

import contextlib
import subprocess
import sys
import threading
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest

from nppg import Domain, NppgError, Options, Policy, evaluate, generate_episode, language_bias_of, train
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
def test_another_thread_is_told_where_to_ask(name: str) -> None:
    world()
    told = elsewhere(QUESTIONS[name])
    assert isinstance(told, NppgError)
    assert str(told) == (
        "nppg is used in the thread other, but can be used only in the one that used it first, MainThread: "
        "have that thread ask, or start a process"
    )
    QUESTIONS[name]()


def test_threads_do_not_disturb_the_one_that_asks() -> None:
    def episodes() -> list:
        return [generate_episode(world()[1], np.random.default_rng(seed)).last for seed in range(40)]

    expected, stop, wrong = episodes(), threading.Event(), []

    def disturb() -> None:
        while not stop.is_set():
            for name in ("start", "situation", "act"):
                with contextlib.suppress(NppgError):
                    wrong.append(QUESTIONS[name]())

    threads = [threading.Thread(target=disturb) for _ in range(3)]
    for each in threads:
        each.start()
    try:
        found = [episodes() for _ in range(3)]
    finally:
        stop.set()
        for each in threads:
            each.join()
    assert found == [expected] * 3 and not wrong


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
    first, second, main = result.stdout.splitlines()
    assert (result.returncode, result.stderr, first) == (0, "", "[11, 11]")
    assert "in the thread second, but" in second and "in the thread MainThread, but" in main
    assert second.endswith(main[main.index("can be used") :]) and "used it first, first:" in main
