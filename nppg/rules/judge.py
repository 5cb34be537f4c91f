"""How well lists of rules do: exactly, or on start states, the smallest first, each list only as far as it keeps up."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np

from nppg.answers.coverage import table_of
from nppg.answers.table import Table
from nppg.bias.language_bias import LanguageBias
from nppg.errors import NppgError
from nppg.judging.evaluation import ExactEvaluator, evaluate, merit, spread
from nppg.learning.episode import Episode, generate_episode
from nppg.policy.policy import Policy
from nppg.trees.tree import Rule, from_rules, tests
from nppg.worlds.domain import Domain
from nppg.worlds.world import State

_EPISODES = 300  # where only returns count
_PROBLEMS = 16  # the most that lists of rules are tried on
_STARTS = 60  # where start states are drawn
_STEPS = 100_000  # of all lists that are tried
_SLACK = 2.0  # times the policy's steps: a list that needs more has failed


class Worth(NamedTuple):
    """Success first, or the mean return where there is no goal; then quality: the mean over all start states of the
    fewest steps that were needed as a share of the steps that were taken, 0 where the goal was not reached. It is 0
    where steps do not count."""

    success: float
    quality: float = 0.0

    def reaches(self, least: Worth) -> bool:
        """Whether it is at least that in both."""
        return self.success >= least.success and self.quality >= least.quality


class Judge(ABC):
    """Compares the greedy policies of lists of rules with `policy`."""

    def __init__(self, policy: Policy, bias: LanguageBias):
        self.original = policy
        self.bias = bias

    @abstractmethod
    def worth(self, ordered: Sequence[Rule]) -> Worth:
        """Of an ordered list of rules."""

    @abstractmethod
    def wanted(self) -> Worth:
        """That of the policy."""

    def reaches(self, ordered: Sequence[Rule], least: Worth) -> bool:
        """Whether it is worth so much."""
        return self.worth(ordered).reaches(least)

    def policy(self, ordered: Sequence[Rule]) -> Policy:
        """The policy whose only tree has these rules, in the domain where it is judged."""
        return self._policy(ordered, self.original.domain)

    def report(self, ordered: Sequence[Rule]) -> str:
        """How far the list was tried, where that is not all that there is."""
        return ""

    def _policy(self, ordered: Sequence[Rule], domain: Domain, table: Table | None = None) -> Policy:
        tree = from_rules(ordered, self.bias.forms.deciding_tests)
        result = Policy(domain, self.bias, table or table_of(tests(tree), domain, self.bias))
        result.add(tree, comment=f"distilled, {len(ordered)} rules")
        return result


class _Once(Judge):
    """Judges a list the first time that it is asked about it."""

    def __init__(self, policy: Policy, bias: LanguageBias):
        super().__init__(policy, bias)
        self._known = cache(lambda ordered: self._of(self.policy(ordered)))

    def worth(self, ordered: Sequence[Rule]) -> Worth:
        return self._known(tuple(ordered))

    @abstractmethod
    def _of(self, policy: Policy) -> Worth:
        """Of the policy of a list."""


class ExactJudge(_Once):
    """By the success over all start states of a finite space. What the lists test is in one table with all else."""

    def __init__(self, policy: Policy, bias: LanguageBias, table: Table):
        super().__init__(policy, bias)
        self.table = table
        self.exact = ExactEvaluator(policy)
        self._shared: ExactEvaluator | None = None

    def wanted(self) -> Worth:
        return Worth(self.exact.evaluate(greedy=True).success)

    def policy(self, ordered: Sequence[Rule]) -> Policy:
        return self._policy(ordered, self.original.domain, self.table)

    def _of(self, policy: Policy) -> Worth:
        if self._shared is None:
            self._shared = ExactEvaluator(policy, self.exact.space)
        self._shared.potentials()  # asks for the answers that all others use
        return Worth(self._shared.of(policy).evaluate(greedy=True).success)


class ReturnJudge(_Once):
    """By the mean return, or the success, of sampled episodes, where nothing shows sooner how good a list is."""

    def wanted(self) -> Worth:
        return self._of(self.original)

    def _of(self, policy: Policy) -> Worth:
        problems = spread(policy.domain.chosen, _PROBLEMS)
        return Worth(merit(policy, evaluate(policy, _EPISODES, greedy=True, problems=problems))[1])


@dataclass(frozen=True, slots=True)
class Trial:
    """A start state with its name, its horizon, and the steps that the policy needs from there, None where it fails."""

    name: str
    start: State
    horizon: int
    steps: int | None


class PlayedJudge(Judge):
    """By episodes from the same start states for all lists, the random choices between equally good actions, too. One
    that fails or wanders where others do not is soon found out: it plays first where lists have failed before. Once it
    is spent, no list that it would have to play on `reaches` anything; `worth` plays it, for it is told as it is."""

    def __init__(self, policy: Policy, bias: LanguageBias, domain: Domain, until: float, revisits: bool = True):
        super().__init__(policy, bias)
        self.domain = domain
        self.revisits = revisits
        self.trials = _trials(policy if domain is policy.domain else in_domain(policy, domain), domain, revisits)
        if not self.trials:
            raise NppgError(f"{domain.path}: no start state to judge rules on: all are goal or terminal states")
        self._best = [trial.steps for trial in self.trials]
        self._order = list(range(len(self.trials)))
        self._known: dict[tuple[Rule, ...], dict[int, int | None]] = {}
        self._left = _STEPS
        self._until = until

    @property
    def is_spent(self) -> bool:
        """Whether no more lists are to be tried."""
        return self._left <= 0 or time.process_time() > self._until

    def wanted(self) -> Worth:
        return self._valued([trial.steps for trial in self.trials])

    def worth(self, ordered: Sequence[Rule]) -> Worth:
        known = self._known.setdefault(tuple(ordered), {})
        missing = [number for number in range(len(self.trials)) if number not in known]
        policy = self.policy(ordered) if missing else None
        for number in missing:
            assert policy is not None
            known[number] = self._played(policy, number)
        return self._valued([known[number] for number in range(len(self.trials))])

    def policy(self, ordered: Sequence[Rule]) -> Policy:
        return self._policy(ordered, self.domain)

    def report(self, ordered: Sequence[Rule]) -> str:
        self.worth(ordered)
        own = self._known[tuple(ordered)]
        both = [(own[i], each.steps) for i, each in enumerate(self.trials) if own[i] and each.steps]
        solved, largest = sum(each is not None for each in own.values()), self.trials[-1]
        before = sum(each.steps is not None for each in self.trials)
        what = "problems" if self.domain.chosen else "start states"
        return (
            f"tried on {len(self.trials)} {what}, up to {largest.name} (horizon {largest.horizon}): solved {solved}, "
            f"where the policy solves {before}; {sum(steps or 0 for steps, _ in both)} steps where the policy takes "
            f"{sum(steps or 0 for _, steps in both)}"
        )

    def reaches(self, ordered: Sequence[Rule], least: Worth) -> bool:
        known = self._known.setdefault(tuple(ordered), {})
        policy: Policy | None = None
        whole = len(self.trials)
        for place, number in enumerate(self._order):
            if number not in known:
                if self.is_spent:
                    return False
                policy = policy or self.policy(ordered)
                known[number] = self._played(policy, number)
            solved = whole - sum(steps is None for steps in known.values())
            lost = sum(1 - self._share(number, steps) for number, steps in known.items())
            if not Worth(solved / whole, (whole - lost) / whole).reaches(least):
                self._order.insert(0, self._order.pop(place))
                return False
        return True

    def episodes(self, ordered: Sequence[Rule]) -> list[Episode]:
        """What a list does from each start state."""
        policy = self.policy(ordered)
        return [self._episode(policy, number) for number in range(len(self.trials))]

    def _episode(self, policy: Policy, number: int) -> Episode:
        trial = self.trials[number]
        longest = trial.horizon
        if trial.steps is not None and not self.domain.has_chance:
            longest = min(longest, round(_SLACK * trial.steps) + 1)
        factor = longest / trial.horizon if trial.horizon else 1.0
        rng = np.random.default_rng([0, number])
        episode = generate_episode(
            policy,
            rng,
            horizon_factor=factor,
            greedy=True,
            start=trial.start,
            revisits=self.revisits,
            scored=False,
        )
        self._left -= len(episode.steps)
        return episode

    def _played(self, policy: Policy, number: int) -> int | None:
        episode = self._episode(policy, number)
        if not episode.success:
            return None
        steps, best = len(episode.steps), self._best[number]
        if best is None or (steps < best and not self.domain.has_chance):
            self._best[number] = steps
        return steps

    def _share(self, number: int, steps: int | None) -> float:
        best = self._best[number]
        return 0.0 if steps is None or best is None else 1.0 if steps == best else best / steps

    def _valued(self, steps: Sequence[int | None]) -> Worth:
        whole = len(self.trials)
        solved = sum(each is not None for each in steps)
        lost = sum(1 - self._share(number, each) for number, each in enumerate(steps))
        return Worth(solved / whole, (whole - lost) / whole)


def in_domain(policy: Policy, domain: Domain) -> Policy:
    """The same policy in another domain of the same file."""
    found = [test for tree in policy.trees for test in tests(tree)]
    other = Policy(domain, policy.bias, table_of(found, domain, policy.bias))
    for tree in policy.trees:
        other.add(tree)
    return other


def _trials(policy: Policy, domain: Domain, revisits: bool) -> list[Trial]:
    """Start states of all sizes, the smallest first, with what the policy does there."""
    found: list[Trial] = []
    rng = np.random.default_rng(0)
    for name, start in by_size(domain, rng):
        if domain.situation(start).status == "running":
            own = np.random.default_rng([0, len(found)])
            episode = generate_episode(policy, own, greedy=True, start=start, revisits=revisits)
            steps = len(episode.steps) if episode.success else None
            found.append(Trial(name, start, domain.horizon(start), steps))
    return found


def by_size(domain: Domain, rng: np.random.Generator) -> list[tuple[str, State]]:
    """Start states with their names, from the smallest to the largest: of problems at even distances, with the largest
    one; else drawn ones."""
    if domain.chosen:
        starts = [(domain.problems[number], domain.problem(number)) for number in domain.chosen]
    else:
        starts = [(f"start {i + 1}", domain.start(rng)) for i in range(_STARTS)]
    starts.sort(key=lambda each: domain.horizon(each[1]))
    if domain.chosen and len(starts) > _PROBLEMS:
        starts = [starts[round(i * (len(starts) - 1) / (_PROBLEMS - 1))] for i in range(_PROBLEMS)]
    return starts
