"""How the goals of a clause are asked: in which order, and what once."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from nppg.features.schemas import variables_of
from nppg.pddl.clauses import Infix, Negated, Once, Part, Term, Var


def joined(goals: Iterable[Part], known: Iterable[Var], calls: Collection[Part] = ()) -> tuple[Part, ...]:
    """The goals in another order, for a clause of which some variables are mostly `known` when it is called: next comes
    the fact with the fewest new variables, of these the one with the most known ones, so that few answers are looked
    through in vain; what compares or denies comes as soon as others have bound all that it shares with them, also where
    that is known. Terms among `calls` are no facts: they, choices and what computes stay in front of or behind the
    facts, and one another, with which they share unbound variables."""
    all_, bound, met = list(goals), set(known), set[Var]()
    own = {id(goal): set(variables_of([goal])) for goal in all_}
    checks = [goal for goal in all_ if _binds_nothing(goal)]
    left = [goal for goal in all_ if not _binds_nothing(goal)]
    fixed = {id(goal) for goal in left if goal in calls or not isinstance(goal, Term)}
    done: list[Part] = []

    def is_free(place: int) -> bool:
        goal = id(left[place])
        return not any(
            (own[goal] & own[id(other)]) - met for other in left[:place] if goal in fixed or id(other) in fixed
        )

    while checks or left:
        open_ = set().union(*(own[id(goal)] for goal in left)) - met
        ready = [goal for goal in checks if not own[id(goal)] & open_]
        done += ready
        checks = [goal for goal in checks if goal not in ready]
        if left:
            free = [goal for place, goal in enumerate(left) if is_free(place)]
            chosen = min(free, key=lambda goal: (len(own[id(goal)] - bound), -len(own[id(goal)] & bound)))
            left = [goal for goal in left if goal is not chosen]
            bound |= own[id(chosen)]
            met |= own[id(chosen)]
            done.append(chosen)
    return tuple(done)


def _binds_nothing(goal: Part) -> bool:
    return isinstance(goal, Negated) or (isinstance(goal, Infix) and goal.operator not in ("is", "="))


def apart(
    goals: Sequence[Part], answered: Collection[Var], known: Collection[Var], bound: Collection[Var] = ()
) -> tuple[Part, ...]:
    """The goals, in about the same order, in which what has nothing to do with the variables that are `answered`, once
    some are `bound`, is asked once, and before the others: else every way in which it is true would be gone through
    again with each answer of theirs. First come facts about what is mostly `known` by then."""
    free, given = {*answered} - {*bound}, {*known, *bound}

    def rank(own: Sequence[Part]) -> int:
        variables = set(variables_of(own))
        return 0 if variables <= given else 1 if free.isdisjoint(variables) else 2

    done: list[Part] = []
    for first, *rest in sorted(_components(goals, bound), key=rank):
        whole = (first, *apart(rest, answered, known, {*bound, *variables_of([first])})) if rest else (first,)
        new = {*variables_of(whole)} - {*bound}
        once = new and free.isdisjoint(new) and any(isinstance(goal, Term) for goal in whole)
        done += [Once(whole)] if once else whole
    return tuple(done)


def _components(goals: Sequence[Part], bound: Collection[Var]) -> list[list[Part]]:
    """Those that hang together by variables that are not bound, in their order."""
    found: list[tuple[set[Var], list[int]]] = []
    for place, goal in enumerate(goals):
        own = set(variables_of([goal])) - {*bound}
        near = [each for each in found if not own.isdisjoint(each[0])]
        found = [each for each in found if each not in near]
        found.append((own.union(*(each for each, _ in near)), sorted([place, *(i for _, own in near for i in own)])))
    return [[goals[place] for place in places] for _, places in sorted(found, key=lambda each: each[1])]
