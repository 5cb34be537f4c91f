"""RIB's instances, held against plain loops; the distances are those between random points, or of the blocks world."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nppg import LanguageBias, NppgError
from nppg.judging.space import Space
from nppg.rrl import removal
from nppg.rrl.distance import PairDistance
from nppg.rrl.instances import Instances
from nppg.rrl.options import RIBOptions


class Points:
    """Points of a plane, at least 1 from each other."""

    def __init__(self, count: int, seed: int = 0):
        points = np.random.default_rng(seed).random((count, 2)) * 10
        self.table = np.abs(points[:, None] - points).sum(axis=2) + 1 - np.eye(count)

    def rows(self, pairs: np.ndarray, others: np.ndarray) -> np.ndarray:
        return self.table[np.ix_(pairs, others)]


def predicted(points: Points, known: dict[int, float], pair: int, power: float = 1.0) -> float:
    """The formula, in a loop."""
    if pair in known:
        return known[pair]
    weights = {each: 1 / float(points.table[pair, each]) ** power for each in known}
    return math.fsum(weights[each] * q for each, q in known.items()) / math.fsum(weights.values()) if known else 0.0


def filled(points: Points, count: int, seed: int = 0, **options: object) -> Instances:
    instances, rng = Instances(points, RIBOptions(**options)), np.random.default_rng(seed)  # type: ignore[arg-type]
    for pair in rng.permutation(len(points.table))[:count].tolist():
        instances.store(pair, float(rng.normal()))
    return instances


def contents(instances: Instances) -> dict[int, float]:
    return dict(zip(instances.pairs.tolist(), instances.values.tolist(), strict=True))


@pytest.mark.parametrize("power", [1.0, 2.5])
@pytest.mark.parametrize("count", [0, 1, 2, 20])
def test_prediction(count: int, power: float) -> None:
    points = Points(60)
    instances = filled(points, count, power=power)
    wanted = [predicted(points, contents(instances), pair, power) for pair in range(60)]
    assert np.allclose(instances.predict(np.arange(60)), wanted, rtol=1e-12)
    assert len(instances) == count and instances.predict(np.arange(0)).shape == (0,)


def test_several_instances_at_distance_0() -> None:
    points = Points(5)
    points.table[:] = [[0 if i < 3 and j < 3 else 1 for i in range(5)] for j in range(5)]
    instances = Instances(points, RIBOptions())
    with np.errstate(divide="ignore"):
        for pair, value in ((0, 1.0), (1, 3.0), (3, 100.0)):
            instances.store(pair, value)
    assert instances.predict(np.array([2, 4])) == pytest.approx([2, (1 + 3 + 100) / 3])


def test_a_known_class_takes_the_new_value() -> None:
    instances = filled(Points(30), 10)
    before, pair = contents(instances), int(instances.pairs[4])
    instances.update(pair, 7.5)
    assert contents(instances) == before | {pair: 7.5}


def test_inflow() -> None:
    """What is predicted well, by each of the two deviations, is kept out."""
    points = Points(400, seed=1)
    rng = np.random.default_rng(2)
    kept_out = {"tolerance": 0, "global": 0, "local": 0, "stored": 0}
    instances = Instances(points, RIBOptions(neighbours=5, local_deviation=0.5, global_deviation=0.3))
    for pair in rng.permutation(400).tolist():
        known = contents(instances)
        value = float(rng.choice([0.0, 0.2, 1.0]) * (points.table[0, pair] < 8))
        error = abs(value - predicted(points, known, pair))
        nearest = sorted(known, key=lambda each: points.table[pair, each])[:5]
        instances.update(pair, value)
        if error <= 1e-6:
            reason = "tolerance"
        elif known and error <= 0.3 * np.std(list(known.values())):
            reason = "global"
        elif known and error <= 0.5 * np.std([known[each] for each in nearest]):
            reason = "local"
        else:
            reason = "stored"
        kept_out[reason] += 1
        assert contents(instances) == known | ({pair: value} if reason == "stored" else {})
    assert all(count >= 3 for count in kept_out.values()), kept_out


def test_the_first_values_are_news() -> None:
    """While values do not deviate, what is not predicted comes in, and nothing else does."""
    instances = Instances(Points(10), RIBOptions())
    for pair, value in ((0, 0.0), (1, 1.0), (2, 1.0), (3, 1.0 + 1e-9), (4, 0.0)):
        instances.update(pair, value)
    assert contents(instances) == {1: 1.0, 4: 0.0}


@pytest.mark.parametrize("removal", ["error-contribution", "maximum-variance"])
@pytest.mark.parametrize("k", [-40, 40])
def test_what_is_stored_does_not_hang_on_the_unit_of_the_values(removal: str, k: int) -> None:
    points, rng, unit = Points(300), np.random.default_rng(0), 2.0**k
    few = {"max_instances": 40, "removal": removal}
    one, other = (Instances(points, RIBOptions(max_gradient=0.3 * each, **few)) for each in (1.0, unit))  # type: ignore[arg-type]
    for pair in rng.permutation(300).tolist():
        value = float(np.sin(pair) * rng.choice([1, 1e-3]))
        one.update(pair, value)
        other.update(pair, unit * value)
    assert len(one) == 40
    assert contents(other) == {pair: unit * value for pair, value in contents(one).items()}


def test_an_error_is_small_beside_all_that_was_met() -> None:
    """Whatever is left in memory: the unit is the task's, not that of a place in it."""
    instances = Instances(Points(3), RIBOptions())
    for pair, value in ((0, 1.0), (0, 0.0), (1, 5e-7), (2, 2e-6)):
        instances.update(pair, value)
    assert contents(instances) == {0: 0.0, 2: 2e-6}


