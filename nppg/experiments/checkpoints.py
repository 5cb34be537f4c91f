"""Checkpoints: all that a run hangs on, in one file of its folder, so that it can be gone on with by another process.

The file is data, sealed as bridge/seals.py says: JSON, with a line that says what it is and one with a table of
bridge/records.py. The one before it stays beside it until the run has ended, for the case that it is damaged.
"""

from __future__ import annotations

import json
import os
import time
import warnings
from collections.abc import Callable, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND
from nppg.bridge.files import replacing, sha256
from nppg.bridge.interrupts import undisturbed
from nppg.bridge.records import Kind, fields_of, table_of, value_of
from nppg.bridge.seals import is_whole, opened, sealed, told
from nppg.bridge.terms import Compound
from nppg.errors import NppgError
from nppg.experiments.progress import Point
from nppg.experiments.versions import versions
from nppg.learning.episode import Episode, Step
from nppg.learning.visits import Visit
from nppg.logic.query import OPEN, Literal, Real, Var
from nppg.policy.copies import BEFORE, CHECKPOINT
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
        self._folder = folder
        self._every = every
        self.has_good = False  # whether the file that is there is one of this run, and whole
        self._due = 0.0 if every else float("inf")

    @property
    def are_due(self) -> bool:
        """Whether one is; the first one at once."""
        return time.monotonic() >= self._due

    @property
    def is_first(self) -> bool:
        """Whether none has been written yet."""
        return self._due == 0.0

    def keep(self, run: Mapping[str, Any], files: Callable[[], object] = lambda: None) -> None:
        """Writes one of a run, then its other files. Raises NppgError, and then the last one is still there."""
        if self._every:
            begin = time.monotonic()
            with undisturbed():
                if self.has_good:
                    _keep(self._folder)
                write(self._folder / CHECKPOINT, run)
                if not self.has_good:
                    _remove(self._folder / BEFORE)
                self.has_good = True
                files()
            end = time.monotonic()
            self._due = end + max(self._every, _SHARE * (end - begin))

    def end(self) -> None:
        """Leaves the last one alone, or none where none are kept."""
        if not self._every:
            _remove(self._folder / CHECKPOINT)
        _remove(self._folder / BEFORE)


def _remove(path: Path) -> None:
    with suppress(OSError):
        path.unlink(missing_ok=True)


def _keep(folder: Path) -> None:
    """Has the checkpoint stay when the next one takes its place; where the file system cannot, it does not."""
    new = folder / f".{BEFORE}.{os.getpid()}"
    try:
        os.link(folder / CHECKPOINT, new)
        os.replace(new, folder / BEFORE)
    except OSError:
        _remove(new)


def write(path: Path, run: Mapping[str, Any]) -> None:
    """Writes the checkpoint of a run whose `sources` are the contents of its files by name."""
    try:
        body = json.dumps(table_of(dict(run), [*_KINDS, *fields_of(Literal)]), separators=(",", ":"))
    except TypeError as error:
        raise told(path, f"cannot be written: {error}, such as a checkpoint can hold: --checkpoint-every 0") from None
    hashes = {name: sha256(source) for name, source in run["sources"].items()}
    head = json.dumps({"nppg": "checkpoint", "format": _FORMAT, "versions": versions(), "files": hashes})
    data = sealed(f'{{\n{head[1:-1]},\n"run": {body}\n}}\n'.encode())
    replacing(path, partial(Path.write_bytes, data=data))


class Checkpoint(NamedTuple):
    """One that was read: the file, the run, and the versions of what has written it."""

    path: Path
    run: dict[str, Any]
    versions: dict[str, str]


def last(folder: Path, bias: LanguageBias | None = None) -> Checkpoint:
    """The checkpoint of a folder, as `read` gives it; the one before where it is damaged, of which a warning tells."""
    path = folder / CHECKPOINT
    try:
        return read(path, bias)
    except NppgError as error:
        if is_whole(path) or not (folder / BEFORE).is_file():
            raise error if path.exists() else told(folder, "there is no checkpoint to go on from") from None
        try:
            found = read(folder / BEFORE, bias)
        except NppgError:
            raise error from None
    what = "is damaged" if path.exists() else "is missing"
    message = f"{path}: {what}, so the run goes on from the one before, of episode {found.run['count']}"
    warnings.warn(message, stacklevel=3)
    return found


def read(path: Path, bias: LanguageBias | None = None) -> Checkpoint:
    """A checkpoint; without a bias all but what it has learned. Raises NppgError for what is no whole one."""
    return opened(path, partial(parsed, path, bias), hint=lambda: "the run has to begin anew; ")


def parsed(path: Path, bias: LanguageBias | None, content: bytes) -> Checkpoint:
    """One that has this content. Raises NppgError."""
    try:
        whole = json.loads(content)
        if (whole["nppg"], whole["format"]) != ("checkpoint", _FORMAT):
            raise told(path, "is no checkpoint of this version of nppg")
        run = value_of(whole["run"], [*_KINDS, *(_literals(bias) if bias else fields_of(Literal))])
        return Checkpoint(path, run, dict(whole["versions"]))
    except _WRONG as error:
        raise told(path, f"is no checkpoint of this run: {error}") from None


def resumed(path: Path, resume: Callable[[], object]) -> None:
    """Has a run gone on with what was read. Raises NppgError where that does not fit."""
    try:
        resume()
    except _WRONG as error:
        raise told(path, f"is no checkpoint of this run: {error}") from None


def check(found: Checkpoint, settings: Mapping[str, Any]) -> None:
    """Raises NppgError where a checkpoint is one of another run than that with these settings, but for the number of
    its episodes, which may be as many more as one likes; of settings that are left out nothing is said."""
    episodes = settings["options"]["episodes"]
    saved = {name: value for name, value in found.run["settings"].items() if name in settings}
    own, theirs = ({**_flat(each), "options.episodes": 0} for each in (settings, saved))
    for name in dict.fromkeys([*own, *theirs]):
        if own.get(name) != theirs.get(name):
            wrong = f"is one of another run: its {name} is {theirs.get(name)}, not {own.get(name)}"
            raise told(found.path, f"{wrong}; only episodes may be raised")
    if found.run["count"] > episodes:
        raise told(found.path, f"has {found.run['count']} episodes already, more than {episodes}")


def tell_versions(found: Checkpoint) -> None:
    """Warns where a checkpoint was written by other versions than go on with it."""
    other = [
        f"{name} {found.versions.get(name)}, not {own}"
        for name, own in versions().items()
        if found.versions.get(name) != own
    ]
    if other:
        message = f"was written with {'; '.join(other)}: the run may not go on as it would have"
        warnings.warn(f"{found.path}: {message}", stacklevel=3)


def are_of(folder: Path, settings: Mapping[str, Any]) -> bool:
    """Whether a folder has a whole checkpoint of the run with these settings."""
    try:
        check(last(folder), settings)
    except (NppgError, *_WRONG):
        return False
    return True


def _flat(settings: Mapping[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name, value in settings.items():
        found |= {f"{name}.{key}": each for key, each in value.items()} if isinstance(value, dict) else {name: value}
    return found
