"""The distance of RIB, held against a plain one: recursion for the edit distance, permutations for the matching."""

from __future__ import annotations

import builtins
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from itertools import permutations
from pathlib import Path
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from samples import pairs, some_blocks, visited

from nppg import Domain, LanguageBias, NppgError
from nppg.bridge.terms import Ground
from nppg.judging.canonical import Canonizer
from nppg.judging.space import Space
from nppg.rrl import matching
from nppg.rrl.distance import PairDistance
from nppg.rrl.matching import PartSets, edit_distances, grown
from nppg.worlds.world import Action, State

PARTS = st.lists(st.integers(1, 3), max_size=4).map(tuple)
SETS = st.lists(PARTS, max_size=4)


@cache
def levenshtein(left: tuple, right: tuple) -> int:
    if not left or not right:
        return len(left) + len(right)
    return min(
        levenshtein(left[1:], right) + 1,
        levenshtein(left, right[1:]) + 1,
        levenshtein(left[1:], right[1:]) + (left[0] != right[0]),
    )


def matched(left: list[tuple], right: list[tuple]) -> int:
    """By every way to match; empty parts stand for those that are left over."""
    left, right = left + [()] * (len(right) - len(left)), right + [()] * (len(left) - len(right))
    return min(sum(map(levenshtein, left, order)) for order in permutations(right))


def between(numbered: PartSets, lefts: list[int], rights: list[int]) -> list[list[int]]:
    return numbered.distances(np.array(lefts, int), np.array(rights, int)).tolist()


@given(st.lists(st.tuples(PARTS, PARTS), min_size=1, max_size=20))
def test_edit_distances(sequences: list[tuple[tuple, tuple]]) -> None:
    sides = []
    for side in zip(*sequences, strict=True):
        array = np.zeros((len(side), 6), np.int32)
        for i, each in enumerate(side):
            array[i, : len(each)] = each
        sides += [array, np.array(list(map(len, side)))]
    assert edit_distances(*sides).tolist() == [levenshtein(*each) for each in sequences]


@given(st.lists(SETS, min_size=2, max_size=8))
def test_matching(sets: list[list[tuple]]) -> None:
    """Every set with every other in one call, and turned about."""
    numbered = PartSets()
    numbers = [numbered.number(each) for each in sets]
    assert [numbers[i] == numbers[j] for i in range(len(sets)) for j in range(i)] == [
        sorted(sets[i]) == sorted(sets[j]) for i in range(len(sets)) for j in range(i)
    ]
    assert between(numbered, numbers, numbers) == [[matched(left, right) for right in sets] for left in sets]
    assert between(numbered, numbers[:1], []) == [[]] and between(numbered, [], numbers) == []


@pytest.mark.parametrize("name, value", [("_SUBSETS", 0), ("_TABLE", 3), ("_BATCH", 2), ("_SINGLES", 0)])
def test_other_ways_to_match(monkeypatch: pytest.MonkeyPatch, name: str, value: int) -> None:
    """By assignment, without a table and in small batches, all comes out the same."""
    rng = Random(0)
    sets = [[tuple(rng.choices(range(1, 5), k=rng.randrange(4))) for _ in range(rng.randrange(9))] for _ in range(40)]

    def all_distances() -> list[list[int]]:
        numbered = PartSets()
        numbers = [numbered.number(each) for each in sets]
        first = between(numbered, numbers[:3], numbers[:3])  # a table that is filled in two goes
        return first + between(numbered, numbers, numbers)

    usual = all_distances()
    monkeypatch.setattr(matching, name, value)
    assert all_distances() == usual


def test_grown() -> None:
    array = grown(np.arange(6).reshape(3, 2), 4, 3)
    assert array.shape == (8, 3) and array[:3, :2].tolist() == [[0, 1], [2, 3], [4, 5]] and array.sum() == 15
    assert grown(array, 8, 2) is array and grown(array, 2, 5).shape == (8, 5)


# ---------------------------------------------------------------- pairs of states and actions


def plain(bias: LanguageBias, left: tuple[State, Action], right: tuple[State, Action], mismatch: float = 1) -> float:
    """The distance in the blocks world as its definition reads."""
    seen = [looks(bias, *each) for each in (left, right)]
    (labels, towers), (other_labels, other_towers) = seen
    differing = sum(one != other for one, other in zip(labels, other_labels, strict=True))
    return mismatch * differing + matched(towers, other_towers)


def looks(bias: LanguageBias, state: State, action: Action) -> tuple[list[str], list[tuple]]:
    (goal,) = (fact[1:] for fact in state if fact[0] == "goal_on")
    names: dict[Ground, str] = {}
    for role, each in zip("ABXY", (*goal, *action[1:]), strict=True):
        names.setdefault(each, each if each == "floor" else role)
    below = {fact[1]: fact[2] for fact in state if fact[0] == "on"}
    above = {lower: upper for upper, lower in below.items() if lower != "floor"}
    towers = []
    for block in (each for each in below if below[each] == "floor"):
        tower = [block]
        while tower[-1] in above:
            tower.append(above[tower[-1]])
        towers.append(tuple(names.get(each, "block") for each in tower))
    return [names[each] for each in (*goal, *action[1:])], towers


