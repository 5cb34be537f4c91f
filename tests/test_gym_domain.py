"""Environments of Gymnasium as domains: what Gymnasium says is what nppg hears, and nothing but the seed decides."""

from __future__ import annotations

import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from samples import in_plain_prolog, term

from nppg import NppgError, Options, Policy, evaluate, generate_episode, language_bias_of, open_domain, run
from nppg.answers.coverage import table_of
from nppg.bridge.interrupts import interruptible
from nppg.bridge.terms import Ground
from nppg.cli.main import main
from nppg.learning.critic import ValueFunction
from nppg.learning.episode import Episode
from nppg.rrl.options import TGOptions
from nppg.rrl.training import examples
from nppg.trees.tree import Leaf
from nppg.worlds.gym_domain import GymDomain
from nppg.worlds.world import State

gymnasium = pytest.importorskip("gymnasium")
spaces = gymnasium.spaces

TAXI = max(each for each in gymnasium.registry if each.startswith("Taxi-v"))
IDS = ["CartPole-v1", "Acrobot-v1", "FrozenLake-v1", TAXI]
SPACES = {
    "vector": spaces.Box(-9, 9, (2,)),
    "double": spaces.Box(-9, 9, (3,), np.float64),
    "picture": spaces.Box(0, 255, (2, 3), np.uint8),
    "number": spaces.Discrete(5, start=2),
    "tuple": spaces.Tuple((spaces.Discrete(2), spaces.Discrete(3))),
}


class Told(gymnasium.Env):
    """Says what it is told to say, and remembers what it is asked to do."""

    metadata = {"render_modes": []}  # noqa: RUF012

    def __init__(self, space: str = "vector", actions: int = 3, first: int = 0, continuous: bool = False):
        self.observation_space = SPACES[space]
        self.action_space = spaces.Box(0, 1, (1,)) if continuous else spaces.Discrete(actions, start=first)
        self.observation: Any = [0.5, -1] if space == "vector" else self.observation_space.sample()
        self.info: dict = {}
        self.outcome: tuple = (1.0, False, False)
        self.taken: list = []

    def reset(self, *, seed: int | None = None, options: dict | None = None) -> tuple:
        super().reset(seed=seed)
        return self.observation, self.info

    def step(self, action: int) -> tuple:
        self.taken.append(action)
        return self.observation, *self.outcome, self.info


gymnasium.register("nppg/Told-v2", Told)


def opened(id: str, **parameters: Any) -> GymDomain:
    domain = open_domain(f"gym:{id}", parameters)
    assert isinstance(domain, GymDomain)
    return domain


def told(**parameters: Any) -> tuple[GymDomain, Told]:
    domain = opened("nppg/Told-v2", **parameters)
    env = domain._made.env.unwrapped
    assert isinstance(env, Told)
    return domain, env


def started(domain: GymDomain, seed: int = 0) -> State:
    return domain.start(np.random.default_rng(seed))


def values(state: State) -> list[Ground]:
    assert [fact[:2] for fact in state] == [("obs", i + 1) for i in range(len(state))]  # type: ignore[index]
    return [fact[2] for fact in state]  # type: ignore[index]


def uniform(domain: GymDomain) -> Policy:
    bias = language_bias_of(domain)
    return Policy(domain, bias, table_of([], domain, bias))


def episode(domain: GymDomain, seed: int, **options: Any) -> Episode:
    return generate_episode(uniform(domain), np.random.default_rng(seed), **options)


def numbers(env: Any, observation: Any) -> list[float | int]:
    """What stands for an observation."""
    if env.spec.id == TAXI:
        return list(env.unwrapped.decode(observation))
    return [observation] if isinstance(observation, int) else np.asarray(observation, np.float32).tolist()


