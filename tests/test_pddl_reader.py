"""PDDL files as they are read: what they mean, and every mistake with its place."""

from __future__ import annotations

import re
import time
from pathlib import Path

import pytest

from nppg.errors import NppgError
from nppg.pddl.model import (
    Add,
    And,
    Arithmetic,
    Atom,
    Change,
    Compare,
    Delete,
    Domain,
    Each,
    Equal,
    Exists,
    Forall,
    Metric,
    Not,
    Or,
    PlanningProblem,
    Probabilistic,
    Symbol,
    Together,
    Typed,
    Value,
    When,
)
from nppg.pddl.reader import read_domain, read_problem
from nppg.pddl.tokens import DEEPEST

HARBOUR = """
; Ships carry crates between quays.
(define (domain Harbour)
  (:requirements :strips :typing :adl :action-costs)
  (:types ship tug - vessel vessel crate - thing quay)
  (:constants home - quay)
  (:predicates (at ?x - thing ?q - quay) (in ?c - crate ?v - vessel) (free ?v - vessel) (calm))
  (:functions (fuel ?v - vessel) - number (far ?p ?q - quay) (total-cost) - number)
  (:action SAIL
    :parameters (?v - vessel ?p ?q - quay)
    :precondition (and (at ?v ?p) (not (= ?p ?q)) (>= (fuel ?v) (* 2 (far ?p ?q))))
    :effect (and (not (at ?v ?p)) (at ?v ?q) (decrease (fuel ?v) (far ?p ?q)) (increase (total-cost) 1.5))))
"""
TRIP = """
(define (problem Trip) (:domain harbour)
  (:objects s - ship t - tug c1 c2 - crate east west - quay)
  (:init (at S East) (at c1 west) (free s) (= (fuel s) 10) (= (far east west) 2.5) (not (calm)))
  (:goal (and (at s west) (exists (?c - crate) (in ?c s))))
  (:metric minimize (total-cost)))
"""
SMALL = "(define (domain small) (:types a b) (:predicates (p ?x - a) (q ?x - b) (r)) {})"


def domain_in(folder: Path, text: str) -> Domain:
    path = folder / "domain.pddl"
    path.write_text(text, encoding="utf-8")
    return read_domain(path)


def problem_in(folder: Path, text: str, domain_text: str = HARBOUR) -> PlanningProblem:
    path = folder / "problem.pddl"
    path.write_text(text, encoding="utf-8")
    return read_problem(path, domain_in(folder, domain_text))


def places(error: pytest.ExceptionInfo[NppgError]) -> list[tuple[int, int, str]]:
    return [(each.line, each.column, each.message) for each in error.value.problems]


def domain_mistakes(folder: Path, text: str) -> list[str]:
    with pytest.raises(NppgError) as error:
        domain_in(folder, text)
    return [each.message for each in error.value.problems]


def problem_mistakes(folder: Path, text: str, domain_text: str = HARBOUR) -> list[str]:
    with pytest.raises(NppgError) as error:
        problem_in(folder, text, domain_text)
    return [each.message for each in error.value.problems]


def with_action(precondition: str = "()", effect: str = "()", parameters: str = "?x - a ?y - b") -> str:
    return SMALL.format(
        f"(:action act :parameters ({parameters}) :precondition {precondition} :effect {effect})"
        "(:functions (cost ?x - a) (heat))"
    )


def effect_of(folder: Path, text: str) -> object:
    return domain_in(folder, with_action(effect=text)).actions[0].effect


def precondition_of(folder: Path, text: str) -> object:
    return domain_in(folder, with_action(precondition=text)).actions[0].precondition


