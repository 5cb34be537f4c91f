"""The head of a domain file: what it is about, and its declarations."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from pathlib import Path

from nppg.bias.names import atom, written
from nppg.pddl.bodies import Vocabulary
from nppg.pddl.changing import changed_functions, derived, fluents, symbols_of
from nppg.pddl.clauses import WIDTH, Clause, Term, variable_name
from nppg.pddl.effects_text import Features
from nppg.pddl.hierarchy import all_types
from nppg.pddl.model import OBJECT, Domain, Symbol
from nppg.pddl.names import APART
from nppg.pddl.rules_text import recursive


def opening(words: Vocabulary, wanted: list[Symbol], does: Features, clauses: list[Clause], has_object: bool) -> str:
    """The head of the file and its declarations. `has_object`: the type object is declared."""
    domain, names = words.domain, words.names
    changing, ruled = fluents(domain), derived(domain)
    static = [
        _indicator(names.predicates[each.name], len(each.parameters))
        for each in symbols_of(domain)
        if each.name not in changing | ruled
    ]
    fluent = [
        _indicator(names.predicates[each.name], len(each.parameters))
        for each in symbols_of(domain)
        if each.name in changing
    ]
    for function in domain.functions:
        if function.name not in APART:
            group = fluent if function.name in changed_functions(domain) else static
            group.append(_indicator(names.functions[function.name], len(function.parameters) + 1))
    types = [*all_types(domain)]
    if has_object:
        types.append(OBJECT)
    static = [_indicator(names.types[type_], 1) for type_ in types] + static
    static += [_indicator(names.goal[each.name], len(each.parameters)) for each in wanted]
    static += [f"{names.own['goals']}/1", f"{names.own['condition']}/1"]
    if does.reward:
        static.append(f"{names.own['goal_reward']}/1")
        fluent.append(f"{names.own['gained']}/1")
    head = [f":- pddl({written(Path(domain.file).name)}).", _declaration("static", static)]
    head += [_declaration("fluent", fluent)] if fluent else []
    head.append(":- dead_ends.")
    apart = _apart(clauses)
    head += [_declaration("discontiguous", apart)] if apart else []
    tabled = [
        _indicator(names.predicates[each.name], len(each.parameters))
        for each in symbols_of(domain)
        if each.name in recursive(domain)
    ]
    head += [_declaration("table", tabled)] if tabled else []
    comment = _comment(words, wanted)
    return "\n\n".join([f":- module({written(module_name(domain))}, []).", comment, "\n".join(head)])


def module_name(domain: Domain) -> str:
    """What the domain is called in Prolog."""
    name = "".join(char if char.isascii() and char.isalnum() else "_" for char in domain.name).strip("_")
    return name if name[:1].isalpha() else f"domain_{name}".rstrip("_")


def _comment(words: Vocabulary, wanted: list[Symbol]) -> str:
    names, own = words.names, words.names.own
    text = f"The PDDL domain {words.domain.name}. What no action changes is static: it belongs to the problem."
    if wanted:
        first = wanted[0]
        args = [variable_name(each.name) for each in first.parameters]
        now, goal = atom(names.predicates[first.name], args), atom(names.goal[first.name], args)
        text += f" So do its goals: {goal} says that {now} is wanted, {own['condition']}/1 has what is wanted beyond"
        text += f" such facts, and {own['goals']}/1 says how many literals that is in all."
    return "\n".join(f"% {line}" for line in textwrap.wrap(text, WIDTH - 2))


def _indicator(name: str, arity: int) -> str:
    return f"{name}/{arity}"


def _declaration(kind: str, indicators: Iterable[str]) -> str:
    """A directive, with line breaks where it is long."""
    lines = [f":- {kind} "]
    for indicator in indicators:
        if len(lines[-1]) + len(indicator) + 2 > WIDTH:
            lines.append("     ")
        lines[-1] += f"{indicator}, "
    return "\n".join(line.rstrip() for line in lines).removesuffix(",") + "."


def _apart(clauses: Iterable[Clause]) -> list[str]:
    """The predicates whose clauses do not stand together."""
    last, closed, apart = "", set[str](), dict[str, None]()
    for clause in clauses:
        assert isinstance(clause.head, Term)
        indicator = _indicator(str(clause.head.name), len(clause.head.args))
        if indicator != last and indicator in closed:
            apart[indicator] = None
        closed.add(indicator)
        last = indicator
    return list(apart)
