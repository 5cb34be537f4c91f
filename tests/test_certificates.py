"""Certificates: what they claim, and that no other claim passes."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from samples import resigned

from nppg.bias.language_bias import LanguageBias
from nppg.cli.main import main
from nppg.judging.evaluation import ExactEvaluator
from nppg.judging.space import Space
from nppg.policy.policy import Policy
from nppg.rules.proof import prove
from nppg.worlds.domain import Domain

WALK = """
:- module(walk, []).
:- fluent at/1.
:- uniform_start.
at_start :- at(start).
start([at(start)]).
goal :- at(goal).
terminal :- at(lost).
action(on).
action(off).
effect(on, SLIP, [at(start)], [at(lost)]).
effect(on, STAY, [at(start)], [at(goal)]).
effect(off, 1, [at(start)], [at(lost)]).
horizon(1).
"""
BIAS = "action: [on, off]\ntypes: {at_start: []}\nmodes: [at_start]\n"


def walk(folder: Path, slip: str, preference: float) -> Path:
    """A model that prefers `on`, which fails with a small probability."""
    text = WALK.replace("SLIP", slip).replace("STAY", f"{1 - float(slip)!r}")
    if slip == "0":
        text = text.replace("effect(on, 0, [at(start)], [at(lost)]).\n", "")
    (folder / "walk.pl").write_text(text)
    (folder / "bias.yaml").write_text(BIAS)
    policy = Policy(Domain(folder / "walk.pl"), LanguageBias.load(folder / "bias.yaml"))
    path = folder / "model.pl"
    policy.save(path)
    text = path.read_text().replace("model(trees, 0)", "model(trees, 1)")
    resigned(path, f"{text}\ndelta(1, on, {preference}) :- !.\ndelta(1, _, 0.0).\n")
    return path


@pytest.mark.parametrize(
    ("slip", "preference", "greedy", "complete"),
    [
        ("0", 1.0, True, True),
        ("1.0e-12", 1.0, True, False),
        ("0", 30.0, False, False),
        ("0", 1000.0, False, False),
        ("0", -1.0, True, False),
    ],
)
def test_a_policy_that_can_fail_is_not_certified(
    tmp_path: Path, slip: str, preference: float, greedy: bool, complete: bool
) -> None:
    """However small the probability is, and where it underflows."""
    model = walk(tmp_path, slip, preference)
    proof = prove(Policy.load(model), model, greedy)
    assert proof.complete is complete and len(proof.failures) == (not complete)
    assert (proof.success == 1.0) >= complete
    assert proof.failures == () or proof.failures[0].states == proof.starts == 1
    assert slip != "1.0e-12" or 0 < 1 - proof.success < 1e-9


def test_certain_is_certain(four_blocks: Domain, four: Space, plain_bias: LanguageBias) -> None:
    """Where probabilities can be trusted, the classes with certain success are those with probability 1."""
    judge = ExactEvaluator(Policy(four_blocks, plain_bias), four)
    for greedy in (False, True):
        success, _ = judge.by_class(greedy)
        assert np.array_equal(judge.certain(greedy), success > 1 - 1e-6)


@pytest.fixture(scope="module")
def proved(tmp_path_factory: pytest.TempPathFactory, plain_bias: LanguageBias) -> Path:
    """A folder with a model, its domain and its certificate."""
    folder = tmp_path_factory.mktemp("proved")
    Policy(Domain("blocks_world", {"blocks": 3}), plain_bias).save(folder / "model.pl")
    assert main(["prove", str(folder / "model.pl"), "--output", str(folder / "certificate.json"), "--show", "0"]) == 0
    return folder


@pytest.fixture
def model(proved: Path, tmp_path: Path) -> Path:
    """A copy of all of it, to change."""
    shutil.copytree(proved, tmp_path, dirs_exist_ok=True)
    return tmp_path / "model.pl"


@pytest.fixture
def certificate(model: Path) -> Path:
    return model.with_name("certificate.json")


def test_a_certificate_is_confirmed(model: Path, certificate: Path, capsys) -> None:
    assert main(["prove", str(model), "--check", str(certificate)]) == 0
    assert "was proved again, with the same result" in capsys.readouterr().out


def claims(certificate: Path) -> dict:
    return {name: value for name, value in json.loads(certificate.read_text()).items() if name != "sha256"}


@pytest.mark.parametrize(("options", "named"), [(["--set", "blocks=4"], "parameters"), (["--stochastic"], "greedy")])
def test_a_certificate_about_another_policy_is_refused(model, certificate, capsys, options, named) -> None:
    assert main(["prove", str(model), "--check", str(certificate), *options]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert named in line.rpartition(":")[2]


@pytest.mark.parametrize("file", ["model", "domain"])
def test_a_certificate_about_other_files_is_refused(model: Path, certificate: Path, capsys, file: str) -> None:
    changed = model if file == "model" else model.with_name("blocks_world.pl")
    text = changed.read_text() + "\n"
    resigned(changed, text) if file == "model" else changed.write_text(text)
    assert main(["prove", str(model), "--check", str(certificate)]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.endswith(f"about: {file}") if file == "model" else "blocks_world.pl" in line


@pytest.mark.parametrize(
    ("name", "value"),
    [("success", 1.0), ("failures", []), ("starts", 11), ("greedy", False), ("parameters", {}), ("more", 1)],
)
def test_changed_claims_are_refused(model: Path, certificate: Path, capsys, name: str, value: object) -> None:
    resigned(certificate, json.dumps(claims(certificate) | {name: value}))
    assert main(["prove", str(model), "--check", str(certificate)]) == 2
    assert capsys.readouterr().err.endswith(f"about: {name}\n")


def test_missing_claims_are_refused(model: Path, certificate: Path, capsys) -> None:
    contents = claims(certificate)
    for name in contents:
        resigned(certificate, json.dumps({each: contents[each] for each in contents if each != name}))
        assert main(["prove", str(model), "--check", str(certificate)]) == 2
        assert len(capsys.readouterr().err.splitlines()) == 1


@pytest.mark.parametrize("text", ["", "[]", "{}", "1", "{", "\udcff"])
def test_what_is_no_certificate_is_refused(model: Path, certificate: Path, capsys, text: str) -> None:
    certificate.write_bytes(text.encode(errors="surrogateescape"))
    assert main(["prove", str(model), "--check", str(certificate)]) == 2
    assert "this is no certificate of nppg" in capsys.readouterr().err
    certificate.unlink()
    assert main(["prove", str(model), "--check", str(certificate)]) == 2
    assert "cannot be read" in capsys.readouterr().err
