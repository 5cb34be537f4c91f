"""The laws of the refinement operator, on random paths down a tree."""

from __future__ import annotations

import os
import subprocess
import sys
import warnings
from itertools import combinations
from random import Random

import pytest
from samples import random_query

from benchmarks.refinement import plainly
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND, Refinement, Refiner, is_open
from nppg.logic.query import OPEN, Literal, Query, Var, variables
from nppg.logic.subsumption import normal_form, subsumes

SMALL = """
action: move(+block, +place)
subtypes: {block: place}
types: {clear: [block], on: [block, place]}
modes: [clear(+), "on(+, +-)", "on(+, floor)", "equal(+place, +block)"]
max_variables: 2
"""
DEEP = """
action: move(+block, +place)
lookahead: 2
max_variables: 3
subtypes: {block: place}
types: {clear: [place], on: [place, place], above: [place, place]}
modes:
  - clear(+)
  - literal: on(+, -)
    lookahead: 1
  - literal: above(-, +)
    lookahead: 2
  - above(+, +)
  - equal(+place, +place)
"""


def form(query: Query, refiner: Refiner) -> frozenset[Literal]:
    found = normal_form(query, refiner.root_count)
    assert found is not None
    return frozenset(found)


def new_variables(literals: Query, query: Query, refiner: Refiner) -> set[Var]:
    return {var for var in set(variables(literals)) - set(variables(query)) if var.index >= refiner.root_count}


NUMERIC = """
action: [go(+distance), lift(+item), wait]
goal: limit(-mass)
lookahead: 2
max_variables: 3
types: {near: [item, item], weight: [item, mass], red: [item]}
modes:
  - {literal: "near(+item, -item)", lookahead: 2}
  - {literal: "weight(+item, -mass)", lookahead: 2}
  - red(+)
  - "+mass =< #"
  - "+mass >= #"
  - "+distance =< #"
  - equal(+distance, [2, 3.0])
  - equal(+item, +item)
"""
OWN = {"small": SMALL, "deep": DEEP, "numeric": NUMERIC}


@pytest.fixture(scope="module", params=["plain", "relational", "delivery", *OWN])
def refiner(request) -> Refiner:
    """One for all laws, since it remembers what it has computed."""
    if request.param in OWN:
        return Refiner(LanguageBias.parse(OWN[request.param], "bias.yaml"))
    return Refiner(request.getfixturevalue(f"{request.param}_bias"))


@pytest.fixture(scope="module")
def queries(refiner: Refiner) -> list[Query]:
    return [(), *(random_query(refiner, 1 + seed % 3, Random(seed)) for seed in range(6))]


def test_a_refinement_is_more_special_than_its_query(refiner: Refiner, queries: list[Query]) -> None:
    roots = refiner.root_count
    for query in queries:
        parent = normal_form(query, roots)
        for each in refiner.refinements(query):
            child = normal_form(query + each.literals, roots)
            assert child is not None
            if not any(literal.name == "=" for literal in query + each.literals):
                assert subsumes(parent, child, roots)
            assert not subsumes(child, parent, roots), (query, each.literals)


def test_no_two_refinements_are_equivalent(refiner: Refiner, queries: list[Query]) -> None:
    for query in queries:
        forms = [form(query + each.literals, refiner) for each in refiner.refinements(query)]
        assert len(set(forms)) == len(forms), query


def test_refinements_are_those_that_normal_forms_tell_apart(refiner: Refiner, queries: list[Query]) -> None:
    """What is put together from the forms of parts is what the normal form of each whole query tells."""
    for query in queries:
        assert [each.literals for each in refiner.refinements(query)] == plainly(refiner, query)


def test_the_test_is_the_refined_component(refiner: Refiner, queries: list[Query]) -> None:
    for query in queries:
        for each in refiner.refinements(query):
            assert form(each.prefix + each.literals, refiner) == form(each.test, refiner)
            assert set(each.prefix) <= set(query)


def test_equivalent_tests_are_the_same_tuple(refiner: Refiner, queries: list[Query]) -> None:
    found: dict[frozenset[Literal], Query] = {}
    for query in queries:
        for each in refiner.refinements(query):
            if not has_threshold(each.test):
                assert found.setdefault(frozenset(each.test), each.test) is each.test


def has_threshold(query: Query) -> bool:
    return any(literal.name in OPEN and not is_open(literal) for literal in query)


def types_of(refiner: Refiner, query: Query) -> dict[Var, str]:
    """The types of the variables that literals after `query` may take, told from the bias and the query alone."""
    bias = refiner.bias
    asked = [literal.args[0] for literal in query if literal.name == KIND] or ([0] if len(bias.actions) == 1 else [])
    types = {Var(i): bias.roots[i] for i in range(bias.offsets[-1], len(bias.roots))}
    for kind in asked:
        types |= {Var(i): bias.roots[i] for i in range(bias.offsets[kind], bias.offsets[kind + 1])}
    for name, args in query:
        for arg, type_ in zip(args, bias.types.get(name, ()), strict=False):
            if isinstance(arg, Var) and arg.index >= len(bias.roots):
                types.setdefault(arg, type_)
    return types


