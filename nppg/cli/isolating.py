"""A command in a process of its own, which can be ended: what hangs or takes all memory takes nothing else along."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from signal import SIG_IGN, SIGINT, SIGTERM, signal
from typing import IO

from nppg.errors import NppgError

MEMORY = 4 * 2**30  # bytes of the process
_VARIABLE = "NPPG_ISOLATED"  # tells the process, and those that it starts, that it is one; see nppg.bridge.watch

# The folder in which a command is given, perhaps a stranger's, is none to import from.
_MAIN = "import sys; sys.path[:1] = []; sys.path.append({root!r}); from nppg.cli.main import main; sys.exit(main())"
_CRASHES = (b"Traceback (most recent", b"Fatal Python error", b"[FATAL ERROR", b"SWI-Prolog [", b"terminate called")


def is_isolated() -> bool:
    """Whether this is such a process already."""
    return os.environ.get(_VARIABLE) == "1"


def bound() -> None:
    """Holds this process, and those that it will start, to their memory."""
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    least = min(each for each in (MEMORY, soft, hard) if each != resource.RLIM_INFINITY)
    resource.setrlimit(resource.RLIMIT_AS, (least, hard))


def isolated(arguments: Sequence[str]) -> int:
    """The exit status of a command in a process of its own. Raises NppgError where that did not end by itself."""
    root = str(Path(__file__).resolve().parents[2])
    child = subprocess.Popen(
        [sys.executable, "-c", _MAIN.format(root=root), *arguments],
        env={**os.environ, _VARIABLE: "1"},
        stderr=subprocess.PIPE,
    )
    before = signal(SIGINT, SIG_IGN), signal(SIGTERM, lambda *_: child.terminate())  # Ctrl-C is the child's to heed
    try:
        assert child.stderr is not None
        _relay(child.stderr)
        status = child.wait()
    finally:
        signal(SIGINT, before[0])
        signal(SIGTERM, before[1])
    if status in (0, 2, 130):
        return status
    raise NppgError(
        f"the process of its own was ended (status {status}): it wanted more than {MEMORY >> 30} GB of memory, or "
        "something ended it; the last checkpoint, if there is one, is whole"
    )


def _relay(stream: IO[bytes]) -> None:
    """Passes on what the process says, but for what it says when it crashes."""
    crashed = False
    while text := os.read(stream.fileno(), 65536):
        ends = [at for at in map(text.find, _CRASHES) if at >= 0]
        if not crashed:
            sys.stderr.write(text[: min(ends, default=len(text))].decode(errors="replace"))
            sys.stderr.flush()
        crashed = crashed or bool(ends)
