"""What a user is told about mistakes in a domain or a model: one clear, located message, whatever they are."""

from __future__ import annotations

import gc
import re
import shutil
import subprocess
import sys
from pathlib import Path

import janus_swi
import numpy as np
import pytest
from samples import resigned

import nppg.bridge.prolog
from nppg import Domain, LanguageBias, NppgError, Options, Policy, train
from nppg.answers.coverage import root_table
from nppg.bias.refinement import Refiner

PARTS = {
    "head": ":- module(walk, []).\n:- fluent at/1.\n",
    "parameter": ":- parameter(size, 3).\n",
    "start": "start([at(Size)]) :- parameter(size, Size), Size > 0.\n",
    "action": "action(left).\naction(right).\n",
    "effect": (
        "effect(left, [at(X)], [at(Y)]) :- at(X), Y is X - 1.\neffect(right, [at(X)], [at(Y)]) :- at(X), Y is X + 1.\n"
    ),
    "goal": "goal :- home.    home :- at(0).\n",
    "more": "",
}
BIAS = "action: [left, right]\ntypes: {home: []}\nmodes: [home]\n"


def text(**changed: str) -> str:
    return "".join((PARTS | changed).values())


def play(domain: Domain) -> None:
    """Runs every predicate of the contract."""
    rng = np.random.default_rng(0)
    state = domain.start(rng)
    domain.horizon(state)
    actions = domain.situation(state).actions
    domain.expert_actions(state)
    domain.neighbours(state)
    domain.parts(state)
    for action in actions:
        domain.act(state, action, rng)


def problem(folder: Path, source: str | bytes, trust: bool = False, **parameters: object) -> str:
    """What NppgError says, without the path of the file; every problem must be fit for the user's eyes."""
    file = folder / "walk.pl"
    file.write_bytes(source if isinstance(source, bytes) else source.encode())
    with pytest.raises(NppgError) as caught:
        play(Domain(file, parameters, trust))
    for each in caught.value.problems:
        assert "#" not in each.message and "\n" not in each.message
        assert not re.search(r"\b_[G\d]\d+|nppg_", each.message), "an internal name"
        assert len(each.message) < 1500
        assert each.file == str(file)
    return str(caught.value).replace(f"{file}:", "")


LOOPS = {
    "plain": "repeat, fail",
    "counting": "between(1, inf, _), fail",
    "swallowed as failure": "catch((repeat, fail), _, fail)",
    "swallowed as truth": "catch((repeat, fail), _, true)",
    "swallowed again and again": "repeat, catch((repeat, fail), _, fail)",
    "swallowed by recursion": "again",
}
AGAIN = "again :- catch((repeat, fail), _, true), again.\n"
HEADS = {
    "start/1": ("start", "start([at(1)])"),
    "action/1": ("action", "action(left)"),
    "effect/3": ("effect", "effect(_, [], [])"),
    "goal/0": ("goal", "goal"),
    "terminal/0": ("more", "terminal"),
    "reward/2": ("more", "reward(_, 1)"),
    "horizon/1": ("more", "horizon(1)"),
    "expert/1": ("more", "expert(left)"),
}


def with_body(predicate: str, body: str) -> str:
    part, head = HEADS[predicate]
    return text(**{part: f"{head} :- {body}.\n"}) + AGAIN


@pytest.mark.parametrize("body", LOOPS.values(), ids=LOOPS)
@pytest.mark.parametrize("predicate", HEADS)
def test_loops(tmp_path: Path, predicate: str, body: str) -> None:
    message = problem(tmp_path, with_body(predicate, body))
    assert f"{predicate} took more than 1,000,000 inferences (does it loop?)" in message
    assert re.match(r"\d+: ", message), "the line"


BODIES = {
    "X is foo + 1, X > 0": "threw Arithmetic",
    "G =.. [nonesuch, 1], call(G)": "threw Unknown procedure: nonesuch/1",
    "G =.. [paramter, size, _], call(G)": "threw Unknown procedure: paramter/2 ",
    "throw(my_error(_))": "threw my_error(_)",
    "throw(_)": "threw",
    "atom_length(L, L)": "threw",
    "halt": "called halt, which would end Python",
    "halt(0)": "called halt, which would end Python",
    "abort": "called abort/0",
    "numlist(1, 900000, L), length(M, 90000000), L = M": "ran out of stack (does it recurse without end?)",
}


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("predicate", HEADS)
def test_exceptions(tmp_path: Path, predicate: str, body: str) -> None:
    message = problem(tmp_path, with_body(predicate, body))
    assert f"{predicate} {BODIES[body]}" in message
    if predicate == "start/1":
        assert "with the parameters [size=3]" in message
    else:
        assert "in the state [at(" in message


