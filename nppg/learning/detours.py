"""Detours: other actions tried in states that episodes have met (exploring starts), to be compared with what is known.

A detour ends where it comes to a state from which a way is known, mostly at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from nppg.learning.experience import Ways
from nppg.policy.policy import Policy, choose
from nppg.worlds.state import interpretation_of

_SPARE = 10  # steps that a detour may take beyond the known way


def detours(ways: Ways, numbers: Sequence[int], policy: Policy, rng: np.random.Generator, most: float) -> int:
    """Tries in states of a problem, in any order, an action that has not been tried there, where one is left and a way
    is known from it, and goes on as the policy does, for no longer than there and back; until `most` steps are taken.
    Returns how many were."""
    known, steps = ways.distances, 0
    for at in rng.permutation(len(numbers)).tolist():
        if steps >= most:
            break
        if numbers[at] in known:
            steps += _detour(ways, numbers[at], known, policy, rng)
    return steps


def _detour(ways: Ways, number: int, known: Mapping[int, int], policy: Policy, rng: np.random.Generator) -> int:
    legal, tried = ways.legal[number], ways.tried[number]
    if legal is None or len(tried) == len(legal):
        return 0
    untried = [action for action in legal if action not in tried]
    action, domain = untried[int(rng.random() * len(untried))], policy.domain
    state = ways.states[number]
    most = 2 * known[number] + _SPARE
    for taken in range(1, most + 1):
        _, state = domain.act(state, action, rng)
        before, number = number, ways.number(interpretation_of(state))
        ways.lead(before, legal, action, number)
        ways.visits[number] += 1
        if number in known:
            return taken
        status, actions = domain.situation(state)
        if status != "running":
            ways.end(number, status == "goal")
            return taken
        legal = list(actions)
        action = legal[choose(policy.scores(state, legal).probabilities, rng)]
    return most
