"""Derived predicates: what they mean against plain Python, which are kept, and what `nppg features` makes of a domain."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping

import janus_swi
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nppg.bias.language_bias import LanguageBias
from nppg.features.derived import Derived, Words
from nppg.features.selection import candidates, text
from nppg.worlds.domain import Domain

VANS = """\
:- module(vans, []).

% Vans carry parcels along roads, each along its own kind of road; some streets are closed to the heavy ones.

:- static road/3, goal_in/2, home/1, place/1, van/1, parcel/1, lid/2, kin/2.
:- fluent at/2, in/2, holds/2, on/2.
:- dead_ends.

todo_in(P, X) :- goal_in(P, X), \\+ in(P, X).

action(drive(V, X, Y)) :- at(V, X), road(V, X, Y).
action(load(V, P, X))  :- at(V, X), in(P, X), \\+ on(_, P).
action(drop(V, P, X))  :- holds(V, P), at(V, X).

effect(drive(V, X, Y), [at(V, X)], [at(V, Y)]).
effect(load(V, P, X), [in(P, X)], [holds(V, P)]).
effect(drop(V, P, X), [holds(V, P)], [in(P, X)]).

goal :- \\+ todo_in(_, _).
"""
VANS_BIAS = """\
action: [drive(+van, +place, +place), load(+van, +parcel, +place), drop(+van, +parcel, +place)]
types:
  at: [van, place]
  in: [parcel, place]
  todo_in: [parcel, place]
  goal_in: [parcel, place]
  holds: [van, parcel]
  road: [van, place, place]
  on: [parcel, parcel]
modes:
  - at(+, +)
