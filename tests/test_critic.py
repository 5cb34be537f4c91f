"""The value function finds the true values, and advantages are those of their definition."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.files import locate
from nppg.learning.critic import STATE, MonteCarlo, ValueFunction, critic
from nppg.learning.episode import Episode, Step, generate_episode
from nppg.learning.gradient import returns
from nppg.learning.options import Options
from nppg.learning.visits import Visit
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain

OPTIONS = Options(critic="value", discount=0.9, trace=0.0, cut_off="bootstrap", critic_step_size=1.0)


def step(domain: Domain, cell: int, chosen: int) -> tuple[Step, tuple]:
    state, rng = (("cell", cell),), np.random.default_rng(0)
    actions = domain.situation(state).actions
    reward, following = domain.act(state, actions[chosen], rng)
    return Step(state, actions, np.zeros((2, 0), bool), np.zeros(2), np.full(2, 0.5), chosen, reward, state), following


def transitions(domain: Domain) -> list[Episode]:
    """Every step of the chain once, as an episode that is cut off behind it."""
    found = []
    for cell in (1, 2, 3):
        for chosen in (0, 1):
            taken, last = step(domain, cell, chosen)
            found.append(Episode((taken,), last, domain.situation(last).actions, False, last))
    return found


def true_values(discount: float) -> np.ndarray:
    """Of the uniform policy in the cells 1 to 3, from its linear equations."""
    moves = np.array([[0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.0]])
    rewards = np.array([-0.1, -0.1, 0.5 * -0.1 + 0.5 * 1.0])
    return np.linalg.solve(np.eye(3) - discount * moves, rewards)


CELLS = [(("cell", cell),) for cell in (1, 2, 3)]


@pytest.mark.parametrize("regressor", ["tilde", "cart"])
@pytest.mark.parametrize("changes", [{}, {"critic_step_size": 0.4, "critic_trees": 3}])
def test_values_are_the_true_ones(chain, regressor: str, changes: dict) -> None:
    """With every transition as often as the policy takes it, learning is value iteration."""
    if regressor == "cart":
        pytest.importorskip("sklearn")
    domain, bias = chain
    values = ValueFunction(domain, bias, replace(OPTIONS, regressor=regressor, **changes))
    for _ in range(150):
        values.learn([visit for episode in transitions(domain) for visit in values.visits(episode)])
    assert values(CELLS) == pytest.approx(true_values(0.9), abs=1e-4)
    assert len(values.trees.trees) == 150 * values.options.critic_trees
    for state, value in zip(CELLS, values(CELLS).tolist(), strict=True):
        assert values.trees.prolog_potentials(state, [STATE]).tolist() == [value]


@pytest.mark.parametrize("trace", [0.0, 0.7, 1.0])
def test_values_come_near_the_true_ones_from_episodes(chain, trace: float) -> None:
    domain, bias = chain
    policy, rng = Policy(domain, bias), np.random.default_rng(0)
    values = ValueFunction(domain, bias, replace(OPTIONS, trace=trace, critic_step_size=0.3))
    for _ in range(25):
        values.learn([visit for _ in range(30) for visit in values.visits(generate_episode(policy, rng))])
    assert values(CELLS) == pytest.approx(true_values(0.9), abs=0.12)


def learned(domain: Domain, bias: LanguageBias, options: Options) -> ValueFunction:
    values = ValueFunction(domain, bias, options)
    for _ in range(3):
        values.learn([visit for episode in transitions(domain) for visit in values.visits(episode)])
    return values


@pytest.mark.parametrize(("ends", "cut_off"), [(True, "bootstrap"), (False, "bootstrap"), (False, "end")])
@pytest.mark.parametrize("trace", [1.0, 0.0, 0.6])
def test_advantages_are_those_of_their_definition(chain, trace: float, ends: bool, cut_off: str) -> None:
    """Of an episode that ends in the last cell, and of one that its horizon cuts off before it."""
    domain, bias = chain
    values = learned(domain, bias, replace(OPTIONS, trace=trace))
    values.options = replace(values.options, cut_off=cut_off)
    moves = [(1, 1), (2, 0), (1, 1), (2, 1), *([(3, 1)] if ends else [])]
    steps, last = [], None
    for cell, chosen in moves:
        taken, last = step(domain, cell, chosen)
        steps.append(taken)
    assert last is not None and (last == (("cell", 4),)) == ends
    open_actions = domain.situation(last).actions
    assert bool(open_actions) != ends
    found = values.visits(Episode(tuple(steps), last, open_actions, False, last))
    v = [*values([each.state for each in steps]).tolist(), values([last]).item()]
    assert len({round(each, 6) for each in v}) >= 3
    v[-1] *= not ends and cut_off == "bootstrap"
    rewards = [each.reward for each in steps]
    for t, visit in enumerate(found):
        rest = range(t, len(steps))
        if trace == 1.0:
            expected = sum(0.9 ** (k - t) * rewards[k] for k in rest) + 0.9 ** (len(steps) - t) * v[-1] - v[t]
        elif trace == 0.0:
            expected = rewards[t] + 0.9 * v[t + 1] - v[t]
        else:
            expected = sum((0.9 * trace) ** (k - t) * (rewards[k] + 0.9 * v[k + 1] - v[k]) for k in rest)
        assert visit.value == pytest.approx(expected, abs=1e-12) and visit.step is steps[t]


def test_without_a_critic_values_are_returns(four_blocks: Domain, plain_bias) -> None:
    policy, rng = Policy(four_blocks, plain_bias), np.random.default_rng(0)
    judge = critic(four_blocks, plain_bias, Options(discount=0.5))
    assert isinstance(judge, MonteCarlo)
    guided = 0
    for _ in range(30):
        episode = generate_episode(policy, rng, guidance=0.3)
        expected = returns([each.reward for each in episode.steps], 0.5).tolist()
        assert judge.visits(episode) == [
            Visit(each, value, episode.guided) for each, value in zip(episode.steps, expected, strict=True)
        ]
        guided += episode.guided
    assert 0 < guided < 30


def test_the_expert_does_not_count(four_blocks: Domain, plain_bias, chain) -> None:
    """The value function is the policy's; where a domain has no expert, no step is an expert's."""
    values = critic(four_blocks, plain_bias, OPTIONS)
    assert isinstance(values, ValueFunction)
    policy, rng = Policy(four_blocks, plain_bias), np.random.default_rng(0)
    guided, own = (
        [visit for _ in range(20) for visit in values.visits(generate_episode(policy, rng, guidance))]
        for guidance in (1.0, 0.0)
    )
    assert all(each.guided for each in guided) and not any(each.guided for each in own)
    values.learn(guided)
    assert not values.trees.trees
    values.learn([*own, *guided])
    alone = ValueFunction(four_blocks, plain_bias, OPTIONS)
    alone.learn(own)
    assert alone.trees.trees == values.trees.trees and len(alone.trees.trees) == 1
    domain, bias = chain
    episode = generate_episode(Policy(domain, bias), rng, guidance=1.0)
    assert not episode.guided and not any(each.guided for each in ValueFunction(domain, bias, OPTIONS).visits(episode))


def test_an_expert_without_advice_leaves_the_policys_own_steps(tmp_path, plain_bias) -> None:
    """What follows the expert's last action is the policy's; what leads there has the expert's value."""
    shipped = locate("blocks_world", "domains", ".pl").read_text()
    (tmp_path / "hesitant.pl").write_text(
        shipped.replace("module(blocks_world,", "module(hesitant,").replace(
            "optimal(Task, Move).", "towers(T), 0 is T mod 2, optimal(Task, Move).", 1
        )
    )
    domain = Domain(tmp_path / "hesitant.pl", {"blocks": 5})
    policy, rng = Policy(domain, plain_bias), np.random.default_rng(0)
    values, returned = ValueFunction(domain, plain_bias, OPTIONS), critic(domain, plain_bias, Options())
    kinds = set()
    for _ in range(60):
        episode = generate_episode(policy, rng, guidance=1.0, horizon_factor=2.0)
        advised = [bool(domain.expert_actions(step.actual)) for step in episode.steps]
        assert [step.guided for step in episode.steps] == advised and episode.guided == any(advised)
        expected = [any(advised[t:]) for t in range(len(advised))]
        assert [visit.guided for visit in values.visits(episode)] == expected
        assert [visit.guided for visit in returned.visits(episode)] == expected
        kinds.add((episode.guided, all(expected)))
        own = generate_episode(policy, rng, guidance=0.0)
        assert not any(step.guided for step in own.steps)
    assert kinds == {(False, False), (True, False), (True, True)}


