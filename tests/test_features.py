"""Derived predicates: what they mean against plain Python, which are kept, and what `nppg features` writes."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Iterable, Mapping
from pathlib import Path

import janus_swi
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

import nppg
from nppg.bias.language_bias import LanguageBias
from nppg.bias.names import atom
from nppg.cli.main import main
from nppg.features.bias_edit import extended
from nppg.features.derived import Derived, Words
from nppg.features.joins import apart, joined
from nppg.features.selection import candidates, text
from nppg.pddl.clauses import Choice, Infix, Negated, Once, Term, Var
from nppg.worlds.deriving import worth_testing
from nppg.worlds.domain import Domain
from nppg.worlds.pddl_domain import import_domain

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
    literal = f"[{', '.join(arg for arg in args if arg[0].isupper())}]-{atom(name, args)}"
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
            (f"p{x}", f"p{y}") for x, y in edges if far[x] is not None and far[y] is not None and far[y] < far[x]
        }
        van = ["v1"] if found[f"toward_{name}"] == 3 else []
        assert rows(domain, f"toward_{name}", [*van, "X", "Y"]) == expected, name


@given(relation, st.dictionaries(st.sampled_from(PARCELS), st.sampled_from(PLACES)), relation)
@settings(max_examples=40)
def test_fewer_compares_numbers_of_objects(vans, held: set, wanted: dict, placed: set) -> None:
    """Vans that are somewhere, or hold something; parcels that are held, wanted, or both."""
    domain, found = vans
    facts = [f"holds(v{v}, q{q})" for q, v in sorted(held)] + [f"at(v{v}, p{x})" for v, x in sorted(placed)]
    facts += [f"goal_in(q{q}, p{x})" for q, x in sorted(wanted.items())]
    domain.visit(domain.state(", ".join([*facts, "in(q9, p9)"])))
    parcels, holders = ({each[place] for each in held} for place in (0, 1))
    numbers = {
        "holds_1": len(holders),
        "at_1": len({v for v, _ in placed}),
        "holds_1_at_1": len(holders & {v for v, _ in placed}),
        "holds_2": len(parcels),
        "todo_in_1": len(wanted),
        "todo_in_1_holds_2": len(parcels & wanted.keys()),
    }
    tested = 0
    for few, n in numbers.items():
        for many, m in numbers.items():
            if (name := f"fewer_{few}_than_{many}") in found:
                assert rows(domain, name, []) == ({()} if n < m else set()), name
                tested += 1
    assert tested > 5


@given(relation, st.dictionaries(st.sampled_from(PARCELS), st.sampled_from(PLACES)), relation, relation)
@settings(max_examples=40)
def test_needed_is_what_is_lacking_for_what_is_left_to_do(vans, held: set, wanted: dict, driven: set, roads) -> None:
    """To drop a parcel where it is wanted somebody is there, and holds it; to hold it, it lies somewhere."""
    domain, found = vans
    facts = [f"holds(v{v}, q{q})" for q, v in sorted(held)] + [f"at(v{v}, p{x})" for v, x in sorted(driven)]
    facts += [f"goal_in(q{q}, p{x})" for q, x in sorted(wanted.items())] + ["in(q0, p5)"]
    domain.visit(domain.state(state_of({"v1": roads}, *facts)))
    todo = {(q, x) for q, x in wanted.items() if (q, x) != (0, 5)}
    holding = {q for q, _ in todo} - {q for q, _ in held}
    expected = {
        "needed_holds_to_drop": {(f"q{q}",) for q in holding},
        "needed_at_to_drop": {(f"p{x}",) for _, x in todo if x not in {place for _, place in driven}},
        "needed_in_to_load_to_drop": {(f"q{q}",) for q in holding if q != 0},
    }
    for name, answers in expected.items():
        assert found[name] == 1 and rows(domain, name, ["X"]) == answers, name
    assert "could_load_needed_holds_to_drop" in found
    assert "could_drop_needed_holds_to_drop" not in found  # dropping brings about no holding


@given(st.permutations(range(4)), st.sampled_from(range(5)))
def test_goals_are_asked_in_an_order_that_binds_what_they_compare(order: list[int], count: int) -> None:
    """Whatever their order was: first what is known, then the facts that are about it; comparisons once they can be."""
    x, y, z, other = Var("X"), Var("Y"), Var("Z"), Var("O")
    goals = [Term("far", (z, other)), Term("road", (x, y)), Term("road", (y, z)), Infix("\\==", x, z)]
    unseen = Negated((Term("shut", (y, Var("W"))),))
    given = [goals[place] for place in order]
    found = joined([*given[:count], unseen, *given[count:]], [x])
    assert found == (goals[1], unseen, goals[2], goals[3], goals[0])


def test_goals_are_joined_without_a_change_of_what_they_mean() -> None:
    """What denies waits for what binds its variables, known or not when it is called; calls keep their order."""
    x, y, n, found = Var("X"), Var("Y"), Var("N"), Var("Found")
    busy, lamp, one = Negated((Term("busy", (x,)),)), Term("lamp", (x, y)), Term("one", (y,))
    assert joined([busy, lamp], [x]) == (lamp, busy)
    either = Choice(((Term("lit", (x, y)),), (Infix("=", x, y),)))
    assert joined([one, either, busy], []) == (one, either, busy)
    free = Term("free", (x,))  # free(X) :- \+ on(_, X).
    assert joined([lamp, free], []) == (free, lamp)
    assert joined([lamp, free], [], [free]) == (lamp, free)
    every, length = Term("findall", (x, lamp, found)), Term("length", (found, n))
    assert joined([every, length, one], [n], [every, length]) == (every, length, one)
    sum_, least = Infix("is", n, Infix("+", x, y)), Infix("<", n, Term(9))
    assert joined([lamp, sum_, least], []) == joined([least, lamp, sum_], []) == (lamp, sum_, least)


def test_what_is_denied_of_all_is_not_asked_of_one(vans) -> None:
    _, found = vans
    assert "could_load_for_todo_in_parcel_any" in found
    assert not [name for name in found if name.startswith("could_load_for") and name[-2:] == "_2"]  # on(_, P) is denied
    assert "could_drop" in found and "toward_could_drop" not in found  # where a parcel is not: that lists no places


def test_what_is_no_matter_of_the_answer_is_asked_once() -> None:
    """Neither whether it rains nor what is sold at the end of a road is gone through again."""
    x, y, z, other, unseen = Var("X"), Var("Y"), Var("Z"), Var("O"), Var("W")
    road, sells, wants = Term("road", (x, y)), Term("sells", (y, z)), Term("wants", (other, z))
    rains, at = Term("rains", (unseen,)), Term("at", (x,))
    found = apart([at, road, sells, wants, rains], [x], [x])
    assert found == (Once((rains,)), at, Once((road, Once((sells, Once((wants,)))))))
    assert apart([road, sells, wants], [x, y], [x]) == (road, Once((sells, Once((wants,)))))
    assert apart([road, Negated((Term("shut", (y, unseen)),))], [x, y], [x]) == (
        road,
        Negated((Term("shut", (y, unseen)),)),
    )


# ---------------------------------------------------------------- which are kept


ROW = """\
:- module(row, []).