def test_a_domain_is_read_as_data(tmp_path: Path) -> None:
    domain = domain_in(tmp_path, HARBOUR)
    assert domain.file == str(tmp_path / "domain.pddl")
    assert domain.name == "harbour" and domain.source == HARBOUR
    assert domain.requirements == (":strips", ":typing", ":adl", ":action-costs")
    assert domain.types == {
        "ship": ("vessel",),
        "tug": ("vessel",),
        "vessel": ("thing",),
        "crate": ("thing",),
        "quay": ("object",),
        "thing": ("object",),
    }
    assert domain.constants == (Typed("home", ("quay",)),)
    assert domain.predicates[0] == Symbol("at", (Typed("?x", ("thing",)), Typed("?q", ("quay",))))
    assert [each.name for each in domain.functions] == ["fuel", "far", "total-cost"]
    (sail,) = domain.actions
    assert sail.name == "sail"
    assert sail.parameters == (Typed("?v", ("vessel",)), Typed("?p", ("quay",)), Typed("?q", ("quay",)))
    needed = Compare(">=", Value("fuel", ("?v",)), Arithmetic("*", (2, Value("far", ("?p", "?q")))))
    assert sail.precondition == And((Atom("at", ("?v", "?p")), Not(Equal("?p", "?q")), needed))
    assert sail.effect == Together(
        (
            Delete(Atom("at", ("?v", "?p"))),
            Add(Atom("at", ("?v", "?q"))),
            Change("decrease", Value("fuel", ("?v",)), Value("far", ("?p", "?q"))),
            Change("increase", Value("total-cost", ()), 1.5),
        )
    )


def test_a_problem_is_read_as_data(tmp_path: Path) -> None:
    problem = problem_in(tmp_path, TRIP)
    assert (problem.name, problem.domain) == ("trip", "harbour")
    assert problem.objects[0] == Typed("s", ("ship",)) and len(problem.objects) == 6
    assert problem.init == (Atom("at", ("s", "east")), Atom("at", ("c1", "west")), Atom("free", ("s",)))
    assert problem.values == ((Value("fuel", ("s",)), 10), (Value("far", ("east", "west")), 2.5))
    crate = (Typed("?c", ("crate",)),)
    assert problem.goal == And((Atom("at", ("s", "west")), Exists(crate, Atom("in", ("?c", "s")))))
    assert problem.metric == Metric("minimize", Value("total-cost", ()))
    assert problem.goal_reward == 0


def test_formulas(tmp_path: Path) -> None:
    p, q = Atom("p", ("?x",)), Atom("q", ("?y",))
    assert precondition_of(tmp_path, "()") == And(())
    assert precondition_of(tmp_path, "(imply (p ?x) (q ?y))") == Or((Not(p), q))
    assert precondition_of(tmp_path, "(or (p ?x) (q ?y))") == Or((p, q))
    both = (Typed("?z", ("a", "b")),)
    assert precondition_of(tmp_path, "(forall (?z - (either a b)) (p ?z))") == Forall(both, Atom("p", ("?z",)))
    assert precondition_of(tmp_path, "(= (heat) 3)") == Compare("=", Value("heat", ()), 3)
    assert precondition_of(tmp_path, "(< (- heat) .5)") == Compare("<", Arithmetic("-", (Value("heat", ()),)), 0.5)


def test_effects(tmp_path: Path) -> None:
    added, deleted = Add(Atom("p", ("?x",))), Delete(Atom("q", ("?y",)))
    assert effect_of(tmp_path, "()") == Together(())
    assert effect_of(tmp_path, "(when (r) (not (q ?y)))") == When(Atom("r", ()), deleted)
    everything = (Typed("?z", ("object",)),)
    assert effect_of(tmp_path, "(forall (?z) (p ?z))") == Each(everything, Add(Atom("p", ("?z",))))
    assert effect_of(tmp_path, "(probabilistic 1/3 (p ?x) 0.25 (not (q ?y)))") == Probabilistic(
        ((1 / 3, added), (0.25, deleted))
    )
    assert effect_of(tmp_path, "(and (when (r) (probabilistic 1 (p ?x))))") == Together(
        (When(Atom("r", ()), Probabilistic(((1, added),))),)
    )
    assert effect_of(tmp_path, "(scale-up (cost ?x) 2)") == Change("scale-up", Value("cost", ("?x",)), 2)


