"""Detours: other ways tried from states that episodes have met (exploring starts), to be compared with what is known.

What is known of a state is the length of the shortest way from it that has been gone, and where actions can be taken in
any order, or several objects can do the same, most ways have hardly been gone. So a detour that begins with another
action goes on as the known way does, as far as that is possible, and then as the policy does; and a known way is gone
without one of its steps and those that are impossible without it (action elimination: Nakhost and Müller 2010). Either
ends where it comes to a state from which a way is known, mostly at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nppg.learning.experience import Ways
from nppg.policy.policy import Policy, choose
from nppg.worlds.state import Interpretation, interpretation_of
from nppg.worlds.world import Action

_SPARE = 10  # steps that a detour may take beyond the known way


def detours(ways: Ways, numbers: Sequence[int], policy: Policy, rng: np.random.Generator, most: float) -> int:
    """Tries in states of a problem from which a way is known, in any order, to do without the first step of that, and
    an action that has not been tried there, if one is left; until `most` steps are taken. Returns how many were."""
    steps = 0
    for at in rng.permutation(len(numbers)).tolist():
        if steps >= most:
            break
        if numbers[at] in ways.distances:
            steps += _without_first(ways, numbers[at], policy, rng)
            steps += _detour(ways, numbers[at], policy, rng)
    return steps


def _without_first(ways: Ways, number: int, policy: Policy, rng: np.random.Generator) -> int:
    """What comes of it is remembered only where it is shorter: else it says little of the actions that are left."""
    known = ways.distances[number]
    if known < 2 or ways.needed.get(number) == known:
        return 0
    ways.needed[number] = known
    domain, state = policy.domain, interpretation_of(ways.states[number])
    status, actions = domain.situation(state)
    gone: list[tuple[Interpretation, list[Action], Action]] = []
    for action in ways.way(number)[1:]:
        if action in actions:
            gone.append((state, list(actions), action))
            state = interpretation_of(domain.act(state, action, rng)[1])
            status, actions = domain.situation(state)
            if ways.distance(state) is not None:
                break
    left = 0 if status == "goal" else ways.distance(state)
    if gone and left is not None and len(gone) + left < known:
        numbers = [ways.number(each) for each, *_ in gone] + [ways.number(state)]
        if status == "goal":
            ways.end(numbers[-1], True)
        for (_, legal, action), before, after in zip(gone, numbers, numbers[1:], strict=False):
            ways.lead(before, legal, action, after)
            ways.visits[after] += 1
    return len(gone)


def _detour(ways: Ways, number: int, policy: Policy, rng: np.random.Generator) -> int:
    legal, tried = ways.legal[number], ways.tried[number]
    if legal is None or len(tried) == len(legal):
        return 0
    untried = [action for action in legal if action not in tried]
    action, domain = untried[int(rng.random() * len(untried))], policy.domain
    way = ways.way(number)
    if action in way:
        way.remove(action)
    state = ways.states[number]
    most = 2 * ways.distances[number] + _SPARE
    for taken in range(1, most + 1):
        _, state = domain.act(state, action, rng)
        before, number = number, ways.number(interpretation_of(state))
        is_known = number in ways.distances
        ways.lead(before, legal, action, number)
        ways.visits[number] += 1
        if is_known:
            return taken
        status, actions = domain.situation(state)
        if status != "running":
            ways.end(number, status == "goal")
            return taken
        legal = list(actions)
        among = set(legal)
        if possible := [each for each in way if each in among]:
            action = possible[0]
            way.remove(action)
        else:
            action = legal[choose(policy.scores(state, legal).probabilities, rng)]
    return most