@pytest.mark.parametrize(
    ("id", "parameters", "limited"),
    [
        ("CartPole-v1", {}, False),
        ("CartPole-v1", {"max_episode_steps": 7}, True),
        ("Acrobot-v1", {}, True),
        ("FrozenLake-v1", {}, False),
        ("FrozenLake-v1", {"is_slippery": False, "map_name": "8x8"}, False),
        (TAXI, {}, True),
    ],
)
def test_an_episode_is_gymnasiums_own(id: str, parameters: dict, limited: bool) -> None:
    """Under its seed and actions: observations, masks, rewards, and the end, by the environment or its time limit."""
    domain, env = opened(id, **parameters), gymnasium.make(id, **parameters)
    assert domain.horizon(()) == env.spec.max_episode_steps
    ends = set()
    for seed in range(4):
        played = episode(domain, seed)
        observation, info = env.reset(seed=int(np.random.default_rng(seed).integers(2**31)))
        terminated = truncated = False
        for step in played.steps:
            assert not terminated and not truncated
            assert values(step.state) == numbers(env, observation)
            assert list(map(type, values(step.state))) == list(map(type, numbers(env, observation)))
            legal = np.flatnonzero(info.get("action_mask", np.ones(env.action_space.n)))
            assert step.actions == [("do", number) for number in legal]
            observation, reward, terminated, truncated, info = env.step(step.actions[step.chosen][1])  # type: ignore[index]
            assert step.reward == reward and type(step.reward) is float
        assert values(played.last) == numbers(env, observation)
        assert (terminated or truncated) and terminated == (not played.open) and not played.success
        ends.add(truncated)
    assert limited in ends


def test_masks_keep_illegal_moves_out_of_the_taxi() -> None:
    seen = {len(step.actions) for seed in range(3) for step in episode(opened(TAXI), seed).steps}
    assert 6 not in seen and len(seen) > 1


@pytest.mark.parametrize("id", IDS)
def test_a_seed_reproduces_an_evaluation_to_the_bit(id: str) -> None:
    once, again = (evaluate(uniform(opened(id)), 10, seed=3) for _ in range(2))
    assert once == again and once.mean_return is not None
    assert once != evaluate(uniform(opened(id)), 10, seed=4)


def test_the_horizon_is_the_only_clock() -> None:
    domain = opened("Acrobot-v1", max_episode_steps=20)
    assert [len(episode(domain, 0, horizon_factor=factor).steps) for factor in (0.5, 1, 3)] == [10, 20, 60]
    assert opened("CartPole-v1").horizon(()) == 500
    assert told()[0].horizon(()) == 1000


def test_an_episode_asks_prolog_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    domain = opened("CartPole-v1")
    policy = uniform(domain)
    played = episode(domain, 1)

    def asked(*_: object) -> None:
        pytest.fail("Prolog is asked")

    for module in ("worlds.domain", "answers.coverage", "answers.table"):
        monkeypatch.setattr(f"nppg.{module}.ask", asked, raising=False)
    assert generate_episode(policy, np.random.default_rng(1)).last == played.last
    with pytest.raises(pytest.fail.Exception):
        domain.picture(played.last)


def test_prolog_knows_the_state_that_it_is_asked_about() -> None:
    domain = opened("CartPole-v1")
    states = [step.state for step in episode(domain, 2).steps]
    for state in (*states[:3], states[0]):
        assert domain.picture(state) == [f"obs({i},{x!r})" for i, x in enumerate(values(state), 1)]


@pytest.mark.parametrize(
    ("space", "observation", "expected"),
    [
        ("vector", np.array([0.1, 0.2]), [float(np.float32(0.1)), float(np.float32(0.2))]),
        ("vector", [1, 2], [1.0, 2.0]),
        ("double", np.array([1 / 3, 1e-50, -2.0]), [float(np.float32(1 / 3)), 0.0, -2.0]),
        ("picture", np.arange(6, dtype=np.uint8).reshape(2, 3), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]),
        ("number", np.int64(4), [4]),
    ],
)
def test_a_state_is_flat_and_holds_plain_numbers(space: str, observation: Any, expected: list) -> None:
    domain, env = told(space=space)
    env.observation = observation
    found = values(started(domain))
    assert found == expected and list(map(type, found)) == list(map(type, expected))
    assert language_bias_of(domain).max_variables == len(expected)