def leave_one_out(points: Points, known: dict[int, float], power: float) -> dict[int, float]:
    return {
        each: abs(q - predicted(points, {other: known[other] for other in known if other != each}, each, power))
        for each, q in known.items()
    }


def growth(points: Points, known: dict[int, float], gone: int, power: float = 1.0) -> float:
    """By how much the summed errors grow where one goes, whose own error has been 0."""
    rest = {each: q for each, q in known.items() if each != gone}
    before = leave_one_out(points, known, power)
    return (
        before[gone] + math.fsum(leave_one_out(points, rest, power).values()) - math.fsum(before[each] for each in rest)
    )


def excess(points: Points, known: dict[int, float], pair: int, most: float) -> float:
    return math.fsum(
        max(0.0, abs(known[pair] - q) / float(points.table[pair, each]) - most)
        for each, q in known.items()
        if each != pair
    )


@pytest.mark.parametrize("power", [1.0, 2.0, 4.0, 8.0, 20.0])
@pytest.mark.parametrize("count", [3, 4, 15, 40])
def test_scores_of_removal(count: int, power: float) -> None:
    points = Points(60, seed=count)
    instances = filled(points, count, max_gradient=0.3, power=power)
    known = contents(instances)
    wanted = [growth(points, known, each, power) for each in known]
    assert np.allclose(instances.error_contributions(), wanted, atol=1e-4)
    assert np.allclose(instances.variance_excess(), [excess(points, known, each, 0.3) for each in known], atol=1e-4)


@pytest.mark.parametrize("power", [1.0, 2.0, 4.0, 5.0, 8.0, 12.0, 20.0])
@pytest.mark.parametrize("unit", [1.0, 1e-6, 1e4])
def test_what_costs_least_is_found_whatever_the_weights_range(power: float, unit: float) -> None:
    """Points at whole distances on a line, of which some are much nearer to each other than to all others."""
    rng = np.random.default_rng(int(power))
    for _ in range(20):
        line = np.cumsum(rng.choice([1, 2, 30, 400], 20)) * unit
        points = Points(20)
        points.table = np.abs(line[:, None] - line)
        instances = filled(points, 20, power=power, seed=int(rng.integers(1000)))
        known = contents(instances)
        found = instances.error_contributions()
        wanted = np.array([growth(points, known, each, power) for each in known])
        assert np.allclose(found, wanted, atol=1e-4)
        assert wanted[found.argmin()] <= wanted.min() + 1e-4


