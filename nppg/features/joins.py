"""The order in which the goals of a clause are asked."""

from __future__ import annotations

from collections.abc import Iterable

from nppg.features.schemas import variables_of
from nppg.pddl.clauses import Part, Term, Var


def joined(goals: Iterable[Part], known: Iterable[Var]) -> tuple[Part, ...]:
    """The goals in another order, for a clause of which some variables are `known` when it is called: next comes the
    fact with the fewest new variables, of these the one with the most known ones, so that few answers are looked
    through in vain; what compares or denies comes as soon as all is known that it shares with others."""
    left, bound = list(goals), set(known)
    own = {id(goal): set(variables_of([goal])) for goal in left}
    done: list[Part] = []
    while left:
        facts = [goal for goal in left if isinstance(goal, Term)]
        checks = [goal for goal in left if goal not in facts]
        shared = set().union(*(own[id(goal)] for goal in facts))
        ready = [goal for goal in checks if not (own[id(goal)] - bound) & shared]
        if ready:
            chosen: Part = ready[0]
        else:
            chosen = min(facts, key=lambda goal: (len(own[id(goal)] - bound), -len(own[id(goal)] & bound)))
        left = [goal for goal in left if goal is not chosen]
        bound |= own[id(chosen)]
        done.append(chosen)
    return tuple(done)
