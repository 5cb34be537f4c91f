"""Points that are drawn in other processes are those of a run without."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path

import pytest

from nppg import Domain, LanguageBias, Options, language_bias_of, open_domain
from nppg.experiments import points
from nppg.experiments.progress import Point, Progress
from nppg.experiments.runs import run
from nppg.learning.training import train
from nppg.policy import beside
from nppg.policy.beside import Beside, Gone, Servant
from nppg.policy.policy import Policy

ROOT = Path(__file__).parent.parent
OPTIONS = Options(episodes=60, min_examples=20)


class Ready(Beside):
    """One that is waited for when it is started, so that it is asked even in a short run."""

    asked = 0
    after = 1_000_000  # questions after which it is killed

    def __init__(self, servant: Servant):
        super().__init__(servant)
        while not self.free:
            time.sleep(0.01)

    def ask(self, *args: object) -> None:
        super().ask(*args)
        Ready.asked += 1
        if Ready.asked == Ready.after:
            self._process.kill()


@pytest.fixture(autouse=True)
def eager(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(beside, "_PATIENCE", -1.0)
    monkeypatch.setattr(points, "_LAST", 60.0)
    monkeypatch.setattr(beside, "Beside", Ready)
    monkeypatch.setattr(Ready, "asked", 0)


def curve(progress: Progress) -> list[Point]:
    return [replace(point, seconds=0.0) for point in progress.curve]


def learned(domain: Domain, bias: LanguageBias, folder: Path, jobs: int) -> tuple[list[Point], bytes]:
    told: list[Point] = []

    def report(progress: Progress) -> None:
        if progress.point:
            told.append(progress.point)

    progress = run(domain, bias, OPTIONS, folder, 10, 6, report, jobs=jobs)
    assert told == progress.curve
    return curve(progress), (folder / "model.pl").read_bytes()


def test_a_run_is_the_same_in_any_number_of_processes(
    delivery: Domain, delivery_bias: LanguageBias, tmp_path: Path
) -> None:
    expected = learned(delivery, delivery_bias, tmp_path / "1", 1)
    for jobs in (2, 3):
        Ready.asked = 0
        assert learned(delivery, delivery_bias, tmp_path / str(jobs), jobs) == expected
        assert Ready.asked


def test_one_process_more_or_less(
    delivery: Domain, delivery_bias: LanguageBias, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected = learned(delivery, delivery_bias, tmp_path / "1", 1)
    monkeypatch.setattr(Ready, "after", 1)
    assert learned(delivery, delivery_bias, tmp_path / "2", 2) == expected
    assert Ready.asked == 1


def test_what_cannot_be_sent_is_evaluated_here(
    delivery: Domain, delivery_bias: LanguageBias, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected = learned(delivery, delivery_bias, tmp_path / "1", 1)
    monkeypatch.setattr(Domain, "__getstate__", lambda self: {"lambda": lambda: None}, raising=False)
    assert learned(delivery, delivery_bias, tmp_path / "2", 2) == expected
    assert not Ready.asked


def test_an_interrupt_loses_no_point_of_those_that_come_together(
    delivery: Domain, delivery_bias: LanguageBias, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected, _ = learned(delivery, delivery_bias, tmp_path / "1", 1)
    monkeypatch.setattr(Ready, "answers_by", lambda self, moment: moment > 0 and Beside.answers_by(self, moment))
    seen: list[Progress] = []

    def interrupt(progress: Progress) -> None:
        seen.append(progress)
        if progress.point and progress.point.episode:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(delivery, delivery_bias, OPTIONS, tmp_path / "2", 10, 6, interrupt, jobs=2)
    assert curve(seen[-1]) == expected


def test_a_process_that_cannot_be_started_is_done_without(
    delivery: Domain, delivery_bias: LanguageBias, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected = learned(delivery, delivery_bias, tmp_path / "1", 1)

    def full(*_: object, **__: object) -> None:
        raise BlockingIOError("no more processes")

    monkeypatch.setattr(beside, "Popen", full)
    assert learned(delivery, delivery_bias, tmp_path / "2", 2) == expected


def test_an_interrupt_loses_no_point(delivery: Domain, delivery_bias: LanguageBias, tmp_path: Path) -> None:
    expected, _ = learned(delivery, delivery_bias, tmp_path / "1", 1)
    seen: list[Progress] = []

    def interrupt(progress: Progress) -> None:
        seen.append(progress)
        if progress.episodes >= 30:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(delivery, delivery_bias, OPTIONS, tmp_path / "2", 10, 6, interrupt, jobs=2)
    due = [point for point in expected if point.episode <= seen[-1].episodes]
    assert curve(seen[-1]) == due and len((tmp_path / "2" / "curve.csv").read_text().splitlines()) == len(due) + 1


def test_a_process_that_has_gone_is_gone(delivery: Domain, delivery_bias: LanguageBias) -> None:
    process = Ready(points.Sampled(Policy(delivery, delivery_bias), 2, 0, 1.0, []))
    process.ask()
    both = process.answer()
    assert [each.greedy for each in both] == [False, True] and process.free
    process._process.kill()
    process._process.wait()
    with pytest.raises(Gone):
        process.ask()
        process.answer()
    process.close()


# ---------------------------------------------------------------- episodes of an iteration


@pytest.mark.parametrize("name", ["delivery", "tests/domains/ferry.pl"])
def test_episodes_of_an_iteration_are_the_same_in_any_number_of_processes(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The least number of episodes does not always give enough examples, so some are played ahead for nothing."""
    monkeypatch.setattr("nppg.learning.rollouts.MANY", 2)
    domain = open_domain(ROOT / name if "/" in name else name)
    bias = language_bias_of(domain)
    options = Options(episodes=50, episodes_per_iteration=4, min_examples=120, guidance=0.2, seed=2)
    found = []
    for jobs in (1, 2, 3):
        Ready.asked = 0
        progress = run(domain, bias, options, tmp_path / str(jobs), 20, 4, jobs=jobs)
        found.append((curve(progress), progress.policy.trees, (tmp_path / str(jobs) / "model.pl").read_bytes()))
        assert bool(Ready.asked) == (jobs > 1)
    assert found[0][1] and found[0] == found[1] == found[2]


def test_a_process_that_dies_takes_no_episode_along(
    delivery: Domain, delivery_bias: LanguageBias, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("nppg.learning.rollouts.MANY", 2)
    options = Options(episodes=30, episodes_per_iteration=5, min_examples=10)
    *_, expected = train(delivery, delivery_bias, options)
    for after in (1, 3):
        Ready.asked, Ready.after = 0, after
        try:
            *_, last = train(delivery, delivery_bias, options, jobs=2)
        finally:
            Ready.after = 1_000_000
        assert Ready.asked == after and last.policy.trees == expected.policy.trees
