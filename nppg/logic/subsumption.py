"""θ-subsumption, and normal forms of queries up to it."""

from __future__ import annotations

from itertools import chain, groupby, permutations, product
from math import factorial, prod

from nppg.logic.query import (
    OPEN,
    Literal,
    Query,
    Term,
    Var,
    implies,
    solve_equalities,
    substitute,
    tightened,
    variables,
)

_ORDERS = 720  # of variables that cannot be told apart: at most so many are tried


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
    kept = tightened(query)
    names = [literal.name for literal in kept]
    if len(set(names)) == len(names):
        return kept
    places = places_of(kept)
    for literal in reversed(kept):
        if names.count(literal.name) > 1 and any(may_map(literal, other, places, roots) for other in kept):
            rest = tuple(other for other in kept if other != literal)
            if subsumes(kept, rest, roots):
                kept, places = rest, places_of(rest)
    return kept


Places = dict[Term, set[tuple[str, int]]]


def places_of(query: Query) -> Places:
    """Where each term of a query stands: the predicates, and which of their arguments it is."""
    places: Places = {}
    for name, args in query:
        for position, arg in enumerate(args[:1] if name in OPEN else args):
            places.setdefault(arg, set()).add((name, position))
    return places


def may_map(general: Literal, special: Literal, places: Places, roots: int) -> bool:
    """Whether a substitution of existential variables may map one literal to another one, by the places where the terms
    of both stand."""
    (name, args), (other, targets) = general, special
    if name != other or len(args) != len(targets) or args == targets:
        return False
    for arg, target in zip(args[:1] if name in OPEN else args, targets, strict=False):
        free = isinstance(arg, Var) and arg.index >= roots and places[arg] <= places[target]
        if not free and (arg != target or type(arg) is not type(target)):
            return False
    return True


def canonical(query: Query, roots: int) -> Query:
    """Renames the existential variables so that queries which differ only by their names and by the order of
    literals become equal as sets. The order stays: a literal may need the variables that an earlier one binds.
    Variables are told apart by where they stand and beside what; of those that cannot be, all orders are tried, up to a
    limit beyond which equal queries may be told apart but are never confused."""
    query = tuple(dict.fromkeys(query))
    existential = [var for var in variables(query) if var.index >= roots]
    names = [Var(roots + i) for i in range(len(existential))]
    classes = _told_apart(query, existential)
    if len(classes) == len(existential) or prod(factorial(len(each)) for each in classes) > _ORDERS:
        found = list(chain(*classes))
        return query if found == names else substitute(query, dict(zip(found, names, strict=True)))
    orders = (chain(*order) for order in product(*map(permutations, classes)))
    renamed = (substitute(query, dict(zip(order, names, strict=True))) for order in orders)
    return min(renamed, key=lambda each: sorted((literal.name, *map(_term_key, literal.args)) for literal in each))


def _term_key(term: Term) -> tuple[int, int, str]:
    return (0, term.index, "") if isinstance(term, Var) else (1, 0, f"{type(term).__name__} {term}")


def _told_apart(query: Query, existential: list[Var]) -> list[list[Var]]:
    """The variables in classes, in an order that does not depend on their names: by the places where they stand, and by
    the classes of the variables that stand beside them (colour refinement)."""
    if len(existential) < 2:
        return [existential] if existential else []
    colours: dict[Term, tuple[int, int, str]] = dict.fromkeys(existential, (2, 0, ""))
    known = 1
    while True:
        places: dict[Term, list[tuple]] = {var: [] for var in existential}
        for name, args in query:
            beside = tuple([colours[arg] if arg in colours else _term_key(arg) for arg in args])
            for position, arg in enumerate(args):
                if arg in places:
                    twice = tuple([other == arg for other in args]) if args.count(arg) > 1 else ()
                    places[arg].append((name, position, twice, beside))
        kinds = [(colours[var], sorted(places[var])) for var in existential]
        ordered = [kind for kind, _ in groupby(sorted(kinds))]
        colours = {var: (2, ordered.index(kind), "") for var, kind in zip(existential, kinds, strict=True)}
        if len(ordered) in (known, len(existential)):
            return [[var for var in existential if colours[var][1] == colour] for colour in range(len(ordered))]
        known = len(ordered)


def normal_form(query: Query, roots: int) -> Query | None:
    """Equalities solved, redundancies removed, variables renamed: for θ-equivalent queries equal as sets. It is what
    the forms of logic.forms, which are put together from parts, are held to.

    Equalities between root variables stay as literals. Returns None for a query that cannot be true.
    """
    found = simplified(query, roots)
    return None if found is None else canonical(found, roots)


def simplified(query: Query, roots: int) -> Query | None:
    """The normal form but for the names of variables."""
    if any(literal.name == "=" for literal in query):
        theta, solvable = solve_equalities(query, roots)
        if not solvable:
            return None
        kept = [Literal("=", (term, var)) for var, term in sorted(theta.items()) if var.index < roots]
        query = (*kept, *substitute((literal for literal in query if literal.name != "="), theta))
    return reduced(query, roots)
