"""A watch over questions that take long: domain code that is over its time is stopped, or the process that is its own.

A thread of Python looks on. It has the thread that asks look at itself (`overdue` in prolog/guard.pl), which works
wherever Prolog comes by; not within one operation, such as a product of enormous numbers, that never ends.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable

_TICK = 0.5  # seconds
_PATIENCE = 2  # ticks until a question is looked at
_STUCK = 7  # ticks without an answer to that, after which a process of its own is ended
_WAKE = signal.SIGURG

#: How often a question has begun or ended: odd while one is being answered.
COUNT = [0]


def watch(look: Callable[[], int]) -> None:
    """Starts the watch over this thread. `look` has it look at itself soon, and tells how often it has done so. A
    signal that nobody uses, if so it is, wakes it where it sleeps."""
    wakes = threading.current_thread() is threading.main_thread() and signal.getsignal(_WAKE) is signal.SIG_DFL
    if wakes:
        signal.signal(_WAKE, lambda *_: None)
    args = (look, threading.get_ident() if wakes else 0)
    threading.Thread(target=_watch, args=args, name="nppg-watch", daemon=True).start()


def _watch(look: Callable[[], int], asleep: int) -> None:
    pause = threading.Event()
    question = ticks = looked = unanswered = 0
    while not pause.wait(_TICK):
        if COUNT[0] != question or not question % 2:
            question, ticks, looked, unanswered = COUNT[0], 0, -1, 0
            continue
        ticks += 1
        if ticks >= _PATIENCE:
            before, looked = looked, look()
            if asleep:
                signal.pthread_kill(asleep, _WAKE)
            unanswered = unanswered + 1 if looked == before else 0
            if unanswered >= _STUCK and os.environ.get("NPPG_ISOLATED") == "1":  # see nppg.cli.isolating
                print("the domain's code hangs in one operation: the process is ended", file=sys.stderr, flush=True)
                os._exit(2)
