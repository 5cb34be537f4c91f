"""Domains whose dynamics live in an environment of Gymnasium.

The domain file names the environment and its actions, so that Prolog knows them. What happens is asked of the
environment alone: Prolog hears nothing of an episode unless something is asked about one of its states.
"""

from __future__ import annotations

import math
import re
import tempfile
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.interrupts import heed_interrupt
from nppg.errors import NppgError, Problem
from nppg.worlds.domain import Action, Domain, Interpretation, Outcome, Situation, State
from nppg.worlds.gym_files import bias_text, domain_text
from nppg.worlds.gym_make import Made, make, told

if TYPE_CHECKING:
    from gymnasium import Env

_SEEDS = 2**31  # an environment's seed is drawn below this
_ENDED = Situation("terminal", [])
_TRUNCATED = "truncated"


class GymDomain(Domain):
    """An environment of Gymnasium with Discrete actions and Box or Discrete observations.

    A state is a tuple of facts ("obs", i, x), i from 1: x is a component of the flattened Box, rounded to what a
    float32 holds; or the whole number of a Discrete observation; or one of the parts that the environment's own
    `decode` takes that number apart into. An action is ("do", k). There is one environment, in one state: `situation`
    and `act` are about that state alone. `parameters` are gymnasium.make's arguments.
    """

    def __init__(
        self,
        path: str | Path,
        parameters: Mapping[str, int | float | str] | None = None,
        made: Made | None = None,
    ):
        given = _named(parameters)
        super().__init__(path, given)
        self.parameters = {**given, **self.parameters}
        self.generated = made is not None  # its file, which has no place then
        self._made = made or make(self.environment, self.parameters)
        numbers = actions_of(self._made)
        self._numbers: dict[Action, int] = {("do", number): number for number in numbers}
        self._running = Situation("running", list(self._numbers))
        self._read, self._components = _reader(self._made)
        self._state: State | None = None
        self._now = _ENDED
        self._check_file()

    def _check_file(self) -> None:
        """Raises NppgError where the file is about other facts or actions than those of the environment."""
        if self.fluents != {("obs", 2)}:
            message = "the only fluent of an environment is obs/2: declare :- fluent obs/2"
            raise NppgError([Problem(str(self.path), 1, 0, message)])
        numbers = list(self._numbers.values())
        if super().situation(()).actions != list(self._numbers):
            what = f"do({numbers[0]}) to do({numbers[-1]})" if len(numbers) > 1 else f"do({numbers[0]})"
            message = f"action/1 has to give {what}, the actions of the environment {self._made.id}, in every state"
            raise NppgError([Problem(str(self.path), 1, 0, message)])

    def language_bias(self) -> LanguageBias:
        """A generated one, which tests the action and every component of the observation."""
        text = bias_text(self._made.id, self._numbers.values(), self._components)
        return LanguageBias.parse(text, str(self.path.with_suffix(".yaml")))

    def start(self, rng: np.random.Generator) -> State:
        """Resets the environment with a seed drawn from `rng`."""
        heed_interrupt()
        seed = int(rng.integers(_SEEDS))
        try:
            observation, info = self._made.env.reset(seed=seed)
        except Exception as error:
            raise self._failed("reset", error) from error
        self._state = self._read(observation)
        self._now = self._legal(info)
        return self._state

    def situation(self, state: State) -> Situation:
        """`terminal` once the environment has terminated the episode, else its actions, or those of its action_mask;
        `truncated` with those that there would be, once the environment itself has cut the episode off."""
        if state is not self._state and state != self._state:
            raise self._elsewhere()
        return self._now

    def horizon(self, state: State) -> int:
        """The environment's time limit: an episode that it ends is not over, its last state is running."""
        return self._made.horizon

    def expert_actions(self, state: State) -> list[Action]:
        return super().expert_actions(state) if self.has_expert else []

    def act(self, state: State, action: Action, rng: np.random.Generator) -> tuple[float, State]:
        """Takes a step in the environment, whose randomness comes from the seed of its start."""
        if state is not self._state and state != self._state:
            raise self._elsewhere()
        if self._now.status != "running":
            raise NppgError(f"gym:{self._made.id}: the episode has ended, and no action leads on")
        number = self._numbers.get(action)
        if number is None:
            raise NppgError(f"gym:{self._made.id}: {action!r} is no action")
        try:
            observation, reward, terminated, truncated, info = self._made.env.step(number)
        except Exception as error:
            raise self._failed("step", error) from error
        reward = float(reward)
        if not math.isfinite(reward):
            raise NppgError(f"gym:{self._made.id}: step gave the reward {reward}")
        self._state = self._read(observation)
        self._now = _ENDED if terminated else self._legal(info)
        if truncated and not terminated:
            self._now = self._now._replace(status=_TRUNCATED)
        return reward, self._state

    def neighbours(self, state: State) -> list[tuple[Action, list[Outcome]]]:
        raise NppgError(f"gym:{self._made.id}: the outcomes of its actions cannot be listed")

    def reward(self, state: State, action: Action) -> float:
        raise NppgError(f"gym:{self._made.id}: its rewards are told when a step is taken, not afterwards")

    def _legal(self, info: dict[str, Any]) -> Situation:
        """A mask that allows nothing says nothing."""
        mask = info.get("action_mask")
        if mask is None:
            return self._running
        allowed = np.asarray(mask).tolist()
        if len(allowed) != len(self._numbers):
            message = f"its action_mask has {len(allowed)} entries for {len(self._numbers)} actions"
            raise NppgError(f"gym:{self._made.id}: {message}")
        actions = [action for action, legal in zip(self._numbers, allowed, strict=True) if legal]
        return Situation("running", actions) if actions else self._running

    def _elsewhere(self) -> NppgError:
        message = "the environment is in another state: it can only go on from where it is"
        return NppgError(f"gym:{self._made.id}: {message}")

    def _failed(self, what: str, error: Exception) -> NppgError:
        return NppgError(f"gym:{self._made.id}: {what} raised {told(error)}")


