"""Normal forms of queries, of each shape once, whatever its variables are called.

A *component* of a query without redundant literals has a number, the same for all that differ by the names of
existential variables and by order. The key of a query is the set of the numbers of its components: two queries are
θ-equivalent exactly if their keys are equal. The key of two parts without a common existential variable is the union of
their keys, unless a substitution may map a literal of the one to one of the other: where terms stand tells that.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from typing import NamedTuple

from nppg.logic.query import OPEN, Literal, Query, Term, Var, components, exact, substitute, variables
from nppg.logic.subsumption import canonical, may_map, places_of, simplified, subsumes

_MEMORY = 100_000  # queries whose forms are remembered
_ARITY = 1000  # more than any
Numbers = frozenset[int]


@dataclass(frozen=True, slots=True)
class Form:
    """What is known of all queries of one shape.

    `test` is the query without equalities about existential variables and without redundant literals, `key` as above.
    `patterns` are those of its literals: a literal with all existential variables taken for one."""

    test: Query
    key: Numbers
    patterns: Numbers


class _Code(NamedTuple):
    """Of a literal: the numbers of its pattern and of all more general ones, and its existential variables with numbers
    that stand for the pattern and the place in it."""

    general: tuple[int, ...]
    places: tuple[tuple[Term, int], ...]


class Forms:
    """The forms of queries under `roots` root variables."""

    def __init__(self, roots: int):
        self.roots = roots
        self._by_query: dict[Query, Form | None] = {}
        self._by_key: dict[Numbers, Form] = {}
        self._components: dict[Hashable, int] = {}
        self._codes: dict[Literal, _Code] = {}
        self._patterns: dict[tuple, int] = {}

    def __reduce__(self) -> tuple:
        return Forms, (self.roots,)  # what is remembered is not for other processes

    def of(self, query: Query, core: Callable[[], Query | None] = lambda: None) -> Form | None:
        """That of a query; None where it cannot be true. Those of equivalent queries have the same test, the same
        tuple.

        `core` is asked where the form is not known: it may tell a component without redundant literals, equalities and
        bounds to which the query, a component itself, is equivalent."""
        if query in self._by_query:
            return self._by_query[query]
        shape = substitute(query, self._names(query))
        if shape in self._by_query:
            form = self._by_query[shape]
        elif (found := core()) is None:
            form = self._of_any(shape)
        else:
            form = self._form(shape, [shape]) if found == query else self.of(found)
        self._remember(shape, form)
        self._remember(query, form)
        return form

    def deciding_tests(self, query: Query, literals: Query) -> tuple[Query, ...]:
        """The tests that all hold exactly if `query` still does when `literals` are added to it. Raises ValueError
        where the literals contradict the query."""
        parts = components(query + literals, self.roots)
        forms = [self.of(part) for part in parts if any(each in literals for each in part)]
        if None in forms:
            raise ValueError("the tests contradict each other")
        return tuple(form.test for form in forms if form is not None)

    def patterns(self, query: Iterable[Literal]) -> Numbers:
        """Those of a query's literals."""
        return frozenset([self._code(literal).general[0] for literal in query])

    def general(self, query: Iterable[Literal]) -> Numbers:
        """The patterns of a query's literals, and all more general ones."""
        return frozenset([number for literal in query for number in self._code(literal).general])

    def is_plain(self, query: Query) -> bool:
        """Whether it has no redundant literals, no equalities and no bounds."""
        form = self.of(query)
        return form is not None and len(form.test) == len(query) and not any(map(_is_built_in, query))

    def _names(self, query: Query) -> dict[Var, Term]:
        """Names for the existential variables by the order of their occurrence; none where they have these."""
        theta: dict[Var, Term] = {}
        named = True
        for _, args in query:
            for arg in args:
                if isinstance(arg, Var) and arg.index >= self.roots and arg not in theta:
                    theta[arg] = Var(self.roots + len(theta))
                    named = named and theta[arg] == arg
        return {} if named else theta

    def _remember(self, query: Query, form: Form | None) -> None:
        if len(self._by_query) >= _MEMORY:
            self._by_query.clear()
        self._by_query[query] = form

    def _of_any(self, query: Query) -> Form | None:
        test = simplified(query, self.roots)
        if test is None:
            return None
        test = substitute(test, self._names(test))
        return self._form(test, components(test, self.roots))

    def _form(self, test: Query, parts: list[Query]) -> Form:
        """That of a query without redundant literals, with its components."""
        key = frozenset([self._component(part) for part in parts])
        form = self._by_key.get(key)
        if form is None:
            form = self._by_key[key] = Form(test, key, self.patterns(test))
        return form

    def _component(self, part: Query) -> int:
        """Its number. Variables are told apart by where they stand; where that is not enough, or there are bounds, by
        the canonical form."""
        codes = [self._code(literal) for literal in part]
        places: dict[Term, list[int]] = {}
        for _, own in codes:
            for var, place in own:
                places.setdefault(var, []).append(place)
        signs = sorted((sorted(own), var) for var, own in places.items())
        apart = all(one[0] != other[0] for one, other in pairwise(signs))
        if apart and not any(map(_is_built_in, part)):
            ranks = {var: rank for rank, (_, var) in enumerate(signs)}
            name: Hashable = frozenset([(general[0], *[ranks[var] for var, _ in own]) for general, own in codes])
        else:
            name = frozenset(canonical(part, self.roots))
        return self._components.setdefault(name, len(self._components))

    def _code(self, literal: Literal) -> _Code:
        if literal.name in OPEN:
            literal = Literal(literal.name, literal.args[:1])
        try:
            return self._codes[literal]
        except KeyError:
            pass
        terms = literal.args
        outside = [self._outside(term) for term in terms]
        choices = product(*((None,) if term is None else (term, None) for term in outside))
        general = tuple(self._patterns.setdefault((literal.name, *each), len(self._patterns)) for each in choices)
        places = tuple((terms[i], _ARITY * general[0] + i) for i, term in enumerate(outside) if term is None)
        code = self._codes[literal] = _Code(general, places)
        return code

    def _outside(self, term: Term) -> object:
        """A term as it is whatever existential variables are called, and to be told from constants equal to Python."""
        if isinstance(term, Var):
            return None if term.index >= self.roots else term
        return exact(term)


