"""Domain files, problems and language biases that are written for PDDL, held against PDDL's own meaning."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import janus_swi
import pddl_domains as samples
import pytest
from pddl_meaning import Reading

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.terms import texts
from nppg.errors import NppgError
from nppg.pddl.bias_text import bias_text
from nppg.pddl.domain_text import domain_text
from nppg.pddl.goals import goal_predicates, unreachable
from nppg.pddl.model import Change, Value
from nppg.pddl.names import names_of
from nppg.pddl.problem_data import problem_data
from nppg.worlds.domain import Domain
from nppg.worlds.opening import open_domain

CONTRACT = {"goal/0", "action/1", "start/1", "effect/3", "effect/4", "reward/2", "horizon/1", "problem/2", "cost/2"}
FORMULA = Path(__file__).parent.parent / "prolog" / "formula"
IDS = [sample.__name__ for sample in samples.SAMPLES]


def taken(name: str, arity: int) -> bool:
    built_in = "functor(Head, Name, Arity), once(predicate_property(system:Head, defined))"
    return f"{name}/{arity}" in CONTRACT or bool(
        janus_swi.query_once(built_in, {"Name": name, "Arity": arity})["truth"]
    )


class Written:
    """A sample's domain file, in which what is static is a part of the state."""

    def __init__(self, sample: Callable[[], samples.Sample], folder: Path):
        self.pddl, self.problem = sample()
        self.names = names_of(self.pddl, taken)
        self.wanted = goal_predicates(self.problem, self.pddl)
        self.text = domain_text(self.pddl, self.names, self.wanted)
        loaded = self.text.replace(":- static ", ":- fluent ").replace(
            ":- dead_ends.\n", "start([]).\nterminal :- \\+ goal, \\+ action(_).\n"
        )
        loaded = re.sub(r":- pddl\(.*\)\.\n", f":- use_module('{FORMULA}').\n", loaded)
        (folder / "domain.pl").write_text(loaded)
        self.domain = Domain(folder / "domain.pl", trust=True)  # it uses the module that has formulas
        self.data = problem_data(self.problem, self.pddl, self.names, self.wanted)

    def state(self, facts: object, numbers: object) -> tuple:
        """The state of a problem's facts and numbers, with what is static."""
        names = {**self.names.predicates, **self.names.functions}
        given = [(names[name], *args) for name, *args in facts]  # type: ignore[attr-defined]
        given += [(names[name], *args, number) for (name, *args), number in dict(numbers).items() if name in names]  # type: ignore[call-overload]
        given = [each if len(each) > 1 else each[0] for each in given]
        gained = [each for each in self.data.fluents if each[0] == "gained"]
        return self.domain.state(", ".join(texts([*self.data.static, *given, *gained])))

    def act(self, action: tuple) -> str:
        name, *args = action
        return texts([(self.names.actions[name], *args) if args else self.names.actions[name]])[0]


@pytest.fixture(params=samples.SAMPLES, ids=IDS)
def written(request: pytest.FixtureRequest, tmp_path: Path) -> Written:
    return Written(request.param, tmp_path)


def test_actions_and_outcomes_are_those_of_pddl(written: Written) -> None:
    reading = Reading(written.pddl, written.problem)
    static_facts = {fact for fact in written.data.static}
    unread = [reading.start()]
    seen = set()
    while unread and len(seen) < 60:
        facts, numbers = unread.pop(0)
        key = facts, frozenset(dict(numbers).items())
        if key in seen:
            continue
        seen.add(key)
        state = written.state(facts, numbers)
        assert static_facts <= set(state)
        situation = written.domain.situation(state)
        known = reading.closed(facts, numbers)
        assert (situation.status == "goal") == reading.holds(written.problem.goal, known, numbers, {})
        legal = reading.legal(facts, numbers)
        assert (situation.status == "running") == (bool(legal) and situation.status != "goal")
        if situation.status == "running":
            assert sorted(map(str, situation.actions)) == sorted(map(written.act, legal))
            for action, outcomes in written.domain.neighbours(state):
                pddl = next(each for each in legal if written.act(each) == str(action))
                expected = reading.results(*legal[pddl], facts, numbers)
                found: dict = {}
                for outcome in outcomes:
                    rest = tuple(fact for fact in outcome.state if fact[0] != "gained")
                    found[rest] = found.get(rest, 0) + outcome.probability
                wanted: dict = {}
                for (after, values), chance in expected.items():
                    rest = tuple(fact for fact in written.state(after, values) if fact[0] != "gained")
                    wanted[rest] = wanted.get(rest, 0) + float(chance)
                assert found == pytest.approx(wanted)
                unread += [(after, dict(values)) for after, values in expected]
    assert len(seen) > 1


