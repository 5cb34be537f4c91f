"""Domains as Gymnasium environments, whose observation is the state itself."""

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from nppg.bridge.plain import alone
from nppg.bridge.terms import texts
from nppg.errors import NppgError, Problem
from nppg.learning.episode import IDLE, longest
from nppg.learning.options import Options
from nppg.worlds.gym_values import Unfit, whole
from nppg.worlds.opening import open_domain
from nppg.worlds.world import Action, State

try:
    import gymnasium
    from gymnasium import spaces
    from gymnasium.vector.utils import batch_space
except ImportError:
    raise NppgError("an environment of Gymnasium needs gymnasium: pip install 'nppg[gym]'") from None

_CONSTANTS = 10  # names that a sampled fact may hold
_SAMPLED = 10  # facts of a sampled observation, at most


class Facts(spaces.Space):
    """Sets of facts of the given fluents: tuples of different texts, as Prolog writes them: `on(a, b)`.

    A sample is made of the names c0, c1, ...; it need not be a state of the domain."""

    def __init__(self, fluents: Iterable[tuple[str, int]], seed: int | np.random.Generator | None = None):
        arities = sorted(fluents)
        self.fluents = tuple(zip(texts([name for name, _ in arities]), [arity for _, arity in arities], strict=True))
        super().__init__(dtype=str, seed=seed)

    def sample(self, mask: Any = None, probability: Any = None) -> tuple[str, ...]:
        drawn = {self._fact(*self.fluents[self.np_random.integers(len(self.fluents))]) for _ in range(_SAMPLED)}
        return tuple(sorted(drawn))

    def _fact(self, name: str, arity: int) -> str:
        names = ", ".join(f"c{each}" for each in self.np_random.integers(_CONSTANTS, size=arity))
        return f"{name}({names})" if arity else name

    def contains(self, x: Any) -> bool:
        return isinstance(x, tuple) and len(set(x)) == len(x) and all(map(self._is_fact, x))

    def _is_fact(self, x: Any) -> bool:
        return isinstance(x, str) and any(
            x.startswith(f"{name}(") and x.endswith(")") if arity else x == name for name, arity in self.fluents
        )

    @property
    def is_np_flattenable(self) -> bool:
        return False

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Facts) and self.fluents == other.fluents

    def __repr__(self) -> str:
        return f"Facts({', '.join(f'{name}/{arity}' for name, arity in self.fluents)})"


class Choice(spaces.Space):
    """The numbers of the legal actions, of which there are `count` at present; a sample is one of them. Every other
    number from 0 is contained too, because how many are legal changes from state to state. The spaces of a batch follow
    that of the environment which they are made from; as long as that has not acted in this process, a sample is below
    `GUESSED`."""

    GUESSED = 10

    def __init__(self, seed: int | np.random.Generator | None = None, follows: Choice | None = None):
        self.count = 0
        self._follows = follows
        super().__init__(shape=(), dtype=np.int64, seed=seed)

    def sample(self, mask: Any = None, probability: Any = None) -> np.int64:
        return self.np_random.integers((self._follows or self).count or self.GUESSED)

    def contains(self, x: Any) -> bool:
        if isinstance(x, np.ndarray) and x.shape == ():
            x = x.item()
        return isinstance(x, (int, np.integer)) and bool(x >= 0)

    @property
    def is_np_flattenable(self) -> bool:
        return False

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Choice)

    def __repr__(self) -> str:
        return "Choice()"


@batch_space.register(Choice)
def _batch(space: Choice, n: int = 1) -> spaces.Tuple:
    """As Gymnasium does for spaces that it does not know, but that copies know how many actions there are."""
    batch = spaces.Tuple([Choice(follows=space) for _ in range(n)])
    batch.seed(copy.deepcopy(space.np_random).integers(10**8, size=n).tolist())
    return batch


class DomainEnv(gymnasium.Env):
    """A domain; the observation is its state, the facts' texts in Prolog's standard order, or what the domain's
    observation/1 shows of it.

    `info["actions"]` has the legal actions, none once the episode has terminated, and `info["action_texts"]` how
    Prolog writes them; step(i) takes the i-th. A number that none of them has changes nothing, is rewarded by 0, counts
    as a step, and is told by `info["legal"]`. An episode terminates in a goal state (`info["is_success"]`) or a
    terminal state, and is truncated after horizon_factor times the domain's horizon, or where a domain that is an
    environment of Gymnasium itself truncates it. Raises NppgError for mistakes in
    the domain file, the parameters and the other arguments.
    """

    metadata = {"render_modes": ["ansi"], "render_fps": 4}  # noqa: RUF012  Gymnasium's way

    def __init__(
        self,
        domain: str | Path,
        parameters: Mapping[str, int | float | str] | None = None,
        horizon_factor: float = 1.0,
        render_mode: str | None = None,
    ):
        if render_mode not in (None, "ansi"):
            raise NppgError(f"render_mode must be 'ansi' or None, not {render_mode!r}")
        self.render_mode = render_mode
        self.horizon_factor = Options(horizon_factor=horizon_factor).horizon_factor
        self.domain = open_domain(domain, parameters)
        self.state: State = ()
        self.actions: Sequence[Action] = []
        self._status = ""
        self._steps = self._limit = 0
        self.observation_space: spaces.Space = Facts(self.domain.fluents | self.domain.static)
        self.action_space: spaces.Space = Choice()

    def __copy__(self) -> DomainEnv:
        """All of it, so that neither draws from the other's generator or acts in the other's environment."""
        return copy.deepcopy(self)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Draws a start state that leaves something to do. No options are known."""
        super().reset(seed=alone(seed))
        for _ in range(IDLE):
            self.state = self.domain.start(self.np_random)
            self._limit = longest(self.domain.horizon(self.state), self.horizon_factor)
            self._look()
            if self._status == "running" and self._limit > 0:
                self._steps = 0
                return self._observed()
        message = f"{IDLE} starts in a row were goal or terminal states, or had the horizon 0"
        raise NppgError([Problem(str(self.domain.path), 0, 0, message)])

    def step(self, action: int) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        if not self._limit:
            raise gymnasium.error.ResetNeeded("call reset() before step()")
        try:
            action = whole("the action", action)
        except Unfit as unfit:
            raise NppgError(str(unfit)) from None
        legal = self._status == "running" and 0 <= action < len(self.actions)
        reward = 0.0
        if legal:
            reward, self.state = self.domain.act(self.state, self.actions[action], self.np_random)
            self._look()
        self._steps += 1
        terminated = self._status in ("goal", "terminal")
        observation, info = self._observed()
        truncated = not terminated and (self._status == "truncated" or self._steps >= self._limit)
        return observation, float(reward), terminated, truncated, {**info, "legal": legal}

    def render(self) -> str | None:
        """The domain's picture of the state."""
        return None if self.render_mode is None else "\n".join(self.domain.picture(self.state))

    def _look(self) -> None:
        self._status, self.actions = self.domain.situation(self.state)

    def _observed(self) -> tuple[Any, dict[str, Any]]:
        """The observation and its info."""
        self.action_space.count = len(self.actions)
        seen = self._seen()
        written = texts([*seen, *self.actions])
        facts = len(seen)
        return tuple(written[:facts]), {**self._info(), "action_texts": written[facts:]}

    def _seen(self) -> State:
        """With the static facts in front."""
        seen = self.domain.observe(self.state, self.np_random)
        static = self.domain.interpreted(seen).static.facts
        return (*static, *seen) if static else seen

    def _info(self) -> dict[str, Any]:
        return {"actions": list(self.actions), "is_success": self._status == "goal"}
