"""The hyperparameters of a training run; each field is also an option of `nppg train`."""

from __future__ import annotations

import sys
from dataclasses import Field, dataclass, field, fields
from typing import Any, ClassVar

from nppg.errors import NppgError, Problem


def at_least(name: str, value: int, low: int) -> None:
    """Raises NppgError for a value below `low`."""
    if value < low:
        raise NppgError(f"{name} must be at least {low}, not {value}")


def option(default: Any, help: str, **bounds: Any) -> Any:
    """A field of an options class: what it is for, and its bounds `low` and `high` or its `choices`."""
    return field(default=default, metadata={"help": help, **bounds})


@dataclass(frozen=True, slots=True)
class Common:
    """What every learner has. Raises NppgError for values that cannot be."""

    learner: ClassVar[str]

    episodes: int = option(2000, "episodes in all", low=0)
    seed: int = option(0, "seed of the NumPy generator that all randomness comes from", low=0)
    guidance: float = option(0.1, "share of episodes that are traces of the domain's expert", low=0, high=1)
    horizon_factor: float = option(1.0, "episodes end after this many times the domain's horizon", low=0)

    def __post_init__(self) -> None:
        wrong = [problem for each in fields(self) if (problem := _problem(each, getattr(self, each.name)))]
        if wrong:
            raise NppgError(Problem("", 0, 0, message) for message in wrong)


@dataclass(frozen=True, slots=True)
class Options(Common):
    """Of non-parametric policy gradients. The paper's settings for the blocks world are the defaults; docs/method.md
    says what the paper leaves open."""

    learner: ClassVar[str] = "nppg"

    step_size: float = option(1.0, "eta, by which each tree is multiplied", low=0)
    discount: float = option(1.0, "gamma, of the returns", low=0, high=1)
    min_examples: int = option(100, "a tree is grown once more examples than this have gathered", low=0)
    episodes_per_iteration: int = option(1, "least number of episodes between two trees", low=1)
    update: str = option(
        "all", "actions that get an example: all, or taken (divided by its probability)", choices=("all", "taken")
    )
    step: str = option(
        "gradient",
        "what a tree fits: the paper's gradient, or second-order steps",
        choices=("gradient", "second-order"),
    )
    regularisation: float = option(0.25, "lambda of a second-order leaf, sum(f) / (sum(h) + lambda)", low=0)
    clip: float = option(3.0, "a second-order leaf lies between -clip and clip", low=0)
    importance: float = option(
        0.5,
        "power of pi(s, a) that weights a visit in second-order steps; in the paper's gradient it is 1",
        low=0,
        high=1,
    )
    replay: int = option(0, "earlier rewarded steps that each tree learns from again, under the present policy", low=0)
    regressor: str = option("tilde", "what fits the trees: TILDE, or CART by scikit-learn", choices=("tilde", "cart"))
    unrewarded: str = option("keep", "what becomes of steps with return 0: keep, or drop", choices=("keep", "drop"))


def _problem(option: Field, value: Any) -> str:
    name, bounds = option.name, option.metadata
    if "choices" in bounds:
        choices = bounds["choices"]
        return "" if value in choices else f"{name} must be one of {', '.join(choices)}, not {value!r}"
    low, high = bounds["low"], bounds.get("high", sys.float_info.max)
    whole = isinstance(option.default, int)
    if isinstance(value, bool) or not isinstance(value, int if whole else (int, float)):
        return f"{name} must be a {'whole ' if whole else ''}number, not {value!r}"
    if not low <= value <= high:  # so are NaN and infinity
        return f"{name} must be {f'from {low} to {high}' if 'high' in bounds else f'at least {low}'}, not {value!r}"
    return ""
