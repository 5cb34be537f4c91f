"""From small problems to large ones, and a word where all episodes come to nothing."""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest

from nppg import language_bias_of, open_domain
from nppg.bias.language_bias import LanguageBias
from nppg.cli.main import main
from nppg.errors import NppgError
from nppg.judging.problems import attempts
from nppg.learning.curriculum import FIRST, Curriculum, curriculum_of
from nppg.learning.options import Options
from nppg.learning.training import Iteration, train
from nppg.rrl import training as q_learning
from nppg.rrl.options import TGOptions
from nppg.worlds.domain import Domain

DOORS = Path(__file__).parent / "domains" / "doors.pl"


def of(count: int, **more) -> Curriculum:
    return Curriculum(tuple(range(1, count + 1)), tuple(range(10, 10 * count + 10, 10)), **more)


def learned(problems: Sequence[int], jobs: int = 1, **options) -> tuple[list[Iteration], list[str]]:
    """What training yields on these problems, and what it warns of."""
    domain = open_domain(DOORS).with_problems(problems)
    return heard(train(domain, language_bias_of(domain), Options(**options), jobs))


def heard(iterations: Iterator[Iteration]) -> tuple[list[Iteration], list[str]]:
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        found = list(iterations)
    return found, [str(each.message) for each in told]


# ---------------------------------------------------------------- the rule


def test_problems_are_ordered_by_their_size() -> None:
    found = curriculum_of(open_domain(DOORS).with_problems([8, 3, 7, 1, 5]))
    assert found and found.order == (1, 3, 5, 7, 8) and found.horizons == (2, 4, 6, 8, 9)
    assert curriculum_of(open_domain(DOORS).with_problems([8, 3, 7, 1])) is None  # it would begin with all
    assert curriculum_of(open_domain("blocks_world")) is None


def test_half_of_the_steps_are_for_the_largest_third_and_half_for_all_that_is_open() -> None:
    curriculum, rng = of(9), np.random.default_rng(0)
    drawn = Counter(curriculum.draw(rng, 6) for _ in range(20_000))
    steps = np.array([drawn[each] * curriculum.horizons[each - 1] for each in range(1, 10)])
    expected = np.array([*[1 / 12] * 4, *[1 / 12 + 1 / 4] * 2, 0, 0, 0])
    assert np.allclose(steps / steps.sum(), expected, atol=0.02)


def test_it_widens_as_the_largest_succeed() -> None:
    curriculum = of(9)
    for _ in range(100):
        curriculum.note(1, True)  # of the smallest third
    assert curriculum.opened == FIRST
    for success in [True] * 15 + [False] * 5:
        assert curriculum.opened == FIRST
        curriculum.note(4, success)
    assert curriculum.opened == FIRST + 1 and str(curriculum) == "5/9"
    for _ in range(100):
        curriculum.note(curriculum.opened, True)
    assert curriculum.opened == 9


@pytest.mark.parametrize(
    "successes, any_success, opened",
    [([], True, FIRST), ([], False, FIRST + 1), ([70], True, FIRST + 1), ([70], False, FIRST + 1)],
)
def test_some_problems_beyond_the_policy_hold_up_no_others(
    successes: list[int], any_success: bool, opened: int
) -> None:
    curriculum = of(9, any_success=any_success)
    for number in range(200):
        assert curriculum.opened == FIRST
        curriculum.note(4, number in successes)
    assert curriculum.opened == opened


# ---------------------------------------------------------------- training


OPTIONS = {"step": "second-order", "discount": 0.95, "guidance": 0.0}


