"""The functional gradient is the derivative of value * pi(s, a), and the Gibbs distribution is stable."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nppg.gradient import functional_gradient, gibbs, returns, taken_gradient

potentials = st.lists(st.floats(-8, 8), min_size=1, max_size=8).map(np.array)
values = st.floats(-10, 10)


@given(potentials, st.data(), values)
def test_gradients_sum_to_zero_and_match_finite_differences(psi: np.ndarray, data, value: float) -> None:
    chosen = data.draw(st.integers(0, len(psi) - 1))
    gradient = functional_gradient(gibbs(psi), chosen, value)
    assert gradient.sum() == pytest.approx(0, abs=1e-12)
    step = 1e-5
    for b in range(len(psi)):
        more, less = psi.copy(), psi.copy()
        more[b] += step
        less[b] -= step
        slope = value * (gibbs(more)[chosen] - gibbs(less)[chosen]) / (2 * step)
        assert gradient[b] == pytest.approx(slope, abs=1e-8)


@given(potentials, st.data(), values)
def test_the_taken_gradient_is_divided_by_the_probability(psi: np.ndarray, data, value: float) -> None:
    chosen = data.draw(st.integers(0, len(psi) - 1))
    pi = gibbs(psi)
    expected = functional_gradient(pi, chosen, value)[chosen]
    assert taken_gradient(pi, chosen, value) * pi[chosen] == pytest.approx(expected, abs=1e-12)


@given(potentials)
def test_gibbs_is_the_distribution_of_its_definition(psi: np.ndarray) -> None:
    total = math.fsum(math.exp(each) for each in psi)
    assert gibbs(psi) == pytest.approx([math.exp(each) / total for each in psi], rel=1e-12)


def test_gibbs_is_stable() -> None:
    with np.errstate(all="raise", under="ignore"):
        assert gibbs(np.array([1e307, 1e307, -1e307])).tolist() == [0.5, 0.5, 0.0]
        assert gibbs(np.array([-1e5, -1e5 - math.log(3)])) == pytest.approx([0.75, 0.25])
    assert gibbs(np.array([1e4])).tolist() == [1.0]


@given(st.lists(st.floats(-5, 5), max_size=8), st.floats(0, 1))
def test_returns_are_discounted_sums(rewards: list[float], discount: float) -> None:
    expected = [sum(discount**k * r for k, r in enumerate(rewards[t:])) for t in range(len(rewards))]
    assert returns(rewards, discount).tolist() == pytest.approx(expected, abs=1e-9)