@pytest.mark.parametrize("blocks, mismatch", [(3, 1.0), (5, 2.5)])
def test_blocks_world_against_the_definition(plain_bias: LanguageBias, blocks: int, mismatch: float) -> None:
    domain = Domain("blocks_world", {"blocks": blocks})
    states, actions = pairs(domain, visited(domain, 12))
    measure = PairDistance(domain, plain_bias, mismatch)
    numbers = described(measure, states, actions)
    found = measure.rows(numbers, numbers)
    wanted = [
        [plain(plain_bias, left, right, mismatch) for right in zip(states, actions, strict=True)]
        for left in zip(states, actions, strict=True)
    ]
    assert found.tolist() == wanted
    assert found.dtype == float and measure.rows(numbers, numbers[:0]).shape == (len(numbers), 0)


def described(measure: PairDistance, states: list[State], actions: list[Action]) -> np.ndarray:
    return np.array([measure.describe(*each)[0] for each in zip(states, ([a] for a in actions), strict=True)])


@pytest.fixture(scope="module", params=["blocks", "delivery"])
def measured(request: pytest.FixtureRequest) -> tuple[PairDistance, list[State], list[Action], np.ndarray]:
    domain = request.getfixturevalue(request.param)
    bias = request.getfixturevalue("delivery_bias" if request.param == "delivery" else "plain_bias")
    states, actions = pairs(domain, visited(domain, 40, seed=1))
    measure = PairDistance(domain, bias)
    return measure, states, actions, described(measure, states, actions)


def test_metric(measured: tuple[PairDistance, list[State], list[Action], np.ndarray]) -> None:
    measure, _, _, numbers = measured
    numbers = np.unique(numbers)
    found = measure.rows(numbers, numbers)
    assert (found == found.T).all() and (found >= 0).all()
    assert ((found == 0) == np.eye(len(numbers), dtype=bool)).all(), "classes are apart"
    for i, j, k in np.random.default_rng(0).integers(len(numbers), size=(20_000, 3)):
        assert found[i, k] <= found[i, j] + found[j, k]


def test_one_number_for_all_that_looks_alike(space: Space, plain_bias: LanguageBias) -> None:
    """In the blocks world, pairs have one number exactly where a renaming makes them equal; each state of the space
    comes up once as it is and once with its blocks renamed."""
    domain, rng = Domain("blocks_world"), Random(0)
    measure = PairDistance(domain, plain_bias)
    canonizer = Canonizer(f"b{i}" for i in range(1, 11))
    forms: dict[tuple, int] = {}
    for state, actions in rng.sample(list(zip(space.states, space.actions, strict=True)), 300):
        names = dict(zip(sorted(canonizer.objects), rng.sample(sorted(canonizer.objects), 10), strict=True))
        renamed = [tuple(names.get(each, each) for each in term) for term in (*state, *actions)]
        facts, moves = tuple(sorted(renamed[: len(state)])), renamed[len(state) :]
        numbers = measure.describe(state, actions)
        assert (numbers == measure.describe(facts, moves)).all()
        for action, number in zip(actions, numbers.tolist(), strict=True):
            form = canonizer.form((*state, action))[0]
            assert forms.setdefault(form, number) == number
    assert len(forms) == len(measure) > 1000
    for number in range(0, len(measure), 50):
        state, action = measure.example(number)
        assert measure.describe(state, [action]) == [number]


def test_default_parts(delivery: Domain, delivery_bias: LanguageBias) -> None:
    """The facts but the goal's. The parcel and the room of goal and action go by their roles; nobody else is renamed,
    since the domain declares nothing interchangeable. Other kinds of actions have other roles."""
    measure = PairDistance(delivery, delivery_bias)

    def state(at: str, wanted: tuple[str, str], **places: str) -> State:
        return (("at", at), ("wanted", *wanted), *(("in", *each) for each in places.items()))

    usual = state("room1", ("parcel1", "room2"), parcel1="room3", parcel2="room1")
    others = [
        (state("room1", ("parcel4", "room5"), parcel4="room3", parcel2="room1"), ("go", "room3"), 0),  # by role
        (state("room4", ("parcel1", "room2"), parcel1="room3", parcel2="room1"), ("go", "room3"), 1),
        (state("room1", ("parcel1", "room2"), parcel1="room3", parcel3="room4"), ("go", "room3"), 2),
        (state("room1", ("parcel1", "room2"), parcel1="room3"), ("go", "room3"), 3),  # a fact less
        (usual, ("go", "room2"), 1 + 1),  # the action's label, and where the goal's parcel is
        (usual, ("pick", "parcel1"), 1 + 1 + 1),  # and the kind of action
        (state("room1", ("parcel1", "room3"), parcel1="room3", parcel2="room1"), ("go", "room3"), 1 + 1),
    ]
    number = measure.describe(usual, [("go", "room3")])
    for facts, action, wanted in others:
        assert measure.rows(number, measure.describe(facts, [action])) == wanted, (facts, action)


