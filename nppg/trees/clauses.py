"""Rules as Prolog clauses: delta(Tree, Action, Value) :- Goal, Literals, !.

What a rule says by equalities is written by sharing variables between the action, the goal and the literals.
Variables cross the bridge as numbers, constants in a list of one.
"""

from __future__ import annotations

import sys
from functools import lru_cache

from nppg.bias.declarations import Template
from nppg.bias.language_bias import LanguageBias
from nppg.bias.refinement import KIND
from nppg.bridge.terms import encoded
from nppg.logic.query import OPEN, Literal, Term, Var, constant, solve_equalities, substitute, tightened
from nppg.trees.tree import Rule

ClauseData = list
ArgumentData = int | list


def to_clause(rule: Rule, bias: LanguageBias) -> ClauseData:
    """[number of variables, head, body, value] for prolog/potential.pl."""
    theta, _ = solve_equalities(rule.query, len(bias.roots))
    kinds = [int(str(literal.args[0])) for literal in rule.query if literal.name == KIND]
    kinds = kinds or ([0] if len(bias.actions) == 1 else [])
    body = tightened(substitute((each for each in rule.query if each.name not in ("=", KIND)), theta))
    if bias.goal:
        goal = _literal(bias.goal, bias.offsets[-1])
        own = set(goal.args)
        shared = own.intersection(theta) or own.intersection(theta.values())
        if shared or any(each.name == goal.name or own.intersection(each.args) for each in body):
            body = (*substitute([goal], theta), *body)
    head = substitute((_literal(bias.actions[kind], bias.offsets[kind]) for kind in kinds), theta)
    numbers = [var.index for literal in (*head, *body) for var in literal.variables()]
    data = encoded(head + body)
    return [max(numbers, default=-1) + 1, data[0] if head else [], data[len(head) :], rule.value]


@lru_cache(maxsize=64)
def _literal(template: Template, offset: int) -> Literal:
    return Literal(template.name, tuple(Var(offset + i) for i in range(len(template.types))))


def from_clause(head: list, body: list[list], value: float, bias: LanguageBias) -> Rule:
    """The rule of a clause. Raises ValueError for what the bias does not declare."""
    for name, *args in [head, *body] if head else body:
        constants = [arg[0] for arg in args if isinstance(arg, list)]
        if not isinstance(name, str) or not all(isinstance(each, str | int | float) for each in constants):
            raise ValueError("a literal has a name, and constants and variables as arguments")
    terms: dict[int, Term] = {}
    query: list[Literal] = []

    def bind(args: list[ArgumentData], offset: int) -> None:
        for i, arg in enumerate(args):
            root = Var(offset + i)
            if isinstance(arg, list):
                query.append(Literal("=", (root, constant(arg[0]))))
            elif arg in terms:
                query.append(Literal("=", (terms[arg], root)))
            else:
                terms[arg] = root

    def read(name: str, args: list[ArgumentData]) -> tuple[Term, ...]:
        fresh = len(bias.roots) + sum(var.index >= len(bias.roots) for var in terms.values() if isinstance(var, Var))
        for arg in args:
            if not isinstance(arg, list) and arg not in terms:
                terms[arg] = Var(fresh)
                fresh += 1
        given = (lambda number: number) if name in OPEN else constant
        return tuple(given(arg[0]) if isinstance(arg, list) else terms[arg] for arg in args)

    if head:
        name, *args = head
        kind = next(
            (k for k, each in enumerate(bias.actions) if (each.name, len(each.types)) == (name, len(args))), None
        )
        if kind is None:
            raise ValueError(f"{name}/{len(args)} is no declared action")
        if len(bias.actions) > 1:
            query.append(Literal(KIND, (kind,)))
        bind(args, bias.offsets[kind])
    if bias.goal and body and (body[0][0], len(body[0]) - 1) == (bias.goal.name, len(bias.goal.types)):
        bind(body[0][1:], bias.offsets[-1])
        body = body[1:]
    for name, *args in body:
        if name in OPEN and len(args) == 2:
            known = _is_finite(args[0]) or (not isinstance(args[0], list) and args[0] in terms)
            if not (known and _is_finite(args[1])):
                raise ValueError(f"a bound is a variable from before, {name} and a finite number")
        elif bias.types_of(name, len(args)) is None:
            raise ValueError(f"{name}/{len(args)} is no declared predicate")
        query.append(Literal(name, read(name, args)))
    if not abs(value) <= sys.float_info.max:
        raise ValueError("the value of a rule is a finite number")
    return Rule(tuple(query), float(value))


def _is_finite(arg: ArgumentData) -> bool:
    """Whether an argument is a number that can be a threshold, to the bit."""
    match arg:
        case [int(number)] | [float(number)]:
            return abs(number) <= sys.float_info.max and float(number) == number
    return False
