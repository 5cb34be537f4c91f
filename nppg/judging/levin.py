"""Levin tree search: a plan by a policy that is nearly right (Orseau, Lelis, Lattimore and Weber 2018, LevinTS).

Nodes are expanded in the order of d(n) / p(n): their depth, and the probability that the policy draws the actions that
lead to them. So a goal at depth d and of probability p is found within d / p expansions. A state that is met again by
a path that is not more probable is cut, which loses nothing, as the policy sees no more than the state.

The policy that is followed is a mixture p = 0.9 g + 0.09 pi + 0.01 / |A|. What the policy would do greedily, g, has
most of it: else a long plan had hardly any probability where actions are tied, though the policy alone finds it. By the
last part every plan is found, given time.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from heapq import heappop, heappush
from itertools import count

import numpy as np

from nppg.errors import NppgError, Problem
from nppg.judging.problems import DEAD_END, LIMIT, SOLVED, TIME, Attempt, to_attempt
from nppg.learning.options import at_least
from nppg.policy.policy import Policy, choose_best
from nppg.worlds.domain import Domain
from nppg.worlds.state import interpretation_of
from nppg.worlds.world import Action, State

BUDGET = 10_000
_GREEDY = 0.9
_UNIFORM = 0.01


@dataclass(slots=True, eq=False)
class _Node:
    """A state as a path has led to it, which has this log probability. `ranked`: its actions by their numbers, the most
    probable first, with their log probabilities."""

    state: State
    parent: _Node | None = None
    action: Action = ""
    depth: int = 0
    log: float = 0.0
    actions: Sequence[Action] = ()
    ranked: np.ndarray = field(default_factory=lambda: np.empty(0, int))
    logs: np.ndarray = field(default_factory=lambda: np.empty(0))


def search(policy: Policy, problem: int, budget: int = BUDGET, seconds: float = math.inf, seed: int = 0) -> Attempt:
    """A plan for the problem of this number, in at most so many expansions and about so many seconds of processor time:
    `ended` is solved, `limit` or `time`, or `dead end` where no state is left, so that there is no plan. `seed` is of
    what is drawn, ties. Raises NppgError, also where outcomes are left to chance."""
    domain = policy.domain
    if domain.has_chance or domain.environment:
        what = "its environment cannot be searched" if domain.environment else "its outcomes are left to chance"
        raise _not_for(domain, what)
    budget = at_least("budget", budget, 1)
    rng, unused = np.random.default_rng([at_least("seed", seed, 0), problem]), np.random.default_rng(0)
    untouched = unused.bit_generator.state
    tree = _Tree(policy, rng)
    start = domain.problem(problem)
    domain.visit(start)
    clock = time.process_time()
    node: _Node | None = _Node(start)
    ended = DEAD_END
    while node:
        if tree.is_new(node):
            if tree.expanded == budget or time.process_time() - clock > seconds:
                ended = LIMIT if tree.expanded == budget else TIME
                break
            if tree.expand(node) == "goal":
                ended = SOLVED
                break
        node = tree.following(unused)
    if unused.bit_generator.state != untouched:
        raise _not_for(domain, "its effects or rewards draw numbers")
    spent = round(time.process_time() - clock, 3)
    path = _path(node) if node and ended == SOLVED else []
    plan = tuple(each.action for each in path)
    cost: float = len(plan)
    if domain.has_costs:
        cost = sum(domain.cost(each.parent.state, each.action) for each in path if each.parent)
    return Attempt(problem, domain.problems[problem], ended, len(plan), cost, spent, plan, expansions=tree.expanded)


def searched(
    policy: Policy,
    budget: int = BUDGET,
    seconds: float = math.inf,
    seed: int = 0,
    problems: Iterable[int] | None = None,
) -> Iterator[Attempt]:
    """One after the other, on these problems; by default on those that `attempts` takes."""
    for problem in to_attempt(policy.domain, problems):
        yield search(policy, problem, budget, seconds, seed)


class _Tree:
    """What has been searched, and what is to be. The children of a node stand in the queue one at a time, and their
    states are found as they leave it: most never do."""

    def __init__(self, policy: Policy, rng: np.random.Generator):
        self.policy = policy
        self.expanded = 0
        self._rng = rng
        self._logs: dict[int, float] = {}  # of the most probable path to a state, by its fingerprint
        self._queue: list[tuple[float, int, _Node, int]] = []
        self._serial = count()

    def is_new(self, node: _Node) -> bool:
        """Whether no path to its state has been met that is as probable."""
        fingerprint = interpretation_of(node.state).fingerprint
        if node.log <= self._logs.get(fingerprint, -math.inf):
            return False
        self._logs[fingerprint] = node.log
        return True

    def expand(self, node: _Node) -> str:
        """Has its children wait in the queue: the status of its state."""
        domain = self.policy.domain
        self.expanded += 1
        status, actions = domain.situation(node.state)
        if status == "running":
            scores = self.policy.scores(domain.observe(node.state, self._rng), actions)
            mixed = (1 - _GREEDY - _UNIFORM) * scores.probabilities + _UNIFORM / len(actions)
            mixed[choose_best(scores.potentials, self._rng)] += _GREEDY
            node.actions = actions
            node.ranked = np.argsort(-mixed, kind="stable")
            node.logs = np.log(mixed[node.ranked])
            self._wait(node, 0)
        return status

    def following(self, rng: np.random.Generator) -> _Node | None:
        """The next of those in the queue, none where it is empty."""
        if not self._queue:
            return None
        _, _, parent, number = heappop(self._queue)
        if number + 1 < len(parent.ranked):
            self._wait(parent, number + 1)
        action = parent.actions[int(parent.ranked[number])]
        _, state = self.policy.domain.act(parent.state, action, rng)
        return _Node(state, parent, action, parent.depth + 1, parent.log + float(parent.logs[number]))

    def _wait(self, parent: _Node, number: int) -> None:
        cost = math.log(parent.depth + 1) - parent.log - float(parent.logs[number])
        heappush(self._queue, (cost, next(self._serial), parent, number))


def _not_for(domain: Domain, what: str) -> NppgError:
    message = f"a search needs a domain in which an action has one outcome: {what}"
    return NppgError([Problem(str(domain.path), 0, 0, message)])


def _path(node: _Node) -> list[_Node]:
    """The nodes that an action has led to, from the start to this one."""
    found = []
    while node.parent:
        found.append(node)
        node = node.parent
    return found[::-1]
