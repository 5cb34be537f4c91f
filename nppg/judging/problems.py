"""How a policy does on problems, one by one, and the plans that it finds."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from nppg.learning.episode import Episode, generate_episode
from nppg.learning.options import at_least
from nppg.policy.gibbs import best
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain
from nppg.worlds.state import interpretation_of
from nppg.worlds.world import Action

SOLVED = "solved"
DEAD_END = "dead end"
LOOP = "loop"
LIMIT = "limit"
TIME = "time"
_AGAIN = 3  # an episode that ends at its limit was in a loop if it has been in a state so often


@dataclass(frozen=True, slots=True)
class Attempt:
    """One episode on a problem: `ended` is solved, or what stopped it: a dead end (or another terminal state), a loop,
    the limit of steps or of time. `cost` is that of its actions by the domain's cost/2, else their number; `seconds`
    are those of acting, of processor time. `plan`: its actions. `avoided`: how many times a greedy policy took another
    action than it would prefer, because that leads back. `expansions`: those of a search."""

    problem: int
    name: str
    ended: str
    steps: int
    cost: float
    seconds: float
    plan: tuple[Action, ...]
    avoided: int = 0
    expansions: int | None = None

    @property
    def solved(self) -> bool:
        """Whether it reached the goal."""
        return self.ended == SOLVED


def attempt(
    policy: Policy,
    problem: int,
    seed: int = 0,
    greedy: bool = True,
    horizon_factor: float = 1.0,
    revisits: bool = True,
    within: float | None = None,
) -> Attempt:
    """One episode on the problem of this number, from a generator of its own; it is not solved where
    that takes more than `within` seconds of acting. Raises NppgError."""
    domain = policy.domain
    rng = np.random.default_rng([at_least("seed", seed, 0), problem])
    start = domain.problem(problem)
    domain.visit(start)
    clock = time.process_time()
    episode = generate_episode(
        policy,
        rng,
        greedy=greedy,
        horizon_factor=horizon_factor,
        start=start,
        revisits=revisits,
        scored=False,
        within=within,
    )
    seconds = time.process_time() - clock
    plan = tuple(step.actions[step.chosen] for step in episode.steps)
    if domain.has_costs:
        cost = sum(domain.cost(step.actual, action) for step, action in zip(episode.steps, plan, strict=True))
    else:
        cost = len(plan)
    ended = _ended(episode) if within is None or seconds < within else TIME
    avoids = (greedy or policy.greedy) and not revisits
    turned = (step for step in episode.steps if avoids and len(step.potentials))
    avoided = sum(not best(step.potentials)[step.chosen] for step in turned)
    return Attempt(problem, domain.problems[problem], ended, len(plan), cost, round(seconds, 3), plan, avoided)


def attempts(
    policy: Policy,
    problems: Iterable[int] | None = None,
    seed: int = 0,
    greedy: bool = True,
    horizon_factor: float = 1.0,
    revisits: bool = True,
    within: float | None = None,
) -> Iterator[Attempt]:
    """One after the other, on these problems; by default on those that the domain's start states are drawn from, or
    all of them."""
    for problem in to_attempt(policy.domain, problems):
        yield attempt(policy, problem, seed, greedy, horizon_factor, revisits, within)


def to_attempt(domain: Domain, problems: Iterable[int] | None) -> Iterable[int]:
    """These problems; by default those that the domain's start states are drawn from, or all of them."""
    return (domain.chosen or domain.problems) if problems is None else problems


def _ended(episode: Episode) -> str:
    if episode.success:
        return SOLVED
    if not episode.open:
        return DEAD_END
    met = Counter(interpretation_of(step.actual).fingerprint for step in episode.steps)
    return LOOP if max(met.values(), default=0) >= _AGAIN else LIMIT