@pytest.mark.parametrize(
    "removal, most", [("error-contribution", 0.1), ("maximum-variance", 0.3), ("maximum-variance", 50.0)]
)
def test_removal(removal: str, most: float) -> None:
    """Each time the one that a plain recomputation would remove; where no slope is too steep, by the errors."""
    points = Points(80, seed=3)
    everything = {"local_deviation": 0.0, "global_deviation": 0.0}
    instances = filled(points, 12, max_instances=12, removal=removal, max_gradient=most, **everything)
    rng = np.random.default_rng(4)
    removed = 0
    for pair in rng.permutation(80).tolist():
        known, value = contents(instances), float(rng.normal())
        instances.update(pair, value)
        now = contents(instances)
        assert len(now) == 12
        if pair in known:
            assert now == known | {pair: value}
            continue
        known[pair] = value
        (gone,) = known.keys() - now.keys()
        steep = {each: excess(points, known, each, most) for each in known}
        if removal == "maximum-variance" and max(steep.values()) > 0:
            assert steep[gone] >= max(steep.values()) - 1e-4
        else:
            grown = {each: growth(points, known, each) for each in known}
            assert grown[gone] <= min(grown.values()) + 1e-4
        removed += 1
    assert removed >= 60


@settings(max_examples=60)
@given(
    st.integers(0, 10**6),
    st.integers(3, 60),
    st.sampled_from([1.0, 3.0, 8.0]),
    st.sampled_from([0.0, 0.01, 1.0]),
    st.sampled_from([2.0**-30, 1.0, 2.0**30]),
    st.sampled_from([1, 4, 100]),
)
def test_the_least_contribution(seed: int, room: int, power: float, noise: float, unit: float, few: int) -> None:
    """While instances come, go and take other values, the bounds hold, and the one that is found is the one of all
    contributions, to the byte; also where values are alike and nearly alike, so that nothing is certain."""
    rng = np.random.default_rng(seed)
    points = Points(3 * room, seed)
    points.table = np.ceil(points.table * rng.choice([0.3, 3]))
    instances = Instances(points, RIBOptions(max_instances=room, power=power))
    quick = instances._contributions
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(removal, "_MANY", 3)
        patch.setattr(removal, "_FEW", min(few, room - 1))
        patch.setattr(removal, "_SOME", few)
        for pair in rng.integers(len(points.table), size=4 * room).tolist():
            instances.update(pair, unit * (rng.integers(3) + noise * rng.normal()))
            n = len(instances)
            if n >= max(3, min(few, room - 1) + 1):
                costs = instances.error_contributions()
                assert quick.least(n) == costs.argmin()
                some = rng.permutation(n)[: rng.integers(2, n + 1)]
                weights, values = instances._weights[:n, :n], instances._values[:n]
                assert (removal.error_contributions(weights, values, some) == costs[some]).all()
        n = len(instances)
        weights, values = instances._weights[:n, :n], instances._values[:n].astype(instances._weights.dtype)
        weights = weights.astype(float)
        assert np.allclose(quick._sums[:, :n], (weights.sum(axis=1), weights @ values, (weights**2).sum(axis=1)))
        if 4 * quick._largest <= quick._sums[0, :n].min():
            q, predicted = values.astype(float), quick._sums[1, :n] / quick._sums[0, :n]
            bounds = quick._bounds(q, predicted, q - predicted)
            slack = removal.error_contributions(weights, q)[:-1] - bounds
            assert slack.min() >= -1e-5 * unit * (3 + 5 * noise)


