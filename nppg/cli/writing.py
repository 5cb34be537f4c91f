"""New files in a folder."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from nppg.errors import NppgError, Problem


def write_new(folder: Path, files: Mapping[str, bytes | None]) -> None:
    """Writes files, contents by name. Raises NppgError where another file of such a name is there."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        others = [
            folder / name
            for name, source in files.items()
            if (folder / name).exists() and (folder / name).read_bytes() != source
        ]
        if others:
            raise NppgError(Problem(str(file), 0, 0, "exists already and is left as it is") for file in others)
        for name, source in files.items():
            (folder / name).write_bytes(source or b"")
    except OSError as error:
        raise NppgError([Problem(str(folder), 0, 0, f"cannot be written to: {error.strerror}")]) from None
