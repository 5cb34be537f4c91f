"""θ-subsumption, and normal forms of queries up to it."""

from __future__ import annotations

from itertools import permutations

from nppg.logic.query import (
    OPEN,
    Literal,
    Query,
    Term,
    Var,
    components,
    implies,
    solve_equalities,
    substitute,
    tightened,
    variables,
)


def subsumes(general: Query, special: Query, roots: int) -> bool:
    """Whether `general` θ-subsumes `special`: some substitution of its existential variables maps every
    literal of `general` into `special`, or to a bound that one of `special` implies."""
    by_name: dict[tuple[str, int], list[Literal]] = {}
    for literal in special:
        by_name.setdefault((literal.name, len(literal.args)), []).append(literal)

    def match(position: int, theta: dict[Var, Term]) -> bool:
        if position == len(general):
            return True
        name, args = general[position]
        terms = args[:1] if name in OPEN else args
        for candidate in by_name.get((name, len(args)), ()):
            if name in OPEN and not implies(candidate, Literal(name, (candidate.args[0], args[1]))):
                continue
            extended = dict(theta)
            for arg, target in zip(terms, candidate.args, strict=False):
                if isinstance(arg, Var) and arg.index >= roots:
                    if extended.setdefault(arg, target) != target:
                        break
                elif arg != target or type(arg) is not type(target):
                    break
            else:
                if match(position + 1, extended):
                    return True
        return False

    return match(0, {})


def reduced(query: Query, roots: int) -> Query:
    """The query without duplicates and without literals that θ-subsumption makes redundant (Plotkin's
    reduction)."""
    kept = list(tightened(query))
    for literal in reversed(list(kept)):
        if any(var.index >= roots for var in literal.variables()):
            rest = [other for other in kept if other != literal]
            if subsumes(tuple(kept), tuple(rest), roots):
                kept = rest
    return tuple(kept)


def _sort_key(literal: Literal) -> tuple:
    return (
        literal.name,
        tuple(
            (0, arg.index, "") if isinstance(arg, Var) else (1, 0, f"{type(arg).__name__} {arg}")
            for arg in literal.args
        ),
    )


def canonical(query: Query, roots: int) -> Query:
    """Renames the existential variables so that queries which differ only by their names and by the order of
    literals become equal as sets. The order stays: a literal may need the variables that an earlier one binds.
    Exact for up to six existential variables; beyond that variables keep their order of occurrence, so equal
    queries may then be told apart but never confused."""
    existential = sorted(var for var in variables(query) if var.index >= roots)
    if not existential:
        return tuple(dict.fromkeys(query))
    names = [Var(roots + i) for i in range(len(existential))]
    orders = permutations(existential) if len(existential) <= 6 else [tuple(existential)]
    renamed = (substitute(query, dict(zip(order, names, strict=True))) for order in orders)
    return tuple(dict.fromkeys(min(renamed, key=lambda each: sorted(map(_sort_key, set(each))))))


def normal_form(query: Query, roots: int) -> Query | None:
    """Equalities solved, redundancies removed, variables renamed: for θ-equivalent queries equal as sets.

    Equalities between root variables stay as literals. Returns None for a query that cannot be true.
    """
    theta, solvable = solve_equalities(query, roots)
    if not solvable:
        return None
    kept = [Literal("=", (term, var)) for var, term in sorted(theta.items()) if var.index < roots]
    rest = substitute((literal for literal in query if literal.name != "="), theta)
    return canonical(reduced((*kept, *rest), roots), roots)


def deciding_tests(query: Query, literals: Query, roots: int) -> tuple[Query, ...]:
    """The tests, in normal form, that all hold exactly if `query` still does when `literals` are added to it.

    Raises ValueError where the literals contradict the query.
    """
    own = [part for part in components(query + literals, roots) if any(each in literals for each in part)]
    forms = [normal_form(part, roots) for part in own]
    if None in forms:
        raise ValueError("the tests contradict each other")
    return tuple(form for form in forms if form is not None)