LOADING = {
    "no module": ("start([at(2)]).\n", "1: a domain starts with :- module(Name, [])."),
    "no header": (text(head=":- use_module(library(lists)).\n"), "1: a domain starts with :- module(Name, [])."),
    "open name": (text(head=":- module(_, []).\n"), "1: a domain starts with"),
    "empty": ("", "1: a domain starts with"),
    "no text": (b"\xff\xfe\x00garbage\x80", "a domain starts with"),
    "not UTF-8": (text(more="name(caf\xe9).\n").encode("latin-1"), ""),
    "syntax": (
        text(action="action(left.\naction(right).\n", goal="goal :- at(0), .\n"),
        "5:11: Syntax error: Operator expected\n9:15: Syntax error: Unbalanced operator",
    ),
    "unknown predicate": (text(goal="goal :- att(0).\n"), "9: unknown predicate att/1 (did you mean 'at'?)"),
    "unknown random": (text(goal="goal :- random_beween(1, 2, 3).\n"), "(did you mean 'random_between'?)"),
    "no start": (text(start=""), "1: start/1 is missing"),
    "no action": (text(action=""), "1: action/1 is missing"),
    "no effect": (text(effect=""), "1: effect/3 is missing"),
    "no goal": (text(goal=""), "1: neither goal/0, terminal/0 nor reward/2 is defined"),
    "no fluent": (text(head=":- module(walk, []).\n"), "1: no fluent is declared"),
    "fluent without arity": (text(more=":- fluent on.\n"), "10: a fluent is declared by its name and the number"),
    "open fluent": (text(more=":- fluent _.\n"), "10: a fluent is declared by its name and the number"),
    "contract as fluent": (text(more=":- fluent goal/0.\n"), "10: goal/0 is a predicate of the contract"),
    "fluent in the file": (text(more="at(7).\n"), "10: at/1 is a fluent: its facts come from start/1"),
    "parameter alone": (text(more=":- parameter(x).\n"), "10: a parameter is declared by :- parameter(Name, Default)"),
    "parameter twice": (text(more=":- parameter(size, 4).\n"), "10: the parameter size is declared twice"),
    "compound parameter": (text(more=":- parameter(x, f(1)).\n"), "10: a parameter is declared by"),
    "interchangeable pair": (text(more=":- interchangeable at/2.\n"), "10: interchangeable objects are declared by"),
    "interchangeable nobody": (text(more=":- interchangeable block/1.\n"), "1: unknown predicate block/1"),
    "singleton": (text(goal="goal :- at(X).\n"), "9: Singleton variables: [X]"),
    "scattered": (text(more="action(up).\n"), "10: Clauses of action/1 are not together"),
    "redefinition": (
        text(more="atom_length(a, b).\n"),
        "10: atom_length/2 is built into Prolog and cannot be defined anew: choose another name",
    ),
    "built-in fluent": (
        text(more=":- fluent length/2.\n"),
        "10: length/2 is built into Prolog and can be no fluent: choose",
    ),
}


TRUSTED = {
    "directive throws": (text(more=":- throw(oops).\n"), "10: oops"),
    "directive fails": (text(more=":- fail.\n"), "10: Goal (directive) failed: fail"),
    "directive halts": (text(more=":- halt.\n"), "10: halt was called, which would end Python"),
    "directive aborts": (text(more=":- abort.\n"), "10: loading was aborted"),
    "missing include": (text(more=":- include(nonesuch).\n"), "10: source_sink `nonesuch' does not exist"),
    "unknown library": (text(more=":- use_module(library(nonesuch)).\n"), "10: "),
    "expansion of others": (
        text(more="user:term_expansion(a, b).\n"),
        "10: expansion in module user would change other",
    ),
}


@pytest.mark.parametrize("source, message", LOADING.values(), ids=LOADING)
def test_mistakes_in_the_file(tmp_path: Path, source: str | bytes, message: str) -> None:
    assert message in problem(tmp_path, source)


