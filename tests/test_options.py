"""Where the options of a run come from: the command line, else the language bias, else the defaults."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from nppg import LanguageBias, NppgError, Options, TGOptions, language_bias_of, open_domain, options_of, run, train
from nppg.cli.main import main
from nppg.experiments.learners import LEARNERS

BIAS = "action: go(+x)\ntypes: {p: [x]}\nmodes: [p(+)]\n"
WORLD = """\
:- module(world, []).
:- fluent at/1.
room(a). room(b).
start([at(a)]).
action(go(X)) :- room(X), \\+ at(X).
effect(go(X), [at(Y)], [at(X)]) :- at(Y).
goal :- at(b).
horizon(2).
"""
WORLD_BIAS = "action: go(+room)\ntypes: {at: [room]}\nmodes: [at(+)]\n"


def bias_with(options: str, text: str = BIAS) -> LanguageBias:
    return LanguageBias.parse(f"{text}options: {options}\n", "b.yaml")


def problems(options: str) -> list[str]:
    with pytest.raises(NppgError) as caught:
        options_of(bias_with(options))
    return [str(each).removeprefix("b.yaml:") for each in caught.value.problems]


@pytest.fixture
def world(tmp_path: Path) -> Path:
    (tmp_path / "world.pl").write_text(WORLD)
    (tmp_path / "world.yaml").write_text(
        WORLD_BIAS + "options: {step: second-order, discount: 1, episodes: 8, min_examples: 3}\n"
    )
    return tmp_path / "world.pl"


def test_given_before_the_bias_before_the_defaults() -> None:
    bias = bias_with("{step: second-order, discount: 0.9, normalise: yes}")
    expected = Options(step="second-order", discount=0.5, normalise="yes", seed=3)
    assert options_of(bias, discount=0.5, seed=3) == expected
    assert options_of(LanguageBias.parse(BIAS, "b.yaml")) == Options()
    assert options_of(replace(bias, options={"seed": 4})) == Options(seed=4)


def test_a_whole_number_is_a_number() -> None:
    """As on the command line, so that the same is recorded."""
    assert repr(options_of(bias_with("{discount: 1, importance: 0}"))) == repr(Options(discount=1.0, importance=0.0))


def test_the_bias_may_choose_the_learner() -> None:
    bias = bias_with("{learner: tg, min_sample: 50, max_depth: 3}")
    assert options_of(bias) == TGOptions(min_sample=50, max_depth=3)
    assert options_of(bias, "nppg", seed=1) == Options(seed=1)
    assert options_of(bias_with("{step: second-order, discount: 0.8, temperature: 2}"), "tg") == TGOptions(
        discount=0.8, temperature=2.0
    )


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ("{stp: gradient}", ["4:11: no learner has the option 'stp' (did you mean 'step'?)"]),
        ("{xyzzy: 1}", ["4:11: no learner has the option 'xyzzy'"]),
        ("{discount: 2}", ["4:21: discount must be from 0 to 1, not 2"]),
        ("{temperature: hot}", ["4:24: temperature must be a number, not 'hot'"]),
        ("{critic: yes, seed: 1.5}", [
            "4:19: critic must be one of none, value, not 'yes'",
            "4:30: seed must be a whole number, not 1.5",
        ]),
        ("{learner: trend}", [
            f"4:20: learner must be one of {', '.join(LEARNERS)}, not 'trend' (did you mean 'trendi'?)"
        ]),
        ("{max_depth: 3}", [
            "4:11: max_depth limits trees: write tree: {max_depth: ...}, unless the option learner is tg or trendi"
        ]),
        ("{learner: rib, max_depth: 3}", [
            "4:25: max_depth limits trees: write tree: {max_depth: ...}, unless the option learner is tg or trendi"
        ]),
        ("{granularity: 3}", ["4:11: granularity limits trees: write tree: {granularity: ...}"]),
        ("{min_leaf: 3}", ["4:11: min_leaf limits trees: write tree: {min_examples: ...}"]),
    ],
)  # fmt: skip
def test_mistakes_in_the_bias(options: str, expected: list[str]) -> None:
    assert problems(options) == expected


def test_mistakes_in_what_is_given() -> None:
    bias = bias_with("{}")
    with pytest.raises(NppgError, match=r"^stp is no option of the learner nppg \(did you mean 'step'\?\)$"):
        options_of(bias, stp="gradient")
    with pytest.raises(NppgError, match=rf"^learner must be one of {', '.join(LEARNERS)}, not 'gt'"):
        options_of(bias, "gt")
    with pytest.raises(NppgError, match=r"^discount must be"):
        options_of(bias, discount=2)


def test_python_learns_with_the_options_of_the_bias(world: Path, tmp_path: Path) -> None:
    domain = open_domain(world)
    bias = language_bias_of(domain)
    assert [each.episodes for each in train(domain, bias)][-1] == 8
    assert [each.episodes for each in train(domain, bias, Options(episodes=4))][-1] == 4
    progress = run(domain, bias, None, tmp_path / "out", evaluate_every=0)
    assert progress.options == options_of(bias) == Options(episodes=8, min_examples=3, step="second-order")


def test_the_command_line_comes_first_and_what_was_learned_with_is_recorded(
    world: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["train", str(world), "--episodes", "6", "--output", str(tmp_path / "out"), "--quiet"]) == 0
    recorded = json.loads((tmp_path / "out" / "run.json").read_text())["options"]
    assert (recorded["episodes"], recorded["min_examples"], recorded["step"]) == (6, 3, "second-order")
    assert "model(option, step='second-order')." in (tmp_path / "out" / "model.pl").read_text()
    text = world.with_suffix(".yaml").read_text().replace("{step", "{learner: tg, step")
    world.with_suffix(".yaml").write_text(text)
    assert main(["train", str(world), "--step", "gradient"]) == 2
    assert capsys.readouterr().err == "--step is no option of the learner tg, but of nppg\n"
    assert main(["train", str(world), "--learner", "nppg", "--output", str(tmp_path / "out"), "--quiet"]) == 0
    assert json.loads((tmp_path / "out" / "run.json").read_text())["learner"] == "nppg"


@pytest.mark.parametrize("verb", ["check", "train"])
def test_mistakes_are_told_with_the_others(
    world: Path, verb: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    file = world.with_suffix(".yaml")
    file.write_text(WORLD_BIAS.replace("at", "att") + "options: {step: newton}\n")
    arguments = [verb, str(world), *(["--output", str(tmp_path / "out")] if verb == "train" else [])]
    assert main(arguments) == 2
    told = capsys.readouterr().err.splitlines()
    assert f"{file}:4:17: step must be one of gradient, second-order, not 'newton'" in told
    if verb == "check":
        assert told[0].startswith(f"{file}:3:9: the domain has no predicate att/1")
        world.write_text(WORLD + "goal :- .\n")
        assert main(arguments) == 2
        told = capsys.readouterr().err.splitlines()
        assert told[0].startswith(str(world)) and told[-1].startswith(f"{file}:4:17: step must be")


def test_an_environment_has_the_shipped_bias_of_its_name() -> None:
    """It tests what the generated one does."""
    gymnasium = pytest.importorskip("gymnasium")
    domain = open_domain("gym:" + max(each for each in gymnasium.registry if each.startswith("Taxi-v")))
    bias = language_bias_of(domain)
    assert Path(bias.file).name == "Taxi.yaml"
    assert bias.check(domain.predicates, domain.actions) == []
    generated = domain.language_bias()
    assert (bias.modes, bias.types, bias.max_variables) == (generated.modes, generated.types, generated.max_variables)
    assert options_of(bias).models == "per-action" and options_of(generated) == Options()
