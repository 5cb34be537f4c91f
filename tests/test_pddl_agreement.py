"""PDDL as nppg and as others understand it: unified-planning's simulator, and distributions written down by hand."""

from __future__ import annotations

from pathlib import Path
from random import Random

import numpy as np
import pytest
from agreement import Reference, agree, named_action, named_facts, opened

from nppg.worlds.pddl_domain import PddlDomain
from nppg.worlds.world import State

TYPES = """
(define (domain types)
  (:requirements :strips :typing)
  (:types place - object car van - vehicle vehicle parcel - thing thing person - object)
  (:constants depot mill - place driver - person)
  (:predicates (at ?x - (either thing person) ?p - place) (in ?x - thing ?v - vehicle) (road ?a ?b - place)
    (licence ?p - person ?v - vehicle))
  (:action drive :parameters (?v - vehicle ?a ?b - place)
    :precondition (and (at ?v ?a) (road ?a ?b) (in-use ?v) (licence driver ?v))
    :effect (and (not (at ?v ?a)) (at ?v ?b)))
  (:action load :parameters (?x - parcel ?v - vehicle ?a - place)
    :precondition (and (at ?x ?a) (at ?v ?a)) :effect (and (not (at ?x ?a)) (in ?x ?v) (in-use ?v)))
  (:action unload :parameters (?x - parcel ?v - van ?a - place)
    :precondition (and (in ?x ?v) (at ?v ?a)) :effect (and (at ?x ?a) (not (in ?x ?v))))
  (:action home :parameters (?x - (either thing person))
    :precondition (and (at ?x depot) (exists (?y - (either thing person)) (at ?y mill))) :effect (resting ?x)))
"""
TYPES = TYPES.replace("(licence ?p", "(in-use ?v - vehicle) (resting ?x - (either thing person)) (licence ?p")
TYPES_PROBLEM = """
(define (problem p) (:domain types)
  (:objects c1 - car v1 v2 - van p1 p2 - parcel ann - person)
  (:init (at c1 depot) (at v1 depot) (at v2 mill) (at p1 depot) (at p2 mill) (at ann depot) (at driver mill)
    (road depot mill) (road mill depot) (licence driver v1) (licence driver c1))
  (:goal (and (at p1 mill) (resting v1))))
"""

FORMULAS = """
(define (domain formulas)
  (:requirements :adl)
  (:types node colour)
  (:constants red - colour)
  (:predicates (edge ?a ?b - node) (has ?n - node ?c - colour) (frozen ?n - node) (mark ?n - node) (quiet))
  (:action paint :parameters (?n - node ?c - colour)
    :precondition (and (not (frozen ?n)) (not (has ?n ?c))
      (forall (?m - node) (or (not (edge ?n ?m)) (not (has ?m ?c)) (= ?m ?n))))
    :effect (and (has ?n ?c) (forall (?d - colour) (when (not (= ?d ?c)) (not (has ?n ?d))))))
  (:action freeze :parameters (?n - node)
    :precondition (or (exists (?m - node ?c - colour) (and (edge ?n ?m) (has ?m ?c) (has ?n ?c))) (has ?n red) (quiet))
    :effect (and (frozen ?n)
      (forall (?m - node) (when (and (edge ?n ?m) (not (frozen ?m))) (and (mark ?m) (not (has ?m red)))))
      (when (forall (?m - node) (imply (edge ?n ?m) (mark ?m))) (quiet))))
  (:action swap :parameters (?a ?b - node)
    :precondition (and (not (= ?a ?b)) (or (edge ?a ?b) (edge ?b ?a)))
    :effect (and (when (mark ?a) (and (not (mark ?a)) (mark ?b))) (when (mark ?b) (and (not (mark ?b)) (mark ?a)))))
  (:action thaw :parameters (?n ?m - node)
    :precondition (and (frozen ?n) (imply (mark ?n) (frozen ?m)) (or (= ?n ?m) (not (quiet))))
    :effect (and (not (frozen ?n)) (frozen ?m) (not (quiet)))))
"""
FORMULAS_PROBLEM = """
(define (problem p) (:domain formulas)
  (:objects a b c - node blue - colour)
  (:init (edge a b) (edge b c) (edge c c) (has a red) (has b red) (mark b))
  (:goal (and (exists (?n - node) (and (frozen ?n) (has ?n blue)))
    (forall (?n - node) (or (has ?n red) (has ?n blue) (mark ?n))) (not (quiet)))))
"""

