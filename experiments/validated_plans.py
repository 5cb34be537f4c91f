"""Acts on PDDL problems and has every plan validated by unified-planning.

python -m experiments.validated_plans MODEL PROBLEM.pddl...
"""

from __future__ import annotations

import sys
from pathlib import Path

from unified_planning.engines import SequentialPlanValidator
from unified_planning.io import PDDLReader

from nppg import Policy
from nppg.judging.problems import attempts
from nppg.worlds.opening import with_problems


def main(model: str, *problems: str) -> None:
    files = [Path(each) for each in problems]
    policy = Policy.load(model)
    policy.domain = with_problems(policy.domain, [], files)
    domain = Path(model).parent / policy.domain.pddl
    valid = solved = 0
    for each in attempts(policy):
        reader = PDDLReader()
        task = reader.parse_problem(str(domain), str(files[each.problem - 1]))
        plan = reader.parse_plan_string(task, "\n".join(map(policy.domain.plan_step, each.plan)))
        solved += each.solved
        valid += bool(SequentialPlanValidator().validate(task, plan))
        print(f"{each.name}: {each.ended}, {valid} valid plans of {solved}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
