"""Looks whether everything that nppg needs is there, and names the mend for what is not.

Nothing here imports janus_swi or starts Prolog in this process, where a wrong home would end it: the probe query
runs in a process of its own.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from nppg.bridge import home as prolog_home
from nppg.bridge.files import shipped

_PACKAGE = Path(__file__).parent.parent
_PROBE = "import janus_swi; print(janus_swi.query_once('X is 6*7')['X'])"


@dataclass(frozen=True)
class Check:
    """One finding. `mend` says in one line what to do, if not ok, or what could be had besides, if ok."""

    name: str
    ok: bool
    detail: str
    mend: str = ""


def doctor() -> list[Check]:
    """All checks, each made whatever the others found; raises nothing."""
    return list(_checks())


def versions() -> str:
    """nppg's version, and those of what it runs on, a line each; Prolog is not started."""
    try:
        linked = prolog_home.linked()
        prolog = f"{_dotted(linked.version)}{', inside janus-swi' if linked.bundled else ''}"
    except (ImportError, OSError):
        prolog = "cannot be loaded: see nppg doctor"
    python = sys.version.split()[0]
    return f"nppg {_version('nppg')}\njanus-swi {_version('janus-swi')}\nSWI-Prolog {prolog}\nPython {python}"


def report(checks: list[Check]) -> str:
    """The checks as lines of text, the mends below what they mend, a summary last."""
    lines = []
    for check in checks:
        lines.append(f"{'ok  ' if check.ok else 'FAIL'}  {check.name:<15}  {check.detail}")
        if check.mend:
            lines.append(f"{'':23}-> {check.mend}")
    failed = sum(not check.ok for check in checks)
    lines.append(f"{failed} of {len(checks)} checks failed" if failed else "all is well")
    return "\n".join(lines)


def _checks() -> Iterator[Check]:
    yield _python()
    yield _module("numpy", "numpy")
    yield _module("yaml", "pyyaml")
    try:
        linked = prolog_home.linked()
    except ModuleNotFoundError as error:
        yield Check("janus-swi", False, str(error), _rebuild())
        yield _swipl_on_path(None)
    except OSError as error:
        yield Check("janus-swi", False, f"cannot be loaded: {error}", _rebuild())
        yield _swipl_on_path(None)
    else:
        yield _janus(linked)
        yield _libswipl(linked)
        yield _home(linked)
        yield _swipl_on_path(linked)
        yield _probe(linked)
    yield from map(_shipped, ("prolog", "domains", "language_bias"))
    yield _extra("matplotlib", "plot", "learning curves as pictures")
    yield _extra("scipy", "rrl", "the distance of RIB and TRENDI")
    yield _extra("scikit-learn", "cart", "CART as a regression learner")
    yield _extra("gymnasium", "gym", "its environments as domains")
    yield _extra("unified-planning", "pddl", "policies as a planner of it")
    yield _extra("distributed", "cluster", "runs on the workers of a cluster")
    yield _extra("tqdm", "progress", "progress bars")


def _python() -> Check:
    ok = sys.version_info >= (3, 10)
    mend = "" if ok else "run ./setup with PYTHON=/path/to/python, 3.10 or newer"
    return Check("Python", ok, f"{sys.version.split()[0]}, {sys.executable}", mend)


def _module(name: str, distribution: str) -> Check:
    try:
        module = import_module(name)
    except Exception as error:  # a damaged installation can raise anything
        return Check(distribution, False, " ".join(str(error).split()), _install(distribution))
    return Check(distribution, True, f"{_version(distribution)}, {module.__file__}")


def _janus(linked: prolog_home.Linked) -> Check:
    return Check("janus-swi", True, f"{_version('janus-swi')}, {linked.extension}")


def _libswipl(linked: prolog_home.Linked) -> Check:
    ok = linked.version >= prolog_home.OLDEST
    detail = f"{_dotted(linked.version)}, {linked.library}"
    if ok:
        return Check("libswipl", True, detail)
    return Check("libswipl", False, f"{detail}: older than {_dotted(prolog_home.OLDEST)}", _rebuild())


