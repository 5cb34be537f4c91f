"""A finite state space up to the renaming of interchangeable objects, for exact evaluation.

The classes of states are found by following all legal actions from a start state. Facts that no action changes
(the goal, for instance) are kept as they are, and the objects that they name are not renamed; every other choice
of them is a renaming of this one, as drawn starts are held against.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from nppg.canonical import Canonizer
from nppg.domain import Action, Domain, Ground, State
from nppg.errors import NppgError

_DRAWN = 32  # starts that are held against the space


class Space:
    """The classes of a domain's states, each with one representative.

    `states`, `sizes`, `status`, `horizons` and `actions` have an entry for each class, and `running` says which are
    start states, `starts` of them in all. The pairs of a running class
    and one of its actions are numbered through; `owner` is the class of each pair. An outcome leads from the pair
    `origin` to the class `target` with probability `weight`.

    Raises NppgError where the domain does not declare `uniform_start`, where there are more than `limit` classes,
    or where drawn starts contradict the declaration.
    """

    def __init__(self, domain: Domain, limit: int = 200_000):
        if not domain.uniform_start:
            raise NppgError(
                f"{domain.path}: exact evaluation needs a finite space with a uniform start distribution, which the "
                "domain does not declare (:- uniform_start); evaluate on sampled starts"
            )
        self.domain = domain
        self.limit = limit
        rng = np.random.default_rng(0)
        drawn = [domain.start(rng) for _ in range(_DRAWN)]
        objects = {each for name in domain.interchangeable for each in self._objects(drawn[0], name)}
        rigid = {_name(fact) for fact in drawn[0]}
        while (changed := self._explore(drawn[0], objects, rigid)) is not None:
            rigid.discard(changed)
        self._check(drawn, objects)
        self.running = np.array([status == "running" for status in self.status])
        self.starts = sum(size for size, running in zip(self.sizes, self.running, strict=True) if running)

    def _objects(self, state: State, predicate: str) -> list[Ground]:
        self.domain.visit(state)
        return self.domain.members(predicate)

    def _explore(self, start: State, objects: set[Ground], rigid: set[Ground]) -> Ground | None:
        """Finds all classes; returns the name of a fact that was taken for rigid and is not."""
        fixed = {fact for fact in start if _name(fact) in rigid}
        named = {each for fact in fixed for each in _atoms(fact)}
        free = objects - named
        canonizer = Canonizer(free)
        renamings = math.factorial(len(free))
        form, symmetries = canonizer.form(start)
        number = {form: 0}
        self.states: list[State] = [start]
        self.sizes = [renamings // symmetries]
        self.status: list[str] = []
        self.horizons: list[int] = []
        self.actions: list[list[Action]] = []
        origin: list[int] = []  # of each outcome: the number of the state-action pair
        target: list[int] = []
        weight: list[float] = []
        pairs = 0
        for state in self.states:
            self.status.append(self.domain.situation(state).status)
            running = self.status[-1] == "running"
            self.horizons.append(self.domain.horizon(state) if running else 0)
            neighbours = self.domain.neighbours(state)
            self.actions.append([action for action, _ in neighbours] if running else [])
            for _, outcomes in neighbours:
                for probability, successor in outcomes:
                    form, symmetries = canonizer.form(successor)
                    if form not in number:
                        strange = fixed.symmetric_difference(fact for fact in successor if _name(fact) in rigid)
                        if strange:
                            return _name(strange.pop())
                        if len(number) == self.limit:
                            raise NppgError(
                                f"{self.domain.path}: more than {self.limit} classes of states; evaluate on samples"
                            )
                        number[form] = len(self.states)
                        self.states.append(successor)
                        self.sizes.append(renamings // symmetries)
                    if running:
                        origin.append(pairs)
                        target.append(number[form])
                        weight.append(probability)
                pairs += running
        counts = [len(actions) for actions in self.actions]
        self.owner = np.repeat(np.arange(len(counts)), counts)
        self.origin, self.target, self.weight = np.array(origin), np.array(target), np.array(weight)
        self.free = free
        return None

    def _check(self, drawn: Iterable[State], objects: set[Ground]) -> None:
        """Whether drawn starts are in the space, up to a renaming of all objects."""
        anything = Canonizer(objects)
        known = {anything.form(state)[0] for state in self.states}
        for state in drawn:
            if anything.form(state)[0] not in known:
                raise NppgError(
                    f"{self.domain.path}: not all starts can be reached from one of them (by a renaming of objects), "
                    f"for instance {state}; evaluate on sampled starts"
                )

    def lengths(self) -> dict[int, int]:
        """How many starts have each horizon."""
        found: dict[int, int] = {}
        for size, status, horizon in zip(self.sizes, self.status, self.horizons, strict=True):
            if status == "running":
                found[horizon] = found.get(horizon, 0) + size
        return dict(sorted(found.items()))


def _name(fact: Ground) -> Ground:
    return fact[0] if isinstance(fact, tuple) else fact


def _atoms(term: Ground) -> Iterable[Ground]:
    if isinstance(term, tuple):
        for arg in term[1:]:
            yield from _atoms(arg)
    else:
        yield term
