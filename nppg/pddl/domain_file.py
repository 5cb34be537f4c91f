"""The domain that a PDDL document defines."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from nppg.pddl.declarations import hierarchy, name, objects, symbols, variables
from nppg.pddl.effects import effect
from nppg.pddl.formulas import Scope, precondition
from nppg.pddl.model import OBJECT, Action, Derived, Domain, Symbol, Typed
from nppg.pddl.sections import by_keyword, definition, keywords, requirements
from nppg.pddl.stratification import negative_cycle
from nppg.pddl.tokens import Document, Group, Node, Word, head
from nppg.pddl.vocabulary import PREDECLARED, Vocabulary

SECTIONS = (":requirements", ":types", ":constants", ":predicates", ":functions", ":derived", ":action", ":actions")
REFUSED = {
    ":durative-action": ":durative-actions",
    ":process": ":continuous-effects",
    ":event": ":continuous-effects",
    ":constraints": ":constraints",
    ":axiom": "write it as (:derived (name ?x) condition)",
    ":method": "",
    ":task": "",
    ":observe": "",
    ":sensor": "",
    ":timeless": "",
    ":safety": "",
}
PARTS = (":parameters", ":precondition", ":effect")
REFUSED_PARTS = {
    ":duration": ":durative-actions",
    ":condition": ":durative-actions",
    ":vars": "write them as parameters",
    ":observe": "",
    ":expansion": "",
    ":agent": "",
}


def domain_of(document: Document) -> Domain:
    """What the document defines. Raises NppgError with all its mistakes."""
    label, _, sections = definition(document, "domain")
    found = by_keyword(document, sections, SECTIONS, REFUSED, (":requirements", ":action", ":derived", ":actions"))
    required = requirements(document, found[":requirements"])
    types = hierarchy(document, _items(found[":types"]))
    constants = tuple(each for _, each in objects(document, types, _items(found[":constants"]), "constant"))
    predicates = symbols(document, types, _items(found[":predicates"]), "predicate")
    functions = symbols(document, types, _items(found[":functions"]), "function")
    functions |= _predeclared({*functions, *predicates}, required, found[":action"])
    heads = {head(each.items[1]) for each in found[":derived"] if len(each.items) > 1}
    vocabulary = Vocabulary(
        types, predicates, functions, {each.name: each.types for each in constants}, heads & set(predicates)
    )
    scope = Scope(document, vocabulary)
    derived = _all_derived(found[":derived"], scope)
    actions = _all_actions(found[":action"], scope)
    document.finish()
    return Domain(
        document.file,
        label,
        required,
        types.parents,
        constants,
        tuple(predicates.values()),
        tuple(functions.values()),
        derived,
        actions,
        document.source,
    )


def _items(sections: Sequence[Group]) -> list[Node]:
    return [node for section in sections for node in section.items[1:]]


def _predeclared(declared: Collection[str], required: Sequence[str], actions: Sequence[Group]) -> dict[str, Symbol]:
    """The functions that are there without a declaration, where they are required or used."""
    wanted = set()
    if ":action-costs" in required:
        wanted.add("total-cost")
    if ":rewards" in required or ":mdp" in required:
        wanted.add("reward")
    left: list[Node] = list(actions)
    while left:
        node = left.pop()
        if isinstance(node, Group):
            left += node.items
        else:
            wanted.add(node.text)
    return {key: symbol for key, symbol in PREDECLARED.items() if key in wanted and key not in declared}


def _all_derived(sections: Sequence[Group], scope: Scope) -> tuple[Derived, ...]:
    """The rules of the derived predicates."""
    found = [(each, rule) for each in sections if (rule := _derived(each, scope))]
    cycle = negative_cycle([rule for _, rule in found])
    if cycle:
        place = next(each for each, rule in found if rule.name == cycle[0])
        scope.report(place, f"derived through its own negation: {', '.join(cycle)}")
    return tuple(rule for _, rule in found)


def _derived(section: Group, scope: Scope) -> Derived | None:
    if len(section.items) != 3 or not isinstance(section.items[1], Group) or not head(section.items[1]):
        scope.report(section, "a derived predicate is given like (:derived (name ?x - type) condition)")
        return None
    atom, body = section.items[1:]
    assert isinstance(atom, Group)
    label = head(atom)
    parameters = variables(scope.document, scope.vocabulary.types, Group(atom.at, atom.items[1:]))
    symbol = scope.vocabulary.predicates.get(label)
    if symbol is None:
        hint = scope.document.hint(label, scope.vocabulary.predicates)
        scope.report(atom, f"the derived predicate '{label}' is not among the predicates{hint}")
    elif len(symbol.parameters) != len(parameters):
        scope.report(atom, f"{label}/{len(symbol.parameters)} is derived with {len(parameters)} parameters")
    else:
        parameters = tuple(map(_narrowed, parameters, symbol.parameters))
        for given, wanted in zip(parameters, symbol.parameters, strict=True):
            if not scope.vocabulary.types.overlap(given.types, wanted.types):
                types = " or ".join(given.types), " or ".join(wanted.types)
                scope.report(atom, f"{given.name} is of type {types[0]}; {label} is declared with type {types[1]}")
    return Derived(label, parameters, precondition(body, scope.within(parameters)))


def _narrowed(given: Typed, declared: Typed) -> Typed:
    """A parameter without a type has that of the predicate's declaration."""
    return Typed(given.name, declared.types) if given.types == (OBJECT,) else given


def _all_actions(sections: Sequence[Group], scope: Scope) -> tuple[Action, ...]:
    found: dict[str, tuple[Group, Action]] = {}
    for section in sections:
        action = _action(section, scope)
        if action is not None and action.name in found:
            line = scope.document.place(found[action.name][0].at)[0]
            scope.report(section, f"the action '{action.name}' is declared twice (first on line {line})")
        elif action is not None:
            found[action.name] = section, action
    return tuple(action for _, action in found.values())


def _action(section: Group, scope: Scope) -> Action | None:
    nodes = section.items[1:]
    if not nodes or not isinstance(nodes[0], Word) or nodes[0].text.startswith(":"):
        scope.report(nodes[0] if nodes else section, "the name of an action is wanted")
        return None
    label = name(scope.document, nodes[0], "an action")
    parts = keywords(scope.document, nodes[1:], PARTS, REFUSED_PARTS, f"the action '{nodes[0].text}'")
    parameters = variables(scope.document, scope.vocabulary.types, parts.get(":parameters"))
    within = scope.within(parameters)
    condition, change = precondition(parts.get(":precondition"), within), effect(parts.get(":effect"), within)
    return None if label is None else Action(label, parameters, condition, change)
