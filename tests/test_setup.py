"""./setup, run in folders of its own on machines of stubs: no network, no compiler, no package manager, no root."""

import platform
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
TOOLS = "basename cat cksum cp cut dirname env flock grep head mkdir mv rm sed sh tail tar tr uname"
SWIPL = """
case "$*" in *runtime*) ;; *) exit 0 ;; esac
cat <<END
PLBASE="{base}";
PLVERSION="{version}";
PLLIBDIR="{base}";
PLTHREADS="yes";
END
"""
PYTHON = """
case "$*" in
*version_info*) echo "3.11.2 {base}" ;;
*get_path*) echo "{base}/include" ;;
*_base_executable*) echo python3 ;;
"-m venv .venv") mkdir -p .venv/bin && cp "$0" .venv/bin/python ;;
*"pip install"*)
    echo "$*" >>"{base}/pip"
    [ ! -e "{base}/offline" ] || {{ echo Temporary failure in name resolution; exit 1; }} ;;
*doctor*) [ ! -e "{base}/ill" ] || {{ echo "FAIL something"; exit 2; }} ;;
esac
"""


@dataclass(frozen=True)
class Machine:
    """A folder with the script, and the only commands that it finds."""

    base: Path

    @property
    def project(self) -> Path:
        return self.base / "project"

    def command(self, name: str, text: str = "exit 0") -> None:
        file = self.base / "bin" / name
        file.unlink(missing_ok=True)
        file.write_text(f"#!/bin/sh\n{text}\n")
        file.chmod(0o755)

    def swipl(self, version: int) -> None:
        self.command("swipl", SWIPL.format(base=self.base, version=version))

    def setup(self, **environment: str) -> subprocess.CompletedProcess[str]:
        variables = {"PATH": str(self.base / "bin"), "HOME": str(self.base)} | environment
        return subprocess.run(["./setup"], cwd=self.project, env=variables, capture_output=True, text=True, timeout=120)

    def refusal(self, **environment: str) -> str:
        """The one line on which the script stops."""
        result = self.setup(**environment)
        assert result.returncode == 2, result.stdout + result.stderr
        assert result.stderr.startswith("setup: ") and result.stderr.count("\n") == 1, result.stderr
        assert not (self.project / ".venv" / "setup.stamp").exists()
        return result.stderr

    def bundled_version(self) -> str:
        """The version of the wheels with Prolog inside, as pyproject.toml has it."""
        found = re.search(r'^bundled = \["janus-swi==(.*)"\]$', (ROOT / "pyproject.toml").read_text(), re.MULTILINE)
        assert found
        return found[1]

    def installed(self) -> list[str]:
        """What pip was asked for since the last call."""
        log = self.base / "pip"
        lines = log.read_text().splitlines() if log.exists() else []
        log.unlink(missing_ok=True)
        return ["janus-swi" if line.endswith(" janus-swi") else line.split()[-1] for line in lines]


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    """Python, its headers, a compiler and SWI-Prolog 9.2.9; an ordinary user; no package manager."""
    machine = Machine(tmp_path)
    (tmp_path / "bin").mkdir()
    for tool in TOOLS.split():
        if found := shutil.which(tool):
            (tmp_path / "bin" / tool).symlink_to(found)
    machine.command("cc")
    machine.command("id", "echo 1000")
    machine.command("python3", PYTHON.format(base=tmp_path))
    machine.swipl(90209)
    for name in ("SWI-Prolog.h", "Python.h"):
        (tmp_path / "include").mkdir(exist_ok=True)
        (tmp_path / "include" / name).touch()
    (tmp_path / "libswipl.so").touch()
    machine.project.mkdir()
    for name in ("setup", "pyproject.toml"):
        shutil.copy(ROOT / name, machine.project)
    return machine


def debian(machine: Machine, candidate: str) -> None:
    """Makes it a Debian whose SWI-Prolog is of that version, with none installed."""
    (machine.base / "bin" / "swipl").unlink()
    machine.command("apt-get", "exit 1")
    machine.command("apt-cache", f"echo '  Candidate: {candidate}'")
    (machine.base / "bin" / "dpkg").symlink_to(shutil.which("dpkg") or pytest.skip("needs dpkg"))


def test_the_script_is_plain_sh() -> None:
    for shell in ("sh", "bash"):
        assert subprocess.run([shell, "-n", ROOT / "setup"]).returncode == 0


def test_the_second_run_has_nothing_to_do(machine: Machine) -> None:
    first = machine.setup()
    assert first.returncode == 0, first.stderr
    assert first.stdout.endswith("setup: ready: .venv/bin/nppg\n")
    assert machine.installed() == ["janus-swi", ".[all]"]
    second = machine.setup()
    assert second.stdout == f"setup: nothing to do (Python 3.11.2, {machine.base}/bin/swipl)\n"
    assert second.returncode == 0 and machine.installed() == []


def test_only_what_has_changed_is_done_again(machine: Machine) -> None:
    machine.setup()
    machine.installed()
    with (machine.project / "pyproject.toml").open("a") as file:
        file.write("# changed\n")
    assert machine.setup().returncode == 0
    assert machine.installed() == [".[all]"]
    machine.swipl(90300)
    assert machine.setup().returncode == 0
    assert machine.installed() == ["janus-swi", ".[all]"]