def test_problems_start_where_pddl_says(written: Written) -> None:
    facts, numbers = Reading(written.pddl, written.problem).start()
    data = [*written.data.static, *written.data.fluents]
    assert written.domain.state(", ".join(texts(data))) == written.state(facts, numbers)
    assert len(set(data)) == len(data)


def test_lines_are_short_and_names_need_no_quotes(written: Written) -> None:
    assert max(map(len, written.text.splitlines())) <= 120
    quoted = set(re.findall(r"'[^']*'", written.text))
    assert quoted <= {f"'{Path(written.pddl.file).name}'", "'two-words'"}


def test_biases_fit_their_domains(written: Written) -> None:
    text = bias_text(written.pddl, written.names, written.wanted)
    bias = LanguageBias.parse(text, "bias.yaml")
    description = janus_swi.query_once("nppg_contract:description(M, x, predicates, P)", {"M": written.domain.module})
    predicates = {(name, arity) for name, arity in description["P"]}
    actions = {(written.names.actions[each.name], len(each.parameters)) for each in written.pddl.actions}
    assert not bias.check(predicates, actions)
    assert max(map(len, text.splitlines())) <= 120


def test_few_tests_where_few_are_wanted() -> None:
    pddl, _ = samples.ferry()
    names = names_of(pddl, taken)
    many, few = (LanguageBias.parse(bias_text(pddl, names, {"at"}, most_tests=most), "bias.yaml") for most in (400, 20))
    assert 0 < len(few.modes) < len(many.modes)


def test_neighbours_are_no_objects_to_be_tested(tmp_path: Path) -> None:
    """A relation along which something moves is asked about known objects alone; distances are derived of it."""
    (tmp_path / "mail.pddl").write_text(
        "(define (domain mail) (:requirements :strips) (:predicates (road ?x ?y) (at ?x) (likes ?x ?y) (seen ?y))"
        " (:action walk :parameters (?x ?y) :precondition (and (road ?x ?y) (at ?x))"
        " :effect (and (at ?y) (not (at ?x)))) (:action see :parameters (?x ?y)"
        " :precondition (and (at ?x) (likes ?x ?y)) :effect (seen ?y)))"
    )
    roads = " ".join(f"(road p{i} p{i + 1})" for i in range(5))
    (tmp_path / "p1.pddl").write_text(
        f"(define (problem p1) (:domain mail) (:objects {' '.join(f'p{i}' for i in range(6))})"
        f" (:init {roads} (at p0) (likes p5 p1) (likes p3 p2)) (:goal (and (seen p1) (seen p2))))"
    )
    domain = open_domain(tmp_path / "mail.pddl", problems=[tmp_path / "p1.pddl"])
    lines = [line.strip() for line in domain.language_bias().source.decode().splitlines()]
    assert [line for line in lines if re.search(r"\broad\(", line)] == ["- road(+, +)"]
    assert any("likes(-, +)" in line for line in lines)
    assert "toward_could_see" in domain.source.decode()


def test_the_ferry_reads_well() -> None:
    pddl, _ = samples.ferry()
    text = domain_text(pddl, names_of(pddl, taken), {"at"})
    for line in [
        ":- module(ferry, []).",
        ":- pddl('ferry.pddl').",
        ":- static car/1, location/1, goal_at/2, goals/1, condition/1.",
        ":- fluent at_ferry/1, at/2, empty_ferry/0, on/1.",
        "action(sail(From, To)) :- at_ferry(From), location(To), \\+ at_ferry(To).",
        "effect(sail(From, To), [at_ferry(From)], [at_ferry(To)]).",
        "action(board(Car, Loc)) :- empty_ferry, at_ferry(Loc), at(Car, Loc).",
        "goal :- \\+ ( goal_at(C, L), \\+ at(C, L) ), \\+ ( condition(Formula), \\+ holds(Formula) ).",
        "horizon(Steps) :- goals(Count), Steps is 8*Count+10.",
        "todo_at(C, L) :- goal_at(C, L), \\+ at(C, L).",
    ]:
        assert line in text.splitlines()