% A token goes along a row; the lamp is never lit, and the gate always open.

:- static goal_at/2, next/2, open/1, spare/2.
:- fluent at/2, lamp/2.

problem(N, [at(t, c1), goal_at(t, Last), open(gate)|Row]) :-
    between(4, 6, N),
    atom_concat(c, N, Last),
    findall(next(A, B), ( between(1, N, I), J is I+1, atom_concat(c, I, A), atom_concat(c, J, B) ), Row).

action(go(T, X, Y)) :- at(T, X), ( next(X, Y) ; next(Y, X) ).
effect(go(T, X, Y), [at(T, X)], [at(T, Y)]).
goal :- goal_at(T, X), at(T, X).
horizon(30).
"""
ROW_BIAS = """\
action: go(+token, +cell, +cell)
types:
  at: [token, cell]
  goal_at: [token, cell]
  next: [cell, cell]
  spare: [cell, cell]
  lamp: [cell, cell]  # a fluent without a fact
modes:
  - {literal: "goal_at(+, -)", lookahead: 1}
  - at(+, +)
lookahead: 1
# how a tree ends
tree: {max_depth: 4, min_examples: 2}
options: {step: second-order, discount: 0.95}
"""


@pytest.fixture
def row(tmp_path: Path) -> Path:
    folder = tmp_path / "row"
    folder.mkdir()
    (folder / "row.pl").write_text(ROW)
    (folder / "row.yaml").write_text(ROW_BIAS)
    return folder / "row.pl"


def test_what_never_holds_or_tells_nothing_new_is_left_out(row: Path) -> None:
    domain, bias = Domain(row), LanguageBias.load(row.with_suffix(".yaml"))
    names, kept = ({each.name for each in found} for found in (all_of(domain, bias), worth_testing(domain, bias)))
    assert kept < names
    assert {"beyond_lamp", "beyond_spare"} <= names - kept  # no fact
    assert "todo_at" in kept and "wanted_at" in names - kept  # which is the same
    assert "beyond_next" in kept and "beyond_goal_at" not in names  # two types
    once = worth_testing(domain, bias)
    assert [each.name for each in once] == [each.name for each in worth_testing(domain, bias)]


def test_what_the_domain_has_is_left_as_it_is(row: Path) -> None:
    """Also where it is only what a derived predicate asks for."""
    own = "todo_at(T, X) :- goal_at(T, X).\nbeyond_next(X, Y) :- next(Y, X).\nfar_at(none).\nplaces_wanted_at(none).\n"
    row.write_text(ROW + own)
    domain, bias = Domain(row), LanguageBias.load(row.with_suffix(".yaml"))
    found = all_of(domain, bias)
    made = [each.name for one in found for each in one.all()]
    assert not {*made} & {"todo_at", "beyond_next", "far_at", "places_wanted_at", "nearer_at", "toward_wanted_at"}
    assert not {*made} & {name for name, _ in domain.predicates}
    assert main(["features", str(row), "--output", str(row.parent / "more")]) == 0


# ---------------------------------------------------------------- nppg features


def test_it_prints_clauses(row: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["features", str(row)]) == 0
    said = capsys.readouterr()
    assert not said.err
    assert "todo_at(Token, Cell) :- goal_at(Token, Cell), \\+ at(Token, Cell)." in said.out
    assert ":- table beyond_next/2." in said.out
    defined = set(re.findall(r"^(\w+)", re.sub(r"\n +", " ", said.out), re.M))
    asked = set(re.findall(r"(\w+)\(", said.out))
    known = {"next", "at", "goal_at", "findall", "sort", "length", "member", "aggregate_all", "min", "_", "is"}
    assert asked - known <= defined


def test_it_writes_files_that_load_check_and_train(row: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = row.parent / "more"
    assert main(["features", str(row), "--output", str(output)]) == 0
    assert re.search(r"row\.pl, row\.yaml; \d+ derived predicates", capsys.readouterr().out)
    assert (output / "row.pl").read_text().startswith(ROW)
    bias = LanguageBias.load(output / "row.yaml")
    assert bias.types["beyond_next"] == ("cell", "cell") and "todo_at" in {mode.name for mode in bias.modes}
    assert bias.options["discount"] == 0.95
    assert main(["check", str(output / "row.pl")]) == 0
    more = ["--episodes", "20", "--min-examples", "40", "--output", str(row.parent / "run"), "--jobs", "1"]
    assert main(["train", str(output / "row.pl"), *more]) == 0
    (output / "row.yaml").write_text("other")
    capsys.readouterr()
    assert main(["features", str(row), "--output", str(output)]) == 2
    assert "exists already and is left as it is" in capsys.readouterr().err


def test_environments_are_told_to_say_nothing_of_their_actions(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["features", "gym:CartPole-v1"]) == 2
    assert capsys.readouterr().err.endswith("an environment of Gymnasium does not say what its actions change\n")


ODD = """\
:- module(odd, []).
:- use_module(library(apply)).
:- static link/2, goal_box/2, goal_at/3, goal_lit/0.
:- fluent at/1, at/2, box/2, fuel/1, 'Held'/1, lit/0.
:- dead_ends.
:- parameter(limit, 3).