def test_actions_are_counted_from_where_the_environment_counts() -> None:
    domain, env = told(actions=2, first=3)
    state = started(domain)
    actions = domain.situation(state).actions
    assert actions == [("do", 3), ("do", 4)]
    for action in actions:
        _, state = domain.act(state, action, np.random.default_rng(0))
    assert env.taken == [3, 4]
    for wrong in (("do", 0), ("do", 5), "do"):
        with pytest.raises(NppgError, match="is no action"):
            domain.act(state, wrong, np.random.default_rng(0))


@pytest.mark.parametrize(
    ("mask", "legal"),
    [([1, 0, 1], [0, 2]), (np.array([0, 1, 0], np.int8), [1]), ([0, 0, 0], [0, 1, 2]), ((True, True, True), [0, 1, 2])],
)
def test_a_mask_says_what_is_legal_unless_nothing_is(mask: Any, legal: list[int]) -> None:
    domain, env = told()
    env.info = {"action_mask": mask}
    state = started(domain)
    assert domain.situation(state) == ("running", [("do", number) for number in legal])
    env.info = {}
    _, state = domain.act(state, ("do", 1), np.random.default_rng(0))
    assert len(domain.situation(state).actions) == 3


class Masked(Told):
    """With sb3-contrib's convention."""

    mask: Any = (1, 0, 1)

    def action_masks(self) -> Any:
        if isinstance(self.mask, Exception):
            raise self.mask
        return self.mask


class Changed(gymnasium.Wrapper):
    """Allows what the environment does not."""

    def action_masks(self) -> Any:
        return ~np.array(self.unwrapped.mask, bool)  # type: ignore[attr-defined]


gymnasium.register("nppg/Masked-v0", Masked)
gymnasium.register("nppg/Changed-v0", lambda: Changed(Masked()))


def test_a_method_says_what_is_legal_where_info_does_not() -> None:
    domain, changed = opened("nppg/Masked-v0"), opened("nppg/Changed-v0")
    env: Any = domain._made.env.unwrapped
    for mask, info, legal in (
        ((1, 0, 1), {}, [0, 2]),
        (np.array([False, True, False]), {}, [1]),
        ([0, 0, 0], {}, [0, 1, 2]),
        (None, {}, [0, 1, 2]),
        ([1, 0, 0], {"action_mask": [0, 0, 1]}, [2]),
    ):
        env.mask, env.info = mask, info
        assert domain.situation(started(domain)) == ("running", [("do", number) for number in legal])
    env.mask, env.info = [0, 1, 1], {}
    _, state = domain.act(started(domain), ("do", 1), np.random.default_rng(0))
    assert domain.situation(state).actions == [("do", 1), ("do", 2)]
    for wrong, message in (
        ([1], r"action_masks gave \[1\] has 1 entries"),
        (KeyError(1), "action_masks raised KeyError: 1"),
    ):
        env.mask = wrong
        with pytest.raises(NppgError, match=f"^gym:nppg/Masked-v0: {message}"):
            started(domain)
    assert changed.situation(started(changed)).actions == [("do", 1)]


def test_an_attribute_that_is_no_method_says_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Told, "action_masks", [1, 0, 0], raising=False)
    domain, _ = told()
    assert len(domain.situation(started(domain)).actions) == 3


@pytest.mark.parametrize("outcome", [(2.0, True, False), (2.0, True, True), (2.0, False, True)])
def test_what_the_environment_ends_goes_on_no_more(outcome: tuple) -> None:
    """It is cut off where the environment truncates by itself, without a time limit that Gymnasium knows of."""
    domain, env = told()
    state = started(domain)
    env.outcome, env.info = outcome, {"action_mask": [1, 0, 1]}
    reward, state = domain.act(state, ("do", 0), np.random.default_rng(0))
    left = ("terminal", []) if outcome[1] else ("truncated", [("do", 0), ("do", 2)])
    assert (reward, domain.situation(state)) == (2.0, left)
    with pytest.raises(NppgError, match="has ended"):
        domain.act(state, ("do", 0), np.random.default_rng(0))
    with pytest.raises(NppgError, match=f"the state is a {left[0]} state"):
        uniform(domain).act(state, np.random.default_rng(0))


