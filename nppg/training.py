"""TREENPPG: Algorithm 1 of Kersting and Driessens (2008)."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from nppg.domain import Action, Domain, State
from nppg.episode import Episode, Step, training_episodes
from nppg.gradient import functional_gradient, returns, taken_gradient
from nppg.language_bias import LanguageBias
from nppg.options import Options
from nppg.policy import Policy
from nppg.regression import Examples, regressor
from nppg.tilde import Newton
from nppg.tree import leaves


@dataclass(frozen=True, slots=True)
class Iteration:
    """The policy after one more tree; `episodes` counts all so far, `recent` are those since the last tree."""

    policy: Policy
    episodes: int
    recent: tuple[Episode, ...]


class Visit(NamedTuple):
    """A step and its return."""

    step: Step
    value: float


def visits(episode: Episode, options: Options) -> list[Visit]:
    """The steps of an episode that trees learn from. A return of 0 gives neither gradient nor curvature, so a
    second-order step learns nothing there."""
    values = returns([step.reward for step in episode.steps], options.discount).tolist()
    pairs = map(Visit, episode.steps, values)
    keep = options.unrewarded == "keep" and options.step == "gradient"
    return [visit for visit in pairs if visit.value != 0 or keep]


def revisited(visit: Visit, policy: Policy) -> Visit:
    """The same step as the present policy would see it."""
    step = visit.step
    answers = step.answers
    if answers.shape[1] != len(policy.table):
        answers = policy.answers(step.state, step.actions)
    potentials = policy.potentials_of(answers)
    probabilities = policy.probabilities_of(potentials)
    return Visit(replace(step, answers=answers, potentials=potentials, probabilities=probabilities), visit.value)


def updated_actions(step: Step, options: Options) -> slice:
    """Which of a step's actions get an example."""
    return slice(None) if options.update == "all" else slice(step.chosen, step.chosen + 1)


def examples(batch: Sequence[Visit], options: Options) -> Examples:
    """The functional gradient at each updated action b (Proposition 3.1); for a second-order step also the curvature
    |value| pi(s, b) (1 - pi(s, b))."""
    states: list[State] = []
    actions: list[Action] = []
    answers, gradients, curvatures = [], [], []
    importance = options.importance if options.step == "second-order" else 1.0
    for step, value in batch:
        updated, probabilities = updated_actions(step, options), step.probabilities
        if options.update == "all":
            gradients.append(functional_gradient(probabilities, step.chosen, value, importance))
        else:
            gradients.append(np.array([taken_gradient(probabilities, step.chosen, value)]))
        curvatures.append((abs(value) * probabilities * (1 - probabilities))[updated])
        answers.append(step.answers[updated])
        actions += step.actions[updated]
        states += [step.state] * len(gradients[-1])
    newton = Newton(np.concatenate(curvatures), options.regularisation, options.clip)
    return Examples(
        states,
        actions,
        np.concatenate(answers),
        np.concatenate(gradients),
        newton if options.step == "second-order" else None,
    )


def train(domain: Domain, bias: LanguageBias, options: Options | None = None) -> Iterator[Iteration]:
    """Yields after each tree, the first time before the first one. Raises NppgError."""
    options = options or Options()
    rng = np.random.default_rng(options.seed)
    learner = regressor(domain, bias, options)
    policy = Policy(domain, bias, learner.table)
    memory: deque[Visit] = deque(maxlen=options.replay)
    batch: list[Visit] = []
    recent: list[Episode] = []
    gathered = 0
    yield Iteration(policy, 0, ())
    for count, episode in enumerate(training_episodes(policy, rng, options), 1):
        recent.append(episode)
        new = visits(episode, options)
        gathered += sum(len(step.actions[updated_actions(step, options)]) for step, _ in new)
        batch += new
        enough = gathered > options.min_examples
        if count < options.episodes and not (enough and len(recent) >= options.episodes_per_iteration):
            continue
        if enough:
            replayed = [revisited(visit, policy) for visit in memory]
            tree = learner.fit(examples([*replayed, *batch], options))
            memory.extend(visit for visit in batch if visit.value != 0)
            size = f"{gathered} examples, {leaves(tree)} leaves"
            policy.add(tree, options.step_size, f"step size {options.step_size}, {size}")
        yield Iteration(policy, count, tuple(recent))
        batch, recent, gathered = [], [], 0
