"""Canonical forms against brute force, and the blocks world's states against the known numbers."""

from __future__ import annotations

import math
from collections import Counter
from itertools import permutations, product
from random import Random

import numpy as np
import pytest
from samples import some_blocks, visited

from nppg.bridge.terms import Ground
from nppg.errors import NppgError
from nppg.judging.canonical import Canonizer
from nppg.judging.space import Space
from nppg.worlds.domain import Domain


def renamed(facts, names: dict) -> frozenset:
    def rename(term: Ground) -> Ground:
        return (term[0], *map(rename, term[1:])) if isinstance(term, tuple) else names.get(term, term)

    return frozenset(map(rename, facts))


def random_facts(objects: list[str], random: Random) -> frozenset:
    shapes = [("edge", 2), ("edge", 2), ("edge", 2), ("loop", 1), ("flag", 0), ("deep", 2), ("to_c", 1)]
    facts = set()
    for _ in range(random.randint(0, 6)):
        name, arity = random.choice(shapes)
        args = [random.choice(objects) for _ in range(arity)]
        facts.add(
            {"deep": lambda a: ("at", ("pair", *a), 1), "to_c": lambda a: ("edge", *a, "c")}.get(
                name, lambda a, name=name: (name, *a) if a else name
            )(args)
        )
    return frozenset(facts)


@pytest.mark.parametrize("size", [1, 2, 3, 4])
def test_forms_and_symmetries_are_those_of_brute_force(size: int) -> None:
    objects = [f"o{i}" for i in range(size)]
    canonizer, random = Canonizer(objects), Random(size)
    by_form: dict = {}
    by_class: dict = {}
    for _ in range(250):
        facts = random_facts(objects, random)
        variants = [renamed(facts, dict(zip(objects, order, strict=True))) for order in permutations(objects)]
        form, symmetries = canonizer.form(facts)
        assert symmetries == variants.count(facts)
        assert canonizer.form(random.choice(variants)) == (form, symmetries)
        by_form.setdefault(form, set()).add(frozenset(variants))
        by_class.setdefault(frozenset(variants), set()).add(form)
    assert all(len(each) == 1 for each in (*by_form.values(), *by_class.values()))
    assert len(by_form) > 3


