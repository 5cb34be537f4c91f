"""What trees learn from, and by what values."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nppg.learning.episode import Step
from nppg.learning.options import Options
from nppg.learning.visits import Visit, kept, normalised

STEP = Step((), [], np.zeros((0, 0), bool), np.zeros(0), np.zeros(0), 0, 0.0, ())
values = st.lists(st.floats(-100, 100), min_size=1, max_size=20)


def visits(drawn: list[float]) -> list[Visit]:
    return [Visit(STEP, value, bool(i % 2)) for i, value in enumerate(drawn)]


@given(values)
def test_standardised_values(drawn: list[float]) -> None:
    found = normalised(visits(drawn), Options(normalise="yes"))
    now = np.array([visit.value for visit in found])
    assert now.mean() == pytest.approx(0, abs=1e-6)
    assert now.std() == pytest.approx(float(np.std(drawn) > 0), abs=1e-6)
    assert [visit.guided for visit in found] == [visit.guided for visit in visits(drawn)]
    assert np.all(np.diff(now[np.argsort(drawn, kind="stable")]) >= -1e-9)
    assert normalised(visits(drawn), Options()) == visits(drawn)


@pytest.mark.parametrize("step", ["gradient", "second-order"])
@pytest.mark.parametrize("unrewarded", ["keep", "drop"])
@pytest.mark.parametrize("normalise", ["no", "yes"])
def test_values_of_0(step: str, unrewarded: str, normalise: str) -> None:
    """They say something where they are standardised, and are an example of the gradient 0 in the paper's step."""
    drawn = visits([1.0, 0.0, -2.0, 0.0])
    options = Options(step=step, unrewarded=unrewarded, normalise=normalise)
    expected = unrewarded == "keep" and (step == "gradient" or normalise == "yes")
    assert kept(drawn, options) == (drawn if expected else [drawn[0], drawn[2]])
