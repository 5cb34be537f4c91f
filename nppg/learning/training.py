"""TREENPPG: Algorithm 1 of Kersting and Driessens (2008)."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from nppg.answers.table import Table, TestTable
from nppg.bias.language_bias import LanguageBias
from nppg.learning.critic import critic
from nppg.learning.episode import Episode, Expert, Step
from nppg.learning.gradient import functional_gradient, taken_gradient
from nppg.learning.line_search import step_size
from nppg.learning.options import Options
from nppg.learning.regressors import Examples, regressor
from nppg.learning.rollouts import are_many, iterations_episodes, training_episodes
from nppg.learning.visits import Visit, kept, normalised, revisited
from nppg.policy.policy import Policy
from nppg.trees.tilde import Newton, size_of
from nppg.trees.tree import leaves
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State

_LARGE = 200  # a table of more tests is asked about steps that trees learn from alone: most teach nothing


@dataclass(frozen=True, slots=True)
class Iteration:
    """The policy after one more tree; `episodes` counts all so far, `recent` are those since the last tree."""

    policy: Policy
    episodes: int
    recent: tuple[Episode, ...]


def updated_actions(step: Step, options: Options) -> slice:
    """Which of a step's actions get an example."""
    return slice(None) if options.update == "all" else slice(step.chosen, step.chosen + 1)


def importance_of(step: Step, options: Options) -> float:
    """The power k of pi(s, a) that weights a step. Second-order steps learn from what an expert chose with k = 0,
    whatever the option is: the weight pi(s, a)^k is about how often the policy itself would act so, and an expert is to
    teach what it would not do. With it the gradient vanishes just where the policy is certain of another action.
    Without it a step climbs value * log pi(s, a), the likelihood of what the expert did: its gradient at the action,
    value (1 - pi(s, a)), is largest there, and its curvature |value| pi(s, b) (1 - pi(s, b)) is the one that `examples`
    has, so that a leaf is a Newton step, bounded by lambda and the clip. The paper's steps weight expert and policy
    alike."""
    assert options.importance is not None
    return 0.0 if step.guided and options.step == "second-order" else options.importance


def examples(batch: Sequence[Visit], options: Options, trees: int = 0, table: Table | None = None) -> Examples:
    """The functional gradient at each updated action b (Proposition 3.1); for a second-order step also the curvature
    |value| pi(s, b) (1 - pi(s, b)), and lambda as it is after so many trees. The answers are those of the steps; where
    a table is given, its own, which are asked for now."""
    states: list[State] = []
    actions: list[Action] = []
    answers, gradients, curvatures = [], [], []
    for step, value, _ in batch:
        updated, probabilities = updated_actions(step, options), step.probabilities
        importance = importance_of(step, options)
        if options.update == "all":
            gradients.append(functional_gradient(probabilities, step.chosen, value, importance))
        else:
            gradients.append(np.array([taken_gradient(probabilities, step.chosen, value, importance)]))
        curvatures.append((abs(value) * probabilities * (1 - probabilities))[updated])
        if table is None:
            answers.append(step.answers[updated])
        actions += step.actions[updated]
        states += [step.state] * len(gradients[-1])
    if table is not None:
        pairs = [(step.state, step.actions[updated_actions(step, options)]) for step, *_ in batch]
        answers.append(table.answers_in(pairs))
    regularisation = options.regularisation * (1 + options.regularisation_growth * trees)
    newton = Newton(np.concatenate(curvatures), regularisation, options.clip)
    return Examples(
        states,
        actions,
        np.concatenate(answers),
        np.concatenate(gradients),
        newton if options.step == "second-order" else None,
        size_of(np.array([value for _, value, _ in batch])),
    )


def wanted(trees: int, options: Options) -> float:
    """More examples than this are gathered for the tree that follows so many: min_examples (1 + growth trees)."""
    return options.min_examples + options.min_examples * options.examples_growth * trees


def train(
    domain: Domain,
    bias: LanguageBias,
    options: Options | None = None,
    jobs: int = 1,
    expert: Expert | None = None,
) -> Iterator[Iteration]:
    """Yields after each tree, the first time before the first one. Where there are MANY episodes to an iteration, up to
    `jobs` processes play them, and nothing changes with their number. `expert` guides episodes in place of the domain's
    own, and is pickled for these processes. Raises NppgError.

    A policy asks what its trees test. It shares the learner's table, so that its steps have the answers that trees are
    grown from, unless that is large."""
    options = options or Options()
    learner, judge = regressor(domain, bias, options), critic(domain, bias, options)
    late = isinstance(learner.table, TestTable) and len(learner.table) > _LARGE and not options.replay
    policy = Policy(domain, bias, None if late else learner.table)
    memory: deque[Visit] = deque(maxlen=options.replay)
    batch: list[Visit] = []
    recent: list[Episode] = []
    gathered = 0
    yield Iteration(policy, 0, ())
    if are_many(options):
        episodes = iterations_episodes(policy, options, jobs, expert)
    else:
        episodes = training_episodes(policy, np.random.default_rng(options.seed), options, expert)
    for count, episode in enumerate(episodes, 1):
        recent.append(episode)
        new = judge.visits(episode)
        gathered += sum(len(visit.step.actions[updated_actions(visit.step, options)]) for visit in kept(new, options))
        batch += new
        grown = len(policy.trees)
        enough = gathered > wanted(grown, options)
        if count < options.episodes and not (enough and len(recent) >= options.episodes_per_iteration):
            continue
        if enough:
            learned = normalised(kept(batch, options), options)
            replayed = [revisited(visit, policy) for visit in memory]
            made = examples([*replayed, *learned], options, grown, learner.table if late else None)
            tree = learner.fit(made)
            eta = step_size(tree, learned, policy, options)
            memory.extend(visit for visit in learned if visit.value != 0)
            policy.add(tree, eta, f"step size {eta}, {gathered} examples, {leaves(tree)} leaves")
            judge.learn(batch)
        yield Iteration(policy, count, tuple(recent))
        batch, recent, gathered = [], [], 0
