"""A planner of unified-planning as an expert: its plans are the traces that guide episodes."""

from __future__ import annotations

import warnings

from nppg.errors import NppgError, Problem
from nppg.judging.expert import ByState
from nppg.planning.optional import Environment, PDDLReader, UPException
from nppg.worlds.domain import Domain
from nppg.worlds.pddl_domain import PddlDomain
from nppg.worlds.world import Action, State

SECONDS = 60  # for one plan

Plan = list[Action]


class PlanningExpert:
    """Follows one plan for each of the problems that the domain's starts are drawn from, made when it is made; it has
    no advice in other states, nor on problems for which the planner finds no plan within 60 seconds: how many have one
    is told by a warning. Raises NppgError where there is no such planner, where these problems are not in PDDL, or
    where a plan does not lead from a start to its goal for certain."""

    def __init__(self, domain: Domain, engine: str, plans: dict[int, Plan] | None = None):
        if not isinstance(domain, PddlDomain) or not all(map(domain.file_of, domain.chosen)) or not domain.chosen:
            message = f"the expert {engine} plans for problems in PDDL files: name them by --problems"
            raise NppgError([Problem(str(domain.path), 0, 0, message)])
        self.domain = domain
        self.engine = engine
        self.plans = self._planned() if plans is None else plans
        self._known: ByState[list[Action]] = ByState()
        for number, plan in self.plans.items():
            self._follow(number, plan)

    def __reduce__(self) -> tuple:
        return PlanningExpert, (self.domain, self.engine, self.plans)

    def __call__(self, state: State) -> list[Action]:
        state = self.domain.interpreted(state)
        return self._known.about(state.static).get(state.fingerprint, [])

    def _planned(self) -> dict[int, Plan]:
        found = {}
        for number in self.domain.chosen:
            if (plan := self._plan(number)) is not None:
                found[number] = plan
        if len(found) < len(self.domain.chosen):
            share = f"{len(found)} of {len(self.domain.chosen)} problems"
            warnings.warn(
                f"the expert {self.engine} has plans for {share}; on the others the policy acts", stacklevel=3
            )
        return found

    def _plan(self, number: int) -> Plan | None:
        environment = Environment()
        environment.credits_stream = None
        file = self.domain.file_of(number)
        assert file
        try:
            problem = PDDLReader(environment).parse_problem_string(self.domain.model.source, file.read_text())
            with environment.factory.OneshotPlanner(name=self.engine) as planner:
                result = planner.solve(problem, timeout=SECONDS)
        except OSError as error:
            raise NppgError([Problem(str(file), 0, 0, f"cannot be read: {error.strerror}")]) from None
        except UPException as error:
            told = " ".join(str(error).split())
            raise NppgError([Problem(str(file), 0, 0, f"the expert {self.engine} cannot plan here: {told}")]) from None
        if result.plan is None:
            return None
        return [
            self.domain.step_of_plan(each.action.name.lower(), [str(arg).lower() for arg in each.actual_parameters])
            for each in result.plan.actions
        ]

    def _follow(self, number: int, plan: Plan) -> None:
        """Notes what the plan does in each state."""
        state: State | None = self.domain.problem(number)
        for action in plan:
            assert state is not None
            status, actions = self.domain.situation(state)
            if status == "goal":
                return
            following = self.domain.certain(state, action) if action in actions else None
            if following is None:
                break
            own = self.domain.interpreted(state)
            self._known.about(own.static)[own.fingerprint] = [action]
            state = following
        if state is None or self.domain.situation(state).status != "goal":
            name = self.domain.problems[number]
            message = f"the plan of {self.engine} for {name} does not lead to its goal for certain"
            raise NppgError([Problem(str(self.domain.path), 0, 0, message)])
