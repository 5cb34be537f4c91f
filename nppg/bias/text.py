"""Literals as people read them, their variables named by letters."""

from __future__ import annotations

from nppg.bias.language_bias import LanguageBias
from nppg.bias.names import atom, written
from nppg.bias.refinement import KIND, is_open
from nppg.logic.query import OPEN, Literal, Var


def literal_text(literal: Literal, bias: LanguageBias) -> str:
    """A literal with its variables named by letters, root variables first: A, B, ...; # is a threshold yet open."""
    args = [_letter(arg.index) if isinstance(arg, Var) else written(arg) for arg in literal.args]
    if literal.name == KIND:
        return f"action is {bias.actions[int(args[0])].name}"
    if literal.name == "=" or literal.name in OPEN:
        return f"{args[0]} {literal.name} {'#' if is_open(literal) else args[1]}"
    return atom(written(literal.name), args)


def _letter(index: int) -> str:
    return chr(ord("A") + index % 26) + (str(index // 26) if index >= 26 else "")
