"""Every domain is an environment of Gymnasium, and is the domain that it was."""

from __future__ import annotations

import importlib
import re
import sys
import warnings
from pathlib import Path

import gymnasium
import janus_swi
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from hypothesis import given
from hypothesis import strategies as st

from nppg import Domain, NppgError
from nppg.answers.coverage import root_table
from nppg.bias.refinement import Refiner
from nppg.bridge.files import shipped
from nppg.bridge.terms import ground, texts
from nppg.gym_env import Choice, DomainEnv, Facts, register
from nppg.gym_env.bounded import BoundedEnv, most_actions
from nppg.learning.episode import longest
from nppg.worlds.opening import language_bias_of, open_domain

FERRY = str(Path(__file__).parent / "domains" / "ferry.pl")
SHIPPED = sorted(path.stem for path in shipped("domains").glob("*.pl"))
LINE = """\
:- module(line, []).
:- fluent at/1.
:- parameter(low, 0).
action(left).
action(right).
effect(left, [at(X)], [at(Y)]) :- at(X), Y is X - 1.
effect(right, [at(X)], [at(Y)]) :- at(X), Y is X + 1.
goal :- at(X), X >= 1.
horizon(N) :- at(X), N is max(0, -X).
start([at(X)]) :- parameter(low, Low), random_between(Low, 1, X).
"""
FOG = f"""\
{LINE.replace("low, 0", "low, -9").replace("Low, 1", "Low, -1")}
observation([at(Y)]) :- at(X), random(U), Y is X + U.
"""


@pytest.fixture
def line(tmp_path: Path) -> Path:
    """A walk to the right; half of its starts are goal states or have the horizon 0."""
    path = tmp_path / "line.pl"
    path.write_text(LINE)
    return path


# ---------------------------------------------------------------- Gymnasium's own checks


@pytest.mark.parametrize("name", [*SHIPPED, "Domain"])
@pytest.mark.parametrize("kind", ["", "-bounded"])
def test_gymnasium_finds_nothing_wrong(name: str, kind: str) -> None:
    given = {"domain": FERRY} if name == "Domain" else {}
    if kind:
        given["slots"] = 2 * most_actions(Domain(given.get("domain", name)))
    env = gymnasium.make(f"nppg/{name}{kind}-v0", horizon_factor=3, **given)  # an end after one step is refused
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped)


def test_registering_again_changes_nothing() -> None:
    before = dict(gymnasium.registry)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        register()
    assert gymnasium.registry == before
    assert {f"nppg/{name}{kind}-v0" for name in SHIPPED for kind in ("", "-bounded")} < set(before)


@pytest.mark.parametrize("kind", ["", "-bounded"])
def test_environments_side_by_side_are_those_alone(kind: str) -> None:
    slots = {"slots": 6} if kind else {}

    def made() -> gymnasium.Env:
        return gymnasium.make(f"nppg/blocks_world{kind}-v0", parameters={"blocks": 3}, **slots)

    both = gymnasium.vector.SyncVectorEnv([made, made])
    observations, _ = both.reset(seed=[5, 6])
    for i, seed in enumerate((5, 6)):
        np.testing.assert_array_equal(observations[i], made().reset(seed=seed)[0])
    both.close()


# ---------------------------------------------------------------- the domain


@pytest.mark.parametrize("name", [*SHIPPED, FERRY, "fog"])
@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize("factor", [1, 1.1, 1.5])
def test_an_episode_is_the_domains(name: str, seed: int, factor: float, line: Path) -> None:
    if name == "fog":
        name = str(line)
        line.write_text(FOG)
    env, domain = DomainEnv(name, horizon_factor=factor), Domain(name)
    rng, choices = np.random.default_rng(seed), np.random.default_rng(seed)
    for number in range(5):
        observation, info = env.reset(seed=seed if number == 0 else None)
        state = domain.start(rng)
        limit = longest(domain.horizon(state), factor)
        steps, over = 0, False
        while not over:
            assert env.state == state
            assert observation == tuple(texts(domain.observe(state, rng)))
            assert info["actions"] == domain.situation(state).actions
            assert info["action_texts"] == texts(info["actions"])
            assert observation in env.observation_space
            chosen = int(choices.integers(len(info["actions"])))
            earned, state = domain.act(state, info["actions"][chosen], rng)
            observation, reward, terminated, truncated, info = env.step(chosen)
            steps += 1
            status = domain.situation(state).status
            assert (reward, terminated, info["is_success"]) == (earned, status != "running", status == "goal")
            assert truncated == (not terminated and steps == limit)
            assert info["legal"]
            over = terminated or truncated
        assert observation == tuple(texts(domain.observe(state, rng)))


