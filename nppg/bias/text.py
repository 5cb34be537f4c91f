"""Literals as people read them, their variables named by letters."""

from __future__ import annotations

from collections.abc import Sequence

from nppg.bias.language_bias import LanguageBias
from nppg.bias.names import atom, written
from nppg.bias.refinement import KIND, is_open
from nppg.logic.query import OPEN, Literal, Var


def literal_text(literal: Literal, bias: LanguageBias | None = None) -> str:
    """A literal with its variables named by letters, root variables first: A, B, ...; # is a threshold yet open. The
    bias knows the names of kinds of actions."""
    args = [letter(arg.index) if isinstance(arg, Var) else written(arg) for arg in literal.args]
    return literal_of(literal.name, [args[0], "#"] if is_open(literal) else args, bias)


def literal_of(name: str, args: Sequence[object], bias: LanguageBias | None = None) -> str:
    """The same of a literal with these arguments, as they are written."""
    if name == KIND:
        return f"action is {bias.actions[int(str(args[0]))].name if bias else f'of kind {args[0]}'}"
    if name == "=" or name in OPEN:
        return f"{args[0]} {name} {args[1]}"
    return atom(written(name), args)


def heading(bias: LanguageBias) -> str:
    """What the variables of tests are the arguments of: move(A, B), goal_on(C, D)."""
    templates = [*bias.actions, *([bias.goal] if bias.goal else [])]
    literals = [
        Literal(template.name, tuple(Var(offset + i) for i in range(len(template.types))))
        for template, offset in zip(templates, bias.offsets, strict=False)
    ]
    return ", ".join(literal_text(literal, bias) for literal in literals)


def letter(index: int) -> str:
    """The name of the variable of this number."""
    return chr(ord("A") + index % 26) + (str(index // 26) if index >= 26 else "")
