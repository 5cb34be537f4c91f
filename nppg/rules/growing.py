"""What lists of rules are grown from: what a policy prefers in states that were met. And the lists."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from nppg.answers.coverage import Coverage, table_of
from nppg.answers.table import Table
from nppg.bias.declarations import TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.judging.evaluation import ExactEvaluator
from nppg.learning.episode import Episode, generate_episode
from nppg.learning.regressors import Examples, PerAction, kinds_of_actions
from nppg.logic.query import Query
from nppg.policy.gibbs import best
from nppg.policy.policy import Policy
from nppg.rules.pruning import is_allowed, ranked, without_literals, without_rules
from nppg.trees.tilde import Split, grow
from nppg.trees.tree import Rule, Tree, rules
from nppg.worlds.state import interpretation_of
from nppg.worlds.world import Action, State

GOOD = (0.3, 1 - 1e-9)  # an action counts as preferred from this share of the best one's probability on
DEPTHS = range(1, 9)
_EPISODES = 300  # the most that rules are grown from, and about how many steps
_STEPS = 3000
_ACTIONS = 60  # of a state that are looked at, where they are many

Met = tuple[State, Sequence[Action], np.ndarray]  # a state, its actions and their potentials


class Preferences:
    """States, each once, with their actions, and the probability of each action as a share of the best one's: 0 or 1
    where the policy is greedy."""

    def __init__(self, policy: Policy, table: Table):
        self.policy = policy
        self.table = table
        self.states: list[State] = []
        self.actions: list[Action] = []
        self.shares = np.empty(0)
        self.first: list[int] = []  # action of each state
        self._met: set[tuple[int, int]] = set()  # by fingerprint and identity of the static facts, which `states` keep
        self._bits: list[np.ndarray] = []
        self._rng = np.random.default_rng(0)

    def __len__(self) -> int:
        return len(self.actions)

    def add(self, met: Iterable[Met], most: int | None = None) -> None:
        """Adds those that are new, up to `most` pairs in all. Of very many actions in a state, some of these are kept:
        first those that the policy prefers; which of the others is drawn."""
        shares = [self.shares]
        for state, legal, potentials in met:
            own = interpretation_of(state)
            key = own.fingerprint, id(own.static)
            if most is not None and len(self.actions) >= most:
                break
            if key in self._met:
                continue
            self._met.add(key)
            share = best(potentials).astype(float) if self.policy.greedy else np.exp(potentials - potentials.max())
            kept: Sequence[int] = range(len(share))
            if most is not None and len(share) > _ACTIONS:
                kept = self._kept(share).tolist()
            self.first.append(len(self.actions))
            self.states += [state] * len(kept)
            self.actions += [legal[i] for i in kept]
            shares.append(share[kept])
        self.shares = np.concatenate(shares)

    def _kept(self, share: np.ndarray) -> np.ndarray:
        order = np.lexsort((self._rng.random(len(share)), -(share >= GOOD[0]).astype(int)))
        return np.sort(order[:_ACTIONS])

    def examples(self, good: float) -> Examples:
        """An example for each pair: 1 where the policy prefers the action, else 0."""
        if self._bits and self._bits[0].shape[1] < len(self.table):  # it has got further tests
            self._bits = []
        done = sum(map(len, self._bits))
        if done < len(self):
            self._bits.append(Coverage(self.table, self.states[done:], self.actions[done:]).bits)
            if len(self._bits) > 1:
                self._bits = [np.concatenate(self._bits)]
        return Examples(self.states, self.actions, self._bits[0], (self.shares >= good).astype(float))


def met_everywhere(exact: ExactEvaluator) -> Iterator[Met]:
    """Every class of states."""
    space, potentials = exact.space, exact.potentials()
    first = np.searchsorted(space.owner, np.arange(len(space.states) + 1))
    for number, (state, legal) in enumerate(zip(space.states, space.actions, strict=True)):
        if legal:
            yield state, legal, potentials[first[number] : first[number + 1]]


def met_in_episodes(policy: Policy, until: float = math.inf) -> Iterator[Met]:
    """What the policy meets, in turn greedy and not, until that processor time: from start states that are drawn, or on
    the smaller half of the problems."""
    domain = policy.domain
    rng = np.random.default_rng(0)
    problems = sorted(domain.chosen, key=lambda each: domain.horizon(domain.problem(each)))
    problems = problems[: -(-len(problems) // 2)]
    left = _STEPS
    for number in range(_EPISODES):
        start = domain.problem(problems[number % len(problems)]) if problems else None
        episode = generate_episode(policy, rng, greedy=number % 2 == 1, start=start)
        for step in episode.steps:
            yield step.state, step.actions, step.potentials
        left -= len(episode.steps)
        if left <= 0 or time.process_time() > until:
            break


def met_by_others(policy: Policy, episodes: Sequence[Episode]) -> Iterator[Met]:
    """What the policy says of the states of others' episodes."""
    for episode in episodes:
        for step in episode.steps:
            status, actions = policy.domain.situation(step.actual)
            if status == "running":
                yield step.state, list(actions), policy.potentials(step.state, actions)


