"""Makes environments of Gymnasium, without a time limit of their own: the horizon is nppg's to keep."""

from __future__ import annotations

import inspect
import re
import warnings
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from nppg.errors import NppgError, suggestion

if TYPE_CHECKING:
    from gymnasium import Env

_HORIZON = 1000  # of an environment that is registered without a time limit
_COLOUR = re.compile(r"\x1b\[[0-9;]*m")
_TRUTH = {"true": True, "false": False}


@dataclass(frozen=True, slots=True)
class Made:
    """An environment with its full id, version included, and the number of steps that an episode may have."""

    id: str
    env: Env
    horizon: int

    def __deepcopy__(self, memo: dict) -> Made:
        """Raises NppgError where the environment cannot be copied."""
        try:
            return replace(self, env=deepcopy(self.env, memo))
        except Exception as error:  # whatever the code of an environment may raise
            raise NppgError(f"gym:{self.id}: it cannot be copied: {told(error)}") from error


def make(id: str, parameters: Mapping[str, int | float | str]) -> Made:
    """`parameters` are gymnasium.make's arguments, where the names true and false mean what they say. Raises NppgError
    where Gymnasium is missing, does not know the id or refuses the arguments; warns of what Gymnasium warns of."""
    try:
        import gymnasium
    except ImportError:
        raise NppgError(f"gym:{id} needs gymnasium, which is not installed: pip install 'nppg[gym]'") from None
    arguments = {
        name: _TRUTH.get(value.lower(), value) if isinstance(value, str) else value
        for name, value in parameters.items()
    }
    horizon = arguments.pop("max_episode_steps", None)
    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always")
        try:
            env = gymnasium.make(id, max_episode_steps=-1, disable_env_checker=True, **arguments)
        except Exception as error:  # whatever the code of an environment may raise
            raise NppgError(f"gym:{id}: {_unknown(id, arguments) or told(error)}") from error
    for message in dict.fromkeys(_COLOUR.sub("", str(each.message)).removeprefix("WARN: ") for each in noted):
        warnings.warn(f"gym:{id}: {message}", stacklevel=3)
    assert env.spec is not None
    for name, parameter in _accepted(env.spec.id).items():
        if isinstance(parameter.default, bool) and not isinstance(arguments.get(name, True), bool):
            raise NppgError(f"gym:{id}: {name} must be true or false, not {arguments[name]!r}")
    if horizon is None:
        horizon = gymnasium.spec(env.spec.id).max_episode_steps or _HORIZON
    if type(horizon) is not int or horizon < 1:
        raise NppgError(f"gym:{id}: max_episode_steps must be a whole number of at least 1, not {horizon!r}")
    module = id.rpartition(":")[0]
    return Made(f"{module}:{env.spec.id}" if module else env.spec.id, env, horizon)


def told(error: Exception) -> str:
    """What an exception says, on one line; Gymnasium's own are written for users and need no name."""
    said = " ".join(_COLOUR.sub("", str(error)).split())
    return said if type(error).__module__ == "gymnasium.error" and said else f"{type(error).__name__}: {said}"


def _unknown(id: str, arguments: Mapping[str, object]) -> str:
    """The problem that the environment takes no argument of some name, where that is so."""
    known = _accepted(id.rpartition(":")[2])
    if any(each.kind is inspect.Parameter.VAR_KEYWORD for each in known.values()):
        return ""
    for name in arguments if known else ():
        if name not in known:
            near = suggestion(name, known) or f"; the environment has {', '.join(known)}"
            return f"there is no parameter {name}{near}"
    return ""


def _accepted(registered: str) -> Mapping[str, inspect.Parameter]:
    """The arguments that a registered environment is made with; none where that cannot be told."""
    from gymnasium.envs.registration import load_env_creator, registry

    spec = registry.get(registered)
    creator = spec and spec.entry_point
    try:
        found = inspect.signature(load_env_creator(creator) if isinstance(creator, str) else creator)
    except Exception:  # there is none, or its module cannot be loaded
        return {}
    return found.parameters
