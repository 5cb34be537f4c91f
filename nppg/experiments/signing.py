"""Checksums for files that were edited on purpose."""

from __future__ import annotations

import codecs
import json
from functools import partial
from pathlib import Path

from nppg.bridge.files import replacing
from nppg.bridge.seals import contents, parts, sealed, told
from nppg.experiments import checkpoints
from nppg.policy import model


def sign(path: Path) -> None:
    """Writes the checksum of a model, a certificate, a checkpoint or a run.json anew. Raises NppgError where it is none
    of these."""
    content = parts(contents(path))[0].removeprefix(codecs.BOM_UTF8)
    if content.lstrip().startswith(b"{"):
        content = _without_member(path, content.lstrip())
    else:
        model.parsed(path)
    replacing(path, partial(Path.write_bytes, data=sealed(content)))


def _without_member(path: Path, content: bytes) -> bytes:
    """JSON of one of these kinds, without a checksum that an editor has moved to another place."""
    try:
        found = json.loads(content)
    except (ValueError, RecursionError) as error:
        raise told(path, f"is no JSON: {error}") from None
    if found.get("nppg") == "checkpoint":
        checkpoints.parsed(path, None, content)
    elif not found.keys() & {"model_sha256", "learner"}:
        raise told(path, "is no model, certificate, checkpoint or run.json of nppg")
    if found.pop("sha256", None) is None:
        return content
    return (json.dumps(found, indent=2) + "\n").encode()
