"""A finite state space up to the renaming of interchangeable objects, for exact evaluation.

The classes of states are found by following all legal actions from a start state. Facts that no action changes
(the goal, for instance) are kept as they are, and the objects that they name are not renamed; every other choice
of them is a renaming of this one. What the domain promises is held against drawn starts, and renamings of them.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from functools import cached_property, lru_cache
from itertools import chain

import numpy as np

from nppg.bridge.terms import Ground
from nppg.errors import NppgError
from nppg.judging.canonical import Canonizer, Form
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, Outcome, State

_DRAWN = 200  # starts that are held against the space
_CHANCE = 1e-9  # what is less likely than this does not happen to uniformly drawn starts


class Space:
    """The classes of a domain's states, each with one representative.

    `states`, `sizes`, `status`, `horizons` and `actions` have an entry for each class, and `running` says which are
    start states, `starts` of them in all. The pairs of a running class
    and one of its actions are numbered through; `owner` is the class of each pair. An outcome leads from the pair
    `origin` to the class `target` with probability `weight`. `objects` are all that are interchangeable.

    Raises NppgError where the domain defines observation/1 or does not declare `uniform_start`, where there are more
    than `limit` classes, or where drawn starts contradict what it declares.
    """

    def __init__(self, domain: Domain, limit: int = 200_000):
        if domain.has_observation:
            raise NppgError(
                f"{domain.path}: exact evaluation is for policies that see states as they are, not what observation/1 "
                "draws; evaluate on sampled starts"
            )
        if not domain.uniform_start:
            raise NppgError(
                f"{domain.path}: exact evaluation needs a finite space with a uniform start distribution, which the "
                "domain does not declare (:- uniform_start); evaluate on sampled starts, or prove on problems"
            )
        if domain.static or domain.chosen:
            what = "problems with static facts" if domain.static else "chosen problems"
            raise NppgError(
                f"{domain.path}: exact evaluation is not for {what}; evaluate on sampled starts, or prove on problems"
            )
        self.domain = domain
        self.limit = limit
        rng = np.random.default_rng(0)
        drawn = [domain.start(rng) for _ in range(_DRAWN)]
        for state in drawn:
            if (status := domain.situation(state).status) != "running":
                raise self._broken(f"start/1 draws {status} states, for instance {state}")
        self._groups = self._alike(drawn)
        self.objects = frozenset(each for group in self._groups for each in group)
        self._told = [(str(i), each) for i, group in enumerate(self._groups) for each in group]
        rigid = {_name(fact) for fact in drawn[0]}
        while (changed := self._explore(drawn[0], rigid)) is not None:
            rigid.discard(changed)
        self.running = np.array([status == "running" for status in self.status])
        self.starts = sum(size for size, running in zip(self.sizes, self.running, strict=True) if running)
        self._check_objects(drawn, rng)
        self._check_uniform(drawn)

    def _broken(self, what: str) -> NppgError:
        """What to raise where start/1 does not keep a promise."""
        return NppgError(f"{self.domain.path}: {what}; correct the declarations, or evaluate on sampled starts")

    def _alike(self, drawn: Iterable[State]) -> list[list[Ground]]:
        """The interchangeable objects, which need not all be there in each state: those of one list are members of the
        same predicates."""
        kinds: dict[Ground, str] = {}
        for state in drawn:
            kinds = self.domain.kinds(state) | kinds
        return [[each for each in kinds if kinds[each] == kind] for kind in sorted(set(kinds.values()))]

    def _form(self, canonizer: Canonizer, state: Iterable[Ground]) -> tuple[Form, int]:
        """As Canonizer.form does, but objects of different kinds are told apart."""
        return canonizer.form((*self._told, *state) if len(self._groups) > 1 else state)

    def _explore(self, start: State, rigid: set[Ground]) -> Ground | None:
        """Finds all classes; returns the name of a fact that was taken for rigid and is not."""
        fixed = {fact for fact in start if _name(fact) in rigid}
        named = {each for fact in fixed for each in _atoms(fact)}
        canonizer = Canonizer(self.objects - named)
        renamings = self._form(canonizer, ())[1]
        form, symmetries = self._form(canonizer, start)
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
                    form, symmetries = self._form(canonizer, successor)
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
        return None

    def _check_objects(self, drawn: Iterable[State], rng: np.random.Generator) -> None:
        """Whether drawn starts are in the space, up to a renaming of all objects, and whether they and renamings of
        them behave like the states there: have the same horizon, and as many actions with the same outcomes."""
        anything = Canonizer(self.objects)
        numbers: dict[Form, int] = {}

        def number(state: State) -> int:
            return numbers.setdefault(self._form(anything, state)[0], len(numbers))

        def summary(outcome: Outcome) -> tuple[int, float]:
            return number(outcome.state), round(outcome.probability, 9)

        own = np.array([number(state) for state in self.states])
        known = {each: i for i, each in enumerate(own)}
        source = self.owner[self.origin]
        for start in drawn:
            i = known.get(number(start))
            if i is None:
                raise self._broken(
                    f"not all starts can be reached from one of them (by a renaming of objects), for instance {start}"
                )
            outcomes = Counter(zip(own[self.target[source == i]], self.weight[source == i].round(9), strict=True))
            for state in (start, self._renamed(start, rng)):
                status, actions = self.domain.situation(state)
                if (
                    (status, len(actions)) != (self.status[i], len(self.actions[i]))
                    or self.domain.horizon(state) != self.horizons[i]
                    or Counter(map(summary, chain(*dict(self.domain.neighbours(state)).values()))) != outcomes
                ):
                    raise self._broken(
                        f"the members of {', '.join(self.domain.interchangeable)} are not interchangeable: {state} and "
                        f"{self.states[i]} differ by a renaming, but not only in names"
                    )

    def _renamed(self, state: State, rng: np.random.Generator) -> State:
        """With the interchangeable objects exchanged at random."""
        names = {
            each: group[i] for group in self._groups for each, i in zip(group, rng.permutation(len(group)), strict=True)
        }

        def renamed(term: Ground) -> Ground:
            return (term[0], *map(renamed, term[1:])) if isinstance(term, tuple) else names.get(term, term)

        return tuple(map(renamed, state))

    def _check_uniform(self, drawn: Iterable[State]) -> None:
        """Whether what many running states have (a fact of a predicate, a horizon) is drawn at all."""
        having: Counter[str] = Counter()
        for i in np.flatnonzero(self.running):
            having.update(dict.fromkeys(_traits(self.states[i], self.horizons[i]), self.sizes[i]))
        for state in drawn:
            for trait in _traits(state, self.domain.horizon(state)):
                having.pop(trait, None)
        for trait, states in having.items():
            if (1 - states / self.starts) ** _DRAWN < _CHANCE:
                raise self._broken(
                    f"start/1 never draws a state with {trait}, which {states / self.starts:.0%} of the running states "
                    "that can be reached have"
                )

    @cached_property
    def shares(self) -> np.ndarray:
        """Of each class among all start states."""
        return np.array([size / self.starts for size in self.sizes]) * self.running

    def mean(self, values: np.ndarray) -> float:
        """Over all start states, of values of the classes: 1 where all are 1."""
        return math.fsum(self.shares * values) / math.fsum(self.shares)

    def draw(self, count: int, rng: np.random.Generator) -> np.ndarray:
        """The classes of `count` random start states."""
        return rng.choice(len(self.shares), count, p=self.shares / self.shares.sum())

    def lengths(self) -> dict[int, int]:
        """How many starts have each horizon."""
        found: dict[int, int] = {}
        for size, status, horizon in zip(self.sizes, self.status, self.horizons, strict=True):
            if status == "running":
                found[horizon] = found.get(horizon, 0) + size
        return dict(sorted(found.items()))


def _name(fact: Ground) -> Ground:
    return fact[0] if isinstance(fact, tuple) else fact


def _traits(state: State, horizon: int) -> set[str]:
    indicators = (f"{fact[0]}/{len(fact) - 1}" if isinstance(fact, tuple) else f"{fact}/0" for fact in state)
    return {f"the horizon {horizon}", *(f"a fact of {each}" for each in indicators)}


def _atoms(term: Ground) -> Iterable[Ground]:
    if isinstance(term, tuple):
        for arg in term[1:]:
            yield from _atoms(arg)
    else:
        yield term


@lru_cache(1)
def shared_space(domain: Domain, limit: int = 200_000) -> Space:
    """The space of a domain, which runs in it share: that of the last domain is kept."""
    return Space(domain, limit)
