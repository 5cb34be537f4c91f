"""Few rules that choose like a sum of many trees.

TILDE learns trees from the ensemble's preferences: over every class of states where the space is finite, else over
states met in episodes; one tree for all kinds of actions, or one for each kind. Their rules are then pruned: a rule or
a literal goes where that costs the greedy policy no success, and hardly a step. Where the space is not finite, that is
judged on other start states than those that the rules were grown from, larger ones among them. What remains is a model
like any other.
"""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

from nppg.answers.coverage import root_table
from nppg.answers.table import Table
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.learning.regressors import kinds_of_actions
from nppg.policy.policy import Policy
from nppg.rules.growing import (
    DEPTHS,
    GOOD,
    Agreement,
    Preferences,
    grown,
    met_by_others,
    met_everywhere,
    met_in_episodes,
)
from nppg.rules.judge import ExactJudge, Judge, PlayedJudge, ReturnJudge, Worth, in_domain
from nppg.rules.pruning import levelled, one_less, pruned
from nppg.trees.tree import Rule
from nppg.worlds.domain import Domain

MAX_RULES = 15
SECONDS = 60.0
_PAIRS = 20_000  # of states and actions
_ANSWERS = 8_000_000  # of these to tests
_ROUNDS = 3
_KEPT = 0.98  # of the best quality that was found
_NOISE = 0.002  # of quality, which choices between equally good actions make


class Distilled(NamedTuple):
    """Rules as a policy, in the domain where they were judged, and how far they were tried, if not everywhere."""

    rules: Policy
    report: str


def distill(policy: Policy, bias: LanguageBias, max_rules: int = MAX_RULES, judged: Domain | None = None) -> Policy:
    """A policy of one tree with at most `max_rules` rules; `bias` says what they may test. They are judged on start
    states of `judged`, by default on the policy's own domain's."""
    return distilled(policy, bias, max_rules, judged).rules


def distilled(
    policy: Policy,
    bias: LanguageBias,
    max_rules: int = MAX_RULES,
    judged: Domain | None = None,
    seconds: float = SECONDS,
) -> Distilled:
    """The same with a report, in about `seconds`; what is found does not hang on these unless they run out."""
    if judged is not None and judged.is_countable:
        policy = in_domain(policy, judged)
    domain = policy.domain
    refiner = Refiner(bias)
    table = root_table(domain, bias, refiner)
    judge: Judge
    if domain.is_countable:
        judge = ExactJudge(policy, bias, table)
        ordered = _from_all(policy, bias, refiner, judge)
    else:
        if not domain.has_goal or domain.environment:
            judge = ReturnJudge(policy, bias)
        else:
            judge = PlayedJudge(policy, bias, judged or domain, seconds)
        ordered = _from_met(policy, bias, refiner, table, judge)
    while len(ordered) > max(max_rules, 1):
        ordered = max(one_less(ordered), key=judge.worth)
        ordered = _pruned(ordered, refiner, judge, _KEPT * judge.worth(ordered).quality)
    return Distilled(judge.policy(ordered), judge.report(ordered))


def _pruned(ordered: list[Rule], refiner: Refiner, judge: Judge, least: float = 0.0) -> list[Rule]:
    """Pruned, with as few values as possible, as long as no success is lost. A shorter list may be of less quality,
    down to `least`; one with a rule that says less may not."""
    present, length = judge.worth(ordered), len(ordered)

    def accepts(candidate: list[Rule]) -> bool:
        nonlocal present, length
        quality = least if len(candidate) < length else max(least, present.quality - _NOISE)
        if not judge.reaches(candidate, Worth(present.success, quality)):
            return False
        present, length = judge.worth(candidate), len(candidate)
        return True

    return levelled(pruned(ordered, refiner, accepts), accepts)


def _from_all(policy: Policy, bias: LanguageBias, refiner: Refiner, judge: ExactJudge) -> list[Rule]:
    """Pruned rules of the shallowest tree whose success is that of the policy, or the best one tried: first of all
    actions that the policy likes, then, should that not do, of its very best ones alone."""
    preferences = Preferences(policy, judge.table)
    preferences.add(met_everywhere(judge.exact))
    found: list[list[Rule]] = []
    for good, depth in product(GOOD, DEPTHS):
        found.append(grown(preferences.examples(good), bias, judge.table, refiner, depth, apart=False))
        if judge.reaches(found[-1], judge.wanted()):
            break
    best = max(found, key=judge.worth)
    return _pruned(best, refiner, judge)


def _from_met(policy: Policy, bias: LanguageBias, refiner: Refiner, table: Table, judge: Judge) -> list[Rule]:
    """Pruned rules, grown from states that the policy meets. Where no list is as good as the policy, what the policy
    would do in the states that the best one comes to is learned, too."""
    preferences = Preferences(policy, table)
    most = min(_PAIRS, _ANSWERS // len(table))
    preferences.add(met_in_episodes(policy), most)
    wanted = judge.wanted()._replace(quality=_KEPT * judge.wanted().quality)
    found: list[list[Rule]] = []
    for _ in range(_ROUNDS):
        for apart in (False, True) if kinds_of_actions(bias) else (False,):
            found.append(_grown(preferences, bias, refiner, judge, wanted, apart))
        best = max(found, key=judge.worth)
        if judge.reaches(best, wanted) or not isinstance(judge, PlayedJudge):
            break
        most += most // 2
        preferences.add(met_by_others(policy, judge.episodes(best)), most)
    least = judge.worth(best)
    least = least._replace(quality=_KEPT * least.quality)
    shorter = [_pruned(each, refiner, judge, least.quality) for each in found if judge.reaches(each, least)]
    return min(shorter, key=lambda each: (len(each), sum(len(rule.query) for rule in each)))


def _grown(
    preferences: Preferences, bias: LanguageBias, refiner: Refiner, judge: Judge, wanted: Worth, apart: bool
) -> list[Rule]:
    """The list of the least depth that is worth what is wanted, or the best one."""
    best: list[Rule] = []
    for good in GOOD:
        examples = preferences.examples(good)
        agreement = Agreement(examples, preferences.first, preferences.table)
        for depth in DEPTHS:
            candidate = grown(examples, bias, preferences.table, refiner, depth, apart)
            candidate = agreement.shortened(candidate, refiner)
            if not best or judge.reaches(candidate, judge.worth(best)):
                best = candidate
            if judge.worth(best).reaches(wanted):
                return best
    return best
