"""What `make wheels` has written, installed by pip into an environment that has nothing else, with nothing on PATH."""

import subprocess
import sys
import venv
from importlib.metadata import files
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
DIST = ROOT / "dist"
TAG = f"cp{sys.version_info.major}{sys.version_info.minor}"
WHEELS = [*DIST.glob(f"janus_swi-*+bundled-{TAG}-*.whl"), *DIST.glob("nppg-*.whl")]

pytestmark = pytest.mark.skipif(len(WHEELS) < 2, reason=f"make wheels has written none for {TAG}")


class Empty:
    """An environment in a folder whose name has a space. NumPy and PyYAML, which come from elsewhere, are borrowed."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        venv.create(folder / "an environment", with_pip=False, symlinks=True)
        self.python = folder / "an environment" / "bin" / "python"
        site = next((folder / "an environment").glob("lib/python*/site-packages"))
        for distribution in ("numpy", "pyyaml"):
            for name in {file.parts[0] for file in files(distribution) or ()} - {"..", "__pycache__"}:
                (site / name).symlink_to(next(Path(path, name) for path in sys.path if Path(path, name).exists()))

    def run(self, *arguments: object, **environment: str) -> subprocess.CompletedProcess[str]:
        words = [str(self.python), *map(str, arguments)]
        return subprocess.run(
            words, cwd=self.folder, env={"PATH": "", **environment}, capture_output=True, text=True, timeout=300
        )

    def nppg(self, *arguments: str, **environment: str) -> str:
        done = self.run("-m", "nppg", *arguments, **environment)
        assert done.returncode == 0 and not done.stderr, done.stdout + done.stderr
        return done.stdout


@pytest.fixture(scope="module")
def empty(tmp_path_factory: pytest.TempPathFactory) -> Empty:
    empty = Empty(tmp_path_factory.mktemp("wheels"))
    pip = [sys.executable, "-m", "pip", "--python", str(empty.python), "install", "--no-compile", "--no-index"]
    options = {"env": {"PATH": "", "PIP_CONFIG_FILE": "/dev/null"}, "capture_output": True, "text": True}
    done = subprocess.run([*pip, "--find-links", str(DIST), "nppg[bundled]"], **options)  # type: ignore[call-overload]
    assert done.returncode == 0, done.stdout + done.stderr
    return empty


def test_train_distill_prove(empty: Empty) -> None:
    trained = empty.nppg("train", "blocks_world", "--set", "blocks=4", "--step", "second-order", "--episodes", "100")
    assert "written to runs/blocks_world/" in trained
    assert "over all" in empty.nppg("distill", "runs/blocks_world/model.pl")
    assert "60 of them start states" in empty.nppg("prove", "runs/blocks_world/rules.pl")


def test_the_doctor_knows_it_and_a_home_of_another_prolog_does_no_harm(empty: Empty) -> None:
    for environment in ({}, {"SWI_HOME_DIR": "/usr/lib/swi-prolog"}):
        assert "inside janus-swi's wheel" in empty.nppg("doctor", **environment)
    assert empty.run("-c", "import janus_swi; print(janus_swi.query_once('X is 6*7')['X'])").stdout == "42\n"


def test_its_libraries_load_as_they_are_called(empty: Empty) -> None:
    goals = {
        "aggregate_all(count, member(_, [a, b]), X)": 2,
        "use_module(library(clpfd)), clpfd:'#='(X, 3)": 3,
        "use_module(library(process)), process_id(_), X = 1": 1,
    }
    code = f"import janus_swi; print([janus_swi.query_once(goal)['X'] for goal in {list(goals)!r}])"
    done = empty.run("-c", code)
    assert done.stdout == f"{list(goals.values())}\n" and not done.stderr, done.stderr


def test_licences_are_included(empty: Empty) -> None:
    folder = next((empty.folder / "an environment").glob("lib/python*/site-packages/janus_swi-*.dist-info/licenses"))
    names = {file.stem for file in folder.iterdir()}
    beside = {file.name.split("-")[0] for file in folder.parent.parent.glob("janus_swi.libs/*")}
    assert names >= {"LICENSE", "SWI-Prolog"} | beside and all(file.stat().st_size for file in folder.iterdir())
