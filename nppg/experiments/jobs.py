"""Runs that are to be done, many at a time, each in a folder of its own; one that is finished is not done again."""

from __future__ import annotations

import csv
import pickle
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, Generic, NamedTuple, TypeVar

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import made, replacing, write_files
from nppg.bridge.interrupts import undisturbed
from nppg.errors import NppgError
from nppg.experiments import checkpoints
from nppg.experiments.cluster import heed_abandoned
from nppg.experiments.many import Pool, each
from nppg.experiments.progress import MEASURES, Judging, Progress, measured
from nppg.experiments.run_files import is_finished, settings, summary_of
from nppg.experiments.runs import make_folder, run
from nppg.judging.space import Space
from nppg.learning.options import Common
from nppg.worlds.domain import Domain
from nppg.worlds.gym_domain import GymDomain


def packed(domain: Domain, bias: LanguageBias) -> bytes:
    """All that it takes to open them in another process, on another machine, too."""
    return pickle.dumps((domain.unmade() if isinstance(domain, GymDomain) else domain, bias))


@lru_cache(4)
def _opened(world: bytes) -> tuple[Domain, LanguageBias]:
    """What the runs of a process share."""
    return pickle.loads(world)


@dataclass(frozen=True)
class Job:
    """A run that is to be done, in the domain and with the language bias that are `packed` in its world."""

    world: bytes = field(repr=False)
    options: Common
    judging: Judging
    folder: Path

    def __str__(self) -> str:
        return self.folder.name

    @property
    def domain(self) -> Domain:
        """To ask about what its file says, not to act in."""
        return _opened(self.world)[0]

    def is_finished(self) -> bool:
        """Whether its files are there and come from the same settings, domain and bias."""
        return is_finished(self.folder, settings(*_opened(self.world), self.options, self.judging))

    def learn(self, folder: Path, heed: Callable[[], None] = lambda: None) -> None:
        """Does it, or goes on with it where this folder has a checkpoint of it, and writes its files there. An
        environment is made for it alone. `heed` is called again and again, and may raise what is to end the run."""
        domain, bias = _opened(self.world)
        if domain.environment:
            domain, bias = pickle.loads(self.world)
        report, space = self.observer(domain, folder)

        def heeding(progress: Progress) -> None:
            heed()
            report(progress)

        known = settings(domain, bias, self.options, self.judging)
        run(
            domain,
            bias,
            self.options,
            folder,
            **self.judging,
            report=heeding,
            space=space,
            resume=checkpoints.are_of(folder, known),
        )

    def observer(self, domain: Domain, folder: Path) -> tuple[Callable[[Progress], None], Space | None]:
        """What the run reports to, and the domain's space, where that has it."""
        return lambda progress: None, None

    def result(self) -> str:
        """What the finished run has come to, in one line."""
        summary = self.summary()
        last, sizes = summary["last"], ("trees", "leaves", "instances")
        told = [f"{summary[name]} {name}" for name in sizes if summary.get(name)] or ["nothing learned"]
        if last:
            name = measured(self.domain, self.judging)
            told.insert(0, f"{name} {last[MEASURES[name][0]]:.4f}")
        return ", ".join(told)

    def summary(self) -> dict[str, Any]:
        """What run.json says of the finished run."""
        return summary_of(self.folder)

    def curve(self) -> list[dict[str, str]]:
        """The points of the finished run's curve.csv."""
        with (self.folder / "curve.csv").open(newline="") as file:
            return list(csv.DictReader(file))

    def due(self, episode: float) -> int:
        """The episode that a point of the curve was due after: policy gradients are judged with the next tree behind
        it. The last point is there for itself."""
        every, number = self.judging["evaluate_every"], int(episode)
        return number if number == self.options.episodes else number // every * every


RunJob = TypeVar("RunJob", bound=Job)


def do(wanted: Sequence[RunJob], pool: Pool) -> Iterator[tuple[RunJob, float]]:
    """Does the runs that are not finished yet. Yields each finished one, with the seconds that it took, 0 where it was
    there already. Raises NppgError."""
    finished = [job.is_finished() for job in wanted]
    yield from ((job, 0.0) for job, is_there in zip(wanted, finished, strict=True) if is_there)
    missing = [job for job, is_there in zip(wanted, finished, strict=True) if not is_there]
    if pool.shares_files:
        yield from each(_learned, missing, pool)
        return
    for job in missing:
        make_folder(job.folder)
    all_sent = [_Sent(job, _contents(job.folder)) for job in missing]
    for sent, (files, seconds) in each(_learned_elsewhere, all_sent, pool):
        _put(files, sent)
        yield sent.job, seconds


def _learned(job: Job) -> float:
    """Does a run: the seconds."""
    begin = time.perf_counter()
    job.learn(job.folder)
    return time.perf_counter() - begin


class _Sent(NamedTuple, Generic[RunJob]):
    """A run for another machine, which has the files of its folder, contents by name, in a folder of its own."""

    job: RunJob
    files: Mapping[str, bytes]

    def __str__(self) -> str:
        return str(self.job)


def _learned_elsewhere(sent: _Sent) -> tuple[dict[str, bytes], float]:
    """Does a run: what is in its folder then, and the seconds."""
    with tempfile.TemporaryDirectory() as parent:
        folder = Path(parent, sent.job.folder.name)
        folder.mkdir()
        write_files(folder, sent.files)
        begin = time.perf_counter()
        try:
            sent.job.learn(folder, heed_abandoned)
        except NppgError as error:
            raise NppgError(str(error).replace(str(folder), str(sent.job.folder))) from None
        return _contents(folder), time.perf_counter() - begin


def _contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@undisturbed()
def _put(files: Mapping[str, bytes], sent: _Sent) -> None:
    """Makes the folder here what it is there."""
    for name, data in files.items():
        if sent.files.get(name) != data:
            made((sent.job.folder / name).parent)
            replacing(sent.job.folder / name, partial(Path.write_bytes, data=data))
    for name in set(sent.files) - set(files):
        (sent.job.folder / name).unlink(missing_ok=True)
