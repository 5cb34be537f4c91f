"""A run that somebody wants to go on with, from what its folder holds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from nppg.bias.declarations import TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.errors import NppgError, Problem
from nppg.experiments import checkpoints
from nppg.experiments.learners import LEARNERS
from nppg.experiments.progress import Judging
from nppg.experiments.run_files import in_the_way
from nppg.learning.options import Common
from nppg.policy.copies import CHECKPOINT, write_copies
from nppg.worlds.domain import Domain
from nppg.worlds.opening import open_domain


class Begun(NamedTuple):
    """What a run was begun with."""

    domain: Domain
    bias: LanguageBias
    options: Common
    judging: Judging


def begun(folder: Path, episodes: int | None = None, trust: bool | None = None) -> Begun:
    """The run of a folder's checkpoint, whose domain and language bias are written beside it where they are missing;
    with so many episodes, if they are given. `trust` is about the domain; that the run was begun with it says nothing,
    for the folder may be another's. Raises NppgError."""
    saved = checkpoints.last(folder)
    found: list[Begun] = []
    checkpoints.resumed(saved.path, lambda: found.append(_begun(folder, saved.run, episodes, trust)))
    return found[0]


def _begun(folder: Path, saved: Mapping[str, Any], episodes: int | None, trust: bool | None) -> Begun:
    known, sources = saved["settings"], saved["sources"]
    if known["bias"] is None:
        message = "its language bias has no file: go on with it in Python, by nppg.run(..., resume=True)"
        raise NppgError([Problem(str(folder / CHECKPOINT), 0, 0, message)])
    if any(Path(name).name != name for name in sources):
        raise ValueError("a file of the run is to be written elsewhere")
    if problems := in_the_way(sources, folder):
        raise NppgError(problems)
    write_copies(folder, sources)
    given = known["options"] | ({} if episodes is None else {"episodes": episodes})
    options = LEARNERS[known["learner"]](**given)
    bias = LanguageBias.load(folder / known["bias"]["file"])
    bias = replace(bias, tree=TreeLimits(**known["tree"]))
    chosen = () if known["beside"] else saved["chosen"]
    domain = open_domain(folder / known["domain"]["file"], known["domain"]["parameters"], chosen, trust)
    return Begun(domain, bias, options, known["curve"])