def test_seeds_tell_episodes_apart() -> None:
    env = DomainEnv("blocks_world")
    starts = [env.reset(seed=seed)[0] for seed in (0, 1, 0)]
    assert starts[0] == starts[2] != starts[1]
    assert env.reset()[0] != starts[0]


@pytest.mark.parametrize("make", [DomainEnv, BoundedEnv])
def test_an_illegal_action_only_takes_a_step(make: type[DomainEnv]) -> None:
    env = make("blocks_world", {"blocks": 4}, horizon_factor=2)
    before, info = env.reset(seed=3)
    drawn = env.np_random.bit_generator.state
    for left in range(2 * env.domain.horizon(env.state) - 1, -1, -1):
        after, reward, terminated, truncated, later = env.step(len(info["actions"]))
        np.testing.assert_array_equal(before, after)
        assert (reward, terminated, truncated, later["legal"]) == (0, False, left == 0, False)
        assert later["actions"] == info["actions"]
    assert env.np_random.bit_generator.state == drawn


def test_there_is_something_to_do_after_reset(line: Path) -> None:
    env = DomainEnv(line, {"low": -2})
    starts = {env.reset(seed=seed)[0] for seed in range(20)}
    assert starts == {("at(-2)",), ("at(-1)",)}
    with pytest.raises(NppgError, match=r"line\.pl: 1000 starts in a row were goal or terminal states"):
        DomainEnv(line).reset()


def test_what_is_drawn_is_the_domains_picture() -> None:
    env = DomainEnv("blocks_world", {"blocks": 3}, render_mode="ansi")
    env.reset(seed=0)
    assert env.render() == "\n".join(env.domain.picture(env.state))
    assert DomainEnv("blocks_world").render() is None


def test_a_step_needs_a_reset() -> None:
    with pytest.raises(gymnasium.error.ResetNeeded):
        DomainEnv("blocks_world").step(0)


# ---------------------------------------------------------------- the spaces

NAMES = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"))
GROUND = st.recursive(
    NAMES | st.integers() | st.floats(allow_nan=False, allow_infinity=False),
    lambda inner: st.builds(lambda name, args: (name, *args), NAMES, st.lists(inner, min_size=1, max_size=3)),
    max_leaves=6,
)


@given(st.lists(GROUND, min_size=1, max_size=3))
def test_prolog_reads_back_what_it_writes(terms: list) -> None:
    for term, text in zip(terms, texts(terms), strict=True):
        read = janus_swi.query_once("term_to_atom(_T, Text), nppg_terms:encode(_T, Data)", {"Text": text})
        assert repr(ground(read["Data"])) == repr(term)


def test_lists_are_written_as_lists() -> None:
    assert texts([("p", ("[|]", 1, ("[|]", "a b", ("[]",)))), "q", ("-", 1, 2)]) == ["p([1, 'a b'])", "q", "-(1, 2)"]


def test_facts_are_of_the_fluents() -> None:
    space = Facts([("on", 2), ("Free", 1), ("raining", 0)], seed=0)
    samples = [space.sample() for _ in range(50)]
    assert all(sample in space for sample in samples)
    assert {"raining"} < {fact.split("(")[0] for sample in samples for fact in sample} == {"on", "'Free'", "raining"}
    assert () in space and ("on(a, b)", "'Free'(a)") in space
    for other in (["on(a, b)"], ("off(a, b)",), ("raining(a)",), ("on",), ("on(a, b)", "on(a, b)"), (1,), "raining"):
        assert other not in space
    assert space == Facts([("raining", 0), ("Free", 1), ("on", 2)]) != Facts([("on", 2)])