def test_thirds_sum_to_one(tmp_path: Path) -> None:
    effect = effect_of(tmp_path, "(probabilistic 1/3 (r) 1/3 (p ?x) 1/3 (q ?y))")
    assert isinstance(effect, Probabilistic) and len(effect.branches) == 3


def test_rewards(tmp_path: Path) -> None:
    text = "(define (domain paid) (:requirements :mdp) (:action work :effect (increase (reward) 5)))"
    domain = domain_in(tmp_path, text)
    assert domain.functions == (Symbol("reward", ()),)
    assert domain.actions[0].effect == Change("increase", Value("reward", ()), 5)
    goal = "(:goal (and)) (:goal-reward 10) (:metric maximize (reward))"
    problem = problem_in(tmp_path, f"(define (problem 0) (:domain paid) (:init) {goal})", text)
    assert problem.goal_reward == 10 and problem.metric == Metric("maximize", Value("reward", ()))
    endless = "(define (problem 0) (:domain paid) (:init) (:metric maximize (reward)))"
    assert problem_in(tmp_path, endless, text).goal == Or(())


def test_a_predicate_may_be_called_like_a_predeclared_function(tmp_path: Path) -> None:
    text = "(define (domain d) (:predicates (reward)) (:action win :effect (reward)))"
    assert domain_in(tmp_path, text).functions == ()


def test_derived_predicates(tmp_path: Path) -> None:
    rule = "(:derived (p ?x) (exists (?y - b) (and (q ?y) (not (r)))))"
    (derived,) = domain_in(tmp_path, SMALL.format(rule)).derived
    assert (derived.name, derived.parameters) == ("p", (Typed("?x", ("a",)),))
    body = And((Atom("q", ("?y",)), Not(Atom("r", ()))))
    assert derived.body == Exists((Typed("?y", ("b",)),), body)


def test_sloppy_files_are_read(tmp_path: Path) -> None:
    domain = domain_in(
        tmp_path,
        """(DEFINE (DOMAIN sloppy)
        (:action move :effect (on a@1 b.2) :parameters () :precondition ( ))
        (:actions move)
        (:predicates (on ?x - thing ?x - thing) (= ?x ?y))
        (:constants a@1 b.2 - thing)
        (:types thing - whatever object))""",
    )
    assert domain.types == {"thing": ("whatever",), "whatever": ("object",)}
    assert domain.actions[0].effect == Add(Atom("on", ("a@1", "b.2")))
    problem = problem_in(
        tmp_path,
        """\ufeff(define (problem 0)
        (:goal (on a@1 7))
        (:init (and (on a@1 b.2) (on a@1 b.2)) (= (total-cost) 0))
        (:length (:serial 3)) (:domain SLOPPY)
        (:objects a@1 - thing 7 - thing)
        (:metric minimize (total-time)))""",
        domain.source,
    )
    assert problem.objects == (Typed("7", ("thing",)),)
    assert problem.init == (Atom("on", ("a@1", "b.2")),)
    assert problem.values == ()


def test_a_file_may_have_a_domain_and_its_problem(tmp_path: Path) -> None:
    domain = domain_in(tmp_path, HARBOUR + TRIP)
    assert read_problem(tmp_path / "domain.pddl", domain).name == "trip"


def test_types_below_several(tmp_path: Path) -> None:
    text = """(define (domain d) (:types amphibian - (either boat car) boat car - vehicle)
    (:predicates (swims ?x - boat) (drives ?x - car))
    (:action go :parameters (?x - boat) :precondition (drives ?x) :effect (swims ?x)))"""
    assert domain_in(tmp_path, text).types["amphibian"] == ("boat", "car")