@pytest.mark.parametrize("source, message", TRUSTED.values(), ids=TRUSTED)
def test_mistakes_in_a_file_that_is_trusted(tmp_path: Path, source: str, message: str) -> None:
    assert message in problem(tmp_path, source, trust=True)
    assert "--trust" in problem(tmp_path, source)


RUNNING = {
    "open fact": ({"start": "start([at(_)]).\n"}, "start/1 gave at(_), which is no fact of a declared fluent (it has"),
    "string": ({"start": 'start([at("a")]).\n'}, 'start/1 gave at("a"), which is no fact of a declared fluent (only'),
    "not a number": ({"start": "start([at(X)]) :- X is nan.\n"}, "which is no fact"),
    "cyclic fact": ({"start": "start([at(X)]) :- X = f(X).\n"}, "(it contains itself)"),
    "other fact": ({"start": "start([ta(1)]).\n"}, "start/1 gave ta(1), which is no fact of a declared fluent,"),
    "no list": ({"start": "start(at(1)).\n"}, "start/1 gave at(1) where a list of facts is wanted"),
    "partial list": ({"start": "start([at(1)|_]).\n"}, "start/1 gave [at(1)|_] where a list"),
    "anything": ({"start": "start(_).\n"}, "start/1 gave _ where a list"),
    "start fails": ({"start": "start(_) :- fail.\n"}, "start/1 failed with the parameters [size=3]"),
    "no legal action": ({"action": "action(left) :- at(9).\n"}, "action/1 gave no legal action, though the state is"),
    "open action": ({"action": "action(go(_)).\n"}, "action/1 gave go(_), which is no action (it has"),
    "any action": ({"action": "action(_).\n"}, "action/1 gave _, which is no action"),
    "number as action": ({"action": "action(1).\n"}, "action/1 gave 1, which is no action"),
    "string as action": ({"action": 'action("go").\n'}, 'action/1 gave "go", which is no action'),
    "open expert": ({"more": "expert(_).\n"}, "expert/1 gave _, which is no action"),
    "no effect": ({"effect": "effect(left, [], []).\n"}, "action/1 allows right, which no effect covers"),
    "open effect": ({"effect": "effect(_, [], [at(_)]).\n"}, "effect/3 gave at(_), which is no fact"),
    "any effect": ({"effect": "effect(_, _, []).\n"}, "effect/3 gave _ where a list of facts is wanted"),
    "other effect": ({"effect": "effect(_, [], [ta(1)]).\n"}, "effect/3 gave ta(1), which is no fact"),
    "two effects": (
        {"effect": "effect(_, [], []).\neffect(_, [], [at(4)]).\n"},
        "2 outcomes whose probabilities sum to 2.0000",
    ),
    "sum": (
        {"effect": "effect(_, 0.5, [], []).\neffect(_, 0.3, [], []).\n"},
        "2 outcomes whose probabilities sum to 0.8000",
    ),
    "one outcome": ({"effect": "effect(_, 0.5, [], []).\n"}, "1 outcomes whose probabilities sum to 0.5000"),
    "negative": ({"effect": "effect(_, -1, [], []).\neffect(_, 2, [], []).\n"}, "effect/4 gave -1 as the probability"),
    "name as probability": (
        {"effect": "effect(_, half, [], []).\n"},
        "effect/4 gave half as the probability of an outcome of left",
    ),
    "nan as probability": ({"effect": "effect(_, P, [], []) :- P is nan.\n"}, "as the probability"),
    "reward good": (
        {"more": "reward(_, good).\n"},
        "reward/2 gave good where a finite number is wanted, for the action left",
    ),
    "reward nan": ({"more": "reward(_, R) :- R is nan.\n"}, "where a finite number is wanted"),
    "reward inf": ({"more": "reward(_, R) :- R is inf.\n"}, "reward/2 gave 1.0Inf where a finite number is wanted"),
    "reward fails": ({"more": "reward(up, 1).\n"}, "reward/2 failed for the action left"),
    "horizon half": ({"more": "horizon(2.5).\n"}, "horizon/1 gave 2.5 where a number of steps"),
    "horizon negative": ({"more": "horizon(-1).\n"}, "horizon/1 gave -1 where a number of steps"),
    "horizon endless": (
        {"more": "horizon(N) :- N is 10**400.\n"},
        "where a number of steps from 0 to 1000000000 is wanted",
    ),
    "horizon fails": ({"more": "horizon(1) :- at(9).\n"}, "horizon/1 failed in the state [at(3)]"),
    "parts fail": ({"more": "parts([[a]]) :- at(9).\n"}, "parts/1 gave no list of lists in the state [at(3)]"),
    "parts no list": ({"more": "parts(at(1)).\n"}, "parts/1 gave no list of lists"),
    "parts no lists": ({"more": "parts([at(1)]).\n"}, "parts/1 gave no list of lists"),
    "partial part": ({"more": "parts([[a|_]]).\n"}, "parts/1 gave no list of lists"),
    "open part": ({"more": "parts([[a, f(_)]]).\n"}, "parts/1 gave f(_) in a part (it has an unbound variable)"),
    "string in a part": ({"more": 'parts([["a"]]).\n'}, 'parts/1 gave "a" in a part (only names'),
    "chance in a test": ({"goal": "goal :- random(X), X > 2.\n"}, "goal/0 drew a random number, which only start/1"),
    "long state": (
        {"start": "start(L) :- findall(at(X), between(1, 20000, X), L).\n", "more": "terminal :- X is a, X > 0.\n"},
        "... and 19,980 more]",
    ),
    "long fact": (
        {"start": "start([at(L)]) :- numlist(1, 20000, L).\n", "more": "terminal :- X is a, X > 0.\n"},
        "terminal/0 threw Arithmetic",
    ),
}


