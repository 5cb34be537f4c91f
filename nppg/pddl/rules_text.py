"""The rules of derived predicates as clauses."""

from __future__ import annotations

from collections.abc import Iterator

from nppg.pddl.bodies import Scope, Vocabulary, body
from nppg.pddl.clauses import Clause, Term
from nppg.pddl.model import Derived, Domain, Exists, Formula, Or
from nppg.pddl.normal import atoms, simplified


def recursive(domain: Domain) -> set[str]:
    """The derived predicates that ask themselves, if only by way of others."""
    asks: dict[str, set[str]] = {}
    for rule in domain.derived:
        asks.setdefault(rule.name, set()).update(each.name for each in atoms(rule.body))
    for middle in asks:
        for name, asked in asks.items():
            if middle in asked:
                asks[name] = asked | asks[middle]
    return {name for name, asked in asks.items() if name in asked}


def rule_clauses(words: Vocabulary, rule: Derived) -> Iterator[Clause]:
    """A clause for each alternative of a rule's body."""
    for alternative in _alternatives(simplified(rule.body)):
        scope = Scope()
        args = scope.declare(rule.parameters)
        goals = body(words, alternative, scope, inline=True)
        yield Clause(Term(words.names.predicates[rule.name], tuple(args)), goals)


def _alternatives(formula: Formula) -> list[Formula]:
    if isinstance(formula, Or):
        return [inner for part in formula.parts for inner in _alternatives(part)]
    if isinstance(formula, Exists):
        return [Exists(formula.variables, inner) for inner in _alternatives(formula.part)]
    return [formula]
