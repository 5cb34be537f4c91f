"""Rules that hold: grown for each kind of action, and judged by their success and steps on larger problems."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path

import pytest

from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, Refiner
from nppg.cli.main import main
from nppg.judging.evaluation import evaluate
from nppg.learning.options import Options
from nppg.learning.training import train
from nppg.logic.query import Literal, Var
from nppg.policy.policy import Policy
from nppg.rules.distill import distill, distilled
from nppg.rules.judge import PlayedJudge, Worth
from nppg.trees.tree import Rule, from_rules, rules
from nppg.worlds.domain import Domain

DOMAINS = Path(__file__).parent / "domains"


def world(name: str, **parameters: int) -> tuple[Domain, LanguageBias]:
    return Domain(DOMAINS / f"{name}.pl", parameters), LanguageBias.load(DOMAINS / f"{name}.yaml")


def learned(domain: Domain, bias: LanguageBias, episodes: int) -> Policy:
    options = Options(episodes, step="second-order", discount=0.9, importance=0.0, models="per-action", guidance=0.0)
    *_, last = train(domain, bias, options)
    return last.policy


def by_hand(domain: Domain, bias: LanguageBias, ordered: list[Rule]) -> Policy:
    policy = Policy(domain, bias)
    policy.add(from_rules(ordered, bias.forms.deciding_tests))
    return policy


def cars_rules(bias: LanguageBias) -> list[Rule]:
    """Straight to where there is something to do."""
    sail, board, debark = (Literal(KIND, (kind,)) for kind in range(3))
    target, car, place, on, there = Var(1), *map(Var, (4, 5, 6, 6))
    assert bias.offsets == (0, 2, 4, 6)
    return [
        Rule((debark, Literal("goal_at", (car, place))), 40.0),
        Rule((debark,), 0.0),
        Rule((board, Literal("misplaced", (Var(2), Var(3)))), 30.0),
        Rule((board,), 0.0),
        Rule((sail, Literal("on", (on,)), Literal("goal_at", (on, target))), 20.0),
        Rule((sail, Literal("empty", ()), Literal("misplaced", (there, target))), 20.0),
        Rule((), 0.0),
    ]


def wandering(ordered: list[Rule]) -> list[Rule]:
    """They sail to cars that have arrived, too."""
    changed = replace(ordered[5], query=(*ordered[5].query[:2], Literal("at", ordered[5].query[2].args)))
    return [*ordered[:5], changed, ordered[6]]


def test_rules_for_each_kind_of_action_hold_where_balls_are_many() -> None:
    domain, bias = world("gripper")
    policy = learned(domain, bias, 300)
    large, _ = world("gripper", balls=15)
    few, report = distilled(policy, bias, judged=large, seconds=600.0)
    assert evaluate(few, 40, greedy=True).success == 1.0 and few.domain is large
    assert len(few.rules(1)) <= 8
    assert report.startswith("tried on 60 start states, up to start") and "(horizon 92): solved 60" in report


def test_steps_count() -> None:
    domain, bias = world("cars", cars=6, places=5)
    straight = cars_rules(bias)
    policy = by_hand(domain, bias, straight)
    judge = PlayedJudge(policy, bias, domain, time.process_time() + 1000)
    other, own = judge.worth(wandering(straight)), judge.worth(straight)
    assert own.success == 1.0 and own.quality > 0.97 and other.success > 0.9 and other.quality < 0.92
    assert judge.reaches(straight, own) and not judge.reaches(wandering(straight), own)
    assert judge.reaches(wandering(straight), other)


def test_a_list_is_judged_the_same_whenever_it_is_stopped() -> None:
    """What was played before it was given up counts later."""
    domain, bias = world("cars", cars=3, places=3)
    straight = cars_rules(bias)
    policy = by_hand(domain, bias, straight)
    worths = []
    for hurdle in (None, Worth(1.0, 1.0), Worth(1.0, 0.9)):
        judge = PlayedJudge(policy, bias, domain, time.process_time() + 1000)
        if hurdle:
            judge.reaches(wandering(straight), hurdle)
        worths.append(judge.worth(wandering(straight)))
    assert worths[0] == worths[1] == worths[2]


def test_who_goes_straight_is_distilled_into_rules_that_do() -> None:
    domain, bias = world("cars")
    policy = by_hand(domain, bias, cars_rules(bias))
    large, _ = world("cars", cars=8, places=6)
    few = distill(policy, bias, judged=large)
    (tree,) = few.trees
    assert len(list(rules(tree))) <= 7
    found = evaluate(few, 40, greedy=True)
    wanted = evaluate(by_hand(large, bias, cars_rules(bias)), 40, greedy=True)
    assert found.success == wanted.success == 1.0 and found.mean_steps < 1.03 * wanted.mean_steps
    assert all(Refiner(bias).allows(rule.query) for rule in rules(tree))


def test_the_same_rules_again() -> None:
    domain, bias = world("cars")
    policy = by_hand(domain, bias, cars_rules(bias))
    assert distill(policy, bias).rules(1) == distill(policy, bias).rules(1)


def test_judged_on_what_is_given(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    domain, bias = world("cars")
    by_hand(domain, bias, cars_rules(bias)).save(tmp_path / "model.pl", [("bias", "cars.yaml")])
    (tmp_path / "cars.yaml").write_bytes((DOMAINS / "cars.yaml").read_bytes())
    assert main(["distill", str(tmp_path / "model.pl"), "--set", "cars=5"]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed[-2].startswith("tried on ") and "(horizon 40): solved 60, where the policy solves 60" in printed[-2]
    assert "over sampled 1,000 start states: 1.000000" in printed[-1]
