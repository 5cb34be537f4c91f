"""One function called with many items, some at a time: in processes of this machine, or where another pool calls it.

This module starts no Prolog: who calls a function elsewhere may import it in another thread than that of the call.
"""

from __future__ import annotations

import os
import pickle
import signal
import warnings
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, ProcessPoolExecutor, wait
from contextlib import suppress
from multiprocessing import get_context
from typing import Any, NamedTuple, Protocol, TypeVar

from nppg.bridge.interrupts import born_deaf, heed_interrupt, interruptible
from nppg.errors import NppgError

_LOSSES = 3  # processes that may be killed under one call
_PAUSE = 0.1  # seconds until Ctrl-C is heeded

Answer = tuple[bytes, list[str]]  # what `called` gives: bytes, for executors unpickle in threads that ask no Prolog
Item = TypeVar("Item")
Result = TypeVar("Result")


class Lost(Exception):
    """The process of a call has been killed, whether or not the call may be repeated."""

    def __init__(self, repeatable: bool):
        self.repeatable = repeatable


class Worker(Protocol):
    """Does one call at a time."""

    def submit(self, call: bytes) -> Future[Answer]:
        """Has `called` done elsewhere."""

    def result(self, future: Future[Answer]) -> Answer:
        """What the call gave, which has ended. Raises what it raised; or Lost."""

    def interrupt(self) -> None:
        """Has its call end soon."""

    def close(self) -> None:
        """To be called once, at the end."""


class Pool(Protocol):
    """Where calls are done. Those that do not share files see none of this machine's."""

    shares_files: bool

    def open(self, count: int) -> Sequence[Worker]:
        """Workers for so many calls. Raises NppgError."""


def each(function: Callable[[Item], Result], items: Sequence[Item], pool: Pool) -> Iterator[tuple[Item, Result]]:
    """Calls the function with each item, and yields the item with what it gave, as the calls end. Both are pickled.

    A killed process costs its call a repetition. What the calls warn of is told here. Ctrl-C or a mistake in one of
    them ends the others, as Ctrl-C ends them. Raises NppgError, and whatever a call raises."""
    waiting = deque((item, 0) for item in items)
    workers = pool.open(len(items)) if items else []
    free = list(workers)
    running: dict[Future[Answer], tuple[Worker, Item, int]] = {}
    try:
        while waiting or running:
            while waiting and free:
                worker, (item, losses) = free.pop(), waiting.popleft()
                running[worker.submit(pickle.dumps((function, item)))] = worker, item, losses
            for future in wait(running, _PAUSE, FIRST_COMPLETED).done:
                worker, item, losses = running.pop(future)
                free.append(worker)
                try:
                    found, told = worker.result(future)
                except Lost as lost:
                    if not lost.repeatable or losses == _LOSSES:
                        message = f"{item}: its process was killed each time it was tried: is there enough memory?"
                        raise NppgError(message) from None
                    waiting.appendleft((item, losses + 1))
                    continue
                finally:
                    del future  # for which a cluster keeps what it has found
                for message in told:
                    warnings.warn(message, stacklevel=2)
                yield item, pickle.loads(found)
            heed_interrupt()
    except BaseException:
        for worker in workers:
            worker.interrupt()
        raise
    finally:
        for worker in workers:
            worker.close()


def in_order(function: Callable[[Item], Result], items: Sequence[Item], pool: Pool) -> Iterator[Result]:
    """What `each` gives, in the order of the items."""
    found: dict[int, Result] = {}
    ended = each(_done, [_Numbered(function, item, number) for number, item in enumerate(items)], pool)
    for number in range(len(items)):
        while number not in found:
            call, result = next(ended)
            found[call.number] = result
        yield found.pop(number)


class _Numbered(NamedTuple):
    function: Callable[[Any], Any]
    item: Any
    number: int

    def __str__(self) -> str:
        return str(self.item)


def _done(call: _Numbered) -> Any:
    return call.function(call.item)


def called(call: bytes) -> Answer:
    """Calls a pickled function with a pickled item: what it gives, pickled, and what it warns of."""
    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always", UserWarning)
        function, item = pickle.loads(call)
        found = function(item)
    told = (str(each.message) for each in noted if issubclass(each.category, UserWarning))
    return pickle.dumps(found), list(dict.fromkeys(told))


def available_cores() -> int:
    """Those that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Processes:
    """So many processes of this machine."""

    shares_files = True

    def __init__(self, count: int):
        self.count = count

    def open(self, count: int) -> Sequence[Worker]:
        return [_Process() for _ in range(min(self.count, count))]


class _Process:
    """A process that does call after call, and another one after it has been killed. It is spawned, for one that has
    started Prolog cannot be forked. Ctrl-C reaches it in a call alone, and waits for one while it starts."""

    def __init__(self) -> None:
        self._start()

    def _start(self) -> None:
        self._executor = ProcessPoolExecutor(1, get_context("spawn"))
        with born_deaf():
            self._number = self._executor.submit(os.getpid)

    def submit(self, call: bytes) -> Future[Answer]:
        try:
            return self._executor.submit(_called_interruptibly, call)
        except BrokenExecutor:  # killed between two calls
            self.close()
            self._start()
            return self._executor.submit(_called_interruptibly, call)

    def result(self, future: Future[Answer]) -> Answer:
        try:
            return future.result()
        except BrokenExecutor:
            raise Lost(repeatable=True) from None

    def interrupt(self) -> None:
        with suppress(BrokenExecutor, ProcessLookupError):
            os.kill(self._number.result(), signal.SIGINT)

    def close(self) -> None:
        self._executor.shutdown(cancel_futures=True)


def _called_interruptibly(call: bytes) -> Answer:
    with interruptible():
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
        try:
            heed_interrupt()
            return called(call)
        finally:
            signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