class Agreement:
    """How far lists of rules choose what the policy prefers, in the states that the examples are about."""

    def __init__(self, examples: Examples, first: Sequence[int], table: Table):
        self.examples = examples
        self.table = table
        self._first = np.array(first)
        self._sizes = np.diff(self._first, append=len(examples.targets))
        self._bad = 1 - examples.targets
        self._asked: dict[Query, np.ndarray] = {}
        self._covered: dict[Query, np.ndarray] = {}

    def loss(self, ordered: Sequence[Rule]) -> float:
        """The share of actions that the policy does not prefer among the best ones, averaged over the states."""
        open_ = np.ones(len(self._bad), bool)
        values = np.empty(len(self._bad))
        for rule in ordered:
            own = self.covered(rule.query) & open_
            values[own] = rule.value
            open_ &= ~own
        highest = values >= np.repeat(np.maximum.reduceat(values, self._first), self._sizes)
        chosen = np.add.reduceat(highest.astype(float), self._first)
        return float((np.add.reduceat(highest * self._bad, self._first) / chosen).mean())

    def covered(self, query: Query) -> np.ndarray:
        """Of which examples a query holds."""
        if query not in self._covered:
            tests = self.table.bias.forms.deciding_tests((), query)
            self.ask(tests)
            answers = [self._answers(test) for test in tests]
            self._covered[query] = np.logical_and.reduce(answers) if answers else np.ones(len(self._bad), bool)
        return self._covered[query]

    def _answers(self, test: Query) -> np.ndarray:
        if test in self._asked:
            return self._asked[test]
        return Split(*self.table.place(test)).covered(self.examples.answers)

    def ask(self, tests: Iterable[Query]) -> None:
        """Asks all tests that are new."""
        new = [test for test in dict.fromkeys(tests) if test not in self._asked and test not in self.table]
        if new:
            own = table_of(new, self.table.domain, self.table.bias)
            bits = Coverage(own, self.examples.states, self.examples.actions).bits
            self._asked |= {test: Split(*own.place(test)).covered(bits) for test in new}

    def shortened(self, ordered: list[Rule], refiner: Refiner) -> list[Rule]:
        """Without the rules and literals that do not make it agree more."""
        forms = self.table.bias.forms
        self.ask(test for rule in ordered for test in forms.deciding_tests((), rule.query))
        least = self.loss(ordered)

        def accepts(candidate: list[Rule]) -> bool:
            return self.loss(candidate) <= least + 1e-9

        before: list[Rule] = []
        while ordered != before:
            before = ordered
            ordered = without_rules(ordered, accepts)
            shorter = [
                tuple(each for each in rule.query if each != literal) for rule in ordered for literal in rule.query
            ]
            self.ask(
                test for query in shorter if is_allowed(query, refiner) for test in forms.deciding_tests((), query)
            )
            ordered = without_literals(ordered, refiner, accepts)
        return ordered


class _OfDepth:
    """TILDE down to a depth."""

    def __init__(self, table: Table, refiner: Refiner, depth: int):
        self.table = table
        self.refiner = refiner
        self.limits = TreeLimits(max_depth=depth, min_examples=1)

    def fit(self, examples: Examples, query: Query = ()) -> Tree:
        coverage = Coverage(self.table, examples.states, examples.actions, examples.answers)
        return grow(examples.targets, coverage, self.refiner, self.limits, query=query)


def grown(
    examples: Examples, bias: LanguageBias, table: Table, refiner: Refiner, depth: int, apart: bool
) -> list[Rule]:
    """The rules of one tree for all kinds of actions, or of one for each kind: values are comparable, for they are all
    shares of preferred actions."""
    learner = _OfDepth(table, refiner, depth)
    tree = PerAction(learner, kinds_of_actions(bias)).fit(examples) if apart else learner.fit(examples)
    return ranked(list(rules(tree)))
