"""Every PDDL domain in the folders that NPPG_PDDL names, each as FOLDER/NAME/domain.pddl with problems below NAME:

    NPPG_PDDL=one:other pytest tests/test_pddl_corpus.py

Warnings tell what was refused, by nppg or by unified-planning.
"""

from __future__ import annotations

import os
import warnings
from pathlib import Path

import numpy as np
import pytest
from agreement import REFUSALS, Reference, agree

from nppg.errors import NppgError
from nppg.worlds.opening import open_domain
from nppg.worlds.pddl_domain import PddlDomain

FOLDERS = [Path(each) for each in os.environ.get("NPPG_PDDL", "").split(os.pathsep) if each]
DOMAINS = [file for folder in FOLDERS for file in sorted(folder.glob("*/domain.pddl"))]
MOST = 4  # problems of a domain, the smallest
EPISODES, STEPS = 100, 20
LARGE = 2000  # facts, from which on unified-planning takes its time

pytestmark = [
    pytest.mark.corpus,
    pytest.mark.skipif(not DOMAINS, reason="NPPG_PDDL names no folder with domains"),
]


def refused(error: NppgError, files: set[Path]) -> None:
    """Holds a refusal against what users are promised, and tells it."""
    for each in error.problems:
        assert Path(each.file) in files
        assert (each.line and each.column) or "cannot be reached" in each.message
    warnings.warn(f"nppg: {error}", stacklevel=2)


def random_episodes(domain: PddlDomain) -> None:
    """Plays them, from starts at random."""
    rng = np.random.default_rng(0)
    for _ in range(EPISODES):
        state = domain.start(rng)
        assert domain.horizon(state) > 0
        for _ in range(STEPS):
            status, actions = domain.situation(state)
            if status != "running":
                break
            state = domain.act(state, actions[int(rng.random() * len(actions))], rng)[1]


def compared(domain: PddlDomain, number: int, domain_file: Path, problem_file: Path) -> bool:
    """Whether unified-planning reads a problem; then both agree on it."""
    try:
        reference = Reference(domain_file, problem_file)
        reference.begin()
    except REFUSALS as error:
        text = " ".join(str(error).split())
        warnings.warn(f"unified-planning: {problem_file}: {type(error).__name__}: {text}", stacklevel=2)
        return False
    walks, steps = (2, 5) if reference.atoms_in_all() < LARGE else (1, 1)
    agree(domain, number, reference, walks, steps)
    return True


@pytest.mark.parametrize("file", DOMAINS, ids=lambda file: f"{file.parent.parent.name}-{file.parent.name}")
def test_it_is_played_or_refused_and_means_what_it_says(file: Path) -> None:
    files = sorted(set(file.parent.rglob("*.pddl")) - {file}, key=lambda each: (each.stat().st_size, each))
    assert files, "a domain has problems"
    read: dict[Path, PddlDomain] = {}
    for each in files[:MOST]:
        try:
            domain = open_domain(file, problems=[each])
            domain.problem(1)
        except NppgError as error:
            refused(error, {file, each})
        else:
            assert isinstance(domain, PddlDomain)
            read[each] = domain
    if not read:
        pytest.skip("refused")
    over_all = open_domain(file, problems=list(read))
    assert isinstance(over_all, PddlDomain) and len(over_all.problems) == len(read)
    random_episodes(over_all)
    certain = all(len(outcomes) == 1 for _, outcomes in over_all.neighbours(over_all.problem(1)))
    if certain and ":probabilistic-effects" not in over_all.model.requirements:
        for number, each in enumerate(list(read)[:2], 1):
            compared(over_all, number, file, each)