def test_all_mistakes_come_at_once_and_in_order(tmp_path: Path) -> None:
    (tmp_path / "bad.pddl").write_text(
        """(define (domain bad)
  (:requirements :strips :typng)
  (:types block)
  (:predicates (on ?x ?y - block) (clear ?x - blok))
  (:action move
    :parameters (?x - block ?x - block)
    :precondition (and (onn ?x ?y) (on ?x))
    :efect (clear ?x)))
""",
        encoding="utf-8",
    )
    with pytest.raises(NppgError) as error:
        read_domain(tmp_path / "bad.pddl")
    assert places(error) == [
        (2, 26, "unknown requirement ':typng' (did you mean ':typing'?)"),
        (4, 47, "the type 'blok' is not declared (did you mean 'block'?)"),
        (6, 29, "the variable ?x is declared twice"),
        (7, 24, "unknown predicate 'onn' (did you mean 'on'?)"),
        (7, 36, "on/2 is used with 1 argument"),
        (8, 5, "unknown keyword ':efect' of the action 'move' (did you mean ':effect'?)"),
    ]
    assert {each.file for each in error.value.problems} == {str(tmp_path / "bad.pddl")}


@pytest.mark.parametrize(
    ("text", "line", "column", "message"),
    [
        ("", 1, 1, "the file is empty"),
        ("; nothing\n", 1, 1, "the file is empty"),
        ("action: move", 1, 1, "not PDDL: a file begins with '(define', not with 'action:'"),
        ("(domain d)", 1, 1, "not PDDL: (define (domain name) ...) or (define (problem name) ...) is wanted"),
        ("(define (domain d)\n  (:types a)", 1, 1, "this parenthesis is never closed"),
        ("(define (domain d)\n  (:types a\n  (:predicates (p)))", 2, 3, "this parenthesis is never closed"),
        ("(define (domain d)))", 1, 20, "this parenthesis closes nothing: there is one too many"),
        (
            "(define (domain d))\n(:types a))",
            1,
            19,
            "this parenthesis closes the file's first one, but more follows",
        ),
        ("(define (domain d)) end", 1, 21, "'end' stands outside of all parentheses"),
        ("(define (domain d) (:types a\0))", 1, 29, "the character '\\x00' has no place in PDDL"),
        ("(define (domain d) (:types " + "a" * 1001 + "))", 1, 28, "a word of 1001 characters, more than 1000"),
        (
            "(define (domain d) " + "(" * 100_000,
            1,
            19 + DEEPEST,
            f"nested too deeply: more than {DEEPEST} parentheses are open",
        ),
        ("(define (problem d))", 1, 1, "a domain is expected, not a problem"),
        ("(define (domain))", 1, 9, "the domain has one name, as in (domain name)"),
        ("(define (domain ?d))", 1, 17, "a name of a domain is wanted, not '?d'"),
        ("(define (domain d) types)", 1, 20, "a section like (:keyword ...) is wanted, not 'types'"),
    ],
)
def test_files_that_are_no_domain(tmp_path: Path, text: str, line: int, column: int, message: str) -> None:
    with pytest.raises(NppgError) as error:
        domain_in(tmp_path, text)
    assert places(error) == [(line, column, message)]


def test_the_deepest_that_is_read(tmp_path: Path) -> None:
    depth = DEEPEST - 3
    domain_in(tmp_path, with_action(precondition="(and " * depth + "(r)" + ")" * depth))
    domain_in(tmp_path, with_action(effect="(when (r) " * depth + "(r)" + ")" * depth))


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(NppgError, match="no such file"):
        read_domain(tmp_path / "none.pddl")
    with pytest.raises(NppgError, match="is a directory"):
        read_domain(tmp_path)
    (tmp_path / "latin.pddl").write_bytes("(define (domain d)\n (:types caf\u00e9))".encode("latin-1"))
    with pytest.raises(NppgError) as error:
        read_domain(tmp_path / "latin.pddl")
    assert places(error) == [(2, 13, "not UTF-8: the byte 0xe9 has no meaning here")]
    with open(tmp_path / "large.pddl", "wb") as stream:
        stream.truncate(50_000_001)
    with pytest.raises(NppgError, match="is larger than 50 MB"):
        read_domain(tmp_path / "large.pddl")


