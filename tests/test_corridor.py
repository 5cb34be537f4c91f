"""The corridor's optimum: where it switches, that nothing is better, and what episodes in the domain itself get."""

from __future__ import annotations

import numpy as np
import pytest

from nppg import Domain, NppgError
from nppg.experiments.corridor import Corridor


@pytest.mark.parametrize(("mean", "switch"), [(0.0, 5.0), (1.0, 1.25), (-1.0, 8.75)])
def test_the_switch(mean: float, switch: float) -> None:
    """With zero-mean noise in the middle; with the noise that the paper prints far from it."""
    corridor = Corridor(Domain("corridor", {"noise_mean": mean}), 400)
    found = corridor.optimum()
    assert found.switch == pytest.approx(switch, abs=0.03)
    assert (found.right == (corridor.centres > found.switch)).all()
    assert found.mean == pytest.approx(found.values.mean())
    assert corridor.values(found.right.astype(float)) == pytest.approx(found.values)


def test_nothing_is_better() -> None:
    corridor = Corridor(Domain("corridor"), 100)
    best = corridor.optimum().values
    assert best == pytest.approx(best[::-1])
    for at in (0.0, 3.0, 4.0, 6.0, 10.0):
        assert corridor.values((corridor.centres > at).astype(float)).mean() < best.mean() - 0.01
    assert corridor.values(np.full(100, 0.5)).mean() < best.mean() - 5


@pytest.mark.parametrize("mean", [0.0, 0.5])
def test_episodes_get_what_the_cells_say(mean: float) -> None:
    """Also with other numbers than the default ones."""
    domain = Domain("corridor", {"noise_mean": mean, "length": 6.0, "step": 0.7, "exit_reward": 5.0, "noise_sd": 0.8})
    corridor = Corridor(domain, 400)
    expected = corridor.values((corridor.centres > 2.0).astype(float)).mean()
    rng, totals = np.random.default_rng(0), []
    for _ in range(1000):
        state, total = domain.start(rng), 0.0
        while domain.situation(state).status == "running":
            reward, state = domain.act(state, "right" if state[0][1] > 2.0 else "left", rng)
            total += reward
        totals.append(total)
    assert np.mean(totals) == pytest.approx(expected, abs=4 * np.std(totals) / 1000**0.5)
    assert 1 < np.std(totals) < 4


def test_without_noise_there_is_no_such_optimum() -> None:
    with pytest.raises(NppgError, match="noise_sd must be above 0"):
        Corridor(Domain("corridor", {"noise_sd": 0.0}))
