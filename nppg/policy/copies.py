"""Copies of a run's input files beside its model, and what may stand in their way."""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping
from contextlib import suppress
from functools import partial
from itertools import islice
from pathlib import Path

from nppg.bridge.files import made, replacing, sha256
from nppg.errors import NppgError, Problem

CHECKPOINT = "checkpoint.json"
BEFORE = "checkpoint.before.json"  # the one before it
_DAMAGED = (OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError)


def conflicts(folder: Path, copies: Mapping[str, bytes], own: Collection[str]) -> dict[str, Problem]:
    """Which copies, contents by name, cannot be put into a folder: those whose name is one of the model's `own` files,
    and those in place of which stands something else that no run of nppg wrote there."""
    recorded = recorded_hashes(folder)
    found = {}
    for name, source in copies.items():
        path = folder / name
        present = _contents(path)
        if name in own:
            found[name] = Problem(str(path), 0, 0, "a model needs another name than its domain's file")
        elif present not in (None, source) and sha256(present or b"") != recorded.get(name):
            message = "there is another file of this name, which is left as it is: write into another folder"
            found[name] = Problem(str(path), 0, 0, message)
    return found


def write_copies(folder: Path, copies: Mapping[str, bytes]) -> None:
    """Writes the copies that are not there yet, and the folders that their names have. Raises NppgError."""
    for name, source in copies.items():
        if Path(name).is_absolute() or ".." in Path(name).parts:
            raise NppgError([Problem(str(folder), 0, 0, f"{name} is no name of a file in the folder")])
        if _contents(folder / name) != source:
            if (within := (folder / name).parent) != folder:
                made(within)
            replacing(folder / name, partial(Path.write_bytes, data=source))


def recorded_hashes(folder: Path) -> dict[str, str]:
    """SHA-256 of the inputs that the last run into a folder put there, by name, whether or not it came to its end."""
    found: dict[str, str] = {}
    for name in (BEFORE, CHECKPOINT):
        with suppress(*_DAMAGED), (folder / name).open(encoding="utf-8") as file:
            found |= json.loads(f"{{{[*islice(file, 3)][2].rstrip()[:-1]}}}")["files"]  # its third line
    with suppress(*_DAMAGED):
        summary = json.loads((folder / "run.json").read_text())
        inputs = (summary["domain"], summary["bias"], *summary.get("beside", ()))
        found |= {each["file"]: each["sha256"] for each in inputs if each}
    return found


def _contents(path: Path) -> bytes | None:
    """What stands in a file, nothing where there is none or it cannot be read."""
    try:
        return path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError:
        return b""