@pytest.mark.parametrize(
    ("section", "message"),
    [
        ("(:types a)", "the section ':types' comes twice (first on line 1)"),
        ("(:requirements :durative-actions)", "the requirement ':durative-actions' is not supported"),
        ("(:requirements :preferences)", "the requirement ':preferences' is not supported"),
        ("(:durative-action go)", "':durative-action' is not supported (:durative-actions)"),
        ("(:process flow)", "':process' is not supported (:continuous-effects)"),
        ("(:event rain)", "':event' is not supported (:continuous-effects)"),
        ("(:constraints (and))", "':constraints' is not supported (:constraints)"),
        ("(:acton go)", "unknown section ':acton' (did you mean ':action'?)"),
        ("(:constants c - a c - a)", "the constant 'c' is declared twice (first on line 1)"),
        ("(:constants c -a)", "'-a': a space is wanted behind the '-'"),
        ("(:constants c -)", "a type is wanted behind the '-'"),
        ("(:constants - a)", "a type of nothing: a constant is wanted before the '-'"),
        ("(:constants ?c)", "a name of a constant is wanted, not '?c'"),
        ("(:functions (f ?x - a) (f))", "the function 'f' is declared twice (first on line 1)"),
        ("(:functions (f ?x - a) - b)", ":object-fluents are not supported: a function of type 'b'"),
        ("(:action)", "the name of an action is wanted"),
        ("(:action go) (:action go)", "the action 'go' is declared twice (first on line 1)"),
        ("(:action go :precondition :effect (r))", "':precondition' has nothing behind it"),
        ("(:action go :effect (r) :effect (r))", "':effect' comes twice in the action 'go'"),
        ("(:action go :duration 5)", "':duration' is not supported (:durative-actions)"),
        ("(:action go :parameters (x - a))", "a variable is wanted, not 'x' (did you mean '?x'?)"),
        ("(:derived (r))", "a derived predicate is given like (:derived (name ?x - type) condition)"),
        ("(:derived (rr) (r))", "the derived predicate 'rr' is not among the predicates (did you mean 'r'?)"),
        ("(:derived (p) (r))", "p/1 is derived with 0 parameters"),
        ("(:derived (p ?x - b) (r))", "?x is of type b; p is declared with type a"),
        ("(:derived (r) (not (r)))", "derived through its own negation: r, not r"),
        (
            "(:derived (p ?x) (r)) (:derived (r) (exists (?y) (imply (p ?y) (q ?y))))",
            "derived through its own negation: r, not p, r",
        ),
        ("(:derived (r) (q c))", "unknown constant 'c'"),
        (
            "(:derived (p ?x) (r)) (:action go :effect (r)) (:derived (r) (and))",
            "'r' is derived: an effect cannot change it",
        ),
    ],
)
def test_sections_with_a_mistake(tmp_path: Path, section: str, message: str) -> None:
    assert domain_mistakes(tmp_path, SMALL.format(section)) == [message]


@pytest.mark.parametrize(
    ("types", "message"),
    [
        ("a - b b - c c - a", "types are below themselves: a, b, c"),
        ("a - a", "types are below themselves: a"),
        ("a b a", "the type 'a' is declared twice (first on line 1)"),
        ("object - a a", "the type 'object' has no type above it"),
        ("a - (neither b)", "a name of a type is wanted, not '(neither ...)'"),
    ],
)
def test_types_with_a_mistake(tmp_path: Path, types: str, message: str) -> None:
    assert domain_mistakes(tmp_path, f"(define (domain d) (:types {types}))") == [message]


def test_recursion_that_is_not_through_negation(tmp_path: Path) -> None:
    text = """(define (domain d) (:predicates (on ?x ?y) (over ?x ?y) (low ?x))
    (:derived (over ?x ?y) (or (on ?x ?y) (exists (?z) (and (on ?x ?z) (over ?z ?y)))))
    (:derived (low ?x) (not (exists (?y) (over ?x ?y)))))"""
    assert len(domain_in(tmp_path, text).derived) == 2


