"""The points of a run's learning curve: when they are due, and how the policy is evaluated for them.

Where a run may use more than one process, sampled points are drawn in others beside it while training goes on. The
numbers are the same, for a point hangs on nothing but the policy as it was when the point was due.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, replace

from nppg.errors import NppgError
from nppg.experiments.progress import Point, Progress
from nppg.judging.evaluation import Evaluation, ExactEvaluator, evaluate_both, spread
from nppg.judging.memory import Memory
from nppg.judging.space import Space, shared_space
from nppg.policy.beside import Beside, Gone, Others
from nppg.policy.policy import Policy

_PROBLEMS = 20  # at most so many are a point of the curve
_CLASSES = 20_000  # state spaces up to this size are evaluated exactly between the trees
_LAST = 3.0  # seconds for what is under way when the run ends by force

Both = tuple[Evaluation, Evaluation]


class Sampled:
    """Evaluates a policy on sampled starts, the stochastic one and the greedy one, as it is by then."""

    def __init__(self, policy: Policy, starts: int, seed: int, horizon_factor: float, problems: list[int]):
        self.policy = policy
        self._settings = (starts, seed, horizon_factor, problems)
        self._memory = Memory(policy.domain)

    def __call__(self) -> Both:
        return evaluate_both(self.policy, *self._settings, self._memory)

    def of_first(self, trees: int) -> Both:
        """The same for the policy as it was after so many trees."""
        earlier = Policy(self.policy.domain, self.policy.bias, self.policy.table)
        for tree in self.policy.trees[:trees]:
            earlier.add(tree)
        return evaluate_both(earlier, *self._settings)

    def __reduce__(self) -> tuple:
        starts, seed, horizon_factor, problems = self._settings
        return Sampled, (self.policy, starts, seed, horizon_factor, problems)


@dataclass
class _Due:
    """A point, but for how the policy does, which `beside` may be about to tell."""

    point: Point
    trees: int
    found: Both | None = None
    beside: Beside | None = None


class Points:
    """The points of a run, in up to `jobs` processes."""

    def __init__(self, progress: Progress, starts: int | None, space: Space | None, jobs: int):
        policy, options = progress.policy, progress.options
        self._exact = _exact(progress, space)
        problems = list(spread(policy.domain.chosen, _PROBLEMS)) if starts is None else []
        self._sampled = Sampled(policy, starts or len(problems), options.seed, options.horizon_factor, problems)
        alone = self._exact or type(policy) is not Policy or policy.domain.environment
        self._others = Others(self._sampled, 0 if alone else jobs - 1)
        self._due: list[_Due] = []

    def draw(self, progress: Progress) -> None:
        """Has the policy evaluated as it is now."""
        due = _Due(_unjudged(progress), len(progress.policy.trees), beside=self._asked())
        self._due.append(due)
        if due.beside is None:
            begin = time.perf_counter()
            due.found = self._here(progress)
            self._others.worked(time.perf_counter() - begin)

    def _here(self, progress: Progress) -> Both:
        if self._exact is None:
            return self._sampled()
        now = progress.evaluator = self._exact.snapshot()
        factor = progress.options.horizon_factor
        return now.evaluate(False, factor), now.evaluate(True, factor)

    def _asked(self) -> Beside | None:
        """A process that has begun to evaluate the policy, if one is free."""
        return next((each for each in self._others.free() if self._others.asked(each)), None)

    def drawn(self, wait: bool = False) -> Iterator[Point]:
        """Those that have been drawn since, in order; all of them, if it is to `wait`."""
        while self._due:
            due = self._due[0]
            if due.beside:
                try:
                    if not (wait or due.beside.answers_by(0.0)):
                        return
                    due.found = due.beside.answer()
                except Gone:
                    self._others.lost(due.beside)
                    due.found = self._sampled.of_first(due.trees)
            assert due.found
            self._due.pop(0)
            yield _judged(due.point, *due.found)

    def saved(self) -> list[list]:
        """Those that are due and not drawn yet, to be stored, each with the trees that its policy had."""
        return [[due.point, due.trees] for due in self._due]

    def resume(self, saved: list[list]) -> None:
        """Draws those."""
        self._due += [_Due(point, trees, self._sampled.of_first(trees)) for point, trees in saved]

    def rescued(self) -> Iterator[Point]:
        """What of them is there within a few seconds, when nothing else is to be learned of a run."""
        moment = time.monotonic() + _LAST
        for due in self._due:
            try:
                if due.beside and due.beside.answers_by(moment):
                    due.found = due.beside.answer()
            except Gone:
                pass
            if due.found:
                yield _judged(due.point, *due.found)

    def close(self) -> None:
        """Ends the other processes."""
        self._others.close()


def is_due(progress: Progress, episodes: int, every: int) -> bool:
    """Whether a point is, after so many more episodes: one every so many, and at the beginning and the end."""
    if every == 0:
        return False
    passed = (progress.episodes - episodes) // every < progress.episodes // every
    return progress.episodes == 0 or passed or progress.is_spent


def _exact(progress: Progress, space: Space | None) -> ExactEvaluator | None:
    """What evaluates the run's policy exactly, where the domain allows it and has few classes of states."""
    policy = progress.policy
    if not policy.domain.is_countable or progress.measure != "success":
        return None
    try:
        return ExactEvaluator(policy, space or shared_space(policy.domain, _CLASSES))
    except NppgError:
        return None


def _unjudged(progress: Progress) -> Point:
    """The point that is due now, which lacks how the policy does."""
    sizes = progress.policy.sizes()
    return Point(
        episode=progress.episodes,
        trees=sizes.get("trees", 0),
        success=0.0,
        seconds=round(progress.seconds, 3),
        greedy_success=0.0,
        mean_steps=0.0,
        recent=progress.recent,
        exact=0,
        leaves=sizes.get("leaves", 0),
        instances=sizes.get("instances", 0),
        mean_return=None,
        greedy_return=None,
    )


def _judged(point: Point, stochastic: Evaluation, greedy: Evaluation) -> Point:
    """The same with how the policy does."""
    return replace(
        point,
        success=stochastic.success,
        greedy_success=greedy.success,
        mean_steps=stochastic.mean_steps,
        exact=int(stochastic.exact),
        mean_return=stochastic.mean_return,
        greedy_return=greedy.mean_return,
    )