def allowed(literal: Literal, refiner: Refiner, query: Query) -> bool:
    if literal.name == KIND:
        return len(refiner.bias.actions) > 1 and not any(each.name == KIND for each in query)
    types, bias = types_of(refiner, query), refiner.bias
    for mode in bias.modes:
        if mode.name != literal.name or len(mode.args) != len(literal.args):
            continue
        for term, arg in zip(literal.args, mode.args, strict=True):
            if arg.kind == "#":
                fits = term in arg.constants
            elif term in types:
                fits = arg.kind in ("+", "+-") and bias.fits(types[term], arg.type)
            else:
                fits = isinstance(term, Var) and term.index >= refiner.root_count and arg.kind in ("-", "+-")
            if not fits:
                break
        else:
            return True
    return False


def test_modes_and_types_are_respected(refiner: Refiner, queries: list[Query]) -> None:
    for query in queries:
        for each in refiner.refinements(query):
            before = query
            for literal in each.literals:
                assert allowed(literal, refiner, before), (query, each.literals)
                before += (literal,)


def test_nothing_that_the_modes_allow_is_missing(refiner: Refiner, queries: list[Query]) -> None:
    """Every literal over the query's variables is a refinement, or equivalent to one, or changes nothing."""
    bias = refiner.bias
    for query in queries:
        types = list(types_of(refiner, query))
        found = {form(query + each.literals, refiner) for each in refiner.refinements(query)}
        for mode in bias.modes:
            if len(mode.args) > 2 or any(arg.kind == "-" for arg in mode.args):
                continue
            constants = [each for arg in mode.args for each in arg.constants]
            terms = [*types, *constants]
            for args in [(a,) for a in terms] if len(mode.args) == 1 else [(a, b) for a in terms for b in terms]:
                literal = Literal(mode.name, args)
                fits = allowed(literal, refiner, query)
                if not fits or len(set(literal.variables())) < len(list(literal.variables())):
                    continue
                possible = normal_form((*query, literal), refiner.root_count)
                if possible is not None and frozenset(possible) != form(query, refiner):
                    assert frozenset(possible) in found, (query, literal)


def test_a_small_bias_by_hand(bias_of) -> None:
    refiner = Refiner(bias_of(SMALL))
    x, y, new = Var(0), Var(1), Var(2)
    expected = [
        ("clear", (x,)),
        ("on", (x, y)),
        ("on", (x, new)),
        ("on", (x, "floor")),
        ("=", (y, x)),
    ]
    assert [each.literals for each in refiner.refinements(())] == [(Literal(*each),) for each in expected]
    below = refiner.refinements((Literal("on", (x, new)),))
    assert (Literal("=", (new, x)),) in [each.literals for each in below]  # unifies
    assert (Literal("on", (x, "floor")),) in [each.literals for each in below]  # grounds
    # a place is no block, so nothing is on it and clear/1 does not ask about it
    assert {each.literals[0].args[0] for each in below if each.literals[0].name != "="} == {x}


def test_lookahead_is_about_new_variables_and_bounded(bias_of) -> None:
    refiner = Refiner(bias_of(DEEP))
    lengths = set()
    for seed in range(12):
        query = random_query(refiner, seed % 3, Random(seed))
        for each in refiner.refinements(query):
            first, *further = each.literals
            bound = {"on": 1, "above": 2 if isinstance(first.args[0], Var) else 0}.get(first.name, 0)
            if not new_variables((first,), query, refiner):
                bound = 0
            assert len(further) <= bound
            for i, literal in enumerate(further, 1):
                assert set(literal.variables()) & new_variables(each.literals[:i], query, refiner)
            lengths.add(len(further))
    assert lengths == {0, 1, 2}


def test_the_general_maximum_of_lookahead_bounds_every_mode(bias_of) -> None:
    with_one = Refiner(bias_of(DEEP.replace("lookahead: 2", "lookahead: 1")))
    assert max(len(each.literals) for each in with_one.refinements(())) == 2
    none = Refiner(bias_of(DEEP.replace("lookahead: 2", "lookahead: 0").replace("lookahead: 1", "lookahead: 0")))
    assert max(len(each.literals) for each in none.refinements(())) == 1


@pytest.mark.parametrize("most", [0, 1, 2])
def test_max_variables(bias_of, most: int) -> None:
    refiner = Refiner(bias_of(DEEP.replace("max_variables: 3", f"max_variables: {most}")))
    counts = set()
    for seed in range(8):
        query = random_query(refiner, 3, Random(seed))
        for each in refiner.refinements(query):
            counts.add(sum(var.index >= refiner.root_count for var in variables(query + each.literals)))
    assert max(counts) == most


