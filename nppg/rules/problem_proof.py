"""A proof of a policy's success on problems: what it does in every state that it can come to."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np

from nppg.bridge.files import file_hash
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
    """A run that misses the goal: the steps `way` from the start to the state that it begins in, what holds there (but
    static facts), its own steps as lines of a plan, with what happens where that is left to chance, and how many of the last of them go
    round in a loop: 0 where it ends in a state without a way on. After `lost` of them, where that is known, the goal is
    out of reach, whatever is done."""

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
    """Proves the policy on these problems of its domain, by default those that start states are drawn from; each is told
    to `report` once it is proven. Raises NppgError where a problem has more than `limit` states, where the domain has no
    goal or is not the one that the model was made with, and as nppg.judging.reachable.Reachable does."""
    domain = policy.domain
    if wrong := another_domain(model, domain, policy.facts):
        raise NppgError(wrong)
    if not domain.has_goal:
        raise NppgError(f"{domain.path}: a proof is about goal/0, which the domain does not define")
    greedy = greedy or policy.greedy
    proven = []
    for number in domain.chosen if problems is None else problems:
        try:
            proven.append(prove_problem(policy, domain.problem(number), domain.problems[number], greedy, everywhere, limit))
        except TooMany as error:
            how = "" if everywhere or not greedy else " by the policy"
            raise NppgError(f"{domain.problems[number]}: {error}{how}: allow more by --states") from None
        report(proven[-1])
    return ProblemsProof(
        version("nppg"), file_hash(model), domain.hash, domain.parameters, greedy, everywhere, tuple(proven)
    )


def prove_problem(
    policy: Policy, start: State, name: str = "", greedy: bool = True, everywhere: bool = False, limit: int = LIMIT
) -> ProblemProof:
    """Proves the policy on the problem of this start state. Raises NppgError."""
    domain = policy.domain
    own = greedy and not everywhere
    graph = Reachable(domain, start, limit, (lambda state, legal: _preferred(policy, state, legal)) if own else None)
    taken, probabilities = _choices(policy, graph, greedy, own)
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


def _preferred(policy: Policy, state: State, legal: Sequence[Action]) -> list[Action]:
    """All that the greedy policy may do."""
    if policy.is_rules:
        return policy.preferred(state)
    actions = list(legal)
    return [actions[i] for i in np.flatnonzero(best(policy.potentials(state, actions)))]


def _choices(policy: Policy, graph: Reachable, greedy: bool, own: bool) -> tuple[np.ndarray, np.ndarray]:
    """Which pairs of the graph the policy can take, and with which probabilities; all where it is its `own` graph. The
    stochastic policy can take every legal action, however small its probability."""
    taken, probabilities = np.ones(len(graph.owner), bool), np.ones(len(graph.owner))
    first = np.flatnonzero(np.diff(graph.owner, prepend=-1))
    for begin, end in zip(first, [*first[1:], len(graph.owner)], strict=True):
        if not own:
            state = graph.states[graph.owner[begin]]
            potentials = policy.potentials(state, graph.actions[begin:end])
            if greedy:
                taken[begin:end] = best(potentials)
            else:
                probabilities[begin:end] = policy.probabilities_of(potentials)
        if greedy:
            probabilities[begin:end] = taken[begin:end] / taken[begin:end].sum()
    return taken, probabilities


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
