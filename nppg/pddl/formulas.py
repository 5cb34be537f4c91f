"""The formulas and expressions of PDDL, and the scope in which their names mean something."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from nppg.pddl.declarations import variables
from nppg.pddl.model import (
    And,
    Arithmetic,
    Atom,
    Compare,
    Equal,
    Exists,
    Expression,
    Forall,
    Formula,
    Not,
    Number,
    Or,
    Symbol,
    Typed,
    Value,
)
from nppg.pddl.numbers import number
from nppg.pddl.tokens import Document, Group, Node, Word, described, head
from nppg.pddl.vocabulary import Vocabulary

TRUE = And(())
COMPARISONS = ("<", "<=", "=", ">=", ">")
OPERATORS = ("+", "-", "*", "/")
CONNECTIVES = ("and", "or", "not", "imply", "forall", "exists")
CHANGES = ("assign", "increase", "decrease", "scale-up", "scale-down")
WORDS = (*CONNECTIVES, *COMPARISONS, *CHANGES, "when", "probabilistic")
UNSUPPORTED = {
    "preference": ":preferences",
    "always": ":constraints",
    "sometime": ":constraints",
    "within": ":constraints",
    "at-most-once": ":constraints",
    "sometime-after": ":constraints",
    "sometime-before": ":constraints",
    "always-within": ":constraints",
    "hold-during": ":constraints",
    "hold-after": ":constraints",
    "oneof": ":non-deterministic",
    "unknown": ":non-deterministic",
    "is-violated": ":preferences",
}


@dataclass(frozen=True, slots=True)
class Scope:
    """The vocabulary and the variables that a formula may use."""

    document: Document
    vocabulary: Vocabulary
    variables: dict[str, tuple[str, ...]] = field(default_factory=dict)

    def within(self, declared: Sequence[Typed]) -> Scope:
        """The scope with more variables."""
        return replace(self, variables={**self.variables, **{each.name: each.types for each in declared}})

    def report(self, node: Node, message: str) -> None:
        """Notes a problem at a node."""
        self.document.report(node, message)


def precondition(node: Node | None, scope: Scope) -> Formula:
    """The formula of a node; nothing and `()` are true."""
    if node is None or (isinstance(node, Group) and not node.items):
        return TRUE
    return formula(node, scope)


def formula(node: Node, scope: Scope) -> Formula:
    """The formula of a node; a true one stands for what is wrong, which is reported."""
    key = head(node)
    if not isinstance(node, Group) or not key:
        hint = f" (did you mean '({node.text})'?)" if isinstance(node, Word) else ""
        scope.report(node, f"a formula is wanted, not {described(node)}{hint}")
        return TRUE
    parts = node.items[1:]
    if key in ("and", "or"):
        found = tuple(formula(each, scope) for each in parts)
        return And(found) if key == "and" else Or(found)
    if key == "not":
        return Not(formula(parts[0], scope)) if counted(node, 1, scope) else TRUE
    if key == "imply":
        if not counted(node, 2, scope):
            return TRUE
        return Or((Not(formula(parts[0], scope)), formula(parts[1], scope)))
    if key in ("forall", "exists"):
        if not counted(node, 2, scope):
            return TRUE
        declared = variables(scope.document, scope.vocabulary.types, parts[0])
        part = formula(parts[1], scope.within(declared))
        return Forall(declared, part) if key == "forall" else Exists(declared, part)
    if key in COMPARISONS and key not in scope.vocabulary.predicates:
        return _comparison(node, key, scope) if counted(node, 2, scope) else TRUE
    return atom(node, scope, "a condition") or TRUE


def _comparison(node: Group, key: str, scope: Scope) -> Formula:
    left, right = node.items[1:]
    if key == "=" and not _is_numeric(left, scope) and not _is_numeric(right, scope):
        terms = [term(each, scope) for each in (left, right)]
        return Equal(terms[0], terms[1])
    return Compare(key, expression(left, scope), expression(right, scope))


def _is_numeric(node: Node, scope: Scope) -> bool:
    """Whether a side of `=` is a number, not an object."""
    if isinstance(node, Group):
        return True
    text = node.text
    return text not in scope.vocabulary.objects and (text in scope.vocabulary.functions or number(text) is not None)


def counted(node: Group, count: int, scope: Scope) -> bool:
    """Whether a group has as many parts behind its head; if not, that is reported."""
    if len(node.items) == count + 1:
        return True
    parts = "1 part" if count == 1 else f"{count} parts"
    scope.report(node, f"'{head(node)}' has {parts}, not {len(node.items) - 1}")
    return False


def atom(node: Group, scope: Scope, where: str) -> Atom | None:
    """The atom of a group, or None where it has a mistake, which is reported; `where` it stands is told."""
    key = head(node)
    predicates = scope.vocabulary.predicates
    symbol = predicates.get(key)
    if symbol is None:
        if key in UNSUPPORTED:
            scope.report(node, f"'{key}' is not supported ({UNSUPPORTED[key]})")
        elif key in WORDS:
            scope.report(node, f"'{key}' has no place in {where}")
        elif key in scope.vocabulary.functions:
            scope.report(node, f"'{key}' is a function, not a predicate")
        else:
            hint = scope.document.hint(key, [*predicates, *CONNECTIVES])
            scope.report(node, f"unknown predicate '{key}'{hint}")
        return None
    args = applied(node, symbol, scope)
    return None if args is None else Atom(key, args)


def applied(node: Group, symbol: Symbol, scope: Scope) -> tuple[str, ...] | None:
    """The terms that a predicate or function is applied to, checked; None where their number is wrong."""
    count = len(node.items) - 1
    if count != len(symbol.parameters):
        scope.report(node, misused(symbol, count))
        return None
    args = tuple(term(each, scope) for each in node.items[1:])
    types = scope.vocabulary.types
    for index, argument in enumerate(args):
        wanted = symbol.parameters[index].types
        if argument in scope.variables:
            given = scope.variables[argument]
            fitting = types.overlap(given, wanted)
        elif argument in scope.vocabulary.objects:
            given = scope.vocabulary.objects[argument]
            fitting = types.fits(given, wanted)
        else:
            continue
        if not fitting:
            scope.report(node.items[index + 1], mistyped(argument, given, symbol, index))
    return args


def misused(symbol: Symbol, count: int) -> str:
    """What is said of a wrong number of arguments."""
    return f"{symbol.name}/{len(symbol.parameters)} is used with {count} argument{'' if count == 1 else 's'}"


def mistyped(argument: str, given: Sequence[str], symbol: Symbol, index: int) -> str:
    """What is said of an argument that is not of the types of the parameter with this index."""
    wanted = " or ".join(symbol.parameters[index].types)
    return f"{argument} is of type {' or '.join(given)}; argument {index + 1} of {symbol.name} is of type {wanted}"


def term(node: Node, scope: Scope) -> str:
    """The variable or object of a node, which is checked."""
    if isinstance(node, Group):
        scope.report(node, f"a variable or an object is wanted, not {described(node)} (:object-fluents)")
        return ""
    text = node.text
    if text[0] == "?":
        if text not in scope.variables:
            hint = scope.document.hint(text, scope.variables)
            scope.report(node, f"the variable {text} is not declared{hint}")
    elif text not in scope.vocabulary.objects:
        hint = scope.document.hint(text, [*scope.variables, *scope.vocabulary.objects])
        scope.report(node, f"unknown {scope.vocabulary.object_kind} '{text}'{hint}")
    return text


def expression(node: Node, scope: Scope) -> Expression:
    """The numeric expression of a node; 0 stands for what is wrong, which is reported."""
    if isinstance(node, Word):
        found = number(node.text)
        if found is not None:
            return found
        return value(node, scope) or 0
    if head(node) not in OPERATORS or head(node) in scope.vocabulary.functions:
        return value(node, scope) or 0
    key, operands = head(node), node.items[1:]
    least, most = (1, 2) if key == "-" else (2, 2) if key == "/" else (2, len(operands))
    if not least <= len(operands) <= most:
        wanted = "one or two operands" if key == "-" else "two operands"
        scope.report(node, f"'{key}' has {wanted}, not {len(operands)}")
        return 0
    return Arithmetic(key, tuple(expression(each, scope) for each in operands))


def value(node: Node, scope: Scope) -> Value | None:
    """The value of a function; None where a mistake has been reported."""
    key = node.text if isinstance(node, Word) else head(node)
    functions = scope.vocabulary.functions
    if key in functions:
        args = applied(node if isinstance(node, Group) else Group(node.at, [node]), functions[key], scope)
        return None if args is None else Value(key, args)
    if key in ("#t", "?duration"):
        scope.report(
            node, f"'{key}' is not supported (:{'durative-actions' if key[0] == '?' else 'continuous-effects'})"
        )
    elif key in UNSUPPORTED:
        scope.report(node, f"'{key}' is not supported ({UNSUPPORTED[key]})")
    elif key in scope.vocabulary.predicates:
        scope.report(node, f"'{key}' is a predicate, not a function")
    elif isinstance(node, Word) or not key:
        scope.report(
            node, f"a number or a function is wanted, not {described(node)}{scope.document.hint(key, functions)}"
        )
    else:
        scope.report(node, f"unknown function '{key}'{scope.document.hint(key, functions)}")
    return None


def whole_number(node: Node, scope: Scope) -> Number | None:
    """The number that a node is; None where it is none, which is reported."""
    found = number(node.text) if isinstance(node, Word) else None
    if found is None:
        scope.report(node, f"a finite number is wanted, not {described(node)}")
    return found
