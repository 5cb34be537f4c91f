"""TREENPPG: Algorithm 1 of Kersting and Driessens (2008)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.learning.courses import course_of
from nppg.learning.curriculum import curriculum_of
from nppg.learning.episode import Episode, Expert
from nppg.learning.options import Options
from nppg.learning.rollouts import are_many, iterations_episodes, training_episodes
from nppg.policy.policy import Policy
from nppg.trees.tree import leaves
from nppg.worlds.domain import Domain


@dataclass(frozen=True, slots=True)
class Iteration:
    """The policy after one more tree; `episodes` counts all so far, `recent` are those since the last tree. `stage`:
    how far the curriculum is, where there is one."""

    policy: Policy
    episodes: int
    recent: tuple[Episode, ...]
    stage: str = ""


def wanted(trees: int, options: Options) -> float:
    """More examples than this are gathered for the tree that follows so many: min_examples (1 + growth trees)."""
    return options.min_examples + options.min_examples * options.examples_growth * trees


def train(
    domain: Domain,
    bias: LanguageBias,
    options: Options | None = None,
    jobs: int = 1,
    is_over: Callable[[], bool] = lambda: False,
    expert: Expert | None = None,
) -> Iterator[Iteration]:
    """Yields after each tree, the first time before the first one, the last time after all episodes, or the one after
    which it `is_over`. Where there are MANY episodes to an iteration, up to `jobs` processes play them, and nothing
    changes with their number. `expert` guides episodes in place of the domain's own, and is pickled for these
    processes. Raises NppgError.

    A policy asks what its trees test. It shares the learner's table where trees are grown from the answers that its
    steps have: not where the table is large, or in self-imitation."""
    options = options or Options()
    course = course_of(domain, bias, options)
    policy = Policy(domain, bias, course.table)
    recent: list[Episode] = []
    curriculum = curriculum_of(domain) if options.curriculum == "yes" else None
    yield Iteration(policy, 0, (), str(curriculum or ""))
    if are_many(options):
        watched = iterations_episodes(policy, options, jobs, curriculum, expert)
    else:
        rng = np.random.default_rng(options.seed)
        watched = training_episodes(policy, rng, options, curriculum, expert)
    with watched as episodes:
        for count, episode in enumerate(episodes, 1):
            recent.append(episode)
            course.hear(episode)
            gathered = course.gathered
            enough = gathered > wanted(len(policy.trees), options)
            last = count == options.episodes or is_over()
            if not last and not (enough and len(recent) >= options.episodes_per_iteration):
                continue
            if enough and (grown := course.tree(policy)):
                tree, eta = grown
                policy.add(tree, eta, f"step size {eta}, {gathered} examples, {leaves(tree)} leaves")
            yield Iteration(policy, count, tuple(recent), str(curriculum or ""))
            if last:
                return
            recent = []
