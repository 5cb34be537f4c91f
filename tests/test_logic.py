"""The laws of queries under θ-subsumption."""

from __future__ import annotations

from itertools import combinations, product
from random import Random

from hypothesis import assume, given, settings
from hypothesis import strategies as st
from samples import holds

from nppg.logic.forms import Forms, Given
from nppg.logic.query import (
    OPEN,
    Literal,
    Query,
    Var,
    components,
    implies,
    opened,
    solve_equalities,
    substitute,
    tightened,
    variables,
)
from nppg.logic.subsumption import normal_form, reduced, subsumes

ROOTS = 2
ROOT_TERMS = [Var(0), Var(1), "a", 3]
TERMS = [*ROOT_TERMS, Var(2), Var(3), Var(4)]
SIGNATURE = {"p": 1, "q": 2, "r": 2}


def literals(terms: list) -> st.SearchStrategy[Literal]:
    return st.sampled_from(sorted(SIGNATURE)).flatmap(
        lambda name: st.tuples(*[st.sampled_from(terms)] * SIGNATURE[name]).map(lambda args: Literal(name, args))
    )


def queries(terms: list = TERMS, most: int = 4) -> st.SearchStrategy[Query]:
    return st.lists(literals(terms), max_size=most).map(tuple)


substitutions = st.dictionaries(st.sampled_from([Var(2), Var(3), Var(4)]), st.sampled_from(TERMS))


def existential(query: Query) -> list[Var]:
    return [var for var in variables(query) if var.index >= ROOTS]


def subsumes_by_trial(general: Query, special: Query) -> bool:
    """The definition: some substitution of the existential variables by terms of `special`."""
    terms = {arg for literal in special for arg in literal.args}
    own = existential(general)
    return any(
        set(substitute(general, dict(zip(own, choice, strict=True)))) <= set(special)
        for choice in product(terms, repeat=len(own))
    )


def form(query: Query) -> frozenset[Literal]:
    found = normal_form(query, ROOTS)
    assert found is not None
    return frozenset(found)


@given(queries(), queries())
def test_subsumption_is_what_its_definition_says(general: Query, special: Query) -> None:
    assert subsumes(general, special, ROOTS) == subsumes_by_trial(general, special)


@given(queries(), substitutions, substitutions, queries(), queries())
def test_subsumption_is_reflexive_and_transitive(query, theta, sigma, more, still_more) -> None:
    special = substitute(query, theta) + more
    most_special = substitute(special, sigma) + still_more
    assert subsumes(query, query, ROOTS)
    assert subsumes(query, special, ROOTS) and subsumes(special, most_special, ROOTS)
    assert subsumes(query, most_special, ROOTS)


def test_constants_of_different_kinds_differ() -> None:
    assert not subsumes((Literal("p", (1,)),), (Literal("p", ("1",)),), ROOTS)
    assert not subsumes((Literal("p", (1,)),), (Literal("p", (1.0,)),), ROOTS)


@given(queries(), substitutions, substitutions)
def test_substitutions_compose(query, theta, sigma) -> None:
    composed = {**sigma, **{var: sigma.get(term, term) for var, term in theta.items()}}
    assert substitute(substitute(query, theta), sigma) == substitute(query, composed)


@given(queries(), queries())
def test_equal_normal_forms_mean_equivalence(left: Query, right: Query) -> None:
    equivalent = subsumes_by_trial(left, right) and subsumes_by_trial(right, left)
    assert (form(left) == form(right)) == equivalent


@given(queries(), st.randoms(use_true_random=False))
def test_the_normal_form_ignores_names_order_and_redundancy(query: Query, random: Random) -> None:
    own = existential(query)
    renaming = dict(zip(own, random.sample([Var(i) for i in range(2, 20)], len(own)), strict=True))
    copy = substitute(query, {var: Var(var.index + 20) for var in own})  # maps back onto the query
    variant = [*substitute(query, renaming), *copy, *substitute(query, renaming)]
    random.shuffle(variant)
    assert form(tuple(variant)) == form(query)


