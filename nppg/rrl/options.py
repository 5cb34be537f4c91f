"""The hyperparameters of the value-function learners. What their papers used is unknown where it is not said here."""

from __future__ import annotations

from dataclasses import dataclass

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
