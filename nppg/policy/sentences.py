"""Rules in plain English, put together from the sentences that a language bias gives for its predicates.

A literal without one stays as it is printed. A rule is about the actions that no rule before it is about, which is
what "otherwise" says. Where the policy is one tree, its values are levels, which the sentences name from the best to
the worst; in a sum of trees they are changes.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from nppg.bias.language_bias import LanguageBias
from nppg.bias.names import written
from nppg.bias.sentences import PLACEHOLDER
from nppg.bias.text import letter, literal_of
from nppg.bridge.prolog import ask
from nppg.logic.query import Query, Term, Var, solve_equalities
from nppg.policy.model import Writable

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


def explained(policy: Writable, tree: int, bias: LanguageBias) -> list[str]:
    """The clauses of a tree (from 1), each below its sentence as a comment."""
    pairs = zip(sentences(policy, tree, bias), ask("rules", policy.name, tree), strict=True)
    return [line for sentence, rule in pairs for line in (f"% {sentence}", rule)]


def sentences(policy: Writable, tree: int, bias: LanguageBias) -> list[str]:
    """One for each rule of a tree (from 1), in the words of `bias` and with the names of the printed rule."""
    rules = ask("parts", policy.name, tree)
    values = [value for *_, value in rules]
    weights = _levels(values) if len(policy.trees) == 1 else list(map(_change, values))
    said = phrases(policy, rules, bias)
    leads = [f"Otherwise {weight}" if i else weight.capitalize() for i, weight in enumerate(weights)]
    return [f"{lead}: {phrase}." for lead, phrase in zip(leads, said, strict=True)]


def phrases(policy: Writable, rules: Sequence[list], bias: LanguageBias) -> list[str]:
    """What each of a tree's rules, as Prolog gives their parts, is about: "move X onto Y, if X is clear"."""
    found = []
    for i, (action, literals, _) in enumerate(rules):
        clauses = _clauses(action, literals, policy.bias, bias, "any other action" if i else "any action")
        found.append(", if ".join(clauses))
    return found


def instance(test: Query, names: Mapping[Var, object], own: LanguageBias, bias: LanguageBias) -> str:
    """A test about one action, whose root variables have these names: "b2 is above b1 and b3 is clear"."""
    theta, _ = solve_equalities(test, len(own.roots))

    def named(term: Term) -> object:
        if isinstance(term, float):
            return f"{term:.4g}"
        return names.get(term, letter(term.index)) if isinstance(term, Var) else written(term)

    said = []
    for literal in test:
        args = [named(theta.get(arg, arg) if isinstance(arg, Var) else arg) for arg in literal.args]
        sentence = bias.sentences.get(literal.name)
        if sentence is None or len(bias.types.get(literal.name, ())) != len(args):
            said.append(literal_of(literal.name, args, own))
        else:
            said.append(PLACEHOLDER.sub(lambda match, args=args: str(args[int(match[1]) - 1]), sentence))  # type: ignore[misc]
    return " and ".join(said)


def _levels(values: Sequence[float]) -> list[str]:
    """The place of each value among all, the highest first."""
    ordered = sorted(set(values), reverse=True)
    names = [f"{_ORDINALS[i]} choice" if i < len(_ORDINALS) else f"choice {i + 1}" for i in range(len(ordered))]
    names[-1] = "last choice" if len(names) > 1 else "no preference"
    return [names[ordered.index(value)] for value in values]


def _change(value: float) -> str:
    if value == 0:
        return "as attractive as before"
    return f"{'more' if value > 0 else 'less'} attractive by {abs(value):.4g}"


def _clauses(action: list, literals: list[list], own: LanguageBias, bias: LanguageBias, every: str) -> list[str]:
    """What to do and, if there are any, the conditions. A variable that is new in a condition is "some" object, save
    those of the goal, which has one answer."""
    mentioned = {arg for arg in action[1] if isinstance(arg, str)} if action else set()
    if own.goal and literals and literals[0][0] == own.goal.name:
        mentioned.update(arg for arg in literals[0][1] if isinstance(arg, str))
    if not action or (not literals and len(own.actions) == 1 and all(arg == "_" for arg in action[1])):
        clauses = [every]
    else:
        clauses = [_phrase(action, own, bias, "any", mentioned)]
    conditions = [_phrase(literal, own, bias, "some", mentioned) for literal in literals]
    return [*clauses, " and ".join(conditions)] if conditions else clauses


def _phrase(literal: list, own: LanguageBias, bias: LanguageBias, nameless: str, mentioned: set[str]) -> str:
    """A literal by its sentence, else as it is printed. Notes which variables it mentions."""
    name, args, printed = literal
    sentence = bias.sentences.get(name)
    if sentence is None or len(bias.types.get(name, ())) != len(args):
        mentioned.update(arg for arg in args if isinstance(arg, str))
        return str(printed)

    def word(match: re.Match[str]) -> str:
        number = int(match[1]) - 1
        arg = args[number]
        if isinstance(arg, list):
            return str(arg[0])
        if arg == "_":
            return f"{nameless} {own.types[name][number].replace('_', ' ')}"
        new = arg not in mentioned
        mentioned.add(arg)
        return f"some {arg}" if new else str(arg)

    return PLACEHOLDER.sub(word, sentence)
