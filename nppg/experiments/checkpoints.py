"""Checkpoints: all that a run hangs on, in one file of its folder, so that it can be gone on with by another process.

The file is data. Its first line says what it is and has the SHA-256 of the second, a table of bridge/records.py.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND
from nppg.bridge.files import replacing, sha256
from nppg.bridge.interrupts import undisturbed
from nppg.bridge.records import Kind, fields_of, table_of, value_of
from nppg.bridge.terms import Compound
from nppg.errors import NppgError, Problem
from nppg.experiments.progress import Point
from nppg.learning.episode import Episode, Step
from nppg.learning.visits import Visit
from nppg.logic.query import OPEN, Literal, Real, Var
from nppg.policy.copies import CHECKPOINT
from nppg.trees.tree import Leaf, Node
from nppg.worlds.legal import LegalActions
from nppg.worlds.state import NOTHING, Interpretation, Static, static_again

MINUTE = 60.0  # seconds between two checkpoints, where nobody says otherwise
_SHARE = 50  # a checkpoint follows after this many times as long as the last one took
_FORMAT = 1
_WRONG = (ValueError, TypeError, LookupError, ArithmeticError, AttributeError, RecursionError, MemoryError)


def _static(*facts: Any) -> Static:
    return static_again(facts) if facts else NOTHING


_KINDS = (
    *fields_of(Var, Leaf, Node, Step, Episode, Visit, Point),
    Kind(Real, lambda value: (float(value),), Real),
    Kind(Compound, tuple, lambda *items: Compound(items)),
    Kind(Fraction, lambda value: (value.numerator, value.denominator), Fraction),
    Kind(LegalActions, lambda value: value.all, lambda *actions: list(actions)),
    Kind(Static, lambda value: value.facts, _static),
    Kind(Interpretation, lambda value: (value.static, *value.facts), lambda static, *own: Interpretation(own, static)),
)


def _literals(bias: LanguageBias) -> list[Kind]:
    """Literals as trees have them, of predicates that the bias declares."""
    (kind,) = fields_of(Literal)

    def made(name: str, args: tuple) -> Literal:
        if name not in ("=", KIND, *OPEN) and len(bias.types.get(name, ())) != len(args):
            raise ValueError(f"{name}/{len(args)} is no declared predicate")
        return Literal(name, args)

    return [kind._replace(made=made)]


class Checkpoints:
    """Those of a run: one is due after so many seconds, and no sooner than that it costs a fiftieth of the time."""

    def __init__(self, folder: Path, every: float):
        self._path = folder / CHECKPOINT
        self._every = every
        self._due = 0.0 if every else float("inf")

    @property
    def are_due(self) -> bool:
        """Whether one is; the first one at once."""
        return time.monotonic() >= self._due

    @property
    def are_kept(self) -> bool:
        """Whether any is to be written."""
        return self._every > 0

    @property
    def is_first(self) -> bool:
        """Whether none has been written yet."""
        return self._due == 0.0

    def keep(self, run: Mapping[str, Any], files: Callable[[], object] = lambda: None) -> None:
        """Writes one of a run, then its other files. Raises NppgError, and then the last one is still there."""
        if self._every:
            begin = time.monotonic()
            with undisturbed():
                write(self._path, run)
                files()
            end = time.monotonic()
            self._due = end + max(self._every, _SHARE * (end - begin))


def write(path: Path, run: Mapping[str, Any]) -> None:
    """Writes the checkpoint of a run whose `sources` are the contents of its files by name."""
    try:
        body = json.dumps(table_of(dict(run), [*_KINDS, *fields_of(Literal)]), separators=(",", ":"))
    except TypeError as error:
        raise _wrong(path, f"cannot be written: {error}, such as a checkpoint can hold: --checkpoint-every 0") from None
    hashes = {name: sha256(source) for name, source in run["sources"].items()}
    head = {"nppg": "checkpoint", "format": _FORMAT, "sha256": sha256(body.encode()), "files": hashes}
    replacing(path, partial(Path.write_text, data=f"{json.dumps(head)}\n{body}\n", encoding="utf-8"))


def read(path: Path, bias: LanguageBias | None = None) -> dict[str, Any]:
    """The run of a checkpoint; without a bias all but what it has learned. Raises NppgError for what is no whole
    checkpoint."""
    try:
        head_line, _, body = path.read_bytes().partition(b"\n")
    except FileNotFoundError:
        raise _wrong(path.parent, "there is no checkpoint to go on from") from None
    except OSError as error:
        raise _wrong(path, f"cannot be read: {error.strerror}") from None
    try:
        head = json.loads(head_line)
        known = head["nppg"] == "checkpoint" and head["format"]
        digest = head["sha256"]
    except _WRONG:
        raise _wrong(path, "is no checkpoint, or damaged") from None
    if known != _FORMAT:
        raise _wrong(path, "is no checkpoint of this version of nppg")
    body = body.removesuffix(b"\n")
    if sha256(body) != digest:
        raise _wrong(path, "is damaged: its checksum is another")
    try:
        return value_of(json.loads(body), [*_KINDS, *(_literals(bias) if bias else fields_of(Literal))])
    except _WRONG as error:
        raise _wrong(path, f"is no checkpoint of this run: {error}") from None


def resumed(path: Path, resume: Callable[[], object]) -> None:
    """Has a run gone on with what was read. Raises NppgError where that does not fit."""
    try:
        resume()
    except _WRONG as error:
        raise _wrong(path, f"is no checkpoint of this run: {error}") from None


def check(path: Path, saved: Mapping[str, Any], settings: Mapping[str, Any], count: int) -> None:
    """Raises NppgError where a checkpoint is one of another run than that with these settings, but for the number of
    its episodes, which may be as many more as one likes."""
    episodes = settings["options"]["episodes"]
    own, theirs = ({**_flat(each), "options.episodes": 0} for each in (settings, saved["settings"]))
    for name in dict.fromkeys([*own, *theirs]):
        if own.get(name) != theirs.get(name):
            raise _wrong(path, f"is one of another run: its {name} is {theirs.get(name)}, not {own.get(name)}")
    if count > episodes:
        raise _wrong(path, f"has {count} episodes already, more than {episodes}")


def are_of(folder: Path, settings: Mapping[str, Any]) -> bool:
    """Whether a folder has a whole checkpoint of the run with these settings."""
    path = folder / CHECKPOINT
    try:
        saved = read(path)
        check(path, saved, settings, saved["count"])
    except (NppgError, *_WRONG):
        return False
    return True


def _flat(settings: Mapping[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name, value in settings.items():
        found |= {f"{name}.{key}": each for key, each in value.items()} if isinstance(value, dict) else {name: value}
    return found


def forget(folder: Path) -> None:
    """Removes the checkpoint of an earlier run."""
    with suppress(OSError):
        (folder / CHECKPOINT).unlink(missing_ok=True)


def _wrong(path: Path, message: str) -> NppgError:
    return NppgError([Problem(str(path), 0, 0, message)])
