"""A PDDL domain as a domain file, such as a person could have written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from nppg.errors import NppgError, Problem
from nppg.pddl.bodies import Vocabulary
from nppg.pddl.changing import symbols_of
from nppg.pddl.clauses import Clause, Infix, Negated, Part, Term, Var, clause_text, parts
from nppg.pddl.effects_text import Features, action_clauses, features
from nppg.pddl.hierarchy import all_types
from nppg.pddl.model import OBJECT, Domain, Symbol
from nppg.pddl.names import Names
from nppg.pddl.opening_text import opening
from nppg.pddl.rules_text import rule_clauses

_QUANTIFIERS = {":adl", ":quantified-preconditions", ":universal-preconditions", ":existential-preconditions"}


def domain_text(
    domain: Domain, names: Names, goal_predicates: Iterable[str], sizes: Mapping[str, float] | None = None
) -> str:
    """The text of the domain file. `goal_predicates`: those of which a goal fact says what is wanted; `sizes`: how many
    facts of a predicate an initial state has.

    Raises NppgError for what is not supported, naming it."""
    words = Vocabulary(domain, names, sizes or {})
    wanted = _wanted(domain, goal_predicates)
    does = features(domain)
    rules, actions = _rules(words), _actions(words, does)
    clauses = [*rules, *(clause for group in actions.values() for clause in group)]
    sections = [opening(words, wanted, does, clauses, _has_object(words, clauses))]
    sections += ["\n".join(map(clause_text, rules))] if rules else []
    sections += [_section(name, group) for name, group in actions.items()]
    sections.append("\n".join(map(clause_text, _end_clauses(words, wanted, does))))
    if wanted:
        sections.append(_section("what is left to do, and what is done", _versions(words, wanted)))
    return "\n\n".join(sections) + "\n"


def declares_object(domain: Domain, names: Names) -> bool:
    """Whether the domain file has facts of which all objects there are: where something in it, or a goal, may range
    over them."""
    words = Vocabulary(domain, names)
    actions = _actions(words, features(domain))
    return _has_object(words, [*_rules(words), *(clause for group in actions.values() for clause in group)])


def _rules(words: Vocabulary) -> list[Clause]:
    return [clause for rule in words.domain.derived for clause in rule_clauses(words, rule)]


def _actions(words: Vocabulary, does: Features) -> dict[str, list[Clause]]:
    return {action.name: action_clauses(words, action, does) for action in words.domain.actions}


def _has_object(words: Vocabulary, clauses: Iterable[Clause]) -> bool:
    if not all_types(words.domain) or _QUANTIFIERS & set(words.domain.requirements):
        return True
    asked = words.names.types[OBJECT]
    return any(
        isinstance(part, Term) and part.name == asked and len(part.args) == 1
        for clause in clauses
        for part in parts(clause)
    )


def _wanted(domain: Domain, goal_predicates: Iterable[str]) -> list[Symbol]:
    """The goal's predicates, in the order of their declarations."""
    chosen = set(goal_predicates)
    symbols = symbols_of(domain)
    unknown = chosen - {each.name for each in symbols}
    if unknown:
        raise NppgError([Problem(domain.file, 0, 0, f"there is no predicate {name}") for name in sorted(unknown)])
    return [each for each in symbols if each.name in chosen]


def _section(title: str, clauses: Iterable[Clause]) -> str:
    return "\n".join([f"% {title}", *map(clause_text, clauses)])


def _end_clauses(words: Vocabulary, wanted: list[Symbol], does: Features) -> Iterator[Clause]:
    """The goal, the horizon and the reward."""
    names, own = words.names, words.names.own
    goals: list[Part] = []
    variables: dict[str, Var] = {}  # the same in several negations, which bind none
    for symbol in wanted:
        args = tuple(variables.setdefault(each.name, Var(each.name)) for each in symbol.parameters)
        asked = Term(names.predicates[symbol.name], args)
        goals.append(Negated((Term(names.goal[symbol.name], args), Negated((asked,)))))
    formula = Var("Formula")
    goals.append(Negated((Term(own["condition"], (formula,)), Negated((Term("holds", (formula,)),)))))
    yield Clause(Term("goal"), tuple(goals))
    steps, count = Var("Steps"), Var("Count")
    length = Infix("+", Infix("*", Term(8), count), Term(10))
    yield Clause(Term("horizon", (steps,)), (Term(own["goals"], (count,)), Infix("is", steps, length)))
    if does.reward:
        gained, reward, more = Var("Gained"), Var("Reward"), Var("More")
        head, before = Term("reward", (Var("Action"), reward)), Term(own["gained"], (gained,))
        sum_of_both = Infix("is", reward, Infix("+", gained, more))
        yield Clause(head, (Term("goal"), before, Term(own["goal_reward"], (more,)), sum_of_both))
        yield Clause(Term("reward", (Var("Action"), gained)), (Negated((Term("goal"),)), before))


def _versions(words: Vocabulary, wanted: list[Symbol]) -> Iterator[Clause]:
    names = words.names
    for symbol in wanted:
        args = tuple(Var(each.name) for each in symbol.parameters)
        goal, now = Term(names.goal[symbol.name], args), Term(names.predicates[symbol.name], args)
        yield Clause(Term(names.todo[symbol.name], args), (goal, Negated((now,))))
        yield Clause(Term(names.done[symbol.name], args), (goal, now))
