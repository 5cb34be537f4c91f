"""The declarations of PDDL: lists of names with types, predicates, functions and the hierarchy of types."""

from __future__ import annotations

import re
from collections.abc import Sequence

from nppg.pddl.model import OBJECT, Symbol, Typed
from nppg.pddl.tokens import Document, Group, Node, Word, described, head
from nppg.pddl.vocabulary import Types, above

RESERVED = ("and", "or", "not", "imply", "forall", "exists", "when", "probabilistic", "either", "=")
NO_TYPE = "?"  # stands for a type that is missing or no name, which has been told; it fits with all
_NAME = re.compile(r"(?!-(?!\d))[\w@.#$%&!~^+*/<>=\[\]{}|-]+")


def is_name(text: str) -> bool:
    """Whether the text may name something."""
    return bool(_NAME.fullmatch(text))


def name(document: Document, node: Node, what: str) -> str | None:
    """The name that a node is; None where it is none, which is reported."""
    if isinstance(node, Word) and is_name(node.text) and node.text not in RESERVED:
        return node.text
    if isinstance(node, Word) and node.text.startswith("-") and len(node.text) > 1:
        document.report(node, f"{node.text!r}: a space is wanted behind the '-'")
    else:
        document.report(node, f"a name of {what} is wanted, not {described(node)}")
    return None


def pairs(document: Document, nodes: Sequence[Node], what: str) -> list[tuple[Node, tuple[Word, ...]]]:
    """The nodes of a list like `a b - t c`, each with the words of its types."""
    found: list[tuple[Node, tuple[Word, ...]]] = []
    waiting: list[Node] = []
    index = 0
    while index < len(nodes):
        node = nodes[index]
        index += 1
        if not isinstance(node, Word) or node.text != "-":
            waiting.append(node)
            continue
        if not waiting:
            document.report(node, f"a type of nothing: {what} is wanted before the '-'")
        if index == len(nodes):
            document.report(node, "a type is wanted behind the '-'")
            found += [(each, (Word(node.at, NO_TYPE),)) for each in waiting]
            waiting = []
        else:
            types = _type_words(document, nodes[index])
            found += [(each, types) for each in waiting]
            waiting = []
            index += 1
    return found + [(each, ()) for each in waiting]


def _type_words(document: Document, node: Node) -> tuple[Word, ...]:
    """The words of a type or of `(either t1 t2)`."""
    if isinstance(node, Group) and head(node) == "either" and len(node.items) > 1:
        words = node.items[1:]
    else:
        words = [node]
    return tuple(Word(each.at, name(document, each, "a type") or NO_TYPE) for each in words)


def typed(document: Document, types: Types, nodes: Sequence[Node], what: str) -> list[tuple[Node, Typed]]:
    """The names of a list with their types, which are checked; `what` is a variable, an object or a constant."""
    found: list[tuple[Node, Typed]] = []
    wanted = f"an {what}" if what == "object" else f"a {what}"
    for node, words in pairs(document, nodes, wanted):
        for word in words:
            if word.text not in types.names and word.text != NO_TYPE:
                hint = document.hint(word.text, types.names)
                document.report(word, f"the type '{word.text}' is not declared{hint}")
        text = _variable(document, node) if what == "variable" else name(document, node, wanted)
        if text is not None:
            unique = tuple(dict.fromkeys(word.text for word in words))
            found.append((node, Typed(text, (OBJECT,) if OBJECT in unique else unique or (OBJECT,))))
    return found


def variables(document: Document, types: Types, node: Node | None) -> tuple[Typed, ...]:
    """Those of a parameter list."""
    if not isinstance(node, Group):
        if node is not None:
            document.report(node, f"a list of variables is wanted, not {described(node)}")
        return ()
    found: dict[str, Typed] = {}
    for place, each in typed(document, types, node.items, "variable"):
        if each.name in found:
            document.report(place, f"the variable {each.name} is declared twice")
        found[each.name] = each
    return tuple(found.values())


def _variable(document: Document, node: Node) -> str | None:
    if isinstance(node, Word) and node.text[0] == "?" and is_name(node.text[1:]):
        return node.text
    hint = f" (did you mean '?{node.text}'?)" if isinstance(node, Word) and is_name(node.text) else ""
    document.report(node, f"a variable is wanted, not {described(node)}{hint}")
    return None


def hierarchy(document: Document, nodes: Sequence[Node]) -> Types:
    """The types of a domain. One that is only named as a parent is declared by that."""
    parents: dict[str, tuple[str, ...]] = {}
    places: dict[str, Node] = {}
    mentioned: list[str] = []
    for node, words in pairs(document, nodes, "a type"):
        text = name(document, node, "a type")
        over = tuple(dict.fromkeys(word.text for word in words)) or (OBJECT,)
        if text is None or (text == OBJECT and over == (OBJECT,)):
            continue
        if text == OBJECT:
            document.report(node, "the type 'object' has no type above it")
        elif text in parents:
            line = document.place(places[text].at)[0]
            document.report(node, f"the type '{text}' is declared twice (first on line {line})")
        else:
            parents[text], places[text] = over, node
            mentioned += over
    for text in mentioned:
        if text != OBJECT:
            parents.setdefault(text, (OBJECT,))
    return Types(_acyclic(document, parents, places))


def _acyclic(
    document: Document, parents: dict[str, tuple[str, ...]], places: dict[str, Node]
) -> dict[str, tuple[str, ...]]:
    """The parents without cycles, which are reported."""
    found = dict(parents)
    for text in parents:
        over = above(found, text)
        if text in over:
            on_it = [each for each in found if each in over and text in above(found, each)]
            document.report(places[text], f"types are below themselves: {', '.join(on_it)}")
            found[text] = (OBJECT,)
    return found


def symbols(document: Document, types: Types, nodes: Sequence[Node], what: str) -> dict[str, Symbol]:
    """The predicates or functions of a section. Names of their parameters may come twice, as they mean nothing."""
    found: dict[str, Symbol] = {}
    places: dict[str, Node] = {}
    for node, words in pairs(document, nodes, f"a {what}"):
        if not isinstance(node, Group) or not node.items:
            document.report(node, f"a {what} is declared like (name ?x - type), not {described(node)}")
            continue
        for word in words:
            if what == "predicate":
                document.report(word, "a predicate has no type")
            elif word.text not in ("number", NO_TYPE):
                document.report(word, f":object-fluents are not supported: a function of type '{word.text}'")
        if head(node) == "=" and what == "predicate":
            continue
        text = name(document, node.items[0], f"a {what}")
        parameters = typed(document, types, node.items[1:], "variable")
        if text in found:
            line = document.place(places[text].at)[0]
            document.report(node, f"the {what} '{text}' is declared twice (first on line {line})")
        elif text is not None:
            found[text], places[text] = Symbol(text, tuple(each for _, each in parameters)), node
    return found


def objects(document: Document, types: Types, nodes: Sequence[Node], what: str) -> list[tuple[Node, Typed]]:
    """The constants of a domain or the objects of a problem, each once."""
    found: dict[str, tuple[Node, Typed]] = {}
    for node, each in typed(document, types, nodes, what):
        if each.name in found:
            line = document.place(found[each.name][0].at)[0]
            document.report(node, f"the {what} '{each.name}' is declared twice (first on line {line})")
        else:
            found[each.name] = node, each
    return list(found.values())
