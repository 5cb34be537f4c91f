"""Domains whose dynamics live in an environment of Gymnasium.

The domain file names the environment and its actions, so that Prolog knows them. What happens is asked of the
environment alone: Prolog hears nothing of an episode unless something is asked about one of its states.
"""

from __future__ import annotations

import copy
import math
import re
import tempfile
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.interrupts import heed_interrupt
from nppg.bridge.plain import named
from nppg.bridge.terms import Compound, plain
from nppg.errors import NppgError, Problem
from nppg.worlds import gym_values
from nppg.worlds.domain import Domain
from nppg.worlds.gym_files import bias_text, domain_text
from nppg.worlds.gym_make import Made, make, told
from nppg.worlds.state import Interpretation
from nppg.worlds.trust import HOW_TO_TRUST
from nppg.worlds.world import Action, Outcome, Situation, State

if TYPE_CHECKING:
    from gymnasium import Env, Space

_SEEDS = 2**31  # an environment's seed is drawn below this
_ENDED = Situation("terminal", [])
_TRUNCATED = "truncated"
_RESET = "observation, info"  # what the methods of an environment return
_STEP = "observation, reward, terminated, truncated, info"
_MASKS = "action_masks"  # a method that says which actions are legal, as sb3-contrib looks for it
_ELSEWHERE = "the environment is in another state: it can only go on from where it is"


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
        trust: bool | None = None,
    ):
        given = named(parameters)
        super().__init__(path, given, trust)
        if ":" in self.environment and not (made or self.trusted):
            message = f"{self.environment} names a module of Python to load{HOW_TO_TRUST}"
            raise NppgError([Problem(str(self.path), 0, 0, message)])
        self.parameters = {**given, **self.parameters}
        self.generated = made is not None  # its file, which has no place then
        self._made = made or make(self.environment, self.parameters)
        numbers = actions_of(self._made)
        self._numbers: dict[Action, int] = {Compound(("do", number)): number for number in numbers}
        self._running = Situation("running", list(self._numbers))
        self._read, self._components = _reader(self._made)
        self._masks = _method(self._made.env, _MASKS)
        self._state: State | None = None
        self._now = _ENDED
        self._check_file()

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name not in ("_read", "_masks")}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        self._made = self._made or make(self.environment, self.parameters)
        self._read, _ = _reader(self._made)
        self._masks = _method(self._made.env, _MASKS)

    def unmade(self) -> GymDomain:
        """To be pickled: without the environment, which need not be one that can be, and is made anew there."""
        other = object.__new__(type(self))
        vars(other).update(vars(self), _made=None, _state=None, _now=_ENDED)
        return other

    def __copy__(self) -> GymDomain:
        """With an environment of its own, so that it goes on from where this one is, whatever this one does."""
        return copy.deepcopy(self)

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
        self._state = None  # until all that the environment says has been understood
        try:
            observation, info = self._asked("reset", _RESET, seed=seed)
            self._now, self._state = self._legal(info), self._read(observation)
        except gym_values.Unfit as unfit:
            raise self._mistake(unfit) from None
        return self._state

    def comes_back(self) -> bool:
        """Whether a seed leads to the same start twice, as far as one shows."""
        return self.start(np.random.default_rng(0)) == self.start(np.random.default_rng(0))

    def situation(self, state: State, lean: bool = False) -> Situation:
        """`terminal` once the environment has terminated the episode, else its actions, or those that its mask allows;
        `truncated` with those that there would be, once the environment itself has cut the episode off."""
        if state is not self._state and state != self._state:
            raise self._mistake(_ELSEWHERE)
        return self._now

    def horizon(self, state: State) -> int:
        """The environment's time limit: an episode that it ends is not over, its last state is running."""
        return self._made.horizon

    def expert_actions(self, state: State) -> list[Action]:
        return super().expert_actions(state) if self.has_expert else []

    def act(self, state: State, action: Action, rng: np.random.Generator, lean: bool = False) -> tuple[float, State]:
        """Takes a step in the environment, whose randomness comes from the seed of its start."""
        if state is not self._state and state != self._state:
            raise self._mistake(_ELSEWHERE)
        if self._now.status != "running":
            raise self._mistake("the episode has ended, and no action leads on")
        try:
            number = self._numbers.get(action)
        except TypeError:  # a number that an array wraps has no hash
            number = self._numbers.get(plain([action])[0])
        if number is None:
            raise self._mistake(f"{action!r} is no action")
        self._state = None
        try:
            observation, reward, terminated, truncated, info = self._asked("step", _STEP, number)
            earned = gym_values.number("the reward", reward)
            over, cut = gym_values.flag("terminated", terminated), gym_values.flag("truncated", truncated)
            now = _ENDED if over else self._legal(info)
            self._now = now._replace(status=_TRUNCATED) if cut and not over else now
            self._state = self._read(observation)
        except gym_values.Unfit as unfit:
            raise self._mistake(unfit) from None
        return earned, self._state

    def neighbours(self, state: State) -> list[tuple[Action, list[Outcome]]]:
        raise self._mistake("the outcomes of its actions cannot be listed")

    def outcomes(self, state: State, actions: Sequence[Action]) -> list[list[Outcome]]:
        return [outcomes for _, outcomes in self.neighbours(state)]

    def certain(self, state: State, action: Action) -> State | None:
        raise self._mistake("what an action leads to is told when it is taken, not before")

    def reward(self, state: State, action: Action) -> float:
        raise self._mistake("its rewards are told when a step is taken, not afterwards")

    def _asked(self, what: str, names: str, *args: Any, **keywords: Any) -> Sequence[Any]:
        """What a method of the environment returns, which has these parts."""
        found = self._called(what, getattr(self._made.env, what), *args, **keywords)
        return gym_values.parts(f"{what} gave", found, names)

    def _called(self, what: str, method: Callable[..., Any], *args: Any, **keywords: Any) -> Any:
        try:
            return method(*args, **keywords)
        except Exception as error:  # whatever the code of an environment may raise
            raise self._mistake(f"{what} raised {told(error)}") from error

    def _legal(self, info: Any) -> Situation:
        """By the mask in `info`, else that of the environment's method. A mask that allows nothing says nothing."""
        mask, source = gym_values.told("info", info).get("action_mask"), "its action_mask"
        if mask is None and self._masks:
            mask, source = self._called(_MASKS, self._masks), f"{_MASKS} gave"
        if mask is None:
            return self._running
        allowed = gym_values.mask(source, mask, len(self._numbers))
        actions = [action for action, legal in zip(self._numbers, allowed, strict=True) if legal]
        return Situation("running", actions) if actions else self._running

    def _mistake(self, message: object) -> NppgError:
        return NppgError(f"gym:{self._made.id}: {message}")