def open_environment(id: str, parameters: Mapping[str, int | float | str] | None = None) -> GymDomain:
    """The domain of an environment, from a generated file. Raises NppgError, naming gym:ID."""
    given = _named(parameters)
    made = make(id, given)
    name = re.split("[:/]", made.id)[-1]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"{name}.pl")
        path.write_text(domain_text(name, made.id, actions_of(made)), encoding="utf-8")
        domain = GymDomain(path, given, made)
    domain.path = Path(path.name)
    return domain


def _named(parameters: Mapping[str, int | float | str] | None) -> dict[str, int | float | str]:
    """Parameters as Prolog has them: true and false are names."""
    return {
        name: str(value).lower() if isinstance(value, bool) else value for name, value in (parameters or {}).items()
    }


def actions_of(made: Made) -> range:
    """The numbers of the environment's actions. Raises NppgError where they are not Discrete."""
    from gymnasium.spaces import Discrete

    space = made.env.action_space
    if not isinstance(space, Discrete):
        raise NppgError(f"gym:{made.id}: its actions are {space}, but only Discrete actions can be chosen among")
    return range(int(space.start), int(space.start + space.n))


def _reader(made: Made) -> tuple[Callable[[Any], State], int]:
    """What makes a state of an observation, and the number of its facts."""
    from gymnasium.spaces import Box, Discrete

    space = made.env.observation_space
    if isinstance(space, Box):
        count = math.prod(space.shape)
        return _box_reader(made.id, count), count
    if isinstance(space, Discrete):
        read = _number_reader(made.env)
        return read, len(read(space.start))
    raise NppgError(f"gym:{made.id}: its observations are {space}, but a state is made of a Box or a Discrete one")


def _box_reader(id: str, count: int) -> Callable[[Any], State]:
    names, indices = ("obs",) * count, range(1, count + 1)

    def read(observation: Any) -> State:
        try:
            values = np.asarray(observation, np.float32).reshape(count).tolist()
        except (TypeError, ValueError) as error:
            raise NppgError(f"gym:{id}: an observation is no array of {count} numbers: {told(error)}") from None
        if not math.isfinite(sum(values)):
            raise NppgError(f"gym:{id}: an observation has numbers that are not finite: {values}")
        return Interpretation(zip(names, indices, values, strict=True))

    return read


def _number_reader(env: Env) -> Callable[[Any], State]:
    decode = getattr(env.unwrapped, "decode", None)
    if not callable(decode) or env.observation_space != env.unwrapped.observation_space:
        decode = None

    @cache
    def state(number: int) -> State:
        parts = decode(number) if decode else (number,)
        return Interpretation(("obs", i, int(part)) for i, part in enumerate(parts, 1))

    return lambda observation: state(int(observation))