@pytest.mark.parametrize("changed, message", RUNNING.values(), ids=RUNNING)
def test_mistakes_of_the_code(tmp_path: Path, changed: dict[str, str], message: str) -> None:
    said = problem(tmp_path, text(**changed))
    assert message in said
    assert re.match(r"\d+: ", said), "the line"


def test_a_directive_that_loops(tmp_path: Path) -> None:
    said = problem(tmp_path, text(more=":- repeat, fail.\n"), trust=True)
    assert said == "10: took more than 100,000,000 inferences to load (does a directive loop?)"


PARAMETERS = [
    ({"sise": 3}, "there is no parameter sise; the domain has size (did you mean 'size'?)"),
    ({"size": "abc"}, "the parameter size must be a whole number, not abc"),
    ({"size": 2.5}, "the parameter size must be a whole number, not 2.5"),
    ({"size": float("nan")}, "the parameter size must be a whole number, not 1.5NaN"),
    ({"size": -1}, "start/1 failed with the parameters [size= -1]"),
]


@pytest.mark.parametrize("parameters, message", PARAMETERS)
def test_parameters(tmp_path: Path, parameters: dict[str, object], message: str) -> None:
    assert message in problem(tmp_path, text(), **parameters)


def test_parameters_of_other_kinds(tmp_path: Path) -> None:
    source = text(more=":- parameter(noise, 0.5).\n:- parameter(name, bob).\n")
    assert "the parameter noise must be a finite number, not 1.0Inf" in problem(tmp_path, source, noise=float("inf"))
    assert "the parameter name must be a name, not 3" in problem(tmp_path, source, name=3)
    assert Domain(tmp_path / "walk.pl", {"noise": 1, "name": "eve"}).parameters == {
        "size": 3,
        "noise": 1,
        "name": "eve",
    }


def test_files(tmp_path: Path) -> None:
    with pytest.raises(NppgError, match="no such file"):
        Domain(tmp_path / "nonesuch.pl")
    with pytest.raises(NppgError, match="did you mean 'blocks_world'"):
        Domain("blocks_word")
    with pytest.raises(NppgError):
        Domain(tmp_path)


def test_garbage(tmp_path: Path) -> None:
    assert "a domain starts with" in problem(tmp_path, np.random.default_rng(0).bytes(1_000_000))
    said = problem(tmp_path, text() + "foo( ].\n" * 2_000)
    assert "Syntax error" in said and len(said) < 10_000


def test_folders_with_spaces(tmp_path: Path) -> None:
    folder = tmp_path / "my domains, ünïcode #1 'x'"
    folder.mkdir()
    (folder / "walk.pl").write_text(text())
    play(Domain(folder / "walk.pl"))
    (folder / "walk.pl").write_text(text(goal="goal :- X is a, X > 0.\n"))
    with pytest.raises(NppgError) as caught:
        play(Domain(folder / "walk.pl"))
    assert str(caught.value).startswith(f"{folder / 'walk.pl'}:9: goal/0 threw Arithmetic")


