"""What becomes of ids and arguments: an environment, or one line that says what is wrong."""

from __future__ import annotations

import subprocess
import sys
import warnings
from typing import Any

import pytest

from nppg import NppgError
from nppg.worlds.gym_make import make

gymnasium = pytest.importorskip("gymnasium")


class Keen(gymnasium.Env):
    """Takes any arguments, and is a little loud."""

    observation_space = action_space = gymnasium.spaces.Discrete(2)

    def __init__(self, **arguments: Any):
        if "fail" in arguments:
            raise RuntimeError("two\nlines")
        self.arguments = arguments
        for _ in range(3):
            warnings.warn("\x1b[33mWARN: \x1b[0mold", stacklevel=1)


gymnasium.register("Keen-v0", Keen)
gymnasium.register("Keen-v1", Keen, max_episode_steps=12)


@pytest.mark.parametrize(
    ("id", "parameters", "message"),
    [
        ("CartPol-v1", {}, "gym:CartPol-v1: Environment `CartPol` doesn't exist. Did you mean: `CartPole`?"),
        ("CartPole-v99", {}, "gym:CartPole-v99: Environment version `v99` for environment `CartPole` doesn't exist."),
        ("", {}, "gym:: Malformed environment ID"),
        ("no_such_module:Foo-v0", {}, "ModuleNotFoundError: No module named 'no_such_module'"),
        ("CartPole-v1", {"sutton_barto": "true"}, "no parameter sutton_barto (did you mean 'sutton_barto_reward'?)"),
        ("CartPole-v1", {"q": 1}, "there is no parameter q; the environment has sutton_barto_reward, render_mode"),
        ("FrozenLake-v1", {"is_slippery": "maybe"}, "is_slippery must be true or false, not 'maybe'"),
        ("FrozenLake-v1", {"is_slippery": 0}, "is_slippery must be true or false, not 0"),
        ("FrozenLake-v1", {"map_name": "9x9"}, "KeyError: '9x9'"),
        ("CartPole-v1", {"max_episode_steps": 0}, "max_episode_steps must be a whole number of at least 1, not 0"),
        ("CartPole-v1", {"max_episode_steps": 2.5}, "max_episode_steps must be a whole number of at least 1, not 2.5"),
        ("CartPole-v1", {"id": 3}, "gym:CartPole-v1: "),
        ("Keen-v1", {"fail": 1}, "gym:Keen-v1: RuntimeError: two lines"),
    ],
)
def test_mistakes_are_one_line(id: str, parameters: dict, message: str) -> None:
    with pytest.raises(NppgError) as caught:
        make(id, parameters)
    assert str(caught.value).startswith(f"gym:{id}: ") and "\n" not in str(caught.value)
    assert message in str(caught.value)


def test_names_that_say_true_or_false_are_truth_values() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        env = make("Keen-v1", {"a": "true", "b": "False", "c": "other", "d": 2, "e": 0.5}).env.unwrapped
    assert isinstance(env, Keen)
    assert env.arguments == {"a": True, "b": False, "c": "other", "d": 2, "e": 0.5}


def test_gymnasium_warns_once_and_in_plain_text() -> None:
    with pytest.warns() as noted:
        made = make("Keen", {})
    assert made.id == "Keen-v1", "the version that Gymnasium chose"
    said = [str(each.message) for each in noted]
    assert sorted(said) == sorted(set(said)) and "gym:Keen: old" in said
    assert any("Keen-v1" in each for each in said) and not any("\x1b" in each or "WARN" in each for each in said)


def test_the_horizon_is_the_registered_one_unless_it_is_given() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert [make("Keen-v1", {}).horizon, make("Keen-v0", {}).horizon] == [12, 1000]
        assert make("Keen-v1", {"max_episode_steps": 40}).horizon == 40
        names = str(make("Keen-v1", {}).env)
    assert "TimeLimit" not in names and "PassiveEnvChecker" not in names


def test_the_module_that_registers_an_environment_stays_in_its_id() -> None:
    assert make("gymnasium:CartPole-v1", {}).id == "gymnasium:CartPole-v1"


def test_without_gymnasium_the_mend_is_named() -> None:
    hidden = "import sys; sys.modules['gymnasium'] = None"
    program = f"{hidden}\nfrom nppg.cli.main import main\nsys.exit(main(sys.argv[1:]))"
    command = [sys.executable, "-c", program]
    result = subprocess.run([*command, "check", "gym:CartPole-v1"], capture_output=True, text=True, timeout=120)
    assert result.returncode == 2
    assert result.stderr == "gym:CartPole-v1 needs gymnasium, which is not installed: pip install 'nppg[gym]'\n"
    assert subprocess.run([*command, "check", "delivery"], capture_output=True, timeout=120).returncode == 0
