"""The refinement operator under θ-subsumption.

A refinement of a query adds a literal that a mode declaration allows (with lookahead, several at once),
unifies two of its variables, grounds one, or bounds one; the last three are literals of `=`, `=<` and `>=`. A
bound's threshold is OPEN: who looks at the examples closes it. No refinement is equivalent to the query itself or to
another one.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import product

from nppg.bias.declarations import Argument, Follower, Lookahead, Mode
from nppg.bias.language_bias import LanguageBias
from nppg.bias.thresholds import closed as closed
from nppg.bias.thresholds import is_open as is_open
from nppg.bias.thresholds import ranked, unranked
from nppg.errors import Problem
from nppg.logic.forms import Given
from nppg.logic.query import OPEN, Literal, Query, Term, Var, solve_equalities, substitute, tightened
from nppg.logic.subsumption import subsumes

KIND = "$action"
_MEMORY = 20_000


@dataclass(frozen=True, slots=True)
class Refinement:
    """One candidate test of a node.

    Where the node's query holds, `literals` extend it to a query that holds exactly if `test` does: the
    component that they are part of, in normal form and, but for thresholds, the same tuple whatever the order in which
    its literals were added. `prefix` is that component without them.
    """

    literals: Query
    test: Query
    prefix: Query

    @property
    def is_open(self) -> bool:
        """Whether a threshold is still to be found."""
        return is_open(self.literals[-1])

    def closed(self, limit: float) -> Refinement:
        """With the threshold that makes its test's limit this one."""
        return Refinement(closed(self.literals, limit), closed(self.test, limit), self.prefix)


