"""A domain's code that waits, or that hangs in one operation after the other, is stopped: time is limited, too."""

from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import pytest

from nppg import Domain, NppgError

WAITS = """\
:- module(waits, []).
:- fluent at/1.
start([at(1)]).
action(go).
effect(_, [at(X)], [at(Y)]) :- at(X), Y is X + 1.
goal :- at(5), catch(sleep(600), _, true).
reward(_, 0) :- \\+ at(3), !.
reward(_, 0) :- repeat, catch(sleep(1), _, true), fail.
sleep(dog, 3).
"""


@pytest.fixture
def waits(tmp_path: Path) -> Domain:
    path = tmp_path / "waits.pl"
    path.write_text(WAITS)
    return Domain(path, trust=True)


def test_a_goal_that_sleeps_is_stopped(waits: Domain) -> None:
    with pytest.raises(NppgError, match=r"waits.pl:6: goal/0 .*seconds"):
        waits.situation((("at", 5),))
    assert waits.situation((("at", 4),)).status == "running", "what is asked then is answered"


def test_so_is_one_that_catches_what_stops_it_in_another_thread(waits: Domain) -> None:
    told: list[str] = []

    def act() -> None:
        try:
            waits.act((("at", 2),), "go", np.random.default_rng(0))
        except NppgError as error:
            told.append(str(error))

    thread = threading.Thread(target=act)
    thread.start()
    thread.join()
    assert len(told) == 1 and "reward/2 " in told[0] and "seconds" in told[0]
    assert waits.act((("at", 1),), "go", np.random.default_rng(0))[0] == 0


def test_a_domain_may_have_a_predicate_of_that_name(tmp_path: Path) -> None:
    path = tmp_path / "naps.pl"
    for more in (":- fluent sleep/1.\n", "sleep(dog).\n", ":- dynamic sleep/1.\n"):
        path.write_text(WAITS.replace("sleep(600)", "true").replace("sleep(1)", "true").replace("waits", "naps") + more)
        assert Domain(path).situation((("at", 1),)).status == "running"
