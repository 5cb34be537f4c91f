"""Checksums that files carry in them, so that no damaged file is taken for another one.

The first line of a Prolog file is a comment with the SHA-256 of all that follows; in JSON it is the first member of the
object, over all but that.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from nppg.bridge.files import sha256
from nppg.errors import NppgError, Problem

Read = TypeVar("Read")

_COMMENT = re.compile(rb"% SHA-256 of what follows: ([0-9a-f]{64})\n")
_MEMBER = re.compile(rb'\{\n  "sha256": "([0-9a-f]{64})",')


def sealed(data: bytes) -> bytes:
    """A file's contents with their checksum; one that they carry is replaced."""
    content = parts(data)[0]
    digest = sha256(content).encode()
    if content.startswith(b"{"):
        return b'{\n  "sha256": "%s",%s' % (digest, content[1:])
    return b"%% SHA-256 of what follows: %s\n%s" % (digest, content)


def parts(data: bytes) -> tuple[bytes, str | None]:
    """What a file has besides its checksum, and that, if it has one."""
    for pattern, begin in ((_COMMENT, b""), (_MEMBER, b"{")):
        if found := pattern.match(data):
            return begin + data[found.end() :], found[1].decode()
    return data, None


def fault(data: bytes) -> str | None:
    """What is wrong with a file's checksum, if anything is."""
    content, digest = parts(data)
    if digest is None:
        return "has no checksum: it was cut off or edited, or an earlier version of nppg wrote it"
    return None if sha256(content) == digest else "was damaged or edited: its checksum is another"


def opened(
    path: Path, read: Callable[[bytes], Read], edited: bool | None = None, hint: Callable[[], str] = str
) -> Read:
    """What is read from a file's content, which is all but its checksum. Raises NppgError where the file cannot be
    read, or is not as it was signed, unless it is said to be `edited`; None: that cannot be said of it. What `read`
    raises of a file without a checksum comes first; `hint` is told with what to do."""
    data = contents(path)
    content, digest = parts(data)
    wrong = None if edited else fault(data)
    if wrong is None or digest is None:
        found = read(content)
    if wrong:
        or_so = "" if edited is None else ", or --edited (edited=True)"
        raise told(path, f"{wrong}; {hint()}where it is meant to be as it is: nppg sign {path}{or_so}")
    return found


def object_in(path: Path, content: bytes, member: str, wrong: str) -> dict[str, Any]:
    """The object of JSON that a file's content is, which has this member. Raises NppgError, which says `wrong`."""
    try:
        found = json.loads(content)
    except (ValueError, RecursionError):
        found = None
    if not isinstance(found, dict) or member not in found:
        raise told(path, wrong)
    return found


def contents(path: Path) -> bytes:
    """Those of a file. Raises NppgError."""
    try:
        return path.read_bytes()
    except OSError as error:
        raise told(path, f"cannot be read: {error.strerror}") from None


def is_whole(path: Path) -> bool:
    """Whether a file is there as it was signed."""
    try:
        return fault(path.read_bytes()) is None
    except OSError:
        return False


def content_hash(path: Path) -> str:
    """SHA-256 of what a file has besides its checksum, in hexadecimal."""
    return sha256(parts(path.read_bytes())[0])


def told(path: Path, message: str) -> NppgError:
    """A mistake in a file."""
    return NppgError([Problem(str(path), 0, 0, message)])
