"""What a policy makes of a state, to be read: each action with its probability, the rules that made it, and why not
another one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from nppg.bias.language_bias import LanguageBias
from nppg.bridge.terms import Ground, texts
from nppg.logic.query import Query, Var
from nppg.policy.model import Writable
from nppg.policy.reasons import Change, Reasons, Rule, Said
from nppg.policy.sentences import instance

_SAID = 6  # rules of an action that are printed


@dataclass(frozen=True, slots=True)
class Considered:
    """Actions about which the policy knows the same, and so thinks the same: the probability of each, their potential,
    and what made it, the weightiest first; nothing where the policy is no sum of trees."""

    actions: tuple[str, ...]
    probability: float
    potential: float
    said: tuple[Said, ...]


@dataclass(frozen=True, slots=True)
class Otherwise:
    """A test that would have to come out differently for another action to be the best: the action, the test about
    which action, in words, and whether it holds now."""

    choice: str
    about: str
    test: str
    holds: bool

    def __str__(self) -> str:
        return f"{self.choice}, if {self.test}{' no longer held' if self.holds else ' held'}"


@dataclass(frozen=True, slots=True)
class Explanation:
    """The legal actions of a state, the best ones first. `words`: whether rules are told in words, or as Prolog."""

    state: tuple[str, ...]
    actions: tuple[Considered, ...]
    otherwise: tuple[Otherwise, ...]
    words: bool

    def __str__(self) -> str:
        return "\n".join(self._lines())

    def _lines(self) -> Iterator[str]:
        for each in self.actions:
            yield f"{each.probability:.4f}  {_listed(each.actions)}"
            for said in each.said[:_SAID]:
                yield f"    {said.value:+9.4g}  {_by(said)}{self.told(said.rule)}"
            if rest := each.said[_SAID:]:
                total = sum(said.value for said in rest)
                yield f"    {total:+9.4g}  {len(rest)} more rules"
        if self.otherwise:
            yield "it would rather choose"
            yield from (f"    {each}" for each in self.otherwise)

    def told(self, rule: Rule) -> str:
        """A rule in the language of this explanation."""
        return rule.words if self.words else str(rule)

    def _repr_html_(self) -> str:
        """For notebooks."""
        rows = []
        for each in self.actions:
            reasons = "".join(
                f"<li><b>{said.value:+.4g}</b> {escape(_by(said) + self.told(said.rule))}</li>"
                for said in each.said[:_SAID]
            )
            bar = f"linear-gradient(90deg, #0f8a7444 {100 * each.probability:.1f}%, transparent 0)"
            rows.append(
                f'<tr><td style="background:{bar};font-variant-numeric:tabular-nums">{each.probability:.4f}</td>'
                f'<td style="text-align:left"><code>{escape(_listed(each.actions))}</code></td>'
                f'<td style="text-align:left"><ul style="margin:0">{reasons}</ul></td></tr>'
            )
        other = "".join(f"<li>{escape(str(each))}</li>" for each in self.otherwise)
        head = "<tr><th>probability</th><th>action</th><th>because</th></tr>"
        after = f"<p>It would rather choose</p><ul>{other}</ul>" if other else ""
        return f"<table>{head}{''.join(rows)}</table>{after}"


def explanation(
    policy: Writable,
    reasons: Reasons | None,
    bias: LanguageBias,
    state: Sequence[Ground],
    actions: Sequence[Ground],
    scores: tuple[np.ndarray, np.ndarray, np.ndarray],
    changes: Sequence[Change],
) -> Explanation:
    """Put together: `scores` are the answers about the actions, their potentials and probabilities."""
    answers, potentials, probabilities = scores
    written = texts(actions)
    alike: dict[tuple, list[int]] = {}
    for i in np.argsort(-potentials, kind="stable").tolist():
        key = (answers[i].tobytes(),) if reasons else (i,)
        alike.setdefault(key, []).append(i)
    considered = [
        Considered(
            tuple(written[i] for i in group),
            float(probabilities[group[0]]),
            float(potentials[group[0]]),
            tuple(reasons.said(answers[group[0]]) if reasons else ()),
        )
        for group in alike.values()
    ]
    told = InWords(policy, bias, state)
    otherwise = [
        Otherwise(written[each.best], written[each.action], told(each.test, actions[each.action]), each.holds)
        for each in changes
    ]
    return Explanation(tuple(texts(state)), tuple(considered), tuple(dict.fromkeys(otherwise)), bool(bias.sentences))


class InWords:
    """Tests about the actions of one state in words, with the names of their objects."""

    def __init__(self, policy: Writable, bias: LanguageBias, state: Sequence[Ground]):
        self._own, self._bias = policy.bias, bias
        self._names: dict[Var, object] = {}
        if goal := policy.bias.goal:
            bound = policy.domain.binding(state, goal.name, len(goal.types))
            first = policy.bias.offsets[-1]
            self._names = {Var(first + i): each for i, each in enumerate(_written(bound))}

    def __call__(self, test: Query, action: Ground) -> str:
        """The test about this action."""
        name, *args = action if isinstance(action, tuple) else (action,)
        kinds = [(each.name, len(each.types)) for each in self._own.actions]
        first = self._own.offsets[kinds.index((str(name), len(args)))]
        names = self._names | {Var(first + i): each for i, each in enumerate(_written(args))}
        return instance(test, names, self._own, self._bias)


def _written(args: Sequence[Ground]) -> list[str]:
    return texts(list(args))


def _by(said: Said) -> str:
    return f"from {said.trees} trees: " if said.trees > 1 else ""


def _listed(actions: Sequence[str]) -> str:
    shown = ", ".join(actions[:4])
    return f"{shown} and {len(actions) - 4} more" if len(actions) > 4 else shown
