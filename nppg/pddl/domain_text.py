"""A PDDL domain as a domain file, such as a person could have written."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from nppg.bias.names import atom, written
from nppg.errors import NppgError, Problem
from nppg.pddl.bodies import Scope, Vocabulary, body
from nppg.pddl.changing import changed_functions, derived, fluents
from nppg.pddl.clauses import Clause, Infix, Negated, Part, Term, Var, clause_text, parts, variable_name
from nppg.pddl.effects_text import Features, action_clauses, features
from nppg.pddl.hierarchy import all_types
from nppg.pddl.model import OBJECT, Derived, Domain, Exists, Formula, Or, Symbol
from nppg.pddl.names import APART, Names
from nppg.pddl.normal import atoms, simplified

_WIDTH = 120
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
    sections = [(action.name, action_clauses(words, action, does)) for action in domain.actions]
    rules = [clause for rule in domain.derived for clause in _rule_clauses(words, rule)]
    sections_text = [_section(name, clauses) for name, clauses in sections]
    if rules:
        sections_text.insert(0, "\n".join(map(clause_text, rules)))
    sections_text.append("\n".join(map(clause_text, _end_clauses(words, wanted, does))))
    if wanted:
        sections_text.append(_section("what is left to do, and what is done", _versions(words, wanted)))
    clauses = [*rules, *(clause for _, group in sections for clause in group)]
    return "\n\n".join([_opening(words, wanted, does, clauses), *sections_text]) + "\n"


def declares_object(domain: Domain, names: Names) -> bool:
    """Whether the domain file has facts of which all objects there are: where something in it ranges over them."""
    if not all_types(domain) or _QUANTIFIERS & set(domain.requirements):
        return True
    words = Vocabulary(domain, names)
    does = features(domain)
    clauses = [clause for action in domain.actions for clause in action_clauses(words, action, does)]
    clauses += [clause for rule in domain.derived for clause in _rule_clauses(words, rule)]
    return _asks_object(names, clauses)


def _asks_object(names: Names, clauses: Iterable[Clause]) -> bool:
    return any(
        isinstance(part, Term) and part.name == names.types[OBJECT] and len(part.args) == 1
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


def symbols_of(domain: Domain) -> list[Symbol]:
    """The predicates with their parameters, those of rules that are not declared among them."""
    found = {each.name: each for each in domain.predicates}
    for rule in domain.derived:
        found.setdefault(rule.name, Symbol(rule.name, rule.parameters))
    return list(found.values())


def _section(title: str, clauses: Iterable[Clause]) -> str:
    return "\n".join([f"% {title}", *map(clause_text, clauses)])


def _opening(words: Vocabulary, wanted: list[Symbol], does: Features, clauses: list[Clause]) -> str:
    """The head of the file and its declarations."""
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
    if declares_object(domain, names):
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
    return "\n".join(f"% {line}" for line in textwrap.wrap(text, _WIDTH - 2))


def _indicator(name: str, arity: int) -> str:
    return f"{name}/{arity}"


def _declaration(kind: str, indicators: Iterable[str]) -> str:
    """A directive, with line breaks where it is long."""
    lines = [f":- {kind} "]
    for indicator in indicators:
        if len(lines[-1]) + len(indicator) + 2 > _WIDTH:
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


def _rule_clauses(words: Vocabulary, rule: Derived) -> Iterator[Clause]:
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
