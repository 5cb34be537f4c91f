"""What the trees of a policy are grown from: the returns of its episodes, or the best ways that these have found."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any, Protocol

import numpy as np

from nppg.answers.table import Table, TestTable
from nppg.bias.language_bias import LanguageBias
from nppg.errors import NppgError
from nppg.learning.critic import critic
from nppg.learning.detours import detours
from nppg.learning.episode import Episode, Step
from nppg.learning.experience import Comparison, Experience, Ways, pairs_of
from nppg.learning.gradient import comparison_gradient, functional_gradient, taken_gradient
from nppg.learning.line_search import step_size
from nppg.learning.options import Options
from nppg.learning.regressors import Examples, regressor
from nppg.learning.visits import Visit, kept, normalised, revisited
from nppg.policy.policy import Policy
from nppg.trees.tilde import Newton, size_of
from nppg.trees.tree import Tree
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State

_LARGE = 200  # a table of more tests is asked about steps that trees learn from alone: most teach nothing
_FEWEST = 20  # comparisons that a tree is grown from; in small worlds a quarter of the states that have been met
_OF_RETURNS = ("update", "unrewarded", "critic", "normalise", "line_search")  # options that are about these alone


class Course(Protocol):
    """Gathers examples from episodes, and makes a tree of them."""

    table: Table | None  # that the policy shares; none where it asks its own trees' tests alone
    gathered: int  # examples since the last tree

    def hear(self, episode: Episode) -> None:
        """Learns of an episode."""

    def tree(self, policy: Policy) -> tuple[Tree, float] | None:
        """The next tree of the policy, and its step size, from what has gathered, which is over then; none where there
        was nothing to learn in it."""

    def saved(self) -> dict[str, Any]:
        """What it has gathered, to be stored between two episodes."""

    def resume(self, saved: dict[str, Any]) -> None:
        """Goes on with that; the policy has its trees already."""


class Returns:
    """The functional gradient of the returns, or advantages (Kersting and Driessens 2008)."""

    def __init__(self, domain: Domain, bias: LanguageBias, options: Options):
        self.options = options
        self.learner, self.judge = regressor(domain, bias, options), critic(domain, bias, options)
        table = self.learner.table
        self._late = isinstance(table, TestTable) and len(table) > _LARGE and not options.replay
        self.table: Table | None = None if self._late else table
        self.gathered = 0
        self._memory: deque[Visit] = deque(maxlen=options.replay)
        self._batch: list[Visit] = []

    def hear(self, episode: Episode) -> None:
        new = self.judge.visits(episode)
        used = (visit.step for visit in kept(new, self.options))
        self.gathered += sum(len(step.actions[updated_actions(step, self.options)]) for step in used)
        self._batch += new

    def tree(self, policy: Policy) -> tuple[Tree, float]:
        learned = normalised(kept(self._batch, self.options), self.options)
        replayed = [revisited(visit, policy) for visit in self._memory]
        table = self.learner.table if self._late else None
        tree = self.learner.fit(examples([*replayed, *learned], self.options, len(policy.trees), table))
        eta = step_size(tree, learned, policy, self.options)
        self._memory.extend(visit for visit in learned if visit.value != 0)
        self.judge.learn(self._batch)
        self._batch, self.gathered = [], 0
        return tree, eta

    def saved(self) -> dict[str, Any]:
        critic = self.judge.saved()
        return {"gathered": self.gathered, "batch": self._batch, "memory": [*self._memory], "critic": critic}

    def resume(self, saved: dict[str, Any]) -> None:
        self.gathered, self._batch = saved["gathered"], saved["batch"]
        self._memory.extend(saved["memory"])
        self.judge.resume(saved["critic"])


class SelfImitation:
    """The best of what episodes have tried, as if an expert had done it (self-imitation: Oh et al. 2018): in each state
    that they have met the beginnings of the shortest known ways to the goal are to have a higher potential than what
    else has been tried there. What has not been tried is not judged.

    So a failed episode teaches as well, as soon as another one has found a way from one of its states; and no action
    stays certain because the others are never drawn."""

    def __init__(self, domain: Domain, bias: LanguageBias, options: Options):
        wrong = (
            "it has no goal" if not domain.has_goal
            else "its actions are left to chance" if domain.has_chance
            else "policies do not see its states as they are" if domain.has_observation
            else "its environment cannot go back to a state" if domain.environment
            else ""
        )
        if wrong:
            raise NppgError(f"self-imitation is not for the domain {domain.name}: {wrong}")
        given, usual = asdict(options), asdict(Options())
        if named := [f"{name} {given[name]}" for name in _OF_RETURNS if given[name] != usual[name]]:
            raise NppgError(f"self-imitation does not learn from returns: it has no use for {', '.join(named)}")
        self.options = options
        self.learner = regressor(domain, bias, options)
        self.table: Table | None = None
        self.gathered = 0
        self._experience = Experience()
        self._rng = np.random.default_rng([options.seed, 1])  # of what is drawn from it
        self._met: dict[tuple[Ways, int], None] = {}

    def hear(self, episode: Episode) -> None:
        if episode.steps:
            ways, numbers = self._experience.hear(episode)
            self._met.update(dict.fromkeys((ways, number) for number in numbers))
            self.gathered += len(episode.steps)

    def tree(self, policy: Policy) -> tuple[Tree, float] | None:
        met: dict[Ways, dict[int, None]] = {}  # by problem, which is expensive to change
        for ways, number in (*self._met, *self._experience.draw(self.options.replay, self._rng)):
            met.setdefault(ways, {})[number] = None
        left = self.options.detours * self.gathered
        self._met, self.gathered = {}, 0
        problems = list(met)
        for at in self._rng.permutation(len(problems)).tolist():
            left -= detours(problems[at], list(met[problems[at]]), policy, self._rng, left)
        found = [ways.comparison(each, self.options.discount) for ways, numbers in met.items() for each in numbers]
        comparisons = [each for each in found if each]
        if len(comparisons) < min(_FEWEST, self._experience.size / 4):
            return None
        made = compared(comparisons, policy, self.learner.table, self.options)
        return self.learner.fit(made), self.options.step_size

    def saved(self) -> dict[str, Any]:
        remembered, met = self._experience.saved([ways for ways, _ in self._met])
        return {
            "gathered": self.gathered,
            "rng": dict(self._rng.bit_generator.state),
            "experience": remembered,
            "met": [[at, number] for at, (_, number) in zip(met, self._met, strict=True)],
        }

    def resume(self, saved: dict[str, Any]) -> None:
        self.gathered = saved["gathered"]
        self._rng.bit_generator.state = saved["rng"]
        ways = self._experience.resume(saved["experience"])
        self._met = {(ways[at], number): None for at, number in saved["met"]}


def course_of(domain: Domain, bias: LanguageBias, options: Options) -> Course:
    """The one that the options ask for. Raises NppgError where it is not for the domain."""
    if options.imitation == "self":
        return SelfImitation(domain, bias, options)
    return Returns(domain, bias, options)


def updated_actions(step: Step, options: Options) -> slice:
    """Which of a step's actions get an example."""
    return slice(None) if options.update == "all" else slice(step.chosen, step.chosen + 1)