def _home(linked: prolog_home.Linked) -> Check:
    name = "home of Prolog"
    if linked.bundled:
        found = linked.home is not None
        return Check(name, found, f"{linked.home}, inside janus-swi's wheel", "" if found else _rebuild())
    if chosen := os.environ.get("SWI_HOME_DIR"):
        same = linked.home is not None and os.path.realpath(chosen) == os.path.realpath(linked.home)
        if same or (linked.home is None and Path(chosen, "boot.prc").is_file()):
            return Check(name, True, f"{chosen}, from SWI_HOME_DIR")
        wrong = f"SWI_HOME_DIR is {chosen}, but janus-swi is linked to the SWI-Prolog of {linked.home}"
        return Check(name, False, wrong, "unset SWI_HOME_DIR")
    if linked.home is None:
        return Check(name, False, f"no boot.prc near {linked.library}", "set SWI_HOME_DIR to the folder with boot.prc")
    return Check(name, True, str(linked.home))


def _swipl_on_path(linked: prolog_home.Linked | None) -> Check:
    name = "swipl on PATH"
    swipl = shutil.which("swipl")
    if swipl is None:
        return Check(name, True, "none, and none is needed")
    environment = {name: value for name, value in os.environ.items() if name != "SWI_HOME_DIR"}
    printed = _run([swipl, "--dump-runtime-variables"], environment).stdout
    variables = dict(re.findall(r'^(\w+)="(.*)"', printed, re.MULTILINE))
    number = variables.get("PLVERSION", "")
    if not number.isdecimal():
        return Check(name, True, f"{swipl} does not work; nppg does not use it")
    detail = f"{_dotted(prolog_home.version(int(number)))}, {swipl}"
    if linked and linked.home and os.path.realpath(variables.get("PLBASE", "")) == os.path.realpath(linked.home):
        return Check(name, True, f"{detail}, the one that nppg uses")
    return Check(name, True, f"{detail}, not the one that nppg uses")


def _probe(linked: prolog_home.Linked) -> Check:
    name = "6*7 in Prolog"
    chosen = os.environ.get("SWI_HOME_DIR")
    home = {"SWI_HOME_DIR": str(linked.home)} if linked.home and not chosen else {}
    result = _run([sys.executable, "-c", _PROBE], os.environ | home)
    answer = " ".join(result.stdout.split())
    if result.returncode == 0 and answer == "42":
        return Check(name, True, answer)
    how = f"stopped by signal {-result.returncode}" if result.returncode < 0 else f"exit status {result.returncode}"
    said = " ".join(result.stderr.split()[-30:]) or answer
    return Check(name, False, f"{how}: {said}", "unset SWI_HOME_DIR" if chosen else _rebuild())


def _shipped(folder: str) -> Check:
    path = shipped(folder)
    if path.is_dir() and any(path.iterdir()):
        return Check(f"{folder}/", True, str(path))
    return Check(f"{folder}/", False, f"{path} is missing or empty", "install nppg anew")


def _extra(name: str, extra: str, purpose: str) -> Check:
    try:
        return Check(name, True, version(name))
    except PackageNotFoundError:
        return Check(name, True, f"not installed; it gives {purpose}", _install(f"nppg[{extra}]"))


def _run(command: list[str], environment: Mapping[str, str]) -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(
            command,
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=30,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return subprocess.CompletedProcess(command, 1, "", str(error))


def _rebuild() -> str:
    if (_PACKAGE.parent / "setup").is_file():
        return f"run {_PACKAGE.parent / 'setup'}, and use the Python in .venv beside it"
    pip = "pip install --force-reinstall --no-cache-dir --no-binary janus-swi janus-swi"
    return f"SWIPL=/path/to/swipl {pip}, with SWI-Prolog {_dotted(prolog_home.OLDEST)} or newer"


def _install(requirement: str) -> str:
    return f"{sys.executable} -m pip install {shlex.quote(requirement)}"


def _version(distribution: str) -> str:
    try:
        return version(distribution)
    except PackageNotFoundError:
        return "of unknown version"


def _dotted(number: tuple[int, ...]) -> str:
    return ".".join(map(str, number))


def main() -> int:
    """Prints the report; the exit status is 0 if all is well, else 2."""
    checks = doctor()
    print(report(checks))
    return 0 if all(check.ok for check in checks) else 2


if __name__ == "__main__":
    sys.exit(main())
