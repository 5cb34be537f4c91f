"""What people hand over as examples, looked at before a tree is grown from it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from nppg.bridge.plain import number
from nppg.errors import NppgError, Problem
from nppg.worlds.domain import Domain
from nppg.worlds.world import Action, State


def given(examples: Sequence[Any], domain: Domain) -> tuple[list[State], list[Action], np.ndarray]:
    """The states, actions and targets of examples. Raises NppgError, which has the index from 0 of the first one that
    is none: a state with facts of undeclared fluents, a target that is no finite number."""
    states: list[State] = []
    actions: list[Action] = []
    targets: list[float] = []
    for index, each in enumerate(examples):
        try:
            if not isinstance(each, tuple | list) or len(each) != 3:
                raise NppgError(f"{each!r} is no Example: a state, an action and a target")
            state, action, value = each
            targets.append(number("the target", value))
            if not (states and state is states[-1]):
                domain.loaded.must_be_declared(domain.interpreted(state))
            actions.append(domain.loaded.action(action))
            states.append(state)
        except NppgError as error:
            raise NppgError(
                Problem("", 0, 0, f"examples[{index}]: {problem.message}") for problem in error.problems
            ) from None
    if not states:
        raise NppgError("there is no example to grow a tree from")
    return states, actions, np.array(targets, float)


def must_be_finite(what: str, values: np.ndarray) -> None:
    """Raises NppgError, which has the index of the first number that is not."""
    wrong = np.flatnonzero(~np.isfinite(values))
    if len(wrong):
        raise NppgError(f"{what} of example {wrong[0]} is {values[wrong[0]]}, which is no finite number")