def test_large_problems_alone_teach_nothing_and_small_ones_first_open_them(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("nppg.learning.rollouts.SILENCE", 20)
    silent, told = learned(range(5, 10), episodes=100, **OPTIONS)
    assert not silent[-1].policy.trees and silent[-1].stage.endswith("/5")
    assert len(told) == 2 and "none of 20 episodes" in told[0] and "none of 100 episodes" in told[1]
    assert "smallest problems" in told[0] and "nothing has been learned" in told[1]

    found, told = learned(range(1, 10), episodes=500, **OPTIONS)
    stages = [int(each.stage.split("/")[0]) for each in found]
    assert not told and stages[0] == FIRST and stages == sorted(stages) and stages[-1] == 9
    assert all(each.solved for each in attempts(found[-1].policy))


def test_without_a_curriculum_problems_are_drawn_as_the_domain_draws_them() -> None:
    found, told = learned(range(5, 10), episodes=50, curriculum="no", **OPTIONS)
    assert found[-1].stage == "" and len(told) == 1 and "--curriculum yes" in told[0]
    few, _ = learned(range(1, FIRST + 1), episodes=50, min_examples=20, **OPTIONS)
    same, _ = learned(range(1, FIRST + 1), episodes=50, min_examples=20, curriculum="no", **OPTIONS)
    assert few[-1].policy.trees == same[-1].policy.trees != []


def test_it_is_the_same_in_any_number_of_processes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("nppg.learning.rollouts.MANY", 5)
    monkeypatch.setattr("nppg.policy.beside._PATIENCE", 0.0)
    options = {"episodes": 150, "episodes_per_iteration": 10, "min_examples": 50, **OPTIONS}
    (one, _), (three, _) = (learned(range(1, 10), jobs, **options) for jobs in (1, 3))
    assert one[-1].policy.trees == three[-1].policy.trees != []
    assert [each.stage for each in one] == [each.stage for each in three] and one[-1].stage != one[0].stage


def test_the_command_line_shows_where_it_stands(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    options = ["--step", "second-order", "--episodes", "60", "--evaluate-every", "30", "--jobs", "1"]
    assert main(["train", str(DOORS), "--problems", "1-9", *options, "--output", str(tmp_path)]) == 0
    said = capsys.readouterr()
    assert "problems 4/9" in said.out and not said.err
    assert main(["train", str(DOORS), "--problems", "5-9", *options, "--output", str(tmp_path)]) == 0
    said = capsys.readouterr()
    assert "problems 4/5" in said.out and said.err.count("warning: none of 60 episodes") == 1


# ---------------------------------------------------------------- where all comes to nothing


def world(folder: Path, clause: str, goal: bool = True) -> tuple[Domain, LanguageBias]:
    """That of the doors with one more clause, with its goal or without: five problems too large for chance."""
    path = folder / "doors.pl"
    text = f"{DOORS.read_text()}\n{clause}\n"
    path.write_text(text if goal else text.replace("goal :- room(X), last(X).", ""))
    return Domain(path).with_problems(range(5, 10)), LanguageBias.load(DOORS.with_suffix(".yaml"))


COSTS = "reward(_, R) :- ( goal -> R = 10 ; R = -1 )."


def test_where_steps_cost_something_it_is_the_goal_that_counts(tmp_path: Path) -> None:
    domain, bias = world(tmp_path, COSTS)
    for learner in (train(domain, bias, Options(20)), q_learning.train(domain, bias, TGOptions(20))):
        _, told = heard(learner)
        assert len(told) == 1 and told[0].startswith("none of 20 episodes reached the goal")
        assert "learned" not in told[0]  # they may learn from costs
    _, told = heard(train(domain.with_problems([1]), bias, Options(20, guidance=0.0)))
    assert not told


def test_where_there_is_no_goal_it_is_the_rewards(tmp_path: Path) -> None:
    domain, bias = world(tmp_path, "reward(_, 0).", goal=False)
    _, told = heard(train(domain, bias, Options(20)))
    assert len(told) == 1 and "none of 20 episodes was rewarded: nothing has been learned. What" in told[0]
    domain, bias = world(tmp_path, "reward(_, -1).", goal=False)
    assert heard(train(domain, bias, Options(20)))[1] == []


def test_it_is_told_however_a_run_ends_but_by_a_mistake() -> None:
    domain = open_domain(DOORS).with_problems(range(5, 10))
    bias = language_bias_of(domain)
    ends = iter([False] * 9 + [True])
    _, told = heard(train(domain, bias, Options(10**6), is_over=lambda: next(ends)))
    assert len(told) == 1 and told[0].startswith("none of 10 episodes reached the goal")

    def ended_by(error: type[BaseException]) -> list[str]:
        """What is told where a run is ended at its fourth episode."""
        calls = iter(range(3))

        def is_over() -> bool:
            if next(calls, None) is None:
                raise error("")
            return False

        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            with pytest.raises(error):
                list(train(domain, bias, Options(10**6), is_over=is_over))
        return [str(each.message) for each in told]

    assert ended_by(NppgError) == [] and "none of 4 episodes" in "".join(ended_by(KeyboardInterrupt))
    iterations = train(domain, bias, Options(10**6, min_examples=0))
    with pytest.warns(UserWarning, match="none of 1 episodes"):
        next(iterations), next(iterations)
        iterations.close()


def test_a_run_that_its_seconds_end_tells_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    options = ["--problems", "5-9", "--seconds", "0.05", "--evaluate-every", "0", "--output", str(tmp_path / "run")]
    for learner in ("nppg", "tg"):
        assert main(["train", str(DOORS), "--learner", learner, *options]) == 0
        assert capsys.readouterr().err.count("reached the goal") == 1
