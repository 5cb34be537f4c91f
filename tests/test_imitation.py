"""Self-imitation: what is known of the ways to the goal, the gradient of comparisons, and that failures teach."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nppg import language_bias_of, open_domain, options_of
from nppg.bias.language_bias import LanguageBias
from nppg.cli.main import main
from nppg.judging.evaluation import ExactEvaluator
from nppg.judging.problems import attempts
from nppg.learning.courses import Returns, SelfImitation, course_of, examples
from nppg.learning.critic import critic
from nppg.learning.detours import detours
from nppg.learning.episode import Episode, Step, generate_episode
from nppg.learning.experience import Experience, Ways
from nppg.learning.gradient import comparison_gradient
from nppg.learning.options import Options
from nppg.learning.regressors import regressor
from nppg.learning.training import train
from nppg.learning.visits import kept
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State

DOORS = Path(__file__).parent / "domains" / "doors.pl"
LOGISTICS = DOORS.with_name("logistics.pl")
SELF = {"imitation": "self", "step": "second-order", "discount": 0.95, "floor": 0.1, "replay": 50, "min_examples": 50}
NOTHING = np.empty(0)


def doors(problems: Sequence[int]) -> Domain:
    return open_domain(DOORS).with_problems(problems)


def played(domain: Domain, choices: Sequence[int], number: int) -> Episode:
    """The episode in which these doors are opened."""
    return acted(domain, [("open", door) for door in choices], domain.problem(number))


def acted(domain: Domain, choices: Sequence[Action], state: State) -> Episode:
    """The episode in which these actions are taken."""
    rng, steps = np.random.default_rng(0), []
    for choice in choices:
        actions = domain.situation(state).actions
        chosen = actions.index(choice)
        reward, following = domain.act(state, actions[chosen], rng)
        steps.append(Step(state, list(actions), NOTHING, NOTHING, NOTHING, chosen, reward, state))
        state = following
    status, actions = domain.situation(state)
    return Episode(tuple(steps), state, actions, status == "goal", state)


# ---------------------------------------------------------------- what is known


graphs = st.lists(st.lists(st.none() | st.integers(0, 7), max_size=4), min_size=1, max_size=8)


@given(graphs, st.sets(st.integers(0, 7), max_size=2), st.sets(st.integers(0, 7), max_size=2), st.data())
def test_distances_and_dead_ends_are_those_of_the_graph(graph: list, goals: set[int], ends: set[int], data) -> None:
    """Of states with actions that lead somewhere or have not been tried (none), some goals, some ends of episodes, in
    whatever order these are learned."""
    graph = [*graph, *[[]] * (8 - len(graph))]
    ways, states = Ways(), range(8)
    numbers = [ways.number(SimpleNamespace(fingerprint=100 + state)) for state in states]  # type: ignore[arg-type]
    assert numbers == [*states]
    ends, acted = ends - goals, [state for state in states if graph[state] and state not in goals | ends]
    learned = [(state, action) for state in acted for action, y in enumerate(graph[state]) if y is not None]
    for state, action in data.draw(st.permutations([*learned, *((state, None) for state in sorted(goals | ends))])):
        if action is None:
            ways.end(state, state in goals)
        else:
            ways.lead(state, range(len(graph[state])), action, graph[state][action])

    edges = {x: {y for y in graph[x] if y is not None} if x in acted else set() for x in states}
    reached = [{x} for x in states]  # by ever more steps
    distances = dict.fromkeys(goals, 0)
    for steps in range(1, 9):
        reached = [set().union(*(edges[y] for y in each)) for each in reached]
        for x in states:
            if reached[x] & goals:
                distances.setdefault(x, steps)
    assert ways.distances == distances
    for state in distances:
        at = state
        for action in ways.way(state):
            at = graph[at][action]
        assert len(ways.way(state)) == distances[state] and at in goals

    def is_open(x: int) -> bool:
        return x not in goals | ends and (not edges[x] or None in graph[x])

    hopeful = {x for x in states if is_open(x) or x in goals}
    for _ in states:
        hopeful |= {x for x in states if edges[x] & hopeful}
    assert ways.dead == set(states) - hopeful


def test_what_has_been_tried_is_compared_by_its_return_and_by_how_often_it_was_seen() -> None:
    ways = Ways()
    for state in range(5):
        ways.number(SimpleNamespace(fingerprint=state))  # type: ignore[arg-type]
    legal = ["right", "round", "unknown", "dead", "untried"]
    for action, following in (("right", 1), ("round", 2), ("unknown", 3), ("dead", 4)):
        ways.lead(0, legal, action, following)
    assert ways.comparison(0, 0.9) is None  # no way is known
    ways.lead(2, ["on"], "on", 1)
    ways.end(1, True)
    ways.end(4, False)
    ways.visits[:] = [1, 1, 6, 3, 1]
    found = ways.comparison(0, 0.9)
    assert found and found.actions == ["right", "round", "unknown", "dead"] and found.best == 1
    assert found.losses == pytest.approx([(1 - 0.9) / (1 + 3 / 6), 1 / (1 + 3 / 3), 1.0])
    assert ways.comparison(2, 0.9) is None  # nothing to compare


# ---------------------------------------------------------------- detours


LAMPS = """\
:- module(lamps, []).
% Lamps are lit one by one, in any order; a bell does nothing but ring.
:- static lamp/1, wanted/1.
:- fluent lit/1, rings/1.
action(light(X)) :- lamp(X), \\+ lit(X).
action(ring) :- \\+ rings(_).
effect(light(X), [], [lit(X)]).
effect(ring, [], [rings(bell)]).
goal :- \\+ ( wanted(X), \\+ lit(X) ).
start([lamp(1), lamp(2), lamp(3), wanted(1), wanted(2)]).
horizon(9).
"""


@pytest.fixture
def lamps(tmp_path: Path) -> Policy:
    (tmp_path / "lamps.pl").write_text(LAMPS)
    domain = Domain(tmp_path / "lamps.pl")
    modes = "modes: [lit(+)]\ntypes: {lit: [lamp]}\n"
    return Policy(domain, LanguageBias.parse(f"action: [light(+lamp), ring]\n{modes}", "lamps.yaml"))


def test_detours_find_out_which_steps_a_way_can_do_without(lamps: Policy) -> None:
    """The lamp that nobody wants and the bell are left out, and what is tried first makes no way longer than it is."""
    domain, rng, experience = lamps.domain, np.random.default_rng(0), Experience()
    start = domain.start(rng)
    waste = [("light", 3), "ring", ("light", 2), ("light", 1)]
    ways, met = experience.hear(acted(domain, waste, start))
    assert ways.distances[met[0]] == 4
    assert detours(ways, met, lamps, rng, 2) <= 2 + 2 * 4 + 10
    for _ in range(20):
        steps = detours(ways, met, lamps, rng, 1000)
    assert steps == 0  # all has been tried
    assert ways.distances[met[0]] == 2 and len(ways.way(met[0])) == 2
    found = ways.comparison(met[0], 0.9)
    assert found and set(found.actions[: found.best]) == {("light", 1), ("light", 2)}
    assert set(found.actions[found.best :]) == {("light", 3), "ring"}
    far = {ways.tried[met[0]][action]: 2 for action in found.actions[found.best :]}
    assert {each: ways.distances[each] for each in far} == far


def test_ways_that_are_no_shorter_are_not_remembered(lamps: Policy) -> None:
    domain, rng, experience = lamps.domain, np.random.default_rng(0), Experience()
    ways, met = experience.hear(acted(domain, [("light", 2), ("light", 1)], domain.start(rng)))
    ways.legal[:] = [None] * len(ways.legal)  # no other action is tried
    assert detours(ways, met, lamps, rng, 1000) == 1  # without light(2), light(1) is what is left
    assert len(ways.states) == 3 and experience.size == 3
    assert detours(ways, met, lamps, rng, 1000) == 0


# ---------------------------------------------------------------- the gradient


@given(
    st.lists(st.floats(-5, 5), min_size=1, max_size=4), st.lists(st.floats(-5, 5), min_size=1, max_size=5), st.data()
)
def test_the_gradient_and_the_curvature_match_finite_differences(better: list, worse: list, data) -> None:
    better = [each + 0.01 * i for i, each in enumerate(sorted(better))]  # one is highest
    losses = np.array(data.draw(st.lists(st.floats(0, 1), min_size=len(worse), max_size=len(worse))))
    psi, step = np.array(better + worse), 1e-4

    def objective(potentials: np.ndarray) -> float:
        apart = potentials[: len(better)].max() - potentials[len(better) :]
        return float((losses * -np.log1p(np.exp(-apart))).sum() / math.sqrt(len(worse)))

    gradient, curvature = comparison_gradient(psi, len(better), losses)
    assert gradient.sum() == pytest.approx(0, abs=1e-12)
    for b, unit in enumerate(step * np.eye(len(psi))):
        more, less, here = objective(psi + unit), objective(psi - unit), objective(psi)
        assert gradient[b] == pytest.approx((more - less) / (2 * step), abs=1e-6)
        assert curvature[b] == pytest.approx(-(more - 2 * here + less) / step**2, abs=1e-4)


def test_equal_ones_share_and_sure_ones_do_not_overflow() -> None:
    gradient, curvature = comparison_gradient(np.array([1.0, 1.0, 0.5, 1.0]), 3, np.array([1.0]))
    assert gradient == pytest.approx([0.25, 0.25, 0, -0.5]) and curvature == pytest.approx([0.125, 0.125, 0, 0.25])
    for far in (1e6, -1e6):
        assert all(np.isfinite(each).all() for each in comparison_gradient(np.array([0.0, far]), 1, np.ones(1)))


# ---------------------------------------------------------------- learning


def test_a_failed_episode_teaches_once_another_has_found_the_way() -> None:
    """Problem 2: door 2 leads on from the first room, door 1 from the second."""
    domain, experience = doors([1, 2]), Experience()
    ways, met = experience.hear(played(domain, [2, 3, 4], 2))
    assert not ways.distances and len(met) == 2 and experience.draw(5, np.random.default_rng(0)) == []
    same, again = experience.hear(played(domain, [2, 1], 2))
    assert same is ways and again[:2] == met
    assert [ways.distances[number] for number in again] == [2, 1, 0]
    first, second = (ways.comparison(number, 0.5) for number in met)
    assert first and first.actions == [("open", 2), ("open", 4)] and first.best == 1
    assert second and second.actions == [("open", 1), ("open", 3)] and second.best == 1
    doubt = 1 + 3 / ways.visits[met[0]]
    assert first.losses == pytest.approx([0.5 / doubt]) and second.losses == pytest.approx([0.75 / doubt])
    other, _ = experience.hear(played(domain, [2], 1))
    assert other is not ways and set(other.distances.values()) == {0, 1}


def test_doors_are_learned_from_failures_as_well() -> None:
    domain = doors(range(1, 10))
    *_, last = train(domain, language_bias_of(domain), Options(episodes=400, **SELF))
    assert last.policy.trees and all(each.solved for each in attempts(last.policy))


def test_a_policy_that_is_certain_of_a_wrong_action_unlearns_it() -> None:
    domain = doors([2, 3])
    bias, options = language_bias_of(domain), Options(episodes=100, **SELF)
    *_, learned = train(domain, bias, options)
    course, rng = SelfImitation(domain, bias, options), np.random.default_rng(0)
    policy = Policy(domain, bias, course.table)
    for tree in learned.policy.trees:
        policy.add(tree, -2.0, "the contrary of what is right")
    start = domain.problem(3)
    actions = domain.situation(start).actions
    right = actions.index(("open", 2))
    assert policy.scores(start, actions).probabilities[right] < 1e-3
    for _ in range(300):
        course.hear(generate_episode(policy, rng, floor=options.floor, learning=True))
        if course.gathered > options.min_examples and (grown := course.tree(policy)):
            policy.add(*grown, "")
    assert policy.scores(start, actions).probabilities[right] > 0.5
    assert all(each.solved for each in attempts(policy))


def test_two_parcels_do_not_stand_in_each_others_way() -> None:
    """Learned from one and two, other problems with two and three are done, greedy and without going round."""
    domain = open_domain(LOGISTICS)
    bias = language_bias_of(domain)
    *_, last = train(domain.with_problems(range(1, 9)), bias, options_of(bias, episodes=120, seed=0))
    policy = last.policy
    policy.domain = domain.with_problems([*range(22, 31, 2), *range(31, 51)])
    solved = [each.solved for each in attempts(policy)]
    assert sum(solved) >= 0.8 * len(solved)


NO_GOAL = """\
:- module(endless, []).
:- fluent at/1.
action(go(X)) :- member(X, [1, 2]).
effect(go(X), [at(Y)], [at(X)]) :- at(Y).
terminal :- at(9).
start([at(1)]).
horizon(3).
"""


@pytest.mark.parametrize(
    "domain, wrong",
    [
        (Path(__file__).parent / "domains" / "ferry.pl", "its actions are left to chance"),
        ("noisy_blocks", "policies do not see its states as they are"),
        (None, "it has no goal"),
    ],
)
def test_it_is_not_for_every_world(tmp_path: Path, capsys: pytest.CaptureFixture[str], domain, wrong: str) -> None:
    if domain is None:
        domain = tmp_path / "endless.pl"
        domain.write_text(NO_GOAL)
        domain.with_suffix(".yaml").write_text("action: go(+n)\ntypes: {at: [n]}\nmodes: [at(+)]\n")
    assert main(["train", str(domain), "--imitation", "self", "--output", str(tmp_path / "run")]) == 2
    said = capsys.readouterr().err
    assert wrong in said and said.count("\n") == 1 and said.startswith("self-imitation is not for the domain ")


@pytest.mark.parametrize(
    "option, value",
    [("critic", "value"), ("normalise", "yes"), ("line_search", 2), ("update", "taken"), ("unrewarded", "drop")],
)
def test_what_is_about_returns_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str], option, value) -> None:
    given = ["--imitation", "self", f"--{option.replace('_', '-')}", str(value), "--output", str(tmp_path / "run")]
    assert main(["train", str(DOORS), *given]) == 2
    said = capsys.readouterr().err
    assert said == f"self-imitation does not learn from returns: it has no use for {option} {value}\n"


NOISY = """\
:- module(noisy, []).
:- fluent at/1.
start([at(1)]).
action(go).
effect(go, [at(X)], [at(Y)]) :- at(X), random_between(0, 3, Y).
goal :- at(3).
horizon(20).
"""


def test_effects_that_draw_are_refused_once_they_show(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    domain = tmp_path / "noisy.pl"
    domain.write_text(NOISY)
    domain.with_suffix(".yaml").write_text("action: [go]\ntypes: {at: [n]}\nmodes: [at(-)]\n")
    given = ["--imitation", "self", "--evaluate-every", "0", "--output", str(tmp_path / "run")]
    assert main(["train", str(domain), *given]) == 2
    said = capsys.readouterr().err
    assert said.startswith("self-imitation is for actions that have one outcome: ") and said.count("\n") == 1


def test_a_problem_that_is_read_again_is_the_same_one() -> None:
    """Its static facts are equal, not the same object."""
    experience = Experience()
    (first, _), (again, _) = (experience.hear(played(doors([2]), [2, 1], 2)) for _ in range(2))
    assert again is first and again.visits[0] == 2


def test_starts_without_static_facts_are_learned() -> None:
    """One graph is all that is known of them: goals are in the states."""
    domain = open_domain("blocks_world", {"blocks": 3})
    *_, last = train(domain, language_bias_of(domain), Options(episodes=150, guidance=0.0, **SELF))
    assert last.policy.trees and ExactEvaluator(last.policy).evaluate(greedy=True).success > 0.9


def test_the_same_seed_gives_the_same_trees() -> None:
    domain = doors(range(1, 7))
    policies = []
    for seed in (1, 1, 2):
        *_, last = train(domain, language_bias_of(domain), Options(episodes=100, seed=seed, **SELF))
        policies.append(last.policy)
    one, same, other = policies
    assert one.trees == same.trees and len(one.trees) > 1 and one.comments == same.comments != other.comments


# ---------------------------------------------------------------- returns


def test_returns_are_the_default_and_learn_as_before(delivery, delivery_bias) -> None:
    """The loop of the paper, written down once more, grows the same trees."""
    options = Options(episodes=30, min_examples=30)
    assert (options.imitation, options.floor) == ("no", 0.0)
    assert isinstance(course_of(delivery, delivery_bias, options), Returns)
    *_, last = train(delivery, delivery_bias, options)
    learner, judge = regressor(delivery, delivery_bias, options), critic(delivery, delivery_bias, options)
    policy, rng, batch, gathered = Policy(delivery, delivery_bias, learner.table), np.random.default_rng(0), [], 0
    for _ in range(30):
        visits = judge.visits(generate_episode(policy, rng, options.guidance, learning=True))
        gathered += sum(len(visit.step.actions) for visit in visits)
        batch += visits
        if gathered > 30:
            policy.add(learner.fit(examples(kept(batch, options), options)), 1.0, "")
            batch, gathered = [], 0
    assert policy.trees == last.policy.trees and len(policy.trees) > 2
