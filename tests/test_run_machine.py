"""Whatever happens to a run's folder, in whatever order: the run comes to the same end, or one line tells why not."""

from __future__ import annotations

import errno
import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule, run_state_machine_as_test
from test_checkpoints import files
from test_seals import damaged

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import shipped
from nppg.errors import NppgError
from nppg.experiments import checkpoints, run_files
from nppg.experiments.checkpoints import Checkpoints
from nppg.experiments.resuming import begun
from nppg.experiments.runs import run
from nppg.learning.options import Common, Options
from nppg.policy.copies import BEFORE, CHECKPOINT
from nppg.policy.policy import Policy
from nppg.rrl.options import RIBOptions, TGOptions
from nppg.worlds.domain import Domain

SOAK = "NPPG_SOAK" in os.environ
OPTIONS: dict[str, Common] = {
    "first": Options(seed=1, min_examples=10),
    "second": Options(seed=2, step="second-order", min_examples=10, replay=10, guidance=0.3),
    "tg": TGOptions(seed=3, min_sample=20, significance=0.2),
    "rib": RIBOptions(seed=4, max_instances=8),
}


@pytest.fixture(autouse=True)
def no_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run_files, "_draw", lambda *_: False)


@lru_cache
def world() -> tuple[Domain, LanguageBias]:
    return Domain("blocks_world", {"blocks": 3}), LanguageBias.load(shipped("language_bias") / "blocks_world.yaml")


def options(way: str, episodes: int) -> Common:
    return replace(OPTIONS[way], episodes=episodes)


@lru_cache(None)
def whole(way: str, episodes: int) -> dict[str, Any]:
    """The files of the run that nothing happened to."""
    with tempfile.TemporaryDirectory() as folder:
        run(*world(), options(way, episodes), Path(folder), 4)
        return files(Path(folder))


class Stopped(BaseException):
    """As if the process were gone: nobody knows what to do about it."""


@contextmanager
def patched(*changes: tuple[object, str, object]) -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patching:
        for owner, name, value in changes:
            patching.setattr(owner, name, value)
        yield


