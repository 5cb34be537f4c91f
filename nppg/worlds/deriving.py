"""Derived predicates that are worth testing in a domain, as its start states show them."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import write_files
from nppg.errors import NppgError
from nppg.features.derived import Derived, Words
from nppg.features.selection import candidates, extensions, text
from nppg.worlds.domain import Domain
from nppg.worlds.state import static_of
from nppg.worlds.world import State

_STARTS = 20  # from which states are drawn
_STEPS = 60  # from each of them


def worth_testing(domain: Domain, bias: LanguageBias) -> list[Derived]:
    """Those that tell something in states that random actions lead to, and nothing that an earlier one tells; whose
    answers can all be asked for. Raises NppgError."""
    found = candidates(domain.module, bias, Words.of(bias, domain.fluents, domain.static, domain.predicates))
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, domain.path.name)
        write_files(file.parent, {file.name: domain.source + text(found).encode(), **domain.used})
        try:
            seen = _seen(Domain(file, domain.given, domain.trusted), _starts(domain), found)
        except NppgError as error:
            own = (replace(each, file=str(domain.path)) if each.file == str(file) else each for each in error.problems)
            raise NppgError(own) from None
    kept: dict[tuple, Derived] = {}
    for each, answers in zip(found, zip(*seen, strict=True), strict=True) if seen else ():
        if "error" not in answers and any(answers) and (each.types or not all(answers)):
            kept.setdefault((each.types, answers), each)
    return list(kept.values())


def _seen(domain: Domain, starts: Sequence[State], found: Sequence[Derived]) -> list[list[str | int]]:
    """What tells the answers of all of them apart, by state. What hangs on static facts alone is asked once in a
    problem; what has once been in error stays so."""
    lasting = {each.name for each in found if domain.loaded.is_static(each.name, len(each.types))}
    wrong: set[str] = set()
    seen, answers, static = [], dict[str, str | int](), None
    for state in _states(domain, starts):
        domain.visit(state)
        if static_of(domain.interpreted(state)) is not static:
            static, answers = static_of(domain.interpreted(state)), {}
        known = wrong | (lasting & answers.keys())
        asked = [each for each in found if each.name not in known]
        answers |= dict(zip((each.name for each in asked), extensions(domain.module, asked), strict=True))
        wrong |= {each.name for each in asked if answers[each.name] == "error"}
        seen.append([answers[each.name] if each.name not in wrong else "error" for each in found])
    return seen


def _starts(domain: Domain) -> list[State]:
    chosen, rng = domain.chosen, np.random.default_rng(0)
    if not chosen:
        return [domain.start(rng) for _ in range(_STARTS)]
    places = np.linspace(0, len(chosen) - 1, min(len(chosen), _STARTS)).astype(int)
    return [domain.problem(chosen[place]) for place in places]


def _states(domain: Domain, starts: Sequence[State]) -> Iterator[State]:
    rng = np.random.default_rng(0)
    for start in starts:
        state = start
        for _ in range(_STEPS):
            status, actions = domain.situation(state)
            if status != "running":
                state = start
                continue
            yield state
            _, state = domain.act(state, actions[int(rng.random() * len(actions))], rng)