@pytest.mark.parametrize(("outcome", "value"), [((1.0, True, False), 1.0), ((1.0, False, True), 1.0 + 0.9 * 5.0)])
def test_value_is_expected_behind_a_truncation_alone(outcome: tuple, value: float) -> None:
    """The paper's critic and relational Q-learning."""
    domain, env = told()
    env.outcome = outcome
    played = episode(domain, 0)
    assert len(played.steps) == 1 and bool(played.open) == outcome[2] and not played.success
    values = ValueFunction(domain, language_bias_of(domain), Options(discount=0.9, cut_off="bootstrap"))
    values.trees.add(Leaf(5.0))
    assert [visit.value for visit in values.visits(played)] == [pytest.approx(value - 5.0)]
    values.options = Options(discount=0.9)
    assert [visit.value for visit in values.visits(played)] == [pytest.approx(1.0 - 5.0)]
    learner: Any = uniform(domain)
    learner.add(Leaf(5.0))
    learner.options = TGOptions(discount=0.9)
    assert [each.value for each in examples(played, learner)] == [pytest.approx(value)]


def test_a_domain_that_cuts_itself_off_is_truncated_as_an_environment_too() -> None:
    from nppg.gym_env import DomainEnv

    env = DomainEnv("gym:nppg/Told-v2")
    own = env.domain._made.env.unwrapped  # type: ignore[attr-defined]
    env.reset(seed=0)
    own.outcome = (2.0, False, True)
    _, reward, terminated, truncated, info = env.step(1)
    assert (reward, terminated, truncated, len(info["actions"]), info["legal"]) == (2.0, False, True, 3, True)
    _, reward, terminated, truncated, info = env.step(1)
    assert (reward, terminated, truncated, info["legal"]) == (0.0, False, True, False)
    assert len(own.taken) == 1
    inner = opened("nppg/grid-bounded-v0")
    assert any(episode(inner, seed).open for seed in range(3)), "its horizon is no limit that Gymnasium knows of"


