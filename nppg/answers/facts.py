"""Tests that can be read off the facts of a state, without asking Prolog.

They are about the kind of an action, about its arguments alone, or about one fluent, whose facts are the state's own:
`obs(2, X), X =< 0.31`. A fluent may have several bounds. The answers are those that Prolog gives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import partial

import numpy as np

from nppg.answers.comparing import NO_NUMBER, at_mode, mode_of
from nppg.answers.table import Table
from nppg.bias.declarations import Mode
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, is_open
from nppg.bridge.prolog import exclusively
from nppg.bridge.terms import Ground, plain
from nppg.errors import NppgError, Problem
from nppg.logic.query import OPEN, Literal, Query, Term, Var, exact
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State

_MEMORY = 1000  # lists of actions whose answers are remembered
_KIND = -1  # a root variable of its own

Roots = dict[int, Ground]  # what root variables are bound to
Shape = tuple[str, int, tuple[int, ...]]  # of a literal: name, arity, and the places of what is bound before
Facts = dict[tuple, list[tuple]]  # the arguments of a state's facts, by shape and what stands in its places
Reader = Callable[[Facts, Roots], float]
Least = Callable[[Sequence[tuple]], float]


def suffices(tests: Iterable[Query], domain: Domain, bias: LanguageBias) -> bool:
    """Whether a FactTable can answer these tests and whatever refinements of them the bias allows."""
    fresh = {arg.type for mode in bias.modes for arg in mode.args if "-" in arg.kind}
    met = [
        mode.name
        for mode in bias.modes
        for arg in mode.args
        for type_ in fresh
        if "+" in arg.kind and bias.fits(type_, arg.type)
    ]
    apart = all(name in OPEN for name in met)
    return bias.goal is None and apart and all(_is_readable(test, domain, bias) for test in tests)


def _is_readable(test: Query, domain: Domain, bias: LanguageBias) -> bool:
    own = [each for each in test if each.name not in OPEN]
    existential = [arg for each in own for arg in each.args if isinstance(arg, Var) and arg.index >= len(bias.roots)]
    bounded = [each.args[0] for each in test if each.name in OPEN]
    return (
        len(own) + (not own) * len(bounded) == 1
        and len(set(existential)) == len(existential)
        and (not own or set(bounded) <= set(existential))
        and all(each.name in (KIND, "=") or (each.name, len(each.args)) in domain.fluents for each in own)
    )


@exclusively("answers")
class FactTable(Table):
    """Tests for which this `suffices`."""

    def __init__(self, domain: Domain, bias: LanguageBias):
        super().__init__(domain, bias)
        self._shapes: dict[tuple[str, int], list[Shape]] = {}  # by name and arity
        self._of_state: dict[tuple, list[tuple[int, Least]]] = {}  # by key: columns, and how they are read
        self._unmet: dict[int, float] = {}  # columns that hang on the state alone, with the answer where nothing holds
        self._readers: dict[str, list[tuple[int, Reader]]] = {"action": [], "both": []}
        self._known: dict[object, np.ndarray] = {}  # answers that hang on the actions alone

    def _prepare(self, columns: Sequence[int]) -> None:
        self._known.clear()
        for column in columns:
            test = self.tests[column]
            bounds = [(each, mode_of(each, test, self.bias)) for each in test if each.name in OPEN]
            literal = next((each for each in test if each.name not in OPEN), None)
            if literal is None or literal.name in (KIND, "="):
                reader = partial(self._of_action, test[0], bounds[0][1] if bounds else None)
                self._readers["action"].append((column, reader))
                continue
            places = [i for i, arg in enumerate(literal.args) if not self._is_existential(arg)]
            shape = (literal.name, len(literal.args), tuple(places))
            known = self._shapes.setdefault(shape[:2], [])
            known += [] if shape in known else [shape]
            least = self._least(literal, bounds)
            if any(isinstance(literal.args[i], Var) for i in places):
                self._readers["both"].append((column, partial(self._of_fluent, shape, literal, least)))
                continue
            self._of_state.setdefault(_key(shape, literal.args), []).append((column, least))
            self._unmet[column] = least(())

    def _is_existential(self, term: Term) -> bool:
        return isinstance(term, Var) and term.index >= len(self.bias.roots)

    def _of_action(self, literal: Literal, mode: Mode | None, _: Facts, roots: Roots) -> float:
        if literal.name in OPEN:
            value = _value(literal.args[0], roots)
            return np.inf if value is None else _sign(literal) * self._number(value, "action/1", mode)
        if literal.name == KIND:
            return float(roots[_KIND] != literal.args[0])
        left, right = (_value(arg, roots) for arg in literal.args)
        return float(left is None or right is None or exact(left) != exact(right))

    def _of_fluent(self, shape: Shape, literal: Literal, least: Least, facts: Facts, roots: Roots) -> float:
        return least(facts.get(_key(shape, [_value(arg, roots) for arg in literal.args]), ()))

    def _least(self, literal: Literal, bounds: Sequence[tuple[Literal, Mode | None]]) -> Least:
        """What the facts that match a literal answer: the least number among those within the closed bounds."""
        source = f"{literal.name}/{len(literal.args)}"
        places = [(literal.args.index(each.args[0]), _sign(each), each, mode) for each, mode in bounds]
        closed = [
            (place, sign, sign * float(each.args[1]), mode)  # type: ignore[arg-type]
            for place, sign, each, mode in places
            if not is_open(each)
        ]
        measured = next(((place, sign, mode) for place, sign, each, mode in places if is_open(each)), None)

        def least(found: Sequence[tuple]) -> float:
            for place, sign, limit, mode in closed:
                found = [args for args in found if sign * self._number(args[place], source, mode) <= limit]
            if measured is None:
                return 0.0 if found else 1.0
            place, sign, mode = measured
            return min([sign * self._number(args[place], source, mode) for args in found], default=np.inf)

        return least

    def _number(self, value: Ground, source: str, mode: Mode | None) -> float:
        if isinstance(value, int | float) and not isinstance(value, bool) and value == value:
            try:
                return float(value)
            except OverflowError:
                return np.inf if value > 0 else -np.inf
        message = f"{source} gave {value}, {NO_NUMBER}"
        problem = Problem(str(self.domain.path), 0, 0, message)
        raise NppgError([at_mode(problem, mode, self.bias) if mode else problem])

    def answers(self, state: State, actions: Sequence[Action]) -> np.ndarray:
        actions = plain(actions)
        numbers = np.empty((len(actions), len(self)))
        facts = self._by_shape(self.domain.interpreted(state).facts)
        numbers[:, list(self._unmet)] = self._about_state(facts)
        if self._readers["action"]:
            numbers[:, [column for column, _ in self._readers["action"]]] = self._of_actions(tuple(actions))
        for column, read in self._readers["both"]:
            numbers[:, column] = [read(facts, self._roots(action)) for action in actions]
        return numbers if self.numeric else numbers == 0

    def _about_state(self, facts: Facts) -> list[float]:
        found = dict(self._unmet)
        for key, all_args in facts.items():
            for column, least in self._of_state.get(key, ()):
                found[column] = least(all_args)
        return list(found.values())

    def _by_shape(self, state: Iterable[Ground]) -> Facts:
        facts: Facts = {}
        for fact in state:
            name, args = (fact[0], fact[1:]) if isinstance(fact, tuple) else (fact, ())
            for shape in self._shapes.get((str(name), len(args)), ()):
                facts.setdefault(_key(shape, args), []).append(args)
        return facts

    def _of_actions(self, actions: tuple[Action, ...]) -> np.ndarray:
        key = exact(actions)
        if key not in self._known:
            if len(self._known) >= _MEMORY:
                self._known.clear()
            readers = self._readers["action"]
            self._known[key] = np.array([[read({}, self._roots(each)) for _, read in readers] for each in actions])
        return self._known[key]

    def _roots(self, action: Action) -> Roots:
        name, *args = action if isinstance(action, tuple) else (action,)
        for kind, template in enumerate(self.bias.actions):
            if (template.name, len(template.types)) == (name, len(args)):
                return {self.bias.offsets[kind] + i: arg for i, arg in enumerate(args)} | {_KIND: kind}
        message = f"gave {action}, for which the language bias has no action template"
        raise NppgError([Problem(str(self.domain.path), 0, 0, message)])


def _value(term: Term, roots: Roots) -> Ground | None:
    """None for an argument that actions of this kind do not have."""
    return roots.get(term.index) if isinstance(term, Var) else term


def _sign(bound: Literal) -> float:
    return 1.0 if bound.name == "=<" else -1.0


def _key(shape: Shape, args: Sequence) -> tuple:
    """What stands in the places of a shape."""
    return (shape, *[exact(args[i]) for i in shape[2]])
