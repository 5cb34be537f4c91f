"""The hyperparameters of a training run; each field is also an option of `nppg train`."""

from __future__ import annotations

import sys
from dataclasses import Field, dataclass, field, fields
from typing import Any, ClassVar

from nppg.bridge.plain import alone
from nppg.errors import NppgError, Problem


def at_least(name: str, value: int, low: int) -> int:
    """The value as Python's own. Raises NppgError for one below `low`, or that is no whole number."""
    value = alone(value)
    if isinstance(value, bool) or not isinstance(value, int):
        raise NppgError(f"{name} must be a whole number, not {value!r}")
    if value < low:
        raise NppgError(f"{name} must be at least {low}, not {value}")
    return value


def option(default: Any, help: str, **bounds: Any) -> Any:
    """A field of an options class: what it is for, its bounds `low` and `high` or its `choices`, or that it is any
    `text`, and its `kind` where the default does not show it."""
    return field(default=default, metadata={"help": help, **bounds})


def kind_of(option: Field) -> type:
    """int, float or str."""
    return option.metadata.get("kind", type(option.default))


@dataclass(frozen=True, slots=True)
class Common:
    """What every learner has. Raises NppgError for values that cannot be."""

    learner: ClassVar[str]

    episodes: int = option(2000, "episodes in all", low=0)
    seed: int = option(0, "seed of the NumPy generator that all randomness comes from", low=0)
    guidance: float = option(0.1, "share of episodes that are traces of an expert", low=0, high=1)
    expert: str = option(
        "domain",
        "who that is: the domain's expert/1; optimal, the fewest steps in problems of few states; or a planner of "
        "unified-planning by its name, such as fast-downward, on problems in PDDL",
        text=True,
    )
    horizon_factor: float = option(1.0, "episodes end after this many times the domain's horizon", low=0)

    def __post_init__(self) -> None:
        for each in fields(self):
            object.__setattr__(self, each.name, alone(getattr(self, each.name)))
        wrong = [problem for each in fields(self) if (problem := problem_of(each, getattr(self, each.name)))]
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
    examples_growth: float = option(
        0.0, "share of min_examples that each tree adds to it, so that later trees average over more", low=0
    )
    episodes_per_iteration: int = option(1, "least number of episodes between two trees", low=1)
    curriculum: str = option(
        "yes",
        "whether problems are learned from the smallest on, more as success rises; without problems it is the same",
        choices=("no", "yes"),
    )
    update: str = option("all", "actions that get an example: all, or the one taken", choices=("all", "taken"))
    step: str = option(
        "gradient",
        "what a tree fits: the paper's gradient, or second-order steps",
        choices=("gradient", "second-order"),
    )
    regularisation: float = option(0.25, "lambda of a second-order leaf, sum(f) / (sum(h) + lambda)", low=0)
    regularisation_growth: float = option(0.0, "share of lambda that each tree adds to it", low=0)
    clip: float = option(3.0, "a second-order leaf lies between -clip and clip", low=0)
    importance: float | None = option(
        None,
        "power of pi(s, a) that weights a visit: 1 is the paper's, 0 makes the gradient that of expected returns; left "
        "out it is 1, in second-order steps 0.5, and 0 where the taken action alone is updated",
        kind=float,
        low=0,
        high=1,
    )
    imitation: str = option(
        "no",
        "what trees learn from: returns, or (self) the shortest ways to the goal that the run's own episodes know",
        choices=("no", "self"),
    )
    floor: float = option(0.0, "share of the policy's actions in training that are drawn uniformly", low=0, high=1)
    detours: float = option(
        1.0,
        "in self-imitation, steps of trying other actions in states that were met, as a share of those of episodes",
        low=0,
    )
    replay: int = option(
        0,
        "earlier steps that each tree learns from again, under the present policy: the last rewarded ones; in "
        "self-imitation states drawn from all that have been met",
        low=0,
    )
    regressor: str = option("tilde", "what fits the trees: TILDE, or CART by scikit-learn", choices=("tilde", "cart"))
    models: str = option(
        "one",
        "one regression tree for all kinds of actions, or one for each kind (for each constant, where the only kind's "
        "arguments are compared with constants); the same where there is nothing to tell apart",
        choices=("one", "per-action"),
    )
    unrewarded: str = option(
        "keep", "what becomes of steps with return (advantage) 0: keep, or drop", choices=("keep", "drop")
    )
    line_search: int = option(
        0, "doublings and halvings of the step size that are tried for each tree; 0: it is fixed", low=0, high=20
    )
    ratio_clip: float = option(
        0.2, "of the line search: a step's importance weight counts up to 1 + ratio_clip and from 1 - ratio_clip", low=0
    )
    critic: str = option(
        "none",
        "what a step is worth: its return, or its advantage over a value function that is learned beside the policy",
        choices=("none", "value"),
    )
    trace: float = option(
        1.0,
        "lambda of generalised advantage estimation: 1 return minus value, 0 one step's reward",
        low=0,
        high=1,
    )
    cut_off: str = option(
        "end",
        "what the critic expects behind an episode that its horizon or its environment has cut off: nothing, where the "
        "horizon is part of the task, or (bootstrap) the value of its last state",
        choices=("end", "bootstrap"),
    )
    critic_step_size: float = option(0.5, "by which each tree of the value function is multiplied", low=0, high=1)
    critic_trees: int = option(1, "trees of the value function for one of the policy", low=1)
    normalise: str = option(
        "no", "whether what a tree's steps are worth is standardised, to mean 0 and deviation 1", choices=("no", "yes")
    )

    def __post_init__(self) -> None:
        super(Options, self).__post_init__()  # without arguments it does not find its class, which has slots
        if self.importance is None:
            usual = 1.0 if self.step == "gradient" else 0.5
            object.__setattr__(self, "importance", 0.0 if self.update == "taken" else usual)


def problem_of(option: Field, value: Any) -> str:
    """What is wrong with a value, or nothing."""
    name, bounds = option.name, option.metadata
    if value is None and option.default is None:
        return ""
    if "choices" in bounds:
        choices = bounds["choices"]
        return "" if value in choices else f"{name} must be one of {', '.join(choices)}, not {value!r}"
    if bounds.get("text"):
        return "" if isinstance(value, str) and value else f"{name} must be a name, not {value!r}"
    low, high = bounds["low"], bounds.get("high", sys.float_info.max)
    whole = kind_of(option) is int
    if isinstance(value, bool) or not isinstance(value, int if whole else (int, float)):
        return f"{name} must be a {'whole ' if whole else ''}number, not {value!r}"
    if not low <= value <= high:  # so are NaN and infinity
        return f"{name} must be {f'from {low} to {high}' if 'high' in bounds else f'at least {low}'}, not {value!r}"
    return ""
