"""The experiments of the paper that can be done again."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Experiment:
    """What a figure is drawn from: runs of `learners` with seeds from 0 on, each tested on `starts` random starts."""

    name: str
    learners: tuple[str, ...]
    domain: str = "blocks_world"
    starts: int = 1000


_ALL = (Experiment("figure1", ("nppg", "tg", "rib", "trendi")), Experiment("figure2", ("nppg",)))
EXPERIMENTS = {each.name: each for each in _ALL}
