"""The doctor and the home of Prolog: what would abort the process becomes a finding with its mend."""

import os
import shutil
import subprocess
import sys
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import pytest

from nppg.bridge import home as prolog_home
from nppg.bridge.doctor import Check, doctor, report

ROOT = Path(__file__).parent.parent
PROBE = "import janus_swi; print(janus_swi.query_once('X is 6*7')['X'])"


by_home = pytest.mark.skipif(
    prolog_home.linked().bundled, reason="janus-swi with SWI-Prolog inside keeps to it: tests/test_wheels.py"
)


def python(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    inherited = {name: value for name, value in os.environ.items() if name != "SWI_HOME_DIR"}
    return subprocess.run(
        [sys.executable, *arguments], cwd=ROOT, env=inherited | environment, capture_output=True, text=True
    )


@pytest.fixture
def other_swipl(tmp_path: Path) -> str:
    """A PATH on which a `swipl` with a home of its own comes first; a binary, since Prolog sees through scripts."""
    (tmp_path / "bin").mkdir()
    shutil.copy(shutil.which("true") or pytest.skip("needs true"), tmp_path / "bin" / "swipl")
    (tmp_path / "swipl.home").write_text(".\n")
    (tmp_path / "boot.prc").write_text("not a boot file")
    return f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}"


def finding(output: str, name: str) -> str:
    return next(line for line in output.splitlines() if name in line)


def test_all_is_well_here() -> None:
    checks = doctor()
    assert all(check.ok for check in checks), report(checks)
    assert report(checks).endswith("all is well")


def test_the_home_belongs_to_the_library() -> None:
    linked = prolog_home.linked()
    assert linked.version >= prolog_home.OLDEST
    assert linked.home is not None and (linked.home / "library" / "lists.pl").is_file()
    assert "libswipl" in linked.library.name and linked.extension.is_file()


@by_home
def test_another_swipl_on_path_aborts_janus_but_not_after_prepare(other_swipl: str) -> None:
    assert python("-c", PROBE, PATH=other_swipl).returncode < 0
    prepared = python("-c", f"from nppg.bridge.home import prepare; prepare(); {PROBE}", PATH=other_swipl)
    assert prepared.stdout == "42\n", prepared.stderr


def test_the_doctor_survives_another_swipl_on_path(other_swipl: str) -> None:
    result = python("-m", "nppg.bridge.doctor", PATH=other_swipl)
    assert result.returncode == 0, result.stdout
    assert "does not work; nppg does not use it" in finding(result.stdout, "swipl on PATH")


def test_another_swipl_on_path_is_told(tmp_path: Path) -> None:
    swipl = tmp_path / "swipl"
    swipl.write_text("""#!/bin/sh\necho 'PLBASE="/elsewhere";'\necho 'PLVERSION="90004";'\n""")
    swipl.chmod(0o755)
    result = python("-m", "nppg.bridge.doctor", PATH=str(tmp_path))
    assert result.returncode == 0, result.stdout
    assert finding(result.stdout, "swipl on PATH").endswith(f"9.0.4, {swipl}, not the one that nppg uses")


@by_home
def test_a_wrong_home_is_reported_instead_of_an_abort(tmp_path: Path) -> None:
    result = python("-m", "nppg.bridge.doctor", SWI_HOME_DIR=str(tmp_path))
    assert result.returncode == 2
    assert "FAIL" in finding(result.stdout, "home of Prolog")
    assert "stopped by signal" in finding(result.stdout, "6*7 in Prolog")
    assert "-> unset SWI_HOME_DIR" in result.stdout
    assert "2 of 18 checks failed" in result.stdout


def test_the_users_home_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SWI_HOME_DIR", "/the/users")
    prolog_home.prepare()
    assert os.environ["SWI_HOME_DIR"] == "/the/users"


def test_nothing_installed_is_reported_with_the_mends() -> None:
    result = python("-S", "-m", "nppg.bridge.doctor")
    assert result.returncode == 2
    for name in ("numpy", "pyyaml", "janus-swi"):
        assert finding(result.stdout, name).startswith("FAIL")
    assert f"-> run {ROOT / 'setup'}" in result.stdout
    assert "-m pip install pyyaml" in result.stdout
    assert not result.stderr


def test_an_extension_that_cannot_be_loaded_is_reported(tmp_path: Path) -> None:
    suffix = EXTENSION_SUFFIXES[0]
    (tmp_path / "janus_swi").mkdir()
    (tmp_path / "janus_swi" / "__init__.py").touch()
    (tmp_path / "janus_swi" / f"_swipl{suffix}").write_text("no library")
    result = python("-m", "nppg.bridge.doctor", PYTHONPATH=str(tmp_path))
    assert result.returncode == 2
    assert "cannot be loaded" in finding(result.stdout, "janus-swi")


def test_mends_stand_below_what_they_mend() -> None:
    text = report([Check("a", True, "fine"), Check("b", False, "broken", "mend it")])
    first, second, mend, last = text.splitlines()
    assert first.startswith("ok") and second.startswith("FAIL") and mend.strip() == "-> mend it"
    assert last == "1 of 2 checks failed"
