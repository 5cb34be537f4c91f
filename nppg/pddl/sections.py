"""The definitions of PDDL files and their sections, found by their keywords."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from nppg.pddl.declarations import name
from nppg.pddl.tokens import Document, Group, Node, Word, described, head

REQUIREMENTS = (
    ":strips",
    ":typing",
    ":negative-preconditions",
    ":equality",
    ":disjunctive-preconditions",
    ":existential-preconditions",
    ":universal-preconditions",
    ":quantified-preconditions",
    ":conditional-effects",
    ":derived-predicates",
    ":domain-axioms",
    ":action-costs",
    ":numeric-fluents",
    ":fluents",
    ":probabilistic-effects",
    ":rewards",
    ":mdp",
    ":adl",
)
UNSUPPORTED = (
    ":durative-actions",
    ":duration-inequalities",
    ":continuous-effects",
    ":timed-initial-literals",
    ":timed-initial-effects",
    ":timed-initial-fluents",
    ":timed-effects",
    ":time",
    ":preferences",
    ":constraints",
    ":trajectory-constraints",
    ":object-fluents",
    ":goal-utilities",
    ":non-deterministic",
    ":partial-observability",
    ":open-world",
    ":true-negation",
    ":action-expansions",
    ":foreach-expansions",
    ":dag-expansions",
    ":subgoal-through-axioms",
    ":safety-constraints",
    ":expression-evaluation",
    ":ucpop",
    ":hierarchy",
    ":method-preconditions",
    ":multi-agent",
    ":unfactored-privacy",
    ":factored-privacy",
)


def definition(document: Document, kind: str) -> tuple[str, Group, list[Group]]:
    """The name of the file's domain or problem, all of it, and its sections. Raises NppgError where it has none."""
    groups = document.groups()
    if not groups:
        raise document.fail(0, "the file is empty")
    found: dict[str, Group] = {}
    for group in groups:
        first = group.items[1] if head(group) == "define" and len(group.items) > 1 else None
        if first is None or head(first) not in ("domain", "problem"):
            raise document.fail(
                group.at, "not PDDL: (define (domain name) ...) or (define (problem name) ...) is wanted"
            )
        if head(first) in found:
            document.report(group, f"a second {head(first)}; a file has one")
        found.setdefault(head(first), group)
    if kind not in found:
        other = next(iter(found))
        raise document.fail(found[other].at, f"a {kind} is expected, not a {other}")
    group = found[kind]
    label = group.items[1]
    assert isinstance(label, Group)
    text = name(document, label.items[1], f"a {kind}") if len(label.items) == 2 else None
    if len(label.items) != 2:
        document.report(label, f"the {kind} has one name, as in ({kind} name)")
    sections = []
    for each in group.items[2:]:
        if isinstance(each, Group) and head(each).startswith(":"):
            sections.append(each)
        else:
            document.report(each, f"a section like (:keyword ...) is wanted, not {described(each)}")
    return text or "", group, sections


def by_keyword(
    document: Document,
    sections: Sequence[Group],
    known: Collection[str],
    refused: Mapping[str, str],
    repeated: Collection[str],
) -> dict[str, list[Group]]:
    """The sections of each keyword. All but the repeated ones come once; those that are not known are reported."""
    found: dict[str, list[Group]] = {each: [] for each in known}
    for section in sections:
        key = head(section)
        if key in refused:
            document.report(section, f"'{key}' is not supported{refused[key] and f' ({refused[key]})'}")
        elif key not in found:
            document.report(section, f"unknown section '{key}'{document.hint(key, known)}")
        elif found[key] and key not in repeated:
            line = document.place(found[key][0].at)[0]
            document.report(section, f"the section '{key}' comes twice (first on line {line})")
        else:
            found[key].append(section)
    return found


def requirements(document: Document, sections: Sequence[Group]) -> tuple[str, ...]:
    """The requirements of a definition, each checked."""
    found = []
    for node in (node for section in sections for node in section.items[1:]):
        text = node.text if isinstance(node, Word) else ""
        text = text if text.startswith(":") else f":{text}"
        if text in UNSUPPORTED:
            document.report(node, f"the requirement '{text}' is not supported")
        elif text not in REQUIREMENTS:
            what = f"'{text}'{document.hint(text, REQUIREMENTS)}" if isinstance(node, Word) else described(node)
            document.report(node, f"unknown requirement {what}")
        else:
            found.append(text)
    return tuple(dict.fromkeys(found))


def keywords(
    document: Document, nodes: Sequence[Node], known: Collection[str], refused: Mapping[str, str], what: str
) -> dict[str, Node]:
    """The parts of an action, `:keyword part`."""
    found: dict[str, Node] = {}
    index = 0
    while index < len(nodes):
        node = nodes[index]
        index += 1
        if not isinstance(node, Word) or not node.text.startswith(":"):
            document.report(node, f"one of {', '.join(known)} is wanted, not {described(node)}")
            continue
        part = nodes[index] if index < len(nodes) else None
        if part is None or (isinstance(part, Word) and part.text.startswith(":")):
            document.report(node, f"'{node.text}' has nothing behind it")
            continue
        index += 1
        if node.text in refused:
            document.report(node, f"'{node.text}' is not supported{refused[node.text] and f' ({refused[node.text]})'}")
        elif node.text not in known:
            document.report(node, f"unknown keyword '{node.text}' of {what}{document.hint(node.text, known)}")
        elif node.text in found:
            document.report(node, f"'{node.text}' comes twice in {what}")
        else:
            found[node.text] = part
    return found