def _is_built_in(literal: Literal) -> bool:
    return literal.name == "=" or literal.name in OPEN


@dataclass(frozen=True, slots=True)
class _Part:
    """What of a query comes to be one component with literals that extend it, and its `others`, of the form `rest`."""

    query: Query
    is_plain: bool
    others: Query
    rest: Form


class Given:
    """A query that is extended. Its `form` is None where it cannot be true."""

    def __init__(self, query: Query, forms: Forms):
        self.query = query
        self.form = forms.of(query)
        self._forms = forms
        self._first = max([forms.roots, *(var.index + 1 for var in variables(query))])  # from here on are new variables
        self._has_equalities = any(name == "=" for name, _ in query)
        self._places = places_of(query)
        parts = components(query, forms.roots)
        self._number = {literal: i for i, part in enumerate(parts) for literal in part}
        numbered = self._number.items()
        self._number_of = {var: i for each, i in numbered for var in each.variables() if var.index >= forms.roots}
        self._parts: dict[frozenset[int], _Part] = {}

    def extended(self, literals: Query) -> tuple[Query, Form, Numbers] | None:
        """With literals: what of the query comes to be one component with them, the form of this component, and the key
        of the whole; None where it cannot be true."""
        part = self._part(literals)
        own = part.query + literals
        form = self._forms.of(own, lambda: self._core(part, literals))
        if form is None:
            return None
        has_equalities = self._has_equalities or any(name == "=" for name, _ in literals)
        if has_equalities or self._meet([(one, other) for one in own for other in part.others], literals):
            whole = self._forms.of(self.query + literals)
            return (part.query, form, whole.key) if whole else None
        return part.query, form, part.rest.key | form.key

    def _part(self, literals: Query) -> _Part:
        known = self._number_of
        joined = frozenset([known[arg] for _, args in literals for arg in args if arg in known])
        found = self._parts.get(joined)
        if found is None:
            own = tuple(each for each in self.query if self._number[each] in joined)
            others = tuple(each for each in self.query if self._number[each] not in joined)
            rest = self._forms.of(others)
            assert rest is not None
            found = self._parts[joined] = _Part(own, self._forms.is_plain(own), others, rest)
        return found

    def _core(self, part: _Part, literals: Query) -> Query | None:
        """A part with literals, or without those if they are redundant; None where neither is seen at once."""
        if not part.is_plain or any(map(_is_built_in, literals)):
            return None
        pairs = [(one, other) for i, one in enumerate(literals) for other in (*part.query, *literals[:i])]
        if not self._meet(pairs, literals):
            return part.query + literals
        return part.query if subsumes(literals, part.query, self._first) else None

    def _meet(self, pairs: Sequence[tuple[Literal, Literal]], literals: Query) -> bool:
        """Whether a substitution in the query with these literals may map one of such a pair of its literals to the
        other, as far as the places of terms tell."""
        pairs = [pair for pair in pairs if pair[0].name == pair[1].name]
        if not pairs:
            return False
        places = dict(self._places)
        for term, own in places_of(literals).items():
            places[term] = places.get(term, set()) | own
        roots = self._forms.roots
        return any(
            one == other or may_map(one, other, places, roots) or may_map(other, one, places, roots)
            for one, other in pairs
        )
