"""Ctrl-C, which is not to hit while Prolog runs: it is noted, and heeded between two questions."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager

_interrupted = False
_undisturbed = 0  # pieces of work that are not to be interrupted


def _in_main_thread() -> bool:
    return threading.current_thread() is threading.main_thread()


def heed_interrupt() -> None:
    """Raises KeyboardInterrupt where Ctrl-C was pressed under `interruptible`, unless it is held back. `ask` does so;
    what asks nothing for long calls it now and then."""
    global _interrupted
    if _interrupted and not _undisturbed and _in_main_thread():
        _interrupted = False
        raise KeyboardInterrupt


@contextmanager
def interruptible() -> Iterator[None]:
    """Lets Ctrl-C end the program only between two questions, never while Prolog runs or calls back, where raising
    can crash it; or at the end. Every question ends, because domain code is held to an inference limit. Python tells
    the main thread alone of Ctrl-C: in another this does nothing."""
    global _interrupted

    if not _in_main_thread():
        yield
        return

    def note(*_: object) -> None:
        global _interrupted
        _interrupted = True

    previous = signal.signal(signal.SIGINT, note)
    try:
        yield
        if _interrupted:
            raise KeyboardInterrupt
    finally:
        signal.signal(signal.SIGINT, previous)
        _interrupted = False


@contextmanager
def undisturbed() -> Iterator[None]:
    """Holds an interrupt back until a piece of work, such as saving, is done; a later question raises it."""
    global _undisturbed
    _undisturbed += 1
    try:
        yield
    finally:
        _undisturbed -= 1


@contextmanager
def born_deaf() -> Iterator[None]:
    """Processes that are started meanwhile hold Ctrl-C back until they say otherwise: on the terminal it is for the one
    that starts them."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
