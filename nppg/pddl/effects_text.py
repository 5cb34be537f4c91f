"""Actions as clauses: when they are legal, what they delete and add, what they cost."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from nppg.errors import NppgError, Problem
from nppg.pddl.bodies import Scope, Vocabulary, atom_term, body, number, term, value
from nppg.pddl.changing import changes
from nppg.pddl.clauses import Choice, Clause, Infix, Items, Once, Part, Term, Var
from nppg.pddl.model import Action, Add, And, Change, Delete, Domain
from nppg.pddl.names import COST, REWARD
from nppg.pddl.outcomes import Conditional, Outcome, outcomes

_OPERATORS = {"increase": "+", "decrease": "-", "scale-up": "*", "scale-down": "/"}


@dataclass(frozen=True, slots=True)
class Features:
    """What any action of a domain does, which decides the form of all."""

    chance: bool
    cost: bool
    reward: bool


def features(domain: Domain) -> Features:
    """Whether actions have several outcomes, costs, and rewards."""
    counted = {each.target.name for each in changes(domain) if isinstance(each, Change)}
    chance = any(len(outcomes(domain, action)) > 1 for action in domain.actions)
    return Features(chance, COST in counted, REWARD in counted)


def action_clauses(words: Vocabulary, action: Action, features: Features) -> list[Clause]:
    """All clauses about one action."""
    scope = Scope()
    args = scope.declare(action.parameters)
    called = Term(words.names.actions[action.name], tuple(args))
    legal = Clause(Term("action", (called,)), body(words, action.precondition, scope))
    known = Scope(scope.variables, {}, set(args))
    found = outcomes(words.domain, action)
    clauses = [legal]
    for index, outcome in enumerate(found, 1):
        mark = (Term(index),) if len(found) > 1 else ()
        clauses += _outcome_clauses(words, outcome, called, mark, known, features)
    if features.cost:
        clauses += _cost_clauses(words, found, called, known)
    return clauses


def _outcome_clauses(
    words: Vocabulary, outcome: Outcome, called: Term, mark: tuple[Term, ...], known: Scope, features: Features
) -> list[Clause]:
    """The effect clause of an outcome, and those of its conditional parts. `mark` tells the outcomes apart."""
    own = words.names.own
    scope, goals = known.inner(), list[Part]()
    deleted: list[Part] = []
    added: list[Part] = []
    helpers: list[Clause] = []
    earned: list[Conditional] = []
    for part in outcome.parts:
        effect = part.effect
        if isinstance(effect, Change):
            if effect.target.name == REWARD:
                earned.append(part)
            elif effect.target.name != COST and part.always and effect.operator != "assign":
                old, new = _changed(words, effect, scope, goals)
                deleted.append(old)
                added.append(new)
            elif effect.target.name != COST:
                helpers += _conditional_change(words, part, called, mark, known)
        elif part.always:
            (added if isinstance(effect, Add) else deleted).append(atom_term(words, effect.atom, scope))
        else:
            helpers.append(_conditional_fact(words, part, called, mark, known))
    if features.reward:
        old, new, more = _earned(words, earned, called, mark, known, scope, goals)
        deleted.append(old)
        added.append(new)
        helpers += more
    helpers.sort(key=lambda each: each.head.name == own["added"])  # type: ignore[union-attr]
    lists, fact = [], Var("Fact")
    for kind, facts in (("deleted", deleted), ("added", added)):
        rest = None
        if any(each.head.name == own[kind] for each in helpers):  # type: ignore[union-attr]
            rest = Var("Delete" if kind == "deleted" else "Add")
            goals.append(Term("findall", (fact, Term(own[kind], (called, *mark, fact)), rest)))
        lists.append(Items(tuple(dict.fromkeys(facts)), rest))
    chance = (Term(_plain(float(outcome.probability))),) if features.chance else ()
    return [Clause(Term("effect", (called, *chance, *lists)), tuple(goals)), *helpers]


def _plain(probability: float) -> int | float:
    return 1 if probability == 1 else probability


def _changed(words: Vocabulary, change: Change, scope: Scope, goals: list[Part]) -> tuple[Term, Term]:
    """The fact of a number and that of what becomes of it; the goals compute it."""
    name = words.names.functions[change.target.name]
    args = tuple(term(each, scope) for each in change.target.args)
    old = value(words, change.target, scope, goals)
    amount = number(words, change.amount, scope, goals)
    new = Var(f"New_{change.target.name}")
    formula = amount if change.operator == "assign" else Infix(_OPERATORS[change.operator], old, amount)
    goals.append(Infix("is", new, formula))
    return Term(name, (*args, old)), Term(name, (*args, new))


def _conditional_fact(
    words: Vocabulary, part: Conditional, called: Term, mark: tuple[Term, ...], known: Scope
) -> Clause:
    scope = known.inner()
    scope.declare(part.variables)
    goals = body(words, And(part.condition), scope)
    assert isinstance(part.effect, Add | Delete)
    kind = "added" if isinstance(part.effect, Add) else "deleted"
    head = Term(words.names.own[kind], (called, *mark, atom_term(words, part.effect.atom, scope)))
    return Clause(head, goals)


def _conditional_change(
    words: Vocabulary, part: Conditional, called: Term, mark: tuple[Term, ...], known: Scope
) -> list[Clause]:
    """What deletes the old number, if there is one, and what adds the new one."""
    change, own = part.effect, words.names.own
    assert isinstance(change, Change)
    scope = known.inner()
    scope.declare(part.variables)
    condition = body(words, And(part.condition), scope)
    assigned = change.operator == "assign"
    before, goals = scope.inner(), list[Part]()
    name = words.names.functions[change.target.name]
    args = tuple(term(each, scope) for each in change.target.args)
    old = value(words, change.target, before, goals)
    deleted = Clause(Term(own["deleted"], (called, *mark, Term(name, (*args, old)))), (*condition, *goals))
    after, goals = scope.inner(), list[Part]()
    if assigned:
        amount = number(words, change.amount, after, goals)
        new = Var(f"New_{change.target.name}")
        goals.append(Infix("is", new, amount))
        fact = Term(name, (*args, new))
    else:
        _, fact = _changed(words, change, after, goals)
    return [deleted, Clause(Term(own["added"], (called, *mark, fact)), (*condition, *goals))]


def _earned(
    words: Vocabulary,
    parts: Sequence[Conditional],
    called: Term,
    mark: tuple[Term, ...],
    known: Scope,
    scope: Scope,
    goals: list[Part],
) -> tuple[Term, Term, list[Clause]]:
    """What the last action and this one have gained, as facts, and the clauses of what depends on the state."""
    gained = words.names.own["gained"]
    old = Var("Before")
    goals.append(Term(gained, (old,)))
    total, helpers = _summed(words, parts, "rewarded", called, mark, known, scope, goals)
    if isinstance(total, Infix):
        goals.append(Infix("is", new := Var("Gained"), total))
        total = new
    return Term(gained, (old,)), Term(gained, (total,)), helpers


def _cost_clauses(words: Vocabulary, found: Sequence[Outcome], called: Term, known: Scope) -> list[Clause]:
    """What an action costs, the same whatever its outcome."""
    costs = [
        tuple(part for part in each.parts if isinstance(part.effect, Change) and part.effect.target.name == COST)
        for each in found
    ]
    if any(cost != costs[0] for cost in costs):
        message = f"the action {called.name}: a cost that is left to chance is not supported"
        raise NppgError([Problem(words.domain.file, 0, 0, message)])
    scope, goals = known.inner(), list[Part]()
    total, helpers = _summed(words, costs[0], "charged", called, (), known, scope, goals)
    if isinstance(total, Infix):
        goals.append(Infix("is", cost := Var("Cost"), total))
        total = cost
    return [Clause(Term("cost", (called, total)), tuple(goals)), *helpers]


def _summed(
    words: Vocabulary,
    parts: Iterable[Conditional],
    kind: str,
    called: Term,
    mark: tuple[Term, ...],
    known: Scope,
    scope: Scope,
    goals: list[Part],
) -> tuple[Part, list[Clause]]:
    """The sum of what is increased and decreased; that of what depends on the state is asked of clauses."""
    own = words.names.own[kind]
    total: Part = Term(0)
    helpers: list[Clause] = []
    for part in parts:
        change = part.effect
        assert isinstance(change, Change)
        problem = ""
        if part.variables:
            problem = "is not supported inside a forall"
        elif change.operator not in ("increase", "decrease"):
            problem = "can only be increased and decreased"
        if problem:
            message = f"the action {called.name}: ({change.target.name}) {problem}"
            raise NppgError([Problem(words.domain.file, 0, 0, message)])
        if part.always:
            total = _plus(total, change.operator, number(words, change.amount, scope, goals))
            continue
        inner = known.inner()
        condition = body(words, And(part.condition), inner)
        if any(isinstance(goal, Choice) for goal in condition):
            condition = (Once(condition),)
        more = list[Part]()
        amount = _plus(Term(0), change.operator, number(words, change.amount, inner, more))
        if isinstance(amount, Infix):
            more.append(Infix("is", computed := Var("Amount"), amount))
            amount = computed
        helpers.append(Clause(Term(own, (called, *mark, amount)), (*condition, *more)))
    if helpers:
        amount, more_amount = Var("Amount"), Var("More")
        goals.append(Term("aggregate_all", (Term("sum", (amount,)), Term(own, (called, *mark, amount)), more_amount)))
        total = _plus(more_amount, "increase", total) if total != Term(0) else more_amount
    return total, helpers


def _plus(total: Part, operator: str, amount: Part) -> Part:
    zero = total == Term(0)
    negated = Term(-amount.name) if isinstance(amount, Term) and not isinstance(amount.name, str) else None
    if zero:
        return amount if operator == "increase" else negated or Infix("-", total, amount)
    if operator == "increase" and negated and negated.name > 0:  # type: ignore[operator]
        return Infix("-", total, negated)
    return Infix("+" if operator == "increase" else "-", total, amount)
