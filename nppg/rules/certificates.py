"""Certificates: what a proof has found, as JSON, to be held against the same proof done again."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from pathlib import Path

from nppg.bridge.files import replacing
from nppg.errors import NppgError, Problem


class Certificate:
    """What dataclasses that are proofs have in common."""

    __slots__ = ()

    def save(self, path: Path) -> None:
        """Writes the certificate, as JSON."""
        replacing(path, lambda temporary: temporary.write_text(_text(self)))


def _text(proof: Certificate) -> str:
    return json.dumps(asdict(proof), indent=1) + "\n"  # type: ignore[call-overload]


def check_certificate(certificate: Path, proof: Certificate) -> None:
    """Raises NppgError where a certificate says anything else than this proof of the policy as it is now."""
    try:
        claimed = json.loads(certificate.read_text())
    except OSError as error:
        raise NppgError([Problem(str(certificate), 0, 0, f"cannot be read: {error.strerror}")]) from None
    except (ValueError, RecursionError):
        claimed = None
    if not isinstance(claimed, dict) or "model_sha256" not in claimed:
        raise NppgError([Problem(str(certificate), 0, 0, "this is no certificate of nppg")])
    proved = json.loads(_text(proof))
    wrong = [name for name in (proved | claimed) if not _agree(claimed.get(name), proved.get(name))]
    if wrong:
        names = ", ".join(name.removesuffix("_sha256") for name in wrong)
        message = f"the certificate says something else than the proof of this policy about: {names}"
        raise NppgError([Problem(str(certificate), 0, 0, message)])


def _agree(one: object, other: object) -> bool:
    """Whether two contents of JSON are the same, but for rounding."""
    match one, other:
        case float(), float():
            return math.isclose(one, other, rel_tol=1e-9, abs_tol=1e-9)
        case list(), list():
            return len(one) == len(other) and all(map(_agree, one, other))
        case dict(), dict():
            return one.keys() == other.keys() and all(_agree(one[name], other[name]) for name in one)
    return type(one) is type(other) and one == other