NUMBERS = """
(define (domain numbers)
  (:requirements :typing :fluents :negative-preconditions :conditional-effects)
  (:types tank)
  (:predicates (open ?t - tank) (used ?a ?b - tank))
  (:functions (level ?t - tank) (size ?t - tank) (flow ?a ?b - tank) (total) (total-cost))
  (:action pour :parameters (?a ?b - tank)
    :precondition (and (not (= ?a ?b)) (open ?a) (>= (level ?a) 1.5) (<= (+ (level ?b) 1.5) (size ?b)))
    :effect (and (decrease (level ?a) 1.5) (increase (level ?b) 1.5) (used ?a ?b) (increase (total-cost) (size ?b))))
  (:action fill :parameters (?t - tank)
    :precondition (and (open ?t) (< (level ?t) (/ (size ?t) 2)))
    :effect (and (assign (level ?t) (size ?t)) (increase (total) (- (size ?t) (level ?t))) (increase (total-cost) 4)))
  (:action turn :parameters (?t - tank)
    :precondition (> (* 2 (size ?t)) (- (total) 30))
    :effect (and (when (open ?t) (not (open ?t))) (when (not (open ?t)) (and (open ?t) (increase (total) 1)))
      (increase (total-cost) 1)))
  (:action empty :parameters (?t - tank)
    :precondition (= (level ?t) (size ?t))
    :effect (and (assign (level ?t) 0) (forall (?o - tank) (not (used ?t ?o))) (increase (total-cost) 0.5)))
  (:action shift :parameters (?a ?b ?c - tank)
    :precondition (>= (flow ?a ?b) 1)
    :effect (and (decrease (flow ?a ?b) 1) (increase (flow ?b ?c) (flow ?a ?b)) (increase (total-cost) 1)))
  (:action spread :parameters (?a - tank)
    :precondition (> (flow ?a ?a) 1)
    :effect (and (decrease (flow ?a ?a) 2) (increase (total-cost) 1)
      (forall (?b - tank) (when (not (= ?b ?a)) (increase (flow ?a ?b) 1))))))
"""
NUMBERS_PROBLEM = """
(define (problem p) (:domain numbers)
  (:objects t1 t2 t3 - tank)
  (:init (open t1) (open t2) (= (level t1) 6) (= (level t2) 0.5) (= (level t3) 3) (= (size t1) 6) (= (size t2) 4)
    (= (size t3) 3) (= (total) 0) (= (total-cost) 0) (= (flow t1 t1) 2) (= (flow t1 t2) 1) (= (flow t1 t3) 0)
    (= (flow t2 t1) 0) (= (flow t2 t2) 3) (= (flow t2 t3) 0.5) (= (flow t3 t1) 0) (= (flow t3 t2) 0) (= (flow t3 t3) 1))
  (:goal (and (>= (level t2) 2) (< (+ (level t1) (level t3)) 6) (used t1 t2)))
  (:metric minimize (total-cost)))
"""

NAMES = """
(define (domain Odd-Names)
  (:requirements :strips :typing :negative-preconditions :equality)
  (:types block - Object fluent action module - block)
  (:constants TABLE end - block)
  (:predicates (goal ?x - block) (on-top ?x ?y - block) (on_top ?x ?y - block) (is ?x - block) (mod ?x ?y - block)
    (block ?x - Block) (true) (member ?x ?y - block) (start) (effect ?x - block) (static) (Not-Yet))
  (:action Action :parameters (?X - block ?Y - block)
    :precondition (and (on-top ?x ?y) (NOT (= ?x table)) (not (goal ?x)))
    :effect (and (goal ?X) (on_top ?y ?x) (not (on-top ?x ?y)) (is ?x) (true)))
  (:action on-top :parameters (?if ?then - block)
    :precondition (and (is ?if) (mod ?if ?then))
    :effect (and (on-top ?if ?then) (not (goal ?if)) (not (mod ?if ?then)) (member ?then ?if) (effect ?if)))
  (:action do-it :parameters (?x_ - block)
    :precondition (and (true) (block ?x_)) :effect (and (not (true)) (start) (not (is ?x_))))
  (:action horizon :parameters () :precondition (start)
    :effect (and (mod end table) (static) (not (start)) (is end) (not-yet))))
"""
NAMES_PROBLEM = """
(define (problem 9-Lives) (:domain odd-names)
  (:objects a - fluent - - action a-b a_b nil - module)
  (:INIT (on-top a table) (ON-TOP end A-B) (mod a end) (mod end a) (is nil) (mod nil a_b) (block a) (block NIL))
  (:goal (and (on_top a-b end) (member TABLE end) (not (goal end)))))
"""
NAMES_PROBLEM = NAMES_PROBLEM.replace(" - - action", " x - action")