@pytest.mark.parametrize(
    ("condition", "message"),
    [
        ("(p ?z)", "the variable ?z is not declared"),
        ("(p ?y)", "?y is of type b; argument 1 of p is of type a"),
        ("(pp ?x)", "unknown predicate 'pp' (did you mean 'p'?)"),
        ("(p thing)", "unknown constant 'thing'"),
        ("(p (cost ?x))", "a variable or an object is wanted, not '(cost ...)' (:object-fluents)"),
        ("(cost ?x)", "'cost' is a function, not a predicate"),
        ("r", "a formula is wanted, not 'r' (did you mean '(r)'?)"),
        ("(and ())", "a formula is wanted, not '()'"),
        ("(not (r) (r))", "'not' has 1 part, not 2"),
        ("(when (r) (r))", "'when' has no place in a condition"),
        ("(preference late (r))", "'preference' is not supported (:preferences)"),
        ("(exists (?z - c) (p ?z))", "the type 'c' is not declared"),
        ("(> (cost ?x) (r))", "'r' is a predicate, not a function"),
        ("(> (cost ?x ?y) 1)", "cost/1 is used with 2 arguments"),
        ("(> (cst ?x) 1)", "unknown function 'cst' (did you mean 'cost'?)"),
        ("(> heat nan)", "a number or a function is wanted, not 'nan'"),
        ("(> heat (/ 1 2 3))", "'/' has two operands, not 3"),
    ],
)
def test_conditions_with_a_mistake(tmp_path: Path, condition: str, message: str) -> None:
    assert domain_mistakes(tmp_path, with_action(precondition=condition)) == [message]


@pytest.mark.parametrize(
    ("effect", "message"),
    [
        ("(q ?x)", "?x is of type a; argument 1 of q is of type b"),
        ("(or (r) (p ?x))", "'or' has no place in an effect"),
        ("(not (and (r)))", "'and' has no place in an effect"),
        ("(= ?x ?y)", "'=' has no place in an effect"),
        ("(oneof (r) (p ?x))", "'oneof' is not supported (:non-deterministic)"),
        ("(increase (heat) (* #t 2))", "'#t' is not supported (:continuous-effects)"),
        ("(probabilistic 0.5 (r) 0.6 (p ?x))", "the probabilities sum to 1.1, above 1"),
        ("(probabilistic 0.5)", "'probabilistic' has pairs of a probability and an effect"),
        ("(probabilistic 1.5 (r))", "a probability is a number from 0 to 1, not '1.5'"),
        ("(probabilistic 1/0 (r))", "a probability is a number from 0 to 1, not '1/0'"),
        ("(probabilistic (heat) (r))", "a probability is a number like 0.5 or 1/2, not '(heat ...)'"),
    ],
)
def test_effects_with_a_mistake(tmp_path: Path, effect: str, message: str) -> None:
    assert domain_mistakes(tmp_path, with_action(effect=effect)) == [message]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("(:domain harbour)", "(:domain ferry)", ":domain harbour is expected, not ferry"),
        ("(:domain harbour)", "", "the problem has no (:domain harbour)"),
        ("- tug", "- tag", "the type 'tag' is not declared (did you mean 'tug'?)"),
        ("c1 c2", "c1 c1", "the object 'c1' is declared twice (first on line 3)"),
        ("west - quay", "west - quay home - crate", "'home' is a constant of the domain, of type quay"),
        ("(free s)", "(fre s)", "unknown predicate 'fre' (did you mean 'free'?)"),
        ("(free s)", "(free s s)", "free/1 is used with 2 arguments"),
        ("(free s)", "(free c2)", "c2 is of type crate; argument 1 of free is of type vessel"),
        ("(free s)", "(free weest)", "unknown object 'weest' (did you mean 'west'?)"),
        ("(free s)", "free", "a fact like (name object ...) is wanted, not 'free'"),
        ("(free s)", "(at 5 (free s))", "a timed fact is not supported (:timed-initial-literals)"),
        ("(free s)", "(oneof (free s))", "'oneof' is not supported in :init (a random initial state)"),
        (
            "(free s)",
            "(probabilistic 1 (free s))",
            "'probabilistic' is not supported in :init (a random initial state)",
        ),
        ("(fuel s) 10", "(fuel s) inf", "a finite number is wanted, not 'inf'"),
        ("(fuel s) 10", "(fuel s) 1e999", "a finite number is wanted, not '1e999'"),
        ("(= (fuel s) 10)", "(fuel s)", "'fuel' is a function; its value is given like (= (fuel ...) 5)"),
        ("(= (fuel s) 10)", "(= (fuel s) 10) (= (fuel s) 9)", "'fuel' has two values here"),
        ("(in ?c s)", "(in ?d s)", "the variable ?d is not declared"),
        ("(at s west)", "(at east west)", "east is of type quay; argument 1 of at is of type thing"),
        (
            "(:metric minimize",
            "(:metric minimise",
            "(:metric minimize expression) or (:metric maximize expression) is wanted (did you mean 'minimize'?)",
        ),
        ("(total-cost)", "(is-violated late)", "'is-violated' is not supported (:preferences)"),
        ("(:metric", "(:goals) (:metric", "':goals' is not supported (write one (:goal (and ...)))"),
    ],
)
def test_problems_with_a_mistake(tmp_path: Path, old: str, new: str, message: str) -> None:
    assert old in TRIP
    assert problem_mistakes(tmp_path, TRIP.replace(old, new, 1)) == [message]