@pytest.mark.parametrize("remembered", [0, 3 * 8 * 21, 40 * 8 * 21, 2**20])
def test_distances_are_remembered(monkeypatch: pytest.MonkeyPatch, remembered: int) -> None:
    """What is remembered, brought up to date, forgotten, or too much to be remembered, is what is computed."""
    monkeypatch.setattr("nppg.rrl.instances._REMEMBERED", remembered)
    monkeypatch.setattr("nppg.rrl.instances._TOGETHER", 30)
    points, rng = Points(80, seed=2), np.random.default_rng(3)
    points.table[:60, :60] = np.rint(points.table[:60, :60])  # single precision has these, and not the others
    instances = Instances(points, RIBOptions(max_instances=20))
    for pair in [*rng.integers(60, size=100), *rng.integers(80, size=300)]:
        instances.update(int(pair), float(rng.normal()))
        some = rng.integers(80, size=rng.integers(6))
        assert (instances._distances(some) == points.rows(some, instances.pairs)).all()
    assert len(instances) == 20


@pytest.mark.parametrize("removal", ["error-contribution", "maximum-variance"])
def test_soak(removal: str) -> None:
    """8,000 examples: memory stays bounded, what is kept incrementally stays exact, and something is learned."""
    points, rng = Points(3000, seed=5), np.random.default_rng(6)
    truth = np.tanh(points.table[0] - points.table[1])
    instances = Instances(points, RIBOptions(max_instances=100, removal=removal, max_gradient=1.0))
    weights = instances._weights
    full = 0
    for count, pair in enumerate(rng.integers(3000, size=8_000).tolist()):
        instances.update(pair, float(truth[pair] + 0.05 * rng.normal()))
        full += len(instances) == 100
        if count % 2000 == 0:
            pairs = instances.pairs
            assert len(set(pairs.tolist())) == len(pairs) == len(instances) <= 100
            wanted = 1 / (points.rows(pairs, pairs) + np.diag(np.full(len(pairs), np.inf)))
            assert (weights[: len(pairs), : len(pairs)] == wanted.astype(np.float32)).all()
    assert full > 4_000 and instances._weights is weights and weights.shape == (101, 101)
    error = np.sqrt(np.mean((instances.predict(np.arange(3000)) - truth) ** 2))
    assert error < 0.75 * truth.std()


def test_a_full_memory_takes_no_more_from_a_file() -> None:
    instances = filled(Points(20), 5, max_instances=5)
    with pytest.raises(ValueError, match="room for 5"):
        instances.store(19, 1.0)


def test_options() -> None:
    with pytest.raises(NppgError) as caught:
        RIBOptions(max_instances=1, removal="at random", neighbours=0, mismatch=0)
    assert len(caught.value.problems) == 4


def test_it_learns_the_optimal_values_of_the_blocks_world(space: Space, plain_bias: LanguageBias) -> None:
    """0.9 to the power of the moves that are left after the action, from a stream of pairs drawn at random."""
    rng = np.random.default_rng(0)
    domain = space.domain
    measure, values = PairDistance(domain, plain_bias), {}
    for i in np.flatnonzero(space.running)[rng.permutation(int(space.running.sum()))[:200]]:
        best = space.horizons[i]
        moves = {action: outcomes[0].state for action, outcomes in domain.neighbours(space.states[i])}
        for action, number in zip(space.actions[i], measure.describe(space.states[i], space.actions[i]), strict=True):
            values[int(number)] = 0.9 ** domain.horizon(moves[action])
        assert best == 1 + min(domain.horizon(each) for each in moves.values())
    numbers, truth = np.array(list(values)), np.array(list(values.values()))
    instances = Instances(measure, RIBOptions(max_instances=300))
    for i in rng.integers(len(numbers), size=1500):
        instances.update(int(numbers[i]), float(truth[i]))
    error = np.sqrt(np.mean((instances.predict(numbers) - truth) ** 2))
    assert len(instances) <= 300 and error < 0.8 * truth.std()