TERMS = (
    "f('Hello World', '', 'ü', [], [1, [a]], {}, {a}, -1, 3.5, 10000000000000000000000000, 'it''s', '\\n', "
    "a-b, '[]', true, false, none, null, p(), '\\\\', 'a#1', -(1), - 1, 'A', (a :- b, c), 1.0e300, 1.0Inf)"
)


def test_all_terms_cross_the_bridge_and_back(tmp_path: Path) -> None:
    source = text(
        start=f"start([at({TERMS})]).\n", action=f"action({TERMS}).\naction(go).\n", effect="effect(_, [], []).\n"
    )
    (tmp_path / "walk.pl").write_text(source + f"reward(A, 1) :- A == {TERMS}, at({TERMS}).\nreward(go, 0).\n")
    domain = Domain(tmp_path / "walk.pl")
    rng = np.random.default_rng(0)
    state = domain.start(rng)
    assert hash(state) is not None
    domain.forget()
    first, second = domain.situation(state).actions
    domain.forget()
    assert sorted([domain.act(state, first, rng), domain.act(state, second, rng)]) == [(0, state), (1, state)]


@pytest.mark.parametrize(
    ("mistake", "said"),
    {
        "action(_) :- at(2), atom_length(_, _).\n": "action/1 threw Arguments are not",
        "action(up) :- at(2), random(X), X < 2.\n": "action/1 drew a random number",
        "action(_) :- at(2), repeat, fail.\n": "action/1 took more than",
        "goal :- at(2), random(X), X > 2.\n": "goal/0 drew a random number",
    }.items(),
)
def test_a_mistake_in_the_next_situation_is_told_to_who_asks_for_it(tmp_path: Path, mistake: str, said: str) -> None:
    """An action brings the next situation along, but all that it tells of it is what went well."""
    more = {"goal": mistake} if mistake.startswith("goal") else {"action": PARTS["action"] + mistake}
    (tmp_path / "walk.pl").write_text(text(**more, more="reward(_, 0).\n"))
    domain, rng = Domain(tmp_path / "walk.pl"), np.random.default_rng(0)
    reward, state = domain.act(domain.start(rng), "left", rng)
    assert (reward, state) == (0, (("at", 2),))
    with pytest.raises(NppgError, match=f"{said}.*at.2"):
        domain.situation(state)
    assert rng.random() == np.random.default_rng(0).random(), "nothing has been drawn"
    assert domain.situation(domain.act(state, "left", rng)[1]).status == "running"


def test_what_is_allowed(tmp_path: Path) -> None:
    """Libraries, tabling, printing, clauses of its own that change, halt as a name of an action."""
    source = text(
        head=":- module(walk, [goal/0]).\n:- use_module(library(assoc)).\n:- fluent at/1.\n:- table near/1.\n",
        effect="effect(_, [at(99)], [at(1)]).\n",
        goal="goal :- format('~w~n', [hello]), near(0), list_to_assoc([a-1], A), get_assoc(a, A, 2), halt(_).\n",
        more="near(X) :- at(X).\nnear(Y) :- near(X), X > 0, Y is X - 1.\nr(a ===> b).\n",
    ).replace(":- fluent", ":- op(700, xfx, ===>).\n:- fluent")
    (tmp_path / "walk.pl").write_text(source)
    play(Domain(tmp_path / "walk.pl"))


def test_fluents_belong_to_the_state(tmp_path: Path) -> None:
    said = problem(tmp_path, text(goal="goal :- retract(at(X)), X < 0.\n"))
    assert "at(3)" in said and "changed" in said


def test_instances_do_not_mix(tmp_path: Path) -> None:
    for name, size in (("a", 3), ("b", 5)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "walk.pl").write_text(text(parameter=f":- parameter(size, {size}).\n"))
    domains = [Domain(tmp_path / name / "walk.pl", more) for name in "ab" for more in ({}, {"size": 9}) for _ in "12"]
    rng = np.random.default_rng(0)
    assert [domain.start(rng) for domain in domains] == [(("at", n),) for n in (3, 3, 9, 9, 5, 5, 9, 9)]
    states = [domain.start(rng) for domain in domains]
    del domains[::2]
    gc.collect()
    for domain, state in zip(domains, states[1::2], strict=True):
        assert domain.situation(state).status == "running"


