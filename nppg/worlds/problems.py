"""Problems: start states by number, to be learned on and to be judged by."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path

from nppg.bias.names import written
from nppg.bridge.bounds import DATA, bounded
from nppg.bridge.prolog import ask
from nppg.bridge.terms import Ground, ground, texts
from nppg.errors import NppgError, Problem
from nppg.worlds.state import Interpretation, interpretation_of, static_facts

BESIDE = "_problems.pl"  # ends the name of the file with a domain file's problems, which lies beside it
_MOST = 100_000  # numbers that a range may choose
_KEPT = 100  # start states that are remembered


class Problems:
    """Start states by number, each with a name; they are read when they are first needed. `given`: beside the domain,
    which does not have them in its file. `files`: those in PDDL that they come from."""

    def __init__(
        self,
        names: Mapping[int, str],
        read: Callable[[int], Interpretation],
        given: bool = True,
        files: Sequence[Path] = (),
    ):
        self.names = names
        self.given = given
        self.files = files
        self._read = read
        self._known: dict[int, Interpretation] = {}

    def state(self, number: int) -> Interpretation:
        """The start state of a problem. Raises NppgError for what its file gets wrong."""
        if number not in self._known:
            if len(self._known) >= _KEPT:
                self._known.pop(next(iter(self._known)))
            self._known[number] = self._read(number)
        return self._known[number]

    def __reduce__(self) -> tuple:
        """Given ones take all states along, for their files may be missing where they are unpickled."""
        if self.given:
            return numbered, ([*map(self.state, self.names)], list(self.names.values()), self.files)
        return Problems, (self.names, self._read, False)


def numbered(states: Sequence[Interpretation], names: Sequence[str], files: Sequence[Path] = ()) -> Problems:
    """These start states, numbered from 1."""
    return Problems(dict(enumerate(names, 1)), partial(_nth, states), files=files)


def _nth(states: Sequence[Interpretation], number: int) -> Interpretation:
    return states[number - 1]


def problems_in(path: Path, module: str) -> Problems:
    """The problems of a data file, of terms problem(Name, Facts), for the domain file loaded as `module`. Raises
    NppgError with every mistake."""
    names, states = [], []
    try:
        bounded(path.read_bytes(), str(path), DATA)
    except OSError as error:
        raise NppgError([Problem(str(path), 0, 0, f"cannot be read: {error.strerror}")]) from None
    for name, static, facts in ask("problems_in", module, str(path)):
        names.append(name)
        states.append(Interpretation(ground(facts), static_facts(ground(static))))
    return numbered(states, names)


def problems_text(states: Iterable[tuple[str, Sequence[Ground]]]) -> str:
    """Start states with their names as a data file; of a name that comes again it is told the how many-th it is."""
    found = ["% Problems: start states by name. They are read as data.\n"]
    count: Counter[str] = Counter()
    for name, each in states:
        state = interpretation_of(each)
        count[name] += 1
        name = name if count[name] == 1 else f"{name} ({count[name]})"
        facts = ",\n    ".join(texts((*state.static.facts, *state.facts)))
        found.append(f"problem({written(name)}, [\n    {facts}\n]).\n")
    return "\n".join(found)


def numbers_of(text: str, option: str = "--problems") -> list[int] | None:
    """The numbers that a text like 1-20 or 3,5,8-10 lists, None where it is another one. Raises NppgError, which names
    the option that they are for."""
    if not re.fullmatch(r"\d+(-\d+)?(,\d+(-\d+)?)*", text):
        return None
    found: list[int] = []
    for part in text.split(","):
        first, _, last = part.partition("-")
        if last and int(last) < int(first):
            raise NppgError(f"{option}: {part} ends before it begins")
        if last and int(last) - int(first) >= _MOST:
            raise NppgError(f"{option}: {part} are more than {_MOST:,} {option.lstrip('-')}")
        found += range(int(first), int(last or first) + 1)
    return found


def sorted_out(given: str | Path | Iterable[str | int | Path]) -> tuple[list[int], list[Path]]:
    """The numbers and the files that somebody has chosen. Raises NppgError where these are mixed, or no such file is
    there."""
    numbers: list[int] = []
    files: list[Path] = []
    for each in [given] if isinstance(given, str | Path) else given:
        listed = [each] if isinstance(each, int) else numbers_of(str(each))
        if listed is None:
            files.append(Path(each))  # type: ignore[arg-type]
        else:
            numbers += listed
    if numbers and files:
        raise NppgError(f"problems are chosen by numbers or given as files, not both: {numbers[0]} and {files[0]}")
    missing = [each for each in files if not each.is_file()]
    if missing:
        raise NppgError(
            Problem(str(each), 0, 0, "is a folder: name its files" if each.is_dir() else "no such file")
            for each in missing
        )
    return numbers, files
