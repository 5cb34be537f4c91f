"""nppg tilde: from files to a tree, a model and predictions."""

from __future__ import annotations

import json
import shutil

import pytest

from nppg.cli.main import main

SETTINGS = """
load(key).
predict(machine(+machine, -action)).
minimal_cases(1).
typed_language(yes).
type(worn(machine, comp)).
type(irreplaceable(comp)).
rmode(worn(+K, +-X)).
rmode(irreplaceable(+X)).
"""
KNOWLEDGE = """
machine(m1, fix). machine(m2, sendback). machine(m3, ok). machine(m4, fix). machine(m5, ok). machine(m6, sendback).
worn(m1, gear). worn(m2, engine). worn(m4, chain). worn(m6, gear). worn(m6, engine).
age(m1, 2.0). age(m2, 9.0). age(m3, 1.0). age(m4, 2.5). age(m5, 1.0). age(m6, 8.0).
"""


@pytest.fixture
def machines(tmp_path):
    (tmp_path / "mach.s").write_text(SETTINGS)
    (tmp_path / "mach.kb").write_text(KNOWLEDGE)
    (tmp_path / "mach.bg").write_text("irreplaceable(engine).\n")
    return tmp_path


def test_fit_predict_and_show(machines, capsys):
    model = machines / "model.json"
    fit = ["tilde", "fit", str(machines), "--pruning", "none", "--cross-validate", "3", "--output", str(model)]
    assert main(fit) == 0
    out = capsys.readouterr().out
    tree = """
machine(A)
worn(A, B) ?
+--yes: irreplaceable(B) ?
|       +--yes: [sendback] [2/2]
|       +--no:  [fix] [2/2]
+--no:  [ok] [2/2]

machine(A, sendback) :- worn(A, B), irreplaceable(B), !.  % 2/2
machine(A, fix) :- worn(A, B), !.  % 2/2
machine(A, ok).  % 2/2
"""
    assert tree in out and "accuracy 1.0000 = 6/6" in out and "of 3 folds" in out and "learned in" in out
    assert main(["tilde", "show", str(model)]) == 0
    assert capsys.readouterr().out == tree[1:] + "\n"
    assert main(["tilde", "predict", str(model), str(machines)]) == 0
    assert capsys.readouterr().out.splitlines()[:2] == ["m1\tfix\t1.0000", "m2\tsendback\t1.0000"]


def test_another_target(machines, capsys):
    assert main(["tilde", "fit", str(machines), "--target", "age(+machine, -years)"]) == 0
    out = capsys.readouterr().out
    assert "age(A, 8.5) :- worn(A, B), irreplaceable(B), !.  % 2" in out and "root mean squared error 0.3" in out


def test_many_trees(machines, capsys):
    assert (
        main(["tilde", "fit", str(machines), "--n-estimators", "4", "--learning-rate", "0.5", "--max-depth", "2"]) == 0
    )
    assert "12 trees, the first of them" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--target", "agee(+m, -n)"], "did you mean 'age'"),
        (["--target", "age(m, n)"], "write what is given with + and what is to be told with -"),
        (["--cross-validate", "9"], "folds must be at least 2 and at most the 6 examples, not 9"),
        (["--heuristic", "variance"], "heuristic must be gain_ratio or gain to classify"),
        (["--max-dept", "3"], "--max-depth"),
    ],
)
def test_mistakes_are_one_line(machines, capsys, arguments, message):
    assert main(["tilde", "fit", str(machines), *arguments]) == 2
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1


def test_a_model_asks_what_its_language_declares_alone(machines, capsys):
    model = machines / "model.json"
    assert main(["tilde", "fit", str(machines), "--pruning", "none", "--output", str(model)]) == 0
    head, body = model.read_text().splitlines()
    changed = body.replace('["Literal","irreplaceable"', '["Literal","shell"')
    assert changed != body
    from nppg.bridge.files import sha256

    model.write_text(json.dumps(json.loads(head) | {"sha256": sha256(changed.encode())}) + "\n" + changed + "\n")
    capsys.readouterr()
    assert main(["tilde", "predict", str(model), str(machines)]) == 2
    assert "holds something else than a model" in capsys.readouterr().err


def test_a_folder_with_several_data_sets(machines, tmp_path_factory, capsys):
    whole = tmp_path_factory.mktemp("sets")
    for name in ("good", "bad", "other"):
        shutil.copytree(machines, whole / name)
    (whole / "bad" / "mach.kb").write_text("machine(m1, fix")
    assert main(["tilde", "fit", str(whole)]) == 2
    said = capsys.readouterr()
    assert said.out.count("accuracy") == 2 and f"{whole / 'other'}:\n" in said.out
    assert said.err.count("\n") == 1 and said.err.startswith(str(whole / "bad" / "mach.kb"))
    assert main(["tilde", "fit", str(whole), "--output", str(whole / "model.json")]) == 2
    assert "--output takes one model" in capsys.readouterr().err