UNTYPED = """
(define (domain untyped)
  (:requirements :strips :equality :negative-preconditions)
  (:predicates (at ?x) (ball ?b) (room ?r) (in ?b ?r) (free) (held ?b))
  (:action move :parameters (?a ?b) :precondition (and (room ?a) (room ?b) (at ?a) (not (= ?a ?b)))
    :effect (and (at ?b) (not (at ?a))))
  (:action take :parameters (?b ?r) :precondition (and (in ?b ?r) (at ?r) (free))
    :effect (and (not (in ?b ?r)) (not (free)) (held ?b)))
  (:action drop :parameters (?b ?r) :precondition (and (held ?b) (at ?r))
    :effect (and (in ?b ?r) (free) (not (held ?b))))
  (:action wait :parameters () :effect (free))
  (:action again :parameters (?x) :precondition () :effect (and (not (at ?x)) (at ?x))))
"""
UNTYPED_PROBLEM = """
(define (problem p) (:domain untyped)
  (:objects r1 r2 b1 b2)
  (:init (room r1) (room r2) (ball b1) (ball b2) (in b1 r1) (in b2 r2) (at r1) (free))
  (:goal (and (in b1 r2) (or (in b2 r1) (held b2)))))
"""

PAIRS = {
    "types": (TYPES, TYPES_PROBLEM),
    "formulas": (FORMULAS, FORMULAS_PROBLEM),
    "numbers": (NUMBERS, NUMBERS_PROBLEM),
    "names": (NAMES, NAMES_PROBLEM),
    "untyped": (UNTYPED, UNTYPED_PROBLEM),
}


def written(folder: Path, domain: str, problem: str) -> tuple[Path, Path]:
    """The two files."""
    files = folder / "domain.pddl", folder / "problem.pddl"
    for file, text in zip(files, (domain, problem), strict=True):
        file.write_text(text, encoding="utf-8")
    return files


@pytest.mark.parametrize("name", PAIRS)
def test_random_walks_are_those_of_another_simulator(name: str, tmp_path: Path) -> None:
    domain, problem = written(tmp_path, *PAIRS[name])
    found = opened(domain, problem)
    domain.write_text(without_either(domain.read_text()))
    assert agree(found, 1, Reference(domain, problem), walks=10, steps=10) > 40


def without_either(domain: str) -> str:
    """The text of a domain as unified-planning reads it, with a type in place of `either`."""
    return domain.replace("thing person - object", "thing person - either_of_them").replace(
        "(either thing person)", "either_of_them"
    )


EITHER = """
(define (domain one-of-both)
  (:requirements :typing)
  (:types car van boat - vehicle person truck)
  (:predicates (here ?x - (either vehicle person)) (fast ?x - object))
  (:action call :parameters (?x - (either van person))
    :precondition (exists (?y - (either boat truck)) (fast ?y)) :effect (here ?x))
  (:action leave :parameters (?x - (either car boat truck)) :effect (and (fast ?x)
    (forall (?y - (either car person)) (when (here ?y) (not (here ?y)))))))
"""
EITHER_PROBLEM = """
(define (problem p) (:domain one-of-both)
  (:objects c - car v - van b - boat ann - person t - truck m - (either car van))
  (:init (fast c) (here c) (here v) (here ann))
  (:goal (forall (?x - (either boat person)) (or (here ?x) (fast ?x)))))
"""


def facts_after(domain: PddlDomain, state: State, named: tuple[str, ...]) -> tuple[State, set[str]]:
    """What the only outcome of an action is, and its facts, as text."""
    for action, outcomes in domain.neighbours(state):
        if named_action(domain, action) == named:
            (outcome,) = outcomes
            return outcome.state, {" ".join(each) for each in named_facts(domain, outcome.state)[0]}
    raise AssertionError(f"{named} is not legal")


def legal(domain: PddlDomain, state: State) -> set[str]:
    return {" ".join(named_action(domain, each)) for each in domain.situation(state).actions}


