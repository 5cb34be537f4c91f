"""TREENPPG: Algorithm 1 of Kersting and Driessens (2008)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from nppg.coverage import Coverage, root_table
from nppg.domain import Action, Domain, State
from nppg.episode import Episode, generate_episode
from nppg.errors import NppgError, Problem
from nppg.gradient import functional_gradient, returns, taken_gradient
from nppg.language_bias import LanguageBias
from nppg.options import Options
from nppg.policy import Policy
from nppg.refinement import Refiner
from nppg.tilde import grow
from nppg.tree import leaves

_IDLE = 1000  # episodes in a row without a step, after which there is nothing to wait for


@dataclass(frozen=True, slots=True)
class Iteration:
    """The policy after one more tree; `episodes` counts all so far, `recent` are those since the last tree."""

    policy: Policy
    episodes: int
    recent: tuple[Episode, ...]


@dataclass
class Batch:
    """The examples that gather between two trees."""

    states: list[State] = field(default_factory=list)
    actions: list[Action] = field(default_factory=list)
    answers: list[np.ndarray] = field(default_factory=list)
    targets: list[np.ndarray] = field(default_factory=list)

    def add(self, episode: Episode, options: Options) -> None:
        """Adds the functional gradient of every step (Proposition 3.1)."""
        values = returns([step.reward for step in episode.steps], options.discount)
        for step, value in zip(episode.steps, values.tolist(), strict=True):
            if value == 0 and options.unrewarded == "drop":
                continue
            if options.update == "all":
                updated = slice(None)
                gradient = functional_gradient(step.probabilities, step.chosen, value)
            else:
                updated = slice(step.chosen, step.chosen + 1)
                gradient = np.array([taken_gradient(step.probabilities, step.chosen, value)])
            self.states += [step.state] * len(gradient)
            self.actions += step.actions[updated]
            self.answers.append(step.answers[updated])
            self.targets.append(gradient)


def train(domain: Domain, bias: LanguageBias, options: Options | None = None) -> Iterator[Iteration]:
    """Yields after each tree, the first time before the first one. Raises NppgError."""
    options = options or Options()
    rng = np.random.default_rng(options.seed)
    refiner = Refiner(bias)
    policy = Policy(domain, bias, root_table(domain, bias, refiner))
    episodes = idle = 0
    yield Iteration(policy, episodes, ())
    while episodes < options.episodes:
        batch = Batch()
        recent: list[Episode] = []
        while episodes < options.episodes and (
            len(batch.states) <= options.min_examples or len(recent) < options.episodes_per_iteration
        ):
            recent.append(generate_episode(policy, rng, options.guidance, options.horizon_factor))
            batch.add(recent[-1], options)
            episodes += 1
            idle = 0 if recent[-1].steps else idle + 1
            if idle == _IDLE:
                message = f"{idle} episodes took no step: their starts were goal or terminal states, or the horizon 0"
                raise NppgError([Problem(str(domain.path), 0, 0, message)])
        if len(batch.states) > options.min_examples:
            coverage = Coverage(policy.table, batch.states, batch.actions, np.concatenate(batch.answers))
            tree = grow(np.concatenate(batch.targets), coverage, refiner, bias.tree)
            examples = f"{len(batch.states)} examples, {leaves(tree)} leaves"
            policy.add(tree, options.step_size, f"step size {options.step_size}, {examples}")
        yield Iteration(policy, episodes, tuple(recent))
