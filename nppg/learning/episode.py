"""Episodes, as they were."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Protocol

import numpy as np

from nppg.learning.gradient import total
from nppg.learning.options import Options
from nppg.policy.policy import Scores, choose, choose_best
from nppg.worlds.state import interpretation_of
from nppg.worlds.world import Action, State, World

IDLE = 1000  # episodes in a row without a step, after which there is nothing to wait for
Expert = Callable[[State], Sequence[Action]]  # what it would do in a state: some of the legal actions, or none
_NOTHING = np.empty(0)
_ROUNDING = Fraction(1, 10**12)  # what is so near to a whole number, relatively, is one


@dataclass(frozen=True, slots=True)
class Step:
    """A state as the policy sees it, with its legal actions, the answers to the policy's tests about them (shape
    (actions, tests)), their potentials and probabilities, the index of the action taken, and the reward; the state as
    it is; and whether an expert, who sees it so, chose the action. Where a list of rules was asked for a
    best action alone, it is the only one, and nothing was answered: the arrays are empty."""

    state: State
    actions: Sequence[Action]
    answers: np.ndarray
    potentials: np.ndarray
    probabilities: np.ndarray
    chosen: int
    reward: float
    actual: State
    guided: bool = False


@dataclass(frozen=True, slots=True)
class Episode:
    """The steps, the last state as the policy sees it, its legal actions (none where it is a goal or terminal state, so
    some where the episode was cut off), and whether it is a goal state. `actual`: the last state as it is."""

    steps: tuple[Step, ...]
    last: State
    open: Sequence[Action]
    success: bool
    actual: State

    @property
    def undiscounted(self) -> float:
        """The sum of its rewards."""
        return total(step.reward for step in self.steps)

    @property
    def guided(self) -> bool:
        """Whether the expert chose an action."""
        return any(step.guided for step in self.steps)


class Player(Protocol):
    """Who acts in an episode: a Policy, or what stands for one."""

    @property
    def domain(self) -> World: ...

    @property
    def greedy(self) -> bool: ...

    @property
    def is_rules(self) -> bool: ...

    def scores(self, state: State, actions: Sequence[Action]) -> Scores: ...

    def prefer(self, state: State, rng: np.random.Generator) -> Action: ...


@lru_cache
def longest(horizon: int, factor: float) -> int:
    """The steps after which an episode ends: `factor` times the horizon, rounded up. A product that is whole but for
    the rounding of the factor is whole: 1.1 times 50 is 55."""
    exact = Fraction(factor) * horizon
    whole = round(exact)
    return whole if abs(exact - whole) <= exact * _ROUNDING else math.ceil(exact)


def generate_episode(
    policy: Player,
    rng: np.random.Generator,
    guidance: float = 0.0,
    horizon_factor: float = 1.0,
    greedy: bool = False,
    learning: bool = False,
    start: State | None = None,
    revisits: bool = True,
    scored: bool = True,
    within: float | None = None,
    expert: Expert | None = None,
    floor: float = 0.0,
) -> Episode:
    """Draws a start state, unless it is given one, and acts until the episode ends: in a goal or terminal state, or cut
    off, by its environment, after horizon_factor times the domain's horizon, or when it is not over `within` so many
    seconds of processor time. Without `revisits` no action is taken that leads for certain to a state that the episode
    has been in, while there is another one. Where not all actions need be `scored`, a greedy list of rules is asked for
    a best one alone, unless that leads back.

    With probability `guidance` the whole episode is a trace of the `expert`, by default the domain's own; where it has
    no advice, the policy acts: greedily, if it is to or does so wherever it does not learn; of its other actions the
    share `floor` is drawn uniformly. Raises NppgError where the domain's code is at fault.
    """
    if not (type(guidance) is type(horizon_factor) is float and 0 <= guidance <= 1 and 0 <= horizon_factor < math.inf):
        given = Options(guidance=guidance, horizon_factor=horizon_factor)
        guidance, horizon_factor = given.guidance, float(given.horizon_factor)
    domain = policy.domain
    greedy = greedy or (policy.greedy and not learning)
    guided = guidance > 0 and bool(rng.random() < guidance)
    advise = domain.expert_actions if expert is None else expert
    state = domain.start(rng) if start is None else start
    met = None if revisits else {domain.interpreted(state).fingerprint}
    most = longest(domain.horizon(state), horizon_factor)
    until = None if within is None else time.process_time() + within
    steps: list[Step] = []
    lean = greedy and not (scored or guided or learning or domain.has_observation)
    lean = lean and policy.is_rules
    status, actions = domain.situation(state, lean)
    while status == "running" and len(steps) < most and not _is_over(until):
        seen = domain.observe(state, rng)
        advice: list[Action] = []
        best = policy.prefer(seen, rng) if lean else None
        if best is not None and not _leads_back(domain, state, best, met):
            actions, answers, potentials, probabilities = [best], _NOTHING, _NOTHING, _NOTHING
        else:
            if learning and type(actions) is not list:
                actions = list(actions)  # while they are at hand
            answers, potentials, probabilities = policy.scores(seen, actions)
            advice = [each for each in advise(state) if each in actions] if guided else []
        if advice:
            chosen = actions.index(advice[int(rng.random() * len(advice))])
        elif best is not None:
            chosen = actions.index(best)
        else:
            chosen = choose_best(potentials, rng) if greedy else choose(_floored(probabilities, floor), rng)
        if met is not None and len(actions) > 1 and not advice:
            weights = potentials if greedy else probabilities
            chosen = _leading_on(domain, state, actions, weights, chosen, met, greedy, rng)
        lean = lean or len(steps) + 1 == most  # nobody acts in the last state
        reward, following = domain.act(state, actions[chosen], rng, lean)
        steps.append(Step(seen, actions, answers, potentials, probabilities, chosen, reward, state, bool(advice)))
        state = following
        if met is not None:
            met.add(interpretation_of(state).fingerprint)
        status, actions = domain.situation(state, lean)
    return Episode(tuple(steps), domain.observe(state, rng), actions, status == "goal", state)


def _floored(probabilities: np.ndarray, floor: float) -> np.ndarray:
    return (1 - floor) * probabilities + floor / len(probabilities) if floor else probabilities


def _is_over(until: float | None) -> bool:
    """Whether it is this processor time, if it is limited."""
    return until is not None and time.process_time() >= until


def _leading_on(
    domain: World,
    state: State,
    actions: Sequence[Action],
    weights: np.ndarray,
    first: int,
    met: Collection[int],
    greedy: bool,
    rng: np.random.Generator,
) -> int:
    """The action that is chosen where those that lead back are left out, by potentials if it is greedy, else by
    probabilities; the first choice where all of them do."""
    chosen, left = first, np.arange(len(actions))
    while _leads_back(domain, state, actions[chosen], met):
        left = left[left != chosen]
        if len(left) == 0:
            return first
        own = weights[left]
        if greedy:
            chosen = int(left[choose_best(own, rng)])
        else:
            chosen = int(left[choose(own / own.sum() if own.sum() > 0 else np.full(len(own), 1 / len(own)), rng)])
    return chosen


def _leads_back(domain: World, state: State, action: Action, met: Collection[int] | None) -> bool:
    """Whether an action leads for certain to one of the states `met`, if these count."""
    following = None if met is None else domain.certain(state, action)
    return following is not None and met is not None and interpretation_of(following).fingerprint in met
