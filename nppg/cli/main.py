"""The command line's way in: Ctrl-C is noted from the first moment on, so nothing else is loaded before."""

from __future__ import annotations

import signal
import sys
from collections.abc import Sequence
from importlib import import_module

from nppg.bridge.interrupts import interruptible


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs one command. Returns the exit status: 0, 2 after a mistake, 130 after Ctrl-C."""
    try:
        with interruptible():
            status: int = import_module("nppg.cli.verbs").run(sys.argv[1:] if arguments is None else arguments)
            return status
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # a second Ctrl-C is not to change the status
        print("interrupted", file=sys.stderr)
        return 130
    except BrokenPipeError:
        sys.stderr.close()
        return 0