"""
PLACES, PARCELS = range(6), range(5)


@pytest.fixture(scope="module")
def vans(tmp_path_factory: pytest.TempPathFactory) -> tuple[Domain, dict[str, int]]:
    """The world of the vans with all that can be derived, kept or not, and how many arguments each has."""
    folder = tmp_path_factory.mktemp("vans")
    (folder / "vans.pl").write_text(VANS + "start([at(v1, p0), in(q0, p0), goal_in(q0, p1)]).\n")
    found = all_of(Domain(folder / "vans.pl"), LanguageBias.parse(VANS_BIAS, "vans.yaml"))
    (folder / "more.pl").write_bytes((folder / "vans.pl").read_bytes() + text(found).encode())
    return Domain(folder / "more.pl"), {each.name: len(each.types) for each in found}


def all_of(domain: Domain, bias: LanguageBias) -> list[Derived]:
    return candidates(domain.module, bias, Words.of(bias, domain.fluents, domain.static, domain.predicates))


def ways_of(edges: Iterable[tuple[int, int]], start: int) -> dict[int, int]:
    """The steps to each place that can be reached, by breadth-first search."""
    following: dict[int, list[int]] = {}
    for x, y in edges:
        following.setdefault(x, []).append(y)
    found, waiting = {start: 0}, deque([start])
    while waiting:
        x = waiting.popleft()
        for y in following.get(x, ()):
            if y not in found:
                found[y] = found[x] + 1
                waiting.append(y)
    return found


def rows(domain: Domain, name: str, args: list[str]) -> set[tuple]:
    """The answers of a literal of variables and names in the current state."""
    literal = f"[{', '.join(arg for arg in args if arg[0].isupper())}]-{name}({', '.join(args)})"
    found = janus_swi.query_once(
        "term_to_atom(_Row-_Literal, Text), _Goal = Module:_Literal, findall(_Row, call(_Goal), Found)",
        {"Text": literal, "Module": domain.module},
    )
    return {tuple(row) for row in found["Found"]}


relation = st.sets(st.tuples(st.sampled_from(PLACES), st.sampled_from(PLACES)), max_size=14)


def state_of(roads: Mapping[str, Iterable[tuple[int, int]]], *facts: str) -> str:
    all_ = [f"road({van}, p{x}, p{y})" for van, edges in roads.items() for x, y in sorted(edges)]
    return ", ".join([*all_, *facts])


# ---------------------------------------------------------------- what they mean


@given(relation)
@settings(max_examples=40)
def test_closures_are_those_of_the_relation_also_where_it_goes_round(vans, edges: set[tuple[int, int]]) -> None:
    domain, _ = vans
    domain.visit(domain.state(", ".join([f"on(q{x}, q{y})" for x, y in sorted(edges)] or ["at(v1, p0)"])))
    expected = {
        (f"q{x}", f"q{y}") for x in PLACES for _, z in (e for e in edges if e[0] == x) for y in ways_of(edges, z)
    }
    assert rows(domain, "beyond_on", ["X", "Y"]) == expected


@given(st.permutations(PARCELS), st.sets(st.integers(1, 4)), st.sets(st.sampled_from(PARCELS)))
@settings(max_examples=40)
def test_unsettled_is_the_recursion_down_a_tower(vans, order: list[int], cuts: set[int], wanted: set[int]) -> None:
    """On random towers: the parcels in an order, cut into piles, some of them wanted elsewhere."""
    domain, _ = vans
    below = {order[i]: order[i + 1] for i in range(4) if i + 1 not in cuts}
    facts = [f"on(q{x}, q{y})" for x, y in below.items()] + [f"goal_in(q{x}, p1)" for x in sorted(wanted)]
    domain.visit(domain.state(", ".join([*facts, "at(v1, p0)"])))

    def unsettled(x: int, beyond: Mapping[int, int]) -> bool:
        return x in wanted or (x in beyond and unsettled(beyond[x], beyond))

    for name, beyond in (("", below), ("before_", {y: x for x, y in below.items()})):
        expected = {(f"q{x}",) for x in PARCELS if unsettled(x, beyond)}
        assert rows(domain, f"unsettled_{name}on_todo_in", ["X"]) == expected


@given(relation, relation, st.sampled_from(PLACES))
@settings(max_examples=40)
def test_steps_and_nearer_are_those_of_a_search(vans, one: set, other: set, goal: int) -> None:
    """On random graphs, an own one for each van, most of them with cycles and parts that do not hang together."""
    domain, found = vans
    domain.visit(domain.state(state_of({"v1": one, "v2": other}, "at(v1, p0)")))
    assert "nearer_at" in found
    for van, edges in (("v1", one), ("v2", other)):
        ways = {x: ways_of(edges, x) for x in PLACES}
        for x in PLACES:
            expected = {(ways[x][goal],)} if goal in ways[x] else set()
            assert rows(domain, "steps_at", [van, f"p{x}", f"p{goal}", "D"]) == expected
            expected = {
                (f"p{y}",)
                for start, y in edges
                if start == x and goal in ways[y] and goal in ways[x] and ways[y][goal] < ways[x][goal]
            }
            assert rows(domain, "nearer_at", [van, f"p{x}", "Y", f"p{goal}"]) == expected


@given(relation, st.sets(st.tuples(st.sampled_from(PARCELS), st.sampled_from(PLACES)), max_size=4), st.data())
@settings(max_examples=40)
def test_toward_leads_to_the_nearest_place_of_its_set(vans, edges: set, placed: set, data) -> None:
    """To where a parcel lies that is wanted elsewhere, and to where one is wanted that the van holds."""
    domain, found = vans
    held = data.draw(st.sets(st.sampled_from(PARCELS), max_size=2)) - {q for q, _ in placed}
    wanted = {q: data.draw(st.sampled_from(PLACES)) for q in data.draw(st.sets(st.sampled_from(PARCELS), max_size=3))}
    facts = [f"in(q{q}, p{x})" for q, x in sorted(placed)] + [f"holds(v1, q{q})" for q in sorted(held)]
    facts += [f"goal_in(q{q}, p{x})" for q, x in sorted(wanted.items())]
    domain.visit(domain.state(state_of({"v1": edges}, "at(v1, p0)", *facts)))
    todo = {(q, x) for q, x in wanted.items() if (q, x) not in placed}
    ways = {x: ways_of(edges, x) for x in PLACES}
    sets = {
        "could_load": {x for _, x in placed},
        "could_load_for_todo_in_parcel_any": {x for q, x in placed if q in {each for each, _ in todo}},
        "could_drop_todo_in": {x for q, x in todo if q in held},
    }
    for name, places in sets.items():
        assert f"toward_{name}" in found, sorted(found)
        far = {x: min((ways[x][z] for z in places if z in ways[x]), default=None) for x in PLACES}
        expected = {
            (f"p{x}", f"p{y}")
            for x, y in edges
            if far[x] is not None and far[y] is not None and far[y] < far[x]
        }
        van = ["v1"] if found[f"toward_{name}"] == 3 else []
        assert rows(domain, f"toward_{name}", [*van, "X", "Y"]) == expected, name