def test_all_graphs_on_four_nodes() -> None:
    """There are 218 directed graphs on four nodes, without loops, up to isomorphism (OEIS A000273)."""
    edges = list(permutations("wxyz", 2))
    canonizer = Canonizer("wxyz")
    sizes: dict = {}
    for choice in product([False, True], repeat=len(edges)):
        facts = [("edge", *edge) for edge, chosen in zip(edges, choice, strict=True) if chosen]
        form, symmetries = canonizer.form(facts)
        sizes.setdefault(form, []).append(24 // symmetries)
    assert len(sizes) == 218
    assert all(set(each) == {len(each)} for each in sizes.values())


def test_regular_structures_that_refinement_leaves_alike() -> None:
    def cycles(*lengths: int) -> list:
        nodes = iter(range(99))
        rings = [[f"o{next(nodes)}" for _ in range(length)] for length in lengths]
        return [("next", a, b) for ring in rings for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]

    canonizer = Canonizer(f"o{i}" for i in range(6))
    assert canonizer.form(cycles(6))[0] != canonizer.form(cycles(3, 3))[0]
    assert canonizer.form(cycles(6))[1] == 6 and canonizer.form(cycles(3, 3))[1] == 18


def test_objects_that_may_not_be_renamed_keep_their_names() -> None:
    canonizer = Canonizer(["a", "b"])
    assert canonizer.form([("on", "a", "x")])[0] != canonizer.form([("on", "a", "y")])[0]
    assert canonizer.form([("on", "a", 1)])[0] != canonizer.form([("on", "a", "1")])[0]
    assert canonizer.form([("on", "a", "x")])[0] == canonizer.form([("on", "b", "x")])[0]
    assert len({canonizer.form([("on", "a", number)])[0] for number in (0, 0.0, -0.0, 1, 1.0)}) == 5


def total(space: Space, status: str) -> int:
    return sum(size for size, own in zip(space.sizes, space.status, strict=True) if own == status)


@pytest.mark.parametrize("blocks", [2, 3, 4, 5, 6])
def test_numbers_of_states(blocks: int) -> None:
    space = Space(Domain("blocks_world", {"blocks": blocks}))
    assert sum(space.sizes) == {2: 3, 3: 13, 4: 73, 5: 501, 6: 4051}[blocks]
    assert space.starts == sum(space.sizes) - total(space, "goal") == total(space, "running")
    if blocks == 6:
        check_horizon_and_expert(space, longest=6)


def test_objects_that_are_not_there_in_every_state_are_interchangeable_too(tmp_path) -> None:
    """Three of five blocks, two of which the goal names: three choices of the third, in the same classes."""
    some, three = Space(some_blocks(tmp_path, 5, 3, 3)), Space(Domain("blocks_world", {"blocks": 3}))
    assert sum(some.sizes) == 3 * sum(three.sizes) and some.starts == 3 * three.starts
    assert sorted(zip(some.sizes, some.status, some.horizons, strict=True)) == sorted(
        (3 * size, status, horizon)
        for size, status, horizon in zip(three.sizes, three.status, three.horizons, strict=True)
    )
    assert len(some.objects) == 5


def check_horizon_and_expert(space: Space, longest: int) -> None:
    """The horizon is the distance to the goal by breadth-first search; the expert's moves are those nearer to it."""
    assert space.origin.tolist() == list(range(len(space.target))) and set(space.weight) == {1.0}
    successors = [space.target[space.owner == i].tolist() for i in range(len(space.states))]
    distance = {i: 0 for i, status in enumerate(space.status) if status == "goal"}
    for steps in range(1, len(space.states)):
        near = [i for i, own in enumerate(successors) if i not in distance and not distance.keys().isdisjoint(own)]
        distance |= dict.fromkeys(near, steps)
    assert len(distance) == len(space.states) and max(distance.values()) == longest
    for i, state in enumerate(space.states):
        if space.status[i] == "running":
            assert space.horizons[i] == space.domain.horizon(state) == distance[i]
            optimal = [a for a, j in zip(space.actions[i], successors[i], strict=True) if distance[j] < distance[i]]
            assert space.domain.expert_actions(state) == optimal


def test_ten_blocks(space: Space) -> None:
    assert len(space.states) == 2084
    assert space.starts == 54_344_538
    assert sum(space.sizes) == 58_941_091
    assert total(space, "goal") == 4_596_553
    assert len(space.owner) == sum(map(len, space.actions)) == 26_406
    share = {length: round(100 * count / space.starts, 3) for length, count in space.lengths().items()}
    assert share == {
        1: 8.458, 2: 14.263, 3: 17.416, 4: 16.885, 5: 14.435, 6: 11.231, 7: 8.001, 8: 5.156, 9: 2.894, 10: 1.261
    }  # fmt: skip
    mean = sum(length * count for length, count in space.lengths().items()) / space.starts
    assert round(mean, 3) == 4.322
    legal = sum(size * len(actions) for size, actions in zip(space.sizes, space.actions, strict=True))
    assert round(legal / space.starts, 3) == 9.297


def check_frequencies(counts: dict, shares: dict) -> None:
    """Chi-square against the 0.999 quantile (Wilson and Hilferty)."""
    drawn, freedom = sum(counts.values()), len(shares) - 1
    assert counts.keys() <= shares.keys()
    chi = sum((counts.get(each, 0) - drawn * share) ** 2 / (drawn * share) for each, share in shares.items())
    assert chi < freedom * (1 - 2 / (9 * freedom) + 3.09 * math.sqrt(2 / (9 * freedom))) ** 3


def test_sampled_starts_are_uniform(four_blocks: Domain) -> None:
    """Over the classes with their weights, and over the 60 states that there are with each of the 12 goals."""
    space = Space(four_blocks)
    assert space.starts == 60
    names = [f"b{i}" for i in range(1, 5)]
    canonizer = Canonizer(names)
    shares: dict = {}
    states: set = set()
    for state, size, status in zip(space.states, space.sizes, space.status, strict=True):
        if status == "running":
            shares[canonizer.form(state)[0]] = size / space.starts
            states |= {renamed(state, dict(zip(names, order, strict=True))) for order in permutations(names)}
    assert len(states) == 60 * 12
    rng = np.random.default_rng(0)
    drawn = [four_blocks.start(rng) for _ in range(4000)]
    check_frequencies(Counter(canonizer.form(state)[0] for state in drawn), shares)
    check_frequencies(Counter(map(frozenset, drawn)), dict.fromkeys(states, 1 / len(states)))


LAMPS = """
:- module(lamps, []).
:- fluent lit/1.
:- parameter(lamps, 4).
:- uniform_start.
:- interchangeable lamp/1.
lamp(I) :- parameter(lamps, N), between(1, N, I).
start(Facts) :-
    findall(lit(I), ( lamp(I), random(R), R < 0.5 ), Facts), \\+ all(Facts), !.
start(Facts) :- start(Facts).
all(Facts) :- parameter(lamps, N), length(Facts, N).
goal :- \\+ ( lamp(I), \\+ lit(I) ).
action(on(I)) :- lamp(I), \\+ lit(I).
action(off(I)) :- lit(I).
effect(on(I), [], [lit(I)]).
effect(off(I), [lit(I)], []).
horizon(N) :- findall(I, ( lamp(I), \\+ lit(I) ), Off), length(Off, N).
"""


def test_states_may_leave_objects_unnamed(tmp_path) -> None:
    (tmp_path / "lamps.pl").write_text(LAMPS)
    space = Space(Domain(tmp_path / "lamps.pl"))
    assert len(space.states) == 5 and space.starts == 15
    assert space.lengths() == {1: 4, 2: 6, 3: 4, 4: 1}


EQUAL_TO_PYTHON = """
:- module(reals, []).
:- fluent at/1.
:- uniform_start.
start([at(1)]).
goal :- at(X), float(X).
action(same).
effect(same, [at(X)], [at(Y)]) :- at(X), Y is X * 1.0.
horizon(1).
"""


def test_whole_and_real_numbers_are_not_the_same(tmp_path) -> None:
    (tmp_path / "reals.pl").write_text(EQUAL_TO_PYTHON)
    space = Space(Domain(tmp_path / "reals.pl"))
    assert space.states == [(("at", 1),), (("at", 1.0),)] and space.status == ["running", "goal"]
    canonizer = Canonizer(["a"])
    assert canonizer.form([("at", 1)]) != canonizer.form([("at", 1.0)])


def test_what_has_no_exact_space_is_refused(delivery: Domain, blocks: Domain) -> None:
    with pytest.raises(NppgError, match="uniform_start"):
        Space(delivery)
    with pytest.raises(NppgError, match="more than 100 classes"):
        Space(blocks, 100)


def test_drawn_goal_states_are_refused(tmp_path) -> None:
    (tmp_path / "lamps.pl").write_text(LAMPS.replace(", \\+ all(Facts), !", ", !"))
    with pytest.raises(NppgError, match="start/1 draws goal states, for instance"):
        Space(Domain(tmp_path / "lamps.pl"))


def test_a_space_without_running_starts_is_refused(tmp_path) -> None:
    (tmp_path / "lamps.pl").write_text(LAMPS + "terminal.\n")
    with pytest.raises(NppgError, match="start/1 draws terminal states, for instance"):
        Space(Domain(tmp_path / "lamps.pl"))


def test_states_that_are_never_drawn_are_refused(tmp_path, delivery: Domain) -> None:
    text = delivery.path.read_text().replace("    in(Parcel, Place),", "    ( in(Parcel, Place) -> true ; at(Place) ),")
    text += """
:- uniform_start.
:- interchangeable room/1.
:- interchangeable parcel/1.
room(Room) :- rooms(Rooms), member(Room, Rooms).
parcel(Parcel) :- parcels(Parcels), member(Parcel, Parcels).
"""
    (tmp_path / "delivery.pl").write_text(text)
    with pytest.raises(NppgError, match=r"start/1 never draws a state with a fact of holding/1, which \d+% of"):
        Space(Domain(tmp_path / "delivery.pl"))
    several, one = "findall(lit(I), ( lamp(I), random(R), R < 0.5 ), Facts)", "lamp(I), Facts = [lit(I)]"
    assert several in LAMPS
    (tmp_path / "lamps.pl").write_text(LAMPS.replace(several, one))
    with pytest.raises(NppgError, match=r"start/1 never draws a state with the horizon \d, which \d+% of"):
        Space(Domain(tmp_path / "lamps.pl"))


ROOMS = """
:- module(rooms, []).
:- fluent at/1, fuel/1, wanted/1.
:- uniform_start.
:- interchangeable room/1.
room(R) :- between(1, 3, R).
start([at(At), fuel(Fuel), wanted(Wanted)]) :-
    random_between(1, 3, At), random_between(LOW, 3, Fuel), random_between(1, 3, Wanted), At =\\= Wanted, !.
start(Facts) :- start(Facts).
goal :- at(R), wanted(R).
terminal :- fuel(0).
action(go(R)) :- room(R), \\+ at(R), fuel(F), F > 0.
action(fill) :- fuel(F), F < 3.
effect(go(R), [at(Old), fuel(F)], [at(R), fuel(Less)]) :- at(Old), fuel(F), Less is F - 1.
effect(fill, [fuel(F)], [fuel(3)]) :- fuel(F).
horizon(HORIZON) :- fuel(F), F > 0.
"""


@pytest.mark.parametrize("low", [1, 3])
@pytest.mark.parametrize("horizon", ["F", "100"])
def test_objects_that_are_not_alike_are_refused(tmp_path, low: int, horizon: str) -> None:
    """The fuel is taken for a room where rooms are numbers, and not where they have names."""
    text = ROOMS.replace("LOW", str(low)).replace("HORIZON", horizon)
    (tmp_path / "rooms.pl").write_text(text)
    with pytest.raises(NppgError, match="room are not interchangeable"):
        Space(Domain(tmp_path / "rooms.pl"))
    text = text.replace("room(R) :- between(1, 3, R).", "room(R) :- member(R, [a, b, c]).")
    text = text.replace("random_between(1, 3, At)", "random_member(At, [a, b, c])").replace("=\\=", "\\==")
    text = text.replace("random_between(1, 3, Wanted)", "random_member(Wanted, [a, b, c])")
    (tmp_path / "named.pl").write_text(text)
    if low == 1:
        assert Space(Domain(tmp_path / "named.pl")).starts == 2 * 3


KINDS = """
:- module(kinds, []).
:- fluent marked/1.
:- uniform_start.
:- interchangeable room/1.
:- interchangeable parcel/1.
room(r1). room(r2).
parcel(p1). parcel(p2). parcel(p3).
thing(X) :- room(X) ; parcel(X).
start(Facts) :-
    findall(marked(X), ( thing(X), random(R), R < 0.5 ), Facts),
    \\+ ( memberchk(marked(r1), Facts), memberchk(marked(r2), Facts) ), !.
start(Facts) :- start(Facts).
goal :- marked(r1), marked(r2).
action(mark(X)) :- thing(X), \\+ marked(X).
action(clear(X)) :- marked(X).
effect(mark(X), [], [marked(X)]).
effect(clear(X), [marked(X)], []).
"""


def test_objects_of_two_kinds_are_not_exchanged(tmp_path) -> None:
    """Of 2 ** 5 states, those with both rooms marked are goal states."""
    (tmp_path / "kinds.pl").write_text(KINDS)
    space = Space(Domain(tmp_path / "kinds.pl"))
    assert (len(space.states), space.starts, total(space, "goal")) == (3 * 4, 24, 8)


def test_every_visited_state_is_in_the_space(four_blocks: Domain) -> None:
    space, canonizer = Space(four_blocks), Canonizer([f"b{i}" for i in range(1, 5)])
    known = {canonizer.form(state)[0] for state in space.states}
    assert all(canonizer.form(state)[0] in known for state in visited(four_blocks, 60, seed=3))