@given(queries(), st.booleans(), st.randoms(use_true_random=False))
def test_equalities_may_be_solved_either_way(query: Query, turned: bool, random: Random) -> None:
    assume(variables(query))
    var = random.choice(variables(query))
    split = tuple(
        Literal(name, tuple(Var(9) if arg == var and random.random() < 0.5 else arg for arg in args))
        for name, args in query
    )
    equality = Literal("=", (Var(9), var) if turned else (var, Var(9)))
    place = random.randint(0, len(split))
    assert form((*split[:place], equality, *split[place:])) == form(query)


def test_equalities_between_root_variables_stay_and_contradictions_are_found() -> None:
    same = Literal("=", (Var(0), Var(1)))
    assert form((same, Literal("p", (Var(1),)))) == {same, Literal("p", (Var(0),))}
    assert form((Literal("=", (Var(1), Var(0))),)) == {same}
    ground = (Literal("=", (Var(2), "a")), Literal("=", (Var(2), Var(0))), Literal("=", (Var(0), 3)))
    assert normal_form(ground, ROOTS) is None
    assert normal_form((Literal("=", (Var(0), 1)), Literal("=", (Var(0), 1.0))), ROOTS) is None


@given(st.lists(st.tuples(st.sampled_from(TERMS), st.sampled_from(TERMS)), max_size=4))
def test_the_unifier_solves_the_equalities_and_prefers_roots(equations) -> None:
    query = tuple(Literal("=", pair) for pair in equations)
    theta, solvable = solve_equalities(query, ROOTS)
    merged = {frozenset([term]) for term in TERMS}
    for left, right in equations:
        together = {group for group in merged if left in group or right in group}
        merged = merged - together | {frozenset().union(*together)}
    assert solvable == all(sum(not isinstance(term, Var) for term in group) <= 1 for group in merged)
    if solvable:
        assert all(left == right for _, (left, right) in substitute(query, theta))
        for group in merged:
            rank = {term: (isinstance(term, Var), term.index if isinstance(term, Var) else 0) for term in group}
            best = min(group, key=rank.__getitem__)
            assert {theta.get(term, term) for term in group} == {best}


@given(queries([Var(0), *map(Var, range(2, 7))], most=7))
def test_components_partition_a_query_and_cannot_be_split(query: Query) -> None:
    query = tuple(dict.fromkeys(query))
    parts = components(query, ROOTS)
    assert sorted(sum(parts, ()), key=str) == sorted(query, key=str)
    for i, part in enumerate(parts):
        assert list(part) == sorted(part, key=query.index)
        for other in parts[:i]:
            assert not set(existential(part)) & set(existential(other))
        reached, rest = {part[0]}, set(part)
        while grown := {each for each in rest - reached if {*existential((each,))} & {*existential(tuple(reached))}}:
            reached |= grown
        assert reached == rest


@given(queries(most=5))
def test_a_reduced_query_is_equivalent_and_has_nothing_redundant(query: Query) -> None:
    core = reduced(query, ROOTS)
    assert set(core) <= set(query)
    assert subsumes_by_trial(core, query) and subsumes_by_trial(query, core)
    for literal in core:
        assert not subsumes_by_trial(core, tuple(each for each in core if each != literal))


@given(queries(most=5))
def test_the_order_of_literals_survives(query: Query) -> None:
    """A literal may need the variables that an earlier one binds."""
    found = normal_form(query, ROOTS)
    names = dict.fromkeys(literal.name for literal in query)
    if len(names) == len(query):
        assert [literal.name for literal in found] == list(names)


@given(st.lists(queries(), min_size=2, max_size=6))
def test_keys_are_equal_where_normal_forms_are(several: list[Query]) -> None:
    forms = Forms(ROOTS)
    for left, right in combinations(several, 2):
        one, other = forms.of(left), forms.of(right)
        assert one is not None and other is not None and form(one.test) == form(left)
        assert (one.key == other.key) == (form(left) == form(right)) == (one.test is other.test)