start([at(p1), at(k, p2), box(b, p1), fuel(3), link(p1, p2), link(p2, p3), goal_box(b, p3),
       goal_at(a, b, c), goal_lit]).

near(X, Y) :- link(X, Y).
near(X, Y) :- link(Y, X).

action(wait).
action(go(X)) :- at(Y), ( link(Y, X) -> true ; link(X, Y) ), fuel(F), F > 0, !, X \\== Y.
action(go(X)) :- at(Y), once(near(Y, X)), \\+ ( lit, \\+ at(X) ; at(X) ), parameter(limit, L), L >= 0.
action(push(B, X)) :-
    box(B, Y), at(Y), findall(Z, ( near(Y, Z), Z \\== B ), Zs), member(X, Zs),
    forall(member(Z, Zs), atom(Z)), format(atom(Text), "~w ~a", [B, X]), Text \\== "none", [_|_] = Zs,
    maplist([Each]>>atom(Each), Zs), \\+ \\+ fuel(_), catch(true, _, fail), X @< 1.5e300 -> fail ; fail.
action('Odd one'(X)) :- at(X), at(X, _).
action({X}) :- at(X), fuel(0).

effect(wait, Gone, New) :- Gone = [], New = [lit].
effect(go(X), [at(Y)|Rest], [at(X)|Rest]) :- at(Y), fuel(_), Rest = [].
effect(go(_), _, _) :- fail.
effect(push(B, X), [box(B, Y), Z], [box(B, X), Z]) :- box(B, Y), Z = at(Y).
effect('Odd one'(_), [], ['Held'(x)]).
effect({_}, [], []).
effect(A, D, D) :- A == none, D = [], ( true ; fail ).