def open_environment(id: str, parameters: Mapping[str, int | float | str] | None = None) -> GymDomain:
    """The domain of an environment, from a generated file. Raises NppgError, naming gym:ID."""
    given = named(parameters)
    made = make(id, given)
    name = re.split("[:/]", made.id)[-1]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"{name}.pl")
        path.write_text(domain_text(name, made.id, actions_of(made)), encoding="utf-8")
        domain = GymDomain(path, given, made)
    domain.path = Path(path.name)
    return domain


def actions_of(made: Made) -> range:
    """The numbers of the environment's actions. Raises NppgError where they are not Discrete."""
    from gymnasium.spaces import Discrete

    space = made.env.action_space
    if not isinstance(space, Discrete):
        message = f"its actions are {space}, but only Discrete actions can be chosen among"
        raise NppgError(f"gym:{made.id}: {message}; {_wrapper(space, 'DiscretizeAction', 'TransformAction')}")
    return range(int(space.start), int(space.start + space.n))


def _method(env: Env, name: str) -> Callable[..., Any] | None:
    """That of the outermost wrapper which has one, or of the environment within."""
    found = env.get_wrapper_attr(name) if env.has_wrapper_attr(name) else None
    return found if callable(found) else None


def _reader(made: Made) -> tuple[Callable[[Any], State], int]:
    """What makes a state of an observation, and the number of its facts."""
    from gymnasium.spaces import Box, Discrete

    space = made.env.observation_space
    if isinstance(space, Box):
        count = math.prod(space.shape)
        return _box_reader(count), count
    if isinstance(space, Discrete):
        read = _number_reader(made.env)
        return read, len(read(space.start))
    message = f"its observations are {space}, but a state is made of a Box or a Discrete one"
    raise NppgError(f"gym:{made.id}: {message}; {_wrapper(space, 'FlattenObservation', 'TransformObservation')}")


def _wrapper(space: Space, ready: str, general: str) -> str:
    """Which of Gymnasium's wrappers helps: the ready one, which flattens what has a fixed size and cuts a Box into
    parts, or the general one."""
    from gymnasium import wrappers
    from gymnasium.spaces import Box

    fits = isinstance(space, Box) if ready == "DiscretizeAction" else space.is_np_flattenable
    name = ready if fits and hasattr(wrappers, ready) else general
    return (
        f"gymnasium.wrappers.{name} makes such ones of them: register the wrapped environment under an id of your own"
    )


def _box_reader(count: int) -> Callable[[Any], State]:
    names, indices = ("obs",) * count, range(1, count + 1)

    def read(observation: Any) -> State:
        values = gym_values.numbers("an observation", observation, count)
        return Interpretation(zip(names, indices, values, strict=True))

    return read


def _number_reader(env: Env) -> Callable[[Any], State]:
    """A method `decode` of the environment that makes no whole numbers of a number has another meaning."""
    decode = getattr(env.unwrapped, "decode", None)
    if not callable(decode) or env.observation_space != env.unwrapped.observation_space:
        decode = None

    @cache
    def state(number: int) -> State:
        try:
            parts = tuple(decode(number)) if decode else (number,)
        except Exception as error:
            raise gym_values.Unfit(f"an observation {number} is nothing that decode knows: {told(error)}") from error
        return Interpretation(("obs", i, gym_values.whole("a part", part)) for i, part in enumerate(parts, 1))

    try:
        state(int(env.observation_space.start))
    except Exception:
        decode = None

    return lambda observation: state(gym_values.whole("an observation", observation))