def test_a_sampled_choice_is_legal() -> None:
    env = DomainEnv("delivery")
    env.action_space.seed(0)
    _, info = env.reset(seed=0)
    taken = set()
    for _ in range(100):
        number = env.action_space.sample()
        assert number in env.action_space and 0 <= number < len(info["actions"])
        taken.add(int(number))
    assert taken == set(range(len(info["actions"])))
    assert -1 not in env.action_space and 0.5 not in env.action_space
    assert env.action_space == Choice() != Facts([])


# ---------------------------------------------------------------- the bounded environment


@pytest.mark.parametrize("name", SHIPPED)
def test_rows_are_the_answers_of_the_legal_actions(name: str) -> None:
    parameters = {"noise": 0} if name == "noisy_blocks" else {}  # so that to look twice is to see the same
    env = BoundedEnv(name, parameters, slots=100)
    domain = open_domain(name, parameters)
    bias = language_bias_of(domain)
    table = root_table(domain, bias, Refiner(bias))
    observation, info = env.reset(seed=0)
    for _ in range(20):
        actions = domain.situation(env.state).actions
        state = domain.observe(env.state, np.random.default_rng(0))
        assert observation in env.observation_space and observation.shape == (100, len(env.tests))
        assert info["action_mask"].dtype == np.int8
        assert list(env.action_masks()) == list(info["action_mask"] == 1) == [i < len(actions) for i in range(100)]
        for row, own in zip(observation, table.answers(state, actions) if actions else (), strict=False):
            for column, (seen, answer) in enumerate(zip(row.tolist(), own.tolist(), strict=True)):
                if column in table.bounds:
                    assert seen == (0 if answer == np.inf else np.float32(answer))
                else:
                    assert seen == (answer <= 0.5 if table.numeric else answer)
        assert not observation[len(actions) :].any()
        observation, _, terminated, truncated, info = env.step(env.action_space.sample(info["action_mask"]))
        if terminated or truncated:
            observation, info = env.reset()


def test_columns_tell_their_tests() -> None:
    env = BoundedEnv("blocks_world", {"blocks": 3})
    assert {"clear(A)", "on(C, D)", "A = C", "on(B, floor)"} <= set(env.tests)
    assert len(set(env.tests)) == len(env.tests) == env.observation_space.shape[1]


@pytest.mark.parametrize("blocks", [2, 3, 4])
def test_the_slots_found_are_enough(blocks: int) -> None:
    """With all blocks on the floor each may go onto every other."""
    assert most_actions(Domain("blocks_world", {"blocks": blocks})) == blocks * (blocks - 1)
    assert BoundedEnv("blocks_world", {"blocks": blocks}).action_space.n == blocks * (blocks - 1)


NUMBERS = """\
action: [left, right]
types: {at: [position]}
modes: [{literal: at(-position), lookahead: 1}, '+position =< #', '+position >= #']
lookahead: 1
"""


def test_numbers_that_are_compared_are_seen_themselves(line: Path) -> None:
    line.with_suffix(".yaml").write_text(NUMBERS)
    env = BoundedEnv(line, {"low": -9})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env, skip_render_check=True)
    columns = {test: i for i, test in enumerate(env.tests)}
    for seed in range(5):
        observation, _ = env.reset(seed=seed)
        ((_, position),) = env.state
        assert position < 0
        assert list(observation[:, columns["at(A), A =< #"]]) == [position, position]
        assert list(observation[:, columns["at(A), A >= #"]]) == [-position, -position]
        assert list(observation[:, columns["action is left"]]) == [1, 0]
        assert observation in env.observation_space


def test_only_what_the_domain_shows_is_seen(line: Path) -> None:
    line.write_text(FOG)
    line.with_suffix(".yaml").write_text(NUMBERS)
    observation, _ = BoundedEnv(line).reset(seed=0)
    (text,), _ = DomainEnv(line).reset(seed=0)
    assert np.float32(text[3:-1]) in observation and np.float32(text[3:-1]) % 1