goal :- \\+ ( goal_box(B, X), \\+ box(B, X) ).
"""


@pytest.mark.parametrize(
    "types",
    [
        "{box: [thing, spot], link: [spot, spot], goal_box: [thing, spot], at: [spot], lit: []}",
        "{at: [thing, spot], goal_at: [a, b, c], goal_lit: [], lit: [], fuel: [number]}",
        "{box: [thing, spot]}",
    ],
)
def test_odd_clauses_lead_to_no_traceback(tmp_path: Path, types: str, capsys: pytest.CaptureFixture[str]) -> None:
    """What cannot be made sense of is passed over, what is not typed as well; what is derived loads."""
    (tmp_path / "odd.pl").write_text(ODD)
    mode = f"{types[1:].split(':')[0]}(-, +)"
    bias = f"action: [wait, go(+spot), push(+thing, +spot)]\ntypes: {types}\nmodes: [{mode!r}]\n"
    (tmp_path / "odd.yaml").write_text(bias)
    domain = Domain(tmp_path / "odd.pl")
    found = all_of(domain, LanguageBias.load(tmp_path / "odd.yaml"))
    (tmp_path / "odd2.pl").write_bytes(domain.source + text(found).encode())
    Domain(tmp_path / "odd2.pl")
    assert main(["features", str(tmp_path / "odd.pl")]) == 0
    assert not capsys.readouterr().err


def test_mistakes_are_told_of_the_file_that_was_given(row: Path, capsys: pytest.CaptureFixture[str]) -> None:
    row.write_text(ROW.replace("effect(go(T, X, Y)", "effect(go(T, X, c2)"))
    assert main(["features", str(row)]) == 2
    assert capsys.readouterr().err.startswith(f"{row}:")


# ---------------------------------------------------------------- the bias that is written


CHOSEN = [Derived("far", ("a", "b"), (), unknown=(1,)), Derived("fewer", (), ())]
WRITTEN = [
    "action: go(+a, +b)\ntypes: {near: [a, b]}\nmodes: [near(+, +)]\n",
    "action: go(+a, +b)\ntypes: {near: [a, b],}\nmodes: [near(+, +),\n  near(-, +),  # open\n]\n",
    "action: go(+a, +b)\nmodes: [near(+, +)  # the last\n  ]\ntypes: {\n  near: [a, b]  # the last\n}\n",
    "modes:\n  - near(+, +)\naction: go(+a, +b)\r\ntypes:\r\n  near: [a, b]\r\n",
    "{action: go(+a, +b), types: {near: [a, b]}, modes: [near(+, +)]}\n",
    """\
action: go(+a, +b)
types:
  near: [a, b]  # one
# about modes
modes:
- near(+, +)
-   {literal: "near(-, +)", lookahead: 1} # two

# trees
lookahead: 1
""",
    """\
modes:
    - literal: near(-, +)
      lookahead: 1


lookahead: 1
action:
  - go(+a, +b)
types:
    near:
      - a
      - b""",
]


@pytest.mark.parametrize("written", WRITTEN)
def test_types_and_modes_go_to_the_ends_of_their_lists(written: str) -> None:
    old, new = (LanguageBias.parse(each, "bias.yaml") for each in (written, extended(written, CHOSEN)))
    assert new.types == {**old.types, "far": ("a", "b"), "fewer": ()}
    assert [str(mode) for mode in new.modes] == [*map(str, old.modes), "far(+a, +b)", "far(+a, -b)", "fewer"]
    left = yaml.safe_load(extended(written, CHOSEN)).keys()
    assert left == yaml.safe_load(written).keys()
    for comment in re.findall("#.*", written):
        assert comment in extended(written, CHOSEN)
    assert extended(written, []) == written


# ---------------------------------------------------------------- no domain by its name


def test_no_line_of_the_code_knows_a_domain_of_the_competition() -> None:
    names = "blocksworld|childsnack|ferry|floortile|miconic|rovers|satellite|sokoban|spanner|transport"
    known = [path for path in Path(nppg.__file__).parent.rglob("*.py") if re.search(names, path.read_text().lower())]
    assert not known


def test_problems_without_a_step_show_nothing(tmp_path: Path) -> None:
    domain, problem = tmp_path / "domain.pddl", tmp_path / "done.pddl"
    domain.write_text(
        "(define (domain walk) (:requirements :strips) (:predicates (at ?x) (road ?x ?y)) (:action go :parameters "
        "(?x ?y) :precondition (and (at ?x) (road ?x ?y)) :effect (and (not (at ?x)) (at ?y))))"
    )
    problem.write_text("(define (problem done) (:domain walk) (:objects a b) (:init (at a) (road a b)) (:goal (at a)))")
    assert import_domain(domain, [problem]).derived == []
