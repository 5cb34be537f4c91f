"""Files: those that come with the package, named or given by a path, hashed, and written whole or not at all."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
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
    """Writes a file under a temporary name and renames it, so that it is there whole or not at all. Raises
    NppgError where that is not possible."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        temporary.touch()
        write_to(temporary)
        os.replace(temporary, path)
    except OSError as error:
        raise NppgError([Problem(str(path), 0, 0, f"cannot be written: {error.strerror}")]) from None
    finally:
        temporary.unlink(missing_ok=True)


def file_hash(path: str | Path) -> str:
    """SHA-256 of a file, in hexadecimal."""
    return sha256(Path(path).read_bytes())


def sha256(data: bytes) -> str:
    """SHA-256, in hexadecimal."""
    return hashlib.sha256(data).hexdigest()
