"""How well a policy does: on sampled starts, or exactly over all of them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from nppg.episode import generate_episode
from nppg.errors import NppgError
from nppg.gradient import gibbs
from nppg.options import at_least
from nppg.policy import Policy, is_best
from nppg.space import Space


@dataclass(frozen=True, slots=True)
class Evaluation:
    """`success`: share of episodes that reach a goal state within the domain's horizon, 0 to 1. `mean_steps`
    and `mean_return` (undiscounted, sampled only) are per episode; `starts` is their number."""

    success: float
    starts: int
    exact: bool
    greedy: bool
    mean_steps: float
    mean_return: float | None = None


def evaluate(
    policy: Policy, starts: int = 1000, seed: int = 0, greedy: bool = False, horizon_factor: float = 1.0
) -> Evaluation:
    """Sampled: one episode from each of `starts` random start states, from a generator of its own."""
    at_least("starts", starts, 1)
    at_least("seed", seed, 0)
    rng = np.random.default_rng([seed, 0x6E707067])
    successes, steps, total = 0, 0, 0.0
    for _ in range(starts):
        episode = generate_episode(policy, rng, greedy=greedy, horizon_factor=horizon_factor)
        successes += episode.success
        steps += len(episode.steps)
        total += sum(step.reward for step in episode.steps)
    return Evaluation(successes / starts, starts, False, greedy, steps / starts, total / starts)


class ExactEvaluator:
    """Evaluates policies of one domain over its whole state space; what does not depend on the policy, and each
    pair's answers to the tests, are computed once."""

    def __init__(self, policy: Policy, limit: int = 200_000):
        if not policy.domain.has_goal:
            raise NppgError(f"{policy.domain.path}: exact evaluation is about goal/0, which the domain does not define")
        self.space = Space(policy.domain, limit)
        self.policy = policy
        self._answers = np.empty((0, 0), bool)

    def potentials(self) -> np.ndarray:
        """Psi of every pair of a running class and a legal action, in the order of the space; 0 for others."""
        space, table = self.space, self.policy.table
        named = {arg for test in table.tests for literal in test for arg in literal.args} & space.free
        if named:
            raise NppgError(f"the policy names {sorted(named)}, which the domain declares interchangeable")
        if self._answers.shape[1] != len(table) or not len(self._answers):
            rows = [
                table.answers(state, actions) if running else np.zeros((len(actions), len(table)), bool)
                for state, actions, running in zip(space.states, space.actions, space.running, strict=True)
            ]
            distinct, inverse = np.unique(np.packbits(np.concatenate(rows), axis=1), axis=0, return_inverse=True)
            self._answers = np.unpackbits(distinct, axis=1, count=len(table)).astype(bool)
            self._inverse = inverse.reshape(-1)
        return self.policy.potentials_of(self._answers)[self._inverse]

    def probabilities(self, greedy: bool = False) -> np.ndarray:
        """pi(s, a) of every such pair; the greedy policy chooses evenly among the best actions."""
        result = np.zeros(self.space.pairs[-1])
        potentials = self.potentials()
        for a, b, running in zip(self.space.pairs[:-1], self.space.pairs[1:], self.space.running, strict=True):
            if running:
                own = gibbs(potentials[a:b])
                result[a:b] = is_best(own) / is_best(own).sum() if greedy else own
        return result

    def evaluate(self, greedy: bool = False, horizon_factor: float = 1.0) -> Evaluation:
        """By backward induction: V_t(s), the probability to reach a goal state within t steps, and U_t(s), the
        expected number of steps when at most t are taken."""
        space = self.space
        probabilities = self.probabilities(greedy)
        flow = probabilities[space.origin] * space.weight
        source = np.repeat(np.arange(len(space.states)), np.diff(space.pairs))[space.origin]
        limits = np.array([math.ceil(horizon_factor * horizon) for horizon in space.horizons])
        value, length = space.goal.astype(float), np.zeros(len(space.states))
        success, steps = np.zeros(len(value)), np.zeros(len(value))
        for t in range(1, limits.max(initial=0) + 1):
            value = np.where(
                space.running, np.bincount(source, flow * value[space.target], len(value)), space.goal.astype(float)
            )
            length = np.where(space.running, 1 + np.bincount(source, flow * length[space.target], len(value)), 0.0)
            success[limits == t], steps[limits == t] = value[limits == t], length[limits == t]
        running = np.flatnonzero(space.running)
        share = np.array([space.sizes[i] / space.starts for i in running])
        return Evaluation(
            math.fsum(share * success[running]), space.starts, True, greedy, math.fsum(share * steps[running])
        )


def evaluate_exactly(policy: Policy, greedy: bool = False, horizon_factor: float = 1.0) -> Evaluation:
    """Exact: over all start states of a domain that declares a uniform start over a finite space. Raises
    NppgError for other domains."""
    return ExactEvaluator(policy).evaluate(greedy, horizon_factor)
