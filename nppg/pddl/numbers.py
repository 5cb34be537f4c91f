"""The numbers of PDDL: whole, decimal, and the fractions that probabilities may be."""

from __future__ import annotations

import math
import re
from fractions import Fraction

from nppg.pddl.model import Number

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?")
_LONGEST = 400  # digits; more are no number that is meant


def number(text: str) -> Number | None:
    """The finite number that a text is, a whole one as an int; None where it is none."""
    if len(text) > _LONGEST or not text.isascii() or not _NUMBER.fullmatch(text):
        return None
    if text.lstrip("+-").isdigit():
        return int(text)
    value = float(text)
    return value if math.isfinite(value) else None


def probability(text: str) -> Fraction | None:
    """The exact value of a number or of a fraction like 1/3; None where the text is neither."""
    above, slash, below = text.partition("/")
    if slash:
        whole = above.isascii() and below.isascii() and above.isdigit() and below.isdigit()
        if not whole or len(text) > _LONGEST or not int(below):
            return None
        return Fraction(int(above), int(below))
    value = number(text)
    return Fraction(text) if value else None if value is None else Fraction(0)


def plain(value: Fraction) -> Number:
    """The value as an int where it is whole, else as a float."""
    return int(value) if value.denominator == 1 else float(value)
