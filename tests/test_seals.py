"""Files that were damaged are refused, and those that were edited are taken where somebody says so."""

from __future__ import annotations

import json
import os
import random
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from samples import in_plain_prolog
from test_checkpoints import files, kept

from nppg.bridge.files import shipped
from nppg.bridge.seals import fault, opened, parts, sealed
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.experiments import checkpoints, run_files
from nppg.experiments.run_files import is_finished, summary_of
from nppg.policy.copies import BEFORE, CHECKPOINT
from nppg.policy.policy import Policy
from nppg.rules.certificates import check_certificate
from nppg.rules.proof import prove

DAMAGES = 2000 if "NPPG_SOAK" in os.environ else 60  # of each kind of file
SMALL = ["train", "blocks_world", "--set", "blocks=3", "--min-examples", "20", "--evaluate-every", "5"]


@pytest.fixture(scope="module")
def trained(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a run, with its certificate."""
    folder = tmp_path_factory.mktemp("run")
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(run_files, "_draw", lambda *_: False)
        assert main([*SMALL, "--episodes", "30", "--quiet", "--output", str(folder)]) == 0
    policy = Policy.load(folder / "model.pl")
    assert policy.trees
    prove(policy, folder / "model.pl").save(folder / "proof.json")
    return folder


@pytest.fixture
def folder(trained: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(run_files, "_draw", lambda *_: False)
    return Path(shutil.copytree(trained, tmp_path / "run"))


def damaged(data: bytes, draw: random.Random) -> bytes:
    """A bit flipped, a character changed, one more, one less, or cut off."""
    at = draw.randrange(len(data))
    other = bytes([draw.choice([each for each in b"0123456789 \n.,(abXY\"'%{\0\xff" if each != data[at]])])
    return draw.choice(
        [
            data[:at] + bytes([data[at] ^ 1 << draw.randrange(8)]) + data[at + 1 :],
            data[:at] + other + data[at + 1 :],
            data[:at] + other + data[at:],
            data[:at] + data[at + 1 :],
            data[:at],
        ]
    )


@pytest.mark.parametrize("name", ["model.pl", "proof.json", CHECKPOINT, "run.json"])
def test_no_damaged_file_is_taken_for_another(folder: Path, name: str) -> None:
    path, draw = folder / name, random.Random(name)
    proof = prove(Policy.load(folder / "model.pl"), folder / "model.pl")
    readers: dict[str, Callable[[], object]] = {
        "model.pl": lambda: Policy.load(path),
        "proof.json": lambda: check_certificate(path, proof),
        CHECKPOINT: lambda: checkpoints.read(path),
        "run.json": lambda: summary_of(folder),
    }
    whole, read = path.read_bytes(), readers[name]
    read()
    for _ in range(DAMAGES):
        path.write_bytes(data := damaged(whole, draw))
        if data == whole:  # a zero beside a zero
            continue
        with pytest.raises(NppgError) as caught:
            read()
        assert len(caught.value.problems) == 1 and "\n" not in str(caught.value)
        assert str(caught.value).startswith(str(path))
    path.write_bytes(parts(whole)[0])  # no line, no check?
    with pytest.raises(NppgError, match=f"has no checksum: .*: nppg sign {path}"):
        read()


@pytest.mark.parametrize("content", [b"", b"{}", b'{"a": 1}\n', b"a(1).\n", b"% SHA-256", b"{\r\n 1}", b"\xff"])
def test_a_checksum_is_over_the_rest(content: bytes, tmp_path: Path) -> None:
    data = sealed(content)
    assert parts(data)[0] == content and fault(data) is None and sealed(data) == data and fault(content)
    (tmp_path / "file").write_bytes(data)
    assert opened(tmp_path / "file", bytes) == content


def test_the_models_that_come_along_are_signed() -> None:
    found = list((shipped("domains").parent / "models").glob("*/*/*.pl"))
    models = [path for path in found if path.name in ("model.pl", "rules.pl")]
    assert len(models) > 10 and not [path for path in models if fault(path.read_bytes())]


# ---------------------------------------------------------------- edited on purpose


def edit(model: Path, value: float = 7.5) -> None:
    """Changes what the last rule says."""
    head, _ = model.read_text().rsplit(", ", 1)
    model.write_text(f"{head}, {value}).\n")


@pytest.mark.parametrize("verb", [["evaluate"], ["show"], ["play"], ["distill"], ["prove"]], ids=lambda verb: verb[0])
def test_an_edited_model_is_taken_where_that_is_said(
    verb: list[str], folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    model = folder / "model.pl"
    edit(model)
    assert main([*verb, str(model)]) == 2
    error = capsys.readouterr().err
    again = f"nppg train --resume {folder} writes it anew from the checkpoint there"
    assert f"{model}: was damaged or edited: its checksum is another; {again}; " in error and error.count("\n") == 1
    assert error.endswith(f"nppg sign {model}, or --edited (edited=True)\n")
    assert main([*verb, str(model), "--edited"]) == 0


def test_what_was_edited_is_what_counts(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model = folder / "model.pl"
    before = Policy.load(model)
    edit(model)
    (folder / CHECKPOINT).write_bytes(b"{")
    assert main(["show", str(model)]) == 2 and "--resume" not in capsys.readouterr().err
    policy = Policy.load(model, edited=True)
    assert policy.trees != before.trees
    assert main(["sign", str(model)]) == 0 and Policy.load(model).trees == policy.trees
    (line, *_) = in_plain_prolog(model, [policy.domain.state("on(b1, floor), on(b2, b3), on(b3, floor)")])
    assert line


def test_an_edited_certificate_is_taken_where_that_is_said(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    check = ["prove", str(folder / "model.pl"), "--check", str(folder / "proof.json")]
    text = (folder / "proof.json").read_text()
    (folder / "proof.json").write_text(text + "\n")
    assert main(check) == 2 and "was damaged or edited" in capsys.readouterr().err
    assert main([*check, "--edited"]) == 0
    (folder / "proof.json").write_text(json.dumps(json.loads(text)))  # an editor has put it on one line
    assert main(["sign", str(folder / "proof.json")]) == 0 and main(check) == 0
    assert (folder / "proof.json").read_text().count("sha256") == text.count("sha256")


def test_only_files_of_nppg_are_signed(folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "other.json").write_text('{"a": 1}')
    (tmp_path / "list.json").write_text("{")
    others = [folder / "blocks_world.pl", tmp_path / "other.json", tmp_path / "list.json", tmp_path / "nowhere", folder]
    before = [path.read_bytes() for path in others[:3]]
    assert main(["sign", *map(str, others), str(folder / "run.json")]) == 2
    told = capsys.readouterr()
    assert [line.split(":")[0] for line in told.err.splitlines()] == [str(path) for path in others]
    assert told.out == f"{folder / 'run.json'}: signed\n" and before == [path.read_bytes() for path in others[:3]]
    for path in (folder / name for name in ("model.pl", "proof.json", CHECKPOINT, "run.json")):
        data = path.read_bytes()
        path.write_bytes(b"\xef\xbb\xbf" + parts(data)[0])  # as some editors save it
        assert main(["sign", str(path)]) == 0 and path.read_bytes() == data


# ---------------------------------------------------------------- what is left then


def test_the_checkpoint_before_a_damaged_one_is_taken(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    whole = files(folder)
    with monkeypatch.context() as patched:
        stored = kept(patched)
        assert main([*SMALL, "--episodes", "30", "--quiet", "--output", str(folder)]) == 0
    assert files(folder) == whole and not (folder / BEFORE).exists()
    before, there = stored[3], stored[17]
    (folder / "model.pl").write_bytes(b"")
    assert main(["train", "--resume", str(folder), "--quiet"]) == 0 and files(folder) == whole
    assert capsys.readouterr().err == ""
    for damage in (b"", b"{", None, there[:-9]):
        (folder / CHECKPOINT).unlink() if damage is None else (folder / CHECKPOINT).write_bytes(damage)
        (folder / "model.pl").write_bytes(b"")
        (folder / BEFORE).write_bytes(before)
        assert main(["train", "--resume", str(folder)]) == 0
        error = capsys.readouterr().err
        what = "is missing" if damage is None else "is damaged"
        assert f"{folder / CHECKPOINT}: {what}, so the run goes on from the one before, of episode 4" in error
        assert files(folder) == whole and checkpoints.read(folder / CHECKPOINT).run["count"] == 30
    (folder / CHECKPOINT).write_bytes(b"{")
    (folder / BEFORE).write_bytes(b"{")
    assert main(["train", "--resume", str(folder)]) == 2
    error = capsys.readouterr().err
    assert error.startswith(f"{folder / CHECKPOINT}: ") and error.count("\n") == 1


def test_a_run_with_a_damaged_summary_is_done_again(folder: Path) -> None:
    wanted = {"learner": "nppg"}
    assert is_finished(folder, wanted)
    (folder / "run.json").write_bytes((folder / "run.json").read_bytes()[:-20])
    with pytest.warns(UserWarning, match=r"run\.json: was damaged or edited: .*; the run is done again"):
        assert not is_finished(folder, wanted)


def test_other_versions_and_trust_are_told(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = folder / CHECKPOINT
    version = json.loads(path.read_text())["versions"]["numpy"]
    path.write_bytes(sealed(path.read_bytes().replace(f'"numpy": "{version}"'.encode(), b'"numpy": "0.9"')))
    assert summary_of(folder)["trust"] is False
    assert main(["train", "--resume", str(folder), "--trust", "--episodes", "31"]) == 0
    assert f"was written with numpy 0.9, not {version}: the run may not go on" in capsys.readouterr().err
    assert summary_of(folder)["trust"] is True


@pytest.fixture(autouse=True)
def no_trust(monkeypatch: pytest.MonkeyPatch) -> None:
    """--trust is said to processes that are started, too."""
    monkeypatch.setenv("NPPG_TRUST", "0")