@st.composite
def extensions(draw: st.DrawFn) -> tuple[Query, Query]:
    """A query, and what may extend it: literals that share the new variables of the first one, or an equality."""
    query = draw(queries(most=5))
    old, new = [*ROOT_TERMS, *existential(query)], [Var(5), Var(6)]
    if draw(st.booleans()):
        pair = draw(st.tuples(*[st.sampled_from(old)] * 2))
        return query, (Literal("=", pair),)
    first = draw(literals([*old, *new]))
    further = draw(st.lists(literals([*old, *new]), max_size=2))
    return query, (first, *(each for each in further if set(existential((first,))) & set(new) & set(each.variables())))


@given(st.lists(extensions(), min_size=1, max_size=4))
def test_an_extended_query_has_the_key_of_the_whole(several: list[tuple[Query, Query]]) -> None:
    """What is remembered, and what is told from the parts alone, is what comes out for the query by itself."""
    forms = Forms(ROOTS)
    keys: dict[frozenset[int], frozenset[Literal]] = {}
    for query, literals in several:
        found, whole = Given(query, forms).extended(literals), normal_form(query + literals, ROOTS)
        assert (found is None) == (whole is None)
        if found and whole is not None:
            prefix, of_part, key = found
            assert form(of_part.test) == form(prefix + literals)
            assert keys.setdefault(key, frozenset(whole)) == frozenset(whole)
            assert forms.of(query + literals).key == key


worlds = st.fixed_dictionaries(
    {name: st.sets(st.tuples(*[st.sampled_from(["a", "b", 3])] * arity)) for name, arity in SIGNATURE.items()}
)


@given(queries(), queries(most=2), worlds, st.tuples(*[st.sampled_from(["a", "b", 3])] * ROOTS))
def test_deciding_tests_decide(query: Query, added: Query, world, roots) -> None:
    values = dict(zip((Var(0), Var(1)), roots, strict=True))
    assume(added and holds(query, 0, values, world))
    tests = Forms(ROOTS).deciding_tests(query, added)
    assert holds(query + added, 0, values, world) == all(holds(test, 0, values, world) for test in tests)


NUMBERS = [-1, 0, 1.5, 2]


@st.composite
def bounded(draw: st.DrawFn) -> Query:
    """A query among numbers, with bounds of what its literals or the example bind, and some equalities."""
    query = draw(queries([Var(0), Var(1), 2, Var(2), Var(3), Var(4)], most=3))
    known = sorted({*variables(query), Var(0), Var(1)})
    bounds = draw(
        st.lists(
            st.builds(
                lambda name, term, limit: Literal(name, (term, limit)),
                st.sampled_from(["=<", ">="]),
                st.sampled_from([*known, 2]),
                st.sampled_from([-1.0, 0.5, 2.0]),
            ),
            max_size=3,
        )
    )
    equalities = draw(st.lists(st.sampled_from(known).map(lambda term: Literal("=", (Var(0), term))), max_size=1))
    return (*query, *bounds, *equalities)


number_worlds = st.fixed_dictionaries(
    {name: st.sets(st.tuples(*[st.sampled_from(NUMBERS)] * arity)) for name, arity in SIGNATURE.items()}
)
examples = st.tuples(*[st.sampled_from(NUMBERS)] * ROOTS).map(
    lambda roots: dict(zip((Var(0), Var(1)), roots, strict=True))
)


def solutions(query: Query, values: dict, world: dict) -> list[dict]:
    """All values of its variables under which every literal holds, by trying each."""
    own = existential(query)
    found = []
    for choice in product(NUMBERS, repeat=len(own)):
        all_values = values | dict(zip(own, choice, strict=True))
        rows = [(name, tuple(all_values.get(arg, arg) for arg in args)) for name, args in query]
        if all(
            row[0] == row[1] if name == "=" else compared(name, *row) if name in OPEN else row in world[name]
            for name, row in rows
        ):
            found.append(all_values)
    return found


