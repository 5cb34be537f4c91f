"""Finds out what format a data set is in, and reads it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nppg.errors import NppgError, Problem, suggestion
from nppg.tilde.ace import read_ace
from nppg.tilde.aleph import read_aleph
from nppg.tilde.own import read_own
from nppg.tilde.task import Task

_MAIN = (".yaml", ".s", ".b", ".pl")  # the file that says what is learned: nppg's, ACE's, Aleph's
_BESIDE = {".s": (".kb", ".bg"), ".b": (".f", ".n")}
_SECTIONS = ("begin_in_pos", "aleph")
_WHAT = "ACE's is a .s file, Aleph's a .b or .pl file, nppg's a .yaml file"


def read_task(sources: Sequence[str | Path]) -> Task:
    """The task of a folder, of a file without its ending, or of files. Raises NppgError for what is wrong with them,
    and where there are several tasks."""
    paths = [Path(each) for each in sources]
    main, beside = _single(paths[0]) if len(paths) == 1 else _several(paths)
    if main.suffix == ".yaml":
        return read_own(main)
    if main.suffix == ".s":
        return read_ace(main, [path for suffix in _BESIDE[".s"] for path in beside if path.suffix == suffix])
    found = {path.suffix: path for path in beside}
    return read_aleph(main, found.get(".f"), found.get(".n"))


def data_sets(sources: Sequence[str | Path]) -> list[list[Path]]:
    """What `read_task` reads one by one: the data sets of a folder that has several, else these sources."""
    paths = [Path(each) for each in sources]
    found = _names(paths[0]) if len(paths) == 1 and paths[0].is_dir() else []
    return [[each] for each in found] if len(found) > 1 else [paths]


def _names(folder: Path) -> list[Path]:
    """By which the data sets of a folder are told from one another."""
    mains = _mains(folder)
    crowded = [folder, *(each.parent for each in mains)]
    return [each.with_suffix("") if crowded.count(each.parent) > 1 else each.parent for each in mains]


def _single(path: Path) -> tuple[Path, list[Path]]:
    if path.is_dir():
        mains = _mains(path)
        if len(mains) > 1:
            names = ", ".join(map(str, _names(path)))
            raise NppgError([Problem(str(path), 0, 0, f"there are several data sets: name one of {names}")])
        if not mains:
            raise NppgError([Problem(str(path), 0, 0, f"there is no data set: {_WHAT}")])
        return mains[0], _files_beside(mains[0])
    if not path.is_file() or path.suffix in (".kb", ".bg", ".f", ".n"):
        stem = path.with_suffix("") if path.is_file() else path
        mains = [main for suffix in _MAIN if (main := stem.parent / f"{stem.name}{suffix}").is_file()]
        if not mains:
            near = path.parent.iterdir() if path.parent.is_dir() else ()
            hint = suggestion(path.name, [name for each in near for name in (each.name, each.stem)])
            what = "belongs to no .s, .b or .yaml file" if path.is_file() else "no such file"
            raise NppgError([Problem(str(path), 0, 0, f"{what}{hint}")])
        path = mains[0]
    if path.suffix not in _MAIN:
        raise NppgError([Problem(str(path), 0, 0, f"is no data set that nppg reads: {_WHAT}")])
    return path, _files_beside(path)


def _mains(folder: Path) -> list[Path]:
    """The data sets of a folder; where there are none, those of its folders. Of Aleph's files only those count that
    have examples, if some have."""
    found = sorted(each for each in folder.iterdir() if _is_main(each))
    if found:
        return [each for each in found if each.suffix != ".b" or each.with_suffix(".f").is_file()] or found
    inner = sorted(each for each in folder.iterdir() if each.is_dir() and not each.is_symlink())
    return [main for each in inner for main in _mains(each)]


def _is_main(path: Path) -> bool:
    if path.suffix == ".pl":
        text = path.read_text(encoding="utf-8", errors="replace")
        return all(word in text for word in _SECTIONS)
    return path.suffix in _MAIN and path.is_file()


def _files_beside(main: Path) -> list[Path]:
    """Those of the same name; for ACE, where there are none, all of the folder if there is no other data set."""
    suffixes = _BESIDE.get(main.suffix, ())
    found = [path for suffix in suffixes if (path := main.with_suffix(suffix)).is_file()]
    if not found and main.suffix == ".s" and len(list(main.parent.glob("*.s"))) == 1:
        found = sorted(path for path in main.parent.iterdir() if path.suffix in suffixes)
    return found


def _several(paths: Sequence[Path]) -> tuple[Path, list[Path]]:
    if not paths:
        raise NppgError("no data is given: name a folder or files")
    missing = [Problem(str(path), 0, 0, "no such file") for path in paths if not path.is_file()]
    if missing:
        raise NppgError(missing)
    mains = [path for path in paths if path.suffix in _MAIN]
    if len(mains) != 1:
        what = (
            "there is no file that says what is learned"
            if not mains
            else f"{mains[0]} and {mains[1]} are two data sets"
        )
        raise NppgError(f"{what}: ACE has one .s file, Aleph one .b file, nppg one .yaml file")
    wrong = [path for path in paths if path != mains[0] and path.suffix not in _BESIDE.get(mains[0].suffix, ())]
    if wrong:
        raise NppgError(Problem(str(path), 0, 0, f"does not belong to {mains[0]}") for path in wrong)
    return mains[0], [path for path in paths if path != mains[0]]
