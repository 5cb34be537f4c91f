"""Derived predicates that are worth testing in a domain, as its problems show them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.features.derived import Derived, Words
from nppg.features.selection import candidates, extensions
from nppg.worlds.domain import Domain
from nppg.worlds.world import State

_STARTS = 20  # from which states are drawn
_STEPS = 60  # from each of them


def derived(domain: Domain, bias: LanguageBias) -> list[Derived]:
    """Those of a domain that has none yet."""
    names = {name for name, _ in domain.predicates}
    return candidates(domain.module, bias, Words.of(bias, domain.fluents, domain.static, names))


def telling(domain: Domain, found: Sequence[Derived]) -> list[Derived]:
    """Those that tell something in states that random actions lead to, and nothing that an earlier one tells. The
    domain has their clauses."""
    seen: list[list[str | int]] = []
    for state in _states(domain):
        domain.visit(state)
        seen.append(extensions(domain.module, found))
    kept: dict[tuple, Derived] = {}
    for each, answers in zip(found, zip(*seen, strict=True), strict=True):
        if any(answers) and (each.types or not all(answers)):
            kept.setdefault((each.types, answers), each)
    return list(kept.values())


def _states(domain: Domain) -> Iterator[State]:
    rng = np.random.default_rng(0)
    chosen = domain.chosen
    starts = [domain.problem(chosen[i]) for i in np.linspace(0, len(chosen) - 1, min(len(chosen), _STARTS)).astype(int)]
    for start in starts or [domain.start(rng) for _ in range(_STARTS)]:
        state = start
        for _ in range(_STEPS):
            status, actions = domain.situation(state)
            if status != "running":
                state = start
                continue
            yield state
            _, state = domain.act(state, actions[int(rng.random() * len(actions))], rng)
