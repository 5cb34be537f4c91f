"""States, and what of them stays in Prolog: static facts, the current state, many legal actions."""

from __future__ import annotations

import copy
import gc
import pickle
from pathlib import Path

import numpy as np
import pytest

from nppg import Domain, LanguageBias, NppgError, Policy, open_domain
from nppg.answers.table import TestTable
from nppg.bias.refinement import Refiner
from nppg.bridge.prolog import ask
from nppg.experiments.runs import run
from nppg.judging.space import Space
from nppg.learning.options import Options
from nppg.rrl.options import RIBOptions
from nppg.worlds.legal import LegalActions
from nppg.worlds.state import Interpretation, static_of

ROADS = """\
:- module(roads, []).
:- fluent at/1, old/1.
:- static road/2, home/1.
start([at(a), road(a, b), road(b, a), home(b)]) :- random(X), X < 0.5, !.
start([at(a), road(a, c), road(c, a), home(c)]).
action(go(X, Y)) :- at(X), road(X, Y).
effect(go(X, Y), [at(X)], [at(Y)]).
goal :- at(X), home(X).
"""
NUMBERED = """\
:- module(numbered, []).
:- fluent at/1.
:- static home/1.
:- dead_ends.
problem(N, [at(0), home(N)]) :- member(N, [3, 5, -2]), N > 0.
action(move(D)) :- member(D, [-1, 1]).
effect(move(D), [at(X)], [at(Y)]) :- at(X), Y is X+D.
goal :- at(X), home(X).
"""


def written(folder: Path, text: str) -> Path:
    name = text.partition("(")[2].partition(",")[0]
    path = folder / f"{name}.pl"
    path.write_text(text)
    return path


@pytest.fixture
def roads(tmp_path: Path) -> Domain:
    return Domain(written(tmp_path, ROADS))


def test_copies_of_states_without_static_facts_come_and_go(four_blocks: Domain) -> None:
    rng = np.random.default_rng(0)
    state = pickle.loads(pickle.dumps(four_blocks.start(rng)))
    four_blocks.visit(state)
    del state
    four_blocks.forget()
    gc.collect()
    again = four_blocks.start(rng)
    assert str(again) and static_of(again).facts == ()


