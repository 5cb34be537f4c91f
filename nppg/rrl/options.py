"""The hyperparameters of the value-function learners. What their papers used is unknown where it is not said here."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from nppg.learning.options import Common, option


@dataclass(frozen=True)
class QOptions(Common):
    """Of Q-learning, whatever the regressor."""

    discount: float = option(0.9, "gamma, of the next state's highest Q", low=0, high=1)
    exploration: str = option("boltzmann", "how actions are chosen by their Q", choices=("boltzmann", "epsilon-greedy"))
    temperature: float = option(0.5, "of the first Boltzmann episode: pi is proportional to exp(Q / T)", low=1e-9)
    cooling: float = option(0.99, "the temperature is multiplied by this after each episode", low=0, high=1)
    min_temperature: float = option(0.01, "it does not fall below this", low=1e-9)
    epsilon: float = option(0.1, "share of uniformly random actions in epsilon-greedy exploration", low=0, high=1)

    def temperature_after(self, episodes: int) -> float:
        """That of the episode behind so many others."""
        return max(self.min_temperature, self.temperature * self.cooling**episodes)


@dataclass(frozen=True)
class GrowthOptions(QOptions):
    """When a leaf splits."""

    min_sample: int = option(200, "examples that a leaf has seen before it may split", low=3)
    significance: float = option(0.001, "level of the F-test that a split must pass; 1 switches it off", low=0, high=1)
    max_depth: int = option(10, "tests on the longest path of the tree", low=0)


@dataclass(frozen=True)
class TGOptions(GrowthOptions):
    """Of TG. Minimal sample size and significance are the paper's."""

    learner: ClassVar[str] = "tg"


@dataclass(frozen=True)
class InstanceOptions(QOptions):
    """What RIB stores, and what it removes."""

    mismatch: float = option(1.0, "distance for each argument of goal and action that is another one", low=1e-9)
    power: float = option(1.0, "power of the distances that weight a prediction; the paper's is 1", low=0.1, high=20)
    neighbours: int = option(30, "nearest instances whose values' standard deviation is the local deviation", low=1)
    local_deviation: float = option(0.1, "an error up to this many local deviations is kept out", low=0)
    global_deviation: float = option(0.05, "an error up to this many deviations of all values is kept out", low=0)
    max_instances: int = option(1500, "instances in memory, of TRENDI in each leaf", low=2, high=4000)
    removal: str = option(
        "error-contribution",
        "what leaves a full memory: the instance that predictions miss least, or the one that varies most",
        choices=("error-contribution", "maximum-variance"),
    )
    max_gradient: float = option(
        0.1, "M of maximum-variance: values should differ by no more than M times the distance", low=0
    )


@dataclass(frozen=True)
class RIBOptions(InstanceOptions):
    """Of RIB."""

    learner: ClassVar[str] = "rib"


@dataclass(frozen=True)
class TrendiOptions(InstanceOptions, GrowthOptions):
    """Of TRENDI. A leaf looks for a split whenever it has seen `min_sample` more examples."""

    learner: ClassVar[str] = "trendi"

    max_instances: int = option(100, "instances in memory, of TRENDI in each leaf", low=2, high=4000)
    min_instances: int = option(20, "instances that a leaf holds before it may split", low=3)