def test_an_environment_goes_on_from_where_it_is_alone() -> None:
    domain = opened("CartPole-v1")
    first = started(domain)
    _, second = domain.act(first, ("do", 0), np.random.default_rng(0))
    for question in (lambda: domain.act(first, ("do", 0), np.random.default_rng(0)), lambda: domain.situation(first)):
        with pytest.raises(NppgError, match="in another state"):
            question()
    same = tuple(tuple(fact) for fact in second)  # type: ignore[arg-type]
    assert domain.situation(same).status == "running"
    for unknown in (lambda: domain.neighbours(second), lambda: domain.reward(second, ("do", 0))):
        with pytest.raises(NppgError, match="gym:CartPole-v1: "):
            unknown()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"observation": [np.nan, 1]}, "not finite"),
        ({"observation": [1, np.inf]}, "not finite"),
        ({"observation": [1, 2, 3]}, "no array of 2 numbers"),
        ({"observation": "x"}, "'x' is no array of numbers"),
        ({"observation": ["0.5", "1"]}, "is no array of numbers"),
        ({"observation": [1j, 0]}, "is no array of numbers"),
        ({"observation": None}, "None is no array of 2 numbers"),
        ({"observation": {"a": 1}}, "is no array of numbers"),
        ({"observation": [[1], [1, 2]]}, "is no array of numbers"),
        ({"observation": [1e300, 0]}, "not finite"),
        ({"outcome": (np.nan, False, False)}, "the reward nan is no finite number"),
        ({"outcome": (np.array([np.inf]), False, False)}, r"the reward array\(\[inf\]\) is no finite number"),
        ({"outcome": (np.ones(2), False, False)}, r"the reward array\(\[1., 1.\]\) is no finite number"),
        ({"outcome": (None, False, False)}, "the reward None is no finite number"),
        ({"outcome": (np.ones((50, 50)), False, False)}, r"the reward array\(.*\.\.\. is no finite number"),
        ({"outcome": (10**400, False, False)}, "is no finite number"),
        ({"outcome": (1j, False, False)}, "the reward 1j is no finite number"),
        ({"outcome": ([1.0], False, False)}, r"the reward \[1.0\] is no finite number"),
        ({"outcome": (1, np.zeros(2, bool), False)}, r"terminated array\(.*\) is neither True nor False"),
        ({"outcome": (1, False, "False")}, "truncated 'False' is neither True nor False"),
        ({"outcome": (1, None, False)}, "terminated None is neither True nor False"),
        ({"outcome": (1, False)}, "step gave .* and not 5 values: observation, reward, terminated, truncated, info"),
        ({"outcome": (1, False, False, 0)}, "step gave .* and not 5 values: "),
        ({"info": {"action_mask": [1]}}, "1 entries for 3 actions"),
        ({"info": {"action_mask": True}}, "True has 1 entries for 3 actions"),
        ({"info": {"action_mask": np.ones((3, 2))}}, "6 entries for 3 actions"),
        ({"info": {"action_mask": "abc"}}, "'abc' is no array of 0 and 1"),
        ({"info": {"action_mask": [1, np.nan, 0]}}, "is no array of 0 and 1"),
        ({"info": {"action_mask": {"do": 1}}}, "is no array of 0 and 1"),
        ({"info": [1]}, r"info \[1\] is no dict"),
    ],
)
def test_an_environments_mistakes_are_one_line(change: dict, message: str) -> None:
    domain, env = told()
    state = started(domain)
    vars(env).update(change)
    with pytest.raises(NppgError, match=message) as caught:
        domain.act(state, ("do", 0), np.random.default_rng(0))
    assert str(caught.value).startswith("gym:nppg/Told-v2: ") and "\n" not in str(caught.value)
    with pytest.raises(NppgError, match="in another state"):
        domain.act(state, ("do", 0), np.random.default_rng(0))


@pytest.mark.parametrize(
    ("found", "message"),
    [
        (np.array([0.5, -1]), r"reset gave array\(\[ 0.5, -1. \]\) and not 2 values: observation, info"),
        (([0.5, -1],), "and not 2 values"),
        (None, "reset gave None and not 2 values"),
        ([[0.5, -1], 1], "info 1 is no dict"),
        (([0.5], {}), r"an observation \[0.5\] is no array of 2 numbers"),
    ],
)
def test_what_reset_gives_is_checked(found: Any, message: str, monkeypatch: pytest.MonkeyPatch) -> None:
    domain, _ = told()
    monkeypatch.setattr(Told, "reset", lambda self, **_: found)
    with pytest.raises(NppgError, match=f"^gym:nppg/Told-v2: .*{message}"):
        started(domain)


@pytest.mark.parametrize("reward", [2, np.float32(2), np.int8(2), np.array(2), np.array([2.0]), np.array([[2]]), "2"])
@pytest.mark.parametrize("false", [False, 0, np.False_, np.array(False), np.array([0])])
def test_an_array_of_one_number_is_the_number(reward: Any, false: Any) -> None:
    domain, env = told()
    env.outcome, env.info = (reward, false, false), None  # type: ignore[assignment]
    found, state = domain.act(started(domain), ("do", 0), np.random.default_rng(0))
    assert (found, type(found)) == (2.0, float) and len(domain.situation(state).actions) == 3
    env.outcome = (reward, np.array([True]), false)
    _, state = domain.act(state, ("do", 0), np.random.default_rng(0))
    assert domain.situation(state).status == "terminal"