def test_the_extras_once_named_are_remembered(machine: Machine) -> None:
    assert machine.setup(EXTRAS="").returncode == 0
    assert machine.installed() == ["janus-swi", "."]
    assert "nothing to do" in machine.setup().stdout
    assert machine.setup(EXTRAS="all").returncode == 0
    assert machine.installed() == [".[all]"]


def test_the_swipl_once_named_is_remembered(machine: Machine) -> None:
    named = machine.base / "named"
    shutil.move(machine.base / "bin" / "swipl", named)
    assert machine.setup(SWIPL=str(named)).returncode == 0
    assert f"nothing to do (Python 3.11.2, {named})" in machine.setup().stdout


def test_a_wheel_with_prolog_inside_needs_neither_swipl_nor_compiler(machine: Machine) -> None:
    version = machine.bundled_version()
    folder = machine.base / "wheels"
    folder.mkdir()
    for name in ("swipl", "cc"):
        (machine.base / "bin" / name).unlink()
    for name in ("1.0", f"{version}-cp310"):
        (folder / f"janus_swi-{name}-cp310-manylinux_2_34_{platform.machine()}.whl").touch()
    assert "SWI-Prolog 9.1.12 or newer is missing" in machine.refusal(PIP_FIND_LINKS=str(folder))
    wheel = folder / f"janus_swi-{version}-cp311-cp311-manylinux_2_34_{platform.machine()}.whl"
    wheel.touch()
    assert machine.setup(PIP_FIND_LINKS=f"/nowhere {folder}").returncode == 0
    assert machine.installed() == [str(wheel), ".[all]"]
    assert f"nothing to do (Python 3.11.2, {wheel})" in machine.setup().stdout
    wheel.write_text("another one")
    assert machine.setup().returncode == 0
    assert machine.installed() == [str(wheel), ".[all]"]


def test_a_wheel_does_not_take_the_place_of_the_swipl_in_use(machine: Machine) -> None:
    machine.setup()
    (machine.project / "dist").mkdir()
    name = f"janus_swi-{machine.bundled_version()}-cp311-cp311-manylinux_2_34_{platform.machine()}.whl"
    (machine.project / "dist" / name).touch()
    assert f"nothing to do (Python 3.11.2, {machine.base}/bin/swipl)" in machine.setup().stdout


def test_no_network_is_one_line_and_leaves_nothing_to_trust(machine: Machine) -> None:
    (machine.base / "offline").touch()
    assert "no network" in machine.refusal()
    (machine.base / "offline").unlink()
    machine.installed()
    assert machine.setup().returncode == 0
    assert machine.installed() == ["janus-swi", ".[all]"]


def test_a_failed_check_shows_the_end_of_the_log(machine: Machine) -> None:
    (machine.base / "ill").touch()
    result = machine.setup()
    assert result.returncode == 2
    assert "FAIL something" in result.stderr
    assert result.stderr.endswith("everything it said is in .venv/setup.log\n")
    assert not (machine.project / ".venv" / "setup.stamp").exists()


def test_swipl_that_is_too_old_or_missing(machine: Machine) -> None:
    assert "nowhere is missing" in machine.refusal(SWIPL="/nowhere")
    machine.swipl(90004)
    assert "is 9.0.4, older than 9.1.12" in machine.refusal(SWIPL="swipl")
    assert "install it with its headers, or set SWIPL=" in machine.refusal()
    machine.swipl(90209)
    (machine.base / "include" / "SWI-Prolog.h").unlink()
    assert "has no header files" in machine.refusal(SWIPL="swipl")


def test_python_that_is_too_old_or_missing(machine: Machine) -> None:
    assert "PYTHON=python2 is not a Python 3.10 or newer" in machine.refusal(PYTHON="python2")
    (machine.base / "bin" / "python3").unlink()
    assert "Python 3.10 or newer is missing" in machine.refusal()


def test_no_compiler_on_an_unknown_system(machine: Machine) -> None:
    (machine.base / "bin" / "cc").unlink()
    assert machine.refusal() == "setup: missing: install gcc by hand, then run ./setup again\n"


def test_no_python_headers(machine: Machine) -> None:
    (machine.base / "include" / "Python.h").unlink()
    assert "Python.h is missing" in machine.refusal()


def test_no_root_on_debian_names_the_packages(machine: Machine) -> None:
    debian(machine, "9.2.9+dfsg-1")
    assert machine.refusal() == "setup: missing, and only root may install them: apt-get install swi-prolog-nox\n"
    assert not (machine.project / ".venv").exists()


def test_no_root_on_an_older_debian_names_what_the_build_needs(machine: Machine) -> None:
    debian(machine, "9.0.4+dfsg-2")
    machine.command("cc", "while read -r line; do case $line in *gmp.h* | *zlib.h*) exit 1 ;; esac; done")
    assert machine.refusal().endswith("apt-get install cmake ninja-build libgmp-dev zlib1g-dev\n")
