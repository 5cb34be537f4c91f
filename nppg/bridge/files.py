"""Files: those that come with the package, named or given by a path, hashed, and written whole or not at all."""

from __future__ import annotations

import fcntl
import hashlib
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from nppg.errors import NppgError, Problem, suggestion


def shipped(folder: str) -> Path:
    """The folder `prolog`, `domains` or `language_bias`: inside an installed package, beside one in a checkout."""
    package = Path(__file__).parent.parent
    inside = package / "_shipped" / folder
    return inside if inside.is_dir() else package.parent / folder


def locate(name: str | Path, folder: str, suffix: str) -> Path:
    """The file of that path, or of that name among the shipped ones in `folder`."""
    path = Path(name)
    if path.is_file():
        return path
    candidate = shipped(folder) / f"{name}{suffix}"
    if path.suffix == "" and candidate.is_file():
        return candidate
    known = sorted(each.stem for each in shipped(folder).glob(f"*{suffix}"))
    hint = suggestion(str(name), known) or f"; shipped are: {', '.join(known)}"
    raise NppgError([Problem(str(name), 0, 0, f"no such file{hint}")])


def replacing(path: Path, write_to: Callable[[Path], object]) -> None:
    """Writes a file under a temporary name and renames it, so that it is there whole or not at all, whatever happens
    to the process or the machine meanwhile. Raises NppgError where that is not possible."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        temporary.touch()
        write_to(temporary)
        _flush(temporary)
        os.replace(temporary, path)
        _flush(path.parent)
    except OSError as error:
        raise NppgError([Problem(str(path), 0, 0, f"cannot be written: {error.strerror}")]) from None
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)


def made(folder: Path) -> None:
    """Makes a folder where there is none. Raises NppgError."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise NppgError([Problem(str(folder), 0, 0, f"the folder cannot be made: {error.strerror}")]) from None


def write_files(folder: Path, files: Mapping[str, bytes]) -> None:
    """Writes files, contents by name, into a folder of somebody's own, and its folders where names have some."""
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def _flush(path: Path) -> None:
    """Has what is in a file, or the names in a folder, come to the disk."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def sweep(folder: Path, names: Iterable[str]) -> None:
    """Removes what processes that were killed have left of these files under temporary names."""
    for name in names:
        for left in folder.glob(f".{name}.*"):
            if left.suffix[1:].isdigit():
                with suppress(OSError):
                    left.unlink()


@contextmanager
def held(folder: Path) -> Iterator[None]:
    """Holds a folder for the work of this process alone. It is let go of when the process ends, however that is. Raises
    NppgError where it is held already, or is not there."""
    try:
        descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    except OSError as error:
        raise NppgError([Problem(str(folder), 0, 0, f"the folder cannot be read: {error.strerror}")]) from None
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            message = "another run is writing into this folder: wait for it, or write into another one"
            raise NppgError([Problem(str(folder), 0, 0, message)]) from None
        except OSError:
            pass  # a file system that knows no locks
        yield
    finally:
        os.close(descriptor)


def sha256(data: bytes) -> str:
    """SHA-256, in hexadecimal."""
    return hashlib.sha256(data).hexdigest()