def importance_of(step: Step, options: Options) -> float:
    """The power k of pi(s, a) that weights a step. Second-order steps learn from what a teacher chose, which is an
    `expert` that nobody wrote, with k = 0: the weight pi(s, a)^k is about how often the policy itself would act so, and
    a teacher is to show what it would not do. With it the gradient vanishes just where the policy is certain of another
    action. Without it a step climbs value * log pi(s, a), the likelihood of what the teacher did: its gradient at the
    action, value (1 - pi(s, a)), is largest there, and its curvature |value| pi(s, b) (1 - pi(s, b)) is the one that
    `examples` has, so that a leaf is a Newton step, bounded by lambda and the clip. The paper weights its expert and
    the policy alike."""
    assert options.importance is not None
    taught = step.guided and options.expert != "domain" and options.step == "second-order"
    return 0.0 if taught else options.importance


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
    return Examples(
        states,
        actions,
        np.concatenate(answers),
        np.concatenate(gradients),
        _newton(np.concatenate(curvatures), options, trees),
        size_of(np.array([value for _, value, _ in batch])),
    )


def compared(comparisons: Sequence[Comparison], policy: Policy, table: Table, options: Options) -> Examples:
    """The gradient of what comparisons say about a policy, and its curvature; the answers are those of the table."""
    pairs = pairs_of(comparisons)
    potentials = policy.potentials_of(policy.table.answers_in(pairs))
    ends = np.cumsum([len(each.actions) for each in comparisons])[:-1]
    found = [
        comparison_gradient(own, each.best, each.losses)
        for own, each in zip(np.split(potentials, ends), comparisons, strict=True)
    ]
    return Examples(
        [each.state for each in comparisons for _ in each.actions],
        [action for each in comparisons for action in each.actions],
        table.answers_in(pairs),
        np.concatenate([gradient for gradient, _ in found]),
        _newton(np.concatenate([curvature for _, curvature in found]), options, len(policy.trees)),
        1.0,
    )


def _newton(curvatures: np.ndarray, options: Options, trees: int) -> Newton | None:
    regularisation = options.regularisation * (1 + options.regularisation_growth * trees)
    return Newton(curvatures, regularisation, options.clip) if options.step == "second-order" else None
