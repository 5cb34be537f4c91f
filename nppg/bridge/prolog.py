"""The bridge to SWI-Prolog, and the only importer of janus_swi.

Everything crosses as data: numbers, strings, lists and tuples. Mistakes come back as data too and are
raised as NppgError, so no Prolog exception leaves this module.
"""

from __future__ import annotations

import threading
import weakref
from collections import deque
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from nppg.bridge import home as prolog_home
from nppg.bridge.files import shipped
from nppg.bridge.interrupts import heed_interrupt
from nppg.bridge.watch import COUNT, watch
from nppg.errors import NppgError, Problem, suggestion

prolog_home.prepare()

import janus_swi  # noqa: E402

_STACK_LIMIT = 256 * 2**20

_dropped: deque[tuple] = deque()  # last questions about what Python has dropped
_generator: np.random.Generator | None = None
_thread = threading.local()  # `asks` in the thread in which Prolog was started
_thread.asks = True
_thread_name = threading.current_thread().name


def uniform(count: int) -> list[float] | None:
    """The next numbers of the generator that a domain draws from, None where there is none; called by
    prolog/randomness.pl."""
    if _generator is None:
        return None
    draw = _generator.random
    return [draw() for _ in range(count)]


def check_thread() -> None:
    """Raises NppgError in another thread than the one that started Prolog: there Prolog would end the process, and two
    threads would change the current state in turn."""
    if not hasattr(_thread, "asks"):
        name = threading.current_thread().name
        raise NppgError(
            f"nppg is used in the thread {name}, but can be used only in the one that used it first, {_thread_name}: "
            "have that thread ask, or start a process"
        )


@contextmanager
def randomness(generator: np.random.Generator) -> Iterator[None]:
    """Lets the domain draw from `generator`. Raises NppgError in a thread that cannot ask."""
    global _generator
    check_thread()
    previous, _generator = _generator, generator
    try:
        yield
    finally:
        _generator = previous


def ask(question: str, *args: Any) -> Any:
    """The answer to one of the questions of prolog/bridge.pl.

    Raises NppgError with file and line where the domain's code is at fault, or in another thread than the one in which
    nppg was used first; and KeyboardInterrupt where Ctrl-C was pressed under `interruptible`, unless it is held back by
    `undisturbed`.
    """
    check_thread()
    while _dropped:
        last, *its_args = _dropped.popleft()
        janus_swi.apply_once("nppg_bridge", "ask", last, its_args)
    COUNT[0] += 1
    try:
        done, value = janus_swi.apply_once("nppg_bridge", "ask", question, list(args))
    except janus_swi.PrologError:
        done, value = janus_swi.apply_once("nppg_bridge", "ask", "aborted", [question])
    finally:
        COUNT[0] += 1
    heed_interrupt()
    if not done:
        raise NppgError(_problem(*each) for each in value)
    return value


def _problem(file: str, line: int, column: int, message: str, name: str = "", known: Iterable[str] = ()) -> Problem:
    return Problem(file, line, column, message + suggestion(name, known))


def drop_with(owner: object, question: str, *args: Any) -> None:
    """Has a last question asked, which frees what Prolog holds for `owner`, once Python has dropped it: with the next
    question, for Python drops things at any moment, also between a question that was aborted and asking why."""
    weakref.finalize(owner, _dropped.append, (question, *args)).atexit = False


def _look() -> int:
    """Has the thread that started Prolog look at itself, as soon as Prolog comes by there; how often it has."""
    janus_swi.attach_engine()
    try:
        looked: int = janus_swi.query_once("nppg_guard:look(Looked)")["Looked"]
        return looked
    finally:
        janus_swi.detach_engine()


def _start() -> None:
    janus_swi.query_once("set_prolog_flag(stack_limit, Limit)", {"Limit": _STACK_LIMIT})
    janus_swi.query_once("use_module(File, [])", {"File": str(shipped("prolog") / "bridge.pl")})
    watch(_look)


_start()
