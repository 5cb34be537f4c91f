"""The problem that a PDDL document defines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nppg.errors import suggestion
from nppg.pddl.declarations import objects
from nppg.pddl.formulas import Scope, atom, expression, mistyped, misused, precondition, value, whole_number
from nppg.pddl.model import Atom, Domain, Formula, Metric, Number, Or, PlanningProblem, Symbol, Typed, Value
from nppg.pddl.sections import by_keyword, definition, requirements
from nppg.pddl.tokens import Document, Group, Node, Word, described, head
from nppg.pddl.vocabulary import PREDECLARED, Types, Vocabulary

SECTIONS = (":domain", ":requirements", ":objects", ":init", ":goal", ":goal-reward", ":metric", ":length")
REFUSED = {
    ":constraints": ":constraints",
    ":situation": "",
    ":horizon": "",
    ":discount": "",
    ":htn": "",
    ":goals": "write one (:goal (and ...))",
}
REFUSED_IN_INIT = {
    "probabilistic": "a random initial state",
    "oneof": "a random initial state",
    "unknown": "an unknown initial state",
    "or": "an unknown initial state",
    "forall": "",
    "when": "",
}
FALSE = Or(())
TOTAL_TIME = Symbol("total-time", ())


def problem_of(document: Document, domain: Domain) -> PlanningProblem:
    """What the document defines. Raises NppgError with all its mistakes."""
    label, whole, sections = definition(document, "problem")
    found = by_keyword(document, sections, SECTIONS, REFUSED, (":requirements",))
    _check_domain(document, found[":domain"], whole, domain)
    requirements(document, found[":requirements"])
    types = Types(domain.types)
    declared = _objects(document, types, found[":objects"], domain)
    functions = {**PREDECLARED, **{each.name: each for each in domain.functions}}
    vocabulary = Vocabulary(
        types,
        {each.name: each for each in domain.predicates},
        functions,
        {each.name: each.types for each in (*domain.constants, *declared)},
        {each.name for each in domain.derived},
        "object",
    )
    scope = Scope(document, vocabulary)
    for key in (":init", ":goal"):
        if not found[key] and not (key == ":goal" and found[":metric"]):
            document.problems.add(
                document.fail(document.source.find("("), f"the problem has no ({key} ...)").problems[0]
            )
    init, values = _init([node for section in found[":init"] for node in section.items[1:]], scope)
    kept = {each.name for each in domain.functions}
    goal = _goal(found[":goal"], scope)
    metric = _metric(found[":metric"], scope)
    reward = _goal_reward(found[":goal-reward"], scope)
    document.finish()
    return PlanningProblem(
        document.file,
        label,
        domain.name,
        declared,
        init,
        tuple((each, number) for each, number in values.items() if each.name in kept),
        goal,
        metric,
        reward,
        document.place(found[":goal"][0].at) if found[":goal"] else (0, 0),
    )


def _check_domain(document: Document, sections: Sequence[Group], whole: Group, domain: Domain) -> None:
    """Reports a problem that belongs to another domain or to none."""
    if not sections:
        document.report(whole, f"the problem has no (:domain {domain.name})")
        return
    nodes = sections[0].items[1:]
    if len(nodes) != 1 or not isinstance(nodes[0], Word):
        document.report(sections[0], f"(:domain {domain.name}) is wanted")
    elif nodes[0].text != domain.name:
        document.report(nodes[0], f":domain {domain.name} is expected, not {nodes[0].text}")


def _objects(document: Document, types: Types, sections: Sequence[Group], domain: Domain) -> tuple[Typed, ...]:
    """Those of the problem that are not constants of the domain."""
    constants = {each.name: each for each in domain.constants}
    found = []
    nodes = [node for section in sections for node in section.items[1:]]
    for node, each in objects(document, types, nodes, "object"):
        if each.name not in constants:
            found.append(each)
        elif constants[each.name].types != each.types:
            kind = " or ".join(constants[each.name].types)
            document.report(node, f"'{each.name}' is a constant of the domain, of type {kind}")
    return tuple(found)


def _init(nodes: Sequence[Node], scope: Scope) -> tuple[tuple[Atom, ...], dict[Value, Number]]:
    """The facts and the numbers of the initial state. Negated facts are checked and left out."""
    facts: dict[Atom, None] = {}
    values: dict[Value, Number] = {}
    predicates, report = scope.vocabulary.predicates, scope.report
    for node in nodes:
        key = head(node)
        if key in predicates and isinstance(node, Group) and not _is_timed(node):
            fact = _fact(node, predicates[key], scope)
            if fact is not None:
                facts[fact] = None
        elif not isinstance(node, Group) or not key:
            report(node, f"a fact like (name object ...) is wanted, not {described(node)}")
        elif key == "=":
            _number(node, values, scope)
        elif key == "not":
            if len(node.items) != 2 or not isinstance(node.items[1], Group) or not head(node.items[1]):
                report(node, "'not' has one fact")
            else:
                atom(node.items[1], scope, "a fact")
        elif key == "and":
            more, numbers = _init(node.items[1:], scope)
            facts.update(dict.fromkeys(more))
            values.update(numbers)
        elif _is_timed(node):
            report(node, "a timed fact is not supported (:timed-initial-literals)")
        elif key in REFUSED_IN_INIT:
            reason = REFUSED_IN_INIT[key]
            report(node, f"'{key}' is not supported in :init{reason and f' ({reason})'}")
        elif key in scope.vocabulary.functions:
            report(node, f"'{key}' is a function; its value is given like (= ({key} ...) 5)")
        else:
            scope.document.report_unknown(node, "predicate", key, predicates)
    return tuple(facts), values


def _is_timed(node: Group) -> bool:
    """Whether it is like `(at 5 (fact))`."""
    return head(node) == "at" and len(node.items) == 3 and isinstance(node.items[2], Group)


def _fact(node: Group, symbol: Symbol, scope: Scope) -> Atom | None:
    """The fact of a group; None where it has a mistake, which is reported."""
    args = node.items[1:]
    parameters = symbol.parameters
    known, fits = scope.vocabulary.objects, scope.vocabulary.types.fits
    is_right = True
    if len(args) != len(parameters):
        scope.report(node, misused(symbol, len(args)))
        return None
    if symbol.name in scope.vocabulary.derived:
        scope.report(node, f"'{symbol.name}' is derived: it cannot be given in :init")
        return None
    words = []
    for index, each in enumerate(args):
        text = each.text if isinstance(each, Word) else ""
        types = known.get(text)
        if types is None:
            is_right = False
            if isinstance(each, Word):
                scope.document.report_unknown(each, "object", text, known)
            else:
                scope.report(each, f"an object is wanted, not {described(each)}")
        elif not fits(types, parameters[index].types):
            is_right = False
            scope.report(each, mistyped(text, types, symbol, index))
        words.append(text)
    return Atom(symbol.name, tuple(words)) if is_right else None


def _number(node: Group, values: dict[Value, Number], scope: Scope) -> None:
    """Notes what a group like `(= (name object ...) 5)` gives."""
    if len(node.items) != 3:
        scope.report(node, "a number is given like (= (name object ...) 5)")
        return
    target, number = value(node.items[1], scope), whole_number(node.items[2], scope)
    if target is None or number is None:
        return
    if values.get(target, number) != number:
        scope.report(node, f"'{target.name}' has two values here")
    values[target] = number


def _goal(sections: Sequence[Group], scope: Scope) -> Formula:
    """That of the section; where only a metric is given, nothing is one."""
    if not sections:
        return FALSE
    section = sections[0]
    if len(section.items) != 2:
        scope.report(section, f"':goal' has one formula, not {len(section.items) - 1}: write (:goal (and ...))")
        return FALSE
    return precondition(section.items[1], scope)


def _metric(sections: Sequence[Group], scope: Scope) -> Metric | None:
    if not sections:
        return None
    section = sections[0]
    direction = section.items[1] if len(section.items) == 3 else None
    if not isinstance(direction, Word) or direction.text not in ("minimize", "maximize"):
        near = suggestion(direction.text, ("minimize", "maximize")) if isinstance(direction, Word) else ""
        scope.report(section, f"(:metric minimize expression) or (:metric maximize expression) is wanted{near}")
        return None
    functions = {TOTAL_TIME.name: TOTAL_TIME, **scope.vocabulary.functions}
    within = replace(scope, vocabulary=replace(scope.vocabulary, functions=functions))
    return Metric(direction.text, expression(section.items[2], within))


def _goal_reward(sections: Sequence[Group], scope: Scope) -> Number:
    if not sections:
        return 0
    section = sections[0]
    if len(section.items) != 2:
        scope.report(section, "':goal-reward' has one number")
        return 0
    return whole_number(section.items[1], scope) or 0
