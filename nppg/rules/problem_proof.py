"""A proof of a policy's success on problems: what it does in every state that it can come to."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np

from nppg.bridge.seals import content_hash
from nppg.bridge.terms import texts
from nppg.errors import NppgError
from nppg.judging.chain import reaching
from nppg.judging.reachable import LIMIT, Reachable, TooMany
from nppg.learning.episode import longest
from nppg.policy.gibbs import best
from nppg.policy.model import another_domain
from nppg.policy.policy import Policy
from nppg.rules.certificates import Certificate
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State


@dataclass(frozen=True, slots=True)
class Trace:
    """A run that misses the goal: the steps `way` from the start to the state that it begins in, what holds there but
    static facts, its own steps as lines of a plan, with what happens where that is left to chance, and how many of the
    last of them go round in a loop: 0 where it ends in a state without a way on. After `lost` of them, where that is
    known, the goal is out of reach, whatever is done."""

    way: tuple[str, ...]
    state: str
    steps: tuple[str, ...]
    loop: int
    lost: int | None = None


@dataclass(frozen=True, slots=True)
class ProblemProof:
    """What is proven of one problem. `states` that were gone through: those that the policy can come to from the start,
    or all that can be reached. `certain`: from the start every run reaches the goal, whatever ties and chance leave
    open, after `longest` steps at most. `success`: the probability to reach it within the `horizon`, ties being drawn
    evenly. `alive`: from how many of the states the goal can be reached, by any actions, and `sure` from how many of
    these the policy reaches it for certain, where all were gone through."""

    name: str
    facts_sha256: str
    horizon: int
    states: int
    certain: bool
    longest: int | None
    success: float
    alive: int | None
    sure: int | None
    failure: Trace | None

    @property
    def complete(self) -> bool:
        """Whether there is no run that fails."""
        return self.failure is None


@dataclass(frozen=True, slots=True)
class ProblemsProof(Certificate):
    """On each of some problems, from the start or `everywhere`: from all states from which the goal can be reached."""

    nppg: str
    model_sha256: str
    domain_sha256: str
    parameters: dict[str, int | float | str]
    greedy: bool
    everywhere: bool
    problems: tuple[ProblemProof, ...]

    @property
    def complete(self) -> bool:
        """Whether all problems are proven."""
        return all(each.complete for each in self.problems)


def prove_problems(
    policy: Policy,
    model: Path,
    problems: Iterable[int] | None = None,
    greedy: bool = True,
    everywhere: bool = False,
    limit: int = LIMIT,
    report: Callable[[ProblemProof], None] = lambda proof: None,
) -> ProblemsProof:
    """Goes through the states of these problems of the policy's domain, by default those that start states are drawn
    from; what is found of each is told to `report` at once. Raises NppgError where a problem has more than `limit`
    states, where the domain has no goal or is not the one that the model was made with, and as
    nppg.judging.reachable.Reachable does."""
    domain = policy.domain
    if wrong := another_domain(model, domain, policy.facts):
        raise NppgError(wrong)
    if not domain.has_goal:
        raise NppgError(f"{domain.path}: a proof is about goal/0, which the domain does not define")
    greedy = greedy or policy.greedy
    proven = []
    for number in domain.chosen if problems is None else problems:
        try:
            proof = prove_problem(policy, domain.problem(number), domain.problems[number], greedy, everywhere, limit)
        except TooMany as error:
            how = " by the policy" if greedy and not everywhere else ""
            raise NppgError(f"{domain.problems[number]}: {error}{how}: allow more by --states") from None
        proven.append(proof)
        report(proof)
    return ProblemsProof(
        version("nppg"), content_hash(model), domain.hash, domain.parameters, greedy, everywhere, tuple(proven)
    )


def prove_problem(
    policy: Policy, start: State, name: str = "", greedy: bool = True, everywhere: bool = False, limit: int = LIMIT
) -> ProblemProof:
    """What there is to say of the policy on the problem of this start state. Raises NppgError."""
    domain = policy.domain
    choice = _Choice(policy, greedy, everywhere)
    graph = Reachable(domain, start, limit, choice, choice.lean)
    taken, probabilities = np.array(choice.taken, bool), np.array(choice.probabilities)
    runs = graph.longest(taken)
    distances = graph.distances() if everywhere else None
    alive = np.flatnonzero(graph.running & (distances > 0)) if distances is not None else np.array([], int)
    failing = [0, *alive.tolist()] if everywhere else [0]
    failing = [state for state in failing if runs[state] < 0]
    horizon = longest(domain.horizon(start), 1.0) if graph.running[0] else 0
    within = horizon * (np.arange(len(graph.states)) == 0)
    success = float(reaching(graph, probabilities, within)[0][0]) if graph.running[0] else float(graph.goal[0])
    certain = bool(runs[0] >= 0)
    return ProblemProof(
        name,
        hashlib.sha256(str(graph.states[0]).encode()).hexdigest(),
        horizon,
        len(graph.states),
        certain,
        int(runs[0]) if certain else None,
        success,
        int((distances >= 0).sum()) if distances is not None else None,
        int(((distances >= 0) & (runs >= 0)).sum()) if distances is not None else None,
        _trace(graph, taken, runs, failing[0], distances) if failing else None,
    )


class _Choice:
    """What a policy does in the states of a graph that is being explored: `taken`, which pairs it may take, and
    `probabilities`, ties being drawn evenly. Where all states are wanted, all legal actions lead on; else the greedy
    policy's own, and a list of rules finds them without looking at the others. The stochastic policy can take every
    legal action, however small its probability."""

    def __init__(self, policy: Policy, greedy: bool, everywhere: bool):
        self.policy = policy
        self.greedy = greedy
        self.own = greedy and not everywhere
        self.lean = self.own and policy.is_rules
        self.taken: list[bool] = []
        self.probabilities: list[float] = []

    def __call__(self, state: State, legal: Sequence[Action]) -> Sequence[Action]:
        if self.lean:
            actions: Sequence[Action] = self.policy.preferred(state)
            return self._noted(actions, np.ones(len(actions), bool))
        actions = list(legal)
        potentials = self.policy.potentials(state, actions)
        if not self.greedy:
            return self._noted(actions, np.ones(len(actions), bool), self.policy.probabilities_of(potentials))
        taken = best(potentials)
        if self.own:
            actions, taken = [actions[i] for i in np.flatnonzero(taken)], taken[taken]
        return self._noted(actions, taken)

    def _noted(
        self, actions: Sequence[Action], taken: np.ndarray, probabilities: np.ndarray | None = None
    ) -> Sequence[Action]:
        self.taken += taken.tolist()
        self.probabilities += (taken / taken.sum() if probabilities is None else probabilities).tolist()
        return actions


def _trace(
    graph: Reachable, taken: np.ndarray, runs: np.ndarray, begin: int, distances: np.ndarray | None
) -> Trace:
    """A run from a state from which the policy can fail: always on to a state from which it can."""
    possible = np.flatnonzero(taken[graph.origin] & (runs[graph.target] < 0))
    onwards: dict[int, int] = {}
    for outcome, state in zip(possible[::-1].tolist(), graph.source[possible[::-1]].tolist(), strict=True):
        onwards[state] = outcome
    met, here, steps = {begin: 0}, begin, []
    while here in onwards:
        steps.append(onwards[here])
        here = int(graph.target[steps[-1]])
        if here in met:
            break
        met[here] = len(steps)
    loop = len(steps) - met[here] if here in onwards else 0
    lost = None
    if distances is not None:
        lost = min((number for state, number in met.items() if distances[state] < 0), default=None)
    domain = graph.domain
    return Trace(
        tuple(_line(domain, graph, outcome) for outcome in graph.way_to(begin)),
        ", ".join(texts(graph.states[begin].facts)),
        tuple(_line(domain, graph, outcome) for outcome in steps),
        loop,
        lost,
    )


def _line(domain: Domain, graph: Reachable, outcome: int) -> str:
    """A step as a line of a plan, with the facts that come to hold where that is left to chance."""
    pair = graph.origin[outcome]
    line = domain.plan_step(graph.actions[pair])
    if np.count_nonzero(graph.origin == pair) > 1:
        before, after = (graph.states[each] for each in (graph.owner[pair], graph.target[outcome]))
        new = sorted({*texts(after.facts)} - {*texts(before.facts)})
        line += f"  ; with luck: {', '.join(new) or 'nothing new'}"
    return line