@pytest.mark.parametrize("observation", [3, np.int64(3), np.array(3), np.array([3]), np.float32(3)])
def test_a_number_is_the_observation_however_it_is_wrapped(observation: Any) -> None:
    domain, env = told(space="number")
    env.observation = observation
    assert started(domain) == (("obs", 1, 3),)
    for wrong in (2.7, np.nan, "3", None, [1, 2]):
        env.observation = wrong
        with pytest.raises(NppgError, match=r"^gym:nppg/Told-v2: an observation .* is no whole number$"):
            started(domain)


def test_a_method_decode_of_another_meaning_is_let_be(monkeypatch: pytest.MonkeyPatch) -> None:
    for decode in (lambda self, text: text.upper(), lambda self, number: "ab", lambda self, a, b: [1]):
        monkeypatch.setattr(Told, "decode", decode, raising=False)
        domain, env = told(space="number")
        env.observation = 5
        assert started(domain) == (("obs", 1, 5),)
    monkeypatch.setattr(Told, "decode", lambda self, number: {2: [1, 2], 4: [np.int64(0), 1.0]}[number])
    domain, env = told(space="number")
    env.observation = 4
    assert started(domain) == (("obs", 1, 0), ("obs", 2, 1))
    env.observation = 3
    with pytest.raises(
        NppgError, match=r"^gym:nppg/Told-v2: an observation 3 is nothing that decode knows: KeyError: 3$"
    ):
        started(domain)


@pytest.mark.parametrize(
    ("parameters", "message"),
    [({"continuous": True}, "only Discrete actions"), ({"space": "tuple"}, "its observations are Tuple")],
)
def test_other_spaces_are_refused(parameters: dict, message: str) -> None:
    with pytest.raises(NppgError, match=message):
        told(**parameters)


def test_an_interrupt_is_heard_between_two_episodes() -> None:
    domain = opened("CartPole-v1")
    policy = uniform(domain)
    with pytest.raises(KeyboardInterrupt), interruptible():
        signal.raise_signal(signal.SIGINT)
        evaluate(policy, 2)
        pytest.fail("the interrupt is not heard")


@pytest.fixture
def trained(tmp_path: Path) -> Path:
    domain = opened("FrozenLake-v1", is_slippery=False)
    run(domain, language_bias_of(domain), Options(30, seed=1, guidance=0), tmp_path, evaluate_every=0)
    return tmp_path / "model.pl"


def test_a_model_opens_its_environment_again(trained: Path) -> None:
    assert "model(parameter, is_slippery=false)." in trained.read_text()
    policy = Policy.load(trained)
    assert isinstance(policy.domain, GymDomain) and policy.trees
    assert policy.domain._made.id == "FrozenLake-v1"
    probabilities = policy.domain._made.env.unwrapped.P[0][0]  # type: ignore[attr-defined]
    assert len(probabilities) == 1, "it is not slippery"
    changed = Policy.load(trained, {"is_slippery": "true"}).domain
    assert isinstance(changed, GymDomain)
    assert len(changed._made.env.unwrapped.P[0][0]) == 3  # type: ignore[attr-defined]
    once, again = (evaluate(Policy.load(trained), 20) for _ in range(2))
    assert once == again
    bias = language_bias_of(policy.domain)
    assert bias.file == str(trained.with_name("FrozenLake-v1.yaml")) and bias.source
    assert not policy.domain.generated


def test_a_seed_reproduces_a_model_to_the_bit(trained: Path, tmp_path: Path) -> None:
    domain = opened("FrozenLake-v1", is_slippery="false")
    run(domain, language_bias_of(domain), Options(30, seed=1, guidance=0), tmp_path / "again", evaluate_every=0)
    for name in ("model.pl", "FrozenLake-v1.pl", "FrozenLake-v1.yaml"):
        assert (tmp_path / "again" / name).read_bytes() == (tmp_path / name).read_bytes()


