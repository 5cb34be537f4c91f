"""Few rules that choose like a sum of many trees.

TILDE learns one tree from the ensemble's preferences: over every class of states where the space is finite, else over
states met in episodes. The tree's rules are then pruned: a rule or a literal goes where that lowers no success of the
greedy policy. What remains is a model like any other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import product

import numpy as np

from nppg.answers.coverage import Coverage, root_table
from nppg.answers.table import Table
from nppg.bias.declarations import TreeLimits
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.judging.evaluation import ExactEvaluator, evaluate, merit, spread
from nppg.learning.episode import generate_episode
from nppg.policy.gibbs import best
from nppg.policy.policy import Policy
from nppg.trees.tilde import grow
from nppg.trees.tree import Rule, Tree, from_rules, rules
from nppg.worlds.world import Action, State

_GOOD = (0.3, 1 - 1e-9)  # an action counts as preferred from this share of the best one's probability on
_DEPTHS = range(1, 9)
_EPISODES = 300
_PROBLEMS = 30  # where a domain's starts are drawn from problems: the most that are looked at, and how many steps
_STEPS = 3000
_STEP = 10.0  # between two values of the rules


def distill(policy: Policy, bias: LanguageBias, max_rules: int = 10) -> Policy:
    """A policy of one tree with at most `max_rules` rules; `bias` says what they may test.

    The tree is the shallowest whose greedy success is that of `policy`, or the best one tried: first of all actions
    that the policy likes, then, should that not do, of its very best ones alone. Where its pruned rules are too many,
    those whose loss costs least go too.
    """
    refiner = Refiner(bias)
    table = root_table(policy.domain, bias, refiner)
    judge = _Judge(policy, table, bias)
    states, actions, shares = judge.preferences()
    coverage = Coverage(table, states, actions)
    wanted = judge.success(policy)
    found: list[list[Rule]] = []
    for good, depth in product(_GOOD, _DEPTHS):
        if len(table) > coverage.bits.shape[1]:  # a judged tree has brought tests of its own
            coverage = Coverage(table, states, actions)
        targets = (shares >= good).astype(float)
        found.append(list(rules(grow(targets, coverage, refiner, TreeLimits(max_depth=depth, min_examples=1)))))
        if judge.rules_success(found[-1]) >= wanted:
            break
    pruned = _pruned(max(found, key=judge.rules_success), refiner, judge.rules_success)
    while len(pruned) > max(max_rules, 1):
        pruned = _pruned(max(_without_rule(pruned), key=judge.rules_success), refiner, judge.rules_success)
    return judge.policy(_levelled(pruned, judge.rules_success))


class _Judge:
    """How well rules do: exactly where that is possible, else on starts sampled with one seed."""

    def __init__(self, policy: Policy, table: Table, bias: LanguageBias):
        self.original = policy
        self.table = table
        self.bias = bias
        domain = policy.domain
        self.exact = ExactEvaluator(policy) if domain.is_countable else None
        self.shared: ExactEvaluator | None = None
        self._known: dict[tuple[Rule, ...], float] = {}

    def preferences(self) -> tuple[list[State], list[Action], np.ndarray]:
        """States with their actions, and the probability of each action as a share of the best one's: 0 or 1 where the
        policy is greedy."""
        states: list[State] = []
        actions: list[Action] = []
        shares: list[np.ndarray] = []
        for state, legal, potentials in self._met():
            states += [state] * len(legal)
            actions += legal
            greedy = self.original.greedy
            shares.append(best(potentials).astype(float) if greedy else np.exp(potentials - potentials.max()))
        return states, actions, np.concatenate(shares)

    def _met(self) -> Iterator[tuple[State, list[Action], np.ndarray]]:
        if self.exact:
            space, potentials = self.exact.space, self.exact.potentials()
            for number, (state, legal) in enumerate(zip(space.states, space.actions, strict=True)):
                if legal:
                    yield state, legal, potentials[space.owner == number]
        else:
            rng = np.random.default_rng(0)
            domain = self.original.domain
            problems = spread(domain.chosen, _PROBLEMS)
            left = _STEPS
            for number in range(_EPISODES):
                start = domain.problem(problems[number % len(problems)]) if problems else None
                steps = generate_episode(self.original, rng, start=start).steps
                for step in steps:
                    yield step.state, list(step.actions), step.potentials
                left -= len(steps)
                if problems and left <= 0:
                    break

    def policy(self, ordered: list[Rule]) -> Policy:
        """The policy whose only tree has these rules."""
        result = Policy(self.original.domain, self.bias, self.table)
        result.add(self._tree(ordered), comment=f"distilled, {len(ordered)} rules")
        return result

    def _tree(self, ordered: list[Rule]) -> Tree:
        return from_rules(ordered, self.bias.forms.deciding_tests)

    def success(self, policy: Policy) -> float:
        """Of the greedy policy; its mean return where the domain has no goal."""
        if self.exact and policy.table is self.table:
            if self.shared is None:
                self.shared = ExactEvaluator(policy, self.exact.space)
            self.shared.potentials()  # asks for the answers that all others use
            return self.shared.of(policy).evaluate(greedy=True).success
        if self.exact:
            return self.exact.of(policy).evaluate(greedy=True).success
        problems = spread(policy.domain.chosen, _PROBLEMS)
        return merit(policy, evaluate(policy, _EPISODES, greedy=True, problems=problems))[1]

    def rules_success(self, ordered: list[Rule]) -> float:
        """Of the greedy policy of an ordered list of rules."""
        key = tuple(ordered)
        if key not in self._known:
            self._known[key] = self.success(self.policy(ordered))
        return self._known[key]


def _pruned(ordered: list[Rule], refiner: Refiner, success: Callable[[list[Rule]], float]) -> list[Rule]:
    """Drops rules, then literals, as long as no success is lost; the last rule stays, and holds always."""
    best = success(ordered)
    shorter = True
    while shorter:
        shorter = False
        for candidate in (*_without_rule(ordered), *_without_literal(ordered, refiner)):
            if success(candidate) >= best:
                ordered, best, shorter = candidate, success(candidate), True
                break
    return ordered


def _without_rule(ordered: list[Rule]) -> Iterator[list[Rule]]:
    for i in range(len(ordered) - 2, -1, -1):
        yield ordered[:i] + ordered[i + 1 :]


def _without_literal(ordered: list[Rule], refiner: Refiner) -> Iterator[list[Rule]]:
    """Only what the language bias allows: no literal may lose the one that binds its variables."""
    for i, rule in enumerate(ordered[:-1]):
        for literal in reversed(rule.query):
            query = tuple(each for each in rule.query if each != literal)
            if query and refiner.allows(query):
                yield [*ordered[:i], replace(rule, query=query), *ordered[i + 1 :]]


def _levelled(ordered: list[Rule], success: Callable[[list[Rule]], float]) -> list[Rule]:
    """The same choices with as few different values as possible: multiples of a number that makes the stochastic
    policy nearly greedy. Neighbouring values become one where that costs no success."""
    ranks = {value: rank for rank, value in enumerate(sorted({rule.value for rule in ordered}))}
    levels = [ranks[rule.value] for rule in ordered]
    best = success(ordered)
    for upper in range(max(levels), 0, -1):
        merged = [level - (level >= upper) for level in levels]
        if success(_with_levels(ordered, merged)) >= best:
            levels = merged
    return _with_levels(ordered, levels)


def _with_levels(ordered: list[Rule], levels: list[int]) -> list[Rule]:
    return [replace(rule, value=_STEP * level) for rule, level in zip(ordered, levels, strict=True)]