CHAIN = """
:- module(chain, []).
:- fluent cell/2, robot/1.
:- interchangeable thing/1.
:- interchangeable tool/1.
thing(X) :- cell(X, _).
tool(X) :- cell(X, f(_, tool)).
start([cell(a, f(1, tool)), cell(b, f(2.5, none)), cell(c, f(1, none)), robot([a, b])]).
action(stop).
action(use(X)) :- thing(X).
effect(_, [], []).
goal :- fail.
"""


def test_no_goal_and_kinds_and_compounds(tmp_path: Path, bias_of: Callable[[str], LanguageBias]) -> None:
    """Without a goal template there are only action roles; names inside compounds are renamed; tools are no mere
    things; an action may have no arguments."""
    (tmp_path / "chain.pl").write_text(CHAIN)
    domain = Domain(tmp_path / "chain.pl")
    bias = bias_of("action: [stop, use(+thing)]\ntypes: {tool: [thing]}\nmodes: [tool(+)]\n")
    measure = PairDistance(domain, bias)
    state = domain.start(np.random.default_rng(0))
    stop, use_a, use_b, use_c = measure.describe(state, ["stop", ("use", "a"), ("use", "b"), ("use", "c")])
    assert len(measure) == 4
    assert measure.rows([stop], [use_c]) == 1 + 1 + 1  # another kind, a role more, cell(c, ...)
    assert measure.rows([use_a], [use_b]) == 2 + 1  # both cells, and the robot's list, which is one term
    other = tuple((name, "b", *rest) if rest and name == "c" else (name, *rest) for name, *rest in state)
    assert measure.describe(other, ["stop"]) == [stop]
    numbers = [measure.describe((("cell", "a", ("f", each, "none")),), ["stop"])[0] for each in (0, 0.0, -0.0, 1, 1.0)]
    assert len(set(numbers)) == 5


def test_what_is_interchangeable_hangs_on_the_state_alone(tmp_path: Path, plain_bias: LanguageBias) -> None:
    """Where each start has other objects: the definition holds, in whichever order the states are met."""
    domain = some_blocks(tmp_path, 7, 2, 5)
    states, actions = pairs(domain, visited(domain, 20))
    assert len({sum(fact[0] == "on" for fact in state) for state in states}) > 2
    found = []
    for order in (1, -1):
        measure = PairDistance(domain, plain_bias)
        numbers = described(measure, states[::order], actions[::order])[::order]
        found.append(measure.rows(numbers, numbers).tolist())
    both = list(zip(states, actions, strict=True))
    assert found == 2 * [[[plain(plain_bias, left, right) for right in both] for left in both]]


SCRIPT = """
import sys, numpy as np
from nppg import Domain, LanguageBias
from nppg.rrl.distance import PairDistance
measure = PairDistance(Domain("blocks_world"), LanguageBias.load(sys.argv[1]))
numbers = [int(measure.describe(state, [action])[0]) for state, action in eval(sys.stdin.read())]
print(measure.rows(np.array(numbers), np.array(numbers)).tolist())
"""


def test_examples_mean_the_same_in_another_process(blocks: Domain, plain_bias: LanguageBias) -> None:
    measure = PairDistance(blocks, plain_bias)
    states, actions = pairs(blocks, visited(blocks, 4, seed=3))
    described(measure, states, actions)
    numbers = np.arange(len(measure))[::-1]
    examples = [measure.example(number) for number in numbers]
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, plain_bias.file],
        input=repr(examples),
        capture_output=True,
        text=True,
        check=True,
    )
    assert eval(done.stdout) == measure.rows(numbers, numbers).tolist()


def test_without_scipy(blocks: Domain, plain_bias: LanguageBias, monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def without(name: str, *more: object) -> object:
        if name.startswith("scipy"):
            raise ImportError(name)
        return real(name, *more)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(NppgError, match=r"^[^\n]*pip install nppg\[rrl\]$"):
        PairDistance(blocks, plain_bias)


@pytest.mark.parametrize("mismatch", [0, -1, float("nan"), float("inf")])
def test_penalties_that_cannot_be(blocks: Domain, plain_bias: LanguageBias, mismatch: float) -> None:
    with pytest.raises(NppgError, match="mismatch"):
        PairDistance(blocks, plain_bias, mismatch)
