"""The functional gradient is the derivative of value * pi(s, a), and the Gibbs distribution is stable."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nppg.learning.gradient import advantages, functional_gradient, returns, taken_gradient, total
from nppg.policy.gibbs import gibbs

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
def test_a_baseline_changes_no_expected_gradient(psi: np.ndarray, data, baseline: float) -> None:
    """The gradients of all actions' advantages add up to the slope of the expected one, and of the expected value. So
    do those of drawn actions on average, where visits are weighted by the power 0 of pi(s, a); not by its power 1."""
    worth = np.array(data.draw(st.lists(values, min_size=len(psi), max_size=len(psi))))
    pi = gibbs(psi)
    gradient = sum(functional_gradient(pi, a, worth[a] - baseline) for a in range(len(psi)))
    drawn = sum(pi[a] * functional_gradient(pi, a, worth[a] - baseline, 0.0) for a in range(len(psi)))
    assert drawn == pytest.approx(gradient, abs=1e-9)
    step = 1e-5
    for b, unit in enumerate(np.eye(len(psi))):
        more, less = gibbs(psi + step * unit), gibbs(psi - step * unit)
        for own in (worth - baseline, worth):
            assert gradient[b] == pytest.approx((own @ more - own @ less) / (2 * step), abs=1e-6)


@given(potentials, st.data(), values)
def test_the_taken_gradient_is_divided_by_the_probability(psi: np.ndarray, data, value: float) -> None:
    chosen = data.draw(st.integers(0, len(psi) - 1))
    pi = gibbs(psi)
    expected = functional_gradient(pi, chosen, value)[chosen]
    assert taken_gradient(pi, chosen, value) * pi[chosen] == pytest.approx(expected, abs=1e-12)
    for k in (0.0, 0.5, 1.0):
        entry = functional_gradient(pi, chosen, value, k)[chosen]
        assert taken_gradient(pi, chosen, value, k) == pytest.approx(entry, abs=1e-12)


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


steps = st.lists(st.tuples(st.floats(-5, 5), st.floats(-5, 5)), max_size=8)


@given(steps, st.floats(-5, 5), st.floats(0, 1), st.floats(0, 1))
def test_advantages_are_sums_of_temporal_differences(drawn, last: float, discount: float, trace: float) -> None:
    rewards, v = [reward for reward, _ in drawn], [*(value for _, value in drawn), last]
    deltas = [r + discount * v[t + 1] - v[t] for t, r in enumerate(rewards)]
    expected = [sum((discount * trace) ** k * d for k, d in enumerate(deltas[t:])) for t in range(len(deltas))]
    assert advantages(rewards, v[:-1], last, discount, trace).tolist() == pytest.approx(expected, abs=1e-9)


@given(steps, st.floats(-5, 5), st.floats(0, 1))
def test_the_ends_of_the_trace(drawn, last: float, discount: float) -> None:
    """1: the return, with the discounted value of where the episode was cut off, minus V; 0: one step's difference."""
    rewards, v = [reward for reward, _ in drawn], [value for _, value in drawn]
    full = returns([*rewards, last], discount)[:-1] - v
    assert advantages(rewards, v, last, discount, 1.0).tolist() == pytest.approx(full.tolist(), abs=1e-9)
    one = np.array(rewards) + discount * np.array([*v[1:], last])[: len(v)] - v
    assert advantages(rewards, v, last, discount, 0.0).tolist() == pytest.approx(one.tolist(), abs=1e-9)


@given(st.lists(st.integers(-(10**6), 10**6)), st.integers(0, 6))
def test_totals_are_those_of_the_decimals(numbers: list[int], places: int) -> None:
    """Rewards of cents that cancel are 0, and cents that make a whole are one."""
    assert total(number / 10**places for number in numbers) == sum(numbers) / 10**places
    assert total([*[-0.1] * 10, 1.0]) == 0.0 and total([0.1, 0.2, -0.3]) == 0.0 and total([]) == 0.0
