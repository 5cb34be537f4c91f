"""What the experiments share: their seeds, how many runs there are at a time, and the exact success of a run."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import TypeVar

from nppg import Domain, LanguageBias, train
from nppg.bridge.files import locate
from nppg.experiments.many import Processes, available_cores, in_order
from nppg.judging.evaluation import ExactEvaluator
from nppg.judging.space import Space
from nppg.learning.options import Common

Item = TypeVar("Item")
Result = TypeVar("Result")


def add_seeds(parser: argparse.ArgumentParser, seeds: int, first: int | None = None) -> None:
    """How many there are, the first of them if that is to be chosen, and `--jobs`."""
    if first is None:
        parser.add_argument("--seeds", type=int, default=seeds, help="seeds 0 to N - 1")
    else:
        parser.add_argument("--seeds", type=int, default=seeds, help="so many")
        parser.add_argument("--first-seed", type=int, default=first)
    add_jobs(parser)


def add_jobs(parser: argparse.ArgumentParser) -> None:
    """`--jobs` alone."""
    parser.add_argument("--jobs", type=int, default=available_cores(), help="runs at a time (default: the cores)")


def done(function: Callable[[Item], Result], items: Sequence[Item], jobs: int) -> Iterator[Result]:
    """What the function gives for each item, in their order, so many at a time."""
    return in_order(function, items, Processes(jobs))


@cache
def world(name: str) -> tuple[Domain, LanguageBias, Space]:
    """A shipped domain that has few states, with its language bias; what the runs of a process share."""
    domain = Domain(name)
    return domain, LanguageBias.load(locate(name, "language_bias", ".yaml")), Space(domain)


def successes(run: tuple[Common, Sequence[int]]) -> list[float]:
    """The exact success on on(A, B) of a run with these options after so many episodes; value functions act
    greedily."""
    options, marks = run
    domain, bias, space = world("blocks_world")
    found: list[float] = []
    judge = None
    for iteration in train(domain, bias, options):
        judge = judge or ExactEvaluator(iteration.policy, space)
        while len(found) < len(marks) and iteration.episodes >= marks[len(found)]:
            found.append(judge.evaluate().success)
    return found
