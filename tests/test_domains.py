"""What every domain file must do. `conforms` is for any domain: to try your own,
NPPG_DOMAIN=path/to/file.pl pytest tests/test_domains.py -k yours"""

from __future__ import annotations

import math
import os
from pathlib import Path

import numpy as np
import pytest

from nppg import Domain, LanguageBias, NppgError, Options, generate_episode, train
from nppg.answers.check import check
from nppg.bridge.prolog import ask
from nppg.policy.policy import Policy
from nppg.worlds.world import Action, Outcome, State

ROOT = Path(__file__).parent.parent
FILES = sorted([*(ROOT / "domains").glob("*.pl"), *(ROOT / "tests" / "domains").glob("*.pl")])


def bias_of(path: Path) -> Path | None:
    """The language bias of the same name: beside the domain, or among the shipped ones."""
    beside = (path.with_suffix(".yaml"), path.parent.parent / "language_bias" / f"{path.stem}.yaml")
    return next((each for each in beside if each.is_file()), None)


def conforms(path: Path, starts: int = 20, steps: int = 15, seed: int = 0) -> None:
    """Plays random episodes and holds each state against the contract."""
    domain, rng = Domain(path), np.random.default_rng(seed)
    for _ in range(starts):
        state = domain.start(rng)
        horizon = domain.horizon(state)
        assert isinstance(horizon, int) and horizon >= 0
        for _ in range(min(horizon, steps)):
            follow = holds(domain, state)
            if follow is None:
                break
            action, states = follow
            reward, successor = domain.act(state, action, rng)
            assert math.isfinite(reward)
            if states is None:
                same = (domain.act(state, action, np.random.default_rng(seed)) for _ in range(2))
                assert next(same) == next(same), "what an effect draws follows the seed"
            else:
                assert successor in states, "what act leads to is one of the outcomes"
            state = successor
            watched(domain, state, seed)
    assert [domain.start(np.random.default_rng(seed + i)) for i in range(5)] == [
        Domain(path).start(np.random.default_rng(seed + i)) for i in range(5)
    ], "the same seed gives the same start"


