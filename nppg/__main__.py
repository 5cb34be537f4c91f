"""The program: `nppg`, and `python -m nppg`. Ctrl-C ends it with status 130 from its first line on, so nothing that
takes time is loaded before."""

import os
import sys
from _signal import SIG_IGN, SIGINT, signal  # type: ignore[import-not-found]  # what `signal` is made of


def _end(*_: object) -> None:
    os.write(2, b"interrupted\n")
    os._exit(130)


def run() -> int:
    """Runs the command of the command line: the exit status."""
    from nppg.cli.main import main

    status = main()
    signal(SIGINT, SIG_IGN)  # all is done, and is not to be undone while Python ends
    return status


signal(SIGINT, _end)
if __name__ == "__main__":
    sys.exit(run())
