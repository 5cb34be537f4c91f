"""The experiments of the paper that can be done again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import product

Parameters = Mapping[str, int | float | str]


@dataclass(frozen=True)
class Variant:
    """One of what an experiment compares: a learner with these options, in a domain with these parameters."""

    name: str
    learner: str = "nppg"
    options: Mapping[str, int | float | str] = field(default_factory=dict)
    parameters: Parameters = field(default_factory=dict)


@dataclass(frozen=True)
class Experiment:
    """What a figure is drawn from: runs of each variant with seeds from 0 on. Every `every` episodes a run is
    evaluated, on `starts` random starts where that cannot be done exactly; the `probe` of that name looks at it."""

    name: str
    variants: tuple[Variant, ...]
    domain: str = "blocks_world"
    probe: str = "lengths"
    runs: int = 10
    episodes: int = 2000
    every: int = 50
    starts: int = 1000


_CORRIDOR = {"step_size": 0.7, "episodes_per_iteration": 30, "min_examples": 0, "guidance": 0.0}
_METHODS: dict[str, Mapping[str, int | float | str]] = {
    "paper": {},
    "critic": {"step": "second-order", "critic": "value"},
}
_ALL = (
    Experiment("figure1", tuple(Variant(name, name) for name in ("nppg", "tg", "rib", "trendi"))),
    Experiment("figure2", (Variant("nppg"),)),
    Experiment(
        "figure3",
        tuple(
            Variant(
                f"{method}-{regressor}-noise{mean:.0f}",
                options={**_CORRIDOR, **options, "regressor": regressor},
                parameters={"noise_mean": mean},
            )
            for (method, options), regressor, mean in product(_METHODS.items(), ("cart", "tilde"), (0.0, 1.0))
        ),
        domain="corridor",
        probe="corridor",
        runs=30,
        episodes=1500,
        every=1500,
        starts=200,
    ),
)
EXPERIMENTS = {each.name: each for each in _ALL}
