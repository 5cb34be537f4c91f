"""Names, as Prolog reads and writes them, and numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence

from nppg.logic.query import Constant


def is_name(text: str) -> bool:
    """Whether Prolog reads the text as an atom without quotes."""
    return bool(re.fullmatch(r"[^\W\d_]\w*", text)) and not text[0].isupper() and not text[0].istitle()


def written(constant: Constant) -> str:
    """As a literal has it, in quotes where it needs them."""
    if not isinstance(constant, str):
        return repr(constant)
    if is_name(constant):
        return constant
    return "'" + constant.replace("\\", "\\\\").replace("'", "''") + "'"


def atom(name: str, args: Sequence[object]) -> str:
    """The text `name(arg, ...)`."""
    return f"{name}({', '.join(map(str, args))})" if args else name


def number(text: str) -> int | float | None:
    """The number that a text is, None where it is none."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return None
