"""Certificates: what a proof has found, as JSON, to be held against the same proof done again."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from functools import partial
from pathlib import Path

from nppg.bridge.files import replacing
from nppg.bridge.seals import object_in, opened, sealed
from nppg.errors import NppgError, Problem


class Certificate:
    """What dataclasses that are proofs have in common."""

    __slots__ = ()

    def save(self, path: Path) -> None:
        """Writes the certificate, as JSON."""
        replacing(path, lambda temporary: temporary.write_bytes(sealed(_text(self).encode())))


def _text(proof: Certificate) -> str:
    return json.dumps(asdict(proof), indent=1) + "\n"  # type: ignore[call-overload]


def check_certificate(certificate: Path, proof: Certificate, edited: bool = False) -> None:
    """Raises NppgError where a certificate says anything else than this proof of the policy as it is now, or is not as
    it was signed and not said to be `edited`."""
    claimed = opened(certificate, partial(_claimed, certificate), edited)
    proved = json.loads(_text(proof))
    wrong = [name for name in (proved | claimed) if not _agree(claimed.get(name), proved.get(name))]
    if wrong:
        names = ", ".join(name.removesuffix("_sha256") for name in wrong)
        message = f"the certificate says something else than the proof of this policy about: {names}"
        raise NppgError([Problem(str(certificate), 0, 0, message)])


def _claimed(certificate: Path, content: bytes) -> dict:
    claimed = object_in(certificate, content, "model_sha256", "this is no certificate of nppg")
    return {name: value for name, value in claimed.items() if name != "sha256"}  # which an editor may have moved


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