def test_goals_are_facts_and_conditions() -> None:
    pddl, problem = samples.ferry()
    data = problem_data(problem, pddl, names_of(pddl, taken), {"at"})
    assert ("goal_at", "c1", "l3") in data.static
    assert ("condition", ("not", ("holds", ("on", "c1")))) in data.static
    assert ("goals", 3) in data.static
    assert "empty_ferry" in data.fluents


def test_names() -> None:
    pddl, _ = samples.odd()
    names = names_of(pddl, taken)
    assert names.predicates["on-top"] == "on_top"
    assert names.predicates["on_top"] == "on_top_2"
    assert names.predicates["is"] == "is_is"
    assert names.types["block"] == "is_block"
    every = [name for group in (names.actions, names.predicates, names.types, names.goal) for name in group.values()]
    assert len(every) == len(set(every))


def test_types_are_asked_where_nothing_guarantees_them() -> None:
    pddl, _ = samples.vehicles()
    lines = domain_text(pddl, names_of(pddl, taken), set()).splitlines()
    assert "action(drive(T, P, Q)) :- at(T, P), truck(T), road(P, Q), P \\== Q." in lines
    assert "action(paint(X)) :- ( box(X) ; truck(X) ), \\+ wet(X)." in lines


def test_recursive_rules_are_tabled() -> None:
    pddl, _ = samples.towers()
    text = domain_text(pddl, names_of(pddl, taken), set())
    assert ":- table above/2." in text
    assert (
        "above(X, Y) :- on(X, Y).\nabove(X, Y) :- on(X, Z), block(Z), above(Z, Y)." in text
        or "above(X, Y) :- on(X, Y)." in text
    )


def test_costs() -> None:
    pddl, _ = samples.tanks()
    text = domain_text(pddl, names_of(pddl, taken), set())
    assert "cost(go(_V, P, Q), Way) :- way(P, Q, Way)." in text
    assert "cost(halve(_V), 0)." in text


def test_rewards(tmp_path: Path) -> None:
    bets = Written(samples.bets, tmp_path)
    start = bets.state(*Reading(bets.pddl, bets.problem).start())
    for action, outcomes in bets.domain.neighbours(start):
        for outcome in outcomes:
            won = "lucky" in outcome.state
            gained = next(fact[1] for fact in outcome.state if fact[0] == "gained")
            assert gained == (0 if str(action) == "rest" else 12 if won else 2)
            assert bets.domain.reward(outcome.state, action) == gained + (100 if won else 0)


def _refused(sample: Callable[[], samples.Sample], effect: object) -> str:
    pddl, _ = sample()
    first = replace(pddl.actions[0], effect=effect)
    with pytest.raises(NppgError) as error:
        domain_text(replace(pddl, actions=(first,)), names_of(pddl, taken), set())
    return str(error.value)


def test_what_is_not_supported_is_named() -> None:
    chance = samples.Probabilistic(((0.5, samples.effects("mad")),))
    assert "forall" in _refused(samples.dice, samples.Each(samples.typed("?x"), chance))
    fuel = Value("fuel", ("?v",))
    twice = samples.effects(Change("increase", fuel, 1), Change("scale-up", fuel, 2))
    assert "fuel" in _refused(samples.tanks, twice)
    assert "total-cost" in _refused(samples.tanks, Change("assign", Value("total-cost", ()), 1))
    assert "more than 1" in _refused(samples.dice, samples.Probabilistic(((0.7, chance), (0.7, chance))))


def test_goals_that_cannot_be_reached() -> None:
    pddl, problem = samples.vehicles()
    assert not unreachable(problem, pddl)
    goal = samples.all_of("road p r", "road p q", "not road p q", "not road q r", "wet p")
    messages = unreachable(replace(problem, goal=goal), pddl)
    assert [message.split(" cannot")[0] for message in messages] == ["the goal (road p r)", "the goal (not (road p q))"]
