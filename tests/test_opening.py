"""What names stand for: shipped domains, files, environments, and the language bias that goes with each."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from nppg import Domain, LanguageBias, NppgError, language_bias_of, open_domain
from nppg.bridge.files import shipped
from nppg.cli.main import main
from nppg.worlds.gym_domain import GymDomain

FILE = """:- module('Cart', []).
:- environment('CartPole-v1').
:- fluent obs/2.
action(do(0)).
action(do(1)).
"""


def test_names_and_files_are_domains_as_ever(tmp_path: Path) -> None:
    domain = open_domain("blocks_world", {"blocks": 3})
    assert type(domain) is Domain and domain.parameters["blocks"] == 3 and domain.environment == ""
    assert language_bias_of(domain) == LanguageBias.load(shipped("language_bias") / "blocks_world.yaml")
    with pytest.raises(NppgError, match="did you mean 'blocks_world'"):
        open_domain("blocks_wrld")
    with pytest.raises(NppgError, match="task=stack has a language bias of its own: give --bias stack"):
        language_bias_of(open_domain("blocks_world", {"task": "stack"}))
    copy = tmp_path / "mine.pl"
    copy.write_bytes((shipped("domains") / "delivery.pl").read_bytes())
    with pytest.raises(NppgError, match="there is no language bias of this name"):
        language_bias_of(open_domain(copy))
    copy.with_suffix(".yaml").write_bytes((shipped("language_bias") / "delivery.yaml").read_bytes())
    assert language_bias_of(open_domain(copy)).file == str(copy.with_suffix(".yaml"))


def test_every_kind_of_domain_has_a_language_bias_that_fits(tmp_path: Path) -> None:
    pytest.importorskip("gymnasium")
    file = tmp_path / "cart.pl"
    file.write_text(FILE)
    for name in ("blocks_world", "delivery", file, "gym:CartPole-v1", "gym:FrozenLake-v1"):
        domain = open_domain(name)
        assert language_bias_of(domain).check(domain.predicates, domain.actions) == []


def test_a_file_may_name_its_environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("gymnasium")
    file = tmp_path / "cart.pl"
    file.write_text(FILE + ":- parameter(max_episode_steps, 30).\nleft :- obs(1, X), X < 0.\n")
    domain = open_domain(file, {"sutton_barto_reward": "true"})
    assert isinstance(domain, GymDomain) and (domain.name, domain.environment) == ("Cart", "CartPole-v1")
    assert domain.parameters == {"sutton_barto_reward": "true", "max_episode_steps": 30}
    assert domain.horizon(()) == 30 and ("left", 0) in domain.predicates
    assert language_bias_of(domain).file == str(tmp_path / "cart.yaml")
    (tmp_path / "cart.yaml").write_text("action: do(+choice)\ntypes: {left: []}\nmodes: [left, 'equal(+choice, 0)']\n")
    assert [mode.name for mode in language_bias_of(domain).modes] == ["left", "="]
    (tmp_path / "CartPole-v1.yaml").write_text("nothing to do with it")
    monkeypatch.chdir(tmp_path)
    assert len(language_bias_of(open_domain("gym:CartPole-v1")).modes) == 6, "generated, whatever lies about"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("'CartPole-v1').", "'CartPol-v1').", "gym:CartPol-v1: Environment `CartPol` doesn't exist."),
        ("'CartPole-v1').", "cart(1)).", ":2: an environment of Gymnasium is declared by its id"),
        ("'CartPole-v1').", "_).", ":2: an environment of Gymnasium is declared by its id"),
        ("'CartPole-v1').", "'CartPole-v1').\n:- environment(other).", ":3: an environment is declared already:"),
        ("action(do(0)).", "", ":1: action/1 has to give do(0) to do(1), the actions of the environment CartPole-v1"),
        ("action(do(0)).", "action(do(0)) :- obs(1, 0.0).", ":1: action/1 has to give do(0) to do(1)"),
        ("action(do(0)).\naction(do(1)).", "", ":1: action/1 is missing"),
        ("obs/2", "seen/2", ":1: the only fluent of an environment is obs/2"),
        ("obs/2", "obs/2, seen/1", ":1: the only fluent of an environment is obs/2"),
        (":- fluent obs/2.", "", ":1: no fluent is declared"),
        ("action(do(1)).", "action(do(1)).\nlow :- obs(1, X), X < limitt.\nhigh :- lo.", "unknown predicate lo/0"),
        *(
            (
                "action(do(0)).",
                f"action(do(0)).\n{clause}",
                f":5: {name} has no place in this file: the dynamics are those",
            )
            for name, clause in {
                "start/1": "start([]).",
                "effect/3": "effect(_, [], []).",
                "effect/4": "effect(_, 1, [], []).",
                "goal/0": "goal :- obs(1, 0.0).",
                "terminal/0": "terminal.",
                "reward/2": "reward(_, 1).",
                "horizon/1": "horizon(3).",
                "observation/1": "observation([]).",
            }.items()
        ),
        (":- fluent", ":- uniform_start.\n:- fluent", ":1: uniform_start has no place in this file"),
    ],
)
def test_mistakes_in_such_a_file(
    tmp_path: Path, old: str, new: str, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("gymnasium")
    file = tmp_path / "cart.pl"
    assert old in FILE
    file.write_text(FILE.replace(old, new))
    assert main(["check", str(file)]) == 2
    errors = capsys.readouterr().err.splitlines()
    assert any(message in each for each in errors), errors


def test_such_a_file_is_no_domain_by_itself(tmp_path: Path) -> None:
    file = tmp_path / "cart.pl"
    file.write_text(FILE)
    with pytest.raises(NppgError, match="open the file by nppg"):
        Domain(file).start(np.random.default_rng(0))
