"""Whether a domain file is code that may do anything, or only what a domain needs; see prolog/safety.pl."""

from __future__ import annotations

import os

HOW_TO_TRUST = ": if its author may run anything on this machine, give --trust (trust=True)"


def trusting(trust: bool | None) -> bool:
    """Whether a file is trusted: as it is said, else as the variable NPPG_TRUST says, which --trust sets."""
    return os.environ.get("NPPG_TRUST") == "1" if trust is None else trust
