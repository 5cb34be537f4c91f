"""One episode, as it was."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from nppg.domain import Action, State
from nppg.gradient import gibbs
from nppg.policy import Policy, choose


@dataclass(frozen=True, slots=True)
class Step:
    """A state with its legal actions, the answers to the policy's tests about them (shape (actions, tests)),
    the policy's probabilities, the index of the action taken, and the reward."""

    state: State
    actions: Sequence[Action]
    answers: np.ndarray
    probabilities: np.ndarray
    chosen: int
    reward: float


@dataclass(frozen=True, slots=True)
class Episode:
    """The steps, the last state, and whether that is a goal state. `guided`: the expert chose the actions."""

    steps: tuple[Step, ...]
    last: State
    success: bool
    guided: bool


def generate_episode(
    policy: Policy,
    rng: np.random.Generator,
    guidance: float = 0.0,
    horizon_factor: float = 1.0,
    greedy: bool = False,
) -> Episode:
    """Draws a start state and acts until the episode ends: in a goal or terminal state, or after
    horizon_factor times the domain's horizon.

    With probability `guidance` the whole episode is a trace of the domain's expert. Raises NppgError where the
    domain's code is at fault.
    """
    domain = policy.domain
    guided = guidance > 0 and bool(rng.random() < guidance)
    state = domain.start(rng)
    limit = math.ceil(horizon_factor * domain.horizon(state))
    steps: list[Step] = []
    status, actions = domain.situation(state)
    while status == "running" and len(steps) < limit:
        answers = policy.table.answers(state, actions)
        probabilities = gibbs(policy.potentials_of(answers))
        advice = [each for each in domain.expert_actions(state) if each in actions] if guided else []
        if advice:
            chosen = actions.index(advice[int(rng.random() * len(advice))])
        else:
            chosen = choose(probabilities, rng, greedy)
        reward, following = domain.act(state, actions[chosen], rng)
        steps.append(Step(state, actions, answers, probabilities, chosen, reward))
        state = following
        status, actions = domain.situation(state)
    return Episode(tuple(steps), state, status == "goal", guided)
