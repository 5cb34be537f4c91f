"""How well a policy does: on sampled starts, or exactly over all of them."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from nppg.errors import NppgError
from nppg.judging.chain import reaching
from nppg.judging.memory import Memory, Remembering
from nppg.judging.space import Space
from nppg.learning.episode import generate_episode, longest
from nppg.learning.gradient import total
from nppg.learning.options import at_least
from nppg.policy.gibbs import best_of_groups, gibbs_of_groups
from nppg.policy.policy import Policy


@dataclass(frozen=True, slots=True)
class Evaluation:
    """`success`: share of episodes that reach a goal state within `horizon_factor` times the domain's horizon, 0 to 1.
    `mean_steps` and `mean_return` (undiscounted, sampled only) are per episode; `starts` is their number."""

    success: float
    starts: int
    exact: bool
    greedy: bool
    mean_steps: float
    mean_return: float | None = None


def merit(policy: Policy, result: Evaluation) -> tuple[str, float]:
    """What the policy is judged by, with its name: its success; the mean return where the domain has no goal."""
    if policy.domain.has_goal or result.mean_return is None:
        return "success", result.success
    return "mean_return", result.mean_return


def evaluate(
    policy: Policy,
    starts: int = 1000,
    seed: int = 0,
    greedy: bool = False,
    horizon_factor: float = 1.0,
    problems: Sequence[int] = (),
    revisits: bool = True,
) -> Evaluation:
    """Sampled: one episode from each of `starts` random start states, from a generator of its own; or, where they are
    given, from each of these problems of the domain. States that are met again are not asked about again. `revisits`:
    whether an episode may come back to a state while there is another action."""
    return _evaluated(policy, _remembering(policy, None), starts, seed, greedy, horizon_factor, problems, revisits)


def evaluate_both(
    policy: Policy,
    starts: int,
    seed: int,
    horizon_factor: float = 1.0,
    problems: Sequence[int] = (),
    memory: Memory | None = None,
) -> tuple[Evaluation, Evaluation]:
    """The stochastic policy and the greedy one, each as `evaluate` has it; `memory` is what earlier evaluations of the
    policy have left, whatever it has learned since."""
    player = _remembering(policy, memory)
    stochastic = _evaluated(policy, player, starts, seed, False, horizon_factor, problems)
    if policy.greedy:
        return stochastic, stochastic
    return stochastic, _evaluated(policy, player, starts, seed, True, horizon_factor, problems)


def _remembering(policy: Policy, memory: Memory | None) -> Remembering | None:
    return Remembering(policy, memory or Memory(policy.domain)) if Memory.suits(policy.domain) else None


def _evaluated(
    policy: Policy,
    remembering: Remembering | None,
    starts: int,
    seed: int,
    greedy: bool,
    horizon_factor: float,
    problems: Sequence[int],
    revisits: bool = True,
) -> Evaluation:
    starts, seed = len(problems) or at_least("starts", starts, 1), at_least("seed", seed, 0)
    greedy = greedy or policy.greedy
    player = policy if remembering is None or (greedy and policy.is_rules) else remembering
    rng = np.random.default_rng([seed, 0x6E707067])
    successes, steps, found = 0, 0, []
    for i in range(starts):
        start = player.domain.problem(problems[i]) if problems else None
        episode = generate_episode(
            player,
            rng,
            greedy=greedy,
            horizon_factor=horizon_factor,
            start=start,
            revisits=revisits,
            scored=False,
        )
        successes += episode.success
        steps += len(episode.steps)
        found.append(episode.undiscounted)
    return Evaluation(successes / starts, starts, False, greedy, steps / starts, total(found) / starts)


def spread(problems: Sequence[int], most: int) -> Sequence[int]:
    """At most so many of them, at even distances."""
    return problems[:: -(-len(problems) // most)] if problems else []


class ExactEvaluator:
    """Evaluates policies of one domain over its whole state space; what does not depend on the trees is computed
    once. `space` may come from another evaluator of the domain with the same parameters. Raises NppgError where the
    domain has no goal or no finite space with a uniform start."""

    def __init__(self, policy: Policy, space: Space | None = None):
        if not policy.domain.has_goal:
            raise NppgError(f"{policy.domain.path}: exact evaluation is about goal/0, which the domain does not define")
        self.policy = policy
        self.space = space or Space(policy.domain)
        self._first = np.flatnonzero(np.diff(self.space.owner, prepend=-1))  # pair of each running class
        self._answers = np.empty((0, 0))
        self._row = np.empty(0, int)  # of each pair among the distinct answers
        self._potentials: np.ndarray | None = None  # of a snapshot

    def of(self, policy: Policy) -> ExactEvaluator:
        """An evaluator of another policy over the same table, with all that has been computed for this one."""
        other = copy.copy(self)
        other.policy = policy
        return other

    def snapshot(self) -> ExactEvaluator:
        """An evaluator of the policy as it is now, whatever it learns later; its potentials are computed once."""
        potentials = self.potentials()
        other = copy.copy(self)
        other._potentials = potentials
        return other

    def potentials(self) -> np.ndarray:
        """Psi of each pair of the space."""
        if self._potentials is not None:
            return self._potentials
        space, policy = self.space, self.policy
        if named := policy.named() & space.objects:
            raise NppgError(f"the policy names {sorted(named)}, which the domain declares interchangeable")
        if policy.table.bounds and any(isinstance(each, int | float) for each in space.objects):
            raise NppgError(f"the policy compares numbers, and {space.domain.path} declares numbers interchangeable")
        if len(self._row) == 0 or self._answers.shape[1] != policy.width:
            rows = [policy.answers(*pairs) for pairs in zip(space.states, space.actions, strict=True) if pairs[1]]
            self._answers, self._row = _distinct(np.concatenate(rows))
        return policy.potentials_of(self._answers)[self._row]

    def probabilities(self, greedy: bool = False) -> np.ndarray:
        """pi(s, a) of each pair of the space; the greedy policy chooses evenly among the best actions."""
        potentials = self.potentials()
        if not self._is_greedy(greedy):
            return gibbs_of_groups(potentials, self._first)
        sizes = np.diff(self._first, append=len(potentials))
        best = best_of_groups(potentials, self._first).astype(float)
        return best / np.repeat(np.add.reduceat(best, self._first), sizes)

    def _is_greedy(self, wanted: bool) -> bool:
        return wanted or self.policy.greedy

    def by_class(self, greedy: bool = False, horizon_factor: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
        """The success probability and the expected number of steps from each class of the space, 0 where it is not a
        start; see nppg.judging.chain."""
        return reaching(self.space, self.probabilities(greedy), self._limits(horizon_factor))

    def _limits(self, horizon_factor: float) -> np.ndarray:
        """The steps after which an episode ends that starts in each class."""
        return np.array([longest(horizon, horizon_factor) for horizon in self.space.horizons])

    def certain(self, greedy: bool = False) -> np.ndarray:
        """From which start classes no possible course misses the goal; without probabilities, so nothing is rounded.
        The stochastic policy can take every legal action."""
        space = self.space
        taken = self.probabilities(True) > 0 if self._is_greedy(greedy) else np.ones(len(space.owner), bool)
        possible = taken[space.origin]
        source, target = space.owner[space.origin][possible], space.target[possible]
        goal = np.array([status == "goal" for status in space.status])
        limits = np.array(space.horizons)
        sure, found = goal, np.zeros(len(goal), bool)
        for t in range(1, limits.max() + 1):
            missing = np.bincount(source, ~sure[target], len(goal)) > 0
            sure = goal | space.running & ~missing
            found |= sure & (limits == t)
        return found & space.running

    def sample(
        self, starts: np.ndarray, rng: np.random.Generator, greedy: bool = False, horizon_factor: float = 1.0
    ) -> np.ndarray:
        """One episode from each of the classes `starts`: whether it reaches the goal. States of one class differ by
        names alone, so this draws from the same distribution as acting in the states themselves."""
        space = self.space
        heads = np.searchsorted(space.owner, np.arange(len(space.states) + 1))  # first pair of each class
        outcomes = np.searchsorted(space.origin, np.arange(len(space.owner) + 1))
        chance, weight = np.cumsum(self.probabilities(greedy)), np.cumsum(space.weight)
        limits = self._limits(horizon_factor)[starts]
        now, goal = np.array(starts), np.array([status == "goal" for status in space.status])
        for t in range(limits.max(initial=0)):
            acting = np.flatnonzero(space.running[now] & (t < limits))
            pairs = _drawn(chance, heads[now[acting]], heads[now[acting] + 1], rng)
            now[acting] = space.target[_drawn(weight, outcomes[pairs], outcomes[pairs + 1], rng)]
        return goal[now]

    def evaluate(self, greedy: bool = False, horizon_factor: float = 1.0) -> Evaluation:
        """The mean over all start states."""
        success, steps = self.by_class(greedy, horizon_factor)
        greedy, means = self._is_greedy(greedy), [self.space.mean(each) for each in (success, steps)]
        return Evaluation(means[0], self.space.starts, True, greedy, means[1])


def _drawn(cumulative: np.ndarray, first: np.ndarray, end: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """For each stretch from `first` to `end` a number of it, drawn by its share of the cumulative weights."""
    low, high = np.where(first > 0, cumulative[first - 1], 0.0), cumulative[end - 1]
    found = np.searchsorted(cumulative, low + rng.random(len(first)) * (high - low), side="right")
    return np.clip(found, first, end - 1)


def _distinct(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The distinct rows, and the number of each row among them."""
    keys = np.packbits(rows, axis=1) if rows.dtype == bool else rows
    _, first, number = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    return rows[first], number.reshape(-1)  # NumPy 2.0 gives a column


def evaluate_exactly(policy: Policy, greedy: bool = False, horizon_factor: float = 1.0) -> Evaluation:
    """Exact: over all start states of a domain that declares a uniform start over a finite space. Raises
    NppgError for other domains."""
    return ExactEvaluator(policy).evaluate(greedy, horizon_factor)
