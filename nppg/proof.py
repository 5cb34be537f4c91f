"""A proof of a policy's success: what it does from every class of states, tied by hashes to the files it is about."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from nppg import __version__
from nppg.errors import NppgError, Problem
from nppg.evaluation import ExactEvaluator
from nppg.model import file_hash, replacing
from nppg.policy import Policy

_SURE = 1 - 1e-9  # a success probability from here on counts as 1: the rest is rounding


@dataclass(frozen=True, slots=True)
class Failure:
    """A class of start states from which the policy can fail: one of its states, drawn and as facts, how many there
    are, and the success probability."""

    picture: tuple[str, ...]
    state: tuple
    states: int
    success: float


@dataclass(frozen=True, slots=True)
class Proof:
    """`success` is the share of all `starts` start states, times the probability to succeed there; `failures` are the
    classes with a probability below 1, the likeliest failure first."""

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
        """Whether the policy succeeds from every start state."""
        return not self.failures

    def save(self, path: Path) -> None:
        """Writes the certificate, as JSON."""
        replacing(path, lambda temporary: temporary.write_text(json.dumps(asdict(self), indent=1) + "\n"))


def prove(policy: Policy, model: Path, greedy: bool = True) -> Proof:
    """Goes through every class of states. Raises NppgError as nppg.evaluation.ExactEvaluator does."""
    judge = ExactEvaluator(policy)
    space = judge.space
    success, _ = judge.by_class(greedy)
    failing = np.flatnonzero(space.running & (success < _SURE))
    return Proof(
        __version__,
        file_hash(model),
        policy.domain.hash,
        policy.domain.parameters,
        greedy,
        len(space.states),
        sum(space.sizes),
        space.starts,
        judge.evaluate(greedy).success if len(failing) else 1.0,
        tuple(
            Failure(tuple(policy.domain.picture(space.states[i])), space.states[i], space.sizes[i], float(success[i]))
            for i in sorted(failing, key=lambda i: (success[i] - 1) * space.sizes[i])
        ),
    )


def check_certificate(certificate: Path, policy: Policy, model: Path) -> dict:
    """The contents of a certificate, if it is about this model and its domain as they are now. Raises NppgError."""
    try:
        contents: dict = json.loads(certificate.read_text())
        claimed = {name: contents[f"{name}_sha256"] for name in ("model", "domain")}
    except OSError as error:
        raise NppgError([Problem(str(certificate), 0, 0, f"cannot be read: {error.strerror}")]) from None
    except (ValueError, KeyError, TypeError):
        raise NppgError([Problem(str(certificate), 0, 0, "this is no certificate of nppg")]) from None
    for name, actual in (("model", file_hash(model)), ("domain", policy.domain.hash)):
        if claimed[name] != actual:
            message = f"the certificate is about another {name}: it has changed since, or was never this one"
            raise NppgError([Problem(str(certificate), 0, 0, message)])
    return contents
