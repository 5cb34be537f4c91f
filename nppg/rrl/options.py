"""The hyperparameters of the value-function learners. What their papers used is unknown where it is not said here."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from nppg.options import Common, option


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