class Run(RuleBasedStateMachine):
    """A run's folder, and what happens to it."""

    def __init__(self) -> None:
        super().__init__()
        self.folder = Path(tempfile.mkdtemp())
        self.episodes = 0  # that the run was last begun or gone on with
        self.damaged: dict[str, tuple[bytes, bytes]] = {}  # files as they were, and as they are

    def teardown(self) -> None:
        shutil.rmtree(self.folder)

    @initialize(way=st.sampled_from(sorted(OPTIONS)), dense=st.booleans())
    def begin(self, way: str, dense: bool) -> None:
        self.way, self.dense = way, dense

    def work(self, episodes: int, resume: bool, *changes: tuple[object, str, object]) -> BaseException | None:
        """Trains, or goes on, and what ended it before its end."""
        dense = [(Checkpoints, "are_due", property(lambda _: True))] if self.dense else []
        self.episodes = episodes
        try:
            with patched(*dense, *changes):
                run(*world(), options(self.way, episodes), self.folder, 4, resume=resume)
        except (NppgError, KeyboardInterrupt, Stopped) as error:
            found: BaseException | None = error
        else:
            found = None
            assert files(self.folder) == whole(self.way, episodes)
        return found

    @rule(episodes=st.integers(1, 12))
    def train(self, episodes: int) -> None:
        """Anew, whatever is there."""
        assert self.work(episodes, False) is None

    @rule(more=st.integers(0, 5))
    def resume(self, more: int) -> None:
        error = self.work(max(self.episodes, 1) + more, True)
        if error is not None:
            assert isinstance(error, NppgError) and "\n" not in str(error)
            assert not any(map(self.is_whole, (CHECKPOINT, BEFORE)))

    @rule(more=st.integers(0, 5), at=st.integers(1, 6), resume=st.booleans(), kind=st.sampled_from("ck"))
    def stop(self, more: int, at: int, resume: bool, kind: str) -> None:
        """In an episode, by Ctrl-C or by force."""
        left = iter(range(at))

        def start(domain: Domain, rng: Any) -> Any:
            found = draw(domain, rng)
            if next(left, None) is None:
                raise KeyboardInterrupt if kind == "c" else Stopped
            return found

        draw = Domain.start
        self.work(max(self.episodes, 1) + more, resume, (Domain, "start", start))

    @rule(at=st.integers(1, 30), where=st.sampled_from(["replace", "fsync", "link"]), resume=st.booleans())
    def fail(self, at: int, where: str, resume: bool) -> None:
        """The disk, at some call."""
        left, call = iter(range(at)), getattr(os, where)

        def failing(*args: Any) -> Any:
            if next(left, None) is None:
                raise OSError(errno.EIO, os.strerror(errno.EIO))
            return call(*args)

        before = {name: self.is_whole(name) for name in (CHECKPOINT, BEFORE)}
        error = self.work(max(self.episodes, 1), resume, (os, where, failing))
        assert error is None or "\n" not in str(error)
        if any(before.values()):
            assert any(map(self.is_whole, before))

    @rule(name=st.sampled_from(["model.pl", CHECKPOINT, BEFORE, "run.json"]), seed=st.integers(0, 1000))
    def damage(self, name: str, seed: int) -> None:
        path = self.folder / name
        if path.exists() and path.stat().st_size:
            data = path.read_bytes()
            good = data if self.is_whole(name) else self.damaged[name][0]
            path.write_bytes(damaged(data, random.Random(seed)))
            self.damaged[name] = (good, path.read_bytes())

    @rule()
    def load_and_save(self) -> None:
        path = self.folder / "model.pl"
        if self.is_whole("model.pl"):
            policy = Policy.load(path)
            with tempfile.TemporaryDirectory() as other:
                policy.save(Path(other, "model.pl"))
                assert Policy.load(Path(other, "model.pl")).trees == policy.trees

    @rule(trusts=st.booleans())
    def open_again(self, trusts: bool) -> None:
        """What the run was begun with, from its folder alone."""
        try:
            found = begun(self.folder, trust=trusts)
        except NppgError as error:
            assert "\n" not in str(error)
        else:
            assert found.domain.trusted is trusts
            assert found.options == options(self.way, found.options.episodes)

    def is_whole(self, name: str) -> bool:
        """Whether a file is there as it was written."""
        path = self.folder / name
        good, bad = self.damaged.get(name, (b"", b""))
        return path.is_file() and (good == bad or path.read_bytes() != bad)

    @invariant()
    def what_was_damaged_is_refused(self) -> None:
        readers: dict[str, Callable[[Path], object]] = {
            "model.pl": Policy.load,
            CHECKPOINT: checkpoints.read,
            BEFORE: checkpoints.read,
            "run.json": lambda path: run_files.summary_of(path.parent),
        }
        for name, read in readers.items():
            if (self.folder / name).exists():
                try:
                    read(self.folder / name)
                    is_read = True
                except NppgError as error:
                    is_read = False
                    assert "\n" not in str(error)
                assert is_read == self.is_whole(name), name


@pytest.mark.filterwarnings("ignore:.*the run goes on from the one before")
def test_a_run_comes_to_its_end_whatever_happens() -> None:
    run_state_machine_as_test(
        Run, settings=settings(max_examples=80 if SOAK else 5, stateful_step_count=15 if SOAK else 8, deadline=None)
    )


SETTINGS = [  # of the process: the seed of its hashes, its locale, the processes beside it
    {"PYTHONHASHSEED": "1", "LC_ALL": "C"},
    {"PYTHONHASHSEED": "2", "LC_ALL": "C.UTF-8", "--jobs": "2"},
    {"PYTHONHASHSEED": "3", "LC_ALL": "POSIX", "PYTHONUTF8": "0", "LANG": "de_DE.ISO-8859-1"},
    {"PYTHONHASHSEED": "4", "LC_ALL": "tr_TR.UTF-8", "LANGUAGE": "tr", "TZ": "Asia/Kathmandu", "--jobs": "3"},
]


@pytest.mark.parametrize("way", [["--step", "second-order", "--guidance", "0.3"], *([["--learner", "tg"]] * SOAK)])
def test_a_seed_is_the_same_run_everywhere(way: list[str], tmp_path: Path) -> None:
    found = []
    for number, setting in enumerate(SETTINGS if SOAK else SETTINGS[1::2]):
        folder = tmp_path / str(number)
        environment = {name: value for name, value in setting.items() if name.isupper()}
        command = [sys.executable, "-m", "nppg", "train", "blocks_world", "--set", "blocks=4", "--seed", "5", "--quiet"]
        command += ["--episodes", "300" if SOAK else "60", "--evaluate-every", "20", "--starts", "20", *way]
        jobs = ["--jobs", setting.get("--jobs", "1")]
        subprocess.run([*command, *jobs, "--output", str(folder)], check=True, env={**os.environ, **environment})
        found.append(files(folder))
    assert all(each == found[0] for each in found) and b"delta(1, " in found[0]["model"]