def compared(name: str, value: float, limit: float) -> bool:
    return value <= limit if name == "=<" else value >= limit


@given(bounded(), number_worlds, examples)
def test_the_normal_form_with_bounds_is_equivalent(query: Query, world, values) -> None:
    found = normal_form(query, ROOTS)
    assert bool(solutions(query, values, world)) == (found is not None and bool(solutions(found, values, world)))
    if found is not None:
        assert normal_form(tuple(reversed(query)), ROOTS) is not None
        assert {*map(len, map(set, (normal_form(found, ROOTS), found)))} == {len(found)}


@given(bounded(), st.data(), number_worlds, examples)
def test_what_a_query_with_bounds_subsumes_implies_it(special: Query, data, world, values) -> None:
    special = tuple(each for each in special if each.name != "=")
    general = tuple(
        Literal(each.name, (each.args[0], data.draw(st.sampled_from([-1.0, 0.5, 2.0])))) if each.name in OPEN else each
        for each in special
        if data.draw(st.booleans())
    )
    looser = all(any(implies(each, other) for each in special) for other in general if other.name in OPEN)
    assert subsumes(general, special, ROOTS) or not looser
    if subsumes(general, special, ROOTS) and solutions(special, values, world):
        assert solutions(general, values, world)


def test_bounds_imply_looser_ones() -> None:
    p, x, y = Literal("p", (Var(2),)), Var(2), Var(3)
    three, five = Literal("=<", (x, 3.0)), Literal("=<", (x, 5.0))
    assert subsumes((p, five), (p, three), ROOTS) and not subsumes((p, three), (p, five), ROOTS)
    assert not subsumes((p, Literal("=<", (y, 3.0))), (p, five), ROOTS)  # y and x are not said to be one
    assert subsumes((Literal("p", (y,)), Literal("=<", (y, 5.0))), (p, three), ROOTS)
    at_least = Literal(">=", (x, 3.0))
    assert implies(at_least, Literal(">=", (x, 2.0))) and not implies(at_least, Literal(">=", (x, 4.0)))
    assert not implies(at_least, three) and not implies(three, Literal("=<", (y, 4.0)))
    assert tightened((p, five, at_least, three, five)) == (p, at_least, three)
    assert reduced((p, five, Literal("p", (y,)), Literal("=<", (y, 3.0))), ROOTS) == (
        Literal("p", (y,)),
        Literal("=<", (y, 3.0)),
    )


@given(bounded(), number_worlds, examples)
def test_the_least_value_decides_a_test_with_a_bound(query: Query, world, values) -> None:
    test, limit = opened(query)
    bounds = [i for i, each in enumerate(query) if each.name in OPEN]
    if not bounds:
        assert (test, limit) == (query, 0.5)
        return
    name, (term, own) = query[bounds[0]]
    sign = 1 if name == "=<" else -1
    assert limit == sign * own and opened(test)[0] == test
    rest = query[: bounds[0]] + query[bounds[0] + 1 :]
    found = [sign * (each[term] if isinstance(term, Var) else term) for each in solutions(rest, values, world)]
    assert bool(solutions(query, values, world)) == (min(found, default=float("inf")) <= limit)


def test_an_open_bound_counts_before_a_closed_one() -> None:
    closed, one = Literal("=<", (Var(2), 3.0)), Literal(">=", (Var(3), OPEN[">="]))
    assert opened((closed, one)) == ((closed, one), -OPEN[">="])


@settings(max_examples=40)
@given(bounded(), bounded(), number_worlds, examples)
def test_deciding_tests_with_bounds_decide(query: Query, added: Query, world, values) -> None:
    added = tuple(each for each in added if each.name != "=")
    assume(added and solutions(query, values, world) and normal_form(query, ROOTS) is not None)
    try:
        tests = Forms(ROOTS).deciding_tests(query, added)
    except ValueError:
        assert not solutions(query + added, values, world)
        return
    truths = [bool(solutions(test, values, world)) for test in tests]
    assert bool(solutions(query + added, values, world)) == all(truths)
