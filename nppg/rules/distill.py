"""Few rules that choose like a sum of many trees.

TILDE learns trees from the ensemble's preferences: over every class of states where the space is finite, else over
states met in episodes; one tree for all kinds of actions, or one for each kind. Their rules are then pruned: a rule or
a literal goes where that costs the greedy policy no success, and hardly a step. Where the space is not finite, that is
judged on other start states than those that the rules were grown from, larger ones among them. What remains is a model
like any other.
"""

from __future__ import annotations

import time
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
_ROUNDS = 5
_FAILURES = 2  # greater depths in a row that are worth no more, after which no greater one is tried
_FINALISTS = 4  # lists that are pruned, of which the shortest remains
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
    revisits: bool = True,
) -> Distilled:
    """The same with a report, in about `seconds` of the processor's time, half of them to grow rules and half to prune
    them; what is found does not hang on these unless they run out. `revisits`: whether an episode may come back to a
    state while there is another action."""
    begun = time.process_time()
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
            judge = PlayedJudge(policy, bias, judged or domain, begun + seconds, revisits)
        ordered = _from_met(policy, bias, refiner, table, judge, begun + seconds / 2)
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


def _from_met(
    policy: Policy, bias: LanguageBias, refiner: Refiner, table: Table, judge: Judge, until: float
) -> list[Rule]:
    """Pruned rules, grown from states that the policy meets. Where no list is good, what the policy would do in the
    states that the best one comes to is learned, too (DAgger: Ross, Gordon and Bagnell 2011), in the way that has done
    best."""
    preferences = Preferences(policy, table)
    most = min(_PAIRS, _ANSWERS // len(table))
    now = time.process_time()
    preferences.add(met_in_episodes(policy, now + (until - now) / _ROUNDS), most)
    wanted = Worth(1.0, _KEPT) if isinstance(judge, PlayedJudge) else judge.wanted()
    found: list[list[Rule]] = []
    ways = [*product(GOOD, (False, True) if kinds_of_actions(bias) else (False,))]
    first = DEPTHS.start
    for left in range(_ROUNDS, 0, -1):
        now = time.process_time()
        round_ends = now + (until - now) / left
        lists = [
            (judge.worth(each), depth, way, each)
            for way in ways
            for depth, each in _grown(preferences, bias, refiner, judge, wanted, *way, first, round_ends).items()
        ]
        found += [each for *_, each in lists]
        best = max(found, key=judge.worth)
        if judge.reaches(best, wanted) or not isinstance(judge, PlayedJudge) or time.process_time() > until:
            break
        _, depth, way, _ = max(lists, key=lambda each: each[0])
        ways, first = [way], max(depth - 1, DEPTHS.start)
        most += most // 2
        preferences.add(met_by_others(policy, judge.episodes(best)), most)
    least = judge.worth(best)
    least = least._replace(quality=_KEPT * least.quality)
    good = sorted((each for each in found if judge.reaches(each, least)), key=_length)
    finalists = good[:_FINALISTS] if isinstance(judge, PlayedJudge) else [best]
    return min((_pruned(each, refiner, judge, least.quality) for each in finalists), key=_length)


def _length(ordered: list[Rule]) -> tuple[int, int]:
    """Rules, then literals."""
    return len(ordered), sum(len(rule.query) for rule in ordered)


def _grown(
    preferences: Preferences,
    bias: LanguageBias,
    refiner: Refiner,
    judge: Judge,
    wanted: Worth,
    good: float,
    apart: bool,
    first: int,
    until: float,
) -> dict[int, list[Rule]]:
    """Lists of growing depth, from the first one on, until one is worth what is wanted, or deeper ones are worth no
    more; at least one."""
    found: dict[int, list[Rule]] = {}
    examples = preferences.examples(good)
    agreement = Agreement(examples, preferences.first, preferences.table)
    best, failures = first, 0
    for depth in range(first, DEPTHS.stop):
        candidate = agreement.shortened(grown(examples, bias, preferences.table, refiner, depth, apart), refiner)
        if not found or (
            judge.reaches(candidate, judge.worth(found[best])) and judge.worth(candidate) > judge.worth(found[best])
        ):
            best, failures = depth, 0
            found[depth] = candidate
        else:
            failures += 1
        if judge.worth(found[best]).reaches(wanted) or failures == _FAILURES or time.process_time() > until:
            break
    return found
