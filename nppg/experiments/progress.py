"""What a run has come to, and the points of its learning curve."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TypedDict

from nppg.judging.evaluation import ExactEvaluator
from nppg.learning.gradient import total
from nppg.learning.options import Common
from nppg.policy.policy import Policy
from nppg.worlds.domain import Domain

MEASURES = {"success": ("success", "greedy_success"), "return": ("mean_return", "greedy_return")}  # as points have them
_RECENT = 100  # episodes that `recent` is the mean of


class _Seconds(TypedDict, total=False):
    seconds: float


class Judging(_Seconds):
    """The arguments of `run` about the curve and where it ends, with what is meant where they are left out; `seconds`
    are left out themselves."""

    evaluate_every: int
    starts: int | None
    until_success: float | None
    until_return: float | None


@dataclass(frozen=True, slots=True)
class Point:
    """One point of the learning curve. `success` is the stochastic policy's (exact where `exact` is 1), `recent`
    the share of the last training episodes that reached the goal, or their mean return (see Progress.measure);
    `seconds` leaves evaluation out. The value-function learners' policies are greedy where they are evaluated. `leaves`
    are those of all trees. Returns are undiscounted, of the sampled episodes; none where `exact` is 1."""

    episode: int
    trees: int
    success: float
    seconds: float
    greedy_success: float
    mean_steps: float
    recent: float
    exact: int
    leaves: int
    instances: int
    mean_return: float | None
    greedy_return: float | None


@dataclass
class Progress:
    """What a run has come to; handed to the caller after each tree, with a new `point` where one was made."""

    policy: Policy
    options: Common
    judging: Judging
    episodes: int = 0
    stage: str = ""  # how far the curriculum is: 12/99, of the problems
    seconds: float = 0.0
    outcomes: list[float] = field(default_factory=list)  # of each episode: see `measure`
    curve: list[Point] = field(default_factory=list)
    point: Point | None = None
    evaluator: ExactEvaluator | None = None  # that the last point comes from, where it is exact
    notes: list = field(default_factory=list)  # what who is reported to wants to find again when the run is resumed
    ended: bool = False
    written: list[str] = field(default_factory=list)  # names of the files, at the end

    @property
    def measure(self) -> str:
        """What episodes are judged by."""
        return measured(self.policy.domain, self.judging)

    @property
    def is_spent(self) -> bool:
        """Whether all episodes were played, or all the seconds that it may learn are over."""
        return self.episodes == self.options.episodes or self.seconds >= self.judging.get("seconds", math.inf)

    def judged(self, point: Point) -> tuple[float, float]:
        """The measure of a point's stochastic policy and of its greedy one."""
        if point.mean_return is None or point.greedy_return is None or self.measure == "success":
            return point.success, point.greedy_success
        return point.mean_return, point.greedy_return

    @property
    def recent(self) -> float:
        """Mean over the last episodes: the share that reached the goal, or the return."""
        return total(self.outcomes[-_RECENT:]) / max(len(self.outcomes[-_RECENT:]), 1)


def measured(domain: Domain, judging: Judging) -> str:
    """What episodes are judged by: their success; their return in domains without a goal, and where the run is to end
    at one."""
    return "success" if domain.has_goal and judging["until_return"] is None else "return"


def sizes(policy: Policy, point: Point | None = None) -> str:
    """What a policy consists of, or did at a point, for people."""
    numbers = policy.sizes()
    if point:
        numbers = {name: getattr(point, name) for name in numbers}
    return "  ".join(f"{name} {number:,}" for name, number in numbers.items())


def title(domain: Domain) -> str:
    """The domain's name with its parameters, for people."""
    parameters = ", ".join(f"{name} = {value}" for name, value in domain.parameters.items())
    return f"{domain.name} ({parameters})" if parameters else domain.name