def test_dropped_domains_leave_little_behind() -> None:
    def load() -> None:
        domain = Domain("blocks_world")
        domain.situation(domain.start(np.random.default_rng(0)))

    def kilobytes() -> int:
        gc.collect()
        status = Path("/proc/self/status")
        if not status.exists():
            pytest.skip("no /proc")
        return int(re.search(r"VmRSS:\s+(\d+)", status.read_text())[1])  # type: ignore[index]

    for _ in range(20):
        load()
    before = kilobytes()
    for _ in range(200):
        load()
    assert kilobytes() - before < 30_000


def test_what_python_drops_does_not_take_the_cause_of_an_abort(tmp_path: Path, monkeypatch) -> None:
    (tmp_path / "walk.pl").write_text(with_body("goal/0", "abort"))
    domain, others = Domain(tmp_path / "walk.pl"), [Domain("blocks_world")]
    asked = nppg.bridge.prolog.janus_swi.apply_once

    def dropping(*args: object) -> object:
        try:
            return asked(*args)
        except nppg.bridge.prolog.janus_swi.PrologError:
            others.clear()
            raise

    monkeypatch.setattr(nppg.bridge.prolog.janus_swi, "apply_once", dropping)
    with pytest.raises(NppgError, match=f"goal/0 {BODIES['abort']}"):
        play(domain)
    assert not others