def test_arguments_of_a_kind_are_asked_about_only_below_its_test(bias_of) -> None:
    refiner = Refiner(
        bias_of(
            """
action: [drive(+room), drop]
goal: wanted(-room)
types: {at: [room]}
modes: [at(+), "equal(+room, +room)"]
"""
        )
    )
    to, wanted = Var(0), Var(1)
    drive, drop = Literal(KIND, (0,)), Literal(KIND, (1,))

    def offered(query: Query) -> list[Query]:
        return [each.literals for each in refiner.refinements(query)]

    at_wanted, at_to = Literal("at", (wanted,)), Literal("at", (to,))
    assert offered(()) == [(drive,), (drop,), (at_wanted,)]
    assert offered((drive,)) == [(at_to,), (at_wanted,), (Literal("=", (to, wanted)),)]
    assert offered((drop,)) == [(at_wanted,)]
    assert offered((at_wanted,)) == [(drive,), (drop,)]


def listing(bias: LanguageBias) -> list[list[Query]]:
    refiner = Refiner(bias)
    queries = [random_query(refiner, 3, Random(seed)) for seed in range(5)]
    return [[each.literals for each in refiner.refinements(query)] for query in queries]


def test_what_thresholds_a_query_has_does_not_matter(bias_of) -> None:
    """Order alone does: refinements are computed for ranks. With every threshold shifted they are the same but for
    the shift."""
    refiner = Refiner(bias_of(NUMERIC))

    def shifted(query: Query) -> Query:
        return tuple(
            Literal(each.name, (each.args[0], 2 * each.args[1] + 1)) if has_threshold((each,)) else each
            for each in query
        )

    several = 0
    for seed in range(40):
        query = random_query(refiner, 4, Random(seed))
        several += len({each.args[1] for each in query if each.name in OPEN}) > 1
        refiner = Refiner(refiner.bias)
        for each in refiner.refinements(query):
            assert set(each.prefix) <= set(query)
            assert form(each.prefix + each.literals, refiner) == form(each.test, refiner)
            assert not any(map(is_open, each.literals[:-1]))  # one threshold at a time
        expected = [
            Refinement(each.literals, shifted(each.test), shifted(each.prefix)) for each in refiner.refinements(query)
        ]
        assert list(Refiner(refiner.bias).refinements(shifted(query))) == expected
        assert list(refiner.refinements(shifted(query))) == expected
    assert several > 5


def test_thresholds_that_are_equal_to_ranks_are_thresholds(bias_of) -> None:
    """Who reads rules asks the same forms with thresholds in the place of ranks."""

    def at_zero(query: Query) -> Query:
        return tuple(Literal(each.name, (each.args[0], 0.0)) if has_threshold((each,)) else each for each in query)

    for seed in range(10):
        bias = bias_of(NUMERIC)
        query = at_zero(random_query(Refiner(bias), 4, Random(seed)))
        expected = Refiner(bias).refinements(query)
        asked = bias_of(NUMERIC)
        for each in expected:
            asked.forms.deciding_tests(query, each.literals)
        assert [each.literals for each in Refiner(asked).refinements(query)] == [each.literals for each in expected]


def test_the_order_is_the_same_in_every_process(relational_bias: LanguageBias) -> None:
    code = (
        "from test_refinement import listing, LanguageBias; import sys;print(listing(LanguageBias.load(sys.argv[1])))"
    )
    printed = {
        subprocess.run(
            [sys.executable, "-c", code, relational_bias.file],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(sys.path)},
            capture_output=True,
            text=True,
            check=True,
        ).stdout.strip()
        for seed in ("1", "2")
    }
    assert printed == {str(listing(relational_bias))}


def test_what_has_been_remembered_is_what_would_be_computed(refiner: Refiner, queries: list[Query]) -> None:
    def literals_of(found: tuple[Refinement, ...]) -> list[Query]:
        return [each.literals for each in found]

    warm = [literals_of(refiner.refinements(query)) for query in reversed(queries)]
    cold = [literals_of(Refiner(refiner.bias).refinements(query)) for query in reversed(queries)]
    assert warm == cold
    assert all(set(a) != set(b) for a, b in combinations({tuple(each) for each in cold}, 2))


CUT = """
action: go(+x)
types: {p: [x, x]}
modes: [p(+, -)]
"""


@pytest.mark.parametrize(
    ("most", "depth", "told"),
    [("", 4, 0), ("", 5, 1), ("max_variables: 4\n", 5, 0), ("max_variables: 9\n", 9, 0)],
)
def test_what_nobody_has_bounded_is_not_cut_short_in_silence(most: str, depth: int, told: int) -> None:
    """Once, and only where the maximum leaves something out that the author has not set."""
    refiner, query = Refiner(LanguageBias.parse(CUT + most, "b.yaml")), ()
    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always")
        for _ in range(depth):
            found = refiner.refinements(query)
            query += found[-1].literals if found else ()
        refiner.refinements(query[:-1])
    message = "b.yaml: tests are left out, since max_variables is 4 unless given: give more, or 4 to stay with it"
    assert [str(each.message) for each in noted] == [message] * told
