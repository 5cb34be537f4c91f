"""A proof of a policy's success: what it does from every class of states, tied by hashes to the files it is about."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np

from nppg.bridge.seals import content_hash
from nppg.errors import NppgError
from nppg.judging.evaluation import ExactEvaluator
from nppg.judging.space import Space
from nppg.policy.model import another_domain
from nppg.policy.policy import Policy
from nppg.rules.certificates import Certificate


@dataclass(frozen=True, slots=True)
class Failure:
    """A class of start states from which the policy can fail: one of its states, drawn and as facts, how many there
    are, and the success probability."""

    picture: tuple[str, ...]
    state: tuple
    states: int
    success: float


@dataclass(frozen=True, slots=True)
class Proof(Certificate):
    """`success` is the share of all `starts` start states, times the probability to succeed there; `failures` are the
    classes from which the goal can be missed, the likeliest failure first."""

    nppg: str
    model_sha256: str
    domain_sha256: str
    parameters: dict[str, int | float | str]
    greedy: bool
    classes: int
    states: int
    starts: int
    success: float
    failures: tuple[Failure, ...]

    @property
    def complete(self) -> bool:
        """Whether the policy succeeds for certain from every start state."""
        return not self.failures


def prove(policy: Policy, model: Path, greedy: bool = True, space: Space | None = None) -> Proof:
    """Goes through every class of states: those of `space`, where it is given. Raises NppgError where the domain is not
    the one that the model was made with, and as nppg.judging.evaluation.ExactEvaluator does."""
    if problems := another_domain(model, policy.domain, policy.facts):
        raise NppgError(problems)
    greedy = greedy or policy.greedy
    judge = ExactEvaluator(policy, space)
    space = judge.space
    success, _ = judge.by_class(greedy)
    failing = np.flatnonzero(space.running & ~judge.certain(greedy))
    return Proof(
        version("nppg"),
        content_hash(model),
        policy.domain.hash,
        policy.domain.parameters,
        greedy,
        len(space.states),
        sum(space.sizes),
        space.starts,
        judge.evaluate(greedy).success if len(failing) else 1.0,
        tuple(
            Failure(
                tuple(policy.domain.picture(space.states[i])), tuple(space.states[i]), space.sizes[i], float(success[i])
            )
            for i in sorted(failing, key=lambda i: (success[i] - 1) * space.sizes[i])
        ),
    )