def test_its_trees_are_about_states(four_blocks: Domain, relational_bias) -> None:
    """Relational ones: the goal's objects and new variables, and no argument of an action."""
    values = ValueFunction(four_blocks, relational_bias, replace(OPTIONS, trace=1.0))
    policy, rng = Policy(four_blocks, relational_bias), np.random.default_rng(1)
    for _ in range(4):
        values.learn([visit for _ in range(40) for visit in values.visits(generate_episode(policy, rng))])
    rules = [rule for tree in range(1, 5) for rule in values.trees.rules(tree)]
    assert len(rules) > 8 and any("goal_on(" in rule and "above(" in rule for rule in rules)
    assert all(
        rule.startswith(("delta(1, state,", "delta(2, state,", "delta(3, state,", "delta(4, state,")) for rule in rules
    )


def test_a_bias_that_says_nothing_about_states_gives_a_constant(four_blocks: Domain, bias_of) -> None:
    bias = bias_of("action: move(+block, +place)\nsubtypes: {block: place}\ntypes: {clear: [place]}\nmodes: [clear(+)]")
    values = ValueFunction(four_blocks, bias, OPTIONS)
    policy, rng = Policy(four_blocks, bias), np.random.default_rng(0)
    visits = [visit for _ in range(20) for visit in values.visits(generate_episode(policy, rng))]
    values.learn(visits)
    mean = np.mean([visit.value for visit in visits])
    assert mean > 0
    assert values([visits[0].step.state, visits[-1].step.state]) == pytest.approx([mean, mean])
