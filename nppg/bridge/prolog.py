"""The bridge to SWI-Prolog, and the only importer of janus_swi.

Everything crosses as data: numbers, strings, lists and tuples. Mistakes come back as data too and are
raised as NppgError, so no Prolog exception leaves this module.
"""

from __future__ import annotations

import os
import threading
import weakref
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import wraps
from typing import Any, TypeVar

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
_Method = TypeVar("_Method", bound=Callable)


class _Engine:
    """What a thread asks Prolog by that has not started it; it is to go in this thread, and with it."""

    def __init__(self) -> None:
        janus_swi.attach_engine()
        janus_swi.query_once("set_prolog_flag(stack_limit, Limit)", {"Limit": _STACK_LIMIT})

    def __del__(self) -> None:
        janus_swi.detach_engine()


class _Exclusive:
    """One thread at a time asks. What it asks within this stands together: no other makes another state current
    meanwhile."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._depth = self._owner = 0
        self._thread = threading.local()  # with what it is known by, and but in the one that starts Prolog an engine
        self._thread.mark = self._latest = object()
        self.engine = 1  # of the thread that has asked last, as Prolog numbers them

    def __enter__(self) -> None:
        self._lock.acquire()
        self._depth += 1
        if self._depth == 1:
            self._owner = threading.get_ident()
            if getattr(self._thread, "mark", None) is not self._latest:
                self._turn()

    def __exit__(self, *_: object) -> None:
        self._depth -= 1
        if not self._depth:
            self._owner = 0
        self._lock.release()

    @property
    def is_own(self) -> bool:
        """Whether this thread is within."""
        return self._owner == threading.get_ident()

    def _turn(self) -> None:
        """Another thread has asked last. The answers that this one's engine keeps in tables may be about states that
        are no longer the current ones."""
        try:
            if not hasattr(self._thread, "mark"):
                self._thread.engine = _Engine()
                self._thread.mark = object()
            self._latest, self.engine = self._thread.mark, janus_swi.engine()
            janus_swi.query_once("abolish_all_tables")
        except BaseException:
            self.__exit__()
            raise

    def forked(self) -> None:
        """In a process that is forked from another, no thread of that one holds the lock."""
        self._lock = threading.RLock()
        self._depth = self._owner = 0


exclusive = _Exclusive()
os.register_at_fork(after_in_child=exclusive.forked)


def exclusively(*names: str) -> Callable[[type], type]:
    """Has these methods and properties of a class run `exclusive`ly: they ask several questions that stand together, or
    remember what they have been asked."""

    def held(method: _Method) -> _Method:
        @wraps(method)
        def run(*args: Any, **keywords: Any) -> Any:
            if exclusive.is_own:
                return method(*args, **keywords)
            with exclusive:
                return method(*args, **keywords)

        return run  # type: ignore[return-value]

    def changed(kind: type) -> type:
        for name in names:
            found = vars(kind)[name]
            setattr(kind, name, property(held(found.fget)) if isinstance(found, property) else held(found))  # type: ignore[type-var]
        return kind

    return changed


def uniform(count: int) -> list[float] | None:
    """The next numbers of the generator that a domain draws from, None where there is none; called by
    prolog/randomness.pl."""
    if _generator is None:
        return None
    draw = _generator.random
    return [draw() for _ in range(count)]


@contextmanager
def randomness(generator: np.random.Generator) -> Iterator[None]:
    """Lets the domain draw from `generator`, in what is done `exclusive`ly. Raises NppgError where it is none."""
    global _generator
    if not isinstance(generator, np.random.Generator):
        raise NppgError(f"{generator!r} is no generator of random numbers: np.random.default_rng(seed) is one")
    previous, _generator = _generator, generator
    try:
        yield
    finally:
        _generator = previous


def ask(question: str, *args: Any) -> Any:
    """The answer to one of the questions of prolog/bridge.pl.

    Any thread may ask. Raises NppgError with file and line where the domain's code is at fault; and KeyboardInterrupt
    where Ctrl-C was pressed under `interruptible`, unless it is held back by `undisturbed`.
    """
    with exclusive:
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
    """Has the thread that is asking look at itself, as soon as Prolog comes by there; how often it has."""
    janus_swi.attach_engine()
    try:
        looked: int = janus_swi.query_once("nppg_guard:look(Engine, Looked)", {"Engine": exclusive.engine})["Looked"]
        return looked
    finally:
        janus_swi.detach_engine()


def _start() -> None:
    janus_swi.query_once("set_prolog_flag(stack_limit, Limit)", {"Limit": _STACK_LIMIT})
    janus_swi.query_once("use_module(File, [])", {"File": str(shipped("prolog") / "bridge.pl")})
    watch(_look)


_start()
