"""The files that somebody has, as a task: ACE's (.s, .kb, .bg), Aleph's (.b, .f, .n), nppg's own (.yaml)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from nppg.errors import NppgError, Problem
from nppg.tilde.ace import read_ace
from nppg.tilde.aleph import read_aleph
from nppg.tilde.task import Task

_KINDS = {".s": "ACE", ".b": "Aleph", ".yaml": "nppg", ".yml": "nppg"}  # by the ending of the file that says what to do
_ENDINGS = (*_KINDS, ".kb", ".bg", ".f", ".n")


def read_task(paths: Sequence[str | Path]) -> Task:
    """The task in a folder, or in files of one name, of which one is enough. Raises NppgError."""
    files = _files(paths)
    heads = [each for each in files if each.suffix in _KINDS]
    if len(heads) != 1:
        names = ", ".join(map(str, heads))
        what = f"there are several tasks, name one: {names}" if heads else "there is no file .s, .b or .yaml"
        raise NppgError([Problem(" ".join(map(str, paths)), 0, 0, what)])
    (head,) = heads
    kind = _KINDS[head.suffix]
    if kind == "ACE":
        return read_ace(head, [each for ending in (".kb", ".bg") for each in files if each.suffix == ending])
    if kind == "Aleph":
        positive, negative = (next((each for each in files if each.suffix == ending), None) for ending in (".f", ".n"))
        return read_aleph(head, positive, negative)
    raise NppgError([Problem(str(head), 0, 0, "is no task that can be read")])


def _files(paths: Iterable[str | Path]) -> list[Path]:
    """The files that are named, and those of the same names beside them; all of a folder's."""
    found: dict[Path, None] = {}
    for each in map(Path, paths):
        if each.is_dir():
            beside: Iterable[Path] = sorted(each.iterdir())
        elif each.is_file():
            beside = [each, *(each.with_suffix(ending) for ending in _ENDINGS)]
        else:
            beside = [each.with_suffix(ending) for ending in _ENDINGS] if not each.suffix else []
            if not any(map(Path.is_file, beside)):
                raise NppgError([Problem(str(each), 0, 0, "there is no such file or folder")])
        found |= dict.fromkeys(file for file in beside if file.is_file() and file.suffix in _ENDINGS)
    return list(found)
