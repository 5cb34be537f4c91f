"""What is used of unified-planning, or how to get it."""

from __future__ import annotations

from nppg.errors import NppgError

try:
    from unified_planning.engines import Engine, PlanGenerationResult, PlanGenerationResultStatus
    from unified_planning.engines import SequentialPlanValidator as PlanValidator
    from unified_planning.engines.mixins import OneshotPlannerMixin
    from unified_planning.engines.results import LogLevel, LogMessage
    from unified_planning.environment import Environment, get_environment
    from unified_planning.exceptions import UPException, UPValueError
    from unified_planning.io import PDDLReader
    from unified_planning.io.pddl_writer import ConverterToPDDLString
    from unified_planning.model import Problem as UPProblem
    from unified_planning.model import ProblemKind
    from unified_planning.model.problem_kind_versioning import LATEST_PROBLEM_KIND_VERSION
    from unified_planning.plans import ActionInstance, SequentialPlan
except ModuleNotFoundError as error:
    if (error.name or "").split(".")[0] != "unified_planning":
        raise
    raise NppgError("nppg.planning needs unified-planning: pip install 'nppg[pddl]'") from None

__all__ = [
    "LATEST_PROBLEM_KIND_VERSION",
    "ActionInstance",
    "ConverterToPDDLString",
    "Engine",
    "Environment",
    "LogLevel",
    "LogMessage",
    "OneshotPlannerMixin",
    "PDDLReader",
    "PlanGenerationResult",
    "PlanGenerationResultStatus",
    "PlanValidator",
    "ProblemKind",
    "SequentialPlan",
    "UPException",
    "UPProblem",
    "UPValueError",
    "get_environment",
]