class Refiner:
    """The refinements of queries under a language bias; remembers what it has computed. Warns, once, where
    max_variables leaves some out and the author has not chosen it."""

    def __init__(self, bias: LanguageBias):
        self.bias = bias
        self.root_count = len(bias.roots)
        self._forms = bias.forms
        self._by_query: dict[Query, tuple[Refinement, ...]] = {}
        self._by_core: dict[Query, tuple[tuple[Refinement, frozenset[int]], ...]] = {}
        self._choices: dict[tuple, tuple[tuple[Literal, int], ...]] = {}
        self._warned = False

    def refinements(self, query: Query) -> tuple[Refinement, ...]:
        """All refinements of an associated query, in the order of the mode declarations."""
        found = self._by_query.get(query)
        if found is None:
            core, thresholds = ranked(tightened(literal for literal in query if self._matters(literal)))
            if core not in self._by_core:
                self._by_core[core] = tuple(self._distinct(core))
            possible = self._by_core[core]
            if thresholds:
                possible = tuple((_unranked(each, thresholds), patterns) for each, patterns in possible)
            found = tuple(self._adding(possible, query))
            if any(mode.recall for mode in self.bias.modes):
                found = tuple(each for each in found if self._recalled(query, each.literals))
            if len(self._by_query) >= _MEMORY:
                self._by_query.clear()
            self._by_query[query] = found
        return found

    def allows(self, query: Query) -> bool:
        """Whether some mode declaration allows each literal of a query behind those before it."""
        return all(
            literal.name == KIND
            or any(self._is_instance(literal, mode, self._typed_variables(query[:i])) for mode in self.bias.modes)
            for i, literal in enumerate(query)
        )

    def _is_instance(self, literal: Literal, mode: Mode, types: dict[Var, str]) -> bool:
        def fits(term: Term, arg: Argument) -> bool:
            if not isinstance(term, Var):
                return arg.kind == "#" and (term in arg.constants or mode.name in OPEN)
            known = term in types
            if arg.kind == "#" or (known and not self.bias.fits(types[term], arg.type)):
                return False
            return known or (arg.kind != "+" and term.index >= self.root_count)

        return (literal.name, len(literal.args)) == (mode.name, len(mode.args)) and all(
            map(fits, literal.args, mode.args)
        )

    def _recalled(self, query: Query, literals: Query) -> bool:
        """Whether no mode's recall is exceeded by the literals behind a query."""

        def of_mode(literal: Literal, mode: Mode) -> bool:
            return (literal.name, len(literal.args)) == (mode.name, len(mode.args)) and all(
                isinstance(term, Var) if arg.kind != "#" else term in arg.constants
                for term, arg in zip(literal.args, mode.args, strict=True)
            )

        for i, literal in enumerate(literals):
            before = (*query, *literals[:i])
            own = [mode for mode in self.bias.modes if of_mode(literal, mode)]
            counts = [sum(of_mode(each, mode) for each in before) if mode.recall else -1 for mode in own]
            if own and all(count >= mode.recall for mode, count in zip(own, counts, strict=True)):
                return False
        return True

    def _matters(self, literal: Literal) -> bool:
        """Whether what can be added depends on the literal."""
        return literal.name in ("=", KIND) or self._is_existential(literal)

    def _is_existential(self, literal: Literal) -> bool:
        return any(var.index >= self.root_count for var in literal.variables())

    def _adding(self, candidates: Iterable[tuple[Refinement, frozenset[int]]], query: Query) -> Iterator[Refinement]:
        """Those that make the query more special: whose test does not θ-subsume it already."""
        theta, _ = solve_equalities(query, self.root_count)
        given = substitute((literal for literal in query if literal.name != "="), theta)
        general = self._forms.general(given)
        equal = {var: term for var, term in theta.items() if var.index < self.root_count}
        for each, patterns in candidates:
            test = each.test
            if equal:
                test = substitute(test, equal)
                patterns = self._forms.patterns(test)
            if not (patterns <= general and subsumes(test, given, self.root_count)):
                yield each

    def _distinct(self, core: Query) -> Iterator[tuple[Refinement, frozenset[int]]]:
        """The extensions of a query as refinements, with the patterns of their tests; the first of those that are
        equivalent."""
        given = Given(tuple(literal for literal in core if literal.name != KIND), self._forms)
        if given.form is None:
            return
        seen = {given.form.key}
        for literals in self.extensions(core):
            found = given.extended(literals)
            if found and found[-1] not in seen:
                prefix, form, key = found
                seen.add(key)
                yield Refinement(literals, form.test, prefix), form.patterns

    def extensions(self, core: Query) -> Iterator[Query]:
        """What the modes allow to add to a query, those that are equivalent to others among it."""
        kinds = self.bias.actions
        asked = [literal.args[0] for literal in core if literal.name == KIND]
        if len(kinds) > 1 and not asked:
            yield from ((Literal(KIND, (kind,)),) for kind in range(len(kinds)))
        types = self._typed_variables(core)
        for literal, steps in self._possible(types):
            yield (literal,)
            yield from self._lookahead((literal,), types, steps)
            yield from self._templated((literal,), types, self.bias.max_lookahead)

    def _lookahead(self, literals: Query, types: dict[Var, str], steps: int) -> Iterator[Query]:
        """The literals with up to `steps` more behind them, each about a variable that they introduce."""
        new = frozenset(var for literal in literals for var in literal.variables() if var not in types)
        if steps == 0 or not new:
            return
        for literal, _ in self._possible(self._with_types(types, literals), new):
            if literal not in literals:
                yield (*literals, literal)
                if not is_open(literal):  # one threshold at a time
                    yield from self._lookahead((*literals, literal), types, steps - 1)

    def _templated(self, literals: Query, types: dict[Var, str], steps: int) -> Iterator[Query]:
        """The literals with what lookahead templates add behind the last one, up to `steps` times."""
        last = literals[-1]
        for each in self.bias.lookaheads if steps else ():
            if _is_behind(each, last):
                for extended in self._following(each.followers, literals, last.args, types):
                    yield extended
                    yield from self._templated(extended, types, steps - 1)

    def _following(
        self, followers: tuple[Follower, ...], literals: Query, places: tuple[Term, ...], types: dict[Var, str]
    ) -> Iterator[Query]:
        if not followers:
            yield literals
            return
        for literal in self._literals(followers[0], self._with_types(types, literals), places):
            if literal not in literals:
                yield from self._following(followers[1:], (*literals, literal), (*places, *literal.args), types)

    def _possible(self, types: dict[Var, str], new: frozenset[Var] = frozenset()) -> tuple[tuple[Literal, int], ...]:
        """What the modes allow behind these variables, with how many literals it may look ahead. With `new` ones, what
        is about one of them; else bounds come first: no new variable where there is one."""
        key = *types.items(), new
        found = self._choices.get(key)
        if found is None:
            modes = self.bias.modes if new else sorted(self.bias.modes, key=lambda mode: mode.name not in OPEN)
            found = self._choices[key] = tuple(
                (literal, min(mode.lookahead, self.bias.max_lookahead))
                for mode in modes
                for literal in self._literals(mode, types)
                if not new or not new.isdisjoint(literal.variables())
            )
        return found

    def _typed_variables(self, core: Query) -> dict[Var, str]:
        """The variables that a literal may use. The arguments of an action are there once its kind is known."""
        kinds = self.bias.actions
        known = [literal.args[0] for literal in core if literal.name == KIND] if len(kinds) > 1 else [0]
        types: dict[Var, str] = {}
        for kind, start in enumerate(self.bias.offsets):
            length = len(kinds[kind].types) if kind < len(kinds) else len(self.bias.roots) - start
            if kind in known or kind == len(kinds):
                types |= {Var(start + i): self.bias.roots[start + i] for i in range(length)}
        return self._with_types(types, core)

    def _with_types(self, types: dict[Var, str], literals: Query) -> dict[Var, str]:
        """Adds the existential variables with the types of the places that introduce them."""
        types = dict(types)
        for name, args in literals:
            for arg, type_ in zip(args, self.bias.types_of(name, len(args)) or (), strict=False):
                if isinstance(arg, Var) and arg.index >= self.root_count:
                    types.setdefault(arg, type_)
        return types

    def _literals(
        self, mode: Mode | Follower, types: dict[Var, str], places: tuple[Term, ...] = ()
    ) -> Iterator[Literal]:
        """What one mode declaration allows, or a literal of a template, in which numbers are about `places`; no literal
        takes a variable twice."""
        first = max([self.root_count - 1, *(var.index for var in types)]) + 1
        room = self.bias.max_variables - (first - self.root_count)
        choices: list[list[Term | None]] = []
        for arg in mode.args:
            if isinstance(arg, int):
                choices.append([places[arg]])
                continue
            if arg.kind == "#":
                choices.append(list(arg.constants))
                continue
            old: list[Term | None] = [var for var, type_ in types.items() if self.bias.fits(type_, arg.type)]
            by_kind: dict[str, list[Term | None]] = {"+": old, "-": [None], "+-": [*old, None]}
            choices.append(by_kind[arg.kind])
        for choice in product(*choices):
            fresh = iter(range(first, first + len(choice)))
            args = tuple(Var(next(fresh)) if term is None else term for term in choice)
            taken = [arg for arg in args if isinstance(arg, Var)]
            if len(set(taken)) < len(taken):
                continue
            if choice.count(None) <= room:
                yield Literal(mode.name, args)
            elif self.bias.is_default_maximum and not self._warned:
                self._warned = True
                warnings.warn(_cut_short(self.bias), stacklevel=2)


def _is_behind(template: Lookahead, literal: Literal) -> bool:
    return (literal.name, len(literal.args)) == (template.name, len(template.given)) and all(
        given is None or (given == term and type(given) is type(term))
        for given, term in zip(template.given, literal.args, strict=True)
    )


def _cut_short(bias: LanguageBias) -> str:
    most = bias.max_variables
    told = f"tests are left out, since max_variables is {most} unless given: give more, or {most} to stay with it"
    return str(Problem(bias.file, 0, 0, told))


def _unranked(refinement: Refinement, thresholds: list[float]) -> Refinement:
    """With the thresholds in place of their ranks."""
    test, prefix = unranked(refinement.test, thresholds), unranked(refinement.prefix, thresholds)
    return Refinement(refinement.literals, test, prefix)
