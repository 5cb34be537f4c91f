"""What a policy sees in place of the state."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from nppg import train
from nppg.answers.coverage import root_table
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import Refiner
from nppg.bridge.files import locate
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.experiments.learners import LEARNERS
from nppg.judging.space import Space
from nppg.learning.episode import Episode, generate_episode
from nppg.learning.options import Options
from nppg.policy.policy import Policy
from nppg.rrl.qfunction import QFunction
from nppg.rrl.training import examples
from nppg.worlds.domain import Domain
from nppg.worlds.world import State

BIAS = LanguageBias.load(locate("noisy_blocks", "language_bias", ".yaml"))
HEAD = ":- module(odd, []).\n:- fluent at/1.\nstart([at(1)]).\naction(go).\neffect(go, [], []).\ngoal :- at(2).\n"


def noisy(noise: float) -> Domain:
    return Domain("noisy_blocks", {"blocks": 4, "noise": noise, "slack": 20})


def episodes(domain: Domain, count: int, seed: int = 0) -> list[Episode]:
    policy, rng = Policy(domain, BIAS), np.random.default_rng(seed)
    return [generate_episode(policy, rng) for _ in range(count)]


def blocks(state: State) -> set:
    return {fact[1] for fact in state if fact[0] == "on"}


def clear(state: State) -> set:
    return blocks(state) - {fact[2] for fact in state if fact[0] == "on"}


def looks_clear(seen: State) -> set:
    return {fact[1] for fact in seen if fact[0] == "looks_clear"}


@pytest.mark.parametrize(("noise", "low", "high"), [(0.0, 0, 0), (0.3, 0.25, 0.35), (1.0, 1, 1)])
def test_how_often_it_is_wrong(noise: float, low: float, high: float) -> None:
    wrong = total = 0
    for episode in episodes(noisy(noise), 30):
        for step in episode.steps:
            assert not any(fact[0] == "on" for fact in step.state) and blocks(step.actual) == {"b1", "b2", "b3", "b4"}
            wrong += len(looks_clear(step.state) ^ clear(step.actual))
            total += 4
    assert total > 1000 and low <= wrong / total <= high


def test_tests_are_asked_of_what_is_seen() -> None:
    domain = noisy(0.5)
    table = root_table(domain, BIAS, Refiner(BIAS))
    policy, rng = Policy(domain, BIAS, table), np.random.default_rng(1)
    steps = [step for _ in range(5) for step in generate_episode(policy, rng).steps]
    assert len(steps) > 50
    differing = 0
    for step in steps:
        assert (step.answers == table.answers(step.state, step.actions)).all()
        goal = tuple(fact for fact in step.state if fact[0] == "goal_on")
        others = tuple(("looks_clear", each) for each in sorted(clear(step.actual)))
        differing += (step.answers != table.answers((*goal, *others), step.actions)).any()
    assert differing > len(steps) / 2


def test_dynamics_and_actions_are_those_of_the_state() -> None:
    domain = noisy(0.5)
    for episode in episodes(domain, 5):
        following = [step.actual for step in episode.steps[1:]] + [episode.actual]
        for step, after in zip(episode.steps, following, strict=True):
            _, moved, place = step.actions[step.chosen]
            possible = moved in clear(step.actual) and (place == "floor" or place in clear(step.actual))
            assert (("on", moved, place) in after) if possible else after == step.actual
            assert step.actions == domain.situation(step.actual).actions


def test_a_seed_reproduces_what_is_seen() -> None:
    first, second = (episodes(noisy(0.3), 3, seed=5) for _ in range(2))
    assert [[step.state for step in each.steps] for each in first] == [
        [step.state for step in each.steps] for each in second
    ]


def test_without_an_observation_the_state_is_seen(four_blocks: Domain, plain_bias: LanguageBias) -> None:
    episode = generate_episode(Policy(four_blocks, plain_bias), np.random.default_rng(0))
    assert episode.steps and all(step.state is step.actual for step in episode.steps)
    assert episode.last is episode.actual


def altered(path: Path, observation: str) -> Domain:
    """The blocks world, seen like this."""
    path.write_text(locate("blocks_world", "domains", ".pl").read_text() + f"\n{observation}\n")
    return Domain(path, {"blocks": 4})


def test_who_sees_all_learns_as_without_an_observation(
    tmp_path: Path, four_blocks: Domain, plain_bias: LanguageBias
) -> None:
    """To the bit, for nothing is drawn."""
    shown = "observation([goal_on(A, B)|Facts]) :- goal_on(A, B), findall(on(X, Y), on(X, Y), Facts)."
    options = Options(episodes=150, seed=3, min_examples=50)
    runs = [
        [(each.episodes, each.recent) for each in iterations]
        for iterations in (
            list(train(domain, plain_bias, options)) for domain in (four_blocks, altered(tmp_path / "seen.pl", shown))
        )
    ]
    assert len(runs[0]) == len(runs[1]) > 3
    for (count, plain), (seen_count, seen) in zip(*runs, strict=True):
        assert count == seen_count and len(plain) == len(seen)
        for one, other in zip(plain, seen, strict=True):
            assert (one.last, one.actual, one.success) == (other.last, other.actual, other.success)
            for step, same in zip(one.steps, other.steps, strict=True):
                assert (step.state, step.chosen, step.reward) == (same.state, same.chosen, same.reward)
                assert step.potentials.tobytes() == same.potentials.tobytes()


@pytest.mark.parametrize("learner", ["tg", "rib", "trendi"])
def test_value_functions_are_about_what_is_seen(learner: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Examples, and the last state of an episode that runs out of steps."""
    domain, asked = noisy(0.3), []
    options = LEARNERS[learner](episodes=40, seed=0)
    original = QFunction.potentials

    def potentials(self: QFunction, state: State, actions: list) -> np.ndarray:
        asked.append(state)
        return original(self, state, actions)

    monkeypatch.setattr(QFunction, "potentials", potentials)
    for iteration in train(domain, BIAS, options):
        for episode in iteration.recent:
            found = examples(episode, iteration.policy)  # type: ignore[arg-type]
            assert [each.state for each in found] == [step.state for step in reversed(episode.steps)]
            if episode.open:
                assert asked[-1] is episode.last
    assert asked and not any(fact[0] == "on" for state in asked for fact in state)