def test_a_type_that_is_missing_is_told_once(tmp_path: Path) -> None:
    assert problem_mistakes(tmp_path, TRIP.replace("- quay)", "-)")) == ["a type is wanted behind the '-'"]


def test_a_problem_without_its_sections(tmp_path: Path) -> None:
    assert problem_mistakes(tmp_path, "(define (problem p) (:domain harbour))") == [
        "the problem has no (:goal ...)",
        "the problem has no (:init ...)",
    ]
    assert problem_mistakes(tmp_path, HARBOUR) == ["a problem is expected, not a domain"]


def test_what_is_derived_is_not_given(tmp_path: Path) -> None:
    text = "(define (problem p) (:domain small) (:init (r)) (:goal (r)))"
    messages = problem_mistakes(tmp_path, text, SMALL.format("(:derived (r) (exists (?x) (p ?x)))"))
    assert messages == ["'r' is derived: it cannot be given in :init"]


def test_messages_are_one_line_each(tmp_path: Path) -> None:
    with pytest.raises(NppgError) as error:
        domain_in(tmp_path, with_action(precondition="(and (pp ?x)\n (q ?x))", effect="(not\n r)"))
    lines = str(error.value).splitlines()
    assert len(lines) == 3 and all(re.match(r".*domain\.pddl:\d+:\d+: ", line) for line in lines)


def test_large_files_are_read_in_time(tmp_path: Path) -> None:
    domain = domain_in(tmp_path, "(define (domain grid) (:types cell) (:predicates (next ?x ?y - cell)))")
    cells = " ".join(f"c{index}" for index in range(5_000))
    body = f"(:domain grid) (:objects {cells} - cell) (:goal (and))"
    facts = "\n".join(f"(next c{index} c{index + 1})" for index in range(4_999))
    wrong = "\n".join(f"(next d{index} e{index + 1})" for index in range(4_999))
    path = tmp_path / "problem.pddl"
    start = time.process_time()
    path.write_text(f"(define (problem p) {body} (:init {facts}))", encoding="utf-8")
    assert len(read_problem(path, domain).init) == 4_999
    path.write_text(f"(define (problem p) {body} (:init {wrong}))", encoding="utf-8")
    with pytest.raises(NppgError) as error:
        read_problem(path, domain)
    assert len(error.value.problems) == 2 * 4_999
    assert time.process_time() - start < 10