def holds(domain: Domain, state: State) -> tuple | None:
    """Checks one state; an action to go on with, and the states that it may lead to, None where effects draw them."""
    assert len(set(state)) == len(state), "facts are distinct"
    assert indicators(state) <= domain.fluents
    status, actions = domain.situation(state)
    assert ask("intact", domain.module) == "true", "queries leave the state alone"
    if status != "running":
        assert actions == []
        return None
    assert actions and len(set(actions)) == len(actions)
    assert domain.situation(state).actions == actions, "the order of actions is a function of the state"
    assert set(domain.expert_actions(state)) <= set(actions), "the expert's actions are legal"
    assert all(isinstance(line, str) for line in domain.picture(state))
    assert all(isinstance(part, tuple) for part in domain.parts(state))
    action = actions[len(actions) // 2]
    neighbours = listed(domain, state)
    if neighbours is None:
        return action, None
    assert list(neighbours) == actions, "every legal action has effects"
    for outcomes in neighbours.values():
        assert math.isclose(sum(outcome.probability for outcome in outcomes), 1)
    assert ask("intact", domain.module) == "true", "looking ahead leaves the state alone"
    return action, [outcome.state for outcome in neighbours[action]]


def watched(domain: Domain, state: State, seed: int) -> None:
    """Checks what is seen of one state."""
    seen, again = (domain.observe(state, np.random.default_rng(seed)) for _ in range(2))
    assert seen == again, "what is seen follows the seed"
    assert ask("intact", domain.module) == "true", "looking leaves the state alone"
    assert indicators(seen) <= domain.fluents and len(set(seen)) == len(seen)
    assert domain.has_observation or seen is state


def indicators(state: State) -> set[tuple]:
    return {(fact[0], len(fact) - 1) if isinstance(fact, tuple) else (fact, 0) for fact in state}


def listed(domain: Domain, state: State) -> dict[Action, list[Outcome]] | None:
    """The outcomes of all actions, None where effects draw: only a domain that promises no finite space may."""
    try:
        return dict(domain.neighbours(state))
    except NppgError as error:
        assert "drew a random number, so what may come of an action cannot be listed" in str(error)
        assert not domain.uniform_start
        return None


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_situation_that_an_action_brings_along_is_the_one_that_is_asked_for(path: Path) -> None:
    """Also after other states, and in whatever order the two are asked."""
    domain, plain, rng = Domain(path), Domain(path), np.random.default_rng(0)
    for _ in range(20):
        state = domain.start(rng)
        status, actions = domain.situation(state)
        for _ in range(10):
            if status != "running":
                break
            _, following = domain.act(state, actions[int(rng.random() * len(actions))], rng)
            if rng.random() < 0.2:
                assert domain.situation(state) == (status, actions)
            state = following
            plain.forget()
            status, actions = domain.situation(state)
            assert (status, actions) == plain.situation(state) == domain.situation(state)
            domain.situation(state).actions.clear()  # what callers do to their list is their business
            assert domain.situation(state).actions == actions


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_conforms(path: Path) -> None:
    conforms(path)


@pytest.mark.skipif("NPPG_DOMAIN" not in os.environ, reason="NPPG_DOMAIN names no file")
def test_yours() -> None:
    conforms(Path(os.environ["NPPG_DOMAIN"]))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_bias(path: Path) -> None:
    """The bias of the same name fits, and an expert's episode stays within the horizon."""
    file = bias_of(path)
    assert file, "every domain has a language bias"
    domain, bias = Domain(path), LanguageBias.load(file)
    assert bias.check(domain.predicates, domain.actions) == []
    rng = np.random.default_rng(0)
    episode = generate_episode(Policy(domain, bias), rng, guidance=1.0)
    assert len(episode.steps) <= domain.horizon(episode.steps[0].actual if episode.steps else episode.actual)
    *_, last = train(domain, bias, Options(episodes=10, min_examples=20))
    assert last.episodes == 10


def test_ferry() -> None:
    """Probabilities, a numeric fluent, rewards and a terminal test, by hand."""
    ferry = Domain(ROOT / "tests" / "domains" / "ferry.pl", {"cars": 1})
    start = ferry.start(np.random.default_rng(0))
    assert start == (("boat", "left"), ("fuel", 2), ("car", "c1", "left"))
    assert ferry.situation(start) == ("running", ["cross", ("carry", "c1")])
    over = (("boat", "right"), ("fuel", 1), ("car", "c1", "right"))
    stuck = (("boat", "left"), ("fuel", 1), ("car", "c1", "left"))
    assert dict(ferry.neighbours(start))[("carry", "c1")] == [(0.75, over), (0.25, stuck)]
    rng = np.random.default_rng(0)
    rewards = [ferry.act(start, ("carry", "c1"), rng) for _ in range(2000)]
    assert set(rewards) == {(10, over), (-1, stuck)}
    assert abs(rewards.count((10, over)) / 2000 - 0.75) < 0.04
    assert ferry.situation(over).status == "goal"
    assert ferry.situation((("boat", "left"), ("fuel", 0), ("car", "c1", "left"))).status == "terminal"


def test_parts(four_blocks: Domain, delivery: Domain) -> None:
    """Towers from the floor up where the domain says so, else the facts; and what the goal is about."""
    state: State = (("goal_on", "b2", "b1"), ("on", "b1", "floor"), ("on", "b2", "floor"), ("on", "b3", "b1"))
    before: State = (("on", "b1", "b2"), ("on", "b2", "floor"), ("on", "b3", "b1"))
    assert four_blocks.parts(before) == (("b2", "b1", "b3"),)
    assert four_blocks.has_parts and four_blocks.parts(state) == (("b1", "b3"), ("b2",))
    assert four_blocks.binding(state, "goal_on", 2) == ("b2", "b1")
    assert not delivery.has_parts and delivery.parts(("idle", ("at", "room1"))) == (("idle",), ("at", "room1"))


def test_neighbours_are_what_acting_leads_to_in_whatever_order_the_facts_come(four_blocks: Domain) -> None:
    rng = np.random.default_rng(0)
    for state in [four_blocks.start(rng) for _ in range(20)]:
        neighbours = four_blocks.neighbours(state)
        assert four_blocks.neighbours(state[::-1]) == neighbours
        for action, outcomes in neighbours:
            assert outcomes == [(1, four_blocks.act(state, action, rng)[1])]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_nothing_is_wrong_with_it(path: Path) -> None:
    """Also with the shipped language biases that are variants of its own."""
    file = bias_of(path)
    assert file
    variants = [] if path.stem == "blocks_world" else sorted(file.parent.glob(f"{path.stem}_*.yaml"))
    for each in (file, *variants):
        problems, summary = check(lambda: Domain(path), lambda _, each=each: LanguageBias.load(each))
        assert problems == [] and "no mistakes" in summary


def test_grid() -> None:
    """Walls hold, a step goes astray to its sides, and all cells but the goal and the pit are starts."""
    grid = Domain("grid", {"slip": 0.2})
    corner = (("x", 1), ("y", 1))
    outcomes = {
        name: sorted((round(p, 9), state[0][1], state[1][1]) for p, state in found)
        for name, found in grid.neighbours(corner)
    }
    assert outcomes["east"] == [(0.1, 1, 1), (0.1, 1, 2), (0.8, 2, 1)]
    assert outcomes["north"] == [(0.1, 1, 1), (0.1, 2, 1), (0.8, 1, 2)]
    beside_the_wall = dict(grid.neighbours((("x", 4), ("y", 3))))["east"]
    assert max(beside_the_wall) == (0.8, (("x", 4), ("y", 3)))
    assert grid.situation((("x", 9), ("y", 6))).status == "goal"
    assert grid.situation((("x", 9), ("y", 5))).status == "terminal"
    assert grid.reward((("x", 9), ("y", 5)), "east") == -1
    rng = np.random.default_rng(0)
    assert len({grid.start(rng) for _ in range(1000)}) == 9 * 6 - 5 - 2
    sure = Domain("grid", {"slip": 0.0})
    assert all(len(found) == 1 for _, found in sure.neighbours(corner))
    with pytest.raises(NppgError, match="start/1 failed"):
        Domain("grid", {"width": 3}).start(rng)


def values(state: State, name: str) -> list[tuple]:
    return [fact[1:] for fact in state if fact[0] == name]


def test_the_rover_keeps_its_limits() -> None:
    """Under random actions the load limit and the battery hold, rocks get neither lost nor doubled, and whoever has no
    energy left is stranded."""
    rover, rng, stranded, loads = Domain("rover"), np.random.default_rng(0), 0, []
    limit, capacity = rover.parameters["load_limit"], rover.parameters["capacity"]
    for _ in range(100):
        state = rover.start(rng)
        weights = dict(values(state, "weight"))
        assert 2 <= len(weights) <= rover.parameters["rocks"] and values(state, "wanted")
        status, actions = rover.situation(state)
        while status == "running":
            reward, state = rover.act(state, actions[int(rng.random() * len(actions))], rng)
            carried = [rock for (rock,) in values(state, "carried")]
            loads.append(sum(weights[rock] for rock in carried))
            assert loads[-1] <= limit
            assert sorted([rock for rock, _ in values(state, "in")] + carried) == sorted(weights)
            ((energy,),) = values(state, "battery")
            assert 0 <= energy <= capacity
            status, actions = rover.situation(state)
            assert (energy == 0) == (status == "terminal") == (reward < -1)
        stranded += status == "terminal"
    assert 50 < stranded <= 100 and max(loads) > limit / 2


@pytest.mark.parametrize("capacity", [15.1, 16.0, 30.0])
def test_the_rover_s_expert_brings_every_wanted_rock(capacity: float) -> None:
    rover, rng = Domain("rover", {"capacity": capacity}), np.random.default_rng(1)
    policy = Policy(rover, LanguageBias.load(ROOT / "language_bias" / "rover.yaml"))
    for _ in range(60):
        episode = generate_episode(policy, rng, guidance=1.0)
        assert episode.success
        wanted = [rock for (rock,) in values(episode.last, "wanted")]
        assert {(rock, "base") for rock in wanted} <= set(values(episode.last, "in"))
        rewards = sum(step.reward for step in episode.steps)
        charges = sum(step.actions[step.chosen] == "charge" for step in episode.steps)
        assert rewards == pytest.approx(len(wanted) - 0.02 * (len(episode.steps) - charges) - 0.25 * charges)


def test_what_the_rover_s_ways_cost() -> None:
    """By hand: half a load costs half as much as the way itself, a full one as much."""
    rover, rng = Domain("rover"), np.random.default_rng(0)
    facts = (
        ("at", "base"),
        ("carried", "rock2"),
        ("wanted", "rock1"),
        ("in", "rock1", "site1"),
        *(("place", name, x) for name, x in (("base", 0.0), ("charger", 5.0), ("site1", 7.0))),
        ("weight", "rock1", 3.0),
        ("weight", "rock2", 3.0),
    )
    state = (("battery", 16.0), *facts)
    assert rover.binding(state, "fetching", 2) == ("rock1", 16 - 7 * 1.5 - 2 * 2)
    there = rover.act(state, ("go", "site1"), rng)[1]
    assert values(there, "battery") == [(16 - 7 * 1.5,)]
    assert ("pick", "rock1") in rover.situation(there).actions, "it fits exactly"
    lost = rover.act((("battery", 10.0), *facts), ("go", "site1"), rng)
    assert lost[0] == -1.02 and values(lost[1], "at") == [] and values(lost[1], "battery") == [(0.0,)]
    heavier = tuple(("weight", "rock1", 3.1) if fact[:2] == ("weight", "rock1") else fact for fact in there)
    assert ("pick", "rock1") not in rover.situation(heavier).actions


def test_states_and_actions_are_written_and_read_as_prolog() -> None:
    domain = Domain("blocks_world", {"blocks": 3})
    state = domain.state("on(b1,b2), on(b2,floor), goal_on(b2,b1).")
    assert state == (("goal_on", "b2", "b1"), ("on", "b1", "b2"), ("on", "b2", "floor"))
    assert str(state) == "goal_on(b2, b1), on(b1, b2), on(b2, floor)"
    assert [*map(str, domain.situation(state).actions)] == ["move(b1, floor)"]
    drawn = domain.start(np.random.default_rng(1))
    assert domain.state(str(drawn)) == drawn
    following = domain.act(drawn, domain.situation(drawn).actions[0], np.random.default_rng(1))[1]
    assert domain.state(str(following)) == following


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("onn(b1, b2)", r"^onn\(b1, ?b2\) is no fact of a declared fluent \(did you mean 'on/2'\?\)$"),
        ("on(b1, X)", r"^on\(b1, ?_\) is no fact \(it has an unbound variable\)$"),
        ("on(b1", r"^a state is a list of facts, like .*on\(b1'$"),
        ("on(b1, b2)|More", r"^a state is a list of facts, like .*no_list in 'on\(b1, b2\)\|More'$"),
        ("3", r"^3 is no fact of a declared fluent$"),
        ('on(b1, "x")', r"^on\(b1, ?\"x\"\) is no fact \(only names"),
    ],
)
def test_a_text_that_is_no_state_is_refused(text: str, message: str) -> None:
    with pytest.raises(NppgError, match=message):
        Domain("blocks_world").state(text)


def test_two_hundred_blocks_start() -> None:
    assert len(Domain("blocks_world", {"blocks": 200}).start(np.random.default_rng(1))) == 201
