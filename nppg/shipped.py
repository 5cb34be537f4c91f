"""The folders that come with the package, and files that are named or given by a path."""

from __future__ import annotations

from collections.abc import Mapping
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


def bias_for(domain: str | Path, parameters: Mapping[str, int | float | str], option: str) -> Path:
    """The language bias of the domain's name: beside the domain, else among the shipped ones.

    Raises NppgError where there is none, or where a parameter is set to the name of another bias in that folder: the
    user is to choose, by `option`."""
    file = locate(domain, "domains", ".pl")
    path = file.with_suffix(".yaml")
    if not path.is_file():
        try:
            path = locate(file.stem, "language_bias", ".yaml")
        except NppgError:
            message = f"there is no language bias of this name; give one by {option.strip(' =')}"
            raise NppgError([Problem(str(path), 0, 0, message)]) from None
    for name, value in parameters.items():
        other = path.parent / f"{value}.yaml"
        if other in path.parent.glob("*.yaml") and other != path:
            own, default = (each.stem if each.parent == shipped("language_bias") else each for each in (other, path))
            raise NppgError(f"{name}={value} has a language bias of its own: give {option}{own}, or {option}{default}")
    return path