def test_halt_from_afar_does_not_end_python(tmp_path: Path) -> None:
    (tmp_path / "walk.pl").write_text(text(goal="goal :- system:halt(3).\n"))
    script = (
        "import sys, numpy as np, nppg\n"
        "domain = nppg.Domain(sys.argv[1], trust=True)\n"
        "try: domain.situation(domain.start(np.random.default_rng(0)))\n"
        "except nppg.NppgError as error: print(error)\n"
    )
    done = subprocess.run([sys.executable, "-c", script, str(tmp_path / "walk.pl")], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert "goal/0 called halt" in done.stdout


def walk(folder: Path, **changed: str) -> tuple[Domain, LanguageBias]:
    (folder / "walk.pl").write_text(text(**changed))
    (folder / "walk.yaml").write_text(BIAS)
    return Domain(folder / "walk.pl"), LanguageBias.load(folder / "walk.yaml")


@pytest.mark.parametrize("start", ["start([at(0)]).\n", "start([at(9)]).\n"])
def test_training_ends_where_every_start_does(tmp_path: Path, start: str) -> None:
    domain, bias = walk(tmp_path, start=start, more="terminal :- at(9).\n")
    with pytest.raises(NppgError, match=r"walk\.pl.*no step"):
        list(train(domain, bias, Options(episodes=5000)))


def test_training_where_some_starts_are_goals(tmp_path: Path) -> None:
    domain, bias = walk(tmp_path, start="start([at(X)]) :- random_between(0, 2, X).\n")
    assert list(train(domain, bias, Options(episodes=20)))[-1].episodes == 20


GOALS = {
    "several answers": (
        "spot(1).\nspot(2).\n",
        "spot/1 is the goal template of the language bias and must have one answer, but has 2",
    ),
    "no answer": (
        "spot(X) :- at(X), X > 7.\n",
        "spot/1 is the goal template of the language bias and must have one answer, but has 0",
    ),
    "open answer": ("spot(_).\n", "spot/1"),
    "loops": ("spot(X) :- repeat, at(X), fail.\n", "spot/1 took more than 1,000,000 inferences"),
    "test loops": ("spot(3).\nodd(_) :- repeat, fail.\n", "odd/1 took more than 1,000,000 inferences"),
    "test throws": ("spot(3).\nodd(X) :- X > a.\n", "odd/1 threw Arithmetic"),
    "test swallows": (
        "spot(3).\nodd(_) :- repeat, catch((repeat, fail), _, fail).\n",
        "a test of the language bias took more than",
    ),
}


@pytest.mark.parametrize("more, message", GOALS.values(), ids=GOALS)
def test_what_the_bias_asks(tmp_path: Path, more: str, message: str) -> None:
    domain, _ = walk(tmp_path, more=more if "odd" in more else more + "odd(1).\n")
    (tmp_path / "walk.yaml").write_text(
        "action: [left, right]\ngoal: spot(-cell)\ntypes: {odd: [cell]}\nmodes: [odd(+)]\n"
    )
    with pytest.raises(NppgError) as caught:
        list(train(domain, LanguageBias.load(tmp_path / "walk.yaml"), Options(episodes=3)))
    assert message in str(caught.value) and "#" not in str(caught.value)


def test_actions_that_the_bias_does_not_have(tmp_path: Path) -> None:
    domain, bias = walk(tmp_path, action="action(left).\naction(A) :- A = up.\n", effect="effect(_, [], []).\n")
    with pytest.raises(NppgError, match="action/1 gave up, for which the language bias has no action template"):
        list(train(domain, bias, Options(episodes=3)))


@pytest.fixture(scope="module")
def trained(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a model and its domain."""
    folder = tmp_path_factory.mktemp("trained")
    domain, bias = walk(folder, start="start([at(1)]).\n")
    *_, last = train(domain, bias, Options(episodes=300, min_examples=5))
    assert last.policy.trees
    last.policy.save(folder / "model.pl")
    return folder


@pytest.fixture
def model(trained: Path, tmp_path: Path) -> Path:
    """A copy, to change."""
    shutil.copytree(trained, tmp_path, dirs_exist_ok=True)
    return tmp_path / "model.pl"


def insert(rule: str) -> object:
    return lambda source: source.replace("\ndelta(", f"\n{rule}\ndelta(", 1)


MODELS = {
    "empty": lambda source: "",
    "garbage": lambda source: "\x00 ]] garbage",
    "prolog": lambda source: ":- module(a, []).\np.\n",
    "half": lambda source: source[: len(source) // 2],
    "no last line": lambda source: source.rstrip().rsplit("\n", 1)[0],
    "a directive": insert(":- shell('touch executed')."),
    "initialization": insert(":- initialization(shell('touch executed'))."),
    "undeclared test": insert("delta(1, left, 0.5) :- shell('touch executed'), !."),
    "undeclared action": insert("delta(1, up, 0.5) :- home, !."),
    "nested call": insert("delta(1, left, 0.5) :- \\+ shell('touch executed'), !."),
    "name as value": insert("delta(1, left, much) :- home, !."),
    "nan as value": insert("delta(1, left, nan) :- home, !."),
    "other tree": insert("delta(7, left, 0.5) :- home, !."),
    "expansion": insert("user:term_expansion(_, _) :- shell('touch executed')."),
    "other domain": lambda source: source.replace("model(literal, home)", "model(literal, flies)"),
    "missing domain": lambda source: source.replace("'walk.pl'", "'nonesuch.pl'"),
    "huge": lambda source: source + "delta(1, left, 0.5).\n" * 100_000,
}


@pytest.mark.parametrize("change", MODELS.values(), ids=MODELS)
def test_models(model: Path, change: object, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(model.parent)
    Policy.load(model)
    changed = change(model.read_text())  # type: ignore[operator]
    assert changed != model.read_text()
    resigned(model, changed)
    with pytest.raises(NppgError) as caught:
        Policy.load(model)
    assert len(caught.value.problems) == 1 and "nppg_" not in str(caught.value)
    assert not Path("executed").exists()


def test_models_that_cannot_be_read(tmp_path: Path, model: Path) -> None:
    for path in (tmp_path, tmp_path / "nonesuch.pl"):
        with pytest.raises(NppgError, match="cannot be read"):
            Policy.load(path)
    resigned(model, b"\xff\xfe" + model.read_bytes())
    with pytest.raises(NppgError):
        Policy.load(model)


CLEANUPS = {
    "loops": "setup_call_cleanup(true, true, (repeat, fail))",
    "loops behind a loop": "setup_call_cleanup(true, (repeat, fail), (repeat, fail))",
    "without a setup": "call_cleanup((repeat, fail), (repeat, fail))",
    "with a catcher": "setup_call_catcher_cleanup(true, true, _, (repeat, fail))",
}


@pytest.mark.parametrize("body", CLEANUPS.values(), ids=CLEANUPS)
def test_a_cleanup_that_loops_ends(tmp_path: Path, body: str) -> None:
    assert "goal/0 took more than 1,000,000 inferences" in problem(tmp_path, text(goal=f"goal :- {body}.\n"))


def test_a_cleanup_cleans(tmp_path: Path) -> None:
    cleaned = "(nb_getval(times, N), M is N + 1, nb_setval(times, M))"
    goal = f"goal :- nb_setval(times, 0), call_cleanup(fail, {cleaned}).\n"
    goal += f"goal :- catch(setup_call_cleanup(true, throw(up), {cleaned}), up, true), nb_getval(times, 2), at(0).\n"
    (tmp_path / "walk.pl").write_text(text(goal=goal))
    domain = Domain(tmp_path / "walk.pl")
    assert domain.situation(domain.state("at(0)")).status == "goal"
    assert domain.situation(domain.state("at(1)")).status == "running"


@pytest.mark.parametrize(
    "body",
    [
        "call_cleanup(spot(X), spot(1))",
        "setup_call_cleanup(spot(_), spot(X), spot(1))",
        "(setup_call_catcher_cleanup(spot(_), spot(X), End, spot(1)), End == exit)",
        "catch(setup_call_catcher_cleanup(true, throw(up), exception(up), spot(1)), up, spot(X))",
    ],
)
def test_a_cleanup_is_about_the_predicates_of_the_domain_and_keeps_all_answers(tmp_path: Path, body: str) -> None:
    more = f"spot(1).\nspot(2).\ncleaned(X) :- {body}.\ngoal :- findall(X, cleaned(X), [1, 2]), at(0).\n"
    (tmp_path / "walk.pl").write_text(text(goal=more))
    domain = Domain(tmp_path / "walk.pl")
    assert ("cleaned", 1) in domain.predicates and ("setup_call_catcher_cleanup", 4) not in domain.predicates
    assert domain.situation(domain.state("at(0)")).status == "goal"
    assert "unknown predicate spott/1" in problem(tmp_path, text(goal=more.replace("spot(X)", "spott(X)", 1)))


def test_an_encoding_may_come_first(tmp_path: Path) -> None:
    file = tmp_path / "walk.pl"
    file.write_text(":- encoding(utf8).\n" + text(goal="goal :- at(0), atom_length('ü', 1).\n"), encoding="utf-8")
    domain = Domain(file)
    assert domain.situation(domain.state("at(0)")).status == "goal"


def test_many_facts_and_many_questions_are_no_loop(tmp_path: Path) -> None:
    """Each of the actions goes through all facts."""
    size = 1500
    (tmp_path / "walk.pl").write_text(
        ":- module(walk, []).\n:- fluent at/1.\n"
        f"start(Facts) :- findall(at(X), between(1, {size}, X), Facts).\n"
        "action(go(X)) :- at(X).\neffect(go(X), [at(X)], []).\ngoal :- \\+ at(_).\n"
        "alone(X) :- \\+ ( at(Y), Y =\\= X, Y mod 10000 =:= X ).\n"
    )
    (tmp_path / "walk.yaml").write_text("action: go(+spot)\ntypes: {alone: [spot]}\nmodes: [alone(+spot)]\n")
    domain = Domain(tmp_path / "walk.pl")
    state = domain.start(np.random.default_rng(0))
    actions = domain.situation(state).actions
    bias = LanguageBias.load(tmp_path / "walk.yaml")
    answers = root_table(domain, bias, Refiner(bias)).answers(state, actions)
    assert answers.shape == (size, 1) and answers.all()


def test_a_domain_is_the_same_whatever_else_has_been_loaded(tmp_path: Path) -> None:
    said = problem(tmp_path, text(goal="goal :- X is foo + 1, X > 0.\n"))
    janus_swi.query_once("use_module(library(arithmetic))")
    assert said == problem(tmp_path, text(goal="goal :- X is foo + 1, X > 0.\n"))
    (tmp_path / "own.pl").write_text(
        ":- module(own, []).\n:- use_module(library(arithmetic)).\n:- arithmetic_function(double/1).\n"
        "double(X, Y) :- Y is 2 * X.\n:- fluent at/1.\nstart([at(1)]).\naction(go).\n"
        "effect(go, [at(X)], [at(Y)]) :- at(X), Y is double(X).\ngoal :- at(2).\n"
    )
    own = Domain(tmp_path / "own.pl")
    assert own.neighbours(own.state("at(1)"))[0][1][0].state == (("at", 2),)
