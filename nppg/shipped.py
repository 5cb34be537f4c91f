"""The folders that come with the package, and files that are named or given by a path."""

from __future__ import annotations

from pathlib import Path

from nppg.errors import NppgError, Problem, suggestion


def shipped(folder: str) -> Path:
    """The folder `prolog`, `domains` or `language_bias`: inside an installed package, beside one in a checkout."""
    package = Path(__file__).parent
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
