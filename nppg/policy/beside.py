"""A process beside this one that holds a copy of a policy and works with it, while this one goes on.

What works there is a servant: an object that has the policy and does its work when it is called. It is sent once, and
with each question what the policy has come by since: new tests of its table, new trees.
"""

from __future__ import annotations

import pickle
import signal
import sys
import time
import warnings
from collections.abc import Sequence
from contextlib import suppress
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from subprocess import DEVNULL, Popen
from typing import Any, Protocol

from nppg.bridge.interrupts import born_deaf, heed_interrupt
from nppg.logic.query import Query
from nppg.policy.policy import Policy
from nppg.trees.tree import Tree

_PATIENCE = 1.0  # seconds of work in this process after which others are started
_TICK = 0.1  # seconds between two looks for Ctrl-C


class Gone(Exception):
    """The process has failed: what it was asked is for this one to do, and so to tell what is wrong, if anything is."""


class Servant(Protocol):
    """Works with a policy. It can be pickled."""

    policy: Policy

    def __call__(self, *args: Any) -> Any: ...


class Beside:
    """A process that a servant works in. Starting it takes about a second, for which nobody waits: until it is `free`
    there is nothing to ask. Raises Gone wherever it is found to have failed."""

    def __init__(self, servant: Servant):
        self._servant = servant
        self._sent: tuple[int, int] | None = None  # tests and trees, once the servant is there
        self._answered = False  # whether nothing is under way there
        self._connection, other = Pipe()
        number = other.fileno()
        program = f"import sys; sys.path[:] = {sys.path!r}; from {__name__} import serve; serve({number})"
        with other, born_deaf():  # a process of its own: one that has started Prolog cannot be forked
            self._process = Popen([sys.executable, "-c", program], stdin=DEVNULL, stdout=DEVNULL, pass_fds=[number])

    @property
    def free(self) -> bool:
        """Whether it can be asked."""
        if not self._answered and self._sent is None and self._there(0.0):
            self._received()
        return self._answered

    def ask(self, *args: Any) -> None:
        """Has the servant called with its policy as it is now; to be asked only while it is `free`."""
        policy = self._servant.policy
        known = (len(policy.table), len(policy.trees))
        if self._sent is None:
            content: tuple = (self._servant, [], [], args)
        else:
            content = (None, policy.table.tests[self._sent[0] :], policy.trees[self._sent[1] :], args)
        try:
            self._connection.send_bytes(pickle.dumps(content))
        except Exception as error:  # pickling raises many kinds
            raise Gone from error
        self._sent, self._answered = known, False

    def answer(self) -> Any:
        """What the servant has given back, once it has; Ctrl-C is heeded meanwhile."""
        while not self._there(_TICK):
            heed_interrupt()
        return self._received()

    def answers_by(self, moment: float) -> bool:
        """Whether there is an answer by a moment of time.monotonic."""
        return self._there(max(0.0, moment - time.monotonic()))

    def close(self) -> None:
        """Ends the process, whatever it is at."""
        self._connection.close()
        self._process.kill()
        self._process.wait()

    def _there(self, seconds: float) -> bool:
        try:
            return self._connection.poll(seconds)
        except OSError as error:
            raise Gone from error

    def _received(self) -> Any:
        try:
            done, value = pickle.loads(self._connection.recv_bytes())
        except (EOFError, OSError, pickle.PickleError) as error:
            raise Gone from error
        if not done:
            raise Gone
        self._answered = True
        return value


class Others:
    """Up to `count` processes for a servant's work. They are started once this one has worked for long enough to make
    it worth while; none is started in the place of one that has failed."""

    def __init__(self, servant: Servant, count: int):
        self.count = count
        self._servant = servant
        self._processes: list[Beside] = []
        self._seconds = 0.0

    def worked(self, seconds: float) -> None:
        """Notes that this process has."""
        self._seconds += seconds
        if self._seconds > _PATIENCE and len(self._processes) < self.count:
            with suppress(OSError):  # there may be no room for more
                while len(self._processes) < self.count:
                    self._processes.append(Beside(self._servant))
            self.count = len(self._processes)

    def free(self) -> list[Beside]:
        """Those that can be asked."""
        found = []
        for each in list(self._processes):
            try:
                found += [each] if each.free else []
            except Gone:
                self.lost(each)
        return found

    def asked(self, process: Beside, *args: Any) -> bool:
        """Whether a free process has been asked, and not failed."""
        try:
            process.ask(*args)
        except Gone:
            self.lost(process)
            return False
        return True

    def lost(self, process: Beside) -> None:
        """Notes that it has failed."""
        process.close()
        self._processes = [each for each in self._processes if each is not process]
        self.count = len(self._processes)

    def close(self) -> None:
        """Ends them."""
        for each in self._processes:
            each.close()


def serve(number: int) -> None:
    """What the process does until nobody is there any more to ask it, by the connection of this number."""
    connection = Connection(number)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    warnings.simplefilter("ignore")  # they have been told
    servant: Servant | None = None
    answer: tuple[bool, Any] = (True, None)
    while True:
        try:
            connection.send_bytes(pickle.dumps(answer))
            sent, tests, trees, args = pickle.loads(connection.recv_bytes())
        except (EOFError, OSError):
            return
        except Exception:
            answer = (False, None)
            continue
        servant = sent or servant
        assert servant
        try:
            _learn(servant.policy, tests, trees)
            answer = (True, servant(*args))
        except Exception:
            answer = (False, None)


def _learn(policy: Policy, tests: Sequence[Query], trees: Sequence[Tree]) -> None:
    policy.table.add(tests)
    for tree in trees:
        policy.add(tree)
