"""Terms as data, to Prolog and from there; see prolog/terms.pl."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import chain
from math import isnan
from typing import Any

from nppg.bridge.plain import alone
from nppg.bridge.prolog import ask
from nppg.errors import NppgError
from nppg.logic.query import Query, Var

Ground = str | int | float | tuple  # a name, a number, or a tuple of a name and its arguments


class Compound(tuple):
    """A ground compound term, a tuple of its name and its arguments; `str` writes it as Prolog does: on(a, 'B c')."""

    __slots__ = ()

    def __str__(self) -> str:
        return texts([self])[0]


_ATOMS = frozenset({str, int, float})
_OWN = frozenset({str, Compound})
_FLAT = frozenset({str, Compound, tuple})


def plain(terms: Iterable[Ground]) -> list[Ground]:
    """Facts or actions that somebody has made, with Python's numbers in place of NumPy's. What nppg has made, which are
    Compounds, is not looked into. Raises NppgError for what is no term."""
    found = list(terms)
    kinds = {*map(type, found)}
    if kinds <= _OWN:
        return found
    if kinds <= _FLAT and () not in found:
        inside = {*map(type, chain.from_iterable(found))}  # type: ignore[arg-type]
        if inside == {str} or (inside <= _ATOMS and all(map(_is_plain, found))):
            return found
    return [each if _is_plain(each) else _made_plain(each) for each in found]


def _is_plain(term: Ground) -> bool:
    """Nothing recurs here, either."""
    unread = [term]
    while unread:
        each = unread.pop()
        if type(each) is float:
            if isnan(each):
                return False
        elif type(each) not in _ATOMS:
            if not isinstance(each, tuple) or not each or not isinstance(each[0], str):
                return False
            unread.extend(each)
    return True


def _made_plain(term: Any) -> Ground:
    term = alone(term)
    if isinstance(term, tuple | list) and len(term) and isinstance(term[0], str):
        return tuple(map(_made_plain, term))
    if isinstance(term, float) and isnan(term):
        raise NppgError(f"{term!r} is no number")
    if isinstance(term, str | int | float | Fraction) and not isinstance(term, bool):
        return term  # type: ignore[return-value]
    raise NppgError(f"{term!r} is no term: that is a name, a number, or a tuple of a name and its arguments")


def texts(terms: Sequence[Ground]) -> list[str]:
    """Facts or actions as Prolog writes and reads them: `on(a, 'B c')`."""
    return ask("texts", list(terms))


def compounds(data: list) -> list[Ground]:
    """Ground terms as they cross, the compound ones as Compound."""
    return [Compound(each) if isinstance(each, tuple) else each for each in ground(data)]


def ground(data: Any) -> Any:
    """A ground term as it crosses, compounds as lists, as Python keeps it, compounds as tuples. A Prolog list is as
    deep as it is long, so nothing recurs here."""
    if not isinstance(data, list):
        return data
    flat = tuple([tuple(each) if isinstance(each, list) else each for each in data])
    try:
        hash(flat)  # fails where a list is left further down, which is rare
        return flat
    except TypeError:
        pass
    whole: list = []
    open_terms = [(data, whole)]
    while True:
        term, done = open_terms[-1]
        if len(done) < len(term):
            arg = term[len(done)]
            if isinstance(arg, list):
                open_terms.append((arg, []))
            else:
                done.append(arg)
        elif len(open_terms) == 1:
            return tuple(done)
        else:
            open_terms.pop()
            open_terms[-1][1].append(tuple(done))


def encoded(query: Query) -> list:
    """A query as the data that prolog/terms.pl reads."""
    return [[name, *(arg.index if isinstance(arg, Var) else [arg] for arg in args)] for name, args in query]