@pytest.mark.parametrize("kind", ["", "-bounded"])
def test_an_environment_of_gymnasium_that_is_a_domain_comes_back_as_it_was(kind: str) -> None:
    env = gymnasium.make(f"nppg/Domain{kind}-v0", domain="gym:CartPole-v1")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped)
    env.reset(seed=0)
    (seed,) = np.random.default_rng(0).integers(2**31, size=1).tolist()
    own = gymnasium.make("CartPole-v1")
    own.reset(seed=seed)
    for _ in range(5):
        observation, reward, *_ = env.step(1)
        values, own_reward, *_ = own.step(1)
        assert reward == own_reward
        if kind:
            assert {float(np.float32(value)) for value in values} <= set(observation[1].tolist())
        else:
            np.testing.assert_allclose([float(fact.split()[1][:-1]) for fact in observation], values)


def test_too_few_slots() -> None:
    env = BoundedEnv("blocks_world", {"blocks": 5}, slots=2)
    with pytest.raises(NppgError, match=r"blocks_world\.pl: a state has \d+ legal actions .* slots=2: give more"):
        for seed in range(20):
            env.reset(seed=seed)


def test_what_the_manual_shows_happens(capsys: pytest.CaptureFixture[str]) -> None:
    text = (Path(__file__).parent.parent / "docs" / "gymnasium.md").read_text(encoding="utf-8")
    section = text.partition("## nppg domains as Gymnasium environments\n")[2].partition("\n## ")[0]
    code = "".join(re.findall(r"```python\n(.*?)```", section, re.DOTALL))
    exec(compile(code, "gymnasium.md", "exec"), {})
    printed = capsys.readouterr().out
    shown = re.findall(r"print\(.*\)  # (.*)", code)
    assert len(shown) == 3 and all(f"{line}\n" in printed for line in shown)


# ---------------------------------------------------------------- mistakes of users


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"slots": 0}, "slots must be at least 1, not 0"),
        ({"render_mode": "human"}, "render_mode must be 'ansi' or None, not 'human'"),
        ({"horizon_factor": -1}, "horizon_factor must be at least 0, not -1"),
        ({"parameters": {"task": "stack"}}, "task=stack has a language bias of its own: give --bias stack, or"),
        ({"parameters": {"block": 3}}, "did you mean 'blocks'"),
        ({"bias": "stak"}, "did you mean 'stack'"),
    ],
)
def test_mistakes_are_told(given: dict, message: str) -> None:
    with pytest.raises(NppgError, match=message) as caught:
        BoundedEnv("blocks_world", **given)
    assert len(caught.value.problems) == 1


def test_the_bias_is_another_domains() -> None:
    with pytest.raises(NppgError, match=r"blocks_world\.yaml:\d+:\d+: "):
        BoundedEnv("delivery", bias="blocks_world")


def test_a_bias_is_missing(line: Path) -> None:
    with pytest.raises(NppgError, match=r"line\.yaml: there is no language bias of this name; give one by --bias$"):
        BoundedEnv(line)


@pytest.mark.parametrize("module", ["gym_env", "gym_env.bounded"])
def test_gymnasium_is_missing(module: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "gymnasium", None)
    for each in ("gym_env", "gym_env.domain_env", "gym_env.bounded"):
        monkeypatch.delitem(sys.modules, f"nppg.{each}", raising=False)
    with pytest.raises(NppgError, match=r"^an environment of Gymnasium needs gymnasium: pip install 'nppg\[gym\]'$"):
        importlib.import_module(f"nppg.{module}")


def test_samples_of_a_vector_of_environments_are_not_always_the_first_action() -> None:
    vector = gymnasium.make_vec("nppg/blocks_world-v0", 3, "sync", parameters={"blocks": 4})
    assert {int(each) for _ in range(30) for each in vector.action_space.sample()} == set(range(Choice.GUESSED))
    vector.reset(seed=1)
    first = vector.envs[0].unwrapped
    drawn = {int(each) for _ in range(100) for each in vector.action_space.sample()}
    assert drawn == set(range(len(first.actions)))
    assert all(each in vector.action_space for each in [vector.action_space.sample()])
    vector.close()