def test_static_facts_outlive_those_that_are_dropped(roads: Domain, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(0)
    first = roads.start(rng)
    facts = static_of(first).facts
    held = [first]
    del first

    def dropping(question: str, *args: object) -> object:
        found = ask(question, *args)
        if question == "draw":
            held.clear()  # as the garbage collector might
            gc.collect()
        return found

    monkeypatch.setattr("nppg.worlds.loaded.ask", dropping)
    monkeypatch.setattr("nppg.worlds.domain.ask", dropping)
    for _ in range(20):
        state = roads.start(rng)
        ask("version")
        again = static_of(state)
        assert len(again.facts) == len(facts) == 3
        held.append(state)
        del state, again


def test_states_that_differ_in_negative_numbers_have_other_fingerprints() -> None:
    states = [Interpretation([("at", number)]) for number in (-1, -2, 1, 1.0)]
    assert len({state.fingerprint for state in states}) == 4
    assert Interpretation([("at", -1)]).changed([("at", -1)], [("at", -2)]).fingerprint == states[1].fingerprint


def test_large_states_of_a_users_own_take_their_static_facts_along(roads: Domain) -> None:
    rng = np.random.default_rng(0)
    state = [("home", "b"), ("road", "a", "b"), ("at", "a"), *(("old", i) for i in range(200))]
    reward, following = roads.act(tuple(state), ("go", "a", "b"), rng)
    assert reward == 1 and ("at", "b") in following
    assert ask("intact", roads.module) == "true"
    other = roads.state("at(a), road(a, c), home(c)")
    assert roads.situation(other).actions == [("go", "a", "c")]


FOG = """\
:- module(fog, []).
:- fluent wet/1.
start([wet(1)]).
action(take(N)) :- between(1, 150, N).
effect(take(_), [], []).
goal :- wet(0).
observation([wet(2)]).
"""


def test_many_actions_are_found_in_one_question(tmp_path: Path, monkeypatch) -> None:
    domain = Domain(written(tmp_path, FOG))
    asked: list[str] = []
    monkeypatch.setattr("nppg.worlds.legal.ask", lambda *question: asked.append(question[0]) or ask(*question))
    assert len(list(domain.situation(domain.start(np.random.default_rng(0))).actions)) == 150
    assert asked == ["all_legal"]


def test_tests_are_about_the_state_that_is_seen(tmp_path: Path) -> None:
    bias = """\
action: take(+number)
modes:
  - wet(+)
types:
  wet: [number]
"""
    domain = Domain(written(tmp_path, FOG))
    state = domain.start(np.random.default_rng(0))
    seen = domain.observe(state, np.random.default_rng(0))
    actions = domain.situation(state).actions
    assert isinstance(actions, LegalActions)
    table = TestTable(domain, LanguageBias.parse(bias, "fog.yaml"))
    table.add(each.test for each in Refiner(table.bias).refinements(()))
    answers = table.answers(seen, actions)
    assert (answers == table.answers(seen, list(actions))).all()


def test_exact_evaluation_refuses_static_facts(tmp_path: Path) -> None:
    domain = Domain(written(tmp_path, ROADS.replace(":- static", ":- uniform_start.\n:- static")))
    with pytest.raises(NppgError, match="static"):
        Space(domain)


def test_a_domain_without_start_draws_from_its_problems(tmp_path: Path) -> None:
    domain = open_domain(written(tmp_path, NUMBERED))
    assert domain.chosen == [3, 5]
    assert domain.problem(np.int64(5)) == domain.problem(5)  # type: ignore[arg-type]


def test_states_go_and_come_back_in_any_order(roads: Domain) -> None:
    rng = np.random.default_rng(1)
    starts = [roads.start(rng) for _ in range(8)]
    other = Domain(roads.path)
    states = [*starts, *(copy.deepcopy(each) for each in starts), *(roads.state(str(each)) for each in starts)]
    for domain in (roads, other, copy.copy(roads), pickle.loads(pickle.dumps(roads))):
        for i in rng.permutation(len(states)):
            state = states[i]
            (action,) = domain.situation(state).actions
            assert ("road", *action[1:]) in static_of(state).facts
            reward, following = domain.act(state, action, rng)
            assert reward == 1 and domain.situation(following).status == "goal"
            assert ask("intact", domain.module) == "true"


def test_static_facts_count_for_the_limit(roads: Domain) -> None:
    text = roads.path.read_text().replace(
        "action(go(X, Y)) :- at(X), road(X, Y).",
        "action(go(X, Y)) :- at(X), between(1, 30, _), road(A, _), atom_length(A, N), N > 0, A == X, Y = b.",
    )
    domain = Domain(written(roads.path.parent, text.replace(":- module(roads", ":- module(wide")))
    far = ", ".join(f"road(x{i}, y)" for i in range(40_000))
    state = domain.state(f"at(a), home(b), road(a, b), {far}")
    assert domain.situation(state).actions == [("go", "a", "b")]


def test_problems_of_an_earlier_run_do_not_stay_beside_the_model(tmp_path: Path) -> None:
    path = written(tmp_path, ROADS)
    problems = tmp_path / "far.pl"
    problems.write_text("problem(far, [at(a), road(a, z), home(z)]).\n")
    bias = LanguageBias.parse("action: go(place, place)\ntypes: {home: [place]}\nmodes: [home(+)]\n", "roads.yaml")
    output = tmp_path / "run"
    for given in ([problems], []):
        run(open_domain(path, problems=given), bias, Options(episodes=1), output, 0)
    assert Policy.load(output / "model.pl").domain.chosen == []


def test_stored_instances_have_their_static_facts(tmp_path: Path) -> None:
    domain = Domain(written(tmp_path, ROADS))
    bias = LanguageBias.parse("action: go(place, place)\ntypes: {home: [place]}\nmodes: [home(+)]\n", "roads.yaml")
    run(domain, bias, RIBOptions(episodes=3), tmp_path / "run", 0)
    learned = Policy.load(tmp_path / "run" / "model.pl")
    stored = learned.facts["instance"]
    assert stored and all(any(fact[0] == "home" for fact in each[4][1:]) for each in stored)
