"""Modes as terms of Prolog have them, ACE's and Aleph's: rmode, warmode, modeb, lookahead, generators of constants."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import count

from nppg.bias.declarations import ANY, Argument, Follower, Lookahead, Mode
from nppg.bridge.terms import Ground
from nppg.errors import Problem
from nppg.logic.query import OPEN, Constant, constant
from nppg.tilde.program import Clause
from nppg.tilde.terms import (
    Indicator,
    arguments,
    elements,
    indicator,
    is_variable,
    number,
    parts,
    told,
)

_MODES = {"+": "+", "-": "-", "+-": "+-", "#": "#", "-#": "#", "+#": "#", "+-#": "#", "+\\": "+", "-\\": "-"}
_BOUNDS = {(name, 2) for name in OPEN}
_MOST_MODES = 2000  # of one generator of several constants at once

Constants = Callable[[Ground, Ground, Clause], list[tuple[Ground, ...]]]  # variables, generator: their values


class Unsupported(Exception):
    """What a declaration has that cannot be carried over."""


@dataclass
class Language:
    """What the declarations of a settings file come to."""

    types: dict[Indicator, tuple[str, ...]]
    constants: Constants
    left_out: list[Problem]
    modes: list[Mode] = field(default_factory=list)
    lookaheads: list[Lookahead] = field(default_factory=list)
    looking: dict[Indicator, int] = field(default_factory=dict)  # auto_lookahead
    clause: Clause | None = None  # the one that is being taken

    def declare(self, clause: Clause) -> None:
        """Takes an rmode, warmode, lookahead or auto_lookahead; what cannot be carried over is told."""
        self.clause = clause
        try:
            name, args = clause.predicate[0], arguments(clause.data)
            if name in ("rmode", "warmode"):
                for each in args[:1]:
                    self._mode(each, clause)
            elif name == "lookahead":
                self._lookahead(*args)
            else:
                self.looking[indicator(args[0])] = 1
        except Unsupported as error:
            shown = clause.text if clause.kind == "directive" and clause.text else told(clause.data)
            self.left_out.append(clause.problem(f"{shown} is left out: {error}"))

    def _mode(self, data: Ground, clause: Clause) -> None:
        recall = 0
        if indicator(data) == (":", 2):
            times, data = arguments(data)
            recall = times if isinstance(times, int) else 0
        if indicator(data) == ("#", 2):
            generator, data = arguments(data)
            if indicator(generator) != (":", 2):
                raise Unsupported("a generator is written #(Variables: Generator, Literal)")
            spec, generator = arguments(generator)
            if indicator(spec) == ("*", 2):  # 10*3*C: how many at most
                spec = arguments(spec)[1]
            self._generated(spec, generator, data, recall, clause)
        else:
            self._conjunction(data, recall, clause, {})

    def _generated(self, spec: Ground, generator: Ground, data: Ground, recall: int, clause: Clause) -> None:
        """A mode for each tuple of constants; where there is one constant alone, one mode for all."""
        variables = elements(spec) or parts(spec)
        values = self.constants(("[]", *variables), generator, clause)
        if not values:
            raise Unsupported(f"{told(generator)} gives no constants")
        if len(variables) == 1:
            each = [value for (value,) in values]
            self._conjunction(data, recall, clause, {number(variables[0]): each})
            return
        if len(values) > _MOST_MODES:
            raise Unsupported(f"{told(generator)} gives {len(values):,} tuples of constants, more than {_MOST_MODES:,}")
        for value in values:
            chosen = {number(variable): [one] for variable, one in zip(variables, value, strict=True)}
            self._conjunction(data, recall, clause, chosen)

    def _conjunction(self, data: Ground, recall: int, clause: Clause, chosen: Mapping[int, list[Ground]]) -> None:
        literals = parts(data)
        for literal in literals:
            if (not isinstance(literal, tuple) and len(literals) > 1) or is_variable(literal):
                raise Unsupported(f"{told(literal)} is no literal")
        first, *others = literals
        names = {indicator(each)[0] for each in literals} & {"\\+", "not", ";", "->"}
        if names:
            raise Unsupported(f"{names.pop()} is not tested")
        if indicator(first) in _BOUNDS and self.types.get(indicator(first), (own_type(arguments(first)[0]),))[0] == ANY:
            sign = indicator(first)[0]
            raise Unsupported(f"numbers alone can be compared: say of which type, type(number {sign} number)")
        if indicator(first) in _BOUNDS and arguments(first)[1] == "#":
            name, (bounded, _) = indicator(first)[0], arguments(first)
            type_ = self.types.get(indicator(first), (own_type(bounded),))[0]
            bound = Mode(name, (Argument("+", type_), Argument("#", type_, (OPEN[name],))), 0, clause.line, 0, recall)
            self.modes += [] if bound in self.modes else [bound]
            return
        args = [self._argument(arg, type_, chosen) for arg, type_ in self._typed(first)]
        for mode in self._spread(Mode(indicator(first)[0], tuple(args), 0, clause.line, 0, recall), clause):
            if mode not in self.modes:
                self.modes.append(mode)
        if others:
            places: dict[int, int] = {}
            at = count()
            for arg in arguments(first):
                _note(arg, next(at), places)
            given = tuple(arg.constants[0] if arg.kind == "#" and len(arg.constants) == 1 else None for arg in args)
            self._add(Lookahead(indicator(first)[0], given, self._followers(others, places, at, chosen)))

    def _lookahead(self, first: Ground, others: Ground) -> None:
        places: dict[int, int] = {}
        at = count()
        given: list[Constant | None] = []
        for arg in arguments(first):
            _note(arg, next(at), places)
            inner = arguments(arg)[0] if indicator(arg)[0] in _MODES and len(arguments(arg)) == 1 else arg
            given.append(None if isinstance(inner, tuple) or inner in _MODES else _constant(inner))
        self._add(Lookahead(indicator(first)[0], tuple(given), self._followers(parts(others), places, at, {})))

    def _add(self, lookahead: Lookahead) -> None:
        if lookahead not in self.lookaheads:
            self.lookaheads.append(lookahead)

    def _followers(
        self, literals: list[Ground], places: dict[int, int], at: Iterator[int], chosen: Mapping[int, list[Ground]]
    ) -> tuple[Follower, ...]:
        found = []
        for literal in literals:
            args: list[int | Argument] = []
            for arg, type_ in self._typed(literal):
                place = next(at)
                inner = arguments(arg)[0] if indicator(arg)[0] in _MODES and arguments(arg) else arg
                if is_variable(inner) and number(inner) in places:
                    args.append(places[number(inner)])
                else:
                    args.append(self._argument(arg, type_, chosen))
                    _note(arg, place, places)
            found.append(Follower(indicator(literal)[0], tuple(args)))
        return tuple(found)

    def _typed(self, literal: Ground) -> list[tuple[Ground, str]]:
        """The arguments with their types: those that are declared, else those that are written in the mode."""
        args = arguments(literal)
        declared = self.types.get(indicator(literal))
        if declared is None:
            declared = tuple(map(own_type, args))
        return list(zip(args, declared, strict=True))

    def _argument(self, arg: Ground, type_: str, chosen: Mapping[int, list[Ground]]) -> Argument:
        name, args = indicator(arg)[0], arguments(arg)
        if is_variable(arg):
            if number(arg) in chosen:
                return Argument("#", type_, self._constants(chosen[number(arg)]))
            return Argument("-", type_)
        if name in _MODES and not args:
            return Argument(_MODES[name], type_)
        if (several := elements(arg)) is not None:
            return Argument("#", type_, self._constants(several))
        if name in _MODES and len(args) == 1:
            inner = args[0]
            if name == "#" and (listed := elements(inner)) is not None:
                return Argument("#", type_, self._constants(listed))
            if isinstance(inner, tuple) and indicator(inner)[0] in _MODES and not is_variable(inner):  # + - X
                both = {name, indicator(inner)[0]}
                return Argument("#" if "#" in both else "+-" if both == {"+", "-"} else _MODES[name], type_)
            if is_variable(inner) and number(inner) in chosen:
                return Argument("#", type_, self._constants(chosen[number(inner)]))
            return Argument(_MODES[name], type_)
        return Argument("#", type_, (_constant(arg),))

    def _constants(self, data: list[Ground]) -> tuple[Constant, ...]:
        """Those among the terms; others are told."""
        others = [each for each in data if isinstance(each, tuple)]
        if others and self.clause:
            what = f"the constant {told(others[0])} is left out: it is a compound term"
            self.left_out.append(self.clause.problem(what))
        return tuple(dict.fromkeys(constant(each) for each in data if not isinstance(each, tuple)))

    def _spread(self, mode: Mode, clause: Clause) -> list[Mode]:
        """Equality is between variables of one type each: a mode for every type, where none is given."""
        if mode.name != "=" or len(mode.args) != 2:
            return [mode]
        if any(arg.kind in ("-", "+-") for arg in mode.args):
            mode = replace(mode, args=tuple(a if a.kind == "#" else Argument("+", a.type) for a in mode.args))
        if all(arg.type != ANY for arg in mode.args):
            return [mode]
        every = dict.fromkeys(type_ for types in self.types.values() for type_ in types if type_ != ANY) or {ANY: None}
        return [replace(mode, args=tuple(Argument(a.kind, type_, a.constants) for a in mode.args)) for type_ in every]


def own_type(arg: Ground) -> str:
    """The type that a mode's argument names itself: +train."""
    inner = arguments(arg)[0] if indicator(arg)[0] in _MODES and len(arguments(arg)) == 1 else None
    return inner if isinstance(inner, str) and inner not in _MODES else ANY


def type_declared(data: Ground) -> tuple[Indicator, tuple[str, ...]]:
    """What type(p(a, b)) declares; a variable is any type."""
    literal = arguments(data)[0]
    types = tuple(str(arg) if isinstance(arg, str | int) else ANY for arg in arguments(literal))
    return indicator(literal), types


def _note(arg: Ground, place: int, places: dict[int, int]) -> None:
    """Notes the place at which a template's variable is first met."""
    inner = arguments(arg)[0] if indicator(arg)[0] in _MODES and len(arguments(arg)) == 1 else arg
    if is_variable(inner):
        places.setdefault(number(inner), place)


def _constant(data: Ground) -> Constant:
    if isinstance(data, tuple):
        raise Unsupported(f"{told(data)} is no constant: that is a name or a number")
    return constant(data)
