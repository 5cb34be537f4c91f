"""Calls elsewhere: each done once, whatever is killed under it, and none left behind."""

from __future__ import annotations

import os
import signal
import time
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from nppg import Domain
from nppg.bridge.interrupts import interruptible
from nppg.errors import NppgError
from nppg.experiments.many import Processes, each, in_order


def square(number: int) -> int:
    return number * number


def late_squares(number: int) -> int:
    """The later ones are there first."""
    time.sleep(0.2 if number == 0 else 0)
    return square(number)


def killed_once(marks: Path) -> int:
    if not marks.exists():
        marks.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return 1


def killed(marks: Path) -> None:
    with marks.open("a") as file:
        file.write("x")
    os.kill(os.getpid(), signal.SIGKILL)


def mistaken(folder: Path) -> None:
    while not (folder / "begun").exists():
        time.sleep(0.01)
    raise NppgError("this is wrong")


def endless(folder: Path) -> None:
    """Ends by Ctrl-C alone, and says so."""
    from nppg.bridge.interrupts import heed_interrupt

    (folder / "begun").touch()
    try:
        while True:
            heed_interrupt()
            time.sleep(0.01)
    except KeyboardInterrupt:
        (folder / "ended").touch()
        raise


def warned(number: int) -> None:
    warnings.warn("mind the gap", stacklevel=1)


def opened(name: str) -> Domain:
    return Domain(name)


def done(call: tuple[Callable, object]) -> object:
    function, item = call
    return function(item)


def test_every_call_is_done_and_given_back_with_its_item() -> None:
    assert sorted(each(square, range(5), Processes(2))) == [(n, n * n) for n in range(5)]
    assert list(in_order(late_squares, range(4), Processes(2))) == [0, 1, 4, 9]
    assert list(each(square, [], Processes(2))) == []
    (domain,) = in_order(opened, ["corridor"], Processes(1))
    assert domain.start(np.random.default_rng(0)), "it is unpickled in a thread that can ask Prolog"


def test_a_killed_process_costs_its_call_a_repetition(tmp_path: Path) -> None:
    marks = [tmp_path / "a", tmp_path / "b", tmp_path / "c"]
    assert sorted(each(killed_once, marks, Processes(2))) == [(path, 1) for path in marks]


def test_a_call_that_is_always_killed_is_told(tmp_path: Path) -> None:
    path = tmp_path / "marks"
    with pytest.raises(NppgError, match=r"marks: its process was killed each time it was tried: is there enough mem"):
        list(each(killed, [path], Processes(1)))
    assert path.read_text() == "xxxx"


def test_a_process_that_is_killed_between_two_calls_is_replaced() -> None:
    found = each(os_pid, range(3), Processes(1))
    _, number = next(found)
    os.kill(number, signal.SIGKILL)
    time.sleep(0.1)
    assert len({number, *(other for _, other in found)}) > 1


def os_pid(_: int) -> int:
    return os.getpid()


def test_a_mistake_ends_the_other_calls(tmp_path: Path) -> None:
    with pytest.raises(NppgError, match=r"^this is wrong$"):
        list(each(done, [(endless, tmp_path), (mistaken, tmp_path), (square, 3)], Processes(2)))
    assert (tmp_path / "ended").exists()


def test_an_interrupt_ends_all_calls(tmp_path: Path) -> None:
    """Though it reaches this process alone; and one that comes while they start waits for them."""
    for item in ("later", "at once"):
        folder = tmp_path / item
        folder.mkdir()
        with pytest.raises(KeyboardInterrupt), interruptible():
            calls: list = [(endless, folder), (interrupter, (folder, os.getpid(), item == "later"))]
            list(each(done, calls, Processes(2)))
        assert (folder / "ended").exists() == (folder / "begun").exists()
    assert (tmp_path / "later" / "ended").exists()


def interrupter(call: tuple[Path, int, bool]) -> None:
    folder, parent, waits = call
    while waits and not (folder / "begun").exists():
        time.sleep(0.01)
    os.kill(parent, signal.SIGINT)
    endless(folder)


def test_warnings_are_told_here() -> None:
    with pytest.warns(UserWarning, match=r"^mind the gap$"):
        list(each(warned, [1], Processes(1)))