def test_either(tmp_path: Path) -> None:
    """By hand, since unified-planning does not read it."""
    domain = opened(*written(tmp_path, EITHER, EITHER_PROBLEM))
    state = domain.problem(1)
    leaving = {f"leave {each}" for each in "cbtm"}
    assert legal(domain, state) == leaving, "nothing of boat or truck is fast"
    state, facts = facts_after(domain, state, ("leave", "m"))
    assert facts == {"fast c", "fast m", "here v"}
    assert legal(domain, state) == leaving
    state, facts = facts_after(domain, state, ("leave", "b"))
    assert legal(domain, state) == leaving | {"call v", "call m", "call ann"}
    state, facts = facts_after(domain, state, ("call", "ann"))
    assert facts == {"fast c", "fast m", "fast b", "here v", "here ann"}
    assert domain.situation(state).status == "goal"


DERIVED = """
(define (domain derived)
  (:requirements :typing :derived-predicates :adl)
  (:types block)
  (:predicates (on ?x ?y - block) (above ?x ?y - block) (clear ?x - block) (top ?x - block) (alone) (held ?x - block)
    (safe ?x - block))
  (:derived (above ?x ?y - block) (or (on ?x ?y) (exists (?z - block) (and (on ?x ?z) (above ?z ?y)))))
  (:derived (clear ?x - block) (and (not (held ?x)) (not (exists (?y - block) (on ?y ?x)))))
  (:derived (top ?x - block) (and (clear ?x) (exists (?y - block) (above ?x ?y))))
  (:derived (alone) (forall (?x ?y - block) (not (above ?x ?y))))
  (:derived (safe ?x - block) (alone))
  (:derived (safe ?x - block) (forall (?y - block) (imply (above ?x ?y) (safe ?y))))
  (:action take :parameters (?x - block)
    :precondition (and (clear ?x) (not (exists (?y - block) (held ?y))))
    :effect (and (held ?x) (forall (?y - block) (when (above ?x ?y) (not (on ?x ?y))))))
  (:action put :parameters (?x ?y - block)
    :precondition (and (held ?x) (clear ?y) (or (top ?y) (alone)))
    :effect (and (not (held ?x)) (on ?x ?y)))
  (:action lay :parameters (?x - block) :precondition (held ?x) :effect (not (held ?x))))
"""
DERIVED_PROBLEM = """
(define (problem p) (:domain derived)
  (:objects a b c d - block)
  (:init (on a b) (on b c))
  (:goal (and (above c a) (top d) (not (above a b)))))
"""


def derived_by_hand(facts: set[tuple[str, ...]]) -> tuple[set[str], bool]:
    """The legal actions, and whether the goal holds."""
    blocks = "abcd"
    on = {each[1:] for each in facts if each[0] == "on"}
    held = {each[1] for each in facts if each[0] == "held"}
    above = set(on)
    for z in blocks:
        above |= {(x, y) for x in blocks for y in blocks if (x, z) in above and (z, y) in above}
    clear = {x for x in blocks if x not in held and not any((y, x) in on for y in blocks)}
    top = {x for x in clear if any((x, y) in above for y in blocks)}
    found = {f"take {x}" for x in clear if not held} | {f"lay {x}" for x in held}
    found |= {f"put {x} {y}" for x in held for y in clear if y in top or not above}
    return found, ("c", "a") in above and "d" in top and ("a", "b") not in above


def test_derived_predicates(tmp_path: Path) -> None:
    """Recursive ones, and negations of them, against what they mean, written down in Python."""
    domain, rng, goals = opened(*written(tmp_path, DERIVED, DERIVED_PROBLEM)), Random(1), 0
    for _ in range(30):
        state = domain.problem(1)
        for _ in range(20):
            facts, _ = named_facts(domain, state)
            assert {each[0] for each in facts} <= {"on", "held"}, "what is derived is no part of a state"
            wanted, goal = derived_by_hand(facts)
            status, actions = domain.situation(state)
            goals += goal
            assert (status == "goal") == goal
            if status != "running":
                break
            assert {" ".join(named_action(domain, each)) for each in actions} == wanted
            state, _ = facts_after(domain, state, tuple(rng.choice(sorted(wanted)).split()))
    assert goals