def test_the_goal_template_is_asked_in_what_is_seen(tmp_path: Path, plain_bias: LanguageBias) -> None:
    domain = altered(tmp_path / "hidden.pl", "observation(Facts) :- findall(on(X, Y), on(X, Y), Facts).")
    with pytest.raises(NppgError, match=r"goal_on/2 is the goal template .* must have one answer, but has 0") as caught:
        generate_episode(Policy(domain, plain_bias), np.random.default_rng(0))
    assert str(caught.value).count("\n") == 0


def test_a_draw_elsewhere_is_no_observation(tmp_path: Path) -> None:
    path = tmp_path / "odd.pl"
    path.write_text(f"{HEAD}observation([at(F)]) :- random(F).\npicture([F]) :- random(F).\n")
    domain, rng = Domain(path), np.random.default_rng(0)
    state = domain.start(rng)
    assert domain.observe(state, rng) != domain.observe(state, rng)
    with pytest.raises(NppgError, match=r"which only start/1, effects, reward/2 and observation/1 may") as caught:
        domain.picture(state)
    assert caught.value.problems[0].line == 8


def test_exact_evaluation_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    path = tmp_path / "blocks.pl"
    domain = altered(path, "observation([goal_on(b1, b2)]).")
    assert domain.uniform_start and not domain.is_countable
    for refused in (domain, noisy(0.1)):
        with pytest.raises(NppgError, match=r"see states as they are, not what observation/1 draws"):
            Space(refused)
    bias = locate("blocks_world", "language_bias", ".yaml")
    output = str(tmp_path / "run")
    settings = ["--bias", str(bias), "--set", "blocks=3", "--episodes", "60", "--output", output]
    assert main(["train", str(path), *settings]) == 0
    for command in (["evaluate", f"{output}/model.pl", "--exact"], ["prove", f"{output}/model.pl"]):
        capsys.readouterr()
        assert main(command) == 2
        error = capsys.readouterr().err
        assert "observation/1" in error and error.count("\n") == 1


@pytest.mark.parametrize(
    ("clause", "message"),
    [
        ("observation(_) :- fail.", "observation/1 failed"),
        ("observation(none).", "gave none where a list of facts is wanted"),
        ("observation([tall(b1)]).", "gave tall\\(b1\\), which is no fact of a declared fluent"),
        ("observation([X]) :- X is 1/0.", "observation/1 threw Arithmetic"),
    ],
)
def test_mistakes_are_located(tmp_path: Path, clause: str, message: str) -> None:
    path = tmp_path / "odd.pl"
    path.write_text(f"{HEAD}{clause}\n")
    domain, rng = Domain(path), np.random.default_rng(0)
    with pytest.raises(NppgError, match=message) as caught:
        domain.observe(domain.start(rng), rng)
    assert caught.value.problems[0].line == 7


def test_play_shows_both(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    policy = Policy(noisy(0.2), BIAS)
    policy.save(tmp_path / "model.pl")
    assert main(["play", str(tmp_path / "model.pl")]) == 0
    shown = capsys.readouterr().out
    assert "goal: " in shown and "seen: " in shown and "looks_clear(" in shown
