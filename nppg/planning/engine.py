"""A policy as a planner of unified-planning."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

from nppg.errors import NppgError
from nppg.judging.problems import attempt
from nppg.learning.options import Options, at_least
from nppg.pddl.goals import unreachable
from nppg.pddl.problem_file import problem_of
from nppg.pddl.tokens import Document
from nppg.planning.optional import (
    LATEST_PROBLEM_KIND_VERSION,
    ActionInstance,
    Engine,
    LogLevel,
    LogMessage,
    OneshotPlannerMixin,
    PlanGenerationResult,
    PlanGenerationResultStatus,
    PlanValidator,
    ProblemKind,
    SequentialPlan,
    UPProblem,
    UPValueError,
    get_environment,
)
from nppg.planning.problem_text import problem_text
from nppg.policy.policy import Policy
from nppg.worlds.pddl_domain import PddlDomain
from nppg.worlds.problems import numbered

__all__ = ["NppgEngine", "get_environment"]

_FEATURES = {
    "problem_class": ["ACTION_BASED"],
    "problem_type": ["SIMPLE_NUMERIC_PLANNING", "GENERAL_NUMERIC_PLANNING"],
    "typing": ["FLAT_TYPING", "HIERARCHICAL_TYPING"],
    "fluents_type": ["INT_FLUENTS", "REAL_FLUENTS"],
    "conditions_kind": [
        "NEGATIVE_CONDITIONS",
        "DISJUNCTIVE_CONDITIONS",
        "EQUALITIES",
        "EXISTENTIAL_CONDITIONS",
        "UNIVERSAL_CONDITIONS",
    ],
    "effects_kind": [
        "CONDITIONAL_EFFECTS",
        "FORALL_EFFECTS",
        "INCREASE_EFFECTS",
        "DECREASE_EFFECTS",
        "STATIC_FLUENTS_IN_NUMERIC_ASSIGNMENTS",
        "FLUENTS_IN_NUMERIC_ASSIGNMENTS",
    ],
    "quality_metrics": ["ACTIONS_COST", "PLAN_LENGTH", "FINAL_VALUE"],
    "actions_cost_kind": [
        "STATIC_FLUENTS_IN_ACTIONS_COST",
        "FLUENTS_IN_ACTIONS_COST",
        "INT_NUMBERS_IN_ACTIONS_COST",
        "REAL_NUMBERS_IN_ACTIONS_COST",
    ],
}


class NppgEngine(Engine, OneshotPlannerMixin):
    """Acts by the policy of a model file, which was learned in a PDDL domain, on problems of that domain: one episode,
    without search. `model`: the file; `seed`: of ties; `revisits`: whether it may come back to a state, while there is
    another way; `horizon_factor`: how many times the domain's horizon an episode is long, by default as in training;
    `edited`: whether it may have been changed since it was written.

    Raises NppgError where the model cannot be used."""

    def __init__(
        self,
        model: str | Path | None = None,
        seed: int = 0,
        revisits: bool = True,
        horizon_factor: float | None = None,
        edited: bool = False,
    ):
        Engine.__init__(self)
        OneshotPlannerMixin.__init__(self)
        if model is None:
            raise NppgError("nppg needs a model: OneshotPlanner(name='nppg', params={'model': 'runs/NAME/model.pl'})")
        self._policy = Policy.load(model, edited=edited)
        if not isinstance(self._policy.domain, PddlDomain):
            raise NppgError(f"{model}: the policy was not learned in a PDDL domain")
        self._domain = self._policy.domain
        factor = self._policy.option("horizon_factor", 1.0) if horizon_factor is None else horizon_factor
        self._seed, self._revisits = at_least("seed", seed, 0), revisits
        self._factor = Options(horizon_factor=factor).horizon_factor

    @property
    def name(self) -> str:
        """nppg."""
        return "nppg"

    @staticmethod
    def supported_kind() -> ProblemKind:
        """What a PDDL domain may have; chance and derived predicates are not unified-planning's."""
        kind = ProblemKind(version=LATEST_PROBLEM_KIND_VERSION)
        for group, names in _FEATURES.items():
            for each in names:
                getattr(kind, f"set_{group}")(each)
        return kind

    @staticmethod
    def supports(problem_kind: ProblemKind) -> bool:
        """Whether it can be used."""
        return bool(problem_kind <= NppgEngine.supported_kind())

    def _solve(
        self, problem: UPProblem, heuristic: Any = None, timeout: float | None = None, output_stream: Any = None
    ) -> PlanGenerationResult:
        for name, given in (("heuristic", heuristic), ("timeout", timeout), ("output_stream", output_stream)):
            if given is not None:
                warnings.warn(f"nppg makes no use of {name}", stacklevel=3)
        status = PlanGenerationResultStatus
        model = self._domain.model
        try:
            text = problem_text(problem, model.name, {each.name for each in model.constants})
            read = problem_of(Document(f"problem {problem.name}", text), model)
            if messages := unreachable(read, model):
                return self._result(status.UNSOLVABLE_PROVEN, "; ".join(messages))
            start = self._domain.start_of(read)
        except NppgError as error:
            return self._result(status.UNSUPPORTED_PROBLEM, f"no problem of the domain {model.name}: {error}")
        self._policy.domain = self._domain.over(numbered([start], [read.name]))
        found = attempt(self._policy, 1, self._seed, horizon_factor=self._factor, revisits=self._revisits)
        metrics = {"engine_internal_time": str(found.seconds)}
        if not found.solved:
            return self._result(
                status.UNSOLVABLE_INCOMPLETELY, f"{found.ended} after {found.steps} steps", metrics=metrics
            )
        plan = self._plan(problem, [self._domain.plan_step(action) for action in found.plan])
        if plan is None:
            message = f"the actions of the problem are not those of the domain {model.name} that the policy knows"
            return self._result(status.INTERNAL_ERROR, message, metrics=metrics)
        return self._result(status.SOLVED_SATISFICING, plan=plan, metrics=metrics)

    def _plan(self, problem: UPProblem, lines: list[str]) -> SequentialPlan | None:
        """The plan, with the actions of the problem; None where it is none."""
        actions = {each.name.lower(): each for each in problem.actions}
        manager = problem.environment.expression_manager
        objects = {each.name.lower(): manager.ObjectExp(each) for each in problem.all_objects}
        steps = []
        try:
            for line in lines:
                name, *args = line.strip("()").split()
                steps.append(ActionInstance(actions[name], tuple(objects[each] for each in args)))
            plan = SequentialPlan(steps, problem.environment)
            return plan if PlanValidator().validate(problem, plan) else None
        except (KeyError, AssertionError, UPValueError):
            return None

    def _result(
        self,
        status: PlanGenerationResultStatus,
        message: str = "",
        plan: SequentialPlan | None = None,
        metrics: dict[str, str] | None = None,
    ) -> PlanGenerationResult:
        logs = [LogMessage(LogLevel.INFO, message)] if message else []
        return PlanGenerationResult(status, plan, self.name, metrics, logs)
