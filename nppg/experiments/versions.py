"""What a run's numbers may hang on besides its settings."""

from __future__ import annotations

import platform
from functools import cache
from importlib.metadata import version

import numpy as np

from nppg.bridge.prolog import ask


@cache
def versions() -> dict[str, str]:
    """By the names that run.json and checkpoints have for them."""
    return {
        "nppg": version("nppg"),
        "prolog": ask("version"),
        "python": platform.python_version(),
        "numpy": np.__version__,
    }