CHANCE = """
(define (domain chance)
  (:requirements :probabilistic-effects :conditional-effects :rewards :typing :negative-preconditions)
  (:types coin)
  (:predicates (heads ?c - coin) (lost ?c - coin) (lucky) (done))
  (:action toss :parameters (?c - coin) :precondition (not (lost ?c))
    :effect (and (probabilistic 1/2 (heads ?c) 0.4 (not (heads ?c)) 0.1 (lost ?c)) (decrease (reward) 1)))
  (:action maybe :parameters () :effect (probabilistic 0.25 (lucky)))
  (:action nested :parameters (?c - coin)
    :effect (probabilistic 0.5 (and (heads ?c) (probabilistic 0.5 (lost ?c) 0.25 (lucky)))
      0.2 (probabilistic 0.5 (done))))
  (:action two :parameters (?a ?b - coin)
    :effect (and (probabilistic 0.5 (heads ?a)) (probabilistic 0.5 (and (lost ?b) (not (heads ?a))))))
  (:action inside :parameters (?c - coin)
    :effect (and (when (lucky) (probabilistic 0.7 (and (not (lucky)) (increase (reward) 5)) 0.3 (done)))
      (forall (?x - coin) (when (heads ?x) (lost ?x)))))
  (:action sure :parameters () :effect (and (probabilistic 1.0 (done)) (probabilistic 0 (lucky)))))
"""
CHANCE_PROBLEM = """
(define (problem p) (:domain chance) (:objects a b - coin) (:init (heads a))
  (:goal (and (done) (lost a))) (:goal-reward 100) (:metric maximize (reward)))
"""


def distribution(domain: PddlDomain, state: State, name: str) -> dict[str, float]:
    """The probability of each set of facts that an action may lead to."""
    found: dict[str, float] = {}
    for action, outcomes in domain.neighbours(state):
        if " ".join(named_action(domain, action)) == name:
            assert sum(each.probability for each in outcomes) == pytest.approx(1)
            for outcome in outcomes:
                text = ", ".join(sorted(" ".join(each) for each in named_facts(domain, outcome.state)[0]))
                found[text] = found.get(text, 0) + outcome.probability
    return found


@pytest.mark.parametrize(
    ("before", "action", "wanted"),
    [
        ((), "toss a", {"heads a": 0.5, "": 0.4, "heads a, lost a": 0.1}),
        ((), "maybe", {"heads a, lucky": 0.25, "heads a": 0.75}),
        (
            (),
            "nested b",
            {
                "heads a, heads b, lost b": 0.25,
                "heads a, heads b, lucky": 0.125,
                "heads a, heads b": 0.125,
                "done, heads a": 0.1,
                "heads a": 0.4,
            },
        ),
        (
            (),
            "two b a",
            {"heads a": 0.25, "heads a, heads b": 0.25, "heads a, lost a": 0.25, "heads a, heads b, lost a": 0.25},
        ),
        ((), "two a b", {"heads a": 0.5, "heads a, lost b": 0.25, "lost b": 0.25}),
        ((), "inside b", {"heads a, lost a": 1}),
        (("maybe",), "inside b", {"heads a, lost a": 0.7, "done, heads a, lost a, lucky": 0.3}),
        ((), "sure", {"done, heads a": 1}),
    ],
)
def test_distributions(before: tuple[str, ...], action: str, wanted: dict[str, float], tmp_path: Path) -> None:
    """What an effect may lead to is what the file says, and what is added stays where another effect deletes it."""
    domain = opened(*written(tmp_path, CHANCE, CHANCE_PROBLEM))
    state = domain.problem(1)
    for name in before:
        state = max(dict(domain.neighbours(state))[name], key=lambda each: len(each.state)).state
    assert distribution(domain, state, action) == pytest.approx(wanted)


def test_rewards(tmp_path: Path) -> None:
    """What each action gains, and the goal's reward once it is reached."""
    domain, rng = opened(*written(tmp_path, CHANCE, CHANCE_PROBLEM)), np.random.default_rng(0)
    start = domain.problem(1)
    assert {domain.act(start, ("toss", "a"), rng)[0] for _ in range(10)} == {-1}
    lucky = max(dict(domain.neighbours(start))["maybe"], key=lambda each: len(each.state)).state
    found = set()
    for _ in range(30):
        reward, following = domain.act(lucky, ("inside", "a"), rng)
        found.add((reward, domain.situation(following).status))
    assert found == {(5, "running"), (100, "goal")}
    assert domain.act(start, ("inside", "b"), rng)[0] == 0