def test_the_commands_tell_returns(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """There is no goal to reach."""
    model, output = str(tmp_path / "model.pl"), str(tmp_path)
    learn = ["--episodes", "24", "--evaluate-every", "12", "--starts", "3", "--output", output]
    assert main(["check", "gym:CartPole-v1"]) == 0
    assert main(["train", "gym:CartPole-v1", "--set", "max_episode_steps=3", *learn]) == 0
    capsys.readouterr()
    assert main(["evaluate", model, "--starts", "5"]) == 0
    told = capsys.readouterr().out
    assert told.startswith("mean return of the stochastic policy over 5 sampled start states: ")
    assert main(["play", model]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.startswith("obs(") for line in lines[:4]] == [True] * 4 and "do(1)" in "".join(lines)
    steps = lines[-1].split()[-2]
    assert lines[-1] == f"the return is {steps} after {steps} steps"
    assert main(["distill", model, "--max-rules", "2", "--explain"]) == 0
    assert "mean return of these rules over sampled 1,000 start states: " in capsys.readouterr().out
    assert "model(mean_return, " in (tmp_path / "rules.pl").read_text()
    assert main(["show", str(tmp_path / "rules.pl"), "--explain"]) == 0
    assert "delta(1, do(_), " in capsys.readouterr().out
    assert main(["prove", model]) == 2


@pytest.mark.parametrize("id", ["CartPole-v1", TAXI])
def test_plain_prolog_chooses_like_the_policy(id: str, tmp_path: Path) -> None:
    domain = opened(id)
    progress = run(domain, language_bias_of(domain), Options(12, seed=0, guidance=0), tmp_path, evaluate_every=0)
    policy = progress.policy
    assert policy.trees
    states = [step.state for step in generate_episode(policy, np.random.default_rng(0)).steps][:5]
    actions = [("do", number) for number in range(domain._made.env.action_space.n)]  # type: ignore[attr-defined]
    for state, (action, potential) in zip(states, in_plain_prolog(tmp_path / "model.pl", states), strict=True):
        expected = policy.potentials(state, actions)
        assert expected[list(map(term, actions)).index(action)] == expected.max() == pytest.approx(potential, rel=1e-12)


class Refused(gymnasium.Env):
    """Observations or actions of a space that no domain has."""

    def __init__(self, observations: str = "box", actions: str = "discrete"):
        known = {
            "box": spaces.Box(0, 1, (2,), np.float32),
            "discrete": spaces.Discrete(2),
            "tuple": spaces.Tuple([spaces.Discrete(2), spaces.Box(0, 1, (2,), np.float32)]),
            "dict": spaces.Dict({"a": spaces.Discrete(3), "b": spaces.MultiBinary(2)}),
            "multi": spaces.MultiDiscrete([2, 3]),
            "text": spaces.Text(5),
            "sequence": spaces.Sequence(spaces.Discrete(2)),
        }
        self.observation_space, self.action_space = known[observations], known[actions]

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict]:
        super().reset(seed=seed)
        self.observation_space.seed(seed)
        return self.observation_space.sample(), {}

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict]:
        return self.observation_space.sample(), 1.0, True, False, {}


@pytest.mark.parametrize(
    ("observations", "actions", "wrapper"),
    [
        ("tuple", "discrete", "FlattenObservation"),
        ("dict", "discrete", "FlattenObservation"),
        ("multi", "discrete", "FlattenObservation"),
        ("text", "discrete", "FlattenObservation"),
        ("sequence", "discrete", "TransformObservation"),
        ("box", "box", "DiscretizeAction"),
        ("box", "multi", "TransformAction"),
    ],
)
def test_refused_spaces_name_the_wrapper_that_helps(
    observations: str, actions: str, wrapper: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gymnasium.envs.registration, "registry", dict(gymnasium.registry))
    gymnasium.register("Refused-v0", entry_point=lambda: Refused(observations, actions))
    with pytest.raises(NppgError, match=rf"gymnasium\.wrappers\.{wrapper} makes such ones"):
        open_domain("gym:Refused-v0")
    if wrapper == "FlattenObservation":
        helped = gymnasium.wrappers.FlattenObservation
        gymnasium.register("Helped-v0", entry_point=lambda: helped(Refused(observations, actions)))
        assert open_domain("gym:Helped-v0").start(np.random.default_rng(1))
